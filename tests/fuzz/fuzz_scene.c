/* Any bytes as a small scene (port/fuzz), and everything that can be asked of it. What must hold:
 *
 *     memory      sp_memory tells enough, where the header promises it to the byte; on failure nothing is touched
 *     numbers     no NaN, no infinity
 *     evidence    sp_verify proves the verdict from the evidence and never the other one from forged evidence; sp_limit_verify,
 *                 sp_strong_verify, sp_sliding_verify likewise; forces of what stands balance it, summed anew (balance.h)
 *     invariants  asked of every scene: the same verdict of it in another order, turned and moved, in other units, with all
 *                 effects; what stands does with more friction, one more block held, one more contact, and what falls does with
 *                 less (otherwise.h)
 *     questions   four of each scene: the one that byte 0 names, the others drawn (further.h, build_order.h, place.h)
 *
 * Byte 0: the question, and settings.localise; byte 1: how it is asked; then the scene. What it is asked besides is drawn from
 * all bytes. At the end is told how often each was asked.
 */
#include "further.h"
#include "build_order.h"
#include "place.h"

/* What a forged claim proves; no motion proves more than its forces leave undone. */
static sp_evidence proved(const sp_scene *s, const sp_result *claim)
{
    sp_settings same_as = sp_settings_default();
    sp_evidence e;
    same_as.tol = claim->tol;
    same_as.force_bound = claim->force_bound;
    HOLDS(sp_verify(s, &same_as, claim, arena(SCRATCH), &e) == SP_OK, "verify of what is forged");
    HOLDS(e.least_imbalance <= e.imbalance * (sp_real)(1 + 1e-9), "proved to leave %g, leaves %g", (double)e.least_imbalance,
          (double)e.imbalance);
    return e;
}

/* Forces of a result, up to twice as much of them along their joints, none longer than it was: within the largest force that
 * counts, and beyond the cone. */
static void forces_of_bytes(const sp_scene *s, const sp_real *from, const uint8_t *data, size_t size, sp_real *f)
{
    for (int32_t v = 0; v < s->count.points; v++) {
        double was[3], is[3];
        for (int k = 0; k < 3; k++) {
            was[k] = (double)from[3 * v + k];
            is[k] = was[k] * (1 + (k ? data[(size_t)(3 * v + k) % size] / 256.0 : 0));
        }
        const double share = length(is) > 0 ? length(was) / length(is) : 1;
        for (int k = 0; k < 3; k++) f[3 * v + k] = (sp_real)(share * is[k]);
    }
}

/* What is told of forces is not less than what they leave, made admissible and summed anew. */
static void leaves_no_less(const sp_scene *s, const sp_real *f, double imbalance)
{
    static sp_real g[3 * VERTICES];
    for (int32_t q = 0; q < s->count.joints; q++)
        for (int32_t v = s->joint[q].point; v < s->joint[q].point + s->joint[q].points; v++)
            admitted(&s->joint[q], f + 3 * v, g + 3 * v);
    const double least = left(s, g) * (1 - 1e-6) - 1e-12;
    HOLDS(imbalance >= least, "told to leave %g, leaves %g", imbalance, least);
}

/* Evidence of the other verdict is never believed: of what stands each block pushed and turned along each axis, and motions
 * and forces of bytes for both. */
static void forged(const sp_scene *s, const sp_result *r, const uint8_t *data, size_t size)
{
    static sp_real dq[6 * SP_FUZZ_BLOCKS], f[3 * VERTICES];
    const int32_t n = 6 * s->count.blocks;
    sp_result claim = *r;
    asked(FORGED);
    claim.verdict = r->verdict == SP_STABLE ? SP_UNSTABLE : SP_STABLE;
    claim.dq = dq;
    claim.f = f;
    forces_of_bytes(s, r->f, data, size, f);
    for (int32_t k = 0; k < (r->verdict == SP_STABLE ? 2 * n : 0); k++) {
        memset(dq, 0, sizeof dq);
        dq[k / 2] = k % 2 ? -1 : 1;
        HOLDS(proved(s, &claim).verdict != SP_UNSTABLE, "it stands, motion %d", (int)k);
    }
    for (int32_t k = 0; k < n; k++) dq[k] = (sp_real)((int)data[(size_t)k % size] - 128);
    const sp_evidence e = proved(s, &claim);
    HOLDS(!opposite(r->verdict, e.verdict), "another motion, other forces");
    if (s->count.joints && s->joint[0].strength.crushing > 0) return;           /* these forces may be too large for it */
    leaves_no_less(s, f, (double)e.imbalance);
}

/* Input: its bytes, the second of them. */
typedef struct input { const uint8_t *data; size_t size; unsigned more; } input;

static void ask(question q, const sp_scene *s, const sp_result *r, const sp_settings *set, const input *in)
{
    switch (q) {
    case MOVES: moves(s, r); return;
    case FORGED: forged(s, r, in->data, in->size); return;
    case LESS_MEMORY: less_memory(s, r, *set, in->more); return;
    case PYRAMID: in_a_pyramid(s, r, *set, in->more); return;
    case COUPLED: coupled(s, r, *set, in->more); return;
    case BUDGET: with_a_budget(s, r, *set, in->more); return;
    case STAGES: by_stages(s, r, *set, in->more); return;
    case LIMIT: limit(s, r); return;
    case NEAR_LIMIT: near_the_limit(s); return;
    case SLIDING: sliding(s); return;
    case STRONG: if (r->verdict == SP_STABLE) strong(s, r->f); return;
    case ORDER_OF_BUILD: block_by_block(s, r); return;
    case HOLD: what_to_hold(s); return;
    case SUGGEST: what_comes_next(s); return;
    case PLAN: planned(s, r, set); return;
    case CONTACTS: contacts(s, set); return;
    case MATRIX: matrices(s, r); return;
    case PLACING: placing(s, r); return;
    case RESTING: resting(s); return;
    default: return;
    }
}

/* The question of byte 0, as ever, so that inputs that were kept ask what they did; six numbers are those of invariants. */
static question named(unsigned byte)
{
    static const question of[16] = { FORGED, FULL, IN_ORDER, TURNED, IN_UNITS, FRICTION, HELD, LIMIT, ORDER_OF_BUILD, STRONG,
                                     PYRAMID, COUPLED, BUDGET, LESS_MEMORY, STAGES, CONTACT };
    return of[byte % 16];
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    sp_arena a = arena(SCENE);
    sp_scene s;
    sp_result r;
    sp_settings set = sp_settings_default();
    if (size < 4 || size > 200) return 0;
    tell_at_end();
    draws_of(data, size);
    const input in = { data, size, data[1] };
    set.localise = data[0] < 128;
    if (sp_scene_from_bytes(data + 2, size - 2, &a, &s)) return 0;
    check(&s, &set, CHECK, &r);
    if (!r.f) return 0;
    verdicts[r.verdict]++;
    resultants(&s, &r);
    invariants(&s, &r);
    for (unsigned k = 0; k < (some ? 2 : 4); k++) {
        draws_anew(QUESTIONS + k);
        ask(k ? (question)(MOVES + draw(QUESTIONS - MOVES)) : named(data[0]), &s, &r, &set, &in);
    }
    return 0;
}
