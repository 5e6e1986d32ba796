/* memory: the arrays a check keeps, the needs of its stages, and both carved in an arena, dry or for real. */
#ifndef SP__CHECK_MEMORY_C
#define SP__CHECK_MEMORY_C

#include "../coupled/alternate.c"
#include "../coupled/open.c"
#include "parts.c"
#include "settings.c"

#ifndef SP_SMALL
/* The arrays of a result, which a check keeps, in front of everything that goes again. */
typedef struct sp__result_arrays {
    sp_real *f, *dq, *y0;
    sp_demand *demand;
    int32_t *island;                    /* where there is more than one */
    sp_island *part;
    sp_real *cdq, *alpha, *penalty;     /* of the coupled check, where it is asked */
    size_t used;                        /* of the arena so far */
    sp_proof proof;
} sp__result_arrays;

#if SP__WITH_COUPLED
/* Besides, what a coupled check keeps. */
static void sp__result_arrays_coupled(sp__result_arrays *r, const sp_scene *scene, const sp__island_counts *counts,
                                      const sp_settings *set, sp_arena *a)
{
    r->cdq = sp__take(a, (size_t)scene->count.blocks, 6 * sizeof *r->cdq);
    r->alpha = sp__take(a, (size_t)scene->count.points, sizeof *r->alpha);
    if (set->localise) r->penalty = sp__take(a, (size_t)scene->count.points, 4 * sizeof *r->penalty);
    r->used = a->used;
    sp__proof_carve(&r->proof, counts->points, counts->blocks, set, a);
}
#else
static void sp__result_arrays_coupled(sp__result_arrays *r, const sp_scene *scene, const sp__island_counts *counts,
                                      const sp_settings *set, sp_arena *a)
{
    (void)r; (void)scene; (void)counts; (void)set; (void)a;
}
#endif

static void sp__result_arrays_carve(sp__result_arrays *r, const sp_scene *scene, int32_t free_blocks,
                                    const sp__island_counts *counts, const sp_settings *set, sp_arena *a)
{
    memset(r, 0, sizeof *r);
    r->f = sp__take(a, (size_t)scene->count.points, 3 * sizeof *r->f);
    r->dq = sp__take(a, (size_t)scene->count.blocks, 6 * sizeof *r->dq);
    r->y0 = sp__take(a, (size_t)free_blocks, 12 * sizeof *r->y0);
    r->demand = sp__take(a, (size_t)scene->count.joints, sizeof *r->demand);
    if (counts->islands > 1) {
        r->island = sp__take(a, (size_t)scene->count.blocks, sizeof *r->island);
        r->part = sp__take(a, (size_t)counts->islands, sizeof *r->part);
    }
    r->used = a->used;
    if (SP__WITH_COUPLED && set && set->coupled.asked) sp__result_arrays_coupled(r, scene, counts, set, a);
}

/* Bytes of that. */
SP__NOINLINE static size_t sp__result_arrays_need(const sp_scene *scene, int32_t free_blocks, const sp__island_counts *counts,
                                                  const sp_settings *set)
{
    sp__result_arrays kept;
    sp_arena dry = sp__arena_dry();
    sp__result_arrays_carve(&kept, scene, free_blocks, counts, set, &dry);
    return dry.used;
}

/* The state that stages work on, numbered as the problem is; what has been checked of it is written at the scene's numbers. The
 * forces of a whole scene are the result's own unless there is a budget, where the result keeps the best of all stages. */
static void sp__state_carve(sp_state *s, const sp_problem *pb, const sp_settings *set, int part, sp_arena *a)
{
    s->y = sp__take(a, (size_t)pb->blocks, 6 * sizeof *s->y);
    s->dq = sp__take(a, (size_t)pb->blocks, 6 * sizeof *s->dq);
    if (part || set->budget > 0) s->f = sp__take(a, (size_t)pb->points, 3 * sizeof *s->f);
    if (part) s->y0 = sp__take(a, (size_t)pb->blocks, 12 * sizeof *s->y0);
}

/* Everything that a check works on. It is in the arena, behind what it keeps, because it is too large for a small stack. */
typedef struct sp__check {
    sp_settings set;
    sp_problem pb;
    sp_state state;
    sp_result r;
    size_t arrays, kept;                /* of the arena: what the result takes, and that with room for a proof */
} sp__check;

#else
typedef struct sp__check { sp_settings set; sp_problem pb; sp_result r; } sp__check;
#endif

#ifndef SP_SMALL
/* Scratch of a problem and its symbolic step. */
static size_t sp__whole_scratch(const sp_scene *scene, const sp_settings *settings)
{
    sp_problem pb;
    sp__problem_count(scene, &pb);
    size_t most = sp__system_scratch(&pb);
    for (int32_t k = 0; SP__WITH_ADMM && settings && k < settings->stage_count; k++) {
        if (settings->stage[k] != SP_STAGE_ADMM) continue;
        const size_t need = sp__admm_scratch(&pb, settings);
        if (need == 0) return 0;
        if (need > most) most = need;
    }
    if (SP__WITH_ADMM && SP__WITH_COUPLED && settings && settings->coupled.asked && settings->coupled.rounds) {
        const size_t need = sp__alt_scratch(&pb, settings);
        if (need == 0) return 0;
        if (need > most) most = need;
    }
    return sp__problem_memory(scene) + SP_ALIGN + most;
}

/* Tables of islands and the vertices of the largest, at most. */
static size_t sp__islands_scratch(const sp_scene *scene)
{
    sp__islands t;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof t);
    sp__islands_carve(&t, scene, scene->count.blocks, NULL, &dry);
    sp__take(&dry, (size_t)scene->count.points, sizeof *scene->point);
    return dry.used + 2 * SP_ALIGN;
}

static size_t sp__check_scratch(const sp_scene *scene, const sp_settings *settings)
{
    if (!scene || (settings && (settings->stage_count < 0 || settings->stage_count > SP_STAGES_MAX))) return 0;
    const size_t whole = sp__whole_scratch(scene, settings);
    return whole ? sizeof(sp__check) + SP_ALIGN + whole + (sp__islands_allowed(settings) ? sp__islands_scratch(scene) : 0) : 0;
}

/* The largest need of the chosen stages and of what judges them, SIZE_MAX: scratch too small. */
SP__NOINLINE static size_t sp__stages_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    const size_t most = sp__certifier_need(pb, set);
    size_t work = 0;
    for (int32_t k = 0; k <= set->stage_count && pb->blocks; k++) {
        if (k == set->stage_count && !set->localise) break;
        const size_t need = k < set->stage_count ? sp__stage_calls(set, set->stage[k]).need(pb, set, scratch)
                                                 : sp__system_need_reduced(pb, set, SP__PENALTY, scratch);
        if (need > work) work = need;
    }
    if (!set->work) return most > work ? most : work;
    if (!set->work->base && work > set->work->peak) set->work->peak = work;     /* SP_FOR_WORK asks */
    return work == SIZE_MAX ? work : most;
}

/* Bytes of a problem, what stages leave and what is done to it; SIZE_MAX: scratch too small. */
static size_t sp__problem_need(const sp_problem *pb, const sp_settings *set, int part, size_t work)
{
    sp_state state;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, part ? sp__part_bytes(pb) : sp__problem_memory(pb->scene));
    sp__state_carve(&state, pb, set, part, &dry);
    sp__take(&dry, 1, work);
    return work == SIZE_MAX ? SIZE_MAX : dry.used;
}

/* That of every stage and of the coupled check on the problem c->pb, which is built. */
SP__NOINLINE static sp_status sp__built_need(sp__check *c, int part, sp_arena scratch, size_t *bytes)
{
    size_t work = sp__stages_need(&c->pb, &c->set, scratch);
    if (SP__WITH_COUPLED && c->set.coupled.asked) {
        const size_t need = sp__coupled_need(&c->pb, &c->set, sp__alt_need(&c->pb, &c->set, scratch), scratch);
        if (need > work) work = need;
    }
    *bytes = sp__problem_need(&c->pb, &c->set, part, work);
    return *bytes == SIZE_MAX ? SP_E_MEMORY : SP_OK;
}

/* Bytes of the stages and the coupled check of a whole scene. */
static sp_status sp__whole_need(const sp_scene *scene, sp__check *c, sp_arena scratch, size_t *bytes)
{
    const sp_status status = sp_problem_build(scene, &scratch, &c->pb);
    return status ? status : sp__built_need(c, 0, scratch, bytes);
}

/* Bytes of a part's check; c: what it works on. */
SP__NOINLINE static sp_status sp__part_need(const sp_scene *scene, const sp__part *part, sp__check *c, sp_arena scratch,
                                            size_t *bytes)
{
    sp_arena dry = sp__arena_dry();
    sp_status status = sp__part_build(scene, part, &scratch, &c->pb);
    if (!status) status = sp__built_need(c, 1, scratch, bytes);
    if (status) return status;
    sp__take(&dry, 1, sizeof *c);
    sp__take(&dry, 1, *bytes);
    *bytes = dry.used;
    return SP_OK;
}

/* The check of one island after the other: where it is, and what it keeps besides the result. */
typedef struct sp__island_loop {
    sp__islands t;
    int32_t at, again;                  /* the island, 1: only for its proof */
    int32_t proof_kept;                 /* the proof is still in the room that all share */
    sp_proof proof;                     /* of the last that was refuted */
    sp_real margin;
    size_t start, mark;                 /* of the arena: before this, behind the tables */
} sp__island_loop;

/* Bytes of the tables and what is `behind`. */
SP__NOINLINE static size_t sp__island_loop_bytes(const sp_scene *scene, int32_t count, size_t behind)
{
    sp__islands t;
    int32_t label = 0;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof(sp__island_loop));
    sp__islands_carve(&t, scene, count, &label, &dry);
    sp__take(&dry, 1, behind);
    return dry.used;
}

/* Bytes of the tables and the island that wants most. */
SP__NOINLINE static sp_status sp__islands_need(const sp_scene *scene, int32_t count, sp__check *c, sp_arena scratch,
                                               size_t *bytes)
{
    size_t most = 0;
    sp__islands *t = sp__take(&scratch, 1, sizeof *t);
    if (!t) return SP_E_MEMORY;
    sp__islands_carve(t, scene, count, NULL, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__islands_fill(scene, t);
    for (int32_t k = 0; k < count; k++) {
        const sp__part part = sp__islands_part(t, k);
        const sp_status status = sp__part_need(scene, &part, c, scratch, bytes);
        if (status) return status;
        if (*bytes > most) most = *bytes;
    }
    *bytes = sp__island_loop_bytes(scene, count, most);
    return SP_OK;
}

/* Bytes behind what a check keeps: islands counts, then all of them judged; or the whole. */
SP__NOINLINE static sp_status sp__work_need(const sp_scene *scene, int32_t islands, sp__check *c, sp_arena scratch,
                                            size_t *bytes)
{
    if (islands < 2) return sp__whole_need(scene, c, scratch, bytes);
    sp__problem_count(scene, &c->pb);
    const size_t judged = sp__problem_need(&c->pb, &c->set, 0, sp__certifier_need(&c->pb, &c->set));
    const sp_status status = sp__islands_need(scene, islands, c, scratch, bytes);
    if (judged > *bytes) *bytes = judged;
    return status;
}

/* SP_MEMORY_BYTES holds only if structs and sizes that the header does not show are no larger than this,
 * in double and float. */
typedef char sp__memory_bytes_holds[sizeof(sp_real) > 8 || (sizeof(sp__system) <= (SP_MIXED_BYTES(0, 0) ? 416 : 400)
                                    && sizeof(sp__yield) <= 64
                                    && sizeof(sp__scale) <= 13 * sizeof(sp_real)
                                    && sizeof(sp__scratch) <= 102 * sizeof(sp_real) && SP_ALIGN == 16) ? 1 : -1];
typedef char sp__memory_bytes_holds_reduction[sizeof(sp_real) > 8 || SP__REDUCTION_G <= 20 ? 1 : -1];
typedef char sp__memory_bytes_holds_inner[sizeof(sp_real) > 8 || sizeof(sp__ipm) <= 144 ? 1 : -1];      /* 368 + 144 = 512 */
typedef char sp__memory_bytes_holds_strength[sizeof(sp_real) > 8 || sizeof(sp__capped) <= 68 * sizeof(sp_real) + 8 ? 1 : -1];

#if SP__WITH_COUPLED
typedef char sp__memory_bytes_holds_coupled[sizeof(sp_real) > 8 || (sizeof(sp__cra) <= 448 && sizeof(sp__branch) <= 448
                                            && sizeof(sp__refute) <= 448 && SP__ROWS <= 21 && SP__PROOF_DEPTH <= 32) ? 1 : -1];
#endif
#if SP__WITH_ADMM
typedef char sp__memory_bytes_holds_program[sizeof(sp_real) > 8 || sizeof(sp__program) + sizeof(sp__qp) <= 1280 ? 1 : -1];
#endif

/* As sp_memory, which has seen to scene and bytes; work: where not NULL, an arena that counts in place of settings.work. */
static sp_status sp__memory(const sp_scene *scene, const sp_settings *settings, sp_arena *work, sp_arena scratch, size_t *bytes)
{
    if (!scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__island_counts counts;
    const sp_status counted = sp__islands_count(scene, settings, scratch, &counts);
    sp__check *c = sp__take(&scratch, 1, sizeof *c);
    if (!c || counted) return SP_E_MEMORY;
    sp_status status = sp__settings_resolve(scene, settings, &c->set);
    size_t behind = 0;
    if (work) c->set.work = work;
    if (!status) status = sp__work_need(scene, counts.islands, c, scratch, &behind);
    if (status) return status;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &c->pb);
    sp__take(&dry, 1, sp__result_arrays_need(scene, c->pb.blocks, &counts, &c->set));
    sp__take(&dry, 1, sizeof *c);
    sp__take(&dry, 1, behind);
    *bytes = dry.used;
    return SP_OK;
}

SP__NOINLINE static sp_status sp__check_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch,
                                               size_t *bytes)
{
    return sp__memory(scene, settings, NULL, scratch, bytes);
}

/* Bytes of settings.work, where stages have an arena of their own. */
SP__NOINLINE static sp_status sp__work_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch,
                                              size_t *bytes)
{
    sp_arena work = sp__arena_dry();
    const sp_status status = sp__memory(scene, settings, &work, scratch, bytes);
    if (!status) *bytes = work.peak;
    return status;
}

/* The memory that stages work in: settings.work, or the rest of the check's. */
static sp_arena sp__work_open(const sp_settings *set, const sp_arena *a) { return set->work ? *set->work : *a; }

/* Afterwards: the peak of that memory goes to where it came from. */
static void sp__work_close(const sp_settings *set, sp_arena *a, const sp_arena *room)
{
    if (set->work) a = set->work;
    if (room->peak > a->peak) a->peak = room->peak;
}

#endif

#endif /* SP__CHECK_MEMORY_C */
