/* The alternation from the inside: which corners count, and the program of the motion, of the specification and with our terms.
 *                                                                                                      [seed 3.2, 3.3] */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/coupled/alternate.c"

#include <math.h>

#if SP__WITH_COUPLED && SP__WITH_ADMM

enum { POINTS = 4 };

/* One free block, four corners; fn and ft of each. Engaged is what exceeds 1 in fn, a hundredth of 100; sliding what does so in
 * ft. */
static const double pressed[POINTS][3] = { { 100, 0, 0 }, { 0.5, 1.5, 0 }, { 2, 0, 0.5 }, { 5, -2, 1.5 } };

static sp_problem pb;
static sp_settings set;
static sp__cra search;
static sp__alt alt;

static void start(sp_real weak)
{
    memset(&pb, 0, sizeof pb);
    memset(&set, 0, sizeof set);
    memset(&search, 0, sizeof search);
    memset(&alt, 0, sizeof alt);
    pb.blocks = 1;
    pb.points = POINTS;
    set.coupled.box = !(weak > 0);
    search.pb = &pb;
    search.set = &set;
    search.k.eps = 1;
    search.k.eta = 100;
    alt.c = &search;
    alt.seed = sp_seed_table();
    sp__alt_carve(&alt, &pb, &test_arena);
    memset(alt.pin, 0, POINTS * sizeof *alt.pin);
    for (int v = 0; v < POINTS; v++) for (int k = 0; k < 3; k++) alt.f[v][k] = R(pressed[v][k]);
    sp__alt_terms(&alt, weak);
    CHECK_INT(sp__alt_engage(&alt), 3);
}

/* E: 0, 2 and 3; F: 1, which presses too little to be in E, and 3. With our terms F is a part of E. */
TEST(friction_counts_wherever_a_corner_slides_engaged_or_not)
{
    for (int ours = 0; ours < 2; ours++) {
        start(ours ? SP__ALT_WEAK : 0);
        const double weight[POINTS] = { 1, 0, sqrt(0.02), sqrt(0.05) };
        const double h[POINTS][2] = { { 0, 0 }, { ours ? 0 : 1, 0 }, { 0, 0 }, { -0.8, 0.6 } };
        for (int v = 0; v < POINTS; v++) {
            CHECK_NEAR(alt.weight[v], weight[v], 4 * (double)SP_EPSILON);
            for (int k = 0; k < 2; k++) CHECK_WITHIN(alt.h[v][k], h[v][k], 4 * (double)SP_EPSILON);
        }
    }
}

static sp__explain motion(void)
{
    sp__explain g;
    memset(&g, 0, sizeof g);
    sp__explain_size(&pb, &g.qp);
    sp__explain_carve(&g, &pb, 0, &test_arena);
    sp__explain_cost(&g, &pb, &alt);
    sp__explain_bounds(&g, &pb, &alt);
    return g;
}

/* sum w^2 (dn + eps)^2 + sum |dt + beta h|^2, nothing else but reg: of x = (dq, dd, beta) the diagonal of P, and q. */
TEST(the_seeds_motion_has_no_term_of_ours)
{
    static const double w2[POINTS] = { 1, 0, 0.02, 0.05 }, rubs[POINTS] = { 0, 1, 0, 1 };
    const double near = 8 * (double)SP_EPSILON, reg = (double)sp_seed_table()->reg;
    start(0);
    const sp__explain g = motion();
    for (int j = 0; j < 6; j++) CHECK_NEAR(g.Px[g.Pp[j + 1] - 1], reg, near);
    for (int v = 0; v < POINTS; v++) {
        const int d = 6 + 3 * v, beta = 6 + 3 * POINTS + v;
        CHECK_WITHIN(g.Px[g.Pp[d + 1] - 1], w2[v], near);
        CHECK_WITHIN(g.q[d], w2[v], near);
        for (int k = 1; k < 3; k++) CHECK_WITHIN(g.Px[g.Pp[d + k + 1] - 1], rubs[v], near);
        CHECK_WITHIN(g.Px[g.Pp[beta + 1] - 1], rubs[v] > 0 ? 1 + reg : reg, near);
        CHECK_WITHIN(g.q[beta], 0, 0);
    }
    start(SP__ALT_WEAK);
    const sp__explain ours = motion();
    CHECK_NEAR(ours.q[6 + 3 * POINTS], -(double)SP__ALT_WEAK, near);            /* beta is drawn to a slip */
    CHECK_NEAR(ours.Px[ours.Pp[6 + 3 + 1] - 1], (double)SP__ALT_WEAK, near);    /* a corner that hardly presses to close */
}

/* dn >= -eps, no component of dd beyond eta, beta >= 0; ours keeps the square inside |dt| <= eta, and some slip. */
TEST(the_seeds_motion_is_bounded_by_eta_in_each_component)
{
    start(0);
    const sp__explain g = motion();
    for (int i = 3 * POINTS; i < 6 * POINTS; i++) {
        CHECK_NEAR(g.l[i], i % 3 ? -100 : -1, 0);
        CHECK_NEAR(g.u[i], 100, 0);
    }
    for (int i = 6 * POINTS; i < 7 * POINTS; i++) CHECK(!(g.l[i] < 0) && !(g.l[i] > 0) && !(g.u[i] < SP_QP_INFINITY));
    start(SP__ALT_WEAK);
    const sp__explain ours = motion();
    CHECK(ours.u[3 * POINTS + 1] < R(100 / sqrt(2.)) && ours.l[6 * POINTS] > 0);
}

TEST_LIST(alternate)
    RUN(friction_counts_wherever_a_corner_slides_engaged_or_not)
    RUN(the_seeds_motion_has_no_term_of_ours)
    RUN(the_seeds_motion_is_bounded_by_eta_in_each_component)
TEST_END

#else

TEST_LIST(alternate)
TEST_END

#endif
