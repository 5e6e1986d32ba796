/* Work of small limits, counted to the flop. Every search of solvers/limit/ goes another way if a place of it is changed, which
 * the multiplier hardly ever tells: both ends are verified, and whatever finds them later or by luck finds the same. */
#include "../scenes/tally.h"

#if !defined SP_NO_IPM && !defined SP_SMALL

/* budget: share of the flops of the whole search, in hundredths; 0: all of it. */
typedef struct count {
    tally_scene of;
    int faces, inscribed, space, budget;
    tally is;
} count;

static sp_limit_result counted(const count *c)
{
    const sp_scene s = tally_make(&c->of);
    const sp_arena mark = test_arena;
    sp_settings set = sp_settings_default();
    sp_limit_result x;
    memset(&x, 0, sizeof x);
    set.faces = c->faces;
    set.inscribed = c->inscribed;
    if (c->space) set.effect[SP_EFFECT_DEPTH] = SP_WITH;
    CHECK_INT(sp_limit(&s, &set, &test_arena, &x), SP_OK);
    if (c->budget) {
        set.budget = x.cost.flops * c->budget / 100;
        test_arena = mark;
        CHECK_INT(sp_limit(&s, &set, &test_arena, &x), SP_OK);
    }
    return x;
}

static void compare(const count *rows, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        const sp_limit_result x = counted(&rows[k]);
        tally_compare(rows[k].of.name, k, &rows[k].is, (int)x.kind, &x.cost);
    }
}

#define COMPARE(rows) compare(rows, sizeof (rows) / sizeof *(rows))

TEST(pushed_stones_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 9, 7, 7, 26838 } },
        { { "two-cubes", "offset", 0.3, 0.1, { 1, 1, 0 }, 0 }, 0, 0, 0, 0, { 1, 10, 8, 8, 85236 } },
        { { "two-cubes", "offset", 0.6, 0.84, { -1, 0, 0.2 }, 0 }, 0, 0, 0, 0, { 1, 12, 9, 7, 34703 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 0, 0, -1 }, 0 }, 0, 0, 0, 0, { 2, 5, 4, 4, 21089 } },
        { { "incline", "angle", 20, 0.84, { 0, 1, 0 }, 0 }, 0, 0, 0, 0, { 1, 14, 12, 12, 121704 } },
        { { "incline", "angle", 50, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 2, 4, 3, 3, 17955 } },
        { { "incline", "angle", 50, 0.84, { -1, 0, 0 }, 0 }, 0, 0, 0, 0, { 3, 8, 5, 3, 21995 } },
        { { "topple", "angle", 10, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 9, 7, 7, 26838 } },
        { { "keystone", "angle", 10, 0.84, { 0, 0, -1 }, 0 }, 0, 0, 0, 0, { 3, 7, 5, 4, 35239 } },
        { { "keystone", "angle", -10, 0.84, { 0, 0, 1 }, 0 }, 0, 0, 0, 0, { 3, 8, 6, 5, 36104 } }
    };
    COMPARE(rows);
}

TEST(pushed_assemblies_take_the_work_written_here)
{
    static const count rows[] = {
        { { "tower", "n", 4, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 9, 7, 7, 128520 } },
        { { "tower", "n", 4, 0.1, { 0, 1, 0 }, 0 }, 0, 0, 0, 0, { 1, 16, 14, 14, 666551 } },
        { { "overhang", "n", 4, 0.84, { 0, 0, -1 }, 0 }, 0, 0, 0, 0, { 3, 9, 7, 7, 114712 } },
        { { "overhang", "factor", 1.1, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 2, 4, 3, 3, 109305 } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, -1 }, 0 }, 0, 0, 0, 0, { 3, 8, 6, 6, 46738 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 11, 9, 7, 215731 } },
        { { "arch", "n", 7, 0.84, { 0, 1, 0 }, 0 }, 0, 0, 0, 0, { 1, 13, 11, 8, 686971 } },
        { { "arch", "t", 0.08, 0.84, { 1, 0, 0.3 }, 0 }, 0, 0, 0, 0, { 2, 4, 3, 3, 471666 } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 3, 10, 8, 5, 127444 } },
        { { "flat-arch", "n", 4, 0.84, { 0, 0, -1 }, 0 }, 0, 0, 0, 0, { 3, 9, 7, 4, 116175 } },
        { { "diamond", "rows", 3, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 13, 11, 8, 609222 } },
        { { "inverted-triangle", "rows", 2, 0.84, { 0, 1, 0 }, 0 }, 0, 0, 0, 0, { 1, 10, 8, 8, 239110 } }
    };
    COMPARE(rows);
}

TEST(walls_and_shells_that_are_pushed_take_the_work_written_here)
{
    static const count rows[] = {
        { { "wall", "bricks", 2, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 17, 15, 15, 2746459 } },
        { { "wall", "rows", 2, 0.3, { 1, 1, 0 }, 0 }, 0, 0, 0, 0, { 1, 15, 13, 13, 5361508 } },
        { { "wall", "rows", 3, 0, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 9, 7, 7, 2133474 } },
        { { "wall", "tilt", 20, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 23, 21, 16, 17654654 } }
    };
    COMPARE(rows);
}

TEST(shells_and_rubble_that_are_pushed_take_the_work_written_here)
{
    static const count rows[] = {
        { { "rubble", "bricks", 2, 0.5, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 17, 15, 13, 1920830 } },
        { { "vault", "around", 3, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 10, 8, 8, 3855984 } },
        { { "dome", "rings", 1, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 0, { 1, 16, 13, 12, 4276177 } }
    };
    COMPARE(rows);
}

TEST(limits_in_space_and_with_pyramids_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 1, 0, 0 }, 0 }, 4, 1, 0, 0, { 1, 9, 7, 7, 28380 } },
        { { "tower", "n", 3, 0.1, { 1, 1, 0 }, 0 }, 8, 0, 0, 0, { 1, 11, 9, 9, 256903 } },
        { { "tower", "n", 3, 0.84, { 1, 0, 0 }, 0 }, 16, 1, 1, 0, { 1, 10, 8, 8, 243010 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 4, 0, 0, 0, { 1, 11, 9, 7, 203449 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 1, 0, { 1, 11, 9, 7, 567115 } },
        { { "diamond", "rows", 2, 0.5, { 1, 0, 0 }, 0 }, 8, 1, 1, 0, { 1, 11, 9, 9, 490233 } },
        { { "keystone", "angle", 20, 0.3, { 0, 1, 0 }, 0 }, 0, 0, 1, 0, { 2, 3, 2, 2, 62025 } }
    };
    COMPARE(rows);
}

TEST(glued_and_crushed_limits_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.3, 0.84, { 1, 0, 0 }, 1 }, 0, 0, 0, 0, { 1, 8, 4, 0, 34324 } },
        { { "two-cubes", "offset", 0.6, 0.84, { 1, 0, 0 }, 3 }, 0, 0, 0, 0, { 1, 10, 5, 0, 38306 } },
        { { "two-cubes", "offset", 0.3, 0.84, { 0, 0, -1 }, 4 }, 0, 0, 0, 0, { 1, 17, 13, 0, 43974 } },
        { { "incline", "angle", 20, 0.84, { 0, 0, -1 }, 3 }, 0, 0, 0, 0, { 3, 2, 0, 0, 11325 } },
        { { "tower", "n", 3, 0.3, { 1, 0, 0 }, 7 }, 0, 0, 0, 0, { 1, 25, 21, 0, 212884 } },
        { { "keystone", "angle", 20, 0.84, { 0, 0, -1 }, 1 }, 0, 0, 0, 0, { 3, 4, 2, 0, 21572 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 4 }, 0, 0, 0, 0, { 1, 37, 33, 0, 611999 } },
        { { "flat-arch", "n", 3, 0.84, { 0, 0, -1 }, 6 }, 0, 0, 0, 0, { 1, 25, 19, 0, 229683 } },
        { { "cantilever", "reach", 1.2, 0.84, { 0, 0, -1 }, 7 }, 0, 0, 0, 0, { 1, 250, 242, 0, 405604 } },
        { { "tower", "n", 3, 0.3, { 1, 0, 0 }, 5 }, 8, 1, 1, 0, { 1, 26, 22, 0, 470622 } }
    };
    COMPARE(rows);
}

/* What does not stand without its live loads: from which multiple on, and up to which. */
TEST(glued_scenes_that_live_loads_hold_take_the_work_written_here)
{
    static const count rows[] = {
        { { "two-cubes", "offset", 0.6, 0.84, { -1, 0, 0.2 }, 2 }, 0, 0, 0, 0, { 1, 25, 16, 0, 96590 } },
        { { "two-cubes", "offset", 0.8, 0.3, { -1, 0, 0 }, 3 }, 0, 0, 0, 0, { 1, 16, 7, 0, 94226 } },
        { { "two-cubes", "offset", 0.8, 0.3, { 0, 0, 1 }, 6 }, 0, 0, 0, 0, { 1, 13, 7, 0, 99762 } },
        { { "tower", "lean", 0.3, 0.5, { -1, 0, 0 }, 3 }, 0, 0, 0, 0, { 1, 54, 40, 9, 4195487 } },
        { { "incline", "angle", 50, 0.3, { -1, 0, 0 }, 1 }, 0, 0, 0, 0, { 1, 11, 6, 0, 44560 } },
        { { "incline", "angle", 60, 0.3, { -1, 0, 0 }, 7 }, 0, 0, 0, 0, { 1, 18, 14, 0, 42940 } },
        { { "topple", "angle", 30, 0.84, { -1, 0, 0 }, 2 }, 0, 0, 0, 0, { 1, 18, 9, 0, 93164 } },
        { { "overhang", "factor", 1.2, 0.84, { 0, 0, 1 }, 2 }, 0, 0, 0, 0, { 1, 23, 17, 1, 874259 } },
        { { "keystone", "angle", 30, 0.2, { 0, 0, 1 }, 1 }, 0, 0, 0, 0, { 3, 4, 2, 0, 21572 } },
        { { "keystone", "angle", 30, 0.2, { 1, 0, 0 }, 7 }, 0, 0, 1, 0, { 1, 17, 13, 0, 170887 } },
        { { "cantilever", "reach", 1.5, 0.84, { 0, 0, 1 }, 6 }, 0, 0, 0, 0, { 1, 250, 244, 0, 529624 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 1 }, 3 }, 0, 0, 0, 0, { 1, 31, 25, 0, 510679 } },
        { { "inverted-triangle", "rows", 3, 0.84, { 0, 0, 1 }, 5 }, 8, 1, 0, 0, { 1, 262, 252, 0, 1751260 } }
    };
    COMPARE(rows);
}

TEST(budgets_end_limits_where_written_here)
{
    static const count rows[] = {
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 90, { 0, 2, 1, 1, 43696 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 100, { 0, 3, 2, 2, 66451 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 120, { 0, 6, 5, 5, 109816 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 140, { 0, 7, 6, 6, 151542 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 170, { 1, 11, 9, 7, 215731 } },
        { { "arch", "n", 5, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 200, { 1, 11, 9, 7, 215731 } },
        { { "tower", "n", 3, 0.3, { 1, 0, 0 }, 7 }, 0, 0, 0, 90, { 0, 10, 7, 0, 143509 } },
        { { "tower", "n", 3, 0.3, { 1, 0, 0 }, 7 }, 0, 0, 0, 100, { 0, 14, 11, 0, 164473 } },
        { { "tower", "n", 3, 0.3, { 1, 0, 0 }, 7 }, 0, 0, 0, 120, { 0, 25, 21, 0, 191890 } },
        { { "tower", "n", 3, 0.3, { 1, 0, 0 }, 7 }, 0, 0, 0, 140, { 1, 25, 21, 0, 212884 } },
        { { "tower", "n", 3, 0.3, { 1, 0, 0 }, 7 }, 0, 0, 0, 170, { 1, 25, 21, 0, 212884 } },
        { { "tower", "n", 3, 0.3, { 1, 0, 0 }, 7 }, 0, 0, 0, 200, { 1, 25, 21, 0, 212884 } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 90, { 0, 0, 0, 0, 0 } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 100, { 0, 0, 0, 0, 0 } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 120, { 0, 2, 1, 1, 109644 } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 140, { 0, 4, 3, 3, 135206 } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 170, { 0, 6, 5, 5, 171660 } },
        { { "flat-arch", "n", 4, 0.84, { 1, 0, 0 }, 0 }, 0, 0, 0, 200, { 3, 8, 6, 5, 116758 } },
        { { "two-cubes", "offset", 0.6, 0.84, { -1, 0, 0.2 }, 0 }, 0, 0, 0, 90, { 0, 2, 1, 1, 6391 } },
        { { "two-cubes", "offset", 0.6, 0.84, { -1, 0, 0.2 }, 0 }, 0, 0, 0, 100, { 0, 3, 2, 2, 9779 } },
        { { "two-cubes", "offset", 0.6, 0.84, { -1, 0, 0.2 }, 0 }, 0, 0, 0, 120, { 0, 7, 6, 6, 16801 } },
        { { "two-cubes", "offset", 0.6, 0.84, { -1, 0, 0.2 }, 0 }, 0, 0, 0, 140, { 1, 8, 7, 7, 27115 } },
        { { "two-cubes", "offset", 0.6, 0.84, { -1, 0, 0.2 }, 0 }, 0, 0, 0, 170, { 1, 12, 9, 7, 34703 } },
        { { "two-cubes", "offset", 0.6, 0.84, { -1, 0, 0.2 }, 0 }, 0, 0, 0, 200, { 1, 12, 9, 7, 34703 } }
    };
    COMPARE(rows);
}

#endif

TEST_LIST(count)
#if !defined SP_NO_IPM && !defined SP_SMALL
    RUN(pushed_stones_take_the_work_written_here)
    RUN(pushed_assemblies_take_the_work_written_here)
    RUN(walls_and_shells_that_are_pushed_take_the_work_written_here)
    RUN(shells_and_rubble_that_are_pushed_take_the_work_written_here)
    RUN(limits_in_space_and_with_pyramids_take_the_work_written_here)
    RUN(glued_and_crushed_limits_take_the_work_written_here)
    RUN(glued_scenes_that_live_loads_hold_take_the_work_written_here)
    RUN(budgets_end_limits_where_written_here)
#endif
TEST_END
