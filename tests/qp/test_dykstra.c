/* The seed's first solver: right where it can be, never a claim it can't make, and no number that is none where the seed's own
 * ran off to 1e60. */
#include "../test.h"

#include <math.h>
#include <string.h>

#if !defined(SP_NO_QP) && !defined(SP_NO_DYKSTRA)

enum { N = 12, M = 30 };

typedef struct sample {
    sp_qp qp;
    int32_t Pp[N + 1], Pi[N], Ap[N + 1], Ai[N * M];
    sp_real Px[N], Ax[N * M], q[N], l[M], u[M];
} sample;

static sample s;

static sp_qp_result solve(const sp_qp *qp, const sp_qp_settings *set)
{
    const sp_qp_solver solver = sp_qp_dykstra();
    sp_qp_result r;
    memset(&r, 0, sizeof r);
    CHECK_INT(solver.solve(solver.self, qp, set, &test_arena, NULL, NULL, &r), SP_OK);
    CHECK(r.iterations <= 500);
    CHECK(isfinite((double)r.objective) && isfinite((double)r.primal) && isfinite((double)r.dual) && isfinite((double)r.gap));
    for (int32_t j = 0; j < qp->n; j++) if (!CHECK(isfinite((double)r.x[j]))) break;
    for (int32_t i = 0; i < qp->m; i++) if (!CHECK(isfinite((double)r.y[i]))) break;
    CHECK(r.status == SP_QP_SOLVED || r.status == SP_QP_INACCURATE || r.status == SP_QP_ITERATIONS || r.status == SP_QP_NUMERICAL);
    return r;
}

/* n unknowns, a diagonal P, rows with a common point, `equations` of them. */
static void make(int32_t n, int32_t m, int32_t equations)
{
    double x[N], a[M][N];
    int32_t k = 0;
    for (int32_t j = 0; j < n; j++) x[j] = (double)test_random_real(-1, 1);
    for (int32_t i = 0; i < m; i++) {
        double z = 0;
        for (int32_t j = 0; j < n; j++) {
            a[i][j] = test_random_int(0, 2) ? (double)test_random_real(-1, 1) : 0;
            z += a[i][j] * x[j];
        }
        s.l[i] = R(i < equations ? z : test_random_int(0, 1) ? -1e30 : z - (double)test_random_real(0, 1));
        s.u[i] = i < equations ? s.l[i] : R(z + (double)test_random_real(0, 1));
    }
    for (int32_t j = 0; j < n; j++) {
        s.Pp[j] = s.Pi[j] = j;
        s.Px[j] = test_random_real(0.5, 2);
        s.q[j] = test_random_real(-1, 1);
        s.Ap[j] = k;
        for (int32_t i = 0; i < m; i++) if (a[i][j] > 0 || a[i][j] < 0) { s.Ai[k] = i; s.Ax[k++] = R(a[i][j]); }
    }
    s.Pp[n] = n;
    s.Ap[n] = k;
    const sp_qp qp = { n, m, s.Pp, s.Pi, s.Px, s.q, s.Ap, s.Ai, s.Ax, s.l, s.u };
    s.qp = qp;
}

/* Row b becomes `factor` times row a, in the columns that have entries of both. */
static void same_row(int32_t a, int32_t b, sp_real factor, int32_t n)
{
    for (int32_t j = 0; j < n; j++) {
        int32_t at_a = -1, at_b = -1;
        for (int32_t k = s.Ap[j]; k < s.Ap[j + 1]; k++) {
            if (s.Ai[k] == a) at_a = k;
            if (s.Ai[k] == b) at_b = k;
        }
        if (at_a >= 0) s.Ax[at_a] = at_b >= 0 ? s.Ax[at_a] : 0;
        if (at_b >= 0) s.Ax[at_b] = at_a >= 0 ? factor * s.Ax[at_a] : 0;
    }
}

/* The point of x + y = 1, x <= 1/4 nearest to 0 in the metric diag(1, 3): without the bound (3/4, 1/4), with it (1/4, 3/4). */
TEST(nearest_point_of_a_line_and_a_bound)
{
    const sp_qp_settings set = sp_qp_default();
    make(2, 2, 1);
    s.Px[0] = 1; s.Px[1] = 3;
    s.q[0] = s.q[1] = 0;
    s.Ap[0] = 0; s.Ap[1] = 2; s.Ap[2] = 3;
    s.Ai[0] = 0; s.Ai[1] = 1; s.Ai[2] = 0;
    s.Ax[0] = s.Ax[1] = s.Ax[2] = 1;
    s.l[0] = s.u[0] = 1;
    for (int bound = 0; bound < 2; bound++) {
        s.l[1] = R(-1e30);
        s.u[1] = bound ? R(0.25) : R(1e30);
        const sp_qp_result r = solve(&s.qp, &set);
        CHECK_INT(r.status, SP_QP_SOLVED);
        CHECK_NEAR(r.x[0], bound ? 0.25 : 0.75, TOL(1e-6, 1e-4));
        CHECK_NEAR(r.x[1], bound ? 0.75 : 0.25, TOL(1e-6, 1e-4));
        CHECK_NEAR(r.y[0], bound ? -2.25 : -0.75, TOL(1e-5, 1e-3));            /* P x + A'y = 0 */
        CHECK_WITHIN(r.y[1], bound ? 2 : 0, TOL(1e-5, 1e-3));
    }
}

/* What it calls solved is what our own solver finds; it may give up. */
TEST(solved_means_solved)
{
    int solved = 0;
    for (int trial = 0; trial < 60; trial++) {
        sp_qp_settings set = sp_qp_default();
        sp_qp_result own;
        test_arena.used = 0;
        make(test_random_int(2, N), test_random_int(1, M), trial % 3);
        set.eps_abs = set.eps_rel = R(TOL(1e-7, 1e-4));
        const sp_qp_result r = solve(&s.qp, &set);
        if (r.status != SP_QP_SOLVED) continue;
        solved++;
        NEED(sp_qp_solve(&s.qp, &set, &test_arena, NULL, NULL, &own) == SP_OK);
        if (own.status == SP_QP_SOLVED) CHECK_WITHIN(r.objective, (double)own.objective, TOL(1e-5, 1e-2) * (1 + fabs((double)own.objective)));
        CHECK(own.status != SP_QP_PRIMAL_INFEASIBLE);
    }
    CHECK(solved > 20);
}

/* Rows that contradict each other: no claim at all, whatever it ends with. */
TEST(what_has_no_solution_is_never_solved)
{
    const sp_qp_settings set = sp_qp_default();
    for (int trial = 0; trial < 30; trial++) {
        test_arena.used = 0;
        make(4, 6, trial % 2);
        same_row(4, 5, -1, 4);                          /* row 5 the opposite of row 4, no room between */
        s.l[4] = s.l[5] = R(-1e30);
        s.u[4] = -1; s.u[5] = R(0.5);
        CHECK(solve(&s.qp, &set).status != SP_QP_SOLVED);
    }
}

/* A P it can't take, equations that depend on each other. */
TEST(what_it_cannot_do_is_numerical)
{
    static const int32_t Pi[] = { 0, 0, 1 }, Pp[] = { 0, 1, 3 };
    static const sp_real Px[] = { 2, 1, 2 };
    const sp_qp_settings set = sp_qp_default();
    make(2, 2, 2);
    s.qp.Pp = Pp; s.qp.Pi = Pi; s.qp.Px = Px;
    CHECK_INT(solve(&s.qp, &set).status, SP_QP_NUMERICAL);
    make(5, 4, 4);
    same_row(2, 3, 1, 5);
    CHECK_INT(solve(&s.qp, &set).status, SP_QP_NUMERICAL);
}

/* ----------------------------------------------------------------------------------------------------------- masonry rows */

#ifndef SP_QP_ONLY
#include "../scenes/gen.h"

/* The penalty program as it comes, in newtons and metres, 4 columns a vertex, rows times 10^+-e where e > 0; our own stage
 * scales what this one doesn't. */
static int masonry(const char *name, double size, int e, sp_qp *qp)
{
    gen_scene g;
    sp_scene *scene = (sp_scene *)(void *)(test_arena.base + test_arena.used);
    sp_settings set = sp_settings_default();
    sp_problem pb;
    sp_triplets aeq, afr;
    sp_csc A;
    test_arena.used += (sizeof *scene + SP_ALIGN) / SP_ALIGN * SP_ALIGN;
    gen_open(&g, name);
    if (gen_build(&g, &test_arena, scene) != SP_OK) return 0;
    for (int32_t i = 0; i < scene->count.points; i++) for (int c = 0; c < 3; c++) scene->point[i][c] *= R(size);
    for (int32_t i = 0; i < scene->count.blocks; i++) for (int c = 0; c < 3; c++) scene->block[i].centroid[c] *= R(size);
    set.faces = 8;
    if (sp_problem_build(scene, &test_arena, &pb) || sp_matrix_aeq(&pb, 4, &test_arena, &aeq)) return 0;
    if (sp_matrix_afr(&pb, &set, 4, &test_arena, &afr)) return 0;
    const int32_t n = 4 * pb.points, eq = 6 * pb.blocks, fr = 8 * pb.points, m = eq + fr + 2 * pb.points, count = aeq.count + afr.count;
    const size_t room = (size_t)(count + n + m + 4);
    int32_t *I = (int32_t *)(void *)(test_arena.base + test_arena.used), *J = I + room, *Pp = J + room;
    test_arena.used += (3 * room * sizeof *I + SP_ALIGN) / SP_ALIGN * SP_ALIGN;
    sp_real *X = (sp_real *)(void *)(test_arena.base + test_arena.used), *Px = X + room, *l = Px + n, *u = l + m, *scale = u + m;
    test_arena.used += ((room + (size_t)n + 3 * (size_t)m) * sizeof *X + SP_ALIGN) / SP_ALIGN * SP_ALIGN;
    for (int32_t i = 0; i < m; i++) scale[i] = R(e ? pow(10, test_random_int(-e, e)) : 1);
    sp_triplets t = { m, n, 0, I, J, X };
    for (int32_t k = 0; k < count; k++) {
        const sp_triplets *from = k < aeq.count ? &aeq : &afr;
        const int32_t q = k < aeq.count ? k : k - aeq.count;
        I[k] = from->i[q] + (k < aeq.count ? 0 : eq);
        J[k] = from->j[q];
        X[k] = from->x[q] * scale[I[k]];
    }
    t.count = count;
    for (int32_t v = 0; v < 2 * pb.points; v++, t.count++) { I[t.count] = eq + fr + v; J[t.count] = 4 * (v / 2) + v % 2; X[t.count] = 1; }
    if (sp_csc_from(&t, &test_arena, &A)) return 0;
    for (int32_t j = 0; j <= n; j++) Pp[j] = j;
    for (int32_t j = 0; j < n; j++) Px[j] = j % 4 == 1 ? 1000 : 1;
    for (int32_t i = 0; i < m; i++) {
        l[i] = i < eq ? -pb.p[i] * scale[i] : i < eq + fr ? R(-1e30) : 0;
        u[i] = i < eq ? l[i] : i < eq + fr ? 0 : R(1e30);
    }
    const sp_qp made = { n, m, Pp, Pp, Px, NULL, A.p, A.i, A.x, l, u };
    *qp = made;
    return 1;
}

/* Joints a tenth of a micrometre wide, or rows from 1e-8 to 1e8 of each other: the seed's went to 1e60 on the like. */
TEST(mixed_scale_masonry_rows_end_as_numerical)
{
    static const struct { const char *name; double size; int e; } row[] = {
        { "two-cubes", 1e-7, 0 }, { "arch", 1e-7, 0 }, { "two-cubes", 1, 8 }, { "arch", 1, 8 }, { "wall", 1, 8 }, { "wall", 1e-7, 0 }
    };
    const sp_qp_settings set = sp_qp_default();
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        sp_qp qp;
        test_arena.used = 0;
        NEED(masonry(row[k].name, row[k].size, row[k].e, &qp));
        const sp_qp_result r = solve(&qp, &set);
        if (!CHECK_INT(r.status, SP_QP_NUMERICAL)) CHECK_TEXT(row[k].name, "");
    }
}

/* Plugged into the check it is only one more who proposes: stable scenes may be decided, falling ones never stand. */
#ifndef SP_NO_ADMM
TEST(in_a_check_it_decides_nothing_wrongly)
{
    static const struct { const char *name, *param; double value; sp_verdict truth; } scene_of[] = {
        { "two-cubes", NULL, 0, SP_STABLE }, { "two-cubes", "offset", 0.7, SP_UNSTABLE }, { "arch", NULL, 0, SP_STABLE },
        { "arch", "t", 0.08, SP_UNSTABLE }, { "incline", "angle", 45, SP_UNSTABLE }, { "wall", "size", 54, SP_STABLE }
    };
    const sp_qp_solver solver = sp_qp_dykstra();
    int right = 0;
    for (size_t k = 0; k < 2 * sizeof scene_of / sizeof scene_of[0]; k++) {
        gen_scene g;
        sp_scene scene;
        sp_result r;
        sp_settings set = sp_settings_seed();
        size_t bytes = 0;
        test_arena.used = 0;
        gen_open(&g, scene_of[k / 2].name);
        if (scene_of[k / 2].param) gen_set(&g, scene_of[k / 2].param, scene_of[k / 2].value);
        NEED(gen_build(&g, &test_arena, &scene) == SP_OK);
        set.penalty.solver = &solver;
        set.penalty.net = k % 2 ? 1 : 0;
        set.stage_count = 1;
        set.stage[0] = SP_STAGE_ADMM;
        NEED(sp_memory(&scene, SP_FOR_CHECK, &set, test_arena, &bytes) == SP_OK);
        sp_arena exact = { test_arena.base + (test_arena.used + SP_ALIGN) / SP_ALIGN * SP_ALIGN, bytes, 0, 0 };
        NEED(sp_check(&scene, &set, &exact, &r) == SP_OK);
        CHECK_INT(r.spent.peak_bytes, bytes);
        CHECK(r.verdict == SP_UNDECIDED || r.verdict == scene_of[k / 2].truth);
        right += r.verdict == SP_STABLE;
    }
    CHECK(right >= 2);
}
#endif
#endif

TEST(dykstra_memory_is_exact)
{
    const sp_qp_solver solver = sp_qp_dykstra();
    const sp_qp_settings set = sp_qp_default();
    for (int trial = 0; trial < 12; trial++) {
        size_t bytes = 0;
        sp_arena a;
        sp_qp_result r;
        make(test_random_int(1, N), test_random_int(1, M), test_random_int(0, 1));
        NEED(solver.need(solver.self, &s.qp, &set, test_arena, &bytes) == SP_OK);
        sp_arena_init(&a, test_arena.base, bytes);
        CHECK_INT(solver.solve(solver.self, &s.qp, &set, &a, NULL, NULL, &r), SP_OK);
        CHECK_INT(a.peak, bytes);
        memset(&r, 0x5a, sizeof r);
        const sp_qp_result before = r;
        sp_arena_init(&a, test_arena.base, bytes - 1);
        CHECK_INT(solver.solve(solver.self, &s.qp, &set, &a, NULL, NULL, &r), SP_E_MEMORY);
        CHECK(a.used == 0 && memcmp(&r, &before, sizeof r) == 0);
    }
}

TEST_LIST(dykstra)
    RUN(nearest_point_of_a_line_and_a_bound)
    RUN(solved_means_solved)
    RUN(what_has_no_solution_is_never_solved)
    RUN_FULL(what_it_cannot_do_is_numerical)
#ifndef SP_QP_ONLY
    RUN_FULL(mixed_scale_masonry_rows_end_as_numerical)
#ifndef SP_NO_ADMM
    RUN_FULL(in_a_check_it_decides_nothing_wrongly)
#endif
#endif
    RUN(dykstra_memory_is_exact)
TEST_END

#else

TEST_LIST(dykstra)
TEST_END

#endif
