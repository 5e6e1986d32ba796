/* Blocks of many faces are asked by trees, grids and a few outermost corners; each has the bits of all faces. Many blocks whose
 * boxes overlap are asked along a face, and what is found has the bits of all pairs. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/contacts/find.c"

#include <math.h>

enum { ROWS = 9, ROUND = 18, VERTICES = 2 + (ROWS - 1) * ROUND, FACES = 2 * ROUND * (ROWS - 1) };

static sp_scene scene;
static sp__touch touch;

/* A ball of triangles about (x, 0, 0), its corners moved in or out by up to `rough`; `flatter` cuts its top off. */
static void ball(double x, double rough, double flatter)
{
    static sp_real xyz[VERTICES][3];
    static int32_t size[FACES], corner[3 * FACES];
    const double pi = 3.14159265358979323846;
    int32_t n = 0;
    for (int32_t v = 0; v < VERTICES; v++) {
        const int32_t row = v ? 1 + (v - 1) / ROUND : 0;
        const double up = pi * (v == VERTICES - 1 ? ROWS : row) / ROWS, way = 2 * pi * ((v - 1) % ROUND) / ROUND;
        const double r = 1 + (double)test_random_real(-1, 1) * rough, z = r * cos(up);
        xyz[v][0] = R(x + r * sin(up) * cos(way));
        xyz[v][1] = R(r * sin(up) * sin(way));
        xyz[v][2] = R(z < 1 - flatter ? z : 1 - flatter);
    }
    for (int32_t f = 0; f < FACES; f++) size[f] = 3;
    for (int32_t j = 0; j < ROUND; j++) {
        const int32_t k = (j + 1) % ROUND;
        const int32_t top[3] = { 0, 1 + j, 1 + k }, end = VERTICES - 1 - ROUND;
        for (int i = 0; i < 3; i++) corner[n++] = top[i];
        for (int32_t r = 0; r + 2 < ROWS; r++) {
            const int32_t p = 1 + r * ROUND, two[6] = { p + j, p + ROUND + j, p + ROUND + k, p + j, p + ROUND + k, p + k };
            for (int i = 0; i < 6; i++) corner[n++] = two[i];
        }
        corner[n++] = end + j;
        corner[n++] = VERTICES - 1;
        corner[n++] = end + k;
    }
    const sp_mesh mesh = { VERTICES, n / 3, xyz[0], size, corner };
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 0, NULL), SP_OK);
}

/* Two balls and their patches, as the search for contacts has them when it comes to the first pair. */
static int start(double apart, double rough, double flatter, double distance)
{
    const sp_capacity cap = { 2, 2 * VERTICES, 2 * FACES, 6 * FACES, 10, 100, 0 };
    if (!CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK)) return 0;
    ball(0, rough, flatter);
    ball(apart, rough, flatter);
    memset(&touch, 0, sizeof touch);
    touch.scene = &scene;
    touch.set = sp_contact_settings_default();
    touch.set.distance = R(distance);
    sp__contact_arrays_carve(&touch.all, &scene, &test_arena);
    sp__touch_blocks(&touch, &test_arena);
    sp__pair_start(&touch, 1);
    return CHECK_INT(touch.status, SP_OK);
}

TEST(a_tree_of_faces_tells_the_depth_of_all_faces)
{
    int32_t deep = 0;
    NEED(start(1.9, 0.05, 0.02, 1e-6));
    for (int k = 0; k < 2000; k++) {
        const sp_real x[3] = { test_random_real(-1, 1), test_random_real(-1, 1), test_random_real(-1, 1) };
        touch.inside.block = 0;
        const sp_real all = sp__depth(&touch, 0, x, touch.now.gap);
        sp__inside_build(&touch, 0);
        CHECK(sp__depth(&touch, 0, x, touch.now.gap) == all);
        deep += all > 0;
    }
    CHECK(deep > 500 && deep < 1500);
}

TEST(a_few_outermost_corners_tell_the_least_shadow_of_all)
{
    const double apart[] = { 1.5, 1.9, 2.3 };
    for (int k = 0; k < 3; k++) {
        sp_real least = SP__HUGE;
        NEED(start(apart[k], 0.03 * k, 0.02, 1e-6));
        for (int32_t p = 0; p < touch.patches; p++) {
            const sp_real x = sp__shadow(&touch, touch.all.patch[p].n);
            if (x < least) least = x;
        }
        CHECK(sp__shadow_faces(&touch, R(-9)) == least);
        CHECK((least < 0) == (k == 2));
    }
}

TEST(a_grid_of_normals_finds_the_first_patch_of_all)
{
    const double distance[] = { 1e-6, 1e-3, 2e-2 };
    for (int k = 0; k < 3; k++) {
        static int32_t mine[FACES];
        NEED(start(2, 1e-3, 0.3, distance[k]));
        sp__body *body = &touch.all.body[1];
        const sp_real flat = sp__plane_tolerance(&touch, body);
        int32_t several = 0;
        touch.patches = body->patch;
        sp__touch_group(&touch, body, FACES);
        memcpy(mine, touch.all.mine, sizeof mine);
        touch.patches = body->patch;
        for (int32_t i = 0; i < FACES; i++) {
            const int32_t f = touch.all.order[i];
            int32_t p = body->patch;
            if (!(touch.all.area[f] > 0)) continue;
            while (p < touch.patches && !sp__patch_holds(&touch, &touch.all.patch[p], f, flat)) p++;
            CHECK_INT(mine[f], p);
            several += p < touch.patches;
            touch.patches += p == touch.patches;
        }
        CHECK(several > ROUND);
    }
}

TEST(a_tree_of_faces_tells_whether_a_block_is_convex)
{
    NEED(start(2, 0, 0, 1e-6));
    CHECK_INT(touch.all.body[0].convex, 1);
    NEED(start(2, 0.01, 0, 1e-6));
    CHECK_INT(touch.all.body[0].convex, 0);
    for (int k = 0; k < 300; k++) {
        const sp_real flat = test_random_real(0, R(0.1));
        const sp__patch *p = &touch.all.patch[test_random_int(touch.all.body[1].patch, touch.patches - 1)];
        touch.own.block = 1;
        touch.inside.block = 0;
        const int all = sp__touch_before(&touch, &touch.all.body[1], p, flat);
        sp__inside_build(&touch, 1);
        CHECK_INT(sp__touch_before(&touch, &touch.all.body[1], p, flat), all);
    }
}

enum { SLABS = 300 };

/* A box with edges 2 h along the columns of a rotation, about the place o of its axes. */
static void block_along(double axis[3][3], const double o[3], const double h[3])
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
    sp_real xyz[8][3];
    for (int v = 0; v < 8; v++) {
        const int side[3] = { (v + 1) & 2, v & 2, v & 4 };
        double x[3];
        for (int c = 0; c < 3; c++) x[c] = o[c] + (side[c] ? h[c] : -h[c]);
        for (int c = 0; c < 3; c++) xyz[v][c] = R(x[0] * axis[0][c] + x[1] * axis[1][c] + x[2] * axis[2][c]);
    }
    const sp_mesh mesh = { 8, 6, xyz[0], size, corner };
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 0, NULL), SP_OK);
}

/* Slabs or beams across the diagonal of space, in an order of no kind, and the pairs of them that were asked. Lengths in `unit`. */
static int64_t lean(int beams, int tried, double unit)
{
    const double a = sqrt(0.5), b = sqrt(1 / 3.0), c = sqrt(1 / 6.0);
    double axis[3][3] = { { a, -a, 0 }, { c, c, -2 * c }, { b, b, b } };
    const sp_capacity cap = { SLABS, 8 * SLABS, 6 * SLABS, 24 * SLABS, 4 * SLABS, 16 * SLABS, 0 };
    test_arena.used = 0;
    if (!CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK)) return 0;
    for (int k = 0; k < SLABS; k++) {
        const int at = k * 7 % SLABS;
        const double slab[3] = { 4 * unit, 4 * unit, 0.0625 * unit }, beam[3] = { 0.0625 * unit, 0.0625 * unit, 4 * unit };
        const double above[3] = { 0, 0, 0.125 * unit * at }, beside[3] = { 0.125 * unit * (at % 20), 0.125 * unit * (at / 20), 0 };
        block_along(axis, beams ? beside : above, beams ? beam : slab);
    }
    memset(&touch, 0, sizeof touch);
    touch.scene = &scene;
    touch.set = sp_contact_settings_default();
    touch.set.distance = R(1e-5 * unit);
    touch.all.tree.tried = tried;
    sp__touch_all(&touch, &test_arena);
    CHECK_INT(touch.status, SP_OK);
    return touch.all.tree.asked;
}

TEST(blocks_whose_boxes_all_overlap_are_asked_along_a_face)
{
    static sp_joint joint[4 * SLABS];
    static sp_real corner[16 * SLABS][3];
    for (int beams = 0; beams < 2; beams++) {
        const int64_t all = lean(beams, 1, 1), all_joints = scene.count.joints, points = scene.count.points;
        CHECK_INT(all_joints, beams ? 19 * 15 + 20 * 14 : SLABS - 1);
        memcpy(joint, scene.joint, (size_t)all_joints * sizeof *joint);
        memcpy(corner, scene.point, (size_t)points * sizeof *corner);
        const int64_t asked = lean(beams, 0, 1);
        CHECK_INT(touch.all.tree.turned, 1);
        CHECK(all > 10000 && asked < 30 * SLABS);
        CHECK_INT(scene.count.joints, all_joints);
        CHECK_INT(scene.count.points, points);
        CHECK(memcmp(corner, scene.point, (size_t)points * sizeof *corner) == 0);
        for (int64_t j = 0; j < all_joints; j++) CHECK(joint[j].a == scene.joint[j].a && joint[j].b == scene.joint[j].b);
        CHECK_INT(lean(beams, 0, 1.0 / 1024), asked);   /* whatever the unit */
    }
}

TEST_LIST(large)
    RUN(blocks_whose_boxes_all_overlap_are_asked_along_a_face)
    RUN(a_tree_of_faces_tells_the_depth_of_all_faces)
    RUN(a_few_outermost_corners_tell_the_least_shadow_of_all)
    RUN(a_grid_of_normals_finds_the_first_patch_of_all)
    RUN(a_tree_of_faces_tells_whether_a_block_is_convex)
TEST_END
