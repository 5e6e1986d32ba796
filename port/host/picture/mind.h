/* Remarks below a picture. */
#ifndef STONEPACK_HOST_MIND_H
#define STONEPACK_HOST_MIND_H

#include "../files/remarks.h"

#define MIND_ROW 26.0                   /* [px] */

/* How many rows they take where so many letters have room in one. */
int mind_rows(const remarks *r, size_t letters);

/* The first row with its letters' foot at y; what is longer than a row goes on in the next. */
void mind_write(FILE *out, const remarks *r, double x, double y, size_t letters);

#endif
