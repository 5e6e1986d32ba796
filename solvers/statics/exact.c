/* exact: the exact stage, in 6 rows a block or in 3: bilateral force, Newton, interior points, proximal path, in that order,
 * until one of them finds forces that balance or a mechanism that nothing resists.
 */
#ifndef SP__STATICS_EXACT_C
#define SP__STATICS_EXACT_C

#include "interior.c"

#if SP__WITH_LARGE

/* Bytes of the stage, reduced or not, whichever takes more. */
static size_t sp__exact_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__system_need_reduced(pb, set, SP__EXACT, scratch);
}

/* Is the bilateral force already inside every cone, that is, P_K of itself up to a little? Then it is the answer, and state->f
 * holds it. A light block beside a heavy one has digits of its own, so an imbalance that is much for its load is measured again
 * with the forces on it. */
SP__NOINLINE static int sp__bilateral_admissible(sp__system *w, sp_state *state)
{
    const sp_real little = sp__max(w->set->tol / 1000, 64 * (sp_real)SP_EPSILON);
    int each = 1;
    sp__system_forces(w, SP__ADMISSIBLE, w->y, state);
    if (w->budget.spent || sp__system_norm(w, w->r) > little * w->measure.load) return 0;
    sp_real *load = w->L.t;                             /* nothing is solved meanwhile */
    sp__system_load(w, load);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k += 6)
        each &= SP_SQRT(sp__dot(w->r + k, w->r + k, 6)) <= little * SP_SQRT(sp__dot(load + k, load + k, 6));
    if (!each) sp__system_sizes(w, w->y);
    return each || (!w->budget.spent && sp__system_imbalance(w, w->r) <= little);
}

/* The y that the search in the plane came to before this one, in 6 rows: no forces are kept that balance less well. */
SP__NOINLINE static void sp__exact_recall(sp__system *w, sp__newton *n, sp_state *state)
{
    const size_t bytes = 6 * (size_t)w->pb->blocks * sizeof *w->y;
    memcpy(w->d, w->y, bytes);
    memcpy(w->y, state->y, bytes);
    sp__newton_measure(w, n, state);
    memcpy(w->y, w->d, bytes);
}

/* y <- y - s p, r there.     returns p.r */
static sp_real sp__nearer_step(sp__system *w, sp_real s, const sp_real *p)
{
    sp__system_axpy(w, -s, p, w->y);
    sp__newton_residual(w);
    return sp__dot(w->r, p, 6 * (size_t)w->pb->blocks);
}

/* Before the first of Newton's factors, conjugate gradients on D with the one at hand, G of the bilateral force,
 *
 *   d <- G^-1 r,   p <- d + b p,   b = d.(r - r_old / 4) / p.(r_old - r),   y <- y - s p
 *
 * for joints that open or slide resist no more than if they held, so G is at least as much as any Hessian [Boehning, Lindsay
 * 1988]. b is between Hestenes and Stiefel's of 1952, which it is in 3 rows, and Dai and Yuan's of 1999; s is the last one,
 * corrected once by the slopes at both ends. What stands soon has most joints open that will be. Where the slope grows beyond
 * the first D has no minimum: y goes ever farther along a mechanism, and proves it. Where it does not, or in 3 rows, where
 * Newton's factors are cheap, Newton begins where this began. */
SP__NOINLINE static void sp__exact_nearer(sp__system *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    const int64_t pays = w->L.flops / sp__system_solve_flops(w);
    const sp_real goal = sp__max(n->goal, sp__reduced(w) ? SP__NEARER_CLEAR3 : SP__NEARER_CLEAR);
    sp_real *p = state->dq, s = SP__NEARER_LONG, first = 0, bend = 0, kept = 0; /* no proof is at hand; kept: d_old.r */
    int falls = 0, most = SP__NEARER_STEPS;
    if (w->singular || pays < SP__NEARER_PAYS) return;
    for (int it = 0; it < most && n->imbalance > goal && !n->proved && !w->budget.spent; it++) {
        sp__system_solve_roughly(w, w->r, w->d);
        const sp_real slope = sp__dot(w->r, w->d, size), change = slope - (sp__reduced(w) ? kept : kept / 4);
        const sp_real b = bend > 0 && change > 0 ? change / bend : 0;
        for (size_t k = 0; k < size; k++) p[k] = w->d[k] + (it ? b * p[k] : 0);
        const sp_real start = sp__dot(w->r, p, size);
        if (!(start > 0) || start > SP__HUGE) break;
        sp_real end = sp__nearer_step(w, s, p), times = start / (start - end);
        if (!(times > 0 && times < SP__NEARER_MORE)) times = SP__NEARER_MORE;
        if (sp__abs(times - 1) > SP__NEARER_NEAR) {
            end = sp__nearer_step(w, s * (times - 1), p);
            s *= times;
        }
        bend = start - end;
        kept = sp__dot(w->r, w->d, size);
        sp__newton_record(w, n, state);
        if (!it) first = slope;
        if (!falls && slope > first) {
            falls = 1;
            most = sp__reduced(w) ? 0 : 2 * pays < SP__NEARER_FALLS ? (int)(2 * pays) : SP__NEARER_FALLS;
        }
        if (falls) sp__newton_record_proof(w, n, w->y, state);
    }
    if (n->proved) n->proved = SP__PROVED_NEARER;
    if (!falls || n->proved) return;
    sp__bilateral_solve(w);
    sp__newton_measure(w, n, state);
}

/* The ways to an answer, until one of them ends the search: Newton, interior points, the proximal path, forces.
 * looked: w->r is of w->y already. */
static void sp__exact_ways(sp__system *w, sp__newton *n, int looked, sp_state *state)
{
    const int whole = sp__system_covers(w);
    int idle = 0;                                       /* too long for these factors: no other way gets there, either */
    if (w->singular) sp__newton_unresisted(w, n, state);
    if (sp__system_metric(w)) { sp__system_bilateral(w); looked = 0; }
    if (!SP__FELL_LAST && !sp__reduced(w) && state->brief == SP__BRIEF_FELL) sp__exact_recall(w, n, state);
    if (whole) sp__newton_record_proof(w, n, w->y, state);
    if (looked) sp__newton_record(w, n, state);
    else sp__newton_measure(w, n, state);
    if (whole) sp__exact_nearer(w, n, state);
    if (whole) sp__newton_plain(w, n, state);
    sp__newton_finish(w, n, state);
    const int cones = SP__WITH_INTERIOR && !sp__problem_strong(w->pb);  /* with strength K is none */
    const int inner = cones || (SP__WITH_INTERIOR && w->capped);        /* its idling is the last word on cones alone */
    const int coarse = n->found && n->best > SP__FINE;  /* within tol, but not to rounding */
    if (sp__newton_unfinished(n) && whole && inner) idle = sp__ipm_run(w, w->inner, n, state) && cones;
    if (sp__newton_unfinished(n) && whole && !idle) {
        sp__newton_path(w, n, state);
        sp__newton_plain(w, n, state);                 /* from there, without what |y|^2 pulls */
        sp__newton_finish(w, n, state);
    }
    if ((coarse || (sp__newton_unfinished(n) && whole && !idle)) && cones && sp__newton_work_left(w, n)) {
        /* y has come as near as it can: the interior-point method goes on from here and looks for forces */
        const size_t bytes = 6 * (size_t)w->pb->blocks * sizeof *w->y;
        if (coarse) memcpy(state->y, w->y, bytes);      /* the y at hand found them; else the nearest that was kept */
        else memcpy(w->y, state->y, bytes);
        sp__system_factor(w, SP__ADMISSIBLE, w->y, SP__SHIFT);
        n->left--;
        n->found = 0;                                   /* then they are still those of y */
        sp__ipm_forces(w, NULL, n, state);
    }
}

/* Does a joint have no friction, and none any strength? */
static int sp__system_slippery(const sp__system *w)
{
    if (sp__problem_strong(w->pb)) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) if (!(sp__system_mu(w, c) > 0)) return 1;
    return 0;
}

/* Without friction the matrices have a null vector for every way that blocks can slide, and solutions are rounding. A little
 * friction resists them; a mechanism that falls with it falls without it, too. Forces that balance with it prove nothing and
 * are not kept. Where none is found, the one there was is what there is. */
SP__NOINLINE static void sp__exact_slippery(sp__system *w, sp__newton *n, sp_state *state)
{
    const sp_real best = n->best;
    const int falls = n->falls;
    const size_t bytes = 6 * (size_t)w->pb->blocks * sizeof *w->y;
    if (falls) memcpy(state->y, w->y, bytes);
    w->law.least = SP__RUB;
    sp__system_bilateral(w);
    n->best = 0;
    sp__ipm_run(w, w->inner, n, state);
    w->law.least = 0;
    n->found = 0;
    n->best = best;
    if (falls && !n->proved) memcpy(w->y, state->y, bytes);
    sp__newton_residual(w);
}

/* What the ways came to: forces, motion, claim and reason. */
SP__NOINLINE static void sp__exact_answer(sp__system *w, const sp__newton *n, sp__reduction *reduction, sp_state *state,
                                          sp_verdict *claim)
{
    const int spent = w->budget.spent;
    w->budget.limit = state->left;
    w->budget.spent = 0;
    if (!n->found && n->best < SP__HUGE) sp__system_forces(w, SP__ADMISSIBLE, state->y, state);
    w->budget.spent = spent;
    if (n->proved && state->brief != SP__BRIEF_FORCES)
        sp__newton_sharpen_proof(w, n->proved == SP__PROVED_NEARER ? 1 : 2, state);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks && !n->proved; k++)
        state->dq[k] = -w->measure.weight[k / 3] * (spent ? state->y[k] : w->y[k]);
    sp__reduction_to_space(w, state->dq);
    sp__reduction_copy_forces(reduction, w->pb, state->f);
    if (reduction) reduction->spent = spent;
    if (!SP__FELL_LAST && reduction && reduction->mode == SP__PLANE && n->falls && !state->brief) {
        state->brief = SP__BRIEF_FELL;
        sp__reduction_to_space(w, state->y);
    }
    *claim = n->proved ? SP_UNSTABLE : n->best <= w->set->tol ? SP_STABLE : SP_UNDECIDED;
    const int nearly = n->best <= SP__NEAR * w->set->tol || n->falls;
    state->reason = n->proved ? SP_REASON_MECHANISM : n->best <= w->set->tol ? SP_REASON_FORCES
                  : n->left > 0 && !spent && nearly ? SP_REASON_LIMIT : SP_REASON_BUDGET;
}

/* reduction (may be NULL): in 3 rows a block; its forces and motions are then made those of all 6. If friction was dropped
 * although the scene has some, only the least force is tried: it can prove stability and costs little. */
SP__NOINLINE static sp_status sp__exact_search(const sp_problem *pb, const sp_settings *set, sp__reduction *reduction,
                                               sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    sp__newton n = { 0, 0, 0, SP__HUGE, set->tol / 4, 0, set->iterations, 0, 0, 0, 0 };
    sp__system *w = sp__system_make(pb, set, SP__EXACT, reduction, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    if (SP__WITH_INTERIOR) w->inner->x = w->x;
    const int whole = sp__system_covers(w);
    const int64_t tail = (int64_t)SP__FLOPS_SWEEP * pb->points + (int64_t)SP__FLOPS_TWIST * pb->contacts;   /* of the forces */
    w->budget.limit = state->left - tail;
    state->reason = SP_REASON_BUDGET;
    if (reduction) reduction->spent = 1;
    sp__system_bilateral(w);
    if (w->budget.spent) return SP_OK;
    if (reduction) reduction->spent = 0;
    sp__bilateral_write_y0(w, state);
    const int looked = sp__reduced(w) && !w->singular;  /* w->r is of this y */
    if (looked && sp__bilateral_admissible(w, state)) {
        sp__reduction_copy_forces(reduction, pb, state->f);
        *claim = SP_STABLE;
        return SP_OK;
    }
    sp__system_sizes(w, w->y);
    if (!whole && w->singular) return SP_OK;
    sp__exact_ways(w, &n, looked, state);
    if (SP__WITH_INTERIOR && sp__newton_unfinished(&n) && whole && sp__system_slippery(w)) sp__exact_slippery(w, &n, state);
    sp__exact_answer(w, &n, reduction, state, claim);
    return SP_OK;
}

/* The stage in all 6 rows. */
static sp_status sp__exact_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                               sp_verdict *claim)
{
    return sp__exact_search(pb, set, NULL, state, arena, claim);
}

#endif

#endif /* SP__STATICS_EXACT_C */
