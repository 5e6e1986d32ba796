/* Scenes: words, room, blocks; what goes in comes out right, what cannot be right does not go in. */
#include "scene.h"

/* ------------------------------------------------------------------------------------------------------------- words */

TEST(every_status_has_its_own_sentence)
{
    for (int a = -17; a <= 1; a++) {
        CHECK(strlen(sp_status_text((sp_status)a)) > 5);
        for (int b = -16; b < a && a <= 0; b++) CHECK(strcmp(sp_status_text((sp_status)a), sp_status_text((sp_status)b)) != 0);
    }
    CHECK_TEXT(sp_status_text((sp_status)-17), sp_status_text((sp_status)1));
    CHECK(strstr(sp_status_text(SP_E_MEMORY), "memory") != NULL);
    CHECK(strstr(sp_status_text(SP_E_INWARD), "inward") != NULL);
    CHECK(strstr(sp_status_text(SP_E_OPEN), "open") != NULL);
    CHECK(strstr(sp_status_text(SP_E_UNSUPPORTED), "not supported") != NULL);
}

#ifdef SP_SMALL
#define TOLD(text) ""           /* of what this build does without */
#else
#define TOLD(text) text
#endif

TEST(words_follow_their_enumerators)
{
    CHECK_TEXT(sp_verdict_text(SP_UNDECIDED), "undecided");
    CHECK_TEXT(sp_verdict_text(SP_STABLE), "stable");
    CHECK_TEXT(sp_verdict_text(SP_UNSTABLE), "unstable");
    CHECK_TEXT(sp_verdict_text((sp_verdict)3), "unknown");
    CHECK_TEXT(sp_level_text(SP_NONE), "none");
    CHECK_TEXT(sp_level_text(SP_ADMISSIBLE), "admissible");
    CHECK_TEXT(sp_level_text(SP_COUPLED), TOLD("coupled"));
    CHECK_TEXT(sp_level_text((sp_level)3), "unknown");
    CHECK_TEXT(sp_reason_text(SP_REASON_FORCES), "forces");
    CHECK_TEXT(sp_reason_text(SP_REASON_NO_SUPPORT), "no support");
    CHECK_TEXT(sp_reason_text(SP_REASON_MECHANISM), "mechanism");
    CHECK_TEXT(sp_reason_text(SP_REASON_STAGES), TOLD("stages"));
    CHECK_TEXT(sp_reason_text(SP_REASON_TENSION), TOLD("tension"));
    CHECK_TEXT(sp_reason_text(SP_REASON_UNVERIFIED), TOLD("unverified"));
    CHECK_TEXT(sp_reason_text(SP_REASON_EFFECT), TOLD("effect left out"));
    CHECK_TEXT(sp_reason_text((sp_reason)(SP_REASON_EFFECT + 1)), "unknown");
    CHECK_TEXT(sp_effect_text(SP_EFFECT_TOGETHER), "together");
    CHECK_TEXT(sp_effect_text(SP_EFFECT_DYNAMICS), "dynamics");
    CHECK_TEXT(sp_effect_text((sp_effect)SP_EFFECTS), "unknown");
    CHECK_TEXT(sp_effect_why_text(SP_WHY_CALLED), "the scene calls for it");
    CHECK_TEXT(sp_effect_why_text(SP_WHY_STAGES), TOLD("stages or a budget that a plan leaves alone"));
    CHECK_TEXT(sp_effect_why_text((sp_effect_why)(SP_WHY_FOREST + 1)), "unknown");
    CHECK_TEXT(sp_stage_text(SP_STAGE_NONE), "none");
    CHECK_TEXT(sp_stage_text(SP_STAGE_LEAST_SQUARES), TOLD("least squares"));
    CHECK_TEXT(sp_stage_text(SP_STAGE_EXACT), "exact");
    CHECK_TEXT(sp_stage_text(SP_STAGE_ADMM), TOLD("ADMM"));
    CHECK_TEXT(sp_stage_text(SP_STAGE_CUSTOM), TOLD("custom"));
    CHECK_TEXT(sp_stage_text((sp_stage_id)(SP_STAGE_CUSTOM + 1)), "unknown");
}

/* ------------------------------------------------------------------------------------------------------------ memory */

TEST(a_scene_takes_exactly_what_it_says)
{
    const sp_capacity caps[5] = { { 1, 0, 0, 0, 0, 0, 0 }, { 2, 16, 12, 48, 1, 4, 0 }, { 7, 3, 5, 1, 9, 11, 3 }, { 0, 0, 0, 0, 0, 1, 0 },
                                  { 0, 0, 0, 0, 0, 0, 1 } };
    for (int k = 0; k < 5; k++) {
        const size_t bytes = sp_scene_memory(&caps[k]);
        sp_arena a = test_arena, was;
        sp_scene scene, before;
        a.capacity = bytes;
        CHECK_INT(sp_scene_create(&scene, &caps[k], &a), SP_OK);
        CHECK_INT(a.used, bytes);
        memset(&scene, 0x5a, sizeof scene);
        before = scene;
        a = test_arena;
        a.capacity = bytes - 1;
        was = a;
        CHECK_INT(sp_scene_create(&scene, &caps[k], &a), SP_E_MEMORY);
        CHECK(memcmp(&a, &was, sizeof a) == 0);
        CHECK(memcmp(&scene, &before, sizeof scene) == 0);
    }
}

TEST(negative_or_missing_capacity_is_refused)
{
    const sp_capacity good = { 1, 1, 1, 1, 1, 1, 1 };
    sp_scene scene;
    for (int k = 0; k < 7; k++) {
        int32_t n[7] = { 1, 1, 1, 1, 1, 1, 1 };
        sp_capacity cap;
        n[k] = -1;
        memcpy(&cap, n, sizeof cap);
        CHECK_INT(sp_scene_memory(&cap), 0);
        CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_E_ARGUMENT);
    }
    sp_arena none = { NULL, 100, 0, 0 };
    CHECK_INT(sp_scene_memory(NULL), 0);
    CHECK_INT(sp_scene_create(NULL, &good, &test_arena), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_create(&scene, NULL, &test_arena), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_create(&scene, &good, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_create(&scene, &good, &none), SP_E_ARGUMENT);
    CHECK_INT(test_arena.used, 0);
}

TEST(a_new_scene_is_empty_and_heavy)
{
    const sp_scene scene = roomy();
    const sp_capacity none = { 0, 0, 0, 0, 0, 0, 0 };
    CHECK(memcmp(&scene.count, &none, sizeof none) == 0);
    CHECK_NEAR(scene.gravity[2], -9.80665, 2 * U);
    CHECK_WITHIN(scene.gravity[0], 0, 0);
    CHECK_WITHIN(scene.gravity[1], 0, 0);
    CHECK_INT(scene.capacity.corners, 256);
}

/* ----------------------------------------------------------------------------------------------------------------- blocks */

TEST(a_block_is_stored_as_given)
{
    sp_real xyz[24];
    int32_t id = -1;
    sp_scene scene = roomy();
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2), SP_FIXED, NULL), SP_OK);
    mesh = box(xyz, 0, 0, 1, 2, 3, 4);
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 5u, &id), SP_OK);
    CHECK_INT(id, 1);
    const sp_block *b = &scene.block[1];
    CHECK_NEAR(b->mass, 2400 * 24, 8 * U);
    CHECK_NEAR(b->volume, 24, 8 * U);
    CHECK_NEAR(b->density, 2400, 0);
    CHECK_NEAR(b->diameter, sqrt(29), 4 * U);
    CHECK_NEAR(b->centroid[0], 1, 8 * U);
    CHECK_NEAR(b->centroid[1], 1.5, 8 * U);
    CHECK_NEAR(b->centroid[2], 3, 8 * U);
    CHECK_INT(b->fixed, 5);
    CHECK_INT(b->vertex, 8);
    CHECK_INT(b->vertices, 8);
    CHECK_INT(b->face, 6);
    CHECK_INT(b->faces, 6);
    CHECK_INT(scene.count.blocks, 2);
    CHECK_INT(scene.count.vertices, 16);
    CHECK_INT(scene.count.faces, 12);
    CHECK_INT(scene.count.corners, 48);
    CHECK_NEAR(scene.block[0].mass, 2, 8 * U);
    CHECK(memcmp(scene.vertex + 8, xyz, sizeof xyz) == 0);
    for (int f = 0; f < 6; f++) {
        CHECK_INT(scene.face[6 + f].corner, 24 + 4 * f);
        CHECK_INT(scene.face[6 + f].corners, 4);
        for (int k = 0; k < 4; k++) CHECK_INT(scene.corner[24 + 4 * f + k], 8 + box_corner[4 * f + k]);
    }
}

TEST(bad_blocks_leave_the_scene_alone)
{
    const sp_real inf = (sp_real)HUGE_VAL, nan_ = (sp_real)NAN;
    sp_scene scene = two_cubes();
    sp_real xyz[24], flat_xyz[24];
    int32_t id;
    const sp_mesh good = box(xyz, 0, 0, 2, 1, 1, 1), flat = box(flat_xyz, 0, 0, 2, 1, 1, 0);
    sp_mesh mesh = good;
    REFUSED(sp_scene_block(NULL, &good, R(1), 0, &id), SP_E_ARGUMENT);
    REFUSED(sp_scene_block(&scene, NULL, R(1), 0, &id), SP_E_ARGUMENT);
    REFUSED(sp_scene_block(&scene, &good, R(0), 0, &id), SP_E_RANGE);
    REFUSED(sp_scene_block(&scene, &good, R(-1), SP_FIXED, &id), SP_E_RANGE);
    REFUSED(sp_scene_block(&scene, &good, inf, 0, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_block(&scene, &good, nan_, 0, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_block(&scene, &good, R(1), SP_FIXED + 1, &id), SP_E_RANGE);
    REFUSED(sp_scene_block(&scene, &flat, R(1), 0, &id), SP_E_DEGENERATE);
    REFUSED(sp_scene_block(&scene, &flat, R(1), 62u, &id), SP_E_DEGENERATE);    /* one direction free: a free block */
    mesh.faces = 5;
    REFUSED(sp_scene_block(&scene, &mesh, R(1), 0, &id), SP_E_OPEN);
    REFUSED(sp_scene_block(&scene, &mesh, R(1), 7u, &id), SP_E_OPEN);
    mesh = good;
    mesh.vertices = 3;
    REFUSED(sp_scene_block(&scene, &mesh, R(1), 0, &id), SP_E_INDEX);
    REFUSED(sp_scene_block(&scene, &mesh, R(1), SP_FIXED, &id), SP_E_INDEX);
    xyz[4] = nan_;
    REFUSED(sp_scene_block(&scene, &good, R(1), 0, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_block(&scene, &good, R(1), SP_FIXED, &id), SP_E_NOT_FINITE);
    box(xyz, 0, 0, 0, 1e3, 1e3, 1e3);
    REFUSED(sp_scene_block(&scene, &good, TOL(1e300, 1e30f), 0, &id), SP_E_NOT_FINITE);      /* mass 1e309, 1e39 */
}

TEST(a_full_scene_refuses_each_kind)
{
    sp_real xyz[24];
    const sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    for (int q = 0; q < 10; q++) {                      /* the first block, the second */
        const int k = q / 2, one = q % 2;
        int32_t n[7] = { 1 + one, 8 + 8 * one, 6 + 6 * one, 24 + 24 * one, 0, 0, 0 }, id;
        sp_capacity cap;
        sp_scene scene;
        if (k < 4) n[k]--;
        memcpy(&cap, n, sizeof cap);
        CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
        if (one) CHECK_INT(sp_scene_block(&scene, &mesh, R(1), 0, &id), SP_OK);
        if (k < 4) REFUSED(sp_scene_block(&scene, &mesh, R(1), 0, &id), SP_E_CAPACITY);
        else CHECK_INT(sp_scene_block(&scene, &mesh, R(1), 0, &id), SP_OK);
    }
    const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 0 };
    const sp_real c[3] = { 0, 0, 0 };
    sp_scene scene;
    int32_t id;
    CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&scene, R(1), c, 0, &id), SP_OK);
    REFUSED(sp_scene_body(&scene, R(1), c, 0, &id), SP_E_CAPACITY);
}

/* Open, flat, inward, or not even faces: a support is where its vertices are, without mass. */
TEST(supports_need_not_be_solid)
{
    sp_real xyz[24];
    int32_t corner[24];
    sp_scene scene = roomy();
    sp_mesh solid = box(xyz, 1, 2, 3, 1, 1, 1), open = solid, inward = solid, bare = solid;
    for (int k = 0; k < 24; k++) corner[k] = box_corner[23 - k];
    open.faces = 5;
    inward.corner = corner;
    bare.faces = 0; bare.size = bare.corner = NULL;
    CHECK_INT(sp_scene_block(&scene, &open, R(10), SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_block(&scene, &inward, R(10), SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_block(&scene, &bare, R(10), SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_block(&scene, &solid, R(10), SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 4; k++) {
        const sp_block *b = &scene.block[k];
        CHECK_NEAR(b->mass, k == 3 ? R(10) : R(0), 8 * U);
        CHECK_NEAR(b->volume, k == 3 ? R(1) : R(0), 8 * U);
        CHECK_NEAR(b->diameter, sqrt(3), 4 * U);
        for (int c = 0; c < 3; c++) CHECK_NEAR(b->centroid[c], 1.5 + c, 8 * U);
    }
    sp_mesh flat = box(xyz, 0, 0, 0, 10, 10, 0);
    CHECK_INT(sp_scene_block(&scene, &flat, R(10), SP_FIXED, NULL), SP_OK);
    CHECK_NEAR(scene.block[4].centroid[0], 5, 8 * U);
    CHECK_NEAR(scene.block[4].mass, 0, 0);
    int32_t id;
    sp_mesh none = bare;
    none.vertices = 0;
    REFUSED(sp_scene_block(&scene, &none, R(10), SP_FIXED, &id), SP_E_DEGENERATE);
    const int32_t two[1] = { 2 };
    open.faces = 1; open.size = two;
    REFUSED(sp_scene_block(&scene, &open, R(10), SP_FIXED, &id), SP_E_DEGENERATE);
}

TEST(bodies_have_mass_and_centroid_only)
{
    const sp_real c[3] = { 1, 2, 3 }, bad[3] = { 1, (sp_real)NAN, 3 };
    sp_scene scene = roomy();
    int32_t id;
    CHECK_INT(sp_scene_body(&scene, R(7), c, 0, &id), SP_OK);
    CHECK_INT(id, 0);
    CHECK_INT(sp_scene_body(&scene, R(0), c, SP_FIXED, NULL), SP_OK);
    CHECK_NEAR(scene.block[0].mass, 7, 0);
    CHECK_NEAR(scene.block[0].centroid[2], 3, 0);
    CHECK_NEAR(scene.block[0].density, 0, 0);
    CHECK_INT(scene.block[1].fixed, SP_FIXED);
    CHECK_INT(scene.block[1].vertices + scene.block[1].faces, 0);
    REFUSED(sp_scene_body(&scene, R(0), c, 0, &id), SP_E_RANGE);
    REFUSED(sp_scene_body(&scene, R(0), c, 31u, &id), SP_E_RANGE);
    REFUSED(sp_scene_body(&scene, R(-1), c, SP_FIXED, &id), SP_E_RANGE);
    REFUSED(sp_scene_body(&scene, R(1), c, 64u, &id), SP_E_RANGE);
    REFUSED(sp_scene_body(&scene, (sp_real)HUGE_VAL, c, 0, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_body(&scene, R(1), bad, 0, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_body(&scene, R(1), NULL, 0, &id), SP_E_ARGUMENT);
    REFUSED(sp_scene_body(NULL, R(1), c, 0, &id), SP_E_ARGUMENT);
}

/* A planner tries a stone and takes it out again. */
TEST(counts_set_back_take_out_what_was_added_last)
{
    sp_scene scene = roomy();
    sp_real xyz[24];
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    sp_contact_report report = { 0 };
    sp_result r;
    NEED(sp_scene_block(&scene, &mesh, R(2400), SP_FIXED, NULL) == SP_OK);
    mesh = box(xyz, 0.2, 0, 1, 1, 1, 1);
    NEED(sp_scene_block(&scene, &mesh, R(2400), 0, NULL) == SP_OK);
    NEED(sp_contacts_find(&scene, NULL, test_arena, &report) == SP_OK);
    const sp_capacity before = scene.count;
    for (int k = 0; k < 20; k++) {                      /* more often than there is room for: nothing is left behind */
        mesh = box(xyz, k % 2 ? 0.9 : 0.3, 0, 2, 1, 1, 1);
        NEED(sp_scene_block(&scene, &mesh, R(2400), 0, NULL) == SP_OK);
        scene.count.joints = scene.count.points = 0;
        NEED(sp_contacts_find(&scene, NULL, test_arena, &report) == SP_OK);
        CHECK_INT(report.joints, 2);
        sp_arena arena = test_arena;
        NEED(sp_check(&scene, NULL, &arena, &r) == SP_OK);
        CHECK_INT(r.verdict, k % 2 ? SP_UNSTABLE : SP_STABLE);
        scene.count = before;
        arena = test_arena;
        NEED(sp_check(&scene, NULL, &arena, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);
    }
}

TEST_LIST(scene)
    RUN(every_status_has_its_own_sentence)
    RUN(words_follow_their_enumerators)
    RUN(a_scene_takes_exactly_what_it_says)
    RUN(negative_or_missing_capacity_is_refused)
    RUN(a_new_scene_is_empty_and_heavy)
    RUN(a_block_is_stored_as_given)
    RUN(bad_blocks_leave_the_scene_alone)
    RUN(a_full_scene_refuses_each_kind)
    RUN(supports_need_not_be_solid)
    RUN(bodies_have_mass_and_centroid_only)
    RUN(counts_set_back_take_out_what_was_added_last)
TEST_END
