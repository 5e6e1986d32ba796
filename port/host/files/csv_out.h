/* A table as CSV: a line of column names, then lines of values; text quoted where it has to be, numbers that read back as the
 * same number.                                                                                      [RFC 4180] */
#ifndef STONEPACK_HOST_CSV_OUT_H
#define STONEPACK_HOST_CSV_OUT_H

#include <stdint.h>
#include <stdio.h>
#include "../../../stonepack.h"

typedef struct csv_out {
    FILE *out;
    int comma;                  /* something stands before in this line */
} csv_out;

void csv_header(csv_out *c, const char *columns);       /* "a,b,area_m2" */
void csv_text(csv_out *c, const char *s);
void csv_real(csv_out *c, sp_real x);                   /* empty where not finite */
void csv_reals(csv_out *c, const sp_real *x, int n);
void csv_int(csv_out *c, int64_t x);
void csv_names(csv_out *c, const char *const *name, const int32_t *which, int32_t n);   /* one value, ; between */
void csv_none(csv_out *c);                              /* an empty value */
void csv_end(csv_out *c);                               /* of a line */

#endif
