/* calls: the public calls of a build order, over the steps of the large engine or of the smallest one (small_steps.c). Each
 * offers sp__sequence_work, _carve, _begin, _put, _put_all, _report, sp__next_candidate and sp__next_try. The search for what
 * to hold is each engine's own: how many checks that may take is what they differ in. */
#ifndef SP__SEQUENCE_CALLS_C
#define SP__SEQUENCE_CALLS_C

#include "hold.c"
#include "next.c"
#include "small_steps.c"

#if SP__WITH_SEQUENCE

static size_t sp__sequence_scratch(const sp_scene *scene, const sp_settings *settings)
{
    const size_t most = sp__check_scratch(scene, settings);
    return most ? sizeof(sp_sequence) + SP_ALIGN + most : 0;
}

/* Bytes of all that a sequence keeps, its checks' work among them. */
SP__NOINLINE static sp_status sp__sequence_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch,
                                                  size_t *bytes)
{
    if (!scratch.base) return SP_E_ARGUMENT;
    size_t work = 0;
    sp_sequence *q = sp__take(&scratch, 1, sizeof *q);
    if (!q) return SP_E_MEMORY;
    sp_status status = sp__sequence_work(scene, settings, scratch, &q->set, &work);
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *q);
    if (!status) status = sp__sequence_carve(q, scene, work, &dry);
    if (!status) *bytes = dry.used;
    return status;
}

SP_API sp_status sp_sequence_open(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_sequence **sequence)
{
    if (!scene || !arena || !arena->base || !sequence) return SP_E_ARGUMENT;
    size_t work = 0;
    sp_arena a = *arena;
    sp_sequence *q = sp__take(&a, 1, sizeof *q);
    if (!q) return SP_E_MEMORY;
    memset(q, 0, sizeof *q);
    q->scene = scene;
    sp_status status = sp__sequence_work(scene, settings, a, &q->set, &work);
    if (!status) status = sp__sequence_carve(q, scene, work, &a);
    if (!status) status = sp__sequence_begin(q);
    if (status) return status;
    *arena = a;
    *sequence = q;
    return SP_OK;
}

static int sp__presence_valid(sp_presence presence)
{
    return presence == SP_ABSENT || presence == SP_PRESENT || presence == SP_HELD;
}

SP_API sp_status sp_sequence_set(sp_sequence *sequence, int32_t block, sp_presence presence, sp_step *step)
{
    if (!sequence || !step || !sp__presence_valid(presence)) return SP_E_ARGUMENT;
    if (block < 0 || block >= sequence->scene->count.blocks) return SP_E_INDEX;
    sp__sequence_reset_counts(sequence);
    const sp_status status = sp__sequence_set_presence(sequence, block, presence);
    if (!status) sp__sequence_report(sequence, step);
    return status;
}

SP_API sp_status sp_sequence_fill(sp_sequence *sequence, const sp_presence *presence, sp_step *step)
{
    if (!sequence || !presence || !step) return SP_E_ARGUMENT;
    for (int32_t b = 0; b < sequence->scene->count.blocks; b++) if (!sp__presence_valid(presence[b])) return SP_E_ARGUMENT;
    sp__sequence_reset_counts(sequence);
    const sp_status status = sp__sequence_set_all(sequence, presence);
    if (!status) sp__sequence_report(sequence, step);
    return status;
}

/* A thousandth of its diameter lower is no lower; the smallest build saves the bytes. */
#define SP__LEVEL(diameter) (SP__WITH_SMALL ? 0 : (sp_real)1e-3 * (diameter))

/* The lowest (to add) or highest candidate not tried yet, q->found.tried 0; -1: none. */
SP__NOINLINE static int32_t sp__next_pick(sp_sequence *q, int32_t add)
{
    int32_t best = -1;
    for (int32_t b = 0; b < q->scene->count.blocks; b++) {
        const sp_real *g = q->scene->gravity;
        sp_real d[3] = { 0, 0, 0 };
        if (q->found.tried[b]) continue;
        if (best >= 0) sp__sub3(q->scene->block[b].centroid, q->scene->block[best].centroid, d);
        const sp_real deeper = (add ? 1 : -1) * sp__dot3(d, g);
        if (best < 0 || deeper > SP__LEVEL(q->scene->block[b].diameter * sp__norm3(g))) best = b;
    }
    if (best >= 0) q->found.tried[best] = 1;
    return best;
}

SP_API sp_status sp_sequence_suggest(sp_sequence *sequence, int32_t add, int64_t budget, sp_suggestion *suggestion)
{
    if (!sequence || !suggestion || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    int32_t b = 0, tried = 0;
    int all = 1, stands = 0;
    sp__sequence_reset_counts(q);
    for (b = 0; b < q->scene->count.blocks; b++) q->found.tried[b] = !sp__next_candidate(q, b, add);
    while (!stands && (b = sp__next_pick(q, add)) >= 0) {
        all = !(budget > 0 && q->spent.cost.flops >= budget);
        if (!all) break;
        const sp_status status = sp__next_try(q, b, add, &stands);
        if (status) return status;
        tried++;
    }
    suggestion->block = stands ? b : -1;
    suggestion->tried = tried;
    suggestion->all = all;
    suggestion->cost = q->spent.cost;
    return SP_OK;
}

#else

static size_t sp__sequence_scratch(const sp_scene *scene, const sp_settings *settings)
{
    return (void)settings, scene ? SP_ALIGN : 0;
}
static sp_status sp__sequence_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    return (void)scene, (void)settings, (void)scratch, (void)bytes, SP_E_UNSUPPORTED;
}

#endif

#endif /* SP__SEQUENCE_CALLS_C */
