/* Memory: what the library says it needs is what it takes; one byte less is refused and nothing outside is touched. */
#include "../test.h"
#include "../scenes/gen.h"

#include <string.h>

enum { GUARD = 256, GUARD_BYTE = 0xa5 };

/* A piece of memory of exactly `bytes` bytes between two guards. */
typedef struct fenced { unsigned char *at; size_t bytes; } fenced;

static fenced fence(size_t bytes)
{
    fenced f;
    size_t from = (test_arena.used + SP_ALIGN - 1) & ~(size_t)(SP_ALIGN - 1);
    unsigned char *p = test_arena.base + from;
    f.at = p + GUARD;
    f.bytes = bytes;
    for (size_t k = 0; k < GUARD; k++) p[k] = f.at[bytes + k] = GUARD_BYTE;
    return f;
}

static int fence_holds(const fenced *f)
{
    for (size_t k = 0; k < GUARD; k++)
        if (f->at[-1 - (ptrdiff_t)k] != GUARD_BYTE || f->at[f->bytes + k] != GUARD_BYTE) return 0;
    return 1;
}

static sp_arena fenced_arena(const fenced *f)
{
    sp_arena a = { f->at, f->bytes, 0, 0 };
    return a;
}

static void build(const char *name, const char *param, double value, sp_scene *scene)
{
    CHECK_INT(gen_make(name, param, value, &test_arena, scene), SP_OK);
}

static const struct { const char *name, *param; double value; } sample[] = {
    { "two-cubes", NULL, 0 }, { "two-cubes", "offset", 0.7 }, { "arch", "n", 7 }, { "arch", "t", 0.09 }, { "h-model", NULL, 0 },
    { "h-model", "mu", 0 }, { "keystone", NULL, 0 }, { "wall", "size", 54 }, { "wall", "tilt", 40 }, { "diamond", "mu", 0.1 }
};

/* Exact size works, and all of it was used; one byte less is refused without a trace. */
TEST(sp_memory_is_exact)
{
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        sp_scene scene;
        sp_result result, before;
        size_t bytes = 0;
        test_arena.used = 0;
        build(sample[k].name, sample[k].param, sample[k].value, &scene);
        NEED(sp_memory(&scene, SP_FOR_CHECK, NULL, test_arena, &bytes) == SP_OK);

        fenced f = fence(bytes);
        sp_arena a = fenced_arena(&f);
        CHECK_INT(sp_check(&scene, NULL, &a, &result), SP_OK);
        CHECK(fence_holds(&f));
        CHECK_INT(result.spent.peak_bytes, bytes);
        CHECK(a.peak <= bytes);

        f = fence(bytes - 1);
        a = fenced_arena(&f);
        before = result;
        CHECK_INT(sp_check(&scene, NULL, &a, &result), SP_E_MEMORY);
        CHECK(fence_holds(&f));
        CHECK_INT(a.used, 0);
        CHECK_INT(a.capacity, bytes - 1);
        CHECK(result.f == before.f && result.verdict == before.verdict && result.spent.peak_bytes == before.spent.peak_bytes);
    }
}

/* The same check with its stages at work in another memory: both sizes exact, every number the same. */
TEST(stages_can_work_in_another_memory)
{
    enum { FAR_BYTES = 1 << 20 };
    const sp_arena whole = test_arena;
    NEED(sp_arena_init(&test_arena, whole.base + FAR_BYTES, whole.capacity - FAR_BYTES) == SP_OK);
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        sp_scene scene;
        sp_result one, two;
        sp_settings set = sp_settings_default();
        size_t all = 0, bytes = 0, work = 0;
        test_arena.used = 0;
        build(sample[k].name, sample[k].param, sample[k].value, &scene);
        NEED(sp_memory(&scene, SP_FOR_CHECK, NULL, test_arena, &all) == SP_OK && sp_memory(&scene, SP_FOR_WORK, NULL, test_arena, &work) == SP_OK);
        NEED(sp_check(&scene, NULL, &test_arena, &one) == SP_OK);

        sp_arena far;
        NEED(work <= FAR_BYTES && sp_arena_init(&far, whole.base, FAR_BYTES) == SP_OK);
        far.capacity = work;
        set.work = &far;
        NEED(sp_memory(&scene, SP_FOR_CHECK, &set, test_arena, &bytes) == SP_OK);
        CHECK(bytes < all && bytes + work >= all);
        CHECK_INT(far.peak, 0);

        fenced f = fence(bytes);
        sp_arena near = fenced_arena(&f);
        NEED(sp_check(&scene, &set, &near, &two) == SP_OK);
        CHECK(fence_holds(&f));
        CHECK_INT(two.spent.peak_bytes, bytes);
        CHECK_INT(far.peak, work);
        CHECK_INT(far.used, 0);
        CHECK(one.verdict == two.verdict && one.reason == two.reason && one.spent.total.flops == two.spent.total.flops);
        CHECK_INT(memcmp(one.f, two.f, 3 * (size_t)scene.count.points * sizeof *one.f), 0);
        CHECK_INT(memcmp(one.dq, two.dq, 6 * (size_t)scene.count.blocks * sizeof *one.dq), 0);

        near = fenced_arena(&f);
        far.capacity = work - 1;
        CHECK_INT(sp_check(&scene, &set, &near, &two), SP_E_MEMORY);
        far.capacity = work;
        f = fence(bytes - 1);
        near = fenced_arena(&f);
        CHECK_INT(sp_check(&scene, &set, &near, &two), SP_E_MEMORY);
        set.work = &near;
        CHECK_INT(sp_check(&scene, &set, &near, &two), SP_E_ARGUMENT);
    }
}

TEST(every_smaller_capacity_is_refused_cleanly)
{
    sp_scene scene;
    size_t bytes = 0;
    build("arch", "n", 3, &scene);
    NEED(sp_memory(&scene, SP_FOR_CHECK, NULL, test_arena, &bytes) == SP_OK);
    for (size_t cap = 0; cap < bytes; cap++) {
        sp_result result;
        const fenced f = fence(cap);
        sp_arena a = fenced_arena(&f);
        const sp_status status = sp_check(&scene, NULL, &a, &result);
        if (!CHECK_INT(status, SP_E_MEMORY) || !CHECK(fence_holds(&f)) || !CHECK_INT(a.used, 0)) {
            CHECK_INT(cap, -1);                         /* tells at which */
            return;
        }
    }
}

/* Where gates decide, or nothing is to be carried, the size is enough, and less than what is taken is refused without a trace. */
TEST(what_gates_decide_takes_no_more)
{
    static const sp_capacity cap = { 3, 0, 0, 0, 1, 4, 0 };
    const sp_real low[3] = { 0, 0, -1 }, high[3] = { 0, 0, 1 }, far_off[3] = { 5, 0, 1 };
    const sp_real square[12] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 };
    const sp_strength strength = sp_strength_friction(R(0.6));
    for (int kind = 0; kind < 3; kind++) {
        sp_scene s;
        sp_result r;
        size_t bytes = 0, least;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK && sp_scene_body(&s, 9, low, SP_FIXED, NULL) == SP_OK);
        NEED(sp_scene_body(&s, 5, high, 0, NULL) == SP_OK);
        if (kind) NEED(sp_scene_joint(&s, 0, 1, 4, square, &strength, NULL) == SP_OK);
        if (kind == 1) NEED(sp_scene_body(&s, 5, far_off, 0, NULL) == SP_OK);
        if (kind == 2) s.gravity[2] = 0;
        NEED(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes) == SP_OK);
        for (least = 0; least <= bytes; least++) {
            const fenced f = fence(least);
            sp_arena a = fenced_arena(&f);
            const sp_status status = sp_check(&s, NULL, &a, &r);
            CHECK(fence_holds(&f));
            if (status == SP_OK) break;
            if (!CHECK_INT(status, SP_E_MEMORY) || !CHECK_INT(a.used, 0)) return;
        }
        if (!TEST_SMALL) CHECK_INT(r.reason, kind == 2 ? SP_REASON_NOTHING : SP_REASON_NO_CONTACT);
        CHECK(least <= bytes && r.spent.peak_bytes == least);
        if (!TEST_SMALL && kind == 2) CHECK(least < bytes);             /* README.md: it takes less than is told */
    }
}

/* A check takes nothing that is not freed by used = mark, and keeps what was there before. */
TEST(check_leaves_what_is_in_the_arena)
{
    sp_scene scene;
    sp_result first, second;
    build("arch", "n", 7, &scene);
    const size_t mark = test_arena.used;
    NEED(sp_check(&scene, NULL, &test_arena, &first) == SP_OK);
    const size_t after = test_arena.used;
    NEED(sp_check(&scene, NULL, &test_arena, &second) == SP_OK);
    CHECK(first.f != second.f);
    CHECK_INT(after - mark, test_arena.used - after);
    for (int32_t k = 0; k < 3 * scene.count.points; k++)
        if (!CHECK(first.f[k] <= second.f[k] && first.f[k] >= second.f[k])) return;
}

TEST(sp_memory_scratch_is_enough_and_less_is_refused)
{
    for (size_t k = 0; k < sizeof sample / sizeof sample[0]; k++) {
        sp_scene scene;
        size_t bytes = 0, again = 1;
        test_arena.used = 0;
        build(sample[k].name, sample[k].param, sample[k].value, &scene);
        const size_t need = sp_memory_scratch(&scene, SP_FOR_CHECK, NULL);
        NEED(need > 0);
        fenced f = fence(need);
        CHECK_INT(sp_memory(&scene, SP_FOR_CHECK, NULL, fenced_arena(&f), &bytes), SP_OK);
        CHECK(fence_holds(&f));
        CHECK_INT(sp_memory(&scene, SP_FOR_CHECK, NULL, test_arena, &again), SP_OK);
        CHECK_INT(bytes, again);
        for (size_t cap = 0; cap < need; cap += 1 + need / 61) {
            f = fence(cap);
            again = 7;
            const sp_status status = sp_memory(&scene, SP_FOR_CHECK, NULL, fenced_arena(&f), &again);
            if (status == SP_OK) CHECK_INT(again, bytes);
            else CHECK_INT(status, SP_E_MEMORY), CHECK_INT(again, 7);
            CHECK(fence_holds(&f));
        }
    }
}

TEST(scene_memory_is_exact_at_every_capacity)
{
    static const sp_capacity cap = { 3, 24, 18, 72, 2, 8, 0 };
    const size_t bytes = sp_scene_memory(&cap);
    NEED(bytes > 0);
    for (size_t given = 0; given <= bytes; given++) {
        sp_scene scene;
        const fenced f = fence(given);
        sp_arena a = fenced_arena(&f);
        CHECK_INT(sp_scene_create(&scene, &cap, &a), given < bytes ? SP_E_MEMORY : SP_OK);
        CHECK(fence_holds(&f));
        CHECK_INT(a.used, given < bytes ? 0 : bytes);
    }
}

/* SP_FOR_VERIFY heeds no settings: it is for 64 faces, where less is refused, and more than enough for the cone. */
TEST(verify_memory_is_enough_and_less_is_refused)
{
    sp_scene scene;
    sp_result result;
    sp_settings settings = sp_settings_default();
    build("arch", "n", 7, &scene);
    settings.faces = 64;
    NEED(sp_check(&scene, &settings, &test_arena, &result) == SP_OK);
    const size_t need = test_bytes(&scene, SP_FOR_VERIFY, NULL);
    NEED(need > 0);
    for (size_t cap = 0; cap <= need; cap++) {
        sp_evidence evidence = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
        const fenced f = fence(cap);
        const sp_status status = sp_verify(&scene, &settings, &result, fenced_arena(&f), &evidence);
        if (!CHECK(fence_holds(&f)) || (status != SP_OK && !CHECK_INT(status, SP_E_MEMORY))) {
            CHECK_INT(cap, -1);
            return;
        }
        CHECK_INT(evidence.verdict, status == SP_OK ? SP_STABLE : SP_UNDECIDED);
        if (cap == need) CHECK_INT(status, SP_OK);
    }
}

TEST(problem_memory_is_exact)
{
    sp_scene scene;
    sp_problem problem;
    build("wall", "size", 54, &scene);
    const size_t need = test_bytes(&scene, SP_FOR_PROBLEM, NULL);
    NEED(need > 0);
    fenced f = fence(need);
    sp_arena a = fenced_arena(&f);
    CHECK_INT(sp_problem_build(&scene, &a, &problem), SP_OK);
    CHECK_INT(a.used, need);
    CHECK(fence_holds(&f));
    f = fence(need - 1);
    a = fenced_arena(&f);
    CHECK_INT(sp_problem_build(&scene, &a, &problem), SP_E_MEMORY);
    CHECK(fence_holds(&f));
}

TEST(problem_memory_of_no_block_is_refused_as_the_call_refuses_it)
{
    static unsigned char memory[1024];
    const sp_capacity room = { 1, 0, 0, 0, 0, 0, 0 };
    sp_arena arena;
    sp_scene scene;
    sp_problem problem;
    size_t bytes = 7;
    NEED(!sp_arena_init(&arena, memory, sizeof memory) && !sp_scene_create(&scene, &room, &arena));
    CHECK_INT(sp_problem_build(&scene, &arena, &problem), SP_E_EMPTY);
    CHECK_INT(sp_memory(&scene, SP_FOR_PROBLEM, NULL, arena, &bytes), SP_E_EMPTY);
    CHECK_INT(bytes, 7);
}

TEST(contacts_memory_is_enough_and_less_is_refused)
{
    sp_scene scene;
    sp_contact_settings settings = sp_contact_settings_default();
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    build("arch", "n", 7, &scene);
    const int32_t given = scene.count.joints, points = scene.count.points;
    const size_t need = test_bytes(&scene, SP_FOR_CONTACTS, NULL);
    NEED(need > 0);
    fenced f = fence(need);
    scene.count.joints = scene.count.points = 0;    /* as if there had been none */
    CHECK_INT(sp_contacts_find(&scene, &settings, fenced_arena(&f), &report), SP_OK);
    CHECK(fence_holds(&f));
    CHECK_INT(scene.count.joints, given);
    CHECK_INT(scene.count.points, points);
    for (size_t cap = 0; cap < need; cap += 1 + need / 199) {
        f = fence(cap);
        scene.count.joints = scene.count.points = 0;
        const sp_status status = sp_contacts_find(&scene, &settings, fenced_arena(&f), &report);
        if (!CHECK(status == SP_E_MEMORY || status == SP_OK) || !CHECK(fence_holds(&f))) return;
        CHECK_INT(scene.count.joints, status == SP_OK ? given : 0);
    }
}

/* Bodies of any weight that touch in points wherever: from none touching to all pairs, repeatedly. */
static void random_scene(sp_scene *scene, int32_t blocks, int32_t joints)
{
    const sp_capacity cap = { blocks, 0, 0, 0, joints, 4 * joints, 2 };
    NEED(sp_scene_create(scene, &cap, &test_arena) == SP_OK);
    for (int32_t k = 0; k < blocks; k++) {
        const sp_real c[3] = { test_random_real(-1, 1), test_random_real(-1, 1), test_random_real(-1, 1) };
        CHECK_INT(sp_scene_body(scene, R(100), c, test_random_int(0, 9) ? 0 : SP_FIXED, NULL), SP_OK);
    }
    for (int32_t k = 0; k < joints && blocks > 1; k++) {
        sp_real xyz[12], n[3] = { test_random_real(-1, 1), test_random_real(-1, 1), R(1) };
        const int32_t a = test_random_int(0, blocks - 1), b = (a + test_random_int(1, blocks - 1)) % blocks;
        const sp_strength strength = sp_strength_friction(R(0.5));
        for (int c = 0; c < 12; c++) xyz[c] = test_random_real(-1, 1);
        CHECK_INT(sp_scene_points(scene, a, b, n, test_random_int(1, 4), xyz, &strength, NULL), SP_OK);
    }
    sp_load load = { 0, 1, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, 0 };
    if (test_random_int(0, 1)) CHECK_INT(sp_scene_load(scene, &load, NULL), SP_OK);
}

/* Mortar in about half of its joints. */
static void strengthen(sp_scene *scene)
{
    for (int32_t k = 0; k < scene->count.joints; k++) {
        sp_strength *s = &scene->joint[k].strength;
        if (test_random_int(0, 1)) s->cohesion = test_random_real(0, 3000);
        if (test_random_int(0, 3) == 0) s->tension = test_random_real(0, 1000);
        if (test_random_int(0, 3) == 0) s->crushing = test_random_real(1000, 100000);
    }
}

#define ALL_STAGES (1 << SP_STAGE_GATES | 1 << SP_STAGE_LEAST_SQUARES | 1 << SP_STAGE_DENSE | 1 << SP_STAGE_POLISH \
                    | 1 << SP_STAGE_EXACT)

static unsigned char a_static_array[SP_SCENE_BYTES(2, 0, 0, 0, 1, 4, 0) + SP_MEMORY_BYTES(2, 1, 4, ALL_STAGES)];

TEST(memory_by_counts_bounds_what_is_taken)
{
    sp_settings dense = sp_settings_default();
    dense.stage_count = 5;
    for (int k = 0; k < 5; k++) dense.stage[k] = (sp_stage_id)(SP_STAGE_GATES + k);
    double least = 1e9;
    for (int k = 0; k < 300; k++) {
        const int32_t blocks = test_random_int(1, k % 10 ? 12 : 40), most = k % 3 ? 3 * blocks : blocks * blocks / 2;
        const int32_t joints = blocks > 1 ? test_random_int(0, most) : 0;
        size_t bytes = 0;
        sp_scene scene;
        test_arena.used = 0;
        random_scene(&scene, blocks, joints);
        NEED(sp_memory(&scene, SP_FOR_CHECK, NULL, test_arena, &bytes) == SP_OK);
        const size_t loads = 4 * (size_t)scene.count.loads;
        const size_t bound = SP_MEMORY_BYTES(blocks, joints, scene.count.points, 0) + loads;
        if (!CHECK(bytes <= bound)) TEST_PRINT("  %d blocks %d joints: %lu > %lu\n", (int)blocks, (int)joints,
                                               (unsigned long)bytes, (unsigned long)bound);
        if ((double)bound / (double)bytes < least) least = (double)bound / (double)bytes;
        NEED(sp_memory(&scene, SP_FOR_CHECK, &dense, test_arena, &bytes) == SP_OK);
        CHECK(bytes <= SP_MEMORY_BYTES(blocks, joints, scene.count.points, ALL_STAGES) + loads);
    }
    CHECK(least < 1.5);                                 /* where all touch all there is not much to spare */
    CHECK(SP_MEMORY_BYTES(1, 1, 1, 1 << SP_STAGE_CUSTOM) == SP_NEVER_FITS);
}

/* Bounds by counts over the truth, smallest and largest, of scenes with some vertices. */
typedef struct spread { const char *what; double least, most; } spread;

static void within(spread *s, const sp_scene *scene, const sp_settings *set, size_t bound)
{
    size_t bytes = 0;
    NEED(sp_memory(scene, SP_FOR_CHECK, set, test_arena, &bytes) == SP_OK);
    bound += 4 * (size_t)scene->count.loads;
    if (!CHECK(bytes <= bound))
        TEST_PRINT("  %s, %d blocks %d joints %d vertices: %lu > %lu\n", s->what, (int)scene->count.blocks,
                   (int)scene->count.joints, (int)scene->count.points, (unsigned long)bytes, (unsigned long)bound);
    if (scene->count.points < 4) return;
    const double ratio = (double)bound / (double)bytes;
    if (ratio < s->least || s->least <= 0) s->least = ratio;
    if (ratio > s->most) s->most = ratio;
}

TEST(pyramids_coupling_and_admm_by_counts_are_bounded)
{
    enum { PYRAMID, COUPLED, PROOF, CG, ADMM, ALL };
    spread s[ALL] = { { "pyramids", 0, 0 }, { "coupled", 0, 0 }, { "coupled, with proofs", 0, 0 },
                      { "ADMM without a factor", 0, 0 }, { "ADMM", 0, 0 } };
    for (int k = 0; k < 120; k++) {
        const int32_t blocks = test_random_int(1, k % 10 ? 8 : 20);
        const int32_t joints = blocks > 1 ? test_random_int(0, 2 * blocks) : 0;
        sp_scene scene;
        test_arena.used = 0;
        random_scene(&scene, blocks, joints);
        const int32_t v = scene.count.points, faces = test_random_int(3, k % 2 ? 8 : 64);
        const int32_t nodes = test_random_int(0, 3) ? test_random_int(0, 300) : 0;
        const size_t plain = SP_MEMORY_BYTES(blocks, joints, v, 0), pyramid = SP_PYRAMID_BYTES(v, faces);
        sp_settings set = sp_settings_default();
        if (k % 3) { set.faces = faces; set.inscribed = k % 2; }
        const size_t base = plain + (k % 3 ? pyramid : 0);
        set.localise = k % 5 > 1;
        within(&s[PYRAMID], &scene, &set, base);
#ifndef SP_NO_CRA
        set.coupled.asked = 1;
        set.coupled.nodes = nodes;
        within(&s[nodes && v <= SP_EXACT_POINTS ? PROOF : COUPLED], &scene, &set, base + SP_COUPLED_BYTES(blocks, v, nodes));
        set.coupled.asked = 0;
#endif
#if !defined SP_NO_QP && !defined SP_NO_ADMM
        set.stage[set.stage_count++] = SP_STAGE_ADMM;
        const size_t both = SP_MEMORY_BYTES(blocks, joints, v, ALL_STAGES | 1 << SP_STAGE_ADMM);
        within(&s[ADMM], &scene, &set, set.faces <= 8 ? base - plain + both : base + SP_ADMM_BYTES(blocks, v, faces));
#ifndef SP_QP_NO_CG
        sp_seed seed = *sp_seed_table();
        seed.dense_cells = 0;
        seed.admm.backend = SP_QP_CG;
        set.seed = &seed;
        within(&s[CG], &scene, &set, base + SP_ADMM_CG_BYTES(blocks, v, set.faces ? faces : seed.faces));
        set.seed = NULL;
#endif
        if (!v) {                                       /* there is no program then */
            size_t bytes = 0;
            sp_arena a = test_arena;
            sp_result r;
            NEED(sp_memory(&scene, SP_FOR_CHECK, &set, test_arena, &bytes) == SP_OK);
            a.capacity = a.used + bytes;
            CHECK_INT(sp_check(&scene, &set, &a, &r), SP_OK);
        }
#endif
    }
    for (int q = 0; q < ALL; q++)
        TEST_PRINT("    %-21s bound / need  %.2f .. %.2f\n", s[q].what, s[q].least, s[q].most);
    for (int q = 0; q < ADMM; q++) CHECK(s[q].least < 2);       /* of one island; where there are several none takes much */
}

/* Stones in `islands`, or one with nearly all joints and the others loose; joints of many vertices any way, in one plane (odd
 * vertices mirror images), or all level. */
static void random_islands(sp_scene *scene, int32_t blocks, int32_t islands, int32_t joints, int32_t most)
{
    const sp_capacity cap = { blocks, 0, 0, 0, joints, most * joints, 1 };
    const int32_t shape = test_random_int(0, 2), supports = test_random_int(0, 1);
    const int32_t large = test_random_int(0, 1) ? blocks - islands : 0;
    NEED(most <= 60 && sp_scene_create(scene, &cap, &test_arena) == SP_OK);
    for (int32_t k = 0; k < blocks; k++) {
        const sp_real c[3] = { test_random_real(-1, 1), shape ? 0 : test_random_real(-1, 1), test_random_real(-1, 1) };
        CHECK_INT(sp_scene_body(scene, R(100), c, k || !supports ? 0 : SP_FIXED, NULL), SP_OK);
    }
    for (int32_t k = 0; k < joints; k++) {
        const int32_t a = test_random_int(1, large && k > islands ? large : blocks - 1), c = test_random_int(1, blocks - 1);
        const int joined = large ? a <= large && c <= large : a % islands == c % islands;
        const int32_t b = joined && a != c && test_random_int(0, 2) ? c : 0, points = test_random_int(1, most);
        const sp_real n[3] = { shape < 2 ? test_random_real(-1, 1) : 0, shape ? 0 : test_random_real(-1, 1), 1 };
        const sp_strength strength = sp_strength_friction(R(0.5));
        sp_real xyz[180];
        for (int32_t i = 0; i < 3 * points; i++) xyz[i] = test_random_real(-1, 1);
        for (int32_t i = 0; i < points && shape; i++) {
            sp_real *x = xyz + 3 * i;
            x[1] = i % 2 ? 1 : -1;
            if (shape == 2) x[2] = 0;
            if (i % 2) { x[0] = x[-3]; x[2] = x[-1]; }
        }
        if (supports || b) CHECK_INT(sp_scene_points(scene, a, b, n, points, xyz, &strength, NULL), SP_OK);
    }
    const sp_load load = { blocks - 1, 1, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, 0 };
    if (test_random_int(0, 1)) CHECK_INT(sp_scene_load(scene, &load, NULL), SP_OK);
}

/* Settings that take memory each in its own way. */
typedef enum variant { BY_DEFAULT, BY_LOCALISE, BY_BUDGET, BY_SPENT, BY_PYRAMID, BY_TOGETHER, BY_SPACE, BY_LADDER,
                       BY_LEAST, BY_DENSE, BY_POLISH, BY_POLISH_BUDGET, BY_EXACT, BY_ADMM,
                       BY_COUPLED, BY_COUPLED_LOCALISE, BY_COUPLED_NODES, BY_COUPLED_ROUNDS, VARIANTS } variant;

/* The settings of a variant.     returns 0: this build leaves it out */
static int variant_settings(variant k, sp_settings *set)
{
    static const sp_stage_id alone[] = { SP_STAGE_LEAST_SQUARES, SP_STAGE_DENSE, SP_STAGE_POLISH, SP_STAGE_POLISH, SP_STAGE_EXACT,
                                         SP_STAGE_ADMM };
    *set = sp_settings_default();
    set->localise = k == BY_LOCALISE || k == BY_COUPLED_LOCALISE || k == BY_COUPLED_NODES;
    if (k == BY_BUDGET || k == BY_POLISH_BUDGET) set->budget = 1000000000;
    if (k == BY_SPENT) set->budget = 20000;
    if (k == BY_PYRAMID) set->faces = 8;
    if (k == BY_TOGETHER) set->effect[SP_EFFECT_TOGETHER] = SP_WITH;
    if (k == BY_SPACE) set->effect[SP_EFFECT_DEPTH] = SP_WITH;
    if (k >= BY_LEAST && k <= BY_ADMM) { set->stage_count = 1; set->stage[0] = alone[k - BY_LEAST]; }
    for (int q = 0; k == BY_LADDER && q < 5; q++) { set->stage[q] = (sp_stage_id)(SP_STAGE_GATES + q); set->stage_count = q + 1; }
    set->coupled.asked = k >= BY_COUPLED;
    if (k == BY_COUPLED_NODES) set->coupled.nodes = 500;
    if (k == BY_COUPLED_ROUNDS) set->coupled.rounds = 10;
#if defined SP_NO_CRA || defined SP_NO_QP || defined SP_NO_ADMM
    if (k == BY_ADMM || k == BY_COUPLED_ROUNDS) return 0;
#endif
#ifdef SP_NO_CRA
    if (set->coupled.asked) return 0;
#endif
#ifdef SP_NO_PLAN
    if (k == BY_SPACE) return 0;
#endif
    return 1;
}

/* Was a part asked all that the settings ask, so that the header promises exact bytes? No earlier stage decided it, no budget ended it,
 * there was something to carry, and forces to ask a coupled check about. */
static int part_was_asked(const sp_settings *set, sp_stage_id stage, sp_reason why, sp_coupling_reason coupled)
{
    if (why == SP_REASON_NO_CONTACT || why == SP_REASON_NO_SUPPORT || why == SP_REASON_NOTHING || why == SP_REASON_BUDGET) return 0;
    if (stage && stage != set->stage[set->stage_count - 1]) return 0;
    return !set->coupled.asked || coupled != SP_COUPLING_STATICS;
}

static int all_was_asked(const sp_settings *set, const sp_result *r)
{
    int all = r->islands.count > 1 || part_was_asked(set, r->stage, r->reason, r->coupled.reason);
    for (int32_t k = 0; k < r->islands.count && r->islands.count > 1; k++)
        all &= part_was_asked(set, r->islands.each[k].stage, r->islands.each[k].reason, r->islands.each[k].coupling_reason);
    return all;
}

/* Exactly so many bytes do and all of them are used; with one SP_ALIGN less nothing is written, in the arena or out of it.
 *   returns 1: the bytes were those promised to be exact */
static int takes_what_was_counted(const sp_scene *scene, const sp_settings *set)
{
    sp_result r, before;
    size_t bytes = 0;
    const sp_status counted = sp_memory(scene, SP_FOR_CHECK, set, test_arena, &bytes);
    fenced f = fence(bytes);
    sp_arena a = fenced_arena(&f);
    if (!CHECK_INT(counted, SP_OK) || !CHECK_INT(sp_check(scene, set, &a, &r), SP_OK) || !CHECK(fence_holds(&f))) return 0;
    CHECK(r.spent.peak_bytes <= bytes);
    if (!all_was_asked(set, &r)) return 0;
    CHECK_INT(r.spent.peak_bytes, bytes);
    f = fence(bytes - SP_ALIGN);
    a = fenced_arena(&f);
    memset(&r, 0x5a, sizeof r);
    before = r;
    CHECK_INT(sp_check(scene, set, &a, &r), SP_E_MEMORY);
    CHECK(a.used == 0 && a.capacity == bytes - SP_ALIGN && memcmp(&r, &before, sizeof r) == 0 && fence_holds(&f));
    return 1;
}

TEST(what_is_counted_is_taken_whatever_is_asked)
{
    const int bundled = (int)(sizeof sample / sizeof *sample);
    for (int k = 0; k < VARIANTS; k++) {
        const int some = k < BY_ADMM ? SOME_OF(400, 40) : k < BY_COUPLED ? SOME_OF(400, 16) : SOME_OF(100, 12);
        const int scenes = k < BY_COUPLED_ROUNDS ? some : bundled;
        const int most = k < BY_COUPLED ? 12 : SOME_OF(12, 6);          /* joints: of many a search of a second is in vain */
        int exact = 0;
        sp_settings set;
        if (!variant_settings((variant)k, &set)) continue;
        for (int q = 0; q < scenes; q++) {
            sp_scene scene;
            test_arena.used = 0;
            if (q < bundled) build(sample[q].name, sample[q].param, sample[q].value, &scene);
            else if (q % 2) random_scene(&scene, test_random_int(1, most / 2), test_random_int(0, most));
            else random_islands(&scene, test_random_int(3, most / 2 + 2), 2, test_random_int(0, most), 4);
            if (q % 3 == 1 && k < BY_COUPLED) strengthen(&scene);
            if (k == BY_ADMM && scene.count.vertices > 500 && !TEST_LONG()) continue;       /* 4 s in float, without an end */
            exact += takes_what_was_counted(&scene, &set);
        }
        if (!CHECK(exact >= 5)) TEST_PRINT("  variant %d: %d of %d exact\n", k, exact, scenes);
    }
}

/* Stones that touch nothing, with weight, without, and all of them supports: whatever is asked, the bytes are counted and do. */
TEST(where_nothing_touches_bytes_are_counted)
{
    static const sp_capacity cap = { 2, 0, 0, 0, 0, 0, 0 };
    for (int k = 0; k < 3 * VARIANTS; k++) {
        sp_scene s;
        sp_settings set;
        const sp_real low[3] = { 0, 0, 0 }, high[3] = { 0, 0, 3 };
        test_arena.used = 0;
        if (!variant_settings((variant)(k / 3), &set)) continue;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        const uint32_t fixed = k % 3 == 2 ? SP_FIXED : 0;
        NEED(sp_scene_body(&s, 9, low, fixed, NULL) == SP_OK && sp_scene_body(&s, 5, high, fixed, NULL) == SP_OK);
        if (k % 3 == 1) s.gravity[2] = 0;
        takes_what_was_counted(&s, &set);
    }
}

TEST(strength_by_counts_is_bounded)
{
    spread s = { "strength", 0, 0 };
    for (int k = 0; k < 200; k++) {
        const int32_t blocks = test_random_int(2, k % 10 ? 12 : 40), joints = test_random_int(1, 3 * blocks);
        sp_scene scene;
        sp_settings set = sp_settings_default();
        test_arena.used = 0;
        if (k % 2) random_scene(&scene, blocks, joints);
        else random_islands(&scene, blocks, test_random_int(1, blocks - 1), joints, 4);
        strengthen(&scene);
        set.faces = k % 3 ? 0 : test_random_int(3, 64);
        const int32_t i = scene.count.joints, v = scene.count.points;
        const size_t more = set.faces ? SP_PYRAMID_BYTES(v, set.faces) : SP_STRENGTH_BYTES(blocks, v);
        within(&s, &scene, &set, SP_MEMORY_BYTES(blocks, i, v, 0) + more);
    }
    TEST_PRINT("    %-21s bound / need  %.3f .. %.2f\n", s.what, s.least, s.most);
#ifndef SP_NO_IPM
    CHECK(s.least > 0 && s.least < 1.5);                /* without interior points strength takes nothing */
#endif
}

TEST(islands_of_few_stones_with_many_joints_are_bounded)
{
    enum { PLAIN, DENSE, PYRAMID, COUPLED, ALL };
    spread s[ALL] = { { "plain", 0, 0 }, { "all stages", 0, 0 }, { "pyramids", 0, 0 }, { "coupled", 0, 0 } };
    for (int k = 0; k < 400; k++) {
        const int32_t blocks = test_random_int(2, k % 8 ? 8 : 30), islands = test_random_int(1, blocks - 1);
        const int32_t joints = test_random_int(0, k % 3 ? 40 : 300);
        sp_scene scene;
        test_arena.used = 0;
        random_islands(&scene, blocks, islands, joints, k % 4 ? 4 : 60);
        const int32_t i = scene.count.joints, v = scene.count.points, faces = test_random_int(3, 64);
        const size_t plain = SP_MEMORY_BYTES(blocks, i, v, 0);
        sp_settings set = sp_settings_default();
        within(&s[PLAIN], &scene, &set, plain);
#ifndef SP_NO_CRA
        set.coupled.asked = 1;
        set.coupled.nodes = v <= SP_EXACT_POINTS ? test_random_int(0, 300) : 0;
        within(&s[COUPLED], &scene, &set, plain + SP_COUPLED_BYTES(blocks, v, set.coupled.nodes));
        set.coupled.asked = 0;
#endif
        set.faces = faces;
        within(&s[PYRAMID], &scene, &set, plain + SP_PYRAMID_BYTES(v, faces));
        set.faces = 0;
        set.stage_count = 5;
        for (int q = 0; q < 5; q++) set.stage[q] = (sp_stage_id)(SP_STAGE_GATES + q);
        within(&s[DENSE], &scene, &set, SP_MEMORY_BYTES(blocks, i, v, ALL_STAGES));
    }
    for (int q = 0; q < ALL; q++) TEST_PRINT("    %-21s bound / need  %.3f .. %.2f\n", s[q].what, s[q].least, s[q].most);
    CHECK(s[PLAIN].least < 1.25);                       /* and where one has nearly all, there is not much to spare */
}

TEST(scene_memory_by_counts_is_exact)
{
    for (int k = 0; k < 100; k++) {
        int32_t n[7];
        for (int c = 0; c < 7; c++) n[c] = test_random_int(0, 99);
        const sp_capacity cap = { n[0], n[1], n[2], n[3], n[4], n[5], n[6] };
        CHECK_INT(SP_SCENE_BYTES(n[0], n[1], n[2], n[3], n[4], n[5], n[6]), sp_scene_memory(&cap));
    }
}

/* What a size_t of 32 bits cannot hold is told all the same, alone and in sums, up to the counts that the header names. */
#define MANY (1 << 23)
typedef char bytes_are_of_64_bits[sizeof(SP_SCENE_BYTES(1, 1, 1, 1, 1, 1, 1)) == 8 && sizeof(SP_MEMORY_BYTES(1, 1, 1, 0)) == 8
                                  && sizeof(SP_PYRAMID_BYTES(1, 8)) == 8 && sizeof(SP_STRENGTH_BYTES(1, 1)) == 8
                                  && sizeof(SP_COUPLED_BYTES(1, 1, 0)) == 8
                                  && sizeof(SP_ADMM_BYTES(1, 1, 8)) == 8 && sizeof(SP_ADMM_CG_BYTES(1, 1, 8)) == 8 ? 1 : -1];
typedef char a_full_factor_is_not_wrapped[SP_MEMORY_BYTES(100000, 0, 0, 0) / 4096 > UINT32_MAX / 4096 ? 1 : -1];
typedef char the_largest_are_not_wrapped[SP_ADMM_BYTES(MANY, MANY, 64) > (uint64_t)20 * MANY * MANY * 64
                                         && SP_MEMORY_BYTES(MANY, MANY, MANY, ALL_STAGES) > (uint64_t)36 * MANY * MANY ? 1 : -1];

TEST(bytes_by_counts_do_not_wrap)
{
    uint64_t last = 0;
    for (int32_t n = 1; n <= MANY; n *= 2) {
        const uint64_t all = SP_SCENE_BYTES(n, n, n, n, n, n, n) + SP_MEMORY_BYTES(n, n, n, ALL_STAGES) + SP_PYRAMID_BYTES(n, 64)
                           + SP_STRENGTH_BYTES(n, n)
                           + SP_COUPLED_BYTES(n, n, 48000) + SP_ADMM_BYTES(n, n, 64);
        CHECK(all > last && all < SP_NEVER_FITS && all + SP_NEVER_FITS > all);
        last = all;
    }
}

TEST(a_static_array_sized_by_counts_is_enough)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 0 };
    const sp_real low[3] = { 0, 0, 0 }, high[3] = { 0, 0, 1 };
    const sp_real xyz[12] = { R(-0.5), R(-0.5), R(0.5), R(0.5), R(-0.5), R(0.5), R(0.5), R(0.5), R(0.5), R(-0.5), R(0.5), R(0.5) };
    const sp_strength strength = sp_strength_friction(R(0.5));
    sp_arena arena;
    sp_scene scene;
    sp_result r;
    NEED(sp_arena_init(&arena, a_static_array, sizeof a_static_array) == SP_OK);
    NEED(sp_scene_create(&scene, &cap, &arena) == SP_OK);
    NEED(sp_scene_body(&scene, R(1), low, SP_FIXED, NULL) == SP_OK && sp_scene_body(&scene, R(1), high, 0, NULL) == SP_OK);
    NEED(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL) == SP_OK);
    NEED(sp_check(&scene, NULL, &arena, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
}

/* The scene with its meshes and all that a check takes. */
TEST(a_wall_of_64_joints_is_checked_in_128_kB_and_in_float_in_64)
{
    sp_arena a = test_arena;
    sp_scene s;
    sp_result r;
    a.capacity = a.used + TOL(128, 64) * 1024;
    CHECK_INT(gen_make("wall", "size", 54, &a, &s), SP_OK);
    CHECK_INT(s.count.joints, 64);
    CHECK_INT(sp_check(&s, NULL, &a, &r), SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK(a.used <= a.capacity);
}

TEST_LIST(memory)
    RUN(what_is_counted_is_taken_whatever_is_asked)
    RUN(where_nothing_touches_bytes_are_counted)
    RUN(a_wall_of_64_joints_is_checked_in_128_kB_and_in_float_in_64)
    RUN(sp_memory_is_exact)
    RUN(stages_can_work_in_another_memory)
    RUN(every_smaller_capacity_is_refused_cleanly)
    RUN(what_gates_decide_takes_no_more)
    RUN(check_leaves_what_is_in_the_arena)
    RUN(sp_memory_scratch_is_enough_and_less_is_refused)
    RUN(scene_memory_is_exact_at_every_capacity)
    RUN(verify_memory_is_enough_and_less_is_refused)
    RUN(problem_memory_is_exact)
    RUN(problem_memory_of_no_block_is_refused_as_the_call_refuses_it)
    RUN(contacts_memory_is_enough_and_less_is_refused)
    RUN(memory_by_counts_bounds_what_is_taken)
    RUN(pyramids_coupling_and_admm_by_counts_are_bounded)
    RUN(strength_by_counts_is_bounded)
    RUN(islands_of_few_stones_with_many_joints_are_bounded)
    RUN(scene_memory_by_counts_is_exact)
    RUN(bytes_by_counts_do_not_wrap)
    RUN(a_static_array_sized_by_counts_is_enough)
TEST_END
