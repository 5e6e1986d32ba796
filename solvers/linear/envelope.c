/* envelope: Cholesky factor of a sparse symmetric positive matrix kept row by row from its first entry on, A = L L': what lies
 * left of a row's first entry stays 0, so there is no fill to predict and no order to find.     [George, Liu 1981, section 4.1]
 *
 * Entry (i, j) of the lower triangle is a[row[i] + j]; rows follow each other, so row i begins at column
 * row[i - 1] + i - row[i], row 0 at 0. `row` NULL: all of the triangle. A pivot of no more than `floor` carries nothing: that
 * unknown comes out 0.
 */
#ifndef SP__ENVELOPE_C
#define SP__ENVELOPE_C

#include "../base/real.c"

#if SP__WITH_SMALL

/* First column of row i, and where its column 0 would be. */
static int32_t sp__envelope_first(const int32_t *row, int32_t i) { return row && i ? row[i - 1] + i - row[i] : 0; }

static size_t sp__envelope_at(const int32_t *row, int32_t i) { return row ? (size_t)row[i] : (size_t)i * ((size_t)i + 1) / 2; }

/* In place; the sum of the squared lengths of rows is its flops. Returns how many pivots carry nothing. */
static int32_t sp__envelope_factor(sp_real *a, const int32_t *row, int32_t n, sp_real floor)
{
    int32_t low = 0;
    for (int32_t i = 0; i < n; i++) {
        const int32_t first = sp__envelope_first(row, i);
        sp_real *ri = a + sp__envelope_at(row, i);
        for (int32_t j = first; j <= i; j++) {
            const sp_real *rj = a + sp__envelope_at(row, j);
            const int32_t own = sp__envelope_first(row, j);
            sp_real s = ri[j];
            for (int32_t k = own > first ? own : first; k < j; k++) s -= ri[k] * rj[k];
            if (j < i) ri[j] = s / rj[j];
            else if (s > floor) ri[j] = SP_SQRT(s);
            else { ri[j] = SP__HUGE; low++; }
        }
    }
    return low;
}

/* x <- A^-1 x */
static void sp__envelope_solve(const sp_real *a, const int32_t *row, int32_t n, sp_real *x)
{
    for (int32_t i = 0; i < n; i++) {                                           /* L z = x */
        const sp_real *ri = a + sp__envelope_at(row, i);
        for (int32_t k = sp__envelope_first(row, i); k < i; k++) x[i] -= ri[k] * x[k];
        x[i] /= ri[i];
    }
    for (int32_t i = n - 1; i >= 0; i--) {                                      /* L' x = z */
        const sp_real *ri = a + sp__envelope_at(row, i);
        x[i] /= ri[i];
        for (int32_t k = sp__envelope_first(row, i); k < i; k++) x[k] -= ri[k] * x[i];
    }
}

#endif
#endif /* SP__ENVELOPE_C */
