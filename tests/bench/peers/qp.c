/* qp: quadratic programs of QPS files by sp_qp_solve and by its peers, in turn in one process, one CSV row a file and solver.
 *
 *     bench-peers [--eps X] [--runs N] FILE.qps ...
 *
 * Seconds are the least of the runs, of processor. `miss`: the largest violation of a row, relative to 1 and its bound.
 * On standard error: how many are solved (miss within 10 eps, too), and the shifted geometric mean of milliseconds, by 1 ms,
 * where what is not solved counts 3 s. */
#include "peer.h"
#include "../../../port/host/files/qps.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define UNSOLVED 3.0                    /* s */

typedef struct tally { const char *name; int files, solved; double logs; } tally;

static int ours(const sp_qp *qp, double eps, peer_run *run)
{
    sp_qp_settings s = sp_qp_default();
    sp_qp_result r;
    sp_arena a;
    size_t bytes = 0;
    s.eps_abs = s.eps_rel = (sp_real)eps;
    s.method = SP_QP_AUTO;
    s.iterations = 100000;
    const double start = peer_clock();
    const size_t scratch = sp_qp_memory_scratch(qp, &s);
    void *memory = malloc(scratch + SP_ALIGN);
    if (!memory || sp_arena_init(&a, memory, scratch + SP_ALIGN) || sp_qp_memory(qp, &s, a, &bytes)) { free(memory); return 0; }
    free(memory);
    memory = malloc(bytes + SP_ALIGN);
    const int ran = memory && !sp_arena_init(&a, memory, bytes + SP_ALIGN) && !sp_qp_solve(qp, &s, &a, NULL, NULL, &r);
    if (!ran) { free(memory); return 0; }
    run->seconds = peer_clock() - start;
    run->solved = r.status == SP_QP_SOLVED;
    run->iterations = r.iterations;
    for (int32_t j = 0; j < qp->n; j++) run->x[j] = (double)r.x[j];
    free(memory);
    return 1;
}

/* 1/2 x'Px + q'x, P by both triangles or the upper one */
static double objective(const sp_qp *qp, const double *x)
{
    double sum = 0;
    for (int32_t j = 0; j < qp->n; j++) {
        sum += qp->q ? (double)qp->q[j] * x[j] : 0;
        for (int32_t e = qp->Pp ? qp->Pp[j] : 0; e < (qp->Pp ? qp->Pp[j + 1] : 0); e++)
            if (qp->Pi[e] <= j) sum += (qp->Pi[e] < j ? 1 : 0.5) * (double)qp->Px[e] * x[j] * x[qp->Pi[e]];
    }
    return sum;
}

static double miss(const sp_qp *qp, const double *x)
{
    double most = 0, *row = calloc((size_t)qp->m + 1, sizeof *row);
    for (int32_t j = 0; row && qp->m && j < qp->n; j++)
        for (int32_t e = qp->Ap[j]; e < qp->Ap[j + 1]; e++) row[qp->Ai[e]] += (double)qp->Ax[e] * x[j];
    for (int32_t i = 0; row && i < qp->m; i++) {
        most = fmax(most, fmax((double)qp->l[i] - row[i], row[i] - (double)qp->u[i]) / (1 + fabs(row[i])));
    }
    free(row);
    return most;
}

static void told(tally *t, const host_qp *h, const char *path, const peer_run *run, double eps)
{
    const char *slash = strrchr(path, '/');
    const double off = miss(&h->qp, run->x);
    const int solved = run->solved > 0 && off <= 10 * eps;
    printf("%s,%s,%d,%d,%s,%.10g,%.1e,%d,%.4g\n", slash ? slash + 1 : path, t->name, h->qp.n, h->qp.m,
           solved ? "solved" : "not", objective(&h->qp, run->x) + h->constant, off, run->iterations, 1e3 * run->seconds);
    t->files++;
    t->solved += solved;
    t->logs += log(1 + 1e3 * (solved ? run->seconds : UNSOLVED));
}

static int file(const char *path, double eps, int runs, tally *t)
{
    host_qp h;
    failure error;
    if (qps_read(path, &h, &error)) { fprintf(stderr, "%s: not read\n", path); qps_free(&h); return 0; }
    peer_run best[2] = { { 0, 0, 1e9, NULL }, { 0, 0, 1e9, NULL } };
    for (int who = 0; who < 2; who++) if (!(best[who].x = calloc((size_t)h.qp.n + 1, sizeof(double)))) exit(1);
    for (int k = 0; k < runs; k++)
        for (int who = 0; who < 2; who++) {
            peer_run now = best[who];
            int ran = who == 0 && ours(&h.qp, eps, &now);
#ifdef WITH_PIQP
            if (who == 1) ran = peer_piqp(&h.qp, h.rows, eps, &now);
#endif
            if (ran && now.seconds < best[who].seconds) best[who] = now;
        }
    for (int who = 0; who < 2; who++) {
        if (who == 0 || t[who].name) told(&t[who], &h, path, &best[who], eps);
        free(best[who].x);
    }
    fflush(stdout);
    qps_free(&h);
    return 1;
}

int main(int count, char **word)
{
    tally t[2] = { { "stonepack", 0, 0, 0 }, { NULL, 0, 0, 0 } };
    double eps = 1e-6;
    int runs = 5;
#ifdef WITH_PIQP
    t[1].name = "piqp";
#endif
    printf("file,solver,columns,rows,outcome,objective,miss,iterations,ms\n");
    for (int k = 1; k < count; k++) {
        if (!strcmp(word[k], "--eps") && k + 1 < count) eps = atof(word[++k]);
        else if (!strcmp(word[k], "--runs") && k + 1 < count) runs = atoi(word[++k]);
        else file(word[k], eps, runs, t);
    }
    for (int who = 0; who < 2; who++)
        if (t[who].files)
            fprintf(stderr, "%s: %d of %d solved, shifted geometric mean %.3f ms\n", t[who].name, t[who].solved, t[who].files,
                    exp(t[who].logs / t[who].files) - 1);
    return 0;
}
