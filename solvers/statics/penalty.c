/* penalty: where help is wanted, by the penalty form.                                       [seed 1.5; Kao 2022, Eq. 14]
 *
 *   min 1/2 sum (fp^2 + gamma fm^2 + tau |ft|^2),   Aeq f + p = 0,   |ft| <= mu fp
 *
 * Tension at a price, so it has a solution wherever joints that pull could hold every block; a stone that touches nothing has
 * none. It does not decide: a finite gamma buys a little tension even where none is
 * needed.
 */
#ifndef SP__STATICS_PENALTY_C
#define SP__STATICS_PENALTY_C

#include "newton.c"

#if SP__WITH_LARGE

/* The largest tension and excess of friction in each joint, by the forces of y. */
SP__NOINLINE static void sp__penalty_demand(sp__system *w, sp_demand *demand)
{
    if (!sp__system_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) return;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        const sp__yield *yield = sp__system_yield(w, c);
        const sp__vertex_limits k = sp__vertex_strength(t->joint, 0);
        sp_demand *o = &demand[t->id];
        sp_real V[3], W[3];
        sp__system_twist(w, t, w->y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3], f[3];
            if (!(sp__system_multiplicity(w, v) > 0)) continue;
            sp__system_rate(w, V, W, w->pb->local[v], u);
            sp__system_force(w, c, yield, u, f);
            const sp_real fn = sp__in_newtons(w->measure.unit, f[0]);
            const sp_real ft = sp__in_newtons(w->measure.unit, SP_SQRT(f[1] * f[1] + f[2] * f[2]));
            o->tension = sp__max(o->tension, -fn - k.T);
            o->friction = sp__max(o->friction, ft - (k.C + t->joint->strength.mu * sp__max(-k.T, fn)));
        }
    }
}

/* Sizes, metric and potential of the bilateral force, from y0 where a stage left it: then one factorisation less. */
SP__NOINLINE static void sp__penalty_begin(sp__system *w, const sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    if (state->has_y0 && !sp__reduced(w)) {
        sp__system_weights(w);
        sp__system_load(w, w->r);
        w->measure.load = sp__system_norm(w, w->r);
        for (size_t k = 0; k < n; k++) {
            const sp_real unit = w->measure.unit * w->measure.weight[k / 3];
            w->y[k] = sp__in_units(unit, state->y0[k]);
            w->d[k] = -sp__in_units(unit, state->y0[n + k]);
        }
    } else sp__system_bilateral(w);
    if (w->budget.spent) return;
    sp__system_sizes(w, w->y);
    if (sp__system_metric(w)) sp__system_bilateral(w);
}

/* Newton along prices of tension that rise tenfold, one step each: from the bilateral force, where tension has price 1, joints
 * that open show step by step. The last price takes as many steps as it needs. */
SP__NOINLINE static void sp__penalty_descend(sp__system *w, sp__newton *n, sp_state *state)
{
    const sp_real soft = w->law.soft;
    n->shift = SP__HELP_SHIFT;
    for (w->law.soft = (sp_real)0.1; w->law.soft > 3 * soft && soft > 0; w->law.soft /= 10) {
        sp__newton_measure(w, n, state);
        if (sp__newton_work_left(w, n) && n->imbalance > (sp_real)0.01) sp__newton_step(w, n, 0, state);
    }
    w->law.soft = soft;
    sp__newton_measure(w, n, state);
    while (sp__newton_work_left(w, n) && n->imbalance > n->goal) sp__newton_step(w, n, 0, state);
}

/* The penalty form, reduced where the scene lets it. It is solved as far as `least`, the imbalance that no admissible forces
 * avoid, so that what is left is small beside the help; demand is left alone where not even tension helps. */
SP__NOINLINE static sp_status sp__penalty_run(const sp_problem *pb, const sp_settings *set, sp_real least, sp_state *state,
                                              sp_arena *arena, sp_demand *demand)
{
    const sp_real goal = sp__max(sp__max(set->tol, 16 * SP__SCALE_TOL), SP__HELP_LEAST);
    sp__newton n = { 0, 0, 0, SP__HUGE, goal, 0, SP__HELP_MOST, 1, 0, 0, 0 };   /* proved = 1: seeks none */
    sp__system *w = NULL;
    const size_t start = arena->used;
    n.goal = sp__max(goal, least < SP__HELP ? least : SP__HELP);
    sp__reduction *reduction = sp__take(arena, 1, sizeof *reduction);
    if (!reduction) return SP_E_MEMORY;
    if (sp__reduction_choose(pb, set, reduction)) {
        w = sp__system_make(pb, set, SP__PENALTY, reduction, &state->cost, arena);
        if (!w) return SP_E_MEMORY;
    }
    if (!w || !sp__system_covers(w)) { arena->used = start; w = NULL; }       /* level, but friction may help */
    if (!w) w = sp__system_make_full(pb, set, SP__PENALTY, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    w->budget.limit = state->left;
    sp__penalty_begin(w, state);
    if (w->budget.spent) return SP_OK;
    sp__penalty_descend(w, &n, state);
    if (n.imbalance <= n.goal) sp__penalty_demand(w, demand);   /* else not even tension helps: a stone that touches nothing */
    return SP_OK;
}

#endif

#endif /* SP__STATICS_PENALTY_C */
