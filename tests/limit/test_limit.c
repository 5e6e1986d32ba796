/* How far from falling: multipliers known by hand or printed, both ends of the bracket, what is not a number, what is refused. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>
#include <string.h>

#define NEAR TOL(1e-6, 2e-3)            /* relative accuracy of a multiplier */
#define LOWEST (10 * NEAR)              /* and of the least one: no forces are sought nearer than the mechanism's balance and some tol */

static const double weight = 2400 * 9.80665;            /* of the cube of 1 m */

/* A limit both ends of which are held by sp_limit_verify, and by sp_verify of the scene with that multiple of its live loads. */
static sp_limit_result limit_of(const sp_scene *scene, const sp_settings *settings)
{
    sp_limit_result x;
    sp_evidence e;
    sp_result claim;
    sp_scene s = *scene;
    int32_t held = 0;
    memset(&x, 0, sizeof x);
    memset(&claim, 0, sizeof claim);
    CHECK_INT(sp_limit(scene, settings, &test_arena, &x), SP_OK);
    if (x.kind == SP_LIMIT_UNDECIDED || !x.f) return x;
    CHECK(x.verified);
    CHECK_INT(sp_limit_verify(scene, settings, &x, test_arena, &held), SP_OK);
    CHECK_INT(held, 1);
    claim.f = x.f;
    claim.dq = x.dq;
    if (x.lower >= 0) {
        s.live = x.lower;
        CHECK_INT(sp_verify(&s, settings, &claim, test_arena, &e), SP_OK);
        CHECK_INT(e.verdict, SP_STABLE);
    }
    if (x.upper >= 0) {
        memset(x.ray, 0, 3 * (size_t)s.count.points * sizeof *x.ray);
        claim.f = x.ray;                                /* forces that prove nothing */
        s.live = x.upper;
        CHECK_INT(sp_verify(&s, settings, &claim, test_arena, &e), SP_OK);
        CHECK_INT(e.verdict, SP_UNSTABLE);
    }
    return x;
}

/* What sp_check says with so many live loads. */
static sp_verdict verdict_at(sp_scene s, const sp_settings *set, double lambda)
{
    sp_arena a = test_arena;
    sp_result r;
    s.live = R(lambda);
    CHECK_INT(sp_check(&s, set, &a, &r), SP_OK);
    return r.verdict;
}

#ifdef SP_NO_PLAN
enum { PLANS = 0 };
#else
enum { PLANS = 1 };
#endif

static void found(const sp_scene *s, const sp_settings *set, double multiplier)
{
    const sp_limit_result x = limit_of(s, set);
    CHECK_INT(x.kind, SP_LIMIT_FOUND);
    CHECK_NEAR(x.multiplier, multiplier, NEAR);
    CHECK(x.lower <= x.multiplier && x.multiplier <= x.upper);
}

/* A cube on the ground, z = 0. */
static sp_scene cube(sp_strength strength)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 4 };
    const sp_real foot[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
    const sp_real middle[3] = { R(0.5), R(0.5), R(0.5) }, ground[3] = { 0, 0, R(-5) };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, R(2400), middle, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &strength, NULL), SP_OK);
    return s;
}

static void push(sp_scene *s, int live, double fx, double fy, double fz, double x, double y, double z)
{
    const sp_load load = { 1, live, { R(x), R(y), R(z) }, { R(fx), R(fy), R(fz) }, { 0, 0, 0 }, 0 };
    CHECK_INT(sp_scene_load(s, &load, NULL), SP_OK);
}

/* Gravity of a slope that rises towards -x: the cube is pulled along x. */
static void slope(sp_scene *s, double angle)
{
    s->gravity[0] = R(9.80665 * sin(angle));
    s->gravity[2] = R(-9.80665 * cos(angle));
}

/* ---------------------------------------------------------------------------------------------------------- closed forms */

TEST(a_push_slides_at_mu_or_topples_at_half_the_width_over_its_height)
{
    for (int k = 0; k < 6; k++) {
        const double mu = 0.1 + 0.2 * k, h = 0.25 + 0.25 * k;
        sp_scene s = cube(sp_strength_friction(R(mu)));
        push(&s, 1, weight, 0, 0, 0, 0.5, h);
        found(&s, NULL, mu < 0.5 / h ? mu : 0.5 / h);
    }
}

TEST(on_a_slope_a_push_along_it_has_what_friction_leaves)
{
    for (int up = 0; up < 2; up++) {
        sp_scene s = cube(sp_strength_friction(R(0.6)));
        slope(&s, 0.3);
        push(&s, 1, up ? -weight : weight, 0, 0, 0, 0.5, 0);
        found(&s, NULL, 0.6 * cos(0.3) + (up ? 1 : -1) * sin(0.3));
    }
}

TEST(what_slides_on_its_own_may_be_held_by_the_live_load)
{
    sp_scene s = cube(sp_strength_friction(R(0.2)));
    slope(&s, 0.3);                                     /* tan .3 = .309 > .2: zero does not work, from .104 to .487 does */
    push(&s, 1, -weight, 0, 0, 0, 0.5, 0);
    found(&s, NULL, sin(0.3) + 0.2 * cos(0.3));
}

TEST(without_friction_one_multiple_works_and_no_other)
{
    sp_scene s = cube(sp_strength_friction(0));
    slope(&s, 0.3);
    s.body[0] = R(-9.80665 * cos(0.3));
    s.body[2] = R(-9.80665 * sin(0.3));
    found(&s, NULL, tan(0.3));
}

TEST(a_gripper_over_the_edge_topples_by_the_lever)
{
    for (int k = 1; k <= 4; k++) {
        sp_scene s = cube(sp_strength_friction(R(0.84)));
        sp_load load = { 1, 1, { R(1 + 0.3 * k), R(0.5), 1 }, { 0, 0, 0 }, { 0, 0, 0 }, R(100) };
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        found(&s, NULL, 2400 * 0.5 / (0.3 * k * 100));
    }
}

TEST(a_couple_topples_at_weight_times_half_the_width)
{
    sp_scene s = cube(sp_strength_friction(R(0.84)));
    sp_load load = { 1, 1, { 0, 0, 0 }, { 0, 0, 0 }, { 0, R(3 * weight), 0 }, 0 };
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    found(&s, NULL, 1. / 6);
}

TEST(every_cone_slides_at_its_own_coefficient)
{
    for (int32_t faces = 0; faces <= (TEST_SMALL ? 0 : 16); faces += 4)
        for (int32_t inscribed = 0; inscribed < 2; inscribed++) {
            sp_settings set = sp_settings_default();
            sp_scene s = cube(sp_strength_friction(R(0.4)));
            set.faces = faces;
            set.inscribed = inscribed;
            push(&s, 1, weight, 0, 0, 0, 0.5, 0);       /* along t1, the first face */
            found(&s, &set, 0.4 * (faces && inscribed ? cos(3.14159265358979 / faces) : 1));
        }
}

TEST(glue_and_crushing_have_their_closed_forms)
{
    const sp_strength glue = { R(0.5), R(5000), R(700), 0 }, soft = { R(0.84), 0, 0, R(1.6 * weight) };
    for (int32_t faces = 0; faces <= 8; faces += 4) {
        sp_settings set = sp_settings_default();
        set.faces = faces;
        sp_scene s = cube(glue);
        push(&s, 1, 0, 0, 100, 0.5, 0.5, 1);            /* lifted: weight and tension */
        found(&s, &set, (weight + 700) / 100);
        s = cube(glue);
        push(&s, 1, weight, 0, 0, 0, 0.5, 0);           /* slides: friction and cohesion, of a pyramid cos(pi/K) of both */
        found(&s, &set, (0.5 + 5000 / weight) * (faces ? cos(3.14159265358979 / faces) : 1));
        s = cube(soft);
        push(&s, 1, weight, 0, 0, 0, 0.5, 1);           /* W (1/2 + lambda) on two corners of cap / 4 each */
        found(&s, &set, 0.3);
    }
}

/* Pressed down, glue makes no difference: nothing ends that but a cap. A slope steeper than friction bears what presses and pulls by
 * its glue only, so that has an end again: |ft| = lambda W sin = mu lambda W cos + c A. */
TEST(a_load_that_presses_on_glue_has_no_end_but_a_cap)
{
    for (int k = 0; k < 6; k++) {
        const sp_strength glue = { R(0.5), R(1e3 * pow(10, k % 3)), k < 3 ? 0 : R(500), 0 };
        const double cap = 1.6 * weight;
        sp_strength soft = glue;
        soft.crushing = R(cap);
        sp_scene s = cube(glue);
        push(&s, 1, 0, 0, -weight, 0.5, 0.5, 1);
        const sp_limit_result x = limit_of(&s, NULL);
        CHECK_INT(x.kind, SP_LIMIT_UNBOUNDED);
        CHECK_WITHIN((double)(x.ray[0] + x.ray[3] + x.ray[6] + x.ray[9]) / weight, 1, TOL(1e-9, 1e-4));
        CHECK_INT(x.dead, SP_STABLE);
        s = cube(soft);
        push(&s, 1, 0, 0, -weight, 0.5, 0.5, 1);
        found(&s, NULL, 0.6);
        s = cube(glue);
        push(&s, 1, weight, 0, -weight, 0.5, 0.5, 0);   /* (lambda W - c A) = mu (1 + lambda) W */
        found(&s, NULL, ((double)glue.cohesion / weight + 0.5) / (1 - 0.5));
    }
}

/* What forces without end may be added is a cone of its own: a claim with forces that only strength carries is not held. */
TEST(a_ray_is_without_strength)
{
    const sp_strength glue = { R(0.5), R(1e6), R(1e6), 0 };
    sp_scene s = cube(glue);
    int32_t held = 1;
    push(&s, 1, 0, 0, weight, 0.5, 0.5, 1);             /* lifted: by glue, to an end */
    sp_limit_result x = limit_of(&s, NULL);
    CHECK_INT(x.kind, SP_LIMIT_FOUND);
    CHECK_NEAR(x.multiplier, (1e6 + weight) / weight, NEAR);
    for (int k = 0; k < 12; k++) x.ray[k] = k % 3 ? 0 : R(-weight / 4);
    x.kind = SP_LIMIT_UNBOUNDED;
    CHECK_INT(sp_limit_verify(&s, NULL, &x, test_arena, &held), SP_OK);
    CHECK_INT(held, 0);
}

TEST(what_stands_only_with_its_live_load_is_told)
{
    sp_scene s = cube(sp_strength_friction(R(0.2)));
    slope(&s, 0.3);                                     /* held up the slope from .104 to .487 */
    push(&s, 1, -weight, 0, 0, 0, 0.5, 0);
    sp_limit_result x = limit_of(&s, NULL);
    CHECK_INT(x.kind, SP_LIMIT_FOUND);
    CHECK_INT(x.dead, SP_UNSTABLE);
    CHECK_NEAR(x.lowest, sin(0.3) - 0.2 * cos(0.3), LOWEST);
    s = cube(sp_strength_friction(R(0.2)));
    slope(&s, 0.3);                                     /* pressed on: without end */
    push(&s, 1, 0, 0, -weight, 0.5, 0.5, 0);
    x = limit_of(&s, NULL);
    CHECK_INT(x.kind, SP_LIMIT_UNBOUNDED);
    CHECK_INT(x.dead, SP_UNSTABLE);
    CHECK_NEAR(x.lower, x.lowest, TOL(1e-12, 1e-6));    /* and every multiple beyond */
    if (!TEST_SMALL) CHECK_NEAR(x.lowest, (sin(0.3) - 0.2 * cos(0.3)) / 0.2, LOWEST);
    s = cube(sp_strength_friction(0));
    slope(&s, 0.3);                                     /* without friction: at one multiple only */
    push(&s, 1, -weight, 0, 0, 0, 0.5, 0);
    x = limit_of(&s, NULL);
    CHECK_INT(x.dead, SP_UNSTABLE);
    CHECK_NEAR(x.lowest, sin(0.3), LOWEST);
    s = cube(sp_strength_friction(R(0.5)));
    push(&s, 1, weight, 0, 0, 0, 0.5, 0);
    x = limit_of(&s, NULL);
    CHECK_INT(x.dead, SP_STABLE);
    CHECK(!(x.lowest < 0) && !(x.lowest > 0));
}

/* tol can't follow every friction: how far the multiplier may be off is told, and is little where friction is not. */
TEST(a_multiplier_is_told_no_nearer_than_tol_lets_it)
{
    for (int k = 0; k <= TOL(12, 5); k++) {
        const double mu = 0.5 * pow(10, -k);
        sp_scene s = cube(sp_strength_friction(R(mu)));
        push(&s, 1, weight, 0, 0, 0, 0.5, 0);
        const sp_limit_result x = limit_of(&s, NULL);
        CHECK_INT(x.kind, SP_LIMIT_FOUND);
        CHECK(fabs((double)x.multiplier - mu) <= (double)x.within * 1.001 + mu * TOL(1e-9, 1e-5));
        CHECK((double)x.within < TOL(3e-6, 0.3));
        CHECK(x.tol <= R(mu / 8) || x.tol <= 4 * SP_EPSILON);
    }
}

/* A cantilever of two cubes' length: the board's tail is held by a weight; pulled at its tip. */
TEST(glue_that_holds_a_hundred_times_the_weight_slides_where_it_should)
{
    const sp_strength glue = { R(0.5), R(1e6), 0, 0 };
    sp_scene s = cube(glue);
    push(&s, 1, 1000, 0, 0, 0, 0.5, 0);
    found(&s, NULL, (1e6 + 0.5 * weight) / 1000);
}

TEST(a_stone_held_from_turning_slides_or_is_lifted)
{
    for (int up = 0; up < 2; up++) {
        sp_scene s = cube(sp_strength_friction(R(0.84)));
        s.block[1].fixed = 56;
        push(&s, 1, up ? 0 : weight, 0, up ? weight : 0, 0.5, 0.5, 1);
        found(&s, NULL, up ? 1 : 0.84);
    }
}

TEST(a_cantilever_tips_when_its_tip_bears_more_than_its_tail)
{
    gen_scene g;
    sp_scene s;
    CHECK_INT(gen_open(&g, "overhang"), 1);
    CHECK_INT(gen_set(&g, "n", 1), 1);
    CHECK_INT(gen_set(&g, "factor", 0.5), 1);           /* one board of 1 m, a quarter of it over the edge */
    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
    const int32_t board = s.count.blocks - 1;
    const sp_real *c = s.block[board].centroid;
    sp_load tip = { board, 1, { c[0] + R(0.5), c[1], c[2] }, { 0, 0, s.block[board].mass * s.gravity[2] }, { 0, 0, 0 }, 0 };
    s.cap.loads = 1;
    s.load = &tip;
    s.count.loads = 1;
    found(&s, NULL, 0.25 / 0.25);                       /* W 1/4 on one side of the edge, lambda W 1/4 on the other */
}

/* -------------------------------------------------------------------------------------------------------- printed tables */

static double lateral(const char *name, const char *const *set, const double *value, double mu, const double direction[3])
{
    gen_scene g;
    sp_scene s;
    test_arena.used = 0;
    if (!CHECK_INT(gen_open(&g, name), 1)) return 0;
    for (int k = 0; set[k]; k++) CHECK_INT(gen_set(&g, set[k], value[k]), 1);
    CHECK_INT(gen_set(&g, "mu", mu), 1);
    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
    for (int k = 0; k < 3; k++) s.body[k] = R(9.80665 * direction[k]);
    const sp_limit_result x = limit_of(&s, NULL);
    CHECK_INT(x.kind, SP_LIMIT_FOUND);
    return (double)x.multiplier;
}

static const char *const wall_numbers[] = { "rows", "bricks", "length", "height", "depth", NULL };

/* Running bond of bricks 2 x 1 x 1, pushed along the wall. */
TEST(walls_in_their_plane_have_the_printed_multipliers)
{
    static const struct { double rows, bricks, mu, lambda; } table[] = {
        { 2, 2, 0.3, 0.3 }, { 2, 2, 0.5, 0.5 }, { 2, 2, 0.65, 0.65 }, { 2, 2, 0.84, 0.84 },
        { 4, 2, 0.3, 0.3 }, { 4, 2, 0.5, 0.5 }, { 4, 2, 0.65, 0.64155 }, { 4, 2, 0.84, 0.76034 },
        { 4, 4, 0.65, 0.64155 }, { 4, 4, 0.84, 0.76034 },
        { 6, 2, 0.5, 0.5 }, { 6, 2, 0.65, 0.56576 }, { 6, 2, 0.84, 0.63243 },
        { 6, 4, 0.65, 0.59758 }, { 6, 4, 0.84, 0.70268 }, { 8, 4, 0.65, 0.56637 }, { 8, 4, 0.84, 0.66165 },
    };
    static const double along[3] = { 1, 0, 0 };
    for (size_t k = 0; k < sizeof table / sizeof *table - (TEST_SMALL && TOL(0, 1)); k++) {     /* the last stays undecided there */
        const double value[5] = { table[k].rows, table[k].bricks, 2, 1, 1 };
        CHECK_WITHIN(lateral("wall", wall_numbers, value, table[k].mu, along), table[k].lambda, TOL(5.1e-6, 2e-3));
    }
}

TEST(walls_out_of_plane_overturn_at_depth_over_height)
{
    static const double across[3] = { 0, 1, 0 };
    for (int rows = 2; rows <= 8; rows += 2) {
        const double value[5] = { rows, 4, 2, 1, 1 };
        CHECK_NEAR(lateral("wall", wall_numbers, value, 0.84, across), 1. / rows, NEAR);
    }
}

/* A semicircular arch of 20 round voussoirs, mean radius 1: sectors of a ring, by their masses and centroids. */
static sp_scene round_arch(double t)
{
    const double pi = 3.14159265358979323846, ro = 1 + t / 2, ri = 1 - t / 2, half = pi / 40;
    const double mass = (ro * ro - ri * ri) * half, rc = 2. / 3 * (ro * ro * ro - ri * ri * ri) / (ro * ro - ri * ri) * sin(half) / half;
    const sp_capacity cap = { 21, 0, 0, 0, 21, 84, 0 };
    const sp_strength strength = sp_strength_friction(R(0.84));
    const sp_real ground[3] = { 0, 0, R(-1) };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 20; k++) {
        const double a = pi - (2 * k + 1) * half;
        const sp_real c[3] = { R(rc * cos(a)), R(0.5), R(rc * sin(a)) };
        CHECK_INT(sp_scene_body(&s, R(mass), c, 0, NULL), SP_OK);
    }
    for (int k = 0; k <= 20; k++) {                     /* joint k: from the voussoir before it into the one after */
        const double c = cos(pi - 2 * k * half), z = k == 0 || k == 20 ? 0 : sin(pi - 2 * k * half);
        const sp_real xyz[12] = { R(ri * c), 0, R(ri * z), R(ri * c), 1, R(ri * z), R(ro * c), 1, R(ro * z), R(ro * c), 0, R(ro * z) };
        CHECK_INT(sp_scene_joint(&s, k, k == 20 ? 0 : k + 1, 4, xyz, &strength, NULL), SP_OK);
    }
    return s;
}

TEST(arches_bear_the_printed_horizontal_acceleration)
{
    static const double table[3][2] = { { 0.12, 0.04819 }, { 0.15, 0.14888 }, { 0.20, 0.28520 } };
    for (int k = 0; k < 3; k++) {
        sp_scene s = round_arch(table[k][0]);
        s.body[0] = R(9.80665);
        const sp_limit_result x = limit_of(&s, NULL);
        CHECK_INT(x.kind, SP_LIMIT_FOUND);
        CHECK_WITHIN(x.multiplier, table[k][1], TOL(5.1e-6, 2e-3));
    }
}

TEST(an_arch_falls_by_four_hinges)
{
    sp_scene s = round_arch(0.15);
    s.body[0] = R(9.80665);
    const sp_limit_result x = limit_of(&s, NULL);
    int kind[4] = { 0, 0, 0, 0 };
    NEED(x.kind == SP_LIMIT_FOUND);
    for (int32_t i = 0; i < s.count.joints; i++) {
        sp_joint_motion m;
        CHECK_INT(sp_joint_moves(&s, x.dq, i, &m), SP_OK);
        kind[m.kind]++;
        if (m.kind != SP_JOINT_HINGE) continue;
        CHECK(m.opening > 0);                           /* about a line across the arch */
        CHECK_WITHIN(fabs((double)m.a[1] - (double)m.b[1]), 1, TOL(1e-9, 1e-5));
    }
#ifndef SP_REAL_FLOAT
    CHECK_INT(kind[SP_JOINT_HINGE], 4);
    CHECK_INT(kind[SP_JOINT_RIGID], 17);
#endif
}

TEST(what_slides_is_called_sliding)
{
    sp_scene s = cube(sp_strength_friction(R(0.3)));
    sp_joint_motion m;
    push(&s, 1, weight, 0, 0, 0, 0.5, 0);
    sp_limit_result x = limit_of(&s, NULL);
    NEED(x.kind == SP_LIMIT_FOUND);
    CHECK_INT(sp_joint_moves(&s, x.dq, 0, &m), SP_OK);
    CHECK_INT(m.kind, SP_JOINT_SLIDING);
    CHECK_NEAR(m.opening, 0.3 * (double)m.slip, TOL(1e-6, 1e-2));
    s = cube(sp_strength_friction(R(0.84)));
    push(&s, 1, 0, 0, 2 * weight, 0.5, 0.5, 1);
    x = limit_of(&s, NULL);
    CHECK_NEAR(x.multiplier, 0.5, NEAR);
    CHECK_INT(sp_joint_moves(&s, x.dq, 0, &m), SP_OK);
    CHECK_INT(m.kind, SP_JOINT_OPEN);
    CHECK_TEXT(sp_joint_text(m.kind), "open");
}

/* ------------------------------------------------------------------------------------------------------ none, unbounded */

TEST(what_falls_whatever_the_live_load_has_no_multiplier)
{
    sp_scene s = cube(sp_strength_friction(R(0.2)));
    slope(&s, 0.3);
    push(&s, 1, weight, 0, 0, 0, 0.5, 0);               /* pushes it down the slope */
    CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_NONE);
    s = cube(sp_strength_friction(R(0.2)));
    slope(&s, 0.3);
    push(&s, 1, 0, weight, 0, 0.5, 0.5, 0);             /* pushes it aside: in vain */
    CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_NONE);
    s = cube(sp_strength_friction(R(0.2)));
    s.count.joints = s.count.points = 0;            /* touches nothing */
    push(&s, 1, weight, 0, 0, 0, 0.5, 0);
    CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_NONE);
}

TEST(a_load_that_presses_has_no_end)
{
    sp_scene s = cube(sp_strength_friction(R(0.2)));
    push(&s, 1, 0.1 * weight, 0, -weight, 0.6, 0.5, 0.5);
    CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_UNBOUNDED);
    s = cube(sp_strength_friction(R(0.2)));
    slope(&s, 0.3);                                     /* it falls, unless pressed on: lambda (.2 - 0) > sin .3 - .2 cos .3 */
    push(&s, 1, 0, 0, -weight, 0.5, 0.5, 0);
    const sp_limit_result x = limit_of(&s, NULL);
    CHECK_INT(x.kind, SP_LIMIT_UNBOUNDED);
    CHECK((double)x.lower >= (sin(0.3) - 0.2 * cos(0.3)) / 0.2 * (1 - NEAR));
}

/* On each free stone in turn, alone: pressed at its middle, off it, at a slant, pushed aside, turned. The stones above bear nothing
 * of it, however much it is. */
TEST(a_load_on_any_stone_has_an_end_or_none)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "tower", "n", 2 }, { "tower", "n", 6 }, { "wall", "rows", 3 }, { "rubble", "rows", 3 }, { "diamond", "rows", 3 }
    };
    static const double force[5][3] = { { 0, 0, -1 }, { 0, 0, -1 }, { 0.2, 0.05, -1 }, { 1, 0, 0 }, { 0, 0, 0 } };
    int several[4] = { 0, 0, 0, 0 };
    for (size_t k = 0; k < sizeof scene / sizeof *scene; k++)
        for (int32_t i = 1, stones = 2; i < stones; i += SOME_OF(1, 3)) {
            for (int q = 0; q < 5; q++) {
                sp_load load;
                sp_scene s;
                test_arena.used = 0;
                CHECK_INT(gen_make(scene[k].name, scene[k].param, scene[k].value, &test_arena, &s), SP_OK);
                stones = s.count.blocks;
                const sp_block *b = &s.block[i];
                if (b->fixed == SP_FIXED) continue;
                memset(&load, 0, sizeof load);
                load.block = i;
                load.live = 1;
                for (int x = 0; x < 3; x++) {
                    load.force[x] = R(2000 * force[q][x]);
                    load.point[x] = b->centroid[x] + (q == 1 && x < 2 ? R(0.1) * b->diameter : 0);
                }
                load.couple[1] = q == 4 ? R(1000) : 0;
                s.load = &load;
                s.count.loads = s.cap.loads = 1;
                const sp_limit_result x = limit_of(&s, NULL);
                several[x.kind]++;
                if (x.kind == SP_LIMIT_UNDECIDED) TEST_PRINT("    %s %g, block %d, load %d\n", scene[k].name, scene[k].value, (int)i, q);
                for (double times = 1e3; x.kind == SP_LIMIT_UNBOUNDED && times < 1e7; times *= 1e3)
                    CHECK_INT(verdict_at(s, NULL, times), SP_STABLE);
            }
        }
    CHECK_INT(several[SP_LIMIT_UNDECIDED], 0);
    CHECK_INT(several[SP_LIMIT_NONE], 0);
    CHECK(several[SP_LIMIT_FOUND] > SOME_OF(100, 30) && several[SP_LIMIT_UNBOUNDED] > SOME_OF(100, 30));
}

/* Weight is taken away by the live load and then more: at 1 there is none, beyond that all that rests on something goes up; between
 * two supports it is wedged. Nothing else than 1 holds what slides and leans. */
TEST(a_load_that_lifts_everything_ends_at_its_weight)
{
    static const struct { const char *name, *param; double value, mu; sp_limit_kind kind; } scene[] = {
        { "wall", "rows", 3, 0.84, SP_LIMIT_FOUND }, { "tower", "n", 5, 0.84, SP_LIMIT_FOUND }, { "arch", "n", 8, 0.84, SP_LIMIT_FOUND },
        { "arch", "n", 8, 0, SP_LIMIT_FOUND }, { "diamond", "rows", 3, 0, SP_LIMIT_FOUND }, { "rubble", "rows", 2, 0, SP_LIMIT_FOUND },
        { "keystone", "angle", 20, 0, SP_LIMIT_UNBOUNDED }, { "keystone", "angle", 20, 0.1, SP_LIMIT_UNBOUNDED }
    };
    for (size_t k = 0; k < sizeof scene / sizeof *scene; k++) {
        sp_scene s;
        test_arena.used = 0;
        CHECK_INT(gen_make(scene[k].name, scene[k].param, scene[k].value, &test_arena, &s), SP_OK);
        for (int32_t i = 0; i < s.count.joints; i++) s.joint[i].strength.mu = R(scene[k].mu);
        s.body[2] = R(9.80665);
        const sp_limit_result x = limit_of(&s, NULL);
        if (!CHECK_INT(x.kind, scene[k].kind)) TEST_PRINT("    %s, mu %g\n", scene[k].name, scene[k].mu);
        if (x.kind == SP_LIMIT_FOUND) CHECK_NEAR(x.multiplier, 1, NEAR);
    }
}

/* A leaning tower too heavy for its stones: a push back would keep it from leaning, and not from being crushed. */
TEST(what_its_own_weight_crushes_has_no_multiplier)
{
    for (int back = 0; back < 2; back++) {
        sp_scene s;
        test_arena.used = 0;
        CHECK_INT(gen_make("tower", "lean", 0.08, &test_arena, &s), SP_OK);
        for (int32_t i = 0; i < s.count.joints; i++) s.joint[i].strength.crushing = R(20000);
        s.body[0] = R(back ? -9.80665 : 9.80665);
        CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_NONE);
    }
}

TEST(supports_alone_bear_any_load)
{
    sp_scene s = cube(sp_strength_friction(R(0.84)));
    s.block[1].fixed = SP_FIXED;
    push(&s, 1, weight, 0, 0, 0, 0.5, 1);
    CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_UNBOUNDED);
}

TEST(without_live_load_it_is_all_or_nothing)
{
    sp_scene s = cube(sp_strength_friction(R(0.2)));
    CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_UNBOUNDED);
    slope(&s, 0.3);
    CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_NONE);
}

TEST(a_live_load_on_a_support_changes_nothing)
{
    sp_scene s = cube(sp_strength_friction(R(0.2)));
    sp_load load = { 0, 1, { 0, 0, 0 }, { R(weight), 0, 0 }, { 0, 0, 0 }, 0 };
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    CHECK_INT(limit_of(&s, NULL).kind, SP_LIMIT_UNBOUNDED);
}

/* ------------------------------------------------------------------------------------------------------------ invariants */

/* The arch in other units of length and mass, and moved: the same multiplier. */
TEST(units_do_not_matter)
{
    for (int k = -1; k <= 1; k++)
        for (int q = -1; q <= 1; q++) {
            const double L = k < 0 ? 1e-3 : k ? 1e3 : 1, M = q < 0 ? 1e-4 : q ? 1e4 : 1;
            sp_scene s = round_arch(0.15);
            for (int32_t b = 0; b < s.count.blocks; b++) {
                s.block[b].mass *= R(M);
                for (int c = 0; c < 3; c++) s.block[b].centroid[c] *= R(L);
            }
            for (int32_t v = 0; v < s.count.points; v++) for (int c = 0; c < 3; c++) s.point[v][c] *= R(L);
            s.body[0] = R(9.80665);
            const sp_limit_result x = limit_of(&s, NULL);
            CHECK_INT(x.kind, SP_LIMIT_FOUND);
            CHECK_WITHIN(x.multiplier, 0.14888, TOL(5.1e-6, 2e-3));
        }
}

TEST(live_loads_twice_as_large_have_half_the_multiplier)
{
    for (int k = -6; k <= 6; k += 3) {
        sp_scene s = round_arch(0.15);
        s.body[0] = R(9.80665 * pow(10, k));
        const sp_limit_result x = limit_of(&s, NULL);
        CHECK_INT(x.kind, SP_LIMIT_FOUND);
        CHECK_NEAR((double)x.multiplier * pow(10, k), 0.14888, TOL(4e-5, 2e-2));
    }
}

/* Every joint turned round: B pushes A. */
TEST(which_side_is_called_a_does_not_matter)
{
    sp_scene s = round_arch(0.15), t = s;
    sp_joint joint[21];
    for (int k = 0; k < 21; k++) {
        joint[k] = s.joint[k];
        joint[k].a = s.joint[k].b;
        joint[k].b = s.joint[k].a;
        for (int c = 0; c < 3; c++) { joint[k].n[c] = -joint[k].n[c]; joint[k].t2[c] = -joint[k].t2[c]; }
    }
    s.body[0] = t.body[0] = R(9.80665);
    t.joint = joint;
    const double a = (double)limit_of(&s, NULL).multiplier, b = (double)limit_of(&t, NULL).multiplier;
    CHECK(a > 0.1);
    CHECK_NEAR(a, b, NEAR);
}

TEST(the_multiple_at_which_the_scene_stands_is_not_read)
{
    sp_scene s = cube(sp_strength_friction(R(0.3)));
    push(&s, 1, weight, 0, 0, 0, 0.5, 0);
    s.live = 77;
    const sp_limit_result x = limit_of(&s, NULL);
    CHECK_NEAR(x.multiplier, 0.3, NEAR);
}

/* ---------------------------------------------------------------------------------------------------------------- attack */

/* A pile of up to four blocks, each on the one before, shaken in a random direction; sometimes it does not stand at all. */
static sp_scene pile(void)
{
    const sp_capacity cap = { 6, 0, 0, 0, 6, 24, 0 };
    const sp_real ground[3] = { 0, 0, R(-1) };
    sp_scene s;
    double x = 0, y = 0, z = 0, w = 2, d = 2;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int32_t k = 0, n = test_random_int(1, 4); k < n; k++) {
        const double nw = (double)test_random_real(0.4, 1.2), nd = (double)test_random_real(0.4, 1.2), h = (double)test_random_real(0.2, 1);
        const double nx = x + (double)test_random_real(-0.4, 0.4), ny = y + (double)test_random_real(-0.4, 0.4);
        const double lx = fmax(x - w / 2, nx - nw / 2), hx = fmin(x + w / 2, nx + nw / 2);
        const double ly = fmax(y - d / 2, ny - nd / 2), hy = fmin(y + d / 2, ny + nd / 2);
        const sp_real c[3] = { R(nx), R(ny), R(z + h / 2) };
        const sp_real foot[12] = { R(lx), R(ly), R(z), R(hx), R(ly), R(z), R(hx), R(hy), R(z), R(lx), R(hy), R(z) };
        const sp_strength strength = sp_strength_friction(test_random_real(0.1, 1));
        CHECK_INT(sp_scene_body(&s, R(nw * nd * h * 2000), c, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, k, k + 1, 4, foot, &strength, NULL), SP_OK);
        x = nx; y = ny; z += h; w = nw; d = nd;
    }
    for (int k = 0; k < 3; k++) s.body[k] = test_random_real(-5, 5);
    return s;
}

TEST(bisection_of_verdicts_ends_within_the_bracket)
{
    int several[4] = { 0, 0, 0, 0 };
    for (int trial = 0; trial < 200; trial++) {
        sp_settings set = sp_settings_default();
        sp_scene s = pile();
        if (trial % 10 == 0) { s.body[0] = s.body[1] = 0; s.body[2] = R(-5); }  /* presses on what stands already */
        set.faces = trial % 3 == 0 && !TEST_SMALL ? 8 : 0;
        const sp_limit_result x = limit_of(&s, &set);
        several[x.kind]++;
        if (x.kind == SP_LIMIT_NONE) {
            CHECK_INT(verdict_at(s, &set, 0), SP_UNSTABLE);
            CHECK_INT(verdict_at(s, &set, 2), SP_UNSTABLE);
        }
        if (x.kind == SP_LIMIT_UNBOUNDED)
            for (double more = 1; more < 1e4; more *= 100) CHECK_INT(verdict_at(s, &set, (double)x.lower + more), SP_STABLE);
        if (x.kind != SP_LIMIT_FOUND) continue;
        double lo = 0, hi = 2 * (double)x.upper + 1;
        if (verdict_at(s, &set, lo) != SP_STABLE) lo = (double)x.lower * (1 - NEAR) - NEAR;
        CHECK_INT(verdict_at(s, &set, lo), SP_STABLE);
        for (int it = 0; it < TOL(26, 12); it++) {
            const double mid = (lo + hi) / 2;
            const sp_verdict v = verdict_at(s, &set, mid);
            if (v == SP_UNDECIDED) break;
            if (v == SP_STABLE) lo = mid; else hi = mid;
        }
        CHECK(lo <= (double)x.upper * (1 + NEAR) + NEAR && hi >= (double)x.lower * (1 - NEAR) - NEAR);
    }
    CHECK(several[SP_LIMIT_FOUND] > 50 && several[SP_LIMIT_NONE] > 5 && several[SP_LIMIT_UNBOUNDED] > 0);
    CHECK(several[SP_LIMIT_UNDECIDED] <= (TEST_SMALL ? 30 : TOL(2, 4)));
    if (several[SP_LIMIT_UNDECIDED]) TEST_PRINT("    %d of 200 undecided\n", several[SP_LIMIT_UNDECIDED]);
}

#ifdef SP_REAL_MIXED
#define GLUED_OPEN 5
#else
#define GLUED_OPEN TOL(2, 4)
#endif

/* Scenes of joints with strength, some with a held stone, pushed as a whole or at one stone: against verdicts beside both ends. Of
 * what is left open little may be told by verdicts. */
TEST(glued_and_crushed_scenes_end_where_verdicts_change)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "two-cubes", "offset", 0.3 }, { "wall", "rows", 2 }, { "tower", "n", 3 }, { "diamond", "rows", 3 }, { "arch", "n", 8 },
        { "keystone", "angle", 20 }, { "cantilever", "reach", 1.2 }, { "overhang", "factor", 0.9 }, { "incline", "angle", 20 },
        { "flat-arch", "n", 5 }
    };
    enum { SCENES = sizeof scene / sizeof *scene };
    int several[4] = { 0, 0, 0, 0 };
    for (int trial = 0; trial < 80; trial++) {
        const int k = test_random_int(0, SCENES - 1), type = test_random_int(1, 7), load = test_random_int(0, 5);
        sp_load at;
        sp_scene s;
        double mass = 0, area = 0;
        test_arena.used = 0;
        NEED(gen_make(scene[k].name, scene[k].param, scene[k].value, &test_arena, &s) == SP_OK);
        for (int32_t b = 0; b < s.count.blocks; b++) if (s.block[b].fixed != SP_FIXED) mass += (double)s.block[b].mass;
        for (int32_t i = 0; i < s.count.joints; i++) area += (double)s.joint[i].area;
        const double p = 9.80665 * mass / area, c = p * pow(10, (double)test_random_real(-1, 3)), cap = p * pow(10, (double)test_random_real(0, 2));
        for (int32_t i = 0; i < s.count.joints; i++) {
            s.joint[i].strength.cohesion = type & 1 ? R(c) : 0;
            s.joint[i].strength.tension = (type & 3) == 3 ? R(c / 4) : 0;
            s.joint[i].strength.crushing = type & 4 ? R(cap) : 0;
        }
        int32_t b = test_random_int(0, s.count.blocks - 1);
        if (trial % 3 == 0 && s.block[b].fixed != SP_FIXED) s.block[b].fixed = test_random_int(1, 62);
        while (s.block[b].fixed == SP_FIXED) b = test_random_int(0, s.count.blocks - 1);
        memset(&at, 0, sizeof at);
        at.block = b;
        at.live = 1;
        for (int x = 0; x < 3; x++) {
            const sp_real d = load == 0 ? R(-(x == 2)) : load == 1 ? R(x == 0) : test_random_real(-1, 1);
            if (load < 4) s.body[x] = R(9.80665) * d;
            at.force[x] = s.block[b].mass * R(9.80665) * d;
            at.point[x] = s.block[b].centroid[x] + test_random_real(-0.2, 0.2) * s.block[b].diameter;
        }
        if (load > 3) { s.load = &at; s.count.loads = s.cap.loads = 1; }
        const sp_limit_result x = limit_of(&s, NULL);
        several[x.kind]++;
        if (x.kind == SP_LIMIT_NONE || x.dead == SP_UNSTABLE) CHECK(verdict_at(s, NULL, 0) != SP_STABLE);
        if (x.dead == SP_STABLE) CHECK(verdict_at(s, NULL, 0) != SP_UNSTABLE);
        for (double more = 1; x.kind == SP_LIMIT_UNBOUNDED && more < 1e5; more *= 100) CHECK(verdict_at(s, NULL, (double)x.lower + more) != SP_UNSTABLE);
        for (double more = 1e-3; x.kind == SP_LIMIT_NONE && more < 1e5; more *= 10) CHECK(verdict_at(s, NULL, more) != SP_STABLE);
        if (x.upper >= 0) CHECK(verdict_at(s, NULL, (double)x.upper * (1 + TOL(1e-6, 1e-3)) + TOL(1e-9, 1e-4)) != SP_STABLE);
        if (x.lower > 0 && x.dead == SP_STABLE) CHECK(verdict_at(s, NULL, (double)x.lower * (1 - TOL(1e-6, 1e-3))) != SP_UNSTABLE);
    }
    CHECK(several[SP_LIMIT_FOUND] > 30 && several[SP_LIMIT_UNBOUNDED] > 8 && several[SP_LIMIT_NONE] > 2);
    CHECK(several[SP_LIMIT_UNDECIDED] <= GLUED_OPEN);
    if (several[SP_LIMIT_UNDECIDED]) TEST_PRINT("    %d of 80 undecided\n", several[SP_LIMIT_UNDECIDED]);
}

/* Scenes with a mirror that live loads share, and without. */
static const struct { const char *name, *param; double value, x, y; int planar; } mirrored[] = {
    { "wall", "size", 40, 1, 0, 1 }, { "wall", "size", 40, -1, 0, 1 }, { "wall", "size", 40, 0, 1, 0 }, { "wall", "size", 150, 1, 0, 1 },
    { "arch", "t", 0.15, 1, 0, 1 }, { "arch", "n", 60, -1, 0, 1 }, { "tower", "lean", 0.03, 1, 0, 1 }, { "diamond", "rows", 4, 1, 0, 1 },
    { "vault", "mu", 0.84, 1, 0, 0 }, { "dome", "mu", 0.84, 1, 0, 0 }
};
enum { MIRRORED = sizeof mirrored / sizeof mirrored[0], DOME = MIRRORED - 1 };
#ifdef SP_REAL_MIXED                    /* factors in float don't end at the dome's optimum: the exact stage asks for forces just below */
#define DOME_TIMES 20
#else
#define DOME_TIMES 4
#endif

static sp_scene mirrored_scene(int k)
{
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(gen_make(mirrored[k].name, mirrored[k].param, mirrored[k].value, &test_arena, &s), SP_OK);
    s.body[0] = R(9.80665 * mirrored[k].x);
    s.body[1] = R(9.80665 * mirrored[k].y);
    return s;
}

TEST(what_has_a_mirror_is_searched_in_its_plane_for_less_work)
{
    for (int k = 0; k < 3 * MIRRORED; k += SOME_OF(1, 2)) {         /* every other still meets each cone and each scene */
        const sp_scene s = mirrored_scene(k / 3);
        sp_settings set = sp_settings_default(), space;
        set.faces = k % 3 == 1 ? 4 : k % 3 == 2 ? 8 : 0;
        set.inscribed = k % 3 == 2;
        space = set;
        space.effect[SP_EFFECT_DEPTH] = SP_WITH;
        const sp_limit_result x = limit_of(&s, &set), all = limit_of(&s, &space);
        CHECK_INT(x.kind, SP_LIMIT_FOUND);
        CHECK_INT(all.kind, SP_LIMIT_FOUND);
        CHECK_NEAR(x.multiplier, all.multiplier, NEAR);
        const double times = (double)all.cost.flops / (double)x.cost.flops;     /* in float either may end sooner: by 1.4 at least */
        if (!CHECK(PLANS && mirrored[k / 3].planar ? times > TOL(2, 1.2) : times > 0.9 && times < 1.1))       /* dead loads may have one */
            TEST_PRINT("    %s, %s %g, %d faces: %.2f\n", mirrored[k / 3].name, mirrored[k / 3].param, mirrored[k / 3].value, (int)set.faces, times);
    }
}

/* Work of a limit over that of a check of the same scene just beyond it. */
TEST(a_limit_takes_less_than_four_times_the_work_of_a_check_that_falls)
{
    for (int k = 0; k < MIRRORED; k++) {
        sp_scene s = mirrored_scene(k);
        const sp_limit_result x = limit_of(&s, NULL);
        sp_result r;
        s.live = x.multiplier * TOL(R(1.01), R(1.1));
        CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_OK);
        if (TOL(1, 0)) CHECK_INT(r.verdict, SP_UNSTABLE);
        else CHECK(r.verdict != SP_STABLE);             /* the arch of 60 is beyond float */
        const double times = (double)x.cost.flops / (double)r.spent.total.flops;
        if (!CHECK(times < (!PLANS ? 12 : k == DOME ? DOME_TIMES : 4)))
            TEST_PRINT("    %s, %s %g: %.2f\n", mirrored[k].name, mirrored[k].param, mirrored[k].value, times);
    }
}

/* A claim with either end pushed too far, or evidence of another scene, is not held. */
TEST(a_changed_claim_is_not_held)
{
    sp_scene s = cube(sp_strength_friction(R(0.3)));
    int32_t held = 1;
    push(&s, 1, weight, 0, 0, 0, 0.5, 0);
    const sp_limit_result x = limit_of(&s, NULL);
    sp_limit_result y = x;
    sp_real dq[12];
    NEED(x.kind == SP_LIMIT_FOUND);
    y.lower = y.upper = x.upper * R(1 + 10 * NEAR);
    CHECK_INT(sp_limit_verify(&s, NULL, &y, test_arena, &held), SP_OK);
    CHECK_INT(held, 0);
    y = x;
    y.lower = y.upper = x.lower * R(1 - 10 * NEAR);
    CHECK_INT(sp_limit_verify(&s, NULL, &y, test_arena, &held), SP_OK);
    CHECK_INT(held, 0);
    y = x;
    for (int k = 0; k < 12; k++) dq[k] = -x.dq[k];
    y.dq = dq;
    CHECK_INT(sp_limit_verify(&s, NULL, &y, test_arena, &held), SP_OK);
    CHECK_INT(held, 0);
    y = x;
    y.kind = SP_LIMIT_NONE;
    CHECK_INT(sp_limit_verify(&s, NULL, &y, test_arena, &held), SP_OK);
    CHECK_INT(held, 0);
    y.kind = SP_LIMIT_UNBOUNDED;
    CHECK_INT(sp_limit_verify(&s, NULL, &y, test_arena, &held), SP_OK);
    CHECK_INT(held, 0);
    y = x;
    y.y0 = NULL;                                        /* hints are not needed */
    CHECK_INT(sp_limit_verify(&s, NULL, &y, test_arena, &held), SP_OK);
    CHECK_INT(held, 1);
}

/* ------------------------------------------------------------------------------------------------------ memory, refusals */

TEST(memory_is_exact_and_one_byte_less_refused)
{
    for (int32_t faces = 0; faces <= (TEST_SMALL ? 0 : 8); faces += 8) {
        sp_settings set = sp_settings_default();
        sp_scene s = round_arch(0.15);
        sp_limit_result x;
        size_t bytes = 0;
        set.faces = faces;
        s.body[0] = R(9.80665);
        sp_arena scratch = test_arena;
        scratch.base += scratch.used;
        scratch.cap = sp_memory_scratch(&s, SP_FOR_LIMIT, NULL);
        scratch.used = 0;
        while ((uintptr_t)scratch.base % SP_ALIGN) scratch.base++;
        CHECK_INT(sp_memory(&s, SP_FOR_LIMIT, &set, scratch, &bytes), SP_OK);
        scratch.cap = bytes - 1;
        memset(&x, 0, sizeof x);
        CHECK_INT(sp_limit(&s, &set, &scratch, &x), SP_E_MEMORY);
        CHECK_INT(scratch.used, 0);
        CHECK(!x.f);
        scratch.cap = bytes;
        CHECK_INT(sp_limit(&s, &set, &scratch, &x), SP_OK);
        CHECK_INT(x.kind, SP_LIMIT_FOUND);
        CHECK_INT(x.peak_bytes, bytes);
        CHECK(scratch.used < bytes);
        scratch = test_arena;
        CHECK(test_bytes(&s, SP_FOR_LIMIT_VERIFY, NULL) > 0);
    }
}

TEST(a_budget_that_is_too_small_is_told)
{
    sp_settings set = sp_settings_default();
    sp_scene s = round_arch(0.15);
    sp_limit_result x;
    s.body[0] = R(9.80665);
    set.iterations = 3;
    CHECK_INT(sp_limit(&s, &set, &test_arena, &x), SP_OK);
    CHECK_INT(x.kind, SP_LIMIT_UNDECIDED);
    CHECK_INT(x.reason, SP_REASON_BUDGET);
    CHECK(!x.verified && x.cost.factorisations <= 3 + 1);
    for (int64_t flops = 1000; flops < 100000000; flops *= 3) {        /* a budget is kept; a large one changes nothing */
        set = sp_settings_default();
        set.budget = flops;
        x = limit_of(&s, &set);
        CHECK(x.cost.flops <= flops);
        CHECK(x.kind == SP_LIMIT_FOUND || (x.kind == SP_LIMIT_UNDECIDED && x.reason == SP_REASON_BUDGET));
    }
    CHECK_INT(x.kind, SP_LIMIT_FOUND);
}

TEST(what_is_no_question_is_refused)
{
    sp_settings set = sp_settings_default();
    sp_scene s = cube(sp_strength_friction(R(0.3))), none = s;
    sp_limit_result x;
    sp_joint_motion m;
    size_t bytes;
    push(&s, 1, weight, 0, 0, 0, 0.5, 0);
    CHECK_INT(sp_limit(NULL, NULL, &test_arena, &x), SP_E_ARGUMENT);
    CHECK_INT(sp_limit(&s, NULL, NULL, &x), SP_E_ARGUMENT);
    CHECK_INT(sp_memory(&s, SP_FOR_LIMIT, NULL, test_arena, NULL), SP_E_ARGUMENT);
    none.count.blocks = 0;
    CHECK_INT(sp_limit(&none, NULL, &test_arena, &x), SP_E_EMPTY);
    CHECK_INT(sp_memory(&none, SP_FOR_LIMIT, NULL, test_arena, &bytes), SP_E_EMPTY);
    set.coupled.asked = 1;
    CHECK_INT(sp_limit(&s, &set, &test_arena, &x), SP_E_UNSUPPORTED);
    set = sp_settings_default();
    set.tol = 2;
    CHECK_INT(sp_limit(&s, &set, &test_arena, &x), SP_E_RANGE);
    s.body[0] = R(1e300) * R(1e300);
    CHECK_INT(sp_limit(&s, NULL, &test_arena, &x), SP_E_NOT_FINITE);
    CHECK_INT(sp_joint_moves(&s, s.gravity, 1, &m), SP_E_INDEX);
    CHECK_TEXT(sp_limit_text(SP_LIMIT_NONE), "none");
}

TEST_LIST(limit)
    RUN(a_push_slides_at_mu_or_topples_at_half_the_width_over_its_height)
    RUN(on_a_slope_a_push_along_it_has_what_friction_leaves)
    RUN(what_slides_on_its_own_may_be_held_by_the_live_load)
    RUN(without_friction_one_multiple_works_and_no_other)
    RUN(a_gripper_over_the_edge_topples_by_the_lever)
    RUN(a_couple_topples_at_weight_times_half_the_width)
    RUN(every_cone_slides_at_its_own_coefficient)
    RUN_FULL(glue_and_crushing_have_their_closed_forms)
    RUN_FULL(a_load_that_presses_on_glue_has_no_end_but_a_cap)
    RUN_FULL(a_ray_is_without_strength)
    RUN(what_stands_only_with_its_live_load_is_told)
    RUN(a_multiplier_is_told_no_nearer_than_tol_lets_it)
    RUN_FULL(glue_that_holds_a_hundred_times_the_weight_slides_where_it_should)
    RUN(a_stone_held_from_turning_slides_or_is_lifted)
    RUN(a_cantilever_tips_when_its_tip_bears_more_than_its_tail)
    RUN(walls_in_their_plane_have_the_printed_multipliers)
    RUN(walls_out_of_plane_overturn_at_depth_over_height)
    RUN(arches_bear_the_printed_horizontal_acceleration)
    RUN(an_arch_falls_by_four_hinges)
    RUN(what_slides_is_called_sliding)
    RUN(what_falls_whatever_the_live_load_has_no_multiplier)
    RUN(a_load_that_presses_has_no_end)
    RUN_FULL(a_load_on_any_stone_has_an_end_or_none)
    RUN(a_load_that_lifts_everything_ends_at_its_weight)
    RUN_FULL(what_its_own_weight_crushes_has_no_multiplier)
    RUN(supports_alone_bear_any_load)
    RUN(without_live_load_it_is_all_or_nothing)
    RUN(a_live_load_on_a_support_changes_nothing)
    RUN(units_do_not_matter)
    RUN(live_loads_twice_as_large_have_half_the_multiplier)
    RUN(which_side_is_called_a_does_not_matter)
    RUN(the_multiple_at_which_the_scene_stands_is_not_read)
    RUN(bisection_of_verdicts_ends_within_the_bracket)
    RUN_FULL(glued_and_crushed_scenes_end_where_verdicts_change)
    RUN_FULL(what_has_a_mirror_is_searched_in_its_plane_for_less_work)
    RUN_FULL(a_limit_takes_less_than_four_times_the_work_of_a_check_that_falls)
    RUN(a_changed_claim_is_not_held)
    RUN(memory_is_exact_and_one_byte_less_refused)
    RUN_FULL(a_budget_that_is_too_small_is_told)
    RUN(what_is_no_question_is_refused)
TEST_END
