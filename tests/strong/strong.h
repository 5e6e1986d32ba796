/* What the suites of strong verdicts share: the question asked and judged, a stool with a cross for feet. All of it is static. */
#ifndef STRONG_H
#define STRONG_H

#include "../test.h"
#include "../scenes/gen.h"
#include "../scenes/change.h"

#include <string.h>

/* The answer of a scene, in the memory that it says it takes; sp_strong_verify proves the same from the evidence alone. */
static sp_strong_result ask(const sp_scene *s, const sp_strong_settings *how)
{
    sp_strong_result r;
    sp_strong_kind proved = SP_STRONG_NONE;
    memset(&r, 0, sizeof r);
    sp_settings set = sp_settings_default();
    sp_result x, pressed;
    sp_settings spare = set;
    spare.budget = 200000000;                           /* enough for all that is asked here; a board's day is short */
    CHECK_INT(sp_check(s, &set, &test_arena, &x), SP_OK);
    set.effect[SP_EFFECT_FRICTION] = SP_WITHOUT;
    CHECK_INT(sp_check(s, &set, &test_arena, &pressed), SP_OK);
    const sp_real *level = pressed.verdict == SP_STABLE ? pressed.f : NULL;
    if (!CHECK_INT(sp_strong(s, &spare, how, x.f, level, &test_arena, &r), SP_OK)) return r;
    CHECK_INT(sp_strong_verify(s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK_INT(proved, r.kind);
    CHECK((r.kind == SP_STRONG_NONE) == (x.verdict != SP_STABLE));
    return r;
}

/* The answer of a generated scene, one number changed. */
static sp_strong_result of(const char *name, const char *param, double value)
{
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(gen_make(name, param, value, &test_arena, &s), SP_OK);
    return ask(&s, NULL);
}

static const int32_t box_size[6] = { 4, 4, 4, 4, 4, 4 };
static const int32_t box_face[24] = { 0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };

/* A square board of weight 1 N, half edge c and height .1 above a ground it has no joint with yet; room for two more. */
static sp_scene board(double c)
{
    const sp_capacity cap = { 4, 24, 18, 72, 12, 24, 1 };
    const sp_real x = R(c), h = R(0.1), ground[3] = { 0, 0, -1 };
    const sp_real corner[24] = { -x, -x, 0, x, -x, 0, x, x, 0, -x, x, 0, -x, -x, h, x, -x, h, x, x, h, -x, x, h };
    const sp_mesh mesh = { 8, 6, corner, box_size, box_face };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_block(&s, &mesh, R(1 / 9.80665 / (4 * c * c * 0.1)), 0, NULL), SP_OK);
    return s;
}

/* One more board, on four points of the ground, each a joint of its own whose normal is n; it touches nothing else. */
static void rest_beside(sp_scene *s, const sp_real n[3])
{
    static const sp_real side[4][2] = { { R(-0.5), R(-0.4) }, { R(0.6), R(-0.5) }, { R(0.4), R(0.5) }, { R(-0.6), R(0.4) } };
    const sp_strength rough = sp_strength_friction(R(0.5));
    sp_real corner[24];
    memcpy(corner, s->vertex[0], sizeof corner);
    const sp_mesh mesh = { 8, 6, corner, box_size, box_face };
    int32_t block;
    CHECK_INT(sp_scene_block(s, &mesh, 1, 0, &block), SP_OK);
    for (int k = 0; k < 4; k++) {
        const sp_real foot[3] = { side[k][0], side[k][1], 0 };
        CHECK_INT(sp_scene_points(s, 0, block, n, 1, foot, &rough, NULL), SP_OK);
    }
}

/* Turn the board about the vertical. */
static void turn_board(sp_scene *s, double torque)
{
    sp_load turn;
    memset(&turn, 0, sizeof turn);
    turn.block = 1;
    turn.couple[2] = R(torque);
    turn.point[2] = R(0.05);
    CHECK_INT(sp_scene_load(s, &turn, NULL), SP_OK);
}

/* A square board of weight 1 N and half edge .7 on four points at (+-near, 0), (0, +-far), its centroid low, turned by a torque about the vertical. */
static sp_scene stool(double nearer, double farther, double mu, double torque)
{
    const sp_real up[3] = { 0, 0, 1 };
    const sp_real foot[12] = { R(nearer), 0, 0, 0, R(farther), 0, R(-nearer), 0, 0, 0, R(-farther), 0 };
    const sp_strength rough = sp_strength_friction(R(mu));
    sp_scene s = board(0.7);
    for (int k = 0; k < 4; k++) CHECK_INT(sp_scene_points(&s, 0, 1, up, 1, foot + 3 * k, &rough, NULL), SP_OK);
    turn_board(&s, torque);
    return s;
}

#endif /* STRONG_H */
