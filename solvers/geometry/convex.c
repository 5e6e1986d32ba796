/* convex: what two convex polygons have in common; in place of clip.c in the smallest build.
 *
 * A region is one convex polygon, its corners given in turn, anticlockwise. P is cut by the line of each side of Q
 * [Sutherland, Hodgman 1974]; what is nearer than eps to a line is on it, so corners of P stay where they are. Work O(p q).
 *
 *   bent   a region was not convex: no result
 *   thin   a result with 2 area / perimeter below this is left out: for a long strip that is its width        [length]
 *          Not where P or Q is below 4 thin itself: then it is narrow as a piece of something wider
 */
#ifndef SP__CONVEX_C
#define SP__CONVEX_C

#include "../base/real.c"

#if SP__WITH_SMALL

typedef struct sp__clip {
    int32_t room, sides;        /* of each array; corners of Q */
    int32_t full;               /* a capacity was too small: no result */
    int32_t bent;
    int32_t corners, loops;     /* of P, then of the result; one loop or none */
    int32_t loop[2];            /* its first corner, and one past its last */
    sp_real eps;
    sp_real (*corner)[2], (*spare)[2], (*side)[2];
} sp__clip;

/* Room for regions of p and q corners. A side of Q adds one corner at most; rounding a few. */
static void sp__clip_carve(sp__clip *c, int64_t p, int64_t q, sp_arena *a)
{
    const int64_t n = p + q + 8;
    c->room = n < INT32_MAX ? (int32_t)n : 0;
    c->corner = sp__take(a, (size_t)n, sizeof *c->corner);
    c->spare = sp__take(a, (size_t)n, sizeof *c->spare);
    c->side = sp__take(a, (size_t)n, sizeof *c->side);
}

/* Forget the input. */
static void sp__clip_clear(sp__clip *c) { c->sides = c->corners = c->full = 0; }

/* Add a corner to P, side 0, or to Q, side 1. */
static void sp__clip_add(sp__clip *c, int32_t side, const sp_real x[2])
{
    int32_t *n = side ? &c->sides : &c->corners;
    if (*n >= c->room) { c->full = 1; return; }
    memcpy((side ? c->side : c->corner)[(*n)++], x, sizeof *c->side);
}

/* Distance of p from the line a b, positive on its left; of a line too short to have a direction 0. */
static sp_real sp__clip_side(const sp__clip *c, const sp_real a[2], const sp_real b[2], const sp_real p[2])
{
    const sp_real dx = b[0] - a[0], dy = b[1] - a[1], length = SP_SQRT(dx * dx + dy * dy);
    return length > c->eps ? (dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / length : 0;
}

/* Do all corners lie left of the lines of all sides? */
static int sp__clip_convex(const sp__clip *c, sp_real (*p)[2], int32_t n)
{
    for (int32_t i = 0; i < n; i++)
        for (int32_t k = 0; k < n; k++)
            if (sp__clip_side(c, p[i], p[i + 1 < n ? i + 1 : 0], p[k]) < -c->eps) return 0;
    return 1;
}

/* Take away what lies right of the line a b. */
static void sp__clip_cut(sp__clip *c, const sp_real a[2], const sp_real b[2])
{
    sp_real (*old)[2] = c->corner;
    const int32_t n = c->corners;
    c->corner = c->spare;
    c->spare = old;
    c->corners = 0;
    for (int32_t k = 0; k < n; k++) {
        const sp_real *p = old[k], *q = old[k + 1 < n ? k + 1 : 0];
        const sp_real d = sp__clip_side(c, a, b, p), e = sp__clip_side(c, a, b, q);
        if (d >= -c->eps) sp__clip_add(c, 0, p);
        if ((d > c->eps && e < -c->eps) || (d < -c->eps && e > c->eps)) {
            const sp_real s = d / (d - e), x[2] = { p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]) };
            sp__clip_add(c, 0, x);
        }
    }
}

/* Take corners out that lie on the line between their neighbours, or on one of these. */
static void sp__clip_straighten(sp__clip *c)
{
    for (int32_t k = 0; k < c->corners; ) {
        const int32_t n = c->corners;
        const sp_real *a = c->corner[k ? k - 1 : n - 1], *b = c->corner[k + 1 < n ? k + 1 : 0];
        if (n > 3 && sp__abs(sp__clip_side(c, a, b, c->corner[k])) <= c->eps) {
            memmove(c->corner + k, c->corner + k + 1, (size_t)(n - 1 - k) * sizeof *c->corner);
            c->corners--;
            k = 0;
        } else k++;
    }
}

/* Back into the box of the sides: beyond the tip of a needle its sides' lines, eps wide, keep what is far from it. */
static void sp__clip_box(sp__clip *c)
{
    for (int k = 0; k < 2; k++) {
        sp_real lo = c->side[0][k], hi = lo;
        for (int32_t s = 1; s < c->sides; s++) {
            lo = lo < c->side[s][k] ? lo : c->side[s][k];
            hi = sp__max(hi, c->side[s][k]);
        }
        for (int32_t p = 0; p < c->corners; p++) {
            sp_real *x = &c->corner[p][k];
            if (*x < lo - c->eps) *x = lo;
            if (*x > hi + c->eps) *x = hi;
        }
    }
}

/* Twice the area of n corners less `thin` times their perimeter. */
static sp_real sp__clip_excess_area(sp_real (*corner)[2], int32_t n, sp_real thin)
{
    sp_real wide = 0;
    for (int32_t k = 0; k < n; k++) {
        const sp_real *o = corner[0], *p = corner[k], *q = corner[k + 1 < n ? k + 1 : 0];
        const sp_real dx = q[0] - p[0], dy = q[1] - p[1];
        wide += (p[0] - o[0]) * dy - (p[1] - o[1]) * dx - thin * SP_SQRT(dx * dx + dy * dy);
    }
    return wide;
}

/* Common polygon of P and Q. Returns 0 if the room of sp__clip_carve was too small. */
SP__NOINLINE_SMALL static int sp__clip_run(sp__clip *c, sp_real eps, sp_real thin)
{
    c->eps = eps;
    if (!(sp__clip_excess_area(c->corner, c->corners, 4 * thin) > 0 && sp__clip_excess_area(c->side, c->sides, 4 * thin) > 0))
        thin = 0;
    c->bent = !sp__clip_convex(c, c->corner, c->corners) || !sp__clip_convex(c, c->side, c->sides);
    for (int32_t s = 0; s < c->sides; s++) sp__clip_cut(c, c->side[s], c->side[s + 1 < c->sides ? s + 1 : 0]);
    if (c->sides) sp__clip_box(c);
    sp__clip_straighten(c);
    c->loop[0] = 0;
    c->loop[1] = c->corners;
    c->loops = !c->bent && sp__clip_excess_area(c->corner, c->corners, sp__max(thin, eps)) > 0;
    return !c->full;
}

#endif
#endif /* SP__CONVEX_C */
