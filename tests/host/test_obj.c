/* Scene files: what is read, what is written, what is refused and where. Host only. */
#include "../test.h"
#include "../../port/host/files/json_in.h"
#include "../../port/host/files/json_out.h"
#include "../../port/host/files/obj.h"
#include "../../port/host/files/obj_write.h"
#include "../../port/host/files/scene.h"
#include "../../port/host/files/suspects.h"
#include "../../port/host/files/text.h"

#include <stdlib.h>
#include <string.h>

#define GROUND "o ground\n#@ fixed\nv 0 0 -1\nv 1 0 -1\nv 1 1 -1\nv 0 1 -1\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" \
               "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
#define STONE  "o stone\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n" \
               "f -5 -6 -7 -8\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 -1\n"
#define JOINT  "#@ interface ground stone 0 0 0 1 0 0 1 1 0 0 1 0\n"

static failure error;

static int parse(const char *text, sp_real mu, scene_contacts contacts, host_scene *s)
{
    const size_t n = strlen(text);
    char *copy = malloc(n + 1);
    scene_settings set = scene_settings_default();
    if (!copy) return EXIT_MEMORY;
    set.mu = mu;
    set.contacts = contacts;
    memcpy(copy, text, n + 1);
    error.line[0] = 0;
    return scene_parse("t.obj", copy, n, &set, s, &error);
}

/* A text must be refused with this message. */
static void refuse(const char *text, const char *message)
{
    host_scene s;
    CHECK_INT(parse(text, -1, SCENE_GIVEN, &s), EXIT_SCENE);
    CHECK_TEXT(error.line, message);
    scene_free(&s);
}

/* What obj_write writes, malloc's. */
static char *written(const host_scene *s)
{
    FILE *f = tmpfile();
    char *text = NULL;
    if (!f || obj_write(f, &s->scene, s->name, "t.obj", &error) != 0) return NULL;
    const long n = ftell(f);
    rewind(f);
    text = calloc((size_t)n + 1, 1);
    if (text && fread(text, 1, (size_t)n, f) != (size_t)n) text[0] = 0;
    fclose(f);
    return text;
}

/* What remarks_json writes of r, malloc's. */
static char *told(const remarks *r)
{
    FILE *f = tmpfile();
    char *text = calloc(1024, 1);
    json_out j = { f, 0 };
    if (!f || !text) return text;
    remarks_json(&j, r);
    rewind(f);
    text[fread(text, 1, 1023, f)] = 0;
    fclose(f);
    return text;
}

TEST(a_remark_is_told_once)
{
    remarks r = { 0, 0, NULL };
    for (int k = 0; k < 20; k++) remarks_add(&r, k % 2 ? "--try it" : NULL, "number %d", k / 2 % 2);
    CHECK_INT(r.count, 2);
    char *text = told(&r);
    CHECK_TEXT(text, "\"remarks\": [{\"text\": \"number 0\", \"option\": null}, {\"text\": \"number 1\", \"option\": null}]");
    free(text);
    for (int k = 0; k < 100; k++) remarks_add(&r, "--try it", "%d more", k);
    CHECK_INT(r.count, 102);
    CHECK_TEXT(r.each[101].option, "--try it");
    remarks_free(&r);
}

static int matches(const char *word, const char *pattern)
{
    const text_word w = { word, strlen(word) }, p = { pattern, strlen(pattern) };
    return text_matches(w, p);
}

TEST(patterns_have_stars_and_question_marks)
{
    CHECK(matches("support.001", "support*") && matches("support", "support*") && !matches("a support", "support*"));
    CHECK(matches("aXbXc", "*X*c") && matches("abab", "*ab") && !matches("aba", "*ab") && matches("", "*") && !matches("", "?"));
    CHECK(matches("b12", "b??") && !matches("b1", "b??") && matches("b1", "b1") && !matches("b1", "b") && !matches("b", "b1"));
    CHECK(matches("aaaaaaaaaaaaaaaaaaaaaaaaaaaa", "*a*a*a*a*") && !matches("aaaaaaaaaaaaaaaaaaaaaaaaaaaa", "*a*a*a*a*b"));
}

/* Gravity askew: the slab's top touches the stone's lowest corner line, and the library takes the slab as closed and outward. */
TEST(a_ground_is_level_under_any_gravity)
{
    static const char *const gravity[] = { "0 0 -9", "0 0 9", "-9 0 0", "9 0 0", "0 9 0", "1 2 3", "-1 -2 0.5", "1e-200 0 0" };
    for (int k = 0; k < 8; k++) {
        char text[1024];
        host_scene s;
        snprintf(text, sizeof text, "#@ gravity %s\n#@ supports ground\n" STONE, sizeof(sp_real) == 4 && k == 7 ? "1e-30 0 0" : gravity[k]);
        CHECK_INT(parse(text, -1, SCENE_GIVEN, &s), 0);
        CHECK_INT(s.scene.count.blocks, 2);
        CHECK(s.scene.block[1].fixed == SP_FIXED && s.scene.block[1].mass > 0);
        CHECK_INT(s.scene.count.joints, k < 5 || k == 7);
        for (int i = 0; i < s.scene.count.joints; i++) CHECK_NEAR(s.scene.joint[i].area, 1, 1e-6);
        scene_free(&s);
    }
}

TEST(a_scene_without_supports_says_so)
{
    host_scene s;
    CHECK_INT(parse(GROUND STONE, -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.remarks.count, 0);
    scene_free(&s);
    CHECK_INT(parse(STONE, -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.remarks.count, 1);
    scene_free(&s);
}

/* A joint placed by hand is believed, and its maker is told where it lies: 4 m above the stone, 5 m above the ground. */
TEST(a_joint_far_from_its_blocks_is_remarked_on)
{
    host_scene s;
    CHECK_INT(parse(GROUND STONE "#@ interface ground stone 0 0 5 1 0 5 1 1 5 0 1 5\n", -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.remarks.count, 1);
    CHECK_TEXT(s.remarks.each[0].text, "1 joint lies off the blocks told for it, that of 'ground' and 'stone': "
                                       "up to 5 m from the one, 4 m from the other");
    scene_free(&s);
    CHECK_INT(parse(GROUND STONE "#@ points ground stone 0 0 1 0 0 3\n#@ points ground stone 0 0 1 0 0 2\n" JOINT, -1, SCENE_GIVEN,
                    &s), 0);
    CHECK_INT(s.remarks.count, 1);
    CHECK_TEXT(s.remarks.each[0].text, "2 joints lie off the blocks told for them, the farthest that of 'ground' and 'stone': "
                                       "up to 3 m from the one, 2 m from the other");
    scene_free(&s);
}

/* Beside the one block only: still not between the two. A hundredth of the smaller, 0.017 m here, is a bed of mortar. */
TEST(a_joint_off_one_block_by_more_than_mortar_is_remarked_on)
{
    static const char *const height[] = { "0", "0.017", "-0.017", "0.018", "1" };
    for (int k = 0; k < 5; k++) {
        char text[1024];
        host_scene s;
        snprintf(text, sizeof text, GROUND STONE "#@ interface ground stone 0 0 %s 1 0 %s 1 1 %s 0 1 %s\n",
                 height[k], height[k], height[k], height[k]);
        CHECK_INT(parse(text, -1, SCENE_GIVEN, &s), 0);
        CHECK_INT(s.remarks.count, k > 2);
        scene_free(&s);
        CHECK_INT(parse(text, -1, SCENE_FIND, &s), 0);
        CHECK_INT(s.remarks.count, 0);
        scene_free(&s);
    }
}

/* Where a block known by its mass and centroid ends is not known. */
TEST(a_joint_of_a_block_without_geometry_is_not_remarked_on)
{
    static const sp_real middle[3] = { 0, 0, 1 }, face[12] = { 0, 0, 5, 1, 0, 5, 1, 1, 5, 0, 1, 5 };
    static const char *const name[2] = { "floor", "stone" };
    const sp_capacity room = { 2, 0, 0, 0, 1, 4, 0 };
    const sp_strength dry = sp_strength_friction((sp_real)0.5);
    const suspects_known told = { { 0, 0 }, 1, 1 };
    remarks r = { 0, 0, NULL };
    sp_scene s;
    sp_arena a;
    void *memory = malloc(sp_scene_memory(&room));

    sp_arena_init(&a, memory, sp_scene_memory(&room));
    CHECK_INT(sp_scene_create(&s, &room, &a), SP_OK);
    CHECK_INT(sp_scene_body(&s, 1, middle, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, 1, middle, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, face, &dry, NULL), SP_OK);
    suspects_find(&s, name, told, &r);
    CHECK_INT(r.count, 0);
    remarks_free(&r);
    free(memory);
}

TEST(a_scene_is_read)
{
    host_scene s;
    CHECK_INT(parse("#@ mu 0.5\n#@ density 1000\n#@ gravity 0 0 -1\n" GROUND STONE "#@ density 2000\n" JOINT "#@ mu 0.7\n", -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.scene.count.blocks, 2);
    CHECK_INT(s.scene.count.vertices, 16);
    CHECK_INT(s.scene.count.joints, 1);
    CHECK_INT(s.scene.block[0].fixed, SP_FIXED);
    CHECK_INT(s.scene.block[1].fixed, 0);
    CHECK_TEXT(s.name[1], "stone");
    CHECK_NEAR(s.scene.block[0].density, 1000, 0);
    CHECK_NEAR(s.scene.block[1].mass, 2000, 1e-6);
    CHECK_NEAR(s.scene.block[1].centroid[2], 0.5, 1e-6);
    CHECK_NEAR(s.scene.joint[0].strength.mu, (sp_real)0.7, 0);
    CHECK_NEAR(s.scene.joint[0].n[2], 1, 1e-6);
    CHECK_NEAR(s.scene.gravity[2], -1, 0);
    CHECK_INT(s.found, 0);
    scene_free(&s);
}

TEST(defaults_are_those_of_stone_on_earth)
{
    host_scene s;
    CHECK_INT(parse(GROUND STONE JOINT, -1, SCENE_GIVEN, &s), 0);
    CHECK_NEAR(s.scene.joint[0].strength.mu, (sp_real)0.84, 0);
    CHECK_NEAR(s.scene.block[1].density, 2400, 0);
    CHECK_NEAR(s.scene.gravity[2], (sp_real)-9.80665, 0);
    scene_free(&s);
}

TEST(mu_of_the_caller_overrides_every_joint)
{
    host_scene s;
    CHECK_INT(parse(GROUND STONE JOINT "#@ mu 0.7\n" JOINT, (sp_real)0.25, SCENE_GIVEN, &s), 0);
    CHECK_NEAR(s.scene.joint[0].strength.mu, 0.25, 0);
    CHECK_NEAR(s.scene.joint[1].strength.mu, 0.25, 0);
    scene_free(&s);
}

TEST(contacts_are_found_where_none_are_given)
{
    host_scene s;
    CHECK_INT(parse("#@ mu 0.3\n" GROUND STONE, -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.found, 1);
    CHECK_INT(s.scene.count.joints, 1);
    CHECK_INT(s.scene.count.points, 4);
    CHECK_NEAR(s.scene.joint[0].area, 1, 1e-6);
    CHECK_NEAR(s.scene.joint[0].strength.mu, (sp_real)0.3, 0);
    scene_free(&s);
}

#define TETRAHEDRON(start, i) start "\nf " i "3 " i "2 " i "1\nf " i "1 " i "2 " i "4\nf " i "2 " i "3 " i "4\nf " i "3 " i "1 " i "4\n"
#define CORNERS "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"

TEST(names_may_have_spaces)
{
    host_scene s;
    CHECK_INT(parse(CORNERS TETRAHEDRON("o Mesh\\\n0", ""), -1, SCENE_GIVEN, &s), 0);
    CHECK_TEXT(s.name[0], "Mesh__0");
    scene_free(&s);
    CHECK_INT(parse(CORNERS TETRAHEDRON("o Mesh 0 \t left  # of two", "") "#@ load Mesh_0___left 0 0 1 0 0 0\n", -1, SCENE_GIVEN,
                    &s), 0);
    CHECK_TEXT(s.name[0], "Mesh_0___left");
    CHECK_INT(s.scene.count.loads, 1);
    scene_free(&s);
}

/* As Maya, Rhino and SketchUp write them: a group without faces first, the same group again after a material. */
TEST(groups_are_blocks_where_no_object_is)
{
    host_scene s;
    CHECK_INT(parse("g default\n" CORNERS "g low stone\nusemtl x\n#@ fixed\n#@ density 7\nf 3 2 1\nf 1 2 4\ng low stone\n"
                    "f 2 3 4\nf 3 1 4\ns 1\n" TETRAHEDRON("g", ""), -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.scene.count.blocks, 2);
    CHECK_TEXT(s.name[0], "low_stone");
    CHECK_TEXT(s.name[1], "default");
    CHECK_INT(s.scene.block[0].fixed, SP_FIXED);
    CHECK_INT(s.scene.block[1].fixed, 0);
    scene_free(&s);
    CHECK_INT(parse("g default\n" CORNERS TETRAHEDRON("o a\ng part", ""), -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.scene.count.blocks, 1);
    CHECK_TEXT(s.name[0], "a");
    scene_free(&s);
}

TEST(lines_that_are_no_solid_are_passed_over)
{
    host_scene s;
    CHECK_INT(parse("mg 1 0.5\nvp 0.1 0.2\n" CORNERS TETRAHEDRON("o a\nlod 1\nl 1 2\np 1", ""), -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.scene.count.faces, 4);
    scene_free(&s);
}

TEST(joints_may_name_blocks_of_later_lines)
{
    host_scene s;
    CHECK_INT(parse(JOINT GROUND STONE, -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.scene.joint[0].a, 0);
    CHECK_INT(s.scene.joint[0].b, 1);
    scene_free(&s);
}

TEST(vertices_no_face_uses_are_left_out)
{
    host_scene s;
    CHECK_INT(parse("v 1e6 1e6 1e6\nv 7 7 7\n" "o lone\n#@ fixed\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 3 4 5\n", -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.scene.count.vertices, 3);
    scene_free(&s);
}

/* Written, read as t and written again: the same bytes. */
static void writes_again(const host_scene *s, host_scene *t)
{
    char *first = written(s);
    CHECK(first != NULL);
    CHECK_INT(parse(first ? first : "", -1, SCENE_GIVEN, t), 0);
    char *second = written(t);
    CHECK(first && second && strcmp(first, second) == 0);
    free(first);
    free(second);
}

/* And in between the same numbers. */
TEST(what_is_written_reads_back_the_same)
{
    static const char text[] = "#@ gravity 0.1 -1e-3 -9.7\n" GROUND STONE "#@ density 1234.5678901234567\n#@ fixed y rz\n" JOINT
                               "#@ mu 0.1\n#@ tension 5e4\n#@ cohesion 1e5\n#@ load stone 1 2 3 4 5 6\n#@ live stone 0 0 -7 0.1 0.2 0.3 couple # down\n"
                               "#@ points ground stone 0 0 2 0.333333333333333333 0.1 0\n#@ mu 0.2\n";
    host_scene s, t;
    CHECK_INT(parse(text, -1, SCENE_GIVEN, &s), 0);
    writes_again(&s, &t);
    CHECK_INT(memcmp(s.scene.vertex, t.scene.vertex, (size_t)s.scene.count.vertices * sizeof *s.scene.vertex), 0);
    CHECK_INT(memcmp(s.scene.point, t.scene.point, (size_t)s.scene.count.points * sizeof *s.scene.point), 0);
    CHECK_NEAR(t.scene.block[1].mass, s.scene.block[1].mass, 0);
    CHECK_NEAR(t.scene.joint[1].strength.mu, s.scene.joint[1].strength.mu, 0);
    CHECK_NEAR(t.scene.joint[0].strength.cohesion, 1e5, 0);
    CHECK_NEAR(t.scene.joint[0].strength.tension, 5e4, 0);
    CHECK_WITHIN(t.scene.joint[1].strength.tension, 0, 0);
    CHECK_INT(t.scene.block[1].fixed, 2 + 32);
    CHECK_INT(t.scene.count.loads, 3);                  /* the second written as a force and a couple */
    CHECK_INT(t.scene.load[1].live + t.scene.load[2].live, 2);
    CHECK_NEAR(t.scene.load[0].point[2], 6, 0);
    CHECK_NEAR(t.scene.load[1].point[2], 0.5, TOL(1e-15, 1e-6));
    CHECK_NEAR(t.scene.load[2].couple[1], 0.2, TOL(1e-15, 1e-6));
    scene_free(&s);
    scene_free(&t);
}

/* Under clang's UBSan, too: a text that was never begun is not read from its start on. */
TEST(json_that_holds_nothing_has_no_block)
{
    refuse("[]", "t.obj:1: the scene has no block");
    refuse("{\"node\": {}}", "t.obj:1: the scene has no block");
}

TEST(every_refusal_tells_line_and_block)
{
    refuse("", "t.obj:1: the scene has no block");
    refuse("o a\nv 0 0 nan\n", "t.obj:2: not a number: 'nan' in block 'a'");
    refuse("o a\nv 0 0\n", "t.obj:2: a vertex needs three numbers in block 'a'");
    refuse("o a\nv 0 0 0\nf 1 1 2\n", "t.obj:3: no such vertex: 2, there are 1; in block 'a'");
    refuse("o a\no b\r\no a", "t.obj:3: block 'a' has the name of the one in line 1");
    refuse(GROUND STONE "#@ interface ground wall 0 0 0 1 0 0 1 1 0\n", "t.obj:32: contact with block 'wall', which does not exist");
    refuse(GROUND STONE "#@ interface stone stone 0 0 0 1 0 0 1 1 0\n",
           "t.obj:32: contact 'stone' 'stone': a joint between a block and itself");
    refuse("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "t.obj:1: block 'a': the mesh is open: an edge lacks its opposite; "
           "a sheet can be a support alone, as of the ground: --fixed a");
    refuse(GROUND STONE "#@ load wall 0 0 1 0 0 0\n", "t.obj:32: load on block 'wall', which does not exist");
    refuse("#@ load a 0 0 1 0 0\n", "t.obj:1: a load needs a point, or a moment and the word 'couple'");
    refuse("#@ cohesion -1\n", "t.obj:1: must not be negative: 'cohesion'");
    refuse("#@ tension 5e4\n" GROUND STONE, "t.obj:1: contacts: tension counts up to cohesion / mu: without cohesion it is nothing");
    refuse(GROUND STONE JOINT "#@ mu 0.5\n#@ tension 5e4\n",
           "t.obj:34: contact 'ground' 'stone': tension counts up to cohesion / mu: without cohesion it is nothing");
    refuse("#@ tension 5e4\n" GROUND STONE JOINT,
           "t.obj:1: contact 'ground' 'stone': tension counts up to cohesion / mu: without cohesion it is nothing");
    refuse("#@ crushing\n", "t.obj:1: strength of a joint needs a number");
    refuse("#@ live a 0 0\n", "t.obj:1: a load needs a force of three numbers");
    refuse("#@ load a 0 0 1 0 0 0 pair\n", "t.obj:1: unexpected 'pair'");
    refuse("o a\n#@ fixed x w\n", "t.obj:2: fixed knows x y z rx ry rz, not 'w' in block 'a'");
    refuse("#@ mass a 1 0 0\n", "t.obj:1: a mass needs kilograms and a point");
    refuse("#@ mass a -1 0 0 0\n", "t.obj:1: a mass must not be negative");
    refuse("#@ mass a 1 0 0 0 dead\n", "t.obj:1: unexpected 'dead'");
    refuse("#@ pressure a 0 5\n", "t.obj:1: faces are counted from 1, not by '0'");
    refuse("#@ pressure a 1\n", "t.obj:1: a pressure needs the number of a face and pascals");
    refuse(GROUND STONE "#@ pressure stone 7 5\n", "t.obj:32: load on 'stone': it has no face 7");
    refuse("#@ pressure wall 1 5\n" GROUND, "t.obj:1: load on block 'wall', which does not exist");
}

TEST(masses_and_pressures_are_loads)
{
    host_scene s, t;
    CHECK_INT(parse(GROUND STONE JOINT "#@ mass stone 12.5 0.1 0.2 1 live # gripper\n#@ mass stone 3 0 0 1\n#@ pressure stone 2 500\n"
                    "#@ pressure stone 4 -7 live\n", -1, SCENE_GIVEN, &s), 0);
    CHECK_INT(s.scene.count.loads, 4);
    CHECK_NEAR(s.scene.load[0].mass, 12.5, 0);
    CHECK_NEAR(s.scene.load[0].point[1], (sp_real)0.2, 0);
    CHECK_INT(s.scene.load[0].live, 1);
    CHECK_INT(s.scene.load[1].live, 0);
    CHECK_NEAR(s.scene.load[2].force[2], -500, TOL(1e-9, 1e-3));        /* on the top */
    CHECK_NEAR(s.scene.load[2].point[0], 0.5, TOL(1e-12, 1e-6));
    CHECK_NEAR(s.scene.load[3].force[0], 7, TOL(1e-9, 1e-3));           /* outwards from the face at x = 1 */
    CHECK_INT(s.scene.load[3].live, 1);
    writes_again(&s, &t);
    CHECK_INT(t.scene.count.loads, 4);
    CHECK_NEAR(t.scene.load[0].mass, 12.5, 0);
    CHECK_INT(t.scene.load[0].live, 1);
    scene_free(&s);
    scene_free(&t);
}

/* A scene that is read, but of which a check says `why`: that, too, is told with its line. */
static void refuse_later(const char *format, int coupled, sp_status why, const char *message)
{
    const char *large = sizeof(sp_real) == 8 ? "1e300" : "1e38", *far = sizeof(sp_real) == 8 ? "1e200" : "1e30";
    sp_settings set = sp_settings_default();
    char text[1600];
    host_scene s;
    sp_result x;
    set.coupled.asked = coupled;
    snprintf(text, sizeof text, format, strstr(format, "points") ? far : large);
    CHECK_INT(parse(text, -1, SCENE_GIVEN, &s), 0);
    test_arena.used = 0;
    CHECK_INT(sp_check(&s.scene, &set, &test_arena, &x), why);
    CHECK_INT(scene_refused(&s, &set, why, &error), EXIT_SCENE);
    CHECK_TEXT(error.line, message);
    scene_free(&s);
}

TEST(what_a_check_refuses_is_told_with_its_line)
{
    const char *const weight = "weight of block 'stone': a number is too large to be squared";
    char line[128];
    refuse_later(GROUND STONE JOINT "#@ load stone 1 0 0 0 0 0\n#@ load stone %s 0 0 0 0 0\n#@ load stone 2 0 0 0 0 0\n", 0, SP_E_NOT_FINITE,
                 "t.obj:34: loads on 'stone': a number is too large to be squared");
    refuse_later(GROUND STONE "#@ live stone 0 0 1 0 %s 0 couple\n", 0, SP_E_NOT_FINITE,
                 "t.obj:32: loads on 'stone': a number is too large to be squared");
    snprintf(line, sizeof line, "t.obj:2: %s", weight);
    refuse_later("#@ mu 0.5\n#@ gravity 0 0 -%s\n" GROUND STONE JOINT, 0, SP_E_NOT_FINITE, line);
    snprintf(line, sizeof line, "t.obj:17: %s", weight);
    refuse_later(GROUND STONE "#@ density %s\n" JOINT, 0, SP_E_NOT_FINITE, line);
    refuse_later(GROUND STONE JOINT "#@ points ground stone 0 0 1 %s 0 0\n" JOINT, 0, SP_E_NOT_FINITE,
                 "t.obj:33: contact 'ground' 'stone': a number is too large to be squared");
#ifndef SP_NO_CRA
    refuse_later("#@ crushing 0\n" GROUND STONE JOINT JOINT "#@ mu 0.5\n#@ cohesion 400\n#@ crushing 2e6\n", 1, SP_E_UNSUPPORTED,
                 "t.obj:36: strength of joints (cohesion, tension, crushing): a coupled check knows friction alone");
    refuse_later("#@ crushing 1e6\n" GROUND STONE, 1, SP_E_UNSUPPORTED,
                 "t.obj:1: strength of joints (cohesion, tension, crushing): a coupled check knows friction alone");
#endif
}

static text_number real(const char *text, sp_real *x)
{
    const text_word w = { text, strlen(text) };
    return text_real(w, x);
}

TEST(numbers_are_strict)
{
    static const char *const no[] = { "", "+", "-", ".", "e1", "1e", "1e+", "nan", "inf", "0x1", "1.2.3", "1f", "1,5", "--1", "1d0" };
    static const char *const yes[] = { "0", "-0", "+1", "1.", ".5", "-1.25e+2", "1E-3", "00012" };
    sp_real x;
    for (size_t k = 0; k < sizeof no / sizeof *no; k++) CHECK_INT(real(no[k], &x), TEXT_NO_NUMBER);
    for (size_t k = 0; k < sizeof yes / sizeof *yes; k++) CHECK_INT(real(yes[k], &x), TEXT_NUMBER);
    CHECK_INT(real("1e999", &x), TEXT_TOO_LARGE);
    CHECK_INT(real("-1.25e+2", &x), TEXT_NUMBER);
    CHECK_NEAR(x, -125, 0);
}

TEST(the_shortest_decimal_reads_back)
{
    char text[32];
    CHECK_TEXT(text_shortest((sp_real)0.84, text), "0.84");
    for (int k = 0; k < 1000; k++) {
        const sp_real x = test_random_real(-1, 1) * (k % 2 ? (sp_real)1e-20 : (sp_real)1e9);
        sp_real y = 0;
        CHECK_INT(real(text_shortest(x, text), &y), TEXT_NUMBER);
        CHECK(!(x < y) && !(x > y));
    }
}

/* What printf prints with the fewest digits, 15 at least (of float 6), that reads back: near ties, carries, ends of exponents. */
TEST(the_shortest_decimal_is_what_printf_prints)
{
    const int most = sizeof(sp_real) == 8 ? 17 : 9, least = sizeof(sp_real) == 8 ? 15 : 6;
    for (int k = 0; k < 20000; k++) {
        char text[32], want[64];
        const double near[] = { 1, 0.1, 1e15, 1e16, 1e17, 1e-4, 1e-5, 0.5, 1e22, 99999, 1e-300, 123456789012345., 2.5, 1e300 };
        const double size = near[test_random_int(0, 13)];
        const double step[] = { 1e-16, 1e-15, 1e-14, 1e-9, 1e-7, 1e-6, 1e-3, 1 };
        sp_real x = (sp_real)(size * (1 + test_random_int(-40, 40) * step[test_random_int(0, 7)] / (k % 2 ? 1 : 4))), y = 0;
        if (k % 3 == 0) x = test_random_real(-1, 1) * (sp_real)(sizeof(sp_real) == 8 || size < 1e30 ? size : 1);
        if (!(x - x <= 0)) continue;
        for (int digits = least; digits <= most; digits++) {
            snprintf(want, sizeof want, "%.*g", digits, (double)x);
            if (real(want, &y) == TEXT_NUMBER && !(y < x) && !(y > x)) break;
        }
        CHECK_TEXT(text_shortest(x, text), want);
    }
}

/* One string through json_out and json_in; what comes out must be UTF-8. */
static void json_trip(const char *in, const char *want)
{
    FILE *f = tmpfile();
    char *text = calloc(256, 1);
    json_tree tree;
    if (!f || !text) { CHECK(0); return; }
    json_out j = { f, 0 };
    json_open(&j, NULL, '[');
    json_string(&j, NULL, in);
    json_close(&j, ']');
    const long n = ftell(f);
    rewind(f);
    CHECK(n < 256 && fread(text, 1, (size_t)n, f) == (size_t)n);
    fclose(f);
    CHECK_INT(json_parse("t.json", text, (size_t)n, &tree, &error), 0);
    CHECK_TEXT(tree.value[1].as.string, want);
    json_free(&tree);
}

TEST(json_strings_are_escaped_and_valid)
{
    json_trip("plain", "plain");
    json_trip("\"\\\t\x01\x7f/", "\"\\\t\x01\x7f/");
    json_trip("gr\xc3\xbcn \xe2\x82\xac \xf0\x9f\xa7\xb1", "gr\xc3\xbcn \xe2\x82\xac \xf0\x9f\xa7\xb1");
    json_trip("\xfc\xff", "\xc3\xbc\xc3\xbf");                          /* no UTF-8: taken as Latin-1 */
    json_trip("\xc0\xaf\xed\xa0\x80", "\xc3\x80\xc2\xaf\xc3\xad\xc2\xa0\xc2\x80");
}

static int json_status(const char *text)
{
    json_tree tree;
    char *copy = malloc(strlen(text) + 1);
    if (!copy) return EXIT_MEMORY;
    strcpy(copy, text);
    const int status = json_parse("t.json", copy, strlen(text), &tree, &error);
    json_free(&tree);
    return status;
}

TEST(json_is_read_strictly)
{
    static const char *const no[] = { "", "{", "[1,]", "{\"a\" 1}", "{a: 1}", "[01]", "[+1]", "[.5]", "[1.]", "[nan]", "[1e999]", "[1] 2",
                                      "\"\\x\"", "\"\\ud800\"", "\"\\u12\"", "\"open", "[\"a\nb\"]", "tru", "[1 2]", "'a'" };
    static const char *const yes[] = { "1", "[]", "{}", " [ -1.5e-3 , 0 ] ", "{\"a\": {\"b\": [true, false, null]}}",
                                       "\"\\ud83e\\uddf1\\n\"" };
    char deep[200];
    for (size_t k = 0; k < sizeof no / sizeof *no; k++) CHECK_INT(json_status(no[k]), EXIT_SCENE);
    for (size_t k = 0; k < sizeof yes / sizeof *yes; k++) CHECK_INT(json_status(yes[k]), 0);
    memset(deep, '[', 199);
    deep[199] = 0;
    CHECK_INT(json_status(deep), EXIT_SCENE);
}

/* The form is told in one place: each word it tells is read, and each word that is read is told. */
TEST(help_tells_the_words_that_are_read)
{
    static const char *const word[] = { "mu", "gravity", "density", "fixed", "interface", "points", "load", "live", "mass", "pressure",
                                        "cohesion", "tension", "crushing", "up", "unit", "supports", "contact_distance", "contact_angle" };
    const size_t words = sizeof word / sizeof *word;
    for (size_t k = 0; k < words; k++) {
        host_scene s;
        char line[32];
        snprintf(line, sizeof line, "#@ %s\n", word[k]);
        parse(line, -1, SCENE_GIVEN, &s);
        scene_free(&s);
        if (!CHECK(!strstr(error.line, "unknown word")) || !CHECK(strstr(obj_format, word[k]))) CHECK_TEXT("", word[k]);
    }
    for (const char *at = strstr(obj_format, "#@ "); at; at = strstr(at + 1, "#@ ")) {
        const size_t n = strcspn(at + 3, " ");
        size_t k = 0;
        while (k < words && (strlen(word[k]) != n || memcmp(word[k], at + 3, n))) k++;
        if (!CHECK(k < words)) CHECK_TEXT("", at);
    }
    refuse("#@ bogus\n", "t.obj:1: unknown word 'bogus' after '#@'");
}

TEST_LIST(obj)
    RUN(a_remark_is_told_once)
    RUN(patterns_have_stars_and_question_marks)
    RUN(a_ground_is_level_under_any_gravity)
    RUN(a_scene_without_supports_says_so)
    RUN(a_joint_far_from_its_blocks_is_remarked_on)
    RUN(a_joint_off_one_block_by_more_than_mortar_is_remarked_on)
    RUN(a_joint_of_a_block_without_geometry_is_not_remarked_on)
    RUN(a_scene_is_read)
    RUN(defaults_are_those_of_stone_on_earth)
    RUN(mu_of_the_caller_overrides_every_joint)
    RUN(contacts_are_found_where_none_are_given)
    RUN(names_may_have_spaces)
    RUN(groups_are_blocks_where_no_object_is)
    RUN(lines_that_are_no_solid_are_passed_over)
    RUN(joints_may_name_blocks_of_later_lines)
    RUN(vertices_no_face_uses_are_left_out)
    RUN(what_is_written_reads_back_the_same)
    RUN(json_that_holds_nothing_has_no_block)
    RUN(every_refusal_tells_line_and_block)
    RUN(what_a_check_refuses_is_told_with_its_line)
    RUN(masses_and_pressures_are_loads)
    RUN(numbers_are_strict)
    RUN(the_shortest_decimal_reads_back)
    RUN(the_shortest_decimal_is_what_printf_prints)
    RUN(json_strings_are_escaped_and_valid)
    RUN(json_is_read_strictly)
    RUN(help_tells_the_words_that_are_read)
TEST_END
