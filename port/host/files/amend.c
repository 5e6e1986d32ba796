#include "amend.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NEARLY_LOWEST 0.01              /* of its own height: so far above the lowest point a block still stands lowest */
#define GROUND_THICK  0.1               /* of the model's width */
#define GROUND_BEYOND 0.15              /* as a share of the same, to each side */

static int out_of_memory(const obj_file *f, failure *error)
{
    return fail_with(error, EXIT_MEMORY, f->path, 0, "out of memory: %ld blocks, %ld vertices", (long)f->blocks,
                     (long)f->vertices);
}

/* ---------------------------------------------------------------------------------------------------------------- lengths */

static void scale(sp_real *x, int32_t n, units_length unit)
{
    for (int32_t i = 0; i < n; i++) x[i] = x[i] * (sp_real)unit.times / (sp_real)unit.over;
}

/* Vertices and points, not what is told in N, N m, Pa or kg. */
static void scale_file(obj_file *f, units_length unit)
{
    if (unit.times == unit.over) return;
    for (int32_t i = 0; i < f->vertices; i++) scale(f->vertex[i], 3, unit);
    for (int32_t i = 0; i < f->points; i++) scale(f->point[i], 3, unit);
    for (int32_t i = 0; i < f->loads; i++)
        if (f->load[i].kind == OBJ_FORCE || f->load[i].kind == OBJ_MASS) scale(f->load[i].x, 3, unit);
}

/* ---------------------------------------------------------------------------------------------------------------- gravity */

static void turn_gravity(obj_file *f, const amendments *a)
{
    if (a->pull) memcpy(f->gravity, a->gravity, sizeof f->gravity);
    if (a->turn) obj_set_up(f, a->up);
}

/* Unit vectors: down, and two level ones that make a right-handed triple with it. For gravity along an axis all are axes. */
typedef struct frame { double down[3], a[3], b[3]; } frame;

static int find_frame(const obj_file *f, frame *t)
{
    double g = 0, most = 0, length = 0;
    int least = 0;
    for (int k = 0; k < 3; k++) most = fmax(most, fabs((double)f->gravity[k]));
    if (!(most > 0)) return 0;
    for (int k = 0; k < 3; k++) g += (double)f->gravity[k] / most * ((double)f->gravity[k] / most);
    for (int k = 0; k < 3; k++) t->down[k] = (double)f->gravity[k] / most / sqrt(g);
    for (int k = 1; k < 3; k++) if (fabs(t->down[k]) < fabs(t->down[least])) least = k;
    for (int k = 0; k < 3; k++) t->a[k] = (k == least) - t->down[least] * t->down[k];
    for (int k = 0; k < 3; k++) length += t->a[k] * t->a[k];
    for (int k = 0; k < 3; k++) t->a[k] /= sqrt(length);
    for (int k = 0; k < 3; k++)
        t->b[k] = t->down[(k + 1) % 3] * t->a[(k + 2) % 3] - t->down[(k + 2) % 3] * t->a[(k + 1) % 3];
    return 1;
}

static double along(const sp_real *x, const double n[3])
{
    return (double)x[0] * n[0] + (double)x[1] * n[1] + (double)x[2] * n[2];
}

/* How far a block reaches in a direction. Without faces: low > high. */
typedef struct reach { double low, high; } reach;

static reach reach_of(const obj_file *f, int32_t b, const double n[3])
{
    reach r = { DBL_MAX, -DBL_MAX };
    const int32_t end = b + 1 < f->blocks ? f->block[b + 1].face : f->faces;
    for (int32_t i = f->block[b].face; i < end; i++)
        for (int32_t k = 0; k < f->face[i].corners; k++) {
            const double x = along(f->vertex[f->corner[f->face[i].corner + k]], n);
            r.low = fmin(r.low, x);
            r.high = fmax(r.high, x);
        }
    return r;
}

static reach reach_of_all(const obj_file *f, const double n[3])
{
    reach all = { DBL_MAX, -DBL_MAX };
    for (int32_t b = 0; b < f->blocks; b++) {
        const reach r = reach_of(f, b, n);
        all.low = fmin(all.low, r.low);
        all.high = fmax(all.high, r.high);
    }
    return all;
}

/* --------------------------------------------------------------------------------------------------------------- supports */

/* Blocks whose lowest point is nearly as low as any. */
static void fix_lowest(obj_file *f, const frame *t)
{
    const double lowest = reach_of_all(f, t->down).high;        /* downwards */
    for (int32_t b = 0; b < f->blocks; b++) {
        const reach r = reach_of(f, b, t->down);
        if (r.low <= r.high && lowest - r.high <= NEARLY_LOWEST * (r.high - r.low)) f->block[b].fixed = SP_FIXED;
    }
}

/* The table with room for so many more entries, NULL: no memory, and the old one stays. */
static void *grow(void *table, int32_t more, int32_t *room, size_t size)
{
    void *bigger = realloc(table, ((size_t)*room + (size_t)more) * size);
    if (bigger) *room += more;
    return bigger;
}

static int make_room(obj_file *f)
{
    void *block = grow(f->block, 1, &f->room.block, sizeof *f->block), *face = grow(f->face, 6, &f->room.face, sizeof *f->face);
    void *corner = grow(f->corner, 24, &f->room.corner, sizeof *f->corner);
    void *vertex = grow(f->vertex, 8, &f->room.vertex, sizeof *f->vertex);
    if (block) f->block = block;
    if (face) f->face = face;
    if (corner) f->corner = corner;
    if (vertex) f->vertex = vertex;
    return block && face && corner && vertex;
}

static const char slab_name[] = "ground";

/* A level slab under the lowest point, a little wider than the model, which the picture is of. a, b, down are a
 * right-handed triple, so its faces look outwards. */
static int add_ground(obj_file *f, const frame *t, int32_t line, failure *error)
{
    static const int side[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
                                    { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
    const reach a = reach_of_all(f, t->a), b = reach_of_all(f, t->b);
    const double top = reach_of_all(f, t->down).high, wide = fmax(a.high - a.low, b.high - b.low);
    const double more = GROUND_BEYOND * wide;
    const obj_block slab = { { slab_name, 6 }, line, f->faces, 0, SP_FIXED, 0 };

    if (!make_room(f)) return out_of_memory(f, error);
    f->block[f->blocks++] = slab;
    for (int k = 0; k < 6; k++) {
        const obj_face face = { line, f->corners, 4 };
        for (int i = 0; i < 4; i++) f->corner[f->corners++] = f->vertices + side[k][i];
        f->face[f->faces++] = face;
    }
    for (int k = 0; k < 8; k++) {                       /* bits: a, b, down */
        const double x = k & 1 ? a.high + more : a.low - more, y = k & 2 ? b.high + more : b.low - more;
        const double z = k & 4 ? top + GROUND_THICK * wide : top;
        for (int i = 0; i < 3; i++) f->vertex[f->vertices][i] = (sp_real)(x * t->a[i] + y * t->b[i] + z * t->down[i]);
        f->vertices++;
    }
    return 0;
}

static int is_named(const obj_file *f, text_word w)
{
    for (int32_t b = 0; b < f->blocks; b++) if (text_same(f->block[b].name, w)) return 1;
    return 0;
}

/* Names of the first blocks, for whoever mistook them. */
static const char *first_names(const obj_file *f, char text[200])
{
    size_t n = 0;
    for (int32_t b = 0; b < f->blocks && b < 4; b++) {
        const text_word w = f->block[b].name;
        n += (size_t)snprintf(text + n, 200 - n, "%s%.*s", b ? ", " : "", (int)(w.n < 40 ? w.n : 40), w.s);
    }
    if (f->blocks > 4) snprintf(text + n, 200 - n, ", ...");
    return text;
}

/* Who tells a list: a line of a file, or for line 0 an option. */
typedef struct teller { int32_t line; const char *by; remarks *told; } teller;

/* Is it the first word of a name? */
static int is_part(const obj_file *f, text_word w)
{
    for (int32_t b = 0; b < f->blocks; b++) if (text_begins(w, f->block[b].name)) return 1;
    return 0;
}

/* No block has this name. */
static int refuse_name(const obj_file *f, text_word w, teller t, failure *error)
{
    char names[200];
    return fail_with(error, t.line ? EXIT_SCENE : EXIT_USAGE, OBJ_AT(f, t.line),
                     "%s '%.*s': no block has such a name%s; there are %s", t.by,
                     (int)(w.n < 60 ? w.n : 60), w.s, is_part(f, w) ? ", blanks of names are written _" : "",
                     first_names(f, names));
}

static int refuse_level(const obj_file *f, text_word w, teller t, const char *why, failure *error)
{
    return fail_with(error, t.line ? EXIT_SCENE : EXIT_USAGE, OBJ_AT(f, t.line), "%s %.*s: %s", t.by, (int)w.n, w.s, why);
}

/* Without the number that the reader of models put behind it: support.0. */
static text_word without_number(text_word name)
{
    text_word w = name;
    while (w.n > 1 && w.s[w.n - 1] >= '0' && w.s[w.n - 1] <= '9') w.n--;
    if (w.n < 2 || w.n == name.n || w.s[w.n - 1] != '.') return name;
    w.n--;
    return w;
}

/* Is it a name or pattern of this block, or of the node that it was? */
static int is_meant(const obj_file *f, int32_t b, text_word w)
{
    const text_word name = f->block[b].name, key = { name.s + 1, name.n - 1 };
    if (text_matches(name, w) || (f->nodes && text_matches(key, w))) return 1;
    return f->numbered && text_matches(without_number(name), w);
}

/* Is a block of the model's own form called so, before it got the name it has? */
static int is_node(const obj_file *f, text_word w)
{
    for (int32_t b = 0; b < f->blocks; b++) {
        const text_word name = f->block[b].name, key = { name.s + 1, name.n - 1 };
        if ((f->nodes && text_same(key, w)) || (f->numbered && text_same(without_number(name), w))) return 1;
    }
    return 0;
}

/* Blocks were meant that lie lowest, or a slab, and one of this name is there. */
static void tell_own(const obj_file *f, text_word w, remarks *told)
{
    const int laid = f->block[f->blocks - 1].name.s == slab_name;       /* asked for once more */
    if (text_is(w, "ground") && !laid)
        remarks_add(told, NULL, "'ground' is a block of this model: it is the support, and no slab is laid under the model");
    if (text_is(w, "lowest"))
        remarks_add(told, NULL, "'lowest' is a block of this model: it is the support, not the blocks that lie lowest");
}

/* One entry of a list. A block that has this very name comes first, whatever the name. */
static int fix_word(obj_file *f, text_word w, teller told, int given, failure *error)
{
    const int own = is_named(f, w), called = own || is_node(f, w);
    const int ground = !called && text_is(w, "ground"), lowest = !called && text_is(w, "lowest");
    int32_t found = 0;
    frame t;
    if ((ground || lowest) && !find_frame(f, &t)) return refuse_level(f, w, told, "without gravity nothing is low", error);
    if (ground && given) return refuse_level(f, w, told, "the file tells its contacts, and none with a ground", error);
    if (ground) return add_ground(f, &t, told.line, error);
    if (lowest) {
        fix_lowest(f, &t);
        return 0;
    }
    if (called) tell_own(f, w, told.told);
    for (int32_t b = 0; b < f->blocks; b++)
        if (own ? text_same(f->block[b].name, w) : is_meant(f, b, w)) {
            f->block[b].fixed = SP_FIXED;
            found++;
        }
    return found ? 0 : refuse_name(f, w, told, error);
}

/* NAME,PATTERN,... */
static int fix_list(obj_file *f, text_word list, teller told, int given, failure *error)
{
    int status = 0;
    for (size_t at = 0; !status && at < list.n; at++) {
        text_word w = { list.s + at, 0 };
        while (at < list.n && list.s[at] != ',') at++, w.n++;
        while (w.n && *w.s == ' ') w.s++, w.n--;
        if (w.n) status = fix_word(f, w, told, given, error);
    }
    return status;
}

int amend_file(obj_file *f, const amendments *a, int given, remarks *told, failure *error)
{
    int status = 0;
    scale_file(f, a->unit.over ? a->unit : f->unit);
    turn_gravity(f, a);
    for (int32_t i = 0; !status && i < f->supports; i++) {
        const teller line = { f->support[i].line, "supports", told };
        status = fix_list(f, f->support[i].list, line, given, error);
    }
    for (int32_t i = 0; !status && i < a->lists; i++) {
        const text_word list = { a->fixed[i], strlen(a->fixed[i]) };
        const teller option = { 0, a->option[i] ? a->option[i] : "--fixed", told };
        status = fix_list(f, list, option, given, error);
    }
    return status;
}
