/* offer: from forces and a motion that nearly agree to a triple for the certificate check.
 *
 *     df = -D Aeq' z,   Aeq D Aeq' z = Aeq f + p,   D: how each corner's force may change along its slip
 */
#ifndef SP__COUPLED_OFFER_C
#define SP__COUPLED_OFFER_C

#include "springs.c"

#if SP__WITH_COUPLED

/* Forces are laid along the slips: df = -D Aeq' z where Aeq D Aeq' z = Aeq f + p; D of a vertex that presses, of one whose
 * friction is free in size, of one at the rim of its cone.     returns 0 when a force changes its sign */
SP__NOINLINE static int sp__cra_align(sp__cra *c)
{
    sp__system *w = c->w;
    for (int round = 0; round < 4; round++) {
        sp__cra_balance(c, c->spring.f, 1);
        if (!round) sp__system_factor(w, SP__GIVEN, w->y, SP__SHIFT);
        sp__system_solve(w, w->r, w->d);
        for (int32_t q = 0; q < c->pb->contacts; q++) {
            const sp_contact *t = &c->pb->contact[q];
            sp_real *V = sp__visit_of(w)->twist[0], *W = V + 3, *u = sp__visit_of(w)->u[0];
            sp__system_twist(w, t, w->d, V, W);
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                const sp_real *D = c->spring.D + 6 * (size_t)v;
                sp_real *f = c->spring.f + 3 * (size_t)v;
                if (!(f[0] > 0)) continue;
                sp__system_rate(w, V, W, c->pb->local[v], u);
                f[0] -= D[0] * u[0] + D[1] * u[1] + D[2] * u[2];
                f[1] -= D[1] * u[0] + D[3] * u[1] + D[4] * u[2];
                f[2] -= D[2] * u[0] + D[4] * u[1] + D[5] * u[2];
                if (!(f[0] > 0) || f[1] * c->spring.d[3 * (size_t)v + 1] + f[2] * c->spring.d[3 * (size_t)v + 2] > 0) return 0;
            }
        }
    }
    return 1;
}

/* How each vertex's force may change: none where it is open, along n, along the slip, along both at the rim of the cone.
 * Friction whose slip is too short is dropped. */
SP__NOINLINE static void sp__cra_freedoms(sp__cra *c)
{
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__cra_sbar(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            sp_real *f = c->spring.f + 3 * v, *D = c->spring.D + 6 * v;
            const sp_real *d = c->spring.d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
            const sp_real reach = sp__cra_friction(c, t, d);
            const sp_real ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
            const sp_real wn = sp__max(sp__max(f[0], ft) / c->sbar_most, (sp_real)1e-6 * s / c->sbar_most);
            const int rubs = ft > 0 && slip > 2 * SP__SLIP, rim = rubs && ft >= (1 - (sp_real)1e-6) * reach * f[0];
            const sp_real x = rubs ? -d[1] / slip : 0, y = rubs ? -d[2] / slip : 0;
            const sp_real wt = rim ? wn * reach * reach : rubs ? wn : 0, cross = rim ? wn * reach : 0;
            if (!rubs && ft > 100 * SP__TINY_FORCE * s) c->offer.tiny = 1;
            D[0] = f[0] > 0 ? wn : 0;
            D[1] = cross * x; D[2] = cross * y;
            D[3] = wt * x * x; D[4] = wt * x * y; D[5] = wt * y * y;
            f[1] = (rim ? reach * f[0] : ft) * x;
            f[2] = (rim ? reach * f[0] : ft) * y;
        }
    }
}

/* A triple in the plane as one in space: motions out of the axes e, f and alpha of mirrored corners those of their images. */
static void sp__cra_to_space(const sp__cra *c)
{
    const sp__reduction *o = sp__reduced(c->w);
    if (!o) return;
    sp__reduction_to_space(c->w, c->offer.t.dq);
    sp__reduction_copy_forces(o, c->pb, c->offer.t.f);
    for (int32_t v = 0; v < c->pb->points; v++) c->offer.t.alpha[v] = c->offer.t.alpha[o->image[v] < v ? o->image[v] : v];
}

/* The triple in metres and newtons.     returns 1 when it is verified */
SP__NOINLINE static int sp__cra_offer(sp__cra *c)
{
    const sp__system *w = c->w;
    for (size_t k = 0; k < 6 * (size_t)c->pb->blocks; k++) c->offer.t.dq[k] = c->k.L * w->measure.weight[k / 3] * w->y[k];
    memset(c->offer.t.f, 0, 3 * (size_t)c->pb->points * sizeof *c->offer.t.f);
    memset(c->offer.t.alpha, 0, (size_t)c->pb->points * sizeof *c->offer.t.alpha);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real *f = c->spring.f + 3 * v, *d = c->spring.d + 3 * v;
            const sp_real slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
            sp__to_newtons(w->measure.unit, 3, f, c->offer.t.f + 3 * v);
            if (slip > 0) c->offer.t.alpha[v] = sp__in_newtons(w->measure.unit / c->k.L, ft / slip);
        }
    }
    sp__cra_to_space(c);
    if (!sp__system_spend(c->w, 2 * SP__FLOPS_CERTIFICATE * (int64_t)c->pb->points)) return 0;
    c->offer.imbalance = sp__certify_forces(&c->j, c->offer.t.f, c->offer.t.f);
    c->offer.residual = sp__certify_coupled(&c->j, &c->k, c->offer.t.f, c->offer.t.dq, c->offer.t.alpha);
    c->offer.made = 1;
    return c->offer.imbalance <= c->set->tol && c->offer.residual <= 1;
}

/* Forces and slips agree to some digits: the rest of the digits.     returns 1 when a triple is verified */
SP__NOINLINE static int sp__cra_polish(sp__cra *c)
{
    memcpy(c->descent.from, c->w->y, 6 * (size_t)c->pb->blocks * sizeof *c->descent.from);
    c->offer.tiny = 0;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__cra_sbar(c, t);
        for (int32_t v = t->point; v < t->point + t->points; v++)
            if (c->spring.f[3 * (size_t)v] <= SP__TINY_FORCE * s)
                memset(c->spring.f + 3 * (size_t)v, 0, 3 * sizeof *c->spring.f);
    }
    sp__cra_move_to_contact(c);
    sp__cra_freedoms(c);
    return sp__cra_align(c) && sp__cra_offer(c);
}

#endif

#endif /* SP__COUPLED_OFFER_C */
