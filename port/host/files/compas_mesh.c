#include "compas_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PARALLEL 1e-9                   /* sine of the angle between axes that tell no plane */

/* Room for one more entry.     returns 0: memory is out */
static int grow(void **table, int32_t count, int32_t *room, size_t size)
{
    const int32_t more = *room ? 2 * *room : 64;
    if (count < *room) return 1;
    void *bigger = more > *room ? realloc(*table, (size_t)more * size) : NULL;
    if (!bigger) return 0;
    *table = bigger;
    *room = more;
    return 1;
}

int compas_begin(compas_solids *s)
{
    void *block = s->block;
    const int grown = grow(&block, s->blocks, &s->room.block, sizeof *s->block);
    s->block = block;
    if (!grown) return 0;
    s->block[s->blocks][0] = s->vertices;
    s->block[s->blocks][1] = s->faces;
    s->blocks++;
    return compas_end_face(s);
}

int compas_add_vertex(compas_solids *s, const double x[3])
{
    void *xyz = s->xyz;
    const int grown = grow(&xyz, s->vertices, &s->room.xyz, sizeof *s->xyz);
    s->xyz = xyz;
    if (grown) memcpy(s->xyz[s->vertices++], x, sizeof *s->xyz);
    return grown;
}

int compas_add_corner(compas_solids *s, int32_t vertex)
{
    void *corner = s->corner;
    const int grown = grow(&corner, s->corners, &s->room.corner, sizeof *s->corner);
    s->corner = corner;
    if (grown) s->corner[s->corners++] = vertex;
    return grown;
}

int compas_end_face(compas_solids *s)
{
    void *face = s->face;
    const int grown = grow(&face, s->faces, &s->room.face, sizeof *s->face);
    s->face = face;
    if (grown) s->face[s->faces++] = s->corners;
    return grown;
}

static compas_solid solid(const compas_solids *s, int32_t b)
{
    const int32_t *at = s->block[b], *end = s->block[b + 1], last = b + 1 == s->blocks;
    const compas_solid one = { s->xyz + at[0], s->corner, s->face + at[1],
                               (last ? s->vertices : end[0]) - at[0], (last ? s->faces : end[1]) - at[1] - 1, at[0] };
    return one;
}

compas_solid compas_last(const compas_solids *s) { return solid(s, s->blocks - 1); }

static void subtract(const double a[3], const double b[3], double d[3]) { for (int k = 0; k < 3; k++) d[k] = a[k] - b[k]; }
static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* n += (a - o) x (b - o) */
static void add_triangle(const double o[3], const double a[3], const double b[3], double n[3])
{
    double d[3], e[3];
    subtract(a, o, d);
    subtract(b, o, e);
    for (int k = 0; k < 3; k++) n[k] += d[(k + 1) % 3] * e[(k + 2) % 3] - d[(k + 2) % 3] * e[(k + 1) % 3];
}

/* Twice the area of face i along its normal, and the mean of its corners. */
static void face_plane(const compas_solid *s, int32_t i, double n[3], double middle[3])
{
    const int32_t *c = s->corner + s->face[i], corners = s->face[i + 1] - s->face[i];
    for (int k = 0; k < 3; k++) n[k] = middle[k] = 0;
    for (int32_t q = 0; q < corners; q++) {
        if (q > 0 && q + 1 < corners) add_triangle(s->xyz[c[0]], s->xyz[c[q]], s->xyz[c[q + 1]], n);
        for (int k = 0; k < 3; k++) middle[k] += s->xyz[c[q]][k] / corners;
    }
}

/* Six times the volume, about a vertex: below 0 where faces look inward. */
static double volume(const compas_solid *s)
{
    double sum = 0;
    for (int32_t i = 0; i < s->faces; i++) {
        double n[3], middle[3], d[3];
        face_plane(s, i, n, middle);
        subtract(middle, s->xyz[0], d);
        sum += dot(d, n);
    }
    return sum;
}

int compas_add_box(compas_solids *s, const double middle[3], double half[3][3])
{
    static const int32_t face[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
                                        { 1, 3, 7, 5 } };      /* bits of a corner: x y z */
    int ok = compas_begin(s);
    for (int v = 0; v < 8 && ok; v++) {
        double x[3];
        for (int i = 0; i < 3; i++)
            x[i] = middle[i] + (v & 1 ? 1 : -1) * half[0][i] + (v & 2 ? 1 : -1) * half[1][i] + (v & 4 ? 1 : -1) * half[2][i];
        ok = compas_add_vertex(s, x);
    }
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 4; k++) ok = ok && compas_add_corner(s, face[i][k]);
        ok = ok && compas_end_face(s);
    }
    return ok;
}

static int make_unit(double x[3])
{
    const double most = fmax(fabs(x[0]), fmax(fabs(x[1]), fabs(x[2])));
    for (int k = 0; k < 3 && most > 0; k++) x[k] /= most;
    const double size = sqrt(dot(x, x));
    for (int k = 0; k < 3 && most > 0; k++) x[k] /= size;
    return most > 0;
}

static void cross(const double a[3], const double b[3], double n[3])
{
    for (int k = 0; k < 3; k++) n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

int compas_unit_axes(double axis[3][3])
{
    if (!make_unit(axis[0]) || !make_unit(axis[1])) return 0;
    cross(axis[0], axis[1], axis[2]);
    if (!(dot(axis[2], axis[2]) > PARALLEL * PARALLEL)) return 0;
    make_unit(axis[2]);
    cross(axis[2], axis[0], axis[1]);
    return 1;
}

void compas_end(compas_solids *s, const double frame[12])
{
    const compas_solid one = compas_last(s);
    for (int32_t v = 0; v < one.vertices; v++) {
        double x[3];
        memcpy(x, one.xyz[v], sizeof x);
        for (int k = 0; k < 3; k++) one.xyz[v][k] = dot(frame + 4 * k, x) + frame[4 * k + 3];
    }
    if (one.vertices == 0 || !(volume(&one) < 0)) return;
    for (int32_t i = 0; i < one.faces; i++)
        for (int32_t a = one.face[i], b = one.face[i + 1] - 1; a < b; a++, b--) {
            const int32_t swap = s->corner[a];
            s->corner[a] = s->corner[b];
            s->corner[b] = swap;
        }
}

/* Along the unit normal n, the outward normal of the face that lies best in the polygon's plane: its sign is what counts. */
static double facing(const compas_solid *s, const double n[3], const double middle[3])
{
    double best = HUGE_VAL, along = 0;
    for (int32_t i = 0; i < s->faces; i++) {
        double m[3], at[3], d[3];
        face_plane(s, i, m, at);
        const double size = sqrt(dot(m, m));
        if (!(size > 0)) continue;
        subtract(middle, at, d);
        const double c = dot(m, n) / size, score = fabs(dot(d, m)) / size / (fabs(c) + 1e-9) + (1 - fabs(c));
        if (score < best) { best = score; along = c; }
    }
    return along;
}

static void mean(double (*x)[3], int32_t n, double m[3])
{
    for (int k = 0; k < 3; k++) m[k] = 0;
    for (int32_t i = 0; i < n; i++) for (int k = 0; k < 3; k++) m[k] += x[i][k] / n;
}

int compas_is_turned(const compas_solids *s, int32_t a, int32_t b, double (*x)[3], int32_t n)
{
    const compas_solid A = solid(s, a), B = solid(s, b);
    double m[3] = { 0, 0, 0 }, middle[3], at[2][3], d[3];
    for (int32_t k = 1; k + 1 < n; k++) add_triangle(x[0], x[k], x[k + 1], m);
    const double size = sqrt(dot(m, m));
    if (!(size > 0)) return 0;
    for (int k = 0; k < 3; k++) m[k] /= size;
    mean(x, n, middle);
    const double side = facing(&A, m, middle) - facing(&B, m, middle);
    mean(A.xyz, A.vertices, at[0]);
    mean(B.xyz, B.vertices, at[1]);
    subtract(at[1], at[0], d);
    return fabs(side) > 0.5 ? side < 0 : dot(m, d) < 0;
}

void compas_free(compas_solids *s)
{
    free(s->xyz);
    free(s->corner);
    free(s->face);
    free(s->block);
}
