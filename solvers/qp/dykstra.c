/* dykstra: quadratic programs by alternating projections, the seed's first solver, kept to be compared with.       [seed 4.1]
 *
 *     min 1/2 x'Px + q'x,  P diagonal,   subject to   l <= Ax <= u
 *
 * is the projection of -W^-1 q onto the constraints in the metric W = P + 1e-12 I. Projections onto the rows in turn, each
 * with what it pushed last time taken back first, and onto all equations at once, converge to it [Boyle, Dykstra 1986]:
 *
 *     row      s = a'x + y_i d_i,  d_i = a'W^-1 a        y_i <- (s - onto [l, u]) / d_i,   x follows
 *     E        x <- x - W^-1 Ae'(Ae W^-1 Ae' + 1e-12 I)^-1 (Ae x - b)                      y_e likewise
 *
 * so that x = -W^-1 (q + A'y) throughout. That factor knows nothing of the scale of rows: where one is lost in it, or x runs
 * away, the end is SP_QP_NUMERICAL. At most 500 rounds; it stops when x moves by less than 1e-8 of itself.
 *
 *   P q A l u       qp              as given
 *   W^-1, d         W d             n, m
 *   M = L L'        M               lower triangle by rows, one row an equation
 */
#ifndef SP__DYKSTRA_C
#define SP__DYKSTRA_C

#include "admm.c"

#if !defined(SP_NO_QP) && !defined(SP_NO_DYKSTRA)

enum { SP__DYKSTRA_ROUNDS = 500 };
#define SP__DYKSTRA_SMALL ((sp_real)1e-12)              /* regularisation */
#define SP__DYKSTRA_AWAY  ((sp_real)1e12)               /* x that much larger than at the start has run away */
#ifdef SP_REAL_FLOAT
#define SP__DYKSTRA_TOL   ((sp_real)1e-6)               /* what a float can tell of 1e-8 */
#define SP__DYKSTRA_LOST  ((sp_real)1e-5)
#else
#define SP__DYKSTRA_TOL   ((sp_real)1e-8)
#define SP__DYKSTRA_LOST  ((sp_real)1e-10)              /* a pivot below this part of its diagonal has lost its row */
#endif

#ifdef SP_SMALL
/* Dykstra's projections without rows of A by themselves and with equations one by one, on ADMM's work and by its judgement:
 * slower, and nearly dependent rows are not reported. */

/* Row i at x in X, its weight a W^-1 a' in *d; then x <- x - W^-1 a' t. */
static sp_real sp__dykstra_row(sp__qp *w, int32_t i, sp_real t, sp_real *d)
{
    const sp_qp *qp = &w->qp;
    sp_real s = 0;
    *d = 0;
    for (int32_t j = 0; j < qp->n; j++)
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
            if (qp->Ai[k] != i) continue;
            const sp_real a = qp->Ax[k], aw = a / w->x[j];
            s += a * w->X[j];
            *d += a * aw;
            w->X[j] -= t * aw;
        }
    return s;
}

static void sp__dykstra_round(sp__qp *w)
{
    for (int32_t i = 0; i < w->qp.m; i++) {
        sp_real d;
        const sp_real s = sp__dykstra_row(w, i, 0, &d) + w->Y[i] * d;
        if (!(d > 0)) continue;
        const sp_real t = (s - sp__qp_clip(&w->qp, i, s, 1)) / d - w->Y[i];
        w->Y[i] += t;
        sp__dykstra_row(w, i, t, &d);
    }
    w->cost.flops += w->cost.products * w->qp.m;
    w->iterations++;
}

static sp_qp_status sp__dykstra_run(sp__qp *w)
{
    const sp_qp *qp = &w->qp;
    if (sp__qp_entries(qp) != sp__qp_a0(qp, qp->n)) return SP_QP_NUMERICAL;
    for (int32_t j = 0; j < qp->n; j++) {
        const int32_t end = sp__qp_p0(qp, j + 1);
        w->x[j] = (end > sp__qp_p0(qp, j) ? qp->Px[end - 1] : 0) + SP__DYKSTRA_SMALL;
        w->X[j] = -sp__qp_q(qp, j) / w->x[j];
    }
    for (int32_t i = 0; i < qp->m; i++) w->Y[i] = 0;
    for (;;) {
        sp__dykstra_round(w);
        sp__qp_residuals(w, NULL);
        if (!(w->residual.off < SP__NEVER)) return SP_QP_NUMERICAL;
        const int last = w->iterations >= SP__DYKSTRA_ROUNDS || w->iterations >= w->set.iterations;
        if (w->residual.off <= (last ? (sp_real)1 : (sp_real)0.1)) return SP_QP_SOLVED;
        if (last || (w->set.budget > 0 && w->cost.flops >= w->set.budget))
            return w->residual.off <= (sp_real)10 ? SP_QP_INACCURATE : last ? SP_QP_ITERATIONS : SP_QP_BUDGET;
    }
}

static sp_status sp__dykstra_solve(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena,
                                   const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    sp_qp_work *w;
    (void)self; (void)x0; (void)y0;                     /* the point projected is no choice */
    if (!settings || !result) return SP_E_ARGUMENT;
    const sp_status status = sp_qp_setup(qp, settings, arena, &w);
    if (status) return status;
    memset(result, 0, sizeof *result);
    w->iterations = w->factorisations = 0;
    result->status = sp__dykstra_run(w);
    if (result->status == SP_QP_NUMERICAL) {
        memset(w->X, 0, (size_t)qp->n * sizeof *w->X);
        memset(w->Y, 0, (size_t)qp->m * sizeof *w->Y);
        sp__qp_residuals(w, NULL);
    }
    sp__qp_write_result(w, result);
    return SP_OK;
}

static sp_status sp__dykstra_need(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes)
{
    return sp__qp_admm_need(self, qp, settings, scratch, bytes);
}
#else
typedef struct sp__dykstra {
    const sp_qp *qp;
    int32_t equations;
    int32_t *rp, *ri;                   /* A by rows */
    sp_real *rx;
    int32_t *row;                       /* row of each equation */
    sp_real *W, *x, *last, *g;          /* n; last: x a round ago */
    sp_real *y, *d, *Ax;                /* m */
    sp_real *M, *t;                     /* t: an equation each */
    int64_t flops, round;               /* round: flops of one */
} sp__dykstra;

/* How many rows are equations. */
static int32_t sp__dykstra_equations(const sp_qp *qp)
{
    int32_t count = 0;
    for (int32_t i = 0; i < qp->m; i++) count += sp__qp_equation(qp, i);
    return count;
}

/* x and y come first: they are the result. */
static void sp__dykstra_carve(sp__dykstra *w, const sp_qp *qp, sp_arena *a)
{
    const size_t n = (size_t)qp->n, m = (size_t)qp->m, e = (size_t)sp__dykstra_equations(qp);
    w->x = sp__take(a, n, sizeof *w->x);
    w->y = sp__take(a, m, sizeof *w->y);
    w->rp = sp__take(a, m + 1, sizeof *w->rp);
    w->ri = sp__take(a, (size_t)sp__qp_a0(qp, qp->n), sizeof *w->ri);
    w->rx = sp__take(a, (size_t)sp__qp_a0(qp, qp->n), sizeof *w->rx);
    w->row = sp__take(a, e, sizeof *w->row);
    w->W = sp__take(a, n, sizeof *w->W);
    w->last = sp__take(a, n, sizeof *w->last);
    w->g = sp__take(a, n, sizeof *w->g);
    w->d = sp__take(a, m, sizeof *w->d);
    w->Ax = sp__take(a, m, sizeof *w->Ax);
    w->M = sp__take(a, e % 2 ? (e + 1) / 2 : e + 1, (e % 2 ? e : e / 2) * sizeof *w->M);
    w->t = sp__take(a, e, sizeof *w->t);
}

/* A by rows, columns ascending. */
static void sp__dykstra_rows(sp__dykstra *w)
{
    const sp_qp *qp = w->qp;
    memset(w->rp, 0, ((size_t)qp->m + 1) * sizeof *w->rp);
    for (int32_t k = 0; k < sp__qp_a0(qp, qp->n); k++) w->rp[qp->Ai[k] + 1]++;
    sp__ldl_sum(w->rp, qp->m);
    for (int32_t j = 0; j < qp->n; j++)
        for (int32_t k = sp__qp_a0(qp, j); k < sp__qp_a0(qp, j + 1); k++) {
            const int32_t to = w->rp[qp->Ai[k]]++;
            w->ri[to] = j;
            w->rx[to] = qp->Ax[k];
        }
    sp__ldl_back(w->rp, qp->m);
}

/* W^-1 and the start x = -W^-1 q.     returns 0 where P is not diagonal or not >= 0 */
static int sp__dykstra_start(sp__dykstra *w)
{
    const sp_qp *qp = w->qp;
    for (int32_t j = 0; j < qp->n; j++) {
        sp_real p = 0;
        for (int32_t k = sp__qp_p0(qp, j); k < sp__qp_p0(qp, j + 1); k++) {
            if (qp->Pi[k] == j) p = qp->Px[k];
            else if (sp__abs(qp->Px[k]) > 0) return 0;
        }
        if (p < 0) return 0;
        w->W[j] = (sp_real)1 / (p + SP__DYKSTRA_SMALL);
        w->x[j] = -w->W[j] * sp__qp_q(qp, j);
    }
    for (int32_t i = 0; i < qp->m; i++) {
        w->y[i] = w->d[i] = 0;
        for (int32_t k = w->rp[i]; k < w->rp[i + 1]; k++) w->d[i] += w->rx[k] * w->rx[k] * w->W[w->ri[k]];
    }
    return 1;
}

/* a_i x */
static sp_real sp__dykstra_ax(const sp__dykstra *w, int32_t i)
{
    sp_real s = 0;
    for (int32_t k = w->rp[i]; k < w->rp[i + 1]; k++) s += w->rx[k] * w->x[w->ri[k]];
    return s;
}

/* y_i += t, x -= W^-1 a_i t */
static void sp__dykstra_push(sp__dykstra *w, int32_t i, sp_real t)
{
    w->y[i] += t;
    for (int32_t k = w->rp[i]; k < w->rp[i + 1]; k++) w->x[w->ri[k]] -= t * w->W[w->ri[k]] * w->rx[k];
}

/* M = Ae W^-1 Ae' + 1e-12 I = L L'.     returns 0 where a row is lost in it */
static int sp__dykstra_factor(sp__dykstra *w)
{
    int32_t e = 0;
    for (int32_t i = 0; i < w->qp->m; i++) if (sp__qp_equation(w->qp, i)) w->row[e++] = i;
    w->equations = e;
    for (int32_t j = 0; j < w->qp->n; j++) w->g[j] = 0;
    for (int32_t r = 0; r < e; r++) {
        sp_real *to = w->M + (size_t)r * ((size_t)r + 1) / 2;
        const int32_t i = w->row[r];
        for (int32_t k = w->rp[i]; k < w->rp[i + 1]; k++) w->g[w->ri[k]] = w->W[w->ri[k]] * w->rx[k];
        for (int32_t s = 0; s <= r; s++) {
            to[s] = 0;
            for (int32_t k = w->rp[w->row[s]]; k < w->rp[w->row[s] + 1]; k++) to[s] += w->rx[k] * w->g[w->ri[k]];
        }
        to[r] += SP__DYKSTRA_SMALL;
        for (int32_t k = w->rp[i]; k < w->rp[i + 1]; k++) w->g[w->ri[k]] = 0;
    }
    sp__chol_factor(w->M, e, 0);
    w->flops += (int64_t)e * e * (e / 3 + 1);
    for (int32_t r = 0; r < e; r++) {
        const sp_real pivot = w->M[(size_t)r * ((size_t)r + 3) / 2], whole = w->d[w->row[r]];
        if (!(pivot < SP__NEVER && pivot * pivot > sp__max(SP__DYKSTRA_LOST * whole, 100 * SP__DYKSTRA_SMALL))) return 0;
    }
    return 1;
}

/* Every row once, then all equations.                                                              [Boyle, Dykstra 1986] */
static void sp__dykstra_round(sp__dykstra *w)
{
    const sp_qp *qp = w->qp;
    for (int32_t i = 0; i < qp->m; i++) {
        if (sp__qp_equation(qp, i) || !(w->d[i] > 0)) continue;
        const sp_real s = sp__dykstra_ax(w, i) + w->y[i] * w->d[i];
        const sp_real over = !sp__qp_no_u(qp, i) && s > qp->u[i] ? s - qp->u[i]
                           : !sp__qp_no_l(qp, i) && s < qp->l[i] ? s - qp->l[i] : 0;
        sp__dykstra_push(w, i, over / w->d[i] - w->y[i]);
    }
    for (int32_t r = 0; r < w->equations; r++) w->t[r] = sp__dykstra_ax(w, w->row[r]) - qp->l[w->row[r]];
    sp__chol_solve(w->M, w->equations, w->t);
    for (int32_t r = 0; r < w->equations; r++) sp__dykstra_push(w, w->row[r], w->t[r]);
    w->flops += w->round;
}

/* Residuals of x, y on the data; returns the larger in units of its tolerance.                                [seed 4.2] */
static sp_real sp__dykstra_residuals(sp__dykstra *w, const sp_qp_settings *set, sp_qp_result *out)
{
    const sp_qp *qp = w->qp;
    sp_real rows = 0, columns = 0, price = 0, moved = 0, terms, xPx = 0, qx = 0;
    out->primal = out->dual = 0;
    sp__qp_A(qp, w->x, w->Ax, 0);
    sp__qp_At(qp, w->y, w->g);
    for (int32_t i = 0; i < qp->m; i++) {
        const sp_real a = w->Ax[i], off = sp__max(sp__qp_no_u(qp, i) ? 0 : a - qp->u[i], sp__qp_no_l(qp, i) ? 0 : qp->l[i] - a);
        out->primal = sp__max(out->primal, off);
        price += sp__abs(w->y[i]) * sp__max(off, 0);
        rows = sp__max(rows, sp__abs(a));
    }
    for (int32_t j = 0; j < qp->n; j++) {
        const sp_real p = w->x[j] * ((sp_real)1 / w->W[j] - SP__DYKSTRA_SMALL), q = sp__qp_q(qp, j);
        out->dual = sp__max(out->dual, sp__abs(p + q + w->g[j]));
        columns = sp__max(columns, sp__max(sp__abs(p), sp__max(sp__abs(q), sp__abs(w->g[j]))));
        moved += sp__abs(w->x[j]) * sp__abs(p + q + w->g[j]);
        xPx += p * w->x[j];
        qx += q * w->x[j];
    }
    out->objective = (sp_real)0.5 * xPx + qx;
    out->gap = sp__max(price, sp__abs(xPx + qx + sp__qp_support(qp, w->y, &terms)) + moved);
    const sp_real off = sp__max(out->primal / (set->eps_abs + set->eps_rel * rows),
                                out->dual / (set->eps_abs + set->eps_rel * columns));
    return sp__finite(out->objective + out->gap + off) ? off : SP__NEVER;
}

/* Rounds until x rests, has run away, or the limits are reached. */
static sp_qp_status sp__dykstra_run(sp__dykstra *w, const sp_qp_settings *set, sp_qp_result *out)
{
    const size_t n = (size_t)w->qp->n;
    sp_real first = 1;
    for (;;) {
        memcpy(w->last, w->x, n * sizeof *w->x);
        sp__dykstra_round(w);
        out->iterations++;
        const sp_real size = sp__largest(w->x, w->qp->n);
        if (out->iterations == 1 && size > first) first = size;
        if (!(size < SP__DYKSTRA_AWAY * first) || !sp__finite(sp__largest(w->y, w->qp->m))) {
            memcpy(w->x, w->last, n * sizeof *w->x);
            return SP_QP_NUMERICAL;
        }
        for (size_t j = 0; j < n; j++) w->last[j] -= w->x[j];
        const int rests = sp__largest(w->last, w->qp->n) <= SP__DYKSTRA_TOL * sp__max((sp_real)1, size);
        const int last = out->iterations >= SP__DYKSTRA_ROUNDS || out->iterations >= set->iterations;
        const int spent = set->budget > 0 && w->flops >= set->budget;
        if (!rests && !last && !spent) continue;
        const sp_real off = sp__dykstra_residuals(w, set, out);
        if (off >= SP__NEVER) return SP_QP_NUMERICAL;
        if (rests && off <= (sp_real)1) return SP_QP_SOLVED;
        if (last || spent) return off <= (sp_real)10 ? SP_QP_INACCURATE : last ? SP_QP_ITERATIONS : SP_QP_BUDGET;
    }
}

static sp_status sp__dykstra_solve(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena,
                                   const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    (void)self; (void)x0; (void)y0;                     /* the point projected is no choice */
    if (!settings || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    const sp_status status = sp__qp_check(qp, settings);
    if (status != SP_OK) return status;
    sp_arena a = *arena;
    sp__dykstra *w = sp__take(&a, 1, sizeof *w);
    if (!w) return SP_E_MEMORY;
    memset(w, 0, sizeof *w);
    sp__dykstra_carve(w, qp, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    w->qp = qp;
    memset(result, 0, sizeof *result);
    sp__dykstra_rows(w);
    result->status = SP_QP_NUMERICAL;
    const int known = sp__dykstra_start(w);
    const int64_t e = sp__dykstra_equations(qp);
    w->round = 8 * (int64_t)sp__qp_a0(qp, qp->n) + 8 * (int64_t)qp->m + 2 * e * e + 2 * (int64_t)qp->n;
    if (known && sp__dykstra_factor(w)) result->status = sp__dykstra_run(w, settings, result);
    if (!known || !(sp__dykstra_residuals(w, settings, result) < SP__NEVER)) {
        memset(w->x, 0, (size_t)qp->n * sizeof *w->x);
        memset(w->y, 0, (size_t)qp->m * sizeof *w->y);
        result->objective = result->primal = result->dual = result->gap = 0;
    }
    result->x = w->x;
    result->y = w->y;
    result->factorisations = 1;
    result->flops = w->flops;
    *arena = a;
    return SP_OK;
}

static sp_status sp__dykstra_need(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes)
{
    (void)self; (void)scratch;
    if (!settings || !bytes) return SP_E_ARGUMENT;
    const sp_status status = sp__qp_check(qp, settings);
    if (status != SP_OK) return status;
    sp__dykstra w;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof w);
    sp__dykstra_carve(&w, qp, &dry);
    if (sp__failed(&dry)) return SP_E_MEMORY;
    *bytes = dry.used;
    return SP_OK;
}
#endif /* SP_SMALL */

SP_API sp_qp_solver sp_qp_dykstra(void)
{
    sp_qp_solver s;
    s.self = NULL;
    s.solve = sp__dykstra_solve;
    s.need = sp__dykstra_need;
    return s;
}

#endif /* SP_NO_DYKSTRA */

#endif /* SP__DYKSTRA_C */
