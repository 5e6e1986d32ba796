/* A load that has mass, which turns with no block: what even friction holds at rest is not proved to stay there. */
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

#endif

TEST_LIST(laden)
#if !defined SP_NO_SLIDING && !defined SP_NO_IPM && !defined SP_NO_STRONG && !defined SP_EXACT_ONLY && !defined SP_QP_ONLY
    RUN(a_load_with_mass_takes_the_strong_side_away_and_no_other)
#endif
TEST_END
