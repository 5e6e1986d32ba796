/* A system takes what was counted for it: every form of it, in 6 rows a block and in 3. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../scenes/gen.h"
#include "../../solvers/statics/open.c"

static const struct { const char *name, *number; double value; } scene_of[] = {
    { "arch", "n", 7 }, { "wall", "size", 20 }, { "wall", "jitter", 0.3 }, { "dome", "rings", 3 }, { "h-model", NULL, 0 }
};

/* A scene ready, and settings with what a system reads of them; the rest of test_arena is behind them. */
typedef struct subject { sp_scene scene; sp_problem pb; sp_settings set; sp_cost cost; } subject;

static int begin(subject *o, size_t k, int32_t faces, int64_t budget)
{
    memset(o, 0, sizeof *o);
    o->set.tol = R(TOL(1e-9, 1e-4f));
    o->set.penalty.gamma = 1000;
    o->set.penalty.tau = 1;
    o->set.faces = faces;
    o->set.budget = budget;
    o->set.iterations = SP__ITERATIONS;
    o->set.stage_count = 1;
    o->set.stage[0] = SP_STAGE_EXACT;
    test_arena.used = 0;
    return CHECK_INT(gen_make(scene_of[k].name, scene_of[k].number, scene_of[k].value, &test_arena, &o->scene), SP_OK)
        && CHECK_INT(sp_problem_build(&o->scene, &test_arena, &o->pb), SP_OK);
}

/* An arena of its own for so many bytes. */
static sp_arena room(size_t bytes)
{
    const size_t from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    sp_arena a = { test_arena.base + from, bytes, 0, 0 };
    return a;
}

TEST(a_system_takes_what_was_counted)
{
    int made = 0;
    for (size_t k = 0; k < sizeof scene_of / sizeof *scene_of; k++)
        for (int variant = 0; variant < 4; variant++)
            for (int form = SP__EXACT; form <= SP__MOTION; form++) {
                subject o;
                NEED(begin(&o, k, variant % 2 ? 6 : 0, variant / 2 ? 1000000 : 0));
                const size_t need = sp__system_need(&o.pb, &o.set, (sp__form)form, test_arena);
                sp_arena a = room(need), less = room(need - SP_ALIGN);
                CHECK(sp__system_make_full(&o.pb, &o.set, (sp__form)form, &o.cost, &a) != NULL);
                CHECK_INT(a.peak, need);
                CHECK(sp__system_make_full(&o.pb, &o.set, (sp__form)form, &o.cost, &less) == NULL);
                made++;
            }
    CHECK(made >= 5 * 4 * 8);
}

/* A search in 3 rows and the one in 6 after it, in the same memory: the larger of both was counted. */
TEST(a_reduced_system_and_the_whole_one_take_what_was_counted)
{
    int reduced = 0;
    for (size_t k = 0; k < sizeof scene_of / sizeof *scene_of; k++)
        for (int32_t faces = 0; faces < 7; faces += 6) {
            subject o;
            NEED(begin(&o, k, faces, 0));
            const size_t need = sp__system_need_reduced(&o.pb, &o.set, SP__EXACT, test_arena);
            sp_arena a = room(need), whole = a, less = room(need - SP_ALIGN), less_whole = less;
            sp__reduction *r = sp__take(&a, 1, sizeof *r);
            NEED(r != NULL && sp__system_make_full(&o.pb, &o.set, SP__EXACT, &o.cost, &whole) != NULL);
            int enough = sp__system_make_full(&o.pb, &o.set, SP__EXACT, &o.cost, &less_whole) != NULL;
            size_t most = whole.peak;
            if (sp__reduction_choose(&o.pb, &o.set, r)) {
                CHECK(sp__system_make(&o.pb, &o.set, SP__EXACT, r, &o.cost, &a) != NULL);
                if (a.peak > most) most = a.peak;
                r = sp__take(&less, 1, sizeof *r);
                enough &= sp__reduction_choose(&o.pb, &o.set, r)
                       && sp__system_make(&o.pb, &o.set, SP__EXACT, r, &o.cost, &less) != NULL;
                reduced++;
            }
            CHECK_INT(most, need);
            CHECK(!enough);
        }
    if (SP__WITH_REDUCTION) CHECK(reduced >= 4);
}

TEST_LIST(open)
    RUN(a_system_takes_what_was_counted)
    RUN(a_reduced_system_and_the_whole_one_take_what_was_counted)
TEST_END
