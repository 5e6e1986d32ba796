/* settings: defaults; settings checked and resolved against the scene (tol, force_bound, effects); which function runs which
 * stage (sp__stage_calls). */
#ifndef SP__CHECK_SETTINGS_C
#define SP__CHECK_SETTINGS_C

#include "../proof/triple.c"
#include "../statics/gates.c"
#include "../statics/exact.c"
#include "../seed/polish.c"
#include "../seed/program.c"

SP_API sp_settings sp_settings_default(void)
{
    sp_settings s;
    memset(&s, 0, sizeof s);
#ifdef SP_REAL_FLOAT
    s.tol = (sp_real)1e-4;
#else
    s.tol = (sp_real)1e-9;
#endif
    s.inscribed = 1;
    s.penalty.gamma = 1000;
    s.penalty.tau = 1;
    s.iterations = SP__ITERATIONS;
    s.budget = 0;
    s.stage_count = 2;
    s.stage[0] = SP_STAGE_GATES;
    s.stage[1] = SP_STAGE_EXACT;
    s.coupled.eps = -1;
    s.coupled.nodes = -1;
    return s;
}

#if SP__WITH_ADMM
SP_API sp_settings sp_settings_seed(void)
{
    sp_settings s = sp_settings_default();
    sp__seed_settings(&s);
    s.localise = 1;
    s.stage_count = 4;
    s.stage[1] = SP_STAGE_LEAST_SQUARES;
    s.stage[2] = SP_STAGE_POLISH;
    s.stage[3] = SP_STAGE_ADMM;
    s.coupled.nodes = 0;
    return s;
}
#endif

#define SP__FORCES_LEAST ((sp_real)4)   /* least force_bound: eight times what a stone on one point takes */

/* Settings that follow from rounding and the scene.
 *
 *     force_bound   min(1e6, tol / (10 u)): larger forces round to more than tol. A finer tol brings it down no further than
 *                   SP__FORCES_LEAST: a scene that stands may need forces of that size, so a smaller bound would prove nothing.
 *     tol           within it a block may miss balance sideways by tol of its forces, where friction holds mu of them: an
 *                   eighth of the least mu at most, or a cube on a slope of 2 mu would stand. */
static void sp__settings_fit(const sp_scene *scene, sp_settings *s)
{
    const sp_real most = s->tol / (10 * (sp_real)SP_EPSILON);
    if (!(s->force_bound > 0)) s->force_bound = sp__max(SP__FORCES_LEAST, most < (sp_real)1e6 ? most : (sp_real)1e6);
    for (int32_t k = 0; k < scene->count.joints; k++) {
        const sp_real enough = scene->joint[k].strength.mu / 8;
        if (enough > 0 && enough < s->tol) s->tol = sp__max(enough, 4 * (sp_real)SP_EPSILON);
    }
}

#ifndef SP_SMALL
/* Do these constants keep loops finite and pyramids whole? */
static int sp__seed_fits(const sp_seed *s)
{
    return s->faces >= SP__FACES_MIN && s->faces <= SP__FACES_MAX && s->window > 0 && s->rounds >= 0 && s->tension >= 0
        && s->balance > 0 && s->cone >= 0 && s->gain >= 0 && s->gain < 1 && s->engaged >= 0 && s->floor >= 0 && s->reg > 0
        && s->gate >= 0 && s->drop >= 0 && s->slip_error >= 0;
}

/* The caller's settings, checked and with the automatic values filled in. */
static sp_status sp__settings_resolve(const sp_scene *scene, const sp_settings *in, sp_settings *out)
{
    *out = in ? *in : sp_settings_default();
    if (!(out->tol >= 4 * (sp_real)SP_EPSILON && out->tol <= (sp_real)0.1)) return SP_E_RANGE;
    if (out->coupled.asked && out->tol > SP__COUPLED_TOL) out->tol = SP__COUPLED_TOL;
    if (!sp__finite(out->force_bound) || out->force_bound < 0) return SP_E_RANGE;
    if (out->faces && (out->faces < 3 || out->faces > 64)) return SP_E_RANGE;
    const sp_real gamma = out->penalty.gamma, tau = out->penalty.tau;
    if (!(gamma > 0) || !(tau > 0) || !sp__finite(gamma) || !sp__finite(tau)) return SP_E_RANGE;
    if (out->iterations < 0 || out->budget < 0 || out->stage_count < 1 || out->stage_count > SP_STAGES_MAX) return SP_E_RANGE;
    for (int32_t k = 0; k < out->stage_count; k++) {
        const sp_stage_id id = out->stage[k];
        if (id <= SP_STAGE_NONE || id > SP_STAGE_CUSTOM) return SP_E_ARGUMENT;
        if (!SP__WITH_ADMM && id == SP_STAGE_ADMM) return SP_E_UNSUPPORTED;
        if (id == SP_STAGE_CUSTOM && (!out->custom || !out->custom->run || !out->custom->need)) return SP_E_ARGUMENT;
    }
    if (out->penalty.solver && !out->penalty.solver->solve) return SP_E_ARGUMENT;
    if (out->parallel && !out->parallel->run) return SP_E_ARGUMENT;
    const sp_coupled_settings *cs = &out->coupled;
    if (!(cs->eps < SP__HUGE) || !sp__finite(cs->eps) || !(cs->eta < SP__HUGE) || cs->eta < 0) return SP_E_RANGE;
    if (cs->rounds < 0 || (cs->eps > 0 && !(cs->eta / cs->eps < SP__HUGE))) return SP_E_RANGE;
    if (!SP__WITH_COUPLED && out->coupled.asked) return SP_E_UNSUPPORTED;
    if (!SP__WITH_ADMM && out->coupled.asked && out->coupled.rounds) return SP_E_UNSUPPORTED;
    if (out->seed && !sp__seed_fits(out->seed)) return SP_E_RANGE;
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) {
        const int32_t choice = (int32_t)out->effect[k];
        if (choice < (int32_t)SP_PLANNED || choice > (int32_t)SP_WITHOUT) return SP_E_ARGUMENT;
    }
    if (!SP__WITH_REDUCTION && out->effect[SP_EFFECT_DEPTH] == SP_WITHOUT) return SP_E_UNSUPPORTED;
    if (out->coupled.asked && sp__scene_strong(scene)) return SP_E_UNSUPPORTED;
    sp__settings_fit(scene, out);
    return SP_OK;
}

/* What runs a stage and what tells its memory. */
static sp_stage sp__stage_calls(const sp_settings *set, sp_stage_id id)
{
    sp_stage s = { sp__exact_run, sp__exact_need };
    if (id == SP_STAGE_GATES) { s.run = sp__gates_run; s.need = sp__gates_need; }
    if (id == SP_STAGE_LEAST_SQUARES) { s.run = sp__least_squares_run; s.need = sp__sparse_need; }
    if (id == SP_STAGE_DENSE) { s.run = sp__dense_run; s.need = sp__dense_need; }
    if (id == SP_STAGE_POLISH) { s.run = sp__polish_run; s.need = sp__polish_need; }
    if (SP__WITH_ADMM && id == SP_STAGE_ADMM) { s.run = sp__admm_run; s.need = sp__admm_need; }
    if (id == SP_STAGE_CUSTOM) s = *set->custom;
    return s;
}

#else
/* Settings of SP_SMALL, checked and resolved; what it does not support it refuses. */
static sp_status sp__settings_resolve(const sp_scene *scene, const sp_settings *in, sp_settings *out)
{
    *out = in ? *in : sp_settings_default();
    if (!(out->tol >= 4 * (sp_real)SP_EPSILON && out->tol <= (sp_real)0.1)) return SP_E_RANGE;
    if (!sp__finite(out->force_bound) || out->force_bound < 0) return SP_E_RANGE;
    if (out->iterations < 0 || out->stage_count < 1 || out->stage_count > SP_STAGES_MAX) return SP_E_RANGE;
    int other = out->faces || out->budget || out->seed || out->coupled.asked || sp__scene_strong(scene);
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) other |= (uint32_t)out->effect[k] > (uint32_t)SP_WITH;
    for (int32_t k = 0; k < out->stage_count; k++) other |= out->stage[k] != SP_STAGE_GATES && out->stage[k] != SP_STAGE_EXACT;
    if (other) return SP_E_UNSUPPORTED;
    sp__settings_fit(scene, out);
    return SP_OK;
}
#endif

#if SP__WITH_LARGE || SP__WITH_PLAN
/* Does the scene have an effect, before settings leave it out? */
static int sp__effect_present(const sp_scene *scene, const sp_settings *set, int32_t islands, sp_effect effect)
{
    int friction = 0;
    for (int32_t k = 0; k < scene->count.joints; k++)
        friction |= sp__contact_counts(scene, &scene->joint[k]) && scene->joint[k].strength.mu > 0;
    return effect == SP_EFFECT_FRICTION ? friction
         : effect == SP_EFFECT_DEPTH ? 1
         : effect == SP_EFFECT_TOGETHER ? islands < 2
         : effect == SP_EFFECT_STRENGTH ? sp__scene_strong(scene)
         : effect == SP_EFFECT_LOADS ? scene->count.loads > 0
         : effect == SP_EFFECT_LIVE ? sp__scene_live(scene)
         : effect == SP_EFFECT_COUPLED && set->coupled.asked;
}
#endif

#if SP__WITH_LARGE
/* Why an effect is on or off. */
static sp_effect_why sp__effect_why(const sp_settings *set, sp_effect effect, int present)
{
    const sp_choice choice = effect < SP_EFFECTS_FORCED ? set->effect[effect] : SP_PLANNED;
    if (choice == SP_WITH) return SP_WHY_ASKED;
    if (effect == SP_EFFECT_TOGETHER && (set->budget > 0 || !sp__plan_stages(set))) return SP_WHY_STAGES;
    if (effect == SP_EFFECT_TOGETHER) return present ? SP_WHY_CALLED : SP_WHY_APART;
    if (choice == SP_WITHOUT) return SP_WHY_LEFT_OUT;
    if (effect < SP_EFFECTS_FORCED && present && !sp__plan_stages(set)) return SP_WHY_STAGES;
    if (effect == SP_EFFECT_DYNAMICS) return SP_WHY_STATICS;
    return present ? SP_WHY_CALLED : effect == SP_EFFECT_COUPLED ? SP_WHY_NOT_ASKED : SP_WHY_ABSENT;
}
#endif

#endif /* SP__CHECK_SETTINGS_C */
