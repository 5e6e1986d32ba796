/* interior: a homogeneous self-dual interior-point method, where Newton stalls. [Nesterov, Todd 1997; Ye, Todd, Mizuno 1994] */
#ifndef SP__STATICS_INTERIOR_C
#define SP__STATICS_INTERIOR_C

#include "newton.c"

#if SP__WITH_LARGE

/* Newton stalls with thousands of joints about to slide or open at once. Forces f = E x of any size (E: sp__ipm_edge):
 *
 *   Aeq E x + tau p = theta r0,  z + E' Aeq' y = theta e,  kappa + p.y = k theta,  x o z = mu e,  tau kappa = k mu,
 *
 * x, z in cones, from x = z = e, y = 0, tau = theta = mu = 1, kappa = k down to theta = mu = 0: the homogeneous self-dual
 * embedding of "is there an f". Then f = E x / tau balances p, or no contact resists dq = -y while the load does work kappa: of
 * all such motions the centre, with k / (k + number of cones) of the most work there is; so k is not 1, and late, where little
 * work has to do for a proof, more than there are cones. A step factorises Aeq E W^2 E' Aeq', the same blocks as Newton's; z is
 * never stored. In 3 rows a block K is a wedge, two half lines, one where joints are level (sp__ipm_sides). Mostly it ends long
 * before that: when the least change of x, in the metric of W, that balances p is admissible, or the least change of y after
 * which nothing resists is a proof.
 *                                  [Ye, Todd, Mizuno 1994; Nesterov, Todd 1997; Mehrotra 1992; Andersen, Roos, Terlaky 2003] */

/* Where copy k of the targets is, from x on: each has as many numbers as x. */
static size_t sp__ipm_copy(const sp__system *w, int k)
{
    return (size_t)k * (size_t)w->pb->points * sp__ipm_numbers(w);
}

/* Is a pass without a step of its own? It makes a right-hand side. */
static int sp__ipm_aims(sp__pass pass) { return pass == SP__AIM || pass == SP__COLUMN || pass == SP__CENTRE; }

/* Are the targets of a step kept, and made? */
static int sp__ipm_has_targets(const sp__ipm *m) { return m->corrected && m->kept && m->pass != SP__AIM; }

/* h of a cone: -x, or W a - x, a of sp__soc_product, the predictor in u. */
static void sp__ipm_target(const sp__ipm *m, const sp_real *x, const sp_real u[3], const sp__nt *W, sp__visit *s)
{
    sp_real *h = s->h, *a = s->edge;
    for (int k = 0; k < 3; k++) h[k] = -x[k];
    if (!m->corrected) return;
    for (int k = 0; k < 3; k++) h[k] = u[k];
    h[0] += m->theta;
    sp__scale3(-1, h, s->dz);
    sp__soc_square(W, h);
    sp__sub3(h, x, h);
    sp__soc_product(W, s->z, h, s->dz, m->sigma * m->mu, a);
    sp__soc_scale(W, a, 0, h);
    sp__sub3(h, x, h);
}

/* h of a cone as it was kept, the step in u. CENTRE: and what brings the products of a step m->reach long back to the centre,
 * for the next.                                                                                            [Gondzio 1996] */
SP__NOINLINE static void sp__ipm_kept(const sp__system *w, const sp__ipm *m, sp_real *x, const sp_real u[3], const sp__nt *W)
{
    sp__visit *s = sp__visit_of(w);
    const sp_real t = m->reach;
    sp_real *h = s->h, *xt = s->edge, *zt = s->rate;
    memcpy(h, x + sp__ipm_copy(w, m->kept), 3 * sizeof *h);
    if (m->pass != SP__CENTRE) return;
    for (int k = 0; k < 3; k++) xt[k] = u[k];
    xt[0] += (1 - m->sigma) * m->theta;                                     /* -dz */
    for (int k = 0; k < 3; k++) zt[k] = s->z[k] - t * xt[k];
    sp__soc_square(W, xt);
    for (int k = 0; k < 3; k++) xt[k] = x[k] + t * (h[k] + xt[k]);
    sp__soc_centre(W, s->z, xt, zt, m->sigma * m->mu, s->D, s->D + 3, h);
    memcpy(x + sp__ipm_copy(w, 3 - m->kept), h, 3 * sizeof *h);
}

/* One cone, E' Aeq' of y, predictor and step in u: dz = -(1 - sigma) theta e - u[2], dx = h - W^2 dz, h of cone/ipm.c.
 * AIM, CENTRE, with no step yet: g = -(1 - sigma) x - dx, what Aeq E of the step has to make up for. */
SP__NOINLINE static void sp__ipm_cone(const sp__system *w, sp__ipm *m, sp_real *x, sp_real u[3][3], sp_real g[3])
{
    sp__visit *s = sp__visit_of(w);
    sp__nt W;
    const sp_real keep = 1 - m->sigma;
    sp_real *h = s->h, *z = s->z, *dz = s->dz;
    sp__scale3(-1, u[0], z);
    z[0] += m->theta;
    if (!sp__soc_scaling(x, z, &W)) { m->outside = 1; return; }
    if (sp__ipm_has_targets(m)) sp__ipm_kept(w, m, x, u[2], &W);
    else sp__ipm_target(m, x, u[1], &W, s);
    if (m->kept && m->corrected && m->pass == SP__AIM) memcpy(x + sp__ipm_copy(w, m->kept), h, 3 * sizeof *h);
    for (int k = 0; k < 3; k++) g[k] = sp__ipm_aims(m->pass) ? 0 : u[2][k];
    g[0] += keep * m->theta;
    sp__scale3(-1, g, dz);
    sp__soc_square(&W, g);
    for (int k = 0; k < 3; k++) g[k] += h[k];                               /* dx */
    if (m->pass == SP__REACH) m->reach = sp__soc_step(z, dz, sp__soc_step(x, g, m->reach));
    for (int k = 0; k < 3; k++) {
        if (m->pass == SP__MOVE) x[k] += m->reach * g[k];
        g[k] = -(keep * x[k] + g[k]);
    }
}

/* One edge of a pyramid, as sp__ipm_cone does a cone; here W^2 = x / z. share: of e; the two sides of a wedge have half
 * each, else it is 1. */
static sp_real sp__ipm_ray(const sp__system *w, sp__ipm *m, sp_real share, sp_real *x, const sp_real u[3])
{
    const sp_real keep = 1 - m->sigma, theta = share * m->theta, z = theta - u[0], s = *x / z, aim = share * m->sigma * m->mu;
    sp_real h = -*x;
    if (sp__ipm_has_targets(m)) h = x[sp__ipm_copy(w, m->kept)];
    else if (m->corrected) {
        const sp_real dz = -theta - u[1], dx = -*x - s * dz;
        h += (aim - dx * dz) / z;
        if (m->kept) x[sp__ipm_copy(w, m->kept)] = h;
    }
    if (m->pass == SP__CENTRE) {
        const sp_real dz = -keep * theta - u[2], dx = h - s * dz;
        h += sp__centred((*x + m->reach * dx) * (z + m->reach * dz), aim) / z;
        x[sp__ipm_copy(w, 3 - m->kept)] = h;
    }
    const sp_real dz = -keep * theta - (sp__ipm_aims(m->pass) ? 0 : u[2]), dx = h - s * dz;
    if (m->pass == SP__REACH) m->reach = sp__ray_step(z, dz, sp__ray_step(*x, dx, m->reach));
    if (m->pass == SP__MOVE) *x += m->reach * dx;
    return -(keep * *x + dx);
}

/* The edges of a vertex's pyramid. */
SP__NOINLINE static void sp__ipm_rays(const sp__system *w, sp__ipm *m, int32_t c, int32_t v, sp_real u[3][3], sp_real g[3])
{
    sp_real *x = m->x + (size_t)w->law.cone.faces * (size_t)v, *e = sp__visit_of(w)->edge, *rate = sp__visit_of(w)->rate;
    const sp_real n = sp__ipm_normal(w, c), mu = sp__system_mu(w, c), h = mu * w->law.cone.tan_half;
    for (int32_t k = 0; k < w->law.cone.faces; k++) {
        sp__ipm_edge(n, mu, h, w->law.cone.direction[k], e);
        for (int q = 0; q < 3; q++) rate[q] = sp__dot3(e, u[q]);
        const sp_real a = sp__ipm_ray(w, m, 1, x + k, rate);
        for (int q = 0; q < 3; q++) g[q] += a * e[q];
    }
}

/* The sides of its wedge; rates and g have two numbers. */
SP__NOINLINE static void sp__ipm_wedge(const sp__system *w, sp__ipm *m, int32_t v)
{
    const int32_t sides = (int32_t)sp__ipm_numbers(w);
    sp__visit *s = sp__visit_of(w);
    sp_real (*u)[3] = s->u, *g = s->f, *x = m->x + (size_t)sides * (size_t)v, *e = s->edge, *rate = s->rate;
    g[0] = g[1] = g[2] = 0;
    for (int32_t k = 0; k < sides; k++) {
        for (int q = 0; q < 3; q++) rate[q] = e[0] * u[q][0] + e[1 + k] * u[q][1];
        const sp_real a = sp__ipm_ray(w, m, sp__ipm_share(w), x + k, rate);
        g[0] += a * e[0];
        g[1] += a * e[1 + k];
    }
}

/* One vertex: its cone or the edges of its pyramid. g is a force. */
SP__NOINLINE static void sp__ipm_vertex(const sp__system *w, sp__ipm *m, int32_t c, int32_t v)
{
    sp_real (*u)[3] = sp__visit_of(w)->u, *g = sp__visit_of(w)->f;
    g[0] = g[1] = g[2] = 0;
    if (w->law.cone.faces) { sp__ipm_rays(w, m, c, v, u, g); return; }
    const sp_real S = m->force_scale * sp__system_scale(w, c), T = S * sp__system_mu(w, c);
    for (int k = 0; k < 3; k++) { u[k][0] *= S; u[k][1] *= T; u[k][2] *= T; }
    sp__ipm_cone(w, m, m->x + 3 * (size_t)v, u, g);
    g[0] *= S; g[1] *= T; g[2] *= T;
}

/* A contact as interior points see it: in two numbers a vertex only where all are. */
static sp__view sp__ipm_view(const sp__system *w, int32_t c)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp__view k = { t, c, sp__ipm_narrow(w) ? sp__reduction_frame(w, t) : NULL };
    return k;
}

/* One pass over all vertices. AIM: r = Aeq g, the right-hand side but for -(1 - sigma) tau p; it has no step yet, and what is
 * not corrected no predictor: those rates are 0. */
SP__NOINLINE static void sp__ipm_sweep(sp__system *w, sp__ipm *m, sp__pass pass, sp_real *r)
{
    const sp_problem *pb = w->pb;
    m->pass = pass;
    const int gathers = sp__ipm_aims(pass), targets = sp__ipm_has_targets(m);
    const int counts[3] = { 1, m->corrected && !targets, !gathers || pass == SP__CENTRE }, rates = 1 + counts[1] + counts[2];
    if (!sp__system_sweep(w, rates, rates)) return;
    if (gathers) memset(r, 0, 6 * (size_t)pb->blocks * sizeof *r);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp__view view = sp__ipm_view(w, c);
        sp__visit *s = sp__visit_of(w);
        sp_real (*u)[3] = s->u, *g = s->f, *Y = s->sum;
        if (m->capped) sp__capped_rows(w, c);
        if (view.g) sp__ipm_sides(w, c, view.g);
        for (int k = 0; k < 3; k++) {
            Y[k] = Y[3 + k] = u[k][0] = u[k][1] = u[k][2] = 0;
            if (counts[k]) sp__view_motion(w, &view, m->along[k], s->twist[k]);
        }
        for (int32_t v = view.t->point; v < view.t->point + view.t->points; v++) {
            if (!(sp__system_multiplicity(w, v) > 0)) continue;
            const sp_real *place = sp__view_place(w, &view, pb->local[v]);
            for (int k = 0; k < 3; k++)
                if (counts[k]) sp__view_rates(w, &view, place, s->twist[k], u[k]);
            if (m->capped) sp__capped_vertex(w, m, c, v);
            else if (view.g) sp__ipm_wedge(w, m, v);
            else sp__ipm_vertex(w, m, c, v);
            sp__scale3(sp__system_multiplicity(w, v), g, g);
            if (gathers) sp__view_gather(w, &view, place, g, Y);
        }
        if (gathers) sp__view_scatter(w, &view, Y, r);
    }
    if (gathers) sp__system_release(w, r);
}

/* g = P_K(f - D u), K = S yield; g may be f. */
static void sp__ipm_change(const sp__system *w, sp_real S, const sp_real D[6], const sp_real u[3], const sp_real f[3],
                           sp_real g[3])
{
    const sp__yield *yield = w->law.yield;
    const sp_real a = f[0] - (D[0] * u[0] + D[1] * u[1] + D[2] * u[2]), b = f[1] - (D[1] * u[0] + D[3] * u[1] + D[4] * u[2]);
    g[2] = f[2] - (D[2] * u[0] + D[4] * u[1] + D[5] * u[2]);
    g[0] = a; g[1] = b;
    if (!yield->plain) sp__scale3(1 / S, g, g);
    sp__cone_project(&w->law.cone, yield, g, g);
    if (!yield->plain) sp__scale3(S, g, g);
}

/* Forces of the live loads alone: is this a vertex that only others press, W^2 < 1, so x -> 0? What x is left there would have
 * to balance stones that nothing else holds. */
static int sp__ipm_idle(const sp__system *w, const sp__ipm *m, int32_t c, const sp_real D[6])
{
    const sp_real S = m->force_scale * sp__system_scale(w, c);
    return m->ray && D[0] < S * S;
}

/* Force and D of a vertex in Newton's y. */
static void sp__ipm_of_newton(sp__system *w, const sp__view *view, const sp_real *u, sp_real D[6], sp_real g[3])
{
    g[2] = 0;
    if (view->g) { sp__wedge_law(w, SP__ADMISSIBLE, view->c, view->g, u, g, D); return; }
    sp__system_force(w, view->c, w->law.yield, u, g);
    if (!sp__vertex_slope(w, SP__ADMISSIBLE, view->c, u, D)) memset(D, 0, 6 * sizeof *D);
}

/* f <- P_K(f - D Aeq' d), D = E W^2 E', in units; first: f <- P_K(E x / tau). m NULL: D = S DP_K and f = S P_K of Newton's y:
 * a y of a thousand times the forces' size has lost their last digits. Then r = Aeq f + p. Changes add up in f, not in d: a
 * large d, most of it a motion that hardly anything resists, would hide small ones. */
SP__NOINLINE static void sp__ipm_balance(sp__system *w, const sp__ipm *m, int first, const sp_real *d, sp_state *state)
{
    const sp_problem *pb = w->pb;
    if (!sp__system_sweep(w, 3, 2)) return;
    sp__system_load(w, w->r);
    memset(w->carried, 0, 3 * (size_t)pb->blocks * sizeof *w->carried);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp__view view = sp__ipm_view(w, c);
        sp__visit *s = sp__visit_of(w);
        sp_real *u = s->u[0], *D = s->D, *g = s->f, *Y = s->sum;
        if (!view.g) sp__system_yield(w, c);
        if (m && m->capped) sp__capped_rows(w, c);
        if (m && view.g) sp__ipm_sides(w, c, view.g);
        sp__view_motion(w, &view, w->y, s->twist[0]);
        sp__view_motion(w, &view, d, s->twist[1]);
        for (int k = 0; k < 6; k++) Y[k] = 0;
        for (int32_t v = view.t->point; v < view.t->point + view.t->points; v++) {
            sp_real *f = state->f + 3 * (size_t)v;
            if (!(sp__system_multiplicity(w, v) > 0)) continue;
            const sp_real *place = sp__view_place(w, &view, pb->local[v]);
            sp__view_rates(w, &view, place, s->twist[0], u);
            if (!m) sp__ipm_of_newton(w, &view, u, D, g);
            else if (view.g) sp__ipm_by_sides(w, v, u, D, g);
            else sp__ipm_derivative(w, c, v, u, D, g);
            if (m && sp__ipm_idle(w, m, c, D)) { memset(f, 0, 3 * sizeof *f); continue; }
            if (first) sp__scale3(m ? 1 / m->tau : 1, g, f);
            sp__view_rates(w, &view, place, s->twist[1], u);
            if (view.g) sp__wedge_change(w, c, view.g, D, u, f, f);
            else sp__ipm_change(w, sp__system_scale(w, c), D, u, f, f);
            sp__scale3(sp__system_multiplicity(w, v), f, g);
            sp__view_gather(w, &view, place, g, Y);
            sp__view_widen(w, &view, g, s->m);
            sp__carry_add(w, view.t, pb->local[v], s->m, sp__view_norm(&view, g));
        }
        sp__view_scatter(w, &view, Y, w->r);
    }
    sp__system_release(w, w->r);
}

/* Forces of wedges as (fn, ft1, ft2). */
SP__NOINLINE static void sp__ipm_widen(const sp__system *w, sp_real *f)
{
    for (int32_t c = 0; c < w->pb->contacts && sp__ipm_narrow(w); c++) {
        const sp__view k = sp__ipm_view(w, c);
        for (int32_t v = k.t->point; v < k.t->point + k.t->points; v++)
            if (sp__system_multiplicity(w, v) > 0) sp__wedge_widen(w, k.g, f + 3 * (size_t)v, f + 3 * (size_t)v);
    }
}

/* Where twice the same share of the imbalance is left, the step w->d is made so long that none would be; *share is 0 then.
 *                                                                                                              [Aitken 1926] */
SP__NOINLINE static void sp__ipm_leap(const sp__system *w, sp_real left, sp_real *share)
{
    const int same = sp__abs(left - *share) < (sp_real)0.05 * left && left > (sp_real)0.1 && left < (sp_real)0.95;
    *share = same ? 0 : left;
    for (size_t k = 0; same && k < 6 * (size_t)w->pb->blocks; k++) w->d[k] /= 1 - left;
}

/* Does the least change of x (m NULL: of Newton's forces) that balances leave the forces admissible? What is not is projected
 * and the rest balanced again while that gains. Then state->f holds them. */
SP__NOINLINE static void sp__ipm_forces(sp__system *w, const sp__ipm *m, sp__newton *n, sp_state *state)
{
    sp_real last = SP__HUGE, strict = SP__HUGE, share = 0;
    int more = 8;                                       /* once balanced: lightly loaded blocks come to rest last */
    memset(w->d, 0, 6 * (size_t)w->pb->blocks * sizeof *w->d);
    for (int it = 0; ; it++) {
        sp__carry_begin(w);
        sp__ipm_balance(w, m, it == 0, w->d, state);
        const sp_real left = sp__system_imbalance(w, w->r) / strict;        /* by what the forces themselves put on a block */
        strict *= left;
        w->carried = NULL;
        if (w->budget.spent) return;
        n->imbalance = sp__system_imbalance(w, w->r);
        const int slow = share > 0 && n->imbalance > SP__GAIN * last && left > SP__GAIN;
        const int vain = m && it == 0 && n->imbalance > SP__NO_START;
        if (it == 60 || vain || sp__newton_close(w, strict) || (slow && (last > n->goal || left >= 1 || !more--))) break;
        last = n->imbalance;
        sp__system_solve(w, w->r, w->d);
        sp__ipm_leap(w, left, &share);
    }
    n->imbalance = strict;
    if (strict > SP__ENOUGH * w->set->tol) return;
    sp__ipm_widen(w, state->f);
    sp__to_newtons(w->measure.unit, 3 * (size_t)w->pb->points, state->f, state->f);
    n->best = strict;
    n->found = 1;
}

/* Work that x does along the column of tau. */
static sp_real sp__ipm_work(const sp__system *w, const sp__ipm *m, const sp_real *x)
{
    return m->capped ? sp__dot(w->load, x, 6 * (size_t)w->pb->blocks) : sp__system_work(w, x);
}

/* kappa + p.y, with strength + h.z: what is left of the last equation. */
static sp_real sp__ipm_rest(const sp__system *w, const sp__ipm *m)
{
    return m->kappa + sp__system_work(w, w->y) + (m->capped ? m->capped->held : 0);
}

/* What of the change of h.z does not come through y: with no change of tau, and for each unit of it. */
static sp_real sp__ipm_offset(const sp__ipm *m) { return m->capped ? m->capped->offset : 0; }
static sp_real sp__ipm_bend(const sp__ipm *m) { return m->capped ? m->capped->bend : 0; }

/* Changes of tau and kappa, from the step w->r of y that leaves tau alone and state->dq = dy / dtau. */
static void sp__ipm_homogeneous(const sp__system *w, sp__ipm *m, const sp_state *state, sp_real product)
{
    const sp_real rest = sp__ipm_rest(w, m), keep = 1 - m->sigma, other = sp__ipm_offset(m) + sp__ipm_work(w, m, w->r);
    const sp_real c = m->tau * m->kappa + product - m->sigma * m->kappa_weight * m->mu;
    m->dtau = (c / m->tau - keep * rest - other) / (sp__ipm_work(w, m, state->dq) + sp__ipm_bend(m) - m->kappa / m->tau);
    m->dkappa = -(c + m->kappa * m->dtau) / m->tau;
}

/* Longest step along m->along[2] that stays inside. */
static void sp__ipm_reach(sp__system *w, sp__ipm *m)
{
    m->reach = 1000;
    sp__ipm_sweep(w, m, SP__REACH, NULL);
    m->reach = sp__ray_step(m->kappa, m->dkappa, sp__ray_step(m->tau, m->dtau, m->reach));
}

/* out = the column of tau: p, with strength p + Aeq b, which w->load keeps. */
static void sp__ipm_column(sp__system *w, sp__ipm *m, sp_real *out)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp__system_load(w, out);
    if (!m->capped) return;
    m->capped->bend = 0;
    sp__ipm_sweep(w, m, SP__COLUMN, w->load);
    sp__system_axpy(w, 1, out, w->load);
    memcpy(out, w->load, size * sizeof *out);
}

/* state->dq = dy / dtau; w->d = the least change of y in the metric of W after which no contact resists. With so much of
 * dy / dtau that the load's work is kappa it is tried as a proof. */
SP__NOINLINE static void sp__ipm_motion(sp__system *w, sp__ipm *m, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    m->corrected = 0;
    m->sigma = 0;
    sp__ipm_column(w, m, state->dq);
    for (size_t k = 0; k < size; k++) state->dq[k] = -state->dq[k];
    sp__system_solve(w, state->dq, state->dq);
    if (m->capped) m->capped->offset = 0;
    sp__ipm_sweep(w, m, SP__AIM, w->d);
    sp__system_solve(w, w->d, w->d);
    const sp_real pulls = -sp__ipm_work(w, m, state->dq) - sp__ipm_bend(m);
    if (!(pulls > 0)) return;
    const sp_real share = (sp__ipm_rest(w, m) + sp__ipm_offset(m) + sp__ipm_work(w, m, w->d)) / pulls;
    for (size_t k = 0; k < size; k++) w->r[k] = w->y[k] + w->d[k] + share * state->dq[k];
    sp__newton_record_proof(w, n, w->r, state);
}

/* Predictor and corrector with the factor at hand, from what sp__ipm_motion left in w->d and state->dq. */
SP__NOINLINE static void sp__ipm_step(sp__system *w, sp__ipm *m, const sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    for (size_t k = 0; k < n; k++) w->r[k] = w->d[k] + m->tau * state->dq[k];
    sp__ipm_homogeneous(w, m, state, 0);
    sp__system_axpy(w, m->tau + m->dtau, state->dq, w->d);
    m->along[1] = m->along[2] = w->d;
    sp__ipm_reach(w, m);
    const sp_real left = 1 - (m->reach < 1 ? m->reach : 1), product = m->dtau * m->dkappa;
    m->corrected = 1;
    m->sigma = left * left * left;
    if (m->capped) { m->capped->before = m->dtau; m->capped->offset = 0; }
    sp__ipm_sweep(w, m, SP__AIM, w->r);
    sp__system_solve(w, w->r, w->r);
    sp__system_axpy(w, (1 - m->sigma) * m->tau, state->dq, w->r);
    sp__ipm_homogeneous(w, m, state, product);
    sp__system_axpy(w, m->dtau, state->dq, w->r);
    m->along[2] = w->r;
    sp__ipm_reach(w, m);
    m->reach *= SP__IPM_KEEP;
    if (m->reach > 1) m->reach = 1;
    sp__ipm_sweep(w, m, SP__MOVE, NULL);
    sp__system_axpy(w, m->reach, w->r, w->y);
    m->tau += m->reach * m->dtau;
    m->kappa += m->reach * m->dkappa;
    m->theta *= 1 - m->reach * (1 - m->sigma);
}

/* Cones of all vertices; a wedge is one. */
static sp_real sp__ipm_cones(const sp__system *w)
{
    return (sp_real)w->pb->points * (sp_real)(sp__ipm_narrow(w) || !w->law.cone.faces ? 1 : w->law.cone.faces);
}

/* x = z = e, y = 0. force_scale is a quarter of the forces at an average block. */
static void sp__ipm_start(sp__system *w, sp__ipm *m)
{
    const size_t numbers = sp__ipm_numbers(w) * (size_t)w->pb->points;
    const int edges = sp__ipm_narrow(w) || w->law.cone.faces;
    memset(w->y, 0, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    for (size_t k = 0; k < numbers && !m->capped; k++) m->x[k] = edges || k % 3 == 0;
    m->force_scale = 0;
    for (int32_t i = 0; i < w->pb->blocks; i++) m->force_scale += w->measure.size[2 * (size_t)i] / (4 * (sp_real)w->pb->blocks);
    if (w->measure.metric > 0) m->force_scale = 1 / (4 * w->measure.metric);
    m->kept = 0;
    m->theta = m->tau = 1;
    m->kappa = m->kappa_weight;
    m->ray = 0;
    m->along[0] = m->along[1] = m->along[2] = w->y;
    w->inner = m;
    if (m->capped) sp__capped_start(w, m);
}

/* Leaves forces that balance (n->found), a proof (n->proved) or neither. m->x: 3 a vertex, faces of them for a pyramid.
 *   returns 1 where no other way gets farther: it falls, but within tol, as a pebble among boulders does; or too many
 *   steps one after the other got nowhere, for factors have too few digits, and tau, which forces keep, is not ahead of kappa:
 *   where it is, the proximal path mostly finds them, for its factors have more */
SP__NOINLINE static int sp__ipm_run(sp__system *w, sp__ipm *m, sp__newton *n, sp_state *state)
{
    sp_real cones = sp__ipm_cones(w);
    if (w->budget.spent) return 0;                      /* maybe before there were sizes */
    m->idle = m->again = 0;
    m->capped = sp__problem_strong(w->pb) ? w->capped : NULL;
    const int most = m->capped && !state->brief ? SP__IPM_PATIENT : SP__IPM_IDLE;
    m->kappa_weight = sp__max(1, cones / 10);
    sp__ipm_start(w, m);
    if (m->capped) cones = m->capped->count;
    for (int it = 0; it < SP__IPM_MOST && m->idle < most && sp__newton_work_left(w, n)
                     && m->theta > (sp_real)SP_EPSILON; it++) {
        m->gap = 0;
        m->outside = 0;
        if (m->capped) m->capped->reserve = 0;
        if (m->theta < SP__IPM_LATE) m->kappa_weight = 3 * cones;
        sp__system_factor(w, SP__INTERIOR, w->y, SP__IPM_SHIFT);
        if (w->budget.spent) break;
        n->left--;
        state->cost.iterations++;
        state->cost.interior++;
        if (m->outside && (!m->capped || m->again)) break;
        if (m->outside) {                               /* with strength rounding may lead out: once more, on another way */
            m->again = 1;
            m->kappa_weight = 3 * cones;
            sp__ipm_start(w, m);
            continue;
        }
        if (m->capped) m->capped->held = m->capped->reserve;
        m->mu = (m->gap + m->tau * m->kappa) / (cones + m->kappa_weight);
        sp__ipm_forces(w, m, n, state);
        if (n->found) return 0;
        sp__newton_record_proof(w, n, w->y, state);
        if (!n->proved) sp__ipm_motion(w, m, n, state);
        if (n->proved || w->budget.spent) return 0;
        sp__ipm_step(w, m, state);
        m->idle = m->reach < SP__IPM_NOWHERE ? (int16_t)(m->idle + 1) : 0;
    }
    sp__newton_measure(w, n, state);
    if (m->idle == most) {                              /* y still shows what goes together, roughly */
        memcpy(w->d, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->d);
        sp__newton_try_rigid(w, n, SP__PLAY_IDLE, state);
    }
    n->falls = m->tau < SP__IPM_NONE && !(m->theta > (sp_real)SP_EPSILON);
    const int stands = m->tau > m->kappa && !state->brief;
    const int fell = n->falls && (SP__FELL_LAST || state->brief == SP__BRIEF_FELL);
    return SP__IPM_LAST && ((m->idle == most && !stands) || fell);
}

#endif

#endif /* SP__STATICS_INTERIOR_C */
