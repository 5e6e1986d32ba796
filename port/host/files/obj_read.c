/* The reader of scene files. Every table grows with what the file really holds: a count is never believed, only counted. */
#include "compas.h"
#include "file.h"
#include "obj_names.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEFAULT_MU      ((sp_real)0.84)         /* [1] */
#define DEFAULT_DENSITY ((sp_real)2400)         /* [kg/m^3] */
#define DEFAULT_GRAVITY ((sp_real)-9.80665)     /* [m/s^2] along z */

/* One reading: the file, where we are, where errors go. */
typedef struct reader {
    obj_file *f;
    text_cursor at;
    failure *error;
    int in_block;               /* the line is about the block it stands in */
    int in_contact;             /* or about a contact of these two */
    text_word pair[2];
    int beside;                 /* reading what stands beside a model: `chosen` are its blocks that lines are about */
    text_word chosen;
    int32_t first_contact;      /* of the file being read */
    int has_objects;            /* an o line was read: from there on g lines start no blocks */
    text_word group;            /* of the g line before, until its block starts; n = 0: none */
    int32_t group_line;
    int32_t unnamed;            /* line of the first face of a file in which no o or g line came before it; 0: none */
} reader;

/* ------------------------------------------------------------------------------------------------------------ messages */

/* " in block 'X'" or " of 'A' and 'B'", or nothing: what the line being read is about. */
static const char *describe_place(const reader *r, char text[160])
{
    text[0] = 0;
    if (r->in_contact)
        snprintf(text, 160, " (contact of " WORD_FORMAT " and " WORD_FORMAT ")", WORD(r->pair[0]), WORD(r->pair[1]));
    else if (r->in_block && r->f->blocks > 0) {
        const text_word name = r->beside ? r->chosen : r->f->block[r->f->blocks - 1].name;
        if (name.n) snprintf(text, 160, " in block " WORD_FORMAT, WORD(name));
    }
    return text;
}

static int fail(reader *r, const char *message)
{
    return fail_with(r->error, EXIT_SCENE, r->f->path, r->at.line, "%s", message);
}

static int fail_in_line(reader *r, const char *message)
{
    char text[160];
    return fail_with(r->error, EXIT_SCENE, r->f->path, r->at.line, "%s%s", message, describe_place(r, text));
}

static int fail_word(reader *r, const char *message, text_word w)
{
    char text[160];
    return fail_with(r->error, EXIT_SCENE, r->f->path, r->at.line, "%s " WORD_FORMAT "%s", message, WORD(w),
                     describe_place(r, text));
}

static int out_of_memory(reader *r)
{
    return fail_with(r->error, EXIT_MEMORY, r->f->path, r->at.line, "out of memory while reading");
}

/* -------------------------------------------------------------------------------------------------------------- tables */

/* Make room for one more entry: twice as many as there are. Counts stay below 2^30, the longest file's bytes. */
static void *grow_table(void *table, int32_t count, int32_t *room, size_t size)
{
    const int32_t more = *room ? 2 * *room : 64;
    void *bigger;
    if (count < *room) return table;
    if (more <= *room || (size_t)more > SIZE_MAX / size) return NULL;
    bigger = realloc(table, (size_t)more * size);
    if (bigger) *room = more;
    return bigger;
}

/* Append an entry to a table of the file; on failure the old table stays to be freed. */
#define APPEND(r, table, count, room, entry)                                                                              \
    do {                                                                                                                  \
        void *bigger_ = grow_table((r)->f->table, (r)->f->count, &(r)->f->room, sizeof *(r)->f->table);                   \
        if (!bigger_) return out_of_memory(r);                                                                            \
        (r)->f->table = bigger_;                                                                                          \
        (r)->f->table[(r)->f->count++] = (entry);                                                                         \
    } while (0)

static int append_triple(reader *r, sp_real (**table)[3], int32_t *count, int32_t *room, const sp_real x[3])
{
    void *bigger = grow_table(*table, *count, room, sizeof **table);
    if (!bigger) return out_of_memory(r);
    *table = bigger;
    memcpy((*table)[(*count)++], x, 3 * sizeof x[0]);
    return 0;
}

/* ------------------------------------------------------------------------------------------------------------- numbers */

static int read_real(reader *r, text_word w, sp_real *x)
{
    switch (text_real(w, x)) {
    case TEXT_NUMBER:    return 0;
    case TEXT_TOO_LARGE: return fail_word(r, "number out of range", w);
    case TEXT_NO_NUMBER:
    default:             return fail_word(r, "not a number:", w);
    }
}

/* Exactly or at least n numbers; what is missing is told by `what`. */
static int read_reals(reader *r, int n, sp_real *x, const char *what)
{
    for (int i = 0; i < n; i++) {
        text_word w;
        int status;
        if (!text_next_word(&r->at, &w)) return fail_in_line(r, what);
        status = read_real(r, w, x + i);
        if (status) return status;
    }
    return 0;
}

/* Nothing more on this line but a comment. */
static int line_is_over(reader *r)
{
    text_word w;
    if (!text_next_word(&r->at, &w) || w.s[0] == '#') return 0;
    return fail_word(r, "unexpected", w);
}

/* ------------------------------------------------------------------------------------------------------- v, f, o lines */

static void note(reader *r, unsigned what) { if (r->f->blocks) r->f->block[r->f->blocks - 1].has |= what; }

static int read_vertex(reader *r)
{
    sp_real x[3], ignored;
    text_word w;
    int status;

    r->in_block = 1;
    status = read_reals(r, 3, x, "a vertex needs three numbers");
    while (!status && text_next_word(&r->at, &w) && w.s[0] != '#') status = read_real(r, w, &ignored);   /* weight, colour */
    if (status) return status;
    note(r, OBJ_VERTICES);
    return append_triple(r, &r->f->vertex, &r->f->vertices, &r->f->room.vertex, x);
}

/* `a`, `a/b`, `a/b/c` or `a//c`: the vertex index a; what follows must at least look right. */
static int corner_index(reader *r, text_word w, int32_t *index)
{
    text_word part = { w.s, 0 };
    size_t at = 0;
    int slashes = 0;

    for (;;) {
        int32_t i = 0;
        text_number kind;
        part.s = w.s + at;
        for (part.n = 0; at + part.n < w.n && part.s[part.n] != '/'; ) part.n++;
        at += part.n;
        kind = text_int(part, &i);
        if (slashes == 0) {
            if (kind == TEXT_TOO_LARGE) return fail_word(r, "no such vertex:", w);
            *index = i;
        }
        if (kind == TEXT_NO_NUMBER && !(slashes == 1 && part.n == 0 && at < w.n)) return fail_word(r, "bad face corner", w);
        if (at == w.n) return 0;
        if (++slashes > 2) return fail_word(r, "bad face corner", w);
        at++;
    }
}

/* Lines beside a model are about its blocks of this name or pattern. */
static int choose_blocks(reader *r, text_word name)
{
    r->chosen = name;
    for (int32_t b = 0; b < r->f->blocks; b++) if (text_matches(r->f->block[b].name, name)) return line_is_over(r);
    return fail_word(r, "no block has such a name:", name);
}

/* All words up to the end of the line or a comment; what separates them becomes '_' in the text.     returns 0: no word */
static int read_name(reader *r, text_word *name)
{
    char *const text = r->beside ? r->f->text_beside : r->f->text;
    text_word more;

    if (!text_next_word(&r->at, name) || name->s[0] == '#') return 0;
    while (text_next_word(&r->at, &more) && more.s[0] != '#') {
        char *gap = text + (name->s - text) + name->n;
        while (gap < more.s) *gap++ = '_';
        name->n = (size_t)(more.s - name->s) + more.n;
    }
    return 1;
}

static int start_block(reader *r, text_word name, int32_t line)
{
    const obj_block block = { name, line, r->f->faces, 0, 0, 0 };
    APPEND(r, block, blocks, room.block, block);
    return 0;
}

/* A file without o and g lines is one block, named after it. */
static int start_unnamed(reader *r)
{
    text_word name;
    r->unnamed = r->at.line;
    r->f->stem = obj_names_stem(r->f->path, &name);
    return r->f->stem ? start_block(r, name, r->at.line) : out_of_memory(r);
}

static int refuse_unnamed(reader *r)
{
    return fail_with(r->error, EXIT_SCENE, r->f->path, r->unnamed, "a face before the first block: an 'o NAME' or 'g NAME' "
                     "line must start one");
}

static int read_block(reader *r)
{
    text_word name;
    if (!read_name(r, &name)) return fail(r, "a block without a name");
    if (r->beside) return choose_blocks(r, name);
    if (r->unnamed) return refuse_unnamed(r);
    r->has_objects = 1;
    r->group.n = 0;
    return start_block(r, name, r->at.line);
}

/* Where no o line came before, a group is a block. It starts with the first line about it: exporters write groups without
 * faces, too, and the same group again after each material. */
static int read_group(reader *r)
{
    static const text_word unnamed = { "default", 7 };
    const obj_file *f = r->f;
    const int32_t line = r->at.line;
    text_word name;

    if (r->beside) return fail(r, "lines beside a model are about blocks after 'o NAME', not 'g NAME'");
    if (r->has_objects) return 0;
    if (r->unnamed) return refuse_unnamed(r);
    if (!read_name(r, &name)) name = unnamed;
    r->group = name;
    r->group_line = line;
    if (f->blocks == 0) return 0;
    const text_word last = f->block[f->blocks - 1].name;
    if (last.n == name.n && memcmp(last.s, name.s, name.n) == 0) r->group.n = 0;
    return 0;
}

/* Start the block of the g line before, if there is one.     returns 0, or fails */
static int start_group(reader *r)
{
    const text_word name = r->group;
    r->group.n = 0;
    return name.n ? start_block(r, name, r->group_line) : 0;
}

static int read_face(reader *r)
{
    obj_face face = { r->at.line, r->f->corners, 0 };
    text_word w;

    r->in_block = 1;
    if (start_group(r)) return r->error->status;
    if (r->f->blocks == 0 && start_unnamed(r)) return r->error->status;
    while (text_next_word(&r->at, &w) && w.s[0] != '#') {
        int32_t i = 0;
        int status = corner_index(r, w, &i);
        if (status) return status;
        if (i == 0) return fail_word(r, "vertices are counted from 1, not from", w);
        if (i < 0 && -i > r->f->vertices) return fail_word(r, "no such vertex:", w);
        i = i > 0 ? i - 1 : r->f->vertices + i;         /* -1: the last one so far; a positive one may still come */
        APPEND(r, corner, corners, room.corner, i);
        face.corners++;
    }
    if (face.corners < 3) return fail_in_line(r, "a face needs at least three corners");
    APPEND(r, face, faces, room.face, face);
    return 0;
}

/* ------------------------------------------------------------------------------------------------------------ #@ lines */

/* Of the whole scene, or of the interface before it. */
static int read_mu(reader *r)
{
    sp_real mu;
    int status = read_reals(r, 1, &mu, "mu needs a number");
    if (status) return status;
    if (mu < 0) return fail(r, "mu must not be negative");
    if (r->f->contacts > r->first_contact) r->f->contact[r->f->contacts - 1].mu = mu;
    else r->f->mu = mu;
    return line_is_over(r);
}

static const char *const strength[] = { "cohesion", "tension", "crushing" };

/* Which of them the word is, -1: none. */
static int strength_word(text_word w)
{
    for (int k = 0; k < 3; k++) if (text_is(w, strength[k])) return k;
    return -1;
}

/* [Pa], likewise. What no line tells of crushing is never crushed. */
static int read_strength(reader *r, int k, text_word w)
{
    sp_real x;
    int status = read_reals(r, 1, &x, "strength of a joint needs a number");
    if (status) return status;
    if (x < 0) return fail_word(r, "must not be negative:", w);
    obj_contact *c = r->f->contacts > r->first_contact ? &r->f->contact[r->f->contacts - 1] : NULL;
    *(c ? &c->strength[k] : &r->f->strength[k]) = x;
    *(c ? &c->strength_line[k] : &r->f->strength_line[k]) = r->at.line;
    return line_is_over(r);
}

static int read_gravity(reader *r)
{
    int status = read_reals(r, 3, r->f->gravity, "gravity needs three numbers");
    r->f->gravity_line = r->at.line;
    r->f->down_told = 1;
    return status ? status : line_is_over(r);
}

/* Is the line about this block? */
static int is_meant(const reader *r, int32_t b)
{
    return r->beside ? r->chosen.n && text_matches(r->f->block[b].name, r->chosen) : b == r->f->blocks - 1;
}

/* Of the whole scene, or of the block it stands in. */
static int read_density(reader *r)
{
    sp_real density;
    int status;

    r->in_block = 1;
    if (start_group(r)) return r->error->status;
    status = read_reals(r, 1, &density, "density needs a number");
    if (status) return status;
    if (!(density > 0)) return fail_in_line(r, "density must be positive");
    if (r->beside ? !r->chosen.n : !r->f->blocks) r->f->density = density;
    for (int32_t b = 0; b < r->f->blocks; b++) if (is_meant(r, b)) r->f->block[b].density = density;
    return line_is_over(r);
}

/* All directions, or those that are named. */
static int read_fixed(reader *r)
{
    static const char *const name[] = { "x", "y", "z", "rx", "ry", "rz" };
    uint32_t held = 0;
    text_word w;

    r->in_block = 1;
    if (start_group(r)) return r->error->status;
    if (r->beside ? !r->chosen.n : !r->f->blocks) return fail(r, "'fixed' before the first block");
    while (text_next_word(&r->at, &w) && w.s[0] != '#') {
        int k = 0;
        while (k < 6 && !text_is(w, name[k])) k++;
        if (k == 6) return fail_word(r, "fixed knows x y z rx ry rz, not", w);
        held |= 1u << k;
    }
    for (int32_t b = 0; b < r->f->blocks; b++) if (is_meant(r, b)) r->f->block[b].fixed = held ? held : SP_FIXED;
    return 0;
}

void obj_set_up(obj_file *file, const sp_real up[3])
{
    double most = 0, sum = 0;
    for (int k = 0; k < 3; k++) most = fmax(most, fabs((double)file->gravity[k]));
    for (int k = 0; k < 3 && most > 0; k++) sum += (double)file->gravity[k] / most * ((double)file->gravity[k] / most);
    for (int k = 0; k < 3; k++) file->gravity[k] = (sp_real)(0 - most * sqrt(sum) * (double)up[k]);
}

static int read_up(reader *r)
{
    sp_real up[3];
    text_word w;
    if (!text_next_word(&r->at, &w)) return fail(r, "up needs x, y or z, with - in front of it where that is down");
    if (!units_read_axis(w, up)) return fail_word(r, "up is x, y, z, -x, -y or -z, not", w);
    obj_set_up(r->f, up);
    r->f->down_told = 1;
    return line_is_over(r);
}

static int read_unit(reader *r)
{
    text_word w;
    if (!text_next_word(&r->at, &w)) return fail(r, "unit needs mm, cm, m or in");
    if (!units_read_length(w, &r->f->unit)) return fail_word(r, "unit is mm, cm, m or in, not", w);
    return line_is_over(r);
}

static int read_touching(reader *r, int angle)
{
    touching *t = &r->f->contact_told;
    text_word w;
    if (!text_next_word(&r->at, &w)) return fail(r, angle ? "contact_angle needs degrees" : "contact_distance needs a length");
    if (angle && !touching_read_angle(w, t)) return fail_word(r, "contact_angle is 0 to 30 degrees, not", w);
    if (!angle && !touching_read_distance(w, t))
        return fail_word(r, "contact_distance is a length [m], or up to 50% of the smaller block, not", w);
    return line_is_over(r);
}

/* Lists of names and patterns; which blocks they are is looked for when all blocks are there. */
static int read_supports(reader *r)
{
    obj_support support = { { NULL, 0 }, r->at.line };
    int32_t n = 0;
    while (text_next_name(&r->at, &support.list) && support.list.s[0] != '#') {
        APPEND(r, support, supports, room.support, support);
        n++;
    }
    return n ? 0 : fail(r, "supports needs names, lowest or ground");
}

/* The name of a block, before numbers.     returns 0, or fails */
static int read_loaded(reader *r, text_word *name)
{
    text_cursor ahead;
    text_word w;
    double x;
    if (!text_next_name(&r->at, name)) return fail(r, "a load needs the name of a block");
    ahead = r->at;
    if (!text_next_word(&ahead, &w) || w.s[0] == '#' || text_double(w, &x) != TEXT_NO_NUMBER) return 0;
    return fail_word(r, "blanks of a name are written _, or it stands in quotes; not a number:", w);
}

/* NAME, then a force and its point; or a force at the centroid, a moment, and `couple`. live: it counts scene.live times. */
static int read_load(reader *r, int live)
{
    obj_load load = { { NULL, 0 }, -1, r->at.line, live, OBJ_FORCE, 0, { 0, 0, 0 }, { 0, 0, 0 } };
    text_word w;
    int status;

    if (read_loaded(r, &load.name)) return r->error->status;
    status = read_reals(r, 3, load.f, "a load needs a force of three numbers");
    if (!status) status = read_reals(r, 3, load.x, "a load needs a point, or a moment and the word 'couple'");
    if (status) return status;
    if (text_next_word(&r->at, &w) && w.s[0] != '#') {
        if (!text_is(w, "couple")) return fail_word(r, "unexpected", w);
        load.kind = OBJ_COUPLE;
        status = line_is_over(r);
        if (status) return status;
    }
    APPEND(r, load, loads, room.load, load);
    return 0;
}

/* NAME kg px py pz, a weight at a point that goes with the block, or NAME FACE Pa, which pulls below 0; either with `live`
 * behind it. */
static int read_weight(reader *r, obj_load_kind kind)
{
    const char *what = kind == OBJ_MASS ? "a mass needs kilograms and a point"
                                        : "a pressure needs the number of a face and pascals";
    obj_load load = { { NULL, 0 }, -1, r->at.line, 0, kind, 0, { 0, 0, 0 }, { 0, 0, 0 } };
    text_word w;
    int status = 0;

    if (read_loaded(r, &load.name)) return r->error->status;
    if (kind == OBJ_PRESSURE) {
        if (!text_next_word(&r->at, &w)) return fail(r, what);
        if (text_int(w, &load.face) != TEXT_NUMBER || load.face < 1) return fail_word(r, "faces are counted from 1, not by", w);
        load.face--;
    }
    status = read_reals(r, 1, load.f, what);
    if (!status && kind == OBJ_MASS) status = read_reals(r, 3, load.x, what);
    if (status) return status;
    if (kind == OBJ_MASS && load.f[0] < 0) return fail(r, "a mass must not be negative");
    if (text_next_word(&r->at, &w) && w.s[0] != '#') {
        if (!text_is(w, "live")) return fail_word(r, "unexpected", w);
        load.live = 1;
        status = line_is_over(r);
        if (status) return status;
    }
    APPEND(r, load, loads, room.load, load);
    return 0;
}

/* A B, then for points nx ny nz, then x y z of each vertex. */
static int read_contact(reader *r, int polygon)
{
    obj_contact c = { { { NULL, 0 }, { NULL, 0 } }, -1, -1, r->at.line, r->f->points, 0, polygon, { 0, 0, 0 }, -1,
                      { -1, -1, -1 }, { 0, 0, 0 } };
    text_word w;
    int status;

    if (!text_next_name(&r->at, &c.name[0]) || !text_next_name(&r->at, &c.name[1]))
        return fail(r, "a contact needs the names of two blocks");
    r->in_contact = 1;
    r->pair[0] = c.name[0];
    r->pair[1] = c.name[1];
    if (!polygon) {
        status = read_reals(r, 3, c.n, "points need a normal of three numbers");
        if (status) return status;
    }
    while (text_next_word(&r->at, &w) && w.s[0] != '#') {
        sp_real x[3];
        status = read_real(r, w, x);
        if (!status) status = read_reals(r, 2, x + 1, "coordinates come in threes: the last point is not complete");
        if (!status) status = append_triple(r, &r->f->point, &r->f->points, &r->f->room.point, x);
        if (status) return status;
        c.points++;
    }
    if (polygon && c.points < 3) return fail_in_line(r, "an interface needs at least three points");
    if (c.points < 1) return fail_in_line(r, "a contact needs at least one point");
    APPEND(r, contact, contacts, room.contact, c);
    return 0;
}

static int read_word(reader *r, text_word w)
{
    if (w.n == 0 && !text_next_word(&r->at, &w)) return fail(r, "a word is missing after '#@'");
    if (text_is(w, "mu")) return read_mu(r);
    if (strength_word(w) >= 0) return read_strength(r, strength_word(w), w);
    if (text_is(w, "gravity")) return read_gravity(r);
    if (text_is(w, "up")) return read_up(r);
    if (text_is(w, "unit")) return read_unit(r);
    if (text_is(w, "contact_distance")) return read_touching(r, 0);
    if (text_is(w, "contact_angle")) return read_touching(r, 1);
    if (text_is(w, "supports")) return read_supports(r);
    if (text_is(w, "density")) return read_density(r);
    if (text_is(w, "fixed")) return read_fixed(r);
    if (text_is(w, "interface")) return read_contact(r, 1);
    if (text_is(w, "points")) return read_contact(r, 0);
    if (text_is(w, "load")) return read_load(r, 0);
    if (text_is(w, "live")) return read_load(r, 1);
    if (text_is(w, "mass")) return read_weight(r, OBJ_MASS);
    if (text_is(w, "pressure")) return read_weight(r, OBJ_PRESSURE);
    if (text_is(w, "picture"))
        return fail_with(r->error, EXIT_SCENE, r->f->path, r->at.line, "this is a picture that --out-obj wrote, not a scene");
    return fail_with(r->error, EXIT_SCENE, r->f->path, r->at.line, "unknown word " WORD_FORMAT " after '#@'", WORD(w));
}

/* --------------------------------------------------------------------------------------------------------- whole files */

static int read_line(reader *r)
{
    static const char *const ignored[] = { "vn", "vt", "vp", "s", "l", "p", "mg", "usemtl", "mtllib", "usemap", "maplib",
                                           "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "cstype", "deg",
                                           "bmat", "step", "curv", "curv2", "parm", "trim", "hole", "scrv", "sp", "end", "con",
                                           "stech", "ctech" };
    text_word w;

    r->in_contact = 0;
    r->in_block = 0;
    if (!text_next_word(&r->at, &w)) return 0;
    if (w.s[0] == '#') {
        const text_word rest = { w.s + 2, w.n - 2 };
        return w.n > 1 && w.s[1] == '@' ? read_word(r, rest) : 0;
    }
    if (r->beside && (text_is(w, "v") || text_is(w, "f"))) return fail_word(r, "the model has the geometry; unexpected", w);
    if (text_is(w, "v")) return read_vertex(r);
    if (text_is(w, "f")) return read_face(r);
    if (text_is(w, "o")) return read_block(r);
    if (text_is(w, "g")) return read_group(r);
    if (text_is(w, "l") || text_is(w, "p") || text_is(w, "curv")) note(r, OBJ_CURVES);
    for (size_t i = 0; i < sizeof ignored / sizeof *ignored; i++)
        if (text_is(w, ignored[i])) return 0;
    if (text_is(w, "surf")) return fail_in_line(r, "a free-form surface: export meshes");
    return fail_with(r->error, EXIT_SCENE, r->f->path, r->at.line, "unknown line: it starts with " WORD_FORMAT, WORD(w));
}

/* Every corner of every face is a vertex that exists by now. */
static int check_corners(reader *r)
{
    const obj_file *f = r->f;
    int32_t b = 0;
    for (int32_t i = 0; i < f->faces; i++)
        for (int32_t k = 0; k < f->face[i].corners; k++) {
            const int32_t v = f->corner[f->face[i].corner + k];
            if (v < f->vertices) continue;
            while (b + 1 < f->blocks && f->block[b + 1].face <= i) b++;
            return fail_with(r->error, EXIT_SCENE, f->path, f->face[i].line, "no such vertex: %ld, there are %ld; in block "
                             WORD_FORMAT, (long)v + 1, (long)f->vertices, WORD(f->block[b].name));
        }
    return 0;
}

static int read_lines(reader *r)
{
    int status, more;
    text_skip_mark(&r->at);
    do {
        status = read_line(r);
        more = !status && text_next_line(&r->at);
    } while (more);
    return status;
}

int obj_parse(const char *path, char *text, size_t length, obj_file *file, failure *error)
{
    const obj_file empty = { 0 };
    reader r = { file, { text, text + length, 1 }, error, 0, 0, { { NULL, 0 }, { NULL, 0 } }, 0, { NULL, 0 }, 0, 0,
                 { NULL, 0 }, 0, 0 };
    int status;

    if (compas_is_json(text, length)) return compas_parse(path, text, length, file, error);
    *file = empty;
    file->path = path;
    file->text = text;
    file->length = length;
    file->mu = DEFAULT_MU;
    file->density = DEFAULT_DENSITY;
    file->gravity[2] = DEFAULT_GRAVITY;
    status = read_lines(&r);
    if (status) return status;
    file->lines = r.at.line;
    if (file->blocks == 0)
        return fail_with(error, EXIT_SCENE, path, file->lines, "%s", sp_status_text(SP_E_EMPTY));
    status = check_corners(&r);
    if (!status) status = obj_names_sort(file, error);
    if (!status) status = obj_names_resolve(file, error);
    return status;
}

int obj_read(const char *path, obj_file *file, failure *error)
{
    const obj_file empty = { 0 };
    char *text;
    size_t length;
    const int status = file_read(path, &text, &length, error);

    *file = empty;
    return status ? status : obj_parse(path, text, length, file, error);
}

/* What is new lies beside the model: its lines are counted below 0. `was`: the file without it. */
static void turn_lines(obj_file *f, const obj_file *was)
{
    for (int32_t i = was->contacts; i < f->contacts; i++) {
        f->contact[i].line *= -1;
        for (int k = 0; k < 3; k++) f->contact[i].strength_line[k] *= -1;
    }
    for (int32_t i = was->loads; i < f->loads; i++) f->load[i].line *= -1;
    for (int32_t i = was->supports; i < f->supports; i++) f->support[i].line *= -1;
    f->gravity_line = f->gravity_line ? -f->gravity_line : was->gravity_line;
    for (int k = 0; k < 3; k++)
        f->strength_line[k] = f->strength_line[k] ? -f->strength_line[k] : was->strength_line[k];
}

static int parse_beside(obj_file *file, size_t length, failure *error)
{
    const text_cursor start = { file->text_beside, file->text_beside + length, 1 };
    reader r = { file, start, error, 0, 0, { { NULL, 0 }, { NULL, 0 } }, 1, { NULL, 0 }, file->contacts, 0,
                 { NULL, 0 }, 0, 0 };
    const obj_file was = *file;
    int status;

    file->path = file->beside;                          /* of messages */
    file->gravity_line = 0;
    memset(file->strength_line, 0, sizeof file->strength_line);
    status = read_lines(&r);
    if (!status) status = obj_names_resolve(file, error);
    file->path = was.path;
    turn_lines(file, &was);
    return status;
}

int obj_read_beside(obj_file *file, failure *error)
{
    const size_t n = strlen(file->path);
    size_t length;
    FILE *there;
    int status;

    if (strcmp(file->path, "-") == 0) return 0;
    file->beside = malloc(n + sizeof OBJ_BESIDE);
    if (!file->beside) return fail_with(error, EXIT_MEMORY, file->path, 0, "out of memory while reading");
    memcpy(file->beside, file->path, n);
    memcpy(file->beside + n, OBJ_BESIDE, sizeof OBJ_BESIDE);
    there = fopen(file->beside, "rb");
    if (!there && errno == ENOENT) {
        free(file->beside);
        file->beside = NULL;
        return 0;
    }
    if (there) fclose(there);
    status = file_read(file->beside, &file->text_beside, &length, error);
    return status ? status : parse_beside(file, length, error);
}
