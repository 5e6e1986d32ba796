/* ldl: factors of a sparse quasi-definite matrix, K = L D L' in any symmetric order.          [Vanderbei 1995; Davis 2005]
 *
 * The first `plus` unknowns have positive pivots, the others negative ones, whatever the order of elimination, so the order may
 * be chosen for fill alone (sp__order) and once for all values. Row k of L is found by following the elimination tree up from
 * the entries of column k of K. A pivot of the wrong sign is bent to +-sqrt(u); what that changes is taken back
 * by refinement against K itself.
 *
 * K is kept as its upper triangle by columns in elimination order, each diagonal entry last in its column.
 */
#ifndef SP__LDL_C
#define SP__LDL_C

#include "order.c"

#if SP__WITH_QP

#ifdef SP_REAL_FLOAT
#define SP__BEND ((sp_real)2.44140625e-4)               /* sqrt(u) */
#else
#define SP__BEND ((sp_real)1.0536712127723509e-8)
#endif

/* The entries off the diagonal, each pair (r, c), (c, r) once and in the same order at every walk. */
typedef void (*sp__entry)(void *to, int32_t r, int32_t c, sp_real x);
typedef void (*sp__walk)(const void *what, sp__entry take, void *to);

typedef struct sp__ldl {
    int32_t n, plus, entries;           /* entries: off the diagonal, one triangle */
    int32_t *perm, *inv;                /* k-th eliminated unknown, and back */
    int32_t *kp, *ki, *lp, *li;
    sp_real *kx, *lx, *d;               /* d: 1 / D */
    int32_t *parent, *mark, *path;      /* elimination tree; path also counts */
    int32_t *count;                     /* entries so far of the columns of L */
    sp_real *t, *r;
    int32_t *xadj, *adj;                /* graph, during the symbolic step only */
    int32_t bent;                       /* pivots bent at the last factorisation */
    int64_t flops, solve_flops;         /* of one factorisation, of one solve without refinement */
} sp__ldl;

static void sp__ldl_carve(sp__ldl *f, int32_t n, int32_t plus, int32_t entries, sp_arena *a)
{
    const size_t m = (size_t)n, e = (size_t)entries;
    f->n = n; f->plus = plus; f->entries = entries;
    f->perm = sp__take(a, m, sizeof *f->perm);
    f->inv = sp__take(a, m, sizeof *f->inv);
    f->kp = sp__take(a, m + 1, sizeof *f->kp);
    f->ki = sp__take(a, m + e, sizeof *f->ki);
    f->kx = sp__take(a, m + e, sizeof *f->kx);
    f->lp = sp__take(a, m + 1, sizeof *f->lp);
    f->d = sp__take(a, m, sizeof *f->d);
    f->parent = sp__take(a, m, sizeof *f->parent);
    f->mark = sp__take(a, m, sizeof *f->mark);
    f->path = sp__take(a, m, sizeof *f->path);
    f->count = sp__take(a, m, sizeof *f->count);
    f->t = sp__take(a, m, sizeof *f->t);
    f->r = sp__take(a, m, sizeof *f->r);
}

/* Memory of the symbolic step. */
static void sp__ldl_carve_graph(sp__ldl *f, sp_arena *a)
{
    f->xadj = sp__take(a, (size_t)f->n + 1, sizeof *f->xadj);
    f->adj = sp__take(a, (size_t)f->entries, 2 * sizeof *f->adj);
}

static void sp__ldl_carve_factor(sp__ldl *f, int32_t nnz, sp_arena *a)
{
    f->li = sp__take(a, (size_t)nnz, sizeof *f->li);
    f->lx = sp__take(a, (size_t)nnz, sizeof *f->lx);
}

/* An entry counts for the degree of both its unknowns. */
static void sp__ldl_degree(void *to, int32_t r, int32_t c, sp_real x)
{
    sp__ldl *f = to;
    (void)x;
    f->xadj[r + 1]++;
    f->xadj[c + 1]++;
}

/* Both unknowns of an entry list each other as neighbours. */
static void sp__ldl_edge(void *to, int32_t r, int32_t c, sp_real x)
{
    sp__ldl *f = to;
    (void)x;
    f->adj[f->xadj[r]++] = c;
    f->adj[f->xadj[c]++] = r;
}

/* An entry counts in its column of K, in elimination order. */
static void sp__ldl_column(void *to, int32_t r, int32_t c, sp_real x)
{
    sp__ldl *f = to;
    const int32_t a = f->inv[r], b = f->inv[c];
    (void)x;
    f->kp[(a < b ? b : a) + 1]++;
}

/* An entry goes to its place in K. */
static void sp__ldl_put(void *to, int32_t r, int32_t c, sp_real x)
{
    sp__ldl *f = to;
    const int32_t a = f->inv[r], b = f->inv[c], k = f->kp[a < b ? b : a]++;
    f->ki[k] = a < b ? a : b;
    f->kx[k] = x;
}

/* starts[0..n] from counts in starts[1..n], and cursors moved to the ends back to the starts. */
static void sp__ldl_sum(int32_t *p, int32_t n) { for (int32_t k = 0; k < n; k++) p[k + 1] += p[k]; }
static void sp__ldl_back(int32_t *p, int32_t n)
{
    for (int32_t k = n; k > 0; k--) p[k] = p[k - 1];
    p[0] = 0;
}

/* The graph of K by rows. */
static void sp__ldl_graph(sp__ldl *f, sp__walk walk, const void *what)
{
    memset(f->xadj, 0, ((size_t)f->n + 1) * sizeof *f->xadj);
    walk(what, sp__ldl_degree, f);
    sp__ldl_sum(f->xadj, f->n);
    walk(what, sp__ldl_edge, f);
    sp__ldl_back(f->xadj, f->n);
}

/* K in elimination order; its diagonal is set by sp__ldl_diagonal. */
static void sp__ldl_values(sp__ldl *f, sp__walk walk, const void *what)
{
    memset(f->kp, 0, ((size_t)f->n + 1) * sizeof *f->kp);
    walk(what, sp__ldl_column, f);
    for (int32_t k = 0; k < f->n; k++) f->kp[k + 1]++;
    sp__ldl_sum(f->kp, f->n);
    walk(what, sp__ldl_put, f);
    for (int32_t k = 0; k < f->n; k++) f->ki[f->kp[k]++] = k;
    sp__ldl_back(f->kp, f->n);
}

/* Elimination tree and column counts of L: lp[j + 1] counts column j.                                   [Davis 2005, fig. 4] */
static void sp__ldl_tree(sp__ldl *f)
{
    memset(f->lp, 0, ((size_t)f->n + 1) * sizeof *f->lp);
    for (int32_t k = 0; k < f->n; k++) {
        f->parent[k] = -1;
        f->mark[k] = k;
        for (int32_t q = f->kp[k]; q < f->kp[k + 1] - 1; q++)
            for (int32_t i = f->ki[q]; f->mark[i] != k; i = f->parent[i]) {
                if (f->parent[i] < 0) f->parent[i] = k;
                f->lp[i + 1]++;
                f->mark[i] = k;
            }
    }
}

/* Symbolic step: order, K, elimination tree, entries of L (-1: more than an int32 counts). Its scratch is sp__ldl_carve_graph
 * and sp__order_carve. */
SP__NOINLINE static int32_t sp__ldl_analyse(sp__ldl *f, sp__walk walk, const void *what, sp_arena scratch)
{
    sp__ldl_carve_graph(f, &scratch);
    sp__ldl_graph(f, walk, what);
    sp__order_run(f->n, f->xadj, f->adj, 0, scratch, f->mark, f->perm);
    for (int32_t k = 0; k < f->n; k++) f->inv[f->perm[k]] = k;
    sp__ldl_values(f, walk, what);
    sp__ldl_tree(f);
    int64_t nnz = 0;
    f->flops = 0;
    for (int32_t k = 0; k < f->n; k++) {
        const int64_t c = f->lp[k + 1];
        nnz += c;
        f->flops += c * (c + 2) + 1;
        if (nnz > INT32_MAX / 2) return -1;
        f->lp[k + 1] = (int32_t)nnz;
    }
    f->solve_flops = 4 * nnz + f->n;
    return (int32_t)nnz;
}

static void sp__ldl_diagonal(sp__ldl *f, int32_t unknown, sp_real x) { f->kx[f->kp[f->inv[unknown] + 1] - 1] = x; }

/* The pattern of row k of L into path[top .. n), in an order of elimination; the row of K into t. Returns top. */
static int32_t sp__ldl_row(sp__ldl *f, int32_t k)
{
    int32_t top = f->n;
    f->mark[k] = k;
    for (int32_t q = f->kp[k]; q < f->kp[k + 1] - 1; q++) {
        int32_t length = 0, i = f->ki[q];
        f->t[i] += f->kx[q];
        for (; f->mark[i] != k; i = f->parent[i]) { f->path[length++] = i; f->mark[i] = k; }
        while (length > 0) f->path[--top] = f->path[--length];
    }
    return top;
}

/* Up-looking: row k of L solves L_(k-1) D_(k-1) l = K_(1..k-1, k), d_k = K_kk - l' D l.                 [Davis 2005, fig. 5] */
SP__NOINLINE static void sp__ldl_factor(sp__ldl *f)
{
    f->bent = 0;
    for (int32_t k = 0; k < f->n; k++) { f->t[k] = 0; f->mark[k] = -1; f->count[k] = 0; }
    for (int32_t k = 0; k < f->n; k++) {
        sp_real pivot = f->kx[f->kp[k + 1] - 1];
        for (int32_t top = sp__ldl_row(f, k); top < f->n; top++) {
            const int32_t i = f->path[top], end = f->lp[i] + f->count[i]++;
            const sp_real y = f->t[i], l = y * f->d[i];
            f->t[i] = 0;
            for (int32_t q = f->lp[i]; q < end; q++) f->t[f->li[q]] -= f->lx[q] * y;
            pivot -= l * y;
            f->li[end] = k;
            f->lx[end] = l;
        }
        const sp_real sign = f->perm[k] < f->plus ? (sp_real)1 : (sp_real)-1;
        if (!(sign * pivot > 0)) { pivot = sign * SP__BEND; f->bent++; }
        f->d[k] = (sp_real)1 / pivot;
    }
}

/* t <- (L D L')^-1 t, in elimination order. */
static void sp__ldl_inner(const sp__ldl *f, sp_real *t)
{
    for (int32_t k = 0; k < f->n; k++) {
        const sp_real s = t[k];
        for (int32_t q = f->lp[k]; q < f->lp[k + 1]; q++) t[f->li[q]] -= f->lx[q] * s;
    }
    for (int32_t k = f->n - 1; k >= 0; k--) {
        sp_real s = t[k] * f->d[k];
        for (int32_t q = f->lp[k]; q < f->lp[k + 1]; q++) s -= f->lx[q] * t[f->li[q]];
        t[k] = s;
    }
}

/* r <- b - K x, r in elimination order, b and x in the caller's. */
static void sp__ldl_residual(const sp__ldl *f, const sp_real *b, const sp_real *x, sp_real *r)
{
    for (int32_t k = 0; k < f->n; k++) r[k] = b[f->perm[k]];
    for (int32_t k = 0; k < f->n; k++) {
        const int32_t last = f->kp[k + 1] - 1;
        const sp_real xk = x[f->perm[k]];
        sp_real s = f->kx[last] * xk;
        for (int32_t q = f->kp[k]; q < last; q++) {
            s += f->kx[q] * x[f->perm[f->ki[q]]];
            r[f->ki[q]] -= f->kx[q] * xk;
        }
        r[k] -= s;
    }
}

/* x <- K^-1 b with `rounds` of refinement; x is not b. */
SP__NOINLINE static void sp__ldl_solve(const sp__ldl *f, const sp_real *b, sp_real *x, int32_t rounds)
{
    for (int32_t k = 0; k < f->n; k++) f->t[k] = b[f->perm[k]];
    sp__ldl_inner(f, f->t);
    for (int32_t k = 0; k < f->n; k++) x[f->perm[k]] = f->t[k];
    for (; rounds > 0; rounds--) {
        sp__ldl_residual(f, b, x, f->r);
        sp__ldl_inner(f, f->r);
        for (int32_t k = 0; k < f->n; k++) x[f->perm[k]] += f->r[k];
    }
}

#endif
#endif /* SP__LDL_C */
