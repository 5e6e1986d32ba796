/* Numbers of a proof that a quadratic program has no solution: its radius, its goal, its direction. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/qp/certificate.c"

#if SP__WITH_QP

#include <math.h>
#include <string.h>

/* (down - its rounding) / rest, no larger than a number that stands for any; nothing where down is rounding, rest no number. */
TEST(a_radius_is_what_is_proved_over_what_is_left)
{
    const volatile sp_real zero = 0;
    const double eps = (double)SP_EPSILON;
    CHECK_NEAR(sp__qp_proof_radius(2, 3, 4, R(0.5)), (2 - 8 * eps * 3) / 0.5, 2 * eps);
    CHECK_NEAR(sp__qp_proof_radius(2, 0, 4, 8), 0.25, 0);
    CHECK_NEAR(sp__qp_proof_radius(2, 0, 4, 0), (double)SP__NEVER, 0);
    CHECK_NEAR(sp__qp_proof_radius(1, 0, 4, R(0.5) / SP__NEVER), (double)SP__NEVER, 0);
    CHECK_NEAR(sp__qp_proof_radius(24 * (sp_real)SP_EPSILON, 3, 4, 1), 0, 0);       /* as much as its rounding: none */
    CHECK(sp__qp_proof_radius(25 * (sp_real)SP_EPSILON, 3, 4, 1) > 0);
    CHECK_NEAR(sp__qp_proof_radius(-1, 0, 4, 1), 0, 0);
    CHECK_NEAR(sp__qp_proof_radius(1, 0, 4, -1), 0, 0);
    CHECK_NEAR(sp__qp_proof_radius(1, 0, 4, zero / zero), 0, 0);
    CHECK_NEAR(sp__qp_proof_radius(zero / zero, 0, 4, 1), 0, 0);
}

/* min q . x without rows falls along x; what is left of two terms of size 1 after they cancel may be their rounding. */
TEST(a_fall_no_larger_than_the_rounding_of_its_terms_proves_nothing)
{
    static const int32_t none[3] = { 0, 0, 0 };
    const sp_real little = 4 * (sp_real)SP_EPSILON, cancels[2] = { 1, -1 - little }, plain[2] = { 0, -little };
    sp_real X[2] = { 1, 1 }, Px[2], D[2] = { 1, 1 };
    sp__qp w;
    memset(&w, 0, sizeof w);
    w.qp.n = 2;
    w.qp.Pp = w.qp.Ap = none;
    w.X = X; w.Px = Px; w.D = D; w.c = 1;
    w.qp.q = cancels;
    CHECK_NEAR(sp__qp_proof_dual(&w), 0, 0);
    w.qp.q = plain;
    CHECK_NEAR(sp__qp_proof_dual(&w), (double)SP__NEVER, 0);
    X[1] = -1;                                          /* uphill */
    CHECK_NEAR(sp__qp_proof_dual(&w), 0, 0);
}

TEST(a_goal_is_a_multiple_of_how_far_the_iterate_is)
{
    const sp_real v[3] = { 1, -2, R(0.5) };
    CHECK_NEAR(sp__qp_proof_goal(v, 3, 10), 45, 0);
    CHECK_NEAR(sp__qp_proof_goal(v, 0, 10), 10, 0);
}

TEST(a_direction_has_1_for_its_largest_and_is_none_of_nothing)
{
    const volatile sp_real zero = 0;
    sp_real v[3] = { 1, -4, 2 }, none[3] = { 0, 0, 0 }, far[3] = { 1, 1 / zero, 2 }, odd[3] = { zero / zero, 7, 2 };
    CHECK_INT(sp__qp_proof_direction(v, 3), 1);
    CHECK_NEAR(v[0], 0.25, 0);
    CHECK_NEAR(v[1], -1, 0);
    CHECK_NEAR(v[2], 0.5, 0);
    CHECK_INT(sp__qp_proof_direction(none, 3), 0);
    CHECK_INT(sp__qp_proof_direction(far, 3), 0);
    CHECK_INT(sp__qp_proof_direction(odd, 3), 0);
    CHECK(sp__qp_proof_direction(v, 0) == 0);
}

/* A NaN goes through, wherever it is; also where larger numbers follow it. */
TEST(the_largest_of_numbers_is_no_number_where_one_is_none)
{
    const volatile sp_real zero = 0;
    for (int at = 0; at < 4; at++) {
        sp_real v[4] = { 3, -9, 0, 5 };
        CHECK_NEAR(sp__largest(v, 4), 9, 0);
        v[at] = zero / zero;
        const sp_real most = sp__largest(v, 4);
        CHECK(!(most >= 0) && !(most < 0));
    }
    CHECK_NEAR(sp__largest(NULL, 0), 0, 0);
}

#endif

TEST_LIST(certificate)
#if SP__WITH_QP
    RUN(a_radius_is_what_is_proved_over_what_is_left)
    RUN(a_fall_no_larger_than_the_rounding_of_its_terms_proves_nothing)
    RUN(a_goal_is_a_multiple_of_how_far_the_iterate_is)
    RUN(a_direction_has_1_for_its_largest_and_is_none_of_nothing)
    RUN(the_largest_of_numbers_is_no_number_where_one_is_none)
#endif
TEST_END
