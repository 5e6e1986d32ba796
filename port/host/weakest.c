#include "weakest.h"
#include "motion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define USED 0.01                       /* share of its friction from which a joint is worth a name: below it is rounding */

/* The joints whose force balance alone fixes: those of a block that has no other, and so on with these taken off. Malloc's, a
 * byte each; without memory none is known, or NULL. */
static unsigned char *find_known(const sp_scene *s)
{
    unsigned char *known = calloc((size_t)s->count.joints + 1, 1);
    int32_t *left = calloc((size_t)s->count.blocks + 1, sizeof *left);
    int32_t *which = calloc((size_t)s->count.blocks + 1, sizeof *which);
    const int room = known && left && which;
    for (int32_t k = 0; room && k < s->count.joints; k++)
        for (int side = 0; side < 2; side++) {
            const int32_t b = side ? s->joint[k].b : s->joint[k].a;
            left[b]++;
            which[b] ^= k;                              /* of the last one left: its number */
        }
    for (int32_t first = 0; room && first < s->count.blocks; first++)
        for (int32_t b = first; !s->block[b].fixed && left[b] == 1;) {
            const int32_t k = which[b], other = s->joint[k].a == b ? s->joint[k].b : s->joint[k].a;
            known[k] = 1;
            left[b] = 0;
            left[other]--;
            which[other] ^= k;
            b = other;
        }
    free(left);
    free(which);
    return known;
}

/* Point v of a joint in its plane, from its first one. */
static void flat_point(const sp_scene *s, const sp_joint *t, int32_t v, double at[2])
{
    const sp_real *p = s->point[t->point + v], *o = s->point[t->point];
    at[0] = at[1] = 0;
    for (int c = 0; c < 3; c++) {
        at[0] += (double)(t->t1[c] * (p[c] - o[c]));
        at[1] += (double)(t->t2[c] * (p[c] - o[c]));
    }
}

/* How far p lies to the left of the line from a to b, times its length. */
static double left_of(const double a[2], const double b[2], const double p[2])
{
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

/* The corner of the hull after `from`, anticlockwise: no other lies to the right of the way there.          [Jarvis 1973] */
static int32_t next_corner(const sp_scene *s, const sp_joint *t, int32_t from)
{
    double a[2], b[2], p[2];
    int32_t to = from;
    flat_point(s, t, from, a);
    flat_point(s, t, to, b);
    for (int32_t v = 0; v < t->points; v++) {
        flat_point(s, t, v, p);
        const double left = left_of(a, b, p);
        if (left > 0 || (!(left < 0) && hypot(p[0] - a[0], p[1] - a[1]) <= hypot(b[0] - a[0], b[1] - a[1]))) continue;
        to = v;
        b[0] = p[0];
        b[1] = p[1];
    }
    return to;
}

/* How far the point `at` has gone from the middle of a joint to an edge of its hull; 0: it has no inside. */
static double way_to_edge(const sp_scene *s, const sp_joint *t, const double at[2])
{
    double middle[2] = { 0, 0 }, p[2], a[2], b[2], way = 0;
    int32_t from = 0;
    flat_point(s, t, 0, a);
    for (int32_t v = 0; v < t->points; v++) {
        flat_point(s, t, v, p);
        for (int c = 0; c < 2; c++) middle[c] += p[c] / t->points;
        if (p[0] < a[0]) {
            from = v;
            a[0] = p[0];
        }
    }
    for (int32_t k = 0; k < t->points; k++) {           /* its edges, some of them twice */
        const int32_t to = next_corner(s, t, from);
        flat_point(s, t, from, a);
        flat_point(s, t, to, b);
        const double inside = left_of(a, b, middle), length = hypot(b[0] - a[0], b[1] - a[1]);
        if (inside > 1e-6 * length * length) way = fmax(way, 1 - left_of(a, b, at) / inside);
        from = to;
    }
    return fmin(way, 1);
}

/* Below this a joint carries next to nothing: 1e-4 of the weight of its lighter block, and what rounding leaves. */
static double least_force(const sp_scene *s, const sp_result *x, const sp_joint *t)
{
    const sp_block *a = &s->block[t->a], *b = &s->block[t->b];
    const double mass = (double)(a->fixed == SP_FIXED || (b->fixed != SP_FIXED && b->mass < a->mass) ? b->mass : a->mass);
    const double g = hypot(hypot((double)s->gravity[0], (double)s->gravity[1]), (double)s->gravity[2]);
    return fmax(1e-4 * mass * g, 1e-9 * (double)x->extremes.compression);
}

/* The share of each limit that joint i has reached. Its corners share the area alike and tension counts up to cohesion / mu, as
 * in sp_strength:
 *     tipping    the force that acts with what tension is left, fn + T at each corner, passes so far from the middle to an edge
 *     turning    sum |ft| / sum (mu fn + C): at 1 all corners slip; of a joint that is near sliding 0, for that is told
 *     parting    - sum fn / sum T,   crushing: the largest fn / N */
static void measure(const sp_scene *s, const sp_result *x, int32_t i, double share[WEAKEST_LIMITS])
{
    const sp_joint *t = &s->joint[i];
    const double mu = (double)t->strength.mu, area = (double)t->area, cohesion = (double)t->strength.cohesion;
    const double tension = mu > 0 ? fmin((double)t->strength.tension, cohesion / mu) : (double)t->strength.tension;
    const double T = tension * area / t->points, N = (double)t->strength.crushing * area / t->points;
    double press = 0, rub = 0, left = 0, most = 0, at[2] = { 0, 0 }, p[2];
    sp_joint_force f;

    for (int k = 0; k < WEAKEST_LIMITS; k++) share[k] = 0;
    for (int32_t v = 0; v < t->points; v++) {
        const sp_real *c = x->f + 3 * (size_t)(t->point + v);
        const double fn = (double)c[0], w = fmax(0, fn + T);
        flat_point(s, t, v, p);
        for (int k = 0; k < 2; k++) at[k] += w * p[k];
        left += w;
        press += fn;
        most = fmax(most, fabs(fn));
        rub += hypot((double)c[1], (double)c[2]);
    }
    const double least = least_force(s, x, t), held = mu * press + cohesion * area;
    if (!(most + rub > least) || sp_joint_resultant(s, x, i, &f) != SP_OK) return;
    share[WEAKEST_SLIDING] = (double)f.utilisation;
    for (int k = 0; k < 2; k++) at[k] = left > 0 ? at[k] / left : 0;
    if (left > least) share[WEAKEST_TIPPING] = way_to_edge(s, t, at);
    if (held > 0 && share[WEAKEST_SLIDING] < WEAKEST_NEAR) share[WEAKEST_TURNING] = rub / held;
    if (T > 0) share[WEAKEST_PARTING] = -press / (T * t->points);
    if (N > 0) share[WEAKEST_CRUSHING] = (double)f.max_fn / N;
}

/* The nearer of the two: what is known comes first. */
static void consider(weakest_joint *best, int32_t joint, weakest_limit by, double share, int known)
{
    const weakest_joint other = { joint, by, fmin(share, 1), known };
    if (share < WEAKEST_NEAR || known < best->known) return;
    if (best->joint < 0 || known > best->known || other.share > best->share) *best = other;
}

weakest_joint weakest_nearest(const sp_scene *s, const sp_result *x)
{
    weakest_joint best = { -1, WEAKEST_SLIDING, 0, 0 };
    const int32_t i = x->extremes.weakest;
    sp_joint_force f;
    if (i < 0) return best;
    unsigned char *known = find_known(s);
    for (int32_t k = 0; x->verdict != SP_UNSTABLE && k < s->count.joints; k++) {
        double share[WEAKEST_LIMITS];
        measure(s, x, k, share);
        for (int by = 0; by < WEAKEST_LIMITS; by++) consider(&best, k, (weakest_limit)by, share[by], known && known[k]);
        if (sp_joint_resultant(s, x, k, &f) == SP_OK) consider(&best, k, WEAKEST_SLIDING, (double)f.corner_utilisation, 0);
    }
    if (!best.known && sp_joint_resultant(s, x, i, &f) == SP_OK && (double)f.utilisation >= USED) {
        best.joint = i;
        best.by = WEAKEST_SLIDING;
        best.share = fmin((double)f.utilisation, 1);
        best.known = known && known[i];
    }
    free(known);
    return best;
}

const char *weakest_text(weakest_limit by)
{
    static const char *const text[] = { "sliding", "tipping", "turning", "parting", "crushing" };
    return text[by];
}

void weakest_words(const sp_scene *s, const sp_result *x, const weakest_joint *w, char words[WEAKEST_WORDS])
{
    static const char *const to[] = { "", "tipping about an edge, its force", "turning, friction of its corners used to",
                                      "parting, tension used to", "crushing, strength of a corner used to" };
    sp_joint_force f;
    words[0] = 0;
    if (w->by != WEAKEST_SLIDING)
        snprintf(words, WEAKEST_WORDS, "near %s %.0f %%%s%s", to[w->by], 100 * w->share,
                 w->by == WEAKEST_TIPPING ? " of the way there" : "", w->known ? "" : ", by these forces");
    else if (sp_joint_resultant(s, x, w->joint, &f) == SP_OK)
        snprintf(words, WEAKEST_WORDS, "%sfriction used to %.0f %%, to %.0f %% at a corner",
                 w->known && w->share >= WEAKEST_NEAR ? "near sliding, " : "", 100 * (double)f.utilisation,
                 100 * (double)f.corner_utilisation);
}

int32_t weakest_told(const sp_scene *s, const sp_result *x)
{
    const int32_t i = x->extremes.weakest;
    const int falls = i >= 0 && (x->demand[i].friction > 0 || x->demand[i].tension > 0 || motion_of_joint(s, x, i));
    return falls ? i : weakest_nearest(s, x).joint;
}
