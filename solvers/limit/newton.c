/* newton: the bracket of lambda, by Newton's method on the power balance -(p . dq) / (q . dq) of motions.
 *                                                                                                          [Dinkelbach 1967] */
#ifndef SP__LIMIT_NEWTON_C
#define SP__LIMIT_NEWTON_C

#include "exact.c"
#include "small_engine.c"

#if SP__WITH_LIMIT

/* A bracket of the multiplier under way. All multiples are in `ref`. */
typedef struct sp__limit {
    sp_limit_result r;
    sp_real ref;                        /* multiplier that counts as 1 */
    sp_real best, slack;                /* least power balance of a motion, and what tol adds to it */
    sp_real least;                      /* largest one of a motion that live loads hinder: less does not stand */
    sp_real *upper, *lower;             /* 6b: motions of best and of least, in the loop */
    sp_real *f;                         /* 3 x points: forces that are tried when all others are kept */
    int none;                           /* the motion of best falls at 0, too */
    int slow;                           /* the last collapse gained less than half of what is open */
    sp__bracket bracket;
    sp__engine engine;                  /* what is asked: does d dead + l live stand? [exact.c, small_engine.c] */
#if SP__WITH_INTERIOR
    sp_real fell;                       /* where the motion of `upper` was proved to fall; SP__HUGE: nowhere yet */
#endif
} sp__limit;

/* The motion of `upper` was proved to fall there; SP__HUGE: nowhere yet. */
#if SP__WITH_INTERIOR
static void sp__limit_fell(sp__limit *L, sp_real at) { L->fell = at; }
#else
static void sp__limit_fell(sp__limit *L, sp_real at) { (void)L; (void)at; }
#endif

/* Forces f, certified last, carry lambda: the lower end. */
static void sp__limit_carried(sp__limit *L, sp_real lambda, const sp_real *f)
{
    L->r.lower = lambda;
    L->r.imbalance = L->bracket.imbalance;
    memmove(L->r.f, f, 3 * (size_t)L->bracket.pb.points * sizeof *f);
}

/* What was asked and left open (SP__HUGE: nothing), and how far from it both sides are asked for. */
typedef struct sp__aside { sp_real open, apart; } sp__aside;

#define SP__LIMIT_WIDE 1000             /* a bracket so many tol wide is closed */
#define SP__LIMIT_FARTHEST (SP__WITH_SMALL ? 1 : (sp_real)0.01)     /* below the balance: where a lower end is still asked
                                                                       for */
#define SP__LIMIT_FIRST (SP__HAS_STRENGTH ? 3 : 1)      /* what joints resist depends on caps, and those on the multiple */
#define SP__LIMIT_ASKS 60               /* where joints have strength: an interval is halved */
#define SP__LIMIT_FAR 1000              /* multiple, in ref, from which on forces are nearly those of live loads alone */
#if defined SP_REAL_MIXED
#define SP__LIMIT_STEP 400              /* tol below a motion's balance where forces are asked for: float sees no nearer */
#define SP__LIMIT_HALVED (2 * SP__LIMIT_STEP)   /* tol between both ends at which halving has an end */
#elif defined SP_REAL_FLOAT
#define SP__LIMIT_STEP (SP__WITH_SMALL ? 4 : 20)        /* nearer a search takes a hundred factorisations */
#define SP__LIMIT_HALVED 8
#else
#define SP__LIMIT_STEP 4
#define SP__LIMIT_HALVED (25 * SP__LIMIT_STEP)
#endif
#define SP__LIMIT_ASIDE (2 * SP__LIMIT_HALVED)  /* tol from a question left open to the first ones beside it */

/* Asks the engine at d dead + a live.       returns what it claims; its motion is in bracket.dq, its forces in f */
static sp_verdict sp__limit_ask(sp__limit *L, sp_real d, sp_real a, sp_real *f)
{
    return sp__engine_ask(&L->engine, &L->bracket, d, a * L->ref, f);
}

/* Power balance of the motion: the multiple of live loads at which its work is 0; SP__HUGE where they do none. */
static sp_real sp__limit_balance(const sp__limit *L)
{
    const sp_real dead = sp__bracket_work(&L->bracket, L->bracket.dead) - L->bracket.resist;
    const sp_real live = L->ref * sp__bracket_work(&L->bracket, L->bracket.live);
    return sp__abs(dead) < SP__HUGE * sp__abs(live) ? -dead / live : SP__HUGE;
}

/* Motion `lower` proves collapse below `least`, motion `upper` above `best`. Where best <= least, their sum in the shares by
 * which live loads do no work proves it at every multiple: joints resist a sum of motions with no
 * more than they resist each with. */
SP__NOINLINE static int sp__limit_never_stands(sp__limit *L)
{
    sp__bracket *b = &L->bracket;
    const size_t n = 6 * (size_t)b->pb.blocks;
    const sp_real p = sp__dot(b->live, L->lower, n), q = sp__dot(b->live, L->upper, n);
    if (!(L->least >= L->best && p < 0 && q > 0)) return 0;
    const sp_real more = 1 + (L->least - L->best) / (2 + 2 * sp__abs(L->best));     /* live loads do work in it, if little */
    for (size_t k = 0; k < n; k++) b->dq[k] = L->lower[k] / -p + more * L->upper[k] / q;
    L->none = sp__bracket_falls(b, 0, 1, NULL);
    if (!L->none) memcpy(b->dq, L->upper, n * sizeof *b->dq);
    return L->none;
}

static int sp__limit_strong(const sp__limit *L) { return SP__HAS_STRENGTH && sp__scene_strong(&L->bracket.scene); }

/* Where to ask after a collapse at `last` that leaves the interval open to `next`: there, or in the middle where it gained less
 * than half. The exact stage ends with any motion that falls, which need not be the one that falls by most. */
static sp_real sp__limit_between(sp__limit *L, sp_real last, sp_real next)
{
    const sp_real low = sp__max(0, sp__max(L->r.lower / L->ref, L->least)), middle = (low + next) / 2;
    L->slow = last - next < next - low;
    return L->slow ? middle : next;
}

/* Are both ends found, and no farther apart than so much? */
static int sp__limit_ends_meet(const sp__limit *L, sp_real apart)
{
    return L->best < SP__HUGE && L->r.lower >= 0 && L->best - L->r.lower / L->ref <= apart * (1 + sp__abs(L->best));
}

/* Are both ends so near that the bracket is closed; where joints have strength as near as halving brings them? */
SP__NOINLINE static int sp__limit_closed(const sp__limit *L)
{
    return sp__limit_ends_meet(L, (sp__limit_strong(L) ? SP__LIMIT_HALVED : SP__LIMIT_WIDE) * L->bracket.set.tol);
}

/* Where joints have strength, *a was left open: the limit is near, and rounding hides it. It is asked for on both sides, below
 * and above in turn, ever farther from there.      returns 0: both ends are nearer already */
static int sp__limit_aside(const sp__limit *L, sp__aside *o, sp_real step, sp_real *a)
{
    if (!(o->open < SP__HUGE)) {
        o->open = *a;
        o->apart = SP__LIMIT_ASIDE * L->bracket.set.tol * (1 + *a);
    } else if (*a > o->open) o->apart *= 2;
    const sp_real low = sp__max(L->r.lower / L->ref, L->least);
    for (int turn = *a < o->open; turn < 4; turn++) {
        const sp_real next = o->open + (turn & 1 ? o->apart : -o->apart);
        if (next > low && next >= 0 && next < L->best - step) { *a = next; return 1; }
        if (turn & 1) o->apart *= 2;
    }
    return 0;
}

/* Where joints have strength, and forces carry *a: where to ask next.      returns 0: the bracket is as narrow as it gets */
static int sp__limit_onwards(sp__limit *L, sp__aside *o, sp_real step, sp_real *a)
{
    if (o->open < SP__HUGE && *a < o->open) return sp__limit_aside(L, o, step, a);
    o->open = SP__HUGE;
    if (!(L->best - *a > 2 * step)) return 0;
    *a = L->slow ? (*a + L->best) / 2 : L->best - step;         /* after another that stands Newton's step again */
    L->slow = 0;
    return 1;
}

/* Something falls at *a. Its power balance is a bound from above; from below where live loads hinder it. *a: where to ask next.
 *     returns 0: nothing gained */
static int sp__limit_bound_by_collapse(sp__limit *L, sp_real *a, sp_real step)
{
    int beyond;
    if (!sp__engine_falls(&L->bracket, *a * L->ref, &beyond)) return 0;
    const sp_real balance = sp__limit_balance(L), last = *a;
    const int idle = SP__HAS_STRENGTH && !(balance < SP__HUGE);  /* live loads do nothing in it */
    L->none = beyond && (last <= 0 || (idle && sp__bracket_falls(&L->bracket, 0, 1, NULL)));
    if (L->none) return 1;
    if (!(balance < SP__HUGE)) return 0;
    if (beyond ? balance < L->best : SP__HAS_STRENGTH && balance > L->least) {
        *(beyond ? &L->best : &L->least) = balance;
        if (beyond) sp__limit_fell(L, last);
        memcpy(beyond ? L->upper : L->lower, L->bracket.dq, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->upper);
    }
    if (SP__HAS_STRENGTH && sp__limit_never_stands(L)) return 1;
    const sp_real next = beyond ? L->best - step : balance + step < L->best ? balance + step : L->best;
    *a = sp__max(0, next);
    if (beyond && last < SP__HUGE && sp__limit_strong(L)) *a = sp__limit_between(L, last, *a);
    return beyond ? *a < last : *a > last;
}

/* Live loads alone. If forces balance them there is no upper end; r.ray keeps those forces. If something falls under them, its
 * power balance is a first upper end. */
SP__NOINLINE static void sp__limit_live_alone(sp__limit *L)
{
    sp__bracket *b = &L->bracket;
    sp_real a = 1;
    const sp_verdict claim = sp__limit_ask(L, 0, 1, L->r.ray);
    if (claim == SP_STABLE) {
        for (size_t k = 0; k < 3 * (size_t)b->pb.points; k++) L->r.ray[k] /= L->ref;
        L->r.kind = SP_LIMIT_UNBOUNDED;
    }
    for (int it = 0; it < SP__LIMIT_FIRST && claim == SP_UNSTABLE && a < SP__HUGE; it++) {
        if (!sp__bracket_resists(b, a * L->ref)) return;
        L->best = a = sp__bracket_work(b, b->live) > 0 ? sp__limit_balance(L) : SP__HUGE;
    }
}

/* Where interior points leave an end open: the exact stage just below the best motion's power balance. Each collapse it finds
 * gives a better one, as Newton's method on the least imbalance over lambda would: few steps.            [Dinkelbach 1967]
 *     returns 1: lower is found (of an UNBOUNDED any), or nothing stands */
SP__NOINLINE static int sp__limit_newton(sp__limit *L)
{
    const int any = L->r.kind == SP_LIMIT_UNBOUNDED, strong = sp__limit_strong(L);
    sp_real *f = any ? L->r.f : L->r.ray;               /* those of the lower end stay until there are better ones */
    if (any) L->best = SP__HUGE;
    const sp_real size = 1 + (L->best < SP__HUGE ? sp__abs(L->best) : 0), farthest = SP__LIMIT_FARTHEST * size;
    sp_real step = SP__LIMIT_STEP * L->bracket.set.tol * size;
    sp__aside o = { SP__HUGE, 0 };
    L->least = -SP__HUGE;
    memcpy(L->upper, L->bracket.dq, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->upper);
    sp_real a = L->best < SP__HUGE ? sp__max(0, L->best - step) : 0;
    int asks = strong ? SP__LIMIT_ASKS : 24;
    while (asks-- > 0 && sp__engine_may_ask(&L->engine, &L->bracket) && step < farthest) {
        if (SP__WITH_INTERIOR && !any && sp__limit_closed(L)) break;
        if (!strong && !any && L->best < SP__HUGE && a * L->ref <= L->r.lower) return 1;        /* it is known to stand there */
        const sp_verdict claim = sp__limit_ask(L, 1, a, f);
        if (claim == SP_STABLE) {
            if (!(a > 0)) L->r.dead = SP_STABLE;
            if (a * L->ref > L->r.lower) sp__limit_carried(L, a * L->ref, f);
            if (strong && !any && L->best < SP__HUGE) {
                if (sp__limit_onwards(L, &o, step, &a)) continue;
                break;
            }
            if (any || L->best < SP__HUGE) return 1;
            if (a > SP__LIMIT_FAR && sp__engine_unbounded(&L->bracket, L->r.ray, L->r.lower, L->ref)) return 1;
            a = a > 0 ? 8 * a : 1;
            continue;
        }
        const sp_real asked = a;
        if (claim == SP_UNSTABLE && sp__limit_bound_by_collapse(L, &a, step)) {
            if (L->none) return 1;
            if (!strong) continue;
            if (!(asked > o.open)) { o.open = SP__HUGE; continue; }
            a = asked;
            if (!sp__limit_aside(L, &o, step, &a)) break;
            continue;
        }
        if (strong && !any && L->best < SP__HUGE && L->r.lower >= 0) {
            if (!sp__limit_aside(L, &o, step, &a) || o.apart > farthest) break;
            continue;
        }
        if (claim == SP_UNSTABLE) {                     /* does it stand at all? */
            if (!(a > 0)) return 0;
            a = 0;
            continue;
        }
        if (L->best < SP__HUGE) {
            step *= 10;
            a = sp__max(0, L->best - step);
        } else a = a > 0 ? 8 * a : 1;
    }
    if (L->best < SP__HUGE) memcpy(L->bracket.dq, L->upper, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->upper);
    return 0;
}

#endif

#endif /* SP__LIMIT_NEWTON_C */
