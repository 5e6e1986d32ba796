/* motion: u = Aeq' y contact by contact, and its transpose.
 *
 *   V, W           velocity of B seen from A at the contact's origin, and its rotation, in the contact's frame
 *   u = V + W x l  rate of a vertex at l
 *   r += z (F, arm x F + M)           force F and moment M about the origin, on both blocks
 *
 * In a reduced search the same by 3 rows a block. Work is counted here, before it is done.
 */
#ifndef SP__STATICS_MOTION_C
#define SP__STATICS_MOTION_C

#include "../base/vectors.c"
#include "../scene/problem.c"
#include "system.c"

#if SP__WITH_LARGE

/* S of a contact's vertices, ~ min(sbar_A, sbar_B): without it a pebble beside a cathedral is lost in rounding. */
static inline sp_real sp__system_scale(const sp__system *w, int32_t c)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real s = w->measure.metric > 0 ? sp__least_of_blocks(t, w->measure.size, 2) * w->measure.metric : 1;
    return s > 0 ? s : 1;
}

/* Frame of a contact in a reduced search, and the maps of its two blocks behind it. */
static const sp_real *sp__reduction_frame(const sp__system *w, const sp_contact *t)
{
    return w->reduction->g + SP__REDUCTION_G * (size_t)(t - w->pb->contact);
}

/* T of a block of a contact, +- that of its weighted rows: (along n, slip, turn), level (along n, two turns), at the origin of
 * the contact, of B seen from A.
 *   planar         [ nx ny arm0 ;  -ny nx arm1 ;  0 0 1 ]
 *   level          [ +-1 +-arm0 +-arm1 ;  0 1 0 ;  0 0 1 ]
 * By columns without the two zeros. */
static void sp__reduction_map(const sp__system *w, const sp_contact *t, int side)
{
    const sp__reduction *o = w->reduction;
    const int32_t i = side ? t->b : t->a;
    sp_real *g = o->g + SP__REDUCTION_G * (size_t)(t - w->pb->contact), *T = g + 6 + 7 * side;
    if (i < 0) return;
    const sp_real sign = side ? (sp_real)1 : (sp_real)-1, up = sp__dot3(t->joint->n, o->e[2]) < 0 ? -sign : sign;
    const sp_real x = sp__dot3(side ? t->rb : t->ra, o->e[0]), y = sp__dot3(side ? t->rb : t->ra, o->e[1]);
    const sp_real z = w->measure.weight[2 * (size_t)i], turn = w->measure.weight[2 * (size_t)i + 1];
    const int plane = o->mode == SP__PLANE;
    T[0] = plane ? sign * z * g[0] : up * z;
    T[1] = plane ? -sign * z * g[1] : 0;
    T[2] = plane ? sign * z * g[1] : up * turn * y;
    T[3] = plane ? sign * z * g[0] : sign * turn;
    T[4] = plane ? sign * turn * (g[1] * x - g[0] * y) : -up * turn * x;
    T[5] = plane ? sign * turn * (g[0] * x + g[1] * y) : 0;
    T[6] = sign * turn;
}

/* Row weights: 1 / sqrt(sum S) for forces, 1 / sqrt(2/3 sum S |r_v - c|^2) for moments: unit diagonal on average. */
static void sp__system_weights(sp__system *w)
{
    const sp_problem *pb = w->pb;
    for (size_t k = 0; k < 2 * (size_t)pb->blocks; k++) w->measure.weight[k] = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            sp_real o[3], *z = w->measure.weight + 2 * (size_t)i;
            const sp_real *arm = side ? t->rb : t->ra;
            const sp_real S = sp__system_scale(w, c);
            o[0] = sp__dot3(arm, t->joint->n); o[1] = sp__dot3(arm, t->joint->t1); o[2] = sp__dot3(arm, t->joint->t2);
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                const sp_real *l = pb->local[v];
                const sp_real x = o[0] + l[0], y = o[1] + l[1], s = o[2] + l[2];
                const sp_real times = S * sp__system_multiplicity(w, v);
                z[0] += times;
                z[1] += times * (x * x + y * y + s * s) * 2 / 3;
            }
        }
    }
    for (sp_real *z = w->measure.weight; z < w->measure.weight + 2 * pb->blocks; z++) *z = *z > 0 ? 1 / SP_SQRT(*z) : 1;
    for (int32_t c = 0; c < 2 * pb->contacts && sp__reduced(w); c++) sp__reduction_map(w, &pb->contact[c / 2], c % 2);
}

/* Rows of held directions to zero. */
static void sp__system_release(const sp__system *w, sp_real *r)
{
    for (int32_t i = 0; i < w->pb->blocks; i++)
        if (w->pb->scene->block[w->pb->block[i]].fixed) sp__drop_held(w->pb, i, r + 6 * (size_t)i);
}

/* Force (k even) or moment of the load of block k / 2 in units, in the axes of the rows. */
static inline void sp__system_load_of(const sp__system *w, size_t k, sp_real p[3])
{
    sp__to_units(w->measure.unit, 3, w->pb->p + 3 * k, p);
    if (!sp__reduced(w)) return;
    const int plane = w->reduction->mode == SP__PLANE, along = plane == (int)(k % 2);         /* rows 2 and 5, or the others */
    sp_real (*e)[3] = w->reduction->e;
    const sp_real x = along ? 0 : sp__dot3(p, e[0]), y = along ? 0 : sp__dot3(p, e[1]);
    p[2] = along ? sp__dot3(p, e[2]) : 0;
    p[0] = x; p[1] = y;
}

/* r <- the weighted load in units. */
static void sp__system_load(const sp__system *w, sp_real *r)
{
    for (size_t k = 0; k < 2 * (size_t)w->pb->blocks; k++) {
        sp__system_load_of(w, k, r + 3 * k);
        for (size_t q = 3 * k; q < 3 * k + 3; q++) r[q] *= w->measure.weight[k];
    }
    sp__system_release(w, r);
}

/* load . y */
static sp_real sp__system_work(const sp__system *w, const sp_real *y)
{
    sp_real s = 0;
    for (size_t k = 0; k < 2 * (size_t)w->pb->blocks; k++) {
        sp_real p[3];
        sp__system_load_of(w, k, p);
        for (size_t q = 0; q < 3; q++) s += w->measure.weight[k] * p[q] * y[3 * k + q];
    }
    return s;
}

/* Is K_v of any contact no cone? */
static int sp__problem_strong(const sp_problem *pb)
{
    for (int32_t c = 0; c < pb->contacts; c++) if (sp__contact_strong(pb, &pb->contact[c])) return 1;
    return 0;
}

/* Coefficient of contact c in force. */
static sp_real sp__system_mu(const sp__system *w, int32_t c)
{
    return sp__max(w->law.least, w->pb->contact[c].joint->strength.mu * w->law.friction);
}

/* K of a vertex of contact c in units, and as f = S P_(K/S)(u) wants it: strength over S, friction in its own units. It lies in
 * w->law.yield until the next call. */
static const sp__yield *sp__system_yield(const sp__system *w, int32_t c)
{
    const sp_contact *t = &w->pb->contact[c];
    sp__yield *k = w->law.yield;
    k->mu = sp__system_mu(w, c);
    k->plain = !sp__contact_strong(w->pb, t);
    k->C = k->T = 0;
    k->N = SP__HUGE;
    if (k->plain) return k;
    const sp__vertex_limits strength = sp__vertex_strength(t->joint, w->pb->ignore_strength);
    const sp_real newton = sp__in_units(w->measure.unit * sp__system_scale(w, c), 1); /* in units */
    k->C = strength.C * newton * w->law.friction;
    k->T = strength.T * newton;
    k->N = sp__ratio(strength.N, 1 / newton);
    return k;
}

/* X = T y: motion of B seen from A at the origin of a contact. */
static inline void sp__reduction_motion(const sp__system *w, const sp_contact *t, const sp_real *g, const sp_real *y,
                                        sp_real X[3])
{
    const sp__reduction *o = w->reduction;
    const size_t row[3] = { sp__reduction_row(o, 0), sp__reduction_row(o, 1), sp__reduction_row(o, 2) };
    X[0] = X[1] = X[2] = 0;
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *T = g + 6 + 7 * side, *yi = y + 6 * (size_t)i;
        const sp_real a = yi[row[0]], b = yi[row[1]], c = yi[row[2]];
        X[0] += T[0] * a + T[2] * b + T[4] * c;
        X[1] += T[1] * a + T[3] * b + T[5] * c;
        X[2] += T[6] * c;
    }
}

/* r += T' Y: the forces Y that X meets. */
static inline void sp__reduction_gather(const sp__system *w, const sp_contact *t, const sp_real *g, const sp_real Y[3],
                                        sp_real *r)
{
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *T = g + 6 + 7 * side;
        sp_real *ri = r + 6 * (size_t)i;
        ri[sp__reduction_row(w->reduction, 0)] += T[0] * Y[0] + T[1] * Y[1];
        ri[sp__reduction_row(w->reduction, 1)] += T[2] * Y[0] + T[3] * Y[1];
        ri[sp__reduction_row(w->reduction, 2)] += T[4] * Y[0] + T[5] * Y[1] + T[6] * Y[2];
    }
}

/* V, W of sp__system_twist from 3 rows a block. */
SP__NOINLINE static void sp__reduction_twist(const sp__system *w, const sp_contact *t, const sp_real *y, sp_real V[3],
                                             sp_real W[3])
{
    const sp_real *g = sp__reduction_frame(w, t);
    const int plane = w->reduction->mode == SP__PLANE;
    sp_real X[3];
    sp__reduction_motion(w, t, g, y, X);
    V[0] = X[0]; V[1] = plane ? X[1] * g[2] : 0; V[2] = plane ? X[1] * g[3] : 0;
    W[0] = 0; W[1] = plane ? -X[2] * g[3] : X[1] * g[0] + X[2] * g[2]; W[2] = plane ? X[2] * g[2] : X[1] * g[1] + X[2] * g[3];
}

/* sp__system_scatter into 3 rows a block. */
SP__NOINLINE static void sp__reduction_scatter(const sp__system *w, const sp_contact *t, const sp_real F[3], const sp_real M[3],
                                               sp_real *r)
{
    const sp_real *g = sp__reduction_frame(w, t);
    const int plane = w->reduction->mode == SP__PLANE;
    const sp_real Y[3] = { F[0], plane ? F[1] * g[2] + F[2] * g[3] : g[0] * M[1] + g[1] * M[2],
                           plane ? g[2] * M[2] - g[3] * M[1] : g[2] * M[1] + g[3] * M[2] };
    sp__reduction_gather(w, t, g, Y, r);
}

/* sp__system_twist from 6 rows a block. */
SP__NOINLINE static void sp__full_twist(const sp__system *w, const sp_contact *t, const sp_real *y, sp_real V[3], sp_real W[3])
{
    sp_real v[3] = { 0, 0, 0 }, o[3] = { 0, 0, 0 };
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *yi = y + 6 * (size_t)i, *arm = side ? t->rb : t->ra;
        const sp_real sign = side ? (sp_real)1 : (sp_real)-1;
        const sp_real z = sign * w->measure.weight[2 * (size_t)i], s = sign * w->measure.weight[2 * (size_t)i + 1];
        const sp_real a = s * yi[3], b = s * yi[4], c = s * yi[5];
        v[0] += z * yi[0] + b * arm[2] - c * arm[1];
        v[1] += z * yi[1] + c * arm[0] - a * arm[2];
        v[2] += z * yi[2] + a * arm[1] - b * arm[0];
        o[0] += a; o[1] += b; o[2] += c;
    }
    V[0] = sp__dot3(v, t->joint->n); V[1] = sp__dot3(v, t->joint->t1); V[2] = sp__dot3(v, t->joint->t2);
    W[0] = sp__dot3(o, t->joint->n); W[1] = sp__dot3(o, t->joint->t1); W[2] = sp__dot3(o, t->joint->t2);
}

/* V, W: velocity of B seen from A at the contact's origin and its rotation, in the contact's frame, for weighted motion y. */
SP__NOINLINE static void sp__system_twist(const sp__system *w, const sp_contact *t, const sp_real *y, sp_real V[3],
                                          sp_real W[3])
{
    if (sp__reduced(w)) sp__reduction_twist(w, t, y, V, W);
    else sp__full_twist(w, t, y, V, W);
}

/* u = V + W x l, friction weighed. */
static void sp__system_rate(const sp__system *w, const sp_real V[3], const sp_real W[3], const sp_real l[3], sp_real u[3])
{
    u[0] = V[0] + W[1] * l[2] - W[2] * l[1];
    u[1] = (V[1] + W[2] * l[0] - W[0] * l[2]) * w->law.slide;
    u[2] = (V[2] + W[0] * l[1] - W[1] * l[0]) * w->law.slide;
}

/* f = S (P_K(u) - (max(0, -u_n) / gamma, 0, 0)), friction unweighed. */
static inline void sp__system_force_at(const sp__system *w, sp_real S, const sp__yield *yield, const sp_real u[3], sp_real f[3])
{
    sp__cone_project(&w->law.cone, yield, u, f);
    if (w->law.soft > 0 && u[0] < 0) f[0] += u[0] * w->law.soft;
    const sp_real slip = S * w->law.slide;
    f[0] *= S; f[1] *= slip; f[2] *= slip;
}

/* The same at a vertex of contact c. */
static void sp__system_force(const sp__system *w, int32_t c, const sp__yield *yield, const sp_real u[3], sp_real f[3])
{
    sp__system_force_at(w, sp__system_scale(w, c), yield, u, f);
}

/* sp__system_scatter into 6 rows a block. */
SP__NOINLINE static void sp__full_scatter(const sp__system *w, const sp_contact *t, const sp_real F[3], const sp_real M[3],
                                          sp_real *r)
{
    sp_real f[3], m[3];
    for (int k = 0; k < 3; k++) {
        f[k] = F[0] * t->joint->n[k] + F[1] * t->joint->t1[k] + F[2] * t->joint->t2[k];
        m[k] = M[0] * t->joint->n[k] + M[1] * t->joint->t1[k] + M[2] * t->joint->t2[k];
    }
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *arm = side ? t->rb : t->ra;
        const sp_real sign = side ? (sp_real)1 : (sp_real)-1;
        const sp_real z = sign * w->measure.weight[2 * (size_t)i], s = sign * w->measure.weight[2 * (size_t)i + 1];
        sp_real *ri = r + 6 * (size_t)i;
        ri[0] += z * f[0];
        ri[1] += z * f[1];
        ri[2] += z * f[2];
        ri[3] += s * (arm[1] * f[2] - arm[2] * f[1] + m[0]);
        ri[4] += s * (arm[2] * f[0] - arm[0] * f[2] + m[1]);
        ri[5] += s * (arm[0] * f[1] - arm[1] * f[0] + m[2]);
    }
}

/* r[i] += z (F, arm x F + M), F and M in the contact's frame about its origin, on both sides. */
static void sp__system_scatter(const sp__system *w, const sp_contact *t, const sp_real F[3], const sp_real M[3], sp_real *r)
{
    if (sp__reduced(w)) sp__reduction_scatter(w, t, F, M, r);
    else sp__full_scatter(w, t, F, M, r);
}

#define SP__FLOPS_SWEEP 48              /* a vertex: u 15, P_K about 15, sums 18; a contact adds SP__FLOPS_TWIST */
#define SP__FLOPS_TWIST 160
#define SP__FLOPS_HESSIAN 75            /* a vertex of the assembly; a contact adds SP__FLOPS_BLOCKS */
#define SP__FLOPS_BLOCKS 900

/* A factorisation was begun; whoever watches is told. */
static void sp__system_factorisation(sp__system *w)
{
    const sp_watch *watch = w->set->watch;
    w->budget.cost->factorisations++;
    if (watch) watch->step(watch->self, SP_STAGE_NONE, w->budget.cost);
}

/* Count work before it is done. What would exceed the budget latches, as a full arena does: this and all later work is left
 * out, so a check on a budget is a check without one that stops early.                returns whether the work is to be done */
static int sp__system_spend(sp__system *w, int64_t flops)
{
    if (flops > w->budget.limit - w->budget.cost->flops) w->budget.spent = 1;
    if (!w->budget.spent) w->budget.cost->flops += flops;
    return !w->budget.spent;
}

/* Pays for so many flops a vertex and a contact, the latter in parts of SP__FLOPS_TWIST. */
static int sp__system_count(sp__system *w, int32_t vertex, int32_t contact)
{
    const sp__reduction *o = sp__reduced(w);
    if (o) return sp__system_spend(w, vertex * o->vertices + contact * SP__FLOPS_REDUCED_TWIST / SP__FLOPS_TWIST * o->sides);
    return sp__system_spend(w, (int64_t)vertex * w->pb->points + (int64_t)contact * w->pb->contacts);
}

/* Pays for so many sweeps over all vertices and so many twists; a vertex with fn and one slip costs less. */
static int sp__system_sweep(sp__system *w, int32_t sweeps, int32_t twists)
{
    const sp__reduction *o = sp__reduced(w);
    if (o && o->no_strength) return sp__system_count(w, sweeps * SP__FLOPS_REDUCED_SWEEP(o), twists * SP__FLOPS_TWIST);
    return sp__system_count(w, sweeps * SP__FLOPS_SWEEP, twists * SP__FLOPS_TWIST);
}

#endif

#endif /* SP__STATICS_MOTION_C */
