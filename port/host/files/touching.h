/* How near faces must be to count as touching, as options and scene files tell it; and which pairs of blocks nearly touch. */
#ifndef STONEPACK_HOST_TOUCHING_H
#define STONEPACK_HOST_TOUCHING_H

#include "../../../stonepack.h"
#include "remarks.h"
#include "text.h"

#define TOUCHING_WIDEST 1e-2            /* of the smaller block: what is farther apart does not nearly touch */

/* Nothing told: all 0. */
typedef struct touching {
    int has_distance, share, has_angle;         /* share: distance counts in diameters of the smaller block */
    sp_real distance;                           /* [m] or [1] */
    sp_real angle;                              /* [degree] */
} touching;

/* "0.0005" or "0.05%"; degrees from 0 to 30.                   returns 1, 0: another word */
int touching_read_distance(text_word w, touching *t);
int touching_read_angle(text_word w, touching *t);

/* What is told first, and for what is left open what is told second. */
touching touching_join(touching first, touching second);

/* Settings of the library. The angle, if not told, follows from a distance that is: faces may rise by 8 of it across the
 * narrower, and as far as the library's own angle. */
sp_contact_settings touching_settings(touching t);

/* Diameter of the smallest block with faces, 0: there is none. */
sp_real touching_smallest(const sp_scene *scene);

/* A scene with the meshes and loads of another and contacts of its own, found once more. */
typedef struct touching_found {
    sp_scene scene;
    sp_joint *joint;
    sp_real (*point)[3];
    int32_t overlaps;           /* pairs of blocks inside each other */
} touching_found;

/* Find all contacts of the meshes under these settings; free them with touching_free after a 1.
 *   returns 1, 0: no memory, or refused */
int touching_find(const sp_scene *scene, const sp_contact_settings *set, touching_found *found);
void touching_free(touching_found *found);

/* "touching": how near faces are that touch, the angle in degrees, null where it follows from the distance, and how many pairs
 * nearly touch; null where contacts were given (t is NULL). */
void touching_json(json_out *j, const touching *t, int32_t near);

/* Look for blocks that nearly touch, up to 1 % of the smaller block, and have no contact or not a whole one, not counting
 * contacts across a thin block; and for such as touch, but in less than the distance in use. Add remarks with the option that
 * counts them all.
 *   returns how many pairs; 0 also where there was no memory to look */
int32_t touching_near(const sp_scene *scene, const sp_contact_settings *used, remarks *r);

/* A distance of a tenth of the smallest block and more is told, as one in mm that counts as metres is. */
void touching_large(const sp_scene *scene, const touching *told, remarks *r);

/* Pairs of blocks inside each other that have no joint, deeper than a distance of 1 % could mend; a remark names the first.
 *   returns how many */
int32_t touching_inside(const sp_scene *s, const sp_overlap *overlap, int32_t overlaps, const char *const *name, remarks *r);

#endif
