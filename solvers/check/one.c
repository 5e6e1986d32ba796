/* one: the check of one part */
#ifndef SP__CHECK_ONE_C
#define SP__CHECK_ONE_C

#include "../statics/penalty.c"
#include "../coupled/coupled.c"
#include "ladder.c"

#if SP__WITH_LARGE

/* Where tension is wanted, of what did not turn out stable. */
SP__NOINLINE static sp_status sp__check_demand(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *a, sp_result *r)
{
    memset(&state->cost, 0, sizeof state->cost);
    state->left = sp__budget_left(set, r);
    sp_arena room = sp__work_open(set, a);
    const sp_status status = sp__penalty_run(pb, set, state, &room, r->demand);
    sp__cost_add(&r->cost, &state->cost);
    sp__work_close(set, a, &room);
    return status;
}

/* The ladder of stages on a built problem, then the localisation where it does not stand. */
static sp_status sp__check_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *a, sp_result *r)
{
    int done = 0;
    for (int32_t k = 0; k < set->stage_count && !done; k++) {
        sp_status status = SP_OK;
        if (SP__WITH_PLAN && set->stage[k] == SP_STAGE_EXACT) status = sp__check_reduced(pb, set, k, state, a, r, &done);
        if (!status && !done && r->reason != SP_REASON_EFFECT) status = sp__check_stage(pb, set, k, state, a, r, &done);
        if (status) return status;
    }
    if (r->verdict == SP_STABLE || r->reason == SP_REASON_STAGES || !set->localise) return SP_OK;
    return sp__check_demand(pb, set, state, a, r);
}

#ifndef SP_NO_CRA
/* eps and eta in force. */
SP__NOINLINE static void sp__coupled_told_lengths(sp__check *c)
{
    const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
    c->r.coupled.eps = k.eps > 0 ? k.L : 0;
    c->r.coupled.eta = k.L * k.eta;
}

/* The coupled check, where forces were found; its answer, its cost and its forces into the result. */
SP__NOINLINE static sp_status sp__check_coupled(sp__check *c, sp_arena *a)
{
    sp_result *r = &c->r;
    sp_coupled *out = &r->coupled;
    const size_t mark = a->used;
    sp_status status = SP_OK;
    sp__coupled_told_lengths(c);
    c->state.left = sp__budget_left(&c->set, r);
    c->state.f = r->f;                                  /* also on a budget */
    if (r->verdict == SP_STABLE) memset(r->dq, 0, 6 * (size_t)c->pb.scene->count.blocks * sizeof *r->dq);
    out->verdict = r->verdict == SP_UNSTABLE ? SP_COUPLING_REFUTED : SP_COUPLING_NOT_FOUND;
    out->reason = r->verdict == SP_STABLE ? SP_COUPLING_BUDGET : SP_COUPLING_STATICS;
    if (!c->pb.blocks) {
        out->verdict = SP_COUPLING_COUPLED;
        out->reason = SP_COUPLING_MOTION;
    } else if (c->state.left >= 10 * SP__FLOPS_CERTIFICATE * (int64_t)c->pb.points && (r->verdict == SP_STABLE || c->set.localise))
        status = sp__coupled_run(&c->pb, &c->set, &c->state, a, r);
    a->used = mark;
    sp__cost_add(&r->cost, &out->cost);
    if (out->verdict == SP_COUPLING_COUPLED && c->pb.blocks && !out->rounds) r->effect[SP_EFFECT_COUPLED] = SP_WHY_FOREST;
    return status;
}

/* What that makes of the verdict of statics.     returns 1: another one */
static int sp__coupled_told(const sp_settings *set, sp_coupling coupling, sp_coupling_reason why, sp_verdict *verdict,
                            sp_reason *reason)
{
    if (coupling <= SP_COUPLING_COUPLED || why == SP_COUPLING_STATICS) return 0;
    const int refuted = coupling == SP_COUPLING_REFUTED;
    *verdict = refuted ? SP_UNSTABLE : SP_UNDECIDED;
    *reason = refuted ? SP_REASON_NO_MOTION : set->effect[SP_EFFECT_DEPTH] == SP_WITHOUT ? SP_REASON_EFFECT : SP_REASON_NOT_COUPLED;
    return 1;
}
#endif

/* An empty result of this scene in c->r, its arrays zero. */
static void sp__check_clear(const sp_scene *scene, sp__check *c)
{
    sp_result *r = &c->r;
    const size_t b = (size_t)c->pb.blocks;
    memset(r->f, 0, 3 * (size_t)scene->count.points * sizeof *r->f);
    memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    memset(r->y0, 0, 12 * b * sizeof *r->y0);
    memset(r->demand, 0, (size_t)scene->count.joints * sizeof *r->demand);
    if (r->coupled.dq) memset(r->coupled.dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->coupled.dq);
    if (r->coupled.alpha) memset(r->coupled.alpha, 0, (size_t)scene->count.points * sizeof *r->coupled.alpha);
    r->tension_ratio = r->coupled.tension_ratio = -1;
    if (r->coupled.penalty) memset(r->coupled.penalty, 0, 4 * (size_t)scene->count.points * sizeof *r->coupled.penalty);
    if (c->set.budget > 0 || c->set.effect[SP_EFFECT_DEPTH] == SP_WITHOUT) r->imbalance = b ? 1 : 0;     /* of no forces at all */
    r->tol = c->set.tol;
    r->force_bound = c->set.force_bound;
    r->free_blocks = c->pb.blocks;
    r->joints = c->pb.contacts;
    r->points = sp__points_count(scene);
    r->verdict = b ? SP_UNDECIDED : SP_STABLE;
    r->reason = b ? SP_REASON_STAGES : SP_REASON_NOTHING;
    r->verified = !b;
    r->islands = b ? 1 : 0;
}

/* Everything of a check in arena `a` but the problem; `a` may be used up.
 *   out    *check: where the result is found on SP_OK */
SP__NOINLINE static sp_status sp__check_open(const sp_scene *scene, const sp_settings *settings, const sp__apart *apart, sp_arena *a,
                                          sp__check **check)
{
    sp_problem count;
    sp__kept arrays;
    sp__problem_count(scene, &count);
    sp__kept_carve(&arrays, scene, count.blocks, apart, settings, a);
    const size_t all = a->used;
    sp__check *c = sp__take(a, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    memset(c, 0, sizeof *c);
    c->pb = count;
    c->r.f = arrays.f; c->r.dq = arrays.dq; c->r.y0 = arrays.y0; c->r.demand = arrays.demand;
    c->r.island = arrays.island; c->r.part = arrays.part;
    c->r.coupled.dq = arrays.cdq;
    c->r.coupled.alpha = arrays.alpha;
    c->r.coupled.penalty = arrays.penalty;
    c->r.coupled.proof = arrays.proof;
    c->arrays = arrays.used;
    c->kept = all;
    const sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (status) return status;
    sp__check_clear(scene, c);
    *check = c;
    return SP_OK;
}

/* The problem and the potential of the search behind it. */
static sp_status sp__check_problem(sp__check *c, sp_arena *a)
{
    const sp_status status = sp_problem_build(c->pb.scene, a, &c->pb);
    if (status) return status;
    sp_state *state = &c->state;
    sp__state_carve(state, &c->pb, &c->set, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    const size_t b = 6 * (size_t)c->pb.blocks;
    memset(state->y, 0, b * sizeof *state->y);
    state->reason = SP_REASON_STAGES;
    state->tension_ratio = -1;
    state->y0 = c->r.y0;
    if (c->set.budget > 0) {
        memset(state->f, 0, 3 * (size_t)c->pb.points * sizeof *state->f);
        memset(state->dq, 0, b * sizeof *state->dq);
        return SP_OK;
    }
    state->f = c->r.f;
    state->dq = c->r.dq;                                /* free blocks first; spread over the scene's once it is a proof */
    return SP_OK;
}

#endif

#endif /* SP__CHECK_ONE_C */
