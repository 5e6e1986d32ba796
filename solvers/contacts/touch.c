/* touch: distances and settings; do two faces touch? */
#ifndef SP__CONTACTS_TOUCH_C
#define SP__CONTACTS_TOUCH_C

#include "../geometry/hull.c"
#include "../geometry/clip.c"
#include "../geometry/convex.c"

/* Which faces of which blocks touch, and in what polygons.
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
 *
 * SP_SMALL takes every face for a patch, and for what the patches of one plane share with a block its convex hull: that carries
 * the same, for a force at a point of it is a sum of forces at its corners. How narrow it is, is asked of the hull, for faces may
 * be narrow that together are not; a narrow piece of two faces that are not is an edge contact. Nothing is sorted, every pair of
 * blocks is asked.
 */

typedef struct sp__patch {
    sp_real n[3], o[3];         /* plane: outward unit normal and a point of the largest face */
    sp_real lo[3], hi[3];       /* box */
    int32_t edge, edges;        /* its part of bound */
#ifdef SP_SMALL
    int32_t plane;              /* the first patch of its block in its plane */
#endif
} sp__patch;

typedef struct sp__body {       /* what the search knows of a block */
    sp_real lo[3], hi[3];       /* box, of its faces only */
    sp_real noise, reach;       /* see above; its own settings' distance */
    sp_real warp;               /* farthest corner of a face from the face's plane */
    int32_t patch, patches, edge, edges;
    int32_t convex;             /* closed and nothing beyond any of its faces */
} sp__body;

#ifndef SP_SMALL
typedef struct sp__found { int32_t start, size; } sp__found;    /* a polygon of the present pair */

/* The largest of a number over the blocks, and the largest of the others. */
typedef struct sp__two { int32_t first, second; } sp__two;

/* Edges of one patch, of a block; patches of a block. */
typedef struct sp__most { sp__two side, total, patches; } sp__most;
#endif

/* Memory of the search. */
typedef struct sp__all {
    sp__body *body;
    sp__patch *patch;
    int32_t (*bound)[2];
#ifndef SP_SMALL
    int32_t *same;                              /* vertex -> the vertex that stands for all at its place */
    int32_t *order, *mine;                      /* of one block: vertices, faces or edges in order; face -> patch */
    int32_t (*edge)[2];                         /* of one block */
    sp_real (*normal)[3], (*middle)[3], *area;  /* of the faces of one block */
    int32_t *hit;                               /* blocks that may touch the present one */
    int32_t width;                              /* of the tree: power of two, not below the number of blocks */
    sp_real (*box)[6];                          /* of the tree's nodes, 1 the top, children 2k and 2k + 1 */
    int32_t *leaf;                              /* block of each leaf */
    uint32_t *code;                             /* Morton code of each block */
#endif
} sp__all;

/* Memory of one pair of blocks. */
typedef struct sp__pair {
    sp_real (*point)[3];                        /* polygons found; of SP_SMALL one */
#ifdef SP_SMALL
    sp__hull hull;                              /* that one, in its plane */
    int32_t corners, parts;                     /* of it; of the same plane, appended before it for want of room */
#else
    int32_t *near_a, *near_b;                   /* patches near the other block's box */
    sp__found *found;
    int32_t *rank;                              /* their order */
    int32_t room;                               /* of them, and of points */
#endif
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
#ifndef SP_SMALL
    sp__most most;
    int32_t leaves, edges;                      /* of the tree; of the faces of a patch */
    sp_real lo[3], hi[3];                       /* box of everything */
    int32_t points, founds;                     /* what was found of the present pair */
#endif
    int32_t patches, bounds;
    int32_t block, vertex0, face0;              /* of the block whose patches are being made */
    int32_t a, b;                               /* present pair */
    sp_real near, noise, snap, unit;            /* of that pair; unit: length of 1 in the plane of the clipping [m] */
    sp_real e1[3], e2[3];                       /* axes of that plane */
} sp__touch;

SP_API sp_contact_settings sp_contact_settings_default(void)
{
    sp_contact_settings s;
    memset(&s, 0, sizeof s);
    s.distance = (sp_real)1e-6;
    s.angle = (sp_real)1e-3;
    s.joint.mu = (sp_real)0.84;
    return s;
}

/* ------------------------------------------------------------------------------------------------------------- memory */

#ifdef SP_SMALL
/* Everything: of a pair there are never more than two faces at once, and the hull of what some of them share. */
static void sp__touch_carve(sp__all *l, sp__clip *clip, sp__pair *pair, const sp_scene *scene, sp_arena *a)
{
    const sp_capacity *n = &scene->count;
    int32_t side = 16;                          /* at least: for the hull of many small faces */
    for (int32_t f = 0; f < n->faces; f++) if (scene->face[f].corners > side) side = scene->face[f].corners;
    l->body = sp__take(a, (size_t)n->blocks, sizeof *l->body);
    l->patch = sp__take(a, (size_t)n->faces, sizeof *l->patch);
    l->bound = sp__take(a, (size_t)n->corners, sizeof *l->bound);
    sp__clip_carve(clip, side, side, a);
    pair->point = sp__take(a, (size_t)clip->cap, sizeof *pair->point);
    sp__hull_carve(&pair->hull, clip->cap, a);
}

SP_API size_t sp_contacts_memory(const sp_scene *scene)
{
    sp_arena dry = sp__arena_dry();
    struct { sp__all all; sp__clip clip; sp__pair pair; } none;
    if (!scene) return 0;
    (void)sp__take(&dry, 1, sizeof(sp__touch));
    sp__touch_carve(&none.all, &none.clip, &none.pair, scene, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}
#else
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
    l->hit = sp__take(a, blocks, sizeof *l->hit);
    for (l->width = 1; l->width < n->blocks && l->width < 1 << 29; l->width *= 2) { }
    l->box = sp__take(a, 2 * (size_t)l->width, sizeof *l->box);
    l->leaf = sp__take(a, blocks, sizeof *l->leaf);
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
#endif

/* ------------------------------------------------------------------------------------------------------------ patches */

#endif /* SP__CONTACTS_TOUCH_C */
