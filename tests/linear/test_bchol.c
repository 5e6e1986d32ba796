/* Block-sparse Cholesky: solutions of random systems, against the matrix itself and a plain dense factorisation. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"

#include <math.h>

#include <string.h>
#include "../../solvers/linear/bchol.c"
#include "../../solvers/linear/chol.c"

#if defined SP_REAL_FLOAT || defined SP_REAL_MIXED      /* the factor's precision counts here */
#define LOW(d, f) (f)
#else
#define LOW(d, f) (d)
#endif

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

/* A as blocks, in the test arena. */
static void blocks_of(int32_t n, sp__bchol *f)
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
            for (int c = 0; c <= r; c++) f->d[21 * f->inv[i] + sp__column[c] + r - c] = R(A[6 * i + r][6 * i + c]);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < i; j++) {
            if (!meet[i][j]) continue;
            int32_t turned;
            const int32_t slot = sp__bchol_slot(f, i, j, &turned);
            for (int r = 0; r < 6; r++)
                for (int c = 0; c < 6; c++) f->x[36 * slot + (turned ? 6 * r + c : 6 * c + r)] = R(A[6 * i + r][6 * j + c]);
        }
}

/* The factor of A; pivots up to `floor` do not count. */
static void factor_above(int32_t n, double floor, sp__bchol *f)
{
    blocks_of(n, f);
    sp__bchol_factor(f, R(floor), NULL);
}

static void factor(int32_t n, sp__bchol *f) { factor_above(n, 0, f); }

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
        CHECK_WITHIN(residual(n, x, b) / (double)SP__LOW_EPSILON, 0, 300);
    }
}

#if !defined SP_NO_IPM && !defined SP_REAL_MIXED
/* Rows of very different size: the floor that is far above some of them does not touch a balanced factor. */
TEST(a_balanced_factor_is_that_of_the_matrix)
{
    for (int trial = 0; trial < 40; trial++) {
        sp_real b[SIZE], x[SIZE];
        double scale[SIZE];
        sp__bchol f;
        const int32_t n = test_random_int(1, BLOCKS);
        test_arena.used = 0;
        make(n, test_random_int(0, 3 * n), 1);
        for (int32_t k = 0; k < 6 * n; k++) scale[k] = pow(10, (double)test_random_real(LOW(-9, -4), LOW(9, 4)));
        for (int32_t i = 0; i < 6 * n; i++)
            for (int32_t j = 0; j < 6 * n; j++) A[i][j] *= scale[i] * scale[j];
        blocks_of(n, &f);
        sp__bchol_balance(&f, 0);
        sp__bchol_factor(&f, 8 * SP__LOW_EPSILON, NULL);
        sp__bchol_unbalance(&f);
        for (int32_t k = 0; k < 6 * n; k++) b[k] = R(scale[k] * (double)test_random_real(-1, 1));
        sp__bchol_solve(&f, b, x);
        CHECK_WITHIN(residual(n, x, b) / (double)SP__LOW_EPSILON, 0, 300);
    }
}

/* Balanced, a row that is zero stays apart: the shift is its pivot, the others see it relative to themselves. */
TEST(the_shift_of_a_balanced_matrix_is_relative)
{
    sp_real b[6] = { 0, 0, 0, 0, 0, 0 }, x[6];
    sp__bchol f;
    make(1, 0, 0);
    A[1][1] = 1e6;
    A[2][2] = 1e-6;
    blocks_of(1, &f);
    sp__bchol_balance(&f, R(0.25));
    sp__bchol_factor(&f, 0, NULL);
    sp__bchol_unbalance(&f);
    b[0] = b[1] = b[2] = 1;
    sp__bchol_solve(&f, b, x);
    CHECK_NEAR(x[0], 4, 8 * (double)SP__LOW_EPSILON);
    CHECK_NEAR(x[1], 1 / 1.25e6, 8 * (double)SP__LOW_EPSILON);
    CHECK_NEAR(x[2], 1 / 1.25e-6, 8 * (double)SP__LOW_EPSILON);
}
#endif

#ifdef SP_REAL_MIXED
/* No two numbers below the diagonal have a product that a float can't hold in its normal range. */
TEST(a_factor_in_float_holds_no_number_that_is_next_to_nothing)
{
    sp__bchol f;
    make(2, 0, 1);
    meet[0][1] = meet[1][0] = 1;
    for (int k = 0; k < 6; k++) A[k][6 + k] = A[6 + k][k] = k % 2 ? 1e-25 : 1e-3;
    factor(2, &f);
    for (int k = 0; k < 36; k++) CHECK(f.x[k] == 0 || (k % 7 == 0 && k / 7 % 2 == 0 && f.x[k] > 9e-4f));
}
#endif

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
    for (int k = 0; k < 6; k++) CHECK_WITHIN(x[k], k == 5 ? 1 : k == 4 ? -1 : 0, 64 * (double)SP__LOW_EPSILON);
}

TEST(pivots_without_strength_are_raised_to_the_floor)
{
    sp_real b[6] = { 0, 0, 0, 0, 0, 0 }, x[6];
    sp__bchol f;
    make(1, 0, 0);                                      /* the zero matrix */
    factor(1, &f);
    sp__bchol_zero(&f);
    sp__bchol_factor(&f, R(0.25), NULL);
    b[2] = 1;
    sp__bchol_solve(&f, b, x);
    CHECK_NEAR(x[2], 4, 8 * (double)SP__LOW_EPSILON);
}

/* The same system by the dense part: shift 1 keeps the condition below 1e4 or so. */
TEST(dense_cholesky_gives_the_same_answer)
{
    static sp_real dense[SIZE * (SIZE + 1) / 2];
    for (int trial = 0; trial < 10; trial++) {
        sp_real x[SIZE], y[SIZE];
        sp__bchol f;
        const int32_t n = test_random_int(1, BLOCKS);
        test_arena.used = 0;
        make(n, test_random_int(0, 3 * n), 1);
        factor(n, &f);
        for (int32_t i = 0, k = 0; i < 6 * n; i++)
            for (int32_t j = 0; j <= i; j++) dense[k++] = R(A[i][j]);
        sp__chol_factor(dense, 6 * n, 0);
        for (int32_t k = 0; k < 6 * n; k++) x[k] = y[k] = test_random_real(-1, 1);
        sp__bchol_solve(&f, x, x);
        sp__chol_solve(dense, 6 * n, y);
        for (int32_t k = 0; k < 6 * n; k++) if (!CHECK_WITHIN(x[k], y[k], LOW(1e-11, 3e-3))) return;
    }
}

TEST(order_and_its_inverse_undo_each_other)
{
    sp__bchol f;
    make(BLOCKS, 2 * BLOCKS, 1);
    factor(BLOCKS, &f);
    for (int32_t k = 0; k < BLOCKS; k++) {
        CHECK_INT(f.inv[f.perm[k]], k);
        CHECK_INT(f.perm[f.inv[k]], k);
        for (int32_t q = f.p[k]; q < f.p[k + 1]; q++) CHECK(f.i[q] > (q > f.p[k] ? f.i[q - 1] : k));
    }
}

/* Blocks renamed i -> place[i]: the same answer under new names, whatever order the elimination takes. */
TEST(renaming_the_blocks_renames_the_answer)
{
    static double B[SIZE][SIZE];
    static unsigned char met[BLOCKS][BLOCKS];
    for (int trial = 0; trial < 10; trial++) {
        const int32_t n = test_random_int(2, BLOCKS);
        int32_t place[BLOCKS];
        sp_real b[SIZE], c[SIZE], x[SIZE], y[SIZE];
        sp__bchol f;
        test_arena.used = 0;
        make(n, 2 * n, 1);
        factor(n, &f);
        for (int32_t k = 0; k < 6 * n; k++) b[k] = test_random_real(-1, 1);
        sp__bchol_solve(&f, b, x);
        for (int32_t i = 0; i < n; i++) place[i] = i;
        for (int32_t i = n - 1; i > 0; i--) {
            const int32_t j = test_random_int(0, i), t = place[i];
            place[i] = place[j];
            place[j] = t;
        }
        memcpy(B, A, sizeof A);
        memcpy(met, meet, sizeof meet);
        for (int32_t i = 0; i < 6 * n; i++) {
            const int32_t to = 6 * place[i / 6] + i % 6;
            c[to] = b[i];
            for (int32_t j = 0; j < 6 * n; j++) {
                A[to][6 * place[j / 6] + j % 6] = B[i][j];
                meet[place[i / 6]][place[j / 6]] = met[i / 6][j / 6];
            }
        }
        factor(n, &f);
        sp__bchol_solve(&f, c, y);
        for (int32_t i = 0; i < 6 * n; i++)
            if (!CHECK_WITHIN(y[6 * place[i / 6] + i % 6], x[i], LOW(1e-11, 3e-3))) return;
    }
}

/* A connected graph of springs that feel four of six directions, turned by a reflection Q so that no coordinate is one of
 * them: A = Laplacian x Q diag(1 1 1 1 0 0) Q', rank 4 (n - 1). */
static void make_springs(int32_t n)
{
    double P[6][6];
    for (int r = 0; r < 6; r++)
        for (int c = 0; c < 6; c++) {                   /* Q = I - 2 v v' / v.v, v = (1, 2, .., 6), v.v = 91 */
            P[r][c] = 0;
            for (int k = 0; k < 4; k++)
                P[r][c] += ((r == k) - 2.0 * (r + 1) * (k + 1) / 91) * ((c == k) - 2.0 * (c + 1) * (k + 1) / 91);
        }
    make(n, 0, 0);
    for (int32_t e = 1; e < 2 * n; e++) {
        const int32_t i = e < n ? e : test_random_int(0, n - 1), j = e < n ? test_random_int(0, e - 1) : test_random_int(0, n - 1);
        const double w = (double)test_random_real(1, 4);
        if (i == j) continue;
        meet[i][j] = meet[j][i] = 1;
        for (int r = 0; r < 6; r++)
            for (int c = 0; c < 6; c++) {
                A[6 * i + r][6 * i + c] += w * P[r][c];
                A[6 * j + r][6 * j + c] += w * P[r][c];
                A[6 * i + r][6 * j + c] -= w * P[r][c];
                A[6 * j + r][6 * i + c] -= w * P[r][c];
            }
    }
}

/* Nothing holds the springs, so A is singular: what is not felt is dropped, and a load they can bear is still borne. */
TEST(dropped_pivots_are_those_of_the_null_space)
{
    for (int trial = 0; trial < 20; trial++) {
        sp_real b[SIZE], x[SIZE];
        sp__bchol f;
        const int32_t n = test_random_int(2, BLOCKS);
        int32_t dropped = 0;
        test_arena.used = 0;
        make_springs(n);
        factor_above(n, LOW(1e-9, 1e-4), &f);
        for (int32_t k = 0; k < n; k++)
            for (int c = 0; c < 6; c++) dropped += f.d[21 * k + sp__column[c]] < 0;
        CHECK_INT(dropped, 6 * n - 4 * (n - 1));
        for (int32_t i = 0; i < 6 * n; i++) {
            double s = 0;
            for (int32_t j = 0; j < 6 * n; j++) s += A[i][j] * (j % 7 - 3);
            b[i] = R(s);
        }
        sp__bchol_solve(&f, b, x);
        CHECK_WITHIN(residual(n, x, b), 0, LOW(1e-11, 1e-4));
    }
}

/* The formula for flops counts 2 flops a multiply-add of what the loops do; here for a chain, where no fill happens. */
TEST(flops_of_a_chain_follow_the_formula)
{
    sp__bchol f;
    make(10, 0, 1);
    for (int32_t i = 1; i < 10; i++) meet[i - 1][i] = meet[i][i - 1] = 1;
    factor(10, &f);
    CHECK_INT(f.p[10], 9);
    CHECK_INT(f.flops, 10 * 91 + 9 * (216 + 252));
}

TEST_LIST(bchol)
    RUN(solutions_satisfy_their_system)
#if !defined SP_NO_IPM && !defined SP_REAL_MIXED
    RUN(a_balanced_factor_is_that_of_the_matrix)
    RUN(the_shift_of_a_balanced_matrix_is_relative)
#endif
#ifdef SP_REAL_MIXED
    RUN(a_factor_in_float_holds_no_number_that_is_next_to_nothing)
#endif
    RUN(answer_may_replace_the_question)
    RUN(one_dense_block_is_plain_cholesky)
    RUN(pivots_without_strength_are_raised_to_the_floor)
    RUN(dense_cholesky_gives_the_same_answer)
    RUN(order_and_its_inverse_undo_each_other)
    RUN(renaming_the_blocks_renames_the_answer)
    RUN(dropped_pivots_are_those_of_the_null_space)
    RUN(flops_of_a_chain_follow_the_formula)
TEST_END
