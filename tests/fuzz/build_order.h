/* build_order: sequences, each step judged by a check of a scene that has just the blocks that are there. */
#ifndef BUILD_ORDER_H
#define BUILD_ORDER_H

#include "otherwise.h"

/* A sequence, and which of its blocks are there. */
typedef struct building { const sp_scene *s; sp_sequence *q; sp_step step; sp_presence there[SP_FUZZ_BLOCKS]; } building;

static int opened(const sp_scene *s, building *b)
{
    const size_t bytes = bytes_of(s, SP_FOR_SEQUENCE, NULL);
    if (!bytes) return 0;
    sp_arena a = room_for(SEQUENCE, bytes - 1);
    HOLDS(sp_sequence_open(s, NULL, &a, &b->q) == SP_E_MEMORY && !a.used, "open in one byte less");
    a = room_for(SEQUENCE, bytes);
    HOLDS(sp_sequence_open(s, NULL, &a, &b->q) == SP_OK, "open");
    HOLDS(a.peak == bytes, "a sequence takes %zu of %zu bytes", a.peak, bytes);
    b->s = s;
    memset(&b->step, 0, sizeof b->step);
    for (int32_t k = 0; k < s->count.blocks; k++) b->there[k] = s->block[k].fixed == SP_FIXED ? SP_PRESENT : SP_ABSENT;
    return 1;
}

static void stepped(building *b, int32_t block, sp_presence to)
{
    const sp_status status = sp_sequence_set(b->q, block, to, &b->step);
    HOLDS(status == SP_OK, "set: status %d", (int)status);
    b->there[block] = to;
}

/* What is there as a scene of its own.     returns 0: nothing is */
static int part_of(const building *b, writing *w, sp_scene *part)
{
    *w = as_it_is(b->s);
    int any = 0;
    for (int32_t k = 0; k < b->s->count.blocks; k++) any |= (w->there[k] = b->there[k]) != SP_ABSENT;
    return any && written(b->s, w, OTHER, part);
}

/* The forces of a step, or its motion, as a claim about that scene. */
static void step_proves(const building *b, const writing *w, const sp_scene *part)
{
    static sp_real f[3 * VERTICES], dq[6 * SP_FUZZ_BLOCKS];
    const sp_scene *s = b->s;
    sp_result claim;
    sp_evidence e;
    memset(&claim, 0, sizeof claim);
    memset(f, 0, sizeof f);
    memset(dq, 0, sizeof dq);
    claim.f = f;
    claim.dq = dq;
    for (int32_t k = 0; k < s->count.joints; k++) {
        const sp_joint *j = &s->joint[k];
        if (w->name[k] < 0) continue;
        memcpy(f + 3 * part->joint[w->name[k]].point, b->step.f + 3 * j->point, 3 * (size_t)j->points * sizeof *f);
    }
    for (int32_t k = 0; k < s->count.blocks; k++)
        if (w->place[k] >= 0) memcpy(dq + 6 * w->place[k], b->step.dq + 6 * k, 6 * sizeof *dq);
    HOLDS(sp_verify(part, NULL, &claim, arena(SCRATCH), &e) == SP_OK, "verify of a step");
    HOLDS(e.verdict == b->step.verdict, "a step says %d, its evidence proves %d: imbalance %g, least %g", (int)b->step.verdict,
          (int)e.verdict, (double)e.imbalance, (double)e.least_imbalance);
}

/* A step says what a check of what is there says, and proves it. */
static void step_is_right(building *b)
{
    const sp_settings set = sp_settings_default();
    const sp_step *t = &b->step;
    sp_scene part;
    sp_result r;
    writing w;
    all_finite(t->f, 3 * b->s->count.points, "step f");
    all_finite(t->dq, 6 * b->s->count.blocks, "step dq");
    HOLDS((t->block < 0) == (t->verdict == SP_STABLE), "block %d of a step", (int)t->block);
    if (!part_of(b, &w, &part)) return;
    if (t->verdict) step_proves(b, &w, &part);
    if (!check_in(&part, &set, CHECK_OTHER, ROOM, &r)) return;
    verdicts[r.verdict]++;
    sp_result of_step = r;
    of_step.verdict = t->verdict;
    of_step.least_imbalance = t->least_imbalance;
    same(&r, &of_step, "a step of a sequence");
}

/* Block by block up to the whole scene, in a drawn order. */
static void block_by_block(const sp_scene *s, const sp_result *r)
{
    building b;
    writing w = as_it_is(s);
    if (!opened(s, &b)) return;
    asked(ORDER_OF_BUILD);
    shuffle(w.block, s->count.blocks);
    for (int32_t k = 0; k < s->count.blocks; k++) {
        stepped(&b, w.block[k], SP_PRESENT);
        step_is_right(&b);
    }
    sp_result last = *r;
    last.verdict = b.step.verdict;
    last.least_imbalance = b.step.least_imbalance;
    same(r, &last, "block by block");
}

/* Some blocks at once: supports are there or not, others may be held. */
static int filled(const sp_scene *s, building *b)
{
    if (!opened(s, b)) return 0;
    asked(FILL);
    for (int32_t k = 0; k < s->count.blocks; k++) {
        const uint32_t how = draw(8);
        b->there[k] = !how ? SP_ABSENT : how == 1 && s->block[k].fixed != SP_FIXED ? SP_HELD : SP_PRESENT;
    }
    HOLDS(sp_sequence_fill(b->q, b->there, &b->step) == SP_OK, "fill");
    step_is_right(b);
    return 1;
}

/* Held as is said it stands; of sets of which none can be let go it does not when one of them is. */
static void what_to_hold(const sp_scene *s)
{
    building b;
    sp_held held;
    int32_t block[SP_FUZZ_BLOCKS];
    if (!filled(s, &b)) return;
    asked(HOLD);
    const sp_verdict before = b.step.verdict;
    HOLDS(sp_sequence_hold(b.q, draw(2) ? 0 : 1000000, &held) == SP_OK, "hold");
    HOLDS(held.count >= 0 && held.count <= s->count.blocks, "%d held", (int)held.count);
    if (before == SP_STABLE) HOLDS(held.count == 0, "it stands, and %d are to be held", (int)held.count);
    const int32_t n = held.count;
    for (int32_t k = 0; k < n; k++) {
        block[k] = held.block[k];
        HOLDS(block[k] >= 0 && block[k] < s->count.blocks && b.there[block[k]] == SP_PRESENT, "held %d", (int)block[k]);
    }
    for (int32_t k = 0; k < n; k++) stepped(&b, block[k], SP_HELD);
    if (n) HOLDS(b.step.verdict == SP_STABLE, "%d held, and it is %d", (int)n, (int)b.step.verdict);
    if (n) step_is_right(&b);
    if (!n || held.proof == SP_HELD_ENOUGH) return;
    stepped(&b, block[draw((uint32_t)n)], SP_PRESENT);
    HOLDS(b.step.verdict != SP_STABLE, "one let go of %d held, and it stands", (int)n);
}

static int touches(const building *b, int32_t block)
{
    for (int32_t j = 0; j < b->s->count.joints; j++) {
        const int32_t x = b->s->joint[j].a, y = b->s->joint[j].b;
        if ((x == block && b->there[y]) || (y == block && b->there[x])) return 1;
    }
    return 0;
}

/* With the stone that is said, everything stands; where none is, with none. */
static void what_comes_next(const sp_scene *s)
{
    building b;
    sp_suggestion next;
    if (!filled(s, &b)) return;
    asked(SUGGEST);
    const int32_t add = (int32_t)draw(2);
    HOLDS(sp_sequence_suggest(b.q, add, draw(2) ? 0 : 1000000, &next) == SP_OK, "suggest");
    HOLDS(next.block >= -1 && next.block < s->count.blocks, "suggested %d", (int)next.block);
    for (int32_t k = 0; k < s->count.blocks; k++) {
        const int may = s->block[k].fixed != SP_FIXED && (add ? b.there[k] == SP_ABSENT && touches(&b, k)
                                                              : b.there[k] == SP_PRESENT);
        if (k == next.block) HOLDS(may, "suggested %d", (int)k);
        if (!may || (next.block >= 0 ? k != next.block : !next.all)) continue;
        const sp_presence was = b.there[k];
        stepped(&b, k, add ? SP_PRESENT : SP_ABSENT);
        HOLDS((b.step.verdict == SP_STABLE) == (k == next.block), "suggested %d, with %d it is %d", (int)next.block, (int)k,
              (int)b.step.verdict);
        if (k == next.block) step_is_right(&b);
        stepped(&b, k, was);
    }
}

#endif
