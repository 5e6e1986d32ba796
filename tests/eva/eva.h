/* What harnesses of Frama-C Eva share: any number, any whole number, memory. */
#ifndef EVA_H
#define EVA_H

#define SP_API static
#include "../../solvers/base/real.c"
#include "__fc_builtin.h"
#include <stdlib.h>

/* Also infinite, or no number: a difference of infinities. */
static sp_real any(void)
{
    const sp_real x = Frama_C_double_interval(-1e308, 1e308), y = Frama_C_double_interval(-1e308, 1e308);
    return x * 1e300 - y * 1e300;
}

static int32_t any_whole(int32_t low, int32_t high) { return Frama_C_interval(low, high); }
static void any_numbers(sp_real *x, int n) { for (int k = 0; k < n; k++) x[k] = any(); }

static union { sp_real aligned; unsigned char byte[1 << 20]; } memory;

static sp_arena memory_of(size_t from)
{
    sp_arena a;
    a.base = memory.byte + from; a.capacity = sizeof memory.byte - from; a.used = a.peak = 0;
    return a;
}

#ifdef EVA_PIECES
/* Memory of its own, zeroed, for each piece the arena has room for: a step from one into the next is an alarm. */
static void *piece_of(sp_arena *a, size_t count, size_t size) { return sp__take(a, count, size) ? calloc(count, size) : NULL; }
#define sp__take piece_of
#endif

#endif
