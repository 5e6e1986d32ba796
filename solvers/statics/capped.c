/* capped: interior points of a vertex whose joint has strength: its K is a cone moved down and cut off below and above.
 *
 *   s = G x + tau h >= 0          (C tau + mu xn, xt) in the cone of second order,  xn + T tau >= 0,  N tau - xn >= 0
 *
 * with x the force of the homogeneous problem and C, T, N of the vertex, all in units of `force_scale` S; each row is scaled
 * so that the start s = e is of its size. The embedding of interior.c then has rows of its own for every vertex,
 *
 *   Aeq x + tau p -> 0,   G x + tau h - s -> 0,   Aeq' y + G' z -> 0,   kappa + p.y + h.z -> 0,   s o z = mu e,
 *   tau kappa = k mu,
 *
 * with z kept. Where rates change by du and tau by dtau, W^2 of s and z,
 *
 *   x changes by D (du + t) + dtau b,   D = (G' W^-2 G)^-1,   b = -D G' W^-2 h,
 *   t = keep (Aeq'y + G'z) + G' W^-2 (aim - keep R),
 *
 * so that the matrix of a step is Aeq D Aeq' as before and the column of tau is p + Aeq b.      [Andersen, Roos, Terlaky 2003]
 */
#ifndef SP__STATICS_CAPPED_C
#define SP__STATICS_CAPPED_C

#include "../cone/ipm.c"
#include "motion.c"

#if SP__WITH_LARGE

/* Rows of the vertices of contact c, before any of them is asked for. Tension that ends where the cone does needs none. */
static void sp__capped_rows(sp__system *w, int32_t c)
{
    sp__capped *o = w->inner->capped;
    const sp__yield *k = sp__system_yield(w, c);
    const sp_real each = 1 / w->inner->force_scale;
    o->mu = k->mu;
    o->C = k->C * each;
    o->T = k->T * each;
    o->N = k->N < SP__HUGE ? k->N * each : 0;
    o->cone = o->mu + o->C > 0 ? 1 / sp__max(o->mu, o->C) : 0;
    o->low = !(o->cone > 0) || o->C - o->mu * o->T > (sp_real)1e-9 * o->C ? 1 / sp__max(1, o->T) : 0;
    o->high = k->N < SP__HUGE ? 1 / sp__max(1, o->N) : 0;
}

/* G x + tau h */
static void sp__capped_slack(const sp__capped *o, const sp_real x[3], sp_real tau, sp_real s[5])
{
    s[0] = o->cone * (o->mu * x[0] + o->C * tau);
    s[1] = o->cone * x[1];
    s[2] = o->cone * x[2];
    s[3] = o->low * (x[0] + o->T * tau);
    s[4] = o->high * (o->N * tau - x[0]);
}

/* x += G' z */
static void sp__capped_gather(const sp__capped *o, const sp_real z[5], sp_real x[3])
{
    x[0] += o->cone * o->mu * z[0] + o->low * z[3] - o->high * z[4];
    x[1] += o->cone * z[1];
    x[2] += o->cone * z[2];
}

/* h.z */
static sp_real sp__capped_reserve(const sp__capped *o, const sp_real z[5])
{
    return o->cone * o->C * z[0] + o->low * o->T * z[3] + o->high * o->N * z[4];
}

/* W and D = (G' W^-2 G)^-1: the cone's part across n in closed form, then what all rows have along n.
 *   returns 0 when s or z is not inside */
static int sp__capped_scaling(sp__capped *o, const sp_real s[5], const sp_real z[5])
{
    sp_real *D = o->D, more = 0;
    for (int k = 0; k < 6; k++) D[k] = 0;
    if ((o->low > 0 && !(s[3] > 0 && z[3] > 0)) || (o->high > 0 && !(s[4] > 0 && z[4] > 0))) return 0;
    o->lower = o->low > 0 ? z[3] / s[3] : 0;
    o->upper = o->high > 0 ? z[4] / s[4] : 0;
    more = o->low * o->low * o->lower + o->high * o->high * o->upper;
    if (!(o->cone > 0)) { D[0] = 1 / more; return 1; }
    if (!sp__soc_scaling(s, z, &o->W)) return 0;
    const sp_real x = o->W.w[1], y = o->W.w[2], t = x * x + y * y, e = 1 / (1 + 2 * t), a = o->W.s / o->cone;
    const sp_real p = o->mu * 2 * o->W.w[0] * e * x, q = o->mu * 2 * o->W.w[0] * e * y;
    D[0] = 1 / (more + o->mu / a * (o->mu / a) * e);
    D[1] = p * D[0];
    D[2] = q * D[0];
    D[3] = p * D[1] + a * a * (t > 0 ? (y * y + e * x * x) / t : 1);
    D[4] = p * D[2] + a * a * (t > 0 ? (e - 1) * x * y / t : 0);
    D[5] = q * D[2] + a * a * (t > 0 ? (x * x + e * y * y) / t : 1);
    return 1;
}

/* v <- W^-2 v */
static void sp__capped_divide(const sp__capped *o, sp_real v[5])
{
    if (o->cone > 0) {
        const sp__nt back = { { o->W.w[0], -o->W.w[1], -o->W.w[2] }, 1 / o->W.s };
        sp__soc_square(&back, v);
    }
    v[3] *= o->lower;
    v[4] *= o->upper;
}

/* x <- D t + dtau b */
static void sp__capped_change(const sp__capped *o, const sp_real t[3], sp_real dtau, sp_real x[3])
{
    const sp_real *D = o->D, *b = o->b;
    x[0] = D[0] * t[0] + D[1] * t[1] + D[2] * t[2] + dtau * b[0];
    x[1] = D[1] * t[0] + D[3] * t[1] + D[4] * t[2] + dtau * b[1];
    x[2] = D[2] * t[0] + D[4] * t[1] + D[5] * t[2] + dtau * b[2];
}

/* D of a vertex for the matrix; f (may be NULL) its force. Adds s.z to the gap and h.z to the reserve. */
SP__NOINLINE static void sp__capped_derivative(sp__system *w, int32_t c, int32_t v, sp_real D[6], sp_real f[3])
{
    sp__ipm *m = w->inner;
    sp__capped *o = m->capped;
    const sp_real *x = m->x + SP__CAPPED * (size_t)v, *s = x + 3, *z = x + 8;
    const sp_real S = m->force_scale * sp__system_scale(w, c), times = sp__system_multiplicity(w, v);
    if (!sp__capped_scaling(o, s, z)) { m->outside = 1; return; }
    for (int k = 0; k < 6; k++) D[k] = S * S * o->D[k];
    for (int k = 0; f && k < 3; k++) f[k] = S * x[k];
    m->gap += times * sp__dot(s, z, 5);
    o->reserve += times * sp__capped_reserve(o, z);
}

/* dz <- W^-2 (-s - ds) = -z - W^-2 ds */
static void sp__capped_push(const sp__capped *o, const sp_real z[5], const sp_real ds[5], sp_real dz[5])
{
    for (int k = 0; k < 5; k++) dz[k] = -ds[k];
    sp__capped_divide(o, dz);
    for (int k = 0; k < 5; k++) dz[k] -= z[k];
}

/* Changes ds, dz of the predictor, u its rates. */
SP__NOINLINE static void sp__capped_predicted(sp__capped *o, const sp_real z[5], const sp_real u[3])
{
    sp_real *ds = o->ds, *dz = o->dz, *t = o->t, *dx = o->dx;
    sp__capped_push(o, z, o->miss, dz);
    for (int k = 0; k < 3; k++) t[k] = u[k] + o->resist[k];
    sp__capped_gather(o, dz, t);
    sp__capped_change(o, t, o->before, dx);
    sp__capped_slack(o, dx, o->before, ds);
    for (int k = 0; k < 5; k++) ds[k] += o->miss[k];
    sp__capped_push(o, z, ds, dz);
}

/* o->change <- W^-2 of the change s is to make: -z, or with the product of the predictor's changes, towards s o z = aim e. */
SP__NOINLINE static void sp__capped_aim(const sp__ipm *m, const sp_real s[5], const sp_real z[5])
{
    sp__capped *o = m->capped;
    const sp_real *ds = o->ds, *dz = o->dz, aim = m->sigma * m->mu;
    for (int k = 0; k < 5; k++) o->change[k] = -z[k];
    if (!m->corrected) return;
    if (o->cone > 0) {
        sp_real a[3], back[3];
        sp__soc_product(&o->W, z, ds, dz, aim, a);
        sp__soc_scale(&o->W, a, 1, back);
        for (int k = 0; k < 3; k++) o->change[k] += back[k];
    }
    if (o->low > 0) o->change[3] += (aim - ds[3] * dz[3]) / s[3];
    if (o->high > 0) o->change[4] += (aim - ds[4] * dz[4]) / s[4];
}

/* Step length or step of x, s, z: changes dx, ds, dz. */
static void sp__capped_go(sp__ipm *m, sp_real *x)
{
    const sp__capped *o = m->capped;
    sp_real *s = x + 3, *z = x + 8;
    if (m->pass == SP__REACH) {
        if (o->cone > 0) m->reach = sp__soc_step(z, o->dz, sp__soc_step(s, o->ds, m->reach));
        if (o->low > 0) m->reach = sp__ray_step(z[3], o->dz[3], sp__ray_step(s[3], o->ds[3], m->reach));
        if (o->high > 0) m->reach = sp__ray_step(z[4], o->dz[4], sp__ray_step(s[4], o->ds[4], m->reach));
        return;
    }
    for (int k = 0; k < 3; k++) x[k] += m->reach * o->dx[k];
    for (int k = 0; k < 5; k++) { s[k] += m->reach * o->ds[k]; z[k] += m->reach * o->dz[k]; }
}

/* b, the x of least |W^-1 (G x + h)|^2, and o->rest = G b + h; returns that least. Nearly all of G' W^-2 h cancels where a row
 * is stiff, so none of it is formed: with p the cone's first row, the cone's part is least, e p^2 / W.s^2, where the other two
 * are 2 w0 e p (w1, w2), e = 1 / (1 + 2 w1^2 + 2 w2^2); along n three squares of b0 are left. */
static sp_real sp__capped_column(sp__capped *o)
{
    const sp_real low = o->low * o->low * o->lower, high = o->high * o->high * o->upper, x = o->W.w[1], y = o->W.w[2];
    sp_real e = 0, cone = 0;                            /* cone, low, high: what (mu b0 + C)^2, (b0 + T)^2, (N - b0)^2 weigh */
    if (o->cone > 0) {
        e = 1 / (1 + 2 * (x * x + y * y));
        cone = o->cone / o->W.s * (o->cone / o->W.s) * e;
    }
    const sp_real p = o->cone * o->D[0] * (low * (o->C - o->mu * o->T) + high * (o->C + o->mu * o->N));
    const sp_real q = 2 * o->W.w[0] * e * p, left = o->cone > 0 ? e * p / (o->W.s * o->W.s) * p : 0;
    o->b[0] = -o->D[0] * (cone * o->mu * o->C + low * o->T - high * o->N);
    o->rest[0] = p;
    o->rest[3] = o->low * o->D[0] * (high * (o->N + o->T) - cone * o->mu * (o->C - o->mu * o->T));
    o->rest[4] = o->high * o->D[0] * (low * (o->N + o->T) + cone * o->mu * (o->C + o->mu * o->N));
    for (int k = 1; k < 3; k++) {
        o->rest[k] = o->cone > 0 ? q * o->W.w[k] : 0;
        o->b[k] = o->cone > 0 ? o->rest[k] / o->cone : 0;
    }
    return left + o->lower * o->rest[3] * o->rest[3] + o->upper * o->rest[4] * o->rest[4];
}

/* Scaling, D and column of a vertex, its rates u by S.     returns 0: that was all, or it is outside */
SP__NOINLINE static int sp__capped_begin(sp__system *w, sp__ipm *m, int32_t c, int32_t v)
{
    sp__capped *o = m->capped;
    sp_real (*u)[3] = sp__visit_of(w)->u, *g = sp__visit_of(w)->f;
    const sp_real *x = m->x + SP__CAPPED * (size_t)v, S = m->force_scale * sp__system_scale(w, c);
    g[0] = g[1] = g[2] = 0;
    if (!sp__capped_scaling(o, x + 3, x + 8)) { m->outside = 1; return 0; }
    for (int k = 0; k < 3; k++) for (int q = 0; q < 3; q++) u[k][q] *= S;
    const sp_real least = sp__capped_column(o);
    if (m->pass != SP__COLUMN) return 1;
    o->bend -= sp__system_multiplicity(w, v) * least;
    sp__scale3(S, o->b, g);
    return 0;
}

/* What the rows miss and what resists; from the predicted changes what the right-hand side aims at. */
SP__NOINLINE static void sp__capped_residuals(sp__ipm *m, const sp_real *x, sp_real u[3][3])
{
    sp__capped *o = m->capped;
    sp__capped_slack(o, x, m->tau, o->miss);
    for (int k = 0; k < 5; k++) o->miss[k] -= x[3 + k];
    memcpy(o->resist, u[0], sizeof o->resist);
    sp__capped_gather(o, x + 8, o->resist);
    if (m->corrected) sp__capped_predicted(o, x + 8, u[1]);
}

/* g of a pass that aims, or the step of one that moves. */
SP__NOINLINE static void sp__capped_move(sp__system *w, sp__ipm *m, int32_t c, int32_t v)
{
    sp_real (*u)[3] = sp__visit_of(w)->u, *g = sp__visit_of(w)->f;
    sp__capped *o = m->capped;
    sp_real *x = m->x + SP__CAPPED * (size_t)v, *t = o->t, *change = o->change;
    const sp_real S = m->force_scale * sp__system_scale(w, c), keep = 1 - m->sigma, times = sp__system_multiplicity(w, v);
    for (int k = 0; k < 5; k++) o->dz[k] = keep * o->miss[k];
    sp__capped_divide(o, o->dz);
    for (int k = 0; k < 5; k++) change[k] -= o->dz[k];
    sp__scale3(keep, o->resist, t);
    sp__capped_gather(o, change, t);
    if (m->pass == SP__AIM) {
        o->offset += times * (sp__dot(o->rest, change, 5) + keep * sp__dot3(o->b, o->resist));
        sp__capped_change(o, t, -keep * m->tau, g);
        for (int k = 0; k < 3; k++) g[k] = -S * (keep * x[k] + g[k]);
        return;
    }
    for (int k = 0; k < 3; k++) t[k] += u[2][k];
    sp__capped_change(o, t, m->dtau, o->dx);
    sp__capped_slack(o, o->dx, m->dtau, o->ds);
    memcpy(o->dz, o->ds, sizeof o->dz);
    sp__capped_divide(o, o->dz);
    for (int k = 0; k < 5; k++) { o->dz[k] = change[k] - o->dz[k]; o->ds[k] += keep * o->miss[k]; }
    sp__capped_go(m, x);
}

/* One vertex of a pass; visit->u: rates of y, predictor and step. visit->f: what Aeq of the right-hand side has to make up for,
 * or S b. */
SP__NOINLINE static void sp__capped_vertex(sp__system *w, sp__ipm *m, int32_t c, int32_t v)
{
    const sp_real *x = m->x + SP__CAPPED * (size_t)v;
    if (!sp__capped_begin(w, m, c, v)) return;
    sp__capped_residuals(m, x, sp__visit_of(w)->u);
    sp__capped_aim(m, x + 3, x + 8);
    sp__capped_move(w, m, c, v);
}

/* x = (1, 0, 0), s = z = e. */
SP__NOINLINE static void sp__capped_start(sp__system *w, sp__ipm *m)
{
    sp__capped *o = m->capped;
    o->count = 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        sp__capped_rows(w, c);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real *x = m->x + SP__CAPPED * (size_t)v;
            for (int k = 0; k < SP__CAPPED; k++) x[k] = k == 0;
            x[3] = x[8] = o->cone > 0;
            x[6] = x[11] = o->low > 0;
            x[7] = x[12] = o->high > 0;
            o->count += sp__system_multiplicity(w, v) * (x[3] + x[6] + x[7]);
        }
    }
}

#endif

#endif /* SP__STATICS_CAPPED_C */
