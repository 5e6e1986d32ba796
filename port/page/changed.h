/* A scene that was read, and the same with stones moved, taken out or held, other friction, tilted, pushed. */
#ifndef STONEPACK_PAGE_CHANGED_H
#define STONEPACK_PAGE_CHANGED_H

#include "../host/files/scene.h"

/* A force on one stone, at a point where the stone is now. */
typedef struct changed_push {
    int32_t block;              /* its number in the scene as read; -1: none */
    sp_real force[3], point[3]; /* [N], [m] */
} changed_push;

/* Blocks are counted as read, in `now` those that are left, in the same order. */
typedef struct changed {
    const host_scene *read;     /* as read; outlives this */
    sp_real (*move)[3];         /* [m] of each block */
    int32_t *out;               /* 1: taken out */
    uint32_t *fixed;            /* directions held, as sp_block.fixed */
    double mu;                  /* of every joint; below 0: its own */
    double tilt, azimuth;       /* [degree] gravity is turned as `check --tilt` does */
    changed_push push;
    host_scene now;             /* what all that comes to; names and remarks are those of `read` */
    int32_t *number;            /* of each block as read its number in `now`, -1: taken out */
    sp_real *own_mu;            /* of each joint of `now` */
    int32_t loads;              /* of `now` without the push */
} changed;

/* Nothing changed yet.     returns 0 or an exit status; changed_free in every case */
int changed_open(changed *c, const host_scene *read, failure *error);

/* After stones were moved, taken out, put back, held or let go: build `now`. What touches a stone that was moved is found anew,
 * all other contacts stay as they were given, or are found.     returns 0 or an exit status, and then `now` has no blocks */
int changed_build(changed *c, failure *error);

/* After friction, tilt or push changed, and after changed_build. */
void changed_apply(changed *c);

void changed_free(changed *c);

#endif
