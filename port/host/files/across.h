/* Joints that reach across a block: two blocks are joined at a distance, though a third one stands between them. */
#ifndef STONEPACK_HOST_ACROSS_H
#define STONEPACK_HOST_ACROSS_H

#include "remarks.h"
#include "touching.h"

/* Of each joint a block between the two it joins, thinner than the distance, else -1.   returns 0: no memory to look */
int across_mark(const sp_scene *scene, const touching *t, int32_t *third);

/* Of joints found at a distance: how many have such a block; a remark names the first.
 *   returns how many; 0 also where there was no memory to look */
int32_t across_find(const sp_scene *scene, const touching *t, const char *const *name, remarks *r);

#endif
