/* The motion that a result shows: the mechanism it falls by, or the virtual motion of the coupled check. */
#ifndef STONEPACK_HOST_MOTION_H
#define STONEPACK_HOST_MOTION_H

#include "../../stonepack.h"

/* Is it the virtual one? */
int motion_is_virtual(const sp_result *result);

/* Is there any to show? Of what falls, a virtual one, or one that a picture puts into what stands: there dq is else zero. */
int motion_is_told(const sp_scene *scene, const sp_result *result);

/* Both as 6 x blocks: velocity and spin of each. */
const sp_real *motion_shown(const sp_result *result);

/* How fast block b moves in it: its fastest point relative to the largest dq (virtual: its way, in eps), 0: at rest. */
double motion_speed(const sp_scene *scene, const sp_result *result, int32_t b);
#define MOTION_STILL 1e-6       /* what moves less than this counts as at rest: rounding of what goes with a support */

/* What a joint does in the mechanism of what falls: "opens", "slides"; NULL: both blocks go together, or neither goes. */
const char *motion_of_joint(const sp_scene *scene, const sp_result *result, int32_t joint);

/* The blocks that move, the fastest first, of equal ones the first.
 *   out   block       the first `most` of them
 *   returns how many move */
int32_t motion_fastest(const sp_scene *scene, const sp_result *result, int32_t most, int32_t *block);
#define MOTION_NAMED 6          /* so many of them have their names in words and pictures */

#endif
