/* Quadratic programs that make no sense, settings at and beyond each of their limits, arguments that are missing: by every call,
 * each refused by its own status, and neither arena nor result is touched. */
#include "../test.h"

#include <math.h>
#include <string.h>

#ifndef SP_NO_QP

/* min x^2 + y^2 - x, -1 <= x + y <= 1, 0 <= y. */
static const int32_t Pp[] = { 0, 1, 2 }, Pi[] = { 0, 1 }, Ap[] = { 0, 1, 3 }, Ai[] = { 0, 0, 1 };
static const sp_real Px[] = { 2, 2 }, Ax[] = { 1, 1, 1 }, q[] = { -1, 0 }, low[] = { -1, 0 }, high[] = { 1, SP_QP_INFINITY };
static const sp_qp plain = { 2, 2, Pp, Pi, Px, q, Ap, Ai, Ax, low, high };

/* What every call that takes a program and settings says of them. */
static int refused(const sp_qp *qp, const sp_qp_settings *set, sp_status want)
{
    static const unsigned char paint = 0x5a;
    sp_arena before = test_arena;
    sp_qp_result r;
    sp_qp_work *work = NULL;
    size_t bytes = 7;
    memset(&r, paint, sizeof r);
    int held = CHECK_INT(sp_qp_solve(qp, set, &test_arena, NULL, NULL, &r), want);
    held &= CHECK_INT(sp_qp_memory(qp, set, test_arena, &bytes), want) & CHECK_INT(bytes, 7);
    held &= CHECK_INT(sp_qp_setup(qp, set, &test_arena, &work), want) & CHECK(!work);
#ifndef SP_NO_DYKSTRA
    const sp_qp_solver solver = sp_qp_dykstra();
    held &= CHECK_INT(solver.solve(solver.self, qp, set, &test_arena, NULL, NULL, &r), want);
    held &= CHECK_INT(solver.need(solver.self, qp, set, test_arena, &bytes), want) & CHECK_INT(bytes, 7);
#endif
    for (size_t k = 0; k < sizeof r; k++) held &= ((unsigned char *)&r)[k] == paint;
    return CHECK(held && test_arena.used == before.used && test_arena.base == before.base);
}

/* Settings with one field changed: taken up to a limit, refused beyond it. */
static sp_qp_settings with(int field, double value)
{
    sp_qp_settings s = sp_qp_default();
    sp_real *real[] = { &s.eps_abs, &s.eps_rel, &s.eps_pinf, &s.eps_dinf, &s.radius, &s.cg_tol, &s.sigma, &s.relax, &s.rho,
                        &s.rho_equal, &s.adapt_factor };
    int32_t *whole[] = { &s.iterations, &s.check, &s.passes, &s.cg_steps, &s.adapt };
    if (field < 11) *real[field] = R(value);
    else if (field < 16) *whole[field - 11] = (int32_t)value;
    else s.budget = (int64_t)value;
    return s;
}

TEST(every_setting_of_a_program_has_its_limits)
{
    static const struct { int field; double out, in; } at[] = {
        { 0, -1e-9, 0 }, { 0, NAN, 1 }, { 0, INFINITY, 1 }, { 1, -1e-9, 0 }, { 1, NAN, 1 }, { 1, INFINITY, 1 },
        { 2, 0, 1e-30 }, { 2, NAN, 1 }, { 3, 0, 1e-30 }, { 3, -1, 1 }, { 4, 0.999, 1 }, { 4, NAN, 2 }, { 5, 0, 1e-9 }, { 5, NAN, 1 },
        { 6, 0, 1e-3 }, { 6, 1.001, 1 }, { 6, NAN, 1 }, { 7, 0, 0.01 }, { 7, 2, 1.99 }, { 7, NAN, 1 },
        { 8, 9e-7, 2e-6 }, { 8, 1.1e6, 1e6 }, { 8, NAN, 1 }, { 9, 0.999, 1 }, { 9, NAN, 2 }, { 10, 1, 1.01 }, { 10, NAN, 2 },
        { 11, 0, 1 }, { 11, INT32_MIN, 1 }, { 12, 0, 1 }, { 12, -1, 10 }, { 13, -1, 0 }, { 14, 0, 1 }, { 14, -1, 10 },
        { 15, -1, 0 }, { 15, INT32_MIN, 1 }, { 16, -1, 0 }
    };
    for (size_t k = 0; k < sizeof at / sizeof *at; k++) {
        const sp_qp_settings out = with(at[k].field, at[k].out), in = with(at[k].field, at[k].in);
        sp_qp_result r;
        sp_arena a = test_arena;
        if (!refused(&plain, &out, SP_E_RANGE) || !CHECK_INT(sp_qp_solve(&plain, &in, &a, NULL, NULL, &r), SP_OK))
            TEST_PRINT("    field %d, row %d\n", at[k].field, (int)k);
    }
    sp_qp_settings s = with(0, 0);
    s.eps_rel = 0;                                      /* one of the two may be 0 */
    refused(&plain, &s, SP_E_RANGE);
    s = sp_qp_default();
    s.backend = (sp_qp_backend)77;
    refused(&plain, &s, SP_E_RANGE);
#if !defined SP_QP_NO_INTERIOR && !defined SP_SMALL
    s = sp_qp_default();
    s.method = (sp_qp_method)77;
    refused(&plain, &s, SP_E_RANGE);
#endif
}

TEST(matrices_are_by_columns_with_ascending_rows)
{
    static const int32_t late[] = { 1, 1, 3 }, back[] = { 0, 2, 1 }, above[] = { 0, 0, 2 }, below[] = { 0, -1, 1 },
                         swapped[] = { 0, 1, 0 }, twice[] = { 0, 1, 1 }, lower[] = { 1, 1 };
    static const sp_real no[] = { NAN, 1, 1 }, far[] = { 1, 1, INFINITY };
    const sp_qp_settings set = sp_qp_default();
    for (int k = 0; k < 19; k++) {
        sp_qp p = plain;
        sp_status want = SP_E_INDEX;
        if (k == 0) p.Ap = late;
        if (k == 1) p.Ap = back;
        if (k == 2) p.Ai = above;
        if (k == 3) p.Ai = below;
        if (k == 4) p.Ai = swapped;
        if (k == 5) p.Ai = twice;
        if (k == 6) p.Pp = late;
        if (k == 7) p.Pi = lower;
        if (k > 7 && k < 14) want = SP_E_ARGUMENT;
        if (k == 8) p.Ap = NULL;
        if (k == 9) p.Ai = NULL;
        if (k == 10) p.Ax = NULL;
        if (k == 11) p.Pp = NULL;
        if (k == 12) p.Pi = NULL;
        if (k == 13) p.Px = NULL;
        if (k > 13) want = SP_E_NOT_FINITE;
        if (k == 14) p.Ax = no;
        if (k == 15) p.Ax = far;
        if (k == 16) p.Px = no;
        if (k == 17) p.q = no;
        if (k == 18) p.l = no;
        if (!refused(&p, &set, want)) TEST_PRINT("    case %d\n", k);
    }
    /* P of which an array is there and the others are not; a column of nothing needs no numbers. */
    static const int32_t none[] = { 0, 0, 0 };
    for (int k = 0; k < 2; k++) {
        sp_qp p = plain;
        p.Pp = NULL;
        if (k) p.Pi = NULL;
        else p.Px = NULL;
        refused(&p, &set, SP_E_ARGUMENT);
    }
    sp_qp p = plain;
    sp_qp_result r;
    p.Pp = p.Ap = none;
    p.Pi = p.Ai = NULL;
    p.Px = p.Ax = NULL;
    static const sp_real around[] = { -1, -1 };
    p.l = around;
    p.q = NULL;
    NEED(sp_qp_solve(&p, &set, &test_arena, NULL, NULL, &r) == SP_OK);
    CHECK_INT(r.status, SP_QP_SOLVED);
    CHECK_WITHIN(r.objective, 0, 0);
}

TEST(bounds_and_sizes_of_a_program_make_sense)
{
    static const sp_real above[] = { -1, SP_QP_INFINITY }, under[] = { -SP_QP_INFINITY, 1 }, over[] = { 2, 0 };
    const sp_qp_settings set = sp_qp_default();
    for (int k = 0; k < 10; k++) {
        sp_qp p = plain;
        sp_status want = SP_E_RANGE;
        if (k == 0) p.l = above;
        if (k == 1) { p.u = under; p.l = under; }
        if (k == 2) p.l = over;
        if (k > 2 && k < 8) want = SP_E_ARGUMENT;
        if (k == 3) p.n = -1;
        if (k == 4) p.m = -1;
        if (k == 5) p.l = NULL;
        if (k == 6) p.u = NULL;
        if (k == 7) p.l = p.u = NULL;
        if (k == 8) { p.n = 0; want = SP_E_EMPTY; }
        if (k == 9) { p.n = p.m = INT32_MAX / 2; want = SP_E_MEMORY; }
        if (!refused(&p, &set, want)) TEST_PRINT("    case %d\n", k);
    }
    refused(NULL, &set, SP_E_ARGUMENT);
}

TEST(arguments_of_a_program_that_are_missing_are_refused)
{
    static const sp_real no[] = { 0, NAN };
    const sp_arena none = { NULL, 0, 0, 0 };
    const sp_qp_settings set = sp_qp_default();
    sp_arena empty = none, a = test_arena;
    sp_qp_work *work = NULL;
    sp_qp_result r;
    size_t bytes = 7;
    memset(&r, 0, sizeof r);
    r.iterations = -7;
    CHECK_INT(sp_qp_solve(&plain, &set, NULL, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_solve(&plain, &set, &empty, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_solve(&plain, &set, &a, NULL, NULL, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_setup(&plain, &set, NULL, &work), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_setup(&plain, &set, &empty, &work), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_setup(&plain, &set, &a, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_memory(&plain, &set, a, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_memory(&plain, &set, none, &bytes), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_run(NULL, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_rho(NULL, 1), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_update(NULL, q, NULL, NULL), SP_E_ARGUMENT);
#ifndef SP_NO_DYKSTRA
    const sp_qp_solver solver = sp_qp_dykstra();
    CHECK_INT(solver.solve(solver.self, &plain, NULL, &a, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(solver.solve(solver.self, &plain, &set, NULL, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(solver.solve(solver.self, &plain, &set, &empty, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(solver.solve(solver.self, &plain, &set, &a, NULL, NULL, NULL), SP_E_ARGUMENT);
    CHECK_INT(solver.need(solver.self, &plain, NULL, a, &bytes), SP_E_ARGUMENT);
    CHECK_INT(solver.need(solver.self, &plain, &set, a, NULL), SP_E_ARGUMENT);
#endif
    CHECK_INT(bytes, 7);
    CHECK_INT(a.used, test_arena.used);
    NEED(sp_qp_setup(&plain, &set, &a, &work) == SP_OK);
    CHECK_INT(sp_qp_run(work, NULL, NULL, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_qp_run(work, no, NULL, &r), SP_E_NOT_FINITE);
    CHECK_INT(sp_qp_run(work, NULL, no, &r), SP_E_NOT_FINITE);
    CHECK_INT(sp_qp_rho(work, R(1e7)), SP_E_RANGE);
    CHECK_INT(sp_qp_rho(work, R(1e-7)), SP_E_RANGE);
    CHECK_INT(sp_qp_rho(work, R(NAN)), SP_E_RANGE);
    CHECK_INT(r.iterations, -7);
    NEED(sp_qp_run(work, NULL, NULL, &r) == SP_OK);
    CHECK_INT(r.status, SP_QP_SOLVED);
    CHECK_WITHIN(r.x[0], 0.5, TOL(1e-4, 1e-3));
    CHECK_WITHIN(r.x[1], 0, TOL(1e-4, 1e-3));
}

/* What a row is decides its penalty: a bound that becomes an equation, or none, asks for another factor, other numbers do not. */
TEST(a_program_is_factored_anew_where_a_row_changes_its_kind)
{
    static const sp_real other[] = { R(-0.25), 0 }, equal[] = { R(0.25), 0 }, at[] = { R(0.25), SP_QP_INFINITY };
    static const sp_real open[] = { -SP_QP_INFINITY, 0 }, wide[] = { SP_QP_INFINITY, SP_QP_INFINITY };
    const struct { const sp_real *l, *u; double x; } step[] = {
        { low, high, 0.5 }, { other, high, 0.5 }, { equal, at, 0.25 }, { low, high, 0.5 }, { open, wide, 0.5 } };
    sp_qp_settings set = sp_qp_default();
    sp_qp_work *work;
    sp_qp_result r;
    set.method = SP_QP_ADMM;
    set.polish = 0;
    set.adapt = 0;
    NEED(sp_qp_setup(&plain, &set, &test_arena, &work) == SP_OK);
    for (size_t k = 0; k < sizeof step / sizeof *step; k++) {
        CHECK_INT(sp_qp_update(work, NULL, step[k].l, step[k].u), SP_OK);
        NEED(sp_qp_run(work, NULL, NULL, &r) == SP_OK);
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_WITHIN(r.x[0], step[k].x, TOL(1e-3, 1e-2));
        CHECK_INT(r.factorisations, k != 1);
    }
    CHECK_INT(sp_qp_rho(work, r.rho), SP_OK);           /* the same: nothing to do */
    NEED(sp_qp_run(work, NULL, NULL, &r) == SP_OK);
    CHECK_INT(r.factorisations, 0);
    for (int k = 0; k < 2; k++) {                       /* less, more */
        CHECK_INT(sp_qp_rho(work, k ? 5 : R(0.01)), SP_OK);
        NEED(sp_qp_run(work, NULL, NULL, &r) == SP_OK);
        CHECK_INT(r.factorisations, 1);
        CHECK_WITHIN(r.x[0], 0.5, TOL(1e-3, 1e-2));
    }
}

/* A guess of either kind, for every method: the same answer. */
TEST(a_guess_of_unknowns_or_of_multipliers_changes_no_answer)
{
    static const sp_real far[] = { 7, -9 };
    for (int k = 0; k < 12; k++) {
        sp_arena a = test_arena;
        sp_qp_settings set = sp_qp_default();
        sp_qp_result r;
        set.method = (sp_qp_method)(k % 3);
#ifdef SP_QP_NO_INTERIOR
        set.method = SP_QP_ADMM;
#endif
        const sp_status status = sp_qp_solve(&plain, &set, &a, k & 4 ? far : NULL, k >= 6 ? far : NULL, &r);
        NEED(CHECK_INT(status, SP_OK));
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_WITHIN(r.x[0], 0.5, TOL(1e-4, 1e-3));
        CHECK_WITHIN(r.x[1], 0, TOL(1e-4, 1e-3));
    }
}

/* An off-diagonal entry without one on the diagonal: x'Px = 2 x y, which is no bowl. */
TEST(a_column_without_its_diagonal_is_no_bowl)
{
    static const int32_t p[] = { 0, 1, 2 }, i[] = { 0, 0 };
    static const sp_real x[] = { 2, 1 };
    sp_qp saddle = plain;
    saddle.Pp = p;
    saddle.Pi = i;
    saddle.Px = x;
    for (int k = 0; k < 2; k++) {
        sp_qp_settings set = sp_qp_default();
        sp_arena a = test_arena;
        sp_qp_result r;
        set.backend = k ? SP_QP_DENSE : SP_QP_SPARSE;
        CHECK_INT(sp_qp_solve(&saddle, &set, &a, NULL, NULL, &r), SP_E_INDEFINITE);
    }
}

/* It was refused as indefinite. */
TEST(a_bowl_of_stored_zeros_is_flat)
{
    static const int32_t p[] = { 0, 1, 2 }, i[] = { 0, 0 };
    static const sp_real zero[] = { 0, 0 };
    static const sp_qp_backend backend[] = { SP_QP_SPARSE, SP_QP_DENSE,
#ifndef SP_QP_NO_CG
                                             SP_QP_CG
#endif
    };
    sp_qp flat = plain;
    flat.Pp = p;
    flat.Pi = i;
    flat.Px = zero;
    for (size_t k = 0; k < sizeof backend / sizeof *backend; k++) {
        sp_qp_settings set = sp_qp_default();
        sp_arena a = test_arena;
        sp_qp_result r;
        set.backend = backend[k];
        if (!CHECK_INT(sp_qp_solve(&flat, &set, &a, NULL, NULL, &r), SP_OK)) continue;
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_WITHIN(r.x[0], 1, TOL(1e-4, 1e-3));       /* min -x of x + y <= 1, y >= 0 */
        CHECK_WITHIN(r.x[1], 0, TOL(1e-4, 1e-3));
    }
}

#ifndef SP_NO_DYKSTRA
/* Projections told to end: by their number, by a budget; nearly solved, not solved, and with nothing to give back. */
TEST(projections_end_where_they_are_told_to)
{
    static const int32_t p[] = { 0, 3, 6, 9 }, i[] = { 0, 1, 2, 0, 1, 2, 0, 1, 2 };
    static const sp_real a[] = { 1, R(0.9), -1, 1, 1, R(0.8), 1, R(1.1), 2 }, lo[] = { 3, R(2.5), -1 }, hi[] = { 4, 3, 0 };
    static const int32_t dp[] = { 0, 1, 2, 3 }, di[] = { 0, 1, 2 };
    static const sp_real d[] = { 1, 2, 3 }, c[] = { -9, 4, 2 };
    const sp_qp three = { 3, 3, dp, di, d, c, p, i, a, lo, hi };
    const sp_qp_solver solver = sp_qp_dykstra();
    sp_qp_settings set = sp_qp_default();
    int seen = 0;
    sp_qp_result r;
    for (int32_t most = 1; most < 600; most += 1 + most / 3)
        for (int64_t budget = 0; budget < 200000; budget = 3 * budget + 100) {
            sp_arena room = test_arena;
            set.iterations = most;
            set.budget = budget;
            NEED(solver.solve(solver.self, &three, &set, &room, NULL, NULL, &r) == SP_OK);
            seen |= 1 << r.status;
            CHECK(r.iterations <= most);
            if (r.status == SP_QP_BUDGET) CHECK(budget > 0 && r.flops >= budget);
            if (r.status == SP_QP_ITERATIONS) CHECK(r.iterations == most || r.iterations >= 500);
            if (r.status == SP_QP_SOLVED) CHECK(r.primal <= R(TOL(1e-3, 1e-2)));
            for (int k = 0; k < 3; k++) CHECK(r.x[k] - r.x[k] >= 0 && r.y[k] - r.y[k] >= 0);
        }
    CHECK(seen >> SP_QP_ITERATIONS & 1 && seen >> SP_QP_BUDGET & 1);
}
#endif

#endif

TEST_LIST(program)
#ifndef SP_NO_QP
    RUN(every_setting_of_a_program_has_its_limits)
    RUN(matrices_are_by_columns_with_ascending_rows)
    RUN(bounds_and_sizes_of_a_program_make_sense)
    RUN(arguments_of_a_program_that_are_missing_are_refused)
    RUN(a_program_is_factored_anew_where_a_row_changes_its_kind)
    RUN(a_guess_of_unknowns_or_of_multipliers_changes_no_answer)
    RUN(a_column_without_its_diagonal_is_no_bowl)
    RUN(a_bowl_of_stored_zeros_is_flat)
#ifndef SP_NO_DYKSTRA
    RUN(projections_end_where_they_are_told_to)
#endif
#endif
TEST_END
