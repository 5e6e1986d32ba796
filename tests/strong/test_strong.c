/* Strong verdicts: what pressure alone holds, what moves for all that friction does, and claims that prove neither. */
#include "../test.h"

#ifndef SP_NO_STRONG
#include "strong.h"

#include <math.h>

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

TEST(a_block_on_a_slope_below_its_friction_does_not_move)
{
    static const double angle[] = { 5, 20, 39 };        /* tan 40 = .84 */
    for (int k = 0; k < 3; k++) CHECK_INT(of("incline", "angle", angle[k]).kind, SP_STRONG_ADMISSIBLE);
    CHECK_INT(of("incline", "angle", 41).kind, SP_STRONG_NONE);
}

/* Corners at r1 that carry all the weight hold mu W r1, those at r2 > r1 mu W r2; the largest spin is (T - mu W r1) / J. */
TEST(a_stool_with_a_cross_for_feet_is_ambiguous_from_the_lesser_torque_on_and_spins_the_most_it_can)
{
    const double mu = 0.5, r1 = 0.3, r2 = 0.6, J = 0.4 * (r2 * r2 + 0.05 * 0.05) / 9.80665;
    static const double below[] = { 0, 0.5, 0.99 }, between[] = { 1.01, 1.2, 1.6, 1.99 };
    for (int k = 0; k < 3; k++) {
        const sp_scene s = stool(r1, r2, mu, below[k] * mu * r1);
        CHECK_INT(ask(&s, NULL).kind, k ? SP_STRONG_ADMISSIBLE : SP_STRONG_STRONG);
    }
    for (int k = 0; k < 4; k++) {
        const sp_scene s = stool(r1, r2, mu, between[k] * mu * r1);
        const sp_strong_result r = ask(&s, NULL);
        CHECK_INT(r.kind, SP_STRONG_AMBIGUOUS);
        CHECK_INT(r.balls, 1);
        const double spin = (double)r.a[6 + 5], most = (between[k] - 1) * mu * r1 / J;
        CHECK(spin > 0 && spin <= most * (1 + TOL(1e-9, 1e-3)));
        CHECK(fabs(spin / most - 1) < TOL(1e-6, 1e-2));
    }
    const sp_scene s = stool(r1, r2, mu, 2.01 * mu * r1);
    CHECK_INT(ask(&s, NULL).kind, SP_STRONG_NONE);
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
        { "incline", "angle", 20, SP_STRONG_ADMISSIBLE }, { "tower", "n", 4, SP_STRONG_STRONG } };
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

TEST(strong_takes_the_memory_it_says_and_no_byte_less)
{
    static const char *const name[] = { "h-model", "wall", "incline" };
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        sp_result x;
        sp_strong_result r;
        size_t bytes = 0;
        test_arena.used = 0;
        CHECK_INT(gen_make(name[k], NULL, 0, &test_arena, &s), SP_OK);
        CHECK_INT(sp_check(&s, NULL, &test_arena, &x), SP_OK);
        CHECK_INT(sp_memory(&s, SP_FOR_STRONG, NULL, test_arena, &bytes), SP_OK);
        sp_arena a = test_arena;
        a.used = (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        a.base += a.used;
        a.used = a.peak = 0;
        a.capacity = bytes - 1;
        CHECK_INT(sp_strong(&s, NULL, NULL, x.f, NULL, &a, &r), SP_E_MEMORY);
        a.capacity = bytes;
        CHECK_INT(sp_strong(&s, NULL, NULL, x.f, NULL, &a, &r), SP_OK);
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

TEST(questions_that_make_no_sense_are_refused)
{
    const sp_strong_settings fewer = { -1 }, no_starts = { 0 };
    const sp_scene s = stool(0.3, 0.6, 0.5, 0.2);
    sp_strong_kind proved;
    sp_strong_result r = ask(&s, &no_starts), x;
    sp_settings set = sp_settings_default();
    CHECK(r.kind == SP_STRONG_ADMISSIBLE && r.starts == 0);
    CHECK_INT(sp_strong(&s, NULL, &fewer, r.f, NULL, &test_arena, &x), SP_E_RANGE);
    CHECK_INT(sp_strong(NULL, NULL, NULL, r.f, NULL, &test_arena, &x), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, NULL, NULL, &test_arena, &x), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, r.f, NULL, &test_arena, NULL), SP_E_ARGUMENT);
    set.faces = 8;
    CHECK_INT(sp_strong(&s, &set, NULL, r.f, NULL, &test_arena, &x), SP_E_UNSUPPORTED);
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
    RUN(a_block_on_a_slope_below_its_friction_does_not_move)
    RUN(a_stool_with_a_cross_for_feet_is_ambiguous_from_the_lesser_torque_on_and_spins_the_most_it_can)
    RUN(evidence_that_is_changed_proves_less)
    RUN(forces_at_rest_are_no_motion)
    RUN(answers_do_not_depend_on_how_the_scene_is_written)
    RUN(what_does_not_stand_is_never_strong)
    RUN(strength_of_joints_proves_nothing_and_hinders_no_proof)
    RUN(strong_takes_the_memory_it_says_and_no_byte_less)
    RUN(questions_that_make_no_sense_are_refused)
#endif
TEST_END
