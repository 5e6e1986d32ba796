#include "seen.h"

#include <math.h>
#include <stdlib.h>

static seen_box paper_box(const drawing *d, int32_t block)
{
    const sp_block *of = &d->s->block[block];
    seen_box p = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };
    for (int32_t k = 0; k < of->vertices; k++) {
        double at[2];
        drawing_point(d, d->s->vertex[of->vertex + k], at);
        for (int c = 0; c < 2; c++) {
            p.low[c] = fmin(p.low[c], at[c]);
            p.high[c] = fmax(p.high[c], at[c]);
        }
    }
    return p;
}

int seen_begin(seen *v, const drawing *d)
{
    v->d = d;
    v->paper = malloc(((size_t)d->s->count.blocks + 1) * sizeof *v->paper);
    for (int32_t b = 0; v->paper && b < d->s->count.blocks; b++) v->paper[b] = paper_box(d, b);
    return v->paper != NULL;
}

void seen_end(seen *v) { free(v->paper); }

double seen_depth(const drawing *d, const sp_real x[3])
{
    return d->v.toward[0] * (double)x[0] + d->v.toward[1] * (double)x[1] + d->v.toward[2] * (double)x[2];
}

/* Is a point of the page inside a face?                                                    [crossings of a ray to the right] */
static int covers(const drawing *d, const sp_face *f, const double at[2])
{
    int inside = 0;
    for (int32_t k = 0; k < f->corners; k++) {
        double a[2], b[2];
        drawing_point(d, d->s->vertex[d->s->corner[f->corner + k]], a);
        drawing_point(d, d->s->vertex[d->s->corner[f->corner + (k + 1) % f->corners]], b);
        if ((a[1] > at[1]) != (b[1] > at[1]) && at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside;
}

/* How near a block comes to the viewer at a point of the page, -HUGE_VAL: it is not there. */
static double front_at(const drawing *d, int32_t block, const double at[2])
{
    const sp_block *of = &d->s->block[block];
    double front = -HUGE_VAL;
    for (int32_t i = of->face; i < of->face + of->faces; i++) {
        const sp_face *f = &d->s->face[i];
        const sp_real *o = d->s->vertex[d->s->corner[f->corner]];
        double n[3], from[2], toward = 0, along = 0;
        view_normal(d->s, i, n);
        for (int c = 0; c < 3; c++) toward += n[c] * d->v.toward[c];
        if (!(toward > 1e-3 * sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])) || !covers(d, f, at)) continue;
        drawing_point(d, o, from);                      /* n . (x - o) = 0 along the line of sight */
        for (int c = 0; c < 3; c++)
            along += n[c] * (d->v.right[c] * (at[0] - from[0]) - d->v.up[c] * (at[1] - from[1])) / d->scale;
        front = fmax(front, seen_depth(d, o) - along / toward);
    }
    return front;
}

/* Does no block but `own` (-1: none at all) come nearer than this depth, by more than `slack`, at a point of the page? */
static int is_free(const seen *v, int32_t own, const double at[2], double depth, double slack)
{
    for (int32_t b = 0; b < v->d->s->count.blocks; b++) {
        const seen_box *o = &v->paper[b];
        if (b == own || at[0] < o->low[0] || at[0] > o->high[0] || at[1] < o->low[1] || at[1] > o->high[1]) continue;
        if (front_at(v->d, b, at) > depth + slack) return 0;
    }
    return 1;
}

int seen_block_at(const seen *v, int32_t block, const double at[2])
{
    const double own = front_at(v->d, block, at);
    return own > -HUGE_VAL && is_free(v, block, at, own, 1e-6 * drawing_size(v->d));
}

int seen_joint(const seen *v, const sp_joint *c)
{
    const double slack = 2e-3 * drawing_size(v->d);     /* its corners lie in the faces of its blocks, but for a gap */
    for (int32_t k = 0; k < 2 * c->points; k++) {       /* corners, and middles of edges */
        const sp_real *a = v->d->s->point[c->point + k / 2], *b = v->d->s->point[c->point + (k + 1) / 2 % c->points];
        double at[2];
        sp_real x[3];
        for (int i = 0; i < 3; i++) x[i] = (a[i] + b[i]) / 2;
        drawing_point(v->d, x, at);
        if (is_free(v, -1, at, seen_depth(v->d, x), slack)) return 1;
    }
    return 0;
}

/* The k-th point tried on a face: its middle, then half-way from there to each corner. */
static void face_point(const drawing *d, const sp_face *f, int32_t k, double at[2])
{
    double corner[2];
    at[0] = at[1] = 0;
    for (int32_t i = 0; i < f->corners; i++) {
        drawing_point(d, d->s->vertex[d->s->corner[f->corner + i]], corner);
        for (int c = 0; c < 2; c++) at[c] += corner[c] / f->corners;
    }
    if (k == 0) return;
    drawing_point(d, d->s->vertex[d->s->corner[f->corner + k - 1]], corner);
    for (int c = 0; c < 2; c++) at[c] = (at[c] + corner[c]) / 2;
}

int seen_spot(const seen *v, int32_t block, const double near_to[2], double at[2])
{
    const sp_block *of = &v->d->s->block[block];
    double best = HUGE_VAL, middle[2];
    drawing_point(v->d, of->centroid, middle);
    if (seen_block_at(v, block, middle)) {
        at[0] = middle[0];
        at[1] = middle[1];
        return 1;
    }
    for (int32_t i = of->face; i < of->face + of->faces; i++)
        for (int32_t k = 0; k <= v->d->s->face[i].corners; k++) {
            double p[2];
            face_point(v->d, &v->d->s->face[i], k, p);
            const double far_off = hypot(p[0] - near_to[0], p[1] - near_to[1]);
            if (!(far_off < best) || !seen_block_at(v, block, p)) continue;
            best = far_off;
            at[0] = p[0];
            at[1] = p[1];
        }
    return best < HUGE_VAL;
}
