#include "suspects.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define LARGE     100.0                 /* [m] no stone is that long */
#define SMALL     1e-3                  /* [m] and a model of parts below this is in other units */
#define HEAVIEST  2e6                   /* [kg] the heaviest stone ever quarried in one piece: some 1650 t, at Baalbek */
#define DENSEST   23000.0               /* [kg/m^3] osmium has 22590 */
#define LIGHTEST  5.0                   /* [kg/m^3] foams begin at some 10: g/cm^3 are below */
#define ROUGHEST  5.0                   /* friction that no stones have, */
#define STEEPEST  90.0                  /* but that an angle in degrees may be; beyond it nothing is meant to slide */
#define LEVEL     0.1                   /* a normal with a smaller part of itself along gravity carries little by pressure */
#define WEDGED    0.01                  /* but stones of a flat arch rest on each other by as little */
#define SOME      0.1                   /* share of all area */
#define OFF       0.01                  /* of the smaller block: a joint farther from a block is none of its */

static void suspect_supports(const sp_scene *s, remarks *r)
{
    int32_t supports = 0, touching = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) supports += s->block[b].fixed != 0;
    for (int32_t i = 0; i < s->count.joints; i++)
        touching += s->block[s->joint[i].a].fixed != 0 || s->block[s->joint[i].b].fixed != 0;
    if (!supports)
        remarks_add(r, "--fixed NAME,..., --fixed lowest or --fixed ground", "no block is a support; tell which are");
    else if (supports == s->count.blocks) remarks_add(r, NULL, "every block is a support: there is nothing that could fall");
    else if (!touching && s->count.joints > 0) remarks_add(r, NULL, "no support touches a block");
}

/* The largest and the smallest free block, and the heaviest. -1: there is none. */
typedef struct extremes { int32_t large, small, heavy, sizes_large, sizes_small; } extremes;

static extremes find_extremes(const sp_scene *s)
{
    extremes x = { -1, -1, -1, 0, 0 };
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_block *k = &s->block[b];
        if (k->fixed) continue;
        if (x.heavy < 0 || k->mass > s->block[x.heavy].mass) x.heavy = b;
        if (!(k->diameter > 0)) continue;
        if (x.large < 0 || k->diameter > s->block[x.large].diameter) x.large = b;
        if (x.small < 0 || k->diameter < s->block[x.small].diameter) x.small = b;
        x.sizes_large += (double)k->diameter > LARGE;
        x.sizes_small += (double)k->diameter < SMALL;
    }
    return x;
}

/* What helps a model that is so many times too large: the unit that exports often have. */
static const char *smaller_unit(suspects_known known, double size)
{
    if (known.unit.over) return "another --unit";
    return size > LARGE ? "--unit mm, cm or in" : "--unit cm or mm";
}

static void suspect_sizes(const sp_scene *s, const char *const *name, suspects_known known, remarks *r)
{
    const extremes x = find_extremes(s);
    const double large = x.large < 0 ? 0 : (double)s->block[x.large].diameter;
    const double small = x.small < 0 ? 0 : (double)s->block[x.small].diameter;
    const double heavy = x.heavy < 0 ? 0 : (double)s->block[x.heavy].mass;
    if (x.sizes_large)
        remarks_add(r, smaller_unit(known, large), "%ld block%s larger than 100 m, the largest, '%.60s', measures %.3g m",
                    (long)x.sizes_large, x.sizes_large == 1 ? " is" : "s are", name[x.large], large);
    else if (heavy > HEAVIEST)
        remarks_add(r, smaller_unit(known, large), "block '%.60s' weighs %.3g t, more than any stone that was ever moved",
                    name[x.heavy], 1e-3 * heavy);
    if (x.sizes_small)
        remarks_add(r, known.unit.over ? "another --unit" : NULL,
                    "%ld block%s smaller than 1 mm, the smallest, '%.60s', measures %.3g mm; lengths are metres",
                    (long)x.sizes_small, x.sizes_small == 1 ? " is" : "s are", name[x.small], 1e3 * small);
}

/* The first block whose density no matter has. */
static void suspect_densities(const sp_scene *s, const char *const *name, remarks *r)
{
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const double density = (double)s->block[b].density;
        if (s->block[b].fixed || !(density > DENSEST || (density > 0 && density < LIGHTEST))) continue;
        remarks_add(r, NULL, "block '%.60s' has a density of %.3g kg/m^3, %s", name[b], density,
                    density > DENSEST ? "more than any metal" : "less than any foam; stone has some 2400");
        return;
    }
}

/* The first joint whose friction looks like its angle. */
static void suspect_friction(const sp_scene *s, const char *const *name, remarks *r)
{
    for (int32_t i = 0; i < s->count.joints; i++) {
        const sp_joint *t = &s->joint[i];
        const double mu = (double)t->strength.mu;
        char option[32];
        if (!(mu > ROUGHEST && mu < STEEPEST)) continue;
        snprintf(option, sizeof option, "--mu %.3g", tan(mu * acos(-1.0) / 180));
        remarks_add(r, option, "the friction of '%.60s' and '%.60s' is %.3g, more than of any stones; it is the tangent of an "
                    "angle", name[t->a], name[t->b], mu);
        return;
    }
}

/* Share of the area of joints whose normal has more than `least` of itself along this axis. */
static double share_along(const sp_scene *s, int axis, double least)
{
    double area = 0, all = 0;
    for (int32_t i = 0; i < s->count.joints; i++) {
        all += (double)s->joint[i].area;
        if (fabs((double)s->joint[i].n[axis]) > least) area += (double)s->joint[i].area;
    }
    return all > 0 ? area / all : 0;
}

/* Y up, taken for z up, as gravity is unless a file tells another: no block rests on another, but would if y were up. */
static void suspect_direction(const sp_scene *s, remarks *r)
{
    if (s->count.joints == 0 || share_along(s, 2, LEVEL) > 0 || share_along(s, 2, WEDGED) > SOME) return;
    if (share_along(s, 1, LEVEL) < SOME) return;
    remarks_add(r, "--up y", "no block rests on another: every face that touches stands upright, as if y were up");
}

typedef struct box { double low[3], high[3]; } box;

static box box_around(const sp_scene *s, const sp_block *k)
{
    box b = { { DBL_MAX, DBL_MAX, DBL_MAX }, { -DBL_MAX, -DBL_MAX, -DBL_MAX } };
    for (int32_t v = 0; v < k->vertices; v++)
        for (int i = 0; i < 3; i++) {
            b.low[i] = fmin(b.low[i], (double)s->vertex[k->vertex + v][i]);
            b.high[i] = fmax(b.high[i], (double)s->vertex[k->vertex + v][i]);
        }
    return b;
}

/* How far the corner of this joint lies from the box that lies farthest from it. */
static double distance_off(const sp_scene *s, const sp_joint *t, const box *b)
{
    double most = 0;
    for (int32_t p = t->point; p < t->point + t->points; p++) {
        double d[3];
        for (int i = 0; i < 3; i++) {
            const double x = (double)s->point[p][i];
            d[i] = fmax(fmax(b->low[i] - x, x - b->high[i]), 0);
        }
        most = fmax(most, sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
    }
    return most;
}

/* The joints that lie off their blocks, and the farthest of them. */
typedef struct strays { int32_t count, farthest; double from_a, from_b; } strays;

static strays find_strays(const sp_scene *s, const box *around)
{
    strays x = { 0, 0, 0, 0 };
    for (int32_t j = 0; j < s->count.joints; j++) {
        const sp_joint *t = &s->joint[j];
        const sp_block *a = &s->block[t->a], *b = &s->block[t->b];
        if (!a->vertices || !b->vertices) continue;                 /* given by its mass: where it ends is not known */
        const double from_a = distance_off(s, t, &around[t->a]), from_b = distance_off(s, t, &around[t->b]);
        if (!(fmax(from_a, from_b) > OFF * fmin((double)a->diameter, (double)b->diameter))) continue;
        x.count++;
        if (fmax(from_a, from_b) <= fmax(x.from_a, x.from_b)) continue;
        x.farthest = j;
        x.from_a = from_a;
        x.from_b = from_b;
    }
    return x;
}

/* Joints that a file tells are believed wherever they are. */
static void suspect_places(const sp_scene *s, const char *const *name, remarks *r)
{
    box *around = malloc(((size_t)s->count.blocks + 1) * sizeof *around);
    if (!around) return;
    for (int32_t b = 0; b < s->count.blocks; b++) around[b] = box_around(s, &s->block[b]);
    const strays x = find_strays(s, around);
    const sp_joint *t = &s->joint[x.farthest];
    if (x.count)
        remarks_add(r, NULL, "%ld joint%s off the blocks told for %s, %sthat of '%.60s' and '%.60s': up to %.3g m from the "
                    "one, %.3g m from the other", (long)x.count, x.count == 1 ? " lies" : "s lie", x.count == 1 ? "it" : "them",
                    x.count == 1 ? "" : "the farthest ", name[t->a], name[t->b], x.from_a, x.from_b);
    free(around);
}

void suspects_find(const sp_scene *scene, const char *const *name, suspects_known known, remarks *r)
{
    suspect_supports(scene, r);
    if (known.joints) suspect_places(scene, name, r);
    if (!known.down) suspect_direction(scene, r);
    suspect_sizes(scene, name, known, r);
    suspect_densities(scene, name, r);
    suspect_friction(scene, name, r);
}
