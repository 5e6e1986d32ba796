/* Friction cones: the nearest point is in the cone, is itself nearest to itself, and leaves a rest at right angles that no
 * admissible force can use (Moreau); the derivative is that of the map. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"

#include <math.h>
#include "../../solvers/cone/cone.c"

static const int32_t faces[] = { 0, 3, 4, 5, 6, 7, 8, 12, 16, 31, 64 };
enum { KINDS = sizeof faces / sizeof faces[0] };

static void open_cone(int kind, sp__cone *k)
{
    sp__cone_carve(k, faces[kind], &test_arena);
    sp__cone_make(k);
}

/* How far f is outside, relative to its size. */
static double outside(const sp__cone *k, double mu, const double f[3])
{
    double most = k->faces ? -1e300 : sqrt(f[1] * f[1] + f[2] * f[2]);
    for (int32_t i = 0; i < k->faces; i++) {
        const double angle = 6.283185307179586477 * i / k->faces, d = cos(angle) * f[1] + sin(angle) * f[2];
        if (d > most) most = d;
    }
    const double size = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    return size > 0 ? (most - mu * f[0]) / size : 0;
}

static sp__yield friction(double mu)
{
    const sp__yield y = { R(mu), 0, 0, SP__HUGE, 1 };
    return y;
}

static void random_force(double mu, sp_real u[3])
{
    const double size = pow(10, (double)test_random_real(-3, 3));
    u[0] = R(size * (double)test_random_real(-1, 1));
    u[1] = R(size * (1 + mu) * (double)test_random_real(-1, 1));
    u[2] = R(size * (1 + mu) * (double)test_random_real(-1, 1));
    if (test_random_int(0, 9) == 0) u[test_random_int(0, 2)] = 0;
}

TEST(nearest_point_is_in_the_cone_and_leaves_a_useless_rest)
{
    for (int kind = 0; kind < KINDS; kind++) {
        sp__cone k;
        open_cone(kind, &k);
        for (int trial = 0; trial < 2000; trial++) {
            static const double mus[] = { 0, 1e-3, 0.3, 0.84, 3 };
            const double mu = (double)R(mus[trial % 5]);
            sp_real u[3], f[3], again[3];
            random_force(mu, u);
            const sp__yield yield = friction(mu);
            sp__cone_project(&k, &yield, u, f);
            sp__cone_project(&k, &yield, f, again);
            double fd[3], rest[3], dot = 0, size = 0, moved = 0;
            for (int c = 0; c < 3; c++) {
                fd[c] = (double)f[c], rest[c] = (double)u[c] - fd[c];
                dot += rest[c] * fd[c], size += (double)u[c] * (double)u[c];
                moved += fabs((double)again[c] - fd[c]);
            }
            const double eps = 64 * (double)SP_EPSILON;
            if (!CHECK_WITHIN(dot / size, 0, eps) || !CHECK_WITHIN(moved / sqrt(size), 0, eps) ||
                !CHECK(outside(&k, mu, fd) <= eps)) {
                TEST_PRINT("    %d faces, mu %g, u %.17g %.17g %.17g\n", (int)k.faces, mu, (double)u[0], (double)u[1], (double)u[2]);
                return;
            }
            for (int c = 0; c < 12; c++) {              /* rest . g <= 0 for admissible g */
                const double angle = (double)test_random_real(0, 6.2831853), reach = k.faces ? cos(3.14159265358979 / k.faces) : 1;
                const double use = rest[0] + mu * reach * (cos(angle) * rest[1] + sin(angle) * rest[2]);
                if (!CHECK(use <= eps * (1 + mu) * sqrt(size))) return;
            }
        }
    }
}

/* Without friction the cone is a half line, and straight away from it nothing is admissible. */
TEST(a_pull_without_friction_is_not_admissible)
{
    const sp__yield slippery = friction(0);
    for (int kind = 0; kind < KINDS; kind++) {
        const sp_real u[3] = { -2, 0, 0 };
        sp_real f[3] = { 1, 1, 1 }, D[6];
        sp__cone k;
        open_cone(kind, &k);
        CHECK_INT(sp__cone_project(&k, &slippery, u, f), SP__APEX);
        for (int c = 0; c < 3; c++) CHECK_WITHIN(f[c], 0, 0);
        CHECK_INT(sp__cone_derivative(&k, &slippery, u, D), SP__APEX);
    }
}

static int other_face(const sp__cone *k, const sp__yield *y, const sp_real a[3], const sp_real b[3])
{
    sp__foot p, q;
    sp__cone_foot(k, y, y->plain, a, &p);
    sp__cone_foot(k, y, y->plain, b, &q);
    if (p.region == SP__INSIDE || p.region == SP__APEX) return 0;       /* of no face */
    return (double)(p.w[0] * q.w[0] + p.w[1] * q.w[1]) < 0.999 || p.side * q.side < 0;
}

/* Central differences of the projection at u, width 2 h, against its derivative: the largest sum over a column of what they are
 * apart, columns along which the region, or the face of a pyramid, changes left out. */
static double derivative_off(const sp__cone *k, const sp__yield *y, const sp_real u[3], double h)
{
    sp_real D[6];
    double worst = 0;
    const sp__region here = sp__cone_derivative(k, y, u, D);
    const double full[3][3] = { { (double)D[0], (double)D[1], (double)D[2] }, { (double)D[1], (double)D[3], (double)D[4] },
                                { (double)D[2], (double)D[4], (double)D[5] } };
    for (int c = 0; c < 3; c++) {
        sp_real lo[3], hi[3], f[3], e[3];
        double off = 0;
        for (int i = 0; i < 3; i++) lo[i] = hi[i] = u[i];
        lo[c] = R((double)u[c] - h), hi[c] = R((double)u[c] + h);
        if (sp__cone_project(k, y, lo, f) != here || sp__cone_project(k, y, hi, e) != here) continue;
        if (k->faces && other_face(k, y, lo, hi)) continue;
        for (int i = 0; i < 3; i++) off += fabs(((double)e[i] - (double)f[i]) / ((double)hi[c] - (double)lo[c]) - full[i][c]);
        worst = fmax(worst, off);
    }
    return worst;
}

TEST(derivative_is_that_of_the_projection)
{
    for (int kind = 0; kind < KINDS; kind++) {
        sp__cone k;
        open_cone(kind, &k);
        for (int trial = 0; trial < 300; trial++) {
            const sp__yield yield = friction(0.5);
            sp_real u[3];
            random_force(0.5, u);
            const double t2 = (double)u[1] * (double)u[1] + (double)u[2] * (double)u[2], size = sqrt((double)u[0] * (double)u[0] + t2);
            const double off = derivative_off(&k, &yield, u, TOL(1e-6, 2e-3) * size);
            /* a pyramid's faces are flat, but neighbours share a region's name */
            if (k.faces == 0) CHECK_WITHIN(off, 0, TOL(1e-6, 5e-2) * (1 + size * size / (1e-300 + t2)));
            else if (off > TOL(1e-6, 5e-2)) CHECK(off < 4);
        }
    }
}

TEST(projection_scales_with_the_force)
{
    for (int kind = 0; kind < KINDS; kind++) {
        sp__cone k;
        open_cone(kind, &k);
        for (int trial = 0; trial < 200; trial++) {
            const sp__yield yield = friction(0.7);
            sp_real u[3], v[3], f[3], g[3];
            random_force(0.7, u);
            for (int c = 0; c < 3; c++) v[c] = 8 * u[c];
            sp__cone_project(&k, &yield, u, f);
            sp__cone_project(&k, &yield, v, g);
            for (int c = 0; c < 3; c++) CHECK(g[c] <= 8 * f[c] && g[c] >= 8 * f[c]);
        }
    }
}

TEST(directions_of_a_pyramid_are_evenly_spaced_unit_vectors)
{
    for (int32_t K = SP__FACES_MIN; K <= SP__FACES_MAX; K++) {
        sp_real c, t;
        sp__pyramid_half(K, &c, &t);
        CHECK_NEAR(c, cos(3.14159265358979323846 / K), 4 * (double)SP_EPSILON);
        CHECK_NEAR(t, tan(3.14159265358979323846 / K), 8 * (double)SP_EPSILON);
        for (int32_t k = 0; k < K; k++) {
            sp_real d[2];
            sp__pyramid_direction(K, k, d);
            CHECK_WITHIN(d[0], cos(6.28318530717958647692 * k / K), 8 * (double)SP_EPSILON + 2e-15);
            CHECK_WITHIN(d[1], sin(6.28318530717958647692 * k / K), 8 * (double)SP_EPSILON + 2e-15);
        }
    }
}

/* Mortar, crushing, both, without friction: what random strength looks like. */
static sp__yield strong(int kind)
{
    sp__yield y = { R(kind % 4 == 3 ? 0 : 0.6), 0, 0, SP__HUGE, 0 };
    if (kind & 1) y.C = test_random_real(0.1, 2), y.T = test_random_real(0, 0.3);
    if (kind & 2) y.N = test_random_real(0.1, 3);
    if (y.T * y.mu > y.C || kind == 5) y.T = y.mu > 0 ? y.C / y.mu : y.T;        /* 5: out to the apex */
    return y;
}

/* Largest d . ut over the directions of K: |ft| of the true cone. */
static double across(const sp__cone *k, const double f[3])
{
    double most = k->faces ? -1e300 : sqrt(f[1] * f[1] + f[2] * f[2]);
    for (int32_t i = 0; i < k->faces; i++) {
        const double angle = 6.283185307179586477 * i / k->faces;
        most = fmax(most, cos(angle) * f[1] + sin(angle) * f[2]);
    }
    return most;
}

/* A force in K: any in its section at some height. */
static void random_inside(const sp__cone *k, const sp__yield *y, double g[3])
{
    const double low = -(double)y->T, high = y->N < 100 ? (double)y->N : 100, n = low + (high - low) * (double)test_random_real(0, 1);
    const double r = ((double)y->C + (double)y->mu * n) * (double)test_random_real(0, 1), angle = (double)test_random_real(0, 6.2831853);
    g[0] = 0; g[1] = cos(angle); g[2] = sin(angle);
    const double size = across(k, g);
    g[0] = n; g[1] *= r / size; g[2] *= r / size;
}

TEST(with_strength_the_nearest_point_is_inside_and_leaves_a_useless_rest)
{
    for (int kind = 0; kind < KINDS; kind++) {
        sp__cone k;
        open_cone(kind, &k);
        for (int trial = 0; trial < (kind ? 5000 : 20000); trial++) {
            const sp__yield y = strong(trial % 7);
            const double eps = 256 * (double)SP_EPSILON;
            sp_real u[3], f[3];
            double use = 0, size = 1;
            for (int c = 0; c < 3; c++) u[c] = test_random_real(-5, 5), size += (double)u[c] * (double)u[c];
            sp__cone_project(&k, &y, u, f);
            const double fd[3] = { (double)f[0], (double)f[1], (double)f[2] };
            if (!CHECK(f[0] >= -y.T && f[0] <= y.N && across(&k, fd) <= (double)y.C + (double)y.mu * fd[0] + eps)) return;
            double g[3];
            random_inside(&k, &y, g);
            for (int c = 0; c < 3; c++) use += ((double)u[c] - fd[c]) * (g[c] - fd[c]);
            if (!CHECK(use <= eps * size * 100)) return;
        }
    }
}

TEST(with_strength_the_derivative_is_that_of_the_projection)
{
    for (int kind = 0; kind < KINDS; kind++) {
        sp__cone k;
        open_cone(kind, &k);
        for (int trial = 0; trial < (kind ? 1000 : 5000); trial++) {
            const sp__yield y = strong(trial % 7);
            sp_real u[3];
            for (int c = 0; c < 3; c++) u[c] = test_random_real(-4, 4);
            if ((double)u[1] * (double)u[1] + (double)u[2] * (double)u[2] < 0.04) continue;
            if (!CHECK_WITHIN(derivative_off(&k, &y, u, TOL(1e-6, 2e-3)), 0, TOL(1e-6, 5e-2))) return;
        }
    }
}

/* f.u over forces inside never comes above it, and the nearest point to a far s u comes close. */
TEST(the_support_function_bounds_what_strength_can_resist)
{
    for (int kind = 0; kind < KINDS; kind++) {
        sp__cone k;
        open_cone(kind, &k);
        for (int trial = 0; trial < (kind ? 5000 : 20000); trial++) {
            const sp__yield y = strong(trial % 7);
            sp_real u[3], far[3], f[3];
            double g[3], use = 0, reach = 0, size = 0;
            for (int c = 0; c < 3; c++) u[c] = test_random_real(-1, 1), far[c] = 4096 * u[c];
            const double most = 200, bound = (double)sp__cone_support(&k, &y, u, R(most));
            random_inside(&k, &y, g);
            for (int c = 0; c < 3; c++) use += g[c] * (double)u[c], size += g[c] * g[c];
            if (sqrt(size) <= most && !CHECK(use <= bound + 1e-4 * fabs(bound))) return;
            sp__cone_project(&k, &y, far, f);
            for (int c = 0; c < 3; c++) reach += (double)f[c] * (double)u[c];
            if (y.N < 100 && !CHECK(reach >= bound - 0.05 * (1 + fabs(bound)))) return;
        }
    }
}

TEST_LIST(cone)
    RUN(nearest_point_is_in_the_cone_and_leaves_a_useless_rest)
    RUN(a_pull_without_friction_is_not_admissible)
    RUN(derivative_is_that_of_the_projection)
    RUN(projection_scales_with_the_force)
    RUN(with_strength_the_nearest_point_is_inside_and_leaves_a_useless_rest)
    RUN(with_strength_the_derivative_is_that_of_the_projection)
    RUN(the_support_function_bounds_what_strength_can_resist)
    RUN(directions_of_a_pyramid_are_evenly_spaced_unit_vectors)
TEST_END
