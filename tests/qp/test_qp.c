/* Quadratic programs: a battery of generated problems whose answers are known by construction, for every back end; refusals,
 * memory, updates, warm starts.
 *
 * A problem with a known solution is built backwards [KKT]: choose x, z, y with y pushing only where z touches a bound, then
 * q = -P x - A'y makes (x, y) optimal. An infeasible one holds a Farkas vector, an unbounded one a direction. */
#include "../test.h"

#include <string.h>

enum { N = 40, M = 90, MOST = 3600 };

static const sp_qp_backend all[] = { SP_QP_SPARSE, SP_QP_DENSE,
#if !defined SP_QP_NO_CG || defined SP_SMALL
                                     SP_QP_CG
#endif
};
enum { BACKENDS = sizeof all / sizeof *all };

#ifdef SP_QP_NO_INTERIOR
#define LACKS(method) (!TEST_SMALL && (method) == SP_QP_INTERIOR)
#else
#define LACKS(method) ((void)(method), 0)
#endif

#ifdef SP_QP_NO_POLISH                                  /* ADMM by itself: residuals as asked for, no digits beyond, more iterations */
#define EPS(real, small) TOL(1e-6, small)
#define EXACT(real, small) TOL(1e-4, 1e-3)
enum { OPEN = 6, ADMM_ALONE = 1 };
#else
#define EPS(real, small) TOL(real, small)
#define EXACT(real, small) TOL(real, small)
enum { OPEN = 2, ADMM_ALONE = 0 };
#endif

typedef enum kind { STRICT, DEGENERATE, LINEAR, SPREAD, REDUNDANT, POINT, EQUALITIES, BOXED, INFEASIBLE, UNBOUNDED, KINDS } kind;

static const char *const kind_name[] = { "strict", "degenerate", "linear", "spread", "redundant", "point", "equalities", "boxed",
                                         "infeasible", "unbounded" };

/* One problem in static memory, dense while it is made, and what is known of it. */
typedef struct sample {
    sp_qp qp;
    int32_t Pp[N + 1], Pi[N * N], Ap[N + 1], Ai[MOST];
    sp_real Px[N * N], Ax[MOST], q[N], l[M], u[M];
    double objective, size;             /* size: of the terms of the objective */
    kind kind;
} sample;

#ifndef EACH
#define EACH 5                                          /* problems of each kind; a long battery: -DEACH=200 */
#endif
#ifndef WILD
#define WILD 2000                                       /* of numbers nobody would give */
#endif
#ifndef TELL
#define TELL 0                                          /* 1: print how each kind went */
#endif

static double P[N][N], A[M][N], x[N], y[M], lo[M], up[M];
static sample s;
static sp_real q_new[N];

static double real(double a, double b) { return (double)test_random_real(a, b); }
static int32_t whole(int32_t a, int32_t b) { return test_random_int(a, b); }
static double size_of(double v) { return v < 0 ? -v : v; }

/* 10^k for k between -e and e */
static double power(int32_t e)
{
    double p = 1;
    for (int32_t k = whole(-e, e); k; k += k < 0 ? 1 : -1) p *= k < 0 ? 0.1 : 10;
    return p;
}

/* A factor that is drawn first, times 10^k: two draws in one expression would come in an order that compilers choose. */
static double spread(double low, int32_t e)
{
    const double t = real(low, 1);
    return t * power(e);
}

/* P = G G' / n of rank `rank` plus `shift` on the diagonal. */
static void make_P(int32_t n, int32_t rank, double shift)
{
    static double g[N][N];
    for (int32_t i = 0; i < n; i++) for (int32_t k = 0; k < rank; k++) g[i][k] = whole(0, 2) ? 0 : real(-1, 1);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++) {
            double t = i == j ? shift : 0;
            for (int32_t k = 0; k < rank; k++) t += g[i][k] * g[j][k];
            P[i][j] = t;
        }
}

/* Sparse rows; at least one entry in each. */
static void make_A(int32_t n, int32_t m)
{
    for (int32_t i = 0; i < m; i++) {
        for (int32_t j = 0; j < n; j++) A[i][j] = whole(0, 3) ? 0 : real(-1, 1);
        const int32_t kept = whole(0, n - 1);
        A[i][kept] = real(0.5, 1);
    }
}

/* Bounds and multipliers around z = A x: `equations` first, then a share of active rows, of which `weak` have no multiplier. */
static void make_bounds(int32_t n, int32_t m, int32_t equations, int32_t active, int weak)
{
    for (int32_t i = 0; i < m; i++) {
        double z = 0;
        for (int32_t j = 0; j < n; j++) z += A[i][j] * x[j];
        const double room = real(0.1, 2), push = weak && whole(0, 1) ? 0 : real(0.1, 2);
        const int side = whole(0, 1), open = whole(0, 2) == 0;
        y[i] = 0;
        if (i < equations) { lo[i] = up[i] = z; y[i] = real(-1, 1); }
        else if (i < equations + active) {
            lo[i] = side ? (open ? -1e30 : z - room) : z;
            up[i] = side ? z : (open ? 1e30 : z + room);
            y[i] = side ? push : -push;
        } else { lo[i] = open && side ? -1e30 : z - room; up[i] = open && !side ? 1e30 : z + room; }
    }
}

/* Into columns; q from KKT where `optimal`. P and A are rounded to sp_real first, so that what is known is known of them; bounds
 * are met but for their own rounding. */
static void finish(int32_t n, int32_t m, int optimal)
{
    int32_t p = 0, a = 0;
    for (int32_t j = 0; j < n; j++) {
        for (int32_t i = 0; i < n; i++) P[i][j] = (double)R(P[i][j]);
        for (int32_t i = 0; i < m; i++) A[i][j] = (double)R(A[i][j]);
    }
    for (int32_t j = 0; j < n; j++) {
        s.Pp[j] = p;
        for (int32_t i = 0; i <= j; i++) if (size_of(P[i][j]) > 0) { s.Pi[p] = i; s.Px[p++] = R(P[i][j]); }
        s.Ap[j] = a;
        for (int32_t i = 0; i < m; i++) if (size_of(A[i][j]) > 0 && a < MOST) { s.Ai[a] = i; s.Ax[a++] = R(A[i][j]); }
    }
    s.Pp[n] = p;
    s.Ap[n] = a;
    s.objective = s.size = 0;
    for (int32_t j = 0; j < n; j++) {
        double px = 0, q = 0;
        for (int32_t i = 0; i < n; i++) px += P[j][i] * x[i];
        for (int32_t i = 0; i < m; i++) q -= A[i][j] * y[i];
        if (optimal) s.q[j] = R(q - px);
        s.objective += (0.5 * px + (double)s.q[j]) * x[j];
        s.size += size_of(0.5 * px * x[j]) + size_of((double)s.q[j] * x[j]);
    }
    for (int32_t i = 0; i < m; i++) { s.l[i] = R(lo[i]); s.u[i] = R(up[i]); }
    const sp_qp qp = { n, m, s.Pp, s.Pi, s.Px, s.q, s.Ap, s.Ai, s.Ax, s.l, s.u };
    s.qp = qp;
}

/* Units of the unknowns and rows changed by up to 10^e either way: x = S x', row i times t_i. */
static void rescale(int32_t n, int32_t m, int32_t e)
{
    for (int32_t j = 0; j < n; j++) {
        const double c = power(e);
        for (int32_t i = 0; i < m; i++) A[i][j] *= c;
        for (int32_t i = 0; i < n; i++) { P[i][j] *= c; P[j][i] *= c; }
        x[j] /= c;
    }
    for (int32_t i = 0; i < m; i++) {
        const double c = power(e);
        for (int32_t j = 0; j < n; j++) A[i][j] *= c;
        if (size_of(lo[i]) < 1e19) lo[i] *= c;
        if (size_of(up[i]) < 1e19) up[i] *= c;
        y[i] /= c;
    }
}

/* Row i becomes minus a positive sum of some others, shifted so that together they can't be met: y >= 0 of them is a proof. */
static void make_infeasible(int32_t n, int32_t m)
{
    double sum = 0, t[N] = { 0 };
    const int32_t rows = whole(1, 5);
    for (int32_t k = 0; k < rows; k++) {
        const double c = real(0.2, 1);
        for (int32_t j = 0; j < n; j++) t[j] += c * A[k][j];
        if (size_of(up[k]) > 1e19) up[k] = (size_of(lo[k]) < 1e19 ? lo[k] : 0) + real(0, 1);
        sum += c * up[k];
    }
    for (int32_t j = 0; j < n; j++) A[m - 1][j] = -t[j];
    lo[m - 1] = -1e30;
    up[m - 1] = -sum - real(0.1, 1);                    /* sum c a'x <= sum, -sum c a'x <= -sum - 0.1 */
}

/* A direction d with P d = 0, A d >= 0 where only l is given, and q'd < 0. */
static void make_unbounded(int32_t n, int32_t m)
{
    double d[N] = { 0 }, dd = 0, qd = 0;
    for (int32_t j = 0; j < n; j++) { d[j] = whole(0, 1) ? 0 : real(-1, 1); dd += d[j] * d[j]; }
    if (!(dd > 0.1)) { dd += 1 - d[0] * d[0]; d[0] = 1; }
    for (int32_t i = 0; i < n; i++) {                   /* P <- (I - dd'/d'd) P (I - dd'/d'd) */
        double t = 0;
        for (int32_t j = 0; j < n; j++) t += P[i][j] * d[j] / dd;
        for (int32_t j = 0; j < n; j++) P[i][j] -= t * d[j];
    }
    for (int32_t j = 0; j < n; j++) {
        double t = 0;
        for (int32_t i = 0; i < n; i++) t += P[i][j] * d[i] / dd;
        for (int32_t i = 0; i < n; i++) P[i][j] -= t * d[i];
    }
    for (int32_t i = 0; i < n; i++) for (int32_t j = 0; j < i; j++) P[i][j] = P[j][i] = 0.5 * (P[i][j] + P[j][i]);
    for (int32_t i = 0; i < m; i++) {
        double t = 0;
        for (int32_t j = 0; j < n; j++) t += A[i][j] * d[j];
        if (t < 0) for (int32_t j = 0; j < n; j++) A[i][j] = -A[i][j];
        if (up[i] < 1e19) { lo[i] = -size_of(lo[i]) - 1; up[i] = 1e30; }
        if (lo[i] > 0) lo[i] = -lo[i];
    }
    for (int32_t j = 0; j < n; j++) { s.q[j] = test_random_real(-1, 1); qd += (double)s.q[j] * d[j]; }
    for (int32_t j = 0; j < n; j++) s.q[j] -= R((qd + 0.5 * dd) * d[j] / dd);
}

static void make(kind k)
{
    const int32_t n = whole(3, N), m = k == LINEAR || k == POINT ? n + whole(2, N) : whole(1, 2 * n);
    int32_t equations = m > 4 ? whole(0, (m < n ? m : n) / 3) : 0, active = n > equations ? whole(0, (n - equations) / 2) : 0;
    for (int32_t j = 0; j < n; j++) x[j] = real(-2, 2);
    s.kind = k;
    make_P(n, k == STRICT || k == SPREAD ? n : k == LINEAR ? 0 : whole(1, n), k == STRICT || k == SPREAD ? 0.1 : 0);
    make_A(n, m);
    if (k == LINEAR) { equations = n / 4; active = n - equations; }
    if (k == DEGENERATE) active = m - equations < n ? m - equations : n;
    if (k == EQUALITIES) { equations = m < n ? m : n - 1; active = 0; }
    if (k == REDUNDANT)
        for (int32_t i = m / 2; i < m; i++) {           /* the second half repeats the first, turned and stretched */
            const double c = whole(0, 1) ? 1 : -2;
            for (int32_t j = 0; j < n; j++) A[i][j] = c * A[i - m / 2][j];
        }
    if (k == REDUNDANT) equations = m > 8 ? m / 2 + m / 4 : 0;
    if (active > m - equations) active = m - equations;
    if (k == BOXED)
        for (int32_t i = 0; i < m && i < n; i++)
            for (int32_t j = 0; j < n; j++) A[m - 1 - i][j] = i == j;
    if (k == POINT) { equations = 0; active = 0; }
    make_bounds(n, m, equations, active, k == DEGENERATE);
    if (k == POINT)                                     /* a'x <= b rows that leave one point: x_j <= and -sum x_j <= , or l = u */
        for (int32_t i = 0; i < m; i++) {
            double z = 0;
            for (int32_t j = 0; j < n; j++) A[i][j] = i < n ? i == j : i == n ? -1 : A[i][j];
            for (int32_t j = 0; j < n; j++) z += A[i][j] * x[j];
            lo[i] = -1e30;
            up[i] = i <= n ? z : z + real(0, 1);
            y[i] = i <= n ? real(0, 1) : 0;
        }
    if (k == SPREAD) rescale(n, m, 4);                  /* entries of P and A from 1e-8 to 1e8 */
    if (k == INFEASIBLE) {
        if (m < 7) { make(k); return; }
        make_infeasible(n, m);
    }
    if (k == UNBOUNDED) make_unbounded(n, m);
    finish(n, m, k != UNBOUNDED);
}

/* What came out: 0 right, 1 not decided, 2 a false claim; the worst relative error of the objective in *error. */
static int outcome(const sp_qp_result *r, double *error)
{
    const int feasible = s.kind < INFEASIBLE;
    if (r->status == SP_QP_SOLVED) {
        const double e = size_of((double)r->objective - s.objective) / (size_of(s.objective) + 1e-3 * s.size + 1e-30);
        if (!feasible) return 2;
        if (e > *error) *error = e;
        return e <= EXACT(1e-6, 2e-4) ? 0 : 2;
    }
    if (r->status == SP_QP_PRIMAL_INFEASIBLE) return s.kind == INFEASIBLE ? 0 : 2;
    if (r->status == SP_QP_DUAL_INFEASIBLE) return s.kind == UNBOUNDED ? 0 : 2;
    return 1;
}

static void battery(sp_qp_backend backend, int each)
{
    int false_claims = 0, undecided = 0;
    sp_qp_settings set = sp_qp_default();
    set.backend = backend;
    set.eps_abs = set.eps_rel = R(EPS(1e-8, 1e-4));
    for (int k = 0; k < KINDS; k++) {
        double error = 0;
        long iterations = 0, factorisations = 0, open = 0;
        for (int trial = 0; trial < each; trial++) {
            sp_qp_result r;
            make((kind)k);
            test_arena.used = 0;
            NEED(sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &r) == SP_OK);
            const int o = outcome(&r, &error);
            if (o == 2 || (o == 1 && TELL)) TEST_PRINT("%s %d: n %d m %d, %s after %d, objective %.9g want %.9g, residuals %.2g %.2g gap %.2g radius %.2g\n", kind_name[k], trial,
                (int)s.qp.n, (int)s.qp.m, sp_qp_status_text(r.status), (int)r.iterations, (double)r.objective, s.objective, (double)r.primal, (double)r.dual, (double)r.gap, (double)r.radius);
            false_claims += o == 2;
            open += o == 1;
            iterations += r.iterations;
            factorisations += r.factorisations;
        }
        undecided += (int)open;
        if (TELL) TEST_PRINT("%-10s open %ld/%d iterations %ld factorisations %ld error %.2g\n", kind_name[k], open, each, iterations / each, factorisations / each, error);
    }
    CHECK_INT(false_claims, 0);
    CHECK(undecided <= OPEN + KINDS * each / 100);
}
TEST(battery_sparse) { battery(SP_QP_SPARSE, EACH); }
TEST(battery_dense)  { battery(SP_QP_DENSE, EACH); }
#if !defined SP_QP_NO_CG || defined SP_SMALL
TEST(battery_cg)     { battery(SP_QP_CG, EACH); }
#endif


/* ------------------------------------------------------------------------------------------------------ small known ones */

/* min (x1 - 1)^2 + (x2 - 2)^2 with x1 + x2 = 2, 0 <= x <= 0.7: x = (0.7, 0.7) breaks the sum, so u of x2 is 1.5: (0.5, 1.5) */
static const int32_t Pp2[] = { 0, 1, 2 }, Pi2[] = { 0, 1 }, Ap2[] = { 0, 2, 4 }, Ai2[] = { 0, 1, 0, 2 };
static const sp_real Px2[] = { 2, 2 }, q2[] = { -2, -4 }, Ax2[] = { 1, 1, 1, 1 };
static const sp_real l2[] = { 2, 0, 0 }, u2[] = { 2, R(1.5), R(1.5) };
static const sp_qp small = { 2, 3, Pp2, Pi2, Px2, q2, Ap2, Ai2, Ax2, l2, u2 };


static sp_qp_settings with(sp_qp_backend backend)
{
    sp_qp_settings set = sp_qp_default();
    set.backend = backend;
    if (ADMM_ALONE) set.method = SP_QP_ADMM;
    return set;
}

TEST(a_point_on_a_line_is_found)
{
    for (int k = 0; k < BACKENDS; k++) {
        const sp_qp_settings set = with(all[k]);
        sp_qp_result r;
        NEED(sp_qp_solve(&small, &set, &test_arena, NULL, NULL, &r) == SP_OK);
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_NEAR(r.x[0], 0.5, EXACT(1e-9, 5e-4));
        CHECK_NEAR(r.x[1], 1.5, EXACT(1e-9, 5e-4));
        CHECK_NEAR(r.objective, 0.25 + 0.25 - 5, EXACT(1e-9, 2e-5));
        CHECK_WITHIN(r.y[1], 0, EXACT(1e-6, 1e-4));       /* x1 is free, so y0 = 2 - 2 x1 = 1, y2 = 4 - 2 x2 - y0 = 0 */
        CHECK_NEAR(r.y[0], 1, EXACT(1e-6, 1e-3));
        CHECK(r.flops > 0 && r.factorisations > 0);
    }
}

TEST(no_rows_and_no_P_are_fine)
{
    for (int k = 0; k < BACKENDS; k++) {
        const sp_qp_settings set = with(all[k]);
        sp_qp free_one = small, line = small;
        sp_qp_result r;
        free_one.m = 0;
        free_one.Ap = free_one.Ai = NULL;
        free_one.Ax = free_one.l = free_one.u = NULL;
        NEED(sp_qp_solve(&free_one, &set, &test_arena, NULL, NULL, &r) == SP_OK);
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_NEAR(r.x[0], 1, EXACT(1e-6, 1e-4));
        CHECK_NEAR(r.x[1], 2, EXACT(1e-6, 1e-4));
        line.Pp = line.Pi = NULL;
        line.Px = NULL;
        NEED(sp_qp_solve(&line, &set, &test_arena, NULL, NULL, &r) == SP_OK);
        CHECK_INT(r.status, SP_QP_SOLVED);              /* -2 x1 - 4 x2 on the line: as much x2 as there is */
        CHECK_NEAR(r.x[1], 1.5, EXACT(1e-6, 1e-4));
        free_one.Pp = free_one.Pi = NULL;
        free_one.Px = NULL;
        NEED(sp_qp_solve(&free_one, &set, &test_arena, NULL, NULL, &r) == SP_OK);
        CHECK_INT(r.status, SP_QP_DUAL_INFEASIBLE);
        CHECK(r.x[0] > 0 && r.x[1] > 0);
    }
}

/* x <= 0, -x <= -t: one point for t = 0, none for t > 0; seen in OSQP as infeasible also for t = 0. */
TEST(one_feasible_point_is_not_none)
{
    static const int32_t Ap[] = { 0, 2 }, Ai[] = { 0, 1 };
    static const sp_real Ax[] = { 1, -1 }, l[] = { R(-1e30), R(-1e30) };
    for (int k = 0; k < BACKENDS; k++)
        for (int t = 0; t < 5; t++) {
            static const double at[] = { 0, 1, -1, 1e3, 1e-3 };
            for (int gap = 0; gap < 2; gap++) {
                const sp_real u[] = { R(at[t]), R(-at[t] - gap * 0.01) }, q[] = { R(1) };
                const sp_qp qp = { 1, 2, NULL, NULL, NULL, q, Ap, Ai, Ax, l, u };
                const sp_qp_settings set = with(all[k]);
                sp_qp_result r;
                NEED(sp_qp_solve(&qp, &set, &test_arena, NULL, NULL, &r) == SP_OK);
                if (gap) CHECK(r.status != SP_QP_SOLVED || size_of(at[t]) > 2);   /* a hundredth of a thousand is within eps */
                else CHECK_INT(r.status, SP_QP_SOLVED);
                if (!gap) CHECK_WITHIN(r.x[0], at[t], TOL(1e-4, 1e-3) * (1 + size_of(at[t])));
            }
        }
}

/* ------------------------------------------------------------------------------------------------------------ refusals */

static sp_status solve(const sp_qp *qp)
{
    sp_qp_result r;
    r.iterations = -7;
    const size_t used = test_arena.used;
    const sp_status status = sp_qp_solve(qp, NULL, &test_arena, NULL, NULL, &r);
    if (status != SP_OK) CHECK(r.iterations == -7 && test_arena.used == used);
    return status;
}

TEST(bad_problems_are_refused)
{
    static const int32_t lower[] = { 0, 2, 3 }, rows[] = { 0, 1, 1 }, twice[] = { 0, 0, 0, 2 }, out[] = { 0, 3, 0, 2 };
    static const sp_real three[] = { 2, 1, 2 }, saddle[] = { 2, -1 };
    const sp_real nan = R(0) / (test_arena.used ? R(1) : R(0)), inf = R(1) / (test_arena.used ? R(1) : R(0));
    const sp_real bad[] = { nan, 0, 0 }, high[] = { inf, 1, 1 }, minus[] = { 1, 1, -1 };
    sp_qp qp = small;
    CHECK_INT(sp_qp_solve(NULL, NULL, &test_arena, NULL, NULL, NULL), SP_E_ARGUMENT);
    qp.n = 0; CHECK_INT(solve(&qp), SP_E_EMPTY); qp = small;
    CHECK(sp_qp_memory_scratch(&qp, NULL) > 0);
    qp.m = -1; CHECK_INT(solve(&qp), SP_E_ARGUMENT); CHECK(sp_qp_memory_scratch(&qp, NULL) == 0); qp = small;
    qp.l = NULL; CHECK_INT(solve(&qp), SP_E_ARGUMENT); qp = small;
    qp.Ai = NULL; CHECK_INT(solve(&qp), SP_E_ARGUMENT); qp = small;
    qp.Pp = lower; qp.Pi = rows; qp.Px = three; CHECK_INT(solve(&qp), SP_E_INDEX); qp = small;     /* the lower triangle */
    qp.Ai = twice; CHECK_INT(solve(&qp), SP_E_INDEX); qp = small;
    qp.Ai = out; CHECK_INT(solve(&qp), SP_E_INDEX); qp = small;
    qp.l = bad; CHECK_INT(solve(&qp), SP_E_NOT_FINITE); qp = small;
    qp.q = bad; CHECK_INT(solve(&qp), SP_E_NOT_FINITE); qp = small;
    qp.q = high; CHECK_INT(solve(&qp), SP_E_NOT_FINITE); qp = small;
    qp.l = high; CHECK_INT(solve(&qp), SP_E_RANGE); qp = small;
    qp.u = minus; CHECK_INT(solve(&qp), SP_E_RANGE); qp = small;                                    /* below l */
    qp.Px = saddle; CHECK_INT(solve(&qp), SP_E_INDEFINITE);
    CHECK_INT(solve(&small), SP_OK);
}

/* Eigenvalues 1 .. n but one of -t: no minor of two rows shows it. */
TEST(indefinite_P_is_refused_by_every_back_end)
{
    for (int trial = 0; trial < 20; trial++) {
        const int32_t n = test_random_int(3, 12), m = 2;
        double v[N], vv = 0;
        make_P(n, n, 1);
        for (int32_t j = 0; j < n; j++) { v[j] = real(-1, 1); x[j] = 0; vv += v[j] * v[j]; }
        double vPv = 0;
        for (int32_t i = 0; i < n; i++) for (int32_t j = 0; j < n; j++) vPv += v[i] * P[i][j] * v[j];
        const double drop = trial % 2 ? vPv * 1.01 : vPv * 0.9;                 /* v'(P - drop vv'/vv^2)v = vPv - drop */
        for (int32_t i = 0; i < n; i++) for (int32_t j = 0; j < n; j++) P[i][j] -= drop * v[i] * v[j] / (vv * vv);
        make_A(n, m);
        make_bounds(n, m, 0, 0, 0);
        finish(n, m, 1);
        for (int k = 0; k < BACKENDS; k++) {
            const sp_qp_settings set = with(all[k]);
            sp_qp_result r;
            const sp_status status = sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &r);
            if (trial % 2) CHECK_INT(status, SP_E_INDEFINITE);
        }
    }
}

/* Numbers of every size, denormal to nearly infinite, in every place: whatever the status, what comes out are numbers. */
TEST(no_NaN_leaves_whatever_goes_in)
{
    for (int trial = 0; trial < SOME_OF(300, 60); trial++) {
        sp_qp_settings set = with(all[trial % BACKENDS]);
        sp_real *const arrays[] = { s.Px, s.Ax, s.q, s.l, s.u };
        sp_qp_result r;
        int numbers = 1;
        make((kind)(trial % KINDS));
        set.iterations = 300;
        const int32_t sizes[] = { s.Pp[s.qp.n], s.Ap[s.qp.n], s.qp.n, s.qp.m, s.qp.m };
        const int where = test_random_int(0, 4);
        for (int32_t k = 0; k < sizes[where]; k++)
            if (whole(0, 2) == 0) arrays[where][k] *= R(power(sizeof(sp_real) == 4 ? 30 : 250));
        for (int32_t i = 0; i < s.qp.m; i++) if (s.l[i] > s.u[i]) s.u[i] = s.l[i];
        const sp_status status = sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &r);
        if (status != SP_OK) continue;
        for (int32_t j = 0; j < s.qp.n; j++) numbers &= r.x[j] - r.x[j] >= 0;
        for (int32_t i = 0; i < s.qp.m; i++) numbers &= r.y[i] - r.y[i] >= 0;
        CHECK(numbers && r.objective - r.objective >= 0 && r.primal - r.primal >= 0 && r.dual - r.dual >= 0 && r.gap - r.gap >= 0);
    }
}

/* Sizes 10^-e .. 10^e in every place, rows that cancel, nothing known: whatever is claimed holds in longer arithmetic.
 * Without sums of |terms| in its residuals a float build calls one in a thousand of these solved that is not. */
static void make_wild(int32_t e)
{
    const int32_t n = whole(1, 10), m = whole(0, 16), rank = whole(0, n);
    static double g[N][N];
    for (int32_t i = 0; i < n; i++) for (int32_t k = 0; k < rank; k++) g[i][k] = whole(0, 1) ? 0 : spread(-1, e / 2);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++) {
            P[i][j] = x[i] = 0;
            for (int32_t k = 0; k < rank; k++) P[i][j] += g[i][k] * g[j][k];
        }
    for (int32_t j = 0; j < n; j++) s.q[j] = R(whole(0, 2) ? spread(-1, e) : 0);
    for (int32_t i = 0; i < m; i++) {
        const int bounds = whole(0, 4);
        const double at = spread(-1, e), room = bounds == 2 ? 0 : spread(0, e);
        for (int32_t j = 0; j < n; j++) A[i][j] = whole(0, 2) ? 0 : spread(-1, e);
        lo[i] = bounds == 0 ? -1e30 : at;
        up[i] = bounds == 1 ? 1e30 : at + room;
        y[i] = 0;
    }
    finish(n, m, 0);
}

typedef long double longer;                             /* of a float build a double would do; elsewhere it is what there is */
static longer size_of_longer(longer v) { return v < 0 ? -v : v; }
static longer larger(longer a, longer b) { return b > a ? b : a; }
static longer over(longer r, longer tol) { return r > 0 || r < 0 ? r / tol : 0; }

/* What the claim of a solution is out by, in units of its tolerances and of what rounding excuses. */
static double overclaim(const sp_qp_result *r, const sp_qp_settings *set)
{
    const longer u = 4 * SP_EPSILON;
    longer ax[M] = { 0 }, px[N] = { 0 }, off = 0, size = 0, most = 0, value = 0, gap = 0, terms = 0;
    for (int32_t j = 0; j < s.qp.n; j++) {
        for (int32_t k = s.Ap[j]; k < s.Ap[j + 1]; k++) ax[s.Ai[k]] += (longer)s.Ax[k] * r->x[j];
        for (int32_t k = s.Pp[j]; k < s.Pp[j + 1]; k++) {
            px[s.Pi[k]] += (longer)s.Px[k] * r->x[j];
            if (s.Pi[k] < j) px[j] += (longer)s.Px[k] * r->x[s.Pi[k]];
        }
    }
    for (int32_t i = 0; i < s.qp.m; i++) {
        const longer to = s.l[i] > -SP_QP_INFINITY && ax[i] < s.l[i] ? s.l[i] : s.u[i] < SP_QP_INFINITY && ax[i] > s.u[i] ? s.u[i] : ax[i];
        const longer push = (longer)r->y[i] * (r->y[i] > 0 ? s.u[i] : s.l[i]);
        size = larger(size, larger(size_of_longer(ax[i]), size_of_longer(to)));
        off = larger(off, size_of_longer(ax[i] - to));
        gap += push;
        terms += size_of_longer(push);
        if (r->y[i] > 0 ? !(s.u[i] < SP_QP_INFINITY) : r->y[i] < 0 && !(s.l[i] > -SP_QP_INFINITY)) return 1e30;
    }
    double worst = (double)over(off, set->eps_abs + (set->eps_rel + u) * size);
    off = size = 0;
    for (int32_t j = 0; j < s.qp.n; j++) {
        longer ay = 0;
        for (int32_t k = s.Ap[j]; k < s.Ap[j + 1]; k++) ay += (longer)s.Ax[k] * r->y[s.Ai[k]];
        most = larger(size_of_longer(px[j]), larger(size_of_longer(ay), size_of_longer((longer)s.q[j])));
        size = larger(size, most);
        off = larger(off, size_of_longer(px[j] + s.q[j] + ay));
        value += (px[j] / 2 + s.q[j]) * r->x[j];
        gap += (px[j] + s.q[j]) * r->x[j];
        terms += (size_of_longer(px[j]) + size_of_longer((longer)s.q[j])) * size_of_longer((longer)r->x[j]);
    }
    worst = (double)larger(worst, over(off, set->eps_abs + (set->eps_rel + u) * size));
    return (double)larger(worst, over(size_of_longer(gap), set->eps_abs + set->eps_rel * size_of_longer(value) + u * terms));
}

TEST(what_is_claimed_of_wild_numbers_holds)
{
    const int trials = SOME_OF(WILD, WILD / 3);
    int solved = 0, false_claims = 0;
    for (int trial = 0; trial < trials; trial++) {
        sp_qp_settings set = with(all[trial % BACKENDS]);
        sp_qp_result r;
        make_wild(trial % 9);
            set.iterations = 200;
        set.eps_abs = set.eps_rel = R(TOL(1e-8, 1e-4));
        if (trial % 4 == 0) set.eps_abs = 0;
        if (sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &r) != SP_OK || r.status != SP_QP_SOLVED) continue;
        const double times = overclaim(&r, &set);
        solved++;
        if (times <= 2) continue;
        false_claims++;
        TEST_PRINT("wild %d: called solved, %.3g times its tolerance\n", trial, times);
    }
    CHECK_INT(false_claims, 0);
    CHECK(solved > trials / 20);
}

/* Nothing to do and no absolute tolerance: 0 is within 0 of 0. */
TEST(nothing_is_solved_to_no_tolerance)
{
    static const sp_real zero[] = { 0, 0 }, l[] = { -1, -1, -1 }, u[] = { 1, 1, 1 };
    for (int k = 0; k < BACKENDS; k++) {
        sp_qp_settings set = with(all[k]);
        sp_qp_result r;
        sp_qp qp = small;
        qp.q = zero;
        qp.l = l;
        qp.u = u;
        set.eps_abs = 0;
        NEED(sp_qp_solve(&qp, &set, &test_arena, NULL, NULL, &r) == SP_OK);
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_WITHIN(r.objective, 0, 0);
    }
}

/* --------------------------------------------------------------------------------------------------------------- memory */

TEST(memory_is_exact)
{
    for (int trial = 0; trial < 12; trial++) {
        size_t bytes = 0;
        make((kind)(trial % KINDS));
        const sp_qp_settings set = with(all[trial % BACKENDS]);
        sp_arena scratch = test_arena, a;
        const size_t need = sp_qp_memory_scratch(&s.qp, &set);
        NEED(need > 0 && need < test_arena.capacity);
        scratch.capacity = need;
        NEED(sp_qp_memory(&s.qp, &set, scratch, &bytes) == SP_OK);
        scratch.capacity = need - 1;
        if (all[trial % BACKENDS] == SP_QP_SPARSE && !TEST_SMALL) CHECK_INT(sp_qp_memory(&s.qp, &set, scratch, &bytes), SP_E_MEMORY);
        sp_qp_work *work;
        sp_arena_init(&a, test_arena.base, bytes);
        CHECK_INT(sp_qp_setup(&s.qp, &set, &a, &work), SP_OK);
        CHECK_INT(a.peak, bytes);
        sp_arena_init(&a, test_arena.base, bytes - 1);
        CHECK_INT(sp_qp_setup(&s.qp, &set, &a, &work), SP_E_MEMORY);
        CHECK_INT(a.used, 0);
    }
}

/* --------------------------------------------------------------------------------------------------- repeated solves */

TEST(warm_start_and_updates_cost_less)
{
    for (int k = 0; k < BACKENDS; k++) {
        sp_qp_settings set = with(all[k]);
        sp_qp_work *work;
        sp_qp_result cold, warm, moved;
        set.method = SP_QP_ADMM;                        /* which keeps its factor; interior points have no use for a guess */
        set.polish = 0;
        make(STRICT);
        NEED(sp_qp_setup(&s.qp, &set, &test_arena, &work) == SP_OK);
        NEED(sp_qp_run(work, NULL, NULL, &cold) == SP_OK);
        NEED(cold.status == SP_QP_SOLVED);
        const int32_t first = cold.iterations;
        const sp_real objective = cold.objective;
        CHECK_INT(sp_qp_run(work, cold.x, cold.y, &warm), SP_OK);
        CHECK_INT(warm.status, SP_QP_SOLVED);
        CHECK(warm.iterations <= first);
        CHECK_INT(warm.factorisations, 0);
        for (int32_t j = 0; j < s.qp.n; j++) q_new[j] = s.q[j] * R(1.001);
        CHECK_INT(sp_qp_update(work, q_new, NULL, NULL), SP_OK);
        CHECK_INT(sp_qp_run(work, warm.x, warm.y, &moved), SP_OK);
        CHECK_INT(moved.status, SP_QP_SOLVED);
        CHECK(moved.factorisations <= 1);               /* of a rho that was adapted */
        CHECK_INT(sp_qp_update(work, s.q, NULL, NULL), SP_OK);
        CHECK_INT(sp_qp_rho(work, R(0.2)), SP_OK);
        CHECK_INT(sp_qp_run(work, NULL, NULL, &moved), SP_OK);
        CHECK(moved.factorisations >= 1);
        CHECK_NEAR(moved.objective, objective, TOL(1e-3, 1e-2));
        CHECK_INT(sp_qp_rho(work, 0), SP_E_RANGE);
        s.l[0] = R(2); s.u[0] = R(1);
        CHECK_INT(sp_qp_update(work, NULL, s.l, s.u), SP_E_RANGE);
    }
}

/* Whatever the budget, no more flops than that; and the answer is one that can be read. */
TEST(a_budget_is_a_cap)
{
    for (int trial = 0; trial < 4 * BACKENDS; trial++) {
        static const kind of[] = { LINEAR, DEGENERATE, INFEASIBLE, SPREAD };
        sp_qp_settings set = with(all[trial % BACKENDS]);
        sp_qp_result all_of_it, r;
        set.eps_abs = set.eps_rel = R(EPS(1e-9, 1e-4));
        make(of[trial / BACKENDS]);
        NEED(sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &all_of_it) == SP_OK);
        for (int k = SOME_OF(0, 1); k < 12; k += SOME_OF(1, 2)) {
            const double share[] = { 1, 0.9, 0.7, 0.5, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01, 0.001, 0 };
            set.budget = (int64_t)(share[k] * (double)all_of_it.flops) + 1;
            NEED(sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &r) == SP_OK);
            const int told = r.status == SP_QP_BUDGET || r.status == SP_QP_INACCURATE || r.status == all_of_it.status;
            CHECK(told && r.objective - r.objective >= 0 && r.gap >= 0 && r.primal >= 0 && r.dual >= 0);
            if (r.iterations > 0) CHECK(r.flops <= set.budget);
            if (share[k] < 0.001) CHECK_INT(r.iterations, 0);
        }
    }
}

TEST(the_limit_of_iterations_is_told)
{
    sp_qp_settings set = with(SP_QP_SPARSE);
    sp_qp_result r;
    set.polish = 0;
    set.eps_abs = set.eps_rel = R(TOL(1e-14, 1e-7));
    make(LINEAR);
    for (int method = SP_QP_ADMM; method <= SP_QP_AUTO; method++) {
        set.method = (sp_qp_method)method;
        if (LACKS(set.method)) continue;
        set.iterations = method == SP_QP_ADMM ? 20 : 4;
        NEED(sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &r) == SP_OK);
        CHECK(r.status == SP_QP_ITERATIONS || r.status == SP_QP_INACCURATE);
        CHECK_INT(r.iterations, set.iterations);
    }
}

TEST(same_input_same_bits)
{
    sp_qp_result a, b;
    make(BOXED);
    NEED(sp_qp_solve(&s.qp, NULL, &test_arena, NULL, NULL, &a) == SP_OK);
    NEED(sp_qp_solve(&s.qp, NULL, &test_arena, NULL, NULL, &b) == SP_OK);
    CHECK_INT(a.flops, b.flops);
    for (int32_t j = 0; j < s.qp.n; j++) CHECK_WITHIN(a.x[j], b.x[j], 0);
}

/* The struct that others fill in, filled in with ours. */
TEST(plugged_in_our_solver_is_the_same)
{
    const sp_qp_solver own = sp_qp_admm();
    sp_qp_settings set = with(SP_QP_SPARSE);
    size_t bytes = 0, again = 1;
    sp_qp_result a, b;
    set.method = SP_QP_ADMM;
    make(STRICT);
    NEED(sp_qp_memory(&s.qp, &set, test_arena, &bytes) == SP_OK);
    CHECK_INT(own.need(own.self, &s.qp, &set, test_arena, &again), SP_OK);
    CHECK_INT(bytes, again);
    NEED(sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &a) == SP_OK);
    NEED(own.solve(own.self, &s.qp, &set, &test_arena, NULL, NULL, &b) == SP_OK);
    CHECK_INT(a.status, SP_QP_SOLVED);
    CHECK_INT(a.flops, b.flops);
    for (int32_t j = 0; j < s.qp.n; j++) CHECK_WITHIN(a.x[j], b.x[j], 0);
}

TEST(words_of_quadratic_programs_are_there_without_stones)
{
    CHECK_TEXT(sp_qp_status_text(SP_QP_SOLVED), "solved");
    CHECK_TEXT(sp_qp_status_text((sp_qp_status)99), "unknown");
    CHECK_TEXT(sp_status_text(SP_OK), "no error");
    CHECK_TEXT(sp_text((sp_words)99, 0), "unknown");
    CHECK_TEXT(sp_text(SP_WORDS_STATUS, 1), "unknown");
    CHECK_TEXT(sp_text(SP_WORDS_STATUS, -17), "unknown");
    CHECK_TEXT(sp_text(SP_WORDS_STATUS, INT32_MIN), "unknown");
    CHECK_TEXT(sp_text(SP_WORDS_QP_STATUS, -1), "unknown");
    CHECK_TEXT(sp_text(SP_WORDS_QP_STATUS, 6), "numerical");
    CHECK_TEXT(sp_text(SP_WORDS_QP_STATUS, 7), "unknown");
#ifdef SP_QP_ONLY
    for (int of = SP_WORDS_VERDICT; of <= SP_WORDS_NBO; of++) CHECK_TEXT(sp_text((sp_words)of, 0), "unknown");
#else
    for (int of = SP_WORDS_VERDICT; of <= SP_WORDS_NBO; of++) CHECK(strcmp(sp_text((sp_words)of, 0), "unknown") != 0);
#endif
}

TEST_LIST(qp)
    RUN(words_of_quadratic_programs_are_there_without_stones)
    RUN(a_point_on_a_line_is_found)
    RUN(no_rows_and_no_P_are_fine)
    RUN(one_feasible_point_is_not_none)
    RUN(bad_problems_are_refused)
    RUN(indefinite_P_is_refused_by_every_back_end)
    RUN(no_NaN_leaves_whatever_goes_in)
    RUN(what_is_claimed_of_wild_numbers_holds)
    RUN(nothing_is_solved_to_no_tolerance)
    RUN(memory_is_exact)
    RUN(warm_start_and_updates_cost_less)
    RUN(a_budget_is_a_cap)
    RUN(the_limit_of_iterations_is_told)
    RUN(same_input_same_bits)
    RUN(plugged_in_our_solver_is_the_same)
    RUN(battery_sparse)
    RUN(battery_dense)
#if !defined SP_QP_NO_CG || defined SP_SMALL
    RUN(battery_cg)
#endif
TEST_END
