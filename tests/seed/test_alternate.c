/* The alternation from the inside: which corners count, and the program of the motion, of the specification and with our terms.
 *                                                                                                      [seed 3.2, 3.3] */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/coupled/alternate.c"

#include <math.h>

#if SP__WITH_COUPLED && SP__WITH_ADMM

enum { POINTS = 4 };

/* One free block, four corners; fn and ft of each. Engaged is what exceeds 1 in fn, a hundredth of 100; sliding what does so in
 * ft. */
static const double pressed[POINTS][3] = { { 100, 0, 0 }, { 0.5, 1.5, 0 }, { 2, 0, 0.5 }, { 5, -2, 1.5 } };

static sp_problem pb;
static sp_settings set;
static sp__cra search;
static sp__alt alt;

static void start(sp_real weak)
{
    memset(&pb, 0, sizeof pb);
    memset(&set, 0, sizeof set);
    memset(&search, 0, sizeof search);
    memset(&alt, 0, sizeof alt);
    pb.blocks = 1;
    pb.points = POINTS;
    set.coupled.box = !(weak > 0);
    search.pb = &pb;
    search.set = &set;
    search.k.eps = 1;
    search.k.eta = 100;
    alt.c = &search;
    alt.seed = sp_seed_table();
    sp__alt_carve(&alt, &pb, &test_arena);
    memset(alt.pin, 0, POINTS * sizeof *alt.pin);
    for (int v = 0; v < POINTS; v++) for (int k = 0; k < 3; k++) alt.f[v][k] = R(pressed[v][k]);
    sp__alt_terms(&alt, weak);
    CHECK_INT(sp__alt_engage(&alt), 3);
}

/* E: 0, 2 and 3; F: 1, which presses too little to be in E, and 3. With our terms F is a part of E. */
TEST(friction_counts_wherever_a_corner_slides_engaged_or_not)
{
    for (int ours = 0; ours < 2; ours++) {
        start(ours ? SP__ALT_WEAK : 0);
        const double weight[POINTS] = { 1, 0, sqrt(0.02), sqrt(0.05) };
        const double h[POINTS][2] = { { 0, 0 }, { ours ? 0 : 1, 0 }, { 0, 0 }, { -0.8, 0.6 } };
        for (int v = 0; v < POINTS; v++) {
            CHECK_NEAR(alt.weight[v], weight[v], 4 * (double)SP_EPSILON);
            for (int k = 0; k < 2; k++) CHECK_WITHIN(alt.h[v][k], h[v][k], 4 * (double)SP_EPSILON);
        }
    }
}

static sp__explain motion(void)
{
    sp__explain g;
    memset(&g, 0, sizeof g);
    sp__explain_size(&pb, &g.qp);
    sp__explain_carve(&g, &pb, 0, &test_arena);
    sp__explain_cost(&g, &pb, &alt);
    sp__explain_bounds(&g, &pb, &alt);
    return g;
}

/* sum w^2 (dn + eps)^2 + sum |dt + beta h|^2, nothing else but reg: of x = (dq, dd, beta) the diagonal of P, and q. */
TEST(the_seeds_motion_has_no_term_of_ours)
{
    static const double w2[POINTS] = { 1, 0, 0.02, 0.05 }, rubs[POINTS] = { 0, 1, 0, 1 };
    const double near = 8 * (double)SP_EPSILON, reg = (double)sp_seed_table()->reg;
    start(0);
    const sp__explain g = motion();
    for (int j = 0; j < 6; j++) CHECK_NEAR(g.Px[g.Pp[j + 1] - 1], reg, near);
    for (int v = 0; v < POINTS; v++) {
        const int d = 6 + 3 * v, beta = 6 + 3 * POINTS + v;
        CHECK_WITHIN(g.Px[g.Pp[d + 1] - 1], w2[v], near);
        CHECK_WITHIN(g.q[d], w2[v], near);
        for (int k = 1; k < 3; k++) CHECK_WITHIN(g.Px[g.Pp[d + k + 1] - 1], rubs[v], near);
        CHECK_WITHIN(g.Px[g.Pp[beta + 1] - 1], rubs[v] > 0 ? 1 + reg : reg, near);
        CHECK_WITHIN(g.q[beta], 0, 0);
    }
    start(SP__ALT_WEAK);
    const sp__explain ours = motion();
    CHECK_NEAR(ours.q[6 + 3 * POINTS], -(double)SP__ALT_WEAK, near);            /* beta is drawn to a slip */
    CHECK_NEAR(ours.Px[ours.Pp[6 + 3 + 1] - 1], (double)SP__ALT_WEAK, near);    /* a corner that hardly presses to close */
}

/* dn >= -eps, no component of dd beyond eta, beta >= 0; ours keeps the square inside |dt| <= eta, and some slip. */
TEST(the_seeds_motion_is_bounded_by_eta_in_each_component)
{
    start(0);
    const sp__explain g = motion();
    for (int i = 3 * POINTS; i < 6 * POINTS; i++) {
        CHECK_NEAR(g.l[i], i % 3 ? -100 : -1, 0);
        CHECK_NEAR(g.u[i], 100, 0);
    }
    for (int i = 6 * POINTS; i < 7 * POINTS; i++) CHECK(!(g.l[i] < 0) && !(g.l[i] > 0) && !(g.u[i] < SP_QP_INFINITY));
    start(SP__ALT_WEAK);
    const sp__explain ours = motion();
    CHECK(ours.u[3 * POINTS + 1] < R(100 / sqrt(2.)) && ours.l[6 * POINTS] > 0);
}

/* ------------------------------------------------------------------------------------- sizes, bounds and answers of programs */

static sp_scene whole;
static sp_block held;
static int32_t number[1];
static sp_real load[6] = { 1, 2, -3, R(0.5), 4, -5 };

/* One block held along y and about x, POINTS corners of no joint. */
static void hand_made(void)
{
    memset(&whole, 0, sizeof whole);
    memset(&held, 0, sizeof held);
    memset(&pb, 0, sizeof pb);
    memset(&set, 0, sizeof set);
    whole.block = &held;
    whole.count.blocks = 1;
    held.fixed = 2u | 8u;
    pb.scene = &whole;
    pb.block = number;
    pb.p = load;
    pb.blocks = 1;
    pb.points = POINTS;
    set.penalty.gamma = 1000;
    set.penalty.tau = 1;
    set.tol = R(1e-6);
    set.coupled.rounds = 3;
}

TEST(programs_of_counts_beyond_an_index_are_none)
{
    const int32_t points[] = { INT32_MAX / 512 + 1, POINTS, INT32_MAX }, blocks[] = { 1, INT32_MAX / 512 + 1, INT32_MAX };
    sp_qp qp;
    hand_made();
    CHECK(sp__alt_scratch(&pb, &set) > 0);
    CHECK(sp__program_size(&pb, &set, &qp) > 0);
    for (int k = 0; k < 3; k++) {
        sp_arena a = test_arena;
        pb.points = points[k];
        pb.blocks = blocks[k];
        CHECK(!sp__explain_make(&pb, NULL, &a));
        CHECK_INT(a.used, test_arena.used);
        CHECK_INT(sp__alt_scratch(&pb, &set), 0);
    }
    pb.points = POINTS;
    pb.blocks = INT32_MAX / 24 + 1;
    CHECK_INT(sp__program_size(&pb, &set, &qp), -1);
    pb.blocks = 1;
    pb.points = INT32_MAX / (16 * 21) + 1;
    CHECK_INT(sp__program_size(&pb, &set, &qp), -1);
    CHECK_INT(sp__admm_scratch(&pb, &set), 0);
}

/* Too little scratch is told, and what does not need it is not told otherwise. */
TEST(memory_of_the_alternation_is_one_number_or_too_little_scratch)
{
    hand_made();
    const size_t enough = sp__alt_scratch(&pb, &set), want = sp__alt_need(&pb, &set, test_arena);
    int little = 0, much = 0;
    CHECK(want > 0 && want < SIZE_MAX);
    for (size_t bytes = 0; bytes <= enough; bytes += 64) {
        const sp_arena scratch = { test_arena.base, bytes, 0, 0 };
        const size_t need = sp__alt_need(&pb, &set, scratch);
        if (need == SIZE_MAX) little++;
        else much += CHECK_INT(need, want);
        if (much) CHECK(need != SIZE_MAX);
    }
    CHECK(little > 0 && much > 0);
    set.coupled.rounds = 0;
    CHECK_INT(sp__alt_need(&pb, &set, test_arena), 0);
    set.coupled.rounds = 3;
    pb.blocks = 0;
    CHECK_INT(sp__alt_need(&pb, &set, test_arena), 0);
}

/* Rows of a block that are held ask for nothing, others for its load; friction <= 0, signs >= 0. */
TEST(bounds_of_the_penalty_program_are_those_of_its_rows)
{
    hand_made();
    const sp__program *g = sp__program_make(&pb, &set, NULL, &test_arena);
    NEED(g != NULL);
    const int32_t signs = 6 + g->friction.faces * POINTS;
    for (int32_t i = 0; i < g->qp.m; i++) {
        const double p = i < 6 ? -(double)(load[i] / g->unit) : 0;
        const int free = i == 1 || i == 3;
        if (free || (i >= 6 && i < signs)) CHECK(g->at.l[i] <= -SP_QP_INFINITY);
        else CHECK_WITHIN(g->at.l[i], p, 4 * (double)SP_EPSILON);
        if (free || i >= signs) CHECK(g->at.u[i] >= SP_QP_INFINITY);
        else CHECK_WITHIN(g->at.u[i], p, 4 * (double)SP_EPSILON);
    }
}

/* A solver that says what it is told to. */
static struct { sp_qp_status says; sp_status returns, needs; sp_real x[4 * POINTS], y[64]; int no_x; } told;

static sp_status told_solve(void *self, const sp_qp *qp, const sp_qp_settings *how, sp_arena *arena, const sp_real *x0,
                            const sp_real *y0, sp_qp_result *result)
{
    (void)self; (void)how; (void)arena; (void)x0; (void)y0;
    CHECK(qp->n == 4 * POINTS && qp->m <= 64);
    memset(result, 0, sizeof *result);
    result->status = told.says;
    result->x = told.no_x ? NULL : told.x;
    result->y = told.y;
    return told.returns;
}

static sp_status told_need(void *self, const sp_qp *qp, const sp_qp_settings *how, sp_arena scratch, size_t *bytes)
{
    (void)self; (void)qp; (void)how; (void)scratch;
    *bytes = 640;
    return told.needs;
}

/* What the program's answer becomes: a claim where it is solved without tension, else at most forces; a motion without what is held
 * or no number; of no answer nothing. */
TEST(an_answer_becomes_a_claim_only_where_it_is_one)
{
    const sp_qp_solver plain = { NULL, told_solve, NULL };
    for (int k = 0; k < 10; k++) {
        const sp_arena mark = test_arena;
        sp_real f[3 * POINTS], dq[6];
        sp_state state;
        sp_verdict claim = SP_UNDECIDED;
        hand_made();
        memset(&state, 0, sizeof state);
        memset(&told, 0, sizeof told);
        set.penalty.solver = &plain;
        for (int q = 0; q < 3 * POINTS; q++) f[q] = -7;
        for (int q = 0; q < 6; q++) dq[q] = -7;
        for (int q = 0; q < 4 * POINTS; q++) told.x[q] = R(q % 4 == 0 ? 2 : q % 4 == 2 ? 1 : 0);
        for (int q = 0; q < 64; q++) told.y[q] = R(q + 1);
        told.y[2] = R(NAN);
        state.f = f;
        state.dq = dq;
        state.tension_ratio = -1;
        told.says = k == 0 ? SP_QP_SOLVED : k == 1 ? SP_QP_DUAL_INFEASIBLE : k == 2 ? SP_QP_NUMERICAL : k == 3 ? SP_QP_PRIMAL_INFEASIBLE
                  : k == 4 ? SP_QP_INACCURATE : k == 5 ? SP_QP_BUDGET : SP_QP_SOLVED;
        if (k == 6) told.x[1] = 1;                      /* tension */
        if (k == 7) told.x[5] = R(NAN);
        if (k == 8) told.no_x = 1;
        if (k == 9) told.returns = SP_E_INDEFINITE;
        CHECK_INT(sp__admm_run(&pb, &set, &state, &test_arena, &claim), SP_OK);
        if (!CHECK_INT(claim, k == 0 ? SP_STABLE : k == 3 ? SP_UNSTABLE : SP_UNDECIDED)) TEST_PRINT("    answer %d\n", k);
        const int forces = k == 0 || k == 4 || k == 5 || k == 6, motion = forces || k == 3;
        CHECK((f[0] > 0) == forces && (f[1] > 0) == forces);
        for (int q = 0; q < 6; q++)
            CHECK_WITHIN(dq[q], !motion ? -7 : q == 1 || q == 2 || q == 3 ? 0 : q + 1, 0);
        CHECK_INT(state.tension_ratio >= 0, k == 0 || k == 6);
        test_arena = mark;
    }
}

TEST(a_solver_tells_its_memory_or_takes_what_its_answer_takes)
{
    const sp_qp_solver with = { NULL, told_solve, told_need }, without = { NULL, told_solve, NULL };
    hand_made();
    memset(&told, 0, sizeof told);
    set.penalty.solver = &with;
    const size_t much = sp__admm_need(&pb, &set, test_arena);
    told.needs = SP_E_MEMORY;
    CHECK(sp__admm_need(&pb, &set, test_arena) == SIZE_MAX);
    set.penalty.solver = &without;
    const size_t own = sp__admm_need(&pb, &set, test_arena);
    pb.points = 0;
    const size_t none = sp__admm_need(&pb, &set, test_arena);
    CHECK(none < own && own < SIZE_MAX && much < SIZE_MAX && much > 640 && none < much);
}

/* What a program of the motion says is used where it is solved, or nearly where that will do. */
TEST(an_inaccurate_motion_is_used_only_where_it_will_do)
{
    static const sp_qp_status says[] = { SP_QP_SOLVED, SP_QP_INACCURATE, SP_QP_PRIMAL_INFEASIBLE, SP_QP_BUDGET };
    sp__system w;
    sp_coupled out;
    sp_qp_result r;
    const sp_real x[1] = { 0 };
    start(0);
    memset(&w, 0, sizeof w);
    memset(&out, 0, sizeof out);
    memset(&r, 0, sizeof r);
    search.w = &w;
    search.out = &out;
    r.flops = 10;
    for (int k = 0; k < 4; k++)
        for (int close = 0; close < 2; close++)
            for (int there = 0; there < 2; there++) {
                w.budget.spent = 0;
                r.status = says[k];
                r.x = there ? x : NULL;
                CHECK_INT(sp__alt_solved(&search, &r, close), there && (k == 0 || (k == 1 && close)));
                CHECK_INT(w.budget.spent, k == 3);
            }
    CHECK_INT(out.cost.flops, 160);
}

/* -eps - 1e-3 <= dn <= eta, and no slip beyond eta, of its components or as a whole. */
TEST(a_motion_within_its_bounds_keeps_every_one_of_them)
{
    static const struct { double d[3]; int round, box; } at[] = {
        { { 0, 0, 0 }, 1, 1 }, { { -1.0005, 0, 0 }, 1, 1 }, { { -1.002, 0, 0 }, 0, 0 }, { { 99, 0, 0 }, 1, 1 }, { { 101, 0, 0 }, 0, 0 },
        { { 0, 99, 0 }, 1, 1 }, { { 0, -101, 0 }, 0, 0 }, { { 0, 0, 101 }, 0, 0 }, { { 0, 80, -80 }, 0, 1 } };
    sp_real d[3 * POINTS];
    for (int box = 0; box < 2; box++)
        for (size_t k = 0; k < sizeof at / sizeof *at; k++)
            for (int v = 0; v < POINTS; v++) {
                const sp_arena mark = test_arena;
                start(0);
                set.coupled.box = box;
                memset(d, 0, sizeof d);
                for (int q = 0; q < 3; q++) d[3 * v + q] = R(at[k].d[q]);
                search.spring.d = d;
                if (!CHECK_INT(sp__alt_within_bounds(&alt), box ? at[k].box : at[k].round)) TEST_PRINT("    motion %d\n", (int)k);
                test_arena = mark;
            }
}

/* Our slip is 1 where there is room for it, else a tenth of eta; the specification has none. */
TEST(the_slip_that_is_asked_for_has_room)
{
    start(SP__ALT_WEAK);
    CHECK_WITHIN(alt.slip, 1, 0);
    search.k.eta = 5;
    sp__alt_terms(&alt, SP__ALT_WEAK);
    CHECK_NEAR(alt.slip, 0.5, 4 * (double)SP_EPSILON);
    search.k.eps = 0;
    search.k.eta = 100;
    sp__alt_terms(&alt, SP__ALT_WEAK);
    CHECK_NEAR(alt.slip, 10, 4 * (double)SP_EPSILON);
    CHECK(alt.least > 0);
    sp__alt_terms(&alt, 0);
    CHECK(!(alt.slip > 0) && !(alt.least > 0));
}

/* What is engaged closes by its weight, what presses less by hardly any, what has lost its force by none. */
TEST(what_has_lost_its_force_need_not_close)
{
    start(SP__ALT_WEAK);
    CHECK_NEAR(sp__alt_closing_weight(&alt, 0), 1, 4 * (double)SP_EPSILON);
    CHECK_NEAR(sp__alt_closing_weight(&alt, 1), (double)SP__ALT_WEAK, 4 * (double)SP_EPSILON);
    alt.pin[1] = 1;
    CHECK_NEAR(sp__alt_closing_weight(&alt, 1), (double)SP__ALT_WEAK, 4 * (double)SP_EPSILON);
    alt.pin[1] = 2;
    CHECK_WITHIN(sp__alt_closing_weight(&alt, 1), 0, 0);
    alt.pin[1] = 0;
    alt.f[1][0] = 0;
    CHECK_WITHIN(sp__alt_closing_weight(&alt, 1), 0, 0);
}

/* Of what is engaged the worst lose their force, of what slides those off their slip their friction; what has lost it loses it once. */
TEST(corners_that_the_motion_does_not_explain_lose_their_force_once)
{
    sp_real d[3 * POINTS] = { -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0 };
    start(0);
    search.spring.d = d;
    CHECK_INT(sp__alt_remove_worst(&alt, 0), 0);
    d[0] = 5;                                           /* 0 is open by 6, 2 by a little */
    d[6] = 0;
    CHECK_INT(sp__alt_remove_worst(&alt, sp__alt_gap(&alt, 0)), 1);
    CHECK(alt.pin[0] == 2 && alt.pin[2] == 0);
    CHECK_INT(sp__alt_remove_worst(&alt, sp__alt_gap(&alt, 0)), 0);
    d[3 + 1] = d[3 + 2] = 9;                            /* 1 slides aside, 0 as far but does not rub */
    d[1] = 9;
    CHECK_INT(sp__alt_remove_worst(&alt, 0), 1);
    CHECK(alt.pin[1] == 1 && alt.pin[3] == 0);
    d[9 + 1] = 8;                                       /* 3 slides against its friction, as it should */
    d[9 + 2] = -6;
    CHECK_INT(sp__alt_remove_worst(&alt, 0), 0);
}

TEST_LIST(alternate)
    RUN(programs_of_counts_beyond_an_index_are_none)
    RUN(memory_of_the_alternation_is_one_number_or_too_little_scratch)
    RUN(bounds_of_the_penalty_program_are_those_of_its_rows)
    RUN(an_answer_becomes_a_claim_only_where_it_is_one)
    RUN(a_solver_tells_its_memory_or_takes_what_its_answer_takes)
    RUN(an_inaccurate_motion_is_used_only_where_it_will_do)
    RUN(a_motion_within_its_bounds_keeps_every_one_of_them)
    RUN(the_slip_that_is_asked_for_has_room)
    RUN(what_has_lost_its_force_need_not_close)
    RUN(corners_that_the_motion_does_not_explain_lose_their_force_once)
    RUN(friction_counts_wherever_a_corner_slides_engaged_or_not)
    RUN(the_seeds_motion_has_no_term_of_ours)
    RUN(the_seeds_motion_is_bounded_by_eta_in_each_component)
TEST_END

#else

TEST_LIST(alternate)
TEST_END

#endif
