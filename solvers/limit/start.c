/* start: first values of both ends: interior points for joints of friction,
 * climb on the dual (strong.c) for joints with strength. */
#ifndef SP__LIMIT_START_C
#define SP__LIMIT_START_C

#include "strong.c"

#if SP__WITH_INTERIOR

/* engine.reduction, the last thing taken from `a`, where one mirror is that of joints, dead and live loads. The loads at hand
 * are those of about the size both have at work. */
static void sp__limit_reduction(sp__limit *L, sp_arena *a)
{
    sp__engine *g = &L->engine;
    sp__bracket *b = &L->bracket;
    g->reduction = NULL;
    const size_t start = a->used;
    sp__reduction *o = SP__WITH_REDUCTION ? sp__take(a, 1, sizeof *o) : NULL;
    int planar = o != NULL;
    for (int k = 0; k < 3 && planar; k++) {             /* both, dead, live */
        sp__bracket_load(b, k != 2, k != 1 ? L->ref : 0);
        planar = k ? sp__mirror_loads(&b->pb, &b->set, o->e[2], 0)
               : sp__reduction_choose(&b->pb, &b->set, o) && o->mode == SP__PLANE;
    }
    if (planar) g->reduction = o;
    else if (o) a->used = start;
    sp__bracket_load(b, 1, L->ref);
}

/* The dual at that load, its sizes and metric; hints for both loads. */
SP__NOINLINE static sp_status sp__limit_open(sp__limit *L, sp_arena *a)
{
    sp__engine *g = &L->engine;
    sp__bracket *b = &L->bracket;
    const size_t n = 6 * (size_t)b->pb.blocks;
    sp_real *y0[2] = { L->r.y0, L->r.y0 + 2 * n };
    sp__limit_reduction(L, a);
    g->w = sp__system_make(&b->pb, &b->set, SP__LIMIT, g->reduction, &b->cost, a);
    if (!g->w) return SP_E_MEMORY;
    g->w->budget.limit = sp__engine_flops(b) + b->cost.flops;
    g->h.m.x = g->w->x;
    g->h.m.capped = NULL;
    for (int k = 0; k < 2; k++) {
        sp__bracket_load(b, k ? 0 : 1, k ? L->ref : 0);
        if (k) sp__bilateral_solve(g->w); else sp__system_bilateral(g->w);
        if (g->w->budget.spent) return SP_OK;
        g->state.y0 = y0[k];
        sp__bilateral_write_y0(g->w, &g->state);
    }
    for (size_t k = 0; k < 2 * n; k++) y0[1][k] /= L->ref;
    b->y0 = L->r.y0;
    sp__limit_loads_sized(L, 1);
    sp__limit_sizes(L);
    if (sp__system_metric(g->w)) sp__system_weights(g->w);
    sp__bracket_load(b, 0, L->ref);
    sp__system_load(g->w, g->q);
    return SP_OK;
}

/* Interior points and what they leave: the best motion sharpened.     returns 1: both ends are near, or nothing stands */
SP__NOINLINE static int sp__limit_search(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__bracket *b = &L->bracket;
    int done = !g->w->budget.spent && sp__interior_run(L);
    if (L->r.kind == SP_LIMIT_UNBOUNDED) return L->r.lower >= 0;
    if (!g->w->budget.spent && !(done && L->none) && L->best < SP__HUGE) sp__limit_sharpen(L);
    if (L->none && !done) done = L->none = sp__bracket_falls(b, 0, 1, NULL);
    b->spent |= g->w->budget.spent;
    return done || sp__limit_ends_meet(L, SP__LIMIT_WIDE * L->r.tol);
}

/* Does it stand under the dead loads alone? Or fall, whatever the live ones do: L->none.
 *     returns 1: it is known, and some multiple may stand, so that there is something to climb to */
SP__NOINLINE static int sp__strong_check_dead(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__bracket *b = &L->bracket;
    const size_t bytes = 6 * (size_t)b->pb.blocks * sizeof *b->dq;
    memcpy(g->Vp, b->dq, bytes);
    const sp_verdict claim = sp__limit_ask(L, 1, 0, L->r.f);
    L->none = claim == SP_UNSTABLE && sp__bracket_falls(b, 0, 1, NULL);
    if (claim == SP_UNSTABLE && (L->none || sp__bracket_falls(b, 0, 0, NULL))) L->r.dead = SP_UNSTABLE;
    if (!L->none) memcpy(b->dq, g->Vp, bytes);
    if (claim != SP_STABLE) return !L->none && L->r.dead == SP_UNSTABLE;
    L->r.lower = 0;
    L->r.imbalance = b->imbalance;
    L->r.dead = SP_STABLE;
    return 1;
}

/* Both ends as near as interior points bring them, or Newton's method with the multiplier in it where joints have strength; an
 * upper one from live loads alone.         *done: both are near, or nothing stands.    `a` is used up */
SP__NOINLINE static sp_status sp__limit_start(sp__limit *L, sp_arena *a, int *done)
{
    const sp__bracket *b = &L->bracket;
    const int strong = sp__problem_strong(&b->pb);
    int live = 0;
    for (size_t k = 0; k < 6 * (size_t)b->pb.blocks; k++) live |= b->live[k] < 0 || b->live[k] > 0;
    if (!live) { L->r.kind = SP_LIMIT_UNBOUNDED; return SP_OK; }        /* does it stand at all? */
    if (!strong) {
        const sp_status status = sp__limit_open(L, a);
        if (status) return status;
        *done = sp__limit_search(L);
        if (*done) return SP_OK;
    }
    L->none = 0;
    if (L->r.kind != SP_LIMIT_UNBOUNDED && !(L->best < SP__HUGE)) sp__limit_live_alone(L);
    if (!strong || L->r.kind == SP_LIMIT_UNBOUNDED) return SP_OK;
    const int climbs = sp__strong_check_dead(L) && L->best >= 0;
    if (L->engine.most > SP__STRONG_ASK) L->engine.most = SP__STRONG_ASK;
    if (!climbs) return SP_OK;
    const sp_real best = L->best, slack = L->slack;
    memcpy(L->upper, b->dq, 6 * (size_t)b->pb.blocks * sizeof *L->upper);
    const sp_status status = sp__limit_open(L, a);
    if (status) return status;
    *done = sp__strong_run(L);
    L->bracket.spent |= L->engine.w->budget.spent;
    if (!L->none) return SP_OK;
    *done = L->none = sp__bracket_falls(&L->bracket, 0, 1, NULL);   /* said of a motion of the climb */
    if (L->none) return SP_OK;
    L->best = best;                                     /* not for certain: back to that of live loads alone */
    L->slack = slack;
    memcpy(L->bracket.dq, L->upper, 6 * (size_t)b->pb.blocks * sizeof *L->upper);
    return SP_OK;
}

static size_t sp__limit_start_scratch(const sp_problem *pb) { return sp__system_scratch(pb); }

/* Memory of these starts: two searches, one after the other, of the loads at hand.       returns 0: no memory */
static int sp__limit_start_need(sp__limit *L, sp_arena scratch, sp_arena *dry)
{
    const sp_problem *pb = &L->bracket.pb;
    L->ref = sp__engine_reference(&L->bracket);
    sp__limit_reduction(L, &scratch);
    sp__reduction *reduction = L->engine.reduction;
    if (SP__WITH_REDUCTION && !reduction) reduction = sp__take(&scratch, 1, sizeof *reduction);  /* other loads may have one */
    const size_t search = pb->blocks ? sp__system_bytes(pb, &L->bracket.set, SP__LIMIT, reduction, scratch)
                        : sizeof(int32_t);              /* of the gates */
    if (search == SIZE_MAX) return 0;
    sp__take(dry, 1, search);
    return 1;
}

#endif

#endif /* SP__LIMIT_START_C */
