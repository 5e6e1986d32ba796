#include "twins.h"

#include <math.h>
#include <stdlib.h>

#define CLOSED 1e-6                     /* of the area of all faces: so much their area vectors may sum to */

/* A face from its first corner by place, so that copies compare alike wherever they begin. */
typedef struct turned { const obj_file *f; int32_t face, from; } turned;

static int32_t faces_end(const obj_file *f, int32_t b) { return b + 1 < f->blocks ? f->block[b + 1].face : f->faces; }

static const sp_real *at(const obj_file *f, int32_t face, int32_t k)
{
    return f->vertex[f->corner[f->face[face].corner + k % f->face[face].corners]];
}

static int compare_place(const sp_real *x, const sp_real *y)
{
    for (int c = 0; c < 3; c++) if (x[c] < y[c] || x[c] > y[c]) return x[c] < y[c] ? -1 : 1;
    return 0;
}

static turned turn(const obj_file *f, int32_t face)
{
    turned t = { f, face, 0 };
    for (int32_t k = 1; k < f->face[face].corners; k++)
        if (compare_place(at(f, face, k), at(f, face, t.from)) < 0) t.from = k;
    return t;
}

static int compare_corners(const turned *a, const turned *b)
{
    const int32_t n = a->f->face[a->face].corners, m = b->f->face[b->face].corners;
    int c = 0;
    if (n != m) return n < m ? -1 : 1;
    for (int32_t k = 0; k < n && !c; k++) c = compare_place(at(a->f, a->face, a->from + k), at(b->f, b->face, b->from + k));
    return c;
}

static int compare_turned(const void *pa, const void *pb)
{
    const turned *a = pa, *b = pb;
    const int c = compare_corners(a, b);
    return c ? c : (a->face > b->face) - (a->face < b->face);
}

/* Mark the copies among the faces of block b; returns how many they are. */
static int32_t mark_copies(const obj_file *f, int32_t b, turned *list, unsigned char *copy)
{
    const int32_t first = f->block[b].face, n = faces_end(f, b) - first;
    int32_t copies = 0;
    for (int32_t i = 0; i < n; i++) list[i] = turn(f, first + i);
    qsort(list, (size_t)n, sizeof *list, compare_turned);
    for (int32_t i = 1; i < n; i++)
        if (compare_corners(&list[i - 1], &list[i]) == 0) copies += copy[list[i].face] = 1;
    return copies;
}

/* Twice the area vectors of the faces of block b, of all or without the copies; returns twice the area of all. */
static double sum_areas(const obj_file *f, int32_t b, const unsigned char *copy, double all[3], double kept[3])
{
    double area = 0;
    for (int k = 0; k < 3; k++) all[k] = kept[k] = 0;
    for (int32_t i = f->block[b].face; i < faces_end(f, b); i++) {
        double n[3] = { 0, 0, 0 };
        const sp_real *o = at(f, i, 0);
        for (int32_t j = 1; j + 1 < f->face[i].corners; j++) {
            const sp_real *p = at(f, i, j), *q = at(f, i, j + 1);
            double d[3], e[3];
            for (int k = 0; k < 3; k++) d[k] = (double)p[k] - (double)o[k], e[k] = (double)q[k] - (double)o[k];
            for (int k = 0; k < 3; k++) n[k] += d[(k + 1) % 3] * e[(k + 2) % 3] - d[(k + 2) % 3] * e[(k + 1) % 3];
        }
        for (int k = 0; k < 3; k++) {
            all[k] += n[k];
            if (!copy[i]) kept[k] += n[k];
        }
        area += sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
    return area;
}

static double length(const double n[3]) { return sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]); }

/* Do the copies close a block that is open without them? Then they are of two solids, one in the other. */
static int are_needed(const obj_file *f, int32_t b, const unsigned char *copy)
{
    double all[3], kept[3];
    const double area = sum_areas(f, b, copy, all, kept);
    return length(all) <= CLOSED * area && length(kept) > CLOSED * area;
}

static int refuse(const obj_file *f, int32_t line, text_word name, const char *why, failure *error)
{
    return fail_with(error, EXIT_SCENE, OBJ_AT(f, line), "block '%.*s': faces are there twice%s",
                     (int)(name.n < 60 ? name.n : 60), name.s, why);
}

static void take_out(obj_file *f, const unsigned char *copy)
{
    int32_t faces = 0, corners = 0;
    for (int32_t b = 0, i = 0; b < f->blocks; b++) {
        const int32_t end = faces_end(f, b);
        f->block[b].face = faces;
        for (; i < end; i++) {
            const obj_face old = f->face[i], new = { old.line, corners, old.corners };
            if (copy[i]) continue;
            for (int32_t k = 0; k < old.corners; k++) f->corner[corners++] = f->corner[old.corner + k];
            f->face[faces++] = new;
        }
    }
    f->faces = faces;
    f->corners = corners;
}

static void tell(const obj_file *f, int32_t copies, int32_t blocks, int32_t first, remarks *told)
{
    const text_word name = f->block[first].name;
    remarks_add(told, NULL, "%ld face%s of %ld block%s, the first '%.*s', %s there twice: counted once", (long)copies,
                copies > 1 ? "s" : "", (long)blocks, blocks > 1 ? "s" : "", (int)(name.n < 60 ? name.n : 60), name.s,
                copies > 1 ? "were" : "was");
}

int twins_drop(obj_file *f, remarks *told, failure *error)
{
    turned *list = malloc(((size_t)f->faces + 1) * sizeof *list);
    unsigned char *copy = calloc((size_t)f->faces + 1, 1);
    int32_t blocks = 0, first = -1;
    int status = list && copy ? 0 : fail_with(error, EXIT_MEMORY, f->path, 0, "out of memory while reading");

    for (int32_t b = 0; !status && b < f->blocks; b++) {
        const int32_t n = mark_copies(f, b, list, copy);
        if (n && are_needed(f, b, copy))
            status = refuse(f, f->block[b].line, f->block[b].name, ", and without the copies it is open", error);
        if (n && !blocks++) first = b;
        f->copies += n;
    }
    if (!status && blocks) {
        take_out(f, copy);
        tell(f, f->copies, blocks, first, told);
    }
    free(list);
    free(copy);
    return status;
}

int twins_check_pressures(const obj_file *f, failure *error)
{
    for (int32_t i = 0; f->copies && i < f->loads; i++)
        if (f->load[i].kind == OBJ_PRESSURE)
            return refuse(f, f->load[i].line, f->load[i].name, " in this file, and a pressure counts them", error);
    return 0;
}
