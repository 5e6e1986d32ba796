/* sliding: sp_sliding: histories from several starts, the lowest state they lead to, and what pressure alone carries. */
#ifndef SP__SLIDING_SLIDING_C
#define SP__SLIDING_SLIDING_C

#include "../proof/sliding.c"
#include "even.c"

#if SP__WITH_SLIDING

#define SP__SLIDING_STIFF ((sp_real)20)     /* of a corner: mean loads a mean arm; along the joint half of that */
#define SP__SLIDING_SOFT ((sp_real)1e-3)    /* damping of a history: mean loads a mean arm */
#define SP__SLIDING_FLOPS 10000000          /* what is spent at least, if starts are left */
#define SP__SLIDING_STEPS 4000              /* of a history, at most */
#define SP__SLIDING_FAR 1000                /* times the multiple where live loads are as large as dead ones: lower's end */
#define SP__SLIDING_HALVES 8                /* of what forces carry, until it is proved */
#define SP__SLIDING_INSIDE (1 - (sp_real)1e6 * (sp_real)SP_EPSILON)     /* of it: inside friction, by more than rounding */

typedef struct sp__sliding {
    sp__bracket bracket;
    sp__slab slab;
    sp__push push;
    sp__descend descend;
    sp__even even;
    sp_real *f, *v, *v6;                /* 3 x points, 6 x blocks of the scene: of the state at hand; 6b */
    sp_real *mixed;                     /* 3 x points: forces between two multiples */
    int64_t limit;                      /* of flops */
    sp_sliding_result r;
} sp__sliding;

static int64_t sp__sliding_flops(const sp__sliding *s)
{
    return s->push.flops + s->push.K.flops + sp__descend_flops(&s->descend) + s->bracket.cost.flops;
}

/* Bytes of the search in a planar scene, at most. */
static size_t sp__sliding_search(int32_t points, int32_t blocks)
{
    if (blocks > SP__SLIDING_BLOCKS || blocks < 1) return 0;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sp__push_need(points, 3 * blocks, 3 * blocks - 1));
    sp__take(&dry, 1, sp__descend_need(points, 3 * blocks));
    return dry.used;
}

/* Bytes of what judges. */
SP__NOINLINE static size_t sp__sliding_judge_need(const sp_problem *pb)
{
    sp__certifier j;
    sp_arena dry = sp__arena_dry();
    sp__certifier_carve(&j, pb, 0, &dry);
    return dry.peak;
}

/* What a call works on besides the search: the bracket is built. */
static void sp__sliding_carve(sp__sliding *s, const sp_problem *pb, sp_arena *a)
{
    const size_t judge = sp__sliding_judge_need(pb);
    s->bracket.room.base = sp__take(a, 1, judge);
    s->bracket.room.capacity = judge ? judge : 1;
    s->bracket.room.used = s->bracket.room.peak = 0;
    s->f = sp__take(a, (size_t)pb->points, 3 * sizeof *s->f);
    s->v = sp__take(a, (size_t)pb->scene->count.blocks, 6 * sizeof *s->v);
    s->v6 = sp__take(a, (size_t)pb->blocks, 6 * sizeof *s->v6);
    s->mixed = sp__take(a, (size_t)pb->points, 3 * sizeof *s->mixed);
    sp__even_carve(&s->even, pb, a);
    sp__slab_carve(&s->slab, pb, a);
}

/* The question and its problem, shared with sp_sliding_verify. */
static sp_status sp__sliding_open(sp__sliding *s, const sp_scene *scene, const sp_settings *settings, sp_arena *a)
{
    memset(s, 0, sizeof *s);
    const sp_status status = sp__bracket_build(scene, settings, &s->bracket, a);
    if (status) return status;
    if (s->bracket.set.faces) return SP_E_UNSUPPORTED;
    sp__sliding_carve(s, &s->bracket.pb, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    sp__even_make(&s->even, &s->bracket.pb, s->v6);
    return SP_OK;
}

/* The loads at lambda, and a certificate check for them within the budget. */
static int sp__sliding_certify(sp__sliding *s, sp_real lambda)
{
    sp__bracket *b = &s->bracket;
    if (b->set.budget > 0 && s->limit > 0) b->limit = s->limit - (sp__sliding_flops(s) - b->cost.flops);
    return sp__bracket_certify_begin(b, 1, lambda);
}

/* Largest violation of a state at lambda; 0 of *share, SP__HUGE: none. */
static sp_real sp__sliding_judge(sp__sliding *s, sp_real lambda, const sp_real *f, const sp_real *v, sp_real *share)
{
    sp__bracket *b = &s->bracket;
    *share = 0;
    if (!(lambda >= 0) || !sp__sliding_certify(s, lambda)) return SP__HUGE;
    sp__motion_read(&b->pb, v, s->v6);
    const sp_real residual = sp__certify_sliding(&b->certifier, b->live, f, s->v6, share);
    sp__bracket_certify_end(b);
    return residual;
}

/* Does the pressure of f alone carry lambda times the live loads?     out: that pressure; may be f */
static int sp__sliding_presses(sp__sliding *s, sp_real lambda, const sp_real *f, sp_real *out)
{
    sp__bracket *b = &s->bracket;
    if (!(lambda >= 0) || !sp__sliding_certify(s, lambda)) return 0;
    const sp_real imbalance = sp__certify_pressure(&b->certifier, f, out);
    sp__bracket_certify_end(b);
    return imbalance <= b->set.tol;
}

/* Do the forces f, by pressure alone or with even friction, carry lambda times the live loads, so that no state lies below? */
static int sp__sliding_carries(sp__sliding *s, sp_real lambda, const sp_real *f)
{
    sp__bracket *b = &s->bracket;
    if (!(lambda >= 0) || !sp__sliding_certify(s, lambda)) return 0;
    const int carries = sp__even_carries(&s->even, &b->certifier, f, b->live);
    sp__bracket_certify_end(b);
    return carries || sp__sliding_presses(s, lambda, f, s->f);
}

/* Does nothing move from rest there, either, whatever friction does? */
static int sp__sliding_holds(sp__sliding *s, sp_real lambda, const sp_real *f)
{
    sp__bracket *b = &s->bracket;
    if (!(lambda >= 0) || !sp__sliding_certify(s, lambda)) return 0;
    const int holds = sp__even_holds(&s->even, &b->certifier, f, b->live);
    sp__bracket_certify_end(b);
    return holds || sp__sliding_presses(s, lambda, f, s->f);
}

/* Strong on all of [0, lambda]: by `resting` at 0, and at lambda by forces between them and those at `lower`. With u of either
 * end a pair (f, a) at l has  u0'Ma <= l q . a  and  u1'Ma <= (l - lambda) q . a: by the sign of q . a one says a = 0. */
static int sp__sliding_strong(sp__sliding *s, sp_real lambda, sp_real lower, const sp_real *pressed, const sp_real *resting)
{
    const size_t n = 3 * (size_t)s->bracket.pb.points;
    if (!(lower > 0) || !(lambda <= lower) || !sp__sliding_holds(s, 0, resting)) return 0;
    for (size_t k = 0; k < n; k++) s->mixed[k] = resting[k] + lambda / lower * (pressed[k] - resting[k]);
    return sp__sliding_holds(s, lambda, s->mixed);
}

/* Stiffness of the corners: the first start's are alike. */
static void sp__sliding_stiffness(sp__sliding *s, int first)
{
    for (int32_t v = 0; v < s->slab.corners; v++) {
        const sp_real a = first ? (sp_real)0.5 : sp__slide_random(&s->descend.seed);
        const sp_real b = first ? (sp_real)0.5 : sp__slide_random(&s->descend.seed);
        s->push.kn[v] = SP__SLIDING_STIFF * (1 + a) / (2 - a);
        s->push.ks[v] = SP__SLIDING_STIFF / 2 * (1 + b) / (2 - b);
    }
}

/* A history: at rest, pushed until forces stay, then without damping.     returns 1: it came to an end */
static int sp__sliding_history(sp__sliding *s, int64_t flops)
{
    sp__push *p = &s->push;
    p->limit = p->flops + p->K.flops + flops;
    p->soft = SP__SLIDING_SOFT;
    p->track = 0;
    if (!sp__push_rest(p) || !sp__push_run(p, SP__SLIDING_STEPS)) return 0;
    p->track = 1;
    return sp__push_run(p, SP__SLIDING_STEPS);
}

/* The state that descend found, where it lies below the one at hand and is one. */
static void sp__sliding_take(sp__sliding *s)
{
    const sp_scene *scene = s->bracket.pb.scene;
    sp_sliding_result *r = &s->r;
    sp_real share, *v6 = s->v6;
    if (r->kind == SP_SLIDING_STATE && s->descend.lambda >= r->upper) return;
    memset(s->f, 0, 3 * (size_t)scene->count.points * sizeof *s->f);
    memset(s->v, 0, 6 * (size_t)scene->count.blocks * sizeof *s->v);
    sp__slab_forces(&s->slab, s->descend.fn, s->descend.ft, s->f);
    sp__slab_motion(&s->slab, s->descend.v, v6);
    for (int32_t i = 0; i < s->bracket.pb.blocks; i++)
        memcpy(s->v + 6 * (size_t)s->bracket.pb.block[i], v6 + 6 * (size_t)i, 6 * sizeof *v6);
    const sp_real residual = sp__sliding_judge(s, s->descend.lambda, s->f, s->v, &share);
    if (!(residual <= s->bracket.set.tol) || !(share >= SP__SLIDES)) return;
    r->kind = SP_SLIDING_STATE;
    r->upper = s->descend.lambda;
    r->residual = residual;
    r->share = share;
    memcpy(r->f, s->f, 3 * (size_t)scene->count.points * sizeof *s->f);
    memcpy(r->v, s->v, 6 * (size_t)scene->count.blocks * sizeof *s->v);
}

/* Histories, each led down as far as it goes. */
SP__NOINLINE static void sp__sliding_starts(sp__sliding *s, const sp_sliding_settings *how)
{
    sp_sliding_result *r = &s->r;
    for (int32_t k = 0; k < how->starts && sp__sliding_flops(s) < s->limit; k++) {
        sp_sliding_end *end = &r->end[r->ends++];
        end->seed = how->seed + (uint32_t)k;
        s->descend.seed = ((uint64_t)end->seed + 1) * 0x9e3779b97f4a7c15u;
        sp__sliding_stiffness(s, !k);
        int64_t left = s->limit - sp__sliding_flops(s);
        const int steady = sp__sliding_history(s, left < s->limit / 3 ? left : s->limit / 3);
        end->steady = steady ? s->push.lambda : -1;
        end->least = -1;
        left = s->limit - sp__sliding_flops(s);
        if (!(s->push.lambda > -SP__HUGE) || left <= 0 || !sp__descend_run(&s->descend, &s->push, left)) continue;
        end->least = s->descend.lambda;
        sp__sliding_take(s);
    }
}

/* Forces of the plane's corners, as they are and at rest, into s->f and s->mixed, so many parts of the way between. */
static void sp__sliding_between(sp__sliding *s, sp_real t)
{
    const size_t n = 3 * (size_t)s->bracket.pb.points;
    sp__slab_forces(&s->slab, s->push.fn, s->push.ft, s->f);
    sp__slab_forces(&s->slab, s->push.gn, s->push.gt, s->mixed);
    for (size_t k = 0; k < n; k++) s->r.pressed[k] = s->mixed[k] + t * (s->f[k] - s->mixed[k]);
}

/* The most that forces carry, by pressure or with friction, down from there by halves until it proves what it is to: no state
 * below; nothing moves from rest up to there. Pressure needs no halves. */
SP__NOINLINE static void sp__sliding_lower(sp__sliding *s, int rubs)
{
    sp_sliding_result *r = &s->r;
    sp_real *const f[2] = { s->push.fn, s->push.ft }, *const rest[2] = { s->push.gn, s->push.gt };
    const sp_real most = r->associative >= 0 ? r->associative : SP__SLIDING_FAR * sp__engine_reference(&s->bracket);
    const int64_t left = s->bracket.set.budget > 0 ? s->limit - sp__sliding_flops(s) : INT64_MAX / 4;
    if (left <= 0) return;
    const sp_real lambda = sp__descend_most(&s->descend, rubs, most, f, rest, left) * (rubs ? SP__SLIDING_INSIDE : (sp_real)1);
    if (!(lambda > r->lower)) return;
    for (int32_t k = 0; k < (rubs ? SP__SLIDING_HALVES : 1); k++) {
        const sp_real part = 1 / (sp_real)((int64_t)1 << k);
        sp__sliding_between(s, part * (rubs ? SP__SLIDING_INSIDE : (sp_real)1));
        if (!sp__sliding_carries(s, part * lambda, r->pressed)) continue;
        r->lower = part * lambda;
        sp__slab_forces(&s->slab, rest[0], rest[1], r->resting);
        for (sp_real x = r->lower; !(r->lower_strong > 0) && k < SP__SLIDING_HALVES; k++, x /= 2)
            if (sp__sliding_strong(s, x, r->lower, r->pressed, r->resting)) r->lower_strong = x;
        return;
    }
}

/* Rows, then both sides. */
static void sp__sliding_decide(sp__sliding *s, const sp_sliding_settings *how, sp_arena *a)
{
    const sp_problem *pb = &s->bracket.pb;
    sp_sliding_result *r = &s->r;
    r->reason = SP_SLIDING_NOT_ASKED;
    if (pb->blocks > SP__SLIDING_BLOCKS || sp__scene_strong(pb->scene) || !sp__slab_make(&s->slab, &s->bracket)) return;
    sp__push_carve(&s->push, s->slab.corners, s->slab.rows, s->slab.band, a);
    sp__descend_carve(&s->descend, s->slab.corners, s->slab.rows, a);
    s->push.w = s->descend.w = &s->slab;
    sp__descend_make(&s->descend);
    r->reason = SP_SLIDING_NOTHING_FOUND;
    if (!(s->descend.size > 0)) return;
    sp__sliding_lower(s, 0);
    if (!(r->lower > 0) && sp__even_asked(pb)) sp__sliding_lower(s, 1);
    s->push.flops = s->push.K.flops = 0;
    sp__sliding_starts(s, how);
    if (r->kind == SP_SLIDING_STATE) r->reason = SP_SLIDING_FOUND;
}

/* What a result keeps. */
typedef struct sp__sliding_kept {
    sp_sliding_end *end;
    sp_real *f, *v, *pressed, *resting;
} sp__sliding_kept;

static void sp__sliding_keep(const sp_scene *scene, sp__sliding_kept *r, sp_arena *a)
{
    const size_t points = (size_t)scene->count.points;
    r->end = sp__take(a, SP_SLIDING_STARTS, sizeof *r->end);
    r->f = sp__take(a, points, 3 * sizeof *r->f);
    r->v = sp__take(a, (size_t)scene->count.blocks, 6 * sizeof *r->v);
    r->pressed = sp__take(a, points, 3 * sizeof *r->pressed);
    r->resting = sp__take(a, points, 3 * sizeof *r->resting);
}

/* A result of nothing found. */
static void sp__sliding_blank(const sp_scene *scene, const sp_limit_result *limit, const sp__sliding_kept *k,
                              sp_sliding_result *r)
{
    const size_t points = 3 * (size_t)scene->count.points;
    r->end = k->end; r->f = k->f; r->v = k->v; r->pressed = k->pressed; r->resting = k->resting;
    memset(r->end, 0, SP_SLIDING_STARTS * sizeof *r->end);
    memset(r->f, 0, points * sizeof *r->f);
    memset(r->v, 0, 6 * (size_t)scene->count.blocks * sizeof *r->v);
    memset(r->pressed, 0, points * sizeof *r->pressed);
    memset(r->resting, 0, points * sizeof *r->resting);
    r->associative = r->upper = limit->kind == SP_LIMIT_FOUND ? limit->upper : -1;
}

/* Bytes of the plane's rows and corners. */
SP__NOINLINE static size_t sp__sliding_slab_need(const sp_problem *pb)
{
    sp__slab w;
    sp_arena dry = sp__arena_dry();
    sp__slab_carve(&w, pb, &dry);
    return dry.used;
}

/* Bytes of what a result keeps. */
SP__NOINLINE static size_t sp__sliding_kept_need(const sp_scene *scene)
{
    sp__sliding_kept kept;
    sp_arena dry = sp__arena_dry();
    sp__sliding_keep(scene, &kept, &dry);
    return dry.used;
}

/* Bytes of what judges, or of a whole call. */
SP__NOINLINE static size_t sp__sliding_bytes(const sp_scene *scene, int search)
{
    sp_problem pb;
    sp__even even;
    sp_real *at[5];
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &pb);
    if (search) sp__take(&dry, 1, sp__sliding_kept_need(scene));
    sp__take(&dry, 1, sizeof(sp__sliding));
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp__bracket_carve(at, pb.blocks, &dry);
    sp__take(&dry, 1, sp__sliding_judge_need(&pb));
    sp__take(&dry, (size_t)pb.points, 3 * sizeof(sp_real));
    sp__take(&dry, (size_t)scene->count.blocks, 6 * sizeof(sp_real));
    sp__take(&dry, (size_t)pb.blocks, 6 * sizeof(sp_real));
    sp__take(&dry, (size_t)pb.points, 3 * sizeof(sp_real));
    sp__even_carve(&even, &pb, &dry);
    sp__take(&dry, 1, sp__sliding_slab_need(&pb));
    if (search) sp__take(&dry, 1, sp__sliding_search(pb.points, pb.blocks));
    return sp__failed(&dry) ? 0 : dry.used;
}

/* What may be spent: so many times the limit's own work. */
static int64_t sp__sliding_budget(const sp__sliding *s, int64_t work, int64_t flops)
{
    const int64_t budget = s->bracket.set.budget;
    int64_t limit = flops > INT64_MAX / 1000 ? INT64_MAX / 2 : work * flops;
    if (limit < SP__SLIDING_FLOPS) limit = SP__SLIDING_FLOPS;
    return budget > 0 && budget < limit ? budget : limit;
}

SP_API sp_status sp_sliding(const sp_scene *scene, const sp_settings *settings, const sp_sliding_settings *how,
                            const sp_limit_result *limit, sp_arena *arena, sp_sliding_result *result)
{
    const sp_sliding_settings plain = sp_sliding_settings_default();
    sp__sliding_kept keep;
    if (!how) how = &plain;
    if (!scene || !limit || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    if (how->starts < 0 || how->starts > SP_SLIDING_STARTS || how->work < 0 || how->work > 1000) return SP_E_RANGE;
    if (!sp__finite(limit->upper)) return SP_E_NOT_FINITE;
    sp_arena a = *arena;
    sp__sliding_keep(scene, &keep, &a);
    const size_t kept = a.used;
    sp__sliding *s = sp__take(&a, 1, sizeof *s);
    if (!s) return SP_E_MEMORY;
    const sp_status status = sp__sliding_open(s, scene, settings, &a);
    if (status) return status;
    sp_arena all = a;
    sp__take(&all, 1, sp__sliding_search(s->bracket.pb.points, s->bracket.pb.blocks));
    if (sp__failed(&all)) return SP_E_MEMORY;
    sp__sliding_blank(scene, limit, &keep, &s->r);
    s->limit = sp__sliding_budget(s, how->work, limit->cost.flops);
    sp__sliding_decide(s, how, &a);
    s->r.tol = s->bracket.set.tol;
    s->r.cost.flops = sp__sliding_flops(s);
    s->r.peak_bytes = arena->peak = all.peak;
    arena->used = kept;
    *result = s->r;
    return SP_OK;
}

/* Are there numbers only? */
static int sp__sliding_finite(const sp_scene *scene, const sp_sliding_result *r)
{
    const size_t points = 3 * (size_t)scene->count.points;
    return sp__finite(r->upper) && sp__finite(r->lower) && sp__finite(r->lower_strong) && sp__all_finite(r->f, points)
        && sp__all_finite(r->v, 6 * (size_t)scene->count.blocks) && sp__all_finite(r->pressed, points)
        && sp__all_finite(r->resting, points);
}

SP_API sp_status sp_sliding_verify(const sp_scene *scene, const sp_settings *settings, const sp_sliding_result *claim,
                                   sp_arena scratch, sp_sliding_evidence *evidence)
{
    if (!scene || !claim || !claim->f || !claim->v || !claim->pressed || !claim->resting || !evidence || !scratch.base)
        return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    if (!sp__sliding_finite(scene, claim)) return SP_E_NOT_FINITE;
    sp__sliding *s = sp__take(&scratch, 1, sizeof *s);
    if (!s) return SP_E_MEMORY;
    const sp_status status = sp__sliding_open(s, scene, settings, &scratch);
    if (status) return status;
    sp_sliding_evidence e = { 0, 0, 0, 0, 0 };
    if (!sp__scene_strong(scene)) {
        e.residual = sp__sliding_judge(s, claim->upper, claim->f, claim->v, &e.share);
        e.state = e.residual <= s->bracket.set.tol && e.share >= SP__SLIDES;
        if (claim->lower > 0 && sp__sliding_carries(s, claim->lower, claim->pressed)) e.lower = claim->lower;
        if (claim->lower_strong > 0 && sp__sliding_strong(s, claim->lower_strong, e.lower, claim->pressed, claim->resting))
            e.lower_strong = claim->lower_strong;
    }
    *evidence = e;
    return SP_OK;
}

#elif SP__WITH_STONES

static size_t sp__sliding_bytes(const sp_scene *scene, int search) { return (void)scene, (void)search, 0; }

#endif

#endif /* SP__SLIDING_SLIDING_C */
