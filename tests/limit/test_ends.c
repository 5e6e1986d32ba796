/* Both ends of a limit and the result they give, by their formulas. */
#include "parts.h"

#include <math.h>

#if SP__WITH_INTERIOR

static sp__limit *L;

static const sp_strength GLUED = { R(0.5), R(1e12), R(1e12), 0 };

/* The limit of a cube, its multiples in `ref`. */
static void limit(const sp_real dead[3], const sp_real live[3], const sp_strength *strength, sp_real ref)
{
    cube(dead, live, 0, strength);
    L = limit_built(&s);
    L->ref = ref;
}

static const sp_real UP[3] = { 0, 0, 10 * W };

TEST(what_tol_forgives_is_by_the_power_of_the_mechanism)
{
    static const double upper[] = { -1, 0, 0.5, 0.8, 4 };
    limit(NOTHING, UP, NULL, 3);
    L->bracket.dq[2] = 1;
    L->r.least_imbalance = R(0.25);
    L->r.tol = R(1e-3);
    CHECK_NEAR(sp__limit_balance(L), 1. / 30, TOL(1e-12, 1e-6));
    for (size_t k = 0; k < sizeof upper / sizeof *upper; k++) {
        L->r.upper = R(upper[k]);
        CHECK_NEAR(sp__limit_forgiven(L), k ? 1e-3 * (upper[k] / 3 - 1. / 30) / 0.25 : 0, TOL(1e-12, 1e-6));
    }
    whole();
}

/* A bracket is closed where it is no wider than 1000 tol (lower + ref) + 4 slack ref, slack at most 0.01. */
TEST(a_bracket_that_is_narrow_is_found)
{
    static const struct { double lower, wide, slack; int none, kind, is; } row[] = {
        { 1, 0.00299, 0, 0, 0, SP_LIMIT_FOUND }, { 1, 0.00301, 0, 0, 0, SP_LIMIT_UNDECIDED }, { 1, 0, 0, 0, 0, SP_LIMIT_FOUND },
        { 1, 0.0109, 1e-3, 0, 0, SP_LIMIT_FOUND }, { 1, 0.0111, 1e-3, 0, 0, SP_LIMIT_UNDECIDED },
        { 1, 0.0829, 0.02, 0, 0, SP_LIMIT_FOUND }, { 1, 0.0831, 0.02, 0, 0, SP_LIMIT_UNDECIDED },
        { 1, -0.0001, 0.02, 0, 0, SP_LIMIT_UNDECIDED }, { 0, 0.0019, 0, 0, 0, SP_LIMIT_FOUND },
        { -1, 0, 0, 1, 0, SP_LIMIT_UNDECIDED }, { -1, 1, 0, 1, 0, SP_LIMIT_NONE }, { -1, 1, 0, 0, 0, SP_LIMIT_NONE },
        { -1, 3, 0, 0, 0, SP_LIMIT_UNDECIDED }, { 0, 0, 0, 1, 0, SP_LIMIT_NONE },
        { -1, 0, 0, 0, SP_LIMIT_UNBOUNDED, SP_LIMIT_UNDECIDED }, { 0, -1, 0, 0, SP_LIMIT_UNBOUNDED, SP_LIMIT_UNBOUNDED }
    };
    for (int spent = 0; spent < 3; spent++)
        for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
            limit(NOTHING, UP, NULL, 2);
            L->none = row[k].none;
            L->slack = R(row[k].slack);
            L->bracket.spent = spent == 1;
            if (spent == 2) L->engine.n.left = 0;
            L->r.kind = (sp_limit_kind)row[k].kind;
            L->r.tol = R(1e-6);
            L->r.lower = R(row[k].lower);
            L->r.upper = R(row[k].lower + row[k].wide);
            L->r.least_imbalance = 1;
            sp__limit_conclude(L);
            CHECK_INT(L->r.kind, row[k].is);
            CHECK_INT(L->r.reason, row[k].is ? SP_REASON_FORCES : spent ? SP_REASON_BUDGET : SP_REASON_LIMIT);
            whole();
        }
}

TEST(the_multiplier_is_the_power_balance_between_both_ends)
{
    static const double ends[][3] = { { 0.99, 1.01, 1 }, { 0.99, 0.995, 0.995 }, { 0.999, 1.002, 1 } };
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
        limit(NOTHING, UP, NULL, R(0.3));
        L->bracket.dq[2] = 1;
        L->slack = R(0.02);
        L->r.lower = R(0.1 * ends[k][0]);
        L->r.upper = R(0.1 * ends[k][1]);
        L->r.least_imbalance = R(0.125);
        L->r.imbalance = 77;
        sp__limit_conclude(L);
        CHECK_INT(L->r.kind, SP_LIMIT_FOUND);
        CHECK_WITHIN(L->r.multiplier, 0.1 * ends[k][2], TOL(1e-12, 1e-6));
        CHECK_WITHIN(L->r.imbalance, 77, 0);
        CHECK_WITHIN(L->r.within, 0.1 * (ends[k][1] - ends[k][0]) + (double)L->r.tol * 0.1 * (ends[k][1] - 1) / 0.125,
                     TOL(1e-12, 1e-6));
    }
    whole();
}

/* No forces carry a tenth of what lifts the cube. */
TEST(forces_within_tol_carry_the_power_balance_too)
{
    limit(NOTHING, UP, NULL, R(0.3));
    L->bracket.dq[2] = 1;
    L->r.lower = R(0.1) * (1 + TOL(R(1e-9), R(1e-5)));
    L->r.upper = R(0.1) * (1 + TOL(R(1e-8), R(1e-4)));
    L->r.least_imbalance = R(0.125);
    L->r.imbalance = 77;
    sp__limit_conclude(L);
    CHECK_INT(L->r.kind, SP_LIMIT_FOUND);
    CHECK_WITHIN(L->r.lower, 0.1, TOL(1e-15, 1e-7));
    CHECK(L->r.imbalance < 1);
    CHECK_WITHIN(L->r.multiplier, 0.1, TOL(1e-15, 1e-7));
    whole();
}

/* It rises at twice its weight, in ref at 2. */
TEST(where_the_best_motion_fell_is_an_upper_end_once)
{
    for (int k = 0; k < 3; k++) {
        limit(NOTHING, UP, NULL, R(0.1));
        L->upper[2] = 1;
        for (int e = 0; e < 6; e++) if (e != 2) L->upper[e] = 0;
        L->fell = 2;
        L->none = k == 2;
        CHECK_INT(sp__limit_upper_fell(L, k ? R(2.1) : R(1.9)), k == 1);
        if (k == 1) {
            CHECK_WITHIN(L->r.upper, 0.2, TOL(1e-12, 1e-6));
            CHECK(L->r.least_imbalance > L->r.tol && L->r.final);
            CHECK(L->fell >= SP__HUGE);
            CHECK(L->r.dq[8] > 0 && L->bracket.dq[2] > 0);
            CHECK_INT(sp__limit_upper_fell(L, SP__HUGE), 0);
        } else CHECK_WITHIN(L->fell, 2, 0);
        whole();
    }
}

TEST(what_carries_more_is_the_lower_end)
{
    static const double lower[] = { 0.5, 0.3, 0.4 };
    const sp_real push[3] = { W, 0, 0 };
    for (int strong = 0; strong < 2; strong++)
        for (int k = 0; k < 3; k++) {
            limit(NOTHING, push, &GLUED, R(0.7));
            L->r.lower = R(lower[k]);
            sp__limit_upper_ask(L, R(0.4), strong);
            CHECK_WITHIN(L->r.lower, strong && k == 1 ? 0.4 : lower[k], TOL(1e-12, 1e-6));
            CHECK((L->r.f[0] > 0) == (strong && k == 1));       /* forces of what was known stay */
            whole();
        }
}

/* Pressed down there is no end; glue that holds 1e12 Pa shows none, and five multiples, each 16 times the last, are asked. */
TEST(a_large_multiple_shows_that_there_is_no_end)
{
    const sp_real down[3] = { 0, 0, R(-2) * W }, lift[3] = { 0, 0, W / 1000 };
    static const struct { double lower, tol; int none, kind, glued, up, is; double to; } row[] = {
        { 2001, 2e-5, 0, 0, 1, 0, SP_LIMIT_UNBOUNDED, 16 }, { 2001, 1e-6, 0, 0, 1, 0, SP_LIMIT_UNBOUNDED, 256 },
        { 2001, 1e-9, 0, 0, 1, 0, SP_LIMIT_UNBOUNDED, 16. * 16 * 16 * 16 * 16 }, { 1999, 1e-6, 0, 0, 1, 0, 0, 1 },
        { 2000, 1e-6, 0, 0, 1, 0, 0, 1 },
        { 2001, 1e-6, 1, 0, 1, 0, 0, 1 }, { 2001, 1e-6, 0, 0, 0, 0, 0, 1 }, { 2001, 1e-6, 0, SP_LIMIT_FOUND, 1, 0, SP_LIMIT_FOUND, 1 },
        { 2001, 1e-6, 0, 0, 1, 1, 0, 16. * 16 * 16 * 16 * 16 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row && sizeof(sp_real) == 8; k++) {
        limit(NOTHING, row[k].up ? lift : down, row[k].glued ? &GLUED : NULL, 2);
        L->none = row[k].none;
        L->bracket.set.tol = R(row[k].tol);
        L->r.kind = (sp_limit_kind)row[k].kind;
        L->r.lower = R(row[k].lower);
        sp__limit_endless(L);
        CHECK_INT(L->r.kind, row[k].is);
        CHECK_NEAR(L->r.lower, row[k].lower * row[k].to, 1e-12);
        if (row[k].is == SP_LIMIT_UNBOUNDED) {
            double sum = 0, least = 0;
            for (int v = 0; v < 4; v++) { sum += (double)L->r.ray[3 * v]; least += (double)L->r.f[3 * v]; }
            CHECK_NEAR(sum, 2 * (double)W, row[k].tol);         /* of the live loads alone */
            CHECK_NEAR(least, (1 + 2 * row[k].to * row[k].lower) * (double)W, 1e-6);
        }
        whole();
    }
}

/* Glue holds three weights, so twice the weight is carried and sixteen times that is not: the motion found there is worse than
 * the one at hand. */
TEST(the_motion_at_hand_stays_where_there_is_an_end)
{
    const sp_real lift[3] = { 0, 0, W / 1000 };
    const sp_strength weak = { R(0.5), 3 * W, 3 * W, 0 };
    limit(NOTHING, lift, &weak, 2);
    L->r.lower = 2001;
    for (int e = 0; e < 6; e++) L->bracket.dq[e] = (sp_real)(e + 1);
    const int32_t left = L->engine.n.left;
    sp__limit_endless(L);
    CHECK_INT(L->r.kind, 0);
    CHECK_WITHIN(L->r.lower, 2001, 0);
    CHECK(L->engine.n.left < left);                     /* it was asked */
    for (int e = 0; e < 6; e++) CHECK_WITHIN(L->bracket.dq[e], e + 1, 0);
    whole();
}

/* On both sides of what was left open, ever farther; not beyond the ends, nor below 0. */
TEST(a_question_left_open_is_asked_on_both_sides)
{
    const double d = SP__LIMIT_ASIDE * 1e-6 * 3;
    static const double both[] = { -1, 1, -2, 2, -4, 4, -8 }, above[] = { 1, 2, 4, 8 }, below[] = { -1, -2, -4, -8 };
    for (int k = 0; k < 3; k++) {
        const double *turn = k == 0 ? both : k == 1 ? above : below;
        sp__aside o = { SP__HUGE, 0 };
        sp_real a = 2;
        limit(NOTHING, UP, NULL, 4);
        L->bracket.set.tol = R(1e-6);
        L->best = k < 2 ? 3 : R(2 + d / 4);
        L->r.lower = k == 1 ? R(4 * (2 - d / 2)) : 0;
        L->least = 0;
        for (int it = 0; it < (k ? 4 : 7); it++) {
            CHECK_INT(sp__limit_aside(L, &o, R(d / 8), &a), 1);
            CHECK_WITHIN(a, 2 + turn[it] * d, TOL(1e-12, 1e-6));
        }
        CHECK_WITHIN(o.open, 2, 0);
    }
    limit(NOTHING, UP, NULL, 4);
    sp__aside o = { SP__HUGE, 0 };
    sp_real a = R(1e-5);
    L->bracket.set.tol = R(1e-5);                       /* below 0 nothing is asked */
    L->best = 1;
    L->least = -1;
    CHECK_INT(sp__limit_aside(L, &o, 0, &a), 1);
    CHECK_WITHIN(a, 1e-5 + SP__LIMIT_ASIDE * 1e-5 * 1.00001, TOL(1e-12, 1e-6));
    o.open = SP__HUGE;
    L->bracket.set.tol = R(1e-3);
    a = 2;
    L->best = R(2.01);
    L->least = R(1.99);
    CHECK_INT(sp__limit_aside(L, &o, 0, &a), 0);
    whole();
}

TEST(an_interval_is_closed_halved_or_left)
{
    for (int k = 0; k < 4; k++) {                       /* where joints have strength it is halved */
        const double apart = (k & 2 ? SP__LIMIT_HALVED : SP__LIMIT_WIDE) * 1e-5 * 3;
        limit(NOTHING, UP, k & 2 ? &GLUED : NULL, 4);
        L->bracket.set.tol = R(1e-5);
        L->best = 2;
        L->r.lower = R(4 * (2 - apart * (k & 1 ? 1.01 : 0.99)));
        CHECK_INT(sp__limit_closed(L), !(k & 1));
        CHECK_INT(sp__limit_ends_meet(L, R(apart / 3)), !(k & 1));
        whole();
    }
    limit(NOTHING, UP, NULL, 4);
    L->r.lower = -1;
    L->best = R(-0.2);
    CHECK_INT(sp__limit_closed(L), 0);
    CHECK_INT(sp__limit_ends_meet(L, 1), 0);
    L->r.lower = 2;                                     /* 0.5 */
    L->best = SP__HUGE;
    CHECK_INT(sp__limit_ends_meet(L, 2), 0);
    L->least = R(0.25);
    CHECK_WITHIN(sp__limit_between(L, 2, R(1.2)), 1.2, TOL(1e-12, 1e-6));       /* 0.8 gained, 0.7 left */
    CHECK_INT(L->slow, 0);
    CHECK_WITHIN(sp__limit_between(L, 2, R(1.3)), 0.9, TOL(1e-12, 1e-6));       /* 0.7 gained, 0.8 left */
    CHECK_INT(L->slow, 1);
    L->least = R(0.75);
    CHECK_WITHIN(sp__limit_between(L, 2, R(1.3)), 1.3, TOL(1e-12, 1e-6));
    L->least = L->r.lower = -1;                         /* 0 at least */
    CHECK_WITHIN(sp__limit_between(L, 2, R(1.1)), 0.55, TOL(1e-12, 1e-6));
    CHECK_WITHIN(sp__limit_between(L, 2, R(0.9)), 0.9, TOL(1e-12, 1e-6));
    L->r.tol = R(1e-6);
    CHECK_WITHIN(sp__interior_share(L, 1), 1e-3, TOL(1e-12, 1e-6));
    CHECK_WITHIN(sp__interior_share(L, R(1e-4)), 1e-4, TOL(1e-12, 1e-6));
    whole();
}

/* Numbers of few bits, so that what is met is met to the last one. low < next < best - step, next >= 0. */
TEST(a_question_beside_what_was_left_open_lies_between_both_ends)
{
    static const struct { double a, open, apart, low, best, step; int is; double next; } row[] = {
        { 2, 2, 0.25, 0, 10, 0.5, 1, 1.75 },                    /* at what was left open: no farther */
        { 2.5, 2, 0.25, 0, 10, 0.5, 1, 1.5 },                   /* above: twice as far */
        { 2.5, 2, 0.5, 1, 10, 0.5, 1, 3 },                      /* 1 is the lower end itself */
        { 2, 2, 2, -1, 10, 0.5, 1, 0 },                         /* 0 is asked */
        { 1.75, 2, 0.5, 1.5, 3, 0.5, 0, 1.75 },                 /* 2.5 is best - step */
        { 1.75, 2, 0.5, 1.5, 2.75, 0.5, 0, 1.75 },              /* and beyond */
        { 2, 2, 0.125, 0, 2.125, 0.5, 0, 2 }                    /* twice on each side */
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        sp__aside o = { R(row[k].open), R(row[k].apart) };
        sp_real a = R(row[k].a);
        limit(NOTHING, UP, NULL, 4);
        L->best = R(row[k].best);
        L->r.lower = -1;
        L->least = R(row[k].low);
        CHECK_INT(sp__limit_aside(L, &o, R(row[k].step), &a), row[k].is);
        CHECK_WITHIN(a, row[k].next, 0);
        whole();
    }
}

/* After forces that carry a, halfway to the best motion's balance where the last collapse gained little, else a step below it. */
TEST(what_stands_is_followed_by_the_next_question)
{
    limit(NOTHING, UP, NULL, 4);
    L->best = 2;
    for (int slow = 0; slow < 2; slow++) {
        sp__aside o = { SP__HUGE, 0 };
        sp_real a = 1;
        L->slow = slow;
        CHECK_INT(sp__limit_onwards(L, &o, R(0.1), &a), 1);
        CHECK_WITHIN(a, slow ? 1.5 : 1.9, TOL(1e-12, 1e-6));
        CHECK_INT(L->slow, 0);
        a = R(1.85);
        CHECK_INT(sp__limit_onwards(L, &o, R(0.1), &a), 0);
        o.open = R(1.5);                                /* what was open is passed */
        a = R(1.6);
        CHECK_INT(sp__limit_onwards(L, &o, R(0.1), &a), 1);
        CHECK(o.open >= SP__HUGE);
        o.open = R(1.5);
        o.apart = R(0.1);
        a = R(1.4);                                     /* beside it: now above */
        CHECK_INT(sp__limit_onwards(L, &o, R(0.1), &a), 1);
        CHECK_WITHIN(a, 1.6, TOL(1e-12, 1e-6));
        o.open = a = R(1.5);                            /* at it: onwards */
        CHECK_INT(sp__limit_onwards(L, &o, R(0.1), &a), 1);
        CHECK_WITHIN(a, 1.9, TOL(1e-12, 1e-6));
        a = R(1.75);                                    /* two steps are as narrow as it gets */
        CHECK_INT(sp__limit_onwards(L, &o, R(0.125), &a), 0);
        a = R(1.7);
        CHECK_INT(sp__limit_onwards(L, &o, R(0.125), &a), 1);
    }
    whole();
}

/* live . lower < 0 < live . upper: their sum in shares that live loads do little work in proves that nothing stands, where it falls. */
TEST(two_motions_prove_that_no_multiple_stands)
{
    const sp_real drag[3] = { 4 * W, 0, 0 };
    for (int k = 0; k < 5; k++) {
        const sp_real lift = k == 1 ? W / 8 : W / 2, live[3] = { k == 2 ? 0 : -W, 0, k == 3 ? 0 : lift };
        limit(drag, live, NULL, 1);
        for (int e = 0; e < 6; e++) L->lower[e] = L->upper[e] = 0;
        L->lower[0] = 3;
        L->upper[2] = 5;
        L->best = 3;
        L->least = k == 4 ? R(2.5) : 5;
        CHECK_INT(sp__limit_never_stands(L), k == 0);
        CHECK_INT(L->none, k == 0);
        /* 1 / W and 1 / lift, of that a share (5 - 3) / (2 + 2 3) more; where they are no two such motions nothing is tried */
        if (k == 0) CHECK_NEAR(L->bracket.dq[0] / L->bracket.dq[2], 0.4, TOL(1e-9, 1e-5));
        if (k == 1) for (int e = 0; e < 6; e++) CHECK_NEAR(L->bracket.dq[e], L->upper[e], 0);
        if (k > 1) CHECK_WITHIN(L->bracket.dq[2], 0, 0);
        whole();
    }
}

/* Pressed by live loads alone it stands for ever; lifted it falls at its weight. */
TEST(live_loads_alone_tell_of_an_end)
{
    const sp_real down[3] = { 0, 0, R(-2) * W }, none[3] = { 0, 0, 0 };
    limit(NOTHING, down, &GLUED, 4);
    sp__limit_live_alone(L);
    CHECK_INT(L->r.kind, SP_LIMIT_UNBOUNDED);
    double sum = 0;
    for (int v = 0; v < 4; v++) sum += (double)L->r.ray[3 * v];
    CHECK_NEAR(sum, 2 * (double)W, TOL(1e-6, 1e-3));
    CHECK(L->best >= SP__HUGE);
    whole();
    limit(NOTHING, UP, NULL, R(0.1));
    sp__limit_live_alone(L);
    CHECK_INT(L->r.kind, SP_LIMIT_UNDECIDED);
    CHECK_NEAR(L->best, 1, TOL(1e-9, 1e-5));
    whole();
    limit(NOTHING, none, NULL, 1);
    sp__limit_live_alone(L);
    CHECK(L->best >= SP__HUGE);
    whole();
}

/* Without a question left, what a lower end of 0 or of more tells. */
TEST(a_lower_end_of_0_stands_under_dead_loads)
{
    static const struct { double lower; int kind, dead; double lowest; } row[] = {
        { 0, SP_LIMIT_FOUND, SP_STABLE, 0 }, { 0.5, SP_LIMIT_FOUND, SP_UNDECIDED, 0.5 }, { -1, SP_LIMIT_NONE, SP_UNSTABLE, -1 },
        { -1, SP_LIMIT_UNDECIDED, SP_UNDECIDED, -1 }, { 3, SP_LIMIT_UNBOUNDED, SP_UNDECIDED, 3 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        limit(NOTHING, UP, NULL, 2);
        L->engine.n.left = 0;
        L->r.kind = (sp_limit_kind)row[k].kind;
        L->r.lower = R(row[k].lower);
        sp__limit_lowest(L, 0);
        CHECK_INT(L->r.dead, row[k].dead);
        CHECK_NEAR(L->r.lowest, row[k].lowest, 0);
        whole();
    }
}

/* A claim is read to its last number and no farther: a NaN lies behind each array. */
TEST(a_claim_is_judged_in_the_memory_that_was_told)
{
    const sp_real nan = R(NAN);
    limit(NOTHING, UP, NULL, 1);
    sp_limit_result x;
    sp_real f[13], ray[13], dq[13];
    int32_t held = -1;
    memset(&x, 0, sizeof x);
    for (int k = 0; k < 13; k++) f[k] = ray[k] = dq[k] = k < 12 ? 0 : nan;
    for (int v = 0; v < 4; v++) f[3 * v] = W / 4;
    dq[8] = 1;
    x.kind = SP_LIMIT_FOUND;
    x.lower = 0;
    x.upper = R(0.2);
    x.f = f;
    x.ray = ray;
    x.dq = dq;
    set.faces = SP__FACES_MAX;                          /* what is told is for any */
    const size_t need = sp__limit_verify_memory(&s);
    sp_arena room = test_arena;
    room.base = fenced_take(&test_arena, 1, need);
    room.used = room.peak = 0;
    room.capacity = need;
    CHECK_INT(sp_limit_verify(&s, &set, &x, room, &held), SP_OK);
    CHECK_INT(held, 1);
    while (sp_limit_verify(&s, &set, &x, room, &held) == SP_OK) room.capacity -= 8;
    fences_down(NULL);
    CHECK(need - room.capacity < 100);                  /* fences are a part of it */
    broken = built = 0;
}

/* Scratch of the size that is told, and less; the arena itself likewise. */
TEST(a_limit_takes_the_memory_that_was_told)
{
    sp_limit_result x;
    size_t bytes = 0, less = 0;
    limit(NOTHING, UP, NULL, 1);
    fences_down(NULL);
    const size_t told = sp__limit_scratch(&s);
    sp_arena scratch = { test_arena.base, told, 0, 0 }, room;
    scratch.base = test_arena.base + (test_arena.used / 64 + 1) * 64;
    CHECK_INT(sp__limit_memory(&s, &set, scratch, &bytes), SP_OK);
    room = scratch;
    room.capacity = bytes;
    while (sp__limit_memory(&s, &set, scratch, &less) == SP_OK) scratch.capacity -= 8;
    CHECK(told < 2 * scratch.capacity);                 /* whatever the order of factors */
    CHECK_INT(sp_limit(&s, &set, &room, &x), SP_OK);
    CHECK_INT(x.kind, SP_LIMIT_FOUND);
    CHECK(bytes - x.peak_bytes <= 4 * FENCE_WIDTH);
    fences_down(NULL);
    broken = built = 0;
}

/* Of no less than what it takes is there a limit's memory. */
TEST(a_limit_is_carved_whole_or_not_at_all)
{
    limit(NOTHING, UP, NULL, 1);
    sp_arena dry = sp__arena_dry(), room = test_arena;
    CHECK_INT(sp__limit_carve(L, &dry, &dry), 1);
    const size_t need = dry.used, at = test_arena.used;
    for (size_t bytes = 0; bytes < need; bytes += need / 100) {
        room.used = at;
        room.capacity = at + bytes;
        CHECK_INT(sp__limit_carve(L, &room, &room), 0);
    }
    fences_down(NULL);
    broken = built = 0;
}

/* What is not proved goes, whatever was there before. */
TEST(a_limit_leaves_no_motion_without_an_upper_end_and_no_ray_with_one)
{
    const sp_real down[3] = { 0, 0, R(-2) * W };
    for (int up = 0; up < 2; up++) {
        limit(NOTHING, up ? UP : down, NULL, 1);
        sp_arena room = test_arena;
        for (int e = 0; e < 12; e++) L->r.dq[e] = L->r.ray[e] = 7;
        CHECK_INT(sp__limit_decide(L, &room), SP_OK);
        CHECK_INT(L->r.kind, up ? SP_LIMIT_FOUND : SP_LIMIT_UNBOUNDED);
        for (int e = 0; e < 12; e++) CHECK_WITHIN(up ? L->r.ray[e] : L->r.dq[e], 0, 0);
        whole();
    }
}

/* Of live loads that cancel most of dead ones the seventh part is left: that much nearer both ends are asked to be. */
TEST(a_climb_ends_nearer_where_loads_cancel)
{
    const sp_real half[3] = { 0, 0, W / 2 };
    for (int k = 0; k < 24; k++) {
        const double ref = k & 2 ? 3 : 1, near = (double)SP__STRONG_NEAR / 7 * 2.5;
        limit(NOTHING, half, NULL, R(ref));
        L->best = R(1.5);
        for (int e = 0; e < 3; e++) {                   /* along each axis */
            L->bracket.dead[e] = e == k / 8 ? -W : 0;
            L->bracket.live[e] = e == k / 8 ? W / 2 / L->ref : 0;
        }
        if (k & 4) L->bracket.dead[3] = W;              /* moments have no share */
        L->r.lower = R(ref * (1.5 - near * (k & 1 ? 1.01 : 0.99)));
        if (sizeof(sp_real) > 4) CHECK_INT(sp__strong_met(L), !(k & 1));
        L->r.lower = R(ref * 1.5);
        CHECK_INT(sp__strong_met(L), 1);
        L->best = SP__HUGE;
        CHECK_INT(sp__strong_met(L), 0);
        whole();
    }
}

/* Steps beyond so many are put aside, none where there are fewer. */
TEST(steps_are_spared_beyond_so_many)
{
    for (int32_t left = 0; left < 9; left++) {
        sp__newton n;
        memset(&n, 0, sizeof n);
        n.left = left;
        CHECK_INT(sp__strong_spare(&n, 5), left > 5 ? left - 5 : 0);
        CHECK_INT(n.left, left > 5 ? 5 : left);
    }
}

TEST(one_block_alone_is_a_scene)
{
    const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 0 };
    const sp_real at[3] = { 0, 0, 0 };
    sp_limit_result x;
    int32_t held = 0;
    size_t bytes = 0;
    test_arena.used = 0;
    set = sp_settings_default();
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, R(1000), at, 0, NULL), SP_OK);
    CHECK_INT(sp__limit_memory(&s, &set, test_arena, &bytes), SP_OK);
    CHECK_INT(sp_limit(&s, &set, &test_arena, &x), SP_OK);
    CHECK_INT(x.kind, SP_LIMIT_NONE);
    CHECK_INT(sp_limit_verify(&s, &set, &x, test_arena, &held), SP_OK);
    CHECK_INT(held, 1);
    whole();
}

/* What a result does not prove is 0 to the last bit: a motion where there is no upper end, a ray where there is one. */
TEST(what_is_not_proved_is_nothing)
{
    const sp_real down[3] = { 0, 0, R(-2) * W }, none[3] = { 0, 0, 0 };
    for (int k = 0; k < 3; k++) {
        sp_limit_result x;
        cube(NOTHING, k == 0 ? down : k == 1 ? UP : none, 0, NULL);
        CHECK_INT(sp_limit(&s, &set, &test_arena, &x), SP_OK);
        CHECK_INT(x.kind, k == 1 ? SP_LIMIT_FOUND : SP_LIMIT_UNBOUNDED);
        for (int e = 0; e < 12; e++) CHECK_WITHIN(k == 1 ? x.ray[e] : x.dq[e], 0, 0);
    }
    fences_down(NULL);
    broken = built = 0;
}

/* A motion of rates dq ends at a + (what resists - its work under dead + a live) / that of live, and tol adds tol size / it. */
static void bound(const sp_real dead[3], const sp_real live[3], const double dq[3], sp_real a)
{
    sp_real y[6];
    limit(dead, live, NULL, R(0.1));
    sp_arena room = test_arena;
    CHECK_INT(sp__limit_open(L, &room), SP_OK);
    const sp__system *w = L->engine.w;
    sp__limit_loads(L, a);
    L->best = SP__HUGE;
    L->slack = 0;
    L->none = 0;
    for (int k = 0; k < 6; k++) y[k] = k < 3 ? R(-dq[k]) / w->measure.weight[0] : 0;
    sp__reduction_from_space(L->engine.reduction, 1, y);
    sp__limit_candidate(L, y);
}

TEST(a_motion_bounds_the_multiple_by_its_power)
{
    const double up[3] = { 0, 0, 1 }, climb[3] = { 1, 0, 0.5 }, sink[3] = { 0, 0, -1 };
    const sp_real drag[3] = { 2 * W, 0, 0 }, nudge[3] = { R(0.4) * W, 0, 0 }, side[3] = { 0, W, 0 };
    for (int k = 0; k < 3; k++) {
        bound(NOTHING, UP, up, R(0.5) * (sp_real)k);
        CHECK_WITHIN(L->best, 1, TOL(1e-12, 1e-6));
        CHECK_INT(L->none, 0);
        CHECK_WITHIN(L->bracket.dq[2], 1, TOL(1e-12, 1e-6));
        const sp__system *w = L->engine.w;
        CHECK_NEAR(L->slack, L->bracket.set.tol * w->measure.size[0] * w->measure.unit / W, TOL(1e-9, 1e-5));
    }
    bound(NOTHING, UP, climb, 0);                       /* friction 1/2: no contact resists */
    CHECK_WITHIN(L->best, 1, TOL(1e-9, 1e-5));
    bound(NOTHING, UP, sink, 0);                        /* live loads hinder it */
    CHECK(L->best >= SP__HUGE && !L->none);
    for (int k = 0; k < 2; k++) {                       /* they do nothing in it: W / 2 of drag is held */
        bound(k ? nudge : drag, side, climb, R(0.5));
        CHECK_INT(L->none, !k);
        if (k) CHECK(L->best >= SP__HUGE);
        else CHECK_WITHIN(L->best, -1, 0);
        CHECK_WITHIN(L->slack, 0, 0);
    }
    fences_down(NULL);
    broken = built = 0;
}

#endif

TEST_LIST(ends)
#if SP__WITH_INTERIOR
    RUN(what_tol_forgives_is_by_the_power_of_the_mechanism)
    RUN(a_bracket_that_is_narrow_is_found)
    RUN(the_multiplier_is_the_power_balance_between_both_ends)
    RUN(forces_within_tol_carry_the_power_balance_too)
    RUN(where_the_best_motion_fell_is_an_upper_end_once)
    RUN(what_carries_more_is_the_lower_end)
    RUN(a_large_multiple_shows_that_there_is_no_end)
    RUN(the_motion_at_hand_stays_where_there_is_an_end)
    RUN(a_question_left_open_is_asked_on_both_sides)
    RUN(an_interval_is_closed_halved_or_left)
    RUN(a_question_beside_what_was_left_open_lies_between_both_ends)
    RUN(what_stands_is_followed_by_the_next_question)
    RUN(two_motions_prove_that_no_multiple_stands)
    RUN(live_loads_alone_tell_of_an_end)
    RUN(a_lower_end_of_0_stands_under_dead_loads)
    RUN(a_claim_is_judged_in_the_memory_that_was_told)
    RUN(a_limit_takes_the_memory_that_was_told)
    RUN(a_limit_is_carved_whole_or_not_at_all)
    RUN(a_limit_leaves_no_motion_without_an_upper_end_and_no_ray_with_one)
    RUN(a_climb_ends_nearer_where_loads_cancel)
    RUN(steps_are_spared_beyond_so_many)
    RUN(one_block_alone_is_a_scene)
    RUN(what_is_not_proved_is_nothing)
    RUN(a_motion_bounds_the_multiple_by_its_power)
#endif
TEST_END
