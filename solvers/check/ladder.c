/* ladder: the stages of a check in their order, each followed by the certificate check of what it found.
 *
 *   sp__run_stages           (in one.c, which calls this file) for every stage until one is decided:
 *     sp__run_reduced          before the exact stage: the search in 3 rows a block, the usual way for walls and arches
 *     sp__run_stage            runs the stage, which leaves forces or a motion in the state and a claim
 *       sp__check_evidence     opens the certificate check and asks it
 *         sp__verdict_proved   the verdict: STABLE, UNSTABLE or UNDECIDED comes from here and nowhere else in this file
 */
#ifndef SP__CHECK_LADDER_C
#define SP__CHECK_LADDER_C

#include "memory.c"

#ifndef SP_SMALL
/* Flops that are left of the budget. */
static int64_t sp__budget_left(const sp_settings *set, const sp_result *r)
{
    return set->budget > 0 ? set->budget - r->spent.total.flops : INT64_MAX / 4;
}

/* Drop forces smaller than `share` of the largest component: on a block without load even tiny ones spoil its balance, which is
 * measured by its own forces. */
static void sp__drop_tiny_forces(sp_real *f, int32_t points, sp_real share)
{
    const size_t n = 3 * (size_t)points;
    sp_real most = 0;
    for (size_t k = 0; k < n; k++) most = sp__max(most, sp__abs(f[k]));
    for (size_t k = 0; k < n; k += 3) if (sp__norm3(f + k) < share * most) memset(f + k, 0, 3 * sizeof *f);
}

/* The verdict that the state's forces and motion prove: the one claimed, either where none was claimed; else UNDECIDED. The
 * forces are checked first; the motion, too, unless they prove STABLE or were all that was claimed. Both go to the result at
 * the scene's numbers; with `best` (on a budget) only if they are better than what it has. */
SP__NOINLINE static sp_verdict sp__verdict_proved(sp__certifier *j, int best, sp_state *state, sp_verdict claim, sp_result *r)
{
    int32_t final = 0;
    const size_t f = 3 * (size_t)j->pb->points, dq = 6 * (size_t)j->pb->blocks;
    if (!sp__all_finite(state->f, f)) memset(state->f, 0, f * sizeof *state->f);
    if (!sp__all_finite(state->dq, dq)) memset(state->dq, 0, dq * sizeof *state->dq);
    sp_real imbalance = sp__certify_forces(j, state->f, state->f);
    if (imbalance > (sp_real)0.1 && claim != SP_UNSTABLE && j->sweeps <= j->sweeps_most) {
        sp__drop_tiny_forces(state->f, j->pb->points, (sp_real)1e-6);
        imbalance = sp__certify_forces(j, state->f, state->f);
    }
    if (!best || imbalance < r->imbalance) {
        sp__points_write(j->pb, 3, state->f, r->f);
        r->imbalance = imbalance;
    }
    if (claim != SP_UNSTABLE && imbalance <= r->tol) return SP_STABLE;
    if (claim == SP_STABLE) return SP_UNDECIDED;
    const sp_real least = sp__certify_mechanism(j, state->dq, r->islands.count > 1 ? SP__TOGETHER : 0, &final);
    if (best && least < r->least_imbalance) return SP_UNDECIDED;
    r->least_imbalance = least;
    const int falls = least > r->tol || final;
    if (claim != SP_UNSTABLE || falls) sp__motion_write(j, r->dq);
    if (!falls) return SP_UNDECIDED;
    r->final = final;
    return SP_UNSTABLE;
}

static void sp__cost_add(sp_cost *to, const sp_cost *c)
{
    to->flops += c->flops;
    to->factorisations += c->factorisations;
    to->iterations += c->iterations;
    to->interior += c->interior;
}

/* The reason a result gives: the stage's own, unless the evidence says otherwise. A limit is near where some imbalance is
 * proved or what is left is some tol, and well below 1 where tol is coarse. */
static sp_reason sp__check_reason(sp_stage_id stage, sp_verdict claim, const sp_result *r, sp_reason reported)
{
    const int close = r->least_imbalance > 0 || (r->imbalance <= SP__NEAR * r->tol && r->imbalance * r->imbalance <= r->tol);
    if (r->verdict == SP_STABLE) return reported == SP_REASON_NOTHING ? reported : SP_REASON_FORCES;
    if (r->verdict == SP_UNSTABLE) return claim == SP_UNSTABLE && stage == SP_STAGE_GATES ? reported : SP_REASON_MECHANISM;
    if (reported == SP_REASON_UNVERIFIED && claim == SP_UNSTABLE && r->least_imbalance > 0) return SP_REASON_LIMIT;
    if (reported == SP_REASON_BUDGET || stage != SP_STAGE_EXACT) return reported;
    return close ? SP_REASON_LIMIT : SP_REASON_BUDGET;
}

/* Certificate check of what a stage left in the state: r->verdict. `most`: sweeps for the scales, 0: scales of the loads alone,
 * which no true scale is below, so that STABLE by them is STABLE. */
SP__NOINLINE static sp_status sp__check_evidence(const sp_problem *pb, const sp_settings *set, int32_t most, sp_verdict claim,
                                              sp_state *state, sp_arena *a, sp_result *r)
{
    sp__certifier j;
    const size_t mark = a->used;
    if (!sp__certifier_open(&j, pb, set, state->has_y0 ? state->y0 : NULL, most, a)) return SP_E_MEMORY;
    r->verdict = sp__verdict_proved(&j, set->budget > 0, state, claim, r);
    a->used = mark;
    state->cost.flops += SP__FLOPS_CERTIFICATE * (int64_t)j.sweeps * pb->points;
    return SP_OK;
}

/* Whoever watches is told that a stage begins. */
static void sp__watch_stage(const sp_settings *set, int32_t k, const sp_state *state)
{
    if (set->watch) set->watch->step(set->watch->self, set->stage[k], &state->cost);
}

/* Outcome of a search in 3 rows. */
typedef struct sp__reduced_outcome {
    sp_verdict claim;
    int plane;                          /* in the plane, not with pressure alone */
    int known;                          /* its bilateral force is that of all 6 rows, so scales follow from it */
    int spent;                          /* the budget ended it */
} sp__reduced_outcome;

/* Run the search in 3 rows, if one is planned, in the memory that the search in 6 rows takes after it. */
SP__NOINLINE static sp_status sp__reduced_search(const sp_problem *pb, const sp_settings *set, const sp_result *r,
                                                 sp_state *state, sp_arena *a, sp__reduced_outcome *s)
{
    sp_arena room = sp__work_open(set, a);
    sp__reduction *o = sp__take(&room, 1, sizeof *o);
    if (!o) return SP_E_MEMORY;
    state->left = sp__budget_left(set, r) - 10 * SP__FLOPS_CERTIFICATE * (int64_t)pb->points;
    if (state->left < 0 || !sp__reduction_choose(pb, set, o)) return SP_OK;
    const sp_status status = sp__exact_search(pb, set, o, state, &room, &s->claim);
    s->plane = o->mode == SP__PLANE;
    s->known = s->plane || o->forest;
    s->spent = o->spent;
    sp__work_close(set, a, &room);
    return status;
}

/* A first guess of f0 from all 6 rows, into the state. */
SP__NOINLINE static sp_status sp__hint_in_full(const sp_problem *pb, const sp_settings *set, sp_state *state, const sp_arena *a)
{
    return sp__bilateral_hint(pb, set, state, sp__work_open(set, a));
}

/* Certificate check, in 6 rows, of what the search in 3 rows found. If its bilateral force is not that of 6 rows, forces are
 * first checked by the scales of the loads alone; if that proves nothing, f0 is found in 6 rows and all is checked again,
 * unless there is a budget. A search that the budget ended is checked, too. */
SP__NOINLINE static sp_status sp__reduced_evidence(const sp_problem *pb, const sp_settings *set, const sp__reduced_outcome *s,
                                                   sp_state *state, sp_arena *a, sp_result *r)
{
    const int32_t most = sp__budget_sweeps(set, pb, sp__budget_left(set, r) - state->cost.flops);
    if (s->known) return sp__check_evidence(pb, set, most, s->claim, state, a, r);
    if (s->claim != SP_UNSTABLE) {
        const sp_status status = sp__check_evidence(pb, set, 0, SP_STABLE, state, a, r);
        if (status || r->verdict == SP_STABLE || !s->claim) return status;
    }
    if (set->budget > 0) return SP_OK;
    const sp_status status = sp__hint_in_full(pb, set, state, a);
    return status ? status : sp__check_evidence(pb, set, INT32_MAX, s->claim, state, a, r);
}

/* The search in 3 rows and its certificate check; *done: the check is decided. A planar scene is not tried without friction.
 * Where the settings leave out the third dimension no search in 6 rows follows. */
SP__NOINLINE static sp_status sp__run_reduced(const sp_problem *pb, const sp_settings *set, int32_t k, sp_state *state,
                                           sp_arena *a, sp_result *r, int *done)
{
    sp__reduced_outcome s = { SP_UNDECIDED, 0, 0, 0 };
    memset(&state->cost, 0, sizeof state->cost);
    sp__watch_stage(set, k, state);
    sp_status status = sp__reduced_search(pb, set, r, state, a, &s);
    if (!status && (s.claim || s.spent)) {
        r->verdict = SP_UNDECIDED;
        status = sp__reduced_evidence(pb, set, &s, state, a, r);
        if (r->verdict == SP_UNDECIDED) r->final = 0;
        if (r->verdict == SP_UNDECIDED && !s.spent) r->least_imbalance = 0;
        *done = s.spent || r->verdict != SP_UNDECIDED;
    }
    if (*done && r->verdict != SP_UNDECIDED) {
        r->verified = 1;
        r->stage = set->stage[k];
        r->reason = r->verdict == SP_STABLE ? SP_REASON_FORCES : SP_REASON_MECHANISM;
        r->effect[s.plane ? SP_EFFECT_DEPTH : SP_EFFECT_FRICTION] = s.plane ? SP_WHY_MIRROR : SP_WHY_PRESSURE;
    } else if (*done) r->reason = SP_REASON_BUDGET;
    else if (set->effect[SP_EFFECT_DEPTH] == SP_WITHOUT) {
        r->reason = SP_REASON_EFFECT;
        r->missing = SP_EFFECT_DEPTH;
    }
    sp__cost_add(&r->spent.by_stage[k], &state->cost);
    sp__cost_add(&r->spent.total, &state->cost);
    return status;
}

/* Certificate check of what a stage found, out of `left` flops. No joint resists a fall that gates find: scales that have not
 * settled mostly prove it. If they do not, all are found and it is checked again, unless there is a budget. */
static sp_status sp__stage_evidence(const sp_problem *pb, const sp_settings *set, sp_stage_id stage, int64_t left,
                                    sp_verdict claim, sp_state *state, sp_arena *a, sp_result *r)
{
    if (stage == SP_STAGE_GATES && claim == SP_UNSTABLE) {
        const sp_status status = sp__check_evidence(pb, set, 2, claim, state, a, r);
        if (status || r->verdict == SP_UNSTABLE || set->budget > 0) return status;
    }
    const int32_t sweeps = sp__budget_sweeps(set, pb, left - state->cost.flops);
    return sp__check_evidence(pb, set, sweeps, claim, state, a, r);
}

/* One stage and, if it claims anything or is the last, the judgement of what it found.     *done: the check is decided */
SP__NOINLINE static sp_status sp__run_stage(const sp_problem *pb, const sp_settings *set, int32_t k, sp_state *state,
                                            sp_arena *a, sp_result *r, int *done)
{
    sp_verdict claim = SP_UNDECIDED;
    const int last = k + 1 == set->stage_count;
    const int64_t left = sp__budget_left(set, r), reserve = 10 * SP__FLOPS_CERTIFICATE * (int64_t)pb->points;
    memset(&state->cost, 0, sizeof state->cost);
    sp__watch_stage(set, k, state);
    if (left < reserve) {
        r->reason = SP_REASON_BUDGET;
        return SP_OK;
    }
    state->left = left - reserve;
    sp_arena room = sp__work_open(set, a);
    const sp_status status = sp__stage_calls(set, set->stage[k]).run(pb, set, state, &room, &claim);
    if (status) return status;
    sp__work_close(set, a, &room);
    r->extremes.tension_ratio = state->tension_ratio;
    if (claim != SP_STABLE && claim != SP_UNSTABLE) claim = SP_UNDECIDED;
    if (claim || last || (set->budget > 0 && set->stage[k] != SP_STAGE_GATES)) {
        const sp_status judged = sp__stage_evidence(pb, set, set->stage[k], left, claim, state, a, r);
        if (judged) return judged;
        *done = r->verdict != SP_UNDECIDED;
        r->verified = *done;
        r->stage = *done ? set->stage[k] : SP_STAGE_NONE;
        r->reason = sp__check_reason(set->stage[k], claim, r, state->reason);
        if (claim == SP_STABLE && !*done && set->budget > 0) r->reason = SP_REASON_BUDGET;     /* scales have few sweeps */
        if (claim == SP_UNSTABLE && !*done && set->effect[SP_EFFECT_FRICTION] == SP_WITHOUT) {
            r->reason = SP_REASON_EFFECT;
            r->missing = SP_EFFECT_FRICTION;
        }
    }
    sp__cost_add(&r->spent.by_stage[k], &state->cost);
    sp__cost_add(&r->spent.total, &state->cost);
    return SP_OK;
}

#endif /* SP_SMALL */

#endif /* SP__CHECK_LADDER_C */
