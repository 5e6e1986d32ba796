/* The forces of the joints as arrows, each on the block that it holds up. */
#ifndef STONEPACK_HOST_FORCES_H
#define STONEPACK_HOST_FORCES_H

#include "drawing.h"

typedef struct forces {
    const sp_result *result;
    double largest;                     /* of a joint [N]; 0: there is none */
    double scale;                       /* length of an arrow per force [m/N] */
    int32_t left_out;                   /* arrows that forces_draw left out beside larger ones */
} forces;

/* Arrows of which the largest is so long [m], covered by d. */
void forces_scale(forces *f, drawing *d, const sp_result *result, double length);

/* The force of a joint on the block it holds up: the one it pushes against gravity.    returns 0: there is none */
int forces_arrow(const forces *f, const sp_scene *s, int32_t joint, sp_real from[3], sp_real to[3], double *size);

/* Draw them: far ones first and, where `fade` asks for it, fainter. Where joints are more than FORCES_MANY, of those that begin
 * within a square of FORCES_CELL pixels the largest only.                                  returns 0: out of memory */
int forces_draw(forces *f, const drawing *d, int fade);
#define FORCES_MANY 2000
#define FORCES_CELL 14.0

#endif
