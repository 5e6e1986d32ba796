#include "compas.h"
#include "compas_mesh.h"
#include "compas_text.h"
#include "json_in.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEPTH_MAX 16            /* wrappers around a value; tables around the nodes */
#define ALL_HELD  63            /* bits of x y z rx ry rz */

/* A reading: the JSON, what of it describes the assembly, the blocks so far, and the scene file as it grows. */
typedef struct reader {
    const char *path;
    failure *error;
    json_tree tree;
    const json_value *node, *edge, *preset, *blocks, *elements, *materials, *contact, *conditions;
    compas_unread unread;
    compas_solids solids;
    compas_text out;
    long edges, whole;                  /* asked for polygons; those that have them */
} reader;

/* ------------------------------------------------------------------------------------------------------------- values */

static int fail(reader *r, const json_value *at, const char *format, ...)
{
    char message[256];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    return fail_with(r->error, EXIT_SCENE, r->path, at ? at->line : 0, "%s", message);
}

static int out_of_memory(reader *r) { return fail_with(r->error, EXIT_MEMORY, r->path, 0, "out of memory while reading"); }

static const json_value *member(const reader *r, const json_value *object, const char *key)
{
    return json_member(&r->tree, object, key);
}

/* The first member of those two names. */
static const json_value *either(const reader *r, const json_value *object, const char *key, const char *other)
{
    const json_value *v = member(r, object, key);
    return v ? v : member(r, object, other);
}

/* What is inside the wrappers { dtype | datatype, data | value }; NULL for null. */
static const json_value *plain(const reader *r, const json_value *v)
{
    for (int depth = 0; depth < DEPTH_MAX && v && either(r, v, "dtype", "datatype"); depth++) {
        const json_value *inner = either(r, v, "data", "value");
        if (!inner) break;
        v = inner;
    }
    return v && v->kind != JSON_NULL ? v : NULL;
}

static const json_value *plain_member(const reader *r, const json_value *object, const char *key)
{
    return plain(r, member(r, object, key));
}

static const json_value *at(const reader *r, int32_t i) { return i < 0 ? NULL : &r->tree.value[i]; }
static const json_value *first(const reader *r, const json_value *v)
{
    return v && (v->kind == JSON_ARRAY || v->kind == JSON_OBJECT) ? at(r, v->first) : NULL;
}
static const json_value *next(const reader *r, const json_value *v) { return at(r, v->next); }
static int is_single(const reader *r, const json_value *v) { return first(r, v) && !next(r, first(r, v)); }

static int is_true(const json_value *v) { return v && (v->kind == JSON_BOOL || v->kind == JSON_NUMBER) && v->as.number != 0; }
static const json_value *number(const json_value *v) { return v && v->kind == JSON_NUMBER ? v : NULL; }
static int is_table(const json_value *v) { return v && v->kind == JSON_OBJECT; }

/* [x, y, z] or { x, y, z }.     returns 0: it is neither */
static int read_point(const reader *r, const json_value *v, double x[3])
{
    static const char *const name[] = { "x", "y", "z" };
    const json_value *each = first(r, v = plain(r, v));
    for (int k = 0; k < 3; k++) {
        const json_value *c = is_table(v) ? member(r, v, name[k]) : each;
        if (!c || c->kind != JSON_NUMBER) return 0;
        x[k] = c->as.number;
        if (each) each = next(r, each);
    }
    return is_table(v) || (v->kind == JSON_ARRAY && !each);
}

/* A key without quotes of its own, which old files gave it. */
static text_word bare(const char *key)
{
    text_word w = { key, strlen(key) };
    if (w.n > 1 && (key[0] == '\'' || key[0] == '"') && key[w.n - 1] == key[0]) { w.s++; w.n -= 2; }
    return w;
}

/* The key that a value names: of a string itself, of a number its digits. */
static text_word named(const json_value *v, char digits[32])
{
    if (v->kind == JSON_STRING) return bare(v->as.string);
    const text_word w = { digits, (size_t)snprintf(digits, 32, "%.17g", v->kind == JSON_NUMBER ? v->as.number : -1) };
    return w;
}

/* -------------------------------------------------------------------------------------------------------- sorted tables */

typedef struct entry {
    text_word key;
    int32_t whole;              /* the key's number, -1: it is none */
    const json_value *value;
} entry;

typedef struct table {
    entry *each;
    int32_t count;
} table;

static int compare_keys(const void *a, const void *b)
{
    const entry *x = a, *y = b;
    if (x->whole != y->whole) return (x->whole > y->whole) - (x->whole < y->whole);
    const size_t n = x->key.n < y->key.n ? x->key.n : y->key.n;
    const int c = n ? memcmp(x->key.s, y->key.s, n) : 0;
    return c ? c : (x->key.n > y->key.n) - (x->key.n < y->key.n);
}

static entry make_entry(text_word key, const json_value *value)
{
    entry e = { key, -1, value };
    if (text_int(key, &e.whole) != TEXT_NUMBER || e.whole < 0) e.whole = -1;
    return e;
}

/* The members of an object, or of a list by their numbers' order, sorted by key: whole numbers as such. Free each. */
static int sort_table(reader *r, const json_value *object, table *t)
{
    t->count = 0;
    for (const json_value *v = first(r, object); v; v = next(r, v)) t->count++;
    t->each = malloc(((size_t)t->count + 1) * sizeof *t->each);
    if (!t->each) return out_of_memory(r);
    t->count = 0;
    for (const json_value *v = first(r, object); v; v = next(r, v), t->count++) {
        if (v->key) t->each[t->count] = make_entry(bare(v->key), v);
        else { const entry e = { { "", 0 }, t->count, v }; t->each[t->count] = e; }
    }
    if (t->count > 1) qsort(t->each, (size_t)t->count, sizeof *t->each, compare_keys);
    return 0;
}

/* Place of a key in a sorted table, -1: not there. */
static int32_t find(const table *t, text_word key)
{
    const entry wanted = make_entry(key, NULL);
    const entry *e = t->count ? bsearch(&wanted, t->each, (size_t)t->count, sizeof wanted, compare_keys) : NULL;
    return e ? (int32_t)(e - t->each) : -1;
}

/* --------------------------------------------------------------------------------------------------------------- output */

/* Append to the text, whose newline ends a line that stands in the JSON at `from`. */
static int put(reader *r, const json_value *from, const char *format, ...)
{
    char some[512];
    va_list args;
    va_start(args, format);
    const int n = vsnprintf(some, sizeof some, format, args);
    va_end(args);
    if (n < 0 || (size_t)n >= sizeof some) return fail(r, from, "a name is too long");
    return compas_text_add(&r->out, some, (size_t)n, from ? from->line : 1) ? 0 : out_of_memory(r);
}

/* b and the key: letters, digits, - _ . of it. */
static const char *block_name(text_word key, char name[100])
{
    size_t n = 1;
    name[0] = 'b';
    for (size_t i = 0; i < key.n && n < 99; i++) {
        const char c = key.s[i];
        const int keep = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')
                      || c == '-' || c == '_' || c == '.' || (unsigned char)c > 127;
        name[n++] = keep ? c : '_';
    }
    name[n] = 0;
    return name;
}

/* --------------------------------------------------------------------------------------------------------------- meshes */

/* The vertices of a mesh, by key. */
static int read_vertices(reader *r, const table *vertex, const json_value *preset, const char *name)
{
    static const char *const axis[] = { "x", "y", "z" };
    for (int32_t i = 0; i < vertex->count; i++) {
        const json_value *v = plain(r, vertex->each[i].value);
        double x[3] = { 0, 0, 0 };
        for (int k = 0; k < 3; k++) {
            const json_value *c = member(r, v, axis[k]);
            if (!c) c = member(r, preset, axis[k]);
            if (c && c->kind != JSON_NUMBER) return fail(r, c, "block '%s': %s of a vertex is not a number", name, axis[k]);
            if (c) x[k] = c->as.number;
        }
        if (!compas_add_vertex(&r->solids, x)) return out_of_memory(r);
    }
    return 0;
}

static int read_faces(reader *r, const table *vertex, const json_value *faces, const char *name)
{
    table face;
    int status = sort_table(r, faces, &face);
    for (int32_t i = 0; i < face.count && !status; i++) {
        int32_t corners = 0;
        for (const json_value *c = first(r, plain(r, face.each[i].value)); c && !status; c = next(r, c)) {
            char digits[32];
            const text_word key = named(c, digits);
            const int32_t v = find(vertex, key);
            if (v < 0) status = fail(r, c, "block '%s': a face has the vertex '%.*s', which is not there", name,
                                     (int)(key.n < 40 ? key.n : 40), key.s);
            else if (!compas_add_corner(&r->solids, v)) status = out_of_memory(r);
            else corners++;
        }
        if (!status && corners < 3)
            status = fail(r, face.each[i].value, "block '%s': a face has %ld corners", name, (long)corners);
        if (!status && !compas_end_face(&r->solids)) status = out_of_memory(r);
    }
    free(face.each);
    return status;
}

/* 4 x 4 of { matrix }, or none. */
static int read_frame(reader *r, const json_value *v, double frame[12], const char *name)
{
    const json_value *row = first(r, plain_member(r, v = plain(r, v), "matrix"));
    if (!v) return 0;
    for (int i = 0; i < 3; i++, row = next(r, row)) {
        const json_value *c = first(r, row);
        for (int k = 0; k < 4; k++, c = next(r, c)) {
            if (!c || c->kind != JSON_NUMBER) return fail(r, v, "block '%s': its transformation is no matrix of 4 x 4", name);
            frame[4 * i + k] = c->as.number;
        }
        if (i < 2 && !next(r, row)) return fail(r, v, "block '%s': its transformation is no matrix of 4 x 4", name);
    }
    return 0;
}

static int is_box(const reader *r, const json_value *v)
{
    return is_table(v) && member(r, v, "xsize") && member(r, v, "frame");
}

/* x y z of a box's frame: its point and its axes, unit vectors across each other. */
static int read_box_frame(const reader *r, const json_value *box, double point[3], double axis[3][3])
{
    const json_value *frame = plain_member(r, box, "frame");
    const int ok = read_point(r, member(r, frame, "point"), point) && read_point(r, member(r, frame, "xaxis"), axis[0])
                && read_point(r, member(r, frame, "yaxis"), axis[1]);
    return ok && compas_unit_axes(axis);
}

/* compas.geometry/Box: a frame in its middle and three sizes. */
static int read_box(reader *r, const json_value *box, const char *name)
{
    static const char *const size[] = { "xsize", "ysize", "zsize" };
    double point[3], axis[3][3];
    if (!read_box_frame(r, box, point, axis))
        return fail(r, box, "block '%s': its box has no frame: a point and two axes that are not parallel", name);
    for (int k = 0; k < 3; k++) {
        const json_value *c = number(member(r, box, size[k]));
        if (!c) return fail(r, box, "block '%s': its box has no %s", name, size[k]);
        for (int i = 0; i < 3; i++) axis[k][i] *= c->as.number / 2;
    }
    return compas_add_box(&r->solids, point, axis) ? 0 : out_of_memory(r);
}

static int read_tables(reader *r, const json_value *mesh, const char *name)
{
    table vertex = { NULL, 0 };
    int status = sort_table(r, member(r, mesh, "vertex"), &vertex);
    if (!status && !compas_begin(&r->solids)) status = out_of_memory(r);
    if (!status) status = read_vertices(r, &vertex, plain(r, either(r, mesh, "default_vertex_attributes", "dva")), name);
    if (!status) status = read_faces(r, &vertex, member(r, mesh, "face"), name);
    free(vertex.each);
    return status;
}

/* A block from its mesh; where: what holds a transformation, or NULL. */
static int read_mesh(reader *r, const json_value *from, const json_value *block, const json_value *where, const char *name)
{
    const json_value *mesh = plain(r, block), *moved = member(r, where, "transformation");
    double frame[12] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
    int status;
    while (mesh && mesh->kind == JSON_ARRAY && is_single(r, mesh)) mesh = plain(r, first(r, mesh));
    if (is_box(r, mesh)) status = read_box(r, mesh, name);
    else if (is_table(member(r, mesh, "vertex")) && is_table(member(r, mesh, "face"))) status = read_tables(r, mesh, name);
    else status = fail(r, from, "block '%s' has no mesh: vertex and face tables", name);
    if (!status && moved) status = read_frame(r, moved, frame, name);
    if (!status) compas_end(&r->solids, frame);
    return status;
}

/* --------------------------------------------------------------------------------------------------------------- blocks */

/* Member of a table by a key that a value names, or of a list the one whose guid it is. */
static const json_value *look_up(const reader *r, const json_value *in, const json_value *key)
{
    if (!in || !key || key->kind != JSON_STRING) return NULL;
    if (is_table(in)) return member(r, in, key->as.string);
    for (const json_value *v = first(r, in); v; v = next(r, v)) {
        const json_value *guid = member(r, v, "guid");
        if (guid && guid->kind == JSON_STRING && strcmp(guid->as.string, key->as.string) == 0) return v;
    }
    return NULL;
}

/* Rates that displacements of the problem hold at 0, x y z and about them, of the block of this key: its bits. What they move
 * is not read. */
static int read_held(reader *r, text_word key)
{
    static const char *const part[] = { "translation", "rotation" };
    const json_value *list = plain_member(r, r->conditions, "displacements");
    int held = 0;
    for (const json_value *v = first(r, list); v; v = next(r, v)) {
        const json_value *index = member(r, v, "block_index");
        char digits[32];
        const text_word of = index ? named(index, digits) : key;
        if (!index || of.n != key.n || memcmp(of.s, key.s, key.n)) continue;
        for (int k = 0; k < 6; k++) {
            const json_value *rate = first(r, plain_member(r, v, part[k / 3]));
            for (int i = 0; i < k % 3 && rate; i++) rate = next(r, rate);
            if (!rate || rate->kind != JSON_NUMBER) continue;
            held |= 1 << k;
            r->unread.moves += rate->as.number != 0;
        }
    }
    return held;
}

static int put_fixed(reader *r, const json_value *from, int held)
{
    static const char *const word[] = { "x", "y", "z", "rx", "ry", "rz" };
    int status = held ? put(r, from, "#@ fixed") : 0;
    for (int k = 0; k < 6 && held != ALL_HELD && !status; k++) if (held >> k & 1) status = put(r, from, " %s", word[k]);
    return status || !held ? status : put(r, from, "\n");
}

static int put_solid(reader *r, const json_value *from, const char *name, int held, double density)
{
    const compas_solid s = compas_last(&r->solids);
    int status = put(r, from, "o %s\n", name);
    if (!status) status = put_fixed(r, from, held);
    if (!status && density > 0) status = put(r, from, "#@ density %.17g\n", density);
    for (int32_t v = 0; v < s.vertices && !status; v++)
        status = put(r, from, "v %.17g %.17g %.17g\n", s.xyz[v][0], s.xyz[v][1], s.xyz[v][2]);
    for (int32_t i = 0; i < s.faces && !status; i++) {
        const int32_t n = s.face[i + 1] - s.face[i], *c = s.corner + s.face[i];
        status = put(r, from, "f");
        for (int32_t q = 0; q < n && !status; q++) status = put(r, from, " %ld", (long)s.before + c[q] + 1);
        if (!status) status = put(r, from, "\n");
    }
    return status;
}

/* The block of a node: its attribute, or in the tables of blocks, or the element that the node names. */
static int read_node(reader *r, const entry *e)
{
    const json_value *own = plain(r, e->value), *element = NULL, *block = member(r, own, "block"), *material;
    char name[100];
    double density = 0;
    block_name(e->key, name);
    if (!plain(r, block) && is_table(r->blocks)) block = member(r, r->blocks, e->value->key);
    if (!plain(r, block)) {
        const json_value *key = member(r, own, "element");
        element = plain(r, key && key->kind == JSON_STRING ? look_up(r, r->elements, key) : key);
        block = either(r, element, "geometry", "shape");
    }
    if (!plain(r, block)) return fail(r, e->value, "node '%.*s' has no block", (int)(e->key.n < 60 ? e->key.n : 60), e->key.s);
    material = plain(r, look_up(r, r->materials, member(r, element, "material")));
    if (member(r, material, "density") && member(r, material, "density")->kind == JSON_NUMBER)
        density = member(r, material, "density")->as.number;
    const int told = member(r, own, "is_support") || member(r, own, "is_anchor");
    const int fixed = is_true(either(r, own, "is_support", "is_anchor")) || is_true(member(r, element, "is_support"))
                   || (!told && is_true(member(r, r->preset, "is_support")));
    if (read_mesh(r, e->value, block, element, name)) return r->error->status;
    const int held = read_held(r, e->key);
    return put_solid(r, e->value, name, fixed ? ALL_HELD : held, density);
}

static int read_listed(reader *r, const json_value *v, long k)
{
    const json_value *inner = plain(r, v), *block = either(r, inner, "geometry", "shape");
    char name[32];
    snprintf(name, sizeof name, "b%ld", k);
    if (read_mesh(r, v, block ? block : v, block ? inner : NULL, name)) return r->error->status;
    return put_solid(r, v, name, is_true(member(r, inner, "is_support")) ? ALL_HELD : 0, 0);
}

/* Blocks of a list, or elements of a model without a graph, by their numbers; courses are lists in it. */
static int read_list(reader *r, const table *list)
{
    long n = 0;
    int status = 0;
    for (int32_t k = 0; k < list->count && !status; k++) {
        const json_value *v = list->each[k].value, *course = plain(r, v);
        const int is_course = course && course->kind == JSON_ARRAY && first(r, course) && !is_single(r, course);
        if (!is_course) status = read_listed(r, v, n++);
        for (const json_value *b = is_course ? first(r, course) : NULL; b && !status; b = next(r, b))
            status = read_listed(r, b, n++);
    }
    return status;
}

/* ------------------------------------------------------------------------------------------------------------- contacts */

/* The points of one joint: its list, or that of its polygon. */
static const json_value *joint_points(const reader *r, const json_value *joint)
{
    static const char *const name[] = { "points", "_points", "interface_points" };
    for (int k = 0; k < 3; k++) {
        const json_value *p = plain_member(r, joint, name[k]);
        if (p) return p;
    }
    const json_value *polygon = plain_member(r, joint, "polygon");
    return is_table(polygon) ? plain_member(r, polygon, "points") : polygon;
}

/* The joints of an edge: a list, one, or the edge itself; NULL: it has no polygon. */
static const json_value *edge_joints(const reader *r, const json_value *edge)
{
    static const char *const name[] = { "interfaces", "interface", "contacts" };
    for (int k = 0; k < 3; k++) {
        const json_value *j = plain_member(r, edge, name[k]);
        if (j && (first(r, j) || !is_table(j))) return first(r, j) ? j : NULL;
    }
    return member(r, edge, "interface_points") && first(r, plain_member(r, edge, "interface_points")) ? edge : NULL;
}

static int put_joint(reader *r, const table *node, const int32_t pair[2], const json_value *from, const json_value *points)
{
    char name[2][100];
    int32_t n = 0;
    int status = 0;
    for (const json_value *p = first(r, points); p; p = next(r, p)) n++;
    double (*x)[3] = malloc(((size_t)n + 1) * sizeof *x);
    if (!x) return out_of_memory(r);
    n = 0;
    for (const json_value *p = first(r, points); p && !status; p = next(r, p))
        if (!read_point(r, p, x[n++])) status = fail(r, p, "a point of an interface is not three numbers");
    if (n > 3 && memcmp(x[0], x[n - 1], sizeof *x) == 0) n--;
    const int turned = !status && compas_is_turned(&r->solids, pair[0], pair[1], x, n);
    for (int k = 0; k < 2; k++) block_name(node->each[pair[k]].key, name[k]);
    if (!status) status = put(r, from, "#@ interface %s %s", name[0], name[1]);
    for (int32_t k = 0; k < n && !status; k++) {
        const double *q = x[turned ? n - 1 - k : k];
        status = put(r, from, " %.17g %.17g %.17g", q[0], q[1], q[2]);
    }
    free(x);
    return status ? status : put(r, from, "\n");
}

/* Do all joints have their polygons? An edge without any is no contact but the wish to find one. */
static int have_polygons(const reader *r, const json_value *edge)
{
    const json_value *joints = edge_joints(r, edge);
    if (!joints) return 0;
    if (joints == edge || is_table(joints)) return joint_points(r, joints) != NULL;
    for (const json_value *j = first(r, joints); j; j = next(r, j)) if (!joint_points(r, plain(r, j))) return 0;
    return 1;
}

static int put_edge(reader *r, const table *node, const int32_t pair[2], const json_value *edge)
{
    const json_value *joints = edge_joints(r, edge);
    int status = 0;
    if (joints == edge || is_table(joints)) return put_joint(r, node, pair, edge, joint_points(r, joints));
    for (const json_value *j = first(r, joints); j && !status; j = next(r, j))
        status = put_joint(r, node, pair, j, joint_points(r, plain(r, j)));
    return status;
}

/* The two nodes of "(a, b)". */
static int read_pair(const table *node, text_word key, int32_t pair[2])
{
    text_word part[2] = { { key.s + 1, 0 }, { NULL, 0 } };
    while (part[0].n + 2 < key.n && part[0].s[part[0].n] != ',') part[0].n++;
    part[1].s = part[0].s + part[0].n + 1;
    part[1].n = key.n > part[0].n + 3 ? key.n - part[0].n - 3 : 0;
    for (int k = 0; k < 2; k++) {
        while (part[k].n && (*part[k].s == ' ' || *part[k].s == '\'')) { part[k].s++; part[k].n--; }
        while (part[k].n && (part[k].s[part[k].n - 1] == ' ' || part[k].s[part[k].n - 1] == '\'')) part[k].n--;
        pair[k] = find(node, part[k]);
    }
    return pair[0] >= 0 && pair[1] >= 0;
}

static void ask_edge(reader *r, const json_value *edge)
{
    r->edges++;
    r->whole += have_polygons(r, edge);
}

/* Every edge, of { a: { b: attributes } } or { "(a, b)": attributes }: writes its joints, or asks whether it has polygons. */
static int walk_edges(reader *r, const table *node, int writes)
{
    table from, to;
    int status = sort_table(r, r->edge, &from);
    for (int32_t i = 0; i < from.count && !status; i++) {
        const json_value *v = plain(r, from.each[i].value);
        const int joined = from.each[i].key.n > 2 && from.each[i].key.s[0] == '(';
        int32_t pair[2] = { find(node, from.each[i].key), -1 };
        if (joined && !read_pair(node, from.each[i].key, pair)) status = fail(r, from.each[i].value, "an edge of no two nodes");
        else if (joined && writes) status = put_edge(r, node, pair, v);
        else if (joined) ask_edge(r, v);
        if (status || joined) continue;
        status = sort_table(r, v, &to);
        for (int32_t k = 0; k < to.count && !status; k++) {
            pair[1] = find(node, to.each[k].key);
            if (pair[0] < 0 || pair[1] < 0) status = fail(r, to.each[k].value, "an edge of no two nodes");
            else if (writes) status = put_edge(r, node, pair, plain(r, to.each[k].value));
            else ask_edge(r, plain(r, to.each[k].value));
        }
        free(to.each);
    }
    free(from.each);
    return status;
}

/* -------------------------------------------------------------------------------------------------------------- problem */

/* Friction of all contacts by the problem's Mohr-Coulomb law: mu, or the tangent of phi in degrees. */
static int put_friction(reader *r)
{
    const json_value *law = plain_member(r, r->contact, "contact_model");
    const json_value *mu = number(member(r, law, "mu")), *phi = number(member(r, law, "phi"));
    const json_value *c = number(member(r, law, "c")), *t = number(member(r, law, "t_c"));
    const double value = mu ? mu->as.number : phi ? tan(phi->as.number * acos(-1.0) / 180) : 0;
    r->unread.strength = (c && c->as.number != 0) || (t && t->as.number != 0);
    if (!mu && !phi) return 0;
    if (!(value >= 0)) return fail(r, law, "friction of the contact model is below 0");
    return put(r, law, "#@ mu %.17g\n", value);
}

/* g along -z where the problem asks for gravity, and accelerations of all blocks. Weight counts also where it asks for none. */
static int put_gravity(reader *r)
{
    const json_value *g = member(r, r->conditions, "g"), *more = plain_member(r, r->conditions, "body_forces");
    const int told = is_true(member(r, r->conditions, "gravity")) && number(g);
    double sum[3] = { 0, 0, told ? -g->as.number : -9.80665 };
    for (const json_value *v = first(r, more); v; v = next(r, v)) {
        double a[3];
        if (!read_point(r, v, a)) return fail(r, v, "a body force is not three numbers");
        for (int k = 0; k < 3; k++) sum[k] += a[k];
    }
    return told || first(r, more) ? put(r, r->conditions, "#@ gravity %.17g %.17g %.17g\n", sum[0], sum[1], sum[2]) : 0;
}

static int put_load(reader *r, const table *node, const json_value *v)
{
    const json_value *index = member(r, v, "block_index");
    const json_value *point = plain_member(r, v, "point"), *moment = plain_member(r, v, "moment");
    double f[3], x[3] = { 0, 0, 0 };
    char digits[32], name[100];
    const int32_t i = index ? find(node, named(index, digits)) : -1;
    if (i < 0) return fail(r, v, "a point load is on a block that is not there");
    if (!read_point(r, member(r, v, "force"), f)) return fail(r, v, "the force of a point load is not three numbers");
    if ((point || moment) && !read_point(r, point ? point : moment, x)) return fail(r, v, "a point load acts nowhere");
    return put(r, v, "#@ load %s %.17g %.17g %.17g %.17g %.17g %.17g%s\n", block_name(node->each[i].key, name),
               f[0], f[1], f[2], x[0], x[1], x[2], point ? "" : " couple");
}

/* Problem of compas_dem: friction, gravity and point loads. Supports are told with their blocks. */
static int put_problem(reader *r, const table *node)
{
    const json_value *loads = plain_member(r, r->conditions, "point_loads");
    const json_value *pressed = plain_member(r, r->conditions, "surface_loads");
    int status = put_friction(r);
    if (!status) status = put_gravity(r);
    for (const json_value *v = first(r, loads); v && !status; v = next(r, v)) status = put_load(r, node, v);
    for (const json_value *v = first(r, pressed); v; v = next(r, v)) r->unread.pressures++;
    return status;
}

/* ------------------------------------------------------------------------------------------------------------- whole file */

/* Of lists in lists the first entry that is none: a mesh or a box? */
static int holds_blocks(const reader *r, const json_value *v)
{
    for (int depth = 0; depth < 3 && v && v->kind == JSON_ARRAY; depth++) v = plain(r, first(r, v));
    return is_box(r, v) || (is_table(v) && is_table(member(r, v, "vertex")) && member(r, v, "face"));
}

/* Find the tables of the assembly inside graph, network, assembly, model, data.     returns a list of blocks, or NULL */
static const json_value *find_tables(reader *r, const json_value *v)
{
    static const char *const inside[] = { "graph", "network", "assembly", "model", "data" };
    for (int depth = 0; depth < DEPTH_MAX; depth++) {
        const json_value *inner = NULL;
        if (!is_table(member(r, v, "node"))) v = plain(r, v);        /* else what looks like a wrapper was merged into it */
        if (!is_table(v)) break;
        if (plain_member(r, v, "blocks")) r->blocks = plain_member(r, v, "blocks");
        if (plain_member(r, v, "elements")) r->elements = plain_member(r, v, "elements");
        if (plain_member(r, v, "materials")) r->materials = plain_member(r, v, "materials");
        if (plain_member(r, v, "contact_properties")) r->contact = plain_member(r, v, "contact_properties");
        if (plain_member(r, v, "boundary_conditions")) r->conditions = plain_member(r, v, "boundary_conditions");
        r->edge = plain_member(r, v, "edge");
        r->preset = plain(r, either(r, v, "default_node_attributes", "dna"));
        r->node = plain_member(r, v, "node");
        if (is_table(r->node)) return NULL;
        r->node = NULL;
        for (int k = 0; k < 5 && !inner; k++) inner = plain_member(r, v, inside[k]);
        if (!inner && is_table(r->blocks) && is_table(member(r, v, "vertex"))) {      /* before compas_assembly 0.2 */
            r->node = member(r, v, "vertex");
            r->preset = member(r, v, "dva");
            return NULL;
        }
        if (!inner) break;
        v = inner;
    }
    r->edge = NULL;
    if (r->elements) return r->elements;
    if (r->blocks) return r->blocks;
    for (const json_value *m = first(r, is_table(v) ? v : NULL); m; m = next(r, m))
        if (m->kind == JSON_ARRAY && holds_blocks(r, m)) return m;
    return v;
}

static int read_assembly(reader *r)
{
    const json_value *list = find_tables(r, &r->tree.value[0]);
    table node = { NULL, 0 };
    int status;
    if (!r->node && is_table(list) && is_table(member(r, list, "vertex")) && member(r, list, "face")) {
        const entry one = { { "0", 1 }, 0, list };
        const table alone = { (entry *)&one, 1 };
        return read_list(r, &alone);
    }
    if (!r->node && (!list || (list->kind != JSON_ARRAY && list != r->elements && list != r->blocks)))
        return fail(r, &r->tree.value[0], "JSON without an assembly: no node table, no list of meshes");
    status = sort_table(r, r->node ? r->node : list, &node);
    if (!status && !r->node) status = read_list(r, &node);
    for (int32_t i = 0; r->node && i < node.count && !status; i++) status = read_node(r, &node.each[i]);
    if (!status && r->node) status = put_problem(r, &node);
    if (!status && r->edge) status = walk_edges(r, &node, 0);
    if (!status && r->edge && r->whole == r->edges) status = walk_edges(r, &node, 1);
    free(node.each);
    return status;
}

/* Lines told of are those of the JSON. */
static void take_lines(const reader *r, obj_file *f)
{
    for (int32_t i = 0; i < f->blocks; i++) f->block[i].line = r->out.line[f->block[i].line - 1];
    for (int32_t i = 0; i < f->faces; i++) f->face[i].line = r->out.line[f->face[i].line - 1];
    for (int32_t i = 0; i < f->contacts; i++) f->contact[i].line = r->out.line[f->contact[i].line - 1];
}

int compas_is_json(const char *text, size_t length)
{
    size_t i = length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (i < length && strchr(" \t\r\n", text[i]) && text[i]) i++;
    return i < length && (text[i] == '{' || text[i] == '[');
}

int compas_parse(const char *path, char *text, size_t length, obj_file *file, failure *error)
{
    reader r = { 0 };
    const obj_file empty = { 0 };
    const size_t mark = length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    int status;
    r.path = path;
    r.error = error;
    *file = empty;
    memset(text, ' ', mark);                            /* the byte order mark */
    status = json_parse(path, text, length, &r.tree, error);
    if (!status) status = read_assembly(&r);
    if (!status && !r.out.text) status = fail_with(error, EXIT_SCENE, path, 1, "%s", sp_status_text(SP_E_EMPTY));
    if (!status) status = obj_parse(path, r.out.text, r.out.length, file, error);       /* it frees the text */
    else free(r.out.text);
    if (!status) take_lines(&r, file);
    file->nodes = 1;
    r.unread.edges = r.whole > 0 ? r.edges - r.whole : 0;
    file->unread = r.unread;
    compas_free(&r.solids);
    free(r.out.line);
    json_free(&r.tree);
    return status;
}
