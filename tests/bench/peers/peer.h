/* A peer of sp_qp_solve: somebody else's solver of the same quadratic programs. */
#ifndef BENCH_PEER_H
#define BENCH_PEER_H

#include "stonepack.h"

#include <time.h>

#define PEER_PATIENCE 30.0              /* s: a peer that looks at the clock gives up */

/* What a run told: seconds of processor for setting up and solving, not for reading or turning one form into another. */
typedef struct peer_run {
    int solved, iterations;             /* solved: 1, -1: said to have no solution, 0: neither */
    double seconds;
    double *x;                          /* n, of the caller */
} peer_run;

static inline double peer_clock(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Rows from `rows` on have one entry each: bounds of a column.     returns 0: no memory */
int peer_piqp(const sp_qp *qp, int32_t rows, double eps, peer_run *run);

#endif
