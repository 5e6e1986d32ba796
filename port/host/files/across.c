#include "across.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#define ALONG  0.9                      /* cosine: joints that face the same way */
#define WITHIN 0.1                      /* of a block's width: so far inside its faces lies the plane of a joint across it */

/* Joints of each block: list[start[b]] .. list[start[b + 1] - 1]. */
typedef struct incidence { int32_t *start, *list; } incidence;

static int make_incidence(const sp_scene *s, incidence *w)
{
    w->start = calloc((size_t)s->count.blocks + 2, sizeof *w->start);
    w->list = malloc((2 * (size_t)s->count.joints + 1) * sizeof *w->list);
    if (!w->start || !w->list) return 0;
    int32_t *next = w->start + 1;                       /* the end of b's list while it grows, its start before */
    for (int32_t j = 0; j < s->count.joints; j++) {
        next[s->joint[j].a + 1]++;
        next[s->joint[j].b + 1]++;
    }
    for (int32_t b = 0; b < s->count.blocks; b++) next[b + 1] += next[b];
    for (int32_t j = 0; j < s->count.joints; j++) {
        w->list[next[s->joint[j].a]++] = j;
        w->list[next[s->joint[j].b]++] = j;
    }
    return 1;
}

static int joins(const sp_joint *t, int32_t b) { return t->a == b || t->b == b; }

/* Does t join the block with `other`, facing as `face` does? */
static int faces_alike(const sp_joint *t, const sp_joint *face)
{
    double c = 0;
    for (int i = 0; i < 3; i++) c += (double)t->n[i] * (double)face->n[i];
    return fabs(c) > ALONG;
}

static int joined(const sp_scene *s, const incidence *w, int32_t block, int32_t other, const sp_joint *face)
{
    for (int32_t k = w->start[block]; k < w->start[block + 1]; k++) {
        const sp_joint *t = &s->joint[w->list[k]];
        if (joins(t, other) && faces_alike(t, face)) return 1;
    }
    return 0;
}

/* Does the plane of t pass through the block, thinner than `most` along its normal? A block is wider than V / d^2. */
static int is_between(const sp_scene *s, const sp_block *k, const sp_joint *t, double most)
{
    double low = DBL_MAX, high = -DBL_MAX;
    if (!((double)k->volume > 0) || (double)(k->volume / k->diameter / k->diameter) > most) return 0;
    for (int32_t v = k->vertex; v < k->vertex + k->vertices; v++) {
        double x = 0;
        for (int i = 0; i < 3; i++) x += (double)t->n[i] * (double)(s->vertex[v][i] - s->point[t->point][i]);
        low = fmin(low, x);
        high = fmax(high, x);
    }
    return high - low <= 2 * most && fmin(-low, high) > WITHIN * (high - low);
}

/* Do the boxes of a block and a joint meet, wider by `most`? */
static int is_near(const sp_scene *s, const sp_block *k, const sp_joint *t, double most)
{
    for (int i = 0; i < 3; i++) {
        double low[2] = { DBL_MAX, DBL_MAX }, high[2] = { -DBL_MAX, -DBL_MAX };
        for (int32_t v = 0; v < k->vertices + t->points; v++) {
            const int own = v < k->vertices;
            const double x = (double)(own ? s->vertex[k->vertex + v] : s->point[t->point + v - k->vertices])[i];
            low[own] = fmin(low[own], x);
            high[own] = fmax(high[own], x);
        }
        if (low[0] > high[1] + most || low[1] > high[0] + most) return 0;
    }
    return 1;
}

/* A block between those that joint j joins, -1: none. Of the two the one with fewer joints is asked for it. */
static int32_t between(const sp_scene *s, const incidence *w, int32_t j, double most)
{
    const sp_joint *t = &s->joint[j];
    const int32_t of_a = w->start[t->a + 1] - w->start[t->a], of_b = w->start[t->b + 1] - w->start[t->b];
    const int32_t near = of_a <= of_b ? t->a : t->b, far = near == t->a ? t->b : t->a;
    for (int32_t k = w->start[near]; k < w->start[near + 1]; k++) {
        const sp_joint *u = &s->joint[w->list[k]];
        const int32_t c = u->a == near ? u->b : u->a;
        const sp_block *third = &s->block[c];
        if (c == far || !faces_alike(u, t) || !is_between(s, third, t, most)) continue;
        if (is_near(s, third, t, most) && joined(s, w, c, far, t)) return c;
    }
    return -1;
}

/* The distance that counts for a pair, as the settings tell it. */
static double distance_of(const sp_scene *s, const sp_joint *t, const touching *told)
{
    const double a = (double)s->block[t->a].diameter, b = (double)s->block[t->b].diameter;
    return (double)told->distance * (told->share ? fmin(a, b) : 1);
}

int across_mark(const sp_scene *s, const touching *told, int32_t *third)
{
    incidence w = { NULL, NULL };
    const int good = make_incidence(s, &w);
    for (int32_t j = 0; good && j < s->count.joints; j++)
        third[j] = between(s, &w, j, distance_of(s, &s->joint[j], told));
    free(w.start);
    free(w.list);
    return good;
}

int32_t across_find(const sp_scene *s, const touching *told, const char *const *name, remarks *r)
{
    int32_t *third = told->has_distance ? malloc(((size_t)s->count.joints + 1) * sizeof *third) : NULL;
    int32_t n = 0, first = -1;
    if (third && across_mark(s, told, third))
        for (int32_t j = 0; j < s->count.joints; j++) if (third[j] >= 0 && !n++) first = j;
    if (n) remarks_add(r, "--contact-distance", "%ld joint%s a block thinner than the contact distance, that of '%.60s' and "
                       "'%.60s' across '%.60s'%s: a lesser distance leaves %s out", (long)n, n == 1 ? " reaches across" :
                       "s reach across", name[s->joint[first].a], name[s->joint[first].b], name[third[first]],
                       n == 1 ? "" : " first", n == 1 ? "it" : "them");
    free(third);
    return n;
}
