/* From where a scene is seen. */
#ifndef STONEPACK_HOST_VIEW_H
#define STONEPACK_HOST_VIEW_H

#include "../../../stonepack.h"

/* Parallel projection: paper coordinates are x . right and x . up, depth is x . toward (larger: nearer). Unit, right-handed. */
typedef struct view {
    double right[3], up[3], toward[3];
} view;

/* From where to look, if not from where it suits the scene. */
typedef struct view_wish {
    int given;
    double azimuth, rise;               /* [degree] from the front to the right; above the horizon */
} view_wish;

/* Which way is up: three axes of the scene, right-handed, the last the one nearest against gravity, so that gravity points down
 * on paper whatever the axes; the first two are level, to the right and away from a viewer in front. */
typedef struct view_axes { double e[3][3]; } view_axes;

view_axes view_level(const sp_scene *s);

/* Height of a point along the axis that is up. */
double view_height(const view_axes *a, const sp_real x[3]);

/* The view that is wished, NULL or not given: the one that suits a scene, from above and from the front left, the front being
 * the longer side in plan. */
view view_choose(const sp_scene *s, const view_wish *wish);

/* Length of a vector. */
double view_length(const sp_real a[3]);

void view_point(const view *v, const sp_real x[3], double paper[2]);

/* Normal of a face of the scene, twice its area long.                                                          [Newell] */
void view_normal(const sp_scene *s, int32_t face, double n[3]);

#endif
