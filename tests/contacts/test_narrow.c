/* Polygons too narrow or too small for a joint, edges without length, patches without edges, blocks of many faces: parts of the
 * search for contacts, each on its own. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/contacts/find.c"

#include <math.h>

#ifndef SP_SMALL

static sp_scene scene;
static sp__touch touch;

#include "boxes.h"

static void open_scene(int32_t blocks)
{
    const sp_capacity cap = { blocks, 64 * blocks, 64 * blocks, 256 * blocks, 8, 64, 0 };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
}

static void find_patches(void)
{
    memset(&touch, 0, sizeof touch);
    touch.scene = &scene;
    touch.set = sp_contact_settings_default();
    sp__contact_arrays_carve(&touch.all, &scene, &test_arena);
    sp__touch_blocks(&touch, &test_arena);
    CHECK_INT(touch.status, SP_OK);
}

/* A prism of n sides and length 2 h, its axis along n3. */
static void prism(int32_t n, const sp_real at[3], const sp_real n3[3], double h)
{
    static sp_real xyz[96];
    static int32_t size[18], corner[96];
    sp_real axis[3][3];
    int32_t corners = 0;
    sp__unit3(n3, axis[2]);
    sp__across3(axis[2], axis[0]);
    sp__cross3(axis[2], axis[0], axis[1]);
    for (int32_t v = 0; v < 2 * n; v++)
        for (int i = 0; i < 3; i++) {
            const double t = 6.283185307179586 * (v % n) / n;
            xyz[3 * v + i] = at[i] + R(cos(t)) * axis[0][i] + R(sin(t)) * axis[1][i] + R(v < n ? -h : h) * axis[2][i];
        }
    for (int32_t k = 0; k < n; k++) {
        const int32_t m = (k + 1) % n, side[4] = { k, m, n + m, n + k };
        size[2 + k] = 4;
        memcpy(corner + 2 * n + 4 * k, side, sizeof side);
    }
    size[0] = size[1] = n;
    for (int32_t k = 0; k < n; k++) { corner[corners++] = n - 1 - k; corner[n + k] = n + k; }
    const sp_mesh mesh = { 2 * n, n + 2, xyz, size, corner };
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 0, NULL), SP_OK);
}

/* Long prisms side by side, leaning: boxes along them are less than half as large as upright ones. Of one of 14 faces six are
 * looked at, the caps among them. */
TEST(boxes_stand_along_a_prism_of_many_faces)
{
    for (int32_t sides = 3; sides < 15; sides += 9) {
        const sp_real along[3] = { 1, R(0.9), R(1.1) };
        open_scene(4);
        for (int k = 0; k < 4; k++) {
            const sp_real at[3] = { R(3 * k), R(-3 * k), 0 };
            prism(sides, at, along, 9);
        }
        find_patches();
        CHECK_INT(touch.all.body[0].patches, sides + 2);
        sp__tree_build(&touch);
        sp_real upright[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
        const double was = share_of(upright);
        CHECK_INT(sp__frame_choose(&touch), 1);
        CHECK(share_of(touch.all.tree.axis) < was / 2);
        double most = 0;                                /* one axis is the prism's */
        for (int c = 0; c < 3; c++) most = fmax(most, fabs((double)sp__dot3(touch.all.tree.axis[c], along)));
        CHECK_NEAR(most, sqrt(1 + 0.81 + 1.21), TOL(1e-9, 1e-5));
    }
}

/* A cube with two vertices in one place, one after the other along bottom and side. */
TEST(an_edge_between_two_vertices_in_one_place_is_none)
{
    static const int32_t size[6] = { 5, 4, 4, 5, 4, 4 };
    static const int32_t corner[26] = { 0, 3, 2, 8, 1,  4, 5, 6, 7,  0, 1, 5, 4,  1, 8, 2, 6, 5,  2, 3, 7, 6,  3, 0, 4, 7 };
    sp_real xyz[27];
    for (int v = 0; v < 9; v++) {
        const int q = v == 8 ? 1 : v;
        xyz[3 * v] = q % 4 == 1 || q % 4 == 2;
        xyz[3 * v + 1] = q % 4 > 1;
        xyz[3 * v + 2] = q > 3;
    }
    const sp_mesh mesh = { 9, 6, xyz, size, corner };
    open_scene(1);
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 0, NULL), SP_OK);
    find_patches();
    CHECK_INT(touch.all.body[0].patches, 6);
    for (int k = 0; k < 6; k++) CHECK_INT(touch.all.patch[k].edges, 4);
    for (int e = 0; e < touch.bounds; e++) CHECK(touch.all.bound[e][0] != touch.all.bound[e][1]);
}

TEST(a_patch_without_edges_is_near_nothing)
{
    open_scene(2);
    for (int k = 0; k < 2; k++) {
        const sp_real at[3] = { 0, 0, R(2 * k) }, up[3] = { 0, 0, 1 };
        prism(4, at, up, 1);
    }
    find_patches();
    int32_t list[8];
    const sp__body *own = &touch.all.body[0], *other = &touch.all.body[1];
    touch.now.gap = R(1e-6);
    const int32_t n = sp__pair_near(&touch, own, other, list);
    CHECK_INT(n, 5);                                    /* but for the bottom */
    touch.all.patch[list[0]].edges = 0;
    CHECK_INT(sp__pair_near(&touch, own, other, list), n - 1);
}

/* A strip of 1 by `wide` at 1e-3 from the other plane, of pieces cut at a hole or not. */
TEST(a_strip_narrower_than_the_distance_is_an_edge_but_for_a_piece)
{
    static const struct { double wide, gap; int opening, edge; } row[] = {
        { 1e-4, 1e-2, 0, 1 }, { 1e-4, 1e-2, 1, 0 }, { 1, 1e-2, 0, 0 }, { 1e-4, 1e-6, 0, 0 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        sp__patch p, q;
        sp_real y = R(row[k].wide), point[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, y, 0 }, { 0, y, 0 } };
        memset(&touch, 0, sizeof touch);
        memset(&p, 0, sizeof p);
        memset(&q, 0, sizeof q);
        p.n[2] = 1;
        q.n[2] = -1;
        q.o[2] = R(1e-3);
        touch.now.gap = R(row[k].gap);
        touch.now.snap = R(1e-6) / 8;
        touch.clip.cut.opening = row[k].opening;
        CHECK_INT(sp__pair_is_edge(&touch, &p, &q, point, 4), row[k].edge);
    }
}

/* A joint, one for which there is no room, which is counted, and one without area, which is not. */
TEST(a_polygon_without_area_is_no_joint)
{
    for (int k = 0; k < 3; k++) {
        const sp_capacity cap = { 2, 0, 0, 0, k == 1 ? 0 : 1, 8, 0 };
        const sp_real at[3] = { 0, 0, 0 };
        sp_real y = k == 2 ? 0 : 1, point[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, y, 0 }, { 0, y, 0 } };
        memset(&touch, 0, sizeof touch);
        CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
        for (int b = 0; b < 2; b++) CHECK_INT(sp_scene_body(&scene, 1, at, 0, NULL), SP_OK);
        touch.scene = &scene;
        touch.set = sp_contact_settings_default();
        touch.now.b = 1;
        sp__pair_add(&touch, 4, point);
        CHECK_INT(scene.count.joints, k == 0);
        CHECK_INT(touch.full, k == 1);
        CHECK_INT(touch.report.joints, k < 2);
        CHECK_INT(touch.report.points, k < 2 ? 4 : 0);
    }
}

#endif

TEST_LIST(narrow)
#ifndef SP_SMALL
    RUN(boxes_stand_along_a_prism_of_many_faces)
    RUN(an_edge_between_two_vertices_in_one_place_is_none)
    RUN(a_patch_without_edges_is_near_nothing)
    RUN(a_strip_narrower_than_the_distance_is_an_edge_but_for_a_piece)
    RUN(a_polygon_without_area_is_no_joint)
#endif
TEST_END
