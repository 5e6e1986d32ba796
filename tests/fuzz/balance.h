/* balance: forces and motions of a check summed by another hand than the library's, from the scene alone. */
#ifndef BALANCE_H
#define BALANCE_H

#include "ask.h"

static void across(const double a[3], const double b[3], double c[3])
{
    for (int k = 0; k < 3; k++) c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static double along(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static double length(const double a[3]) { return sqrt(along(a, a)); }

/* Force and moment about a point, and the sum of what they are made of. */
typedef struct wrench { double at[3], force[3], moment[3], size, arm_size, arm; } wrench;

static void push(wrench *w, const double F[3], const sp_real x[3], double sign)
{
    double r[3], m[3];
    for (int k = 0; k < 3; k++) r[k] = (double)x[k] - w->at[k];
    across(r, F, m);
    for (int k = 0; k < 3; k++) { w->force[k] += sign * F[k]; w->moment[k] += sign * m[k]; }
    w->size += length(F);
    w->arm_size += length(F) * length(r);
    if (length(r) > w->arm) w->arm = length(r);
}

static void corner_force(const sp_joint *j, const sp_real *f, double F[3])
{
    const double fn = (double)f[0], t1 = (double)f[1], t2 = (double)f[2];
    for (int k = 0; k < 3; k++) F[k] = fn * (double)j->n[k] + t1 * (double)j->t1[k] + t2 * (double)j->t2[k];
}

/* What the contacts do to a block, about its centroid. */
static wrench contacts_on(const sp_scene *s, const sp_real *f, int32_t b)
{
    wrench w;
    memset(&w, 0, sizeof w);
    for (int k = 0; k < 3; k++) w.at[k] = (double)s->block[b].centroid[k];
    for (int32_t q = 0; q < s->count.joints; q++) {
        const sp_joint *j = &s->joint[q];
        if (j->a != b && j->b != b) continue;
        for (int32_t v = j->point; v < j->point + j->points; v++) {
            double F[3];
            corner_force(j, f + 3 * v, F);
            push(&w, F, s->point[v], j->b == b ? 1 : -1);
        }
    }
    return w;
}

/* Weight and loads of a block; loads of these scenes have no mass, nothing shakes them. */
static wrench loads_on(const sp_scene *s, int32_t b)
{
    wrench w;
    double F[3];
    memset(&w, 0, sizeof w);
    for (int k = 0; k < 3; k++) {
        w.at[k] = (double)s->block[b].centroid[k];
        F[k] = (double)s->block[b].mass * (double)s->gravity[k];
    }
    push(&w, F, s->block[b].centroid, 1);
    for (int32_t q = 0; q < s->count.loads; q++) {
        const sp_load *load = &s->load[q];
        const double share = load->live ? (double)s->live : 1;
        if (load->block != b) continue;
        for (int k = 0; k < 3; k++) F[k] = share * (double)load->force[k];
        push(&w, F, load->point, 1);
        for (int k = 0; k < 3; k++) {
            w.moment[k] += share * (double)load->couple[k];
            w.arm_size += fabs(share * (double)load->couple[k]);
        }
    }
    return w;
}

static void near_to(const double a[3], const sp_real *b, double least, const char *what)
{
    for (int k = 0; k < 3; k++) HOLDS(fabs(a[k] - (double)b[k]) <= least, "%s[%d]: %g, summed %g", what, k, (double)b[k], a[k]);
}

/* Forces of a corner are those that its joint can carry. */
static void carried(const sp_joint *j, const sp_real *f)
{
    const double area = (double)j->area / j->points, slip = hypot((double)f[1], (double)f[2]);
    const double size = fabs((double)f[0]) + slip, rounding = 1e-12 * size * (1 + (double)j->strength.mu);
    HOLDS((double)f[0] >= -(double)j->strength.tension * area - rounding, "fn %g", (double)f[0]);
    HOLDS(slip <= (double)j->strength.mu * (double)f[0] + (double)j->strength.cohesion * area + rounding, "ft %g, fn %g", slip,
          (double)f[0]);
    if (j->strength.crushing > 0) HOLDS((double)f[0] <= (double)j->strength.crushing * area + rounding, "fn %g", (double)f[0]);
}

/* A corner's force as its joint can carry it, without crushing: fn kept, no tension beyond its strength, ft shortened. */
static void admitted(const sp_joint *j, const sp_real *f, sp_real *out)
{
    const double area = (double)j->area / j->points, slip = hypot((double)f[1], (double)f[2]);
    const double pull = (double)j->strength.tension * area, fn = (double)f[0] > -pull ? (double)f[0] : -pull;
    const double room = fmax(0, (double)j->strength.mu * fn + (double)j->strength.cohesion * area);
    out[0] = (sp_real)fn;
    for (int k = 1; k < 3; k++) out[k] = (sp_real)((double)f[k] * (slip > room ? room / slip : 1));
}

/* What forces leave of the loads, of the block that fares worst: relative to all that acts on it, in its free directions. */
static double left(const sp_scene *s, const sp_real *f)
{
    double worst = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const wrench c = contacts_on(s, f, b), p = loads_on(s, b);
        const double arm = c.arm > p.arm ? c.arm : p.arm, size = c.size + p.size, turn = c.arm_size + p.arm_size + arm * size;
        for (int k = 0; k < 6; k++) {
            if (s->block[b].fixed >> k & 1) continue;
            const double off = fabs(k < 3 ? c.force[k] + p.force[k] : c.moment[k - 3] + p.moment[k - 3]);
            const double of = k < 3 ? size : turn;
            if (off > worst * of) worst = off / of;
        }
    }
    return worst;
}

static void joint_resultants(const sp_scene *s, const sp_result *r)
{
    for (int32_t q = 0; q < s->count.joints; q++) {
        const sp_joint *j = &s->joint[q];
        double sum[3] = { 0, 0, 0 }, F[3], size = 0;
        sp_joint_force got;
        HOLDS(sp_joint_resultant(s, r, q, &got) == SP_OK, "joint %d", (int)q);
        for (int32_t v = j->point; v < j->point + j->points; v++) {
            corner_force(j, r->f + 3 * v, F);
            for (int k = 0; k < 3; k++) sum[k] += F[k];
            size += length(F);
            HOLDS(r->f[3 * v] >= got.min_fn && r->f[3 * v] <= got.max_fn, "fn of corner %d", (int)v);
            if (r->verdict == SP_STABLE) carried(j, r->f + 3 * v);
        }
        near_to(sum, got.force, 1e-12 * size, "joint");
        all_finite(got.point, 3, "point");
        HOLDS(got.utilisation >= 0 && got.corner_utilisation >= 0, "utilisation");
        if (r->verdict == SP_STABLE && !(j->strength.tension > 0))
            HOLDS(got.utilisation <= 1 + 1e-9, "utilisation %g", (double)got.utilisation);
    }
}

/* Resultants are the sums of the forces; forces of what stands balance it. */
static void resultants(const sp_scene *s, const sp_result *r)
{
    asked(RESULTANTS);
    joint_resultants(s, r);
    for (int32_t b = 0; b < s->count.blocks; b++) {
        sp_real force[3], moment[3];
        const wrench w = contacts_on(s, r->f, b);
        HOLDS(sp_block_resultant(s, r, b, force, moment) == SP_OK, "block %d", (int)b);
        near_to(w.force, force, 1e-12 * w.size, "force");
        near_to(w.moment, moment, 1e-12 * (w.arm_size + w.size * w.arm), "moment");
    }
    if (r->verdict == SP_STABLE) HOLDS(left(s, r->f) <= 2 * (double)r->tol + 1e-12, "it stands, and %g is left", left(s, r->f));
}

/* ------------------------------------------------------------------------------------------------------------- motions */

static void displaced(const sp_scene *s, const sp_real *dq, int32_t b, int32_t v, double u[3])
{
    double r[3], turn[3];
    for (int k = 0; k < 3; k++) {
        r[k] = (double)s->point[v][k] - (double)s->block[b].centroid[k];
        turn[k] = (double)dq[6 * b + 3 + k];
    }
    across(turn, r, u);
    for (int k = 0; k < 3; k++) u[k] += (double)dq[6 * b + k];
}

/* The conditions of the coupled check: forces that balance, corners no deeper than eps and no farther than eta, pressed ones as
 * deep as eps, friction against its slip.                                                        [Kao 2022, Eqs. 8-11] */
static void triple(const sp_scene *s, const sp_result *r)
{
    const double eps = (double)r->coupled.eps, eta = (double)r->coupled.eta, little = 1e-5 * (eps > 0 ? eps : eta);
    double most = 0;
    HOLDS(left(s, r->f) <= 2 * (double)r->tol + 1e-12, "coupled, and %g is left", left(s, r->f));
    for (int32_t v = 0; v < s->count.points; v++) most = fmax(most, fabs((double)r->f[3 * v]));
    for (int32_t q = 0; q < s->count.joints; q++) {
        const sp_joint *j = &s->joint[q];
        for (int32_t v = j->point; v < j->point + j->points; v++) {
            const double fn = (double)r->f[3 * v], f1 = (double)r->f[3 * v + 1], f2 = (double)r->f[3 * v + 2];
            const double ft = hypot(f1, f2);
            double u[3], a[3], d[3] = { 0, 0, 0 };
            displaced(s, r->coupled.dq, j->b, v, u);
            displaced(s, r->coupled.dq, j->a, v, a);
            for (int k = 0; k < 3; k++) {
                d[0] += (u[k] - a[k]) * (double)j->n[k];
                d[1] += (u[k] - a[k]) * (double)j->t1[k];
                d[2] += (u[k] - a[k]) * (double)j->t2[k];
            }
            const double slip = hypot(d[1], d[2]);
            carried(j, r->f + 3 * v);
            HOLDS(d[0] >= -eps - little && fmax(d[0], slip) <= eta + little, "corner %d: dn %g, |dt| %g", (int)v, d[0], slip);
            if (fn > 1e-6 * most) HOLDS(d[0] <= -eps + little, "corner %d: fn %g, dn %g", (int)v, fn, d[0]);
            if (ft > 1e-6 * most)
                HOLDS(f1 * d[1] + f2 * d[2] < -0.99 * ft * slip, "corner %d: ft %g, |dt| %g", (int)v, ft, slip);
        }
    }
}

/* How far corner v opens, and how far it slips.     returns how far both blocks move there */
static double corner_moves(const sp_scene *s, const sp_real *dq, const sp_joint *j, int32_t v, double *opening, double *slip)
{
    double u[3], w[3], n[3];
    displaced(s, dq, j->b, v, u);
    displaced(s, dq, j->a, v, w);
    const double size = length(u) + length(w);
    for (int k = 0; k < 3; k++) { u[k] -= w[k]; n[k] = (double)j->n[k]; }
    *opening = along(u, n);
    for (int k = 0; k < 3; k++) u[k] -= *opening * n[k];
    *slip = length(u);
    return size;
}

/* Loads work along a motion that proves a fall, no held direction moves, and no corner with friction alone resists it: it opens
 * by mu times its slip, but for what largest forces would make little of. */
static void falls(const sp_scene *s, const sp_result *r, double largest)
{
    double work = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const wrench p = loads_on(s, b);
        for (int k = 0; k < 6; k++) {
            if (s->block[b].fixed >> k & 1) HOLDS(fabs((double)r->dq[6 * b + k]) <= 0, "block %d moves along %d", (int)b, k);
            else work += (k < 3 ? p.force[k] : p.moment[k - 3]) * (double)r->dq[6 * b + k];
        }
    }
    HOLDS(work > 0, "work of the loads: %g", work);
    for (int32_t q = 0; q < s->count.joints; q++) {
        const sp_joint *j = &s->joint[q];
        for (int32_t v = j->point; v < j->point + j->points; v++) {
            double opening, slip;
            const double mu = (double)j->strength.mu, most = corner_moves(s, r->dq, j, v, &opening, &slip);
            if (j->strength.cohesion > 0 || j->strength.tension > 0 || j->strength.crushing > 0) continue;
            HOLDS((mu * slip - opening) / sqrt(1 + mu * mu) <= 1e-2 * (most + largest), "joint %d opens by %g, slips by %g",
                  (int)q, opening, slip);
        }
    }
}

/* What is told of a joint is what its corners do. */
static void joint_motion(const sp_scene *s, const sp_result *r, int32_t q, double *largest)
{
    const sp_joint *j = &s->joint[q];
    double opening = 0, slip = 0, most = 0;
    sp_joint_motion m;
    HOLDS(sp_joint_moves(s, r->dq, q, &m) == SP_OK, "joint %d", (int)q);
    for (int32_t v = j->point; v < j->point + j->points; v++) {
        double o, t;
        const double size = corner_moves(s, r->dq, j, v, &o, &t);
        if (o > opening) opening = o;
        if (t > slip) slip = t;
        if (size > most) most = size;
    }
    const double rounding = 1e-9 * (1 + most);
    HOLDS(fabs(opening - (double)m.opening) <= rounding && fabs(slip - (double)m.slip) <= rounding, "opens %g, slips %g",
          opening, slip);
    if (m.kind == SP_JOINT_RIGID) HOLDS(opening + slip <= 1e-4 * (1 + most), "rigid: opens %g, slips %g", opening, slip);
    if (m.kind == SP_JOINT_OPEN) HOLDS(opening > 0, "open by %g", opening);
    all_finite(m.a, 3, "a");
    all_finite(m.b, 3, "b");
    if (most > *largest) *largest = most;
}

static void moves(const sp_scene *s, const sp_result *r)
{
    double largest = 0;
    asked(MOVES);
    for (int32_t q = 0; q < s->count.joints; q++) joint_motion(s, r, q, &largest);
    if (r->verdict == SP_UNSTABLE) falls(s, r, largest);
    for (int32_t k = 0; r->verdict == SP_STABLE && k < 6 * s->count.blocks; k++)
        HOLDS(fabs((double)r->dq[k]) <= 0, "it stands and moves");
}

#endif
