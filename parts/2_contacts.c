/* contacts: which faces of which blocks touch, and in what polygons.
 *
 *   patch      all faces of one block in one plane and with one direction; bounded by the edges that do not cancel
 *   bound      boundary edges of the patches, vertex numbers of the scene, patch on the left seen from outside
 *   noise      16 u (|coordinate| + diameter): no tolerance is below it, so float and far coordinates work          [m]
 *   near       settings' distance of a pair of blocks, at least the noise                                           [m]
 *
 *   distance   of two patches: along A's normal, in the middle of what they share; the angle bounds the rest
 *   in-plane   corners nearer than min(near, 1e-6 diameter)/8 are one; what is narrower than `near` is an edge contact, and
 *              left out
 *
 * Boxes in a balanced tree by Morton order find the pairs, n log n whatever the sizes are mixed like; a slab under everything
 * costs its own pairs and no more.
 */

typedef struct sp__patch {
    sp_real n[3], o[3];         /* plane: outward unit normal and a point of the largest face */
    sp_real lo[3], hi[3];       /* box */
    int32_t edge, edges;        /* its part of bound */
} sp__patch;

typedef struct sp__body {       /* what the search knows of a block */
    sp_real lo[3], hi[3];       /* box, of its faces only */
    sp_real noise, reach;       /* see above; its own settings' distance */
    sp_real warp;               /* farthest corner of a face from the face's plane */
    int32_t patch, patches, edge, edges;
    int32_t convex;             /* closed and nothing beyond any of its faces */
} sp__body;

typedef struct sp__found { int32_t start, size; } sp__found;    /* a polygon of the present pair */

/* The largest of a number over the blocks, and the largest of the others. */
typedef struct sp__two { int32_t first, second; } sp__two;

/* Edges of one patch, of a block; patches of a block. */
typedef struct sp__most { sp__two side, total, patches; } sp__most;

/* Memory of the search. */
typedef struct sp__all {
    sp__body *body;
    sp__patch *patch;
    int32_t (*bound)[2];
    int32_t *same;                              /* vertex -> the vertex that stands for all at its place */
    int32_t *order, *mine;                      /* of one block: vertices, faces or edges in order; face -> patch */
    int32_t (*edge)[2];                         /* of one block */
    sp_real (*normal)[3], (*middle)[3], *area;  /* of the faces of one block */
    int32_t width;                              /* of the tree: power of two, not below the number of blocks */
    sp_real (*box)[6];                          /* of the tree's nodes, 1 the top, children 2k and 2k + 1 */
    int32_t *leaf, *hit;                        /* block of each leaf; blocks that may touch the present one */
    uint32_t *code;                             /* Morton code of each block */
} sp__all;

/* Memory of one pair of blocks. */
typedef struct sp__pair {
    int32_t *near_a, *near_b;                   /* patches near the other block's box */
    sp_real (*point)[3];                        /* polygons found */
    sp__found *found;
    int32_t *rank;                              /* their order */
    int32_t room;                               /* of the last three */
} sp__pair;

typedef struct sp__touch {
    sp_scene *scene;
    sp_contact_settings set;
    sp_contact_report report;
    sp_capacity before;                         /* the scene's count at the start */
    sp_status status;
    int32_t full;                               /* the scene had no room for something */
    sp__all all;
    sp__clip clip;
    sp__pair pair;
    sp__most most;
    int32_t patches, bounds, leaves;
    sp_real lo[3], hi[3];                       /* box of everything */
    int32_t block, vertex0, face0, edges;       /* of the block whose patches are being made */
    int32_t a, b, points, founds;               /* present pair, and what was found */
    sp_real near, noise, snap, unit;            /* of that pair; unit: length of 1 in the plane of the clipping [m] */
    sp_real e1[3], e2[3];                       /* axes of that plane */
} sp__touch;

static void sp__contact_default(sp_contact_settings *s)
{
    memset(s, 0, sizeof *s);
    s->distance = (sp_real)1e-6;
    s->angle = (sp_real)1e-3;
    s->joint.mu = (sp_real)0.84;
}

SP_API sp_contact_settings sp_contact_settings_default(void)
{
    sp_contact_settings s;
    sp__contact_default(&s);
    return s;
}

/* ------------------------------------------------------------------------------------------------------------- memory */

/* Crossings of boundaries of p and q edges that there is room for: all up to 16-gons; otherwise 8 (p + q), four times what a
 * convex one can have with any other. Combs across combs may need more: SP_E_MEMORY. */
static int64_t sp__crossings(const sp__two *t)
{
    const int64_t all = (int64_t)t->first * t->second, most = 8 * ((int64_t)t->first + t->second);
    return all < most ? all : most;
}

static void sp__two_add(sp__two *t, int32_t x)
{
    if (x > t->first) { t->second = t->first; t->first = x; }
    else if (x > t->second) t->second = x;
}

/* Corners of the faces of a block. */
static int32_t sp__block_corners(const sp_scene *scene, int32_t block)
{
    const sp_face *f = scene->face + scene->block[block].face;
    const int32_t n = scene->block[block].faces;
    return n ? f[n - 1].corner + f[n - 1].corners - f[0].corner : 0;
}

static void sp__all_carve(sp__all *l, const sp_scene *scene, sp_arena *a)
{
    const sp_capacity *n = &scene->count;
    int32_t vertices = 0, faces = 0, corners = 0;
    for (int32_t i = 0; i < n->blocks; i++) {
        const sp_block *k = &scene->block[i];
        const int32_t c = sp__block_corners(scene, i);
        vertices = k->vertices > vertices ? k->vertices : vertices;
        faces = k->faces > faces ? k->faces : faces;
        corners = c > corners ? c : corners;
    }
    const size_t blocks = (size_t)n->blocks, face = (size_t)faces;
    for (l->width = 1; l->width < n->blocks && l->width < 1 << 29; l->width *= 2) { }
    l->body = sp__take(a, blocks, sizeof *l->body);
    l->patch = sp__take(a, (size_t)n->faces, sizeof *l->patch);
    l->bound = sp__take(a, (size_t)n->corners, sizeof *l->bound);
    l->same = sp__take(a, (size_t)n->vertices, sizeof *l->same);
    l->order = sp__take(a, (size_t)(vertices > corners ? vertices : corners), sizeof *l->order);
    l->mine = sp__take(a, face, sizeof *l->mine);
    l->edge = sp__take(a, (size_t)corners, sizeof *l->edge);
    l->normal = sp__take(a, face, sizeof *l->normal);
    l->middle = sp__take(a, face, sizeof *l->middle);
    l->area = sp__take(a, face, sizeof *l->area);
    l->box = sp__take(a, 2 * (size_t)l->width, sizeof *l->box);
    l->leaf = sp__take(a, blocks, sizeof *l->leaf);
    l->hit = sp__take(a, blocks, sizeof *l->hit);
    l->code = sp__take(a, blocks, sizeof *l->code);
}

static void sp__pair_carve(sp__pair *p, const sp__most *most, sp_arena *a)
{
    const int64_t room = 2 * ((int64_t)most->total.first + most->total.second + sp__crossings(&most->side)) + 64;
    p->room = room < INT32_MAX ? (int32_t)room : 0;
    p->near_a = sp__take(a, (size_t)most->patches.first, sizeof *p->near_a);
    p->near_b = sp__take(a, (size_t)most->patches.first, sizeof *p->near_b);
    p->point = sp__take(a, (size_t)room, sizeof *p->point);
    p->found = sp__take(a, (size_t)room, sizeof *p->found);
    p->rank = sp__take(a, (size_t)room, sizeof *p->rank);
}

/* Before the patches are known: a block has no more of them than faces, and no more edges than corners. Of a closed block one
 * patch has at most half of these, because their opposites bound others. */
static void sp__most_guess(sp__most *most, const sp_scene *scene)
{
    memset(most, 0, sizeof *most);
    for (int32_t i = 0; i < scene->count.blocks; i++) {
        const int32_t corners = sp__block_corners(scene, i);
        sp__two_add(&most->side, scene->block[i].volume > 0 ? corners / 2 : corners);
        sp__two_add(&most->total, corners);
        sp__two_add(&most->patches, scene->block[i].faces);
    }
}

SP_API size_t sp_contacts_memory(const sp_scene *scene)
{
    sp_arena dry = sp__arena_dry();
    union { sp__all all; sp__clip clip; sp__pair pair; } none;
    sp__most most;
    if (!scene) return 0;
    sp__most_guess(&most, scene);
    (void)sp__take(&dry, 1, sizeof(sp__touch));
    sp__all_carve(&none.all, scene, &dry);
    sp__clip_carve(&none.clip, most.side.first, most.side.second, sp__crossings(&most.side), &dry);
    sp__pair_carve(&none.pair, &most, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

/* ------------------------------------------------------------------------------------------------------------ patches */

/* Lexicographic order of places; 0: the same. */
static int sp__place_order(const sp_real p[3], const sp_real q[3], sp_real eps)
{
    for (int c = 0; c < 3; c++) {
        if (p[c] < q[c] - eps) return -1;
        if (p[c] > q[c] + eps) return 1;
    }
    return 0;
}

static int sp__vertex_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const int o = sp__place_order(t->scene->vertex[t->vertex0 + i], t->scene->vertex[t->vertex0 + j], 0);
    return o ? o < 0 : i < j;
}

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

/* same[v]: the first vertex, in order, at v's place. */
static void sp__touch_weld(sp__touch *t)
{
    const sp_block *k = &t->scene->block[t->block];
    for (int32_t v = 0; v < k->vertices; v++) t->all.order[v] = v;
    sp__sort(t->all.order, k->vertices, sp__vertex_before, t);
    int32_t first = 0;
    for (int32_t i = 0; i < k->vertices; i++) {
        const int32_t v = t->vertex0 + t->all.order[i];
        if (!i || sp__place_order(t->scene->vertex[first], t->scene->vertex[v], 0)) first = v;
        t->all.same[v] = first;
    }
}

/* Plane of a face through its vertex mean, by Newell's normal about its first corner; normal 0 and area 0 without one. */
static void sp__touch_plane(sp__touch *t, int32_t f)
{
    const sp_face *face = &t->scene->face[t->face0 + f];
    const int32_t *corner = t->scene->corner + face->corner;
    const sp_real *o = t->scene->vertex[corner[0]];
    sp_real *n = t->all.normal[f], *m = t->all.middle[f], p[3], q[3];
    for (int c = 0; c < 3; c++) n[c] = m[c] = 0;
    for (int32_t k = 0; k < face->corners; k++) {
        sp__sub3(t->scene->vertex[corner[k]], o, p);
        sp__sub3(t->scene->vertex[corner[k + 1 < face->corners ? k + 1 : 0]], o, q);
        sp__cross3_add(p, q, n);
        for (int c = 0; c < 3; c++) m[c] += p[c];
    }
    const sp_real twice = sp__norm3(n);
    t->all.area[f] = twice;
    for (int c = 0; c < 3; c++) {
        n[c] = twice > 0 ? n[c] / twice : 0;
        m[c] = o[c] + m[c] / (sp_real)face->corners;
    }
}

/* Farthest corner of a face from a plane. */
static sp_real sp__touch_off(const sp__touch *t, int32_t f, const sp_real n[3], const sp_real o[3])
{
    const sp_face *face = &t->scene->face[t->face0 + f];
    sp_real most = 0;
    for (int32_t k = 0; k < face->corners; k++) {
        sp_real d[3];
        sp__sub3(t->scene->vertex[t->scene->corner[face->corner + k]], o, d);
        most = sp__max(most, sp__abs(sp__dot3(d, n)));
    }
    return most;
}

/* Give each face with area its patch: the first whose plane all its corners keep to, or a new one. */
static void sp__touch_group(sp__touch *t, sp__body *body, int32_t faces)
{
    const sp_real flat = sp__max(body->noise, (sp_real)1e-6 * t->scene->block[t->block].diameter / 8);
    for (int32_t f = 0; f < faces; f++) {
        sp__touch_plane(t, f);
        body->warp = sp__max(body->warp, sp__touch_off(t, f, t->all.normal[f], t->all.middle[f]));
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
                && sp__touch_off(t, f, t->all.patch[p].n, t->all.patch[p].o) <= flat) break;
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
    const sp_face *face = &t->scene->face[t->face0 + f];
    const int32_t *corner = t->scene->corner + face->corner;
    for (int32_t k = 0; k < face->corners; k++) {
        t->all.edge[t->edges][0] = t->all.same[corner[k]];
        t->all.edge[t->edges][1] = t->all.same[corner[k + 1 < face->corners ? k + 1 : 0]];
        t->edges++;
    }
}

static void sp__box_start(sp_real lo[3], sp_real hi[3], const sp_real p[3])
{
    for (int c = 0; c < 3; c++) lo[c] = hi[c] = p[c];
}

static void sp__box_add(sp_real lo[3], sp_real hi[3], const sp_real p[3])
{
    for (int c = 0; c < 3; c++) {
        lo[c] = p[c] < lo[c] ? p[c] : lo[c];
        hi[c] = hi[c] < p[c] ? p[c] : hi[c];
    }
}

/* Boundary of a patch from t->all.edge: of the edges between two vertices those that their opposites do not cancel. */
static void sp__touch_bound(sp__touch *t, sp__patch *p)
{
    int32_t *order = t->all.order;
    p->edge = t->bounds;
    for (int32_t k = 0; k < t->edges; k++) order[k] = k;
    sp__sort(order, t->edges, sp__edge_before, t);
    for (int32_t k = 0; k < t->edges; ) {
        const int32_t u = t->all.edge[order[k]][0], v = t->all.edge[order[k]][1];
        int32_t net = 0;
        for (; k < t->edges; k++) {
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
    for (int32_t k = 0; k < p->edges; k++) {
        const sp_real *x = t->scene->vertex[t->all.bound[p->edge + k][0]];
        if (k == 0) sp__box_start(p->lo, p->hi, x);
        sp__box_add(p->lo, p->hi, x);
    }
}

/* Nothing of a closed block beyond a face of it? */
static int sp__touch_convex(const sp__touch *t, const sp__body *body)
{
    const sp_block *k = &t->scene->block[t->block];
    const sp_real flat = sp__max(body->noise, (sp_real)1e-6 * k->diameter / 8) + 2 * body->warp;
    if (!(k->volume > 0)) return 0;
    for (int32_t p = body->patch; p < body->patch + body->patches; p++)
        for (int32_t e = body->edge; e < body->edge + body->edges; e++) {
            sp_real d[3];
            sp__sub3(t->scene->vertex[t->all.bound[e][0]], t->all.patch[p].o, d);
            if (sp__dot3(d, t->all.patch[p].n) > flat) return 0;
        }
    return 1;
}

/* Box and noise of a block from its patches. */
static void sp__touch_size(sp__touch *t, sp__body *body)
{
    const sp_real diameter = t->scene->block[t->block].diameter;
    sp_real far = 0;
    for (int32_t v = 0; v < t->scene->block[t->block].vertices; v++)
        for (int c = 0; c < 3; c++) far = sp__max(far, sp__abs(t->scene->vertex[t->vertex0 + v][c]));
    body->noise = 16 * SP_EPSILON * (far + diameter);
    body->reach = sp__max(body->noise, t->set.absolute ? t->set.distance : t->set.distance * diameter);
}

/* Patches of one block. */
static void sp__touch_block(sp__touch *t, int32_t block)
{
    const sp_block *k = &t->scene->block[block];
    sp__body *body = &t->all.body[block];
    t->block = block;
    t->vertex0 = k->vertex;
    t->face0 = k->face;
    body->warp = 0;
    body->patch = t->patches;
    body->edge = t->bounds;
    sp__touch_size(t, body);
    sp__touch_weld(t);
    sp__touch_group(t, body, k->faces);
    body->patches = t->patches - body->patch;
    for (int32_t p = body->patch; p < t->patches; p++) {
        t->edges = 0;
        for (int32_t f = 0; f < k->faces; f++) if (t->all.mine[f] == p) sp__touch_edges(t, f);
        sp__touch_bound(t, &t->all.patch[p]);
    }
    body->edges = t->bounds - body->edge;
    for (int32_t e = body->edge; e < t->bounds; e++) {
        if (e == body->edge) sp__box_start(body->lo, body->hi, t->scene->vertex[t->all.bound[e][0]]);
        sp__box_add(body->lo, body->hi, t->scene->vertex[t->all.bound[e][0]]);
    }
    body->convex = sp__touch_convex(t, body);
}

/* --------------------------------------------------------------------------------------------------------------- tree */

/* Do two boxes come nearer than d? */
static int sp__boxes_near(const sp_real lo[3], const sp_real hi[3], const sp_real lo2[3], const sp_real hi2[3], sp_real d)
{
    for (int c = 0; c < 3; c++) if (lo[c] > hi2[c] + d || lo2[c] > hi[c] + d) return 0;
    return 1;
}

/* Every third bit from bit 0. */
static uint32_t sp__spread(uint32_t x)
{
    x = (x | x << 16) & UINT32_C(0x030000ff);
    x = (x | x << 8) & UINT32_C(0x0300f00f);
    x = (x | x << 4) & UINT32_C(0x030c30c3);
    return (x | x << 2) & UINT32_C(0x09249249);
}

static int sp__code_before(const void *what, int32_t i, int32_t j)
{
    const uint32_t *code = what;
    return code[i] != code[j] ? code[i] < code[j] : i < j;
}

static int sp__number_before(const void *what, int32_t i, int32_t j)
{
    (void)what;
    return i < j;
}

/* Leaves: the blocks with faces along a Morton curve through the middles of their boxes, 1024 steps a side. */
static void sp__tree_leaves(sp__touch *t)
{
    sp_real *lo = t->lo, *hi = t->hi;
    t->leaves = 0;
    for (int32_t i = 0; i < t->scene->count.blocks; i++) {
        const sp__body *k = &t->all.body[i];
        if (!k->edges) continue;
        if (!t->leaves) sp__box_start(lo, hi, k->lo);
        sp__box_add(lo, hi, k->lo);
        sp__box_add(lo, hi, k->hi);
        t->all.leaf[t->leaves++] = i;
    }
    for (int32_t l = 0; l < t->leaves; l++) {
        const sp__body *k = &t->all.body[t->all.leaf[l]];
        uint32_t code = 0;
        for (int c = 0; c < 3; c++) {
            const sp_real wide = hi[c] - lo[c], at = (k->lo[c] - lo[c]) / 2 + (k->hi[c] - lo[c]) / 2;
            const uint32_t step = wide > 0 ? (uint32_t)(int32_t)(1023 * (at / wide)) : 0;
            code |= sp__spread(step < 1023 ? step : 1023) << c;
        }
        t->all.code[t->all.leaf[l]] = code;
    }
    sp__sort(t->all.leaf, t->leaves, sp__code_before, t->all.code);
}

/* Boxes bottom-up; an empty one has low above high. */
static void sp__tree_build(sp__touch *t)
{
    sp__tree_leaves(t);
    for (int32_t k = 2 * t->all.width - 1; k > 0; k--) {
        sp_real *box = t->all.box[k];
        box[0] = (sp_real)1;
        box[3] = (sp_real)0;
        if (k >= t->all.width) {
            if (k - t->all.width >= t->leaves) continue;
            const sp__body *b = &t->all.body[t->all.leaf[k - t->all.width]];
            for (int c = 0; c < 3; c++) { box[c] = b->lo[c] - b->reach; box[3 + c] = b->hi[c] + b->reach; }
            continue;
        }
        const sp_real *left = t->all.box[2 * k], *right = t->all.box[2 * k + 1];
        if (left[0] > left[3]) continue;
        for (int c = 0; c < 6; c++) box[c] = left[c];
        if (right[0] > right[3]) continue;
        sp__box_add(box, box + 3, right);
        sp__box_add(box, box + 3, right + 3);
    }
}

/* Blocks above a whose boxes come near a's, in order. Returns how many. */
static int32_t sp__tree_ask(sp__touch *t, int32_t a)
{
    const sp__body *body = &t->all.body[a];
    int32_t hits = 0, k = 1;
    if (!body->edges) return 0;
    while (k > 0) {
        const sp_real *box = t->all.box[k];
        if (!(box[0] > box[3]) && sp__boxes_near(body->lo, body->hi, box, box + 3, body->reach)) {
            if (k < t->all.width) { k *= 2; continue; }
            if (t->all.leaf[k - t->all.width] > a) t->all.hit[hits++] = t->all.leaf[k - t->all.width];
        }
        while (k & 1) k >>= 1;                          /* up from right children, past the top to 0 */
        if (k) k++;
    }
    sp__sort(t->all.hit, hits, sp__number_before, NULL);
    return hits;
}

/* --------------------------------------------------------------------------------------------------------------- pair */

/* Coordinates of x in the plane of patch p, e1 and e2 from o, in units. */
static void sp__pair_flat(const sp__touch *t, const sp__patch *p, const sp_real x[3], sp_real xy[2])
{
    sp_real d[3];
    sp__sub3(x, p->o, d);
    xy[0] = sp__dot3(t->e1, d) / t->unit;
    xy[1] = sp__dot3(t->e2, d) / t->unit;
}

/* Give the boundary of a patch to the clipper: A's as it is, B's in A's plane, turned round. */
static void sp__pair_region(sp__touch *t, const sp__patch *plane, const sp__patch *p, int32_t side)
{
    for (int32_t e = p->edge; e < p->edge + p->edges; e++) {
        const int32_t u = t->all.bound[e][side], v = t->all.bound[e][1 - side];
        sp_real from[2], to[2];
        sp__pair_flat(t, plane, t->scene->vertex[u], from);
        sp__pair_flat(t, plane, t->scene->vertex[v], to);
        sp__clip_add(&t->clip, side, from, to, u, v);
    }
}

/* A corner of the result in space: on A's plane; a vertex that is there already stays what it is, to the bit. */
static void sp__pair_corner(const sp__touch *t, const sp__patch *p, int32_t corner, sp_real x[3])
{
    const sp_real *xy = t->clip.corner[corner];
    const int32_t name = t->clip.name[corner];
    int exact = name >= 0;
    for (int c = 0; c < 3; c++) {
        x[c] = p->o[c] + t->unit * (xy[0] * t->e1[c] + xy[1] * t->e2[c]);
        if (exact && sp__abs(t->scene->vertex[name][c] - x[c]) > t->noise / 4) exact = 0;
    }
    for (int c = 0; c < 3 && exact; c++) x[c] = t->scene->vertex[name][c];
}

static void sp__reverse(sp_real (*p)[3], int32_t from, int32_t to)
{
    for (to--; from < to; from++, to--)
        for (int c = 0; c < 3; c++) {
            const sp_real x = p[from][c];
            p[from][c] = p[to][c];
            p[to][c] = x;
        }
}

/* Start the polygon at its first corner in order of x, y, z. */
static void sp__pair_canonical(sp__touch *t, int32_t start, int32_t size)
{
    sp_real (*p)[3] = t->pair.point + start;
    int32_t first = 0;
    for (int32_t k = 1; k < size; k++) if (sp__place_order(p[k], p[first], t->snap) < 0) first = k;
    sp__reverse(p, 0, first);
    sp__reverse(p, first, size);
    sp__reverse(p, 0, size);
}

/* Keep loop l of the clipper if B's plane is near in its middle: gap g along n_A, n_B . (o_B - m - g n_A) = 0. */
static void sp__pair_keep(sp__touch *t, const sp__patch *p, const sp__patch *q, int32_t l)
{
    const int32_t from = t->clip.loop[l], size = t->clip.loop[l + 1] - from;
    sp_real m[3] = { 0, 0, 0 };
    if (size > t->pair.room - t->points || t->founds >= t->pair.room) { t->status = SP_E_MEMORY; return; }
    for (int32_t k = 0; k < size; k++) {
        sp_real d[3];
        sp__pair_corner(t, p, from + k, t->pair.point[t->points + k]);
        sp__sub3(q->o, t->pair.point[t->points + k], d);
        for (int c = 0; c < 3; c++) m[c] += d[c] / (sp_real)size;
    }
    if (sp__abs(sp__dot3(q->n, m) / sp__dot3(q->n, p->n)) > t->near) return;
    sp__pair_canonical(t, t->points, size);
    t->pair.found[t->founds].start = t->points;
    t->pair.found[t->founds].size = size;
    t->points += size;
    t->founds++;
}

/* Can patches p and q touch: opposed to within the angle, boxes and planes near? Between planes at angle s the distance
 * changes by s times the way. */
static int sp__pair_opposed(const sp__touch *t, const sp__patch *p, const sp__patch *q)
{
    sp_real x[3], d[3];
    if (sp__dot3(p->n, q->n) >= 0 || !sp__boxes_near(p->lo, p->hi, q->lo, q->hi, t->near)) return 0;
    sp__cross3(p->n, q->n, x);
    const sp_real s = sp__norm3(x);
    if (s > t->set.angle) return 0;
    sp__sub3(q->o, p->o, d);
    return sp__abs(sp__dot3(d, p->n)) <= 2 * t->near + 2 * s * sp__norm3(d);
}

/* Polygons of two patches. */
static void sp__pair_clip(sp__touch *t, const sp__patch *p, const sp__patch *q)
{
    sp__across3(p->n, t->e1);
    sp__cross3(p->n, t->e1, t->e2);
    sp__clip_clear(&t->clip);
    sp__pair_region(t, p, p, 0);
    sp__pair_region(t, p, q, 1);
    if (!sp__clip_run(&t->clip, t->snap / t->unit, t->near / t->unit)) { t->status = SP_E_MEMORY; return; }
    for (int32_t l = 0; l < t->clip.loops && !t->status; l++) sp__pair_keep(t, p, q, l);
}

/* Patches of one block near the box of another. Returns how many. */
static int32_t sp__pair_near(const sp__touch *t, const sp__body *own, const sp__body *other, int32_t *list)
{
    int32_t n = 0;
    for (int32_t k = own->patch; k < own->patch + own->patches; k++) {
        const sp__patch *p = &t->all.patch[k];
        if (p->edges && sp__boxes_near(p->lo, p->hi, other->lo, other->hi, t->near)) list[n++] = k;
    }
    return n;
}

static int sp__found_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const sp__found *f = &t->pair.found[i], *g = &t->pair.found[j];
    for (int32_t k = 0; k < f->size && k < g->size; k++) {
        const int o = sp__place_order(t->pair.point[f->start + k], t->pair.point[g->start + k], t->snap);
        if (o) return o < 0;
    }
    return f->size != g->size ? f->size < g->size : i < j;
}

/* Append what was found to the scene, in the order of corners; where there is no room, count. */
static void sp__pair_append(sp__touch *t)
{
    for (int32_t k = 0; k < t->founds; k++) t->pair.rank[k] = k;
    sp__sort(t->pair.rank, t->founds, sp__found_before, t);
    for (int32_t k = 0; k < t->founds; k++) {
        const sp__found *f = &t->pair.found[t->pair.rank[k]];
        const sp_status s = sp_scene_interface(t->scene, t->a, t->b, f->size, t->pair.point[f->start], &t->set.joint, NULL);
        if (s != SP_OK && s != SP_E_CAPACITY) continue;             /* too small for its coordinates */
        t->full |= s == SP_E_CAPACITY;
        t->report.interfaces++;
        t->report.points += f->size;
    }
}

/* Tolerances of the pair. */
static void sp__pair_start(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[b];
    const sp_real d = t->scene->block[t->a].diameter, e = t->scene->block[b].diameter, small = d < e ? d : e;
    t->b = b;
    t->points = t->founds = 0;
    t->noise = sp__max(p->noise, q->noise);
    t->near = sp__max(t->noise, p->reach < q->reach ? p->reach : q->reach);
    t->snap = (sp_real)1e-6 * small < t->near ? (sp_real)1e-6 * small : t->near;
    t->snap = sp__max(t->noise, t->snap / 8);
    t->unit = small > 0 ? sp__power_of_two(small) : (sp_real)1;
}

/* ------------------------------------------------------------------------------------------------------------ overlap */

/* By how much the blocks' shadows on an axis overlap, of any length; below 0 they are apart. */
static sp_real sp__shadow(const sp__touch *t, const sp_real axis[3])
{
    sp_real lo[2] = { 0, 0 }, hi[2] = { 0, 0 };
    const sp_real *o = t->all.body[t->a].lo;
    for (int side = 0; side < 2; side++) {
        const sp__body *k = &t->all.body[side ? t->b : t->a];
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
        const sp__body *k = &t->all.body[side ? t->b : t->a];
        for (int32_t p = k->patch; p < k->patch + k->patches; p++) {
            const sp_real x = sp__shadow(t, t->all.patch[p].n);
            if (!some || x < least) least = x;
            some = 1;
            if (least <= flat) return least;
        }
    }
    return least;
}

/* The same along the cross products of their edges: with the normals that is all a convex pair can be kept apart by. */
static sp_real sp__shadow_edges(const sp__touch *t, sp_real least, sp_real flat)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[t->b];
    for (int32_t i = p->edge; i < p->edge + p->edges; i++)
        for (int32_t j = q->edge; j < q->edge + q->edges; j++) {
            const int32_t *u = t->all.bound[i], *v = t->all.bound[j];
            sp_real d[3], e[3];
            if (u[0] > u[1] || v[0] > v[1]) continue;               /* each edge once */
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
static sp_real sp__triangle_far2(const sp_real x[3], const sp_real *const v[3], const sp_real n[3])
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
            const sp_real far2 = sp__triangle_far2(x, v, n);
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
        if (t->all.bound[e][0] > t->all.bound[e][1]) continue;
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
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[t->b];
    const int64_t work = (int64_t)p->edges * q->edges * (p->edges + q->edges) / 4;
    for (int c = 0; c < 3; c++) if (p->hi[c] - q->lo[c] <= flat || q->hi[c] - p->lo[c] <= flat) return 0;
    const sp_real least = sp__shadow_faces(t, flat);
    if (least <= flat) return 0;
    if (p->convex && q->convex && work <= 10000000) return sp__shadow_edges(t, least, flat);
    sp_real most = sp__max(sp__depth_edges(t, t->a, t->b, flat), sp__depth_edges(t, t->b, t->a, flat));
    for (int side = 0; side < 2; side++) {
        const sp_real *x = t->scene->block[side ? t->b : t->a].centroid;
        const sp_real d = sp__depth(t, t->a, x, flat), e = sp__depth(t, t->b, x, flat);
        most = sp__max(most, d < e ? d : e);
    }
    return most < least ? most : least;
}

static void sp__pair_overlap(sp__touch *t)
{
    const sp_real flat = t->near + 2 * (t->all.body[t->a].warp + t->all.body[t->b].warp);
    const sp_real depth = sp__pair_depth(t, flat);
    if (!(depth > flat)) return;
    if (t->report.overlap && t->report.overlaps < t->report.overlap_cap) {
        const sp_overlap o = { t->a, t->b, depth };
        t->report.overlap[t->report.overlaps] = o;
    }
    t->report.overlaps++;
}

/* --------------------------------------------------------------------------------------------------------------- find */

/* All of one pair. */
static void sp__touch_pair(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[b];
    if (t->scene->block[t->a].fixed == SP_FIXED && t->scene->block[b].fixed == SP_FIXED) return;
    sp__pair_start(t, b);
    const int32_t n = sp__pair_near(t, p, q, t->pair.near_a), m = sp__pair_near(t, q, p, t->pair.near_b);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < m && !t->status; j++) {
            const sp__patch *u = &t->all.patch[t->pair.near_a[i]], *v = &t->all.patch[t->pair.near_b[j]];
            if (sp__pair_opposed(t, u, v)) sp__pair_clip(t, u, v);
        }
    if (t->status) return;
    sp__pair_append(t);
    sp__pair_overlap(t);
}

/* Patches of all blocks, then what the largest pair needs. */
static void sp__touch_blocks(sp__touch *t, sp_arena *scratch)
{
    sp__most *most = &t->most;
    for (int32_t i = 0; i < t->scene->count.blocks; i++) {
        int32_t side = 0;
        sp__touch_block(t, i);
        for (int32_t p = t->all.body[i].patch; p < t->patches; p++)
            if (t->all.patch[p].edges > side) side = t->all.patch[p].edges;
        sp__two_add(&most->side, side);
        sp__two_add(&most->total, t->all.body[i].edges);
        sp__two_add(&most->patches, t->all.body[i].patches);
    }
    sp__clip_carve(&t->clip, most->side.first, most->side.second, sp__crossings(&most->side), scratch);
    sp__pair_carve(&t->pair, most, scratch);
    if (sp__failed(scratch)) t->status = SP_E_MEMORY;
}

static sp_status sp__contact_settings_check(const sp_contact_settings *s)
{
    if (!sp__finite(s->distance) || !sp__finite(s->angle)) return SP_E_RANGE;
    if (s->distance < 0 || s->angle < 0 || s->angle > (sp_real)0.5) return SP_E_RANGE;
    return sp__joint_check(&s->joint);
}

SP_API sp_status sp_contacts_find(sp_scene *scene, const sp_contact_settings *settings, sp_arena scratch,
                                  sp_contact_report *report)
{
    if (!scene || !scratch.base || !report || report->overlap_cap < 0) return SP_E_ARGUMENT;
    sp__touch *t = sp__take(&scratch, 1, sizeof *t);
    if (!t) return SP_E_MEMORY;
    memset(t, 0, sizeof *t);
    if (settings) t->set = *settings;
    else sp__contact_default(&t->set);
    t->status = sp__contact_settings_check(&t->set);
    if (t->status) return t->status;
    t->scene = scene;
    t->before = scene->count;
    t->report.overlap = report->overlap;
    t->report.overlap_cap = report->overlap_cap;
    sp__all_carve(&t->all, scene, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__touch_blocks(t, &scratch);
    if (!t->status) sp__tree_build(t);
    for (t->a = 0; t->a < scene->count.blocks && !t->status; t->a++) {
        const int32_t hits = sp__tree_ask(t, t->a);
        for (int32_t h = 0; h < hits && !t->status; h++) sp__touch_pair(t, t->all.hit[h]);
    }
    if (t->status || t->full) scene->count = t->before;
    if (t->status) return t->status;
    *report = t->report;
    return t->full ? SP_E_CAPACITY : SP_OK;
}
