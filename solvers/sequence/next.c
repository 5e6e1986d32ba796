/* next: may a stone come, or go, next, and would everything stand after it? */
#ifndef SP__SEQUENCE_NEXT_C
#define SP__SEQUENCE_NEXT_C

#include "steps.c"

#if SP__WITH_LARGE

/* May block b be tried as the next one? */
static int sp__next_candidate(const sp_sequence *q, int32_t b, int32_t add)
{
    if (q->graph.row[b] < 0) return 0;
    if (!add) return q->now.state[b].presence == SP_PRESENT;
    if (q->now.state[b].presence != SP_ABSENT) return 0;
    for (int32_t k = q->graph.start[b]; k < q->graph.start[b + 1]; k++)
        if (q->now.state[sp__neighbour(&q->pb.contact[q->graph.joint[k]], b)].presence != SP_ABSENT) return 1;
    return 0;
}

/* Would everything stand with block b there, or gone? All that is known stays as it is. */
SP__NOINLINE static sp_status sp__next_try(sp_sequence *q, int32_t b, int32_t add, int *stands)
{
    const size_t n = (size_t)q->scene->count.blocks, v = 3 * (size_t)q->scene->count.points;
    const int32_t was = q->held_last[b];
    memcpy(q->saved.state, q->now.state, n * sizeof *q->now.state);
    memcpy(q->saved.f, q->now.f, v * sizeof *q->now.f);
    memcpy(q->saved.dq, q->now.dq, 6 * n * sizeof *q->now.dq);
    sp__sequence_change(q, b, add ? SP_PRESENT : SP_ABSENT);
    sp__sequence_islands(q);
    sp__sequence_mark_stale(q, b);
    const sp_status status = sp__sequence_recheck(q);
    *stands = 1;
    for (int32_t k = 0; k < q->scene->count.blocks; k++) *stands &= !sp__free_now(q, k) || q->now.state[k].verdict == SP_STABLE;
    memcpy(q->now.state, q->saved.state, n * sizeof *q->now.state);
    memcpy(q->now.f, q->saved.f, v * sizeof *q->now.f);
    memcpy(q->now.dq, q->saved.dq, 6 * n * sizeof *q->now.dq);
    q->held_last[b] = was;
    sp__sequence_islands(q);
    return status;
}

#endif

#endif /* SP__SEQUENCE_NEXT_C */
