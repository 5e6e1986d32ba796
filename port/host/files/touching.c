#include "touching.h"
#include "../run.h"

#include <math.h>
#include <stdlib.h>

#define SLOPE    8.0                    /* faces may rise by so many distances across the narrower of them */
#define STEEPEST 0.5                    /* sine, the library's limit */

int touching_read_distance(text_word w, touching *t)
{
    t->has_distance = 1;
    t->share = w.n > 1 && w.s[w.n - 1] == '%';
    if (t->share) w.n--;
    if (text_real(w, &t->distance) != TEXT_NUMBER || !(t->distance >= 0)) return 0;
    if (t->share) t->distance /= 100;
    return !t->share || t->distance <= (sp_real)0.5;
}

int touching_read_angle(text_word w, touching *t)
{
    t->has_angle = 1;
    return text_real(w, &t->angle) == TEXT_NUMBER && t->angle >= 0 && t->angle <= 30;
}

touching touching_join(touching first, touching second)
{
    if (!first.has_distance) {
        first.has_distance = second.has_distance;
        first.distance = second.distance;
        first.share = second.share;
    }
    if (!first.has_angle) {
        first.has_angle = second.has_angle;
        first.angle = second.angle;
    }
    return first;
}

sp_real touching_smallest(const sp_scene *s)
{
    sp_real least = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_real d = s->block[b].diameter;
        if (d > 0 && (!(least > 0) || d < least)) least = d;
    }
    return least;
}

sp_contact_settings touching_settings(touching t)
{
    sp_contact_settings set = sp_contact_settings_default();
    if (t.has_distance) {
        set.absolute = !t.share;
        set.distance = t.distance;
        set.angle = (sp_real)-SLOPE;
    }
    if (t.has_angle) set.angle = (sp_real)fmin(STEEPEST, sin((double)t.angle * acos(-1.0) / 180));
    return set;
}

void touching_json(json_out *j, const touching *t, int32_t near)
{
    if (!t) {
        json_null(j, "touching");
        return;
    }
    const sp_contact_settings set = touching_settings(*t);
    json_open(j, "touching", '{');
    json_real(j, "distance", (double)set.distance);
    json_bool(j, "share", !set.absolute);
    if (set.angle >= 0) json_real(j, "angle", asin((double)set.angle) * 180 / acos(-1.0));
    else json_null(j, "angle");
    json_int(j, "near_pairs", near);
    json_close(j, '}');
}

/* --------------------------------------------------------------------------------------------------------- found once more */

void touching_free(touching_found *p)
{
    free(p->joint);
    free(p->point);
    p->joint = NULL;
    p->point = NULL;
}

static sp_status find(sp_scene *s, const sp_contact_settings *set, sp_contact_report *report)
{
    const sp_contact_report none = { 0, 0, 0, 0, NULL };
    void *memory;
    sp_arena scratch;
    sp_status status = run_arena(run_bytes(s, SP_FOR_CONTACTS, NULL), &scratch, &memory);
    *report = none;
    if (status == SP_OK) status = sp_contacts_find(s, set, scratch, report);
    free(memory);
    return status;
}

int touching_find(const sp_scene *s, const sp_contact_settings *set, touching_found *p)
{
    sp_contact_report report;
    sp_status status;
    p->scene = *s;
    p->joint = NULL;
    p->point = NULL;
    p->scene.count.joints = p->scene.count.points = 0;
    p->scene.capacity.joints = p->scene.capacity.points = 0;
    status = find(&p->scene, set, &report);
    p->overlaps = report.overlaps;
    if (status == SP_OK) return 1;
    if (status != SP_E_CAPACITY) return 0;
    p->joint = malloc((size_t)report.joints * sizeof *p->joint);
    p->point = malloc((size_t)report.points * sizeof *p->point);
    p->scene.joint = p->joint;
    p->scene.point = p->point;
    p->scene.capacity.joints = report.joints;
    p->scene.capacity.points = report.points;
    if (p->joint && p->point && find(&p->scene, set, &report) == SP_OK) return 1;
    touching_free(p);
    return 0;
}

/* -------------------------------------------------------------------------------------------------------- inside each other */

static int has_joint(const sp_scene *s, int32_t a, int32_t b)
{
    for (int32_t k = 0; k < s->count.joints; k++) if (s->joint[k].a == a && s->joint[k].b == b) return 1;
    return 0;
}

/* Deeper than what nearly touches: 1 % of the smaller, and no more than that counts of a thin one (a quarter of V / d^2). */
static int is_deep(const sp_scene *s, const sp_overlap *o)
{
    double least = -1;
    for (int side = 0; side < 2; side++) {
        const sp_block *k = &s->block[side ? o->b : o->a];
        const double d = (double)k->diameter, thin = (double)k->volume / d / d / 4;
        const double most = k->volume > 0 ? fmin(TOUCHING_WIDEST * d, thin) : TOUCHING_WIDEST * d;
        least = least < 0 ? most : fmin(least, most);
    }
    return (double)o->depth > least;
}

int32_t touching_inside(const sp_scene *s, const sp_overlap *overlap, int32_t overlaps, const char *const *name, remarks *r)
{
    const sp_overlap *first = NULL;
    int32_t n = 0;
    for (int32_t i = 0; i < overlaps; i++) {
        if (!is_deep(s, &overlap[i]) || has_joint(s, overlap[i].a, overlap[i].b)) continue;
        if (!n++) first = &overlap[i];
    }
    if (n) remarks_add(r, NULL, "%ld pair%s of blocks lie%s inside each other and do%s not touch: %s and %s by %.3g m%s: "
                       "move them apart, or leave one out", (long)n, n == 1 ? "" : "s", n == 1 ? "s" : "",
                       n == 1 ? "es" : "", name[first->a], name[first->b], (double)first->depth, n == 1 ? "" : " first");
    return n;
}
