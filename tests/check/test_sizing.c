/* Bounds near the truth: SP_CHECK_BYTES and its kin are never less than what sp_memory tells, and at most 1.3 times it, for
 * walls, arches and piles of 8 to 60 stones. */
#include "../scenes/gen.h"
#include "../test.h"

#if defined SP_NO_IPM || defined SP_REAL_MIXED          /* these take less, bounds are as they are */
#define MOST 2.0
#else
#define MOST 1.3
#endif

enum { CHECK_FOR, LIMIT_FOR, SEQUENCE_FOR, CONTACTS_FOR, QUESTIONS };
static const char *const asked[QUESTIONS] = { "check", "limit", "sequence", "contacts" };

typedef struct spread { double least[QUESTIONS], most[QUESTIONS]; int scenes; } spread;

static int32_t free_blocks(const sp_scene *s)
{
    int32_t n = 0;
    for (int32_t k = 0; k < s->count.blocks; k++) n += s->block[k].fixed != SP_FIXED;
    return n;
}

/* Do all free blocks hang together? */
static int one_island(const sp_scene *s)
{
    static int32_t to[128];
    int32_t parts = free_blocks(s);
    for (int32_t k = 0; k < s->count.blocks; k++) to[k] = k;
    for (int32_t k = 0; k < s->count.joints; k++) {
        int32_t a = s->joint[k].a, b = s->joint[k].b;
        if (s->block[a].fixed == SP_FIXED || s->block[b].fixed == SP_FIXED) continue;
        while (to[a] != a) a = to[a];
        while (to[b] != b) b = to[b];
        if (a != b) { to[a] = b; parts--; }
    }
    return parts == 1;
}

static int32_t most_corners(const sp_scene *s)
{
    int32_t most = 0;
    for (int32_t k = 0; k < s->count.blocks; k++) {
        int32_t n = 0;
        for (int32_t i = 0; i < s->block[k].faces; i++) n += s->face[s->block[k].face + i].corners;
        if (n > most) most = n;
    }
    return most;
}

/* What is needed, told by sp_memory; 0: this build leaves the question out. */
static size_t needed(const sp_scene *s, sp_memory_for what)
{
    size_t bytes = 0;
    const sp_status status = sp_memory(s, what, NULL, test_arena, &bytes);
    return status == SP_E_UNSUPPORTED ? 0 : CHECK_INT(status, SP_OK) ? bytes : 0;
}

static void compare(spread *sp, int q, uint64_t bound, size_t need, const char *name, const sp_scene *s)
{
    const double ratio = (double)bound / (double)need;
    if (!need) return;
    if (!CHECK(bound >= need && ratio <= MOST))
        TEST_PRINT("  %s, %s: %d blocks %d joints %d vertices: %lu for %lu\n", name, asked[q], (int)s->count.blocks,
                   (int)s->count.joints, (int)s->count.points, (unsigned long)bound, (unsigned long)need);
    if (!sp->scenes || ratio < sp->least[q]) sp->least[q] = ratio;
    if (!sp->scenes || ratio > sp->most[q]) sp->most[q] = ratio;
}

static void bounded(spread *sp, const sp_scene *s, uint64_t fill, const char *name)
{
    const int32_t b = s->count.blocks, j = s->count.joints, v = s->count.points;
    const int32_t f = free_blocks(s);
    if (f < 8 || f > 60 || !one_island(s)) return;
    compare(sp, CHECK_FOR, SP_CHECK_BYTES(b, j, v, fill), needed(s, SP_FOR_CHECK), name, s);
    compare(sp, SEQUENCE_FOR, SP_SEQUENCE_BYTES(b, j, v, fill), needed(s, SP_FOR_SEQUENCE), name, s);
#ifndef SP_NO_IPM
    compare(sp, LIMIT_FOR, SP_LIMIT_BYTES(b, j, v, fill), needed(s, SP_FOR_LIMIT), name, s);
#endif
    compare(sp, CONTACTS_FOR, SP_CONTACTS_BYTES(b, s->count.vertices, s->count.faces, s->count.corners, most_corners(s)),
            needed(s, SP_FOR_CONTACTS), name, s);
    sp->scenes++;
}

static void tell(const spread *sp)
{
    for (int q = 0; q < QUESTIONS; q++)
        TEST_PRINT("    %-9s bound / need  %.3f .. %.3f\n", asked[q], sp->least[q], sp->most[q]);
}

/* A scene by formula with two of its numbers set, and its bound as a wall so wide; courses of one stone alternate with two
 * halves. */
static void course(spread *sp, const char *name, const char *one, double x, const char *two, double y, const char *three,
                   double z)
{
    gen_scene g;
    sp_arena arena = test_arena;
    sp_scene s;
    const double width = !two || x < 2 ? 1 : y < 2 ? 2 : x < y ? x : y;
    NEED(gen_open(&g, name));
    gen_set(&g, one, x);
    if (two) gen_set(&g, two, y);
    if (three) gen_set(&g, three, z);
    NEED(gen_build(&g, &arena, &s) == SP_OK);
    const sp_arena all = test_arena;
    test_arena = arena;
    bounded(sp, &s, SP_FILL_WALL(s.count.blocks, s.count.joints, (int)width), name);
    test_arena = all;
}

TEST(arches_and_towers_are_bounded_within_1_3)
{
    spread sp = { { 0 }, { 0 }, 0 };
    for (int n = 8; n <= 60; n += n < 12 ? 1 : SOME_OF(1, 6)) {
        course(&sp, "arch", "n", n, NULL, 0, NULL, 0);
        course(&sp, "flat-arch", "n", n, NULL, 0, NULL, 0);
        course(&sp, "tower", "n", n, NULL, 0, NULL, 0);
    }
    tell(&sp);
    CHECK(sp.scenes >= 30);
}

TEST(walls_are_bounded_within_1_3)
{
    spread sp = { { 0 }, { 0 }, 0 };
    for (int rows = 1; rows <= 30; rows++)
        for (int bricks = 1; bricks <= 30; bricks++) {
            if (rows * bricks < 8 || rows * (bricks + 1) > 66 || (!TEST_LONG() && (rows + bricks) % 3)) continue;
            course(&sp, "wall", "rows", rows, "bricks", bricks, "jitter", 0.2 * (rows % 3));
            course(&sp, "rubble", "rows", rows, "bricks", bricks, "seed", 1 + rows % 7);
            if (rows > 2) course(&sp, "vault", "around", rows, "n", bricks, NULL, 0);
        }
    tell(&sp);
    CHECK(sp.scenes >= 60);
}

static void box(sp_scene *s, const sp_real at[3], const sp_real size[3], uint32_t fixed)
{
    static const int32_t four[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 3,2,1,0, 4,5,6,7, 0,1,5,4, 1,2,6,5, 2,3,7,6, 3,0,4,7 };
    sp_real xyz[24];
    for (int k = 0; k < 8; k++) {
        xyz[3 * k] = at[0] + (k % 4 == 1 || k % 4 == 2) * size[0];
        xyz[3 * k + 1] = at[1] + (k % 4 > 1) * size[1];
        xyz[3 * k + 2] = at[2] + (k > 3) * size[2];
    }
    const sp_mesh mesh = { 8, 6, xyz, four, corner };
    NEED(sp_scene_block(s, &mesh, 2400, fixed, NULL) == SP_OK);
}

/* m x n stones in layers, each layer moved by (x, y), smaller by `less`; gap 0: they touch sideways, too. */
typedef struct heap { int m, n, layers, less; double gap, x, y; } heap;

static void heaped(spread *sp, const heap *h)
{
    static const sp_capacity cap = { 64, 64 * 8, 64 * 6, 64 * 24, 400, 1600, 0 };
    const sp_real ground[3] = { -9, -9, -1 }, wide[3] = { 40, 40, 1 }, size[3] = { 1, 1, R(0.5) };
    sp_arena all = test_arena;
    sp_scene s;
    NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
    box(&s, ground, wide, SP_FIXED);
    for (int k = 0; k < h->layers; k++)
        for (int i = 0; i < h->m - h->less * k; i++)
            for (int j = 0; j < h->n - h->less * k; j++) {
                const sp_real at[3] = { (sp_real)(i * (1 + h->gap) + k * h->x), (sp_real)(j * (1 + h->gap) + k * h->y),
                                        (sp_real)(0.5 * k) };
                if (s.count.blocks < 62) box(&s, at, size, 0);
            }
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    CHECK_INT(sp_contacts_find(&s, NULL, test_arena, &report), SP_OK);
    bounded(sp, &s, SP_FILL_PILE(s.count.blocks, s.count.joints), "pile");
    test_arena = all;
}

TEST(piles_are_bounded_within_1_3)
{
    spread sp = { { 0 }, { 0 }, 0 };
    for (int m = 2; m <= 6; m++)
        for (int n = m; n <= 7; n++)
            for (int layers = 2; layers <= 8; layers++)
                for (int less = 0; less < 2; less++) {
                    if (m * n * layers > 90 || (less && layers >= m) || (!TEST_LONG() && (m + n + layers) % 3)) continue;
                    const heap loose = { m, n, layers, less, 0.2, 0.5, 0.5 }, tight = { m, n, layers, less, 0, 0.5, 0.5 },
                               askew = { m, n, layers, less, 0.1, 0.3, 0.4 };
                    heaped(&sp, &loose);
                    heaped(&sp, &tight);
                    heaped(&sp, &askew);
                }
    tell(&sp);
    CHECK(sp.scenes >= 20);
}

/* Whatever touches what, with the full fill: no family is assumed. */
TEST(any_scene_is_bounded_with_a_full_factor)
{
    for (int k = 0; k < SOME_OF(300, 100); k++) {
        const int32_t b = test_random_int(2, 24), joints = test_random_int(1, 4 * b);
        const sp_capacity cap = { b, 0, 0, 0, joints, 20 * joints, 1 };
        const sp_strength strength = sp_strength_friction(R(0.5));
        const int flat = test_random_int(0, 1), apart = test_random_int(1, b);
        const sp_arena all = test_arena;
        sp_scene s;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        for (int32_t i = 0; i < b; i++) {
            const sp_real c[3] = { test_random_real(-1, 1), flat ? 0 : test_random_real(-1, 1), test_random_real(-1, 1) };
            CHECK_INT(sp_scene_body(&s, R(100), c, i ? 0 : SP_FIXED, NULL), SP_OK);
        }
        for (int32_t q = 0; q < joints; q++) {
            const int32_t i = test_random_int(1, b - 1), to = test_random_int(0, b - 1), n = test_random_int(1, 20);
            const sp_real normal[3] = { test_random_real(-1, 1), 0, 1 };
            const int32_t other = i != to && i % apart == to % apart ? to : 0;
            sp_real xyz[60];
            for (int c = 0; c < 60; c++) {
                xyz[c] = test_random_real(-1, 1);
                if (flat && c % 3 == 1) xyz[c] = c / 3 % 2 ? 1 : -1;        /* mirror images */
                else if (flat && c / 3 % 2) xyz[c] = xyz[c - 3];
            }
            CHECK_INT(sp_scene_points(&s, i, other, normal, n, xyz, &strength, NULL), SP_OK);
        }
        const sp_load load = { b - 1, 1, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, 0 };
        if (test_random_int(0, 1)) CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        const int32_t j = s.count.joints, v = s.count.points;
        const uint64_t fill = SP_FILL_ANY(b);
        CHECK(needed(&s, SP_FOR_CHECK) <= SP_CHECK_BYTES(b, j, v, fill) + (one_island(&s) ? 0 : SP_APART_BYTES(b, v)));
        CHECK(needed(&s, SP_FOR_SEQUENCE) <= SP_SEQUENCE_BYTES(b, j, v, fill));
#ifndef SP_NO_IPM
        CHECK(needed(&s, SP_FOR_LIMIT) <= SP_LIMIT_BYTES(b, j, v, fill));
#endif
        test_arena = all;
    }
}

TEST_LIST(sizing)
    RUN(arches_and_towers_are_bounded_within_1_3)
    RUN(walls_are_bounded_within_1_3)
    RUN(piles_are_bounded_within_1_3)
    RUN(any_scene_is_bounded_with_a_full_factor)
TEST_END
