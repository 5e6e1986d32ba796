/* program: the seed's penalty form, a quadratic program of 4 columns x = (fp, fm, ft1, ft2) and K friction rows a vertex:
 *
 *     min 1/2 sum (fp^2 + gamma fm^2 + tau |ft|^2)        Aeq x = -p,   Afr x <= 0,   fp, fm >= 0       [seed 1.5, 4.2]
 *
 * Forces are counted in the largest load, moments in forces at the block's longest arm, so residuals don't depend on units.
 * Its forces fp - fm, ft are put into the cones and judged; the multipliers of Aeq are a motion: dq of a certificate that there
 * are no forces. Where the true cone is asked for the seed's pyramid takes its place, whose forces the true cone admits.
 */
#ifndef SP__SEED_PROGRAM_C
#define SP__SEED_PROGRAM_C

#include "../base/vectors.c"
#include "../qp/admm.c"
#include "../scene/problem.c"
#include "../scene/matrix.c"
#include "table.c"

#if SP__WITH_LARGE

#if SP__WITH_ADMM

typedef struct sp__program_arrays {
    int32_t *Pp, *Ap, *Ai;              /* Pp: 0, 1, ...: column starts and rows of the diagonal P */
    sp_real *Px, *Ax, *l, *u, *x;       /* x: first guess */
    sp_real *arm;                       /* b: 1 / longest arm */
} sp__program_arrays;

typedef struct sp__program {
    sp_qp qp;
    sp_qp_settings set;
    sp_qp_solver solver;
    sp_qp_result r;
    sp__friction friction;
    sp__program_arrays at;
    sp_real unit;                       /* of force [N] */
} sp__program;

/* Arrays of the program from the arena. */
static void sp__program_carve(sp__program_arrays *at, const sp_qp *qp, int32_t blocks, int32_t entries, sp_arena *a)
{
    const size_t n = (size_t)qp->n, m = (size_t)qp->m;
    at->Pp = sp__take(a, n + 1, sizeof *at->Pp);
    at->Px = sp__take(a, n, sizeof *at->Px);
    at->Ap = sp__take(a, n + 1, sizeof *at->Ap);
    at->Ai = sp__take(a, (size_t)entries, sizeof *at->Ai);
    at->Ax = sp__take(a, (size_t)entries, sizeof *at->Ax);
    at->l = sp__take(a, m, sizeof *at->l);
    at->u = sp__take(a, m, sizeof *at->u);
    at->x = sp__take(a, n, sizeof *at->x);
    at->arm = sp__take(a, (size_t)blocks, sizeof *at->arm);
}

/* The constants in the settings, or the table. */
static const sp_seed *sp__seed_of(const sp_settings *set) { return set->seed ? set->seed : &sp__seed; }

/* n and m, and the most entries A can have: 12 of Aeq and K of Afr a column, 2 signs a vertex.     returns -1: too large */
static int32_t sp__program_size(const sp_problem *pb, const sp_settings *set, sp_qp *qp)
{
    const int32_t faces = set->faces ? set->faces : sp__seed_of(set)->faces;
    memset(qp, 0, sizeof *qp);
    if (pb->blocks > INT32_MAX / 24 || pb->points > INT32_MAX / (16 * (faces + 13))) return -1;
    qp->n = 4 * pb->points;
    qp->m = 6 * pb->blocks + (faces + 2) * pb->points;
    return pb->points * (4 * (12 + faces) + 2);
}

/* Dense or without a matrix, as the seed has it; else what the settings say.                                  [seed 1.5] */
static sp_qp_backend sp__program_backend(const sp_problem *pb, const sp_settings *set, const sp_qp *qp)
{
    const sp_seed *seed = sp__seed_of(set);
    if (set->penalty.solver) return seed->native.backend;
    if (!set->seed || seed->dense_cells <= 0) return seed->admm.backend;
    const int64_t n = qp->n, cells = n * (n + qp->m - 2 * pb->points);
    if (cells <= seed->dense_cells) return SP_QP_DENSE;
    return SP__WITH_QP_CG ? SP_QP_CG : SP_QP_SPARSE;
}

/* Without the preset the accuracy is that of the check, and the active rows are solved for exactly. */
static void sp__program_tighten(sp_qp_settings *s, sp_real tol)
{
    const sp_real eps = sp__max(tol / 4, 1000 * (sp_real)SP_EPSILON);
    if (eps < s->eps_abs) s->eps_abs = eps;
    if (eps < s->eps_rel) s->eps_rel = eps;
    s->polish = SP__WITH_QP_POLISH;
}

/* Sizes, pyramid and who solves it.     returns 0: too large */
static int sp__program_open(sp__program *g, const sp_problem *pb, const sp_settings *set)
{
    const sp_seed *seed = sp__seed_of(set);
    if (sp__program_size(pb, set, &g->qp) < 0) return 0;
    sp__friction_begin(&g->friction, set->faces ? set->faces : seed->faces,
                       set->faces ? set->inscribed : seed->inscribed, set->penalty.net, 6 * pb->blocks);
    g->set = set->penalty.solver ? seed->native : seed->admm;
    g->set.backend = sp__program_backend(pb, set, &g->qp);
    if (!set->seed) sp__program_tighten(&g->set, set->tol);
    if (set->penalty.solver) g->solver = *set->penalty.solver;
    else g->solver = sp_qp_admm();
    return 1;
}

/* A by columns: rows of Aeq, of Afr, and 1 in a row of its own where the unknown has a sign. Ap NULL: only counts entries. */
static void sp__program_columns(const sp__program *g, const sp_problem *pb, sp_triplets *t, int32_t *Ap)
{
    t->count = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *contact = &pb->contact[c];
        for (int32_t q = 0; q < 4 * contact->points; q++) {
            const int32_t v = contact->point + q / 4;
            sp__aeq_vertex(t, pb, contact, v, 4, q % 4);
            sp__afr_vertex(t, &g->friction, contact, v, 4, q % 4);
            if (q % 4 < 2)
                sp__triplets_put(t, 6 * pb->blocks + g->friction.faces * pb->points + 2 * v + q % 4, 4 * v + q % 4, 1);
            if (Ap) Ap[4 * v + q % 4 + 1] = t->count;
        }
    }
}

/* P and A; moments about a centroid are divided by its longest arm. */
SP__NOINLINE static void sp__program_matrices(sp__program *g, const sp_problem *pb, const sp_settings *set)
{
    const int32_t n = g->qp.n;
    sp_triplets t = { g->qp.m, n, 0, g->at.Ai, NULL, g->at.Ax };
    memset(g->at.Ap, 0, ((size_t)n + 1) * sizeof *g->at.Ap);
    sp__program_columns(g, pb, &t, g->at.Ap);
    for (int32_t i = 0; i < pb->blocks; i++) g->at.arm[i] = 0;
    for (int32_t k = 0; k < t.count; k++) {
        const int32_t row = g->at.Ai[k], i = row / 6;
        if (row < 6 * pb->blocks && row % 6 > 2) g->at.arm[i] = sp__max(g->at.arm[i], sp__abs(g->at.Ax[k]));
    }
    for (int32_t i = 0; i < pb->blocks; i++) g->at.arm[i] = g->at.arm[i] > 0 ? 1 / g->at.arm[i] : 1;
    for (int32_t k = 0; k < t.count; k++)
        if (g->at.Ai[k] < 6 * pb->blocks && g->at.Ai[k] % 6 > 2) g->at.Ax[k] *= g->at.arm[g->at.Ai[k] / 6];
    for (int32_t j = 0; j < n; j++) {
        if (g->at.Ap[j + 1] < g->at.Ap[j]) g->at.Ap[j + 1] = g->at.Ap[j];   /* a vertex between supports has no entries */
        g->at.Pp[j] = j;
        g->at.Px[j] = j % 4 == 0 ? 1 : j % 4 == 1 ? set->penalty.gamma : set->penalty.tau;
    }
    g->at.Pp[n] = n;
    g->qp.Pp = g->qp.Pi = g->at.Pp;
    g->qp.Px = g->at.Px;
    g->qp.Ap = g->at.Ap;
    g->qp.Ai = g->at.Ai;
    g->qp.Ax = g->at.Ax;
}

/* l, u: the load on rows of Aeq that are not held; Afr x <= 0; fp, fm >= 0. */
static void sp__program_bounds(sp__program *g, const sp_problem *pb)
{
    const int32_t friction = 6 * pb->blocks, signs = friction + g->friction.faces * pb->points;
    for (int32_t i = 0; i < g->qp.m; i++) {
        const int held = i < friction && sp__held(pb, i / 6, (int)(i % 6));
        const sp_real p = i < friction ? -sp__in_units(g->unit, pb->p[i]) * (i % 6 > 2 ? g->at.arm[i / 6] : 1) : 0;
        g->at.l[i] = held || (i >= friction && i < signs) ? -SP_QP_INFINITY : p;
        g->at.u[i] = held || i >= signs ? SP_QP_INFINITY : p;
    }
    g->qp.l = g->at.l;
    g->qp.u = g->at.u;
}

/* The program in `a`, with a first guess from the forces of the stage before; NULL: it does not fit. */
SP__NOINLINE static sp__program *sp__program_make(const sp_problem *pb, const sp_settings *set, const sp_real *f, sp_arena *a)
{
    sp__program *g = sp__take(a, 1, sizeof *g);
    if (!g) return NULL;
    memset(g, 0, sizeof *g);
    if (!sp__program_open(g, pb, set)) return NULL;
    sp_triplets t = { 0, 0, 0, NULL, NULL, NULL };
    sp__program_columns(g, pb, &t, NULL);
    sp__program_carve(&g->at, &g->qp, pb->blocks, t.count, a);
    if (sp__failed(a)) return NULL;
    g->unit = sp__load_unit(pb);
    sp__program_matrices(g, pb, set);
    sp__program_bounds(g, pb);
    for (size_t v = 0; v < (size_t)pb->points; v++) {
        const sp_real fn = f ? sp__in_units(g->unit, f[3 * v]) : 0;
        g->at.x[4 * v] = sp__max(fn, 0);
        g->at.x[4 * v + 1] = sp__max(-fn, 0);
        g->at.x[4 * v + 2] = f ? sp__in_units(g->unit, f[3 * v + 1]) : 0;
        g->at.x[4 * v + 3] = f ? sp__in_units(g->unit, f[3 * v + 2]) : 0;
    }
    return g;
}

/* The answer into the state, whose forces are put into the cones by whoever judges them.     returns max fm / max fp, -1: there
 * are no forces in it */
static sp_real sp__program_forces(const sp__program *g, const sp_problem *pb, sp_state *state)
{
    const sp_real *x = g->r.x;
    sp_real press = 0, pull = 0;
    if (!x) return -1;
    for (int32_t j = 0; j < g->qp.n; j++) if (!sp__finite(sp__in_newtons(g->unit, x[j]))) return -1;
    for (size_t v = 0; v < (size_t)pb->points; v++, x += 4) {
        press = sp__max(press, x[0]);
        pull = sp__max(pull, x[1]);
        state->f[3 * v] = sp__in_newtons(g->unit, x[0] - x[1]);
        state->f[3 * v + 1] = sp__in_newtons(g->unit, x[2]);
        state->f[3 * v + 2] = sp__in_newtons(g->unit, x[3]);
    }
    return sp__ratio(pull, press);
}

/* Flops that a run of the quadratic program takes before it looks at its budget: it measures the first guess twice. */
static int64_t sp__program_least_flops(const sp_qp *qp)
{
    const int64_t products = 4 * ((int64_t)qp->Ap[qp->n] + 2 * (int64_t)qp->n) + 2 * (int64_t)qp->Ap[qp->n];
    return 2 * (6 * products + 700 * ((int64_t)qp->n + qp->m));
}

/* dq <- the multipliers of Aeq. */
static void sp__program_motion(const sp__program *g, const sp_problem *pb, sp_real *dq)
{
    for (int32_t i = 0; g->r.y && i < 6 * pb->blocks; i++) {
        const sp_real y = g->r.y[i] * (i % 6 > 2 ? g->at.arm[i / 6] : 1);
        dq[i] = sp__finite(y) && !sp__held(pb, i / 6, (int)(i % 6)) ? y : 0;
    }
}

static sp_status sp__admm_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    const sp_seed *seed = set->seed ? set->seed : &sp__seed;
    sp__program *g = sp__program_make(pb, set, state->f, arena);
    if (!g) return SP_E_MEMORY;
    state->reason = SP_REASON_BUDGET;
    if (set->budget > 0) g->set.budget = state->left;
    if (set->budget > 0 && state->left < sp__program_least_flops(&g->qp)) return SP_OK;
    const sp_status status = g->solver.solve(g->solver.self, &g->qp, &g->set, arena, g->at.x, NULL, &g->r);
    if (status) return status == SP_E_MEMORY ? status : SP_OK;
    state->cost.flops += g->r.flops;
    state->cost.factorisations += g->r.factorisations;
    state->cost.iterations += g->r.iterations;
    if (g->r.status == SP_QP_PRIMAL_INFEASIBLE) {
        sp__program_motion(g, pb, state->dq);
        state->reason = SP_REASON_UNVERIFIED;
        *claim = SP_UNSTABLE;
        return SP_OK;
    }
    if (g->r.status == SP_QP_DUAL_INFEASIBLE || g->r.status == SP_QP_NUMERICAL) return SP_OK;
    const sp_real ratio = sp__program_forces(g, pb, state);
    if (ratio < 0) return SP_OK;
    sp__program_motion(g, pb, state->dq);
    if (g->r.status != SP_QP_SOLVED) return SP_OK;
    state->tension_ratio = ratio;
    state->reason = ratio > seed->tension ? SP_REASON_TENSION : SP_REASON_UNVERIFIED;
    if (!(ratio > seed->tension)) *claim = SP_STABLE;
    return SP_OK;
}

static size_t sp__admm_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    size_t bytes = 0;
    sp__program *g = sp__program_make(pb, set, NULL, &scratch);
    if (!g) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *g);
    sp__program_carve(&g->at, &g->qp, pb->blocks, g->at.Ap[g->qp.n], &dry);     /* g->qp keeps the arrays */
    if (!pb->points) return dry.peak;                   /* without unknowns it is no program, and is not solved */
    if (g->solver.need && g->solver.need(g->solver.self, &g->qp, &g->set, scratch, &bytes)) return SIZE_MAX;
    sp__take(&dry, 1, bytes);
    if (g->solver.need) return dry.peak;
    sp__take(&dry, (size_t)g->qp.n, sizeof(sp_real));
    sp__take(&dry, (size_t)g->qp.m, sizeof(sp_real));
    return dry.peak;
}

/* Scratch for that, from counts alone; 0: too large. */
static size_t sp__admm_scratch(const sp_problem *pb, const sp_settings *set)
{
    sp_qp qp;
    sp__program_arrays at;
    sp_arena dry = sp__arena_dry();
    const int32_t entries = sp__program_size(pb, set, &qp);
    const size_t solver = entries < 0 ? 0 : sp__qp_bytes(&qp, entries, sp__program_backend(pb, set, &qp), 0, 0);
    if (solver == 0) return 0;
    sp__take(&dry, 1, sizeof(sp__program));
    sp__program_carve(&at, &qp, pb->blocks, entries, &dry);
    sp__take(&dry, 1, solver);
    return sp__failed(&dry) ? 0 : dry.peak + SP_ALIGN;
}

#else

static sp_status sp__admm_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    return (void)pb, (void)set, (void)state, (void)arena, (void)claim, SP_E_UNSUPPORTED;
}
static size_t sp__admm_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return (void)pb, (void)set, (void)scratch, 0;
}
static size_t sp__admm_scratch(const sp_problem *pb, const sp_settings *set) { return (void)pb, (void)set, 0; }

#endif

#endif

#endif /* SP__SEED_PROGRAM_C */
