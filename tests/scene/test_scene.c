/* Scenes: what goes in comes out right, what cannot be right does not go in. */
#include "../test.h"
#include <string.h>
#include <math.h>

#define U ((double)SP_EPSILON)

/* A box [0,1]^3 as six quads or twelve triangles, outward. Vertex v: bits 0 1 2 of v are x y z. */
static const int32_t box_size[6] = { 4, 4, 4, 4, 4, 4 };
static const int32_t box_corner[24] = { 0, 2, 3, 1,  4, 5, 7, 6,  0, 1, 5, 4,  2, 6, 7, 3,  0, 4, 6, 2,  1, 3, 7, 5 };
static const int32_t tri_size[12] = { 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3 };
static const int32_t tri_corner[36] = { 0, 2, 3,  0, 3, 1,  4, 5, 7,  4, 7, 6,  0, 1, 5,  0, 5, 4,
                                        2, 6, 7,  2, 7, 3,  0, 4, 6,  0, 6, 2,  1, 3, 7,  1, 7, 5 };

static sp_mesh box(sp_real xyz[24], double ox, double oy, double oz, double x, double y, double z)
{
    for (int v = 0; v < 8; v++) {
        xyz[3 * v] = R(ox + (v & 1 ? x : 0));
        xyz[3 * v + 1] = R(oy + (v & 2 ? y : 0));
        xyz[3 * v + 2] = R(oz + (v & 4 ? z : 0));
    }
    const sp_mesh mesh = { 8, 6, xyz, box_size, box_corner };
    return mesh;
}

static sp_mesh triangles(const sp_mesh *quads)
{
    const sp_mesh mesh = { 8, 12, quads->xyz, tri_size, tri_corner };
    return mesh;
}

/* A random rotation, from a quaternion. */
static void rotation(double r[9])
{
    double q[4], n = 0;
    for (int k = 0; k < 4; k++) { q[k] = (double)test_random_real(-1, 1); n += q[k] * q[k]; }
    for (int k = 0; k < 4; k++) q[k] /= sqrt(n);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double m[9] = { 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                          2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                          2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y) };
    for (int k = 0; k < 9; k++) r[k] = m[k];
}

static void turn(const double r[9], sp_real *xyz, int points)
{
    for (int v = 0; v < points; v++) {
        const double x = (double)xyz[3 * v], y = (double)xyz[3 * v + 1], z = (double)xyz[3 * v + 2];
        for (int c = 0; c < 3; c++) xyz[3 * v + c] = R(r[3 * c] * x + r[3 * c + 1] * y + r[3 * c + 2] * z);
    }
}

static sp_scene roomy(void)
{
    const sp_capacity cap = { 8, 64, 64, 256, 8, 64, 0 };
    sp_scene scene;
    CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
    return scene;
}

/* Two unit cubes, 0 a support below 1. */
static sp_scene two_cubes(void)
{
    sp_real xyz[24];
    sp_scene scene = roomy();
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    CHECK_INT(sp_scene_block(&scene, &mesh, R(1), SP_FIXED, NULL), SP_OK);
    mesh = box(xyz, 0, 0, 1, 1, 1, 1);
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 0, NULL), SP_OK);
    return scene;
}

/* Sum over all bytes that belong to a scene. */
static uint64_t mix(uint64_t h, const void *p, size_t bytes)
{
    const unsigned char *c = p;
    for (size_t k = 0; k < bytes; k++) h = (h ^ c[k]) * 1099511628211u;
    return h;
}

static uint64_t content(const sp_scene *s)
{
    uint64_t h = mix(14695981039346656037u, s->gravity, sizeof s->gravity);
    h = mix(h, &s->cap, sizeof s->cap);
    h = mix(h, &s->count, sizeof s->count);
    h = mix(h, s->block, (size_t)s->count.blocks * sizeof *s->block);
    h = mix(h, s->vertex, (size_t)s->count.vertices * sizeof *s->vertex);
    h = mix(h, s->face, (size_t)s->count.faces * sizeof *s->face);
    h = mix(h, s->corner, (size_t)s->count.corners * sizeof *s->corner);
    h = mix(h, s->joint, (size_t)s->count.joints * sizeof *s->joint);
    return mix(h, s->point, (size_t)s->count.points * sizeof *s->point);
}

/* `call` gives `status` and leaves `scene` and `id` as they are. */
#define REFUSED(call, status) do { \
        const uint64_t before = content(&scene); \
        id = -77; \
        CHECK_INT(call, status); \
        CHECK(content(&scene) == before); \
        CHECK_INT(id, -77); \
    } while (0)

/* sp_mesh_mass gives `status` and leaves the mass as it is. */
static void mass_refused(const sp_mesh *mesh, sp_status status, const char *what)
{
    sp_mass m, was;
    memset(&m, 0x5a, sizeof m);
    was = m;
    const sp_status got = sp_mesh_mass(mesh, &m);
    test_check_int(got, status, __FILE__, __LINE__, what);
    test_check(memcmp(&m, &was, sizeof m) == 0, __FILE__, __LINE__, what);
}

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
    CHECK_TEXT(sp_level_text(SP_COUPLED), "coupled");
    CHECK_TEXT(sp_level_text((sp_level)3), "unknown");
    CHECK_TEXT(sp_reason_text(SP_REASON_FORCES), "forces");
    CHECK_TEXT(sp_reason_text(SP_REASON_NO_SUPPORT), "no support");
    CHECK_TEXT(sp_reason_text(SP_REASON_MECHANISM), "mechanism");
    CHECK_TEXT(sp_reason_text(SP_REASON_STAGES), "stages");
    CHECK_TEXT(sp_reason_text(SP_REASON_TENSION), "tension");
    CHECK_TEXT(sp_reason_text(SP_REASON_UNVERIFIED), "unverified");
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
        a.cap = bytes;
        CHECK_INT(sp_scene_create(&scene, &caps[k], &a), SP_OK);
        CHECK_INT(a.used, bytes);
        memset(&scene, 0x5a, sizeof scene);
        before = scene;
        a = test_arena;
        a.cap = bytes - 1;
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
    CHECK_INT(scene.cap.corners, 256);
}

/* ----------------------------------------------------------------------------------------------------- mass, closed form */

TEST(cube_volume_is_its_edge_cubed_at_any_scale)
{
    for (int e = -9; e <= 9; e++) {
        const double s = pow(10, e);
        sp_real xyz[24];
        sp_mass m;
        sp_mesh mesh = box(xyz, 0, 0, 0, s, s, s);
        const double edge = (double)xyz[3];
        for (int k = 0; k < 2; k++, mesh = triangles(&mesh)) {
            CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
            CHECK_NEAR(m.volume, edge * edge * edge, 8 * U);
            CHECK_NEAR(m.diameter, edge * sqrt(3), 4 * U);
            for (int c = 0; c < 3; c++) CHECK_NEAR(m.centroid[c], edge / 2, 8 * U);
        }
    }
}

TEST(tetrahedron_centroid_is_a_quarter)
{
    static const int32_t size[4] = { 3, 3, 3, 3 }, corner[12] = { 0, 2, 1,  0, 1, 3,  0, 3, 2,  1, 2, 3 };
    const sp_real xyz[12] = { 0, 0, 0,  3, 0, 0,  0, 2, 0,  0, 0, 5 };
    const sp_mesh mesh = { 4, 4, xyz, size, corner };
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 5, 4 * U);
    CHECK_NEAR(m.centroid[0], 0.75, 4 * U);
    CHECK_NEAR(m.centroid[1], 0.5, 4 * U);
    CHECK_NEAR(m.centroid[2], 1.25, 4 * U);
    CHECK_NEAR(m.diameter, sqrt(38), 4 * U);
}

/* Five-sided column between z = 0 and 2, leaning by 3 in x: area of the pentagon times height, centroid at half the lean. */
TEST(sheared_prism_keeps_its_volume)
{
    static const int32_t size[7] = { 5, 5, 4, 4, 4, 4, 4 };
    static const int32_t corner[30] = { 4, 3, 2, 1, 0,  5, 6, 7, 8, 9,  0, 1, 6, 5,  1, 2, 7, 6,  2, 3, 8, 7,  3, 4, 9, 8,
                                        4, 0, 5, 9 };
    const sp_real plan[5][2] = { { 0, 0 }, { 4, 0 }, { 4, 2 }, { 2, 4 }, { 0, 2 } };    /* 4 x 2 and a triangle 4 x 2 / 2 */
    sp_real xyz[30];
    for (int k = 0; k < 10; k++) {
        xyz[3 * k] = plan[k % 5][0] + (k < 5 ? R(0) : R(3));
        xyz[3 * k + 1] = plan[k % 5][1];
        xyz[3 * k + 2] = k < 5 ? R(0) : R(2);
    }
    const sp_mesh mesh = { 10, 7, xyz, size, corner };
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 24, 8 * U);
    CHECK_NEAR(m.centroid[0], 3.5, 8 * U);
    CHECK_NEAR(m.centroid[1], (8 * 1 + 4 * (2 + 2.0 / 3)) / 12, 8 * U);
    CHECK_NEAR(m.centroid[2], 1, 8 * U);
}

/* The same eighth-of-a-metre coordinates near the origin and 1e6 away give the same volume and the same place in it. */
TEST(far_from_the_origin_nothing_is_lost)
{
    const double far[3] = { 1e6, -1e6, 1048576 };
    for (int k = 0; k < 50; k++) {
        sp_real near_xyz[24], far_xyz[24];
        const double step = 0.125;                      /* exact at 1e6 in both precisions */
        for (int v = 0; v < 8; v++)
            for (int c = 0; c < 3; c++) {
                const double x = (v >> c & 1 ? 16 : 0) + test_random_int(-2, 2);
                near_xyz[3 * v + c] = R(step * x);
                far_xyz[3 * v + c] = R(step * x + far[c]);
            }
        const sp_mesh here = { 8, 12, near_xyz, tri_size, tri_corner }, there = { 8, 12, far_xyz, tri_size, tri_corner };
        sp_mass a, b;
        NEED(sp_mesh_mass(&here, &a) == SP_OK);
        NEED(sp_mesh_mass(&there, &b) == SP_OK);
        CHECK_NEAR(b.volume, a.volume, 0);
        CHECK_NEAR(b.diameter, a.diameter, 0);
        for (int c = 0; c < 3; c++) CHECK_NEAR(b.centroid[c], (double)a.centroid[c] + far[c], 2 * U);
    }
}

TEST(turning_a_block_turns_its_centroid)
{
    for (int k = 0; k < 50; k++) {
        double r[9];
        sp_real xyz[24], c0[3] = { R(2.5), R(-1.0), R(0.25) };
        sp_mesh mesh = box(xyz, 2, -2, 0, 1, 2, 0.5);
        sp_mass m;
        rotation(r);
        turn(r, xyz, 8);
        turn(r, c0, 1);
        CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
        CHECK_NEAR(m.volume, 1, 64 * U);
        for (int c = 0; c < 3; c++) CHECK_WITHIN(m.centroid[c], c0[c], 64 * U);
    }
}

TEST(a_hole_and_a_cavity_count_as_missing)
{
    static const int32_t size[12] = { 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4 };
    sp_real xyz[48];
    int32_t corner[48];
    box(xyz, 0, 0, 0, 4, 4, 4);
    box(xyz + 24, 1, 1, 1, 2, 2, 1);
    for (int k = 0; k < 24; k++) {
        corner[k] = box_corner[k];
        corner[24 + k] = 8 + box_corner[23 - k];        /* inward */
    }
    const sp_mesh mesh = { 16, 12, xyz, size, corner };
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 60, 8 * U);
    CHECK_NEAR(m.centroid[0], 2, 8 * U);
    CHECK_NEAR(m.centroid[2], (64 * 2 - 4 * 1.5) / 60, 8 * U);
}

/* ------------------------------------------------------------------------------------------------------ mass, closedness */

TEST(equal_coordinates_are_the_same_vertex)
{
    sp_real xyz[24], own[72];
    int32_t corner[24];
    box(xyz, 0, 0, 0, 1, 1, 1);
    for (int k = 0; k < 24; k++) {
        corner[k] = 23 - k;
        for (int c = 0; c < 3; c++) {
            const sp_real x = xyz[3 * box_corner[k] + c];
            own[3 * (23 - k) + c] = x < R(0.5) && k % 2 ? -R(0.0) : x;      /* also -0 for 0 */
        }
    }
    for (int k = 0; k < 24; k++) corner[k] = 4 * (k / 4) + 3 - k % 4;       /* faces were reversed with the numbering */
    const sp_mesh mesh = { 24, 6, own, box_size, corner };
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 1, 4 * U);
}

TEST(a_vertex_off_by_an_ulp_opens_the_mesh)
{
    sp_real xyz[27];
    int32_t corner[24];
    const sp_mesh mesh = { 9, 6, xyz, box_size, corner };
    box(xyz, 0, 0, 0, 1, 1, 1);
    memcpy(corner, box_corner, sizeof corner);
    memcpy(xyz + 24, xyz + 21, 3 * sizeof *xyz);
    corner[6] = 8;                                      /* vertex 7 under another number */
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    xyz[24] = R(1) + 2 * SP_EPSILON;
    mass_refused(&mesh, SP_E_OPEN, "one ulp");
}

TEST(open_meshes_are_refused)
{
    sp_real xyz[24];
    int32_t size[7] = { 4, 4, 4, 4, 4, 4, 4 }, corner[28];
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    mesh.size = size;
    mesh.corner = corner;
    memcpy(corner, box_corner, sizeof box_corner);
    mesh.faces = 5;
    mass_refused(&mesh, SP_E_OPEN, "face missing");
    mesh.faces = 7;
    memcpy(corner + 24, box_corner + 20, 4 * sizeof *corner);
    mass_refused(&mesh, SP_E_OPEN, "face twice");
    mesh.faces = 6;
    for (int k = 0; k < 4; k++) corner[20 + k] = box_corner[23 - k];
    mass_refused(&mesh, SP_E_OPEN, "face turned round");
    mesh = triangles(&mesh);
    mesh.faces = 11;
    mass_refused(&mesh, SP_E_OPEN, "triangle missing");
}

/* A fifth corner on an edge that the neighbour does not have is a gap; a triangle without area closes it, legally. */
TEST(a_face_without_area_closes_a_gap)
{
    sp_real xyz[27];
    static const int32_t size[7] = { 5, 4, 4, 4, 4, 4, 3 };
    static const int32_t corner[28] = { 0, 2, 3, 1, 8,  4, 5, 7, 6,  0, 1, 5, 4,  2, 6, 7, 3,  0, 4, 6, 2,  1, 3, 7, 5,
                                        8, 1, 0 };
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    sp_mass m;
    mesh.vertices = 9;
    mesh.size = size;
    mesh.corner = corner;
    xyz[24] = R(0.375); xyz[25] = xyz[26] = 0;
    mass_refused(&mesh, SP_E_OPEN, "corner on an edge");
    mesh.faces = 7;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 1, 4 * U);
    for (int c = 0; c < 3; c++) CHECK_NEAR(m.centroid[c], 0.5, 4 * U);
}

TEST(inward_meshes_say_so)
{
    sp_real xyz[24];
    int32_t corner[36];
    sp_mesh mesh = box(xyz, 5, 5, 5, 1, 2, 3);
    for (int k = 0; k < 24; k++) corner[k] = box_corner[23 - k];
    mesh.corner = corner;
    mass_refused(&mesh, SP_E_INWARD, "quads");
    mesh = triangles(&mesh);
    for (int k = 0; k < 36; k++) corner[k] = tri_corner[35 - k];
    mesh.corner = corner;
    mass_refused(&mesh, SP_E_INWARD, "triangles");
    for (int k = 0; k < 8; k++) xyz[3 * k] = -xyz[3 * k];      /* a mirror image of an inward mesh is outward */
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 6, 8 * U);
}

/* ------------------------------------------------------------------------------------------------------- mass, thin and flat */

TEST(needles_and_plates_have_a_volume)
{
    const double dims[3][3] = { { 1, 1e-6, 1e-6 }, { 1, 1, 1e-6 }, { 1e-6, 1, 1e-3 } };
    for (int e = -9; e <= 9; e += 3)
        for (int d = 0; d < 3; d++) {
            const double s = pow(10, e);
            sp_real xyz[24];
            sp_mass m;
            sp_mesh mesh = box(xyz, 0, 0, 0, s * dims[d][0], s * dims[d][1], s * dims[d][2]);
            const double v = (double)xyz[21] * (double)xyz[22] * (double)xyz[23];
            if (v < (double)TOL(0, 1e-36f)) continue;   /* float has no such numbers */
            CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
            CHECK_NEAR(m.volume, v, 16 * U);
            mesh = triangles(&mesh);
            CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
            CHECK_NEAR(m.volume, v, 16 * U);
        }
}

/* Turned, the coordinates themselves carry u per unit of length, 1e6 u of the thickness. */
TEST(turned_needles_and_plates_pass_too)
{
    const double dims[2][3] = { { 1, 1e-6, 1e-6 }, { 1, 1, 1e-6 } };
    for (int k = 0; k < 100; k++) {
        const double *d = dims[k % 2], s = pow(10, (double)test_random_real(-6, 6));
        double r[9];
        sp_real xyz[24];
        sp_mass m;
        sp_mesh mesh = box(xyz, 0, 0, 0, s * d[0], s * d[1], s * d[2]);
        rotation(r);
        turn(r, xyz, 8);
        if (k % 4 > 1) mesh = triangles(&mesh);
        CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
        CHECK_NEAR(m.volume, s * s * s * d[0] * d[1] * d[2], 8e6 * U);
    }
}

TEST(flat_bodies_are_degenerate_at_any_scale_and_place)
{
    const double dims[4][3] = { { 1, 1, 0 }, { 1, 1e-6, 0 }, { 1, 0, 0 }, { 0, 0, 0 } };
    for (int k = 0; k < 400; k++) {
        const double *d = dims[k % 4], s = pow(10, (double)test_random_real(-9, 9)), off = k % 3 ? 0 : s * 1e6;
        double r[9];
        sp_real xyz[24];
        sp_mesh mesh = box(xyz, 0, 0, 0, s * d[0], s * d[1], s * d[2]);
        rotation(r);
        turn(r, xyz, 8);
        for (int c = 0; c < 24; c++) xyz[c] += R(off);
        if (k % 5 > 1) mesh = triangles(&mesh);
        mass_refused(&mesh, SP_E_DEGENERATE, "flat");
    }
}

TEST(faces_may_warp_by_a_hundredth_and_no_more)
{
    const double d = sqrt(3);
    sp_real xyz[24];
    sp_mass m;
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    xyz[23] = R(1 + 4 * 0.9e-2 * d);                    /* one corner of four lifted by h: each is about h/4 off */
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
    CHECK_NEAR(m.volume, 1 + 0.9e-2 * d, 1e-3);
    xyz[23] = R(1 + 4 * 1.1e-2 * d);
    mass_refused(&mesh, SP_E_WARPED, "lifted corner");
    mesh = triangles(&mesh);                            /* triangles cannot warp */
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
}

/* -------------------------------------------------------------------------------------------------------- mass, refusals */

TEST(broken_meshes_are_refused)
{
    sp_real xyz[24];
    int32_t size[6], corner[24];
    const sp_mesh good = box(xyz, 0, 0, 0, 1, 1, 1);
    sp_mesh mesh = good;
    sp_mass m;
    CHECK_INT(sp_mesh_mass(&good, NULL), SP_E_ARGUMENT);
    mass_refused(NULL, SP_E_ARGUMENT, "no mesh");
    mesh.xyz = NULL;             mass_refused(&mesh, SP_E_ARGUMENT, "no xyz");
    mesh = good; mesh.size = NULL;    mass_refused(&mesh, SP_E_ARGUMENT, "no size");
    mesh = good; mesh.corner = NULL;  mass_refused(&mesh, SP_E_ARGUMENT, "no corner");
    mesh = good; mesh.vertices = -1;  mass_refused(&mesh, SP_E_ARGUMENT, "vertices < 0");
    mesh = good; mesh.faces = -1;     mass_refused(&mesh, SP_E_ARGUMENT, "faces < 0");
    mesh = good; mesh.faces = 0;      mass_refused(&mesh, SP_E_DEGENERATE, "no faces");
    mesh.vertices = 0;                mass_refused(&mesh, SP_E_DEGENERATE, "nothing");
    mesh = good; mesh.vertices = 7;   mass_refused(&mesh, SP_E_INDEX, "corner beyond the vertices");
    mesh = good; mesh.corner = corner; mesh.size = size;
    memcpy(corner, box_corner, sizeof corner);
    memcpy(size, box_size, sizeof size);
    corner[5] = -1;                   mass_refused(&mesh, SP_E_INDEX, "corner -1");
    corner[5] = 5; size[2] = 2;       mass_refused(&mesh, SP_E_DEGENERATE, "two corners");
    size[2] = -4;                     mass_refused(&mesh, SP_E_DEGENERATE, "negative corners");
    size[2] = INT32_MAX;              mass_refused(&mesh, SP_E_ARGUMENT, "more corners than can be counted");
    size[2] = 4;
    CHECK_INT(sp_mesh_mass(&mesh, &m), SP_OK);
}

TEST(infinities_and_overflow_are_refused)
{
    const sp_real bad[3] = { (sp_real)HUGE_VAL, -(sp_real)HUGE_VAL, (sp_real)NAN };
    const double large = (double)TOL(1e110, 1e14f), widest = (double)TOL(1.7e308, 3e38f);
    sp_real xyz[24];
    sp_mesh mesh = box(xyz, 0, 0, 0, 1, 1, 1);
    for (int k = 0; k < 24; k += 5)
        for (int b = 0; b < 3; b++) {
            const sp_real was = xyz[k];
            xyz[k] = bad[b];
            mass_refused(&mesh, SP_E_NOT_FINITE, "not a number");
            xyz[k] = was;
        }
    mesh = box(xyz, 0, 0, 0, large, large, large);
    mass_refused(&mesh, SP_E_NOT_FINITE, "cube overflows");
    mesh = box(xyz, -widest, 0, 0, 2, 1, 1);
    xyz[3] = R(widest);
    mass_refused(&mesh, SP_E_NOT_FINITE, "difference overflows");
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
    for (int k = 0; k < 5; k++) {
        int32_t n[7] = { 1, 8, 6, 24, 0, 0, 0 }, id;
        sp_capacity cap;
        sp_scene scene;
        if (k < 4) n[k]--;
        memcpy(&cap, n, sizeof cap);
        CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
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

/* ------------------------------------------------------------------------------------------------------------- joints */

static double dot(const sp_real *a, const sp_real *b)
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

/* n, t1, t2 are orthonormal and right-handed to `tol`. */
static void frame_is_right_handed(const sp_joint *f, double tol)
{
    const double det = (double)f->n[0] * ((double)f->t1[1] * (double)f->t2[2] - (double)f->t1[2] * (double)f->t2[1])
                     + (double)f->n[1] * ((double)f->t1[2] * (double)f->t2[0] - (double)f->t1[0] * (double)f->t2[2])
                     + (double)f->n[2] * ((double)f->t1[0] * (double)f->t2[1] - (double)f->t1[1] * (double)f->t2[0]);
    CHECK_NEAR(det, 1, tol);
    CHECK_NEAR(dot(f->n, f->n), 1, tol);
    CHECK_NEAR(dot(f->t1, f->t1), 1, tol);
    CHECK_NEAR(dot(f->t2, f->t2), 1, tol);
    CHECK_WITHIN(dot(f->n, f->t1), 0, tol);
    CHECK_WITHIN(dot(f->n, f->t2), 0, tol);
    CHECK_WITHIN(dot(f->t1, f->t2), 0, tol);
}

TEST(square_has_the_obvious_frame)
{
    const sp_real xyz[12] = { 0, 0, 1,  2, 0, 1,  2, 2, 1,  0, 2, 1 };
    const sp_strength strength = sp_strength_friction(R(0.5));
    sp_scene scene = two_cubes();
    int32_t id = -1;
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&scene, 1, 0, 4, xyz, &strength, &id), SP_OK);        /* repeated: legal */
    CHECK_INT(id, 1);
    const sp_joint *f = &scene.joint[0];
    const sp_real x[3] = { 1, 0, 0 }, y[3] = { 0, 1, 0 }, z[3] = { 0, 0, 1 };
    for (int c = 0; c < 3; c++) {
        CHECK_WITHIN(f->n[c], z[c], 0);
        CHECK_WITHIN(f->t1[c], x[c], 0);
        CHECK_WITHIN(f->t2[c], y[c], 0);
    }
    CHECK_NEAR(f->area, 4, 0);
    CHECK_NEAR(f->strength.mu, R(0.5), 0);
    CHECK_INT(f->a, 0);
    CHECK_INT(f->b, 1);
    CHECK_INT(scene.joint[1].point, 4);
    CHECK_INT(scene.joint[1].points, 4);
    CHECK_INT(scene.count.points, 8);
    CHECK(memcmp(scene.point + 4, xyz, sizeof xyz) == 0);
}

/* An L of area 3 in units of any size and any direction; t1 goes along its first edge. */
TEST(frames_hold_at_any_scale_and_turn)
{
    static const double plan[6][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    for (int k = 0; k < 200; k++) {
        const double s = pow(10, (double)test_random_real(-15, 15));        /* 1e-6 .. 1e6 m in units of 1e-9 .. 1e9 */
        double r[9];
        sp_real xyz[18], e[6] = { 0, 0, 1, 1, 0, 0 };
        rotation(r);
        for (int v = 0; v < 6; v++) {
            xyz[3 * v] = R(s * plan[v][0]); xyz[3 * v + 1] = R(s * plan[v][1]); xyz[3 * v + 2] = R(s * 0.5);
        }
        turn(r, xyz, 6);
        turn(r, e, 2);
        scene.count.joints = scene.count.points = 0;
        NEED(sp_scene_joint(&scene, 0, 1, 6, xyz, &strength, NULL) == SP_OK);
        const sp_joint *f = &scene.joint[0];
        frame_is_right_handed(f, 16 * U);
        CHECK_NEAR(f->area, 3 * s * s, 64 * U);
        CHECK_NEAR(dot(f->n, e), 1, 64 * U);
        CHECK_NEAR(dot(f->t1, e + 3), 1, 64 * U);
    }
}

/* Strips 1e-6 wide keep a normal good to the width's own rounding. */
TEST(strips_are_joints_and_lines_are_not)
{
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    int32_t id;
    for (int k = 0; k < 300; k++) {
        const double s = pow(10, (double)test_random_real(-9, 9));
        double r[9];
        sp_real strip[12] = { 0, 0, 0,  R(s), 0, 0,  R(s), R(s * 1e-6), 0,  0, R(s * 1e-6), 0 };
        sp_real line[12] = { 0, 0, 0,  R(s), 0, 0,  R(s * 0.7), 0, 0,  R(s * 0.3), 0, 0 };
        if (k % 2) {
            rotation(r);
            turn(r, strip, 4);
            turn(r, line, 4);
        }
        scene.count.joints = scene.count.points = 0;
        NEED(sp_scene_joint(&scene, 0, 1, 4, strip, &strength, NULL) == SP_OK);
        frame_is_right_handed(&scene.joint[0], 16 * U);
        CHECK_NEAR(scene.joint[0].area, s * s * 1e-6, k % 2 ? 8e6 * U : 8 * U);
        REFUSED(sp_scene_joint(&scene, 0, 1, 4, line, &strength, &id), SP_E_AREA);
    }
    sp_real point[12] = { 1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3 };
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, point, &strength, &id), SP_E_AREA);
    const sp_real eight[12] = { 0, 0, 0,  1, 1, 0,  1, 0, 0,  0, 1, 0 };        /* two lobes that cancel */
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, eight, &strength, &id), SP_E_AREA);
    const sp_real box_[12] = { 0, 0, 0,  1, 0, 0,  1, R(1e-3), 0,  0, R(1e-3), 0 };
    REFUSED(sp_scene_joint(&scene, 0, 1, 2, box_, &strength, &id), SP_E_AREA);
    REFUSED(sp_scene_joint(&scene, 0, 1, 0, box_, &strength, &id), SP_E_AREA);
}

/* A strip 1e-6 m wide and 1e6 m long: one part in 1e12, which float cannot tell from a line. */
TEST(very_long_strips_pass_in_double)
{
#ifndef SP_REAL_FLOAT
    const sp_real strip[12] = { 0, 0, 0,  1e6, 0, 0,  1e6, 1e-6, 0,  0, 1e-6, 0 };
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    NEED(sp_scene_joint(&scene, 0, 1, 4, strip, &strength, NULL) == SP_OK);
    CHECK_NEAR(scene.joint[0].area, 1, 8 * U);
    CHECK_NEAR(scene.joint[0].n[2], 1, 0);
#endif
}

TEST(polygons_are_plane_to_a_millionth)
{
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    int32_t id;
    sp_real xyz[12] = { 0, 0, 0,  1, 0, 0,  1, 1, 0,  0, 1, 0 };
    xyz[8] = R(4 * 0.8e-6 * sqrt(2));                   /* each corner is a quarter of it off */
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL), SP_OK);
    xyz[8] = R(4 * (double)TOL(1.2e-6, 3e-6f) * sqrt(2));
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, &id), SP_E_PLANE);
    xyz[8] = R(0.1);
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, &id), SP_E_PLANE);
}

TEST(tangent_skips_edges_without_length)
{
    const sp_strength strength = sp_strength_friction(0);
    const sp_real tiny = R(1e-10);
    const sp_real xyz[18] = { 0, 0, 0,  0, 0, 0,  tiny, 0, 0,  tiny, 1, 0,  -1, 1, 0,  -1, 0, 0 };
    sp_scene scene = two_cubes();
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 6, xyz, &strength, NULL), SP_OK);
    CHECK_NEAR(scene.joint[0].t1[1], 1, 0);         /* third edge, 1 long */
    const sp_real collinear[15] = { 0, 0, 0,  0, R(-0.5), 0,  0, -1, 0,  1, -1, 0,  1, 0, 0 };
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 5, collinear, &strength, NULL), SP_OK);
    CHECK_NEAR(scene.joint[1].t1[1], -1, 0);
    CHECK_NEAR(scene.joint[1].area, 1, 4 * U);
}

TEST(bad_joints_leave_the_scene_alone)
{
    const sp_real inf = (sp_real)HUGE_VAL, nan_ = (sp_real)NAN;
    sp_real xyz[12] = { 0, 0, 1,  1, 0, 1,  1, 1, 1,  0, 1, 1 };
    const sp_real n[3] = { 0, 0, 1 };
    const sp_strength good = sp_strength_friction(R(0.5));
    sp_scene scene = two_cubes();
    int32_t id;
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &good, &id), SP_OK);
    for (int points = 0; points < 2; points++) {
#define ADD(scene_, a, b, count, xyz_, joint_) (points ? sp_scene_points(scene_, a, b, n, count, xyz_, joint_, &id) \
                                                       : sp_scene_joint(scene_, a, b, count, xyz_, joint_, &id))
        REFUSED(ADD(NULL, 0, 1, 4, xyz, &good), SP_E_ARGUMENT);
        REFUSED(ADD(&scene, 0, 1, 4, NULL, &good), SP_E_ARGUMENT);
        REFUSED(ADD(&scene, 0, 1, 4, xyz, NULL), SP_E_ARGUMENT);
        REFUSED(ADD(&scene, 0, 1, -1, xyz, &good), SP_E_ARGUMENT);
        REFUSED(ADD(&scene, -1, 1, 4, xyz, &good), SP_E_INDEX);
        REFUSED(ADD(&scene, 0, 2, 4, xyz, &good), SP_E_INDEX);
        REFUSED(ADD(&scene, 0, INT32_MAX, 4, xyz, &good), SP_E_INDEX);
        REFUSED(ADD(&scene, 1, 1, 4, xyz, &good), SP_E_SELF);
        sp_strength j = good;
        j.mu = R(-0.1);  REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_RANGE);
        j.mu = inf;      REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_NOT_FINITE);
        j.mu = nan_;     REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_NOT_FINITE);
        j = good; j.cohesion = R(-1); REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_RANGE);
        j = good; j.tension = R(-1);  REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_RANGE);
        j = good; j.crushing = R(-1);      REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_RANGE);
        j = good; j.crushing = inf;        REFUSED(ADD(&scene, 0, 1, 4, xyz, &j), SP_E_NOT_FINITE);
        xyz[7] = nan_;   REFUSED(ADD(&scene, 0, 1, 4, xyz, &good), SP_E_NOT_FINITE);
        xyz[7] = -inf;   REFUSED(ADD(&scene, 0, 1, 4, xyz, &good), SP_E_NOT_FINITE);
        xyz[7] = 1;
#undef ADD
    }
    const sp_real huge = TOL(1e200, 1e25f), wide = TOL(1.7e308, 3e38f);
    const sp_real big[9] = { 0, 0, 0, huge, 0, 0, 0, huge, 0 }, wider[9] = { -wide, 0, 0, wide, 0, 0, 0, 1, 0 };
    REFUSED(sp_scene_joint(&scene, 0, 1, 3, big, &good, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_joint(&scene, 0, 1, 3, wider, &good, &id), SP_E_NOT_FINITE);
}

TEST(joints_and_points_stop_at_the_capacity)
{
    const sp_capacity cap = { 2, 0, 0, 0, 2, 5, 0 };
    const sp_real c[3] = { 0, 0, 0 }, n[3] = { 0, 0, 1 }, xyz[12] = { 0, 0, 1,  1, 0, 1,  1, 1, 1,  0, 1, 1 };
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene;
    int32_t id;
    NEED(sp_scene_create(&scene, &cap, &test_arena) == SP_OK);
    CHECK_INT(sp_scene_body(&scene, R(1), c, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&scene, R(1), c, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL), SP_OK);
    REFUSED(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, &id), SP_E_CAPACITY);
    REFUSED(sp_scene_points(&scene, 0, 1, n, 2, xyz, &strength, &id), SP_E_CAPACITY);
    CHECK_INT(sp_scene_points(&scene, 0, 1, n, 1, xyz, &strength, &id), SP_OK);
    CHECK_INT(id, 1);
    REFUSED(sp_scene_points(&scene, 0, 1, n, 1, xyz, &strength, &id), SP_E_CAPACITY);
}

TEST(point_contacts_have_a_frame_of_their_normal)
{
    const sp_real xyz[6] = { 0, 0, 1,  1, 0, 1 };
    const sp_strength strength = sp_strength_friction(0);
    sp_scene scene = two_cubes();
    int32_t id;
    const double most = (double)TOL(1e300, 1e37f), least = (double)TOL(1e-300, 1e-37f);
    const double length[5] = { 1, 2.5, 1e-9, most, least };
    for (int k = 0; k < 5; k++)
        for (int axis = 0; axis < 3; axis++) {
            sp_real n[3] = { 0, 0, 0 };
            n[axis] = R(length[k]);
            scene.count.joints = scene.count.points = 0;
            NEED(sp_scene_points(&scene, 0, 1, n, 2, xyz, &strength, NULL) == SP_OK);
            const sp_joint *f = &scene.joint[0];
            CHECK_WITHIN(f->n[axis], 1, 0);
            CHECK_WITHIN(f->t1[axis == 0 ? 1 : 0], 1, 0);       /* the first of the two axes across n */
            CHECK_NEAR(f->area, 0, 0);
            frame_is_right_handed(f, 0);
        }
    for (int k = 0; k < 200; k++) {
        const sp_real n[3] = { test_random_real(-1, 1), test_random_real(-1, 1), test_random_real(-1, 1) };
        scene.count.joints = scene.count.points = 0;
        NEED(sp_scene_points(&scene, 0, 1, n, 1, xyz, &strength, NULL) == SP_OK);
        frame_is_right_handed(&scene.joint[0], 16 * U);
        CHECK_NEAR(dot(scene.joint[0].n, n), sqrt(dot(n, n)), 8 * U);
    }
    const sp_real zero[3] = { 0, 0, 0 }, bad[3] = { 0, (sp_real)NAN, 1 }, inf[3] = { 0, 1, (sp_real)HUGE_VAL }, up[3] = { 0, 0, 1 };
    REFUSED(sp_scene_points(&scene, 0, 1, zero, 2, xyz, &strength, &id), SP_E_AREA);
    REFUSED(sp_scene_points(&scene, 0, 1, bad, 2, xyz, &strength, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_points(&scene, 0, 1, inf, 2, xyz, &strength, &id), SP_E_NOT_FINITE);
    REFUSED(sp_scene_points(&scene, 0, 1, NULL, 2, xyz, &strength, &id), SP_E_ARGUMENT);
    REFUSED(sp_scene_points(&scene, 0, 1, up, 0, xyz, &strength, &id), SP_E_RANGE);
}

TEST(friction_is_set_for_all_or_none)
{
    const sp_real xyz[12] = { 0, 0, 1,  1, 0, 1,  1, 1, 1,  0, 1, 1 };
    const sp_strength strength = sp_strength_friction(R(0.25));
    sp_scene scene = two_cubes();
    int32_t id;
    CHECK_NEAR(strength.mu, 0.25, 0);
    CHECK_NEAR((double)strength.cohesion + (double)strength.tension + (double)strength.crushing, 0, 0);
    for (int k = 0; k < 3; k++) CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, xyz, &strength, NULL), SP_OK);
    CHECK_INT(sp_scene_friction(&scene, R(0.75)), SP_OK);
    for (int k = 0; k < 3; k++) CHECK_NEAR(scene.joint[k].strength.mu, 0.75, 0);
    REFUSED(sp_scene_friction(&scene, R(-1)), SP_E_RANGE);
    REFUSED(sp_scene_friction(&scene, (sp_real)NAN), SP_E_NOT_FINITE);
    REFUSED(sp_scene_friction(&scene, (sp_real)HUGE_VAL), SP_E_NOT_FINITE);
    REFUSED(sp_scene_friction(NULL, R(1)), SP_E_ARGUMENT);
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
    RUN(cube_volume_is_its_edge_cubed_at_any_scale)
    RUN(tetrahedron_centroid_is_a_quarter)
    RUN(sheared_prism_keeps_its_volume)
    RUN(far_from_the_origin_nothing_is_lost)
    RUN(turning_a_block_turns_its_centroid)
    RUN(a_hole_and_a_cavity_count_as_missing)
    RUN(equal_coordinates_are_the_same_vertex)
    RUN(a_vertex_off_by_an_ulp_opens_the_mesh)
    RUN(open_meshes_are_refused)
    RUN(a_face_without_area_closes_a_gap)
    RUN(inward_meshes_say_so)
    RUN(needles_and_plates_have_a_volume)
    RUN(turned_needles_and_plates_pass_too)
    RUN(flat_bodies_are_degenerate_at_any_scale_and_place)
    RUN(faces_may_warp_by_a_hundredth_and_no_more)
    RUN(broken_meshes_are_refused)
    RUN(infinities_and_overflow_are_refused)
    RUN(a_block_is_stored_as_given)
    RUN(bad_blocks_leave_the_scene_alone)
    RUN(a_full_scene_refuses_each_kind)
    RUN(supports_need_not_be_solid)
    RUN(bodies_have_mass_and_centroid_only)
    RUN(square_has_the_obvious_frame)
    RUN(frames_hold_at_any_scale_and_turn)
    RUN(strips_are_joints_and_lines_are_not)
    RUN(very_long_strips_pass_in_double)
    RUN(polygons_are_plane_to_a_millionth)
    RUN(tangent_skips_edges_without_length)
    RUN(bad_joints_leave_the_scene_alone)
    RUN(joints_and_points_stop_at_the_capacity)
    RUN(point_contacts_have_a_frame_of_their_normal)
    RUN(friction_is_set_for_all_or_none)
    RUN(counts_set_back_take_out_what_was_added_last)
TEST_END
