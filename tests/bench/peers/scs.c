/* scs: SCS with its direct solver, as it comes but for eps. Needs scs.h and libscsdir.a.                   [O'Donoghue 2021] */
#include <scs.h>

#define PEER_INT scs_int
#include "program.h"

int peer_scs(const peer_program *p, double eps, peer_run *run)
{
    const size_t m = (size_t)p->equations + (size_t)p->rows, n = (size_t)p->n;
    peer_matrix A, P;
    const int has_A = peer_stack(&A, p->A, p->G), has_P = peer_identity(&P, p->n);
    double *b = calloc(m + 1, sizeof *b), *c = calloc(n + 1, sizeof *c), *y = calloc(2 * m + 1, sizeof *y);
    scs_int *q = peer_threes(p->cones);
    const int made = has_A && has_P && b && c && y && q;
    if (made) {
        for (int32_t i = 0; i < p->equations; i++) b[i] = p->b[i];
        ScsMatrix a = { A.x, A.i, A.p, (scs_int)m, (scs_int)n }, h = { P.x, P.i, P.p, (scs_int)n, (scs_int)n };
        ScsData data = { (scs_int)m, (scs_int)n, &a, &h, b, c };
        ScsCone cone = { 0 };
        ScsSettings s;
        ScsInfo info;
        ScsSolution x = { run->x, y, y + m };
        cone.z = p->equations;
        cone.l = p->cones ? 0 : p->rows;
        cone.q = q;
        cone.qsize = p->cones;
        scs_set_default_settings(&s);
        s.eps_abs = s.eps_rel = eps;
        s.verbose = 0;
        s.time_limit_secs = PEER_PATIENCE;
        const double start = peer_clock();
        const scs_int status = scs(&data, &cone, &s, &x, &info);
        run->seconds = peer_clock() - start;
        run->solved = status == SCS_SOLVED ? 1 : status == SCS_INFEASIBLE ? -1 : 0;
        run->iterations = (int)info.iter;
    }
    peer_matrix_free(&A);
    peer_matrix_free(&P);
    free(b); free(c); free(y); free(q);
    return made;
}
