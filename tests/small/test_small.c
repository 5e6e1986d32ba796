/* small: what a build with SP_SMALL leaves out, it refuses; every other build does it. What it has, it does. */
#include "../test.h"
#include "../scenes/gen.h"

#include <string.h>

#ifdef SP_SMALL
#define LEFT_OUT SP_E_UNSUPPORTED
#else
#define LEFT_OUT SP_OK
#endif

static void arch(sp_scene *s)
{
    gen_scene g;
    NEED(gen_open(&g, "arch"));
    NEED(gen_build(&g, &test_arena, s) == SP_OK);
}

/* The check, the size of its memory and the verification agree on what they take. */
static void answered(const sp_scene *s, const sp_settings *set, sp_status want)
{
    sp_arena a = test_arena;
    sp_result r, claim;
    sp_evidence e;
    size_t bytes = 0;
    memset(&claim, 0, sizeof claim);
    claim.f = &s->point[0][0];
    claim.dq = &s->point[0][0];
    CHECK_INT(sp_check(s, set, &a, &r), want);
    CHECK_INT(sp_memory(s, SP_FOR_CHECK, set, test_arena, &bytes), want);
    CHECK_INT(sp_verify(s, set, &claim, test_arena, &e), want);
}

TEST(the_default_settings_are_taken_by_every_build)
{
    sp_scene s;
    arch(&s);
    answered(&s, NULL, SP_OK);
}

TEST(pyramids_and_the_tables_of_the_seed_are_refused_by_the_smallest_build)
{
    sp_scene s;
    sp_settings set = sp_settings_default();
    arch(&s);
    set.faces = 8;
    answered(&s, &set, LEFT_OUT);
    set.faces = 0;
    sp_seed table;
    memset(&table, 0, sizeof table);
    CHECK((sp_seed_table() == NULL) == TEST_SMALL);
    if (sp_seed_table()) table = *sp_seed_table();
    set.seed = &table;
    answered(&s, &set, LEFT_OUT);
#if !defined SP_NO_QP && !defined SP_NO_ADMM
    set = sp_settings_seed();
    answered(&s, &set, LEFT_OUT);
#endif
}

TEST(stages_but_gates_and_the_exact_one_are_refused_by_the_smallest_build)
{
    static const sp_stage_id other[] = { SP_STAGE_LEAST_SQUARES, SP_STAGE_DENSE, SP_STAGE_POLISH };
    sp_scene s;
    sp_settings set = sp_settings_default();
    arch(&s);
    for (size_t k = 0; k < sizeof other / sizeof other[0]; k++) {
        set.stage[1] = other[k];
        answered(&s, &set, LEFT_OUT);
    }
}

TEST(strength_of_joints_is_refused_by_the_smallest_build)
{
    sp_scene s;
    arch(&s);
    s.joint[0].strength.cohesion = 1000;
    answered(&s, NULL, LEFT_OUT);
}

TEST(budgets_and_effects_left_out_are_refused_by_the_smallest_build)
{
    sp_scene s;
    sp_settings set = sp_settings_default();
    arch(&s);
    set.budget = INT64_MAX;
    answered(&s, &set, LEFT_OUT);
    set.budget = 0;
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) {
#ifdef SP_NO_PLAN
        if (k == SP_EFFECT_DEPTH) continue;
#endif
        set.effect[k] = SP_WITHOUT;
        answered(&s, &set, LEFT_OUT);
        set.effect[k] = SP_WITH;
        answered(&s, &set, SP_OK);
        set.effect[k] = SP_PLANNED;
    }
}

/* What the smallest build does not know it does not look into: there it is left out, not wrong. */
TEST(what_is_wrong_in_what_is_left_out_is_refused_too)
{
    sp_scene s;
    sp_settings set = sp_settings_default();
    arch(&s);
    set.faces = 2;
    answered(&s, &set, TEST_SMALL ? SP_E_UNSUPPORTED : SP_E_RANGE);
    set.faces = 0;
    set.budget = -1;
    answered(&s, &set, TEST_SMALL ? SP_E_UNSUPPORTED : SP_E_RANGE);
    set.budget = 0;
    set.stage[1] = SP_STAGE_CUSTOM;
    answered(&s, &set, TEST_SMALL ? SP_E_UNSUPPORTED : SP_E_ARGUMENT);
    set = sp_settings_default();
    memset(&set.effect[SP_EFFECT_TOGETHER], 7, 1);
    answered(&s, &set, TEST_SMALL ? SP_E_UNSUPPORTED : SP_E_ARGUMENT);
}

/* The result in one arena and all else in another, each of the size that is told and no byte more than was said. */
TEST(what_a_check_works_in_may_be_another_arena)
{
    sp_scene s;
    sp_arena kept = test_arena, work;
    sp_settings set = sp_settings_default();
    sp_result r;
    size_t bytes[2] = { 0, 0 };
    arch(&s);
    set.work = &work;
    memset(&work, 0, sizeof work);
    memset(&r, 0, sizeof r);
    NEED(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes[0]) == SP_OK);
    NEED(sp_memory(&s, SP_FOR_WORK, &set, test_arena, &bytes[1]) == SP_OK);
    kept.base += (test_arena.used + 15) & ~(size_t)15;
    kept.used = kept.peak = 0;
    kept.capacity = bytes[0];
    work = kept;
    work.base += (bytes[0] + 15) & ~(size_t)15;
    work.capacity = bytes[1] - 1;
    CHECK_INT(sp_check(&s, &set, &kept, &r), SP_E_MEMORY);
    work.capacity = bytes[1];
    CHECK_INT(sp_check(&s, &set, &kept, &r), SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK(work.used == 0 && work.peak == bytes[1] && kept.peak == bytes[0] && r.spent.peak_bytes == bytes[0]);
    set.work = &kept;
    CHECK_INT(sp_check(&s, &set, &kept, &r), SP_E_ARGUMENT);
}

#if !defined SP_NO_PLAN && defined SP_SMALL
TEST(a_plan_of_the_smallest_search_tells_its_bytes_and_takes_all_effects)
{
    sp_scene s;
    sp_outlook o;
    size_t bytes = 0;
    arch(&s);
    NEED(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes) == SP_OK);
    sp_arena scratch = test_arena;
    scratch.base += (scratch.used + 15) & ~(size_t)15;
    scratch.used = 0;
    scratch.capacity = test_bytes(&s, SP_FOR_PLAN, NULL);
    NEED(sp_plan(&s, NULL, scratch, &o) == SP_OK);
    CHECK_INT(o.bytes, bytes);
    CHECK_INT(o.islands, 1);
    CHECK(o.flops > 0 && o.unknowns > 0);
    CHECK_INT(o.effect[SP_EFFECT_FRICTION].why, SP_WHY_CALLED);
    CHECK_INT(o.effect[SP_EFFECT_STRENGTH].why, SP_WHY_ABSENT);
    CHECK_INT(o.effect[SP_EFFECT_DYNAMICS].why, SP_WHY_STATICS);
}
#endif

/* The arena that sp_memory tells, all of it and, where no gate decides, no byte less; then a result that verifies. */
static void fits(const sp_scene *s, sp_verdict want, int tight)
{
    const size_t mark = test_arena.used;
    size_t bytes = 0;
    sp_result r;
    sp_evidence e;
    memset(&r, 0, sizeof r);
    NEED(sp_memory(s, SP_FOR_CHECK, NULL, test_arena, &bytes) == SP_OK);
    sp_arena a = test_arena;
    a.base += (a.used + 15) & ~(size_t)15;
    a.used = a.peak = 0;
    a.capacity = bytes - (size_t)tight;
    if (tight) CHECK_INT(sp_check(s, NULL, &a, &r), SP_E_MEMORY);
    CHECK(a.used == 0 && r.f == NULL);
    a.capacity = bytes;
    NEED(sp_check(s, NULL, &a, &r) == SP_OK);
    CHECK(a.peak == r.spent.peak_bytes && a.peak <= bytes && a.peak >= (tight ? bytes : 0) && a.used < bytes);
    CHECK(bytes <= SP_MEMORY_BYTES(s->count.blocks, s->count.joints, s->count.points, 0));
    CHECK_INT(r.verdict, want);
    test_arena.used = ((mark + 15) & ~(size_t)15) + bytes;
    NEED(sp_verify(s, NULL, &r, test_arena, &e) == SP_OK);
    CHECK_INT(e.verdict, want);
    CHECK_NEAR(e.imbalance, r.imbalance, 1e-6);
    test_arena.used = mark;
}

TEST(memory_of_a_check_is_exact_and_its_evidence_verifies)
{
    static const double tilt[] = { 0, 20 };
    for (int k = 0; k < 2; k++) {
        gen_scene g;
        sp_scene s;
        NEED(gen_open(&g, "wall"));
        gen_set(&g, "rows", 3);
        gen_set(&g, "bricks", 3);
        gen_set(&g, "azimuth", 90);
        gen_set(&g, "tilt", tilt[k]);
        NEED(gen_build(&g, &test_arena, &s) == SP_OK);
        fits(&s, k ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

/* A stone that nothing touches falls, one that nothing pulls stands, and supports alone stand. */
TEST(stones_without_contact_load_or_freedom_are_told)
{
    for (int k = 0; k < 3; k++) {
        const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 0 };
        const sp_real at[3] = { 1, 2, 3 };
        sp_scene s;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        NEED(sp_scene_body(&s, 5, at, k == 2 ? SP_FIXED : 0, NULL) == SP_OK);
        if (k == 1) s.gravity[0] = s.gravity[1] = s.gravity[2] = 0;
        fits(&s, k ? SP_STABLE : SP_UNSTABLE, LEFT_OUT != SP_OK && k < 2);
    }
}

/* Two stones on each other by many joints, loose ones beside them: an island that has nearly everything. */
TEST(a_pile_with_many_joints_and_loose_stones_fits_into_memory_by_counts)
{
    for (int32_t k = 0; k < 120; k++) {
        const int32_t loose = k % 4, each = 10 * (k / 4), corners = k % 3 ? 3 : 9;
        const sp_capacity cap = { 3 + loose, 0, 0, 0, 2 * each + loose, corners * (2 * each + loose), 0 };
        const sp_strength strength = sp_strength_friction(R(0.6));
        const sp_real up[3] = { 0, 0, 1 };
        size_t bytes = 0;
        sp_scene s;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        for (int32_t b = 0; b < 3 + loose; b++) {
            const sp_real c[3] = { R(b > 2 ? 3 * b : 0), 0, R(b > 2 ? 0.5 : b - 0.5) };
            NEED(sp_scene_body(&s, 1000, c, b ? 0 : SP_FIXED, NULL) == SP_OK);
        }
        for (int32_t q = 0; q < 2 * each + loose; q++) {
            const int32_t b = q < 2 * each ? 1 + q % 2 : 3 + q - 2 * each;
            sp_real xyz[27];
            for (int c = 0; c < 9; c++) {
                xyz[3 * c] = test_random_real(-0.5, 0.5) + s.block[b].centroid[0];
                xyz[3 * c + 1] = test_random_real(-0.5, 0.5);
                xyz[3 * c + 2] = b == 2;
            }
            NEED(sp_scene_points(&s, b == 2, b, up, corners, xyz, &strength, NULL) == SP_OK);
        }
        NEED(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes) == SP_OK);
        if (!CHECK(bytes <= SP_MEMORY_BYTES(s.count.blocks, s.count.joints, s.count.points, 0)))
            TEST_PRINT("  %d loose, %d joints each of %d: %lu\n", (int)loose, (int)each, (int)corners, (unsigned long)bytes);
    }
}

/* Three stones on each other that weigh nothing, a force on the lowest: no forces found leave the upper ones balanced. */
TEST(a_motion_is_of_numbers_where_nothing_balances_what_bears_no_load)
{
    static double memory[4000];
    const sp_capacity room = { 4, 0, 0, 0, 3, 12, 1 };
    const sp_strength dry = sp_strength_friction((sp_real)0.5);
    const sp_load load = { .block = 1, .force = { 0, -2, -7 }, .point = { (sp_real)-0.5, (sp_real)-0.2, (sp_real)0.4 } };
    sp_arena arena;
    sp_scene scene;
    sp_result result;
    memset(memory, 0xff, sizeof memory);                                        /* NaNs: what is not written is seen */
    NEED(!sp_arena_init(&arena, memory, sizeof memory) && !sp_scene_create(&scene, &room, &arena));
    scene.gravity[2] = 0;
    for (int32_t b = 0; b < 4; b++) {
        const sp_real middle[3] = { 0, 0, (sp_real)0.5 * (sp_real)b }, h = (sp_real)0.5, z = middle[2] - (sp_real)0.25;
        const sp_real corner[12] = { -h, -h, z, h, -h, z, h, h, z, -h, h, z };
        CHECK_INT(sp_scene_body(&scene, 1000, middle, b ? 0 : SP_FIXED, NULL), SP_OK);
        if (b) CHECK_INT(sp_scene_joint(&scene, b - 1, b, 4, corner, &dry, NULL), SP_OK);
    }
    CHECK_INT(sp_scene_load(&scene, &load, NULL), SP_OK);
    CHECK_INT(sp_check(&scene, NULL, &arena, &result), SP_OK);
    for (int k = 0; k < 24; k++) CHECK(result.dq[k] - result.dq[k] == 0);
    sp_evidence evidence;
    CHECK_INT(sp_verify(&scene, NULL, &result, test_arena, &evidence), SP_OK);
}

/* Stones one after the other between two supports: rows of the first are 1 to 6 numbers of the envelope long, of others 7 to 12. */
#if !defined SP_NO_PLAN && defined SP_SMALL
TEST(a_plan_counts_the_squares_of_the_rows_of_the_envelope)
{
    for (int n = 4; n < 9; n++) {
        sp_scene s;
        sp_outlook o;
        test_arena.used = 0;
        NEED(gen_make("arch", "n", n, &test_arena, &s) == SP_OK);
        NEED(sp_plan(&s, NULL, test_arena, &o) == SP_OK);
        CHECK_INT(o.unknowns, 6 * n + 3 * 4 * (n + 1));
        CHECK_INT(o.flops, 5 * (91 + 559 * (n - 1)) + 20 * 900 * 4 * (n + 1));
        CHECK(o.full_unknowns == o.unknowns && o.full_flops == o.flops && o.full_bytes == o.bytes);
        CHECK_INT(o.islands, 1);
        for (int k = 0; k < SP_EFFECTS; k++) CHECK(o.effect[k].unknowns == 0 && o.effect[k].flops == 0 && o.effect[k].bytes == 0);
        CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_NOT_ASKED);
        CHECK_INT(o.effect[SP_EFFECT_DYNAMICS].why, SP_WHY_STATICS);
        CHECK_INT(sp_plan(&s, NULL, test_arena, NULL), SP_E_ARGUMENT);
    }
}

TEST(a_plan_of_one_stone_or_of_supports_alone_has_an_island_or_none)
{
    for (int k = 0; k < 2; k++) {
        const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 0 };
        const sp_real at[3] = { 1, 2, 3 };
        sp_scene s;
        sp_outlook o;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        NEED(sp_scene_body(&s, 5, at, k ? SP_FIXED : 0, NULL) == SP_OK);
        NEED(sp_plan(&s, NULL, test_arena, &o) == SP_OK);
        CHECK_INT(o.islands, k ? 0 : 1);
        CHECK_INT(o.unknowns, k ? 0 : 6);
        CHECK_INT(o.flops, k ? 0 : 5 * 91);
    }
}
#endif

/* Scratch of which sp_memory itself takes as much as is told, for any number of blocks. */
TEST(the_bytes_that_asking_for_memory_takes_are_enough)
{
    for (int32_t n = 1; n < 6; n++) {
        const sp_capacity cap = { n, 0, 0, 0, 0, 0, 0 };
        sp_scene s;
        size_t bytes = 0;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        for (int32_t b = 0; b < n; b++) {
            const sp_real at[3] = { R(b), 0, 0 };
            CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
        }
        sp_arena scratch = test_arena;
        scratch.base += (scratch.used + 15) & ~(size_t)15;
        scratch.used = 0;
        scratch.capacity = sp_memory_scratch(&s, SP_FOR_CHECK, NULL);
        CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, scratch, &bytes), SP_OK);
        CHECK_INT(sp_memory(&s, SP_FOR_WORK, NULL, scratch, &bytes), SP_OK);
        for (; scratch.capacity > 64; scratch.capacity -= 8) {      /* with less the same, or a refusal */
            size_t told = 0;
            const sp_status status = sp_memory(&s, SP_FOR_WORK, NULL, scratch, &told);
            CHECK(status ? status == SP_E_MEMORY && told == 0 : told == bytes);
        }
    }
}

#ifdef SP_SMALL
/* The first of many stones touches all others: their rows begin at its first number, 18 n^2 + 3 n numbers. */
TEST(an_envelope_too_large_to_count_is_refused)
{
    const sp_real corner[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
    const sp_strength dry = sp_strength_friction((sp_real)0.5);
    for (int32_t n = 10922; n < 10924; n++) {
        const sp_capacity cap = { n, 0, 0, 0, n - 1, 3 * (n - 1), 0 };
        sp_scene s;
        size_t bytes = 7;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        for (int32_t b = 0; b < n; b++) {
            const sp_real at[3] = { 0, 0, b ? 1 : -1 };
            if (sp_scene_body(&s, 1, at, 0, NULL) || (b && sp_scene_joint(&s, 0, b, 3, corner, &dry, NULL))) break;
        }
        NEED(s.count.blocks == n && s.count.joints == n - 1);
        CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes), n < 10923 ? SP_OK : SP_E_MEMORY);
        CHECK((bytes == 7) == (n == 10923));
    }
}
#endif

TEST(what_is_no_question_is_refused_and_the_result_untouched)
{
    sp_scene s, none;
    sp_arena a = test_arena, empty;
    sp_result r;
    sp_settings set = sp_settings_default();
    size_t bytes = 7;
    arch(&s);
    a = test_arena;
    memset(&empty, 0, sizeof empty);
    memset(&r, 7, sizeof r);
    none = s;
    none.count.blocks = 0;
    CHECK_INT(sp_check(NULL, NULL, &a, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, &empty, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, NULL, &a, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&none, NULL, &a, &r), SP_E_EMPTY);
    set.work = &empty;
    CHECK_INT(sp_check(&s, &set, &a, &r), SP_E_ARGUMENT);
    set.work = NULL;
    set.tol = -1;
    CHECK_INT(sp_check(&s, &set, &a, &r), SP_E_RANGE);
    CHECK(a.used == test_arena.used && r.counts.free_blocks == 0x07070707);
    for (int k = SP_FOR_CHECK; k <= SP_FOR_WORK; k++) {
        CHECK_INT(sp_memory(NULL, (sp_memory_for)k, NULL, test_arena, &bytes), SP_E_ARGUMENT);
        CHECK_INT(sp_memory(&s, (sp_memory_for)k, NULL, empty, &bytes), SP_E_ARGUMENT);
        CHECK_INT(sp_memory(&s, (sp_memory_for)k, NULL, test_arena, NULL), SP_E_ARGUMENT);
        CHECK_INT(sp_memory(&none, (sp_memory_for)k, NULL, test_arena, &bytes), SP_E_EMPTY);
        CHECK_INT(sp_memory(&s, (sp_memory_for)k, &set, test_arena, &bytes), SP_E_RANGE);
    }
    CHECK_INT(bytes, 7);
    CHECK_INT(sp_memory_scratch(NULL, SP_FOR_CHECK, NULL), 0);
}

#ifdef SP_SMALL
/* Each in an arena that remembers: what nobody writes is seen. */
TEST(all_that_a_result_tells_is_written)
{
    static const struct { const char *name, *number; double value; sp_verdict verdict; sp_reason reason; } is[] = {
        { "two-cubes", "offset", 0.3, SP_STABLE, SP_REASON_FORCES }, { "two-cubes", "offset", 0.6, SP_UNSTABLE, SP_REASON_MECHANISM }
    };
    for (int k = 0; k < 2; k++) {
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        NEED(gen_make(is[k].name, is[k].number, is[k].value, &test_arena, &s) == SP_OK);
        memset(test_arena.base + test_arena.used, 0xff, 20000);
        memset(&r, 0xff, sizeof r);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK(r.verdict == is[k].verdict && r.reason == is[k].reason && r.stage == SP_STAGE_EXACT && r.verified == 1);
        CHECK_INT(r.level, k ? SP_NONE : SP_ADMISSIBLE);
        CHECK_INT(r.final, k);
        CHECK(r.counts.free_blocks == 1 && r.counts.joints == 1 && r.counts.points == 4 && r.islands.count == 1);
        CHECK(r.extremes.weakest == -1 && r.extremes.tension_ratio == -1 && r.coupled.tension_ratio == -1);
        CHECK(r.tol > 0 && r.tol < R(1e-3) && r.force_bound > 1);
        CHECK(r.spent.total.iterations == k && r.spent.total.factorisations == 1 + k && r.spent.total.flops > 0);
        CHECK(r.demand[0].tension == 0 && r.demand[0].friction == 0);
        for (int c = 0; c < 6; c++) CHECK(r.dq[c] == 0);
        for (int c = 6; c < 12 && !k; c++) CHECK(r.dq[c] == 0);
        for (int c = 0; c < 12; c++) CHECK(r.f[c] - r.f[c] == 0 && r.y0[c] - r.y0[c] == 0);
    }
}
#endif

#ifndef SP_EXACT_ONLY
/* An upright drum of n sides, r wide and tall from z on, its ends fans of triangles or one face each. */
static void drum(sp_scene *s, int32_t n, double r, double z, int fan)
{
    sp_real xyz[3 * 64];
    int32_t size[192], corner[600], faces = 0, corners = 0;
    for (int32_t v = 0; v < 2 * n; v++) {
        xyz[3 * v] = R(r * gen_cos(6.283185307179586 * (v % n) / n));
        xyz[3 * v + 1] = R(r * gen_sin(6.283185307179586 * (v % n) / n));
        xyz[3 * v + 2] = R(z + (v < n ? 0 : 1));
    }
    for (int32_t k = 0; k < n; k++) {                   /* sides */
        const int32_t next = (k + 1) % n, side[4] = { k, next, n + next, n + k };
        size[faces++] = 4;
        for (int c = 0; c < 4; c++) corner[corners++] = side[c];
    }
    for (int end = 0; end < 2; end++)
        for (int32_t k = 0; k < (fan ? n - 2 : 1); k++) {
            size[faces++] = fan ? 3 : n;
            for (int32_t c = 0; c < (fan ? 3 : n); c++) {
                const int32_t v = fan && c ? k + c : c;
                corner[corners++] = end ? n + v : (n - v) % n;
            }
        }
    const sp_mesh mesh = { 2 * n, faces, xyz, size, corner };
    CHECK_INT(sp_scene_block(s, &mesh, 1000, 0, NULL), SP_OK);
}

static sp_contact_report drums(sp_scene *s, int32_t n, double r, int fan)
{
    const sp_capacity cap = { 2, 200, 400, 2000, 20, 400, 0 };
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    drum(s, n, 1, 0, fan);
    drum(s, n, r, 1, fan);
    CHECK_INT(sp_contacts_find(s, NULL, test_arena, &report), SP_OK);
    return report;
}

/* Faces of more corners than are usual, in one piece or as triangles: hulls of these have no room for all, and go in parts. */
TEST(drums_touch_in_all_of_the_smaller_end)
{
    for (int32_t n = 12; n <= 32; n += 4)
        for (int fan = 0; fan < 2; fan++) {
            sp_scene s;
            double area = 0;
            const sp_contact_report r = drums(&s, n, 0.75, fan);
            for (int32_t k = 0; k < s.count.joints; k++) area += (double)s.joint[k].area;
            CHECK_NEAR(area, 0.5 * n * 0.75 * 0.75 * gen_sin(6.283185307179586 / n), TOL(1e-9, 1e-4));
            CHECK(r.joints == s.count.joints && (fan ? r.joints >= 1 : r.joints == 1));
            if (!fan) CHECK_INT(r.points, n);
        }
}
#endif

TEST_LIST(small)
    RUN(the_default_settings_are_taken_by_every_build)
    RUN(pyramids_and_the_tables_of_the_seed_are_refused_by_the_smallest_build)
    RUN(stages_but_gates_and_the_exact_one_are_refused_by_the_smallest_build)
    RUN(strength_of_joints_is_refused_by_the_smallest_build)
    RUN(budgets_and_effects_left_out_are_refused_by_the_smallest_build)
    RUN(what_is_wrong_in_what_is_left_out_is_refused_too)
    RUN(what_a_check_works_in_may_be_another_arena)
#if !defined SP_NO_PLAN && defined SP_SMALL
    RUN(a_plan_of_the_smallest_search_tells_its_bytes_and_takes_all_effects)
#endif
    RUN(memory_of_a_check_is_exact_and_its_evidence_verifies)
    RUN(stones_without_contact_load_or_freedom_are_told)
    RUN(a_pile_with_many_joints_and_loose_stones_fits_into_memory_by_counts)
#if !defined SP_NO_PLAN && defined SP_SMALL
    RUN(a_plan_counts_the_squares_of_the_rows_of_the_envelope)
    RUN(a_plan_of_one_stone_or_of_supports_alone_has_an_island_or_none)
#endif
    RUN(the_bytes_that_asking_for_memory_takes_are_enough)
#ifdef SP_SMALL
    RUN(an_envelope_too_large_to_count_is_refused)
    RUN(all_that_a_result_tells_is_written)
#endif
    RUN(what_is_no_question_is_refused_and_the_result_untouched)
#ifndef SP_EXACT_ONLY
    RUN(drums_touch_in_all_of_the_smaller_end)
#endif
    RUN(a_motion_is_of_numbers_where_nothing_balances_what_bears_no_load)
TEST_END
