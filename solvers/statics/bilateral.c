/* bilateral: f0, the force of joints that may pull and slide as they like, by least squares.                  [seed 2.1]
 *
 *   (G + shift) y = -p,   G = Aeq S Aeq',   f0 = S Aeq' y         in the metric S
 *
 * If p has a part that no contact resists at all, y would run off by it; that part is taken out again:
 * y <- y - shift (G + shift)^-1 y.
 */
#ifndef SP__STATICS_BILATERAL_C
#define SP__STATICS_BILATERAL_C

#include "factor.c"
#include "open.c"

#if SP__WITH_LARGE

/* y <- y + s x */
static void sp__system_axpy(sp__system *w, sp_real s, const sp_real *x, sp_real *y)
{
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) y[k] += s * x[k];
}

/* |x| */
static sp_real sp__system_norm(const sp__system *w, const sp_real *x)
{
    return SP_SQRT(sp__dot(x, x, 6 * (size_t)w->pb->blocks));
}

/* w->r <- correction of y for gradient r but for `left` of it, by the factor at hand. */
static void sp__bilateral_correct(sp__system *w, sp_real left)
{
    sp__system_solve_to(w, left, w->r, w->r);
    if (!w->singular) return;
    sp__system_solve(w, w->r, w->d);
    sp__system_axpy(w, -SP__SHIFT, w->d, w->r);
}

/* w->y: potential of the bilateral force of the load at hand, by the bilateral factor; w->d: what rounding left of it, y - d is
 * better. Where one more correction, shrinking r as the last one did, leaves rounding, nothing is measured after it. Worth
 * nothing when w->budget.spent. */
SP__NOINLINE static void sp__bilateral_solve(sp__system *w)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    for (size_t k = 0; k < n; k++) w->y[k] = 0;
    sp__system_load(w, w->r);
    w->measure.load = sp__system_norm(w, w->r);
    w->singular = 0;
    sp_real last = w->measure.load, left = 0;
    int once = 0;                                       /* is one more correction enough? */
    for (int it = 0; it < 6; it++) {
        sp__bilateral_correct(w, left);
        sp__system_axpy(w, -1, w->r, w->y);
        sp__system_gradient(w, SP__BILATERAL, w->y, w->r, NULL);
        if (w->budget.spent) return;
        const sp_real now = sp__system_norm(w, w->r);
        const int held = now <= SP__HELD * w->measure.load;
        if (!w->singular && !held && now > SP__RUNS_OFF * last) {       /* again, for a matrix with null vectors in the load */
            w->singular = 1;
            it = -1;
            last = SP__HUGE;
            for (size_t k = 0; k < n; k++) w->y[k] = 0;
            sp__system_load(w, w->r);
            continue;
        }
        const sp_real rounding = 64 * (sp_real)SP_EPSILON * w->measure.load;
        left = now > rounding ? rounding / now : 1;
        once = held && now > rounding && now <= SP__FORETELLS * last && now * now <= rounding * last;
        if (once || now <= rounding || (now > last / 4 && (w->singular || held))) break;
        last = now;
    }
    sp__bilateral_correct(w, left);
    for (size_t k = 0; k < n; k++) {                    /* y - r in two parts [Dekker 1971] */
        const sp_real y = once ? w->y[k] - w->r[k] : w->y[k];
        w->d[k] = w->r[k] + (y - w->y[k]);
        w->y[k] = y;
    }
}

/* Weights, factor and potential of the bilateral force, in the metric at hand. Factorises once. */
static void sp__system_bilateral(sp__system *w)
{
    sp__system_weights(w);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->y[k] = 0;
    sp__system_factor(w, SP__BILATERAL, w->y, SP__SHIFT);
    sp__bilateral_solve(w);
}

/* state->y0 <- unweighted potential of metric 1, [N/m]: f0 = Aeq' (y0 + y0'), in two parts. */
static void sp__bilateral_write_y0(sp__system *w, sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp__reduction *o = sp__reduced(w);
    if (o && o->mode == SP__LEVEL_JOINTS && !o->forest) return;
    for (size_t k = 0; k < n; k++) {
        const sp_real unit = w->measure.unit * w->measure.weight[k / 3];
        state->y0[k] = sp__in_newtons(unit, w->y[k]);
        state->y0[n + k] = -sp__in_newtons(unit, w->d[k]);
    }
    sp__reduction_to_space(w, state->y0);
    sp__reduction_to_space(w, state->y0 + n);
    state->has_y0 = 1;
}

/* state->f <- forces of potential y in newtons. */
static void sp__system_forces(sp__system *w, sp__law law, const sp_real *y, sp_state *state)
{
    sp__system_gradient(w, law, y, w->r, state->f);
    for (int32_t c = 0; c < w->pb->contacts && !w->budget.spent; c++) {
        const sp_contact *t = &w->pb->contact[c];
        sp_real *f = state->f + 3 * (size_t)t->point;
        sp__to_newtons(w->measure.unit, 3 * (size_t)t->points, f, f);
    }
}

/* The hint alone. */
SP__NOINLINE static sp_status sp__bilateral_hint(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena arena)
{
    sp__system *w = sp__system_make_full(pb, set, SP__LEAST, &state->cost, &arena);
    if (!w) return SP_E_MEMORY;
    sp__system_bilateral(w);
    sp__bilateral_write_y0(w, state);
    return SP_OK;
}

#endif

#endif /* SP__STATICS_BILATERAL_C */
