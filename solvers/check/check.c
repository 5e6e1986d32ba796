/* check: sp_check */
#ifndef SP__CHECK_CHECK_C
#define SP__CHECK_CHECK_C

#include "extremes.c"
#include "islands.c"

#if SP__WITH_LARGE

#ifndef SP_NO_CRA
/* What the coupled check makes of what statics said, of every island and of the whole. */
SP__NOINLINE static void sp__apply_coupled_verdicts(sp__check *c)
{
    sp_result *r = &c->r;
    for (int32_t k = 0; r->part && k < r->islands; k++) {
        sp_island *p = &r->part[k];
        sp__apply_coupled_verdict(&c->set, p->coupling, p->coupling_reason, &p->verdict, &p->reason);
    }
    if (!sp__apply_coupled_verdict(&c->set, r->coupled.verdict, r->coupled.reason, &r->verdict, &r->reason)) return;
    r->verified = r->verdict == SP_UNSTABLE;
    if (r->reason == SP_REASON_EFFECT) r->missing = SP_EFFECT_DEPTH;
}
#endif

/* What a check starts with: room for its result and, where there are several islands, the loop over them. */
SP__NOINLINE static sp_status sp__check_begin(const sp_scene *scene, const sp_settings *settings, sp_arena *a, sp__check **c,
                                           sp__island_loop **w)
{
    sp__island_counts counts;
    sp_status status = sp__islands_count(scene, settings, *a, &counts);
    if (!status) status = sp__check_open(scene, settings, &counts, a, c);
    if (status || counts.islands < 2) return status;
    (*c)->r.islands = counts.islands;
    return sp__island_loop_begin(scene, *c, a, w);
}

/* Words and resultants of what was found. */
SP__NOINLINE static void sp__check_close(const sp_scene *scene, sp__check *c)
{
    sp_result *r = &c->r;
    const int32_t islands = r->islands > 1 ? r->islands : 1;
#ifndef SP_NO_CRA
    if (c->set.coupled.asked) sp__apply_coupled_verdicts(c);
#endif
    if (r->verdict == SP_STABLE) memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    if (r->verdict == SP_STABLE) r->level = c->set.coupled.asked ? SP_COUPLED : SP_ADMISSIBLE;
    sp__check_read(scene, r);
    for (int32_t k = 0; k < SP_EFFECTS; k++)
        if (r->effect[k] == SP_WHY_CALLED)
            r->effect[k] = sp__effect_why(&c->set, (sp_effect)k, sp__effect_present(scene, &c->set, islands, (sp_effect)k));
}

SP_API sp_status sp_check(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (settings && settings->work && (settings->work == arena || !settings->work->base)) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__check *c = NULL;
    sp__island_loop *w = NULL;
    sp_arena a = *arena;
    sp_status status = sp__check_begin(scene, settings, &a, &c, &w);
    for (int32_t k = 0; !status && (w ? sp__island_loop_more(w, c, k) : !k); k++) {
        sp__check *found = c;
        if (w) status = sp__island_loop_open(scene, w, k, c, &a, &found);
        else status = sp__check_problem(found, &a);
        if (!status && found->pb.blocks) status = sp__check_run(&found->pb, &found->set, &found->state, &a, &found->r);
#ifndef SP_NO_CRA
        if (!status && found->set.coupled.asked) status = sp__check_coupled(found, &a);
#endif
        if (!status && w) sp__island_loop_collect(w, found, c, &a);
    }
    if (!status && w) status = sp__islands_certify(scene, w, c, &a);
    if (status) return status;
    sp__check_close(scene, c);
    c->r.peak_bytes = arena->peak = a.peak;
    arena->used = c->r.coupled.proof.nodes ? c->kept : c->arrays;
    *result = c->r;
    return SP_OK;
}

#endif

#endif /* SP__CHECK_CHECK_C */
