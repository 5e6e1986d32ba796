/* Linear programs without an objective: points that meet every row, proofs where there is none, and both again from where the
 * program before ended. Programs are made around a known point or around a known proof. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/lp.c"

enum { MOST_N = 40, MOST_M = 160 };

static double A[MOST_M][MOST_N];
static double low[MOST_M + MOST_N], high[MOST_M + MOST_N];      /* rows, then variables */

static double size_of(double x) { return x < 0 ? -x : x; }
static double random_real(double a, double b) { return (double)test_random_real(a, b); }

/* Small whole numbers (exact, with many ties) or reals, about half of them zero. */
static void random_rows(int32_t n, int32_t m, int whole)
{
    for (int32_t i = 0; i < m; i++)
        for (int32_t j = 0; j < n; j++) {
            A[i][j] = whole ? (double)test_random_int(-2, 2) : random_real(-1, 1);
            if (test_random_int(0, 1)) A[i][j] = 0;
        }
}

static double row_at(int32_t i, int32_t n, int32_t m, const double *x)
{
    double s = 0;
    if (i >= m) return x[i - m];
    for (int32_t j = 0; j < n; j++) s += A[i][j] * x[j];
    return s;
}

/* Bounds around a point, a share of them tight. */
static void bounds_around(int32_t n, int32_t m, const double *x, int32_t tight)
{
    for (int32_t i = 0; i < m + n; i++) {
        const double v = row_at(i, n, m, x);
        low[i] = high[i] = v;
        if (test_random_int(0, 99) >= tight) low[i] -= random_real(0.1, 3);
        if (test_random_int(0, 99) >= tight) high[i] += random_real(0.1, 3);
        if (test_random_int(0, 3) == 0) low[i] = -2e30;
        if (test_random_int(0, 3) == 0) high[i] = 2e30;
    }
}

/* The program of A, low, high in the test's arena, every entry stored so that rows can change. */
static void load(sp__lp *lp, int32_t n, int32_t m)
{
    memset(lp, 0, sizeof *lp);
    sp__lp_carve(lp, n, m, n * m, &test_arena);
    for (int32_t i = 0; i <= m; i++) lp->start[i] = n * i;
    for (int32_t i = 0; i < m; i++)
        for (int32_t j = 0; j < n; j++) {
            lp->index[n * i + j] = j;
            lp->value[n * i + j] = R(A[i][j]);
        }
    for (int32_t i = 0; i < m + n; i++) { lp->lower[i] = R(low[i]); lp->upper[i] = R(high[i]); }
    sp__lp_start(lp);
}

static double entry(int32_t i, int32_t j, int32_t m) { return i < m ? A[i][j] : i - m == j; }

/* Largest violation of x. */
static double violation(const sp__lp *lp)
{
    double worst = 0;
    for (int32_t i = 0; i < lp->m + lp->n; i++) {
        double s = 0;
        for (int32_t j = 0; j < lp->n; j++) s += entry(i, j, lp->m) * (double)lp->x[j];
        if (low[i] - s > worst) worst = low[i] - s;
        if (s - high[i] > worst) worst = s - high[i];
    }
    return worst;
}

/* By how much sum y b < 0 with sum y a = 0: what it falls short of, less |sum y a| over a box of 100. */
static double proof(const sp__lp *lp)
{
    const double sign = lp->low ? -1 : 1;
    double right = 0, left = 0;
    for (int32_t j = 0; j <= lp->n; j++) {
        double c = 0;
        for (int32_t k = 0; k <= lp->n; k++) {
            const int32_t i = k < lp->n ? lp->active[k] : lp->failed;
            const double y = k < lp->n ? -sign * (double)lp->t[k] : sign;
            if (size_of(y) <= (double)SP__LP_ZERO * 100) continue;
            if (j < lp->n) c += y * entry(i, j, lp->m);
            else right += y * (y > 0 ? high[i] : low[i]);
        }
        left += 100 * size_of(c);
    }
    return -right - left;
}

static void random_point(int32_t n, double *x, int whole)
{
    for (int32_t j = 0; j < n; j++) x[j] = whole ? (double)test_random_int(-3, 3) : random_real(-3, 3);
}

TEST(a_programme_around_a_point_has_one)
{
    for (int k = 0; k < 300; k++) {
        const int32_t n = test_random_int(1, MOST_N), m = test_random_int(0, 4 * n);
        double x[MOST_N] = { 0 };
        sp__lp lp;
        test_arena.used = 0;
        random_rows(n, m, k % 2);
        random_point(n, x, k % 2);
        bounds_around(n, m, x, k % 3 ? 50 : 100);           /* 100: the point is the only one, or nearly */
        load(&lp, n, m);
        NEED(sp__lp_run(&lp, 100000) == SP__LP_POINT);
        NEED(violation(&lp) <= TOL(1e-8, 2e-3));
    }
}

/* Rows whose sum with weights y is zero, bounds whose sum with those weights is -short: no point, by exactly that proof. */
static void infeasible(int32_t n, int32_t m, int32_t rows, double lack)
{
    double x[MOST_N] = { 0 }, y[MOST_N];
    random_rows(n, m, 0);
    random_point(n, x, 0);
    bounds_around(n, m, x, 20);
    for (int32_t j = 0; j < n; j++) A[rows][j] = 0;
    for (int32_t i = 0; i < rows; i++) {
        y[i] = random_real(0.2, 1);
        for (int32_t j = 0; j < n; j++) A[rows][j] -= y[i] * A[i][j];
    }
    low[rows] = -2e30;
    high[rows] = -lack;
    for (int32_t i = 0; i < rows; i++) {
        low[i] = -2e30;
        high[i] = row_at(i, n, m, x);
        high[rows] -= y[i] * high[i];
    }
}

TEST(a_programme_around_a_proof_is_proved_empty)
{
    for (int k = 0; k < 300; k++) {
        const int32_t n = test_random_int(2, MOST_N), m = test_random_int(n, 4 * n), rows = test_random_int(1, n - 1);
        const double lack = k % 2 ? 1 : TOL(1e-4, 0.1);
        sp__lp lp;
        test_arena.used = 0;
        infeasible(n, m, rows, lack);
        load(&lp, n, m);
        NEED(sp__lp_run(&lp, 100000) == SP__LP_NONE);
        NEED(proof(&lp) > 0);
    }
}

TEST(bounds_that_just_touch_leave_a_point)
{
    for (int k = 0; k < 100; k++) {
        const int32_t n = test_random_int(2, MOST_N), m = test_random_int(n, 4 * n), rows = test_random_int(1, n - 1);
        sp__lp lp;
        test_arena.used = 0;
        infeasible(n, m, rows, 0);
        for (int32_t i = rows + 1; i < m + n; i++) { low[i] = -2e30; high[i] = 2e30; }
        load(&lp, n, m);
        NEED(sp__lp_run(&lp, 100000) == SP__LP_POINT);
        NEED(violation(&lp) <= TOL(1e-8, 2e-3));
    }
}

/* Bounds and rows change as in a search over cases; every answer is checked on its own, and costs less than from the start. */
TEST(a_programme_goes_on_from_where_it_was)
{
    int64_t warm = 0, cold = 0;
    for (int k = 0; k < SOME_OF(30, 16); k++) {
        const int32_t n = 30, m = 60;
        double x[MOST_N] = { 0 };
        sp__lp lp, fresh;
        test_arena.used = 0;
        random_rows(n, m, k % 2);
        random_point(n, x, k % 2);
        bounds_around(n, m, x, 20);
        load(&lp, n, m);
        sp__lp_run(&lp, 100000);
        lp.steps = 0;
        for (int change = 0; change < 20; change++) {
            const int32_t i = test_random_int(0, m - 1);
            const double at = row_at(i, n, m, x) + random_real(-2, 2);
            low[i] = at - random_real(0, 1);
            high[i] = at + random_real(0, 1);
            if (change % 2) {
                sp__lp_deactivate(&lp, i);
                for (int32_t j = 0; j < n; j++) { A[i][j] = random_real(-1, 1); lp.value[n * i + j] = R(A[i][j]); }
            }
            lp.lower[i] = R(low[i]);
            lp.upper[i] = R(high[i]);
            const sp__lp_status got = sp__lp_run(&lp, 100000);
            const size_t mark = test_arena.used;
            load(&fresh, n, m);
            NEED(sp__lp_run(&fresh, 100000) == got);
            test_arena.used = mark;
            cold += fresh.steps;
            NEED(got == SP__LP_POINT ? violation(&lp) <= TOL(1e-8, 2e-3) : proof(&lp) > 0);
        }
        warm += lp.steps;
    }
    CHECK(4 * warm < cold);
}

TEST(the_same_programme_gives_the_same_bits)
{
    const int32_t n = 25, m = 80;
    double x[MOST_N] = { 0 };
    sp__lp a, b;
    random_rows(n, m, 1);
    random_point(n, x, 1);
    bounds_around(n, m, x, 60);
    load(&a, n, m);
    load(&b, n, m);
    CHECK_INT(sp__lp_run(&a, 100000), sp__lp_run(&b, 100000));
    CHECK_INT(a.steps, b.steps);
    CHECK(memcmp(a.x, b.x, (size_t)n * sizeof *a.x) == 0);
}

/* x_i <= x_i+1 - 1 in a ring: each row alone is harmless, together they ask for n <= 0. */
TEST(a_ring_of_steps_up_is_empty)
{
    const int32_t n = 20;
    sp__lp lp;
    memset(A, 0, sizeof A);
    for (int32_t i = 0; i < n; i++) {
        A[i][i] = 1;
        A[i][(i + 1) % n] = -1;
        low[i] = -2e30; high[i] = -1;
        low[n + i] = -1000; high[n + i] = 1000;
    }
    load(&lp, n, n);
    NEED(sp__lp_run(&lp, 100000) == SP__LP_NONE);
    CHECK_NEAR(proof(&lp), 20, TOL(1e-9, 1e-2));
    lp.upper[0] = R(n - 1);                                 /* one step down as far as the others go up */
    high[0] = n - 1;
    CHECK(sp__lp_run(&lp, 100000) == SP__LP_POINT && violation(&lp) <= TOL(1e-8, 2e-3));
}

TEST(without_steps_nothing_is_said)
{
    sp__lp lp;
    A[0][0] = A[0][1] = 1;
    low[0] = high[0] = 5;
    low[1] = low[2] = 0;
    high[1] = high[2] = 9;
    load(&lp, 2, 1);
    CHECK(sp__lp_run(&lp, 0) == SP__LP_GIVEN_UP);
    CHECK(sp__lp_run(&lp, 10) == SP__LP_POINT);
}

TEST_LIST(lp)
    RUN(a_programme_around_a_point_has_one)
    RUN(a_programme_around_a_proof_is_proved_empty)
    RUN(bounds_that_just_touch_leave_a_point)
    RUN(a_programme_goes_on_from_where_it_was)
    RUN(the_same_programme_gives_the_same_bits)
    RUN(a_ring_of_steps_up_is_empty)
    RUN(without_steps_nothing_is_said)
TEST_END
