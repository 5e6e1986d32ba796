/* What harnesses of Frama-C Eva share: any number, any whole number, memory. */
#ifndef EVA_H
#define EVA_H

#define SP_API static
#include "../../solvers/base/real.c"
#include "__fc_builtin.h"

/* Also infinite, or no number: a difference of infinities. */
static sp_real any(void)
{
    const sp_real x = Frama_C_double_interval(-1e308, 1e308), y = Frama_C_double_interval(-1e308, 1e308);
    return x * 1e300 - y * 1e300;
}

static int32_t any_whole(int32_t low, int32_t high) { return Frama_C_interval(low, high); }
static void any_numbers(sp_real *x, int n) { for (int k = 0; k < n; k++) x[k] = any(); }

static union { sp_real aligned; unsigned char byte[65536]; } memory;

static sp_arena memory_of(size_t from)
{
    sp_arena a;
    a.base = memory.byte + from; a.capacity = sizeof memory.byte - from; a.used = a.peak = 0;
    return a;
}

#endif
