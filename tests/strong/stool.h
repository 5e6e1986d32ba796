/* Scenes that the suites of strong verdicts share: a board on points, a stool with a cross for feet, a plate. All is static. */
#ifndef STOOL_H
#define STOOL_H

#include "../test.h"

#include <string.h>

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

/* A square board of weight 1 N and half edge .7 on four points at (+-near, 0), (0, +-far), its centroid low, turned by a torque
 * about the vertical. */
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

/* A square plate of weight 1 N and half edge c on its corners, maybe on the middles of its edges, too, turned by a torque. */
static sp_scene plate(double c, double mu, double torque, int middles)
{
    const sp_real x = R(c), few[12] = { -x, -x, 0, x, -x, 0, x, x, 0, -x, x, 0 };
    const sp_real more[24] = { -x, -x, 0, 0, -x, 0, x, -x, 0, x, 0, 0, x, x, 0, 0, x, 0, -x, x, 0, -x, 0, 0 };
    const sp_strength rough = sp_strength_friction(R(mu));
    sp_scene s = board(c);
    CHECK_INT(sp_scene_joint(&s, 0, 1, middles ? 8 : 4, middles ? more : few, &rough, NULL), SP_OK);
    turn_board(&s, torque);
    return s;
}

#endif /* STOOL_H */
