/* clip: what two plane regions have in common, as simple polygons.
 *
 * A region is a set of directed segments with the region on their left; it may be concave, in several pieces, with holes, and
 * its boundary may be cut into any number of segments in any order. The method is the plain one, chosen because nothing in it
 * minds shared edges, shared corners or a corner on an edge:
 *
 *   1 arrange    every segment is split where it meets another one or a corner; points nearer than eps become one
 *   2 classify   winding numbers of both regions left and right of each piece; it stays if exactly one side is in both
 *   3 trace      pieces are joined to loops, always by the sharpest left turn, and cut into simple loops where they touch
 *   4 cut        only if a loop is a hole: lines through the holes cut the region into strips, each clipped as above
 *
 *   P, Q   regions 0 and 1         w    winding number          eps    points nearer than this are one        [length]
 *   thin   loops with 2 area / perimeter below this are left out: for a long strip that is its width          [length]
 *   slit   holes below this are filled                                                                        [length]
 *
 * Work O(E^2) for E pieces. A result never has corners that are not needed, except where lines cut a region with holes.
 */
#ifndef SP__CLIP_C
#define SP__CLIP_C

#include "../base/real.c"
#include "../base/sort.c"

#if SP__WITH_LARGE

typedef struct sp__clip_edge { int32_t from, to, w[2]; } sp__clip_edge;     /* w: windings left minus right, of P and Q */

typedef struct sp__clip_corner { sp_real x[2]; int32_t name; } sp__clip_corner;     /* name: the caller's number or -1 */

/* The regions as they are given, later the pieces of a result that has holes. */
typedef struct sp__clip_input {
    sp_real (*segment)[4];      /* from, to */
    int32_t (*tag)[3];          /* the caller's number of from and to (-1: none), region */
    int32_t segments;
} sp__clip_input;

/* Their arrangement: nodes, and edges that meet only in nodes. */
typedef struct sp__clip_graph {
    sp_real (*xy)[2];           /* nodes */
    int32_t *label;             /* node -> the caller's number or -1 */
    int32_t *first, *place;     /* node -> its first outgoing edge; its place on the path or -1 */
    sp__clip_edge *edge;
    int32_t *order, *next;      /* edges in order; next outgoing edge of the same node */
    int32_t *path;              /* nodes of the loop being traced */
    int32_t nodes, edges, node_capacity, edge_capacity;
} sp__clip_graph;

/* Lines through holes, and the strip between two of them. */
typedef struct sp__clip_cuts {
    sp_real *x;                 /* lines x = const, ascending */
    sp_real lo[2], hi[2];       /* the strip */
    int32_t lines, holes;
    int32_t opening;            /* in the strips */
} sp__clip_cuts;

typedef struct sp__clip {
    sp__clip_input in;
    sp__clip_graph g;
    sp__clip_cuts cut;
    sp__clip_corner *corner;    /* result: corners, loop after loop, anticlockwise */
    int32_t *loop;              /* result: first corner of each loop, and one past the last */
    int32_t corners, loops;
    int32_t full;               /* a capacity was too small: no result */
    int32_t torn;               /* loops that did not close, or holes that cuts did not open; 0 unless rounding won */
    sp_real eps, thin, snap;    /* snap: eps of this attempt */
    sp_real slit;               /* the caller's before sp__clip_run, no less than thin in it */
} sp__clip;

/* Room for regions of p and q segments that cross at most `crossings` times. */
static void sp__clip_carve(sp__clip *c, int64_t p, int64_t q, int64_t crossings, sp_arena *a)
{
    const int64_t nodes = p + q + crossings + 32, edges = 3 * (p + q) + 2 * crossings + 32;
    const size_t n = (size_t)nodes, e = (size_t)edges;
    c->g.node_capacity = nodes < INT32_MAX ? (int32_t)nodes : 0;
    c->g.edge_capacity = edges < INT32_MAX ? (int32_t)edges : 0;
    c->in.segment = sp__take(a, e, sizeof *c->in.segment);
    c->in.tag = sp__take(a, e, sizeof *c->in.tag);
    c->g.xy = sp__take(a, n, sizeof *c->g.xy);
    c->g.label = sp__take(a, n, sizeof *c->g.label);
    c->g.first = sp__take(a, n, sizeof *c->g.first);
    c->g.place = sp__take(a, n, sizeof *c->g.place);
    c->g.edge = sp__take(a, e, sizeof *c->g.edge);
    c->g.order = sp__take(a, e, sizeof *c->g.order);
    c->g.next = sp__take(a, e, sizeof *c->g.next);
    c->g.path = sp__take(a, e, sizeof *c->g.path);
    c->corner = sp__take(a, e, sizeof *c->corner);
    c->loop = sp__take(a, n + 1, sizeof *c->loop);
    c->cut.x = sp__take(a, n, sizeof *c->cut.x);
}

/* Forget the input. */
static void sp__clip_clear(sp__clip *c)
{
    c->in.segments = c->corners = c->loops = 0;
    c->full = c->torn = 0;
    c->slit = 0;
}

/* Add a segment of region `side` (0: P, 1: Q) from (x0, y0) to (x1, y1); numbers of its ends or -1. */
static void sp__clip_add(sp__clip *c, int32_t side, const sp_real from[2], const sp_real to[2], int32_t name0, int32_t name1)
{
    if (c->in.segments >= c->g.edge_capacity) { c->full = 1; return; }
    const int32_t s = c->in.segments++;
    c->in.segment[s][0] = from[0];
    c->in.segment[s][1] = from[1];
    c->in.segment[s][2] = to[0];
    c->in.segment[s][3] = to[1];
    c->in.tag[s][0] = name0;
    c->in.tag[s][1] = name1;
    c->in.tag[s][2] = side;
}

/* ---------------------------------------------------------------------------------------------------------- 1 arrange */

static sp_real sp__clip_abs(sp_real x) { return x < 0 ? -x : x; }

/* (b - a) x (p - a): twice the area of the triangle a b p, positive anticlockwise. */
static sp_real sp__clip_turn(const sp_real a[2], const sp_real b[2], const sp_real p[2])
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/* The node at p: one nearer than eps, or a new one. The older place stays, so corners of P win over corners of Q. */
static int32_t sp__clip_node(sp__clip *c, const sp_real p[2], int32_t name)
{
    const sp_real near2 = c->snap * c->snap;
    for (int32_t k = 0; k < c->g.nodes; k++) {
        const sp_real dx = p[0] - c->g.xy[k][0], dy = p[1] - c->g.xy[k][1];
        if (dx * dx + dy * dy > near2) continue;
        if (c->g.label[k] < 0) c->g.label[k] = name;
        return k;
    }
    if (c->g.nodes >= c->g.node_capacity) { c->full = 1; return 0; }
    c->g.xy[c->g.nodes][0] = p[0];
    c->g.xy[c->g.nodes][1] = p[1];
    c->g.label[c->g.nodes] = name;
    return c->g.nodes++;
}

static void sp__clip_edge_add(sp__clip *c, int32_t from, int32_t to, int32_t w0, int32_t w1)
{
    if (from == to) return;
    if (c->g.edges >= c->g.edge_capacity) { c->full = 1; return; }
    const sp__clip_edge e = { from, to, { w0, w1 } };
    c->g.edge[c->g.edges++] = e;
}

/* Do the boxes of two edges come nearer than eps? */
static int sp__clip_edges_near(const sp__clip *c, int32_t i, int32_t j)
{
    const sp_real *a = c->g.xy[c->g.edge[i].from], *b = c->g.xy[c->g.edge[i].to];
    const sp_real *p = c->g.xy[c->g.edge[j].from], *q = c->g.xy[c->g.edge[j].to];
    for (int k = 0; k < 2; k++) {
        if ((a[k] < b[k] ? b[k] : a[k]) + c->snap < (p[k] < q[k] ? p[k] : q[k])) return 0;
        if ((p[k] < q[k] ? q[k] : p[k]) + c->snap < (a[k] < b[k] ? a[k] : b[k])) return 0;
    }
    return 1;
}

/* A node where edges i and j cross in their insides, X = a + (b - a) s / (s - t); s, t: on which sides of j the ends lie. */
static void sp__clip_cross(sp__clip *c, int32_t i, int32_t j)
{
    const sp__clip_edge *e = &c->g.edge[i], *f = &c->g.edge[j];
    if (e->from == f->from || e->from == f->to || e->to == f->from || e->to == f->to) return;
    const sp_real *a = c->g.xy[e->from], *b = c->g.xy[e->to], *p = c->g.xy[f->from], *q = c->g.xy[f->to];
    const sp_real s = sp__clip_turn(p, q, a), t = sp__clip_turn(p, q, b);
    const sp_real u = sp__clip_turn(a, b, p), v = sp__clip_turn(a, b, q);
    if (!((s < 0 && t > 0) || (s > 0 && t < 0)) || !((u < 0 && v > 0) || (u > 0 && v < 0))) return;
    const sp_real x[2] = { a[0] + (b[0] - a[0]) * (s / (s - t)), a[1] + (b[1] - a[1]) * (s / (s - t)) };
    (void)sp__clip_node(c, x, -1);
}

/* Does node k lie on the inside of edge e, nearer than eps? Only if both parts are shorter than e, so that splitting ends: of
 * three nodes a little more than eps apart each may be near the edge between the others. */
static int sp__clip_node_on_edge(const sp__clip *c, const sp__clip_edge *e, int32_t k)
{
    if (k == e->from || k == e->to) return 0;
    const sp_real *a = c->g.xy[e->from], *b = c->g.xy[e->to], *p = c->g.xy[k];
    const sp_real dx = b[0] - a[0], dy = b[1] - a[1], len2 = dx * dx + dy * dy;
    const sp_real x = p[0] - a[0], y = p[1] - a[1], along = x * dx + y * dy, turn = dx * y - dy * x;
    if (!(along > 0 && along < len2 && turn * turn <= c->snap * c->snap * len2)) return 0;
    return x * x + y * y < len2 && x * x + y * y < 2 * along;
}

/* Split every edge at the nodes on it. Returns whether anything changed. */
static int sp__clip_split(sp__clip *c)
{
    const int32_t before = c->g.edges;
    for (int32_t i = 0; i < c->g.edges && !c->full; i++)
        for (int32_t k = 0; k < c->g.nodes; k++) {
            if (!sp__clip_node_on_edge(c, &c->g.edge[i], k)) continue;
            sp__clip_edge_add(c, k, c->g.edge[i].to, c->g.edge[i].w[0], c->g.edge[i].w[1]);
            c->g.edge[i].to = k;
        }
    return c->g.edges > before;
}

static int sp__clip_edge_before(const void *what, int32_t i, int32_t j)
{
    const sp__clip_edge *a = (const sp__clip_edge *)what + i, *b = (const sp__clip_edge *)what + j;
    if (a->from != b->from) return a->from < b->from;
    if (a->to != b->to) return a->to < b->to;
    return i < j;
}

/* One edge for all pieces between the same two nodes, from the lower to the higher; their windings add. */
static void sp__clip_merge(sp__clip *c)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < c->g.edges; i++) {
        sp__clip_edge *e = &c->g.edge[i];
        c->g.order[i] = i;
        if (e->from < e->to) continue;
        const sp__clip_edge r = { e->to, e->from, { -e->w[0], -e->w[1] } };
        *e = r;
    }
    sp__sort(c->g.order, c->g.edges, sp__clip_edge_before, c->g.edge);
    for (int32_t i = 0; i < c->g.edges; kept++) {                   /* sums at the first of each run */
        const int32_t at = c->g.order[i];
        sp__clip_edge *e = &c->g.edge[at];
        for (i++; i < c->g.edges; i++) {
            const sp__clip_edge *f = &c->g.edge[c->g.order[i]];
            if (f->from != e->from || f->to != e->to) break;
            e->w[0] += f->w[0];
            e->w[1] += f->w[1];
        }
        c->g.order[kept] = at;
    }
    c->g.edges = kept;
}

/* Read the segments into nodes and edges that meet only in nodes. Snapping moves edges by up to eps, so repeat until calm. */
static void sp__clip_arrange(sp__clip *c)
{
    c->g.nodes = c->g.edges = 0;
    for (int32_t s = 0; s < c->in.segments; s++) {
        const int32_t from = sp__clip_node(c, c->in.segment[s], c->in.tag[s][0]);
        const int32_t to = sp__clip_node(c, c->in.segment[s] + 2, c->in.tag[s][1]);
        sp__clip_edge_add(c, from, to, c->in.tag[s][2] == 0, c->in.tag[s][2] == 1);
    }
    for (int pass = 0; pass < 8 && !c->full; pass++) {
        const int32_t before = c->g.nodes;
        for (int32_t i = 1; i < c->g.edges; i++)
            for (int32_t j = 0; j < i; j++)
                if (sp__clip_edges_near(c, i, j)) sp__clip_cross(c, i, j);
        if (!sp__clip_split(c) && c->g.nodes == before) break;
    }
    if (!c->full) sp__clip_merge(c);
}

/* --------------------------------------------------------------------------------------------------------- 2 classify */

/* Winding numbers beside the middle of edge e, on its far side as seen along a ray that leaves e across: +x for a steep edge,
 * +y for a flat one. Each edge that the ray crosses adds its own; half-open intervals count shared ends once. */
static void sp__clip_winding(const sp__clip_graph *g, int32_t at, int flat, int32_t w[2])
{
    const sp__clip_edge *e = &g->edge[at];
    const int x = flat ? 1 : 0, y = 1 - x;
    const sp_real mx = (g->xy[e->from][x] + g->xy[e->to][x]) / 2, my = (g->xy[e->from][y] + g->xy[e->to][y]) / 2;
    w[0] = w[1] = 0;
    for (int32_t k = 0; k < g->edges; k++) {
        if (g->order[k] == at) continue;
        const sp__clip_edge *f = &g->edge[g->order[k]];
        const sp_real *a = g->xy[f->from], *b = g->xy[f->to];
        const int up = a[y] <= my && my < b[y], down = b[y] <= my && my < a[y];
        if (!up && !down) continue;
        if (a[x] < mx && b[x] < mx) continue;
        if (a[x] + (b[x] - a[x]) * ((my - a[y]) / (b[y] - a[y])) < mx) continue;
        const int32_t sign = up != flat ? 1 : -1;                   /* x and y swapped mirror the plane */
        w[0] += sign * f->w[0];
        w[1] += sign * f->w[1];
    }
}

/* Does edge e bound the common region: 1 on its left, -1 on its right, 0 neither or both. left = right + w. */
static int sp__clip_bounds(const sp__clip_graph *g, int32_t at)
{
    const sp__clip_edge *e = &g->edge[at];
    const sp_real dx = g->xy[e->to][0] - g->xy[e->from][0], dy = g->xy[e->to][1] - g->xy[e->from][1];
    const int flat = sp__clip_abs(dy) < sp__clip_abs(dx);
    const int far_is_left = flat ? dx > 0 : dy < 0;
    int32_t winding[2];
    if (e->w[0] == 0 && e->w[1] == 0) return 0;
    sp__clip_winding(g, at, flat, winding);
    const int32_t s = far_is_left ? -1 : 1;
    const int far_in = winding[0] > 0 && winding[1] > 0;
    const int near_in = winding[0] + s * e->w[0] > 0 && winding[1] + s * e->w[1] > 0;
    if (far_in == near_in) return 0;
    return far_in == far_is_left ? 1 : -1;
}

/* Keep the boundary of the common region, directed with the region on the left. Returns whether it closes everywhere. */
static int sp__clip_classify(sp__clip_graph *g)
{
    int32_t kept = 0, open = 0;
    int32_t *side = g->next, *from = g->path, *to = g->order, *leaving = g->place;       /* no longer needed as such */
    for (int32_t k = 0; k < g->edges; k++) side[k] = sp__clip_bounds(g, g->order[k]);
    for (int32_t k = 0; k < g->edges; k++) {            /* ends first, then edges: the merged edges may overlap */
        const sp__clip_edge *e = &g->edge[g->order[k]];
        if (!side[k]) continue;
        from[kept] = side[k] > 0 ? e->from : e->to;
        to[kept++] = side[k] > 0 ? e->to : e->from;
    }
    for (int32_t k = 0; k < g->nodes; k++) leaving[k] = 0;
    for (int32_t k = 0; k < kept; k++) {
        const sp__clip_edge e = { from[k], to[k], { 0, 0 } };
        g->edge[k] = e;
        leaving[e.from]++;
        leaving[e.to]--;
    }
    for (int32_t k = 0; k < g->nodes; k++) open += leaving[k] != 0;
    g->edges = kept;
    return open == 0;
}

/* ------------------------------------------------------------------------------------------------------------ 3 trace */

/* Turning clockwise from r, is a met before b? A direction equal to r is met last. */
static int sp__clip_turns_before(const sp_real r[2], const sp_real a[2], const sp_real b[2])
{
    const int late_a = !(r[0] * a[1] - r[1] * a[0] < 0), late_b = !(r[0] * b[1] - r[1] * b[0] < 0);
    if (late_a != late_b) return late_b;
    return a[0] * b[1] - a[1] * b[0] < 0;
}

/* The edge to leave by after edge e: the unused one with the sharpest left turn; -1: none. */
static int32_t sp__clip_next_edge(const sp__clip_graph *g, int32_t e)
{
    const sp_real *v = g->xy[g->edge[e].to], *u = g->xy[g->edge[e].from];
    const sp_real back[2] = { u[0] - v[0], u[1] - v[1] };
    int32_t best = -1;
    sp_real lead[2] = { 0, 0 };
    for (int32_t k = g->first[g->edge[e].to]; k >= 0; k = g->next[k]) {
        const sp_real *t = g->xy[g->edge[k].to];
        const sp_real d[2] = { t[0] - v[0], t[1] - v[1] };
        if (g->edge[k].w[0]) continue;                  /* used */
        if (best >= 0 && !sp__clip_turns_before(back, d, lead)) continue;
        best = k;
        lead[0] = d[0];
        lead[1] = d[1];
    }
    return best;
}

/* Distance of p from the segment a b, squared. */
static sp_real sp__clip_distance2(const sp_real p[2], const sp_real a[2], const sp_real b[2])
{
    const sp_real dx = b[0] - a[0], dy = b[1] - a[1], len2 = dx * dx + dy * dy;
    sp_real t = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy;
    t = t <= 0 || !(len2 > 0) ? 0 : t >= len2 ? 1 : t / len2;
    const sp_real x = a[0] + t * dx - p[0], y = a[1] + t * dy - p[1];
    return x * x + y * y;
}

/* Take corners out of the last loop that lie on the line between their neighbours. */
static void sp__clip_straighten(sp__clip *c)
{
    const int32_t from = c->loop[c->loops];
    for (int32_t k = from, calm = 0; calm < c->corners - from && c->corners - from > 3; ) {
        const int32_t n = c->corners - from, i = (k - from) % n;
        const int32_t prev = from + (i + n - 1) % n, next = from + (i + 1) % n, at = from + i;
        if (sp__clip_distance2(c->corner[at].x, c->corner[prev].x, c->corner[next].x) > c->snap * c->snap) {
            k = at + 1;
            calm++;
            continue;
        }
        c->corners--;
        for (int32_t j = at; j < c->corners; j++) c->corner[j] = c->corner[j + 1];
        calm = 0;
        k = i ? at - 1 : c->corners - 1;
    }
}

/* Note a line through the hole whose corners are the last ones, unless one through its inner 8/10 is there already. */
static void sp__clip_add_cut(sp__clip *c)
{
    sp_real lo = c->corner[c->loop[c->loops]].x[0], hi = lo;
    for (int32_t k = c->loop[c->loops]; k < c->corners; k++) {
        const sp_real x = c->corner[k].x[0];
        lo = x < lo ? x : lo;
        hi = x > hi ? x : hi;
    }
    const sp_real mid = (lo + hi) / 2, rim = (hi - lo) / 10;
    for (int32_t k = 0; k < c->cut.lines; k++) if (c->cut.x[k] > lo + rim && c->cut.x[k] < hi - rim) return;
    if (c->cut.lines >= c->g.node_capacity) { c->full = 1; return; }
    int32_t k = c->cut.lines++;
    for (; k > 0 && c->cut.x[k - 1] > mid; k--) c->cut.x[k] = c->cut.x[k - 1];
    c->cut.x[k] = mid;
}

/* Put the simple loop path[from..to) out: kept if it goes round anticlockwise and is not thin; a hole asks for a cut. */
static void sp__clip_put_loop(sp__clip *c, int32_t from, int32_t to)
{
    const int32_t start = c->corners;
    sp_real area2 = 0, around = 0;
    if (c->corners + (to - from) > c->g.edge_capacity || c->loops >= c->g.node_capacity) { c->full = 1; return; }
    const sp_real *o = c->g.xy[c->g.path[from]];
    for (int32_t k = from; k < to; k++) {
        const sp_real *p = c->g.xy[c->g.path[k]], *q = c->g.xy[c->g.path[k + 1 < to ? k + 1 : from]];
        const sp_real dx = q[0] - p[0], dy = q[1] - p[1];
        area2 += sp__clip_turn(o, p, q);
        around += SP_SQRT(dx * dx + dy * dy);
        const sp__clip_corner at = { { p[0], p[1] }, c->g.label[c->g.path[k]] };
        c->corner[c->corners++] = at;
    }
    c->loop[c->loops] = start;
    if (area2 > c->thin * around) {
        sp__clip_straighten(c);
        c->loop[++c->loops] = c->corners;
        return;
    }
    if (-area2 > c->slit * around) {
        c->cut.holes++;
        if (!c->cut.opening) sp__clip_add_cut(c);
    }
    c->corners = start;
}

/* Follow the boundary from edge e back to it. Where it comes to a node a second time, a simple loop is complete. */
static void sp__clip_walk(sp__clip *c, int32_t start)
{
    int32_t depth = 0, e = start;
    c->g.path[depth] = c->g.edge[e].from;
    c->g.place[c->g.path[depth]] = depth;
    depth++;
    for (;;) {
        const int32_t v = c->g.edge[e].to;
        if (c->g.place[v] < 0) {
            c->g.place[v] = depth;
            c->g.path[depth++] = v;
        } else {
            const int32_t from = c->g.place[v];
            sp__clip_put_loop(c, from, depth);
            while (depth > from + 1) c->g.place[c->g.path[--depth]] = -1;
        }
        if (e != start) c->g.edge[e].w[0] = 1;
        e = sp__clip_next_edge(&c->g, e);
        if (e < 0 || e == start) break;
    }
    if (e < 0) c->torn++;
    c->g.edge[start].w[0] = 1;
    while (depth > 0) c->g.place[c->g.path[--depth]] = -1;
}

/* Every unused edge starts a walk along the boundary. */
static void sp__clip_trace(sp__clip *c)
{
    for (int32_t k = 0; k < c->g.nodes; k++) c->g.first[k] = c->g.place[k] = -1;
    for (int32_t k = c->g.edges - 1; k >= 0; k--) {
        c->g.next[k] = c->g.first[c->g.edge[k].from];
        c->g.first[c->g.edge[k].from] = k;
    }
    for (int32_t k = 0; k < c->g.edges && !c->full; k++) if (!c->g.edge[k].w[0]) sp__clip_walk(c, k);
}

/* The boundary of the common region, traced; with another eps where rounding left it open. */
static void sp__clip_intersect(sp__clip *c)
{
    for (int attempt = 0; attempt < 3; attempt++) {
        c->snap = attempt == 0 ? c->eps : attempt == 1 ? 3 * c->eps : c->eps / 3;
        sp__clip_arrange(c);
        if (c->full || sp__clip_classify(&c->g)) break;
    }
    if (!c->full) sp__clip_trace(c);
}

/* -------------------------------------------------------------------------------------------------------------- 4 cut */

/* Make the traced pieces the input. Returns their number. */
static int32_t sp__clip_reuse_pieces(sp__clip *c)
{
    c->in.segments = c->corners = c->loops = c->cut.holes = 0;
    for (int32_t k = 0; k < c->g.edges; k++) {
        const int32_t u = c->g.edge[k].from, v = c->g.edge[k].to;
        sp__clip_add(c, 0, c->g.xy[u], c->g.xy[v], c->g.label[u], c->g.label[v]);
    }
    return c->in.segments;
}

/* Add the box lo .. hi as region Q, anticlockwise. */
static void sp__clip_add_box(sp__clip *c)
{
    sp_real from[2] = { c->cut.lo[0], c->cut.lo[1] }, to[2] = { c->cut.lo[0], c->cut.lo[1] };
    for (int k = 0; k < 4; k++) {
        const int along = k & 1;                                    /* right, up, left, down */
        to[along] = k < 2 ? c->cut.hi[along] : c->cut.lo[along];
        sp__clip_add(c, 1, from, to, -1, -1);
        from[along] = to[along];
    }
}

/* Clip the region found to the strips between the cuts: no hole is left whole. Forces at corners that the lines add are
 * mixtures of forces at true corners, so what a polygon can carry does not change. */
static void sp__clip_cut_holes(sp__clip *c)
{
    const int32_t cuts = c->cut.lines, pieces = sp__clip_reuse_pieces(c);
    for (int k = 0; k < 2; k++) {
        c->cut.lo[k] = c->cut.hi[k] = c->in.segment[0][k];
        for (int32_t s = 0; s < pieces; s++) {
            const sp_real x = c->in.segment[s][k];
            c->cut.lo[k] = x < c->cut.lo[k] ? x : c->cut.lo[k];
            c->cut.hi[k] = x > c->cut.hi[k] ? x : c->cut.hi[k];
        }
        const sp_real wide = c->cut.hi[k] - c->cut.lo[k];
        c->cut.lo[k] -= wide;
        c->cut.hi[k] += wide;
    }
    const sp_real end = c->cut.hi[0];
    c->thin = c->slit = c->eps;
    c->cut.opening = 1;
    for (int32_t k = 0; k <= cuts && !c->full; k++) {
        c->in.segments = pieces;
        c->cut.hi[0] = k < cuts ? c->cut.x[k] : end;
        sp__clip_add_box(c);
        sp__clip_intersect(c);
        c->cut.lo[0] = c->cut.hi[0];
    }
    c->torn += c->cut.holes;
}

/* Common region of P and Q: c->loops simple polygons. Returns 0 if the room of sp__clip_carve was too small. */
static int sp__clip_run(sp__clip *c, sp_real eps, sp_real thin)
{
    c->eps = eps;
    c->thin = thin > eps ? thin : eps;
    if (c->slit < c->thin) c->slit = c->thin;
    c->corners = c->loops = c->cut.holes = c->cut.lines = c->cut.opening = 0;
    c->loop[0] = 0;
    if (!c->full) sp__clip_intersect(c);
    if (!c->full && c->cut.holes) sp__clip_cut_holes(c);
    return !c->full;
}

#endif
#endif /* SP__CLIP_C */
