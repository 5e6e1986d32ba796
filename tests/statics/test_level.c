/* Searches in 3 rows a block: which joints count, what is a forest, what has no friction, what is a mirror. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/scene/joint.c"
#include "../../solvers/statics/newton.c"

#if SP__WITH_REDUCTION

static sp_scene s;
static sp_problem pb;
static sp_settings set;
static sp__reduction *o;
static sp_cost cost;

/* Two cubes side by side on a plate, feet warped like a saddle by so much; they touch or they do not. */
static void pair(double mu, int touch, double warp)
{
    const sp_capacity cap = { 3, 0, 0, 0, 3, 12, 0 };
    const sp_real ground[3] = { 0, 0, R(-5) }, h = R(warp);
    const sp_real side[12] = { 1, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1 };
    const sp_strength rough = { R(mu), 0, 0, 0 };
    test_arena.used = 0;
    memset(&set, 0, sizeof set);
    memset(&cost, 0, sizeof cost);
    set.tol = R(TOL(1e-9, 1e-4f));
    set.stage[0] = SP_STAGE_EXACT;
    set.stage_count = 1;
    set.iterations = SP__ITERATIONS;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const sp_real x = R(k), at[3] = { x + R(0.5), R(0.5), R(0.5) };
        const sp_real foot[12] = { x, 0, h, x + 1, 0, -h, x + 1, 1, h, x, 1, -h };
        CHECK_INT(sp_scene_body(&s, R(1000), at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, k + 1, 4, foot, &rough, NULL), SP_OK);
    }
    if (touch) CHECK_INT(sp_scene_joint(&s, 1, 2, 4, side, &rough, NULL), SP_OK);
    CHECK_INT(sp_problem_build(&s, &test_arena, &pb), SP_OK);
}

/* In 3 rows: level joints where depth is asked for. */
static sp__system *level(void)
{
    set.effect[SP_EFFECT_DEPTH] = SP_WITH;
    o = sp__take(&test_arena, 1, sizeof *o);
    CHECK_INT(sp__reduction_choose(&pb, &set, o), 1);
    CHECK_INT(o->mode, SP__LEVEL_JOINTS);
    sp__system *w = sp__system_make(&pb, &set, SP__EXACT, o, &cost, &test_arena);
    CHECK(w != NULL);
    return w;
}

/* Joints across the loads do not count, and with one of them friction may help even without: it holds in no way that is known. */
TEST(a_scene_is_a_forest_without_joints_across_or_warped_ones)
{
    static const struct { double mu, warp; int touch, forest, frictionless; } row[] = {
        { 0.5, 0, 0, 1, 0 }, { 0, 0, 0, 1, 1 }, { 0, 0, 1, 0, 0 }, { 0.5, 0, 1, 0, 0 }, { 0.5, TOL(2e-7, 0), 0, TOL(0, 1), 0 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        pair(row[k].mu, row[k].touch, row[k].warp);
        if (!level()) return;
        CHECK_INT(o->forest, row[k].forest);
        CHECK_INT(o->frictionless, row[k].frictionless);
        CHECK_INT(o->vertices, 8);
    }
}

/* Both rise alike: they are one group by the joint between them, which counts in 6 rows alone. */
TEST(a_joint_that_does_not_count_ties_no_group)
{
    for (int rows = 3; rows <= 6; rows += 3)
        for (int touch = 0; touch < 2; touch++) {
            sp_real x[12] = { 0 };
            int32_t up[3];
            pair(0.5, touch, 0);
            sp__system *w = rows == 3 ? level() : sp__system_make_full(&pb, &set, SP__EXACT, &cost, &test_arena);
            if (!CHECK(w != NULL)) return;
            sp__system_weights(w);
            for (int i = 0; i < 2; i++) x[6 * i + 2] = 1 / w->measure.weight[2 * i];
            sp__rigid_groups(w, x, R(1e-3), up);
            CHECK_INT(sp__root(up, 1) == sp__root(up, 2), rows == 6 && touch);
            CHECK(sp__root(up, 1) != 0);
        }
}

/* Corners that mirror each other in the plane and not in height are no images. */
TEST(a_warped_joint_has_no_mirror)
{
    for (int warped = 0; warped < 2; warped++) {
        pair(0.5, 1, warped ? TOL(2e-7, 0) : 0);
        o = sp__take(&test_arena, 1, sizeof *o);
        CHECK_INT(sp__reduction_choose(&pb, &set, o) && o->mode == SP__PLANE, !warped || TOL(0, 1));
    }
}

#endif

TEST_LIST(level)
#if SP__WITH_REDUCTION
    RUN(a_scene_is_a_forest_without_joints_across_or_warped_ones)
    RUN(a_joint_that_does_not_count_ties_no_group)
    RUN(a_warped_joint_has_no_mirror)
#endif
TEST_END
