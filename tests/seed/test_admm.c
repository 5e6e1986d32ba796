/* The stage admm: the penalty form as a quadratic program, by our solver or another's, the preset of the seed with its table of
 * constants. It proposes; what it may not do is be believed. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>
#include <string.h>

#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)

static const double pi = 3.14159265358979323846;

static void build(const char *name, const char *param, double value, sp_scene *scene)
{
    gen_scene g;
    CHECK_INT(gen_open(&g, name), 1);
    if (param) CHECK_INT(gen_set(&g, param, value), 1);
    if (!strcmp(name, "wall")) gen_set(&g, "jitter", 0.35);
    CHECK_INT(gen_build(&g, &test_arena, scene), SP_OK);
}

static sp_settings admm(int faces, int inscribed, int net)
{
    sp_settings s = sp_settings_default();
    s.tol = R(TOL(1e-6, 1e-3));
    s.faces = faces;
    s.inscribed = inscribed;
    s.penalty.net = net;
    s.stage[1] = SP_STAGE_ADMM;
    return s;
}

static sp_result check(const sp_scene *scene, const sp_settings *settings)
{
    sp_result r;
    memset(&r, 0, sizeof r);
    CHECK_INT(sp_check(scene, settings, &test_arena, &r), SP_OK);
    CHECK_INT(r.verified, r.verdict != SP_UNDECIDED);
    for (int32_t k = 0; k < 3 * scene->count.points; k++) CHECK(isfinite((double)r.f[k]));
    for (int32_t k = 0; k < 6 * scene->count.blocks; k++) CHECK(isfinite((double)r.dq[k]));
    return r;
}

/* 1 ----------------------------------------------------------------------------------------------------------- constants */

/* The document's own numbers, typed in anew. A float has its own where it can't reach them. */
TEST(the_table_holds_the_seeds_numbers)
{
    const sp_seed *s = sp_seed_table();
    CHECK_INT(s->faces, 8);                             /* 1.4: K = 8 inscribed, friction on the net normal */
    CHECK_INT(s->inscribed, 1);
    CHECK_INT(s->net, 1);
    CHECK_NEAR(s->gamma, 1e3, 0);                       /* 1.5 */
    CHECK_NEAR(s->tau, 1, 0);
    CHECK_INT(s->dense_cells, 12000000);
    CHECK_NEAR(s->tension, 1e-3, SP_EPSILON);           /* 1.6 */
    CHECK_NEAR(s->balance, TOL(1e-6, 1e-5), SP_EPSILON);        /* 2.1 */
    CHECK_NEAR(s->cone, TOL(1e-7, 1e-5), SP_EPSILON);
    CHECK_NEAR(s->gain, 0.05, SP_EPSILON);              /* 2.2: 5 % in 250 rounds, at most 20000 */
    CHECK_INT(s->window, 250);
    CHECK_INT(s->rounds, 20000);
    CHECK_NEAR(s->engaged, 0.01, SP_EPSILON);           /* 3.2 */
    CHECK_NEAR(s->floor, 1e-9, SP_EPSILON);
    CHECK_NEAR(s->reg, TOL(1e-9, 1e-6), SP_EPSILON);
    CHECK_NEAR(s->gate, 0.5, 0);                        /* 3.3 */
    CHECK_NEAR(s->drop, 0.75, 0);
    CHECK_NEAR(s->slip_error, 2, 0);
    CHECK_INT(s->turns, 12);
    CHECK_NEAR(s->admm.sigma, TOL(1e-6, 1e-3), SP_EPSILON);     /* 4.2 */
    CHECK_NEAR(s->admm.relax, 1.6, SP_EPSILON);
    CHECK_NEAR(s->admm.rho, 0.1, SP_EPSILON);
    CHECK_NEAR(s->admm.rho_equal, TOL(1e3, 1e2), SP_EPSILON);
    CHECK_NEAR(s->admm.eps_abs, 1e-4, SP_EPSILON);
    CHECK_NEAR(s->admm.eps_rel, 1e-4, SP_EPSILON);
    CHECK_INT(s->admm.check, 10);
    CHECK_INT(s->admm.adapt, 100);
    CHECK_INT(s->admm.adapt_most, 10);
    CHECK_NEAR(s->admm.adapt_factor, 5, 0);
    CHECK_INT(s->admm.passes, 3);
    CHECK_INT(s->admm.cg_steps, 250);
    CHECK_NEAR(s->admm.cg_tol, TOL(1e-10, 1e-6), SP_EPSILON);
    CHECK_INT(s->admm.iterations, 8000);
    CHECK_INT(s->admm.polish, 0);
    CHECK_NEAR(s->admm.eps_pinf, 1e-4, SP_EPSILON);     /* 4.3 */
    CHECK_NEAR(s->native.eps_abs, TOL(1e-6, 1e-4), SP_EPSILON); /* 4.4 */
    CHECK_NEAR(s->native.eps_rel, TOL(1e-5, 1e-4), SP_EPSILON);
    CHECK_INT(s->native.iterations, 6000);
    CHECK_INT(s->native.polish, 1);
}

TEST(the_preset_is_the_table_and_the_seeds_order)
{
    static const sp_stage_id order[] = { SP_STAGE_GATES, SP_STAGE_LEAST_SQUARES, SP_STAGE_POLISH, SP_STAGE_ADMM };
    const sp_seed *t = sp_seed_table();
    const sp_settings s = sp_settings_seed();
    CHECK(s.seed == t);
    CHECK_INT(s.stage_count, 4);
    for (int k = 0; k < 4; k++) CHECK_INT(s.stage[k], order[k]);
    CHECK(s.faces == t->faces && s.inscribed == t->inscribed && s.penalty.net == t->net);
    CHECK_NEAR(s.penalty.gamma, t->gamma, 0);
    CHECK_NEAR(s.penalty.tau, t->tau, 0);
    CHECK_NEAR(s.tol, t->tension, 0);
    CHECK(s.coupled.rounds == t->turns && s.coupled.nodes == 0 && s.coupled.eps < 0);     /* its alternation, alone */
    CHECK_INT(s.coupled.box, 1);                        /* eta bounds each component */
}

TEST(a_table_that_would_break_a_stage_is_refused)
{
    sp_scene scene;
    sp_result r;
    sp_settings set = sp_settings_seed();
    build("two-cubes", NULL, 0, &scene);
    for (int k = 0; k < 7; k++) {
        sp_seed bad = *sp_seed_table();
        set.seed = &bad;
        if (k == 0) bad.window = 0;
        if (k == 1) bad.faces = 2;
        if (k == 2) bad.faces = 65;
        if (k == 3) bad.balance = 0;
        if (k == 4) bad.gain = 1;
        if (k == 5) bad.rounds = -1;
        if (k == 6) bad.tension = -1;
        CHECK_INT(sp_check(&scene, &set, &test_arena, &r), SP_E_RANGE);
    }
}

/* 2 ----------------------------------------------------------------------------------------------------------- mechanics */

/* A cube of weight W on a cube, its centroid beyond the edge. The joint's two sides are `width` apart and statics alone gives
 * their forces: moments about the outer one, the edge of the cube below, at 1/2 - offset from the centroid:
 * tension on the inner side W (offset - 1/2) / width, compression W more on the outer.        [offset 3/4: 1 W and 2 W] */
TEST(tension_of_a_cube_beyond_the_edge_is_that_of_statics)
{
    for (int k = 0; k < 4; k++) {
        static const double offset[] = { 0.55, 0.6, 0.75, 0.9 };
        const double pull = (offset[k] - 0.5) / (1 - offset[k]);
        sp_scene scene;
        sp_settings set = admm(8, 1, 0);
        test_arena.used = 0;
        build("two-cubes", "offset", offset[k], &scene);
        set.localise = 1;
        const sp_result r = check(&scene, &set);
        CHECK_INT(r.verdict, SP_UNDECIDED);
        CHECK_TEXT(sp_reason_text(r.reason), "tension");
        CHECK_NEAR(r.extremes.tension_ratio, pull / (1 + pull), TOL(1e-5, 2e-3));
        const sp_real W = scene.block[1].mass * R(9.80665);
        CHECK_NEAR(r.extremes.tension, (double)W * pull / 2, TOL(1e-5, 4e-2));        /* as the exact stage's own localisation */
    }
}

/* Friction on the net normal leaves no tension: what falls has no forces, and the proof of that is a motion. */
TEST(on_the_net_normal_what_falls_is_proved_to_fall)
{
    static const struct { const char *name, *param; double value; } fall[] = {
        { "two-cubes", "offset", 0.6 }, { "topple", "angle", 16 }, { "incline", "angle", 45 }, { "arch", "t", 0.08 },
        { "overhang", "factor", 1.1 }
    };
    for (size_t k = 0; k < sizeof fall / sizeof fall[0]; k++) {
        sp_scene scene;
        sp_settings set = admm(8, 1, 1);
        test_arena.used = 0;
        build(fall[k].name, fall[k].param, fall[k].value, &scene);
        const sp_result r = check(&scene, &set);
        CHECK_INT(r.verdict, SP_UNSTABLE);
        CHECK_INT(r.stage, SP_STAGE_ADMM);
        CHECK_TEXT(sp_reason_text(r.reason), "mechanism");
        CHECK_NEAR(r.extremes.tension_ratio, -1, 0);
    }
}

/* A block on a slope that falls along the first tangent: it slides when tan(slope) > mu_eff; of an odd pyramid an edge looks
 * uphill, where it is larger. */
TEST(every_pyramid_slides_at_its_own_coefficient)
{
    static const int faces[] = { 3, 4, 5, 8, 16, 64 };
    for (size_t k = 0; k < sizeof faces / sizeof faces[0]; k++)
        for (int mode = 0; mode < 8; mode++) {
            const int inscribed = mode & 1, net = mode >> 1 & 1, beyond = mode >> 2;
            const double half = cos(pi / faces[k]), mu = 0.84 * (inscribed ? half : 1) / (faces[k] % 2 ? half : 1);
            const double angle = atan(mu * (beyond ? 1.02 : 0.98)) * 180 / pi;
            sp_scene scene;
            sp_settings set = admm(faces[k], inscribed, net);
            test_arena.used = 0;
            build("incline", "angle", angle, &scene);
            const sp_result r = check(&scene, &set);
            if (beyond) CHECK(r.verdict == (net ? SP_UNSTABLE : SP_UNDECIDED));
            else if (net) CHECK_INT(r.verdict, SP_STABLE);
            else CHECK(r.verdict != SP_UNSTABLE);
        }
}

/* With the true cone asked for its pyramid is the inscribed one of 8: forces of it are admissible, motions of it prove nothing. */
TEST(for_the_true_cone_the_pyramid_is_inside_it)
{
    static const double share[] = { 0.90, 0.96, 1.02 };         /* of mu; cos(pi/8) = 0.924 */
    static const sp_verdict want[] = { SP_STABLE, SP_UNDECIDED, SP_UNDECIDED };
    for (int k = 0; k < 3; k++) {
        sp_scene scene;
        sp_settings set = admm(0, 0, 1);
        test_arena.used = 0;
        build("incline", "angle", atan(0.84 * share[k]) * 180 / pi, &scene);
        CHECK_INT(check(&scene, &set).verdict, want[k]);
        set.stage[1] = SP_STAGE_EXACT;
        CHECK_INT(check(&scene, &set).verdict, k < 2 ? SP_STABLE : SP_UNSTABLE);
    }
}

/* Same question, two solvers that share nothing. */
TEST(admm_and_the_exact_stage_agree)
{
    static const struct { const char *name, *param; double value; } scene_of[] = {
        { "two-cubes", NULL, 0 }, { "incline", NULL, 0 }, { "wall", "size", 54 }, { "arch", "n", 11 }, { "dome", NULL, 0 },
        { "topple", NULL, 0 }
    };
    for (size_t k = 0; k < sizeof scene_of / sizeof scene_of[0]; k++) {
        sp_scene scene;
        sp_settings set = admm(8, 1, 1);
        test_arena.used = 0;
        build(scene_of[k].name, scene_of[k].param, scene_of[k].value, &scene);
        const sp_result a = check(&scene, &set);
        set.stage[1] = SP_STAGE_EXACT;
        const sp_result e = check(&scene, &set);
        CHECK_INT(a.verdict, SP_STABLE);
        CHECK_INT(e.verdict, SP_STABLE);
        CHECK_INT(a.stage, SP_STAGE_ADMM);
        CHECK(a.extremes.tension_ratio >= 0 && a.extremes.tension_ratio <= R(1e-3));
        CHECK_NEAR(e.extremes.tension_ratio, -1, 0);
    }
}

/* Lengths times 1e3 or 1e-3 and densities to match nothing in particular: verdict and ratio stay. */
TEST(units_do_not_matter)
{
    sp_real first = 0;
    for (int k = 0; k < 3; k++) {
        const sp_real L = k == 0 ? 1 : k == 1 ? R(1e3) : R(1e-3), m = k == 0 ? 1 : k == 1 ? R(1e-7) : R(1e5);
        sp_scene scene;
        sp_settings set = admm(8, 1, 0);
        test_arena.used = 0;
        build("two-cubes", "offset", 0.7, &scene);
        for (int32_t i = 0; i < scene.count.points; i++) for (int c = 0; c < 3; c++) scene.point[i][c] *= L;
        for (int32_t i = 0; i < scene.count.blocks; i++) {
            for (int c = 0; c < 3; c++) scene.block[i].centroid[c] *= L;
            scene.block[i].mass *= m;
        }
        const sp_result r = check(&scene, &set);
        if (k == 0) first = r.extremes.tension_ratio;
        CHECK_INT(r.verdict, SP_UNDECIDED);
        CHECK_NEAR(r.extremes.tension_ratio, (double)first, TOL(1e-6, 1e-3));
    }
}

/* 3 -------------------------------------------------------------------------------------------------------------- preset */

TEST(the_preset_decides_what_the_seed_decides)
{
    static const struct { const char *name, *param; double value; sp_verdict want; } sample[] = {
        { "two-cubes", NULL, 0, SP_STABLE }, { "two-cubes", "offset", 0.6, SP_UNSTABLE }, { "arch", NULL, 0, SP_STABLE },
        { "wall", "size", 54, SP_STABLE }, { "overhang", "factor", 1.1, SP_UNSTABLE }, { "h-model", NULL, 0, SP_STABLE }
    };
    const sp_settings set = sp_settings_seed();
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        sp_scene scene;
        test_arena.used = 0;
        build(sample[k].name, sample[k].param, sample[k].value, &scene);
        CHECK_INT(check(&scene, &set).verdict, sample[k].want);
    }
}

/* Least squares stops at its gate, where by tol alone its forces would pass; polish goes on to its own. */
TEST(the_seeds_gates_are_kept)
{
    sp_scene scene;
    sp_settings set = sp_settings_seed();
    build("wall", "size", 54, &scene);
    const sp_result r = check(&scene, &set);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.stage, SP_STAGE_POLISH);
    CHECK(r.imbalance <= 2 * sp_seed_table()->balance);
    CHECK(r.spent.by_stage[1].factorisations == 1 && r.spent.by_stage[1].iterations == 0);
    sp_seed loose = *sp_seed_table();
    loose.balance = loose.cone = loose.tension = R(10);
    set.seed = &loose;
    set.tol = R(0.1);
    CHECK_INT(check(&scene, &set).stage, SP_STAGE_LEAST_SQUARES);
    set.seed = NULL;
    set.tol = R(1e-3);
    CHECK(check(&scene, &set).imbalance > 10 * sp_seed_table()->balance);
}

/* mu = .6 and 8 faces inside: the pyramid carries .5543 of the pressure towards a face, the preset's cone .5121 everywhere. Of a
 * slope between the two the preset's polish knows no forces; ADMM after it does.                                      [seed 2.2] */
TEST(the_presets_polish_projects_onto_the_seeds_cone)
{
    static const double slope[] = { 0.45, 0.53, 0.57 };
    const sp_settings preset = sp_settings_seed();
    for (int k = 0; k < 3; k++)
        for (int seed = 0; seed < 2; seed++) {
            gen_scene g;
            sp_scene scene;
            sp_settings set = preset;
            set.stage_count = 1;
            set.stage[0] = SP_STAGE_POLISH;
            if (!seed) set.seed = NULL;
            test_arena.used = 0;
            CHECK_INT(gen_open(&g, "incline"), 1);
            gen_set(&g, "mu", 0.6);
            gen_set(&g, "angle", atan(slope[k]) * 180 / 3.14159265358979323846);
            NEED(gen_build(&g, &test_arena, &scene) == SP_OK);
            const sp_result r = check(&scene, &set);
            CHECK_INT(r.verdict, k < 2 - seed ? SP_STABLE : SP_UNDECIDED);
            if (r.verdict == SP_STABLE) CHECK_NEAR(r.extremes.utilisation, slope[k] / 0.6, 5e-3);
            if (seed && k < 2) CHECK_INT(check(&scene, &preset).verdict, SP_STABLE);
        }
}

/* Its forces use cos^2(pi/8) = 85.4 % of mu at most, in whatever direction; ours go to the corners of the pyramid. */
TEST(forces_of_the_presets_polish_are_within_its_cone)
{
    const double most = cos(3.14159265358979323846 / 8) * cos(3.14159265358979323846 / 8);
    for (int seed = 0; seed < 2; seed++) {
        sp_scene scene;
        sp_settings set = sp_settings_seed();
        if (!seed) set.seed = NULL;
        test_arena.used = 0;
        build("wall", "size", 54, &scene);
        const sp_result r = check(&scene, &set);
        CHECK_INT(r.verdict, SP_STABLE);
        CHECK_INT(r.stage, SP_STAGE_POLISH);
        if (seed) CHECK_NEAR(r.extremes.corner_utilisation, most, 16 * (double)SP_EPSILON);
        else CHECK((double)r.extremes.corner_utilisation > cos(3.14159265358979323846 / 8));
    }
}

/* Below the gate a dense factor, above none at all: less memory, no cheaper. */
TEST(the_gate_of_cells_chooses_dense_or_none)
{
    sp_scene scene;
    sp_settings set = sp_settings_seed();
    sp_seed table = *sp_seed_table();
    size_t dense = 0, none = 0, sparse = 0;
    build("arch", "n", 11, &scene);
    set.seed = &table;
    set.stage_count = 1;
    set.stage[0] = SP_STAGE_ADMM;
    NEED(sp_memory(&scene, SP_FOR_CHECK, &set, test_arena, &dense) == SP_OK);
    const sp_result d = check(&scene, &set);
    table.dense_cells = 1;
    NEED(sp_memory(&scene, SP_FOR_CHECK, &set, test_arena, &none) == SP_OK);
    const sp_result n = check(&scene, &set);
    table.dense_cells = 0;
    NEED(sp_memory(&scene, SP_FOR_CHECK, &set, test_arena, &sparse) == SP_OK);
    const sp_result s = check(&scene, &set);
    CHECK(none < dense && none < sparse);
    CHECK(d.verdict == SP_STABLE && n.verdict == SP_STABLE && s.verdict == SP_STABLE);
    CHECK(s.spent.total.flops < d.spent.total.flops && s.spent.total.flops < n.spent.total.flops);
}

/* 4 ---------------------------------------------------------------------------------------------------- plugged-in solvers */

typedef enum lie { HONEST, GARBAGE, NAN_SOLVED, NO_POINT, FALSE_PROOF, NO_PROOF, BROKEN, FULL, LIES } lie;

typedef struct plug { lie how; sp_qp_settings asked; int calls; } plug;

static sp_status plug_solve(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, const sp_real *x0,
                            const sp_real *y0, sp_qp_result *result)
{
    plug *p = self;
    const sp_qp_solver own = sp_qp_admm();
    p->asked = *settings;
    p->calls++;
    if (p->how == FULL) return SP_E_MEMORY;
    const sp_status status = own.solve(own.self, qp, settings, arena, x0, y0, result);
    if (status || p->how == HONEST) return status;
    sp_real *x = (sp_real *)(uintptr_t)result->x, *y = (sp_real *)(uintptr_t)result->y;
    result->status = p->how == FALSE_PROOF || p->how == NO_PROOF ? SP_QP_PRIMAL_INFEASIBLE
                   : p->how == BROKEN ? SP_QP_NUMERICAL : SP_QP_SOLVED;
    const int nan = p->how == NAN_SOLVED || p->how == BROKEN;
    for (int32_t j = 0; j < qp->n; j++) x[j] = nan ? R(NAN) : test_random_real(0, 1);
    for (int32_t i = 0; i < qp->m; i++) y[i] = nan ? R(NAN) : test_random_real(-1, 1);
    if (p->how == NO_POINT) result->x = NULL;
    if (p->how == NO_PROOF) result->y = NULL;
    return SP_OK;
}

static sp_status plug_need(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes)
{
    (void)self;
    return sp_qp_memory(qp, settings, scratch, bytes);
}

TEST(another_solver_is_asked_as_the_seed_asks_its_own)
{
    plug p = { HONEST, sp_qp_default(), 0 };
    const sp_qp_solver solver = { &p, plug_solve, plug_need };
    sp_scene scene;
    sp_settings set = sp_settings_seed();
    set.stage_count = 1;
    set.stage[0] = SP_STAGE_ADMM;
    set.penalty.solver = &solver;
    build("arch", "n", 11, &scene);
    const sp_result r = check(&scene, &set);
    CHECK_INT(p.calls, 1);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_NEAR(p.asked.eps_abs, TOL(1e-6, 1e-4), SP_EPSILON);
    CHECK_NEAR(p.asked.eps_rel, TOL(1e-5, 1e-4), SP_EPSILON);
    CHECK_INT(p.asked.iterations, 6000);
    CHECK_INT(p.asked.polish, 1);
}

TEST(a_solver_that_lies_decides_nothing)
{
    for (int how = GARBAGE; how < FULL; how++)
        for (int falls = 0; falls < 2; falls++) {
            plug p = { (lie)how, sp_qp_default(), 0 };
            const sp_qp_solver solver = { &p, plug_solve, plug_need };
            sp_scene scene;
            sp_settings set = admm(8, 1, 1);
            test_arena.used = 0;
            set.penalty.solver = &solver;
            build("arch", "t", falls ? 0.08 : 0.12, &scene);
            const sp_result r = check(&scene, &set);
            CHECK_INT(p.calls, 1);
            CHECK_INT(r.verdict, SP_UNDECIDED);
            CHECK(r.reason == SP_REASON_UNVERIFIED || r.reason == SP_REASON_BUDGET || r.reason == SP_REASON_TENSION);
        }
}

TEST(a_solver_without_memory_says_so)
{
    plug p = { FULL, sp_qp_default(), 0 };
    const sp_qp_solver solver = { &p, plug_solve, plug_need };
    sp_scene scene;
    sp_result r;
    sp_settings set = admm(8, 1, 1);
    set.penalty.solver = &solver;
    build("arch", NULL, 0, &scene);
    const size_t used = test_arena.used;
    CHECK_INT(sp_check(&scene, &set, &test_arena, &r), SP_E_MEMORY);
    CHECK_INT(test_arena.used, used);
}

/* 5 -------------------------------------------------------------------------------------------------------------- memory */

TEST(memory_is_exact_and_scratch_is_enough)
{
    for (int k = 0; k < 4; k++) {
        sp_scene scene;
        sp_result r;
        sp_settings set = k < 2 ? admm(k ? 0 : 16, 1, k) : sp_settings_seed();
        size_t bytes = 0;
        sp_arena a;
        test_arena.used = 0;
        build(k % 2 ? "arch" : "dome", NULL, 0, &scene);
        if (k == 2) set.penalty.solver = NULL;
        const size_t need = sp_memory_scratch(&scene, SP_FOR_CHECK, &set);
        NEED(need > 0 && need < test_arena.capacity - test_arena.used);
        sp_arena scratch = { test_arena.base + (test_arena.used + SP_ALIGN) / SP_ALIGN * SP_ALIGN, need, 0, 0 };
        NEED(sp_memory(&scene, SP_FOR_CHECK, &set, scratch, &bytes) == SP_OK);
        a = scratch;
        a.capacity = bytes;
        CHECK_INT(sp_check(&scene, &set, &a, &r), SP_OK);
        CHECK(a.peak <= bytes);
        if (k < 2) CHECK_INT(r.spent.peak_bytes, bytes);      /* the preset's earlier stages may decide with less */
        if (k >= 2) continue;
        a = scratch;
        a.capacity = bytes - 1;
        CHECK_INT(sp_check(&scene, &set, &a, &r), SP_E_MEMORY);
        CHECK_INT(a.used, 0);
        scratch.capacity = need / 8;
        CHECK_INT(sp_memory(&scene, SP_FOR_CHECK, &set, scratch, &bytes), SP_E_MEMORY);
    }
}

TEST_LIST(admm)
    RUN(the_table_holds_the_seeds_numbers)
    RUN(the_preset_is_the_table_and_the_seeds_order)
    RUN(a_table_that_would_break_a_stage_is_refused)
    RUN(tension_of_a_cube_beyond_the_edge_is_that_of_statics)
    RUN(on_the_net_normal_what_falls_is_proved_to_fall)
    RUN(every_pyramid_slides_at_its_own_coefficient)
    RUN(for_the_true_cone_the_pyramid_is_inside_it)
    RUN(admm_and_the_exact_stage_agree)
    RUN(units_do_not_matter)
    RUN(the_preset_decides_what_the_seed_decides)
    RUN(the_seeds_gates_are_kept)
    RUN(the_presets_polish_projects_onto_the_seeds_cone)
    RUN(forces_of_the_presets_polish_are_within_its_cone)
    RUN(the_gate_of_cells_chooses_dense_or_none)
    RUN(another_solver_is_asked_as_the_seed_asks_its_own)
    RUN(a_solver_that_lies_decides_nothing)
    RUN(a_solver_without_memory_says_so)
    RUN(memory_is_exact_and_scratch_is_enough)
TEST_END

#else

TEST_LIST(admm)
TEST_END

#endif
