/* What has next to no area, mass or edge: slivers beside resting faces, edges that stand across a joint, faces and masses at
 * the ends of numbers, chains of more blocks than vertices. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/scene/joint.c"
#include "../../solvers/scene/place.c"
#include "../../solvers/scene/inertia.c"
#include "../../solvers/scene/part.c"

/* ----------------------------------------------------------------------------------------------------------------- placing */

/* A cube of 1 m, corners of the bottom anticlockwise from above, then those of the top; one more vertex at (x, y, z). */
static int32_t resting(const int32_t *size, const int32_t *corner, int32_t faces, double x, double y, double z, sp_rest *r)
{
    sp_real xyz[27];
    int32_t count = -1;
    for (int v = 0; v < 8; v++) {
        xyz[3 * v] = v % 4 == 1 || v % 4 == 2;
        xyz[3 * v + 1] = v % 4 > 1;
        xyz[3 * v + 2] = v > 3;
    }
    xyz[24] = R(x);
    xyz[25] = R(y);
    xyz[26] = R(z);
    const sp_mesh m = { 9, faces, xyz, size, corner };
    CHECK_INT(sp_rest_faces(&m, test_arena, r, 12, &count), SP_OK);
    return count;
}

/* A triangle without area at an edge of the bottom: it has no normal, so no plane is its own. */
TEST(a_face_without_area_before_a_resting_face_takes_none_away)
{
    static const int32_t size[7] = { 3, 4, 4, 5, 4, 4, 4 };
    static const int32_t corner[28] = { 0, 1, 8,  0, 3, 2, 1,  4, 5, 6, 7,  0, 8, 1, 5, 4,  1, 2, 6, 5,  2, 3, 7, 6,
                                        3, 0, 4, 7 };
    sp_rest r[12];
    if (!CHECK_INT(resting(size, corner, 7, 0.5, 0, 0, r), 6)) return;
    CHECK_INT(r[0].face, 1);
    CHECK_WITHIN(r[0].normal[2], -1, 0);
    CHECK_NEAR(r[0].support.area, 1, TOL(1e-12, 1e-6));
    CHECK_NEAR(r[0].support.clearance, 0.5, TOL(1e-12, 1e-6));
}

/* A sliver that stands on a diagonal of the bottom, as high as planes are told apart: it lies in that plane and has stone on
 * both sides. Behind it the bottom's three parts count as one. */
TEST(a_sliver_that_stands_in_the_stone_takes_no_resting_face_away)
{
    static const int32_t size[9] = { 3, 3, 3, 3, 4, 4, 4, 4, 4 };
    static const int32_t corner[32] = { 0, 8, 2,  0, 2, 1,  0, 3, 8,  3, 2, 8,  4, 5, 6, 7,  0, 1, 5, 4,  1, 2, 6, 5,
                                        2, 3, 7, 6,  3, 0, 4, 7 };
    sp_rest r[12];
    if (!CHECK_INT(resting(size, corner, 9, 0.5, 0.5, 5e-7, r), 6)) return;
    CHECK_INT(r[0].face, 1);
    CHECK_NEAR(r[0].support.area, 1, 1e-5);
}

/* ------------------------------------------------------------------------------------------------------------------ joints */

static sp_scene s;

static void scene(int32_t blocks, int32_t joints, int32_t points)
{
    const sp_capacity cap = { blocks, 16, 8, 32, joints, points, 1 };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
}

/* The first edge is as high as a joint may be warped, and as long as it is high: the tangent is along the next. */
TEST(an_edge_across_its_joints_plane_is_no_tangent)
{
    static const double height[] = { 0, 3e-7, -3e-7 };
    for (int k = 0; k < 3; k++) {
        const sp_real at[3] = { 0, 0, 1 }, xyz[15] = { 0, 0, 0, 0, R(k ? 0 : 1e-2), R(height[k]), 1, 0, 0, 1, 1, 0, 0, 1, 0 };
        const sp_real flat[15] = { 0, 0, 0, R(1e-2), 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
        const sp_strength mu = { R(0.5), 0, 0, 0 };
        scene(2, 1, 5);
        CHECK_INT(sp_scene_body(&s, 0, at, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 1, 5, k ? xyz : flat, &mu, NULL), SP_OK);
        CHECK_NEAR(s.joint[0].t1[0], 1, 1e-6);
        CHECK_NEAR(s.joint[0].n[2], 1, 1e-6);
        CHECK_NEAR(s.joint[0].area, 1, 1e-5);
    }
}

/* Pressure on a wall: moments of its area overflow where the area does not. */
TEST(a_face_too_large_for_its_centroid_is_refused)
{
    static const int32_t size[1] = { 4 }, corner[4] = { 0, 1, 2, 3 };
    for (int large = 0; large < 2; large++) {
        const sp_real xyz[12] = { 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0 }, times = large ? R(TOL(1e104, 1e13)) : 1;
        const sp_mesh wall = { 4, 1, xyz, size, corner };
        scene(1, 0, 0);
        CHECK_INT(sp_scene_block(&s, &wall, 1, SP_FIXED, NULL), SP_OK);
        for (int k = 0; k < 12; k++) s.vertex[k / 3][k % 3] *= times;   /* so large a block is refused itself */
        CHECK_INT(sp_scene_pressure(&s, 0, 0, 3, 0, NULL), large ? SP_E_AREA : SP_OK);
        CHECK_INT(s.count.loads, !large);
        if (!large) CHECK_NEAR(s.load[0].force[2], -12, TOL(1e-12, 1e-6));
        if (!large) CHECK_NEAR(s.load[0].point[0], 1, TOL(1e-12, 1e-6));
    }
}

/* ----------------------------------------------------------------------------------------------------------------- inertia */

#if SP__WITH_STRONG
/* A body on a joint of sides 2 r has the inertia of a ball, 0.4 m |arm|^2. */
TEST(a_mass_of_nothing_or_next_to_nothing_has_no_inertia)
{
    static const double mass[] = { 1, 0, TOL(1e-310, 1e-40), 1 }, far[] = { 1, 1, TOL(1e153, 1e18), 0 };
    for (int k = 0; k < 4; k++) {
        const sp_real r = R(far[k]) + (k == 3), at[3] = { 0, 0, 0 };
        const sp_real foot[12] = { -r, -r, 0, r, -r, 0, r, r, 0, -r, r, 0 };
        const sp_strength mu = { R(0.5), 0, 0, 0 };
        sp_problem pb;
        sp__inertia o;
        sp_real arm;
        scene(2, 1, 4);
        CHECK_INT(sp_scene_body(&s, 1, at, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &mu, NULL), SP_OK);
        s.block[1].mass = R(mass[k]);                   /* which sp_scene_body would refuse */
        CHECK_INT(sp_problem_build(&s, &test_arena, &pb), SP_OK);
        if (k == 3) pb.contacts = 0;                    /* no joint, no arm */
        CHECK_INT(sp__inertias(&pb, &arm, &o), k == 0);
        if (k == 0) CHECK_NEAR(o.J[0][0], 0.8, TOL(1e-12, 1e-6));
        if (k == 2) CHECK(sp__finite3(o.turn[0]) && !sp__finite(o.inverse[0]));
    }
}
#endif

/* ----------------------------------------------------------------------------------------------------------------- islands */

/* A chain of blocks that touch in one point each. */
TEST(a_chain_of_more_blocks_than_a_proof_deals_with_is_too_large)
{
    for (int32_t more = 0; more < 2; more++) {
        static int32_t up[SP_EXACT_POINTS + 1], points[SP_EXACT_POINTS + 1], blocks[SP_EXACT_POINTS + 1];
        const int32_t n = SP_EXACT_POINTS + more;
        const sp_real n3[3] = { 0, 0, 1 };
        const sp_strength mu = { R(0.5), 0, 0, 0 };
        sp__island_counts o;
        scene(n, n, n);
        for (int32_t k = 0; k < n; k++) {
            const sp_real at[3] = { 0, 0, R(k) + R(0.5) }, touch[3] = { 0, 0, R(k) };
            CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
            if (k) CHECK_INT(sp_scene_points(&s, k - 1, k, n3, 1, touch, &mu, NULL), SP_OK);
        }
        CHECK_INT(sp__islands_join(&s, up), 1);
        sp__islands_proof_size(&s, up, points, blocks, &o);
        CHECK_INT(o.points, more ? 0 : SP_EXACT_POINTS - 1);
        CHECK_INT(o.blocks, more ? 0 : SP_EXACT_POINTS);
    }
}

TEST_LIST(slivers)
    RUN(a_face_without_area_before_a_resting_face_takes_none_away)
    RUN(a_sliver_that_stands_in_the_stone_takes_no_resting_face_away)
    RUN(an_edge_across_its_joints_plane_is_no_tangent)
    RUN(a_face_too_large_for_its_centroid_is_refused)
#if SP__WITH_STRONG
    RUN(a_mass_of_nothing_or_next_to_nothing_has_no_inertia)
#endif
    RUN(a_chain_of_more_blocks_than_a_proof_deals_with_is_too_large)
TEST_END
