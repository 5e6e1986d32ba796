#include "sheet.h"
#include "mind.h"
#include "names.h"
#include "page.h"
#include "through.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 3, ROWS = 20 };
#define GAP     14.0                    /* [px] */
#define CAPTION 24.0                    /* height of one */
#define TOP     62.0                    /* of the first row */
#define SMALL   10.0                    /* a block is hard to find */
enum { NAMED = 4 };                     /* blocks that come or are held have their names, if not more than these */

/* A sheet being drawn. */
typedef struct sheet {
    const sp_scene *all;
    sp_scene s;                         /* its blocks that are there, at one moment: arrays of its own for blocks and faces */
    drawing d;
    view_axes axes;
    int frames;
    const sheet_frame *frame;
    const sheet_page *page;
    double width, height[ROWS];         /* of a picture; of the pictures in a row [px] */
    double lowest;                      /* height of the lowest vertex at the first moment [m] */
} sheet;

/* A block that is there, without what fell below where everything began. */
static void cover_block(sheet *t, const sheet_frame *f, int32_t b)
{
    const sp_block *of = &t->all->block[b];
    if (f->mark && f->mark[b] == MARK_ABSENT) return;
    for (int32_t k = of->vertex; k < of->vertex + of->vertices; k++)
        if (view_height(&t->axes, f->vertex[k]) >= t->lowest) drawing_cover(&t->d, f->vertex[k]);
}

/* Paper for some moments. */
static void cover_moments(sheet *t, int first, int count)
{
    drawing *d = &t->d;
    drawing_clear(d);
    for (int i = first; i < first + count; i++)
        for (int32_t b = 0; b < t->all->count.blocks; b++) cover_block(t, &t->frame[i], b);
    for (int c = 0; c < 2 && !(d->high[0] >= d->low[0]); c++) d->low[c] = d->high[c] = 0;
}

/* Only the faces of blocks that are there. */
static void leave_absent(sp_scene *s, const sp_scene *all, const unsigned char *mark)
{
    s->count.faces = 0;
    for (int32_t b = 0; b < all->count.blocks; b++) {
        const sp_block *from = &all->block[b];
        const int there = !mark || mark[b] != MARK_ABSENT;
        s->block[b] = *from;
        s->block[b].face = s->count.faces;
        s->block[b].faces = there ? from->faces : 0;
        for (int32_t f = 0; there && f < from->faces; f++) s->face[s->count.faces++] = all->face[from->face + f];
    }
}

/* Columns are as wide as the page allows, a row is as high as what it shows.             returns the height of the page [px] */
static double lay_out(sheet *t)
{
    drawing *d = &t->d;
    double bottom, total = TOP + GAP;
    t->width = (PAGE_WIDTH - 2 * PAGE_MARGIN - (COLUMNS - 1) * GAP) / COLUMNS;
    cover_moments(t, 0, t->frames);
    bottom = d->low[1];
    d->scale = (t->width - 2) / fmax(fmax(d->high[0] - d->low[0], 0.6 * (d->high[1] - d->low[1])), 1e-12 * drawing_size(d));
    d->left = (t->width - d->scale * (d->high[0] - d->low[0])) / 2;
    d->top = 1;
    for (int first = 0; first < t->frames; first += COLUMNS) {
        const int n = t->frames - first < COLUMNS ? t->frames - first : COLUMNS;
        cover_moments(t, first, n);
        t->height[first / COLUMNS] = d->scale * (d->high[1] - bottom) + 2;
        total += t->height[first / COLUMNS] + CAPTION + GAP;
    }
    cover_moments(t, 0, t->frames);
    return total;
}

/* A ring around a block that comes or must be held, where that is small on paper. */
static void draw_ring(const sheet *t, int32_t b, block_mark mark)
{
    const sp_block *of = &t->s.block[b];
    double at[2];
    int c[3];
    if ((mark != MARK_NEW && mark != MARK_HELD) || !((double)of->diameter * t->d.scale < SMALL)) return;
    faces_color(mark, c);
    drawing_point(&t->d, of->centroid, at);
    fprintf(t->d.out, "<circle class=\"ring\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.0f\" fill=\"none\" stroke=\"#%02x%02x%02x\" "
            "stroke-width=\"2\"/>\n", at[0], at[1], 0.6 * SMALL, c[0] / 2, c[1] / 2, c[2] / 2);
}

/* Names of those that come or must be held where it falls, or wherever names are asked for, and then of all that have room. */
static int draw_names(const sheet *t, const sheet_frame *f)
{
    const int32_t blocks = t->s.count.blocks;
    names n = { t->page->name, NULL, NULL, 0, t->page->names };
    unsigned char *told = calloc((size_t)blocks + 1, 1);
    int32_t drawn, some = 0;
    if (!told) return 0;
    for (int32_t b = 0; b < blocks && f->mark && (f->bad || n.all); b++)
        some += told[b] = f->mark[b] == MARK_NEW || f->mark[b] == MARK_HELD;
    n.told = some <= NAMED ? told : NULL;
    if (!n.told) some = 0;
    const int good = (!some && !n.all) || names_draw(&n, &t->d, &drawn);
    free(told);
    return good;
}

static int draw_moment(sheet *t, const sheet_frame *f, double x, double y, double h)
{
    FILE *out = t->d.out;
    faces seen;
    int good;
    t->s.vertex = f->vertex;
    leave_absent(&t->s, t->all, f->mark);
    if (f->bad)
        fprintf(out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#fbeae7\" stroke=\"%s\"/>\n",
                x - 3, y - 3, t->width + 6, h + CAPTION + 2, INK_MOTION);
    fprintf(out, "<svg x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\">\n", x, y, t->width, h);
    good = faces_find(&seen, &t->d) && faces_draw(&seen, &t->d, f->mark);
    if (good && f->mark) good = through_draw(&t->d, &seen, f->mark);
    if (good && t->page->name) good = draw_names(t, f);
    page_end(out);
    fprintf(out, "<g transform=\"translate(%.1f %.1f)\">\n", x, y);          /* whole, also where they stand out */
    for (int32_t b = 0; f->mark && b < t->s.count.blocks; b++) draw_ring(t, b, (block_mark)f->mark[b]);
    fputs("</g>\n", out);
    page_label(out, x, y + h + 16);
    page_text(out, f->caption, sizeof f->caption);
    fputs("</text>\n", out);
    faces_free(&seen);
    return good;
}

static int draw_moments(sheet *t)
{
    double y = TOP;
    for (int i = 0; i < t->frames; i++) {
        const int row = i / COLUMNS, column = i % COLUMNS;
        if (column == 0) {
            if (row) y += t->height[row - 1] + CAPTION + GAP;
            t->d.high[1] = t->d.low[1] + (t->height[row] - 2) / t->d.scale;
        }
        if (!draw_moment(t, &t->frame[i], PAGE_MARGIN + column * (t->width + GAP), y, t->height[row])) return 0;
    }
    return 1;
}

/* What the colours say. */
static void draw_legend(FILE *out)
{
    static const char *const word[5] = { NULL, NULL, "new", "to be held", "moves" };
    double x = PAGE_WIDTH - PAGE_MARGIN - 240;
    for (int k = MARK_NEW; k <= MARK_FALLS; x += k == MARK_NEW ? 66 : 106, k++) {
        int c[3];
        faces_color((block_mark)k, c);
        fprintf(out, "<rect x=\"%.0f\" y=\"29\" width=\"12\" height=\"12\" fill=\"#%02x%02x%02x\" stroke=\"#555\"/>\n", x,
                c[0], c[1], c[2]);
        page_label(out, x + 18, 40);
        fprintf(out, "%s</text>\n", word[k]);
    }
}

/* A page with everything on it; t's scene has room for all blocks and faces. */
static int draw_page(sheet *t, FILE *out)
{
    const sheet_page *p = t->page;
    double high;
    int good;
    leave_absent(&t->s, t->all, NULL);
    t->s.vertex = t->frame[t->frames - 1].vertex;
    t->d.out = out;
    t->d.s = &t->s;
    t->d.v = view_choose(&t->s, p->wish);
    t->axes = view_level(&t->s);
    t->lowest = HUGE_VAL;
    for (int32_t k = 0; k < t->all->count.vertices; k++)
        t->lowest = fmin(t->lowest, view_height(&t->axes, t->frame[0].vertex[k]));
    high = lay_out(t);
    page_begin(out, high + (p->told ? MIND_ROW * mind_rows(p->told, 124) : 0));
    fprintf(out, "<text x=\"%.0f\" y=\"40\" font-size=\"%d\" font-weight=\"bold\" fill=\"#333\">", PAGE_MARGIN,
            strlen(p->title) > 48 ? 17 : 20);
    page_text(out, p->title, 90);
    fputs("</text>\n", out);
    if (t->frame[0].mark) draw_legend(out);
    good = draw_moments(t);
    if (p->told) mind_write(out, p->told, PAGE_MARGIN, high + MIND_ROW / 2, 124);
    page_end(out);
    return good;
}

int sheet_write(FILE *out, const sp_scene *scene, int frames, const sheet_frame *frame, const sheet_page *page)
{
    sheet t;
    int good = 0;
    if (frames <= 0 || frames > ROWS * COLUMNS) return 0;
    memset(&t, 0, sizeof t);
    t.all = scene;
    t.s = *scene;
    t.frames = frames;
    t.frame = frame;
    t.page = page;
    t.s.block = malloc(((size_t)scene->count.blocks + 1) * sizeof *t.s.block);
    t.s.face = malloc(((size_t)scene->count.faces + 1) * sizeof *t.s.face);
    if (t.s.block && t.s.face) good = draw_page(&t, out);
    free(t.s.block);
    free(t.s.face);
    return good;
}
