/* factor: L L' = Aeq S DP Aeq' + shift, and x = (L L')^-1 b.
 *
 * Four ways behind one face: blocks of 6 x 6, of 3 x 3 in a reduced search, one dense triangle where a stage asks for it, and
 * with SP_REAL_MIXED a factor in float that conjugate gradients refine.                                 [Polak, Ribiere 1969]
 */
#ifndef SP__STATICS_FACTOR_C
#define SP__STATICS_FACTOR_C

#include "../linear/chol.c"
#include "hessian.c"

#if SP__WITH_LARGE

#ifdef SP_REAL_MIXED
/* L <- T A T + 2 u, u and L of the factor's precision, T = diag(A)^-1/2 (1 where that is 0): no number leaves the range of a
 * float, and motions that A hardly resists are all slowed down alike. Pivots dropped one by one would tear them apart, and
 * conjugate gradients would find each anew. Before that A's diagonal grows by its own `own`. */
SP__NOINLINE static void sp__system_to_float(sp__system *w, sp_real own)
{
    const sp__bchol *L = &w->L;
    sp__bchol_zero(&w->L);
    for (size_t k = 0; k < (size_t)L->n; k++) {
        sp_real *d = w->mixed.diagonal + 21 * k, *t = w->mixed.scale + 6 * k;
        sp__low *to = L->d + 21 * k;
        for (int c = 0; c < 6; c++) {
            sp_real *pivot = d + sp__column[c];
            *pivot += own * *pivot;
            t[c] = *pivot > 0 ? 1 / SP_SQRT(*pivot) : 1;
        }
        for (int c = 0; c < 6; c++) {
            for (int r = c; r < 6; r++) to[sp__column[c] + r - c] = (sp__low)(d[sp__column[c] + r - c] * t[c] * t[r]);
            to[sp__column[c]] += 2 * SP__LOW_EPSILON;
        }
    }
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        if (w->slot[c] == INT32_MIN) continue;
        const int32_t a = L->inv[w->pb->contact[c].a], b = L->inv[w->pb->contact[c].b], first = a < b ? a : b;
        const sp_real *A = sp__system_coupling(w, c), *T = w->mixed.scale;
        const sp_real *col = T + 6 * (size_t)first, *row = T + 6 * (size_t)(a + b - first);
        sp__low *to = L->x + 36 * (size_t)(w->slot[c] < 0 ? -1 - w->slot[c] : w->slot[c]);
        for (int k = 0; k < 36; k++) to[k] += (sp__low)(A[k] * col[k / 6] * row[k % 6]);
    }
}

/* y <- A x, in the caller's order of rows. */
SP__NOINLINE static void sp__system_times(const sp__system *w, const sp_real *x, sp_real *y)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *d = sp__system_diagonal(w, i), *xi = x + 6 * (size_t)i;
        sp_real *yi = y + 6 * (size_t)i;
        for (int r = 0; r < 6; r++) yi[r] = 0;
        for (int c = 0; c < 6; c++)
            for (int r = c; r < 6; r++) {
                const sp_real a = d[sp__column[c] + r - c];
                yi[r] += a * xi[c];
                if (r > c) yi[c] += a * xi[r];
            }
    }
    for (int32_t k = 0; k < pb->contacts; k++) {
        if (w->slot[k] == INT32_MIN) continue;
        const size_t a = (size_t)pb->contact[k].a, b = (size_t)pb->contact[k].b, first = w->L.inv[a] < w->L.inv[b] ? a : b;
        const sp_real *block = sp__system_coupling(w, k), *xc = x + 6 * first, *xr = x + 6 * (a + b - first);
        sp_real *yc = y + 6 * first, *yr = y + 6 * (a + b - first);
        sp_real z0 = yr[0], z1 = yr[1], z2 = yr[2], z3 = yr[3], z4 = yr[4], z5 = yr[5];
        for (int c = 0; c < 6; c++, block += 6) {
            const sp_real *l = block, t = xc[c];
            z0 += l[0] * t; z1 += l[1] * t; z2 += l[2] * t; z3 += l[3] * t; z4 += l[4] * t; z5 += l[5] * t;
            yc[c] += l[0] * xr[0] + l[1] * xr[1] + l[2] * xr[2] + l[3] * xr[3] + l[4] * xr[4] + l[5] * xr[5];
        }
        yr[0] = z0; yr[1] = z1; yr[2] = z2; yr[3] = z3; yr[4] = z4; yr[5] = z5;
    }
}
#endif

/* A contact's H = h of vv, vw, ww in its own frame as 3 x 3 in X. */
static void sp__reduction_project(const sp__reduction *o, const sp_real *g, const sp_real *h, sp_real *H)
{
    const sp_real *vv = h, *vw = h + 9, *ww = h + 18, x = g[2], y = g[3];
    if (o->mode == SP__PLANE) {
        H[0] = vv[0];
        H[1] = H[3] = vv[1] * x + vv[2] * y;
        H[4] = (vv[4] * x + 2 * vv[5] * y) * x + vv[8] * y * y;
        H[2] = H[6] = vw[2] * x - vw[1] * y;
        H[5] = H[7] = (vw[5] * x - vw[4] * y) * x + (vw[8] * x - vw[7] * y) * y;
        H[8] = (ww[8] * x - 2 * ww[5] * y) * x + ww[4] * y * y;
        return;
    }
    const sp_real p = ww[4] * g[0] + ww[5] * g[1], q = ww[5] * g[0] + ww[8] * g[1];
    H[0] = vv[0];
    H[1] = H[3] = vw[1] * g[0] + vw[2] * g[1];
    H[2] = H[6] = vw[1] * x + vw[2] * y;
    H[4] = p * g[0] + q * g[1];
    H[5] = H[7] = p * x + q * y;
    H[8] = (ww[4] * x + 2 * ww[5] * y) * x + ww[8] * y * y;
}

/* out = H T by columns, H symmetric. */
static void sp__reduction_right(const sp_real H[9], const sp_real T[7], sp_real out[9])
{
    for (int r = 0; r < 3; r++) {
        const sp_real h0 = H[r], h1 = H[3 + r], h2 = H[6 + r];
        out[r] = T[0] * h0 + T[1] * h1;
        out[3 + r] = T[2] * h0 + T[3] * h1;
        out[6 + r] = T[4] * h0 + T[5] * h1 + T[6] * h2;
    }
}

/* y = T' x */
static inline void sp__reduction_left(const sp_real T[7], const sp_real x[3], sp_real y[3])
{
    y[0] = T[0] * x[0] + T[1] * x[1];
    y[1] = T[2] * x[0] + T[3] * x[1];
    y[2] = T[4] * x[0] + T[5] * x[1] + T[6] * x[2];
}

/* Contact c's H into L: T' H T, of a diagonal block the upper triangle, which is kept as columns of the lower one. */
SP__NOINLINE static void sp__reduction_add(sp__system *w, int32_t c, const sp_real H[9])
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *T = sp__reduction_frame(w, t) + 6;
    sp_real (*X)[9] = w->scratch->of.HT, y[3];
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        sp__reduction_right(H, T + 7 * side, X[side]);
        sp_real *d = sp__bchol_d(&w->L) + 6 * (size_t)w->L.inv[i];
        sp__reduction_left(T + 7 * side, X[side], y);
        d[0] += y[0];
        sp__reduction_left(T + 7 * side, X[side] + 3, y);
        d[1] += y[0]; d[3] += y[1];
        sp__reduction_left(T + 7 * side, X[side] + 6, y);
        d[2] += y[0]; d[4] += y[1]; d[5] += y[2];
    }
    if (w->slot[c] == INT32_MIN) return;
    const int turn = w->slot[c] < 0;
    sp_real *x = sp__bchol_x(&w->L) + 9 * (size_t)(turn ? -1 - w->slot[c] : w->slot[c]);
    for (int q = 0; q < 3; q++, x += 3) {
        sp__reduction_left(T + 7 * turn, X[!turn] + 3 * q, y);
        x[0] += y[0]; x[1] += y[1]; x[2] += y[2];
    }
}

/* sp__system_assemble in 3 rows a block. */
SP__NOINLINE static void sp__reduction_assemble(sp__system *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp_problem *pb = w->pb;
    sp_real *H = w->scratch->H3;
    sp__bchol_zero(&w->L);
    for (int32_t c = 0; c < pb->contacts; c++) {
        if (law == SP__INTERIOR ? sp__ipm_narrow(w) : law != SP__GIVEN && sp__system_yield(w, c)->plain)
            sp__wedge_hessian(w, law, c, y, H);
        else if (sp__system_contact_hessian(w, law, c, y))
            sp__reduction_project(w->reduction, sp__reduction_frame(w, &pb->contact[c]), w->scratch->H, H);
        else continue;
        sp__reduction_add(w, c, H);
    }
    for (size_t k = 0; k < (size_t)pb->blocks; k++)
        for (int q = 0; q < 3; q++) sp__bchol_d(&w->L)[6 * k + sp__column3[q]] += shift;
}

/* x <- (L L')^-1 b in 3 rows a block; the other rows of x become 0. */
static void sp__reduction_solve(sp__system *w, const sp_real *b, sp_real *x)
{
    sp_real *t = w->L.t;
    for (size_t k = 0; k < (size_t)w->L.n; k++)
        for (int r = 0; r < 3; r++) t[3 * k + (size_t)r] = b[6 * (size_t)w->L.perm[k] + sp__reduction_row(w->reduction, r)];
    sp__bchol3_solve(&w->L, t);
    memset(x, 0, 6 * (size_t)w->L.n * sizeof *x);
    for (size_t k = 0; k < (size_t)w->L.n; k++)
        for (int r = 0; r < 3; r++) x[6 * (size_t)w->L.perm[k] + sp__reduction_row(w->reduction, r)] = t[3 * k + (size_t)r];
}

/* The assembled blocks as one dense lower triangle, in elimination order. */
static void sp__system_densify(sp__system *w)
{
    const sp__bchol *L = &w->L;
    const size_t n = 6 * (size_t)L->n;
    memset(w->dense, 0, n * (n + 1) / 2 * sizeof *w->dense);
    for (int32_t k = 0; k < L->n; k++)
        for (int32_t q = L->p[k] - 1; q < L->p[k + 1]; q++) {
            const int diagonal = q < L->p[k];
            const int32_t i = diagonal ? k : L->i[q];
            const sp__low *block = diagonal ? L->d + 21 * (size_t)k : L->x + 36 * (size_t)q;
            for (size_t r = 0; r < 6; r++)
                for (size_t c = 0; c < (diagonal ? r + 1 : 6); c++) {
                    const size_t row = 6 * (size_t)i + r;
                    w->dense[row * (row + 1) / 2 + 6 * (size_t)k + c]
                        = (sp_real)block[diagonal ? sp__column[c] + r - c : 6 * c + r];
                }
        }
}

/* sp__system_factor in 3 rows a block, in full precision. */
static void sp__reduction_factor(sp__system *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp_real floor = 4 * (sp_real)SP_EPSILON;
    sp__reduction_assemble(w, law, y, law == SP__INTERIOR ? 0 : shift);
    sp__system_factorisation(w);
    const int balanced = SP__WITH_INTERIOR && law == SP__INTERIOR;
    if (balanced) sp__bchol_balance(&w->L, shift);
    sp__bchol3_factor(&w->L, floor, w->set->parallel);
    if (balanced) sp__bchol_unbalance(&w->L);
}

/* L L' = Aeq S DP Aeq' + shift; for the interior law, whose rows differ by orders, shift times its own diagonal. */
SP__NOINLINE static void sp__system_factor(sp__system *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp__low floor = 4 * (sp__low)SP__LOW_EPSILON;
    const int64_t n = 6 * (int64_t)w->L.n, own = w->dense ? n * n * 2 * w->L.n : w->L.flops;
    const int narrow = sp__reduced(w) && w->reduction->no_strength && law != SP__GIVEN;
    if (!sp__system_spend(w, own) || !sp__system_assembly(w, narrow)) return;
    if (sp__reduced(w)) { sp__reduction_factor(w, law, y, shift); return; }
    sp__system_assemble(w, law, y, law == SP__INTERIOR ? 0 : shift);
    sp__system_factorisation(w);
#ifdef SP_REAL_MIXED
    sp__system_to_float(w, law == SP__INTERIOR ? shift : 0);
#else
    if (SP__WITH_INTERIOR && law == SP__INTERIOR) {
        sp__bchol_balance(&w->L, shift);
        sp__bchol_factor(&w->L, floor, w->set->parallel);
        sp__bchol_unbalance(&w->L);
        return;
    }
#endif
    if (w->dense) {
        sp__system_densify(w);
        sp__chol_factor(w->dense, 6 * w->L.n, (sp_real)floor);
    } else sp__bchol_factor(&w->L, floor, w->set->parallel);
}

/* x <- (L L')^-1 b; x may be b. */
static void sp__system_substitute(sp__system *w, const sp_real *b, sp_real *x)
{
    const size_t n = 6 * (size_t)w->L.n;
    if (!w->dense) { sp__bchol_solve(&w->L, b, x); return; }
    for (size_t k = 0; k < n; k++) w->L.t[k] = b[6 * (size_t)w->L.perm[k / 6] + k % 6];
    sp__chol_solve(w->dense, 6 * w->L.n, w->L.t);
    for (size_t k = 0; k < n; k++) x[6 * (size_t)w->L.perm[k / 6] + k % 6] = w->L.t[k];
}

/* Flops of one solution by the factor. */
static int64_t sp__system_solve_flops(const sp__system *w)
{
    const int64_t n = 6 * (int64_t)w->L.n;
    return w->dense ? 2 * n * n : (144 * (int64_t)w->L.p[w->L.n] + 12 * n) / (w->L.rows == 3 ? 4 : 1);
}

#ifdef SP_REAL_MIXED
/* z <- T (L L')^-1 T r, in the range of a float whatever the size of r, unless |T r| <= enough.
 * returns the largest |T r|, paid: the factor's part; z <- 0 where it is not */
static sp_real sp__system_precondition(sp__system *w, const sp_real *r, sp_real enough, sp_real *z)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real most = 0;
    for (size_t k = 0; k < n; k++) {
        z[k] = r[k] * w->mixed.scale[6 * (size_t)w->L.inv[k / 6] + k % 6];
        most = sp__max(most, sp__abs(z[k]));
    }
    if (!(most > enough)) return most;
    if (!sp__system_spend(w, sp__system_solve_flops(w))) { memset(z, 0, n * sizeof *z); return 0; }
    for (size_t k = 0; k < n; k++) z[k] /= most;
    sp__system_substitute(w, z, z);
    for (size_t k = 0; k < n; k++) z[k] *= w->mixed.scale[6 * (size_t)w->L.inv[k / 6] + k % 6] * most;
    return most;
}

/* x <- A^-1 b, x may be b, but for `left` of the residual, by conjugate gradients with the factor as preconditioner: two steps,
 * and where A is nearly singular one more for every null vector, which floats can't tell from another. Directions are made
 * orthogonal to the last one only in A [Polak, Ribiere 1969]: L is not exactly what it solves. x <- 0 where not one step is
 * paid for. */
static void sp__system_solve_to(sp__system *w, sp_real left, const sp_real *b, sp_real *x)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real *p = w->mixed.cg, *q = p + n, *z = q + n, *r = z + n;
    if (sp__reduced(w)) {
        if (sp__system_spend(w, sp__system_solve_flops(w))) sp__reduction_solve(w, b, x);
        else memset(x, 0, n * sizeof *x);
        return;
    }
    memcpy(r, b, n * sizeof *r);
    memset(x, 0, n * sizeof *x);
    const sp_real enough = sp__max(left, SP__REFINED) * sp__system_precondition(w, r, 0, p);
    sp_real rz = sp__dot(r, p, n);
    for (int it = 0; it < SP__REFINE && rz > 0; it++) {
        if (!sp__system_spend(w, 144 * (int64_t)w->pb->contacts + 180 * (int64_t)w->L.n)) return;
        sp__system_times(w, p, q);
        const sp_real pq = sp__dot(p, q, n);
        if (!(pq > 0)) return;
        const sp_real alpha = rz / pq;
        for (size_t k = 0; k < n; k++) { x[k] += alpha * p[k]; r[k] -= alpha * q[k]; }
        if (!(sp__system_precondition(w, r, enough, z) > enough)) return;
        const sp_real beta = -alpha * sp__dot(z, q, n) / rz;
        for (size_t k = 0; k < n; k++) p[k] = z[k] + beta * p[k];
        rz = sp__dot(r, z, n);
    }
}

/* Nine digits of the residual are enough, who wants more solves again for what is left; with eight, a needle of 1e4 : 1 at its
 * limit takes ten times the factors. */
static void sp__system_solve(sp__system *w, const sp_real *b, sp_real *x) { sp__system_solve_to(w, 0, b, x); }

/* x <- A^-1 b as well as the factor alone can tell; x is not b. */
static void sp__system_solve_roughly(sp__system *w, const sp_real *b, sp_real *x)
{
    if (sp__reduced(w)) sp__system_solve(w, b, x);
    else sp__system_precondition(w, b, 0, x);
}
#else
/* x <- (L L')^-1 b; x may be b. x <- 0 where that is no longer paid for. */
static void sp__system_solve(sp__system *w, const sp_real *b, sp_real *x)
{
    const int paid = sp__system_spend(w, sp__system_solve_flops(w));
    if (paid && sp__reduced(w)) sp__reduction_solve(w, b, x);
    else if (paid) sp__system_substitute(w, b, x);
    else memset(x, 0, 6 * (size_t)w->L.n * sizeof *x);
}

/* The same: such a factor leaves rounding. */
static void sp__system_solve_to(sp__system *w, sp_real left, const sp_real *b, sp_real *x)
{
    (void)left;
    sp__system_solve(w, b, x);
}

static void sp__system_solve_roughly(sp__system *w, const sp_real *b, sp_real *x) { sp__system_solve(w, b, x); }
#endif

#endif

#endif /* SP__STATICS_FACTOR_C */
