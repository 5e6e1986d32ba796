/* From the tables of a file to the library's scene. What the library refuses is told with the line of the block or contact. */
#include "across.h"
#include "../run.h"
#include "bare.h"
#include "meshes.h"
#include "scene.h"
#include "solids.h"
#include "suspects.h"
#include "twins.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FLAT 1e-3                       /* of its extent: a mesh that reaches no farther out of its plane is a sheet */

/* Text for messages about a block or a contact. */
#define NAME(w) (int)((w).n < 60 ? (w).n : 60), (w).s, (w).n < 60 ? "" : "..."

static int out_of_memory(const obj_file *f, failure *error)
{
    return fail_with(error, EXIT_MEMORY, f->path, 0, "out of memory: %ld blocks, %ld vertices, %ld contact points",
                     (long)f->blocks, (long)f->vertices, (long)f->points);
}

/* ------------------------------------------------------------------------------------------------------- one block's mesh */

/* Room for the largest block, and for each vertex of the file its number in the block being built. */
typedef struct mesh_room {
    sp_real *xyz;
    int32_t *size, *corner, *used, *number;
} mesh_room;

static int32_t faces_of(const obj_file *f, int32_t b)
{
    return (b + 1 < f->blocks ? f->block[b + 1].face : f->faces) - f->block[b].face;
}

static int32_t corners_of(const obj_file *f, int32_t b)
{
    const int32_t end = f->block[b].face + faces_of(f, b);
    if (faces_of(f, b) == 0) return 0;
    return (end < f->faces ? f->face[end].corner : f->corners) - f->face[f->block[b].face].corner;
}

static void free_room(mesh_room *m)
{
    free(m->xyz);
    free(m->size);
    free(m->corner);
    free(m->used);
    free(m->number);
}

static int make_room(const obj_file *f, mesh_room *m)
{
    size_t faces = 1, corners = 1;
    for (int32_t b = 0; b < f->blocks; b++) {
        if ((size_t)faces_of(f, b) > faces) faces = (size_t)faces_of(f, b);
        if ((size_t)corners_of(f, b) > corners) corners = (size_t)corners_of(f, b);
    }
    m->xyz = malloc(3 * corners * sizeof *m->xyz);
    m->size = malloc(faces * sizeof *m->size);
    m->corner = malloc(corners * sizeof *m->corner);
    m->used = malloc(corners * sizeof *m->used);
    m->number = malloc(((size_t)f->vertices + 1) * sizeof *m->number);
    if (!m->xyz || !m->size || !m->corner || !m->used || !m->number) return 0;
    for (int32_t v = 0; v < f->vertices; v++) m->number[v] = -1;
    return 1;
}

static int ascending(const void *a, const void *b)
{
    const int32_t x = *(const int32_t *)a, y = *(const int32_t *)b;
    return (x > y) - (x < y);
}

/* The mesh of block b with the vertices it uses, in the order of the file. */
static sp_mesh gather_mesh(const obj_file *f, int32_t b, mesh_room *m)
{
    const int32_t faces = faces_of(f, b), corners = corners_of(f, b);
    const int32_t *c = faces ? f->corner + f->face[f->block[b].face].corner : f->corner;
    sp_mesh mesh = { 0, faces, m->xyz, m->size, m->corner };

    for (int32_t i = 0; i < faces; i++) m->size[i] = f->face[f->block[b].face + i].corners;
    for (int32_t i = 0; i < corners; i++)
        if (m->number[c[i]] < 0) {
            m->number[c[i]] = 0;
            m->used[mesh.vertices++] = c[i];
        }
    if (mesh.vertices > 1) qsort(m->used, (size_t)mesh.vertices, sizeof *m->used, ascending);
    for (int32_t i = 0; i < mesh.vertices; i++) {
        m->number[m->used[i]] = i;
        memcpy(m->xyz + 3 * i, f->vertex[m->used[i]], 3 * sizeof *m->xyz);
    }
    for (int32_t i = 0; i < corners; i++) m->corner[i] = m->number[c[i]];
    for (int32_t i = 0; i < mesh.vertices; i++) m->number[m->used[i]] = -1;
    return mesh;
}

/* A support may be a name only: then it has no mesh, and what touches it must be given. */
static sp_status add_mesh(const obj_file *f, const obj_block *block, const sp_mesh *mesh, sp_scene *scene)
{
    const sp_real origin[3] = { 0, 0, 0 };
    if (mesh->faces == 0 && block->fixed == SP_FIXED) return sp_scene_body(scene, 0, origin, SP_FIXED, NULL);
    return sp_scene_block(scene, mesh, block->density > 0 ? block->density : f->density, block->fixed, NULL);
}

/* Does no corner x stand off the plane of the first face, n . (x - o) = 0, by more than a thousandth of |x - o|? */
static int is_sheet(const sp_mesh *m)
{
    const sp_real *o = m->xyz + 3 * m->corner[0];
    double n[3] = { 0, 0, 0 };
    for (int32_t k = 1; k + 1 < m->size[0]; k++) {
        const sp_real *p = m->xyz + 3 * m->corner[k], *q = m->xyz + 3 * m->corner[k + 1];
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, l = (i + 2) % 3;
            n[i] += (double)(p[j] - o[j]) * (double)(q[l] - o[l]) - (double)(p[l] - o[l]) * (double)(q[j] - o[j]);
        }
    }
    for (int32_t v = 0; v < m->vertices; v++) {
        const sp_real *x = m->xyz + 3 * v;
        double off = 0, far = 0;
        for (int i = 0; i < 3; i++) {
            off += n[i] * (double)(x[i] - o[i]);
            far = fmax(far, fabs((double)(x[i] - o[i])));
        }
        if (fabs(off) > FLAT * far * (fabs(n[0]) + fabs(n[1]) + fabs(n[2]))) return 0;
    }
    return fabs(n[0]) + fabs(n[1]) + fabs(n[2]) > 0;
}

/* A plane that a model stands on has no inside: it can be a support. */
static int refuse_sheet(const obj_file *f, const obj_block *block, const char *what, failure *error)
{
    return fail_with(error, EXIT_SCENE, OBJ_AT(f, block->line), "%s: %s; a sheet can be a support alone, as of the ground: "
                     "--fixed %.*s", what, sp_status_text(SP_E_OPEN), (int)(block->name.n < 60 ? block->name.n : 60),
                     block->name.s);
}

static int add_block(const obj_file *f, int32_t b, mesh_room *m, sp_scene *scene, failure *error)
{
    const obj_block *block = &f->block[b];
    const sp_mesh mesh = gather_mesh(f, b, m);
    const sp_status status = add_mesh(f, block, &mesh, scene);
    char what[96];

    if (status == SP_OK) return 0;
    snprintf(what, sizeof what, "block '%.*s%s'", NAME(block->name));
    if (mesh.faces == 0) return fail_with(error, EXIT_SCENE, OBJ_AT(f, block->line), "%s has no faces", what);
    if (status == SP_E_OPEN && is_sheet(&mesh)) return refuse_sheet(f, block, what, error);
    return fail_status(error, status, OBJ_AT(f, block->line), what);
}

static void name_contact(const obj_contact *c, char what[192])
{
    snprintf(what, 192, "contact '%.*s%s' '%.*s%s'", NAME(c->name[0]), NAME(c->name[1]));
}

/* A joint with this friction and strength; of strength the scene's where a number is below 0 (points have none: no area). */
static sp_strength make_strength(const obj_file *f, sp_real mu, const sp_real own[3], int polygon)
{
    sp_real k[3];
    for (int i = 0; i < 3; i++) k[i] = own[i] >= 0 ? own[i] : polygon ? f->strength[i] : 0;
    const sp_strength strength = { mu, k[0], k[1], k[2] };
    return strength;
}

/* Tension ends where the cone does, at cohesion / mu: with friction and no cohesion it would be nothing. c: of this contact,
 * NULL: of those that are found.     returns 0, or fails */
static int refuse_vain_tension(const obj_file *f, const sp_strength *j, const obj_contact *c, failure *error)
{
    const int32_t line = c && c->strength_line[1] ? c->strength_line[1] : f->strength_line[1];
    char what[192] = "contacts";
    if (!(j->tension > 0) || j->cohesion > 0 || !(j->mu > 0)) return 0;
    if (c) name_contact(c, what);
    return fail_with(error, EXIT_SCENE, OBJ_AT(f, line), "%s: tension counts up to cohesion / mu: without cohesion it "
                     "is nothing", what);
}

static int add_contact(const obj_file *f, int32_t i, sp_real mu, sp_scene *scene, failure *error)
{
    const obj_contact *c = &f->contact[i];
    const sp_strength strength = make_strength(f, mu >= 0 ? mu : c->mu >= 0 ? c->mu : f->mu, c->strength, c->polygon);
    const sp_real *xyz = f->point[c->point];
    if (refuse_vain_tension(f, &strength, c, error)) return error->status;
    const sp_status status = c->polygon ? sp_scene_joint(scene, c->a, c->b, c->points, xyz, &strength, NULL)
                                        : sp_scene_points(scene, c->a, c->b, c->n, c->points, xyz, &strength, NULL);
    char what[192];

    if (status == SP_OK) return 0;
    name_contact(c, what);
    return fail_status(error, status, OBJ_AT(f, c->line), what);
}

static int add_load(const obj_file *f, int32_t i, sp_scene *scene, failure *error)
{
    const obj_load *l = &f->load[i];
    sp_load load = { 0 };
    sp_status status;
    char what[96];

    load.block = l->block;
    load.live = l->live;
    if (l->kind == OBJ_MASS) load.mass = l->f[0];
    else memcpy(load.force, l->f, sizeof load.force);
    memcpy(load.point, l->kind == OBJ_COUPLE ? scene->block[l->block].centroid : l->x, sizeof load.point);
    if (l->kind == OBJ_COUPLE) memcpy(load.couple, l->x, sizeof load.couple);
    if (l->kind == OBJ_PRESSURE) status = sp_scene_pressure(scene, l->block, l->face, l->f[0], l->live, NULL);
    else status = sp_scene_load(scene, &load, NULL);
    if (status == SP_OK) return 0;
    snprintf(what, sizeof what, "load on '%.*s%s'", NAME(l->name));
    if (status == SP_E_INDEX)
        return fail_with(error, EXIT_SCENE, OBJ_AT(f, l->line), "%s: it has no face %ld", what, (long)l->face + 1);
    return fail_status(error, status, OBJ_AT(f, l->line), what);
}

/* --------------------------------------------------------------------------------------------------------- whole scene */

/* Exactly what the meshes of the file need; the vertices of a block are those its faces use. */
static int count_meshes(const obj_file *f, sp_capacity *cap, mesh_room *m)
{
    cap->blocks = f->blocks;
    cap->faces = f->faces;
    cap->corners = f->corners;
    cap->loads = f->loads;
    cap->vertices = 0;
    for (int32_t b = 0; b < f->blocks; b++) {
        const int32_t more = gather_mesh(f, b, m).vertices;
        if (more > INT32_MAX - cap->vertices) return 0;
        cap->vertices += more;
    }
    return 1;
}

/* An empty scene in new memory. */
static int create_scene(const obj_file *f, const sp_capacity *cap, host_scene *s, failure *error)
{
    sp_arena arena;
    free(s->memory);
    s->bytes = sp_scene_memory(cap);
    if (run_arena(s->bytes, &arena, &s->memory) != SP_OK || sp_scene_create(&s->scene, cap, &arena) != SP_OK)
        return out_of_memory(f, error);
    memcpy(s->scene.gravity, f->gravity, sizeof f->gravity);
    return 0;
}

static int build_blocks(const obj_file *f, const sp_capacity *cap, mesh_room *m, host_scene *s, failure *error)
{
    int status = create_scene(f, cap, s, error);
    for (int32_t b = 0; !status && b < f->blocks; b++) status = add_block(f, b, m, &s->scene, error);
    for (int32_t i = 0; !status && i < f->loads; i++) status = add_load(f, i, &s->scene, error);
    return status;
}

static int find_once(const obj_file *f, host_scene *s, sp_contact_report *report, sp_status *status, failure *error)
{
    sp_contact_settings settings = touching_settings(s->touching);
    void *memory;
    sp_arena scratch;

    settings.strength = s->strength;
    if (run_arena(run_bytes(&s->scene, SP_FOR_CONTACTS, NULL), &scratch, &memory) != SP_OK) return out_of_memory(f, error);
    *status = sp_contacts_find(&s->scene, &settings, scratch, report);
    free(memory);
    return 0;
}

/* Contacts are found in a scene without room for any, which tells how many there are, then once more with just that room:
 * memory stays exact. Overlaps are kept on the second pass. */
static int find_contacts(const obj_file *f, sp_capacity *cap, mesh_room *m, touching told, host_scene *s, failure *error)
{
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    sp_status status;
    int failed;

    s->found = 1;
    s->touching = touching_join(told, f->contact_told);
    s->strength = make_strength(f, s->mu, f->strength, 1);
    if (refuse_vain_tension(f, &s->strength, NULL, error)) return error->status;
    failed = find_once(f, s, &report, &status, error);
    if (failed) return failed;
    if (status != SP_OK && status != SP_E_CAPACITY) return fail_status(error, status, f->path, f->lines, "contacts");
    if (report.overlaps > 0) {
        s->overlap = malloc((size_t)report.overlaps * sizeof *s->overlap);
        if (!s->overlap) return out_of_memory(f, error);
    }
    if (status == SP_OK && report.overlaps == 0) return 0;
    cap->joints = report.joints;
    cap->points = report.points;
    report.overlap = s->overlap;
    report.overlap_capacity = report.overlaps;
    failed = build_blocks(f, cap, m, s, error);
    if (!failed) failed = find_once(f, s, &report, &status, error);
    if (failed) return failed;
    if (status != SP_OK) return fail_status(error, status, f->path, f->lines, "contacts");
    s->overlaps = report.overlaps;
    return 0;
}

/* *line: the first where something above 0 is told. */
static void keep_first_line(sp_real x, int32_t told, int32_t *line)
{
    if (x > 0 && told && (!*line || labs(told) < labs(*line))) *line = told;
}

/* Where what stands in the file, for messages after the file is let go. */
static int keep_lines(const obj_file *f, int given, host_scene *s, failure *error)
{
    int32_t *line = malloc(((size_t)f->blocks + (size_t)f->contacts + (size_t)f->loads + 1) * sizeof *line);
    s->line = line;
    if (!line) return out_of_memory(f, error);
    s->given = given ? f->contacts : 0;
    s->gravity_line = f->gravity_line;
    for (int32_t b = 0; b < f->blocks; b++) *line++ = f->block[b].line;
    for (int32_t i = 0; i < s->given; i++) *line++ = f->contact[i].line;
    for (int32_t i = 0; i < f->loads; i++) *line++ = f->load[i].line;
    for (int k = 0; k < 3; k++) keep_first_line(f->strength[k], f->strength_line[k], &s->strength_line);
    for (int32_t i = 0; i < s->given; i++)
        for (int k = 0; k < 3; k++)
            keep_first_line(f->contact[i].strength[k], f->contact[i].strength_line[k], &s->strength_line);
    return 0;
}

static int keep_names(const obj_file *f, host_scene *s, failure *error)
{
    size_t bytes = 0;
    for (int32_t b = 0; b < f->blocks; b++) bytes += f->block[b].name.n + 1;
    s->names = malloc(bytes);
    s->name = malloc((size_t)f->blocks * sizeof *s->name);
    if (!s->names || !s->name) return out_of_memory(f, error);
    bytes = 0;
    for (int32_t b = 0; b < f->blocks; b++) {
        const text_word w = f->block[b].name;
        s->name[b] = memcpy(s->names + bytes, w.s, w.n);
        s->names[bytes + w.n] = 0;
        bytes += w.n + 1;
    }
    return 0;
}

static int from_file(const obj_file *f, mesh_room *m, const scene_settings *set, host_scene *s, failure *error)
{
    const sp_real mu = set->mu;
    const int given = set->contacts == SCENE_GIVEN && f->contacts > 0;
    sp_capacity cap = { 0, 0, 0, 0, 0, 0, 0 };
    int status = keep_names(f, s, error);

    if (!status) status = keep_lines(f, given, s, error);
    s->mu = mu >= 0 ? mu : f->mu;
    s->density = f->density;
    if (status) return status;
    if (!make_room(f, m) || !count_meshes(f, &cap, m)) return out_of_memory(f, error);
    if (given) {
        cap.joints = f->contacts;
        cap.points = f->points;
    }
    status = build_blocks(f, &cap, m, s, error);
    if (status || !given) return status ? status : find_contacts(f, &cap, m, set->amend.contact, s, error);
    for (int32_t i = 0; !status && i < f->contacts; i++) status = add_contact(f, i, mu, &s->scene, error);
    return status;
}

static void make_remarks(const obj_file *f, const amendments *a, host_scene *s)
{
    const suspects_known known = { a->unit.over ? a->unit : f->unit, a->turn || a->pull || f->down_told,
                                    !s->found };
    if (f->beside) remarks_add(&s->remarks, NULL, "more about this scene was read from %.300s", f->beside);
    if (s->found) {
        const sp_contact_settings used = touching_settings(s->touching);
        touching_large(&s->scene, &s->touching, &s->remarks);
        s->near = touching_near(&s->scene, &used, &s->remarks);
        s->inside = touching_inside(&s->scene, s->overlap, s->overlaps, s->name, &s->remarks);
        s->across = across_find(&s->scene, &s->touching, s->name, &s->remarks);
    }
    suspects_find(&s->scene, s->name, known, &s->remarks);
}

/* The file's tables are let go as soon as the scene is built. */
static int build_from(obj_file *f, int status, const scene_settings *set, host_scene *s, failure *error)
{
    mesh_room m = { NULL, NULL, NULL, NULL, NULL };
    if (!status) status = twins_check_pressures(f, error);
    if (!status) status = amend_file(f, &set->amend, set->contacts == SCENE_GIVEN && f->contacts > 0, &s->remarks, error);
    if (!status) status = bare_drop(f, &s->remarks, error);
    if (!status) {
        s->path = malloc(strlen(f->path) + 1);
        status = s->path ? 0 : out_of_memory(f, error);
    }
    if (!status) {
        strcpy(s->path, f->path);
        status = from_file(f, &m, set, s, error);
        if (!status) make_remarks(f, &set->amend, s);
        s->beside = f->beside;
        f->beside = NULL;
    }
    free_room(&m);
    obj_free(f);
    return status;
}

scene_settings scene_settings_default(void)
{
    const amendments none = { { NULL }, { NULL }, 0, 0, { 0, 0, 0 }, 0, { 0, 0, 0 }, { 0, 0 }, { 0, 0, 0, 0, 0 }, 0 };
    const scene_settings set = { -1, SCENE_GIVEN, none };
    return set;
}

static void tell_unread(const compas_unread *u, remarks *told)
{
    const long n = u->edges;
    if (u->moves) remarks_add(told, NULL, "displacements of the problem were not read, only what they hold at rest");
    if (u->pressures) remarks_add(told, NULL, "surface loads of the problem were not read: 'pressure' lines are such");
    if (u->strength) remarks_add(told, NULL, "cohesion and tension of the problem's contact model were not read");
    if (!n) return;
    remarks_add(told, NULL, "%ld edge%s of the model %s no contact polygon: all contacts were found anew", n, n == 1 ? "" : "s",
                n == 1 ? "has" : "have");
}

static int mend(obj_file *f, const scene_settings *set, host_scene *s, failure *error)
{
    const int status = twins_drop(f, &s->remarks, error);
    return status ? status : solids_mend(f, set->amend.split, &s->remarks, error);
}

int scene_read(const char *path, const scene_settings *set, host_scene *s, failure *error)
{
    const host_scene empty = { 0 };
    obj_file f;
    int status;
    *s = empty;
    status = meshes_is_known(path) ? meshes_read(path, &set->amend, &f, &s->remarks, error) : obj_read(path, &f, error);
    if (!status) tell_unread(&f.unread, &s->remarks);
    if (!status) status = mend(&f, set, s, error);
    if (!status) status = obj_read_beside(&f, error);
    return build_from(&f, status, set, s, error);
}

int scene_parse(const char *path, char *text, size_t length, const scene_settings *set, host_scene *s, failure *error)
{
    const host_scene empty = { 0 };
    obj_file f;
    int status = obj_parse(path, text, length, &f, error);
    *s = empty;
    if (!status) status = mend(&f, set, s, error);
    return build_from(&f, status, set, s, error);
}

/* ------------------------------------------------------------------------------------------------- what the library refuses */

#define LARGEST (sizeof(sp_real) == 8 ? DBL_MAX : (double)FLT_MAX)

/* Is a number of this scene too large? Not where there is no memory to tell. */
static int is_too_large(const sp_scene *scene)
{
    void *memory;
    sp_arena a;
    sp_problem problem;
    const int yes = run_arena(run_bytes(scene, SP_FOR_PROBLEM, NULL), &a, &memory) == SP_OK
                 && sp_problem_build(scene, &a, &problem) == SP_E_NOT_FINITE;
    free(memory);
    return yes;
}

/* The first `*count` of something, of which none is too much and all are: one that makes it so.     returns its number */
static int32_t find_culprit(const sp_scene *part, int32_t *count)
{
    int32_t low = 0, high = *count;
    while (high - low > 1) {
        *count = low + (high - low) / 2;
        if (is_too_large(part)) high = *count; else low = *count;
    }
    return high - 1;
}

/* A block whose weight alone is too large, -1: none. */
static int32_t find_too_heavy(const sp_scene *scene)
{
    for (int32_t b = 0; b < scene->count.blocks; b++)
        for (int k = 0; k < 3 && scene->block[b].fixed != SP_FIXED; k++) {
            const double w = (double)(scene->block[b].mass * scene->gravity[k]);
            if (!(w * w <= LARGEST)) return b;
        }
    return -1;
}

static int blame_too_large(const host_scene *s, failure *error)
{
    const char *const why = "a number is too large to be squared";
    sp_scene part = s->scene;
    const int32_t blocks = part.count.blocks, loads = part.count.loads;
    part.count.loads = part.count.joints = 0;
    if (is_too_large(&part)) {
        const int32_t b = find_too_heavy(&part);
        if (b < 0) return fail_with(error, EXIT_SCENE, s->path, 0, "live loads of a block: %s", why);
        const int32_t line = s->gravity_line ? s->gravity_line : s->line[b];
        return fail_with(error, EXIT_SCENE, OBJ_AT(s, line), "weight of block '%.60s': %s", s->name[b], why);
    }
    part.count.loads = loads;
    if (is_too_large(&part)) {
        const int32_t k = find_culprit(&part, &part.count.loads);
        return fail_with(error, EXIT_SCENE, OBJ_AT(s, s->line[blocks + s->given + k]), "loads on '%.60s': %s",
                         s->name[s->scene.load[k].block], why);
    }
    part.count.joints = s->scene.count.joints;
    const int32_t i = find_culprit(&part, &part.count.joints);
    const sp_joint *f = &s->scene.joint[i];
    return fail_with(error, EXIT_SCENE, OBJ_AT(s, s->line[i < s->given ? blocks + i : f->b]), "contact '%.60s' '%.60s': %s",
                     s->name[f->a], s->name[f->b], why);
}

int scene_refused(const host_scene *s, const sp_settings *settings, sp_status why, failure *error)
{
    if (why == SP_E_NOT_FINITE && is_too_large(&s->scene)) return blame_too_large(s, error);
    if (why == SP_E_UNSUPPORTED && settings->coupled.asked && s->strength_line)
        return fail_with(error, EXIT_SCENE, OBJ_AT(s, s->strength_line), "strength of joints (cohesion, tension, crushing): a "
                         "coupled check knows friction alone");
    return fail_status(error, why, s->path, 0, "");
}

void scene_remarks_json(json_out *j, const host_scene *s)
{
    touching_json(j, s->found ? &s->touching : NULL, s->near);
    remarks_json(j, &s->remarks);
}

void scene_body(host_scene *s, const double body[3])
{
    double g = 0;
    for (int k = 0; k < 3; k++) g += (double)s->scene.gravity[k] * (double)s->scene.gravity[k];
    for (int k = 0; k < 3; k++) s->scene.body[k] = (sp_real)(sqrt(g) * body[k]);
}

void scene_free(host_scene *s)
{
    free(s->line);
    free(s->path);
    free(s->beside);
    free(s->memory);
    free(s->name);
    free(s->names);
    free(s->overlap);
    remarks_free(&s->remarks);
}
