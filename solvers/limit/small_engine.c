/* small_engine: the smallest search as the engine that a limit asks */
#ifndef SP__LIMIT_SMALL_ENGINE_C
#define SP__LIMIT_SMALL_ENGINE_C

#include "../small/check.c"
#include "bracket.c"

#if SP__WITH_SMALL && SP__WITH_LIMIT

/* Joints have no strength: contacts without motion are all that resists. */
static int sp__bracket_resists(sp__bracket *b, sp_real lambda) { (void)b; (void)lambda; return 1; }

/* Does b->dq fall at lambda, and at every larger one, too? What moves in the best proof stays in b->dq, and in `all` (may be
 * NULL) as a result has it. */
SP__NOINLINE static int sp__bracket_falls(sp__bracket *b, sp_real lambda, int beyond, sp_real *all)
{
    if (!sp__bracket_certify_begin(b, 1, lambda)) return 0;
    b->least = sp__certify_mechanism(&b->certifier, b->dq, 0, &b->final);
    if (!(b->least > b->set.tol)) return 0;
    if (all) sp__motion_write(&b->certifier, all);
    memcpy(b->dq, b->certifier.dual.motion, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    return !beyond || sp__bracket_falls_beyond(b);
}

typedef struct sp__engine {
    sp__small w;
    sp_result at;                       /* of the search at hand */
} sp__engine;

/* Arrays of the engine; rows of the factor in `rows`, which is `a`, or scratch where `a` only counts.   returns 0: no memory */
static int sp__engine_carve(sp__engine *g, const sp_problem *pb, sp_arena *rows, sp_arena *a)
{
    g->at.dq = sp__take(a, (size_t)pb->scene->count.blocks, 6 * sizeof *g->at.dq);
    if (rows != a) sp__take(a, (size_t)pb->blocks, 6 * sizeof *g->w.row);
    return sp__small_carve(&g->w, pb, rows, a);
}

static void sp__engine_begin(sp__engine *g, const sp__bracket *b, const sp_arena *rest)
{
    g->w.pb = &b->pb;
    g->w.set = &b->set;
    g->w.to = &g->at;
    (void)rest;
    g->at.y0 = b->hint;
}

static int sp__engine_may_ask(const sp__engine *g, const sp__bracket *b) { (void)g; (void)b; return 1; }
static const sp_cost *sp__engine_cost(const sp__engine *g, const sp__bracket *b) { (void)b; return &g->at.spent.total; }

/* Multiple at which the largest dead and live loads are of one size. */
static sp_real sp__engine_reference(sp__bracket *b)
{
    sp__bracket_load(b, 1, 0);
    const sp_real dead = sp__load_unit(&b->pb);
    sp__bracket_load(b, 0, 1);
    return dead / sp__load_unit(&b->pb);
}

/* The search at d dead + l live.     returns its verdict; b->dq, or f, says it */
SP__NOINLINE static sp_verdict sp__engine_ask(sp__engine *g, sp__bracket *b, sp_real d, sp_real l, sp_real *f)
{
    sp_arena room = b->room;
    sp__bracket_load(b, d, l);
    g->at.verdict = SP_UNDECIDED;
    g->at.f = f;
    g->w.metric = 0;
    if (!b->pb.blocks) return SP_STABLE;
    sp__small_run(&g->w, &room);
    if (g->at.verdict == SP_UNSTABLE) sp__motion_read(&b->pb, g->at.dq, b->dq);
    b->imbalance = g->at.imbalance;
    return g->at.verdict;
}

/* The smallest search certifies its verdict itself. */
static int sp__engine_falls(sp__bracket *b, sp_real lambda, int *beyond)
{
    (void)lambda;
    *beyond = sp__bracket_falls_beyond(b);
    return 1;
}

/* Forces for large multiples are not made into those of live loads alone. */
static int sp__engine_unbounded(sp__bracket *b, sp_real *f, sp_real lambda, sp_real ref)
{
    (void)b; (void)f; (void)lambda; (void)ref;
    return 0;
}

#endif

#endif /* SP__LIMIT_SMALL_ENGINE_C */
