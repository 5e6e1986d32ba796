/* Scenes of families that builders know, by a seed, as near to their limit as is asked.
 *
 *     sp_scene_of_family(SP_FUZZ_WALL, 42, &arena, &scene);
 *     sp_scene_at(&scene, 1e-3, scratch);                 it stands, by a thousandth of what it bears
 *
 * Needs stonepack.h and families.c, no other file. */
#ifndef STONEPACK_FUZZ_FAMILIES_H
#define STONEPACK_FUZZ_FAMILIES_H

#include "../../stonepack.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sp_fuzz_family {
    SP_FUZZ_STACK,              /* 1 to 8 boxes of any size, each somewhere on the one below */
    SP_FUZZ_WALL,               /* 2 to 6 courses of 2 to 5 bricks in running bond, now and then a brick is missing */
    SP_FUZZ_RUBBLE,             /* 2 to 5 courses of any height, cut anywhere */
    SP_FUZZ_ARCH,               /* 5 to 15 voussoirs of half a circle, any thickness that is worth it */
    SP_FUZZ_FAMILIES
} sp_fuzz_family;

/* A scene of a family on a fixed ground, friction .4 to .9, contacts found; shaken sideways, in a direction of its own, by
 * scene.body of one gravity times scene.live, which is 0. The same seed makes the same scene. It lives in the arena, of which
 * 256 KiB are enough.
 *   returns   SP_OK, SP_E_ARGUMENT (no such family), SP_E_MEMORY */
sp_status sp_scene_of_family(sp_fuzz_family family, uint64_t seed, sp_arena *arena, sp_scene *scene);

/* Set scene.live to (1 - distance) times the limit of its live loads: > 0 stands, < 0 falls, by so much of the limit.
 *   scratch   as sp_memory tells for SP_FOR_LIMIT; overwritten
 *   returns   SP_OK, SP_E_UNSUPPORTED (there is no limit, or it was not found: live stays), what sp_limit returns */
sp_status sp_scene_at(sp_scene *scene, sp_real distance, sp_arena scratch);

#ifdef __cplusplus
}
#endif

#endif
