/* penalty: the penalty form: where help is wanted [seed 1.5] */
#ifndef SP__STATICS_PENALTY_C
#define SP__STATICS_PENALTY_C

#include "newton.c"

#if SP__WITH_LARGE

/* min 1/2 sum (fp^2 + gamma fm^2 + tau |ft|^2), Aeq f + p = 0, |ft| <= mu fp: tension at a price, so it always has a solution
 * and shows where help is wanted. It does not decide: a finite gamma buys a little tension even where none is needed.
 *                                                                                            [seed 1.5; Kao 2022, Eq. 14] */

SP__NOINLINE static void sp__penalty_demand(sp__dual *w, sp_demand *demand)
{
    if (!sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) return;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        const sp__yield *yield = sp__dual_yield(w, c);
        const sp__strength k = sp__vertex_strength(t->joint, 0);
        sp_demand *o = &demand[t->id];
        sp_real V[3], W[3];
        sp__dual_twist(w, t, w->y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3], f[3];
            if (!(sp__dual_counts(w, v) > 0)) continue;
            sp__dual_rate(w, V, W, w->pb->local[v], u);
            sp__dual_force(w, c, yield, u, f);
            const sp_real held = k.C + t->joint->strength.mu * sp__max(-k.T, f[0] * w->unit);
            o->tension = sp__max(o->tension, -f[0] * w->unit - k.T);
            o->friction = sp__max(o->friction, SP_SQRT(f[1] * f[1] + f[2] * f[2]) * w->unit - held);
        }
    }
}

SP__NOINLINE static sp_status sp__penalty_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                                           sp_demand *demand)
{
    sp__newton n = { 0, 0, 0, SP__HUGE, sp__max(set->tol, 16 * SP__SCALE_TOL), 40, 1, 0, 0, 0 };   /* proved: no proofs are sought */
    sp__dual *w = NULL;
    const size_t start = arena->used;
    sp__flat *flat = sp__take(arena, 1, sizeof *flat);
    if (!flat) return SP_E_MEMORY;
    if (sp__flat_choose(pb, set, flat)) {
        w = sp__dual_make(pb, set, SP__PENALTY, flat, &state->cost, arena);
        if (!w) return SP_E_MEMORY;
    }
    if (!w || !sp__dual_whole(w)) { arena->used = start; w = NULL; }       /* level, but friction may help */
    if (!w) w = sp__dual_open(pb, set, SP__PENALTY, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    w->limit = state->left;
    sp__dual_bilateral(w);
    if (w->spent) return SP_OK;
    sp__dual_sizes(w, w->y);
    if (sp__dual_metric(w)) sp__dual_bilateral(w);
    sp__newton_look(w, &n, state);
    n.shift = SP__SHIFT;
    while (sp__newton_left(w, &n) && n.imbalance > n.goal) sp__newton_step(w, &n, state);
    if (n.imbalance <= n.goal) sp__penalty_demand(w, demand);   /* else not even tension helps: no friction, a loose stone */
    return SP_OK;
}

#endif

#endif /* SP__STATICS_PENALTY_C */
