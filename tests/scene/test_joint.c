/* Joints: their frames, what is no joint, contacts in points, friction. */
#include "scene.h"

/* ------------------------------------------------------------------------------------------------------------- joints */

static double dot(const sp_real *a, const sp_real *b)
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

/* n, t1, t2 are orthonormal and right-handed to `tol`. */
static void frame_is_right_handed(const sp_joint *f, double tol)
{
    const double det = (double)f->n[0] * ((double)f->t1[1] * (double)f->t2[2] - (double)f->t1[2] * (double)f->t2[1])
                     + (double)f->n[1] * ((double)f->t1[2] * (double)f->t2[0] - (double)f->t1[0] * (double)f->t2[2])
                     + (double)f->n[2] * ((double)f->t1[0] * (double)f->t2[1] - (double)f->t1[1] * (double)f->t2[0]);
    CHECK_NEAR(det, 1, tol);
    CHECK_NEAR(dot(f->n, f->n), 1, tol);
    CHECK_NEAR(dot(f->t1, f->t1), 1, tol);
    CHECK_NEAR(dot(f->t2, f->t2), 1, tol);
    CHECK_WITHIN(dot(f->n, f->t1), 0, tol);
    CHECK_WITHIN(dot(f->n, f->t2), 0, tol);
    CHECK_WITHIN(dot(f->t1, f->t2), 0, tol);
}

TEST(square_has_the_obvious_frame)
{
    const sp_real xyz[12] = { 0, 0, 1,  2, 0, 1,  2, 2, 1,  0, 2, 1 };
    const sp_strength strength = sp_strength_friction(R(0.5));
    sp_scene scene = two_cubes();
    int32_t id = -1;
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&scene, 1, 0, 4, xyz, &strength, &id), SP_OK);        /* repeated: legal */
    CHECK_INT(id, 1);
    const sp_joint *f = &scene.joint[0];
    const sp_real x[3] = { 1, 0, 0 }, y[3] = { 0, 1, 0 }, z[3] = { 0, 0, 1 };
    for (int c = 0; c < 3; c++) {
        CHECK_WITHIN(f->n[c], z[c], 0);
        CHECK_WITHIN(f->t1[c], x[c], 0);
        CHECK_WITHIN(f->t2[c], y[c], 0);
    }
    CHECK_NEAR(f->area, 4, 0);
    CHECK_NEAR(f->strength.mu, R(0.5), 0);
    CHECK_INT(f->a, 0);
    CHECK_INT(f->b, 1);
    CHECK_INT(scene.joint[1].point, 4);
    CHECK_INT(scene.joint[1].points, 4);
    CHECK_INT(scene.count.points, 8);
    CHECK(memcmp(scene.point + 4, xyz, sizeof xyz) == 0);
}

/* An L of area 3 in units of any size and any direction; t1 goes along its first edge. */
TEST(frames_hold_at_any_scale_and_turn)
{
    static const double plan[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    for (int k = 0; k < 200; k++) {
        const double s = pow(10, (double)test_random_real(-15, 15));        /* 1e-6 .. 1e6 m in units of 1e-9 .. 1e9 */
        double r[9];
        sp_real xyz[18], e[6] = { 0, 0, 1, 1, 0, 0 };
        rotation(r);
        for (int v = 0; v < 6; v++) {
            xyz[3 * v] = R(s * plan[v][0]); xyz[3 * v + 1] = R(s * plan[v][1]); xyz[3 * v + 2] = R(s * 0.5);
        }
        turn(r, xyz, 6);
        turn(r, e, 2);
        scene.count.joints = scene.count.points = 0;
        NEED(sp_scene_joint(&scene, 0, 1, 6, xyz, &strength, NULL) == SP_OK);
        const sp_joint *f = &scene.joint[0];
        frame_is_right_handed(f, 16 * U);
        CHECK_NEAR(f->area, 3 * s * s, 64 * U);
        CHECK_NEAR(dot(f->n, e), 1, 64 * U);
        CHECK_NEAR(dot(f->t1, e + 3), 1, 64 * U);
    }
}

/* Strips 1e-6 wide keep a normal good to the width's own rounding. */
TEST(strips_are_joints_and_lines_are_not)
{
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    int32_t id;
    for (int k = 0; k < 300; k++) {
        const double s = pow(10, (double)test_random_real(-9, 9));
        double r[9];
        sp_real strip[12] = { 0, 0, 0,  R(s), 0, 0,  R(s), R(s * 1e-6), 0,  0, R(s * 1e-6), 0 };
        sp_real line[12] = { 0, 0, 0,  R(s), 0, 0,  R(s * 0.7), 0, 0,  R(s * 0.3), 0, 0 };
        if (k % 2) {
            rotation(r);
            turn(r, strip, 4);
            turn(r, line, 4);
        }
        scene.count.joints = scene.count.points = 0;
        NEED(sp_scene_joint(&scene, 0, 1, 4, strip, &strength, NULL) == SP_OK);
        frame_is_right_handed(&scene.joint[0], 16 * U);
        CHECK_NEAR(scene.joint[0].area, s * s * 1e-6, k % 2 ? 8e6 * U : 8 * U);
        REFUSED(sp_scene_joint(&scene, 0, 1, 4, line, &strength, &id), SP_E_AREA);
    }
    sp_real point[12] = { 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3 };
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, point, &strength, &id), SP_E_AREA);
    const sp_real eight[12] = { 0, 0, 0,  1, 1, 0,  1, 0, 0,  0, 1, 0 };        /* two lobes that cancel */
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, eight, &strength, &id), SP_E_AREA);
    const sp_real box_[12] = { 0, 0, 0,  1, 0, 0,  1, R(1e-3), 0,  0, R(1e-3), 0 };
    REFUSED(sp_scene_joint(&scene, 0, 1, 2, box_, &strength, &id), SP_E_AREA);
    REFUSED(sp_scene_joint(&scene, 0, 1, 0, box_, &strength, &id), SP_E_AREA);
}

/* A strip 1e-6 m wide and 1e6 m long: one part in 1e12, which float cannot tell from a line. */
TEST(very_long_strips_pass_in_double)
{
#ifndef SP_REAL_FLOAT
    const sp_real strip[12] = { 0, 0, 0,  1e6, 0, 0,  1e6, 1e-6, 0,  0, 1e-6, 0 };
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    NEED(sp_scene_joint(&scene, 0, 1, 4, strip, &strength, NULL) == SP_OK);
    CHECK_NEAR(scene.joint[0].area, 1, 8 * U);
    CHECK_NEAR(scene.joint[0].n[2], 1, 0);
#endif
}

TEST(polygons_are_plane_to_a_millionth)
{
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    int32_t id;
    sp_real xyz[12] = { 0, 0, 0,  1, 0, 0,  1, 1, 0,  0, 1, 0 };
    xyz[8] = R(4 * 0.8e-6 * sqrt(2));                   /* each corner is a quarter of it off */
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL), SP_OK);
    xyz[8] = R(4 * (double)TOL(1.2e-6, 3e-6f) * sqrt(2));
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, &id), SP_E_PLANE);
    xyz[8] = R(0.1);
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, &id), SP_E_PLANE);
}

TEST(tangent_skips_edges_without_length)
{
    const sp_strength strength = sp_strength_friction(0);
    const sp_real tiny = R(1e-10);
    const sp_real xyz[18] = { 0, 0, 0,  0, 0, 0,  tiny, 0, 0,  tiny, 1, 0,  -1, 1, 0,  -1, 0, 0 };
    sp_scene scene = two_cubes();
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 6, xyz, &strength, NULL), SP_OK);
    CHECK_NEAR(scene.joint[0].t1[1], 1, 0);         /* third edge, 1 long */
    const sp_real collinear[15] = { 0, 0, 0,  0, R(-0.5), 0,  0, -1, 0,  1, -1, 0,  1, 0, 0 };
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 5, collinear, &strength, NULL), SP_OK);
    CHECK_NEAR(scene.joint[1].t1[1], -1, 0);
    CHECK_NEAR(scene.joint[1].area, 1, 4 * U);
}

TEST(bad_joints_leave_the_scene_alone)
{
    const sp_real inf = (sp_real)HUGE_VAL, nan_ = (sp_real)NAN;
    sp_real xyz[12] = { 0, 0, 1,  1, 0, 1,  1, 1, 1,  0, 1, 1 };
    const sp_real n[3] = { 0, 0, 1 };
    const sp_strength good = sp_strength_friction(R(0.5));
    sp_scene scene = two_cubes();
    int32_t id;
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &good, &id), SP_OK);
    for (int points = 0; points < 2; points++) {
#define ADD(scene_, a, b, count, xyz_, joint_) (points ? sp_scene_points(scene_, a, b, n, count, xyz_, joint_, &id) \
                                                       : sp_scene_joint(scene_, a, b, count, xyz_, joint_, &id))
        REFUSED(ADD(NULL, 0, 1, 4, xyz, &good), SP_E_ARGUMENT);
        REFUSED(ADD(&scene, 0, 1, 4, NULL, &good), SP_E_ARGUMENT);
        REFUSED(ADD(&scene, 0, 1, 4, xyz, NULL), SP_E_ARGUMENT);
        REFUSED(ADD(&scene, 0, 1, -1, xyz, &good), SP_E_ARGUMENT);
        REFUSED(ADD(&scene, -1, 1, 4, xyz, &good), SP_E_INDEX);
        REFUSED(ADD(&scene, 0, 2, 4, xyz, &good), SP_E_INDEX);
        REFUSED(ADD(&scene, 0, INT32_MAX, 4, xyz, &good), SP_E_INDEX);
        REFUSED(ADD(&scene, 1, 1, 4, xyz, &good), SP_E_SELF);
        sp_strength j = good;
        j.mu = R(-0.1);  REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_RANGE);
        j.mu = inf;      REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_NOT_FINITE);
        j.mu = nan_;     REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_NOT_FINITE);
        j = good; j.cohesion = R(-1); REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_RANGE);
        j = good; j.tension = R(-1);  REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_RANGE);
        j = good; j.crushing = R(-1);      REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_RANGE);
        j = good; j.crushing = inf;        REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_NOT_FINITE);
        xyz[7] = nan_;   REFUSED(ADD(&scene, 0, 1, 4, xyz, &good), SP_E_NOT_FINITE);
        xyz[7] = -inf;   REFUSED(ADD(&scene, 0, 1, 4, xyz, &good), SP_E_NOT_FINITE);
        xyz[7] = 1;
#undef ADD
    }
    const sp_real huge = TOL(1e200, 1e25f), wide = TOL(1.7e308, 3e38f);
    const sp_real big[9] = { 0, 0, 0, huge, 0, 0, 0, huge, 0 }, wider[9] = { -wide, 0, 0, wide, 0, 0, 0, 1, 0 };
    REFUSED(sp_scene_joint(&scene, 0, 1, 3, big, &good, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_joint(&scene, 0, 1, 3, wider, &good, &id), SP_E_NOT_FINITE);
}

TEST(joints_and_points_stop_at_the_capacity)
{
    const sp_capacity cap = { 2, 0, 0, 0, 2, 5, 0 };
    const sp_real c[3] = { 0, 0, 0 }, n[3] = { 0, 0, 1 }, xyz[12] = { 0, 0, 1,  1, 0, 1,  1, 1, 1,  0, 1, 1 };
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene;
    int32_t id;
    NEED(sp_scene_create(&scene, &cap, &test_arena) == SP_OK);
    CHECK_INT(sp_scene_body(&scene, R(1), c, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&scene, R(1), c, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL), SP_OK);
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, &id), SP_E_CAPACITY);
    REFUSED(sp_scene_points(&scene, 0, 1, n, 2, xyz, &strength, &id), SP_E_CAPACITY);
    CHECK_INT(sp_scene_points(&scene, 0, 1, n, 1, xyz, &strength, &id), SP_OK);
    CHECK_INT(id, 1);
    REFUSED(sp_scene_points(&scene, 0, 1, n, 1, xyz, &strength, &id), SP_E_CAPACITY);
}

TEST(point_contacts_have_a_frame_of_their_normal)
{
    const sp_real xyz[6] = { 0, 0, 1,  1, 0, 1 };
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    int32_t id;
    const double most = (double)TOL(1e300, 1e37f), least = (double)TOL(1e-300, 1e-37f);
    const double length[5] = { 1, 2.5, 1e-9, most, least };
    for (int k = 0; k < 5; k++)
        for (int axis = 0; axis < 3; axis++) {
            sp_real n[3] = { 0, 0, 0 };
            n[axis] = R(length[k]);
            scene.count.joints = scene.count.points = 0;
            NEED(sp_scene_points(&scene, 0, 1, n, 2, xyz, &strength, NULL) == SP_OK);
            const sp_joint *f = &scene.joint[0];
            CHECK_WITHIN(f->n[axis], 1, 0);
            CHECK_WITHIN(f->t1[axis == 0 ? 1 : 0], 1, 0);       /* the first of the two axes across n */
            CHECK_NEAR(f->area, 0, 0);
            frame_is_right_handed(f, 0);
        }
    for (int k = 0; k < 200; k++) {
        const sp_real n[3] = { test_random_real(-1, 1), test_random_real(-1, 1), test_random_real(-1, 1) };
        scene.count.joints = scene.count.points = 0;
        NEED(sp_scene_points(&scene, 0, 1, n, 1, xyz, &strength, NULL) == SP_OK);
        frame_is_right_handed(&scene.joint[0], 16 * U);
        CHECK_NEAR(dot(scene.joint[0].n, n), sqrt(dot(n, n)), 8 * U);
    }
    const sp_real zero[3] = { 0, 0, 0 }, bad[3] = { 0, (sp_real)NAN, 1 }, inf[3] = { 0, 1, (sp_real)HUGE_VAL }, up[3] = { 0, 0, 1 };
    REFUSED(sp_scene_points(&scene, 0, 1, zero, 2, xyz, &strength, &id), SP_E_AREA);
    REFUSED(sp_scene_points(&scene, 0, 1, bad, 2, xyz, &strength, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_points(&scene, 0, 1, inf, 2, xyz, &strength, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_points(&scene, 0, 1, NULL, 2, xyz, &strength, &id), SP_E_ARGUMENT);
    REFUSED(sp_scene_points(&scene, 0, 1, up, 0, xyz, &strength, &id), SP_E_RANGE);
}

TEST(friction_is_set_for_all_or_none)
{
    const sp_real xyz[12] = { 0, 0, 1,  1, 0, 1,  1, 1, 1,  0, 1, 1 };
    const sp_strength strength = sp_strength_friction(R(0.25));
    sp_scene scene = two_cubes();
    int32_t id;
    CHECK_NEAR(strength.mu, 0.25, 0);
    CHECK_NEAR((double)strength.cohesion + (double)strength.tension + (double)strength.crushing, 0, 0);
    for (int k = 0; k < 3; k++) CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL), SP_OK);
    CHECK_INT(sp_scene_friction(&scene, R(0.75)), SP_OK);
    for (int k = 0; k < 3; k++) CHECK_NEAR(scene.joint[k].strength.mu, 0.75, 0);
    REFUSED(sp_scene_friction(&scene, R(-1)), SP_E_RANGE);
    REFUSED(sp_scene_friction(&scene, (sp_real)NAN), SP_E_NOT_FINITE);
    REFUSED(sp_scene_friction(&scene, (sp_real)HUGE_VAL), SP_E_NOT_FINITE);
    REFUSED(sp_scene_friction(NULL, R(1)), SP_E_ARGUMENT);
}

TEST_LIST(joint)
    RUN(square_has_the_obvious_frame)
    RUN(frames_hold_at_any_scale_and_turn)
    RUN(strips_are_joints_and_lines_are_not)
    RUN(very_long_strips_pass_in_double)
    RUN(polygons_are_plane_to_a_millionth)
    RUN(tangent_skips_edges_without_length)
    RUN(bad_joints_leave_the_scene_alone)
    RUN(joints_and_points_stop_at_the_capacity)
    RUN(point_contacts_have_a_frame_of_their_normal)
    RUN(friction_is_set_for_all_or_none)
TEST_END
