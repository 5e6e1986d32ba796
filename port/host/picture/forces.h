/* The forces of the joints as arrows, each on the block that it holds up. */
#ifndef STONEPACK_HOST_FORCES_H
#define STONEPACK_HOST_FORCES_H

#include "drawing.h"

typedef struct forces {
    const sp_result *result;
    double largest;                     /* of a joint [N]; 0: there is none */
    double scale;                       /* length of an arrow per force [m/N] */
} forces;

/* Arrows of which the largest is so long [m], covered by d. */
void forces_scale(forces *f, drawing *d, const sp_result *result, double length);

/* The force of a joint on the block it holds up: the one it pushes against gravity.    returns 0: there is none */
int forces_arrow(const forces *f, const sp_scene *s, int32_t joint, sp_real from[3], sp_real to[3], double *size);

/* Draw them: far ones first and, where `fade` asks for it, fainter.                        returns 0: out of memory */
int forces_draw(const forces *f, const drawing *d, int fade);

#endif
