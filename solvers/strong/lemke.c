/* lemke: contact forces and accelerations at rest by complementary pivoting, which settles where sweeps do not.
 *
 *   w = q + M z >= 0, z >= 0, w . z = 0,   a corner: z = (fn, beta_1..4, lambda), w = (dn, s_k . dt + lambda, mu fn - sum beta)
 *                                                       [Stewart, Trinkle 1996; Anitescu, Potra 1997: it never ends on a ray]
 * s_k = +-t1, +-t2: a pyramid in the cone, exact where slips are along its axes. From w = q + d z0 + M z with z0 large, z0 goes
 * down to 0 by exchanges of one variable of a pair for its other [Lemke 1965]. What it ends with is basic: the corners that
 * press are a least set that carries the load; other d > 0 come to other sets. */
#ifndef SP__STRONG_LEMKE_C
#define SP__STRONG_LEMKE_C

#include "sweep.c"

#if SP__WITH_STRONG

#define SP__LEMKE_POINTS 108            /* corners up to which the table is held: 3.4 MB */
#define SP__LEMKE_PIVOTS 8              /* times rows, and no more: .3 to 3 were counted */
#ifdef SP_REAL_FLOAT
#define SP__LEMKE_NONE ((sp_real)1e-4)  /* of a column's largest entry, that counts as 0 */
#define SP__LEMKE_NEAR ((sp_real)1e-6)  /* of the largest q, likewise */
#else
#define SP__LEMKE_NONE ((sp_real)1e-9)
#define SP__LEMKE_NEAR ((sp_real)1e-12)
#endif
#define SP__LEMKE_ROWS 6                /* a corner */

/* y = T x over the n variables at hand (basic) and the n + 1 others, all 0; the last column of T is y's value then.
 * Variables: w 0 to n - 1, z n to 2n - 1, z0 2n. */
typedef struct sp__lemke {
    int32_t n;                          /* rows: 6 a corner */
    int32_t *basic, *other;             /* n, n + 1 */
    sp_real *T;                         /* n x (n + 2) */
    sp_real dust;                       /* what counts as 0 of a value */
    sp_real *size;                      /* V: 1 / sqrt(Wnn), so that rows are in proportion */
} sp__lemke;

static int sp__lemke_allowed(int32_t points) { return points > 0 && points <= SP__LEMKE_POINTS; }

static void sp__lemke_carve(sp__lemke *s, int32_t points, sp_arena *a)
{
    const size_t n = SP__LEMKE_ROWS * (size_t)points;
    s->n = (int32_t)n;
    s->basic = sp__take(a, n, sizeof *s->basic);
    s->other = sp__take(a, n + 1, sizeof *s->other);
    s->T = sp__take(a, n, (n + 2) * sizeof *s->T);
    s->size = sp__take(a, (size_t)points, sizeof *s->size);
}

static size_t sp__lemke_need(int32_t points)
{
    sp__lemke s;
    sp_arena dry = sp__arena_dry();
    if (sp__lemke_allowed(points)) sp__lemke_carve(&s, points, &dry);
    return dry.used;
}

static sp_real *sp__lemke_row(const sp__lemke *s, int32_t i) { return s->T + (size_t)i * ((size_t)s->n + 2); }

/* Column c of rows 6u to 6u + 4: dn, and s_k . dt of directions that come in pairs, for the slip d in units of its corner. */
static void sp__lemke_rates(const sp__lemke *s, int32_t u, int32_t c, const sp_real d[3], sp_real scale)
{
    for (int k = 0; k < 5; k++) {
        const sp_real rate = k == 0 ? d[0] : k < 3 ? d[k] : -d[k - 2];
        sp__lemke_row(s, SP__LEMKE_ROWS * u + k)[c] = scale * rate;
    }
}

/* M's columns of corner v's forces: the motion of all corners in a unit of each. */
static void sp__lemke_columns(const sp__lemke *s, sp__sweep *w, int32_t v)
{
    const sp_joint *o = w->pb->contact[w->corner[v].contact].joint;
    for (int e = 0; e < 3; e++) {
        memset(w->a, 0, 6 * (size_t)w->pb->blocks * sizeof *w->a);
        sp__sweep_push(w, &w->corner[v], e == 0 ? o->n : e == 1 ? o->t1 : o->t2, w->a);
        for (int32_t u = 0; u < w->corners; u++) {
            const int32_t c = SP__LEMKE_ROWS * v + e;
            sp_real d[3];
            sp__sweep_rate(w, &w->corner[u], w->a, d);
            sp__lemke_rates(s, u, c, d, s->size[u] * s->size[v]);
            if (e) sp__lemke_rates(s, u, c + 2, d, -s->size[u] * s->size[v]);
        }
    }
}

/* M's column of lambda and row of mu fn - sum beta. */
static void sp__lemke_cone(const sp__lemke *s, int32_t v, sp_real mu)
{
    const int32_t at = SP__LEMKE_ROWS * v;
    for (int k = 1; k < 5; k++) {
        sp__lemke_row(s, at + k)[at + 5] = 1;
        sp__lemke_row(s, at + 5)[at + k] = -1;
    }
    sp__lemke_row(s, at + 5)[at] = mu;
}

/* Columns q, the motion in the loads alone, and d, from 1 to 256 by `seed`. */
static void sp__lemke_start(sp__lemke *s, sp__sweep *w, uint32_t seed)
{
    const int32_t n = s->n;
    memset(w->f, 0, 3 * (size_t)w->pb->points * sizeof *w->f);
    sp__sweep_accelerate(w);
    for (int32_t u = 0; u < w->corners; u++) {
        sp_real d[3];
        sp__sweep_rate(w, &w->corner[u], w->a, d);
        sp__lemke_rates(s, u, n + 1, d, s->size[u]);
    }
    s->dust = 0;
    for (int32_t i = 0; i < n; i++) {
        sp_real *t = sp__lemke_row(s, i);
        seed = sp__random(seed);
        t[n] = (sp_real)(1u << (seed >> 8) % 8u) * (1 + (sp_real)((seed >> 16) % 1024u) / 1024);
        s->dust = sp__max(s->dust, SP__LEMKE_NEAR * sp__abs(t[n + 1]));
    }
}

/* The table: w = q + M z + d z0, all z 0. */
SP__NOINLINE static void sp__lemke_make(sp__lemke *s, sp__sweep *w, uint32_t seed)
{
    const int32_t n = s->n;
    for (size_t k = 0; k < (size_t)n * ((size_t)n + 2); k++) s->T[k] = 0;
    for (int32_t v = 0; v < w->corners; v++) s->size[v] = SP_SQRT(w->corner[v].normal);
    for (int32_t v = 0; v < w->corners; v++) {
        sp__lemke_columns(s, w, v);
        sp__lemke_cone(s, v, w->pb->contact[w->corner[v].contact].joint->strength.mu);
    }
    sp__lemke_start(s, w, seed);
    for (int32_t i = 0; i < n; i++) {
        s->basic[i] = i;
        s->other[i] = n + i;
    }
    s->other[n] = 2 * n;
    w->flops += SP__SWEEP_FLOPS / 2 * 3 * (int64_t)w->corners * w->corners;
}

/* The other variable in column c becomes basic in row r, and the one there other. */
static void sp__lemke_exchange(sp__lemke *s, int32_t r, int32_t c)
{
    const size_t m = (size_t)s->n + 2;
    sp_real *p = sp__lemke_row(s, r);
    const sp_real by = 1 / p[c];
    for (size_t k = 0; k < m; k++) p[k] *= -by;
    p[c] = by;
    for (int32_t i = 0; i < s->n; i++) {
        sp_real *t = sp__lemke_row(s, i);
        const sp_real x = t[c];
        if (i == r || !(x < 0 || x > 0)) continue;
        t[c] = 0;
        for (size_t k = 0; k < m; k++) t[k] += x * p[k];
    }
    const int32_t left = s->basic[r];
    s->basic[r] = s->other[c];
    s->other[c] = left;
}

/* How far column c's variable may grow until one of the basic ones is `dust` below 0; *none: what counts as 0 of the column. */
static sp_real sp__lemke_reach(const sp__lemke *s, int32_t c, sp_real *none)
{
    sp_real most = 0, reach = SP__HUGE;
    for (int32_t i = 0; i < s->n; i++) most = sp__max(most, sp__abs(sp__lemke_row(s, i)[c]));
    *none = SP__LEMKE_NONE * most;
    for (int32_t i = 0; i < s->n; i++) {
        const sp_real *t = sp__lemke_row(s, i);
        const sp_real at = t[c] < -*none ? (sp__max(0, t[s->n + 1]) + s->dust) / -t[c] : SP__HUGE;
        if (at < reach) reach = at;
    }
    return reach;
}

/* The row whose variable first comes to 0 as column c's grows: of those within rounding of the first z0's, else the one that
 * falls steepest.     returns -1: none                                                                         [Harris 1973] */
static int32_t sp__lemke_leaves(const sp__lemke *s, int32_t c)
{
    sp_real none;
    const sp_real reach = sp__lemke_reach(s, c, &none);
    int32_t r = -1;
    for (int32_t i = 0; i < s->n; i++) {
        const sp_real *t = sp__lemke_row(s, i);
        if (!(t[c] < -none) || sp__max(0, t[s->n + 1]) > reach * -t[c]) continue;
        if (s->basic[i] == 2 * s->n) return i;
        if (r < 0 || t[c] < sp__lemke_row(s, r)[c]) r = i;
    }
    return r;
}

/* Column of variable x. */
static int32_t sp__lemke_column(const sp__lemke *s, int32_t x)
{
    int32_t c = 0;
    while (c < s->n && s->other[c] != x) c++;
    return c;
}

/* The row that is 0 where z0 is as small as it may be with all else 0: the least q / d. */
static int32_t sp__lemke_first(const sp__lemke *s)
{
    const int32_t n = s->n;
    int32_t r = 0;
    for (int32_t i = 1; i < n; i++) {
        const sp_real *t = sp__lemke_row(s, i), *u = sp__lemke_row(s, r);
        if (t[n + 1] / t[n] < u[n + 1] / u[n]) r = i;
    }
    return r;
}

/* Exchanges until z0 is 0.     returns 0: on a ray, by rounding, or too many */
SP__NOINLINE static int sp__lemke_pivot(sp__lemke *s, sp__sweep *w)
{
    const int32_t n = s->n;
    int32_t r = sp__lemke_first(s), c = n;
    if (sp__lemke_row(s, r)[n + 1] >= 0) return 1;
    for (int32_t it = 0; it < SP__LEMKE_PIVOTS * n && r >= 0; it++) {
        const int32_t left = s->basic[r];
        sp__lemke_exchange(s, r, c);
        w->flops += 2 * (int64_t)n * (n + 2);
        if (left == 2 * n) return 1;
        c = sp__lemke_column(s, left < n ? left + n : left - n);
        r = sp__lemke_leaves(s, c);
    }
    return 0;
}

/* Forces of the pyramid at rest into w->f, all 0 where it did not end.     returns 1: it ended */
SP__NOINLINE static int sp__lemke_run(sp__lemke *s, sp__sweep *w, uint32_t seed)
{
    sp__lemke_make(s, w, seed);
    const int ended = sp__lemke_pivot(s, w);
    for (int32_t i = 0; i < s->n && ended; i++) {
        const int32_t z = s->basic[i] - s->n, v = z / SP__LEMKE_ROWS, k = z % SP__LEMKE_ROWS;
        const sp_real value = sp__lemke_row(s, i)[s->n + 1];
        if (z < 0 || z >= s->n || k == 5 || !(value > s->dust && value < SP__HUGE)) continue;
        sp_real *f = w->f + 3 * (size_t)w->corner[v].at;
        f[k == 0 ? 0 : k < 3 ? k : k - 2] += (k < 3 ? 1 : -1) * s->size[v] * value;
    }
    return ended;
}

#endif

#endif /* SP__STRONG_LEMKE_C */
