/* Work of small quadratic programs, counted to the flop, by every method and back end: a method that is changed takes another way to
 * the same solution. Problems are those of a generator of this file, whatever seed the tests have. */
#include "../scenes/tally.h"

#if !defined SP_NO_QP && !defined SP_SMALL && !defined SP_QP_NO_CG && !defined SP_QP_NO_POLISH && !defined SP_QP_NO_INTERIOR \
 && !defined SP_NO_DYKSTRA && !defined SP_QP_ONLY
#define ALL_WAYS

enum { N = 7, M = 10, EACH = 4 };

typedef enum kind { STRICT, LINEAR, EQUATIONS, SINGULAR, INFEASIBLE, UNBOUNDED, SPREAD } kind;
typedef enum way { ADMM, INTERIOR, DENSE, BY_CG, NO_POLISH, LOOSE, DYKSTRA, AGAIN, SPENT } way;

typedef struct sample {
    sp_qp qp;
    int32_t Pp[N + 1], Pi[N * N], Ap[N + 1], Ai[N * M];
    sp_real Px[N * N], Ax[N * M], q[N], l[M], u[M];
} sample;

static sample s;
static uint64_t state;

/* -1 .. 1, by 53 bits of a linear congruence.                                                                       [Knuth] */
static double any(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)(state >> 11) * 0x1p-52 - 1;
}

/* P = G G' + shift I where any; l <= A x0 <= u of a random x0, one side mostly near. */
static void make(kind k, int number, int diagonal)
{
    double g[N][N], a[M][N], x0[N];
    int32_t p = 0, e = 0;
    state = 977u * (uint64_t)number + (uint64_t)k;
    for (int i = 0; i < N; i++) for (int j = 0; j < N; j++) g[i][j] = any();
    for (int i = 0; i < M; i++) for (int j = 0; j < N; j++) a[i][j] = any() < 0 ? 0 : any();
    for (int j = 0; j < N; j++) { a[j][j] = 1 + any() / 2; x0[j] = any(); s.q[j] = R(any()); }
    for (int i = 0; i < M; i++) {
        const double size = k == SPREAD ? (i % 3 == 0 ? 1e3 : i % 3 == 1 ? 1e-3 : 1) : 1;
        double z = 0;
        for (int j = 0; j < N; j++) { a[i][j] *= size; z += a[i][j] * x0[j]; }
        const double near = any() < 0 ? 0.01 : 0.5;
        s.l[i] = R(z - size * (1 + any()) * near);
        s.u[i] = i % 4 == 3 ? R(1e30) : R(z + size * (1 + any()) * near);
        if (k == EQUATIONS && i < 3) s.l[i] = s.u[i] = R(z);
        if (k == UNBOUNDED) { s.l[i] = R(i ? -1e30 : z - 1); s.u[i] = R(1e30); }
    }
    if (k == INFEASIBLE) {
        for (int j = 0; j < N; j++) a[M - 1][j] = -a[0][j];
        s.l[M - 1] = R(1 - (double)s.l[0]);
        s.u[M - 1] = R(1e30);
    }
    const int rank = k == LINEAR || k == UNBOUNDED ? 0 : k == SINGULAR ? 2 : N;
    for (int j = 0; j < N; j++) {
        s.Pp[j] = p;
        s.Ap[j] = e;
        for (int i = 0; i <= j; i++) {
            double t = i == j && rank == N ? 0.1 : 0;
            for (int r = 0; r < rank; r++) t += diagonal ? (i == j) * g[i][r] * g[i][r] : g[i][r] * g[j][r];
            if (rank && (t > 0 || t < 0)) { s.Pi[p] = i; s.Px[p++] = R(t); }
        }
        for (int i = 0; i < M; i++) if (a[i][j] > 0 || a[i][j] < 0) { s.Ai[e] = i; s.Ax[e++] = R(a[i][j]); }
    }
    s.Pp[N] = p;
    s.Ap[N] = e;
    const sp_qp made = { N, M, rank ? s.Pp : NULL, rank ? s.Pi : NULL, rank ? s.Px : NULL, s.q, s.Ap, s.Ai, s.Ax, s.l, s.u };
    s.qp = made;
}

static sp_qp_settings asked(way w)
{
    sp_qp_settings set = sp_qp_default();
    set.method = w == INTERIOR ? SP_QP_INTERIOR : SP_QP_ADMM;
    set.backend = w == DENSE ? SP_QP_DENSE : w == BY_CG ? SP_QP_CG : SP_QP_SPARSE;
    if (w == NO_POLISH) { set.polish = 0; set.iterations = 400; }
    if (w == LOOSE) { set.strict = 0; set.eps_abs = set.eps_rel = R(1e-3); set.adapt = 20; }
    if (w == SPENT) set.budget = 60000;
    return set;
}

/* One problem, its status added to *status, its work to *sum, with interior those polished, sizes of x, y, the objective, radius and
 * rho to found. AGAIN: set up once, run, q changed, run from there, rho changed, run. */
static void solve(way w, int *status, sp_cost *sum, double found[TALLY_FOUND])
{
    const sp_qp_settings set = asked(w);
    sp_qp_result r;
    sp_qp_work *work;
    sp_real q[N];
    const int rounds = w == AGAIN ? 3 : 1;
    test_arena.used = 0;
    if (w == AGAIN) CHECK_INT(sp_qp_setup(&s.qp, &set, &test_arena, &work), SP_OK);
    for (int k = 0; k < rounds; k++) {
        if (w == DYKSTRA) CHECK_INT(sp_qp_dykstra().solve(NULL, &s.qp, &set, &test_arena, NULL, NULL, &r), SP_OK);
        else if (w != AGAIN) CHECK_INT(sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &r), SP_OK);
        else CHECK_INT(sp_qp_run(work, k ? r.x : NULL, k ? r.y : NULL, &r), SP_OK);
        *status += (int)r.status;
        sum->factorisations += r.factorisations;
        sum->iterations += r.iterations;
        sum->interior += r.polished;
        sum->flops += r.flops;
        found[0] += tally_size(r.x, N);
        found[1] += tally_size(r.y, M);
        found[2] += (double)r.objective;
        found[3] += (double)r.radius < 1e29 ? (double)r.radius : 0;
        found[4] += (double)r.rho;
        if (w != AGAIN) continue;
        for (int j = 0; j < N; j++) q[j] = s.q[j] + (k ? 0 : R(0.1));
        if (k) CHECK_INT(sp_qp_rho(work, 1), SP_OK);
        else CHECK_INT(sp_qp_update(work, q, NULL, NULL), SP_OK);
    }
}

typedef struct row { kind of; way by; tally is; } row;

static void compare(const row *rows, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        int status = 0;
        sp_cost sum = { 0, 0, 0, 0 };
        double found[TALLY_FOUND] = { 0 };
        test_arena.peak = 0;
        for (int number = 0; number < EACH; number++) {
            make(rows[k].of, number, rows[k].by == DYKSTRA);
            solve(rows[k].by, &status, &sum, found);
        }
        tally_compare("programs", k, &rows[k].is, status, &sum, test_arena.peak, found);
    }
}

#define COMPARE(rows) compare(rows, sizeof (rows) / sizeof *(rows))

TEST(programs_by_admm_take_the_work_written_here)
{
    static const row rows[] = {
        { STRICT, ADMM, { 0, 17, 350, 4, 366421,
          5904, { 5.541967, 16.853325, 6.2122191, 0, 1.6 } } },
        { LINEAR, ADMM, { 0, 14, 400, 4, 331845,
          5296, { 9.1103357, 10.510038, -7.0866458, 0, 0.4 } } },
        { EQUATIONS, ADMM, { 0, 16, 400, 4, 498511,
          5856, { 6.7728596, 22.169616, 3.7775967, 0, 2 } } },
        { SINGULAR, ADMM, { 0, 19, 500, 4, 602410,
          5808, { 6.238501, 14.522787, 1.8792978, 0, 4 } } },
        { INFEASIBLE, ADMM, { 8, 8, 400, 0, 296466,
          5984, { 0, 5.6568542, 17.459895, 4.6843951e+15, 2 } } },
        { UNBOUNDED, ADMM, { 12, 4, 40, 0, 27353,
          5408, { 6.1474527, 0, -61182524, 17028710, 0.4 } } },
        { SPREAD, ADMM, { 0, 15, 400, 4, 452931,
          5984, { 4.0469537, 5557.8943, 4.8904815, 0, 0.8 } } },
        { STRICT, DENSE, { 0, 17, 350, 4, 451641,
          2304, { 5.541967, 16.853325, 6.2122191, 0, 1.6 } } },
        { LINEAR, DENSE, { 0, 14, 400, 4, 383478,
          2304, { 9.1103357, 10.510038, -7.0866458, 0, 0.4 } } },
        { EQUATIONS, DENSE, { 0, 16, 400, 4, 584392,
          2304, { 6.7728596, 22.169616, 3.7775967, 0, 2 } } },
        { SINGULAR, DENSE, { 0, 19, 500, 4, 714237,
          2304, { 6.238501, 14.522787, 1.8792978, 0, 4 } } },
        { INFEASIBLE, DENSE, { 8, 8, 400, 0, 383428,
          2304, { 0, 5.6568542, 17.459895, 4.4578189e+15, 2 } } },
        { UNBOUNDED, DENSE, { 12, 4, 40, 0, 37976,
          2304, { 6.1474527, 0, -61182524, 17028710, 0.4 } } },
        { SPREAD, DENSE, { 0, 15, 400, 4, 545355,
          2304, { 4.0469537, 5557.8943, 4.8904815, 0, 0.8 } } },
        { STRICT, NO_POLISH, { 0, 8, 680, 0, 461683,
          5904, { 5.541962, 16.853258, 6.2122054, 0, 3.6 } } },
        { LINEAR, NO_POLISH, { 5, 4, 1440, 0, 949995,
          5296, { 9.10851, 10.317261, -7.0862157, 0, 0.4 } } },
        { EQUATIONS, NO_POLISH, { 1, 9, 970, 0, 676347,
          5856, { 6.7728281, 22.168842, 3.77755, 0, 4 } } },
        { SINGULAR, NO_POLISH, { 4, 10, 1180, 0, 824199,
          5808, { 6.2394459, 14.51782, 1.8792242, 0, 6 } } },
        { INFEASIBLE, NO_POLISH, { 8, 9, 660, 0, 470618,
          5984, { 0, 5.6568542, 17.800903, 5.3857483e+08, 4 } } },
        { UNBOUNDED, NO_POLISH, { 12, 4, 40, 0, 27353,
          5408, { 6.1474527, 0, -61182524, 17028710, 0.4 } } },
        { SPREAD, NO_POLISH, { 1, 5, 1140, 0, 821944,
          5984, { 4.0470117, 5557.3765, 4.8903401, 0, 0.8 } } },
        { STRICT, LOOSE, { 0, 17, 190, 4, 200415,
          5904, { 5.541967, 16.853325, 6.2122191, 0, 5.6 } } },
        { LINEAR, LOOSE, { 0, 21, 400, 4, 335964,
          5296, { 9.1103357, 10.510038, -7.0866458, 0, 1.6 } } },
        { EQUATIONS, LOOSE, { 0, 17, 290, 4, 315200,
          5856, { 6.7728596, 22.169616, 3.7775967, 0, 4 } } },
        { SINGULAR, LOOSE, { 0, 20, 320, 4, 343544,
          5808, { 6.238501, 14.522787, 1.8792978, 0, 6 } } },
        { INFEASIBLE, LOOSE, { 8, 17, 310, 0, 228971,
          5984, { 0, 5.6568542, 17.802328, 1.7090944e+15, 640 } } },
        { UNBOUNDED, LOOSE, { 12, 4, 40, 0, 27353,
          5408, { 6.1474527, 0, -61182524, 17028710, 0.4 } } },
        { SPREAD, LOOSE, { 0, 14, 240, 4, 300385,
          5984, { 4.0469537, 5557.8943, 4.8904815, 0, 0.8 } } }
    };
    COMPARE(rows);
}

TEST(programs_by_conjugate_gradients_take_the_work_written_here)
{
    static const row rows[] = {
        { STRICT, BY_CG, { 0, 17, 350, 4, 1714564,
          2480, { 5.541967, 16.853325, 6.2122191, 0, 1.6 } } },
        { LINEAR, BY_CG, { 0, 14, 400, 4, 1462682,
          2480, { 9.1103357, 10.510038, -7.0866458, 0, 0.4 } } },
        { EQUATIONS, BY_CG, { 0, 16, 400, 4, 2142380,
          2480, { 6.7728596, 22.169616, 3.7775967, 0, 2 } } },
        { SINGULAR, BY_CG, { 0, 19, 500, 4, 2616448,
          2480, { 6.238501, 14.522787, 1.8792978, 0, 4 } } },
        { INFEASIBLE, BY_CG, { 8, 8, 400, 0, 1748932,
          2480, { 0, 5.6568542, 17.459895, 4.5255894e+15, 2 } } },
        { UNBOUNDED, BY_CG, { 12, 4, 40, 0, 162390,
          2480, { 6.1474527, 0, -61182524, 17028710, 0.4 } } },
        { SPREAD, BY_CG, { 0, 15, 400, 4, 2120012,
          2480, { 4.0469537, 5557.8943, 4.8904815, 0, 0.8 } } }
    };
    COMPARE(rows);
}

TEST(programs_by_interior_points_and_projections_take_the_work_written_here)
{
    static const row rows[] = {
        { STRICT, INTERIOR, { 0, 40, 36, 0, 253550,
          5904, { 5.541967, 16.853325, 6.2122191, 0, 0.4 } } },
        { LINEAR, INTERIOR, { 0, 42, 34, 0, 229314,
          5376, { 9.1103357, 10.510038, -7.0866458, 0, 0.4 } } },
        { EQUATIONS, INTERIOR, { 0, 38, 34, 0, 242127,
          5856, { 6.7728596, 22.169616, 3.7775967, 0, 0.4 } } },
        { SINGULAR, INTERIOR, { 0, 39, 35, 0, 250229,
          5808, { 6.238501, 14.522787, 1.8792978, 0, 0.4 } } },
        { INFEASIBLE, INTERIOR, { 8, 33, 29, 0, 218057,
          5984, { 0, 5.6568541, 17.83946, 1.6953976e+09, 0.4 } } },
        { UNBOUNDED, INTERIOR, { 12, 12, 8, 0, 58665,
          5408, { 6.09225, 0, -20250647, 2.2088201e+09, 0.4 } } },
        { SPREAD, INTERIOR, { 0, 38, 34, 0, 247798,
          5984, { 4.0469537, 5557.8943, 4.8904815, 0, 0.4 } } },
        { STRICT, DYKSTRA, { 0, 4, 278, 0, 103060,
          1200, { 4.889679, 13.54435, 8.2640378, 0, 0 } } },
        { EQUATIONS, DYKSTRA, { 0, 4, 365, 0, 149576,
          1256, { 5.7735924, 18.361635, 9.0228146, 0, 0 } } },
        { INFEASIBLE, DYKSTRA, { 16, 4, 2000, 0, 808000,
          1216, { 6.4634536, 2260.4719, 14.890206, 0, 0 } } }
    };
    COMPARE(rows);
}

TEST(programs_that_go_on_or_end_early_take_the_work_written_here)
{
    static const row rows[] = {
        { STRICT, AGAIN, { 0, 38, 880, 12, 1077276,
          5904, { 16.556186, 51.60336, 18.559069, 0, 11.2 } } },
        { LINEAR, AGAIN, { 0, 40, 1200, 12, 990451,
          5296, { 27.318616, 31.814416, -21.389701, 0, 5.2 } } },
        { EQUATIONS, AGAIN, { 0, 39, 1040, 12, 1233721,
          5856, { 20.339825, 65.426102, 11.493444, 0, 10 } } },
        { SINGULAR, AGAIN, { 0, 36, 1290, 12, 1393921,
          5808, { 18.595369, 44.461578, 5.2765133, 0, 18 } } },
        { INFEASIBLE, AGAIN, { 24, 18, 940, 0, 687280,
          5984, { 0, 16.970563, 52.757876, 7.8958687e+15, 14 } } },
        { UNBOUNDED, AGAIN, { 36, 8, 120, 0, 80496,
          5408, { 18.957083, 0, -1.8648124e+08, 43264561, 4.8 } } },
        { SPREAD, AGAIN, { 0, 46, 1170, 12, 1241920,
          5984, { 12.119638, 16493.064, 15.004234, 0, 3.2 } } },
        { STRICT, SPENT, { 16, 4, 185, 0, 135272,
          5904, { 5.4262262, 10.163094, 5.4615167, 0, 0.4 } } },
        { LINEAR, SPENT, { 20, 4, 196, 0, 136717,
          5296, { 10.13868, 9.8713863, -7.9820744, 0, 0.4 } } },
        { EQUATIONS, SPENT, { 20, 4, 182, 0, 134401,
          5856, { 6.5795552, 10.530502, 3.05777, 0, 0.4 } } },
        { SINGULAR, SPENT, { 20, 4, 178, 0, 133444,
          5808, { 6.7951728, 9.7549306, 0.73688249, 0, 0.4 } } },
        { INFEASIBLE, SPENT, { 20, 4, 175, 0, 132832,
          5984, { 7.0346944, 35.000926, 16.728886, 0, 0.4 } } },
        { UNBOUNDED, SPENT, { 12, 4, 40, 0, 27353,
          5408, { 6.1474527, 0, -61182524, 17028710, 0.4 } } },
        { SPREAD, SPENT, { 20, 4, 170, 0, 131974,
          5984, { 4.0618547, 3801.2994, 3.9801773, 0, 0.4 } } }
    };
    COMPARE(rows);
}

#endif

TEST_LIST(steps)
#ifdef ALL_WAYS
    RUN(programs_by_admm_take_the_work_written_here)
    RUN(programs_by_conjugate_gradients_take_the_work_written_here)
    RUN(programs_by_interior_points_and_projections_take_the_work_written_here)
    RUN(programs_that_go_on_or_end_early_take_the_work_written_here)
#endif
TEST_END
