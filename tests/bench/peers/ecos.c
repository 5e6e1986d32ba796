/* ecos: ECOS, as it comes but for eps. It has no quadratic objective, so it is asked for the least sum of fn: the verdict is
 * the same. Needs ecos.h and libecos.a, with long integers (-DDLONG -DLDL_LONG).            [Domahidi, Chu, Boyd 2013] */
#include <ecos.h>

#define PEER_INT idxint
#include "program.h"

int peer_ecos(const peer_program *p, double eps, peer_run *run)
{
    const size_t n = (size_t)p->n;
    peer_matrix A, G;
    const int has_A = peer_stack(&A, p->A, NULL), has_G = peer_stack(&G, p->G, NULL);
    double *b = calloc((size_t)p->equations + 1, sizeof *b), *c = calloc(n + 1, sizeof *c);
    double *h = calloc((size_t)p->rows + 1, sizeof *h);
    idxint *q = peer_threes(p->cones);
    const int made = has_A && has_G && b && c && h && q;
    if (made) {
        for (int32_t i = 0; i < p->equations; i++) b[i] = p->b[i];
        for (size_t j = 0; j < n; j += 3) c[j] = 1;
        const double start = peer_clock();
        pwork *w = ECOS_setup(p->n, p->rows, p->equations, p->cones ? 0 : p->rows, p->cones, q, 0, G.x, G.p, G.i, A.x, A.p, A.i,
                              c, h, b);
        idxint status = ECOS_FATAL;
        if (w) {
            w->stgs->feastol = w->stgs->abstol = w->stgs->reltol = eps;
            w->stgs->verbose = 0;
            status = ECOS_solve(w);
        }
        run->seconds = peer_clock() - start;
        run->solved = status == ECOS_OPTIMAL ? 1 : status == ECOS_PINF ? -1 : 0;
        run->iterations = w ? (int)w->info->iter : 0;
        for (size_t j = 0; w && j < n; j++) run->x[j] = w->x[j];
        if (w) ECOS_cleanup(w, 0);
    }
    peer_matrix_free(&A);
    peer_matrix_free(&G);
    free(b); free(c); free(h); free(q);
    return made;
}
