/* Memory of malloc's, and one call of the library in it: the library itself never asks for memory.
 *
 * What a call leaves behind lies in *memory, which the caller frees in every case; where there is no `memory`, nothing stays.
 * Each returns what the call of the library returns, and SP_E_MEMORY where malloc has no more. */
#ifndef STONEPACK_HOST_RUN_H
#define STONEPACK_HOST_RUN_H

#include "../../stonepack.h"

/* What a call took. */
typedef struct run_cost {
    size_t bytes;               /* of its arena */
    double seconds;             /* of the call alone, without the count of its memory */
} run_cost;

/* An arena of so many bytes; of 0 an empty one, in which the library says itself what it refuses. */
sp_status run_arena(size_t bytes, sp_arena *arena, void **memory);

/* sp_memory of what follows from counts alone; 0 where it is refused. */
size_t run_bytes(const sp_scene *scene, sp_memory_for what, const sp_settings *settings);

/* sp_memory, also of what needs scratch. */
sp_status run_bytes_of(const sp_scene *scene, sp_memory_for what, const sp_settings *settings, size_t *bytes);

/* sp_check, and the bytes of its arena alone. */
sp_status run_check(const sp_scene *scene, const sp_settings *settings, sp_result *result, run_cost *cost, void **memory);
sp_status run_check_bytes(const sp_scene *scene, const sp_settings *settings, size_t *bytes);

#ifndef SP_NO_STRONG
/* sp_strong after a check (its forces f) and one without friction; sp_strong_verify */
sp_status run_strong(const sp_scene *scene, const sp_settings *settings, const sp_strong_settings *how, const sp_real *f,
                     sp_strong_result *result, run_cost *cost, void **memory);
sp_status run_strong_verify(const sp_scene *scene, const sp_settings *settings, const sp_strong_result *claim,
                            sp_strong_kind *proved);
#endif

/* sp_limit */
sp_status run_limit(const sp_scene *scene, const sp_settings *settings, sp_limit_result *result, run_cost *cost, void **memory);

#ifndef SP_NO_SLIDING
/* sp_sliding after a limit; sp_sliding_verify */
sp_status run_sliding(const sp_scene *scene, const sp_settings *settings, const sp_limit_result *limit,
                      sp_sliding_result *result, run_cost *cost, void **memory);
sp_status run_sliding_verify(const sp_scene *scene, const sp_settings *settings, const sp_sliding_result *claim,
                             sp_sliding_evidence *evidence);
#endif

/* sp_sequence_open; the sequence lies in *memory. */
sp_status run_sequence(const sp_scene *scene, const sp_settings *settings, sp_sequence **sequence, size_t *bytes,
                       void **memory);

/* sp_plan, but in a library without it, as the battery of tests/instruments has it; sp_verify */
#ifndef SP_NO_PLAN
sp_status run_plan(const sp_scene *scene, const sp_settings *settings, sp_outlook *outlook);
#endif
sp_status run_verify(const sp_scene *scene, const sp_settings *settings, const sp_result *claim, sp_evidence *evidence);

/* The `solve` of a solver of quadratic programs, its time with the count of its memory. */
sp_status run_qp(const sp_qp_solver *solver, const sp_qp *qp, const sp_qp_settings *settings, sp_qp_result *result,
                 run_cost *cost, void **memory);

#endif
