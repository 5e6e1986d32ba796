/* limit: sp_limit by the smallest search */
#ifndef SP__SMALL_LIMIT_C
#define SP__SMALL_LIMIT_C

#include "../limit/bracket.c"
#include "check.c"

#if SP__WITH_SMALL && SP__WITH_LIMIT

/* sp_limit by that search alone. Forces that balance the live loads without the dead ones are a ray, and there is no end; or
 * something falls under them, and the multiple at which its motion does no work, -(dead . dq) / (live . dq), is no less than
 * lambda. From there Newton's method on the least imbalance over lambda: what falls just below has a lesser one, or, where live
 * loads hold it, tells the least multiple.                                                             [Dinkelbach 1967] */
typedef struct sp__limit {
    sp__bracket bracket;
    sp__small w;
    sp_result at;                       /* of the search at hand */
    sp_limit_result r;                  /* its dq: the motion of `best` */
    sp_real best, unit, step;           /* least balance; multiple at which both loads are as large; how far below to ask */
    sp_verdict dead;                    /* without live loads */
    int none;                           /* that motion falls at 0, too */
} sp__limit;

/* The search under d dead + l live; the ends' dq is the motion it ends with. */
SP__NOINLINE static sp_verdict sp__limit_ask(sp__limit *L, sp_real d, sp_real l, sp_arena room)
{
    sp__bracket_load(&L->bracket, d, l);
    L->at.verdict = SP_UNDECIDED;
    L->w.metric = 0;
    if (!L->bracket.pb.blocks) return SP_STABLE;
    sp__small_run(&L->w, &room);
    sp__verify_motion(&L->bracket.pb, L->at.dq, L->bracket.dq);
    return L->at.verdict;
}

/* Power balance of the motion: the multiple of live loads at which its work is 0; SP__HUGE where they do none. */
static sp_real sp__limit_balance(const sp__bracket *b)
{
    const sp_real dead = sp__bracket_work(b, b->dead), live = sp__bracket_work(b, b->live);
    return sp__abs(dead) < SP__HUGE * sp__abs(live) ? -dead / live : SP__HUGE;
}

/* What falls at a: a better bound from above, or, where live loads would hold it, from below. Returns where to ask next; a itself
 * where nothing is gained. */
SP__NOINLINE static sp_real sp__limit_cut(sp__limit *L, sp_real a, sp_arena room)
{
    const sp_real balance = sp__limit_balance(&L->bracket);
    const int beyond = sp__bracket_falls_beyond(&L->bracket, room);
    L->none = beyond && !(a > 0);
    if (beyond && (L->none || balance < L->best)) {
        L->best = balance;
        memcpy(L->r.dq, L->at.dq, 6 * (size_t)L->bracket.scene.count.blocks * sizeof *L->r.dq);
        return L->none ? a : sp__max(0, balance - L->step);
    }
    const sp_real middle = balance < L->best ? (balance + L->best) / 2 : L->best;
    const sp_real next = balance + L->step < middle ? balance + L->step : middle;
    return !beyond && next > a ? next : a;
}

SP__NOINLINE static void sp__limit_search(sp__limit *L, sp_arena room)
{
    sp__bracket *b = &L->bracket;
    sp_limit_result *r = &L->r;
    sp__bracket_load(b, 1, 0);
    const sp_real dead = sp__load_unit(&b->pb);
    sp__bracket_load(b, 0, 1);
    L->unit = dead / sp__load_unit(&b->pb);
    if (sp__limit_ask(L, 0, 1, room) == SP_STABLE) {
        r->kind = SP_LIMIT_UNBOUNDED;
        L->at.f = r->f;                                 /* the others stay: the ray */
    } else if (sp__bracket_work(b, b->live) > 0) sp__limit_cut(L, 1, room);
    L->step = 4 * r->tol * (L->unit + (L->best < SP__HUGE ? L->best : 0));
    sp_real a = L->best < SP__HUGE ? sp__max(0, L->best - L->step) : 0;
    for (int it = 0; it < 24 && !L->none; it++) {
        const sp_verdict verdict = sp__limit_ask(L, 1, a, room);
        if (!(a > 0)) L->dead = verdict;
        if (verdict == SP_STABLE) {
            r->lower = a;
            r->imbalance = L->at.imbalance;
            memmove(r->f, L->at.f, 3 * (size_t)b->pb.points * sizeof *r->f);
            if (r->kind == SP_LIMIT_UNBOUNDED || L->best < SP__HUGE) return;
        }
        const sp_real was = a;
        if (verdict == SP_UNSTABLE) a = sp__limit_cut(L, a, room);
        else if (verdict == SP_STABLE || !(L->best < SP__HUGE)) a = a > 0 ? 8 * a : L->unit;
        else { L->step *= 10; a = sp__max(0, L->best - L->step); }
        if (!(a < was) && !(a > was)) return;
    }
}

/* Does it stand under the dead loads alone, and if not, from where on? */
SP__NOINLINE static void sp__limit_lowest(sp__limit *L, sp_arena room)
{
    sp_limit_result *r = &L->r;
    sp_real a = 0;
    r->lowest = r->lower;
    if (r->kind == SP_LIMIT_NONE) r->dead = SP_UNSTABLE;
    else if (!(r->lower > 0)) r->dead = r->lower < 0 ? SP_UNDECIDED : SP_STABLE;
    if (r->kind == SP_LIMIT_UNBOUNDED && r->lower > 0) r->dead = L->dead;       /* asked already, and no room for other forces */
    for (int it = 0; it < 12 && r->kind == SP_LIMIT_FOUND && r->lower > a; it++) {
        const sp_real last = a;
        const sp_verdict verdict = sp__limit_ask(L, 1, a, room);
        if (!it) r->dead = verdict;
        if (verdict == SP_STABLE) r->lowest = a;
        if (verdict != SP_UNSTABLE) return;
        a = sp__limit_balance(&L->bracket) + L->step;
        if (!(a > last)) return;
    }
}

/* Both ends of what was found, and what that makes of it. */
SP__NOINLINE static void sp__limit_conclude(sp__limit *L, sp_arena room)
{
    sp__bracket *b = &L->bracket;
    sp_limit_result *r = &L->r;
    const sp_real wide = 1000 * r->tol * (L->unit + sp__abs(r->lower));
    sp_real slack = wide / 500;
    for (int it = 0; it < 10 && r->upper < 0 && (L->none || (!r->kind && L->best < SP__HUGE)); it++, slack *= 2) {
        const sp_real lambda = L->none ? 0 : sp__max(0, L->best + slack);
        sp__verify_motion(&b->pb, r->dq, b->dq);
        if (!sp__bracket_falls(b, lambda, 1, r->dq, room)
            && (sp__limit_ask(L, 1, lambda, room) != SP_UNSTABLE || !sp__bracket_falls(b, lambda, 1, r->dq, room))) continue;
        r->upper = lambda;
        r->least_imbalance = b->least;
        r->final = b->final;
    }
    if (L->none) r->kind = SP_LIMIT_NONE;
    else if (!r->kind && r->lower >= 0 && r->upper - r->lower <= wide) r->kind = SP_LIMIT_FOUND;
    const sp_real balance = sp__limit_balance(b);
    if (r->kind == SP_LIMIT_FOUND) {
        r->multiplier = balance < r->lower ? r->lower : balance > r->upper ? r->upper : balance;
        r->within = sp__bracket_within(r, balance);
    }
    sp__limit_lowest(L, room);
    if (r->kind != SP_LIMIT_UNBOUNDED) memset(r->ray, 0, 3 * (size_t)b->pb.points * sizeof *r->ray);
    r->verified = r->kind && sp__bracket_holds(b, r, room);
    if (!r->verified) { r->kind = SP_LIMIT_UNDECIDED; r->reason = SP_REASON_LIMIT; }
}

/* f, ray, dq */
static size_t sp__limit_numbers(const sp_scene *scene)
{
    return 6 * ((size_t)scene->count.points + (size_t)scene->count.blocks);
}

static size_t sp__limit_scratch(const sp_scene *scene)
{
    if (!scene) return 0;
    return sizeof(sp__limit) + sp__limit_verify_memory(scene) + 24 * (size_t)scene->count.blocks + 2 * SP_ALIGN;
}

static sp_status sp__limit_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__limit *L = sp__take(&scratch, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    const sp_status status = sp__bracket_build(scene, settings, &L->bracket, &scratch);
    if (status) return status;
    sp_real *at[5];
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, sp__limit_numbers(scene), sizeof(sp_real));
    sp__take(&dry, 1, sizeof *L);
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp__bracket_carve(at, L->bracket.pb.blocks, &dry);
    sp__take(&dry, (size_t)scene->count.blocks, 6 * sizeof(sp_real));
    if (!sp__small_need(&L->w, &L->bracket.pb, &L->bracket.set, scratch, &dry)) return SP_E_MEMORY;
    *bytes = dry.used;
    return SP_OK;
}

SP_API sp_status sp_limit(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_limit_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp_arena a = *arena;
    const size_t numbers = sp__limit_numbers(scene), forces = 3 * (size_t)scene->count.points;
    sp_real *number = sp__take(&a, numbers, sizeof *number);
    const size_t used = a.used;
    sp__limit *L = sp__take(&a, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    memset(number, 0, numbers * sizeof *number);
    memset(L, 0, sizeof *L);
    const sp_status status = sp__bracket_build(scene, settings, &L->bracket, &a);
    if (status) return status;
    sp_limit_result *r = &L->r;
    r->f = number; r->ray = r->f + forces; r->dq = r->ray + forces;
    r->lower = r->upper = r->lowest = -1;
    r->tol = L->bracket.set.tol;
    r->force_bound = L->bracket.set.force_bound;
    L->best = SP__HUGE;
    L->at.f = r->ray; L->at.y0 = L->bracket.hint;
    L->at.dq = sp__take(&a, (size_t)scene->count.blocks, 6 * sizeof *r->dq);
    if (L->at.dq) memset(L->at.dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    L->w.pb = &L->bracket.pb; L->w.set = &L->bracket.set; L->w.to = &L->at;
    sp_arena room = a;
    if (!sp__small_carve(&L->w, &L->bracket.pb, &a, &a)) return SP_E_MEMORY;
    room = a;
    sp__take(&a, 1, sp__certificate_need(&L->bracket.pb, &L->bracket.set));
    if (sp__failed(&a)) return SP_E_MEMORY;
    sp__limit_search(L, room);
    sp__limit_conclude(L, room);
    r->cost = L->at.cost;
    r->peak_bytes = arena->peak = a.peak;
    arena->used = used;
    *result = *r;
    return SP_OK;
}

#endif

#endif /* SP__SMALL_LIMIT_C */
