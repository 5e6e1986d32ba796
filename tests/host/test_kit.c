/* The kit for tests of others: scenes by family and distance from their limit, parts, the smallest part, bytes and back, files. */
#include "../test.h"
#include "../../port/fuzz/bytes.c"
#include "../../port/fuzz/families.c"
#include "../../port/fuzz/shrink.c"
#include "../../port/fuzz/write.c"
#include "../../port/host/files/scene.h"

#include <stdlib.h>

static sp_verdict verdict_of(const sp_scene *s, sp_arena a)
{
    sp_result r;
    if (!CHECK_INT(sp_check(s, NULL, &a, &r), SP_OK)) return SP_UNDECIDED;
    return r.verdict;
}

/* ------------------------------------------------------------------------------------------------------------- families */

TEST(a_seed_makes_its_scene_again)
{
    for (int family = 0; family < SP_FUZZ_FAMILIES; family++)
        for (uint64_t seed = 0; seed < 20; seed++) {
            const sp_arena mark = test_arena;
            sp_scene a, b;
            NEED(sp_scene_of_family((sp_fuzz_family)family, seed, &test_arena, &a) == SP_OK);
            CHECK(test_arena.used - mark.used <= 256 * 1024);
            NEED(sp_scene_of_family((sp_fuzz_family)family, seed, &test_arena, &b) == SP_OK);
            CHECK(!memcmp(a.vertex, b.vertex, (size_t)a.count.vertices * sizeof *a.vertex));
            CHECK(!memcmp(a.body, b.body, sizeof a.body));
            CHECK_INT(a.count.joints, b.count.joints);
            CHECK(a.count.blocks >= 2 && a.count.joints >= a.count.blocks - 1);
            test_arena = mark;
        }
    sp_scene s;
    const sp_arena mark = test_arena;
    CHECK_INT(sp_scene_of_family(SP_FUZZ_FAMILIES, 1, &test_arena, &s), SP_E_ARGUMENT);
    CHECK(test_arena.used == mark.used);
}

TEST(a_distance_is_on_its_side_of_the_limit)
{
    int asked[SP_FUZZ_FAMILIES] = { 0 };
    for (int family = 0; family < SP_FUZZ_FAMILIES; family++)
        for (uint64_t seed = 100; seed < 100 + SOME_OF(200, 20); seed++) {
            const double some[4] = { 0.1, -0.1, TOL(1e-4, 0.02), TOL(-1e-4, -0.02) };
            const sp_arena mark = test_arena;
            const double distance = some[seed % 4];
            sp_scene s;
            NEED(sp_scene_of_family((sp_fuzz_family)family, seed, &test_arena, &s) == SP_OK);
            const sp_status status = sp_scene_at(&s, R(distance), test_arena);
            if (status == SP_E_UNSUPPORTED) CHECK_WITHIN(s.live, 0, 0);
            else if (CHECK_INT(status, SP_OK)) {
                asked[family]++;
                const sp_verdict got = verdict_of(&s, test_arena);
                if (sizeof(sp_real) == 8 || got != SP_UNDECIDED) CHECK_INT(got, distance > 0 ? SP_STABLE : SP_UNSTABLE);
            }
            test_arena = mark;
        }
    for (int family = 0; family < SP_FUZZ_FAMILIES; family++) CHECK(asked[family] >= 8);     /* most have a limit */
}

/* --------------------------------------------------------------------------------------------------------------- parts */

/* A wall that falls keeps falling as little as two stones: shoved beyond their friction. */
static int falls(void *user, const sp_scene *s)
{
    ++*(int *)user;
    return s->count.blocks > 1 && verdict_of(s, test_arena) == SP_UNSTABLE;
}

TEST(what_is_left_still_falls_and_nothing_more_can_go)
{
    for (uint64_t seed = 0; seed < 12; seed++) {
        const sp_arena mark = test_arena;
        sp_scene s, small, less;
        int asked = 0;
        NEED(sp_scene_of_family(SP_FUZZ_WALL, seed, &test_arena, &s) == SP_OK);
        s.live = 1;
        NEED(verdict_of(&s, test_arena) == SP_UNSTABLE);
        sp_arena marks = test_arena;
        test_arena.used += 4096;
        test_arena.used -= test_arena.used % SP_ALIGN;
        marks.capacity = test_arena.used;
        NEED(sp_scene_shrink(&s, falls, &asked, &test_arena, marks, &small) == SP_OK);
        CHECK(falls(&asked, &small));
        CHECK_INT(small.count.blocks, 2);
        for (int32_t b = 0; b < small.count.blocks; b++) {
            uint8_t all[2] = { 1, 1 };
            const sp_arena here = test_arena;
            all[b] = 0;
            NEED(sp_scene_part(&small, all, NULL, NULL, &test_arena, &less) == SP_OK);
            CHECK(!falls(&asked, &less));
            test_arena = here;
        }
        test_arena = mark;
    }
}

static int never(void *user, const sp_scene *s) { (void)user; (void)s; return 0; }

TEST(what_does_not_show_is_no_start)
{
    const sp_arena mark = test_arena;
    sp_scene s, small;
    NEED(sp_scene_of_family(SP_FUZZ_ARCH, 3, &test_arena, &s) == SP_OK);
    sp_arena marks = test_arena, none = test_arena;
    test_arena.used += 4096;
    const size_t used = test_arena.used;
    CHECK_INT(sp_scene_shrink(&s, never, NULL, &test_arena, marks, &small), SP_E_ARGUMENT);
    CHECK(test_arena.used == used);
    none.capacity = none.used + (size_t)s.count.blocks;
    CHECK_INT(sp_scene_shrink(&s, never, NULL, &test_arena, none, &small), SP_E_MEMORY);
    test_arena = mark;
}

/* The whole of a scene as a part is the scene: the same verdict by the same forces. */
TEST(a_part_is_the_scene_to_the_bit)
{
    for (int family = 0; family < SP_FUZZ_FAMILIES; family++) {
        const sp_arena mark = test_arena;
        sp_scene s, all;
        sp_result a, b;
        NEED(sp_scene_of_family((sp_fuzz_family)family, 7, &test_arena, &s) == SP_OK);
        NEED(sp_scene_part(&s, NULL, NULL, NULL, &test_arena, &all) == SP_OK);
        NEED(sp_check(&s, NULL, &test_arena, &a) == SP_OK && sp_check(&all, NULL, &test_arena, &b) == SP_OK);
        CHECK_INT(a.verdict, b.verdict);
        CHECK(!memcmp(a.f, b.f, 3 * (size_t)s.count.points * sizeof *a.f));
        test_arena = mark;
    }
}

/* --------------------------------------------------------------------------------------------------------------- bytes */

static int same_blocks(const sp_scene *a, const sp_scene *b)
{
    if (a->count.blocks != b->count.blocks || a->count.loads != b->count.loads || a->count.joints != b->count.joints) return 0;
    for (int32_t k = 0; k < a->count.blocks; k++)
        if (memcmp(&a->block[k], &b->block[k], sizeof *a->block)) return 0;
    for (int32_t k = 0; k < a->count.loads; k++)
        if (memcmp(a->load[k].force, b->load[k].force, sizeof a->load->force) || a->load[k].block != b->load[k].block ||
            memcmp(a->load[k].point, b->load[k].point, sizeof a->load->point)) return 0;
    return !memcmp(a->vertex, b->vertex, (size_t)a->count.vertices * sizeof *a->vertex) &&
           !memcmp(a->point, b->point, (size_t)a->count.points * sizeof *a->point) &&
           !memcmp(a->gravity, b->gravity, sizeof a->gravity);
}

TEST(bytes_and_back_are_the_same_scene)
{
    for (int round = 0; round < SOME_OF(2000, 200); round++) {
        const sp_arena mark = test_arena;
        uint8_t in[160], out[SP_FUZZ_BYTES];
        sp_scene a, b;
        for (int k = 0; k < 160; k++) in[k] = (uint8_t)test_random_int(0, 255);
        if (sp_scene_from_bytes(in, (size_t)test_random_int(0, 160), &test_arena, &a) == SP_OK) {
            const size_t n = sp_scene_to_bytes(&a, out, sizeof out);
            CHECK(n > 0);
            NEED(sp_scene_from_bytes(out, n, &test_arena, &b) == SP_OK);
            CHECK(same_blocks(&a, &b));
            CHECK_INT(sp_scene_to_bytes(&a, out, sizeof out - 1), 0);
        }
        test_arena = mark;
    }
}

TEST(what_bytes_cannot_say_has_none)
{
    const sp_arena mark = test_arena;
    uint8_t out[SP_FUZZ_BYTES] = { 0 };
    sp_scene s;
    NEED(sp_scene_from_bytes(out, 0, &test_arena, &s) == SP_OK);
    CHECK(sp_scene_to_bytes(&s, out, sizeof out) > 0);
    s.live = 2;
    CHECK_INT(sp_scene_to_bytes(&s, out, sizeof out), 0);
    s.live = 1;
    s.block[1].density = 2401;
    CHECK_INT(sp_scene_to_bytes(&s, out, sizeof out), 0);
    s.block[1].density = 2400;
    s.gravity[0] = R(0.05);
    CHECK_INT(sp_scene_to_bytes(&s, out, sizeof out), 0);
    test_arena = mark;
    NEED(sp_scene_of_family(SP_FUZZ_ARCH, 1, &test_arena, &s) == SP_OK);
    CHECK_INT(sp_scene_to_bytes(&s, out, sizeof out), 0);
    test_arena = mark;
}

/* -------------------------------------------------------------------------------------------------------------- files */

/* The scene that the program reads of what sp_scene_write wrote.     returns 1: it is one */
static int read_again(const sp_scene *s, host_scene *back)
{
    static failure error;
    scene_settings set = scene_settings_default();
    FILE *f = tmpfile();
    if (!f || sp_scene_write(s, f) != SP_OK) return 0;
    const size_t n = (size_t)ftell(f);
    char *text = calloc(n + 1, 1);
    rewind(f);
    const int whole = text && fread(text, 1, n, f) == n;
    fclose(f);
    set.contacts = SCENE_GIVEN;
    if (whole && scene_parse("t.obj", text, n, &set, back, &error) == 0) return 1;
    printf("%s\n", error.line);
    scene_free(back);
    return 0;
}

TEST(what_is_written_the_program_decides_alike)
{
    for (int round = 0; round < SOME_OF(400, 60); round++) {
        const sp_arena mark = test_arena;
        uint8_t in[160];
        sp_scene s;
        host_scene back;
        for (int k = 0; k < 160; k++) in[k] = (uint8_t)test_random_int(0, 255);
        const int family = round % (SP_FUZZ_FAMILIES + 1);
        NEED((family < SP_FUZZ_FAMILIES ? sp_scene_of_family((sp_fuzz_family)family, (uint64_t)round, &test_arena, &s)
            : sp_scene_from_bytes(in, 160, &test_arena, &s)) == SP_OK);
        if (family < SP_FUZZ_FAMILIES) sp_scene_at(&s, R(round % 2 ? 0.1 : -0.1), test_arena);
        NEED(read_again(&s, &back));
        CHECK_INT(back.scene.count.joints, s.count.joints);
        CHECK(s.live > 0 || same_blocks(&s, &back.scene));
        const sp_verdict here = verdict_of(&s, test_arena), there = verdict_of(&back.scene, test_arena);
        if (family < SP_FUZZ_FAMILIES && sizeof(sp_real) == 8) CHECK_INT(there, here);
        else CHECK(here + there != SP_STABLE + SP_UNSTABLE || here == there);
        scene_free(&back);
        test_arena = mark;
    }
}

TEST(a_free_block_without_a_mesh_is_not_written)
{
    const sp_real at[3] = { 0, 0, 1 };
    const sp_capacity room = { 1, 0, 0, 0, 0, 0, 0 };
    sp_scene s;
    FILE *f = tmpfile();
    NEED(f && sp_scene_create(&s, &room, &test_arena) == SP_OK && sp_scene_body(&s, 10, at, 0, NULL) == SP_OK);
    CHECK_INT(sp_scene_write(&s, f), SP_E_UNSUPPORTED);
    CHECK_INT(ftell(f), 0);
    fclose(f);
}

TEST_LIST(kit)
    RUN(a_seed_makes_its_scene_again)
    RUN(a_distance_is_on_its_side_of_the_limit)
    RUN(what_is_left_still_falls_and_nothing_more_can_go)
    RUN(what_does_not_show_is_no_start)
    RUN(a_part_is_the_scene_to_the_bit)
    RUN(bytes_and_back_are_the_same_scene)
    RUN(what_bytes_cannot_say_has_none)
    RUN(what_is_written_the_program_decides_alike)
    RUN(a_free_block_without_a_mesh_is_not_written)
TEST_END
