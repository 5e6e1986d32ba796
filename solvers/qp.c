/* qp: a quadratic program, a point of it, and how good that point is on the data as given.
 *
 *     min 1/2 x'Px + q'x   subject to   Ax = z,  l <= z <= u
 *
 *   paper [OSQP]                code            shape
 *   x, z, y; x~, nu             x z y; s        n, m, m; n + m together: what the linear system gives
 *   P q A l u                   qp              n x n, n, m x n, m, m; as given, never copied
 *   D, E, c                     D E c           scales: the iteration runs on cDPD, cDq, EAD, El, Eu, multiplied on the fly
 *   sigma, rho_i; alpha         sigma row; relax
 *   X, Y                        X Y             n, m: a point in the units of the data; everything is judged there
 *
 * Stellato, Banjac, Goulart, Bemporad, Boyd 2020, "OSQP", Math. Programming Computation 12 [OSQP].
 */
#ifndef SP__QP_C
#define SP__QP_C

#ifndef SP_NO_QP

#include "ldl.c"
#include "chol.c"
#ifndef SP_QP_NO_CG
#include "cg.c"
#endif
#include "ruiz.c"

#define SP__QP_RHO_LEAST ((sp_real)1e-6)                /* clamps of rho                                        [seed 4.2] */
#define SP__QP_RHO_MOST  ((sp_real)1e6)
#define SP__QP_FREE_ROW  ((sp_real)1e20)                /* 1 / rho of a row that shall not matter */

struct sp_qp_work {
    sp_qp qp;
    sp_qp_settings set;
    sp_real c, rho, sigma;
    sp_real *D, *E, *row;               /* row: rho of each row */
    sp_real *x, *z, *y, *xc, *yc;       /* iterate; xc, yc: at the look before this one */
    sp_real *b, *s;                     /* n + m: right-hand side and solution of the linear system */
    sp_real *X, *Y, *Px, *Aty, *Ax;     /* a point and its products, in the units of the data */
    signed char *side;                  /* m, polish: the row is outside its bounds */
    sp__ldl ldl;
    sp_real *M;                         /* dense: lower triangle by rows */
#ifndef SP_QP_NO_CG
    sp__cg cg;
    sp_real *v, *Av;                    /* cg: n, m */
#endif
    int32_t stale;                      /* the factor is not that of rho */
    int32_t factorisations, iterations, changes, broken;
    int64_t flops, products, limit;     /* products: flops of P x, A x and A'y together; limit: where flops must end */
    sp_real primal, dual, gap, objective, off;  /* of X, Y; off: largest residual relative to its tolerance */
    sp_real rel_primal, rel_dual;       /* scaled residuals relative to their terms */
};
typedef struct sp_qp_work sp__qp;

static int sp__qp_no_l(const sp_qp *qp, int32_t i) { return !(qp->l[i] > -SP_QP_INFINITY); }
static int sp__qp_no_u(const sp_qp *qp, int32_t i) { return !(qp->u[i] < SP_QP_INFINITY); }
static int sp__qp_equation(const sp_qp *qp, int32_t i) { return !(qp->l[i] < qp->u[i]); }
static sp_real sp__qp_q(const sp_qp *qp, int32_t j) { return qp->q ? qp->q[j] : (sp_real)0; }
static sp_real sp__within(sp_real x, sp_real low, sp_real high) { return x < low ? low : x > high ? high : x; }

static sp_real sp__largest(const sp_real *x, int32_t n)
{
    sp_real most = 0;
    for (int32_t i = 0; i < n; i++)
        if (!(sp__abs(x[i]) <= most)) most = sp__abs(x[i]);                 /* a NaN goes through */
    return most;
}

/* v onto [l_i, u_i]. */
static sp_real sp__qp_clip(const sp_qp *qp, int32_t i, sp_real v)
{
    if (v < qp->l[i] && !sp__qp_no_l(qp, i)) return qp->l[i];
    if (v > qp->u[i] && !sp__qp_no_u(qp, i)) return qp->u[i];
    return v;
}

/* u'y+ + l'y-, the support function of [l, u] at y; *terms: sum of |terms|. A multiplier of a bound that is not there counts 0:
 * callers make sure there is none. */
static sp_real sp__qp_support(const sp_qp *qp, const sp_real *y, sp_real *terms)
{
    sp_real s = 0;
    *terms = 0;
    for (int32_t i = 0; i < qp->m; i++) {
        const sp_real t = y[i] > 0 ? (sp__qp_no_u(qp, i) ? (sp_real)0 : qp->u[i] * y[i])
                                   : (sp__qp_no_l(qp, i) ? (sp_real)0 : qp->l[i] * y[i]);
        s += t;
        *terms += sp__abs(t);
    }
    return s;
}

/* ------------------------------------------------------------------------------------------------------------ products */

/* y <- P x, from the upper triangle. */
static void sp__qp_P(const sp_qp *qp, const sp_real *x, sp_real *y)
{
    for (int32_t j = 0; j < qp->n; j++) {
        y[j] = 0;
        for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++) {
            const int32_t i = qp->Pi[k];
            y[i] += qp->Px[k] * x[j];                   /* i <= j: set before */
            if (i < j) y[j] += qp->Px[k] * x[i];
        }
    }
}

/* y <- A x */
static void sp__qp_A(const sp_qp *qp, const sp_real *x, sp_real *y)
{
    for (int32_t i = 0; i < qp->m; i++) y[i] = 0;
    for (int32_t j = 0; j < qp->n; j++)
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) y[qp->Ai[k]] += qp->Ax[k] * x[j];
}

/* x <- A'y */
static void sp__qp_At(const sp_qp *qp, const sp_real *y, sp_real *x)
{
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real s = 0;
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) s += qp->Ax[k] * y[qp->Ai[k]];
        x[j] = s;
    }
}

/* ----------------------------------------------------------------------------------------------------------- judgement */

/* A residual, the largest of its terms, and both in equilibrated units. */
typedef struct sp__rest { sp_real r, size, scaled, scaled_size; } sp__rest;

/* One component r of terms up to `size`, which the scales multiply by t. A NaN goes through. */
static void sp__rest_widen(sp__rest *a, sp_real r, sp_real size, sp_real t)
{
    if (!(r <= a->r)) a->r = r;
    a->size = sp__max(a->size, size);
    a->scaled = sp__max(a->scaled, t * r);
    a->scaled_size = sp__max(a->scaled_size, t * size);
}

/* Relative size of the equilibrated residual. */
static sp_real sp__rest_relative(const sp__rest *a) { return a->scaled_size > 0 ? a->scaled / a->scaled_size : a->scaled; }

/* Residual over tolerance; strict: also in equilibrated units, so that small rows count as large ones do. */
static sp_real sp__rest_over(const sp__rest *a, const sp_qp_settings *set)
{
    const sp_real off = a->r / (set->eps_abs + set->eps_rel * a->size);
    const sp_real scaled = a->scaled / (set->eps_abs + set->eps_rel * a->scaled_size);
    return set->strict && scaled > off ? scaled : off;
}

/* |AX - z| with z the scaled iterate, or, z NULL, AX onto [l, u]. Returns its price |Y|'|AX - z|. */
static sp_real sp__qp_primal(const sp__qp *w, const sp_real *z, sp__rest *out)
{
    sp_real price = 0;
    for (int32_t i = 0; i < w->qp.m; i++) {
        const sp_real a = w->Ax[i], to = z ? z[i] / w->E[i] : sp__qp_clip(&w->qp, i, a), r = sp__abs(a - to);
        sp__rest_widen(out, r, sp__max(sp__abs(a), sp__abs(to)), w->E[i]);
        price += sp__abs(w->Y[i]) * r;
    }
    return price;
}

/* |PX + q + A'Y|. Returns its price |X|'|PX + q + A'Y|. */
static sp_real sp__qp_dual(const sp__qp *w, sp__rest *out)
{
    sp_real price = 0;
    for (int32_t j = 0; j < w->qp.n; j++) {
        const sp_real q = sp__qp_q(&w->qp, j), p = w->Px[j], a = w->Aty[j], r = sp__abs(p + q + a);
        sp__rest_widen(out, r, sp__max(sp__abs(q), sp__max(sp__abs(p), sp__abs(a))), w->c * w->D[j]);
        price += sp__abs(w->X[j]) * r;
    }
    return price;
}

/* Residuals of X, Y on the data as given, and how far off they are in units of their tolerances.            [seed 4.2]
 *
 *   |Ax - z|       <= eps_abs + eps_rel max(|Ax|, |z|)
 *   |Px + q + A'y| <= eps_abs + eps_rel max(|Px|, |A'y|, |q|)
 *   gap            <= eps_abs + eps_rel |1/2 x'Px + q'x|                     strict only
 *
 * Residuals alone let the objective be wrong by far more than eps. With r = Ax - z, s = Px + q + A'y and the best value f*,
 *
 *     f(x) >= f* - y*'r                       f* as a function of the bounds is convex with slope y*
 *     f*   >= -1/2 x'Px - (u'y+ + l'y-) + s'x*        the dual with q - s for q
 *
 * so near the solution |f(x) - f*| <= gap = max(|y|'|r|, |x'Px + q'x + u'y+ + l'y-| + |x|'|s|). */
SP__APART static void sp__qp_judge(sp__qp *w, const sp_real *z)
{
    const sp_qp *qp = &w->qp;
    sp__rest primal = { 0, 0, 0, 0 }, dual = { 0, 0, 0, 0 };
    sp_real terms, xPx = 0, qx = 0;
    sp__qp_A(qp, w->X, w->Ax);
    sp__qp_P(qp, w->X, w->Px);
    sp__qp_At(qp, w->Y, w->Aty);
    const sp_real infeasible = sp__qp_primal(w, z, &primal), unbalanced = sp__qp_dual(w, &dual);
    for (int32_t j = 0; j < qp->n; j++) {
        xPx += w->X[j] * w->Px[j];
        qx += w->X[j] * sp__qp_q(qp, j);
    }
    w->primal = primal.r;
    w->dual = dual.r;
    w->rel_primal = sp__rest_relative(&primal);
    w->rel_dual = sp__rest_relative(&dual);
    w->objective = (sp_real)0.5 * xPx + qx;
    w->gap = sp__max(infeasible, sp__abs(xPx + qx + sp__qp_support(qp, w->Y, &terms)) + unbalanced);
    w->off = sp__max(sp__rest_over(&primal, &w->set), sp__rest_over(&dual, &w->set));
    if (w->set.strict) w->off = sp__max(w->off, w->gap / (w->set.eps_abs + w->set.eps_rel * sp__abs(w->objective)));
    if (!(w->off < SP__NEVER) || !sp__finite(w->primal + w->dual + w->gap + w->objective)) w->off = SP__NEVER;
    w->flops += w->products + 18 * (int64_t)qp->n + 14 * (int64_t)qp->m;
}

/* The iterate in the units of the data. */
static void sp__qp_unscale(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) w->X[j] = w->D[j] * w->x[j];
    for (int32_t i = 0; i < w->qp.m; i++) w->Y[i] = w->E[i] * w->y[i] / w->c;
}

#endif /* SP_NO_QP */
#endif /* SP__QP_C */
