/* system: the dual problem, its vectors and its memory.
 *
 * The shortest force in the cones that balances p is f = S P_K(Aeq' y), where y minimises
 *
 *   D(y) = 1/2 sum S_v |P_K(u_v)|^2 + p . y,   u = Aeq' y         gradient Aeq f + p,  Hessian Aeq S DP_K(u) Aeq'
 *
 * convex, once differentiable, 6 unknowns a free block. f is admissible for every y; the imbalance is the only error. An
 * assembly that cannot stand has no minimiser: y runs off along the mechanism dq = -y.
 * Rows are weighted to unit size, forces counted in the largest load, so nothing depends on units. The penalty form adds
 * sum max(0, -u_n)^2 / (2 gamma) (tension at a price) and weighs friction by tau; with gamma finite it has a
 * minimiser wherever joints that pull could hold every block.
 */
#ifndef SP__STATICS_SYSTEM_C
#define SP__STATICS_SYSTEM_C

#include "../cone/ipm.c"
#include "../linear/bchol.c"
#include "mirror.c"

#if SP__WITH_LARGE

typedef enum sp__pass { SP__AIM, SP__REACH, SP__MOVE, SP__COLUMN, SP__CENTRE } sp__pass;

/* Interior points of joints with strength (capped.c), and scratch of the vertex at hand. Rows are 5: 3 of the cone, 2 of its
 * ends. */
typedef struct sp__capped {
    sp_real count;                      /* of cones and half lines */
    sp_real reserve, held;              /* h.z as it is summed; of the point at hand */
    sp_real bend, offset;               /* what its change has besides work of w->load: for each unit of dtau, and without */
    sp_real before;                     /* dtau of the predictor */
    sp_real mu, C, T, N;                /* of the vertex, in units of force_scale S; N 0: no crushing */
    sp_real cone, low, high;            /* scales of its rows, 0: there is no such row */
    sp_real lower, upper;               /* z / s of both ends */
    sp__nt W;
    sp_real D[6], b[3], t[3];           /* as in capped.c: x changes by D (du + t) + dtau b */
    sp_real dx[3], ds[5], dz[5];        /* changes */
    sp_real rest[5];                    /* G b + h */
    sp_real miss[5], resist[3];         /* G x + tau h - s; Aeq'y + G'z */
    sp_real change[5];                  /* W^-2 of what s is to change by */
} sp__capped;
#define SP__CAPPED 13                   /* numbers of a vertex: x, s, z */

/* The interior-point method (interior.c) has f = E x at a vertex, x in a cone that is its own dual. */
typedef struct sp__ipm {
    sp_real *x;                         /* 3 a vertex, or one an edge of its pyramid */
    sp_real force_scale;                /* force of x = e where S = 1 */
    sp_real theta, gap;                 /* what is left of the start's residuals; sum of x z */
    int16_t outside;                    /* x or z is no longer inside, by rounding */
    int16_t kept;                       /* targets of a step are kept behind x, in copy 1 or 2; 0: they are not */
    sp__pass pass;                      /* right-hand side; step length; step */
    int16_t again;                      /* with strength: begun anew after rounding had led out of the cones */
    int16_t corrected;                  /* the product of the predictor's changes is taken into account */
    int16_t ray;                        /* forces are asked for the live loads alone */
    int16_t idle;                       /* steps that got nowhere, one after the other */
    sp__capped *capped;                 /* NULL: no joint has strength */
    const sp_real *along[3];            /* y; its predictor and its step */
    sp_real tau, kappa, mu, sigma;
    sp_real kappa_weight;               /* weight of the pair: tau kappa = kappa_weight mu */
    sp_real reach;                      /* step length */
    sp_real dtau, dkappa;
} sp__ipm;

/* Scratch of a pass over the vertices of a contact. Twists are V and W of sp__system_twist. */
typedef struct sp__visit {
    sp_real twist[3][6];                /* motions, of B seen from A: one, or a point, its change and that one's change */
    sp_real u[3][3];                    /* rates of the vertex at hand in them */
    sp_real D[6];                       /* derivative of its force: nn, n1, n2, 11, 12, 22 */
    sp_real f[3], m[3];                 /* its force and the moment of that */
    sp_real sum[6];                     /* their sums over the vertices */
    sp_real h[3], z[3], dz[3];          /* interior points: a cone's target, its slack, that one's change */
    sp_real edge[3], rate[3];           /* an edge of its pyramid, u along it */
    sp_real origin[2][3];               /* of the contact, seen from the centroid of a, of b, in its frame */
} sp__visit;

/* A contact's Hessian on its way to the centroids of its blocks: 3 x 3 matrices in the world's axes. */
typedef struct sp__moved {
    sp_real vv[9], vw[9], ww[9];        /* about the contact's origin */
    sp_real vwa[9], vwb[9];             /* vw about the centroid of a, of b */
    sp_real part[9], sum[9];            /* of ww */
} sp__moved;

/* Temporaries, here because frames are small. Passes and moves take turns: H is all that is handed from one to the other. */
typedef struct sp__scratch {
    sp_real H[27];                      /* Hessian of a contact in its frame: vv, vw, ww, 9 numbers each */
    sp_real H3[9];                      /* in 3 rows */
    union {
        sp__visit visit;
        sp__moved moved;
        sp_real HT[2][9];               /* H3 times the map of a, of b */
    } of;
} sp__scratch;

/* Free blocks that touch; once L has its pattern all of it is free for other work. */
typedef struct sp__graph {
    int32_t *xadj, *adj;                /* where each block's neighbours start (b + 1), the neighbours */
    int32_t *parent, *mark;             /* b: of the elimination tree; marks */
} sp__graph;

#ifdef SP_REAL_MIXED
/* The matrix in full precision, what the factor in float is refined by. */
typedef struct sp__mixed {
    sp_real *diagonal, *coupling;       /* 21 a block as in L.d, 36 a contact */
    sp_real *scale;                     /* 6b: 1 / sqrt(its diagonal) */
    sp_real *cg;                        /* 24b: direction, its image, residual over the factor, residual */
} sp__mixed;
#endif

/* f(u) of a vertex. */
typedef struct sp__joint_law {
    sp__cone cone;
    sp__yield *yield;                   /* of the contact last asked for */
    const sp_real *given;               /* 6 x points: D of every vertex, for SP__GIVEN */
    sp_real soft, slide;                /* 1/gamma (0: no tension), 1/sqrt(tau); the exact form has 0 and 1 */
    sp_real friction;                   /* coefficient in force / mu */
    sp_real least;                      /* coefficient that every joint has at least */
} sp__joint_law;

/* Scales by which numbers are measured. */
typedef struct sp__measure {
    sp_real unit, load;                 /* force of one unit [N]; norm of the weighted load */
    sp_real metric;                     /* 1 / largest sbar of a contact, or 0: S = 1 everywhere */
    sp_real *weight;                    /* 2b: of force and moment rows */
    sp_real *size;                      /* 2b: sbar and Sbar of the certificate check, in units */
} sp__measure;

/* Work paid for. */
typedef struct sp__purse {
    int64_t limit;                      /* flops that cost may reach */
    sp_cost *cost;
    int spent;                          /* a piece of work did not fit; from then on none is done */
} sp__purse;

typedef struct sp__system {
    const sp_problem *pb;
    const sp_settings *set;
    sp__joint_law law;
    sp__measure measure;
    sp__graph graph;
    sp__bchol L;                        /* factor of the Hessian + shift */
    sp_real *dense;                     /* or, not NULL, its dense factor */
    int32_t *slot;                      /* per contact: its off-diagonal block in L; -1 - slot: transposed; INT32_MIN: none */
#ifdef SP_REAL_MIXED
    sp__mixed mixed;
#endif
    struct sp__reduction *reduction;    /* of a search in 3 rows a block, else NULL: ask sp__reduced */
    struct sp__ipm *inner;              /* of the interior-point method */
    sp__capped *capped;                 /* of that, where joints have strength, else NULL */
    sp_real *load;                      /* 6b, likewise: p + Aeq b, the column of tau */
    sp_real *x;                         /* points x sp__form_numbers */
    sp_real *y, *r, *d;                 /* 6b: potential, gradient, step */
    sp_real *carried;                   /* 3b: sum |f_v|, sum |x_v x f_v|, longest arm of the last forces; NULL: not wanted */
    sp__scratch *scratch;
    sp__purse budget;
    int singular;                       /* the bilateral matrix has null vectors that the load has a part along */
} sp__system;

/* What a system is made for. EXACT, LIMIT: with interior points; LEAST, LEAST_DENSE, POLISH: the bilateral force, METRIC with H
 * of the penalty form, POLISH with the seed's constants, too; MOTION: the coupled check. */
typedef enum sp__form {
    SP__EXACT, SP__LEAST, SP__LEAST_DENSE, SP__METRIC, SP__POLISH, SP__PENALTY, SP__LIMIT, SP__MOTION
} sp__form;

/* Are there interior points of joints with strength? The true cone's alone. */
static int sp__form_capped(const sp_problem *pb, const sp_settings *set, sp__form form)
{
    int strong = 0;
    if (!SP__WITH_INTERIOR || (form != SP__EXACT && form != SP__LIMIT) || set->faces) return 0;
    for (int32_t c = 0; c < pb->contacts; c++) strong |= sp__strength_beyond_friction(&pb->contact[c].joint->strength);
    return strong;
}

/* Numbers a vertex that it keeps in x: interior points 3, or one an edge of a pyramid, and for a limit two targets of each;
 * the polish its best forces on a budget. */
static size_t sp__form_numbers(sp__form form, const sp_settings *set, int capped)
{
    if (form == SP__POLISH) return set->budget > 0 ? 3 : 0;
    if (!SP__WITH_INTERIOR || (form != SP__EXACT && form != SP__LIMIT)) return 0;
    if (capped) return SP__CAPPED;
    return (size_t)(form == SP__LIMIT ? 3 : 1) * (set->faces ? (size_t)set->faces : 3);
}

#ifdef SP_REAL_MIXED
#define SP__REFINE 10                   /* steps a solution of the factor is refined by, at most */
#define SP__REFINED ((sp_real)1e-9)     /* of the first residual that may be left */
#endif
#define SP__CORRECTED ((sp_real)1e-3)   /* the same where the factor is of another y, and gains few digits more */

/* The reduction of a search in 3 rows a block, NULL where it has all 6; without SP__WITH_REDUCTION the compiler knows that, and
 * all that stands under it is gone. */
static const sp__reduction *sp__reduced(const sp__system *w) { return SP__WITH_REDUCTION ? w->reduction : NULL; }

/* Temporaries of the pass at hand. */
static sp__visit *sp__visit_of(const sp__system *w) { return &w->scratch->of.visit; }

/* Arrays of the graph and of L's columns from the arena. */
static void sp__graph_carve(sp__graph *g, sp__bchol *L, const sp_problem *pb, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    sp__bchol_carve_pattern(L, pb->blocks, a);
    g->xadj = sp__take(a, b + 1, sizeof *g->xadj);
    g->adj = sp__take(a, (size_t)pb->contacts, 2 * sizeof *g->adj);
    g->parent = sp__take(a, b, sizeof *g->parent);
    g->mark = sp__take(a, b, sizeof *g->mark);
}

/* All other arrays, for nnz blocks of L below the diagonal. */
static void sp__system_carve(sp__system *w, const sp_problem *pb, const sp_settings *set, sp__form form, int32_t nnz,
                             sp_arena *a)
{
    const size_t b = (size_t)pb->blocks, c = (size_t)pb->contacts;
    const int capped = sp__form_capped(pb, set, form);
    w->dense = form == SP__LEAST_DENSE ? sp__take(a, 3 * b, (6 * b + 1) * sizeof *w->dense) : NULL;
    sp__cone_carve(&w->law.cone, set->faces, a);
    w->law.yield = sp__take(a, 1, sizeof *w->law.yield);
    w->slot = sp__take(a, c, sizeof *w->slot);
    w->measure.weight = sp__take(a, b, 2 * sizeof *w->measure.weight);
    w->measure.size = sp__take(a, b, 2 * sizeof *w->measure.size);
    w->y = sp__take(a, b, 6 * sizeof *w->y);
    w->r = sp__take(a, b, 6 * sizeof *w->r);
    w->d = sp__take(a, b, 6 * sizeof *w->d);
    w->scratch = sp__take(a, 1, sizeof *w->scratch);
    if (sp__reduced(w)) {
        w->L.rows = 3;
        w->reduction->image = sp__take(a, (size_t)pb->points, sizeof *w->reduction->image);
        w->reduction->g = sp__take(a, c, SP__REDUCTION_G * sizeof *w->reduction->g);
    }
    sp__bchol_carve_values(&w->L, nnz, a);
#ifdef SP_REAL_MIXED
    w->mixed.diagonal = sp__take(a, b, 21 * sizeof *w->mixed.diagonal);
    w->mixed.coupling = sp__take(a, c, 36 * sizeof *w->mixed.coupling);
    w->mixed.scale = sp__take(a, b, 6 * sizeof *w->mixed.scale);
    w->mixed.cg = sp__take(a, b, 24 * sizeof *w->mixed.cg);
#endif
    if (SP__WITH_INTERIOR) w->inner = sp__take(a, 1, sizeof *w->inner);
    w->capped = capped ? sp__take(a, 1, sizeof *w->capped) : NULL;
    w->load = capped ? sp__take(a, b, 6 * sizeof *w->load) : NULL;
    w->x = sp__take(a, (size_t)pb->points, sp__form_numbers(form, set, capped) * sizeof *w->x);
}

/* Neighbours of every free block, each once. */
SP__NOINLINE static void sp__system_graph(sp__system *w)
{
    const sp_problem *pb = w->pb;
    const int32_t b = pb->blocks;
    sp__graph *g = &w->graph;
    for (int32_t i = 0; i <= b; i++) g->xadj[i] = 0;
    for (int32_t c = 0; c < pb->contacts; c++)
        if (pb->contact[c].a >= 0 && pb->contact[c].b >= 0) {
            g->xadj[pb->contact[c].a + 1]++;
            g->xadj[pb->contact[c].b + 1]++;
        }
    for (int32_t i = 0; i < b; i++) { g->xadj[i + 1] += g->xadj[i]; g->mark[i] = g->xadj[i]; }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int32_t i = pb->contact[c].a, k = pb->contact[c].b;
        if (i < 0 || k < 0) continue;
        g->adj[g->mark[i]++] = k;
        g->adj[g->mark[k]++] = i;
    }
    for (int32_t i = 0; i < b; i++) g->mark[i] = -1;
    int32_t to = 0, from = 0;                           /* repeated neighbours go: two joints between one pair */
    for (int32_t i = 0; i < b; i++) {
        const int32_t end = g->xadj[i + 1], start = to;
        for (; from < end; from++)
            if (g->mark[g->adj[from]] != i) { g->mark[g->adj[from]] = i; g->adj[to++] = g->adj[from]; }
        g->xadj[i] = start;
    }
    g->xadj[b] = to;
}

/* Work of the elimination order. */
SP__NOINLINE static void sp__system_carve_order(const sp_problem *pb, sp_arena *a)
{
    sp__order order;
    sp__order_carve(&order, pb->blocks, 2 * pb->contacts, 1, a);
}

/* Symbolic step in `a`, whose peak then covers it.     returns blocks of L below the diagonal, -1: does not fit */
SP__NOINLINE static int32_t sp__system_analyse(sp__system *w, const sp_problem *pb, sp_arena *a)
{
    w->pb = pb;
    sp__graph_carve(&w->graph, &w->L, pb, a);
    sp_arena rest = *a;
    sp__system_carve_order(pb, &rest);
    if (sp__failed(a) || sp__failed(&rest)) return -1;
    if (rest.peak > a->peak) a->peak = rest.peak;
    sp__system_graph(w);
    rest.used = a->used;
    for (int32_t k = 0; k < pb->blocks && pb->keep_order; k++) w->L.perm[k] = k;
    return pb->keep_order ? sp__bchol_count(&w->L, w->graph.xadj, w->graph.adj, w->graph.parent, w->graph.mark)
                       : sp__bchol_analyse(&w->L, w->graph.xadj, w->graph.adj, w->graph.parent, w->graph.mark, rest);
}

/* Bytes the symbolic step takes. */
SP__NOINLINE static size_t sp__system_scratch(const sp_problem *pb)
{
    sp__graph graph;
    sp__bchol L;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof(sp__reduction));
    sp__take(&dry, 1, sizeof(sp__system));
    sp__graph_carve(&graph, &L, pb, &dry);
    sp__system_carve_order(pb, &dry);
    return dry.peak;
}

/* Where a system ends that begins at `from`, with so many blocks below the diagonal: the symbolic step and the factor share the
 * space behind the graph. t is used up; t->reduction: in 3 rows. */
static size_t sp__system_end(sp__system *t, const sp_problem *pb, const sp_settings *set, sp__form form, int32_t nnz,
                             size_t from)
{
    sp_arena dry = sp__arena_dry();
    dry.used = from;
    sp__take(&dry, 1, sizeof *t);
    t->pb = pb;
    sp__graph_carve(&t->graph, &t->L, pb, &dry);
    sp_arena symbolic = dry;
    sp__system_carve_order(pb, &symbolic);
    sp__system_carve(t, pb, set, form, nnz, &dry);
    return dry.peak > symbolic.peak ? dry.peak : symbolic.peak;
}

/* Bytes of the whole system; reduction (may be NULL): and of one in 3 rows before it, behind *reduction, which takes more where
 * few blocks have many joints. */
static size_t sp__system_bytes(const sp_problem *pb, const sp_settings *set, sp__form form, sp__reduction *reduction,
                               sp_arena scratch)
{
    sp__system *w = sp__take(&scratch, 1, sizeof *w);
    const int32_t nnz = w ? sp__system_analyse(w, pb, &scratch) : -1;
    if (nnz < 0) return SIZE_MAX;
    w->reduction = NULL;
    const size_t whole = sp__system_end(w, pb, set, form, nnz, 0);
    w->reduction = reduction;
    const size_t less = reduction ? sp__system_end(w, pb, set, form, nnz, sizeof *reduction) : 0;
    return less > whole ? less : whole;
}

/* Bytes of a system in 6 rows. */
static size_t sp__system_need(const sp_problem *pb, const sp_settings *set, sp__form form, sp_arena scratch)
{
    return sp__system_bytes(pb, set, form, NULL, scratch);
}

/* Bytes of a system that may be reduced first. */
static size_t sp__system_need_reduced(const sp_problem *pb, const sp_settings *set, sp__form form, sp_arena scratch)
{
    sp__reduction *o = sp__take(&scratch, 1, sizeof *o);
    if (!o) return SIZE_MAX;
    if (sp__reduction_choose(pb, set, o)) return sp__system_bytes(pb, set, form, o, scratch);
    return sp__system_need(pb, set, form, scratch);
}

/* How often vertex v counts: 0 where its mirror image does for both, or where it takes no part. */
static sp_real sp__system_multiplicity(const sp__system *w, int32_t v)
{
    const sp__reduction *o = sp__reduced(w);
    return o ? (o->image[v] > v ? 2 : o->image[v] == v) : 1;
}

#endif

#endif /* SP__STATICS_SYSTEM_C */
