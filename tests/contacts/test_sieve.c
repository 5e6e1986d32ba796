/* Boxes sieve pairs of blocks before anything is asked of their faces: what they are, which frame they stand along, and that they
 * let through each pair whose boxes are near and no other. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/contacts/find.c"

#include <math.h>

#ifndef SP_SMALL

enum { STONES = 150 };

static sp_scene scene;
static sp__touch touch;

#include "boxes.h"

/* Boxes of sides up to `wide`, turned any way, in a cloud `size` across; about every tenth is a body without faces. */
static void cloud(int32_t stones, double size, double wide)
{
    static const int32_t sides[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
    const sp_capacity cap = { STONES, 8 * STONES, 6 * STONES, 24 * STONES, 8 * STONES, 64 * STONES, 0 };
    CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
    for (int32_t k = 0; k < stones; k++) {
        sp_real at[3], n[3], t[3], b[3], xyz[24], half[3];
        for (int i = 0; i < 3; i++) {
            at[i] = test_random_real(-size, size);
            n[i] = test_random_real(-1, 1);
            half[i] = test_random_real(wide / 20, wide / 2);
        }
        if (test_random_int(0, 9) == 0) { CHECK_INT(sp_scene_body(&scene, 1, at, 0, NULL), SP_OK); continue; }
        sp__unit3(n, n);
        sp__across3(n, t);
        sp__cross3(n, t, b);
        for (int c = 0; c < 8; c++)
            for (int i = 0; i < 3; i++) {
                const int q = c % 4;
                xyz[3 * c + i] = at[i] + (q == 1 || q == 2 ? 1 : -1) * half[0] * t[i] + (q > 1 ? 1 : -1) * half[1] * b[i]
                               + (c > 3 ? 1 : -1) * half[2] * n[i];
            }
        const sp_mesh mesh = { 8, 6, xyz, sides, corner };
        CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), k % 9 ? 0 : SP_FIXED, NULL), SP_OK);
    }
    memset(&touch, 0, sizeof touch);
    touch.scene = &scene;
    touch.set = sp_contact_settings_default();
    sp__contact_arrays_carve(&touch.all, &scene, &test_arena);
    sp__touch_blocks(&touch, &test_arena);
    sp__tree_build(&touch);
    CHECK_INT(touch.status, SP_OK);
}

static int near_each_other(const double p[6], const double q[6])
{
    for (int c = 0; c < 3; c++) if (p[c] > q[3 + c] || q[c] > p[3 + c]) return 0;
    return 1;
}

/* Pairs whose boxes along x, y, z are near, and those along the tree's axes if it is turned. */
static int64_t pairs(void)
{
    sp__tree *tree = &touch.all.tree;
    int64_t n = 0;
    for (int32_t a = 0; a < scene.count.blocks; a++)
        for (int32_t b = a + 1; b < scene.count.blocks; b++) {
            const sp__body *p = &touch.all.body[a], *q = &touch.all.body[b];
            if (!scene.block[a].faces || !scene.block[b].faces) continue;
            if (!sp__boxes_near(p->lo, p->hi, q->lo, q->hi, p->reach + q->reach)) continue;
            if (tree->turned) {
                double x[6], y[6];
                box_of(a, tree->axis, x);
                box_of(b, tree->axis, y);
                if (!near_each_other(x, y)) continue;
            }
            n++;
        }
    return n;
}

static int64_t found(void)
{
    int64_t n = 0;
    for (int32_t a = 0; a < scene.count.blocks; a++) {
        const int32_t hits = sp__tree_near(&touch, a);
        for (int32_t k = 0; k < hits; k++) CHECK(touch.all.hit[k] > (k ? touch.all.hit[k - 1] : a));
        n += hits;
    }
    return n;
}

TEST(each_pair_whose_boxes_are_near_is_asked_and_no_other)
{
    for (int32_t stones = 1; stones <= STONES; stones += stones / 3 + 1) {
        test_arena.used = 0;
        cloud(stones, 1, 0.6);
        CHECK_INT(found(), pairs());
        for (int32_t i = 0, c = 0; i < stones && c < 3; i++) {
            if (!scene.block[i].faces) continue;
            sp__frame_of(&touch, &touch.all.patch[touch.all.body[i].patch], touch.all.tree.axis);
            touch.all.tree.turned = 1;
            sp__tree_build(&touch);
            CHECK_INT(found(), pairs());
            c++;
        }
    }
}

TEST(a_frame_is_a_faces_normal_its_first_edge_and_what_is_across)
{
    cloud(40, 1, 0.5);
    for (int32_t i = 0; i < scene.count.blocks; i++)
        for (int32_t p = touch.all.body[i].patch; p < touch.all.body[i].patch + touch.all.body[i].patches; p++) {
            const sp__patch *o = &touch.all.patch[p];
            sp_real axis[3][3], edge[3], across[3];
            if (!o->edges) continue;
            sp__frame_of(&touch, o, axis);
            sp__sub3(scene.vertex[touch.all.bound[o->edge][1]], scene.vertex[touch.all.bound[o->edge][0]], edge);
            sp__unit3(edge, edge);
            sp__cross3(o->n, edge, across);
            for (int c = 0; c < 3; c++) {
                CHECK_WITHIN(axis[0][c], o->n[c], 0);
                CHECK_WITHIN(axis[1][c], edge[c], TOL(1e-12, 1e-5));
                CHECK_WITHIN(axis[2][c], across[c], TOL(1e-12, 1e-5));
            }
        }
}

TEST(the_share_of_a_frame_is_that_of_its_formula_and_the_least_is_chosen)
{
    for (int32_t stones = 2; stones <= 48; stones += 7) {
        sp_real best[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
        double least;
        int better = 0;
        test_arena.used = 0;
        cloud(stones, 0.2, 1);
        const sp__tree *tree = &touch.all.tree;
        least = share_of(best) / 2;
        CHECK_NEAR(sp__frame_share(&touch, best), 2 * least, TOL(1e-10, 1e-4));
        for (int32_t l = 0; l < tree->leaves; l += tree->leaves / 8 + 1) {
            const sp__body *b = &touch.all.body[tree->leaf[l]];
            for (int32_t p = b->patch; p < b->patch + b->patches && p < b->patch + 6; p++) {
                sp_real axis[3][3];
                sp__frame_of(&touch, &touch.all.patch[p], axis);
                CHECK_NEAR(sp__frame_share(&touch, axis), share_of(axis), TOL(1e-10, 1e-4));
                if (!(share_of(axis) < least)) continue;
                least = share_of(axis);
                memcpy(best, axis, sizeof best);
                better = 1;
            }
        }
        CHECK_INT(sp__frame_choose(&touch), better);
        if (better) CHECK(!memcmp(best, touch.all.tree.axis, sizeof best));
    }
}

/* Bits of x, y and z in turn, x lowest, of the middle of a box in 1024 steps a side. */
TEST(a_place_on_the_curve_is_that_of_the_boxs_middle)
{
    const sp_real all_lo[3] = { -64, 0, 0 }, all_hi[3] = { 64, 1023, 0 };
    for (int k = 0; k < 200; k++) {
        const int32_t at[2] = { test_random_int(0, 1022), test_random_int(0, 1022) }, half = test_random_int(0, 8);
        const double x = 128.0 * (at[0] + 0.5) / 1023 - 64, y = at[1] + 0.5;
        const sp_real lo[3] = { R(x - half), R(y - half), 0 }, hi[3] = { R(x + half), R(y + half), 0 };
        uint32_t code = 0;
        for (int b = 0; b < 10; b++)
            for (int c = 0; c < 2; c++) code |= (uint32_t)(at[c] >> b & 1) << (3 * b + c);
        CHECK_INT(sp__morton(lo, hi, all_lo, all_hi), code);
    }
}

/* How often a better frame is looked for: once, when boxes let through more than sixteen pairs a block. */
TEST(other_axes_are_asked_for_once_where_many_pairs_are_near)
{
    cloud(100, 1, 0.6);
    touch.all.tree.asked = 16 * (int64_t)touch.all.tree.leaves;
    sp__tree_turn(&touch);
    CHECK_INT(touch.all.tree.tried, 0);
    touch.all.tree.asked++;
    sp__tree_turn(&touch);
    CHECK_INT(touch.all.tree.tried, 1);
}

#endif

TEST_LIST(sieve)
#ifndef SP_SMALL
    RUN(each_pair_whose_boxes_are_near_is_asked_and_no_other)
    RUN(a_frame_is_a_faces_normal_its_first_edge_and_what_is_across)
    RUN(the_share_of_a_frame_is_that_of_its_formula_and_the_least_is_chosen)
    RUN(a_place_on_the_curve_is_that_of_the_boxs_middle)
    RUN(other_axes_are_asked_for_once_where_many_pairs_are_near)
#endif
TEST_END
