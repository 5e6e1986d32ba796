/* Joints with strength: mortar that sticks, stone that crushes; each at a limit known by hand, both sides of it. */
#include "../scenes/gen.h"
#include "../test.h"

#include <math.h>
#include <string.h>

#define CLOSE TOL(1e-6, 2e-3)

static const double weight = 2400 * 9.80665;            /* of the cube of 1 m */

/* A cube joined to a support on one face: 0 below it, 1 beside it (at x = 0, n along x). */
static sp_scene cube(int beside, sp_strength strength)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 1 };
    const sp_real below[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 }, side[12] = { 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1 };
    const sp_real middle[3] = { R(0.5), R(0.5), R(0.5) }, ground[3] = { R(-1), 0, R(-1) };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, R(2400), middle, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, beside ? side : below, &strength, NULL), SP_OK);
    return s;
}

static sp_strength mortar(double mu, double cohesion, double tension, double crushing)
{
    const sp_strength strength = { R(mu), R(cohesion), R(tension), R(crushing) };
    return strength;
}

/* The true cone and pyramids, those inside it and around it. */
static const int32_t cones[][2] = { { 0, 0 }, { 3, 1 }, { 4, 0 }, { 4, 1 }, { 5, 0 }, { 8, 0 }, { 8, 1 }, { 64, 1 } };
enum { CONES = sizeof cones / sizeof cones[0] };

static sp_settings cone(int kind)
{
    sp_settings set = sp_settings_default();
    set.faces = cones[kind][0];
    set.inscribed = cones[kind][1];
    return set;
}

static sp_result check_with(const sp_scene *s, const sp_settings *set)
{
    sp_result r;
    sp_evidence e;
    memset(&r, 0, sizeof r);
    CHECK_INT(sp_check(s, set, &test_arena, &r), SP_OK);
    CHECK_INT(sp_verify(s, set, &r, test_arena, &e), SP_OK);
    CHECK_INT(e.verdict, r.verdict);
    CHECK_INT(e.final, r.final);
    return r;
}

static sp_result check(const sp_scene *s) { return check_with(s, NULL); }

/* Stable with all of it 1 - CLOSE times, unstable with 1 + CLOSE times. */
static void pulled(sp_strength strength, double fx, double fy, double fz, double z)
{
    for (int side = -1; side <= 1; side += 2) {
        const double k = 1 + side * CLOSE;
        const sp_load load = { 1, 0, { R(0.5), R(0.5), R(z) }, { R(k * fx), R(k * fy), R(k * fz) }, { 0, 0, 0 }, 0 };
        sp_scene s = cube(0, strength);
        s.gravity[2] = 0;
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        CHECK_INT(check(&s).verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
    }
}

TEST(mortar_is_pulled_apart_at_its_tensile_strength)
{
    pulled(mortar(0.6, 1000, 700, 0), 0, 0, 700, 1);
}

TEST(tension_counts_up_to_cohesion_over_mu)
{
    pulled(mortar(0.5, 100, 700, 0), 0, 0, 200, 1);
}

TEST(without_friction_tension_counts_in_full)
{
    pulled(mortar(0, 0, 700, 0), 0, 0, 700, 1);
}

TEST(mortar_slides_at_its_cohesion_without_pressure)
{
    pulled(mortar(0.6, 1000, 700, 0), 600, 800, 0, 0);
}

TEST(mortar_under_pressure_slides_by_mohr_and_coulomb)
{
    for (int side = -1; side <= 1; side += 2) {
        sp_scene s = cube(0, mortar(0.3, 5000, 1000, 0));
        const double most = 0.3 * weight + 5000;
        const sp_load load = { 1, 0, { 0, R(0.5), 0 }, { R(most * (1 + side * CLOSE)), 0, 0 }, { 0, 0, 0 }, 0 };
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        CHECK_INT(check(&s).verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
    }
}

/* Glued to a wall: the upper corners pull 2 t A / 4 at 1 m over the lower ones, the weight turns at 1/2 m. */
TEST(a_glued_cantilever_breaks_at_its_tensile_strength)
{
    for (int side = -1; side <= 1; side += 2) {
        const sp_scene s = cube(1, mortar(0.84, 5 * weight, weight * (1 - side * CLOSE), 0));
        const sp_result r = check(&s);
        CHECK_INT(r.verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
        CHECK_INT(r.final, side > 0);
    }
}

TEST(without_mortar_the_cantilever_falls)
{
    const sp_scene s = cube(1, mortar(0.84, 0, 0, 0));
    CHECK_INT(check(&s).verdict, SP_UNSTABLE);
}

TEST(stone_is_crushed_by_its_weight_at_its_strength)
{
    for (int side = -1; side <= 1; side += 2) {
        const sp_scene s = cube(0, mortar(0.84, 0, 0, weight * (1 - side * CLOSE)));
        const sp_result r = check(&s);
        CHECK_INT(r.verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
        CHECK_INT(r.final, side > 0);
        if (side > 0) CHECK(r.dq[8] < 0 && r.dq[2] >= 0 && r.dq[2] <= 0);       /* it sinks into the support */
    }
}

/* A push at height h shifts the weight towards an edge, where two corners carry cap A / 4 each: W (1/2 + e) = cap A / 2. */
TEST(crushing_moves_the_toppling_point_inwards)
{
    const double cap = 1.6 * weight, e = cap / (2 * weight) - 0.5;
    for (int side = -1; side <= 1; side += 2) {
        sp_scene s = cube(0, mortar(0.84, 0, 0, cap));
        const sp_load load = { 1, 0, { 0, R(0.5), 1 }, { R(weight * e * (1 + side * CLOSE)), 0, 0 }, { 0, 0, 0 }, 0 };
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        CHECK_INT(check(&s).verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
    }
}

TEST(forces_keep_within_strength)
{
    const sp_scene s = cube(1, mortar(0.5, 3 * weight, 2 * weight, 2.5 * weight));
    const sp_result r = check(&s);
    CHECK_INT(r.verdict, SP_STABLE);
    for (int32_t v = 0; v < 4; v++) {
        const double fn = (double)r.f[3 * v], t1 = (double)r.f[3 * v + 1], t2 = (double)r.f[3 * v + 2];
        CHECK(fn >= -0.5 * weight * (1 + 1e-6) && fn <= 0.625 * weight * (1 + 1e-6));
        CHECK(t1 * t1 + t2 * t2 <= (0.75 * weight + 0.5 * fn) * (0.75 * weight + 0.5 * fn) * (1 + 1e-6));
    }
    sp_joint_force f;
    CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
    CHECK_NEAR(f.utilisation, 1. / 3, TOL(1e-8, 1e-3));         /* W / (3 W), no pressure */
    CHECK(f.min_fn < 0);
}

TEST(more_strength_never_turns_stable_into_unstable)
{
    for (int trial = 0; trial < 60; trial++) {
        sp_strength strength = mortar((double)test_random_real(0, 1), weight * (double)test_random_real(0, 2), weight * (double)test_random_real(0, 2),
                                trial % 2 ? weight * (double)test_random_real(0.5, 3) : 0);
        int stood = 0;
        for (int step = 0; step < 3; step++) {
            const sp_scene s = cube(trial % 3 == 0, strength);
            const sp_verdict v = check(&s).verdict;
            CHECK(!(stood && v == SP_UNSTABLE));
            stood |= v == SP_STABLE;
            strength.cohesion *= R(1.5); strength.tension *= R(1.5); strength.crushing *= R(1.5);
        }
    }
}

TEST(strength_has_no_unit_of_its_own)
{
    for (int k = -2; k <= 2; k++) {                     /* the same cube in other units of mass: all forces times 10^(3k) */
        sp_real unit = 1;
        for (int i = 0; i < (k < 0 ? -k : k); i++) unit *= k < 0 ? R(1e-3) : R(1e3);
        for (int side = -1; side <= 1; side += 2) {
            sp_strength strength = mortar(0.84, 5 * weight, weight * (1 - side * CLOSE), 4 * weight);
            strength.cohesion *= unit; strength.tension *= unit; strength.crushing *= unit;
            sp_scene s = cube(1, strength);
            s.block[1].mass *= unit;
            CHECK_INT(check(&s).verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
        }
    }
}

/* Friction along t1, a face, and towards a corner: both cohesion and friction are cos(pi/K) of it inside the cone, all of it around
 * it, and 1/cos(pi/K) of that towards a corner. */
TEST(every_pyramid_slides_at_its_own_share_of_cohesion_and_friction)
{
    for (int kind = 0; kind < CONES; kind++)
        for (int k = 0; k < 8; k++) {
            const int side = k % 2 ? 1 : -1, corner = k / 2 % 2, pressed = k / 4;
            const sp_settings set = cone(kind);
            const double turn = set.faces ? 3.14159265358979323846 / set.faces : 0, angle = corner * turn;
            const double reach = (set.inscribed ? cos(turn) : 1) / cos(angle);
            const double most = reach * (5000 + pressed * 0.3 * weight) * (1 + side * CLOSE);
            const sp_load load = { 1, 0, { R(0.5), R(0.5), 0 }, { R(-most * cos(angle)), R(-most * sin(angle)), 0 }, { 0, 0, 0 }, 0 };
            sp_scene s = cube(0, mortar(0.3, 5000, 1000, 0));
            if (!pressed) s.gravity[2] = 0;
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
            CHECK_INT(check_with(&s, &set).verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
        }
}

TEST(no_pyramid_changes_what_tears_or_is_crushed)
{
    for (int kind = 0; kind < CONES; kind++)
        for (int side = -1; side <= 1; side += 2) {
            const sp_settings set = cone(kind);
            const double k = 1 - side * CLOSE;
            const int final = side > 0 && !(set.faces && set.inscribed);
            sp_scene s = cube(1, mortar(0.84, 5 * weight, weight * k, 0));              /* the glued cantilever */
            sp_result r = check_with(&s, &set);
            CHECK_INT(r.verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
            CHECK_INT(r.final, final);
            s = cube(0, mortar(0.84, 0, 0, weight * k));                                /* crushed by its weight */
            r = check_with(&s, &set);
            CHECK_INT(r.verdict, side < 0 ? SP_STABLE : SP_UNSTABLE);
            CHECK_INT(r.final, final);
        }
}

/* inside the cone, the cone, around it: each holds what the one before holds; and no answer depends on what a plan leaves out. */
TEST(what_stands_in_a_smaller_cone_stands_in_a_larger_one)
{
    for (int trial = 0; trial < 120; trial++) {
        const sp_strength strength = mortar((double)test_random_real(0, 1), weight * (double)test_random_real(0, 1.5),
                                      weight * (double)test_random_real(0, 1.5), trial % 2 ? weight * (double)test_random_real(0.7, 3) : 0);
        const sp_load load = { 1, 0, { R(0.5), R(0.5), test_random_real(0, 1) },
                               { R(weight) * test_random_real(-1, 1), trial % 4 < 2 ? 0 : R(weight) * test_random_real(-1, 1), 0 },
                               { 0, 0, 0 }, 0 };
        const int32_t faces = 4 * test_random_int(1, 4);
        int stood = 0;
        for (int step = 0; step < 3; step++) {
            sp_scene s = cube(trial % 3 == 0, strength);
            sp_settings set = sp_settings_default();
            set.faces = step == 1 ? 0 : faces;
            set.inscribed = step == 0;
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
            const sp_verdict v = check_with(&s, &set).verdict;
            CHECK(!(stood && v == SP_UNSTABLE));
            CHECK(v != SP_UNDECIDED);
            stood |= v == SP_STABLE;
            set.effect[SP_EFFECT_FRICTION] = set.effect[SP_EFFECT_DEPTH] = set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
            CHECK_INT(check_with(&s, &set).verdict, v);
        }
    }
}

TEST(strength_goes_with_an_area_and_statics_only)
{
    const sp_scene s = cube(0, mortar(0.84, 1, 1, 0));
    const sp_real up[3] = { 0, 0, 1 }, at[3] = { 0, 0, 0 };
    const sp_strength strength = mortar(0.84, 1, 0, 0);
    sp_settings set = sp_settings_default();
    sp_scene points = s;
    sp_triplets t;
    sp_problem p;
    sp_result r;
    set.faces = 8;
    CHECK_INT(sp_problem_build(&s, &test_arena, &p), SP_OK);
    CHECK_INT(sp_matrix_afr(&p, &set, 3, &test_arena, &t), SP_E_UNSUPPORTED);
    set.coupled.asked = 1;
    CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_UNSUPPORTED);
    set.faces = 0;
    CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_UNSUPPORTED);
    points.count.joints = points.count.points = 0;
    CHECK_INT(sp_scene_points(&points, 0, 1, up, 1, at, &strength, NULL), SP_E_AREA);
}

#if !defined SP_REAL_FLOAT && !defined SP_REAL_MIXED && !defined SP_NO_IPM && !defined SP_SMALL
#include "../scenes/vaults.h"

/* An assembly of weights up to `apart` times apart, whose joints stick, tear and crush, each by its own numbers or not at all. */
static int random_masonry(double apart, sp_scene *s)
{
    static const char *const name[] = { "rubble", "wall", "arch", "flat-arch", "dome", "tower" };
    const int kind = test_random_int(0, 5);
    gen_scene g;
    double weight_of_all = 0;
    test_arena.used = 0;
    gen_open(&g, name[kind]);
    if (kind < 2) {
        gen_set(&g, "rows", test_random_int(2, 3));
        gen_set(&g, "bricks", test_random_int(2, 3));
        gen_set(&g, "jitter", (double)test_random_real(0, kind ? R(0.4) : 1));
        gen_set(&g, "seed", test_random_int(1, 900));
    } else if (kind == 4) {
        gen_set(&g, "rings", 2);
        gen_set(&g, "segments", 5);
    } else gen_set(&g, "n", test_random_int(3, 7));
    if (!CHECK_INT(gen_build(&g, &test_arena, s), SP_OK)) return 0;
    for (int32_t i = 0; i < s->count.blocks; i++) {
        s->block[i].mass *= R(pow(apart, (double)test_random_real(R(-0.5), R(0.5))));
        weight_of_all += 9.80665 * (double)s->block[i].mass;
    }
    const sp_real stress = R(weight_of_all / s->count.blocks / 0.05);
    for (int32_t k = 0; k < s->count.joints; k++) {
        sp_strength *j = &s->joint[k].strength;
        if (test_random_int(0, 9) < 7) j->cohesion = stress * test_random_real(0, 2);
        if (test_random_int(0, 9) < 5) j->tension = stress * test_random_real(0, 1);
        if (test_random_int(0, 9) < 7) j->crushing = stress * test_random_real(10, 100);
    }
    gen_gravity(45, (double)test_random_real(0, 360), s->body);
    s->body[2] = 0;
    return 1;
}

static sp_verdict pushed_by(sp_scene *s, double multiple)
{
    s->live = R(multiple);
    return check(s).verdict;
}

/* Where it stands and falls is told by evidence, for what `check` says is verified. */
TEST(cohesion_mixed_with_crushing_is_decided_to_1e_5_of_the_limit)
{
    int limits = 0, found = 0;
    for (int k = 0; k < SOME_OF(200, 24); k++) {
        sp_scene s;
        double stands = -1, falls = -1;
        if (!random_masonry(k % 3 ? 10 : 1e6, &s)) return;
        for (double push = 0.01; push < 200 && falls < 0; push *= 2) {
            const sp_verdict got = pushed_by(&s, push);
            if (!CHECK(got != SP_UNDECIDED)) TEST_PRINT("  scene %d, %g\n", k, push);
            if (got == SP_STABLE) stands = push;
            if (got == SP_UNSTABLE) falls = push;
        }
        if (stands < 0 || falls < 0) continue;
        limits++;
        while (falls - stands > 1e-5 * falls) {
            const double middle = (stands + falls) / 2;
            const sp_verdict got = pushed_by(&s, middle);
            const double beside = got == SP_UNDECIDED ? 4e-6 * falls : 0;       /* of the limit itself there is an answer */
            if (got != SP_UNSTABLE) stands = middle - beside;
            if (got != SP_STABLE) falls = middle + beside;
            if (got != SP_UNDECIDED) continue;
            if (!CHECK_INT(pushed_by(&s, stands), SP_STABLE) || !CHECK_INT(pushed_by(&s, falls), SP_UNSTABLE))
                TEST_PRINT("  scene %d, %.9g\n", k, middle);
            break;
        }
        const size_t used = test_arena.used;
        sp_limit_result r;
        CHECK_INT(sp_limit(&s, NULL, &test_arena, &r), SP_OK);
        if (!CHECK(r.lower <= falls && r.upper >= stands && r.lower >= 0 && r.upper - r.lower <= R(1e-5) * r.upper))
            TEST_PRINT("  scene %d, %.9g .. %.9g in %.9g .. %.9g\n", k, (double)r.lower, (double)r.upper, stands, falls);
        found += r.kind == SP_LIMIT_FOUND && CHECK_INT(r.dead, pushed_by(&s, 0));
        test_arena.used = used;
    }
    TEST_PRINT("    %d limits closed in, %d of them found\n", limits, found);
    CHECK(limits >= SOME_OF(100, 12) && 5 * found > 4 * limits);
}

/* Pushed to 1.2 of its limit by dead loads and pulled back by live ones: it stands from 0.2 of that on, and falls the other way
 * somewhere. 8 of 26 had no such answer when it was sought by halving alone. */
TEST(what_only_live_loads_hold_has_both_ends)
{
    int asked = 0, found = 0, most = 0;
    for (int k = 0; k < SOME_OF(120, 30); k++) {
        sp_scene s;
        sp_limit_result r;
        if (!random_masonry(10, &s)) return;
        const size_t used = test_arena.used;
        CHECK_INT(sp_limit(&s, NULL, &test_arena, &r), SP_OK);
        test_arena.used = used;
        const sp_real m = r.multiplier;
        if (r.kind != SP_LIMIT_FOUND || r.dead != SP_STABLE || !(m > R(0.01))) continue;
        for (int c = 0; c < 3; c++) {
            s.gravity[c] += R(1.2) * m * s.body[c];
            s.body[c] = -s.body[c];
        }
        CHECK_INT(sp_limit(&s, NULL, &test_arena, &r), SP_OK);
        test_arena.used = used;
        asked++;
        CHECK_INT(r.dead, SP_UNSTABLE);
        if (r.kind == SP_LIMIT_FOUND && CHECK(r.lowest > R(0.2 - 1e-5) * m) && r.lowest < R(0.2 + 1e-5) * m) found++;
        else TEST_PRINT("  scene %d, kind %d, lowest %g of %g\n", k, (int)r.kind, (double)r.lowest, 0.2 * (double)m);
        if (r.cost.factorisations > most) most = r.cost.factorisations;
    }
    TEST_PRINT("    %d of %d found, %d factorisations at most\n", found, asked, most);
    CHECK(asked >= SOME_OF(80, 20) && 10 * found > 9 * asked);
}

/* A stone on a bed with a little cohesion, pulled through its middle beyond mu N + c A: 17 of 400 were undecided when the
 * column of tau was a difference of what nearly cancels. */
TEST(a_stone_that_sticks_a_little_slides_one_millionth_beyond_its_limit)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 1 };
    const sp_real ground[3] = { 0, 0, R(-1) }, bed[12] = { R(0.5), 0, 0, R(0.5), R(0.4), 0, 0, R(0.4), 0, 0, 0, 0 };
    const double n = 536;
    for (int k = 0; k < SOME_OF(400, 100); k++) {
        const double mass = 5087 * (double)test_random_real(R(0.9), R(1.1));
        const double turn = 1.849 + (double)test_random_real(R(-0.01), R(0.01));
        const sp_real middle[3] = { R(0.2495) + test_random_real(R(-0.001), R(0.001)), R(0.2), R(0.1244) };
        const sp_strength strength = mortar(0.8832 * (double)test_random_real(R(0.99), R(1.01)), 52059, 0, 0);
        const double slides = (double)strength.mu * n + (double)strength.cohesion * 0.2 / mass;
        sp_settings set = sp_settings_default();
        sp_scene s;
        test_arena.used = 0;
        CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
        CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, R(mass), middle, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 1, 4, bed, &strength, NULL), SP_OK);
        s.gravity[0] = R(slides * (1 + 1e-6) * cos(turn));
        s.gravity[1] = R(slides * (1 + 1e-6) * sin(turn));
        s.gravity[2] = R(-n);
        set.tol = R(1e-9);
        if (!CHECK_INT(check_with(&s, &set).verdict, SP_UNSTABLE)) TEST_PRINT("  scene %d\n", k);
    }
}

/* The interior points took 8 steps that got nowhere, one after the other, for the end; these vaults were undecided. */
TEST(vaults_that_stick_and_crush_fall_after_steps_that_get_nowhere)
{
    static const struct { uint32_t number; double push; } vault[] = {
        { 97, 18.460098266601562 }, { 115, 2.9362735748291016 }, { 117, 16.56707763671875 }, { 124, 12.631309509277344 }
    };
    for (size_t k = 0; k < sizeof vault / sizeof vault[0]; k++) {
        sp_scene s;
        double push[3];
        numbered_vault(vault[k].number, &s, push);
        for (int c = 0; c < 3; c++) s.gravity[c] += R(vault[k].push * push[c]);
        if (!CHECK_INT(check(&s).verdict, SP_UNSTABLE)) TEST_PRINT("  vault %d\n", (int)vault[k].number);
    }
}
#endif

TEST_LIST(strength)
    RUN(mortar_is_pulled_apart_at_its_tensile_strength)
    RUN(tension_counts_up_to_cohesion_over_mu)
    RUN(without_friction_tension_counts_in_full)
    RUN(mortar_slides_at_its_cohesion_without_pressure)
    RUN(mortar_under_pressure_slides_by_mohr_and_coulomb)
    RUN(a_glued_cantilever_breaks_at_its_tensile_strength)
    RUN(without_mortar_the_cantilever_falls)
    RUN(stone_is_crushed_by_its_weight_at_its_strength)
    RUN(crushing_moves_the_toppling_point_inwards)
    RUN(forces_keep_within_strength)
    RUN(more_strength_never_turns_stable_into_unstable)
    RUN(strength_has_no_unit_of_its_own)
    RUN(every_pyramid_slides_at_its_own_share_of_cohesion_and_friction)
    RUN(no_pyramid_changes_what_tears_or_is_crushed)
    RUN(what_stands_in_a_smaller_cone_stands_in_a_larger_one)
    RUN(strength_goes_with_an_area_and_statics_only)
#if !defined SP_REAL_FLOAT && !defined SP_REAL_MIXED && !defined SP_NO_IPM && !defined SP_SMALL
    RUN(cohesion_mixed_with_crushing_is_decided_to_1e_5_of_the_limit)
    RUN(what_only_live_loads_hold_has_both_ends)
    RUN(a_stone_that_sticks_a_little_slides_one_millionth_beyond_its_limit)
    RUN(vaults_that_stick_and_crush_fall_after_steps_that_get_nowhere)
#endif
TEST_END
