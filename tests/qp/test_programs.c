/* Work of drawn programs: sums over a few of a kind, counted as test_steps.c counts those of one size that are all well. These
 * have rows that say the same, rows and columns of any scale, bounds on either side or none, columns without entries, a flat P
 * or none, no solution, or a bottomless one; they are asked by every setting that takes another way, with too little to spend,
 * from guesses, and again after changes. */
#include "../scenes/tally.h"

#if defined TALLY_ALL && COUNTED
enum { N = 12, M = 14 };

/* P: positive, of low rank, none, diagonal. Bits: no solution, no bottom, many equations, a P that falls along some line. */
enum { ROUND, FLAT, LINEAR, DIAGONAL, SHAPE = 3, EMPTY = 4, DEEP = 8, TIED = 16, SADDLE = 32 };

typedef enum how {
    USUAL, ADMM, INTERIOR, DENSE, DENSE_ADMM, BY_CG, PLAIN, PLAIN_ADMM, LOOSE, TIGHT, RESIDUALS, UNSCALED, ONE_PASS, FIXED_RHO,
    OFTEN, RELAXED, EACH_STEP, CG_SHORT, DYKSTRA, HOWS
} how;

typedef struct program {
    sp_qp qp;
    int32_t Pp[N + 1], Pi[N * N], Ap[N + 1], Ai[N * M];
    sp_real Px[N * N], Ax[N * M], q[N], l[M], u[M], x[N], y[M];
} program;

/* A program before it is written by columns. */
typedef struct dense { int n, m; double P[N][N], A[M][N], q[N], l[M], u[M], x[N], y[M]; } dense;

/* `count` programs of a kind from number `first` on, rows and columns by up to 10^-spread .. 10^spread. is.kind: how many ended
 * solved, and ten times those inaccurate, and so on. */
typedef struct drawn { int kind, first, count, spread, how; tally is; } drawn;

typedef struct sum { int kind; sp_cost cost; size_t bytes; double found[TALLY_FOUND]; } sum;

static program p;
static uint32_t draws;

static double any(double low, double high) { return test_draw(&draws, low, high); }
static int chance(double of) { return any(0, 1) < of; }

/* 10^low .. 10^high, by products alone: the same on every machine. */
static double tens(int low, int high)
{
    const int k = (int)any(low, high + 1);
    double x = any(0.5, 5);
    for (int i = 0; i < k; i++) x *= 10;
    for (int i = 0; i > k; i--) x /= 10;
    return x;
}

static double scale(int spread) { return spread && chance(0.5) ? tens(-spread, spread) : 1; }

/* A row of numbers, or an earlier one times some number. */
static void draw_row(dense *d, int i, double full)
{
    const int from = chance(0.15) ? (int)any(0, i) : i;
    const double times = any(-2, 2);
    for (int j = 0; j < d->n; j++) d->A[i][j] = from < i ? times * d->A[from][j] : chance(full) ? any(-1, 1) : 0;
}

/* Bounds about z = a x: an equation, none, one, two, near or far; the multiplier y of one that is met. */
static void draw_bounds(dense *d, int i, int kind)
{
    const double what = any(0, 1), below = chance(0.4) ? 0 : any(0, 2), above = chance(0.4) ? 0 : any(0, 2);
    const int equation = what < (kind & TIED ? 0.5 : 0.15), l = what < 0.65, u = what < 0.4 || (what > 0.65 && what < 0.9);
    double z = 0;
    for (int j = 0; j < d->n; j++) z += d->A[i][j] * d->x[j];
    d->l[i] = equation ? z : l ? z - below : -1e30;
    d->u[i] = equation ? z : u ? z + above + (l && below <= 0 && above <= 0 ? 0.5 : 0) : 1e30;
    d->y[i] = chance(0.3) ? 0 : any(0, 1);
    if (equation) d->y[i] = 2 * d->y[i] - 1;
    else if (l && below <= 0) d->y[i] = -d->y[i];
    else if (!u || above > 0 || l) d->y[i] = 0;
}

/* P = G G' of some rank. */
static void draw_P(dense *d, int kind)
{
    const int shape = kind & SHAPE, n = d->n, rank = shape == LINEAR ? 0 : shape == FLAT ? (n + 1) / 3 : n;
    const double full = any(0.2, 1);
    for (int r = 0; r < rank; r++) {
        double g[N];
        for (int j = 0; j < n; j++)
            g[j] = shape == DIAGONAL ? (j == r) * any(0.3, 1.5) : chance(full) || j == r ? any(-1, 1) : 0;
        for (int i = 0; i < n; i++) for (int j = 0; j < n; j++) d->P[i][j] += g[i] * g[j];
    }
    for (int j = 0; j < n; j++) if (shape == ROUND) d->P[j][j] += 0.1;
    if (!(kind & SADDLE)) return;
    const double by = tens(-11, 0);
    double g[N];
    for (int j = 0; j < n; j++) g[j] = shape == DIAGONAL ? j == n / 8 : any(-1, 1);
    for (int i = 0; i < n; i++) for (int j = 0; j < n; j++) d->P[i][j] -= by * g[i] * g[j];
}

/* The last row is against the sum of two others, by a hair or more. */
static void draw_empty(dense *d)
{
    const int m = d->m - 1, a = (int)any(0, m), b = (int)any(0, m);
    for (int j = 0; j < d->n; j++) d->A[m][j] = d->A[a][j] + d->A[b][j];
    d->u[a] = fmin(d->u[a], 5);
    d->u[b] = fmin(d->u[b], 5);
    d->l[m] = d->u[a] + d->u[b] + tens(-3, 0);
    d->u[m] = 1e30;
}

/* Down for ever along x: nothing is in the way. */
static void draw_deep(dense *d)
{
    double size = 0, along = 0, down = 0;
    for (int j = 0; j < d->n; j++) { size += d->x[j] * d->x[j]; down += d->q[j] * d->x[j]; }
    for (int i = 0; i < d->m; i++) {
        along = 0;
        for (int j = 0; j < d->n; j++) along += d->A[i][j] * d->x[j];
        if (along > 0) { d->l[i] = fmin(d->l[i], 1e10); d->u[i] = 1e30; }
        else d->l[i] = -1e30;
    }
    for (int j = 0; j < d->n; j++) d->q[j] -= (down + any(0.01, 1)) / size * d->x[j];
    for (int k = 0; k < 2; k++)                         /* P <- (I - x x' / |x|^2) P, then its transpose */
        for (int i = 0; i < d->n; i++) {
            double Px = 0;
            for (int j = 0; j < d->n; j++) Px += (k ? d->P[j][i] : d->P[i][j]) * d->x[j];
            for (int j = 0; j < d->n; j++) *(k ? &d->P[j][i] : &d->P[i][j]) -= Px / size * d->x[j];
        }
}

/* Rows and columns by their scales; q so that x, y is a solution, but where there is none. */
static void draw_rest(dense *d, int kind, int spread)
{
    double by[N];
    for (int j = 0; j < d->n; j++) by[j] = scale(spread);
    for (int j = 0; j < d->n; j++) {
        for (int i = 0; i < d->n; i++) d->q[j] -= d->P[i][j] * d->x[i];
        for (int i = 0; i < d->m; i++) d->q[j] -= d->A[i][j] * d->y[i];
    }
    if (kind & EMPTY && d->m > 2) draw_empty(d);
    if (kind & DEEP) draw_deep(d);
    for (int i = 0; i < d->m; i++) {
        const double row = scale(spread > 6 ? 3 : spread); /* bounds stay below 1e20 */
        for (int j = 0; j < d->n; j++) d->A[i][j] *= row * by[j];
        if (d->l[i] > -1e29) d->l[i] *= row;
        if (d->u[i] < 1e29) d->u[i] *= row;
        d->y[i] /= row;
    }
    for (int j = 0; j < d->n; j++) {
        for (int i = 0; i < d->n; i++) d->P[i][j] *= by[i] * by[j];
        d->q[j] *= by[j];
        d->x[j] /= by[j];
    }
}

static int there(double x) { return x > 0 || x < 0; }

/* By columns; where n is even some entries of P that are 0 are written, too, but where all are. */
static void write_columns(const dense *d)
{
    int32_t e = 0, f = 0, some = 0;
    for (int j = 0; j < d->n; j++) some |= d->n % 2 == 0 && there(d->P[j][j]);
    for (int j = 0; j < d->n; j++) {
        p.Pp[j] = e;
        p.Ap[j] = f;
        for (int i = 0; i <= j; i++)
            if (there(d->P[i][j]) || (some && i < j && (i + j) % 4 == 3)) { p.Pi[e] = i; p.Px[e++] = R(d->P[i][j]); }
        for (int i = 0; i < d->m; i++) if (there(d->A[i][j])) { p.Ai[f] = i; p.Ax[f++] = R(d->A[i][j]); }
        p.q[j] = R(d->q[j]);
        p.x[j] = R(d->x[j]);
    }
    p.Pp[d->n] = e;
    p.Ap[d->n] = f;
    for (int i = 0; i < d->m; i++) { p.l[i] = R(d->l[i]); p.u[i] = R(d->u[i]); p.y[i] = R(d->y[i]); }
    const sp_qp made = { d->n, d->m, p.Pp, p.Pi, p.Px, p.q, p.Ap, p.Ai, p.Ax, p.l, p.u };
    p.qp = made;
    if (!e) { p.qp.Pp = p.qp.Pi = NULL; p.qp.Px = NULL; }
    if (!d->m) { p.qp.Ap = p.qp.Ai = NULL; p.qp.Ax = p.qp.l = p.qp.u = NULL; }
}

static void draw(int kind, int number, int spread)
{
    static dense d;
    memset(&d, 0, sizeof d);
    draws = 2654435761u * (uint32_t)(number + 1) ^ 40503u * (uint32_t)(kind + 1);
    for (int k = 0; k < 8; k++) any(0, 1);
    d.n = (int)any(2, N + 1);
    d.m = kind & EMPTY ? (int)any(3, M + 1) : chance(0.08) ? 0 : (int)any(1, M + 1);
    const double full = any(0.2, 1), none = chance(0.3) ? 0.2 : 0;
    for (int j = 0; j < d.n; j++) d.x[j] = any(-1, 1);
    for (int i = 0; i < d.m; i++) draw_row(&d, i, full);
    for (int j = 0; j < d.n; j++)
        if (chance(none)) for (int i = 0; i < d.m; i++) d.A[i][j] = 0;
    draw_P(&d, kind);
    for (int i = 0; i < d.m; i++) draw_bounds(&d, i, kind);
    draw_rest(&d, kind, spread);
    write_columns(&d);
}

static sp_qp_settings asked(int by)
{
    sp_qp_settings set = sp_qp_default();
    if (by == ADMM || by == DENSE_ADMM || by == PLAIN_ADMM || by >= RESIDUALS) set.method = SP_QP_ADMM;
    if (by == INTERIOR) set.method = SP_QP_INTERIOR;
    if (by == DENSE || by == DENSE_ADMM) set.backend = SP_QP_DENSE;
    if (by == BY_CG || by == CG_SHORT) set.backend = SP_QP_CG;
    if (by == PLAIN || by == PLAIN_ADMM) set.polish = 0;
    if (by == LOOSE || by == TIGHT) set.eps_abs = set.eps_rel = R(by == LOOSE ? 1e-3 : 1e-10);
    if (by == LOOSE || by == RESIDUALS) set.strict = 0;
    if (by == UNSCALED || by == ONE_PASS) set.passes = by == ONE_PASS;
    if (by == FIXED_RHO) { set.adapt = 0; set.eps_pinf = set.eps_dinf = R(1e-6); }
    if (by == OFTEN) { set.adapt = 20; set.adapt_factor = R(2.5); set.adapt_most = 3; set.iterations = 800; }
    if (by == RELAXED) { set.relax = 1; set.sigma = R(1e-3); set.rho = 10; set.rho_equal = 1; set.radius = 1; }
    if (by == EACH_STEP) { set.check = set.adapt = 1; set.iterations = 300; set.polish = 0; }
    if (by == CG_SHORT) { set.cg_steps = 3; set.cg_tol = R(1e-3); }
    if (by != EACH_STEP) set.iterations = (int)fmin(set.iterations, 1000);
    return set;
}

static sp_qp_solver solver(int by)
{
    return by == DYKSTRA ? sp_qp_dykstra() : by == INTERIOR ? sp_qp_interior() : sp_qp_admm();
}

/* |x| of n numbers of any size. */
static double size_of(const sp_real *x, int32_t n)
{
    double most = 0, squares = 0;
    for (int32_t k = 0; k < n; k++) most = fmax(most, fabs((double)x[k]));
    for (int32_t k = 0; k < n && most > 0; k++) squares += (double)x[k] / most * ((double)x[k] / most);
    return most * sqrt(squares);
}

static int nonzero(const sp_real *x, int32_t n)
{
    int count = 0;
    for (int32_t k = 0; k < n; k++) count += x[k] > 0 || x[k] < 0;
    return count;
}

/* interior: those polished. */
static void add(sum *t, const sp_qp_result *r)
{
    const sp_cost cost = { r->flops, r->factorisations, r->iterations, r->polished };
    int of = 1;
    for (int k = 0; k < (int)r->status; k++) of *= 10;
    t->kind += of;
    tally_add(&t->cost, &cost);
    t->found[0] += size_of(r->x, p.qp.n) + nonzero(r->x, p.qp.n) + (double)r->rho;
    t->found[1] += size_of(r->y, p.qp.m) + nonzero(r->y, p.qp.m);
    t->found[2] += (double)r->objective;
    t->found[3] += fmin((double)r->primal, 1e9) + fmin((double)r->dual, 1e9) + fmin((double)r->gap, 1e9);
    t->found[4] += fmin((double)r->radius, 1e17);
}

typedef void question(const drawn *d, sum *t);

/* One answer more to *t; what is refused is an answer, too. Memory is what was said before; nothing is written behind it. */
static sp_qp_result ask(int by, const sp_qp_settings *set, const sp_real *x0, const sp_real *y0, sum *t)
{
    const sp_qp_solver use = solver(by);
    const int own = by == USUAL || by == DENSE || by == PLAIN;
    size_t bytes = 0;
    sp_qp_result r;
    memset(&r, 0, sizeof r);
    test_arena.used = test_arena.peak = 0;
    const sp_status known = own ? sp_qp_memory(&p.qp, set, test_arena, &bytes) : use.need(NULL, &p.qp, set, test_arena, &bytes);
    uint64_t *behind = (uint64_t *)test_arena.base + (bytes + 7) / 8;
    behind[0] = behind[1] = 0x3d3d3d3d3d3d3d3du;
    const sp_status done = own ? sp_qp_solve(&p.qp, set, &test_arena, x0, y0, &r)
                               : use.solve(NULL, &p.qp, set, &test_arena, x0, y0, &r);
    CHECK(known == SP_OK && behind[0] == 0x3d3d3d3d3d3d3d3du && behind[1] == 0x3d3d3d3d3d3d3d3du);
    t->bytes += bytes;
    if (done == SP_OK && CHECK_INT(test_arena.peak, bytes)) add(t, &r);
    else t->kind -= (int)done;
    return r;
}

static void solve_it(const drawn *d, sum *t)
{
    const sp_qp_settings set = asked(d->how);
    ask(d->how, &set, NULL, NULL, t);
    t->bytes += sp_qp_memory_scratch(&p.qp, &set);
}

static void compare(const drawn *rows, size_t n, question *put)
{
    for (size_t k = 0; k < n; k++) {
        sum t;
        memset(&t, 0, sizeof t);
        for (int i = 0; i < rows[k].count; i++) {
            test_renew();
            draw(rows[k].kind, rows[k].first + i, rows[k].spread);
            put(&rows[k], &t);
        }
        tally_compare("programs", k, &rows[k].is, t.kind, &t.cost, t.bytes, t.found);
    }
}

#define COMPARE(rows, put) compare(rows, sizeof (rows) / sizeof *(rows), put)

/* With each part of what it takes, from an eighth on, and with next to nothing. */
static void spend_it(const drawn *d, sum *t)
{
    sp_qp_settings set = asked(d->how);
    const int64_t all = ask(d->how, &set, NULL, NULL, t).flops;
    for (int k = 0; k < 9; k++) {
        set.budget = k ? all * k / 8 : 1;
        ask(d->how, &set, NULL, NULL, t);
    }
}

/* With 80 budgets about what 100 iterations take. */
static void spend_near(const drawn *d, sum *t)
{
    sp_qp_settings set = asked(d->how);
    set.iterations = 100;
    const int64_t all = ask(d->how, &set, NULL, NULL, t).flops;
    for (int k = 0; k < 80; k++) {
        set.budget = all - all / 8 + all * k / 320;
        ask(d->how, &set, NULL, NULL, t);
    }
}

/* From x, y that are about right, or one of both, or none, with no more than so many iterations. */
static void guess_it(const drawn *d, sum *t)
{
    static const int most[4] = { 1, 7, 150, 250 };
    sp_qp_settings set = asked(d->how);
    for (int j = 0; j < p.qp.n; j++) p.x[j] *= R(any(0.99, 1.01));
    for (int k = 0; k < 16; k++) {
        set.iterations = most[k / 4];
        ask(d->how, &set, k % 2 ? p.x : NULL, k % 4 < 2 ? p.y : NULL, t);
    }
}

/* From where products overflow. */
static void far_it(const drawn *d, sum *t)
{
    const sp_qp_settings set = asked(d->how);
    for (int far = 140; far < 300; far += 40) {
        sp_real x[N], y[M];
        for (int j = 0; j < p.qp.n; j++) x[j] = R(tens(far, far));
        for (int i = 0; i < p.qp.m; i++) y[i] = R(i % 3 ? -tens(far, far) : tens(far, far));
        ask(d->how, &set, far % 3 < 2 ? x : NULL, far % 3 ? y : NULL, t);
    }
}

/* Once as it is; from there with another q and the same rho; with the first row fixed and the least rho; with that row free and
 * another rho; as at first. */
static void change_it(const drawn *d, sum *t)
{
    const sp_qp_settings set = asked(d->how);
    sp_real q[N], l[M], u[M];
    sp_qp_work *work;
    sp_qp_result r;
    for (int j = 0; j < p.qp.n; j++) q[j] = p.q[j] * R(any(0.5, 1.5));
    for (int i = 0; i < p.qp.m; i++) { l[i] = i ? p.l[i] : R(fmax((double)p.l[i], -1)); u[i] = i ? p.u[i] : l[i]; }
    CHECK_INT(sp_qp_setup(&p.qp, &set, &test_arena, &work), SP_OK);
    for (int k = 0; k < 5; k++) {
        if (k == 1) CHECK_INT(sp_qp_update(work, q, NULL, NULL), SP_OK);
        if (k == 2) CHECK_INT(sp_qp_update(work, NULL, l, u), SP_OK);
        if (k == 3) { l[0] = R(-1e30); u[0] = R(1e30); CHECK_INT(sp_qp_update(work, p.q, l, u), SP_OK); }
        if (k == 4) CHECK_INT(sp_qp_update(work, p.q, p.l, p.u), SP_OK);
        if (k) CHECK_INT(sp_qp_rho(work, k == 2 ? R(1e-6) : k == 3 ? 1 : r.rho), SP_OK);
        CHECK_INT(sp_qp_run(work, k ? r.x : NULL, k && k < 4 ? r.y : NULL, &r), SP_OK);
        add(t, &r);
    }
    t->bytes += test_arena.peak;
}

/* eps times a residual over 1, 10, a little less and a little more: solved up to 1, inaccurate up to 10. */
static void near_eps(int by, int kind)
{
    static const double off[6] = { 1, 1.05, 9.5, 10, 10.5, 12 };
    static const sp_qp_status word[6] = { SP_QP_SOLVED, SP_QP_INACCURATE, SP_QP_INACCURATE, SP_QP_INACCURATE,
                                          SP_QP_ITERATIONS, SP_QP_ITERATIONS };
    sp_qp_settings set = asked(by);
    sum t;
    memset(&t, 0, sizeof t);
    set.strict = set.polish = 0;
    set.eps_rel = 0;
    set.iterations = 3;
    for (int number = 0; number < 6; number++) {
        test_renew();
        draw(kind, number, 0);
        set.eps_abs = R(1e-12);
        const sp_qp_result r = ask(by, &set, NULL, NULL, &t);
        const double worst = fmax((double)r.primal, (double)r.dual);
        for (int k = by == DYKSTRA; k < 6 && worst > 1e-6; k++) {      /* those are not at rest yet */
            set.eps_abs = R(worst / off[k]);
            CHECK_INT(ask(by, &set, NULL, NULL, &t).status, word[k]);
        }
    }
}

TEST(drawn_programs_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND, 0, 8, 0, USUAL, { 8, 122, 66, 3, 680703, 56912, { 49.036937, 31.494613, -8.5113794, 4.9961282e-12, 0 } } },
        { ROUND, 100, 8, 0, ADMM, { 8, 73, 410, 8, 646830, 88736, { 68.851755, 33.385214, -12.007858, 1.3926871e-13, 0 } } },
        { ROUND, 200, 8, 0, INTERIOR, { 8, 138, 80, 3, 1346081, 85408,
          { 77.74326, 62.254353, -22.696041, 3.7832376e-11, 0 } } },
        { ROUND, 300, 8, 0, DENSE, { 8, 240, 156, 7, 1742993, 37136, { 73.88979, 48.213604, -16.056342, 1.312756e-11, 0 } } },
        { ROUND, 400, 8, 0, DENSE_ADMM, { 8, 34, 400, 8, 395615, 30064,
          { 58.207699, 25.896327, -9.8589121, 1.0452744e-13, 0 } } },
        { ROUND, 500, 8, 0, BY_CG, { 8, 54, 400, 8, 4653998, 37296, { 80.162221, 31.494508, -28.284356, 2.8871538e-13, 0 } } },
        { FLAT, 600, 8, 0, USUAL, { 8, 57, 44, 0, 411648, 91168, { 73.530706, 58.146347, -8.2185479, 1.0486622e-11, 0 } } },
        { FLAT, 700, 8, 0, ADMM, { 8, 30, 290, 8, 811556, 89184, { 124.041, 28.571029, -10.13894, 3.1793368e-12, 0 } } },
        { FLAT, 800, 8, 0, INTERIOR, { 8, 58, 48, 0, 267833, 62184, { 56.14158, 42.755154, -4.2429813, 7.5684384e-12, 0 } } },
        { FLAT, 900, 8, 0, DENSE, { 8, 206, 159, 6, 1172368, 32024, { 297.34184, 29.26695, -6.4070036, 2.1794633e-12, 0 } } },
        { FLAT, 1000, 8, 0, DENSE_ADMM, { 8, 25, 380, 8, 658357, 33376,
          { 65.763478, 24.223676, -9.795205, 1.4962348e-12, 0 } } },
        { FLAT, 1100, 8, 0, BY_CG, { 8, 26, 270, 8, 1391200, 32160, { 78.59445, 17.024191, -7.5757588, 1.2241962e-13, 0 } } },
        { LINEAR, 1200, 8, 0, USUAL, { 8, 54, 44, 0, 275163, 68648, { 65.836391, 61.175587, 0.026852601, 5.3709581e-12, 0 } } },
        { LINEAR, 1300, 8, 0, ADMM, { 8, 20, 310, 8, 269919, 68320, { 58.37147, 32.723181, -1.4448852, 5.1931587e-14, 0 } } },
        { LINEAR, 1400, 8, 0, INTERIOR, { 8, 59, 49, 0, 252462, 66408, { 73.159453, 84.0032, 0.33350564, 8.7974315e-12, 0 } } },
        { LINEAR, 1500, 8, 0, DENSE, { 8, 165, 217, 5, 1600087, 37144,
          { 53.005787, 22.086965, -0.33545759, 1.5263729e-12, 0 } } },
        { LINEAR, 1600, 8, 0, DENSE_ADMM, { 8, 27, 330, 8, 448036, 34160,
          { 60.027705, 21.563491, -0.58785617, 1.0059683e-13, 0 } } },
        { LINEAR, 1700, 8, 0, BY_CG, { 8, 24, 470, 8, 1559057, 39392, { 67.970013, 32.907649, -3.1733174, 2.748524e-14, 0 } } }
    };
    COMPARE(rows, solve_it);
}

TEST(drawn_programs_asked_otherwise_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND, 2000, 5, 0, PLAIN, { 5, 30, 25, 0, 181858, 50648, { 45.805957, 31.935604, -11.066767, 4.8634485e-05, 0 } } },
        { ROUND, 2100, 5, 0, PLAIN_ADMM, { 5, 5, 200, 0, 180427, 61056,
          { 50.675906, 18.890885, -13.532794, 3.2516458e-05, 0 } } },
        { ROUND, 2200, 5, 0, LOOSE, { 5, 34, 110, 5, 228364, 54880, { 50.565888, 17.829479, -9.1295723, 1.8405605e-11, 0 } } },
        { ROUND, 2300, 5, 0, TIGHT, { 5, 75, 400, 5, 873138, 57088, { 43.157816, 33.929539, -17.755608, 3.7378448e-14, 0 } } },
        { ROUND, 2400, 5, 0, RESIDUALS, { 5, 19, 200, 5, 235027, 51936,
          { 40.723147, 26.099758, -8.8996242, 6.422137e-14, 0 } } },
        { ROUND, 2500, 5, 0, UNSCALED, { 5, 35, 290, 5, 280274, 47168,
          { 43.268434, 13.489799, -7.4228045, 2.6648507e-13, 0 } } },
        { ROUND, 2600, 5, 0, ONE_PASS, { 5, 43, 430, 5, 435831, 46656,
          { 35.158325, 28.085084, -11.17005, 4.0376896e-13, 0 } } },
        { ROUND, 2700, 5, 0, FIXED_RHO, { 5, 63, 270, 5, 496823, 62560,
          { 52.229162, 31.095082, -13.880787, 1.076896e-13, 0 } } },
        { ROUND, 2800, 5, 0, OFTEN, { 5, 28, 180, 5, 249364, 53408, { 57.100447, 14.808119, -24.229228, 1.0017148e-13, 0 } } },
        { ROUND, 2900, 5, 0, RELAXED, { 5, 42, 410, 5, 552530, 53568, { 59.05112, 59.816691, -15.03411, 3.9657719e-11, 0 } } },
        { ROUND, 3000, 5, 0, EACH_STEP, { 5, 24, 124, 0, 248676, 45344,
          { 45.469884, 15.189482, -16.035303, 0.00016948309, 0 } } },
        { ROUND, 3100, 5, 0, CG_SHORT, { 10004, 202, 2400, 4, 18184759, 22144,
          { 44.632541, 17.408593, -11.427971, 0.0014771, 0 } } },
        { FLAT, 3200, 5, 0, PLAIN, { 5, 28, 23, 0, 176323, 52736, { 96.97146, 114.25012, -4.9826519, 4.779253e-06, 0 } } },
        { FLAT, 3300, 5, 0, PLAIN_ADMM, { 5, 5, 190, 0, 108996, 48960,
          { 52.327503, 19.536692, -9.5539275, 3.4588568e-05, 0 } } },
        { FLAT, 3400, 5, 0, LOOSE, { 5, 35, 190, 5, 261794, 43744, { 44.402996, 13.979229, -3.6896604, 2.5776784e-11, 0 } } },
        { FLAT, 3500, 5, 0, TIGHT, { 5, 20, 390, 5, 501454, 49824, { 41.256137, 20.885172, -4.5548668, 1.4491863e-14, 0 } } },
        { FLAT, 3600, 5, 0, RESIDUALS, { 5, 15, 230, 5, 379566, 54048,
          { 49.057792, 18.178164, -7.1617546, 6.8648936e-13, 0 } } },
        { FLAT, 3700, 5, 0, UNSCALED, { 5, 33, 290, 5, 545455, 56352,
          { 46.289987, 21.285296, -5.1212874, 1.8609487e-13, 0 } } },
        { FLAT, 3800, 5, 0, ONE_PASS, { 5, 18, 200, 5, 297961, 38464,
          { 38.286306, 8.9509426, -0.92010167, 4.4332671e-13, 0 } } },
        { FLAT, 3900, 5, 0, FIXED_RHO, { 5, 13, 190, 5, 282531, 58624,
          { 51.79539, 21.556904, -6.7854396, 1.0460766e-13, 0 } } },
        { FLAT, 4000, 5, 0, OFTEN, { 5, 16, 230, 5, 182914, 45184, { 32.293672, 29.419117, -1.5477877, 6.9279121e-14, 0 } } },
        { FLAT, 4100, 5, 0, RELAXED, { 5, 12, 120, 5, 79916, 35232, { 93.703608, 7.5755735, -1.5809123, 1.1945724e-14, 0 } } },
        { FLAT, 4200, 5, 0, EACH_STEP, { 5, 47, 220, 0, 656194, 51072,
          { 1015674.8, 12.274485, -3.6037823, 4.048036e-05, 0 } } },
        { FLAT, 4300, 5, 0, CG_SHORT, { 5, 35, 430, 5, 697927, 20848,
          { 37.943989, 27.011196, -3.5479983, 9.4446939e-14, 0 } } },
        { LINEAR, 4400, 5, 0, PLAIN, { 5, 21, 16, 0, 121883, 48504, { 172.18505, 40.778898, 1.0728777, 2.4131562e-06, 0 } } },
        { LINEAR, 4500, 5, 0, PLAIN_ADMM, { 5, 5, 160, 0, 106499, 43776,
          { 38.168611, 15.329232, 4.08191, 4.6324444e-06, 0 } } },
        { LINEAR, 4600, 5, 0, LOOSE, { 5, 14, 160, 5, 186060, 57088,
          { 59.866033, 28.081746, -0.76366031, 4.2728986e-12, 0 } } },
        { LINEAR, 4700, 5, 0, TIGHT, { 5, 19, 360, 5, 521000, 41856, { 35.993623, 17.447306, -3.1969073, 3.7574981e-15, 0 } } },
        { LINEAR, 4800, 5, 0, RESIDUALS, { 5, 16, 310, 5, 268990, 50880,
          { 39.216708, 18.063254, 0.070147629, 7.7180068e-14, 0 } } },
        { LINEAR, 4900, 5, 0, UNSCALED, { 5, 17, 260, 5, 205954, 39296,
          { 29.879006, 13.854078, 1.2737328, 4.7096797e-14, 0 } } },
        { LINEAR, 5000, 5, 0, ONE_PASS, { 5, 7, 100, 5, 62657, 26720,
          { 17.039252, 3.4343985, -0.29369183, 4.3363372e-14, 0 } } },
        { LINEAR, 5100, 5, 0, FIXED_RHO, { 5, 12, 350, 5, 297029, 48736,
          { 70.167993, 34.861333, -1.2612246, 1.0690084e-13, 0 } } },
        { LINEAR, 5200, 5, 0, OFTEN, { 5, 17, 190, 5, 132835, 33984, { 19.217703, 9.7017284, 0.50890724, 2.1386221e-14, 0 } } },
        { LINEAR, 5300, 5, 0, RELAXED, { 5, 13, 190, 5, 152629, 41280,
          { 75.505589, 10.408942, -0.22991135, 7.0704839e-14, 0 } } },
        { LINEAR, 5400, 5, 0, EACH_STEP, { 5, 26, 252, 0, 498150, 40544,
          { 976584.9, 16.833379, -0.32109131, 2.6783985e-05, 0 } } },
        { LINEAR, 5500, 5, 0, CG_SHORT, { 10004, 238, 1400, 4, 18130897, 27040,
          { 54.528294, 19.962155, -1.5982658, 11.214899, 0 } } }
    };
    COMPARE(rows, solve_it);
}

TEST(drawn_programs_of_many_equations_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND | TIED, 6000, 8, 0, USUAL, { 8, 77, 58, 1, 369385, 72728,
          { 61.914871, 80.670705, -13.768698, 2.8713505e-11, 0 } } },
        { ROUND | TIED, 6100, 8, 0, ADMM, { 8, 20, 310, 8, 392461, 73568,
          { 70.059568, 33.80681, -22.34101, 1.9624494e-13, 0 } } },
        { ROUND | TIED, 6200, 8, 0, DENSE, { 8, 245, 187, 8, 2313568, 41016,
          { 70.100478, 72.045456, -19.002869, 5.089584e-13, 0 } } },
        { ROUND | TIED, 6300, 8, 0, BY_CG, { 8, 16, 260, 8, 1546824, 33696,
          { 65.642431, 48.906185, -19.605011, 5.21978e-14, 0 } } },
        { ROUND | TIED, 6400, 8, 0, PLAIN, { 8, 47, 39, 0, 329327, 97600,
          { 74.651093, 114.60695, -22.453779, 6.5336037e-05, 0 } } },
        { ROUND | TIED, 6500, 8, 0, RESIDUALS, { 8, 37, 330, 8, 355447, 80640,
          { 77.208881, 27.855486, -27.307715, 4.8436627e-13, 0 } } },
        { FLAT | TIED, 6600, 8, 0, USUAL, { 8, 61, 44, 1, 302307, 79776,
          { 80.939321, 43.674996, -6.9466259, 1.2299468e-07, 0 } } },
        { FLAT | TIED, 6700, 8, 0, ADMM, { 8, 30, 270, 8, 546067, 87680,
          { 216.29411, 50.291757, 6.7707122, 6.4778143e-12, 0 } } },
        { FLAT | TIED, 6800, 8, 0, DENSE, { 8, 186, 150, 7, 1429786, 37952,
          { 57.362107, 44.544943, -7.8747148, 8.4360873e-13, 0 } } },
        { FLAT | TIED, 6900, 8, 0, BY_CG, { 8, 20, 290, 8, 1293087, 35520,
          { 68.306917, 39.161156, -1.8118373, 3.5422526e-13, 0 } } },
        { FLAT | TIED, 7000, 8, 0, PLAIN, { 8, 31, 23, 0, 190846, 79424,
          { 68.5376, 75.981708, -8.4686872, 4.9957456e-05, 0 } } },
        { FLAT | TIED, 7100, 8, 0, RESIDUALS, { 8, 20, 240, 8, 310819, 72288,
          { 51.968398, 39.229298, 4.0012394, 2.1488878e-13, 0 } } },
        { LINEAR | TIED, 7200, 8, 0, USUAL, { 8, 35, 24, 0, 147412, 56952,
          { 40.884069, 33.153892, -1.1324163, 2.0589504e-12, 0 } } },
        { LINEAR | TIED, 7300, 8, 0, ADMM, { 8, 21, 240, 8, 329056, 67328,
          { 60.658723, 39.503507, 3.2318993, 9.7661176e-14, 0 } } },
        { LINEAR | TIED, 7400, 8, 0, DENSE, { 8, 145, 112, 5, 754703, 34664,
          { 58.330116, 54.532523, 3.0812366, 1.1570999e-12, 0 } } },
        { LINEAR | TIED, 7500, 8, 0, BY_CG, { 8, 21, 410, 8, 1868902, 38544,
          { 58.912182, 43.091624, -0.6908481, 1.1178511e-13, 0 } } },
        { LINEAR | TIED, 7600, 8, 0, PLAIN, { 8, 32, 24, 0, 163054, 79144,
          { 72.944118, 120.96266, -2.3707087, 2.1835235e-05, 0 } } },
        { LINEAR | TIED, 7700, 8, 0, RESIDUALS, { 8, 27, 340, 8, 245213, 59584,
          { 51.058015, 35.527744, 1.3943582, 1.9528609e-13, 0 } } }
    };
    COMPARE(rows, solve_it);
}

TEST(drawn_programs_without_solution_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND | EMPTY, 9000, 4, 0, USUAL, { 400, 27, 23, 0, 252124, 60512,
          { 0.4, 25.928203, 13.858798, 5493047.9, 2.0229803e+08 } } },
        { ROUND | EMPTY, 9100, 4, 0, ADMM, { 400, 5, 280, 0, 141966, 38624,
          { 0.8, 23.551156, 16.094994, 389.83814, 6.677713e+12 } } },
        { ROUND | EMPTY, 9200, 4, 0, DENSE_ADMM, { 400, 43, 1080, 0, 2549699, 21040,
          { 3.6, 32.865057, 22088.371, 39959.389, 2.9115809e+15 } } },
        { ROUND | EMPTY, 9300, 4, 0, BY_CG, { 10300, 63, 1160, 0, 11121931, 18448,
          { 103.09334, 4742.72, 3793.8857, 3226.8462, 62202080 } } },
        { ROUND | EMPTY, 9400, 4, 0, PLAIN_ADMM, { 400, 7, 520, 0, 321093, 36992,
          { 13.2, 27.832636, 450.60233, 1317.2358, 4.7683253e+08 } } },
        { ROUND | EMPTY, 9500, 4, 0, FIXED_RHO, { 400, 5, 270, 0, 182766, 40576,
          { 0.4, 21.937003, 5.1846185, 268.44134, 2.0968341e+14 } } },
        { ROUND | EMPTY, 9600, 4, 0, OFTEN, { 400, 15, 290, 0, 321730, 61696,
          { 5.3125, 24.192021, 34.667748, 2461.6866, 2.6972143e+15 } } },
        { ROUND | EMPTY, 9700, 4, 0, RELAXED, { 400, 6, 290, 0, 215909, 44320,
          { 80, 23.732058, 5.730335, 4473.3218, 4.2619151e+13 } } },
        { LINEAR | EMPTY, 9800, 4, 0, USUAL, { 1300, 18, 14, 0, 63214, 31264,
          { 8.465096, 22.962592, -1638.0331, 7485.1772, 2.1267169e+10 } } },
        { LINEAR | EMPTY, 9900, 4, 0, ADMM, { 400, 4, 270, 0, 281871, 50080,
          { 0.8, 31.598417, 2.1775697, 85.337459, 3.8092266e+08 } } },
        { LINEAR | EMPTY, 10000, 4, 0, DENSE_ADMM, { 400, 28, 550, 0, 751554, 18496,
          { 12.8, 26.776667, 1.1588825, 2009.3843, 1.4775656e+08 } } },
        { LINEAR | EMPTY, 10100, 4, 0, BY_CG, { 1300, 4, 170, 0, 1252084, 22048,
          { 10.745761, 20.422598, -20461680, 40937136, 9.8729262e+08 } } },
        { LINEAR | EMPTY, 10200, 4, 0, PLAIN_ADMM, { 4000, 4, 80, 0, 43655, 34784,
          { 38.667997, 0, -1.5601787e+08, 3.2361791e+08, 3.1952029e+08 } } },
        { LINEAR | EMPTY, 10300, 4, 0, FIXED_RHO, { 1300, 52, 1180, 0, 3993253, 34496,
          { 8.9083583, 17.24742, -53188803, 1.0637784e+08, 5.238934e+15 } } },
        { LINEAR | EMPTY, 10400, 4, 0, OFTEN, { 2200, 8, 160, 0, 55209, 28640,
          { 14.483829, 6.0982407, -2560592.3, 5836025.4, 1e+17 } } },
        { LINEAR | EMPTY, 10500, 4, 0, RELAXED, { 400, 4, 110, 0, 73216, 39200,
          { 40, 25.322929, 7.8432765, 33129.907, 310157.89 } } },
        { ROUND | DEEP, 10600, 4, 0, USUAL, { 4000, 33, 29, 0, 319209, 58944,
          { 46.156611, 0, -7524512.7, 34993880, 49491009 } } },
        { ROUND | DEEP, 10700, 4, 0, ADMM, { 4000, 4, 110, 0, 26497, 23008, { 24.267813, 0, -1069113, 2139200.7, 56001024 } } },
        { ROUND | DEEP, 10800, 4, 0, DENSE_ADMM, { 4000, 4, 130, 0, 63752, 15312,
          { 27.317362, 0, -5355.7378, 10712.266, 85096962 } } },
        { ROUND | DEEP, 10900, 4, 0, BY_CG, { 4000, 4, 220, 0, 1916152, 19632,
          { 34.556718, 0, -333.15186, 774.27122, 1.762496e+08 } } },
        { ROUND | DEEP, 11000, 4, 0, PLAIN_ADMM, { 4000, 4, 130, 0, 53124, 30816,
          { 28.940025, 0, -2454961.5, 4909930.6, 3.0721538e+08 } } },
        { ROUND | DEEP, 11100, 4, 0, FIXED_RHO, { 4000, 4, 160, 0, 104821, 33600,
          { 28.741505, 0, -3227532.5, 6455204.8, 49171546 } } },
        { ROUND | DEEP, 11200, 4, 0, OFTEN, { 4000, 9, 170, 0, 144858, 53088,
          { 47.073552, 0, -392.21246, 871.0415, 1.4508208e+08 } } },
        { ROUND | DEEP, 11300, 4, 0, RELAXED, { 4000, 30, 540, 0, 1517115, 39872,
          { 49.540366, 0, -2674.5582, 5326.1533, 7.9068754e+15 } } },
        { FLAT | DEEP, 11400, 4, 0, USUAL, { 4000, 27, 23, 0, 222369, 43808,
          { 39.231153, 0, -66565980, 1.3695116e+08, 7.5256883e+14 } } },
        { FLAT | DEEP, 11500, 4, 0, ADMM, { 4000, 4, 110, 0, 67603, 37120, { 37.550044, 0, -31982576, 64322713, 54130689 } } },
        { FLAT | DEEP, 11600, 4, 0, DENSE_ADMM, { 4000, 4, 150, 0, 136183, 17152,
          { 31.133469, 0, -10576686, 26477001, 1.4092748e+09 } } },
        { FLAT | DEEP, 11700, 4, 0, BY_CG, { 4000, 4, 80, 0, 540906, 19264, { 33.028692, 0, -16125727, 37036749, 42331383 } } },
        { FLAT | DEEP, 11800, 4, 0, PLAIN_ADMM, { 4000, 5, 200, 0, 164400, 42560,
          { 34.101306, 0, -1747250.4, 3544397.9, 1.0848037e+08 } } },
        { FLAT | DEEP, 11900, 4, 0, FIXED_RHO, { 4000, 4, 140, 0, 125679, 54112,
          { 36.84942, 0, -517496.46, 5741118.4, 1.7143805e+08 } } },
        { FLAT | DEEP, 12000, 4, 0, OFTEN, { 4000, 6, 80, 0, 62097, 40160,
          { 33.768325, 0, -42967280, 87241711, 1.5131664e+08 } } },
        { FLAT | DEEP, 12100, 4, 0, RELAXED, { 4000, 5, 170, 0, 120149, 35392,
          { 67.506114, 0, -17341.449, 45807.097, 9.6446711e+15 } } },
        { LINEAR | DEEP, 12200, 4, 0, USUAL, { 4000, 21, 17, 0, 75823, 30536, { 33.427506, 0, -34225670, 69845603, 3e+17 } } },
        { LINEAR | DEEP, 12300, 4, 0, ADMM, { 4000, 4, 40, 0, 15187, 28576, { 28.144999, 0, -37279157, 80421967, 3e+17 } } },
        { LINEAR | DEEP, 12400, 4, 0, DENSE_ADMM, { 4000, 4, 40, 0, 27214, 16816,
          { 37.239468, 0, -23906005, 53043526, 4e+17 } } },
        { LINEAR | DEEP, 12500, 4, 0, BY_CG, { 4000, 4, 50, 0, 159068, 15856, { 27.891956, 0, -33111912, 68377895, 3e+17 } } },
        { LINEAR | DEEP, 12600, 4, 0, PLAIN_ADMM, { 4000, 4, 80, 0, 72644, 42752,
          { 45.905658, 0, -15004471, 46351804, 2e+17 } } },
        { LINEAR | DEEP, 12700, 4, 0, FIXED_RHO, { 4000, 4, 60, 0, 13231, 21504,
          { 24.090338, 0, -38921906, 77843815, 3e+17 } } },
        { LINEAR | DEEP, 12800, 4, 0, OFTEN, { 4000, 4, 50, 0, 48028, 46752, { 38.760124, 0, -10019068, 44579884, 3e+17 } } },
        { LINEAR | DEEP, 12900, 4, 0, RELAXED, { 4000, 4, 40, 0, 27325, 42528,
          { 84.745133, 0, -25017.644, 51742.393, 2e+17 } } }
    };
    COMPARE(rows, solve_it);
}

TEST(drawn_programs_of_any_scale_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND, 14000, 4, 3, USUAL, { 4, 72, 44, 1, 627503, 52992, { 93.500706, 10854.089, -10.405374, 1.0467902e-10, 0 } } },
        { ROUND, 14100, 4, 3, ADMM, { 4, 12, 210, 4, 93825, 28480, { 40.606011, 9.6549295, -8.2293482, 3.8796572e-12, 0 } } },
        { ROUND, 14200, 4, 3, DENSE, { 4, 123, 64, 3, 1334930, 19776,
          { 61.285619, 25.438583, -18.438083, 1.6008008e-09, 0 } } },
        { ROUND, 14300, 4, 3, BY_CG, { 4, 22, 200, 4, 599112, 18480, { 40.48987, 23.680595, -2.3527215, 4.4036408e-12, 0 } } },
        { ROUND, 14400, 4, 3, PLAIN, { 4, 22, 18, 0, 104892, 33008, { 27.402645, 42.366364, -7.1191833, 5.0466799e-05, 0 } } },
        { ROUND, 14500, 4, 3, RESIDUALS, { 4, 11, 180, 4, 164240, 35904,
          { 79.652486, 13.424126, -3.9997477, 7.3637036e-11, 0 } } },
        { ROUND, 14600, 4, 3, ONE_PASS, { 4, 22, 400, 4, 381877, 40160,
          { 140.48004, 64.089271, -4.9037649, 2.7414073e-12, 0 } } },
        { ROUND, 14700, 4, 3, UNSCALED, { 4, 62, 330, 4, 479582, 45280,
          { 53.811743, 81.309467, -6.8671524, 6.4473199e-12, 0 } } },
        { FLAT, 14800, 4, 3, USUAL, { 4, 18, 13, 0, 105380, 35488, { 145.02738, 13.803461, -2.2273785, 2.1366308e-11, 0 } } },
        { FLAT, 14900, 4, 3, ADMM, { 4, 17, 210, 4, 433480, 39808, { 55.640107, 14.280354, -4.5061218, 6.8885231e-12, 0 } } },
        { FLAT, 15000, 4, 3, DENSE, { 4, 109, 80, 3, 1408209, 20536, { 74.652717, 23.372222, -4.8046016, 2.3022293e-11, 0 } } },
        { FLAT, 15100, 4, 3, BY_CG, { 4, 15, 200, 4, 947669, 17888, { 34.782133, 32.560565, 1.4071129, 3.0327087e-10, 0 } } },
        { FLAT, 15200, 4, 3, PLAIN, { 4, 18, 14, 0, 92344, 40224, { 28.695442, 37.929801, -1.0877079, 0.00039344137, 0 } } },
        { FLAT, 15300, 4, 3, RESIDUALS, { 4, 13, 110, 4, 82034, 26592,
          { 108.28223, 7.0797405, 0.86653169, 2.5188428e-13, 0 } } },
        { FLAT, 15400, 4, 3, ONE_PASS, { 4, 16, 230, 4, 344387, 36576,
          { 34.92897, 10.572417, -0.52912431, 2.9607523e-12, 0 } } },
        { FLAT, 15500, 4, 3, UNSCALED, { 4, 12, 140, 4, 375265, 42976,
          { 46.348927, 9.3939658, -6.3323563, 8.7629179e-12, 0 } } },
        { LINEAR, 15600, 4, 3, USUAL, { 4, 36, 30, 0, 162754, 36256, { 49.313374, 184.08979, 1.072442, 5.2881577e-13, 0 } } },
        { LINEAR, 15700, 4, 3, ADMM, { 4, 11, 140, 4, 138038, 35712,
          { 143.21152, 36.158772, 0.047322604, 2.0434221e-12, 0 } } },
        { LINEAR, 15800, 4, 3, DENSE, { 4, 120, 125, 4, 1202423, 20864,
          { 127.18322, 4515.4334, 1.9887936, 2.7989297e-12, 0 } } },
        { LINEAR, 15900, 4, 3, BY_CG, { 4, 14, 190, 4, 172015, 15024, { 88.092688, 14.713282, -1.0406925, 5.992992e-13, 0 } } },
        { LINEAR, 16000, 4, 3, PLAIN, { 4, 16, 12, 0, 74835, 34128, { 36.997235, 43.505583, 0.8231544, 1.3072863e-05, 0 } } },
        { LINEAR, 16100, 4, 3, RESIDUALS, { 4, 9, 80, 4, 212763, 25440,
          { 6.9937952, 4.4445104, -0.73823357, 1.6366694e-12, 0 } } },
        { LINEAR, 16200, 4, 3, ONE_PASS, { 4, 11, 120, 4, 77401, 27360,
          { 27.370323, 11.147911, -3.2120384, 7.1031046e-13, 0 } } },
        { LINEAR, 16300, 4, 3, UNSCALED, { 4, 8, 200, 4, 110849, 26400,
          { 23.346253, 23.652225, 1.9567682, 8.5634757e-13, 0 } } },
        { FLAT, 24, 1, 3, UNSCALED, { 1, 4, 50, 1, 225785, 12576, { 73.998454, 10.272041, 0.39775588, 2.1004413e-11, 0 } } },
        { FLAT | DEEP, 38, 1, 3, UNSCALED, { 1000, 1, 30, 0, 23580, 12480,
          { 12.457234, 0, -1738872.4, 3484820.9, 7660933.3 } } },
        { ROUND, 17, 1, 3, USUAL, { 1, 62, 13, 1, 103247, 4960, { 2.3436347, 252.84826, -0.030588897, 3.5053064e-13, 0 } } },
        { LINEAR, 32, 1, 3, USUAL, { 1, 3, 1, 1, 4084, 5024, { 4.5329477, 0, 0, 2.4380039e-15, 0 } } }
    };
    COMPARE(rows, solve_it);
}

TEST(drawn_programs_of_extreme_scale_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND, 17000, 4, 6, USUAL, { 4, 75, 44, 2, 435123, 30904, { 609.50376, 8890.7018, -2.7595019, 9.232846e-09, 0 } } },
        { ROUND, 17100, 4, 6, ADMM, { 4, 13, 260, 4, 420162, 42432, { 54901.742, 24192.451, -5.4905842, 1.9256645e-10, 0 } } },
        { LINEAR, 17200, 4, 6, USUAL, { 4, 29, 22, 0, 92071, 27160, { 588.94109, 81399.234, -0.13358949, 6.4359809e-10, 0 } } },
        { LINEAR, 17300, 4, 6, ADMM, { 4, 13, 240, 4, 490606, 40608, { 20946.798, 17556.712, -2.1274002, 8.362597e-10, 0 } } },
        { ROUND | EMPTY, 17400, 4, 6, USUAL, { 400, 57, 53, 0, 319858, 37928,
          { 0.4, 34.04438, 178667.78, 3.615653e+09, 9.1648687e+10 } } },
        { ROUND | EMPTY, 17500, 4, 6, ADMM, { 400, 17, 430, 0, 346527, 40928,
          { 1.2, 22.026594, 34.941272, 27464.066, 2.3476622e+15 } } },
        { ROUND | DEEP, 17600, 4, 6, USUAL, { 4000, 34, 30, 0, 245039, 44064,
          { 35.302058, 0, -1.0917141e+08, 2.202607e+08, 4.4422591e+08 } } },
        { ROUND | DEEP, 17700, 4, 6, ADMM, { 4000, 16, 550, 0, 1078366, 35072,
          { 29.552816, 0, -62.451009, 1539.5349, 5.3304027e+15 } } },
        { ROUND, 18000, 2, 6, BY_CG, { 2, 7, 130, 2, 760643, 8944, { 55.298082, 1, -15.413003, 2.3768131e-09, 0 } } },
        { ROUND | DEEP, 18100, 2, 6, BY_CG, { 2000, 298, 1010, 0, 10993812, 7216,
          { 9.1000012, 0, -442880.88, 1130519.2, 30005017 } } },
        { ROUND, 19000, 1, 40, USUAL, { 1, 3, 2, 0, 3935, 4576, { 9612558.3, 0, -0.28063686, 1e+09, 0 } } },
        { ROUND, 19100, 1, 40, ADMM, { 1, 11, 30, 1, 16679, 5376, { 5.0722839, 1.7639929, -0.6379291, 1e+09, 0 } } },
        { ROUND, 19200, 1, 40, UNSCALED, { 10000, 10, 1000, 0, 5453612, 10144,
          { 195320.44, 1.4037814, -1.1778988, 1e+09, 0 } } },
        { LINEAR | EMPTY, 19300, 1, 40, USUAL, { 100, 58, 424, 0, 1678044, 17712,
          { 62.5, 5.0000127, -0.85819816, 1318.5339, 1.2612999e+11 } } },
        { LINEAR | EMPTY, 19400, 1, 40, ADMM, { 100, 1, 40, 0, 7927, 5792,
          { 0.1, 4.0701395, -0.086871334, 14.094034, 12371343 } } },
        { LINEAR | EMPTY, 19500, 1, 40, UNSCALED, { 1000000, 1, 10, 0, 12062, 9248, { 0.1, 0, 0, 1e+09, 0 } } },
        { FLAT | DEEP, 19600, 1, 40, USUAL, { 1000, 14, 13, 0, 58120, 7680, { 6.1, 0, -7982177.6, 16015777, 9932030.5 } } },
        { FLAT | DEEP, 19700, 1, 40, ADMM, { 1000, 1, 20, 0, 13144, 10784,
          { 12.208134, 0, -1609618.2, 1.0033636e+09, 1.3526501e+08 } } },
        { FLAT | DEEP, 19800, 1, 40, UNSCALED, { 10000, 75, 1000, 0, 1271750, 9152,
          { 7.5810807e+08, 2.5566649, -8.027906e+08, 2e+09, 0 } } }
    };
    COMPARE(rows, solve_it);
}

TEST(drawn_projections_take_the_work_written_here)
{
    static const drawn rows[] = {
        { DIAGONAL, 21000, 12, 0, DYKSTRA, { 12, 12, 255, 0, 122513, 65648,
          { 99.655044, 66.458046, -12.536403, 5.1842199e-08, 0 } } },
        { DIAGONAL | TIED, 21100, 12, 0, DYKSTRA, { 1000020, 12, 555, 0, 395658, 62448,
          { 111.47098, 38.755517, -11.165345, 6.1133741, 0 } } },
        { DIAGONAL | EMPTY, 21200, 12, 0, DYKSTRA, { 120000, 12, 6000, 0, 2686043, 80472,
          { 219.56987, 22295.597, 884.44528, 65577.627, 0 } } },
        { ROUND, 21300, 12, 0, DYKSTRA, { 12000000, 12, 0, 0, 0, 86136, { 0, 0, 0, 0, 0 } } },
        { LINEAR, 21400, 12, 0, DYKSTRA, { 2040024, 12, 3364, 0, 1530627, 70872,
          { 3.1055519e+12, 58.787129, -7.5985882e+12, 4e+09, 0 } } },
        { DIAGONAL | DEEP, 21500, 12, 0, DYKSTRA, { 12000000, 12, 0, 0, 0, 75344, { 0, 0, 0, 0, 0 } } },
        { DIAGONAL, 22000, 12, 2, DYKSTRA, { 30, 12, 1083, 0, 576713, 66720,
          { 105.26712, 42.426118, -13.159711, 0.00033497171, 0 } } },
        { DIAGONAL | TIED, 22100, 12, 2, DYKSTRA, { 2000010, 12, 447, 0, 245907, 74136,
          { 117.88556, 53.597405, -22.040751, 557.84428, 0 } } },
        { DIAGONAL | EMPTY, 22200, 12, 2, DYKSTRA, { 120000, 12, 6000, 0, 2600038, 75728,
          { 179.93486, 14867.022, 161.5365, 58871.489, 0 } } },
        { DIAGONAL, 23000, 12, 40, DYKSTRA, { 1020027, 12, 2072, 0, 1136386, 71608,
          { 243671.43, 4484.1308, -7.7944584, 4.3523217e+09, 0 } } },
        { DIAGONAL | TIED, 23100, 12, 40, DYKSTRA, { 7000005, 12, 21, 0, 5408, 64576,
          { 92461.535, 103.13838, -25.210349, 5.0084199e+09, 0 } } },
        { LINEAR | EMPTY, 23200, 12, 40, DYKSTRA, { 5060010, 12, 3500, 0, 984086, 73328,
          { 1.8662113e+47, 1.5981707e+60, -3.4811487e+82, 1.9000135e+10, 0 } } },
        { LINEAR, 24000, 12, 4, DYKSTRA, { 1070013, 12, 4006, 0, 1558343, 61008,
          { 2.0611923e+12, 1340.4477, -8.6015528e+11, 1.2e+10, 0 } } },
        { LINEAR | TIED, 24100, 12, 4, DYKSTRA, { 4020024, 12, 2008, 0, 845512, 66680,
          { 2.6660311e+16, 12552.784, -3.683144e+20, 1.3046313e+10, 0 } } },
        { FLAT, 24200, 12, 4, DYKSTRA, { 11010000, 12, 500, 0, 116001, 59184,
          { 55512293, 5.0136578, -2223.5504, 115647.86, 0 } } }
    };
    COMPARE(rows, solve_it);
}

TEST(drawn_programs_with_little_to_spend_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND, 25000, 1, 0, USUAL, { 900001, 18, 43, 0, 81234, 40960, { 46.563179, 6.0229872, -5.4674257, 8.8801348, 0 } } },
        { ROUND, 25100, 1, 0, ADMM, { 900001, 4, 44, 1, 30239, 38080, { 15.011697, 0, -1.1940613, 10.396613, 0 } } },
        { ROUND, 25200, 1, 0, DENSE, { 900001, 103, 104, 1, 143605, 15120,
          { 19.187638, 20.009993, -0.045571405, 0.1133359, 0 } } },
        { ROUND, 25300, 1, 0, BY_CG, { 700012, 12, 139, 1, 739046, 24800,
          { 78.108894, 9.0419242, -12.106345, 7.3328792, 0 } } },
        { LINEAR, 25400, 1, 0, USUAL, { 900001, 14, 34, 0, 49034, 36400, { 11.562366, 22.045237, 0.4982413, 5.1252169, 0 } } },
        { LINEAR, 25500, 1, 0, ADMM, { 900001, 8, 309, 1, 173831, 43840, { 36.19528, 39.561102, 2.1062067, 6.1626038, 0 } } },
        { LINEAR, 25600, 1, 0, DENSE, { 10, 6, 5, 0, 11102, 15680, { 2, 3.001, 0, 8.2109414e-15, 0 } } },
        { LINEAR, 25700, 1, 0, BY_CG, { 800011, 9, 278, 1, 368826, 22720,
          { 36.983286, 22.801165, -3.3823426, 6.3776107, 0 } } },
        { FLAT | TIED, 25800, 1, 0, USUAL, { 900001, 9, 26, 0, 35542, 35520,
          { 8.4493573, 40.607844, -1.8031012, 12.81544, 0 } } },
        { FLAT | TIED, 25900, 1, 0, ADMM, { 900001, 6, 78, 1, 93258, 52960,
          { 35.923045, 31.613245, 8.408615, 35.384902, 0 } } },
        { FLAT | TIED, 26000, 1, 0, DENSE, { 900001, 124, 164, 1, 795948, 26800,
          { 49.051263, 71.061031, -9.4108802, 5.4298081, 0 } } },
        { FLAT | TIED, 26100, 1, 0, BY_CG, { 400015, 17, 174, 3, 206180, 17040,
          { 25.53524, 0, -0.016039835, 0.17411633, 0 } } },
        { FLAT | DEEP, 26200, 1, 0, USUAL, { 901000, 5, 4, 0, 32082, 49280,
          { 8.2270527, 0, -2389646.1, 4781794.9, 2.5178542e+08 } } },
        { FLAT | DEEP, 26300, 1, 0, ADMM, { 901000, 1, 20, 0, 33795, 56640,
          { 12.10113, 0, -109921.08, 1216372.7, 1331028.2 } } },
        { FLAT | DEEP, 26400, 1, 0, DENSE, { 802000, 43, 75, 0, 609342, 30960,
          { 78097784, 11.232944, -1.6566603e+08, 3.4674772e+08, 1.2056463e+08 } } },
        { FLAT | DEEP, 26500, 1, 0, BY_CG, { 604000, 8, 79, 0, 256128, 16640,
          { 40933881, 0, -35970195, 73582606, 2.7219876e+08 } } },
        { LINEAR | EMPTY, 27000, 1, 0, USUAL, { 900100, 5, 4, 0, 45094, 53760,
          { 1, 7.7112144, -0.72723894, 43225.266, 4.8257928e+09 } } },
        { LINEAR | EMPTY, 27100, 1, 0, ADMM, { 901000, 1, 20, 0, 32255, 57120,
          { 13.03545, 0, -32920400, 65840891, 21475248 } } },
        { LINEAR | EMPTY, 27200, 1, 0, DENSE, { 800200, 224, 305, 0, 1916759, 30080,
          { 27.274202, 61.157027, -0.44898587, 602.09706, 12983545 } } },
        { LINEAR | EMPTY, 27300, 1, 0, CG_SHORT, { 901000, 8, 192, 0, 495072, 24160,
          { 828.18844, 44.171134, -1009.435, 3901.0892, 33566031 } } }
    };
    COMPARE(rows, spend_it);
}

TEST(drawn_programs_spent_near_a_look_take_the_work_written_here)
{
    static const drawn rows[] = {
        { FLAT | EMPTY, 27500, 1, 0, ADMM, { 8000100, 81, 2935, 0, 3400748, 580608,
          { 905.40702, 2155.6413, -97.894569, 1832.8517, 26448519 } } },
        { FLAT | EMPTY, 27600, 1, 0, BY_CG, { 4302900, 130, 7766, 0, 30623466, 184032,
          { 524.15044, 2560.8915, 10.199258, 3588.747, 2.3454958e+16 } } },
        { FLAT | DEEP, 27700, 1, 0, ADMM, { 8001000, 1, 20, 0, 153987, 426384,
          { 19.80929, 0, -2536575, 5961219.8, 77141413 } } },
        { FLAT | DEEP, 27800, 1, 0, BY_CG, { 8001000, 1, 30, 0, 45756, 136728,
          { 11.387638, 0, -303.99161, 713.31267, 69790359 } } },
        { ROUND, 27900, 1, 0, ADMM, { 81, 2021, 8100, 81, 11041382, 460080,
          { 723.80835, 486.95465, -76.799716, 3.3732136e-07, 0 } } },
        { ROUND, 28000, 1, 0, BY_CG, { 1100277, 83, 2146, 1, 2140910, 128952,
          { 524.76229, 145.64937, -129.09359, 0.0037234659, 0 } } }
    };
    COMPARE(rows, spend_near);
}

TEST(drawn_projections_with_little_to_spend_take_the_work_written_here)
{
    static const drawn rows[] = {
        { DIAGONAL, 28000, 4, 0, DYKSTRA, { 1400170, 40, 1010, 0, 660320, 69680,
          { 451.21552, 218.56775, -39.37059, 9.1298796, 0 } } },
        { DIAGONAL | TIED, 28100, 4, 0, DYKSTRA, { 10700122, 40, 99, 0, 48790, 36560,
          { 361.66, 141.3309, -51.976536, 5.8157201, 0 } } },
        { DIAGONAL | EMPTY, 28200, 4, 0, DYKSTRA, { 3280000, 40, 11012, 0, 3727622, 42240,
          { 395.40994, 20804.946, 319.10449, 122824.43, 0 } } }
    };
    COMPARE(rows, spend_it);
}

TEST(drawn_programs_from_a_guess_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND, 29000, 1, 0, USUAL, { 16, 137, 398, 14, 1388979, 107008,
          { 195.44596, 49.007327, -71.227906, 1.6037924e-10, 0 } } },
        { ROUND, 29100, 1, 0, ADMM, { 16, 91, 272, 16, 1206350, 125440,
          { 211.19881, 24.81851, -178.47808, 2.7050547e-10, 0 } } },
        { ROUND, 29200, 1, 0, INTERIOR, { 16, 124, 88, 4, 367832, 53504,
          { 70.520215, 155.32542, -19.348182, 1.0953392e-11, 0 } } },
        { ROUND, 29300, 1, 0, DENSE, { 16, 110, 254, 16, 946970, 35712,
          { 187.43765, 31.370878, -32.215515, 3.759937e-13, 0 } } },
        { ROUND, 29400, 1, 0, PLAIN, { 70009, 39, 246, 0, 460528, 117504, { 187.9675, 83.112868, -54.18894, 13.336082, 0 } } },
        { LINEAR, 29500, 1, 0, USUAL, { 16, 75, 366, 13, 225874, 50688,
          { 45.711555, 25.564875, 0.31105251, 4.3816574e-14, 0 } } },
        { LINEAR, 29600, 1, 0, ADMM, { 16, 67, 832, 16, 1129739, 96256,
          { 137.19489, 157.26625, -20.764824, 1.1450327e-13, 0 } } },
        { LINEAR, 29700, 1, 0, INTERIOR, { 16, 80, 64, 4, 224160, 51712, { 138.42087, 48, 0, 1.3451639e-13, 0 } } },
        { LINEAR, 29800, 1, 0, DENSE, { 16, 16, 84, 12, 10608, 18688, { 35.018576, 0, 0, 0, 0 } } },
        { LINEAR, 29900, 1, 0, PLAIN, { 16, 16, 84, 0, 6492, 24320, { 31.319883, 0, 0, 0, 0 } } },
        { FLAT | TIED, 30000, 1, 0, USUAL, { 16, 63, 203, 13, 538922, 77568,
          { 176.78421, 72.166819, -2.8345774, 5.9932623e-13, 0 } } },
        { FLAT | TIED, 30100, 1, 0, ADMM, { 16, 54, 252, 16, 1126856, 120320,
          { 147.29809, 209.50806, 11.141533, 3.2694725e-13, 0 } } },
        { FLAT | TIED, 30200, 1, 0, INTERIOR, { 16, 152, 88, 4, 1025852, 100608,
          { 175.3369, 184.09693, -14.870522, 7.9687378e-12, 0 } } },
        { FLAT | TIED, 30300, 1, 0, DENSE, { 16, 68, 168, 12, 342652, 30848, { 148.33747, 0, -14.025913, 1.3316759e-11, 0 } } },
        { FLAT | TIED, 30400, 1, 0, PLAIN, { 60019, 24, 191, 0, 198624, 83712,
          { 175.59822, 66.132253, -48.63086, 13.49747, 0 } } },
        { FLAT | EMPTY, 30500, 1, 0, USUAL, { 11500, 50, 557, 0, 809155, 94976,
          { 15.46558, 114.7117, -60.594855, 783643.34, 1.0526419e+16 } } },
        { FLAT | EMPTY, 30600, 1, 0, ADMM, { 21400, 41, 432, 0, 293636, 51968,
          { 109.1614, 294.81048, 3.6792855, 2124.2146, 4.0818057e+16 } } },
        { FLAT | EMPTY, 30700, 1, 0, INTERIOR, { 80800, 392, 128, 0, 4938912, 91648,
          { 42.500537, 198.38451, 4.096858, 5635097.2, 1.6474093e+09 } } },
        { FLAT | EMPTY, 30800, 1, 0, DENSE, { 51100, 167, 474, 0, 1772739, 35072,
          { 55.206668, 95.246514, -41.03355, 38.545096, 1.2765754e+15 } } },
        { FLAT | EMPTY, 30900, 1, 0, PLAIN, { 80800, 46, 352, 0, 287450, 71424,
          { 41.459692, 135.16408, 49.961446, 2.2817681e+08, 1.6697051e+08 } } },
        { LINEAR | DEEP, 31000, 1, 0, USUAL, { 25000, 26, 91, 0, 145584, 32256,
          { 1310513.6, 0, -73967986, 1.4793598e+08, 1.5e+18 } } },
        { LINEAR | DEEP, 31100, 1, 0, ADMM, { 16000, 28, 112, 0, 139072, 94976,
          { 162.03325, 0, -62658572, 1.4359899e+08, 1.1088499e+18 } } },
        { LINEAR | DEEP, 31200, 1, 0, INTERIOR, { 52000, 256, 28, 0, 849228, 45824,
          { 8938088.7, 4.5645239, -19799504, 39599011, 1.2568844e+09 } } },
        { LINEAR | DEEP, 31300, 1, 0, DENSE, { 25000, 60, 217, 0, 933909, 57088,
          { 1650772.5, 14.755677, -32892017, 1.0010062e+09, 7.0993639e+17 } } },
        { LINEAR | DEEP, 31400, 1, 0, PLAIN, { 34000, 24, 91, 0, 90372, 70400,
          { 447263.71, 3.2365076, -8852129.6, 17704300, 9e+17 } } },
        { FLAT, 31500, 1, 0, BY_CG, { 16, 63, 292, 16, 2311188, 32768,
          { 211.43091, 17.533143, -20.614634, 1.0883391e-13, 0 } } },
        { DIAGONAL, 31600, 2, 0, DYKSTRA, { 80024, 32, 312, 0, 138176, 26240,
          { 213.45572, 104.26366, -10.009722, 2.7077877, 0 } } },
        { DIAGONAL | TIED, 31700, 2, 0, DYKSTRA, { 176, 32, 1648, 0, 468864, 23808,
          { 230.87062, 129.83818, -52.813721, 3.5538466e-05, 0 } } }
    };
    COMPARE(rows, guess_it);
}

TEST(drawn_programs_from_far_away_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND, 40000, 1, 0, ADMM, { 3000001, 689, 830, 1, 7232464, 41664,
          { 1.1402714e+221, 1.0102859e+261, 2e+30, 7e+09, 0 } } },
        { ROUND, 40100, 1, 0, DENSE_ADMM, { 3000001, 271, 430, 1, 4717128, 11840,
          { 8.320058e+220, 6.4634359e+260, 2e+30, 7e+09, 0 } } },
        { ROUND, 40200, 1, 0, PLAIN_ADMM, { 4000000, 5, 530, 0, 393512, 25152,
          { 9.5768615e+220, 9.3793688e+260, 5.3491658e+117, 1e+10, 0 } } },
        { ROUND, 40300, 1, 0, USUAL, { 3000001, 87, 137, 0, 370114, 25024,
          { 6.2937913e+220, 7.6971885e+260, 2e+30, 7e+09, 0 } } },
        { ROUND, 40400, 1, 0, CG_SHORT, { 3010000, 95, 1030, 0, 8953724, 11360,
          { 7.2589857e+220, 6.3770778e+260, 8.1475309e+247, 1e+10, 0 } } },
        { LINEAR, 40500, 1, 0, ADMM, { 4000000, 4, 40, 0, 16092, 18112,
          { 6.8763448e+220, 1.0861979e+261, 2.4169133e+220, 9e+09, 0 } } },
        { LINEAR, 40600, 1, 0, DENSE_ADMM, { 4, 4, 100, 4, 26987, 6176, { 1.3431851e+261, 0, 0, 4e+09, 0 } } },
        { LINEAR, 40700, 1, 0, PLAIN_ADMM, { 4000000, 4, 40, 0, 18768, 17024,
          { 1.1782589e+221, 4.6270835e+260, 4.4405316e+220, 9e+09, 0 } } },
        { LINEAR, 40800, 1, 0, USUAL, { 4000000, 4, 40, 0, 9420, 11840,
          { 8.4899119e+220, 6.9290789e+260, 2.8721096e+220, 9e+09, 0 } } },
        { LINEAR, 40900, 1, 0, CG_SHORT, { 4000000, 4, 40, 0, 20400, 7456,
          { 3.7943977e+220, 8.4303031e+260, 2.5108889e+220, 9e+09, 0 } } },
        { FLAT | TIED, 41000, 1, 0, ADMM, { 3010000, 16, 1030, 0, 880618, 13696,
          { 4.363968e+220, 5.9889521e+260, 1.5371207e+245, 1e+10, 0 } } },
        { FLAT | TIED, 41100, 1, 0, DENSE_ADMM, { 3010000, 16, 1030, 0, 2262780, 11168,
          { 9.2686373e+220, 8.8741188e+260, -1.0622459e+245, 1e+10, 0 } } },
        { FLAT | TIED, 41200, 1, 0, PLAIN_ADMM, { 3010000, 5, 1030, 0, 1031079, 29824,
          { 1.1930505e+221, 8.2946876e+260, 1.0431218e+249, 1e+10, 0 } } },
        { FLAT | TIED, 41300, 1, 0, USUAL, { 3000001, 21, 135, 0, 415582, 27456,
          { 1.1314128e+221, 6.7560217e+260, 2e+30, 7e+09, 0 } } },
        { FLAT | TIED, 41400, 1, 0, CG_SHORT, { 3010000, 27, 1030, 0, 1864619, 10368,
          { 7.4180464e+220, 9.9828653e+260, 3.1466891e+243, 1.1e+10, 0 } } },
        { ROUND, 42000, 3, 40, ADMM, { 8010003, 331, 1540, 3, 1787521, 45504,
          { 2.1974746e+221, 1.3966635e+261, 2.514408e+253, 2.2008836e+10, 0 } } },
        { ROUND, 42100, 3, 40, PLAIN_ADMM, { 9030000, 26, 3090, 0, 1371845, 49728,
          { 1.8368425e+221, 2.1840025e+261, 8.9504804e+275, 3.1e+10, 0 } } },
        { LINEAR, 42200, 3, 40, ADMM, { 8040000, 74, 4080, 0, 28314506, 49152,
          { 2.7988201e+303, 1.2524844e+261, 3.9826121e+266, 3.1e+10, 0 } } },
        { LINEAR, 42300, 3, 40, PLAIN_ADMM, { 12000000, 12, 120, 0, 57268, 47808,
          { 2.0395197e+221, 2.054152e+261, 4.7668753e+228, 2.6171951e+10, 0 } } },
        { ROUND, 7, 1, 40, ADMM, { 4000000, 21, 670, 0, 197230, 10624,
          { 6.1642298e+220, 5.5437778e+260, 3.1103553e+229, 1e+10, 0 } } }
    };
    COMPARE(rows, far_it);
}

TEST(drawn_programs_that_fall_along_a_line_are_refused_as_written_here)
{
    static const drawn rows[] = {
        { ROUND | SADDLE, 45000, 24, 0, PLAIN, { 114, 102, 84, 0, 463025, 228192,
          { 136.05983, 175.47058, -46.09167, 0.00024222665, 0 } } },
        { ROUND | SADDLE, 45100, 24, 0, DENSE, { 84, 703, 424, 18, 5679709, 114992,
          { 176.15395, 144.79198, -38.010907, 7.8269341e-13, 0 } } },
        { ROUND | SADDLE, 45200, 24, 0, BY_CG, { 99, 110, 890, 19, 5039141, 98064,
          { 155.00282, 58.928349, -39.101414, 3.0530764e-13, 0 } } },
        { FLAT | SADDLE, 45300, 24, 0, PLAIN, { 354, 9, 7, 0, 35744, 191816,
          { 14.07553, 9.5029708, -1.3405603, 2.8271847e-06, 0 } } },
        { FLAT | SADDLE, 45400, 24, 0, DENSE, { 354, 34, 24, 1, 701821, 109024,
          { 16.026614, 9.6183917, -0.61269353, 6.8805557e-08, 0 } } },
        { FLAT | SADDLE, 45500, 24, 0, BY_CG, { 354, 7, 130, 2, 1518686, 112992,
          { 12.63502, 7.4522694, -1.1495318, 5.7947106e-08, 0 } } },
        { DIAGONAL | SADDLE, 45600, 24, 0, PLAIN, { 54, 134, 112, 0, 586749, 199000,
          { 179.7176, 301.74481, -26.131894, 9.6946052e-05, 0 } } },
        { DIAGONAL | SADDLE, 45700, 24, 0, DENSE, { 54, 766, 454, 19, 5526525, 115392,
          { 185.35943, 115.33352, -20.282963, 1.3462691e-12, 0 } } },
        { DIAGONAL | SADDLE, 45800, 24, 0, BY_CG, { 99, 123, 940, 19, 2683214, 98320,
          { 141.63554, 55.095163, -16.109051, 3.0441438e-13, 0 } } },
        { FLAT | SADDLE, 586, 1, 0, BY_CG, { 16, 0, 0, 0, 0, 5712, { 0, 0, 0, 0, 0 } } },
        { FLAT | SADDLE, 2832, 1, 0, BY_CG, { 1, 4, 30, 1, 272362, 4752, { 13.71525, 0, -0.67785006, 9.5258378e-07, 0 } } }
    };
    COMPARE(rows, solve_it);
}

TEST(drawn_programs_that_change_take_the_work_written_here)
{
    static const drawn rows[] = {
        { ROUND, 32003, 1, 0, USUAL, { 5, 22, 258, 4, 201426, 4160, { 28.403803, 37.791926, 6.3727163, 1.3602946e-12, 0 } } },
        { ROUND, 32103, 1, 0, ADMM, { 5, 17, 360, 5, 481436, 6960, { 65.254709, 25.64366, -28.253331, 2.9163448e-13, 0 } } },
        { ROUND, 32203, 1, 0, DENSE, { 104, 36, 281, 4, 324834, 3088,
          { 17.734715, 76.930104, -3.280342, 6.9924129, 1.3740963e+15 } } },
        { ROUND, 32303, 1, 0, PLAIN, { 104, 33, 316, 0, 559013, 7152,
          { 30.994244, 62.669915, -7.6428638, 245323.93, 54108972 } } },
        { ROUND, 32403, 1, 0, PLAIN_ADMM, { 10004, 14, 1200, 0, 758750, 5056,
          { 41.16002, 209.37758, 12.11258, 6.6591745, 0 } } },
        { ROUND, 32503, 1, 0, RELAXED, { 5, 13, 310, 5, 275032, 4272,
          { 25.034945, 79.280959, 0.59997902, 1.2667613e-14, 0 } } },
        { LINEAR, 32603, 1, 0, USUAL, { 5, 20, 408, 4, 609843, 6976,
          { 43.491094, 47.000747, -0.69531448, 1.2162641e-13, 0 } } },
        { LINEAR, 32703, 1, 0, ADMM, { 2003, 10, 130, 3, 208858, 5376,
          { 62.041013, 9.3649531, -5415582.4, 11425104, 5656193.2 } } },
        { LINEAR, 32803, 1, 0, DENSE, { 104, 41, 221, 4, 364132, 2936,
          { 26.832181, 23.479972, 1.0767622, 5.5122975, 11649465 } } },
        { LINEAR, 32903, 1, 0, PLAIN, { 5, 9, 64, 0, 27228, 3056, { 37.809385, 11.97759, 0, 2.7499626e-06, 0 } } },
        { LINEAR, 33003, 1, 0, PLAIN_ADMM, { 1004, 4, 140, 0, 26992, 2480,
          { 14.507472, 25.103265, -38752.658, 77506.629, 5243189.5 } } },
        { LINEAR, 33103, 1, 0, RELAXED, { 11003, 3804, 1370, 3, 4290023, 3120,
          { 166191.67, 6.5723767, -122.5975, 3164.2961, 8.2907472e+14 } } },
        { FLAT | TIED, 33203, 1, 0, USUAL, { 5, 28, 87, 5, 88997, 2392,
          { 18.381586, 15.160153, -4.8818878, 4.1540639e-14, 0 } } },
        { FLAT | TIED, 33303, 1, 0, ADMM, { 5, 13, 120, 5, 200147, 4448,
          { 13.514012, 50.234267, -2.3283439, 5.8307951e-15, 0 } } },
        { FLAT | TIED, 33403, 1, 0, DENSE, { 5, 44, 122, 5, 543246, 3120,
          { 26.887032, 112.54903, -3.2088992, 1.5518431e-13, 0 } } },
        { FLAT | TIED, 33503, 1, 0, PLAIN, { 2003, 6, 92, 0, 72930, 5168,
          { 66.309297, 1.0000001, -48523056, 97046084, 36805168 } } },
        { FLAT | TIED, 33603, 1, 0, PLAIN_ADMM, { 1004, 6, 720, 0, 1059148, 9216,
          { 83.844118, 45.401317, -20559839, 41119674, 8464297.9 } } },
        { FLAT | TIED, 33703, 1, 0, RELAXED, { 5, 12, 150, 5, 153679, 3728,
          { 34.268571, 23.40946, 0.72877269, 2.1956899e-15, 0 } } },
        { FLAT | EMPTY, 33803, 1, 0, USUAL, { 401, 47, 523, 1, 761282, 6304,
          { 14.05305, 26.141464, -4281168.5, 9351881.8, 7.4265231e+15 } } },
        { FLAT | EMPTY, 33903, 1, 0, ADMM, { 1400, 4, 210, 0, 146636, 5392,
          { 11.09054, 12.472136, -307937.07, 615958.71, 2.4633557e+10 } } },
        { FLAT | EMPTY, 34003, 1, 0, DENSE, { 500, 139, 1312, 0, 2116798, 3192,
          { 3.000625, 23.315319, -3.8295182, 505.4311, 1.9029762e+15 } } },
        { FLAT | EMPTY, 34103, 1, 0, PLAIN, { 1400, 13, 248, 0, 198127, 4736,
          { 10.770435, 23.928203, -6626.3664, 15196.013, 1.8049683e+12 } } },
        { FLAT | EMPTY, 34203, 1, 0, PLAIN_ADMM, { 2300, 3, 840, 0, 688221, 6400,
          { 19.334344, 18.196152, -21943627, 43887277, 1.3718744e+09 } } },
        { FLAT | EMPTY, 34303, 1, 0, RELAXED, { 500, 5, 180, 0, 120006, 5392,
          { 22.000001, 37.660254, -13526.446, 55156.019, 5.4187837e+15 } } }
    };
    COMPARE(rows, change_it);
}

TEST(up_to_ten_times_off_is_inaccurate)
{
    near_eps(ADMM, ROUND);
    near_eps(DENSE_ADMM, FLAT);
    near_eps(DYKSTRA, DIAGONAL);
}

/* An objective b and a gap 2 b, both numbers; their sum is none. The guess is judged. */
TEST(figures_whose_sum_overflows_are_no_answer)
{
    static const sp_real q = R(0.8e154), x = R(1e154);
    const sp_qp qp = { 1, 0, NULL, NULL, NULL, &q, NULL, NULL, NULL, NULL, NULL };
    sp_qp_settings set = asked(PLAIN_ADMM);
    sp_qp_result r;
    set.budget = 1;
    CHECK_INT(sp_qp_solve(&qp, &set, &test_arena, &x, NULL, &r), SP_OK);
    CHECK_INT(r.status, SP_QP_NUMERICAL);
}

/* Entries 1e-300 and 1e300 in a column: the third pass makes the scale of a row more than any number, that of the column is
 * well. */
TEST(a_scale_that_overflows_alone_is_refused)
{
    static const sp_real x[2] = { R(1e-300), R(1e300) }, l[2] = { -1, -1 }, u[2] = { 1, 1 };
    static const int32_t one[2] = { 0, 2 }, down[2] = { 0, 1 };
    const sp_qp column = { 1, 2, NULL, NULL, NULL, NULL, one, down, x, l, u };
    sp_qp_settings set = asked(ADMM);
    sp_qp_result r;
    set.passes = 3;
    CHECK_INT(sp_qp_solve(&column, &set, &test_arena, NULL, NULL, &r), SP_E_NOT_FINITE);
    set.passes = 2;
    CHECK_INT(sp_qp_solve(&column, &set, &test_arena, NULL, NULL, &r), SP_OK);
}

/* 1 / q is more than any number. */
TEST(a_scale_of_the_objective_that_overflows_is_refused)
{
    static const sp_real q = R(1e-310), l = -1, u = 1, x = 1;
    static const int32_t p0[2] = { 0, 1 }, i0 = 0;
    const sp_qp qp = { 1, 1, NULL, NULL, NULL, &q, p0, &i0, &x, &l, &u };
    const sp_qp none = { 0, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL };
    const sp_qp_settings set = asked(ADMM);
    sp_qp_result r;
    CHECK_INT(sp_qp_solve(&qp, &set, &test_arena, NULL, NULL, &r), SP_E_NOT_FINITE);
    CHECK_INT(sp_qp_memory_scratch(&none, &set), 0);
}
#endif

TEST_LIST(programs)
#if defined TALLY_ALL && COUNTED
    RUN(drawn_programs_take_the_work_written_here)
    RUN(drawn_programs_asked_otherwise_take_the_work_written_here)
    RUN(drawn_programs_of_many_equations_take_the_work_written_here)
    RUN(drawn_programs_without_solution_take_the_work_written_here)
    RUN(drawn_programs_of_any_scale_take_the_work_written_here)
    RUN(drawn_programs_of_extreme_scale_take_the_work_written_here)
    RUN(drawn_projections_take_the_work_written_here)
    RUN(drawn_programs_with_little_to_spend_take_the_work_written_here)
    RUN(drawn_programs_spent_near_a_look_take_the_work_written_here)
    RUN(drawn_projections_with_little_to_spend_take_the_work_written_here)
    RUN(drawn_programs_from_a_guess_take_the_work_written_here)
    RUN(drawn_programs_from_far_away_take_the_work_written_here)
    RUN(drawn_programs_that_fall_along_a_line_are_refused_as_written_here)
    RUN(drawn_programs_that_change_take_the_work_written_here)
    RUN(up_to_ten_times_off_is_inaccurate)
    RUN(figures_whose_sum_overflows_are_no_answer)
    RUN(a_scale_that_overflows_alone_is_refused)
    RUN(a_scale_of_the_objective_that_overflows_is_refused)
#endif
TEST_END
