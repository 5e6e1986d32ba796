/* hold: the smallest set of blocks that must be held so that all others stand: every set up to 8 blocks, then a minimal one. */
#ifndef SP__SEQUENCE_HOLD_C
#define SP__SEQUENCE_HOLD_C

#include "steps.c"

#if SP__WITH_LARGE

/* Holding a block takes its six equations away and forbids no force: whatever set makes an assembly stand, a larger one does,
 * too (forces between two held blocks are 0, which every K_v holds). So a block that falls with all others held is in every
 * set, one pass of letting go leaves a set that can lose no block, and sets of one and two need few proofs. */

/* h->worst: the block that moves farthest in what was found, of equals the first. */
SP__NOINLINE static void sp__hold_farthest(sp__hold *h, const sp__check *c)
{
    sp_real most = -1;
    for (int32_t i = 0; i < c->pb.blocks; i++) {
        const int32_t b = c->pb.block[i];
        const sp_real size = sp__norm3(c->r.dq + 6 * (size_t)b);
        if (!(size > most) && !(size >= most && b < h->worst)) continue;
        most = size;
        h->worst = b;
    }
}

/* Do the members stand that are not held now?     returns 0 also when the budget is spent */
SP__NOINLINE static int sp__hold_stands(sp__hold *h)
{
    sp_sequence *q = h->q;
    q->spent.tries++;
    sp__sequence_islands(q);
    for (int32_t k = 0; k < h->members; k++) {
        sp__check *c = NULL;
        const int32_t root = h->member[k];
        if (!sp__free_now(q, root) || sp__root(q->island, root) != root) continue;
        h->stop |= h->budget > 0 && q->spent.cost.flops >= h->budget;
        if (h->stop) return 0;
        sp__part_island(q, root);
        h->status = sp__part_check(q, q->saved.f, q->saved.dq, &c);           /* what is known of the step stays */
        if (h->status) { h->stop = 1; return 0; }
        if (c->r.verdict == SP_STABLE) continue;
        h->unsure |= c->r.verdict == SP_UNDECIDED;
        sp__hold_farthest(h, c);
        return 0;
    }
    return 1;
}

/* All members held, present or absent. */
static void sp__hold_every_member(const sp__hold *h, sp_presence presence)
{
    for (int32_t k = 0; k < h->members; k++) h->q->now.state[h->member[k]].presence = presence;
}

/* must[b]: b falls even when all other members are held. */
SP__NOINLINE static void sp__hold_find_must(sp__hold *h)
{
    sp_sequence *q = h->q;
    sp__hold_every_member(h, SP_HELD);
    for (int32_t k = 0; k < h->members && !h->stop; k++) {
        h->unsure = 0;                                  /* of these sets nothing is claimed but who falls */
        q->now.state[h->member[k]].presence = SP_PRESENT;
        q->must[h->member[k]] = !sp__hold_stands(h) && !h->stop && !h->unsure;
        q->now.state[h->member[k]].presence = SP_HELD;
    }
}

/* Exactly the members of this set are held. */
static void sp__hold_only(const sp__hold *h, uint32_t set)
{
    for (int32_t k = 0; k < h->members; k++) h->q->now.state[h->member[k]].presence = set >> k & 1u ? SP_HELD : SP_PRESENT;
}

/* How many members are held. */
static int32_t sp__hold_count(const sp__hold *h)
{
    int32_t n = 0;
    for (int32_t k = 0; k < h->members; k++) n += h->q->now.state[h->member[k]].presence == SP_HELD;
    return n;
}

/* All sets that hold what must be, the smallest first, in the order of their numbers.     leaves the first that does */
SP__NOINLINE static sp_held_proof sp__hold_smallest_of_all(sp__hold *h)
{
    uint32_t must = 0;
    for (int32_t k = 0; k < h->members; k++) if (h->q->must[h->member[k]]) must |= 1u << k;
    for (int32_t size = 1; size <= h->members; size++)
        for (uint32_t set = 1; set < 1u << h->members && !h->stop; set++) {
            sp__hold_only(h, set);
            if ((set & must) != must || sp__hold_count(h) != size) continue;
            if (sp__hold_stands(h)) return SP_HELD_MINIMAL;
        }
    sp__hold_every_member(h, SP_HELD);
    return SP_HELD_ENOUGH;
}

/* Of those that can't be let go one is minimal; of two, does one of the others suffice?     leaves it so if it does */
SP__NOINLINE static sp_held_proof sp__hold_one_for_two(sp__hold *h)
{
    sp_sequence *q = h->q;
    int32_t pair[2] = { -1, -1 }, n = 0;
    if (sp__hold_count(h) < 2) return SP_HELD_MINIMAL;
    if (sp__hold_count(h) > 2) return SP_HELD_IRREDUCIBLE;
    for (int32_t k = 0; k < h->members; k++)
        if (q->now.state[h->member[k]].presence == SP_HELD) pair[n++] = h->member[k];
    sp__hold_every_member(h, SP_PRESENT);
    for (int32_t k = 0; k < h->members && !h->stop; k++) {
        const int32_t b = h->member[k];
        if (b == pair[0] || b == pair[1]) continue;                     /* the pair itself: letting go has tried */
        if (h->must_members && !q->must[b]) continue;
        q->now.state[b].presence = SP_HELD;
        if (sp__hold_stands(h)) return SP_HELD_MINIMAL;
        q->now.state[b].presence = SP_PRESENT;
    }
    q->now.state[pair[0]].presence = q->now.state[pair[1]].presence = SP_HELD;
    return h->stop ? SP_HELD_IRREDUCIBLE : SP_HELD_MINIMAL;
}

/* A set for large islands: hold what must be held and was held last, add the block that moves most until all stand, then let go
 * each that can be. */
SP__NOINLINE static sp_held_proof sp__hold_by_collapse(sp__hold *h)
{
    sp_sequence *q = h->q;
    int32_t must = 0;
    for (int32_t k = 0; k < h->members; k++) {
        const int32_t b = h->member[k];
        must += q->must[b];
        q->now.state[b].presence = q->must[b] || q->held_last[b] ? SP_HELD : SP_PRESENT;
    }
    while (!sp__hold_stands(h)) {
        if (h->stop) { sp__hold_every_member(h, SP_HELD); return SP_HELD_ENOUGH; }
        q->now.state[h->worst].presence = SP_HELD;
    }
    for (int32_t k = 0; k < h->members && !h->stop; k++) {
        const int32_t b = h->member[k];
        if (q->now.state[b].presence != SP_HELD || q->must[b]) continue;
        q->now.state[b].presence = SP_PRESENT;
        if (!sp__hold_stands(h)) q->now.state[b].presence = SP_HELD;
    }
    h->must_members = must;
    return h->stop ? SP_HELD_ENOUGH : sp__hold_count(h) == must ? SP_HELD_MINIMAL : SP_HELD_IRREDUCIBLE;
}

/* The island whose lowest block is h->member[0]; its set to the answer. */
SP__NOINLINE static sp_status sp__hold_island(sp__hold *h)
{
    sp_sequence *q = h->q;
    h->worst = h->member[0];
    for (int32_t k = 0; k < h->members; k++) q->must[h->member[k]] = 0;
    sp__hold_find_must(h);
    h->unsure = q->now.state[h->member[0]].verdict == SP_UNDECIDED;     /* that of none held */
    sp_held_proof proof = h->members <= SP_HELD_EXHAUSTIVE ? sp__hold_smallest_of_all(h) : sp__hold_by_collapse(h);
    if (proof == SP_HELD_IRREDUCIBLE) proof = sp__hold_one_for_two(h);
    if (h->unsure) proof = SP_HELD_ENOUGH;
    if (proof > h->proof) h->proof = proof;
    for (int32_t k = 0; k < h->members; k++) {
        const int32_t b = h->member[k];
        q->held_last[b] = q->now.state[b].presence == SP_HELD;
        if (q->held_last[b]) q->found.held[h->count++] = b;
        q->now.state[b].presence = SP_PRESENT;
    }
    sp__sequence_islands(q);
    return h->status;
}

SP_API sp_status sp_sequence_hold(sp_sequence *sequence, int64_t budget, sp_held *held)
{
    if (!sequence || !held || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    sp__hold *h = &q->hold;
    memset(h, 0, sizeof *h);
    h->q = q;
    h->member = q->list.member;
    h->budget = budget;
    sp__sequence_reset_counts(q);
    for (int32_t root = 0; root < q->scene->count.blocks; root++) {
        if (!sp__free_now(q, root) || sp__root(q->island, root) != root || q->now.state[root].verdict == SP_STABLE) continue;
        h->members = 0;
        for (int32_t b = root; b < q->scene->count.blocks; b++)
            if (sp__free_now(q, b) && sp__root(q->island, b) == root) q->list.member[h->members++] = b;
        const sp_status status = sp__hold_island(h);
        if (status) return status;
    }
    for (int32_t k = 0; k < h->count; k++) q->list.reported[k] = q->must[q->found.held[k]];
    memset(held, 0, sizeof *held);
    held->count = h->count;
    held->block = q->found.held;
    held->must = q->list.reported;
    held->proof = h->proof;
    held->checks = q->spent.tries;
    held->cost = q->spent.cost;
    return SP_OK;
}

#endif

#endif /* SP__SEQUENCE_HOLD_C */
