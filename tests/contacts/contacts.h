/* What the suites of contacts share: prisms in any frame, what is found between them. All of it is static. */
#ifndef CONTACTS_H
#define CONTACTS_H

#include "../test.h"

#include <string.h>

#define MANY 64                                         /* corners of a prism's outline */
#define CLOSE TOL(1e-9, 2e-5f)

/* A frame: x = unit (R x' + shift); identity to start with. */
typedef struct frame { double r[3][3], shift[3], unit; } frame;

static frame upright(void)
{
    frame f = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { 0, 0, 0 }, 1 };
    return f;
}

/* A rotation with rational-looking numbers, from the quaternion (w, x, y, z) / |.|. */
static frame turned(double w, double x, double y, double z, double shift, double unit)
{
    const double s = 2 / (w * w + x * x + y * y + z * z);
    frame f = { { { 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w) },
                  { s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w) },
                  { s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y) } },
                { shift, -shift, 2 * shift }, unit };
    return f;
}

static void place(const frame *f, double x, double y, double z, sp_real out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = R(f->unit * (f->r[k][0] * x + f->r[k][1] * y + f->r[k][2] * z + f->shift[k]));
}

static sp_scene scene;
static sp_contact_report report;
static sp_overlap overlap[16];

/* A scene with ample room. */
static int start(int32_t blocks)
{
    const sp_capacity cap = { blocks, blocks * 160, blocks * 200, blocks * 900, blocks * 12, blocks * 200, 0 };
    return CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
}

/* Upright prism over an outline, anticlockwise; caps as one polygon, or as a fan from corner `fan` >= 0; sides as one
 * rectangle or as two triangles. `first` turns the order of the faces, so it must not matter. */
static int32_t prism(const frame *f, int32_t n, double (*xy)[2], double z0, double z1, int fan, int first, uint32_t fixed)
{
    static sp_real xyz[2 * MANY][3];
    static int32_t size[6 * MANY], corner[16 * MANY], begin[6 * MANY], s2[6 * MANY], c2[16 * MANY];
    int32_t faces = 0, corners = 0, id = -1, at = 0;
    for (int32_t k = 0; k < n; k++) {
        place(f, xy[k][0], xy[k][1], z0, xyz[k]);
        place(f, xy[k][0], xy[k][1], z1, xyz[n + k]);
    }
    for (int cap = 0; cap < 2; cap++) {
        if (fan < 0) {
            begin[faces] = corners;
            size[faces++] = n;
            for (int32_t k = 0; k < n; k++) corner[corners++] = cap ? n + k : n - 1 - k;
            continue;
        }
        for (int32_t k = 1; k + 1 < n; k++) {
            const int32_t a = (fan + k) % n, b = (fan + k + 1) % n;
            begin[faces] = corners;
            size[faces++] = 3;
            corner[corners++] = cap ? n + fan : fan;
            corner[corners++] = cap ? n + a : b;
            corner[corners++] = cap ? n + b : a;
        }
    }
    for (int32_t k = 0; k < n; k++) {
        const int32_t m = (k + 1) % n, q[4] = { k, m, n + m, n + k };
        for (int t = 0; t < (fan < 0 ? 1 : 2); t++) {
            begin[faces] = corners;
            size[faces++] = fan < 0 ? 4 : 3;
            corner[corners++] = q[0];
            corner[corners++] = q[1 + t];
            corner[corners++] = q[2 + t];
            if (fan < 0) corner[corners++] = q[3];
        }
    }
    for (int32_t k = 0; k < faces; k++) {
        const int32_t g = (k + first) % faces;
        s2[k] = size[g];
        for (int32_t c = 0; c < size[g]; c++) c2[at++] = corner[begin[g] + c];
    }
    const sp_mesh mesh = { 2 * n, faces, xyz[0], s2, c2 };
    CHECK_INT(sp_scene_block(&scene, &mesh, 2400, fixed, &id), SP_OK);
    return id;
}

static int32_t box(const frame *f, double x0, double y0, double z0, double x1, double y1, double z1, uint32_t fixed)
{
    double xy[4][2] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
    return prism(f, 4, xy, z0, z1, -1, 0, fixed);
}

static sp_status find(const sp_contact_settings *set)
{
    const size_t need = test_bytes(&scene, SP_FOR_CONTACTS, NULL);
    if (!CHECK(need > 0 && need < test_arena.capacity - test_arena.used)) return SP_E_MEMORY;
    report.overlap = overlap;
    report.overlap_capacity = 16;
    return sp_contacts_find(&scene, set, test_arena, &report);
}

/* The smallest build knows convex faces alone: another one with an opposed one near it is refused. Of what two blocks share in one
 * plane it has the convex hull. */
#ifdef SP_SMALL
enum { CONVEX_ONLY = 1 };
#else
enum { CONVEX_ONLY = 0 };
#endif

static double area_sum(void)
{
    double a = 0;
    for (int32_t k = 0; k < scene.count.joints; k++) a += (double)scene.joint[k].area;
    return a;
}

/* One contact of n corners and this area, and no overlap. */
static void expect_one(int32_t corners, double area)
{
    CHECK_INT(find(NULL), SP_OK);
    CHECK_INT(report.joints, 1);
    CHECK_INT(report.points, corners);
    CHECK_INT(report.overlaps, 0);
    CHECK_NEAR(area_sum(), area, CLOSE);
}

static double ell[6][2] = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };

#endif /* CONTACTS_H */
