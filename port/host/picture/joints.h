/* Joints over the blocks: the weakest one, and those that a mechanism uses. */
#ifndef STONEPACK_HOST_JOINTS_H
#define STONEPACK_HOST_JOINTS_H

#include "drawing.h"

/* Radius of the ring [px] round the weakest joint if it is small on paper, else 0; its middle there. */
double joints_ring(const drawing *d, const sp_joint *weakest, double middle[2]);

/* The weakest joint, tinted, through what is before it; -1: none. *behind: nothing of it is seen, its rim is dashed.
 *   returns 0: out of memory */
int joints_draw_weakest(const drawing *d, int32_t weakest, int *behind);

/* Joints of a mechanism: hinges as thick lines with their ends, sliding joints as tinted polygons. Counts both. */
void joints_draw_mechanism(const drawing *d, const sp_real *dq, int32_t *hinges, int32_t *slides);

#endif
