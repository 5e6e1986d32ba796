/* How a joint moves in a collapse, by the formulas of joints.c: how little is rest, where sliding ends, what stays in touch. */
#include "../test.h"

#include <math.h>

#if !defined SP_NO_IPM && !defined SP_EXACT_ONLY && !defined SP_QP_ONLY

#define PLAY TOL(1e-6, 1e-3)

static sp_scene s;

/* Two blocks on either side of a square of 1 m in z = 0, centroids above and below its middle; all its corners have one arm. */
static void pair(void)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 0 };
    const sp_real foot[12] = { R(-0.5), R(-0.5), 0, R(0.5), R(-0.5), 0, R(0.5), R(0.5), 0, R(-0.5), R(0.5), 0 };
    const sp_real below[3] = { 0, 0, R(-0.7) }, above[3] = { 0, 0, R(0.5) };
    const sp_strength k = { R(0.5), 0, 0, 0 };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 10, below, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, 10, above, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &k, NULL), SP_OK);
}

static double size(const sp_real *x)
{
    return sqrt((double)x[0] * (double)x[0] + (double)x[1] * (double)x[1] + (double)x[2] * (double)x[2]);
}

/* Both turn and go alike but for d, by which the upper one goes farther.        returns what counts as rest then: play of
 * |u| + (1 + |w|) |arm| of either block */
static double together(sp_real dq[12], const double u[3], const double w[3], const double d[3], double most)
{
    const double apart = 1.2;                           /* of the centroids, along z: the upper one is w x apart ahead */
    for (int k = 0; k < 3; k++) {
        dq[k] = R(u[k]);
        dq[3 + k] = dq[9 + k] = R(w[k]);
        dq[6 + k] = R(u[k] + (k == 0 ? w[1] * apart : k == 1 ? -w[0] * apart : 0) + d[k] * most);
    }
    return PLAY * (size(dq) + size(dq + 6) + (1 + size(dq + 3)) * (sqrt(0.5 + 0.49) + sqrt(0.5 + 0.25)));
}

static sp_joint_motion moved(const double u[3], const double w[3], const double d[3], double most)
{
    sp_real dq[12];
    sp_joint_motion m;
    together(dq, u, w, d, most);
    CHECK_INT(sp_joint_moves(&s, dq, 0, &m), SP_OK);
    return m;
}

static const double STILL[3] = { 0, 0, 0 };

/* In double: in float rounding of large motions is as large as the play. */
TEST(what_moves_less_than_play_is_at_rest)
{
    static const double u[3][3] = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 2, -5 } }, w[3][3] = { { 0, 0, 0 }, { 0, 0, 4 }, { 3, -1, 2 } };
    static const double d[4][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0.6, 0.8, 0 }, { 0, 0, 1 } };
    pair();
    for (int k = 0; k < 36 && sizeof(sp_real) > 4; k++) {
        sp_real dq[12];
        const double *go = u[k % 3], *turn = w[k / 3 % 3], *to = d[k / 9], rest = together(dq, go, turn, to, 0);
        sp_joint_motion m = moved(go, turn, to, R(0.99) * rest);
        CHECK_INT(m.kind, SP_JOINT_RIGID);
        CHECK_NEAR(m.b[0] - m.a[0], 1, 1e-12);          /* a diagonal is in touch */
        CHECK_NEAR(m.b[1] - m.a[1], 1, 1e-12);
        m = moved(go, turn, to, 1.01 * rest);
        CHECK_INT(m.kind, k / 9 == 3 ? SP_JOINT_OPEN : SP_JOINT_SLIDING);
    }
}

TEST(sliding_ends_where_a_corner_opens_by_more_than_friction_rises_and_play)
{
    static const double along[3][2] = { { 1, 0 }, { 0, 1 }, { 0.6, -0.8 } };
    pair();
    for (int k = 0; k < 3; k++)
        for (int tiny = 0; tiny < 2; tiny++) {
            const double slip = tiny ? 4 * PLAY : 1;
            double d[3] = { along[k][0] * slip, along[k][1] * slip, 0.5 * slip * 1.001 };
            sp_real dq[12];
            const double rest = together(dq, STILL, STILL, d, 1);
            for (int more = 0; more < 2; more++) {
                d[2] = 0.5 * slip * 1.001 + (more ? 1.02 : 0.98) * rest;
                sp_joint_motion m = moved(STILL, STILL, d, 1);
                CHECK_INT(m.kind, more ? SP_JOINT_OPEN : SP_JOINT_SLIDING);
                CHECK_WITHIN(m.opening, d[2], TOL(1e-12, 1e-6));
                CHECK_WITHIN(m.slip, slip, TOL(1e-12, 1e-6));
                for (int e = 0; e < 3; e++) {           /* of what is open nothing stays in touch */
                    CHECK_NEAR(m.a[e], more ? 0 : e < 2 ? -0.5 : 0, TOL(1e-12, 1e-6));
                    CHECK_NEAR(m.b[e], more ? 0 : e < 2 ? 0.5 : 0, TOL(1e-12, 1e-6));
                }
            }
        }
}

/* About its edges x = 1/2 and y = -1/2. */
TEST(an_edge_that_stays_in_touch_is_a_hinge)
{
    pair();
    for (int k = 0; k < 2; k++) {
        const double turn = 0.01;
        sp_real dq[12] = { 0 };
        sp_joint_motion m;
        dq[9 + k] = R(turn);                            /* w x (centroid - edge) */
        dq[6] = k ? R(turn * 0.5) : 0;
        dq[7] = k ? 0 : R(-turn * 0.5);
        dq[8] = R(turn * 0.5);
        CHECK_INT(sp_joint_moves(&s, dq, 0, &m), SP_OK);
        CHECK_INT(m.kind, SP_JOINT_HINGE);
        CHECK_WITHIN(m.opening, turn, TOL(1e-9, 1e-4));
        CHECK_NEAR(m.slip, 0, TOL(1e-12, 1e-6));
        CHECK_NEAR(m.a[!k], k ? 0.5 : -0.5, TOL(1e-12, 1e-6));
        CHECK_NEAR(m.b[!k], k ? 0.5 : -0.5, TOL(1e-12, 1e-6));
        CHECK_NEAR(m.b[k] - m.a[k], 1, TOL(1e-12, 1e-6));
    }
}

/* A support rests wherever its centroid is said to be: what is small is so beside the block that moves alone. */
TEST(how_far_a_support_lies_away_is_no_matter)
{
    for (int side = 0; side < 2; side++)
        for (int far = 0; far < 2; far++) {
            sp_real dq[12] = { 0 };
            sp_joint_motion m;
            pair();
            s.block[side].fixed = SP_FIXED;
            s.block[side].centroid[0] = R(far ? 4.5e6 : 0);
            s.block[side].centroid[2] = R(far ? -5e6 : -0.7);
            dq[6 * !side + 4] = R(0.01);                /* about its edge x = 1/2 */
            dq[6 * !side] = R(0.01) * s.block[!side].centroid[2];
            dq[6 * !side + 2] = R(0.005);
            CHECK_INT(sp_joint_moves(&s, dq, 0, &m), SP_OK);
            CHECK_INT(m.kind, side ? SP_JOINT_SLIDING : SP_JOINT_HINGE);
            CHECK_WITHIN(m.opening, side ? 0 : 0.01, TOL(1e-9, 1e-6));
        }
}

/* About an axis through the corner (1/2, 1/2), across the diagonal: the three others open. */
TEST(a_corner_that_stays_in_touch_is_both_ends_of_its_hinge)
{
    const double turn = 0.01;
    sp_real dq[12] = { 0 };
    sp_joint_motion m;
    pair();
    const sp_real *at = s.block[1].centroid;
    const double arm[3] = { (double)at[0] - 0.5, (double)at[1] - 0.5, (double)at[2] };
    dq[9] = R(-turn);
    dq[10] = R(turn);
    dq[6] = R(turn * arm[2]);                           /* w x (centroid - corner) */
    dq[7] = R(turn * arm[2]);
    dq[8] = R(-turn * (arm[0] + arm[1]));
    CHECK_INT(sp_joint_moves(&s, dq, 0, &m), SP_OK);
    CHECK_INT(m.kind, SP_JOINT_HINGE);
    CHECK_WITHIN(m.opening, 2 * turn, TOL(1e-9, 1e-6));
    for (int e = 0; e < 2; e++) {
        CHECK_NEAR(m.a[e], 0.5, TOL(1e-12, 1e-6));
        CHECK_NEAR(m.b[e], 0.5, TOL(1e-12, 1e-6));
    }
}

/* What is play is measured by the block that moves: its corners' distance from its centroid. */
TEST(a_support_adds_no_play)
{
    for (int more = 0; more < 2 && sizeof(sp_real) > 4; more++) {
        sp_real dq[12] = { 0 };
        sp_joint_motion m;
        pair();
        s.block[0].fixed = SP_FIXED;
        dq[6] = R(PLAY * sqrt(0.5 + 0.25) * (more ? 1.01 : 0.99));
        CHECK_INT(sp_joint_moves(&s, dq, 0, &m), SP_OK);
        CHECK_INT(m.kind, more ? SP_JOINT_SLIDING : SP_JOINT_RIGID);
    }
}

#endif

TEST_LIST(moves)
#if !defined SP_NO_IPM && !defined SP_EXACT_ONLY && !defined SP_QP_ONLY
    RUN(what_moves_less_than_play_is_at_rest)
    RUN(sliding_ends_where_a_corner_opens_by_more_than_friction_rises_and_play)
    RUN(an_edge_that_stays_in_touch_is_a_hinge)
    RUN(how_far_a_support_lies_away_is_no_matter)
    RUN(a_corner_that_stays_in_touch_is_both_ends_of_its_hinge)
    RUN(a_support_adds_no_play)
#endif
TEST_END
