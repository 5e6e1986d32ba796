/* Which faces of a scene a viewer sees first: the painter's order, decided pair by pair where two faces overlap on paper. */
#ifndef STONEPACK_HOST_HIDDEN_H
#define STONEPACK_HOST_HIDDEN_H

#include "../../../stonepack.h"

/* Parallel projection: paper coordinates are x . right and x . up, depth is x . toward (larger: nearer). Unit, right-handed. */
typedef struct view {
    double right[3], up[3], toward[3];
} view;

void view_point(const view *v, const sp_real x[3], double paper[2]);

/* Normal of a face of the scene, twice its area long.                                                          [Newell] */
void view_normal(const sp_scene *s, int32_t face, double n[3]);

/* The faces that look towards the viewer, back to front, in *order (malloc's).      returns their number, -1: out of memory */
int32_t hidden_order(const sp_scene *s, const view *v, int32_t **order);

#endif
