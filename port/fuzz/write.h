/* A scene as a file, to look at what a harness found and to ask the program about it.
 *
 *     FILE *out = fopen("found.obj", "w");
 *     sp_scene_write(&scene, out);
 *
 *     stonepack check --svg found.svg found.obj
 *
 * Needs stonepack.h and write.c, no other file. */
#ifndef STONEPACK_FUZZ_WRITE_H
#define STONEPACK_FUZZ_WRITE_H

#include <stdio.h>

#include "../../stonepack.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Write the scene in the program's form (OBJ with `#@` lines), blocks as b0 b1 ..., numbers to the last digit, all joints. It is
 * the scene that sp_check is asked about: what is live is written as much as it counts now, `body` as a share of gravity.
 *   returns   SP_OK, SP_E_UNSUPPORTED (a free block has no mesh, which the form can't say: nothing is written), SP_E_ARGUMENT
 *             (the file took it badly) */
sp_status sp_scene_write(const sp_scene *scene, FILE *out);

#ifdef __cplusplus
}
#endif

#endif
