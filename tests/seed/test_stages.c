/* Stages as data: each says only what it can prove, and where it ends. */
#include "../scenes/stages.h"

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
    for (int run = 0; run < SOME_OF(1000, 400); run++) {
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
    CHECK(falls > SOME_OF(100, 40) && stands > SOME_OF(30, 12));
}

/* --------------------------------------------------------------------------------------------- least squares and polish */

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

/* --------------------------------------------------------------------------------------------------- exact and pyramids */

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
    if (test_long) leaning(2000, 0, 26, SP_STABLE);
    if (test_long) leaning(2000, 0, 28, SP_UNSTABLE);
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

/* ------------------------------------------------------------------------------------------------------------ force bound */

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
TEST_END
