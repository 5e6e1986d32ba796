/* ipopt_cra: coupled rigid-block analysis as published.                                             [Kao et al. 2022, Eq. 11]
 *
 *     min |fn|^2 + |alpha|^2   over  f (3 v), d (3 v), alpha (v), dq (6 b)   subject to
 *
 *     Aeq f + p = 0                   6 b     equilibrium
 *     d - Aeq' dq = 0                 3 v     motion of the joints
 *     fn (dn + eps) = 0               v       force only where a joint gave all it gives
 *     ft + alpha dt = 0               2 v     friction against slip
 *     f in its cone                   K v     pyramid, Afr f <= 0;  or v: |ft|^2 - mu^2 fn^2 <= 0
 *     |dt|^2 <= eta^2                 v       or bounds on dt1, dt2 (box)
 *     fn >= 0, alpha >= 0, -eps <= dn <= eta
 *
 * in the signs of the design (section 9.3). Ipopt works with forces in units of the mean weight F, lengths in units of L = eps
 * (eta where eps = 0), moments over their block's largest arm; the program and its solutions stay what they are: the objective
 * becomes |fn / F|^2 + |alpha L / F|^2 / L^2.
 */
#define _POSIX_C_SOURCE 200809L         /* clock_gettime */
#include "ipopt_cra.h"
#include "ipopt_count.h"

#include <IpoptConfig.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define NONE 2e19                       /* Ipopt's: no bound */

/* One term of constraint i: c x_j, k < 0, or c x_j x_k. */
typedef struct term { Index i, j, k; Number c; } term;

typedef struct nlp {
    Index iterations;                   /* first: ipopt_count */
    sp_problem problem;
    const sp_settings *settings;
    Index b, v;                         /* free blocks, contact vertices that touch one */
    int32_t *point;                     /* v: their numbers in the scene */
    Index *vertex;                      /* of the scene: their numbers here, -1 */
    double *arm;                        /* b [m] */
    double F, L, e, h, weight;          /* units; eps and eta in L; 1 / L^2 */
    Index n, m, terms, room;
    term *term;
    Number *x, *low, *high, *g, *g_low, *g_high;
} nlp;

static Index at_f(Index k) { return 3 * k; }                   /* fn, ft1, ft2 */
static Index at_d(const nlp *p, Index k) { return 3 * p->v + 3 * k; }
static Index at_alpha(const nlp *p, Index k) { return 6 * p->v + k; }
static Index at_dq(const nlp *p, Index row) { return 7 * p->v + row; }

/* Row r: a direction in which its block is held, so neither balance nor motion count. */
static int held(const nlp *p, Index r)
{
    return (int)(p->problem.scene->block[p->problem.block[r / 6]].fixed >> (r % 6) & 1);
}

/* Unit of row r of Aeq: F, or F times the arm; of dq the inverse, L or L over the arm. */
static double arm_of(const nlp *p, Index row) { return row % 6 < 3 ? 1 : p->arm[row / 6]; }

/* ------------------------------------------------------------------------------------------------------- the constraints */

static void row(nlp *p, Number low, Number high, double constant)
{
    p->g_low[p->m] = low - constant;
    p->g_high[p->m++] = high - constant;
}

/* c x_j, or c x_j x_k, in the row that comes next */
static void add(nlp *p, Index i, Index j, Index k, Number c)
{
    const term t = { i, j, k, c };
    p->term[p->terms++] = t;
}

static void make_balance(nlp *p, const sp_triplets *A)
{
    for (Index t = 0; t < A->count; t++) {
        const Index k = p->vertex[A->j[t] / 3], part = A->j[t] % 3;
        const double a = (double)A->x[t] / arm_of(p, A->i[t]);
        if (k < 0) continue;
        add(p, A->i[t], at_f(k) + part, -1, a);
        add(p, 6 * p->b + 3 * k + part, at_dq(p, A->i[t]), -1, -a);
    }
    for (Index r = 0; r < 6 * p->b; r++)
        row(p, held(p, r) ? -NONE : 0, held(p, r) ? NONE : 0, held(p, r) ? 0 : (double)p->problem.p[r] / (p->F * arm_of(p, r)));
    for (Index k = 0; k < 3 * p->v; k++) {
        add(p, 6 * p->b + k, at_d(p, 0) + k, -1, 1);
        row(p, 0, 0, 0);
    }
}

static void make_coupling(nlp *p)
{
    for (Index k = 0; k < p->v; k++) {
        add(p, p->m, at_f(k), at_d(p, k), 1);
        if (p->e > 0) add(p, p->m, at_f(k), -1, p->e);
        row(p, 0, 0, 0);
        for (Index t = 1; t < 3; t++) {
            add(p, p->m, at_f(k) + t, -1, 1);
            add(p, p->m, at_alpha(p, k), at_d(p, k) + t, 1);
            row(p, 0, 0, 0);
        }
    }
}

static double mu_of(const nlp *p, Index k)
{
    for (int32_t c = 0; c < p->problem.contacts; c++) {
        const sp_contact *a = p->problem.contact + c;
        if (p->point[k] >= a->point && p->point[k] < a->point + a->points) return (double)a->joint->strength.mu;
    }
    return 0;
}

static void make_cone(nlp *p, const sp_triplets *A)
{
    if (p->settings->faces) {
        const Index first = p->m, faces = p->settings->faces;
        for (Index t = 0; t < A->count; t++) {
            const Index k = p->vertex[A->j[t] / 3];
            if (k >= 0) add(p, first + k * faces + A->i[t] % faces, at_f(k) + A->j[t] % 3, -1, (double)A->x[t]);
        }
        for (Index r = 0; r < p->v * faces; r++) row(p, -NONE, 0, 0);
        return;
    }
    for (Index k = 0; k < p->v; k++) {
        const double mu = mu_of(p, k);
        add(p, p->m, at_f(k), at_f(k), -mu * mu);
        add(p, p->m, at_f(k) + 1, at_f(k) + 1, 1);
        add(p, p->m, at_f(k) + 2, at_f(k) + 2, 1);
        row(p, -NONE, 0, 0);
    }
}

static void make_circle(nlp *p)
{
    for (Index k = 0; k < p->v; k++) {
        add(p, p->m, at_d(p, k) + 1, at_d(p, k) + 1, 1);
        add(p, p->m, at_d(p, k) + 2, at_d(p, k) + 2, 1);
        row(p, -NONE, p->h * p->h, 0);
    }
}

static void make_bounds(nlp *p, int box)
{
    for (Index j = 0; j < p->n; j++) {
        p->low[j] = -NONE;
        p->high[j] = NONE;
    }
    for (Index r = 0; r < 6 * p->b; r++) if (held(p, r)) p->low[at_dq(p, r)] = p->high[at_dq(p, r)] = 0;
    for (Index k = 0; k < p->v; k++) {
        p->low[at_f(k)] = p->low[at_alpha(p, k)] = 0;
        p->low[at_d(p, k)] = -p->e;
        p->high[at_d(p, k)] = p->h;
        for (Index t = 1; box && t < 3; t++) {
            p->low[at_d(p, k) + t] = -p->h;
            p->high[at_d(p, k) + t] = p->h;
        }
    }
}

/* ------------------------------------------------------------------------------------------------------- what Ipopt asks */

static Bool value(Index n, Number *x, Bool new_x, Number *f, UserDataPtr user)
{
    const nlp *p = user;
    Number s = 0;
    (void)n; (void)new_x;
    for (Index k = 0; k < p->v; k++)
        s += x[at_f(k)] * x[at_f(k)] + p->weight * x[at_alpha(p, k)] * x[at_alpha(p, k)];
    *f = s;
    return TRUE;
}

static Bool gradient(Index n, Number *x, Bool new_x, Number *g, UserDataPtr user)
{
    const nlp *p = user;
    (void)new_x;
    for (Index j = 0; j < n; j++) g[j] = 0;
    for (Index k = 0; k < p->v; k++) {
        g[at_f(k)] = 2 * x[at_f(k)];
        g[at_alpha(p, k)] = 2 * p->weight * x[at_alpha(p, k)];
    }
    return TRUE;
}

static Bool rows(Index n, Number *x, Bool new_x, Index m, Number *g, UserDataPtr user)
{
    const nlp *p = user;
    (void)n; (void)new_x;
    for (Index i = 0; i < m; i++) g[i] = 0;
    for (Index t = 0; t < p->terms; t++) {
        const term *a = p->term + t;
        g[a->i] += a->c * x[a->j] * (a->k < 0 ? 1 : x[a->k]);
    }
    return TRUE;
}

/* d (c x_j x_k): c x_k at j and c x_j at k, two entries; a constant has one. */
static Bool jacobian(Index n, Number *x, Bool new_x, Index m, Index count, Index *i, Index *j, Number *v, UserDataPtr user)
{
    const nlp *p = user;
    Index at = 0;
    (void)n; (void)new_x; (void)m; (void)count;
    for (Index t = 0; t < p->terms; t++) {
        const term *a = p->term + t;
        if (v) v[at] = a->c * (a->k < 0 ? 1 : x[a->k]);
        else { i[at] = a->i; j[at] = a->j; }
        at++;
        if (a->k < 0) continue;
        if (v) v[at] = a->c * x[a->j];
        else { i[at] = a->i; j[at] = a->k; }
        at++;
    }
    return TRUE;
}

/* 2 on fn and alpha of the objective; y_i c at (j, k) of each product, twice that where j = k. */
static Bool hessian(Index n, Number *x, Bool new_x, Number factor, Index m, Number *y, Bool new_y, Index count, Index *i,
                    Index *j, Number *v, UserDataPtr user)
{
    const nlp *p = user;
    Index at = 0;
    (void)n; (void)x; (void)new_x; (void)m; (void)new_y; (void)count;
    for (Index k = 0; k < 2 * p->v; k++, at++) {
        const Index of = k < p->v ? at_f(k) : at_alpha(p, k - p->v);
        if (v) v[at] = 2 * factor * (k < p->v ? 1 : p->weight);
        else i[at] = j[at] = of;
    }
    for (Index t = 0; t < p->terms; t++) {
        const term *a = p->term + t;
        if (a->k < 0) continue;
        if (v) v[at] = a->c * y[a->i] * (a->j == a->k ? 2 : 1);
        else {
            i[at] = a->j > a->k ? a->j : a->k;
            j[at] = a->j > a->k ? a->k : a->j;
        }
        at++;
    }
    return TRUE;
}

/* ---------------------------------------------------------------------------------------------------------------- a run */

static const char *status_text(int code)
{
    switch (code) {
    case Solve_Succeeded:                    return "Solve_Succeeded";
    case Solved_To_Acceptable_Level:         return "Solved_To_Acceptable_Level";
    case Infeasible_Problem_Detected:        return "Infeasible_Problem_Detected";
    case Search_Direction_Becomes_Too_Small: return "Search_Direction_Becomes_Too_Small";
    case Diverging_Iterates:                 return "Diverging_Iterates";
    case Feasible_Point_Found:               return "Feasible_Point_Found";
    case Maximum_Iterations_Exceeded:        return "Maximum_Iterations_Exceeded";
    case Restoration_Failed:                 return "Restoration_Failed";
    case Error_In_Step_Computation:          return "Error_In_Step_Computation";
    case Maximum_CpuTime_Exceeded:           return "Maximum_CpuTime_Exceeded";
    case Not_Enough_Degrees_Of_Freedom:      return "Not_Enough_Degrees_Of_Freedom";
    case Insufficient_Memory:                return "Insufficient_Memory";
    default:                                 return "an error";
    }
}

static int run(nlp *p, const ipopt_cra_question *q)
{
    Index products = 0;
    int code = Insufficient_Memory;
    IpoptProblem ip;
    for (Index t = 0; t < p->terms; t++) products += p->term[t].k >= 0;
    ip = CreateIpoptProblem(p->n, p->low, p->high, p->m, p->g_low, p->g_high, p->terms + products, 2 * p->v + products, 0,
                            value, rows, gradient, jacobian, hessian);
    if (!ip) return code;
    AddIpoptIntOption(ip, (char *)"print_level", 0);
    AddIpoptStrOption(ip, (char *)"sb", (char *)"yes");
    AddIpoptIntOption(ip, (char *)"max_iter", q->iterations);
    AddIpoptNumOption(ip, (char *)"max_cpu_time", q->seconds);
    AddIpoptNumOption(ip, (char *)"tol", q->tol);
    AddIpoptNumOption(ip, (char *)"constr_viol_tol", q->tol);
    AddIpoptStrOption(ip, (char *)"mu_strategy", (char *)"adaptive");
    AddIpoptNumOption(ip, (char *)"bound_relax_factor", 0);       /* else eta gives way, and with it the smallest alpha */
    SetIntermediateCallback(ip, ipopt_count);
    code = IpoptSolve(ip, p->x, p->g, NULL, NULL, NULL, NULL, p);
    FreeIpoptProblem(ip);
    return code;
}

/* --------------------------------------------------------------------------------------------------------------- answer */

static double larger(double a, double b) { return a > b || isnan(a) ? a : b; }

/* |p| of a block, of one without: the mean weight */
static double load_of(const nlp *p, Index block)
{
    const sp_real *w = p->problem.p + 6 * block;
    const double size = sqrt((double)w[0] * (double)w[0] + (double)w[1] * (double)w[1] + (double)w[2] * (double)w[2]);
    return size > 0 ? size : p->F;
}

/* Residuals from x itself: sums of their own, none of Ipopt's. Rows 6b of balance come first. */
static void residuals(const nlp *p, int box, ipopt_cra_answer *out)
{
    out->balance = out->cone = out->contact = out->gap = out->slip = out->bound = 0;
    for (Index r = 0; r < p->m; r++) {
        const double over = larger(p->g_low[r] - p->g[r], p->g[r] - p->g_high[r]);
        if (r < 6 * p->b) out->balance = larger(out->balance, over * p->F / load_of(p, r / 6));
        else if (r >= 6 * p->b + 6 * p->v && p->settings->faces && r < 6 * p->b + 6 * p->v + p->v * p->settings->faces)
            out->cone = larger(out->cone, over);
    }
    for (Index k = 0; k < p->v; k++) {
        const Number *f = p->x + at_f(k), *d = p->x + at_d(p, k), a = p->x[at_alpha(p, k)];
        const double slide = hypot(d[1], d[2]), side = box ? larger(fabs(d[1]), fabs(d[2])) : slide;
        if (!p->settings->faces) out->cone = larger(out->cone, hypot(f[1], f[2]) - mu_of(p, k) * f[0]);
        out->cone = larger(out->cone, -f[0]);
        out->contact = larger(out->contact, fabs(f[0] * (d[0] + p->e)));
        out->gap = larger(out->gap, -p->e - d[0]);
        out->slip = larger(out->slip, larger(hypot(f[1] + a * d[1], f[2] + a * d[2]), -a));
        out->bound = larger(out->bound, larger(d[0], side) - p->h);
    }
}

double ipopt_cra_residual(const ipopt_cra_answer *a)
{
    return larger(larger(a->balance, a->cone), larger(larger(a->contact, a->gap), larger(a->slip, a->bound)));
}

/* The triple in SI, rounded to sp_real; d again from dq, so that residuals are those of what is handed over. */
static void hand_over(nlp *p, sp_real *f, sp_real *dq, sp_real *alpha, ipopt_cra_answer *out)
{
    out->objective = 0;
    for (Index k = 0; k < p->v; k++) {
        for (Index t = 0; t < 3; t++) f[3 * p->point[k] + t] = (sp_real)(p->x[at_f(k) + t] * p->F);
        alpha[p->point[k]] = (sp_real)(p->x[at_alpha(p, k)] * p->F / p->L);
        out->objective += pow(p->x[at_f(k)] * p->F, 2) + pow(p->x[at_alpha(p, k)] * p->F / p->L, 2);
    }
    for (Index r = 0; r < 6 * p->b; r++)
        dq[6 * p->problem.block[r / 6] + r % 6] = (sp_real)(p->x[at_dq(p, r)] * p->L / arm_of(p, r));
    for (Index k = 0; k < 3 * p->v; k++) p->x[at_d(p, 0) + k] = 0;
    for (Index t = 0; t < p->terms; t++)
        if (p->term[t].i >= 6 * p->b && p->term[t].i < 6 * p->b + 3 * p->v && p->term[t].j >= at_dq(p, 0))
            p->x[at_d(p, 0) + p->term[t].i - 6 * p->b] -= p->term[t].c * p->x[p->term[t].j];
    rows(p->n, p->x, TRUE, p->m, p->g, p);
}

/* ---------------------------------------------------------------------------------------------------------------- set up */

/* Which vertices take part, the units, and room for everything: rows and terms are counted from above. */
static int nlp_room(nlp *p, int32_t points, Index in_A, Index faces)
{
    const size_t cone = (size_t)(faces ? faces : 1);
    size_t n, m, v = 0;
    p->point = malloc((size_t)points * sizeof *p->point + 1);
    p->vertex = malloc((size_t)points * sizeof *p->vertex + 1);
    p->arm = calloc((size_t)p->b + 1, sizeof *p->arm);
    if (!p->point || !p->vertex || !p->arm) return 0;
    for (int32_t k = 0; k < points; k++) p->vertex[k] = -1;
    for (int32_t c = 0; c < p->problem.contacts; c++)
        for (int32_t k = 0; k < p->problem.contact[c].points; k++) {
            p->vertex[p->problem.contact[c].point + k] = (Index)v;
            p->point[v++] = p->problem.contact[c].point + k;
        }
    p->v = (Index)v;
    n = 7 * v + 6 * (size_t)p->b;
    m = 6 * (size_t)p->b + 7 * v + cone * v;
    p->n = (Index)n;
    p->room = 2 * in_A + (Index)(v * (14 + 3 * cone));
    p->term = malloc(((size_t)p->room + 1) * sizeof *p->term);
    p->x = calloc(3 * n + 3 * m + 1, sizeof *p->x);
    if (!p->term || !p->x) return 0;
    p->low = p->x + n;
    p->high = p->low + n;
    p->g = p->high + n;
    p->g_low = p->g + m;
    p->g_high = p->g_low + m;
    return 1;
}

static void nlp_units(nlp *p, const sp_triplets *A, const ipopt_cra_question *q)
{
    p->L = q->eps > 0 ? (double)q->eps : (double)q->eta;
    p->e = q->eps > 0 ? 1 : 0;
    p->h = (double)q->eta / p->L;
    p->weight = 1 / (p->L * p->L);
    p->F = 0;
    for (Index i = 0; i < p->b; i++) p->F += load_of(p, i) / p->b;
    if (!(p->F > 0)) p->F = 1;
    for (Index t = 0; t < A->count; t++)
        if (A->i[t] % 6 > 2) p->arm[A->i[t] / 6] = larger(p->arm[A->i[t] / 6], fabs((double)A->x[t]));
    for (Index i = 0; i < p->b; i++) if (!(p->arm[i] > 0)) p->arm[i] = 1;
}

static void nlp_start(nlp *p, const sp_real *f)
{
    for (Index k = 0; k < p->v; k++) {
        for (Index t = 0; t < 3; t++) p->x[at_f(k) + t] = f ? (double)f[3 * p->point[k] + t] / p->F : t == 0;
        p->x[at_alpha(p, k)] = 0;
    }
}

static void nlp_free(nlp *p)
{
    free(p->point);
    free(p->vertex);
    free(p->arm);
    free(p->term);
    free(p->x);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void answer_of(nlp *p, const ipopt_cra_question *q, sp_real *f, sp_real *dq, sp_real *alpha, ipopt_cra_answer *out)
{
    const double start = now();
    /* without Ipopt: nothing touches, nothing is free */
    const int code = p->v ? run(p, q) : p->b ? Infeasible_Problem_Detected : Solve_Succeeded;
    out->seconds = now() - start;
    out->status = status_text(code);
    out->iterations = p->iterations;
    hand_over(p, f, dq, alpha, out);
    residuals(p, q->box, out);
    out->solved = (code == Solve_Succeeded || code == Solved_To_Acceptable_Level) && ipopt_cra_residual(out) <= 1e-6;
}

/* Matrices of the problem; their memory is the arena's. */
static sp_status matrices(nlp *p, sp_arena *a, sp_triplets *aeq, sp_triplets *afr)
{
    sp_status status = sp_matrix_aeq(&p->problem, 3, a, aeq);
    memset(afr, 0, sizeof *afr);
    if (status == SP_OK && p->settings->faces) status = sp_matrix_afr(&p->problem, p->settings, 3, a, afr);
    return status;
}

static size_t matrices_bytes(const sp_scene *s, const sp_settings *set)
{
    const size_t points = (size_t)s->count.points, entry = 2 * sizeof(int32_t) + sizeof(sp_real);
    const sp_arena none = { NULL, 0, 0, 0 };
    size_t problem = 0;
    if (sp_memory(s, SP_FOR_PROBLEM, NULL, none, &problem)) return 0;
    return problem + points * 36 * entry + points * 3 * (size_t)set->faces * entry + 64 * SP_ALIGN;
}

sp_status ipopt_cra_solve(const sp_scene *scene, const sp_settings *settings, const ipopt_cra_question *q, sp_real *f,
                          sp_real *dq, sp_real *alpha, ipopt_cra_answer *answer)
{
    sp_triplets aeq, afr;
    sp_arena a;
    nlp p;
    void *memory;
    size_t bytes;
    sp_status status;
    if (!scene || !settings || !q || !f || !dq || !alpha || !answer) return SP_E_ARGUMENT;
    if (!(q->eps >= 0) || !(q->eta > 0)) return SP_E_RANGE;
    for (int32_t i = 0; i < scene->count.joints; i++) {
        const sp_strength *j = &scene->joint[i].strength;
        if (j->cohesion > 0 || j->tension > 0 || j->crushing > 0) return SP_E_UNSUPPORTED;
    }
    memset(&p, 0, sizeof p);
    memset(f, 0, 3 * (size_t)scene->count.points * sizeof *f);
    memset(dq, 0, 6 * (size_t)scene->count.blocks * sizeof *dq);
    memset(alpha, 0, (size_t)scene->count.points * sizeof *alpha);
    bytes = matrices_bytes(scene, settings);
    memory = malloc(bytes);
    status = memory ? sp_arena_init(&a, memory, bytes) : SP_E_MEMORY;
    if (status == SP_OK) status = sp_problem_build(scene, &a, &p.problem);
    p.settings = settings;
    p.b = p.problem.blocks;
    if (status == SP_OK) status = matrices(&p, &a, &aeq, &afr);
    if (status == SP_OK && !nlp_room(&p, scene->count.points, aeq.count, settings->faces)) status = SP_E_MEMORY;
    if (status == SP_OK) {
        nlp_units(&p, &aeq, q);
        make_balance(&p, &aeq);
        make_coupling(&p);
        make_cone(&p, &afr);
        if (!q->box) make_circle(&p);
        make_bounds(&p, q->box);
        nlp_start(&p, q->f);
        answer_of(&p, q, f, dq, alpha, answer);
    }
    nlp_free(&p);
    free(memory);
    return status;
}
