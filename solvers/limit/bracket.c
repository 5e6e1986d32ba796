/* bracket: the certificate check of both ends of the bracket: forces at the lower, a collapse at the upper. */
#ifndef SP__LIMIT_BRACKET_C
#define SP__LIMIT_BRACKET_C

#include "../check/settings.c"

#if SP__WITH_LIMIT

/* What proves an end of the bracket, by the certificate check alone: forces that balance dead + lower live; a motion that falls
 * under dead + upper live and that live loads push on rather than hinder, so that it falls at every larger multiple, too;
 * forces that balance the live loads alone, which may be added to others as often as one likes (the cones are convex). */
typedef struct sp__bracket {
    sp_real *dead, *live;               /* 6b each */
    const sp_real *y0;                  /* 24b: hints for both; may be NULL */
    sp_real *hint;                      /* 12b: for the loads at hand */
    sp_real *dq, *whole;                /* 6b: the motion; with what is held in dq */
    sp_real imbalance, least, resist;       /* resist: work that joints with strength take of the motion certified last [N m] */
    int32_t final;
    int slight;                         /* a motion that no contact resists proves as sp_verify has it, within tol, too */
    int spent;                          /* a certificate check did not fit */
    int lacking;                        /* a search had no memory */
    int64_t limit;                      /* flops in all */
    sp_cost cost;
    sp_arena room;                      /* for certifying */
    sp_problem pb;                      /* p: some multiples of both loads */
    sp__certifier certifier;        /* the one at hand */
    sp_settings set, wide;              /* resolved; with a pyramid around the cone: `final` then tells of it */
    sp_scene scene;                     /* without live loads in p */
} sp__bracket;

/* dead, live, dq, whole, hint */
static void sp__bracket_carve(sp_real *at[5], int32_t blocks, sp_arena *a)
{
    for (int k = 0; k < 5; k++) at[k] = sp__take(a, (size_t)blocks, (k < 4 ? 6 : 12) * sizeof *at[k]);
}

/* Settings resolved, problem built, both loads apart. */
static sp_status sp__bracket_build(const sp_scene *scene, const sp_settings *settings, sp__bracket *b, sp_arena *a)
{
    memset(b, 0, sizeof *b);
    b->scene = *scene;
    b->scene.live = 0;
    sp_status status = sp__settings_resolve(scene, settings, &b->set);
    if (!status && b->set.coupled.asked) status = SP_E_UNSUPPORTED;
    if (!status) status = sp_problem_build(&b->scene, a, &b->pb);
    if (status) return status;
    b->wide = b->set;
    b->wide.inscribed = 0;
    b->limit = b->set.budget > 0 ? b->set.budget : INT64_MAX / 4;
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

/* Are there hints? SP_SMALL makes none and takes none. */
static int sp__bracket_has_hint(const sp__bracket *b) { return SP__WITH_INTERIOR && b->y0; }

/* p = d dead + l live. Live loads without dead ones stand for ever more of them:
 * what they want of joints is there without end. */
static void sp__bracket_load(sp__bracket *b, sp_real d, sp_real l)
{
    const size_t n = 6 * (size_t)b->pb.blocks;
    b->pb.ignore_strength = !(d > 0);
    for (size_t k = 0; k < n; k++) b->pb.p[k] = d * b->dead[k] + l * b->live[k];
    for (size_t k = 0; k < 2 * n && sp__bracket_has_hint(b); k++) b->hint[k] = d * b->y0[k] + l * b->y0[2 * n + k];
}

/* Passes over the vertices that are left of the budget; SP_SMALL refuses budgets. */
static int32_t sp__bracket_sweeps(const sp__bracket *b)
{
    if (!SP__WITH_INTERIOR || b->pb.points < 1) return INT32_MAX;
    const int64_t sweeps = (b->limit - b->cost.flops) / (SP__FLOPS_CERTIFICATE * (int64_t)b->pb.points) - 8;
    return sweeps > INT32_MAX ? INT32_MAX : sweeps < 2 ? 0 : (int32_t)sweeps;
}

/* A certificate check for d dead + l live, while ten passes and more are left; what it took is counted when it is closed. */
static int sp__bracket_certify_begin(sp__bracket *b, sp_real d, sp_real l)
{
    const int32_t sweeps = sp__bracket_sweeps(b);
    sp_arena room = b->room;
    if (!sweeps) { b->spent = 1; return 0; }
    sp__bracket_load(b, d, l);
    return sp__certifier_open(&b->certifier, &b->pb, &b->set, sp__bracket_has_hint(b) ? b->hint : NULL, sweeps, &room);
}

/* Counts what the certificate check took. */
SP__NOINLINE_SMALL static void sp__bracket_certify_end(sp__bracket *b)
{
    if (SP__WITH_INTERIOR) b->cost.flops += SP__FLOPS_CERTIFICATE * (int64_t)b->certifier.sweeps * b->pb.points;
}

/* Do these forces balance d dead + l live?     admitted: as sp__certify_forces */
SP__NOINLINE static int sp__bracket_stands(sp__bracket *b, sp_real d, sp_real l, const sp_real *f, sp_real *admitted)
{
    if (!sp__bracket_certify_begin(b, d, l)) return 0;
    b->imbalance = sp__certify_forces(&b->certifier, f, admitted);
    sp__bracket_certify_end(b);
    return b->imbalance <= b->set.tol;
}

/* load . dq */
static sp_real sp__bracket_work(const sp__bracket *b, const sp_real *load)
{
    return sp__dot(load, b->dq, 6 * (size_t)b->pb.blocks);
}

/* Where it falls, does it fall at every larger multiple, too? Live loads push on it, more than joints resist without end; or
 * nothing resists it but strength, and they hinder it so little that force_bound times a multiple at which they are as large as
 * the dead ones does not hold it. */
SP__NOINLINE static int sp__bracket_falls_beyond(sp__bracket *b)
{
    int32_t final;
    if (!b->pb.live) return 1;
    sp__bracket_load(b, 1, 0);
    const sp_real dead = sp__load_unit(&b->pb);
    if (!sp__bracket_certify_begin(b, 0, 1)) return 0;
    b->certifier.set = &b->wide;
    const int pushes = sp__certify_motion(&b->certifier, b->dq, 0, 0, &final) > 0;
    sp__bracket_certify_end(b);
    if (pushes) return 1;
    const sp_real ratio = sp__ratio(dead, b->certifier.unit);
    if (!final || (b->resist > 0 && !b->final)) return 0;
    return sp__bracket_work(b, b->dead) - b->resist + b->set.force_bound * ratio * sp__bracket_work(b, b->live) >= 0;
}

#endif

#endif /* SP__LIMIT_BRACKET_C */
