/* Interior points for quadratic programs, asked alone: answers known by hand, both methods, memory, turns. */
#include "../test.h"

#include <string.h>

#ifndef SP_QP_NO_INTERIOR
enum { N = 30, M = 60 };
#ifdef SP_QP_NO_POLISH
enum { LAST_DIGITS = 0 };
#else
enum { LAST_DIGITS = 1 };
#endif

static const sp_real none = R(1e30);

static sp_qp_settings by(sp_qp_method method, sp_qp_backend backend)
{
    sp_qp_settings set = sp_qp_default();
    set.method = method;
    set.backend = backend;
    return set;
}

static sp_qp_result asked(const sp_qp *qp, const sp_qp_settings *set)
{
    sp_qp_result r;
    memset(&r, 0, sizeof r);
    r.status = SP_QP_NUMERICAL;
    test_arena.used = 0;
    CHECK_INT(sp_qp_solve(qp, set, &test_arena, NULL, NULL, &r), SP_OK);
    return r;
}

/* One problem in static memory. */
static sp_real Px[N * N], Ax[N * M], q[N], l[M], u[M];
static int32_t Pp[N + 1], Pi[N * N], Ap[N + 1], Ai[N * M];

/* A diagonal P and a dense A drawn at random, bounds about A x0, some rows equations, in units up to `spread` apart. */
static sp_qp drawn(int32_t n, int32_t m, int32_t equations, double spread)
{
    sp_real x0[N], row[M] = { 0 };
    int32_t p = 0;
    Ap[0] = Pp[0] = 0;
    for (int32_t j = 0; j < n; j++) {
        const sp_real unit = test_random_int(0, 1) ? R(spread) : R(1);
        x0[j] = test_random_real(-1, 1) / unit;
        q[j] = test_random_real(-1, 1) * unit;
        Px[j] = test_random_real(0, 1) * unit * unit;
        Pi[j] = j;
        Pp[j + 1] = j + 1;
        for (int32_t i = 0; i < m; i++, p++) { Ai[p] = i; Ax[p] = test_random_real(-1, 1) * unit; row[i] += Ax[p] * x0[j]; }
        Ap[j + 1] = p;
    }
    for (int32_t i = 0; i < m; i++) {
        l[i] = i < equations ? row[i] : row[i] - test_random_real(0, 1);
        u[i] = i < equations ? row[i] : row[i] + test_random_real(0, 1);
    }
    const sp_qp qp = { n, m, Pp, Pi, Px, q, Ap, Ai, Ax, l, u };
    return qp;
}

static const sp_qp_backend backends[] = { SP_QP_SPARSE, SP_QP_DENSE };

TEST(both_methods_find_the_same_value)
{
    for (int trial = 0; trial < SOME_OF(60, 16); trial++) {
        const int32_t n = test_random_int(2, N), m = test_random_int(n, 2 * n);
        const sp_qp qp = drawn(n, m, test_random_int(0, n / 2), trial % 4 ? 1 : TOL(1e3, 30));
        sp_qp_settings set = by(SP_QP_ADMM, backends[trial % 2]);
        set.eps_abs = set.eps_rel = R(TOL(1e-8, 1e-4));
        const sp_qp_result admm = asked(&qp, &set);
        const sp_real want = admm.objective;
        NEED(admm.status == SP_QP_SOLVED);
        set.method = SP_QP_INTERIOR;
        const sp_qp_result r = asked(&qp, &set);
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_WITHIN(r.objective, want, TOL(1e-6, 1e-3) * (1 + (want < 0 ? -want : want)));
        if (LAST_DIGITS) CHECK(r.iterations < TOL(60, 120));            /* else ADMM finds them after many */
    }
}

/* Least x1^2 + x2^2 on x1 + x2 = 2, given twice and once more doubled: rows that depend on each other, and only equations. */
TEST(equations_given_three_times_are_met)
{
    static const int32_t p[] = { 0, 1, 2 }, i[] = { 0, 1 }, ap[] = { 0, 3, 6 }, ai[] = { 0, 1, 2, 0, 1, 2 };
    static const sp_real two[] = { 2, 2 }, a[] = { 1, 1, 2, 1, 1, 2 }, b[] = { 2, 2, 4 };
    const sp_qp qp = { 2, 3, p, i, two, NULL, ap, ai, a, b, b };
    for (int k = 0; k < 2; k++) {
        const sp_qp_settings set = by(SP_QP_INTERIOR, backends[k]);
        const sp_qp_result r = asked(&qp, &set);
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_WITHIN(r.x[0], 1, TOL(1e-5, 1e-3));
        CHECK_WITHIN(r.x[1], 1, TOL(1e-5, 1e-3));
        CHECK_WITHIN(r.objective, 2, TOL(1e-4, 1e-3));
    }
}

/* A linear program whose every point of an edge is best: -x1 - x2 with x1 + x2 <= 1, x >= 0. The value is what is known. */
TEST(an_edge_of_best_points_has_one_value)
{
    static const int32_t ap[] = { 0, 2, 4 }, ai[] = { 0, 1, 0, 2 };
    static const sp_real c[] = { -1, -1 }, a[] = { 1, 1, 1, 1 };
    const sp_real low[] = { -none, 0, 0 }, high[] = { 1, none, none };
    const sp_qp qp = { 2, 3, NULL, NULL, NULL, c, ap, ai, a, low, high };
    for (int k = 0; k < 2; k++) {
        const sp_qp_settings set = by(SP_QP_INTERIOR, backends[k]);
        const sp_qp_result r = asked(&qp, &set);
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_NEAR(r.objective, -1, TOL(1e-5, 1e-3));
        CHECK_NEAR(r.y[0], 1, TOL(1e-4, 1e-2));
    }
}

/* x1 + x2 <= 1 and x1 + x2 >= 2; and min -x1 with x1 >= 0. Claims come with a certificate. */
TEST(what_has_no_answer_is_proved_so)
{
    static const int32_t ap[] = { 0, 2, 4 }, ai[] = { 0, 1, 0, 1 }, bp[] = { 0, 1 }, bi[] = { 0 };
    static const sp_real a[] = { 1, 1, 1, 1 }, c[] = { 1, 1 }, one[] = { 1 }, minus[] = { -1 }, nil[] = { 0 };
    const sp_real low[] = { -none, 2 }, high[] = { 1, none };
    const sp_qp empty = { 2, 2, NULL, NULL, NULL, c, ap, ai, a, low, high };
    const sp_qp open = { 1, 1, NULL, NULL, NULL, minus, bp, bi, one, nil, &none };
    for (int k = 0; k < 2; k++) {
        const sp_qp_settings set = by(SP_QP_INTERIOR, backends[k]);
        sp_qp_result r = asked(&empty, &set);
        CHECK_INT(r.status, SP_QP_PRIMAL_INFEASIBLE);
        CHECK(r.radius > 0 && r.y[0] > 0 && r.y[1] < 0);
        r = asked(&open, &set);
        CHECK_INT(r.status, SP_QP_DUAL_INFEASIBLE);
        CHECK(r.radius > 0 && r.x[0] > 0);
    }
}

/* A bound that is met but does not push: x1^2 with x1 >= 0. Interior points come near it as a square root only. */
TEST(a_bound_that_does_not_push_is_met_to_the_digits_asked_for)
{
    static const int32_t p[] = { 0, 1 }, i[] = { 0 };
    static const sp_real two[] = { 2 }, one[] = { 1 }, nil[] = { 0 };
    const sp_qp qp = { 1, 1, p, i, two, NULL, p, i, one, nil, &none };
    for (int k = 0; k < 2; k++) {
        sp_qp_settings set = by(SP_QP_INTERIOR, backends[k]);
        const sp_qp_result r = asked(&qp, &set);
        CHECK_INT(r.status, SP_QP_SOLVED);
#ifndef SP_QP_NO_POLISH
        CHECK_WITHIN(r.x[0], 0, TOL(1e-5, 1e-3));
#endif
        CHECK_WITHIN(r.objective, 0, TOL(1e-6, 1e-4));
    }
}

TEST(memory_is_told_to_the_byte)
{
    for (int trial = 0; trial < 8; trial++) {
        const sp_qp qp = drawn(test_random_int(2, N), test_random_int(2, N), 1, 1);
        sp_qp_settings set = by(SP_QP_INTERIOR, backends[trial % 2]);
        size_t bytes = 0, without = 0;
        sp_qp_work *work;
        sp_arena a;
        test_arena.used = 0;
        NEED(sp_qp_memory(&qp, &set, test_arena, &bytes) == SP_OK);
        sp_arena_init(&a, test_arena.base, bytes);
        CHECK_INT(sp_qp_setup(&qp, &set, &a, &work), SP_OK);
        CHECK_INT(a.peak, bytes);
        sp_arena_init(&a, test_arena.base, bytes - 1);
        CHECK_INT(sp_qp_setup(&qp, &set, &a, &work), SP_E_MEMORY);
        CHECK_INT(a.used, 0);
        set.method = SP_QP_ADMM;
        NEED(sp_qp_memory(&qp, &set, test_arena, &without) == SP_OK);
        CHECK(without <= bytes);
    }
}

/* From a guess ADMM is first, without one interior points are; who asks for one of them gets it. */
TEST(a_guess_decides_who_is_first)
{
    const sp_qp qp = drawn(12, 20, 3, 1);
    sp_qp_settings set = by(SP_QP_INTERIOR, SP_QP_SPARSE);
    sp_qp_result r, again;
    const sp_qp_result interior = asked(&qp, &set);
    set.method = SP_QP_ADMM;
    const sp_qp_result admm = asked(&qp, &set);
    set.method = SP_QP_AUTO;
    const sp_qp_result cold = asked(&qp, &set);
    CHECK_INT(cold.flops, interior.flops);
    CHECK(cold.iterations < admm.iterations);
    sp_qp_work *work;
    test_arena.used = 0;
    NEED(sp_qp_setup(&qp, &set, &test_arena, &work) == SP_OK);
    CHECK_INT(sp_qp_run(work, NULL, NULL, &r), SP_OK);
    const sp_real value = r.objective;
    CHECK_INT(sp_qp_run(work, r.x, r.y, &again), SP_OK);
    CHECK_INT(again.status, SP_QP_SOLVED);
    CHECK(again.iterations <= set.check && again.factorisations < r.factorisations);
    CHECK_NEAR(again.objective, value, TOL(1e-4, 1e-2));
}

TEST(a_method_that_is_none_is_refused)
{
    const sp_qp qp = drawn(2, 2, 0, 1);
    const sp_qp_settings set = by((sp_qp_method)7, SP_QP_SPARSE);
    sp_qp_result r;
    CHECK_INT(sp_qp_solve(&qp, &set, &test_arena, NULL, NULL, &r), SP_E_RANGE);
}

/* The struct that others fill in, filled in with interior points: settings that ask for ADMM change nothing. */
TEST(plugged_in_interior_points_are_the_same)
{
    const sp_qp_solver own = sp_qp_interior();
    const sp_qp qp = drawn(9, 14, 2, 1);
    sp_qp_settings set = by(SP_QP_INTERIOR, SP_QP_SPARSE);
    size_t bytes = 0, again = 1;
    sp_qp_result b;
    const sp_qp_result a = asked(&qp, &set);
    NEED(sp_qp_memory(&qp, &set, test_arena, &bytes) == SP_OK);
    set.method = SP_QP_ADMM;
    CHECK_INT(own.need(own.self, &qp, &set, test_arena, &again), SP_OK);
    CHECK_INT(bytes, again);
    CHECK_INT(own.solve(own.self, &qp, &set, &test_arena, NULL, NULL, &b), SP_OK);
    CHECK_INT(a.flops, b.flops);
    for (int32_t j = 0; j < qp.n; j++) CHECK_WITHIN(a.x[j], b.x[j], 0);
}

TEST_LIST(proximal)
    RUN(both_methods_find_the_same_value)
    RUN(equations_given_three_times_are_met)
    RUN(an_edge_of_best_points_has_one_value)
    RUN(what_has_no_answer_is_proved_so)
    RUN(a_bound_that_does_not_push_is_met_to_the_digits_asked_for)
    RUN(memory_is_told_to_the_byte)
    RUN(a_guess_decides_who_is_first)
    RUN(a_method_that_is_none_is_refused)
    RUN(plugged_in_interior_points_are_the_same)
TEST_END
#else
TEST(without_interior_points_they_are_refused)
{
    static const int32_t p[] = { 0, 1 }, i[] = { 0 };
    static const sp_real one[] = { 1 };
    const sp_qp qp = { 1, 0, p, i, one, one, NULL, NULL, NULL, NULL, NULL };
    sp_qp_settings set = sp_qp_default();
    sp_qp_result r;
    CHECK_INT(sp_qp_solve(&qp, &set, &test_arena, NULL, NULL, &r), SP_OK);
    set.method = SP_QP_INTERIOR;
    CHECK_INT(sp_qp_solve(&qp, &set, &test_arena, NULL, NULL, &r), SP_E_UNSUPPORTED);
}

TEST_LIST(proximal)
    RUN(without_interior_points_they_are_refused)
TEST_END
#endif
