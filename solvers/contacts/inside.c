/* inside: how deep a point lies inside a block, by its distance from the nearest face. The faces of large blocks stand in a
 * balanced tree of boxes along a Morton curve, in arrays that served the patches: log n a point, with the bits of all faces. */
#ifndef SP__CONTACTS_INSIDE_C
#define SP__CONTACTS_INSIDE_C

#include "face.c"
#include "morton.c"

#if !SP__WITH_SMALL

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

/* A point asked of the faces of a block. */
typedef struct sp__asked { sp_real x[3], least2; int wind; } sp__asked;

/* Nearest face so far, and how often those above wind round the point. */
static void sp__ask_face(const sp_scene *s, int32_t f, sp__asked *p)
{
    for (int32_t i = 1; i + 1 < s->face[f].corners; i++) {
        const int32_t *corner = s->corner + s->face[f].corner;
        const sp_real *const v[3] = { s->vertex[corner[0]], s->vertex[corner[i]], s->vertex[corner[i + 1]] };
        sp_real d[3], n[3];
        sp__sub3(v[1], v[0], d);
        sp__sub3(v[2], v[0], n);
        sp__cross3(d, n, n);
        if (!(sp__dot3(n, n) > 0)) continue;
        const sp_real far2 = sp__triangle_distance2(p->x, v, n);
        if (far2 < p->least2) p->least2 = far2;
        const int w = sp__ray_edge(p->x, v[0], v[1]) + sp__ray_edge(p->x, v[1], v[2]) + sp__ray_edge(p->x, v[2], v[0]);
        sp__sub3(v[0], p->x, d);
        if (w && (n[2] > 0 ? sp__dot3(d, n) > 0 : sp__dot3(d, n) < 0)) p->wind += w;
    }
}

#define SP__LEAF_FACES 8                /* of the tree; its boxes, less than half as many as faces, fit into `normal` */

/* Is the tree worth while? */
static int sp__inside_large(const sp__touch *t, int32_t block)
{
    return t->scene->block[block].faces > 8 * SP__LEAF_FACES;
}

/* The box of a face. */
static void sp__face_box(const sp_scene *s, int32_t f, sp_real lo[3], sp_real hi[3])
{
    const int32_t *corner = s->corner + s->face[f].corner;
    sp__box_start(lo, hi, s->vertex[corner[0]]);
    for (int32_t i = 1; i < s->face[f].corners; i++) sp__box_add(lo, hi, s->vertex[corner[i]]);
}

/* Faces of a block in the order of a Morton curve, and the boxes of eight each bottom-up; an empty one has low above high. */
SP__NOINLINE static void sp__inside_build(sp__touch *t, int32_t block)
{
    const sp_scene *s = t->scene;
    const sp_block *k = &s->block[block];
    const sp__body *body = &t->all.body[block];
    uint32_t *code = (uint32_t *)t->all.mine;
    sp_real (*box)[6] = (sp_real (*)[6])t->all.normal;
    sp_real lo[3], hi[3];
    t->inside.block = block + 1;
    t->inside.width = 1;
    while (t->inside.width * SP__LEAF_FACES < k->faces) t->inside.width *= 2;
    for (int32_t f = 0; f < k->faces; f++) {
        sp__face_box(s, k->face + f, lo, hi);
        code[f] = sp__morton(lo, hi, body->lo, body->hi);
        t->all.order[f] = f;
    }
    sp__sort(t->all.order, k->faces, sp__code_before, code);
    for (int32_t n = 2 * t->inside.width - 1; n > 0; n--) {
        const int32_t from = (n - t->inside.width) * SP__LEAF_FACES;
        box[n][0] = (sp_real)1;
        box[n][3] = 0;
        if (n < t->inside.width) {
            memcpy(box[n], box[2 * n], sizeof *box);
            if (box[2 * n + 1][0] > box[2 * n + 1][3]) continue;
            sp__box_add(box[n], box[n] + 3, box[2 * n + 1]);
            sp__box_add(box[n], box[n] + 3, box[2 * n + 1] + 3);
            continue;
        }
        for (int32_t i = from; i < k->faces && i < from + SP__LEAF_FACES; i++) {
            sp__face_box(s, k->face + t->all.order[i], lo, hi);
            if (i == from) sp__box_start(box[n], box[n] + 3, lo);
            sp__box_add(box[n], box[n] + 3, lo);
            sp__box_add(box[n], box[n] + 3, hi);
        }
    }
}

/* The next node of the tree that is not below n; 0: none. */
static int32_t sp__inside_next(int32_t n)
{
    while (n & 1) n >>= 1;                              /* up from right children, past the top to 0 */
    return n ? n + 1 : 0;
}

static int sp__face_before_plane(const sp__touch *t, int32_t f, const sp__patch *p, sp_real flat)
{
    const sp_face *face = &t->scene->face[f];
    for (int32_t k = 0; k < face->corners; k++) {
        sp_real d[3];
        sp__sub3(t->scene->vertex[t->scene->corner[face->corner + k]], p->o, d);
        if (sp__dot3(d, p->n) > flat) return 1;
    }
    return 0;
}

/* Along a normal, the farthest corner of a box from o. */
static sp_real sp__box_reach(const sp_real box[6], const sp_real o[3], const sp_real n[3])
{
    sp_real sum = 0;
    for (int c = 0; c < 3; c++) sum += n[c] * ((n[c] > 0 ? box[3 + c] : box[c]) - o[c]);
    return sum;
}

/* Is a corner of the block in the tree more than `flat` in front of a plane? */
SP__NOINLINE static int sp__inside_before(const sp__touch *t, const sp_block *k, const sp__patch *p, sp_real flat)
{
    const sp_real (*box)[6] = (const sp_real (*)[6])t->all.normal;
    const int32_t width = t->inside.width;
    for (int32_t n = 1; n > 0; ) {
        if (!(box[n][0] > box[n][3]) && sp__box_reach(box[n], p->o, p->n) > flat / 2) {
            if (n < width) { n *= 2; continue; }
            const int32_t from = (n - width) * SP__LEAF_FACES;
            for (int32_t i = from; i < k->faces && i < from + SP__LEAF_FACES; i++)
                if (sp__face_before_plane(t, k->face + t->all.order[i], p, flat)) return 1;
        }
        n = sp__inside_next(n);
    }
    return 0;
}

/* Squared distance of x from a box; an empty one is farther than any. */
static sp_real sp__box_distance2(const sp_real box[6], const sp_real x[3])
{
    sp_real sum = 0;
    if (box[0] > box[3]) return SP__HUGE;
    for (int c = 0; c < 3; c++) {
        const sp_real d = x[c] < box[c] ? box[c] - x[c] : x[c] > box[3 + c] ? x[c] - box[3 + c] : 0;
        sum += d * d;
    }
    return sum;
}

/* May the upward ray from x meet the box? */
static int sp__box_above(const sp_real box[6], const sp_real x[3], sp_real noise)
{
    return box[0] - noise <= x[0] && x[0] <= box[3] + noise && box[1] - noise <= x[1] && x[1] <= box[4] + noise
        && x[2] <= box[5] + noise;
}

static void sp__ask_leaf(const sp__touch *t, const sp_block *k, int32_t leaf, sp__asked *p)
{
    const int32_t from = leaf * SP__LEAF_FACES;
    for (int32_t i = from; i < k->faces && i < from + SP__LEAF_FACES; i++) sp__ask_face(t->scene, k->face + t->all.order[i], p);
}

/* Down to the box that is nearest at every step, for a first distance; then all boxes that are as near, or above. */
SP__NOINLINE static void sp__ask_tree(const sp__touch *t, int32_t block, sp__asked *p)
{
    const sp_block *const k = &t->scene->block[block];
    const sp_real (*box)[6] = (const sp_real (*)[6])t->all.normal;
    const sp_real noise = t->all.body[block].noise;
    const int32_t width = t->inside.width;
    int32_t n = 1;
    while (n < width) n = 2 * n + (sp__box_distance2(box[2 * n + 1], p->x) < sp__box_distance2(box[2 * n], p->x));
    sp__ask_leaf(t, k, n - width, p);
    p->wind = 0;
    for (n = 1; n > 0; ) {
        const int empty = box[n][0] > box[n][3];
        if (!empty && (sp__box_above(box[n], p->x, noise) || sp__box_distance2(box[n], p->x) * (sp_real)0.9999 <= p->least2)) {
            if (n < width) { n *= 2; continue; }
            sp__ask_leaf(t, k, n - width, p);
        }
        n = sp__inside_next(n);
    }
}

/* How deep x lies inside a closed block: 0 if outside, or not deeper than `flat`. Inside: the faces above wind round it. */
static sp_real sp__depth(const sp__touch *t, int32_t block, const sp_real x[3], sp_real flat)
{
    const sp_scene *s = t->scene;
    const sp_block *k = &s->block[block];
    const sp__body *body = &t->all.body[block];
    sp__asked p = { { x[0], x[1], x[2] }, k->diameter * k->diameter, 0 };
    if (!(k->volume > 0)) return 0;
    for (int c = 0; c < 3; c++) if (x[c] < body->lo[c] + flat || x[c] > body->hi[c] - flat) return 0;
    if (t->inside.block == block + 1) sp__ask_tree(t, block, &p);
    else for (int32_t f = k->face; f < k->face + k->faces && p.least2 > flat * flat; f++) sp__ask_face(s, f, &p);
    return p.wind > 0 && p.least2 > flat * flat ? SP_SQRT(p.least2) : 0;
}

#endif

#endif /* SP__CONTACTS_INSIDE_C */
