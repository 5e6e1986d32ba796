/* What becomes of a limit whose engine keeps silent, claims what is not so or has no memory; and of starts of ours that no
 * search leaves: each condition that decides there, by its formula. */
#define SP_API static
#include "../test.h"
#include "../base/fence.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/check/ladder.c"
#include "../../solvers/limit/falls.c"

#if SP__WITH_INTERIOR

/* What gates and the exact stage say in place of what they find. */
typedef struct told {
    int on;
    sp_status status;
    sp_verdict claim;
    int level, wood;                    /* of a search in 3 rows: level joints, a forest */
} told;
static told gates, reduced, exact;
static int runs;                        /* of the exact stage in 6 rows */

static sp_status told_gates(const sp_problem *pb, const sp_settings *of, sp_state *state, sp_arena *room, sp_verdict *claim)
{
    if (!gates.on) return sp__gates_run(pb, of, state, room, claim);
    *claim = gates.claim;
    return gates.status;
}

static sp_status told_search(const sp_problem *pb, const sp_settings *of, sp__reduction *o, sp_state *state, sp_arena *room,
                             sp_verdict *claim)
{
    if (!reduced.on) return sp__exact_search(pb, of, o, state, room, claim);
    *claim = reduced.claim;
    o->mode = reduced.level ? SP__LEVEL_JOINTS : SP__PLANE;
    o->forest = reduced.wood;
    return reduced.status;
}

static sp_status told_run(const sp_problem *pb, const sp_settings *of, sp_state *state, sp_arena *room, sp_verdict *claim)
{
    runs++;
    if (!exact.on) return sp__exact_run(pb, of, state, room, claim);
    *claim = exact.claim;
    return exact.status;
}

#define sp__gates_run(pb, set, state, room, claim) told_gates(pb, set, state, room, claim)
#define sp__exact_search(pb, set, o, state, room, claim) told_search(pb, set, o, state, room, claim)
#define sp__exact_run(pb, set, state, room, claim) told_run(pb, set, state, room, claim)
#include "../../solvers/limit/exact.c"

/* Multiples between which the engine keeps silent when asked, and in whole checks. */
static sp_real silent[2], quiet[2];

/* What it claims in place of what it finds: of live loads alone, of dead ones with any. No forces, and these motions. */
typedef struct claimed { int on; sp_verdict claim; sp_real dq[12]; } claimed;
static claimed says[2];

static sp_verdict told_ask(sp__engine *g, sp__bracket *b, sp_real d, sp_real l, sp_real *f)
{
    const claimed *is = &says[d > 0];
    if (is->on) {
        memset(f, 0, 3 * (size_t)b->pb.points * sizeof *f);
        memcpy(b->dq, is->dq, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
        return is->claim;
    }
    if (d > 0 && l > silent[0] && l < silent[1]) return SP_UNDECIDED;
    return sp__engine_ask(g, b, d, l, f);
}

static int told_check(sp__engine *g, sp__bracket *b, sp_real l, int all, sp_real *f)
{
    if (!(l > quiet[0] && l < quiet[1])) return sp__engine_check(g, b, l, all, f);
    memset(b->dq, 0, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    return 0;
}

#define sp__engine_ask(g, b, d, l, f) told_ask(g, b, d, l, f)
#define sp__engine_check(g, b, l, all, f) told_check(g, b, l, all, f)

#endif

#include "parts.h"

#if SP__WITH_INTERIOR

static sp__limit *L;

static void aloud(void)
{
    memset(&gates, 0, sizeof gates);
    memset(&reduced, 0, sizeof reduced);
    memset(&exact, 0, sizeof exact);
    memset(says, 0, sizeof says);
    silent[0] = silent[1] = quiet[0] = quiet[1] = 0;
    runs = 0;
}

/* The limit of scene s, multiples in units of 1. */
static void begin(void)
{
    L = limit_built(&s);
    L->ref = 1;
    memset(L->upper, 0, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->upper);
    memset(L->lower, 0, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->lower);
}

/* Of a cube, pushed at its foot: by friction it is 1/2 of its weight. */
static void limit(const sp_real dead[3], const sp_real live[3], const sp_strength *strength)
{
    aloud();
    cube(dead, live, R(-0.5), strength);
    begin();
}

/* Of two such cubes apart, pushed along x by so many weights, dead and live. */
static void two(double dead0, double live0, double dead1, double live1)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 4 };
    const double push[4] = { dead0, live0, dead1, live1 };
    const sp_strength mu = { R(0.5), 0, 0, 0 };
    const sp_real ground[3] = { 0, 0, R(-5) };
    aloud();
    test_arena.used = 0;
    set = sp_settings_default();
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const sp_real x = R(3 * k), at[3] = { x + R(0.5), R(0.5), R(0.5) };
        const sp_real foot[12] = { x, 0, 0, x + 1, 0, 0, x + 1, 1, 0, x, 1, 0 };
        CHECK_INT(sp_scene_body(&s, R(1000), at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, k + 1, 4, foot, &mu, NULL), SP_OK);
        for (int live = 0; live < 2; live++) {
            const sp_real F = R(push[2 * k + live]) * W;
            const sp_load load = { k + 1, live, { x + R(0.5), R(0.5), 0 }, { F, 0, 0 }, { 0, 0, 0 }, 0 };
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        }
    }
    begin();
}

static const sp_real PUSH[3] = { W, 0, 0 }, DOWN[3] = { 0, 0, -W }, UP[3] = { 0, 0, 2 * W };
static const sp_strength GLUED = { R(0.5), R(1e3), R(1e15), 0 };        /* it slides at 1 kPa more, and never opens */

/* ------------------------------------------------------------------------------------------------------- claims of stages */

TEST(stages_that_fail_leave_a_question_open)
{
    for (int k = 0; k < 4; k++) {
        limit(NOTHING, PUSH, NULL);
        told *of = k == 1 ? &gates : k == 2 ? &reduced : &exact;
        of->on = k > 0;
        of->status = SP_E_MEMORY;
        of->claim = SP_UNSTABLE;
        if (k == 3) for (int e = 0; e < 2; e++) L->bracket.set.effect[e] = L->bracket.wide.effect[e] = SP_WITH;
        CHECK_INT(sp__limit_ask(L, 1, R(0.25), L->f), k ? SP_UNDECIDED : SP_STABLE);
        CHECK_INT(sp__engine_check(&L->engine, &L->bracket, R(0.25), k == 3, L->f), !k);
        CHECK_INT(runs, k == 3 ? 2 : 0);
        CHECK(!(L->bracket.dq[0] < 0 || L->bracket.dq[0] > 0));
        whole();
    }
}

/* A fall that level joints claim is that of 6 rows where they are a forest. */
TEST(what_3_rows_do_not_know_is_asked_of_6)
{
    for (int k = 0; k < 6; k++) {
        limit(NOTHING, PUSH, NULL);
        reduced.on = 1;
        reduced.level = k > 0;
        reduced.wood = k == 2;
        reduced.claim = k < 3 ? SP_UNSTABLE : k == 3 ? SP_UNDECIDED : SP_STABLE;
        const sp_verdict is = sp__limit_ask(L, 1, R(0.25), L->f);
        CHECK_INT(runs, k == 1 || k == 3);
        CHECK_INT(is, runs ? SP_STABLE : k < 3 ? SP_UNSTABLE : SP_UNDECIDED);
        whole();
    }
}

TEST(forces_that_balance_nothing_are_not_believed)
{
    for (int k = 0; k < 2; k++) {
        limit(NOTHING, PUSH, NULL);
        gates.on = k;
        gates.claim = SP_STABLE;
        CHECK_INT(sp__limit_ask(L, 1, R(0.25), L->f), k ? SP_UNDECIDED : SP_STABLE);
        CHECK_INT(sp__engine_check(&L->engine, &L->bracket, R(0.25), 0, L->f), !k);
        whole();
    }
}

/* Gates answer where there is no load, and no stage is asked for it. */
TEST(what_gates_decide_needs_no_stage)
{
    for (int all = 0; all < 2; all++)
        for (int loaded = 0; loaded < 2; loaded++) {
            limit(NOTHING, PUSH, NULL);
            for (int e = 0; e < 6; e++) L->bracket.dead[e] = 0;
            if (loaded) L->bracket.dead[2] = -W;
            CHECK_INT(sp__engine_check(&L->engine, &L->bracket, 0, all, L->f), 1);
            CHECK_INT(runs, all && loaded);
            CHECK_WITHIN(L->f[0] + L->f[3] + L->f[6] + L->f[9], loaded ? (double)W : 0, TOL(1e-9, 1e-4) * (double)W);
            whole();
        }
}

/* Where friction and depth are both asked for there is no search in 3 rows. */
TEST(a_check_in_3_rows_that_are_not_planned_is_left_open)
{
    for (int k = 0; k < 2; k++) {
        limit(NOTHING, PUSH, NULL);
        for (int e = 0; e < 2; e++) L->bracket.wide.effect[e] = k ? SP_WITH : SP_PLANNED;
        CHECK_INT(sp__engine_check(&L->engine, &L->bracket, R(0.25), 0, L->f), !k);
        CHECK_INT(sp__engine_check(&L->engine, &L->bracket, R(0.25), 1, L->f), 1);
        CHECK_INT(runs, 1);
        whole();
    }
}

/* --------------------------------------------------------------------------------------------------------- without an end */

/* Pressed down there is no end; not asked without strength, nor without a factorisation left. */
TEST(only_joints_with_strength_are_asked_for_an_end_far_away)
{
    for (int k = 0; k < 4; k++) {
        limit(NOTHING, k == 3 ? DOWN : UP, k == 1 ? NULL : &GLUED);
        L->r.lower = 2000;
        if (k == 2) L->engine.n.left = 0;
        sp__limit_endless(L);
        CHECK_INT(L->r.kind, k == 3 ? SP_LIMIT_UNBOUNDED : SP_LIMIT_UNDECIDED);
        CHECK_INT(L->r.lower > 2000, k == 3);
        whole();
    }
}

/* ---------------------------------------------------------------------------------------------------------- the upper end */

TEST(forces_that_carry_no_more_are_no_lower_end)
{
    for (int k = 0; k < 3; k++) {
        limit(NOTHING, PUSH, &GLUED);
        L->r.lower = k ? R(0.3) : R(0.1);
        sp__limit_upper_ask(L, R(0.2), k < 2);
        CHECK_WITHIN(L->r.lower, k ? 0.3 : 0.2, TOL(1e-12, 1e-6));
        whole();
    }
}

/* At rest nothing falls, however often it is asked. */
TEST(a_motion_of_nothing_is_no_upper_end)
{
    for (int none = 0; none < 2; none++) {
        limit(NOTHING, DOWN, NULL);
        L->best = R(0.5);
        L->none = none;
        sp__limit_upper(L);
        CHECK_WITHIN(L->r.upper, -1, 0);
        CHECK_INT(L->bracket.cost.factorisations > 0, !none);
        CHECK_INT(sp__limit_upper_near(L, 1), 0);
        whole();
    }
}

/* The cube slides from half its weight on, by (1, 0, z) from z on. */
static void slides(sp_real z)
{
    limit(NOTHING, PUSH, NULL);
    L->r.lower = 0;
    L->r.upper = z * R(1.001);
    L->r.dq[6] = 1;
    L->r.dq[8] = z;
    L->r.kind = SP_LIMIT_UNDECIDED;
    sp__motion_read(&L->bracket.pb, L->r.dq, L->bracket.dq);
}

TEST(a_motion_is_an_upper_end_as_near_to_its_balance_as_proves_it)
{
    static const double tols[] = { -1e6, 0, 2, 3, 4, 5, 6, 7, 7.5, 1e6 };
    int near = 0;
    for (size_t k = 0; k < sizeof tols / sizeof *tols; k++) {
        slides(1);
        const sp_real lambda = 1 + R(tols[k]) * L->r.tol;
        L->r.upper = -1;
        const int is = sp__limit_upper_near(L, lambda);
        CHECK(is >= near && is <= (k > 1));             /* what proves an end proves all farther ones */
        if (is) CHECK(L->r.upper > 1 && L->r.upper <= lambda);
        else CHECK_WITHIN(L->r.upper, -1, 0);
        near = is;
        whole();
    }
    CHECK_INT(near, 1);
}

/* Whatever budget ends it, an upper end is one. */
TEST(on_any_budget_both_ends_hold)
{
    int kept = 0;
    for (int k = 0; k < 150; k++) {
        slides(R(1.5));
        L->bracket.limit = 4 * SP__FLOPS_CERTIFICATE * (80 + 4 * k);
        sp__limit_halve(L);
        CHECK(L->r.lower <= R(0.5) + TOL(R(1e-6), R(1e-3)) && L->r.upper >= R(0.5) - TOL(R(1e-6), R(1e-3)));
        kept += L->r.upper > 1;
        whole();
    }
    CHECK(kept > 0 && kept < 150);
}

/* ---------------------------------------------------------------------------------------------------------------- halving */

static void half(double from, double to)
{
    CHECK(L->r.lower <= R(from) * (1 + TOL(R(1e-6), R(1e-3))));
    CHECK(L->r.upper >= R(to) * (1 - TOL(R(1e-6), R(1e-3))));
    CHECK(L->r.lower <= L->r.upper);
    whole();
}

/* What is kept silent about is asked on both sides, and an upper end that comes below it ends that. */
TEST(ends_meet_beside_what_is_left_open)
{
    static const double band[][2] = { { 0, 0 }, { 0.7, 0.8 }, { 0.7, 1.3 }, { 0.55, 1.3 }, { 0.3, 0.45 }, { 0.1, 0.2 } };
    for (size_t k = 0; k < sizeof band / sizeof *band; k++) {
        slides(R(1.5));
        quiet[0] = R(band[k][0]);
        quiet[1] = R(band[k][1]);
        sp__limit_halve(L);
        half(0.5, 0.5);
        CHECK_NEAR(L->r.lower, 0.5, TOL(1e-5, 0.3));
        CHECK_NEAR(L->r.upper, 0.5, TOL(1e-5, 2e-2));
    }
}

TEST(what_four_checks_leave_open_stays_so)
{
    slides(R(1.5));
    quiet[1] = 2;
    sp__limit_halve(L);
    CHECK_INT(L->engine.n.left, 1);
    CHECK_WITHIN(L->r.lower, 0, 0);
    CHECK_NEAR(L->r.upper, 1.5, TOL(1e-5, 2e-3));
    half(0.5, 0.5);
}

TEST(without_a_flop_left_both_ends_stay)
{
    slides(R(1.5));
    L->bracket.limit = L->bracket.cost.flops;
    sp__limit_halve(L);
    CHECK_WITHIN(L->r.lower, 0, 0);
    CHECK_WITHIN(L->r.upper, 1.5015, TOL(1e-12, 1e-6));
    half(0.5, 0.5);
}

/* Pressed down it stands under any load: above 1,000 nothing more is asked. */
TEST(where_no_upper_end_is_known_halving_ends_far_away)
{
    for (int known = 0; known < 2; known++) {
        limit(NOTHING, DOWN, NULL);
        L->r.lower = known ? 2000 : 0;
        const int64_t flops = L->bracket.cost.flops;
        sp__limit_halve(L);
        CHECK(L->r.upper < 0 && L->r.lower >= SP__LIMIT_FAR);
        CHECK_INT(L->bracket.cost.flops > flops, !known);
        whole();
    }
}

/* One falls below 1/2 of its weight, the other above 1/5. */
TEST(halving_finds_that_nothing_stands)
{
    for (int k = 0; k < 2; k++) {
        two(k ? -1 : 1, -1, 0.3, 1);
        if (k) quiet[1] = 9;
        L->r.upper = 2;
        L->r.dq[12] = 1;
        L->r.dq[14] = R(0.5);                           /* sliding lifts, as friction has it here */
        sp__limit_halve(L);
        CHECK_INT(L->none, !k);
        CHECK_WITHIN(L->r.upper, k ? 0.2 : 0, TOL(1e-5, 1e-2));
        whole();
    }
}

/* -------------------------------------------------------------------------------------------------------- Newton's method */

TEST(what_is_known_to_stand_is_not_asked_again)
{
    for (int k = 0; k < 4; k++) {
        limit(NOTHING, PUSH, k == 1 ? &GLUED : NULL);
        const sp_real low = R(0.5) - 2000 * L->r.tol;
        silent[1] = k < 3 ? 9 : 0;
        L->r.lower = low;
        if (k < 3) L->best = R(0.5);
        if (k == 2) L->r.kind = SP_LIMIT_UNBOUNDED;
        CHECK_INT(sp__limit_newton(L), k > 1 || (k == 0 && sizeof(sp_real) > 4));
        CHECK_WITHIN(L->r.lower, (double)low, TOL(1e-2, 2e-1));
        CHECK(L->r.lower <= R(0.5) * (1 + TOL(R(1e-6), R(1e-3))));
        whole();
    }
}

/* Joints with strength that carry any multiple of live loads, of which nothing is told. */
TEST(what_carries_any_multiple_and_is_left_open_has_no_lower_end)
{
    limit(NOTHING, DOWN, &GLUED);
    silent[0] = -1;
    silent[1] = SP__HUGE;
    L->r.kind = SP_LIMIT_UNBOUNDED;
    CHECK_INT(sp__limit_newton(L), 0);
    CHECK_WITHIN(L->r.lower, -1, 0);
    CHECK(L->best >= SP__HUGE);
    whole();
}

/* One cube slides whatever pushes the other: no multiple stands; found as far as the budget goes. */
TEST(a_collapse_that_live_loads_do_nothing_in_is_one_at_0)
{
    int none = 0;
    for (int k = 0; k < 60; k++) {
        sp_real a = 1;
        two(1, 0, 0, 1);
        L->bracket.dq[0] = 1;
        L->bracket.dq[2] = R(0.5);
        L->bracket.limit = 8 * SP__FLOPS_CERTIFICATE * (8 + 4 * k);
        const int is = sp__limit_bound_by_collapse(L, &a, R(1e-6));
        CHECK_INT(is, L->none);
        CHECK(is >= none && L->best >= SP__HUGE);
        none = is;
        whole();
    }
    CHECK_INT(none, 1);
}

/* --------------------------------------------------------------------------------------------------- claims of the engine */

TEST(a_fall_that_live_loads_do_no_work_in_is_no_end)
{
    for (int k = 0; k < 2; k++) {
        limit(NOTHING, PUSH, NULL);
        says[0].on = 1;
        says[0].claim = SP_UNSTABLE;
        says[0].dq[0] = k ? 0 : 1;
        says[0].dq[2] = R(0.5);
        sp__limit_live_alone(L);
        if (k) CHECK(L->best >= SP__HUGE);
        else CHECK_WITHIN(L->best, 0.5, TOL(1e-9, 1e-4));
        whole();
    }
}

/* Pushed by its weight under dead loads, it stands from where they are taken back to 1/2 of it and what glue holds. */
TEST(the_least_multiple_that_stands_is_closed_in_from_above)
{
    for (int k = 0; k < 3; k++) {
        const sp_real back[3] = { -W, 0, 0 };
        limit(k == 1 ? NOTHING : PUSH, back, &GLUED);
        L->r.lower = k == 1 ? R(0.3) : R(0.9);
        L->r.kind = SP_LIMIT_FOUND;
        says[1].on = k == 2;
        says[1].claim = SP_UNSTABLE;
        sp__limit_lowest(L, 0);
        CHECK_INT(L->r.dead, k == 0 ? SP_UNSTABLE : k == 1 ? SP_STABLE : SP_UNDECIDED);
        CHECK_WITHIN(L->r.lowest, k == 2 ? 0.9 : k ? 0 : 0.5 - 1000 / (double)W, TOL(1e-5, 2e-2));
        whole();
    }
}

TEST(dead_loads_fall_where_that_is_proved)
{
    for (int k = 0; k < 4; k++) {
        const sp_real along[3] = { k == 1 ? -W : W, 0, 0 };
        limit(k == 3 ? NOTHING : PUSH, along, &GLUED);
        says[1].on = k == 2;
        says[1].claim = SP_UNSTABLE;
        CHECK_INT(sp__strong_check_dead(L), k & 1);
        CHECK_INT(L->r.dead, k < 2 ? SP_UNSTABLE : k == 2 ? SP_UNDECIDED : SP_STABLE);
        CHECK_INT(L->none, k == 0);
        whole();
    }
}

/* The second cube falls under dead loads already; what is told of the first is a collapse that live loads hinder. */
TEST(nothing_is_climbed_to_below_0)
{
    int done = 7;
    two(1, -1, 1, 1);
    s.joint[0].strength.cohesion = s.joint[1].strength.cohesion = 1;
    begin();
    says[0].on = says[1].on = 1;
    says[0].claim = says[1].claim = SP_UNSTABLE;
    says[0].dq[6] = says[1].dq[0] = 1;
    says[0].dq[8] = says[1].dq[2] = R(0.5);
    CHECK_INT(sp__limit_start(L, &test_arena, &done), SP_OK);
    CHECK_INT(done, 7);
    CHECK_INT(L->r.dead, SP_UNSTABLE);
    CHECK_WITHIN(L->best, -0.5, TOL(1e-3, 1e-2));
    CHECK(L->r.lower < 0 && L->bracket.cost.factorisations == 0);
    whole();
}

/* Without live loads: forces of nothing carry the cube, says the engine. */
TEST(a_limit_by_false_forces_is_not_told)
{
    for (int k = 0; k < 3; k++) {
        sp_limit_result r;
        limit(k == 2 ? NOTHING : PUSH, NOTHING, NULL);
        if (k == 2) s.load[0].force[0] = 0;
        says[1].on = k > 0;
        says[1].claim = k ? SP_STABLE : SP_UNDECIDED;
        if (k == 2) says[1].on = 0;
        CHECK_INT(sp_limit(&s, &set, &test_arena, &r), SP_OK);
        CHECK_INT(r.kind, k == 2 ? SP_LIMIT_UNBOUNDED : k ? SP_LIMIT_UNDECIDED : SP_LIMIT_NONE);
        CHECK_INT(r.verified, k != 1);
        CHECK_INT(r.reason, k == 1 ? SP_REASON_UNVERIFIED : SP_REASON_FORCES);
        whole();
    }
}

static sp_strength rough = { R(0.5), R(1e3), 0, 0 };    /* that holds 1 kPa more */

TEST(a_collapse_at_any_multiple_is_an_end_at_its_balance)
{
    static const double at[] = { 1, 3, 1e6, 1e30 };
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        sp_real a = R(at[k]);
        limit(NOTHING, PUSH, &rough);
        L->bracket.dq[0] = 1;
        L->bracket.dq[2] = R(0.6);
        CHECK_INT(sp__limit_bound_by_collapse(L, &a, R(1e-6)), 1);
        CHECK_WITHIN(L->best, 0.6 + 1000 / (double)W, TOL(1e-9, 1e-4));
        CHECK(a <= L->best);
        whole();
    }
}

/* Ends of the climb are sought of a motion that there is, and of none. */
TEST(a_climb_without_an_end_has_no_motion_to_sharpen)
{
    for (int k = 0; k < 2; k++) {
        int done = 0;
        limit(NOTHING, k ? NOTHING : PUSH, &rough);
        CHECK_INT(sp__limit_start(L, &test_arena, &done), SP_OK);
        if (!k) CHECK_WITHIN(L->best, 0.5 + 1000 / (double)W, TOL(1e-5, 1e-2));
        L->r.lower = 0;
        if (k) CHECK_INT(sp__limit_open(L, &test_arena), SP_OK);
        else L->best = R(0.7);
        for (int e = 0; e < 6; e++) L->engine.w->y[e] = 0;
        sp__limit_loads(L, 0);
        CHECK_INT(sp__strong_ends(L, 1, 0, 1), 0);
        if (k) CHECK(L->best >= SP__HUGE);
        else CHECK(L->best >= R(0.6) && L->best <= R(0.7));
        whole();
    }
}

/* ---------------------------------------------------------------------------------------------------------------- budgets */

/* Dead loads push the cube off, live ones help them or push it back. A lower end that is known stays, and so does what is open
 * where no flop is left. */
TEST(dead_loads_that_fall_with_the_help_of_live_ones_leave_nothing)
{
    for (int k = 0; k < 4; k++) {
        const sp_real along[3] = { k == 1 ? -W : W, 0, 0 };
        limit(PUSH, along, NULL);
        if (k == 2) L->r.lower = R(0.7);
        if (k == 3) L->bracket.limit = 0;
        sp__limit_check_dead(L);
        CHECK_INT(L->none, k == 0);
        CHECK_INT(L->r.dead, k == 3 ? SP_UNDECIDED : SP_UNSTABLE);
        CHECK_WITHIN(L->r.upper, k == 0 ? 0 : -1, 0);
        if (k == 1) CHECK_WITHIN(L->least, 0.5, TOL(1e-5, 1e-2));
        whole();
    }
}

/* A cube that slides from 1/2 on, one that falls, one that is pressed down. */
TEST(a_limit_on_any_budget_is_the_limit_or_none_is_told)
{
    static const sp_limit_kind kind[] = { SP_LIMIT_FOUND, SP_LIMIT_NONE, SP_LIMIT_UNBOUNDED };
    int told_of[3] = { 0, 0, 0 };
    for (int what = 0; what < 3; what++)
        for (int k = 0; k < 100; k++) {
            sp_limit_result r;
            limit(what == 1 ? PUSH : NOTHING, what == 2 ? DOWN : PUSH, NULL);
            set.budget = 400 * (1 + k) * (k > 50 ? k / 10 : 1);
            CHECK_INT(sp_limit(&s, &set, &test_arena, &r), SP_OK);
            CHECK(r.kind == kind[what] || r.kind == SP_LIMIT_UNDECIDED);
            if (r.kind == SP_LIMIT_FOUND) CHECK_NEAR(r.multiplier, 0.5, TOL(1e-6, 1e-2));
            if (!r.kind) CHECK_INT(r.reason, SP_REASON_BUDGET);
            told_of[what] += r.kind == kind[what];
            whole();
        }
    for (int what = 0; what < 3; what++) CHECK(told_of[what] > 0 && told_of[what] < 100);
}

/* -------------------------------------------------------------------------------------------------------- interior points */

TEST(where_nothing_stands_no_forces_are_tried)
{
    limit(PUSH, PUSH, NULL);
    L->none = 1;
    L->best = 0;
    L->r.lower = 0;
    L->engine.h.l = L->engine.h.m.tau = 1;
    CHECK_INT(sp__interior_lower(L, 1), 0);
    CHECK_INT(L->bracket.cost.flops, 0);
    L->none = 0;
    CHECK_INT(sp__interior_lower(L, 1), 1);             /* ends that meet */
    whole();
}

/* Pulled up by twice its weight it rises whatever pushes it along, unless what pushes back counts for more. */
TEST(a_motion_that_live_loads_do_nothing_in_proves_that_nothing_stands)
{
    for (int along = -1; along < 2; along++) {
        sp_real y[6] = { 0 };
        limit(UP, PUSH, NULL);
        L->bracket.set.effect[SP_EFFECT_DEPTH] = SP_WITH;
        CHECK_INT(sp__limit_open(L, &test_arena), SP_OK);
        const sp_real *weight = L->engine.w->measure.weight;
        y[0] = -(sp_real)along / weight[0];
        y[2] = -1 / weight[0];
        L->engine.at = 0;
        sp__limit_loads(L, 0);
        sp__limit_candidate(L, y);
        CHECK_INT(L->none, along >= 0);
        if (!along) CHECK_WITHIN(L->best, -1, 0);
        whole();
    }
}

#endif

TEST_LIST(decides)
#if SP__WITH_INTERIOR
#ifndef SP_NO_PLAN
    RUN(stages_that_fail_leave_a_question_open)
    RUN(what_3_rows_do_not_know_is_asked_of_6)
    RUN(forces_that_balance_nothing_are_not_believed)
    RUN(what_gates_decide_needs_no_stage)
    RUN(a_check_in_3_rows_that_are_not_planned_is_left_open)
#endif
    RUN(only_joints_with_strength_are_asked_for_an_end_far_away)
    RUN(forces_that_carry_no_more_are_no_lower_end)
    RUN(a_motion_of_nothing_is_no_upper_end)
    RUN(a_motion_is_an_upper_end_as_near_to_its_balance_as_proves_it)
    RUN(ends_meet_beside_what_is_left_open)
    RUN(what_four_checks_leave_open_stays_so)
    RUN(without_a_flop_left_both_ends_stay)
    RUN(where_no_upper_end_is_known_halving_ends_far_away)
    RUN(on_any_budget_both_ends_hold)
    RUN(halving_finds_that_nothing_stands)
    RUN(what_is_known_to_stand_is_not_asked_again)
    RUN(what_carries_any_multiple_and_is_left_open_has_no_lower_end)
    RUN(a_collapse_that_live_loads_do_nothing_in_is_one_at_0)
    RUN(a_fall_that_live_loads_do_no_work_in_is_no_end)
    RUN(the_least_multiple_that_stands_is_closed_in_from_above)
    RUN(dead_loads_fall_where_that_is_proved)
    RUN(nothing_is_climbed_to_below_0)
    RUN(a_limit_by_false_forces_is_not_told)
    RUN(a_collapse_at_any_multiple_is_an_end_at_its_balance)
    RUN(a_climb_without_an_end_has_no_motion_to_sharpen)
    RUN(dead_loads_that_fall_with_the_help_of_live_ones_leave_nothing)
    RUN(a_limit_on_any_budget_is_the_limit_or_none_is_told)
    RUN(where_nothing_stands_no_forces_are_tried)
    RUN(a_motion_that_live_loads_do_nothing_in_proves_that_nothing_stands)
#endif
TEST_END
