/* springs: forces from a motion, by springs at pressing corners and drag at slipping ones,
 * and Newton steps on the energy of both. */
#ifndef SP__COUPLED_SPRINGS_C
#define SP__COUPLED_SPRINGS_C

#include "../statics/bilateral.c"
#include "decide.c"

#if SP__WITH_COUPLED

/* Is there a virtual motion that explains the forces? Only asked where forces were found; every triple the search offers is
 * judged by the certificate check.
 *                                                                                          [Kao 2022, Eqs. 8-11; departure 3]
 *
 * For any alpha >= 0 the motion that minimises   -p . dq + 1/2 sum alpha |dt|^2   subject to dn >= -eps   meets every condition
 * but two: fn, its multiplier, balances the loads with ft = -alpha dt, but |ft| may exceed mu fn, and slips eta. So the search
 * looks for alpha. It starts with a drag so weak that joints close before friction carries anything, cuts each vertex's
 * friction at mu times the normal force it saw last, and lets the drag grow, which shortens the slips:
 *
 *     min  -p . dq + sum h(|dt|) + kn/2 sum max(0, lam/kn - (dn + eps))^2    h: drag/2 |dt|^2, from drag |dt| = bound on linear
 *
 * by Newton steps on the block matrix of the dual; lam <- fn, bound <- mu fn. Where forces and slips then agree, the motion is
 * put onto dn = -eps and the forces, along their slips, onto balance, both to rounding. */

/* Springs at the vertices, in units of force and of L; D, of a vertex: nn n1 n2 11 12 22. */
typedef struct sp__springs {
    sp_real *f, *d, *D;                 /* 3, 3, 6 x points: forces, dd / L, their derivative */
    sp_real *lam;                       /* points: multiplier of the normal */
    sp_real stiff;                      /* kn */
    sp_real soft;                       /* of joints that stick: their stiffness when pulled / when pressed; else 0 */
} sp__springs;

/* What friction carries: drag of the slip, up to a bound. */
typedef struct sp__drag {
    sp_real size;                       /* of slip, in sbar / L */
    sp_real *bound;                     /* points: bound of the friction; viscous: a factor on the drag */
    sp_real *share, *miss;              /* points: by how much of the miss the bound moves; the last miss, 0: none yet */
    int viscous;                        /* friction beyond its cone is lessened by its drag; else cut */
    sp_real grow;                       /* how fast a drag that was lessened may grow again */
} sp__drag;

/* Newton steps on the energy of both, and how far forces and slips are from agreeing. */
typedef struct sp__descent {
    sp_real *from;                      /* 6b: y before the step, or before the last digits */
    sp_real energy;                     /* at the end of a descent */
    sp_real goal, violation, change;    /* friction beyond its cone, change of fn, relative to sbar */
    int too_far;                        /* forces and slips agree, but a slip or opening exceeds eta */
} sp__descent;

/* What a vertex may carry in a motion held fast. */
typedef struct sp__held_vertex {
    sp_real reach;                      /* largest |ft| / fp, -1: open */
    sp_real against[2];                 /* direction of friction */
    sp_real per_slip;                   /* 1 / |dt| */
} sp__held_vertex;

/* A motion held fast, whose forces are those of the penalty form. */
typedef struct sp__held_motion {
    sp_real *y;                         /* 6b: that motion */
    sp__held_vertex *vertex;            /* points */
    sp_real least;                      /* of the penalty form so far */
    int on;                             /* forces are those of this motion */
} sp__held_motion;

/* The triple on offer. */
typedef struct sp__offer {
    sp__triple t;
    sp_real imbalance, residual;        /* in the certificate check */
    int made;                           /* the search made one */
    int tiny;                           /* friction had to be dropped because its slip was too short */
} sp__offer;

typedef struct sp__cra {
    const sp_problem *pb;
    const sp_settings *set;
    sp_coupled *out;
    const sp_real *statics;             /* 3 x points: the forces that were found [N] */
    sp__lengths k;
    sp_real sbar_most;                  /* largest sbar of a contact */
    sp__certifier j;
    sp__system *w;                      /* block matrix, rows, weights; w->y is the motion in L */
    sp__springs spring;
    sp__drag drag;
    sp__descent descent;
    sp__held_motion held;
    sp__offer offer;
    int mirror, spent;                  /* it was searched for in the plane; the budget ended the search */
    int slow;                           /* the first reflections took all the work that they may */
} sp__cra;

#ifdef SP_REAL_FLOAT
#define SP__AGREE ((sp_real)1e-3)       /* forces and slips agree so far when their other digits are tried */
#define SP__TINY_FORCE ((sp_real)1e-5)  /* forces below it, relative to sbar, are taken for none */
#else
#define SP__AGREE ((sp_real)1e-7)
#define SP__TINY_FORCE ((sp_real)1e-8)
#endif
#define SP__STIFF ((sp_real)(sizeof(sp_real) == 8 ? 1e4 : 100)) /* kn: of joints, in sbar / L */
#define SP__LESS_STIFF ((sp_real)100)   /* the same to begin with: fewer Newton steps a round, more rounds */
#define SP__CRA_FLOPS 4000000000        /* work after which the search gives up */
#define SP__HOLD_SHIFT ((sp_real)(sizeof(sp_real) == 8 ? 1e-8 : 1e-5))          /* SP__SHIFT for a motion held fast */

static void sp__triple_carve(sp__triple *t, const sp_problem *pb, sp_arena *a)
{
    t->f = sp__take(a, (size_t)pb->points, 3 * sizeof *t->f);
    t->dq = sp__take(a, (size_t)pb->blocks, 6 * sizeof *t->dq);
    t->alpha = sp__take(a, (size_t)pb->points, sizeof *t->alpha);
}

static void sp__cra_carve(sp__cra *c, const sp_problem *pb, int localise, sp_arena *a)
{
    const size_t v = (size_t)pb->points;
    c->spring.f = sp__take(a, v, 3 * sizeof *c->spring.f);
    c->spring.d = sp__take(a, v, 3 * sizeof *c->spring.d);
    c->spring.D = sp__take(a, v, 6 * sizeof *c->spring.D);
    c->spring.lam = sp__take(a, v, sizeof *c->spring.lam);
    c->drag.bound = sp__take(a, v, sizeof *c->drag.bound);
    c->drag.share = sp__take(a, v, sizeof *c->drag.share);
    c->drag.miss = sp__take(a, v, sizeof *c->drag.miss);
    c->descent.from = sp__take(a, (size_t)pb->blocks, 6 * sizeof *c->descent.from);
    c->held.y = sp__take(a, localise ? (size_t)pb->blocks : 0, 6 * sizeof *c->held.y);
    c->held.vertex = sp__take(a, localise ? v : 0, sizeof *c->held.vertex);
}

/* sbar of the vertices of contact c, the smaller. */
static sp_real sp__cra_sbar(const sp__cra *c, const sp_contact *t)
{
    return sp__least_of_blocks(t, &c->j.scale->s, sizeof *c->j.scale / sizeof c->j.scale->s);
}

/* Largest |ft| / fn against slip d: mu, of a pyramid what it reaches in that direction. */
static sp_real sp__cra_friction(const sp__cra *c, const sp_contact *t, const sp_real d[3])
{
    const sp_real mu = t->joint->strength.mu * c->j.mu_factor, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
    sp_real most = 0;
    if (!c->set->faces || !(slip > 0)) return mu;
    for (int32_t k = 0; k < c->set->faces; k++)
        most = sp__max(most, -(c->j.direction[k][0] * d[1] + c->j.direction[k][1] * d[2]));
    return mu * (slip / most);
}

/* u = Aeq' y at every vertex. */
SP__NOINLINE static void sp__cra_rates(const sp__cra *c, const sp_real *y, sp_real *u)
{
    if (!sp__system_count(c->w, 15, SP__FLOPS_TWIST / 2)) return;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        sp_real V[3], W[3];
        sp__system_twist(c->w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++)
            if (sp__system_multiplicity(c->w, v) > 0) sp__system_rate(c->w, V, W, c->pb->local[v], u + 3 * (size_t)v);
    }
}

/* w->r = Aeq f + load (load: 1 or 0), weighted. */
SP__NOINLINE static void sp__cra_balance(const sp__cra *c, const sp_real *f, int load)
{
    const sp_problem *pb = c->pb;
    if (load) sp__system_load(c->w, c->w->r);
    else memset(c->w->r, 0, 6 * (size_t)pb->blocks * sizeof *c->w->r);
    if (!sp__system_count(c->w, 15, SP__FLOPS_TWIST / 2)) return;
    for (int32_t q = 0; q < pb->contacts; q++) {
        const sp_contact *t = &pb->contact[q];
        sp_real F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 }, m[3];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real *g = f + 3 * (size_t)v, times = sp__system_multiplicity(c->w, v);
            if (!(times > 0)) continue;
            sp__cross3(pb->local[v], g, m);
            for (int k = 0; k < 3; k++) { F[k] += times * g[k]; M[k] += times * m[k]; }
        }
        sp__system_scatter(c->w, t, F, M, c->w->r);
    }
    sp__system_release(c->w, c->w->r);
}

/* Force and derivative of one vertex that moves by d; the energy stored in it is added to *energy. */
static void sp__cra_vertex(const sp__cra *c, size_t v, sp_real s, sp_real *energy)
{
    const int viscous = c->drag.viscous;
    const sp_real *d = c->spring.d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
    const sp_real drag = c->drag.size * s * (viscous ? c->drag.bound[v] : 1), bound = viscous ? SP__HUGE : c->drag.bound[v];
    const sp_real fn = c->spring.lam[v] - c->spring.stiff * s * (d[0] + c->k.eps);
    sp_real *f = c->spring.f + 3 * v, *D = c->spring.D + 6 * v;
    const int slides = drag * slip > bound;
    const sp_real al = slides ? bound / slip : drag, z = al / (c->spring.stiff * c->sbar_most);
    const sp_real x = slides ? d[1] / slip : 0, y = slides ? d[2] / slip : 0;
    f[0] = fn > 0 ? fn : c->spring.soft * fn;
    f[1] = -al * d[1];
    f[2] = -al * d[2];
    D[0] = (fn > 0 ? 1 : c->spring.soft) * s / c->sbar_most;
    D[1] = D[2] = 0;
    D[3] = z * (1 - x * x);
    D[4] = -z * x * y;
    D[5] = z * (1 - y * y);
    *energy += f[0] * fn / (2 * c->spring.stiff * s) + (slides ? bound * (slip - bound / (2 * drag)) : al * slip * slip / 2);
}

/* Forces in a motion held fast, d being the penalty form's potential:  fm = max(0, dn) / gamma, and (fp, sqrt(tau) |ft|) is
 * the nearest to -(dn, e . dt / sqrt(tau)) in the wedge between (1, 0) and (1, m). */
static void sp__cra_wedge(const sp__cra *c, size_t v, sp_real s, sp_real *energy)
{
    const sp__held_vertex *held = &c->held.vertex[v];
    const sp_real *d = c->spring.d + 3 * v, *e = held->against;
    const sp_real soft = 1 / c->set->penalty.gamma, slide = 1 / SP_SQRT(c->set->penalty.tau);
    const sp_real m = held->reach / slide, x = -d[0], z = -slide * (e[0] * d[1] + e[1] * d[2]);
    const sp_real on = (x + m * z) / (1 + m * m);
    const int open = held->reach < 0, inside = !open && x > 0 && z > 0 && z <= m * x, rim = !open && !inside && z > 0 && on > 0;
    const int axis = !open && z <= 0 && x > 0;
    const sp_real nn = inside || axis ? 1 : rim ? 1 / (1 + m * m) : 0;
    const sp_real nt = rim ? m * nn : 0, tt = inside ? 1 : rim ? m * nt : 0;
    const sp_real fp = inside || axis ? x : rim ? on : 0, ft = inside ? z : rim ? m * on : 0, fm = soft * sp__max(-x, 0);
    sp_real *f = c->spring.f + 3 * v, *D = c->spring.D + 6 * v;
    f[0] = s * (fp - fm);
    f[1] = s * slide * ft * e[0];
    f[2] = s * slide * ft * e[1];
    s /= c->sbar_most;
    D[0] = s * (nn + (x < 0 ? soft : 0));
    D[1] = s * slide * nt * e[0];
    D[2] = s * slide * nt * e[1];
    s *= slide * slide * tt;
    D[3] = s * e[0] * e[0];
    D[4] = s * e[0] * e[1];
    D[5] = s * e[1] * e[1];
    *energy += (f[0] * x + f[1] * -d[1] + f[2] * -d[2]) / 2;
}

/* sbar of contact t as the penalty form takes it: no metric unless there must be one. */
static sp_real sp__cra_size(const sp__cra *c, const sp_contact *t)
{
    return c->w->measure.metric > 0 ? sp__cra_sbar(c, t) : c->sbar_most;
}

/* Forces, derivatives and the energy of motion w->y; w->r: what they leave unbalanced. */
SP__NOINLINE static sp_real sp__cra_springs(sp__cra *c)
{
    sp_real energy = 0;
    sp__cra_rates(c, c->w->y, c->spring.d);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = c->held.on ? sp__cra_size(c, t) : sp__cra_sbar(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real times = sp__system_multiplicity(c->w, (int32_t)v);
            sp_real part = 0;
            if (!(times > 0)) continue;
            if (c->held.on) sp__cra_wedge(c, v, s, &part);
            else sp__cra_vertex(c, v, s, &part);
            energy += times * part;
        }
    }
    sp__cra_balance(c, c->spring.f, 1);
    return energy - sp__system_work(c->w, c->w->y);
}

/* Largest component of Aeq' y. */
SP__NOINLINE static sp_real sp__cra_extent(const sp__cra *c, const sp_real *y)
{
    sp_real most = 0;
    if (!sp__system_count(c->w, 15, SP__FLOPS_TWIST / 2)) return 0;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        sp_real V[3], W[3], u[3];
        sp__system_twist(c->w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            if (!(sp__system_multiplicity(c->w, v) > 0)) continue;
            sp__system_rate(c->w, V, W, c->pb->local[v], u);
            for (int k = 0; k < 3; k++) most = sp__max(most, sp__abs(u[k]));
        }
    }
    return most;
}

/* y <- kept + step d */
static sp_real sp__cra_energy_at(sp__cra *c, sp_real step)
{
    memcpy(c->w->y, c->descent.from, 6 * (size_t)c->pb->blocks * sizeof *c->descent.from);
    sp__system_axpy(c->w, step, c->w->d, c->w->y);
    return sp__cra_springs(c);
}

/* Line search: the step between 0 and `high` along d at which the energy is least; it falls by `down` at first,
 * and rises at `step`. */
static sp_real sp__cra_line_search(sp__cra *c, sp_real step, sp_real high, sp_real down)
{
    const size_t n = 6 * (size_t)c->pb->blocks;
    sp_real low = 0, energy = 0;
    for (int k = 0; k < 20; k++) {
        energy = sp__cra_energy_at(c, step);
        const sp_real slope = sp__dot(c->w->r, c->w->d, n);
        if (sp__abs(slope) < (sp_real)0.1 * down) break;
        if (slope > 0) low = step;
        else high = step;
        step = (low + high) / 2;
    }
    return energy;
}

/* Newton steps with halving on the energy; a motion held fast has sharper bends, and takes more of them.
 *   returns 0 when the motion runs away, or the work is spent */
SP__NOINLINE static int sp__cra_descend(sp__cra *c)
{
    const size_t n = 6 * (size_t)c->pb->blocks;
    sp__system *w = c->w;
    const int held = c->held.on;
    const sp_real enough = sp__max(1000 * (sp_real)SP_EPSILON, (sp_real)1e-3 * c->descent.goal);
    const sp_real shift = held ? SP__HOLD_SHIFT : SP__SHIFT;
    const sp_real room = 1 + (held ? 1000 * c->set->penalty.gamma : c->k.eta);
    const sp_real whole = 1 / ((held ? 1 : c->spring.stiff) * c->sbar_most);
    sp_real energy = sp__cra_springs(c), least = SP__HUGE;
    int stalled = 0;                                    /* steps without a gain beyond rounding */
    for (int it = 0; it < (held ? 150 : 30) && !w->budget.spent; it++) {
        const sp_real norm = sp__system_norm(w, w->r);
        if (norm <= enough * w->measure.load || (!held && stalled >= 3)) break;
        if (norm < least / 2) { least = norm; stalled = 0; }
        sp__system_factor(w, SP__GIVEN, w->y, shift);
        sp__system_solve(w, w->r, w->d);
        const sp_real down = sp__dot(w->r, w->d, n), reach = sp__cra_extent(c, w->d);
        memcpy(c->descent.from, w->y, n * sizeof *w->y);
        sp_real step = reach * whole > 20 * room ? 20 * room / reach : whole, next = energy;
        for (int half = 0; half < 30; half++, step /= 2) {
            next = sp__cra_energy_at(c, step);
            if (next <= energy - (sp_real)1e-4 * down * step + 100 * (sp_real)SP_EPSILON * sp__abs(energy)) break;
        }
        stalled += energy - next <= 100 * (sp_real)SP_EPSILON * sp__abs(energy);
        energy = held && step < whole ? sp__cra_line_search(c, step, whole, down) : next;
        c->out->cost.iterations++;
        if (!(sp__cra_extent(c, w->y) < 1000 * room)) return 0;
    }
    c->descent.energy = energy;
    return !w->budget.spent;
}

/* The bound of friction moves towards the room in its cone by a share of what it misses: the secant through the last two
 * misses, within 1/4 and 2 of the share before. Where friction lifts its own vertex, whole steps would turn about the answer.
 *                                                                                                     [Irons, Tuck 1969] */
static void sp__cra_move_bound(sp__drag *g, size_t v, sp_real ft, sp_real room)
{
    if (ft > room && g->bound[v] > ft) g->bound[v] = ft;
    if (!(g->bound[v] < SP__HUGE)) g->bound[v] = room;
    const sp_real miss = room - g->bound[v], last = g->miss[v], turn = last - miss;
    const sp_real factor = sp__abs(last) > 0 ? (last * turn > 0 ? last / turn : 2) : 1;
    g->share[v] = sp__within(g->share[v] * sp__within(factor, (sp_real)0.25, 2), (sp_real)1e-3, 1);
    g->miss[v] = miss;
    g->bound[v] += g->share[v] * miss;
}

/* Cut friction that exceeds its cone; lam follows fn.     returns 1 when forces and slips agree */
SP__NOINLINE static int sp__cra_update(sp__cra *c)
{
    sp__descent *n = &c->descent;
    n->violation = n->change = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t q = 0; q < c->pb->contacts; q++) {
            const sp_contact *t = &c->pb->contact[q];
            const sp_real s = sp__cra_sbar(c, t);
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                const sp_real *f = c->spring.f + 3 * (size_t)v;
                sp_real *bound = &c->drag.bound[v];
                const sp_real fp = sp__max(f[0], 0), room = sp__cra_friction(c, t, c->spring.d + 3 * (size_t)v) * fp;
                const sp_real ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
                if (!pass) {
                    n->violation = sp__max(n->violation, (ft - room) / s);
                    n->change = sp__max(n->change, sp__abs(fp - c->spring.lam[v]) / (c->spring.stiff * s));
                    c->spring.lam[v] = fp;
                } else if (c->drag.viscous) {
                    if (ft > 0) *bound *= sp__max((sp_real)0.1, room < 2 * ft ? (sp_real)0.999 * room / ft : c->drag.grow);
                    if (*bound > 1) *bound = 1;
                } else sp__cra_move_bound(&c->drag, (size_t)v, ft, room);
            }
            if (q + 1 == c->pb->contacts && !pass && n->violation <= n->goal) pass = 1;     /* the bounds are good */
        }
    return n->violation <= n->goal && n->change <= n->goal;
}

/* The motion put onto dn = -eps where a vertex presses: proximal steps on the squares of dn + eps. */
SP__NOINLINE static void sp__cra_move_to_contact(sp__cra *c)
{
    sp__system *w = c->w;
    for (int round = 0; round < 5; round++) {
        sp__cra_rates(c, w->y, c->spring.d);
        for (int32_t q = 0; q < c->pb->contacts; q++) {
            const sp_contact *t = &c->pb->contact[q];
            const sp_real s = sp__cra_sbar(c, t) / c->sbar_most;
            for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
                const int presses = c->spring.f[3 * v] > 0;
                sp_real *D = c->spring.D + 6 * v, *pull = c->spring.d + 3 * v;      /* a force in the place of its rate */
                D[0] = presses ? s : 0;
                D[1] = D[2] = D[4] = 0;
                D[3] = D[5] = (sp_real)1e-6 * s;
                pull[0] = presses ? -s * (pull[0] + c->k.eps) : 0;
                pull[1] = pull[2] = 0;
            }
        }
        if (!round) sp__system_factor(w, SP__GIVEN, w->y, SP__SHIFT);
        sp__cra_balance(c, c->spring.d, 0);
        sp__system_solve(w, w->r, w->d);
        sp__system_axpy(w, 1, w->d, w->y);
    }
    sp__cra_rates(c, w->y, c->spring.d);
}

#endif

#endif /* SP__COUPLED_SPRINGS_C */
