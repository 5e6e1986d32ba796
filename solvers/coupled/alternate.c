/* alternate: the specification's search for a triple, for comparison: forces and motion take turns.          [seed 3.2, 3.3] */
#ifndef SP__COUPLED_ALTERNATE_C
#define SP__COUPLED_ALTERNATE_C

#include "../linear/csc.c"
#include "../seed/program.c"
#include "offer.c"

#if SP__WITH_COUPLED

#if SP__WITH_ADMM
/* The seed's own search, settings.coupled.rounds > 0: forces and motion take turns.                        [seed 3.2, 3.3]
 *
 *     E: fn > max(floor, engaged max fn)     F: |ft| above the same     w^2 = fn / max fn     h = ft / |ft|
 *     min over dq, beta   sum_E w^2 (dn + eps)^2 + sum_F |dt + beta h|^2 + reg |dq|^2
 *     s.t.                dn >= -eps, |dd| <= eta, beta >= least
 *
 * in our signs and units of L: first without constraints, beta solved for in closed form (in the block matrix it is the
 * projection of dt across h); where that breaks a constraint, as a quadratic program. Where w |dn + eps| <= gate on E the
 * forces are laid along the slips and the triple is judged like any other. Else the worst joints of E lose their force and
 * friction against the slip is dropped, and the forces are solved for anew.
 *
 * The least such motion hardly slips, which explains no friction. Terms of ours: beta is drawn, ever so weakly, to m->slip and
 * bounded below; corners that hardly press are drawn as weakly to close; F is a part of E. With the seed's constants in the
 * settings its motion is without them (weak, least = 0) until it passes the gate, where the seed would have ended; from there
 * on it is with them, so that there is a triple to judge. */
typedef struct sp__alt {
    sp__cra *c;
    const sp_seed *seed;
    sp_real (*f)[3];                    /* points: forces of the round, in units */
    sp_real (*h)[2];                    /* points: direction of friction, 0 outside F */
    sp_real *weight;                    /* points: w, 0 outside E */
    int32_t *pin;                       /* points: 1: no friction, 2: no force */
    sp_real *normal, *sliding;          /* points: a and b, parts of the force along the normal and along the slip */
    sp_real weak, slip, least;          /* weight of our terms, 0: the seed's motion; what beta is drawn to; its bound */
    sp_arena rest;                      /* for the programs */
} sp__alt;

/* min 1/2 x'Px + q'x over x = (y, d, beta): rows Aeq' y - d = 0, bounds of d, of beta. */
typedef struct sp__explain {
    sp_qp qp;
    sp_qp_settings set;
    sp_qp_result r;
    sp_triplets t;
    sp_csc A;
    int32_t *Pp, *Pi;
    sp_real *Px, *q, *l, *u, *x;
} sp__explain;

#define SP__ALT_STEPS 40                /* of the forces towards balance */
#define SP__ALT_WEAK ((sp_real)(sizeof(sp_real) == 8 ? 1e-6 : 1e-3))    /* of our terms: of (beta - slip)^2, (dn + eps)^2 */

static void sp__alt_carve(sp__alt *m, const sp_problem *pb, sp_arena *a)
{
    const size_t v = (size_t)pb->points;
    m->f = sp__take(a, v, sizeof *m->f);
    m->h = sp__take(a, v, sizeof *m->h);
    m->weight = sp__take(a, v, sizeof *m->weight);
    m->pin = sp__take(a, v, sizeof *m->pin);
    m->normal = sp__take(a, v, sizeof *m->normal);
    m->sliding = sp__take(a, v, sizeof *m->sliding);
}

/* Entries of A; weight: of force and moment rows (NULL: 1). */
static void sp__explain_entries(sp_triplets *t, const sp_problem *pb, const sp_real *weight)
{
    const int32_t y = 6 * pb->blocks, d = 3 * pb->points;
    t->count = 0;
    for (int32_t c = 0; c < pb->contacts; c++)
        for (int32_t q = 0; q < 3 * pb->contact[c].points; q++)
            sp__aeq_vertex(t, pb, &pb->contact[c], pb->contact[c].point + q / 3, 3, q % 3);
    for (int32_t k = 0; t->i && k < t->count; k++) {
        const int32_t row = t->i[k];
        t->i[k] = t->j[k];
        t->j[k] = row;
        t->x[k] = sp__held(pb, row / 6, (int)(row % 6)) ? 0 : t->x[k] * (weight ? weight[row / 3] : 1);
    }
    for (int32_t k = 0; k < d; k++) sp__triplets_put(t, k, y + k, -1);
    for (int32_t k = 0; k < d + pb->points; k++) sp__triplets_put(t, d + k, y + k, 1);
}

/* Unknowns: motion y 6b, d 3v, beta v. Rows: Aeq' y = d, bounds of d, of beta. */
static void sp__explain_size(const sp_problem *pb, sp_qp *qp)
{
    memset(qp, 0, sizeof *qp);
    qp->n = 6 * pb->blocks + 4 * pb->points;
    qp->m = 7 * pb->points;
}

static void sp__explain_carve(sp__explain *g, const sp_problem *pb, int32_t entries, sp_arena *a)
{
    const size_t n = (size_t)g->qp.n, m = (size_t)g->qp.m;
    g->Pp = sp__take(a, n + 1, sizeof *g->Pp);
    g->Pi = sp__take(a, n + 2 * (size_t)pb->points, sizeof *g->Pi);
    g->Px = sp__take(a, n + 2 * (size_t)pb->points, sizeof *g->Px);
    g->q = sp__take(a, n, sizeof *g->q);
    g->l = sp__take(a, m, sizeof *g->l);
    g->u = sp__take(a, m, sizeof *g->u);
    g->x = sp__take(a, n, sizeof *g->x);
    sp__triplets_carve(&g->t, entries, a);
}

/* w^2; of a joint that presses too little to be engaged hardly anything: it closes if nothing speaks against it. */
static sp_real sp__alt_closing_weight(const sp__alt *m, size_t v)
{
    const sp_real w = m->weight[v];
    return w > 0 ? w * w : m->f[v][0] > 0 && m->pin[v] < 2 ? m->weak : 0;
}

/* P and q; m NULL: only where their entries are. */
SP__NOINLINE static void sp__explain_cost(sp__explain *g, const sp_problem *pb, const sp__alt *m)
{
    const int32_t y = 6 * pb->blocks, d = 3 * pb->points;
    int32_t e = 0;
    for (int32_t j = 0; j < g->qp.n; j++) {
        const int32_t v = j < y ? 0 : j < y + d ? (j - y) / 3 : j - y - d, axis = j < y + d ? (j - y) % 3 : 3;
        const sp_real w2 = m && j >= y ? sp__alt_closing_weight(m, (size_t)v) : 0;
        const int rubs = m && j >= y && (m->h[v][0] * m->h[v][0] + m->h[v][1] * m->h[v][1] > 0);
        g->Pp[j] = e;
        g->q[j] = 0;
        for (int32_t k = 1; j >= y + d && k < 3; k++, e++) {
            g->Pi[e] = y + 3 * v + k;
            g->Px[e] = rubs ? m->h[v][k - 1] : 0;
        }
        g->Pi[e] = j;
        g->Px[e] = j < y ? (m ? m->seed->reg : 1) : axis == 0 ? w2 : axis < 3 ? (sp_real)rubs
                    : (sp_real)rubs + (m ? sp__max(m->weak, m->seed->reg) : 1);
        if (m && j >= y && axis == 0) g->q[j] = w2 * m->c->k.eps;
        if (m && j >= y + d) g->q[j] = -m->weak * m->slip;
        e++;
    }
    g->Pp[g->qp.n] = e;
}

/* Aeq' y = d;  -eps <= dn <= eta, |dt1|, |dt2| <= eta or, of |dt| <= eta, the square inside;  beta >= least. */
static void sp__explain_bounds(sp__explain *g, const sp_problem *pb, const sp__alt *m)
{
    const int32_t d = 3 * pb->points;
    const sp_real eta = !m ? 1 : m->c->set->coupled.box ? m->c->k.eta : (sp_real)0.7 * m->c->k.eta;
    for (int32_t i = 0; i < g->qp.m; i++) {
        const int normal = i < 2 * d && i % 3 == 0;
        g->l[i] = i < d ? 0 : i >= 2 * d ? (m ? m->least : 0) : normal ? (m ? -m->c->k.eps : 0) : -eta;
        g->u[i] = i < d ? 0 : i >= 2 * d ? SP_QP_INFINITY : normal && m ? m->c->k.eta : eta;
    }
}

/* The program in `a`; m NULL: its shape alone. NULL: it does not fit. */
SP__NOINLINE static sp__explain *sp__explain_make(const sp_problem *pb, const sp__alt *m, sp_arena *a)
{
    if (pb->points > INT32_MAX / 512 || pb->blocks > INT32_MAX / 512) return NULL;
    sp__explain *g = sp__take(a, 1, sizeof *g);
    if (!g) return NULL;
    memset(g, 0, sizeof *g);
    sp__explain_size(pb, &g->qp);
    g->t.rows = g->qp.m;
    g->t.cols = g->qp.n;
    sp__explain_entries(&g->t, pb, NULL);
    sp__explain_carve(g, pb, g->t.count, a);
    if (sp__failed(a)) return NULL;
    sp__explain_entries(&g->t, pb, m ? m->c->w->measure.weight : NULL);
    if (sp_csc_from(&g->t, a, &g->A)) return NULL;
    sp__explain_cost(g, pb, m);
    sp__explain_bounds(g, pb, m);
    g->qp.Pp = g->Pp; g->qp.Pi = g->Pi; g->qp.Px = g->Px; g->qp.q = g->q;
    g->qp.Ap = g->A.p; g->qp.Ai = g->A.i; g->qp.Ax = g->A.x;
    g->qp.l = g->l; g->qp.u = g->u;
    return g;
}

static sp_qp_solver sp__alt_solver(const sp_settings *set) { return set->penalty.solver ? *set->penalty.solver : sp_qp_admm(); }

/* Bytes of the program and of whoever solves it; the program is made in more than it keeps. */
static size_t sp__explain_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    size_t bytes = 0;
    sp__take(&scratch, 1, 0);                           /* aligned */
    const size_t from = scratch.used;
    scratch.peak = from;
    sp__explain *g = sp__explain_make(pb, NULL, &scratch);
    const sp_qp_solver solver = sp__alt_solver(set);
    if (!g) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, scratch.used - from);
    if (solver.need) {
        if (solver.need(solver.self, &g->qp, &sp__seed_of(set)->native, scratch, &bytes)) return SIZE_MAX;
        sp__take(&dry, 1, bytes);
    } else {
        sp__take(&dry, (size_t)g->qp.n, sizeof(sp_real));
        sp__take(&dry, (size_t)g->qp.m, sizeof(sp_real));
    }
    const size_t made = scratch.peak - from;
    return dry.used > made ? dry.used : made;
}

/* Bytes of its own arrays. */
SP__NOINLINE static size_t sp__alt_bytes(const sp_problem *pb)
{
    sp_arena dry = sp__arena_dry();
    sp__alt m;
    sp__take(&dry, 1, sizeof m);
    sp__alt_carve(&m, pb, &dry);
    return dry.used;
}

/* Bytes of the alternation; SIZE_MAX: scratch too small. */
static size_t sp__alt_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    if (!set->coupled.rounds || !pb->blocks) return 0;
    const size_t forces = sp__admm_need(pb, set, scratch), motion = sp__explain_need(pb, set, scratch);
    if (forces == SIZE_MAX || motion == SIZE_MAX) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sp__alt_bytes(pb));
    sp__take(&dry, 1, forces > motion ? forces : motion);
    return dry.used;
}

/* Scratch for that, from counts alone; 0: too large. */
static size_t sp__alt_scratch(const sp_problem *pb, const sp_settings *set)
{
    const size_t forces = sp__admm_scratch(pb, set);
    if (!forces || pb->points > INT32_MAX / 512 || pb->blocks > INT32_MAX / 512) return 0;
    sp_qp qp;
    sp_arena dry = sp__arena_dry();
    sp__explain_size(pb, &qp);
    const int32_t entries = 43 * pb->points;
    const size_t n = (size_t)qp.n, m = (size_t)qp.m;
    const size_t solver = sp__qp_bytes(&qp, entries + qp.n + 2 * pb->points, sp__seed_of(set)->native.backend, 0, 0);
    if (!solver) return 0;
    sp__take(&dry, 1, sizeof(sp__explain) + 16 * SP_ALIGN);
    sp__take(&dry, 6 * n + 2 * m + 8, sizeof(sp_real));
    sp__take(&dry, (size_t)entries + n + 1, 2 * sizeof(sp_real) + 3 * sizeof(int32_t));
    sp__take(&dry, 1, solver);
    if (sp__failed(&dry)) return 0;
    return sizeof(sp__cra) + SP_ALIGN + (dry.used > forces ? dry.used : forces);
}

/* E, F, w, h of the round's forces.     returns the number of engaged vertices */
static int32_t sp__alt_engage(sp__alt *m)
{
    const sp__cra *c = m->c;
    sp_real most = 0;
    int32_t engaged = 0;
    for (int32_t v = 0; v < c->pb->points; v++) most = sp__max(most, m->f[v][0]);
    const sp_real least = sp__max(m->seed->floor, m->seed->engaged * most);
    for (int32_t v = 0; v < c->pb->points; v++) {
        const sp_real *f = m->f[v], ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
        const int rubs = ft > least && (!(m->weak > 0) || f[0] > least);
        m->weight[v] = f[0] > least ? SP_SQRT(f[0] / most) : 0;
        m->h[v][0] = rubs ? f[1] / ft : 0;
        m->h[v][1] = rubs ? f[2] / ft : 0;
        engaged += f[0] > least;
    }
    return engaged;
}

/* The motion of least squares, beta free, into w->y: (2J'J + reg) y = -2J' (residual of rest). */
SP__NOINLINE static void sp__alt_least_squares(sp__alt *m)
{
    const sp__cra *c = m->c;
    const sp_real weak = sp__max(m->weak, m->seed->reg);
    memset(c->spring.d, 0, 3 * (size_t)c->pb->points * sizeof *c->spring.d);
    memset(c->spring.D, 0, 6 * (size_t)c->pb->points * sizeof *c->spring.D);
    for (size_t v = 0; v < (size_t)c->pb->points; v++) {
        const sp_real x = m->h[v][0], y = m->h[v][1];
        sp_real *D = c->spring.D + 6 * v, *pull = c->spring.d + 3 * v;      /* right-hand sides in the place of rates */
        D[0] = sp__alt_closing_weight(m, v);
        pull[0] = -D[0] * c->k.eps;
        if (!(x * x + y * y > 0)) continue;
        D[3] = y * y + weak * x * x;
        D[4] = (weak - 1) * x * y;
        D[5] = x * x + weak * y * y;
        pull[1] = -weak * m->slip * x;
        pull[2] = -weak * m->slip * y;
    }
    sp__system_factor(c->w, SP__GIVEN, c->w->y, m->seed->reg);
    sp__cra_balance(c, c->spring.d, 0);
    sp__system_solve(c->w, c->w->r, c->w->y);
    sp__cra_rates(c, c->w->y, c->spring.d);
}

/* beta of vertex v that suits its slip. */
static sp_real sp__alt_beta(const sp__alt *m, size_t v)
{
    const sp_real *d = m->c->spring.d + 3 * v;
    return -(d[1] * m->h[v][0] + d[2] * m->h[v][1]);
}

/* Does the motion keep the constraints? To 1e-3 eps: what presses is put into place later. */
static int sp__alt_within_bounds(const sp__alt *m)
{
    const sp__lengths *k = &m->c->k;
    for (size_t v = 0; v < (size_t)m->c->pb->points; v++) {
        const sp_real *d = m->c->spring.d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
        const sp_real most = m->c->set->coupled.box ? sp__max(sp__abs(d[1]), sp__abs(d[2])) : slip;
        if (d[0] < -k->eps - (sp_real)1e-3 || sp__max(d[0], most) > k->eta) return 0;
        if (m->least > 0 && m->h[v][0] * m->h[v][0] + m->h[v][1] * m->h[v][1] > 0 && sp__alt_beta(m, v) < m->least) return 0;
    }
    return 1;
}

/* Budget that is left for a program.     returns 0 when it is too little */
static int sp__alt_set_budget(const sp__cra *c, const sp_qp *qp, sp_qp_settings *set)
{
    if (c->set->budget <= 0) return 1;
    set->budget = c->w->budget.limit - c->out->cost.flops;
    if (set->budget < sp__program_least_flops(qp)) c->w->budget.spent = 1;
    return !c->w->budget.spent;
}

/* Count the cost of a program.     returns whether it is solved; `close`: nearly will do */
static int sp__alt_solved(const sp__cra *c, const sp_qp_result *r, int close)
{
    c->out->cost.flops += r->flops;
    c->out->cost.factorisations += r->factorisations;
    c->out->cost.iterations += r->iterations;
    if (r->status == SP_QP_BUDGET) c->w->budget.spent = 1;
    return r->x && (r->status == SP_QP_SOLVED || (close && r->status == SP_QP_INACCURATE));
}

/* The motion under its constraints, as a quadratic program.     returns 1, 0: no answer */
SP__NOINLINE static int sp__alt_explain(sp__alt *m)
{
    const sp__cra *c = m->c;
    const size_t n = 6 * (size_t)c->pb->blocks, d = 3 * (size_t)c->pb->points;
    sp_arena a = m->rest;
    sp__explain *g = sp__explain_make(c->pb, m, &a);
    const sp_qp_solver solver = sp__alt_solver(c->set);
    if (!g) return 0;
    memcpy(g->x, c->w->y, n * sizeof *g->x);
    memcpy(g->x + n, c->spring.d, d * sizeof *g->x);
    for (size_t v = 0; v < d / 3; v++) g->x[n + d + v] = sp__max(sp__alt_beta(m, v), m->least);
    g->set = m->seed->native;
    if (!sp__alt_set_budget(c, &g->qp, &g->set)) return 0;
    if (solver.solve(solver.self, &g->qp, &g->set, &a, g->x, NULL, &g->r)) return 0;
    if (!sp__alt_solved(c, &g->r, 1)) return 0;
    for (size_t k = 0; k < n; k++) if (!sp__finite(g->r.x[k])) return 0;
    memcpy(c->w->y, g->r.x, n * sizeof *c->w->y);
    sp__cra_rates(c, c->w->y, c->spring.d);
    return 1;
}

/* Our terms, or with weak = 0 none. */
static void sp__alt_terms(sp__alt *m, sp_real weak)
{
    const sp__lengths *k = &m->c->k;
    m->weak = weak;
    m->slip = !(weak > 0) ? 0 : k->eps > 0 && k->eta > 10 ? 1 : k->eta / 10;
    m->least = weak > 0 ? sp__max(m->slip / 1000, 4 * SP__SLIP) : 0;
}

/* The motion for the round's forces.     returns 1, 0: none: nothing presses, or its program has no answer */
static int sp__alt_motion(sp__alt *m)
{
    if (!sp__alt_engage(m)) return 0;
    sp__alt_least_squares(m);
    return sp__alt_within_bounds(m) || sp__alt_explain(m);
}

/* w |dn + eps| at vertex v, in L. */
static sp_real sp__alt_gap(const sp__alt *m, size_t v)
{
    return m->weight[v] * sp__abs(m->c->spring.d[3 * v] + m->c->k.eps);
}

/* Corners that the motion does not explain lose their force: of E the worst, of F those off their slip.
 *     returns how many were pinned */
static int32_t sp__alt_remove_worst(sp__alt *m, sp_real worst)
{
    const sp_real most = sp__max(m->seed->gate, m->seed->drop * worst);
    int32_t pinned = 0;
    for (size_t v = 0; v < (size_t)m->c->pb->points; v++) {
        const sp_real *d = m->c->spring.d + 3 * v, beta = sp__max(sp__alt_beta(m, v), 0);
        const sp_real x = d[1] + beta * m->h[v][0], y = d[2] + beta * m->h[v][1];
        const int rubs = m->h[v][0] * m->h[v][0] + m->h[v][1] * m->h[v][1] > 0;
        const int32_t pin = sp__alt_gap(m, v) > most ? 2 : rubs && SP_SQRT(x * x + y * y) > m->seed->slip_error ? 1 : 0;
        if (pin <= m->pin[v]) continue;
        m->pin[v] = pin;
        pinned++;
    }
    return pinned;
}

/* Forces anew, columns of what is pinned out of A.     returns 1; 0: none, or with tension */
SP__NOINLINE static int sp__alt_forces(sp__alt *m)
{
    const sp__cra *c = m->c;
    sp_arena a = m->rest;
    sp__program *g = sp__program_make(c->pb, c->set, NULL, &a);
    if (!g) return 0;
    for (int32_t j = 0; j < g->qp.n; j++)
        if (m->pin[j / 4] > (j % 4 < 2))
            for (int32_t k = g->at.Ap[j]; k < g->at.Ap[j + 1]; k++) g->at.Ax[k] = 0;
    if (!sp__alt_set_budget(c, &g->qp, &g->set)) return 0;
    if (g->solver.solve(g->solver.self, &g->qp, &g->set, &a, NULL, NULL, &g->r)) return 0;
    if (!sp__alt_solved(c, &g->r, 0)) return 0;
    sp_real press = 0, pull = 0;
    for (size_t v = 0; v < (size_t)c->pb->points; v++) {
        const sp_real *x = g->r.x + 4 * v;                      /* in units of the loads of c->pb, as m->f is */
        for (int k = 0; k < 3; k++) {
            m->f[v][k] = m->pin[v] > (k == 0) ? 0 : k ? x[k + 1] : x[0] - x[1];
            if (!sp__finite(m->f[v][k])) return 0;
        }
        press = sp__max(press, x[0]);
        pull = sp__max(pull, x[1]);
    }
    return sp__ratio(pull, press) <= m->seed->tension;
}

/* f = a e + b g in each closed vertex: e = n, g = n - reach dt / |dt|; a, b first from the round's forces.
 * The derivative for a step in proportion to a and b:  D = a e e' + b g g'. */
SP__NOINLINE static void sp__alt_slip_forces(const sp__alt *m, int first)
{
    const sp__cra *c = m->c;
    sp_real *a = m->normal, *b = m->sliding;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__cra_sbar(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real *d = c->spring.d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
            const sp_real reach = sp__cra_friction(c, t, d);
            const int rubs = slip > 2 * SP__SLIP && reach > 0;
            const sp_real x = rubs ? -reach * d[1] / slip : 0, y = rubs ? -reach * d[2] / slip : 0;
            sp_real *f = c->spring.f + 3 * v, *D = c->spring.D + 6 * v;
            if (first) {
                const sp_real along = rubs ? sp__max(m->f[v][1] * x + m->f[v][2] * y, 0) / (reach * reach) : 0;
                const int closed = sp__abs(d[0] + c->k.eps) <= SP__GIVE / 2;
                b[v] = closed && rubs ? sp__max(along, (sp_real)0.01 * s) : 0;
                a[v] = closed ? sp__max(m->f[v][0] - along, (sp_real)0.01 * s) : 0;
            }
            const sp_real A = a[v] / c->sbar_most, B = b[v] / c->sbar_most;
            f[0] = a[v] + b[v];
            f[1] = b[v] * x;
            f[2] = b[v] * y;
            D[0] = A + B;
            D[1] = B * x; D[2] = B * y;
            D[3] = B * x * x; D[4] = B * x * y; D[5] = B * y * y;
        }
    }
}

/* One step towards balance that keeps a and b positive: df = -D Aeq' z, Aeq D Aeq' z = Aeq f + p. */
SP__NOINLINE static void sp__alt_step(const sp__alt *m)
{
    const sp__cra *c = m->c;
    sp__system *w = c->w;
    sp_real *a = m->normal, *b = m->sliding, least = -1;
    sp__system_factor(w, SP__GIVEN, w->y, SP__SHIFT);
    sp__system_solve(w, w->r, w->d);
    for (int pass = 0; pass < 2; pass++)
        for (int32_t q = 0; q < c->pb->contacts; q++) {
            const sp_contact *t = &c->pb->contact[q];
            sp_real V[3], W[3], u[3];
            sp__system_twist(w, t, w->d, V, W);
            for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
                const sp_real *f = c->spring.f + 3 * v;
                sp__system_rate(w, V, W, c->pb->local[v], u);
                const sp_real ge = u[0], gg = u[0] + (b[v] > 0 ? (f[1] * u[1] + f[2] * u[2]) / b[v] : 0), k = 1 / c->sbar_most;
                if (!pass) least = sp__max(least, sp__max(ge, gg) * k);
                else {
                    const sp_real by = least > (sp_real)0.9 ? (sp_real)0.9 / least : 1;
                    a[v] -= by * k * a[v] * ge;
                    b[v] -= by * k * b[v] * gg;
                }
            }
        }
}

/* Forces along the motion's slips where it presses, and the triple to the certificate check.   returns 1 when it is verified */
static int sp__alt_offer(sp__alt *m)
{
    sp__cra *c = m->c;
    for (size_t v = 0; v < (size_t)c->pb->points; v++)
        c->spring.f[3 * v] = m->weight[v] > 0
                          || (sp__alt_closing_weight(m, v) > 0 && sp__abs(c->spring.d[3 * v] + c->k.eps) <= (sp_real)0.01);
    sp__cra_move_to_contact(c);
    for (int step = 0; step < SP__ALT_STEPS; step++) {
        sp__alt_slip_forces(m, !step);
        sp__cra_balance(c, c->spring.f, 1);
        if (sp__system_norm(c->w, c->w->r) <= 32 * (sp_real)SP_EPSILON * c->w->measure.load) break;
        sp__alt_step(m);
    }
    sp__alt_slip_forces(m, 0);
    return sp__cra_offer(c);
}

/* A round's motion and its residual, the largest w |dn + eps|. Where the seed's own passes the gate, the seed is done: it is
 * taken anew with our terms, and they stay, until a triple is verified.     returns 1, 0: there is none */
static int sp__alt_look(sp__alt *m, sp_real *worst)
{
    for (;;) {
        *worst = 0;
        if (!sp__alt_motion(m)) return 0;
        for (size_t v = 0; v < (size_t)m->c->pb->points; v++) *worst = sp__max(*worst, sp__alt_gap(m, v));
        if (m->weak > 0 || *worst > m->seed->gate) return 1;
        sp__alt_terms(m, SP__ALT_WEAK);
    }
}

/* Rounds of forces and motion.     returns 1 when a triple is verified, -1: no memory */
SP__NOINLINE static int sp__alternate(sp__cra *c, sp_arena *a)
{
    sp__alt *m = sp__take(a, 1, sizeof *m);
    if (!m) return -1;
    memset(m, 0, sizeof *m);
    sp__alt_carve(m, c->pb, a);
    if (sp__failed(a)) return -1;
    m->c = c;
    m->seed = sp__seed_of(c->set);
    m->rest = *a;
    sp__alt_terms(m, c->set->seed ? 0 : SP__ALT_WEAK);
    memset(m->pin, 0, (size_t)c->pb->points * sizeof *m->pin);
    const sp_real newton = sp__in_units(c->w->measure.unit, 1);         /* in units */
    for (size_t v = 0; v < (size_t)c->pb->points; v++) sp__scale3(newton, c->statics + 3 * v, m->f[v]);
    while (c->out->rounds < c->set->coupled.rounds) {
        sp_real worst;
        c->out->rounds++;
        if (!sp__alt_look(m, &worst)) return 0;
        const int32_t pinned = sp__alt_remove_worst(m, worst);
        const int passes = worst <= m->seed->gate;
        if (passes && sp__alt_offer(m)) return 1;
        if (!pinned && !passes) return 0;
        if (!pinned) memcpy(m->f, c->spring.f, (size_t)c->pb->points * sizeof *m->f);
        else if (!sp__alt_forces(m)) return 0;
    }
    return 0;
}
#else
static size_t sp__alt_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    (void)pb; (void)set; (void)scratch;
    return 0;
}

static size_t sp__alt_scratch(const sp_problem *pb, const sp_settings *set) { return (void)pb, (void)set, 0; }
SP__NOINLINE static int sp__alternate(sp__cra *c, sp_arena *a) { (void)c; (void)a; return 0; }
#endif

#elif SP__WITH_LARGE

static size_t sp__alt_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return (void)pb, (void)set, (void)scratch, 0;
}
static size_t sp__alt_scratch(const sp_problem *pb, const sp_settings *set) { return (void)pb, (void)set, 0; }

#endif

#endif /* SP__COUPLED_ALTERNATE_C */
