/* Masonry whose stones weigh 1e-4 to 1e4 of what they did, known by its numbers, a hair beyond a limit. All of it is static. */
#ifndef HEAVY_H
#define HEAVY_H

#include "../test.h"
#include "gen.h"

#include <math.h>

/* Scene number k: gravity leans so far that it falls by a share of 1e-2 to 1e-7, and body is another push. */
static int heavy_stones(uint32_t k, sp_scene *s)
{
    static const char *const name[] = { "wall", "diamond", "rubble", "arch", "tower", "flat-arch" };
    uint32_t draws = 2654435769u * (k + 1);
    gen_scene g;
    sp_limit_result x;
    for (int i = 0; i < 5; i++) (void)test_draw(&draws, 0, 1);
    const int kind = (int)test_draw(&draws, 0, 6);
    gen_open(&g, name[kind]);
    gen_set(&g, kind < 3 ? "rows" : "n", kind < 3 ? 2 + (int)test_draw(&draws, 0, 2) : 3 + (int)test_draw(&draws, 0, 5));
    if (kind == 0 || kind == 2) gen_set(&g, "bricks", 1 + (int)test_draw(&draws, 0, 3));
    gen_set(&g, "mu", test_draw(&draws, 0.2, 1));
    test_arena.used = 0;
    if (!CHECK_INT(gen_build(&g, &test_arena, s), SP_OK)) return 0;
    for (int32_t i = 0; i < s->count.blocks; i++) s->block[i].mass *= R(pow(10, test_draw(&draws, -4, 4)));
    for (int c = 0; c < 3; c++) s->body[c] = R(test_draw(&draws, -10, 10));
    const sp_arena mark = test_arena;
    if (!CHECK_INT(sp_limit(s, NULL, &test_arena, &x), SP_OK) || !CHECK_INT(x.kind, SP_LIMIT_FOUND)) return 0;
    test_arena = mark;
    const double share = 1 + pow(10, -test_draw(&draws, 2, 7));
    for (int c = 0; c < 3; c++) {
        s->gravity[c] += R(share) * x.multiplier * s->body[c];
        s->body[c] = R(test_draw(&draws, -10, 10));
    }
    return 1;
}

#endif /* HEAVY_H */
