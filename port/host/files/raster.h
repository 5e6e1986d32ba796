/* SVG into PNG by a program that is found at run time: rsvg-convert of librsvg. */
#ifndef STONEPACK_HOST_RASTER_H
#define STONEPACK_HOST_RASTER_H

#include <stdio.h>
#include "failure.h"

/* From where svg starts into png, both open; twice the size.     returns 0, EXIT_UNAVAILABLE: no such program, EXIT_INTERNAL */
int raster_png(FILE *svg, FILE *png, const char *path, failure *error);

#endif
