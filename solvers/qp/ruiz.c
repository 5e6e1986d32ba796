/* ruiz: scales of a quadratic program that bring every row and column of its KKT matrix near 1.   [Ruiz 2001; OSQP, sec. 5.1]
 *
 *     [ P  A' ]        [ D     ] [ cP  A' ] [ D     ]
 *     [ A  0  ]   ->   [     E ] [ A   0  ] [     E ]        P <- c DPD,  q <- c Dq,  A <- EAD,  l, u <- El, Eu
 *
 * Each pass divides by the square roots of the largest entries; c brings the mean column of P, or q, to 1. P, A and q stay as
 * they are, only D, E and c are found: x = D x', y = E y' / c.
 */
#ifndef SP__RUIZ_C
#define SP__RUIZ_C

#include "../base/real.c"

#if SP__WITH_QP

/* Start of column j of P and of A; a matrix may be left out. */
static int32_t sp__qp_p0(const sp_qp *qp, int32_t j) { return qp->Pp ? qp->Pp[j] : 0; }
static int32_t sp__qp_a0(const sp_qp *qp, int32_t j) { return qp->m ? qp->Ap[j] : 0; }

/* col[j]: largest |entry| of the columns of cDPD. */
static void sp__ruiz_norms_P(const sp_qp *qp, const sp_real *D, sp_real c, sp_real *col)
{
    for (int32_t j = 0; j < qp->n; j++) {
        col[j] = 0;
        for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++) {
            const int32_t i = qp->Pi[k];
            const sp_real a = sp__abs(qp->Px[k]) * c * D[i] * D[j];
            col[i] = sp__max(col[i], a);                /* i <= j: set before */
            col[j] = sp__max(col[j], a);
        }
    }
}

/* col[j], row[i]: those of [cDPD; EAD], and of the rows of EAD. */
static void sp__ruiz_norms(const sp_qp *qp, const sp_real *D, const sp_real *E, sp_real c, sp_real *col, sp_real *row)
{
    sp__ruiz_norms_P(qp, D, c, col);
    for (int32_t i = 0; i < qp->m; i++) row[i] = 0;
    for (int32_t j = 0; j < qp->n; j++)
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
            const int32_t i = qp->Ai[k];
            const sp_real a = sp__abs(qp->Ax[k]) * E[i] * D[j];
            row[i] = sp__max(row[i], a);
            col[j] = sp__max(col[j], a);
        }
}

/* Factor for c: 1 / max(mean column norm of cDPD, |cDq|), 1 where both are nothing. */
static sp_real sp__ruiz_cost(const sp_qp *qp, const sp_real *D, sp_real c, sp_real *col)
{
    sp_real mean = 0, q = 0;
    sp__ruiz_norms_P(qp, D, c, col);
    for (int32_t j = 0; j < qp->n; j++) {
        if (qp->q) q = sp__max(q, c * D[j] * sp__abs(qp->q[j]));
        mean += col[j] / (sp_real)qp->n;
    }
    const sp_real size = sp__max(mean, q);
    return size > 0 ? (sp_real)1 / size : (sp_real)1;
}

/* scale <- scale / sqrt(norm), where there is a norm. */
static void sp__ruiz_divide(sp_real *scale, const sp_real *norm, int32_t n)
{
    for (int32_t k = 0; k < n; k++)
        if (norm[k] > 0) scale[k] /= SP_SQRT(norm[k]);
}

/* Returns c; col and row are n and m numbers of scratch. */
SP__NOINLINE static sp_real sp__ruiz(const sp_qp *qp, int32_t passes, sp_real *D, sp_real *E, sp_real *col, sp_real *row)
{
    sp_real c = (sp_real)1;
    for (int32_t j = 0; j < qp->n; j++) D[j] = (sp_real)1;
    for (int32_t i = 0; i < qp->m; i++) E[i] = (sp_real)1;
    for (int32_t pass = 0; pass < passes; pass++) {
        sp__ruiz_norms(qp, D, E, c, col, row);
        sp__ruiz_divide(D, col, qp->n);
        sp__ruiz_divide(E, row, qp->m);
        c *= sp__ruiz_cost(qp, D, c, col);
    }
    return c;
}

#endif
#endif /* SP__RUIZ_C */
