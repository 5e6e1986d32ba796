/* hashes: three numbers over what the library answers on the scenes of the corpus and on random ones, islands among them,
 * for each of its four questions.
 *
 *     evidence    verdicts and reasons, forces, motions, multipliers, proofs, to the last bit
 *     work        flops, factorisations and iterations
 *     bytes       what each call took of its arena; pointers are in there
 *
 * A change that only moves code leaves all three as they are. One that means to move work or memory shows here that the evidence
 * stayed. Prints `QUESTION evidence work bytes`; with an argument first a line for each scene.
 *
 *     check       sp_check with default settings
 *     limit       sp_limit of a push along x by half the weight of every block
 *     coupled     sp_check with coupled.asked, a tree of 300 nodes at most
 *     sequence    sp_sequence: all blocks in their order, then what must be held after every eighth
 */
#define main corpus_main
#include "corpus.c"
#undef main
#include "../scenes/kinds.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct hashes { uint64_t evidence, work, bytes; } hashes;

static const hashes none = { 14695981039346656037u, 14695981039346656037u, 14695981039346656037u };
static size_t room = (size_t)64 << 20;
static unsigned char *heap[2];
static int each;

static void mix_cost(hashes *h, const sp_cost *cost)
{
    h->work = mix(mix(h->work, (uint64_t)cost->flops), (uint64_t)cost->factorisations);
    h->work = mix(mix(h->work, (uint64_t)cost->iterations), (uint64_t)cost->interior);
}

static void mix_result(hashes *h, const sp_scene *scene, const sp_result *r)
{
    const sp_extremes *most = &r->extremes;
    const sp_real number[6] = { r->imbalance, r->least_imbalance, most->compression, most->tension, most->utilisation, r->coupled.residual };
    h->evidence = mix(mix(h->evidence, (uint64_t)r->verdict), (uint64_t)r->reason);
    h->evidence = mix(mix(h->evidence, (uint64_t)(r->final + 2 * r->verified)), (uint64_t)r->extremes.weakest);
    h->evidence = mix(mix(h->evidence, (uint64_t)r->level), (uint64_t)r->stage);
    h->evidence = mix(mix(h->evidence, (uint64_t)r->coupled.verdict), (uint64_t)r->coupled.reason);
    h->evidence = mix_reals(h->evidence, number, 6);
    h->evidence = mix_reals(h->evidence, r->f, 3 * scene->count.points);
    h->evidence = mix_reals(h->evidence, r->dq, 6 * scene->count.blocks);
    if (r->coupled.verdict == SP_COUPLING_COUPLED) {
        h->evidence = mix_reals(h->evidence, r->coupled.dq, 6 * scene->count.blocks);
        h->evidence = mix_reals(h->evidence, r->coupled.alpha, scene->count.points);
    }
    if (r->coupled.proof.nodes) h->evidence = mix_reals(h->evidence, r->coupled.proof.y, r->coupled.proof.entries);
    mix_cost(h, &r->spent.total);
    h->bytes = mix(h->bytes, (uint64_t)r->spent.peak_bytes);
}

static sp_status ask_check(sp_scene *scene, sp_arena *arena, hashes *h)
{
    sp_settings set = sp_settings_default();
    sp_result r;
    size_t bytes = 0;
    sp_arena scratch;
    set.localise = 1;
    sp_arena_init(&scratch, heap[1], room);
    sp_status status = sp_memory(scene, SP_FOR_CHECK, &set, scratch, &bytes);
    h->bytes = mix(h->bytes, (uint64_t)bytes);
    if (!status) status = sp_check(scene, &set, arena, &r);
    if (!status) mix_result(h, scene, &r);
    return status;
}

static sp_status ask_coupled(sp_scene *scene, sp_arena *arena, hashes *h)
{
    sp_settings set = sp_settings_default();
    sp_result r;
    set.coupled.asked = set.localise = 1;
    set.coupled.nodes = 300;
    const sp_status status = sp_check(scene, &set, arena, &r);
    if (!status) mix_result(h, scene, &r);
    return status;
}

static sp_status ask_limit(sp_scene *scene, sp_arena *arena, hashes *h)
{
    sp_limit_result r;
    scene->body[0] = (sp_real)0.5 * -scene->gravity[2];
    const sp_status status = sp_limit(scene, NULL, arena, &r);
    scene->body[0] = 0;
    if (status) return status;
    const sp_real number[7] = { r.multiplier, r.lower, r.upper, r.within, r.lowest, r.imbalance, r.least_imbalance };
    h->evidence = mix(mix(h->evidence, (uint64_t)r.kind), (uint64_t)r.reason);
    h->evidence = mix(mix(h->evidence, (uint64_t)r.dead), (uint64_t)(r.final + 2 * r.verified));
    h->evidence = mix_reals(h->evidence, number, 7);
    h->evidence = mix_reals(h->evidence, r.f, 3 * scene->count.points);
    h->evidence = mix_reals(h->evidence, r.dq, 6 * scene->count.blocks);
    mix_cost(h, &r.cost);
    h->bytes = mix(h->bytes, (uint64_t)r.peak_bytes);
    return SP_OK;
}

static sp_status ask_sequence(sp_scene *scene, sp_arena *arena, hashes *h)
{
    sp_sequence *s;
    sp_step step;
    sp_held held;
    sp_status status = sp_sequence_open(scene, NULL, arena, &s);
    for (int32_t k = 0; !status && k < scene->count.blocks; k++) {
        if (scene->block[k].fixed == SP_FIXED) continue;
        status = sp_sequence_set(s, k, SP_PRESENT, &step);
        if (status) break;
        h->evidence = mix(mix(h->evidence, (uint64_t)step.verdict), (uint64_t)step.block);
        h->evidence = mix_reals(h->evidence, step.f, 3 * scene->count.points);
        h->evidence = mix_reals(h->evidence, step.dq, 6 * scene->count.blocks);
        mix_cost(h, &step.cost);
        if (k % 8) continue;
        status = sp_sequence_hold(s, 20000000, &held);
        for (int32_t i = 0; i < held.count; i++) h->evidence = mix(h->evidence, (uint64_t)held.block[i]);
        mix_cost(h, &held.cost);
    }
    h->bytes = mix(h->bytes, (uint64_t)arena->peak);
    return status;
}

typedef struct question { const char *name; sp_status (*ask)(sp_scene *, sp_arena *, hashes *); } question;

static const question asked[] = { { "check", ask_check }, { "limit", ask_limit }, { "coupled", ask_coupled }, { "sequence", ask_sequence } };

static void line(const char *name, const char *what, const hashes *h)
{
    printf("%s%s%s %016llx %016llx %016llx\n", name, *what ? " " : "", what, (unsigned long long)h->evidence,
           (unsigned long long)h->work, (unsigned long long)h->bytes);
}

static void add(hashes *all, const question *q, const char *name, sp_scene *scene)
{
    hashes h = none;
    sp_arena arena;
    sp_arena_init(&arena, heap[0], room);
    const sp_status status = q->ask(scene, &arena, &h);
    h.evidence = mix(h.evidence, (uint64_t)-(int64_t)status);               /* also what this build refuses */
    if (each) line(q->name, name, &h);
    all->evidence = mix(all->evidence, h.evidence);
    all->work = mix(all->work, h.work);
    all->bytes = mix(all->bytes, h.bytes);
}

int main(int count, char **word)
{
    (void)word, (void)corpus_main;
    each = count > 1;
    for (int k = 0; k < 2; k++) if (!(heap[k] = malloc(room))) return 1;
    for (size_t q = 0; q < sizeof asked / sizeof asked[0]; q++) {
        hashes all = none;
        for (size_t k = 0; k < sizeof compiled / sizeof compiled[0]; k++) {
            sp_arena arena;
            sp_scene scene;
            sp_arena_init(&arena, memory, sizeof memory);
            if (build(&compiled[k], &arena, &scene)) return 1;
            add(&all, &asked[q], compiled[k].name, &scene);
        }
        for (size_t k = 0; k < sizeof made / sizeof made[0]; k++) {
            sp_arena arena;
            sp_scene scene;
            gen_scene g;
            sp_arena_init(&arena, memory, sizeof memory);
            if (!gen_open(&g, made[k].name)) return 1;
            for (int c = 0; c < 3 && made[k].set[c].name; c++) gen_set(&g, made[k].set[c].name, made[k].set[c].value);
            if (gen_build(&g, &arena, &scene)) return 1;
            add(&all, &asked[q], made[k].name, &scene);
        }
        for (int k = 0; k < 2 * KINDS; k++) {
            sp_arena arena;
            sp_scene scene;
            sp_settings set;
            sp_arena_init(&arena, memory, sizeof memory);
            if (kinds_make(k, &arena, &scene, &set)) return 1;
            add(&all, &asked[q], kinds_table[k % KINDS].name, &scene);
        }
        line(asked[q].name, "", &all);
    }
    return 0;
}
