/* Where no motion explains the forces: the tension and friction that joints lack. */
#include "coupled.h"

/* -------------------------------------------------------------------------------------------- where help is wanted */

/* How B moves seen from A at point v of joint i, along n, t1, t2 [m]. */
static void rate(const sp_scene *s, const sp_real *dq, const sp_joint *i, int32_t v, double d[3])
{
    double u[3] = { 0, 0, 0 };
    for (int side = 0; side < 2; side++) {
        const int32_t b = side ? i->a : i->b;
        const sp_real *q = dq + 6 * b, *x = s->point[v], *c = s->block[b].centroid;
        for (int k = 0; k < 3; k++) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            const double turn = (double)q[3 + l] * (double)(x[m] - c[m]) - (double)q[3 + m] * (double)(x[l] - c[l]);
            u[k] += (side ? -1 : 1) * ((double)q[k] + turn);
        }
    }
    for (int k = 0; k < 3; k++) {
        const sp_real *e = k == 0 ? i->n : k == 1 ? i->t1 : i->t2;
        d[k] = u[0] * (double)e[0] + u[1] * (double)e[1] + u[2] * (double)e[2];
    }
}

/* Force of vertex v of joint i onto its B, and the turn about c it gives. */
static void push(const sp_scene *s, const sp_real *penalty, const sp_joint *i, int32_t v, int32_t b, double sum[6])
{
    const sp_real *x = penalty + 4 * v;
    double f[3], arm[3];
    for (int k = 0; k < 3; k++) {
        f[k] = (double)((x[0] - x[1]) * i->n[k] + x[2] * i->t1[k] + x[3] * i->t2[k]) * (b == i->b ? 1 : -1);
        arm[k] = (double)(s->point[v][k] - s->block[b].centroid[k]);
        sum[k] += f[k];
    }
    for (int k = 0; k < 3; k++) sum[3 + k] += arm[(k + 1) % 3] * f[(k + 2) % 3] - arm[(k + 2) % 3] * f[(k + 1) % 3];
}

/* Every condition of the penalty form, its forces in balance; returns whether there is an answer. */
static int explained(const sp_scene *s, const sp_result *r)
{
    const double give = TOL(1e-6, 1e-2) * (double)r->coupled.eps;
    if (!CHECK(r->coupled.tension_ratio >= 0)) return 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const double weight = (double)s->block[b].mass * (double)s->gravity[2];
        double sum[6] = { 0, 0, weight, 0, 0, 0 };
        if (s->block[b].fixed) continue;
        for (int32_t i = 0; i < s->count.joints; i++)
            for (int32_t v = 0; v < s->joint[i].points && (s->joint[i].a == b || s->joint[i].b == b); v++)
                push(s, r->coupled.penalty, &s->joint[i], s->joint[i].point + v, b, sum);
        for (int k = 0; k < 6; k++) CHECK_WITHIN(sum[k], 0, TOL(1e-6, 1e-2) * fabs(weight));
    }
    for (int32_t i = 0; i < s->count.joints; i++)
        for (int32_t v = s->joint[i].point; v < s->joint[i].point + s->joint[i].points; v++) {
            const sp_real *x = r->coupled.penalty + 4 * v;
            double d[3];
            rate(s, r->coupled.dq, &s->joint[i], v, d);
            const double ft = hypot((double)x[2], (double)x[3]), dust = TOL(1e-9, 1e-4) * (double)x[0];
            CHECK(x[0] >= 0 && x[1] >= 0 && r->coupled.alpha[v] >= 0 && d[0] >= -(double)r->coupled.eps - give);
            CHECK(hypot(d[1], d[2]) <= (double)r->coupled.eta + give && d[0] <= (double)r->coupled.eta + give);
            if (x[0] > 0) CHECK_WITHIN(d[0], -(double)r->coupled.eps, give);
            CHECK(ft <= (double)s->joint[i].strength.mu * (double)x[0] + dust);
            for (int k = 1; k < 3; k++)
                CHECK_WITHIN((double)x[k + 1] + (double)r->coupled.alpha[v] * d[k], 0, TOL(1e-6, 1e-2) * (ft + dust));
        }
    return 1;
}

/* A cube of weight W that reaches beyond its support by `offset` of 1: it turns about the edge, s = 1 - offset wide, and only
 * the other edge holds it: W (1/2 - s) / s. */
TEST(a_block_beyond_its_support_demands_tension_at_the_far_edge)
{
    static const double offset[] = { 0.55, 0.6, 0.75 };
    for (int k = 0; k < 3; k++) {
        const sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        build("two-cubes", "offset", offset[k], &s);
        NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
        CHECK_INT(r.coupled.verdict, SP_COUPLING_REFUTED);
        if (!explained(&s, &r)) continue;
        const double W = (double)s.block[1].mass * 9.80665, pull = W * (offset[k] - 0.5) / (1 - offset[k]);
        CHECK_NEAR(r.demand[0].tension, pull / 2, TOL(1e-6, 1e-2));
        CHECK_NEAR(r.extremes.tension, pull / 2, TOL(1e-6, 1e-2));
        CHECK_NEAR(r.coupled.tension_ratio, pull / (W + pull), TOL(1e-6, 1e-2));
        for (int32_t v = 0; v < 4; v++) {
            const int far = s.point[v][0] < s.block[1].centroid[0] - R(offset[k]) / 2;
            CHECK_WITHIN(r.coupled.penalty[4 * v + (far ? 0 : 1)], 0, TOL(1e-6, 1e-2) * W);
            CHECK_NEAR(r.coupled.penalty[4 * v + (far ? 1 : 0)], (far ? pull : W + pull) / 2, TOL(1e-6, 1e-2));
        }
    }
}

/* Statics let the H model squeeze its beam and demand nothing. No motion squeezes it: one joint rubs, W / mu pressed at an
 * edge, against the other end's W w / (2h); the difference must be pulled. */
TEST(the_h_model_demands_tension_at_its_joints_once_a_motion_is_asked_for)
{
    static const double mu[] = { 0.2, 0.45, 0.84 };
    for (int k = 0; k < 3; k++) {
        const sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        build("h-model", "mu", mu[k], &s);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK_WITHIN(r.demand[0].tension + r.demand[1].tension + r.demand[0].friction + r.demand[1].friction, 0, 0);
        NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
        CHECK(r.coupled.verdict != SP_COUPLING_COUPLED);
        if (!explained(&s, &r)) continue;
        const double W = (double)s.block[2].mass * 9.80665;
        double pull = 0;
        for (int32_t v = 0; v < s.count.points; v++) pull += (double)r.coupled.penalty[4 * v + 1];
        CHECK(pull > 0.01 * W && r.coupled.tension_ratio > R(0.1));
        CHECK((double)(r.demand[0].friction + r.demand[1].friction) > 0.01 * W);
        if (k == 2) CHECK_WITHIN(pull / W, 1 / mu[k] - 1, 0.01);        /* w = 2h */
    }
}

TEST(friction_that_a_slope_lacks_is_told_along_with_the_slip)
{
    const sp_settings set = asked(100, 0);
    sp_scene s;
    sp_result r;
    test_arena.used = 0;
    build("incline", "angle", 50, &s);
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    if (!explained(&s, &r)) return;
    CHECK(r.demand[0].friction > 0);
    CHECK_INT(r.extremes.weakest, 0);
    for (int32_t v = 0; v < 4; v++) CHECK(r.coupled.alpha[v] > 0 && r.coupled.penalty[4 * v + 1] > 0);
}

TEST(nothing_is_demanded_where_a_motion_is_found_or_nobody_asks)
{
    for (int k = 0; k < 2; k++) {
        sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        set.localise = !k;
        build(k ? "h-model" : "incline", NULL, 0, &s);
        CHECK(answer(&s, &set, &r) == (k ? TOL(SP_COUPLING_REFUTED, r.coupled.verdict) : SP_COUPLING_COUPLED));
        CHECK(r.coupled.tension_ratio < 0 && !(r.extremes.tension > 0));
        for (int32_t i = 0; i < s.count.joints; i++) CHECK(!(r.demand[i].tension > 0) && !(r.demand[i].friction > 0));
        for (int32_t v = 0; !k && v < 4 * s.count.points; v++) CHECK_WITHIN(r.coupled.penalty[v], 0, 0);
    }
}

TEST(what_is_demanded_does_not_depend_on_units_axes_order_or_sides)
{
    double ratio = -1;
    for (int k = 0; k < 32; k += SOME_OF(1, 3)) {
        squeeze q = plain;
        sp_scene s;
        sp_result r;
        q.turn = k & 1 ? 0.7 : 0;
        q.unit = k & 2 ? 1e-3 : 1;
        q.heavy = k & 4 ? 1e3 : 1;
        q.swap = k >> 3 & 1;
        q.late = k >> 4 & 1;
        q.mu = 0.7;
        sp_settings set = asked(20, 1);
        set.coupled.eps *= R(q.unit);
        set.coupled.eta *= R(q.unit);
        squeezed(&q, &s);
        CHECK(answer(&s, &set, &r) != SP_COUPLING_COUPLED);
        if (!explained(&s, &r)) continue;
        if (ratio < 0) ratio = (double)r.coupled.tension_ratio;
        CHECK_NEAR(r.coupled.tension_ratio, ratio, TOL(1e-6, 1e-2));
    }
}

TEST_LIST(demand)
    RUN(a_block_beyond_its_support_demands_tension_at_the_far_edge)
    RUN(the_h_model_demands_tension_at_its_joints_once_a_motion_is_asked_for)
    RUN(friction_that_a_slope_lacks_is_told_along_with_the_slip)
    RUN(nothing_is_demanded_where_a_motion_is_found_or_nobody_asks)
    RUN(what_is_demanded_does_not_depend_on_units_axes_order_or_sides)
TEST_END
