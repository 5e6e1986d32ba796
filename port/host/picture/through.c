#include "page.h"
#include "through.h"
#include "seen.h"

#include <stdlib.h>

enum { FEW = 8 };

static int is_marked(const drawing *d, const unsigned char *mark, int32_t b)
{
    return mark[b] >= MARK_NEW && d->s->block[b].faces > 0;
}

/* Marked blocks that are nowhere seen; *others: some are.     returns their number, where others are seen FEW + 1 at most */
static int32_t find_hidden(const drawing *d, const unsigned char *mark, const seen *look, unsigned char *hidden, int *others)
{
    int32_t n = 0;
    *others = 0;
    for (int32_t b = 0; b < d->s->count.blocks && !(*others && n > FEW); b++) {
        double at[2];
        if (!is_marked(d, mark, b)) continue;
        drawing_point(d, d->s->block[b].centroid, at);
        hidden[b] = !seen_spot(look, b, at, at);
        n += hidden[b];
        *others |= !hidden[b];
    }
    return n;
}

static void draw_outline(const drawing *d, const faces *f, int32_t b, block_mark mark)
{
    int c[3];
    faces_color(mark, c);
    if (mark == MARK_FALLS) fputs("<path stroke=\"" INK_MOTION "\" d=\"", d->out);
    else fprintf(d->out, "<path stroke=\"#%02x%02x%02x\" d=\"", c[0] / 2, c[1] / 2, c[2] / 2);
    faces_outline(f, d, b);
    fputs("\"/>\n", d->out);
}

int through_draw(const drawing *d, const faces *f, const unsigned char *mark)
{
    unsigned char *hidden = calloc((size_t)d->s->count.blocks + 1, 1);
    seen look;
    int others = 0, good = seen_begin(&look, d) && hidden;
    const int32_t n = good ? find_hidden(d, mark, &look, hidden, &others) : 0;
    if (n > 0 && (n <= FEW || !others)) {
        fputs("<g class=\"through\" fill=\"none\" stroke-width=\"1.5\" stroke-dasharray=\"3 2\">\n", d->out);
        for (int32_t b = 0; b < d->s->count.blocks; b++) if (hidden[b]) draw_outline(d, f, b, (block_mark)mark[b]);
        fputs("</g>\n", d->out);
    }
    seen_end(&look);
    free(hidden);
    return good;
}
