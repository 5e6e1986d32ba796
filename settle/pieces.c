/* Convex pieces: clipping of convex solids by planes, and a binary space partition that cuts any solid into such.
 *
 * A solid is a bag of polygons. A corner that a plane makes on an edge is computed from the edge's ends in a fixed order, so the
 * two polygons at the edge get the same numbers and pieces stay closed.
 */
#include "pieces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

int pieces_finite(const double *x, size_t n)
{
    for (size_t k = 0; k < n; k++)
        if (!(fabs(x[k]) < 1e100)) return 0;
    return 1;
}

void pieces_free(pieces_solid *s)
{
    free(s->size);
    free(s->xyz);
    memset(s, 0, sizeof *s);
}

static int reserve(pieces_solid *s, int32_t faces, int32_t corners)
{
    if (faces > s->face_room) {
        int32_t *size = realloc(s->size, 2 * (size_t)faces * sizeof *size);
        if (!size) return 0;
        s->size = size;
        s->face_room = 2 * faces;
    }
    if (corners > s->corner_room) {
        double (*xyz)[3] = realloc(s->xyz, 2 * (size_t)corners * sizeof *xyz);
        if (!xyz) return 0;
        s->xyz = xyz;
        s->corner_room = 2 * corners;
    }
    return 1;
}

int pieces_add(pieces_solid *s, int32_t n, const double (*xyz)[3])
{
    if (!reserve(s, s->faces + 1, s->corners + n)) return 0;
    memcpy(s->xyz + s->corners, xyz, (size_t)n * sizeof *xyz);
    s->size[s->faces++] = n;
    s->corners += n;
    return 1;
}

int pieces_mesh(pieces_solid *s, const settle_mesh *mesh)
{
    const int32_t *corner = mesh->corner;
    for (int32_t f = 0; f < mesh->faces; f++) {
        if (!reserve(s, s->faces + 1, s->corners + mesh->size[f])) return 0;
        s->size[s->faces++] = mesh->size[f];
        for (int32_t k = 0; k < mesh->size[f]; k++) memcpy(s->xyz[s->corners++], mesh->xyz + 3 * (size_t)*corner++, sizeof *s->xyz);
    }
    return 1;
}

int pieces_box(pieces_solid *s, const double low[3], const double high[3])
{
    static const int side[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
    double q[4][3];
    memset(s, 0, sizeof *s);
    for (int f = 0; f < 6; f++) {
        for (int k = 0; k < 4; k++)
            for (int c = 0; c < 3; c++) q[k][c] = side[f][k] >> c & 1 ? high[c] : low[c];
        if (!pieces_add(s, 4, (const double (*)[3])q)) {
            pieces_free(s);
            return 0;
        }
    }
    return 1;
}

/* sum over the polygon's edges, about its first corner: 2 area n = sum (p - o) x (q - o)                     [Newell] */
void pieces_normal(int32_t corners, const double (*xyz)[3], double n[3])
{
    n[0] = n[1] = n[2] = 0;
    for (int32_t k = 1; k + 1 < corners; k++) {
        double p[3], q[3];
        for (int c = 0; c < 3; c++) p[c] = xyz[k][c] - xyz[0][c], q[c] = xyz[k + 1][c] - xyz[0][c];
        for (int c = 0; c < 3; c++) n[c] += p[(c + 1) % 3] * q[(c + 2) % 3] - p[(c + 2) % 3] * q[(c + 1) % 3];
    }
}

/* Length of a vector, which becomes of length 1. */
static double unit(double n[3])
{
    const double length = sqrt(dot(n, n));
    for (int c = 0; c < 3 && length > 0; c++) n[c] /= length;
    return length;
}

/* v = n x e for the axis e farthest from n, u = v x n */
void pieces_axes(const double n[3], double u[3], double v[3])
{
    double e[3] = { 0, 0, 0 };
    int low = 0;
    for (int c = 1; c < 3; c++)
        if (fabs(n[c]) < fabs(n[low])) low = c;
    e[low] = 1;
    for (int c = 0; c < 3; c++) v[c] = n[(c + 1) % 3] * e[(c + 2) % 3] - n[(c + 2) % 3] * e[(c + 1) % 3];
    for (int c = 0; c < 3; c++) u[c] = v[(c + 1) % 3] * n[(c + 2) % 3] - v[(c + 2) % 3] * n[(c + 1) % 3];
}

static int plane_around(const settle_mesh *m, int32_t corners, const double (*q)[3], pieces_plane *p)
{
    double low = HUGE_VAL;
    pieces_normal(corners, q, p->n);
    if (!(unit(p->n) > 0)) return 0;
    p->d = -HUGE_VAL;
    for (int32_t k = 0; k < m->vertices; k++) {
        const double h = dot(p->n, m->xyz + 3 * (size_t)k);
        p->d = fmax(p->d, h);
        low = fmin(low, h);
    }
    p->width = p->d - low;
    return 1;
}

int pieces_planes(const settle_mesh *mesh, pieces_plane **plane, int32_t *planes)
{
    pieces_solid s = { 0, 0, 0, 0, NULL, NULL };
    const int whole = pieces_mesh(&s, mesh);
    const double (*q)[3] = (const double (*)[3])s.xyz;
    *planes = 0;
    *plane = malloc(((size_t)mesh->faces + 1) * sizeof **plane);
    for (int32_t f = 0; whole && *plane && f < s.faces; q += s.size[f++])
        *planes += plane_around(mesh, s.size[f], q, &(*plane)[*planes]);
    pieces_free(&s);
    return whole && *plane;
}

/* Where the edge p q meets the plane; the same bits for q p. hp, hq: heights over the plane, of different sign. */
static void cross(const double p[3], double hp, const double q[3], double hq, double x[3])
{
    const int swap = memcmp(p, q, 3 * sizeof *p) > 0;
    const double *a = swap ? q : p, *b = swap ? p : q, ha = swap ? hq : hp, hb = swap ? hp : hq, t = ha / (ha - hb);
    for (int c = 0; c < 3; c++) x[c] = a[c] + t * (b[c] - a[c]);
}

/* The part of a polygon at or under the plane n . x = d, at most 2 n corners.        [Sutherland, Hodgman 1974] */
static int32_t under(int32_t n, const double (*q)[3], const double normal[3], double d, double eps, double (*out)[3])
{
    int32_t m = 0, below = 0;
    for (int32_t k = 0; k < n; k++) {
        const int32_t next = (k + 1) % n;
        const double h = dot(normal, q[k]) - d, g = dot(normal, q[next]) - d;
        if (h <= eps) memcpy(out[m++], q[k], sizeof *out);
        if (h < -eps) below++;
        if ((h < -eps && g > eps) || (h > eps && g < -eps)) cross(q[k], h, q[next], g, out[m++]);
    }
    return below ? m : 0;
}

typedef struct around { double angle, x[3]; } around;

static int by_angle(const void *pa, const void *pb)
{
    const around *a = pa, *b = pb;
    return (a->angle > b->angle) - (a->angle < b->angle);
}

/* The lid where a plane cut: its corners lie around their mean, anticlockwise seen from outside. */
static int add_lid(pieces_solid *s, const double normal[3], double d, double eps)
{
    around *p = malloc(((size_t)s->corners + 1) * sizeof *p);
    double mean[3] = { 0, 0, 0 }, u[3], v[3], (*q)[3] = NULL;
    int32_t n = 0, m = 0;
    int good = p != NULL;

    for (int32_t k = 0; good && k < s->corners; k++) {
        int fresh = fabs(dot(normal, s->xyz[k]) - d) <= 2 * eps;
        for (int32_t i = 0; fresh && i < n; i++)
            fresh = fabs(p[i].x[0] - s->xyz[k][0]) > eps || fabs(p[i].x[1] - s->xyz[k][1]) > eps || fabs(p[i].x[2] - s->xyz[k][2]) > eps;
        if (fresh) memcpy(p[n++].x, s->xyz[k], sizeof mean);
    }
    if (!good || n < 3) {
        free(p);
        return good;
    }
    for (int32_t i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) mean[c] += p[i].x[c] / n;
    pieces_axes(normal, u, v);
    for (int32_t i = 0; i < n; i++) {
        double r[3];
        for (int c = 0; c < 3; c++) r[c] = p[i].x[c] - mean[c];
        p[i].angle = atan2(dot(v, r), dot(u, r));
    }
    qsort(p, (size_t)n, sizeof *p, by_angle);
    q = malloc((size_t)n * sizeof *q);
    good = q != NULL;
    for (int32_t i = 0; good && i < n; i++) memcpy(q[m++], p[i].x, sizeof *q);
    good = good && pieces_add(s, m, (const double (*)[3])q);
    free(q);
    free(p);
    return good;
}

int pieces_clip(const pieces_solid *s, const double n[3], double d, double eps, pieces_solid *out)
{
    int32_t cut = 0, level = 0;
    const double (*q)[3] = (const double (*)[3])s->xyz;
    out->faces = out->corners = 0;
    for (int32_t f = 0; f < s->faces; q += s->size[f++]) {
        int32_t m, on = 0;
        if (!reserve(out, out->faces + 1, out->corners + 2 * s->size[f])) return 0;
        for (int32_t k = 0; k < s->size[f]; k++) {
            const double h = dot(n, q[k]) - d;
            cut |= h > eps;
            on += h <= eps && h >= -eps;
        }
        level |= on == s->size[f];
        m = on == s->size[f] ? 0 : under(s->size[f], q, n, d, eps, out->xyz + out->corners);
        if (m < 3) {
            if (on == s->size[f] && !pieces_add(out, s->size[f], q)) return 0;
            continue;
        }
        out->size[out->faces++] = m;
        out->corners += m;
    }
    if (level && !cut) return 1;                /* it ends at the plane already */
    if (level) {                                /* it begins there: nothing is under it */
        out->faces = out->corners = 0;
        return 1;
    }
    return !cut || out->faces == 0 || add_lid(out, n, d, eps);
}

/* ------------------------------------------------------------------------------------------------------------ splitting */

/* A mesh being cut: its polygons in new numbers, and the pieces found. */
typedef struct cutter {
    pieces_solid mesh;          /* to ask whether a point is inside */
    double size, eps;           /* its diagonal; thickness of a plane [m] */
    pieces_solid *piece;
    int32_t pieces;
    settle_status status;
} cutter;

/* Solid angle of the mesh seen from x, 4 pi inside and 0 outside, by triangles (a, b, c) from x:
 * tan(imbalance/2) = a.(b x c) / (abc + (a.b) c + (b.c) a + (c.a) b)                                 [van Oosterom 1983] */
static int inside(const cutter *t, const double x[3])
{
    const double (*q)[3] = (const double (*)[3])t->mesh.xyz;
    double sum = 0;
    for (int32_t f = 0; f < t->mesh.faces; q += t->mesh.size[f++])
        for (int32_t k = 1; k + 1 < t->mesh.size[f]; k++) {
            double r[3][3], l[3], det;
            for (int i = 0; i < 3; i++) {
                for (int c = 0; c < 3; c++) r[i][c] = q[i ? k + i - 1 : 0][c] - x[c];
                l[i] = sqrt(dot(r[i], r[i]));
            }
            det = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) + r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2])
                + r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
            sum += 2 * atan2(det, l[0] * l[1] * l[2] + dot(r[0], r[1]) * l[2] + dot(r[1], r[2]) * l[0] + dot(r[2], r[0]) * l[1]);
        }
    return sum > 6.283185307179586;             /* half of 4 pi */
}

/* A cell without a face of the mesh within is all stone or all air. */
static void leaf(cutter *t, pieces_solid *cell)
{
    double x[3] = { 0, 0, 0 };
    for (int32_t k = 0; k < cell->corners; k++)
        for (int c = 0; c < 3; c++) x[c] += cell->xyz[k][c] / cell->corners;
    if (cell->faces >= 4 && inside(t, x)) {
        if (t->pieces == SETTLE_PIECES) t->status = SETTLE_E_PIECES;
        else {
            t->piece[t->pieces++] = *cell;
            memset(cell, 0, sizeof *cell);
        }
    }
    pieces_free(cell);
}

/* How polygons lie to a plane: some before it, some behind, some through. */
typedef struct sides { int32_t before, behind, through; } sides;

static sides count_sides(const pieces_solid *bag, const double n[3], double d, double eps)
{
    const double (*q)[3] = (const double (*)[3])bag->xyz;
    sides s = { 0, 0, 0 };
    for (int32_t f = 0; f < bag->faces; q += bag->size[f++]) {
        int up = 0, down = 0;
        for (int32_t k = 0; k < bag->size[f]; k++) {
            const double h = dot(n, q[k]) - d;
            up |= h > eps;
            down |= h < -eps;
        }
        s.through += up && down;
        s.before += up && !down;
        s.behind += down && !up;
    }
    return s;
}

static double plane_of(int32_t n, const double (*q)[3], double normal[3])
{
    double d = 0;
    pieces_normal(n, q, normal);
    unit(normal);
    for (int32_t k = 0; k < n; k++) d += dot(normal, q[k]) / n;
    return d;
}

/* The plane of one of the polygons that cuts fewest others; one with nothing before it cuts off air and is best. */
static double choose_plane(const cutter *t, const pieces_solid *bag, double best[3], int32_t *which)
{
    const double (*q)[3] = (const double (*)[3])bag->xyz;
    double best_d = 0, least = HUGE_VAL;
    for (int32_t f = 0; f < bag->faces; q += bag->size[f++]) {
        double n[3], score;
        const double d = plane_of(bag->size[f], q, n);
        const sides s = count_sides(bag, n, d, t->eps);
        score = s.before + s.through == 0 ? -1 : 16.0 * s.through + abs(s.before - s.behind);
        if (score >= least) continue;
        least = score;
        best_d = d;
        *which = f;
        memcpy(best, n, sizeof n);
    }
    return best_d;
}

/* The polygons of a bag on one side of a plane, slivers and what lies in the plane left out. */
static int take_side(const cutter *t, const pieces_solid *bag, int32_t but, const double n[3], double d, pieces_solid *out)
{
    const double (*q)[3] = (const double (*)[3])bag->xyz;
    memset(out, 0, sizeof *out);
    for (int32_t f = 0; f < bag->faces; q += bag->size[f++]) {
        double normal[3];
        int32_t m;
        if (f == but) continue;
        if (!reserve(out, out->faces + 1, out->corners + 2 * bag->size[f])) return 0;
        m = under(bag->size[f], q, n, d, t->eps, out->xyz + out->corners);
        if (m < 3) continue;
        pieces_normal(m, (const double (*)[3])(out->xyz + out->corners), normal);
        if (sqrt(dot(normal, normal)) < t->eps * t->size) continue;
        out->size[out->faces++] = m;
        out->corners += m;
    }
    return 1;
}

#define MOST_DEPTH 4096                         /* planes above a cell; each uses up a face at least, pieces end it earlier */

/* Cut the cell by a plane of the polygons within, and so on on both sides. Owns cell and bag. */
static void partition(cutter *t, pieces_solid *cell, pieces_solid *bag, int depth)
{
    double n[3] = { 0, 0, 1 }, back[3];
    int32_t which = -1;
    const double d = choose_plane(t, bag, n, &which);
    pieces_solid half[2] = { { 0, 0, 0, 0, NULL, NULL }, { 0, 0, 0, 0, NULL, NULL } }, rest[2];

    memset(rest, 0, sizeof rest);
    if (which < 0 || cell->faces < 4) {
        leaf(t, cell);
        pieces_free(bag);
        return;
    }
    for (int c = 0; c < 3; c++) back[c] = -n[c];
    if (depth == MOST_DEPTH) t->status = SETTLE_E_PIECES;
    else if (!pieces_clip(cell, n, d, t->eps, &half[0]) || !pieces_clip(cell, back, -d, t->eps, &half[1])
             || !take_side(t, bag, which, n, d, &rest[0]) || !take_side(t, bag, which, back, -d, &rest[1]))
        t->status = SETTLE_E_MEMORY;
    pieces_free(cell);
    pieces_free(bag);
    for (int k = 0; k < 2; k++) {
        if (!t->status) partition(t, &half[k], &rest[k], depth + 1);
        pieces_free(&half[k]);
        pieces_free(&rest[k]);
    }
}

static int is_convex(const pieces_solid *m, double slack)
{
    const double (*q)[3] = (const double (*)[3])m->xyz;
    for (int32_t f = 0; f < m->faces; q += m->size[f++]) {
        double n[3];
        const double d = plane_of(m->size[f], q, n);
        if (!(dot(n, n) > 0)) continue;
        for (int32_t k = 0; k < m->corners; k++)
            if (dot(n, m->xyz[k]) > d + slack) return 0;
    }
    return 1;
}

/* All pieces as meshes in one allocation: each polygon has its own vertices, which are numbered in order. */
static settle_status hand_over(const pieces_solid *solid, int32_t pieces, settle_mesh **out)
{
    size_t corners = 0, faces = 0, bytes;
    settle_mesh *mesh;
    double *xyz;
    int32_t *size, *corner;

    for (int32_t p = 0; p < pieces; p++) corners += (size_t)solid[p].corners, faces += (size_t)solid[p].faces;
    bytes = (size_t)pieces * sizeof *mesh + 3 * corners * sizeof *xyz + (faces + corners) * sizeof *size;
    mesh = malloc(bytes);
    if (!mesh) return SETTLE_E_MEMORY;
    xyz = (double *)(void *)(mesh + pieces);
    size = (int32_t *)(void *)(xyz + 3 * corners);
    corner = size + faces;
    for (int32_t p = 0; p < pieces; p++) {
        const pieces_solid *s = &solid[p];
        mesh[p].vertices = s->corners;
        mesh[p].faces = s->faces;
        mesh[p].xyz = memcpy(xyz, s->xyz, (size_t)s->corners * sizeof *s->xyz);
        mesh[p].size = memcpy(size, s->size, (size_t)s->faces * sizeof *s->size);
        mesh[p].corner = corner;
        for (int32_t k = 0; k < s->corners; k++) corner[k] = k;
        xyz += 3 * (size_t)s->corners;
        size += s->faces;
        corner += s->corners;
    }
    *out = mesh;
    return SETTLE_OK;
}

/* Six times the volume, about the first corner. */
static double volume6(const pieces_solid *s)
{
    const double (*q)[3] = (const double (*)[3])s->xyz;
    double sum = 0;
    for (int32_t f = 0; f < s->faces; q += s->size[f++]) {
        double n[3], r[3];
        pieces_normal(s->size[f], q, n);
        for (int c = 0; c < 3; c++) r[c] = q[0][c] - s->xyz[0][c];
        sum += dot(n, r);
    }
    return sum;
}

static settle_status gather(const settle_mesh *m, cutter *t, double low[3], double high[3])
{
    int32_t at = 0;
    if (!m || m->vertices < 4 || m->faces < 4 || !m->xyz || !m->size || !m->corner) return SETTLE_E_MESH;
    for (int c = 0; c < 3; c++) low[c] = HUGE_VAL, high[c] = -HUGE_VAL;
    for (int32_t f = 0; f < m->faces; f++) {
        if (m->size[f] < 3 || m->size[f] > 3 * (int64_t)m->vertices + 64) return SETTLE_E_MESH;
        if (!reserve(&t->mesh, f + 1, t->mesh.corners + m->size[f])) return SETTLE_E_MEMORY;
        for (int32_t k = 0; k < m->size[f]; k++, at++) {
            double *x = t->mesh.xyz[t->mesh.corners++];
            if (m->corner[at] < 0 || m->corner[at] >= m->vertices) return SETTLE_E_MESH;
            memcpy(x, m->xyz + 3 * (size_t)m->corner[at], 3 * sizeof *x);
            for (int c = 0; c < 3; c++) {
                if (!(fabs(x[c]) < 1e100)) return SETTLE_E_NUMBER;
                low[c] = fmin(low[c], x[c]);
                high[c] = fmax(high[c], x[c]);
            }
        }
        t->mesh.size[t->mesh.faces++] = m->size[f];
    }
    t->size = sqrt((high[0] - low[0]) * (high[0] - low[0]) + (high[1] - low[1]) * (high[1] - low[1])
                   + (high[2] - low[2]) * (high[2] - low[2]));
    return volume6(&t->mesh) > 1e-9 * t->size * t->size * t->size ? SETTLE_OK : SETTLE_E_MESH;
}

/* The cell that holds the mesh is cut; a copy of the mesh guides the cuts. */
static void cut_up(cutter *t, const double low[3], const double high[3])
{
    pieces_solid cell, bag = { 0, 0, 0, 0, NULL, NULL };
    double wide[2][3];
    for (int c = 0; c < 3; c++) wide[0][c] = low[c] - 0.1 * t->size, wide[1][c] = high[c] + 0.1 * t->size;
    if (!pieces_box(&cell, wide[0], wide[1])) {
        t->status = SETTLE_E_MEMORY;
        return;
    }
    if (!reserve(&bag, t->mesh.faces, t->mesh.corners)) {
        pieces_free(&cell);
        pieces_free(&bag);
        t->status = SETTLE_E_MEMORY;
        return;
    }
    bag.faces = t->mesh.faces;
    bag.corners = t->mesh.corners;
    memcpy(bag.size, t->mesh.size, (size_t)bag.faces * sizeof *bag.size);
    memcpy(bag.xyz, t->mesh.xyz, (size_t)bag.corners * sizeof *bag.xyz);
    partition(t, &cell, &bag, 0);
}

/* Add the pieces of a mesh to those found. */
static void cut_mesh(cutter *t, const settle_mesh *mesh, double flat)
{
    const int32_t before = t->pieces;
    double low[3], high[3];
    t->mesh.faces = t->mesh.corners = 0;
    t->status = gather(mesh, t, low, high);
    t->eps = 1e-6 * t->size;
    if (t->status) return;
    if (!is_convex(&t->mesh, flat * t->size)) cut_up(t, low, high);
    else if (t->pieces == SETTLE_PIECES) t->status = SETTLE_E_PIECES;
    else {
        t->piece[t->pieces++] = t->mesh;
        memset(&t->mesh, 0, sizeof t->mesh);
    }
    if (!t->status && t->pieces == before) t->status = SETTLE_E_MESH;
}

static settle_status start(cutter *t)
{
    memset(t, 0, sizeof *t);
    t->piece = calloc(SETTLE_PIECES, sizeof *t->piece);
    return t->piece ? SETTLE_OK : SETTLE_E_MEMORY;
}

static settle_status finish(cutter *t, settle_mesh **piece, int32_t *pieces)
{
    if (!t->status) t->status = hand_over(t->piece, t->pieces, piece);
    if (!t->status) *pieces = t->pieces;
    for (int32_t p = 0; p < t->pieces; p++) pieces_free(&t->piece[p]);
    free(t->piece);
    pieces_free(&t->mesh);
    return t->status;
}

settle_status settle_split(const settle_mesh *mesh, double flat, settle_mesh **piece, int32_t *pieces)
{
    cutter t;
    if (!piece || !pieces || !(flat >= 0)) return SETTLE_E_ARGUMENT;
    if (start(&t)) return SETTLE_E_MEMORY;
    cut_mesh(&t, mesh, flat);
    return finish(&t, piece, pieces);
}

/* The face's polygon, the same one behind it looking back, and a side at each edge. */
static void add_plate(cutter *t, const settle_mesh *mesh, const int32_t *corner, int32_t n, double thickness)
{
    double (*x)[3] = malloc(2 * (size_t)n * sizeof *x), normal[3];
    int32_t *size = malloc((7 * (size_t)n + 2) * sizeof *size), *id = size + n + 2;
    settle_mesh plate = { 2 * n, n + 2, NULL, size, id };

    t->status = x && size ? SETTLE_OK : SETTLE_E_MEMORY;
    for (int32_t k = 0; k < n && !t->status; k++) {
        if (corner[k] < 0 || corner[k] >= mesh->vertices) t->status = SETTLE_E_MESH;
        else memcpy(x[k], mesh->xyz + 3 * (size_t)corner[k], sizeof *x);
    }
    if (!t->status) {
        pieces_normal(n, (const double (*)[3])x, normal);
        unit(normal);
        for (int32_t k = 0; k < n; k++) {
            const int32_t next = (k + 1) % n, side[4] = { k, k + n, next + n, next };
            for (int c = 0; c < 3; c++) x[n + k][c] = x[k][c] - thickness * normal[c];
            id[k] = k;
            id[2 * n - 1 - k] = n + k;
            size[2 + k] = 4;
            memcpy(id + 2 * n + 4 * k, side, sizeof side);
        }
        size[0] = size[1] = n;
        plate.xyz = x[0];
        cut_mesh(t, &plate, 1e-3);
    }
    free(size);
    free(x);
}

settle_status settle_plates(const settle_mesh *mesh, double thickness, settle_mesh **piece, int32_t *pieces)
{
    cutter t;
    const int32_t *corner;
    if (!mesh || !mesh->xyz || !mesh->size || !mesh->corner || !piece || !pieces || !(thickness > 0)) return SETTLE_E_ARGUMENT;
    if (start(&t)) return SETTLE_E_MEMORY;
    if (mesh->faces < 1) t.status = SETTLE_E_MESH;
    corner = mesh->corner;
    for (int32_t f = 0; f < mesh->faces && !t.status; corner += mesh->size[f++]) {
        if (mesh->size[f] < 3) t.status = SETTLE_E_MESH;
        else add_plate(&t, mesh, corner, mesh->size[f], thickness);
    }
    return finish(&t, piece, pieces);
}

void settle_free(void *memory) { free(memory); }

const char *settle_status_text(settle_status status)
{
    switch (status) {
    case SETTLE_OK:         return "no error";
    case SETTLE_E_ARGUMENT: return "a null pointer, a count out of range, or a stone that does not exist";
    case SETTLE_E_MEMORY:   return "out of memory";
    case SETTLE_E_NUMBER:   return "an infinity or a NaN";
    case SETTLE_E_SETTINGS: return "a setting outside its range";
    case SETTLE_E_MESH:     return "a mesh that encloses no volume, or is too thin to be simulated";
    case SETTLE_E_PIECES:   return "too many convex pieces in one stone";
    case SETTLE_E_STOPPED:  return "stopped";
    case SETTLE_E_BODY:     return "a block without a mesh, or a free one whose mesh is open";
    case SETTLE_E_DIVERGED: return "the simulation left the finite numbers";
    case SETTLE_E_LOAD:     return "loads besides weight, mortar, and blocks held in some directions only are not simulated";
    }
    return "unknown status";
}
