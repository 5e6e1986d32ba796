/* Coupled check: room that ends between its parts, what a corner of a program's point carries, whom a spent budget is told of. */
#define SP_API static
#include "../test.h"

#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/scene/joint.c"
#include "../../solvers/coupled/coupled.c"

#if SP__WITH_COUPLED

static sp_scene s;
static sp_problem pb;
static sp_settings set;

/* A cube of 1 m on a plate. */
static void cube(void)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 0 };
    const sp_real ground[3] = { 0, 0, R(-5) }, at[3] = { R(0.5), R(0.5), R(0.5) };
    const sp_real foot[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
    const sp_strength mu = { R(0.5), 0, 0, 0 };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, R(1000), at, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &mu, NULL), SP_OK);
    CHECK_INT(sp_problem_build(&s, &test_arena, &pb), SP_OK);
    memset(&set, 0, sizeof set);
    set.tol = R(TOL(1e-9, 1e-4f));
    set.iterations = SP__ITERATIONS;
    set.stage[0] = SP_STAGE_EXACT;
    set.stage_count = 1;
}

static sp_arena with(size_t bytes)
{
    sp_arena a = test_arena;
    a.capacity = a.used + bytes;
    return a;
}

/* 24 V^3 nodes of a proof, 48,000 at most, of few vertices and blocks. */
TEST(a_proof_has_room_where_vertices_and_blocks_are_few)
{
    static const struct { int32_t points, blocks, asked, room; } row[] = {
        { 4, 2, -1, 24 * 64 }, { 48, 48, -1, 48000 }, { 48, 49, -1, 0 }, { 49, 48, -1, 0 }, { 0, 1, -1, 0 }, { 4, 2, 7, 7 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        int32_t entries;
        CHECK_INT(sp__branch_proof_room(row[k].points, row[k].blocks, row[k].asked, &entries), row[k].room);
        CHECK_INT(entries, row[k].room ? 20 * row[k].room + 3 * row[k].points + 6 * row[k].blocks + 1 : 0);
    }
}

/* The memory of a coupled check is told with scratch for all that counts it, and else not. */
TEST(the_memory_of_a_coupled_check_is_told_with_enough_scratch)
{
    int told = 0, none = 0;
    size_t need = 0;
    cube();
    for (size_t bytes = 0; bytes < 40000; bytes += 128) {
        const size_t is = sp__coupled_need(&pb, &set, 0, with(bytes));
        if (is == SIZE_MAX) { none++; CHECK_INT(told, 0); continue; }
        CHECK(!told || is == need);
        need = is;
        told++;
    }
    CHECK(told > 0 && none > 0);
    CHECK(sp__coupled_need(&pb, &set, SIZE_MAX, test_arena) == SIZE_MAX);
    CHECK(sp__coupled_need(&pb, &set, 100 * need, test_arena) > 100 * need);
}

/* A search that its own limit of work ends is not one that the budget ended. */
TEST(a_search_is_spent_where_it_had_all_that_is_left)
{
    static const struct { int spent, limit, left, is; } row[] = { { 0, 9, 5, 0 }, { 1, 4, 5, 0 }, { 1, 5, 5, 1 }, { 1, 9, 5, 1 } };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        static sp__system w;
        static sp__cra c;
        sp_coupled out;
        sp_state state;
        sp_real imbalance = 7;
        memset(&c, 0, sizeof c);
        memset(&state, 0, sizeof state);
        memset(&out, 0, sizeof out);
        c.w = &w;
        c.out = &out;
        c.offer.residual = R(1.5);
        w.budget.spent = row[k].spent;
        w.budget.limit = row[k].limit;
        state.left = row[k].left;
        sp__coupled_tell(&c, 0, &state, &imbalance);
        CHECK_INT(c.spent, row[k].is);
        CHECK_WITHIN(out.residual, 1.5, 0);
        CHECK_WITHIN(imbalance, 7, 0);
    }
}

#if SP__WITH_ADMM
TEST(an_alternation_is_told_with_scratch_for_forces_and_for_motions)
{
    int told = 0, none = 0;
    cube();
    set.coupled.rounds = 3;
    for (size_t bytes = 0; bytes < 100000; bytes += 64) {
        const size_t is = sp__alt_need(&pb, &set, with(bytes));
        CHECK(is == SIZE_MAX ? !told : is > 0);
        if (is == SIZE_MAX) none++; else told++;
    }
    CHECK(told > 0 && none > 0);
    set.coupled.rounds = 0;
    CHECK(sp__alt_need(&pb, &set, test_arena) == 0);
}
#endif

/* A corner of which the program has force (2, 1, -1) and slip (x, y): what presses rubs where it slips against its friction, with
 * alpha = -ft . dt / dt^2; not in state 3, of no friction, nor 1, open. */
TEST(a_corner_carries_friction_against_its_slip_alone)
{
    static const struct { int state; double x, y, force, rubs; } row[] = {
        { 2, -1, 1, 2, 1 }, { 4, -2, 2, 2, 1 }, { 3, -1, 1, 2, 0 }, { 2, 0, 0, 2, 0 }, { 2, 1, -1, 2, 0 }, { 1, -1, 1, 2, 0 }, { 2, -1, 1, 0, 0 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const int32_t at = 0;
        int32_t start[2 + SP__ROWS] = { 0 }, index[2] = { 3, 4 }, state = row[k].state;
        sp_real x[5] = { R(row[k].force), 1, -1, R(row[k].x), R(row[k].y) }, size = 1, d[1][3][12] = { { { 0 } } };
        sp_real f[3] = { R(row[k].force), 5, 5 }, alpha = 7;
        static sp_problem none;
        static sp__certifier j;
        sp__branch b;
        const sp__triple t = { f, NULL, &alpha };
        memset(&b, 0, sizeof b);
        j.unit = 1;
        for (int q = 2; q < 2 + SP__ROWS; q++) start[q] = 2;
        b.pb = &none; b.j = &j; b.points = 1; b.state = &state; b.size = &size; b.d = d;
        b.at = (int32_t *)&at;
        b.k.L = 1;
        b.lp.start = start; b.lp.index = index; b.lp.x = x;
        d[0][1][0] = d[0][2][1] = 1;
        sp__point_write_vertex(&b, 0, &t);
        CHECK_WITHIN(f[0], row[k].state == 1 ? 0 : row[k].force, 0);
        CHECK_WITHIN(f[1], row[k].rubs, TOL(1e-12, 1e-6));
        CHECK_WITHIN(f[2], -row[k].rubs, TOL(1e-12, 1e-6));
        CHECK_WITHIN(alpha, row[k].rubs > 0 ? (row[k].y - row[k].x) / (row[k].x * row[k].x + row[k].y * row[k].y) : 0, TOL(1e-12, 1e-6));
    }
}

#endif

TEST_LIST(rooms)
#if SP__WITH_COUPLED
    RUN(a_proof_has_room_where_vertices_and_blocks_are_few)
    RUN(the_memory_of_a_coupled_check_is_told_with_enough_scratch)
    RUN(a_search_is_spent_where_it_had_all_that_is_left)
#if SP__WITH_ADMM
    RUN(an_alternation_is_told_with_scratch_for_forces_and_for_motions)
#endif
    RUN(a_corner_carries_friction_against_its_slip_alone)
#endif
TEST_END
