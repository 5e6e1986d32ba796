/* How long forces and how far motions are drawn, beside the blocks. */
#ifndef STONEPACK_HOST_SCALES_H
#define STONEPACK_HOST_SCALES_H

#include "forces.h"
#include "mechanism.h"

/* Everything in one scale. The largest force is about as long as a block, where joints are many no longer, or they hide it all;
 * the corner that goes farthest goes a third of a block, at least 4 and at most 12 % of the scene.
 *   out: *size_of_all, of the scene on paper [m]     returns the usual block [m] */
double scales_choose(drawing *d, forces *f, mechanism *m, const sp_result *result, double *size_of_all);

/* The usual block [m], and the size of the scene as it is seen [m]. */
double scales_blocks(const sp_scene *s, double *size);

/* That way of a corner, of the usual block and the size of the scene [m]. */
double scales_way(double block, double size);

#endif
