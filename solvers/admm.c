/* admm: quadratic programs by the alternating direction method of multipliers.
 *
 *     min 1/2 x'Px + q'x   subject to   Ax = z,  l <= z <= u
 *
 * Stellato, Banjac, Goulart, Bemporad, Boyd 2020, "OSQP", Math. Programming Computation 12 [OSQP]; infeasibility: Banjac,
 * Goulart, Stellato, Boyd 2019, J. Optim. Theory Appl. 183 [Banjac]; [seed 4.2, 4.3].
 *
 *   paper                       code            shape
 *   x, z, y; x~, nu             x z y; s        n, m, m; n + m together: what the linear system gives
 *   P q A l u                   qp              n x n, n, m x n, m, m; as given, never copied
 *   D, E, c                     D E c           scales: the iteration runs on cDPD, cDq, EAD, El, Eu, multiplied on the fly
 *   sigma, rho_i; alpha         sigma row; relax
 *   X, Y                        X Y             n, m: a point in the units of the data; everything is judged there
 */
#ifndef SP__ADMM_C
#define SP__ADMM_C

#ifndef SP_NO_QP

#include "ldl.c"
#include "chol.c"
#include "cg.c"
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
    signed char *side;                  /* m: the bound a row is guessed to be at: -1 l, 1 u, 2 both, 0 none */
    sp__ldl ldl;
    sp_real *M;                         /* dense: lower triangle by rows */
    sp__cg cg;
    sp_real *v, *Av;                    /* cg: n, m */
    int32_t stale;                      /* the factor is not that of rho */
    int32_t factorisations, iterations, changes, broken;
    int64_t flops, products;            /* products: flops of P x, A x and A'y together */
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

/* ------------------------------------------------------------------------------------------------------------ products */

/* y <- P x, from the upper triangle. */
static void sp__qp_P(const sp_qp *qp, const sp_real *x, sp_real *y)
{
    for (int32_t j = 0; j < qp->n; j++) y[j] = 0;
    if (!qp->Pp) return;
    for (int32_t j = 0; j < qp->n; j++)
        for (int32_t k = qp->Pp[j]; k < qp->Pp[j + 1]; k++) {
            const int32_t i = qp->Pi[k];
            y[i] += qp->Px[k] * x[j];
            if (i < j) y[j] += qp->Px[k] * x[i];
        }
}

/* y <- A x */
static void sp__qp_A(const sp_qp *qp, const sp_real *x, sp_real *y)
{
    for (int32_t i = 0; i < qp->m; i++) y[i] = 0;
    if (qp->m == 0) return;
    for (int32_t j = 0; j < qp->n; j++)
        for (int32_t k = qp->Ap[j]; k < qp->Ap[j + 1]; k++) y[qp->Ai[k]] += qp->Ax[k] * x[j];
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

/* ------------------------------------------------------------------------------------------------------- linear systems
 *
 *     [ P + sigma I     A'     ] [ x~ ]   [ bx ]
 *     [      A      -1/rho_i   ] [ nu ] = [ bz ]      all scaled; b = (bx, bz), s = (x~, nu)                [OSQP, eq. 24]
 *
 * The dense and the matrix-free back end eliminate nu = rho (A x~ - bz):
 *
 *     (P + sigma I + A' rho A) x~ = bx + A' rho bz                                                          [seed 4.2]
 */

/* The KKT matrix off its diagonal, scaled. */
static void sp__qp_walk(const void *what, sp__entry take, void *to)
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
static sp_real sp__qp_diagonal(const sp__qp *w, int32_t j)
{
    const int32_t end = sp__qp_p0(&w->qp, j + 1);
    return end > sp__qp_p0(&w->qp, j) && w->qp.Pi[end - 1] == j ? w->c * w->D[j] * w->qp.Px[end - 1] * w->D[j] : (sp_real)0;
}

static void sp__qp_factor_sparse(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) sp__ldl_diagonal(&w->ldl, j, sp__qp_diagonal(w, j) + w->sigma);
    for (int32_t i = 0; i < w->qp.m; i++)
        sp__ldl_diagonal(&w->ldl, w->qp.n + i, w->row[i] > 0 ? (sp_real)-1 / w->row[i] : -SP__QP_FREE_ROW);
    sp__ldl_factor(&w->ldl, 0);
    w->broken = w->ldl.bent;
    w->flops += w->ldl.flops;
}

/* Row j of the lower triangle: P_jk + sum over rows i of rho_i a_ij a_ik, k <= j; column j spread out in t (m). */
static void sp__qp_dense_row(sp__qp *w, int32_t j, sp_real *t)
{
    const sp_qp *qp = &w->qp;
    sp_real *r = w->M + (size_t)j * ((size_t)j + 1) / 2;
    w->flops += (int64_t)j * (j + 1);                   /* Cholesky: n^3 / 3 in all */
    for (int32_t k = 0; k <= j; k++) r[k] = 0;
    for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++) r[qp->Pi[k]] = w->c * w->D[qp->Pi[k]] * qp->Px[k] * w->D[j];
    r[j] += w->sigma;
    if (qp->m == 0) return;
    for (int32_t i = 0; i < qp->m; i++) t[i] = 0;
    for (int32_t k = qp->Ap[j]; k < qp->Ap[j + 1]; k++) {
        const int32_t i = qp->Ai[k];
        t[i] = w->row[i] * w->E[i] * w->E[i] * qp->Ax[k] * w->D[j];
    }
    for (int32_t k = 0; k <= j; k++) {
        sp_real s = 0;
        for (int32_t q = qp->Ap[k]; q < qp->Ap[k + 1]; q++) s += qp->Ax[q] * t[qp->Ai[q]];
        r[k] += s * w->D[k];
    }
    w->flops += 2 * (int64_t)qp->Ap[j + 1];
}

static void sp__qp_factor_dense(sp__qp *w)
{
    const int64_t n = w->qp.n;
    for (int32_t j = 0; j < w->qp.n; j++) sp__qp_dense_row(w, j, w->s + n);
    sp__chol_factor(w->M, w->qp.n, 0);
    w->broken = 0;
    for (size_t j = 0; j < (size_t)n; j++) w->broken += !(w->M[j * (j + 3) / 2] < SP__NEVER);
}

/* Preconditioner of the matrix-free back end: 1 / diagonal. */
static void sp__qp_factor_cg(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real d = sp__qp_diagonal(w, j) + w->sigma;
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
            const sp_real a = w->E[qp->Ai[k]] * qp->Ax[k] * w->D[j];
            d += w->row[qp->Ai[k]] * a * a;
        }
        w->cg.inverse[j] = (sp_real)1 / d;
        w->s[j] = 0;
    }
    w->broken = 0;
}

/* Factor for sigma and row. */
static void sp__qp_factor(sp__qp *w)
{
    if (w->set.backend == SP_QP_SPARSE) sp__qp_factor_sparse(w);
    else if (w->set.backend == SP_QP_DENSE) sp__qp_factor_dense(w);
    else sp__qp_factor_cg(w);
    w->factorisations++;
}

/* out <- (P + sigma I + A' rho A) in, scaled. */
static void sp__qp_apply(const void *what, const sp_real *in, sp_real *out)
{
    const sp__qp *w = what;
    const sp_qp *qp = &w->qp;
    for (int32_t j = 0; j < qp->n; j++) w->v[j] = w->D[j] * in[j];
    sp__qp_A(qp, w->v, w->Av);
    for (int32_t i = 0; i < qp->m; i++) w->Av[i] *= w->row[i] * w->E[i] * w->E[i];
    sp__qp_P(qp, w->v, out);
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real s = w->c * out[j];
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) s += qp->Ax[k] * w->Av[qp->Ai[k]];
        out[j] = w->D[j] * s + w->sigma * in[j];
    }
}

/* b <- (bx + A' rho bz, bz), solve for x~ in s, nu = rho (A x~ - bz). */
static void sp__qp_solve_eliminated(sp__qp *w, int exact)
{
    const sp_qp *qp = &w->qp;
    sp_real *nu = w->s + qp->n;
    const sp_real *bz = w->b + qp->n;
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real s = 0;
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++)
            s += qp->Ax[k] * w->E[qp->Ai[k]] * w->row[qp->Ai[k]] * bz[qp->Ai[k]];
        w->b[j] += w->D[j] * s;
    }
    if (w->set.backend == SP_QP_DENSE) {
        for (int32_t j = 0; j < qp->n; j++) w->s[j] = w->b[j];
        sp__chol_solve(w->M, qp->n, w->s);
        w->flops += 2 * (int64_t)qp->n * qp->n;
    } else {
        for (int32_t j = 0; exact && j < qp->n; j++) w->s[j] = 0;
        const sp_real tol = exact ? (sp_real)8 * SP_EPSILON : w->set.cg_tol;
        const int32_t steps = sp__cg_solve(&w->cg, sp__qp_apply, w, w->b, w->s, w->set.cg_steps, tol);
        w->flops += (int64_t)(steps < 0 ? -steps : steps + 1) * (w->products + 12 * (int64_t)qp->n);
    }
    for (int32_t j = 0; j < qp->n; j++) w->b[j] = w->D[j] * w->s[j];        /* bx is spent */
    sp__qp_A(qp, w->b, nu);
    for (int32_t i = 0; i < qp->m; i++) nu[i] = w->row[i] * (w->E[i] * nu[i] - bz[i]);
    w->flops += w->products;
}

/* s <- KKT^-1 b; b is spent. rounds: of refinement, > 0 where the last digit counts. */
static void sp__qp_linear(sp__qp *w, int32_t rounds)
{
    if (w->set.backend != SP_QP_SPARSE) {
        sp__qp_solve_eliminated(w, rounds > 0);
        return;
    }
    if (w->broken && rounds == 0) rounds = 2;
    sp__ldl_solve(&w->ldl, w->b, w->s, rounds);
    w->flops += w->ldl.solve_flops + rounds * (w->ldl.solve_flops + 4 * (int64_t)w->ldl.entries);
}

/* ------------------------------------------------------------------------------------------------------------- iteration */

/* 1e3 rho on equations, the least on rows without bounds. */
static sp_real sp__qp_row_rho(const sp__qp *w, int32_t i)
{
    if (sp__qp_no_l(&w->qp, i) && sp__qp_no_u(&w->qp, i)) return SP__QP_RHO_LEAST;
    return sp__qp_equation(&w->qp, i) ? w->set.rho_equal * w->rho : w->rho;
}

static void sp__qp_refactor(sp__qp *w)
{
    for (int32_t i = 0; i < w->qp.m; i++) w->row[i] = sp__qp_row_rho(w, i);
    w->sigma = w->set.sigma;
    sp__qp_factor(w);
    w->stale = 0;
}

/* v onto [El, Eu]. */
static sp_real sp__qp_onto(const sp__qp *w, int32_t i, sp_real v)
{
    if (!sp__qp_no_l(&w->qp, i) && v < w->E[i] * w->qp.l[i]) return w->E[i] * w->qp.l[i];
    if (!sp__qp_no_u(&w->qp, i) && v > w->E[i] * w->qp.u[i]) return w->E[i] * w->qp.u[i];
    return v;
}

/* One over-relaxed iteration.                                                                  [OSQP, alg. 1, lines 3-7] */
static void sp__qp_step(sp__qp *w)
{
    const int32_t n = w->qp.n, m = w->qp.m;
    const sp_real a = w->set.relax;                     /* alpha in the paper */

    /* b = ( sigma x - q ; z - y/rho ) */
    for (int32_t j = 0; j < n; j++) w->b[j] = w->sigma * w->x[j] - w->c * w->D[j] * sp__qp_q(&w->qp, j);
    for (int32_t i = 0; i < m; i++) w->b[n + i] = w->z[i] - w->y[i] / w->row[i];
    sp__qp_linear(w, 0);

    /* x <- a x~ + (1 - a) x */
    for (int32_t j = 0; j < n; j++) w->x[j] = a * w->s[j] + ((sp_real)1 - a) * w->x[j];

    /* z~ = z + (nu - y)/rho;  v = a z~ + (1 - a) z + y/rho;  z <- v onto [l, u];  y <- rho (v - z) */
    for (int32_t i = 0; i < m; i++) {
        const sp_real r = w->row[i], zt = w->z[i] + (w->s[n + i] - w->y[i]) / r;
        const sp_real v = a * zt + ((sp_real)1 - a) * w->z[i] + w->y[i] / r;
        w->z[i] = sp__qp_onto(w, i, v);
        w->y[i] = r * (v - w->z[i]);
    }
    w->flops += 6 * (int64_t)n + 14 * (int64_t)m;
}

/* ------------------------------------------------------------------------------------------------------------- judgement */

/* The iterate in the units of the data. */
static void sp__qp_unscale(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) w->X[j] = w->D[j] * w->x[j];
    for (int32_t i = 0; i < w->qp.m; i++) w->Y[i] = w->E[i] * w->y[i] / w->c;
}

/* A residual, the largest of its terms, and both in scaled units. */
typedef struct sp__qp_rest { sp_real r, size, scaled, scaled_size; } sp__qp_rest;

/* One component r of terms up to `size`, which the scales multiply by t. A NaN goes through. */
static void sp__qp_widen(sp__qp_rest *a, sp_real r, sp_real size, sp_real t)
{
    if (!(r <= a->r)) a->r = r;
    a->size = sp__max(a->size, size);
    a->scaled = sp__max(a->scaled, t * r);
    a->scaled_size = sp__max(a->scaled_size, t * size);
}

/* |AX - z| with z the scaled iterate, or, z NULL, AX onto [l, u]. */
static void sp__qp_primal(const sp__qp *w, const sp_real *z, sp__qp_rest *out)
{
    memset(out, 0, sizeof *out);
    for (int32_t i = 0; i < w->qp.m; i++) {
        const sp_real a = w->Ax[i], to = z ? z[i] / w->E[i]
            : !sp__qp_no_l(&w->qp, i) && a < w->qp.l[i] ? w->qp.l[i] : !sp__qp_no_u(&w->qp, i) && a > w->qp.u[i] ? w->qp.u[i] : a;
        sp__qp_widen(out, sp__abs(a - to), sp__max(sp__abs(a), sp__abs(to)), w->E[i]);
    }
}

/* |PX + q + A'Y| */
static void sp__qp_dual(const sp__qp *w, sp__qp_rest *out)
{
    memset(out, 0, sizeof *out);
    for (int32_t j = 0; j < w->qp.n; j++) {
        const sp_real q = sp__qp_q(&w->qp, j), p = w->Px[j], a = w->Aty[j];
        sp__qp_widen(out, sp__abs(p + q + a), sp__max(sp__abs(q), sp__max(sp__abs(p), sp__abs(a))), w->c * w->D[j]);
    }
}

/* Relative size of the scaled residual, for the choice of rho. */
static sp_real sp__qp_relative(const sp__qp_rest *a) { return a->scaled_size > 0 ? a->scaled / a->scaled_size : a->scaled; }

/* Residual over tolerance; strict: also in scaled units, so that small rows count as large ones do. */
static sp_real sp__qp_over(const sp__qp *w, const sp__qp_rest *a)
{
    const sp_real off = a->r / (w->set.eps_abs + w->set.eps_rel * a->size);
    const sp_real scaled = a->scaled / (w->set.eps_abs + w->set.eps_rel * a->scaled_size);
    return w->set.strict && scaled > off ? scaled : off;
}

/* u'y+ + l'y-, the support function of [l, u] at y; *terms: sum of |terms|. A multiplier of a bound that is not there counts 0:
 * callers make sure there is none. */
static sp_real sp__qp_support(const sp_qp *qp, const sp_real *y, sp_real *terms)
{
    sp_real s = 0;
    *terms = 0;
    for (int32_t i = 0; i < qp->m; i++) {
        const sp_real t = y[i] > 0 ? (sp__qp_no_u(qp, i) ? (sp_real)0 : qp->u[i] * y[i])
                        : y[i] < 0 ? (sp__qp_no_l(qp, i) ? (sp_real)0 : qp->l[i] * y[i]) : (sp_real)0;
        s += t;
        *terms += sp__abs(t);
    }
    return s;
}

/* Residuals of X, Y on the data as given, and how far off they are in units of their tolerances.            [seed 4.2]
 *   |Ax - z|       <= eps_abs + eps_rel max(|Ax|, |z|)
 *   |Px + q + A'y| <= eps_abs + eps_rel max(|Px|, |A'y|, |q|)
 *   |x'Px + q'x + u'y+ + l'y-| <= eps_abs + eps_rel max of its terms                  strict only */
SP__APART static void sp__qp_judge(sp__qp *w, const sp_real *z)
{
    const sp_qp *qp = &w->qp;
    sp__qp_rest primal, dual;
    sp_real terms, qx = 0;
    sp__qp_A(qp, w->X, w->Ax);
    sp__qp_P(qp, w->X, w->Px);
    sp__qp_At(qp, w->Y, w->Aty);
    sp__qp_primal(w, z, &primal);
    sp__qp_dual(w, &dual);
    const sp_real xPx = sp__inner(w->X, w->Px, qp->n), support = sp__qp_support(qp, w->Y, &terms);
    for (int32_t j = 0; j < qp->n; j++) qx += sp__qp_q(qp, j) * w->X[j];
    w->primal = primal.r;
    w->dual = dual.r;
    w->rel_primal = sp__qp_relative(&primal);
    w->rel_dual = sp__qp_relative(&dual);
    w->objective = (sp_real)0.5 * xPx + qx;
    w->gap = sp__abs(xPx + qx + support);
    terms = sp__max(sp__abs(xPx), sp__max(sp__abs(qx), sp__abs(support)));
    w->off = sp__max(sp__qp_over(w, &primal), sp__qp_over(w, &dual));
    if (w->set.strict) w->off = sp__max(w->off, w->gap / (w->set.eps_abs + w->set.eps_rel * terms));
    if (!sp__finite(w->primal + w->dual + w->gap + w->objective)) w->off = SP__NEVER;
    w->flops += w->products + 16 * (int64_t)qp->n + 12 * (int64_t)qp->m;
}

/* Regularisation where an exact answer is wanted and refined. */
#ifdef SP_REAL_FLOAT
#define SP__QP_DELTA ((sp_real)1e-3)
#else
#define SP__QP_DELTA ((sp_real)1e-6)
#endif
enum { SP__QP_ROUNDS = 6, SP__QP_REFINE = 30 };

/* ----------------------------------------------------------------------------------------------------------- certificates
 *
 * y with A'y = 0 and u'y+ + l'y- < 0 proves that nothing is feasible, for y'Ax <= u'y+ + l'y- wherever l <= Ax <= u [OSQP, 3.4].
 * Numbers leave a rest r = A'y; then any feasible x has
 *
 *     |r|_D |x / D|_1 >= r'x >= ... >= -(u'y+ + l'y-),       |r|_D = max_j D_j |r_j|
 *
 * so what is proved is that there is none with |x / D|_1 below radius = -(u'y+ + l'y-) / |r|_D. A claim asks for a radius far
 * beyond the iterate: a feasible set of one point has radius <= |x / D|_1 and can't be taken for none. The mirror image for x:
 * Px = 0, q'x < 0 and Ax in the recession cone of [l, u], but for rests, rules out all (x*, y*) with Px* + q + A'y* = 0 and
 * |x* / D|_1 + |c y* / E|_1 below -q'x / max(D|Px|, E|rest|).                                      [Banjac, sec. 3]
 */

/* How large solutions must be to be believed away: a multiple of the iterate (of y for the mirror image: x runs away there). */
static sp_real sp__qp_far(const sp_real *v, int32_t n, sp_real radius)
{
    sp_real s = (sp_real)1;
    for (int32_t k = 0; k < n; k++) s += sp__abs(v[k]);
    return s * radius;
}

/* Make v the certificate's direction: largest 1. 0 if it is nothing. */
static int sp__qp_direction(sp_real *v, int32_t n)
{
    const sp_real size = sp__largest(v, n);
    if (!(size > 0) || !sp__finite(size)) return 0;
    for (int32_t k = 0; k < n; k++) v[k] /= size;
    return 1;
}

/* r_j = |A'y|_j and what rounding may have hidden in it, times D_j: the largest. */
static sp_real sp__qp_rest_primal(const sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    sp_real worst = 0;
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real r = 0, size = 0;
        for (int32_t k = qp->Ap[j]; k < qp->Ap[j + 1]; k++) {
            const sp_real t = qp->Ax[k] * w->Y[qp->Ai[k]];
            r += t;
            size += sp__abs(t);
        }
        worst = sp__max(worst, w->D[j] * (sp__abs(r) + (sp_real)4 * SP_EPSILON * size));
    }
    return worst;
}

/* Y judged as a certificate of primal infeasibility: its radius, 0 if it proves nothing. Multipliers of bounds that are not
 * there are dropped first. */
static sp_real sp__qp_proof_primal(sp__qp *w)
{
    sp_real terms;
    for (int32_t i = 0; i < w->qp.m; i++)
        if ((w->Y[i] > 0 && sp__qp_no_u(&w->qp, i)) || (w->Y[i] < 0 && sp__qp_no_l(&w->qp, i))) w->Y[i] = 0;
    const sp_real down = -sp__qp_support(&w->qp, w->Y, &terms) - (sp_real)(w->qp.m + 4) * SP_EPSILON * terms;
    w->flops += 3 * w->products;
    if (!(down > 0)) return 0;
    const sp_real rest = sp__qp_rest_primal(w);
    return rest > 0 ? down / rest : SP__NEVER;
}

/* X judged as a certificate of dual infeasibility: its radius, 0 if it proves nothing. */
static sp_real sp__qp_proof_dual(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    sp_real down = 0, terms = 0, rest = 0;
    for (int32_t j = 0; j < qp->n; j++) {
        const sp_real t = sp__qp_q(qp, j) * w->X[j];
        down -= t;
        terms += sp__abs(t);
    }
    down -= (sp_real)(qp->n + 4) * SP_EPSILON * terms;
    w->flops += 3 * w->products;
    if (!(down > 0)) return 0;
    sp__qp_P(qp, w->X, w->Px);
    sp__qp_A(qp, w->X, w->Ax);
    for (int32_t j = 0; j < qp->n; j++) rest = sp__max(rest, w->D[j] * sp__abs(w->Px[j]));
    for (int32_t i = 0; i < qp->m; i++) {
        const int wrong = (w->Ax[i] > 0 && !sp__qp_no_u(qp, i)) || (w->Ax[i] < 0 && !sp__qp_no_l(qp, i));
        if (wrong) rest = sp__max(rest, sp__abs(w->Ax[i]) * w->E[i] / w->c);
    }
    return rest > 0 ? down / rest : SP__NEVER;
}

/* Y (unscaled) <- the nearest vector with A_S'y = 0, S its rows that count: from y near a certificate one that proves more.
 *
 *     [ delta I  A_S' ] [ -t ]   [  0 ]
 *     [ A_S       -I  ] [ y' ] = [ -y ]       y' = (I + A_S A_S' / delta)^-1 y, some times
 *
 * P is taken out of the KKT matrix by c = 0. */
SP__APART static void sp__qp_sharpen_y(sp__qp *w)
{
    const int32_t n = w->qp.n, m = w->qp.m;
    const sp_real c = w->c;
    for (int32_t i = 0; i < m; i++) w->Y[i] /= w->E[i];
    const sp_real little = (sp_real)1e-3 * sp__largest(w->Y, m);
    w->c = 0;
    w->sigma = SP__QP_DELTA;
    for (int32_t i = 0; i < m; i++) {
        w->row[i] = sp__abs(w->Y[i]) > little ? (sp_real)1 : (sp_real)0;
        w->Y[i] *= w->row[i];
    }
    if (w->set.backend == SP_QP_SPARSE) sp__ldl_values(&w->ldl, sp__qp_walk, w);
    sp__qp_factor(w);
    for (int round = 0; round < 4; round++) {
        for (int32_t j = 0; j < n; j++) w->b[j] = 0;
        for (int32_t i = 0; i < m; i++) w->b[n + i] = -w->Y[i];
        sp__qp_linear(w, 1);
        for (int32_t i = 0; i < m; i++) w->Y[i] = w->row[i] > 0 ? w->s[n + i] : (sp_real)0;
    }
    for (int32_t i = 0; i < m; i++) w->Y[i] *= w->E[i];
    w->c = c;
    if (w->set.backend == SP_QP_SPARSE) sp__ldl_values(&w->ldl, sp__qp_walk, w);
    w->stale = 1;
}

/* X (unscaled) <- the nearest vector with PX = 0 and A_T X = 0, T the rows that must not move: the proximal point method on
 * 1/2 x'Px + |A_T x|^2 / (2 delta). */
SP__APART static void sp__qp_sharpen_x(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    sp__qp_A(qp, w->X, w->Ax);
    for (int32_t i = 0; i < qp->m; i++) w->Ax[i] *= w->E[i];
    const sp_real little = (sp_real)1e-3 * sp__largest(w->Ax, qp->m);
    w->sigma = SP__QP_DELTA;
    for (int32_t i = 0; i < qp->m; i++) {
        const int stays = (!sp__qp_no_u(qp, i) && w->Ax[i] > -little) || (!sp__qp_no_l(qp, i) && w->Ax[i] < little);
        w->row[i] = stays ? (sp_real)1 / w->sigma : (sp_real)0;
    }
    sp__qp_factor(w);
    for (int32_t j = 0; j < qp->n; j++) w->X[j] /= w->D[j];
    for (int round = 0; round < 4; round++) {
        for (int32_t j = 0; j < qp->n; j++) w->b[j] = w->sigma * w->X[j];
        for (int32_t i = 0; i < qp->m; i++) w->b[qp->n + i] = 0;
        sp__qp_linear(w, 1);
        for (int32_t j = 0; j < qp->n; j++) w->X[j] = w->s[j];
    }
    for (int32_t j = 0; j < qp->n; j++) w->X[j] *= w->D[j];
    w->stale = 1;
}

/* ---------------------------------------------------------------------------------------------------------------- polish
 *
 * With the active rows guessed, what is left is min 1/2 x'Px + q'x, A_S x = b_S. It is solved by the proximal method of
 * multipliers, which is refinement of the regularised KKT system [OSQP, sec. 4]: delta = sigma = 1 / rho on S, rows off S free.
 * Rows whose multiplier has the wrong sign leave S, rows that are violated enter, a few times.
 */

/* First guess: a row is at a bound when its distance is less than its multiplier.                  [OSQP, sec. 4] */
static void sp__qp_guess(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    for (int32_t i = 0; i < qp->m; i++) {
        w->side[i] = 0;
        if (sp__qp_equation(qp, i)) w->side[i] = 2;
        else if (!sp__qp_no_l(qp, i) && w->z[i] - w->E[i] * qp->l[i] < -w->y[i]) w->side[i] = -1;
        else if (!sp__qp_no_u(qp, i) && w->E[i] * qp->u[i] - w->z[i] < w->y[i]) w->side[i] = 1;
    }
}

/* b <- what is left of the equality problem's KKT conditions at X, Y (scaled here):
 * ( -(Px + q + A'y) ; b_S - A_S x ) */
static void sp__qp_left(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    const int32_t n = qp->n, m = qp->m;
    for (int32_t j = 0; j < n; j++) w->s[j] = w->D[j] * w->X[j];
    for (int32_t i = 0; i < m; i++) w->s[n + i] = w->E[i] * w->Y[i];
    sp__qp_P(qp, w->s, w->Px);
    sp__qp_A(qp, w->s, w->Ax);
    sp__qp_At(qp, w->s + n, w->Aty);
    for (int32_t j = 0; j < n; j++) w->b[j] = -w->D[j] * (w->c * (w->Px[j] + sp__qp_q(qp, j)) + w->Aty[j]);
    for (int32_t i = 0; i < m; i++)
        w->b[n + i] = w->side[i] ? w->E[i] * ((w->side[i] < 0 ? qp->l[i] : qp->u[i]) - w->Ax[i]) : (sp_real)0;
    w->flops += w->products + 7 * (int64_t)n + 3 * (int64_t)m;
}

/* X, Y (scaled here) <- the equality problem of the rows with a side, from where they are. */
static void sp__qp_equality(sp__qp *w)
{
    const int32_t n = w->qp.n, m = w->qp.m;
    for (int32_t i = 0; i < m; i++) w->row[i] = w->side[i] ? (sp_real)1 / SP__QP_DELTA : 0;
    w->sigma = SP__QP_DELTA;
    w->stale = 1;
    sp__qp_factor(w);
    sp_real before = SP__NEVER;
    for (int32_t round = 0; round < SP__QP_REFINE; round++) {
        sp__qp_left(w);
        sp__qp_linear(w, 1);
        const sp_real change = sp__largest(w->s, n);
        if (!(change < before) && round > 3) return;
        for (int32_t j = 0; j < n; j++) w->X[j] += w->s[j];
        for (int32_t i = 0; i < m; i++) w->Y[i] = w->side[i] ? w->Y[i] + w->s[n + i] : (sp_real)0;
        if (!(change > (sp_real)4 * SP_EPSILON * sp__largest(w->X, n)) || (round > 3 && !(change < (sp_real)0.9 * before))) return;
        before = change;
    }
}

/* Move rows in and out of the active set by what X, Y (unscaled, judged) say. Returns whether one moved. */
static int sp__qp_exchange(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    const sp_real little = (sp_real)64 * SP_EPSILON * sp__largest(w->Y, qp->m);
    int moved = 0;
    for (int32_t i = 0; i < qp->m; i++) {
        const sp_real a = w->Ax[i], out = w->set.eps_abs + w->set.eps_rel * sp__abs(a);
        if (w->side[i] == 2) continue;
        if (w->side[i] && w->side[i] * w->Y[i] < 0) {
            if (w->side[i] * w->Y[i] < -little) { w->side[i] = 0; moved = 1; }
            w->Y[i] = 0;
        } else if (!w->side[i] && !sp__qp_no_l(qp, i) && a < qp->l[i] - out) { w->side[i] = -1; moved = 1; }
        else if (!w->side[i] && !sp__qp_no_u(qp, i) && a > qp->u[i] + out) { w->side[i] = 1; moved = 1; }
    }
    return moved;
}

/* Look for a point within eps near the iterate: 1 and X, Y judged, or 0. */
SP__APART static int sp__qp_polish(sp__qp *w, sp_real off)
{
    sp__qp_guess(w);
    for (int32_t round = 0; round < SP__QP_ROUNDS; round++) {
        for (int32_t j = 0; j < w->qp.n; j++) w->X[j] = w->x[j];
        for (int32_t i = 0; i < w->qp.m; i++) w->Y[i] = w->side[i] ? w->y[i] : (sp_real)0;
        sp__qp_equality(w);
        for (int32_t j = 0; j < w->qp.n; j++) w->X[j] *= w->D[j];
        for (int32_t i = 0; i < w->qp.m; i++) w->Y[i] *= w->E[i] / w->c;
        sp__qp_A(&w->qp, w->X, w->Ax);
        const int moved = sp__qp_exchange(w);
        sp__qp_judge(w, NULL);
        if (w->off <= off) return 1;
        if (!moved || !(w->off < SP__NEVER)) return 0;
    }
    return 0;
}

/* --------------------------------------------------------------------------------------------------------------- the run */

/* rho by what is further off.                                                                              [seed 4.2] */
static void sp__qp_adapt(sp__qp *w)
{
    const sp_real primal = w->rel_primal, dual = w->rel_dual;        /* scaled [OSQP, sec. 5.2] */
    if (w->changes >= w->set.adapt_most) return;
    sp_real rho = w->rho;
    if (primal > (sp_real)10 * dual) rho *= w->set.adapt_factor;
    else if (dual > (sp_real)10 * primal) rho /= w->set.adapt_factor;
    rho = sp__within(rho, SP__QP_RHO_LEAST, SP__QP_RHO_MOST);
    if (!(rho < w->rho) && !(rho > w->rho)) return;
    w->rho = rho;
    w->changes++;
    w->stale = 1;
}

/* A certificate in Y, from the change since the last look or, `hard`, from that sharpened. Its radius if it counts, else 0. */
static sp_real sp__qp_primal_infeasible(sp__qp *w, int hard)
{
    const int32_t m = w->qp.m;
    for (int32_t i = 0; i < m; i++) w->Y[i] = w->E[i] * (w->y[i] - w->yc[i]);
    if (!sp__qp_direction(w->Y, m)) return 0;
    const sp_real far = sp__qp_far(w->x, w->qp.n, w->set.radius);
    sp_real radius = sp__qp_proof_primal(w);
    if (hard && radius > (sp_real)1 && radius <= far) {
        sp__qp_sharpen_y(w);
        radius = sp__qp_direction(w->Y, m) ? sp__qp_proof_primal(w) : 0;
    }
    return radius > far && radius * w->set.eps_pinf > (sp_real)1 ? radius : (sp_real)0;
}

/* The mirror image, in X. */
static sp_real sp__qp_dual_infeasible(sp__qp *w, int hard)
{
    const int32_t n = w->qp.n;
    for (int32_t j = 0; j < n; j++) w->X[j] = w->D[j] * (w->x[j] - w->xc[j]);
    if (!sp__qp_direction(w->X, n)) return 0;
    const sp_real far = sp__qp_far(w->y, w->qp.m, w->set.radius);
    sp_real radius = sp__qp_proof_dual(w);
    if (hard && radius > (sp_real)1 && radius <= far) {
        sp__qp_sharpen_x(w);
        radius = sp__qp_direction(w->X, n) ? sp__qp_proof_dual(w) : 0;
    }
    return radius > far && radius * w->set.eps_dinf > (sp_real)1 ? radius : (sp_real)0;
}

/* Is the problem infeasible? */
static int sp__qp_infeasible(sp__qp *w, int hard, sp_qp_result *out)
{
    out->status = SP_QP_PRIMAL_INFEASIBLE;
    out->radius = sp__qp_primal_infeasible(w, hard);
    if (out->radius > 0) return 1;
    out->status = SP_QP_DUAL_INFEASIBLE;
    out->radius = sp__qp_dual_infeasible(w, hard);
    return out->radius > 0;
}

static void sp__qp_keep(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) w->xc[j] = w->x[j];
    for (int32_t i = 0; i < w->qp.m; i++) w->yc[i] = w->y[i];
}

/* One look at the iterate: 1 and a status when the run is over. */
static int sp__qp_look(sp__qp *w, sp_qp_result *out)
{
    const int last = w->iterations >= w->set.iterations, spent = w->set.budget > 0 && w->flops >= w->set.budget;
    sp__qp_unscale(w);
    sp__qp_judge(w, w->z);
    if (!(w->off < SP__NEVER)) {
        for (int32_t j = 0; j < w->qp.n; j++) w->x[j] = w->xc[j];
        for (int32_t i = 0; i < w->qp.m; i++) w->y[i] = w->yc[i];
        out->status = SP_QP_NUMERICAL;
        return 1;
    }
    const sp_real off = w->off;
    const int solved = off <= (sp_real)1;
    const int32_t k = w->iterations / 100;
    const int try = solved || last || (w->iterations == 100 * k && (k & (k - 1)) == 0);
    if (!solved && !last && w->set.adapt > 0 && w->iterations % w->set.adapt == 0) sp__qp_adapt(w);
    if (w->set.polish && try && !spent && sp__qp_polish(w, solved ? off : (sp_real)1)) {
        out->status = SP_QP_SOLVED;
        out->polished = 1;
        return 1;
    }
    out->status = SP_QP_SOLVED;
    if (solved) return 1;
    if (sp__qp_infeasible(w, try && !spent, out)) return 1;
    if (last || spent) {
        out->status = off <= (sp_real)10 ? SP_QP_INACCURATE : last ? SP_QP_ITERATIONS : SP_QP_BUDGET;
        return 1;
    }
    return 0;
}

/* What is left of the result, for a point or a certificate. */
static void sp__qp_report(sp__qp *w, sp_qp_result *out)
{
    if (out->status == SP_QP_PRIMAL_INFEASIBLE)
        for (int32_t j = 0; j < w->qp.n; j++) w->X[j] = 0;
    else if (out->status == SP_QP_DUAL_INFEASIBLE)
        for (int32_t i = 0; i < w->qp.m; i++) w->Y[i] = 0;
    else if (!out->polished) {
        sp__qp_unscale(w);
        sp__qp_judge(w, out->status == SP_QP_NUMERICAL ? NULL : w->z);
    }
    out->x = w->X;
    out->y = w->Y;
    out->objective = w->objective;
    out->primal = w->primal;
    out->dual = w->dual;
    out->gap = w->gap;
    out->rho = w->rho;
    out->iterations = w->iterations;
    out->factorisations = w->factorisations;
    out->flops = w->flops;
}

static void sp__qp_iterate(sp__qp *w, sp_qp_result *out)
{
    const sp_qp_result none = { SP_QP_ITERATIONS, NULL, NULL, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 };
    *out = none;
    w->iterations = w->changes = 0;
    do {
        if (w->stale) sp__qp_refactor(w);
        sp__qp_keep(w);
        for (int32_t k = 0; k < w->set.check && w->iterations < w->set.iterations; k++, w->iterations++) sp__qp_step(w);
    } while (!sp__qp_look(w, out));
    sp__qp_report(w, out);
}

/* ------------------------------------------------------------------------------------------------------------ arguments */

static sp_status sp__qp_check_matrix(const int32_t *p, const int32_t *i, const sp_real *x, int32_t rows, int32_t cols, int upper)
{
    if (!p || p[0] != 0) return p ? SP_E_INDEX : SP_E_ARGUMENT;
    for (int32_t j = 0; j < cols; j++) {
        if (p[j + 1] < p[j]) return SP_E_INDEX;
        if (p[j + 1] > p[j] && (!i || !x)) return SP_E_ARGUMENT;
        for (int32_t k = p[j]; k < p[j + 1]; k++) {
            if (i[k] < 0 || i[k] >= (upper ? j + 1 : rows) || (k > p[j] && i[k] <= i[k - 1])) return SP_E_INDEX;
            if (!sp__finite(x[k])) return SP_E_NOT_FINITE;
        }
    }
    return SP_OK;
}

/* A number or an infinity, not a NaN. */
static int sp__qp_bound(sp_real b) { return b > 0 ? 1 : b <= 0; }

static sp_status sp__qp_check_vectors(const sp_qp *qp)
{
    if (qp->m > 0 && (!qp->l || !qp->u)) return SP_E_ARGUMENT;
    for (int32_t j = 0; qp->q && j < qp->n; j++)
        if (!sp__finite(qp->q[j])) return SP_E_NOT_FINITE;
    for (int32_t i = 0; i < qp->m; i++) {
        if (!sp__qp_bound(qp->l[i]) || !sp__qp_bound(qp->u[i])) return SP_E_NOT_FINITE;
        if (qp->l[i] > qp->u[i] || !(qp->l[i] < SP_QP_INFINITY) || !(qp->u[i] > -SP_QP_INFINITY)) return SP_E_RANGE;
    }
    return SP_OK;
}

static int sp__qp_settings_fit(const sp_qp_settings *s)
{
    if (s->backend != SP_QP_SPARSE && s->backend != SP_QP_DENSE && s->backend != SP_QP_CG) return 0;
    if (!(s->eps_abs >= 0 && s->eps_rel >= 0 && s->eps_abs + s->eps_rel > 0 && sp__finite(s->eps_abs + s->eps_rel))) return 0;
    if (!(s->eps_pinf > 0 && s->eps_dinf > 0 && s->radius >= 1 && s->cg_tol > 0)) return 0;
    if (!(s->sigma > 0 && s->sigma <= 1 && s->relax > 0 && s->relax < 2 && s->rho_equal >= 1 && s->adapt_factor > 1)) return 0;
    if (!(s->rho >= SP__QP_RHO_LEAST && s->rho <= SP__QP_RHO_MOST)) return 0;
    return s->iterations > 0 && s->check > 0 && s->passes >= 0 && s->cg_steps > 0 && s->adapt >= 0 && s->budget >= 0;
}

static sp_status sp__qp_check(const sp_qp *qp, const sp_qp_settings *set)
{
    if (!qp || qp->n < 0 || qp->m < 0) return SP_E_ARGUMENT;
    if (qp->n == 0) return SP_E_EMPTY;
    if (!sp__qp_settings_fit(set)) return SP_E_RANGE;
    if (qp->n > INT32_MAX / 2 - qp->m) return SP_E_MEMORY;
    sp_status status = SP_OK;
    if (qp->Pp || qp->Pi || qp->Px) status = sp__qp_check_matrix(qp->Pp, qp->Pi, qp->Px, qp->n, qp->n, 1);
    if (status == SP_OK && qp->m > 0) status = sp__qp_check_matrix(qp->Ap, qp->Ai, qp->Ax, qp->m, qp->n, 0);
    return status == SP_OK ? sp__qp_check_vectors(qp) : status;
}

/* P_jj >= 0 and P_ij^2 <= P_ii P_jj, scaled and up to rounding; in d (n) the roots of the diagonal.
 * Returns 0: indefinite, 1: can't tell, 2: diagonal, so semidefinite. */
static int sp__qp_minors(const sp__qp *w, sp_real *d)
{
    const sp_qp *qp = &w->qp;
    int diagonal = 1;
    for (int32_t j = 0; j < qp->n; j++) d[j] = sp__qp_diagonal(w, j);
    const sp_real slack = (sp_real)64 * SP_EPSILON * sp__largest(d, qp->n);
    for (int32_t j = 0; j < qp->n; j++) {
        if (d[j] < -slack) return 0;
        d[j] = SP_SQRT(sp__max(d[j], 0));
        for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++) {
            const int32_t i = qp->Pi[k];
            if (i == j || !(sp__abs(qp->Px[k]) > 0)) continue;
            diagonal = 0;
            if (w->c * w->D[i] * sp__abs(qp->Px[k]) * w->D[j] > d[i] * d[j] * (sp_real)1.00001 + slack) return 0;
        }
    }
    return 1 + diagonal;
}

/* Is P semidefinite? P + shift I, scaled, has a factor, the shift above what rounding can do; conjugate gradients look for a
 * direction of negative curvature from a right-hand side without pattern instead. */
static int sp__qp_semidefinite(sp__qp *w)
{
    const int known = sp__qp_minors(w, w->b);
    if (known != 1) return known == 2;
    sp_real most = 0;
    for (int32_t j = 0; j < w->qp.n; j++) w->b[j] = 0;
    for (int32_t j = 0; j < w->qp.n; j++)
        for (int32_t k = w->qp.Pp[j]; k < w->qp.Pp[j + 1]; k++) {
            const int32_t i = w->qp.Pi[k];
            const sp_real a = w->c * w->D[i] * sp__abs(w->qp.Px[k]) * w->D[j];
            w->b[j] += a;
            if (i < j) w->b[i] += a;
        }
    for (int32_t j = 0; j < w->qp.n; j++) most = sp__max(most, w->b[j]);
    w->sigma = most * ((sp_real)1e-9 + (sp_real)4 * SP_EPSILON * (sp_real)w->qp.n);
    for (int32_t i = 0; i < w->qp.m; i++) w->row[i] = 0;
    sp__qp_factor(w);
    if (w->set.backend != SP_QP_CG) return w->broken == 0;
    uint32_t seed = 1;
    for (int32_t j = 0; j < w->qp.n; j++) {
        seed = seed * 1664525u + 1013904223u;
        w->b[j] = (sp_real)(int32_t)(seed >> 16) / (sp_real)32768 - (sp_real)1;
    }
    return sp__cg_solve(&w->cg, sp__qp_apply, w, w->b, w->s, w->set.cg_steps, w->set.cg_tol) >= 0;
}

/* --------------------------------------------------------------------------------------------------------------- memory */

static int32_t sp__qp_entries(const sp_qp *qp)
{
    int32_t count = sp__qp_a0(qp, qp->n);
    for (int32_t j = 0; j < qp->n; j++) {
        const int32_t from = sp__qp_p0(qp, j), end = sp__qp_p0(qp, j + 1);
        count += end - from - (end > from && qp->Pi[end - 1] == j);
        if (count < 0 || count > INT32_MAX / 4) return -1;
    }
    return count;
}

enum { SP__QP_OF_N = 6, SP__QP_OF_M = 13, SP__QP_VECTORS = 15 };      /* ends of the vectors of n, m, n + m numbers */

/* The work and its vectors; p, if not NULL: where they are. */
static sp__qp *sp__qp_carve_vectors(const sp_qp *qp, sp_real **p, sp_arena *a)
{
    const size_t n = (size_t)qp->n, m = (size_t)qp->m;
    sp__qp *w = sp__take(a, 1, sizeof *w);
    for (int k = 0; k < SP__QP_VECTORS; k++) {
        sp_real *v = sp__take(a, k < SP__QP_OF_N ? n : k < SP__QP_OF_M ? m : n + m, sizeof *v);
        if (p) p[k] = v;
    }
    return w;
}

/* n (n + 1) / 2 numbers. */
static sp_real *sp__qp_carve_dense(const sp_qp *qp, sp_arena *a)
{
    const size_t n = (size_t)qp->n;
    return sp__take(a, n % 2 ? (n + 1) / 2 : n + 1, (n % 2 ? n : n / 2) * sizeof(sp_real));
}

static void sp__qp_carve_symbolic(sp__ldl *f, sp_arena *a)
{
    sp__order o;
    sp__ldl_carve_graph(f, a);
    sp__order_carve(&o, f->n, 2 * f->entries, a);
}

/* Everything but the factor of the sparse back end, in the order of sp__qp_count. NULL: it does not fit. */
SP__APART static sp__qp *sp__qp_carve(const sp_qp *qp, sp_qp_backend backend, sp_arena *a)
{
    sp_real *p[SP__QP_VECTORS];
    sp__qp *w = sp__qp_carve_vectors(qp, p, a);
    if (sp__failed(a)) return NULL;
    memset(w, 0, sizeof *w);
    w->D = p[0]; w->x = p[1]; w->xc = p[2]; w->X = p[3]; w->Px = p[4]; w->Aty = p[5];
    w->E = p[6]; w->row = p[7]; w->z = p[8]; w->y = p[9]; w->yc = p[10]; w->Y = p[11]; w->Ax = p[12];
    w->b = p[13]; w->s = p[14];
    w->side = sp__take(a, (size_t)qp->m, 1);
    if (backend == SP_QP_SPARSE) sp__ldl_carve(&w->ldl, qp->n + qp->m, qp->n, sp__qp_entries(qp), a);
    else if (backend == SP_QP_DENSE) w->M = sp__qp_carve_dense(qp, a);
    else sp__cg_carve(&w->cg, qp->n, a);
    if (backend == SP_QP_CG) w->v = sp__take(a, (size_t)qp->n, sizeof *w->v);
    if (backend == SP_QP_CG) w->Av = sp__take(a, (size_t)qp->m, sizeof *w->Av);
    return sp__failed(a) ? NULL : w;
}

/* Bytes of everything for n, m of *qp and so many `entries`, the factor having `fill`; 0: too many. */
SP__APART static size_t sp__qp_count(const sp_qp *qp, int32_t entries, sp_qp_backend backend, int32_t fill)
{
    sp_arena a = sp__arena_dry();
    if (entries < 0) return 0;
    sp__qp_carve_vectors(qp, NULL, &a);
    sp__take(&a, (size_t)qp->m, 1);
    if (backend == SP_QP_SPARSE) {
        sp__ldl f;
        sp__ldl_carve(&f, qp->n + qp->m, qp->n, entries, &a);
        sp_arena symbolic = a;
        sp__qp_carve_symbolic(&f, &symbolic);
        sp__ldl_carve_factor(&f, fill, &a);
        if (sp__failed(&symbolic) || symbolic.used > a.used) a = symbolic;
    } else if (backend == SP_QP_DENSE) {
        sp__qp_carve_dense(qp, &a);
    } else {
        sp__cg cg;
        sp__cg_carve(&cg, qp->n, &a);
        sp__take(&a, (size_t)qp->n, sizeof(sp_real));
        sp__take(&a, (size_t)qp->m, sizeof(sp_real));
    }
    return sp__failed(&a) ? 0 : a.used;
}

/* Place the work in the arena, find the scales and run the symbolic step; *fill: entries of the factor. NULL: no room. */
SP__APART static sp__qp *sp__qp_place(const sp_qp *qp, const sp_qp_settings *set, sp_arena *a, int32_t *fill)
{
    if (sp__qp_entries(qp) < 0) return NULL;
    sp__qp *w = sp__qp_carve(qp, set->backend, a);
    if (!w) return NULL;
    w->qp = *qp;
    w->set = *set;
    w->rho = set->rho;
    w->stale = 1;
    w->products = 4 * ((int64_t)sp__qp_entries(qp) + qp->n) + 2 * (int64_t)sp__qp_a0(qp, qp->n);
    w->c = sp__ruiz(qp, set->passes, w->D, w->E, w->b, w->b + qp->n);
    *fill = 0;
    if (set->backend != SP_QP_SPARSE) return w;
    sp_arena symbolic = *a;
    sp__qp_carve_symbolic(&w->ldl, &symbolic);
    if (sp__failed(&symbolic)) return NULL;
    if (symbolic.peak > a->peak) a->peak = symbolic.peak;
    *fill = sp__ldl_analyse(&w->ldl, sp__qp_walk, w, *a);
    return *fill < 0 ? NULL : w;
}

/* ------------------------------------------------------------------------------------------------------------ public calls */

SP_API sp_qp_settings sp_qp_default(void)
{
    sp_qp_settings s;
    s.backend = SP_QP_SPARSE;
#ifdef SP_REAL_FLOAT
    s.eps_abs = s.eps_rel = (sp_real)1e-4;
    s.radius = (sp_real)1e3;
    s.sigma = (sp_real)1e-3;                            /* below 64 u x the largest penalty pivots drown */
    s.rho_equal = (sp_real)1e2;
    s.cg_tol = (sp_real)1e-6;
#else
    s.eps_abs = 1e-6;
    s.eps_rel = 1e-5;
    s.radius = 1e6;
    s.sigma = 1e-6;
    s.rho_equal = 1e3;
    s.cg_tol = 1e-10;
#endif
    s.eps_pinf = s.eps_dinf = (sp_real)1e-4;
    s.strict = s.polish = 1;
    s.iterations = 8000;
    s.budget = 0;
    s.check = 10;
    s.passes = 10;
    s.relax = (sp_real)1.6;
    s.rho = (sp_real)0.1;
    s.adapt = 100;
    s.adapt_most = 10;
    s.adapt_factor = (sp_real)5;
    s.cg_steps = 250;
    return s;
}

SP_API size_t sp_qp_memory_scratch(const sp_qp *qp, const sp_qp_settings *settings)
{
    const sp_qp_settings set = settings ? *settings : sp_qp_default();
    return sp__qp_check(qp, &set) == SP_OK ? sp__qp_count(qp, sp__qp_entries(qp), set.backend, 0) : 0;
}

SP_API sp_status sp_qp_memory(const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes)
{
    const sp_qp_settings set = settings ? *settings : sp_qp_default();
    const sp_status status = sp__qp_check(qp, &set);
    int32_t fill = 0;
    if (status != SP_OK || !bytes) return status == SP_OK ? SP_E_ARGUMENT : status;
    if (set.backend == SP_QP_SPARSE) {
        if (!scratch.base) return SP_E_ARGUMENT;
        if (!sp__qp_place(qp, &set, &scratch, &fill)) return SP_E_MEMORY;
    }
    const size_t need = sp__qp_count(qp, sp__qp_entries(qp), set.backend, fill);
    if (need == 0) return SP_E_MEMORY;
    *bytes = need;
    return SP_OK;
}

SP_API sp_status sp_qp_setup(const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, sp_qp_work **work)
{
    const sp_qp_settings set = settings ? *settings : sp_qp_default();
    const sp_status status = sp__qp_check(qp, &set);
    if (status != SP_OK || !arena || !arena->base || !work) return status == SP_OK ? SP_E_ARGUMENT : status;
    sp_arena a = *arena;
    int32_t fill;
    sp__qp *w = sp__qp_place(qp, &set, &a, &fill);
    if (!w) return SP_E_MEMORY;
    if (set.backend == SP_QP_SPARSE) sp__ldl_carve_factor(&w->ldl, fill, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    if (!sp__finite(w->c) || !sp__finite(sp__largest(w->D, qp->n)) || !sp__finite(sp__largest(w->E, qp->m))) return SP_E_NOT_FINITE;
    if (!sp__qp_semidefinite(w)) return SP_E_INDEFINITE;
    *arena = a;
    *work = w;
    return SP_OK;
}

SP_API sp_status sp_qp_update(sp_qp_work *work, const sp_real *q, const sp_real *l, const sp_real *u)
{
    if (!work) return SP_E_ARGUMENT;
    const sp_qp before = work->qp;
    if (q) work->qp.q = q;
    if (l) work->qp.l = l;
    if (u) work->qp.u = u;
    const sp_status status = sp__qp_check_vectors(&work->qp);
    if (status != SP_OK) work->qp = before;
    if (status != SP_OK || work->stale) return status;
    for (int32_t i = 0; i < before.m; i++) {
        const sp_real r = sp__qp_row_rho(work, i);
        if (r < work->row[i] || r > work->row[i]) work->stale = 1;
    }
    return SP_OK;
}

SP_API sp_status sp_qp_rho(sp_qp_work *work, sp_real rho)
{
    if (!work) return SP_E_ARGUMENT;
    if (!(rho >= SP__QP_RHO_LEAST && rho <= SP__QP_RHO_MOST)) return SP_E_RANGE;
    if (rho < work->rho || rho > work->rho) work->stale = 1;
    work->rho = rho;
    return SP_OK;
}

/* x <- x0 / D, y <- c y0 / E, z <- Ax onto [l, u], as the iteration wants them; s: a first guess for conjugate gradients. */
static void sp__qp_start(sp__qp *w, const sp_real *x0, const sp_real *y0)
{
    for (int32_t j = 0; j < w->qp.n; j++) w->X[j] = x0 ? x0[j] : (sp_real)0;
    for (int32_t i = 0; i < w->qp.m; i++) w->y[i] = y0 ? w->c * y0[i] / w->E[i] : (sp_real)0;
    sp__qp_A(&w->qp, w->X, w->Ax);
    for (int32_t j = 0; j < w->qp.n; j++) w->x[j] = w->s[j] = w->X[j] / w->D[j];
    for (int32_t i = 0; i < w->qp.m; i++) w->z[i] = sp__qp_onto(w, i, w->E[i] * w->Ax[i]);
}

SP_API sp_status sp_qp_run(sp_qp_work *work, const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    if (!work || !result) return SP_E_ARGUMENT;
    for (int32_t j = 0; x0 && j < work->qp.n; j++) if (!sp__finite(x0[j])) return SP_E_NOT_FINITE;
    for (int32_t i = 0; y0 && i < work->qp.m; i++) if (!sp__finite(y0[i])) return SP_E_NOT_FINITE;
    sp__qp_start(work, x0, y0);
    work->flops = 0;
    work->factorisations = 0;
    sp__qp_iterate(work, result);
    return SP_OK;
}

SP_API sp_status sp_qp_solve(const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, const sp_real *x0,
                             const sp_real *y0, sp_qp_result *result)
{
    sp_qp_work *work;
    sp_arena a;
    if (!arena || !result) return SP_E_ARGUMENT;
    a = *arena;
    sp_status status = sp_qp_setup(qp, settings, &a, &work);
    if (status == SP_OK) status = sp_qp_run(work, x0, y0, result);
    if (status == SP_OK) *arena = a;
    return status;
}

static sp_status sp__qp_plug_solve(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena,
                                   const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    (void)self;
    return sp_qp_solve(qp, settings, arena, x0, y0, result);
}

static sp_status sp__qp_plug_need(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes)
{
    (void)self;
    return sp_qp_memory(qp, settings, scratch, bytes);
}

SP_API sp_qp_solver sp_qp_admm(void)
{
    sp_qp_solver s;
    s.self = NULL;
    s.solve = sp__qp_plug_solve;
    s.need = sp__qp_plug_need;
    return s;
}

#endif /* SP_NO_QP */
#endif /* SP__ADMM_C */
