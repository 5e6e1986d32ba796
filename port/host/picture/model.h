/* A checked scene as a model that Rhino, Blender and others open: blocks as they stand, blocks moved, forces and thrust as
 * lines. It is a picture: its first lines say so, and the reader of scenes refuses it. */
#ifndef STONEPACK_HOST_MODEL_H
#define STONEPACK_HOST_MODEL_H

#include <stdio.h>
#include "subject.h"

/* Groups `blocks`, `moved` (where something moves: all that does), `forces`, `thrust`.      returns 1, 0: out of memory */
int model_write(FILE *out, const subject *of);

/* A block of a build order: its group tells what comes of the step. */
typedef struct model_step { int32_t block; const char *group; } model_step;

/* Supports and blocks that have no step first, in the group `start`; then the others in their order, each named after its step:
 * 0012_NAME. Hiding those from a number on shows that step. */
void model_write_steps(FILE *out, const host_scene *scene, const model_step *step, int32_t steps);

#endif
