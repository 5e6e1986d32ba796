/* What is drawn into a file: whole or not at all, as it is or as PNG. */
#ifndef STONEPACK_HOST_DRAWN_H
#define STONEPACK_HOST_DRAWN_H

#include <stdio.h>
#include "failure.h"

/* Writes it.                                                                                     returns 1, 0: out of memory */
typedef int drawn_put(FILE *out, const void *of);

/* Into a file of this name; NULL: nothing is asked for.                                   returns 0 or an exit status */
int drawn_file(const char *path, drawn_put *put, const void *of, failure *error);

/* The same of an SVG, by a rasteriser; EXIT_UNAVAILABLE: there is none. */
int drawn_png(const char *path, drawn_put *put, const void *of, failure *error);

#endif
