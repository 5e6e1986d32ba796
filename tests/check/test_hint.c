/* The hint of an island, part of a claim's hint for all blocks. */
#define SP_API static
#include "../test.h"

#include "../../solvers/base/words.c"
#include "../../solvers/check/verify.c"

#if SP__WITH_COUPLED
enum { HINT_SCENE = 7, HINT_FREE = 4, HINT_ISLAND = 2 };

/* y0 has 6 numbers a free block, the large half of all, then the small; the island's hint has those of its blocks likewise. */
TEST(an_island_has_the_rows_of_its_blocks_in_both_halves_of_the_hint)
{
    int32_t rank[HINT_SCENE + 1] = { 0, -1, 1, -1, 2, 3, -1, 4 };       /* supports have none; behind the last another */
    int32_t block[HINT_ISLAND] = { 2, 5 };
    sp_real y0[12 * HINT_FREE], hint[12 * HINT_ISLAND + 6];
    sp__island_claim p;
    sp_scene scene;
    memset(&p, 0, sizeof p);
    memset(&scene, 0, sizeof scene);
    scene.count.blocks = HINT_SCENE;
    p.t.rank = rank;
    p.pb.block = block;
    p.pb.blocks = HINT_ISLAND;
    p.hint = hint;
    for (int k = 0; k < 12 * HINT_FREE; k++) y0[k] = R(1 + k);
    for (int k = 0; k < 12 * HINT_ISLAND + 6; k++) hint[k] = -1;
    sp__island_hint(&p, &scene, y0);
    for (int half = 0; half < 2; half++)
        for (int i = 0; i < HINT_ISLAND; i++)
            for (int q = 0; q < 6; q++)
                CHECK_INT(hint[6 * (half * HINT_ISLAND + i) + q], 1 + 6 * (half * HINT_FREE + rank[block[i]]) + q);
    for (int k = 0; k < 6; k++) CHECK_INT(hint[12 * HINT_ISLAND + k], -1);
}
#endif

TEST_LIST(hint)
#if SP__WITH_COUPLED
    RUN(an_island_has_the_rows_of_its_blocks_in_both_halves_of_the_hint)
#endif
TEST_END
