/* forest: where joints close no loop between blocks a triple needs no search. All blocks sink by eps, and each edge of the
 * graph slips as a plate whose friction is spread as its pressure: dt = -s g(r),
 * g(r) = G + w x (r - o) (sp__forest_slip_of). */
#ifndef SP__COUPLED_FOREST_C
#define SP__COUPLED_FOREST_C

#include "../base/sort.c"
#include "open.c"

#if SP__WITH_COUPLED

/* May a forest be answered without a search? Not where nothing may be left out, or the seed's search is asked for. */
static int sp__forest_allowed(const sp_settings *set) { return !set->coupled.rounds && set->iterations >= SP__ITERATIONS; }

/* The contact graph: supports are one node, and the joints of two nodes are one edge if they have one normal. */
typedef struct sp__forest {
    int32_t *contact;                   /* all contacts, those of one edge together */
    int32_t *degree, *join, *order;     /* of blocks; join: where the only edge left begins in contact; order: leaves first */
} sp__forest;

/* Do the joints i and j, in order of their nodes, belong to different edges?     1: i first, -1: j first, 0: to one */
static int sp__forest_order(const sp_problem *pb, int32_t i, int32_t j)
{
    const sp_contact *s = &pb->contact[i], *t = &pb->contact[j];
    const int32_t lo = s->a < s->b ? s->a : s->b, low = t->a < t->b ? t->a : t->b;
    const int32_t hi = s->a + s->b - lo, high = t->a + t->b - low;
    return lo != low ? (lo < low ? 1 : -1) : hi < high ? 1 : hi > high ? -1 : 0;
}

/* By edge, then by number. */
static int sp__forest_before(const void *what, int32_t i, int32_t j)
{
    const int order = sp__forest_order(what, i, j);
    return order ? order > 0 : i < j;
}

/* Sorts contacts by edges.     returns 0 where joints of the same two nodes have two normals, a ring */
SP__NOINLINE static int sp__forest_edges(const sp_problem *pb, sp__forest *g)
{
    for (int32_t q = 0; q < pb->contacts; q++) g->contact[q] = q;
    sp__sort(g->contact, pb->contacts, sp__forest_before, pb);
    for (int32_t k = 1; k < pb->contacts; k++) {
        const sp_contact *s = &pb->contact[g->contact[k - 1]], *t = &pb->contact[g->contact[k]];
        sp_real x[3];
        if (sp__forest_order(pb, g->contact[k - 1], g->contact[k])) continue;
        sp__cross3(s->joint->n, t->joint->n, x);
        if (!(sp__norm3(x) <= SP__GIVE) || (sp__dot3(s->joint->n, t->joint->n) > 0) != (s->a == t->a)) return 0;
    }
    return 1;
}

/* Leaves first: block order[k] goes with its only edge left, join[order[k]].
 *   returns 1 when no block is left: a forest rooted in the supports; 0: it does not, or no memory */
SP__NOINLINE static int sp__forest_of(const sp_problem *pb, sp__forest *g, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    int32_t n = 0;
    g->contact = sp__take(a, (size_t)pb->contacts, sizeof *g->contact);
    g->degree = sp__take(a, b, sizeof *g->degree);
    g->join = sp__take(a, b, sizeof *g->join);
    g->order = sp__take(a, b, sizeof *g->order);
    if (sp__failed(a) || !sp__forest_edges(pb, g)) return 0;
    for (size_t i = 0; i < b; i++) g->degree[i] = g->join[i] = 0;
    for (int32_t k = 0; k < pb->contacts; k++) {
        const sp_contact *t = &pb->contact[g->contact[k]];
        if (k && !sp__forest_order(pb, g->contact[k - 1], g->contact[k])) continue;
        if (t->a >= 0) { g->degree[t->a]++; g->join[t->a] ^= k; }       /* of a single edge left its number */
        if (t->b >= 0) { g->degree[t->b]++; g->join[t->b] ^= k; }
    }
    for (int32_t i = 0; i < pb->blocks; i++)
        for (int32_t v = i; v >= 0 && g->degree[v] == 1;) {
            const sp_contact *t = &pb->contact[g->contact[g->join[v]]];
            const int32_t u = t->a == v ? t->b : t->a;
            g->order[n++] = v;
            g->degree[v] = 0;
            if (u >= 0) { g->degree[u]--; g->join[u] ^= g->join[v]; }
            v = u;
        }
    return n == pb->blocks;
}

/* Friction of an edge, on the B side of its first joint, spread as its pressure, and the slip against it:
 * g(r) = G + w x (r - o). */
typedef struct sp__forest_slip {
    const sp_contact *first;
    int32_t from, to;                   /* of sp__forest.contact */
    sp_real o[3], G[3], w[3], F, I, M;
} sp__forest_slip;

/* g(r) */
static void sp__forest_slip_at(const sp__forest_slip *p, const sp_real r[3], sp_real g[3])
{
    sp_real arm[3];
    sp__sub3(r, p->o, arm);
    sp__cross3(p->w, arm, g);
    for (int k = 0; k < 3; k++) g[k] += p->G[k];
}

/* +1, or -1 for a joint whose A is the other's B. */
static sp_real sp__forest_slip_side(const sp__forest_slip *p, const sp_contact *t)
{
    return t->b == p->first->b ? (sp_real)1 : (sp_real)-1;
}

/* Friction that statics found at point v of contact t, on the B side of the first. */
static void sp__forest_slip_friction(const sp__cra *c, const sp__forest_slip *p, const sp_contact *t, int32_t v, sp_real ft[3])
{
    const sp_real *f = c->statics + 3 * (size_t)v, side = sp__forest_slip_side(p, t);
    for (int k = 0; k < 3; k++) ft[k] = side * (f[1] * t->joint->t1[k] + f[2] * t->joint->t2[k]);
}

/* One of four sums over an edge:  0 F, F o;  1 Ft;  2 I, Mn;  3 the largest |g|, returned. */
SP__NOINLINE static sp_real sp__forest_slip_sum(const sp__cra *c, const sp__forest *g, sp__forest_slip *p, int pass)
{
    const sp_real *at = c->pb->point[p->first->point];
    sp_real most = 0;
    for (int32_t k = p->from; k < p->to; k++) {
        const sp_contact *t = &c->pb->contact[g->contact[k]];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real fn = c->statics[3 * (size_t)v];
            sp_real x[3], y[3], ft[3];
            sp__forest_slip_friction(c, p, t, v, ft);
            sp__sub3(c->pb->point[v], pass ? p->o : at, x);
            sp__cross3(p->first->joint->n, x, y);
            if (pass == 0) { p->F += fn; for (int q = 0; q < 3; q++) p->o[q] += fn * x[q]; }
            if (pass == 1) for (int q = 0; q < 3; q++) p->G[q] += ft[q];
            if (pass == 2) { p->I += fn * sp__dot3(y, y); p->M += sp__dot3(ft, y); }
            if (pass < 3) continue;
            sp__forest_slip_at(p, c->pb->point[v], x);
            most = sp__max(most, sp__norm3(x));
        }
    }
    return most;
}

/* G = Ft / F, w = Mn / I n;  F = sum fn, o = sum fn r / F, I = sum fn |n x (r - o)|^2, Ft and Mn: friction and its moment
 * about o.     returns the largest |g| of the edge's vertices */
SP__NOINLINE static sp_real sp__forest_slip_of(const sp__cra *c, const sp__forest *g, int32_t from, sp__forest_slip *p)
{
    memset(p, 0, sizeof *p);
    p->first = &c->pb->contact[g->contact[from]];
    p->from = from;
    for (p->to = from + 1; p->to < c->pb->contacts && !sp__forest_order(c->pb, g->contact[from], g->contact[p->to]);) p->to++;
    sp__forest_slip_sum(c, g, p, 0);
    if (!(p->F > 0)) return 0;
    for (int k = 0; k < 3; k++) p->o[k] = c->pb->point[p->first->point][k] + p->o[k] / p->F;
    for (int pass = 1; pass < 3; pass++) sp__forest_slip_sum(c, g, p, pass);
    sp__scale3(1 / p->F, p->G, p->G);
    if (p->I > 0) sp__scale3(p->M / p->I, p->first->joint->n, p->w);
    return sp__forest_slip_sum(c, g, p, 3);
}

/* dq of block v from that of the block or support on the other side of the edge: sinking by eps, slip -s g. */
SP__NOINLINE static void sp__forest_slip_carry(const sp__cra *c, int32_t v, const sp__forest_slip *p, sp_real s)
{
    const sp_contact *t = p->first;
    const sp_problem *pb = c->pb;
    const int32_t u = t->a == v ? t->b : t->a;
    const sp_real sign = t->b == v ? (sp_real)1 : (sp_real)-1, *at = pb->scene->block[pb->block[v]].centroid;
    sp_real *m = c->offer.t.dq + 6 * (size_t)v, g[3];
    sp__forest_slip_at(p, at, g);
    for (int k = 0; k < 3; k++) {
        m[k] = -sign * (c->k.eps * c->k.L * t->joint->n[k] + s * g[k]);
        m[k + 3] = -sign * s * p->w[k];
    }
    if (u < 0) return;
    const sp_real *from = c->offer.t.dq + 6 * (size_t)u;
    sp_real arm[3], x[3];
    sp__sub3(at, pb->scene->block[pb->block[u]].centroid, arm);
    sp__cross3(from + 3, arm, x);
    for (int k = 0; k < 3; k++) { m[k] += from[k] + x[k]; m[k + 3] += from[k + 3]; }
}

/* f and alpha of an edge. */
SP__NOINLINE static void sp__forest_slip_write(const sp__cra *c, const sp__forest *g, const sp__forest_slip *p, sp_real s)
{
    for (int32_t k = p->from; k < p->to; k++) {
        const sp_contact *t = &c->pb->contact[g->contact[k]];
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            sp_real *f = c->offer.t.f + 3 * v, x[3];
            sp__forest_slip_at(p, c->pb->point[v], x);
            f[0] = c->statics[3 * v];
            f[1] = sp__forest_slip_side(p, t) * f[0] * sp__dot3(x, t->joint->t1);
            f[2] = sp__forest_slip_side(p, t) * f[0] * sp__dot3(x, t->joint->t2);
            c->offer.t.alpha[v] = s > 0 ? f[0] / s : 0;
        }
    }
}

/* If the edges join the free blocks to the supports as a forest, nothing need be searched for: how the sides of an edge move
 * against each other can be chosen for each edge alone. All sink by eps, dn = -eps at every vertex, and slip like a plate whose
 * drag is its pressure (sp__forest_slip_of):
 *
 *     ft = fn g(r),    dt = -s g(r),    alpha = fn / s      s > 0 as small as eta likes
 *
 * Their sum and moment are those of the friction that statics found, and fn stays, so balance stays; [K 8-10] hold whatever eps
 * and eta. What is left is |g| <= mu: of forces in their cones |Ft| <= mu F, so it holds where friction has no moment about the
 * normal, and else the certificate check decides. One cycle, and slips are not free: the H model's block lies between two
 * contacts with supports, the beam snug between a wall and an upright in a ring through the ground,
 * although it has no self-stress.
 *   returns 1 when the triple is verified */
SP__NOINLINE static int sp__cra_forest(sp__cra *c, sp_arena a)
{
    const sp_problem *pb = c->pb;
    const sp_real imbalance = c->offer.imbalance;
    sp__forest g;
    if (!sp__forest_allowed(c->set) || !sp__forest_of(pb, &g, &a)) return 0;
    for (int32_t k = pb->blocks; k-- > 0;) {
        sp__forest_slip p;
        const sp_real most = sp__forest_slip_of(c, &g, g.join[g.order[k]], &p);
        const sp_real slip = c->k.L * (c->k.eta < 2 ? c->k.eta / 2 : 1);
        const sp_real s = most > 0 ? slip / most : 0;
        sp__forest_slip_carry(c, g.order[k], &p, s);
        sp__forest_slip_write(c, &g, &p, s);
    }
    c->out->cost.flops += 240 * (int64_t)pb->points;
    c->offer.imbalance = sp__certify_forces(&c->j, c->offer.t.f, c->offer.t.f);
    c->offer.residual = sp__certify_coupled(&c->j, &c->k, c->offer.t.f, c->offer.t.dq, c->offer.t.alpha);
    if (c->offer.imbalance <= c->set->tol && c->offer.residual <= 1) return 1;
    sp__cra_offer_statics(c, imbalance);
    return 0;
}

#endif

#endif /* SP__COUPLED_FOREST_C */
