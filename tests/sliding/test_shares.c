/* What the descent allows of the forces at a corner, by the motion at hand. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/sliding/descend.c"

#if SP__WITH_SLIDING

/* A corner of friction mu whose motion opens and slips by so much. Its force is along both edges of the cone, where it stays
 * shut along the one against its slip; without friction they are one, whichever way it slips. */
TEST(a_corner_may_press_where_it_is_shut_and_rub_where_it_is_rough)
{
    static const struct { double mu, open, slip; int moves, press, rub; } row[] = {
        { 0.5, 0, 0, 0, 1, 1 }, { 0, 0, 0, 0, 1, 0 }, { 0.5, 0, 0, 1, 1, 1 }, { 0.5, 0, 1, 1, 0, 1 }, { 0.5, 0, -1, 1, 1, 0 },
        { 0.5, 1, 1, 1, 0, 0 }, { 0, 0, -1, 1, 1, 0 }, { 0, 0, 1, 1, 1, 0 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        sp__slab_corner corner;
        sp__slab w;
        sp__descend s;
        int32_t at[4] = { -1, -1, -1, -1 };
        sp_real lower[4], upper[4], x[4] = { 5, 5, 5, 5 }, m[3] = { R(row[k].slip), R(row[k].open), 0 };
        memset(&corner, 0, sizeof corner);
        memset(&w, 0, sizeof w);
        memset(&s, 0, sizeof s);
        corner.row[0] = 0;
        corner.row[1] = -1;
        corner.mu = R(row[k].mu);
        corner.n[1] = corner.t[0] = 1;
        w.corners = 1;
        w.corner = &corner;
        s.w = &w;
        s.force.lower = lower;
        s.force.upper = upper;
        s.force.at = at;
        s.force.x = x;
        sp__descend_allow(&s, row[k].moves ? m : NULL, R(1e-6));
        CHECK_INT(upper[0] > 0, row[k].press);
        CHECK_INT(upper[1] > 0, row[k].rub);
        for (int q = 0; q < 2; q++) CHECK_WITHIN(lower[q], 0, 0);
    }
}

#endif

TEST_LIST(shares)
#if SP__WITH_SLIDING
    RUN(a_corner_may_press_where_it_is_shut_and_rub_where_it_is_rough)
#endif
TEST_END
