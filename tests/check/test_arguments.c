/* Arguments that are missing, claims with a number that is none, counts and indices beyond what there is: by every question
 * about a scene, each refused by its own status, and nothing is touched. */
#include "../scenes/stages.h"

static const sp_arena none = { NULL, 0, 0, 0 };

/* One number of a claim replaced for as long as a question is asked. */
#define NOT_A_NUMBER(place, question) \
    do { const sp_real was = (place); \
         for (int k_ = 0; k_ < 3; k_++) { (place) = R(k_ == 0 ? NAN : k_ == 1 ? INFINITY : -INFINITY); CHECK_INT(question, SP_E_NOT_FINITE); } \
         (place) = was; } while (0)
/* One pointer of a claim left out likewise. */
#define WITHOUT(pointer, question) \
    do { sp_real *const was = (pointer); (pointer) = NULL; CHECK_INT(question, SP_E_ARGUMENT); (pointer) = was; } while (0)

#ifndef SP_NO_IPM
TEST(a_claimed_limit_is_of_numbers_and_has_all_its_arrays)
{
    sp_scene s;
    sp_limit_result r;
    int32_t held = 7;
    build("two-cubes", NULL, 0, &s);
    s.body[0] = 1;
    NEED(sp_limit(&s, NULL, &test_arena, &r) == SP_OK);
    const int32_t points = 3 * s.count.points, rows = 6 * s.count.blocks;
#define ASK sp_limit_verify(&s, NULL, &r, test_arena, &held)
    NOT_A_NUMBER(r.lower, ASK);
    NOT_A_NUMBER(r.upper, ASK);
    NOT_A_NUMBER(r.f[0], ASK);
    NOT_A_NUMBER(r.f[points - 1], ASK);
    NOT_A_NUMBER(r.ray[points - 1], ASK);
    NOT_A_NUMBER(r.dq[rows - 1], ASK);
    WITHOUT(r.f, ASK);
    WITHOUT(r.ray, ASK);
    WITHOUT(r.dq, ASK);
    CHECK_INT(sp_limit_verify(NULL, NULL, &r, test_arena, &held), SP_E_ARGUMENT);
    CHECK_INT(sp_limit_verify(&s, NULL, NULL, test_arena, &held), SP_E_ARGUMENT);
    CHECK_INT(sp_limit_verify(&s, NULL, &r, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_limit_verify(&s, NULL, &r, none, &held), SP_E_ARGUMENT);
    CHECK_INT(held, 7);
    CHECK_INT(ASK, SP_OK);
    CHECK_INT(held, 1);
#undef ASK
}

/* Whatever kind a claim says it is, every end that it has must hold. */
TEST(a_claimed_limit_holds_with_both_its_ends_or_not_at_all)
{
    sp_scene s;
    sp_limit_result r;
    int32_t held;
    build("two-cubes", NULL, 0, &s);
    s.body[0] = 1;
    NEED(sp_limit(&s, NULL, &test_arena, &r) == SP_OK);
    NEED(r.kind == SP_LIMIT_FOUND && r.lower > 0 && r.upper >= r.lower);
    sp_real *no = (sp_real *)(void *)(test_arena.base + (test_arena.used + 63) / 64 * 64);
    for (int32_t k = 0; k < 6 * s.count.blocks + 3 * s.count.points; k++) no[k] = 0;
    test_arena.used += (size_t)(6 * s.count.blocks + 3 * s.count.points) * sizeof *no + 64;
    for (int k = 0; k < 12; k++) {
        sp_limit_result c = r;
        if (k == 1) c.lower = -1;                       /* no such end */
        if (k == 2) { c.lower = r.upper; c.upper = r.lower; }       /* the ends exchanged, each as far off as they are */
        if (k == 3) c.lower = 2 * r.lower;
        if (k == 4) { c.lower = 2 * r.lower; c.upper = 4 * r.upper; }
        if (k == 5) c.upper = r.lower / 2;
        if (k == 6) c.f = no;
        if (k == 7) c.dq = no;
        if (k == 8) c.kind = SP_LIMIT_NONE;
        if (k == 9) c.kind = SP_LIMIT_UNBOUNDED;
        if (k == 10) { c.kind = SP_LIMIT_UNBOUNDED; c.ray = r.f; }
        if (k == 11) c.kind = SP_LIMIT_UNDECIDED;
        held = 7;
        CHECK_INT(sp_limit_verify(&s, NULL, &c, test_arena, &held), SP_OK);
        if (!CHECK_INT(held, k == 0)) TEST_PRINT("    claim %d\n", k);
    }
}

TEST(a_joint_that_does_not_exist_does_not_move)
{
    sp_scene s;
    sp_joint_motion m;
    const sp_real dq[12] = { 0 };
    build("two-cubes", NULL, 0, &s);
    CHECK_INT(sp_joint_moves(NULL, dq, 0, &m), SP_E_ARGUMENT);
    CHECK_INT(sp_joint_moves(&s, NULL, 0, &m), SP_E_ARGUMENT);
    CHECK_INT(sp_joint_moves(&s, dq, 0, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_joint_moves(&s, dq, -1, &m), SP_E_INDEX);
    CHECK_INT(sp_joint_moves(&s, dq, s.count.joints, &m), SP_E_INDEX);
    CHECK_INT(sp_joint_moves(&s, dq, s.count.joints - 1, &m), SP_OK);
    CHECK_INT(m.kind, SP_JOINT_RIGID);
}
#endif

#ifndef SP_NO_STRONG
TEST(a_claimed_strong_verdict_is_of_numbers_and_has_all_its_arrays)
{
    sp_scene s;
    sp_strong_result r;
    sp_strong_kind proved = SP_STRONG_AT_CORNERS;
    build("two-cubes", NULL, 0, &s);
    const sp_result rest = check(&s, NULL);
    const int32_t points = 3 * s.count.points, rows = 6 * s.count.blocks;
    const sp_strong_settings few = { -1, 0 };
#define ASK sp_strong(&s, NULL, NULL, rest.f, rest.f, &test_arena, &r)
    memset(&r, 0, sizeof r);
    r.starts = -7;
    NOT_A_NUMBER(rest.f[0], ASK);
    NOT_A_NUMBER(rest.f[points - 1], ASK);
    CHECK_INT(sp_strong(NULL, NULL, NULL, rest.f, NULL, &test_arena, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, NULL, rest.f, &test_arena, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, rest.f, NULL, NULL, &r), SP_E_ARGUMENT);
    sp_arena empty = none;
    CHECK_INT(sp_strong(&s, NULL, NULL, rest.f, NULL, &empty, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, rest.f, NULL, &test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, &few, rest.f, NULL, &test_arena, &r), SP_E_RANGE);
    sp_settings pyramid = sp_settings_default();
    pyramid.faces = 8;
    CHECK_INT(sp_strong(&s, &pyramid, NULL, rest.f, NULL, &test_arena, &r), SP_E_UNSUPPORTED);
    CHECK_INT(r.starts, -7);
    sp_real *pressed = (sp_real *)(void *)(test_arena.base + (test_arena.used + 63) / 64 * 64);
    memcpy(pressed, rest.f, (size_t)points * sizeof *pressed);
    test_arena.used += (size_t)points * sizeof *pressed + 64;
    NOT_A_NUMBER(pressed[points - 1], sp_strong(&s, NULL, NULL, rest.f, pressed, &test_arena, &r));
    NEED(sp_strong(&s, NULL, NULL, rest.f, NULL, &test_arena, &r) == SP_OK);
    CHECK_INT(r.kind, SP_STRONG_STRONG);
#undef ASK
#define ASK sp_strong_verify(&s, NULL, &r, test_arena, &proved)
    NOT_A_NUMBER(r.f[points - 1], ASK);
    NOT_A_NUMBER(r.moving[points - 1], ASK);
    NOT_A_NUMBER(r.a[rows - 1], ASK);
    WITHOUT(r.f, ASK);
    WITHOUT(r.moving, ASK);
    WITHOUT(r.a, ASK);
    CHECK_INT(sp_strong_verify(NULL, NULL, &r, test_arena, &proved), SP_E_ARGUMENT);
    CHECK_INT(sp_strong_verify(&s, NULL, NULL, test_arena, &proved), SP_E_ARGUMENT);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_strong_verify(&s, NULL, &r, none, &proved), SP_E_ARGUMENT);
    CHECK_INT(sp_strong_verify(&s, &pyramid, &r, test_arena, &proved), SP_E_UNSUPPORTED);
    CHECK_INT(proved, SP_STRONG_AT_CORNERS);
    CHECK_INT(ASK, SP_OK);
    CHECK_INT(proved, SP_STRONG_STRONG);
#undef ASK
}
#endif

#if !defined SP_NO_SLIDING && !defined SP_NO_IPM
TEST(a_claimed_sliding_limit_is_of_numbers_and_has_all_its_arrays)
{
    sp_scene s;
    sp_limit_result limit;
    sp_sliding_result r;
    sp_sliding_evidence e = { 7, 0, 0, 0, 0 };
    build("two-cubes", "offset", 0.1, &s);
    s.body[0] = 1;
    NEED(sp_limit(&s, NULL, &test_arena, &limit) == SP_OK);
    const int32_t points = 3 * s.count.points, rows = 6 * s.count.blocks;
    sp_arena empty = none;
    memset(&r, 0, sizeof r);
    r.ends = -7;
#define ASK sp_sliding(&s, NULL, NULL, &limit, &test_arena, &r)
    NOT_A_NUMBER(limit.upper, ASK);
    CHECK_INT(sp_sliding(NULL, NULL, NULL, &limit, &test_arena, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding(&s, NULL, NULL, NULL, &test_arena, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding(&s, NULL, NULL, &limit, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding(&s, NULL, NULL, &limit, &empty, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding(&s, NULL, NULL, &limit, &test_arena, NULL), SP_E_ARGUMENT);
    const sp_sliding_settings odd[] = { { -1, 90, 1 }, { SP_SLIDING_STARTS + 1, 90, 1 }, { 1, -1, 1 }, { 1, 1001, 1 } };
    for (int k = 0; k < 4; k++) CHECK_INT(sp_sliding(&s, NULL, &odd[k], &limit, &test_arena, &r), SP_E_RANGE);
    CHECK_INT(r.ends, -7);
    NEED(ASK == SP_OK);
#undef ASK
#define ASK sp_sliding_verify(&s, NULL, &r, test_arena, &e)
    NOT_A_NUMBER(r.upper, ASK);
    NOT_A_NUMBER(r.lower, ASK);
    NOT_A_NUMBER(r.lower_strong, ASK);
    NOT_A_NUMBER(r.f[points - 1], ASK);
    NOT_A_NUMBER(r.v[rows - 1], ASK);
    NOT_A_NUMBER(r.pressed[points - 1], ASK);
    NOT_A_NUMBER(r.resting[points - 1], ASK);
    WITHOUT(r.f, ASK);
    WITHOUT(r.v, ASK);
    WITHOUT(r.pressed, ASK);
    WITHOUT(r.resting, ASK);
    CHECK_INT(sp_sliding_verify(NULL, NULL, &r, test_arena, &e), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding_verify(&s, NULL, NULL, test_arena, &e), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding_verify(&s, NULL, &r, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding_verify(&s, NULL, &r, none, &e), SP_E_ARGUMENT);
    CHECK_INT(e.state, 7);
    CHECK_INT(ASK, SP_OK);
    CHECK_INT(e.state, r.kind == SP_SLIDING_STATE);
#undef ASK
}
#endif

#ifndef SP_EXACT_ONLY
TEST(a_build_order_is_asked_with_all_its_arguments)
{
    sp_scene s;
    sp_sequence *q = NULL;
    sp_step step;
    sp_held held;
    sp_suggestion next;
    sp_arena empty = none;
    static const sp_presence odd[2] = { SP_PRESENT, (sp_presence)77 }, all[2] = { SP_PRESENT, SP_PRESENT };
    build("two-cubes", NULL, 0, &s);
    CHECK_INT(sp_sequence_open(NULL, NULL, &test_arena, &q), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_open(&s, NULL, NULL, &q), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_open(&s, NULL, &empty, &q), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_open(&s, NULL, &test_arena, NULL), SP_E_ARGUMENT);
    CHECK(!q);
    NEED(sp_sequence_open(&s, NULL, &test_arena, &q) == SP_OK);
    CHECK_INT(sp_sequence_set(NULL, 1, SP_PRESENT, &step), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_set(q, 1, SP_PRESENT, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_set(q, 1, (sp_presence)77, &step), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_set(q, -1, SP_PRESENT, &step), SP_E_INDEX);
    CHECK_INT(sp_sequence_set(q, s.count.blocks, SP_PRESENT, &step), SP_E_INDEX);
    CHECK_INT(sp_sequence_fill(NULL, all, &step), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_fill(q, NULL, &step), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_fill(q, all, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_fill(q, odd, &step), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_hold(NULL, 0, &held), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_hold(q, 0, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_hold(q, -1, &held), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_suggest(NULL, 1, 0, &next), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_suggest(q, 1, 0, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_suggest(q, 1, -1, &next), SP_E_ARGUMENT);
    CHECK_INT(sp_sequence_suggest(q, 1, 0, &next), SP_OK);          /* nothing of it was done: the upper one is still absent */
    CHECK_INT(next.block, 1);
    CHECK_INT(sp_sequence_fill(q, all, &step), SP_OK);
    CHECK_INT(step.verdict, SP_STABLE);
}
#endif

#ifndef SP_NO_PLAN
TEST(a_plan_is_asked_with_all_its_arguments)
{
    sp_scene s;
    sp_outlook out;
    build("two-cubes", NULL, 0, &s);
    memset(&out, 0, sizeof out);
    out.islands = -7;
    CHECK_INT(sp_plan(NULL, NULL, test_arena, &out), SP_E_ARGUMENT);
    CHECK_INT(sp_plan(&s, NULL, none, &out), SP_E_ARGUMENT);
    CHECK_INT(sp_plan(&s, NULL, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(out.islands, -7);
    CHECK_INT(sp_plan(&s, NULL, test_arena, &out), SP_OK);
    CHECK_INT(out.islands, 1);
}
#endif

/* Whatever is asked for: no memory without a scene, without a place for the number, without scratch. */
TEST(memory_is_told_of_what_there_is)
{
    sp_scene s;
    sp_settings set = sp_settings_default();
    build("two-cubes", NULL, 0, &s);
    for (int what = 0; what <= (int)SP_FOR_WORK + 2; what++) {
        size_t bytes = 7;
        const sp_memory_for f = (sp_memory_for)what;
        CHECK(sp_memory(NULL, f, NULL, test_arena, &bytes) != SP_OK);
        CHECK(sp_memory(&s, f, NULL, test_arena, NULL) != SP_OK);
        CHECK_INT(bytes, 7);
        CHECK_INT(sp_memory_scratch(NULL, f, NULL), 0);
        if (f == SP_FOR_CHECK || f == SP_FOR_WORK || f == SP_FOR_LIMIT || f == SP_FOR_SEQUENCE)
            CHECK(sp_memory(&s, f, NULL, none, &bytes) != SP_OK && bytes == 7);
    }
    static const int32_t odd[] = { -1, INT32_MIN, SP_STAGES_MAX + 1, INT32_MAX };
    for (int k = 0; k < 4; k++) {
        set.stage_count = odd[k];
        CHECK_INT(sp_memory_scratch(&s, SP_FOR_CHECK, &set), 0);
    }
    set.stage_count = 1;
    CHECK(sp_memory_scratch(&s, SP_FOR_CHECK, &set) > 0);
    CHECK(sp_memory_scratch(&s, SP_FOR_CHECK, NULL) > 0);
}

TEST(settings_of_a_coupled_check_and_effects_have_their_limits)
{
    sp_scene s;
    build("two-cubes", NULL, 0, &s);
    for (int k = 0; k < 20; k++) {
        sp_settings set = sp_settings_default();
        sp_status want = SP_E_RANGE;
        sp_result r;
        if (k == 0) set.coupled.eps = R(NAN);
        if (k == 1) set.coupled.eps = R(INFINITY);
        if (k == 2) set.coupled.eps = -R(INFINITY);
        if (k == 3) set.coupled.eta = R(NAN);
        if (k == 4) set.coupled.eta = R(INFINITY);
        if (k == 5) set.coupled.eta = -1;
        if (k == 6) set.coupled.rounds = -1;
        if (k == 7) { set.coupled.eps = R(TOL(1e-200, 1e-30)); set.coupled.eta = R(TOL(1e150, 1e20)); }
        if (k == 8) set.budget = -1;
        if (k == 9) set.iterations = INT32_MIN;
        if (k > 9 && k < 14) { want = SP_E_ARGUMENT; set.effect[k % SP_EFFECTS_FORCED] = (sp_choice)(k % 2 ? -1 : SP_WITHOUT + 1); }
        if (k > 13 && k < 18) want = SP_OK;
        if (k == 18) { set.coupled.eps = 0; set.coupled.eta = R(1e30); }
        if (k == 19) { set.coupled.eps = R(1e30); set.coupled.eta = 1; }
        if (k == 14) { set.coupled.eps = 0; set.coupled.eta = 1; }
        if (k == 15) { set.coupled.eps = R(1e-3); set.coupled.eta = 1; }
        if (k == 16) set.coupled.rounds = 1;
        if (k == 17) set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
        const sp_arena before = test_arena;
        if (!CHECK_INT(sp_check(&s, &set, &test_arena, &r), want)) TEST_PRINT("    case %d\n", k);
        if (want) CHECK_INT(test_arena.used, before.used);
    }
}

TEST(the_constants_of_the_seed_have_their_limits)
{
    sp_scene s;
    build("two-cubes", NULL, 0, &s);
    for (int k = 0; k < 34; k++) {
        sp_seed c = *sp_seed_table();
        sp_real *const not_below[] = { &c.tension, &c.cone, &c.gain, &c.engaged, &c.floor, &c.gate, &c.drop, &c.slip_error };
        sp_real *const above[] = { &c.balance, &c.reg };
        sp_settings set = sp_settings_default();
        sp_status want = SP_E_RANGE;
        sp_result r;
        if (k < 8) *not_below[k] = R(-1e-30);
        if (k >= 8 && k < 16) *not_below[k - 8] = R(NAN);
        if (k == 16 || k == 17) *above[k - 16] = 0;
        if (k == 18 || k == 19) *above[k - 18] = R(NAN);
        if (k == 20) c.faces = 2;
        if (k == 21) c.faces = 65;
        if (k == 22) c.window = 0;
        if (k == 23) c.rounds = -1;
        if (k == 24) c.gain = 1;
        if (k > 24) want = SP_OK;
        if (k == 25) c.faces = 3;
        if (k == 26) c.faces = 64;
        if (k == 27) c.window = 1;
        if (k == 28) c.rounds = 0;
        if (k > 28 && k < 33) *not_below[2 * (k - 29)] = 0;
        set.seed = &c;
        if (!CHECK_INT(sp_check(&s, &set, &test_arena, &r), want)) TEST_PRINT("    case %d\n", k);
    }
}

TEST(contacts_are_found_with_distances_that_are_numbers)
{
    sp_scene s;
    sp_contact_report report;
    build("two-cubes", NULL, 0, &s);
    memset(&report, 0, sizeof report);
    for (int k = 0; k < 14; k++) {
        sp_contact_settings set = sp_contact_settings_default();
        sp_status want = SP_E_RANGE;
        sp_arena scratch = test_arena;
        sp_scene *scene = &s;
        sp_contact_report *out = &report;
        report.overlap_capacity = 0;
        report.joints = -7;
        if (k == 0) set.distance = R(NAN);
        if (k == 1) set.distance = R(INFINITY);
        if (k == 2) set.distance = -1;
        if (k == 3) set.angle = R(NAN);
        if (k == 4) set.angle = -R(INFINITY);
        if (k == 5) set.angle = R(0.51);
        if (k == 6) set.angle = R(-64.5);
        if (k == 7) set.strength.mu = -1;
        if (k > 7) want = SP_E_ARGUMENT;
        if (k == 8) scene = NULL;
        if (k == 9) scratch = none;
        if (k == 10) out = NULL;
        if (k == 11) report.overlap_capacity = -1;
        if (k == 12) { set.strength.cohesion = R(NAN); want = SP_E_NOT_FINITE; }
        if (k == 13) { set.angle = R(0.5); want = SP_E_CAPACITY; }   /* all arguments are right, the scene is full */
        if (!CHECK_INT(sp_contacts_find(scene, &set, scratch, out), want)) TEST_PRINT("    case %d\n", k);
        if (k < 13) CHECK_INT(report.joints, -7);
        else CHECK_INT(report.joints, 1);
    }
}

TEST(work_is_asked_only_of_an_arena_that_has_memory)
{
    sp_scene s;
    sp_result r;
    sp_settings set = sp_settings_default();
    sp_arena nothing = none, a;
    build("two-cubes", NULL, 0, &s);
    a = test_arena;
    set.work = &nothing;
    r.verdict = SP_STABLE;
    CHECK_INT(sp_check(&s, &set, &a, &r), SP_E_ARGUMENT);
    CHECK(r.verdict == SP_STABLE && a.used == test_arena.used);
}

TEST(an_arena_needs_memory)
{
    unsigned char few[4 * SP_ALIGN];
    sp_arena a = { few, 1, 2, 3 };
    CHECK_INT(sp_arena_init(NULL, few, sizeof few), SP_E_ARGUMENT);
    CHECK_INT(sp_arena_init(&a, NULL, sizeof few), SP_E_ARGUMENT);
    CHECK(a.base == few && a.capacity == 1);
    CHECK_INT(sp_arena_init(&a, few, 0), SP_E_MEMORY);
    CHECK_INT(sp_arena_init(&a, few, sizeof few), SP_OK);
    CHECK(a.capacity > 2 * SP_ALIGN && a.used == 0 && a.peak == 0);
}

TEST_LIST(arguments)
#ifndef SP_NO_IPM
    RUN(a_claimed_limit_is_of_numbers_and_has_all_its_arrays)
    RUN(a_claimed_limit_holds_with_both_its_ends_or_not_at_all)
    RUN(a_joint_that_does_not_exist_does_not_move)
#endif
#ifndef SP_NO_STRONG
    RUN(a_claimed_strong_verdict_is_of_numbers_and_has_all_its_arrays)
#endif
#if !defined SP_NO_SLIDING && !defined SP_NO_IPM
    RUN(a_claimed_sliding_limit_is_of_numbers_and_has_all_its_arrays)
#endif
#ifndef SP_EXACT_ONLY
    RUN(a_build_order_is_asked_with_all_its_arguments)
#endif
#ifndef SP_NO_PLAN
    RUN(a_plan_is_asked_with_all_its_arguments)
#endif
    RUN(memory_is_told_of_what_there_is)
    RUN(settings_of_a_coupled_check_and_effects_have_their_limits)
    RUN(the_constants_of_the_seed_have_their_limits)
    RUN(contacts_are_found_with_distances_that_are_numbers)
    RUN(work_is_asked_only_of_an_arena_that_has_memory)
    RUN(an_arena_needs_memory)
TEST_END
