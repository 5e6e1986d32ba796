/* Scenes made to mislead by their shape: points, edges, many corners, needles, any weight and gravity, what floats. */
#include "attack.h"

/* ----------------------------------------------------------------------------------------------- degenerate contacts */

TEST(a_block_on_a_point_stands_above_it_only)
{
    for (int k = 0; k < 5; k++) {
        static const double off[] = { 0, TOL(1e-6, 1e-2), 0.1, -0.3, 5 };
        sp_scene s;
        const sp_real n[3] = { 0, 0, R(3) }, x[3] = { 0, 0, 0 };
        const sp_strength strength = sp_strength_friction(R(0.5));
        start(&s, 2, 1, 1);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        body(&s, 2, off[k], 0, 1, 0);
        CHECK_INT(sp_scene_points(&s, 0, 1, n, 1, x, &strength, NULL), SP_OK);
        verdict_is(&s, k ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

TEST(a_block_on_an_edge_stands_above_it_only)
{
    static const double at[][2] = { { 0, 0 }, { 0.9, 0 }, { 1.1, 0 }, { 0, TOL(1e-6, 1e-2) }, { 0.5, -0.2 } };
    for (int k = 0; k < 5; k++) {
        sp_scene s;
        const sp_real n[3] = { 0, 0, 1 }, x[6] = { -1, 0, 0, 1, 0, 0 };
        const sp_strength strength = sp_strength_friction(R(0.5));
        start(&s, 2, 1, 2);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        body(&s, 2, at[k][0], at[k][1], 1, 0);
        CHECK_INT(sp_scene_points(&s, 0, 1, n, 2, x, &strength, NULL), SP_OK);
        verdict_is(&s, k < 2 ? SP_STABLE : SP_UNSTABLE, 1);
    }
}

/* A table on three legs, each a point: stands above their triangle only. */
TEST(three_points_carry_what_is_above_their_triangle)
{
    static const double at[][2] = { { 0, 0 }, { 0.99, 0 }, { 1.01, 0 }, { -0.51, 0 }, { -0.49, 0 } };
    for (int k = 0; k < 5; k++) {
        sp_scene s;
        const sp_real n[3] = { 0, 0, 1 };
        const sp_strength strength = sp_strength_friction(R(0.5));
        start(&s, 2, 3, 3);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        body(&s, 2, at[k][0], at[k][1], 1, 0);
        for (int leg = 0; leg < 3; leg++) {
            const sp_real x[3] = { R(leg ? -0.5 : 1), R(leg == 1 ? 1 : leg == 2 ? -1 : 0), 0 };
            CHECK_INT(sp_scene_points(&s, 0, 1, n, 1, x, &strength, NULL), SP_OK);
        }
        verdict_is(&s, k == 2 || k == 3 ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

/* A round block of radius 1 with n corners, height 2 h, in a world tilted along its first corner's middle; `times` joints. */
static void column(sp_scene *s, int32_t n, int32_t times, double h, double mu, double tilt)
{
    static sp_real x[3 * 512];
    const sp_strength strength = sp_strength_friction(R(mu));
    start(s, 2, times, n * times);
    body(s, 0, 0, 0, -1, SP_FIXED);
    body(s, 1, 0, 0, h, 0);
    for (int32_t k = 0; k < n; k++) {
        const double a = 6.283185307179586 * (k + 0.5) / n;
        x[3 * k] = R(cos(a));
        x[3 * k + 1] = R(sin(a));
        x[3 * k + 2] = 0;
    }
    for (int32_t k = 0; k < times; k++) CHECK_INT(sp_scene_joint(s, 0, 1, n, x, &strength, NULL), SP_OK);
    gen_gravity(tilt, 0, s->gravity);
}

/* Near the limit never wrong, a little off it decided. */
TEST(many_corners_and_repeated_joints_slide_and_topple_as_one)
{
    static const int32_t corners[] = { 3, 4, 7, 64, 512 };
    const double deg = 57.295779513082320877;
    for (size_t k = 0; k < sizeof corners / sizeof corners[0]; k++)
        for (int32_t times = 1; times <= (corners[k] < 100 ? 5 : 1); times += 4)
            for (int m = -2; m <= 2; m++) {
                const int32_t n = corners[k];
                const int far = (m == -2 || m == 2) && n < 100;
                const double margin = (m < 0 ? -1 : 1) * (far ? TOL(1e-5, 5e-2) : TOL(1e-6, 1e-2));
                const double edge = cos(6.283185307179586 / 2 / n);         /* from the middle to the edge across +x */
                sp_scene s;
                if (!m) continue;
                column(&s, n, times, 0.3, 0.5 * (1 + margin), atan(0.5) * deg);
                if (!verdict_is(&s, m < 0 ? SP_UNSTABLE : SP_STABLE, far)) TEST_PRINT("    sliding, margin %g\n", margin);
                column(&s, n, times, 2 * edge, 10, atan(0.5 * (1 + margin)) * deg);
                s.gravity[0] = R(fabs((double)s.gravity[0]));
                if (!verdict_is(&s, m < 0 ? SP_STABLE : SP_UNSTABLE, far))
                    TEST_PRINT("    %d corners, %d times, margin %g\n", (int)n, (int)times, margin);
            }
}

/* Corners on straight edges add nothing. */
TEST(collinear_corners_change_nothing)
{
    static const sp_real x[] = { -1, -1, 0, 0, -1, 0, R(0.5), -1, 0, 1, -1, 0, 1, R(0.1), 0, 1, 1, 0, -1, 1, 0, -1, 0, 0 };
    static const double at[] = { 0, 0.999, 1.001 };
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        const sp_strength strength = sp_strength_friction(R(0.5));
        start(&s, 2, 1, 8);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        body(&s, 1, at[k], 0, 1, 0);
        CHECK_INT(sp_scene_joint(&s, 0, 1, 8, x, &strength, NULL), SP_OK);
        verdict_is(&s, k == 2 ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

/* Needles standing, plates lying, from b / h = 1e-4 to 1e4; tol is of the height, so a needle's limit is known that well. */
TEST(needles_and_plates_topple_where_they_should)
{
    static const double base[] = { 1e-4, 1e-2, 1, 1e2, 1e4 };
    for (size_t k = TOL(0, 1); k < TOL(5, 4); k++)
        for (size_t j = TOL(0, 1); j < TOL(5, 4); j++)
            for (int m = -2; m <= 2; m++) {             /* near the limit never wrong, well off it decided */
                const double unit = (base[k] < 1 ? 1 / base[k] : 1) * (base[j] > 1 ? base[j] : 1);
                const double hides = TOL(4e-9, 0) * base[k];        /* in tol of a load that is nearly all sideways */
                const double margin = (m == -2 || m == 2 ? TOL(1e-4, 0.1) : TOL(1e-6, 2e-2)) * unit + hides;
                const int side = m < 0 ? -1 : 1;
                sp_scene s;
                if (!m || margin > 0.9) continue;
                start(&s, 2, 1, 4);
                body(&s, 0, 0, 0, -1, SP_FIXED);
                body(&s, 1, 0, 0, 1, 0);
                bed(&s, 0, 1, 0, 0, 0, base[k], base[j], 1e5);
                s.gravity[0] = R(9.80665 * base[k] * (1 + side * margin));
                const int sure = (m == -2 || m == 2) && base[k] < TOL(1e3, 10);
                if (!verdict_is(&s, side < 0 ? SP_STABLE : SP_UNSTABLE, sure))
                    TEST_PRINT("    base %g by %g, margin %g\n", base[k], base[j], side * margin);
            }
}

TEST(friction_from_nothing_to_a_thousand)
{
    static const double mu[] = { 0, 1e-6, 1e-3, 1, 1e3 };
    for (size_t k = 0; k < 5; k++) {
        sp_scene s;
        column(&s, 4, 1, 1e-3, mu[k], 0);
        verdict_is(&s, SP_STABLE, 1);
        s.gravity[0] = -s.gravity[2] * R(mu[k] * 0.98);
        if (mu[k] > 0 && mu[k] < 100) verdict_is(&s, SP_STABLE, 1);
        s.gravity[0] = -s.gravity[2] * R(mu[k] * 1.02 + TOL(1e-8, 1e-2));
        if (!verdict_is(&s, SP_UNSTABLE, 1)) TEST_PRINT("    mu = %g\n", mu[k]);
    }
}

TEST(gravity_from_every_side)
{
    sp_scene s;
    column(&s, 8, 1, 0.5, 0.5, 0);
    s.gravity[2] = 0;
    verdict_is(&s, SP_STABLE, 1);
    s.gravity[2] = R(9.81);
    verdict_is(&s, SP_UNSTABLE, 1);
    s.gravity[2] = 0, s.gravity[0] = R(9.81);
    verdict_is(&s, SP_UNSTABLE, 1);
    s.gravity[0] = 0, s.gravity[1] = R(-1e-3);
    verdict_is(&s, SP_UNSTABLE, 1);
    s.gravity[1] = R(NAN);
    sp_result r;
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
    s.gravity[1] = R(INFINITY);
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
}

/* From denormal to overflowing weights: the right verdict or a status. */
TEST(weights_of_any_size)
{
    static const double mass[] = {
        TOL(5e-324, 1.5e-45), TOL(1e-310, 1e-40), TOL(1e-300, 1e-37), TOL(1e-160, 1e-30), TOL(1e-80, 1e-20), 1e-9,
        1e9, TOL(1e80, 1e16), TOL(1e150, 1e18), TOL(1e155, 1e20), TOL(1e300, 1e37), TOL(1.7e308, 3.4e38)
    };
    for (size_t k = 0; k < sizeof mass / sizeof mass[0]; k++)
        for (int falls = 0; falls < 2; falls++) {
            sp_scene s;
            sp_result r;
            column(&s, 5, 1, 0.3, falls ? 0.4 : 0.7, 30);       /* tan 30 = .577 */
            s.block[1].mass = R(mass[k]);
            for (int i = 0; i < 3 && k < 2; i++) s.gravity[i] *= R(1024);       /* a weight that still has digits */
            const sp_status status = k > 1 ? checked(&s, NULL, &r) : sp_check(&s, NULL, &test_arena, &r);
            if (status) CHECK_INT(status, SP_E_NOT_FINITE);
            else if ((k > 1 || r.verdict) && !CHECK_INT(r.verdict, falls ? SP_UNSTABLE : SP_STABLE))
                TEST_PRINT("    mass %g\n", mass[k]);
            if (!status && !CHECK(numbers(r.f, 15) && numbers(r.dq, 12) && numbers(r.y0, 6)))
                TEST_PRINT("    mass %g\n", mass[k]);
        }
}

/* ------------------------------------------------------------------------------------------- supports, none and in part */

TEST(nothing_free_or_nothing_to_carry_stands)
{
    sp_scene s;
    sp_result r;
    column(&s, 6, 1, 1, 0, 60);
    s.block[1].fixed = SP_FIXED;
    NEED(checked(&s, NULL, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.reason, SP_REASON_NOTHING);
    start(&s, 2, 0, 0);                                 /* no contact, and no load either */
    body(&s, 1, 0, 0, 0, 0);
    body(&s, 1, 5, 0, 0, 0);
    s.gravity[2] = 0;
    verdict_is(&s, SP_STABLE, 1);
}

TEST(floaters_fall)
{
    sp_scene s;
    sp_result r;
    column(&s, 6, 1, 1, 0.5, 0);
    CHECK_INT(sp_scene_body(&s, 1, s.block[1].centroid, 0, NULL), SP_E_CAPACITY);
    start(&s, 4, 2, 8);
    body(&s, 0, 0, 0, -1, SP_FIXED);
    body(&s, 1, 0, 0, 1, 0);
    bed(&s, 0, 1, 0, 0, 0, 1, 1, 0.5);
    body(&s, 1e-9, 9, 0, 1, 0);
    NEED(checked(&s, NULL, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.reason, SP_REASON_NO_CONTACT);
    CHECK(r.final);
    CHECK_WITHIN(r.dq[6], 0, 1e-9);
    CHECK(r.dq[12 + 2] < 0);
    body(&s, 3, 9, 0, 3, 0);                            /* and a companion on it: a group in the air */
    bed(&s, 2, 3, 9, 0, 2, 1, 1, 0.5);
    NEED(checked(&s, NULL, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.reason, SP_REASON_NO_SUPPORT);
    CHECK(r.final && r.dq[12 + 2] < 0 && r.dq[18 + 2] < 0);
}

TEST_LIST(shapes)
    RUN(a_block_on_a_point_stands_above_it_only)
    RUN(a_block_on_an_edge_stands_above_it_only)
    RUN(three_points_carry_what_is_above_their_triangle)
    RUN(many_corners_and_repeated_joints_slide_and_topple_as_one)
    RUN(collinear_corners_change_nothing)
    RUN(needles_and_plates_topple_where_they_should)
    RUN(friction_from_nothing_to_a_thousand)
    RUN(gravity_from_every_side)
    RUN(weights_of_any_size)
    RUN(nothing_free_or_nothing_to_carry_stands)
    RUN(floaters_fall)
TEST_END
