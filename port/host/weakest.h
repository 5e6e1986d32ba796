/* The joint nearest to its limit, where it is near enough to be told of. */
#ifndef STONEPACK_HOST_WEAKEST_H
#define STONEPACK_HOST_WEAKEST_H

#include "../../stonepack.h"

/* The joint that lacks most, else the one that opens or slides fastest, else the one that uses most of its friction; -1: none
 * is near its limit. */
int32_t weakest_told(const sp_scene *scene, const sp_result *result);

#endif
