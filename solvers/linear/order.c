/* order: a fill-reducing elimination order of an undirected graph.                                [Amestoy, Davis, Duff 1996]
 *
 * Minimum degree on the quotient graph. A node's list holds first its elements (cliques left by eliminated nodes), then its
 * remaining neighbours. Eliminating p makes the clique Lp = (A_p u union of L_e, e in E_p) \ p, which replaces every e in E_p.
 * Degrees are the upper bound |A_i \ Lp| + |Lp \ i| + sum over the other elements of |L_e \ Lp|. Ties: the node that came last.
 *
 *   n nodes, m directed edges: memory (m + 8 n) int32, time near m for the graphs of assemblies.
 */
#ifndef SP__ORDER_C
#define SP__ORDER_C

#include "../base/real.c"

#if SP__WITH_LARGE || SP__WITH_QP

typedef struct sp__order {
    int32_t n, free, room;              /* nodes; first free place and size of iw */
    int32_t *iw;                        /* all lists */
    int32_t *pe, *len, *elen;           /* start of a node's list, its length, how many of it are elements; len -1: dead */
    int32_t *degree, *head, *next, *last, *w;
} sp__order;

static void sp__order_carve(sp__order *o, int32_t n, int32_t edges, sp_arena *a)
{
    const size_t m = (size_t)n;
    o->n = n; o->free = edges; o->room = edges + n;
    o->iw = sp__take(a, (size_t)edges + m, sizeof *o->iw);
    o->pe = sp__take(a, m, sizeof *o->pe);
    o->len = sp__take(a, m, sizeof *o->len);
    o->elen = sp__take(a, m, sizeof *o->elen);
    o->degree = sp__take(a, m, sizeof *o->degree);
    o->head = sp__take(a, m + 1, sizeof *o->head);
    o->next = sp__take(a, m, sizeof *o->next);
    o->last = sp__take(a, m, sizeof *o->last);
    o->w = sp__take(a, m, sizeof *o->w);
}

/* Degree lists: doubly linked, newest first. */
static void sp__order_insert(sp__order *o, int32_t i)
{
    const int32_t d = o->degree[i], old = o->head[d];
    o->next[i] = old; o->last[i] = -1;
    if (old >= 0) o->last[old] = i;
    o->head[d] = i;
}

/* Takes node i out of its degree list. */
static void sp__order_remove(sp__order *o, int32_t i)
{
    if (o->next[i] >= 0) o->last[o->next[i]] = o->last[i];
    if (o->last[i] >= 0) o->next[o->last[i]] = o->next[i];
    else o->head[o->degree[i]] = o->next[i];
}

/* Close the gaps in iw: the head of each live list is swapped for a mark that names its owner. */
static void sp__order_compact(sp__order *o)
{
    for (int32_t i = 0; i < o->n; i++)
        if (o->len[i] > 0) {
            const int32_t first = o->iw[o->pe[i]];
            o->iw[o->pe[i]] = -i - 1;
            o->pe[i] = first;
        }
    int32_t to = 0;
    for (int32_t from = 0; from < o->free; ) {
        if (o->iw[from] >= 0) { from++; continue; }
        const int32_t i = -o->iw[from] - 1;
        const int32_t first = o->pe[i];
        o->pe[i] = to;
        o->iw[to++] = first;
        from++;
        for (int32_t k = 1; k < o->len[i]; k++) o->iw[to++] = o->iw[from++];
    }
    o->free = to;
}

/* Collect Lp at the end of iw; w marks its members with `mark`. The elements of p die. */
static void sp__order_pivot(sp__order *o, int32_t p, int32_t mark)
{
    const int32_t start = o->free;
    int32_t to = start;
    o->w[p] = mark;
    for (int32_t k = 0; k < o->len[p]; k++) {
        const int32_t e = o->iw[o->pe[p] + k];
        const int32_t *list = k < o->elen[p] ? o->iw + o->pe[e] : &o->iw[o->pe[p] + k];
        const int32_t count = k < o->elen[p] ? o->len[e] : 1;
        for (int32_t q = 0; q < count; q++)
            if (o->w[list[q]] != mark) { o->w[list[q]] = mark; o->iw[to++] = list[q]; }
        if (k < o->elen[p]) o->len[e] = -1;
    }
    o->pe[p] = start;
    o->len[p] = to - start;
    o->elen[p] = -1;                                     /* p is an element now */
    o->free = to;
}

/* size[e] - |Le n Lp| for every element e next to Lp, kept in degree[e] of the element, counted down from |Le|. */
static void sp__order_outside(sp__order *o, int32_t p, int32_t *stamp, int32_t mark)
{
    for (int32_t k = 0; k < o->len[p]; k++) {
        const int32_t i = o->iw[o->pe[p] + k];
        for (int32_t q = 0; q < o->elen[i]; q++) {
            const int32_t e = o->iw[o->pe[i] + q];
            if (o->len[e] < 0) continue;
            if (stamp[e] != mark) { stamp[e] = mark; o->degree[e] = o->len[e]; }
            o->degree[e]--;
        }
    }
}

/* Rewrite the list of i, a member of Lp: live elements that reach outside Lp, then neighbours outside Lp, p in front. */
static void sp__order_update(sp__order *o, int32_t i, int32_t p, int32_t mark, int32_t left)
{
    int32_t *list = o->iw + o->pe[i];
    const int32_t elements = o->elen[i], length = o->len[i];
    int32_t to = 0, d = 0;
    for (int32_t q = 0; q < elements; q++) {
        const int32_t e = list[q];
        if (o->len[e] < 0) continue;
        if (o->degree[e] == 0) { o->len[e] = -1; continue; }           /* Le inside Lp: absorbed */
        d += o->degree[e];
        list[to++] = e;
    }
    const int32_t kept = to;
    for (int32_t q = elements; q < length; q++) {
        const int32_t j = list[q];
        if (o->w[j] == mark) continue;
        d++;
        list[to++] = j;
    }
    list[to] = list[kept];                              /* one entry at least was p or led to p, so there is room */
    list[kept] = list[0];
    list[0] = p;
    o->elen[i] = kept + 1;
    o->len[i] = to + 1;
    const int32_t others = o->len[p] - 1;
    d += others;
    if (d > o->degree[i] + others) d = o->degree[i] + others;
    if (d > left) d = left;
    o->degree[i] = d;
}

/* perm[k]: the node eliminated k-th. Graph by rows: neighbours of i are adj[xadj[i] .. xadj[i+1]), symmetric, no loops.
 * Takes its memory from `a`; the caller counted it by sp__order_carve. */
static void sp__order_run(int32_t n, const int32_t *xadj, const int32_t *adj, sp_arena a, int32_t *stamp, int32_t *perm)
{
    sp__order o;
    sp__order_carve(&o, n, xadj[n], &a);
    memcpy(o.iw, adj, (size_t)xadj[n] * sizeof *adj);
    for (int32_t i = 0; i <= n; i++) o.head[i] = -1;
    for (int32_t i = 0; i < n; i++) {
        o.pe[i] = xadj[i]; o.len[i] = xadj[i + 1] - xadj[i]; o.elen[i] = 0;
        o.w[i] = stamp[i] = -1;
        o.degree[i] = o.len[i];
    }
    for (int32_t i = n - 1; i >= 0; i--) sp__order_insert(&o, i);
    int32_t least = 0;
    for (int32_t k = 0; k < n; k++) {
        while (o.head[least] < 0) least++;
        const int32_t p = o.head[least];
        sp__order_remove(&o, p);
        perm[k] = p;
        if (o.room - o.free < n - k) sp__order_compact(&o);
        sp__order_pivot(&o, p, k);
        for (int32_t q = 0; q < o.len[p]; q++) sp__order_remove(&o, o.iw[o.pe[p] + q]);
        sp__order_outside(&o, p, stamp, k);
        for (int32_t q = 0; q < o.len[p]; q++) {
            const int32_t i = o.iw[o.pe[p] + q];
            sp__order_update(&o, i, p, k, n - k - 2);
            if (o.degree[i] < least) least = o.degree[i];
            sp__order_insert(&o, i);
        }
    }
}

#endif
#endif /* SP__ORDER_C */
