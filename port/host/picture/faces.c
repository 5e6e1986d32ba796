#include "faces.h"
#include "hidden.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* ------------------------------------------------------------------------------------------------------------ creases */

static int compare_edges(const void *pa, const void *pb)
{
    const face_edge *a = pa, *b = pb;
    if (a->low != b->low) return a->low < b->low ? -1 : 1;
    if (a->high != b->high) return a->high < b->high ? -1 : 1;
    return (a->face > b->face) - (a->face < b->face);
}

static face_edge edge_after(const sp_scene *s, int32_t face, int32_t k)
{
    const sp_face *f = &s->face[face];
    const int32_t a = s->corner[f->corner + k], b = s->corner[f->corner + (k + 1) % f->corners];
    const face_edge e = { a < b ? a : b, a < b ? b : a, face };
    return e;
}

int32_t faces_across(const faces *f, const sp_scene *s, int32_t face, int32_t k)
{
    const face_edge e = edge_after(s, face, k);
    const face_edge first = { e.low, e.high, -1 };
    int32_t low = 0, high = f->edges, n = 0;
    while (low < high) {
        const int32_t middle = low + (high - low) / 2;
        if (compare_edges(&f->edge[middle], &first) < 0) low = middle + 1;
        else high = middle;
    }
    while (low + n < f->edges && f->edge[low + n].low == e.low && f->edge[low + n].high == e.high) n++;
    if (n != 2) return -1;
    return f->edge[low].face == e.face ? f->edge[low + 1].face : f->edge[low].face;
}

/* Faces bend at an edge by more than 10 degrees, or there is no other face; it is drawn, too, if the other looks away. */
static void mark_edge(faces *f, const drawing *d, int32_t face, int32_t k)
{
    const int32_t other = faces_across(f, d->s, face, k), at = d->s->face[face].corner + k;
    double a[3], b[3];
    f->bend[at] = f->crease[at] = 1;
    if (other < 0) return;
    view_normal(d->s, face, a);
    view_normal(d->s, other, b);
    f->bend[at] = dot(a, b) < 0.985 * sqrt(dot(a, a) * dot(b, b));
    f->crease[at] = f->bend[at] || dot(b, d->v.toward) <= 0;
}

int faces_find(faces *f, const drawing *d)
{
    const sp_scene *s = d->s;
    memset(f, 0, sizeof *f);
    f->edge = malloc(((size_t)s->count.corners + 1) * sizeof *f->edge);
    f->crease = malloc((size_t)s->count.corners + 1);
    f->bend = malloc((size_t)s->count.corners + 1);
    if (!f->edge || !f->crease || !f->bend) return 0;
    for (int32_t i = 0; i < s->count.faces; i++)
        for (int32_t k = 0; k < s->face[i].corners; k++) f->edge[f->edges++] = edge_after(s, i, k);
    qsort(f->edge, (size_t)f->edges, sizeof *f->edge, compare_edges);
    for (int32_t i = 0; i < s->count.faces; i++)
        for (int32_t k = 0; k < s->face[i].corners; k++) mark_edge(f, d, i, k);
    return 1;
}

void faces_free(faces *f)
{
    free(f->edge);
    free(f->crease);
    free(f->bend);
}

/* -------------------------------------------------------------------------------------------------------------- shading */

static int32_t block_of_face(const sp_scene *s, int32_t face)
{
    int32_t low = 0, high = s->count.blocks - 1;
    while (low < high) {                                /* the last block whose faces begin at or before this one */
        const int32_t middle = low + (high - low + 1) / 2;
        if (s->block[middle].face <= face) low = middle;
        else high = middle - 1;
    }
    return low;
}

static const double color_mark[5][3] = {                /* by block_mark */
    { 226, 213, 190 }, { 226, 213, 190 }, { 168, 200, 232 }, { 246, 190, 90 }, { 226, 140, 128 } };

void faces_color(block_mark mark, int rgb[3])
{
    for (int c = 0; c < 3; c++) rgb[c] = (int)color_mark[mark][c];
}

/* Lambert's law with a light from the upper left, a little of the block's own tint. */
static void shade(const drawing *d, int32_t face, int32_t block, block_mark mark, int rgb[3])
{
    static const double support[3] = { 158, 166, 174 };
    const double *stone = color_mark[mark];
    double n[3], light[3], bright, tint;
    const uint32_t hash = ((uint32_t)block + 1) * 2654435761u;

    for (int c = 0; c < 3; c++) light[c] = 0.55 * d->v.up[c] + 0.75 * d->v.toward[c] - 0.25 * d->v.right[c];
    view_normal(d->s, face, n);
    bright = dot(n, light) / sqrt(fmax(dot(n, n) * dot(light, light), 1e-300));
    tint = ((hash >> 16) % 1000) / 1000.0 - 0.5;
    bright = 0.66 + 0.38 * fmax(0, bright) + 0.05 * tint;
    for (int c = 0; c < 3; c++) {
        const double base = d->s->block[block].fixed ? support[c] : stone[c];
        rgb[c] = (int)fmin(255, base * bright + (c == 0 ? 3 * tint : 0));
    }
}

static void put_outline(const drawing *d, int32_t face)
{
    const sp_face *f = &d->s->face[face];
    for (int32_t k = 0; k < f->corners; k++) {
        double at[2];
        drawing_point(d, d->s->vertex[d->s->corner[f->corner + k]], at);
        fprintf(d->out, "%s%.1f %.1f", k ? "L" : "M", at[0], at[1]);
    }
    fputs("Z", d->out);
}

/* The drawn edges of a face as runs of lines. */
static void put_creases(const faces *f, const drawing *d, int32_t face)
{
    const sp_face *of = &d->s->face[face];
    int pen = 0;
    for (int32_t k = 0; k < of->corners; k++) {
        double a[2], b[2];
        if (!f->crease[of->corner + k]) { pen = 0; continue; }
        drawing_point(d, d->s->vertex[d->s->corner[of->corner + k]], a);
        drawing_point(d, d->s->vertex[d->s->corner[of->corner + (k + 1) % of->corners]], b);
        if (!pen) fprintf(d->out, "M%.1f %.1f", a[0], a[1]);
        fprintf(d->out, "L%.1f %.1f", b[0], b[1]);
        pen = 1;
    }
}

void faces_outline(const faces *f, const drawing *d, int32_t block)
{
    const sp_block *of = &d->s->block[block];
    for (int32_t i = of->face; i < of->face + of->faces; i++) {
        double n[3];
        view_normal(d->s, i, n);
        if (dot(n, d->v.toward) > 0) put_creases(f, d, i);
    }
}

static int has_crease(const faces *f, const sp_scene *s, int32_t face)
{
    for (int32_t k = 0; k < s->face[face].corners; k++)
        if (f->crease[s->face[face].corner + k]) return 1;
    return 0;
}

/* Its fill, the hatching of a support, its creases. */
static void draw_face(const faces *f, const drawing *d, int32_t face, block_mark mark, int32_t block)
{
    int c[3];
    shade(d, face, block, mark, c);
    fprintf(d->out, "<path fill=\"#%02x%02x%02x\" stroke=\"#%02x%02x%02x\" d=\"", c[0], c[1], c[2], c[0], c[1], c[2]);
    put_outline(d, face);
    fputs("\"/>\n", d->out);
    if (d->s->block[block].fixed) {
        fputs("<path fill=\"url(#hatch)\" d=\"", d->out);
        put_outline(d, face);
        fputs("\"/>\n", d->out);
    }
    if (!has_crease(f, d->s, face)) return;
    fprintf(d->out, "<path fill=\"none\" stroke=\"#%02x%02x%02x\" d=\"", c[0] * 45 / 100, c[1] * 43 / 100, c[2] * 42 / 100);
    put_creases(f, d, face);
    fputs("\"/>\n", d->out);
}

/* Lines are thinner where faces are small on paper, or they hide them. */
static double line_width(const drawing *d, int32_t drawn)
{
    const double area = (d->high[0] - d->low[0]) * (d->high[1] - d->low[1]) * d->scale * d->scale;
    return fmin(fmax(sqrt(area / fmax(drawn, 1)) / 20, 0.4), 1);
}

int faces_draw(const faces *f, const drawing *d, const unsigned char *mark)
{
    int32_t *order;
    const int32_t n = hidden_order(d->s, &d->v, &order);
    if (n < 0) return 0;
    fprintf(d->out, "<g stroke-linejoin=\"round\" stroke-linecap=\"round\" stroke-width=\"%.2f\">\n", line_width(d, n));
    for (int32_t i = 0; i < n; i++) {
        const int32_t block = block_of_face(d->s, order[i]);
        draw_face(f, d, order[i], mark ? (block_mark)mark[block] : MARK_PLAIN, block);
    }
    fputs("</g>\n", d->out);
    free(order);
    return 1;
}
