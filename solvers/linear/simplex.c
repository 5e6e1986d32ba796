/* simplex: min c x  with  A x = b,  l <= x <= u, from any point within the bounds.
 *
 *   basis          m columns of A or of I (n + i: what row i lacks); B is the inverse of their matrix; others stay as they are
 *   y = c_B B      multipliers; the rate of column j is c_j - y A_j
 *   step           a column whose rate pays changes by theta, the basis by -theta t, t = B A_j, until one is at its bound; that
 *                  one leaves. Of those at their bounds within SP__SIMPLEX_SLACK the largest entry of t leaves    [Harris 1973]
 * Columns need not be at a bound to be out of the basis: a point found elsewhere is led to a vertex that is no worse. After
 * many steps that gain nothing the first column that pays and the first that may leave are taken: no cycles    [Bland 1977].
 */
#ifndef SP__SIMPLEX_C
#define SP__SIMPLEX_C

#include "../base/real.c"

#if SP__WITH_SLIDING

#define SP__SIMPLEX_FREE ((sp_real)1e30)    /* a bound that is none */
#ifdef SP_REAL_FLOAT
#define SP__SIMPLEX_TOL ((sp_real)1e-4)     /* rate that pays, against the costs */
#define SP__SIMPLEX_SLACK ((sp_real)1e-5)   /* beyond a bound that is as good as at it */
#define SP__SIMPLEX_PIVOT ((sp_real)1e-4)   /* entry of t that counts as none */
#define SP__SIMPLEX_LACK ((sp_real)1e-4)    /* of b, that counts as met */
#else
#define SP__SIMPLEX_TOL ((sp_real)1e-12)
#define SP__SIMPLEX_SLACK ((sp_real)1e-12)
#define SP__SIMPLEX_PIVOT ((sp_real)1e-8)
#define SP__SIMPLEX_LACK ((sp_real)1e-10)
#endif
#define SP__SIMPLEX_AGAIN 64                /* after so many steps x and y are corrected */
#define SP__SIMPLEX_STALL 400               /* after so many steps that gain nothing the first that pays is taken */

typedef enum sp__simplex_status { SP__SIMPLEX_BEST, SP__SIMPLEX_ENDLESS, SP__SIMPLEX_GIVEN_UP } sp__simplex_status;

typedef struct sp__simplex {
    int32_t m, n;
    int32_t *start, *index;             /* n + 1; rows of column j from start[j] */
    sp_real *value, *b;                 /* b: m */
    sp_real *lower, *upper, *cost, *x;  /* n + m */
    sp_real *B;                         /* m x m, row k belongs to head[k] */
    int32_t *head, *at;                 /* m: columns of the basis; n + m: place in it, -1 */
    sp_real *y, *t, *r;                 /* m; r: work */
    int32_t stall;                      /* steps that gained nothing */
    int64_t steps, flops, limit;        /* in all; of flops: what would exceed it is not begun */
} sp__simplex;

static void sp__simplex_carve(sp__simplex *s, int32_t m, int32_t n, int32_t entries, sp_arena *a)
{
    const size_t rows = (size_t)m, all = (size_t)m + (size_t)n;
    s->m = m; s->n = n; s->steps = s->flops = 0;
    s->start = sp__take(a, (size_t)n + 1, sizeof *s->start);
    s->index = sp__take(a, (size_t)entries, sizeof *s->index);
    s->value = sp__take(a, (size_t)entries, sizeof *s->value);
    s->b = sp__take(a, rows, sizeof *s->b);
    s->lower = sp__take(a, all, sizeof *s->lower);
    s->upper = sp__take(a, all, sizeof *s->upper);
    s->cost = sp__take(a, all, sizeof *s->cost);
    s->x = sp__take(a, all, sizeof *s->x);
    s->B = sp__take(a, rows, rows * sizeof *s->B);
    s->head = sp__take(a, rows, sizeof *s->head);
    s->at = sp__take(a, all, sizeof *s->at);
    s->y = sp__take(a, rows, sizeof *s->y);
    s->t = sp__take(a, rows, sizeof *s->t);
    s->r = sp__take(a, rows, sizeof *s->r);
}

/* r = b - A x */
static void sp__simplex_residual(sp__simplex *s)
{
    for (int32_t i = 0; i < s->m; i++) s->r[i] = s->b[i] - s->x[s->n + i];
    for (int32_t j = 0; j < s->n; j++) {
        const sp_real x = s->x[j];
        if (!(sp__abs(x) > 0)) continue;
        for (int32_t e = s->start[j]; e < s->start[j + 1]; e++) s->r[s->index[e]] -= s->value[e] * x;
    }
    s->flops += 2 * (int64_t)s->start[s->n];
}

/* The basis of what rows lack, at the columns' values x. */
static void sp__simplex_begin(sp__simplex *s)
{
    const size_t m = (size_t)s->m;
    memset(s->B, 0, m * m * sizeof *s->B);
    for (int32_t j = 0; j < s->n; j++) s->at[j] = -1;
    for (int32_t i = 0; i < s->m; i++) {
        s->B[(size_t)i * m + (size_t)i] = 1;
        s->head[i] = s->n + i;
        s->at[s->n + i] = i;
        s->x[s->n + i] = 0;
    }
    sp__simplex_residual(s);
    memcpy(s->x + s->n, s->r, m * sizeof *s->r);
}

static sp_real sp__simplex_rate(const sp__simplex *s, int32_t j)
{
    if (j >= s->n) return s->cost[j] - s->y[j - s->n];
    sp_real d = s->cost[j];
    for (int32_t e = s->start[j]; e < s->start[j + 1]; e++) d -= s->y[s->index[e]] * s->value[e];
    return d;
}

/* x_B += B (b - A x), y = c_B B, y += (c_B - y A_B) B: what rounding has taken. */
static void sp__simplex_correct(sp__simplex *s)
{
    const size_t m = (size_t)s->m;
    sp__simplex_residual(s);
    memset(s->y, 0, m * sizeof *s->y);
    for (size_t k = 0; k < m; k++) {
        const sp_real *row = s->B + k * m, c = s->cost[s->head[k]];
        sp_real x = 0;
        for (size_t i = 0; i < m; i++) { x += row[i] * s->r[i]; s->y[i] += c * row[i]; }
        s->x[s->head[k]] += x;
    }
    for (size_t k = 0; k < m; k++) s->r[k] = sp__simplex_rate(s, s->head[k]);
    for (size_t k = 0; k < m; k++) {
        const sp_real *row = s->B + k * m;
        for (size_t i = 0; i < m; i++) s->y[i] += s->r[k] * row[i];
    }
    s->flops += 6 * (int64_t)s->m * s->m;
}

/* The column that pays most, or the first that does; -1: none. *rate: its. */
static int32_t sp__simplex_enter(sp__simplex *s, sp_real *rate)
{
    const int first = s->stall > SP__SIMPLEX_STALL;
    int32_t pick = -1;
    sp_real most = SP__SIMPLEX_TOL;
    for (int32_t j = 0; j < s->n; j++) {
        if (s->at[j] >= 0 || !(s->upper[j] > s->lower[j])) continue;
        const sp_real d = sp__simplex_rate(s, j);
        if (sp__abs(d) <= most || (d < 0 ? s->x[j] >= s->upper[j] : s->x[j] <= s->lower[j])) continue;
        most = sp__abs(d);
        *rate = d;
        pick = j;
        if (first) break;
    }
    s->flops += 2 * (int64_t)s->start[s->n];
    return pick;
}

/* t = B A_j */
static void sp__simplex_column(sp__simplex *s, int32_t j)
{
    const size_t m = (size_t)s->m;
    for (size_t k = 0; k < m; k++) {
        const sp_real *row = s->B + k * m;
        sp_real t = 0;
        for (int32_t e = s->start[j]; e < s->start[j + 1]; e++) t += row[s->index[e]] * s->value[e];
        s->t[k] = t;
    }
    s->flops += 2 * (int64_t)s->m * (s->start[j + 1] - s->start[j]);
}

/* How far the basis's k-th column may go if its value changes by `slope` a unit; `slack` beyond its bound. */
static sp_real sp__simplex_room(const sp__simplex *s, int32_t k, sp_real slope, sp_real slack)
{
    const int32_t j = s->head[k];
    if (sp__abs(slope) <= SP__SIMPLEX_PIVOT) return SP__HUGE;
    if (slope < 0) return s->lower[j] <= -SP__SIMPLEX_FREE ? SP__HUGE : (s->x[j] - s->lower[j] + slack) / -slope;
    return s->upper[j] >= SP__SIMPLEX_FREE ? SP__HUGE : (s->upper[j] - s->x[j] + slack) / slope;
}

/* Who leaves when column j goes up or down; -1: no one. *theta: how far it goes. */
static int32_t sp__simplex_leave(sp__simplex *s, int32_t j, sp_real up, sp_real *theta)
{
    const sp_real own = up > 0 ? s->upper[j] - s->x[j] : s->x[j] - s->lower[j];
    sp_real most = SP__HUGE, largest = 0;
    int32_t pick = -1;
    for (int32_t k = 0; k < s->m; k++) {
        const sp_real room = sp__simplex_room(s, k, -up * s->t[k], SP__SIMPLEX_SLACK);
        if (room < most) most = room;
    }
    *theta = own;
    if (own <= most) return -1;
    for (int32_t k = 0; k < s->m; k++) {
        const sp_real room = sp__simplex_room(s, k, -up * s->t[k], 0), size = sp__abs(s->t[k]);
        const int first = s->stall > SP__SIMPLEX_STALL && pick >= 0;
        if (room > most || (first ? s->head[k] > s->head[pick] : size <= largest)) continue;
        largest = size;
        pick = k;
        *theta = sp__max(0, room);
    }
    return pick;
}

/* Column j takes the k-th place:  B_k <- B_k / t_k,  B_i <- B_i - t_i B_k,  y <- y + rate B_k */
static void sp__simplex_swap(sp__simplex *s, int32_t k, int32_t j, sp_real rate)
{
    const size_t m = (size_t)s->m;
    sp_real *pivot = s->B + (size_t)k * m;
    const sp_real d = s->t[k];
    for (size_t i = 0; i < m; i++) pivot[i] /= d;
    for (size_t q = 0; q < m; q++) {
        const sp_real t = s->t[q];
        sp_real *row = s->B + q * m;
        if (q == (size_t)k || !(sp__abs(t) > 0)) continue;
        for (size_t i = 0; i < m; i++) row[i] -= t * pivot[i];
        s->flops += 2 * (int64_t)m;
    }
    for (size_t i = 0; i < m; i++) s->y[i] += rate * pivot[i];
    s->at[s->head[k]] = -1;
    s->head[k] = j;
    s->at[j] = k;
}

/* One step of column j, whose rate pays.     returns 0: nothing ends it */
static int sp__simplex_step(sp__simplex *s, int32_t j, sp_real rate)
{
    const sp_real up = rate < 0 ? (sp_real)1 : (sp_real)-1;
    sp_real theta;
    sp__simplex_column(s, j);
    const int32_t k = sp__simplex_leave(s, j, up, &theta);
    if (!(theta < SP__HUGE / 2)) return 0;
    for (int32_t i = 0; i < s->m; i++) s->x[s->head[i]] -= up * theta * s->t[i];
    s->x[j] += up * theta;
    s->stall = theta * sp__abs(rate) > SP__SIMPLEX_SLACK ? 0 : s->stall + 1;
    s->steps++;
    if (k < 0) { s->x[j] = up > 0 ? s->upper[j] : s->lower[j]; return 1; }
    const int32_t out = s->head[k];
    s->x[out] = -up * s->t[k] > 0 ? s->upper[out] : s->lower[out];
    sp__simplex_swap(s, k, j, rate);
    return 1;
}

/* From the basis and point at hand, at most so many steps. */
SP__NOINLINE static sp__simplex_status sp__simplex_run(sp__simplex *s, int32_t most)
{
    sp_real rate = 0;
    s->stall = 0;
    for (int32_t it = 0; it < most && s->flops < s->limit; it++) {
        if (it % SP__SIMPLEX_AGAIN == 0) sp__simplex_correct(s);
        int32_t j = sp__simplex_enter(s, &rate);
        if (j < 0) {
            for (int turn = 0; turn < 2; turn++) sp__simplex_correct(s);
            j = sp__simplex_enter(s, &rate);
            if (j < 0) return SP__SIMPLEX_BEST;
        }
        if (!sp__simplex_step(s, j, rate)) return SP__SIMPLEX_ENDLESS;
    }
    return SP__SIMPLEX_GIVEN_UP;
}

/* From the columns' values, within their bounds, to a point with A x = b: what rows lack shrinks to nothing. All costs are 0
 * then.     returns 0: there is none, or it was not found */
SP__NOINLINE static int sp__simplex_meet(sp__simplex *s, int32_t most)
{
    sp_real lack = 0, size = 0;
    sp__simplex_begin(s);
    for (int32_t j = 0; j < s->n; j++) s->cost[j] = 0;
    for (int32_t j = s->n; j < s->n + s->m; j++) {
        s->lower[j] = s->x[j] < 0 ? -SP__SIMPLEX_FREE : 0;
        s->upper[j] = s->x[j] < 0 ? 0 : SP__SIMPLEX_FREE;
        s->cost[j] = s->x[j] < 0 ? (sp_real)-1 : (sp_real)1;
        size = sp__max(size, sp__abs(s->b[j - s->n]));
    }
    sp__simplex_run(s, most);
    for (int32_t j = s->n; j < s->n + s->m; j++) {
        lack = sp__max(lack, sp__abs(s->x[j]));
        s->lower[j] = s->upper[j] = s->cost[j] = 0;
    }
    return lack <= SP__SIMPLEX_LACK * size;
}

#endif

#endif /* SP__SIMPLEX_C */
