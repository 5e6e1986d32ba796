/* sequence: sp_sequence in SP_SMALL: each step is one check of all that is there. */
#ifndef SP__SMALL_SEQUENCE_C
#define SP__SMALL_SEQUENCE_C

#include "check.c"

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
    int32_t *answer, *must, *reported;      /* per block */
    sp_cost cost;                       /* of the call at hand */
    int32_t tries;
    sp_arena work;                      /* of a check */
};

#define SP__TRIED ((sp_presence)3)

static void sp__sequence_carve(sp_sequence *q, const sp_scene *scene, size_t work, sp_arena *a)
{
    const size_t blocks = (size_t)scene->count.blocks;
    q->part.block = sp__take(a, blocks, sizeof *q->part.block);
    q->part.joint = sp__take(a, (size_t)scene->count.joints, sizeof *q->part.joint);
    q->who = sp__take(a, blocks, sizeof *q->who);
    q->answer = sp__take(a, 3 * blocks, sizeof *q->answer);
    q->work.base = sp__take(a, 1, work);
    q->work.cap = work;
}

/* Settings, and bytes of a check: one of the whole takes the most. */
static sp_status sp__sequence_work(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, sp_settings *set,
                                   size_t *work)
{
    *set = settings ? *settings : sp_settings_default();
    set->work = NULL;
    return sp__check_memory(scene, set, scratch, work);
}

static size_t sp__sequence_scratch(const sp_scene *scene, const sp_settings *settings)
{
    const size_t most = sp__check_scratch(scene, settings);
    return most ? sizeof(sp_sequence) + SP_ALIGN + most : 0;
}

static sp_status sp__sequence_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    sp_sequence *q = sp__take(&scratch, 1, sizeof *q);
    size_t work = 0;
    if (!q) return SP_E_MEMORY;
    const sp_status status = sp__sequence_work(scene, settings, scratch, &q->set, &work);
    if (status) return status;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *q);
    sp__sequence_carve(q, scene, work, &dry);
    *bytes = dry.used;
    return SP_OK;
}

SP_API sp_status sp_sequence_open(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_sequence **sequence)
{
    if (!scene || !arena || !arena->base || !sequence) return SP_E_ARGUMENT;
    sp_arena a = *arena;
    sp_sequence *q = sp__take(&a, 1, sizeof *q);
    size_t work = 0;
    if (!q) return SP_E_MEMORY;
    memset(q, 0, sizeof *q);
    const sp_status status = sp__sequence_work(scene, settings, a, &q->set, &work);
    if (status) return status;
    q->scene = scene;
    q->part = *scene;
    sp__sequence_carve(q, scene, work, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    q->must = q->answer + scene->count.blocks;
    q->reported = q->must + scene->count.blocks;
    for (int32_t b = 0; b < scene->count.blocks; b++) q->who[b] = scene->block[b].fixed == SP_FIXED ? SP_PRESENT : SP_ABSENT;
    *arena = a;
    *sequence = q;
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
    q->cost.flops += q->r.spent.total.flops;
    q->cost.iterations += q->r.spent.total.iterations;
    q->cost.factorisations += q->r.spent.total.factorisations;
    q->tries++;
    return q->r.verdict;
}

static void sp__sequence_start(sp_sequence *q)
{
    memset(&q->cost, 0, sizeof q->cost);
    q->tries = 0;
}

static int sp__free_now(const sp_sequence *q, int32_t b)
{
    return q->who[b] == SP_PRESENT && q->scene->block[b].fixed != SP_FIXED;
}

static void sp__sequence_step(sp_sequence *q, sp_step *step)
{
    const sp_result *r = &q->r;
    sp_real most = -1;
    sp__sequence_start(q);
    q->verdict = sp__sequence_check(q);
    memset(step, 0, sizeof *step);
    step->verdict = r->verdict;
    step->reason = r->reason;
    step->final = r->final;
    step->block = -1;
    for (int32_t b = 0; b < q->scene->count.blocks && r->verdict != SP_STABLE; b++) {
        const sp_real moves = sp__norm3(r->dq + 6 * (size_t)b);
        if (sp__free_now(q, b) && moves > most) { most = moves; step->block = b; }
    }
    step->islands = step->checked = r->islands.count;
    step->blocks = step->again = r->counts.free_blocks;
    step->imbalance = r->imbalance;
    step->least_imbalance = r->least_imbalance;
    step->f = r->f;
    step->dq = r->dq;
    step->cost = q->cost;
}

static int sp__presence_valid(sp_presence p) { return p == SP_ABSENT || p == SP_PRESENT || p == SP_HELD; }

SP_API sp_status sp_sequence_set(sp_sequence *sequence, int32_t block, sp_presence presence, sp_step *step)
{
    if (!sequence || !step || !sp__presence_valid(presence)) return SP_E_ARGUMENT;
    if (block < 0 || block >= sequence->scene->count.blocks) return SP_E_INDEX;
    sequence->who[block] = presence;
    sp__sequence_step(sequence, step);
    return SP_OK;
}

SP_API sp_status sp_sequence_fill(sp_sequence *sequence, const sp_presence *presence, sp_step *step)
{
    if (!sequence || !presence || !step) return SP_E_ARGUMENT;
    const int32_t blocks = sequence->scene->count.blocks;
    for (int32_t b = 0; b < blocks; b++) if (!sp__presence_valid(presence[b])) return SP_E_ARGUMENT;
    memcpy(sequence->who, presence, (size_t)blocks * sizeof *presence);
    sp__sequence_step(sequence, step);
    return SP_OK;
}

/* One of the blocks held on trial let go. */
static sp_verdict sp__hold_without(sp_sequence *q, int32_t b, int64_t budget)
{
    if (budget > 0 && q->cost.flops >= budget) return SP_UNDECIDED;
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
    sp__sequence_start(q);
    memset(held, 0, sizeof *held);
    for (int32_t b = 0; b < blocks && q->verdict != SP_STABLE; b++) if (sp__free_now(q, b)) q->who[b] = SP__TRIED;
    for (int32_t b = 0; b < blocks; b++) q->must[b] = q->who[b] == SP__TRIED && sp__hold_without(q, b, budget) == SP_UNSTABLE;
    for (int32_t b = 0; b < blocks; b++) {
        if (q->who[b] != SP__TRIED || q->must[b]) continue;
        const sp_verdict verdict = sp__hold_without(q, b, budget);
        if (verdict == SP_STABLE) q->who[b] = SP_PRESENT; else others++;
        sure &= verdict != SP_UNDECIDED;
    }
    for (int32_t b = 0; b < blocks; b++) {
        if (q->who[b] != SP__TRIED) continue;
        q->reported[held->count] = q->must[b];
        q->answer[held->count++] = b;
        q->who[b] = SP_PRESENT;
    }
    held->block = q->answer;
    held->must = q->reported;
    held->proof = !sure ? SP_HELD_ENOUGH : others > 1 ? SP_HELD_IRREDUCIBLE : SP_HELD_MINIMAL;
    held->checks = q->tries;
    held->cost = q->cost;
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

SP_API sp_status sp_sequence_suggest(sp_sequence *sequence, int32_t add, int64_t budget, sp_suggestion *suggestion)
{
    if (!sequence || !suggestion || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    const int32_t blocks = q->scene->count.blocks;
    sp__sequence_start(q);
    memset(suggestion, 0, sizeof *suggestion);
    suggestion->block = -1;
    suggestion->all = 1;
    for (int32_t b = 0; b < blocks; b++) q->answer[b] = sp__next_candidate(q, b, add);
    while (suggestion->block < 0) {
        int32_t next = -1;
        sp_real least = 0;                              /* height, of a block to be taken away the depth */
        for (int32_t b = 0; b < blocks; b++) {
            const sp_real h = (add ? -1 : 1) * sp__dot3(q->scene->gravity, q->scene->block[b].centroid);
            if (q->answer[b] && (next < 0 || h < least)) { next = b; least = h; }
        }
        if (next < 0) break;
        suggestion->all = !(budget > 0 && q->cost.flops >= budget);
        if (!suggestion->all) break;
        const sp_presence was = q->who[next];
        q->answer[next] = 0;
        q->who[next] = add ? SP_PRESENT : SP_ABSENT;
        if (sp__sequence_check(q) == SP_STABLE) suggestion->block = next;
        q->who[next] = was;
        suggestion->tried++;
    }
    suggestion->cost = q->cost;
    return SP_OK;
}

#elif SP__WITH_SMALL

static size_t sp__sequence_scratch(const sp_scene *scene, const sp_settings *settings)
{
    return (void)settings, scene ? SP_ALIGN : 0;
}
static sp_status sp__sequence_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    return (void)scene, (void)settings, (void)scratch, (void)bytes, SP_E_UNSUPPORTED;
}

#endif

#endif /* SP__SMALL_SEQUENCE_C */
