/* gen, where blocks and joints go: solids by their meshes, joints by their corners, counted or built. */
#ifndef GEN_SOLIDS_H
#define GEN_SOLIDS_H

#include "gen.h"
#include <math.h>

struct gen_sink {
    sp_scene *scene;            /* NULL: count only */
    sp_capacity count;
    sp_strength strength;
    double density;
    sp_status status;           /* the first failure */
    uint64_t random;
};

enum { GEN_VERTICES = 512, GEN_FACES = 512, GEN_CORNERS = 2048 };   /* of one block: the ring under a dome is the largest */

static const double gen_pi = 3.14159265358979323846;

static double rad(double degrees) { return degrees * (gen_pi / 180.0); }

static double tangent(double x) { return gen_sin(x) / gen_cos(x); }

/* -1 <= x < 1                                                                                            [xorshift64*] */
static double jitter(gen_sink *s)
{
    s->random ^= s->random >> 12;
    s->random ^= s->random << 25;
    s->random ^= s->random >> 27;
    return (double)((s->random * 2685821657736338717u) >> 32) / 2147483648.0 - 1.0;
}

static void seed(gen_sink *s, double value)
{
    s->random = ((uint64_t)value + 1) * 2862933555777941757u + 3037000493u;
}

static int32_t whole(double value) { return (int32_t)floor(value + 0.5); }

/* A block by its mesh: its number. */
static int32_t solid(gen_sink *s, int32_t vertices, const double (*xyz)[3], int32_t faces, const int32_t *size,
                     const int32_t *corner, uint32_t fixed)
{
    sp_real x[3 * GEN_VERTICES];
    int32_t id = s->count.blocks++, corners = 0;
    for (int32_t k = 0; k < faces; k++) corners += size[k];
    s->count.vertices += vertices;
    s->count.faces += faces;
    s->count.corners += corners;
    if (!s->scene || s->status) return id;
    for (int32_t k = 0; k < vertices; k++)
        for (int c = 0; c < 3; c++) x[3 * k + c] = (sp_real)xyz[k][c];
    const sp_mesh mesh = { vertices, faces, x, size, corner };
    s->status = sp_scene_block(s->scene, &mesh, (sp_real)s->density, fixed, &id);
    return id;
}

/* A joint, anticlockwise seen from b. */
static void joint(gen_sink *s, int32_t a, int32_t b, int32_t points, const double (*xyz)[3])
{
    sp_real x[3 * 8];
    s->count.joints++;
    s->count.points += points;
    if (!s->scene || s->status) return;
    for (int32_t k = 0; k < points; k++)
        for (int c = 0; c < 3; c++) x[3 * k + c] = (sp_real)xyz[k][c];
    s->status = sp_scene_joint(s->scene, a, b, points, x, &s->strength, NULL);
}

/* A six-sided solid: corners 0-3 anticlockwise seen from outside, 4-7 the same corners of the opposite side. */
static int32_t hexahedron(gen_sink *s, const double xyz[8][3], uint32_t fixed)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 1, 2, 3,  7, 6, 5, 4,  0, 4, 5, 1,  1, 5, 6, 2,  2, 6, 7, 3,  3, 7, 4, 0 };
    return solid(s, 8, xyz, 6, size, corner, fixed);
}

/* The polygon q (x, z) extruded from y0 to y1. */
static int32_t prism(gen_sink *s, int32_t n, const double (*q)[2], double y0, double y1, uint32_t fixed)
{
    double xyz[GEN_VERTICES][3];
    int32_t size[GEN_FACES], corner[GEN_CORNERS], k = 0;
    for (int32_t i = 0; i < n; i++) {
        xyz[i][0] = xyz[n + i][0] = q[i][0];
        xyz[i][1] = y0;
        xyz[n + i][1] = y1;
        xyz[i][2] = xyz[n + i][2] = q[i][1];
    }
    size[0] = size[1] = n;
    for (int32_t i = 0; i < n; i++) corner[k++] = i;                        /* towards -y */
    for (int32_t i = n; i-- > 0; ) corner[k++] = n + i;                     /* towards +y */
    for (int32_t i = 0; i < n; i++) {
        const int32_t j = (i + 1) % n;
        size[2 + i] = 4;
        corner[k++] = i;
        corner[k++] = n + i;
        corner[k++] = n + j;
        corner[k++] = j;
    }
    return solid(s, 2 * n, (const double (*)[3])xyz, 2 + n, size, corner, fixed);
}

/* The joint over p q, from y0 to y1; p q runs along a's outline, so b is on its right. */
static void seam(gen_sink *s, int32_t a, int32_t b, const double p[2], const double q[2], double y0, double y1)
{
    const double xyz[4][3] = { { p[0], y0, p[1] }, { p[0], y1, p[1] }, { q[0], y1, q[1] }, { q[0], y0, q[1] } };
    joint(s, a, b, 4, xyz);
}

static int32_t box(gen_sink *s, double x0, double y0, double z0, double x1, double y1, double z1, uint32_t fixed)
{
    const double q[4][2] = { { x0, z0 }, { x1, z0 }, { x1, z1 }, { x0, z1 } };
    return prism(s, 4, q, y0, y1, fixed);
}

/* A level joint, b on a. */
static void level(gen_sink *s, int32_t a, int32_t b, double x0, double x1, double y0, double y1, double z)
{
    const double xyz[4][3] = { { x0, y0, z }, { x1, y0, z }, { x1, y1, z }, { x0, y1, z } };
    joint(s, a, b, 4, xyz);
}

/* An upright joint, b to the right of a. */
static void upright(gen_sink *s, int32_t a, int32_t b, double x, double y0, double y1, double z0, double z1)
{
    const double xyz[4][3] = { { x, y0, z0 }, { x, y1, z0 }, { x, y1, z1 }, { x, y0, z1 } };
    joint(s, a, b, 4, xyz);
}

#endif /* GEN_SOLIDS_H */
