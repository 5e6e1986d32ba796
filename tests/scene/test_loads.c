/* Loads besides weight: forces, couples, weights laid on, pressures, body forces, props; each at a limit known by hand. */
#include "../test.h"

#include <string.h>

#define G R(9.80665)
#define CLOSE TOL(1e-6, 2e-3)           /* relative distance from the limit at which both sides are decided */

/* A cube of 1 m and 2400 kg on the ground, joint at z = 0 with friction mu; room for loads. */
static sp_scene cube(double mu)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 2, 3, 1,  4, 5, 7, 6,  0, 1, 5, 4,  2, 6, 7, 3,  0, 4, 6, 2,  1, 3, 7, 5 };
    const sp_capacity cap = { 2, 16, 12, 48, 1, 4, 4 };
    const sp_real foot[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 }, ground[3] = { 0, 0, R(-5) };
    const sp_strength strength = sp_strength_friction(R(mu));
    sp_real xyz[24];
    const sp_mesh mesh = { 8, 6, xyz, size, corner };
    sp_scene s;
    for (int k = 0; k < 24; k++) xyz[k] = R(k / 3 >> k % 3 & 1);
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_block(&s, &mesh, R(2400), 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &strength, NULL), SP_OK);
    return s;
}

static const double weight = 2400 * 9.80665;

static sp_load force(double fx, double fy, double fz, double x, double y, double z)
{
    const sp_load load = { 1, 0, { R(x), R(y), R(z) }, { R(fx), R(fy), R(fz) }, { 0, 0, 0 }, 0 };
    return load;
}

static sp_verdict verdict(const sp_scene *s)
{
    sp_arena a = test_arena;
    sp_result r;
    sp_evidence e;
    CHECK_INT(sp_check(s, NULL, &a, &r), SP_OK);
    CHECK_INT(sp_verify(s, NULL, &r, a, &e), SP_OK);
    CHECK_INT(e.verdict, r.verdict);
    return r.verdict;
}

static sp_verdict loaded(double mu, sp_load load)
{
    sp_scene s = cube(mu);
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    return verdict(&s);
}

TEST(a_push_at_the_top_topples_at_half_the_weight)
{
    CHECK_INT(loaded(0.84, force(weight / 2 * (1 - CLOSE), 0, 0, 0, 0.5, 1)), SP_STABLE);
    CHECK_INT(loaded(0.84, force(weight / 2 * (1 + CLOSE), 0, 0, 0, 0.5, 1)), SP_UNSTABLE);
}

TEST(a_push_at_the_foot_slides_at_mu_times_the_weight)
{
    CHECK_INT(loaded(0.3, force(0, weight * 0.3 * (1 - CLOSE), 0, 0.5, 0, 0)), SP_STABLE);
    CHECK_INT(loaded(0.3, force(0, weight * 0.3 * (1 + CLOSE), 0, 0.5, 0, 0)), SP_UNSTABLE);
}

TEST(a_push_down_helps_against_a_push_aside)
{
    sp_scene s = cube(0.3);
    const sp_load aside = force(0.45 * weight, 0, 0, 0, 0.5, 0.1), down = force(0, 0, -weight, 0.5, 0.5, 1);
    CHECK_INT(sp_scene_load(&s, &aside, NULL), SP_OK);
    CHECK_INT(verdict(&s), SP_UNSTABLE);
    CHECK_INT(sp_scene_load(&s, &down, NULL), SP_OK);
    CHECK_INT(verdict(&s), SP_STABLE);
}

TEST(a_couple_topples_at_weight_times_half_the_width)
{
    sp_load load = force(0, 0, 0, 7, 8, 9);
    load.couple[0] = R(weight / 2 * (1 - CLOSE));
    CHECK_INT(loaded(0.84, load), SP_STABLE);
    load.couple[0] = R(weight / 2 * (1 + CLOSE));
    CHECK_INT(loaded(0.84, load), SP_UNSTABLE);
}

/* The square foot carries a couple about z of at most mu W times the mean distance of its corners from the middle. */
TEST(a_couple_about_the_vertical_is_held_by_friction_at_the_corners)
{
    const double most = 0.5 * weight * 0.70710678118654752;
    sp_load load = force(0, 0, 0, 0, 0, 0);
    load.couple[2] = R(most * (1 - CLOSE));
    CHECK_INT(loaded(0.5, load), SP_STABLE);
    load.couple[2] = R(most * (1 + CLOSE));
    CHECK_INT(loaded(0.5, load), SP_UNSTABLE);
}

/* A gripper of mass m on an arm that reaches x beyond the edge: m x = M / 2. */
TEST(a_weight_over_the_edge_topples_by_the_lever)
{
    for (int side = -1; side <= 1; side += 2) {
        sp_load load = force(0, 0, 0, 1 + 0.75, 0.5, 1);
        load.mass = R(2400 * 0.5 / 0.75 * (1 + side * CLOSE));
        CHECK_INT(loaded(0.84, load), side < 0 ? SP_STABLE : SP_UNSTABLE);
    }
}

TEST(a_hung_weight_follows_gravity)
{
    sp_scene s = cube(0.3);
    sp_load load = force(0, 0, 0, 0.5, 0.5, 0.5);
    load.mass = R(2400);                                /* at the centroid: changes nothing in the slope at which it slides */
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    s.gravity[0] = R(0.3) * G * R(1 - CLOSE);
    CHECK_INT(verdict(&s), SP_STABLE);
    s.gravity[0] = R(0.3) * G * R(1 + CLOSE);
    CHECK_INT(verdict(&s), SP_UNSTABLE);
}

/* Of a face so small that the product of two areas and a length underflows in float, and as large. */
TEST(the_centroid_of_a_face_has_no_unit)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 3, 2, 1,  4, 5, 6, 7,  0, 1, 5, 4,  1, 2, 6, 5,  2, 3, 7, 6,  3, 0, 4, 7 };
    static const double unit[5] = { 1e-11, 1e-9, 1, 1e6, 1e8 };
    for (int k = 0; k < 5; k++) {
        const sp_capacity cap = { 1, 8, 6, 24, 0, 0, 1 };
        sp_real xyz[24];
        const sp_mesh m = { 8, 6, xyz, size, corner };
        sp_scene s;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        for (int v = 0; v < 8; v++) {
            xyz[3 * v] = R(unit[k] * (v % 4 == 1 || v % 4 == 2));
            xyz[3 * v + 1] = R(unit[k] * (v % 4 >= 2));
            xyz[3 * v + 2] = R(unit[k] * (v >= 4));
        }
        CHECK_INT(sp_scene_block(&s, &m, 1, 0, NULL), SP_OK);
        NEED(sp_scene_pressure(&s, 0, 0, 1, 0, NULL) == SP_OK);
        CHECK_NEAR(s.load[0].point[0] / R(unit[k]), 0.5, TOL(1e-12, 1e-5));
        CHECK_NEAR(s.load[0].point[1] / R(unit[k]), 0.5, TOL(1e-12, 1e-5));
        CHECK_NEAR(s.load[0].force[2] / R(unit[k]) / R(unit[k]), 1, TOL(1e-12, 1e-5));
    }
}

TEST(pressure_on_a_face_pushes_at_its_centroid)
{
    for (int side = -1; side <= 1; side += 2) {
        sp_scene s = cube(0.84);                        /* face 4 looks to -x: 1 m2 at z = 1/2, topples at W / 1 */
        CHECK_INT(sp_scene_pressure(&s, 1, 4, R(weight * 0.84 * (1 + side * CLOSE)), 0, NULL), SP_OK);
        CHECK_NEAR(s.load[0].force[0], weight * 0.84 * (1 + side * CLOSE), TOL(1e-14, 1e-6));
        CHECK_NEAR(s.load[0].point[2], 0.5, TOL(1e-14, 1e-6));
        CHECK_INT(verdict(&s), side < 0 ? SP_STABLE : SP_UNSTABLE);
    }
}

TEST(live_loads_count_as_often_as_the_scene_says)
{
    for (int side = -1; side <= 1; side += 2) {
        sp_scene s = cube(0.84);
        sp_load load = force(weight, 0, 0, 0, 0.5, 1);
        load.live = 1;
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        CHECK_INT(verdict(&s), SP_UNSTABLE);
        s.live = R(0.5 * (1 + side * CLOSE));
        CHECK_INT(verdict(&s), side < 0 ? SP_STABLE : SP_UNSTABLE);
        s.live = 0;
        CHECK_INT(verdict(&s), SP_STABLE);
    }
}

TEST(a_live_body_force_slides_at_mu)
{
    for (int side = -1; side <= 1; side += 2) {
        sp_scene s = cube(0.3);
        s.body[1] = -G;
        s.live = R(0.3 * (1 + side * CLOSE));
        CHECK_INT(verdict(&s), side < 0 ? SP_STABLE : SP_UNSTABLE);
    }
}

TEST(the_problem_holds_what_acts_and_what_is_live)
{
    sp_scene s = cube(0.84);
    sp_load load = force(1, 2, 3, 1.5, 0.5, 0.5);       /* 1 m beside the centroid along x */
    sp_problem p;
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    load.live = 1;
    load.couple[1] = 5;
    load.mass = 2;
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    s.live = 10;
    s.body[0] = 1;
    CHECK_INT(sp_problem_build(&s, &test_arena, &p), SP_OK);
    NEED(p.live != NULL);
    const double g = 9.80665, live[6] = { 1 + 2400 + 2, 2, 3 - 2 * g, 0, -3 + 5 + 2 * g, 2 };
    const double all[6] = { 1, 2, 3 - 2400 * g, 0, -3, 2 };
    for (int k = 0; k < 6; k++) {
        CHECK_WITHIN(p.live[k], live[k], TOL(1e-12, 1e-3));
        CHECK_WITHIN(p.p[k], all[k] + 10 * live[k], TOL(1e-10, 1e-1));
    }
}

TEST(a_force_and_its_shift_by_a_couple_are_the_same_load)
{
    sp_load at = force(300, -200, 100, 0.25, 0.75, 1), shifted = force(300, -200, 100, 0.5, 0.5, 0.5);
    const sp_real r[3] = { R(-0.25), R(0.25), R(0.5) }, *f = at.force;
    for (int k = 0; k < 3; k++) shifted.couple[k] = r[(k + 1) % 3] * f[(k + 2) % 3] - r[(k + 2) % 3] * f[(k + 1) % 3];
    sp_real p[2][6];
    for (int which = 0; which < 2; which++) {
        sp_scene s = cube(0.84);
        sp_problem problem;
        CHECK_INT(sp_scene_load(&s, which ? &shifted : &at, NULL), SP_OK);
        CHECK_INT(sp_problem_build(&s, &test_arena, &problem), SP_OK);
        memcpy(p[which], problem.p, sizeof p[which]);
    }
    for (int k = 0; k < 6; k++) CHECK_WITHIN(p[0][k], p[1][k], 0);
}

TEST(loads_on_a_support_do_nothing)
{
    sp_load load = force(1e6, 1e6, 1e6, 9, 9, 9);
    load.block = 0;
    CHECK_INT(loaded(0.84, load), SP_STABLE);
}

/* A prop: the cube hangs half its weight over an edge it can't carry until it is held upright. */
TEST(a_prop_holds_what_would_fall)
{
    sp_scene s = cube(0.84);
    sp_load load = force(0, 0, 0, 2, 0.5, 1);
    load.mass = 2400;
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    CHECK_INT(verdict(&s), SP_UNSTABLE);
    s.block[1].fixed = 1u << 4;                         /* no turn about y */
    CHECK_INT(verdict(&s), SP_STABLE);
    s.block[1].fixed = 1u << 3;                         /* a turn about x is not what it does */
    CHECK_INT(verdict(&s), SP_UNSTABLE);
}

/* Pushed at the top the cube topples at W / 2; held upright it slides at mu W; held in that direction, too, it bears any push. */
TEST(a_propped_cube_slides_at_mu_times_its_weight)
{
    for (int side = -1; side <= 1; side += 2) {
        sp_scene s = cube(0.84);
        const sp_load load = force(weight * 0.84 * (1 + side * CLOSE), 0, 0, 0, 0.5, 1);
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        CHECK_INT(verdict(&s), SP_UNSTABLE);
        s.block[1].fixed = 1u << 4;
        CHECK_INT(verdict(&s), side < 0 ? SP_STABLE : SP_UNSTABLE);
        s.block[1].fixed |= 1u << 0;
        CHECK_INT(verdict(&s), SP_STABLE);
    }
}

/* Two plates of one weight on each other, friction lower[0] and upper[1], all shaken along x: what is above the weaker joint
 * slides at its own mu, both of them at the lower's. */
TEST(each_joint_slides_at_its_own_friction)
{
    static const double mu[2][2] = { { 0.5, 0.3 }, { 0.3, 0.5 } };
    for (int k = 0; k < 2; k++)
        for (int side = -1; side <= 1; side += 2) {
            const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 0 };
            sp_scene s;
            sp_result r;
            test_arena.used = 0;
            CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
            for (int b = 0; b < 3; b++) {
                const sp_real c[3] = { 2, 2, R(0.1 * b - 0.05) };
                const sp_real z = R(0.1 * (b - 1)), foot[12] = { 0, 0, z, 4, 0, z, 4, 4, z, 0, 4, z };
                const sp_strength strength = sp_strength_friction(R(b ? mu[k][b - 1] : 0));
                CHECK_INT(sp_scene_body(&s, 100, c, b ? 0 : SP_FIXED, NULL), SP_OK);
                if (b) CHECK_INT(sp_scene_joint(&s, b - 1, b, 4, foot, &strength, NULL), SP_OK);
            }
            s.gravity[0] = R(0.3) * G * R(1 + side * CLOSE);
            CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_OK);
            CHECK_INT(r.verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
            if (side < 0) continue;
            CHECK(r.dq[12] > 0);
            CHECK_WITHIN(r.dq[6], k ? (double)r.dq[12] : 0, TOL(1e-6, 1e-2) * (double)r.dq[12]);
        }
}

/* Blocks in free fall, weightless, turned by a couple: a motion that nothing resists. */
TEST(a_couple_turns_what_nothing_holds)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 1 };
    const sp_real at[2][3] = { { 0, 0, 0 }, { 0, 0, 1 } }, quad[12] = { 0, 0, R(0.5), 1, 0, R(0.5), 1, 1, R(0.5), 0, 1, R(0.5) };
    const sp_strength strength = sp_strength_friction(R(0.5));
    sp_load load = force(0, 0, 0, 0, 0, 0);
    sp_scene s;
    sp_result r;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < 2; k++) CHECK_INT(sp_scene_body(&s, 1, at[k], 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, quad, &strength, NULL), SP_OK);
    load.couple[0] = 1;
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    s.gravity[2] = 0;
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.final, 1);
    if (TEST_SMALL) return;                                     /* has no gates: finds another motion */
    CHECK_INT(r.reason, SP_REASON_NO_SUPPORT);
    CHECK_NEAR(r.dq[7] / r.dq[3], -1, TOL(1e-12, 1e-5));        /* the upper one swings to -y about the lower's centroid */
}

/* Without weight, held by nothing: what is neither pulled nor turned stays where it is, whichever comes first. */
TEST(of_what_floats_only_what_is_pulled_moves)
{
    const sp_capacity cap = { 3, 0, 0, 0, 0, 0, 1 };
    for (int k = 0; k < 6; k++) {
        const int pulled = k / 2;
        sp_load load = force(0, 2, 0, 2 * pulled, 0, 0);
        sp_settings set = sp_settings_default();
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
        for (int i = 0; i < 3; i++) {
            const sp_real at[3] = { R(2 * i), 0, 0 };
            CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
        }
        load.block = pulled;
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        s.gravity[2] = 0;
        set.effect[SP_EFFECT_TOGETHER] = k % 2 ? SP_WITH : SP_PLANNED;
        CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
        CHECK_INT(r.verdict, SP_UNSTABLE);
        for (int i = 0; i < 18; i++) CHECK(i == 6 * pulled + 1 ? r.dq[i] > 0 : !(r.dq[i] > 0) && !(r.dq[i] < 0));
    }
}

/* The weight in parts, pulled up in any order and from any place: what is left of the sum is rounding, and falls no more than the
 * cube does without. A millionth (float: a hundredth) more lifts it. */
TEST(loads_that_cancel_are_none_in_any_order)
{
    static const double part[4] = { 20000, 3535.96, 7777.77, 15758.19 };
    for (int k = 0; k < 40; k++) {
        const int scale = k % 5, first = 2 * (k / 5 % 2), turned = k / 10 % 2, more = k / 20;
        const double off = scale * 0.0371, up = more ? 1 + TOL(1e-6, 1e-2) : 1;
        sp_scene s = cube(0.84);
        for (int q = 0; q < 2; q++) {
            const sp_load load = force(0, 0, up * part[first + (q ^ turned)], 0.5, 0.5, 1 + off);
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        }
        if (!CHECK_INT(verdict(&s), more ? SP_UNSTABLE : SP_STABLE)) TEST_PRINT("    pull %d\n", k);
    }
}

TEST(pulls_along_one_line_cancel)
{
    sp_scene s = cube(0.84);
    const sp_load there = force(0.1, 0, 0, 0.3, 0.5, 0.7), back = force(-0.3, 0, 0, 1.3, 0.5, 0.7);
    s.gravity[2] = 0;
    for (int q = 0; q < 3; q++) CHECK_INT(sp_scene_load(&s, &there, NULL), SP_OK);
    CHECK_INT(sp_scene_load(&s, &back, NULL), SP_OK);
    CHECK_INT(verdict(&s), SP_STABLE);
}

/* Pushed from both sides, as much as one likes: that cancels, but its rounding hides no weight of what nothing carries. */
TEST(opposed_pushes_hide_no_weight)
{
    for (int k = 0; k < 5; k++) {
        double push = TOL(1e18, 1e6);
        const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 2 };
        const sp_real at[3] = { 0, 0, 0 };
        sp_scene s;
        for (int q = 0; q < k; q++) push *= 10;
        test_arena.used = 0;
        CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
        CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
        for (int side = -1; side <= 1; side += 2) {
            sp_load load = force(side * push, 0, 0, 0, 0, 0);
            load.block = 0;
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        }
        CHECK_INT(verdict(&s), SP_UNSTABLE);
    }
}

/* Two loads of opposite sign along the weight, or along the slope, swallowed it: a cube that slides stood. */
TEST(loads_that_cancel_swallow_no_weight)
{
    for (int k = 0; k < 12; k++) {
        const double push = (k % 3 + 1) * TOL(1e19, 1e9);
        const int up = k / 3 % 2, falls = k / 6;
        sp_scene s = cube(0.3);
        s.gravity[0] = (sp_real)(falls ? 3.354 : 1.703);        /* 20 or 10 degrees; friction holds 16.7 */
        for (int side = -1; side <= 1; side += 2) {
            const sp_load load = force(up ? 0 : side * push, 0, up ? side * push : 0, 0.5, 0.5, 1.25);
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        }
        if (!CHECK_INT(verdict(&s), falls ? SP_UNSTABLE : SP_STABLE)) TEST_PRINT("    loads %d\n", k);
    }
}

/* A push that moves the cube, or not, beside two loads that cancel: in the sum of those before it, it was less than rounding, and
 * what falls was told to stand, or not, by the order of the loads. */
TEST(a_third_load_was_swallowed_by_two_that_cancel)
{
    for (int k = 0; k < 12; k++) {
        const double push = weight * (k < 6 ? 0.8 : 0.9), large = push * TOL(1e17, 1e8), sent[3] = { push, large, -large };
        sp_scene s = cube(0.84);
        for (int n = 0; n < 3; n++) {
            const int which = n == 0 ? k % 3 : n == 1 ? (k % 3 + 1 + k / 3 % 2) % 3 : (k % 3 + 2 - k / 3 % 2) % 3;
            const sp_load load = force(sent[which], 0, 0, 0.5, 0.5, 0);
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        }
        if (!CHECK_INT(verdict(&s), k < 6 ? SP_STABLE : SP_UNSTABLE)) TEST_PRINT("    order %d\n", k);
    }
}

/* Lifted, but not at its centroid: it turns. */
TEST(a_couple_on_what_touches_nothing_turns_it)
{
    const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 1 };
    const sp_real at[3] = { 0, 0, 0 };
    sp_load lift = force(0, 0, 1, R(0.1), 0, 0);
    sp_scene s;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
    s.gravity[2] = -1;
    lift.block = 0;
    CHECK_INT(sp_scene_load(&s, &lift, NULL), SP_OK);
    CHECK_INT(verdict(&s), SP_UNSTABLE);
}

/* A pull of a millionth of a newton, or a couple, a huge number of times: what is rounding is asked of the loads as they come to
 * be, not of the weight as often. */
TEST(a_large_multiple_of_a_small_load_counts)
{
    for (int k = 0; k < 4; k++) {
        const double much = TOL(1e16, 1e8), share = 0.5 * weight * (k % 2 ? 1.1 : 0.9) / much;
        sp_scene s = cube(0.84);
        sp_load load = force(k < 2 ? share : 0, 0, 0, 0.5, 0.5, 1);
        load.live = 1;
        load.couple[1] = R(k < 2 ? 0 : share);
        s.live = R(much);
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        CHECK_INT(verdict(&s), k % 2 ? SP_UNSTABLE : SP_STABLE);
    }
}

TEST(bad_loads_are_refused)
{
    sp_scene s = cube(0.84);
    sp_load load = force(0, 0, 0, 0, 0, 0);
    const sp_real zero = 0;
    CHECK_INT(sp_scene_load(NULL, &load, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_load(&s, NULL, NULL), SP_E_ARGUMENT);
    load.block = 2;
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_E_INDEX);
    load.block = -1;
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_E_INDEX);
    load.block = 1;
    load.mass = R(-1);
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_E_RANGE);
    load.mass = 0;
    sp_real *const field[3] = { load.point, load.force, load.couple };
    for (int k = 0; k < 3; k++) {
        field[k][1] = zero / zero;
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_E_NOT_FINITE);
        field[k][1] = 0;
    }
    CHECK_INT(sp_scene_pressure(&s, 1, 6, 1, 0, NULL), SP_E_INDEX);
    CHECK_INT(sp_scene_pressure(&s, 0, 0, 1, 0, NULL), SP_E_INDEX);
    CHECK_INT(sp_scene_pressure(&s, 1, 0, zero / zero, 0, NULL), SP_E_NOT_FINITE);
    CHECK_INT(s.count.loads, 0);
    for (int k = 0; k < 4; k++) CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_E_CAPACITY);
    sp_result r;
    s.load[0].force[0] = TOL(1e200, 1e30f);
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
    s.load[0].force[0] = 0;
    s.live = zero / zero;
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
}

TEST(memory_is_exact_with_live_loads)
{
    sp_scene s = cube(0.84);
    const sp_load load = { 1, 1, { 0, 0, 1 }, { 100, 0, 0 }, { 0, 0, 0 }, 0 };
    sp_result r;
    size_t bytes = 0;
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes), SP_OK);
    sp_arena a = test_arena;
    test_arena.used = (test_arena.used + 15) / 16 * 16;
    a.used = test_arena.used;
    a.capacity = a.used + bytes - 1;
    CHECK_INT(sp_check(&s, NULL, &a, &r), SP_E_MEMORY);
    a.capacity++;
    CHECK_INT(sp_check(&s, NULL, &a, &r), SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
}

/* Without weight a load on one stone of a pile presses what is below it, and nothing what is above: there each force is none. */
TEST(without_weight_only_what_bears_the_load_is_pressed)
{
    const sp_capacity cap = { 12, 0, 0, 0, 11, 44, 1 };
    const sp_strength strength = sp_strength_friction(R(0.6));
    for (int k = 1; k < 12; k++)
        for (int q = 0; q < 4; q++) {
            const double at = 0.06 * k, out = at + (q < 2 ? 0.41 : 0.37) * (q % 2 ? 1 : -1);
            const sp_load load = { k, 0, { R(out), R(0.2), R(k) }, { R(0), R(0), R(-100) }, { 0, 0, 0 }, 0 };
            sp_scene s;
            test_arena.used = 0;
            CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
            for (int i = 0; i < 12; i++) {
                const double x = 0.06 * i, low = x - 0.03 - 0.47, high = x - 0.03 + 0.47;
                const sp_real c[3] = { R(x), 0, R(i - 0.5) }, v[12] = { R(low), R(-0.5), R(i - 1), R(high), R(-0.5), R(i - 1),
                                                                        R(high), R(0.5), R(i - 1), R(low), R(0.5), R(i - 1) };
                CHECK_INT(sp_scene_body(&s, R(1000), c, i ? 0 : SP_FIXED, NULL), SP_OK);
                if (i) CHECK_INT(sp_scene_joint(&s, i - 1, i, 4, v, &strength, NULL), SP_OK);
            }
            memset(s.gravity, 0, sizeof s.gravity);
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
            /* the joint of stone i reaches from 0.06 i - 0.5 to 0.06 i + 0.44: that of the first, or its own, is the first to open */
            const int stands = out < 0.06 + 0.44 && out > at - 0.5;
            const sp_verdict v = verdict(&s);
            const int open = v == SP_UNDECIDED && (stands ? TEST_SMALL : sizeof(sp_real) == 4 || TEST_SMALL);
            const int right = open || v == (stands ? SP_STABLE : SP_UNSTABLE);
            if (!CHECK(right)) TEST_PRINT("    stone %d, load %d at %g: %s\n", k, q, out, sp_verdict_text(v));
        }
}

TEST_LIST(loads)
    RUN(a_push_at_the_top_topples_at_half_the_weight)
    RUN(a_push_at_the_foot_slides_at_mu_times_the_weight)
    RUN(a_push_down_helps_against_a_push_aside)
    RUN(a_couple_topples_at_weight_times_half_the_width)
    RUN(a_couple_about_the_vertical_is_held_by_friction_at_the_corners)
    RUN(a_weight_over_the_edge_topples_by_the_lever)
    RUN(a_hung_weight_follows_gravity)
    RUN(the_centroid_of_a_face_has_no_unit)
    RUN(pressure_on_a_face_pushes_at_its_centroid)
    RUN(live_loads_count_as_often_as_the_scene_says)
    RUN(a_live_body_force_slides_at_mu)
    RUN(the_problem_holds_what_acts_and_what_is_live)
    RUN(a_force_and_its_shift_by_a_couple_are_the_same_load)
    RUN(loads_on_a_support_do_nothing)
    RUN(a_prop_holds_what_would_fall)
    RUN(a_propped_cube_slides_at_mu_times_its_weight)
    RUN(each_joint_slides_at_its_own_friction)
    RUN(a_couple_turns_what_nothing_holds)
    RUN(of_what_floats_only_what_is_pulled_moves)
    RUN(loads_that_cancel_are_none_in_any_order)
    RUN(pulls_along_one_line_cancel)
    RUN(opposed_pushes_hide_no_weight)
    RUN(loads_that_cancel_swallow_no_weight)
    RUN(a_third_load_was_swallowed_by_two_that_cancel)
    RUN(a_couple_on_what_touches_nothing_turns_it)
    RUN(a_large_multiple_of_a_small_load_counts)
    RUN(bad_loads_are_refused)
    RUN(memory_is_exact_with_live_loads)
    RUN(without_weight_only_what_bears_the_load_is_pressed)
TEST_END
