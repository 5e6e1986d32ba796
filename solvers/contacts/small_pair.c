/* small_pair: polygon.c and sweep.c for SP_SMALL. Every pair of blocks is compared, and the faces of A in one plane share with
 * B the convex hull of their intersections: a force at a point of the hull is a sum of forces at its corners. */
#ifndef SP__CONTACTS_SMALL_PAIR_C
#define SP__CONTACTS_SMALL_PAIR_C

#include "body.c"
#include "overlap.c"
#include "pair.c"

#if SP__WITH_SMALL

/* Give the boundary of a patch to the clipper: A's as it is, B's in A's plane, turned round. */
static void sp__pair_region(sp__touch *t, const sp__patch *plane, const sp__patch *p, int32_t side)
{
    for (int32_t k = 0; k < p->edges; k++) {
        sp_real x[2];
        sp__pair_to_plane(t, plane, t->scene->vertex[t->all.bound[p->edge + (side ? p->edges - 1 - k : k)][0]], x);
        sp__clip_add(&t->clip, side, x);
    }
}

/* Append what was gathered in the plane of patch p, unless that is all and narrower than `gap`. */
static void sp__pair_close(sp__touch *t, const sp__patch *p)
{
    const int32_t n = t->pair.corners;
    for (int32_t k = 0; k < n; k++) sp__pair_to_space(t, p, t->pair.hull.p[k], t->pair.point[k]);
    if (n && (t->pair.parts || sp__clip_excess_area(t->pair.hull.p, n, t->now.gap / t->now.unit) > 0))
        sp__pair_add(t, n, t->pair.point);
    t->pair.corners = 0;
}

/* Gather the clipper's polygon: the hull of it and what there is. Without room for that what there is goes by itself. */
static void sp__pair_gather(sp__touch *t, const sp__patch *p)
{
    sp__clip *c = &t->clip;
    sp__hull *h = &t->pair.hull;
    if (t->pair.corners + c->corners > c->room) {
        t->pair.parts++;
        sp__pair_close(t, p);
    }
    h->points = t->pair.corners + c->corners;
    memcpy(h->p + t->pair.corners, c->corner, (size_t)c->corners * sizeof *h->p);
    sp__hull_run(h);
    c->corners = h->corners;
    for (int32_t k = 0; k < h->corners; k++) memcpy(c->corner[k], h->p[h->corner[k]], sizeof *h->p);
    sp__clip_straighten(c);
    t->pair.corners = c->corners;
    memcpy(h->p, c->corner, (size_t)c->corners * sizeof *h->p);
}

/* Gather loop l of the clipper, a polygon in the plane of patch p, if B's plane is near. */
static void sp__pair_add_loop(sp__touch *t, const sp__patch *p, const sp__patch *q, int32_t l)
{
    const int32_t from = t->clip.loop[l], size = t->clip.loop[l + 1] - from;
    for (int32_t k = 0; k < size; k++) sp__pair_to_space(t, p, t->clip.corner[from + k], t->pair.point[k]);
    if (sp__pair_meets(t, p, q, t->pair.point, size)) sp__pair_gather(t, p);
}

/* The polygon that patch u of A and q of B share, in the plane of patch p, the first of A in u's plane. */
static void sp__pair_clip(sp__touch *t, const sp__patch *p, const sp__patch *u, const sp__patch *q)
{
    sp__pair_plane(t, p);
    sp__pair_region(t, p, u, 0);
    sp__pair_region(t, p, q, 1);
    if (!sp__clip_run(&t->clip, t->now.snap / t->now.unit, t->now.gap / t->now.unit)) { t->status = SP_E_MEMORY; return; }
    if (t->clip.bent) { t->status = SP_E_UNSUPPORTED; return; }
    for (int32_t l = 0; l < t->clip.loops && !t->status; l++) sp__pair_add_loop(t, p, q, l);
}

/* All contacts of one pair, plane by plane of A, and their overlap. */
static void sp__touch_pair(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->now.a], *q = &t->all.body[b];
    if (t->scene->block[t->now.a].fixed == SP_FIXED && t->scene->block[b].fixed == SP_FIXED) return;
    sp__pair_start(t, b);
    if (!p->edges || !q->edges || !sp__boxes_near(p->lo, p->hi, q->lo, q->hi, p->reach + q->reach)) return;
    for (int32_t plane = p->patch; plane < p->patch + p->patches; plane++) {
        const sp__patch *first = &t->all.patch[plane];
        t->pair.parts = 0;
        for (int32_t i = plane; i < p->patch + p->patches; i++)
            for (int32_t j = q->patch; j < q->patch + q->patches && !t->status; j++) {
                const sp__patch *u = &t->all.patch[i], *v = &t->all.patch[j];
                if (u->plane == plane && sp__pair_opposed(t, u, v)) sp__pair_clip(t, first, u, v);
            }
        sp__pair_close(t, first);
    }
    if (!t->status) sp__pair_overlap(t);
}

/* Every pair of blocks. */
static void sp__touch_all(sp__touch *t, sp_arena *scratch)
{
    sp_scene *scene = t->scene;
    sp__touch_carve(&t->all, &t->clip, &t->pair, scene, scratch);
    if (sp__failed(scratch)) { t->status = SP_E_MEMORY; return; }
    for (int32_t i = 0; i < scene->count.blocks; i++) sp__touch_block(t, i);
    for (t->now.a = 0; t->now.a < scene->count.blocks; t->now.a++)
        for (int32_t b = t->now.a + 1; b < scene->count.blocks && !t->status; b++) sp__touch_pair(t, b);
}

#endif

#endif /* SP__CONTACTS_SMALL_PAIR_C */
