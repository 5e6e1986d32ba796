/* newton: semismooth Newton's method on D(y) and, where it stalls, along the proximal path; proofs are tried on the way.
 *
 *   (Aeq S DP_K Aeq' + prox + shift) d = -(r + prox y),   y <- y + s d          [Qi, Sun 1993; Rockafellar 1976]
 */
#ifndef SP__STATICS_NEWTON_C
#define SP__STATICS_NEWTON_C

#include "line.c"
#include "rigid.c"

#if SP__WITH_LARGE

/* Keeps the imbalance after a step, and y in state->y if it is the best so far. */
static void sp__newton_record(const sp__system *w, sp__newton *n, sp_state *state)
{
    if (w->budget.spent) return;                               /* w->r is not of this y */
    n->imbalance = sp__system_imbalance(w, w->r);
    if (n->imbalance < n->best) {
        n->best = n->imbalance;
        memcpy(state->y, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    }
}

/* r of the y at hand. */
SP__NOINLINE static void sp__newton_residual(sp__system *w) { sp__system_gradient(w, SP__ADMISSIBLE, w->y, w->r, NULL); }

/* r and the imbalance of the y at hand. */
static void sp__newton_measure(sp__system *w, sp__newton *n, sp_state *state)
{
    sp__newton_residual(w);
    sp__newton_record(w, n, state);
}

/* The line from y along d. */
SP__NOINLINE static void sp__line_begin(const sp__system *w, const sp__newton *n, sp__line *l)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    l->yd = n->prox * sp__dot(w->y, w->d, size);
    l->dd = n->prox * sp__dot(w->d, w->d, size);
    l->start = sp__dot(w->r, w->d, size) + l->yd;
    l->noise = 64 * (sp_real)SP_EPSILON * w->measure.load * sp__system_norm(w, w->d);
}

/* y += s d. The whole step is tried first: its gradient gives the slope there, and mostly no shorter step is needed. Where a
 * first one leads so far astray that few of its digits would be left, s = 0. */
SP__NOINLINE static sp_real sp__newton_move(sp__system *w, sp__newton *n, int first, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp__line l;
    sp_real s = 1, *start = w->L.t;                     /* keeps y: nothing is solved meanwhile */
    sp__line_begin(w, n, &l);
    memcpy(start, w->y, size * sizeof *w->y);
    sp__system_axpy(w, 1, w->d, w->y);
    sp__newton_residual(w);
    const sp_real f = sp__dot(w->r, w->d, size) + l.yd + l.dd;
    if (l.start < -l.noise && sp__abs(f) > sp__line_enough(&l)) {
        memcpy(w->y, start, size * sizeof *w->y);
        s = first && f > SP__ASTRAY * sp__abs(l.start) ? 0 : sp__newton_search(w, &l, f);
        sp__system_axpy(w, s, w->d, w->y);
        sp__newton_residual(w);
    }
    sp__newton_record(w, n, state);
    return s;
}

/* Nothing resists a mechanism: it is a null vector of the Hessian, and inverse iteration brings it out of x (used up). */
static void sp__newton_purify(sp__system *w, sp__newton *n, sp_real *x, sp_state *state)
{
    for (int it = 0; it < 2 && !n->proved; it++) {
        sp__system_solve(w, x, x);
        const sp_real size = sp__system_norm(w, x);
        if (!(size > 0)) return;
        for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) x[k] /= size;
        sp__newton_record_proof(w, n, x, state);
    }
}

/* The candidate in w->d, tied into rigid groups: opened, else as it is. */
SP__NOINLINE static void sp__newton_try_rigid(sp__system *w, sp__newton *n, sp_real play, sp_state *state)
{
    if (n->proved || !sp__system_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) return;
    int32_t *group = sp__rigid_room(w);
    sp__rigid_groups(w, w->d, play, group);
    if (sp__rigid_sharpen(w, group, state)) {
        memcpy(w->r, w->d, 6 * (size_t)w->pb->blocks * sizeof *w->r);
        sp__rigid_open_joints(w, w->d, sp__rigid_offsets(state));
        sp__newton_record_proof(w, n, w->d, state);
        sp__newton_record_proof(w, n, w->r, state);
    }
    sp__system_gradient(w, SP__ADMISSIBLE, w->y, w->r, NULL);
}

/* One Newton step; returns its length. On the way y, the step and what inverse iteration makes of them are tried as proofs. */
SP__NOINLINE static sp_real sp__newton_step(sp__system *w, sp__newton *n, int first, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp__system_factor(w, SP__ADMISSIBLE, w->y, n->prox + n->shift);
    if (w->budget.spent) return 0;
    n->left--;
    state->cost.iterations++;
    if (n->stalled) {
        memcpy(w->d, w->y, size * sizeof *w->d);
        sp__newton_purify(w, n, w->d, state);
        if (n->prox < SP__TIE) sp__newton_try_rigid(w, n, SP__PLAY, state);
    }
    for (size_t k = 0; k < size; k++) w->d[k] = -w->r[k] - n->prox * w->y[k];
    sp__system_solve(w, w->d, w->d);
    if (state->brief != SP__BRIEF_FORCES) sp__newton_record_proof(w, n, w->d, state);
    const sp_real s = sp__newton_move(w, n, first, state);
    if (n->imbalance > n->goal && !n->proved) {
        sp__newton_record_proof(w, n, w->y, state);
        if (s > 10) sp__newton_purify(w, n, w->d, state);
    }
    return s;
}

/* y += (Aeq S DP Aeq')^-1 (-r), with the factor at hand. */
static void sp__newton_correct(sp__system *w)
{
    sp__system_solve_to(w, SP__CORRECTED, w->r, w->d);
    sp__system_axpy(w, -1, w->d, w->y);
}

/* The goal is reached: where digits lack, a few more steps with the factor at hand while each gains one; then imbalance as
 * forces are judged, and more steps where that asks for them. What is good enough goes to state->f. */
SP__NOINLINE static void sp__newton_finish(sp__system *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    if (n->found || n->proved || n->imbalance > n->goal) return;
    for (int it = 0; it < 4 && !sp__newton_close(w, n->imbalance); it++) {
        const sp_real last = n->imbalance;
        sp__newton_correct(w);
        sp__newton_measure(w, n, state);
        if (n->imbalance > last / 10) break;
    }
    memcpy(w->y, state->y, size * sizeof *w->y);
    sp__carry_begin(w);
    n->imbalance = SP__HUGE;
    for (int it = 0; it < 12 && !n->found; it++) {
        const sp_real last = n->imbalance;
        if (it) sp__newton_correct(w);
        sp__system_forces(w, SP__ADMISSIBLE, w->y, state);
        if (w->budget.spent) break;
        n->best = n->imbalance = sp__system_imbalance(w, w->r);
        n->found = n->imbalance <= SP__ENOUGH * w->set->tol;
        if (n->imbalance > last / 2) break;
    }
    w->carried = NULL;
}

/* After a step of length s, more or less on the diagonal.     returns whether the step was tiny */
SP__NOINLINE static int sp__newton_adapt_shift(sp__newton *n, sp_real s)
{
    const int tiny = s < (sp_real)0.03;
    if (tiny) n->shift = n->shift * 1000 < 1 ? n->shift * 1000 : 1;
    if (s > (sp_real)0.5) n->shift = sp__max(SP__SHIFT, n->shift / 100);
    return tiny;
}

/* After a step of length 1 that gained two digits the next factor would hardly be another one: more steps with the one at hand
 * until the imbalance is well within the goal. One that gains no digit is taken back, for the next factor may lead to a proof
 * instead; nor does one gain any that a budget no longer pays for. state->dq, where no proof is, keeps y. n->level: imbalance
 * before the step. */
SP__NOINLINE static void sp__newton_again(sp__system *w, sp__newton *n, sp_real s, sp_state *state)
{
    const size_t bytes = 6 * (size_t)w->pb->blocks * sizeof *w->y;
    if (sp__reduced(w) || n->proved || sp__abs(s - 1) > 0 || !(n->imbalance < n->level / 100)) return;
    while (n->imbalance > n->goal / 10) {
        memcpy(state->dq, w->y, bytes);
        sp__newton_correct(w);
        sp__newton_residual(w);
        if (!(sp__system_imbalance(w, w->r) <= n->imbalance / 10)) {
            memcpy(w->y, state->dq, bytes);
            sp__newton_residual(w);
            return;
        }
        sp__newton_record(w, n, state);
    }
}

/* Where a step gains nothing more, twice the goal will do: in float a goal may be below what rounding leaves. */
static void sp__newton_raise_goal(const sp__system *w, sp__newton *n)
{
    const sp_real enough = w->set->tol / 2;
    if (n->best <= enough && n->imbalance > n->level / 2) n->goal = enough;
}

/* Plain Newton: quadratic unless close to collapse. Gives up after two tiny steps, a first one that leads astray, or in float
 * after a far one that leaves more imbalance than load. */
SP__NOINLINE static void sp__newton_plain(sp__system *w, sp__newton *n, sp_state *state)
{
    int tiny = 0;
    n->prox = 0;
    n->stalled = 0;
    n->shift = SP__SHIFT;
    for (int it = 0; it < 12 && sp__newton_work_left(w, n) && n->imbalance > n->goal && !n->proved && tiny < 2; it++) {
        n->level = n->imbalance;
        const sp_real s = sp__newton_step(w, n, it == 0 && !n->falls && sp__reduced(w), state);
        sp__newton_again(w, n, s, state);
        sp__newton_raise_goal(w, n);
        tiny += !(s > 0) || (s > SP__FAR && n->imbalance > 1) ? 2 : sp__newton_adapt_shift(n, s);
    }
}

/* On the proximal path y = (mechanism) / prox + (what balances the forces). The second part is no mechanism: contacts resist
 * it, and a proof multiplies that by their caps. So Newton steps without the load, x <- x - (H + shift)^-1 Aeq S P_K(Aeq' x),
 * each a little too long, move the direction of y to where no contact resists. For hinges inverse iteration would be enough,
 * for curved cones it is not. */
SP__NOINLINE static void sp__newton_restore(sp__system *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    const sp_real y = sp__system_norm(w, w->y);
    sp_real *load = w->L.t;                             /* until the next solution */
    if (!(y > 0)) return;
    for (size_t k = 0; k < size; k++) w->d[k] = w->y[k] / y;
    for (int it = 0; it < 3 && sp__newton_work_left(w, n) && !n->proved; it++, n->left--) {
        sp__system_factor(w, SP__ADMISSIBLE, w->d, SP__SHIFT);
        sp__system_gradient(w, SP__ADMISSIBLE, w->d, w->r, NULL);
        sp__system_load(w, load);
        for (size_t k = 0; k < size; k++) w->r[k] -= load[k];
        sp__system_solve(w, w->r, w->r);
        sp__system_axpy(w, -(sp_real)1.1, w->r, w->d);
        sp__newton_record_proof(w, n, w->d, state);
    }
    if (!n->proved) sp__newton_try_rigid(w, n, SP__PLAY, state);
}

/* Is y near enough to the minimum for this prox?     n->stalled: does the imbalance no longer fall with it? */
SP__NOINLINE static int sp__newton_near_minimum(sp__system *w, sp__newton *n)
{
    const sp_real y = n->prox * sp__system_norm(w, w->y), r = sp__system_norm(w, w->r);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->d[k] = w->r[k] + n->prox * w->y[k];
    const sp_real inner = sp__system_norm(w, w->d);
    if (inner > (sp_real)0.3 * y && inner > (sp_real)0.1 * r) return 0;
    n->stalled = r > (sp_real)0.1 * n->level && n->prox < (sp_real)1e-4;
    n->level = r;
    return 1;
}

/* Proximal path from y = 0; farther along it where the interior points came to a motion. */
SP__NOINLINE static void sp__newton_path(sp__system *w, sp__newton *n, sp_state *state)
{
    memset(w->y, 0, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    n->prox = n->falls ? SP__PATH_FELL : (sp_real)0.1;
    n->shift = 0;
    n->level = SP__HUGE;
    sp__newton_measure(w, n, state);
    for (int extra = 8; extra > 0 && sp__newton_work_left(w, n) && n->imbalance > n->goal && !n->proved; ) {
        sp__newton_step(w, n, 0, state);
        if (n->prox <= SP__SHIFT) {
            if (extra-- == 8) sp__newton_restore(w, n, state);
            continue;
        }
        if (!sp__newton_near_minimum(w, n)) continue;
        if (n->stalled && !n->proved) sp__newton_restore(w, n, state);
        n->prox = n->prox > 100 * SP__SHIFT ? n->prox / 100 : SP__PROX;
        n->stalled |= n->prox <= SP__DEEP;
    }
}

/* Tries a motion that not even bilateral joints resist: the part of the load along null vectors, by inverse iteration. */
static void sp__newton_unresisted(sp__system *w, sp__newton *n, sp_state *state)
{
    sp__system_load(w, w->d);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->d[k] = -w->d[k];
    sp__newton_purify(w, n, w->d, state);
}

/* A proof is found: sharpen it by the rigid groups it shows, as it is and, of two passes, after inverse iteration with the last
 * factor (that of f0 knows nothing of the mechanism), and take what the contacts resist least. A block that turns about its
 * edge or its point moves none of its corners, so it counts as tied: where that ties all, every block goes alone. state->y is
 * used up. */
SP__NOINLINE static void sp__newton_sharpen_proof(sp__system *w, int passes, sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    int32_t *group = sp__rigid_room(w);
    for (size_t k = 0; k < n; k++) state->y[k] = w->d[k] = -state->dq[k] / w->measure.weight[k / 3];
    sp__power best, now;
    sp__newton_power(w, w->d, &best);
    for (int pass = 0; pass < passes && best.resist > 0; pass++) {
        memcpy(w->d, state->y, n * sizeof *w->d);
        if (pass) sp__system_solve(w, w->d, w->d);
        if (!sp__system_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) break;
        sp__rigid_groups(w, w->d, SP__PLAY, group);
        if (!sp__rigid_sharpen(w, group, state)) {
            memcpy(w->d, state->y, n * sizeof *w->d);
            sp__rigid_groups(w, w->d, -1, group);
            if (!sp__rigid_sharpen(w, group, state)) continue;
        }
        sp__newton_power(w, w->d, &now);
        if (!(now.work > now.resist && now.resist * best.work < best.resist * now.work)) continue;
        best = now;
        memcpy(state->y, w->d, n * sizeof *w->d);
    }
    for (size_t k = 0; k < n; k++) state->dq[k] = -w->measure.weight[k / 3] * state->y[k];
}

#endif

#endif /* SP__STATICS_NEWTON_C */
