#include "scales.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

double scales_blocks(const sp_scene *s, double *size)
{
    drawing d;
    memset(&d, 0, sizeof d);
    d.s = s;
    d.v = view_choose(s, NULL);
    drawing_clear(&d);
    for (int32_t k = 0; k < s->count.vertices; k++) drawing_cover(&d, s->vertex[k]);
    *size = drawing_size(&d);
    return median_block(s, *size);
}

double scales_way(double block, double size) { return fmin(fmax(block / 3, 0.04 * size), 0.12 * size); }

double scales_choose(drawing *d, forces *f, mechanism *m, const sp_result *result, double *size_of_all)
{
    double size, block;
    drawing_clear(d);
    for (int32_t k = 0; k < d->s->count.vertices; k++) drawing_cover(d, d->s->vertex[k]);
    for (int32_t k = 0; k < d->s->count.points; k++) drawing_cover(d, d->s->point[k]);
    size = drawing_size(d);
    block = median_block(d->s, size);
    forces_scale(f, d, result, fmin(fmax(0.75 * block, (d->s->count.joints > FORCES_MANY ? 0.03 : 0.05) * size), 0.2 * size));
    mechanism_scale(m, d, result, size, scales_way(block, size));
    *size_of_all = size;
    return block;
}
