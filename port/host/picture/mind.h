/* Remarks below a picture. */
#ifndef STONEPACK_HOST_MIND_H
#define STONEPACK_HOST_MIND_H

#include "../files/remarks.h"

#define MIND_ROW 26.0                   /* [px] */

/* How many rows they take. */
int mind_rows(const remarks *r);

/* A row each, the first with its letters' foot at y; so many letters have room in a row. */
void mind_write(FILE *out, const remarks *r, double x, double y, size_t letters);

#endif
