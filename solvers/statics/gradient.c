/* gradient: f(y) = S P_K(Aeq' y), the gradient Aeq f + p of D, its slope along a direction, and what blocks bear of f. */
#ifndef SP__STATICS_GRADIENT_C
#define SP__STATICS_GRADIENT_C

#include "map.c"

#if SP__WITH_LARGE

/* From now on gradients also sum what each block carries, in the memory of solutions, which are not needed meanwhile. */
static void sp__carry_begin(sp__system *w) { w->carried = w->L.t; }

/* Add force g of size |g| at l, in the contact's frame, to what its blocks carry. */
SP__NOINLINE static void sp__carry_add(sp__system *w, const sp_contact *t, const sp_real *l, const sp_real g[3], sp_real size)
{
    const sp_joint *f = t->joint;
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *arm = side ? t->rb : t->ra;
        const sp_real x[3] = { sp__dot3(arm, f->n) + l[0], sp__dot3(arm, f->t1) + l[1], sp__dot3(arm, f->t2) + l[2] };
        sp_real m[3], *sum = w->carried + 3 * (size_t)i;
        sp__cross3(x, g, m);
        sum[0] += size;
        sum[1] += sp__norm3(m);
        sum[2] = sp__max(sum[2], sp__norm3(x));
    }
}

/* A contact's share of sp__system_gradient. */
SP__NOINLINE static void sp__contact_gradient(sp__system *w, sp__law law, const sp__view *k, const sp_real *y, sp_real *r,
                                              sp_real *f)
{
    const sp_contact *t = k->t;
    sp__visit *s = sp__visit_of(w);
    sp_real *X = s->twist[0], *u = s->u[0], *g = s->f, *Y = s->sum;
    for (int q = 0; q < 6; q++) Y[q] = 0;
    sp__view_motion(w, k, y, X);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *l = w->pb->local[v], times = sp__system_multiplicity(w, v);
        if (!(times > 0)) continue;
        const sp_real *place = sp__view_place(w, k, l);
        sp__view_rates(w, k, place, X, u);
        sp__view_force(w, k, law, u, g);
        if (f) sp__view_widen(w, k, g, f + 3 * (size_t)v);
        for (int q = 0; q < (k->g ? 2 : 3); q++) g[q] *= times;
        sp__view_gather(w, k, place, g, Y);
        if (!w->carried) continue;
        sp__view_widen(w, k, g, s->m);
        sp__carry_add(w, t, l, s->m, sp__view_norm(k, g));
    }
    sp__view_scatter(w, k, Y, r);
}

/* The same of a joint with friction alone in the wide kernel, where r alone is asked for. Most passes are of these, and with S
 * worked out once a joint a check in space takes a tenth less time. */
SP__NOINLINE static void sp__plain_gradient(sp__system *w, const sp__view *k, const sp_real *y, sp_real *r)
{
    const sp_contact *t = k->t;
    const sp_real S = sp__system_scale(w, k->c);
    sp__visit *s = sp__visit_of(w);
    sp_real *X = s->twist[0], *u = s->u[0], *f = s->f, *Y = s->sum;
    for (int q = 0; q < 6; q++) Y[q] = 0;
    sp__full_twist(w, t, y, X, X + 3);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *l = w->pb->local[v];
        sp__system_rate(w, X, X + 3, l, u);
        sp__system_force_at(w, S, w->law.yield, u, f);
        sp__view_gather(w, k, l, f, Y);
    }
    sp__full_scatter(w, t, Y, Y + 3, r);
}

/* r = Aeq f(y) + p, weighted; f (may be NULL) gets the forces, 3 x points, in units. */
static void sp__system_gradient(sp__system *w, sp__law law, const sp_real *y, sp_real *r, sp_real *f)
{
    const sp_problem *pb = w->pb;
    const int r_alone = law == SP__ADMISSIBLE && !f && !w->carried && !sp__reduced(w);
    if (!sp__system_sweep(w, 1, 1) || (w->carried && !sp__system_count(w, SP__FLOPS_SWEEP, 0))) return;
    sp__system_load(w, r);
    if (w->carried) memset(w->carried, 0, 3 * (size_t)pb->blocks * sizeof *w->carried);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp__view k = sp__view_of(w, c);
        if (r_alone && w->law.yield->plain) sp__plain_gradient(w, &k, y, r);
        else sp__contact_gradient(w, law, &k, y, r, f);
    }
    sp__system_release(w, r);
}

/* A contact's share of sp__system_slope. All that outlives a call is in memory: the line search stands deep in the stack. */
SP__NOINLINE static sp_real sp__contact_slope(sp__system *w, int32_t c, const sp_real *y, const sp_real *d, sp_real s)
{
    const sp__view view = sp__view_of(w, c), *k = &view;
    sp__visit *o = sp__visit_of(w);
    o->sum[0] = 0;
    sp__view_motion(w, k, y, o->twist[0]);
    sp__view_motion(w, k, d, o->twist[1]);
    for (int q = 0; q < (k->g ? 3 : 6); q++) o->twist[0][q] += s * o->twist[1][q];
    for (int32_t v = k->t->point; v < k->t->point + k->t->points; v++) {
        if (!(sp__system_multiplicity(w, v) > 0)) continue;
        const sp_real *place = sp__view_place(w, k, w->pb->local[v]);
        sp__view_rates(w, k, place, o->twist[0], o->u[0]);
        sp__view_rates(w, k, place, o->twist[1], o->u[1]);
        if (k->g) sp__view_wedge(w, k, o->u[0], o->f);
        else sp__system_force(w, k->c, w->law.yield, o->u[0], o->f);
        o->sum[0] += sp__system_multiplicity(w, v) * sp__view_power(w, k, o->f, o->u[1]);
    }
    return o->sum[0];
}

/* d/ds D(y + s d) = f(u + s du) . du + p . d, but for p . d, which is the same all along d. */
SP__NOINLINE static sp_real sp__system_slope(sp__system *w, const sp_real *y, const sp_real *d, sp_real s)
{
    sp_real sum = 0;
    if (!sp__system_sweep(w, 1, 2)) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) sum += sp__contact_slope(w, c, y, d, s);
    return sum;
}

#endif

#endif /* SP__STATICS_GRADIENT_C */
