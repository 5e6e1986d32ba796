/* limit: sp_limit: both ends of the bracket, the verdict they give, and from which multiple on a scene stands. */
#ifndef SP__LIMIT_LIMIT_C
#define SP__LIMIT_LIMIT_C

#include "verify.c"
#include "start.c"
#include "small_start.c"

#if SP__WITH_LIMIT

#define SP__LIMIT_ROUNDS (SP__WITH_SMALL ? 10 : 8)       /* slacks that are tried, each twice the last */
#define SP__LIMIT_ROUNDS_STRONG 14      /* where joints have strength: tol may blur the limit by more */
#define SP__LIMIT_ENDLESS 5             /* multiples, each 16 times the last, that are tried where there seems to be no end */
#define SP__LIMIT_CHECKS 40             /* checks between both ends, where the search leaves them apart */
#define SP__LIMIT_OPEN 4                /* of them so many left open: the rest is within rounding of the limit */
#define SP__LIMIT_SLACK ((sp_real)0.01) /* what tol adds to a motion's balance may widen it by no more, in ref */

/* Is lambda proved for an upper end, by the motion at hand? */
static int sp__limit_upper_at(sp__limit *L, sp_real lambda)
{
    sp_limit_result *r = &L->r;
    if (!sp__bracket_falls(&L->bracket, lambda, 1, r->dq)) return 0;
    const sp_real marginal = sp__limit_strong(L) ? 2 : (sp_real)1.1;    /* caps make up to a fifth of tol of rounding */
    if (L->bracket.least < marginal * L->bracket.set.tol) {     /* again, as the result will hold it */
        sp__motion_read(&L->bracket.pb, r->dq, L->bracket.dq);
        if (!sp__bracket_falls(&L->bracket, lambda, 1, NULL)) return 0;
    }
    r->upper = lambda;
    r->least_imbalance = L->bracket.least;
    r->final = L->bracket.final;
    return 1;
}

#if SP__WITH_INTERIOR
/* Is it where the motion of the least power balance was proved to fall, below next? Asked once. */
static int sp__limit_upper_fell(sp__limit *L, sp_real next)
{
    const sp_real at = L->fell;
    if (L->none || !(at < next)) return 0;
    L->fell = SP__HUGE;
    memcpy(L->bracket.dq, L->upper, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->upper);
    return sp__limit_upper_at(L, at * L->ref);
}

/* A large multiple is carried: do the forces of much larger ones, in which dead loads have next to no share, balance live loads
 * alone? Where joints have strength: a question about live loads alone leaves most blocks without load, and may stay open.
 * Where they have an end the motion at hand stays. */
SP__NOINLINE static void sp__limit_endless(sp__limit *L)
{
    sp_limit_result *r = &L->r;
    const size_t bytes = 6 * (size_t)L->bracket.pb.blocks * sizeof *L->lower;
    sp_real a = r->lower / L->ref;
    if (L->none || r->kind || !(a > SP__LIMIT_FAR) || !sp__limit_strong(L)) return;
    memcpy(L->lower, L->bracket.dq, bytes);             /* nothing else asks for it any more */
    for (int it = 0; it < SP__LIMIT_ENDLESS && !r->kind && sp__engine_may_ask(&L->engine, &L->bracket); it++) {
        a *= 16;
        if (sp__limit_ask(L, 1, a, r->ray) != SP_STABLE) break;
        sp__limit_carried(L, a * L->ref, r->ray);
        if (sp__engine_unbounded(&L->bracket, r->ray, r->lower, L->ref)) r->kind = SP_LIMIT_UNBOUNDED;
    }
    if (!r->kind) memcpy(L->bracket.dq, L->lower, bytes);
}
#else
static int sp__limit_upper_fell(sp__limit *L, sp_real next) { (void)L; (void)next; return 0; }
static void sp__limit_endless(sp__limit *L) { (void)L; }
#endif

/* The engine at lambda, for the motion of the upper end; forces that carry it are a lower end. */
static void sp__limit_upper_ask(sp__limit *L, sp_real lambda, int strong)
{
    const sp_verdict claim = sp__limit_ask(L, 1, lambda / L->ref, L->r.ray);
    if (strong && claim == SP_STABLE && lambda > L->r.lower) sp__limit_carried(L, lambda, L->r.ray);
}

/* The upper end: the least multiple that the motion at hand proves, or that of the engine there: once of the exact
 * stage, whose motion is as good as it gets, again and again of the smallest search and where joints have strength; at most
 * where that motion was proved before. */
SP__NOINLINE static void sp__limit_upper(sp__limit *L)
{
    const int strong = sp__limit_strong(L), again = SP__WITH_SMALL || strong;
    sp_real slack = sp__max(SP__WITH_INTERIOR ? L->slack : 0, L->bracket.set.tol * (1 + sp__abs(L->best))) * (sp_real)1.5;
    for (int it = 0; it < (strong ? SP__LIMIT_ROUNDS_STRONG : SP__LIMIT_ROUNDS); it++, slack *= 2) {
        if (sp__limit_upper_fell(L, L->best + slack)) return;
        const sp_real lambda = L->none ? 0 : sp__max(0, L->best + slack) * L->ref;
        if ((it == 2 || (again && it > 2)) && !L->none) sp__limit_upper_ask(L, lambda, strong);
        if (sp__limit_upper_at(L, lambda)) return;
    }
    sp__limit_upper_fell(L, SP__HUGE);
}

/* What tol forgives forces at the upper end, by the power of its mechanism, in ref. */
static sp_real sp__limit_forgiven(const sp__limit *L)
{
    const sp_limit_result *r = &L->r;
    return r->upper < 0 ? 0 : r->tol * sp__ratio(r->upper / L->ref - sp__limit_balance(L), r->least_imbalance);
}

/* How wide a bracket is closed. */
static sp_real sp__limit_wide(const sp__limit *L)
{
    const sp_real most = sp__max(L->slack, sp__limit_forgiven(L));
    const sp_real slack = !SP__WITH_INTERIOR ? 0 : most < SP__LIMIT_SLACK ? most : SP__LIMIT_SLACK;
    return SP__LIMIT_WIDE * L->r.tol * (sp__abs(L->r.lower) + L->ref) + 4 * slack * L->ref;
}

/* The result that both ends of the bracket give. */
static void sp__limit_conclude(sp__limit *L)
{
    sp_limit_result *r = &L->r;
    const sp_real wide = sp__limit_wide(L);
    const int never = L->none || (r->lower < 0 && !(r->upper > 0));
    if (never) r->kind = r->upper < 0 ? SP_LIMIT_UNDECIDED : SP_LIMIT_NONE;
    else if (r->kind == SP_LIMIT_UNBOUNDED) r->kind = r->lower < 0 ? SP_LIMIT_UNDECIDED : SP_LIMIT_UNBOUNDED;
    else if (r->lower >= 0 && r->upper >= r->lower && r->upper - r->lower <= wide) r->kind = SP_LIMIT_FOUND;
    const int spent = L->bracket.spent || !sp__engine_may_ask(&L->engine, &L->bracket);
    r->reason = r->kind ? SP_REASON_FORCES : spent ? SP_REASON_BUDGET : SP_REASON_LIMIT;
    if (r->kind != SP_LIMIT_FOUND) return;
    const sp_real balance = sp__limit_balance(L) * L->ref;
    if (SP__WITH_INTERIOR && balance >= 0 && balance < r->lower && sp__bracket_stands(&L->bracket, 1, balance, r->f, NULL)) {
        r->lower = balance;                             /* within tol the same forces carry less, too */
        r->imbalance = L->bracket.imbalance;
    }
    r->multiplier = balance < r->lower ? r->lower : balance > r->upper ? r->upper : balance;
    r->within = sp__bracket_within(r, balance);
}

/* Does it stand under the dead loads alone? If not, from which multiple on? Each collapse that live loads hinder gives a larger
 * lower bound of that multiple, by Newton's method on the least imbalance.     a: asked first, 0 or above what falls */
SP__NOINLINE static void sp__limit_lowest(sp__limit *L, sp_real a)
{
    sp__bracket *b = &L->bracket;
    sp_limit_result *r = &L->r;
    r->lowest = r->lower;
    if (r->kind == SP_LIMIT_NONE) r->dead = SP_UNSTABLE;
    else if (!(r->lower > 0) && r->lower >= 0) r->dead = SP_STABLE;
    if (r->dead == SP_STABLE) r->lowest = 0;
    const int strong = sp__limit_strong(L);
    const int first = !(a > 0);
    sp_real fell = 0;
    int slow = 0;                                       /* as L->slow, from below */
    sp__aside o = { SP__HUGE, 0 };
    for (int it = 0; it < (strong ? SP__LIMIT_ASKS : 12) && r->lowest > a * L->ref && sp__engine_may_ask(&L->engine, b); it++) {
        const sp_real last = a;
        const sp_verdict claim = sp__limit_ask(L, 1, a, L->f);
        if (claim == SP_STABLE) {
            r->lowest = a * L->ref;
            if (!it && first) r->dead = SP_STABLE;
            if (SP__WITH_INTERIOR && r->kind == SP_LIMIT_UNBOUNDED) sp__limit_carried(L, r->lowest, L->f);  /* from there on */
            if (!strong || !it || o.open < a || a - fell <= SP__LIMIT_HALVED * b->set.tol * (1 + a)) return;
            a = slow ? (fell + a) / 2 : fell + SP__LIMIT_STEP * b->set.tol * (1 + fell);
            slow = 0;
            continue;
        }
        if (claim == SP_UNSTABLE && sp__bracket_falls(b, a * L->ref, 0, NULL)) {
            r->dead = SP_UNSTABLE;
            fell = sp__limit_balance(L);
            a = fell + SP__LIMIT_STEP * b->set.tol * (1 + a);
            slow = strong && a - last < r->lowest / L->ref - a;
            if (slow) a = (a + r->lowest / L->ref) / 2;
        } else if (!it) return;
        else if (strong) {                              /* as sp__limit_aside does */
            o.apart = o.open < SP__HUGE ? 2 * o.apart : SP__LIMIT_ASIDE * b->set.tol * (1 + a);
            if (!(o.open < SP__HUGE)) o.open = a;
            a = o.open + o.apart;
        }
        if (!(a > last)) a = (last + r->lowest / L->ref) / 2;
    }
}

#if SP__WITH_INTERIOR
/* A whole check at a.      returns STABLE: L->f carries it; UNSTABLE: bracket.dq falls, if *beyond at all larger multiples */
static sp_verdict sp__limit_check(sp__limit *L, sp_real a, int *beyond)
{
    for (int all = 0; all < 2; all++) {
        if (sp__engine_check(&L->engine, &L->bracket, a * L->ref, all, L->f)) return SP_STABLE;
        if (sp__engine_falls(&L->bracket, a * L->ref, beyond)) return SP_UNSTABLE;
    }
    return SP_UNDECIDED;
}

/* The collapse at hand, at a, is one that live loads hinder: less than its balance does not stand. */
static void sp__limit_hindered(sp__limit *L, sp_real a)
{
    L->least = sp__max(a, sp__limit_balance(L));
    memcpy(L->lower, L->bracket.dq, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->lower);
}

/* The dead loads by a whole check. */
static void sp__limit_check_dead(sp__limit *L)
{
    sp_limit_result *r = &L->r;
    int beyond = 0;
    r->dead = sp__limit_check(L, 0, &beyond);
    if (r->dead == SP_STABLE) {
        r->lowest = 0;
        if (r->lower < 0) sp__limit_carried(L, 0, L->f);
    }
    if (r->dead != SP_UNSTABLE) return;
    if (!beyond) sp__limit_hindered(L, 0);
    else L->none = r->lower < 0 && sp__limit_upper_at(L, 0);
}

/* The upper end by the motion at hand, as near to its power balance as that proves it, no farther than lambda: a motion that no
 * contact resists falls by more than rounding there. L->upper keeps r.dq of it, digit by digit.    returns 0: it is none */
static int sp__limit_upper_near(sp__limit *L, sp_real lambda)
{
    const sp_real balance = sp__limit_balance(L);
    sp_real apart = SP__LIMIT_STEP * L->r.tol * (1 + sp__abs(balance));
    while (balance + apart < lambda / L->ref && !sp__limit_upper_at(L, sp__max(0, balance + apart) * L->ref)) apart *= 8;
    if (!(balance + apart < lambda / L->ref) && !sp__limit_upper_at(L, lambda)) return 0;
    sp__motion_read(&L->bracket.pb, L->r.dq, L->upper);
    L->slack = 0;
    return 1;
}

/* Ends that the search left apart, by whole checks at multiples between, each in the middle of what is open. One that is left
 * open itself is near the limit: the wider side of it is next. */
SP__NOINLINE static void sp__limit_halve(sp__limit *L)
{
    sp_limit_result *r = &L->r;
    const size_t bytes = 6 * (size_t)L->bracket.pb.blocks * sizeof *L->upper;
    sp_real open[2] = { 0, 0 };                         /* between these multiples checks are left open */
    int it = 0, opened = 0;
    sp__motion_read(&L->bracket.pb, r->dq, L->upper);
    memcpy(L->bracket.dq, L->upper, bytes);
    if (r->upper > 0 && sp__bracket_resists(&L->bracket, r->upper)) sp__limit_upper_near(L, r->upper);
    for (int beyond = 0; it < SP__LIMIT_CHECKS && opened < SP__LIMIT_OPEN && sp__engine_flops(&L->bracket) > 0; it++) {
        const sp_real low = sp__max(L->least, r->lower / L->ref), high = r->upper < 0 ? 8 * low + 2 : r->upper / L->ref;
        if (!(high - low > (r->lower < 0 ? SP__LIMIT_STEP : SP__LIMIT_WIDE) * r->tol * (1 + low))) break;
        if (r->upper < 0 && low > SP__LIMIT_FAR) break;
        if (!(open[1] > low && open[0] < high)) open[0] = open[1] = 0;
        const int above = !(open[1] > 0) || high - open[1] > open[0] - low;
        const sp_real a = !(open[1] > 0) ? (low + high) / 2 : above ? (open[1] + high) / 2 : (low + open[0]) / 2;
        const sp_verdict claim = sp__limit_check(L, a, &beyond);
        if (claim == SP_STABLE) sp__limit_carried(L, a * L->ref, L->f);
        else if (claim == SP_UNSTABLE && !beyond) sp__limit_hindered(L, a);
        else if (claim == SP_UNDECIDED || !sp__limit_upper_near(L, a * L->ref)) {
            opened++;
            if (above) open[1] = a;
            if (!above || !(open[0] > 0)) open[0] = a;
        }
    }
    L->engine.n.left = it < SP__LIMIT_CHECKS;
    if (r->upper < 0) return;
    for (int32_t i = 0; i < L->bracket.pb.blocks; i++)  /* what did not prove a nearer one goes */
        memcpy(r->dq + 6 * (size_t)L->bracket.pb.block[i], L->upper + 6 * (size_t)i, 6 * sizeof *r->dq);
    memcpy(L->bracket.dq, L->upper, bytes);
    sp__bracket_resists(&L->bracket, r->upper);
    memcpy(L->upper, L->bracket.dq, bytes);
    L->best = sp__limit_balance(L);
    if (r->lower < 0 && sp__limit_never_stands(L)) L->none = sp__limit_upper_at(L, 0);
}

/* What is open by now is asked of whole checks: the dead loads, the ends, and from where on it stands. Not where the caller
 * wants less work than theirs. */
SP__NOINLINE static void sp__limit_last(sp__limit *L, int endless)
{
    sp_limit_result *r = &L->r;
    if ((r->kind && r->dead) || sp__engine_flops(&L->bracket) <= 0 || L->bracket.wide.iterations < SP__ITERATIONS) return;
    const int open = !r->kind;
    L->bracket.slight = 1;
    L->least = 0;
    memset(L->lower, 0, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->lower);
    if (!r->dead) sp__limit_check_dead(L);
    const sp_real fell = L->least;
    if (open) {
        if (endless) r->kind = SP_LIMIT_UNBOUNDED;
        else if (!L->none) sp__limit_halve(L);
        sp__limit_conclude(L);
        if (r->kind == SP_LIMIT_NONE) r->dead = SP_UNSTABLE;
    }
    L->engine.n.left = L->engine.most;
    if (r->dead == SP_UNSTABLE) sp__limit_lowest(L, fell + SP__LIMIT_STEP * r->tol * (1 + fell));
}
#else
static void sp__limit_last(sp__limit *L, int endless) { (void)L; (void)endless; }
#endif

/* Search, then both ends; `a` is used up. */
SP__NOINLINE static sp_status sp__limit_decide(sp__limit *L, sp_arena *a)
{
    sp__bracket *b = &L->bracket;
    int done = 0;
    const sp_status status = sp__limit_start(L, a, &done);
    if (status) return status;
    if (!done && !L->none) sp__limit_newton(L);
    sp__limit_endless(L);
    if (L->none || (L->r.kind != SP_LIMIT_UNBOUNDED && L->best < SP__HUGE)) sp__limit_upper(L);
    const int endless = L->r.kind == SP_LIMIT_UNBOUNDED;
    sp__limit_conclude(L);
    sp__limit_lowest(L, 0);
    sp__limit_last(L, endless);
    if (SP__WITH_INTERIOR && L->r.upper < 0) memset(L->r.dq, 0, 6 * (size_t)b->scene.count.blocks * sizeof *L->r.dq);
    if (L->r.kind != SP_LIMIT_UNBOUNDED) memset(L->r.ray, 0, 3 * (size_t)b->pb.points * sizeof *L->r.ray);
    return SP_OK;
}

/* Numbers of a result: f, ray, dq, and y0 of the interior points. */
static size_t sp__limit_numbers(const sp_scene *scene, int32_t blocks)
{
    return 6 * ((size_t)scene->count.points + (size_t)scene->count.blocks) + (SP__WITH_INTERIOR ? 24 * (size_t)blocks : 0);
}

/* Memory of a limit besides the bracket's own; room for its certificate checks last.        returns 0: no memory */
static int sp__limit_carve(sp__limit *L, sp_arena *rows, sp_arena *a)
{
    const sp_problem *pb = &L->bracket.pb;
    L->f = sp__take(a, (size_t)pb->points, 3 * sizeof *L->f);
    L->upper = sp__take(a, (size_t)pb->blocks, 6 * sizeof *L->upper);
    L->lower = sp__take(a, (size_t)pb->blocks, 6 * sizeof *L->lower);
    if (!sp__engine_carve(&L->engine, pb, rows, a)) return 0;
    const size_t need = sp__certifier_need(pb, &L->bracket.set);
    L->bracket.room.base = sp__take(a, 1, need);
    L->bracket.room.capacity = need ? need : 1;                 /* 0 would mean that something did not fit */
    return !sp__failed(a);
}

static size_t sp__limit_scratch(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp__problem_count(scene, &pb);
    return sizeof(sp__limit) + SP_ALIGN + sp__limit_verify_memory(scene) + SP_ALIGN + sp__limit_start_scratch(&pb);
}

SP__NOINLINE static sp_status sp__limit_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch,
                                               size_t *bytes)
{
    if (!scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__limit *L = sp__take(&scratch, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    const sp_status status = sp__bracket_build(scene, settings, &L->bracket, &scratch);
    if (status) return status;
    const sp_problem *pb = &L->bracket.pb;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, sp__limit_numbers(scene, pb->blocks), sizeof(sp_real));
    sp__take(&dry, 1, sizeof *L);
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp_real *at[5];
    sp__bracket_carve(at, pb->blocks, &dry);
    if (!sp__limit_carve(L, &scratch, &dry)) return SP_E_MEMORY;
    if (!sp__limit_start_need(L, scratch, &dry)) return SP_E_MEMORY;
    *bytes = dry.used;
    return SP_OK;
}

/* All that a limit works on, in arena `a`; results in `number`. */
static sp_status sp__limit_build(sp__limit *L, const sp_scene *scene, const sp_settings *settings, sp_real *number, sp_arena *a)
{
    sp_limit_result *r = &L->r;
    const sp_status status = sp__bracket_build(scene, settings, &L->bracket, a);
    if (status) return status;
    if (!sp__limit_carve(L, a, a)) return SP_E_MEMORY;
    r->f = number;
    r->ray = r->f + 3 * (size_t)scene->count.points;
    r->dq = r->ray + 3 * (size_t)scene->count.points;
    r->y0 = SP__WITH_INTERIOR ? r->dq + 6 * (size_t)scene->count.blocks : NULL;
    r->lower = r->upper = r->lowest = -1;
    r->tol = L->bracket.set.tol;
    r->force_bound = L->bracket.set.force_bound;
    sp__engine_begin(&L->engine, &L->bracket, a);
    L->best = SP__HUGE;
    sp__limit_fell(L, SP__HUGE);
    L->ref = sp__engine_reference(&L->bracket);
    return SP_OK;
}

/* How many numbers a result of this scene has. */
SP__NOINLINE static size_t sp__limit_room(const sp_scene *scene)
{
    sp_problem count;
    sp__problem_count(scene, &count);
    return sp__limit_numbers(scene, count.blocks);
}

SP_API sp_status sp_limit(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_limit_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp_arena a = *arena;
    const size_t numbers = sp__limit_room(scene);
    sp_real *number = sp__take(&a, numbers, sizeof *number);
    const size_t kept = a.used;
    sp__limit *L = sp__take(&a, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    memset(number, 0, numbers * sizeof *number);
    memset(L, 0, sizeof *L);
    sp_status status = sp__limit_build(L, scene, settings, number, &a);
    if (!status) status = sp__limit_decide(L, &a);
    if (!status && L->bracket.lacking) status = SP_E_MEMORY;            /* not the answer that the memory it takes gives */
    if (status) return status;
    L->r.verified = L->r.kind != SP_LIMIT_UNDECIDED && sp__bracket_verify(&L->bracket, &L->r);
    if (L->r.kind && !L->r.verified) L->r.reason = L->bracket.spent ? SP_REASON_BUDGET : SP_REASON_UNVERIFIED;
    if (!L->r.verified) L->r.kind = SP_LIMIT_UNDECIDED;
    L->r.cost = *sp__engine_cost(&L->engine, &L->bracket);
    L->r.peak_bytes = a.peak;
    arena->used = kept;
    arena->peak = a.peak;
    *result = L->r;
    return SP_OK;
}

#elif SP__WITH_STONES

static size_t sp__limit_scratch(const sp_scene *scene) { return scene ? SP_ALIGN : 0; }
static sp_status sp__limit_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    return (void)scene, (void)settings, (void)scratch, (void)bytes, SP_E_UNSUPPORTED;
}

#endif

#endif /* SP__LIMIT_LIMIT_C */
