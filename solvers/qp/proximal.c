/* proximal: quadratic programs by interior points with proximal terms.            [Schwan, Jiang, Kuhn, Jones 2023, "PIQP"]
 *
 *     min 1/2 x'Px + q'x   subject to   Ax = b in equations,   t (Ax - b_t) + s_t = 0, s_t >= 0 for each bound b_t,
 *
 * t = -1, b_t = l or t = 1, b_t = u. A bound has a multiplier y_t >= 0, a row the sum of t y_t. With r_t = t (Ax - b_t) + s_t,
 * c_t what is to be added to s_t y_t, Newton's step is
 *
 *     [ P + rho I      A'          ] [ dx ]   [ -(Px + q + A'y) ]         W = sum_t y_t / s_t
 *     [    A     -(1/W + delta I)  ] [ dy ] = [      -g / W     ]         g = sum_t t (c_t + y_t r_t) / s_t
 *
 *     v = (dy - g) / W = A dx - delta dy,     ds_t = -r_t - t v,     dy_t = (c_t - y_t ds_t) / s_t
 *
 * the system of ADMM (kkt.c) with other weights; in an equation 1/W = 0, b - Ax on the right. Steps are Mehrotra's: to mu = 0,
 * then again to as much of mu as that step left over, with its term of second order. rho and delta weigh proximal terms about
 * the iterate and fall with mu: rho slows what P leaves flat, delta rows that depend on others; delta is raised where a pivot
 * has the wrong sign. All scaled (ruiz.c); x, y judged on the data as given. Without a factor (SP_QP_CG) there is nothing here.
 */
#ifndef SP__PROXIMAL_C
#define SP__PROXIMAL_C

#include "auglag.c"
#include "certificate.c"

#if SP__WITH_QP
#if SP__WITH_QP_INTERIOR

#ifdef SP_REAL_FLOAT
#define SP__PROXIMAL_RHO   ((sp_real)1e-6)              /* least */
#define SP__PROXIMAL_DELTA ((sp_real)1e-5)
#define SP__PROXIMAL_MOST  ((sp_real)1e-3)              /* what the least delta may be raised to */
#else
#define SP__PROXIMAL_RHO   ((sp_real)1e-10)
#define SP__PROXIMAL_DELTA ((sp_real)1e-8)
#define SP__PROXIMAL_MOST  ((sp_real)1e-6)
#endif
#define SP__PROXIMAL_TAU   ((sp_real)0.995)             /* of the way to the boundary */
#define SP__PROXIMAL_ENOUGH ((sp_real)1e-6)             /* of eps: no digits beyond that are looked for */
#define SP__PROXIMAL_FEW    ((sp_real)1e-2)             /* of eps: less is left to the method of multipliers */
#define SP__PROXIMAL_WEAK   ((sp_real)1e2)              /* s_t and y_t nearer than that: neither is 0 yet */
#define SP__PROXIMAL_LITTLE ((sp_real)1e-3)             /* s_t, y_t at the start, at least */
enum { SP__PROXIMAL_STEPS = 200, SP__PROXIMAL_IDLE = 20, SP__PROXIMAL_RAISES = 3, SP__PROXIMAL_AFTER = 100 };

/* Lengths of a step, of x and s_t, of y and y_t. */
typedef struct sp__strides { sp_real primal, dual; } sp__strides;

/* Is bound k there, and in no equation? k = i: l of row i, k = m + i: u. */
static int sp__side_there(const sp__qp *w, int32_t k) { return w->ip.s[k] > 0; }

/* t (Ax - b_t) */
static sp_real sp__side_over(const sp__qp *w, int32_t k)
{
    const int32_t m = w->qp.m, i = k < m ? k : k - m;
    return k < m ? w->E[i] * (w->qp.l[i] - w->Ax[i]) : w->E[i] * (w->Ax[i] - w->qp.u[i]);
}

/* ds_t; *dy: dy_t */
static sp_real sp__side_step(const sp__qp *w, int32_t k, sp_real *dy)
{
    const int32_t m = w->qp.m;
    const sp_real tv = k < m ? -w->ip.v[k] : w->ip.v[k - m], ds = -sp__side_over(w, k) - w->ip.s[k] - tv;
    *dy = (w->ip.c[k] - w->ip.y[k] * ds) / w->ip.s[k];
    return ds;
}

/* W of row i; 0: no bounds. */
static sp_real sp__proximal_weight(const sp__qp *w, int32_t i)
{
    sp_real W = 0;
    for (int32_t k = i; k < 2 * w->qp.m; k += w->qp.m)
        if (sp__side_there(w, k)) W += w->ip.y[k] / w->ip.s[k];
    return W;
}

/* g of row i. */
static sp_real sp__proximal_target(const sp__qp *w, int32_t i)
{
    sp_real g = 0;
    for (int32_t k = i; k < 2 * w->qp.m; k += w->qp.m) {
        if (!sp__side_there(w, k)) continue;
        const sp_real tg = (w->ip.c[k] + w->ip.y[k] * (sp__side_over(w, k) + w->ip.s[k])) / w->ip.s[k];
        g += k == i ? -tg : tg;
    }
    return g;
}

/* Factor for s, y, rho and delta; again with more delta where pivots had to be bent. */
static void sp__proximal_factor(sp__qp *w)
{
    for (int32_t raise = 0; raise <= SP__PROXIMAL_RAISES; raise++) {
        for (int32_t i = 0; i < w->qp.m; i++) {
            const sp_real W = sp__proximal_weight(w, i);
            w->kkt.row[i] = sp__qp_equation(&w->qp, i) ? 1 / w->ip.delta : W / (1 + w->ip.delta * W);
        }
        w->kkt.sigma = w->ip.rho;
        sp__kkt_factor(w);
        if (!w->kkt.broken || raise == SP__PROXIMAL_RAISES) return;
        w->ip.delta *= (sp_real)100;
        w->ip.least = w->ip.least < SP__PROXIMAL_MOST / 10 ? 10 * w->ip.least : SP__PROXIMAL_MOST;
    }
}

/* Newton's step for c: dx, dy in kkt.s, v. */
static void sp__proximal_direction(sp__qp *w)
{
    const int32_t n = w->qp.n, m = w->qp.m;
    sp_real *b = w->kkt.b, *v = w->ip.v;
    for (int32_t j = 0; j < n; j++) b[j] = -w->c * w->D[j] * (w->Px[j] + sp__qp_q(&w->qp, j) + w->Aty[j]);
    for (int32_t i = 0; i < m; i++) {
        const sp_real W = sp__proximal_weight(w, i);
        if (sp__qp_equation(&w->qp, i)) v[i] = w->E[i] * (w->qp.l[i] - w->Ax[i]);
        else v[i] = W > 0 ? -sp__proximal_target(w, i) / W : (sp_real)0;
        b[n + i] = v[i];
    }
    sp__kkt_solve(w, 1);
    for (int32_t i = 0; i < m; i++) {
        const sp_real W = sp__proximal_weight(w, i);
        if (W > 0) v[i] += w->kkt.s[n + i] / W;
    }
}

/* How far s_t and y_t may go to stay positive, at most 1. */
static sp__strides sp__proximal_reach(const sp__qp *w)
{
    sp__strides a = { 1, 1 };
    for (int32_t k = 0; k < 2 * w->qp.m; k++) {
        sp_real dy;
        if (!sp__side_there(w, k)) continue;
        const sp_real ds = sp__side_step(w, k, &dy);
        if (w->ip.s[k] + a.primal * ds < 0) a.primal = -w->ip.s[k] / ds;
        if (w->ip.y[k] + a.dual * dy < 0) a.dual = -w->ip.y[k] / dy;
    }
    return a;
}

/* mu, the mean of s_t y_t. */
static sp_real sp__proximal_mu(const sp__qp *w)
{
    sp_real sum = 0;
    for (int32_t k = 0; k < 2 * w->qp.m; k++) sum += w->ip.s[k] * w->ip.y[k];
    return w->ip.sides > 0 ? sum / (sp_real)w->ip.sides : (sp_real)0;
}

/* mu after a step. */
static sp_real sp__proximal_mu_after(const sp__qp *w, sp__strides a)
{
    sp_real sum = 0;
    for (int32_t k = 0; k < 2 * w->qp.m; k++) {
        sp_real dy;
        if (!sp__side_there(w, k)) continue;
        const sp_real ds = sp__side_step(w, k, &dy);
        sum += (w->ip.s[k] + a.primal * ds) * (w->ip.y[k] + a.dual * dy);
    }
    return sum / (sp_real)w->ip.sides;
}

/* c_t = -s_t y_t */
static void sp__proximal_predict(sp__qp *w)
{
    for (int32_t k = 0; k < 2 * w->qp.m; k++) w->ip.c[k] = -w->ip.s[k] * w->ip.y[k];
}

/* c_t = mu - s_t y_t - ds_t dy_t */
static void sp__proximal_correct(sp__qp *w, sp_real mu)
{
    for (int32_t k = 0; k < 2 * w->qp.m; k++) {
        sp_real dy;
        if (!sp__side_there(w, k)) continue;
        const sp_real ds = sp__side_step(w, k, &dy);
        w->ip.c[k] = mu - w->ip.s[k] * w->ip.y[k] - ds * dy;
    }
}

/* y of the rows with bounds from their y_t. */
static void sp__proximal_rows(sp__qp *w)
{
    for (int32_t i = 0; i < w->qp.m; i++)
        if (!sp__qp_equation(&w->qp, i)) w->y[i] = w->ip.y[w->qp.m + i] - w->ip.y[i];
}

static void sp__proximal_move(sp__qp *w, sp__strides a)
{
    const int32_t n = w->qp.n, m = w->qp.m;
    for (int32_t k = 0; k < 2 * m; k++) {
        sp_real dy;
        if (!sp__side_there(w, k)) continue;
        const sp_real ds = sp__side_step(w, k, &dy);
        w->ip.s[k] += a.primal * ds;
        w->ip.y[k] += a.dual * dy;
    }
    memcpy(w->xc, w->x, (size_t)n * sizeof *w->x);
    memcpy(w->yc, w->y, (size_t)m * sizeof *w->y);
    for (int32_t j = 0; j < n; j++) w->x[j] += a.primal * w->kkt.s[j];
    for (int32_t i = 0; i < m; i++) w->y[i] += a.dual * w->kkt.s[n + i];
    sp__proximal_rows(w);
}

/* ------------------------------------------------------------------------------------------------------------- the start */

/* s_t = 1 where there is a bound, and one spring of strength 1 for each row that has any: W = 1. */
static void sp__proximal_bounds(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    const int32_t m = qp->m;
    w->ip.sides = 0;
    for (int32_t i = 0; i < m; i++) {
        const int equation = sp__qp_equation(qp, i), l = !equation && !sp__qp_no_l(qp, i), u = !equation && !sp__qp_no_u(qp, i);
        w->ip.s[i] = w->ip.y[i] = (sp_real)l;
        w->ip.s[m + i] = (sp_real)u;
        w->ip.y[m + i] = (sp_real)(u && !l);
        w->ip.sides += l + u;
    }
}

/* x and y of least 1/2 x'Px + q'x + 1/2 |Ax - z|^2, z of [l, u] nearest to 0; s_t (in c) and y_t from these, whatever their
 * signs. */
static void sp__proximal_springs(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    const int32_t n = qp->n, m = qp->m;
    for (int32_t j = 0; j < n; j++) w->kkt.b[j] = -w->c * w->D[j] * sp__qp_q(qp, j);
    for (int32_t i = 0; i < m; i++) w->kkt.b[n + i] = sp__qp_clip(qp, i, 0, w->E[i]);
    sp__proximal_factor(w);
    sp__kkt_solve(w, 1);
    memcpy(w->x, w->kkt.s, (size_t)n * sizeof *w->x);
    memcpy(w->y, w->kkt.s + n, (size_t)m * sizeof *w->y);
    sp__qp_scale(w->X, w->D, w->x, n);
    sp__qp_A(qp, w->X, w->Ax, 0);
    for (int32_t k = 0; k < 2 * m; k++) {
        w->ip.c[k] = -sp__side_over(w, k);
        w->ip.y[k] = k < m ? -w->y[k] : w->y[k - m];
    }
}

/* s_t and y_t raised until they are positive, then to what makes them about equal.       [Mehrotra 1992, sec. 7; PIQP] */
static void sp__proximal_raise(sp__qp *w)
{
    sp_real s0 = 0, y0 = 0, s = 0, y = 0, product = 0;
    for (int32_t k = 0; k < 2 * w->qp.m; k++) {
        if (!sp__side_there(w, k)) { w->ip.c[k] = w->ip.y[k] = 0; continue; }
        s0 = sp__max(s0, (sp_real)-1.5 * w->ip.c[k]);
        y0 = sp__max(y0, (sp_real)-1.5 * w->ip.y[k]);
    }
    for (int32_t k = 0; k < 2 * w->qp.m; k++) {
        if (!sp__side_there(w, k)) continue;
        s += w->ip.c[k] + s0;
        y += w->ip.y[k] + y0;
        product += (w->ip.c[k] + s0) * (w->ip.y[k] + y0);
    }
    if (y > 0) s0 += product / (2 * y);
    if (s > 0) y0 += product / (2 * s);
    for (int32_t k = 0; k < 2 * w->qp.m; k++) {
        if (!sp__side_there(w, k)) continue;
        w->ip.s[k] = sp__max(w->ip.c[k] + s0, SP__PROXIMAL_LITTLE);
        w->ip.y[k] = sp__max(w->ip.y[k] + y0, SP__PROXIMAL_LITTLE);
    }
}

static void sp__proximal_start(sp__qp *w)
{
    w->ip.rho = (sp_real)1e-6;
    w->ip.delta = (sp_real)1e-4;
    w->ip.least = SP__PROXIMAL_DELTA;
    sp__proximal_bounds(w);
    sp__proximal_springs(w);
    sp__proximal_raise(w);
    sp__proximal_rows(w);
}

/* --------------------------------------------------------------------------------------------------------------- the run */

/* Flops of a step at most, and of a look. */
static int64_t sp__proximal_step_flops(const sp__qp *w)
{
    return (1 + SP__PROXIMAL_RAISES) * w->cost.factoring + 2 * sp__kkt_solve_flops(w, 1) + 4 * w->cost.products
         + 20 * w->cost.vectors;
}

/* One step of Mehrotra's. */
static void sp__proximal_step(sp__qp *w)
{
    const sp_real mu = sp__proximal_mu(w);
    sp__proximal_factor(w);
    sp__proximal_predict(w);
    sp__proximal_direction(w);
    sp__strides a = sp__proximal_reach(w);
    if (mu > 0) {
        const sp_real left = sp__proximal_mu_after(w, a) / mu;
        sp__proximal_correct(w, left * left * left * mu);
        sp__proximal_direction(w);
        a = sp__proximal_reach(w);
        a.primal *= SP__PROXIMAL_TAU;
        a.dual *= SP__PROXIMAL_TAU;
    }
    sp__proximal_move(w, a);
    const sp_real fall = mu > 0 ? sp__within(sp__proximal_mu(w) / mu, (sp_real)0.1, 1) : (sp_real)0.1;
    w->ip.rho = sp__max(fall * w->ip.rho, SP__PROXIMAL_RHO);
    w->ip.delta = sp__max(fall * w->ip.delta, w->ip.least);
    w->cost.flops += 16 * w->cost.vectors;
    w->ip.steps++;
}

/* The best point so far into x, y, z; judged. */
static void sp__proximal_recall(sp__qp *w)
{
    memcpy(w->x, w->ip.x, (size_t)w->qp.n * sizeof *w->x);
    memcpy(w->y, w->ip.Y, (size_t)w->qp.m * sizeof *w->y);
    sp__qp_unscale(w);
    sp__qp_residuals(w, NULL);
    for (int32_t i = 0; i < w->qp.m; i++) w->z[i] = w->E[i] * sp__qp_clip(&w->qp, i, w->Ax[i], 1);
}

/* Look at the iterate and keep it if it is the best. 1: the run is over, for better or worse; a solved one goes on, for
 * the last digits, as long as a step halves how far off it is. */
static int sp__proximal_look(sp__qp *w, sp_qp_result *out)
{
    if (w->ip.idle > 0 && sp__qp_proof_found(w, 0, out)) return 1;
    sp__qp_unscale(w);
    sp__qp_residuals(w, NULL);
    const sp_real off = w->residual.off, before = w->ip.best;
    w->ip.idle = off < (sp_real)0.9 * before ? 0 : w->ip.idle + 1;
    if (off < before) {
        memcpy(w->ip.x, w->x, (size_t)w->qp.n * sizeof *w->x);
        memcpy(w->ip.Y, w->y, (size_t)w->qp.m * sizeof *w->y);
        w->ip.best = off;
    }
    if (!(off < SP__NEVER) || w->ip.idle > SP__PROXIMAL_IDLE) return 1;
    return w->ip.best <= (sp_real)1 && (!w->set.polish || off > (sp_real)0.5 * before || off < SP__PROXIMAL_ENOUGH);
}

/* Is there a bound that is met but hardly pushes? Its s_t and y_t go to 0 as the square root of mu. */
static int sp__proximal_weak(const sp__qp *w)
{
    for (int32_t k = 0; k < 2 * w->qp.m; k++) {
        const sp_real s = w->ip.s[k], y = w->ip.y[k];
        if (sp__side_there(w, k) && s < SP__PROXIMAL_WEAK * y && y < SP__PROXIMAL_WEAK * s) return 1;
    }
    return 0;
}

/* After sp__proximal_run the best point is the result; what is not solved, or has few digits more than asked for, is for the
 * method of multipliers to better.     1: solved; 0: x, y, z are anything */
SP__NOINLINE static int sp__proximal_finish(sp__qp *w, sp_qp_result *out)
{
    const sp_real best = w->ip.best, most = best <= (sp_real)1 ? sp__max(best, SP__PROXIMAL_FEW) : (sp_real)1;
    if (!(best < SP__NEVER)) return 0;
    sp__proximal_recall(w);
    out->status = SP_QP_SOLVED;
    if (w->set.polish && (best > SP__PROXIMAL_FEW || sp__proximal_weak(w)) && sp__auglag_run(w, most)) return out->polished = 1;
    if (best <= (sp_real)1) sp__proximal_recall(w);
    return best <= (sp_real)1;
}

/* Interior points.     1: there is no solution, with a certificate; 0: there may be a best point */
SP__NOINLINE static int sp__proximal_run(sp__qp *w, sp_qp_result *out)
{
    const int64_t step = sp__proximal_step_flops(w);
    const int32_t left = w->set.iterations - w->iterations, most = left < SP__PROXIMAL_STEPS ? left : SP__PROXIMAL_STEPS;
    w->ip.turn = INT32_MAX;
    if (step > w->cost.limit - w->cost.flops) return 0;
    w->kkt.stale = 1;
    sp__proximal_start(w);
    while (!sp__proximal_look(w, out) && w->ip.steps < most && step <= w->cost.limit - w->cost.flops) sp__proximal_step(w);
    return out->radius > 0;
}

/* ------------------------------------------------------------------------------------------------------- their turn */

/* method: another than that of the settings, -1: that one */
static int sp__proximal_used(const sp_qp_settings *set, int method)
{
    return (method < 0 ? (int)set->method : method) != SP_QP_ADMM && sp__qp_backend(set) != SP_QP_CG;
}

static void sp__proximal_choose(sp__qp *w, int method)
{
    if (method >= 0) w->set.method = (sp_qp_method)method;
}

/* Its arrays; w NULL: only counts. */
static void sp__proximal_carve(sp__qp *w, const sp_qp *qp, sp_arena *a)
{
    const size_t n = (size_t)qp->n, m = (size_t)qp->m;
    sp_real *s = sp__take(a, 2 * m, sizeof *s), *y = sp__take(a, 2 * m, sizeof *y), *c = sp__take(a, 2 * m, sizeof *c);
    sp_real *v = sp__take(a, m, sizeof *v), *x = sp__take(a, n, sizeof *x), *Y = sp__take(a, m, sizeof *Y);
    if (!w) return;
    w->ip.s = s; w->ip.y = y; w->ip.c = c; w->ip.v = v; w->ip.x = x; w->ip.Y = Y;
}

/* A run begins: when is their turn? At once, or after some iterations of ADMM from a guess, which they can't use. */
static void sp__proximal_begin(sp__qp *w, int guess)
{
    w->ip.turn = !sp__proximal_used(&w->set, -1) ? INT32_MAX : guess && w->set.method == SP_QP_AUTO ? SP__PROXIMAL_AFTER : 0;
    w->ip.best = SP__NEVER;
    w->ip.idle = w->ip.steps = 0;
}

static int sp__proximal_due(const sp__qp *w) { return w->iterations >= w->ip.turn; }

/* ADMM is done, too, and has no answer: the better point of both. */
static void sp__proximal_prefer(sp__qp *w, sp_qp_result *out)
{
    if (out->status == SP_QP_SOLVED || out->radius > 0 || !(w->ip.best < w->residual.off)) return;
    sp__proximal_recall(w);
    if (w->ip.best <= (sp_real)10) out->status = SP_QP_INACCURATE;
}

static int32_t sp__proximal_steps(const sp__qp *w) { return w->ip.steps; }

#else

static int sp__proximal_run(sp__qp *w, sp_qp_result *out) { return (void)w, (void)out, 0; }
static int sp__proximal_finish(sp__qp *w, sp_qp_result *out) { return (void)w, (void)out, 0; }
static int sp__proximal_used(const sp_qp_settings *set, int method) { return (void)set, (void)method, 0; }
static void sp__proximal_choose(sp__qp *w, int method) { (void)w; (void)method; }
static void sp__proximal_carve(sp__qp *w, const sp_qp *qp, sp_arena *a) { (void)w; (void)qp; (void)a; }
static void sp__proximal_begin(sp__qp *w, int guess) { (void)w; (void)guess; }
static int sp__proximal_due(const sp__qp *w) { return (void)w, 0; }
static void sp__proximal_prefer(sp__qp *w, sp_qp_result *out) { (void)w; (void)out; }
static int32_t sp__proximal_steps(const sp__qp *w) { return (void)w, 0; }

#endif
#endif
#endif /* SP__PROXIMAL_C */
