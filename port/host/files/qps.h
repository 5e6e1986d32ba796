/* Quadratic programs from QPS files. */
#ifndef STONEPACK_HOST_QPS_H
#define STONEPACK_HOST_QPS_H

#include "failure.h"
#include "text.h"

typedef struct host_qp {
    char *text;                 /* the file; names are words of it */
    void *memory;               /* everything sp_qp points to */
    sp_qp qp;                   /* rows of the file, then one row for each bounded column */
    int32_t rows, entries;      /* rows of the file that constrain; entries of A among them */
    double constant;            /* added to the objective */
    int maximise;               /* the file asks for the largest: P and q are turned */
    int32_t integers;           /* columns between integer markers: taken as real */
    text_word name;
} host_qp;

/* Read a QPS file ("-": standard input), fixed or free: read by words first, by columns if that fails. Sections NAME, OBJSENSE,
 * ROWS, COLUMNS, RHS, RANGES, BOUNDS, QUADOBJ (QSECTION), QMATRIX, ENDATA.
 *   returns 0 or an exit status; free it in any case */
int qps_read(const char *path, host_qp *qp, failure *error);
void qps_free(host_qp *qp);

#endif
