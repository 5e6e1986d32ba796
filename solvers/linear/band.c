/* band: A x = b for a matrix of a band without symmetry, by elimination with row exchanges.     [Golub, Van Loan 2013, 4.3.5]
 *
 * Row i has room for columns i - h .. i + 2 h: exchanges fill h more above the diagonal. Multipliers stay where they made 0.
 */
#ifndef SP__BAND_C
#define SP__BAND_C

#include "../base/real.c"

#if SP__WITH_SLIDING

typedef struct sp__band {
    int32_t n, h;                       /* rows; |i - j| <= h where A is not 0 */
    sp_real *a;                         /* n x (3 h + 1) */
    int32_t *pivot;                     /* n */
    int64_t flops;                      /* in all */
} sp__band;

static void sp__band_carve(sp__band *A, int32_t n, int32_t h, sp_arena *a)
{
    A->n = n; A->h = h; A->flops = 0;
    A->a = sp__take(a, (size_t)n, (3 * (size_t)h + 1) * sizeof *A->a);
    A->pivot = sp__take(a, (size_t)n, sizeof *A->pivot);
}

static void sp__band_zero(sp__band *A) { memset(A->a, 0, (size_t)A->n * (3 * (size_t)A->h + 1) * sizeof *A->a); }

/* Row i, to be indexed by the column. */
static sp_real *sp__band_row(const sp__band *A, int32_t i)
{
    return A->a + (size_t)i * (3 * (size_t)A->h + 1) + A->h - i;
}

/* Last column that row k reaches after exchanges. */
static int32_t sp__band_last(const sp__band *A, int32_t k) { return k + 2 * A->h < A->n ? k + 2 * A->h : A->n - 1; }

/* Largest entry on or below the diagonal in column k; its row comes up. */
static sp_real sp__band_exchange(sp__band *A, int32_t k)
{
    const int32_t end = k + A->h < A->n ? k + A->h : A->n - 1, last = sp__band_last(A, k);
    int32_t p = k;
    for (int32_t i = k + 1; i <= end; i++)
        if (sp__abs(sp__band_row(A, i)[k]) > sp__abs(sp__band_row(A, p)[k])) p = i;
    A->pivot[k] = p;
    sp_real *x = sp__band_row(A, k), *y = sp__band_row(A, p);
    for (int32_t j = k; p > k && j <= last; j++) { const sp_real z = x[j]; x[j] = y[j]; y[j] = z; }
    return x[k];
}

/* L U in place.     returns 0: singular, or no numbers */
SP__NOINLINE static int sp__band_factor(sp__band *A)
{
    for (int32_t k = 0; k < A->n; k++) {
        const sp_real d = sp__band_exchange(A, k), *x = sp__band_row(A, k);
        const int32_t end = k + A->h < A->n ? k + A->h : A->n - 1, last = sp__band_last(A, k);
        if (!(sp__abs(d) > 0) || !sp__finite(d)) return 0;
        for (int32_t i = k + 1; i <= end; i++) {
            sp_real *y = sp__band_row(A, i);
            if (!(sp__abs(y[k]) > 0)) continue;
            const sp_real m = y[k] / d;
            y[k] = m;
            for (int32_t j = k + 1; j <= last; j++) y[j] -= m * x[j];
            A->flops += 2 * (last - k);
        }
    }
    return 1;
}

/* x = A^-1 x */
SP__NOINLINE static void sp__band_solve(sp__band *A, sp_real *x)
{
    for (int32_t k = 0; k < A->n; k++) {
        const int32_t end = k + A->h < A->n ? k + A->h : A->n - 1, p = A->pivot[k];
        const sp_real z = x[p];
        x[p] = x[k];
        x[k] = z;
        for (int32_t i = k + 1; i <= end; i++) x[i] -= sp__band_row(A, i)[k] * z;
    }
    for (int32_t k = A->n - 1; k >= 0; k--) {
        const sp_real *row = sp__band_row(A, k);
        const int32_t last = sp__band_last(A, k);
        for (int32_t j = k + 1; j <= last; j++) x[k] -= row[j] * x[j];
        x[k] /= row[k];
    }
    A->flops += 6 * (int64_t)A->n * A->h;
}

#endif

#endif /* SP__BAND_C */
