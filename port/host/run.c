#include "run.h"
#include "clock.h"

#include <stdlib.h>

sp_status run_arena(size_t bytes, sp_arena *arena, void **memory)
{
    *memory = bytes < SIZE_MAX - SP_ALIGN ? malloc(bytes + SP_ALIGN) : NULL;
    return *memory ? sp_arena_init(arena, *memory, bytes + SP_ALIGN) : SP_E_MEMORY;
}

size_t run_bytes(const sp_scene *scene, sp_memory_for what, const sp_settings *settings)
{
    const sp_arena none = { NULL, 0, 0, 0 };
    size_t bytes = 0;
    return sp_memory(scene, what, settings, none, &bytes) == SP_OK ? bytes : 0;
}

/* sp_memory of what runs a symbolic step, in memory of malloc's. */
static sp_status counted(const sp_scene *scene, sp_memory_for what, const sp_settings *settings, size_t *bytes)
{
    void *memory;
    sp_arena scratch;
    sp_status status = run_arena(sp_memory_scratch(scene, what, settings), &scratch, &memory);
    if (status == SP_OK) status = sp_memory(scene, what, settings, scratch, bytes);
    free(memory);
    return status;
}

sp_status run_check_bytes(const sp_scene *scene, const sp_settings *settings, size_t *bytes)
{
    return counted(scene, SP_FOR_CHECK, settings, bytes);
}

sp_status run_check(const sp_scene *scene, const sp_settings *settings, sp_result *result, run_cost *cost, void **memory)
{
    sp_arena arena;
    sp_status status = run_check_bytes(scene, settings, &cost->bytes);
    double start;

    *memory = NULL;
    if (status == SP_OK) status = run_arena(cost->bytes, &arena, memory);
    if (status != SP_OK) return status;
    start = now();
    status = sp_check(scene, settings, &arena, result);
    cost->seconds = now() - start;
    return status;
}

#ifndef SP_NO_STRONG
sp_status run_strong(const sp_scene *scene, const sp_settings *settings, const sp_strong_settings *how, const sp_real *f,
                     sp_strong_result *result, run_cost *cost, void **memory)
{
    sp_settings without = *settings;
    sp_result pressed;
    sp_arena arena;
    void *kept;
    run_cost check;
    const double start = now();
    sp_status status;

    without.effect[SP_EFFECT_FRICTION] = SP_WITHOUT;
    without.coupled.asked = without.localise = 0;
    *memory = NULL;
    status = run_check(scene, &without, &pressed, &check, &kept);
    cost->bytes = run_bytes(scene, SP_FOR_STRONG, settings);
    if (status == SP_OK) status = run_arena(cost->bytes, &arena, memory);
    if (status == SP_OK)
        status = sp_strong(scene, settings, how, f, pressed.verdict == SP_STABLE ? pressed.f : NULL, &arena, result);
    cost->seconds = now() - start;
    free(kept);
    return status;
}

sp_status run_strong_verify(const sp_scene *scene, const sp_settings *settings, const sp_strong_result *claim,
                            sp_strong_kind *proved)
{
    void *memory;
    sp_arena scratch;
    sp_status status = run_arena(run_bytes(scene, SP_FOR_STRONG_VERIFY, NULL), &scratch, &memory);
    if (status == SP_OK) status = sp_strong_verify(scene, settings, claim, scratch, proved);
    free(memory);
    return status;
}
#endif

sp_status run_limit(const sp_scene *scene, const sp_settings *settings, sp_limit_result *result, run_cost *cost, void **memory)
{
    sp_arena arena;
    sp_status status = counted(scene, SP_FOR_LIMIT, settings, &cost->bytes);
    double start;

    *memory = NULL;
    if (status == SP_OK) status = run_arena(cost->bytes, &arena, memory);
    if (status != SP_OK) return status;
    start = now();
    status = sp_limit(scene, settings, &arena, result);
    cost->seconds = now() - start;
    return status;
}

#ifndef SP_NO_SLIDING
sp_status run_sliding(const sp_scene *scene, const sp_settings *settings, const sp_limit_result *limit,
                      sp_sliding_result *result, run_cost *cost, void **memory)
{
    sp_arena arena;
    const double start = now();
    sp_status status;

    cost->bytes = run_bytes(scene, SP_FOR_SLIDING, settings);
    status = run_arena(cost->bytes, &arena, memory);
    if (status == SP_OK) status = sp_sliding(scene, settings, NULL, limit, &arena, result);
    cost->seconds = now() - start;
    return status;
}

sp_status run_sliding_verify(const sp_scene *scene, const sp_settings *settings, const sp_sliding_result *claim,
                             sp_sliding_evidence *evidence)
{
    void *memory;
    sp_arena scratch;
    sp_status status = run_arena(run_bytes(scene, SP_FOR_SLIDING_VERIFY, NULL), &scratch, &memory);
    if (status == SP_OK) status = sp_sliding_verify(scene, settings, claim, scratch, evidence);
    free(memory);
    return status;
}
#endif

sp_status run_bytes_of(const sp_scene *scene, sp_memory_for what, const sp_settings *settings, size_t *bytes)
{
    return counted(scene, what, settings, bytes);
}

sp_status run_sequence(const sp_scene *scene, const sp_settings *settings, sp_sequence **sequence, size_t *bytes,
                       void **memory)
{
    sp_arena arena;
    sp_status status = counted(scene, SP_FOR_SEQUENCE, settings, bytes);
    *memory = NULL;
    if (status == SP_OK) status = run_arena(*bytes, &arena, memory);
    if (status == SP_OK) status = sp_sequence_open(scene, settings, &arena, sequence);
    return status;
}

#ifndef SP_NO_PLAN
sp_status run_plan(const sp_scene *scene, const sp_settings *settings, sp_outlook *outlook)
{
    void *memory;
    sp_arena scratch;
    sp_status status = run_arena(run_bytes(scene, SP_FOR_PLAN, settings), &scratch, &memory);
    if (status == SP_OK) status = sp_plan(scene, settings, scratch, outlook);
    free(memory);
    return status;
}
#endif

sp_status run_verify(const sp_scene *scene, const sp_settings *settings, const sp_result *claim, sp_evidence *evidence)
{
    void *memory;
    sp_arena scratch;
    sp_status status = run_arena(run_bytes(scene, SP_FOR_VERIFY, NULL), &scratch, &memory);
    if (status == SP_OK) status = sp_verify(scene, settings, claim, scratch, evidence);
    free(memory);
    return status;
}

static sp_status qp_bytes(const sp_qp_solver *solver, const sp_qp *qp, const sp_qp_settings *settings, size_t *bytes)
{
    void *memory;
    sp_arena scratch;
    sp_status status = run_arena(sp_qp_memory_scratch(qp, settings), &scratch, &memory);
    if (status == SP_OK) status = solver->need(solver->self, qp, settings, scratch, bytes);
    free(memory);
    return status;
}

sp_status run_qp(const sp_qp_solver *solver, const sp_qp *qp, const sp_qp_settings *settings, sp_qp_result *result,
                 run_cost *cost, void **memory)
{
    const double start = now();
    sp_arena arena;
    sp_status status = qp_bytes(solver, qp, settings, &cost->bytes);

    *memory = NULL;
    if (status == SP_OK) status = run_arena(cost->bytes, &arena, memory);
    if (status == SP_OK) status = solver->solve(solver->self, qp, settings, &arena, NULL, NULL, result);
    cost->seconds = now() - start;
    return status;
}
