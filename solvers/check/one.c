/* one: the check of one part of a scene: stages, then help where it does not stand, then the coupled check. */
#ifndef SP__CHECK_ONE_C
#define SP__CHECK_ONE_C

#include "../statics/penalty.c"
#include "../coupled/coupled.c"
#include "ladder.c"

#if SP__WITH_LARGE

/* Where tension is missing in a part that is not stable: the penalty form's demand on each joint. */
SP__NOINLINE static sp_status sp__find_help(const sp_problem *pb, const sp_settings *set, sp_state *state,
                                                       sp_arena *a, sp_result *r)
{
    memset(&state->cost, 0, sizeof state->cost);
    state->left = sp__budget_left(set, r);
    sp_arena room = sp__work_open(set, a);
    const sp_status status = sp__penalty_run(pb, set, r->least_imbalance, state, &room, r->demand);
    sp__cost_add(&r->spent.total, &state->cost);
    sp__work_close(set, a, &room);
    return status;
}

/* Can a pull at some joint hold it? Not stones without a path to a support, nor where no stage was to be asked. */
static int sp__may_be_helped(const sp_result *r)
{
    return r->verdict != SP_STABLE && r->reason != SP_REASON_STAGES && sp__has_paths(r->reason);
}

/* The ladder of stages on a built problem, then the localisation where it does not stand. */
static sp_status sp__run_stages(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *a, sp_result *r)
{
    int done = 0;
    for (int32_t k = 0; k < set->stage_count && !done; k++) {
        sp_status status = SP_OK;
        if (SP__WITH_REDUCTION && set->stage[k] == SP_STAGE_EXACT) status = sp__run_reduced(pb, set, k, state, a, r, &done);
        if (!status && !done && r->reason != SP_REASON_EFFECT) status = sp__run_stage(pb, set, k, state, a, r, &done);
        if (status) return status;
    }
    if (!set->localise || !sp__may_be_helped(r)) return SP_OK;
    return sp__find_help(pb, set, state, a, r);
}

#if SP__WITH_COUPLED
/* eps and eta in force. */
SP__NOINLINE static void sp__report_lengths(sp__check *c)
{
    const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
    c->r.coupled.eps = k.eps > 0 ? k.L : 0;
    c->r.coupled.eta = k.L * k.eta;
}

/* The coupled check, where forces were found; its answer, its cost and its forces into the result. */
SP__NOINLINE static sp_status sp__run_coupled(sp__check *c, sp_arena *a)
{
    sp_result *r = &c->r;
    sp_coupled *out = &r->coupled;
    const size_t mark = a->used;
    sp_status status = SP_OK;
    sp__report_lengths(c);
    c->state.left = sp__budget_left(&c->set, r);
    sp__points_read(&c->pb, 3, r->f, c->state.f);       /* on a budget the best of all stages */
    out->verdict = r->verdict == SP_UNSTABLE ? SP_COUPLING_REFUTED : SP_COUPLING_NOT_FOUND;
    out->reason = r->verdict == SP_STABLE ? SP_COUPLING_BUDGET : SP_COUPLING_STATICS;
    if (!c->pb.blocks) {
        out->verdict = SP_COUPLING_COUPLED;
        out->reason = SP_COUPLING_MOTION;
    } else if (c->state.left >= 10 * SP__FLOPS_CERTIFICATE * (int64_t)c->pb.points
               && (r->verdict == SP_STABLE || c->set.localise))
        status = sp__coupled_run(&c->pb, &c->set, &c->state, a, r);
    sp__points_write(&c->pb, 3, c->state.f, r->f);
    a->used = mark;
    sp__cost_add(&r->spent.total, &out->cost);
    if (out->verdict == SP_COUPLING_COUPLED && c->pb.blocks && !out->rounds) r->effect[SP_EFFECT_COUPLED] = SP_WHY_FOREST;
    return status;
}

/* The verdict after the coupled check.     returns 1: it is another one */
static int sp__apply_coupled_verdict(const sp_settings *set, sp_coupling coupling, sp_coupling_reason why, sp_verdict *verdict,
                            sp_reason *reason)
{
    if (coupling <= SP_COUPLING_COUPLED || why == SP_COUPLING_STATICS) return 0;
    const int refuted = coupling == SP_COUPLING_REFUTED;
    *verdict = refuted ? SP_UNSTABLE : SP_UNDECIDED;
    *reason = refuted ? SP_REASON_NO_MOTION
            : set->effect[SP_EFFECT_DEPTH] == SP_WITHOUT ? SP_REASON_EFFECT : SP_REASON_NOT_COUPLED;
    return 1;
}
#else
/* sp__settings_resolve has refused to ask for it. */
static sp_status sp__run_coupled(sp__check *c, sp_arena *a)
{
    (void)c;
    (void)a;
    return SP_OK;
}
#endif

/* The numbers of a result of which nothing is known yet; b free blocks. */
static void sp__result_start(sp_result *r, const sp_settings *set, int32_t b, int32_t contacts, int32_t points)
{
    r->extremes.tension_ratio = r->coupled.tension_ratio = -1;
    if (set->budget > 0 || set->effect[SP_EFFECT_DEPTH] == SP_WITHOUT) r->imbalance = b ? 1 : 0;    /* of no forces at all */
    r->tol = set->tol;
    r->force_bound = set->force_bound;
    r->counts.free_blocks = b;
    r->counts.joints = contacts;
    r->counts.points = points;
    r->verdict = b ? SP_UNDECIDED : SP_STABLE;
    r->reason = b ? SP_REASON_STAGES : SP_REASON_NOTHING;
    r->verified = !b;
    r->islands.count = b ? 1 : 0;
}

/* Arrays of a result that are there, zero. */
static void sp__result_clear(const sp_scene *scene, int32_t free_blocks, sp_result *r)
{
    const size_t points = (size_t)scene->count.points, blocks = (size_t)scene->count.blocks;
    sp_coupled *c = &r->coupled;
    memset(r->f, 0, 3 * points * sizeof *r->f);
    memset(r->dq, 0, 6 * blocks * sizeof *r->dq);
    memset(r->y0, 0, 12 * (size_t)free_blocks * sizeof *r->y0);
    memset(r->demand, 0, (size_t)scene->count.joints * sizeof *r->demand);
    if (c->dq) memset(c->dq, 0, 6 * blocks * sizeof *c->dq);
    if (c->alpha) memset(c->alpha, 0, points * sizeof *c->alpha);
    if (c->penalty) memset(c->penalty, 0, 4 * points * sizeof *c->penalty);
}

/* Everything of a check in arena `a` but the problem; `a` may be used up.
 *   out    *check: where the result is found on SP_OK */
SP__NOINLINE static sp_status sp__check_open(const sp_scene *scene, const sp_settings *settings,
                                             const sp__island_counts *counts, sp_arena *a, sp__check **check)
{
    sp_problem count;
    sp__result_arrays arrays;
    sp__problem_count(scene, &count);
    sp__result_arrays_carve(&arrays, scene, count.blocks, counts, settings, a);
    const size_t all = a->used;
    sp__check *c = sp__take(a, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    memset(c, 0, sizeof *c);
    c->pb = count;
    c->r.f = arrays.f; c->r.dq = arrays.dq; c->r.y0 = arrays.y0; c->r.demand = arrays.demand;
    c->r.islands.of = arrays.island; c->r.islands.each = arrays.part;
    c->r.coupled.dq = arrays.cdq;
    c->r.coupled.alpha = arrays.alpha;
    c->r.coupled.penalty = arrays.penalty;
    c->r.coupled.proof = arrays.proof;
    c->arrays = arrays.used;
    c->kept = all;
    const sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (status) return status;
    sp__result_clear(scene, count.blocks, &c->r);
    sp__result_start(&c->r, &c->set, count.blocks, count.contacts, sp__points_count(scene));
    *check = c;
    return SP_OK;
}

/* The state that stages fill: empty. */
static sp_status sp__state_open(sp__check *c, int part, sp_arena *a)
{
    sp_state *state = &c->state;
    const size_t b = 6 * (size_t)c->pb.blocks;
    state->f = c->r.f;
    state->y0 = c->r.y0;
    sp__state_carve(state, &c->pb, &c->set, part, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    memset(state->y, 0, b * sizeof *state->y);
    memset(state->dq, 0, b * sizeof *state->dq);
    if (part) memset(state->y0, 0, 2 * b * sizeof *state->y0);
    if (state->f != c->r.f) memset(state->f, 0, 3 * (size_t)c->pb.points * sizeof *state->f);
    state->reason = SP_REASON_STAGES;
    state->tension_ratio = -1;
    return SP_OK;
}

/* The problem of a whole scene and what stages leave of it. */
static sp_status sp__check_problem(sp__check *c, sp_arena *a)
{
    const sp_status status = sp_problem_build(c->pb.scene, a, &c->pb);
    return status ? status : sp__state_open(c, 0, a);
}

/* A check of a part, everything of it but where its results go: arrays of a whole scene's. */
SP__NOINLINE static sp_status sp__part_open(const sp_scene *scene, const sp__part *part, const sp_settings *set, sp_arena *a,
                                            sp__check **check)
{
    sp__check *c = sp__take(a, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    memset(c, 0, sizeof *c);
    c->set = *set;
    const sp_status status = sp__part_build(scene, part, a, &c->pb);
    if (status) return status;
    sp__result_start(&c->r, set, c->pb.blocks, c->pb.contacts, sp__problem_points(&c->pb));
    *check = c;
    return sp__state_open(c, 1, a);
}

#endif

#endif /* SP__CHECK_ONE_C */
