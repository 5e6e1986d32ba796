/* descend: from a state nearly found to one that is exact and lies lower, by two linear programs in turn.
 *
 *   forces   least lambda with A f + p + lambda q = 0 over f that a motion v allows: none where it opens, ft = -+mu fn where it
 *            slides. x = (fn + ft / mu, fn - ft / mu) / 2 >= 0 counts along both edges of the cone, so all bounds are of x
 *   motion   v that f allows: dn >= 0, = 0 where it presses, dt = 0 where |ft| < mu fn, least sum cn dn + ct |dt|, q . v = 1.
 *            Its dual has the same matrix: A g + kappa q = 0, gn <= cn, |gt| <= ct (no bound where v must stay), least kappa; v
 *            are its multipliers. Costs are high where more freedom of f would lower lambda
 *   mending  what no pattern fits: g = sum fn dn + ft dt + mu fn |dt| >= 0 is 0 of states alone; the least over f, then over v,
 *            by the same programs
 */
#ifndef SP__SLIDING_DESCEND_C
#define SP__SLIDING_DESCEND_C

#include "../linear/simplex.c"
#include "push.c"

#if SP__WITH_SLIDING

#define SP__DESCEND_ROUNDS 60
#define SP__DESCEND_PLAIN 3             /* rounds without a lower lambda, and among forces as good others are taken */
#define SP__DESCEND_STALL 10            /* and it is enough */
#define SP__DESCEND_MENDS 12
#define SP__DESCEND_STEPS 20            /* most steps of a program, for each row */
#ifdef SP_REAL_FLOAT
#define SP__DESCEND_NONE ((sp_real)1e-4)    /* force, rate, gain of lambda, g that counts as none, of the largest */
#define SP__DESCEND_TIE ((sp_real)1e-4)
#else
#define SP__DESCEND_NONE ((sp_real)1e-9)
#define SP__DESCEND_TIE ((sp_real)1e-7)     /* costs of forces that choose among those as good */
#endif
#define SP__DESCEND_FIRST ((sp_real)1e-5)   /* rate that counts as none in a motion that is not exact yet */

/* Numbers without pattern, the same on every machine: 0 .. 1.                                      [xorshift64*: Vigna 2016] */
static sp_real sp__slide_random(uint64_t *seed)
{
    uint64_t x = *seed;
    x ^= x >> 12; x ^= x << 25; x ^= x >> 27;
    *seed = x;
    return (sp_real)((uint32_t)((x * 2685821657736338717u) >> 40)) / (sp_real)16777216;
}

typedef struct sp__descend {
    const sp__slab *w;
    sp__simplex force, motion;
    sp_real *fn, *ft, *v;               /* corners, corners, rows: the best state */
    sp_real lambda;                     /* its; < 0: none */
    sp_real size;                       /* sum |q|: q . v of its motion */
    uint64_t seed;
    int64_t limit;                      /* of flops of both */
} sp__descend;

static void sp__descend_program(sp__simplex *x, int32_t corners, int32_t rows, sp_arena *a)
{
    sp__simplex_carve(x, rows, 2 * corners + 1, 12 * corners + rows, a);
}

static void sp__descend_carve(sp__descend *s, int32_t corners, int32_t rows, sp_arena *a)
{
    sp__descend_program(&s->force, corners, rows, a);
    sp__descend_program(&s->motion, corners, rows, a);
    s->fn = sp__take(a, (size_t)corners, sizeof *s->fn);
    s->ft = sp__take(a, (size_t)corners, sizeof *s->ft);
    s->v = sp__take(a, (size_t)rows, sizeof *s->v);
}

/* Bytes of that. */
SP__NOINLINE static size_t sp__descend_need(int32_t corners, int32_t rows)
{
    sp__simplex x;
    sp_arena dry = sp__arena_dry();
    sp__descend_program(&x, corners, rows, &dry);
    sp__descend_program(&x, corners, rows, &dry);
    sp__take(&dry, (size_t)corners, sizeof(sp_real));
    sp__take(&dry, (size_t)corners, sizeof(sp_real));
    sp__take(&dry, (size_t)rows, sizeof(sp_real));
    return dry.used;
}

static int64_t sp__descend_flops(const sp__descend *s) { return s->force.flops + s->motion.flops; }

/* One of both programs as far as it goes.     returns 0: it was not solved, or flops ended it */
static int sp__descend_solve(sp__descend *s, sp__simplex *x)
{
    x->limit = x->flops + s->limit - sp__descend_flops(s);
    return sp__simplex_run(x, SP__DESCEND_STEPS * x->m) == SP__SIMPLEX_BEST;
}

/* Column j = a n + b t of a corner. */
static void sp__descend_column(sp__simplex *s, int32_t j, const sp__slab_corner *k, sp_real a, sp_real b)
{
    int32_t e = s->start[j];
    for (int i = 0; i < 6; i++) {
        if (k->row[i / 3] < 0) continue;
        s->index[e] = k->row[i / 3] + i % 3;
        s->value[e++] = a * k->n[i] + b * k->t[i];
    }
    s->start[j + 1] = e;
}

/* The last column, q, and the right side. */
static void sp__descend_loads(const sp__slab *w, sp__simplex *x, sp_real p)
{
    const int32_t last = 2 * w->corners;
    int32_t e = x->start[last];
    for (int32_t i = 0; i < w->rows; i++) {
        x->b[i] = p * w->p[i];
        if (!(sp__abs(w->q[i]) > 0)) continue;
        x->index[e] = i;
        x->value[e++] = w->q[i];
    }
    x->start[last + 1] = e;
}

/* Both programs' matrices. */
SP__NOINLINE static void sp__descend_make(sp__descend *s)
{
    const sp__slab *w = s->w;
    s->force.start[0] = s->motion.start[0] = 0;
    for (int32_t v = 0; v < w->corners; v++) {
        const sp__slab_corner *k = &w->corner[v];
        sp__descend_column(&s->force, 2 * v, k, 1, k->mu);
        sp__descend_column(&s->force, 2 * v + 1, k, 1, -k->mu);
        sp__descend_column(&s->motion, 2 * v, k, 1, 0);
        sp__descend_column(&s->motion, 2 * v + 1, k, 0, 1);
    }
    sp__descend_loads(w, &s->force, -1);
    sp__descend_loads(w, &s->motion, 0);
    s->size = 0;
    for (int32_t i = 0; i < w->rows; i++) s->size += sp__abs(w->q[i]);
}

static sp_real sp__descend_fn(const sp__descend *s, int32_t v) { return s->force.x[2 * v] + s->force.x[2 * v + 1]; }

static sp_real sp__descend_ft(const sp__descend *s, int32_t v)
{
    return s->w->corner[v].mu * (s->force.x[2 * v] - s->force.x[2 * v + 1]);
}

/* Which shares the motion m allows, NULL: all; rates below `none` of the largest are none. */
static void sp__descend_allow(sp__descend *s, const sp_real *m, sp_real none)
{
    const sp__slab *w = s->w;
    sp__simplex *x = &s->force;
    sp_real largest = 0;
    for (int32_t v = 0; m && v < w->corners; v++) {
        const sp__slab_corner *k = &w->corner[v];
        largest = sp__max(largest, sp__max(sp__abs(sp__slab_rate(k, k->n, m)), sp__abs(sp__slab_rate(k, k->t, m))));
    }
    none *= largest;
    for (int32_t v = 0; v < w->corners; v++) {
        const sp__slab_corner *k = &w->corner[v];
        const sp_real open = m ? sp__slab_rate(k, k->n, m) : 0, slip = m ? sp__slab_rate(k, k->t, m) : 0;
        x->lower[2 * v] = x->lower[2 * v + 1] = 0;
        x->upper[2 * v] = open <= none && (slip <= none || !(k->mu > 0)) ? SP__SIMPLEX_FREE : 0;
        x->upper[2 * v + 1] = open <= none && slip >= -none && k->mu > 0 ? SP__SIMPLEX_FREE : 0;
        for (int32_t j = 2 * v; j < 2 * v + 2; j++) if (!(x->upper[j] > 0) && x->at[j] < 0) x->x[j] = 0;
    }
    x->lower[2 * w->corners] = 0;
    x->upper[2 * w->corners] = SP__SIMPLEX_FREE;
}

/* Forces and lambda of a history, as far as motion m (NULL: any) allows them, made to balance.     returns 0: they can't be */
static int sp__descend_enter(sp__descend *s, const sp__push *from, const sp_real *m)
{
    const sp__slab *w = s->w;
    sp__simplex *x = &s->force;
    for (int32_t v = 0; v < w->corners; v++) {
        const sp_real mu = w->corner[v].mu, half = mu > 0 ? from->ft[v] / mu : from->fn[v];
        x->x[2 * v] = sp__max(0, (from->fn[v] + half) / 2);
        x->x[2 * v + 1] = sp__max(0, (from->fn[v] - half) / 2);
        x->at[2 * v] = x->at[2 * v + 1] = -1;
    }
    x->x[2 * w->corners] = sp__max(0, from->lambda);
    sp__descend_allow(s, m, SP__DESCEND_FIRST);
    x->limit = x->flops + s->limit - sp__descend_flops(s);
    return sp__simplex_meet(x, SP__DESCEND_STEPS * w->rows);
}

/* Least lambda from x, which balances; `tie`: cost of forces.     returns 0: not found */
static int sp__descend_least(sp__descend *s, sp_real tie)
{
    sp__simplex *x = &s->force;
    const int32_t last = 2 * s->w->corners;
    for (int32_t j = 0; j < last; j++) x->cost[j] = tie * sp__slide_random(&s->seed);
    x->cost[last] = 1;
    return sp__descend_solve(s, x);
}

/* The motion's dual from its point 0, bounds given; the motion goes to motion.y.     returns 0: there is none, or not found */
static int sp__descend_move(sp__descend *s)
{
    sp__simplex *m = &s->motion;
    const int32_t last = 2 * s->w->corners;
    for (int32_t j = 0; j < last + 1 + m->m; j++) m->x[j] = m->cost[j] = 0;
    m->lower[last] = -SP__SIMPLEX_FREE;
    m->upper[last] = SP__SIMPLEX_FREE;
    m->cost[last] = s->size;
    return sp__descend_solve(s, m);
}

/* Bounds of the dual for motions that the forces at hand allow. */
static void sp__descend_follow(sp__descend *s)
{
    const sp__slab *w = s->w;
    const sp__simplex *f = &s->force;
    sp__simplex *m = &s->motion;
    sp_real none = 0;
    for (int32_t v = 0; v < w->corners; v++) none = sp__max(none, SP__DESCEND_NONE * sp__descend_fn(s, v));
    for (int32_t j = 0; j < 2 * w->corners; j += 2) {
        sp_real cn = sp__slide_random(&s->seed) / 100, ct = sp__slide_random(&s->seed) / 100;
        const int up = f->upper[j] > 0, down = f->upper[j + 1] > 0;
        const sp_real a = up ? 0 : -sp__simplex_rate(f, j), b = down ? 0 : -sp__simplex_rate(f, j + 1);
        const sp_real wish = 10 * sp__max(0, sp__max(a, b));
        if (up || down) ct += wish; else cn += wish;
        m->upper[j] = f->x[j] + f->x[j + 1] > none ? SP__SIMPLEX_FREE : cn;
        m->lower[j] = -SP__SIMPLEX_FREE;
        const int rough = w->corner[j / 2].mu > 0;      /* without friction x is fn and 0, and slips either way */
        m->upper[j + 1] = rough && f->x[j] > none ? SP__SIMPLEX_FREE : ct;  /* ft > -mu fn: no slip along t */
        m->lower[j + 1] = f->x[j + 1] > none ? -SP__SIMPLEX_FREE : -ct;
    }
}

/* Costs of forces: g of the motion y. */
static void sp__descend_cost(sp__descend *s, const sp_real *y)
{
    const sp__slab *w = s->w;
    for (int32_t v = 0; v < w->corners; v++) {
        const sp__slab_corner *k = &w->corner[v];
        const sp_real open = sp__max(0, sp__slab_rate(k, k->n, y)), slip = sp__slab_rate(k, k->t, y);
        s->force.cost[2 * v] = open + k->mu * (slip + sp__abs(slip));
        s->force.cost[2 * v + 1] = open + k->mu * (sp__abs(slip) - slip);
    }
    s->force.cost[2 * w->corners] = 0;
}

/* Bounds of the dual whose least is -g of the forces at hand. */
static void sp__descend_bound(sp__descend *s)
{
    const sp__slab *w = s->w;
    const sp_real *x = s->force.x;
    for (int32_t v = 0; v < w->corners; v++) {
        const int32_t j = 2 * v;
        const sp_real mu = w->corner[v].mu;
        s->motion.upper[j] = x[j] + x[j + 1];
        s->motion.lower[j] = -SP__SIMPLEX_FREE;
        s->motion.upper[j + 1] = 2 * mu * x[j];
        s->motion.lower[j + 1] = -2 * mu * x[j + 1];
    }
}

/* Forces and motion of a history to such with g = 0.     returns 0: it stays above */
SP__NOINLINE static int sp__descend_mend(sp__descend *s, const sp__push *from)
{
    const sp__slab *w = s->w;
    const sp_real work = sp__dot(w->q, from->v, (size_t)w->rows);
    sp_real last = SP__HUGE;
    if (!(work > 0) || !sp__descend_enter(s, from, NULL)) return 0;
    for (int32_t i = 0; i < w->rows; i++) s->motion.y[i] = from->v[i] * (s->size / work);
    for (int k = 0; k < SP__DESCEND_MENDS; k++) {
        sp__descend_cost(s, s->motion.y);
        if (!sp__descend_solve(s, &s->force)) return 0;
        sp__descend_bound(s);
        if (!sp__descend_move(s)) return 0;
        const sp_real g = -s->motion.x[2 * w->corners];
        if (g < SP__DESCEND_NONE) { sp__descend_allow(s, s->motion.y, SP__DESCEND_NONE); return 1; }
        if (g > (sp_real)0.99 * last) return 0;
        last = g;
    }
    return 0;
}

/* Keeps the state of the programs' points. */
static void sp__descend_keep(sp__descend *s)
{
    const sp__slab *w = s->w;
    for (int32_t v = 0; v < w->corners; v++) {
        s->fn[v] = sp__descend_fn(s, v);
        s->ft[v] = sp__descend_ft(s, v);
    }
    memcpy(s->v, s->motion.y, (size_t)w->rows * sizeof *s->v);
    s->lambda = s->force.x[2 * w->corners];
}

/* The motion's program begins: nothing in its basis. */
static void sp__descend_begin(sp__descend *s)
{
    const int32_t all = 2 * s->w->corners + 1;
    for (int32_t i = 0; i < s->w->rows; i++) s->motion.lower[all + i] = s->motion.upper[all + i] = 0;
    for (int32_t j = 0; j < all; j++) s->motion.x[j] = 0;
    sp__simplex_begin(&s->motion);
}

/* From forces, motion and lambda of a history; `flops` it may take. Its best state is kept.     returns 0: none was found */
SP__NOINLINE static int sp__descend_run(sp__descend *s, const sp__push *from, int64_t flops)
{
    const int32_t last = 2 * s->w->corners;
    int stall = 0;
    s->lambda = -1;
    s->limit = sp__descend_flops(s) + flops;
    sp__descend_begin(s);
    if (!sp__descend_enter(s, from, from->v) && !sp__descend_mend(s, from)) return 0;
    for (int k = 0; k < SP__DESCEND_ROUNDS && stall < SP__DESCEND_STALL; k++) {
        if (!sp__descend_least(s, stall < SP__DESCEND_PLAIN ? 0 : SP__DESCEND_TIE)) break;
        sp__descend_follow(s);
        if (!sp__descend_move(s)) break;
        stall = s->lambda < 0 || s->force.x[last] < s->lambda * (1 - SP__DESCEND_TIE) ? 0 : stall + 1;
        if (s->lambda < 0 || s->force.x[last] < s->lambda) sp__descend_keep(s);
        sp__descend_allow(s, s->motion.y, SP__DESCEND_NONE);
    }
    return s->lambda >= 0;
}

/* Forces of the program's point: two columns a corner, (1, b) and (1, -b); b = 0: pressure alone, in the first. */
static void sp__descend_take(const sp__descend *s, int rubs, sp_real *fn, sp_real *ft)
{
    for (int32_t v = 0; v < s->w->corners; v++) {
        const sp_real *x = s->force.x + 2 * v;
        fn[v] = x[0] + x[1];
        ft[v] = rubs ? s->w->corner[v].mu * (x[0] - x[1]) : 0;
    }
}

/* Largest lambda >= 0 that forces carry, at most `most`, pressure alone or with friction: forces into f, those at lambda = 0
 * into rest, fn and then ft of all corners.     returns -1: not even 0 */
SP__NOINLINE static sp_real sp__descend_most(sp__descend *s, int rubs, sp_real most, sp_real *const f[2],
                                             sp_real *const rest[2], int64_t flops)
{
    const sp__slab *w = s->w;
    sp__simplex *x = &s->force;
    const int32_t last = 2 * w->corners;
    s->limit = sp__descend_flops(s) + flops;
    x->limit = x->flops + flops;
    for (int32_t v = 0; v < w->corners; v++) {
        const sp_real b = rubs ? w->corner[v].mu : 0;
        sp__descend_column(x, 2 * v, &w->corner[v], 1, b);
        sp__descend_column(x, 2 * v + 1, &w->corner[v], rubs ? (sp_real)1 : 0, -b);
    }
    for (int32_t j = 0; j <= last; j++) {
        x->x[j] = x->lower[j] = 0;
        x->upper[j] = j < last && (rubs || j % 2 == 0) ? SP__SIMPLEX_FREE : 0;
    }
    const int stands = sp__simplex_meet(x, SP__DESCEND_STEPS * w->rows);
    sp__descend_take(s, rubs, rest[0], rest[1]);
    x->upper[last] = most;
    x->cost[last] = -1;
    if (stands) sp__descend_solve(s, x);
    sp__descend_take(s, rubs, f[0], f[1]);
    const sp_real lambda = x->x[last];
    sp__descend_make(s);
    return stands ? lambda : -1;
}

#endif

#endif /* SP__SLIDING_DESCEND_C */
