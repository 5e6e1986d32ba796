#include "obj_names.h"
#include "solids.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WARPED 1e-2                     /* of a block's size: from there on faces become triangles; the library refuses more */
#define SHARPEST 1e-2                   /* [rad] no stone has a sharper edge: faces that meet at less lie on each other */

static int32_t faces_end(const obj_file *f, int32_t b) { return b + 1 < f->blocks ? f->block[b + 1].face : f->faces; }

static const sp_real *at(const obj_file *f, int32_t face, int32_t k)
{
    return f->vertex[f->corner[f->face[face].corner + k % f->face[face].corners]];
}

static int out_of_memory(const obj_file *f, failure *error)
{
    return fail_with(error, EXIT_MEMORY, f->path, 0, "out of memory while reading");
}

/* ---------------------------------------------------------------------------------------------------------- geometry */

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static int compare_place(const sp_real *x, const sp_real *y)
{
    for (int c = 0; c < 3; c++) if (x[c] < y[c] || x[c] > y[c]) return x[c] < y[c] ? -1 : 1;
    return 0;
}

/* n += (q - o) x (r - o), of which the sum over a polygon is twice its area along its normal (Newell). */
static void add_cross(double n[3], const sp_real *o, const sp_real *q, const sp_real *r)
{
    double a[3], b[3];
    for (int k = 0; k < 3; k++) a[k] = (double)q[k] - (double)o[k], b[k] = (double)r[k] - (double)o[k];
    for (int k = 0; k < 3; k++) n[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void face_normal(const obj_file *f, int32_t i, double n[3])
{
    n[0] = n[1] = n[2] = 0;
    for (int32_t k = 1; k + 1 < f->face[i].corners; k++) add_cross(n, at(f, i, 0), at(f, i, k), at(f, i, k + 1));
}

static void face_mean(const obj_file *f, int32_t i, double m[3])
{
    m[0] = m[1] = m[2] = 0;
    for (int32_t k = 0; k < f->face[i].corners; k++)
        for (int c = 0; c < 3; c++) m[c] += (double)at(f, i, k)[c] / f->face[i].corners;
}

/* Six times the volume under a face, seen from o; the sum over a block below 0: its faces look inwards. */
static double face_volume(const obj_file *f, int32_t i, const sp_real *o)
{
    double n[3], d[3];
    face_normal(f, i, n);
    for (int c = 0; c < 3; c++) d[c] = (double)at(f, i, 0)[c] - (double)o[c];
    return dot(n, d);
}

/* The box around faces. */
typedef struct box { double low[3], high[3]; } box;

static const box no_box = { { DBL_MAX, DBL_MAX, DBL_MAX }, { -DBL_MAX, -DBL_MAX, -DBL_MAX } };

static void box_add(const obj_file *f, int32_t i, box *a)
{
    for (int32_t k = 0; k < f->face[i].corners; k++)
        for (int c = 0; c < 3; c++) {
            a->low[c] = fmin(a->low[c], (double)at(f, i, k)[c]);
            a->high[c] = fmax(a->high[c], (double)at(f, i, k)[c]);
        }
}

static double box_size(const box *a)
{
    return fmax(a->high[0] - a->low[0], fmax(a->high[1] - a->low[1], a->high[2] - a->low[2]));
}

static int box_holds(const box *a, const box *b)
{
    for (int c = 0; c < 3; c++) if (b->low[c] < a->low[c] || b->high[c] > a->high[c]) return 0;
    return 1;
}

/* ------------------------------------------------------------------------------------------------------------- seams */

typedef struct placed { const sp_real *x; int32_t block, vertex; } placed;

static int compare_places(const void *pa, const void *pb)
{
    const placed *a = pa, *b = pb;
    if (a->block != b->block) return a->block < b->block ? -1 : 1;
    for (int c = 0; c < 3; c++) if (a->x[c] < b->x[c] || a->x[c] > b->x[c]) return a->x[c] < b->x[c] ? -1 : 1;
    return (a->vertex > b->vertex) - (a->vertex < b->vertex);
}

static int same_place(const placed *a, const placed *b)
{
    for (int c = 0; c < 3; c++) if (a->x[c] < b->x[c] || a->x[c] > b->x[c]) return 0;
    return a->block == b->block;
}

/* Corners that follow their own vertex go, and faces with less than three left. */
static void drop_empty_corners(obj_file *f)
{
    int32_t faces = 0, corners = 0;
    for (int32_t b = 0, i = 0; b < f->blocks; b++) {
        const int32_t end = faces_end(f, b);
        f->block[b].face = faces;
        for (; i < end; i++) {
            const obj_face old = f->face[i];
            obj_face new = { old.line, corners, 0 };
            for (int32_t k = 0; k < old.corners; k++) {
                const int32_t v = f->corner[old.corner + k];
                const int32_t last = new.corners ? corners + new.corners - 1 : old.corner + old.corners - 1;
                const int32_t before = f->corner[last];
                if (v != before) f->corner[corners + new.corners++] = v;
            }
            if (new.corners < 3) continue;
            f->face[faces++] = new;
            corners += new.corners;
        }
    }
    f->faces = faces;
    f->corners = corners;
}

static int weld(obj_file *f)
{
    placed *sorted = malloc(((size_t)f->corners + 1) * sizeof *sorted);
    int32_t *one = malloc(((size_t)f->vertices + 1) * sizeof *one), n = 0;

    for (int32_t b = 0; sorted && one && b < f->blocks; b++)
        for (int32_t i = f->block[b].face; i < faces_end(f, b); i++)
            for (int32_t k = 0; k < f->face[i].corners; k++) {
                const placed p = { at(f, i, k), b, f->corner[f->face[i].corner + k] };
                sorted[n++] = p;
            }
    if (sorted && one) {
        qsort(sorted, (size_t)n, sizeof *sorted, compare_places);
        for (int32_t i = 0; i < n; i++)
            one[sorted[i].vertex] = i && same_place(&sorted[i], &sorted[i - 1]) ? one[sorted[i - 1].vertex] : sorted[i].vertex;
        for (int32_t i = 0; i < f->corners; i++) f->corner[i] = one[f->corner[i]];
        drop_empty_corners(f);
    }
    free(sorted);
    free(one);
    return sorted && one;
}

static void turn_face(obj_file *f, int32_t i)
{
    int32_t *c = f->corner + f->face[i].corner;
    for (int32_t k = 0, m = f->face[i].corners - 1; k < m; k++, m--) {
        const int32_t keep = c[k];
        c[k] = c[m];
        c[m] = keep;
    }
}

static void turn_inward_block(obj_file *f, int32_t b)
{
    const int32_t first = f->block[b].face, end = faces_end(f, b);
    double sum = 0;
    for (int32_t i = first; i < end; i++) sum += face_volume(f, i, at(f, first, 0));
    for (int32_t i = first; i < end && sum < 0; i++) turn_face(f, i);
}

/* ---------------------------------------------------------------------------------------------------------- contacts */

/* Along n (a unit vector), the outward unit normal of the face of block b that lies best in the plane at m across n. */
static double nearest_normal(const obj_file *f, int32_t b, const double m[3], const double n[3])
{
    double best = DBL_MAX, found = 0;
    for (int32_t i = f->block[b].face; i < faces_end(f, b); i++) {
        double k[3], d[3];
        face_normal(f, i, k);
        const double size = sqrt(dot(k, k));
        for (int c = 0; c < 3; c++) d[c] = m[c] - (double)at(f, i, 0)[c];
        const double cosine = size > 0 ? dot(k, n) / size : 0, away = size > 0 ? fabs(dot(d, k)) / size : DBL_MAX;
        const double score = away / (fabs(cosine) + 1e-9) + (1 - fabs(cosine));
        if (score < best) best = score, found = cosine;
    }
    return found;
}

/* Does the polygon's normal leave A and enter B? By the faces in its plane, which holds for concave blocks, too. */
static int points_into_b(const obj_file *f, const obj_contact *c)
{
    double n[3] = { 0, 0, 0 }, m[3] = { 0, 0, 0 }, between[3] = { 0, 0, 0 }, mean[3];
    sp_real (*p)[3] = f->point + c->point;
    for (int32_t k = 1; k + 1 < c->points; k++) add_cross(n, p[0], p[k], p[k + 1]);
    for (int32_t k = 0; k < c->points; k++) for (int i = 0; i < 3; i++) m[i] += (double)p[k][i] / c->points;
    const double size = sqrt(dot(n, n));
    if (!(size > 0)) return 1;
    for (int i = 0; i < 3; i++) n[i] /= size;
    const double sign = nearest_normal(f, c->a, m, n) - nearest_normal(f, c->b, m, n);
    if (fabs(sign) > 0.5) return sign > 0;
    for (int side = 0; side < 2; side++) {
        const int32_t b = side ? c->b : c->a;
        for (int32_t i = f->block[b].face; i < faces_end(f, b); i++) {
            face_mean(f, i, mean);
            for (int k = 0; k < 3; k++) between[k] += (side ? mean[k] : -mean[k]) / (faces_end(f, b) - f->block[b].face);
        }
    }
    return dot(n, between) > 0;
}

static void turn_contacts(obj_file *f)
{
    for (int32_t i = 0; i < f->contacts; i++) {
        const obj_contact *c = &f->contact[i];
        sp_real (*p)[3] = f->point + c->point, keep[3];
        if (!c->polygon || points_into_b(f, c)) continue;
        for (int32_t k = 0, m = c->points - 1; k < m; k++, m--) {
            memcpy(keep, p[k], sizeof keep);
            memcpy(p[k], p[m], sizeof keep);
            memcpy(p[m], keep, sizeof keep);
        }
    }
}

int solids_tidy(obj_file *f)
{
    if (!weld(f)) return 0;
    for (int32_t b = 0; b < f->blocks; b++) turn_inward_block(f, b);
    turn_contacts(f);
    return 1;
}

/* ------------------------------------------------------------------------------------------------------------ warped */

/* How far a corner lies from the plane through the mean of all, across their normal. */
static double warp_of(const obj_file *f, int32_t i)
{
    double n[3], m[3], d[3], most = 0;
    if (f->face[i].corners == 3) return 0;
    face_normal(f, i, n);
    face_mean(f, i, m);
    for (int32_t k = 0; k < f->face[i].corners; k++) {
        for (int c = 0; c < 3; c++) d[c] = (double)at(f, i, k)[c] - m[c];
        most = fmax(most, fabs(dot(d, n)));
    }
    return dot(n, n) > 0 ? most / sqrt(dot(n, n)) : 0;
}

/* Would triangles from corner k all look the way the face does? */
static int fans_well(const obj_file *f, int32_t i, int32_t k)
{
    double n[3], t[3];
    face_normal(f, i, n);
    for (int32_t j = 1; j + 1 < f->face[i].corners; j++) {
        t[0] = t[1] = t[2] = 0;
        add_cross(t, at(f, i, k), at(f, i, k + j), at(f, i, k + j + 1));
        if (!(dot(t, n) > 0)) return 0;
    }
    return 1;
}

/* Of the corners to fan from the one that is first by its coordinates, so that faces that meet are cut alike.   -1: none */
static int32_t fan_corner(const obj_file *f, int32_t i)
{
    int32_t first = -1;
    for (int32_t k = 0; k < f->face[i].corners; k++) {
        const placed here = { at(f, i, k), 0, k }, best = { first < 0 ? here.x : at(f, i, first), 0, first };
        if (fans_well(f, i, k) && (first < 0 || compare_places(&here, &best) < 0)) first = k;
    }
    return first;
}

/* Where a face is to be cut from, -1: it stays. */
static int32_t cut_from(const obj_file *f, int32_t i, double size)
{
    return warp_of(f, i) > WARPED * size ? fan_corner(f, i) : -1;
}

static double block_size(const obj_file *f, int32_t b)
{
    box around = no_box;
    for (int32_t i = f->block[b].face; i < faces_end(f, b); i++) box_add(f, i, &around);
    return box_size(&around);
}

/* Loads count the faces of their block. */
static int is_pressed(const obj_file *f, int32_t b)
{
    for (int32_t i = 0; i < f->loads; i++) if (f->load[i].kind == OBJ_PRESSURE && f->load[i].block == b) return 1;
    return 0;
}

/* Append face i, from corner `from` as a fan, as it is if that is -1. */
static void copy_face(const obj_file *f, int32_t i, int32_t from, obj_face *face, int32_t *faces, int32_t *corner,
                      int32_t *corners)
{
    const obj_face old = f->face[i];
    const int32_t *c = f->corner + old.corner;
    const int32_t pieces = from < 0 ? 1 : old.corners - 2;
    for (int32_t j = 0; j < pieces; j++) {
        const obj_face piece = { old.line, *corners, from < 0 ? old.corners : 3 };
        face[(*faces)++] = piece;
        if (from < 0) memcpy(corner + *corners, c, (size_t)old.corners * sizeof *c);
        else for (int32_t k = 0; k < 3; k++) corner[*corners + k] = c[(from + (k ? j + k : 0)) % old.corners];
        *corners += piece.corners;
    }
}

/* The corners of a face from the first by its place, towards the lesser of its neighbours: alike for faces that meet. */
typedef struct ring { const obj_file *f; int32_t face, from, back; } ring;

static const sp_real *ring_at(const ring *r, int32_t k)
{
    return at(r->f, r->face, r->from + (r->back ? r->f->face[r->face].corners - k : k));
}

static ring make_ring(const obj_file *f, int32_t i)
{
    ring r = { f, i, 0, 0 };
    const int32_t n = f->face[i].corners;
    for (int32_t k = 1; k < n; k++) if (compare_place(at(f, i, k), at(f, i, r.from)) < 0) r.from = k;
    r.back = compare_place(at(f, i, r.from + n - 1), at(f, i, r.from + 1)) < 0;
    return r;
}

static int compare_corners(const ring *a, const ring *b)
{
    const int32_t n = a->f->face[a->face].corners, m = b->f->face[b->face].corners;
    int c = (n > m) - (n < m);
    for (int32_t k = 0; k < n && !c; k++) c = compare_place(ring_at(a, k), ring_at(b, k));
    return c;
}

static int compare_rings(const void *pa, const void *pb)
{
    const ring *a = pa, *b = pb;
    const int c = compare_corners(a, b);
    return c ? c : (a->face > b->face) - (a->face < b->face);
}

/* A face that meets one that is cut is cut, too, however large its block is.      returns 0: no memory */
static int cut_alike(const obj_file *f, int32_t *from)
{
    ring *list = malloc(((size_t)f->faces + 1) * sizeof *list);
    if (!list) return 0;
    for (int32_t i = 0; i < f->faces; i++) list[i] = make_ring(f, i);
    qsort(list, (size_t)f->faces, sizeof *list, compare_rings);
    for (int32_t i = 0, j; i < f->faces; i = j) {
        int cut = 0;
        for (j = i; j < f->faces && !compare_corners(&list[i], &list[j]); j++) cut |= from[list[j].face] >= 0;
        for (int32_t k = i; k < j && cut; k++) from[list[k].face] = fan_corner(f, list[k].face);
    }
    free(list);
    return 1;
}

/* Where each face is to be cut from.      returns how many are cut, -1: no memory */
static int32_t choose_cuts(const obj_file *f, int32_t *from, int32_t *blocks, int32_t *name)
{
    int32_t cut = 0;
    for (int32_t b = 0; b < f->blocks; b++) {
        const double size = block_size(f, b);
        for (int32_t i = f->block[b].face; i < faces_end(f, b); i++) cut += (from[i] = cut_from(f, i, size)) >= 0;
    }
    if (!cut) return 0;
    if (!cut_alike(f, from)) return -1;
    cut = 0;
    for (int32_t b = 0; b < f->blocks; b++) {
        const int pressed = is_pressed(f, b);
        const int32_t before = cut;
        for (int32_t i = f->block[b].face; i < faces_end(f, b); i++)
            if (pressed) from[i] = -1; else cut += from[i] >= 0;
        if (cut > before && !(*blocks)++) *name = b;
    }
    return cut;
}

static int cut_warped(obj_file *f, remarks *told, failure *error)
{
    int32_t *from = malloc(((size_t)f->faces + 1) * sizeof *from), blocks = 0, faces = 0, corners = 0, name = -1;
    const int32_t cut = from ? choose_cuts(f, from, &blocks, &name) : -1;
    const size_t most = (size_t)f->corners * 3 + 1;     /* of faces and corners after */
    obj_face *face = NULL;
    int32_t *corner = NULL;

    if (cut < 0) {
        free(from);
        return out_of_memory(f, error);
    }
    if (cut && (most > INT32_MAX || !(face = malloc(most * sizeof *face)) || !(corner = malloc(most * sizeof *corner)))) {
        free(from);
        free(face);
        return out_of_memory(f, error);
    }
    for (int32_t b = 0, i = 0; cut && b < f->blocks; b++) {
        const int32_t end = faces_end(f, b);
        f->block[b].face = faces;
        for (; i < end; i++) copy_face(f, i, from[i], face, &faces, corner, &corners);
    }
    free(from);
    if (!cut) return 0;
    free(f->face);
    free(f->corner);
    f->face = face;
    f->corner = corner;
    f->faces = faces;
    f->corners = corners;
    f->room.face = f->room.corner = (int32_t)most;
    const text_word w = f->block[name].name;
    remarks_add(told, NULL, "%ld warped face%s of %ld block%s, the first '%.*s', %s cut into triangles", (long)cut,
                cut > 1 ? "s" : "", (long)blocks, blocks > 1 ? "s" : "", (int)(w.n < 60 ? w.n : 60), w.s,
                cut > 1 ? "were" : "was");
    return 0;
}

/* ------------------------------------------------------------------------------------------------------------ shells */

/* The shells of a block: faces that meet at edges. */
typedef struct shell { double volume; box around; int32_t into, number; } shell;

/* An edge of a face between two places, p before q; forward: the face runs from p to q. */
typedef struct side { const sp_real *p, *q; int32_t face, corner; int forward; } side;

typedef struct shells {
    int32_t *root, *of;         /* of faces: of those that are joined the same; the shell, counted within its block */
    int32_t *at;                /* of vertices: a face with an edge that no other has */
    int32_t *count;             /* of each block, that move on their own */
    side *side;                 /* of the block being looked at */
    shell *each;                /* likewise */
} shells;

static int32_t find_root(int32_t *root, int32_t v)
{
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
}

static void join(shells *s, int32_t i, int32_t j) { s->root[find_root(s->root, i)] = find_root(s->root, j); }

static int compare_sides(const void *pa, const void *pb)
{
    const side *a = pa, *b = pb;
    const int p = compare_place(a->p, b->p), q = p ? p : compare_place(a->q, b->q);
    return q ? q : (a->corner > b->corner) - (a->corner < b->corner);
}

static int32_t list_sides(const obj_file *f, int32_t first, int32_t end, side *list)
{
    int32_t n = 0;
    for (int32_t i = first; i < end; i++)
        for (int32_t k = 0; k < f->face[i].corners; k++) {
            const sp_real *p = at(f, i, k), *q = at(f, i, k + 1);
            const int forward = compare_place(p, q) < 0;
            const side e = { forward ? p : q, forward ? q : p, i, f->face[i].corner + k, forward };
            list[n++] = e;
        }
    qsort(list, (size_t)n, sizeof *list, compare_sides);
    return n;
}

/* About the edge of side a, by how much one turns from its face through the stone to the face of b: up to 2 pi, which also is
 * what a face in the same place has, whatever is rounded. Into a face from its edge: n x edge; into the stone: -n. */
static double turn_to(const obj_file *f, const side *a, const side *b)
{
    double n[3], m[3], u[3], w[3], x = 0, y = 0;
    face_normal(f, a->face, n);
    face_normal(f, b->face, m);
    for (int c = 0; c < 3; c++) {
        const int d = (c + 1) % 3, e = (c + 2) % 3;
        const double ed = (double)a->q[d] - (double)a->p[d], ee = (double)a->q[e] - (double)a->p[e];
        u[c] = (n[d] * ee - n[e] * ed) * (a->forward ? 1 : -1);
        w[c] = (m[d] * ee - m[e] * ed) * (b->forward ? 1 : -1);
    }
    x = dot(u, w) * sqrt(dot(n, n));
    y = -dot(n, w) * sqrt(dot(u, u));
    const double turn = atan2(y, x);
    return turn > SHARPEST ? turn : turn + 2 * acos(-1.0);
}

/* The faces at one edge: each that runs forward goes with the first backward one through the stone. */
static void join_sides(const obj_file *f, const side *e, int32_t n, shells *s)
{
    int32_t forward = 0;
    for (int32_t i = 0; i < n; i++) forward += e[i].forward;
    for (int32_t i = 0; i < n; i++) {
        int32_t best = -1;
        double least = DBL_MAX;
        if (forward == 0 || forward == n) { join(s, e[i].face, e[0].face); continue; }
        if (!e[i].forward) continue;
        for (int32_t j = 0; j < n; j++) {
            const double turn = e[j].forward ? DBL_MAX : n == 2 ? 0 : turn_to(f, &e[i], &e[j]);
            if (turn < least) { least = turn; best = j; }
        }
        if (best >= 0) join(s, e[i].face, e[best].face);
    }
}

/* A face with an edge of its own goes with others that have such at the same vertex. */
static void join_lone(const obj_file *f, const side *e, shells *s)
{
    const obj_face *face = &f->face[e->face];
    const int32_t next = e->corner + 1 < face->corner + face->corners ? e->corner + 1 : face->corner;
    const int32_t ends[2] = { f->corner[e->corner], f->corner[next] };
    for (int k = 0; k < 2; k++) {
        if (s->at[ends[k]] >= 0) join(s, e->face, s->at[ends[k]]);
        s->at[ends[k]] = e->face;
    }
}

static void join_faces(const obj_file *f, int32_t first, int32_t end, shells *s)
{
    const int32_t n = list_sides(f, first, end, s->side);
    for (int32_t i = first; i < end; i++) s->root[i] = i;
    for (int32_t i = 0; i < n; i++) s->at[f->corner[s->side[i].corner]] = -1;
    for (int32_t i = 0, j; i < n; i = j) {
        const side *e = &s->side[i];
        for (j = i + 1; j < n && !compare_place(e->p, s->side[j].p) && !compare_place(e->q, s->side[j].q); ) j++;
        if (j > i + 1) join_sides(f, e, j - i, s);
        else join_lone(f, e, s);
    }
}

/* Volumes and boxes of the shells of block b; returns how many there are. */
static int32_t measure_shells(const obj_file *f, int32_t b, shells *s)
{
    const int32_t first = f->block[b].face, end = faces_end(f, b);
    int32_t n = 0;
    join_faces(f, first, end, s);
    for (int32_t i = first; i < end; i++) s->of[i] = find_root(s->root, i);
    for (int32_t i = first; i < end; i++) s->root[s->of[i]] = -1;
    for (int32_t i = first; i < end; i++) {
        int32_t *number = &s->root[s->of[i]];
        const shell empty = { 0, no_box, -1, 0 };
        if (*number < 0) s->each[*number = n++] = empty;
        s->of[i] = *number;
        s->each[*number].volume += face_volume(f, i, at(f, first, 0));
        box_add(f, i, &s->each[*number].around);
    }
    return n;
}

/* A shell that looks inwards is a hollow in the smallest one around it. */
static int32_t number_shells(shells *s, int32_t n)
{
    int32_t bodies = 0;
    for (int32_t i = 0; i < n; i++) {
        shell *e = &s->each[i];
        for (int32_t j = 0; j < n && e->volume < 0; j++)
            if (s->each[j].volume > 0 && box_holds(&s->each[j].around, &e->around)
                && (e->into < 0 || box_size(&s->each[j].around) < box_size(&s->each[e->into].around))) e->into = j;
        if (e->into < 0) e->number = bodies++;
    }
    for (int32_t i = 0; i < n; i++) if (s->each[i].into >= 0) s->each[i].number = s->each[s->each[i].into].number;
    return bodies;
}

static void find_shells(const obj_file *f, shells *s)
{
    for (int32_t b = 0; b < f->blocks; b++) {
        s->count[b] = number_shells(s, measure_shells(f, b, s));
        for (int32_t i = f->block[b].face; i < faces_end(f, b); i++) s->of[i] = s->each[s->of[i]].number;
    }
}

static void tell_shells(const obj_file *f, const shells *s, remarks *told)
{
    int32_t several = 0, first = -1;
    for (int32_t b = 0; b < f->blocks; b++) if (s->count[b] > 1 && !several++) first = b;
    if (!several) return;
    const text_word name = f->block[first].name;
    remarks_add(told, "--split",
                "%ld object%s of several separate shells, the first '%.*s' of %ld, move as one; each shell a block",
                (long)several, several > 1 ? "s" : "", (int)(name.n < 60 ? name.n : 60), name.s, (long)s->count[first]);
}

static int refuse_split(const obj_file *f, int32_t b, const char *what, failure *error)
{
    const text_word name = f->block[b].name;
    return fail_with(error, EXIT_SCENE, f->path, f->block[b].line, "--split: the file tells %s of '%.*s', which would be split",
                     what, (int)(name.n < 60 ? name.n : 60), name.s);
}

static int may_split(const obj_file *f, const shells *s, failure *error)
{
    for (int32_t i = 0; i < f->contacts; i++) {
        if (s->count[f->contact[i].a] > 1) return refuse_split(f, f->contact[i].a, "contacts", error);
        if (s->count[f->contact[i].b] > 1) return refuse_split(f, f->contact[i].b, "contacts", error);
    }
    for (int32_t i = 0; i < f->loads; i++)
        if (s->count[f->load[i].block] > 1) return refuse_split(f, f->load[i].block, "loads", error);
    return 0;
}

/* What a split makes, to take the place of the file's tables. */
typedef struct tables { obj_block *block; obj_face *face; int32_t *corner; char *names; } tables;

/* One block a shell, with the faces of each in their order. */
static void split_block(const obj_file *f, int32_t b, const shells *s, tables *t, int32_t n[3], char **name)
{
    const obj_block old = f->block[b];
    for (int32_t k = 0; k < s->count[b] || k == 0; k++) {
        obj_block *piece = &t->block[n[0]++];
        *piece = old;
        piece->face = n[1];
        if (s->count[b] > 1) {
            memcpy(*name, old.name.s, old.name.n);
            piece->name.s = *name;
            piece->name.n = old.name.n + (size_t)sprintf(*name + old.name.n, ".%ld", (long)k + 1);
            *name += piece->name.n;
        }
        for (int32_t i = old.face; i < faces_end(f, b); i++)
            if (s->of[i] == k) copy_face(f, i, -1, t->face, &n[1], t->corner, &n[2]);
    }
}

static int split_file(obj_file *f, const shells *s, failure *error)
{
    size_t blocks = 1, bytes = 1;
    int32_t n[3] = { 0, 0, 0 };                         /* blocks, faces, corners so far */
    for (int32_t b = 0; b < f->blocks; b++) {
        blocks += (size_t)s->count[b] + 1;
        if (s->count[b] > 1) bytes += (size_t)s->count[b] * (f->block[b].name.n + 12);
    }
    tables t = { malloc(blocks * sizeof *t.block), malloc(((size_t)f->faces + 1) * sizeof *t.face),
                 malloc(((size_t)f->corners + 1) * sizeof *t.corner), malloc(bytes) };
    if (!t.block || !t.face || !t.corner || !t.names || blocks > INT32_MAX) {
        free(t.block);
        free(t.face);
        free(t.corner);
        free(t.names);
        return out_of_memory(f, error);
    }
    char *name = t.names;
    for (int32_t b = 0; b < f->blocks; b++) split_block(f, b, s, &t, n, &name);
    free(f->block);
    free(f->face);
    free(f->corner);
    free(f->by_name);
    f->block = t.block;
    f->face = t.face;
    f->corner = t.corner;
    f->names = t.names;
    f->by_name = NULL;
    f->blocks = n[0];
    f->room.block = (int32_t)blocks;
    f->room.face = n[1] + 1;
    f->room.corner = n[2] + 1;
    const int status = obj_names_sort(f, error);
    return status ? status : obj_names_resolve(f, error);
}

static int separate(obj_file *f, int split, remarks *told, failure *error)
{
    int32_t most = 0;
    for (int32_t b = 0; b < f->blocks; b++)
        if (faces_end(f, b) - f->block[b].face > most) most = faces_end(f, b) - f->block[b].face;
    shells s = { malloc(((size_t)f->faces + 1) * sizeof *s.root), malloc(((size_t)f->faces + 1) * sizeof *s.of),
                 malloc(((size_t)f->vertices + 1) * sizeof *s.at), malloc(((size_t)f->blocks + 1) * sizeof *s.count),
                 malloc(((size_t)f->corners + 1) * sizeof *s.side), malloc(((size_t)most + 1) * sizeof *s.each) };
    int status = 0;
    if (!s.root || !s.of || !s.at || !s.count || !s.side || !s.each) status = out_of_memory(f, error);
    if (!status) find_shells(f, &s);
    if (!status && !split) tell_shells(f, &s, told);
    if (!status && split) status = may_split(f, &s, error);
    if (!status && split) status = split_file(f, &s, error);
    free(s.root);
    free(s.of);
    free(s.at);
    free(s.side);
    free(s.count);
    free(s.each);
    return status;
}

int solids_mend(obj_file *f, int split, remarks *told, failure *error)
{
    const int status = cut_warped(f, told, error);
    return status ? status : separate(f, split, told, error);
}
