/* order: a fill-reducing elimination order of an undirected graph.                                [Amestoy, Davis, Duff 1996]
 *
 * Approximate minimum degree on the quotient graph. A node's list holds first its elements (cliques left by eliminated nodes),
 * then its remaining neighbours. Eliminating p makes the clique Lp = (A_p u union of L_e, e in E_p) \ p, which replaces every e
 * in E_p, and every other e whose L_e lies inside Lp. Degrees are the upper bound
 *     d_i = min(d_i, |A_i \ Lp| + sum over the other elements of |L_e \ Lp|) + |Lp \ i|.        Ties: the node that came last.
 * Where large assemblies are solved nodes also merge: those of Lp with equal lists go on as one of their weight, one that has
 * no list but p follows p at once, and those with more than 10 sqrt(n) neighbours come last. There ties may be broken in four
 * ways: of equal degrees the first or the last node of the graph goes first, Lp returns to the lists forwards or backwards.
 *
 *   n nodes, m directed edges: memory (m + 8 n) int32, (m + 11 n) where nodes merge; time near m for the graphs of assemblies.
 */
#ifndef SP__ORDER_C
#define SP__ORDER_C

#include "../base/real.c"

#if SP__WITH_LARGE || SP__WITH_QP

#define SP__ORDER_WAYS 4

typedef struct sp__order {
    int32_t n, free, room;              /* nodes; first free place and size of iw */
    int32_t *iw;                        /* all lists */
    int32_t *pe, *len, *elen;           /* start of a node's list, its length, how many of it are elements; len -1: dead */
    int32_t *degree, *head, *next, *last, *w;
#if SP__WITH_LARGE
    int way;                            /* 0: every node by itself; 1 .. SP__ORDER_WAYS: they merge, ties broken in this way */
    int32_t *weight;                    /* nodes that this one stands for; 0: it is eliminated, or another stands for it */
    int32_t *ring;                      /* the next of those that it stands for, in a ring */
    int32_t *bucket;                    /* by hash of a list, the node met last; -1 between pivots */
#endif
} sp__order;

/* 1 ----------------------------------------------------------------------------------------------------- nodes that merge */

#if SP__WITH_LARGE
static int sp__order_way(const sp__order *o) { return o->way; }
static int32_t sp__order_weight(const sp__order *o, int32_t i) { return o->way ? o->weight[i] : 1; }
static int32_t sp__order_after(const sp__order *o, int32_t i) { return o->way ? o->ring[i] : i; }

static void sp__order_carve_merging(sp__order *o, int way, sp_arena *a)
{
    const size_t m = way ? (size_t)o->n : 0;
    o->way = way;
    o->weight = sp__take(a, m, sizeof *o->weight);
    o->ring = sp__take(a, m, sizeof *o->ring);
    o->bucket = sp__take(a, m, sizeof *o->bucket);
}

/* Node i stands for itself.     returns 1: it has too many neighbours and waits to the end */
static int sp__order_start_merging(sp__order *o, int32_t i)
{
    if (!o->way) return 0;
    const int64_t degree = o->len[i];
    o->weight[i] = 1; o->ring[i] = i; o->bucket[i] = -1;
    if (degree <= 16 || degree * degree <= (int64_t)100 * o->n) return 0;
    o->weight[i] = 0; o->len[i] = -1;
    return 1;
}

/* j goes on as part of i: the ring of i takes in that of j. */
static void sp__order_merge(sp__order *o, int32_t i, int32_t j)
{
    const int32_t next = o->ring[i];
    o->ring[i] = o->ring[j];
    o->ring[j] = next;
    o->weight[i] += o->weight[j];
    o->weight[j] = 0;
    o->len[j] = -1;
}

/* Has j as many entries in its list as i, and are all of them marked, as those of i are? */
static int sp__order_same(const sp__order *o, const int32_t *stamp, int32_t mark, int32_t i, int32_t j)
{
    if (o->len[i] != o->len[j] || o->elen[i] != o->elen[j]) return 0;
    const int32_t *list = o->iw + o->pe[j];
    int32_t q = 0;
    while (q < o->len[j] && stamp[list[q]] == mark) q++;
    return q == o->len[j];
}

/* i merges into a node met before that has an equal list. Nodes with one hash are chained by `last`; next[i] is the hash. */
static void sp__order_meet(sp__order *o, int32_t i, int32_t *stamp, int32_t mark)
{
    const int32_t *list = o->iw + o->pe[i];
    uint32_t hash = 0;
    for (int32_t q = 0; q < o->len[i]; q++) { hash += (uint32_t)list[q]; stamp[list[q]] = mark; }
    o->next[i] = (int32_t)(hash % (uint32_t)o->n);
    int32_t *bucket = o->bucket + o->next[i], j = *bucket;
    while (j >= 0 && !sp__order_same(o, stamp, mark, i, j)) j = o->last[j];
    if (j >= 0) sp__order_merge(o, j, i);
    else { o->last[i] = *bucket; *bucket = i; }
}

/* In Lp: nodes without another list follow p, nodes with equal lists merge.     returns the last mark used, from `mark` on */
static int32_t sp__order_gather(sp__order *o, int32_t p, int32_t *stamp, int32_t mark)
{
    if (!o->way) return mark;
    const int32_t *L = o->iw + o->pe[p];
    for (int32_t q = 0; q < o->len[p]; q++) {
        const int32_t i = L[q];
        o->next[i] = 0;
        if (o->len[i] == 1) sp__order_merge(o, p, i);
        else if (mark < INT32_MAX / 2) sp__order_meet(o, i, stamp, ++mark);
    }
    for (int32_t q = 0; q < o->len[p]; q++) o->bucket[o->next[L[q]]] = -1;
    return mark;
}
#else
static int sp__order_way(const sp__order *o) { (void)o; return 0; }
static int32_t sp__order_weight(const sp__order *o, int32_t i) { (void)o; (void)i; return 1; }
static int32_t sp__order_after(const sp__order *o, int32_t i) { (void)o; return i; }
static void sp__order_carve_merging(sp__order *o, int way, sp_arena *a) { (void)o; (void)way; (void)a; }
static int sp__order_start_merging(sp__order *o, int32_t i) { (void)o; (void)i; return 0; }
static int32_t sp__order_gather(sp__order *o, int32_t p, int32_t *stamp, int32_t mark)
{
    (void)o; (void)p; (void)stamp;
    return mark;
}
#endif

/* 2 -------------------------------------------------------------------------------------------------------- minimum degree */

static void sp__order_carve(sp__order *o, int32_t n, int32_t edges, int way, sp_arena *a)
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
    sp__order_carve_merging(o, way, a);
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
            if (o->w[list[q]] != mark && sp__order_weight(o, list[q])) { o->w[list[q]] = mark; o->iw[to++] = list[q]; }
        if (k < o->elen[p]) o->len[e] = -1;
    }
    o->pe[p] = start;
    o->len[p] = to - start;
    o->elen[p] = -1;                                     /* p is an element now */
    o->free = to;
}

/* |Le \ Lp| for every element e next to Lp, kept in degree[e], counted down from |Le|, which next[e] holds. */
static void sp__order_outside(sp__order *o, int32_t p, int32_t *stamp, int32_t mark)
{
    for (int32_t k = 0; k < o->len[p]; k++) {
        const int32_t i = o->iw[o->pe[p] + k];
        for (int32_t q = 0; q < o->elen[i]; q++) {
            const int32_t e = o->iw[o->pe[i] + q];
            if (o->len[e] < 0) continue;
            if (stamp[e] != mark) { stamp[e] = mark; o->degree[e] = o->next[e]; }
            o->degree[e] -= sp__order_weight(o, i);
        }
    }
}

/* Rewrite the list of i, a member of Lp: live elements that reach outside Lp, then neighbours outside Lp, p in front. The
 * degree without |Lp \ i|. */
static void sp__order_update(sp__order *o, int32_t i, int32_t p, int32_t mark)
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
        if (o->w[j] == mark || !sp__order_weight(o, j)) continue;
        d += sp__order_weight(o, j);
        list[to++] = j;
    }
    list[to] = list[kept];                              /* one entry at least was p or led to p, so there is room */
    list[kept] = list[0];
    list[0] = p;
    o->elen[i] = kept + 1;
    o->len[i] = to + 1;
    if (d < o->degree[i]) o->degree[i] = d;
}

/* Lp without those that merged, degrees of the others: `left` nodes are not eliminated. Puts them back into the lists. */
static void sp__order_return(sp__order *o, int32_t p, int32_t left, int32_t *least)
{
    int32_t *L = o->iw + o->pe[p], to = 0, size = 0;
    for (int32_t q = 0; q < o->len[p]; q++) {
        const int32_t weight = sp__order_weight(o, L[q]);
        if (weight) L[to++] = L[q];
        size += weight;
    }
    o->len[p] = to;
    o->next[p] = size;
    o->free = o->pe[p] + to;
    for (int32_t q = 0; q < to; q++) {
        const int32_t i = L[sp__order_way(o) > 2 ? to - 1 - q : q];
        const int32_t rest = o->degree[i] + size < left ? o->degree[i] + size : left;
        o->degree[i] = rest - sp__order_weight(o, i);
        if (o->degree[i] < *least) *least = o->degree[i];
        sp__order_insert(o, i);
    }
}

/* Eliminate p: the lists of all that it reaches.     returns the last mark used */
static int32_t sp__order_eliminate(sp__order *o, int32_t p, int32_t *stamp, int32_t mark)
{
    sp__order_pivot(o, p, mark);
    for (int32_t q = 0; q < o->len[p]; q++) sp__order_remove(o, o->iw[o->pe[p] + q]);
    sp__order_outside(o, p, stamp, mark);
    for (int32_t q = 0; q < o->len[p]; q++) sp__order_update(o, o->iw[o->pe[p] + q], p, mark);
    return sp__order_gather(o, p, stamp, mark);
}

/* Lists and degrees of the graph.     returns how many nodes have too many neighbours: those are the last of perm */
static int32_t sp__order_start(sp__order *o, const int32_t *xadj, const int32_t *adj, int32_t *stamp, int32_t *perm)
{
    const int32_t n = o->n;
    int32_t dense = 0;
    memcpy(o->iw, adj, (size_t)xadj[n] * sizeof *adj);
    for (int32_t i = 0; i <= n; i++) o->head[i] = -1;
    for (int32_t k = 0; k < n; k++) {                    /* the last to enter a list goes first */
        const int32_t i = sp__order_way(o) % 2 || !sp__order_way(o) ? n - 1 - k : k;
        o->pe[i] = xadj[i]; o->degree[i] = o->len[i] = xadj[i + 1] - xadj[i]; o->elen[i] = 0;
        o->w[i] = stamp[i] = -1;
        if (sp__order_start_merging(o, i)) perm[n - ++dense] = i;
        else sp__order_insert(o, i);
    }
    return dense;
}

/* perm[k]: the node eliminated k-th. Graph by rows: neighbours of i are adj[xadj[i] .. xadj[i+1]), symmetric, no loops.
 * Takes its memory from `a`; the caller counted it by sp__order_carve.
 *   returns the sum over columns of L of (entries below the diagonal)^2, but of those with too many neighbours */
static int64_t sp__order_run(int32_t n, const int32_t *xadj, const int32_t *adj, int way, sp_arena a, int32_t *stamp,
                             int32_t *perm)
{
    sp__order o;
    int64_t squares = 0;
    sp__order_carve(&o, n, xadj[n], way, &a);
    const int32_t end = n - sp__order_start(&o, xadj, adj, stamp, perm);
    for (int32_t k = 0, least = 0, mark = 0; k < end; mark++) {
        while (o.head[least] < 0) least++;
        const int32_t p = o.head[least], from = k;
        sp__order_remove(&o, p);
        if (o.room - o.free < n - k) sp__order_compact(&o);
        mark = sp__order_eliminate(&o, p, stamp, mark);
        perm[k++] = p;
        for (int32_t i = sp__order_after(&o, p); i != p; i = sp__order_after(&o, i)) perm[k++] = i;
        sp__order_return(&o, p, end - k, &least);
        for (int32_t c = o.next[p]; c < o.next[p] + k - from; c++) squares += (int64_t)c * c;
    }
    return squares;
}

#endif
#endif /* SP__ORDER_C */
