/* How the blocks move: all of them a little way on, those that move in a colour of their own. */
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

/* A block_mark of each block: does it move? */
void mechanism_marks(const mechanism *m, const sp_scene *s, unsigned char *mark);

/* The scene with its blocks moved: vertices and centroids; freed with mechanism_free in every case.
 *   returns 0: out of memory */
int mechanism_move(const mechanism *m, const sp_scene *s, sp_scene *moved);
void mechanism_free(sp_scene *moved);

/* A moved scene, shaded; of blocks that move behind others their outlines through those.    returns 0: out of memory */
int mechanism_draw(const drawing *moved, const unsigned char *mark);

#endif
