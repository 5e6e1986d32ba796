/* Scaling and steps of the interior-point method, against what defines them. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"

#include <math.h>
#include "../../solvers/cone/ipm.c"

/* A point of the cone, `deep` 1: far inside, 0: on its boundary, and anything outside that. */
static void point(double deep, sp_real x[3])
{
    const double angle = (double)test_random_real(0, 6.2831853), size = pow(10, (double)test_random_real(-2, 2));
    x[0] = R(size);
    x[1] = R(size * (1 - deep) * cos(angle));
    x[2] = R(size * (1 - deep) * sin(angle));
}

static double det(const sp_real x[3])
{
    return ((double)x[0] - hypot((double)x[1], (double)x[2])) * ((double)x[0] + hypot((double)x[1], (double)x[2]));
}

static double largest(const sp_real x[3]) { return fmax(fabs((double)x[0]), fmax(fabs((double)x[1]), fabs((double)x[2]))); }

TEST(scaling_brings_a_pair_to_one_point)
{
    for (int trial = 0; trial < 2000; trial++) {
        sp_real x[3], z[3], a[3], b[3], c[3];
        sp__nt W;
        const double deep = pow(10, (double)test_random_real(TOL(-6, -2), 0));
        point(deep, x);
        point(deep, z);
        NEED(sp__soc_scaling(x, z, &W));
        sp__soc_scale(&W, z, 0, a);                     /* W z = W^-1 x */
        sp__soc_scale(&W, x, 1, b);
        for (int k = 0; k < 3; k++) if (!CHECK_WITHIN(a[k], b[k], TOL(1e-12, 1e-4) / deep / deep * largest(b))) return;
        sp__soc_scale(&W, a, 0, c);                     /* W W z = W^2 z = x */
        for (int k = 0; k < 3; k++) if (!CHECK_WITHIN(c[k], x[k], TOL(1e-12, 1e-4) / deep / deep * largest(x))) return;
        sp__soc_square(&W, z);
        for (int k = 0; k < 3; k++) if (!CHECK_WITHIN(z[k], x[k], TOL(1e-12, 1e-4) / deep / deep * largest(x))) return;
        CHECK_NEAR((double)sp__soc_det(x), det(x), TOL(1e-12, 1e-4) / deep);
    }
}

TEST(scaling_refuses_what_is_not_inside)
{
    static const sp_real in[3] = { 1, 0, 0 }, out[4][3] = { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 2 }, { -1, 0, 0 } };
    sp__nt W;
    CHECK(sp__soc_scaling(in, in, &W));
    for (int k = 0; k < 4; k++) CHECK(!sp__soc_scaling(in, out[k], &W) && !sp__soc_scaling(out[k], in, &W));
}

/* Numbers so large that a determinant is none: the scaling would be infinite, or 0. */
TEST(scaling_refuses_what_has_no_finite_size)
{
    const sp_real in[3] = { 1, 0, 0 }, huge[3] = { R(TOL(1e200, 1e30f)), 0, 0 };
    sp__nt W;
    CHECK(!sp__soc_scaling(huge, in, &W));
    CHECK(!sp__soc_scaling(in, huge, &W));
}

/* The step ends on the boundary, or there is none; also along the axis, where both roots are one. */
TEST(the_longest_step_ends_on_the_boundary)
{
    for (int trial = 0; trial < 4000; trial++) {
        sp_real x[3], d[3], y[3];
        point(pow(10, (double)test_random_real(TOL(-5, -2), 0)), x);
        for (int k = 0; k < 3; k++) d[k] = trial % 4 == k ? 0 : test_random_real(-1, 1);
        if (trial % 5 == 0) for (int k = 0; k < 3; k++) d[k] = -x[k];
        const sp_real s = sp__soc_step(x, d, 1000);
        CHECK(s > 0 && s <= 1000);
        for (int k = 0; k < 3; k++) y[k] = x[k] + s * d[k];
        const double noise = TOL(1e-12, 1e-4) * (pow(largest(x), 2) + pow((double)s * largest(d), 2));
        if (s < 1000 && !CHECK_WITHIN(det(y), 0, noise)) TEST_PRINT("    trial %d\n", trial);
        for (int k = 0; k < 3; k++) y[k] = x[k] + s * R(0.99) * d[k];
        CHECK((double)y[0] >= hypot((double)y[1], (double)y[2]) - sqrt(noise) * 1e-3);
    }
    const sp_real axis[3] = { 2, 0, 0 }, down[3] = { -1, 0, 0 }, up[3] = { 1, R(0.5), 0 };
    CHECK_NEAR(sp__soc_step(axis, down, 1000), 2, 0);
    CHECK_NEAR(sp__soc_step(axis, up, 7), 7, 0);
    CHECK_NEAR(sp__ray_step(3, -2, 1), 1, 0);
    CHECK_NEAR(sp__ray_step(3, -2, 10), 1.5, 0);
    CHECK_NEAR(sp__ray_step(3, 2, 10), 10, 0);
}

/* h = W q where lambda o q = aim e - lambda o lambda - (W^-1 dx) o (W dz). */
TEST(the_aim_is_what_the_corrector_asks_for)
{
    for (int trial = 0; trial < 1000; trial++) {
        sp_real x[3], z[3], dx[3], dz[3], h[3], l[3], a[3], b[3], q[3];
        sp__nt W;
        const double aim = (double)test_random_real(0, 1);
        point(0.3, x);
        point(0.3, z);
        for (int k = 0; k < 3; k++) { dx[k] = test_random_real(-1, 1); dz[k] = test_random_real(-1, 1); }
        NEED(sp__soc_scaling(x, z, &W));
        sp__soc_product(&W, z, dx, dz, R(aim), a);
        sp__soc_scale(&W, a, 0, h);
        for (int k = 0; k < 3; k++) h[k] -= x[k];
        sp__soc_scale(&W, z, 0, l);
        sp__soc_scale(&W, dx, 1, a);
        sp__soc_scale(&W, dz, 0, b);
        sp__soc_scale(&W, h, 1, q);
        const sp_real *pair[3][2] = { { l, q }, { l, l }, { a, b } };
        double sum[3] = { -aim, 0, 0 }, size = aim;
        for (int k = 0; k < 3; k++) {
            const sp_real *u = pair[k][0], *v = pair[k][1];
            for (int i = 0; i < 3; i++) {
                sum[0] += (double)u[i] * (double)v[i];
                if (i) sum[i] += (double)u[0] * (double)v[i] + (double)v[0] * (double)u[i];
            }
            size += 4 * largest(u) * largest(v);
        }
        for (int i = 0; i < 3; i++) if (!CHECK_WITHIN(sum[i], 0, TOL(1e-12, 1e-4) * size)) return;
    }
}

TEST_LIST(ipm)
    RUN(scaling_brings_a_pair_to_one_point)
    RUN(scaling_refuses_what_is_not_inside)
    RUN(scaling_refuses_what_has_no_finite_size)
    RUN(the_longest_step_ends_on_the_boundary)
    RUN(the_aim_is_what_the_corrector_asks_for)
TEST_END
