/* small_start: no quick ways in front of the loop, in the smallest build */
#ifndef SP__LIMIT_SMALL_START_C
#define SP__LIMIT_SMALL_START_C

#include "newton.c"

#if SP__WITH_SMALL && SP__WITH_LIMIT

/* Only: can live loads alone be balanced? */
static sp_status sp__limit_start(sp__limit *L, sp_arena *a, int *done)
{
    (void)done;
    (void)a;
    sp__limit_live_alone(L);
    return SP_OK;
}

static size_t sp__limit_start_scratch(const sp_problem *pb) { return 24 * (size_t)pb->blocks; }
static int sp__limit_start_need(sp__limit *L, sp_arena scratch, sp_arena *dry) { (void)L; (void)scratch; (void)dry; return 1; }

#endif

#endif /* SP__LIMIT_SMALL_START_C */
