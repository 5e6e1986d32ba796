/* small_patch: patch.c and memory.c for SP_SMALL. Each face with an area is a patch. */
#ifndef SP__CONTACTS_SMALL_PATCH_C
#define SP__CONTACTS_SMALL_PATCH_C

#include "face.c"

#if SP__WITH_SMALL

/* All arrays of the search. A pair never needs more than two faces at once and the hull of what they share. */
static void sp__touch_carve(sp__contact_arrays *l, sp__clip *clip, sp__pair_buffer *pair, const sp_scene *scene, sp_arena *a)
{
    const sp_capacity *n = &scene->count;
    int32_t side = 16;                          /* at least: for the hull of many small faces */
    for (int32_t f = 0; f < n->faces; f++) if (scene->face[f].corners > side) side = scene->face[f].corners;
    l->body = sp__take(a, (size_t)n->blocks, sizeof *l->body);
    l->patch = sp__take(a, (size_t)n->faces, sizeof *l->patch);
    l->bound = sp__take(a, (size_t)n->corners, sizeof *l->bound);
    sp__clip_carve(clip, side, side, a);
    pair->point = sp__take(a, (size_t)clip->room, sizeof *pair->point);
    sp__hull_carve(&pair->hull, clip->room, a);
}

static size_t sp__contacts_memory(const sp_scene *scene)
{
    sp_arena dry = sp__arena_dry();
    struct { sp__contact_arrays all; sp__clip clip; sp__pair_buffer pair; } none;
    (void)sp__take(&dry, 1, sizeof(sp__touch));
    sp__touch_carve(&none.all, &none.clip, &none.pair, scene, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

/* Patches of a block: its faces that have an area. */
static void sp__touch_patches(sp__touch *t, sp__body *body, int32_t faces)
{
    const sp_real flat = sp__plane_tolerance(t, body);
    for (int32_t f = 0; f < faces; f++) {
        const sp_face *face = &t->scene->face[t->own.face0 + f];
        const int32_t *corner = t->scene->corner + face->corner;
        sp__patch *p = &t->all.patch[t->patches];
        if (!(sp__face_plane(t, f, p->n, p->o) > 0)) continue;
        body->warp = sp__max(body->warp, sp__face_distance(t, f, p->n, p->o));
        p->edge = t->bounds;
        p->edges = face->corners;
        for (int32_t k = 0; k < p->edges; k++) {
            t->all.bound[t->bounds][0] = corner[k];
            t->all.bound[t->bounds++][1] = corner[k + 1 < p->edges ? k + 1 : 0];
        }
        sp__bound_box(t, p->edge, t->bounds, p->lo, p->hi);
        p->plane = body->patch;
        for (const sp__patch *q; p->plane < t->patches; p->plane++) {
            q = &t->all.patch[p->plane];
            if (q->plane == p->plane && sp__dot3(q->n, p->n) > 0 && sp__face_distance(t, f, q->n, q->o) <= flat) break;
        }
        t->patches++;
    }
}

#endif

#endif /* SP__CONTACTS_SMALL_PATCH_C */
