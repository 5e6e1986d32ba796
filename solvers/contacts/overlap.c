/* overlap: how deep two blocks penetrate each other.
 *
 *   convex      least overlap of the projections on the face normals and the cross products of edges     [separating axes]
 *   otherwise   the deepest vertex, or point on an edge, of one inside the other; 0 where a plane along a face separates them
 */
#ifndef SP__CONTACTS_OVERLAP_C
#define SP__CONTACTS_OVERLAP_C

#include "inside.c"

#if SP__WITH_SMALL

/* By how much the blocks' shadows on an axis overlap, of any length; below 0 they are apart. */
static sp_real sp__shadow(const sp__touch *t, const sp_real axis[3])
{
    sp_real lo[2] = { 0, 0 }, hi[2] = { 0, 0 };
    const sp_real *o = t->all.body[t->now.a].lo;
    for (int side = 0; side < 2; side++) {
        const sp__body *k = &t->all.body[side ? t->now.b : t->now.a];
        for (int32_t e = k->edge; e < k->edge + k->edges; e++) {
            sp_real d[3];
            sp__sub3(t->scene->vertex[t->all.bound[e][0]], o, d);
            const sp_real x = sp__dot3(axis, d);
            if (e == k->edge || x < lo[side]) lo[side] = x;
            if (e == k->edge || x > hi[side]) hi[side] = x;
        }
    }
    const sp_real one = hi[0] - lo[1], two = hi[1] - lo[0];
    return one < two ? one : two;
}

/* Least overlap of the shadows along the normals of both blocks' patches. At most `flat`: a plane keeps them apart, which is
 * proof for blocks of any shape. */
static sp_real sp__shadow_faces(const sp__touch *t, sp_real flat)
{
    sp_real least = 0;
    int some = 0;
    for (int side = 0; side < 2; side++) {
        const sp__body *k = &t->all.body[side ? t->now.b : t->now.a];
        for (int32_t p = k->patch; p < k->patch + k->patches; p++) {
            const sp_real x = sp__shadow(t, t->all.patch[p].n);
            if (!some || x < least) least = x;
            some = 1;
            if (least <= flat) return least;
        }
    }
    return least;
}

#else

/* Where some vertices lie on an axis, from o: least and largest, and which they are. */
typedef struct sp__span { sp_real lo, hi; int32_t first, last; } sp__span;

/* Of column `side` of a list. */
static sp__span sp__span_of(const sp__touch *t, const sp_real axis[3], const int32_t (*list)[2], int32_t n, int side)
{
    const sp_real *o = t->all.body[t->now.a].lo;
    sp__span s = { 0, 0, list[0][side], list[0][side] };
    for (int32_t i = 0; i < n; i++) {
        sp_real d[3];
        sp__sub3(t->scene->vertex[list[i][side]], o, d);
        const sp_real x = sp__dot3(axis, d);
        if (i == 0 || x < s.lo) { s.lo = x; s.first = list[i][side]; }
        if (i == 0 || x > s.hi) { s.hi = x; s.last = list[i][side]; }
    }
    return s;
}

static sp_real sp__spans_share(sp__span p, sp__span q)
{
    const sp_real one = p.hi - q.lo, two = q.hi - p.lo;
    return one < two ? one : two;
}

static sp__span sp__span_body(const sp__touch *t, const sp_real axis[3], int32_t block)
{
    const sp__body *k = &t->all.body[block];
    return sp__span_of(t, axis, (const int32_t (*)[2])t->all.bound + k->edge, k->edges, 0);
}

/* By how much the blocks' shadows on an axis overlap, of any length; below 0 they are apart. */
static sp_real sp__shadow(const sp__touch *t, const sp_real axis[3])
{
    return sp__spans_share(sp__span_body(t, axis, t->now.a), sp__span_body(t, axis, t->now.b));
}

#define SP__OUTER 64                    /* vertices of each block that are asked first */

/* Vertices that were outermost before, in the array `edge`: A's in column 0, B's in 1. */
typedef struct sp__outermost { int32_t room, kept, next; } sp__outermost;

/* The shadow along n, unless those vertices alone share as much as `least`. */
static sp_real sp__shadow_below(const sp__touch *t, const sp_real n[3], sp_real least, sp__outermost *o)
{
    int32_t (*list)[2] = t->all.edge;
    const int32_t (*seen)[2] = (const int32_t (*)[2])list;
    if (o->kept) {
        const sp__span p = sp__span_of(t, n, seen, o->kept, 0), q = sp__span_of(t, n, seen, o->kept, 1);
        if (sp__spans_share(p, q) >= least) return least;
    }
    const sp__span p = sp__span_body(t, n, t->now.a), q = sp__span_body(t, n, t->now.b);
    list[o->next][0] = p.first;
    list[o->next][1] = q.first;
    list[o->next + 1][0] = p.last;
    list[o->next + 1][1] = q.last;
    o->next = (o->next + 2) % o->room;
    if (o->kept < o->room) o->kept += 2;
    return sp__spans_share(p, q);
}

/* Least overlap of the shadows along the normals of both blocks' patches. At most `flat`: a plane keeps them apart, which is
 * proof for blocks of any shape. In the order of every 2^k-th, and those between, which is soon near the least; then few axes
 * are asked of all vertices. */
SP__NOINLINE static sp_real sp__shadow_faces(const sp__touch *t, sp_real flat)
{
    const sp__body *a = &t->all.body[t->now.a], *b = &t->all.body[t->now.b];
    const int32_t most = a->edges > b->edges ? a->edges : b->edges, patches = a->patches + b->patches;
    sp__outermost o = { (most < SP__OUTER ? most : SP__OUTER) / 2 * 2, 0, 0 };
    sp_real least = SP__HUGE;
    int32_t way = 1;
    while (way < patches) way *= 2;
    for (int32_t from = 0; way > 0; from = way /= 2)
        for (int32_t i = from; i < patches; i += 2 * way) {
            const sp__patch *p = &t->all.patch[i < a->patches ? a->patch + i : b->patch + i - a->patches];
            const sp_real x = sp__shadow_below(t, p->n, least, &o);
            if (x < least) least = x;
            if (least <= flat) return least;
        }
    return least;
}

#endif

/* One of an edge and its opposite? */
static int sp__edge_is_first(const sp__touch *t, const int32_t *e)
{
    if (!SP__WITH_SMALL) return e[0] <= e[1];                       /* one number stands for all vertices at a place */
    return sp__place_order(t->scene->vertex[e[0]], t->scene->vertex[e[1]], 0) < 0;
}

/* Least overlap of the shadows along the cross products of their edges, too. If a plane keeps two convex bodies apart, one
 * along a face or along two edges does. */
static sp_real sp__shadow_edges(const sp__touch *t, sp_real least, sp_real flat)
{
    const sp__body *p = &t->all.body[t->now.a], *q = &t->all.body[t->now.b];
    for (int32_t i = p->edge; i < p->edge + p->edges; i++)
        for (int32_t j = q->edge; j < q->edge + q->edges; j++) {
            const int32_t *u = t->all.bound[i], *v = t->all.bound[j];
            sp_real d[3], e[3];
            if (!sp__edge_is_first(t, u) || !sp__edge_is_first(t, v)) continue;
            sp__sub3(t->scene->vertex[u[1]], t->scene->vertex[u[0]], d);
            sp__sub3(t->scene->vertex[v[1]], t->scene->vertex[v[0]], e);
            const sp_real blur = t->now.noise * (sp__norm3(d) + sp__norm3(e));
            sp__cross3(d, e, d);
            const sp_real length = sp__norm3(d);
            if (!(length > blur)) continue;                         /* parallel: no axis of its own */
            sp__scale3((sp_real)1 / length, d, d);
            const sp_real x = sp__shadow(t, d);
            if (x < least) least = x;
            if (least <= flat) return least;
        }
    return least;
}

#if !SP__WITH_SMALL

/* Part of the edge p q in a box: from s[0] to s[1], empty if s[0] > s[1].                          [Liang, Barsky 1984] */
static void sp__edge_in_box(const sp_real p[3], const sp_real q[3], const sp__body *k, sp_real s[2])
{
    s[0] = 0;
    s[1] = (sp_real)1;
    for (int c = 0; c < 3; c++) {
        const sp_real d = q[c] - p[c];
        if (!(sp__abs(d) > 0)) {
            if (p[c] < k->lo[c] || p[c] > k->hi[c]) s[1] = (sp_real)-1;
            continue;
        }
        const sp_real u = (k->lo[c] - p[c]) / d, v = (k->hi[c] - p[c]) / d;
        s[0] = sp__max(s[0], u < v ? u : v);
        if (s[1] > (u < v ? v : u)) s[1] = u < v ? v : u;
    }
}

/* Deepest of the vertices of `inner`, and of points along its edges, inside `outer`. */
static sp_real sp__depth_edges(sp__touch *t, int32_t inner, int32_t outer, sp_real flat)
{
    const sp__body *k = &t->all.body[inner];
    const int64_t work = (int64_t)k->edges * t->scene->block[outer].faces;
    const int steps = work < 20000 ? 8 : 2, closed = t->scene->block[inner].volume > 0;     /* each edge has an opposite */
    sp_real most = 0;
    if (sp__inside_large(t, outer) && t->inside.block != outer + 1) sp__inside_build(t, outer);
    for (int32_t e = k->edge; e < k->edge + k->edges; e++) {
        const sp_real *p = t->scene->vertex[t->all.bound[e][0]], *q = t->scene->vertex[t->all.bound[e][1]];
        sp_real s[2], x[3];
        most = sp__max(most, sp__depth(t, outer, p, flat));
        if (closed && !sp__edge_is_first(t, t->all.bound[e])) continue;
        sp__edge_in_box(p, q, &t->all.body[outer], s);
        for (int i = 1; i < steps && s[0] < s[1]; i++) {
            const sp_real at = s[0] + (s[1] - s[0]) * (sp_real)i / (sp_real)steps;
            for (int c = 0; c < 3; c++) x[c] = p[c] + at * (q[c] - p[c]);
            most = sp__max(most, sp__depth(t, outer, x, flat));
        }
    }
    return most;
}

/* The deepest vertex, point on an edge or centroid of one block inside the other. */
SP__NOINLINE static sp_real sp__depth_points(sp__touch *t, sp_real flat)
{
    sp_real most = sp__max(sp__depth_edges(t, t->now.a, t->now.b, flat), sp__depth_edges(t, t->now.b, t->now.a, flat));
    for (int side = 0; side < 2; side++) {
        const sp_real *x = t->scene->block[side ? t->now.b : t->now.a].centroid;
        const sp_real d = sp__depth(t, t->now.a, x, flat), e = sp__depth(t, t->now.b, x, flat);
        most = sp__max(most, d < e ? d : e);
    }
    return most;
}

#else

static sp_real sp__depth_points(sp__touch *t, sp_real flat) { (void)t; return flat; }    /* not asked: convex blocks only */

#endif

/* Depth of the present pair inside each other, at most `flat` if none is seen.
 *   convex, closed   separating axes: always seen, least way out
 *   other shapes     only what is certain: no plane along a face keeps them apart, and a vertex, a point on an edge, or a
 *                    centroid of one is inside the other; depth of that point. Thin crossings may be missed; touching blocks
 *                    are never reported
 *   open or flat     supports have no inside: only their vertices and edges inside the other are seen */
static sp_real sp__pair_depth(sp__touch *t, sp_real flat)
{
    const sp__body *p = &t->all.body[t->now.a], *q = &t->all.body[t->now.b];
    const int64_t work = (int64_t)p->edges * q->edges * (p->edges + q->edges) / 4;
    for (int c = 0; c < 3; c++) if (p->hi[c] - q->lo[c] <= flat || q->hi[c] - p->lo[c] <= flat) return 0;
    const sp_real least = sp__shadow_faces(t, flat);
    if (least <= flat) return 0;
    if (p->convex && q->convex && work <= 10000000) return sp__shadow_edges(t, least, flat);
    if (!SP__HAS_STRENGTH) return 0;
    const sp_real most = sp__depth_points(t, flat);
    return most < least ? most : least;
}

/* The distance beyond which blocks are inside each other: that counts between any of their faces. A body is nowhere
 * thinner than its volume over its diameter squared. */
#if SP__WITH_SMALL
#define SP__PAIR_INSIDE(t) ((t)->now.gap)
#else
static sp_real sp__pair_inside(const sp__touch *t)
{
    const sp_real usual = 8 * t->now.snap;
    sp_real gap = t->now.asked;
    if (gap <= usual) return gap;
    for (int side = 0; side < 2; side++) {
        const sp_block *k = &t->scene->block[side ? t->now.b : t->now.a];
        const sp_real thin = k->volume > 0 ? k->volume / k->diameter / k->diameter / 4 : gap;
        gap = thin < gap ? thin : gap;
    }
    return sp__max(gap, usual);
}
#define SP__PAIR_INSIDE(t) sp__pair_inside(t)
#endif

/* Report the pair if it overlaps by more than its distance and what its faces are warped by. */
SP__NOINLINE static void sp__pair_overlap(sp__touch *t)
{
    const sp_real flat = SP__PAIR_INSIDE(t) + 2 * (t->all.body[t->now.a].warp + t->all.body[t->now.b].warp);
    const sp_real depth = sp__pair_depth(t, flat);
    if (!(depth > flat)) return;
    if (t->report.overlap && t->report.overlaps < t->report.overlap_capacity) {
        const sp_overlap o = { t->now.a, t->now.b, depth };
        t->report.overlap[t->report.overlaps] = o;
    }
    t->report.overlaps++;
}

#endif /* SP__CONTACTS_OVERLAP_C */
