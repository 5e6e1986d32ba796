/* qp: a quadratic program, a point of it, and how good that point is on the data as given.
 *
 *     min 1/2 x'Px + q'x   subject to   Ax = z,  l <= z <= u
 *
 *   paper [OSQP]                code            shape
 *   x, z, y; x~, nu             x z y; kkt.s    n, m, m; n + m together: what the linear system gives
 *   P q A l u                   qp              n x n, n, m x n, m, m; as given, never copied
 *   D, E, c                     D E c           scales: the iteration runs on cDPD, cDq, EAD, El, Eu, multiplied on the fly
 *   sigma, rho_i; alpha         kkt.sigma .row; set.relax
 *   X, Y                        X Y             n, m: a point in the units of the data; everything is judged there
 *
 * Stellato, Banjac, Goulart, Bemporad, Boyd 2020, "OSQP", Math. Programming Computation 12 [OSQP].
 */
#ifndef SP__QP_C
#define SP__QP_C

#include "../linear/chol.c"
#include "../linear/ldl.c"
#include "../linear/cg.c"
#include "ruiz.c"

#if SP__WITH_QP

#define SP__QP_RHO_LEAST ((sp_real)1e-6)                /* clamps of rho                                        [seed 4.2] */
#define SP__QP_RHO_MOST  ((sp_real)1e6)
#define SP__QP_FREE_ROW  ((sp_real)1e20)                /* 1 / rho of a row that shall not matter */

/* The linear system of every iteration (kkt.c). */
typedef struct sp__kkt {
    sp_real *b, *s, *row;               /* n + m: right-hand side and solution; m: rho of each row */
    sp_real *M;                         /* dense: lower triangle by rows */
    int32_t stale, broken;              /* the factor is not that of rho; pivots that had to be bent */
    sp_real rho, sigma;
    sp__ldl ldl;
#if SP__WITH_QP_CG
    sp__cg cg;
    sp_real *v, *Av;                    /* cg: n, m */
#endif
} sp__kkt;

#if SP__WITH_QP_INTERIOR
/* Slacks and multipliers of the bounds, first all l, then all u; s = 0: none (proximal.c). */
typedef struct sp__proximal {
    sp_real *s, *y, *c, *v;             /* 2 m, 2 m, 2 m, m: c_t, v as there */
    sp_real *x, *Y;                     /* n, m: x, y of the best iterate */
    sp_real best, rho, delta, least;    /* how far off that is; least: of delta */
    int32_t sides, steps, idle, turn;   /* bounds there are, but for equations; idle: steps since it got better; turn: the
                                           iteration of ADMM before which it is their turn */
} sp__proximal;
#endif

/* How good X, Y are. */
typedef struct sp__qp_residual {
    sp_real primal, dual, gap, objective;
    sp_real off;                        /* largest residual relative to its tolerance */
    sp_real rel_primal, rel_dual;       /* scaled residuals relative to their terms */
} sp__qp_residual;

/* What it costs, and what it may. */
typedef struct sp__qp_cost {
    int64_t flops, limit;               /* limit: where flops must end */
    int64_t products, vectors;          /* flops of P x, A x and A'y together; of what else a step or a look does, about */
    int64_t factoring;                  /* flops of a factorisation */
} sp__qp_cost;

struct sp_qp_work {                     /* pointers first: near offsets make short instructions */
    sp_qp qp;
    sp_real *D, *E;                     /* scales, with c */
    sp_real *x, *z, *y, *xc, *yc;       /* iterate; xc, yc: at the look before this one */
    sp_real *X, *Y, *Px, *Aty, *Ax;     /* a point and its products, in the units of the data */
    int32_t factorisations, iterations, changes;        /* changes: of rho */
    sp__kkt kkt;
    sp__qp_cost cost;
    sp_qp_settings set;
    sp__qp_residual residual;           /* of X, Y */
    sp_real c;
    signed char *side;                  /* m, polish: the row is outside its bounds */
#if SP__WITH_QP_INTERIOR
    sp__proximal ip;
#endif
};
typedef struct sp_qp_work sp__qp;

/* The back end in use: SP_SMALL has the dense one alone. */
static sp_qp_backend sp__qp_backend(const sp_qp_settings *set)
{
    return SP__WITH_SMALL ? SP_QP_DENSE : set->backend;
}

static int sp__qp_no_l(const sp_qp *qp, int32_t i) { return !(qp->l[i] > -SP_QP_INFINITY); }
static int sp__qp_no_u(const sp_qp *qp, int32_t i) { return !(qp->u[i] < SP_QP_INFINITY); }
/* Would the multiplier y of row i push at a bound that is not there? */
static int sp__qp_no_bound(const sp_qp *qp, int32_t i, sp_real y) { return y > 0 ? sp__qp_no_u(qp, i) : sp__qp_no_l(qp, i); }
static int sp__qp_equation(const sp_qp *qp, int32_t i) { return !(qp->l[i] < qp->u[i]); }
static sp_real sp__qp_q(const sp_qp *qp, int32_t j) { return qp->q ? qp->q[j] : (sp_real)0; }

/* Diagonal entry j of cDPD: the last of its column, if there is one. */
static sp_real sp__qp_diagonal(const sp__qp *w, int32_t j)
{
    const int32_t end = sp__qp_p0(&w->qp, j + 1);
    return end > sp__qp_p0(&w->qp, j) && w->qp.Pi[end - 1] == j ? w->c * w->D[j] * w->qp.Px[end - 1] * w->D[j] : (sp_real)0;
}

/* Largest |x_i|; NaN where there is one. */
static sp_real sp__largest(const sp_real *x, int32_t n)
{
    sp_real most = 0;
    for (int32_t i = 0; i < n && most >= 0; i++)
        if (!(sp__abs(x[i]) <= most)) most = sp__abs(x[i]);                 /* a NaN goes through */
    return most;
}

/* out <- a b, one by one. */
SP__NOINLINE static void sp__qp_scale(sp_real *out, const sp_real *a, const sp_real *b, int32_t n)
{
    for (int32_t k = 0; k < n; k++) out[k] = a[k] * b[k];
}

/* Are they numbers? NULL is. */
static int sp__qp_numbers(const sp_real *v, int32_t n) { return !v || sp__all_finite(v, (size_t)n); }

/* v onto e [l_i, u_i], e = 1 or the scale of the row. */
static sp_real sp__qp_clip(const sp_qp *qp, int32_t i, sp_real v, sp_real e)
{
    const sp_real l = e * qp->l[i], u = e * qp->u[i];
    if (v < l && !sp__qp_no_l(qp, i)) return l;
    if (v > u && !sp__qp_no_u(qp, i)) return u;
    return v;
}

/* u'y+ + l'y-, the support function of [l, u] at y; *terms: sum of |terms|. A multiplier of a bound that is not there counts 0:
 * callers make sure there is none. */
static sp_real sp__qp_support(const sp_qp *qp, const sp_real *y, sp_real *terms)
{
    sp_real s = 0;
    *terms = 0;
    for (int32_t i = 0; i < qp->m; i++) {
        const sp_real t = sp__qp_no_bound(qp, i, y[i]) ? (sp_real)0 : (y[i] > 0 ? qp->u[i] : qp->l[i]) * y[i];
        s += t;
        *terms += sp__abs(t);
    }
    return s;
}

/* ------------------------------------------------------------------------------------------------------------ products */

/* a b, or its size. */
static sp_real sp__qp_term(sp_real a, sp_real b, int sizes) { return sizes ? sp__abs(a * b) : a * b; }

/* y <- P x, from the upper triangle; sizes: |P| |x|. */
static void sp__qp_P(const sp_qp *qp, const sp_real *x, sp_real *y, int sizes)
{
    for (int32_t j = 0; j < qp->n; j++) {
        y[j] = 0;
        for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++) {
            const int32_t i = qp->Pi[k];
            y[i] += sp__qp_term(qp->Px[k], x[j], sizes);                    /* i <= j: set before */
            if (i < j) y[j] += sp__qp_term(qp->Px[k], x[i], sizes);
        }
    }
}

/* y <- A x; sizes: |A| |x|. */
static void sp__qp_A(const sp_qp *qp, const sp_real *x, sp_real *y, int sizes)
{
    for (int32_t i = 0; i < qp->m; i++) y[i] = 0;
    for (int32_t j = 0; j < qp->n; j++)
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++)
            y[qp->Ai[k]] += sp__qp_term(qp->Ax[k], x[j], sizes);
}

/* (A'y)_j; *size: sum of |terms|. */
static sp_real sp__qp_column(const sp_qp *qp, const sp_real *y, int32_t j, sp_real *size)
{
    sp_real s = 0, sum = 0;
    for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
        const sp_real t = qp->Ax[k] * y[qp->Ai[k]];
        s += t;
        sum += sp__abs(t);
    }
    *size = sum;
    return s;
}

/* x <- A'y */
static void sp__qp_At(const sp_qp *qp, const sp_real *y, sp_real *x)
{
    sp_real size;
    for (int32_t j = 0; j < qp->n; j++) x[j] = sp__qp_column(qp, y, j, &size);
}

/* ----------------------------------------------------------------------------------------------------------- judgement */

/* A residual, the largest of its terms, and both in equilibrated units; price: the sum of |weight| r. */
typedef struct sp__residual { sp_real r, size, scaled, scaled_size, price; } sp__residual;

/* One component r of terms up to `size`, which the scales multiply by t. The price is no number where an r is none. */
SP__NOINLINE static void sp__residual_add(sp__residual *a, sp_real r, sp_real size, sp_real t, sp_real weight)
{
    a->r = sp__max(a->r, r);
    a->size = sp__max(a->size, size);
    a->scaled = sp__max(a->scaled, t * r);
    a->scaled_size = sp__max(a->scaled_size, t * size);
    a->price += sp__abs(weight) * r;
}

/* Relative size of the equilibrated residual. */
SP__NOINLINE static sp_real sp__residual_relative(const sp__residual *a)
{
    return a->scaled_size > 0 ? a->scaled / a->scaled_size : a->scaled;
}

/* r over its tolerance. */
SP__NOINLINE static sp_real sp__qp_over_tol(const sp__qp *w, sp_real r, sp_real size)
{
    return r > 0 ? r / (w->set.eps_abs + w->set.eps_rel * size) : (sp_real)0;
}

/* Residual over tolerance; strict: also in equilibrated units, so that small rows count as large ones do. */
static sp_real sp__residual_over_tol(const sp__qp *w, const sp__residual *a)
{
    const sp_real off = sp__qp_over_tol(w, a->r, a->size);
    return w->set.strict ? sp__max(off, sp__qp_over_tol(w, a->scaled, a->scaled_size)) : off;
}

/* |AX - z| with z the scaled iterate, or, z NULL, AX onto [l, u], and what rounding may hide: u |A| |X|, the latter in b + n.
 * Its price: |Y|'|AX - z|. */
static void sp__qp_primal(const sp__qp *w, const sp_real *z, sp__residual *out)
{
    for (int32_t i = 0; i < w->qp.m; i++) {
        const sp_real a = w->Ax[i], to = z ? z[i] / w->E[i] : sp__qp_clip(&w->qp, i, a, 1);
        const sp_real r = sp__abs(a - to) + SP_EPSILON * w->kkt.b[w->qp.n + i];
        sp__residual_add(out, r, sp__max(sp__abs(a), sp__abs(to)), w->E[i], w->Y[i]);
    }
}

/* |PX + q + A'Y| and, with |P| |X| in sizes (or NULL), what rounding may hide. Its price: |X|'|PX + q + A'Y|.
 * In passing Aty, objective = 1/2 X'PX + q'X and gap = X'PX + q'X. */
static void sp__qp_dual(sp__qp *w, const sp_real *sizes, sp__residual *out)
{
    sp_real xPx = 0, qx = 0, size;
    for (int32_t j = 0; j < w->qp.n; j++) {
        const sp_real q = sp__qp_q(&w->qp, j), p = w->Px[j], a = sp__qp_column(&w->qp, w->Y, j, &size), x = w->X[j];
        const sp_real most = sp__max(sp__abs(q), sp__max(sp__abs(p), sp__abs(a)));
        const sp_real hidden = sizes ? SP_EPSILON * (most + size + sizes[j]) : (sp_real)0;
        sp__residual_add(out, sp__abs(p + q + a) + hidden, most, w->c * w->D[j], x);
        w->Aty[j] = a;
        xPx += x * p;
        qx += x * q;
    }
    w->residual.objective = (sp_real)0.5 * xPx + qx;
    w->residual.gap = xPx + qx;
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
 * so near the solution |f(x) - f*| <= gap = max(|y|'|r|, |x'Px + q'x + u'y+ + l'y-| + |x|'|s|). Where terms cancel rounding may
 * hide a residual: u times their sizes counts as one. The right-hand side b is scratch. */
SP__NOINLINE static void sp__qp_residuals(sp__qp *w, const sp_real *z)
{
    const sp_qp *qp = &w->qp;
    sp__qp_residual *out = &w->residual;
    sp__residual primal = { 0, 0, 0, 0, 0 }, dual = primal;
    sp_real terms;
    sp__qp_A(qp, w->X, w->Ax, 0);
    sp__qp_A(qp, w->X, w->kkt.b + qp->n, 1);
    sp__qp_P(qp, w->X, w->Px, 0);
    sp__qp_P(qp, w->X, w->kkt.b, 1);
    sp__qp_primal(w, z, &primal);
    sp__qp_dual(w, w->kkt.b, &dual);
    out->primal = primal.r;
    out->dual = dual.r;
    out->rel_primal = sp__residual_relative(&primal);
    out->rel_dual = sp__residual_relative(&dual);
    out->off = sp__max(sp__residual_over_tol(w, &primal), sp__residual_over_tol(w, &dual));
    const sp_real open = sp__abs(out->gap + sp__qp_support(qp, w->Y, &terms)) + SP_EPSILON * terms + dual.price;
    out->gap = sp__max(primal.price, open);
    if (w->set.strict) out->off = sp__max(out->off, sp__qp_over_tol(w, out->gap, sp__abs(out->objective)));
    if (!(out->off < SP__NEVER) || !sp__finite(primal.price + open + out->objective)) out->off = SP__NEVER;
    w->cost.flops += 2 * w->cost.products + w->cost.vectors;
}

/* The iterate in the units of the data. */
static void sp__qp_unscale(sp__qp *w)
{
    sp__qp_scale(w->X, w->D, w->x, w->qp.n);
    for (int32_t i = 0; i < w->qp.m; i++) w->Y[i] = w->E[i] * w->y[i] / w->c;
}

#endif
#endif /* SP__QP_C */
