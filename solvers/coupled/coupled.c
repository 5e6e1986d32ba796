/* coupled: the run of the coupled check: forests first, then the search in the plane, then in space, last the decision.
 *                                                                                             [Kao 2022, Eqs. 8-11] */
#ifndef SP__COUPLED_COUPLED_C
#define SP__COUPLED_COUPLED_C

#include "../statics/gates.c"
#include "point.c"
#include "help.c"
#include "reflect.c"
#include "alternate.c"
#include "forest.c"

#if SP__WITH_COUPLED

/* The motion of the free blocks into the scene's; where the certificate check takes spins off they stay off,
 * also among other islands. */
static void sp__cra_write_motion(const sp__cra *c)
{
    const sp_problem *pb = c->pb;
    const int few = sp__problem_points(pb) <= SP_EXACT_POINTS;
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (few) sp__certifier_remove_spin(&c->j, i, c->offer.t.dq + 6 * (size_t)i);
        memcpy(c->out->dq + 6 * (size_t)pb->block[i], c->offer.t.dq + 6 * (size_t)i, 6 * sizeof *c->offer.t.dq);
    }
    sp__points_write(pb, 1, c->offer.t.alpha, c->out->alpha);
}

/* The triple on offer is verified: into the result. */
static void sp__cra_write_result(const sp__cra *c, sp_state *state, sp_real *imbalance)
{
    c->out->verdict = SP_COUPLING_COUPLED;
    c->out->reason = SP_COUPLING_MOTION;
    memcpy(state->f, c->offer.t.f, (size_t)c->pb->points * 3 * sizeof *c->offer.t.f);
    *imbalance = c->offer.imbalance;
}

/* Scales of the certificate check once more, from a hint or none. */
static void sp__coupled_scales(sp__cra *c, const sp_real *y0)
{
    const int32_t before = c->j.sweeps;
    sp__certifier_scales(&c->j, y0);
    c->out->cost.flops += SP__FLOPS_CERTIFICATE * (int64_t)(c->j.sweeps - before) * c->pb->points;
}

/* The triple on offer is judged.     returns 1 when it is verified: into the result */
static int sp__coupled_judge(sp__cra *c, sp_state *state, sp_real *imbalance)
{
    c->offer.imbalance = sp__certify_forces(&c->j, c->offer.t.f, c->offer.t.f);
    c->offer.residual = sp__certify_coupled(&c->j, &c->k, c->offer.t.f, c->offer.t.dq, c->offer.t.alpha);
    c->out->cost.flops += 2 * SP__FLOPS_CERTIFICATE * (int64_t)c->pb->points;
    c->out->residual = c->offer.residual;
    if (!(c->offer.imbalance <= c->set->tol && c->offer.residual <= 1)) return 0;
    sp__cra_write_result(c, state, imbalance);
    return 1;
}

/* The decision found no proof: where it stopped at friction without slip there may be triples beside that point, so they are
 * looked for by the same cases (point.c), with middling slips, with shorter and with longer ones, ever farther from the
 * likeliest case. A length whose whole tree was walked is done. */
SP__NOINLINE static sp_status sp__coupled_by_cases(sp__cra *c, sp_state *state, sp_real *imbalance, sp_arena a)
{
    static const struct { sp_real slip; int by_friction; } way[] = { { (sp_real)0.1, 1 }, { (sp_real)0.01, 0 }, { 1, 1 } };
    const int64_t judge = 2 * SP__FLOPS_CERTIFICATE * (int64_t)c->pb->points, before = c->out->cost.flops;
    sp__branch *s = sp__point_open(c->pb, c->set, &c->j, &c->k, state->left - before - judge, &a);
    int done = 0;
    if (!s) return sp__failed(&a) ? SP_E_MEMORY : SP_OK;
    for (int32_t most = 1; most <= SP__POINT_MOST && done != 7; most *= 2)
        for (int q = 0; q < 3; q++) {
            sp__dive g = { s, way[q].slip, way[q].by_friction, 0, most, 0 };
            if (done >> q & 1 || !(g.slip > 4 * SP__SLIP)) continue;
            const int point = sp__point_run(&g);
            c->out->cost.flops = before + s->lp.flops;
            if (point) sp__point_write(s, &c->offer.t);
            if (point && sp__coupled_judge(c, state, imbalance)) return SP_OK;
            if (!g.cut) done |= 1 << q;
        }
    return SP_OK;
}

/* No triple was found: is there none? With mu = 0 this is one linear program that decides either way: ft = 0, alpha = 0, and
 * what is left is linear. Forces fn >= 0 that balance with the least g sum fn, and the multipliers dq of balance, dn >= -g,
 * meet fn (dn + g) = 0, because g sum fn = p . dq: a triple, where |d| <= eta. The root of the decision is that program,
 * |d| <= eta among its rows. */
SP__NOINLINE static sp_status sp__coupled_decide(sp__cra *c, sp_state *state, sp_real *imbalance, sp_arena *a)
{
    int frictionless = 1;
    for (int32_t q = 0; q < c->pb->contacts; q++) if (c->pb->contact[q].joint->strength.mu > 0) frictionless = 0;
    /* scales anew, without a hint, so that rounding of the search before cannot change the tree; float keeps the hint, for
     * without it fewer scenes are refuted */
    const int anew = sizeof(sp_real) == 8 && c->set->budget <= 0 && sp__branch_need(c->pb, c->set) > 0;
    if (anew) sp__coupled_scales(c, NULL);
    sp__triple *t = frictionless ? &c->offer.t : NULL;
    const sp_status status = sp__branch_decide(c->pb, c->set, &c->j, &c->k, state->left, t, a, c->out);
    if (anew) sp__coupled_scales(c, state->has_y0 ? state->y0 : NULL);
    if (status || c->out->verdict != SP_COUPLING_NOT_FOUND) return status;
    if (!frictionless) return sp__coupled_by_cases(c, state, imbalance, *a);
    if (c->out->reason == SP_COUPLING_LIMIT) sp__coupled_judge(c, state, imbalance);
    return SP_OK;
}

/* The search in the plane, where one plane is a mirror of everything (statics/mirror.c): motions in it that turn about its
 * normal, 3 rows a block, corners in pairs. There dt of every corner lies in the plane, so ft = -alpha dt does, too, and
 * mirrored corners carry mirrored forces: what meets the conditions there, forces shared by halves, meets them in space,
 * whose check has the last word.
 * From rest the search in space would stay in the plane by itself: energy, caps and drags are symmetric, so are Newton's steps.
 * So where this one finds nothing the decision comes before the search in space. That there is nothing in the plane proves
 * nothing: motions that explain forces need not be convex, and the mean of a triple and its image is none.
 *   returns 1 when a triple is verified, 0: none, or there is no such plane (see c->mirror), -1: no memory */
SP__NOINLINE static int sp__cra_plane(sp__cra *c, int64_t left, sp_arena *a)
{
    const size_t mark = a->used;
    const sp_real imbalance = c->offer.imbalance;
    const int64_t limit = c->out->cost.flops + SP__CRA_FLOPS;
    sp__reduction *o = sp__take(a, 1, sizeof *o);
    int found = 0;
    if (!o) return -1;
    if (sp__cra_mirror(c->pb, c->set, o)) {
        if (!sp__cra_open(c, limit < left ? limit : left, o, a)) return -1;
        memset(c->spring.f, 0, 3 * (size_t)c->pb->points * sizeof *c->spring.f);      /* images keep it */
        sp__cra_begin(c);
        found = sp__cra_search(c);
        c->mirror = 1;
        c->spent = c->w->budget.spent && limit >= left;
    }
    a->used = mark;
    if (found || !c->mirror) return found;
    c->offer.made = c->offer.tiny = 0;
    sp__cra_offer_statics(c, imbalance);
    return 0;
}

/* What a search in the dual at hand found is the answer, or the reason that there is none. */
static void sp__coupled_tell(sp__cra *c, int found, sp_state *state, sp_real *imbalance)
{
    c->out->residual = c->offer.residual;
    if (found) sp__cra_write_result(c, state, imbalance);
    c->spent = c->w->budget.spent && c->w->budget.limit >= state->left;
}

/* By reflections from some of their starts, in the dual at hand. */
SP__NOINLINE static void sp__coupled_reflect(sp__cra *c, int first, int last, sp_state *state, sp_real *imbalance)
{
    const int found = sp__cra_reflect(c, first, last, state->left);
    c->slow = c->w->budget.spent;
    sp__coupled_tell(c, found, state, imbalance);
}

/* The dual in space, for a search's work within `left`, and room for what works in it besides. */
SP__NOINLINE static int sp__coupled_space(sp__cra *c, int64_t left, sp_arena *a)
{
    const int64_t limit = c->out->cost.flops + SP__CRA_FLOPS;
    if (!sp__cra_open(c, limit < left ? limit : left, NULL, a)) return 0;
    const size_t turns = a->used, more = sp__alt_need(c->pb, c->set, *a);
    if (more == SIZE_MAX || (more && !sp__take(a, 1, more))) return 0;
    a->used = turns;
    return 1;
}

/* In space, by springs unless one is found (`found`) and by a few reflections, then the decision, then by all reflections,
 * which would take longer than that. */
SP__NOINLINE static sp_status sp__coupled_search(sp__cra *c, int found, sp_state *state, sp_real *imbalance, sp_arena *a)
{
    const size_t mark = a->used;
    const int seed = c->set->coupled.rounds > 0;
    if (!sp__coupled_space(c, state->left, a)) return SP_E_MEMORY;
    if (!found) {
        sp__cra_begin(c);
        found = seed ? sp__alternate(c, a) : sp__cra_search(c);
    }
    if (found < 0) return SP_E_MEMORY;
    sp__coupled_tell(c, found, state, imbalance);
    if (!found && c->offer.made && c->offer.tiny) c->out->reason = SP_COUPLING_LIMIT;
    if (!found && !seed && !c->spent) sp__coupled_reflect(c, 0, SP__REFLECT_FIRST, state, imbalance);
    a->used = mark;
    if (c->spent || c->out->verdict != SP_COUPLING_NOT_FOUND) return SP_OK;
    const sp_status status = c->mirror ? SP_OK : sp__coupled_decide(c, state, imbalance, a);
    if (status || seed || c->slow || c->out->verdict != SP_COUPLING_NOT_FOUND) return status;
    a->used = mark;
    if (!sp__cra_open(c, state->left, NULL, a)) return SP_E_MEMORY;
    sp__cra_begin(c);
    sp__coupled_reflect(c, SP__REFLECT_FIRST, SP__REFLECT_STARTS, state, imbalance);
    return SP_OK;
}

/* Is there a triple? In the plane where there is one, then in space, unless that is left out. */
static sp_status sp__coupled_ask(sp__cra *c, sp_state *state, sp_result *r, sp_arena *a)
{
    const int found = c->offer.residual <= 1 || sp__cra_forest(c, *a);
    c->out->cost.flops += SP__FLOPS_CERTIFICATE * (int64_t)c->j.sweeps * c->pb->points;       /* offers pay for themselves */
    const int plane = found || !SP__WITH_REDUCTION ? 0 : sp__cra_plane(c, state->left, a);
    if (plane < 0) return SP_E_MEMORY;
    if (plane) {
        c->out->residual = c->offer.residual;
        sp__cra_write_result(c, state, &r->imbalance);
        return SP_OK;
    }
    if (!found && c->set->effect[SP_EFFECT_DEPTH] == SP_WITHOUT) return SP_OK;
    if (!found && r->effect[SP_EFFECT_DEPTH] == SP_WHY_MIRROR) r->effect[SP_EFFECT_DEPTH] = SP_WHY_CALLED;
    if (c->mirror && !c->spent) {
        const sp_status status = sp__coupled_decide(c, state, &r->imbalance, a);
        if (status || c->out->verdict != SP_COUPLING_NOT_FOUND) return status;
    }
    return sp__coupled_search(c, found, state, &r->imbalance, a);
}

/* Is there a triple? Its forces become state->f. Else, where asked, what the joints would have to carry.
 *   in     r->coupled.verdict, reason: statics, if there are no forces (state->f) to begin with; r->imbalance of the forces
 *          state->left: flops, ten sweeps or more
 *   out    verdict, reason, residual, rounds, dq, alpha, cost; r->imbalance of the new forces, r->demand;
 *          r->effect: whether it was looked for in space after all */
SP__NOINLINE static sp_status sp__coupled_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *a,
                                           sp_result *r)
{
    sp_coupled *out = &r->coupled;
    sp__cra *c = sp__take(a, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    memset(c, 0, sizeof *c);
    sp__coupled_carve(c, pb, set, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    const int32_t sweeps = sp__has_paths(r->reason) ? sp__budget_sweeps(set, pb, state->left) : 2;  /* 2: no triple is judged */
    sp__certifier_begin(&c->j, pb, set, state->has_y0 ? state->y0 : NULL, sweeps);
    const size_t mark = a->used;
    sp__take(a, 1, sp__branch_need(pb, set));           /* for the decision, so that the peak depends on no method's success */
    if (sp__failed(a)) return SP_E_MEMORY;
    a->used = mark;
    c->pb = pb;
    c->set = set;
    c->out = out;
    c->k = sp__coupled_lengths(pb, set);
    c->statics = state->f;
    for (int32_t q = 0; q < pb->contacts; q++) c->sbar_most = sp__max(c->sbar_most, sp__cra_sbar(c, &pb->contact[q]));
    memset(c->spring.d, 0, (size_t)pb->points * 3 * sizeof *c->spring.d);
    sp__cra_offer_statics(c, r->imbalance);
    sp_status status = SP_OK;
    if (out->reason != SP_COUPLING_STATICS) status = sp__coupled_ask(c, state, r, a);
    else out->cost.flops += SP__FLOPS_CERTIFICATE * (int64_t)c->j.sweeps * pb->points;
    if (out->verdict != SP_COUPLING_COUPLED && set->localise && c->sbar_most > 0 && !status && sp__has_paths(r->reason)) {
        const int64_t help = out->cost.flops + SP__CRA_FLOPS / 2;
        a->used = mark;
        if (!sp__cra_open(c, help < state->left ? help : state->left, NULL, a)) return SP_E_MEMORY;
        sp__cra_begin(c);
        sp__cra_help(c, r->demand);
    }
    sp__cra_write_motion(c);
    return status;
}

#endif

#endif /* SP__COUPLED_COUPLED_C */
