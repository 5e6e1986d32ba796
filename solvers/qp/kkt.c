/* kkt: the linear system of every iteration, three ways.
 *
 *     [ P + sigma I     A'     ] [ x~ ]   [ bx ]
 *     [      A      -1/rho_i   ] [ nu ] = [ bz ]      all scaled; b = (bx, bz), s = (x~, nu)                [OSQP, eq. 24]
 *
 * Sparse: as it stands, LDL'. The dense and the matrix-free back end eliminate nu = rho (A x~ - bz):
 *
 *     (P + sigma I + A' rho A) x~ = bx + A' rho bz                                                          [seed 4.2]
 */
#ifndef SP__KKT_C
#define SP__KKT_C

#include "kkt_cg.c"

#if SP__WITH_QP

/* ---------------------------------------------------------------------------------------------------------------- sparse */

/* The KKT matrix off its diagonal, scaled. */
static void sp__kkt_walk(const void *what, sp__entry take, void *to)
{
    const sp__qp *w = what;
    const sp_qp *qp = &w->qp;
    for (int32_t j = 0; j < qp->n; j++) {
        for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++) {
            const int32_t i = qp->Pi[k];
            if (i < j) take(to, i, j, w->c * w->D[i] * qp->Px[k] * w->D[j]);
        }
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++)
            take(to, j, qp->n + qp->Ai[k], w->E[qp->Ai[k]] * qp->Ax[k] * w->D[j]);
    }
}

static void sp__kkt_factor_sparse(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) sp__ldl_diagonal(&w->kkt.ldl, j, sp__qp_diagonal(w, j) + w->kkt.sigma);
    for (int32_t i = 0; i < w->qp.m; i++)
        sp__ldl_diagonal(&w->kkt.ldl, w->qp.n + i, w->kkt.row[i] > 0 ? (sp_real)-1 / w->kkt.row[i] : -SP__QP_FREE_ROW);
    sp__ldl_factor(&w->kkt.ldl);
    w->kkt.broken = w->kkt.ldl.bent;
}

/* ----------------------------------------------------------------------------------------------------------------- dense */

/* Row j of the lower triangle: P_jk + sum over rows i of rho_i a_ij a_ik, k <= j. */
static void sp__kkt_dense_row(sp__qp *w, int32_t j)
{
    const sp_qp *qp = &w->qp;
    sp_real *r = w->kkt.M + (size_t)j * ((size_t)j + 1) / 2, *s = w->kkt.s, *t = s + qp->n;
    for (int32_t i = 0; i < qp->m; i++) t[i] = 0;
    for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
        const int32_t i = qp->Ai[k];
        t[i] = w->kkt.row[i] * w->E[i] * w->E[i] * qp->Ax[k] * w->D[j];
    }
    sp__qp_At(qp, t, s);
    sp__qp_scale(r, s, w->D, j + 1);
    for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++)
        r[qp->Pi[k]] += w->c * w->D[qp->Pi[k]] * qp->Px[k] * w->D[j];
    r[j] += w->kkt.sigma;
}

static void sp__kkt_factor_dense(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) sp__kkt_dense_row(w, j);
    w->kkt.broken = sp__chol_factor(w->kkt.M, w->qp.n, 0);
}

/* ------------------------------------------------------------------------------------------------------------------ all */

/* Flops of a solve with `rounds` of refinement; matrix-free: the least that makes sense. */
static int64_t sp__kkt_solve_flops(const sp__qp *w, int32_t rounds)
{
    if (sp__qp_backend(&w->set) == SP_QP_SPARSE)
        return w->kkt.ldl.solve_flops
             + (w->kkt.broken ? 2 : rounds) * (w->kkt.ldl.solve_flops + 4 * (int64_t)w->kkt.ldl.entries);
    if (SP__WITH_QP_CG && sp__qp_backend(&w->set) == SP_QP_CG)
        return w->cost.products + SP__KKT_CG_LEAST * sp__kkt_cg_step_flops(w);
    return w->cost.products + 2 * (int64_t)w->qp.n * w->qp.n;
}

/* Factor for sigma and row. */
SP__NOINLINE_SMALL static void sp__kkt_factor(sp__qp *w)
{
    if (sp__qp_backend(&w->set) == SP_QP_SPARSE) sp__kkt_factor_sparse(w);
    else if (sp__qp_backend(&w->set) == SP_QP_DENSE) sp__kkt_factor_dense(w);
    else sp__kkt_factor_cg(w);
    w->cost.flops += w->cost.factoring;
    w->factorisations++;
}

/* bx <- bx + A' rho bz, solve for x~ in s, nu = rho (A x~ - bz); in Aty: A' rho bz. */
static void sp__kkt_solve_eliminated(sp__qp *w, int exact)
{
    const sp_qp *qp = &w->qp;
    sp_real *b = w->kkt.b, *s = w->kkt.s, *bz = b + qp->n, *nu = s + qp->n;
    sp__qp_scale(nu, w->E, w->kkt.row, qp->m);
    sp__qp_scale(nu, nu, bz, qp->m);
    sp__qp_At(qp, nu, w->Aty);
    for (int32_t j = 0; j < qp->n; j++) {
        b[j] += w->D[j] * w->Aty[j];
        if (sp__qp_backend(&w->set) == SP_QP_DENSE) s[j] = b[j];
        else if (exact) s[j] = 0;
    }
    if (sp__qp_backend(&w->set) == SP_QP_DENSE) sp__chol_solve(w->kkt.M, qp->n, s);
    else sp__kkt_cg(w, w->set.cg_steps, exact ? (sp_real)8 * SP_EPSILON : w->set.cg_tol);
    sp__qp_scale(b, w->D, s, qp->n);                    /* bx is spent */
    sp__qp_A(qp, b, nu, 0);
    for (int32_t i = 0; i < qp->m; i++) nu[i] = w->kkt.row[i] * (w->E[i] * nu[i] - bz[i]);
}

/* s <- KKT^-1 b; b is spent. rounds: of refinement, > 0 where the last digit counts. */
static void sp__kkt_solve(sp__qp *w, int32_t rounds)
{
    w->cost.flops += sp__kkt_solve_flops(w, rounds);
    if (sp__qp_backend(&w->set) == SP_QP_SPARSE) sp__ldl_solve(&w->kkt.ldl, w->kkt.b, w->kkt.s, w->kkt.broken ? 2 : rounds);
    else sp__kkt_solve_eliminated(w, rounds > 0);
}

#endif
#endif /* SP__KKT_C */
