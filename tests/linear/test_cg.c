/* Conjugate gradients: exact after as many steps as there are different eigenvalues, warm starts, negative curvature. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/cg.c"
#include <string.h>

enum { MOST = 40 };

typedef struct matrix { int32_t n; sp_real a[MOST][MOST]; } matrix;

static matrix M;

static void apply(const void *what, const sp_real *v, sp_real *mv)
{
    const matrix *m = what;
    for (int32_t i = 0; i < m->n; i++) mv[i] = sp__inner(m->a[i], v, m->n);
}

static void start(sp__cg *cg, int32_t n)
{
    M.n = n;
    sp__cg_carve(cg, n, &test_arena);
    for (int32_t i = 0; i < n; i++) cg->inverse[i] = 1 / M.a[i][i];
}

static void random_matrix(int32_t n, double shift)
{
    static double g[MOST][MOST];
    for (int32_t i = 0; i < n; i++) for (int32_t k = 0; k < n; k++) g[i][k] = (double)test_random_real(-1, 1);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++) {
            double t = i == j ? shift : 0;
            for (int32_t k = 0; k < n; k++) t += g[i][k] * g[j][k] / n;
            M.a[i][j] = R(t);
        }
}

TEST(diagonal_takes_one_step)
{
    sp__cg cg;
    sp_real b[MOST], x[MOST] = { 0 };
    memset(&M, 0, sizeof M);
    for (int32_t i = 0; i < MOST; i++) { M.a[i][i] = R(i + 1); b[i] = R((i + 1) * (i % 3 - 1)); }
    start(&cg, MOST);
    CHECK_INT(sp__cg_solve(&cg, apply, &M, b, x, 10, R(TOL(1e-12, 1e-6))), 1);
    for (int32_t i = 0; i < MOST; i++) CHECK_WITHIN(x[i], i % 3 - 1, TOL(1e-12, 1e-6));
}

TEST(residual_falls_below_what_was_asked)
{
    for (int trial = 0; trial < 20; trial++) {
        const int32_t n = test_random_int(1, MOST);
        const double tol = TOL(1e-10, 1e-5);
        sp__cg cg;
        sp_real b[MOST], x[MOST] = { 0 }, r[MOST];
        random_matrix(n, 0.5);
        start(&cg, n);
        for (int32_t i = 0; i < n; i++) b[i] = test_random_real(-1, 1);
        const int32_t steps = sp__cg_solve(&cg, apply, &M, b, x, 250, R(tol));
        CHECK(steps >= 0 && steps < 100);
        apply(&M, x, r);
        for (int32_t i = 0; i < n; i++) r[i] -= b[i];
        CHECK(sp__inner(r, r, n) <= R(2 * tol * tol) * sp__inner(b, b, n));
        CHECK_INT(sp__cg_solve(&cg, apply, &M, b, x, 250, R(2 * tol)), 0);     /* warm: nothing left to do */
    }
}

TEST(cap_is_kept)
{
    sp__cg cg;
    sp_real b[MOST], x[MOST] = { 0 };
    random_matrix(MOST, 1e-3);
    start(&cg, MOST);
    for (int32_t i = 0; i < MOST; i++) b[i] = 1;
    CHECK_INT(sp__cg_solve(&cg, apply, &M, b, x, 5, R(1e-30)), 5);
}

TEST(negative_curvature_is_seen)
{
    sp__cg cg;
    sp_real b[3] = { 1, 1, 1 }, x[3] = { 0, 0, 0 };
    memset(&M, 0, sizeof M);
    M.a[0][0] = M.a[1][1] = M.a[2][2] = 1;
    M.a[0][1] = M.a[1][0] = -3;
    start(&cg, 3);
    CHECK(sp__cg_solve(&cg, apply, &M, b, x, 10, R(1e-6)) < 0);
}

/* A preconditioner of both signs, r'Cr <= 0 of an r that is not small: no step is taken. */
TEST(a_preconditioner_that_is_not_positive_ends_it)
{
    sp__cg cg;
    sp_real b[2] = { 1, 1 }, x[2] = { 0, 0 };
    random_matrix(2, 1);
    start(&cg, 2);
    cg.inverse[0] = 1;
    for (int k = 0; k < 2; k++) {
        cg.inverse[1] = k ? -2 : -1;
        CHECK_INT(sp__cg_solve(&cg, apply, &M, b, x, 10, R(1e-6)), 0);
        for (int i = 0; i < 2; i++) CHECK_WITHIN(x[i], 0, 0);
    }
}

TEST(nothing_asked_nothing_done)
{
    sp__cg cg;
    sp_real b[2] = { 0, 0 }, x[2] = { 0, 0 };
    random_matrix(2, 1);
    start(&cg, 2);
    CHECK_INT(sp__cg_solve(&cg, apply, &M, b, x, 10, R(1e-6)), 0);
    CHECK_WITHIN(x[0], 0, 0);
}

TEST_LIST(cg)
    RUN(diagonal_takes_one_step)
    RUN(residual_falls_below_what_was_asked)
    RUN(cap_is_kept)
    RUN(negative_curvature_is_seen)
    RUN(a_preconditioner_that_is_not_positive_ends_it)
    RUN(nothing_asked_nothing_done)
TEST_END
