/* osqp_qp: hands a quadratic program to OSQP 1.x and its answer to the judge.                                 [seed 4.4]
 *
 * Both write min 1/2 x'Px + q'x, l <= Ax <= u with P as its upper triangle and columns in order; what differs is the size of
 * integers and numbers, what an infinity is, and that OSQP wants q and P even where they are 0.
 */
#include "osqp_qp.h"
#include "../host/qp_judge.h"

#include <osqp/osqp.h>

#include <stdlib.h>
#include <string.h>

typedef struct marshal {
    OSQPCscMatrix P, A;
    OSQPFloat *q, *l, *u, *x0, *y0;
    void *memory[11];
    int pieces;
} marshal;

static void *piece(marshal *d, size_t count, size_t size)
{
    void *p = calloc(count ? count : 1, size);
    if (p) d->memory[d->pieces++] = p;
    return p;
}

static OSQPFloat *numbers(marshal *d, const sp_real *v, int32_t n)
{
    OSQPFloat *out = piece(d, (size_t)n, sizeof *out);
    for (int32_t k = 0; out && v && k < n; k++) out[k] = (OSQPFloat)v[k];
    return out;
}

/* A bound, its infinities as OSQP's. */
static OSQPFloat bound(sp_real b)
{
    return !(b > -SP_QP_INFINITY) ? -OSQP_INFTY : !(b < SP_QP_INFINITY) ? OSQP_INFTY : (OSQPFloat)b;
}

/* A matrix of ours as one of theirs; p NULL: empty. */
static int matrix(marshal *d, OSQPCscMatrix *out, int32_t rows, int32_t cols, const int32_t *p, const int32_t *i,
                  const sp_real *x)
{
    const int32_t entries = p ? p[cols] : 0;
    OSQPInt *op = piece(d, (size_t)cols + 1, sizeof *op), *oi = piece(d, (size_t)entries, sizeof *oi);
    OSQPFloat *ox = numbers(d, x, entries);
    if (!op || !oi || !ox) return 0;
    for (int32_t j = 0; p && j <= cols; j++) op[j] = p[j];
    for (int32_t k = 0; k < entries; k++) oi[k] = i[k];
    OSQPCscMatrix_set_data(out, rows, cols, entries, ox, oi, op);
    return 1;
}

static int marshal_make(marshal *d, const sp_qp *qp, const sp_real *x0, const sp_real *y0)
{
    memset(d, 0, sizeof *d);
    if (!matrix(d, &d->P, qp->n, qp->n, qp->Pp, qp->Pi, qp->Px)) return 0;
    if (!matrix(d, &d->A, qp->m, qp->n, qp->m ? qp->Ap : NULL, qp->Ai, qp->Ax)) return 0;
    d->q = numbers(d, qp->q, qp->n);
    d->l = numbers(d, NULL, qp->m);
    d->u = numbers(d, NULL, qp->m);
    d->x0 = numbers(d, x0, qp->n);
    d->y0 = numbers(d, y0, qp->m);
    if (!d->q || !d->l || !d->u || !d->x0 || !d->y0) return 0;
    for (int32_t k = 0; k < qp->m; k++) {
        d->l[k] = bound(qp->l[k]);
        d->u[k] = bound(qp->u[k]);
    }
    return 1;
}

static void marshal_free(marshal *d)
{
    while (d->pieces) free(d->memory[--d->pieces]);
}

/* What counts as a certificate is as it was given. No polish yet, see run.                                   [seed 4.3, 4.4] */
static void settings_of(const sp_qp_settings *s, OSQPSettings *o)
{
    osqp_set_default_settings(o);
    o->verbose = 0;
    o->eps_abs = (OSQPFloat)s->eps_abs;
    o->eps_rel = (OSQPFloat)s->eps_rel;
    o->eps_prim_inf = (OSQPFloat)s->eps_pinf;
    o->eps_dual_inf = (OSQPFloat)s->eps_dinf;
    o->polishing = 0;
    o->max_iter = s->iterations;
    o->check_termination = s->check;
    o->scaling = s->passes;
    o->sigma = (OSQPFloat)s->sigma;
    o->alpha = (OSQPFloat)s->relax;
    o->rho = (OSQPFloat)s->rho;
}

/* By name: numbers changed from 0.6 to 1.0. What is not certain is an error.                                  [seed 4.4] */
sp_qp_status osqp_qp_claim(int status)
{
    switch (status) {
    case OSQP_SOLVED:             return SP_QP_SOLVED;
    case OSQP_SOLVED_INACCURATE:  return SP_QP_INACCURATE;
    case OSQP_PRIMAL_INFEASIBLE:  return SP_QP_PRIMAL_INFEASIBLE;
    case OSQP_DUAL_INFEASIBLE:    return SP_QP_DUAL_INFEASIBLE;
    case OSQP_MAX_ITER_REACHED:   return SP_QP_ITERATIONS;
    case OSQP_TIME_LIMIT_REACHED: return SP_QP_BUDGET;
    default:                      return SP_QP_NUMERICAL;
    }
}

/* setup's errors in our words */
static sp_status setup_status(OSQPInt error)
{
    switch (error) {
    case OSQP_NO_ERROR:                   return SP_OK;
    case OSQP_NONCVX_ERROR:               return SP_E_INDEFINITE;
    case OSQP_SETTINGS_VALIDATION_ERROR:  return SP_E_RANGE;
    case OSQP_DATA_VALIDATION_ERROR:      return SP_E_ARGUMENT;
    default:                              return SP_E_MEMORY;
    }
}

static void take(const OSQPFloat *from, sp_real *to, int32_t n)
{
    for (int32_t k = 0; k < n; k++) to[k] = (sp_real)from[k];
}

/* Does a row push? */
static int active(const OSQPSolution *s, int32_t m)
{
    for (int32_t i = 0; i < m; i++)
        if (s->y[i] > 1e-9 || s->y[i] < -1e-9) return 1;
    return 0;
}

/* Run, polish, and take x and y, or the certificate in their place. Without an active row there is nothing to polish, and OSQP
 * 1.0 says so on standard output, however quiet it was told to be: hence two runs, the second one from the end of the first. */
static sp_status run(OSQPSolver *solver, OSQPSettings *o, int polish, const sp_qp *qp, sp_real *x, sp_real *y,
                     sp_qp_status *claim, sp_qp_result *r)
{
    const OSQPSolution *s = solver->solution;
    if (osqp_solve(solver) != OSQP_NO_ERROR) return SP_E_MEMORY;
    r->iterations += (int32_t)solver->info->iter;
    r->factorisations += (int32_t)solver->info->rho_updates + 1;
    if (polish && solver->info->status_val == OSQP_SOLVED && active(s, qp->m)) {
        o->polishing = 1;
        if (osqp_update_settings(solver, o) || osqp_solve(solver) != OSQP_NO_ERROR) return SP_E_MEMORY;
        r->iterations += (int32_t)solver->info->iter;
        r->factorisations += (int32_t)solver->info->rho_updates + 1;
        r->polished = solver->info->status_polish == OSQP_POLISH_SUCCESS;
    }
    r->rho = (sp_real)solver->info->rho_estimate;
    if (solver->info->status_val == OSQP_NON_CVX) return SP_E_INDEFINITE;
    *claim = osqp_qp_claim((int)solver->info->status_val);
    take(*claim == SP_QP_DUAL_INFEASIBLE ? s->dual_inf_cert : s->x, x, qp->n);
    take(*claim == SP_QP_PRIMAL_INFEASIBLE ? s->prim_inf_cert : s->y, y, qp->m);
    return SP_OK;
}

/* Does the judge make a proof of this certificate? x and y stay as they are. */
static int proves(const sp_qp *qp, const sp_qp_settings *set, sp_qp_status claim, const sp_real *x, const sp_real *y)
{
    const size_t n = (size_t)qp->n, m = (size_t)qp->m;
    sp_real *v = malloc((n + m) * sizeof *v);
    sp_qp_result r;
    memset(&r, 0, sizeof r);
    if (!v) return 0;
    memcpy(v, x, n * sizeof *v);
    if (m) memcpy(v + n, y, m * sizeof *v);
    const int proved = qp_judge(qp, set, claim, v, v + n, &r) == SP_OK && r.status == claim;
    free(v);
    return proved;
}

/* One run from the caller's guess, certificates `sharp` times what was given. */
static sp_status once(const sp_qp *qp, const sp_qp_settings *set, double sharp, const sp_real *x0, const sp_real *y0,
                      sp_real *x, sp_real *y, sp_qp_status *claim, sp_qp_result *r)
{
    OSQPSettings o;
    OSQPSolver *solver = NULL;
    marshal d;
    sp_status status = marshal_make(&d, qp, x0, y0) ? SP_OK : SP_E_MEMORY;
    settings_of(set, &o);
    o.eps_prim_inf *= (OSQPFloat)sharp;
    o.eps_dual_inf *= (OSQPFloat)sharp;
    o.max_iter = set->iterations - r->iterations;
    if (status == SP_OK) status = setup_status(osqp_setup(&solver, &d.P, d.q, &d.A, d.l, d.u, qp->m, qp->n, &o));
    if (status == SP_OK && (x0 || y0)) osqp_warm_start(solver, d.x0, d.y0);
    if (status == SP_OK) status = run(solver, &o, set->polish, qp, x, y, claim, r);
    if (solver) osqp_cleanup(solver);
    marshal_free(&d);
    return status;
}

/* Certificates as given; where the judge can't make a proof of one, anew with the iterations that are left, for one a thousand
 * times sharper. */
static sp_status attempt(const sp_qp *qp, const sp_qp_settings *set, const sp_real *x0, const sp_real *y0,
                         sp_real *x, sp_real *y, sp_qp_status *claim, sp_qp_result *r)
{
    const sp_status status = once(qp, set, 1, x0, y0, x, y, claim, r);
    const int infeasible = *claim == SP_QP_PRIMAL_INFEASIBLE || *claim == SP_QP_DUAL_INFEASIBLE;
    if (status != SP_OK || !infeasible || r->iterations >= set->iterations || proves(qp, set, *claim, x, y)) return status;
    return once(qp, set, 1e-3, x0, y0, x, y, claim, r);
}

static sp_status solve(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, const sp_real *x0,
                       const sp_real *y0, sp_qp_result *result)
{
    (void)self;
    return qp_judge_solve(attempt, qp, settings, arena, x0, y0, result);
}

sp_qp_solver osqp_qp_solver(void)
{
    const sp_qp_solver s = { NULL, solve, qp_judge_need };
    return s;
}

const char *osqp_qp_version(void) { return osqp_version(); }
