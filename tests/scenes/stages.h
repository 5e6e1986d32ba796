/* What suites on stages share: a scene, a list of stages, a check whose answer is verified. All of it is static. */
#ifndef STAGES_H
#define STAGES_H

#include "../test.h"
#include "gen.h"

#include <math.h>
#include <string.h>

static void build(const char *name, const char *param, double value, sp_scene *scene)
{
    CHECK_INT(gen_make(name, param, value, &test_arena, scene), SP_OK);
}

static void wall(int rows, int bricks, double jitter, sp_scene *scene)
{
    gen_scene g;
    CHECK_INT(gen_open(&g, "wall"), 1);
    gen_set(&g, "rows", rows);
    gen_set(&g, "bricks", bricks);
    gen_set(&g, "jitter", jitter);
    CHECK_INT(gen_build(&g, &test_arena, scene), SP_OK);
}

/* Settings with one or two stages. */
static sp_settings stages(sp_stage_id first, sp_stage_id second)
{
    sp_settings s = sp_settings_default();
    s.stage_count = second ? 2 : 1;
    s.stage[0] = first;
    s.stage[1] = second;
    return s;
}

static sp_result check(const sp_scene *scene, const sp_settings *settings)
{
    sp_result r;
    memset(&r, 0, sizeof r);
    r.verdict = SP_UNDECIDED;
    r.extremes.weakest = -2;
    CHECK_INT(sp_check(scene, settings, &test_arena, &r), SP_OK);
    CHECK_INT(r.verified, r.verdict != SP_UNDECIDED);
    CHECK_INT(r.level, r.verdict == SP_STABLE ? SP_ADMISSIBLE : SP_NONE);
    return r;
}

static int all_finite(const sp_real *x, int32_t n)
{
    for (int32_t k = 0; k < n; k++) if (!isfinite((double)x[k])) return 0;
    return 1;
}

/* --------------------------------------------------------------------------------------------------------------- gates */

/* Cubes of 1 m, each on top of the one below: one fixed or all free, then a gap, then two more. */
static void columns(int standing, int floating, sp_scene *s)
{
    const sp_capacity cap = { standing + floating, 0, 0, 0, standing + floating, 4 * (standing + floating), 0 };
    const sp_strength strength = sp_strength_friction(R(0.84));
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < standing + floating; k++) {
        const double z = k < standing ? k : k + 1;
        const sp_real c[3] = { R(0.5), R(0.5), R(z + 0.5) };
        const sp_real foot[12] = { 0, 0, R(z), 1, 0, R(z), 1, 1, R(z), 0, 1, R(z) };
        CHECK_INT(sp_scene_body(s, 2400, c, standing && !k ? SP_FIXED : 0, NULL), SP_OK);
        if (k && k != standing) CHECK_INT(sp_scene_joint(s, k - 1, k, 4, foot, &strength, NULL), SP_OK);
    }
}

/* ------------------------------------------------------------------------------------------------------- a stage of one's own */

/* What the custom stage below leaves and says. */
static struct plan {
    const sp_real *f, *dq;                              /* NULL: left as they are */
    double value;                                       /* times f and dq */
    sp_verdict claim;
    sp_reason reason;
    sp_status status;
    size_t takes;                                       /* [byte] */
    int64_t overspends;                                 /* flops beyond what it was left; 0: spends a thousand */
    int runs;
} plan;

static sp_status custom_run(const sp_problem *problem, const sp_settings *settings, sp_state *state, sp_arena *arena,
                            sp_verdict *claim)
{
    plan.runs++;
    CHECK(settings->force_bound > 0);                   /* resolved */
    CHECK_INT(*claim, SP_UNDECIDED);
    const size_t from = (arena->used + SP_ALIGN - 1) & ~(size_t)(SP_ALIGN - 1);
    if (plan.takes && (from > arena->capacity || plan.takes > arena->capacity - from)) return SP_E_MEMORY;
    for (size_t k = 0; k < plan.takes; k++) arena->base[from + k] = 0xcc;
    if (plan.takes) arena->used = from + plan.takes;
    if (arena->used > arena->peak) arena->peak = arena->used;
    if (plan.f)
        for (int32_t k = 0; k < 3 * problem->points; k++) state->f[k] = R((double)plan.f[k] * plan.value);
    if (plan.dq)
        for (int32_t k = 0; k < 6 * problem->blocks; k++) state->dq[k] = R((double)plan.dq[k] * plan.value);
    state->reason = plan.reason;
    state->cost.flops += plan.overspends ? state->left + plan.overspends : 1000;
    state->cost.iterations += 3;
    *claim = plan.claim;
    return plan.status;
}

static size_t custom_need(const sp_problem *problem, const sp_settings *settings, sp_arena scratch)
{
    (void)problem; (void)settings; (void)scratch;
    return plan.takes;
}

static const sp_stage custom = { custom_run, custom_need };

/* The custom stage alone, or with another after it. */
static sp_settings own(sp_stage_id then)
{
    sp_settings s = stages(SP_STAGE_CUSTOM, then);
    s.custom = &custom;
    return s;
}

/* `r` and `a` as they were before a call that failed. */
static int untouched(const sp_result *r, const sp_arena *a, const sp_arena *before)
{
    unsigned char pattern[sizeof *r];
    memset(pattern, 0x5a, sizeof pattern);
    return CHECK(memcmp(r, pattern, sizeof pattern) == 0) && CHECK(memcmp(a, before, sizeof *a) == 0);
}

#endif /* STAGES_H */
