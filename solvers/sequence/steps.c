/* steps: a block comes, goes, is held or let go; islands that this touches are checked again. */
#ifndef SP__SEQUENCE_STEPS_C
#define SP__SEQUENCE_STEPS_C

#include "local.c"

#if SP__WITH_LARGE

/* Every island with a stale block is looked at again. */
SP__NOINLINE static sp_status sp__sequence_recheck(sp_sequence *q)
{
    for (int32_t b = 0; b < q->scene->count.blocks; b++)
        if (sp__free_now(q, b) && q->now.state[b].stale) q->now.state[sp__root(q->island, b)].stale = 1;
    for (int32_t root = 0; root < q->scene->count.blocks; root++) {
        if (!sp__free_now(q, root) || sp__root(q->island, root) != root || !q->now.state[root].stale) continue;
        q->spent.checked++;
        if (sp__local_island(q, root)) continue;
        sp__check *c = NULL;
        sp__part_island(q, root);
        const sp_status status = sp__part_check(q, q->now.f, q->now.dq, &c);
        if (status) return status;
        sp__part_record(q, c);
    }
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->now.state[b].stale = 0;
    return SP_OK;
}

/* The islands of block b and of what it touches are stale. */
static void sp__sequence_mark_stale(sp_sequence *q, int32_t b)
{
    const int32_t n = q->scene->count.blocks;
    for (int32_t k = 0; k < n; k++) q->chosen.mark[k] = 0;
    if (sp__free_now(q, b)) q->chosen.mark[sp__root(q->island, b)] = 1;
    for (int32_t k = q->graph.start[b]; k < q->graph.start[b + 1]; k++) {
        const int32_t s = sp__neighbour(&q->pb.contact[q->graph.joint[k]], b);
        if (sp__free_now(q, s)) q->chosen.mark[sp__root(q->island, s)] = 1;
    }
    for (int32_t k = 0; k < n; k++) q->now.state[k].stale |= sp__free_now(q, k) && q->chosen.mark[sp__root(q->island, k)];
}

/* Block b comes, goes, is held or let go: forces of joints that no longer count vanish, and who bore them is to be weighed. */
SP__NOINLINE static void sp__sequence_change(sp_sequence *q, int32_t b, sp_presence presence)
{
    sp__sequence_mark_stale(q, b);
    q->now.state[b].presence = presence;
    q->now.state[b].certified = 0;
    if (!sp__free_now(q, b)) for (size_t k = 0; k < 6; k++) q->now.dq[6 * (size_t)b + k] = 0;
    for (int32_t k = q->graph.start[b]; k < q->graph.start[b + 1]; k++) {
        const sp_contact *t = &q->pb.contact[q->graph.joint[k]];
        const int32_t s = sp__neighbour(t, b);
        const int both = presence != SP_ABSENT && q->now.state[s].presence != SP_ABSENT;
        if (both && (sp__free_now(q, b) || sp__free_now(q, s))) continue;
        q->now.state[s].certified = 0;
        memset(q->now.f + 3 * (size_t)t->point, 0, 3 * (size_t)t->points * sizeof *q->now.f);
    }
    if (presence == SP_ABSENT) q->held_last[b] = 0;
}

/* Counts of a step start at 0. */
static void sp__sequence_reset_counts(sp_sequence *q)
{
    memset(&q->spent, 0, sizeof q->spent);
}

/* Is it worse: unstable, then undecided, then stable? */
static int sp__verdict_worse(sp_verdict a, sp_verdict b)
{
    return a == SP_STABLE ? 0 : b == SP_STABLE || (a == SP_UNSTABLE && b == SP_UNDECIDED);
}

/* The result of the step. */
SP__NOINLINE static void sp__sequence_report(sp_sequence *q, sp_step *step)
{
    sp_real most = -1;
    memset(step, 0, sizeof *step);
    step->verdict = SP_STABLE;
    step->reason = SP_REASON_NOTHING;
    step->block = -1;
    for (int32_t b = 0; b < q->scene->count.blocks; b++) {
        const sp__block_state *s = &q->now.state[b];
        if (!sp__free_now(q, b)) continue;
        step->blocks++;
        step->islands += sp__root(q->island, b) == b;
        step->imbalance = sp__max(step->imbalance, s->imbalance);
        if (step->blocks == 1 || sp__verdict_worse(s->verdict, step->verdict)
            || (s->verdict == SP_STABLE && step->verdict == SP_STABLE && s->reason == SP_REASON_FORCES)) {
            if (s->verdict != step->verdict) step->block = b;
            step->verdict = s->verdict;
            step->reason = s->reason;
            step->final = s->final;
            step->least_imbalance = s->least;
        }
    }
    const int32_t root = step->block;
    for (size_t k = 0; k < 6 && !(most > 0); k += 3)    /* where nothing goes anywhere, what turns */
        for (int32_t b = 0; root >= 0 && b < q->scene->count.blocks; b++) {
            const sp_real moves = sp__norm3(q->now.dq + 6 * (size_t)b + k);
            if (!sp__free_now(q, b) || sp__root(q->island, b) != sp__root(q->island, root) || !(moves > most)) continue;
            most = moves;
            step->block = b;
        }
    step->checked = q->spent.checked;
    step->again = q->spent.again;
    step->local = q->spent.local;
    step->f = q->now.f;
    step->dq = q->now.dq;
    step->cost = q->spent.cost;
}

/* Block b so from now on. */
SP__NOINLINE static sp_status sp__sequence_set_presence(sp_sequence *q, int32_t b, sp_presence presence)
{
    if (presence == q->now.state[b].presence) return SP_OK;
    sp__sequence_change(q, b, presence);
    sp__sequence_islands(q);
    sp__sequence_mark_stale(q, b);
    return sp__sequence_recheck(q);
}

/* All blocks so from now on; every island is looked at again. */
SP__NOINLINE static sp_status sp__sequence_set_all(sp_sequence *q, const sp_presence *presence)
{
    for (int32_t b = 0; b < q->scene->count.blocks; b++)
        if (presence[b] != q->now.state[b].presence) sp__sequence_change(q, b, presence[b]);
    sp__sequence_islands(q);
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->now.state[b].stale = sp__free_now(q, b);
    return sp__sequence_recheck(q);
}

#endif

#endif /* SP__SEQUENCE_STEPS_C */
