/* next: a stone that may come, or go, next so that everything stands after it; lowest first to add, highest first to remove. */
#ifndef SP__SEQUENCE_NEXT_C
#define SP__SEQUENCE_NEXT_C

#include "steps.c"

#if SP__WITH_LARGE

#define SP__LEVEL ((sp_real)1e-3)        /* of its diameter: so much lower is no lower */

/* May block b be tried as the next one? */
static int sp__next_candidate(const sp_sequence *q, int32_t b, int32_t add)
{
    if (q->row[b] < 0) return 0;
    if (!add) return q->state[b].presence == SP_PRESENT;
    if (q->state[b].presence != SP_ABSENT) return 0;
    for (int32_t k = q->start[b]; k < q->start[b + 1]; k++)
        if (q->state[sp__neighbour(&q->pb.contact[q->joint[k]], b)].presence != SP_ABSENT) return 1;
    return 0;
}

/* The lowest (to add) or highest candidate not tried yet, q->answer 0; -1: none. */
static int32_t sp__next_pick(sp_sequence *q, int32_t add)
{
    int32_t best = -1;
    for (int32_t b = 0; b < q->scene->count.blocks; b++) {
        const sp_real *g = q->scene->gravity;
        sp_real d[3] = { 0, 0, 0 };
        if (q->answer[b]) continue;
        if (best >= 0) sp__sub3(q->scene->block[b].centroid, q->scene->block[best].centroid, d);
        const sp_real deeper = (add ? 1 : -1) * sp__dot3(d, g);
        if (best < 0 || deeper > SP__LEVEL * q->scene->block[b].diameter * sp__norm3(g)) best = b;
    }
    if (best >= 0) q->answer[best] = 1;
    return best;
}

/* Would everything stand with block b there, or gone? All that is known stays as it is. */
SP__NOINLINE static sp_status sp__next_try(sp_sequence *q, int32_t b, int32_t add, int *stands)
{
    const size_t n = (size_t)q->scene->count.blocks, v = 3 * (size_t)q->scene->count.points;
    const int32_t was = q->was[b];
    memcpy(q->state_saved, q->state, n * sizeof *q->state);
    memcpy(q->f_saved, q->f, v * sizeof *q->f);
    memcpy(q->dq_saved, q->dq, 6 * n * sizeof *q->dq);
    sp__sequence_change(q, b, add ? SP_PRESENT : SP_ABSENT);
    sp__sequence_islands(q);
    sp__sequence_mark_stale(q, b);
    const sp_status status = sp__sequence_recheck(q);
    *stands = 1;
    for (int32_t k = 0; k < q->scene->count.blocks; k++) *stands &= !sp__free_now(q, k) || q->state[k].verdict == SP_STABLE;
    memcpy(q->state, q->state_saved, n * sizeof *q->state);
    memcpy(q->f, q->f_saved, v * sizeof *q->f);
    memcpy(q->dq, q->dq_saved, 6 * n * sizeof *q->dq);
    q->was[b] = was;
    sp__sequence_islands(q);
    return status;
}

SP_API sp_status sp_sequence_suggest(sp_sequence *sequence, int32_t add, int64_t budget, sp_suggestion *suggestion)
{
    if (!sequence || !suggestion || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    int32_t found = -1, tried = 0, all = 1;
    sp__sequence_start(q);
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->answer[b] = !sp__next_candidate(q, b, add);
    for (int32_t b = sp__next_pick(q, add); b >= 0 && found < 0; b = sp__next_pick(q, add)) {
        int stands = 0;
        all = !(budget > 0 && q->cost.flops >= budget);
        if (!all) break;
        const sp_status status = sp__next_try(q, b, add, &stands);
        if (status) return status;
        tried++;
        if (stands) found = b;
    }
    suggestion->block = found;
    suggestion->tried = tried;
    suggestion->all = all;
    suggestion->cost = q->cost;
    return SP_OK;
}

#endif

#endif /* SP__SEQUENCE_NEXT_C */
