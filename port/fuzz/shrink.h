/* The smallest scene that still shows a fault: what a failing property should print.
 *
 *     static int still(void *user, const sp_scene *scene) { ... return 1 where it fails yet ... }
 *     sp_scene_shrink(&scene, still, NULL, &arena, scratch, &small);
 *
 * Needs stonepack.h and shrink.c, no other file. */
#ifndef STONEPACK_FUZZ_SHRINK_H
#define STONEPACK_FUZZ_SHRINK_H

#include "../../stonepack.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Part of a scene, to the bit: blocks, joints and loads whose mark is 1; joints and loads of what is left out are left out.
 *   block, joint, load   count.blocks, count.joints, count.loads marks, 0 or 1; NULL: all
 *   returns              SP_OK, SP_E_MEMORY */
sp_status sp_scene_part(const sp_scene *scene, const uint8_t *block, const uint8_t *joint, const uint8_t *load, sp_arena *arena,
                        sp_scene *part);

/* Whether a scene still shows it; != 0: it does. The scene lives in the arena that sp_scene_shrink was given, of which it may
 * use nothing. */
typedef int (*sp_scene_shows)(void *user, const sp_scene *scene);

/* Leave out blocks, then loads, then joints, in halves, quarters ... one by one, as long as `shows` says yes, until no single
 * one can be left out [Zeller & Hildebrandt 2002, "Simplifying and isolating failure-inducing input"].
 *   scratch   blocks + joints + loads bytes
 *   returns   SP_OK, SP_E_ARGUMENT (the whole scene does not show it), SP_E_MEMORY */
sp_status sp_scene_shrink(const sp_scene *scene, sp_scene_shows shows, void *user, sp_arena *arena, sp_arena scratch,
                          sp_scene *small);

#ifdef __cplusplus
}
#endif

#endif
