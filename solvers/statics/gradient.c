/* gradient: the forces of y, and the gradient of D */
#ifndef SP__STATICS_GRADIENT_C
#define SP__STATICS_GRADIENT_C

#include "motion.c"

#if SP__WITH_LARGE

/* An assembly. */
static int sp__dual_assembly(sp__dual *w, int plain)
{
    const sp__flat *o = sp__reduced(w);
    if (o && plain) return sp__dual_pay(w, SP__FLOPS_FLAT_HESSIAN(o) * o->vertices + SP__FLOPS_FLAT_BLOCKS * o->sides);
    return sp__dual_count(w, SP__FLOPS_HESSIAN, SP__FLOPS_BLOCKS);
}

/* f = S u; f = S P_K(u); df = D du with D given, with D of section 19 */
typedef enum sp__law { SP__BILATERAL, SP__ADMISSIBLE, SP__GIVEN, SP__INTERIOR } sp__law;

/* From now on gradients tell what the blocks bear, in the place of solutions: none is asked for meanwhile. */
static void sp__carry_begin(sp__dual *w) { w->carried = w->L.t; }

/* Force g at l, in the contact's frame, into what the blocks bear. */
SP__NOINLINE static void sp__dual_bear(sp__dual *w, const sp_contact *t, const sp_real *l, const sp_real g[3])
{
    const sp_joint *f = t->joint;
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *arm = side ? t->rb : t->ra;
        const sp_real x[3] = { sp__dot3(arm, f->n) + l[0], sp__dot3(arm, f->t1) + l[1], sp__dot3(arm, f->t2) + l[2] };
        sp_real m[3], *sum = w->carried + 3 * (size_t)i;
        sp__cross3(x, g, m);
        sum[0] += sp__norm3(g);
        sum[1] += sp__norm3(m);
        sum[2] = sp__max(sum[2], sp__norm3(x));
    }
}

/* Where no joint has strength a vertex of a search in 3 rows has fn, and planar one slip, with rates
 *   planar         un = X0 + q0 X2,  us = X1 + q1 X2;  level un = X0 + q0 X1 + q1 X2
 * and K is a wedge, its sides those of the cone in the plane.          *times: how often it counts */
static sp_real sp__flat_rate(const sp__dual *w, const sp_real *g, int32_t v, const sp_real X[3], sp_real q[2], sp_real u[2])
{
    const sp_real *l = w->pb->local[v];
    if (w->flat->mode == SP__PLANE) {
        q[0] = -(l[1] * g[2] + l[2] * g[3]);
        q[1] = l[0];
        u[0] = X[0] + q[0] * X[2];
        u[1] = w->slide * (X[1] + q[1] * X[2]);
    } else {
        q[0] = g[0] * l[2] - g[1] * l[1];
        q[1] = g[2] * l[2] - g[3] * l[1];
        u[0] = X[0] + q[0] * X[1] + q[1] * X[2];
        u[1] = 0;
    }
    return sp__dual_counts(w, v);
}

/* f = P_K(u) with tension at its price, D its derivative (nn, ns, ss); mu: of the yield. f or D may be NULL. */
static void sp__flat_wedge(const sp__dual *w, sp_real mu, const sp_real *g, const sp_real u[2], sp_real *f, sp_real *D)
{
    const sp_real side = u[1] < 0 ? (sp_real)-1 : (sp_real)1, s = side * u[1], k = mu / g[u[1] < 0 ? 5 : 4];
    const sp_real n = u[0] + k * s, x = n / (1 + k * k);
    const int inside = u[0] >= 0 && s <= k * u[0], carries = inside || n > 0;
    const sp_real soft = u[0] < 0 ? w->soft : 0, c = 1 / (1 + k * k);
    if (f) { f[0] = (inside ? u[0] : carries ? x : 0) + soft * u[0]; f[1] = inside ? u[1] : carries ? side * k * x : 0; }
    if (!D) return;
    D[0] = (inside ? 1 : carries ? c : 0) + soft;
    D[1] = inside || !carries ? 0 : side * k * c;
    D[2] = inside ? 1 : carries ? k * k * c : 0;
}

/* f = P_K(u), or u where joints are bilateral, in the metric; D likewise. */
static void sp__flat_law(const sp__dual *w, sp__law law, int32_t c, const sp_real *g, const sp_real u[2], sp_real *f, sp_real *D)
{
    const sp_real S = sp__dual_S(w, c), T = S * w->slide;
    if (f) { f[0] = u[0]; f[1] = u[1]; }
    if (D) { D[0] = D[2] = 1; D[1] = 0; }
    if (law == SP__ADMISSIBLE && w->flat->mode == SP__PLANE) sp__flat_wedge(w, sp__dual_mu(w, c), g, u, f, D);
    else if (law == SP__ADMISSIBLE && u[0] < 0) {
        if (f) f[0] *= w->soft;
        if (D) D[0] = w->soft;
    }
    if (f) { f[0] *= S; f[1] *= T; }
    if (D) { D[0] *= S; D[1] *= T; D[2] *= T * w->slide; }
}

/* Size of a force (fn, a slip) and of its moment about an arm x + l in the contact's frame. */
static sp_real sp__flat_moment(const sp__dual *w, const sp_contact *t, int side, int32_t v, const sp_real h[2], sp_real size[2])
{
    const sp_real *g = sp__flat_frame(w, t), *arm = side ? t->rb : t->ra, *l = w->pb->local[v];
    const sp_real x[3] = { sp__dot3(arm, t->joint->n) + l[0], sp__dot3(arm, t->joint->t1) + l[1], sp__dot3(arm, t->joint->t2) + l[2] };
    const int plane = w->flat->mode == SP__PLANE;
    const sp_real f[3] = { h[0], plane ? h[1] * g[2] : 0, plane ? h[1] * g[3] : 0 };
    sp_real m[3];
    sp__cross3(x, f, m);
    size[0] = SP_SQRT(h[0] * h[0] + h[1] * h[1]);
    size[1] = sp__norm3(m);
    return sp__norm3(x);
}

/* sp__dual_bear of that force. */
static void sp__flat_bear(sp__dual *w, const sp_contact *t, int32_t v, sp_real times, const sp_real h[2])
{
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        sp_real size[2], *sum = w->carried + 3 * (size_t)i;
        if (i < 0) continue;
        const sp_real moment = sp__flat_moment(w, t, side, v, h, size);
        sum[0] += times * size[0];
        sum[1] += times * size[1];
        sum[2] = sp__max(sum[2], moment);
    }
}

/* A contact's share of sp__dual_gradient. */
SP__NOINLINE static void sp__flat_gradient(sp__dual *w, sp__law law, int32_t c, const sp_real *y, sp_real *r, sp_real *f)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__flat_frame(w, t);
    const int plane = w->flat->mode == SP__PLANE;
    sp__visit *s = sp__visit_of(w);
    sp_real *X = s->twist[0], *Y = s->F, *q = s->m, *u = s->u[0], *h = s->f;
    Y[0] = Y[1] = Y[2] = 0;
    sp__flat_there(w, t, g, y, X);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        if (!(times > 0)) continue;
        sp__flat_law(w, law, c, g, u, h, NULL);
        if (w->carried) sp__flat_bear(w, t, v, times, h);
        if (f) {
            f[3 * (size_t)v] = h[0];
            f[3 * (size_t)v + 1] = plane ? h[1] * g[2] : 0;
            f[3 * (size_t)v + 2] = plane ? h[1] * g[3] : 0;
        }
        const sp_real n = times * h[0], slip = times * h[1];
        Y[0] += n;
        Y[1] += plane ? slip : q[0] * n;
        Y[2] += plane ? q[0] * n + q[1] * slip : q[1] * n;
    }
    sp__flat_back(w, t, g, Y, r);
}

/* What its vertices can resist motion y with: sum |P_K(u)| times the cap, in the metric. */
SP__NOINLINE static sp_real sp__flat_resist(const sp__dual *w, int32_t c, const sp_real *y, sp_real most)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__flat_frame(w, t);
    sp__visit *at = sp__visit_of(w);
    sp_real *X = at->twist[0], *q = at->m, *u = at->u[0], *h = at->f, sum = 0;
    sp__flat_there(w, t, g, y, X);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        if (!(times > 0)) continue;
        sp__flat_law(w, SP__ADMISSIBLE, c, g, u, h, NULL);
        sum += times * SP_SQRT(h[0] * h[0] + h[1] * h[1]);
    }
    return most * sum;
}

/* And of sp__dual_slope. */
SP__NOINLINE static sp_real sp__flat_slope(sp__dual *w, int32_t c, const sp_real *y, const sp_real *d, sp_real s)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__flat_frame(w, t);
    sp__visit *at = sp__visit_of(w);
    sp_real *X = at->twist[0], *dX = at->twist[1], *q = at->m, *u = at->u[0], *du = at->u[1], *h = at->f, sum = 0;
    sp__flat_there(w, t, g, y, X);
    sp__flat_there(w, t, g, d, dX);
    for (int k = 0; k < 3; k++) X[k] += s * dX[k];
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        if (!(times > 0)) continue;
        sp__flat_law(w, SP__ADMISSIBLE, c, g, u, h, NULL);
        sp__flat_rate(w, g, v, dX, q, du);
        sum += times * (h[0] * du[0] + h[1] * du[1] / w->slide);
    }
    return sum;
}

/* H of a contact, 3 x 3 in X. */
SP__NOINLINE static void sp__flat_hessian(sp__dual *w, sp__law law, int32_t c, const sp_real *y, sp_real H[9])
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__flat_frame(w, t);
    const int plane = w->flat->mode == SP__PLANE;
    sp__visit *at = sp__visit_of(w);
    sp_real *X = at->twist[0], *h = at->twist[1], *q = at->m, *u = at->u[0], *D = at->D;
    for (int k = 0; k < 6; k++) h[k] = 0;
    sp__flat_there(w, t, g, y, X);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        if (!(times > 0)) continue;
        sp__flat_law(w, law, c, g, u, NULL, D);
        const sp_real nn = times * D[0], ns = times * D[1], ss = times * D[2];
        const sp_real a = nn * q[0], b = plane ? ns * q[1] : nn * q[1];
        h[0] += nn;
        h[1] += plane ? ns : a;
        h[2] += plane ? a + b : b;
        h[3] += plane ? ss : a * q[0];
        h[4] += plane ? ns * q[0] + ss * q[1] : a * q[1];
        h[5] += plane ? (a + 2 * b) * q[0] + ss * q[1] * q[1] : b * q[1];
    }
    H[0] = h[0]; H[1] = H[3] = h[1]; H[2] = H[6] = h[2];
    H[4] = h[3]; H[5] = H[7] = h[4]; H[8] = h[5];
}

/* And in 6 rows. */
SP__NOINLINE static void sp__space_gradient(sp__dual *w, sp__law law, int32_t c, const sp_real *y, sp_real *r, sp_real *f)
{
    const sp_contact *t = &w->pb->contact[c];
    sp__visit *s = sp__visit_of(w);
    sp_real *V = s->twist[0], *W = V + 3, *u = s->u[0], *g = s->f, *F = s->F, *M = s->M;
    for (int k = 0; k < 3; k++) F[k] = M[k] = 0;
    sp__dual_twist(w, t, y, V, W);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *l = w->pb->local[v], times = sp__dual_counts(w, v);
        if (!(times > 0)) continue;
        sp__dual_rate(w, V, W, l, u);
        if (law == SP__ADMISSIBLE) sp__dual_force(w, c, w->yield, u, g);
        else for (int k = 0; k < 3; k++) g[k] = sp__dual_S(w, c) * (k ? w->slide * u[k] : u[k]);
        if (f) memcpy(f + 3 * (size_t)v, g, 3 * sizeof *g);
        sp__scale3(times, g, g);
        F[0] += g[0]; F[1] += g[1]; F[2] += g[2];
        M[0] += l[1] * g[2] - l[2] * g[1];
        M[1] += l[2] * g[0] - l[0] * g[2];
        M[2] += l[0] * g[1] - l[1] * g[0];
        if (w->carried) sp__dual_bear(w, t, l, g);
    }
    sp__dual_scatter(w, t, F, M, r);
}

/* r = Aeq f(y) + p, weighted; f (may be NULL) gets the forces, 3 x points, in units. */
static void sp__dual_gradient(sp__dual *w, sp__law law, const sp_real *y, sp_real *r, sp_real *f)
{
    const sp_problem *pb = w->pb;
    if (!sp__dual_sweep(w, 1, 1) || (w->carried && !sp__dual_count(w, SP__FLOPS_SWEEP, 0))) return;
    sp__dual_load(w, r);
    if (w->carried) memset(w->carried, 0, 3 * (size_t)pb->blocks * sizeof *w->carried);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int plain = sp__dual_yield(w, c)->plain;
        if (sp__reduced(w) && plain) sp__flat_gradient(w, law, c, y, r, f);
        else sp__space_gradient(w, law, c, y, r, f);
    }
    sp__dual_release(w, r);
}

/* A contact's share of sp__dual_slope. */
SP__NOINLINE static sp_real sp__space_slope(sp__dual *w, int32_t c, const sp_real *y, const sp_real *d, sp_real s)
{
    const sp_contact *t = &w->pb->contact[c];
    sp__visit *o = sp__visit_of(w);
    sp_real *at = o->twist[0], *move = o->twist[1], *u = o->u[0], *du = o->u[1], *f = o->f, sum = 0;
    sp__dual_twist(w, t, y, at, at + 3);
    sp__dual_twist(w, t, d, move, move + 3);
    for (int k = 0; k < 6; k++) at[k] += s * move[k];
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        if (!(sp__dual_counts(w, v) > 0)) continue;
        sp__dual_rate(w, at, at + 3, w->pb->local[v], u);
        sp__dual_rate(w, move, move + 3, w->pb->local[v], du);
        sp__dual_force(w, c, w->yield, u, f);
        sum += sp__dual_counts(w, v) * (f[0] * du[0] + (f[1] * du[1] + f[2] * du[2]) / w->slide);
    }
    return sum;
}

/* d/ds D(y + s d) = f(u + s du) . du + p . d. */
SP__NOINLINE static sp_real sp__dual_slope(sp__dual *w, const sp_real *y, const sp_real *d, sp_real s)
{
    sp_real sum = 0;
    if (!sp__dual_sweep(w, 1, 2)) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const int plain = sp__dual_yield(w, c)->plain;
        sum += sp__reduced(w) && plain ? sp__flat_slope(w, c, y, d, s) : sp__space_slope(w, c, y, d, s);
    }
    return sum + sp__dual_work(w, d);
}

/* h += (I, -[l]x)' D (I, -[l]x), row by row: x = l x D_i is row i of -D [l]x, and [l]x of those rows makes ww. */
SP__NOINLINE static void sp__vertex_hessian(const sp_real D[6], const sp_real *l, sp_real *h)
{
    static const unsigned char at[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
    for (int i = 0; i < 3; i++) {
        const int up = (i + 2) % 3, down = (i + 1) % 3;
        const sp_real row[3] = { D[at[i][0]], D[at[i][1]], D[at[i][2]] };
        sp_real x[3];
        sp__cross3(l, row, x);
        for (int j = 0; j < 3; j++) {
            h[3 * i + j] += row[j];
            h[9 + 3 * i + j] += x[j];
            h[18 + 3 * down + j] += l[up] * x[j];
            h[18 + 3 * up + j] -= l[down] * x[j];
        }
    }
}

#endif

#endif /* SP__STATICS_GRADIENT_C */
