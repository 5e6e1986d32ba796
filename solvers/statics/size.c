/* size: what imbalances are measured by, as the search sees it */
#ifndef SP__STATICS_SIZE_C
#define SP__STATICS_SIZE_C

#include "gradient.c"

#if SP__WITH_LARGE

/* Sizes by which forces are judged: sbar and Sbar, no more than load and what they themselves put on block i. */
SP__NOINLINE static void sp__dual_strict(const sp__dual *w, int32_t i, sp_real s[2])
{
    const sp_real *p = w->pb->p + 6 * (size_t)i, *carried = w->carried + 3 * (size_t)i;
    const sp_real rounding = 16 * (sp_real)SP_EPSILON * s[0] * carried[2] / w->set->tol;
    const sp_real f = sp__norm3(p) / w->unit + carried[0], m = sp__norm3(p + 3) / w->unit + carried[1] + rounding;
    if (f < s[0]) s[0] = f;
    if (m < s[1]) s[1] = m;
}

/* Weighted imbalance relative to sbar and Sbar, or to what forces are judged by: the largest over the blocks. */
static sp_real sp__dual_imbalance(const sp__dual *w, const sp_real *r)
{
    sp_real imbalance = 0;
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *ri = r + 6 * (size_t)i, *z = w->weight + 2 * (size_t)i;
        sp_real s[2] = { w->size[2 * (size_t)i], w->size[2 * (size_t)i + 1] };
        if (w->carried) sp__dual_strict(w, i, s);
        const sp_real f = sp__ratio(sp__norm3(ri), z[0] * s[0]), m = sp__ratio(sp__norm3(ri + 3), z[1] * s[1]);
        if (f > imbalance) imbalance = f;
        if (m > imbalance) imbalance = m;
    }
    return imbalance;
}

/* Are forces and motions of the rows at hand all of the scene's? Else sizes are the loads alone, which are less. */
static int sp__dual_whole(const sp__dual *w)
{
    const sp__flat *o = sp__reduced(w);
    return !o || o->mode != SP__LEVEL_JOINTS || o->forest || o->frictionless;
}

/* A contact's share in the size of a block it touches: sum |f_v| and sum |x_v x f_v|, x_v seen from the centroid. */
SP__NOINLINE static void sp__dual_size(const sp__dual *w, const sp_contact *t, const sp_real *arm, sp_real twist[4][3], sp_real *size,
                                    sp_real *longest)
{
    const sp_joint *g = t->joint;
    const sp_real o[3] = { sp__dot3(arm, g->n), sp__dot3(arm, g->t1), sp__dot3(arm, g->t2) };
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *l = w->pb->local[v], x[3] = { o[0] + l[0], o[1] + l[1], o[2] + l[2] };
        const sp_real times = sp__dual_counts(w, v);
        sp_real u[3], m[3];
        sp__dual_rate(w, twist[0], twist[1], l, u);
        sp__dual_rate(w, twist[2], twist[3], l, m);
        sp__sub3(u, m, u);
        sp__cross3(x, u, m);
        size[0] += times * sp__norm3(u);
        size[1] += times * sp__norm3(m);
        *longest = sp__max(*longest, sp__norm3(x));
    }
}

/* The same of a contact in 3 rows, both blocks. */
SP__NOINLINE static void sp__flat_size(sp__dual *w, const sp_contact *t, const sp_real *y, sp_real *longest)
{
    const sp_real *g = sp__flat_frame(w, t);
    sp_real X[3] = { 0, 0, 0 }, dX[3];
    if (sp__dual_whole(w)) {
        sp__flat_there(w, t, g, y, X);
        sp__flat_there(w, t, g, w->d, dX);
        sp__sub3(X, dX, X);
    }
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp_real q[2], u[2], one[2];
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        for (int side = 0; side < 2 && times > 0; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real moment = sp__flat_moment(w, t, side, v, u, one);
            w->size[2 * (size_t)i] += times * one[0];
            w->size[2 * (size_t)i + 1] += times * one[1];
            longest[i] = sp__max(longest[i], moment);
        }
    }
}

/* size = sbar and Sbar of the certificate check, from the bilateral force of potential y (metric 1) less that of w->d, its
 * correction. */
static void sp__dual_sizes(sp__dual *w, const sp_real *y)
{
    const sp_problem *pb = w->pb;
    sp_real *longest = w->L.t;                          /* arm of each block: nothing is solved meanwhile */
    if (!sp__dual_sweep(w, sp__dual_whole(w), 2 * sp__dual_whole(w)) || !sp__dual_count(w, SP__FLOPS_SWEEP, 0)) return;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *p = pb->p + 6 * (size_t)i;
        w->size[2 * (size_t)i] = sp__norm3(p) / w->unit;
        w->size[2 * (size_t)i + 1] = sp__norm3(p + 3) / w->unit;
        longest[i] = 0;
    }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        if (sp__reduced(w) && w->flat->plain) { sp__flat_size(w, t, y, longest); continue; }
        sp_real twist[4][3];
        sp__dual_twist(w, t, y, twist[0], twist[1]);
        sp__dual_twist(w, t, w->d, twist[2], twist[3]);
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i >= 0) sp__dual_size(w, t, side ? t->rb : t->ra, twist, w->size + 2 * (size_t)i, &longest[i]);
        }
    }
    for (size_t i = 0; i < (size_t)pb->blocks; i++)
        w->size[2 * i + 1] += 16 * (sp_real)SP_EPSILON * w->size[2 * i] * longest[i] / w->set->tol;
}

/* Is a metric needed, because contacts of very different load meet?     returns 1 when it is, and sets it */
static int sp__dual_metric(sp__dual *w)
{
    sp_real least = SP__HUGE, most = 0;
    if (w->spent) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_real s = sp__lesser(&w->pb->contact[c], w->size, 2);
        if (s < least) least = s;
        if (s > most) most = s;
    }
    if (!(most > 1000 * least)) return 0;
    w->metric = 1 / most;
    return 1;
}

/* METRIC: H of the penalty form; LIMIT: exact, and room for interior points of 3 numbers a vertex, or one an edge, behind it;
 * MOTION: exact, with no such room. */
typedef enum sp__form { SP__EXACT, SP__EXACT_DENSE, SP__PENALTY, SP__METRIC, SP__LIMIT, SP__MOTION } sp__form;

/* Where every contact's block off the diagonal is. */
static void sp__dual_slots(sp__dual *w)
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
