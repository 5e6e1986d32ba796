/* find: what touches what, over the whole scene */
#ifndef SP__CONTACTS_FIND_C
#define SP__CONTACTS_FIND_C

#include "pair.c"
#include "overlap.c"

/* --------------------------------------------------------------------------------------------------------------- find */

/* All of one pair. */
static void sp__touch_pair(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[b];
    if (t->scene->block[t->a].fixed == SP_FIXED && t->scene->block[b].fixed == SP_FIXED) return;
    sp__pair_start(t, b);
#ifdef SP_SMALL
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
#else
    t->points = t->founds = 0;
    const int32_t n = sp__pair_near(t, p, q, t->pair.near_a), m = sp__pair_near(t, q, p, t->pair.near_b);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < m && !t->status; j++) {
            const sp__patch *u = &t->all.patch[t->pair.near_a[i]], *v = &t->all.patch[t->pair.near_b[j]];
            if (sp__pair_opposed(t, u, v)) sp__pair_clip(t, u, u, v);
        }
    if (t->status) return;
    sp__pair_append(t);
#endif
    if (!t->status) sp__pair_overlap(t);
}

#ifndef SP_SMALL
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
#endif

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
    t->set = settings ? *settings : sp_contact_settings_default();
    t->status = sp__contact_settings_check(&t->set);
    if (t->status) return t->status;
    t->scene = scene;
    t->before = scene->count;
    t->report.overlap = report->overlap;
    t->report.overlap_cap = report->overlap_cap;
#ifdef SP_SMALL
    sp__touch_carve(&t->all, &t->clip, &t->pair, scene, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    for (int32_t i = 0; i < scene->count.blocks; i++) sp__touch_block(t, i);
    for (t->a = 0; t->a < scene->count.blocks; t->a++)
        for (int32_t b = t->a + 1; b < scene->count.blocks && !t->status; b++) sp__touch_pair(t, b);
#else
    sp__all_carve(&t->all, scene, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__touch_blocks(t, &scratch);
    if (!t->status) sp__tree_build(t);
    for (t->a = 0; t->a < scene->count.blocks && !t->status; t->a++) {
        const int32_t hits = sp__tree_ask(t, t->a);
        for (int32_t h = 0; h < hits && !t->status; h++) sp__touch_pair(t, t->all.hit[h]);
    }
#endif
    if (t->status || t->full) scene->count = t->before;
    if (t->status) return t->status;
    *report = t->report;
    return t->full ? SP_E_CAPACITY : SP_OK;
}

#endif /* SP__CONTACTS_FIND_C */
