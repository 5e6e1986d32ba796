/* Any budget, in every question: what is said with it is proved, and never the opposite of what is said without. A budget grows by
 * a factor from far too little to more than enough, so that work ends at every place where it may. */
#include "../scenes/stages.h"

#ifndef SP_SMALL

/* Scenes of one question: what is generated, one number changed, friction, glue and a cap of joints, loads along x and z. */
typedef struct spent_scene { const char *name, *param; double value, mu, glue, cap, x, z; } spent_scene;

static const spent_scene scenes[] = {
    { "two-cubes", "offset", 0.2, 0.5, 0, 0, 1, 0 }, { "tower", "n", 4, 0.3, 0, 0, 1, 0 }, { "arch", "n", 8, 0.84, 0, 0, 1, 0 },
    { "rubble", "rows", 2, 0.6, 0, 0, 0.3, 0.2 }, { "keystone", "angle", 20, 0.2, 0, 0, 1, 0 }, { "wall", "rows", 2, 0.5, 2000, 0, 1, 0.5 },
    { "tower", "n", 3, 0.5, 0, 1e6, 1, -1 }, { "flat-arch", "n", 3, 0.4, 0, 0, 0, -1 }, { "h-model", NULL, 0, 0.5, 0, 0, 0, -1 },
    { "diamond", "rows", 3, 0.2, 500, 5e5, 1, 0 }, { "incline", "angle", 35, 0.5, 0, 0, -1, 0 }, { "overhang", "n", 3, 0.5, 0, 0, 0, 1 }
};
enum { SCENES = sizeof scenes / sizeof *scenes };

static void make(int k, sp_scene *s)
{
    const spent_scene *o = &scenes[k];
    test_arena.used = 0;
    build(o->name, o->param, o->value, s);
    for (int32_t q = 0; q < s->count.joints; q++) {
        s->joint[q].strength.mu = R(o->mu);
        s->joint[q].strength.cohesion = R(o->glue);
        s->joint[q].strength.tension = R(o->glue / 4);
        s->joint[q].strength.crushing = R(o->cap);
    }
    s->body[0] = R(9.80665 * o->x);
    s->body[2] = R(9.80665 * o->z);
}

/* A number of all bytes of the scene, which is alone in the arena; whatever ends anywhere leaves it as it was. */
static uint64_t scene_bytes;
static size_t scene_used;
static uint64_t number_of(void)
{
    uint64_t h = 14695981039346656037u;
    for (size_t k = 0; k < scene_used; k++) h = (h ^ test_arena.base[k]) * 1099511628211u;
    return h;
}
static void keep(void)
{
    scene_used = test_arena.used;
    scene_bytes = number_of();
}
static int as_it_was(void) { return number_of() == scene_bytes; }

/* The next budget. */
static int64_t more(int64_t budget) { return budget * SOME_OF(5, 9) / SOME_OF(4, 5) + 1; }

/* Opposite verdicts. */
static int opposite(sp_verdict a, sp_verdict b) { return a + b == SP_STABLE + SP_UNSTABLE && a != b && a && b; }

#ifndef SP_NO_IPM
TEST(a_limit_with_any_budget_has_ends_that_hold)
{
    for (int k = 0; k < SCENES; k++) {
        sp_scene s;
        sp_limit_result all;
        int kinds = 0;
        make(k, &s);
        keep();
        NEED(sp_limit(&s, NULL, &test_arena, &all) == SP_OK);
        const double near = TOL(1e-6, 5e-3);
        for (int64_t b = 1; b < 40 * all.cost.flops; b = more(b)) {
            sp_arena a = test_arena;
            sp_settings set = sp_settings_default();
            sp_limit_result r;
            int32_t held = 0;
            set.budget = b;
            NEED(sp_limit(&s, &set, &a, &r) == SP_OK);
            CHECK(as_it_was());
            kinds |= 1 << r.kind;
            if (r.kind == SP_LIMIT_UNDECIDED) continue;
            CHECK_INT(sp_limit_verify(&s, NULL, &r, a, &held), SP_OK);
            CHECK(held && r.verified);
            if (all.kind) CHECK_INT(r.kind, all.kind);
            if (r.kind != SP_LIMIT_FOUND || all.kind != SP_LIMIT_FOUND) continue;
            CHECK((double)r.lower <= (double)all.upper * (1 + near) + near && (double)r.upper >= (double)all.lower * (1 - near) - near);
        }
        CHECK(kinds & 1 || !all.kind);                  /* too little is told as too little */
        if (all.kind) CHECK(kinds >> all.kind & 1);
    }
}
#endif

#if !defined SP_NO_IPM && !defined SP_NO_SLIDING
TEST(a_sliding_limit_with_any_budget_is_proved)
{
    for (int k = 0; k < SCENES; k++) {
        sp_scene s;
        sp_limit_result limit;
        sp_sliding_result all;
        make(k, &s);
        keep();
        NEED(sp_limit(&s, NULL, &test_arena, &limit) == SP_OK);
        NEED(sp_sliding(&s, NULL, NULL, &limit, &test_arena, &all) == SP_OK);
        for (int64_t b = 1; b < 2 * all.cost.flops; b = more(more(b))) {
            sp_arena a = test_arena;
            sp_settings set = sp_settings_default();
            sp_sliding_result r;
            sp_sliding_evidence e;
            set.budget = b;
            NEED(sp_sliding(&s, &set, NULL, &limit, &a, &r) == SP_OK);
            CHECK(as_it_was());
            CHECK_INT(sp_sliding_verify(&s, NULL, &r, a, &e), SP_OK);
            CHECK_INT(e.state, r.kind == SP_SLIDING_STATE);
            CHECK(!(e.lower < r.lower) && !(e.lower_strong < r.lower_strong) && r.lower_strong <= r.lower);
            if (r.kind == SP_SLIDING_STATE) CHECK(r.upper >= all.lower * R(1 - TOL(1e-6, 1e-2)));
        }
    }
}
#endif

#ifndef SP_NO_STRONG
TEST(a_strong_verdict_with_any_budget_is_proved)
{
    for (int k = 0; k < SCENES; k++) {
        sp_scene s;
        sp_strong_result all;
        make(k, &s);
        s.body[0] = s.body[2] = 0;
        keep();
        const sp_result rest = check(&s, NULL);
        sp_settings most = sp_settings_default();
        most.budget = SOME_OF(200000000, 1000000);
        NEED(sp_strong(&s, &most, NULL, rest.f, NULL, &test_arena, &all) == SP_OK);
        for (int64_t b = 1; b < most.budget; b = more(more(b))) {
            sp_arena a = test_arena;
            sp_settings set = sp_settings_default();
            sp_strong_result r;
            sp_strong_kind proved = SP_STRONG_NONE;
            set.budget = b;
            NEED(sp_strong(&s, &set, NULL, rest.f, NULL, &a, &r) == SP_OK);
            CHECK(as_it_was());
            CHECK_INT(sp_strong_verify(&s, NULL, &r, a, &proved), SP_OK);
            CHECK_INT(proved, r.kind);
            if (r.kind >= SP_STRONG_AT_CORNERS) CHECK(all.kind != SP_STRONG_AMBIGUOUS);
            if (r.kind == SP_STRONG_AMBIGUOUS) CHECK(all.kind < SP_STRONG_AT_CORNERS);
        }
    }
}
#endif

#ifndef SP_NO_CRA
TEST(a_coupled_check_with_any_budget_says_what_it_proves)
{
    for (int k = 0; k < SCENES; k++) {
        sp_scene s;
        sp_settings set = sp_settings_default();
        sp_result all;
        make(k, &s);
        s.body[0] = s.body[2] = 0;
        for (int32_t q = 0; q < s.count.joints; q++) s.joint[q].strength = sp_strength_friction(R(scenes[k].mu));
        set.coupled.asked = 1;
        keep();
        const sp_settings ask = set;
        NEED(sp_check(&s, &set, &test_arena, &all) == SP_OK);
        for (int64_t b = 1; b < 2 * all.spent.total.flops; b = more(more(b))) {
            sp_arena a = test_arena;
            sp_result r;
            sp_evidence e;
            set.budget = b;
            NEED(sp_check(&s, &set, &a, &r) == SP_OK);
            CHECK(as_it_was());
            CHECK(!opposite(r.verdict, all.verdict));
            CHECK(!(r.coupled.verdict == SP_COUPLING_REFUTED && all.level == SP_COUPLED));
            CHECK(!(r.level == SP_COUPLED && all.coupled.verdict == SP_COUPLING_REFUTED));
            CHECK_INT(sp_verify(&s, &ask, &r, a, &e), SP_OK);
            if (r.verdict) CHECK_INT(e.verdict, r.verdict);
        }
    }
}
#endif

#ifndef SP_EXACT_ONLY
TEST(a_build_order_with_any_budget_says_what_it_proves)
{
    for (int k = 0; k < SCENES; k++) {
        sp_scene s;
        sp_result whole;
        sp_presence who[64];
        make(k, &s);
        s.body[0] = s.body[2] = 0;
        NEED(s.count.blocks <= 64);
        keep();
        NEED(sp_check(&s, NULL, &test_arena, &whole) == SP_OK);
        for (int32_t q = 0; q < s.count.blocks; q++) who[q] = SP_PRESENT;
        for (int64_t b = 1; b < 4 * whole.spent.total.flops + 1000; b = more(more(b))) {
            sp_arena a = test_arena;
            sp_settings set = sp_settings_default();
            sp_sequence *q;
            sp_step step;
            sp_held held;
            sp_suggestion next;
            set.budget = b;
            NEED(sp_sequence_open(&s, &set, &a, &q) == SP_OK);
            NEED(sp_sequence_fill(q, who, &step) == SP_OK);
            CHECK(!opposite(step.verdict, whole.verdict));
            NEED(sp_sequence_hold(q, b, &held) == SP_OK);
            int32_t held_now[64], count = held.count;
            for (int32_t i = 0; i < count; i++) held_now[i] = held.block[i];
            NEED(sp_sequence_suggest(q, 0, b, &next) == SP_OK);
            if (next.block >= 0) {
                NEED(sp_sequence_set(q, next.block, SP_ABSENT, &step) == SP_OK);
                CHECK(step.verdict != SP_UNSTABLE);
                NEED(sp_sequence_set(q, next.block, SP_PRESENT, &step) == SP_OK);
            }
            for (int32_t i = 0; i < count; i++) NEED(sp_sequence_set(q, held_now[i], SP_HELD, &step) == SP_OK);
            CHECK(step.verdict != SP_UNSTABLE);
            CHECK(as_it_was());
            if (whole.verdict == SP_STABLE && step.verdict == SP_STABLE) CHECK_INT(step.block, -1);
        }
    }
}
#endif

/* So many factorisations and no more, in 3 rows a block or 6, with the cone or a pyramid. */
TEST(any_number_of_factorisations_proves_what_it_says)
{
    for (int k = 0; k < SCENES; k++)
        for (int how = SOME_OF(0, k % 4); how < SOME_OF(4, k % 4 + 1); how++) {
            sp_scene s;
            sp_settings set = sp_settings_default();
            make(k, &s);
            if (how & 1) set.faces = 8;
            if (how & 2) set.effect[SP_EFFECT_DEPTH] = SP_WITH;
            const sp_result all = check(&s, &set);
#ifndef SP_NO_IPM
            sp_limit_result most, r;
            NEED(sp_limit(&s, &set, &test_arena, &most) == SP_OK);
#endif
            for (int32_t n = 0; n < 24; n += 1 + n / 6) {
                sp_arena a = test_arena;
                sp_result x;
                sp_evidence e;
                set.iterations = n;
                NEED(sp_check(&s, &set, &a, &x) == SP_OK);
                CHECK(!opposite(x.verdict, all.verdict));
                NEED(sp_verify(&s, &set, &x, a, &e) == SP_OK);
                if (x.verdict) CHECK_INT(e.verdict, x.verdict);
#ifndef SP_NO_IPM
                int32_t held = 0;
                NEED(sp_limit(&s, &set, &a, &r) == SP_OK);
                if (r.kind && most.kind) CHECK_INT(r.kind, most.kind);
                if (!r.kind) continue;
                CHECK_INT(sp_limit_verify(&s, &set, &r, a, &held), SP_OK);
                CHECK(held);
#endif
            }
        }
}

#if !defined SP_NO_QP && !defined SP_NO_ADMM
/* The specification's stages with constants that pass everything, nothing, or give up at once: they only propose. */
TEST(constants_of_the_seed_never_turn_a_verdict)
{
    static const sp_stage_id stage[] = { SP_STAGE_LEAST_SQUARES, SP_STAGE_DENSE, SP_STAGE_POLISH };
    for (int k = 0; k < SCENES; k++) {
        sp_scene s;
        make(k, &s);
        for (int32_t q = 0; q < s.count.joints; q++) s.joint[q].strength = sp_strength_friction(R(scenes[k].mu));
        const sp_result all = check(&s, NULL);
        for (int c = 0; c < 54; c++) {
            sp_arena a = test_arena;
            sp_seed constants = *sp_seed_table();
            sp_settings set = sp_settings_seed();
            sp_result r;
            sp_evidence e;
            constants.tension = R(c % 3 == 0 ? 0 : c % 3 == 1 ? 1e-3 : 1e9);
            constants.cone = R(c / 3 % 3 == 0 ? 0 : c / 3 % 3 == 1 ? 1e-3 : 1e9);
            constants.balance = R(c / 9 % 2 ? 1e-6 : 1e9);
            constants.rounds = c % 2 ? 300 : 0;
            set.seed = &constants;
            set.stage_count = 2;
            set.stage[1] = stage[c / 18];
            NEED(sp_check(&s, &set, &a, &r) == SP_OK);
            CHECK(!opposite(r.verdict, all.verdict));
            NEED(sp_verify(&s, &set, &r, a, &e) == SP_OK);
            if (r.verdict) CHECK_INT(e.verdict, r.verdict);
        }
    }
}
#endif

#ifndef SP_NO_CRA
/* Pyramids of few faces, which a proof knows one by one, and of many, of which it knows the eighths of a circle. */
TEST(a_coupled_check_with_a_pyramid_says_what_it_proves)
{
    static const int32_t faces[] = { 3, 4, 8, 9, 16, 64 };
    int several[4] = { 0, 0, 0, 0 };
    for (int k = 0; k < SCENES; k++)
        for (int q = 0; q < 12; q++) {
            sp_scene s;
            sp_settings set = sp_settings_default();
            sp_result r;
            sp_evidence e;
            make(k, &s);
            s.body[0] = s.body[2] = 0;
            for (int32_t i = 0; i < s.count.joints; i++) s.joint[i].strength = sp_strength_friction(R(scenes[k].mu));
            set.coupled.asked = 1;
            set.coupled.box = q % 2;
            set.faces = faces[q / 2];
            set.budget = SOME_OF(0, 20000000);
            NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
            NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
            if (r.verdict) CHECK_INT(e.verdict, r.verdict);
            if (r.level == SP_COUPLED) CHECK(e.residual <= 1 && e.level == SP_COUPLED);
            several[r.coupled.verdict]++;
        }
    CHECK(several[SP_COUPLING_REFUTED] > 0);
}
#endif

#endif

TEST_LIST(spent)
#ifndef SP_SMALL
    RUN(any_number_of_factorisations_proves_what_it_says)
#if !defined SP_NO_QP && !defined SP_NO_ADMM
    RUN(constants_of_the_seed_never_turn_a_verdict)
#endif
#ifndef SP_NO_CRA
    RUN(a_coupled_check_with_a_pyramid_says_what_it_proves)
#endif
#ifndef SP_NO_IPM
    RUN(a_limit_with_any_budget_has_ends_that_hold)
#endif
#if !defined SP_NO_IPM && !defined SP_NO_SLIDING
    RUN(a_sliding_limit_with_any_budget_is_proved)
#endif
#ifndef SP_NO_STRONG
    RUN(a_strong_verdict_with_any_budget_is_proved)
#endif
#ifndef SP_NO_CRA
    RUN(a_coupled_check_with_any_budget_says_what_it_proves)
#endif
#ifndef SP_EXACT_ONLY
    RUN(a_build_order_with_any_budget_says_what_it_proves)
#endif
#endif
TEST_END
