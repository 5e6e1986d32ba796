/* From where a scene is seen. */
#ifndef STONEPACK_HOST_VIEW_H
#define STONEPACK_HOST_VIEW_H

#include "../../../stonepack.h"

/* Parallel projection: paper coordinates are x . right and x . up, depth is x . toward (larger: nearer). Unit, right-handed. */
typedef struct view {
    double right[3], up[3], toward[3];
} view;

/* The view that suits a scene: from above and from the front left, the front being the longer side in plan. */
view view_choose(const sp_scene *s);

/* Length of a vector. */
double view_length(const sp_real a[3]);

void view_point(const view *v, const sp_real x[3], double paper[2]);

/* Normal of a face of the scene, twice its area long.                                                          [Newell] */
void view_normal(const sp_scene *s, int32_t face, double n[3]);

#endif
