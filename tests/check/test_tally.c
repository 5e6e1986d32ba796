/* Work of small questions, counted to the flop: checks by every stage and plan, coupled checks, strong verdicts, sliding limits,
 * building sequences. A search that is changed goes another way, which its verdict hardly ever tells. */
#include "../scenes/tally.h"

#if !defined SP_NO_IPM && !defined SP_SMALL && !defined SP_NO_CRA && !defined SP_NO_STRONG && !defined SP_NO_SLIDING \
 && !defined SP_NO_QP && !defined SP_NO_ADMM && !defined SP_NO_DYKSTRA && !defined SP_QP_NO_CG && !defined SP_QP_NO_POLISH \
 && !defined SP_QP_NO_INTERIOR && !defined SP_EXACT_ONLY && !defined SP_QP_ONLY
#define TALLY_ALL

/* How a scene is asked. */
typedef enum ask { PLANNED, IN_SPACE, TOGETHER, FINE, IN_4, AROUND_8, IN_16, NO_HELP, LESS_BOUND, LEAST_SQUARES, DENSE, POLISH,
                   BY_ADMM, NET, SEEDED, COUPLED, COUPLED_8, COUPLED_TREE, COUPLED_BOX, COUPLED_SOFT, ROUNDS } ask;

typedef struct count {
    tally_scene of;
    ask how;
    int budget;                                         /* share of the flops of the whole, in hundredths; 0: all of it */
    tally is;
} count;

static void alone(sp_settings *set, sp_stage_id stage)
{
    set->stage_count = 1;
    set->stage[0] = stage;
}

static sp_settings asked(ask how)
{
    sp_settings set = how == SEEDED ? sp_settings_seed() : sp_settings_default();
    if (how == IN_SPACE || how == TOGETHER) set.effect[SP_EFFECT_DEPTH] = set.effect[SP_EFFECT_FRICTION] = SP_WITH;
    if (how == TOGETHER) set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
    if (how == FINE) set.tol = R(TOL(1e-12, 1e-5));
    if (how == IN_4 || how == AROUND_8 || how == IN_16 || how == COUPLED_8) set.faces = how == IN_4 ? 4 : how == IN_16 ? 16 : 8;
    set.inscribed = how == IN_4 || how == IN_16;
    if (how == NO_HELP) set.localise = 0;
    if (how == LESS_BOUND) set.force_bound = 10;
    if (how == LEAST_SQUARES) alone(&set, SP_STAGE_LEAST_SQUARES);
    if (how == DENSE) alone(&set, SP_STAGE_DENSE);
    if (how == POLISH) alone(&set, SP_STAGE_POLISH);
    if (how == BY_ADMM || how == NET) alone(&set, SP_STAGE_ADMM);
    set.penalty.net = how == NET;
    if (how >= COUPLED) set.coupled.asked = 1;
    if (how == COUPLED_TREE) set.coupled.eps = 0;
    if (how == COUPLED_BOX) set.coupled.box = 1;
    if (how == COUPLED_SOFT) set.coupled.eta = R(1e-6);
    if (how == ROUNDS) set.coupled.rounds = 3;
    return set;
}

static void compare(const count *rows, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const count *c = &rows[k];
        const sp_scene s = tally_make(&c->of);
        const sp_arena mark = test_arena;
        sp_settings set = asked(c->how);
        sp_result r;
        CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
        if (c->budget) {
            set.budget = r.spent.total.flops * c->budget / 100;
            test_arena = mark;
            CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
        }
        tally_compare(c->of.name, k, &c->is, (int)r.verdict + 10 * (int)r.coupled.verdict, &r.spent.total);
    }
}

#define COMPARE(rows) compare(rows, sizeof (rows) / sizeof *(rows))

TEST(planned_checks_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 1209 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 6, 4, 0, 4832 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 3, 2, 0, 20111 } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 1209 } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 7, 5, 0, 7229 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 2, 1, 0, 4316 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 5, 3, 0, 7437 } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 4, 3, 0, 27664 } },
        { { "tower", "n", 4, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 5823 } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 9, 7, 2, 179193 } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 4, 3, 0, 63844 } },
        { { "diamond", "rows", 4, 0.1, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 6, 5, 3, 640205 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 8, 6, 0, 73544 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 2, 1, 0, 4316 } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 2747 } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 6, 4, 0, 13846 } },
        { { "overhang", "n", 4, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 5823 } },
        { { "overhang", "factor", 1.1, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 6, 4, 0, 36072 } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 5313 } }
    };
    COMPARE(rows);
}

TEST(walls_and_shells_take_the_work_written_here)
{
    static const count rows[] = {
        { { "wall", "bricks", 2, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 72601 } },
        { { "wall", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 95968 } },
        { { "arch", "t", 0.1, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 2, 9, 7, 0, 300239 } },
        { { "rubble", "bricks", 2, 0.5, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 3, 2, 0, 113130 } },
        { { "wall", "rows", 2, 0, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 56466 } },
        { { "vault", "around", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 0, { 1, 1, 0, 0, 279192 } }
    };
    COMPARE(rows);
}

TEST(checks_in_space_and_together_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 1, 0, 0, 5313 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 2, 5, 4, 0, 17645 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 3, 2, 0, 70203 } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 2, 6, 5, 0, 27272 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 2, 1, 0, 14988 } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 4, 3, 0, 101336 } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 2, 8, 7, 2, 515612 } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 4, 3, 0, 241194 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 2, 7, 6, 0, 233718 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, IN_SPACE, 0, { 1, 2, 1, 0, 14988 } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 0 }, 0 }, TOGETHER, 0, { 2, 5, 4, 0, 44558 } },
        { { "overhang", "factor", 1.1, 0.84, { 0, 0, 0 }, 0 }, TOGETHER, 0, { 2, 5, 4, 0, 105217 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, TOGETHER, 0, { 2, 4, 3, 0, 24530 } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, TOGETHER, 0, { 1, 1, 0, 0, 5313 } }
    };
    COMPARE(rows);
}

TEST(checks_of_other_accuracy_take_the_work_written_here)
{
    static const count rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, FINE, 0, { 1, 3, 2, 0, 20111 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, FINE, 0, { 1, 3, 2, 0, 4997 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, FINE, 0, { 2, 6, 4, 0, 4832 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, FINE, 0, { 1, 2, 1, 0, 4316 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, LESS_BOUND, 0, { 1, 3, 2, 0, 20111 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, LESS_BOUND, 0, { 2, 5, 3, 0, 7437 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, LESS_BOUND, 0, { 1, 2, 1, 0, 4316 } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, LESS_BOUND, 0, { 2, 7, 5, 0, 7229 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, NO_HELP, 0, { 2, 2, 1, 0, 2920 } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, NO_HELP, 0, { 2, 5, 4, 2, 148617 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, NO_HELP, 0, { 2, 1, 0, 0, 3789 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, NO_HELP, 0, { 2, 4, 3, 0, 40684 } }
    };
    COMPARE(rows);
}

TEST(checks_with_pyramids_take_the_work_written_here)
{
    static const count rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 1, 3, 2, 0, 20111 } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 1, 1, 0, 0, 5313 } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 2, 6, 4, 0, 6908 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 1, 2, 1, 0, 4316 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, IN_4, 0, { 2, 8, 6, 0, 76456 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, AROUND_8, 0, { 1, 3, 2, 0, 20111 } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 0 }, AROUND_8, 0, { 2, 7, 5, 0, 7229 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, AROUND_8, 0, { 2, 5, 3, 0, 7437 } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 0 }, AROUND_8, 0, { 2, 9, 7, 2, 179193 } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, IN_16, 0, { 1, 1, 0, 0, 5313 } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, IN_16, 0, { 1, 4, 3, 0, 27664 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, IN_16, 0, { 1, 2, 1, 0, 4316 } }
    };
    COMPARE(rows);
}

TEST(checks_by_other_stages_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, LEAST_SQUARES, 0, { 1, 1, 0, 0, 3283 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, LEAST_SQUARES, 0, { 0, 1, 0, 0, 22991 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, LEAST_SQUARES, 0, { 0, 1, 0, 0, 3643 } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, DENSE, 0, { 1, 1, 0, 0, 3264 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, DENSE, 0, { 0, 1, 0, 0, 32256 } },
        { { "wall", "rows", 2, 0, { 0, 0, 0 }, 0 }, DENSE, 0, { 1, 1, 0, 0, 532224 } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, POLISH, 0, { 1, 1, 0, 0, 3987 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, POLISH, 0, { 1, 1, 171, 0, 140363 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, POLISH, 0, { 0, 1, 250, 0, 110347 } }
    };
    COMPARE(rows);
}

TEST(checks_by_programs_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, BY_ADMM, 0, { 1, 4, 100, 0, 938742 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, BY_ADMM, 0, { 0, 12, 103, 0, 978188 } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, BY_ADMM, 0, { 1, 4, 100, 0, 417294 } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, NET, 0, { 1, 4, 100, 0, 437302 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, NET, 0, { 2, 43, 140, 0, 607223 } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, SEEDED, 0, { 1, 1, 0, 0, 5281 } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, SEEDED, 0, { 1, 1, 0, 0, 5281 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, SEEDED, 0, { 1, 2, 133, 0, 119332 } }
    };
    COMPARE(rows);
}

TEST(glued_and_crushed_checks_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 1 }, PLANNED, 0, { 2, 6, 4, 0, 7708 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 3 }, PLANNED, 0, { 1, 1, 0, 0, 1476 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 7 }, PLANNED, 0, { 1, 1, 0, 0, 1476 } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 1 }, PLANNED, 0, { 1, 1, 0, 0, 1476 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 1 }, PLANNED, 0, { 1, 2, 1, 0, 5736 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 2 }, PLANNED, 0, { 2, 8, 6, 0, 95272 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 7 }, PLANNED, 0, { 1, 2, 1, 0, 26704 } },
        { { "tower", "lean", 0.2, 0.84, { 0, 0, 0 }, 4 }, PLANNED, 0, { 2, 42, 40, 0, 1581948 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 4 }, PLANNED, 0, { 1, 3, 2, 0, 26897 } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 5 }, PLANNED, 0, { 1, 4, 3, 0, 37448 } },
        { { "overhang", "factor", 1.1, 0.84, { 0, 0, 0 }, 3 }, PLANNED, 0, { 1, 1, 0, 0, 9004 } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 0 }, 6 }, PLANNED, 0, { 2, 6, 4, 0, 18216 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 1 }, IN_SPACE, 0, { 1, 2, 1, 0, 14988 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 3 }, IN_SPACE, 0, { 1, 2, 1, 0, 68336 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 4 }, IN_SPACE, 0, { 1, 3, 2, 0, 70203 } },
        { { "incline", "angle", 45, 0.84, { 0, 0, 0 }, 1 }, IN_4, 0, { 1, 1, 0, 0, 1476 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 5 }, IN_4, 0, { 1, 2, 1, 0, 21312 } }
    };
    COMPARE(rows);
}

TEST(budgets_end_checks_where_written_here)
{
    static const count rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 30, { 0, 1, 0, 0, 5904 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 60, { 0, 3, 2, 0, 11757 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 90, { 0, 4, 3, 0, 15104 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, PLANNED, 30, { 0, 2, 1, 0, 2019 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, PLANNED, 60, { 0, 4, 3, 0, 3488 } },
        { { "keystone", "angle", 20, 0.3, { 0, 0, 0 }, 0 }, PLANNED, 90, { 0, 4, 3, 0, 3488 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 30, { 0, 4, 3, 0, 19956 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 60, { 0, 4, 2, 0, 43238 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, PLANNED, 90, { 2, 7, 5, 0, 65599 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 2 }, PLANNED, 30, { 0, 2, 1, 0, 27426 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 2 }, PLANNED, 60, { 0, 5, 3, 0, 57105 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 2 }, PLANNED, 90, { 2, 6, 4, 0, 83617 } }
    };
    COMPARE(rows);
}

TEST(coupled_checks_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 3609 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 22, 32, 25, 0, 89614 } },
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 11, 6, 0, 72483 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 22, 1122, 1101, 0, 27700664 } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 15, 10, 0, 87399 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 22, 7260, 7186, 0, 41302688 } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 11, 6, 0, 186398 } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, COUPLED_8, 0, { 11, 1, 0, 0, 3609 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_8, 0, { 22, 1122, 1101, 0, 22818488 } }
    };
    COMPARE(rows);
}

TEST(coupled_checks_of_other_lengths_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, COUPLED_TREE, 0, { 11, 1, 0, 0, 1929 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, COUPLED_TREE, 0, { 11, 11, 7, 0, 19817 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_BOX, 0, { 22, 1122, 1101, 0, 19256480 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_SOFT, 0, { 22, 2419, 1650, 0, 8932843 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, COUPLED_SOFT, 0, { 22, 3692, 3491, 0, 11817906 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 40, { 30, 1236, 1218, 0, 16520992 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 40, { 30, 1108, 1090, 0, 11080189 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 80, { 30, 1108, 1091, 0, 22160528 } }
    };
    COMPARE(rows);
}

TEST(coupled_trees_and_rings_take_the_work_written_here)
{
    static const count rows[] = {
        { { "tower", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 11485 } },
        { { "incline", "turn", 30, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 7713 } },
        { { "incline", "angle", 40, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 2, 1, 0, 4632 } },
        { { "overhang", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 11485 } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 7547 } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, COUPLED_8, 0, { 11, 1, 0, 0, 3609 } },
        { { "overhang", "factor", 0.99, 0.84, { 0, 0, 0 }, 0 }, COUPLED_BOX, 0, { 11, 1, 0, 0, 19361 } },
        { { "topple", "angle", 10, 0.84, { 0, 0, 0 }, 0 }, COUPLED_TREE, 0, { 11, 1, 0, 0, 3609 } },
        { { "inverted-triangle", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 1, 0, 0, 11485 } },
        { { "inverted-triangle", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED_SOFT, 0, { 11, 1, 0, 0, 11485 } },
        { { "keystone", "angle", -10, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 10, 5, 0, 20384 } },
        { { "keystone", "angle", -10, 0.3, { 0, 0, 0 }, 0 }, COUPLED_8, 0, { 11, 10, 5, 0, 20384 } },
        { { "two-cubes", "offset", 0.45, 0.84, { 0, 0, 0 }, 0 }, COUPLED_BOX, 0, { 11, 1, 0, 0, 3609 } },
        { { "arch", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 50, { 30, 6, 4, 0, 24712 } },
        { { "arch", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 0, { 11, 13, 8, 0, 49465 } },
        { { "flat-arch", "n", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 70, { 30, 10, 7, 0, 28308 } },
        { { "flat-arch", "n", 2, 0.84, { 0, 0, 0 }, 0 }, COUPLED_BOX, 0, { 11, 14, 9, 0, 40608 } },
        { { "tower", "n", 3, 0.84, { 0, 0, 0 }, 0 }, COUPLED, 50, { 30, 1, 0, 0, 3851 } }
    };
    COMPARE(rows);
}

TEST(alternations_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 11, 4, 0, 0, 10538 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, ROUNDS, 0, { 22, 31, 59, 0, 26829199 } }
    };
    COMPARE(rows);
}

/* kind: the verdict and its reason; iterations: starts that were tried. */
TEST(strong_verdicts_take_the_work_written_here)
{
    static const struct { tally_scene of; tally is; } rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, 0 }, 0 }, { 14, 0, 0, 0, 2880 } },
        { { "incline", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, { 64, 0, 0, 0, 3240 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, { 22, 0, 22, 0, 2701920 } },
        { { "h-model", "mu", 0.84, 0.84, { 0, 0, 0 }, 0 }, { 22, 0, 22, 0, 2898720 } },
        { { "flat-arch", "n", 2, 0.84, { 0, 0, 0 }, 0 }, { 53, 0, 28, 0, 20411868 } },
        { { "keystone", "angle", -10, 0.84, { 0, 0, 0 }, 0 }, { 53, 0, 28, 0, 6138492 } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, { 14, 0, 0, 0, 7920 } },
        { { "inverted-triangle", "rows", 2, 0.84, { 0, 0, 0 }, 0 }, { 14, 0, 0, 0, 9720 } }
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const sp_scene s = tally_make(&rows[k].of);
        sp_strong_settings how = sp_strong_settings_default();
        sp_strong_result x;
        sp_result r;
        how.starts = 6;
        CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_OK);
        CHECK_INT(sp_strong(&s, NULL, &how, r.f, NULL, &test_arena, &x), SP_OK);
        sp_cost cost = x.cost;
        cost.iterations = x.starts;
        tally_compare(rows[k].of.name, k, &rows[k].is, (int)x.kind + 10 * (int)x.reason, &cost);
    }
}

TEST(sliding_limits_take_the_work_written_here)
{
    static const struct { tally_scene of; tally is; } rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 43242 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 757664 } },
        { { "tower", "n", 4, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 505288 } },
        { { "incline", "angle", 20, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 85126 } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, { 10, 0, 0, 0, 7782924 } },
        { { "diamond", "rows", 3, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 3484668 } },
        { { "keystone", "angle", 10, 0.5, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 6780604 } },
        { { "cantilever", "reach", 1, 0.84, { 0, 0, -1 }, 0 }, { 10, 0, 0, 0, 6683546 } },
        { { "tower", "n", 3, 0.1, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 307650 } },
        { { "inverted-triangle", "rows", 2, 0.84, { 1, 0, 0.2 }, 0 }, { 1, 0, 0, 0, 215496 } },
        { { "overhang", "n", 3, 0.84, { 1, 0, 0 }, 0 }, { 1, 0, 0, 0, 280950 } },
        { { "arch", "n", 7, 0.3, { 1, 0, 0 }, 0 }, { 10, 0, 0, 0, 275744 } }
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const sp_scene s = tally_make(&rows[k].of);
        sp_sliding_settings how = sp_sliding_settings_default();
        sp_sliding_result x;
        sp_limit_result limit;
        how.starts = 2;
        CHECK_INT(sp_limit(&s, NULL, &test_arena, &limit), SP_OK);
        CHECK_INT(sp_sliding(&s, NULL, &how, &limit, &test_arena, &x), SP_OK);
        tally_compare(rows[k].of.name, k, &rows[k].is, (int)x.kind + 10 * (int)x.reason, &x.cost);
    }
}

/* Block after block; then what must be held, and what may come or go next. kind: steps that do not stand, stones held. */
TEST(building_takes_the_work_written_here)
{
    static const struct { tally_scene of; int backward; tally is; } rows[] = {
        { { "arch", "n", 5, 0.84, { 0, 0, 0 }, 0 }, 0, { 404, 69, 39, 0, 287529 } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, { 303, 98, 62, 5, 814103 } },
        { { "diamond", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 1, { 1508, 72, 28, 0, 551331 } },
        { { "overhang", "n", 4, 0.84, { 0, 0, 0 }, 0 }, 0, { 0, 5, 0, 0, 24589 } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, 0 }, 0 }, 0, { 303, 55, 35, 3, 211888 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, { 202, 61, 37, 5, 413280 } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, 0, { 101, 7, 3, 0, 13433 } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, 0 }, 0 }, 1, { 101, 3, 1, 0, 7365 } },
        { { "wall", "rows", 3, 0.84, { 0, 0, 0 }, 0 }, 0, { 0, 41, 15, 0, 246223 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, 0 }, 0 }, 0, { 0, 2, 1, 0, 5276 } }
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        const sp_scene s = tally_make(&rows[k].of);
        const int32_t n = s.count.blocks;
        sp_cost cost;
        sp_sequence *q;
        sp_suggestion next;
        int falls = 0, held = 0;
        memset(&cost, 0, sizeof cost);
        CHECK_INT(sp_sequence_open(&s, NULL, &test_arena, &q), SP_OK);
        for (int32_t i = 0; i < n; i++) {
            const int32_t b = rows[k].backward ? n - 1 - i : i;
            sp_held hold;
            sp_step step;
            if (s.block[b].fixed == SP_FIXED) continue;
            CHECK_INT(sp_sequence_set(q, b, SP_PRESENT, &step), SP_OK);
            tally_add(&cost, &step.cost);
            if (step.verdict == SP_STABLE) continue;
            falls++;
            CHECK_INT(sp_sequence_hold(q, 0, &hold), SP_OK);
            tally_add(&cost, &hold.cost);
            held += hold.count;
        }
        CHECK_INT(sp_sequence_suggest(q, 0, 0, &next), SP_OK);
        tally_add(&cost, &next.cost);
        tally_compare(rows[k].of.name, k, &rows[k].is, falls + 100 * held, &cost);
    }
}

#endif

TEST_LIST(tally)
#ifdef TALLY_ALL
    RUN(planned_checks_take_the_work_written_here)
    RUN(walls_and_shells_take_the_work_written_here)
    RUN(checks_in_space_and_together_take_the_work_written_here)
    RUN(checks_of_other_accuracy_take_the_work_written_here)
    RUN(checks_with_pyramids_take_the_work_written_here)
    RUN(checks_by_other_stages_take_the_work_written_here)
    RUN(checks_by_programs_take_the_work_written_here)
    RUN(glued_and_crushed_checks_take_the_work_written_here)
    RUN(budgets_end_checks_where_written_here)
    RUN(coupled_checks_take_the_work_written_here)
    RUN(coupled_checks_of_other_lengths_take_the_work_written_here)
    RUN(coupled_trees_and_rings_take_the_work_written_here)
    RUN(alternations_take_the_work_written_here)
    RUN(strong_verdicts_take_the_work_written_here)
    RUN(sliding_limits_take_the_work_written_here)
    RUN(building_takes_the_work_written_here)
#endif
TEST_END
