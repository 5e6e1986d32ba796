/* What a step reports of its blocks, and what certifies one of them, of states that are changed by hand. */
#define SP_API static
#include "../test.h"

#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/scene/joint.c"
#include "../../solvers/sequence/calls.c"

#if SP__WITH_LARGE

static const sp_real W = R(1000 * 9.80665);

static sp_scene s;
static sp_sequence *q;

/* Two cubes of 1 m on a plate, apart, both there: at every corner a quarter of their weight. */
static void laid(void)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 0 };
    const sp_real ground[3] = { 0, 0, R(-5) };
    const sp_strength mu = { R(0.5), 0, 0, 0 };
    const sp_presence all[3] = { SP_PRESENT, SP_PRESENT, SP_PRESENT };
    sp_step step;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const sp_real x = R(4 * k), at[3] = { x + R(0.5), R(0.5), R(0.5) };
        const sp_real foot[12] = { x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0 };
        CHECK_INT(sp_scene_body(&s, R(1000), at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, k + 1, 4, foot, &mu, NULL), SP_OK);
    }
    CHECK_INT(sp_sequence_open(&s, NULL, &test_arena, &q), SP_OK);
    CHECK_INT(sp_sequence_fill(q, all, &step), SP_OK);
    CHECK_INT(step.verdict, SP_STABLE);
    for (int k = 0; k < 24; k++) q->now.f[k] = k % 3 ? 0 : W / 4;
}

/* Of blocks that stand one with forces tells why; of others the worst, the first of them. */
TEST(a_step_tells_of_its_worst_block_and_of_forces_before_nothing)
{
    static const struct { sp_verdict v[2]; sp_reason r[2]; sp_verdict is; sp_reason why; } row[] = {
        { { SP_STABLE, SP_STABLE }, { SP_REASON_NOTHING, SP_REASON_NOTHING }, SP_STABLE, SP_REASON_NOTHING },
        { { SP_STABLE, SP_STABLE }, { SP_REASON_NOTHING, SP_REASON_FORCES }, SP_STABLE, SP_REASON_FORCES },
        { { SP_STABLE, SP_STABLE }, { SP_REASON_FORCES, SP_REASON_NOTHING }, SP_STABLE, SP_REASON_FORCES },
        { { SP_STABLE, SP_UNSTABLE }, { SP_REASON_FORCES, SP_REASON_MECHANISM }, SP_UNSTABLE, SP_REASON_MECHANISM },
        { { SP_UNDECIDED, SP_STABLE }, { SP_REASON_LIMIT, SP_REASON_FORCES }, SP_UNDECIDED, SP_REASON_LIMIT },
        { { SP_UNSTABLE, SP_UNDECIDED }, { SP_REASON_NO_SUPPORT, SP_REASON_LIMIT }, SP_UNSTABLE, SP_REASON_NO_SUPPORT }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        sp_step step;
        laid();
        for (int b = 0; b < 2; b++) {
            q->now.state[b + 1].verdict = row[k].v[b];
            q->now.state[b + 1].reason = row[k].r[b];
        }
        sp__sequence_report(q, &step);
        CHECK_INT(step.verdict, row[k].is);
        CHECK_INT(step.reason, row[k].why);
        CHECK_INT(step.blocks, 2);
        CHECK_INT(step.islands, 2);
    }
}

/* In balance, with an arm, and no force at a corner above the bound, here of the weight: a quarter of it is there. */
TEST(a_block_is_certified_in_balance_with_an_arm_and_no_large_force)
{
    static const struct { double share, bound, arm; int certified; } row[] = {
        { 1, 1e3, 1, 1 }, { 1, 0.3, 1, 1 }, { 1, 0.2, 1, 0 }, { 1, 1e3, 0, 0 }, { 0.9, 1e3, 1, 0 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        laid();
        q->set.force_bound = R(row[k].bound);
        for (int e = 0; e < 2; e++) q->graph.lever[e] *= R(row[k].arm);
        for (int e = 0; e < 12; e++) q->now.f[e] *= R(row[k].share);
        sp__block_certify(q, 1);
        CHECK_INT(q->now.state[1].certified, row[k].certified);
        if (row[k].share < 1) CHECK_WITHIN(q->now.state[1].imbalance, 0.1 / 1.8, TOL(1e-12, 1e-5));
        else CHECK(q->now.state[1].imbalance <= q->set.tol);
    }
}

#endif

TEST_LIST(report)
#if SP__WITH_LARGE
    RUN(a_step_tells_of_its_worst_block_and_of_forces_before_nothing)
    RUN(a_block_is_certified_in_balance_with_an_arm_and_no_large_force)
#endif
TEST_END
