/* osqp: OSQP with QDLDL, eps, up to 100,000 iterations; eps_prim_inf 10 eps. Pyramids only. Needs osqp.h and libosqpstatic.a.
 *                                                                                              [Stellato et al. 2020] */
#include <osqp.h>

#define PEER_INT OSQPInt
#include "program.h"

int peer_osqp(const peer_program *p, double eps, peer_run *run)
{
    const size_t m = (size_t)p->equations + (size_t)p->rows, n = (size_t)p->n;
    peer_matrix A, P;
    const int has_A = peer_stack(&A, p->A, p->G), has_P = peer_identity(&P, p->n);
    double *l = calloc(m + 1, sizeof *l), *u = calloc(m + 1, sizeof *u), *q = calloc(n + 1, sizeof *q);
    OSQPSettings *s = OSQPSettings_new();
    const int made = has_A && has_P && l && u && q && s;
    if (made) {
        for (size_t i = 0; i < m; i++) l[i] = i < (size_t)p->equations ? (u[i] = p->b[i]) : -OSQP_INFTY;
        OSQPCscMatrix *a = OSQPCscMatrix_new((OSQPInt)m, (OSQPInt)n, A.entries, A.x, A.i, A.p);
        OSQPCscMatrix *h = OSQPCscMatrix_new((OSQPInt)n, (OSQPInt)n, P.entries, P.x, P.i, P.p);
        OSQPSolver *solver = NULL;
        s->eps_abs = s->eps_rel = eps;
        s->eps_prim_inf = 10 * eps;
        s->max_iter = 100000;
        s->time_limit = PEER_PATIENCE;
        s->verbose = 0;
        const double start = peer_clock();
        const int set = !osqp_setup(&solver, h, q, a, l, u, (OSQPInt)m, (OSQPInt)n, s);
        if (set) osqp_solve(solver);
        run->seconds = peer_clock() - start;
        const OSQPInt status = set ? solver->info->status_val : 0;
        run->solved = status == OSQP_SOLVED ? 1 : status == OSQP_PRIMAL_INFEASIBLE ? -1 : 0;
        run->iterations = set ? (int)solver->info->iter : 0;
        for (size_t j = 0; set && j < n; j++) run->x[j] = solver->solution->x[j];
        osqp_cleanup(solver);
        OSQPCscMatrix_free(a);
        OSQPCscMatrix_free(h);
    }
    peer_matrix_free(&A);
    peer_matrix_free(&P);
    OSQPSettings_free(s);
    free(l); free(u); free(q);
    return made;
}
