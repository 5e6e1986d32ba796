/* Equilibration: rows and columns of the scaled KKT matrix come near 1, the units of the unknowns and rows drop out. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/qp/ruiz.c"

enum { N = 12, M = 15 };

static sp_real P[N][N], A[M][N], Px[N * N], Ax[N * M], q[N];
static int32_t Pp[N + 1], Pi[N * N], Ap[N + 1], Ai[N * M];
static sp_qp qp;

static void columns(void)
{
    int32_t p = 0, a = 0;
    for (int32_t j = 0; j < N; j++) {
        Pp[j] = p; Ap[j] = a;
        for (int32_t i = 0; i <= j; i++) if (P[i][j] > 0 || P[i][j] < 0) { Pi[p] = i; Px[p++] = P[i][j]; }
        for (int32_t i = 0; i < M; i++) if (A[i][j] > 0 || A[i][j] < 0) { Ai[a] = i; Ax[a++] = A[i][j]; }
    }
    Pp[N] = p; Ap[N] = a;
    const sp_qp made = { N, M, Pp, Pi, Px, q, Ap, Ai, Ax, NULL, NULL };
    qp = made;
}

static void random_problem(void)
{
    for (int32_t j = 0; j < N; j++) {
        q[j] = test_random_real(-1, 1);
        for (int32_t i = 0; i <= j; i++) P[i][j] = i == j ? R(1) : test_random_int(0, 3) ? R(0) : test_random_real(-0.3, 0.3);
        for (int32_t i = 0; i < M; i++) A[i][j] = test_random_int(0, 2) && i != j ? R(0) : test_random_real(0.1, 1);
    }
    for (int32_t i = N; i < M; i++) A[i][0] = 1;
    columns();
}

/* Largest entry of each row and column of [cDPD, A'; A] scaled: all within a factor. */
static void near_one(const sp_real *D, const sp_real *E, sp_real c, double factor)
{
    sp_real col[N], row[M];
    sp__ruiz_norms(&qp, D, E, c, col, row);
    for (int32_t j = 0; j < N; j++) CHECK((double)col[j] < factor && (double)col[j] > 1 / factor);
    for (int32_t i = 0; i < M; i++) CHECK((double)row[i] < factor && (double)row[i] > 1 / factor);
}

TEST(rows_and_columns_come_near_one)
{
    for (int trial = 0; trial < 20; trial++) {
        sp_real D[N], E[M], col[N], row[M];
        random_problem();
        for (int32_t j = 0; j < N; j++) {
            const sp_real s = R(test_random_int(0, 1) ? 1e3 : 1e-3);
            for (int32_t i = 0; i < N; i++) { P[i][j] *= s; P[j][i] *= s; }
            for (int32_t i = 0; i < M; i++) A[i][j] *= s;
            q[j] *= s;
        }
        columns();
        const sp_real c = sp__ruiz(&qp, 15, D, E, col, row);
        near_one(D, E, c, 1.5);
    }
}

/* x = S x', rows times t: the scaled problem stays what it was. */
TEST(units_drop_out)
{
    sp_real D[N], E[M], D2[N], E2[M], col[N], row[M];
    random_problem();
    sp__ruiz(&qp, 20, D, E, col, row);
    for (int32_t j = 0; j < N; j++) {                   /* powers of two, so that nothing is rounded */
        const sp_real s = j % 2 ? R(64) : R(0.03125);
        for (int32_t i = 0; i < N; i++) { P[i][j] *= s; P[j][i] *= s; }
        for (int32_t i = 0; i < M; i++) A[i][j] *= s;
        q[j] *= s;
    }
    for (int32_t i = 0; i < M; i++) for (int32_t j = 0; j < N; j++) A[i][j] *= i % 3 ? R(16) : R(0.125);
    columns();
    const sp_real c = sp__ruiz(&qp, 20, D2, E2, col, row);
    near_one(D2, E2, c, 1.5);
    for (int32_t j = 0; j < N; j++) CHECK((double)(D2[j] * (j % 2 ? R(64) : R(0.03125)) / D[j]) > 0.2 && (double)(D2[j] * (j % 2 ? R(64) : R(0.03125)) / D[j]) < 5);
}

TEST(empty_rows_and_columns_are_left_alone)
{
    sp_real D[N], E[M], col[N], row[M];
    random_problem();
    for (int32_t i = 0; i < M; i++) A[i][3] = 0;
    for (int32_t i = 0; i < N; i++) P[i][3] = P[3][i] = 0;
    for (int32_t j = 0; j < N; j++) A[5][j] = 0;
    columns();
    sp__ruiz(&qp, 10, D, E, col, row);
    CHECK_WITHIN(D[3], 1, 0);
    CHECK_WITHIN(E[5], 1, 0);
}

TEST(no_pass_no_scale)
{
    sp_real D[N], E[M], col[N], row[M];
    random_problem();
    CHECK_WITHIN(sp__ruiz(&qp, 0, D, E, col, row), 1, 0);
    CHECK_WITHIN(D[0], 1, 0);
}

TEST_LIST(ruiz)
    RUN(rows_and_columns_come_near_one)
    RUN(units_drop_out)
    RUN(empty_rows_and_columns_are_left_alone)
    RUN(no_pass_no_scale)
TEST_END
