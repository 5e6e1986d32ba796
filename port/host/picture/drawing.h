/* Where a scene lies on a page: a view of it, in one scale. Everything drawn is covered before the scale is chosen. */
#ifndef STONEPACK_HOST_DRAWING_H
#define STONEPACK_HOST_DRAWING_H

#include <stdio.h>
#include "view.h"

typedef struct drawing {
    FILE *out;
    const sp_scene *s;
    view v;
    double low[2], high[2];             /* of all that is covered, on paper in world lengths */
    double scale, left, top;            /* px = left + scale (x - low), top + scale (high - y) */
} drawing;

/* Nothing is covered; then all that is to be seen. */
void drawing_clear(drawing *d);
void drawing_cover(drawing *d, const sp_real x[3]);

/* Pixels of a point. */
void drawing_point(const drawing *d, const sp_real x[3], double px[2]);

/* The larger side of what is covered, above 0 [m]. */
double drawing_size(const drawing *d);

#endif
