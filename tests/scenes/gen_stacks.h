/* gen, what rests by weight alone: cubes, slopes, overhangs, towers, rows. */
#ifndef GEN_STACKS_H
#define GEN_STACKS_H

#include "gen_solids.h"

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

#endif /* GEN_STACKS_H */
