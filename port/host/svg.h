/* A picture of a checked scene. */
#ifndef STONEPACK_HOST_SVG_H
#define STONEPACK_HOST_SVG_H

#include "report.h"

/* Draw the scene with its forces, its weakest joint and, where it is unstable, how it moves.  returns 1, 0: out of memory */
int svg_write(FILE *out, const report *r);

#endif
