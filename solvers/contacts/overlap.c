/* overlap: how deep two blocks penetrate each other.
 *
 *   convex      least overlap of the projections on the face normals and the cross products of edges     [separating axes]
 *   otherwise   the deepest vertex, or point on an edge, of one inside the other; 0 where a plane along a face separates them
 */
#ifndef SP__CONTACTS_OVERLAP_C
#define SP__CONTACTS_OVERLAP_C

#include "face.c"

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
            const sp_real size = sp__norm3(d) * sp__norm3(e);
            sp__cross3(d, e, d);
            const sp_real length = sp__norm3(d);
            if (!(length > (sp_real)1e-4 * size)) continue;         /* parallel: no axis of its own */
            sp__scale3((sp_real)1 / length, d, d);
            const sp_real x = sp__shadow(t, d);
            if (x < least) least = x;
            if (least <= flat) return least;
        }
    return least;
}

/* Does the upward ray from x pass right of the directed edge p q, seen from above? +1, -1 or 0, the same for q p but for the
 * sign. Half-open in y. */
static int sp__ray_edge(const sp_real x[3], const sp_real p[3], const sp_real q[3])
{
    const int up = p[1] <= x[1], to = q[1] <= x[1];
    if (up == to) return 0;
    const sp_real *lo = up ? p : q, *hi = up ? q : p;
    const sp_real side = (hi[0] - lo[0]) * (x[1] - lo[1]) - (hi[1] - lo[1]) * (x[0] - lo[0]);
    return side > 0 ? (up ? 1 : -1) : 0;
}

/* Squared distance of x from the triangle v[0] v[1] v[2] with normal n (not 0): from its plane over its inside, else from the
 * nearest edge, d - s e with s = clamp(d . e / e . e). */
static sp_real sp__triangle_distance2(const sp_real x[3], const sp_real *const v[3], const sp_real n[3])
{
    sp_real e[3], d[3], c[3], least = -1, h = 0;
    int inside = 1;
    for (int k = 0; k < 3; k++) {
        sp__sub3(v[(k + 1) % 3], v[k], e);
        sp__sub3(x, v[k], d);
        h = sp__dot3(d, n);
        sp__cross3(e, d, c);
        if (sp__dot3(c, n) < 0) inside = 0;
        const sp_real len2 = sp__dot3(e, e), along = sp__dot3(d, e);
        const sp_real s = along <= 0 || !(len2 > 0) ? 0 : along >= len2 ? (sp_real)1 : along / len2;
        for (int i = 0; i < 3; i++) d[i] -= s * e[i];
        const sp_real far2 = sp__dot3(d, d);
        if (least < 0 || far2 < least) least = far2;
    }
    return inside ? h * h / sp__dot3(n, n) : least;
}

/* How deep x lies inside a closed block: 0 if outside, or not deeper than `flat`. Inside: the faces above wind round it. */
static sp_real sp__depth(const sp__touch *t, int32_t block, const sp_real x[3], sp_real flat)
{
    const sp_scene *s = t->scene;
    const sp_block *k = &s->block[block];
    sp_real least2 = k->diameter * k->diameter;
    int wind = 0;
    if (!(k->volume > 0)) return 0;
    const sp__body *body = &t->all.body[block];
    for (int c = 0; c < 3; c++) if (x[c] < body->lo[c] + flat || x[c] > body->hi[c] - flat) return 0;
    for (int32_t f = k->face; f < k->face + k->faces; f++)
        for (int32_t i = 1; i + 1 < s->face[f].corners; i++) {
            const int32_t *corner = s->corner + s->face[f].corner;
            const sp_real *const v[3] = { s->vertex[corner[0]], s->vertex[corner[i]], s->vertex[corner[i + 1]] };
            sp_real d[3], n[3];
            sp__sub3(v[1], v[0], d);
            sp__sub3(v[2], v[0], n);
            sp__cross3(d, n, n);
            if (!(sp__dot3(n, n) > 0)) continue;
            const sp_real far2 = sp__triangle_distance2(x, v, n);
            if (far2 <= flat * flat) return 0;
            if (far2 < least2) least2 = far2;
            const int w = sp__ray_edge(x, v[0], v[1]) + sp__ray_edge(x, v[1], v[2]) + sp__ray_edge(x, v[2], v[0]);
            sp__sub3(v[0], x, d);
            if (w && (n[2] > 0 ? sp__dot3(d, n) > 0 : sp__dot3(d, n) < 0)) wind += w;
        }
    return wind > 0 ? SP_SQRT(least2) : 0;
}

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
static sp_real sp__depth_edges(const sp__touch *t, int32_t inner, int32_t outer, sp_real flat)
{
    const sp__body *k = &t->all.body[inner];
    const int64_t work = (int64_t)k->edges * t->scene->block[outer].faces;
    const int steps = work < 20000 ? 8 : 2;
    sp_real most = 0;
    for (int32_t e = k->edge; e < k->edge + k->edges; e++) {
        const sp_real *p = t->scene->vertex[t->all.bound[e][0]], *q = t->scene->vertex[t->all.bound[e][1]];
        sp_real s[2], x[3];
        most = sp__max(most, sp__depth(t, outer, p, flat));
        if (!sp__edge_is_first(t, t->all.bound[e])) continue;
        sp__edge_in_box(p, q, &t->all.body[outer], s);
        for (int i = 1; i < steps && s[0] < s[1]; i++) {
            const sp_real at = s[0] + (s[1] - s[0]) * (sp_real)i / (sp_real)steps;
            for (int c = 0; c < 3; c++) x[c] = p[c] + at * (q[c] - p[c]);
            most = sp__max(most, sp__depth(t, outer, x, flat));
        }
    }
    return most;
}

/* Depth of the present pair inside each other, at most `flat` if none is seen.
 *   convex, closed   separating axes: always seen, least way out
 *   other shapes     only what is certain: no plane along a face keeps them apart, and a vertex, a point on an edge, or a
 *                    centroid of one is inside the other; depth of that point. Thin crossings may be missed; touching blocks
 *                    are never reported
 *   open or flat     supports have no inside: only their vertices and edges inside the other are seen */
static sp_real sp__pair_depth(const sp__touch *t, sp_real flat)
{
    const sp__body *p = &t->all.body[t->now.a], *q = &t->all.body[t->now.b];
    const int64_t work = (int64_t)p->edges * q->edges * (p->edges + q->edges) / 4;
    for (int c = 0; c < 3; c++) if (p->hi[c] - q->lo[c] <= flat || q->hi[c] - p->lo[c] <= flat) return 0;
    const sp_real least = sp__shadow_faces(t, flat);
    if (least <= flat) return 0;
    if (p->convex && q->convex && work <= 10000000) return sp__shadow_edges(t, least, flat);
    if (!SP__HAS_STRENGTH) return 0;
    sp_real most = sp__max(sp__depth_edges(t, t->now.a, t->now.b, flat), sp__depth_edges(t, t->now.b, t->now.a, flat));
    for (int side = 0; side < 2; side++) {
        const sp_real *x = t->scene->block[side ? t->now.b : t->now.a].centroid;
        const sp_real d = sp__depth(t, t->now.a, x, flat), e = sp__depth(t, t->now.b, x, flat);
        most = sp__max(most, d < e ? d : e);
    }
    return most < least ? most : least;
}

/* Report the pair if it overlaps by more than its distance and what its faces are warped by. */
SP__NOINLINE_SMALL static void sp__pair_overlap(sp__touch *t)
{
    const sp_real flat = t->now.gap + 2 * (t->all.body[t->now.a].warp + t->all.body[t->now.b].warp);
    const sp_real depth = sp__pair_depth(t, flat);
    if (!(depth > flat)) return;
    if (t->report.overlap && t->report.overlaps < t->report.overlap_capacity) {
        const sp_overlap o = { t->now.a, t->now.b, depth };
        t->report.overlap[t->report.overlaps] = o;
    }
    t->report.overlaps++;
}

#endif /* SP__CONTACTS_OVERLAP_C */
