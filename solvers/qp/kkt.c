/* kkt: the linear system of every iteration, three ways.
 *
 *     [ P + sigma I     A'     ] [ x~ ]   [ bx ]
 *     [      A      -1/rho_i   ] [ nu ] = [ bz ]      all scaled; b = (bx, bz), s = (x~, nu)                [OSQP, eq. 24]
 *
 * Sparse: as it stands, LDL'. The dense and the matrix-free back end eliminate nu = rho (A x~ - bz):
 *
 *     (P + sigma I + A' rho A) x~ = bx + A' rho bz                                                          [seed 4.2]
 *
 * SP_QP_NO_CG leaves the matrix-free one out.
 */
#ifndef SP__KKT_C
#define SP__KKT_C

#include "qp.c"

#ifndef SP_NO_QP

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

/* Diagonal entry j of cDPD: the last of its column, if there is one. */
static sp_real sp__kkt_diagonal(const sp__qp *w, int32_t j)
{
    const int32_t end = sp__qp_p0(&w->qp, j + 1);
    return end > sp__qp_p0(&w->qp, j) && w->qp.Pi[end - 1] == j ? w->c * w->D[j] * w->qp.Px[end - 1] * w->D[j] : (sp_real)0;
}

static void sp__kkt_factor_sparse(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) sp__ldl_diagonal(&w->ldl, j, sp__kkt_diagonal(w, j) + w->sigma);
    for (int32_t i = 0; i < w->qp.m; i++)
        sp__ldl_diagonal(&w->ldl, w->qp.n + i, w->row[i] > 0 ? (sp_real)-1 / w->row[i] : -SP__QP_FREE_ROW);
    sp__ldl_factor(&w->ldl);
    w->broken = w->ldl.bent;
}

/* ----------------------------------------------------------------------------------------------------------------- dense */

/* Row j of the lower triangle: P_jk + sum over rows i of rho_i a_ij a_ik, k <= j. */
static void sp__kkt_dense_row(sp__qp *w, int32_t j)
{
    const sp_qp *qp = &w->qp;
    sp_real *r = w->M + (size_t)j * ((size_t)j + 1) / 2, *s = w->s, *t = s + qp->n;
    for (int32_t i = 0; i < qp->m; i++) t[i] = 0;
    for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
        const int32_t i = qp->Ai[k];
        t[i] = w->row[i] * w->E[i] * w->E[i] * qp->Ax[k] * w->D[j];
    }
    sp__qp_At(qp, t, s);
    sp__qp_scale(r, s, w->D, j + 1);
    for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++)
        r[qp->Pi[k]] += w->c * w->D[qp->Pi[k]] * qp->Px[k] * w->D[j];
    r[j] += w->sigma;
}

static void sp__kkt_factor_dense(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) sp__kkt_dense_row(w, j);
    w->broken = sp__chol_factor(w->M, w->qp.n, 0);
}

/* ----------------------------------------------------------------------------------------------------------- matrix-free */
#ifndef SP_QP_NO_CG

static void sp__kkt_carve_cg(const sp_qp *qp, sp__cg *cg, sp_real **v, sp_real **Av, sp_arena *a)
{
    sp__cg_carve(cg, qp->n, a);
    *v = sp__take(a, (size_t)qp->n, sizeof **v);
    *Av = sp__take(a, (size_t)qp->m, sizeof **Av);
}

/* Preconditioner: 1 / diagonal. */
static void sp__kkt_factor_cg(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real d = sp__kkt_diagonal(w, j) + w->sigma;
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
            const sp_real a = w->E[qp->Ai[k]] * qp->Ax[k] * w->D[j];
            d += w->row[qp->Ai[k]] * a * a;
        }
        w->cg.inverse[j] = (sp_real)1 / d;
    }
    w->broken = 0;
}

/* out <- (P + sigma I + A' rho A) in, scaled. */
static void sp__kkt_apply(const void *what, const sp_real *in, sp_real *out)
{
    const sp__qp *w = what;
    const sp_qp *qp = &w->qp;
    for (int32_t j = 0; j < qp->n; j++) w->v[j] = w->D[j] * in[j];
    sp__qp_A(qp, w->v, w->Av, 0);
    for (int32_t i = 0; i < qp->m; i++) w->Av[i] *= w->row[i] * w->E[i] * w->E[i];
    sp__qp_P(qp, w->v, out, 0);
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real s = w->c * out[j];
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) s += qp->Ax[k] * w->Av[qp->Ai[k]];
        out[j] = w->D[j] * s + w->sigma * in[j];
    }
}

static int64_t sp__kkt_cg_step_flops(const sp__qp *w) { return w->products + 12 * (int64_t)w->qp.n; }

enum { SP__KKT_CG_LEAST = 4 };          /* steps that sp__kkt_solve_flops has counted */

/* s <- M^-1 b from the guess in s, as many steps as the budget allows. */
static void sp__kkt_cg(sp__qp *w, int32_t steps, sp_real tol)
{
    const int64_t each = sp__kkt_cg_step_flops(w), room = (w->limit - w->flops) / each + SP__KKT_CG_LEAST - 1;
    if (room < steps) steps = room > 0 ? (int32_t)room : 0;
    steps = sp__cg_solve(&w->cg, sp__kkt_apply, w, w->b, w->s, steps, tol);
    w->flops += ((steps < 0 ? -steps : steps + 1) - SP__KKT_CG_LEAST) * each;
}
#endif

/* ------------------------------------------------------------------------------------------------------------------ all */

/* Flops of a solve with `rounds` of refinement; matrix-free: the least that makes sense. */
static int64_t sp__kkt_solve_flops(const sp__qp *w, int32_t rounds)
{
    if (sp__qp_backend(&w->set) == SP_QP_SPARSE)
        return w->ldl.solve_flops + (w->broken ? 2 : rounds) * (w->ldl.solve_flops + 4 * (int64_t)w->ldl.entries);
#ifndef SP_QP_NO_CG
    if (sp__qp_backend(&w->set) == SP_QP_CG) return w->products + SP__KKT_CG_LEAST * sp__kkt_cg_step_flops(w);
#endif
    return w->products + 2 * (int64_t)w->qp.n * w->qp.n;
}

/* Factor for sigma and row. */
SP__NOINLINE_SMALL static void sp__kkt_factor(sp__qp *w)
{
    if (sp__qp_backend(&w->set) == SP_QP_SPARSE) sp__kkt_factor_sparse(w);
    else if (sp__qp_backend(&w->set) == SP_QP_DENSE) sp__kkt_factor_dense(w);
#ifndef SP_QP_NO_CG
    else sp__kkt_factor_cg(w);
#endif
    w->flops += w->factoring;
    w->factorisations++;
}

/* bx <- bx + A' rho bz, solve for x~ in s, nu = rho (A x~ - bz); in Aty: A' rho bz. */
static void sp__kkt_solve_eliminated(sp__qp *w, int exact)
{
    const sp_qp *qp = &w->qp;
    sp_real *b = w->b, *s = w->s, *bz = b + qp->n, *nu = s + qp->n;
    sp__qp_scale(nu, w->E, w->row, qp->m);
    sp__qp_scale(nu, nu, bz, qp->m);
    sp__qp_At(qp, nu, w->Aty);
    for (int32_t j = 0; j < qp->n; j++) {
        b[j] += w->D[j] * w->Aty[j];
        if (sp__qp_backend(&w->set) == SP_QP_DENSE) s[j] = b[j];
        else if (exact) s[j] = 0;
    }
    if (sp__qp_backend(&w->set) == SP_QP_DENSE) sp__chol_solve(w->M, qp->n, s);
#ifndef SP_QP_NO_CG
    else sp__kkt_cg(w, w->set.cg_steps, exact ? (sp_real)8 * SP_EPSILON : w->set.cg_tol);
#endif
    sp__qp_scale(b, w->D, s, qp->n);                    /* bx is spent */
    sp__qp_A(qp, b, nu, 0);
    for (int32_t i = 0; i < qp->m; i++) nu[i] = w->row[i] * (w->E[i] * nu[i] - bz[i]);
}

/* s <- KKT^-1 b; b is spent. rounds: of refinement, > 0 where the last digit counts. */
static void sp__kkt_solve(sp__qp *w, int32_t rounds)
{
    w->flops += sp__kkt_solve_flops(w, rounds);
    if (sp__qp_backend(&w->set) == SP_QP_SPARSE) sp__ldl_solve(&w->ldl, w->b, w->s, w->broken ? 2 : rounds);
    else sp__kkt_solve_eliminated(w, rounds > 0);
}

#endif /* SP_NO_QP */

#endif /* SP__KKT_C */
