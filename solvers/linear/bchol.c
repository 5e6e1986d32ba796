/* bchol: Cholesky factors of a sparse symmetric matrix of 6 x 6 blocks, A = L L'.                    [George, Liu 1981, ch. 5]
 *
 * Rows are renumbered by sp__order. Column k of L: its diagonal block in d (the lower triangle by columns, 21 numbers, entry
 * (r, c) at sp__column[c] + r - c, reciprocals on the diagonal), the blocks below it in x, row numbers ascending in i, entry
 * (r, c) of a block at 6 c + r.
 * Right-looking: when column k is final, every pair of its blocks updates one block further right. Columns that follow each
 * other and have the same rows below them (a supernode) update together, so that a block further right is found and moved once
 * for all of them; each number still sums column by column.
 * A pivot below `floor` is raised to it and the rest of its column dropped: such a direction carries nothing, and what rounding
 * left of the column would grow. Its reciprocal is marked by a minus sign.
 */
#ifndef SP__BCHOL_C
#define SP__BCHOL_C

#include "order.c"

#if SP__WITH_LARGE

static const unsigned char sp__column[6] = { 0, 6, 11, 15, 18, 20 };    /* where the columns of a lower triangle start */
static const unsigned char sp__column3[3] = { 0, 3, 5 };                /* of one of 3 x 3 */

typedef struct sp__bchol {
    int32_t n, rows;                    /* rows: 6, or 3 with blocks of 6 numbers in d and 9 in x */
    int32_t *perm, *inv;                /* k-th eliminated row, and back */
    int32_t *p, *i;                     /* column starts (n + 1), row numbers in elimination order */
    sp__low *d, *x;                     /* 21 n, 36 p[n] */
#ifdef SP_REAL_MIXED
    sp_real *d3, *x3;                   /* in place of them where rows = 3 */
#endif
    sp_real *t;                         /* 6 n: right-hand side in elimination order, free between solves */
    sp__low *z;                         /* the same in the factor's precision: t, where that is the only one */
    int64_t flops;                      /* of one factorisation */
} sp__bchol;

static void sp__bchol_carve_pattern(sp__bchol *f, int32_t n, sp_arena *a)
{
    f->n = n;
    f->rows = 6;
    f->perm = sp__take(a, (size_t)n, sizeof *f->perm);
    f->inv = sp__take(a, (size_t)n, sizeof *f->inv);
    f->p = sp__take(a, (size_t)n + 1, sizeof *f->p);
}

static void sp__bchol_carve_values(sp__bchol *f, int32_t nnz, sp_arena *a)
{
    f->i = sp__take(a, (size_t)nnz, sizeof *f->i);
    const int flat = f->rows == 3;
#ifdef SP_REAL_MIXED
    f->d3 = sp__take(a, (size_t)f->n, (flat ? 6 : 0) * sizeof *f->d3);
    f->x3 = sp__take(a, (size_t)nnz, (flat ? 9 : 0) * sizeof *f->x3);
    f->d = sp__take(a, (size_t)f->n, (flat ? 0 : 21) * sizeof *f->d);
    f->x = sp__take(a, (size_t)nnz, (flat ? 0 : 36) * sizeof *f->x);
#else
    f->d = sp__take(a, (size_t)f->n, (flat ? 6 : 21) * sizeof *f->d);
    f->x = sp__take(a, (size_t)nnz, (flat ? 9 : 36) * sizeof *f->x);
#endif
    f->t = sp__take(a, (size_t)f->n, 6 * sizeof *f->t);
#ifdef SP_REAL_MIXED
    f->z = sp__take(a, (size_t)f->n, 6 * sizeof *f->z);
#else
    f->z = f->t;
#endif
}

/* Walk the pattern of L by rows: row k holds j if a path leads from j up the elimination tree to k. Without `i` the columns
 * are counted into p (p[j + 1] for column j), with `i` they are filled; p then serves as cursor and is shifted back after. */
static void sp__bchol_rows(sp__bchol *f, const int32_t *xadj, const int32_t *adj, int32_t *parent, int32_t *mark, int32_t *i)
{
    for (int32_t k = 0; k < f->n; k++) {
        const int32_t v = f->perm[k];
        mark[k] = k;
        if (!i) parent[k] = -1;
        for (int32_t q = xadj[v]; q < xadj[v + 1]; q++)
            for (int32_t j = f->inv[adj[q]]; j < k && mark[j] != k; j = parent[j]) {
                mark[j] = k;
                if (i) i[f->p[j]++] = k;
                else {
                    f->p[j + 1]++;
                    if (parent[j] < 0) parent[j] = k;
                }
            }
    }
}

/* Count in the order of perm: fills inv, p (column starts), flops. Returns the number of blocks below the diagonal, -1 when it
 * does not fit an int32. parent (n) is for sp__bchol_pattern. */
SP__NOINLINE static int32_t sp__bchol_count(sp__bchol *f, const int32_t *xadj, const int32_t *adj, int32_t *parent,
                                            int32_t *mark)
{
    for (int32_t k = 0; k < f->n; k++) { f->inv[f->perm[k]] = k; f->p[k] = 0; }
    f->p[f->n] = 0;
    sp__bchol_rows(f, xadj, adj, parent, mark, NULL);
    int64_t nnz = 0;
    f->flops = 0;
    for (int32_t k = 0; k < f->n; k++) {
        const int64_t c = f->p[k + 1];
        f->flops += 91 + 468 * c + 432 * (c * (c - 1) / 2);     /* 6x6 Cholesky, c triangular solves and squares, products */
        nnz += c;
        if (nnz > INT32_MAX / 36) return -1;
        f->p[k + 1] = (int32_t)nnz;
    }
    return (int32_t)nnz;
}

#define SP__BCHOL_FEW  50               /* rows that have nothing to gain from nodes that merge */
#define SP__BCHOL_LONG 30000            /* squares (see sp__order_run) beyond which every way to break ties is tried */

/* Order and count: the way to break ties that gives the fewest flops. Scratch: what sp__order_carve takes. */
static int32_t sp__bchol_analyse(sp__bchol *f, const int32_t *xadj, const int32_t *adj, int32_t *parent, int32_t *mark,
                                 sp_arena scratch)
{
    int best = f->n >= SP__BCHOL_FEW, last = best;
    int64_t least = sp__order_run(f->n, xadj, adj, best, scratch, mark, f->perm);
    while (last && least >= SP__BCHOL_LONG && last < SP__ORDER_WAYS) {
        const int64_t squares = sp__order_run(f->n, xadj, adj, ++last, scratch, mark, f->perm);
        if (squares < least) { least = squares; best = last; }
    }
    if (best != last) sp__order_run(f->n, xadj, adj, best, scratch, mark, f->perm);
    return sp__bchol_count(f, xadj, adj, parent, mark);
}

/* Row numbers of L's columns, column by column, after sp__bchol_count. */
static void sp__bchol_pattern(sp__bchol *f, const int32_t *xadj, const int32_t *adj, int32_t *parent, int32_t *mark)
{
    for (int32_t k = 0; k < f->n; k++) mark[k] = -1;
    sp__bchol_rows(f, xadj, adj, parent, mark, f->i);
    for (int32_t k = f->n; k > 0; k--) f->p[k] = f->p[k - 1];
    f->p[0] = 0;
}

/* Place of block (row r, column c) of the matrix, r and c unpermuted, r != c; *turned: it is stored as its transpose. */
static int32_t sp__bchol_slot(const sp__bchol *f, int32_t r, int32_t c, int32_t *turned)
{
    int32_t k = f->inv[c], i = f->inv[r];
    *turned = k > i;
    if (*turned) { const int32_t s = k; k = i; i = s; }
    int32_t lo = f->p[k], hi = f->p[k + 1];
    while (hi - lo > 1) {
        const int32_t mid = lo + (hi - lo) / 2;
        if (f->i[mid] <= i) lo = mid; else hi = mid;
    }
    return lo;
}

/* L L' = A for one block, lower triangle in place, reciprocal diagonal. */
static void sp__bchol_block(sp__low *a, sp__low floor)
{
    for (int c = 0; c < 6; c++) {
        sp__low *ac = a + sp__column[c];
        for (int k = 0; k < c; k++) {
            const sp__low *ak = a + sp__column[k] + c - k;
            const sp__low s = *ak;
            for (int r = c; r < 6; r++) ac[r - c] -= ak[r - c] * s;
        }
        const int carries = *ac > floor;
        const sp__low s = (sp__low)(1 / SP_SQRT((sp_real)(carries ? *ac : floor)));
        *ac = carries ? s : -s;
        for (int r = c + 1; r < 6; r++) ac[r - c] *= carries ? s : 0;
    }
}

#ifdef SP_REAL_MIXED
/* A final block loses what is below 2^-63: rows have unit size, and two such numbers have a product below the normal range of a
 * float, which processors take a hundred cycles for. Conjugate gradients mend it. */
static void sp__bchol_flush(sp__low *x)
{
    const sp__low tiny = 1.08420217e-19f;
    for (int k = 0; k < 36; k++) x[k] = x[k] < tiny && x[k] > -tiny ? 0 : x[k];
}
#else
static void sp__bchol_flush(sp__low *x) { (void)x; }
#endif

/* z <- z - l s of six numbers z0 .. z5 at hand: compilers at -O2 take two at a time. */
#define SP__LESS6(l, s) \
    z0 -= (l)[0] * (s); z1 -= (l)[1] * (s); z2 -= (l)[2] * (s); z3 -= (l)[3] * (s); z4 -= (l)[4] * (s); z5 -= (l)[5] * (s)

/* X <- X L'^-1, column by column. */
static void sp__bchol_right(sp__low *x, const sp__low *l)
{
    for (int c = 0; c < 6; c++) {
        sp__low *xc = x + 6 * c, z0 = xc[0], z1 = xc[1], z2 = xc[2], z3 = xc[3], z4 = xc[4], z5 = xc[5];
        const sp__low *lc = l + c, *xk = x;
        for (int k = 5; xk < xc; xk += 6, lc += k--) { SP__LESS6(xk, *lc); }
        const sp__low s = *lc < 0 ? 0 : *lc;
        xc[0] = z0 * s; xc[1] = z1 * s; xc[2] = z2 * s; xc[3] = z3 * s; xc[4] = z4 * s; xc[5] = z5 * s;
    }
    sp__bchol_flush(x);
}

/* B for many an update: in mixed each number six times, in room, so that compilers take four floats of C at a time, of two
 * columns three times four; else b itself. */
#ifdef SP_REAL_MIXED
#define SP__SPREAD 216                  /* numbers in room; with one for each column at hand, 7 kB of stack */

SP__NOINLINE static const sp__low *sp__bchol_spread(const sp__low *b, sp__low *room)
{
    sp__low *e = room;
    for (int k = 0; k < 36; k++, e += 6) e[0] = e[1] = e[2] = e[3] = e[4] = e[5] = b[k];
    return room;
}
#else
#define SP__SPREAD 1
static const sp__low *sp__bchol_spread(const sp__low *b, sp__low *room) { (void)room; return b; }
#endif

/* C <- C - sum of A B' over `wide` columns, A at a[m] + at, B at b[m] as sp__bchol_spread makes it; all 6 x 6 by columns.
 * Written out because compilers at -O2 do not unroll it. */
#ifdef SP_REAL_MIXED
static void sp__bchol_update(sp__low *c, int wide, const sp__low *const *a, const sp__low *const *b, size_t at)
{
    for (int q = 0; q < 36; q += 12, c += 12) {
        sp__low z0 = c[0], z1 = c[1], z2 = c[2], z3 = c[3], z4 = c[4], z5 = c[5];
        sp__low y0 = c[6], y1 = c[7], y2 = c[8], y3 = c[9], y4 = c[10], y5 = c[11];
        for (int m = 0; m < wide; m++) {
            const sp__low *l = a[m] + at, *e = b[m] + q;
#define SP__STEP(l, e) \
    z0 -= (l)[0] * (e)[0]; z1 -= (l)[1] * (e)[1]; z2 -= (l)[2] * (e)[2]; z3 -= (l)[3] * (e)[3]; \
    z4 -= (l)[4] * (e)[4]; z5 -= (l)[5] * (e)[5]; y0 -= (l)[0] * (e)[6]; y1 -= (l)[1] * (e)[7]; \
    y2 -= (l)[2] * (e)[8]; y3 -= (l)[3] * (e)[9]; y4 -= (l)[4] * (e)[10]; y5 -= (l)[5] * (e)[11];
            SP__STEP(l, e) SP__STEP(l + 6, e + 36) SP__STEP(l + 12, e + 72)
            SP__STEP(l + 18, e + 108) SP__STEP(l + 24, e + 144) SP__STEP(l + 30, e + 180)
#undef SP__STEP
        }
        c[0] = z0; c[1] = z1; c[2] = z2; c[3] = z3; c[4] = z4; c[5] = z5;
        c[6] = y0; c[7] = y1; c[8] = y2; c[9] = y3; c[10] = y4; c[11] = y5;
    }
}
#else
static void sp__bchol_update(sp__low *c, int wide, const sp__low *const *a, const sp__low *const *b, size_t at)
{
    for (int q = 0; q < 6; q++, c += 6) {
        sp__low z0 = c[0], z1 = c[1], z2 = c[2], z3 = c[3], z4 = c[4], z5 = c[5];
        for (int m = 0; m < wide; m++) {
            const sp__low *am = a[m] + at, *bm = b[m] + q;
#define SP__STEP(k) { const sp__low s = bm[6 * (k)]; SP__LESS6(am + 6 * (k), s); }
            SP__STEP(0) SP__STEP(1) SP__STEP(2) SP__STEP(3) SP__STEP(4) SP__STEP(5)
#undef SP__STEP
        }
        c[0] = z0; c[1] = z1; c[2] = z2; c[3] = z3; c[4] = z4; c[5] = z5;
    }
}
#endif

/* C <- C - A A', the lower triangle C. */
static void sp__bchol_square(sp__low *c, const sp__low *a)
{
    for (int k = 0; k < 6; k++, a += 6) {
        const sp__low a0 = a[0], a1 = a[1], a2 = a[2], a3 = a[3], a4 = a[4], a5 = a[5];
        c[0] -= a0 * a0; c[1] -= a1 * a0; c[2] -= a2 * a0; c[3] -= a3 * a0; c[4] -= a4 * a0; c[5] -= a5 * a0;
        c[6] -= a1 * a1; c[7] -= a2 * a1; c[8] -= a3 * a1; c[9] -= a4 * a1; c[10] -= a5 * a1;
        c[11] -= a2 * a2; c[12] -= a3 * a2; c[13] -= a4 * a2; c[14] -= a5 * a2;
        c[15] -= a3 * a3; c[16] -= a4 * a3; c[17] -= a5 * a3;
        c[18] -= a4 * a4; c[19] -= a5 * a4;
        c[20] -= a5 * a5;
    }
}

#define SP__SUPERNODE 8                 /* columns that update together, at most */

/* How many columns from k on, at most SP__SUPERNODE, have the same rows below them? Each has those of the one before but its
 * own. */
static int sp__bchol_wide(const sp__bchol *f, int32_t k)
{
    int wide = 1;
    for (int32_t j = k + 1; wide < SP__SUPERNODE && j < f->n; j++, wide++)
        if (f->p[j] == f->p[j - 1] || f->i[f->p[j - 1]] != j || f->p[j + 1] - f->p[j] != f->p[j] - f->p[j - 1] - 1) break;
    return wide;
}

/* A supernode, columns k .. k + wide - 1, and how many tasks share the work on what is below it. */
typedef struct sp__supernode {
    sp__bchol *f;
    int32_t k, below, tasks;            /* below: blocks that all of its columns have */
    int wide;
    sp__low floor;
} sp__supernode;

#define SP__TASKS      16               /* of a supernode, at most */
#define SP__TASK_FLOPS 100000           /* less is not worth a task of its own */

/* A supernode from column k on. */
static sp__supernode sp__supernode_at(sp__bchol *f, int32_t k, sp__low floor)
{
    const int wide = sp__bchol_wide(f, k);
    const sp__supernode s = { f, k, f->p[k + wide] - f->p[k + wide - 1], 1, wide, floor };
    return s;
}

/* Work on a supernode by as many tasks as `flops` are worth, at once where the caller can: each writes blocks that no other
 * writes or reads, so the bits are the same. */
SP__NOINLINE static void sp__supernode_run(sp__supernode *s, const sp_parallel *parallel, int64_t flops,
                                           void (*task)(void *, int32_t))
{
    s->tasks = !parallel || flops < 2 * SP__TASK_FLOPS ? 1
             : flops < SP__TASKS * SP__TASK_FLOPS ? (int32_t)(flops / SP__TASK_FLOPS) : SP__TASKS;
    if (s->tasks > 1) parallel->run(parallel->self, task, s, s->tasks);
    else task(s, 0);
}

/* x[m]: blocks of column k + m from the first row on that all columns have. */
static void sp__supernode_columns(const sp__supernode *s, sp__low **x)
{
    for (int m = 0; m < s->wide; m++) x[m] = s->f->x + 36 * (size_t)(s->f->p[s->k + m] + s->wide - 1 - m);
}

/* The columns' own rows made final, column after column; each updates those after it. */
static void sp__supernode_within(const sp__supernode *s)
{
    sp__bchol *f = s->f;
    for (int32_t j = s->k, own = s->wide - 1; own >= 0; j++, own--) {
        sp__low *d = f->d + 21 * (size_t)j, *x = f->x + 36 * (size_t)f->p[j];
        sp__bchol_block(d, s->floor);
        for (int32_t q = 0; q < own; q++) sp__bchol_right(x + 36 * (size_t)q, d);
        for (int32_t b = 0; b < own; b++) {
            sp__low *to = f->x + 36 * (size_t)f->p[j + 1 + b], *at = x + 36 * (size_t)b, room[SP__SPREAD];
            const sp__low *const from[1] = { x }, *const xb[1] = { sp__bchol_spread(at, room) };
            sp__bchol_square(f->d + 21 * (size_t)(j + 1 + b), at);
            for (int32_t a = b + 1; a < own; a++, to += 36) sp__bchol_update(to, 1, from, xb, 36 * (size_t)a);
        }
    }
}

/* Task t: rows below made final, each by itself: its block of every column less what the columns before it put there. */
static void sp__supernode_rows(void *job, int32_t t)
{
    const sp__supernode *s = job;
    sp__low *x[SP__SUPERNODE], room[SP__SUPERNODE][SP__SPREAD];
    const sp__low *a[SP__SUPERNODE], *b[SP__SUPERNODE];
    sp__supernode_columns(s, x);
    for (int m = 0; m < s->wide; m++) a[m] = x[m];
    for (int m = 0; m < s->wide; m++) {
        const sp__low *d = s->f->d + 21 * (size_t)(s->k + m);
        for (int c = 0; c < m; c++) b[c] = sp__bchol_spread(x[c] - 36 * (size_t)(s->wide - m), room[c]);
        for (int32_t r = t; r < s->below; r += s->tasks) {
            sp__bchol_update(x[m] + 36 * (size_t)r, m, a, b, 36 * (size_t)r);
            sp__bchol_right(x[m] + 36 * (size_t)r, d);
        }
    }
}

/* Task t: the columns of rows t, t + tasks, .. further right less what the supernode puts there. */
static void sp__supernode_beyond(void *job, int32_t t)
{
    const sp__supernode *s = job;
    const sp__bchol *f = s->f;
    const int32_t *row = f->i + f->p[s->k + s->wide - 1];
    sp__low *x[SP__SUPERNODE], room[SP__SUPERNODE][SP__SPREAD];
    const sp__low *a[SP__SUPERNODE], *b[SP__SUPERNODE];         /* blocks of its columns below it; of the row at hand */
    sp__supernode_columns(s, x);
    for (int m = 0; m < s->wide; m++) a[m] = x[m];
    for (int32_t c = t; c < s->below; c += s->tasks) {
        int32_t to = f->p[row[c]];
        for (int m = 0; m < s->wide; m++) {
            const sp__low *at = x[m] + 36 * (size_t)c;
            sp__bchol_square(f->d + 21 * (size_t)row[c], at);
            b[m] = c + 1 < s->below ? sp__bchol_spread(at, room[m]) : at;       /* the last row updates none */
        }
        for (int32_t r = c + 1; r < s->below; r++) {
            while (f->i[to] < row[r]) to++;
            sp__bchol_update(f->x + 36 * (size_t)to, s->wide, a, b, 36 * (size_t)r);
        }
    }
}

/* A = L L' in place, blocks of 6 x 6, supernode after supernode. parallel: who runs tasks at once, NULL: no one. */
SP__NOINLINE static void sp__bchol_factor(sp__bchol *f, sp__low floor, const sp_parallel *parallel)
{
    for (int32_t k = 0; k < f->n;) {
        sp__supernode s = sp__supernode_at(f, k, floor);
        const int64_t wide = s.wide, below = s.below;
        sp__supernode_within(&s);
        sp__supernode_run(&s, parallel, 216 * wide * wide * below, sp__supernode_rows);
        sp__supernode_run(&s, parallel, 216 * wide * below * below, sp__supernode_beyond);
        k += s.wide;
    }
}

/* Numbers of blocks in full precision: where it is mixed only those of 3 x 3 are. */
#ifdef SP_REAL_MIXED
static sp_real *sp__bchol_d(const sp__bchol *f) { return f->d3; }
static sp_real *sp__bchol_x(const sp__bchol *f) { return f->x3; }
#else
static sp_real *sp__bchol_d(const sp__bchol *f) { return f->d; }
static sp_real *sp__bchol_x(const sp__bchol *f) { return f->x; }
#endif

/* Factor of a block of 3 x 3: 6 numbers on the diagonal of the matrix, 9 below it. */
static void sp__bchol3_block(sp_real *d, sp_real floor)
{
    for (int c = 0; c < 3; c++) {
        sp_real *x = d + sp__column3[c];
        const int carries = *x > floor;
        const sp_real s = 1 / SP_SQRT(carries ? *x : floor);
        for (int r = c + 1; r < 3; r++) x[r - c] *= carries ? s : 0;
        *x = carries ? s : -s;
        for (int k = c + 1; k < 3; k++)
            for (int r = k; r < 3; r++) d[sp__column3[k] + r - k] -= x[r - c] * x[k - c];
    }
}

/* C <- C - sum of A B' over `wide` columns, as sp__bchol_update; all 3 x 3 by columns. */
static void sp__bchol3_update(sp_real *c, int wide, const sp_real *const *a, const sp_real *const *b, size_t at)
{
    for (int q = 0; q < 3; q++, c += 3) {
        sp_real c0 = c[0], c1 = c[1], c2 = c[2];
        for (int m = 0; m < wide; m++) {
            const sp_real *am = a[m] + at, s = b[m][q], t = b[m][3 + q], u = b[m][6 + q];
            c0 -= am[0] * s + am[3] * t + am[6] * u;
            c1 -= am[1] * s + am[4] * t + am[7] * u;
            c2 -= am[2] * s + am[5] * t + am[8] * u;
        }
        c[0] = c0; c[1] = c1; c[2] = c2;
    }
}

/* C <- C - A A', the lower triangle C. */
static void sp__bchol3_square(sp_real *c, const sp_real *a)
{
    for (int q = 0, at = 0; q < 3; q++)
        for (int r = q; r < 3; r++, at++) c[at] -= a[r] * a[q] + a[3 + r] * a[3 + q] + a[6 + r] * a[6 + q];
}

/* X <- X L'^-1 */
static void sp__bchol3_right(sp_real *x, const sp_real *d)
{
    const sp_real s0 = sp__max(d[0], 0), s1 = sp__max(d[3], 0), s2 = sp__max(d[5], 0);
    for (int r = 0; r < 3; r++) {
        x[r] *= s0;
        x[3 + r] = (x[3 + r] - x[r] * d[1]) * s1;
        x[6 + r] = (x[6 + r] - x[r] * d[2] - x[3 + r] * d[4]) * s2;
    }
}

/* sp__bchol_within, blocks of 3 x 3. */
static void sp__bchol3_within(sp__bchol *f, int32_t k, int wide, sp_real floor)
{
    for (int32_t j = k; j < k + wide; j++) {
        sp_real *d = sp__bchol_d(f) + 6 * (size_t)j;
        const int32_t below = f->p[j + 1] - f->p[j];
        sp_real *x = sp__bchol_x(f) + 9 * (size_t)f->p[j];
        sp__bchol3_block(d, floor);
        for (int32_t q = 0; q < below; q++) sp__bchol3_right(x + 9 * (size_t)q, d);
        for (int32_t b = 0; j + 1 + b < k + wide; b++) {
            const sp_real *from = x, *xb = x + 9 * (size_t)b;
            sp_real *to = sp__bchol_x(f) + 9 * (size_t)f->p[j + 1 + b];
            sp__bchol3_square(sp__bchol_d(f) + 6 * (size_t)(j + 1 + b), xb);
            for (int32_t a = b + 1; a < below; a++, to += 9) sp__bchol3_update(to, 1, &from, &xb, 9 * (size_t)a);
        }
    }
}

/* sp__supernode_beyond, blocks of 3 x 3. */
static void sp__bchol3_beyond(void *job, int32_t t)
{
    const sp__supernode *s = job;
    const sp__bchol *f = s->f;
    const int32_t *row = f->i + f->p[s->k + s->wide - 1];
    const sp_real *x[SP__SUPERNODE], *xb[SP__SUPERNODE];
    for (int m = 0; m < s->wide; m++) x[m] = sp__bchol_x(f) + 9 * (size_t)(f->p[s->k + m] + s->wide - 1 - m);
    for (int32_t b = t; b < s->below; b += s->tasks) {
        int32_t to = f->p[row[b]];
        for (int m = 0; m < s->wide; m++) {
            xb[m] = x[m] + 9 * (size_t)b;
            sp__bchol3_square(sp__bchol_d(f) + 6 * (size_t)row[b], xb[m]);
        }
        for (int32_t a = b + 1; a < s->below; a++) {
            while (f->i[to] < row[a]) to++;
            sp__bchol3_update(sp__bchol_x(f) + 9 * (size_t)to, s->wide, x, xb, 9 * (size_t)a);
        }
    }
}

/* sp__bchol_factor, blocks of 3 x 3. */
SP__NOINLINE static void sp__bchol3_factor(sp__bchol *f, sp_real floor, const sp_parallel *parallel)
{
    for (int32_t k = 0; k < f->n;) {
        sp__supernode s = sp__supernode_at(f, k, 0);
        sp__bchol3_within(f, k, s.wide, floor);
        sp__supernode_run(&s, parallel, (int64_t)27 * s.wide * s.below * s.below, sp__bchol3_beyond);
        k += s.wide;
    }
}

/* t <- (L L')^-1 t, 3 n in elimination order. */
SP__NOINLINE static void sp__bchol3_solve(const sp__bchol *f, sp_real *t)
{
    for (int32_t k = 0; k < f->n; k++) {                                /* L z = b */
        sp_real *v = t + 3 * (size_t)k;
        const sp_real *d = sp__bchol_d(f) + 6 * (size_t)k;
        v[0] *= sp__abs(d[0]);
        v[1] = (v[1] - d[1] * v[0]) * sp__abs(d[3]);
        v[2] = (v[2] - d[2] * v[0] - d[4] * v[1]) * sp__abs(d[5]);
        for (int32_t q = f->p[k]; q < f->p[k + 1]; q++) {
            sp_real *z = t + 3 * (size_t)f->i[q];
            const sp_real *l = sp__bchol_x(f) + 9 * (size_t)q;
            for (int r = 0; r < 3; r++) z[r] -= l[r] * v[0] + l[3 + r] * v[1] + l[6 + r] * v[2];
        }
    }
    for (int32_t k = f->n - 1; k >= 0; k--) {                           /* L' x = z */
        sp_real *v = t + 3 * (size_t)k;
        const sp_real *d = sp__bchol_d(f) + 6 * (size_t)k;
        for (int32_t q = f->p[k]; q < f->p[k + 1]; q++) {
            const sp_real *z = t + 3 * (size_t)f->i[q], *l = sp__bchol_x(f) + 9 * (size_t)q;
            for (int c = 0; c < 3; c++, l += 3) v[c] -= l[0] * z[0] + l[1] * z[1] + l[2] * z[2];
        }
        v[2] *= sp__abs(d[5]);
        v[1] = (v[1] - d[4] * v[2]) * sp__abs(d[3]);
        v[0] = (v[0] - d[1] * v[1] - d[2] * v[2]) * sp__abs(d[0]);
    }
}

/* Numbers of a diagonal block, of one below; where column c of the former starts. */
static size_t sp__bchol_triangle(const sp__bchol *f) { return f->rows == 3 ? 6 : 21; }
static size_t sp__bchol_whole(const sp__bchol *f) { return f->rows == 3 ? 9 : 36; }
static size_t sp__bchol_at(const sp__bchol *f, int c) { return f->rows == 3 ? sp__column3[c] : sp__column[c]; }

/* A <- T A T + shift, T = diag(A)^-1/2 (1 where that is 0) kept in t: with it a floor is relative to every row. */
SP__NOINLINE static void sp__bchol_balance(sp__bchol *f, sp_real shift)
{
    const size_t n = (size_t)f->rows, whole = sp__bchol_whole(f);
    for (size_t k = 0; k < (size_t)f->n; k++) {
        sp_real *d = sp__bchol_d(f) + sp__bchol_triangle(f) * k, *t = f->t + n * k;
        for (int c = 0; c < f->rows; c++) {
            const sp_real x = d[sp__bchol_at(f, c)];
            t[c] = x > 0 ? 1 / SP_SQRT(x) : 1;
        }
        for (int c = 0; c < f->rows; c++) {
            sp_real *x = d + sp__bchol_at(f, c);
            for (int r = c; r < f->rows; r++) x[r - c] *= t[c] * t[r];
            *x += shift;
        }
    }
    for (int32_t k = 0; k < f->n; k++)
        for (int32_t q = f->p[k]; q < f->p[k + 1]; q++) {
            const sp_real *s = f->t + n * (size_t)k, *t = f->t + n * (size_t)f->i[q];
            for (size_t c = 0; c < whole; c++) sp__bchol_x(f)[whole * (size_t)q + c] *= s[c / n] * t[c % n];
        }
}

/* L <- T^-1 L: the factor of A, not of T A T. */
SP__NOINLINE static void sp__bchol_unbalance(sp__bchol *f)
{
    const size_t n = (size_t)f->rows, whole = sp__bchol_whole(f);
    for (int32_t k = 0; k < f->n; k++) {
        sp_real *d = sp__bchol_d(f) + sp__bchol_triangle(f) * (size_t)k, *t = f->t + n * (size_t)k;
        for (int c = 0; c < f->rows; c++) {
            sp_real *x = d + sp__bchol_at(f, c);
            *x *= t[c];
            for (int r = c + 1; r < f->rows; r++) x[r - c] /= t[r];
        }
        for (int32_t q = f->p[k]; q < f->p[k + 1]; q++)
            for (size_t c = 0; c < whole; c++) sp__bchol_x(f)[whole * (size_t)q + c] /= f->t[n * (size_t)f->i[q] + c % n];
    }
}

/* All blocks of the matrix 0, before it is assembled. */
static void sp__bchol_zero(sp__bchol *f)
{
    if (SP__WITH_REDUCTION && f->rows == 3) {
        memset(sp__bchol_d(f), 0, (size_t)f->n * 6 * sizeof(sp_real));
        memset(sp__bchol_x(f), 0, (size_t)f->p[f->n] * 9 * sizeof(sp_real));
        return;
    }
    memset(f->d, 0, (size_t)f->n * 21 * sizeof *f->d);
    memset(f->x, 0, (size_t)f->p[f->n] * 36 * sizeof *f->x);
}

#ifdef SP_REAL_MIXED
/* to <- sum of l z, entry by entry, over the blocks of column k, of which l is a column: compilers at -O2 take four floats at
 * a time. */
SP__NOINLINE static void sp__bchol_products(const sp__bchol *f, int32_t k, int c, sp__low to[6])
{
    sp__low z0 = 0, z1 = 0, z2 = 0, z3 = 0, z4 = 0, z5 = 0;
    for (int32_t q = f->p[k]; q < f->p[k + 1]; q++) {
        const sp__low *z = f->z + 6 * (size_t)f->i[q], *l = f->x + 36 * (size_t)q + 6 * c;
        z0 += l[0] * z[0]; z1 += l[1] * z[1]; z2 += l[2] * z[2]; z3 += l[3] * z[3]; z4 += l[4] * z[4]; z5 += l[5] * z[5];
    }
    to[0] = z0; to[1] = z1; to[2] = z2; to[3] = z3; to[4] = z4; to[5] = z5;
}

/* v <- v - sum of L' z over the blocks of column k */
static void sp__bchol_less_below(const sp__bchol *f, int32_t k, sp__low *v)
{
    for (int c = 0; c < 6; c++) {
        sp__low s[6];
        sp__bchol_products(f, k, c, s);
        v[c] -= (s[0] + s[4]) + (s[1] + s[5]) + (s[2] + s[3]);
    }
}
#else
static void sp__bchol_less_below(const sp__bchol *f, int32_t k, sp__low *v)
{
    for (int32_t q = f->p[k]; q < f->p[k + 1]; q++) {
        const sp__low *z = f->z + 6 * (size_t)f->i[q], *l = f->x + 36 * (size_t)q;
        for (int c = 0; c < 6; c++, l += 6)
            v[c] -= l[0] * z[0] + l[1] * z[1] + l[2] * z[2] + l[3] * z[3] + l[4] * z[4] + l[5] * z[5];
    }
}
#endif

/* x <- A^-1 b, both 6 n in the caller's row order; x may be b. */
SP__NOINLINE static void sp__bchol_solve(const sp__bchol *f, const sp_real *b, sp_real *x)
{
    sp__low *t = f->z;
    for (int32_t k = 0; k < f->n; k++)
        for (int r = 0; r < 6; r++) t[6 * (size_t)k + (size_t)r] = (sp__low)b[6 * (size_t)f->perm[k] + (size_t)r];
    for (int32_t k = 0; k < f->n; k++) {                                        /* L z = b */
        sp__low *v = t + 6 * (size_t)k;
        const sp__low *d = f->d + 21 * (size_t)k;
        for (int c = 0; c < 6; c++) {
            const sp__low *dc = d + sp__column[c];
            v[c] *= (sp__low)sp__abs((sp_real)*dc);
            for (int r = c + 1; r < 6; r++) v[r] -= dc[r - c] * v[c];
        }
        for (int32_t q = f->p[k]; q < f->p[k + 1]; q++) {
            sp__low *z = t + 6 * (size_t)f->i[q];
            const sp__low *l = f->x + 36 * (size_t)q;
            sp__low z0 = z[0], z1 = z[1], z2 = z[2], z3 = z[3], z4 = z[4], z5 = z[5];
            for (int c = 0; c < 6; c++, l += 6) { SP__LESS6(l, v[c]); }
            z[0] = z0; z[1] = z1; z[2] = z2; z[3] = z3; z[4] = z4; z[5] = z5;
        }
    }
    for (int32_t k = f->n - 1; k >= 0; k--) {                                   /* L' x = z */
        sp__low *v = t + 6 * (size_t)k;
        const sp__low *d = f->d + 21 * (size_t)k;
        sp__bchol_less_below(f, k, v);
        for (int c = 5; c >= 0; c--) {
            const sp__low *dc = d + sp__column[c];
            for (int r = c + 1; r < 6; r++) v[c] -= dc[r - c] * v[r];
            v[c] *= (sp__low)sp__abs((sp_real)*dc);
        }
    }
    for (int32_t k = 0; k < f->n; k++)
        for (int r = 0; r < 6; r++) x[6 * (size_t)f->perm[k] + (size_t)r] = (sp_real)t[6 * (size_t)k + (size_t)r];
}

#endif
#endif /* SP__BCHOL_C */
