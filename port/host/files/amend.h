/* What is asked of a model beside what stands in its file: which blocks are supports, where is down, how long is a unit. */
#ifndef STONEPACK_HOST_AMEND_H
#define STONEPACK_HOST_AMEND_H

#include "obj.h"
#include "remarks.h"

enum { AMEND_LISTS = 64 };

/* The options that say so; they come before what the file and the one beside it say. */
typedef struct amendments {
    const char *fixed[AMEND_LISTS];     /* as `#@ supports` */
    const char *option[AMEND_LISTS];    /* that told it, NULL: --fixed */
    int32_t lists;
    int turn;                   /* up is told */
    sp_real up[3];              /* a unit vector */
    int pull;                   /* gravity is told */
    sp_real gravity[3];         /* [m/s^2] */
    units_length unit;          /* over is 0: not told */
    touching contact;
    int split;                  /* shells that are not joined are blocks of their own */
} amendments;

/* Bring a file into metres, with gravity and supports as told. `given`: its own contacts count, so a ground would touch
 * nothing. What of it may surprise is a remark.
 *   returns    0 or an exit status: 64 where an option names no block, 65 where the file does */
int amend_file(obj_file *f, const amendments *a, int given, remarks *told, failure *error);

#endif
