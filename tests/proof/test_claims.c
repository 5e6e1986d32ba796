/* Claims made to mislead: forces, motions and hints that are changed, borrowed or hidden prove nothing that is wrong. */
#include "attack.h"

/* ----------------------------------------------------------------------------------------------------- forged claims */

static const struct { const char *name, *param; double value; sp_verdict verdict; } sample[] = {
    { "two-cubes", "offset", 0.3, SP_STABLE }, { "two-cubes", "offset", 0.6, SP_UNSTABLE }, { "arch", "t", 0.14, SP_STABLE },
    { "arch", "t", 0.09, SP_UNSTABLE }, { "incline", "angle", 35, SP_STABLE }, { "incline", "angle", 45, SP_UNSTABLE },
    { "keystone", "mu", 0.5, SP_STABLE }, { "keystone", "mu", 0.3, SP_UNSTABLE }, { "rubble", "rows", 3, SP_STABLE },
    { "wall", "tilt", 42, SP_UNSTABLE }
};
enum { SAMPLES = sizeof sample / sizeof sample[0] };

static int sampled(int k, sp_scene *s, sp_result *r)
{
    generated(sample[k].name, sample[k].param, sample[k].value, s);
    if (!CHECK_INT(sp_check(s, NULL, &test_arena, r), SP_OK)) return 0;
    return TOL(1, 0) ? CHECK_INT(r->verdict, sample[k].verdict) : r->verdict == sample[k].verdict;
}

/* The opposite of the truth is never proved; the truth need not be. */
static int not_wrong(int k, const sp_scene *s, const sp_result *claim)
{
    const sp_verdict got = judged(s, claim, NULL);
    return CHECK(got == SP_UNDECIDED || got == sample[k].verdict);
}

TEST(a_force_changed_by_more_than_tol_is_refused)
{
    const double by = TOL(1e-6, 2e-2);
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!sampled(k, &s, &r) || r.verdict != SP_STABLE) continue;
        for (int32_t c = 0; c < s.count.joints; c++) {
            const int32_t v = s.joint[c].point;     /* a vertex that carries something, with a free block above */
            const sp_real kept = r.f[3 * v];
            if (kept < R(0.05) * r.extremes.compression) continue;
            r.f[3 * v] = R((double)kept + by * (double)r.extremes.compression);
            CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
            r.f[3 * v] = kept;
        }
        for (int32_t j = 0; j < 3 * s.count.points; j++) r.f[j] = R((double)r.f[j] * (1 - 0.1 * by));
        if (TOL(1, 0)) CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
    }
}

/* Balanced forces that pull: a cube hung from above, and one that hangs on at one side. */
TEST(tension_is_no_evidence)
{
    sp_scene s;
    start(&s, 2, 1, 4);
    const int32_t top = body(&s, 0, 0, 0, 3, SP_FIXED), stone = body(&s, 1, 0, 0, 1, 0);
    bed(&s, stone, top, 0, 0, 2, 1, 1, 1e3);
    sp_result r = empty_claim(&s);
    for (int32_t v = 0; v < 4; v++) r.f[3 * v] = R(-9.80665 / 4);
    CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
    verdict_is(&s, SP_UNSTABLE, 1);

    generated("two-cubes", "offset", 0.6, &s);
    r = empty_claim(&s);
    const double weight = (double)s.block[1].mass * 9.80665;
    for (int32_t v = 0; v < 4; v++) {                   /* overlap 0.6 .. 1 in x, centre of weight at 1.1 */
        const int right = s.point[v][0] > R(0.8);
        r.f[3 * v] = R(weight / 2 * (right ? 1.25 : -0.25));
    }
    CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
}

/* Balanced forces beyond the cone: a block on a slope steeper than its friction. */
TEST(friction_beyond_the_cone_is_no_evidence)
{
    for (int beyond = 0; beyond < 2; beyond++) {
        sp_scene s;
        generated("incline", "angle", 30, &s);
        sp_result r = empty_claim(&s);
        NEED(s.count.points == 4);
        const double weight = (double)s.block[s.count.blocks - 1].mass * 9.80665, tan30 = tan(30 / 57.295779513082320877);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        NEED(r.verdict == SP_STABLE);                   /* forces that balance, for mu .84 */
        CHECK(weight > 0);
        CHECK_INT(sp_scene_friction(&s, R(tan30 * (beyond ? 1 - TOL(1e-7, 1e-2) : 1 + TOL(1e-7, 1e-2)))), SP_OK);
        CHECK_INT(judged(&s, &r, NULL), beyond ? SP_UNDECIDED : judged(&s, &r, NULL));
        verdict_is(&s, beyond ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

/* Balanced, in the cone, but beyond the bound on forces. */
TEST(forces_above_the_cap_are_no_evidence)
{
    for (int above = 0; above < 2; above++) {
        sp_scene s;
        sp_settings settings = sp_settings_default();
        settings.force_bound = R(50);
        generated("h-model", "mu", 0.84, &s);
        sp_result r;
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        NEED(r.verdict == SP_STABLE);
        const double weight = (double)s.block[s.count.blocks - 1].mass * 9.80665;
        for (int32_t v = 0; v < s.count.points; v++) r.f[3 * v] += R((above ? 1e4 : 1) * weight);
        CHECK_INT(judged(&s, &r, &settings), above ? SP_UNDECIDED : SP_STABLE);
    }
}

/* Hints of any size, in range and null directions, change no verdict to a wrong one. */
TEST(no_hint_misleads)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!sampled(k, &s, &r)) continue;
        sp_result forged = empty_claim(&s);
        const double step = r.counts.free_blocks > 20 ? TOL(1e60, 1e8) : TOL(1e12, 1e3);
        for (double size = TOL(1e-20, 1e-10); size < TOL(1e250, 1e30); size *= step) {
            for (int32_t i = 0; i < 6 * r.counts.free_blocks; i++) r.y0[i] = test_random_real(-size, size);
            not_wrong(k, &s, &r);
            for (int32_t i = 0; i < 6 * r.counts.free_blocks; i++) r.y0[i] = i % 6 == 0 ? R(size) : 0;         /* all alike */
            not_wrong(k, &s, &r);
            for (int32_t v = 0; v < s.count.points; v++) forged.f[3 * v] = R(size);
            for (int32_t i = 0; i < 6 * r.counts.free_blocks; i++) forged.y0[i] = test_random_real(-size, size);
            if (sample[k].verdict == SP_UNSTABLE) CHECK_INT(judged(&s, &forged, NULL), SP_UNDECIDED);
        }
    }
}

TEST(a_hint_and_a_squeeze_together_hold_nothing)
{
    int told = 0;
    for (double squeeze = 1; squeeze < TOL(1e14, 1e9) && told < 3; squeeze *= 100)
        for (double hint = 1; hint < TOL(1e100, 1e30) && told < 3; hint *= 1e4)
            for (int kind = 0; kind < 3; kind++) {
                sp_scene s;
                generated("h-model", "mu", 0, &s);
                sp_result forged = empty_claim(&s);
                for (int32_t v = 0; v < s.count.points; v++) forged.f[3 * v] = R(squeeze * (double)s.block[2].mass);
                for (int32_t i = 0; i < 6; i++)
                    if (kind == 0 || (kind == 1) == (i < 3)) forged.y0[i] = test_random_real(-hint, hint);
                if (!CHECK_INT(judged(&s, &forged, NULL), SP_UNDECIDED)) {
                    told++;
                    TEST_PRINT("    squeeze %g, hint %g, kind %d\n", squeeze, hint, kind);
                }
            }
}

/* On an edge a block may roll without moving its contacts: a hint along that motion is no force. */
TEST(hints_along_motions_no_contact_feels_do_nothing)
{
    for (double size = 1; size < TOL(1e100, 1e25); size *= 1e3)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int off = 0; off < 2; off++) {
                sp_scene s;
                sp_result r;
                const sp_real n[3] = { 0, 0, 1 }, x[6] = { -1, 0, 0, 1, 0, 0 };
                const sp_strength strength = sp_strength_friction(R(0.5));
                start(&s, 2, 1, 2);
                body(&s, 0, 0, 0, -1, SP_FIXED);
                body(&s, 1, 0, 0.1 * off, 1, 0);
                CHECK_INT(sp_scene_points(&s, 0, 1, n, 2, x, &strength, NULL), SP_OK);
                NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
                CHECK_INT(r.verdict, off ? SP_UNSTABLE : SP_STABLE);
                for (int i = 0; i < 6; i++) r.y0[i] = 0;
                r.y0[1] = R(sign * size);               /* roll about the edge: v = w x (c - edge) */
                r.y0[2] = R(-0.1 * off * sign * size);
                r.y0[3] = R(-sign * size);
                CHECK(judged(&s, &r, NULL) != (off ? SP_STABLE : SP_UNSTABLE));
                for (int v = 0; v < 2; v++) r.f[3 * v] = R(9.80665 / 2 * (off ? 1 : 3));
                CHECK_INT(judged(&s, &r, NULL), off ? judged(&s, &r, NULL) : SP_UNDECIDED);
                CHECK(judged(&s, &r, NULL) != SP_STABLE);
            }
}

/* Motions that are none, or of supports, or that contacts forbid; any of them against a scene that stands. */
TEST(motions_that_prove_nothing)
{
    for (int k = 0; k < SAMPLES; k++)
        for (int kind = 0; kind < 6; kind++) {
            sp_scene s;
            sp_result r;
            if (!sampled(k, &s, &r)) continue;
            for (int32_t j = 0; j < 3 * s.count.points; j++) r.f[j] = 0;
            for (int32_t b = 0; b < s.count.blocks; b++)
                for (int c = 0; c < 6; c++) {
                    sp_real *x = &r.dq[6 * b + c];
                    if (kind == 0) *x = 0;
                    else if (kind == 1) *x = R(c == 0);                             /* all of it sideways */
                    else if (kind == 2) *x = R(c == 2);                             /* up */
                    else if (kind == 3) *x = R(c == 2 ? -1 : 0);                    /* down, into the ground */
                    else if (kind == 4) *x = s.block[b].fixed ? R(-1) : 0;          /* supports only */
                    else *x = -*x;                                                  /* the mechanism, backwards */
                }
            if (kind == 1 || kind == 3) not_wrong(k, &s, &r);                       /* may be one */
            else CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
        }
}

/* Tiny motions of other blocks, from rounding: the mechanism still proves, and a standing scene gets none. */
TEST(tiny_motions_elsewhere_change_no_proof)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        double largest = 0;
        if (!sampled(k, &s, &r)) continue;
        sp_result forged = empty_claim(&s);
        const int32_t n = 6 * s.count.blocks;
        for (int32_t j = 0; j < n; j++) largest = fmax(largest, fabs((double)r.dq[j]));
        if (!(largest > 0)) largest = 1;
        for (double size = TOL(1e-14, 1e-8) * largest; size < 1e3 * largest; size *= TOL(100, 10)) {
            for (int32_t j = 0; j < n; j++) forged.dq[j] = R((double)r.dq[j] + (double)test_random_real(-size, size));
            not_wrong(k, &s, &forged);
            for (int32_t b = 0; b < s.count.blocks; b++) {              /* now only blocks that rest, as a whole */
                double moves = 0;
                for (int32_t j = 6 * b; j < 6 * b + 6; j++) moves += fabs((double)r.dq[j]);
                for (int32_t j = 6 * b; j < 6 * b + 6 && moves > 0; j++) forged.dq[j] = r.dq[j];
            }
            if (size < 1e-6 * largest && r.verdict == SP_UNSTABLE) CHECK_INT(judged(&s, &forged, NULL), SP_UNSTABLE);
        }
    }
}

/* Forces and motions of another scene with the same shape. */
TEST(evidence_of_another_scene_is_refused)
{
    static const struct { const char *name, *param; double good, bad; } pair[] = {
        { "two-cubes", "offset", 0.4, 0.6 }, { "incline", "angle", 35, 45 }, { "arch", "t", 0.14, 0.09 },
        { "keystone", "mu", 0.5, 0.3 }, { "wall", "tilt", 10, 42 }
    };
    for (size_t k = 0; k < sizeof pair / sizeof pair[0]; k++) {
        sp_scene good, bad;
        sp_result stands, falls;
        gen_scene g;
        generated(pair[k].name, pair[k].param, pair[k].good, &good);
        gen_open(&g, pair[k].name);
        gen_set(&g, pair[k].param, pair[k].bad);
        NEED(gen_build(&g, &test_arena, &bad) == SP_OK);
        NEED(sp_check(&good, NULL, &test_arena, &stands) == SP_OK);
        NEED(sp_check(&bad, NULL, &test_arena, &falls) == SP_OK);
        CHECK_INT(judged(&bad, &stands, NULL), SP_UNDECIDED);
        if (falls.verdict == SP_UNSTABLE) CHECK(judged(&good, &falls, NULL) != SP_UNSTABLE);
    }
}

/* ----------------------------------------------------------------------------------------------------- random scenes */

/* A small scene of random kind and numbers: tilt, weights and friction too. */
static void anything(sp_scene *s)
{
    static const struct { const char *name, *a; double a0, a1; const char *b; double b0, b1; } kind[] = {
        { "wall", "rows", 1, 4, "jitter", 0, 0.4 },     { "rubble", "rows", 1, 3, "jitter", 0, 1 },
        { "arch", "n", 3, 15, "t", 0.05, 0.3 },         { "flat-arch", "n", 2, 9, "half", 0, 40 },
        { "vault", "around", 3, 9, "t", 0.05, 0.3 },    { "dome", "rings", 1, 3, "t", 0.05, 0.2 },
        { "diamond", "rows", 1, 5, "height", 0.1, 1 },  { "tower", "n", 1, 12, "lean", 0, 0.2 },
        { "overhang", "n", 1, 8, "factor", 0.5, 1.2 }
    };
    gen_scene g;
    const int k = (int)test_random_int(0, 8);
    test_arena.used = 0;
    CHECK_INT(gen_open(&g, kind[k].name), 1);
    CHECK_INT(gen_set(&g, kind[k].a, test_random_int((int32_t)kind[k].a0, (int32_t)kind[k].a1)), 1);
    CHECK_INT(gen_set(&g, kind[k].b, (double)test_random_real(kind[k].b0, kind[k].b1)), 1);
    if (k == 0 || k == 1) gen_set(&g, "bricks", test_random_int(1, 5));
    if (k == 4) gen_set(&g, "n", test_random_int(1, 3));
    if (k == 5) gen_set(&g, "segments", test_random_int(4, 9));
    gen_set(&g, "tilt", test_random_int(0, 2) ? 0 : (double)test_random_real(0, 60));
    gen_set(&g, "azimuth", (double)test_random_real(-180, 180));
    CHECK_INT(gen_build(&g, &test_arena, s), SP_OK);
    for (int32_t b = 0; b < s->count.blocks; b++) s->block[b].mass *= R(pow(10, (double)test_random_real(-2, 2)));
    for (int32_t j = 0; j < s->count.joints; j++) s->joint[j].strength.mu = test_random_real(0, 1.2);
}

TEST(random_scenes_have_evidence_that_holds_with_and_without_hint)
{
    for (int k = 0; k < 60; k++) {
        sp_scene s;
        sp_settings settings = sp_settings_default();
        sp_result r;
        anything(&s);
        if (k % 3 == 1) settings.faces = test_random_int(3, 16), settings.inscribed = test_random_int(0, 1);
        CHECK_INT(checked(&s, &settings, &r), SP_OK);
    }
}

TEST(random_scenes_take_exactly_their_memory)
{
    for (int k = 0; k < 40; k++) {
        sp_scene s;
        sp_settings settings = sp_settings_default();
        sp_result r;
        size_t bytes = 0;
        anything(&s);
        settings.faces = k % 2 ? 0 : test_random_int(3, 64);
        settings.localise = test_random_int(0, 1);
        static const sp_stage_id more[] = { SP_STAGE_LEAST_SQUARES, SP_STAGE_DENSE, SP_STAGE_POLISH };
        if (k % 4 == 3) {
            settings.stage[1] = more[test_random_int(0, 1)];
            settings.stage[2] = SP_STAGE_POLISH;
            settings.stage[3] = SP_STAGE_EXACT;
            settings.stage_count = 4;
            settings.effect[SP_EFFECT_DEPTH] = settings.effect[SP_EFFECT_FRICTION] = SP_WITH;
        }
        NEED(sp_memory(&s, SP_FOR_CHECK, &settings, test_arena, &bytes) == SP_OK);
        NEED(bytes > 0 && bytes < test_arena.capacity - test_arena.used);
        sp_arena a = test_arena;
        a.capacity = a.used + bytes;
        a.peak = a.used;
        CHECK_INT(sp_check(&s, &settings, &a, &r), SP_OK);
        if (settings.stage_count == 4 && r.stage != SP_STAGE_EXACT) {   /* decided before the search, which takes more, was asked */
            CHECK(r.spent.peak_bytes <= test_arena.used + bytes);
            bytes = r.spent.peak_bytes - test_arena.used;
        } else CHECK_INT(r.spent.peak_bytes, test_arena.used + bytes);
        a = test_arena;
        a.capacity = a.used + bytes - 1;
        const size_t used = a.used;
        CHECK_INT(sp_check(&s, &settings, &a, &r), SP_E_MEMORY);
        CHECK_INT(a.used, used);
    }
}

TEST_LIST(claims)
    RUN(a_force_changed_by_more_than_tol_is_refused)
    RUN(tension_is_no_evidence)
    RUN(friction_beyond_the_cone_is_no_evidence)
    RUN(forces_above_the_cap_are_no_evidence)
    RUN(no_hint_misleads)
    RUN(a_hint_and_a_squeeze_together_hold_nothing)
    RUN(hints_along_motions_no_contact_feels_do_nothing)
    RUN(motions_that_prove_nothing)
    RUN(tiny_motions_elsewhere_change_no_proof)
    RUN(evidence_of_another_scene_is_refused)
    RUN(random_scenes_have_evidence_that_holds_with_and_without_hint)
    RUN(random_scenes_take_exactly_their_memory)
TEST_END
