/* touch: data, tolerances and settings of the search for contacts. */
#ifndef SP__CONTACTS_TOUCH_C
#define SP__CONTACTS_TOUCH_C

#include "../geometry/hull.c"
#include "../geometry/clip.c"
#include "../geometry/convex.c"

/* The search for contacts finds which faces of which blocks touch, and in what polygons.
 *
 *   patch      all faces of one block in one plane and with one direction; bounded by the edges that do not cancel
 *   bound      boundary edges of the patches, vertex numbers of the scene, patch on the left seen from outside
 *   noise      16 u (|coordinate| + diameter): no tolerance is below it, so float and far coordinates work          [m]
 *   near       settings' distance of a pair of blocks, at least the noise                                           [m]
 *
 *   distance   of two patches: along A's normal, in the middle of what they share; the angle bounds the rest
 *   limit      of a distance beyond 1e-6 diameters: a quarter of each closed block's width along A's normal, so that none
 *              reaches through a block; not of SP_SMALL
 *   in-plane   corners nearer than min(gap, 1e-6 diameter)/8 are one; what is narrower than `gap` is an edge contact, and
 *              left out; beyond 1e-6 diameters only if its faces are not in one plane to 4e-9 diameters: what is found at a
 *              distance of 1e-6 between exact faces is found at every other one; not of SP_SMALL
 *
 * Boxes in a balanced tree by Morton order find the pairs, n log n whatever the sizes are mixed like; a slab under everything
 * costs its own pairs and no more. Where most boxes overlap they are made anew along a face (frame.c). The faces of a block
 * of many stand in such a tree, too, its patches in a grid of normals.
 *
 * SP_SMALL takes every face for a patch, and for what the patches of one plane share with a block its convex hull: that carries
 * the same, for a force at a point of it is a sum of forces at its corners. How narrow it is, is asked of the hull, for faces
 * may be narrow that together are not; a narrow piece of two faces that are not is an edge contact. Nothing is sorted, every
 * pair of blocks is asked.
 */

typedef struct sp__patch {
    sp_real n[3], o[3];         /* plane: outward unit normal and a point of the largest face */
    sp_real lo[3], hi[3];       /* box */
    int32_t edge, edges;        /* its part of bound */
#if SP__WITH_SMALL
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

#if !SP__WITH_SMALL
typedef struct sp__polygon { int32_t start, size; } sp__polygon;    /* a polygon of the present pair */

/* The largest of a number over the blocks, and the largest of the others. */
typedef struct sp__top_two { int32_t first, second; } sp__top_two;

/* The tree of boxes. */
typedef struct sp__tree {
    int32_t width, leaves;                      /* power of two, not below the number of blocks; blocks with faces */
    sp_real (*box)[6];                          /* of the nodes, 1 the top, children 2k and 2k + 1 */
    int32_t *leaf;                              /* block of each leaf */
    uint32_t *code;                             /* Morton code of each block */
    sp_real lo[3], hi[3];                       /* box of everything */
    sp_real axis[3][3];                         /* of the boxes, if they are turned */
    int32_t turned, tried;                      /* boxes stand along these axes; other axes were asked for */
    int64_t asked;                              /* pairs of blocks so far */
} sp__tree;

/* Edges of one patch, of a block; patches of a block. */
typedef struct sp__top_sizes { sp__top_two side, total, patches; } sp__top_sizes;
#endif

/* Memory of the search. */
typedef struct sp__contact_arrays {
    sp__body *body;
    sp__patch *patch;
    int32_t (*bound)[2];
#if !SP__WITH_SMALL
    int32_t *same;                              /* vertex -> the vertex that stands for all at its place */
    int32_t *order, *mine;                      /* of one block: vertices, faces or edges in order; face -> patch */
    int32_t (*edge)[2];                         /* of one block */
    sp_real (*normal)[3], (*middle)[3], *area;  /* of the faces of one block */
    int32_t *hit;                               /* blocks that may touch the present one */
    sp__tree tree;
#endif
} sp__contact_arrays;

/* Memory of one pair of blocks. */
typedef struct sp__pair_buffer {
    sp_real (*point)[3];                        /* polygons found; of SP_SMALL one */
#if SP__WITH_SMALL
    sp__hull hull;                              /* that one, in its plane */
    int32_t corners, parts;                     /* of it; of the same plane, appended before it for want of room */
#else
    int32_t *near_a, *near_b;                   /* patches near the other block's box */
    sp__polygon *found;
    int32_t *rank;                              /* their order */
    int32_t room;                               /* of them, and of points */
    int32_t points, founds;                     /* so many now */
#endif
} sp__pair_buffer;

/* The block whose patches are being made. */
typedef struct sp__own_block {
    int32_t block, vertex0, face0;
#if !SP__WITH_SMALL
    int32_t edges;                              /* of the faces of a patch */
#endif
} sp__own_block;

/* The present pair, and the plane it is clipped in. */
typedef struct sp__present_pair {
    int32_t a, b;
    sp_real gap, noise, snap, unit;             /* unit: length of 1 in the plane [m] */
#if !SP__WITH_SMALL
    sp_real asked;                              /* settings' distance of the blocks; gap is what counts for two patches */
#endif
    sp_real e1[3], e2[3];                       /* its axes */
} sp__present_pair;

typedef struct sp__touch {
    sp_scene *scene;
    sp_contact_settings set;
    sp_contact_report report;
    sp_capacity before;                         /* the scene's count at the start */
    sp_status status;
    int32_t full;                               /* the scene had no room for something */
    sp__contact_arrays all;
    sp__clip clip;
    sp__pair_buffer pair;
#if !SP__WITH_SMALL
    sp__top_sizes most;
    struct { int32_t block, width; } inside;    /* whose faces stand in a tree: 1 more than its number; its leaves */
#endif
    int32_t patches, bounds;                    /* made so far */
    sp__own_block own;
    sp__present_pair now;
} sp__touch;

SP_API sp_contact_settings sp_contact_settings_default(void)
{
    sp_contact_settings s;
    memset(&s, 0, sizeof s);
    s.distance = (sp_real)1e-6;
    s.angle = (sp_real)1e-3;
    s.strength.mu = (sp_real)0.84;
    return s;
}

#endif /* SP__CONTACTS_TOUCH_C */
