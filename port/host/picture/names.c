#include "names.h"
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LETTER 6.2                      /* width of one [px] */
#define LINE   12.0                     /* height of a name [px] */
#define LONGEST 24                      /* characters shown */

typedef struct box { double low[2], high[2]; } box;

typedef struct placed {
    box *paper;                         /* of each block */
    box *name;                          /* those drawn */
    int32_t *order;                     /* blocks, the nearest first */
    int32_t count;
} placed;

static int apart(const box *a, const box *b)
{
    return a->high[0] <= b->low[0] || b->high[0] <= a->low[0] || a->high[1] <= b->low[1] || b->high[1] <= a->low[1];
}

static box paper_box(const drawing *d, int32_t block)
{
    const sp_block *of = &d->s->block[block];
    box p = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };
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

static double depth_of(const drawing *d, const sp_real x[3])
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
        front = fmax(front, depth_of(d, o) - along / toward);
    }
    return front;
}

/* Does nothing stand before this block at a point of the page? */
static int is_seen(const placed *p, const drawing *d, int32_t block, const double at[2])
{
    const double own = front_at(d, block, at), tiny = 1e-6 * drawing_size(d);
    if (!(own > -HUGE_VAL)) return 0;
    for (int32_t b = 0; b < d->s->count.blocks; b++) {
        const box *o = &p->paper[b];
        if (b == block || at[0] < o->low[0] || at[0] > o->high[0] || at[1] < o->low[1] || at[1] > o->high[1]) continue;
        if (front_at(d, b, at) > own + tiny) return 0;
    }
    return 1;
}

static box name_box(const char *text, const double at[2])
{
    const size_t n = strlen(text);
    const double wide = LETTER * (double)(n < LONGEST ? n : LONGEST + 3) + 2;
    const box b = { { at[0] - wide / 2, at[1] - LINE / 2 }, { at[0] + wide / 2, at[1] + LINE / 2 } };
    return b;
}

static int is_free(const placed *p, const box *b)
{
    for (int32_t k = 0; k < p->count; k++)
        if (!apart(&p->name[k], b)) return 0;
    return 1;
}

static void draw_name(placed *p, const drawing *d, const char *text, const double at[2], int told)
{
    p->name[p->count++] = name_box(text, at);
    fprintf(d->out, "<text class=\"name\" x=\"%.1f\" y=\"%.1f\"%s>", at[0], at[1] + 3.6, told ? " font-weight=\"bold\"" : "");
    page_text(d->out, text, LONGEST);
    fputs("</text>\n", d->out);
}

/* The name of a block that the words tell of: on it, else beside it, at the worst over another. */
static void draw_told(placed *p, const drawing *d, const char *text, int32_t block)
{
    static const double step[7][2] = { { 0, 0 }, { 0, -1 }, { 0, 1 }, { 1, 0 }, { -1, 0 }, { 0, -2 }, { 0, 2 } };
    const double wide = LETTER * (double)strlen(text) + 4;
    double from[2], at[2];
    drawing_point(d, d->s->block[block].centroid, from);
    for (int k = 0; k < 7; k++) {
        at[0] = from[0] + step[k][0] * wide;
        at[1] = from[1] + step[k][1] * LINE;
        const box b = name_box(text, at);
        if (is_free(p, &b)) break;
        if (k == 6) { at[0] = from[0]; at[1] = from[1]; }
    }
    draw_name(p, d, text, at, 1);
}

/* The name of another block, where it fits on what is seen of it. */
static void draw_asked(placed *p, const drawing *d, const char *text, int32_t block)
{
    double at[2];
    drawing_point(d, d->s->block[block].centroid, at);
    const box b = name_box(text, at);
    const box *o = &p->paper[block];
    if (b.high[0] - b.low[0] > o->high[0] - o->low[0] || b.high[1] - b.low[1] > 1.3 * (o->high[1] - o->low[1])) return;
    if (is_free(p, &b) && is_seen(p, d, block, at)) draw_name(p, d, text, at, 0);
}

static const drawing *ordered;          /* what nearest_first compares in */

static int nearest_first(const void *pa, const void *pb)
{
    const int32_t a = *(const int32_t *)pa, b = *(const int32_t *)pb;
    const double x = depth_of(ordered, ordered->s->block[a].centroid), y = depth_of(ordered, ordered->s->block[b].centroid);
    return x > y ? -1 : x < y ? 1 : (a > b) - (a < b);
}

static void draw_names(const names *n, placed *p, const drawing *d)
{
    const int32_t blocks = d->s->count.blocks;
    for (int32_t b = 0; b < blocks; b++) {
        p->paper[b] = paper_box(d, b);
        p->order[b] = b;
    }
    ordered = d;
    qsort(p->order, (size_t)blocks, sizeof *p->order, nearest_first);
    fputs("<g font-size=\"11\" text-anchor=\"middle\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"2.6\" stroke-"
          "opacity=\"0.8\" paint-order=\"stroke\">\n", d->out);
    for (int told = 1; told >= 0; told--)
        for (int32_t k = 0; k < blocks; k++) {
            const int32_t b = p->order[k];
            if (told != (n->told && n->told[b]) || d->s->block[b].faces == 0) continue;
            if (told) draw_told(p, d, n->text[b], b);
            else if (n->all) draw_asked(p, d, n->text[b], b);
        }
    fputs("</g>\n", d->out);
}

int names_draw(const names *n, const drawing *d, int32_t *drawn)
{
    const size_t blocks = (size_t)d->s->count.blocks + 1;
    placed p = { malloc(blocks * sizeof *p.paper), malloc(blocks * sizeof *p.name), malloc(blocks * sizeof *p.order), 0 };
    const int good = p.paper && p.name && p.order;
    if (good) draw_names(n, &p, d);
    *drawn = p.count;
    free(p.paper);
    free(p.name);
    free(p.order);
    return good;
}
