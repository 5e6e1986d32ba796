/* limit: sp_limit: the bracket, by Newton's method on the power balance */
#ifndef SP__LIMIT_LIMIT_C
#define SP__LIMIT_LIMIT_C

#include "../check/ladder.c"
#include "strong.c"

#if SP__WITH_INTERIOR

/* Flops that are left to the search: the certificate check of both ends needs some, too. */
static int64_t sp__limit_left(const sp__bracket *b)
{
    return b->limit - b->cost.flops - 80 * SP__FLOPS_CERTIFICATE * (int64_t)b->pb.points;
}

/* L->flat, the last thing taken from `a`, where one mirror is that of joints, dead and live loads. The loads at hand are those of
 * about the size both have at work. */
static void sp__limit_flat(sp__limit *L, sp_arena *a)
{
    sp__bracket *b = &L->bracket;
    L->flat = NULL;
    const size_t start = a->used;
    sp__flat *o = SP__WITH_PLAN ? sp__take(a, 1, sizeof *o) : NULL;
    int planar = o != NULL;
    for (int k = 0; k < 3 && planar; k++) {             /* both, dead, live */
        sp__bracket_load(b, k != 2, k != 1 ? L->ref : 0);
        planar = k ? sp__flat_loads(&b->pb, &b->set, o->e[2], 0) : sp__flat_choose(&b->pb, &b->set, o) && o->mode == SP__PLANE;
    }
    if (planar) L->flat = o;
    else if (o) a->used = start;
    sp__bracket_load(b, 1, L->ref);
}

/* The dual at that load, its sizes and metric; hints for both loads. */
SP__NOINLINE static sp_status sp__limit_open(sp__limit *L, sp_arena *a)
{
    sp__bracket *b = &L->bracket;
    const size_t n = 6 * (size_t)b->pb.blocks;
    sp_real *y0[2] = { L->r.y0, L->r.y0 + 2 * n };
    sp__limit_flat(L, a);
    L->w = sp__dual_make(&b->pb, &b->set, SP__LIMIT, L->flat, &b->cost, a);
    if (!L->w) return SP_E_MEMORY;
    L->w->limit = sp__limit_left(b) + b->cost.flops;
    L->m.x = sp__take(a, (size_t)b->pb.points, (size_t)(b->set.faces ? b->set.faces : 3) * sizeof *L->m.x);
    if (sp__failed(a)) return SP_E_MEMORY;
    for (int k = 0; k < 2; k++) {
        sp__bracket_load(b, k ? 0 : 1, k ? L->ref : 0);
        if (k) sp__bilateral_solve(L->w); else sp__dual_bilateral(L->w);
        if (L->w->spent) return SP_OK;
        L->state.y0 = y0[k];
        sp__dual_hint(L->w, &L->state);
    }
    for (size_t k = 0; k < 2 * n; k++) y0[1][k] /= L->ref;
    b->y0 = L->r.y0;
    L->w->metric = 0;
    sp__limit_loads_sized(L, 1);
    sp__limit_sizes(L);
    if (sp__dual_metric(L->w)) sp__dual_weights(L->w);
    sp__bracket_load(b, 0, L->ref);
    sp__dual_load(L->w, L->q);
    return SP_OK;
}

/* The exact stage under the loads at hand, first in 3 rows where they let it. */
SP__NOINLINE static sp_status sp__limit_stage(sp__limit *L, sp_arena room, sp_verdict *claim)
{
    sp__bracket *b = &L->bracket;
    sp_arena again = room;
    sp__flat *o = sp__take(&again, 1, sizeof *o);
    if (!o) return SP_E_MEMORY;
    if (sp__flat_choose(&b->pb, &b->wide, o)) {    /* with as many iterations as were asked for */
        const sp_status status = sp__exact_search(&b->pb, &b->set, o, &L->state, &again, claim);
        if (status || *claim == SP_STABLE || (*claim == SP_UNSTABLE && (o->mode == SP__PLANE || o->forest))) return status;
        *claim = SP_UNDECIDED;
    }
    return sp__exact_run(&b->pb, &b->set, &L->state, &room, claim);
}

/* Gates and the exact stage at d dead + a live.     returns what they claim; state.dq, or f, says it */
SP__NOINLINE static sp_verdict sp__limit_ask(sp__limit *L, sp_real d, sp_real a, sp_real *f, sp_arena room)
{
    sp__bracket *b = &L->bracket;
    sp_verdict claim = SP_UNDECIDED;
    sp_arena again = room;
    sp__bracket_load(b, d, a * L->ref);
    b->set.iterations = L->n.left;
    b->set.localise = 1;
    L->state.f = f;
    memset(f, 0, 3 * (size_t)b->pb.points * sizeof *f);
    L->state.y0 = b->hint;
    memset(&L->state.cost, 0, sizeof L->state.cost);
    L->state.left = sp__limit_left(b);
    if (L->state.left <= 0) { b->spent = 1; return SP_UNDECIDED; }
    sp_status status = sp__gates_run(&b->pb, &b->set, &L->state, &room, &claim);
    if (!status && !claim) status = sp__limit_stage(L, again, &claim);
    L->n.left -= L->state.cost.factorisations;
    sp__cost_add(&b->cost, &L->state.cost);
    if (status) claim = SP_UNDECIDED;
    if (claim == SP_UNSTABLE) memcpy(b->dq, L->state.dq, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    return claim;
}

/* Power balance of the motion: the multiple of live loads at which its work is 0; SP__HUGE where they do none. */
static sp_real sp__limit_balance(const sp__limit *L)
{
    const sp_real dead = sp__bracket_work(&L->bracket, L->bracket.dead) - L->bracket.resist;
    const sp_real live = L->ref * sp__bracket_work(&L->bracket, L->bracket.live);
    return sp__abs(dead) < SP__HUGE * sp__abs(live) ? -dead / live : SP__HUGE;
}

/* Vp falls below `least`, Vq beyond `best`, which is not more: together, in the shares in which live loads do no work, they fall at
 * any multiple, for joints resist both at once with no more than what they resist each with. */
static int sp__limit_never_stands(sp__limit *L)
{
    sp__bracket *b = &L->bracket;
    const size_t n = 6 * (size_t)b->pb.blocks;
    const sp_real p = sp__dot(b->live, L->Vp, n), q = sp__dot(b->live, L->Vq, n);
    if (!(L->least >= L->best && p < 0 && q > 0)) return 0;
    for (size_t k = 0; k < n; k++) b->dq[k] = L->Vp[k] / -p + L->Vq[k] / q;
    L->none = sp__bracket_falls(b, 0, 1, NULL, L->room);
    if (!L->none) memcpy(b->dq, L->Vq, n * sizeof *b->dq);
    return L->none;
}

/* An UNSTABLE at *a: its motion is a better bound from above, or, where live loads would hold it, from below. *a: where to ask
 * next.                                                                             returns 0: nothing gained */
static int sp__limit_cut(sp__limit *L, sp_real *a, sp_real step)
{
    const int beyond = sp__bracket_falls(&L->bracket, *a * L->ref, 1, NULL, L->room);
    if (!beyond && !sp__bracket_falls(&L->bracket, *a * L->ref, 0, NULL, L->room)) return 0;
    const sp_real balance = sp__limit_balance(L), last = *a;
    L->none = beyond && last <= 0;
    if (L->none) return 1;
    if (!(balance < SP__HUGE)) return 0;
    if (beyond ? balance < L->best : balance > L->least) {
        *(beyond ? &L->best : &L->least) = balance;
        memcpy(beyond ? L->Vq : L->Vp, L->bracket.dq, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->Vq);
    }
    if (sp__limit_never_stands(L)) return 1;
    const sp_real next = beyond ? L->best - step : balance + step < L->best ? balance + step : L->best;
    *a = sp__max(0, next);
    return beyond ? *a < last : *a > last;
}

/* Live loads alone, before there is an upper end: forces that balance them are a ray, and there is none; or something falls under
 * them, and its power balance is one. */
SP__NOINLINE static void sp__limit_live_alone(sp__limit *L, sp_arena room)
{
    sp__bracket *b = &L->bracket;
    sp_real a = 1;
    const sp_verdict claim = sp__limit_ask(L, 0, 1, L->r.ray, room);
    if (claim == SP_STABLE && sp__bracket_stands(b, 0, L->ref, L->r.ray, L->r.ray, L->room)) {
        for (size_t k = 0; k < 3 * (size_t)b->pb.points; k++) L->r.ray[k] /= L->ref;
        L->r.kind = SP_LIMIT_UNBOUNDED;
    }
    for (int it = 0; it < 3 && claim == SP_UNSTABLE && a < SP__HUGE; it++) {    /* what joints resist hangs on caps, and those on a */
        int32_t final;
        sp_arena again = L->room;
        if (!sp__bracket_judge_open(b, 1, a * L->ref, &again)) return;
        sp__certify_motion(&b->certificate, b->dq, 0, &final);
        sp__bracket_keep(b);
        L->best = a = sp__bracket_work(b, b->live) > 0 ? sp__limit_balance(L) : SP__HUGE;
    }
}

/* Does it stand under the dead loads alone, so that there is something to climb from? Or fall, whatever the live ones do: L->none */
SP__NOINLINE static int sp__strong_starts(sp__limit *L, sp_arena room)
{
    sp__bracket *b = &L->bracket;
    const size_t bytes = 6 * (size_t)b->pb.blocks * sizeof *b->dq;
    memcpy(L->Vp, b->dq, bytes);
    const sp_verdict claim = sp__limit_ask(L, 1, 0, L->r.f, room);
    L->none = claim == SP_UNSTABLE && sp__bracket_falls(b, 0, 1, NULL, L->room);
    if (!L->none) memcpy(b->dq, L->Vp, bytes);
    if (claim != SP_STABLE || !sp__bracket_stands(b, 1, 0, L->r.f, L->r.f, L->room)) return 0;
    L->r.lower = 0;
    L->r.omega = b->omega;
    L->r.dead = SP_STABLE;
    return 1;
}

/* Of forces in r.ray that carry a large multiple little is due to dead loads: are they a ray without what is so small? */
SP__NOINLINE static int sp__limit_far_unbounded(sp__limit *L)
{
    sp_real *ray = L->r.ray;
    sp__forces_dust(ray, L->bracket.pb.points, 100 * L->ref / L->r.lower);
    for (size_t k = 0; k < 3 * (size_t)L->bracket.pb.points; k++) ray[k] /= L->r.lower;
    if (!sp__bracket_stands(&L->bracket, 0, 1, L->r.ray, L->r.ray, L->room)) return 0;
    L->r.kind = SP_LIMIT_UNBOUNDED;
    return 1;
}

/* Where interior points leave an end open: the exact stage just below the best motion's power balance. Each collapse it finds
 * gives a better one, as Newton's method on the least imbalance over lambda would: few steps.            [Dinkelbach 1967]
 *     returns 1: lower is found (of an UNBOUNDED any), or nothing stands */
SP__NOINLINE static int sp__limit_newton(sp__limit *L, sp_arena room)
{
    const int any = L->r.kind == SP_LIMIT_UNBOUNDED;
    sp_real *f = any ? L->r.f : L->r.ray;               /* those of the lower end stay until there are better ones */
    if (any) L->best = SP__HUGE;
    const sp_real size = 1 + (L->best < SP__HUGE ? sp__abs(L->best) : 0), far = (sp_real)0.01 * size;
    sp_real step = SP__LIMIT_STEP * L->bracket.set.tol * size;
    L->least = -SP__HUGE;
    memcpy(L->Vq, L->bracket.dq, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->Vq);
    sp_real a = L->best < SP__HUGE ? sp__max(0, L->best - step) : 0;
    for (int it = 0; it < 24 && L->n.left > 0 && sp__limit_left(&L->bracket) > 0 && step < far; it++) {
        const sp_verdict claim = sp__limit_ask(L, 1, a, f, room);
        if (claim == SP_STABLE && sp__bracket_stands(&L->bracket, 1, a * L->ref, f, f, L->room)) {
            if (!(a > 0)) L->r.dead = SP_STABLE;
            if (a * L->ref > L->r.lower) {
                L->r.lower = a * L->ref;
                L->r.omega = L->bracket.omega;
                memmove(L->r.f, f, 3 * (size_t)L->bracket.pb.points * sizeof *f);
            }
            if (any || L->best < SP__HUGE || (a > SP__LIMIT_FAR && sp__limit_far_unbounded(L))) return 1;
            a = a > 0 ? 8 * a : 1;
            continue;
        }
        if (claim == SP_UNSTABLE && sp__limit_cut(L, &a, step)) {
            if (L->none) return 1;
            continue;
        }
        if (claim == SP_UNSTABLE) {                     /* does it stand at all? */
            if (!(a > 0)) return 0;
            a = 0;
            continue;
        }
        if (L->best < SP__HUGE) {
            step *= 10;
            a = sp__max(0, L->best - step);
        } else a = a > 0 ? 8 * a : 1;
    }
    if (L->best < SP__HUGE) memcpy(L->bracket.dq, L->Vq, 6 * (size_t)L->bracket.pb.blocks * sizeof *L->Vq);
    return 0;
}

/* The motion at hand proves the upper end, the least it can; or that of the exact stage there. */
SP__NOINLINE static int sp__limit_upper(sp__limit *L, sp_arena room)
{
    sp_limit_result *r = &L->r;
    sp_real slack = sp__max(L->slack, L->bracket.set.tol * (1 + sp__abs(L->best))) * (sp_real)1.5;
    for (int it = 0; it < 8; it++, slack *= 2) {
        const sp_real lambda = L->none ? 0 : sp__max(0, L->best + slack) * L->ref;
        if (it == 2 && !L->none) sp__limit_ask(L, 1, L->best + slack, r->ray, room);
        if (!sp__bracket_falls(&L->bracket, lambda, 1, r->dq, L->room)) continue;
        if (L->bracket.least < (sp_real)1.1 * L->bracket.set.tol) {   /* by a hair: so that it is proof as it is told, too */
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

/* What was found, by its ends. */
static void sp__limit_conclude(sp__limit *L)
{
    sp_limit_result *r = &L->r;
    const sp_real slack = L->slack < SP__LIMIT_SLACK ? L->slack : SP__LIMIT_SLACK;
    const sp_real wide = SP__LIMIT_WIDE * r->tol * (sp__abs(r->lower) + L->ref) + 4 * slack * L->ref;
    const int never = L->none || (r->lower < 0 && !(r->upper > 0));
    if (never) r->kind = r->upper < 0 ? SP_LIMIT_UNDECIDED : SP_LIMIT_NONE;
    else if (r->kind == SP_LIMIT_UNBOUNDED) r->kind = r->lower < 0 ? SP_LIMIT_UNDECIDED : SP_LIMIT_UNBOUNDED;
    else if (r->lower >= 0 && r->upper >= r->lower && r->upper - r->lower <= wide) r->kind = SP_LIMIT_FOUND;
    const int spent = L->bracket.spent || L->n.left <= 0 || sp__limit_left(&L->bracket) <= 0;
    r->reason = r->kind ? SP_REASON_FORCES : spent ? SP_REASON_BUDGET : SP_REASON_LIMIT;
    if (r->kind != SP_LIMIT_FOUND) return;
    const sp_real balance = sp__limit_balance(L) * L->ref;
    if (balance >= 0 && balance < r->lower && sp__bracket_stands(&L->bracket, 1, balance, r->f, NULL, L->room)) {
        r->lower = balance;                             /* within tol the same forces carry less, too */
        r->omega = L->bracket.omega;
    }
    r->multiplier = balance < r->lower ? r->lower : balance > r->upper ? r->upper : balance;
    r->within = sp__bracket_within(r, balance);
}

/* What of all that stands, or falls, under the dead loads alone, and from where on? Where live loads must hold it, each collapse
 * tells a least multiple, by Newton's method on the least imbalance, from below. */
SP__NOINLINE static void sp__limit_lowest(sp__limit *L, sp_arena room)
{
    sp__bracket *b = &L->bracket;
    sp_limit_result *r = &L->r;
    sp_real a = 0;
    r->lowest = r->lower;
    if (r->kind == SP_LIMIT_NONE) r->dead = SP_UNSTABLE;
    else if (!(r->lower > 0) && r->lower >= 0) r->dead = SP_STABLE;
    if (r->dead == SP_STABLE) r->lowest = 0;
    for (int it = 0; it < 12 && r->lowest > a * L->ref && L->n.left > 0; it++) {
        const sp_real last = a;
        const sp_verdict claim = sp__limit_ask(L, 1, a, L->f, room);
        if (claim == SP_STABLE && sp__bracket_stands(b, 1, a * L->ref, L->f, NULL, L->room)) {
            r->lowest = a * L->ref;
            if (!it) r->dead = SP_STABLE;
            if (r->kind != SP_LIMIT_UNBOUNDED) return;
            r->lower = r->lowest;                       /* every multiple from there on */
            r->omega = b->omega;
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

/* About the multiple at which live loads are of the size of dead ones, over all contacts; moments by their arms. */
static sp_real sp__limit_reference(sp__bracket *b)
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

/* Interior points and what they leave: the best motion sharpened.     returns 1: both ends are near, or nothing stands */
SP__NOINLINE static int sp__limit_search(sp__limit *L)
{
    sp__bracket *b = &L->bracket;
    int done = !L->w->spent && sp__interior_run(L);
    if (L->r.kind == SP_LIMIT_UNBOUNDED) return L->r.lower >= 0;
    if (!L->w->spent && !(done && L->none) && L->best < SP__HUGE) sp__limit_sharpen(L);
    if (L->none && !done) done = L->none = sp__bracket_falls(b, 0, 1, NULL, L->room);
    b->spent |= L->w->spent;
    return done || sp__limit_closed(L, SP__LIMIT_WIDE * L->r.tol);
}

/* Search, then both ends; `a` is used up. */
SP__NOINLINE static sp_status sp__limit_decide(sp__limit *L, sp_arena *a)
{
    sp__bracket *b = &L->bracket;
    sp_arena rest = *a;
    int done = 0, live = 0;
    for (size_t k = 0; k < 6 * (size_t)b->pb.blocks; k++) live |= b->live[k] < 0 || b->live[k] > 0;
    if (!live) L->r.kind = SP_LIMIT_UNBOUNDED;                  /* does it stand at all? */
    else if (!sp__problem_strong(&b->pb)) {
        const sp_status status = sp__limit_open(L, a);
        if (status) return status;
        done = sp__limit_search(L);
    }
    if (!done) {
        L->none = 0;
        if (L->r.kind != SP_LIMIT_UNBOUNDED && !(L->best < SP__HUGE)) sp__limit_live_alone(L, rest);
        const int strong = sp__problem_strong(&b->pb) && L->r.kind != SP_LIMIT_UNBOUNDED;
        if (strong && sp__strong_starts(L, rest) && L->best >= 0) {
            a->used = rest.used;
            const sp_status status = sp__limit_open(L, a);
            if (status) return status;
            done = sp__strong_run(L);
        }
        if (!done && !L->none) done = sp__limit_newton(L, rest);
    }
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
    L->state.y = sp__take(a, (size_t)blocks, 6 * sizeof *L->state.y);
    L->state.dq = sp__take(a, (size_t)blocks, 6 * sizeof *L->state.dq);
    L->q = sp__take(a, (size_t)blocks, 6 * sizeof *L->q);
    L->Vq = sp__take(a, (size_t)blocks, 6 * sizeof *L->Vq);
    L->Vp = sp__take(a, (size_t)blocks, 6 * sizeof *L->Vp);
}

SP_API size_t sp_limit_memory_scratch(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp__problem_count(scene, &pb);
    return sizeof(sp__limit) + SP_ALIGN + sp_limit_verify_memory(scene) + SP_ALIGN + sp__dual_scratch(&pb);
}

SP_API sp_status sp_limit_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__limit *L = sp__take(&scratch, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    const sp_status status = sp__bracket_build(scene, settings, &L->bracket, &scratch);
    if (status) return status;
    const sp_problem *pb = &L->bracket.pb;
    const int32_t faces = L->bracket.set.faces;
    L->bracket.y0 = NULL;
    L->ref = sp__limit_reference(&L->bracket);
    sp__limit_flat(L, &scratch);
    if (SP__WITH_PLAN && !L->flat) L->flat = sp__take(&scratch, 1, sizeof *L->flat);    /* of other loads there may be one */
    const size_t search = pb->blocks ? sp__dual_most(pb, &L->bracket.set, 0, (size_t)(faces ? faces : 3), L->flat, scratch) : 0;
    if (search == SIZE_MAX) return SP_E_MEMORY;
    sp__limit_kept kept;
    sp_arena dry = sp__arena_dry();
    sp__limit_carve_kept(&kept, scene, pb->blocks, &dry);
    sp__take(&dry, 1, sizeof *L);
    sp__take(&dry, 1, sp_problem_memory(scene));
    sp_real *at[5];
    sp__bracket_carve(at, pb->blocks, &dry);
    sp__limit_carve(L, scene, pb->blocks, &dry);
    sp__take(&dry, 1, sp__certificate_need(pb, &L->bracket.set));
    sp__take(&dry, 1, search);
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
    memset(L->state.y, 0, 6 * (size_t)count.blocks * sizeof *L->state.y);
    r->lower = r->upper = r->lowest = -1;
    r->tol = L->bracket.set.tol;
    r->force_bound = L->bracket.set.force_bound;
    L->n.goal = r->tol / 4;
    L->n.left = (sp__problem_strong(&L->bracket.pb) ? 2 : 1) * L->bracket.set.iterations;
    L->best = SP__HUGE;
    L->ref = sp__limit_reference(&L->bracket);
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
