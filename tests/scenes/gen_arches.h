/* gen, what holds by thrust: arches of voussoirs and of wedges, a keystone, a beam between posts. */
#ifndef GEN_ARCHES_H
#define GEN_ARCHES_H

#include "gen_solids.h"

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

#endif /* GEN_ARCHES_H */
