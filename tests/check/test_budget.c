/* budget: a cap on the work of a check, and what it buys. */
#include "../test.h"
#include "../scenes/gen.h"

#include <string.h>

typedef struct budget_case { const char *scene, *number; double value; int32_t faces; const char *stages; } budget_case;

#if defined SP_NO_IPM && defined SP_REAL_FLOAT          /* forces of the proximal path are best by the search's measure */
#define SLACK 1.2
#else
#define SLACK TOL(1 + 1e-9, 1 + 1e-5)
#endif

/* Both sides of a limit, near it, curved, wall, pyramid; and ladders of more than one search. */
static const budget_case cases[] = {
    { "arch", "t", 0.14, 0, "x" }, { "arch", "t", 0.09, 0, "x" }, { "arch", "t", 0.1076, 0, "x" }, { "wall", "size", 54, 0, "x" },
    { "wall", "tilt", 30, 0, "x" }, { "dome", "t", 0.1, 0, "x" }, { "dome", "t", 0.02, 8, "x" }, { "h-model", NULL, 0, 8, "x" },
    { "overhang", "factor", 1.05, 0, "x" }, { "arch", "t", 0.14, 0, "lpx" }, { "wall", "size", 54, 0, "lpx" },
    { "arch", "t", 0.09, 0, "px" }, { "overhang", "factor", 1.05, 8, "ldp" },
    { "wall", "tilt", 30, 8, "ldp" },
};

static sp_settings settings_of(const budget_case *c)
{
    sp_settings set = sp_settings_default();
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) set.effect[k] = SP_WITH;
    set.faces = c->faces;
    set.stage_count = 1;
    for (const char *s = c->stages; *s; s++)
        set.stage[set.stage_count++] = *s == 'l' ? SP_STAGE_LEAST_SQUARES : *s == 'd' ? SP_STAGE_DENSE
                                     : *s == 'p' ? SP_STAGE_POLISH : *s == 'a' ? SP_STAGE_ADMM : SP_STAGE_EXACT;
    return set;
}

static int scene_of(const budget_case *c, sp_scene *s)
{
    gen_scene g;
    return gen_open(&g, c->scene) && (!c->number || gen_set(&g, c->number, c->value)) && gen_build(&g, &test_arena, s) == SP_OK;
}

static sp_result check(const sp_scene *s, const sp_settings *set)
{
    sp_result r;
    memset(&r, 0, sizeof r);
    CHECK_INT(sp_check(s, set, &test_arena, &r), SP_OK);
    return r;
}

static int64_t stages_flops(const sp_result *r)
{
    int64_t sum = 0;
    for (int k = 0; k < SP_STAGES_MAX; k++) sum += r->spent.by_stage[k].flops;
    return sum;
}

/* The row whose checks take 1700 of the 1900 ms of a whole table: with LONG=1 alone. */
static int slow(const budget_case *c) { return c->stages[1] == 'd' && c->scene[0] == 'w'; }

/* One scene over budgets from nothing to more than enough, in steps that share no pattern with the work. More of it never finds
 * a larger imbalance; what it is relative to is summed in as many sweeps as fit, hence the last digits. */
static void sweep(const budget_case *c, int steps, sp_choice choice)
{
    const int beyond = SOME_OF(8, 2);
    sp_scene s;
    sp_settings set = settings_of(c);
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) set.effect[k] = choice;
    test_arena.used = 0;
    NEED(scene_of(c, &s));
    const sp_result all = check(&s, &set);
    const size_t mark = test_arena.used;
    sp_result last = all;
    last.verdict = SP_UNDECIDED;
    last.imbalance = 1;
    last.final = 0;
    int better = 0;
    for (int k = 1; k <= steps + beyond; k++) {
        set.budget = (int64_t)((double)all.spent.total.flops * (k <= steps ? 0.9936 * k / steps : 1.0571 + 3.0 / beyond * (k - steps))) + 1;
        test_arena.used = mark;
        const sp_result r = check(&s, &set);
        CHECK(r.spent.total.flops <= set.budget);
        CHECK(stages_flops(&r) <= r.spent.total.flops);
        if (last.verdict) CHECK_INT(r.verdict, last.verdict);
        if (r.verdict == SP_STABLE || !r.verdict) {
            if (!CHECK(r.imbalance <= R(SLACK) * last.imbalance + 16 * (sp_real)SP_EPSILON))
                TEST_PRINT("    %s %s at %d: %.9g after %.9g\n", c->scene, c->stages, k, (double)r.imbalance, (double)last.imbalance);
            better += r.imbalance < last.imbalance;
        }
        CHECK(r.final >= last.final);
        if (!r.verdict) CHECK(r.reason == SP_REASON_BUDGET || r.spent.total.flops == all.spent.total.flops || r.reason == all.reason);
        last = r;
    }
    CHECK(better > 0 || all.verdict == SP_UNSTABLE);
    if (!CHECK_INT(last.verdict, all.verdict)) TEST_PRINT("    %s %s: %g, reason %d\n", c->scene, c->stages, (double)last.imbalance, (int)last.reason);
    if (all.verdict == SP_STABLE)
        CHECK(memcmp(last.f, all.f, 3 * (size_t)s.count.points * sizeof *all.f) == 0);
}

TEST(no_check_costs_more_than_its_budget_and_more_of_it_never_proves_less)
{
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++)
        if (test_long || !slow(&cases[k])) sweep(&cases[k], SOME_OF(16, 6), SP_WITH);
}

/* The plan is followed on a budget: in the plane, by pressure alone, and where that is tried in vain. */
TEST(a_plan_keeps_to_a_budget_and_decides_with_less_of_it)
{
    static const budget_case level[] = { { "dome", "tilt", 0, 0, "x" }, { "diamond", "rows", 4, 0, "x" }, { "diamond", "rows", 5, 0, "x" },
        { "overhang", "factor", 1.1, 0, "x" }, { "tower", "n", 12, 0, "lx" } };
    int less = 0;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++)
        if (test_long || !slow(&cases[k])) sweep(&cases[k], SOME_OF(16, 6), SP_PLANNED);
    for (size_t k = 0; k < sizeof level / sizeof level[0]; k++) sweep(&level[k], SOME_OF(16, 6), SP_PLANNED);
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        sp_scene s;
        sp_settings set = settings_of(&cases[k]), planned = set;
        if (slow(&cases[k]) && !test_long) continue;
        test_arena.used = 0;
        NEED(scene_of(&cases[k], &s));
        const sp_result all = check(&s, &set);
        for (int q = 0; q < SP_EFFECTS_FORCED; q++) planned.effect[q] = SP_PLANNED;
        planned.budget = set.budget = all.spent.total.flops / 2;
        const sp_result r = check(&s, &planned);
        CHECK(!r.verdict || !all.verdict || r.verdict == all.verdict);
        less += r.verdict && !check(&s, &set).verdict;
    }
#ifndef SP_NO_PLAN                                      /* which leaves nothing to decide with less */
    if (sizeof(sp_real) == 8) CHECK(less > 2);
#else
    CHECK_INT(less, 0);
#endif
}

/* Rounds of projections lessen the imbalance of the whole, not of the worst block: the best of them counts. */
TEST(more_rounds_of_projections_never_balance_less)
{
    static const budget_case polished[] = { { "arch", "t", 0.14, 0, "lpx" }, { "keystone", "mu", 0.85, 0, "p" } };
    for (size_t k = 0; k < sizeof polished / sizeof polished[0]; k++) sweep(&polished[k], SOME_OF(300, 100), SP_WITH);
}

/* No budget is too small to answer, and none is so small that the answer is a verdict nobody paid for. */
TEST(a_budget_of_next_to_nothing_is_no_verdict)
{
    for (int64_t budget = 1; budget < 2000; budget = 3 * budget + 1) {
        sp_scene s;
        sp_settings set = settings_of(&cases[0]);
        test_arena.used = 0;
        NEED(scene_of(&cases[0], &s));
        set.budget = budget;
        const sp_result r = check(&s, &set);
        CHECK_INT(r.verdict, SP_UNDECIDED);
        CHECK_INT(r.reason, SP_REASON_BUDGET);
        CHECK(r.spent.total.flops <= budget);
        CHECK_NEAR(r.imbalance, 1, 1e-12);
    }
}

#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
TEST(the_penalty_program_keeps_to_what_is_left)
{
    static const budget_case c = { "arch", "t", 0.14, 0, "la" };
    sp_scene s;
    sp_settings set = settings_of(&c);
    test_arena.used = 0;
    NEED(scene_of(&c, &s));
    const int64_t all = check(&s, &set).spent.total.flops;
    const size_t mark = test_arena.used;
    for (int k = 1; k <= 24; k++) {
        test_arena.used = mark;
        set.budget = all / 20 * k + 1;
        const sp_result r = check(&s, &set);
        CHECK(r.spent.total.flops <= set.budget);
    }
}
#endif

/* Search, exact decision and penalty form, one after the other, and the seed's alternation with its programs. */
TEST(a_coupled_check_keeps_to_its_budget_and_more_of_it_takes_no_answer_back)
{
    static const budget_case asked[] = { { "h-model", NULL, 0, 0, "x" }, { "incline", "angle", 30, 0, "x" },
        { "arch", "t", 0.14, 0, "x" }, { "arch", "t", 0.09, 0, "x" }, { "h-model", "mu", 0.6, 0, "turns" } };
    for (size_t k = 0; k < sizeof asked / sizeof asked[0]; k++) {
        sp_scene s;
        sp_settings set = settings_of(&asked[k]);
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
        if (asked[k].stages[0] == 't') set = sp_settings_seed();
#endif
        set.coupled.asked = 1;
        test_arena.used = 0;
        NEED(scene_of(&asked[k], &s));
        const sp_result all = check(&s, &set);
        const size_t mark = test_arena.used;
        sp_coupling last = SP_COUPLING_NOT_FOUND;
        sp_result r = all;
        for (int n = 1; n <= 24; n += SOME_OF(1, 3)) {
            set.budget = (int64_t)((double)all.spent.total.flops * (n < 17 ? 0.0621 * n : 1.0571 + 0.25 * (n - 16))) + 1;
            test_arena.used = mark;
            r = check(&s, &set);
            CHECK(r.spent.total.flops <= set.budget);
            if (last != SP_COUPLING_NOT_FOUND) CHECK_INT(r.coupled.verdict, last);
            if (r.verdict && r.coupled.verdict == SP_COUPLING_NOT_FOUND) CHECK_INT(r.coupled.reason, SP_COUPLING_BUDGET);
            if (r.level == SP_COUPLED) {
                sp_evidence e;
                CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
                CHECK_INT(e.level, SP_COUPLED);
            }
            last = r.coupled.verdict;
        }
        CHECK_INT(last, all.coupled.verdict);
        CHECK((r.coupled.tension_ratio >= 0) == (all.coupled.tension_ratio >= 0));
    }
}

/* Exactly what sp_memory says, also for the arrays a budget wants. */
static void exact_memory(const budget_case *c)
{
    sp_scene s;
    sp_settings set = settings_of(c);
    size_t bytes = 0;
    test_arena.used = 0;
    NEED(scene_of(c, &s));
    set.budget = 1000000;
    NEED(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes) == SP_OK);
    for (int less = 0; less < 2; less++) {
        sp_result r;
        sp_arena a = test_arena;
        a.base += a.used + SP_ALIGN - a.used % SP_ALIGN;
        a.used = 0;
        a.capacity = bytes - (size_t)less;
        CHECK_INT(sp_check(&s, &set, &a, &r), less ? SP_E_MEMORY : SP_OK);
    }
}

TEST(memory_on_a_budget_is_exact)
{
    static const budget_case each[] = {
        { "arch", "t", 0.14, 0, "x" }, { "arch", "t", 0.14, 0, "p" }, { "arch", "t", 0.14, 0, "l" },
    };
    for (size_t k = 0; k < sizeof each / sizeof each[0]; k++) exact_memory(&each[k]);
}

TEST_LIST(budget)
    RUN(no_check_costs_more_than_its_budget_and_more_of_it_never_proves_less)
    RUN(a_plan_keeps_to_a_budget_and_decides_with_less_of_it)
    RUN(more_rounds_of_projections_never_balance_less)
    RUN(a_budget_of_next_to_nothing_is_no_verdict)
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
    RUN(the_penalty_program_keeps_to_what_is_left)
#endif
    RUN(a_coupled_check_keeps_to_its_budget_and_more_of_it_takes_no_answer_back)
    RUN(memory_on_a_budget_is_exact)
TEST_END
