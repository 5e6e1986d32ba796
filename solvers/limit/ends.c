/* ends: what proves each end of the bracket */
#ifndef SP__LIMIT_ENDS_C
#define SP__LIMIT_ENDS_C

#include "../check/settings.c"

#if SP__WITH_LIMIT

/* What proves an end of the bracket, by the certificate check alone: forces that balance dead + lower live; a motion that falls
 * under dead + upper live and that live loads push on rather than hinder, so that it falls at every larger multiple, too;
 * forces that balance the live loads alone, which may be added to others as often as one likes (the cones are convex). */
typedef struct sp__ends {
    sp_settings set, wide;              /* resolved; with a pyramid around the cone: `final` then tells of it */
    sp_scene scene;                     /* without live loads in p */
    sp_problem pb;                      /* p: some multiples of both loads */
    sp_real *dead, *live;               /* 6b each */
    const sp_real *y0;                  /* 24b: hints for both; may be NULL */
    sp_real *hint;                      /* 12b: for the loads at hand */
    sp_real *dq, *whole;                /* 6b: the motion; with what is held in dq */
    sp_real omega, least, resist;       /* resist: work that joints with strength take of the motion judged last [N m] */
    int32_t final;
    int64_t limit;                      /* flops in all */
    sp_cost cost;
    int spent;                          /* a judgement did not fit */
    sp__certificate certificate;                    /* the one at hand */
} sp__ends;

/* dead, live, dq, whole, hint */
static void sp__ends_carve(sp_real *at[5], int32_t blocks, sp_arena *a)
{
    for (int k = 0; k < 5; k++) at[k] = sp__take(a, (size_t)blocks, (k < 4 ? 6 : 12) * sizeof *at[k]);
}

static sp_status sp__ends_build(const sp_scene *scene, const sp_settings *settings, sp__ends *e, sp_arena *a)
{
    e->scene = *scene;
    e->scene.live = 0;
    sp_status status = sp__settings_resolve(scene, settings, &e->set);
    if (!status && e->set.coupled.asked) status = SP_E_UNSUPPORTED;
    if (!status) status = sp_problem_build(&e->scene, a, &e->pb);
    if (status) return status;
    e->wide = e->set;
    e->wide.inscribed = 0;
    e->limit = e->set.budget > 0 ? e->set.budget : INT64_MAX / 4;
    memset(&e->cost, 0, sizeof e->cost);
    e->spent = 0;
    e->resist = 0;
    sp_real *at[5];
    sp__ends_carve(at, e->pb.blocks, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    e->dead = at[0]; e->live = at[1]; e->dq = at[2]; e->whole = at[3]; e->hint = at[4];
    const size_t bytes = 6 * (size_t)e->pb.blocks * sizeof *e->dead;
    memcpy(e->dead, e->pb.p, bytes);
    if (e->pb.live) memcpy(e->live, e->pb.live, bytes); else memset(e->live, 0, bytes);
    memset(e->dq, 0, bytes);
    return SP_OK;
}

/* p = d dead + l live. Live loads without dead ones stand for ever more of them: what they want of joints is there without end. */
static void sp__ends_mix(sp__ends *e, sp_real d, sp_real l)
{
    const size_t n = 6 * (size_t)e->pb.blocks;
    e->pb.ignore_strength = !(d > 0);
    for (size_t k = 0; k < n; k++) e->pb.p[k] = d * e->dead[k] + l * e->live[k];
    for (size_t k = 0; k < 2 * n && e->y0; k++) e->hint[k] = d * e->y0[k] + l * e->y0[2 * n + k];
}

/* A certificate check for d dead + l live, while ten sweeps and more are left of the budget; what it took is counted when it is closed. */
static int sp__ends_open(sp__ends *e, sp_real d, sp_real l, sp_arena *room)
{
    const int64_t sweep = SP__FLOPS_CERTIFICATE * (int64_t)e->pb.points, left = e->limit - e->cost.flops;
    const int64_t sweeps = sweep ? left / sweep - 8 : INT32_MAX;
    if (sweeps < 2) { e->spent = 1; return 0; }
    sp__ends_mix(e, d, l);
    return sp__certificate_open(&e->certificate, &e->pb, &e->set, e->y0 ? e->hint : NULL, sweeps < INT32_MAX ? (int32_t)sweeps : INT32_MAX,
                          room);
}

SP__NOINLINE_SMALL static void sp__ends_close(sp__ends *e)
{
    e->cost.flops += SP__FLOPS_CERTIFICATE * (int64_t)e->certificate.sweeps * e->pb.points;
}

/* Do these forces balance d dead + l live?     admitted: as sp__certify_forces */
SP__NOINLINE static int sp__ends_stand(sp__ends *e, sp_real d, sp_real l, const sp_real *f, sp_real *admitted, sp_arena room)
{
    if (!sp__ends_open(e, d, l, &room)) return 0;
    e->omega = sp__certify_forces(&e->certificate, f, admitted);
    sp__ends_close(e);
    return e->omega <= e->set.tol;
}

static sp_real sp__ends_work(const sp__ends *e, const sp_real *load)
{
    return sp__dot(load, e->dq, 6 * (size_t)e->pb.blocks);
}

/* Where it falls, does it fall at every larger multiple, too? Live loads push on it, more than joints resist without end; or
 * nothing resists it but strength, and they hinder it so little that force_bound times a multiple at which they are as large as
 * the dead ones does not hold it. */
SP__NOINLINE static int sp__ends_beyond(sp__ends *e, sp_arena room)
{
    int32_t final;
    if (!e->pb.live) return 1;
    sp__ends_mix(e, 1, 0);
    const sp_real dead = sp__load_unit(&e->pb);
    if (!sp__ends_open(e, 0, 1, &room)) return 0;
    e->certificate.set = &e->wide;
    const int pushes = sp__certify_motion(&e->certificate, e->dq, 0, &final) > 0;
    sp__ends_close(e);
    if (pushes) return 1;
    const sp_real ratio = sp__ratio(dead, e->certificate.unit);
    if (!final || (e->resist > 0 && !e->final)) return 0;
    return sp__ends_work(e, e->dead) - e->resist + e->set.force_bound * ratio * sp__ends_work(e, e->live) >= 0;
}

#ifdef SP_SMALL
/* Does e->dq fall at lambda, and at every larger one, too? What moves in the best proof stays in e->dq, and in `all` (may be NULL)
 * as a result has it. */
SP__NOINLINE static int sp__ends_fall(sp__ends *e, sp_real lambda, int beyond, sp_real *all, sp_arena room)
{
    sp_arena again = room;
    if (!sp__ends_open(e, 1, lambda, &again)) return 0;
    e->least = sp__certify_mechanism(&e->certificate, e->dq, &e->final);
    if (!(e->least > e->set.tol)) return 0;
    if (all) sp__check_motion(&e->certificate, all);
    memcpy(e->dq, e->certificate.x, 6 * (size_t)e->pb.blocks * sizeof *e->dq);
    return !beyond || sp__ends_beyond(e, room);
}
#else
/* The motion just judged into e->dq, and what joints with strength take of it. */
static void sp__ends_keep(sp__ends *e)
{
    e->resist = sp__problem_strong(&e->pb) ? e->certificate.resist * e->certificate.unit : 0;
    memcpy(e->dq, e->certificate.x, 6 * (size_t)e->pb.blocks * sizeof *e->dq);
    sp__ends_close(e);
}

/* Does e->dq fall at lambda, with smaller motions held as sp__certify_mechanism may, and if `beyond` at every larger one, too?
 * What moves in that proof stays in e->dq, and in `all` (may be NULL) as a result has it. */
SP__NOINLINE static int sp__ends_fall(sp__ends *e, sp_real lambda, int beyond, sp_real *all, sp_arena room)
{
    const size_t bytes = 6 * (size_t)e->pb.blocks * sizeof *e->dq;
    sp_real value[6] = { 0, 0, 0, 0, 0, 0 };
    int32_t final[6] = { 0, 0, 0, 0, 0, 0 };
    memcpy(e->whole, e->dq, bytes);
    for (int pass = 0; pass < 7; pass++) {
        sp_arena again = room;
        sp__certificate *j = &e->certificate;
        int k = 0;
        if (!sp__ends_open(e, 1, lambda, &again)) return 0;
        if (pass == 0) {
            for (k = 0; k < 6; k++) value[k] = sp__certify_motion(j, e->whole, sp__certify_rest[k], &final[k]);
            sp__ends_close(e);
            continue;
        }
        for (int q = 1; q < 6; q++) {                   /* a final proof before others, then the best */
            const int proof = value[q] > e->set.tol, before = value[k] > e->set.tol;
            if (proof && (!before || final[q] > final[k] || (final[q] == final[k] && value[q] > value[k]))) k = q;
        }
        if (!(value[k] > e->set.tol)) break;
        e->least = sp__certify_motion(j, e->whole, sp__certify_rest[k], &e->final);
        if (all) sp__check_motion(j, all);
        sp__ends_keep(e);
        if (!beyond || sp__ends_beyond(e, room)) return 1;
        value[k] = 0;
    }
    memcpy(e->dq, e->whole, bytes);
    return 0;
}
#endif

/* By how much the multiplier may be off. dq proves (upper - balance) live . dq = least scale, and forces within tol carry at most
 * tol scale / (live . dq) more than they should. */
static sp_real sp__ends_within(const sp_limit_result *r, sp_real balance)
{
    return r->upper - r->lower + r->tol * sp__ratio(r->upper - balance, r->least_imbalance);
}

/* Every end that the claim has. */
SP__NOINLINE static int sp__ends_hold(sp__ends *e, const sp_limit_result *r, sp_arena room)
{
    if (r->kind == SP_LIMIT_UNBOUNDED && !sp__ends_stand(e, 0, 1, r->ray, NULL, room)) return 0;
    if (r->kind != SP_LIMIT_NONE && r->lower < 0) return 0;
    if (r->kind == SP_LIMIT_FOUND && !(r->lower <= r->upper)) return 0;
    if (r->kind != SP_LIMIT_NONE && !sp__ends_stand(e, 1, r->lower, r->f, NULL, room)) return 0;
    if (r->kind == SP_LIMIT_UNBOUNDED) return 1;
    sp__verify_motion(&e->pb, r->dq, e->dq);
    return sp__ends_fall(e, r->kind == SP_LIMIT_NONE ? 0 : r->upper, 1, NULL, room);
}

SP_API size_t sp_limit_verify_memory(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp_real *at[5];
    sp__certificate j;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &pb);
    sp__take(&dry, 1, sizeof(sp__ends));
    sp__take(&dry, 1, sp_problem_memory(scene));
    sp__ends_carve(at, pb.blocks, &dry);
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
    sp__ends *e = sp__take(&scratch, 1, sizeof *e);
    if (!e) return SP_E_MEMORY;
    const sp_status status = sp__ends_build(scene, settings, e, &scratch);
    if (status) return status;
    e->y0 = claim->y0;
    sp_arena room = scratch;
    sp__take(&room, 1, sp__certificate_need(&e->pb, &e->set));
    if (sp__failed(&room)) return SP_E_MEMORY;
    *held = claim->kind != SP_LIMIT_UNDECIDED && sp__ends_hold(e, claim, scratch);
    return SP_OK;
}

#endif

#endif /* SP__LIMIT_ENDS_C */
