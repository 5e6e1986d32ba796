/* small_steps: a build order in the smallest build: each step is one check of all that is there. */
#ifndef SP__SEQUENCE_SMALL_STEPS_C
#define SP__SEQUENCE_SMALL_STEPS_C

#include "../small/check.c"

#if SP__WITH_SMALL && SP__WITH_SEQUENCE

/* Every step is a check of all that is there: the scene with what is absent or held taken for a support, and joints of what is
 * absent left out. */
struct sp_sequence {
    const sp_scene *scene;
    sp_scene part;
    sp_settings set;
    sp_result r;                        /* of the last check */
    sp_verdict verdict;                 /* of the last step */
    sp_presence *who;                   /* per block; SP__TRIED: held to see what that does */
    union { int32_t *held, *tried; } found;             /* blocks to be held; per block, 1: a call has tried it, or may not */
    int32_t *must, *reported;           /* must it be held? per block, and of each block of the answer */
    struct { sp_cost cost; int32_t tries; } spent;      /* of the call at hand */
    sp_arena work;                      /* of a check */
};

#define SP__TRIED ((sp_presence)3)

static sp_status sp__sequence_carve(sp_sequence *q, const sp_scene *scene, size_t work, sp_arena *a)
{
    const size_t blocks = (size_t)scene->count.blocks;
    q->part.block = sp__take(a, blocks, sizeof *q->part.block);
    q->part.joint = sp__take(a, (size_t)scene->count.joints, sizeof *q->part.joint);
    q->who = sp__take(a, blocks, sizeof *q->who);
    q->found.held = sp__take(a, 3 * blocks, sizeof *q->found.held);       /* must and reported, too */
    q->work.base = sp__take(a, 1, work);
    q->work.capacity = work;
    return sp__failed(a) ? SP_E_MEMORY : SP_OK;
}

/* Settings, and bytes of a check: one of the whole takes the most. */
static sp_status sp__sequence_work(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, sp_settings *set,
                                   size_t *work)
{
    *set = settings ? *settings : sp_settings_default();
    set->work = NULL;
    return sp__check_memory(scene, set, scratch, work);
}

/* Nothing but supports is there. */
static sp_status sp__sequence_begin(sp_sequence *q)
{
    const sp_scene *s = q->scene;
    sp_block *block = q->part.block;
    sp_joint *joint = q->part.joint;
    q->part = *s;
    q->part.block = block;                              /* its own */
    q->part.joint = joint;
    q->must = q->found.held + s->count.blocks;
    q->reported = q->must + s->count.blocks;
    for (int32_t b = 0; b < s->count.blocks; b++) q->who[b] = s->block[b].fixed == SP_FIXED ? SP_PRESENT : SP_ABSENT;
    return SP_OK;
}

/* Check of all that is there. */
SP__NOINLINE static sp_verdict sp__sequence_check(sp_sequence *q)
{
    const sp_scene *s = q->scene;
    sp_arena a = q->work;
    q->part.count.joints = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        q->part.block[b] = s->block[b];
        if (q->who[b] != SP_PRESENT) q->part.block[b].fixed = SP_FIXED;
    }
    for (int32_t k = 0; k < s->count.joints; k++)
        if (q->who[s->joint[k].a] && q->who[s->joint[k].b]) q->part.joint[q->part.count.joints++] = s->joint[k];
    q->r.verdict = SP_UNDECIDED;
    sp_check(&q->part, &q->set, &a, &q->r);
    q->spent.cost.flops += q->r.spent.total.flops;
    q->spent.cost.iterations += q->r.spent.total.iterations;
    q->spent.cost.factorisations += q->r.spent.total.factorisations;
    q->spent.tries++;
    return q->r.verdict;
}

static void sp__sequence_reset_counts(sp_sequence *q)
{
    memset(&q->spent.cost, 0, sizeof q->spent.cost);
    q->spent.tries = 0;
}

static int sp__free_now(const sp_sequence *q, int32_t b)
{
    return q->who[b] == SP_PRESENT && q->scene->block[b].fixed != SP_FIXED;
}

/* The result of the step: that of the check. */
static void sp__sequence_report(const sp_sequence *q, sp_step *step)
{
    const sp_result *r = &q->r;
    sp_real most = -1;
    memset(step, 0, sizeof *step);
    step->verdict = r->verdict;
    step->reason = r->reason;
    step->final = r->final;
    step->block = -1;
    for (size_t k = 0; k < 6 && !(most > 0); k += 3)    /* where nothing goes anywhere, what turns */
        for (int32_t b = 0; b < q->scene->count.blocks && r->verdict != SP_STABLE; b++) {
            const sp_real moves = sp__norm3(r->dq + 6 * (size_t)b + k);
            if (sp__free_now(q, b) && moves > most) { most = moves; step->block = b; }
        }
    step->islands = step->checked = r->islands.count;
    step->blocks = step->again = r->counts.free_blocks;
    step->imbalance = r->imbalance;
    step->least_imbalance = r->least_imbalance;
    step->f = r->f;
    step->dq = r->dq;
    step->cost = q->spent.cost;
}

static sp_status sp__sequence_set_presence(sp_sequence *q, int32_t b, sp_presence presence)
{
    q->who[b] = presence;
    q->verdict = sp__sequence_check(q);
    return SP_OK;
}

static sp_status sp__sequence_set_all(sp_sequence *q, const sp_presence *presence)
{
    memcpy(q->who, presence, (size_t)q->scene->count.blocks * sizeof *presence);
    q->verdict = sp__sequence_check(q);
    return SP_OK;
}

/* One of the blocks held on trial let go. */
static sp_verdict sp__hold_without(sp_sequence *q, int32_t b, int64_t budget)
{
    if (budget > 0 && q->spent.cost.flops >= budget) return SP_UNDECIDED;
    q->who[b] = SP_PRESENT;
    const sp_verdict verdict = sp__sequence_check(q);
    q->who[b] = SP__TRIED;
    return verdict;
}

/* A block that falls with all others held is in every set. Of the rest one after the other is let go again: holding more never
 * harms, so what cannot be let go then never can, and with no more than one such block no set is smaller. */
SP_API sp_status sp_sequence_hold(sp_sequence *sequence, int64_t budget, sp_held *held)
{
    if (!sequence || !held || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    const int32_t blocks = q->scene->count.blocks;
    int sure = 1, others = 0;
    sp__sequence_reset_counts(q);
    memset(held, 0, sizeof *held);
    for (int32_t b = 0; b < blocks && q->verdict != SP_STABLE; b++) if (sp__free_now(q, b)) q->who[b] = SP__TRIED;
    for (int32_t b = 0; b < blocks; b++)
        q->must[b] = q->who[b] == SP__TRIED && sp__hold_without(q, b, budget) == SP_UNSTABLE;
    for (int32_t b = 0; b < blocks; b++) {
        if (q->who[b] != SP__TRIED || q->must[b]) continue;
        const sp_verdict verdict = sp__hold_without(q, b, budget);
        if (verdict == SP_STABLE) q->who[b] = SP_PRESENT; else others++;
        sure &= verdict != SP_UNDECIDED;
    }
    for (int32_t b = 0; b < blocks; b++) {
        if (q->who[b] != SP__TRIED) continue;
        q->reported[held->count] = q->must[b];
        q->found.held[held->count++] = b;
        q->who[b] = SP_PRESENT;
    }
    held->block = q->found.held;
    held->must = q->reported;
    held->proof = !sure ? SP_HELD_ENOUGH : others > 1 ? SP_HELD_IRREDUCIBLE : SP_HELD_MINIMAL;
    held->checks = q->spent.tries;
    held->cost = q->spent.cost;
    return SP_OK;
}

/* May block b be put there (add) or taken away? */
static int sp__next_candidate(const sp_sequence *q, int32_t b, int32_t add)
{
    if (q->scene->block[b].fixed == SP_FIXED) return 0;
    if (!add) return q->who[b] == SP_PRESENT;
    for (int32_t k = 0; k < q->scene->count.joints && !q->who[b]; k++) {
        const sp_joint *t = &q->scene->joint[k];
        if ((t->a == b && q->who[t->b]) || (t->b == b && q->who[t->a])) return 1;
    }
    return 0;
}

/* Would everything stand with block b there, or gone? */
static sp_status sp__next_try(sp_sequence *q, int32_t b, int32_t add, int *stands)
{
    const sp_presence was = q->who[b];
    q->who[b] = add ? SP_PRESENT : SP_ABSENT;
    *stands = sp__sequence_check(q) == SP_STABLE;
    q->who[b] = was;
    return SP_OK;
}

#endif

#endif /* SP__SEQUENCE_SMALL_STEPS_C */
