/* A checked scene as a model that Rhino, Blender and others open: blocks as they stand, blocks moved, forces and thrust as
 * lines. It is a picture: its first lines say so, and the reader of scenes refuses it. */
#ifndef STONEPACK_HOST_MODEL_H
#define STONEPACK_HOST_MODEL_H

#include <stdio.h>
#include "subject.h"

/* Groups `blocks`, `moved` (where something moves: all that does), `forces`, `thrust`.      returns 1, 0: out of memory */
int model_write(FILE *out, const subject *of);

#endif
