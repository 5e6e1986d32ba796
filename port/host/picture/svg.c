#include "svg.h"
#include "../motion.h"
#include "../weakest.h"
#include "joints.h"
#include "names.h"
#include "scales.h"
#include "page.h"
#include "words.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TALLEST 600.0                   /* of the drawing [px] */
#define HEAD    84.0                    /* of the title */
#define FOOT    70.0                    /* of the legend of one line */
#define LINE    26.0                    /* of each more */
#define CAPTION 26.0                    /* of the picture of a motion */

/* ---------------------------------------------------------------------------------------------------------------- page */

/* Are both sides in plan several blocks long? Then joints lie behind each other. */
static int is_deep(const sp_scene *s, double block)
{
    const view_axes axes = view_level(s);
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
    for (int32_t k = 0; k < s->count.vertices; k++)
        for (int c = 0; c < 2; c++) {
            double x = 0;
            for (int i = 0; i < 3; i++) x += axes.e[c][i] * (double)s->vertex[k][i];
            low[c] = fmin(low[c], x);
            high[c] = fmax(high[c], x);
        }
    return fmin(high[0] - low[0], high[1] - low[1]) > 3 * block;
}

/* One picture, or with a motion two of one size: above each other, of what is tall side by side. The page's width, or its
 * tallest height, holds all that is covered.      out: *second, where the other one lies     returns the height of both [px] */
static double fit_page(drawing *d, double size, int two, drawing *second)
{
    double w, h, wide = PAGE_WIDTH - 2 * PAGE_MARGIN;
    if (!(d->high[0] >= d->low[0])) d->low[0] = d->low[1] = d->high[0] = d->high[1] = 0;
    w = fmax(d->high[0] - d->low[0], 1e-12 * size);
    h = fmax(d->high[1] - d->low[1], 1e-12 * size);
    const int beside = two && h > 0.8 * w;
    if (beside) wide = (wide - PAGE_MARGIN) / 2;
    d->scale = fmin(wide / w, TALLEST / h);
    if (!(d->scale < HUGE_VAL)) d->scale = 1;
    d->left = PAGE_MARGIN + (wide - d->scale * w) / 2;
    d->top = HEAD + PAGE_MARGIN / 2 + (beside ? CAPTION : 0);
    *second = *d;
    if (beside) second->left += wide + PAGE_MARGIN;
    else if (two) second->top += d->scale * h + CAPTION + 14;
    return second->top - HEAD - PAGE_MARGIN / 2 + d->scale * h;
}

/* ------------------------------------------------------------------------------------------------------------- picture */

/* A picture being drawn. */
typedef struct picture {
    drawing d, after;                   /* as it stands; how it starts to move */
    forces f;
    mechanism m;
    unsigned char *mark, *told;         /* of each block: does it move, is it named in the words of this picture? */
    int deep;
} picture;

/* Names on one picture; the words of the first tell of the weakest joint, those of the second of the fastest. */
static int draw_names(words *w, picture *p, const drawing *d, int after)
{
    int32_t fastest[MOTION_NAMED];
    const int32_t blocks = d->s->count.blocks;
    sp_real middle[3];
    const sp_joint *told = !after && w->weakest >= 0 ? &d->s->joint[w->weakest] : NULL;
    double at[2];
    const names n = { w->of->scene->name, p->told, told ? middle : NULL, told ? joints_ring(d, told, at) : 0, w->of->names };
    memset(p->told, 0, (size_t)blocks);
    if (told) p->told[told->a] = p->told[told->b] = 1;
    for (int c = 0; told && c < 3; c++) {
        middle[c] = 0;
        for (int32_t k = 0; k < told->points; k++) middle[c] += d->s->point[told->point + k][c] / (sp_real)told->points;
    }
    const int32_t moving = after ? motion_fastest(p->d.s, w->of->result, MOTION_NAMED, fastest) : 0;
    for (int k = 0; k < moving && k < MOTION_NAMED; k++) p->told[fastest[k]] = 1;
    return names_draw(&n, d, after ? &w->named[1] : &w->named[0]);
}

/* Less than half of the blocks: then they are told by their colour where they stand, too. */
static int few_move(const picture *p)
{
    int32_t moving = 0;
    for (int32_t b = 0; b < p->d.s->count.blocks; b++) moving += p->mark[b] == MARK_FALLS;
    return 2 * moving < p->d.s->count.blocks;
}

/* Blocks, then what lies over them, from the forces to the names. */
static int draw_standing(words *w, picture *p)
{
    const drawing *d = &p->d;
    faces seen;
    int good = faces_find(&seen, d) && faces_draw(&seen, d, few_move(p) ? p->mark : NULL);
    faces_free(&seen);
    if (!good) return 0;
    if (!forces_draw(&p->f, d, p->deep)) return 0;
    if (!joints_draw_weakest(d, w->weakest, &w->behind)) return 0;
    if (w->of->limit) joints_draw_mechanism(d, w->of->result->dq, &w->hinges, &w->slides);
    return draw_names(w, p, d, 0);
}

/* How it moves, in a picture of its own: both over each other can't be read. */
static int draw_moving(words *w, picture *p)
{
    sp_scene moved;
    int good;
    if (!(p->m.shift > 0)) return 1;
    good = mechanism_move(&p->m, p->d.s, &moved);
    p->after.s = &moved;
    if (good) words_motion(w, p->after.left, p->after.top - 12);
    good = good && mechanism_draw(&p->after, p->mark) && draw_names(w, p, &p->after, 1);
    mechanism_free(&moved);
    return good;
}

static int draw_page(FILE *out, const subject *of, picture *p)
{
    words w = { out, of, &p->d, &p->f, &p->m, weakest_told(p->d.s, of->result), 0, 0, 0, { 0, 0 } };
    double block, size, high;
    int good;
    block = scales_choose(&p->d, &p->f, &p->m, of->result, &size);
    mechanism_marks(&p->m, p->d.s, p->mark);
    p->deep = is_deep(p->d.s, block);
    high = HEAD + PAGE_MARGIN / 2 + fit_page(&p->d, size, p->m.shift > 0, &p->after);
    page_begin(out, floor(high + FOOT + LINE * (words_legend_lines(&w) - 1)));
    good = draw_standing(&w, p) && draw_moving(&w, p);
    words_title(&w);
    words_legend(&w, floor(high + 46));
    page_end(out);
    return good;
}

int svg_write(FILE *out, const subject *of)
{
    picture p;
    size_t blocks;
    int good;
    memset(&p, 0, sizeof p);
    p.d.out = out;
    p.d.s = &of->scene->scene;
    p.d.v = view_choose(p.d.s, &of->view);
    blocks = (size_t)p.d.s->count.blocks + 1;
    p.mark = malloc(blocks);
    p.told = malloc(blocks);
    good = p.mark && p.told && draw_page(out, of, &p);
    free(p.mark);
    free(p.told);
    return good;
}
