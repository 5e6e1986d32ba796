/* steps: a block comes, goes, is held or let go; islands that this touches are checked again. */
#ifndef SP__SEQUENCE_STEPS_C
#define SP__SEQUENCE_STEPS_C

#include "local.c"

#if SP__WITH_LARGE

/* Every island with a stale block is looked at again. */
SP__NOINLINE static sp_status sp__sequence_recheck(sp_sequence *q)
{
    for (int32_t b = 0; b < q->scene->count.blocks; b++)
        if (sp__free_now(q, b) && q->state[b].stale) q->state[sp__root(q->up, b)].stale = 1;
    for (int32_t root = 0; root < q->scene->count.blocks; root++) {
        if (!sp__free_now(q, root) || sp__root(q->up, root) != root || !q->state[root].stale) continue;
        q->checked++;
        if (sp__local_island(q, root)) continue;
        sp__check *c = NULL;
        sp__part_island(q, root);
        const sp_status status = sp__part_check(q, q->f, q->dq, &c);
        if (status) return status;
        sp__part_keep(q, c);
    }
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->state[b].stale = 0;
    return SP_OK;
}

/* The islands of block b and of what it touches are stale. */
static void sp__sequence_mark_stale(sp_sequence *q, int32_t b)
{
    const int32_t n = q->scene->count.blocks;
    for (int32_t k = 0; k < n; k++) q->mark[k] = 0;
    if (sp__free_now(q, b)) q->mark[sp__root(q->up, b)] = 1;
    for (int32_t k = q->start[b]; k < q->start[b + 1]; k++) {
        const int32_t s = sp__neighbour(&q->pb.contact[q->joint[k]], b);
        if (sp__free_now(q, s)) q->mark[sp__root(q->up, s)] = 1;
    }
    for (int32_t k = 0; k < n; k++) q->state[k].stale |= sp__free_now(q, k) && q->mark[sp__root(q->up, k)];
}

/* Block b comes, goes, is held or let go: forces of joints that no longer count vanish, and who bore them is to be weighed. */
SP__NOINLINE static void sp__sequence_change(sp_sequence *q, int32_t b, sp_presence presence)
{
    sp__sequence_mark_stale(q, b);
    q->state[b].presence = presence;
    q->state[b].certified = 0;
    if (!sp__free_now(q, b)) for (size_t k = 0; k < 6; k++) q->dq[6 * (size_t)b + k] = 0;
    for (int32_t k = q->start[b]; k < q->start[b + 1]; k++) {
        const sp_contact *t = &q->pb.contact[q->joint[k]];
        const int32_t s = sp__neighbour(t, b);
        if (presence != SP_ABSENT && q->state[s].presence != SP_ABSENT && (sp__free_now(q, b) || sp__free_now(q, s))) continue;
        q->state[s].certified = 0;
        memset(q->f + 3 * (size_t)t->point, 0, 3 * (size_t)t->points * sizeof *q->f);
    }
    if (presence == SP_ABSENT) q->was[b] = 0;
}

/* Counts of a step start at 0. */
static void sp__sequence_start(sp_sequence *q)
{
    memset(&q->cost, 0, sizeof q->cost);
    q->checked = q->again = q->local = q->tries = 0;
}

/* Is it worse: unstable, then undecided, then stable? */
static int sp__worse(sp_verdict a, sp_verdict b)
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
        const sp__block_state *s = &q->state[b];
        if (!sp__free_now(q, b)) continue;
        step->blocks++;
        step->islands += sp__root(q->up, b) == b;
        step->imbalance = sp__max(step->imbalance, s->imbalance);
        if (step->blocks == 1 || sp__worse(s->verdict, step->verdict)
            || (s->verdict == SP_STABLE && step->verdict == SP_STABLE && s->reason == SP_REASON_FORCES)) {
            if (s->verdict != step->verdict) step->block = b;
            step->verdict = s->verdict;
            step->reason = s->reason;
            step->final = s->final;
            step->least_imbalance = s->least;
        }
    }
    for (int32_t b = 0, root = step->block; root >= 0 && b < q->scene->count.blocks; b++) {
        const sp_real *dq = q->dq + 6 * (size_t)b;
        if (!sp__free_now(q, b) || sp__root(q->up, b) != sp__root(q->up, root) || !(sp__norm3(dq) > most)) continue;
        most = sp__norm3(dq);
        step->block = b;
    }
    step->checked = q->checked;
    step->again = q->again;
    step->local = q->local;
    step->f = q->f;
    step->dq = q->dq;
    step->cost = q->cost;
}

static int sp__presence_valid(sp_presence presence)
{
    return presence == SP_ABSENT || presence == SP_PRESENT || presence == SP_HELD;
}

SP_API sp_status sp_sequence_set(sp_sequence *sequence, int32_t block, sp_presence presence, sp_step *step)
{
    if (!sequence || !step || !sp__presence_valid(presence)) return SP_E_ARGUMENT;
    if (block < 0 || block >= sequence->scene->count.blocks) return SP_E_INDEX;
    sp__sequence_start(sequence);
    if (presence != sequence->state[block].presence) {
        sp__sequence_change(sequence, block, presence);
        sp__sequence_islands(sequence);
        sp__sequence_mark_stale(sequence, block);
        const sp_status status = sp__sequence_recheck(sequence);
        if (status) return status;
    }
    sp__sequence_report(sequence, step);
    return SP_OK;
}

SP_API sp_status sp_sequence_fill(sp_sequence *sequence, const sp_presence *presence, sp_step *step)
{
    if (!sequence || !presence || !step) return SP_E_ARGUMENT;
    for (int32_t b = 0; b < sequence->scene->count.blocks; b++) if (!sp__presence_valid(presence[b])) return SP_E_ARGUMENT;
    sp__sequence_start(sequence);
    for (int32_t b = 0; b < sequence->scene->count.blocks; b++)
        if (presence[b] != sequence->state[b].presence) sp__sequence_change(sequence, b, presence[b]);
    sp__sequence_islands(sequence);
    for (int32_t b = 0; b < sequence->scene->count.blocks; b++) sequence->state[b].stale = sp__free_now(sequence, b);
    const sp_status status = sp__sequence_recheck(sequence);
    if (status) return status;
    sp__sequence_report(sequence, step);
    return SP_OK;
}

#endif

#endif /* SP__SEQUENCE_STEPS_C */
