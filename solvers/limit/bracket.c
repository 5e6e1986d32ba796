/* bracket: what proves each end of the bracket */
#ifndef SP__LIMIT_BRACKET_C
#define SP__LIMIT_BRACKET_C

#include "../check/settings.c"

#if SP__WITH_LIMIT

/* What proves an end of the bracket, by the certificate check alone: forces that balance dead + lower live; a motion that falls
 * under dead + upper live and that live loads push on rather than hinder, so that it falls at every larger multiple, too;
 * forces that balance the live loads alone, which may be added to others as often as one likes (the cones are convex). */
typedef struct sp__bracket {
    sp_settings set, wide;              /* resolved; with a pyramid around the cone: `final` then tells of it */
    sp_scene scene;                     /* without live loads in p */
    sp_problem pb;                      /* p: some multiples of both loads */
    sp_real *dead, *live;               /* 6b each */
    const sp_real *y0;                  /* 24b: hints for both; may be NULL */
    sp_real *hint;                      /* 12b: for the loads at hand */
    sp_real *dq, *whole;                /* 6b: the motion; with what is held in dq */
    sp_real imbalance, least, resist;       /* resist: work that joints with strength take of the motion judged last [N m] */
    int32_t final;
    int64_t limit;                      /* flops in all */
    sp_cost cost;
    int spent;                          /* a judgement did not fit */
    sp__certificate certificate;                    /* the one at hand */
} sp__bracket;

/* dead, live, dq, whole, hint */
static void sp__bracket_carve(sp_real *at[5], int32_t blocks, sp_arena *a)
{
    for (int k = 0; k < 5; k++) at[k] = sp__take(a, (size_t)blocks, (k < 4 ? 6 : 12) * sizeof *at[k]);
}

static sp_status sp__bracket_build(const sp_scene *scene, const sp_settings *settings, sp__bracket *b, sp_arena *a)
{
    b->scene = *scene;
    b->scene.live = 0;
    sp_status status = sp__settings_resolve(scene, settings, &b->set);
    if (!status && b->set.coupled.asked) status = SP_E_UNSUPPORTED;
    if (!status) status = sp_problem_build(&b->scene, a, &b->pb);
    if (status) return status;
    b->wide = b->set;
    b->wide.inscribed = 0;
    b->limit = b->set.budget > 0 ? b->set.budget : INT64_MAX / 4;
    memset(&b->cost, 0, sizeof b->cost);
    b->spent = 0;
    b->resist = 0;
    b->y0 = NULL;
    sp_real *at[5];
    sp__bracket_carve(at, b->pb.blocks, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    b->dead = at[0]; b->live = at[1]; b->dq = at[2]; b->whole = at[3]; b->hint = at[4];
    const size_t bytes = 6 * (size_t)b->pb.blocks * sizeof *b->dead;
    memcpy(b->dead, b->pb.p, bytes);
    if (b->pb.live) memcpy(b->live, b->pb.live, bytes); else memset(b->live, 0, bytes);
    memset(b->dq, 0, bytes);
    return SP_OK;
}

/* p = d dead + l live. Live loads without dead ones stand for ever more of them: what they want of joints is there without end. */
static void sp__bracket_load(sp__bracket *b, sp_real d, sp_real l)
{
    const size_t n = 6 * (size_t)b->pb.blocks;
    b->pb.ignore_strength = !(d > 0);
    for (size_t k = 0; k < n; k++) b->pb.p[k] = d * b->dead[k] + l * b->live[k];
    for (size_t k = 0; k < 2 * n && b->y0; k++) b->hint[k] = d * b->y0[k] + l * b->y0[2 * n + k];
}

/* A certificate check for d dead + l live, while ten sweeps and more are left of the budget; what it took is counted when it is closed. */
static int sp__bracket_judge_open(sp__bracket *b, sp_real d, sp_real l, sp_arena *room)
{
    const int64_t sweep = SP__FLOPS_CERTIFICATE * (int64_t)b->pb.points, left = b->limit - b->cost.flops;
    const int64_t sweeps = sweep ? left / sweep - 8 : INT32_MAX;
    if (sweeps < 2) { b->spent = 1; return 0; }
    sp__bracket_load(b, d, l);
    return sp__certificate_open(&b->certificate, &b->pb, &b->set, b->y0 ? b->hint : NULL, sweeps < INT32_MAX ? (int32_t)sweeps : INT32_MAX,
                          room);
}

SP__NOINLINE_SMALL static void sp__bracket_judge_close(sp__bracket *b)
{
    b->cost.flops += SP__FLOPS_CERTIFICATE * (int64_t)b->certificate.sweeps * b->pb.points;
}

/* Do these forces balance d dead + l live?     admitted: as sp__certify_forces */
SP__NOINLINE static int sp__bracket_stands(sp__bracket *b, sp_real d, sp_real l, const sp_real *f, sp_real *admitted, sp_arena room)
{
    if (!sp__bracket_judge_open(b, d, l, &room)) return 0;
    b->imbalance = sp__certify_forces(&b->certificate, f, admitted);
    sp__bracket_judge_close(b);
    return b->imbalance <= b->set.tol;
}

static sp_real sp__bracket_work(const sp__bracket *b, const sp_real *load)
{
    return sp__dot(load, b->dq, 6 * (size_t)b->pb.blocks);
}

/* Where it falls, does it fall at every larger multiple, too? Live loads push on it, more than joints resist without end; or
 * nothing resists it but strength, and they hinder it so little that force_bound times a multiple at which they are as large as
 * the dead ones does not hold it. */
SP__NOINLINE static int sp__bracket_falls_beyond(sp__bracket *b, sp_arena room)
{
    int32_t final;
    if (!b->pb.live) return 1;
    sp__bracket_load(b, 1, 0);
    const sp_real dead = sp__load_unit(&b->pb);
    if (!sp__bracket_judge_open(b, 0, 1, &room)) return 0;
    b->certificate.set = &b->wide;
    const int pushes = sp__certify_motion(&b->certificate, b->dq, 0, &final) > 0;
    sp__bracket_judge_close(b);
    if (pushes) return 1;
    const sp_real ratio = sp__ratio(dead, b->certificate.unit);
    if (!final || (b->resist > 0 && !b->final)) return 0;
    return sp__bracket_work(b, b->dead) - b->resist + b->set.force_bound * ratio * sp__bracket_work(b, b->live) >= 0;
}

#ifdef SP_SMALL
/* Does b->dq fall at lambda, and at every larger one, too? What moves in the best proof stays in b->dq, and in `all` (may be NULL)
 * as a result has it. */
SP__NOINLINE static int sp__bracket_falls(sp__bracket *b, sp_real lambda, int beyond, sp_real *all, sp_arena room)
{
    sp_arena again = room;
    if (!sp__bracket_judge_open(b, 1, lambda, &again)) return 0;
    b->least = sp__certify_mechanism(&b->certificate, b->dq, &b->final);
    if (!(b->least > b->set.tol)) return 0;
    if (all) sp__check_motion(&b->certificate, all);
    memcpy(b->dq, b->certificate.x, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    return !beyond || sp__bracket_falls_beyond(b, room);
}
#else
/* The motion just judged into b->dq, and what joints with strength take of it. */
static void sp__bracket_keep(sp__bracket *b)
{
    b->resist = sp__problem_strong(&b->pb) ? b->certificate.resist * b->certificate.unit : 0;
    memcpy(b->dq, b->certificate.x, 6 * (size_t)b->pb.blocks * sizeof *b->dq);
    sp__bracket_judge_close(b);
}

/* Does b->dq fall at lambda, with smaller motions held as sp__certify_mechanism may, and if `beyond` at every larger one, too?
 * What moves in that proof stays in b->dq, and in `all` (may be NULL) as a result has it. */
SP__NOINLINE static int sp__bracket_falls(sp__bracket *b, sp_real lambda, int beyond, sp_real *all, sp_arena room)
{
    const size_t bytes = 6 * (size_t)b->pb.blocks * sizeof *b->dq;
    sp_real value[6] = { 0, 0, 0, 0, 0, 0 };
    int32_t final[6] = { 0, 0, 0, 0, 0, 0 };
    memcpy(b->whole, b->dq, bytes);
    for (int pass = 0; pass < 7; pass++) {
        sp_arena again = room;
        sp__certificate *j = &b->certificate;
        int k = 0;
        if (!sp__bracket_judge_open(b, 1, lambda, &again)) return 0;
        if (pass == 0) {
            for (k = 0; k < 6; k++) value[k] = sp__certify_motion(j, b->whole, sp__certify_rest[k], &final[k]);
            sp__bracket_judge_close(b);
            continue;
        }
        for (int q = 1; q < 6; q++) {                   /* a final proof before others, then the best */
            const int proof = value[q] > b->set.tol, before = value[k] > b->set.tol;
            if (proof && (!before || final[q] > final[k] || (final[q] == final[k] && value[q] > value[k]))) k = q;
        }
        if (!(value[k] > b->set.tol)) break;
        b->least = sp__certify_motion(j, b->whole, sp__certify_rest[k], &b->final);
        if (all) sp__check_motion(j, all);
        sp__bracket_keep(b);
        if (!beyond || sp__bracket_falls_beyond(b, room)) return 1;
        value[k] = 0;
    }
    memcpy(b->dq, b->whole, bytes);
    return 0;
}
#endif

/* By how much the multiplier may be off. dq proves (upper - balance) live . dq = least scale, and forces within tol carry at most
 * tol scale / (live . dq) more than they should. */
static sp_real sp__bracket_within(const sp_limit_result *r, sp_real balance)
{
    return r->upper - r->lower + r->tol * sp__ratio(r->upper - balance, r->least_imbalance);
}

/* Every end that the claim has. */
SP__NOINLINE static int sp__bracket_holds(sp__bracket *b, const sp_limit_result *r, sp_arena room)
{
    if (r->kind == SP_LIMIT_UNBOUNDED && !sp__bracket_stands(b, 0, 1, r->ray, NULL, room)) return 0;
    if (r->kind != SP_LIMIT_NONE && r->lower < 0) return 0;
    if (r->kind == SP_LIMIT_FOUND && !(r->lower <= r->upper)) return 0;
    if (r->kind != SP_LIMIT_NONE && !sp__bracket_stands(b, 1, r->lower, r->f, NULL, room)) return 0;
    if (r->kind == SP_LIMIT_UNBOUNDED) return 1;
    sp__verify_motion(&b->pb, r->dq, b->dq);
    return sp__bracket_falls(b, r->kind == SP_LIMIT_NONE ? 0 : r->upper, 1, NULL, room);
}

static size_t sp__limit_verify_memory(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp_real *at[5];
    sp__certificate j;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &pb);
    sp__take(&dry, 1, sizeof(sp__bracket));
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp__bracket_carve(at, pb.blocks, &dry);
    sp_arena certificate = sp__arena_dry();
    sp__certificate_carve(&j, &pb, SP__FACES_MAX, &certificate);
    sp__take(&dry, 1, certificate.peak);
    return sp__failed(&dry) ? 0 : dry.used;
}

SP_API sp_status sp_limit_verify(const sp_scene *scene, const sp_settings *settings, const sp_limit_result *claim,
                                 sp_arena scratch, int32_t *held)
{
    if (!scene || !claim || !claim->f || !claim->ray || !claim->dq || !held || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    if (!sp__finite(claim->lower) || !sp__finite(claim->upper)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->f, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->ray, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->dq, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    sp__bracket *b = sp__take(&scratch, 1, sizeof *b);
    if (!b) return SP_E_MEMORY;
    const sp_status status = sp__bracket_build(scene, settings, b, &scratch);
    if (status) return status;
    b->y0 = claim->y0;
    sp_arena room = scratch;
    sp__take(&room, 1, sp__certificate_need(&b->pb, &b->set));
    if (sp__failed(&room)) return SP_E_MEMORY;
    *held = claim->kind != SP_LIMIT_UNDECIDED && sp__bracket_holds(b, claim, scratch);
    return SP_OK;
}

#endif

#endif /* SP__LIMIT_BRACKET_C */
