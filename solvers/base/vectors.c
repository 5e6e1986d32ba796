/* vectors: sums and products of vectors of any length, and quotients that stay in range. */
#ifndef SP__VECTORS_C
#define SP__VECTORS_C

#include "real.c"

#if SP__WITH_STONES

/* a / b for a, b >= 0; 0 / 0 is 0; SP__HUGE for what is larger or no number. */
static sp_real sp__ratio(sp_real a, sp_real b)
{
    if (a <= 0 && a >= 0) return 0;
    if (b > 1) return a / b < SP__HUGE ? a / b : SP__HUGE;      /* there SP__HUGE b may leave the range of float */
    return a < SP__HUGE * b ? a / b : SP__HUGE;
}

static sp_real sp__dot(const sp_real *a, const sp_real *b, size_t n)
{
    sp_real s = 0;
    for (size_t k = 0; k < n; k++) s += a[k] * b[k];
    return s;
}

/* a = s a + t b. */
static void sp__add(sp_real *a, sp_real s, sp_real t, const sp_real *b, size_t n)
{
    for (size_t k = 0; k < n; k++) a[k] = s * a[k] + t * b[k];
}

#endif

#endif /* SP__VECTORS_C */
