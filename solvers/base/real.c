/* real: numbers, and what is one. */
#ifndef SP__REAL_C
#define SP__REAL_C

#include "arena.c"

#include <string.h>
#ifndef SP_SQRT
#include <math.h>
#ifdef SP_REAL_FLOAT
#define SP_SQRT(x) sqrtf(x)
#else
#define SP_SQRT(x) sqrt(x)
#endif
#endif

#ifdef SP_REAL_MIXED
typedef float sp__low;                  /* what factors are made of; what they solve is refined in sp_real */
#define SP__LOW_EPSILON 5.9604644775390625e-08f
#else
typedef sp_real sp__low;
#define SP__LOW_EPSILON SP_EPSILON
#endif

#define SP__HUGE ((sp_real)1e30)        /* stands for no bound, and for a ratio with nothing below the line */

/* |x|, of -0 too: one instruction where the compiler knows it. */
#if defined(__GNUC__) && defined(SP_REAL_FLOAT)
static sp_real sp__abs(sp_real x) { return __builtin_fabsf(x); }
#elif defined(__GNUC__) && !defined(SP_REAL_QUAD) && !defined(SP_REAL_OTHER)
static sp_real sp__abs(sp_real x) { return __builtin_fabs(x); }
#else
static sp_real sp__abs(sp_real x) { return x < 0 ? -x : x + (sp_real)0; }
#endif
SP__NOINLINE_SMALL static sp_real sp__max(sp_real x, sp_real y) { return x < y ? y : x; }
#if !defined(SP_NO_QP) || !defined(SP_NO_CRA)
static sp_real sp__within(sp_real x, sp_real low, sp_real high) { return x < low ? low : x > high ? high : x; }
#endif

#if SP__WITH_STRONG || SP__WITH_COUPLED
/* The next of numbers without pattern.                                                        [xorshift32: Marsaglia 2003] */
static uint32_t sp__random(uint32_t x)
{
    x ^= x << 13;
    x ^= x >> 17;
    return x ^ x << 5;
}
#endif

/* x - x is 0 for a number, NaN for an infinity or a NaN. */
SP__NOINLINE_SMALL static int sp__finite(sp_real x) { return x - x >= 0; }

static int sp__all_finite(const sp_real *x, size_t n)
{
    for (size_t k = 0; k < n; k++) if (!sp__finite(x[k])) return 0;
    return 1;
}

#endif /* SP__REAL_C */
