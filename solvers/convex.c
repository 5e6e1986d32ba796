/* convex: what two convex polygons have in common; the calls of clip.c in less than a third of its code, for the smallest build.
 *
 * A region is a set of directed segments with the region on their left, as in clip.c, its boundary one convex polygon. P is cut
 * by the line of each side of Q in turn [Sutherland, Hodgman 1974]; what is nearer than eps to a line is on it, so corners of P
 * stay where they are; a cut that is as near to a corner of Q is that corner. Work O(p q).
 *
 *   bent   a region was not convex: no result
 *   thin   a result with 2 area / perimeter below this is left out: for a long strip that is its width        [length]
 */
#ifndef SP__CONVEX_C
#define SP__CONVEX_C

#include "arena.c"
#include "real.c"

typedef struct sp__clip_segment { sp_real from[2], to[2]; int32_t name[2]; } sp__clip_segment;

typedef struct sp__clip_corner { sp_real x[2]; int32_t name; } sp__clip_corner;

typedef struct sp__clip {
    int32_t cap, segments, own; /* own: the first ones, of P */
    int32_t full;               /* a capacity was too small: no result */
    int32_t bent;
    int32_t corners, loops;     /* of the result; one loop or none */
    int32_t loop[2];            /* its first corner, and one past its last */
    sp_real eps;
    sp__clip_segment *segment;
    sp__clip_corner *corner, *spare;
} sp__clip;

/* Room for regions of p and q segments. A side of Q adds one corner at most, so crossings do not count; rounding a few. */
static void sp__clip_carve(sp__clip *c, int64_t p, int64_t q, int64_t crossings, sp_arena *a)
{
    (void)crossings;
    const int64_t n = p + q + 8;
    c->cap = n < INT32_MAX ? (int32_t)n : 0;
    c->segment = sp__take(a, (size_t)n, sizeof *c->segment);
    c->corner = sp__take(a, (size_t)n, sizeof *c->corner);
    c->spare = sp__take(a, (size_t)n, sizeof *c->spare);
}

/* Forget the input. */
static void sp__clip_clear(sp__clip *c) { c->segments = c->own = c->full = c->bent = 0; }

/* Add a segment of region `side` (0: P, all of it before 1: Q) with the numbers >= 0 of its ends. */
static void sp__clip_add(sp__clip *c, int32_t side, const sp_real from[2], const sp_real to[2], int32_t name0, int32_t name1)
{
    const sp__clip_segment s = { { from[0], from[1] }, { to[0], to[1] }, { name0, name1 } };
    if (c->segments >= c->cap) { c->full = 1; return; }
    c->segment[c->segments++] = s;
    if (!side) c->own = c->segments;
}

/* Distance of p from the line a b, positive on its left; of a line too short to have a direction 0. */
static sp_real sp__clip_side(const sp__clip *c, const sp_real a[2], const sp_real b[2], const sp_real p[2])
{
    const sp_real dx = b[0] - a[0], dy = b[1] - a[1], length = SP_SQRT(dx * dx + dy * dy);
    return length > c->eps ? (dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / length : 0;
}

static void sp__clip_put(sp__clip *c, const sp_real x[2], int32_t name)
{
    const sp__clip_corner k = { { x[0], x[1] }, name };
    if (c->corners >= c->cap) { c->full = 1; return; }
    c->corner[c->corners++] = k;
}

/* Do all segments from..to-1 lie left of the lines of all? */
static int sp__clip_convex(const sp__clip *c, int32_t from, int32_t to)
{
    for (int32_t i = from; i < to; i++)
        for (int32_t k = from; k < to; k++)
            if (sp__clip_side(c, c->segment[i].from, c->segment[i].to, c->segment[k].from) < -c->eps) return 0;
    return 1;
}

/* Corners of P, segment after segment by the numbers of their ends.     returns 0: they are not one loop */
static int sp__clip_chain(sp__clip *c)
{
    int32_t at = 0;
    c->corners = 0;
    while (c->corners < c->own) {
        const sp__clip_segment *s = &c->segment[at];
        sp__clip_put(c, s->from, s->name[0]);
        for (at = 0; at < c->own && c->segment[at].name[0] != s->name[1]; at++) { }
        if (at == 0 || at == c->own) break;
    }
    return at == 0 && c->corners == c->own;
}

/* Take away what lies right of the line a b. */
static void sp__clip_cut(sp__clip *c, const sp_real a[2], const sp_real b[2])
{
    sp__clip_corner *old = c->corner;
    const int32_t n = c->corners;
    c->corner = c->spare;
    c->spare = old;
    c->corners = 0;
    for (int32_t k = 0; k < n; k++) {
        const sp_real *p = old[k].x, *q = old[k + 1 < n ? k + 1 : 0].x;
        const sp_real d = sp__clip_side(c, a, b, p), e = sp__clip_side(c, a, b, q);
        if (d >= -c->eps) sp__clip_put(c, p, old[k].name);
        if ((d > c->eps && e < -c->eps) || (d < -c->eps && e > c->eps)) {
            const sp_real s = d / (d - e), x[2] = { p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]) };
            sp__clip_put(c, x, -1);
        }
    }
}

/* Cuts at a corner of Q become that corner. */
static void sp__clip_name(sp__clip *c)
{
    for (int32_t k = 0; k < c->corners; k++)
        for (int32_t s = c->own; s < c->segments && c->corner[k].name < 0; s++) {
            const sp_real *x = c->segment[s].from, dx = x[0] - c->corner[k].x[0], dy = x[1] - c->corner[k].x[1];
            if (dx * dx + dy * dy > c->eps * c->eps) continue;
            const sp__clip_corner at = { { x[0], x[1] }, c->segment[s].name[0] };
            c->corner[k] = at;
        }
}

/* Take corners out that lie on the line between their neighbours, or on one of these. */
static void sp__clip_straighten(sp__clip *c)
{
    for (int32_t k = 0; k < c->corners; ) {
        const int32_t n = c->corners;
        const sp_real *a = c->corner[k ? k - 1 : n - 1].x, *b = c->corner[k + 1 < n ? k + 1 : 0].x;
        if (n > 3 && sp__abs(sp__clip_side(c, a, b, c->corner[k].x)) <= c->eps) {
            memmove(c->corner + k, c->corner + k + 1, (size_t)(n - 1 - k) * sizeof *c->corner);
            c->corners--;
            k = 0;
        } else k++;
    }
}

/* Twice the area less `thin` times the perimeter. */
static sp_real sp__clip_wide(const sp__clip *c, sp_real thin)
{
    sp_real wide = 0;
    for (int32_t k = 0; k < c->corners; k++) {
        const sp_real *o = c->corner[0].x, *p = c->corner[k].x, *q = c->corner[k + 1 < c->corners ? k + 1 : 0].x;
        const sp_real dx = q[0] - p[0], dy = q[1] - p[1];
        wide += (p[0] - o[0]) * dy - (p[1] - o[1]) * dx - thin * SP_SQRT(dx * dx + dy * dy);
    }
    return wide;
}

/* Common polygon of P and Q. Returns 0 if the room of sp__clip_carve was too small. */
static int sp__clip_run(sp__clip *c, sp_real eps, sp_real thin)
{
    c->eps = eps;
    c->bent = !sp__clip_chain(c) || !sp__clip_convex(c, 0, c->own) || !sp__clip_convex(c, c->own, c->segments);
    for (int32_t s = c->own; s < c->segments; s++) sp__clip_cut(c, c->segment[s].from, c->segment[s].to);
    sp__clip_name(c);
    sp__clip_straighten(c);
    c->loop[0] = 0;
    c->loop[1] = c->corners;
    c->loops = !c->bent && sp__clip_wide(c, sp__max(thin, eps)) > 0;
    return !c->full;
}

#endif /* SP__CONVEX_C */
