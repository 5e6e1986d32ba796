/* What a bracket and its engine keep, and what they are asked, by their formulas. */
#include "parts.h"

#include <math.h>

#if SP__WITH_INTERIOR

TEST(a_bracket_is_built_at_rest_with_a_pyramid_around_the_cone)
{
    const sp_real push[3] = { R(100), 0, 0 };
    cube(NOTHING, push, 0, NULL);
    set.faces = 8;
    set.inscribed = 1;
    for (int budget = 0; budget < 2; budget++) {
        set.budget = budget;
        open();
        CHECK_INT(b.limit, budget ? 1 : INT64_MAX / 4);
        CHECK_INT(b.set.inscribed, 1);
        CHECK_INT(b.wide.inscribed, 0);
        CHECK_INT(b.wide.faces, 8);
        CHECK(b.dq != b.whole && b.dq != b.live && b.whole != b.hint);
        for (int k = 0; k < 6; k++) CHECK(!(b.dq[k] < 0 || b.dq[k] > 0));
        CHECK_NEAR(b.live[0], 100, TOL(1e-12, 1e-6));
        CHECK_NEAR(b.dead[2], -W, TOL(1e-12, 1e-6));
        whole();
    }
}

TEST(passes_are_what_is_left_of_the_budget_but_eight)
{
    const int64_t pass = SP__FLOPS_CERTIFICATE;
    memset(&b, 0, sizeof b);
    CHECK_INT(sp__bracket_sweeps(&b), INT32_MAX);       /* of nothing */
    for (int points = 1; points < 5; points++) {
        b.pb.points = points;
        b.cost.flops = 77;
        for (int k = 0; k < 6; k++) {
            b.limit = 77 + pass * points * (8 + k) + (k & 1);
            CHECK_INT(sp__bracket_sweeps(&b), k < 2 ? 0 : k);
        }
        b.limit = 77 + pass * points * (9 + (int64_t)INT32_MAX);
        CHECK_INT(sp__bracket_sweeps(&b), INT32_MAX);
        b.limit = 77 + pass * points * (7 + (int64_t)INT32_MAX);
        CHECK_INT(sp__bracket_sweeps(&b), INT32_MAX - 1);
    }
}

TEST(without_a_pass_left_nothing_is_proved)
{
    const sp_real push[3] = { 0, 0, R(-100) };
    sp_real f[12] = { 0 };
    cube(NOTHING, push, 0, NULL);
    open();
    for (int v = 0; v < 4; v++) f[3 * v] = W / 4;
    CHECK_INT(sp__bracket_stands(&b, 1, 0, f, NULL), 1);
    b.dq[2] = 1;
    b.limit = b.cost.flops;
    CHECK_INT(sp__bracket_stands(&b, 1, 0, f, NULL), 0);
    CHECK(b.spent);
    CHECK_INT(sp__bracket_falls_beyond(&b), 0);
    CHECK_INT(sp__bracket_falls(&b, 0, 0, NULL), 0);
    CHECK_INT(sp__bracket_resists(&b, 0), 0);
    whole();
}

/* Pulled up by twice its weight a cube rises; live loads push it aside and down, `share` times as much as lets force_bound
 * hold it: W - resist = force_bound |dead| / |live| x, so it falls at every larger multiple where share < 1. */
static int inside;                                      /* of four faces */
static int rises(sp_real aside, sp_real share, sp_real resist, int32_t final)
{
    const sp_real up[3] = { 0, 0, 2 * W };
    const sp_real x = share * (W - resist) * aside / (1000 * W), live[3] = { aside, 0, -x };
    cube(up, live, 0, NULL);
    set.force_bound = 1000;
    set.faces = inside ? 4 : 0;
    set.inscribed = inside;
    open();
    b.dq[2] = 1;
    b.resist = resist;
    b.final = final;
    const int falls = sp__bracket_falls_beyond(&b);
    whole();
    return falls;
}

TEST(what_live_loads_hinder_a_little_falls_at_every_larger_multiple)
{
    for (int k = 1; k < 4; k++) {
        const sp_real aside = (sp_real)k * W / 2;
        CHECK_INT(rises(aside, R(0.95), 0, 0), 1);
        CHECK_INT(rises(aside, R(1.05), 0, 0), 0);
        CHECK_INT(rises(aside, R(0.95), W / 2, 1), 1);
        CHECK_INT(rises(aside, R(1.05), W / 2, 1), 0);
        CHECK_INT(rises(aside, -1, W / 2, 0), 1);       /* they push */
    }
    CHECK_INT(rises(W, R(0.95), W / 2, 0), 0);          /* what resists by strength must be final */
    CHECK_INT(rises(W, R(0.95), R(0.5), 0), 0);
    CHECK_INT(rises(W, R(0.95), 0, 1), 1);
}

TEST(what_friction_could_hold_does_not_fall_at_every_larger_multiple)
{
    const sp_real drag[3] = { 4 * W, 0, 0 }, live[3] = { R(-0.001) * W, W, 0 };
    cube(drag, live, 0, NULL);
    open();
    b.dq[0] = 1;
    CHECK_INT(sp__bracket_falls_beyond(&b), 0);
    b.pb.live = NULL;
    CHECK_INT(sp__bracket_falls_beyond(&b), 1);         /* without live loads there is no larger one */
    whole();
}

/* Forces inside the cone alone prove nothing of those beyond them: the pyramid around it does. */
TEST(a_pyramid_around_the_cone_tells_what_is_final)
{
    inside = 1;
    CHECK_INT(rises(W, R(0.95), 0, 0), 1);
    CHECK_INT(rises(W, R(1.05), 0, 0), 0);
    inside = 0;
}

TEST(an_engine_begins_at_rest_with_a_quarter_of_tol)
{
    const sp_strength glued = { R(0.5), R(1000), 0, 0 };
    for (int strong = 0; strong < 2; strong++) {
        cube(NOTHING, NOTHING, 0, strong ? &glued : NULL);
        set.iterations = 30;
        open();
        for (int k = 0; k < 6; k++) CHECK(!(g.state.y[k] < 0 || g.state.y[k] > 0));
        CHECK_NEAR(g.n.goal, b.set.tol / 4, TOL(1e-15, 1e-7));
        CHECK_INT(g.state.brief, 1);
        CHECK_INT(g.most, 30);
        CHECK_INT(g.n.left, strong ? 120 : 30);
        whole();
    }
}

/* sum over joints of |dead| by that of |live|, moments by the arm of the joint. */
TEST(the_reference_is_where_dead_and_live_loads_are_of_one_size)
{
    const sp_real dead[3] = { 0, 0, 0 }, live[3] = { R(100), R(200), R(200) };
    for (int k = 0; k < 3; k++) {
        const sp_real up = k ? R(0.25) * (sp_real)k : 0;
        cube(dead, live, up, NULL);
        open();
        const double moment = 100 * (double)up * sqrt(5), arm = 0.5;
        CHECK_NEAR(sp__engine_reference(&b), (double)W / (300 + moment / arm), TOL(1e-12, 1e-5));
        for (int e = 0; e < 3; e++) b.pb.contact[0].rb[e] *= 4;
        CHECK_NEAR(sp__engine_reference(&b), (double)W / (300 + moment / (4 * arm)), TOL(1e-12, 1e-5));
        for (int e = 0; e < 3; e++) b.pb.contact[0].rb[e] = 0;
        CHECK_NEAR(sp__engine_reference(&b), (double)W / 300, TOL(1e-12, 1e-5));
    }
    cube(dead, NOTHING, 0, NULL);
    open();
    CHECK_NEAR(sp__engine_reference(&b), 1, 0);
    cube(dead, live, 0, NULL);
    s.gravity[2] = 0;
    open();
    CHECK_NEAR(sp__engine_reference(&b), 1, 0);
    whole();
}

TEST(gates_start_from_no_forces_with_what_is_left)
{
    const sp_real push[3] = { R(100), 0, 0 };
    for (int k = 0; k < 3; k++) {
        sp_verdict claim = SP_UNDECIDED;
        cube(NOTHING, push, 0, NULL);
        open();
        sp_real *f = fenced_take(&test_arena, 12, sizeof *f);
        g.rest = test_arena;
        for (int e = 0; e < 12; e++) f[e] = 7;
        g.n.left = 20 + k;
        g.most = 21;
        if (k < 2) b.limit = b.cost.flops + 80 * SP__FLOPS_CERTIFICATE * (int64_t)b.pb.points + k;
        sp__bracket_load(&b, 1, 0);
        CHECK_INT(sp__engine_gates(&g, &b, f, &claim), SP_OK);
        CHECK_INT(b.set.iterations, k ? 21 : 20);
        CHECK_INT(b.spent, !k);
        CHECK(g.state.f == f && g.state.y0 == b.hint);
        if (!k) for (int e = 0; e < 12; e++) CHECK(!(f[e] < 0 || f[e] > 0));
        whole();
    }
}

TEST(a_question_takes_what_it_costs)
{
    for (int falls = 0; falls < 2; falls++) {
        const sp_real push[3] = { (falls ? R(0.6) : R(0.4)) * W, 0, 0 };
        cube(NOTHING, push, R(-0.5), NULL);
        open();
        sp_real *f = fenced_take(&test_arena, 12, sizeof *f);
        g.rest = test_arena;
        const int32_t left = g.n.left;
        CHECK_INT(sp__engine_ask(&g, &b, 1, 1, f), falls ? SP_UNSTABLE : SP_STABLE);
        CHECK_INT(left - g.n.left, b.cost.factorisations);
        CHECK(b.cost.factorisations > 0);
        if (falls) CHECK(b.dq[0] > 0);
        whole();
    }
}

/* What flops or iterations end is told as a spent budget where there is one. */
TEST(a_question_that_a_budget_ends_has_spent_it)
{
    const sp_real push[3] = { R(0.6) * W, 0, 0 };
    for (int k = 0; k < 4; k++) {
        cube(NOTHING, push, R(-0.5), NULL);
        set.budget = k < 3 ? k : INT64_MAX / 8;
        open();
        sp_real *f = fenced_take(&test_arena, 12, sizeof *f);
        g.rest = test_arena;
        if (k < 3) b.limit = b.cost.flops + 80 * SP__FLOPS_CERTIFICATE * (int64_t)b.pb.points + 1;
        else g.n.left = 0;                              /* no iteration left */
        CHECK_INT(sp__engine_ask(&g, &b, 1, 1, f), SP_UNDECIDED);
        CHECK_INT(b.spent, k > 0);
        whole();
    }
}

/* A cube is pushed at its foot, friction 1/2: by 2/5 of its weight it stands, by 3/5 it slides. */
TEST(a_whole_check_begins_at_rest_with_all_iterations)
{
    for (int k = 0; k < 6; k++) {
        const int all = k & 1, falls = k >= 2, spent = k >= 4;
        const sp_real push[3] = { (falls ? R(0.6) : R(0.4)) * W, 0, 0 };
        cube(NOTHING, push, R(-0.5), NULL);
        open();
        sp_real *f = fenced_take(&test_arena, 12, sizeof *f), sum = 0;
        g.rest = test_arena;
        g.n.left = g.most = 1;
        for (int e = 0; e < 6; e++) b.dq[e] = 7;
        if (spent) b.limit = b.cost.flops + 80 * SP__FLOPS_CERTIFICATE * (int64_t)b.pb.points;
        CHECK_INT(sp__engine_check(&g, &b, 1, all, f), !falls);
        CHECK_INT(g.n.left, b.wide.iterations);
        CHECK_INT(g.most, b.wide.iterations);
        for (int v = 0; v < 4; v++) sum += f[3 * v];
        if (!falls) CHECK_NEAR(sum, W, TOL(1e-6, 1e-3));
        if (falls && !spent) CHECK(b.dq[0] > 0 && b.cost.factorisations > 0);
        for (int e = 0; e < 6 && spent; e++) CHECK_WITHIN(b.dq[e], 0, 0);
        whole();
    }
}

/* A push along no axis has no mirror: only a check in all rows answers. It is not brief, and what it
 * finds is certified once. */
TEST(a_whole_check_asks_in_rows_of_a_mirror_or_in_all)
{
    for (int k = 0; k < 4; k++) {
        const int all = k & 1, mirror = k >= 2;
        const sp_real push[3] = { R(0.2) * W, mirror ? 0 : R(0.1) * W, 0 };
        cube(NOTHING, push, R(-0.5), NULL);
        open();
        sp_real *f = fenced_take(&test_arena, 12, sizeof *f);
        g.rest = test_arena;
        CHECK_INT(sp__engine_check(&g, &b, 1, all, f), all || mirror);
        CHECK_INT(g.state.brief, 0);
        if (all || mirror) {
            const int64_t proof = b.cost.flops - g.state.cost.flops;
            CHECK_INT(sp__bracket_stands(&b, 1, 1, f, f), 1);
            CHECK_INT((int)(b.cost.flops - g.state.cost.flops - 2 * proof), 0);
        }
        whole();
    }
}

/* Under 1e10 times its weight a cube's own is what is dropped, with forces along the joint of less than 1e-5 of the largest. */
TEST(forces_of_a_large_multiple_balance_live_loads_alone_without_the_tiny_ones)
{
    const sp_real down[3] = { 0, 0, -W }, lambda = R(1e10);
    sp_real f[13];
    cube(NOTHING, down, 0, NULL);
    set.tol = R(TOL(1e-9, 1e-5));
    open();
    for (int sound = 0; sound < 2; sound++) {
        for (int e = 0; e < 12; e++) f[e] = 0;
        f[0] = f[6] = lambda * W / 2;                   /* two opposite corners */
        f[3] = lambda * W * R(1e-7);
        f[12] = 5;
        if (!sound) f[0] *= R(1.01);
        CHECK_INT(sp__engine_unbounded(&b, f, lambda, 1), sound);
        CHECK_NEAR(f[6], W / 2, TOL(1e-9, 1e-5));
        if (sound) CHECK_NEAR(f[0], W / 2, TOL(1e-9, 1e-5));
        CHECK_NEAR(f[3], 0, 0);
        CHECK_NEAR(f[12], 5, 0);
    }
    whole();
}

TEST(loads_that_cancel_are_no_size)
{
    static const struct { double a, at; } row[] = { { 0, 0 }, { -0.5, -0.5 }, { -0.9, -0.9 }, { -0.9395, 0.0605 }, { -0.935, -0.935 },
                                                    { -1, 0 }, { -1.0605, -0.0605 }, { -1.07, -1.07 }, { 3, 3 } };
    const sp_real down[3] = { 0, 0, -W };
    cube(NOTHING, down, 0, NULL);
    open();
    sp__limit L;
    memset(&L, 0, sizeof L);
    L.bracket = b;
    L.engine = g;
    L.ref = 1;
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        sp__limit_loads_sized(&L, R(row[k].a));
        CHECK_WITHIN(L.engine.at, row[k].at, TOL(1e-12, 1e-6));
        CHECK_NEAR(L.bracket.pb.p[2], -(1 + row[k].at) * (double)W, TOL(1e-12, 1e-5));
    }
    for (int e = 0; e < 6; e++) {                       /* of loads so small, along any axis */
        for (int q = 0; q < 6; q++) b.dead[q] = b.live[q] = q == e ? R(1e-6) : 0;
        for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
            sp__limit_loads_sized(&L, R(row[k].a));
            CHECK_WITHIN(L.engine.at, row[k].at, TOL(1e-12, 1e-6));
        }
    }
    whole();
}

#endif

TEST_LIST(ask)
#if SP__WITH_INTERIOR
    RUN(a_bracket_is_built_at_rest_with_a_pyramid_around_the_cone)
    RUN(passes_are_what_is_left_of_the_budget_but_eight)
    RUN(without_a_pass_left_nothing_is_proved)
    RUN(what_live_loads_hinder_a_little_falls_at_every_larger_multiple)
    RUN(what_friction_could_hold_does_not_fall_at_every_larger_multiple)
    RUN(a_pyramid_around_the_cone_tells_what_is_final)
    RUN(an_engine_begins_at_rest_with_a_quarter_of_tol)
    RUN(the_reference_is_where_dead_and_live_loads_are_of_one_size)
    RUN(gates_start_from_no_forces_with_what_is_left)
    RUN(a_question_takes_what_it_costs)
    RUN(a_question_that_a_budget_ends_has_spent_it)
#ifndef SP_NO_PLAN
    RUN(a_whole_check_begins_at_rest_with_all_iterations)
    RUN(a_whole_check_asks_in_rows_of_a_mirror_or_in_all)
#endif
    RUN(forces_of_a_large_multiple_balance_live_loads_alone_without_the_tiny_ones)
    RUN(loads_that_cancel_are_no_size)
#endif
TEST_END
