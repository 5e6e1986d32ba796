/* ipopt_qp: hands a quadratic program to Ipopt and its answer to the judge.
 *
 * Ipopt minimises f(x) with g_l <= g(x) <= g_u; here f = 1/2 x'Px + q'x and g = Ax, whose derivatives are constant. Its
 * multipliers have our sign: grad f + A'y = 0. It knows no certificates:
 *
 *   infeasible   a second program that always has a solution, min 1/2 |s|^2 with l <= Ax + s <= u: where s is not 0 its
 *                multipliers are one, A'y = 0 and s = -y                                                      [Farkas]
 *   unbounded    the point it was at when it diverged, as a direction
 */
#include "ipopt_qp.h"
#include "../host/qp_judge.h"
#include "ipopt_count.h"

#include <IpoptConfig.h>

#include <stdlib.h>
#include <string.h>

typedef struct entry { Index i, j; Number x; } entry;

typedef struct program {
    Index iterations;                   /* first: ipopt_count */
    Index n, m, in_P, in_A;
    entry *P, *A;                       /* P: j <= i */
    Number *q, *l, *u;
    Number *x, *y;
    void *memory[7];
    int pieces;
} program;

static void *piece(program *p, size_t count, size_t size)
{
    void *v = calloc(count ? count : 1, size);
    if (v) p->memory[p->pieces++] = v;
    return v;
}

static void program_free(program *p)
{
    while (p->pieces) free(p->memory[--p->pieces]);
}

static int program_room(program *p, Index n, Index m, Index in_P, Index in_A)
{
    memset(p, 0, sizeof *p);
    p->n = n;
    p->m = m;
    p->in_P = in_P;
    p->in_A = in_A;
    return (p->P = piece(p, (size_t)in_P, sizeof *p->P)) && (p->A = piece(p, (size_t)in_A, sizeof *p->A)) &&
           (p->q = piece(p, (size_t)n, sizeof *p->q)) && (p->l = piece(p, (size_t)m, sizeof *p->l)) &&
           (p->u = piece(p, (size_t)m, sizeof *p->u)) && (p->x = piece(p, (size_t)n, sizeof *p->x)) &&
           (p->y = piece(p, (size_t)m, sizeof *p->y));
}

static int program_make(program *p, const sp_qp *qp)
{
    const Index in_P = qp->Pp ? qp->Pp[qp->n] : 0, in_A = qp->m ? qp->Ap[qp->n] : 0;
    if (!program_room(p, qp->n, qp->m, in_P, in_A)) return 0;
    for (Index j = 0; j < qp->n; j++) {
        for (Index k = qp->Pp ? qp->Pp[j] : 0; k < (qp->Pp ? qp->Pp[j + 1] : 0); k++) {
            p->P[k].i = j;
            p->P[k].j = qp->Pi[k];
            p->P[k].x = (Number)qp->Px[k];
        }
        for (Index k = qp->m ? qp->Ap[j] : 0; k < (qp->m ? qp->Ap[j + 1] : 0); k++) {
            p->A[k].i = qp->Ai[k];
            p->A[k].j = j;
            p->A[k].x = (Number)qp->Ax[k];
        }
        p->q[j] = qp->q ? (Number)qp->q[j] : 0;
    }
    for (Index i = 0; i < qp->m; i++) {
        p->l[i] = (Number)qp->l[i];
        p->u[i] = (Number)qp->u[i];
    }
    return 1;
}

/* min 1/2 |s|^2,  l <= Ax + s <= u */
static int program_phase_one(program *p, const program *from)
{
    const Index n = from->n, m = from->m;
    if (!program_room(p, n + m, m, m, from->in_A + m)) return 0;
    memcpy(p->A, from->A, (size_t)from->in_A * sizeof *p->A);
    for (Index i = 0; i < m; i++) {
        const entry s = { i, n + i, 1 }, one = { n + i, n + i, 1 };
        p->A[from->in_A + i] = s;
        p->P[i] = one;
        p->l[i] = from->l[i];
        p->u[i] = from->u[i];
    }
    return 1;
}

/* ------------------------------------------------------------------------------------------------------- what Ipopt asks */

static Bool value(Index n, Number *x, Bool new_x, Number *f, UserDataPtr user)
{
    const program *p = user;
    Number s = 0;
    (void)new_x;
    for (Index j = 0; j < n; j++) s += p->q[j] * x[j];
    for (Index k = 0; k < p->in_P; k++) s += (p->P[k].i == p->P[k].j ? 0.5 : 1) * p->P[k].x * x[p->P[k].i] * x[p->P[k].j];
    *f = s;
    return TRUE;
}

static Bool gradient(Index n, Number *x, Bool new_x, Number *g, UserDataPtr user)
{
    const program *p = user;
    (void)new_x;
    memcpy(g, p->q, (size_t)n * sizeof *g);
    for (Index k = 0; k < p->in_P; k++) {
        g[p->P[k].i] += p->P[k].x * x[p->P[k].j];
        if (p->P[k].i != p->P[k].j) g[p->P[k].j] += p->P[k].x * x[p->P[k].i];
    }
    return TRUE;
}

static Bool rows(Index n, Number *x, Bool new_x, Index m, Number *g, UserDataPtr user)
{
    const program *p = user;
    (void)n;
    (void)new_x;
    for (Index i = 0; i < m; i++) g[i] = 0;
    for (Index k = 0; k < p->in_A; k++) g[p->A[k].i] += p->A[k].x * x[p->A[k].j];
    return TRUE;
}

static void entries(const entry *e, Index count, Number factor, Index *i, Index *j, Number *v)
{
    for (Index k = 0; k < count; k++) {
        if (v) v[k] = factor * e[k].x;
        else { i[k] = e[k].i; j[k] = e[k].j; }
    }
}

static Bool jacobian(Index n, Number *x, Bool new_x, Index m, Index count, Index *i, Index *j, Number *v, UserDataPtr user)
{
    const program *p = user;
    (void)n; (void)x; (void)new_x; (void)m;
    entries(p->A, count, 1, i, j, v);
    return TRUE;
}

static Bool hessian(Index n, Number *x, Bool new_x, Number factor, Index m, Number *y, Bool new_y, Index count, Index *i,
                    Index *j, Number *v, UserDataPtr user)
{
    const program *p = user;
    (void)n; (void)x; (void)new_x; (void)m; (void)y; (void)new_y;
    entries(p->P, count, factor, i, j, v);
    return TRUE;
}

/* ---------------------------------------------------------------------------------------------------------------- a run */

static void text(IpoptProblem ip, const char *name, const char *v) { AddIpoptStrOption(ip, (char *)name, (char *)v); }
static void number(IpoptProblem ip, const char *name, Number v) { AddIpoptNumOption(ip, (char *)name, v); }

/* tol: of Ipopt's own scaled residuals */
static void options(IpoptProblem ip, Number tol, Index most, int warm)
{
    AddIpoptIntOption(ip, (char *)"print_level", 0);
    AddIpoptIntOption(ip, (char *)"max_iter", most);
    AddIpoptIntOption(ip, (char *)"acceptable_iter", 0);
    text(ip, "sb", "yes");
    text(ip, "hessian_constant", "yes");
    text(ip, "jac_c_constant", "yes");
    text(ip, "jac_d_constant", "yes");
    if (warm) text(ip, "warm_start_init_point", "yes");
    number(ip, "tol", tol);
    number(ip, "constr_viol_tol", tol);
    number(ip, "dual_inf_tol", tol);
    number(ip, "compl_inf_tol", tol);
    number(ip, "bound_relax_factor", tol < 1e-8 ? tol : 1e-8);
    number(ip, "diverging_iterates_tol", 1e10);
    text(ip, "dependency_detector", "mumps");
    number(ip, "nlp_lower_bound_inf", -(Number)SP_QP_INFINITY);
    number(ip, "nlp_upper_bound_inf", (Number)SP_QP_INFINITY);
}

/* Ipopt refuses more equations than unknowns: then each is given a little width. */
static void widen(program *p, Number tol)
{
    Index equations = 0;
    for (Index i = 0; i < p->m; i++) equations += !(p->l[i] < p->u[i]);
    for (Index i = 0; equations > p->n && i < p->m; i++)
        if (!(p->l[i] < p->u[i])) {
            const Number b = p->l[i], w = tol * (1 + (b < 0 ? -b : b));
            p->l[i] = b - w;
            p->u[i] = b + w;
        }
}

/* Solve from p->x, p->y; they become the answer. */
static int run(program *p, Number tol, Index most, int warm)
{
    int code = Insufficient_Memory;
    IpoptProblem ip;
    Number *low = malloc(3 * (size_t)p->n * sizeof *low), *high, *none;
    if (!low) return code;
    high = low + p->n;
    none = high + p->n;
    widen(p, tol);
    for (Index j = 0; j < p->n; j++) {
        low[j] = -2 * (Number)SP_QP_INFINITY;
        high[j] = 2 * (Number)SP_QP_INFINITY;
        none[j] = 0;
    }
    ip = CreateIpoptProblem(p->n, low, high, p->m, p->l, p->u, p->in_A, p->in_P, 0, value, rows, gradient, jacobian, hessian);
    if (ip) {
        options(ip, tol, most, warm);
        SetIntermediateCallback(ip, ipopt_count);
        memcpy(low, none, (size_t)p->n * sizeof *low);
        code = IpoptSolve(ip, p->x, NULL, NULL, p->y, low, none, p);
        FreeIpoptProblem(ip);
    }
    free(low);
    return code;
}

/* By name. */
sp_qp_status ipopt_qp_claim(int code)
{
    switch (code) {
    case Solve_Succeeded:             return SP_QP_SOLVED;
    case Solved_To_Acceptable_Level:  return SP_QP_INACCURATE;
    case Feasible_Point_Found:        return SP_QP_INACCURATE;
    case Infeasible_Problem_Detected: return SP_QP_PRIMAL_INFEASIBLE;
    case Restoration_Failed:          return SP_QP_PRIMAL_INFEASIBLE;
    case Diverging_Iterates:          return SP_QP_DUAL_INFEASIBLE;
    case Maximum_Iterations_Exceeded: return SP_QP_ITERATIONS;
    case Maximum_CpuTime_Exceeded:    return SP_QP_BUDGET;
    default:                          return SP_QP_NUMERICAL;
    }
}

/* p->y <- a certificate that p has no solution. */
static int find_proof(program *p, Number tol, Index most)
{
    program one;
    int code = Insufficient_Memory;
    if (program_phase_one(&one, p)) {
        code = run(&one, tol, most, 0);
        memcpy(p->y, one.y, (size_t)p->m * sizeof *p->y);
        p->iterations += one.iterations;
    }
    program_free(&one);
    return code;
}

static Number tolerance(const sp_qp_settings *s)
{
    const double a = (double)s->eps_abs, r = (double)s->eps_rel, least = 0.01 * (a > 0 && (a < r || !(r > 0)) ? a : r);
    return least < 1e-11 ? 1e-11 : least;
}

static sp_status solve_into(program *p, const sp_qp *qp, const sp_qp_settings *set, const sp_real *x0, const sp_real *y0,
                            sp_real *x, sp_real *y, sp_qp_status *claim)
{
    int code;
    for (Index j = 0; x0 && j < p->n; j++) p->x[j] = (Number)x0[j];
    for (Index i = 0; y0 && i < p->m; i++) p->y[i] = (Number)y0[i];
    code = run(p, tolerance(set), set->iterations, x0 && y0);
    *claim = ipopt_qp_claim(code);
    if (*claim == SP_QP_PRIMAL_INFEASIBLE) code = find_proof(p, 1e-10, set->iterations);
    if (code == Insufficient_Memory) return SP_E_MEMORY;
    for (Index j = 0; j < qp->n; j++) x[j] = (sp_real)p->x[j];
    for (Index i = 0; i < qp->m; i++) y[i] = (sp_real)p->y[i];
    return SP_OK;
}

static sp_status attempt(const sp_qp *qp, const sp_qp_settings *set, const sp_real *x0, const sp_real *y0, sp_real *x, sp_real *y,
                         sp_qp_status *claim, sp_qp_result *r)
{
    program p;
    const sp_status status = program_make(&p, qp) ? solve_into(&p, qp, set, x0, y0, x, y, claim) : SP_E_MEMORY;
    r->iterations = r->factorisations = p.iterations;
    r->rho = set->rho;
    program_free(&p);
    return status;
}

static sp_status solve(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, const sp_real *x0,
                       const sp_real *y0, sp_qp_result *result)
{
    (void)self;
    return qp_judge_solve(attempt, qp, settings, arena, x0, y0, result);
}

sp_qp_solver ipopt_qp_solver(void)
{
    const sp_qp_solver s = { NULL, solve, qp_judge_need };
    return s;
}

const char *ipopt_qp_version(void) { return IPOPT_VERSION; }
