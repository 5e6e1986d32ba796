/* A checked scene as a model that Rhino, Blender and others open: blocks as they stand, blocks moved, forces and thrust as
 * lines. It is a picture: its first lines say so, and the reader of scenes refuses it. */
#ifndef STONEPACK_HOST_MODEL_H
#define STONEPACK_HOST_MODEL_H

#include <stdio.h>
#include "turn.h"

/* Groups `blocks`, `moved` (where something moves: all that does), `forces`, `thrust`.      returns 1, 0: out of memory */
int model_write(FILE *out, const subject *of);

/* A block of a build order: its group tells what comes of the step. Who moves while it falls, if that is kept. */
typedef struct model_step { int32_t block; const char *group; const turn_move *move; int32_t moves; } model_step;

/* Supports and blocks that have no step first, in the group `start`; then the others in their order, each named after its step:
 * 0012_NAME. Hiding those from a number on shows that step. In the group `moved` what moves while a step falls, displaced:
 * 0012_NAME_moved, each step by itself.      returns 1, 0: out of memory */
int model_write_steps(FILE *out, const host_scene *scene, const model_step *step, int32_t steps);

#endif
