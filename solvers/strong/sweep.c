/* sweep: contact forces and accelerations of the blocks at rest by projected sweeps over the corners, from any start.
 *
 *   a = M^-1 (p + Aeq f);   corner by corner   fn <- max(0, fn - dn / Wnn),  ft <- P_(mu fn) (ft - dt / Wt),  W = Aeq' M^-1 Aeq
 *                                                                     [nonsmooth Gauss-Seidel: Jourdan, Alart, Jean 1998]
 * Where it settles, (f, a) meets the laws of contact. Which of several pairs it comes to depends on where it starts.
 */
#ifndef SP__STRONG_SWEEP_C
#define SP__STRONG_SWEEP_C

#include "../scene/inertia.c"

#if SP__WITH_STRONG

/* A corner: its contact, its place among the scene's, 1 / Wnn and 1 / Wt. */
typedef struct sp__sweep_corner { int32_t contact, at; sp_real normal, tangent; } sp__sweep_corner;

typedef struct sp__sweep {
    const sp_problem *pb;
    const sp__inertia *M;
    int32_t corners;                    /* V: that take part */
    int32_t plates;                     /* 1: friction of a joint is one force at the centre of its pressure */
    sp__sweep_corner *corner;           /* V */
    uint8_t *on;                        /* V: 0: carries nothing for now */
    sp_real *f;                         /* 3 x points */
    sp_real *a;                         /* 6b */
    int64_t flops;
} sp__sweep;

#define SP__SWEEP_FLOPS 170             /* a corner in a sweep */

static void sp__sweep_carve(sp__sweep *s, const sp_problem *pb, sp_arena *a)
{
    s->pb = pb;
    s->corners = sp__points_count(pb->scene);
    s->corner = sp__take(a, (size_t)s->corners, sizeof *s->corner);
    s->on = sp__take(a, (size_t)s->corners, sizeof *s->on);
    s->f = sp__take(a, (size_t)pb->points, 3 * sizeof *s->f);
    s->a = sp__take(a, (size_t)pb->blocks, 6 * sizeof *s->a);
}

/* a += sign M^-1 Aeq of a force F at corner q. */
static void sp__sweep_push(const sp__sweep *s, const sp__sweep_corner *q, const sp_real F[3], sp_real *a)
{
    const sp_contact *t = &s->pb->contact[q->contact];
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->a : t->b;
        if (i < 0) continue;
        sp_real w[6], arm[3];
        sp__arm(s->pb, i, q->at, arm);
        sp__scale3(side ? (sp_real)-1 : (sp_real)1, F, w);
        sp__cross3(arm, w, w + 3);
        sp__inertia_accelerate(&s->M[i], w, a + 6 * (size_t)i);
    }
}

/* d = (dn, dt1, dt2) of corner q in the acceleration a. */
static void sp__sweep_rate(const sp__sweep *s, const sp__sweep_corner *q, const sp_real *a, sp_real d[3])
{
    const sp_contact *t = &s->pb->contact[q->contact];
    sp_real u[3] = { 0, 0, 0 };
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->a : t->b;
        if (i < 0) continue;
        sp_real arm[3], w[3];
        sp__arm(s->pb, i, q->at, arm);
        sp__cross3(a + 6 * (size_t)i + 3, arm, w);
        for (int k = 0; k < 3; k++) u[k] += (side ? -1 : 1) * (a[6 * (size_t)i + (size_t)k] + w[k]);
    }
    sp__joint_frame(t->joint, u, d);
}

/* Corners in order, and W of each from what a unit force gives; s->a is used up. Wt is the trace of both tangents. */
static void sp__sweep_begin(sp__sweep *s)
{
    int32_t v = 0;
    for (int32_t c = 0; c < s->pb->contacts; c++)
        for (int32_t k = 0; k < s->pb->contact[c].points; k++, v++) {
            const sp_joint *o = s->pb->contact[c].joint;
            sp__sweep_corner *q = &s->corner[v];
            sp_real W[3];
            q->contact = c;
            q->at = s->pb->contact[c].point + k;
            for (int e = 0; e < 3; e++) {
                sp_real d[3];
                memset(s->a, 0, 6 * (size_t)s->pb->blocks * sizeof *s->a);
                sp__sweep_push(s, q, e == 0 ? o->n : e == 1 ? o->t1 : o->t2, s->a);
                sp__sweep_rate(s, q, s->a, d);
                W[e] = d[e];
            }
            q->normal = W[0] > 0 ? 1 / W[0] : 0;
            q->tangent = W[1] + W[2] > 0 ? 1 / (W[1] + W[2]) : 0;
        }
}

/* a = M^-1 (p + Aeq f) */
static void sp__sweep_accelerate(sp__sweep *s)
{
    memset(s->a, 0, 6 * (size_t)s->pb->blocks * sizeof *s->a);
    for (int32_t i = 0; i < s->pb->blocks; i++)
        sp__inertia_accelerate(&s->M[i], s->pb->p + 6 * (size_t)i, s->a + 6 * (size_t)i);
    for (int32_t v = 0; v < s->corners; v++) {
        const sp__sweep_corner *q = &s->corner[v];
        sp_real F[3];
        sp__joint_force(s->pb->contact[q->contact].joint, s->f + 3 * (size_t)q->at, F);
        sp__sweep_push(s, q, F, s->a);
    }
    s->flops += SP__SWEEP_FLOPS * (int64_t)s->corners / 2;
}

/* Corner q's force becomes g.     returns its change */
static sp_real sp__sweep_change(sp__sweep *s, const sp__sweep_corner *q, const sp_real g[3])
{
    sp_real *f = s->f + 3 * (size_t)q->at, F[3];
    const sp_real change[3] = { g[0] - f[0], g[1] - f[1], g[2] - f[2] };
    memcpy(f, g, sizeof change);
    sp__joint_force(s->pb->contact[q->contact].joint, change, F);
    sp__sweep_push(s, q, F, s->a);
    return sp__norm3(change);
}

/* The corner's own step.     returns the change of its force */
static sp_real sp__sweep_corner_step(sp__sweep *s, const sp__sweep_corner *q)
{
    const sp_contact *t = &s->pb->contact[q->contact];
    const int joined = s->plates && t->points > 1;
    const sp_real *f = s->f + 3 * (size_t)q->at;
    sp_real d[3], g[3];
    sp__sweep_rate(s, q, s->a, d);
    g[0] = sp__max(0, f[0] - d[0] * q->normal);
    for (int k = 1; k < 3; k++) g[k] = f[k] - (joined ? 0 : d[k] * q->tangent);
    const sp_real most = t->joint->strength.mu * g[0], ft = SP_SQRT(g[1] * g[1] + g[2] * g[2]);
    if (ft > most) { g[1] *= most / ft; g[2] *= most / ft; }
    return sp__sweep_change(s, q, g);
}

/* The friction of the joint whose n corners begin at q, one force F at the centre of its pressure N, w the slip there:
 * F <- P_(mu N) (F - w / W); corners share F as they share N. */
static sp_real sp__sweep_joint_step(sp__sweep *s, const sp__sweep_corner *q, int32_t n)
{
    sp_real F[3] = { 0, 0, 0 }, d[3], change = 0, tangent = 0;
    for (int32_t k = 0; k < n; k++) sp__add3(F, 1, s->f + 3 * (size_t)q[k].at);
    if (!(F[0] > 0)) return 0;
    for (int32_t k = 0; k < n; k++) tangent += s->f[3 * (size_t)q[k].at] / F[0] * q[k].tangent;
    for (int32_t k = 0; k < n; k++) {
        const sp_real share = s->f[3 * (size_t)q[k].at] / F[0];
        sp__sweep_rate(s, &q[k], s->a, d);
        for (int e = 1; e < 3; e++) F[e] -= share * d[e] * tangent;
    }
    const sp_real most = s->pb->contact[q->contact].joint->strength.mu * F[0], ft = SP_SQRT(F[1] * F[1] + F[2] * F[2]);
    for (int e = 1; e < 3 && ft > most; e++) F[e] *= most / ft;
    for (int32_t k = 0; k < n; k++) {
        const sp_real fn = s->f[3 * (size_t)q[k].at], g[3] = { fn, fn / F[0] * F[1], fn / F[0] * F[2] };
        change += sp__sweep_change(s, &q[k], g);
    }
    return change;
}

/* Up to `most` sweeps, forward or backward, until a sweep changes forces by less than tol of their sum.
 *     returns the change of the last sweep, relative to the forces */
SP__NOINLINE static sp_real sp__sweep_run(sp__sweep *s, int32_t most, int backward, sp_real tol)
{
    sp_real change = 1;
    for (int32_t it = 0; it < most && change > tol; it++) {
        sp_real sum = 0, all = 0;
        if (it % 64 == 0) sp__sweep_accelerate(s);
        for (int32_t k = 0; k < s->corners; k++) {
            const int32_t v = backward ? s->corners - 1 - k : k;
            if (!s->on[v]) continue;
            sum += sp__sweep_corner_step(s, &s->corner[v]);
            all += s->f[3 * (size_t)s->corner[v].at];
        }
        for (int32_t v = 0; s->plates && v < s->corners; v += s->pb->contact[s->corner[v].contact].points)
            if (s->pb->contact[s->corner[v].contact].points > 1)
                sum += sp__sweep_joint_step(s, &s->corner[v], s->pb->contact[s->corner[v].contact].points);
        s->flops += SP__SWEEP_FLOPS * (int64_t)s->corners;
        change = all > 0 ? sum / all : sum > 0 ? 1 : 0;
    }
    sp__sweep_accelerate(s);
    return change;
}

#endif

#endif /* SP__STRONG_SWEEP_C */
