/* Strong verdicts: what pressure alone holds, what moves for all that friction does, and claims that prove neither. */
#include "../test.h"

#ifndef SP_NO_STRONG
#include "strong.h"

#include <math.h>

enum { CASES = TOL(1, 0) };             /* in float no proof by cases */

/* A beam on two posts on a floor. */
static sp_scene trilithon(void)
{
    const sp_capacity cap = { 4, 32, 24, 96, 4, 16, 0 };
    const sp_strength rough = sp_strength_friction(R(0.5));
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    static const sp_real low[4][3] = { { -2, -1, -1 }, { R(-1.5), R(-0.3), 0 }, { R(0.9), R(-0.3), 0 }, { -2, R(-0.4), 2 } };
    static const sp_real high[4][3] = { { 2, 1, 0 }, { R(-0.9), R(0.3), 2 }, { R(1.5), R(0.3), 2 }, { 2, R(0.4), R(2.5) } };
    for (int k = 0; k < 4; k++) {
        const sp_real *a = low[k], *b = high[k];
        const sp_real c[24] = { a[0], a[1], a[2], b[0], a[1], a[2], b[0], b[1], a[2], a[0], b[1], a[2],
                                a[0], a[1], b[2], b[0], a[1], b[2], b[0], b[1], b[2], a[0], b[1], b[2] };
        const sp_mesh box = { 8, 6, c, box_size, box_face };
        CHECK_INT(sp_scene_block(&s, &box, 2400, k ? 0 : SP_FIXED, NULL), SP_OK);
    }
    for (int k = 0; k < 2; k++) {
        const sp_real *a = low[1 + k], *b = high[1 + k];
        const sp_real foot[12] = { a[0], a[1], 0, b[0], a[1], 0, b[0], b[1], 0, a[0], b[1], 0 };
        const sp_real head[12] = { a[0], a[1], 2, b[0], a[1], 2, b[0], b[1], 2, a[0], b[1], 2 };
        CHECK_INT(sp_scene_joint(&s, 0, 1 + k, 4, foot, &rough, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 1 + k, 3, 4, head, &rough, NULL), SP_OK);
    }
    return s;
}

TEST(what_pressure_alone_holds_is_strong)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "two-cubes", "offset", 0.4 }, { "overhang", "factor", 0.9 }, { "cantilever", "reach", 1.1 }, { "tower", "n", 6 },
        { "wall", "rows", 3 }, { "flat-arch", "n", 5 }, { "flat-arch", "mu", 0 } };
    for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++) {
        const sp_strong_result r = of(scene[k].name, scene[k].param, scene[k].value);
        if (!CHECK_INT(r.kind, SP_STRONG_STRONG)) TEST_PRINT("    %s\n", scene[k].name);
        CHECK(r.reason == SP_STRONG_PRESSURE && r.plate && r.residual <= r.tol);
    }
}

TEST(a_beam_held_by_squeezing_alone_is_ambiguous_whatever_the_friction)
{
    static const double mu[] = { 0.01, 0.5, 2, 20 };
    for (int k = 0; k < 4; k++) {
        const sp_strong_result r = of("h-model", "mu", mu[k]);
        CHECK_INT(r.kind, SP_STRONG_AMBIGUOUS);
        CHECK_INT(r.reason, SP_STRONG_MOTION);
        CHECK(fabs((double)r.moves - 1) < TOL(1e-9, 1e-3));                     /* it falls freely */
    }
}

/* Level courses, a leaning stack, a flat arch without much friction, a beam on posts: pressure alone. */
TEST(level_walls_stacks_and_a_trilithon_are_strong)
{
    for (int k = 0; k < 8; k++) {
        const sp_strong_result r = k < 3 ? of("wall", "rows", 1 + k) : k < 6 ? of("tower", "n", 2 + k)
                                         : of("flat-arch", "mu", 0.01 * k);
        CHECK(r.kind == SP_STRONG_STRONG && r.reason == SP_STRONG_PRESSURE);
    }
    const sp_scene s = trilithon();
    CHECK_INT(ask(&s, NULL).reason, SP_STRONG_PRESSURE);
}

/* Narrower downward its sides press it up; else nothing but a squeeze of its own holds it, from mu = tan on. */
TEST(a_keystone_is_strong_where_it_narrows_downward_and_never_else)
{
    static const double angle[] = { -20, -5, -0.1, 0, 0.1, 5, 20 };
    for (int k = 0; k < 7; k++) {
        const double tan_s = tan(angle[k] * 3.14159265358979323846 / 180);
        sp_scene s;
        test_arena.used = 0;
        CHECK_INT(gen_make("keystone", "angle", angle[k], &test_arena, &s), SP_OK);
        for (int above = 0; above < 2; above++) {
            const double mu = tan_s + (above ? 1 : -1) * TOL(1e-3, 0.05) * (tan_s > 0.01 ? tan_s : 0.01);
            if (mu < 0) continue;
            for (int32_t j = 0; j < s.count.joints; j++) s.joint[j].strength.mu = R(mu);
            const sp_strong_result r = ask(&s, NULL);
            CHECK_INT(r.kind, angle[k] < 0 ? SP_STRONG_STRONG : above ? SP_STRONG_AMBIGUOUS : SP_STRONG_NONE);
            if (angle[k] < 0) CHECK_INT(r.reason, SP_STRONG_PRESSURE);
        }
    }
}

/* tan b <= mu to a millionth from both sides, held to the plane or not, wherever in the joint pressure is. */
TEST(a_slope_is_decided_to_a_millionth_in_the_plane_and_in_space)
{
    for (int plane = 0; plane < 2; plane++)
        for (int above = 0; above < 2; above++) {
            const double near = TOL(1e-6, 1e-2);
            sp_scene s;
            test_arena.used = 0;
            CHECK_INT(gen_make("incline", "angle", 20, &test_arena, &s), SP_OK);
            for (int32_t b = 0; b < s.count.blocks && plane; b++) if (!s.block[b].fixed) s.block[b].fixed = 42;
            s.joint[0].strength.mu = R(0.36397023426620234 * (above ? 1 - near : 1 + near));
            const sp_strong_result r = ask(&s, NULL);
            CHECK_INT(r.kind, above ? SP_STRONG_NONE : CASES ? SP_STRONG_STRONG : SP_STRONG_ADMISSIBLE);
            if (!above && CASES) CHECK(r.reason == SP_STRONG_EVEN && r.plate && r.margin > 0);
        }
}

/* r = c sqrt 2: two corners across carry mu W r; two middles mu W c only. So which corners a joint lists matters, and strong at
 * these corners is no more than that. The largest spin is (T - mu W c) / J. */
TEST(a_plate_on_its_corners_holds_what_moves_with_the_middles_of_its_edges_too)
{
    const sp_strong_settings corners = { 256, 1 };
    const double c = 0.5, mu = 0.4, r = c * sqrt(2.0), torque = 0.85 * mu * r, J = (4 * c * c + 4 * c * c) / 12 / 9.80665;
    sp_scene s = plate(c, mu, torque, 0);
    sp_strong_result x = ask(&s, &corners);
    CHECK_INT(x.kind, CASES ? SP_STRONG_AT_CORNERS : SP_STRONG_ADMISSIBLE);
    CHECK(!x.plate);
    s = plate(c, mu, torque, 1);
    x = ask(&s, &corners);
    CHECK_INT(x.kind, SP_STRONG_AMBIGUOUS);
    CHECK(!x.plate);
    const double spin = (double)x.a[6 + 5], most = (torque - mu * c) / J;
    CHECK(spin > 0 && spin <= most * (1 + TOL(1e-9, 1e-3)));
    CHECK(fabs(spin / most - 1) < TOL(1e-6, 1e-2));
}

/* Pressure that gathers at the middle holds no torque, and spins by T / J: so says the plate's answer, however its edges are split.
 * Without a torque nothing spins it. */
TEST(splitting_an_edge_never_changes_the_answer_of_a_plate)
{
    const double c = 0.5, mu = 0.4, W = 1, J = (4 * c * c + 4 * c * c) / 12 / 9.80665;
    static const double part[] = { 0.1, 0.3, 0.85, 0.99 };
    for (int k = 0; k < 4; k++)
        for (int middles = 0; middles < 2; middles++) {
            const double torque = part[k] * mu * W * c;
            sp_scene s = plate(c, mu, torque, middles);
            const sp_strong_result x = ask(&s, NULL);
            CHECK_INT(x.kind, SP_STRONG_AMBIGUOUS);
            CHECK(x.plate);
            CHECK(fabs((double)x.a[6 + 5] * J / torque - 1) < TOL(1e-6, 1e-2));
        }
    const sp_scene s = plate(c, mu, 0, 1);
    CHECK_INT(ask(&s, NULL).kind, SP_STRONG_STRONG);
}

/* A point has no centre of pressure but itself, and what stands on points beside a plate rests. */
TEST(a_plate_spins_beside_what_rests_on_single_points)
{
    const double c = 0.5, mu = 0.4, W = 1, J = (4 * c * c + 4 * c * c) / 12 / 9.80665, torque = 0.5 * mu * W * c;
    const sp_real slope[3] = { R(0.2), R(0.1), 1 };
    sp_scene s = plate(c, mu, torque, 0);
    rest_beside(&s, slope);
    const sp_strong_result x = ask(&s, NULL);
    CHECK_INT(x.kind, SP_STRONG_AMBIGUOUS);
    CHECK(x.plate);
    CHECK(fabs((double)x.a[6 + 5] * J / torque - 1) < TOL(1e-6, 1e-2));
    for (int k = 12; k < 18; k++) CHECK(fabs((double)x.a[k]) < TOL(1e-12, 1e-5));
}

/* What moves at the centre of its pressure is no motion where pressure is at the corners, or elsewhere. */
TEST(friction_at_the_centre_of_pressure_is_judged_as_one_force)
{
    const double c = 0.5, mu = 0.4;
    sp_strong_kind proved;
    sp_scene s = plate(c, mu, 0.3 * mu * c, 0);
    const sp_strong_result x = ask(&s, NULL);
    CHECK(x.kind == SP_STRONG_AMBIGUOUS && x.plate);
    for (int what = 0; what < 3; what++) {
        const sp_real was = x.moving[what];
        x.moving[what] += R(what ? 0.01 : 0.1);         /* more pressure there; friction that corners do not share alike */
        CHECK_INT(sp_strong_verify(&s, NULL, &x, test_arena, &proved), SP_OK);
        CHECK_INT(proved, SP_STRONG_ADMISSIBLE);
        x.moving[what] = was;
    }
    CHECK_INT(sp_strong_verify(&s, NULL, &x, test_arena, &proved), SP_OK);
    CHECK_INT(proved, SP_STRONG_AMBIGUOUS);
}

TEST(a_block_on_a_slope_below_its_friction_is_strong)
{
    static const double angle[] = { 5, 20, 39 };        /* tan 40 = .84 */
    for (int k = 0; k < 3; k++) {
        const sp_strong_result r = of("incline", "angle", angle[k]);
        CHECK_INT(r.kind, CASES ? SP_STRONG_STRONG : SP_STRONG_ADMISSIBLE);     /* rounding of float proves nothing */
        if (CASES) CHECK(r.reason == SP_STRONG_EVEN && r.plate && r.starts == 0 && r.proof.leaves == 0);
    }
    CHECK_INT(of("incline", "angle", 41).kind, SP_STRONG_NONE);
}

/* n cubes, each .08 m beyond the one below, gravity turned that way by tan t: they tip about the edge of the support at
 * n tan t = 1 - .08 (n + 1). */
TEST(stacks_on_a_slope_are_strong_until_they_tip)
{
    for (int n = 1; n <= 10; n++)
        for (int over = 0; over < 2; over++) {
            const double tan = (1 - 0.08 * (n + 1)) / n * (over ? 1.001 : 0.999);
            sp_scene s;
            test_arena.used = 0;
            CHECK_INT(gen_make("tower", "n", n, &test_arena, &s), SP_OK);
            for (int32_t j = 0; j < s.count.joints; j++) s.joint[j].strength.mu = R(1.2);
            s.gravity[0] = -s.gravity[2] * R(tan);
            const sp_strong_result r = ask(&s, NULL);
            if (!CASES) continue;
            if (!CHECK_INT(r.kind, over ? SP_STRONG_NONE : SP_STRONG_STRONG)) TEST_PRINT("    %d cubes\n", n);
        }
}

/* A block that leans against another closes a loop, and friction without torsion asks for a load without. */
TEST(even_friction_is_no_proof_around_a_loop_or_with_torsion)
{
    sp_scene s = plate(0.5, 0.4, 0.02, 0);
    CHECK(ask(&s, NULL).reason != SP_STRONG_EVEN);
    s = trilithon();
    s.gravity[0] = R(0.5);
    CHECK(ask(&s, NULL).reason != SP_STRONG_EVEN);
}

/* Friction of one joint listed in parts counts as one, and forces that lack some of it prove nothing. */
TEST(joints_of_the_same_two_blocks_count_as_one_where_they_lie_in_a_plane)
{
    const sp_real x = R(0.5), half[2][12] = { { -x, -x, 0, 0, -x, 0, 0, x, 0, -x, x, 0 }, { 0, -x, 0, x, -x, 0, x, x, 0, 0, x, 0 } };
    const sp_strength rough = sp_strength_friction(R(0.4));
    sp_strong_kind proved;
    sp_scene s = board(0.5);
    for (int k = 0; k < 2; k++) CHECK_INT(sp_scene_joint(&s, 0, 1, 4, half[k], &rough, NULL), SP_OK);
    s.gravity[0] = R(3.5);
    s.gravity[1] = R(-1);
    const sp_strong_result r = ask(&s, NULL);
    CHECK((r.kind == SP_STRONG_STRONG && r.reason == SP_STRONG_EVEN) || !CASES);
    s.joint[1].strength.mu = R(0.3);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK(proved < SP_STRONG_AT_CORNERS);
}

/* Corners at r1 that carry all the weight hold mu W r1, those at r2 > r1 mu W r2; the largest spin is (T - mu W r1) / J. */
TEST(a_stool_with_a_cross_for_feet_is_ambiguous_from_the_lesser_torque_on_and_spins_the_most_it_can)
{
    const sp_strong_settings no_starts = { 0, 0 };
    const double mu = 0.5, r1 = 0.3, r2 = 0.6, J = (0.7 * 0.7 + 0.7 * 0.7) / 3 / 9.80665;
    static const double below[] = { 0, 0.1, 0.5, 0.9, 0.99, 0.999 }, between[] = { 1.01, 1.2, 1.6, 1.999 };
    for (int k = 0; k < 6; k++) {
        const sp_scene s = stool(r1, r2, mu, below[k] * mu * r1);
        const sp_strong_result r = ask(&s, NULL);
        CHECK_INT(r.kind, k && !CASES ? SP_STRONG_ADMISSIBLE : SP_STRONG_STRONG);       /* its joints are points */
        CHECK_INT(r.reason, k ? CASES ? SP_STRONG_CASES : SP_STRONG_NOTHING_FOUND : SP_STRONG_PRESSURE);
    }
    for (int k = 0; k < 4; k++) {
        const sp_scene s = stool(r1, r2, mu, between[k] * mu * r1);
        CHECK_INT(ask(&s, &no_starts).kind, SP_STRONG_ADMISSIBLE);      /* there is no proof that nothing moves */
        const sp_strong_result r = ask(&s, NULL);
        CHECK_INT(r.kind, SP_STRONG_AMBIGUOUS);
        CHECK_INT(r.balls, 0);
        const double spin = (double)r.a[6 + 5], most = (between[k] - 1) * mu * r1 / J;
        CHECK(spin > 0 && spin <= most * (1 + TOL(1e-9, 1e-3)));
        CHECK(fabs(spin / most - 1) < TOL(1e-6, 1e-2));
    }
    const sp_scene s = stool(r1, r2, mu, 2.001 * mu * r1);
    CHECK_INT(ask(&s, NULL).kind, SP_STRONG_NONE);
}

/* A cube of weight 1 N between a wall and a jaw that force F presses on it; everything moves in the plane of x and z only. */
static sp_scene clamped(double mu, double F)
{
    const sp_capacity cap = { 3, 16, 12, 48, 2, 4, 1 };
    const sp_real wall[3] = { -9, 0, 0 }, right[3] = { 1, 0, 0 };
    const sp_real edge[2][6] = { { -1, 0, R(-0.5), -1, 0, R(0.5) }, { 1, 0, R(-0.5), 1, 0, R(0.5) } };
    const sp_strength rough = sp_strength_friction(R(mu));
    sp_load press;
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, wall, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const sp_real a = R(k ? 1 : -1), b = R(k ? 3 : 1);
        const sp_real corner[24] = { a, -1, -1, b, -1, -1, b, 1, -1, a, 1, -1, a, -1, 1, b, -1, 1, b, 1, 1, a, 1, 1 };
        const sp_mesh cube = { 8, 6, corner, box_size, box_face };
        const uint32_t held = k ? 62 : 42;              /* free: the jaw along x; the cube along x, z, to turn about y */
        CHECK_INT(sp_scene_block(&s, &cube, R(1 / 9.80665 / 8), held, NULL), SP_OK);
    }
    CHECK_INT(sp_scene_points(&s, 0, 1, right, 2, edge[0], &rough, NULL), SP_OK);
    CHECK_INT(sp_scene_points(&s, 1, 2, right, 2, edge[1], &rough, NULL), SP_OK);
    memset(&press, 0, sizeof press);
    press.block = 2;
    press.point[0] = 2;
    press.force[0] = R(-F);
    CHECK_INT(sp_scene_load(&s, &press, NULL), SP_OK);
    return s;
}

/* W <= 2 mu F; in the plane no joint spins, so this is no matter of corners. */
TEST(a_block_under_a_loaded_jaw_is_strong_as_long_as_it_is_held)
{
    static const double part[] = { 0.3, 0.9, 0.99, 0.999, 0.9999 };
    for (int k = 0; k < 5; k++) {
        const sp_scene s = clamped(0.4, 1 / (2 * 0.4 * part[k]));
        const sp_strong_result r = ask(&s, NULL);
        CHECK_INT(r.kind, TOL(SP_STRONG_STRONG, SP_STRONG_ADMISSIBLE));
        CHECK_INT(r.plate, CASES);
    }
    const sp_scene s = clamped(0.4, 1 / (2 * 0.4 * TOL(1.000001, 1.001)));
    CHECK_INT(ask(&s, NULL).kind, SP_STRONG_NONE);
}

/* Of half edge 1. */
static const sp_real cube_corner[24] = { -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1 };
static const sp_mesh cube = { 8, 6, cube_corner, box_size, box_face };

/* A cube between five supports, below and at its sides, that it touches at 3 to 8 points; pushed and turned at random. */
static sp_scene wedged(void)
{
    const sp_capacity cap = { 2, 8, 6, 24, 8, 8, 1 };
    const sp_real ground[3] = { 0, 0, -9 };
    const sp_strength rough = sp_strength_friction(test_random_real(0.1, 1.2));
    const int32_t points = test_random_int(3, 8);
    sp_load push;
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_block(&s, &cube, R(0.1 / 8), 0, NULL), SP_OK);
    for (int32_t k = 0; k < points; k++) {
        const int32_t axis = k < 3 ? 2 : test_random_int(0, 2), side = axis < 2 && test_random_int(0, 1);
        sp_real at[3], n[3] = { 0, 0, 0 };
        for (int i = 0; i < 3; i++) at[i] = test_random_real(-1, 1);
        at[axis] = side ? R(1) : R(-1);
        n[axis] = -at[axis];
        CHECK_INT(sp_scene_points(&s, 0, 1, n, 1, at, &rough, NULL), SP_OK);
    }
    memset(&push, 0, sizeof push);
    push.block = 1;
    for (int i = 0; i < 3; i++) {
        push.force[i] = test_random_real(-0.3, 0.3);
        push.couple[i] = test_random_real(-0.2, 0.2);
    }
    CHECK_INT(sp_scene_load(&s, &push, NULL), SP_OK);
    return s;
}

/* The proof by cases and the search for a motion know nothing of each other; every set of corners is a start. */
TEST(no_start_moves_what_cases_prove_strong)
{
    const sp_strong_settings no_starts = { 0, 0 };
    int strong = 0, ambiguous = 0, stands = 0;
    for (int k = 0; k < SOME_OF(500, 40); k++) {
        const sp_scene s = wedged();
        const size_t mark = test_arena.used;
        const sp_strong_result proved = ask(&s, &no_starts);
        const int by_cases = proved.reason == SP_STRONG_CASES;
        stands += proved.kind != SP_STRONG_NONE;
        strong += by_cases;
        test_arena.used = mark;
        const sp_strong_result found = ask(&s, NULL);
        ambiguous += found.kind == SP_STRONG_AMBIGUOUS;
        CHECK(!(by_cases && found.kind == SP_STRONG_AMBIGUOUS));
        CHECK(proved.kind != SP_STRONG_AMBIGUOUS);
    }
    CHECK(stands > 5 && ambiguous > 0 && (strong > 5 || !CASES));
}

/* The stool that spins, and a block that rests on a slope nearby: its laws are not asked along a slip that is rounding. */
TEST(what_rests_does_not_hide_what_moves_beside_it)
{
    const sp_real up[3] = { 0, 0, 1 }, slope[3] = { R(0.3), R(0.1), 1 };
    for (int beside = 0; beside < 3; beside++) {
        sp_scene s = stool(1, 2, 0.5, 0.75);
        for (int b = 0; b < beside; b++) rest_beside(&s, b ? up : slope);
        const sp_strong_result r = ask(&s, NULL);
        CHECK_INT(r.kind, SP_STRONG_AMBIGUOUS);
        CHECK(r.moves > R(0.1));
        for (int k = 12; k < 6 * (2 + beside); k++) CHECK(fabs((double)r.a[k]) < TOL(1e-12, 1e-5));
    }
}

/* A cube of mass .1 kg on three points of a floor, with a fourth at its side: strong at mu .5, and ambiguous at 1. */
TEST(more_friction_may_let_go_what_less_holds)
{
    static const double at[4][3] = { { 0.87, -0.409, -1 }, { 0.982, -0.188, -1 }, { -0.901, -0.028, -1 }, { 1, 0.068, 0.39 } };
    static const double push[3] = { -0.0861, -0.2542, 0.2516 }, turn[3] = { -0.0817, 0.1218, -0.1638 };
    for (int more = 0; more < 2; more++) {
        const sp_capacity cap = { 2, 8, 6, 24, 4, 4, 1 };
        const sp_real ground[3] = { 0, 0, -9 };
        const sp_strength rough = sp_strength_friction(more ? R(1) : R(0.5));
        sp_load load;
        sp_scene s;
        test_arena.used = 0;
        memset(&load, 0, sizeof load);
        CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
        CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_block(&s, &cube, R(0.1 / 8), 0, NULL), SP_OK);
        for (int k = 0; k < 4; k++) {
            const sp_real point[3] = { R(at[k][0]), R(at[k][1]), R(at[k][2]) }, n[3] = { k < 3 ? 0 : -1, 0, k < 3 ? 1 : 0 };
            CHECK_INT(sp_scene_points(&s, 0, 1, n, 1, point, &rough, NULL), SP_OK);
        }
        load.block = 1;
        for (int i = 0; i < 3; i++) { load.force[i] = R(push[i]); load.couple[i] = R(turn[i]); }
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        const sp_strong_result r = ask(&s, NULL);
        CHECK_INT(r.kind, more ? SP_STRONG_AMBIGUOUS : CASES ? SP_STRONG_STRONG : SP_STRONG_ADMISSIBLE);
        if (more) CHECK(r.moves > R(0.05));
    }
}

TEST(evidence_that_is_changed_proves_less)
{
    sp_strong_kind proved;
    sp_scene s = stool(0.3, 0.6, 0.5, 0.2);
    sp_strong_result r = ask(&s, NULL);
    CHECK_INT(r.kind, SP_STRONG_AMBIGUOUS);
    r.a[6 + 5] *= R(1.1);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK_INT(proved, SP_STRONG_ADMISSIBLE);
    r.a[6 + 5] /= R(1.1);
    for (int k = 0; k < 12; k++) if (k % 3) r.moving[k] = -r.moving[k];
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK_INT(proved, SP_STRONG_ADMISSIBLE);
    memset(r.moving, 0, 12 * sizeof *r.moving);
    memset(r.a, 0, 12 * sizeof *r.a);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK_INT(proved, SP_STRONG_ADMISSIBLE);
    r.f[0] *= R(1.5);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK_INT(proved, SP_STRONG_NONE);
    s = stool(0.3, 0.6, 0.5, 0);
    r = ask(&s, NULL);
    CHECK_INT(r.kind, SP_STRONG_STRONG);
    r.f[3] += R(0.01);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK_INT(proved, SP_STRONG_NONE);
}

/* No multiplier may be of the wrong sign, no case left out, none closed by another's multipliers, no load of another size. */
TEST(a_proof_that_is_changed_proves_nothing)
{
    sp_strong_kind proved;
    sp_scene s = stool(0.3, 0.6, 0.5, 0.1);
    sp_strong_result r = ask(&s, NULL);
    if (!CASES) return;
    CHECK_INT(r.reason, SP_STRONG_CASES);
    for (int k = 0; k < 6; k++) {
        sp_strong_result x = r;
        const int32_t middle = r.proof.entries / 2;
        const sp_real y = r.proof.y[middle];
        if (k == 0) x.proof.y[middle] = -y;
        if (k == 1) x.proof.nodes--;
        if (k == 2) x.proof.row[middle] = (uint16_t)(r.proof.row[middle] + 1);
        if (k == 3) x.proof.entries--;
        if (k == 4) x.proof.y[middle] = y * 2;
        if (k == 5) s.load[0].couple[2] *= R(1.6);      /* beyond mu W r1 */
        CHECK_INT(sp_strong_verify(&s, NULL, &x, test_arena, &proved), SP_OK);
        CHECK(proved == SP_STRONG_ADMISSIBLE || (k == 5 && proved == SP_STRONG_NONE));
        r.proof.y[middle] = y;
        if (k == 2) r.proof.row[middle]--;
    }
}

/* What rests, standing still, is no motion: (f, 0) meets every law. */
TEST(forces_at_rest_are_no_motion)
{
    sp_strong_kind proved;
    const sp_scene s = stool(0.3, 0.6, 0.5, 0.2);
    sp_strong_result r = ask(&s, NULL);
    memcpy(r.moving, r.f, 12 * sizeof *r.f);
    memset(r.a, 0, 12 * sizeof *r.a);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_OK);
    CHECK_INT(proved, SP_STRONG_ADMISSIBLE);
}

/* Turned, moved, in other units, in another order, from the other side, loads that count c times. */
TEST(answers_do_not_depend_on_how_the_scene_is_written)
{
    static const struct { const char *name, *param; double value; sp_strong_kind kind; } scene[] = {
        { "h-model", "mu", 0.6, SP_STRONG_AMBIGUOUS }, { "wall", "rows", 2, SP_STRONG_STRONG },
        { "incline", "angle", 20, TOL(SP_STRONG_STRONG, SP_STRONG_ADMISSIBLE) }, { "tower", "n", 4, SP_STRONG_STRONG } };
    for (int k = 0; k < 4; k++)
        for (int round = 0; round < SOME_OF(20, 4); round++) {
            sp_scene s, t;
            int32_t place[MOST], name[MOST];
            change c = none();
            test_arena.used = 0;
            CHECK_INT(gen_make(scene[k].name, scene[k].param, scene[k].value, &test_arena, &s), SP_OK);
            any_turn(&c);
            c.scale = round % 2 ? 100 : 0.1;
            c.gravity = round % 3 ? 1 : 7;
            c.permute = c.turn = c.swap = 1;
            copy(&s, &c, &t, place, name);
            CHECK_INT(ask(&t, NULL).kind, scene[k].kind);
        }
}

TEST(what_does_not_stand_is_never_strong)
{
    static const char *const name[] = { "topple", "tower", "overhang", "cantilever", "inverted-triangle", "two-cubes" };
    static const char *const param[] = { "angle", "lean", "factor", "reach", "rows", "offset" };
    static const double value[] = { 15, 0.2, 1.1, 1.5, 4, 0.6 };
    for (int k = 0; k < 6; k++) {
        const sp_strong_result r = of(name[k], param[k], value[k]);
        CHECK_INT(r.kind, SP_STRONG_NONE);
        CHECK_INT(r.reason, SP_STRONG_NO_FORCES);
    }
}

/* Strength may break: what needs none of it is strong, of the rest nothing is said. */
TEST(strength_of_joints_proves_nothing_and_hinders_no_proof)
{
    for (int k = 0; k < 2; k++) {
        sp_scene s;
        test_arena.used = 0;
        CHECK_INT(gen_make(k ? "h-model" : "two-cubes", NULL, 0, &test_arena, &s), SP_OK);
        for (int32_t i = 0; i < s.count.joints; i++) s.joint[i].strength.cohesion = R(1e6);
        const sp_strong_result r = ask(&s, NULL);
        CHECK_INT(r.kind, k ? SP_STRONG_ADMISSIBLE : SP_STRONG_STRONG);
        CHECK_INT(r.reason, k ? SP_STRONG_NOT_ASKED : SP_STRONG_PRESSURE);
    }
}

/* A weight on a support turns with nothing; one on a stone turns with it or not: no motion is sought. Neither is one of a body
 * that has no extent. */
TEST(motions_are_sought_only_where_masses_and_inertias_are_known)
{
    for (int k = 0; k < 4; k++) {
        const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 1 };
        const sp_strength rough = sp_strength_friction(R(0.5));
        const sp_real ground[3] = { 0, 0, 0 }, at[3] = { 0, 0, R(k == 3 ? 1 : 2) }, slope[3] = { R(-0.2), 0, 1 };
        const sp_real foot[12] = { R(k == 3 ? 0 : -1), -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1 }, mid[3] = { 0, 0, 1 };
        sp_load load;
        sp_scene s;
        test_arena.used = 0;
        CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
        CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, 5, at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_points(&s, 0, 1, slope, k == 3 ? 1 : 4, k == 3 ? mid : foot, &rough, NULL), SP_OK);
        memset(&load, 0, sizeof load);
        load.block = k == 1;
        load.mass = 3;
        if (k < 2) CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        const sp_strong_result r = ask(&s, NULL);
        if (k == 1 || k == 3) CHECK_INT(r.reason, SP_STRONG_NOT_ASKED);
        else CHECK(r.kind != SP_STRONG_NONE && r.reason != SP_STRONG_NOT_ASKED);
        CHECK_INT(r.balls, k == 1 || k == 3 ? 0 : 1);
    }
}

/* Forces that squeeze sideways prove nothing by pressure, those without friction do; loads that overflow are told. */
TEST(pressure_is_taken_from_the_forces_that_have_no_friction)
{
    sp_scene s;
    sp_result x;
    sp_strong_result r;
    test_arena.used = 0;
    CHECK_INT(gen_make("two-cubes", "offset", 0, &test_arena, &s), SP_OK);
    CHECK_INT(sp_check(&s, NULL, &test_arena, &x), SP_OK);
    sp_real *tilted = (sp_real *)(void *)(test_arena.base + (test_arena.used + 63) / 64 * 64);
    test_arena.used += 64 + 12 * sizeof *tilted;
    for (int k = 0; k < 12; k++) tilted[k] = x.f[k];
    tilted[0] *= 2;                                     /* out of balance */
    for (int k = 0; k < 2; k++) {
        sp_arena a = test_arena;
        CHECK_INT(sp_strong(&s, NULL, NULL, tilted, k ? x.f : NULL, &a, &r), SP_OK);
        CHECK_INT(r.kind, k ? SP_STRONG_STRONG : SP_STRONG_NONE);
        CHECK_INT(sp_strong(&s, NULL, NULL, tilted, tilted, &a, &r), SP_OK);
        CHECK_INT(r.kind, SP_STRONG_NONE);
    }
    s.gravity[2] = R(TOL(1e306, 1e36));
    sp_strong_kind proved = SP_STRONG_AMBIGUOUS;
    CHECK_INT(sp_strong(&s, NULL, NULL, x.f, NULL, &test_arena, &r), SP_E_NOT_FINITE);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_E_NOT_FINITE);
    CHECK_INT(proved, SP_STRONG_AMBIGUOUS);
}

TEST(strong_takes_the_memory_it_says_and_no_byte_less)
{
    static const char *const name[] = { "h-model", "wall", "incline" };
    static const int64_t budget[] = { 200000000, 0, 1000000 };      /* two blocks on eight corners: 21 MB where there is none */
    for (int k = 0; k < 3; k++) {
        sp_settings set = sp_settings_default();
        sp_scene s;
        sp_result x;
        sp_strong_result r;
        size_t bytes = 0;
        test_arena.used = 0;
        set.budget = budget[k];
        CHECK_INT(gen_make(name[k], NULL, 0, &test_arena, &s), SP_OK);
        CHECK_INT(sp_check(&s, NULL, &test_arena, &x), SP_OK);
        CHECK_INT(sp_memory(&s, SP_FOR_STRONG, &set, test_arena, &bytes), SP_OK);
        sp_arena a = test_arena;
        a.used = (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        a.base += a.used;
        a.used = a.peak = 0;
        a.capacity = bytes - 1;
        CHECK_INT(sp_strong(&s, &set, NULL, x.f, NULL, &a, &r), SP_E_MEMORY);
        a.capacity = bytes;
        CHECK_INT(sp_strong(&s, &set, NULL, x.f, NULL, &a, &r), SP_OK);
        CHECK(a.peak == bytes && r.peak_bytes == bytes);
        const size_t kept = (bytes + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        CHECK_INT(sp_memory(&s, SP_FOR_STRONG_VERIFY, NULL, test_arena, &bytes), SP_OK);
        a.base += kept;                                 /* behind the claim */
        a.used = a.peak = 0;
        a.capacity = bytes - 1;
        sp_strong_kind proved;
        CHECK_INT(sp_strong_verify(&s, NULL, &r, a, &proved), SP_E_MEMORY);
        a.used = 0;
        a.capacity = bytes;
        CHECK_INT(sp_strong_verify(&s, NULL, &r, a, &proved), SP_OK);
    }
}

/* A proof by cases has room for what the budget has work for, and for no more. */
TEST(a_lesser_budget_takes_less_memory)
{
    static const int64_t budget[] = { 1000000, 10000000, 100000000, 0 };
    size_t last = 0;
    for (int k = 0; k < 4; k++) {
        sp_settings set = sp_settings_default();
        sp_scene s;
        size_t bytes = 0;
        test_arena.used = 0;
        set.budget = budget[k];
        CHECK_INT(gen_make("tower", "n", 2, &test_arena, &s), SP_OK);
        CHECK_INT(sp_memory(&s, SP_FOR_STRONG, &set, test_arena, &bytes), SP_OK);
        CHECK(CASES ? bytes > last : bytes >= last);
        last = bytes;
    }
    CHECK(last < 32000000);
}

TEST(questions_that_make_no_sense_are_refused)
{
    const sp_strong_settings fewer[3] = { { -1, 0 }, { 4, -1 }, { 4, 2 } }, no_starts = { 0, 0 };
    const sp_scene s = stool(0.3, 0.6, 0.5, 0.2);
    sp_strong_kind proved;
    sp_strong_result r = ask(&s, &no_starts), x;
    sp_settings set = sp_settings_default();
    CHECK(r.kind == SP_STRONG_ADMISSIBLE && r.starts == 0);             /* neither is there a proof */
    for (int k = 0; k < 3; k++) CHECK_INT(sp_strong(&s, NULL, &fewer[k], r.f, NULL, &test_arena, &x), SP_E_RANGE);
    CHECK_INT(sp_strong(NULL, NULL, NULL, r.f, NULL, &test_arena, &x), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, NULL, NULL, &test_arena, &x), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, r.f, NULL, &test_arena, NULL), SP_E_ARGUMENT);
    set.faces = 8;
    CHECK_INT(sp_strong(&s, &set, NULL, r.f, NULL, &test_arena, &x), SP_E_UNSUPPORTED);
    set.tol = -1;
    CHECK_INT(sp_strong(&s, &set, NULL, r.f, NULL, &test_arena, &x), SP_E_RANGE);
    r.a[0] = R(1e300) * R(1e300);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, &proved), SP_E_NOT_FINITE);
    r.f[0] = r.a[0];
    CHECK_INT(sp_strong(&s, NULL, NULL, r.f, NULL, &test_arena, &x), SP_E_NOT_FINITE);
}

#endif

TEST_LIST(strong)
#ifndef SP_NO_STRONG
    RUN(what_pressure_alone_holds_is_strong)
    RUN(a_beam_held_by_squeezing_alone_is_ambiguous_whatever_the_friction)
    RUN(level_walls_stacks_and_a_trilithon_are_strong)
    RUN(a_keystone_is_strong_where_it_narrows_downward_and_never_else)
    RUN(a_slope_is_decided_to_a_millionth_in_the_plane_and_in_space)
    RUN(a_plate_on_its_corners_holds_what_moves_with_the_middles_of_its_edges_too)
    RUN(splitting_an_edge_never_changes_the_answer_of_a_plate)
    RUN(a_plate_spins_beside_what_rests_on_single_points)
    RUN(friction_at_the_centre_of_pressure_is_judged_as_one_force)
    RUN(a_block_on_a_slope_below_its_friction_is_strong)
    RUN(stacks_on_a_slope_are_strong_until_they_tip)
    RUN(even_friction_is_no_proof_around_a_loop_or_with_torsion)
    RUN(joints_of_the_same_two_blocks_count_as_one_where_they_lie_in_a_plane)
    RUN(a_stool_with_a_cross_for_feet_is_ambiguous_from_the_lesser_torque_on_and_spins_the_most_it_can)
    RUN(a_block_under_a_loaded_jaw_is_strong_as_long_as_it_is_held)
    RUN(no_start_moves_what_cases_prove_strong)
    RUN(what_rests_does_not_hide_what_moves_beside_it)
    RUN(more_friction_may_let_go_what_less_holds)
    RUN(evidence_that_is_changed_proves_less)
    RUN(a_proof_that_is_changed_proves_nothing)
    RUN(forces_at_rest_are_no_motion)
    RUN(answers_do_not_depend_on_how_the_scene_is_written)
    RUN(what_does_not_stand_is_never_strong)
    RUN(strength_of_joints_proves_nothing_and_hinders_no_proof)
    RUN(motions_are_sought_only_where_masses_and_inertias_are_known)
    RUN(pressure_is_taken_from_the_forces_that_have_no_friction)
    RUN(strong_takes_the_memory_it_says_and_no_byte_less)
    RUN(a_lesser_budget_takes_less_memory)
    RUN(questions_that_make_no_sense_are_refused)
#endif
TEST_END
