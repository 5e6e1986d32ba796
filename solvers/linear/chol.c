/* chol: Cholesky factor of a dense symmetric positive matrix, A = L L'.                    [Golub, Van Loan, alg. 4.2.1]
 *
 * The lower triangle row after row: entry (i, j), j <= i, at i (i + 1) / 2 + j. A pivot below `floor` is made SP__NEVER:
 * that unknown comes out 0.
 */
#ifndef SP__CHOL_C
#define SP__CHOL_C

#include "envelope.c"

#if SP__WITH_LARGE || SP__WITH_QP

#define SP__NEVER ((sp_real)1e30)

#ifdef SP_SMALL
static int32_t sp__chol_factor(sp_real *a, int32_t n, sp_real floor) { return sp__envelope_factor(a, NULL, n, floor); }
static void sp__chol_solve(const sp_real *a, int32_t n, sp_real *x) { sp__envelope_solve(a, NULL, n, x); }
#else
/* In place; n^3 / 3 flops. Returns how many pivots were below the floor. */
static int32_t sp__chol_factor(sp_real *a, int32_t n, sp_real floor)
{
    int32_t low = 0;
    for (int32_t i = 0; i < n; i++) {
        sp_real *ri = a + (size_t)i * ((size_t)i + 1) / 2;
        for (int32_t j = 0; j <= i; j++) {
            const sp_real *rj = a + (size_t)j * ((size_t)j + 1) / 2;
            sp_real s = ri[j];
            for (int32_t k = 0; k < j; k++) s -= ri[k] * rj[k];
            if (j < i) ri[j] = s / rj[j];
            else if (s > floor) ri[j] = SP_SQRT(s);
            else { ri[j] = SP__NEVER; low++; }
        }
    }
    return low;
}

/* x <- A^-1 x */
static void sp__chol_solve(const sp_real *a, int32_t n, sp_real *x)
{
    for (int32_t i = 0; i < n; i++) {                                           /* L z = x */
        const sp_real *ri = a + (size_t)i * ((size_t)i + 1) / 2;
        for (int32_t k = 0; k < i; k++) x[i] -= ri[k] * x[k];
        x[i] /= ri[i];
    }
    for (int32_t i = n - 1; i >= 0; i--) {                                      /* L' x = z */
        const sp_real *ri = a + (size_t)i * ((size_t)i + 1) / 2;
        x[i] /= ri[i];
        for (int32_t k = 0; k < i; k++) x[k] -= ri[k] * x[i];
    }
}
#endif

#endif
#endif /* SP__CHOL_C */
