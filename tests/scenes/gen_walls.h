/* gen, courses in running bond, and stones without courses: walls, rubble. */
#ifndef GEN_WALLS_H
#define GEN_WALLS_H

#include "gen_solids.h"

enum { GEN_JOINTS = 256 };                                  /* head joints of one course */

/* Ends and head joints of a course in running bond: n bricks, or in odd courses n - 1 between two halves. Joints wander by
 * `wander` of half a brick, below 0.5, so neighbours never meet.  Returns the number of stones. */
static int32_t course(gen_sink *s, int32_t odd, int32_t n, double length, double wander, double *x)
{
    int32_t k = 0;
    x[k++] = 0;
    for (int32_t i = odd ? 0 : 1; i < n; i++)
        x[k++] = (i + (odd ? 0.5 : 0.0) + 0.5 * wander * jitter(s)) * length;
    x[k] = n * length;
    return k;
}

/* Joints between two neighbouring courses, stones `first + i` between x[i] and x[i + 1]; calls `meet` for each overlap. */
static void bond(gen_sink *s, int32_t a, int32_t na, const double *xa, int32_t b, int32_t nb, const double *xb,
                 void (*meet)(gen_sink *, int32_t, int32_t, double, double, const void *), const void *data)
{
    for (int32_t i = 0, j = 0; i < na && j < nb; ) {
        meet(s, a + i, b + j, fmax(xa[i], xb[j]), fmin(xa[i + 1], xb[j + 1]), data);
        if (xa[i + 1] < xb[j + 1]) i++;
        else if (xa[i + 1] > xb[j + 1]) j++;
        else i++, j++;
    }
}

typedef struct bed { double depth, z; } bed;

static void meet_level(gen_sink *s, int32_t a, int32_t b, double x0, double x1, const void *data)
{
    const bed *t = data;
    level(s, a, b, x0, x1, 0, t->depth, t->z);
}

/* Known sizes: about 54, 95, 147, 500, 2000 and 10000 joints have 64, 95, 150, 474, 2004 and 9986. */
static void wall_size(double size, int32_t *rows, int32_t *bricks)
{
    static const struct { int32_t size, rows, bricks; } known[] = {
        { 54, 4, 6 }, { 95, 5, 7 }, { 147, 6, 9 }, { 500, 11, 15 }, { 2000, 22, 31 }, { 10000, 48, 70 }
    };
    for (size_t k = 0; k < sizeof known / sizeof known[0]; k++)
        if (whole(size) == known[k].size) {
            *rows = known[k].rows;
            *bricks = known[k].bricks;
        }
}

static void wall(gen_sink *s, const double *v)
{
    int32_t rows = whole(v[0]), n = whole(v[1]);
    wall_size(v[7], &rows, &n);
    const double length = v[2], h = v[3], depth = v[4];
    double x[2][GEN_JOINTS];
    seed(s, v[5]);
    int32_t below = box(s, 0, 0, -h, n * length, depth, 0, SP_FIXED), n_below = 1;
    x[1][0] = 0;
    x[1][1] = n * length;
    for (int32_t r = 0; r < rows; r++) {
        double *here = x[r % 2], *under = x[1 - r % 2];
        const int32_t stones = course(s, r % 2, n, length, v[6], here), first = s->count.blocks;
        const bed t = { depth, r * h };
        for (int32_t i = 0; i < stones; i++) {
            const int32_t b = box(s, here[i], 0, r * h, here[i + 1], depth, (r + 1) * h, 0);
            if (i) upright(s, b - 1, b, here[i], 0, depth, r * h, (r + 1) * h);
        }
        bond(s, below, n_below, under, first, stones, here, meet_level, &t);
        below = first;
        n_below = stones;
    }
}

/* A running-bond wall whose joint corners have all wandered: stones are hexagons in elevation, fitting exactly. */
enum { LOOSE_PLANES = 12 };                             /* faces of a loose stone: 6 sides, 6 chipped corners */

/* Where three planes n . x = d meet, if that lies under all the others.                                      [Cramer] */
static int corner_of(const double (*n)[3], const double *d, const int32_t pick[3], double x[3])
{
    double m[3][3], det = 0;                                /* m: cross products of the other two normals */
    for (int i = 0; i < 3; i++)
        for (int c = 0; c < 3; c++) {
            const double *p = n[pick[(i + 1) % 3]], *q = n[pick[(i + 2) % 3]];
            m[i][c] = p[(c + 1) % 3] * q[(c + 2) % 3] - p[(c + 2) % 3] * q[(c + 1) % 3];
        }
    for (int c = 0; c < 3; c++) det += n[pick[0]][c] * m[0][c];
    if (fabs(det) < 1e-6) return 0;
    for (int c = 0; c < 3; c++) x[c] = (d[pick[0]] * m[0][c] + d[pick[1]] * m[1][c] + d[pick[2]] * m[2][c]) / det;
    for (int32_t k = 0; k < LOOSE_PLANES; k++)
        if (k != pick[0] && k != pick[1] && k != pick[2] && n[k][0] * x[0] + n[k][1] * x[1] + n[k][2] * x[2] > d[k]) return 0;
    return 1;
}

/* Grows with the angle of (x, y) from 0 to 4 in one turn; no arcus tangens, so the same everywhere. */
static double turn(double x, double y)
{
    if (y >= 0) return x >= 0 ? y / (x + y) : 1 - x / (y - x);
    return x < 0 ? 2 + y / (x + y) : 3 + x / (x - y);
}

/* Corners of a face, anticlockwise seen from outside: by their angle about the middle, in the plane. */
static int32_t face_of(const double (*x)[3], int32_t n, const uint32_t *on, int32_t face, const double normal[3], int32_t *corner)
{
    double angle[2 * LOOSE_PLANES], mean[3] = { 0, 0, 0 }, u[3], w[3];
    int32_t size = 0;
    for (int32_t k = 0; k < n; k++)
        if (on[k] >> face & 1) corner[size++] = k;
    for (int32_t k = 0; k < size; k++)
        for (int c = 0; c < 3; c++) mean[c] += x[corner[k]][c] / size;
    for (int c = 0; c < 3 && size; c++) u[c] = x[corner[0]][c] - mean[c];
    for (int c = 0; c < 3 && size; c++) w[c] = normal[(c + 1) % 3] * u[(c + 2) % 3] - normal[(c + 2) % 3] * u[(c + 1) % 3];
    for (int32_t k = 0; k < size; k++) {
        const int32_t id = corner[k];
        double along = 0, across = 0;
        int32_t at = k;
        for (int c = 0; c < 3; c++) along += u[c] * (x[id][c] - mean[c]), across += w[c] * (x[id][c] - mean[c]);
        along *= sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        const double a = k ? turn(along, across) : 0;
        for (; at > 0 && angle[at - 1] > a; at--) angle[at] = angle[at - 1], corner[at] = corner[at - 1];
        angle[at] = a;
        corner[at] = id;
    }
    return size;
}

/* An irregular convex stone about `middle`: a box with tilted sides and six of its corners chipped off, turned about the upright
 * and tilted by up to 30 degrees. half: of its length, depth, height. */
static void loose_stone(gen_sink *s, const double middle[3], const double half[3], double rough)
{
    double n[LOOSE_PLANES][3], d[LOOSE_PLANES], x[2 * LOOSE_PLANES][3];
    uint32_t on[2 * LOOSE_PLANES];
    int32_t size[LOOSE_PLANES], corner[6 * LOOSE_PLANES], pick[3], corners = 0, vertices = 0;
    const int32_t first = whole(4 * fabs(jitter(s)));       /* of the corners chipped */
    const double yaw = gen_pi * jitter(s), tilt = rad(30) * jitter(s), cy = cos(yaw), sy = sin(yaw), ct = cos(tilt), st = sin(tilt);

    for (int32_t k = 0; k < LOOSE_PLANES; k++) {
        const int32_t at = (first + k) % 8;
        for (int32_t c = 0; c < 3; c++) {
            const double side = k < 6 ? (k / 2 == c) * (k % 2 ? 1 : -1) : at >> c & 1 ? 1 : -1;
            n[k][c] = side + (k < 6 ? 0.25 : 0.35) * rough * jitter(s);
        }
        d[k] = k < 6 ? 0.9 + 0.1 * jitter(s) : 2.1 + 0.3 * jitter(s);
    }
    for (pick[0] = 0; pick[0] < LOOSE_PLANES; pick[0]++)
        for (pick[1] = pick[0] + 1; pick[1] < LOOSE_PLANES; pick[1]++)
            for (pick[2] = pick[1] + 1; pick[2] < LOOSE_PLANES; pick[2]++)
                if (vertices < 2 * LOOSE_PLANES - 4 && corner_of((const double (*)[3])n, d, pick, x[vertices]))
                    on[vertices++] = 1u << pick[0] | 1u << pick[1] | 1u << pick[2];
    int32_t faces = 0;
    for (int32_t k = 0; k < LOOSE_PLANES; k++) {
        size[faces] = face_of((const double (*)[3])x, vertices, on, k, n[k], corner + corners);
        if (size[faces] < 3) continue;
        corners += size[faces++];
    }
    for (int32_t k = 0; k < vertices; k++) {
        const double p = half[0] * x[k][0], q = half[1] * x[k][1], r = half[2] * x[k][2];
        x[k][0] = middle[0] + cy * (ct * p + st * r) - sy * q;
        x[k][1] = middle[1] + sy * (ct * p + st * r) + cy * q;
        x[k][2] = middle[2] - st * p + ct * r;
    }
    solid(s, vertices, (const double (*)[3])x, faces, size, corner, 0);
}

/* Loose stones in the air over a slab, in layers, as they are before they fall. */
static void loose(gen_sink *s, int32_t count, const double half[3], double rough)
{
    const double pitch = 2.3 * sqrt(half[0] * half[0] + half[1] * half[1] + half[2] * half[2]);
    int32_t side = 1;
    while (1.953125 * side * side * side < count) side++;       /* 0.8 of the cube root, rounded up */
    const double edge = (0.5 * side + 1.5) * pitch;
    box(s, -edge, -edge, -2 * half[2], edge, edge, 0, SP_FIXED);
    for (int32_t k = 0; k < count; k++) {
        const int32_t column = k % (side * side), layer = k / (side * side);
        const double shift = 0.25 * (layer % 2 ? 1 : -1) - 0.5 * (side - 1);        /* each over a gap of the layer below */
        const double middle[3] = { pitch * (column % side + shift), pitch * (column / side + shift), pitch * (0.8 * layer + 0.5) };
        loose_stone(s, middle, half, rough);
    }
}

static void rubble(gen_sink *s, const double *v)
{
    const int32_t rows = whole(v[0]), n = whole(v[1]), nodes = 2 * n + 1;
    const double length = v[2], h = v[3], depth = v[4], wander = v[6] * 0.45;
    double q[2][GEN_JOINTS + 1][2];                         /* corners of the bed below and above this course */
    int32_t below[GEN_JOINTS];                              /* stone of the course below at each half brick */
    const double half[3] = { 0.5 * length, 0.5 * depth, 0.5 * h };
    seed(s, v[5]);
    if (v[7] > 0) {
        loose(s, whole(v[7]), half, v[6]);
        return;
    }
    const int32_t ground = box(s, 0, 0, -h, n * length, depth, 0, SP_FIXED);
    for (int32_t l = 0; l <= rows; l++) {
        double (*p)[2] = q[l % 2];
        for (int32_t j = 0; j < nodes; j++) {               /* the outline stays straight at the ground and the ends */
            const double dx = jitter(s), dz = jitter(s);
            p[j][0] = 0.5 * length * (j + (j > 0 && j < nodes - 1 ? wander * dx : 0));
            p[j][1] = h * (l + (l > 0 ? wander * dz : 0));
        }
        if (l == 0) continue;
        const int32_t r = l - 1;
        const double (*lo)[2] = (const double (*)[2])q[r % 2], (*hi)[2] = (const double (*)[2])p;
        int32_t here[GEN_JOINTS];
        for (int32_t j0 = 0, j1; j0 < nodes - 1; j0 = j1) {
            double outline[6][2];
            int32_t k = 0;
            j1 = r % 2 && j0 == 0 ? 1 : j0 + 2 < nodes ? j0 + 2 : nodes - 1;
            for (int32_t j = j0; j <= j1; j++, k++) outline[k][0] = lo[j][0], outline[k][1] = lo[j][1];
            for (int32_t j = j1; j >= j0; j--, k++) outline[k][0] = hi[j][0], outline[k][1] = hi[j][1];
            const int32_t b = prism(s, k, (const double (*)[2])outline, 0, depth, 0);
            if (j0) seam(s, b - 1, b, lo[j0], hi[j0], 0, depth);
            if (r == 0) seam(s, ground, b, lo[j1], lo[j0], 0, depth);
            for (int32_t j = j0; j < j1; j++) {
                here[j] = b;
                if (r) seam(s, below[j], b, lo[j + 1], lo[j], 0, depth);
            }
        }
        for (int32_t j = 0; j < nodes - 1; j++) below[j] = here[j];
    }
}

#endif /* GEN_WALLS_H */
