/* polish: alternating projections between the cones and { Aeq f + p = 0 }.                                    [seed 2.2]
 *
 *   f <- P_K(f),   f <- f - Aeq' G^-1 (Aeq f + p),   one factor of G = Aeq Aeq'
 *
 * Ends when the forces in the cones balance, or when a window of rounds gains too little: an empty intersection never ends by
 * itself, so this stage can only say STABLE. With the seed's constants in the settings the second step is taken in the metric
 * of the penalty form, f <- f - H^-1 Aeq' (Aeq H^-1 Aeq')^-1 (Aeq f + p), its goal is the seed's gate, it does not start where
 * tension alone blocks the bilateral force, and K is the seed's round cone inside the pyramid.
 */
#ifndef SP__SEED_POLISH_C
#define SP__SEED_POLISH_C

#include "table.c"
#include "stages.c"

#if SP__WITH_LARGE

/* f <- P_K(f + H^-1 Aeq' y) and r = Aeq f + p of it. */
SP__NOINLINE static void sp__polish_round(sp__system *w, const sp_real *y, sp_real *f, sp_real *r)
{
    const sp_problem *pb = w->pb;
    if (!sp__system_count(w, (w->carried ? 2 : 1) * SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) return;
    sp__system_load(w, r);
    if (w->carried) memset(w->carried, 0, 3 * (size_t)pb->blocks * sizeof *w->carried);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp__yield *yield = sp__system_yield(w, c);
        sp_real V[3], W[3], F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 }, u[3], m[3];
        sp__system_twist(w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real *g = f + 3 * (size_t)v;
            sp__system_rate(w, V, W, pb->local[v], u);
            for (int k = 0; k < 3; k++) u[k] = g[k] + (k ? w->law.slide * u[k] : u[k]);
            sp__cone_project(&w->law.cone, yield, u, g);
            sp__cross3(pb->local[v], g, m);
            for (int k = 0; k < 3; k++) { F[k] += g[k]; M[k] += m[k]; }
            if (w->carried) sp__carry_add(w, t, pb->local[v], g, sp__norm3(g));
        }
        sp__system_scatter(w, t, F, M, r);
    }
    sp__system_release(w, r);
}

/* A round and its imbalance. keep (NULL: not on a budget) gets the forces of the least imbalance as proof/ measures it. */
SP__NOINLINE static sp_real sp__polish_measure(sp__system *w, sp_real *f, sp_real *keep, sp_real *best)
{
    if (keep) sp__carry_begin(w);
    sp__polish_round(w, w->y, f, w->r);
    const sp_real strict = w->budget.spent ? SP__HUGE : sp__system_imbalance(w, w->r);
    w->carried = NULL;
    if (keep && strict < *best) {
        *best = strict;
        memcpy(keep, f, 3 * (size_t)w->pb->points * sizeof *f);
    }
    return w->budget.spent ? SP__HUGE : sp__system_imbalance(w, w->r);
}

/* From now on K is the round cone that the seed names, of the coefficient mu_eff cos(pi/K). It lies inside the pyramid, and is
 * not the largest that does: that has mu_eff.                                                      [seed 2.2, departure 7] */
static void sp__polish_round_cone(sp__system *w)
{
    sp_real c, half;
    if (!w->law.cone.faces) return;
    sp__pyramid_half(w->law.cone.faces, &c, &half);
    w->law.cone.faces = 0;
    w->law.cone.tan_half = 0;
    w->law.friction *= c;
}

/* Bytes the stage takes: a factor, and on a budget the best forces so far. */
static size_t sp__polish_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__system_need(pb, set, SP__POLISH, scratch);
}

/* The stage: rounds from the bilateral force until forces in the cones balance, or a window of them gains too little. */
static sp_status sp__polish_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                                sp_verdict *claim)
{
    const sp_seed *seed = set->seed ? set->seed : sp_seed_table();
    sp__system *w = sp__system_make_full(pb, set, SP__POLISH, &state->cost, arena);
    const size_t n = 6 * (size_t)pb->blocks, size = 3 * (size_t)pb->points;
    sp_real best = SP__HUGE;
    if (!w) return SP_E_MEMORY;
    sp_real *keep = set->budget > 0 ? w->x : NULL;
    w->budget.limit = state->left;
    const sp_real goal = set->seed && seed->balance < set->tol / 4 ? seed->balance : set->tol / 4;
    state->reason = SP_REASON_BUDGET;
    sp__system_bilateral(w);
    if (w->budget.spent) return SP_OK;
    if (!set->seed) sp__bilateral_write_y0(w, state);
    sp__system_sizes(w, w->y);
    if (set->seed) sp__system_forces(w, SP__BILATERAL, w->y, state);
    const sp__gate gate = set->seed ? sp__seed_gate(w, seed, state->f) : (sp__gate){ 1, 0 };
    if (gate.friction && !gate.tension) { state->reason = SP_REASON_STAGES; return SP_OK; }
    if (set->seed) sp__polish_round_cone(w);
    memset(state->f, 0, size * sizeof *state->f);
    sp_real imbalance = sp__polish_measure(w, state->f, keep, &best), last = imbalance;
    if (w->budget.spent) return SP_OK;
    for (int round = 1; imbalance > goal && round <= seed->rounds; round++) {
        sp__system_solve(w, w->r, w->y);
        for (size_t k = 0; k < n; k++) w->y[k] = -w->y[k];
        const sp_real now = sp__polish_measure(w, state->f, keep, &best);
        if (w->budget.spent) break;
        imbalance = now;
        state->cost.iterations++;
        if (round % seed->window) continue;
        if (imbalance > (1 - seed->gain) * last) break;
        last = imbalance;
    }
    *claim = imbalance <= (set->seed ? goal : set->tol) ? SP_STABLE : SP_UNDECIDED;
    if (keep && !*claim) memcpy(state->f, keep, size * sizeof *keep);
    sp__to_newtons(w->measure.unit, size, state->f, state->f);
    if (!w->budget.spent) state->reason = SP_REASON_STAGES;
    return SP_OK;
}

#endif

#endif /* SP__SEED_POLISH_C */
