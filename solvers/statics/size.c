/* size: sbar and Sbar, what a block's imbalance of force and of moment is measured by, as the search sees them; and whether
 * they differ so much from contact to contact that forces need a metric.
 */
#ifndef SP__STATICS_SIZE_C
#define SP__STATICS_SIZE_C

#include "gradient.c"

#if SP__WITH_LARGE

/* Sizes by which forces are judged: sbar and Sbar, no more than load and what they themselves put on block i. */
SP__NOINLINE static void sp__size_carried(const sp__system *w, int32_t i, sp_real s[2])
{
    const sp_real *p = w->pb->p + 6 * (size_t)i, *carried = w->carried + 3 * (size_t)i;
    const sp_real rounding = 16 * (sp_real)SP_EPSILON * s[0] * carried[2] / w->set->tol;
    const sp_real f = sp__in_units(w->measure.unit, sp__norm3(p)) + carried[0];
    const sp_real m = sp__in_units(w->measure.unit, sp__norm3(p + 3)) + carried[1] + rounding;
    if (f < s[0]) s[0] = f;
    if (m < s[1]) s[1] = m;
}

/* Weighted imbalance relative to sbar and Sbar, or to what forces are judged by: the largest over the blocks. */
static sp_real sp__system_imbalance(const sp__system *w, const sp_real *r)
{
    sp_real imbalance = 0;
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *ri = r + 6 * (size_t)i, *z = w->measure.weight + 2 * (size_t)i;
        sp_real s[2] = { w->measure.size[2 * (size_t)i], w->measure.size[2 * (size_t)i + 1] };
        if (w->carried) sp__size_carried(w, i, s);
        const sp_real f = sp__ratio(sp__norm3(ri), z[0] * s[0]), m = sp__ratio(sp__norm3(ri + 3), z[1] * s[1]);
        if (f > imbalance) imbalance = f;
        if (m > imbalance) imbalance = m;
    }
    return imbalance;
}

/* Do the rows at hand see all forces and motions of the scene? If not, sizes are the loads alone, which are less. */
static int sp__system_covers(const sp__system *w)
{
    const sp__reduction *o = sp__reduced(w);
    return !o || o->mode != SP__LEVEL_JOINTS || o->forest || o->frictionless;
}

/* Bilateral forces of contact c, those of potential y less those of d, into what the blocks bear. In 3 rows motions are
 * subtracted, in 6 rates. */
SP__NOINLINE static void sp__size_carry(sp__system *w, int32_t c, const sp_real *y, const sp_real *d)
{
    const sp__view k = sp__view_of(w, c);
    sp__visit *s = sp__visit_of(w);
    sp_real *X = s->twist[0], *dX = s->twist[1], *u = s->u[0], *du = s->u[1];
    sp__view_motion(w, &k, y, X);
    sp__view_motion(w, &k, d, dX);
    for (int q = 0; k.g && q < 3; q++) X[q] = sp__system_covers(w) ? X[q] - dX[q] : 0;
    for (int32_t v = k.t->point; v < k.t->point + k.t->points; v++) {
        const sp_real *l = w->pb->local[v], times = sp__system_multiplicity(w, v);
        if (!(times > 0)) continue;
        sp__view_rates(w, &k, sp__view_place(w, &k, l), X, u);
        if (!k.g) sp__view_rates(w, &k, l, dX, du);
        for (int q = 0; q < (k.g ? 2 : 3); q++) u[q] = times * (k.g ? u[q] : u[q] - du[q]);
        sp__view_widen(w, &k, u, s->f);
        sp__carry_add(w, k.t, l, s->f, sp__view_norm(&k, u));
    }
}

/* size = sbar and Sbar of the certificate check: the load, and what the bilateral force of potential y (metric 1) less that of
 * w->d, its correction, puts on a block. */
static void sp__system_sizes(sp__system *w, const sp_real *y)
{
    const sp_problem *pb = w->pb;
    if (!sp__system_sweep(w, sp__system_covers(w), 2 * sp__system_covers(w))) return;
    if (!sp__system_count(w, SP__FLOPS_SWEEP, 0)) return;
    sp__carry_begin(w);
    for (size_t i = 0; i < (size_t)pb->blocks; i++) {
        w->carried[3 * i] = sp__in_units(w->measure.unit, sp__norm3(pb->p + 6 * i));
        w->carried[3 * i + 1] = sp__in_units(w->measure.unit, sp__norm3(pb->p + 6 * i + 3));
        w->carried[3 * i + 2] = 0;
    }
    for (int32_t c = 0; c < pb->contacts; c++) sp__size_carry(w, c, y, w->d);
    for (size_t i = 0; i < (size_t)pb->blocks; i++) {
        const sp_real *sum = w->carried + 3 * i;
        w->measure.size[2 * i] = sum[0];
        w->measure.size[2 * i + 1] = sum[1] + 16 * (sp_real)SP_EPSILON * sum[0] * sum[2] / w->set->tol;
    }
    w->carried = NULL;
}

/* Is a metric needed, because contacts of very different load meet?     returns 1 when it is, and sets it */
static int sp__system_metric(sp__system *w)
{
    sp_real least = SP__HUGE, most = 0;
    if (w->budget.spent) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_real s = sp__least_of_blocks(&w->pb->contact[c], w->measure.size, 2);
        if (s < least) least = s;
        if (s > most) most = s;
    }
    if (!(most > 1000 * least)) return 0;
    w->measure.metric = 1 / most;
    return 1;
}

/* Position of every contact's block off the diagonal. */
static void sp__system_slots(sp__system *w)
{
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        int32_t turned = 0;
        w->slot[c] = INT32_MIN;
        if (t->a < 0 || t->b < 0) continue;
        w->slot[c] = sp__bchol_slot(&w->L, t->a, t->b, &turned);
        if (turned) w->slot[c] = -1 - w->slot[c];
    }
}

#endif

#endif /* SP__STATICS_SIZE_C */
