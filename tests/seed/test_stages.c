/* Stages as data: each says only what it can prove, a caller's own is believed no further than its evidence goes, and settings
 * that make no sense are refused before anything is touched. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>
#include <string.h>

static void build(const char *name, const char *param, double value, sp_scene *scene)
{
    CHECK_INT(gen_make(name, param, value, &test_arena, scene), SP_OK);
}

static void wall(int rows, int bricks, double jitter, sp_scene *scene)
{
    gen_scene g;
    CHECK_INT(gen_open(&g, "wall"), 1);
    gen_set(&g, "rows", rows);
    gen_set(&g, "bricks", bricks);
    gen_set(&g, "jitter", jitter);
    CHECK_INT(gen_build(&g, &test_arena, scene), SP_OK);
}

/* Settings with one or two stages. */
static sp_settings stages(sp_stage_id first, sp_stage_id second)
{
    sp_settings s = sp_settings_default();
    s.stage_count = second ? 2 : 1;
    s.stage[0] = first;
    s.stage[1] = second;
    return s;
}

static sp_result check(const sp_scene *scene, const sp_settings *settings)
{
    sp_result r;
    memset(&r, 0, sizeof r);
    r.verdict = SP_UNDECIDED;
    r.extremes.weakest = -2;
    CHECK_INT(sp_check(scene, settings, &test_arena, &r), SP_OK);
    CHECK_INT(r.verified, r.verdict != SP_UNDECIDED);
    CHECK_INT(r.level, r.verdict == SP_STABLE ? SP_ADMISSIBLE : SP_NONE);
    return r;
}

static int all_finite(const sp_real *x, int32_t n)
{
    for (int32_t k = 0; k < n; k++) if (!isfinite((double)x[k])) return 0;
    return 1;
}

/* UNDECIDED for this reason, and nothing that looks like evidence. */
static void undecided(const sp_scene *scene, const sp_result *r, sp_reason reason)
{
    CHECK_INT(r->verdict, SP_UNDECIDED);
    CHECK_TEXT(sp_reason_text(r->reason), sp_reason_text(reason));
    CHECK_INT(r->stage, SP_STAGE_NONE);
    CHECK_INT(r->final, 0);
    CHECK(r->least_imbalance >= 0 && r->least_imbalance <= r->tol);
    CHECK(all_finite(r->f, 3 * scene->count.points) && all_finite(r->dq, 6 * scene->count.blocks));
}

/* 1 ------------------------------------------------------------------------------------------------------------- gates */

/* Cubes of 1 m, each on top of the one below: one fixed or all free, then a gap, then two more. */
static void columns(int standing, int floating, sp_scene *s)
{
    const sp_capacity cap = { standing + floating, 0, 0, 0, standing + floating, 4 * (standing + floating), 0 };
    const sp_strength strength = sp_strength_friction(R(0.84));
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < standing + floating; k++) {
        const double z = k < standing ? k : k + 1;
        const sp_real c[3] = { R(0.5), R(0.5), R(z + 0.5) };
        const sp_real foot[12] = { 0, 0, R(z), 1, 0, R(z), 1, 1, R(z), 0, 1, R(z) };
        CHECK_INT(sp_scene_body(s, 2400, c, standing && !k ? SP_FIXED : 0, NULL), SP_OK);
        if (k && k != standing) CHECK_INT(sp_scene_joint(s, k - 1, k, 4, foot, &strength, NULL), SP_OK);
    }
}

TEST(gates_see_a_block_that_touches_nothing)
{
    sp_scene s;
    const sp_settings set = stages(SP_STAGE_GATES, SP_STAGE_NONE);
    columns(2, 1, &s);
    const sp_result r = check(&s, &set);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_TEXT(sp_reason_text(r.reason), "no contact");
    CHECK_INT(r.stage, SP_STAGE_GATES);
    CHECK_INT(r.final, 1);
    for (int32_t k = 0; k < 18; k++) CHECK_WITHIN(r.dq[k], k == 14 ? -sqrt(0.75) : 0, 8 * (double)SP_EPSILON);  /* it alone falls */
}

TEST(gates_see_a_group_without_support)
{
    const sp_settings set = stages(SP_STAGE_GATES, SP_STAGE_NONE);
    for (int standing = 0; standing <= 2; standing += 2) {
        sp_scene s;
        test_arena.used = 0;
        columns(standing, 3, &s);
        const sp_result r = check(&s, &set);
        CHECK_INT(r.verdict, SP_UNSTABLE);
        CHECK_TEXT(sp_reason_text(r.reason), "no support");
        CHECK_INT(r.final, 1);
        CHECK(r.dq[6 * standing + 2] < 0);
        for (int32_t k = 0; k < 6 * (standing + 3); k++)        /* all of the group alike, and nothing else */
            CHECK_WITHIN(r.dq[k], k < 6 * standing || k % 6 != 2 ? 0 : (double)r.dq[6 * standing + 2], 8 * (double)SP_EPSILON);
    }
}

TEST(nothing_to_carry_stands)
{
    const sp_settings set = stages(SP_STAGE_GATES, SP_STAGE_NONE);
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        test_arena.used = 0;
        columns(2, k, &s);
        if (k) for (int c = 0; c < 3; c++) s.gravity[c] = 0;    /* floating, but nothing pulls */
        else s.block[1].fixed = SP_FIXED;
        const sp_result r = check(&s, &set);
        CHECK_INT(r.verdict, SP_STABLE);
        CHECK_TEXT(sp_reason_text(r.reason), "nothing to carry");
        CHECK_INT(r.counts.free_blocks, k ? 1 + k : 0);
        CHECK_INT(r.stage, k ? SP_STAGE_GATES : SP_STAGE_NONE);
        CHECK_WITHIN(r.imbalance, 0, 0);
        for (int32_t v = 0; v < 3 * s.count.points; v++) CHECK_WITHIN(r.f[v], 0, 0);
    }
}

TEST(gates_leave_everything_else_open)
{
    static const struct { const char *name, *param; double value; } table[] = {
        { "two-cubes", NULL, 0 }, { "two-cubes", "offset", 0.6 }, { "arch", NULL, 0 }, { "arch", "t", 0.05 }, { "wall", NULL, 0 }
    };
    const sp_settings set = stages(SP_STAGE_GATES, SP_STAGE_NONE);
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        test_arena.used = 0;
        build(table[k].name, table[k].param, table[k].value, &s);
        const sp_result r = check(&s, &set);
        undecided(&s, &r, SP_REASON_STAGES);
    }
}

/* Bodies anywhere, some of them touching: what gates call unstable the exact stage alone never calls stable. */
TEST(gates_never_say_unstable_where_the_exact_stage_says_stable)
{
    const sp_settings gates = stages(SP_STAGE_GATES, SP_STAGE_NONE), exact = stages(SP_STAGE_EXACT, SP_STAGE_NONE);
    int32_t falls = 0, stands = 0;
    for (int run = 0; run < 1000; run++) {
        const int32_t n = test_random_int(2, 7), joints = test_random_int(1, 2 * n);
        const sp_capacity cap = { n, 0, 0, 0, joints, 4 * joints, 1 };
        const sp_strength strength = sp_strength_friction(test_random_real(0, 1));
        sp_scene s;
        test_arena.used = 0;
        CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
        for (int32_t b = 0; b < n; b++) {
            const sp_real c[3] = { test_random_real(-1, 1), test_random_real(-1, 1), R(b) };
            const uint32_t fixed = b == 0 ? SP_FIXED : test_random_int(0, 9) ? 0 : (uint32_t)test_random_int(1, 63);
            CHECK_INT(sp_scene_body(&s, test_random_real(1, 9), c, fixed, NULL), SP_OK);
        }
        for (int32_t k = 0; k < joints; k++) {
            const int32_t a = test_random_int(0, n - 2), b = test_random_int(a + 1, n - 1);
            const double x = (double)test_random_real(-2, 0), y = (double)test_random_real(-2, 0), z = 0.5 * (a + b);
            const sp_real foot[12] = { R(x), R(y), R(z), R(x + 2), R(y), R(z), R(x + 2), R(y + 2), R(z), R(x), R(y + 2), R(z) };
            CHECK_INT(sp_scene_joint(&s, a, b, 4, foot, &strength, NULL), SP_OK);
        }
        if (run % 4 == 0) {
            sp_load load = { 1, 0, { 0, 0, 1 }, { 0, 0, 0 }, { 0, 0, 0 }, 0 };
            for (int k = 0; k < 3; k++) { load.force[k] = test_random_real(-20, 20); load.couple[k] = test_random_real(-9, 9); }
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        }
        const sp_verdict v = check(&s, &gates).verdict, w = check(&s, &exact).verdict;
        if (!CHECK(!(v == SP_UNSTABLE && w == SP_STABLE)) || !CHECK(!(v == SP_STABLE && w == SP_UNSTABLE))) return;
        falls += v == SP_UNSTABLE;
        stands += w == SP_STABLE;
    }
    CHECK(falls > 100 && stands > 30);
}

/* 2 ------------------------------------------------------------------------------------------- least squares and polish */

static const sp_stage_id bilateral[2] = { SP_STAGE_LEAST_SQUARES, SP_STAGE_DENSE };

TEST(least_squares_accept_a_regular_wall_sparse_and_dense_alike)
{
    sp_result r[2];
    sp_scene s;
    wall(6, 5, 0, &s);
    for (int k = 0; k < 2; k++) {
        const sp_settings set = stages(bilateral[k], SP_STAGE_NONE);
        r[k] = check(&s, &set);
        CHECK_INT(r[k].verdict, SP_STABLE);
        CHECK_TEXT(sp_reason_text(r[k].reason), "forces");
        CHECK_INT(r[k].stage, bilateral[k]);
        CHECK_INT(r[k].spent.total.factorisations, 1);
        CHECK_WITHIN(r[k].imbalance, 0, TOL(1e-13, 1e-5));
    }
    const double most = (double)r[0].extremes.compression;
    for (int32_t k = 0; k < 3 * s.count.points; k++)
        if (!CHECK_WITHIN(r[1].f[k], r[0].f[k], TOL(1e-12, 1e-4) * most)) return;
}

/* They also show what they would say: forces that pull, cut off, leave an imbalance. */
TEST(least_squares_decline_a_wall_that_needs_more)
{
    for (int k = 0; k < 2; k++) {
        sp_scene s;
        const sp_settings set = stages(bilateral[k], SP_STAGE_NONE);
        test_arena.used = 0;
        wall(6, 5, 0.35, &s);
        const sp_result r = check(&s, &set);
        undecided(&s, &r, SP_REASON_STAGES);
        CHECK(r.imbalance > r.tol);
        for (int32_t v = 0; v < s.count.points; v++) CHECK(r.f[3 * v] >= 0);
    }
}

TEST(least_squares_never_say_that_something_falls)
{
    for (int k = 0; k < 2; k++) {
        sp_scene s;
        const sp_settings set = stages(bilateral[k], SP_STAGE_POLISH);
        test_arena.used = 0;
        build("two-cubes", "offset", 0.6, &s);
        const sp_result r = check(&s, &set);
        undecided(&s, &r, SP_REASON_STAGES);
    }
}

static const struct { const char *name, *param; double value; } polishable[] = {
    { "wall", "jitter", 0.35 }, { "arch", "t", 0.2 }, { "h-model", NULL, 0 }, { "keystone", NULL, 0 }, { "rubble", NULL, 0 }
};

TEST(polish_accepts_what_least_squares_cannot)
{
    for (size_t k = 0; k < sizeof polishable / sizeof polishable[0]; k++) {
        sp_scene s;
        sp_evidence e;
        sp_settings set = stages(SP_STAGE_LEAST_SQUARES, SP_STAGE_POLISH);
        test_arena.used = 0;
        build(polishable[k].name, polishable[k].param, polishable[k].value, &s);
        const sp_result r = check(&s, &set);
        CHECK_INT(r.verdict, SP_STABLE);
        CHECK_INT(r.stage, SP_STAGE_POLISH);
        CHECK_TEXT(sp_reason_text(r.reason), "forces");
        CHECK(r.spent.by_stage[1].iterations > 0);
        CHECK_INT(r.spent.by_stage[0].factorisations, 1);
        CHECK_INT(r.spent.by_stage[1].factorisations, 1);
        CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
        CHECK_INT(e.verdict, SP_STABLE);
        CHECK(e.imbalance <= r.tol);
        const sp_result again = check(&s, NULL);
        CHECK_INT(again.verdict, SP_STABLE);
    }
}

/* Friction pyramids are honoured by every stage: at tan(angle) between the two cones only one of them carries. */
TEST(every_stage_knows_the_cone)
{
    static const sp_stage_id id[] = { SP_STAGE_LEAST_SQUARES, SP_STAGE_DENSE, SP_STAGE_POLISH, SP_STAGE_EXACT };
    gen_scene g;
    sp_scene s;
    CHECK_INT(gen_open(&g, "incline"), 1);
    gen_set(&g, "mu", 0.6);
    gen_set(&g, "angle", 28);                           /* tan 28 = .5317; inscribed in four faces .4243, around them .6 */
    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
    for (size_t k = 0; k < sizeof id / sizeof id[0]; k++)
        for (int32_t inscribed = 0; inscribed < 2; inscribed++) {
            sp_settings set = stages(id[k], SP_STAGE_NONE);
            set.faces = 4;
            set.inscribed = inscribed;
            const sp_result r = check(&s, &set);
            CHECK_INT(r.verdict, !inscribed ? SP_STABLE : id[k] == SP_STAGE_EXACT ? SP_UNSTABLE : SP_UNDECIDED);
            CHECK_INT(r.final, 0);
        }
}

/* 3 ------------------------------------------------------------------------------------------------- exact and pyramids */

/* A block slides on a slope when the pull along it exceeds what the pyramid carries in that direction, whatever the shape of
 * the block: tan = mu_eff / max_k d_k.e, e the direction of friction in the joint's frame, d_k at 2 pi k/K. */
static double critical_slope(const sp_scene *s, int32_t K, int inscribed, double mu)
{
    const sp_joint *t = &s->joint[0];
    const double pi = 3.14159265358979323846;
    double e[2] = { 0, 0 }, most = 0;
    for (int c = 0; c < 3; c++) {
        e[0] -= (double)(s->gravity[c] * t->t1[c]);
        e[1] -= (double)(s->gravity[c] * t->t2[c]);
    }
    const double size = sqrt(e[0] * e[0] + e[1] * e[1]);
    for (int32_t k = 0; k < K; k++) {
        const double d = (cos(2 * pi * k / K) * e[0] + sin(2 * pi * k / K) * e[1]) / size;
        if (d > most) most = d;
    }
    return atan((inscribed ? mu * cos(pi / K) : mu) / most) * 180 / pi;
}

TEST(pyramids_of_every_number_of_faces_slide_where_they_should)
{
    static const double turn[] = { 0, 22.5, 40, 131 };
    for (int32_t K = 3; K <= 64; K++)
        for (size_t a = 0; a < sizeof turn / sizeof turn[0]; a++)
            for (int inscribed = 0; inscribed < 2; inscribed++) {
                sp_settings set = sp_settings_default();
                gen_scene g;
                sp_scene s;
                set.faces = K;
                set.inscribed = inscribed;
                set.localise = 0;
                test_arena.used = 0;
                gen_open(&g, "incline");
                gen_set(&g, "mu", 0.6);
                gen_set(&g, "turn", turn[a]);
                CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
                const double limit = critical_slope(&s, K, inscribed, 0.6), m = TOL(1e-6, 2e-3) * limit;
                for (int above = 0; above < 2; above++) {
                    test_arena.used = 0;
                    gen_set(&g, "angle", above ? limit + m : limit - m);
                    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
                    const sp_result r = check(&s, &set);
                    if (!CHECK_INT(r.verdict, above ? SP_UNSTABLE : SP_STABLE))
                        TEST_PRINT("    %d faces, inscribed %d, turn %g, limit %.9g\n", (int)K, inscribed, turn[a], limit);
                    CHECK(!r.final || (above && !inscribed));
                }
            }
}

/* So does the true cone, from whatever side and by whatever margin: a limit is easy from afar and at a hair, and between. */
TEST(a_slide_is_decided_at_every_margin_in_every_direction)
{
    static const double margin[] = { TOL(1e-6, 3e-3), TOL(1e-5, 3e-3), TOL(1e-4, 3e-3), TOL(1e-3, 3e-3),
                                     3e-3, 0.01, 0.03, 0.1, 0.3 };
    static const double height[] = { 0.01, 0.2, 1 };
    const double limit = atan(0.6) * 180 / 3.14159265358979323846;
    for (size_t h = 0; h < 3; h++)
        for (size_t k = 0; k < sizeof margin / sizeof margin[0]; k++) {
            int stable[2] = { 0, 0 }, unstable[2] = { 0, 0 }, runs = 0;
            for (int turn = 0; turn < 180; turn += 7, runs++)
                for (int above = 0; above < 2; above++) {
                    gen_scene g;
                    sp_scene s;
                    sp_settings set = sp_settings_default();
                    set.localise = 0;
                    test_arena.used = 0;
                    gen_open(&g, "incline");
                    gen_set(&g, "mu", 0.6);
                    gen_set(&g, "height", height[h]);
                    gen_set(&g, "turn", turn);
                    gen_set(&g, "angle", limit * (above ? 1 + margin[k] : 1 - margin[k]));
                    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
                    const sp_result r = check(&s, &set);
                    stable[above] += r.verdict == SP_STABLE;
                    unstable[above] += r.verdict == SP_UNSTABLE;
                }
            if (!CHECK_INT(stable[0], runs) || !CHECK_INT(unstable[1], runs))
                TEST_PRINT("    height %g, margin %g\n", height[h], margin[k]);
            CHECK_INT(stable[1] + unstable[0], 0);
        }
}

TEST(exact_needs_no_gates)
{
    static const sp_stage_id order[][2] = { { SP_STAGE_EXACT, SP_STAGE_NONE }, { SP_STAGE_EXACT, SP_STAGE_GATES } };
    for (int k = 0; k < 2; k++)
        for (int floating = 1; floating <= 3; floating++) {
            sp_scene s;
            const sp_settings set = stages(order[k][0], order[k][1]);
            test_arena.used = 0;
            columns(2, floating, &s);
            const sp_result r = check(&s, &set);
            CHECK_INT(r.verdict, SP_UNSTABLE);
        }
}

TEST(an_empty_budget_is_the_reason_not_a_verdict)
{
    static const struct { double t; int32_t iterations; } table[] = { { 0.12, 0 }, { 0.12, 1 }, { 0.09, 0 }, { 0.105, 0 } };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        sp_settings set = sp_settings_default();
        test_arena.used = 0;
        set.localise = 0;
        set.iterations = table[k].iterations;
        build("arch", "t", table[k].t, &s);
        const sp_result r = check(&s, &set);
        undecided(&s, &r, SP_REASON_BUDGET);
        CHECK(r.spent.total.iterations <= set.iterations);
        CHECK(r.spent.total.factorisations <= set.iterations + 2);     /* the bilateral force is found before anything is counted */
        CHECK(r.imbalance > r.tol);
    }
}

TEST(a_budget_is_kept_and_enough_of_it_decides)
{
    sp_scene s;
    sp_settings set = sp_settings_default();
    int decided = 0;
    build("arch", NULL, 0, &s);
    for (set.iterations = 0; set.iterations <= 40; set.iterations++) {
        const size_t mark = test_arena.used;
        const sp_result r = check(&s, &set);
        test_arena.used = mark;
        CHECK(r.spent.by_stage[1].iterations <= set.iterations);
        if (decided) CHECK_INT(r.verdict, SP_STABLE);   /* more never hurts */
        if (r.verdict == SP_UNDECIDED) CHECK_TEXT(sp_reason_text(r.reason), "budget");
        decided |= r.verdict == SP_STABLE;
    }
    CHECK(decided);
}

/* Walls about to fall in their own plane, where Newton stalls: few interior-point iterations on either side of the limit.
 * Steps of the ladder between which it lies were found by bisection and are told by gravity's angle. */
static void leaning(int32_t size, int32_t faces, double angle, sp_verdict want)
{
    gen_scene g;
    sp_scene s;
    sp_settings set = sp_settings_default();
    test_arena.used = 0;
    CHECK_INT(gen_open(&g, "wall"), 1);
    gen_set(&g, "size", size);
    gen_set(&g, "tilt", angle);
    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
    set.localise = 0;
    set.faces = faces;
    const sp_result r = check(&s, &set);
    if (want == SP_UNDECIDED ? r.verdict == SP_STABLE : !CHECK_INT(r.verdict, want)) TEST_PRINT("    %d joints, %g\n", (int)size, angle);
#ifndef SP_NO_IPM
    CHECK(r.spent.total.interior <= 16);
    if (want == SP_UNSTABLE) CHECK(r.spent.total.interior > 0);
#endif
}

/* Pushed along the level with lambda times gravity; the limits are those of linear programmes (tests/oracle), n = 4: 1 / 16. */
static void pushed(const char *name, int n, double lambda, double near)
{
    for (int side = -1; side <= 1; side += 2) {
        gen_scene g;
        sp_scene s;
        sp_settings set = sp_settings_default();
        test_arena.used = 0;
        CHECK_INT(gen_open(&g, name), 1);
        gen_set(&g, "n", n);
        CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
        s.gravity[0] = -s.gravity[2] * (sp_real)(lambda * (1 + side * near));
        set.tol = (sp_real)TOL(1e-12, 1e-6);
        const sp_result r = check(&s, &set);
        if (!CHECK_INT(r.verdict, side < 0 ? SP_STABLE : SP_UNSTABLE)) TEST_PRINT("    %s, side %d\n", name, side);
    }
}

TEST(both_sides_of_a_limit_are_told_a_billionth_from_it)
{
    pushed("arch", 11, 0.05519778886121, TOL(1e-9, 1e-3));
    pushed("overhang", 4, 0.0625, TOL(1e-9, 1e-3));
}

TEST(walls_about_to_fall_in_their_plane_take_few_iterations)
{
#if !defined SP_REAL_FLOAT && !defined SP_NO_IPM
    leaning(500, 0, 31, SP_STABLE);
    leaning(500, 0, 32, SP_UNSTABLE);
    leaning(500, 0, 34, SP_UNSTABLE);
    leaning(500, 8, 30, SP_STABLE);
    leaning(500, 8, 31, SP_UNSTABLE);
    leaning(2000, 0, 26, SP_STABLE);
    leaning(2000, 0, 28, SP_UNSTABLE);
    leaning(2000, 0, 33, SP_UNSTABLE);
#endif
    leaning(150, 0, 40, TOL(SP_UNSTABLE, SP_UNDECIDED));
    leaning(500, 0, 36, TOL(SP_UNSTABLE, SP_UNDECIDED));
}

/* A later stage goes on where an earlier one ran dry. */
TEST(what_runs_dry_leaves_the_rest_to_others)
{
    sp_scene s;
    sp_settings set = stages(SP_STAGE_EXACT, SP_STAGE_POLISH);
    build("arch", "t", 0.2, &s);
    set.iterations = 0;
    const sp_result r = check(&s, &set);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.stage, SP_STAGE_POLISH);
}

/* 4 ---------------------------------------------------------------------------------------------------------- force bound */

TEST(the_force_bound_follows_the_tolerance_unless_given)
{
    static const double tol[] = { 1e-3, TOL(1e-9, 1e-4), TOL(1e-12, 1e-5), TOL(1e-15, 2.5e-7) };
    sp_scene s;
    sp_settings set = sp_settings_default();
    build("two-cubes", NULL, 0, &s);
    for (int k = 0; k < 4; k++) {
        const double most = tol[k] / (10 * (double)SP_EPSILON);
        set.tol = R(tol[k]);
        const sp_result r = check(&s, &set);
        CHECK_NEAR(r.force_bound, most > 1e6 ? 1e6 : most > 4 ? most : 4, 4 * (double)SP_EPSILON);
        CHECK_NEAR(r.tol, tol[k], 4 * (double)SP_EPSILON);
    }
    set.force_bound = 77;
    const sp_result r = check(&s, &set);
    CHECK_WITHIN(r.force_bound, 77, 0);
}

/* Beyond its friction by a factor of two a cube misses balance by mu alone: no tol takes that for standing, short of 4 u. */
TEST(no_tolerance_is_larger_than_what_friction_holds)
{
    static const double mu[] = { 1e-2, 1e-4, TOL(1e-8, 1e-6), TOL(1e-12, 1e-6) };
    for (int k = 0; k < 4; k++)
        for (int beyond = 0; beyond < 2; beyond++) {
            const double least = 4 * (double)SP_EPSILON;
            gen_scene g;
            sp_scene s;
            sp_settings set = sp_settings_default();
            test_arena.used = 0;
            gen_open(&g, "incline");
            gen_set(&g, "angle", 0);
            gen_set(&g, "mu", mu[k]);
            CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
            s.gravity[0] = -s.gravity[2] * R(mu[k]) * (beyond ? 2 : R(0.5));
            set.tol = R(1e-2);
            const sp_result r = check(&s, &set);
            CHECK_INT(r.verdict, beyond ? SP_UNSTABLE : SP_STABLE);
            CHECK_NEAR(r.tol, mu[k] / 8 > least ? mu[k] / 8 : least, 4 * (double)SP_EPSILON);
        }
}

/* A keystone's sides press N = W / (2 (mu cos a - sin a)) each, in four equal corners; the ordinary force, were joints glued,
 * is W / 8 upwards at each of the eight, so caps are 2 W force_bound: it stands for force_bound from
 * sqrt(1 + mu^2) / (16 (mu cos a - sin a)), and that more force would do is no proof that it falls for good. */
TEST(a_keystone_stands_when_the_force_bound_lets_it)
{
    static const double margin[] = { 0.3, 0.03, TOL(0.003, 0.03) };
    const double a = 20 / 57.295779513082320877;
    for (int k = 0; k < 3; k++) {
        const double mu = tan(a) * (1 + margin[k]), bound = sqrt(1 + mu * mu) / (16 * (mu * cos(a) - sin(a)));
        sp_scene s;
        sp_settings set = sp_settings_default();
        test_arena.used = 0;
        build("keystone", "mu", mu, &s);
        set.force_bound = R(1.01 * bound);
        CHECK_INT(check(&s, &set).verdict, SP_STABLE);
        set.force_bound = R(0.99 * bound);
        const sp_result r = check(&s, &set);
        CHECK(r.verdict != SP_STABLE);
        CHECK_INT(r.final, 0);
        set.force_bound = R(0.5 * bound);
        CHECK(check(&s, &set).verdict != SP_STABLE);
    }
}

/* 5 ----------------------------------------------------------------------------------------------------- a stage of one's own */

/* What the custom stage below leaves and says. */
static struct plan {
    const sp_real *f, *dq;                              /* NULL: left as they are */
    double value;                                       /* times f and dq */
    sp_verdict claim;
    sp_reason reason;
    sp_status status;
    size_t takes;                                       /* [byte] */
    int runs;
} plan;

static sp_status custom_run(const sp_problem *problem, const sp_settings *settings, sp_state *state, sp_arena *arena,
                            sp_verdict *claim)
{
    plan.runs++;
    CHECK(settings->force_bound > 0);                   /* resolved */
    CHECK_INT(*claim, SP_UNDECIDED);
    const size_t from = (arena->used + SP_ALIGN - 1) & ~(size_t)(SP_ALIGN - 1);
    if (plan.takes && (from > arena->cap || plan.takes > arena->cap - from)) return SP_E_MEMORY;
    for (size_t k = 0; k < plan.takes; k++) arena->base[from + k] = 0xcc;
    if (plan.takes) arena->used = from + plan.takes;
    if (arena->used > arena->peak) arena->peak = arena->used;
    if (plan.f)
        for (int32_t k = 0; k < 3 * problem->points; k++) state->f[k] = R((double)plan.f[k] * plan.value);
    if (plan.dq)
        for (int32_t k = 0; k < 6 * problem->blocks; k++) state->dq[k] = R((double)plan.dq[k] * plan.value);
    state->reason = plan.reason;
    state->cost.flops += 1000;
    state->cost.iterations += 3;
    *claim = plan.claim;
    return plan.status;
}

static size_t custom_need(const sp_problem *problem, const sp_settings *settings, sp_arena scratch)
{
    (void)problem; (void)settings; (void)scratch;
    return plan.takes;
}

static const sp_stage custom = { custom_run, custom_need };

/* The custom stage alone, or with another after it. */
static sp_settings own(sp_stage_id then)
{
    sp_settings s = stages(SP_STAGE_CUSTOM, then);
    s.custom = &custom;
    return s;
}

static void plan_for(const sp_real *f, const sp_real *dq, double value, sp_verdict claim)
{
    memset(&plan, 0, sizeof plan);
    plan.f = f;
    plan.dq = dq;
    plan.value = value;
    plan.claim = claim;
    plan.reason = claim == SP_UNSTABLE ? SP_REASON_MECHANISM : SP_REASON_FORCES;
}

enum { NUMBERS = 4096 };

/* Forces and, by rows of free blocks, the motion an ordinary check finds. */
static sp_result truth(const sp_scene *s, sp_real *f, sp_real *dq)
{
    const sp_result r = check(s, NULL);
    int32_t row = 0;
    CHECK(3 * s->count.points <= NUMBERS && 6 * s->count.blocks <= NUMBERS);
    memcpy(f, r.f, 3 * (size_t)s->count.points * sizeof *f);
    for (int32_t b = 0; b < s->count.blocks; b++)
        if (s->block[b].fixed != SP_FIXED) memcpy(dq + 6 * row++, r.dq + 6 * b, 6 * sizeof *dq);
    return r;
}

static const struct { const char *name, *param; double value; } subject[] = {
    { "two-cubes", "offset", 0.3 }, { "two-cubes", "offset", 0.6 }, { "arch", "t", 0.14 }, { "arch", "t", 0.09 },
    { "keystone", "mu", 0.5 }, { "incline", "angle", 45 }, { "wall", "jitter", 0.3 }
};
enum { SUBJECTS = sizeof subject / sizeof subject[0] };

TEST(a_stage_that_is_right_is_believed)
{
    for (int k = 0; k < SUBJECTS; k++) {
        static sp_real f[NUMBERS], dq[NUMBERS];
        sp_scene s;
        const sp_settings set = own(SP_STAGE_NONE);
        test_arena.used = 0;
        build(subject[k].name, subject[k].param, subject[k].value, &s);
        const sp_result t = truth(&s, f, dq);
        plan_for(t.verdict == SP_STABLE ? f : NULL, t.verdict == SP_STABLE ? NULL : dq, 1, t.verdict);
        const sp_result r = check(&s, &set);
        CHECK_INT(r.verdict, t.verdict);
        CHECK_INT(r.stage, SP_STAGE_CUSTOM);
        CHECK_INT(r.reason, plan.reason);
        CHECK_INT(r.spent.by_stage[0].iterations, 3);
        CHECK(r.spent.by_stage[0].flops > 1000);              /* the judgement is counted with it */
        CHECK_INT(plan.runs, 1);
        const double most = (double)t.extremes.compression;
        for (int32_t v = 0; plan.f && v < 3 * s.count.points; v++) CHECK_WITHIN(r.f[v], f[v], 8 * (double)SP_EPSILON * most);
        for (int32_t v = 0; plan.dq && v < 6 * s.count.blocks; v++) CHECK_WITHIN(r.dq[v], t.dq[v], 64 * (double)SP_EPSILON);
    }
}

/* The plan alone proves nothing, and does not keep the exact stage after it from the truth. */
static void lie(const sp_scene *s, const sp_result *t, const char *what)
{
    const sp_settings alone = own(SP_STAGE_NONE), first = own(SP_STAGE_EXACT);
    const size_t mark = test_arena.used;
    const sp_result r = check(s, &alone);
    if (!CHECK_INT(r.verdict, SP_UNDECIDED)) TEST_PRINT("    %s\n", what);
    CHECK_INT(r.stage, SP_STAGE_NONE);
    CHECK_INT(r.final, 0);
    if (!CHECK(all_finite(r.f, 3 * s->count.points) && all_finite(r.dq, 6 * s->count.blocks))) TEST_PRINT("    %s\n", what);
    test_arena.used = mark;
    const sp_result q = check(s, &first);
    if (!CHECK_INT(q.verdict, t->verdict)) TEST_PRINT("    exact after %s\n", what);
    CHECK_INT(q.stage, SP_STAGE_EXACT);
    test_arena.used = mark;
}

TEST(a_stage_that_lies_with_forces_is_not_believed)
{
    static const double factor[] = { -1, 0, 0.5, 1.001, 2, 1e6, TOL(1e300, 1e37), INFINITY, NAN };
    for (int k = 0; k < SUBJECTS; k++) {
        static sp_real f[NUMBERS], dq[NUMBERS], g[NUMBERS];
        sp_scene s;
        test_arena.used = 0;
        build(subject[k].name, subject[k].param, subject[k].value, &s);
        const sp_result t = truth(&s, f, dq);
        if (t.verdict == SP_UNSTABLE) {
            plan_for(f, NULL, 1, SP_STABLE);            /* the best attempt is still no answer */
            lie(&s, &t, "its best forces");
            plan_for(NULL, NULL, 1, SP_STABLE);
            lie(&s, &t, "no forces");
        }
        for (size_t i = 0; i < sizeof factor / sizeof factor[0]; i++) {
            plan_for(f, NULL, factor[i], SP_STABLE);
            lie(&s, &t, "scaled forces");
        }
        for (int trial = 0; trial < 20; trial++) {      /* one number spoilt, where it carries */
            const double most = (double)t.extremes.compression > 0 ? (double)t.extremes.compression : 1e4;
            memcpy(g, f, sizeof g);
            int32_t v = test_random_int(0, s.count.points - 1);
            for (int32_t i = 0; i < s.count.points && (double)g[3 * v] < 0.1 * most; i++) v = (v + 1) % s.count.points;
            g[3 * v] = trial % 4 == 0 ? R(NAN) : trial % 4 == 1 ? R(INFINITY) : g[3 * v] + R(most * (trial % 4 == 2 ? 0.1 : -0.1));
            plan_for(g, NULL, 1, SP_STABLE);
            lie(&s, &t, "one spoilt force");
        }
    }
}

TEST(a_stage_that_lies_with_a_motion_is_not_believed)
{
    static const double odd[] = { 0, NAN, INFINITY, -INFINITY, TOL(1e300, 1e37), TOL(1e-300, 1e-37) };
    for (int k = 0; k < SUBJECTS; k++) {
        static sp_real f[NUMBERS], dq[NUMBERS], m[NUMBERS];
        sp_scene s;
        test_arena.used = 0;
        build(subject[k].name, subject[k].param, subject[k].value, &s);
        const sp_result t = truth(&s, f, dq);
        const int32_t n = 6 * t.counts.free_blocks;
        if (t.verdict == SP_UNSTABLE) {
            plan_for(NULL, dq, -1, SP_UNSTABLE);
            lie(&s, &t, "the mechanism reversed");
        }
        for (size_t i = 0; i < sizeof odd / sizeof odd[0]; i++) {
            for (int32_t j = 0; j < n; j++) m[j] = R(odd[i]);
            plan_for(NULL, m, 1, SP_UNSTABLE);
            lie(&s, &t, "an odd motion");
        }
        for (int32_t j = 0; j < n; j++) m[j] = R(j % 6 == 2);
        plan_for(NULL, m, 1, SP_UNSTABLE);
        lie(&s, &t, "all of it rising");
        if (t.verdict == SP_UNSTABLE) continue;         /* by chance a motion might be right */
        plan_for(NULL, m, -1, SP_UNSTABLE);
        lie(&s, &t, "all of it sinking");
        for (int trial = 0; trial < 20; trial++) {
            for (int32_t j = 0; j < n; j++) m[j] = trial % 2 || test_random_int(0, 2) ? test_random_real(-1, 1) : R(0);
            if (trial % 5 == 0) m[test_random_int(0, n - 1)] = R(NAN);
            plan_for(NULL, m, 1, SP_UNSTABLE);
            lie(&s, &t, "a random motion");
        }
    }
}

/* A motion that some would call a mechanism may hide numbers that are none among zeros. */
TEST(a_motion_with_one_number_that_is_none_is_not_believed)
{
    static const double odd[] = { NAN, INFINITY, -INFINITY };
    sp_scene s;
    static sp_real f[NUMBERS], dq[NUMBERS], m[NUMBERS];
    wall(3, 3, 0.3, &s);
    const sp_result t = truth(&s, f, dq);
    for (int32_t j = 0; j < 6 * t.counts.free_blocks; j++)
        for (int i = 0; i < 3; i++) {
            memset(m, 0, sizeof m);
            m[j] = R(odd[i]);
            plan_for(NULL, m, 1, SP_UNSTABLE);
            lie(&s, &t, "one odd number");
        }
}

/* Friction resists a slide of any length: squares of short motions vanish, those of long ones overflow. */
TEST(a_slide_is_resisted_however_short_or_long)
{
    const double a = 20 / 57.295779513082320877;        /* of the slope; mu .84 holds it */
    for (int power = TOL(-300, -36); power <= TOL(300, 36); power += TOL(10, 1)) {
        static sp_real f[NUMBERS], dq[NUMBERS], m[12];
        sp_scene s;
        sp_evidence e;
        test_arena.used = 0;
        build("incline", "angle", 20, &s);
        sp_result t = truth(&s, f, dq);
        CHECK_INT(t.verdict, SP_STABLE);
        memset(m, 0, sizeof m);
        m[0] = R(pow(10, power) * cos(a));
        m[2] = R(pow(10, power) * -sin(a));
        plan_for(NULL, m, 1, SP_UNSTABLE);
        lie(&s, &t, "a slide");
        memset(t.f, 0, 12 * sizeof *t.f);
        memcpy(t.dq + 6, m, 6 * sizeof *m);
        CHECK_INT(sp_verify(&s, NULL, &t, test_arena, &e), SP_OK);
        if (!CHECK_INT(e.verdict, SP_UNDECIDED)) TEST_PRINT("    a slide of 1e%d m\n", power);
    }
}

TEST(a_claim_that_does_not_exist_is_none)
{
    static sp_real f[NUMBERS], dq[NUMBERS];
    sp_scene s;
    build("two-cubes", NULL, 0, &s);
    const sp_result t = truth(&s, f, dq);
    for (int claim = 3; claim < 9; claim += 5) {
        plan_for(f, dq, 0.5, (sp_verdict)claim);
        lie(&s, &t, "a claim of no kind");
    }
}

/* A stage may be too shy: what it leaves is judged all the same when no other comes after it, or the next one decides. */
TEST(evidence_without_a_claim_is_evidence)
{
    for (int k = 0; k < SUBJECTS; k++) {
        static sp_real f[NUMBERS], dq[NUMBERS];
        sp_scene s;
        const sp_settings alone = own(SP_STAGE_NONE), first = own(SP_STAGE_EXACT);
        test_arena.used = 0;
        build(subject[k].name, subject[k].param, subject[k].value, &s);
        const sp_result t = truth(&s, f, dq);
        plan_for(f, dq, 1, SP_UNDECIDED);
        CHECK_INT(check(&s, &alone).verdict, t.verdict);
        CHECK_INT(check(&s, &first).verdict, t.verdict);
    }
}

TEST(gates_after_a_liar_still_see_what_floats)
{
    static sp_real m[NUMBERS];
    const sp_settings set = own(SP_STAGE_GATES);
    for (int trial = 0; trial < 20; trial++) {
        sp_scene s;
        test_arena.used = 0;
        columns(3, 1 + trial % 2, &s);
        for (int32_t j = 0; j < NUMBERS; j++) m[j] = trial < 18 ? test_random_real(-100, 100) : R(trial < 19 ? NAN : INFINITY);
        plan_for(NULL, m, 1, trial % 3 ? SP_UNDECIDED : SP_STABLE);
        const sp_result r = check(&s, &set);
        CHECK_INT(r.verdict, SP_UNSTABLE);
        CHECK_TEXT(sp_reason_text(r.reason), trial % 2 ? "no support" : "no contact");
        CHECK_INT(r.final, 1);
    }
}

/* A reason is part of what is said, and must fit the verdict. */
TEST(reasons_fit_the_verdict_whatever_the_stage_says)
{
    for (int k = 0; k < 2; k++)
        for (int reason = 0; reason <= 7; reason++) {
            static sp_real f[NUMBERS], dq[NUMBERS];
            sp_scene s;
            const sp_settings set = own(SP_STAGE_NONE);
            test_arena.used = 0;
            build("two-cubes", "offset", k ? 0.6 : 0.3, &s);
            const sp_result t = truth(&s, f, dq);
            plan_for(f, dq, 1, t.verdict);
            plan.reason = (sp_reason)reason;
            const sp_result r = check(&s, &set);
            CHECK_INT(r.verdict, t.verdict);
            if (r.verdict == SP_STABLE) CHECK(r.reason == SP_REASON_FORCES || r.reason == SP_REASON_NOTHING);
            else CHECK(r.reason >= SP_REASON_NO_CONTACT && r.reason <= SP_REASON_MECHANISM);
        }
}

/* `r` and `a` as they were before a call that failed. */
static int untouched(const sp_result *r, const sp_arena *a, const sp_arena *before)
{
    unsigned char pattern[sizeof *r];
    memset(pattern, 0x5a, sizeof pattern);
    return CHECK(memcmp(r, pattern, sizeof pattern) == 0) && CHECK(memcmp(a, before, sizeof *a) == 0);
}

TEST(a_stage_without_memory_ends_the_check)
{
    sp_scene s;
    const sp_settings set = own(SP_STAGE_EXACT);
    build("arch", NULL, 0, &s);
    plan_for(NULL, NULL, 1, SP_STABLE);
    plan.status = SP_E_MEMORY;
    const sp_arena before = test_arena;
    sp_result r;
    memset(&r, 0x5a, sizeof r);
    CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_MEMORY);
    untouched(&r, &test_arena, &before);
    CHECK_INT(plan.runs, 1);
}

/* sp_memory asks the stage, sp_check gives what was asked for, and one byte less is too little; twice the stage needs no more
 * than once, because everything is given back in between. */
TEST(a_stage_gets_the_memory_it_needs)
{
    sp_scene s;
    build("two-cubes", NULL, 0, &s);
    for (int twice = 0; twice < 2; twice++) {
        static sp_real f[NUMBERS], dq[NUMBERS];
        sp_settings set = own(twice ? SP_STAGE_CUSTOM : SP_STAGE_NONE);
        size_t bytes = 0, more = 0;
        sp_result r;
        truth(&s, f, dq);
        set.localise = 0;
        plan_for(twice ? NULL : f, NULL, 1, twice ? SP_UNDECIDED : SP_STABLE);
        plan.takes = 100000;
        CHECK_INT(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes), SP_OK);
        plan.takes = 100016;
        CHECK_INT(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &more), SP_OK);
        CHECK_INT(more - bytes, 16);
        plan.takes = 100000;
        NEED(test_arena.cap - test_arena.used > bytes + SP_ALIGN);
        for (size_t less = 0; less < 2; less++) {
            sp_arena a;
            unsigned char *at = test_arena.base + ((test_arena.used + SP_ALIGN - 1) & ~(size_t)(SP_ALIGN - 1));
            at[bytes - less] = 0x77;
            CHECK_INT(sp_arena_init(&a, at, bytes - less), SP_OK);
            CHECK_INT(sp_check(&s, &set, &a, &r), less ? SP_E_MEMORY : SP_OK);
            CHECK_INT(at[bytes - less], 0x77);
            if (!less) CHECK_INT(r.spent.peak_bytes, bytes);
        }
    }
}

static size_t need_unknown(const sp_problem *problem, const sp_settings *settings, sp_arena scratch)
{
    (void)problem; (void)settings; (void)scratch;
    return SIZE_MAX;
}

TEST(a_stage_that_cannot_tell_its_need_says_so)
{
    static const sp_stage silent = { custom_run, need_unknown };
    sp_scene s;
    sp_settings set = own(SP_STAGE_NONE);
    size_t bytes = 7;
    build("two-cubes", NULL, 0, &s);
    set.custom = &silent;
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes), SP_E_MEMORY);
    CHECK_INT(bytes, 7);
}

/* 6 ------------------------------------------------------------------------------------------------------------- refusals */

static void refused(const sp_scene *s, const sp_settings *set, sp_status want, const char *what)
{
    const sp_arena before = test_arena;
    size_t bytes = 7;
    sp_result r;
    memset(&r, 0x5a, sizeof r);
    if (!CHECK_INT(sp_check(s, set, &test_arena, &r), want) || !untouched(&r, &test_arena, &before)) TEST_PRINT("    %s\n", what);
    CHECK_INT(sp_memory(s, SP_FOR_CHECK, set, test_arena, &bytes), want);
    CHECK_INT(bytes, 7);
    sp_evidence e = { SP_STABLE, 1, 2, 3, SP_NONE, 0, 0 };
    memset(&r, 0, sizeof r);
    r.f = &s->point[0][0];                              /* numbers of the right count, whatever they say */
    r.dq = &s->point[0][0];
    CHECK_INT(sp_verify(s, set, &r, test_arena, &e), want);
    CHECK_INT(e.verdict, SP_STABLE);
}

TEST(settings_out_of_range_are_refused_and_nothing_is_touched)
{
    static const double no_tol[] = { 0, -1e-9, TOL(4e-16, 2e-7), 0.11, 1, NAN, INFINITY, -INFINITY };
    static const double no_bound[] = { -1, -1e-30, NAN, INFINITY, -INFINITY };
    static const double no_weight[] = { 0, -1, NAN, INFINITY, -INFINITY };
    static const int32_t no_faces[] = { -1, 1, 2, 65, INT32_MAX, INT32_MIN }, no_count[] = { -1, 0, 7, INT32_MAX, INT32_MIN };
    sp_scene s;
    sp_settings set;
    build("two-cubes", NULL, 0, &s);
#define REFUSE(list, field, number) \
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++) { \
        set = sp_settings_default(); \
        set.field = number(list[k]); \
        refused(&s, &set, SP_E_RANGE, #field); \
    }
    REFUSE(no_tol, tol, R)
    REFUSE(no_bound, force_bound, R)
    REFUSE(no_weight, penalty.gamma, R)
    REFUSE(no_weight, penalty.tau, R)
    REFUSE(no_faces, faces, (int32_t))
    REFUSE(no_count, stage_count, (int32_t))
#undef REFUSE
    set = sp_settings_default();
    set.iterations = -1;
    refused(&s, &set, SP_E_RANGE, "iterations");
}

TEST(stages_that_do_not_exist_are_refused)
{
    static const sp_stage no_run = { NULL, custom_need }, no_need = { custom_run, NULL };
    static const sp_qp_solver nothing = { NULL, NULL, NULL };
    static const int odd[] = { SP_STAGE_NONE, SP_STAGE_CUSTOM + 1, 1000, -1 };
    sp_scene s;
    sp_settings set;
    build("two-cubes", NULL, 0, &s);
    for (size_t k = 0; k < sizeof odd / sizeof odd[0]; k++)
        for (int place = 0; place < 2; place++) {
            set = sp_settings_default();
            set.stage[place] = (sp_stage_id)odd[k];
            refused(&s, &set, SP_E_ARGUMENT, "stage");
        }
    set = own(SP_STAGE_NONE);
    set.custom = NULL;
    refused(&s, &set, SP_E_ARGUMENT, "no custom stage");
    set.custom = &no_run;
    refused(&s, &set, SP_E_ARGUMENT, "no run");
    set.custom = &no_need;
    refused(&s, &set, SP_E_ARGUMENT, "no need");
    set = sp_settings_default();
    set.penalty.solver = &nothing;
    refused(&s, &set, SP_E_ARGUMENT, "no solve");
    set = sp_settings_default();
    set.stage[2] = (sp_stage_id)1000;                   /* beyond the count: not looked at */
    CHECK_INT(check(&s, &set).verdict, SP_STABLE);
}

TEST(settings_at_the_ends_of_their_ranges_are_taken)
{
    sp_scene s;
    build("two-cubes", NULL, 0, &s);
    for (int k = 0; k < 10; k++) {
        sp_settings set = sp_settings_default();
        if (k == 0) set.tol = 4 * SP_EPSILON;
        if (k == 1) set.tol = R(0.1);
        if (k == 2) set.faces = 3;
        if (k == 3) set.faces = 64;
        if (k == 4) set.iterations = INT32_MAX;
        if (k == 5) set.force_bound = R(TOL(1e300, 1e38));
        if (k == 6) set.penalty.gamma = set.penalty.tau = R(1e-6);
        if (k == 7) set.penalty.gamma = set.penalty.tau = R(1e6);
        if (k == 8) set.stage_count = SP_STAGES_MAX;
        for (int i = 0; k == 8 && i < SP_STAGES_MAX; i++) set.stage[i] = i < SP_STAGES_MAX - 1 ? SP_STAGE_GATES : SP_STAGE_EXACT;
        const size_t mark = test_arena.used;
        const sp_result r = check(&s, k == 9 ? NULL : &set);
        test_arena.used = mark;
        if (k) CHECK_INT(r.verdict, SP_STABLE);         /* 4 u is more than rounding may allow */
        else CHECK(r.verdict != SP_UNSTABLE);
    }
}

TEST(arguments_that_are_missing_are_refused)
{
    sp_scene s, none;
    sp_arena empty = { NULL, 0, 0, 0 };
    sp_result r;
    size_t bytes = 7;
    const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 0 };
    build("two-cubes", NULL, 0, &s);
    CHECK_INT(sp_scene_create(&none, &cap, &test_arena), SP_OK);
    memset(&r, 0x5a, sizeof r);
    const sp_arena before = test_arena;
    CHECK_INT(sp_check(NULL, NULL, &test_arena, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, &empty, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, &test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&none, NULL, &test_arena, &r), SP_E_EMPTY);
    CHECK_INT(sp_memory(NULL, SP_FOR_CHECK, NULL, test_arena, &bytes), SP_E_ARGUMENT);
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, empty, &bytes), SP_E_ARGUMENT);
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_memory(&none, SP_FOR_CHECK, NULL, test_arena, &bytes), SP_E_EMPTY);
    CHECK_INT(bytes, 7);
    s.gravity[0] = R(INFINITY);
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
    s.gravity[0] = R(TOL(1e306, 1e36));                 /* the load overflows */
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
    untouched(&r, &test_arena, &before);
}

TEST_LIST(stages)
    RUN(gates_see_a_block_that_touches_nothing)
    RUN(gates_see_a_group_without_support)
    RUN(nothing_to_carry_stands)
    RUN(gates_leave_everything_else_open)
    RUN(gates_never_say_unstable_where_the_exact_stage_says_stable)
    RUN(least_squares_accept_a_regular_wall_sparse_and_dense_alike)
    RUN(least_squares_decline_a_wall_that_needs_more)
    RUN(least_squares_never_say_that_something_falls)
    RUN(polish_accepts_what_least_squares_cannot)
    RUN(every_stage_knows_the_cone)
    RUN(pyramids_of_every_number_of_faces_slide_where_they_should)
    RUN(a_slide_is_decided_at_every_margin_in_every_direction)
    RUN(exact_needs_no_gates)
    RUN(an_empty_budget_is_the_reason_not_a_verdict)
    RUN(a_budget_is_kept_and_enough_of_it_decides)
    RUN(both_sides_of_a_limit_are_told_a_billionth_from_it)
    RUN(walls_about_to_fall_in_their_plane_take_few_iterations)
    RUN(what_runs_dry_leaves_the_rest_to_others)
    RUN(the_force_bound_follows_the_tolerance_unless_given)
    RUN(no_tolerance_is_larger_than_what_friction_holds)
    RUN(a_keystone_stands_when_the_force_bound_lets_it)
    RUN(a_stage_that_is_right_is_believed)
    RUN(a_stage_that_lies_with_forces_is_not_believed)
    RUN(a_stage_that_lies_with_a_motion_is_not_believed)
    RUN(a_motion_with_one_number_that_is_none_is_not_believed)
    RUN(a_slide_is_resisted_however_short_or_long)
    RUN(a_claim_that_does_not_exist_is_none)
    RUN(evidence_without_a_claim_is_evidence)
    RUN(gates_after_a_liar_still_see_what_floats)
    RUN(reasons_fit_the_verdict_whatever_the_stage_says)
    RUN(a_stage_without_memory_ends_the_check)
    RUN(a_stage_gets_the_memory_it_needs)
    RUN(a_stage_that_cannot_tell_its_need_says_so)
    RUN(settings_out_of_range_are_refused_and_nothing_is_touched)
    RUN(stages_that_do_not_exist_are_refused)
    RUN(settings_at_the_ends_of_their_ranges_are_taken)
    RUN(arguments_that_are_missing_are_refused)
TEST_END
