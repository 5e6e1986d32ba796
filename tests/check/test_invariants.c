/* The verdict does not depend on where the scene is, how it is turned, in which units it is written, in which order its
 * blocks, joints and contact vertices come, or which side is called A; and the forces go with the scene. */
#include "../test.h"
#include "../scenes/gen.h"
#include "../scenes/change.h"

#include <math.h>
#include <string.h>

/* Resultants of `two` are those of `one`, turned and in new units. A scene that stands has one shortest force state, which
 * both searches approach: far less exactly than their balance, as the balance of nearby states is as good. */
static void same_forces(const sp_scene *s1, const sp_result *r1, const sp_scene *s2, const sp_result *r2, const change *c,
                        const int32_t *name, double tol)
{
    const double unit = c->density * c->gravity * c->scale * c->scale * c->scale;
    double largest = 0, worst = 0;
    for (int32_t j = 0; j < s1->count.joints; j++) {
        sp_joint_force a, b;
        double want[3];
        CHECK_INT(sp_joint_resultant(s1, r1, j, &a), SP_OK);
        CHECK_INT(sp_joint_resultant(s2, r2, name[j], &b), SP_OK);
        const double sign = c->swap && j % 2 == 0 ? -unit : unit;
        move(c, a.force, 1, want);
        for (int i = 0; i < 3; i++) {
            const double off = fabs((double)b.force[i] - sign * want[i]);
            if (off > worst) worst = off;
            if (fabs(unit * want[i]) > largest) largest = fabs(unit * want[i]);
        }
    }
    CHECK_WITHIN(worst / largest, 0, tol);
}

/* hard: float may leave it undecided (hundreds of joints slide and open at once). */
static const struct { const char *name, *param; double value; sp_verdict verdict; int hard; } sample[] = {
    { "two-cubes", "offset", 0.3, SP_STABLE, 0 },  { "two-cubes", "offset", 0.6, SP_UNSTABLE, 0 },
    { "arch", "t", 0.13, SP_STABLE, 0 },           { "arch", "t", 0.095, SP_UNSTABLE, 0 },
    { "wall", "jitter", 0.35, SP_STABLE, 0 },      { "wall", "tilt", 35, SP_UNSTABLE, TOL(0, 1) },
    { "rubble", "jitter", 0.6, SP_STABLE, 0 },     { "rubble", "tilt", 42, SP_UNSTABLE, 0 },
    { "keystone", "mu", 0.40, SP_STABLE, 0 },      { "keystone", "mu", 0.34, SP_UNSTABLE, 0 },
    { "diamond", "mu", TOL(0.30, 0.40), SP_STABLE, 0 }, { "diamond", "mu", TOL(0.26, 0.18), SP_UNSTABLE, 0 }
};

/* `forces`: how closely the forces must follow, 0: not asked. */
static void unchanged_by(const change *c, double forces)
{
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        gen_scene g;
        sp_scene s1, s2;
        sp_result r1, r2;
        sp_evidence evidence;
        int32_t place[MOST], name[MOST];
        test_arena.used = 0;
        gen_open(&g, sample[k].name);
        gen_set(&g, sample[k].param, sample[k].value);
        NEED(gen_build(&g, &test_arena, &s1) == SP_OK);
        NEED(s1.count.blocks <= MOST && s1.count.joints <= MOST);
        copy(&s1, c, &s2, place, name);
        NEED(sp_check(&s1, NULL, &test_arena, &r1) == SP_OK);
        NEED(sp_check(&s2, NULL, &test_arena, &r2) == SP_OK);
        if (sample[k].hard && (!r1.verdict || !r2.verdict)) continue;
        if (!CHECK_INT(r1.verdict, sample[k].verdict) || !CHECK_INT(r2.verdict, sample[k].verdict))
            TEST_PRINT("    %s, %s = %g\n", sample[k].name, sample[k].param, sample[k].value);
        CHECK(r1.verified && r2.verified);
        const int told = TOL(1, 0) && strcmp(sample[k].name, "rubble");     /* whether nothing resists at all is told from rounding */
        if (told && !CHECK_INT(r1.final, r2.final)) TEST_PRINT("    %s, %s = %g\n", sample[k].name, sample[k].param, sample[k].value);
        CHECK_INT(sp_verify(&s2, NULL, &r2, test_arena, &evidence), SP_OK);
        CHECK_INT(evidence.verdict, r2.verdict);
        if (forces > 0 && r1.verdict == SP_STABLE && r2.verdict == SP_STABLE) same_forces(&s1, &r1, &s2, &r2, c, name, forces);
    }
}

static const double close = TOL(1e-6, 2e-2);

TEST(rotating_the_world_turns_the_forces)
{
    for (int k = 0; k < 3; k++) {
        change c = none();
        any_turn(&c);
        unchanged_by(&c, close);
    }
}

TEST(mirroring_through_two_planes_is_a_rotation)
{
    change c = none();
    c.q[0][0] = c.q[1][1] = -1;
    unchanged_by(&c, close);
}

TEST(translating_changes_nothing)
{
    change c = none();
    c.shift[0] = TOL(1000, 10), c.shift[1] = TOL(-2000, -20), c.shift[2] = TOL(500, 5);
    unchanged_by(&c, close);
}

TEST(units_change_numbers_only)
{
    static const struct { double m, kg_m3, m_s2; } unit[] = {
        { 1e3, 1e-9, 1e3 },                             /* mm, kg: forces in mN */
        { 1e3, 1e-12, 1e3 },                            /* mm, tonne: N */
        { 1e-3, 1e9, 1e-3 },                            /* km, kg */
        { 1, 1, 1 / 9.80665 },                          /* forces in kg */
        { 3.2808399, 1 / 35.314667, 3.2808399 }         /* ft */
    };
    for (size_t k = 0; k < sizeof unit / sizeof unit[0]; k++) {
        change c = none();
        c.scale = unit[k].m, c.density = unit[k].kg_m3, c.gravity = unit[k].m_s2;
        unchanged_by(&c, close);
    }
}

TEST(order_of_blocks_and_joints_does_not_matter)
{
    for (int k = 0; k < 3; k++) {
        change c = none();
        c.permute = 1;
        unchanged_by(&c, close);
    }
}

TEST(first_corner_of_a_joint_does_not_matter)
{
    change c = none();
    c.turn = 1;
    unchanged_by(&c, close);
}

TEST(which_side_is_called_a_does_not_matter)
{
    change c = none();
    c.swap = 1;
    unchanged_by(&c, close);
}

TEST(all_changes_at_once_change_nothing)
{
    for (int k = 0; k < 3; k++) {
        change c = none();
        any_turn(&c);
        for (int i = 0; i < 3; i++) c.shift[i] = (double)test_random_real(-5, 5);
        c.scale = 12.5, c.density = 0.25, c.gravity = 3;
        c.permute = c.turn = c.swap = 1;
        unchanged_by(&c, close);
    }
}

TEST(the_same_scene_twice_gives_the_same_bits)
{
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        gen_scene g;
        sp_scene s;
        sp_result r1, r2;
        test_arena.used = 0;
        gen_open(&g, sample[k].name);
        gen_set(&g, sample[k].param, sample[k].value);
        NEED(gen_build(&g, &test_arena, &s) == SP_OK);
        NEED(sp_check(&s, NULL, &test_arena, &r1) == SP_OK);
        NEED(sp_check(&s, NULL, &test_arena, &r2) == SP_OK);
        const unsigned char *a = (const unsigned char *)r1.f, *b = (const unsigned char *)r2.f;
        int same = 1;
        for (size_t i = 0; i < sizeof(sp_real) * 3 * (size_t)s.count.points; i++) same = same && a[i] == b[i];
        CHECK(same);
        CHECK_INT(r1.spent.total.flops, r2.spent.total.flops);
    }
}

TEST(joints_given_twice_change_nothing)
{
    change c = none();
    c.twice = 1;
    unchanged_by(&c, 0);
}

/* More friction never makes a standing scene fall; less never lifts a fallen one. */
TEST(friction_helps)
{
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        gen_scene g;
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        gen_open(&g, sample[k].name);
        gen_set(&g, sample[k].param, sample[k].value);
        NEED(gen_build(&g, &test_arena, &s) == SP_OK);
        const double mu = (double)s.joint[0].strength.mu;
        CHECK_INT(sp_scene_friction(&s, R(sample[k].verdict == SP_STABLE ? 1.5 * mu : 0.7 * mu)), SP_OK);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        if (!sample[k].hard || r.verdict) CHECK_INT(r.verdict, sample[k].verdict);
    }
}

TEST_LIST(invariants)
    RUN(rotating_the_world_turns_the_forces)
    RUN(mirroring_through_two_planes_is_a_rotation)
    RUN(translating_changes_nothing)
    RUN(units_change_numbers_only)
    RUN(order_of_blocks_and_joints_does_not_matter)
    RUN(first_corner_of_a_joint_does_not_matter)
    RUN(which_side_is_called_a_does_not_matter)
    RUN(all_changes_at_once_change_nothing)
    RUN(the_same_scene_twice_gives_the_same_bits)
    RUN(joints_given_twice_change_nothing)
    RUN(friction_helps)
TEST_END
