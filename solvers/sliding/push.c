/* push: a history: live loads are pushed on, step by step, joints being a little soft, until forces stay as they are.
 *
 *   q . v = ds,   fn' = max(0, fn - kn dn),  ft' = P_(mu fn') (ft - ks dt),   A f' + p + lambda q = eps v
 *
 * A step has unknowns v and lambda and is solved by semismooth Newton steps in a band, bordered by q. Steps grow where Newton
 * is quick and are halved where it fails. Where forces stay, d = 0 where they press or stick: a sliding state, but for eps.
 * Then damping is of what differs from the last step alone, and is none where motion stays, too.
 */
#ifndef SP__SLIDING_PUSH_C
#define SP__SLIDING_PUSH_C

#include "../linear/band.c"
#include "plane.c"

#if SP__WITH_SLIDING

#define SP__PUSH_SOFT ((sp_real)1e-5)   /* eps: damping, loads a mean arm */
#define SP__PUSH_STEP ((sp_real)0.01)   /* first step of each block, mean arms */
#define SP__PUSH_NEWTON 30
#define SP__PUSH_HALVINGS 6
#define SP__PUSH_REST 3
#define SP__PUSH_LONG 64
#ifdef SP_REAL_FLOAT
#define SP__PUSH_BALANCE ((sp_real)1e-5)
#define SP__PUSH_STEADY ((sp_real)1e-4)
#else
#define SP__PUSH_BALANCE ((sp_real)1e-9)    /* imbalance of a step that is done, mean loads */
#define SP__PUSH_STEADY ((sp_real)1e-7)     /* change of forces in a step that counts as none */
#endif

typedef struct sp__push {
    const sp__slab *w;
    sp__band K;
    sp_real *kn, *ks;                   /* corners: stiffness */
    sp_real *fn, *ft, *gn, *gt;         /* corners: forces, and those tried */
    uint8_t *state;                     /* corners: 0 open, 1 sticks, 2 ft = mu fn, 3 ft = -mu fn */
    sp_real *v, *x, *r, *dx, *dq, *keep;    /* rows: motion of the last step, that tried, imbalance, Newton's steps */
    sp_real *first, track;              /* rows: the motion tried first; 1: damping is of what differs from it, 0: of all */
    sp_real lambda, ds, soft, change;   /* change: largest of a force in the last step, for a step of the first size */
    int64_t flops, limit;
    int32_t steps, newtons;
} sp__push;

static void sp__push_carve(sp__push *s, int32_t corners, int32_t rows, int32_t band, sp_arena *a)
{
    const size_t n = (size_t)corners, m = (size_t)rows;
    sp__band_carve(&s->K, rows, band, a);
    sp_real **at[6] = { &s->kn, &s->ks, &s->fn, &s->ft, &s->gn, &s->gt };
    sp_real **row[7] = { &s->v, &s->x, &s->r, &s->dx, &s->dq, &s->keep, &s->first };
    for (int k = 0; k < 6; k++) *at[k] = sp__take(a, n, sizeof(sp_real));
    for (int k = 0; k < 7; k++) *row[k] = sp__take(a, m, sizeof(sp_real));
    s->state = sp__take(a, n, sizeof *s->state);
}

/* Bytes of that. */
SP__NOINLINE static size_t sp__push_need(int32_t corners, int32_t rows, int32_t band)
{
    sp__push s;
    sp_arena dry = sp__arena_dry();
    sp__push_carve(&s, corners, rows, band, &dry);
    return dry.used;
}

/* Forces tried, states and imbalance r at (x, lambda).     returns the largest imbalance, the step's length among them */
static sp_real sp__push_try(sp__push *s, const sp_real *x, sp_real lambda)
{
    const sp__slab *w = s->w;
    sp_real worst = 0, work = 0;
    for (int32_t i = 0; i < w->rows; i++) {
        s->r[i] = w->p[i] + lambda * w->q[i] - s->soft * (x[i] - s->track * s->first[i]);
        work += w->q[i] * x[i];
    }
    for (int32_t v = 0; v < w->corners; v++) {
        const sp__slab_corner *k = &w->corner[v];
        const sp_real n = s->fn[v] - s->kn[v] * sp__slab_rate(k, k->n, x), g = s->ft[v] - s->ks[v] * sp__slab_rate(k, k->t, x);
        const sp_real most = n > 0 ? k->mu * n : 0;
        s->gn[v] = n > 0 ? n : 0;
        s->gt[v] = g > most ? most : g < -most ? -most : g;
        s->state[v] = n <= 0 ? 0 : g >= most ? 2 : g <= -most ? 3 : 1;
        sp__slab_push(k, k->n, s->gn[v], s->r);
        sp__slab_push(k, k->t, s->gt[v], s->r);
    }
    for (int32_t i = 0; i < w->rows; i++) worst = sp__max(worst, sp__abs(s->r[i]));
    s->flops += 70 * (int64_t)w->corners;
    if (s->ds > 0) worst = sp__max(worst, sp__abs(work - s->ds));
    return sp__finite(work) ? worst : SP__HUGE;
}

/* K -= k (column a) (column b)' */
static void sp__push_outer(sp__push *s, const sp__slab_corner *k, const sp_real *a, const sp_real *b, sp_real size)
{
    for (int i = 0; i < 6; i++) {
        if (k->row[i / 3] < 0) continue;
        sp_real *row = sp__band_row(&s->K, k->row[i / 3] + i % 3);
        for (int j = 0; j < 6; j++) if (k->row[j / 3] >= 0) row[k->row[j / 3] + j % 3] -= size * a[i] * b[j];
    }
    s->flops += 108;
}

/* K = dr / dx = -(sum kn n n' + ks t t' or +-mu kn t n') - eps */
static void sp__push_matrix(sp__push *s)
{
    const sp__slab *w = s->w;
    sp__band_zero(&s->K);
    for (int32_t i = 0; i < w->rows; i++) sp__band_row(&s->K, i)[i] -= s->soft;
    for (int32_t v = 0; v < w->corners; v++) {
        const sp__slab_corner *k = &w->corner[v];
        if (!s->state[v]) continue;
        sp__push_outer(s, k, k->n, k->n, s->kn[v]);
        if (s->state[v] == 1) sp__push_outer(s, k, k->t, k->t, s->ks[v]);
        else sp__push_outer(s, k, k->t, k->n, (s->state[v] == 2 ? k->mu : -k->mu) * s->kn[v]);
    }
}

/* [ K q ; q' 0 ] [ dx ; dl ] = -[ r ; q . x - ds ]; with ds = 0 K dx = -r     returns 0: singular */
static int sp__push_newton(sp__push *s, sp_real *dl)
{
    const sp__slab *w = s->w;
    const size_t m = (size_t)w->rows;
    sp__push_matrix(s);
    if (!sp__band_factor(&s->K)) return 0;
    for (size_t i = 0; i < m; i++) { s->dx[i] = -s->r[i]; s->dq[i] = -w->q[i]; }
    sp__band_solve(&s->K, s->dx);
    *dl = 0;
    if (!(s->ds > 0)) return 1;
    sp__band_solve(&s->K, s->dq);
    const sp_real a = sp__dot(w->q, s->dq, m), b = s->ds - sp__dot(w->q, s->x, m) - sp__dot(w->q, s->dx, m);
    if (!(sp__abs(a) > 0)) return 0;
    *dl = b / a;
    sp__add(s->dx, 1, *dl, s->dq, m);
    return sp__finite(*dl);
}

/* One step from s->x, s->lambda: Newton with halving.     returns Newton's steps, 0: it failed; *lambda: the new one */
static int32_t sp__push_step(sp__push *s, sp_real *lambda)
{
    const size_t m = (size_t)s->w->rows;
    memcpy(s->first, s->x, m * sizeof *s->x);
    sp_real l = s->lambda, r = sp__push_try(s, s->x, l);
    for (int32_t it = 1; it <= SP__PUSH_NEWTON; it++) {
        sp_real dl, part = 1, next = SP__HUGE;
        if (!sp__push_newton(s, &dl)) return 0;
        s->newtons++;
        memcpy(s->keep, s->x, m * sizeof *s->x);
        for (int h = 0; h < SP__PUSH_HALVINGS; h++, part /= 2) {
            for (size_t i = 0; i < m; i++) s->x[i] = s->keep[i] + part * s->dx[i];
            next = sp__push_try(s, s->x, l + part * dl);
            if (next < (1 - part / 10) * r || next < SP__PUSH_BALANCE / 10) break;
            if (h == SP__PUSH_HALVINGS - 1) break;
        }
        l += part * dl;
        r = next;
        if (!(r < SP__HUGE)) return 0;
        if (r < SP__PUSH_BALANCE) { *lambda = l; return it; }
    }
    return 0;
}

/* The forces tried become those at hand; s->change. */
static void sp__push_accept(sp__push *s, sp_real first)
{
    const sp__slab *w = s->w;
    sp_real change = 0;
    for (int32_t v = 0; v < w->corners; v++) {
        change = sp__max(change, sp__max(sp__abs(s->gn[v] - s->fn[v]), sp__abs(s->gt[v] - s->ft[v])));
        s->fn[v] = s->gn[v];
        s->ft[v] = s->gt[v];
    }
    memcpy(s->v, s->x, (size_t)w->rows * sizeof *s->v);
    s->change = s->ds > 0 ? change * first / s->ds : change;
}

/* Forces of the dead loads on joints that press alike before: the scene as it settles.     returns 0: none were found */
SP__NOINLINE static int sp__push_rest(sp__push *s)
{
    const sp__slab *w = s->w;
    sp_real lambda;
    int32_t it = 0;
    for (int32_t v = 0; v < w->corners; v++) { s->fn[v] = 1; s->ft[v] = 0; }
    memset(s->v, 0, (size_t)w->rows * sizeof *s->v);    /* of a history that gets no step done, too */
    s->ds = s->lambda = 0;
    for (int k = 0; k < SP__PUSH_REST; k++) {
        memset(s->x, 0, (size_t)w->rows * sizeof *s->x);
        it = sp__push_step(s, &lambda);
        if (it) sp__push_accept(s, 1);
    }
    return it > 0;
}

/* From forces fn, ft at lambda.     returns 1: forces stay as they are, s->v the motion; 0: it did not come to that */
SP__NOINLINE static int sp__push_run(sp__push *s, int32_t most)
{
    const sp__slab *w = s->w;
    const size_t m = (size_t)w->rows;
    sp_real first = 0;
    int32_t good = 0;
    for (size_t i = 0; i < m; i++) first += sp__abs(w->q[i]);
    first *= SP__PUSH_STEP;
    s->ds = first;
    if (!(s->track > 0)) memset(s->v, 0, m * sizeof *s->v);
    for (s->steps = 0; s->steps < most && s->flops + s->K.flops < s->limit; s->steps++) {
        const sp_real work = sp__dot(w->q, s->v, m), grow = work > 0 ? s->ds / work : 1;
        sp_real lambda = 0;
        for (size_t i = 0; i < m; i++) s->x[i] = grow * s->v[i];
        const int32_t it = sp__push_step(s, &lambda);
        if (!it) {
            good = 0;
            s->ds /= 2;
            if (s->ds < first * (sp_real)1e-4) return 0;
            continue;
        }
        s->lambda = lambda;
        sp__push_accept(s, first);
        if (s->change < SP__PUSH_STEADY) return 1;
        if (++good >= 4 && s->ds < SP__PUSH_LONG * first && it <= 5) { s->ds *= (sp_real)1.5; good = 0; }
    }
    return 0;
}

#endif

#endif /* SP__SLIDING_PUSH_C */
