/* triple: do forces, motion and slip factors (f, dq, alpha) meet the conditions of the coupled check?     [Kao 2022, Eqs. 8-11]
 *
 *   dd = Aeq' dq,   dn >= -eps,   fn (dn + eps) = 0,   ft = -alpha dt, alpha >= 0,   dn <= eta, |dt| <= eta
 */
#ifndef SP__PROOF_TRIPLE_C
#define SP__PROOF_TRIPLE_C

#include "../scene/part.c"
#include "forces.c"

/* Largest tol of a coupled check: by so much a triple may miss balance, so a coarse one would certify what lies beyond its
 * limit, and no proof would reach as far. */
#define SP__COUPLED_TOL ((sp_real)(sizeof(sp_real) >= 8 ? 1e-6 : 1e-4))

#if SP__WITH_COUPLED

/* Tolerances of a triple (f, dq, alpha) of the coupled check, in units of its length L: a pressing joint by SP__GIVE, slip
 * that takes friction at least SP__SLIP and opposite within SP__SLIP, and what rounding hides in a motion: of a gap
 * SP__GIVE_MOST at most, or a block that spins about the points it is held at would hide all of it. */
#ifdef SP_REAL_FLOAT
#define SP__GIVE ((sp_real)1e-4)
#define SP__GIVE_MOST ((sp_real)1e-2)
#define SP__SLIP ((sp_real)1e-2)
#define SP__SLIP_ROUNDING (400 * (sp_real)SP_EPSILON)
#else
#define SP__GIVE ((sp_real)1e-10)
#define SP__GIVE_MOST ((sp_real)1e-6)
#define SP__SLIP ((sp_real)1e-6)
#define SP__SLIP_ROUNDING (4000000 * (sp_real)SP_EPSILON)
#endif
#define SP__GIVE_ROUNDING (16 * (sp_real)SP_EPSILON)

/* Lengths of the coupled check; eps and eta are counted in L: (1, eta / eps), or (0, 1) where eps is 0. */
typedef struct sp__lengths { sp_real L, eps, eta; } sp__lengths;

/* Mean edge of the joints that take part; where these are points, mean distance of a joint from its blocks' centroids. */
static sp_real sp__mean_edge(const sp_problem *pb)
{
    sp_real edges = 0, arms = 0, count = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const int32_t n = t->points > 2 ? t->points : t->points - 1;
        for (int32_t k = 0; k < n; k++) {
            sp_real e[3];
            sp__sub3(pb->point[t->point + (k + 1) % t->points], pb->point[t->point + k], e);
            edges += sp__norm3(e);
        }
        count += (sp_real)n;
        arms += (sp__norm3(t->ra) + sp__norm3(t->rb)) / 2;
    }
    if (edges > 0) return edges / count;
    return arms > 0 ? arms / (sp_real)pb->contacts : 1;
}

static sp__lengths sp__coupled_lengths(const sp_problem *pb, const sp_settings *set)
{
    const sp_coupled_settings *cs = &set->coupled;
    const sp_real edge = sp__mean_edge(pb), eps = cs->eps < 0 ? (sp_real)1e-4 * edge : cs->eps;
    const sp_real eta = cs->eta > 0 ? cs->eta : eps > 0 ? 100 * eps : (sp_real)1e-2 * edge;
    sp__lengths k = { eps, 1, 0 };
    if (eps > 0) k.eta = eta / eps;
    else { k.L = eta; k.eps = 0; k.eta = 1; }
    return k;
}

/* dd of vertex v of contact t in its frame, for the motion j->dual.motion. */
static void sp__certifier_rate_at(const sp__certifier *j, const sp_contact *t, int32_t v, sp_real d[3])
{
    sp_real w[3];
    sp__vertex_velocity(j->pb, NULL, t, v, j->dual.motion, w);
    d[0] = sp__dot3(w, t->joint->n); d[1] = sp__dot3(w, t->joint->t1); d[2] = sp__dot3(w, t->joint->t2);
}

/* The spin of block i about the line through all its contact points, if they lie on one: it moves no contact, so motions are
 * judged without it, and proofs need not bound it. In weighted rows z = dq / W, |k| = 1.     returns 0: there is none */
SP__NOINLINE static int sp__certifier_free_spin(const sp__certifier *j, int32_t i, sp_real k[6])
{
    const sp_problem *pb = j->pb;
    sp_real first[3] = { 0, 0, 0 }, line[3] = { 0, 0, 0 }, longest = 0;
    int32_t seen = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t c = 0; c < pb->contacts; c++) {
            const sp_contact *t = &pb->contact[c];
            for (int32_t v = t->point; (t->a == i || t->b == i) && v < t->point + t->points; v++) {
                sp_real r[3], off[3];
                sp__arm(pb, i, v, r);
                if (!seen++) memcpy(first, r, sizeof first);
                sp__sub3(r, first, r);
                sp__cross3(line, r, off);
                if (pass && sp__norm3(off) > 64 * (sp_real)SP_EPSILON * j->scale[i].arm) return 0;
                if (pass || !(sp__norm3(r) > longest)) continue;
                longest = sp__norm3(r);
                memcpy(line, r, sizeof line);
            }
        }
        if (!(longest > 0)) return 0;
        if (!pass) sp__scale3(1 / longest, line, line);
    }
    sp__cross3(first, line, k);                         /* of the centroid */
    sp_real size = 0;
    for (int q = 0; q < 6; q++) {
        k[q] = q < 3 ? k[q] / j->scale[i].wf : line[q - 3] / j->scale[i].wm;
        if (sp__held(pb, i, q) && sp__abs(k[q]) > 0) return 0;
        size += k[q] * k[q];
    }
    for (int q = 0; q < 6; q++) k[q] /= SP_SQRT(size);
    return 1;
}

/* dq of block i without that spin; twice, for what rounding leaves of a fast one. */
static void sp__certifier_remove_spin(const sp__certifier *j, int32_t i, sp_real *dq)
{
    sp_real k[6];
    if (!sp__certifier_free_spin(j, i, k)) return;
    for (int round = 0; round < 2; round++) {
        sp_real along = 0;
        for (int q = 0; q < 6; q++) along += k[q] * dq[q] / (q < 3 ? j->scale[i].wf : j->scale[i].wm);
        for (int q = 0; q < 6; q++) dq[q] -= along * k[q] * (q < 3 ? j->scale[i].wf : j->scale[i].wm);
    }
}

/* Worst violation of the conditions at one vertex relative to what is allowed. d: dd / L; ft and -alpha dt in units of force;
 * least: force below which friction is not asked for its slip. */
static sp_real sp__coupled_vertex(const sp__lengths *k, int box, const sp_real f[3], sp_real alpha, const sp_real d[3],
                                  sp_real moved, sp_real least)
{
    const sp_real hidden = SP__GIVE_ROUNDING * moved, gap = d[0] + k->eps;
    const sp_real g = SP__GIVE + (hidden < SP__GIVE_MOST ? hidden : SP__GIVE_MOST);
    const sp_real slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
    const sp_real most = box ? sp__max(sp__abs(d[1]), sp__abs(d[2])) : slip;
    sp_real worst = sp__max(d[0], most) > k->eta ? (sp__max(d[0], most) - k->eta) / g : 0;
    if (gap < 0 || f[0] > 0) worst = sp__max(worst, sp__abs(gap) / g);
    if (!(alpha >= 0)) return SP__HUGE;
    if (ft > least) {
        const sp_real x = f[1] + alpha * d[1], y = f[2] + alpha * d[2];
        worst = sp__max(worst, sp__ratio(SP_SQRT(x * x + y * y), SP__SLIP * ft));
        worst = sp__max(worst, sp__ratio(SP__SLIP + SP__SLIP_ROUNDING * moved, slip));
    }
    return worst < SP__HUGE ? worst : SP__HUGE;
}

/* Residual of a triple: f (3 x points), dq (6b), alpha (points).                                       [Kao 2022, Eqs. 8-10] */
SP__NOINLINE static sp_real sp__certify_coupled(sp__certifier *j, const sp__lengths *k, const sp_real *f, const sp_real *dq,
                                           const sp_real *alpha)
{
    const sp_problem *pb = j->pb;
    const int few = sp__problem_points(pb) <= SP_EXACT_POINTS;       /* only then there are proofs */
    for (int32_t i = 0; i < pb->blocks; i++) {
        for (size_t q = 0; q < 6; q++) j->dual.motion[6 * (size_t)i + q] = dq[6 * (size_t)i + q] / k->L;
        sp__drop_held(pb, i, j->dual.motion + 6 * (size_t)i);
        if (few) sp__certifier_remove_spin(j, i, j->dual.motion + 6 * (size_t)i);
    }
    sp_real worst = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real moved = sp__certifier_displacement(j, t->a) + sp__certifier_displacement(j, t->b);
        const sp_real least = j->set->tol * sp__least_of_blocks(t, &j->scale->s, sizeof *j->scale / sizeof j->scale->s);
        j->force_cap = sp__certifier_force_cap(j, t);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real g[3], d[3];
            sp__to_units(j->unit, 3, f + 3 * (size_t)v, g);
            sp__certifier_make_admissible(j, t, g, g);
            sp__certifier_rate_at(j, t, v, d);
            const sp_real alpha_L = sp__in_units(j->unit, alpha[v] * k->L);
            worst = sp__max(worst, sp__coupled_vertex(k, j->set->coupled.box, g, alpha_L, d, moved, least));
        }
    }
    j->sweeps++;
    return worst;
}

#endif

#endif /* SP__PROOF_TRIPLE_C */
