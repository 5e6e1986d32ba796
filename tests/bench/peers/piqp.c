/* piqp: PIQP by its C interface, as it comes but for eps. Needs piqp.h and libpiqpc.    [Schwan, Jiang, Kuhn, Jones 2023] */
#include "peer.h"

#include <piqp.h>
#include <stdlib.h>

/* P, its upper triangle; equations A x = b; inequalities h_l <= G x <= h_u; bounds of columns. */
typedef struct form {
    piqp_csc P, A, G;
    piqp_float *c, *b, *low, *high, *x_low, *x_high;
    int32_t *place;                     /* of each row of the file, in A (below 0: -1 - it) or in G */
} form;

static void *room(size_t n, size_t size) { return calloc(n + 1, size); }

static int matrix(piqp_csc *m, int32_t columns, int32_t entries)
{
    m->n = columns;
    m->p = room((size_t)columns + 1, sizeof *m->p);
    m->i = room((size_t)entries, sizeof *m->i);
    m->x = room((size_t)entries, sizeof *m->x);
    return m->p && m->i && m->x;
}

static int form_make(form *f, const sp_qp *qp)
{
    const size_t n = (size_t)qp->n, m = (size_t)qp->m;
    piqp_float **const v[] = { &f->c, &f->b, &f->low, &f->high, &f->x_low, &f->x_high };
    for (int k = 0; k < 6; k++) if (!(*v[k] = room(k == 0 || k > 3 ? n : m, sizeof **v[k]))) return 0;
    f->place = room(m, sizeof *f->place);
    return f->place && matrix(&f->P, qp->n, qp->Pp ? qp->Pp[n] : 0) && matrix(&f->A, qp->n, m ? qp->Ap[n] : 0)
           && matrix(&f->G, qp->n, m ? qp->Ap[n] : 0);
}

/* Rows of the file to equations and inequalities. */
static void form_rows(form *f, const sp_qp *qp, int32_t rows)
{
    for (int32_t r = 0; r < rows; r++) {
        const int equal = !(qp->l[r] < qp->u[r]);
        f->place[r] = equal ? -1 - f->A.m : f->G.m;
        if (equal) f->b[f->A.m++] = (double)qp->l[r];
        else {
            f->low[f->G.m] = (double)qp->l[r] > -1e20 ? (double)qp->l[r] : -PIQP_INF;
            f->high[f->G.m++] = (double)qp->u[r] < 1e20 ? (double)qp->u[r] : PIQP_INF;
        }
    }
}

static void put(piqp_csc *m, int32_t row, sp_real x)
{
    m->i[m->nnz] = row;
    m->x[m->nnz++] = (double)x;
}

static void form_fill(form *f, const sp_qp *qp, int32_t rows)
{
    form_rows(f, qp, rows);
    f->P.m = qp->n;
    for (int32_t j = 0; j < qp->n; j++) {
        f->c[j] = qp->q ? (double)qp->q[j] : 0;
        f->x_low[j] = -PIQP_INF;
        f->x_high[j] = PIQP_INF;
        for (int32_t e = qp->Pp ? qp->Pp[j] : 0; e < (qp->Pp ? qp->Pp[j + 1] : 0); e++)
            if (qp->Pi[e] <= j) put(&f->P, qp->Pi[e], qp->Px[e]);
        for (int32_t e = qp->m ? qp->Ap[j] : 0; e < (qp->m ? qp->Ap[j + 1] : 0); e++) {
            const int32_t r = qp->Ai[e];
            if (r < rows && f->place[r] < 0) put(&f->A, -1 - f->place[r], qp->Ax[e]);
            else if (r < rows) put(&f->G, f->place[r], qp->Ax[e]);
            else {
                if ((double)qp->l[r] > -1e20) f->x_low[j] = (double)(qp->l[r] / qp->Ax[e]);
                if ((double)qp->u[r] < 1e20) f->x_high[j] = (double)(qp->u[r] / qp->Ax[e]);
            }
        }
        f->P.p[j + 1] = f->P.nnz;
        f->A.p[j + 1] = f->A.nnz;
        f->G.p[j + 1] = f->G.nnz;
    }
}

static void form_free(form *f)
{
    void *const all[] = { f->P.p, f->P.i, f->P.x, f->A.p, f->A.i, f->A.x, f->G.p, f->G.i, f->G.x, f->c, f->b, f->low, f->high,
                          f->x_low, f->x_high, f->place };
    for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) free(all[k]);
}

int peer_piqp(const sp_qp *qp, int32_t rows, double eps, peer_run *run)
{
    form f = { { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0, 0, 0 }, 0, 0, 0, 0, 0, 0, 0 };
    const int made = form_make(&f, qp);
    if (made) {
        form_fill(&f, qp, rows);
        piqp_data_sparse data = { qp->n, f.A.m, f.G.m, &f.P, f.c, f.A.m ? &f.A : NULL, f.A.m ? f.b : NULL, f.G.m ? &f.G : NULL,
                                  f.G.m ? f.low : NULL, f.G.m ? f.high : NULL, f.x_low, f.x_high };
        piqp_settings s;
        piqp_workspace *w = NULL;
        piqp_set_default_settings_sparse(&s);
        s.eps_abs = s.eps_rel = s.eps_duality_gap_abs = s.eps_duality_gap_rel = eps;
        const double start = peer_clock();
        piqp_setup_sparse(&w, &data, &s);
        const piqp_status status = piqp_solve(w);
        run->seconds = peer_clock() - start;
        run->solved = status == PIQP_SOLVED ? 1 : status == PIQP_PRIMAL_INFEASIBLE ? -1 : 0;
        run->iterations = w->result->info.iter;
        for (int32_t j = 0; j < qp->n; j++) run->x[j] = w->result->x[j];
        piqp_cleanup(w);
    }
    form_free(&f);
    return made;
}
