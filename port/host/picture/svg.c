#include "svg.h"
#include "joints.h"
#include "page.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TALLEST 600.0                   /* of the drawing [px] */
#define HEAD    84.0                    /* of the title */
#define FOOT    96.0                    /* of the legend */

/* -------------------------------------------------------------------------------------------------------------- scales */

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Diameter that half of the free blocks exceed. */
static double median_block(const sp_scene *s, double size)
{
    double *d = malloc(((size_t)s->count.blocks + 1) * sizeof *d), m;
    size_t n = 0;
    if (!d) return size / 10;
    for (int32_t b = 0; b < s->count.blocks; b++)
        if (!s->block[b].fixed && s->block[b].diameter > 0) d[n++] = (double)s->block[b].diameter;
    qsort(d, n, sizeof *d, ascending);
    m = n ? d[n / 2] : size / 10;
    free(d);
    return m;
}

/* Are both sides in plan several blocks long? Then joints lie behind each other. */
static int is_deep(const sp_scene *s, double block)
{
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
    for (int32_t k = 0; k < s->count.vertices; k++)
        for (int c = 0; c < 2; c++) {
            low[c] = fmin(low[c], (double)s->vertex[k][c]);
            high[c] = fmax(high[c], (double)s->vertex[k][c]);
        }
    return fmin(high[0] - low[0], high[1] - low[1]) > 3 * block;
}

/* The page's width, or its tallest height, holds all that is covered. */
static void fit_page(drawing *d, double size)
{
    double w, h;
    if (!(d->high[0] >= d->low[0])) d->low[0] = d->low[1] = d->high[0] = d->high[1] = 0;
    w = fmax(d->high[0] - d->low[0], 1e-12 * size);
    h = fmax(d->high[1] - d->low[1], 1e-12 * size);
    d->scale = fmin((PAGE_WIDTH - 2 * PAGE_MARGIN) / w, TALLEST / h);
    if (!(d->scale < HUGE_VAL)) d->scale = 1;
    d->left = (PAGE_WIDTH - d->scale * w) / 2;
    d->top = HEAD + PAGE_MARGIN / 2;
}

/* Everything in one scale. The largest force is about as long as a block; the corner that goes farthest goes a third of a
 * block, at least 4 and at most 12 % of the scene.          returns the usual block [m] */
static double scale_all(drawing *d, forces *f, mechanism *m, const sp_result *result)
{
    double size, block;
    drawing_clear(d);
    for (int32_t k = 0; k < d->s->count.vertices; k++) drawing_cover(d, d->s->vertex[k]);
    for (int32_t k = 0; k < d->s->count.points; k++) drawing_cover(d, d->s->point[k]);
    size = drawing_size(d);
    block = median_block(d->s, size);
    forces_scale(f, d, result, fmin(fmax(0.75 * block, 0.05 * size), 0.2 * size));
    mechanism_scale(m, d, result, size, fmin(fmax(block / 3, 0.04 * size), 0.12 * size));
    fit_page(d, size);
    return block;
}

/* ------------------------------------------------------------------------------------------------------------- picture */

/* Blocks, then what lies over them, from the joints to the words.                           returns 0: out of memory */
static int draw_all(words *w, const faces *f, int deep, double legend)
{
    const drawing *d = w->d;
    if (!faces_draw(f, d, NULL)) return 0;
    joints_draw_weakest(d, w->of->result->extremes.weakest);
    if (!forces_draw(w->forces, d, deep)) return 0;
    mechanism_draw(w->motion, d, f);
    if (w->of->limit) joints_draw_mechanism(d, w->of->limit->dq, &w->hinges, &w->slides);
    words_title(w);
    words_legend(w, legend);
    return 1;
}

int svg_write(FILE *out, const subject *of)
{
    drawing d;
    forces f;
    mechanism m;
    faces seen;
    words w = { out, of, &d, &f, &m, 0, 0 };
    double block, height, foot;
    int good;

    memset(&d, 0, sizeof d);
    d.out = out;
    d.s = &of->scene->scene;
    d.v = view_choose(d.s);
    block = scale_all(&d, &f, &m, of->result);
    foot = FOOT + (m.shift > 0 ? 26 : 0);
    height = floor(d.top + d.scale * (d.high[1] - d.low[1]) + foot);
    page_begin(out, height);
    good = faces_find(&seen, &d) && draw_all(&w, &seen, is_deep(d.s, block), height - foot + 46);
    page_end(out);
    faces_free(&seen);
    return good;
}
