/* A load that has mass, which turns with no block: what even friction holds at rest is not proved to stay there. And bodies on
 * points without friction, whose states are those of the limit with dilatancy. */
#include "../test.h"

#if !defined SP_NO_SLIDING && !defined SP_NO_IPM && !defined SP_NO_STRONG && !defined SP_EXACT_ONLY && !defined SP_QP_ONLY
#include "sliding.h"

/* A cube that slides at 1/2 of its weight, its push even with pressure. */
TEST(a_load_with_mass_takes_the_strong_side_away_and_no_other)
{
    static const sp_sliding_settings once = { 1, 90, 1 };
    for (int laden = 0; laden < 2; laden++) {
        sp_load load;
        sp_scene s = pushed("two-cubes", "offset", 0, 1, 0);
        memset(&load, 0, sizeof load);
        load.block = 1;
        load.mass = laden ? s.block[1].mass : 0;
        memcpy(load.point, s.block[1].centroid, sizeof load.point);
        s.joint[0].strength.mu = R(0.5);
        s.load = &load;
        s.count.loads = s.capacity.loads = 1;
        const sp_sliding_result r = slide(&s, &once);
        CHECK_NEAR(r.upper, 0.5, TOL(1e-6, 1e-2));
        if (TOL(1, 0)) CHECK_NEAR(r.lower, 0.5, 1e-5);
        CHECK_INT(r.lower_strong > 0, !laden && TOL(1, 0));
    }
}

/* A body on two slopes without friction, pushed up one of them, either way: there is no dilatancy to do without. */
TEST(a_body_without_friction_that_slides_was_not_found)
{
    static const sp_sliding_settings once = { 1, 90, 1 };
    for (int k = 0; k < 8; k++) {
        const double x = k & 1 ? -1 : 1, half = 1.57079632679489662, lean = 0.37 - 0.1 * (k / 2);
        const double at[2][2] = { { -x, -1 }, { x, -0.8 } }, angle[2] = { half - x * lean, half + x * (0.63 - 0.05 * (k / 2)) };
        const double q[3] = { x, 0.1, 0.05 * x };
        const sp_scene s = two_points(at, angle, 0, q);
        const sp_sliding_result r = slide(&s, &once);
        if (TOL(1, 0)) CHECK_INT(r.kind, SP_SLIDING_STATE);     /* float finds half of them */
        CHECK_NEAR(r.upper, r.associative, TOL(1e-6, 1e-2));
    }
}

#endif

TEST_LIST(laden)
#if !defined SP_NO_SLIDING && !defined SP_NO_IPM && !defined SP_NO_STRONG && !defined SP_EXACT_ONLY && !defined SP_QP_ONLY
    RUN(a_load_with_mass_takes_the_strong_side_away_and_no_other)
    RUN(a_body_without_friction_that_slides_was_not_found)
#endif
TEST_END
