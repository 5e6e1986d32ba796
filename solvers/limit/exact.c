/* exact: does dead + lambda live stand? The exact stage as the engine that the bracket of a limit asks. */
#ifndef SP__LIMIT_EXACT_C
#define SP__LIMIT_EXACT_C

#include "../check/ladder.c"
#include "falls.c"

#if SP__WITH_INTERIOR

/* What the interior points of a limit keep [interior.c]. */
typedef struct sp__homogeneous {
    sp__ipm m;
    sp_real l, s, dl, ds;
    sp_real along[2];                   /* a step is its free part and these multiples of Vq and Vp */
    sp_real left;                       /* of the way, that the predictor does not get */
    sp_real pl, pt;                     /* products of changes that are aimed at, of l s and tau kappa */
    sp_real before[5];                  /* reach, dl, ds, dtau, dkappa of the step before a corrector */
} sp__homogeneous;

/* The exact stage as the engine that a limit asks, and the dual with the live loads in it [interior.c, strong.c]. */
typedef struct sp__engine {
    sp_state state;
    sp__newton n;
    sp__system *w;
    sp_arena rest;                      /* for its search */
    sp__reduction *reduction;           /* NULL: in 6 rows a block */
    sp_real *q, *Vq, *Vp;               /* 6b: weighted live load, M^-1 q, M^-1 p' */
    sp_real G[3];                       /* q.Vq, q.Vp, p'.Vp */
    sp_real at;                         /* a: the loads at hand are dead + a live, live loads in ref */
    int32_t most;                       /* factorisations of a question, at most */
    sp__homogeneous h;
} sp__engine;

/* Arrays of the engine; `rows` is for the small engine only.       returns 0: no memory */
static int sp__engine_carve(sp__engine *g, const sp_problem *pb, sp_arena *rows, sp_arena *a)
{
    const size_t blocks = (size_t)pb->blocks;
    (void)rows;
    g->state.y = sp__take(a, blocks, 6 * sizeof *g->state.y);
    g->state.dq = sp__take(a, blocks, 6 * sizeof *g->state.dq);
    g->q = sp__take(a, blocks, 6 * sizeof *g->q);
    g->Vq = sp__take(a, blocks, 6 * sizeof *g->Vq);
    g->Vp = sp__take(a, blocks, 6 * sizeof *g->Vp);
    return 1;
}

/* A fresh start of the search, with all its iterations. */
static void sp__engine_begin(sp__engine *g, const sp__bracket *b, const sp_arena *rest)
{
    memset(g->state.y, 0, 6 * (size_t)b->pb.blocks * sizeof *g->state.y);
    g->n.goal = b->set.tol / 4;
    g->state.brief = 1;
    g->rest = *rest;
    g->most = b->set.iterations;
    g->n.left = (sp__problem_strong(&b->pb) ? 4 : 1) * g->most;
}

static const sp_cost *sp__engine_cost(const sp__engine *g, const sp__bracket *b) { (void)g; return &b->cost; }

/* Flops that are left to the search: the certificate check of both ends needs some, too. */
static int64_t sp__engine_flops(const sp__bracket *b)
{
    return b->limit - b->cost.flops - 80 * SP__FLOPS_CERTIFICATE * (int64_t)b->pb.points;
}

/* May the engine be asked again? */
static int sp__engine_may_ask(const sp__engine *g, const sp__bracket *b) { return g->n.left > 0 && sp__engine_flops(b) > 0; }

/* About the multiple at which live loads are of the size of dead ones, over all contacts; moments by their arms. */
static sp_real sp__engine_reference(sp__bracket *b)
{
    sp_real sum[2] = { 0, 0 };
    for (int32_t c = 0; c < b->pb.contacts; c++)
        for (int side = 0; side < 2; side++) {
            const sp_contact *t = &b->pb.contact[c];
            const int32_t i = side ? t->b : t->a;
            const sp_real arm = sp__norm3(side ? t->rb : t->ra);
            for (int k = 0; k < 2 && i >= 0; k++) {
                const sp_real *p = (k ? b->live : b->dead) + 6 * (size_t)i;
                sum[k] += sp__norm3(p) + (arm > 0 ? sp__norm3(p + 3) / arm : 0);
            }
        }
    const sp_real ref = sp__ratio(sum[0], sum[1]);
    return ref > 0 && ref < SP__HUGE ? ref : 1;
}

/* The exact stage under the loads at hand, first in 3 rows where they let it. */
SP__NOINLINE static sp_status sp__engine_stage(sp__engine *g, sp__bracket *b, sp_arena room, sp_verdict *claim)
{
    sp_arena again = room;
    sp__reduction *o = sp__take(&again, 1, sizeof *o);
    if (!o) return SP_E_MEMORY;
    if (sp__reduction_choose(&b->pb, &b->wide, o)) {    /* with as many iterations as were asked for */
        const sp_status status = sp__exact_search(&b->pb, &b->set, o, &g->state, &again, claim);
        if (status || *claim == SP_STABLE || (*claim == SP_UNSTABLE && (o->mode == SP__PLANE || o->forest))) return status;
        *claim = SP_UNDECIDED;
    }
    return sp__exact_run(&b->pb, &b->set, &g->state, &room, claim);
}

/* The gates, before the exact stage, under the loads at hand; forces go to f. */
SP__NOINLINE static sp_status sp__engine_gates(sp__engine *g, sp__bracket *b, sp_real *f, sp_verdict *claim)
{
    sp_arena room = g->rest;
    b->set.iterations = g->n.left < g->most ? g->n.left : g->most;
    g->state.f = f;
    memset(f, 0, 3 * (size_t)b->pb.points * sizeof *f);
    g->state.y0 = b->hint;
    memset(&g->state.cost, 0, sizeof g->state.cost);
    g->state.left = sp__engine_flops(b);
    if (g->state.left <= 0) { b->spent = 1; return SP_OK; }
    return sp__gates_run(&b->pb, &b->set, &g->state, &room, claim);
}

/* Gates and the exact stage at d dead + l live.     returns STABLE where f carries it for certain, UNSTABLE where
 * b->dq is said to fall */
SP__NOINLINE static sp_verdict sp__engine_ask(sp__engine *g, sp__bracket *b, sp_real d, sp_real l, sp_real *f)
{
    sp_verdict claim = SP_UNDECIDED;
    sp__bracket_load(b, d, l);
    sp_status status = sp__engine_gates(g, b, f, &claim);
    if (g->state.left <= 0) return SP_UNDECIDED;
    if (!status && !claim) status = sp__engine_stage(g, b, g->rest, &claim);
    g->n.left -= g->state.cost.factorisations;
    sp__cost_add(&b->cost, &g->state.cost);
    b->lacking |= status == SP_E_MEMORY;
    if (status) claim = SP_UNDECIDED;
    if (!claim && b->set.budget > 0 && g->state.reason == SP_REASON_BUDGET) b->spent = 1;
    if (claim == SP_UNSTABLE) memcpy(b->dq, g->state.dq, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    if (claim == SP_STABLE && !sp__bracket_stands(b, d, l, f, f)) return SP_UNDECIDED;
    return claim;
}

/* As a check asks: with all iterations, no way given up early, in 3 rows or in `all`.      returns 1: f carries dead + l live,
 * whatever was claimed; else b->dq is what may fall */
SP__NOINLINE static int sp__engine_check(sp__engine *g, sp__bracket *b, sp_real l, int all, sp_real *f)
{
    sp_verdict claim = SP_UNDECIDED;
    sp_arena room = g->rest;
    memset(b->dq, 0, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    sp__bracket_load(b, 1, l);
    g->n.left = g->most = b->wide.iterations;
    sp_status status = sp__engine_gates(g, b, f, &claim);
    if (status || g->state.left <= 0) return 0;
    g->state.brief = 0;
    sp__reduction *o = claim || all ? NULL : sp__take(&room, 1, sizeof *o);
    if (!claim && all) status = sp__exact_run(&b->pb, &b->set, &g->state, &room, &claim);
    else if (o && sp__reduction_choose(&b->pb, &b->wide, o))
        status = sp__exact_search(&b->pb, &b->set, o, &g->state, &room, &claim);
    else if (!claim) return 0;
    sp__cost_add(&b->cost, &g->state.cost);
    b->lacking |= status == SP_E_MEMORY;
    if (status) return 0;
    memcpy(b->dq, g->state.dq, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    if (claim == SP_UNSTABLE) return 0;
    if (sp__bracket_stands(b, 1, l, f, f)) return 1;
    sp__drop_tiny_forces(f, b->pb.points, (sp_real)1e-6);
    return sp__bracket_stands(b, 1, l, f, f);
}

/* Does the motion that the engine claims to fall at lambda pass the certificate check?
 *   *beyond: and at every larger multiple */
static int sp__engine_falls(sp__bracket *b, sp_real lambda, int *beyond)
{
    *beyond = sp__bracket_falls(b, lambda, 1, NULL);
    return *beyond || sp__bracket_falls(b, lambda, 0, NULL);
}

/* Forces f carry a large multiple lambda, so dead loads have a small share in them, ref / lambda. Do they balance live loads
 * alone once what is much less than those is dropped?     returns 1: f does */
SP__NOINLINE static int sp__engine_unbounded(sp__bracket *b, sp_real *f, sp_real lambda, sp_real ref)
{
    sp__drop_tiny_forces(f, b->pb.points, SP_SQRT(ref / lambda));
    for (size_t k = 0; k < 3 * (size_t)b->pb.points; k++) f[k] /= lambda;
    return sp__bracket_stands(b, 0, 1, f, f);
}

#endif

#endif /* SP__LIMIT_EXACT_C */
