/* The picture of a checked scene: an axonometric drawing in the painter's order, joints and forces over it, words around it. */
#ifndef STONEPACK_HOST_SVG_H
#define STONEPACK_HOST_SVG_H

#include <stdio.h>
#include "subject.h"

/* Draw the scene with its forces, its weakest joint and, where it is unstable, how it moves.  returns 1, 0: out of memory */
int svg_write(FILE *out, const subject *of);

#endif
