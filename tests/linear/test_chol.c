/* Dense Cholesky: its factor multiplied out again, systems solved against the matrix itself and closed forms, and pivots that
 * carry nothing. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/chol.c"

enum { MOST = 40, ENTRIES = MOST * (MOST + 1) / 2 };

static sp_real A[MOST][MOST], L[ENTRIES];               /* the matrix, and its lower triangle by rows */

static size_t at(int32_t i, int32_t j) { return (size_t)(i * (i + 1) / 2 + j); }

static double size_of(double x) { return x < 0 ? -x : x; }

static void factor(int32_t n, double floor)
{
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j <= i; j++) L[at(i, j)] = A[i][j];
    sp__chol_factor(L, n, R(floor));
}

/* A = G G' + shift I of `columns` random columns: rank n with as many, less with fewer and no shift. `lead` on the diagonal of G
 * keeps its first rows far from dependent. */
static void random_matrix(int32_t n, int32_t columns, double shift, double lead)
{
    static double g[MOST][MOST];
    for (int32_t i = 0; i < n; i++)
        for (int32_t k = 0; k < columns; k++) g[i][k] = (double)test_random_real(-1, 1) + (i == k ? lead : 0);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++) {
            double s = i == j ? shift : 0;
            for (int32_t k = 0; k < columns; k++) s += g[i][k] * g[j][k];
            A[i][j] = R(s);
        }
}

/* 1 / (i + j + 1): condition e^(3.5 n) */
static void hilbert(int32_t n)
{
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++) A[i][j] = R(1.0 / (i + j + 1));
}

/* Largest |A - L L'| relative to |L| |L'|, entry by entry; in units of u at most n + 1.                  [Higham 2002, th. 10.3] */
static double product_error(int32_t n)
{
    double worst = 0;
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j <= i; j++) {
            double r = (double)A[i][j], s = 0;
            for (int32_t k = 0; k <= j; k++) {
                const double t = (double)L[at(i, k)] * (double)L[at(j, k)];
                r -= t;
                s += size_of(t);
            }
            if (size_of(r) > worst * s) worst = size_of(r) / s;
        }
    return worst / (double)SP_EPSILON;
}

/* Largest |A x - b| relative to max |A| max |x|, in units of u. */
static double residual(int32_t n, const sp_real *x, const sp_real *b)
{
    double worst = 0, a = 0, most = 0;
    for (int32_t i = 0; i < n; i++) {
        double r = -(double)b[i];
        for (int32_t j = 0; j < n; j++) {
            r += (double)A[i][j] * (double)x[j];
            if (size_of((double)A[i][j]) > a) a = size_of((double)A[i][j]);
        }
        if (size_of((double)x[i]) > most) most = size_of((double)x[i]);
        if (size_of(r) > worst) worst = size_of(r);
    }
    return worst / (a * most) / (double)SP_EPSILON;
}

TEST(factor_times_its_transpose_is_the_matrix)
{
    for (int trial = 0; trial < 60; trial++) {
        const int32_t n = test_random_int(1, MOST);
        random_matrix(n, n, trial % 3 ? 1 : 1e-3, 0);
        factor(n, 0);
        CHECK_WITHIN(product_error(n), 0, n + 1);
        for (int32_t i = 0; i < n; i++) CHECK(L[at(i, i)] > 0 && L[at(i, i)] < SP__NEVER);
    }
    for (int32_t n = 1; n <= TOL(10, 5); n++) {
        hilbert(n);
        factor(n, 0);
        CHECK_WITHIN(product_error(n), 0, n + 1);
    }
}

TEST(factor_of_a_known_product_is_found)
{
    static const double want[] = { 2,  1, 3,  -1, 2, 1,  4, 0, -2, 5 };     /* L; small whole numbers, so exact */
    for (int32_t i = 0; i < 4; i++)
        for (int32_t j = 0; j <= i; j++) {
            double s = 0;
            for (int32_t k = 0; k <= j; k++) s += want[at(i, k)] * want[at(j, k)];
            A[i][j] = R(s);
        }
    factor(4, 0);
    for (size_t k = 0; k < 10; k++) CHECK_WITHIN(L[k], want[k], 0);
}

/* Rows above column j of L are never read: what lies right of the diagonal is not part of the matrix. */
TEST(leading_minors_have_the_leading_factor)
{
    sp_real all[ENTRIES];
    random_matrix(20, 20, 1, 0);
    factor(20, 0);
    for (size_t k = 0; k < at(20, 0); k++) all[k] = L[k];
    for (int32_t n = 1; n < 20; n++) {
        factor(n, 0);
        for (size_t k = 0; k < at(n, 0); k++) if (!CHECK_WITHIN(L[k], all[k], 0)) return;
    }
}

/* However bad the condition, the answer solves a system within a few roundings of the given one.        [Wilkinson 1961] */
TEST(residuals_are_small_however_bad_the_condition)
{
    sp_real b[MOST], x[MOST];
    for (int trial = 0; trial < 60; trial++) {
        const int32_t n = trial < 40 ? test_random_int(1, MOST) : test_random_int(1, TOL(10, 5));
        if (trial < 40) random_matrix(n, n, trial % 2 ? 1 : 1e-3, 0);
        else hilbert(n);
        factor(n, 0);
        for (int32_t i = 0; i < n; i++) b[i] = x[i] = test_random_real(-1, 1);
        sp__chol_solve(L, n, x);
        CHECK_WITHIN(residual(n, x, b), 0, 8 * n);
    }
}

/* The inverse of a Hilbert matrix has whole numbers; its corner for n = 3 is 9, for n = 5 25. */
TEST(inverse_of_a_hilbert_matrix_is_whole)
{
    static const double want[3][3] = { { 9, -36, 30 }, { -36, 192, -180 }, { 30, -180, 180 } };
    hilbert(3);
    factor(3, 0);
    for (int32_t j = 0; j < 3; j++) {
        sp_real x[3] = { 0, 0, 0 };
        x[j] = 1;
        sp__chol_solve(L, 3, x);
        for (int32_t i = 0; i < 3; i++) CHECK_NEAR(x[i], want[i][j], 8 * 524 * (double)SP_EPSILON);     /* condition 524 */
    }
}

TEST(unknowns_of_no_strength_come_out_as_nothing)
{
    sp_real x[3] = { 5, 7, 11 };
    for (int32_t i = 0; i < 3; i++)
        for (int32_t j = 0; j < 3; j++) A[i][j] = 0;
    A[0][0] = 4;                                        /* x_1 is in no equation, x_2 in one of its own below the floor */
    A[2][2] = R(1e-6);
    factor(3, 1e-3);
    sp__chol_solve(L, 3, x);
    CHECK_WITHIN(x[0], 1.25, 0);
    CHECK_WITHIN(x[1], 0, TOL(1e-50, 1e-30));
    CHECK_WITHIN(x[2], 0, TOL(1e-50, 1e-30));
}

TEST(the_floor_is_where_a_pivot_stops_to_count)
{
    static const struct { double pivot; int counts; } table[] = { { 0.26, 1 }, { 0.25, 0 }, { 0.24, 0 }, { 0, 0 }, { -1, 0 } };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_real x[2] = { 3, 1 };
        A[0][0] = 1;
        A[1][0] = A[0][1] = 2;
        A[1][1] = R(4 + table[k].pivot);                /* pivot: what is left of it after the first column */
        factor(2, 0.25);
        CHECK_INT(L[2] < SP__NEVER, table[k].counts);
        sp__chol_solve(L, 2, x);
        if (table[k].counts) CHECK_NEAR(x[1], (1 - 2 * 3) / table[k].pivot, TOL(1e-12, 1e-4));
        else CHECK_WITHIN(x[1], 0, TOL(1e-50, 1e-30)), CHECK_NEAR(x[0], 3, 8 * (double)SP_EPSILON);
    }
}

/* Semidefinite with a right-hand side in its range: as many pivots count as the rank, and the answer still solves it. */
TEST(a_semidefinite_system_is_solved_where_it_can_be)
{
    for (int trial = 0; trial < 40; trial++) {
        sp_real b[MOST], x[MOST];
        const int32_t n = test_random_int(2, 12), rank = test_random_int(1, n - 1);
        random_matrix(n, rank, 0, 8);
        factor(n, 0.01);
        for (int32_t i = 0; i < n; i++) CHECK_INT(L[at(i, i)] < SP__NEVER, i < rank);
        for (int32_t i = 0; i < n; i++) {
            double s = 0;
            for (int32_t j = 0; j < n; j++) s += (double)A[i][j];
            b[i] = x[i] = R(s);                         /* A (1 1 .. 1)' */
        }
        sp__chol_solve(L, n, x);
        CHECK_WITHIN(residual(n, x, b), 0, 40 * n);     /* what was dropped is rounding, magnified by the rows above */
        for (int32_t i = rank; i < n; i++) CHECK_WITHIN(x[i], 0, TOL(1e-50, 1e-30));
    }
}

TEST_LIST(chol)
    RUN(factor_times_its_transpose_is_the_matrix)
    RUN(factor_of_a_known_product_is_found)
    RUN(leading_minors_have_the_leading_factor)
    RUN(residuals_are_small_however_bad_the_condition)
    RUN(inverse_of_a_hilbert_matrix_is_whole)
    RUN(unknowns_of_no_strength_come_out_as_nothing)
    RUN(the_floor_is_where_a_pivot_stops_to_count)
    RUN(a_semidefinite_system_is_solved_where_it_can_be)
TEST_END
