/* What the suites of scenes share: boxes, turns, a scene with room, what a refusal must leave as it was. All of it is static. */
#ifndef SCENE_H
#define SCENE_H

#include "../test.h"

#include <string.h>
#include <math.h>

#define U ((double)SP_EPSILON)

/* A box [0,1]^3 as six quads or twelve triangles, outward. Vertex v: bits 0 1 2 of v are x y z. */
static const int32_t box_size[6] = { 4, 4, 4, 4, 4, 4 };
static const int32_t box_corner[24] = { 0, 2, 3, 1,  4, 5, 7, 6,  0, 1, 5, 4,  2, 6, 7, 3,  0, 4, 6, 2,  1, 3, 7, 5 };

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
    h = mix(h, &s->capacity, sizeof s->capacity);
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

#endif /* SCENE_H */
