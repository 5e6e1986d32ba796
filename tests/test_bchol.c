/* Block-sparse Cholesky: solutions of random systems, against the matrix itself and a plain dense factorisation. */
#define SP_API static
#include "test.h"

#include <string.h>
#ifndef SP_SQRT
#include <math.h>
#ifdef SP_REAL_FLOAT
#define SP_SQRT(x) sqrtf(x)
#else
#define SP_SQRT(x) sqrt(x)
#endif
#endif

#include "../solvers/bchol.c"

enum { BLOCKS = 30, SIZE = 6 * BLOCKS };

static double A[SIZE][SIZE];                            /* the matrix, dense */
static unsigned char meet[BLOCKS][BLOCKS];

/* A graph of n blocks with about `edges` edges and a positive definite matrix on it: A = sum over edges of G'G + shift I. */
static void make(int32_t n, int32_t edges, double shift)
{
    memset(A, 0, sizeof A);
    memset(meet, 0, sizeof meet);
    for (int32_t k = 0; k < edges; k++) {
        const int32_t i = test_random_int(0, n - 1), j = test_random_int(0, n - 1);
        if (i == j) continue;
        meet[i][j] = meet[j][i] = 1;
        for (int row = 0; row < 4; row++) {
            double v[12];
            for (int c = 0; c < 12; c++) v[c] = (double)test_random_real(-1, 1);
            for (int c = 0; c < 12; c++)
                for (int d = 0; d < 12; d++)
                    A[6 * (c < 6 ? i : j) + c % 6][6 * (d < 6 ? i : j) + d % 6] += v[c] * v[d];
        }
    }
    for (int32_t k = 0; k < 6 * n; k++) A[k][k] += shift;
}

/* The factor of A, in the test arena. */
static void factor(int32_t n, sp__bchol *f)
{
    static int32_t xadj[BLOCKS + 1], adj[BLOCKS * BLOCKS], parent[BLOCKS], mark[BLOCKS];
    int32_t m = 0;
    for (int32_t i = 0; i < n; i++) {
        xadj[i] = m;
        for (int32_t j = 0; j < n; j++)
            if (meet[i][j]) adj[m++] = j;
    }
    xadj[n] = m;
    sp__bchol_carve_pattern(f, n, &test_arena);
    const int32_t nnz = sp__bchol_analyse(f, xadj, adj, parent, mark, test_arena);
    CHECK(nnz >= m / 2);
    sp__bchol_carve_values(f, nnz, &test_arena);
    sp__bchol_pattern(f, xadj, adj, parent, mark);
    CHECK_INT(f->p[n], nnz);
    sp__bchol_zero(f);
    for (int32_t i = 0; i < n; i++)
        for (int r = 0; r < 6; r++)
            for (int c = 0; c < 6; c++) f->d[36 * f->inv[i] + 6 * c + r] = R(A[6 * i + r][6 * i + c]);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < i; j++) {
            if (!meet[i][j]) continue;
            int32_t turned;
            const int32_t slot = sp__bchol_slot(f, i, j, &turned);
            for (int r = 0; r < 6; r++)
                for (int c = 0; c < 6; c++) f->x[36 * slot + (turned ? 6 * r + c : 6 * c + r)] = R(A[6 * i + r][6 * j + c]);
        }
    sp__bchol_factor(f, 0);
}

/* |A x - b| relative to |A| |x| + |b| */
static double residual(int32_t n, const sp_real *x, const sp_real *b)
{
    double worst = 0;
    for (int32_t i = 0; i < 6 * n; i++) {
        double r = -(double)b[i], s = (double)(b[i] < 0 ? -b[i] : b[i]);
        for (int32_t j = 0; j < 6 * n; j++) {
            const double t = A[i][j] * (double)x[j];
            r += t;
            s += t < 0 ? -t : t;
        }
        if (r < 0) r = -r;
        if (s > 0 && r / s > worst) worst = r / s;
    }
    return worst;
}

TEST(solutions_satisfy_their_system)
{
    for (int trial = 0; trial < 40; trial++) {
        sp_real b[SIZE], x[SIZE];
        sp__bchol f;
        const int32_t n = test_random_int(1, BLOCKS);
        test_arena.used = 0;
        make(n, test_random_int(0, 3 * n), 1);
        factor(n, &f);
        for (int32_t k = 0; k < 6 * n; k++) b[k] = test_random_real(-1, 1);
        sp__bchol_solve(&f, b, x);
        CHECK_WITHIN(residual(n, x, b) / (double)SP_EPSILON, 0, 300);
    }
}

TEST(answer_may_replace_the_question)
{
    sp_real b[SIZE], x[SIZE];
    sp__bchol f;
    make(12, 30, 1);
    factor(12, &f);
    for (int32_t k = 0; k < 72; k++) b[k] = test_random_real(-1, 1);
    sp__bchol_solve(&f, b, x);
    sp__bchol_solve(&f, b, b);
    for (int32_t k = 0; k < 72; k++) CHECK(x[k] <= b[k] && x[k] >= b[k]);
}

TEST(one_dense_block_is_plain_cholesky)
{
    sp_real b[6], x[6];
    sp__bchol f;
    make(1, 0, 0);
    for (int i = 0; i < 6; i++)                         /* min(i, j): inverse is tridiagonal, det 1 */
        for (int j = 0; j < 6; j++) A[i][j] = 1 + (i < j ? i : j);
    factor(1, &f);
    for (int k = 0; k < 6; k++) b[k] = R(k == 5);       /* last column of the inverse: 0 .. 0 -1 1 */
    sp__bchol_solve(&f, b, x);
    for (int k = 0; k < 6; k++) CHECK_WITHIN(x[k], k == 5 ? 1 : k == 4 ? -1 : 0, 64 * (double)SP_EPSILON);
}

TEST(pivots_without_strength_are_raised_to_the_floor)
{
    sp_real b[6] = { 0, 0, 0, 0, 0, 0 }, x[6];
    sp__bchol f;
    make(1, 0, 0);                                      /* the zero matrix */
    factor(1, &f);
    sp__bchol_zero(&f);
    sp__bchol_factor(&f, R(0.25));
    b[2] = 1;
    sp__bchol_solve(&f, b, x);
    CHECK_NEAR(x[2], 4, 8 * (double)SP_EPSILON);
}

/* The formula for flops counts 2 flops a multiply-add of what the loops do; here for a chain, where no fill happens. */
TEST(flops_of_a_chain_follow_the_formula)
{
    sp__bchol f;
    make(10, 0, 1);
    for (int32_t i = 1; i < 10; i++) meet[i - 1][i] = meet[i][i - 1] = 1;
    factor(10, &f);
    CHECK_INT(f.p[10], 9);
    CHECK_INT(f.flops, 10 * 91 + 9 * (216 + 432));
}

TEST_LIST(bchol)
    RUN(solutions_satisfy_their_system)
    RUN(answer_may_replace_the_question)
    RUN(one_dense_block_is_plain_cholesky)
    RUN(pivots_without_strength_are_raised_to_the_floor)
    RUN(flops_of_a_chain_follow_the_formula)
TEST_END
