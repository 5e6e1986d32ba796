/* Limits known in closed form or to many digits: a scene just inside its limit stands, just outside it falls, and both are
 * verified. `margin` is the relative distance on either side; the float build asks the same with its own accuracy.
 * Values come from Paterson & Zwick (stacks), Cocchetti & Rizzi 2020 (arches), and thrust lines in 80 bits (the four arches).
 */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>

static const double deg = 57.295779513082320877;

/* Verdict of a scene as it is, UNDECIDED where the evidence does not hold. */
static sp_verdict verdict(const gen_scene *g, const sp_settings *settings)
{
    const size_t mark = test_arena.used;
    sp_scene s;
    sp_result r;
    sp_status status = gen_build(g, &test_arena, &s);
    if (!status) status = sp_check(&s, settings, &test_arena, &r);
    test_arena.used = mark;
    if (!CHECK_INT(status, SP_OK)) return SP_UNDECIDED;
    if (r.verdict != SP_UNDECIDED) CHECK(r.verified);
    return r.verdict;
}

static sp_verdict verdict_at(gen_scene *g, const sp_settings *settings, const char *param, double value)
{
    if (!CHECK_INT(gen_set(g, param, value), 1)) return SP_UNDECIDED;
    return verdict(g, settings);
}

/* Is `limit` of `param` where the verdict changes? below: the verdict on its smaller side. */
static void limit_in(gen_scene *g, const sp_settings *settings, const char *param, double limit, double margin, sp_verdict below)
{
    const sp_verdict above = below == SP_STABLE ? SP_UNSTABLE : SP_STABLE;
    const double m = margin * fabs(limit);
    if (!CHECK_INT(verdict_at(g, settings, param, limit - m), below) || !CHECK_INT(verdict_at(g, settings, param, limit + m), above))
        TEST_PRINT("    %s, %s = %.9g\n", g->entry->name, param, limit);
}

static void limit(gen_scene *g, const char *param, double value, double margin, sp_verdict below)
{
    limit_in(g, NULL, param, value, margin, below);
}

/* The same for a number known to `digit`, half a unit of its last place. */
static void limit_digits(gen_scene *g, const char *param, double value, double digit, sp_verdict below)
{
    (void)digit;                                        /* finer than float */
    limit_in(g, NULL, param, value, TOL(1.2 * digit / value, 0.1), below);
}

/* The search of the smallest build has a third of a digit less in motions of long chains. */
#ifdef SP_SMALL
enum { CHAIN = 2 };
#else
enum { CHAIN = 1 };
#endif

/* 1 ------------------------------------------------------------------------------------------ sliding and toppling */

TEST(block_slides_when_tan_of_the_slope_exceeds_mu_whatever_the_direction)
{
    static const double turn[] = { 0, 10, 22.5, 33.3, 45, 67.5, 90, 201 };
    for (size_t k = 0; k < sizeof turn / sizeof turn[0]; k++) {
        gen_scene g;
        gen_open(&g, "incline");
        gen_set(&g, "turn", turn[k]);
        gen_set(&g, "angle", 30);
        limit(&g, "mu", tan(30 / deg), TOL(1e-6, 2e-3), SP_UNSTABLE);
        gen_set(&g, "mu", 0.6);
        limit(&g, "angle", atan(0.6) * deg, TOL(1e-6, 2e-3), SP_STABLE);
    }
}

TEST(tilting_the_world_is_tilting_the_slope)
{
    gen_scene g;
    gen_open(&g, "incline");
    gen_set(&g, "angle", 0);
    gen_set(&g, "mu", 0.6);
    for (int k = 0; k < 5; k++) {
        gen_set(&g, "azimuth", 31.0 * k);
        limit(&g, "tilt", atan(0.6) * deg, TOL(1e-6, 2e-3), SP_STABLE);
    }
}

/* Pyramids are stronger or weaker than the cone, by direction: critical slope at azimuths 0, 22.5, 45 to t1, mu = .6. */
#ifndef SP_SMALL
TEST(pyramids_bend_the_sliding_angle_as_their_faces_say)
{
    static const struct { int32_t faces, inscribed; double critical[3]; } table[] = {
        { 4, 0, { 30.964, 33.001, 40.316 } }, { 8, 0, { 30.964, 33.001, 30.964 } },
        { 4, 1, { 22.990, 24.666, 30.964 } }, { 8, 1, { 29.001, 30.964, 29.001 } }, { 16, 1, { 30.476, 30.476, 30.476 } }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++)
        for (int a = 0; a < 3; a++) {
            gen_scene g;
            sp_settings settings = sp_settings_default();
            settings.faces = table[k].faces;
            settings.inscribed = table[k].inscribed;
            gen_open(&g, "incline");
            gen_set(&g, "mu", 0.6);
            gen_set(&g, "turn", 22.5 * a);
            limit_in(&g, &settings, "angle", table[k].critical[a], TOL(3e-5, 2e-3), SP_STABLE);
        }
}
#endif

TEST(block_topples_when_tan_of_the_slope_exceeds_base_over_height)
{
    static const double base[] = { 0.1, 0.25, 0.5, 1 };
    for (size_t k = 0; k < sizeof base / sizeof base[0]; k++) {
        gen_scene g;
        gen_open(&g, "topple");
        gen_set(&g, "mu", 10);
        gen_set(&g, "base", base[k]);
        limit(&g, "angle", atan(base[k]) * deg, TOL(1e-6, 1e-2), SP_STABLE);
    }
}

TEST(cube_falls_off_another_beyond_its_middle)
{
    gen_scene g;
    gen_open(&g, "two-cubes");
    limit(&g, "offset", 0.5, TOL(1e-6, 1e-3), SP_STABLE);
}

TEST(cantilever_tips_when_the_moments_about_its_edge_say_so)
{
    gen_scene g;                                        /* 0.4 (reach - 1) = 0.8 w (1.6 - reach), w = 0.3 */
    gen_open(&g, "cantilever");
    limit(&g, "reach", (0.4 + 0.24 * 1.6) / 0.64, TOL(1e-6, 1e-3), SP_STABLE);
}

TEST(leaning_tower_falls_beyond_one_in_n_plus_one)
{
    static const int n[] = { 1, 2, 5, 10, 30 };
    for (size_t k = 0; k < sizeof n / sizeof n[0] - TOL(0, 1); k++) {
        gen_scene g;
        gen_open(&g, "tower");
        gen_set(&g, "n", n[k]);
        limit(&g, "lean", 1.0 / (n[k] + 1), TOL(n[k] > 10 ? CHAIN * 1e-5 : 1e-6, 3e-2), SP_STABLE);  /* thirty: 1e-9 of imbalance */
    }
}

/* 2 ------------------------------------------------------------------------------------------------------ stacks of boards */

TEST(harmonic_overhang_is_the_limit)
{
    static const int n[] = { 1, 2, 4, 10, 30 };
    for (size_t k = 0; k < sizeof n / sizeof n[0] - TOL(0, 1); k++) {
        gen_scene g;
        gen_open(&g, "overhang");
        gen_set(&g, "n", n[k]);
        limit(&g, "factor", 1, TOL(1e-6, 2e-2), SP_STABLE);
    }
}

TEST(harmonic_stack_falls_when_its_foot_moves_by_a_millionth)
{
    gen_scene g;
    gen_open(&g, "overhang");
    gen_set(&g, "n", 10);
    gen_set(&g, "factor", 1);
    CHECK_INT(verdict_at(&g, NULL, "shift", TOL(-1e-6, -2e-2)), SP_STABLE);
    CHECK_INT(verdict_at(&g, NULL, "shift", TOL(1e-6, 2e-2)), SP_UNSTABLE);
}

TEST(diamonds_of_four_need_no_friction_of_five_and_six_do)
{
    gen_scene g;
    gen_open(&g, "diamond");
    gen_set(&g, "rows", 4);
    CHECK_INT(verdict_at(&g, NULL, "mu", 0), SP_STABLE);
    gen_set(&g, "rows", 5);
    CHECK_INT(verdict_at(&g, NULL, "mu", 0), SP_UNSTABLE);
    limit_digits(&g, "mu", 0.2813, 5e-5, SP_UNSTABLE);
    gen_set(&g, "rows", 6);
    CHECK_INT(verdict_at(&g, NULL, "mu", 0), SP_UNSTABLE);
#ifndef SP_REAL_FLOAT                                   /* float leaves a band of a tenth and more undecided */
    limit_digits(&g, "mu", 0.5396, 5e-5, SP_UNSTABLE);
#endif
}

TEST(inverted_triangles_stand_up_to_two_rows)
{
    for (int rows = 1; rows <= 4; rows++) {
        gen_scene g;
        gen_open(&g, "inverted-triangle");
        gen_set(&g, "rows", rows);
        CHECK_INT(verdict_at(&g, NULL, "mu", 0.001), rows <= 2 ? SP_STABLE : SP_UNSTABLE);
        CHECK_INT(verdict_at(&g, NULL, "mu", 0.84), rows <= 2 ? SP_STABLE : SP_UNSTABLE);
    }
}

/* 3 ------------------------------------------------------------------------------------------------------ wedges and arches */

TEST(keystone_stands_from_mu_the_tangent_of_its_sides)
{
    static const double angle[] = { 35, 30, 20, 10, 5, 1 };         /* the last two need more force than float may use */
    for (size_t k = 0; k < sizeof angle / sizeof angle[0] - TOL(0, 2); k++) {
        gen_scene g;
        gen_open(&g, "keystone");
        gen_set(&g, "angle", angle[k]);
        limit(&g, "mu", tan(angle[k] / deg), TOL(1e-4, 5e-2), SP_UNSTABLE);
    }
}

TEST(keystone_narrowing_downwards_stands_without_friction)
{
    gen_scene g;
    gen_open(&g, "keystone");
    gen_set(&g, "angle", -10);
    CHECK_INT(verdict_at(&g, NULL, "mu", 0), SP_STABLE);
}

TEST(h_model_is_admissible_at_any_friction)
{
    gen_scene g;
    gen_open(&g, "h-model");
    CHECK_INT(verdict_at(&g, NULL, "mu", 0.84), SP_STABLE);
    CHECK_INT(verdict_at(&g, NULL, "mu", 0.01), SP_STABLE);
    CHECK_INT(verdict_at(&g, NULL, "mu", 0), SP_UNSTABLE);
}

TEST(semicircle_needs_the_thickness_of_its_thrust_line)
{
    static const struct { int n; double t; } table[] = {
        { 11, 0.104589144893471 }, { 21, 0.106694801051070 }, { 51, 0.107356862949617 }, { 101, 0.107446469927349 }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        gen_scene g;
        gen_open(&g, "arch");
        gen_set(&g, "n", table[k].n);
        limit(&g, "t", table[k].t, TOL(k < 3 ? 1e-6 : CHAIN * 1e-6, k < 2 ? 3e-2 : 0.15), SP_UNSTABLE);
    }
}

#ifndef SP_REAL_FLOAT
/* By bisection, so that nothing depends on knowing the answer. Where neither side can be proved is part of the answer. */
TEST(bisection_finds_the_thickness_of_eleven_voussoirs)
{
    const double want = 0.104589144893471;
    double falls = 0.05, stands = 0.2;
    gen_scene g;
    gen_open(&g, "arch");
    gen_set(&g, "n", 11);
    while (stands - falls > 1e-7 * want) {
        const double middle = 0.5 * (stands + falls);
        const sp_verdict v = verdict_at(&g, NULL, "t", middle);
        if (v == SP_UNDECIDED) {                        /* only at the limit itself */
            CHECK_NEAR(middle, want, 1e-6);
            return;
        }
        if (v == SP_STABLE) stands = middle; else falls = middle;
    }
    CHECK_NEAR(stands, want, 1e-6);
}

TEST(round_voussoirs_have_the_printed_thickness)
{
    static const struct { int n; double t; } table[] = { { 10, 0.107460 }, { 14, 0.106771 }, { 20, 0.107460 }, { 40, 0.107460 } };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        gen_scene g;
        gen_open(&g, "arch");
        gen_set(&g, "n", table[k].n);
        gen_set(&g, "facets", 40);
        limit_digits(&g, "t", table[k].t, 1e-6, SP_UNSTABLE);
    }
}

TEST(arches_of_other_angles_have_the_printed_thickness)
{
    static const struct { double half, t, digit; } table[] = {
        { 45, 0.00750, 5e-6 }, { 60, 0.02284, 5e-6 }, { 75, 0.05369, 5e-6 }, { 85, 0.08646, 5e-6 }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        gen_scene g;
        gen_open(&g, "arch");
        gen_set(&g, "n", 120);
        gen_set(&g, "half", table[k].half);
        limit_digits(&g, "t", table[k].t, table[k].digit, SP_UNSTABLE);
    }
}

TEST(arch_with_fixed_end_voussoirs_has_the_printed_limits)
{
    gen_scene g;                                        /* inner radius 5, n 20, ends held: t_min .36821, mu_min .27759 at t .5 */
    gen_open(&g, "arch");
    gen_set(&g, "n", 20);
    gen_set(&g, "ends", 1);
    gen_set(&g, "radius", 5.25);
    gen_set(&g, "t", 0.5 / 5.25);
    limit_digits(&g, "mu", 0.27759, 5e-6, SP_UNSTABLE);
    gen_set(&g, "mu", 0.84);
    limit_digits(&g, "t", 0.36821 / (5 + 0.5 * 0.36821), 1e-6, SP_UNSTABLE);
}

TEST(arch_carries_the_printed_horizontal_acceleration)
{
    static const struct { double t, lambda; } table[] = { { 0.12, 0.04819 }, { 0.15, 0.14888 }, { 0.20, 0.28520 } };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        gen_scene g;
        gen_open(&g, "arch");
        gen_set(&g, "n", 20);
        gen_set(&g, "facets", 40);
        gen_set(&g, "t", table[k].t);
        limit_digits(&g, "tilt", atan(table[k].lambda) * deg, 4e-4, SP_STABLE);
    }
}

/* 4 ------------------------------------------------------------------------------------------------------------- walls */

static void brick_wall(gen_scene *g, int rows, int bricks, double mu)
{
    gen_open(g, "wall");
    gen_set(g, "rows", rows);
    gen_set(g, "bricks", bricks);
    gen_set(g, "length", 2);
    gen_set(g, "height", 1);
    gen_set(g, "depth", 1);
    gen_set(g, "mu", mu);
}

TEST(wall_falls_over_as_one_out_of_its_plane)
{
    for (int rows = 2; rows <= 8; rows += 2) {
        gen_scene g;
        brick_wall(&g, rows, 4, 0.84);
        gen_set(&g, "azimuth", 90);
        limit(&g, "tilt", atan(1.0 / rows) * deg, 1e-6, SP_STABLE);
    }
}

TEST(wall_carries_the_printed_acceleration_in_its_plane)
{
    static const struct { int rows, bricks; double mu, lambda; } table[] = {
        { 2, 2, 0.3, 0.3 }, { 4, 2, 0.5, 0.5 }, { 4, 2, 0.65, 0.64155 }, { 4, 4, 0.84, 0.76034 }, { 6, 2, 0.84, 0.63243 },
        { 6, 4, 0.65, 0.59758 }, { 8, 4, 0.65, 0.56637 }, { 8, 4, 0.84, 0.66165 }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        gen_scene g;
        brick_wall(&g, table[k].rows, table[k].bricks, table[k].mu);
        limit_digits(&g, "tilt", atan(table[k].lambda) * deg, 5e-4, SP_STABLE);
    }
}
#endif

/* Stones `lost` leave a scene: they and their joints count for nothing. */
static void lose(sp_scene *s, int n, const int32_t *lost)
{
    int32_t kept = 0;
    for (int k = 0; k < n; k++) s->block[lost[k]].fixed = SP_FIXED;
    for (int32_t j = 0; j < s->count.joints; j++) {
        int gone = 0;
        for (int k = 0; k < n; k++) gone |= s->joint[j].a == lost[k] || s->joint[j].b == lost[k];
        if (!gone) s->joint[kept++] = s->joint[j];
    }
    s->count.joints = kept;
}

/* Without any friction nothing resists many ways to slide, and a matrix with so many null vectors tells nothing: this was undecided
 * at mu = 0 and falls for good at mu = 1e-6, and friction only helps. */
TEST(dome_without_friction_that_lost_stones_falls_for_good)
{
    static const int32_t lost[] = { 3, 5, 6 };
    static const int32_t faces[] = { 0, 8, 4 };
#ifdef SP_SMALL
    const int cones = 1;
#else
    const int cones = 3;
#endif
    for (int k = 0; k < cones; k++) {
        const size_t mark = test_arena.used;
        sp_settings set = sp_settings_default();
        sp_result r;
        sp_scene s;
        gen_scene g;
        gen_open(&g, "dome");
        gen_set(&g, "rings", 2);
        gen_set(&g, "segments", 6);
        gen_set(&g, "mu", 0);
        set.faces = faces[k];
        set.inscribed = 0;
        if (CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK)) {
            lose(&s, 3, lost);
            if (CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK)) {
                CHECK_INT(r.verdict, SP_UNSTABLE);
                CHECK(r.verified && r.final);
            }
        }
        test_arena.used = mark;
    }
}

TEST_LIST(closed)
    RUN(block_slides_when_tan_of_the_slope_exceeds_mu_whatever_the_direction)
    RUN(tilting_the_world_is_tilting_the_slope)
#ifndef SP_SMALL
    RUN(pyramids_bend_the_sliding_angle_as_their_faces_say)
#endif
    RUN(block_topples_when_tan_of_the_slope_exceeds_base_over_height)
    RUN(cube_falls_off_another_beyond_its_middle)
    RUN(cantilever_tips_when_the_moments_about_its_edge_say_so)
    RUN(leaning_tower_falls_beyond_one_in_n_plus_one)
    RUN(harmonic_overhang_is_the_limit)
    RUN(harmonic_stack_falls_when_its_foot_moves_by_a_millionth)
    RUN(diamonds_of_four_need_no_friction_of_five_and_six_do)
    RUN(inverted_triangles_stand_up_to_two_rows)
    RUN(keystone_stands_from_mu_the_tangent_of_its_sides)
    RUN(keystone_narrowing_downwards_stands_without_friction)
    RUN(h_model_is_admissible_at_any_friction)
    RUN(semicircle_needs_the_thickness_of_its_thrust_line)
#ifndef SP_REAL_FLOAT
    RUN(bisection_finds_the_thickness_of_eleven_voussoirs)
    RUN(round_voussoirs_have_the_printed_thickness)
    RUN(arches_of_other_angles_have_the_printed_thickness)
    RUN(arch_with_fixed_end_voussoirs_has_the_printed_limits)
    RUN(arch_carries_the_printed_horizontal_acceleration)
#ifndef SP_NO_IPM
    RUN(dome_without_friction_that_lost_stones_falls_for_good)
#endif
    RUN(wall_falls_over_as_one_out_of_its_plane)
    RUN(wall_carries_the_printed_acceleration_in_its_plane)
#endif
TEST_END
