/* The program of a check as its peers are given it: forces x in units of the largest load, three to a corner (fn ft1 ft2).
 *
 *     min 1/2 x'x     A x = b,     s = -G x  >= 0, or in cones s1 >= |(s2, s3)|                          [seed 1.2, 1.4]
 */
#ifndef BENCH_PROGRAM_H
#define BENCH_PROGRAM_H

#include "peer.h"

#include <stdlib.h>

typedef struct peer_program {
    int32_t n, equations, rows, cones;  /* unknowns; rows of A, of G; 0: all s >= 0, else rows / 3 */
    const sp_csc *A, *G;
    const double *b;
} peer_program;

/* As in peer.h. */
int peer_scs(const peer_program *p, double eps, peer_run *run);
int peer_qoco(const peer_program *p, double eps, peer_run *run);
int peer_ecos(const peer_program *p, double eps, peer_run *run);
int peer_osqp(const peer_program *p, double eps, peer_run *run);

#ifdef PEER_INT
/* A matrix by columns in the integers of the peer. */
typedef struct peer_matrix { PEER_INT *p, *i, entries; double *x; } peer_matrix;

static inline int peer_matrix_room(peer_matrix *m, size_t columns, size_t entries)
{
    m->entries = 0;
    m->p = calloc(columns + 1, sizeof *m->p);
    m->i = calloc(entries + 1, sizeof *m->i);
    m->x = calloc(entries + 1, sizeof *m->x);
    return m->p && m->i && m->x;
}

static inline void peer_matrix_free(peer_matrix *m)
{
    free(m->p);
    free(m->i);
    free(m->x);
}

static inline void peer_put(peer_matrix *m, int32_t row, double x)
{
    m->i[m->entries] = row;
    m->x[m->entries++] = x;
}

/* [A; B], B NULL: A alone */
static inline int peer_stack(peer_matrix *m, const sp_csc *A, const sp_csc *B)
{
    if (!peer_matrix_room(m, (size_t)A->cols, (size_t)A->p[A->cols] + (size_t)(B ? B->p[B->cols] : 0))) return 0;
    for (int32_t j = 0; j < A->cols; j++) {
        for (int32_t e = A->p[j]; e < A->p[j + 1]; e++) peer_put(m, A->i[e], (double)A->x[e]);
        for (int32_t e = B ? B->p[j] : 0; e < (B ? B->p[j + 1] : 0); e++) peer_put(m, A->rows + B->i[e], (double)B->x[e]);
        m->p[j + 1] = m->entries;
    }
    return 1;
}

static inline int peer_identity(peer_matrix *m, int32_t n)
{
    if (!peer_matrix_room(m, (size_t)n, (size_t)n)) return 0;
    for (int32_t j = 0; j < n; j++) {
        peer_put(m, j, 1);
        m->p[j + 1] = m->entries;
    }
    return 1;
}

/* The sizes of the cones. */
static inline PEER_INT *peer_threes(int32_t cones)
{
    PEER_INT *q = calloc((size_t)cones + 1, sizeof *q);
    for (int32_t k = 0; q && k < cones; k++) q[k] = 3;
    return q;
}
#endif

#endif
