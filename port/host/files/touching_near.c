#include "across.h"
#include "touching.h"

#include <math.h>
#include <stdlib.h>

#define STEPS 4                         /* of ten each, up to the widest distance */
#define LARGE 0.1                       /* of the smallest block: no gap between faces that touch */
#define LEAST 0.99                      /* of its area a contact needs to count as whole */

/* Area of the joints of one pair from joint *k on, which goes behind them; those across a `third` block do not count. */
static double add_area(const sp_scene *s, int32_t a, int32_t b, const int32_t *third, int32_t *k)
{
    double area = 0;
    for (; *k < s->count.joints && s->joint[*k].a == a && s->joint[*k].b == b; ++*k)
        if (!third || third[*k] < 0) area += (double)s->joint[*k].area;
    return area;
}

/* Pairs that touch in `wide` and in `s` not, or not whole. Both have their joints in the order of pairs, as
 * the library finds them. */
static int32_t count_missing(const sp_scene *s, const sp_scene *wide, const int32_t *third)
{
    int32_t missing = 0, k = 0;
    for (int32_t i = 0; i < wide->count.joints; ) {
        const int32_t a = wide->joint[i].a, b = wide->joint[i].b;
        const double most = add_area(wide, a, b, third, &i);
        while (k < s->count.joints && (s->joint[k].a < a || (s->joint[k].a == a && s->joint[k].b < b))) k++;
        missing += add_area(s, a, b, NULL, &k) < most * LEAST;
    }
    return missing;
}

/* Distance as a share of the smaller block, with the angle that follows from it. */
static touching touching_at(double share)
{
    touching t = { 1, 1, 0, 0, 0 };
    t.distance = (sp_real)share;
    return t;
}

static sp_contact_settings settings_at(double share, const sp_contact_settings *used)
{
    sp_contact_settings set = touching_settings(touching_at(share));
    set.strength = used->strength;
    return set;
}

/* The least power of ten that counts what the widest does. */
static double find_share(const sp_scene *s, const sp_scene *wide, const int32_t *third, const sp_contact_settings *used)
{
    double share = TOUCHING_WIDEST;
    for (int k = 1; k < STEPS; k++) {
        const double less = TOUCHING_WIDEST * pow(10, -k);
        const sp_contact_settings set = settings_at(less, used);
        touching_found p;
        if (!touching_find(s, &set, &p)) return share;
        const int32_t missing = count_missing(&p.scene, wide, third);
        touching_free(&p);
        if (missing) return share;
        share = less;
    }
    return share;
}

/* Pairs that touch at the widest distance and in the scene not, or not whole. */
static int32_t near_wide(const sp_scene *scene, const sp_contact_settings *used, remarks *r)
{
    const sp_contact_settings set = settings_at(TOUCHING_WIDEST, used);
    char option[64];
    touching_found p;
    if (!used->absolute && used->distance >= set.distance) return 0;
    if (!touching_find(scene, &set, &p)) return 0;
    const touching widest = touching_at(TOUCHING_WIDEST);
    int32_t *third = malloc(((size_t)p.scene.count.joints + 1) * sizeof *third);
    const int32_t missing = third && across_mark(&p.scene, &widest, third) ? count_missing(scene, &p.scene, third) : 0;
    const double share = missing ? find_share(scene, &p.scene, third, used) : 0;
    free(third);
    touching_free(&p);
    if (!missing) return 0;
    snprintf(option, sizeof option, "--contact-distance %g%%", 100 * share);
    remarks_add(r, option, "%ld pair%s of blocks nearly touch%s and %s not counted, or not whole: faces up to %g %% of "
                "the smaller block apart", (long)missing, missing == 1 ? "" : "s", missing == 1 ? "es" : "",
                missing == 1 ? "is" : "are", 100 * share);
    return missing;
}

/* Pairs that touch at the default distance and at a larger one in use not: what they share is narrower than that. */
static int32_t near_narrow(const sp_scene *scene, const sp_contact_settings *used, remarks *r)
{
    sp_contact_settings set = sp_contact_settings_default();
    touching_found p;
    if (!used->absolute && used->distance <= set.distance) return 0;
    set.strength = used->strength;
    if (used->angle >= 0) set.angle = used->angle;
    if (!touching_find(scene, &set, &p)) return 0;
    const int32_t missing = count_missing(scene, &p.scene, NULL);
    touching_free(&p);
    if (missing)
        remarks_add(r, "--contact-distance", "%ld pair%s of blocks touch%s where it is narrower than the contact distance, "
                    "and %s not counted, or not whole: a lesser distance counts %s", (long)missing, missing == 1 ? "" : "s",
                    missing == 1 ? "es" : "", missing == 1 ? "is" : "are", missing == 1 ? "it" : "them");
    return missing;
}

int32_t touching_near(const sp_scene *scene, const sp_contact_settings *used, remarks *r)
{
    const int32_t wide = near_wide(scene, used, r);
    return wide + near_narrow(scene, used, r);
}

void touching_large(const sp_scene *scene, const touching *told, remarks *r)
{
    const double least = (double)touching_smallest(scene), d = (double)told->distance;
    if (!told->has_distance || told->share || !(least > 0) || d < LARGE * least) return;
    remarks_add(r, "--contact-distance", "the contact distance, %.3g m, is %.3g times what the smallest block measures: it is "
                "in metres, whatever the unit of the model", d, d / least);
}
