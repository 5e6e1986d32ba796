/* More cores: the tasks of a factor run in any order, each once, and no bit of an answer depends on it. */
#include "../test.h"
#include "../scenes/gen.h"

#include <string.h>

enum { FEWEST = 2, MOST = 16 };                         /* tasks that are given at once */

/* Who runs them: how often, and calls with a number of tasks that is not promised. */
typedef struct crew { int32_t calls, wrong, step; } crew;

/* Tasks 0, step, 2 step, .. modulo n, from the last on: with an odd step each once for n = 2, 4, 8, 16; else one after the other. */
static void run_mixed_up(void *self, void (*task)(void *job, int32_t k), void *job, int32_t n)
{
    crew *c = self;
    const int turned = n == 2 || n == 4 || n == 8 || n == 16;
    c->calls++;
    c->wrong += n < FEWEST || n > MOST;
    for (int32_t k = n - 1; k >= 0; k--) task(job, turned ? c->step * k % n : k);
}

static const struct { const char *name; const char *number; double value, degrees; } sample[] = {
    { "dome", "rings", 8, 0 },                          /* blocks of 6 x 6 */
    { "dome", "t", 0.03, 2 },                           /* that falls: interior points, and where help is wanted */
#ifndef SP_NO_PLAN
    { "wall", "size", 2000, 0 },                        /* of 3 x 3 */
#endif
};

TEST(tasks_in_any_order_give_the_same_bits)
{
    for (size_t k = 0; k < sizeof sample / sizeof *sample; k++) {
        sp_scene s;
        sp_result alone, r;
        crew c = { 0, 0, 3 };
        const sp_parallel all = { run_mixed_up, &c };
        sp_settings set = sp_settings_default();
        set.localise = 1;
        test_arena.used = 0;
        NEED(gen_make(sample[k].name, sample[k].number, sample[k].value, &test_arena, &s) == SP_OK);
        gen_gravity(sample[k].degrees, 30, s.gravity);
        NEED(sp_check(&s, &set, &test_arena, &alone) == SP_OK);
        set.parallel = &all;
        NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
        if (!CHECK(c.calls > 0)) TEST_PRINT("    %s %s\n", sample[k].name, sample[k].number);
        CHECK_INT(c.wrong, 0);
        CHECK_INT(r.verdict, alone.verdict);
        CHECK_INT(r.spent.total.flops, alone.spent.total.flops);
        CHECK_INT(memcmp(r.f, alone.f, 3 * (size_t)s.count.points * sizeof *r.f), 0);
        CHECK_INT(memcmp(r.dq, alone.dq, 6 * (size_t)s.count.blocks * sizeof *r.dq), 0);
        CHECK_INT(memcmp(r.demand, alone.demand, (size_t)s.count.joints * sizeof *r.demand), 0);
    }
}

#ifndef SP_NO_IPM
TEST(a_limit_has_the_same_bits_too)
{
    sp_scene s;
    sp_limit_result alone, r;
    crew c = { 0, 0, 5 };
    const sp_parallel all = { run_mixed_up, &c };
    sp_settings set = sp_settings_default();
    NEED(gen_make("dome", "rings", 8, &test_arena, &s) == SP_OK);
    s.body[0] = 1;
    NEED(sp_limit(&s, &set, &test_arena, &alone) == SP_OK);
    set.parallel = &all;
    NEED(sp_limit(&s, &set, &test_arena, &r) == SP_OK);
    CHECK(c.calls > 0);
    CHECK_INT(c.wrong, 0);
    CHECK_INT(memcmp(&r.multiplier, &alone.multiplier, sizeof r.multiplier), 0);
    CHECK_INT(memcmp(r.f, alone.f, 3 * (size_t)s.count.points * sizeof *r.f), 0);
    CHECK_INT(memcmp(r.dq, alone.dq, 6 * (size_t)s.count.blocks * sizeof *r.dq), 0);
}
#endif

TEST(small_scenes_have_no_tasks)
{
    sp_scene s;
    sp_result r;
    crew c = { 0, 0, 1 };
    const sp_parallel all = { run_mixed_up, &c };
    sp_settings set = sp_settings_default();
    NEED(gen_make("arch", "n", 15, &test_arena, &s) == SP_OK);
    set.parallel = &all;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(c.calls, 0);
}

TEST(nobody_to_run_tasks_is_refused)
{
    sp_scene s;
    sp_result r;
    const sp_parallel none = { NULL, NULL };
    sp_settings set = sp_settings_default();
    NEED(gen_make("arch", "n", 15, &test_arena, &s) == SP_OK);
    set.parallel = &none;
    CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_ARGUMENT);
}

TEST_LIST(parallel)
    RUN(tasks_in_any_order_give_the_same_bits)
#ifndef SP_NO_IPM
    RUN(a_limit_has_the_same_bits_too)
#endif
    RUN(small_scenes_have_no_tasks)
    RUN(nobody_to_run_tasks_is_refused)
TEST_END
