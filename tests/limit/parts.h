/* What the white-box suites of limits share: a cube under dead and live loads, its bracket and engine; a fence stands behind
 * every piece they take. All of it is static. */
#ifndef PARTS_H
#define PARTS_H

#define SP_API static
#include "../test.h"
#include "../base/fence.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/limit/limit.c"

#if SP__WITH_INTERIOR

#define G R(9.80665)
#define W (R(1000) * G)                                 /* weight of the cube */

static sp_scene s;
static sp_settings set;
static sp__bracket b;
static sp__engine g;

/* All fences stand, and there were some. */
static void whole(void)
{
    fences_down(NULL);
    CHECK_INT(broken, 0);
    CHECK(built > 0);
    broken = built = 0;
}

/* A cube of 1 m on a plate, friction 1/2: `dead` and `live` forces at `up` above its centroid. */
static void cube(const sp_real dead[3], const sp_real live[3], sp_real up, const sp_strength *strength)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 2 };
    const sp_real foot[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
    const sp_real at[3] = { R(0.5), R(0.5), R(0.5) }, ground[3] = { R(0.5), R(0.5), R(-5) };
    const sp_strength plain = { R(0.5), 0, 0, 0 };
    const sp_load of[2] = { { 1, 0, { R(0.5), R(0.5), R(0.5) + up }, { dead[0], dead[1], dead[2] }, { 0, 0, 0 }, 0 },
                            { 1, 1, { R(0.5), R(0.5), R(0.5) + up }, { live[0], live[1], live[2] }, { 0, 0, 0 }, 0 } };
    test_arena.used = 0;
    set = sp_settings_default();
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, R(1000), at, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, strength ? strength : &plain, NULL), SP_OK);
    for (int k = 0; k < 2; k++) CHECK_INT(sp_scene_load(&s, &of[k], NULL), SP_OK);
}

/* The bracket of `set`, the engine with all its iterations. */
static void open(void)
{
    CHECK_INT(sp__bracket_build(&s, &set, &b, &test_arena), SP_OK);
    CHECK_INT(sp__engine_carve(&g, &b.pb, NULL, &test_arena), 1);
    b.room.base = fenced_take(&test_arena, 1, sp__certifier_need(&b.pb, &b.set));
    b.room.capacity = sp__certifier_need(&b.pb, &b.set);
    sp__engine_begin(&g, &b, &test_arena);
}

/* The limit of a scene, not begun. */
static sp__limit *limit_built(const sp_scene *of)
{
    const size_t numbers = sp__limit_room(of);
    sp_real *number = fenced_take(&test_arena, numbers, sizeof *number);
    sp__limit *l = fenced_take(&test_arena, 1, sizeof *l);
    memset(number, 0, numbers * sizeof *number);
    memset(l, 0, sizeof *l);
    CHECK_INT(sp__limit_build(l, of, &set, number, &test_arena), SP_OK);
    return l;
}

static const sp_real NOTHING[3] = { 0, 0, 0 };

#endif

#endif /* PARTS_H */
