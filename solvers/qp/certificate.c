/* certificate: proofs that a quadratic program has no solution, judged on the data as given.
 *
 * y with A'y = 0 and u'y+ + l'y- < 0 proves that nothing is feasible, for y'Ax <= u'y+ + l'y- wherever l <= Ax <= u [OSQP,
 * 3.4]. Numbers leave a rest r = A'y; then any feasible x has
 *
 *     |r|_D |x / D|_1 >= r'x >= ... >= -(u'y+ + l'y-),       |r|_D = max_j D_j |r_j|
 *
 * so what is proved is that there is none with |x / D|_1 below radius = -(u'y+ + l'y-) / |r|_D. A claim asks for a radius far
 * beyond the iterate: a feasible set of one point has radius <= |x / D|_1 and can't be taken for none. The mirror image for x:
 * Px = 0, q'x < 0 and Ax in the recession cone of [l, u], but for rests, rules out all (x*, y*) with Px* + q + A'y* = 0 and
 * |x* / D|_1 + |c y* / E|_1 below -q'x / max(D|Px|, E|rest|).                                      [Banjac, sec. 3]
 *
 * Banjac, Goulart, Stellato, Boyd 2019, J. Optim. Theory Appl. 183 [Banjac]; [seed 4.3].
 */
#ifndef SP__PROOF_C
#define SP__PROOF_C

#include "sharpen.c"

#if SP__WITH_QP

/* r_j = |A'y|_j and what rounding may have hidden in it, times D_j: the largest. */
static sp_real sp__qp_proof_residual(const sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    sp_real worst = 0;
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real size;
        const sp_real r = sp__qp_column(qp, w->Y, j, &size);
        worst = sp__max(worst, w->D[j] * (sp__abs(r) + (sp_real)4 * SP_EPSILON * size));
    }
    return worst;
}

/* Radius of a proof: `down` less its own rounding, over the rest; 0 if it proves nothing. */
SP__NOINLINE static sp_real sp__qp_proof_radius(sp_real down, sp_real terms, int32_t count, sp_real rest)
{
    down -= (sp_real)(count + 4) * SP_EPSILON * terms;
    if (!(down > 0) || !(rest >= 0)) return 0;
    return down < rest * SP__NEVER ? down / rest : SP__NEVER;
}

/* Y judged as a certificate of primal infeasibility. Multipliers of bounds that are not there are dropped first. */
static sp_real sp__qp_proof_primal(sp__qp *w)
{
    sp_real terms;
    for (int32_t i = 0; i < w->qp.m; i++)
        if (sp__qp_no_bound(&w->qp, i, w->Y[i])) w->Y[i] = 0;
    const sp_real down = -sp__qp_support(&w->qp, w->Y, &terms);
    w->cost.flops += w->cost.products + w->cost.vectors;
    return down > 0 ? sp__qp_proof_radius(down, terms, w->qp.m, sp__qp_proof_residual(w)) : (sp_real)0;
}

/* X judged as a certificate of dual infeasibility. */
static sp_real sp__qp_proof_dual(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    sp_real down = 0, terms = 0, rest = 0;
    for (int32_t j = 0; j < qp->n; j++) {
        const sp_real t = sp__qp_q(qp, j) * w->X[j];
        down -= t;
        terms += sp__abs(t);
    }
    w->cost.flops += w->cost.products + w->cost.vectors;
    if (!(down > 0)) return 0;
    sp__qp_P(qp, w->X, w->Px, 0);
    sp__qp_A(qp, w->X, w->Ax, 0);
    for (int32_t j = 0; j < qp->n; j++) rest = sp__max(rest, w->D[j] * sp__abs(w->Px[j]));
    for (int32_t i = 0; i < qp->m; i++)
        if (!sp__qp_no_bound(qp, i, w->Ax[i])) rest = sp__max(rest, sp__abs(w->Ax[i]) * w->E[i] / w->c);
    return sp__qp_proof_radius(down, terms, qp->n, rest);
}

/* How large solutions must be to be believed away: a multiple of the iterate (of y for the mirror image: x runs away there). */
static sp_real sp__qp_proof_goal(const sp_real *v, int32_t n, sp_real radius)
{
    sp_real s = (sp_real)1;
    for (int32_t k = 0; k < n; k++) s += sp__abs(v[k]);
    return s * radius;
}

/* Make v the certificate's direction: largest 1. 0 if it is nothing. */
static int sp__qp_proof_direction(sp_real *v, int32_t n)
{
    const sp_real size = sp__largest(v, n);
    if (!(size > 0) || !sp__finite(size)) return 0;
    for (int32_t k = 0; k < n; k++) v[k] /= size;
    return 1;
}

static sp_real sp__qp_proof_measure(sp__qp *w, int primal) { return primal ? sp__qp_proof_primal(w) : sp__qp_proof_dual(w); }

/* A certificate in v (Y: primal, X: dual infeasible), from the change since the last look or, `hard`, from that sharpened.
 * Its radius if it counts, else 0. */
SP__NOINLINE static sp_real sp__qp_proof_try(sp__qp *w, int primal, int hard)
{
    const int32_t n = w->qp.n, m = w->qp.m, size = primal ? m : n;
    const sp_real *to = primal ? w->y : w->x, *from = primal ? w->yc : w->xc;
    sp_real *v = primal ? w->Y : w->X;
    for (int32_t k = 0; k < size; k++) v[k] = to[k] - from[k];
    sp__qp_scale(v, primal ? w->E : w->D, v, size);
    if (!sp__qp_proof_direction(v, size)) return 0;
    const sp_real multiple = primal ? sp__qp_proof_goal(w->x, n, w->set.radius) : sp__qp_proof_goal(w->y, m, w->set.radius);
    const sp_real least = sp__max(multiple, (sp_real)1 / (primal ? w->set.eps_pinf : w->set.eps_dinf));
    sp_real radius = sp__qp_proof_measure(w, primal);
    if (SP__WITH_QP_POLISH && hard && radius > (sp_real)1 && !(radius > least)) {
        if (primal) sp__sharpen_y(w);
        else sp__sharpen_x(w);
        radius = sp__qp_proof_direction(v, size) ? sp__qp_proof_measure(w, primal) : (sp_real)0;
    }
    return radius > least ? radius : (sp_real)0;
}

/* Is the problem infeasible? Then 1 with status and radius, the certificate in Y or X. */
static int sp__qp_proof_found(sp__qp *w, int hard, sp_qp_result *out)
{
    for (int primal = 1; primal >= 0; primal--) {
        out->status = primal ? SP_QP_PRIMAL_INFEASIBLE : SP_QP_DUAL_INFEASIBLE;
        out->radius = sp__qp_proof_try(w, primal, hard);
        if (out->radius > 0) return 1;
    }
    return 0;
}

#endif
#endif /* SP__PROOF_C */
