/* Reflections: the set of every corner, by the conditions of a triple. */
#define SP_API static
#include "../test.h"

#include <math.h>

#include "../../solvers/base/words.c"
#include "../../solvers/coupled/coupled.c"

#if SP__WITH_COUPLED

static sp__cra c;
static sp_settings set;
static sp_joint joint;
static sp_contact contact;

static void corner_of(double mu)
{
    memset(&c, 0, sizeof c);
    memset(&joint, 0, sizeof joint);
    memset(&set, 0, sizeof set);
    joint.strength.mu = R(mu);
    contact.joint = &joint;
    c.set = &set;
    c.k = (sp__lengths){ 1, 1, 20 };
    c.j.mu_factor = 1;
}

static sp__corner any_corner(void)
{
    sp__corner x;
    const sp_real f = R(pow(10, (double)test_random_real(-2, 1))), d = R(pow(10, (double)test_random_real(-1, 2)));
    for (int k = 0; k < 3; k++) {
        x.f[k] = f * test_random_real(-1, 1);
        x.d[k] = d * test_random_real(-1, 1);
    }
    return x;
}

static double square(const sp_real *x) { return (double)x[1] * (double)x[1] + (double)x[2] * (double)x[2]; }

/* Every condition of a triple at one corner. */
static int meets(const sp__corner *x, double mu)
{
    const double ft = sqrt(square(x->f)), dt = sqrt(square(x->d)), near = TOL(1e-12, 1e-4);
    const double dot = (double)x->f[1] * (double)x->d[1] + (double)x->f[2] * (double)x->d[2];
    const double across = (double)x->f[1] * (double)x->d[2] - (double)x->f[2] * (double)x->d[1];
    int good = x->f[0] >= 0 && x->d[0] >= -1 && x->d[0] <= 20 && dt <= 20 * (1 + near);
    if (x->f[0] > 0) good = good && (double)x->d[0] <= -1 + near && ft <= mu * (double)x->f[0] * (1 + near);
    else good = good && ft <= near;
    return good && fabs(across) <= near * (1 + ft * dt) && dot <= near * (1 + ft * dt) && (ft <= near || dt > 0);
}

TEST(what_is_nearest_of_a_corner_meets_its_conditions_and_stays_where_it_is)
{
    int open = 0, rubs = 0;
    for (int k = 0; k < 2000; k++) {
        const double mu = k % 5 ? (double)test_random_real(0, 2) : 0;
        corner_of(mu);
        const sp__corner x = any_corner();
        sp__corner y, z;
        sp__reflect_corner(&c, &contact, R(0.1), &x, &y);
        if (!CHECK(meets(&y, mu))) return;
        sp__reflect_corner(&c, &contact, R(0.1), &y, &z);
        CHECK((double)sp__reflect_distance(&y, &z, R(0.1)) <= TOL(1e-24, 1e-8) * (1 + (double)(y.f[0] * y.f[0]) + square(y.d)));
        open += !(y.f[0] > 0);
        rubs += square(y.f) > 0;
    }
    CHECK(open > 200 && rubs > 200);
}

/* The square of the distance to pressing with friction along any of 720 directions, where neither cone nor eta ends it. */
static double least_of_all(const sp__corner *x)
{
    double least = 1e30;
    for (int k = 0; k < 720; k++) {
        const double angle = k * 3.14159265358979323846 / 360, e[2] = { cos(angle), sin(angle) };
        const double a = fmax(-((double)x->f[1] * e[0] + (double)x->f[2] * e[1]), 0);
        const double b = fmax((double)x->d[1] * e[0] + (double)x->d[2] * e[1], 0);
        const sp__corner y = { { sp__max(x->f[0], 0), R(-a * e[0]), R(-a * e[1]) }, { -1, R(b * e[0]), R(b * e[1]) } };
        least = fmin(least, (double)sp__reflect_distance(x, &y, R(0.1)));
    }
    return least;
}

TEST(no_direction_is_nearer_where_friction_is_free)
{
    int slips = 0;
    for (int k = 0; k < 300; k++) {
        corner_of(1e6);
        c.k.eta = R(1e6);
        sp__corner x = any_corner(), y;
        x.f[0] = sp__abs(x.f[0]) + R(0.01);
        x.d[0] = -1;
        sp__reflect_corner(&c, &contact, R(0.1), &x, &y);
        const double shortest = 0.02 * (double)SP__REFLECT_LEAST * (1 + sqrt(square(x.d)));     /* a slip of that is asked for */
        CHECK((double)sp__reflect_distance(&x, &y, R(0.1)) <= least_of_all(&x) * (1 + TOL(1e-9, 1e-3)) + shortest);
        slips += square(y.f) > 0 && square(y.d) > 0;
    }
    CHECK(slips > 100);
}

TEST(a_corner_is_open_where_that_is_nearer)
{
    sp__corner y;
    const sp__corner apart = { { R(-0.1), 0, 0 }, { 3, 1, 30 } }, pressed = { { 2, R(-0.5), 0 }, { R(-1.5), 4, 0 } };
    corner_of(0.5);
    sp__reflect_corner(&c, &contact, R(0.1), &apart, &y);
    CHECK_NEAR(y.f[0], 0, 0);
    CHECK_NEAR(y.d[0], 3, 0);
    CHECK_NEAR(square(y.d), 400, TOL(1e-12, 1e-5));
    sp__reflect_corner(&c, &contact, R(0.1), &pressed, &y);
    CHECK_NEAR(y.f[0], 2, 0);
    CHECK_NEAR(y.f[1], -0.5, TOL(1e-12, 1e-5));
    CHECK_NEAR(y.d[0], -1, 0);
    CHECK_NEAR(y.d[1], 4, TOL(1e-12, 1e-5));
}

TEST(friction_beyond_its_cone_is_put_onto_it_and_slips_a_little_at_least)
{
    sp__corner y;
    const sp__corner x = { { 1, -3, 0 }, { -1, 0, 0 } };
    corner_of(0.5);
    sp__reflect_corner(&c, &contact, R(0.1), &x, &y);
    CHECK_NEAR(y.f[0], (1 + 0.5 * 3) / 1.25, TOL(1e-12, 1e-5));
    CHECK_NEAR(y.f[1], -0.5 * (double)y.f[0], TOL(1e-12, 1e-5));
    CHECK_NEAR(y.d[1], SP__REFLECT_LEAST, TOL(1e-12, 1e-5));
}

TEST(what_carries_nothing_is_scaled_as_if_it_carried_a_little)
{
    sp__scale scale[2];
    memset(scale, 0, sizeof scale);
    corner_of(0.5);
    contact.a = 0;
    contact.b = 1;
    c.j.scale = scale;
    c.sbar_most = 8;
    for (int k = 0; k < 3; k++) {
        static const double s[] = { 0, 1e-12, 2 };
        scale[0].s = 8;
        scale[1].s = R(s[k]);
        CHECK_NEAR(sp__reflect_scale(&c, &contact), k == 2 ? 2 : 8 * (double)SP__REFLECT_LIGHT, TOL(1e-15, 1e-6));
    }
}

#endif

TEST_LIST(reflect)
#if !defined SP_QP_ONLY && !defined SP_NO_CRA && !defined SP_SMALL && !defined SP_EXACT_ONLY
    RUN(what_is_nearest_of_a_corner_meets_its_conditions_and_stays_where_it_is)
    RUN(no_direction_is_nearer_where_friction_is_free)
    RUN(a_corner_is_open_where_that_is_nearer)
    RUN(friction_beyond_its_cone_is_put_onto_it_and_slips_a_little_at_least)
    RUN(what_carries_nothing_is_scaled_as_if_it_carried_a_little)
#endif
TEST_END
