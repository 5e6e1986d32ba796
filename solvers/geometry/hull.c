/* hull: convex hull of points in a plane, and how far inside it a point lies.                  [Andrew 1979, monotone chain]
 *
 * Corners run anticlockwise, each place once, none on the line between its neighbours. Ties by index.
 */
#ifndef SP__HULL_C
#define SP__HULL_C

#include "../base/vec3.c"
#include "../base/sort.c"

#if SP__WITH_STONES

typedef struct sp__hull {
    int32_t points, corners;
    sp_real (*p)[2];            /* points: the caller writes them */
    int32_t *order;             /* points: from left to right */
    int32_t *corner;            /* 2 points + 1: the first `corners` count, the one after them is the first again */
} sp__hull;

static void sp__hull_carve(sp__hull *h, int32_t points, sp_arena *a)
{
    h->points = points;
    h->corners = 0;
    h->p = sp__take(a, (size_t)points, sizeof *h->p);
    h->order = sp__take(a, (size_t)points, sizeof *h->order);
    h->corner = sp__take(a, 2 * (size_t)points + 1, sizeof *h->corner);
}

static int sp__hull_before(const void *what, int32_t i, int32_t j)
{
    const sp__hull *h = what;
    if (h->p[i][0] < h->p[j][0] || h->p[i][0] > h->p[j][0]) return h->p[i][0] < h->p[j][0];
    if (h->p[i][1] < h->p[j][1] || h->p[i][1] > h->p[j][1]) return h->p[i][1] < h->p[j][1];
    return i < j;
}

/* (b - a) x (c - a): positive where a, b, c turn left. */
static sp_real sp__hull_turn(const sp__hull *h, int32_t a, int32_t b, int32_t c)
{
    const sp_real *p = h->p[a], *q = h->p[b], *r = h->p[c];
    return sp__minor(q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]);
}

/* Add point k to the chain that starts at corner `from`: what would no longer be a left turn leaves it. */
static int32_t sp__hull_add(sp__hull *h, int32_t from, int32_t m, int32_t k)
{
    while (m >= from + 2 && sp__hull_turn(h, h->corner[m - 2], h->corner[m - 1], k) <= 0) m--;
    h->corner[m] = k;
    return m + 1;
}

/* The lower chain from left to right, the upper one back. Fewer than three corners: all points on a line. */
static void sp__hull_run(sp__hull *h)
{
    int32_t m = 0;
    h->corners = h->points;
    for (int32_t i = 0; i < h->points; i++) h->order[i] = i;
    sp__sort(h->order, h->points, sp__hull_before, h);
    if (h->points < 3) return;
    for (int32_t i = 0; i < h->points; i++) m = sp__hull_add(h, 0, m, h->order[i]);
    const int32_t right = m - 1;
    for (int32_t i = h->points - 2; i >= 0; i--) m = sp__hull_add(h, right, m, h->order[i]);
    h->corners = m - 1;
}

/* Area and its centroid, summed as triangles about the first corner.     returns the area */
static sp_real sp__hull_area(const sp__hull *h, sp_real g[2])
{
    const sp_real *o = h->p[h->corner[0]];
    sp_real twice = 0, x = 0, y = 0;
    for (int32_t i = 1; i + 1 < h->corners; i++) {
        const sp_real *a = h->p[h->corner[i]], *b = h->p[h->corner[i + 1]];
        const sp_real t = sp__hull_turn(h, h->corner[0], h->corner[i], h->corner[i + 1]);
        twice += t;
        x += t * (a[0] - o[0] + b[0] - o[0]);
        y += t * (a[1] - o[1] + b[1] - o[1]);
    }
    g[0] = o[0] + x / ((sp_real)3 * twice);
    g[1] = o[1] + y / ((sp_real)3 * twice);
    return twice / (sp_real)2;
}

/* Distance of c from the nearest edge line, positive inside: min over edges (a, b) of n . (c - a), n = (-e_y, e_x) / |e|. */
static sp_real sp__hull_clearance(const sp__hull *h, const sp_real c[2])
{
    sp_real least = 0;
    for (int32_t i = 0; i < h->corners; i++) {
        const sp_real *a = h->p[h->corner[i]], *b = h->p[h->corner[i + 1]];
        const sp_real e[3] = { b[0] - a[0], b[1] - a[1], 0 };
        const sp_real d = sp__minor(e[0], e[1], c[0] - a[0], c[1] - a[1]) / sp__norm3(e);
        if (i == 0 || d < least) least = d;
    }
    return least;
}

#endif
#endif /* SP__HULL_C */
