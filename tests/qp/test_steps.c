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

/* One problem, its status added to *status, its work to *sum, with interior those polished. AGAIN: set up once, run, q changed, run from there, rho changed, run. */
static void solve(way w, int *status, sp_cost *sum)
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
        for (int number = 0; number < EACH; number++) {
            make(rows[k].of, number, rows[k].by == DYKSTRA);
            solve(rows[k].by, &status, &sum);
        }
        tally_compare("programs", k, &rows[k].is, status, &sum);
    }
}

#define COMPARE(rows) compare(rows, sizeof (rows) / sizeof *(rows))

TEST(programs_by_admm_take_the_work_written_here)
{
    static const row rows[] = {
        { STRICT, ADMM, { 0, 17, 350, 4, 366421 } },
        { LINEAR, ADMM, { 0, 14, 400, 4, 331845 } },
        { EQUATIONS, ADMM, { 0, 16, 400, 4, 498511 } },
        { SINGULAR, ADMM, { 0, 19, 500, 4, 602410 } },
        { INFEASIBLE, ADMM, { 8, 8, 400, 0, 296466 } },
        { UNBOUNDED, ADMM, { 12, 4, 40, 0, 27353 } },
        { SPREAD, ADMM, { 0, 15, 400, 4, 452931 } },
        { STRICT, DENSE, { 0, 17, 350, 4, 451641 } },
        { LINEAR, DENSE, { 0, 14, 400, 4, 383478 } },
        { EQUATIONS, DENSE, { 0, 16, 400, 4, 584392 } },
        { SINGULAR, DENSE, { 0, 19, 500, 4, 714237 } },
        { INFEASIBLE, DENSE, { 8, 8, 400, 0, 383428 } },
        { UNBOUNDED, DENSE, { 12, 4, 40, 0, 37976 } },
        { SPREAD, DENSE, { 0, 15, 400, 4, 545355 } },
        { STRICT, NO_POLISH, { 0, 8, 680, 0, 461683 } },
        { LINEAR, NO_POLISH, { 5, 4, 1440, 0, 949995 } },
        { EQUATIONS, NO_POLISH, { 1, 9, 970, 0, 676347 } },
        { SINGULAR, NO_POLISH, { 4, 10, 1180, 0, 824199 } },
        { INFEASIBLE, NO_POLISH, { 8, 9, 660, 0, 470618 } },
        { UNBOUNDED, NO_POLISH, { 12, 4, 40, 0, 27353 } },
        { SPREAD, NO_POLISH, { 1, 5, 1140, 0, 821944 } },
        { STRICT, LOOSE, { 0, 17, 190, 4, 200415 } },
        { LINEAR, LOOSE, { 0, 21, 400, 4, 335964 } },
        { EQUATIONS, LOOSE, { 0, 17, 290, 4, 315200 } },
        { SINGULAR, LOOSE, { 0, 20, 320, 4, 343544 } },
        { INFEASIBLE, LOOSE, { 8, 17, 310, 0, 228971 } },
        { UNBOUNDED, LOOSE, { 12, 4, 40, 0, 27353 } },
        { SPREAD, LOOSE, { 0, 14, 240, 4, 300385 } }
    };
    COMPARE(rows);
}

TEST(programs_by_conjugate_gradients_take_the_work_written_here)
{
    static const row rows[] = {
        { STRICT, BY_CG, { 0, 17, 350, 4, 1714564 } },
        { LINEAR, BY_CG, { 0, 14, 400, 4, 1462682 } },
        { EQUATIONS, BY_CG, { 0, 16, 400, 4, 2142380 } },
        { SINGULAR, BY_CG, { 0, 19, 500, 4, 2616448 } },
        { INFEASIBLE, BY_CG, { 8, 8, 400, 0, 1748932 } },
        { UNBOUNDED, BY_CG, { 12, 4, 40, 0, 162390 } },
        { SPREAD, BY_CG, { 0, 15, 400, 4, 2120012 } }
    };
    COMPARE(rows);
}

TEST(programs_by_interior_points_and_projections_take_the_work_written_here)
{
    static const row rows[] = {
        { STRICT, INTERIOR, { 0, 40, 36, 0, 253550 } },
        { LINEAR, INTERIOR, { 0, 42, 34, 0, 229314 } },
        { EQUATIONS, INTERIOR, { 0, 38, 34, 0, 242127 } },
        { SINGULAR, INTERIOR, { 0, 39, 35, 0, 250229 } },
        { INFEASIBLE, INTERIOR, { 8, 33, 29, 0, 218057 } },
        { UNBOUNDED, INTERIOR, { 12, 12, 8, 0, 58665 } },
        { SPREAD, INTERIOR, { 0, 38, 34, 0, 247798 } },
        { STRICT, DYKSTRA, { 0, 4, 278, 0, 103060 } },
        { EQUATIONS, DYKSTRA, { 0, 4, 365, 0, 149576 } },
        { INFEASIBLE, DYKSTRA, { 16, 4, 2000, 0, 808000 } }
    };
    COMPARE(rows);
}

TEST(programs_that_go_on_or_end_early_take_the_work_written_here)
{
    static const row rows[] = {
        { STRICT, AGAIN, { 0, 38, 880, 12, 1077276 } },
        { LINEAR, AGAIN, { 0, 40, 1200, 12, 990451 } },
        { EQUATIONS, AGAIN, { 0, 39, 1040, 12, 1233721 } },
        { SINGULAR, AGAIN, { 0, 36, 1290, 12, 1393921 } },
        { INFEASIBLE, AGAIN, { 24, 18, 940, 0, 687280 } },
        { UNBOUNDED, AGAIN, { 36, 8, 120, 0, 80496 } },
        { SPREAD, AGAIN, { 0, 46, 1170, 12, 1241920 } },
        { STRICT, SPENT, { 16, 4, 185, 0, 135272 } },
        { LINEAR, SPENT, { 20, 4, 196, 0, 136717 } },
        { EQUATIONS, SPENT, { 20, 4, 182, 0, 134401 } },
        { SINGULAR, SPENT, { 20, 4, 178, 0, 133444 } },
        { INFEASIBLE, SPENT, { 20, 4, 175, 0, 132832 } },
        { UNBOUNDED, SPENT, { 12, 4, 40, 0, 27353 } },
        { SPREAD, SPENT, { 20, 4, 170, 0, 131974 } }
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
