/* Work of a check, counted: factorisations, flops and bytes of scenes of the bench, so that a regression shows without a clock.
 * In double and float, with nothing left out, the counts are the same on every machine. */
#include "../test.h"
#include "../scenes/gen.h"

#include <string.h>

#if defined SP_NO_IPM || defined SP_NO_PLAN || defined SP_REAL_MIXED || defined SP_REAL_QUAD
enum { COUNTED = 0, SINGLE = 0 };
#else
enum { COUNTED = TOL(1, 0), SINGLE = TOL(0, 1) };
#endif

typedef struct work {
    const char *name, *number; double value; const char *second; double second_value, thick, tilt, azimuth;
    sp_verdict verdict;
    int factorisations; double mflop;
    int helped; double helped_mflop;                    /* with settings.localise */
    double kib; int single;                             /* with it; factorisations in float, at most */
} work;

enum { LARGE = 2 };                                     /* the last ones of the table, for LONG=1 */

static const work bench[] = {
    { "wall", "size", 54, "jitter", 0.35, 0, 0, 0, SP_STABLE, 3, 0.224, 3, 0.224, 69, 3 },
    { "wall", "size", 54, "jitter", 0.35, 0, 8.421746, 90, SP_STABLE, 2, 1.044, 2, 1.044, 69, 2 },
    { "wall", "size", 54, "jitter", 0.35, 0, 17.545304, 90, SP_UNSTABLE, 1, 0.992, 5, 1.934, 69, 4 },
    { "wall", "size", 147, "jitter", 0.35, 0, 0, 0, SP_STABLE, 3, 0.603, 3, 0.603, 176.8, 3 },
    { "wall", "size", 147, "jitter", 0.35, 0, 14.323945, 0, SP_STABLE, 6, 1.098, 6, 1.098, 176.8, 6 },
    { "wall", "size", 147, "jitter", 0.35, 0, 11.827903, 90, SP_UNSTABLE, 1, 3.041, 6, 6.658, 176.8, 5 },
    { "wall", "size", 500, "jitter", 0.35, 0, 0, 0, SP_STABLE, 2, 2.721, 2, 2.721, 690.1, 2 },
    { "wall", "size", 500, "jitter", 0.35, 0, 6.493036, 90, SP_UNSTABLE, 1, 16.484, 6, 38.145, 690.1, 10 },
    { "arch", "n", 11, NULL, 0, 0.12, 0, 0, SP_STABLE, 3, 0.038, 3, 0.038, 17.5, 3 },
    { "arch", "n", 51, NULL, 0, 0.10, 0, 0, SP_UNSTABLE, 6, 0.651, 13, 0.911, 72, 26 },
    { "arch", "n", 200, NULL, 0, 0.12, 0, 0, SP_STABLE, 6, 2.221, 6, 2.221, 275.1, 8 },
    { "arch", "n", 200, NULL, 0, 0.10, 0, 0, SP_UNSTABLE, 7, 3.065, 21, 5.705, 275.1, 63 },
    { "dome", "rings", 12, "segments", 24, 0.10, 0, 0, SP_STABLE, 2, 24.900, 2, 24.900, 1149.0, 2 },
    { "dome", "rings", 12, "segments", 24, 0.02, 0, 0, SP_UNSTABLE, 1, 29.441, 8, 103.230, 1149.0, 8 },
    { "wall", "size", 2000, "jitter", 0.35, 0, 0, 0, SP_STABLE, 2, 22.027, 2, 22.027, 3935.5, 2 },
    { "wall", "size", 2000, "jitter", 0.35, 0, 3.253203, 90, SP_UNSTABLE, 1, 161.680, 8, 493.732, 3935.5, 13 }
};

static int make(const work *b, sp_scene *s)
{
    gen_scene g;
    if (gen_open(&g, b->name) != 1 || gen_set(&g, b->number, b->value) != 1) return 0;
    if (b->second && gen_set(&g, b->second, b->second_value) != 1) return 0;
    if (b->thick > 0 && gen_set(&g, "t", b->thick) != 1) return 0;
    if (gen_build(&g, &test_arena, s) != SP_OK) return 0;
    if (b->tilt > 0) gen_gravity(b->tilt, b->azimuth, s->gravity);
    return 1;
}

TEST(scenes_of_the_bench_take_no_more_work_than_written_here)
{
    const size_t all = sizeof bench / sizeof bench[0];
    for (size_t k = 0; k < 2 * SOME_OF(all, all - LARGE); k++) {
        const work *b = &bench[k / 2];
        const int helped = k % 2;
        sp_settings set = sp_settings_default();
        sp_scene s;
        sp_result r;
        set.localise = helped;
        test_arena.used = 0;
        NEED(CHECK(make(b, &s)));
        const size_t before = test_arena.peak = test_arena.used;
        NEED(CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK));
        const sp_cost *spent = &r.spent.total;
        CHECK(r.verdict == b->verdict || (!COUNTED && r.verdict == SP_UNDECIDED));
        if (SINGLE) CHECK(spent->factorisations <= b->single);
        if (!COUNTED) continue;
        CHECK_INT(spent->factorisations, helped ? b->helped : b->factorisations);
        CHECK((double)spent->flops <= 1.001e6 * (helped ? b->helped_mflop : b->mflop));
        CHECK((double)(r.spent.peak_bytes - before) <= 1030 * b->kib);
    }
}

TEST_LIST(work)
    RUN(scenes_of_the_bench_take_no_more_work_than_written_here)
TEST_END
