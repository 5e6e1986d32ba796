/* qoco: QOCO, as it comes but for eps. It has no word for programs without a solution. Needs qoco.h and libqocostatic.a.
 *                                                                                        [Chari, Acikmese 2025] */
#include <qoco.h>

#define PEER_INT QOCOInt
#include "program.h"

int peer_qoco(const peer_program *p, double eps, peer_run *run)
{
    const size_t n = (size_t)p->n;
    peer_matrix A, G, P;
    const int has_A = peer_stack(&A, p->A, NULL), has_G = peer_stack(&G, p->G, NULL), has_P = peer_identity(&P, p->n);
    double *b = calloc((size_t)p->equations + 1, sizeof *b), *c = calloc(n + 1, sizeof *c);
    double *h = calloc((size_t)p->rows + 1, sizeof *h);
    QOCOInt *q = peer_threes(p->cones);
    QOCOSolver *solver = calloc(1, sizeof *solver);
    const int made = has_A && has_G && has_P && b && c && h && q && solver;
    if (made) {
        for (int32_t i = 0; i < p->equations; i++) b[i] = p->b[i];
        QOCOCscMatrix a, g, o;
        QOCOSettings s;
        qoco_set_csc(&a, p->equations, p->n, A.entries, A.x, A.p, A.i);
        qoco_set_csc(&g, p->rows, p->n, G.entries, G.x, G.p, G.i);
        qoco_set_csc(&o, p->n, p->n, P.entries, P.x, P.p, P.i);
        set_default_settings(&s);
        s.abstol = s.reltol = eps;
        s.verbose = 0;
        const double start = peer_clock();
        const int set = qoco_setup(solver, p->n, p->rows, p->equations, &o, c, &a, b, &g, h, p->cones ? 0 : p->rows, p->cones,
                                   q, &s) == QOCO_NO_ERROR;
        if (set) qoco_solve(solver);
        run->seconds = peer_clock() - start;
        run->solved = set && (solver->sol->status == QOCO_SOLVED || solver->sol->status == QOCO_SOLVED_INACCURATE);
        run->iterations = set ? (int)solver->sol->iters : 0;
        for (size_t j = 0; set && j < n; j++) run->x[j] = solver->sol->x[j];
        if (set) qoco_cleanup(solver);
        solver = NULL;
    }
    peer_matrix_free(&A);
    peer_matrix_free(&G);
    peer_matrix_free(&P);
    free(b); free(c); free(h); free(q); free(solver);
    return made;
}
