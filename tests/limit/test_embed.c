/* Interior points with the multiplier in them: steps by their equations, and what ends them, where factors and forces answer as
 * they are told to. */
#define SP_API static
#include "../test.h"
#include "../base/fence.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/limit/newton.c"

#include <math.h>

#if SP__WITH_INTERIOR

/* From the first factor on: l / tau, theta, the best balance, whether nothing stands. length: of each step. outside, spent: from
 * that factor on. found: of forces, one bit a question. falls: of proofs. */
typedef struct world {
    double l, theta, best, length;
    int none, outside, spent, found, falls;
} world;

static world here;
static sp__limit *lim;
static int told;                                        /* else they answer as they do */
static int factors, forces, proofs, rays, seen;
static sp_real motion[4][6];                            /* candidates, in turn */
static const double *lengths;                           /* of steps, in turn, instead of here.length */

static void world_factor(sp__system *w, sp__law law, const sp_real *y, sp_real shift)
{
    if (!told) { sp__system_factor(w, law, y, shift); return; }
    sp__engine *g = &lim->engine;
    factors++;
    CHECK(!g->h.m.outside && law == SP__INTERIOR);
    g->h.m.tau = g->h.m.kappa = g->h.s = 1;
    g->h.m.gap = 1;
    g->h.l = R(here.l);
    g->h.m.theta = R(here.theta);
    lim->best = here.best < 1e9 ? R(here.best) : SP__HUGE;
    lim->none = here.none;
    g->h.m.outside = (int16_t)(here.outside && factors >= here.outside);
    w->budget.spent = here.spent && factors >= here.spent;
}

static void world_solve(sp__system *w, const sp_real *x, sp_real *y)
{
    if (told) memmove(y, x, 6 * (size_t)w->pb->blocks * sizeof *y);
    else sp__system_solve(w, x, y);
}

static void world_sweep(sp__system *w, sp__ipm *m, sp__pass pass, sp_real *r)
{
    if (!told) sp__ipm_sweep(w, m, pass, r);
    else if (r) memset(r, 0, 6 * (size_t)w->pb->blocks * sizeof *r);
}

static void world_reach(sp__system *w, sp__ipm *m)
{
    if (told) m->reach = R(lengths ? *lengths++ : here.length);
    else sp__ipm_reach(w, m);
}

static sp_real world_resist(const sp__system *w, int32_t c, const sp_real *y)
{
    if (seen < 4) memcpy(motion[seen], y, sizeof motion[0]);
    seen++;
    return told ? SP__HUGE : sp__newton_resist(w, c, y);
}

static void world_forces(sp__system *w, const sp__ipm *m, sp__newton *n, sp_state *state)
{
    (void)w;
    rays = 2 * rays + (m && m->ray);
    n->found = (signed char)(here.found >> forces++ & 1);
    state->f[0] = R(forces);
}

static int world_stands(sp__bracket *b, sp_real d, sp_real l, const sp_real *f, sp_real *admitted)
{
    (void)d; (void)l; (void)f; (void)admitted;
    b->imbalance = R(0.25) * R(forces);
    return 1;
}

static int world_falls(sp__bracket *b, sp_real lambda, int beyond, sp_real *all)
{
    (void)b;
    CHECK(beyond && !all);
    CHECK_WITHIN(lambda, 0, 0);
    proofs++;
    return here.falls;
}

#define sp__system_factor world_factor
#define sp__system_solve world_solve
#define sp__ipm_sweep world_sweep
#define sp__ipm_reach world_reach
#define sp__newton_resist world_resist
#define sp__ipm_forces world_forces
#define sp__bracket_stands world_stands
#define sp__bracket_falls world_falls
#include "parts.h"

/* The limit of a cube, opened; the loads are those that were real. */
static void opened(const sp_real dead[3], const sp_real live[3], sp_real ref)
{
    cube(dead, live, 0, NULL);
    lim = limit_built(&s);
    if (ref > 0) lim->ref = ref;
    told = 0;
    CHECK_INT(sp__limit_open(lim, &test_arena), SP_OK);
    factors = forces = proofs = rays = seen = 0;
}

static const sp_real UP[3] = { 0, 0, 2 * W };

/* left: factorisations. is: what is returned. rays: which questions about forces were about live loads alone, the last in bit 0. */
TEST(interior_points_end_where_written_here)
{
    enum { ENDLESS = SP_LIMIT_UNBOUNDED };
    static const struct { world of; int left, is, factors, forces, rays, proofs, kind; double lower; } row[] = {
        { { 2, 1, 1e9, 0.5, 0, 0, 0, 0, 0 }, 3, 0, 3, 0, 0, 0, 0, -1 },         /* steps run out */
        { { 2, 1, 1e9, 0.5, 0, 0, 0, 0, 0 }, 500, 0, 100, 0, 0, 0, 0, -1 },
        { { 2, 1, 1e9, 0.05, 0, 0, 0, 0, 0 }, 500, 0, 8, 0, 0, 0, 0, -1 },      /* they get nowhere */
        { { 2, 1e-30, 1e9, 0.5, 0, 0, 0, 0, 0 }, 500, 0, 1, 2, 0, 0, 0, -1 },
        { { 2, 1, 1e9, 0.5, 0, 0, 3, 0, 0 }, 500, 0, 3, 0, 0, 0, 0, -1 },       /* no budget */
        { { 2, 1, 1e9, 0.5, 0, 4, 0, 0, 0 }, 500, 0, 4, 0, 0, 0, 0, -1 },       /* rounding */
        { { 2, 1, 2, 0.5, 1, 0, 0, 0, 1 }, 500, 1, 1, 0, 0, 1, 0, -1 },         /* nothing stands */
        { { 2, 1, 2, 0.5, 1, 0, 0, 0, 0 }, 5, 0, 5, 0, 0, 5, 0, -1 },
        { { 2, 1, 2.0000000001, 0.5, 0, 0, 0, 1, 0 }, 5, 1, 1, 1, 0, 0, 0, 2 },         /* both ends meet */
        { { 2, 1, 2.000001, 0.5, 0, 0, 0, 1, 0 }, 5, 0, 5, 1, 0, 0, 0, 2 },
        { { 2, 1, 2.001, 0.5, 0, 0, 0, 1, 0 }, 5, 0, 5, 0, 0, 0, 0, -1 },
        { { 2, 1, 2 + 2998.5 * SP__SCALE_TOL, 0, 0, 0, 0, 0, 0 }, 1, 0, 1, 2, 0, 0, 0, -1 },  /* nearer than 3000 at last */
        { { 2, 1, 2 + 3001.5 * SP__SCALE_TOL, 0, 0, 0, 0, 0, 0 }, 1, 0, 1, 0, 0, 0, 0, -1 },
        { { 2, 1, 1.999999, 0.5, 0, 0, 0, 1, 0 }, 5, 1, 1, 1, 0, 0, 0, 1.999999 },
        { { 2, 1, 2, 0.5, 0, 0, 0, 4, 0 }, 5, 1, 2, 3, 0, 0, 0, 2 },            /* the first forces are none */
        { { 1000, 1, 1e9, 0.5, 0, 0, 0, 3, 0 }, 5, 0, 5, 0, 0, 0, 0, -1 },
        { { 1000.5, 1, 1e9, 0.5, 0, 0, 0, 3, 0 }, 5, 1, 1, 2, 2, 0, ENDLESS, 1000.5 },  /* live loads alone */
        { { 1000.5, 1, 1e9, 0.5, 0, 0, 0, 1, 0 }, 5, 1, 1, 2, 2, 0, ENDLESS, -1 },
        { { 1000.5, 1, 1e9, 0.5, 0, 0, 0, 2, 0 }, 1, 0, 1, 1, 1, 0, 0, -1 },
        { { 1000.5, 1, 1e9, 0.5, 0, 0, 0, 2, 0 }, 2, 1, 2, 3, 6, 0, ENDLESS, -1 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row && sizeof(sp_real) == 8; k++) {
        opened(NOTHING, UP, R(0.5));
        here = row[k].of;
        told = 1;
        lim->engine.n.left = row[k].left;
        lim->engine.h.m.outside = 1;
        lim->r.imbalance = 9;
        const sp_cost cost = lim->bracket.cost;
        CHECK_INT(sp__interior_run(lim), row[k].is);
        const int steps = factors - (here.spent > 0);   /* what did not fit is not counted */
        CHECK_INT(factors, row[k].factors);
        CHECK_INT(forces, row[k].forces);
        CHECK_INT(rays, row[k].rays);
        CHECK_INT(proofs, row[k].proofs);
        CHECK_INT(lim->engine.h.m.ray, 0);
        CHECK_INT(lim->engine.n.left, row[k].left - steps);
        CHECK_INT(lim->bracket.cost.iterations - cost.iterations, steps);
        CHECK_INT(lim->bracket.cost.interior - cost.interior, steps);
        CHECK_INT(lim->r.kind, row[k].kind);
        CHECK_WITHIN(lim->r.lower, row[k].lower < 0 ? -1 : row[k].lower / 2, TOL(1e-12, 1e-6));
        CHECK_WITHIN(lim->r.imbalance, row[k].lower < 0 ? 9 : 0.25 * forces, 0);
        whole();
    }
}

/* The factor at hand, and its columns: loads p' = p + a q with p' . M^-1 q = 0, unless a is a thousand times l / tau + 1. */
static sp_real columns(const sp_real dead[3], sp_real ref, sp_real l)
{
    opened(dead, UP, ref);
    sp__interior_start(lim);
    lim->engine.h.l = l;
    lim->engine.h.m.mu = 1;
    sp__system_factor(lim->engine.w, SP__INTERIOR, lim->engine.w->y, SP__IPM_SHIFT);
    sp__interior_columns(lim);
    return lim->engine.at;
}

TEST(columns_are_apart_where_loads_let_them)
{
    for (int k = 0; k < 3; k++) {
        CHECK_NEAR(columns(NOTHING, R(0.5), (sp_real)k + 1), 1, TOL(1e-9, 1e-4));       /* W down, 2 W / 2 up */
        const sp__engine *e = &lim->engine;
        CHECK_WITHIN(sp__system_work(e->w, e->Vq) / sp__dot(e->q, e->Vq, 6), 0, TOL(1e-9, 1e-4));
        CHECK_NEAR(columns(NOTHING, TOL(R(1e-6), R(1e-5)), (sp_real)k + 1), 1000 * (k + 2), TOL(1e-12, 1e-6));
        const sp_real up[3] = { 0, 0, 2 * W };
        CHECK_NEAR(columns(up, TOL(R(1e-6), R(1e-5)), (sp_real)k + 1), -1000 * (k + 2), TOL(1e-12, 1e-6));
    }
    whole();
}

/* Candidates: y; one with q . y = -s - tau; one with p . y = l - kappa, too. */
TEST(motions_work_as_the_embedding_wants)
{
    const sp_real push[3] = { W / 5, W / 10, 0 }, aside[3] = { W / 4, 0, 0 };
    for (int k = 0; k < 4; k++) {
        columns(k & 1 ? push : aside, k & 2 ? R(0.7) : R(0.2), R(0.6));
        sp__engine *e = &lim->engine;
        sp__homogeneous *h = &e->h;
        const size_t n = 6;
        e->w->y[2] = R(0.1);
        h->m.tau = R(0.75);
        h->m.kappa = R(0.3);
        h->s = R(1.25);
        h->m.sigma = 5;
        h->m.corrected = 1;
        seen = 0;
        sp__interior_motions(lim);
        CHECK_INT(seen, 3);
        CHECK_WITHIN(h->m.sigma, 0, 0);
        CHECK_INT(h->m.corrected, 0);
        for (size_t i = 0; i < n; i++) CHECK_WITHIN(motion[0][i], i == 2 ? R(0.1) : 0, 0);
        for (int q = 1; q < 3; q++) CHECK_WITHIN(sp__dot(e->q, motion[q], n), -2, TOL(1e-8, 1e-3));
        sp__limit_loads(lim, 0);
        CHECK_WITHIN(sp__system_work(e->w, motion[2]), 0.3, TOL(1e-6, 1e-2));
        whole();
    }
}

#ifndef SP_REAL_MIXED
/* From a step of length[0] on, which is kept behind x in copy 1; each that is longer is kept in the other copy, and by turns in r
 * and d. A shorter one goes back to that before it. */
TEST(steps_are_centred_while_that_makes_them_longer)
{
    static const struct { double length[5]; int spent, solves, in_d; double is; } row[] = {
        { { 0.95, 0, 0, 0, 0 }, 0, 0, 0, 0.95 }, { { 0.5, 0.4, 0, 0, 0 }, 0, 1, 0, 0.5 }, { { 0.5, 0.52, 0, 0, 0 }, 0, 1, 1, 0.52 },
        { { 0.5, 0.54, 0.53, 0, 0 }, 0, 2, 1, 0.54 }, { { 0.5, 0.54, 0.55, 0, 0 }, 0, 2, 0, 0.55 },
        { { 0.5, 0.6, 0.7, 0.8, 0.85 }, 0, 4, 0, 0.85 },
        { { 0.5, 0.6, 0.7, 0.8, 0.75 }, 0, 4, 1, 0.8 }, { { 0.5, 0.5, 0, 0, 0 }, 0, 1, 1, 0.5 }, { { 0.5, 0.6, 0, 0, 0 }, 1, 0, 0, 0.5 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        columns(NOTHING, R(0.5), 1);
        sp__system *w = lim->engine.w;
        sp__homogeneous *h = &lim->engine.h;
        sp__ipm *m = &h->m;
        told = 1;
        lengths = row[k].length + 1;
        w->budget.spent = row[k].spent;
        m->reach = R(row[k].length[0]);
        m->sigma = R(0.1);
        m->kept = 1;
        m->along[2] = w->r;
        h->dl = h->ds = m->dtau = m->dkappa = 77;
        const sp_real *dy = sp__interior_centre(lim);
        const int solves = (int)(lengths - row[k].length) - 1;
        CHECK_INT(solves, row[k].solves);
        CHECK_INT(dy == (row[k].in_d ? w->d : w->r) && dy == m->along[2], 1);
        CHECK_WITHIN(m->reach, row[k].is, TOL(1e-12, 1e-6));
        CHECK_INT(m->kept, row[k].in_d ? 2 : 1);
        CHECK_INT(h->dl > 76 && h->ds > 76 && m->dtau > 76 && m->dkappa > 76, dy == w->r && solves < 2);
        lengths = NULL;
        whole();
    }
}
#endif

/* With a metric sizes stay as they are. */
TEST(sizes_stay_where_there_is_a_metric)
{
    for (int k = 0; k < 3; k++) {
        opened(NOTHING, UP, R(0.5));
        sp__system *w = lim->engine.w;
        w->measure.metric = k == 0 ? 0 : R(0.75) * (sp_real)k;
        w->measure.size[0] = 77;
        sp__limit_loads(lim, 3);
        sp__limit_sizes(lim);
        CHECK_INT(w->measure.size[0] < 77 || w->measure.size[0] > 77, k == 0);
        whole();
    }
}

/* Live loads that do less than rounding in a motion have no share in it; those that do little have. */
TEST(live_loads_care_from_rounding_on)
{
    for (int k = 0; k < 5 && sizeof(sp_real) <= 8; k++) {       /* in quad their balance is beyond all numbers */
        static const double tilt[5] = { 0, 1, 100, 1000, 1e6 };         /* in units of the last place */
        const sp_real live[3] = { W, 0, W };
        opened(NOTHING, live, R(0.5));
        sp_real y[6] = { 0, 0, 0, 0, 0, 0 };
        for (int e = 0; e < 6; e++) lim->engine.q[e] = e == 0 || e == 2;
        y[0] = 1;
        y[2] = -1 - R(tilt[k]) * (sp_real)SP_EPSILON;
        lim->best = SP__HUGE;
        lim->slack = 0;
        sp__limit_candidate(lim, y);
        CHECK_INT(lim->best < SP__HUGE, k > 2);
        whole();
    }
}

#endif

TEST_LIST(embed)
#if SP__WITH_INTERIOR
    RUN(interior_points_end_where_written_here)
    RUN(columns_are_apart_where_loads_let_them)
    RUN(motions_work_as_the_embedding_wants)
#ifndef SP_REAL_MIXED
    RUN(steps_are_centred_while_that_makes_them_longer)
#endif
    RUN(sizes_stay_where_there_is_a_metric)
    RUN(live_loads_care_from_rounding_on)
#endif
TEST_END
