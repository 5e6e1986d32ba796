#include "names.h"
#include "page.h"
#include "seen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LETTER 6.2                      /* width of one [px] */
#define BOLD   7.4                      /* of a name that the words tell */
#define LINE   12.0                     /* height of a name [px] */
#define LONGEST 24                      /* characters shown */

typedef struct placed {
    seen view;
    seen_box *name;                     /* those drawn */
    seen_box clear;                     /* no name goes here; high is below low: nothing kept clear */
    int32_t *order;                     /* blocks, the nearest first */
    int32_t count;
} placed;

static int apart(const seen_box *a, const seen_box *b)
{
    return a->high[0] <= b->low[0] || b->high[0] <= a->low[0] || a->high[1] <= b->low[1] || b->high[1] <= a->low[1];
}

static seen_box name_box(const char *text, const char *more, double letter, const double at[2])
{
    const size_t n = strlen(text);
    const double wide = letter * (double)((n < LONGEST ? n : LONGEST + 3) + strlen(more)) + 2;
    const seen_box b = { { at[0] - wide / 2, at[1] - LINE / 2 }, { at[0] + wide / 2, at[1] + LINE / 2 } };
    return b;
}

static int is_free(const placed *p, const seen_box *b)
{
    if (!apart(&p->clear, b)) return 0;
    for (int32_t k = 0; k < p->count; k++)
        if (!apart(&p->name[k], b)) return 0;
    return 1;
}

/* A name at a point of the page; it tells of a block at `from`, to which a line leads where that is not under the name. */
static void draw_name(placed *p, FILE *out, const char *text, const char *more, const double at[2], const double *from)
{
    const seen_box b = name_box(text, more, from ? BOLD : LETTER, at);
    const int off = from && (from[0] < b.low[0] || from[0] > b.high[0] || from[1] < b.low[1] || from[1] > b.high[1]);
    p->name[p->count++] = b;
    if (off) fprintf(out, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#111\" stroke-width=\"0.8\" stroke-opacity=\"1\"/>\n",
                     from[0], from[1], fmin(fmax(from[0], b.low[0]), b.high[0]), fmin(fmax(from[1], b.low[1]), b.high[1]));
    fprintf(out, "<text class=\"name\" x=\"%.1f\" y=\"%.1f\"%s>", at[0], at[1] + 3.6, from ? " font-weight=\"bold\"" : "");
    page_text(out, text, LONGEST);
    fprintf(out, "%s</text>\n", more);
}

/* The k-th place that is tried for a name, in widths and heights of it: on the spot, then above, below, right, left of
 * it, farther each time. */
static void try_place(int k, double step[2])
{
    static const double to[4][2] = { { 0, -1 }, { 0, 1 }, { 1, 0 }, { -1, 0 } };
    const int r = (k + 3) / 4;
    for (int c = 0; c < 2; c++) step[c] = k ? to[(k - 1) % 4][c] * (c ? r : 1) : 0;
    if (k && (k - 1) % 4 > 1) step[1] = (k - 1) % 4 == 2 ? 1 - r : r - 1;
}

/* The name of a block that the words tell of: where it is seen, else beside that, at the worst over another. */
static void draw_told(placed *p, const drawing *d, const names *n, int32_t block)
{
    enum { PLACES = 33 };
    double from[2], near_to[2], at[2];
    drawing_point(d, n->at ? n->at : d->s->block[block].centroid, near_to);
    drawing_point(d, d->s->block[block].centroid, from);
    const char *more = seen_spot(&p->view, block, near_to, from) ? "" : " (behind)";
    const seen_box first = name_box(n->text[block], more, BOLD, from);
    for (int k = 0; k <= PLACES; k++) {
        double step[2];
        try_place(k < PLACES ? k : 0, step);
        at[0] = from[0] + step[0] * (first.high[0] - first.low[0] + 2);
        at[1] = from[1] + step[1] * LINE;
        const seen_box b = name_box(n->text[block], more, BOLD, at);
        if (is_free(p, &b)) break;
    }
    draw_name(p, d->out, n->text[block], more, at, from);
}

/* The name of another block, where it fits on what is seen of it. */
static void draw_asked(placed *p, const drawing *d, const char *text, int32_t block)
{
    double at[2];
    drawing_point(d, d->s->block[block].centroid, at);
    const seen_box b = name_box(text, "", LETTER, at);
    const seen_box *o = &p->view.paper[block];
    if (b.high[0] - b.low[0] > o->high[0] - o->low[0] || b.high[1] - b.low[1] > 1.3 * (o->high[1] - o->low[1])) return;
    if (is_free(p, &b) && seen_block_at(&p->view, block, at)) draw_name(p, d->out, text, "", at, NULL);
}

/* The square that a small joint needs to be seen under its ring. */
static void keep_clear(placed *p, const drawing *d, const names *n)
{
    double at[2] = { 0, 0 };
    if (n->at) drawing_point(d, n->at, at);
    for (int i = 0; i < 2; i++) {
        p->clear.low[i] = n->at && n->clear > 0 ? at[i] - n->clear : HUGE_VAL;
        p->clear.high[i] = n->at && n->clear > 0 ? at[i] + n->clear : -HUGE_VAL;
    }
}

static const drawing *ordered;          /* what nearest_first compares in */

static int nearest_first(const void *pa, const void *pb)
{
    const int32_t a = *(const int32_t *)pa, b = *(const int32_t *)pb;
    const double x = seen_depth(ordered, ordered->s->block[a].centroid), y = seen_depth(ordered, ordered->s->block[b].centroid);
    return x > y ? -1 : x < y ? 1 : (a > b) - (a < b);
}

static void draw_names(const names *n, placed *p, const drawing *d)
{
    const int32_t blocks = d->s->count.blocks;
    for (int32_t b = 0; b < blocks; b++) p->order[b] = b;
    keep_clear(p, d, n);
    ordered = d;
    qsort(p->order, (size_t)blocks, sizeof *p->order, nearest_first);
    fputs("<g font-size=\"11\" text-anchor=\"middle\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"2.6\" stroke-"
          "opacity=\"0.8\" paint-order=\"stroke\">\n", d->out);
    for (int told = 1; told >= 0; told--)
        for (int32_t k = 0; k < blocks; k++) {
            const int32_t b = p->order[k];
            if (told != (n->told && n->told[b]) || d->s->block[b].faces == 0) continue;
            if (told) draw_told(p, d, n, b);
            else if (n->all) draw_asked(p, d, n->text[b], b);
        }
    fputs("</g>\n", d->out);
}

int names_draw(const names *n, const drawing *d, int32_t *drawn)
{
    const size_t blocks = (size_t)d->s->count.blocks + 1;
    placed p = { { d, NULL }, malloc(blocks * sizeof *p.name), { { 0, 0 }, { 0, 0 } }, malloc(blocks * sizeof *p.order), 0 };
    const int good = seen_begin(&p.view, d) && p.name && p.order;
    if (good) draw_names(n, &p, d);
    *drawn = p.count;
    seen_end(&p.view);
    free(p.name);
    free(p.order);
    return good;
}
