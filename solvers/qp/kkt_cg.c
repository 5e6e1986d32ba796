/* kkt_cg: the matrix-free back end, conjugate gradients on the eliminated KKT system                                 [seed 4.2]
 *
 *     (P + sigma I + A' rho A) x~ = bx + A' rho bz        all scaled; no matrix is formed, memory 6 n + m numbers
 *
 * Without it (SP_QP_NO_CG, SP_SMALL) nothing below does anything: settings that ask for it are refused,
 * or taken for dense ones.
 */
#ifndef SP__KKT_CG_C
#define SP__KKT_CG_C

#include "qp.c"

#if SP__WITH_QP
#if SP__WITH_QP_CG

/* Its vectors in the arena; w, if not NULL, keeps where they are. */
static void sp__kkt_carve_cg(const sp_qp *qp, sp__qp *w, sp_arena *a)
{
    sp__cg cg;
    sp__cg_carve(&cg, qp->n, a);
    sp_real *v = sp__take(a, (size_t)qp->n, sizeof *v), *Av = sp__take(a, (size_t)qp->m, sizeof *Av);
    if (!w) return;
    w->kkt.cg = cg;
    w->kkt.v = v;
    w->kkt.Av = Av;
}

/* Preconditioner: 1 / diagonal. */
static void sp__kkt_factor_cg(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real d = sp__qp_diagonal(w, j) + w->kkt.sigma;
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
            const sp_real a = w->E[qp->Ai[k]] * qp->Ax[k] * w->D[j];
            d += w->kkt.row[qp->Ai[k]] * a * a;
        }
        w->kkt.cg.inverse[j] = (sp_real)1 / d;
    }
    w->kkt.broken = 0;
}

/* out <- (P + sigma I + A' rho A) in, scaled. */
static void sp__kkt_apply(const void *what, const sp_real *in, sp_real *out)
{
    const sp__qp *w = what;
    const sp_qp *qp = &w->qp;
    for (int32_t j = 0; j < qp->n; j++) w->kkt.v[j] = w->D[j] * in[j];
    sp__qp_A(qp, w->kkt.v, w->kkt.Av, 0);
    for (int32_t i = 0; i < qp->m; i++) w->kkt.Av[i] *= w->kkt.row[i] * w->E[i] * w->E[i];
    sp__qp_P(qp, w->kkt.v, out, 0);
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real s = w->c * out[j];
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) s += qp->Ax[k] * w->kkt.Av[qp->Ai[k]];
        out[j] = w->D[j] * s + w->kkt.sigma * in[j];
    }
}

static int64_t sp__kkt_cg_step_flops(const sp__qp *w) { return w->cost.products + 12 * (int64_t)w->qp.n; }

enum { SP__KKT_CG_LEAST = 4 };          /* steps that sp__kkt_solve_flops has counted */

/* s <- M^-1 b from the guess in s, as many steps as the budget allows. */
static void sp__kkt_cg(sp__qp *w, int32_t steps, sp_real tol)
{
    const int64_t each = sp__kkt_cg_step_flops(w), room = (w->cost.limit - w->cost.flops) / each + SP__KKT_CG_LEAST - 1;
    if (room < steps) steps = room > 0 ? (int32_t)room : 0;
    steps = sp__cg_solve(&w->kkt.cg, sp__kkt_apply, w, w->kkt.b, w->kkt.s, steps, tol);
    w->cost.flops += ((steps < 0 ? -steps : steps + 1) - SP__KKT_CG_LEAST) * each;
}

/* P_jj >= 0 and P_ij^2 <= P_ii P_jj, scaled and up to rounding; in d (n) the roots of the diagonal. */
static int sp__kkt_cg_minors(const sp__qp *w, sp_real *d)
{
    const sp_qp *qp = &w->qp;
    for (int32_t j = 0; j < qp->n; j++) d[j] = sp__qp_diagonal(w, j);
    const sp_real slack = (sp_real)64 * SP_EPSILON * sp__largest(d, qp->n);
    for (int32_t j = 0; j < qp->n; j++) {
        if (d[j] < -slack) return 0;
        d[j] = SP_SQRT(sp__max(d[j], 0));
        for (int32_t k = qp->Pp[j]; k < qp->Pp[j + 1]; k++) {
            const int32_t i = qp->Pi[k];
            if (i < j && w->c * w->D[i] * sp__abs(qp->Px[k]) * w->D[j] > d[i] * d[j] * (sp_real)1.00001 + slack) return 0;
        }
    }
    return 1;
}

/* Conjugate gradients from a right-hand side without pattern meet a direction of negative curvature, if there is one, within n
 * steps, were it not for rounding. 1: none was met. */
static int sp__kkt_cg_no_descent(sp__qp *w)
{
    uint32_t seed = 1;
    for (int32_t j = 0; j < w->qp.n; j++) {
        seed = seed * 1664525u + 1013904223u;
        w->kkt.b[j] = (sp_real)(int32_t)(seed >> 16) / (sp_real)32768 - (sp_real)1;
        w->kkt.s[j] = 0;
    }
    return sp__cg_solve(&w->kkt.cg, sp__kkt_apply, w, w->kkt.b, w->kkt.s, w->qp.n, (sp_real)4 * SP_EPSILON) >= 0;
}

static int sp__kkt_cg_semidefinite(sp__qp *w) { return sp__kkt_cg_minors(w, w->kkt.b) && sp__kkt_cg_no_descent(w); }

#else

enum { SP__KKT_CG_LEAST = 0 };

static void sp__kkt_carve_cg(const sp_qp *qp, sp__qp *w, sp_arena *a) { (void)qp; (void)w; (void)a; }
static void sp__kkt_factor_cg(sp__qp *w) { (void)w; }
static int64_t sp__kkt_cg_step_flops(const sp__qp *w) { return (void)w, 0; }
static void sp__kkt_cg(sp__qp *w, int32_t steps, sp_real tol) { (void)w; (void)steps; (void)tol; }
static int sp__kkt_cg_semidefinite(sp__qp *w) { return (void)w, 0; }

#endif
#endif
#endif /* SP__KKT_CG_C */
