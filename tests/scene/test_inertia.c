/* Inertia of blocks with a mesh and without, and what forces give them, by closed forms. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/scene/joint.c"
#include "../../solvers/scene/inertia.c"

#include <math.h>

#if SP__WITH_STRONG

enum { TRIALS = 30 };

/* A rotation, rows are axes. */
static void any_axes(sp_real Q[3][3])
{
    sp_real a[3], b[3];
    for (int k = 0; k < 3; k++) { a[k] = test_random_real(-1, 1); b[k] = test_random_real(-1, 1); }
    a[0] += 2;
    b[1] += 2;
    sp__unit3(a, Q[0]);
    sp__cross3(a, b, Q[2]);
    sp__unit3(Q[2], Q[2]);
    sp__cross3(Q[2], Q[0], Q[1]);
}

/* A box of `size` along Q about `middle`. */
static sp_status add_box(sp_scene *s, sp_real Q[3][3], const sp_real *size, const sp_real *middle, double density)
{
    static const int32_t corners[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 3, 2, 1,  4, 5, 6, 7,  0, 1, 5, 4,  1, 2, 6, 5,  2, 3, 7, 6,  3, 0, 4, 7 };
    sp_real xyz[24];
    const sp_mesh mesh = { 8, 6, xyz, corners, corner };
    for (int v = 0; v < 8; v++)
        for (int k = 0; k < 3; k++) {
            const sp_real x = v % 4 == 1 || v % 4 == 2 ? 1 : -1, y = v % 4 >= 2 ? 1 : -1, z = v >= 4 ? 1 : -1;
            xyz[3 * v + k] = middle[k] + (x * size[0] * Q[0][k] + y * size[1] * Q[1][k] + z * size[2] * Q[2][k]) / 2;
        }
    return sp_scene_block(s, &mesh, R(density), 0, NULL);
}

/* A scene of one free box of any sides, turned any way, with room for a body and a load beside it. */
static int one_box(sp_scene *s, sp_real Q[3][3], sp_real size[3], const sp_real *middle, double density)
{
    const sp_capacity cap = { 2, 8, 6, 24, 0, 0, 1 };
    test_arena.used = 0;
    any_axes(Q);
    for (int k = 0; k < 3; k++) size[k] = test_random_real(0.2, 3);
    return CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK) && CHECK_INT(add_box(s, Q, size, middle, density), SP_OK);
}

/* J = sum_k m / 12 (size^2 - size_k^2) q_k q_k' of a box. */
TEST(inertia_of_a_box_is_that_of_its_sides)
{
    for (int trial = 0; trial < TRIALS; trial++) {
        const sp_real middle[3] = { test_random_real(-2, 2), test_random_real(-2, 2), test_random_real(-2, 2) };
        sp_real Q[3][3], size[3];
        sp_scene s;
        sp__inertia o;
        NEED(one_box(&s, Q, size, middle, 1700));
        sp__inertia_of(&s, &s.block[0], 7, &o);
        CHECK_INT(o.known, 1);
        const double m = 1700 * (double)(size[0] * size[1] * size[2]), all = (double)sp__dot3(size, size);
        CHECK_NEAR(o.mass, m, TOL(1e-12, 1e-5));
        for (int r = 0; r < 3; r++)
            for (int c = 0; c < 3; c++) {
                double want = 0;
                for (int k = 0; k < 3; k++) want += m / 12 * (all - (double)(size[k] * size[k])) * (double)(Q[k][r] * Q[k][c]);
                CHECK_WITHIN(o.J[r][c], want, TOL(1e-11, 1e-4) * m * all);
            }
    }
}

/* Without a mesh 2/5 m r^2, r the longest arm to a corner of a joint, on either side of it. */
TEST(inertia_without_a_mesh_is_that_of_a_ball_as_large_as_joints_are_far)
{
    for (int trial = 0; trial < TRIALS; trial++) {
        const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 0 };
        const sp_strength dry = sp_strength_friction(R(0.6));
        const sp_real h = test_random_real(0.1, 2), up = test_random_real(0.1, 2), m = test_random_real(0.5, 9);
        const sp_real ground[3] = { 0, 0, -3 }, at[3] = { h / 3, 0, up }, top[3] = { h / 3, 0, 3 * up };
        const sp_real foot[12] = { 0, 0, 0, h, 0, 0, h, h, 0, 0, h, 0 };
        const sp_real head[12] = { 0, 0, 2 * up, h / 2, 0, 2 * up, h / 2, h / 2, 2 * up, 0, h / 2, 2 * up };
        sp_scene s;
        sp_problem pb;
        sp__inertia o[2];
        sp_real arm[2];
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        CHECK_INT(sp_scene_body(&s, 1, ground, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, m, at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, 2 * m, top, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &dry, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 1, 2, 4, head, &dry, NULL), SP_OK);
        NEED(sp_problem_build(&s, &test_arena, &pb) == SP_OK);
        CHECK_INT(sp__inertias(&pb, arm, o), 1);
        const double hh = (double)(h * h), uu = (double)(up * up);
        const double r[2] = { sqrt(hh * 4 / 9 + hh + uu), sqrt(hh / 9 + hh / 4 + uu) };
        for (int i = 0; i < 2; i++) {
            CHECK_INT(o[i].known, 0);
            CHECK_NEAR(arm[i], r[i], TOL(1e-12, 1e-5));
            for (int k = 0; k < 3; k++)
                for (int c = 0; c < 3; c++)
                    CHECK_WITHIN(o[i].J[k][c], k == c ? 0.4 * (i + 1) * (double)m * r[i] * r[i] : 0, TOL(1e-11, 1e-4) * (double)m);
        }
    }
}

/* a = M^-1 (force, moment): M a gives them back where all is free; held directions have none. */
TEST(acceleration_is_what_inertia_takes_and_none_where_it_is_held)
{
    for (int trial = 0; trial < 64; trial++) {
        const sp_real middle[3] = { 0, 0, 0 };
        sp_real Q[3][3], size[3], a[6] = { 0, 0, 0, 0, 0, 0 }, force[6];
        sp_scene s;
        sp_problem pb;
        sp__inertia o[2];
        sp_real arm[2];
        NEED(one_box(&s, Q, size, middle, 2000));
        s.block[0].fixed = (uint32_t)(trial % 63);
        NEED(sp_problem_build(&s, &test_arena, &pb) == SP_OK && pb.blocks == 1);
        CHECK_INT(sp__inertias(&pb, arm, o), 1);
        for (int k = 0; k < 6; k++) force[k] = test_random_real(-1, 1);
        sp__inertia_accelerate(&o[0], force, a);
        for (int k = 0; k < 6; k++) {
            const int held = s.block[0].fixed >> k & 1;
            double back = k < 3 ? (double)(o[0].mass * a[k]) : 0;
            for (int q = 0; q < 3 && k >= 3; q++) back += (double)(o[0].J[k - 3][q] * a[3 + q]);
            if (held) CHECK_NEAR(a[k], 0, 0);
            else CHECK_WITHIN(back, (double)force[k], TOL(1e-10, 1e-3));
        }
    }
}

/* A load that has mass turns with no block; one on a support does not matter. */
TEST(loads_with_mass_leave_inertia_unknown_unless_a_support_bears_them)
{
    for (int32_t on = 0; on < 2; on++) {
        const sp_real middle[3] = { 0, 0, 0 };
        const sp_load heavy = { on, 0, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, R(2) };
        sp_real Q[3][3], size[3];
        sp_scene s;
        sp_problem pb;
        sp__inertia o[2];
        sp_real arm[2];
        NEED(one_box(&s, Q, size, middle, 2000));
        CHECK_INT(sp_scene_body(&s, 1, middle, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_load(&s, &heavy, NULL), SP_OK);
        NEED(sp_problem_build(&s, &test_arena, &pb) == SP_OK);
        CHECK_INT(sp__inertias(&pb, arm, o), on);
    }
}

#endif

TEST_LIST(inertia)
#if SP__WITH_STRONG
    RUN(inertia_of_a_box_is_that_of_its_sides)
    RUN(inertia_without_a_mesh_is_that_of_a_ball_as_large_as_joints_are_far)
    RUN(acceleration_is_what_inertia_takes_and_none_where_it_is_held)
    RUN(loads_with_mass_leave_inertia_unknown_unless_a_support_bears_them)
#endif
TEST_END
