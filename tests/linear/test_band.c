/* Elimination in a band with row exchanges: systems solved against the matrix itself, and what has no solution told. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/linear/band.c"

#if SP__WITH_SLIDING

#include <math.h>
#include <string.h>

enum { MOST = 30 };

static sp_real A[MOST][MOST];

/* Entries of -1 to 1 in the band, small ones on the diagonal, so that rows are exchanged; of 1 to 3 where there is nothing else. */
static void random_band(sp__band *b, int32_t n, int32_t h)
{
    sp__band_carve(b, n, h, &test_arena);
    sp__band_zero(b);
    memset(A, 0, sizeof A);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = i > h ? i - h : 0; j < n && j <= i + h; j++)
            A[i][j] = sp__band_row(b, i)[j] = test_random_real(-1, 1) / (i == j ? R(h + 1) : R(1)) + (h ? R(0) : R(2));
}

TEST(a_band_is_solved_with_rows_exchanged)
{
    for (int trial = 0; trial < 100; trial++) {
        const sp_arena mark = test_arena;
        const int32_t n = test_random_int(1, MOST), h = test_random_int(0, 5);
        sp__band b;
        sp_real x[MOST], rhs[MOST];
        double most = 0;
        random_band(&b, n, h);
        for (int32_t i = 0; i < n; i++) rhs[i] = x[i] = test_random_real(-1, 1);
        NEED(sp__band_factor(&b));
        sp__band_solve(&b, x);
        CHECK(b.flops > 0 || !h);
        for (int32_t i = 0; i < n; i++) if (fabs((double)x[i]) > most) most = fabs((double)x[i]);
        for (int32_t i = 0; i < n; i++) {
            double r = -(double)rhs[i];
            for (int32_t j = 0; j < n; j++) r += (double)A[i][j] * (double)x[j];
            CHECK(fabs(r) <= 100 * (double)SP_EPSILON * (1 + most));
        }
        test_arena = mark;
    }
}

/* Of entries of one size the first is the pivot: the rows stay. */
TEST(a_tie_exchanges_no_rows)
{
    const sp_arena mark = test_arena;
    sp__band b;
    sp__band_carve(&b, 4, 1, &test_arena);
    sp__band_zero(&b);
    for (int32_t i = 0; i < 4; i++) for (int32_t j = 0; j < 4; j++)
        if (i - j <= 1 && j - i <= 1) sp__band_row(&b, i)[j] = i > j ? R(-1) : i < j ? R(0.5) : R(1);
    NEED(sp__band_factor(&b));
    for (int32_t k = 0; k < 4; k++) CHECK_INT(b.pivot[k], k);
    test_arena = mark;
}

/* A column of nothing, on the diagonal and below, or of what is no number. */
TEST(a_band_without_a_pivot_is_told)
{
    for (int what = 0; what < 3; what++) {
        const sp_arena mark = test_arena;
        const volatile sp_real zero = 0;
        sp__band b;
        random_band(&b, 6, 1);
        for (int32_t i = 2; i < 5; i++) sp__band_row(&b, i)[3] = what ? 1 / zero : 0;
        if (what == 2) for (int32_t i = 2; i < 5; i++) sp__band_row(&b, i)[3] *= zero;
        CHECK_INT(sp__band_factor(&b), 0);
        test_arena = mark;
    }
}

#endif

TEST_LIST(band)
#if SP__WITH_SLIDING
    RUN(a_band_is_solved_with_rows_exchanged)
    RUN(a_tie_exchanges_no_rows)
    RUN(a_band_without_a_pivot_is_told)
#endif
TEST_END
