/* admm: quadratic programs by the alternating direction method of multipliers, and the public calls.
 *
 *     min 1/2 x'Px + q'x   subject to   Ax = z,  l <= z <= u                       [OSQP, alg. 1; seed 4.2, 4.3]
 *
 * Scale, factor, then: step, look; a look ends the run with a solution, a proof that there is none, or at a limit. Letters as
 * in qp.c. Linear systems: kkt.c. Proofs: certificate.c. Last digits: auglag.c. Before all this, by default: proximal.c.
 */
#ifndef SP__ADMM_C
#define SP__ADMM_C

#include "proximal.c"

#if SP__WITH_QP

/* ------------------------------------------------------------------------------------------------------------- iteration */

/* 1e3 rho on equations, the least on rows without bounds. */
static sp_real sp__qp_row_rho(const sp__qp *w, int32_t i)
{
    if (sp__qp_no_l(&w->qp, i) && sp__qp_no_u(&w->qp, i)) return SP__QP_RHO_LEAST;
    return sp__qp_equation(&w->qp, i) ? w->set.rho_equal * w->kkt.rho : w->kkt.rho;
}

/* Factor the KKT matrix anew, for the rho at hand. */
static void sp__qp_refactor(sp__qp *w)
{
    for (int32_t i = 0; i < w->qp.m; i++) w->kkt.row[i] = sp__qp_row_rho(w, i);
    w->kkt.sigma = w->set.sigma;
    sp__kkt_factor(w);
    w->kkt.stale = 0;
}

/* One over-relaxed iteration.                                                                  [OSQP, alg. 1, lines 3-7] */
static void sp__qp_step(sp__qp *w)
{
    const int32_t n = w->qp.n, m = w->qp.m;
    const sp_real a = w->set.relax;                     /* alpha in the paper */

    /* b = ( sigma x - q ; z - y/rho ) */
    for (int32_t j = 0; j < n; j++) w->kkt.b[j] = w->kkt.sigma * w->x[j] - w->c * w->D[j] * sp__qp_q(&w->qp, j);
    for (int32_t i = 0; i < m; i++) w->kkt.b[n + i] = w->z[i] - w->y[i] / w->kkt.row[i];
    sp__kkt_solve(w, 0);

    /* x <- a x~ + (1 - a) x */
    for (int32_t j = 0; j < n; j++) w->x[j] = a * w->kkt.s[j] + ((sp_real)1 - a) * w->x[j];

    /* z~ = z + (nu - y)/rho;  v = a z~ + (1 - a) z + y/rho;  z <- v onto [l, u];  y <- rho (v - z) */
    for (int32_t i = 0; i < m; i++) {
        const sp_real r = w->kkt.row[i], zt = w->z[i] + (w->kkt.s[n + i] - w->y[i]) / r;
        const sp_real v = a * zt + ((sp_real)1 - a) * w->z[i] + w->y[i] / r;
        w->z[i] = sp__qp_clip(&w->qp, i, v, w->E[i]);
        w->y[i] = r * (v - w->z[i]);
    }
    w->cost.flops += w->cost.vectors;
}

static int64_t sp__qp_step_flops(const sp__qp *w)
{
    return sp__kkt_solve_flops(w, 0) + w->cost.vectors;
}

/* rho by what is further off, in equilibrated units.                                       [seed 4.2; OSQP, sec. 5.2] */
static void sp__qp_adapt(sp__qp *w)
{
    sp_real rho = w->kkt.rho;
    if (w->changes >= w->set.adapt_most) return;
    if (w->residual.rel_primal > (sp_real)10 * w->residual.rel_dual) rho *= w->set.adapt_factor;
    else if (w->residual.rel_dual > (sp_real)10 * w->residual.rel_primal) rho /= w->set.adapt_factor;
    rho = sp__within(rho, SP__QP_RHO_LEAST, SP__QP_RHO_MOST);
    if (!(rho < w->kkt.rho) && !(rho > w->kkt.rho)) return;
    w->kkt.rho = rho;
    w->changes++;
    w->kkt.stale = 1;
}

/* --------------------------------------------------------------------------------------------------------------- the run */

/* Flops a look at the iterate may take, and what stops short of the budget must leave. */
static int64_t sp__qp_decide_flops(const sp__qp *w)
{
    return 8 * w->cost.products + 50 * w->cost.vectors;
}

/* Iterations that are left to ADMM. */
static int32_t sp__qp_most(const sp__qp *w) { return w->set.iterations - sp__proximal_steps(w); }

/* Iterate until the next look, as far as the budget goes. Returns whether it went that far. */
static int sp__qp_advance(sp__qp *w)
{
    memcpy(w->xc, w->x, (size_t)w->qp.n * sizeof *w->x);
    memcpy(w->yc, w->y, (size_t)w->qp.m * sizeof *w->y);
    if (w->kkt.stale) {
        if (w->cost.factoring + sp__qp_step_flops(w) > w->cost.limit - w->cost.flops) return 0;
        sp__qp_refactor(w);
    }
    for (int32_t k = 0; k < w->set.check && w->iterations < sp__qp_most(w); k++, w->iterations++) {
        if (sp__qp_step_flops(w) > w->cost.limit - w->cost.flops) return 0;
        sp__qp_step(w);
    }
    return 1;
}

/* One look at the iterate: 1 and a status when the run is over. The costly attempts come at 100, 200, 400 .. iterations. */
static int sp__qp_decide(sp__qp *w, int spent, sp_qp_result *out)
{
    const int last = w->iterations >= sp__qp_most(w);
    const int32_t k = w->iterations / 100;
    sp__qp_unscale(w);
    sp__qp_residuals(w, w->z);
    const sp_real off = w->residual.off;
    if (!(off < SP__NEVER)) {
        memcpy(w->x, w->xc, (size_t)w->qp.n * sizeof *w->x);            /* back to the one before */
        memcpy(w->y, w->yc, (size_t)w->qp.m * sizeof *w->y);
        out->status = SP_QP_NUMERICAL;
        return 1;
    }
    const int solved = off <= (sp_real)1, doubled = w->iterations == 100 * k && (k & (k - 1)) == 0;
    const int hard = !spent && (solved || last || doubled);
    if (!solved) {
        if (!last && w->set.adapt > 0 && w->iterations % w->set.adapt == 0) sp__qp_adapt(w);
        if (sp__qp_proof_found(w, hard && w->set.polish, out)) return 1;
    }
    out->status = SP_QP_SOLVED;
    if (hard && w->set.polish && sp__auglag_run(w, solved ? off : (sp_real)1)) return out->polished = 1;
    out->status = solved ? SP_QP_SOLVED : off <= (sp_real)10 ? SP_QP_INACCURATE : last ? SP_QP_ITERATIONS : SP_QP_BUDGET;
    return solved || last || spent;
}

/* Numbers that left the range of sp_real become 0. */
static void sp__qp_zero_infinite(sp_real *v, int32_t n)
{
    for (int32_t k = 0; k < n; k++)
        if (!sp__finite(v[k])) v[k] = 0;
}

static sp_real sp__qp_finite(sp_real x) { return sp__finite(x) ? x : SP__NEVER; }

static void sp__qp_write_result(const sp__qp *w, sp_qp_result *out)
{
    out->x = w->X;
    out->y = w->Y;
    out->objective = sp__qp_finite(w->residual.objective);
    out->primal = sp__qp_finite(w->residual.primal);
    out->dual = sp__qp_finite(w->residual.dual);
    out->gap = sp__qp_finite(w->residual.gap);
    out->rho = w->kkt.rho;
    out->iterations = w->iterations + sp__proximal_steps(w);
    out->factorisations = w->factorisations;
    out->flops = w->cost.flops;
}

/* Complete the result, of a point or of a certificate. No NaN leaves. */
static void sp__qp_finish(sp__qp *w, sp_qp_result *out)
{
    if (out->status == SP_QP_PRIMAL_INFEASIBLE) memset(w->X, 0, (size_t)w->qp.n * sizeof *w->X);
    else if (out->status == SP_QP_DUAL_INFEASIBLE) memset(w->Y, 0, (size_t)w->qp.m * sizeof *w->Y);
    else if (!out->polished) {
        sp__qp_unscale(w);
        sp__qp_zero_infinite(w->X, w->qp.n);
        sp__qp_zero_infinite(w->Y, w->qp.m);
        sp__qp_residuals(w, out->status == SP_QP_NUMERICAL ? NULL : w->z);
    }
    sp__qp_write_result(w, out);
}

/* x <- x0 / D, y <- c y0 / E but for bounds that are not there, z <- Ax onto [l, u]; s: a guess for conjugate gradients. */
static void sp__qp_start(sp__qp *w, const sp_real *x0, const sp_real *y0)
{
    for (int32_t j = 0; j < w->qp.n; j++) w->X[j] = x0 ? x0[j] : (sp_real)0;
    for (int32_t i = 0; i < w->qp.m; i++) {
        const sp_real y = y0 ? y0[i] : (sp_real)0;
        w->y[i] = sp__qp_no_bound(&w->qp, i, y) ? (sp_real)0 : w->c * y / w->E[i];
    }
    sp__qp_A(&w->qp, w->X, w->Ax, 0);
    for (int32_t j = 0; j < w->qp.n; j++) w->x[j] = w->kkt.s[j] = w->X[j] / w->D[j];
    for (int32_t i = 0; i < w->qp.m; i++) w->z[i] = sp__qp_clip(&w->qp, i, w->E[i] * w->Ax[i], w->E[i]);
}

static void sp__qp_iterate(sp__qp *w, sp_qp_result *out)
{
    int spent;
    memset(out, 0, sizeof *out);
    w->cost.flops = 0;
    w->factorisations = w->iterations = w->changes = 0;
    w->cost.limit = w->set.budget > 0 ? w->set.budget - 2 * sp__qp_decide_flops(w) : INT64_MAX / 4;
    do {
        if (sp__proximal_due(w)) {
            if (sp__proximal_run(w, out) || sp__proximal_finish(w, out)) break;
            sp__qp_start(w, NULL, NULL);
        }
        spent = !sp__qp_advance(w);
    } while (!sp__qp_decide(w, spent, out));
    sp__proximal_prefer(w, out);
    sp__qp_finish(w, out);
}

/* ------------------------------------------------------------------------------------------------------------ arguments */

static sp_status sp__qp_check_matrix(const int32_t *p, const int32_t *i, const sp_real *x, int32_t rows, int32_t cols,
                                     int upper)
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

static sp_status sp__qp_check_vectors(const sp_qp *qp)
{
    if (qp->m > 0 && (!qp->l || !qp->u)) return SP_E_ARGUMENT;
    if (!sp__qp_numbers(qp->q, qp->n)) return SP_E_NOT_FINITE;
    for (int32_t i = 0; i < qp->m; i++) {
        if (!(qp->l[i] <= qp->u[i])) return qp->l[i] > qp->u[i] ? SP_E_RANGE : SP_E_NOT_FINITE;
        if (!(qp->l[i] < SP_QP_INFINITY) || !(qp->u[i] > -SP_QP_INFINITY)) return SP_E_RANGE;
    }
    return SP_OK;
}

/* Do they ask for what this build leaves out? */
static int sp__qp_settings_unsupported(const sp_qp_settings *s)
{
    if (!SP__WITH_QP_INTERIOR && !SP__WITH_SMALL && s->method == SP_QP_INTERIOR) return 1;
    return (!SP__WITH_QP_CG && !SP__WITH_SMALL && s->backend == SP_QP_CG) || (!SP__WITH_QP_POLISH && s->polish);
}

static int sp__qp_settings_fit(const sp_qp_settings *s)
{
    if (s->backend != SP_QP_SPARSE && s->backend != SP_QP_DENSE && s->backend != SP_QP_CG) return 0;
    if (SP__WITH_QP_INTERIOR && s->method != SP_QP_ADMM && s->method != SP_QP_INTERIOR && s->method != SP_QP_AUTO) return 0;
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
    if (sp__qp_settings_unsupported(set)) return SP_E_UNSUPPORTED;
    if (!sp__qp_settings_fit(set)) return SP_E_RANGE;
    if (qp->n > INT32_MAX / 2 - qp->m) return SP_E_MEMORY;
    sp_status status = SP_OK;
    if (qp->Pp || qp->Pi || qp->Px) status = sp__qp_check_matrix(qp->Pp, qp->Pi, qp->Px, qp->n, qp->n, 1);
    if (status == SP_OK && qp->m > 0) status = sp__qp_check_matrix(qp->Ap, qp->Ai, qp->Ax, qp->m, qp->n, 0);
    return status == SP_OK ? sp__qp_check_vectors(qp) : status;
}

/* Entries of the KKT matrix off its diagonal, one triangle; -1: too many. */
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

/* Is P semidefinite? A diagonal one shows; of others cDPD + shift I has a factor, the shift above what rounding can do. */
SP__NOINLINE_SMALL static int sp__qp_semidefinite(sp__qp *w)
{
    const int diagonal = sp__qp_entries(&w->qp) == sp__qp_a0(&w->qp, w->qp.n);
    for (int32_t j = 0; diagonal && j < w->qp.n; j++)
        if (sp__qp_diagonal(w, j) < 0) return 0;
    if (diagonal) return 1;
    for (int32_t i = 0; i < w->qp.m; i++) w->kkt.row[i] = 0;
    sp__ruiz_norms_P(&w->qp, w->D, w->c, w->kkt.b);
    const sp_real largest = sp__largest(w->kkt.b, w->qp.n);
    if (!(largest > 0)) return 1;                       /* it stores zeros */
    w->kkt.sigma = largest * ((sp_real)1e-9 + (sp_real)4 * SP_EPSILON * (sp_real)w->qp.n);
    sp__kkt_factor(w);
    if (SP__WITH_QP_CG && sp__qp_backend(&w->set) == SP_QP_CG) return sp__kkt_cg_semidefinite(w);
    return w->kkt.broken == 0;
}

/* --------------------------------------------------------------------------------------------------------------- memory */

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
    sp__order_carve(&o, f->n, 2 * f->entries, 0, a);
}

/* Everything but the factor of the sparse back end, in the order of sp__qp_bytes. NULL: it does not fit. */
SP__NOINLINE static sp__qp *sp__qp_carve(const sp_qp *qp, sp_qp_backend backend, sp_arena *a)
{
    sp_real *p[SP__QP_VECTORS];
    sp__qp *w = sp__qp_carve_vectors(qp, p, a);
    if (sp__failed(a)) return NULL;
    memset(w, 0, sizeof *w);
    w->D = p[0]; w->x = p[1]; w->xc = p[2]; w->X = p[3]; w->Px = p[4]; w->Aty = p[5];
    w->E = p[6]; w->kkt.row = p[7]; w->z = p[8]; w->y = p[9]; w->yc = p[10]; w->Y = p[11]; w->Ax = p[12];
    w->kkt.b = p[13]; w->kkt.s = p[14];
    if (SP__WITH_QP_POLISH) w->side = sp__take(a, (size_t)qp->m, 1);
    if (backend == SP_QP_SPARSE) sp__ldl_carve(&w->kkt.ldl, qp->n + qp->m, qp->n, sp__qp_entries(qp), a);
    else if (backend == SP_QP_DENSE) w->kkt.M = sp__qp_carve_dense(qp, a);
    else sp__kkt_carve_cg(qp, w, a);
    return sp__failed(a) ? NULL : w;
}

/* Bytes of everything for n, m of *qp and so many `entries`, the factor having `fill`, for interior points, too, or not; 0: too
 * many. */
SP__NOINLINE static size_t sp__qp_bytes(const sp_qp *qp, int32_t entries, sp_qp_backend backend, int32_t fill, int interior)
{
    sp_arena a = sp__arena_dry();
    if (entries < 0) return 0;
    sp__qp_carve_vectors(qp, NULL, &a);
    if (SP__WITH_QP_POLISH) sp__take(&a, (size_t)qp->m, 1);
    if (backend == SP_QP_SPARSE) {
        sp__ldl f;
        sp__ldl_carve(&f, qp->n + qp->m, qp->n, entries, &a);
        sp_arena symbolic = a;
        sp__qp_carve_symbolic(&f, &symbolic);
        sp__ldl_carve_factor(&f, fill, &a);
        if (interior) sp__proximal_carve(NULL, qp, &a);
        if (sp__failed(&symbolic) || symbolic.used > a.used) a = symbolic;
    } else if (backend == SP_QP_DENSE) {
        sp__qp_carve_dense(qp, &a);
        if (interior) sp__proximal_carve(NULL, qp, &a);
    } else sp__kkt_carve_cg(qp, NULL, &a);
    return sp__failed(&a) ? 0 : a.used;
}

/* Place the work in the arena, find the scales and run the symbolic step; *fill: entries of the factor. NULL: no room. */
SP__NOINLINE static sp__qp *sp__qp_open(const sp_qp *qp, const sp_qp_settings *set, sp_arena *a, int32_t *fill)
{
    if (sp__qp_entries(qp) < 0) return NULL;
    sp__qp *w = sp__qp_carve(qp, sp__qp_backend(set), a);
    if (!w) return NULL;
    w->qp = *qp;
    w->set = *set;
    w->kkt.rho = set->rho;
    w->kkt.stale = 1;
    w->cost.products = 4 * ((int64_t)sp__qp_entries(qp) + qp->n) + 2 * (int64_t)sp__qp_a0(qp, qp->n);
    w->cost.vectors = 14 * ((int64_t)qp->n + qp->m);
    w->cost.factoring = w->cost.products;
    if (sp__qp_backend(set) == SP_QP_DENSE) w->cost.factoring = qp->n * (w->cost.products + (int64_t)qp->n * (qp->n / 3 + 1));
    w->c = sp__ruiz(qp, set->passes, w->D, w->E, w->kkt.b, w->kkt.b + qp->n);
    *fill = 0;
    if (sp__qp_backend(set) != SP_QP_SPARSE) return w;
    sp_arena symbolic = *a;
    sp__qp_carve_symbolic(&w->kkt.ldl, &symbolic);
    if (sp__failed(&symbolic)) return NULL;
    if (symbolic.peak > a->peak) a->peak = symbolic.peak;
    *fill = sp__ldl_analyse(&w->kkt.ldl, sp__kkt_walk, w, *a);
    w->cost.factoring = w->kkt.ldl.flops;
    return *fill < 0 ? NULL : w;
}

/* ------------------------------------------------------------------------------------------------------------ public calls */

static const sp_qp_settings sp__qp_usual = {
    .backend = SP_QP_SPARSE, .method = SP_QP_AUTO,
#ifdef SP_REAL_FLOAT
    .eps_abs = (sp_real)1e-4, .eps_rel = (sp_real)1e-4, .eps_pinf = (sp_real)1e-4, .eps_dinf = (sp_real)1e-4,
    .radius = (sp_real)1e3,
#else
    .eps_abs = 1e-6, .eps_rel = 1e-5, .eps_pinf = 1e-4, .eps_dinf = 1e-4, .radius = 1e6,
#endif
    .strict = 1,
    .polish = SP__WITH_QP_POLISH,
    .iterations = 8000, .check = 10, .passes = 10,
#ifdef SP_REAL_FLOAT
    .sigma = (sp_real)1e-3,                             /* below 64 u x the largest penalty pivots drown */
    .relax = (sp_real)1.6, .rho = (sp_real)0.1, .rho_equal = (sp_real)1e2,
#else
    .sigma = 1e-6, .relax = 1.6, .rho = 0.1, .rho_equal = 1e3,
#endif
    .adapt = 100, .adapt_most = 10, .adapt_factor = (sp_real)5, .cg_steps = 250,
    .cg_tol = sizeof(sp_real) == 4 ? (sp_real)1e-6 : (sp_real)1e-10
};

SP_API sp_qp_settings sp_qp_default(void)
{
    sp_qp_settings s;
    memcpy(&s, &sp__qp_usual, sizeof s);                /* a call, where an assignment is written out */
    return s;
}

SP_API size_t sp_qp_memory_scratch(const sp_qp *qp, const sp_qp_settings *settings)
{
    const sp_qp_settings *set = settings ? settings : &sp__qp_usual;
    return sp__qp_check(qp, set) == SP_OK ? sp__qp_bytes(qp, sp__qp_entries(qp), sp__qp_backend(set), 0, 0) : 0;
}

/* sp_qp_memory, sp_qp_setup and sp_qp_solve by this method, whatever settings say: a copy of those takes much of a stack. */
#define SP__AS_SET  (-1)
#define SP__BY_ADMM (SP__WITH_QP_INTERIOR ? (int)SP_QP_ADMM : SP__AS_SET)

static sp_status sp__qp_memory_by(const sp_qp *qp, const sp_qp_settings *settings, int method, sp_arena scratch,
                                  size_t *bytes)
{
    const sp_qp_settings *set = settings ? settings : &sp__qp_usual;
    const sp_status status = sp__qp_check(qp, set);
    int32_t fill = 0;
    if (status != SP_OK || !bytes) return status == SP_OK ? SP_E_ARGUMENT : status;
    if (sp__qp_backend(set) == SP_QP_SPARSE) {
        if (!scratch.base) return SP_E_ARGUMENT;
        if (!sp__qp_open(qp, set, &scratch, &fill)) return SP_E_MEMORY;
    }
    const size_t need = sp__qp_bytes(qp, sp__qp_entries(qp), sp__qp_backend(set), fill, sp__proximal_used(set, method));
    if (need == 0) return SP_E_MEMORY;
    *bytes = need;
    return SP_OK;
}

SP_API sp_status sp_qp_memory(const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes)
{
    return sp__qp_memory_by(qp, settings, SP__AS_SET, scratch, bytes);
}

static sp_status sp__qp_setup_by(const sp_qp *qp, const sp_qp_settings *settings, int method, sp_arena *arena,
                                 sp_qp_work **work)
{
    const sp_qp_settings *set = settings ? settings : &sp__qp_usual;
    const sp_status status = sp__qp_check(qp, set);
    if (status != SP_OK || !arena || !arena->base || !work) return status == SP_OK ? SP_E_ARGUMENT : status;
    sp_arena a = *arena;
    int32_t fill;
    sp__qp *w = sp__qp_open(qp, set, &a, &fill);
    if (!w) return SP_E_MEMORY;
    if (sp__qp_backend(set) == SP_QP_SPARSE) sp__ldl_carve_factor(&w->kkt.ldl, fill, &a);
    if (sp__proximal_used(set, method)) sp__proximal_carve(w, qp, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    if (!sp__finite(w->c) || !sp__qp_numbers(w->D, qp->n) || !sp__qp_numbers(w->E, qp->m)) return SP_E_NOT_FINITE;
    if (!sp__qp_semidefinite(w)) return SP_E_INDEFINITE;
    *arena = a;
    *work = w;
    sp__proximal_choose(w, method);
    return SP_OK;
}

SP_API sp_status sp_qp_setup(const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, sp_qp_work **work)
{
    return sp__qp_setup_by(qp, settings, SP__AS_SET, arena, work);
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
    if (status != SP_OK || work->kkt.stale) return status;
    for (int32_t i = 0; i < before.m; i++) {
        const sp_real r = sp__qp_row_rho(work, i);
        if (r < work->kkt.row[i] || r > work->kkt.row[i]) work->kkt.stale = 1;
    }
    return SP_OK;
}

SP_API sp_status sp_qp_rho(sp_qp_work *work, sp_real rho)
{
    if (!work) return SP_E_ARGUMENT;
    if (!(rho >= SP__QP_RHO_LEAST && rho <= SP__QP_RHO_MOST)) return SP_E_RANGE;
    if (rho < work->kkt.rho || rho > work->kkt.rho) work->kkt.stale = 1;
    work->kkt.rho = rho;
    return SP_OK;
}

SP_API sp_status sp_qp_run(sp_qp_work *work, const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    if (!work || !result) return SP_E_ARGUMENT;
    if (!sp__qp_numbers(x0, work->qp.n) || !sp__qp_numbers(y0, work->qp.m)) return SP_E_NOT_FINITE;
    sp__qp_start(work, x0, y0);
    sp__proximal_begin(work, x0 || y0);
    sp__qp_iterate(work, result);
    return SP_OK;
}

static sp_status sp__qp_solve_by(const sp_qp *qp, const sp_qp_settings *set, int method, sp_arena *arena,
                                 const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    sp_qp_work *work;
    sp_arena a;
    if (!arena || !result) return SP_E_ARGUMENT;
    a = *arena;
    sp_status status = sp__qp_setup_by(qp, set, method, &a, &work);
    if (status == SP_OK) status = sp_qp_run(work, x0, y0, result);
    if (status == SP_OK) *arena = a;
    return status;
}

SP_API sp_status sp_qp_solve(const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, const sp_real *x0,
                             const sp_real *y0, sp_qp_result *result)
{
    return sp__qp_solve_by(qp, settings, SP__AS_SET, arena, x0, y0, result);
}

static sp_status sp__qp_admm_solve(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena,
                                   const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    (void)self;
    return sp__qp_solve_by(qp, settings, SP__BY_ADMM, arena, x0, y0, result);
}

static sp_status sp__qp_admm_need(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes)
{
    (void)self;
    return sp__qp_memory_by(qp, settings, SP__BY_ADMM, scratch, bytes);
}

SP_API sp_qp_solver sp_qp_admm(void)
{
    sp_qp_solver s;
    s.self = NULL;
    s.solve = sp__qp_admm_solve;
    s.need = sp__qp_admm_need;
    return s;
}

#if SP__WITH_QP_INTERIOR
static sp_status sp__qp_interior_solve(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena,
                                       const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    (void)self;
    return sp__qp_solve_by(qp, settings, SP_QP_INTERIOR, arena, x0, y0, result);
}

static sp_status sp__qp_interior_need(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch,
                                      size_t *bytes)
{
    (void)self;
    return sp__qp_memory_by(qp, settings, SP_QP_INTERIOR, scratch, bytes);
}

SP_API sp_qp_solver sp_qp_interior(void)
{
    sp_qp_solver s;
    s.self = NULL;
    s.solve = sp__qp_interior_solve;
    s.need = sp__qp_interior_need;
    return s;
}
#endif

#endif
#endif /* SP__ADMM_C */
