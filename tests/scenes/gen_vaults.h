/* gen, shells of voussoirs: a barrel in running bond, a dome of rings. */
#ifndef GEN_VAULTS_H
#define GEN_VAULTS_H

#include "gen_arches.h"
#include "gen_walls.h"

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

#endif /* GEN_VAULTS_H */
