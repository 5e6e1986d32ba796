/* What looks mistaken in a scene: sizes, weights and directions that no one builds. */
#ifndef STONEPACK_HOST_SUSPECTS_H
#define STONEPACK_HOST_SUSPECTS_H

#include "remarks.h"
#include "units.h"

/* What is known of where the numbers come from; it keeps remarks away, or makes their option fit. */
typedef struct suspects_known {
    units_length unit;          /* as told, over 0: not */
    int down;                   /* which way is down is told */
    int joints;                 /* so are the joints: none was found */
} suspects_known;

/* Add a remark for each kind of mistake. name: of each block. */
void suspects_find(const sp_scene *scene, const char *const *name, suspects_known known, remarks *r);

#endif
