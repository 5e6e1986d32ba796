#include "drawing.h"

#include <math.h>

void drawing_clear(drawing *d)
{
    for (int c = 0; c < 2; c++) {
        d->low[c] = HUGE_VAL;
        d->high[c] = -HUGE_VAL;
    }
}

void drawing_cover(drawing *d, const sp_real x[3])
{
    double at[2];
    view_point(&d->v, x, at);
    for (int c = 0; c < 2; c++) {
        d->low[c] = fmin(d->low[c], at[c]);
        d->high[c] = fmax(d->high[c], at[c]);
    }
}

void drawing_point(const drawing *d, const sp_real x[3], double px[2])
{
    double at[2];
    view_point(&d->v, x, at);
    px[0] = d->left + d->scale * (at[0] - d->low[0]);
    px[1] = d->top + d->scale * (d->high[1] - at[1]);
}

double drawing_size(const drawing *d)
{
    return fmax(fmax(d->high[0] - d->low[0], d->high[1] - d->low[1]), 1e-300);
}
