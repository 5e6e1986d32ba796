/* gen: assemblies made by formula.
 *
 * Contents:  1 sink   2 solids and joints   3 stacks   4 wedges and arches   5 walls   6 vault and dome   7 table   8 calls
 *
 * Most scenes are drawn in the x-z plane, x to the right and z up, and extruded along y. Polygons run anticlockwise seen
 * from -y. Lengths in m, angles in degrees.
 */
#include "gen.h"

#include <math.h>

/* 1 -------------------------------------------------------------------------------------------------------------- sink */

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

/* sin and cos by their series on |r| <= pi/4, r = x - k pi/2 with pi/2 in two parts: C libraries differ in the last bit, this
 * does not. For |x| up to some hundred turns. */
static void turned(double x, double *sine, double *cosine)
{
    const double k = floor(x * (2 / gen_pi) + 0.5), r = (x - k * 1.57079632673412561417) - k * 6.07710050650619224932e-11, q = r * r;
    double s = 0, c = 0;
    for (int i = 17; i >= 3; i -= 2) s = q / (i * (i - 1)) * (1 - s);       /* sin r = r (1 - q/6 (1 - q/20 (1 - ... */
    for (int i = 18; i >= 2; i -= 2) c = q / (i * (i - 1)) * (1 - c);       /* cos r = 1 - q/2 (1 - q/12 (1 - ... */
    s = r - r * s;
    c = 1 - c;
    const int quarter = (int)k & 3;
    *sine = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
    *cosine = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
}

double gen_sin(double x)
{
    double s, c;
    turned(x, &s, &c);
    return s;
}

double gen_cos(double x)
{
    double s, c;
    turned(x, &s, &c);
    return c;
}

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

/* 2 ------------------------------------------------------------------------------------------------ solids and joints */

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

/* 3 ------------------------------------------------------------------------------------------------------------ stacks */

static void two_cubes(gen_sink *s, const double *v)
{
    const double x = v[0];
    const int32_t a = box(s, 0, 0, 0, 1, 1, 1, SP_FIXED), b = box(s, x, 0, 1, 1 + x, 1, 2, 0);
    level(s, a, b, x > 0 ? x : 0, x > 0 ? 1 : 1 + x, 0, 1, 1);
}

/* A slab tilted about y, falling towards +x, and a box on it turned by `azimuth` about the slab's normal: the slope runs at
 * that angle to the first edge of the joint. */
static void slope(gen_sink *s, double angle, double azimuth, double length, double depth, double height)
{
    const double ca = gen_cos(rad(angle)), sa = gen_sin(rad(angle)), cz = gen_cos(rad(azimuth)), sz = gen_sin(rad(azimuth));
    const double r = 0.75 * sqrt(length * length + depth * depth);
    double slab[8][3], block[8][3];
    for (int i = 0; i < 8; i++) {                           /* corners 0-3 face down, so they run the other way */
        static const double sx[4] = { -1, 1, 1, -1 }, sy[4] = { -1, -1, 1, 1 };
        const double u = sx[3 - i % 4], w = sy[3 - i % 4];
        const int top = i >= 4;
        const double bx = 0.5 * length * u, by = 0.5 * depth * w, bz = top ? height : 0;
        const double x = cz * bx + sz * by, y = -sz * bx + cz * by;
        block[i][0] = ca * x + sa * bz;
        block[i][1] = y;
        block[i][2] = -sa * x + ca * bz;
        const double g = top ? 0 : -0.2 * r;
        slab[i][0] = ca * r * u + sa * g;
        slab[i][1] = r * w;
        slab[i][2] = -sa * r * u + ca * g;
    }
    const int32_t a = hexahedron(s, (const double (*)[3])slab, SP_FIXED);
    const int32_t b = hexahedron(s, (const double (*)[3])block, 0);
    double foot[4][3];
    for (int i = 0; i < 4; i++)
        for (int c = 0; c < 3; c++) foot[i][c] = block[3 - i][c];
    joint(s, a, b, 4, (const double (*)[3])foot);
}

static void incline(gen_sink *s, const double *v) { slope(s, v[0], v[1], 1, 1, v[2]); }

static void topple(gen_sink *s, const double *v) { slope(s, v[2], 0, v[0], 1, v[1]); }

/* n boards over a table's edge at x = 0; counted from the top, board k reaches factor / (2k) beyond the one below. */
static void overhang(gen_sink *s, const double *v)
{
    const int32_t n = whole(v[0]);
    const double h = v[3];
    int32_t below = box(s, -1, 0, -h, 0, 1, 0, SP_FIXED);
    double left = -1, reach = v[2];                                             /* of the block below; right end of this */
    for (int32_t k = n; k >= 1; k--) {
        reach += v[1] / (2.0 * k);
        const double z = (n - k) * h, right_below = left + 1, x0 = reach - 1 > left ? reach - 1 : left;
        const int32_t b = box(s, reach - 1, 0, z, reach, 1, z + h, 0);
        level(s, below, b, x0, right_below < reach ? right_below : reach, 0, 1, z);
        below = b;
        left = reach - 1;
    }
}

/* A beam 2 long and 0.2 high that reaches beyond its support, and a weight on its tail.
 * It tips when 2 * 0.2 (reach - 1) > 0.8 w ((2 - reach) - 0.4). */
static void cantilever(gen_sink *s, const double *v)
{
    const double reach = v[0], w = v[1], tail = 2 - reach, d = 0.5;
    const int32_t a = box(s, -tail, 0, -0.5, 0, d, 0, SP_FIXED);
    const int32_t b = box(s, -tail, 0, 0, reach, d, 0.2, 0);
    const int32_t c = box(s, -tail, 0, 0.2, 0.8 - tail, d, 0.2 + w, 0);
    level(s, a, b, -tail, 0, 0, d, 0);
    level(s, b, c, -tail, 0.8 - tail, 0, d, 0.2);
}

/* n cubes, each `lean` further than the one below; falls over its foot when lean > 1 / (n + 1). */
static void tower(gen_sink *s, const double *v)
{
    const int32_t n = whole(v[0]);
    int32_t below = box(s, 0, 0, -1, 1, 1, 0, SP_FIXED);
    for (int32_t k = 0; k < n; k++) {
        const double x = (k + 1) * v[1];
        const int32_t b = box(s, x, 0, k, x + 1, 1, k + 1, 0);
        level(s, below, b, x, x + 1 - v[1], 0, 1, k);
        below = b;
    }
}

/* One row of unit boards centred over x = 0 on the row below; level joints only. */
static int32_t row(gen_sink *s, int32_t first_below, int32_t n_below, int32_t n, double z, double h)
{
    const double left_below = -0.5 * n_below, left = -0.5 * n;
    int32_t first = -1;
    for (int32_t i = 0; i < n; i++) {
        const int32_t b = box(s, left + i, 0, z, left + i + 1, 0.5, z + h, 0);
        if (i == 0) first = b;
        for (int32_t k = 0; k < n_below; k++) {
            const double x0 = fmax(left_below + k, left + i), x1 = fmin(left_below + k + 1, left + i + 1);
            if (x1 > x0 + 0.25) level(s, first_below + k, b, x0, x1, 0, 0.5, z);
        }
    }
    return first;
}

/* Rows of 1, 2, ... m, and down to 1 again for a diamond. */
static void rows_up_and_down(gen_sink *s, int32_t m, int32_t down, double h)
{
    int32_t below = box(s, -0.5, 0, -h, 0.5, 0.5, 0, SP_FIXED), n_below = 1;
    for (int32_t k = 1; k <= (down ? 2 * m - 1 : m); k++) {
        const int32_t n = k <= m ? k : 2 * m - k;
        below = row(s, below, n_below, n, (k - 1) * h, h);
        n_below = n;
    }
}

static void diamond(gen_sink *s, const double *v) { rows_up_and_down(s, whole(v[0]), 1, v[1]); }

static void inverted_triangle(gen_sink *s, const double *v) { rows_up_and_down(s, whole(v[0]), 0, v[1]); }

/* 4 ------------------------------------------------------------------------------------------------- wedges and arches */

static void polar(double r, double angle, double q[2])
{
    q[0] = r * gen_cos(angle);
    q[1] = r * gen_sin(angle);
}

enum { GEN_FACETS = 60 };                       /* chords of a voussoir's inside and outside, at most */

/* Outline of a voussoir between two radial joints, angles from x, the left one the larger; both arcs as `facets` chords.
 * Returns the number of corners. */
static int32_t voussoir(double ri, double ro, double left, double right, int32_t facets, double (*q)[2])
{
    int32_t n = 0;
    for (int32_t k = 0; k <= facets; k++) polar(ro, (right * (facets - k) + left * k) / facets, q[n++]);
    for (int32_t k = 0; k <= facets; k++) polar(ri, (left * (facets - k) + right * k) / facets, q[n++]);
    return n;                                   /* the left joint runs from q[facets + 1] inside to q[facets] outside */
}

/* Angle of joint i of n over 2 half, measured from the crown: left and right are mirror images to the last bit. */
static double joint_angle(int32_t i, int32_t n, double half) { return 0.5 * gen_pi + (n - 2 * i) * (half / n); }

/* n voussoirs over an angle of 2 half, from left to right; springers are blocks of their own, or (ends = 1) the first and
 * last voussoirs. */
static void arch(gen_sink *s, const double *v)
{
    const int32_t n = whole(v[0]), ends = whole(v[4]), facets = whole(v[6]);
    const double ri = v[2] * (1 - 0.5 * v[1]), ro = v[2] * (1 + 0.5 * v[1]), half = rad(v[3]), depth = v[5];
    double q[2 * GEN_FACETS + 2][2];
    int32_t before = -1;
    for (int32_t i = ends ? 0 : -1; i < (ends ? n : n + 1); i++) {
        const int held = ends ? i == 0 || i == n - 1 : i < 0 || i == n;
        const int32_t corners = voussoir(ri, ro, joint_angle(i, n, half), joint_angle(i + 1, n, half), facets, q);
        const int32_t b = prism(s, corners, (const double (*)[2])q, 0, depth, held ? SP_FIXED : 0);
        if (before >= 0 && (!ends || n > 2)) seam(s, before, b, q[facets + 1], q[facets], 0, depth);
        before = b;
    }
}

/* n wedges under a level top, joints through one centre below; the outer ones are `half` from upright. */
static void flat_arch(gen_sink *s, const double *v)
{
    const int32_t n = whole(v[0]);
    const double span = v[1], h = v[2], depth = v[4], grow = tangent(rad(v[3])) * h / (0.5 * span);
    int32_t before = -1;
    for (int32_t i = -1; i <= n; i++) {
        const double x0 = span * ((double)i / n - 0.5), x1 = span * ((double)(i + 1) / n - 0.5);
        const double q[4][2] = { { x0, 0 }, { x1, 0 }, { x1 * (1 + grow), h }, { x0 * (1 + grow), h } };
        const int32_t b = prism(s, 4, q, 0, depth, i < 0 || i == n ? SP_FIXED : 0);
        if (before >= 0) seam(s, before, b, q[0], q[3], 0, depth);
        before = b;
    }
}

/* One wedge between two supports; its sides lean by `angle` from upright, wider below for angle > 0: stands iff mu >= tan. */
static void keystone(gen_sink *s, const double *v)
{
    const double w = 0.5 * v[1], h = v[2], d = v[3], lean = 0.5 * h * tangent(rad(v[0])), far = w + fabs(lean) + 0.5 * v[1];
    const double left[4][2] = { { -far, 0 }, { -w - lean, 0 }, { -w + lean, h }, { -far, h } };
    const double stone[4][2] = { { -w - lean, 0 }, { w + lean, 0 }, { w - lean, h }, { -w + lean, h } };
    const double right[4][2] = { { w + lean, 0 }, { far, 0 }, { far, h }, { w - lean, h } };
    const int32_t a = prism(s, 4, left, 0, d, SP_FIXED), b = prism(s, 4, stone, 0, d, 0);
    const int32_t c = prism(s, 4, right, 0, d, SP_FIXED);
    seam(s, a, b, left[1], left[2], 0, d);
    seam(s, b, c, stone[1], stone[2], 0, d);
}

/* A beam held between two posts by friction alone: statics accepts it for any mu > 0.                 [CRA paper, H model] */
static void h_model(gen_sink *s, const double *v)
{
    (void)v;
    const int32_t a = box(s, 0, 0, 0, 0.4, 0.4, 1.2, SP_FIXED), c = box(s, 1, 0, 0, 1.4, 0.4, 1.2, SP_FIXED);
    const int32_t b = box(s, 0.4, 0, 0.6, 1, 0.4, 0.9, 0);
    upright(s, a, b, 0.4, 0, 0.4, 0.6, 0.9);
    upright(s, b, c, 1, 0, 0.4, 0.6, 0.9);
}

/* 5 ------------------------------------------------------------------------------------------------------------- walls */

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

/* 6 ---------------------------------------------------------------------------------------------------- vault and dome */

typedef struct radial { const double *in, *out; } radial;   /* ends of a radial joint (x, z) */

static void meet_radial(gen_sink *s, int32_t a, int32_t b, double y0, double y1, const void *data)
{
    const radial *t = data;
    seam(s, a, b, t->in, t->out, y0, y1);
}

/* A barrel: courses run along y, in running bond, from the left springing to the right; both springers are one block. */
static void vault(gen_sink *s, const double *v)
{
    const int32_t around = whole(v[0]), n = whole(v[1]);
    const double ri = v[3] * (1 - 0.5 * v[2]), ro = v[3] * (1 + 0.5 * v[2]), half = rad(v[4]);
    const double length = v[5] / n;
    double y[2][GEN_JOINTS], q[4][2];
    int32_t before = -1, n_before = 0;
    seed(s, v[6]);
    for (int32_t i = -1; i <= around; i++) {
        const int held = i < 0 || i == around;
        double *here = y[(i + 1) % 2], *last = y[1 - (i + 1) % 2];
        voussoir(ri, ro, joint_angle(i, around, half), joint_angle(i + 1, around, half), 1, q);     /* out, out, in, in */
        const int32_t stones = held ? 1 : course(s, i % 2, n, length, v[7], here), first = s->count.blocks;
        if (held) here[0] = 0, here[1] = n * length;
        for (int32_t k = 0; k < stones; k++) {
            const int32_t b = prism(s, 4, (const double (*)[2])q, here[k], here[k + 1], held ? SP_FIXED : 0);
            if (k) {                                        /* the cross section, towards +y */
                const double x[4][3] = { { q[3][0], here[k], q[3][1] }, { q[2][0], here[k], q[2][1] },
                                         { q[1][0], here[k], q[1][1] }, { q[0][0], here[k], q[0][1] } };
                joint(s, b - 1, b, 4, x);
            }
        }
        const radial t = { q[2], q[1] };
        if (before >= 0) bond(s, before, n_before, last, first, stones, here, meet_radial, &t);
        before = first;
        n_before = stones;
    }
}

/* A point of a dome: radius, angle from the zenith, azimuth. */
static void spherical(double r, double phi, double azimuth, double x[3])
{
    x[0] = r * gen_sin(phi) * gen_cos(azimuth);
    x[1] = r * gen_sin(phi) * gen_sin(azimuth);
    x[2] = r * gen_cos(phi);
}

/* The fixed ring under a dome: `n` corners each inside and outside, at its top and its foot. */
static int32_t ring(gen_sink *s, int32_t n, double ri, double ro, double top, double foot)
{
    double x[GEN_VERTICES][3];
    int32_t size[GEN_FACES], corner[GEN_CORNERS], c = 0, f = 0;
    for (int32_t i = 0; i < n; i++) {
        const double az = 2 * gen_pi * i / n;
        spherical(ri, top, az, x[4 * i]);
        spherical(ro, top, az, x[4 * i + 1]);
        spherical(ro, foot, az, x[4 * i + 2]);
        spherical(ri, foot, az, x[4 * i + 3]);
    }
    for (int32_t i = 0; i < n; i++)
        for (int32_t k = 0; k < 4; k++) {                   /* sides of the ring's section: top, outside, foot, inside */
            const int32_t j = 4 * ((i + 1) % n), l = (k + 1) % 4;
            corner[c++] = 4 * i + k;
            corner[c++] = 4 * i + l;
            corner[c++] = j + l;
            corner[c++] = j + k;
            size[f++] = 4;
        }
    return solid(s, 4 * n, (const double (*)[3])x, f, size, corner, SP_FIXED);
}

/* Rings of equal stones from the springing up to an oculus; all faces are plane. */
static void dome(gen_sink *s, const double *v)
{
    const int32_t rings = whole(v[0]), n = whole(v[1]);
    const double ri = v[3] * (1 - 0.5 * v[2]), ro = v[3] * (1 + 0.5 * v[2]), foot = rad(v[4]), eye = rad(v[5]);
    const double step = (foot - eye) / rings;
    const int32_t ground = ring(s, n, ri, ro, foot, foot + step);
    for (int32_t r = 0; r < rings; r++)
        for (int32_t i = 0; i < n; i++) {
            const double a = foot - r * step, b = foot - (r + 1) * step;
            const double az0 = 2 * gen_pi * i / n, az1 = 2 * gen_pi * ((i + 1) % n) / n;
            double x[8][3];                                 /* 0-3 the joint below seen from below, 4-7 the one above */
            spherical(ri, a, az0, x[0]);
            spherical(ri, a, az1, x[1]);
            spherical(ro, a, az1, x[2]);
            spherical(ro, a, az0, x[3]);
            spherical(ri, b, az0, x[4]);
            spherical(ri, b, az1, x[5]);
            spherical(ro, b, az1, x[6]);
            spherical(ro, b, az0, x[7]);
            const int32_t id = hexahedron(s, (const double (*)[3])x, 0);
            double q[4][3];
            for (int c = 0; c < 3; c++) q[0][c] = x[0][c], q[1][c] = x[3][c], q[2][c] = x[2][c], q[3][c] = x[1][c];
            joint(s, r ? id - n : ground, id, 4, (const double (*)[3])q);
            for (int c = 0; c < 3; c++) q[0][c] = x[0][c], q[1][c] = x[4][c], q[2][c] = x[7][c], q[3][c] = x[3][c];
            if (i) joint(s, id - 1, id, 4, (const double (*)[3])q);
            for (int c = 0; c < 3; c++) q[0][c] = x[1][c], q[1][c] = x[5][c], q[2][c] = x[6][c], q[3][c] = x[2][c];
            if (i == n - 1) joint(s, id, id - i, 4, (const double (*)[3])q);
        }
}

/* 7 ------------------------------------------------------------------------------------------------------------- table */

#define END { NULL, 0, 0, 0, NULL }

const gen_param gen_common[] = {
    { "mu",      0.84,    0, 1e9, "friction coefficient" },
    { "density", 2400, 1e-9, 1e9, "kg/m^3" },
    { "tilt",    0,     -90,  90, "the world turned, degrees" },
    { "azimuth", 0,    -360, 360, "towards this direction, degrees from x to y" },
    END
};

const gen_entry gen_table[] = {
    { "two-cubes", "a cube on a fixed one", two_cubes, {
        { "offset", 0.3, -0.99, 0.99, "of the upper one along x, m; falls beyond 0.5" }, END } },
    { "incline", "a block on a slope; slides when tan(angle) > mu", incline, {
        { "angle", 20, -80, 80, "of the slope, degrees" },
        { "turn", 0, -360, 360, "of the slope against the joint's first edge, degrees" },
        { "height", 0.2, 1e-3, 10, "of the unit block, m" }, END } },
    { "topple", "a tall block on a slope; topples when tan(angle) > base / height", topple, {
        { "base", 0.25, 1e-3, 100, "m" }, { "height", 1, 1e-3, 100, "m" }, { "angle", 13, -80, 80, "degrees" }, END } },
    { "overhang", "the harmonic stack over a table's edge; falls when factor > 1", overhang, {
        { "n", 5, 1, 200, "boards of length 1" }, { "factor", 0.95, 0, 1.5, "of the harmonic offsets" },
        { "shift", 0, -0.5, 0.5, "of the whole stack, m" }, { "height", 0.2, 1e-3, 10, "of a board, m" }, END } },
    { "cantilever", "a beam held down by a weight on its tail", cantilever, {
        { "reach", 1.2, 0, 1.6, "beyond the support, m, of 2 m" }, { "weight", 0.3, 1e-3, 100, "height of the weight, m" }, END } },
    { "tower", "a leaning stack of cubes; falls when lean > 1 / (n + 1)", tower, {
        { "n", 10, 1, 1000, "cubes" }, { "lean", 0.08, 0, 0.9, "each beyond the one below, m" }, END } },
    { "diamond", "rows of 1, 2 .. m .. 2, 1 boards; m = 5 needs mu .2813, 6 needs .5396", diamond, {
        { "rows", 5, 1, 60, "m, boards in the longest row" }, { "height", 0.3, 1e-3, 10, "of a board, m" }, END } },
    { "inverted-triangle", "rows of 1, 2 .. m boards; stands only to m = 2", inverted_triangle, {
        { "rows", 3, 1, 60, "m" }, { "height", 0.3, 1e-3, 10, "of a board, m" }, END } },
    { "arch", "a ring of voussoirs with straight sides", arch, {
        { "n", 20, 2, 2000, "voussoirs" }, { "t", 0.12, 1e-4, 1.9, "thickness / mean radius" }, { "radius", 1, 1e-3, 1e6, "mean, m" },
        { "half", 90, 1, 170, "half angle of embrace, degrees" }, { "ends", 0, 0, 1, "1: the end voussoirs are the supports" },
        { "depth", 0.5, 1e-3, 1e6, "m" }, { "facets", 1, 1, GEN_FACETS, "chords of each inside and outside" }, END } },
    { "flat-arch", "wedges under a level top", flat_arch, {
        { "n", 9, 1, 500, "wedges" }, { "span", 2, 1e-3, 1e6, "m, below" }, { "height", 0.4, 1e-3, 1e6, "m" },
        { "half", 25, 0, 60, "lean of the outer joints, degrees" }, { "depth", 0.4, 1e-3, 1e6, "m" }, END } },
    { "keystone", "one wedge between supports; stands iff mu >= tan(angle)", keystone, {
        { "angle", 20, -60, 60, "of its sides from upright, wider below for > 0, degrees" }, { "width", 1, 1e-3, 1e6, "at mid height, m" },
        { "height", 0.5, 1e-3, 1e6, "m" }, { "depth", 0.5, 1e-3, 1e6, "m" }, END } },
    { "h-model", "a beam held between two posts by friction alone", h_model, { END } },
    { "wall", "running bond, odd courses end in half bricks", wall, {
        { "rows", 8, 1, 500, "" }, { "bricks", 8, 1, 200, "per course" }, { "length", 0.4, 1e-6, 1e6, "of a brick, m" },
        { "height", 0.2, 1e-6, 1e6, "of a course, m" }, { "depth", 0.2, 1e-6, 1e6, "m" }, { "seed", 1, 0, 1e9, "" },
        { "jitter", 0, 0, 0.49, "of the head joints, of half a brick" },
        { "size", 0, 0, 1e4, "instead of rows and bricks: 54 95 147 500 2000 10000 interfaces or so" }, END } },
    { "rubble", "irregular polygonal stones that fit exactly", rubble, {
        { "rows", 6, 1, 500, "" }, { "bricks", 6, 1, 120, "per course" }, { "length", 0.5, 1e-6, 1e6, "mean, m" },
        { "height", 0.25, 1e-6, 1e6, "mean, m" }, { "depth", 0.4, 1e-6, 1e6, "m" }, { "seed", 1, 0, 1e9, "" },
        { "jitter", 0.5, 0, 1, "of all corners" },
        { "count", 0, 0, 5000, "loose stones in the air instead, for settle" }, END } },
    { "vault", "a barrel in running bond", vault, {
        { "around", 13, 2, 400, "courses" }, { "n", 5, 1, 200, "stones along a course" }, { "t", 0.15, 1e-3, 1.9, "thickness / mean radius" },
        { "radius", 1, 1e-3, 1e6, "mean, m" }, { "half", 90, 1, 170, "half angle of embrace, degrees" },
        { "length", 2, 1e-3, 1e6, "m" }, { "seed", 1, 0, 1e9, "" }, { "jitter", 0, 0, 0.49, "of the cross joints" }, END } },
    { "dome", "rings of stones from the springing to an oculus", dome, {
        { "rings", 8, 1, 200, "" }, { "segments", 16, 3, 128, "stones of a ring" }, { "t", 0.1, 1e-3, 1.9, "thickness / mean radius" },
        { "radius", 1, 1e-3, 1e6, "mean, m" }, { "foot", 90, 10, 120, "springing, degrees from the zenith" },
        { "eye", 12, 1, 80, "oculus, degrees from the zenith" }, END } },
    { NULL, NULL, NULL, { END } }
};

/* 8 ------------------------------------------------------------------------------------------------------------- calls */

static int same(const char *a, const char *b)
{
    while (*a && *a == *b) a++, b++;
    return *a == *b;
}

int gen_open(gen_scene *g, const char *name)
{
    for (const gen_entry *e = gen_table; e->name; e++)
        if (same(e->name, name)) {
            g->entry = e;
            for (int k = 0; k < GEN_OWN; k++) g->value[k] = 0;
            for (int k = 0; k < GEN_OWN && e->param[k].name; k++) g->value[k] = e->param[k].value;
            for (int k = 0; k < GEN_COMMON; k++) g->value[GEN_OWN + k] = gen_common[k].value;
            return 1;
        }
    return 0;
}

int gen_set(gen_scene *g, const char *name, double value)
{
    for (int k = 0; k < GEN_OWN + GEN_COMMON; k++) {
        const gen_param *p = k < GEN_OWN ? &g->entry->param[k] : &gen_common[k - GEN_OWN];
        if (!p->name) {
            k = GEN_OWN - 1;
            continue;
        }
        if (!same(p->name, name)) continue;
        if (!(value >= p->low && value <= p->high)) return -1;
        g->value[k] = value;
        return 1;
    }
    return 0;
}

static gen_sink start(const gen_scene *g, sp_scene *scene)
{
    gen_sink s = { scene, { 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0 }, g->value[GEN_OWN + 1], SP_OK, 1 };
    s.strength.mu = (sp_real)g->value[GEN_OWN];
    return s;
}

sp_status gen_capacity(const gen_scene *g, sp_capacity *cap)
{
    gen_sink s = start(g, NULL);
    g->entry->emit(&s, g->value);
    *cap = s.count;
    return SP_OK;
}

void gen_gravity(double tilt, double azimuth, sp_real gravity[3])
{
    const double g = 9.80665;
    gravity[0] = (sp_real)(g * gen_sin(rad(tilt)) * gen_cos(rad(azimuth)));
    gravity[1] = (sp_real)(g * gen_sin(rad(tilt)) * gen_sin(rad(azimuth)));
    gravity[2] = (sp_real)(-g * gen_cos(rad(tilt)));
}

sp_status gen_build(const gen_scene *g, sp_arena *arena, sp_scene *scene)
{
    sp_capacity cap;
    sp_status status = gen_capacity(g, &cap);
    if (status) return status;
    status = sp_scene_create(scene, &cap, arena);
    if (status) return status;
    gen_sink s = start(g, scene);
    g->entry->emit(&s, g->value);
    gen_gravity(g->value[GEN_OWN + 2], g->value[GEN_OWN + 3], scene->gravity);
    return s.status;
}

sp_status gen_make(const char *name, const char *param, double value, sp_arena *arena, sp_scene *scene)
{
    gen_scene g;
    if (gen_open(&g, name) != 1 || (param && gen_set(&g, param, value) != 1)) return SP_E_ARGUMENT;
    return gen_build(&g, arena, scene);
}
