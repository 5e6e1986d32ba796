/* Watching a check: what is told is what is done, and telling it changes nothing. */
#include "../scenes/stages.h"

#include <string.h>

typedef struct seen {
    int32_t steps, stages, backwards;
    sp_stage_id stage[16];
    int64_t flops;                      /* of the stage so far */
} seen;

static void see(void *self, sp_stage_id stage, const sp_cost *cost)
{
    seen *s = self;
    if (stage) {
        if (s->stages < 16) s->stage[s->stages] = stage;
        s->stages++;
    } else {
        s->steps++;
        s->backwards += cost->flops < s->flops && cost->factorisations > 1;
    }
    s->flops = cost->flops;
}

/* What a check answers with someone watching, and without; both must be the same to the last bit. */
static sp_result watched(const sp_scene *s, sp_settings set, seen *eye)
{
    const sp_watch watch = { see, eye };
    sp_result plain, r;
    memset(eye, 0, sizeof *eye);
    CHECK_INT(sp_check(s, &set, &test_arena, &plain), SP_OK);
    set.watch = &watch;
    CHECK_INT(sp_check(s, &set, &test_arena, &r), SP_OK);
    CHECK_INT(r.verdict, plain.verdict);
    CHECK_INT(r.spent.total.flops, plain.spent.total.flops);
    CHECK_INT(memcmp(r.f, plain.f, 3 * (size_t)s->count.points * sizeof *r.f), 0);
    CHECK_INT(memcmp(r.dq, plain.dq, 6 * (size_t)s->count.blocks * sizeof *r.dq), 0);
    CHECK_INT(eye->backwards, 0);
    return r;
}

static const struct { const char *name, *param; double value; } sample[] = {
    { "arch", "n", 15 }, { "arch", "t", 0.09 }, { "wall", "size", 54 }, { "wall", "tilt", 40 }, { "h-model", "mu", 0.3 },
    { "overhang", "factor", 1.05 }, { "dome", "t", 0.1 }, { "rubble", NULL, 0 },
};

TEST(every_factorisation_is_told_once)
{
    for (size_t k = 0; k < sizeof sample / sizeof *sample; k++) {
        sp_scene s;
        seen eye;
        CHECK_INT(gen_make(sample[k].name, sample[k].param, sample[k].value, &test_arena, &s), SP_OK);
        const sp_result r = watched(&s, sp_settings_default(), &eye);
        if (!CHECK_INT(eye.steps, r.spent.total.factorisations)) TEST_PRINT("    %s\n", sample[k].name);
        CHECK_INT(eye.stage[0], SP_STAGE_GATES);
        CHECK(eye.stages > 0);
    }
}

TEST(stages_are_told_as_they_begin)
{
    sp_scene s;
    sp_settings set = sp_settings_default();
    seen eye;
    CHECK_INT(gen_make("arch", "n", 15, &test_arena, &s), SP_OK);
    set.effect[SP_EFFECT_DEPTH] = set.effect[SP_EFFECT_FRICTION] = set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
    set.stage_count = 4;
    set.stage[1] = SP_STAGE_LEAST_SQUARES;
    set.stage[2] = SP_STAGE_POLISH;
    set.stage[3] = SP_STAGE_EXACT;
    watched(&s, set, &eye);
    for (int k = 0; k < eye.stages; k++) CHECK_INT(eye.stage[k], set.stage[k]);
    CHECK(eye.stages > 1);
}

/* Flops of all stages at every place where a check is told of, and where it might end. */
enum { PLACES = 64 };
typedef struct places { int32_t count; int64_t before, stage, at[PLACES]; } places;

static void note(void *self, sp_stage_id stage, const sp_cost *cost)
{
    places *p = self;
    if (stage) p->before += p->stage;
    p->stage = stage ? 0 : cost->flops;
    if (p->count < PLACES) p->at[p->count++] = p->before + cost->flops + 1;
}

/* Ended there, the scene has every byte it had, and is checked as if nothing had been. */
TEST(a_check_that_ends_anywhere_leaves_its_scene_as_it_was)
{
    for (size_t k = 0; k < sizeof sample / sizeof *sample; k++) {
        places p;
        const sp_watch watch = { note, &p };
        sp_settings set = sp_settings_default();
        sp_scene s;
        sp_result all, r;
        memset(&p, 0, sizeof p);
        test_arena.used = 0;
        NEED(gen_make(sample[k].name, sample[k].param, sample[k].value, &test_arena, &s) == SP_OK);
        const size_t bytes = test_arena.used;
        test_arena.used = (bytes + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN + bytes;
        NEED(test_arena.used <= test_arena.capacity);
        unsigned char *copy = test_arena.base + test_arena.used - bytes;
        memcpy(copy, test_arena.base, bytes);
        set.watch = &watch;
        NEED(sp_check(&s, &set, &test_arena, &all) == SP_OK);
        set.watch = NULL;
        NEED(p.count > 0 && p.count < PLACES);
        for (int32_t q = 0; q < p.count; q++) {
            sp_arena a = test_arena;
            set.budget = p.at[q];
            CHECK_INT(sp_check(&s, &set, &a, &r), SP_OK);
            CHECK(r.verdict == SP_UNDECIDED || r.verdict == all.verdict);
            CHECK_INT(memcmp(copy, test_arena.base, bytes), 0);
        }
        set.budget = 0;
        NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
        CHECK_INT(r.verdict, all.verdict);
        CHECK_INT(r.spent.total.flops, all.spent.total.flops);
        CHECK_INT(memcmp(r.f, all.f, 3 * (size_t)s.count.points * sizeof *r.f), 0);
    }
}

TEST_LIST(watch)
    RUN(every_factorisation_is_told_once)
    RUN(stages_are_told_as_they_begin)
    RUN(a_check_that_ends_anywhere_leaves_its_scene_as_it_was)
TEST_END
