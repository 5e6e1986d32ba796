/* Not one byte beyond any piece of the arena: the whole library once more, with a fence behind every piece it takes.
 *
 * Pieces lie in the memory like a stack, so a piece taken at or below a fence is the end of everything above. A fence is looked
 * at when it goes and at the end of every test. Built with AddressSanitizer fences cannot be read either.
 */
#define SP_API static
#include "../test.h"
#include "../scenes/gen.h"
#include "fence.h"
#include "../../stonepack.c"
#undef sp__take

/* After each use of the library: all fences stand, and there were some. */
static void whole(void)
{
    fences_down(NULL);
    CHECK_INT(broken, 0);
    CHECK(built > 0);
    broken = built = 0;
}

/* Joint k of `from`, if `back` from its other side. */
static void join(sp_scene *s, const sp_scene *from, int32_t k, int back)
{
    const sp_joint *t = &from->joint[k];
    sp_real xyz[64][3];
    for (int32_t v = 0; v < t->points; v++)
        memcpy(xyz[v], from->point[t->point + (back ? t->points - 1 - v : v)], sizeof xyz[v]);
    CHECK_INT(sp_scene_joint(s, back ? t->b : t->a, back ? t->a : t->b, t->points, xyz[0], &t->strength, NULL), SP_OK);
}

/* The scene of an entry, its pieces fenced as well. The plain one that it is made of stays in front of it. */
static void build(const char *name, const char *param, double value, int back, sp_scene *s)
{
    sp_scene plain;
    CHECK_INT(gen_make(name, param, value, &test_arena, &plain), SP_OK);
    CHECK_INT(sp_scene_create(s, &plain.count, &test_arena), SP_OK);
    memcpy(s->gravity, plain.gravity, sizeof s->gravity);
    for (int32_t b = 0; b < plain.count.blocks; b++) {
        const sp_block *from = &plain.block[b];
        int32_t size[64], corner[512], n = 0;
        for (int32_t f = 0; f < from->faces; f++) {
            const sp_face *face = &plain.face[from->face + f];
            size[f] = face->corners;
            for (int32_t k = 0; k < face->corners; k++) corner[n++] = plain.corner[face->corner + k] - from->vertex;
        }
        const sp_mesh mesh = { from->vertices, from->faces, plain.vertex[from->vertex], size, corner };
        CHECK_INT(sp_scene_block(s, &mesh, from->density, from->fixed, NULL), SP_OK);
    }
    for (int32_t k = 0; k < plain.count.joints; k++) join(s, &plain, k, back);
}

static const struct { const char *name, *param; double value; } sample[] = {
    { "two-cubes", NULL, 0 }, { "two-cubes", "offset", 0.7 }, { "arch", "n", 7 }, { "arch", "t", 0.09 }, { "h-model", "mu", 0 },
    { "wall", "jitter", 0.3 }, { "wall", "tilt", 40 }, { "diamond", "mu", 0.1 }, { "rubble", NULL, 0 }, { "dome", "rings", 3 }
};
enum { SAMPLES = sizeof sample / sizeof sample[0], WALL = 5, VAIN = 6, RUBBLE = 8 };   /* half the work of all is VAIN's, and undecided */

static void prepare(int k, sp_scene *s)
{
    test_arena.used = 0;
    build(sample[k].name, sample[k].param, sample[k].value, k % 2, s);
}

TEST(a_step_over_the_edge_is_seen)
{
#ifndef FENCED                                          /* there it would end the run */
    char *p = fenced_take(&test_arena, 5, 1);
    p[5] = 0;
    fences_down(NULL);
    CHECK_INT(broken, 1);
    broken = 0;
    p = fenced_take(&test_arena, 5, 1);
    p[4] = 0;
#endif
    built++;
    whole();
}

TEST(building_and_checking_keep_to_their_pieces)
{
    for (int k = 0; k < SAMPLES; k++)
        for (int32_t faces = 0; faces <= (TEST_SMALL ? 0 : 8); faces += 8) {
            sp_scene s;
            sp_result r;
            sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
            size_t bytes;
            sp_settings set = sp_settings_default();
            set.localise = 1;
            set.faces = faces;
            prepare(k, &s);
            CHECK_INT(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes), SP_OK);
            CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
            CHECK(r.verdict != SP_UNDECIDED);
            CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
            CHECK_INT(e.verdict, r.verdict);
#ifndef SP_NO_PLAN
            sp_outlook o;
            CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_OK);
#endif
            whole();
        }
}

TEST(every_stage_keeps_to_its_pieces)
{
    for (int k = 0; k < SAMPLES; k++)
        for (int id = SP_STAGE_GATES; id < SP_STAGE_CUSTOM; id++) {
            sp_scene s;
            sp_result r;
            sp_settings set = sp_settings_default();
            set.localise = 1;
            set.stage_count = 1;
            set.stage[0] = (sp_stage_id)id;
            set.penalty.net = id % 2;
            set.tol = R(TOL(1e-6, 1e-3));
            if (SOME_OF(0, k == VAIN || (id == SP_STAGE_ADMM && (k == WALL || k == RUBBLE)))) continue;
            prepare(k, &s);
#if defined(SP_NO_QP) || defined(SP_NO_ADMM)
            CHECK_INT(sp_check(&s, &set, &test_arena, &r), id == SP_STAGE_ADMM ? SP_E_UNSUPPORTED : SP_OK);
#else
            CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
#endif
            whole();
        }
}

/* Small scenes for the other questions, with friction, then glued and crushed; pushed along x, y and z. */
static const struct { const char *name, *param; double value; } asked[] = {
    { "two-cubes", "offset", 0.3 }, { "arch", "n", 5 }, { "keystone", "angle", 10 }, { "tower", "n", 3 }, { "rubble", "bricks", 2 }
};
enum { ASKED = sizeof asked / sizeof asked[0] };

static void ask(int k, int glued, sp_scene *s)
{
    test_arena.used = 0;
    build(asked[k].name, asked[k].param, asked[k].value, k % 2, s);
    for (int i = 0; i < 3; i++) s->body[i] = R(k % 3 == i ? 3 : 0);
    for (int32_t j = 0; glued && j < s->count.joints; j++) {
        s->joint[j].strength.cohesion = R(2e4);
        s->joint[j].strength.tension = R(k % 2 ? 1e4 : 0);
        s->joint[j].strength.crushing = R(1e6);
    }
}

#if (!defined SP_NO_IPM || defined SP_SMALL) && !defined SP_EXACT_ONLY
TEST(limits_keep_to_their_pieces)
{
    for (int k = 0; k < (TEST_SMALL ? 1 : 2) * ASKED; k++) {
        sp_scene s;
        sp_limit_result r;
        int32_t held = 0;
        ask(k % ASKED, k / ASKED, &s);
        memset(&r, 0, sizeof r);
        CHECK_INT(sp_limit(&s, NULL, &test_arena, &r), SP_OK);
        whole();
        CHECK_INT(sp_limit_verify(&s, NULL, &r, test_arena, &held), SP_OK);
        whole();
    }
}
#endif

#ifndef SP_NO_CRA
TEST(coupled_checks_keep_to_their_pieces)
{
    for (int k = 0; k < ASKED; k++)
        for (int seed = 0; seed < 2; seed++) {
            sp_scene s;
            sp_result r;
            sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
#if defined SP_NO_QP || defined SP_NO_ADMM
            sp_settings set = sp_settings_default();    /* nothing alternates */
#else
            sp_settings set = seed ? sp_settings_seed() : sp_settings_default();
            set.coupled.rounds = 1;
#endif
            ask(k, 0, &s);
            set.coupled.asked = 1;
            set.coupled.nodes = 20;
            set.budget = 20000000;
            NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
            whole();
            CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
            whole();
        }
}
#endif

#ifndef SP_NO_STRONG
TEST(strong_verdicts_keep_to_their_pieces)
{
    for (int k = 0; k < ASKED; k++) {
        sp_scene s;
        sp_result r;
        sp_strong_result x;
        sp_strong_settings how = sp_strong_settings_default();
        how.starts = 3;
        ask(k, 0, &s);
        CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_OK);
        CHECK_INT(sp_strong(&s, NULL, &how, r.f, NULL, &test_arena, &x), SP_OK);
        whole();
    }
}
#endif

#if !defined SP_NO_SLIDING && !defined SP_NO_IPM && !defined SP_SMALL
TEST(sliding_limits_keep_to_their_pieces)
{
    for (int k = 0; k < ASKED; k++) {
        sp_scene s;
        sp_limit_result limit;
        sp_sliding_result x;
        sp_sliding_settings how = sp_sliding_settings_default();
        how.starts = 2;
        ask(k, 0, &s);
        CHECK_INT(sp_limit(&s, NULL, &test_arena, &limit), SP_OK);
        CHECK_INT(sp_sliding(&s, NULL, &how, &limit, &test_arena, &x), SP_OK);
        whole();
    }
}
#endif

#ifndef SP_EXACT_ONLY
TEST(building_up_and_down_keeps_to_its_pieces)
{
    for (int k = 0; k < ASKED - TEST_SMALL; k++) {
        sp_scene s;
        sp_sequence *q = NULL;
        sp_step step;
        sp_held held;
        sp_suggestion next;
        ask(k, 0, &s);
        CHECK_INT(sp_sequence_open(&s, NULL, &test_arena, &q), SP_OK);
        for (int32_t i = 0; i < 2 * s.count.blocks; i++) {
            const int32_t b = i % s.count.blocks;
            CHECK_INT(sp_sequence_set(q, b, i == b ? SP_PRESENT : b % 3 ? SP_HELD : SP_ABSENT, &step), SP_OK);
            if (step.verdict != SP_STABLE) CHECK_INT(sp_sequence_hold(q, 0, &held), SP_OK);
            CHECK_INT(sp_sequence_suggest(q, i % 2, 0, &next), SP_OK);
        }
        whole();
    }
}
#endif

TEST(refused_checks_keep_to_their_pieces)
{
    sp_scene s;
    size_t bytes = 0;
    sp_result r;
    build("arch", "t", 0.09, 0, &s);
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes), SP_OK);
    for (size_t cap = 1; cap < bytes; cap += 1 + bytes / 397) {
        sp_arena a = { test_arena.base + ((test_arena.used + 63) & ~(size_t)63), cap, 0, 0 };
        const sp_status status = sp_check(&s, NULL, &a, &r);
        CHECK(status == SP_E_MEMORY || status == SP_OK);        /* fences make what is asked for a little more than enough */
    }
    whole();
}

TEST(finding_contacts_keeps_to_its_pieces)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_overlap overlap[1];
        sp_contact_report report = { 0, 0, 0, 1, NULL };
        report.overlap = overlap;
        prepare(k, &s);
        const int32_t given = s.count.joints;
        s.count.joints = s.count.points = 0;
        const sp_status status = sp_contacts_find(&s, NULL, test_arena, &report);
        CHECK_INT(status, report.joints > given ? SP_E_CAPACITY : SP_OK);  /* boards side by side touch, too */
        CHECK(report.joints >= given);
        s.count.joints = s.count.points = s.capacity.points = 0;    /* no room: only counted */
        CHECK_INT(sp_contacts_find(&s, NULL, test_arena, &report), SP_E_CAPACITY);
        whole();
    }
}

TEST(matrices_keep_to_their_pieces)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_problem p;
        sp_triplets t;
        sp_csc m;
        sp_settings set = sp_settings_default();
        set.faces = 5;
        prepare(k, &s);
        CHECK_INT(sp_problem_build(&s, &test_arena, &p), SP_OK);
        for (int32_t columns = 3; columns <= 4; columns++) {
            CHECK_INT(sp_matrix_aeq(&p, columns, &test_arena, &t), SP_OK);
            CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_OK);
            CHECK_INT(sp_matrix_afr(&p, &set, columns, &test_arena, &t), SP_OK);
            CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_OK);
        }
        whole();
    }
}

TEST_LIST(fence)
    RUN(a_step_over_the_edge_is_seen)
    RUN(building_and_checking_keep_to_their_pieces)
    RUN_FULL(every_stage_keeps_to_its_pieces)
#if (!defined SP_NO_IPM || defined SP_SMALL) && !defined SP_EXACT_ONLY
    RUN(limits_keep_to_their_pieces)
#endif
#ifndef SP_NO_CRA
    RUN(coupled_checks_keep_to_their_pieces)
#endif
#ifndef SP_NO_STRONG
    RUN(strong_verdicts_keep_to_their_pieces)
#endif
#if !defined SP_NO_SLIDING && !defined SP_NO_IPM && !defined SP_SMALL
    RUN(sliding_limits_keep_to_their_pieces)
#endif
#ifndef SP_EXACT_ONLY
    RUN(building_up_and_down_keeps_to_its_pieces)
#endif
    RUN(refused_checks_keep_to_their_pieces)
    RUN(finding_contacts_keeps_to_its_pieces)
    RUN(matrices_keep_to_their_pieces)
TEST_END
