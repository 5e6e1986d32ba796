/* sharpen: from a vector near a certificate of infeasibility to one that proves more, with the KKT factor at hand
 *
 * Two projections by the proximal point method: of y onto A'y = 0, of x onto Px = 0, Ax = 0 in the rows that must not move.
 * Without polish (SP_QP_NO_POLISH, SP_SMALL) vectors stay as they are.
 */
#ifndef SP__SHARPEN_C
#define SP__SHARPEN_C

#include "kkt.c"

#if SP__WITH_QP
#if SP__WITH_QP_POLISH

/* Regularisation where an exact answer is wanted and refined. */
#ifdef SP_REAL_FLOAT
#define SP__QP_DELTA ((sp_real)1e-3)
#else
#define SP__QP_DELTA ((sp_real)1e-6)
#endif

/* Y (unscaled) <- the nearest vector with A_S'y = 0, S its rows that count: from y near a certificate one that proves more.
 *
 *     [ delta I  A_S' ] [ -t ]   [  0 ]
 *     [ A_S       -I  ] [ y' ] = [ -y ]       y' = (I + A_S A_S' / delta)^-1 y, some times
 *
 * P is taken out of the KKT matrix by c = 0. */
SP__NOINLINE static void sp__sharpen_y(sp__qp *w)
{
    const int32_t n = w->qp.n, m = w->qp.m;
    const sp_real c = w->c;
    for (int32_t i = 0; i < m; i++) w->Y[i] /= w->E[i];
    const sp_real little = (sp_real)1e-3 * sp__largest(w->Y, m);
    w->c = 0;
    w->kkt.sigma = SP__QP_DELTA;
    for (int32_t i = 0; i < m; i++) {
        w->kkt.row[i] = sp__abs(w->Y[i]) > little ? (sp_real)1 : (sp_real)0;
        w->Y[i] *= w->kkt.row[i];
    }
    if (w->set.backend == SP_QP_SPARSE) sp__ldl_values(&w->kkt.ldl, sp__kkt_walk, w);
    sp__kkt_factor(w);
    for (int round = 0; round < 4; round++) {
        for (int32_t j = 0; j < n; j++) w->kkt.b[j] = 0;
        for (int32_t i = 0; i < m; i++) w->kkt.b[n + i] = -w->Y[i];
        sp__kkt_solve(w, 1);
        for (int32_t i = 0; i < m; i++) w->Y[i] = w->kkt.row[i] > 0 ? w->kkt.s[n + i] : (sp_real)0;
    }
    for (int32_t i = 0; i < m; i++) w->Y[i] *= w->E[i];
    w->c = c;
    if (w->set.backend == SP_QP_SPARSE) sp__ldl_values(&w->kkt.ldl, sp__kkt_walk, w);
    w->kkt.stale = 1;
}

/* X (unscaled) <- the nearest vector with PX = 0 and A_T X = 0, T the rows that must not move: the proximal point method on
 * 1/2 x'Px + |A_T x|^2 / (2 delta). */
SP__NOINLINE static void sp__sharpen_x(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    sp__qp_A(qp, w->X, w->Ax, 0);
    for (int32_t i = 0; i < qp->m; i++) w->Ax[i] *= w->E[i];
    const sp_real little = (sp_real)1e-3 * sp__largest(w->Ax, qp->m);
    w->kkt.sigma = SP__QP_DELTA;
    for (int32_t i = 0; i < qp->m; i++) {
        const int stays = (!sp__qp_no_u(qp, i) && w->Ax[i] > -little) || (!sp__qp_no_l(qp, i) && w->Ax[i] < little);
        w->kkt.row[i] = stays ? (sp_real)1 / w->kkt.sigma : (sp_real)0;
    }
    sp__kkt_factor(w);
    for (int32_t j = 0; j < qp->n; j++) w->X[j] /= w->D[j];
    for (int round = 0; round < 4; round++) {
        for (int32_t j = 0; j < qp->n; j++) w->kkt.b[j] = w->kkt.sigma * w->X[j];
        for (int32_t i = 0; i < qp->m; i++) w->kkt.b[qp->n + i] = 0;
        sp__kkt_solve(w, 1);
        for (int32_t j = 0; j < qp->n; j++) w->X[j] = w->kkt.s[j];
    }
    for (int32_t j = 0; j < qp->n; j++) w->X[j] *= w->D[j];
    w->kkt.stale = 1;
}

#else

static void sp__sharpen_y(sp__qp *w) { (void)w; }
static void sp__sharpen_x(sp__qp *w) { (void)w; }

#endif
#endif
#endif /* SP__SHARPEN_C */
