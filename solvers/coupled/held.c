/* held: forces under a given motion, corners that press and slip fixed by it: the penalty form in that motion, and the best of
 * such answers, kept for a scene that is not coupled. */
#ifndef SP__COUPLED_HELD_C
#define SP__COUPLED_HELD_C

#include "springs.c"

#if SP__WITH_COUPLED

/* The motion is held fast: what each vertex may carry in it.     returns 0 when it is none that the conditions allow */
SP__NOINLINE static int sp__cra_hold_motion(sp__cra *c)
{
    for (int deep = 1, round = 0; deep && round < 5; round++) {         /* what comes to lie too deep presses, too */
        deep = 0;
        sp__cra_move_to_contact(c);
        for (size_t v = 0; v < (size_t)c->pb->points; v++) {
            if (c->spring.d[3 * v] + c->k.eps >= -SP__GIVE) continue;
            deep = !(c->spring.f[3 * v] > 0);
            c->spring.f[3 * v] = 1;
        }
    }
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real *d = c->spring.d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), gap = d[0] + c->k.eps;
            const sp_real most = c->set->coupled.box ? sp__max(sp__abs(d[1]), sp__abs(d[2])) : slip;
            const int rubs = slip > 2 * SP__SLIP;
            if (gap < -SP__GIVE || sp__max(d[0], most) > c->k.eta) return 0;
            sp__held_vertex *h = &c->held.vertex[v];
            h->reach = gap > SP__GIVE ? -1 : rubs ? sp__cra_friction(c, t, d) : 0;
            h->against[0] = rubs ? -d[1] / slip : 0;
            h->against[1] = rubs ? -d[2] / slip : 0;
            h->per_slip = rubs ? 1 / slip : 0;
        }
    }
    return 1;
}

/* The best answer so far: forces, and the motion with its alpha. */
SP__NOINLINE static void sp__cra_record(sp__cra *c)
{
    const sp__system *w = c->w;
    const sp_real soft = 1 / c->set->penalty.gamma;
    c->held.least = -c->descent.energy;
    for (size_t k = 0; k < 6 * (size_t)c->pb->blocks; k++) c->offer.t.dq[k] = c->k.L * w->measure.weight[k / 3] * c->held.y[k];
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__cra_size(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real fm = s * soft * sp__max(c->spring.d[3 * v], 0), *f = c->spring.f + 3 * v;
            sp_real *to = c->out->penalty + 4 * (v + (size_t)t->joint->point - (size_t)t->point);
            const sp_real drag = sp__in_newtons(w->measure.unit / c->k.L, SP_SQRT(f[1] * f[1] + f[2] * f[2]));
            c->offer.t.alpha[v] = drag * c->held.vertex[v].per_slip;
            to[0] = c->held.vertex[v].reach < 0 ? 0 : sp__max(f[0] + fm, 0);
            to[1] = fm;
            to[2] = f[1];
            to[3] = f[2];
            sp__to_newtons(w->measure.unit, 4, to, to);
        }
    }
}

/* The penalty form in the motion at hand, put onto dn = -eps.     returns 1 when it is the best so far */
SP__NOINLINE static int sp__cra_try_motion(sp__cra *c)
{
    const size_t n = 6 * (size_t)c->pb->blocks;
    sp__system *w = c->w;
    if (!sp__cra_hold_motion(c)) return 0;
    memcpy(c->held.y, w->y, n * sizeof *w->y);
    memset(w->y, 0, n * sizeof *w->y);
    c->held.on = 1;
    c->descent.goal = SP__AGREE;
    const int balanced = sp__cra_descend(c) && sp__system_norm(w, w->r) <= SP__AGREE * w->measure.load;
    const int better = balanced && -c->descent.energy < c->held.least;
    if (better) sp__cra_record(c);
    c->held.on = 0;
    memcpy(w->y, c->held.y, n * sizeof *w->y);
    return better;
}

#endif

#endif /* SP__COUPLED_HELD_C */
