/* auglag: the last digits of a quadratic program by the method of multipliers.               [Hestenes 1969; Powell 1969]
 *
 * With a guess y of the multipliers
 *
 *     x <- least of  1/2 x'Px + q'x + sum_i R_i/2 dist^2(v_i, [l_i, u_i]),     v = Ax + y / R;     y <- R (v - v onto [l, u])
 *
 * The inner problem is convex and piecewise quadratic: Newton's method on the rows outside their bounds, with the exact step
 * along each direction [Hermans, Themelis, Patrinos 2019, "QPALM"]. Once the rows are the right ones each round is a step of
 * refinement of their KKT system, which is the polish of [OSQP, sec. 4]; until then it finds them where ADMM takes very long.
 * The linear systems are those of ADMM with rho = r on these rows and nothing on the others, so R_i = r E_i^2 / c here.
 *
 * X is the point, yc the guess, Y what follows from both: the gradient at X is PX + q + A'Y.
 * Without polish a run finds nothing.
 */
#ifndef SP__AUGLAG_C
#define SP__AUGLAG_C

#include "sharpen.c"

#if SP__WITH_QP
#if SP__WITH_QP_POLISH

#ifdef SP_REAL_FLOAT
#define SP__AUGLAG_MOST ((sp_real)1e3)                  /* largest r */
#else
#define SP__AUGLAG_MOST ((sp_real)1e8)
#endif
#define SP__AUGLAG_LITTLE ((sp_real)1e-6)                /* a step that stays where it is */
enum { SP__AUGLAG_ROUNDS = 2000, SP__AUGLAG_IDLE = 5, SP__AUGLAG_VAIN = 2 };

typedef struct sp__auglag {
    sp_real r, tol, violated, t;        /* penalty; where the inner problem ends; primal residual before; last step */
    sp_real best;                       /* how far off what is kept in x, y is */
    int32_t moved, full, stale;         /* rows came or went; the last step was a whole one; the factor is another's */
    int32_t idle, vain;                 /* steps that moved nothing; rounds that did not better what is kept */
} sp__auglag;

static sp_real sp__auglag_weight(const sp__qp *w, int32_t i, sp_real r) { return r * w->E[i] * w->E[i] / w->c; }

/* Y = R (v - v onto [l, u]) at X, and the products of both. Returns how many rows came in or went out. After a whole step t a
 * row that stays has Y + t nu from the linear system, which does not lose digits to R as the formula does. */
static int32_t sp__auglag_sides(sp__qp *w, const sp__auglag *g)
{
    const sp_qp *qp = &w->qp;
    const sp_real *guess = w->yc, *nu = w->kkt.s + qp->n;
    int32_t moved = 0;
    sp__qp_A(qp, w->X, w->Ax, 0);
    for (int32_t i = 0; i < qp->m; i++) {
        const sp_real R = sp__auglag_weight(w, i, g->r), v = w->Ax[i] + guess[i] / R, to = sp__qp_clip(qp, i, v, 1);
        const signed char side = v < to || v > to || sp__qp_equation(qp, i);
        if (g->full && side && w->side[i] == side) w->Y[i] += g->t * w->E[i] * nu[i] / w->c;
        else w->Y[i] = R * (v - to);
        moved += side != w->side[i];
        w->side[i] = side;
    }
    sp__qp_P(qp, w->X, w->Px, 0);
    w->cost.flops += w->cost.products + 9 * (int64_t)qp->m;
    return moved;
}

/* Newton's direction d (in xc): (P + sigma I + A_S' R A_S) d = -(Px + q + A'Y); Pd, Ad into b. */
static void sp__auglag_direction(sp__qp *w, sp__auglag *g)
{
    const int32_t n = w->qp.n, m = w->qp.m;
    sp_real *d = w->xc, *b = w->kkt.b;
    if (g->stale) {
        for (int32_t i = 0; i < m; i++) w->kkt.row[i] = w->side[i] ? g->r : (sp_real)0;
        w->kkt.sigma = SP__QP_DELTA;
        w->kkt.stale = 1;
        sp__kkt_factor(w);
        g->stale = 0;
    }
    for (int32_t j = 0; j < n; j++) b[j] = -w->c * w->D[j] * (w->Px[j] + w->Aty[j] + sp__qp_q(&w->qp, j));
    for (int32_t i = 0; i < m; i++) b[n + i] = 0;
    sp__kkt_solve(w, 1);
    for (int32_t j = 0; j < n; j++) d[j] = w->D[j] * w->kkt.s[j];
    sp__qp_P(&w->qp, d, b, 0);
    sp__qp_A(&w->qp, d, b + n, 0);
    w->cost.flops += w->cost.products + 6 * (int64_t)n;
}

/* Slope along d at X + t d: d'(P(x + td) + q) + (Ad)'R (v - v onto [l, u]). */
static sp_real sp__auglag_slope(sp__qp *w, sp_real r, sp_real t)
{
    const int32_t n = w->qp.n;
    const sp_real *d = w->xc, *Pd = w->kkt.b, *Ad = Pd + n, *guess = w->yc;
    sp_real s = 0;
    for (int32_t j = 0; j < n; j++) s += d[j] * (w->Px[j] + sp__qp_q(&w->qp, j) + t * Pd[j]);
    for (int32_t i = 0; i < w->qp.m; i++) {
        const sp_real R = sp__auglag_weight(w, i, r), v = w->Ax[i] + t * Ad[i] + guess[i] / R;
        s += Ad[i] * R * (v - sp__qp_clip(&w->qp, i, v, 1));
    }
    w->cost.flops += 5 * (int64_t)n + 11 * (int64_t)w->qp.m;
    return s;
}

/* The step where the slope, which rises in straight pieces, is 0 but for a hundredth: bracketed, then by secants and halves. */
SP__NOINLINE static sp_real sp__auglag_stride(sp__qp *w, sp_real r)
{
    const sp_real first = sp__auglag_slope(w, r, 0), enough = (sp_real)-0.01 * first;
    sp_real low = 0, high = (sp_real)1, below = first, above = sp__auglag_slope(w, r, high);
    for (int k = 0; k < 20 && above < -enough; k++) {
        low = high; below = above;
        high *= (sp_real)2;
        above = sp__auglag_slope(w, r, high);
    }
    if (!(above > enough)) return high;
    for (int k = 1; k < 40; k++) {
        const sp_real t = k % 3 ? low + (high - low) * (below / (below - above)) : (sp_real)0.5 * (low + high);
        const sp_real s = sp__auglag_slope(w, r, t);
        if (!(sp__abs(s) > enough)) return t;
        if (s < 0) { low = t; below = s; } else { high = t; above = s; }
    }
    return low;
}

/* X, Y to x, y; the iterate is not needed any more once they are good enough. */
static void sp__auglag_save(sp__qp *w)
{
    for (int32_t j = 0; j < w->qp.n; j++) w->x[j] = w->X[j];
    for (int32_t i = 0; i < w->qp.m; i++) w->y[i] = w->Y[i];
}

/* The point that was kept into X, Y.     returns 1, 0: none was */
static int sp__auglag_restore(sp__qp *w, const sp__auglag *g)
{
    if (!(g->best < SP__NEVER)) return 0;
    for (int32_t j = 0; j < w->qp.n; j++) w->X[j] = w->x[j];
    for (int32_t i = 0; i < w->qp.m; i++) w->Y[i] = w->y[i];
    sp__qp_residuals(w, NULL);
    return 1;
}

/* The inner problem is solved: judge X, Y. 1: there is nothing to gain by going on. 0: go on from the next guess; r grows where
 * the violation does not shrink by itself. */
static int sp__auglag_round(sp__qp *w, sp__auglag *g, sp_real off)
{
    sp__qp_residuals(w, NULL);
    if (!(w->residual.off < SP__NEVER)) return 1;
    if (w->residual.off <= off && w->residual.off < (sp_real)0.5 * g->best) {
        sp__auglag_save(w);
        g->best = w->residual.off;
        if (w->residual.off <= (sp_real)1e-8 * off) return 1;
    } else if (g->best < SP__NEVER && ++g->vain > SP__AUGLAG_VAIN) return 1;
    if (w->residual.primal > (sp_real)0.25 * g->violated && g->r < SP__AUGLAG_MOST) {
        g->r = sp__within((sp_real)10 * g->r, 1, SP__AUGLAG_MOST);
        g->stale = 1;
    }
    for (int32_t i = 0; i < w->qp.m; i++) w->yc[i] = w->Y[i];
    g->violated = w->residual.primal;
    g->tol = sp__max((sp_real)0.01 * w->residual.rel_dual, (sp_real)8 * SP_EPSILON);
    g->full = 0;
    return 0;
}

/* Nothing good enough was found; if X, Y are nearer than the iterate all the same, ADMM goes on from them. */
static void sp__auglag_hand_back(sp__qp *w, const sp__auglag *g, sp_real before)
{
    sp__auglag_sides(w, g);
    sp__qp_residuals(w, NULL);
    if (!(w->residual.off < (sp_real)0.1 * before)) return;
    for (int32_t j = 0; j < w->qp.n; j++) w->x[j] = w->X[j] / w->D[j];
    for (int32_t i = 0; i < w->qp.m; i++) {
        w->y[i] = w->c * w->Y[i] / w->E[i];
        w->z[i] = w->E[i] * sp__qp_clip(&w->qp, i, w->Ax[i], 1);
    }
}

/* The dual residual, relative; -1: it is not finite */
SP__NOINLINE static sp_real sp__auglag_dual(sp__qp *w)
{
    sp__residual dual = { 0, 0, 0, 0, 0 };
    sp__qp_dual(w, NULL, &dual);
    return sp__finite(dual.r) ? sp__residual_relative(&dual) : -1;
}

/* Look for a point within `off` of eps near the iterate, for at most about as much work as was done so far: 1 and X, Y judged,
 * or 0. */
SP__NOINLINE static int sp__auglag_run(sp__qp *w, sp_real off)
{
    sp__auglag g = { sp__within((sp_real)10 * w->kkt.rho, (sp_real)0.01, SP__AUGLAG_MOST), (sp_real)0.01, w->residual.primal, 0,
                     SP__NEVER, 0, 0, 1, 0, 0 };
    const int64_t step = w->cost.factoring + sp__kkt_solve_flops(w, 1) + 4 * w->cost.products +
                         700 * ((int64_t)w->qp.n + w->qp.m);
    const int64_t own = 2 * w->cost.flops + 10 * step, end = own < w->cost.limit ? own : w->cost.limit;
    const sp_real before = w->residual.off;
    sp__qp_unscale(w);
    for (int32_t i = 0; i < w->qp.m; i++) { w->yc[i] = w->Y[i]; w->side[i] = -1; }
    for (int round = 0; round < SP__AUGLAG_ROUNDS && end - w->cost.flops > step && g.idle < SP__AUGLAG_IDLE; round++) {
        g.moved = sp__auglag_sides(w, &g) > 0;
        g.stale |= g.moved;
        const sp_real dual = sp__auglag_dual(w);
        if (dual < 0) return sp__auglag_restore(w, &g);
        if (dual <= g.tol || (g.full && !g.moved)) {
            if (sp__auglag_round(w, &g, off)) return sp__auglag_restore(w, &g);
            continue;
        }
        sp__auglag_direction(w, &g);
        g.t = sp__auglag_stride(w, g.r);
        g.full = g.t > (sp_real)0.9 && g.t < (sp_real)1.1;
        g.idle = g.moved || g.t > SP__AUGLAG_LITTLE ? 0 : g.idle + 1;
        for (int32_t j = 0; j < w->qp.n; j++) w->X[j] += g.t * w->xc[j];
    }
    if (sp__auglag_restore(w, &g)) return 1;
    sp__auglag_hand_back(w, &g, before);
    return 0;
}

#else

static int sp__auglag_run(sp__qp *w, sp_real off) { return (void)w, (void)off, 0; }

#endif
#endif
#endif /* SP__AUGLAG_C */
