/* Rungs of a check on their own: what evidence proves, what islands and plans make of it, where memory ends between them. */
#define SP_API static
#include "../test.h"

#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/scene/joint.c"
#include "../../solvers/check/check.c"
#include "../../solvers/check/plan.c"

#if SP__WITH_LARGE

#define G R(9.80665)
#define W (R(1000) * G)                                 /* weight of a cube */

static sp_scene s;
static sp_settings set;
static sp_problem pb;
static sp_state state;
static sp_result r;

/* Cubes of 1 m on a plate, apart, each pulled up by so much. */
static void cubes(int32_t n, sp_real up)
{
    const sp_capacity cap = { n + 1, 0, 0, 0, n, 4 * n, n };
    const sp_strength mu = { R(0.5), 0, 0, 0 };
    const sp_real ground[3] = { 0, 0, R(-5) };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int32_t k = 0; k < n; k++) {
        const sp_real x = (sp_real)(3 * k), at[3] = { x + R(0.5), R(0.5), R(0.5) };
        const sp_real foot[12] = { x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0 };
        const sp_load pull = { k + 1, 0, { x + R(0.5), R(0.5), R(0.5) }, { 0, 0, up }, { 0, 0, 0 }, 0 };
        CHECK_INT(sp_scene_body(&s, R(1000), at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, k + 1, 4, foot, &mu, NULL), SP_OK);
        CHECK_INT(sp_scene_load(&s, &pull, NULL), SP_OK);
    }
    CHECK_INT(sp__settings_resolve(&s, NULL, &set), SP_OK);
}

/* One cube, a result and what stages leave: forces at its corners, a motion upwards. */
static void one(sp_real up, sp_real force, sp_real rise)
{
    cubes(1, up);
    CHECK_INT(sp_problem_build(&s, &test_arena, &pb), SP_OK);
    memset(&state, 0, sizeof state);
    memset(&r, 0, sizeof r);
    state.f = sp__take(&test_arena, 12, sizeof *state.f);
    state.y0 = sp__take(&test_arena, 12, sizeof *state.y0);
    state.y = sp__take(&test_arena, 6, sizeof *state.y);
    state.dq = sp__take(&test_arena, 6, sizeof *state.dq);
    r.f = sp__take(&test_arena, 12, sizeof *r.f);
    r.dq = sp__take(&test_arena, 12, sizeof *r.dq);
    for (int k = 0; k < 12; k++) state.f[k] = k % 3 ? 0 : force;
    for (int k = 0; k < 12; k++) r.f[k] = r.dq[k] = state.y0[k] = 0;
    for (int k = 0; k < 6; k++) { state.dq[k] = k == 2 ? rise : 0; state.y[k] = 0; }
    r.tol = set.tol;
    r.imbalance = 1;
}

static sp_arena with(size_t bytes)
{
    sp_arena a = test_arena;
    a.capacity = a.used + bytes;
    return a;
}

/* ------------------------------------------------------------------------------------------------------------- the ladder */

/* On a budget the better proof stays. */
TEST(a_motion_that_proves_less_than_another_is_not_taken)
{
    static const struct { int best; double had; sp_verdict is; } row[] = {
        { 0, 5, SP_UNSTABLE }, { 1, 0, SP_UNSTABLE }, { 1, 5, SP_UNDECIDED }, { 0, 0, SP_UNSTABLE }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        sp__certifier j;
        one(2 * W, 0, 1);
        sp_arena a = test_arena;
        CHECK_INT(sp__certifier_open(&j, &pb, &set, NULL, INT32_MAX, &a), 1);
        r.least_imbalance = R(row[k].had);
        CHECK_INT(sp__verdict_proved(&j, row[k].best, &state, SP_UNSTABLE, &r), row[k].is);
        if (row[k].is) CHECK(r.final && r.dq[8] > 0 && r.least_imbalance > 0 && r.least_imbalance < 5);
        else CHECK_WITHIN(r.least_imbalance, 5, 0);
    }
}

TEST(a_fall_that_is_proved_by_less_than_tol_is_near_the_limit)
{
    static const struct { sp_reason told; sp_verdict claim; double least; sp_reason is; } row[] = {
        { SP_REASON_UNVERIFIED, SP_UNSTABLE, 1e-3, SP_REASON_LIMIT },
        { SP_REASON_UNVERIFIED, SP_UNSTABLE, 0, SP_REASON_UNVERIFIED },
        { SP_REASON_UNVERIFIED, SP_UNDECIDED, 1e-3, SP_REASON_UNVERIFIED },
        { SP_REASON_STAGES, SP_UNSTABLE, 1e-3, SP_REASON_STAGES }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        memset(&r, 0, sizeof r);
        r.imbalance = 1;
        r.least_imbalance = R(row[k].least);
        CHECK_INT(sp__check_reason(SP_STAGE_DENSE, row[k].claim, &r, row[k].told), row[k].is);
    }
}

/* Level joints: forces by scales of the loads alone, then by those of 6 rows, unless a budget or nothing to prove ends it. */
TEST(evidence_of_3_rows_is_judged_twice_where_it_claims_something)
{
    static const struct { sp_verdict claim; double force; int budget, bytes; sp_status status; sp_verdict is; } row[] = {
        { SP_STABLE, 0.25, 0, 1, SP_OK, SP_STABLE }, { SP_STABLE, 0.25, 0, 0, SP_E_MEMORY, SP_UNDECIDED },
        { SP_STABLE, 0, 0, 1, SP_OK, SP_UNDECIDED }, { SP_STABLE, 0, 1, 1, SP_OK, SP_UNDECIDED },
        { SP_UNDECIDED, 0, 0, 1, SP_OK, SP_UNDECIDED }, { SP_UNDECIDED, 0.25, 0, 1, SP_OK, SP_STABLE }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const sp__reduced_outcome found = { row[k].claim, 0, 0, 0 };
        one(0, R(row[k].force) * W, 0);
        sp_arena a = row[k].bytes ? test_arena : with(64);
        set.budget = row[k].budget ? 1000000 : 0;
        CHECK_INT(sp__reduced_evidence(&pb, &set, &found, &state, &a, &r), row[k].status);
        CHECK_INT(r.verdict, row[k].is);
        if (!row[k].status) CHECK_WITHIN(r.imbalance, 1 - 4 * row[k].force, TOL(1e-12, 1e-5));
        CHECK_INT(state.has_y0, k == 2);                /* f0 of 6 rows */
    }
}

/* A motion by gates: proved at once, or with all scales, or open. */
TEST(a_fall_that_gates_tell_of_is_judged_again_where_it_was_not_proved)
{
    static const struct { double rise; int budget, bytes; sp_status status; sp_verdict is; } row[] = {
        { 1, 0, 1, SP_OK, SP_UNSTABLE }, { 0, 0, 1, SP_OK, SP_UNDECIDED }, { 0, 1, 1, SP_OK, SP_UNDECIDED },
        { 1, 0, 0, SP_E_MEMORY, SP_UNDECIDED }
    };
    int64_t flops[4];
    for (size_t k = 0; k < 4; k++) {
        one(2 * W, 0, R(row[k].rise));
        sp_arena a = row[k].bytes ? test_arena : with(64);
        set.budget = row[k].budget ? 1000000 : 0;
        CHECK_INT(sp__stage_evidence(&pb, &set, SP_STAGE_GATES, 1000000, SP_UNSTABLE, &state, &a, &r), row[k].status);
        CHECK_INT(r.verdict, row[k].is);
        flops[k] = state.cost.flops;
    }
    CHECK(flops[1] > flops[2] && flops[3] == 0);
}

/* ---------------------------------------------------------------------------------------------------------------- islands */

static sp__check *c;
static sp__island_loop *w;

/* Two cubes, checked apart: forces of each corner by `share` of their weight; coupled: each sunk by eps. */
static void islands(int coupled, double share)
{
    cubes(2, 0);
    set = sp_settings_default();
    set.coupled.asked = coupled;
    CHECK_INT(sp__check_begin(&s, &set, &test_arena, &c, &w), SP_OK);
    CHECK_INT(c->r.islands.count, 2);
    for (int k = 0; k < 2; k++) {
        memset(&c->r.islands.each[k], 0, sizeof *c->r.islands.each);
        c->r.islands.each[k].verdict = SP_STABLE;
        c->r.islands.each[k].reason = SP_REASON_FORCES;
        c->r.islands.each[k].stage = SP_STAGE_EXACT;
        c->r.islands.each[k].coupling = SP_COUPLING_COUPLED;
    }
    for (int k = 0; k < 24; k++) c->r.f[k] = k % 3 ? 0 : R(share) * W / 4;
}

TEST(islands_that_stand_well_within_tol_stand_together)
{
    static const struct { double imbalance, share; sp_verdict is; } row[] = {
        { 0.5, 1, SP_STABLE }, { 0.9999, 1, SP_STABLE }, { 0.9999, 0.5, SP_UNDECIDED }, { 0.5, 0.5, SP_STABLE }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        islands(0, row[k].share);
        const sp_real was = c->r.imbalance = R(row[k].imbalance) * c->r.tol;
        CHECK_INT(sp__islands_certify(&s, w, c, &test_arena), SP_OK);
        CHECK_INT(c->r.verdict, row[k].is);
        const double apart = (1 - row[k].share) / (1 + row[k].share);
        CHECK_WITHIN(c->r.imbalance, k == 0 || k == 3 ? (double)was : apart, TOL(1e-12, 1e-5));
    }
}

TEST(islands_are_judged_together_only_with_memory)
{
    int kept = 0, short_of = 0;
    for (size_t bytes = 0; bytes < 40000; bytes += 256) {
        islands(0, 1);
        sp_arena a = test_arena;
        a.capacity = w->start + bytes;
        const sp_status status = sp__islands_certify(&s, w, c, &a);
        CHECK(status == SP_OK || status == SP_E_MEMORY);
        CHECK_INT(c->r.verdict == SP_STABLE && c->r.verified, !status);
        if (status) { short_of++; CHECK_INT(kept, 0); } else kept++;
    }
    CHECK(kept > 0 && short_of > 0);
}

TEST(a_loop_over_islands_begins_only_with_memory)
{
    for (int coupled = 0; coupled < 2; coupled++) {
        int begun = 0, fell_short = 0;
        for (size_t bytes = 0; bytes < 20000; bytes += 128) {
            sp__island_loop *is = NULL;
            islands(coupled, 1);
            sp_arena a = with(bytes);
            const sp_status status = sp__island_loop_begin(&s, c, &a, &is);
            CHECK_INT(status, is ? SP_OK : SP_E_MEMORY);
            CHECK(is || !begun);
            if (is) begun++; else fell_short++;
        }
        CHECK(begun > 0 && fell_short > 0);
    }
}

#if SP__WITH_COUPLED
/* What is coupled island by island is a triple of the whole: sunk by eps, pressed by a quarter of the weight. */
TEST(triples_of_islands_are_judged_as_one)
{
    static const struct { double share, sunk; sp_coupling is; } row[] = {
        { 1, 1, SP_COUPLING_COUPLED }, { 0.5, 1, SP_COUPLING_NOT_FOUND }, { 1, -1, SP_COUPLING_NOT_FOUND }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        islands(1, row[k].share);
        CHECK_INT(sp_problem_build(&s, &test_arena, &pb), SP_OK);
        const sp_real eps = sp__coupled_lengths(&pb, &c->set).L;
        for (int e = 0; e < 18; e++) c->r.coupled.dq[e] = e % 6 == 2 && e > 6 ? -R(row[k].sunk) * eps : 0;
        CHECK_INT(sp__islands_certify(&s, w, c, &test_arena), SP_OK);
        CHECK_INT(c->r.coupled.verdict, row[k].is);
        CHECK_INT(c->r.imbalance <= c->r.tol, k != 1);
        CHECK_INT(c->r.coupled.residual <= 1, k != 2);
    }
}

/* The first island that its own search left open gives the reason, not one that statics left open. */
TEST(of_open_islands_the_first_that_is_not_statics_tells_why)
{
    for (int k = 0; k < 4; k++) {
        islands(1, 1);
        c->r.verdict = SP_STABLE;
        c->r.islands.each[k & 1].coupling = SP_COUPLING_NOT_FOUND;
        c->r.islands.each[k & 1].coupling_reason = SP_COUPLING_BUDGET;
        c->r.islands.each[!(k & 1)].coupling = k < 2 ? SP_COUPLING_COUPLED : SP_COUPLING_NOT_FOUND;
        c->r.islands.each[!(k & 1)].coupling_reason = k < 2 ? SP_COUPLING_MOTION : SP_COUPLING_STATICS;
        CHECK_INT(sp__islands_couple(c, &test_arena), SP_OK);
        CHECK_INT(c->r.coupled.verdict, SP_COUPLING_NOT_FOUND);
        CHECK_INT(c->r.coupled.reason, SP_COUPLING_BUDGET);
    }
}

/* A search writes into the room of the proof; where none ran it is kept. */
TEST(a_proof_is_kept_until_another_search_runs)
{
    static const struct { int rounds; sp_coupling verdict; sp_coupling_reason reason; int kept; } row[] = {
        { 0, SP_COUPLING_COUPLED, SP_COUPLING_MOTION, 1 }, { 3, SP_COUPLING_COUPLED, SP_COUPLING_MOTION, 0 },
        { 0, SP_COUPLING_NOT_FOUND, SP_COUPLING_STATICS, 1 }, { 0, SP_COUPLING_NOT_FOUND, SP_COUPLING_BUDGET, 0 },
        { 0, SP_COUPLING_REFUTED, SP_COUPLING_STATICS, 1 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        static sp__check found;
        islands(1, 1);
        memset(&found, 0, sizeof found);
        found.r.coupled.rounds = row[k].rounds;
        found.r.coupled.verdict = row[k].verdict;
        found.r.coupled.reason = row[k].reason;
        w->again = w->proof_kept = 1;
        w->proof.nodes = 5;
        sp__island_loop_collect(w, &found, c, &test_arena);
        CHECK_INT(w->proof_kept, row[k].kept);
        CHECK_INT(sp__island_loop_continues(w, c, 2), !row[k].kept);
    }
}
#endif

/* ------------------------------------------------------------------------------------------------------- memory and plans */

/* Labels of a thousand supports take more than a check. */
TEST(the_memory_of_many_blocks_is_counted_only_with_room_for_their_labels)
{
    const sp_capacity cap = { 3000, 0, 0, 0, 0, 0, 0 };
    const sp_real at[3] = { 0, 0, 0 };
    size_t bytes = 7;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < 3000; k++) CHECK_INT(sp_scene_body(&s, 1, at, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp__memory(&s, NULL, NULL, with(sizeof(sp__check) + 256), &bytes), SP_E_MEMORY);
    CHECK_INT(sp__memory(&s, NULL, NULL, with(sizeof(sp__check) / 2), &bytes), SP_E_MEMORY);
    CHECK_INT((long long)bytes, 7);
    CHECK_INT(sp__memory(&s, NULL, NULL, test_arena, &bytes), SP_OK);
    CHECK(bytes > 3000 * 6 * sizeof(sp_real));
}

#if SP__WITH_PLAN
TEST(a_plan_of_islands_ends_where_memory_does)
{
    int whole = 0, none = 0;
    cubes(3, 0);
    for (size_t bytes = 0; bytes < 40000; bytes += 256) {
        sp__work o;
        memset(&o, 0, sizeof o);
        const sp_status status = sp__plan_islands(&s, 3, &set, with(bytes), &o);
        CHECK_INT(status, o.problems == 3 ? SP_OK : SP_E_MEMORY);
        CHECK_INT(o.unknowns, o.problems * (6 + 3 * 4));
        if (status) { none++; CHECK_INT(whole, 0); } else whole++;
    }
    CHECK(whole > 0 && none > 0);
}

/* Where nothing is free nothing is planned by a mirror, by pressure or as a forest. */
TEST(a_plan_of_no_problem_leaves_every_effect_as_it_is)
{
    static const struct { int problems, plane, level, forests; } row[] = {
        { 0, 0, 0, 0 }, { 2, 2, 1, 1 }, { 2, 1, 2, 1 }, { 2, 1, 1, 2 }, { 2, 2, 2, 2 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        static sp__planner p;
        cubes(1, 0);
        memset(&p, 0, sizeof p);
        p.set = set;
        p.planned.problems = row[k].problems;
        p.planned.reduced[SP__PLANE] = row[k].plane;
        p.planned.reduced[SP__LEVEL_JOINTS] = row[k].level;
        p.planned.forests = row[k].forests;
        sp__plan_effects(&s, &p);
        CHECK_INT(p.o.effect[SP_EFFECT_DEPTH].why == SP_WHY_MIRROR, row[k].plane == 2);
        CHECK_INT(p.o.effect[SP_EFFECT_FRICTION].why == SP_WHY_PRESSURE, row[k].level == 2);
        CHECK_INT(p.o.effect[SP_EFFECT_COUPLED].why == SP_WHY_FOREST, row[k].forests == 2);
    }
}
#endif

#endif

TEST_LIST(rungs)
#if SP__WITH_LARGE
    RUN(a_motion_that_proves_less_than_another_is_not_taken)
    RUN(a_fall_that_is_proved_by_less_than_tol_is_near_the_limit)
    RUN(evidence_of_3_rows_is_judged_twice_where_it_claims_something)
    RUN(a_fall_that_gates_tell_of_is_judged_again_where_it_was_not_proved)
    RUN(islands_that_stand_well_within_tol_stand_together)
    RUN(islands_are_judged_together_only_with_memory)
    RUN(a_loop_over_islands_begins_only_with_memory)
#if SP__WITH_COUPLED
    RUN(triples_of_islands_are_judged_as_one)
    RUN(of_open_islands_the_first_that_is_not_statics_tells_why)
    RUN(a_proof_is_kept_until_another_search_runs)
#endif
    RUN(the_memory_of_many_blocks_is_counted_only_with_room_for_their_labels)
#if SP__WITH_PLAN
    RUN(a_plan_of_islands_ends_where_memory_does)
    RUN(a_plan_of_no_problem_leaves_every_effect_as_it_is)
#endif
#endif
TEST_END
