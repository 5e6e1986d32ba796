/* lp: is there an x with  l_i <= a_i x <= u_i  for every row i and  l_j <= x_j <= u_j  for every variable j?
 *
 *   constraints    i = 0..m-1 the rows, m + j the variable x_j; a bound of +-SP__LP_FREE or beyond is none
 *   active         n independent constraints; w_k is the value that constraint active[k] has now, so x = M w, and for any
 *                  constraint i  a_i x = t . w,  t = a_i M
 *   step           the most violated constraint takes the place of an active one that may give way: t_k of the right sign and
 *                  w_k not at its bound                                               [Dutertre, de Moura 2006, CAV, LNCS 4144]
 *   no such one    a_i x = t . w is the most it can be: the multipliers 1 on i and -t on the active ones prove that there is
 *                  no x [Farkas]
 * After many steps the first violated constraint and the first that may give way are taken, by number: no cycles [Bland 1977].
 * Between runs bounds may change freely, and coefficients of a row after sp__lp_deactivate; the active ones stay: a warm start.
 * Rows are best scaled to coefficients of size 1 by the caller.
 */
#ifndef SP__LP_C
#define SP__LP_C

#include "../base/real.c"

#if SP__WITH_COUPLED || SP__WITH_STRONG

#define SP__LP_FREE ((sp_real)1e30)     /* a bound that is none */
#ifdef SP_REAL_FLOAT
#define SP__LP_TOL ((sp_real)1e-4)      /* violation that counts as none */
#define SP__LP_ZERO ((sp_real)1e-5)     /* entry of t, relative to the largest, that counts as none */
#else
#define SP__LP_TOL ((sp_real)1e-9)
#define SP__LP_ZERO ((sp_real)1e-10)
#endif
#define SP__LP_LARGE ((sp_real)1e6)     /* multiplier that is asked of M built anew */
#define SP__LP_STEPS 64                 /* after so many M is built anew */

typedef enum sp__lp_status { SP__LP_POINT, SP__LP_NONE, SP__LP_GIVEN_UP } sp__lp_status;

typedef struct sp__lp {
    int32_t n, m, entries;
    int32_t *start, *index;             /* m + 1; entries of row i from start[i], its variables */
    sp_real *value;
    sp_real *lower, *upper;             /* m + n */
    sp_real *M;                         /* n x n, row after row */
    int32_t *active, *slot;             /* n; m + n: its place among the active, -1 */
    int32_t *list, *keep;               /* n: work */
    sp_real *w, *x, *t, *was;           /* n; t belongs to the last constraint looked at; was: work */
    int32_t failed;                     /* SP__LP_NONE: the constraint that cannot be met; t its multipliers */
    int32_t low;                        /* 1: its lower bound, 0: its upper */
    int32_t since;                      /* steps since M was built */
    int64_t steps, flops;               /* in all */
    int64_t limit;                      /* of flops: what would exceed it is not begun */
} sp__lp;

static void sp__lp_carve(sp__lp *lp, int32_t n, int32_t m, int32_t entries, sp_arena *a)
{
    const size_t all = (size_t)n + (size_t)m;
    lp->n = n; lp->m = m; lp->entries = entries;
    lp->start = sp__take(a, (size_t)m + 1, sizeof *lp->start);
    lp->index = sp__take(a, (size_t)entries, sizeof *lp->index);
    lp->value = sp__take(a, (size_t)entries, sizeof *lp->value);
    lp->lower = sp__take(a, all, sizeof *lp->lower);
    lp->upper = sp__take(a, all, sizeof *lp->upper);
    lp->M = sp__take(a, (size_t)n * (size_t)n, sizeof *lp->M);
    lp->active = sp__take(a, (size_t)n, sizeof *lp->active);
    lp->slot = sp__take(a, all, sizeof *lp->slot);
    lp->list = sp__take(a, (size_t)n, sizeof *lp->list);
    lp->keep = sp__take(a, (size_t)n, sizeof *lp->keep);
    lp->was = sp__take(a, (size_t)n, sizeof *lp->was);
    lp->w = sp__take(a, (size_t)n, sizeof *lp->w);
    lp->x = sp__take(a, (size_t)n, sizeof *lp->x);
    lp->t = sp__take(a, (size_t)n, sizeof *lp->t);
}

/* The variables themselves are active: M = I. */
static void sp__lp_identity(sp__lp *lp)
{
    const size_t n = (size_t)lp->n;
    memset(lp->M, 0, n * n * sizeof *lp->M);
    for (int32_t i = 0; i < lp->m; i++) lp->slot[i] = -1;
    for (int32_t j = 0; j < lp->n; j++) {
        lp->M[(size_t)j * n + (size_t)j] = 1;
        lp->active[j] = lp->m + j;
        lp->slot[lp->m + j] = j;
    }
    lp->since = 0;
}

/* After the rows are written. */
static void sp__lp_start(sp__lp *lp)
{
    sp__lp_identity(lp);
    for (int32_t j = 0; j < lp->n; j++) lp->w[j] = lp->x[j] = 0;
    lp->steps = lp->flops = 0;
    lp->limit = INT64_MAX / 2;
}

/* a_i x */
static sp_real sp__lp_value(const sp__lp *lp, int32_t i)
{
    if (i >= lp->m) return lp->x[i - lp->m];
    sp_real s = 0;
    for (int32_t e = lp->start[i]; e < lp->start[i + 1]; e++) s += lp->value[e] * lp->x[lp->index[e]];
    return s;
}

/* t = a_i M */
static void sp__lp_row(sp__lp *lp, int32_t i)
{
    const size_t n = (size_t)lp->n;
    if (i >= lp->m) {
        memcpy(lp->t, lp->M + (size_t)(i - lp->m) * n, n * sizeof *lp->t);
        return;
    }
    for (size_t k = 0; k < n; k++) lp->t[k] = 0;
    for (int32_t e = lp->start[i]; e < lp->start[i + 1]; e++) {
        const sp_real a = lp->value[e], *row = lp->M + (size_t)lp->index[e] * n;
        for (size_t k = 0; k < n; k++) lp->t[k] += a * row[k];
    }
    lp->flops += 2 * (int64_t)lp->n * (lp->start[i + 1] - lp->start[i]);
}

/* Constraint i, t = a_i M, takes column k:  M_k <- M_k / t_k,  M_l <- M_l - M_k t_l / t_k. */
static void sp__lp_swap(sp__lp *lp, int32_t k, int32_t i)
{
    const size_t n = (size_t)lp->n, c = (size_t)k;
    const sp_real inverse = 1 / lp->t[c];
    for (size_t r = 0; r < n; r++) {
        sp_real *row = lp->M + r * n;
        const sp_real a = row[c] * inverse;
        if (!(sp__abs(a) > 0)) continue;
        for (size_t l = 0; l < n; l++) row[l] -= a * lp->t[l];
        row[c] = a;
    }
    lp->slot[lp->active[k]] = -1;
    lp->active[k] = i;
    lp->slot[i] = k;
    lp->since++;
    lp->steps++;
    lp->flops += 2 * (int64_t)lp->n * lp->n;
}

/* x = M w */
static void sp__lp_point(sp__lp *lp)
{
    const size_t n = (size_t)lp->n;
    for (size_t j = 0; j < n; j++) {
        sp_real s = 0;
        for (size_t k = 0; k < n; k++) s += lp->M[j * n + k] * lp->w[k];
        lp->x[j] = s;
    }
    lp->flops += 2 * (int64_t)lp->n * lp->n;
}

/* Bounds may have moved: active constraints go to the nearest place between theirs, onto a bound they are next to. */
static void sp__lp_move_to_bounds(sp__lp *lp)
{
    for (int32_t k = 0; k < lp->n; k++) {
        const int32_t i = lp->active[k];
        if (lp->w[k] < lp->lower[i] + SP__LP_TOL) lp->w[k] = lp->lower[i];
        if (lp->w[k] > lp->upper[i] - SP__LP_TOL) lp->w[k] = lp->upper[i];
    }
    sp__lp_point(lp);
}

/* The column of largest |t_k|, the first of equals, among those of variables that may leave; -1: all are zero. */
static int32_t sp__lp_largest(const sp__lp *lp)
{
    int32_t best = -1;
    sp_real most = SP__LP_ZERO;
    for (int32_t k = 0; k < lp->n; k++) {
        if (lp->keep[k] || lp->active[k] < lp->m || !(sp__abs(lp->t[k]) > most)) continue;
        most = sp__abs(lp->t[k]);
        best = k;
    }
    return best;
}

/* M anew from the identity: the active rows swapped in, in their order, each by its largest column whose variable was not
 * active itself. A row that depends on those before it is left out. */
SP__NOINLINE static void sp__lp_refresh(sp__lp *lp)
{
    for (int32_t k = 0; k < lp->n; k++) {
        lp->list[k] = lp->active[k];
        lp->was[k] = lp->w[k];
        lp->keep[k] = 0;
    }
    for (int32_t k = 0; k < lp->n; k++) if (lp->list[k] >= lp->m) lp->keep[lp->list[k] - lp->m] = 1;
    sp__lp_identity(lp);
    for (int32_t k = 0; k < lp->n; k++) lp->w[k] = lp->x[k];
    for (int32_t k = 0; k < lp->n; k++) if (lp->list[k] >= lp->m) lp->w[lp->list[k] - lp->m] = lp->was[k];
    for (int32_t k = 0; k < lp->n; k++) {
        if (lp->list[k] >= lp->m) continue;
        sp__lp_row(lp, lp->list[k]);
        const int32_t column = sp__lp_largest(lp);
        if (column < 0) continue;
        sp__lp_swap(lp, column, lp->list[k]);
        lp->w[column] = lp->was[k];
    }
    lp->since = 0;
    sp__lp_move_to_bounds(lp);
}

/* Take row i out of the active ones before its coefficients change: the variable it moves most takes its place. */
static void sp__lp_deactivate(sp__lp *lp, int32_t i)
{
    const int32_t k = lp->slot[i];
    if (k < 0) return;
    const size_t n = (size_t)lp->n;
    int32_t best = -1;
    sp_real most = 0;
    for (int32_t j = 0; j < lp->n; j++) {
        const sp_real a = sp__abs(lp->M[(size_t)j * n + (size_t)k]);
        if (lp->slot[lp->m + j] < 0 && a > most) { most = a; best = j; }
    }
    if (best < 0) return;
    sp__lp_row(lp, lp->m + best);
    sp__lp_swap(lp, k, lp->m + best);
    lp->w[k] = lp->x[best];
}

/* The most violated constraint, or the first; -1: none. *gap: what it lacks, > 0 below its lower bound. */
static int32_t sp__lp_violated(sp__lp *lp, int first, sp_real *gap)
{
    int32_t worst = -1;
    *gap = 0;
    for (int32_t i = 0; i < lp->m + lp->n; i++) {
        if (lp->slot[i] >= 0) continue;
        if (lp->lower[i] <= -SP__LP_FREE && lp->upper[i] >= SP__LP_FREE) continue;
        const sp_real s = sp__lp_value(lp, i);
        const sp_real g = s < lp->lower[i] ? lp->lower[i] - s : s > lp->upper[i] ? lp->upper[i] - s : 0;
        if (sp__abs(g) <= SP__LP_TOL || sp__abs(g) <= sp__abs(*gap)) continue;
        worst = i;
        *gap = g;
        if (first) break;
    }
    lp->flops += 2 * (int64_t)lp->entries;
    return worst;
}

/* The active constraint that gives way: t_k > 0 and room above (or t_k < 0 and room below) when a_i x has to grow. The largest
 * |t_k|, those without any bound first, or the first by number; -1: none. */
static int32_t sp__lp_leaving(const sp__lp *lp, int grow, int first)
{
    int32_t best = -1;
    sp_real most = 0, largest = 0;
    for (int32_t k = 0; k < lp->n; k++) largest = sp__max(largest, sp__abs(lp->t[k]));
    for (int32_t k = 0; k < lp->n; k++) {
        const int32_t i = lp->active[k];
        sp_real size = sp__abs(lp->t[k]);
        if (size <= SP__LP_ZERO * largest) continue;
        const int up = (lp->t[k] > 0) == grow;
        if (up ? lp->w[k] >= lp->upper[i] : lp->w[k] <= lp->lower[i]) continue;
        if (lp->lower[i] <= -SP__LP_FREE && lp->upper[i] >= SP__LP_FREE) size *= 1024;
        if (first ? best < 0 || i < lp->active[best] : size > most) { best = k; most = size; }
    }
    return best;
}

/* The largest |t_k|. Where it is large the small ones may be rounding, or be taken for it. */
static sp_real sp__lp_greatest(const sp__lp *lp)
{
    sp_real largest = 0;
    for (int32_t k = 0; k < lp->n; k++) largest = sp__max(largest, sp__abs(lp->t[k]));
    return largest;
}

/* How far the active constraints are from the values they should have: what rounding did to M. */
static sp_real sp__lp_drift(const sp__lp *lp)
{
    sp_real most = 0;
    for (int32_t k = 0; k < lp->n; k++) most = sp__max(most, sp__abs(sp__lp_value(lp, lp->active[k]) - lp->w[k]));
    return most;
}

/* May so many n x n sweeps more be done? */
static int sp__lp_affords(const sp__lp *lp, int64_t sweeps)
{
    return lp->flops + 2 * (int64_t)lp->entries + 2 * sweeps * lp->n * lp->n <= lp->limit;
}

/* Look for x, by at most `most` steps and within the limit. SP__LP_POINT: x; SP__LP_NONE: failed, low, t. */
static sp__lp_status sp__lp_run(sp__lp *lp, int32_t most)
{
    const int32_t patience = 4 * lp->n + 64;
    sp_real gap;
    if (!sp__lp_affords(lp, 1)) return SP__LP_GIVEN_UP;
    sp__lp_move_to_bounds(lp);
    for (int32_t step = 0; step < most; step++) {
        const int first = step >= patience;
        if (!sp__lp_affords(lp, lp->since >= SP__LP_STEPS ? 2 * (int64_t)lp->n + 3 : 3)) break;
        if (lp->since >= SP__LP_STEPS) sp__lp_refresh(lp);
        const int32_t i = sp__lp_violated(lp, first, &gap);
        if (i < 0) {
            if (lp->since == 0 || sp__lp_drift(lp) <= SP__LP_TOL) return SP__LP_POINT;
            if (!sp__lp_affords(lp, 2 * (int64_t)lp->n + 3)) break;
            sp__lp_refresh(lp);
            continue;
        }
        sp__lp_row(lp, i);
        const int32_t k = sp__lp_leaving(lp, gap > 0, first);
        if (k < 0) {
            lp->failed = i;
            lp->low = gap > 0;
            const int sound = sp__lp_greatest(lp) < SP__LP_LARGE && sp__lp_drift(lp) <= SP__LP_TOL * (sp_real)0.01;
            if (lp->since == 0 || sound) return SP__LP_NONE;
            if (!sp__lp_affords(lp, 2 * (int64_t)lp->n + 3)) break;
            sp__lp_refresh(lp);
            continue;
        }
        sp__lp_swap(lp, k, i);
        lp->w[k] = gap > 0 ? lp->lower[i] : lp->upper[i];
        for (size_t j = 0; j < (size_t)lp->n; j++) lp->x[j] += lp->M[j * (size_t)lp->n + (size_t)k] * gap;
    }
    return SP__LP_GIVEN_UP;
}

#endif
#endif /* SP__LP_C */
