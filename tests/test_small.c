/* small: what a build with SP_EXACT_ONLY leaves out, it refuses; every other build does it. */
#include "test.h"
#include "scenes/gen.h"

#include <string.h>

#ifdef SP_EXACT_ONLY
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
    CHECK_INT(sp_memory(s, set, test_arena, &bytes), want);
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
    set.seed = sp_seed_table();
    answered(&s, &set, LEFT_OUT);
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
    s.interface[0].joint.cohesion = 1000;
    answered(&s, NULL, LEFT_OUT);
}

TEST_LIST(small)
    RUN(the_default_settings_are_taken_by_every_build)
    RUN(pyramids_and_the_tables_of_the_seed_are_refused_by_the_smallest_build)
    RUN(stages_but_gates_and_the_exact_one_are_refused_by_the_smallest_build)
    RUN(strength_of_joints_is_refused_by_the_smallest_build)
TEST_END
