/* A stage of the caller: it is believed where it is right, and nothing it says otherwise becomes a verdict. */
#include "../scenes/stages.h"

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

TEST(a_motion_that_a_stage_leaves_behind_is_not_told_of_what_stands)
{
    static sp_real dq[NUMBERS];
    const char *const name[3] = { "two-cubes", "arch", NULL };
    sp_settings set = own(SP_STAGE_EXACT);
    set.budget = 100000000;                             /* on a budget the best so far is kept */
    for (int32_t k = 0; k < NUMBERS; k++) dq[k] = test_random_real(-1, 1);
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        test_arena.used = 0;
        if (name[k]) build(name[k], "mu", 0.84, &s);
        else columns(3, 0, &s);                         /* islands */
        plan_for(NULL, dq, 1, SP_UNDECIDED);
        const sp_result r = check(&s, &set);
        CHECK_INT(r.verdict, SP_STABLE);
        for (int32_t v = 0; v < 6 * s.count.blocks; v++) CHECK_WITHIN(r.dq[v], 0, 0);
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
        for (int trial = 0; trial < SOME_OF(20, 8); trial++) {      /* one number spoilt, where it carries */
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
        for (int trial = 0; trial < SOME_OF(20, 8); trial++) {
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
        NEED(test_arena.capacity - test_arena.used > bytes + SP_ALIGN);
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

/* A tower of cubes sinks into the ground, says a stage that spends more than it was left. A cube's own weight is a small part of
 * what it carries: caps by weights alone would prove that forces below twice as much cannot hold it. */
TEST(a_stage_that_overspends_its_budget_proves_no_fall)
{
    static const int64_t over[] = { 1, 5, 9, 10, 11, 20, 1000000 };     /* sweeps of the certificate check */
    static sp_real down[NUMBERS];
    for (size_t k = 0; k < sizeof over / sizeof over[0]; k++)
        for (int paint = 0; paint < 2; paint++) {
            sp_scene s;
            sp_result r;
            test_arena.used = 0;
            columns(20, 0, &s);
            sp_settings set = own(SP_STAGE_NONE);
            set.force_bound = 2;
            set.budget = 100000000;
            for (int i = 0; i < 19; i++) down[6 * i + 2] = -1;
            plan_for(NULL, down, 1, SP_UNSTABLE);
            plan.overspends = over[k] * 90 * s.count.points;
            sp_real *left = (sp_real *)(void *)(test_arena.base + (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN);
            for (int i = 0; i < 20000; i++) left[i] = R(paint);         /* what was in the arena before */
            CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
            CHECK_INT(r.verdict, SP_UNDECIDED);
        }
}

TEST_LIST(custom)
    RUN(a_stage_that_is_right_is_believed)
    RUN(a_motion_that_a_stage_leaves_behind_is_not_told_of_what_stands)
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
    RUN_FULL(a_stage_that_overspends_its_budget_proves_no_fall)
TEST_END
