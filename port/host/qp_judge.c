/* qp_judge: residuals and certificates of quadratic programs, in double, with sums of its own.
 *
 *     min 1/2 x'Px + q'x   subject to   l <= Ax <= u
 *
 * Sizes are taken relative to rows and columns whose largest entry is 1: E_i max_j |a_ij| = 1, D_j max_i E_i |a_ij| = 1.
 */
#include "qp_judge.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct judge {
    const sp_qp *qp;
    double *D, *E, *x, *y;              /* scales; the point, unscaled */
    double *Px, *Ax, *Aty;
    double *w, *r, *s, *d, *t;          /* of the least squares: n + m each */
} judge;

static int no_l(const sp_qp *qp, int32_t i) { return !(qp->l[i] > -SP_QP_INFINITY); }
static int no_u(const sp_qp *qp, int32_t i) { return !(qp->u[i] < SP_QP_INFINITY); }
static double q_of(const sp_qp *qp, int32_t j) { return qp->q ? (double)qp->q[j] : 0; }
static double larger(double a, double b) { return a > b || isnan(a) ? a : b; }     /* a NaN stays */

static double largest(const double *v, int32_t n)
{
    double most = 0;
    for (int32_t k = 0; k < n; k++)
        most = larger(most, fabs(v[k]));
    return most;
}

static double inner(const double *a, const double *b, int32_t n)
{
    double sum = 0;
    for (int32_t k = 0; k < n; k++) sum += a[k] * b[k];
    return sum;
}

/* ------------------------------------------------------------------------------------------------------------ products */

/* out <- P v, from the upper triangle */
static void times_P(const sp_qp *qp, const double *v, double *out)
{
    memset(out, 0, (size_t)qp->n * sizeof *out);
    for (int32_t j = 0; qp->Pp && j < qp->n; j++)
        for (int32_t k = qp->Pp[j]; k < qp->Pp[j + 1]; k++) {
            out[qp->Pi[k]] += (double)qp->Px[k] * v[j];
            if (qp->Pi[k] < j) out[j] += (double)qp->Px[k] * v[qp->Pi[k]];
        }
}

/* out (m) <- A v;  out (n) <- A'v */
static void times_A(const sp_qp *qp, const double *v, double *out)
{
    memset(out, 0, (size_t)qp->m * sizeof *out);
    for (int32_t j = 0; qp->m && j < qp->n; j++)
        for (int32_t k = qp->Ap[j]; k < qp->Ap[j + 1]; k++) out[qp->Ai[k]] += (double)qp->Ax[k] * v[j];
}

static void times_At(const sp_qp *qp, const double *v, double *out)
{
    for (int32_t j = 0; j < qp->n; j++) {
        double sum = 0;
        for (int32_t k = qp->m ? qp->Ap[j] : 0; k < (qp->m ? qp->Ap[j + 1] : 0); k++) sum += (double)qp->Ax[k] * v[qp->Ai[k]];
        out[j] = sum;
    }
}

static void find_scales(judge *g)
{
    const sp_qp *qp = g->qp;
    for (int32_t i = 0; i < qp->m; i++) g->E[i] = 0;
    for (int32_t j = 0; qp->m && j < qp->n; j++)
        for (int32_t k = qp->Ap[j]; k < qp->Ap[j + 1]; k++) g->E[qp->Ai[k]] = larger(g->E[qp->Ai[k]], fabs((double)qp->Ax[k]));
    for (int32_t i = 0; i < qp->m; i++) g->E[i] = g->E[i] > 0 ? 1 / g->E[i] : 1;
    for (int32_t j = 0; j < qp->n; j++) {
        double most = 0;
        for (int32_t k = qp->m ? qp->Ap[j] : 0; k < (qp->m ? qp->Ap[j + 1] : 0); k++)
            most = larger(most, g->E[qp->Ai[k]] * fabs((double)qp->Ax[k]));
        g->D[j] = most > 0 ? 1 / most : 1;
    }
}

/* A multiplier of a bound that is not there is none. */
static void drop_unbounded(const sp_qp *qp, double *y)
{
    for (int32_t i = 0; i < qp->m; i++)
        if ((y[i] > 0 && no_u(qp, i)) || (y[i] < 0 && no_l(qp, i))) y[i] = 0;
}

/* u'y+ + l'y-; *terms: sum of |terms| */
static double support(const sp_qp *qp, const double *y, double *terms)
{
    double sum = 0;
    *terms = 0;
    for (int32_t i = 0; i < qp->m; i++) {
        const double t = y[i] > 0 ? (double)qp->u[i] * y[i] : y[i] < 0 ? (double)qp->l[i] * y[i] : 0;
        sum += t;
        *terms += fabs(t);
    }
    return sum;
}

/* ------------------------------------------------------------------------------------------------------------ a point */

/* The three residuals of x, y, and the largest of them over its tolerance.                                [seed 4.2]
 *   |Ax - z|       <= eps_abs + eps_rel max(|Ax|, |z|)               z: Ax moved onto [l, u]
 *   |Px + q + A'y| <= eps_abs + eps_rel max(|Px|, |A'y|, |q|)
 *   gap            <= eps_abs + eps_rel |objective|                  (whatever settings.strict: y knows nothing of z here)
 * gap = max(|y|'|Ax - z|, |x'Px + q'x + u'y+ + l'y-| + |x|'|Px + q + A'y|) bounds what the objective is out by, see
 * solvers/qp/qp.c. */
static double residuals(judge *g, const sp_qp_settings *set, sp_qp_result *out)
{
    const sp_qp *qp = g->qp;
    const double abs_tol = (double)set->eps_abs, rel_tol = (double)set->eps_rel;
    double primal = 0, dual = 0, size_p = 0, size_d = 0, terms, qx = 0, infeasible = 0, unbalanced = 0;
    times_P(qp, g->x, g->Px);
    times_A(qp, g->x, g->Ax);
    times_At(qp, g->y, g->Aty);
    for (int32_t i = 0; i < qp->m; i++) {
        const double a = g->Ax[i], z = !no_l(qp, i) && a < (double)qp->l[i] ? (double)qp->l[i]
                                     : !no_u(qp, i) && a > (double)qp->u[i] ? (double)qp->u[i] : a;
        primal = larger(primal, fabs(a - z));
        infeasible += fabs(g->y[i] * (a - z));
        size_p = larger(size_p, larger(fabs(a), fabs(z)));
    }
    for (int32_t j = 0; j < qp->n; j++) {
        const double q = q_of(qp, j);
        qx += q * g->x[j];
        dual = larger(dual, fabs(g->Px[j] + q + g->Aty[j]));
        unbalanced += fabs(g->x[j] * (g->Px[j] + q + g->Aty[j]));
        size_d = larger(size_d, larger(fabs(q), larger(fabs(g->Px[j]), fabs(g->Aty[j]))));
    }
    const double xPx = inner(g->x, g->Px, qp->n), s = support(qp, g->y, &terms), f = 0.5 * xPx + qx;
    const double gap = larger(infeasible, fabs(xPx + qx + s) + unbalanced);
    out->objective = (sp_real)f;
    out->primal = (sp_real)primal;
    out->dual = (sp_real)dual;
    out->gap = (sp_real)gap;
    if (!isfinite(primal + dual + gap + xPx + qx)) return HUGE_VAL;
    return larger(primal / (abs_tol + rel_tol * size_p),
                  larger(dual / (abs_tol + rel_tol * size_d), gap / (abs_tol + rel_tol * fabs(f))));
}

static sp_qp_status point_status(sp_qp_status claim, double off)
{
    if (claim == SP_QP_SOLVED) return off <= 1 ? SP_QP_SOLVED : off <= 10 ? SP_QP_INACCURATE : SP_QP_NUMERICAL;
    if (claim == SP_QP_ITERATIONS || claim == SP_QP_BUDGET) return off <= 10 ? SP_QP_INACCURATE : claim;
    return claim;
}

/* -------------------------------------------------------------------------------------------------------- certificates
 *
 * y with A'y = 0 and u'y+ + l'y- < 0: nothing is feasible. A rest r = A'y leaves |x / D|_1 >= -(u'y+ + l'y-) / max D_j |r_j|
 * for anything feasible: that is the radius. x with Px = 0, q'x < 0 and Ax in the recession cone of [l, u]: it goes down for
 * ever; rests leave |x* / D|_1 + |y* / E|_1 >= -q'x / max(D |Px|, E |wrong Ax|) for anything optimal.
 *                                                                             [Banjac et al. 2019, J. Optim. Theory Appl. 183]
 */

static double radius_primal(judge *g)
{
    const sp_qp *qp = g->qp;
    double terms, worst = 0;
    const double down = -support(qp, g->y, &terms) - (qp->m + 4) * 0x1p-53 * terms;
    if (!(down > 0)) return 0;
    for (int32_t j = 0; j < qp->n; j++) {
        double r = 0, size = 0;
        for (int32_t k = qp->Ap[j]; k < qp->Ap[j + 1]; k++) {
            const double t = (double)qp->Ax[k] * g->y[qp->Ai[k]];
            r += t;
            size += fabs(t);
        }
        worst = larger(worst, g->D[j] * (fabs(r) + (qp->Ap[j + 1] - qp->Ap[j]) * 0x1p-53 * size));
    }
    return worst > 0 ? down / worst : HUGE_VAL;
}

static double radius_dual(judge *g)
{
    const sp_qp *qp = g->qp;
    double down = 0, terms = 0, worst = 0;
    for (int32_t j = 0; j < qp->n; j++) {
        down -= q_of(qp, j) * g->x[j];
        terms += fabs(q_of(qp, j) * g->x[j]);
    }
    down -= (qp->n + 4) * 0x1p-53 * terms;
    if (!(down > 0)) return 0;
    times_P(qp, g->x, g->Px);
    times_A(qp, g->x, g->Ax);
    for (int32_t j = 0; j < qp->n; j++) worst = larger(worst, g->D[j] * fabs(g->Px[j]));
    for (int32_t i = 0; i < qp->m; i++)
        if ((g->Ax[i] > 0 && !no_u(qp, i)) || (g->Ax[i] < 0 && !no_l(qp, i))) worst = larger(worst, g->E[i] * fabs(g->Ax[i]));
    return worst > 0 ? down / worst : HUGE_VAL;
}

/* How large solutions must be for their absence to be believed: what the data asks for at least, times settings.radius. */
static double far_primal(const judge *g, const sp_qp_settings *set)
{
    double most = 0;
    for (int32_t i = 0; i < g->qp->m; i++) {
        const double l = (double)g->qp->l[i], u = (double)g->qp->u[i];
        most = larger(most, g->E[i] * (!no_l(g->qp, i) && l > 0 ? l : !no_u(g->qp, i) && u < 0 ? -u : 0));
    }
    return (double)set->radius * (1 + most);
}

static double far_dual(const judge *g, const sp_qp_settings *set)
{
    double most = 0;
    for (int32_t j = 0; j < g->qp->n; j++) most = larger(most, g->D[j] * fabs(q_of(g->qp, j)));
    return (double)set->radius * (1 + most);
}

/* The matrix B whose kernel a certificate lies in, scaled: B = (E_S A_S D)' for y / E in the rows S that count, or
 * B = (DPD; E_T A_T D) for x / D and the rows T that must not move. keep: S or T, as 0 and 1. */
typedef struct kernel { judge *g; const double *keep; int dual; } kernel;

static int32_t kernel_from(const kernel *k) { return k->dual ? k->g->qp->n : k->g->qp->m; }
static int32_t kernel_to(const kernel *k) { return k->dual ? k->g->qp->n + k->g->qp->m : k->g->qp->n; }

/* out (n) <- D A' E keep v */
static void kernel_At(const kernel *k, const double *v, double *out)
{
    judge *g = k->g;
    for (int32_t i = 0; i < g->qp->m; i++) g->Ax[i] = g->E[i] * k->keep[i] * v[i];
    times_At(g->qp, g->Ax, out);
    for (int32_t j = 0; j < g->qp->n; j++) out[j] *= g->D[j];
}

/* out (m) <- keep E A D v */
static void kernel_A(const kernel *k, const double *v, double *out)
{
    judge *g = k->g;
    for (int32_t j = 0; j < g->qp->n; j++) g->Px[j] = g->D[j] * v[j];
    times_A(g->qp, g->Px, out);
    for (int32_t i = 0; i < g->qp->m; i++) out[i] *= k->keep[i] * g->E[i];
}

/* out (n) <- D P D v */
static void kernel_P(const kernel *k, const double *v, double *out)
{
    judge *g = k->g;
    for (int32_t j = 0; j < g->qp->n; j++) g->Px[j] = g->D[j] * v[j];
    times_P(g->qp, g->Px, out);
    for (int32_t j = 0; j < g->qp->n; j++) out[j] *= g->D[j];
}

static void kernel_B(const kernel *k, const double *v, double *out)
{
    if (!k->dual) { kernel_At(k, v, out); return; }
    kernel_P(k, v, out);
    kernel_A(k, v, out + k->g->qp->n);
}

static void kernel_Bt(const kernel *k, const double *v, double *out)
{
    if (!k->dual) { kernel_A(k, v, out); return; }
    kernel_At(k, v + k->g->qp->n, out);
    kernel_P(k, v, k->g->Aty);
    for (int32_t j = 0; j < k->g->qp->n; j++) out[j] += k->g->Aty[j];
}

/* v <- v - B'w with the w of least |v - B'w|: the nearest vector of B's kernel. Conjugate gradients on B B'w = B v, twice. */
static void into_kernel(const kernel *k, double *v)
{
    judge *g = k->g;
    const int32_t from = kernel_from(k), to = kernel_to(k);
    for (int again = 0; again < 2; again++) {
        kernel_B(k, v, g->s);
        memcpy(g->d, g->s, (size_t)to * sizeof *g->d);
        double ss = inner(g->s, g->s, to);
        const double start = ss;
        for (int32_t step = 0; step < 4 * to + 20 && ss > 1e-32 * start && ss > 0; step++) {
            kernel_Bt(k, g->d, g->t);
            const double tt = inner(g->t, g->t, from), a = tt > 0 ? ss / tt : 0, before = ss;
            if (!(a > 0) || !isfinite(a)) break;
            for (int32_t i = 0; i < from; i++) v[i] -= a * g->t[i];
            kernel_B(k, v, g->s);                       /* not by recurrence: the rest is what matters */
            ss = inner(g->s, g->s, to);
            for (int32_t i = 0; i < to; i++) g->d[i] = g->s[i] + ss / before * g->d[i];
        }
    }
}

/* v to its largest entry 1, rounded as it will be told; 0: it is nothing */
static int scale_to_one(double *v, int32_t n)
{
    const double most = largest(v, n);
    if (!(most > 0) || !isfinite(most)) return 0;
    for (int32_t k = 0; k < n; k++) v[k] = (double)(sp_real)(v[k] / most);
    return 1;
}

/* y <- the nearest with A_S'y = 0, S the rows where y / E is not small. */
static void sharpen_y(judge *g)
{
    const int32_t m = g->qp->m;
    const kernel k = { g, g->r, 0 };
    for (int32_t i = 0; i < m; i++) g->w[i] = g->y[i] / g->E[i];
    const double little = 1e-4 * largest(g->w, m);
    for (int32_t i = 0; i < m; i++) g->w[i] *= g->r[i] = fabs(g->w[i]) > little ? 1 : 0;
    into_kernel(&k, g->w);
    for (int32_t i = 0; i < m; i++) g->y[i] = g->E[i] * g->w[i];
    drop_unbounded(g->qp, g->y);
}

/* x <- the nearest with Px = 0 and A_T x = 0, T the rows that hardly move and must not. */
static void sharpen_x(judge *g)
{
    const sp_qp *qp = g->qp;
    const kernel k = { g, g->r, 1 };
    double most = 0;
    times_A(qp, g->x, g->Ax);
    for (int32_t i = 0; i < qp->m; i++) most = larger(most, g->E[i] * fabs(g->Ax[i]));
    for (int32_t i = 0; i < qp->m; i++) {
        const double a = g->E[i] * g->Ax[i];
        g->r[i] = (!no_u(qp, i) && a > -1e-4 * most) || (!no_l(qp, i) && a < 1e-4 * most) ? 1 : 0;
    }
    for (int32_t j = 0; j < qp->n; j++) g->w[j] = g->x[j] / g->D[j];
    into_kernel(&k, g->w);
    for (int32_t j = 0; j < qp->n; j++) g->x[j] = g->D[j] * g->w[j];
}

/* The radius of y as a proof that nothing is feasible, 0 if it is none. */
static double proof_primal(judge *g, const sp_qp_settings *set)
{
    const double enough = larger(far_primal(g, set), 1 / (double)set->eps_pinf);
    double radius;
    drop_unbounded(g->qp, g->y);
    radius = scale_to_one(g->y, g->qp->m) ? radius_primal(g) : 0;
    if (radius > 1 && radius <= enough) {
        sharpen_y(g);
        radius = scale_to_one(g->y, g->qp->m) ? radius_primal(g) : 0;
    }
    return radius > enough ? radius : 0;
}

static double proof_dual(judge *g, const sp_qp_settings *set)
{
    const double enough = larger(far_dual(g, set), 1 / (double)set->eps_dinf);
    double radius = scale_to_one(g->x, g->qp->n) ? radius_dual(g) : 0;
    if (radius > 1 && radius <= enough) {
        sharpen_x(g);
        radius = scale_to_one(g->x, g->qp->n) ? radius_dual(g) : 0;
    }
    return radius > enough ? radius : 0;
}

/* ------------------------------------------------------------------------------------------------------------ judgement */

static int judge_make(judge *g, const sp_qp *qp)
{
    const size_t n = (size_t)qp->n, m = (size_t)qp->m;
    double *p = malloc((4 * n + 3 * m + 5 * (n + m)) * sizeof *p);
    memset(g, 0, sizeof *g);
    if (!p) return 0;
    g->qp = qp;
    g->D = p; g->x = p + n; g->Px = p + 2 * n; g->Aty = p + 3 * n;
    p += 4 * n;
    g->E = p; g->y = p + m; g->Ax = p + 2 * m;
    p += 3 * m;
    g->w = p; g->r = p + (n + m); g->s = p + 2 * (n + m); g->d = p + 3 * (n + m); g->t = p + 4 * (n + m);
    find_scales(g);
    return 1;
}

static void write_scaled(const double *from, sp_real *to, int32_t n, double factor)
{
    for (int32_t k = 0; k < n; k++) to[k] = (sp_real)(factor * from[k]);
}

/* A certificate that does not hold leaves the origin, judged, and `numerical`. */
static void leave_no_point(judge *g, sp_real *x, sp_real *y)
{
    memset(g->x, 0, (size_t)g->qp->n * sizeof *g->x);
    memset(g->y, 0, (size_t)g->qp->m * sizeof *g->y);
    write_scaled(g->x, x, g->qp->n, 0);
    write_scaled(g->y, y, g->qp->m, 0);
}

sp_status qp_judge(const sp_qp *qp, const sp_qp_settings *settings, sp_qp_status claim, sp_real *x, sp_real *y,
                   sp_qp_result *result)
{
    const sp_qp_settings set = settings ? *settings : sp_qp_default();
    judge g;
    double radius = 0, off;
    if (!judge_make(&g, qp)) return SP_E_MEMORY;
    for (int32_t j = 0; j < qp->n; j++) g.x[j] = (double)x[j];
    for (int32_t i = 0; i < qp->m; i++) g.y[i] = (double)y[i];
    result->x = x;
    result->y = y;
    result->status = claim;
    if (claim == SP_QP_PRIMAL_INFEASIBLE || claim == SP_QP_DUAL_INFEASIBLE) {
        radius = claim == SP_QP_PRIMAL_INFEASIBLE ? proof_primal(&g, &set) : proof_dual(&g, &set);
        if (!(radius > 0)) { result->status = SP_QP_NUMERICAL; leave_no_point(&g, x, y); }
        else if (claim == SP_QP_PRIMAL_INFEASIBLE) memset(g.x, 0, (size_t)qp->n * sizeof *g.x);
        else memset(g.y, 0, (size_t)qp->m * sizeof *g.y);
    } else {
        if (!isfinite(largest(g.x, qp->n)) || !isfinite(largest(g.y, qp->m))) {
            result->status = SP_QP_NUMERICAL;
            leave_no_point(&g, x, y);
        }
        drop_unbounded(qp, g.y);
    }
    write_scaled(g.x, x, qp->n, 1);
    write_scaled(g.y, y, qp->m, 1);
    off = residuals(&g, &set, result);
    if (radius <= 0) result->status = point_status(result->status, off);
    result->radius = radius < 1e30 ? (sp_real)radius : (sp_real)1e30;
    free(g.D);
    return SP_OK;
}

/* What sp_qp_setup says, which also knows whether P is semidefinite. */
static sp_status try_setup(const sp_qp *qp, const sp_qp_settings *set, size_t bytes)
{
    sp_arena a;
    sp_qp_work *work;
    void *memory = malloc(bytes + SP_ALIGN);
    sp_status status = memory ? sp_arena_init(&a, memory, bytes + SP_ALIGN) : SP_E_MEMORY;
    if (status == SP_OK) status = sp_qp_setup(qp, set, &a, &work);
    free(memory);
    return status;
}

static sp_status check_semidefinite(const sp_qp *qp, sp_qp_settings set)
{
    sp_arena a;
    sp_status status = SP_E_MEMORY;
    void *memory;
    size_t bytes;
    set.backend = SP_QP_SPARSE;
    bytes = sp_qp_memory_scratch(qp, &set);
    memory = bytes ? malloc(bytes + SP_ALIGN) : NULL;
    if (memory && sp_arena_init(&a, memory, bytes + SP_ALIGN) == SP_OK) status = sp_qp_memory(qp, &set, a, &bytes);
    free(memory);
    return status == SP_OK ? try_setup(qp, &set, bytes) : status;
}

sp_status qp_judge_arguments(const sp_qp *qp, const sp_qp_settings *settings, const sp_real *x0, const sp_real *y0)
{
    const sp_arena none = { NULL, 0, 0, 0 };
    sp_qp_settings set = settings ? *settings : sp_qp_default();
    size_t bytes;
    sp_status status;
    set.backend = SP_QP_CG;                             /* which needs no scratch to know its size */
    status = sp_qp_memory(qp, &set, none, &bytes);
    if (status != SP_OK) return status;
    for (int32_t j = 0; x0 && j < qp->n; j++) if (!isfinite((double)x0[j])) return SP_E_NOT_FINITE;
    for (int32_t i = 0; y0 && i < qp->m; i++) if (!isfinite((double)y0[i])) return SP_E_NOT_FINITE;
    return qp->Pp ? check_semidefinite(qp, set) : SP_OK;
}

static size_t round_up(size_t bytes) { return (bytes + (SP_ALIGN - 1)) / SP_ALIGN * SP_ALIGN; }

/* n numbers at *x, m at *y.     returns bytes taken; NULL arena: only counts; 0: no room */
static size_t carve_point(const sp_qp *qp, sp_arena *arena, sp_real **x, sp_real **y)
{
    const size_t of_x = round_up((size_t)qp->n * sizeof(sp_real)), of_y = round_up((size_t)qp->m * sizeof(sp_real));
    if (!arena) return of_x + of_y;
    const size_t used = round_up(arena->used);
    unsigned char *at = arena->base + used;
    if (used > arena->capacity || arena->capacity - used < of_x + of_y) return 0;
    memcpy(x, &at, sizeof at);
    at += of_x;
    memcpy(y, &at, sizeof at);
    arena->used = used + of_x + of_y;
    if (arena->used > arena->peak) arena->peak = arena->used;
    return of_x + of_y;
}

sp_status qp_judge_solve(qp_judge_attempt *attempt, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena,
                         const sp_real *x0, const sp_real *y0, sp_qp_result *result)
{
    const sp_qp_settings set = settings ? *settings : sp_qp_default();
    sp_arena a;
    sp_qp_result r;
    sp_real *x = NULL, *y = NULL;
    sp_qp_status claim = SP_QP_NUMERICAL;
    sp_status status = qp_judge_arguments(qp, &set, x0, y0);

    if (status != SP_OK || !arena || !result) return status == SP_OK ? SP_E_ARGUMENT : status;
    a = *arena;
    if (!carve_point(qp, &a, &x, &y)) return SP_E_MEMORY;
    memset(&r, 0, sizeof r);
    status = attempt(qp, &set, x0, y0, x, y, &claim, &r);
    if (status == SP_OK) status = qp_judge(qp, &set, claim, x, y, &r);
    if (status != SP_OK) return status;
    *arena = a;
    *result = r;
    return SP_OK;
}

sp_status qp_judge_need(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes)
{
    const sp_status status = qp_judge_arguments(qp, settings, NULL, NULL);
    (void)self;
    (void)scratch;
    if (status == SP_OK) *bytes = carve_point(qp, NULL, NULL, NULL);
    return status;
}
