/* How the blocks move: the outlines of all that move, a little way on. */
#ifndef STONEPACK_HOST_MECHANISM_H
#define STONEPACK_HOST_MECHANISM_H

#include "drawing.h"
#include "faces.h"

typedef struct mechanism {
    const sp_result *result;
    double shift;                       /* factor on dq; 0: nothing moves */
    double largest;                     /* longest way a corner goes in the drawing [m] */
} mechanism;

/* The motion that a result shows, if any, so far that the fastest corner goes about `length` [m]; covered by d, whose scene is
 * of this size [m]. */
void mechanism_scale(mechanism *m, drawing *d, const sp_result *result, double size, double length);

void mechanism_draw(const mechanism *m, const drawing *d, const faces *f);

#endif
