/* What a limit starts with: which search is run, and what is made of what it says, where searches, proofs and questions
 * answer as they are told to. */
#define SP_API static
#include "../test.h"
#include "../base/fence.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/limit/interior.c"

#if SP__WITH_INTERIOR

static sp_real lift;                                    /* loads at hand where a proof is sharpened */

static void world_sharpen_proof(sp__system *w, int passes, sp_state *state)
{
    lift = w->pb->p[2];
    for (int k = 0; k < 6; k++) state->dq[k] *= (sp_real)passes;
}

#define sp__newton_sharpen_proof world_sharpen_proof
#include "../../solvers/limit/strong.c"

/* What is answered: by the search, by proofs one after the other, by the question about dead loads and by live loads alone. */
typedef struct world {
    int done, none, kind, spent;
    double best, lower;
    int falls[2];
    sp_verdict claim;
    double alone;                                       /* balance under live loads alone; below 0: no end, 0: none found */
} world;

static world here;
static int runs, sharpened, proofs, questions, alone, climbed;

static int world_run(sp__limit *L)
{
    runs++;
    L->none = here.none;
    L->r.kind = (sp_limit_kind)here.kind;
    L->best = here.best < 9 ? R(here.best) : SP__HUGE;
    L->r.lower = R(here.lower) * L->ref;
    L->engine.w->budget.spent = here.spent == 2;
    return here.done;
}

static int world_climb(sp__limit *L)
{
    climbed++;
    runs--;
    L->best = L->slack = 7;
    L->bracket.dq[0] = 7;
    const int done = world_run(L);
    L->best = 7;
    return done;
}

static void world_sharpen(sp__limit *L) { (void)L; sharpened++; }
static void sharpen(sp__limit *L) { sp__limit_sharpen(L); }

/* A proof that holds leaves what moves in it. */
static int world_falls(sp__bracket *b, sp_real lambda, int beyond, sp_real *all)
{
    CHECK_WITHIN(lambda, 0, 0);
    CHECK(!all && !beyond == (proofs > 0));
    if (!here.falls[proofs++ & 1]) return 0;
    b->dq[0] = R(proofs);
    return 1;
}

static sp_verdict world_ask(sp__limit *L, sp_real d, sp_real a, sp_real *f)
{
    questions++;
    CHECK_WITHIN(d, 1, 0);
    CHECK_WITHIN(a, 0, 0);
    CHECK(f == L->r.f);
    L->bracket.imbalance = R(0.25);
    if (here.claim == SP_UNSTABLE) L->bracket.dq[0] = 5;
    return here.claim;
}

static void world_alone(sp__limit *L)
{
    alone++;
    if (here.alone < 0) L->r.kind = SP_LIMIT_UNBOUNDED;
    if (here.alone > 0) L->best = R(here.alone);
    L->slack = R(0.5);
    L->bracket.dq[0] = 3;
}

#define sp__interior_run world_run
#define sp__strong_run world_climb
#define sp__limit_sharpen world_sharpen
#define sp__bracket_falls world_falls
#define sp__limit_ask world_ask
#define sp__limit_live_alone world_alone
#include "parts.h"

#include <math.h>

static sp__limit *L;

static const sp_strength GLUED = { R(0.5), R(1e12), R(1e12), 0 };
static const sp_real UP[3] = { 0, 0, 10 * W };

/* The limit of a cube in that world. */
static void cast(const world *w, const sp_real live[3], const sp_strength *strength)
{
    cube(NOTHING, live, 0, strength);
    L = limit_built(&s);
    here = *w;
    runs = sharpened = proofs = questions = alone = climbed = 0;
}

/* By live loads, where those make it fall, by dead ones below 0; twice the motion is as good and is not taken then. */
TEST(a_motion_is_sharpened_under_the_loads_it_falls_by)
{
    const world w = { 0, 0, 0, 0, 2, -1, { 0, 0 }, 0, 0 };
    for (int k = 0; k < 4; k++) {
        static const double best[] = { -1, 0, 0.25, 2 };
        cast(&w, UP, NULL);
        sp_arena room = test_arena;
        L->ref = R(0.3);
        CHECK_INT(sp__limit_open(L, &room), SP_OK);
        L->best = R(best[k]);
        L->slack = R(k == 3 ? 2 : 0);
        L->bracket.dq[2] = 3;
        sharpen(L);
        CHECK_NEAR(lift, k ? 3 * (double)W : -(double)W, TOL(1e-12, 1e-6));
        CHECK_WITHIN(L->engine.at, k ? best[k] : 0, 0);
        CHECK_NEAR(L->bracket.dq[2], k == 3 ? 6 : 3, TOL(1e-12, 1e-6));
        CHECK_NEAR(L->best, k == 3 ? 1 / 3. : best[k], TOL(1e-9, 1e-5));
        whole();
    }
}

/* Both ends meet where they are 1000 tol of 1 + 2 apart. */
TEST(a_search_ends_as_its_parts_say)
{
    static const struct { world of; int is, none, sharpened, proofs; } row[] = {
        { { 0, 0, 0, 0, 2, -1, { 0, 0 }, 0, 0 }, 0, 0, 1, 0 }, { { 1, 0, 0, 0, 2, -1, { 0, 0 }, 0, 0 }, 1, 0, 1, 0 },
        { { 0, 0, 0, 0, 9, -1, { 0, 0 }, 0, 0 }, 0, 0, 0, 0 }, { { 1, 1, 0, 0, 2, -1, { 0, 0 }, 0, 0 }, 1, 1, 0, 0 },
        { { 0, 1, 0, 0, 2, -1, { 1, 0 }, 0, 0 }, 1, 1, 1, 1 }, { { 0, 1, 0, 0, 2, -1, { 0, 0 }, 0, 0 }, 0, 0, 1, 1 },
        { { 0, 0, 0, 0, 2, 1.995, { 0, 0 }, 0, 0 }, 0, 0, 1, 0 }, { { 0, 0, 0, 0, 2, 1.998, { 0, 0 }, 0, 0 }, 1, 0, 1, 0 },
        { { 0, 0, SP_LIMIT_UNBOUNDED, 0, 9, 0, { 0, 0 }, 0, 0 }, 1, 0, 0, 0 },
        { { 1, 0, SP_LIMIT_UNBOUNDED, 0, 9, 0, { 0, 0 }, 0, 0 }, 1, 0, 0, 0 },
        { { 1, 0, SP_LIMIT_UNBOUNDED, 0, 9, -1, { 0, 0 }, 0, 0 }, 0, 0, 0, 0 },
        { { 1, 0, 0, 2, 2, -1, { 0, 0 }, 0, 0 }, 1, 0, 0, 0 }, { { 0, 0, 0, 2, 2, 1.998, { 0, 0 }, 0, 0 }, 1, 0, 0, 0 },
        { { 1, 1, 0, 1, 2, -1, { 1, 0 }, 0, 0 }, 1, 1, 0, 1 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        cast(&row[k].of, UP, NULL);
        sp_arena room = test_arena;
        CHECK_INT(sp__limit_open(L, &room), SP_OK);
        L->r.tol = R(1e-6);
        L->engine.w->budget.spent = here.spent == 1;    /* before it begins: nothing is run */
        if (here.spent == 1) L->none = 1;
        CHECK_INT(sp__limit_search(L), row[k].is);
        CHECK_INT(runs, here.spent != 1);
        CHECK_INT(L->none, row[k].none);
        CHECK_INT(sharpened, row[k].sharpened);
        CHECK_INT(proofs, row[k].proofs);
        CHECK_INT(L->bracket.spent, here.spent > 0);
        whole();
    }
}

/* The motion at hand, 3 at first, stays unless it falls whatever live loads do. */
TEST(dead_loads_are_known_before_a_climb)
{
    static const struct { world of; int is, none, dead, proofs; double lower, dq; } row[] = {
        { { 0, 0, 0, 0, 0, 0, { 0, 0 }, SP_STABLE, 0 }, 1, 0, SP_STABLE, 0, 0, 3 },
        { { 0, 0, 0, 0, 0, 0, { 0, 0 }, SP_UNDECIDED, 0 }, 0, 0, SP_UNDECIDED, 0, -1, 3 },
        { { 0, 0, 0, 0, 0, 0, { 0, 0 }, SP_UNSTABLE, 0 }, 0, 0, SP_UNDECIDED, 2, -1, 3 },
        { { 0, 0, 0, 0, 0, 0, { 0, 1 }, SP_UNSTABLE, 0 }, 1, 0, SP_UNSTABLE, 2, -1, 3 },
        { { 0, 0, 0, 0, 0, 0, { 1, 0 }, SP_UNSTABLE, 0 }, 0, 1, SP_UNSTABLE, 1, -1, 1 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        cast(&row[k].of, UP, &GLUED);
        L->bracket.dq[0] = 3;
        L->r.imbalance = 9;
        CHECK_INT(sp__strong_check_dead(L), row[k].is);
        CHECK_INT(questions, 1);
        CHECK_INT(proofs, row[k].proofs);
        CHECK_INT(L->none, row[k].none);
        CHECK_INT(L->r.dead, row[k].dead);
        CHECK_WITHIN(L->r.lower, row[k].lower, 0);
        CHECK_WITHIN(L->r.imbalance, row[k].is && row[k].dead == SP_STABLE ? 0.25 : 9, 0);
        CHECK_WITHIN(L->bracket.dq[0], row[k].dq, 0);
        whole();
    }
}

/* strong: joints have strength; live: there are live loads. */
typedef struct begun {
    world of;
    int strong, live, done, none, kind, runs, alone, questions, climbs, most;
    double best, slack, dq;
} begun;

static void start(const begun *r)
{
    const sp_real up[3] = { 0, 0, (sp_real)r->live * W };
    int done = 0;
    cast(&r->of, up, r->strong ? &GLUED : NULL);
    sp_arena room = test_arena;
    L->engine.most = 300;
    L->bracket.dq[0] = 2;
    CHECK_INT(sp__limit_start(L, &room, &done), SP_OK);
    CHECK_INT(done, r->done);
    CHECK_INT(L->none, r->none);
    CHECK_INT(L->r.kind, r->kind);
    const int counts[5] = { runs, alone, questions, climbed, L->engine.most };
    const int is[5] = { r->runs, r->alone, r->questions, r->climbs, r->most };
    for (int k = 0; k < 5; k++) CHECK_INT(counts[k], is[k]);
    CHECK_WITHIN(L->best < SP__HUGE ? L->best : -1, r->best, 0);
    CHECK_WITHIN(L->slack, r->slack, 0);
    CHECK_WITHIN(L->bracket.dq[0], r->dq, 0);
    CHECK_INT(L->bracket.spent, r->of.spent == 2);
    whole();
}

TEST(the_first_search_is_chosen_by_joints_and_loads)
{
    enum { ENDLESS = SP_LIMIT_UNBOUNDED };
    static const begun row[] = {
        { { 0, 0, 0, 0, 2, -1, { 0, 0 }, 0, 0 }, 0, 0, 0, 0, ENDLESS, 0, 0, 0, 0, 300, -1, 0, 2 },
        { { 0, 0, 0, 0, 2, -1, { 0, 0 }, 0, 0 }, 0, -1, 0, 0, 0, 1, 0, 0, 0, 300, 2, 0, 2 },
        { { 1, 0, 0, 0, 2, -1, { 0, 0 }, 0, 0 }, 0, 1, 1, 0, 0, 1, 0, 0, 0, 300, 2, 0, 2 },
        { { 0, 0, 0, 0, 9, -1, { 0, 0 }, 0, 1 }, 0, 1, 0, 0, 0, 1, 1, 0, 0, 300, 1, 0.5, 3 },
        { { 0, 0, ENDLESS, 0, 9, -1, { 0, 0 }, 0, 1 }, 0, 1, 0, 0, ENDLESS, 1, 0, 0, 0, 300, -1, 0, 2 },
        { { 0, 1, 0, 0, 2, -1, { 0, 0 }, 0, 1 }, 0, 1, 0, 0, 0, 1, 0, 0, 0, 300, 2, 0, 2 },
        { { 0, 0, 0, 0, 2, -1, { 0, 0 }, SP_STABLE, -1 }, 1, 1, 0, 0, ENDLESS, 0, 1, 0, 0, 300, -1, 0.5, 3 },
        { { 0, 0, 0, 0, 2, -1, { 0, 0 }, SP_UNDECIDED, 1 }, 1, 1, 0, 0, 0, 0, 1, 1, 0, 160, 1, 0.5, 3 },
        { { 1, 0, 0, 0, 2, -1, { 0, 0 }, SP_STABLE, 1 }, 1, 1, 1, 0, 0, 0, 1, 1, 1, 160, 7, 7, 7 },
        { { 0, 0, 0, 2, 2, -1, { 0, 0 }, SP_STABLE, 0 }, 1, 1, 0, 0, 0, 0, 1, 1, 1, 160, 7, 7, 7 },
        { { 1, 1, 0, 0, 2, -1, { 1, 0 }, SP_STABLE, 1 }, 1, 1, 1, 1, 0, 0, 1, 1, 1, 160, 7, 7, 1 },
        { { 1, 1, 0, 0, 2, -1, { 0, 0 }, SP_STABLE, 1 }, 1, 1, 0, 0, 0, 0, 1, 1, 1, 160, 1, 0.5, 3 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) start(&row[k]);
}

/* A climb begins from balances of 0 and above. */
TEST(a_balance_below_0_is_no_start_of_a_climb)
{
    for (int k = -1; k < 2; k++) {
        int done = 0;
        const world w = { 1, 0, 0, 0, 2, -1, { 0, 0 }, SP_STABLE, 0 };
        cast(&w, UP, &GLUED);
        sp_arena room = test_arena;
        L->best = R(k);
        L->engine.most = k < 0 ? 40 : 160;
        CHECK_INT(sp__limit_start(L, &room, &done), SP_OK);
        CHECK_INT(climbed, k >= 0);
        CHECK_INT(L->engine.most, k < 0 ? 40 : 160);
        CHECK_INT(alone, 0);
        whole();
    }
}

/* Nothing of an earlier search is left: dead and live loads have their own hints, in ref and by themselves. */
TEST(a_search_is_opened_anew)
{
    const world w = { 0, 0, 0, 0, 2, -1, { 0, 0 }, 0, 0 };
    static int32_t row[1];
    for (int ref = 1; ref < 4; ref += 2) {
        cast(&w, UP, NULL);
        sp_arena room = test_arena;
        L->ref = R(ref);
        L->engine.h.m.capped = (void *)row;
        CHECK_INT(sp__limit_open(L, &room), SP_OK);
        CHECK(!L->engine.h.m.capped && L->engine.h.m.x == L->engine.w->x);
        CHECK(L->bracket.y0 == L->r.y0);
        CHECK_WITHIN(L->engine.at, 1, 0);
        CHECK(L->engine.w->budget.limit > 0);
        double size[2] = { 0, 0 };
        for (int k = 0; k < 24; k++) size[k / 12] += fabs((double)L->r.y0[k]);
        CHECK_NEAR(size[1], 10 * size[0], TOL(1e-9, 1e-4));       /* ten times its weight, upwards */
        whole();
    }
}

/* Dead and live loads of one mirror are searched in its rows; where one of both has another, or none, in all. */
TEST(rows_of_a_mirror_are_those_of_both_loads)
{
    static const struct { double dead[3], live[3]; int plane; } row[] = {
        { { 0, 0, 0 }, { 1, 0, 0 }, 1 }, { { 0, 0, 0 }, { 0, 1, 0 }, 1 }, { { 0, 0, 0 }, { 1, 1, 0 }, 1 },
        { { 1, 0, 0 }, { 1, 0, 0 }, 1 }, { { 0, 1, 0 }, { 1, 0, 0 }, 0 }, { { 1, 0, 0 }, { 0, 1, 0 }, 0 },
        { { 0, 1, 0 }, { 1, -1, 0 }, 0 }, { { 1, 0, 0 }, { -1, 1, 0 }, 0 }, { { 1, 0, 0 }, { 0, 0, 1 }, 1 },
        { { 0, 1, 0 }, { 0, 0, 1 }, 1 }, { { 0.3, 0.1, 0 }, { 0, 0, 1 }, 0 }, { { 0, 0, 1 }, { 0.3, 0.1, 0 }, 0 }
    };
    const world w = { 0, 0, 0, 0, 2, -1, { 0, 0 }, 0, 0 };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        cast(&w, UP, NULL);
        for (int e = 0; e < 3; e++) {
            L->bracket.dead[e] = (R(row[k].dead[e]) - (e == 2 ? 2 : 0)) * W;
            L->bracket.live[e] = R(row[k].live[e]) * W;
        }
        L->ref = 1;
        sp_arena room = test_arena;
        sp__limit_reduction(L, &room);
        CHECK_INT(L->engine.reduction != NULL, row[k].plane && SP__WITH_REDUCTION);
        CHECK_INT(room.used > test_arena.used, row[k].plane && SP__WITH_REDUCTION);
        CHECK_NEAR(L->bracket.pb.p[2], L->bracket.dead[2] + L->bracket.live[2], TOL(1e-12, 1e-6));
        whole();
    }
}

#endif

TEST_LIST(start)
#if SP__WITH_INTERIOR
    RUN(a_motion_is_sharpened_under_the_loads_it_falls_by)
    RUN(a_search_ends_as_its_parts_say)
    RUN(dead_loads_are_known_before_a_climb)
    RUN(the_first_search_is_chosen_by_joints_and_loads)
    RUN(a_balance_below_0_is_no_start_of_a_climb)
    RUN(a_search_is_opened_anew)
    RUN(rows_of_a_mirror_are_those_of_both_loads)
#endif
TEST_END
