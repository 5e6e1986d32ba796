/* system: the dual D(y): its unknowns, weights and settings */
#ifndef SP__STATICS_SYSTEM_C
#define SP__STATICS_SYSTEM_C

#include "../linear/bchol.c"
#include "mirror.c"

#if SP__WITH_LARGE

/* The shortest force in the cones that balances p is f = S P_K(Aeq' y), where y minimises
 *
 *   D(y) = 1/2 sum S_v |P_K(u_v)|^2 + p . y,   u = Aeq' y         gradient Aeq f + p,  Hessian Aeq S DP_K(u) Aeq'
 *
 * convex, once differentiable, 6 unknowns a free block. f is admissible for every y; the imbalance is the only error. An
 * assembly that cannot stand has no minimiser: y runs off along the mechanism dq = -y.
 * Rows are weighted to unit size, forces counted in the largest load, so nothing depends on units. The penalty form adds
 * sum max(0, -u_n)^2 / (2 gamma) (tension at a price) and weighs friction by tau; with gamma finite it always has a minimiser.
 */

typedef enum sp__pass { SP__AIM, SP__REACH, SP__MOVE } sp__pass;

/* The interior-point method (section 19) has f = E x at a vertex, x in a cone that is its own dual. */
typedef struct sp__ipm {
    sp_real *x;                         /* 3 a vertex, or one an edge of its pyramid */
    sp_real force_scale;                /* force of x = e where S = 1 */
    sp_real theta, gap;                 /* what is left of the start's residuals; sum of x z */
    int outside;                        /* x or z is no longer inside, by rounding */
    sp__pass pass;                      /* right-hand side; step length; step */
    int corrected;                      /* the product of the predictor's changes is taken into account */
    const sp_real *along[3];            /* y; its predictor and its step */
    sp_real tau, kappa, mu, sigma;
    sp_real kappa_weight;               /* weight of the pair: tau kappa = kappa_weight mu */
    sp_real reach;                      /* step length */
    sp_real dtau, dkappa;
    int ray;                            /* forces are asked for the live loads alone */
} sp__ipm;

/* What a pass over the vertices of a contact works with. Twists are V and W of sp__dual_twist. */
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

typedef struct sp__dual {
    const sp_problem *pb;
    const sp_settings *set;
    sp__cone cone;
    sp__yield *yield;                   /* of the contact last asked for */
    sp__bchol L;                        /* factor of the Hessian + shift */
    sp_real *dense;                     /* or, not NULL, its dense factor */
#ifdef SP_REAL_MIXED
    sp_real *diagonal, *coupling;       /* the matrix: 21 a block as in L.d, 36 a contact */
    sp_real *scale;                     /* 6b: 1 / sqrt(its diagonal) */
    sp_real *cg;                        /* 24b: direction, its image, residual over the factor, residual */
#endif
    sp_real soft, slide;                /* 1/gamma (0: no tension), 1/sqrt(tau); the exact form has 0 and 1 */
    sp_real unit, load;                 /* force of one unit [N]; norm of the weighted load */
    sp_real factor;                     /* coefficient in force / mu */
    struct sp__flat *flat;              /* of a search in 3 rows a block, else NULL */
    struct sp__ipm *inner;              /* of the interior-point method */
    sp_real *x;                         /* 3 x points: its x for the true cone */
    int singular;                       /* the bilateral matrix has null vectors that the load has a part along */
    sp_real metric;                     /* 1 / largest sbar of a contact, or 0: S = 1 everywhere */
    int32_t *slot;                      /* per contact: its off-diagonal block in L; -1 - slot: transposed; INT32_MIN: none */
    sp_real *weight;                    /* 2b: of force and moment rows */
    sp_real *size;                      /* 2b: sbar and Sbar of the certificate check, in units */
    sp_real *y, *r, *d;                 /* 6b: potential, gradient, step */
    sp_real *carried;                   /* 3b: sum |f_v|, sum |x_v x f_v|, longest arm of the last forces; NULL: not asked for */
    sp__scratch *scratch;
    const sp_real *given;               /* 6 x points: D of every vertex, for SP__GIVEN */
    int32_t *xadj, *adj, *parent, *mark;/* graph of touching free blocks */
    sp_cost *cost;
    int64_t limit;                      /* flops that cost may reach */
    int spent;                          /* a piece of work did not fit; from then on none is done */
} sp__dual;

#ifdef SP_REAL_MIXED
#define SP__REFINE 40                   /* steps a solution of the factor is refined by, at most */
#endif

/* The reduction of a search in 3 rows a block, NULL where it has all 6; without SP__WITH_PLAN the compiler knows that, and all
 * that stands under it is gone. */
static const sp__flat *sp__reduced(const sp__dual *w) { return SP__WITH_PLAN ? w->flat : NULL; }

static sp__visit *sp__visit_of(const sp__dual *w) { return &w->scratch->of.visit; }

static void sp__dual_carve_graph(sp__dual *w, const sp_problem *pb, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    w->pb = pb;
    sp__bchol_carve_pattern(&w->L, pb->blocks, a);
    w->xadj = sp__take(a, b + 1, sizeof *w->xadj);
    w->adj = sp__take(a, (size_t)pb->contacts, 2 * sizeof *w->adj);
    w->parent = sp__take(a, b, sizeof *w->parent);
    w->mark = sp__take(a, b, sizeof *w->mark);
}

static void sp__dual_carve(sp__dual *w, const sp_problem *pb, int32_t faces, int32_t nnz, int dense, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks, c = (size_t)pb->contacts;
    w->dense = dense ? sp__take(a, 3 * b, (6 * b + 1) * sizeof *w->dense) : NULL;
    sp__cone_carve(&w->cone, faces, a);
    w->yield = sp__take(a, 1, sizeof *w->yield);
    w->slot = sp__take(a, c, sizeof *w->slot);
    w->weight = sp__take(a, b, 2 * sizeof *w->weight);
    w->size = sp__take(a, b, 2 * sizeof *w->size);
    w->y = sp__take(a, b, 6 * sizeof *w->y);
    w->r = sp__take(a, b, 6 * sizeof *w->r);
    w->d = sp__take(a, b, 6 * sizeof *w->d);
    w->scratch = sp__take(a, 1, sizeof *w->scratch);
    if (sp__reduced(w)) {
        w->L.rows = 3;
        w->flat->mate = sp__take(a, (size_t)pb->points, sizeof *w->flat->mate);
        w->flat->g = sp__take(a, c, SP__FLAT_G * sizeof *w->flat->g);
    }
    sp__bchol_carve_values(&w->L, nnz, a);
#ifdef SP_REAL_MIXED
    w->diagonal = sp__take(a, b, 21 * sizeof *w->diagonal);
    w->coupling = sp__take(a, c, 36 * sizeof *w->coupling);
    w->scale = sp__take(a, b, 6 * sizeof *w->scale);
    w->cg = sp__take(a, b, 24 * sizeof *w->cg);
#endif
    if (!SP__WITH_INTERIOR) return;
    w->inner = sp__take(a, 1, sizeof *w->inner);
    w->x = sp__take(a, faces ? 0 : (size_t)pb->points, 3 * sizeof *w->x);
}

/* Neighbours of every free block, each once. */
SP__NOINLINE static void sp__dual_graph(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    const int32_t b = pb->blocks;
    for (int32_t i = 0; i <= b; i++) w->xadj[i] = 0;
    for (int32_t c = 0; c < pb->contacts; c++)
        if (pb->contact[c].a >= 0 && pb->contact[c].b >= 0) {
            w->xadj[pb->contact[c].a + 1]++;
            w->xadj[pb->contact[c].b + 1]++;
        }
    for (int32_t i = 0; i < b; i++) { w->xadj[i + 1] += w->xadj[i]; w->mark[i] = w->xadj[i]; }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int32_t i = pb->contact[c].a, k = pb->contact[c].b;
        if (i < 0 || k < 0) continue;
        w->adj[w->mark[i]++] = k;
        w->adj[w->mark[k]++] = i;
    }
    for (int32_t i = 0; i < b; i++) w->mark[i] = -1;
    int32_t to = 0, from = 0;                           /* repeated neighbours go: two joints between one pair */
    for (int32_t i = 0; i < b; i++) {
        const int32_t end = w->xadj[i + 1], start = to;
        for (; from < end; from++)
            if (w->mark[w->adj[from]] != i) { w->mark[w->adj[from]] = i; w->adj[to++] = w->adj[from]; }
        w->xadj[i] = start;
    }
    w->xadj[b] = to;
}

SP__NOINLINE static void sp__dual_carve_order(const sp_problem *pb, sp_arena *a)
{
    sp__order order;
    sp__order_carve(&order, pb->blocks, 2 * pb->contacts, a);
}

/* Symbolic step in `a`, whose peak then covers it.     returns blocks of L below the diagonal, -1: does not fit */
SP__NOINLINE static int32_t sp__dual_analyse(sp__dual *w, const sp_problem *pb, sp_arena *a)
{
    sp__dual_carve_graph(w, pb, a);
    sp_arena rest = *a;
    sp__dual_carve_order(pb, &rest);
    if (sp__failed(a) || sp__failed(&rest)) return -1;
    if (rest.peak > a->peak) a->peak = rest.peak;
    sp__dual_graph(w);
    rest.used = a->used;
    for (int32_t k = 0; k < pb->blocks && pb->keep_order; k++) w->L.perm[k] = k;
    return pb->keep_order ? sp__bchol_count(&w->L, w->xadj, w->adj, w->parent, w->mark)
                       : sp__bchol_analyse(&w->L, w->xadj, w->adj, w->parent, w->mark, rest);
}

/* Bytes the symbolic step takes. */
SP__NOINLINE static size_t sp__dual_scratch(const sp_problem *pb)
{
    sp__dual w;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof(sp__flat));
    sp__take(&dry, 1, sizeof w);
    sp__dual_carve_graph(&w, pb, &dry);
    sp__dual_carve_order(pb, &dry);
    return dry.peak;
}

/* Where a dual ends that begins at `from`, with so many blocks below the diagonal and rays a vertex: the symbolic step and the
 * factor share the space behind the graph. t is used up; t->flat: in 3 rows. */
static size_t sp__dual_end(sp__dual *t, const sp_problem *pb, const sp_settings *set, int dense, size_t rays, int32_t nnz, size_t from)
{
    sp_arena dry = sp__arena_dry();
    dry.used = from;
    sp__take(&dry, 1, sizeof *t);
    sp__dual_carve_graph(t, pb, &dry);
    sp_arena symbolic = dry;
    sp__dual_carve_order(pb, &symbolic);
    sp__dual_carve(t, pb, set->faces, nnz, dense, &dry);
    if (rays) sp__take(&dry, (size_t)pb->points, rays * sizeof *t->y);
    return dry.peak > symbolic.peak ? dry.peak : symbolic.peak;
}

/* Bytes of the whole dual; flat (may be NULL): and of one in 3 rows before it, behind *flat, which takes more where few blocks
 * have many joints. */
static size_t sp__dual_most(const sp_problem *pb, const sp_settings *set, int dense, size_t rays, sp__flat *flat, sp_arena scratch)
{
    sp__dual *w = sp__take(&scratch, 1, sizeof *w);
    const int32_t nnz = w ? sp__dual_analyse(w, pb, &scratch) : -1;
    if (nnz < 0) return SIZE_MAX;
    w->flat = NULL;
    const size_t whole = sp__dual_end(w, pb, set, dense, rays, nnz, 0);
    w->flat = flat;
    const size_t less = flat ? sp__dual_end(w, pb, set, dense, rays, nnz, sizeof *flat) : 0;
    return less > whole ? less : whole;
}

static size_t sp__dual_need(const sp_problem *pb, const sp_settings *set, int dense, size_t rays, sp_arena scratch)
{
    return sp__dual_most(pb, set, dense, rays, NULL, scratch);
}

/* The same of a search that may be in 3 rows first. */
static size_t sp__flat_need(const sp_problem *pb, const sp_settings *set, size_t rays, sp_arena scratch)
{
    sp__flat *o = sp__take(&scratch, 1, sizeof *o);
    if (!o) return SIZE_MAX;
    if (sp__flat_choose(pb, set, o)) return sp__dual_most(pb, set, 0, rays, o, scratch);
    return sp__dual_need(pb, set, 0, rays, scratch);
}

/* How often vertex v counts: 0 where its mirror image does for both, or where it takes no part. */
static sp_real sp__dual_counts(const sp__dual *w, int32_t v)
{
    const sp__flat *o = sp__reduced(w);
    return o ? (o->mate[v] > v ? 2 : o->mate[v] == v) : 1;
}

#endif

#endif /* SP__STATICS_SYSTEM_C */
