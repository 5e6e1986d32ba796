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

/* Give each face with area its patch: the first whose plane all its corners keep to, or a new one. */
static void sp__touch_group(sp__touch *t, sp__body *body, int32_t faces)
{
    const sp_real flat = sp__plane_tolerance(t, body);
    for (int32_t f = 0; f < faces; f++) {
        t->all.area[f] = sp__face_plane(t, f, t->all.normal[f], t->all.middle[f]);
        body->warp = sp__max(body->warp, sp__face_distance(t, f, t->all.normal[f], t->all.middle[f]));
        t->all.order[f] = f;
    }
    sp__sort(t->all.order, faces, sp__face_before, t);
    for (int32_t i = 0; i < faces; i++) {
        const int32_t f = t->all.order[i];
        int32_t p = body->patch;
        t->all.mine[f] = -1;
        if (!(t->all.area[f] > 0)) continue;
        for (; p < t->patches; p++)
            if (sp__dot3(t->all.patch[p].n, t->all.normal[f]) > 0
                && sp__face_distance(t, f, t->all.patch[p].n, t->all.patch[p].o) <= flat) break;
        t->all.mine[f] = p;
        if (p < t->patches) continue;
        for (int c = 0; c < 3; c++) {
            t->all.patch[p].n[c] = t->all.normal[f][c];
            t->all.patch[p].o[c] = t->all.middle[f][c];
        }
        t->patches++;
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

/* Patches of a block: its faces by plane. */
static void sp__touch_patches(sp__touch *t, sp__body *body, int32_t faces)
{
    sp__touch_weld(t);
    sp__touch_group(t, body, faces);
    for (int32_t p = body->patch; p < t->patches; p++) {
        t->own.edges = 0;
        for (int32_t f = 0; f < faces; f++) if (t->all.mine[f] == p) sp__touch_edges(t, f);
        sp__touch_boundary(t, &t->all.patch[p]);
    }
}

#endif

#endif /* SP__CONTACTS_PATCH_C */
