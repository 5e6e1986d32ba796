/* check: how a check begins, goes on and ends. sp_check itself stands at the end of stonepack.c. */
#ifndef SP__CHECK_CHECK_C
#define SP__CHECK_CHECK_C

#include "extremes.c"
#include "islands.c"

#if SP__WITH_LARGE

#if SP__WITH_COUPLED
/* The coupled check's answers change the verdicts of statics, of every island and of the whole. */
SP__NOINLINE static void sp__apply_coupled_verdicts(sp__check *c)
{
    sp_result *r = &c->r;
    for (int32_t k = 0; r->islands.each && k < r->islands.count; k++) {
        sp_island *p = &r->islands.each[k];
        sp__apply_coupled_verdict(&c->set, p->coupling, p->coupling_reason, &p->verdict, &p->reason);
    }
    if (!sp__apply_coupled_verdict(&c->set, r->coupled.verdict, r->coupled.reason, &r->verdict, &r->reason)) return;
    r->verified = r->verdict == SP_UNSTABLE;
    if (r->reason == SP_REASON_EFFECT) r->missing = SP_EFFECT_DEPTH;
}
#else
static void sp__apply_coupled_verdicts(sp__check *c) { (void)c; }
#endif

/* Begin a check: room for its result and, if there are several islands, for the loop over them. */
SP__NOINLINE static sp_status sp__check_begin(const sp_scene *scene, const sp_settings *settings, sp_arena *a, sp__check **c,
                                           sp__island_loop **w)
{
    sp__island_counts counts;
    sp_status status = sp__islands_count(scene, settings, *a, &counts);
    if (!status) status = sp__check_open(scene, settings, &counts, a, c);
    if (status || counts.islands < 2) return status;
    (*c)->r.islands.count = counts.islands;
    return sp__island_loop_begin(scene, *c, a, w);
}

/* End a check: verdict, level, extremes of the forces, why each effect was on or off. */
SP__NOINLINE static void sp__check_close(const sp_scene *scene, sp__check *c)
{
    sp_result *r = &c->r;
    const int32_t islands = r->islands.count > 1 ? r->islands.count : 1;
    if (c->set.coupled.asked) sp__apply_coupled_verdicts(c);
    if (r->verdict == SP_STABLE) memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    if (r->verdict == SP_STABLE) r->level = c->set.coupled.asked ? SP_COUPLED : SP_ADMISSIBLE;
    sp__read_extremes(scene, &c->set, r);
    for (int32_t k = 0; k < SP_EFFECTS; k++)
        if (r->effect[k] == SP_WHY_CALLED)
            r->effect[k] = sp__effect_why(&c->set, (sp_effect)k, sp__effect_present(scene, &c->set, islands, (sp_effect)k));
}

/* The status of arguments that sp_check can't work with. */
static sp_status sp__check_arguments(const sp_scene *scene, const sp_settings *settings, const sp_arena *arena,
                                     const sp_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (settings && settings->work && (settings->work == arena || !settings->work->base)) return SP_E_ARGUMENT;
    return scene->count.blocks < 1 ? SP_E_EMPTY : SP_OK;
}

/* Is there a k-th part to check? Without islands the whole is the only one. */
static int sp__check_more(const sp__island_loop *islands, const sp__check *whole, int32_t k)
{
    return islands ? sp__island_loop_continues(islands, whole, k) : k == 0;
}

/* The problem of the k-th part. */
static sp_status sp__check_part(const sp_scene *scene, sp__island_loop *islands, int32_t k, sp__check *whole, sp_arena *a,
                                sp__check **part)
{
    *part = whole;
    return islands ? sp__island_loop_open(scene, islands, k, whole, a, part) : sp__check_problem(whole, a);
}

#endif

#endif /* SP__CHECK_CHECK_C */
