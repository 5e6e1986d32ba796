/* patch: faces of a block in one plane become one patch, bounded by the edges that no opposite edge cancels.
 * Larger faces go first, ties by place, so the order of faces does not matter. Not in SP_SMALL: small_patch.c. */
#ifndef SP__CONTACTS_PATCH_C
#define SP__CONTACTS_PATCH_C

#include "face.c"

#if !SP__WITH_SMALL

/* Larger faces first: the largest of a plane is the most exact. Equal ones by place, so face order does not matter. */
static int sp__face_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    if (t->all.area[i] > t->all.area[j]) return 1;
    if (t->all.area[i] < t->all.area[j]) return 0;
    const int o = sp__place_order(t->all.middle[i], t->all.middle[j], 0);
    return o ? o < 0 : i < j;
}

/* Edges between the same two vertices stand together. */
static int sp__edge_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const int32_t *p = t->all.edge[i], *q = t->all.edge[j];
    const int32_t plo = p[0] < p[1] ? p[0] : p[1], qlo = q[0] < q[1] ? q[0] : q[1];
    const int32_t phi = p[0] + p[1] - plo, qhi = q[0] + q[1] - qlo;
    if (plo != qlo) return plo < qlo;
    return phi != qhi ? phi < qhi : i < j;
}

/* same[v]: the first vertex at v's place. */
static int sp__vertex_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const int o = sp__place_order(t->scene->vertex[t->own.vertex0 + i], t->scene->vertex[t->own.vertex0 + j], 0);
    return o ? o < 0 : i < j;
}

/* t->all.same[v]: the first in order of the vertices that lie where v lies, to the bit. */
static void sp__touch_weld(sp__touch *t)
{
    const sp_block *k = &t->scene->block[t->own.block];
    for (int32_t v = 0; v < k->vertices; v++) t->all.order[v] = v;
    sp__sort(t->all.order, k->vertices, sp__vertex_before, t);
    int32_t first = 0;
    for (int32_t i = 0; i < k->vertices; i++) {
        const int32_t v = t->own.vertex0 + t->all.order[i];
        if (!i || sp__place_order(t->scene->vertex[first], t->scene->vertex[v], 0)) first = v;
        t->all.same[v] = first;
    }
}

/* Perimeter of a face. */
static sp_real sp__face_round(const sp__touch *t, int32_t f)
{
    const sp_face *face = &t->scene->face[t->own.face0 + f];
    const int32_t *corner = t->scene->corner + face->corner;
    sp_real sum = 0, d[3];
    for (int32_t k = 0; k < face->corners; k++) {
        sp__sub3(t->scene->vertex[corner[k + 1 < face->corners ? k + 1 : 0]], t->scene->vertex[corner[k]], d);
        sum += sp__norm3(d);
    }
    return sum;
}

/* Patches by their normals: a grid of side^3 cells over -1 .. 1 in the array `edge`; in each the last patch, behind them to
 * each patch the one before. */
typedef struct sp__normals { int32_t *last, *before, side; } sp__normals;

static sp__normals sp__normals_start(const sp__touch *t, int32_t faces)
{
    sp__normals g = { t->all.edge[0], NULL, 1 };
    while (8 * (int64_t)g.side * g.side * g.side <= faces) g.side *= 2;
    g.before = g.last + g.side * g.side * g.side;
    for (int32_t *c = g.last; c < g.before; c++) *c = -1;
    return g;
}

static int32_t sp__normals_step(const sp__normals *g, sp_real x)
{
    const int32_t i = (int32_t)((x + 1) / 2 * (sp_real)g->side);
    return i < 0 ? 0 : i < g->side ? i : g->side - 1;
}

static int32_t sp__normals_cell(const sp__normals *g, int32_t x, int32_t y, int32_t z)
{
    return (x * g->side + y) * g->side + z;
}

/* Do all corners of face f keep to the plane of patch p? If so their mean does. */
static int sp__patch_holds(const sp__touch *t, const sp__patch *p, int32_t f, sp_real flat)
{
    sp_real d[3];
    if (!(sp__dot3(p->n, t->all.normal[f]) > 0)) return 0;
    sp__sub3(t->all.middle[f], p->o, d);
    return sp__abs(sp__dot3(p->n, d)) <= 2 * flat && sp__face_distance(t, f, p->n, p->o) <= flat;
}

/* The first patch whose plane holds all corners of face f; its normal then differs from n by
 *   sin = |n_p x integral of x over the boundary| / area <= flat perimeter / area
 * and lies in a neighbouring cell, where that is less than one. */
static int32_t sp__patch_of(const sp__touch *t, const sp__normals *g, const sp__body *body, int32_t f, sp_real flat)
{
    const sp_real *n = t->all.normal[f];
    const int close = 4 * flat * sp__face_round(t, f) * (sp_real)g->side <= t->all.area[f];
    const int32_t x = sp__normals_step(g, n[0]), y = sp__normals_step(g, n[1]), z = sp__normals_step(g, n[2]);
    const int32_t end = g->side - 1;
    int32_t first = t->patches;
    if (!close || g->side == 1) {
        for (int32_t p = body->patch; p < t->patches; p++) if (sp__patch_holds(t, &t->all.patch[p], f, flat)) return p;
        return first;
    }
    for (int32_t i = x > 0 ? x - 1 : 0; i <= (x < end ? x + 1 : end); i++)
        for (int32_t j = y > 0 ? y - 1 : 0; j <= (y < end ? y + 1 : end); j++)
            for (int32_t k = z > 0 ? z - 1 : 0; k <= (z < end ? z + 1 : end); k++)
                for (int32_t p = g->last[sp__normals_cell(g, i, j, k)]; p >= 0; p = g->before[p - body->patch])
                    if (p < first && sp__patch_holds(t, &t->all.patch[p], f, flat)) first = p;
    return first;
}

static void sp__patch_start(sp__touch *t, const sp__normals *g, const sp__body *body, int32_t f)
{
    const sp_real *n = t->all.normal[f];
    const int32_t x = sp__normals_step(g, n[0]), y = sp__normals_step(g, n[1]), z = sp__normals_step(g, n[2]);
    int32_t *last = &g->last[sp__normals_cell(g, x, y, z)];
    sp__patch *p = &t->all.patch[t->patches];
    memcpy(p->n, n, sizeof p->n);
    memcpy(p->o, t->all.middle[f], sizeof p->o);
    g->before[t->patches - body->patch] = *last;
    *last = t->patches++;
}

/* Give each face with area its patch: the first whose plane all its corners keep to, or a new one. */
SP__NOINLINE static void sp__touch_group(sp__touch *t, sp__body *body, int32_t faces)
{
    const sp_real flat = sp__plane_tolerance(t, body);
    if (!faces) return;
    const sp__normals g = sp__normals_start(t, faces);
    for (int32_t f = 0; f < faces; f++) {
        t->all.area[f] = sp__face_plane(t, f, t->all.normal[f], t->all.middle[f]);
        body->warp = sp__max(body->warp, sp__face_distance(t, f, t->all.normal[f], t->all.middle[f]));
        t->all.order[f] = f;
    }
    sp__sort(t->all.order, faces, sp__face_before, t);
    for (int32_t i = 0; i < faces; i++) {
        const int32_t f = t->all.order[i];
        t->all.mine[f] = -1;
        if (!(t->all.area[f] > 0)) continue;
        t->all.mine[f] = sp__patch_of(t, &g, body, f, flat);
        if (t->all.mine[f] == t->patches) sp__patch_start(t, &g, body, f);
    }
}

/* All edges of a face, by the vertices that stand for their places. */
static void sp__touch_edges(sp__touch *t, int32_t f)
{
    const sp_face *face = &t->scene->face[t->own.face0 + f];
    const int32_t *corner = t->scene->corner + face->corner;
    for (int32_t k = 0; k < face->corners; k++) {
        t->all.edge[t->own.edges][0] = t->all.same[corner[k]];
        t->all.edge[t->own.edges][1] = t->all.same[corner[k + 1 < face->corners ? k + 1 : 0]];
        t->own.edges++;
    }
}

/* Boundary of a patch from t->all.edge: of the edges between two vertices those that their opposites do not cancel. */
static void sp__touch_boundary(sp__touch *t, sp__patch *p)
{
    int32_t *order = t->all.order;
    p->edge = t->bounds;
    for (int32_t k = 0; k < t->own.edges; k++) order[k] = k;
    sp__sort(order, t->own.edges, sp__edge_before, t);
    for (int32_t k = 0; k < t->own.edges; ) {
        const int32_t u = t->all.edge[order[k]][0], v = t->all.edge[order[k]][1];
        int32_t net = 0;
        for (; k < t->own.edges; k++) {
            const int32_t *e = t->all.edge[order[k]];
            if (e[0] == u && e[1] == v) net++;
            else if (e[0] == v && e[1] == u) net--;
            else break;
        }
        for (; net && u != v; net += net < 0 ? 1 : -1) {
            t->all.bound[t->bounds][0] = net > 0 ? u : v;
            t->all.bound[t->bounds++][1] = net > 0 ? v : u;
        }
    }
    p->edges = t->bounds - p->edge;
    sp__bound_box(t, p->edge, t->bounds, p->lo, p->hi);
}

/* Patches of a block: its faces by plane. Of each patch the first face, of each face the next, where normals were. */
static void sp__touch_patches(sp__touch *t, sp__body *body, int32_t faces)
{
    int32_t *next = (int32_t *)(void *)t->all.normal;
    t->inside.block = 0;
    sp__touch_weld(t);
    sp__touch_group(t, body, faces);
    for (int32_t p = body->patch; p < t->patches; p++) t->all.patch[p].edge = -1;
    for (int32_t f = faces; f-- > 0; ) {
        if (t->all.mine[f] < 0) continue;
        next[f] = t->all.patch[t->all.mine[f]].edge;
        t->all.patch[t->all.mine[f]].edge = f;
    }
    for (int32_t p = body->patch; p < t->patches; p++) {
        t->own.edges = 0;
        for (int32_t f = t->all.patch[p].edge; f >= 0; f = next[f]) sp__touch_edges(t, f);
        sp__touch_boundary(t, &t->all.patch[p]);
    }
}

#endif

#endif /* SP__CONTACTS_PATCH_C */
