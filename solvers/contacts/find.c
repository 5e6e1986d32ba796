/* find: sp_contacts_find checks settings and scene, finds the patches, then all contacts, and adds them as joints. */
#ifndef SP__CONTACTS_FIND_C
#define SP__CONTACTS_FIND_C

#include "sweep.c"
#include "small_pair.c"

/* The least angle: -64 distances along the narrower face. */
#if SP__WITH_SMALL
#define SP__ANGLE_LEAST 0
#else
#define SP__ANGLE_LEAST (-64)
#endif

static sp_status sp__contact_settings_check(const sp_contact_settings *s)
{
    if (!sp__finite(s->distance) || !sp__finite(s->angle)) return SP_E_RANGE;
    if (s->distance < 0 || s->angle < SP__ANGLE_LEAST || s->angle > (sp_real)0.5) return SP_E_RANGE;
    return sp__strength_check(&s->strength);
}

SP_API sp_status sp_contacts_find(sp_scene *scene, const sp_contact_settings *settings, sp_arena scratch,
                                  sp_contact_report *report)
{
    if (!scene || !scratch.base || !report || report->overlap_capacity < 0) return SP_E_ARGUMENT;
    sp__touch *t = sp__take(&scratch, 1, sizeof *t);
    if (!t) return SP_E_MEMORY;
    memset(t, 0, sizeof *t);
    t->set = settings ? *settings : sp_contact_settings_default();
    t->status = sp__contact_settings_check(&t->set);
    if (t->status) return t->status;
    t->scene = scene;
    t->before = scene->count;
    t->report.overlap = report->overlap;
    t->report.overlap_capacity = report->overlap_capacity;
    sp__touch_all(t, &scratch);
    if (t->status || t->full) scene->count = t->before;
    if (t->status) return t->status;
    *report = t->report;
    return t->full ? SP_E_CAPACITY : SP_OK;
}

#endif /* SP__CONTACTS_FIND_C */
