/* The search for the bilateral force f0 that scales come of: its product, where it begins, where it ends, what it may take. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/forces.c"

#include <math.h>

#include "scale.h"

/* G x = W Aeq Aeq' W x: its product with any y is that of A' W x and A' W y, corner by corner; a held row is 0. */
TEST(the_normal_product_is_that_of_corner_forces)
{
    uint32_t draws = test_random() | 1;
    for (int trial = 0; trial < 20; trial++) {
        const sp_arena mark = test_arena;
        one_block o;
        sp_real x[2][24], g[24];
        double got = 0, want = 0, size = 0;
        NEED(chain(&o, &draws));
        o.scene.block[2].fixed = trial % 2 ? 5u : 0u;   /* along x and z */
        NEED(CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK));
        NEED(judge(&o, NULL));
        for (int k = 0; k < 48; k++) x[k / 24][k % 24] = R(test_draw(&draws, -1, 1));
        if (trial % 2) for (int k = 0; k < 2; k++) x[k][6] = x[k][8] = 0;
        for (int k = 0; k < 24; k++) g[k] = 7;
        o.j.sweeps = 0;
        sp__certifier_normal_product(&o.j, x[0], g);
        CHECK_INT(o.j.sweeps, 1);
        for (int k = 0; k < 24; k++) got += (double)g[k] * (double)x[1][k];
        for (int32_t v = 0; v < o.scene.count.points; v++) {
            double f[2][3] = { { 0 } }, arm[3], w[3], y[6];
            for (int32_t b = 1; b < 5; b++) {
                if (!arm_of(&o, b, v, arm)) continue;
                const double sign = v < o.scene.joint[b - 1].point + o.scene.joint[b - 1].points ? 1 : -1;
                for (int q = 0; q < 2; q++) {
                    for (int k = 0; k < 6; k++)
                        y[k] = (double)(x[q][6 * (b - 1) + k] * (k < 3 ? o.j.scale[b - 1].wf : o.j.scale[b - 1].wm));
                    cross(y + 3, arm, w);
                    for (int k = 0; k < 3; k++) f[q][k] += sign * (y[k] + w[k]);
                }
            }
            for (int k = 0; k < 3; k++) { want += f[0][k] * f[1][k]; size += fabs(f[0][k] * f[1][k]); }
        }
        CHECK_WITHIN(got, want, TOL(1e-11, 1e-4) * size);
        if (trial % 2) CHECK(!(g[6] < 0) && !(g[6] > 0) && !(g[8] < 0) && !(g[8] > 0));
        test_arena = mark;
    }
}

/* A residual that is no number ends the search for scales: one sweep, and the potential stays what it was. */
TEST(a_residual_that_is_no_number_moves_nothing)
{
    one_block o;
    sp_real to[6] = { 1, 2, 3, 4, 5, 6 };
    NEED(place(&o, 1, 1, 0.5, 0.1, 0.5));
    NEED(judge(&o, NULL));
    for (int k = 0; k < 6; k++) o.j.residual[k] = k == 2 ? R(NAN) : 1;
    o.j.sweeps = 0;
    sp__certifier_least_squares(&o.j, to);
    CHECK_INT(o.j.sweeps, 1);
    for (int k = 0; k < 6; k++) CHECK_NEAR(to[k], k + 1, 0);
}

/* Conjugate residuals from residual `first` with no more than so many sweeps.     returns how many it took */
static int32_t searched(one_block *o, const sp_real first[24], int32_t most, sp_real to[24])
{
    for (int r = 0; r < 24; r++) { o->j.residual[r] = first[r]; to[r] = 0; }
    o->j.sweeps = 0;
    o->j.sweeps_most = most;
    sp__certifier_least_squares(&o->j, to);
    return o->j.sweeps;
}

/* Every 102 steps of four blocks: where the residual is more than nine tenths of what it was, and what could lower it more than
 * half, the search ends, then first; it has lost nothing but to rounding. */
TEST(a_search_for_scales_ends_where_it_stalls_and_has_lost_nothing)
{
    int stalls = 0, goes_on = 0, worse = 0;
    uint32_t draws = 20261126;
    for (int k = 0; k < 40; k++) {
        const sp_arena mark = test_arena;
        one_block o;
        sp_real to[24], first[24], image[24], last_r = 0, last_g = 0;
        NEED(chain(&o, &draws));
        NEED(judge(&o, NULL));
        for (int i = 0; i < 4 && k % 2; i++) o.j.scale[i].wm *= R(pow(10, test_draw(&draws, -4, 4)));
        for (int r = 0; r < 24; r++) first[r] = R(test_draw(&draws, -1, 1));
        const int32_t sweeps = searched(&o, first, INT32_MAX, to);
        CHECK(sweeps <= 1 + 1000 + 24);
        goes_on += sweeps > 103;
        sp__certifier_normal_product(&o.j, to, image);
        for (int r = 0; r < 24; r++) image[r] -= first[r];
        const double was = sqrt((double)sp__dot(first, first, 24)), far = sqrt((double)sp__dot(to, to, 24));
        worse += k % 2 == 0 && !(sqrt((double)sp__dot(image, image, 24)) <= was + 1000 * (double)SP_EPSILON * (was + far));
        int stalled = 0;
        for (int32_t most = 1; most <= sweeps; most += 102) {       /* what the search sees at each of these places */
            CHECK_INT(searched(&o, first, most, to), most);
            const sp_real rr = sp__dot(o.j.residual, o.j.residual, 24), gg = sp__dot(o.j.image, o.j.image, 24);
            stalled = most > 1 && rr > (sp_real)0.9 * last_r && gg > last_g / 2;
            if (stalled) CHECK_INT(sweeps, most);
            stalls += stalled;
            last_r = rr;
            last_g = gg;
        }
        if (sweeps > 1 && sweeps % 102 == 1) CHECK(stalled);
        test_arena = mark;
    }
    CHECK_INT(worse, 0);
    TEST_PRINT("    %d stall, %d go on after the first look\n", stalls, goes_on);
    CHECK(goes_on > 0 && (stalls > 1 || TOL(0, 1)));
}

/* It ends at the first residual r that is 1e-9 of where it began, or that nothing lowers: |G r| <= 1e-14 |r|; in float 1e-4, 3e-6.
 * Neither knows units. */
TEST(a_search_for_scales_ends_as_soon_as_its_residual_is_small_or_least)
{
    const sp_real solved = R(TOL(1e-9, 1e-4)) * R(TOL(1e-9, 1e-4)), null = R(TOL(1e-14, 3e-6)) * R(TOL(1e-14, 3e-6));
    uint32_t draws = 20261127;
    int small = 0, least = 0;
    for (int k = 0; k < 60; k++) {
        const sp_arena mark = test_arena;
        const double size = k % 3 == 0 ? 1 : k % 3 == 1 ? 1e-3 : 1e3;
        one_block o;
        sp_real to[24], first[24];
        NEED(chain(&o, &draws));
        NEED(judge(&o, NULL));
        for (int r = 0; r < 24; r++) first[r] = R(size * test_draw(&draws, -1, 1));
        if (k % 2) {                                    /* what G makes of a motion can be undone, of others a part is left */
            sp__certifier_normal_product(&o.j, first, to);
            memcpy(first, to, sizeof first);
        }
        const sp_real start = sp__dot(first, first, 24);
        const int32_t sweeps = searched(&o, first, INT32_MAX, to);
        if (sweeps > 2 && sweeps % 102 != 1 && sweeps < 1025)
            for (int before = 0; before < 2; before++) {        /* at the end, and a step before it */
                searched(&o, first, sweeps - before, to);
                const sp_real rr = sp__dot(o.j.residual, o.j.residual, 24), gg = sp__dot(o.j.image, o.j.image, 24);
                CHECK_INT(rr <= solved * start || gg <= null * rr, !before);
                small += !before && rr <= solved * start;
                least += !before && gg <= null * rr;
            }
        test_arena = mark;
    }
    TEST_PRINT("    %d small, %d least\n", small, least);
    CHECK(small > 0 && least > 0);
}

/* Sweeps that f0 takes with no hint: looked at, solved for, then corrected up to twice. A look is a sweep, and from the second on
 * one more for whether anything lowers what is left, the fourth time up to rounding; neither a look nor a search begins with
 * fewer than two sweeps left.     returns whether it settled */
static int looked_and_searched(one_block *o, int32_t most)
{
    sp__certifier *j = &o->j;
    j->sweeps = 0;
    j->sweeps_most = most;
    for (int r = 0; r < 24; r++) j->dual.potential[r] = j->correction[r] = 0;
    for (int look = 1; look <= 4 && most - j->sweeps >= 2; look++) {
        if (sp__certifier_sums(j) == 0) return 1;
        sp__certifier_scale_rows(j, j->residual);
        if (look > 1 && sp__certifier_is_optimal(j, look == 4)) return 1;
        if (look == 4 || most - j->sweeps < 2) return 0;
        for (int r = 0; r < 24; r++) j->residual[r] *= -1;
        sp__certifier_least_squares(j, look == 1 ? j->dual.potential : j->correction);
    }
    return 0;
}

TEST(f0_is_looked_at_four_times_and_searched_for_three)
{
    uint32_t draws = 20261128;
    int settled = 0, open = 0, corrected = 0;
    for (int k = 0; k < SOME_OF(120, 40); k++) {
        const sp_arena mark = test_arena;
        one_block o;
        sp_real potential[24], correction[24];
        NEED(chain(&o, &draws));
        NEED(judge(&o, NULL));
        const int32_t all = o.j.sweeps;
        for (int32_t most = 2; most < 64; most += most < 12 ? 1 : all > 40 ? all / 6 : 7) {
            for (int r = 0; r < 24; r++) o.j.dual.potential[r] = o.j.correction[r] = 7;
            o.j.sweeps = 0;
            o.j.sweeps_most = most < 52 ? most : INT32_MAX;
            const int got = sp__certifier_bilateral(&o.j, NULL);
            const int32_t sweeps = o.j.sweeps;
            memcpy(potential, o.j.dual.potential, sizeof potential);
            memcpy(correction, o.j.correction, sizeof correction);
            CHECK_INT(looked_and_searched(&o, o.j.sweeps_most), got);
            CHECK_INT(o.j.sweeps, sweeps);
            CHECK_INT(memcmp(potential, o.j.dual.potential, sizeof potential), 0);
            CHECK_INT(memcmp(correction, o.j.correction, sizeof correction), 0);
            settled += got;
            open += !got;
            for (int r = 0; r < 24; r++) corrected += correction[r] < 0 || correction[r] > 0;
        }
        test_arena = mark;
    }
    TEST_PRINT("    %d settled, %d open, %d corrected\n", settled, open, corrected);
    CHECK(settled > 0 && open > 0 && corrected > 0);
}

/* 2^e, the same to the bit on every target: what comes of these weights depends on it. */
static sp_real two_to(int e)
{
    sp_real x = 1;
    for (; e > 0; e--) x *= 2;
    for (; e < 0; e++) x /= 2;
    return x;
}

/* Where weights are 1e10 apart the search goes on until it has taken 1000 steps and one for each row. */
TEST(a_search_for_scales_ends_after_a_thousand_steps_and_one_for_each_row)
{
    static const uint32_t first[] = { TOL(242, 5392), TOL(742, 7266), TOL(1762, 10470) };
    int most = 0;
    for (size_t k = 0; k < sizeof first / sizeof first[0]; k++) {
        const sp_arena mark = test_arena;
        uint32_t draws = first[k];
        one_block o;
        sp_real to[24];
        NEED(chain(&o, &draws));
        NEED(judge(&o, NULL));
        for (int i = 0; i < 4; i++) {
            o.j.scale[i].wf *= two_to((int)test_draw(&draws, -17, 17));
            o.j.scale[i].wm *= two_to((int)test_draw(&draws, -17, 17));
        }
        for (int r = 0; r < 24; r++) { o.j.residual[r] = R(test_draw(&draws, -1, 1)); to[r] = 0; }
        o.j.sweeps = 0;
        sp__certifier_least_squares(&o.j, to);
        most = o.j.sweeps > most ? o.j.sweeps : most;
        test_arena = mark;
    }
    CHECK_INT(most, 1 + 1000 + 24);
}

/* Where products leave the range of numbers the search ends before its first step. */
TEST(a_search_for_scales_whose_products_overflow_takes_no_step)
{
    one_block o;
    sp_real to[6] = { 1, 2, 3, 4, 5, 6 };
    NEED(place(&o, 1, 1, 0.5, 0.1, 0.5));
    NEED(judge(&o, NULL));
    o.j.scale[0].wf = o.j.scale[0].wm = R(TOL(1e160, 1e20));
    for (int k = 0; k < 6; k++) o.j.residual[k] = R(k % 2 ? -1 : 1);
    o.j.residual[1] = R(1e-3);                          /* so small that its own row has the other sign: inf - inf */
    o.j.residual[3] = R(1e-3);
    o.j.sweeps = 0;
    sp__certifier_least_squares(&o.j, to);
    CHECK_INT(o.j.sweeps, 1);
    for (int k = 0; k < 6; k++) CHECK_NEAR(to[k], k + 1, 0);
}

/* No step lowers a residual r where |G r| <= 1e-14 |r|, in float 3e-6; at the last, where it is 64 u times weighted loads and
 * forces. */
TEST(a_residual_is_the_least_up_to_its_allowance)
{
    uint32_t draws = test_random() | 1;
    for (int trial = 0; trial < 40; trial++) {
        const sp_arena mark = test_arena;
        const int within = trial % 2, last = trial / 2 % 2;
        const double small = trial % 8 > 3 ? 0.64 * (double)SP_EPSILON : 1;         /* as of loads of next to nothing */
        one_block o;
        double rr = 0, gg = 0, sum = 0;
        NEED(chain(&o, &draws));
        NEED(judge(&o, NULL));
        for (int k = 0; k < 24; k++) o.j.residual[k] = R(small * test_draw(&draws, -1, 1));
        sp__certifier_normal_product(&o.j, o.j.residual, o.j.image);
        for (int k = 0; k < 24; k++) {
            rr += (double)o.j.residual[k] * (double)o.j.residual[k];
            gg += (double)o.j.image[k] * (double)o.j.image[k];
        }
        const double off = 1 + (within ? -1 : 1) * TOL(1e-6, 1e-3);
        if (last) {
            for (int i = 0; i < 4; i++) {
                sp__scale *s = &o.j.scale[i];
                s->load = R(test_draw(&draws, 1, 2)); s->sum_f0 = R(test_draw(&draws, 1, 2));
                s->couple = R(test_draw(&draws, 1, 2)); s->sum_m0 = R(test_draw(&draws, 1, 2));
                const double f = (double)(s->wf * (s->load + s->sum_f0)), m = (double)(s->wm * (s->couple + s->sum_m0));
                sum += f * f + m * m;
            }
            const double c = sqrt(gg / (off * off) / sum) / (64 * (double)SP_EPSILON);
            for (int i = 0; i < 4; i++) {
                sp__scale *s = &o.j.scale[i];
                s->load *= R(c); s->sum_f0 *= R(c); s->couple *= R(c); s->sum_m0 *= R(c);
            }
            CHECK_INT(sp__certifier_is_optimal(&o.j, 0), 0);
        } else {
            const double c = sqrt(TOL(1e-14, 3e-6) * off * sqrt(rr / gg));    /* G goes with the square of its weights */
            for (int i = 0; i < 4; i++) {
                sp__scale *s = &o.j.scale[i];
                s->wf *= R(c); s->wm *= R(c);
                s->load = s->sum_f0 = s->couple = s->sum_m0 = 0;
            }
        }
        if (SP__HAS_STRENGTH || !last) CHECK_INT(sp__certifier_is_optimal(&o.j, last), within);
        test_arena = mark;
    }
}

/* What comes of a search, given as a hint, is taken after one sweep; a search takes no more sweeps than it is given. */
TEST(a_hint_that_is_right_takes_one_sweep_and_no_search_more_than_it_may)
{
    one_block o;
    sp_real y0[12];
    NEED(place(&o, 5, 1, 0.5, 0.3, 0.5));
    NEED(judge(&o, NULL));
    const int32_t own = o.j.sweeps;
    const sp__scale want = o.j.scale[0];
    CHECK(own > 2);
    for (int k = 0; k < 6; k++) {
        const sp_real w = k < 3 ? want.wf : want.wm;
        y0[k] = o.j.dual.potential[k] * w * o.j.unit;
        y0[6 + k] = o.j.correction[k] * w * o.j.unit;
    }
    NEED(judge(&o, y0));
    CHECK_INT(o.j.sweeps, 1);
    CHECK_NEAR(o.j.scale[0].s, want.s, TOL(1e-12, 1e-5));
    CHECK_NEAR(o.j.scale[0].S, want.S, TOL(1e-12, 1e-5));
    for (int32_t most = 2; most < own + 3; most++) {
        NEED(CHECK(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, most, &test_arena)));
        CHECK(o.j.sweeps <= most);
        CHECK_INT(o.j.sweeps == own, most > own);       /* two must be left for another look */
        CHECK_INT(o.j.scale[0].known > 0, most > own);
    }
}

#ifndef SP_SMALL
/* A sweep is counted with 90 flops a corner, eight are kept for what comes after the scales, and two are had in any case. */
TEST(a_budget_gives_scales_the_sweeps_it_has)
{
    one_block o;
    NEED(place(&o, 1, 1, 0.5, 0, 0.5));
    CHECK_INT(sp__budget_sweeps(&o.set, &o.pb, 0), INT32_MAX);          /* no budget */
    o.set.budget = 1;
    CHECK_INT(sp__budget_sweeps(&o.set, &o.pb, 20 * 4 * 90), 12);
    CHECK_INT(sp__budget_sweeps(&o.set, &o.pb, 11 * 4 * 90 - 1), 2);
    CHECK_INT(sp__budget_sweeps(&o.set, &o.pb, 11 * 4 * 90), 3);
    CHECK_INT(sp__budget_sweeps(&o.set, &o.pb, -1000000), 2);
    CHECK_INT(sp__budget_sweeps(&o.set, &o.pb, INT64_MAX), INT32_MAX);
    o.pb.points = 0;
    CHECK_INT(sp__budget_sweeps(&o.set, &o.pb, 0), INT32_MAX);          /* nothing touches */
}
#endif

TEST_LIST(search)
    RUN(the_normal_product_is_that_of_corner_forces)
    RUN(a_residual_that_is_no_number_moves_nothing)
    RUN(a_search_for_scales_ends_where_it_stalls_and_has_lost_nothing)
    RUN(a_search_for_scales_ends_as_soon_as_its_residual_is_small_or_least)
    RUN(f0_is_looked_at_four_times_and_searched_for_three)
    RUN(a_search_for_scales_ends_after_a_thousand_steps_and_one_for_each_row)
    RUN(a_search_for_scales_whose_products_overflow_takes_no_step)
    RUN(a_residual_is_the_least_up_to_its_allowance)
    RUN(a_hint_that_is_right_takes_one_sweep_and_no_search_more_than_it_may)
#ifndef SP_SMALL
    RUN(a_budget_gives_scales_the_sweeps_it_has)
#endif
TEST_END
