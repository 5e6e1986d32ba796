/* none: no table of the seed's in the smallest build */
#ifndef SP__SEED_NONE_C
#define SP__SEED_NONE_C

#include "../base/config.c"

#if SP__WITH_SMALL

SP_API const sp_seed *sp_seed_table(void) { return NULL; }

#endif

#endif /* SP__SEED_NONE_C */
