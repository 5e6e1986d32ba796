/* Sparse LDL': random quasi-definite matrices solved against the matrix itself, its inertia, pivots that must be bent. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/ldl.c"

enum { MOST = 60 };

static double K[MOST][MOST];
static int32_t size;

static double size_of(double x) { return x < 0 ? -x : x; }

static void walk(const void *what, sp__entry take, void *to)
{
    (void)what;
    for (int32_t j = 0; j < size; j++)
        for (int32_t i = 0; i < j; i++)
            if (size_of(K[i][j]) > 0) take(to, i, j, R(K[i][j]));
}

/* [ G G' + d I, A'; A, -d I ] with `density` of 8 entries. */
static void quasidefinite(int32_t n, int32_t m, int32_t density, double d)
{
    static double g[MOST][MOST];
    size = n + m;
    for (int32_t i = 0; i < n; i++) for (int32_t k = 0; k < n; k++) g[i][k] = test_random_int(0, 7) < density ? (double)test_random_real(-1, 1) : 0;
    for (int32_t i = 0; i < size; i++)
        for (int32_t j = 0; j <= i; j++) {
            double t = i == j ? (i < n ? d : -d) : 0;
            if (i < n) for (int32_t k = 0; k < n; k++) t += g[i][k] * g[j][k];
            else if (j < n && test_random_int(0, 7) < density) t = (double)test_random_real(-1, 1);
            K[i][j] = K[j][i] = (double)R(t);
        }
}

static int factor(sp__ldl *f, int32_t plus)
{
    int32_t entries = 0;
    memset(f, 0, sizeof *f);
    for (int32_t j = 0; j < size; j++) for (int32_t i = 0; i < j; i++) entries += size_of(K[i][j]) > 0;
    sp__ldl_carve(f, size, plus, entries, &test_arena);
    const int32_t fill = sp__ldl_analyse(f, walk, NULL, test_arena);
    sp__ldl_carve_factor(f, fill, &test_arena);
    for (int32_t k = 0; k < size; k++) sp__ldl_diagonal(f, k, R(K[k][k]));
    sp__ldl_factor(f);
    return !sp__failed(&test_arena) && f->lp[size] == fill;
}

/* Largest |b - K x| relative to |K| |x|, in units of u. */
static double residual(const sp_real *x, const sp_real *b)
{
    double worst = 0, most = 0, a = 0;
    for (int32_t i = 0; i < size; i++) {
        double r = (double)b[i];
        for (int32_t j = 0; j < size; j++) { r -= K[i][j] * (double)x[j]; if (size_of(K[i][j]) > a) a = size_of(K[i][j]); }
        if (size_of(r) > worst) worst = size_of(r);
        if (size_of((double)x[i]) > most) most = size_of((double)x[i]);
    }
    return worst / (a * most) / (double)SP_EPSILON;
}

TEST(systems_are_solved_in_any_order)
{
    for (int trial = 0; trial < 60; trial++) {
        const int32_t n = test_random_int(1, MOST / 2), m = test_random_int(0, MOST / 2);
        sp_real b[MOST], x[MOST];
        sp__ldl f;
        test_arena.used = 0;
        quasidefinite(n, m, test_random_int(0, 8), 0.1);
        NEED(factor(&f, n));
        CHECK_INT(f.bent, 0);
        for (int32_t k = 0; k < size; k++) b[k] = test_random_real(-1, 1);
        sp__ldl_solve(&f, b, x, 0);
        CHECK_WITHIN(residual(x, b), 0, 50 * size);
        sp__ldl_solve(&f, b, x, 1);
        CHECK_WITHIN(residual(x, b), 0, 10 + size);
    }
}

/* Quasi-definite: as many positive pivots as unknowns, as many negative ones as rows.                    [Vanderbei 1995] */
TEST(pivots_have_the_signs_they_must)
{
    sp__ldl f;
    quasidefinite(20, 25, 3, 0.1);
    NEED(factor(&f, 20));
    for (int32_t k = 0; k < 45; k++) CHECK(f.perm[k] < 20 ? f.d[k] > 0 : f.d[k] < 0);
}

/* An arrow with its point first fills up in the order given; the order found leaves it empty. */
TEST(arrow_is_not_filled)
{
    sp__ldl f;
    size = 30;
    for (int32_t i = 0; i < size; i++) for (int32_t j = 0; j < size; j++) K[i][j] = i == j ? 40 : i == 0 || j == 0 ? 1 : 0;
    NEED(factor(&f, size));
    CHECK_INT(f.lp[size], size - 1);
}

/* An unknown without a pivot is bent and refined: the others come out as if it were not there. */
TEST(missing_pivot_is_bent)
{
    sp__ldl f;
    sp_real b[3] = { 4, 0, 9 }, x[3];
    size = 3;
    memset(K, 0, sizeof K);
    K[0][0] = 2; K[2][2] = 3;
    NEED(factor(&f, 3));
    CHECK_INT(f.bent, 1);
    sp__ldl_solve(&f, b, x, 2);
    CHECK_NEAR(x[0], 2, TOL(1e-12, 1e-6));
    CHECK_WITHIN(x[1], 0, 0);
    CHECK_NEAR(x[2], 3, TOL(1e-12, 1e-6));
}

/* [1 2; 2 1] has a negative pivot whichever comes first. */
TEST(indefinite_shows_in_the_pivots)
{
    sp__ldl f;
    size = 2;
    memset(K, 0, sizeof K);
    K[0][0] = K[1][1] = 1; K[0][1] = K[1][0] = 2;
    NEED(factor(&f, 2));
    CHECK_INT(f.bent, 1);
    CHECK(factor(&f, 1));
    CHECK(f.n == 2);
}

TEST_LIST(ldl)
    RUN(systems_are_solved_in_any_order)
    RUN(pivots_have_the_signs_they_must)
    RUN(arrow_is_not_filled)
    RUN(missing_pivot_is_bent)
    RUN(indefinite_shows_in_the_pivots)
TEST_END
