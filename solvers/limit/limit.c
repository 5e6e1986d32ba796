/* limit: sp_limit: both ends, what they say, and from where on it stands */
#ifndef SP__LIMIT_LIMIT_C
#define SP__LIMIT_LIMIT_C

#include "start.c"

#if SP__WITH_INTERIOR

#define SP__LIMIT_SLACK ((sp_real)0.01) /* what tol adds to a motion's balance may widen it by no more, in ref */

/* The upper end: the least multiple that the motion at hand proves, or that of the engine there.     returns 0: none */
SP__NOINLINE static int sp__limit_upper(sp__limit *L, sp_arena room)
{
    sp_limit_result *r = &L->r;
    sp_real slack = sp__max(L->slack, L->bracket.set.tol * (1 + sp__abs(L->best))) * (sp_real)1.5;
    for (int it = 0; it < 8; it++, slack *= 2) {
        const sp_real lambda = L->none ? 0 : sp__max(0, L->best + slack) * L->ref;
        if (it == 2 && !L->none) sp__limit_ask(L, 1, L->best + slack, r->ray, room);
        if (!sp__bracket_falls(&L->bracket, lambda, 1, r->dq, L->room)) continue;
        if (L->bracket.least < (sp_real)1.1 * L->bracket.set.tol) {   /* a marginal proof: again, as the result will hold it */
            sp__verify_motion(&L->bracket.pb, r->dq, L->bracket.dq);
            if (!sp__bracket_falls(&L->bracket, lambda, 1, NULL, L->room)) continue;
        }
        r->upper = lambda;
        r->least_imbalance = L->bracket.least;
        r->final = L->bracket.final;
        return 1;
    }
    return 0;
}

/* What both ends say. */
static void sp__limit_conclude(sp__limit *L)
{
    sp_limit_result *r = &L->r;
    const sp_real slack = L->slack < SP__LIMIT_SLACK ? L->slack : SP__LIMIT_SLACK;
    const sp_real wide = SP__LIMIT_WIDE * r->tol * (sp__abs(r->lower) + L->ref) + 4 * slack * L->ref;
    const int never = L->none || (r->lower < 0 && !(r->upper > 0));
    if (never) r->kind = r->upper < 0 ? SP_LIMIT_UNDECIDED : SP_LIMIT_NONE;
    else if (r->kind == SP_LIMIT_UNBOUNDED) r->kind = r->lower < 0 ? SP_LIMIT_UNDECIDED : SP_LIMIT_UNBOUNDED;
    else if (r->lower >= 0 && r->upper >= r->lower && r->upper - r->lower <= wide) r->kind = SP_LIMIT_FOUND;
    const int spent = L->bracket.spent || !sp__engine_left(&L->engine, &L->bracket);
    r->reason = r->kind ? SP_REASON_FORCES : spent ? SP_REASON_BUDGET : SP_REASON_LIMIT;
    if (r->kind != SP_LIMIT_FOUND) return;
    const sp_real balance = sp__limit_balance(L) * L->ref;
    if (balance >= 0 && balance < r->lower && sp__bracket_stands(&L->bracket, 1, balance, r->f, NULL, L->room)) {
        r->lower = balance;                             /* within tol the same forces carry less, too */
        r->imbalance = L->bracket.imbalance;
    }
    r->multiplier = balance < r->lower ? r->lower : balance > r->upper ? r->upper : balance;
    r->within = sp__bracket_within(r, balance);
}

/* Does it stand under the dead loads alone? If not, from which multiple on? Each collapse that live loads hinder gives a larger
 * lower bound of that multiple, by Newton's method on the least imbalance. */
SP__NOINLINE static void sp__limit_lowest(sp__limit *L, sp_arena room)
{
    sp__bracket *b = &L->bracket;
    sp_limit_result *r = &L->r;
    sp_real a = 0;
    r->lowest = r->lower;
    if (r->kind == SP_LIMIT_NONE) r->dead = SP_UNSTABLE;
    else if (!(r->lower > 0) && r->lower >= 0) r->dead = SP_STABLE;
    if (r->dead == SP_STABLE) r->lowest = 0;
    for (int it = 0; it < 12 && r->lowest > a * L->ref && sp__engine_left(&L->engine, b); it++) {
        const sp_real last = a;
        const sp_verdict claim = sp__limit_ask(L, 1, a, L->f, room);
        if (claim == SP_STABLE && sp__bracket_stands(b, 1, a * L->ref, L->f, NULL, L->room)) {
            r->lowest = a * L->ref;
            if (!it) r->dead = SP_STABLE;
            if (r->kind != SP_LIMIT_UNBOUNDED) return;
            r->lower = r->lowest;                       /* every multiple from there on */
            r->imbalance = b->imbalance;
            memcpy(r->f, L->f, 3 * (size_t)b->pb.points * sizeof *r->f);
            return;
        }
        if (claim == SP_UNSTABLE && sp__bracket_falls(b, a * L->ref, 0, NULL, L->room)) {
            r->dead = SP_UNSTABLE;
            a = sp__limit_balance(L) + SP__LIMIT_STEP * b->set.tol * (1 + a);
        } else if (!it) return;
        if (!(a > last)) a = (last + r->lowest / L->ref) / 2;
    }
}

/* Search, then both ends; `a` is used up. */
SP__NOINLINE static sp_status sp__limit_decide(sp__limit *L, sp_arena *a)
{
    sp__bracket *b = &L->bracket;
    sp_arena rest = *a;
    int done = 0, live = 0;
    for (size_t k = 0; k < 6 * (size_t)b->pb.blocks; k++) live |= b->live[k] < 0 || b->live[k] > 0;
    if (!live) L->r.kind = SP_LIMIT_UNBOUNDED;                  /* does it stand at all? */
    else {
        const sp_status status = sp__limit_start(L, a, &done);
        if (status) return status;
    }
    if (!done && !L->none) sp__limit_newton(L, rest);
    if (L->none || (L->r.kind != SP_LIMIT_UNBOUNDED && L->best < SP__HUGE)) sp__limit_upper(L, rest);
    sp__limit_conclude(L);
    sp__limit_lowest(L, rest);
    if (L->r.upper < 0) memset(L->r.dq, 0, 6 * (size_t)b->scene.count.blocks * sizeof *L->r.dq);
    if (L->r.kind != SP_LIMIT_UNBOUNDED) memset(L->r.ray, 0, 3 * (size_t)b->pb.points * sizeof *L->r.ray);
    return SP_OK;
}

typedef struct sp__limit_kept { sp_real *f, *ray, *dq, *y0; } sp__limit_kept;

static void sp__limit_carve_kept(sp__limit_kept *r, const sp_scene *scene, int32_t blocks, sp_arena *a)
{
    r->f = sp__take(a, (size_t)scene->count.points, 3 * sizeof *r->f);
    r->ray = sp__take(a, (size_t)scene->count.points, 3 * sizeof *r->ray);
    r->dq = sp__take(a, (size_t)scene->count.blocks, 6 * sizeof *r->dq);
    r->y0 = sp__take(a, (size_t)blocks, 24 * sizeof *r->y0);
}

static void sp__limit_carve(sp__limit *L, const sp_scene *scene, int32_t blocks, sp_arena *a)
{
    L->f = sp__take(a, (size_t)scene->count.points, 3 * sizeof *L->f);
    L->upper = sp__take(a, (size_t)blocks, 6 * sizeof *L->upper);
    L->lower = sp__take(a, (size_t)blocks, 6 * sizeof *L->lower);
    sp__engine_carve(&L->engine, blocks, a);
}

static size_t sp__limit_scratch(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp__problem_count(scene, &pb);
    return sizeof(sp__limit) + SP_ALIGN + sp__limit_verify_memory(scene) + SP_ALIGN + sp__system_scratch(&pb);
}

static sp_status sp__limit_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__limit *L = sp__take(&scratch, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    const sp_status status = sp__bracket_build(scene, settings, &L->bracket, &scratch);
    if (status) return status;
    const sp_problem *pb = &L->bracket.pb;
    sp__limit_kept kept;
    sp_arena dry = sp__arena_dry();
    sp__limit_carve_kept(&kept, scene, pb->blocks, &dry);
    sp__take(&dry, 1, sizeof *L);
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp_real *at[5];
    sp__bracket_carve(at, pb->blocks, &dry);
    sp__limit_carve(L, scene, pb->blocks, &dry);
    sp__take(&dry, 1, sp__certificate_need(pb, &L->bracket.set));
    if (!sp__limit_start_need(L, scratch, &dry)) return SP_E_MEMORY;
    *bytes = dry.used;
    return SP_OK;
}

/* Everything of a limit in arena `a`.     *limit: where the result is found on SP_OK; *kept: end of its arrays */
SP__NOINLINE static sp_status sp__limit_build(const sp_scene *scene, const sp_settings *settings, sp_arena *a, sp__limit **limit,
                                           size_t *kept)
{
    sp_problem count;
    sp__limit_kept arrays;
    sp__problem_count(scene, &count);
    sp__limit_carve_kept(&arrays, scene, count.blocks, a);
    *kept = a->used;
    sp__limit *L = sp__take(a, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    memset(L, 0, sizeof *L);
    const sp_status status = sp__bracket_build(scene, settings, &L->bracket, a);
    if (status) return status;
    sp__limit_carve(L, scene, count.blocks, a);
    const size_t need = sp__certificate_need(&L->bracket.pb, &L->bracket.set);
    L->room.base = sp__take(a, 1, need);
    L->room.cap = need ? need : 1;                      /* 0 would mean that something did not fit */
    if (sp__failed(a)) return SP_E_MEMORY;
    sp_limit_result *r = &L->r;
    r->f = arrays.f; r->ray = arrays.ray; r->dq = arrays.dq; r->y0 = arrays.y0;
    memset(r->f, 0, 3 * (size_t)scene->count.points * sizeof *r->f);
    memset(r->ray, 0, 3 * (size_t)scene->count.points * sizeof *r->ray);
    memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    memset(r->y0, 0, 24 * (size_t)count.blocks * sizeof *r->y0);
    memset(L->engine.state.y, 0, 6 * (size_t)count.blocks * sizeof *L->engine.state.y);
    r->lower = r->upper = r->lowest = -1;
    r->tol = L->bracket.set.tol;
    r->force_bound = L->bracket.set.force_bound;
    L->engine.n.goal = r->tol / 4;
    L->engine.n.left = (sp__problem_strong(&L->bracket.pb) ? 2 : 1) * L->bracket.set.iterations;
    L->best = SP__HUGE;
    L->ref = sp__engine_reference(&L->bracket);
    *limit = L;
    return SP_OK;
}

SP_API sp_status sp_limit(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_limit_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__limit *L = NULL;
    size_t kept = 0;
    sp_arena a = *arena;
    sp_status status = sp__limit_build(scene, settings, &a, &L, &kept);
    if (!status) status = sp__limit_decide(L, &a);
    if (status) return status;
    L->r.verified = L->r.kind != SP_LIMIT_UNDECIDED && sp__bracket_holds(&L->bracket, &L->r, L->room);
    if (L->r.kind && !L->r.verified) L->r.reason = L->bracket.spent ? SP_REASON_BUDGET : SP_REASON_UNVERIFIED;
    if (!L->r.verified) L->r.kind = SP_LIMIT_UNDECIDED;
    L->r.cost = L->bracket.cost;
    L->r.peak_bytes = a.peak;
    arena->used = kept;
    arena->peak = a.peak;
    *result = L->r;
    return SP_OK;
}

#endif

#endif /* SP__LIMIT_LIMIT_C */
