/* Cholesky in an envelope: its factor multiplied out again, systems solved against the matrix itself, the dense factor where the
 * envelope is all of the triangle, and pivots that carry nothing. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/chol.c"
#if !SP__WITH_SMALL                                     /* its body was left out: both are wanted here */
#undef SP__WITH_SMALL
#undef SP__ENVELOPE_C
#define SP__WITH_SMALL 1
#endif
#include "../../solvers/linear/envelope.c"

enum { MOST = 40, ENTRIES = MOST * (MOST + 1) / 2 };

static sp_real A[MOST][MOST], L[ENTRIES];
static int32_t row[MOST];

static double size_of(double x) { return x < 0 ? -x : x; }

/* A = G G' + shift I, whose rows begin at random columns, or all at the first; G's rows begin there, too. */
static void random_matrix(int32_t n, int full, double shift)
{
    static double g[MOST][MOST];
    int32_t size = 0, first[MOST];
    for (int32_t i = 0; i < n; i++) {
        first[i] = full ? 0 : test_random_int(0, i);
        for (int32_t k = 0; k < n; k++) g[i][k] = k >= first[i] && k <= i ? (double)test_random_real(-1, 1) : 0;
        row[i] = size - first[i];
        size += i - first[i] + 1;
    }
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++) {
            double s = i == j ? shift : 0;
            for (int32_t k = 0; k < n; k++) s += g[i][k] * g[j][k];
            A[i][j] = R(s);
        }
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = first[i]; j <= i; j++) L[row[i] + j] = A[i][j];
}

TEST(first_columns_follow_from_where_rows_start)
{
    static const int32_t start[] = { 0, 0, 1, 1 }, at[] = { 0, 1, 2, 4 };       /* rows of 1, 2, 2, 3 entries */
    for (int32_t i = 0; i < 4; i++) CHECK_INT(sp__envelope_first(at, i), start[i]);
    for (int32_t i = 0; i < 4; i++) CHECK_INT(sp__envelope_first(NULL, i), 0);                  /* all of the triangle */
}

TEST(factor_times_its_transpose_is_the_matrix)
{
    for (int trial = 0; trial < 60; trial++) {
        const int32_t n = test_random_int(1, MOST);
        double worst = 0;
        random_matrix(n, trial % 3 == 0, trial % 2 ? 1 : 1e-2);
        sp__envelope_factor(L, row, n, 0);
        for (int32_t i = 0; i < n; i++)
            for (int32_t j = 0; j <= i; j++) {
                double r = (double)A[i][j], s = 0;
                for (int32_t k = 0; k <= j; k++) {
                    if (k < sp__envelope_first(row, i) || k < sp__envelope_first(row, j)) continue;
                    const double t = (double)L[row[i] + k] * (double)L[row[j] + k];
                    r -= t;
                    s += size_of(t);
                }
                if (size_of(r) > worst * s) worst = size_of(r) / s;
            }
        CHECK_WITHIN(worst / (double)SP_EPSILON, 0, n + 1);
    }
}

TEST(residuals_are_small)
{
    sp_real b[MOST], x[MOST];
    for (int trial = 0; trial < 60; trial++) {
        const int32_t n = test_random_int(1, MOST);
        double worst = 0, a = 0, most = 0;
        random_matrix(n, trial % 3 == 0, trial % 2 ? 1 : 1e-2);
        sp__envelope_factor(L, row, n, 0);
        for (int32_t i = 0; i < n; i++) b[i] = x[i] = test_random_real(-1, 1);
        sp__envelope_solve(L, row, n, x);
        for (int32_t i = 0; i < n; i++) {
            double r = -(double)b[i];
            for (int32_t j = 0; j < n; j++) {
                r += (double)A[i][j] * (double)x[j];
                if (size_of((double)A[i][j]) > a) a = size_of((double)A[i][j]);
            }
            if (size_of((double)x[i]) > most) most = size_of((double)x[i]);
            if (size_of(r) > worst) worst = size_of(r);
        }
        CHECK_WITHIN(worst / (a * most) / (double)SP_EPSILON, 0, 8 * n);
    }
}

TEST(envelope_of_everything_is_the_dense_factor)
{
    static sp_real dense[ENTRIES];
    random_matrix(MOST, 1, 1);
    for (size_t k = 0; k < ENTRIES; k++) dense[k] = L[k];
    sp__envelope_factor(L, row, MOST, 0);
    sp__chol_factor(dense, MOST, 0);
    for (size_t k = 0; k < ENTRIES; k++) if (!CHECK_WITHIN(L[k], dense[k], 0)) return;
}

TEST(unknowns_of_no_strength_come_out_as_nothing)
{
    sp_real a[] = { 4, 2, 1, 9 }, x[] = { 8, 4, 18 };       /* 4 2 . | 2 1 . | . . 9: the second row is half the first */
    static const int32_t at[] = { 0, 1, 1 };
    sp__envelope_factor(a, at, 3, R(1e-6));
    sp__envelope_solve(a, at, 3, x);
    CHECK_NEAR(x[0], 2, 1e-6);
    CHECK_WITHIN(x[1], 0, 1e-6);
    CHECK_NEAR(x[2], 2, 1e-6);
}

TEST_LIST(envelope)
    RUN(first_columns_follow_from_where_rows_start)
    RUN(factor_times_its_transpose_is_the_matrix)
    RUN(residuals_are_small)
    RUN(envelope_of_everything_is_the_dense_factor)
    RUN(unknowns_of_no_strength_come_out_as_nothing)
TEST_END
