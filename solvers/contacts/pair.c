/* pair: tolerances of two blocks, the plane in which their patches are compared, and appending a polygon as a joint.
 *
 *   gap g along n_A in the middle m of the shared polygon:  n_B . (o_B - m - g n_A) = 0
 */
#ifndef SP__CONTACTS_PAIR_C
#define SP__CONTACTS_PAIR_C

#include "face.c"

/* Tolerances of the pair. */
static void sp__pair_start(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->now.a], *q = &t->all.body[b];
    const sp_real d = t->scene->block[t->now.a].diameter, e = t->scene->block[b].diameter, smaller = d < e ? d : e;
    t->now.b = b;
    t->now.noise = sp__max(p->noise, q->noise);
    t->now.gap = sp__max(t->now.noise, p->reach < q->reach ? p->reach : q->reach);
    t->now.snap = (sp_real)1e-6 * smaller < t->now.gap ? (sp_real)1e-6 * smaller : t->now.gap;
    t->now.snap = sp__max(t->now.noise, t->now.snap / 8);
    t->now.unit = smaller > 0 ? sp__power_of_two(smaller) : (sp_real)1;
}

/* Axes of the plane of patch p, and nothing in the clipper. */
static void sp__pair_plane(sp__touch *t, const sp__patch *p)
{
    sp__across3(p->n, t->now.e1);
    sp__cross3(p->n, t->now.e1, t->now.e2);
    sp__clip_clear(&t->clip);
}

/* Coordinates of x in the plane of patch p, e1 and e2 from o, in units. */
static void sp__pair_to_plane(const sp__touch *t, const sp__patch *p, const sp_real x[3], sp_real xy[2])
{
    sp_real d[3];
    sp__sub3(x, p->o, d);
    xy[0] = sp__dot3(t->now.e1, d) / t->now.unit;
    xy[1] = sp__dot3(t->now.e2, d) / t->now.unit;
}

/* A place in the plane of patch p in space. */
static void sp__pair_to_space(const sp__touch *t, const sp__patch *p, const sp_real xy[2], sp_real x[3])
{
    for (int c = 0; c < 3; c++) x[c] = p->o[c] + t->now.unit * (xy[0] * t->now.e1[c] + xy[1] * t->now.e2[c]);
}

/* From the middle of a patch to that of another, and to its end: the smaller block is no longer than two units. */
#if SP__WITH_SMALL
#define SP__PAIR_WAY(t, d) sp__norm3(d)
#else
#define SP__PAIR_WAY(t, d) (sp__norm3(d) + 2 * (t)->now.unit)
#endif

#if SP__WITH_SMALL

static int sp__pair_parallel(const sp__touch *t, sp_real s) { return s <= t->set.angle; }
#define SP__PAIR_PARALLEL(t, p, q, x, s) sp__pair_parallel(t, s)

#else

/* Width of a box along u, of any length. */
static sp_real sp__box_width(const sp_real lo[3], const sp_real hi[3], const sp_real u[3])
{
    sp_real width = 0;
    for (int c = 0; c < 3; c++) width += sp__abs(u[c]) * (hi[c] - lo[c]);
    return width;
}

/* Are patches with x = n_A x n_B of length s parallel enough? An angle of -k: to the default's angle, or where one rises
 * by k distances at most across the narrower: 2/k of it are within then. */
static int sp__pair_parallel(const sp__touch *t, const sp__patch *p, const sp__patch *q, const sp_real x[3], sp_real s)
{
    sp_real u[3];
    if (t->set.angle >= 0) return s <= t->set.angle;
    if (s <= (sp_real)1e-3) return 1;
    sp__cross3(x, p->n, u);
    const sp_real w = sp__box_width(p->lo, p->hi, u), v = sp__box_width(q->lo, q->hi, u);
    return s <= (sp_real)0.5 && (w < v ? w : v) <= -t->set.angle * t->now.gap;
}
#define SP__PAIR_PARALLEL(t, p, q, x, s) sp__pair_parallel(t, p, q, x, s)

#endif

/* Can patches p and q touch: opposed to within the angle, boxes and planes near? Between planes at angle s the distance
 * changes by s times the way. */
static int sp__pair_opposed(const sp__touch *t, const sp__patch *p, const sp__patch *q)
{
    sp_real x[3], d[3];
    if (sp__dot3(p->n, q->n) >= 0 || !sp__boxes_near(p->lo, p->hi, q->lo, q->hi, t->now.gap)) return 0;
    sp__cross3(p->n, q->n, x);
    const sp_real s = sp__norm3(x);
    if (!SP__PAIR_PARALLEL(t, p, q, x, s)) return 0;
    sp__sub3(q->o, p->o, d);
    return sp__abs(sp__dot3(d, p->n)) <= 2 * t->now.gap + 2 * s * SP__PAIR_WAY(t, d);
}

#if SP__WITH_SMALL

/* Is B's plane near in the middle of a polygon in A's: gap g along n_A, n_B . (o_B - m - g n_A) = 0? */
static int sp__pair_meets(const sp__touch *t, const sp__patch *p, const sp__patch *q, sp_real (*point)[3], int32_t size)
{
    sp_real m[3] = { 0, 0, 0 };
    for (int32_t k = 0; k < size; k++) {
        sp_real d[3];
        sp__sub3(q->o, point[k], d);
        sp__add3(m, 1 / (sp_real)size, d);
    }
    return !(sp__abs(sp__dot3(q->n, m) / sp__dot3(q->n, p->n)) > t->now.gap);
}

#else

/* Gap at a place x of A's plane, along n_A. */
static sp_real sp__pair_gap(const sp__patch *p, const sp__patch *q, const sp_real x[3])
{
    sp_real d[3];
    sp__sub3(q->o, x, d);
    return sp__dot3(q->n, d) / sp__dot3(q->n, p->n);
}

/* Part of a polygon where side * gap, side 1 or -1, is within the distance.                       [Sutherland, Hodgman 1974]
 *   returns its size, in place; needs room for twice the corners behind them */
static int32_t sp__pair_cut(const sp__touch *t, const sp__patch *p, const sp__patch *q, sp_real (*point)[3], int32_t size,
                            sp_real side)
{
    sp_real (*out)[3] = point + size;
    int32_t n = 0;
    for (int32_t k = 0; k < size; k++) {
        const sp_real *x = point[k], *y = point[k + 1 < size ? k + 1 : 0];
        const sp_real g = side * sp__pair_gap(p, q, x), h = side * sp__pair_gap(p, q, y);
        const int in = g <= t->now.gap;
        if (in) memcpy(out[n++], x, sizeof *out);
        if (in == (h <= t->now.gap)) continue;
        const sp_real s = (t->now.gap - g) / (h - g);
        for (int c = 0; c < 3; c++) out[n][c] = x[c] + s * (y[c] - x[c]);
        n++;
    }
    memmove(point, out, (size_t)n * sizeof *out);
    return n;
}

/* Perimeter of a polygon. */
static sp_real sp__pair_round(sp_real (*point)[3], int32_t size)
{
    sp_real round = 0, e[3];
    for (int32_t k = 0; k < size; k++) {
        sp__sub3(point[k + 1 < size ? k + 1 : 0], point[k], e);
        round += sp__norm3(e);
    }
    return round;
}

/* Is a polygon about as narrow as the distance: twice its area over its perimeter? */
static int sp__pair_narrow(const sp__touch *t, const sp__patch *p, sp_real (*point)[3], int32_t size)
{
    sp_real twice = 0;
    for (int32_t k = 0; k < size; k++) {
        sp_real d[3], e[3], x[3];
        const sp_real *y = point[k + 1 < size ? k + 1 : 0];
        sp__sub3(point[k], point[0], d);
        sp__sub3(y, point[k], e);
        sp__cross3(d, e, x);
        twice += sp__dot3(x, p->n);
    }
    return !(sp__abs(twice) > t->now.gap * sp__pair_round(point, size));
}

/* Is a polygon in both planes as exactly as coordinates of nine digits, or rounding, leave it? Of a small one less than a
 * millionth of its perimeter is asked: corners that are measured meet by chance in such a dot. */
static int sp__pair_exact(const sp__touch *t, const sp__patch *p, const sp__patch *q, sp_real (*point)[3], int32_t size)
{
    const sp_real fine = t->now.snap / 32, share = (sp_real)1e-6 * sp__pair_round(point, size);
    const sp_real most = sp__max(t->now.noise, share < fine ? share : fine);
    for (int32_t k = 0; k < size; k++) if (!(sp__abs(sp__pair_gap(p, q, point[k])) <= most)) return 0;
    return 1;
}

/* Of a polygon in A's plane what is within the distance of B's: all of it where no corner is farther than twice that and
 * the middle of all is within, for then the planes are parallel as far as the distance can tell.
 *   returns its size, 0: nothing, or no room (status) */
static int32_t sp__pair_within(sp__touch *t, const sp__patch *p, const sp__patch *q, sp_real (*point)[3], int32_t size)
{
    sp_real low = sp__pair_gap(p, q, point[0]), high = low;
    for (int32_t k = 1; k < size; k++) {
        const sp_real g = sp__pair_gap(p, q, point[k]);
        low = g < low ? g : low;
        high = g > high ? g : high;
    }
    if (low > t->now.gap || high < -t->now.gap) return 0;
    const sp_real twice = 2 * t->now.gap;
    if (low >= -twice && high <= twice && sp__abs(low + high) <= twice) return size;
    if (size > (t->pair.room - t->pair.points) / 5) { t->status = SP_E_MEMORY; return 0; }
    size = sp__pair_cut(t, p, q, point, size, (sp_real)1);
    size = sp__pair_cut(t, p, q, point, size, (sp_real)-1);
    return size < 3 || sp__pair_narrow(t, p, point, size) ? 0 : size;
}

/* A polygon in A's plane goes to the plane between both faces, where the gap is more than the default distance. */
static void sp__pair_between(const sp__touch *t, const sp__patch *p, const sp__patch *q, sp_real (*point)[3], int32_t size)
{
    sp_real most = 0;
    for (int32_t k = 0; k < size; k++) most = sp__max(most, sp__abs(sp__pair_gap(p, q, point[k])));
    if (!(most > 8 * t->now.snap)) return;
    for (int32_t k = 0; k < size; k++) sp__add3(point[k], sp__pair_gap(p, q, point[k]) / 2, p->n);
}

#endif

/* Append a polygon to the scene; where there is no room, count. */
static void sp__pair_add(sp__touch *t, int32_t size, sp_real (*point)[3])
{
    const sp_status s = sp_scene_joint(t->scene, t->now.a, t->now.b, size, point[0], &t->set.strength, NULL);
    if (s != SP_OK && s != SP_E_CAPACITY) return;                   /* too small for its coordinates */
    t->full |= s == SP_E_CAPACITY;
    t->report.joints++;
    t->report.points += size;
}

#endif /* SP__CONTACTS_PAIR_C */
