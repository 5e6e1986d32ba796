/* body: a block as the search for contacts sees it: bounding box, rounding noise, patches; whether it is convex.
 *
 *   noise = 16 u (max |coordinate| + diameter)       convex: every boundary vertex is behind every patch, to rounding
 */
#ifndef SP__CONTACTS_BODY_C
#define SP__CONTACTS_BODY_C

#include "inside.c"
#include "patch.c"
#include "small_patch.c"

#if SP__WITH_SMALL

/* Is the block closed and convex, no corner of it in front of any of its faces? */
static int sp__touch_convex(const sp__touch *t, const sp__body *body)
{
    const sp_block *k = &t->scene->block[t->own.block];
    const sp_real flat = sp__plane_tolerance(t, body) + 2 * body->warp;
    if (!(k->volume > 0)) return 0;
    for (int32_t p = body->patch; p < body->patch + body->patches; p++)
        for (int32_t e = body->edge; e < body->edge + body->edges; e++) {
            sp_real d[3];
            sp__sub3(t->scene->vertex[t->all.bound[e][0]], t->all.patch[p].o, d);
            if (sp__dot3(d, t->all.patch[p].n) > flat) return 0;
        }
    return 1;
}

#else

/* Is a corner of the block more than `flat` in front of a plane? */
static int sp__touch_before(const sp__touch *t, const sp__body *body, const sp__patch *p, sp_real flat)
{
    if (t->inside.block == t->own.block + 1) return sp__inside_before(t, &t->scene->block[t->own.block], p, flat);
    for (int32_t e = body->edge; e < body->edge + body->edges; e++) {
        sp_real d[3];
        sp__sub3(t->scene->vertex[t->all.bound[e][0]], p->o, d);
        if (sp__dot3(d, p->n) > flat) return 1;
    }
    return 0;
}

/* Is the block closed and convex, no corner of it in front of any of its faces? */
static int sp__touch_convex(sp__touch *t, const sp__body *body)
{
    const sp_real flat = sp__plane_tolerance(t, body) + 2 * body->warp;
    if (!(t->scene->block[t->own.block].volume > 0)) return 0;
    if (sp__inside_large(t, t->own.block)) sp__inside_build(t, t->own.block);
    for (int32_t p = body->patch; p < body->patch + body->patches; p++)
        if (sp__touch_before(t, body, &t->all.patch[p], flat)) return 0;
    return 1;
}

#endif

/* Box and noise of a block from its patches. */
static void sp__touch_size(sp__touch *t, sp__body *body)
{
    const sp_real diameter = t->scene->block[t->own.block].diameter;
    sp_real reach = 0;
    for (int32_t v = 0; v < t->scene->block[t->own.block].vertices; v++)
        for (int c = 0; c < 3; c++) reach = sp__max(reach, sp__abs(t->scene->vertex[t->own.vertex0 + v][c]));
    body->noise = 16 * SP_EPSILON * (reach + diameter);
    body->reach = sp__max(body->noise, t->set.absolute ? t->set.distance : t->set.distance * diameter);
}

/* Patches of one block. */
static void sp__touch_block(sp__touch *t, int32_t block)
{
    const sp_block *k = &t->scene->block[block];
    sp__body *body = &t->all.body[block];
    t->own.block = block;
    t->own.vertex0 = k->vertex;
    t->own.face0 = k->face;
    body->warp = 0;
    body->patch = t->patches;
    body->edge = t->bounds;
    sp__touch_size(t, body);
    sp__touch_patches(t, body, k->faces);
    body->patches = t->patches - body->patch;
    body->edges = t->bounds - body->edge;
    sp__bound_box(t, body->edge, t->bounds, body->lo, body->hi);
    body->convex = sp__touch_convex(t, body);
}

#endif /* SP__CONTACTS_BODY_C */
