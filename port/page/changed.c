#include "changed.h"
#include "../host/run.h"
#include "../host/tilt.h"

#include <stdlib.h>
#include <string.h>

static int out_of_memory(const changed *c, failure *error)
{
    return fail_with(error, EXIT_MEMORY, c->read->path, 0, "out of memory");
}

static int is_moved(const changed *c, int32_t b)
{
    const sp_real *d = c->move[b];
    return d[0] < 0 || d[0] > 0 || d[1] < 0 || d[1] > 0 || d[2] < 0 || d[2] > 0;
}

static int any_moved(const changed *c)
{
    for (int32_t b = 0; b < c->read->scene.count.blocks; b++) if (!c->out[b] && is_moved(c, b)) return 1;
    return 0;
}

int changed_open(changed *c, const host_scene *read, failure *error)
{
    const changed empty = { 0 };
    const size_t n = (size_t)read->scene.count.blocks;
    *c = empty;
    c->read = read;
    c->mu = -1;
    c->push.block = -1;
    c->move = calloc(n, sizeof *c->move);
    c->out = calloc(n, sizeof *c->out);
    c->fixed = calloc(n, sizeof *c->fixed);
    c->number = calloc(n, sizeof *c->number);
    if (!c->move || !c->out || !c->fixed || !c->number) return out_of_memory(c, error);
    for (size_t b = 0; b < n; b++) c->fixed[b] = read->scene.block[b].fixed;
    return changed_build(c, error);
}

/* ---------------------------------------------------------------------------------------------------------------- blocks */

/* What the stones that are left need; their numbers. */
static sp_capacity count_blocks(changed *c)
{
    const sp_scene *s = &c->read->scene;
    sp_capacity room = { 0, 0, 0, 0, 0, 0, s->count.loads + 1 };
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_block *block = &s->block[b];
        c->number[b] = c->out[b] ? -1 : room.blocks++;
        if (c->out[b]) continue;
        room.vertices += block->vertices;
        room.faces += block->faces;
        for (int32_t i = 0; i < block->faces; i++) room.corners += s->face[block->face + i].corners;
    }
    return room;
}

/* The mesh of block b where it is now, in xyz, size, corner. */
static sp_mesh place_mesh(const changed *c, int32_t b, sp_real *xyz, int32_t *size, int32_t *corner)
{
    const sp_scene *s = &c->read->scene;
    const sp_block *block = &s->block[b];
    const sp_mesh mesh = { block->vertices, block->faces, xyz, size, corner };
    for (int32_t v = 0; v < block->vertices; v++)
        for (int k = 0; k < 3; k++) xyz[3 * v + k] = s->vertex[block->vertex + v][k] + c->move[b][k];
    for (int32_t i = 0; i < block->faces; i++) {
        const sp_face *face = &s->face[block->face + i];
        size[i] = face->corners;
        for (int32_t k = 0; k < face->corners; k++) *corner++ = s->corner[face->corner + k] - block->vertex;
    }
    return mesh;
}

static sp_status add_block(const changed *c, int32_t b, sp_scene *to, sp_real *xyz, int32_t *size, int32_t *corner)
{
    const sp_block *block = &c->read->scene.block[b];
    sp_real at[3];
    for (int k = 0; k < 3; k++) at[k] = block->centroid[k] + c->move[b][k];
    if (block->faces == 0) return sp_scene_body(to, block->mass, at, c->fixed[b], NULL);
    const sp_mesh mesh = place_mesh(c, b, xyz, size, corner);
    return sp_scene_block(to, &mesh, block->density, c->fixed[b], NULL);
}

/* All stones that are left, without contacts, in new memory. */
static int add_blocks(const changed *c, const sp_capacity *room, sp_scene *to, void **memory, failure *error)
{
    const sp_capacity *n = &c->read->scene.count;
    sp_real *xyz = malloc(3 * (size_t)n->vertices * sizeof *xyz + 1);
    int32_t *size = malloc((size_t)n->faces * sizeof *size + 1), *corner = malloc((size_t)n->corners * sizeof *corner + 1);
    sp_arena arena;
    sp_status status = xyz && size && corner ? run_arena(sp_scene_memory(room), &arena, memory) : SP_E_MEMORY;
    if (status == SP_OK) status = sp_scene_create(to, room, &arena);
    for (int32_t b = 0; b < n->blocks && status == SP_OK; b++)
        if (!c->out[b]) {
            status = add_block(c, b, to, xyz, size, corner);
            if (status != SP_OK) fail_status(error, status, c->read->path, 0, c->read->name[b]);
        }
    free(xyz);
    free(size);
    free(corner);
    return status == SP_OK ? 0 : error->status ? error->status : out_of_memory(c, error);
}

/* -------------------------------------------------------------------------------------------------------------- contacts */

static sp_status find_once(const changed *c, sp_scene *s, sp_contact_report *report)
{
    sp_contact_settings set = touching_settings(c->read->touching);
    void *memory;
    sp_arena scratch;
    set.strength = c->read->found ? c->read->strength : sp_strength_friction(c->read->mu);
    sp_status status = run_arena(run_bytes(s, SP_FOR_CONTACTS, NULL), &scratch, &memory);
    if (status == SP_OK) status = sp_contacts_find(s, &set, scratch, report);
    free(memory);
    return status;
}

/* The stones with all contacts found, as scene.c does it: once to count, once into just that room. */
static int find_contacts(changed *c, sp_capacity *room, sp_scene *s, void **memory, failure *error)
{
    sp_contact_report report = { 0, 0, 0, 0, NULL };
    int failed = add_blocks(c, room, s, memory, error);
    sp_status status = failed ? SP_OK : find_once(c, s, &report);
    if (failed) return failed;
    if (status == SP_E_CAPACITY || report.overlaps > 0) {
        room->joints = report.joints;
        room->points = report.points;
        c->now.overlap = malloc((size_t)report.overlaps * sizeof *c->now.overlap + 1);
        if (!c->now.overlap) return out_of_memory(c, error);
        report.overlap = c->now.overlap;
        report.overlap_capacity = c->now.overlaps = report.overlaps;
        free(*memory);
        *memory = NULL;
        failed = add_blocks(c, room, s, memory, error);
        if (!failed) status = find_once(c, s, &report);
    }
    if (failed) return failed;
    return status == SP_OK ? 0 : fail_status(error, status, c->read->path, 0, "contacts");
}

/* Does joint j of `from`, whose blocks have these numbers as read (NULL: the same), join a stone that was moved? */
static int joins_moved(const changed *c, const sp_joint *j, const int32_t *as_read)
{
    const int32_t a = as_read ? as_read[j->a] : j->a, b = as_read ? as_read[j->b] : j->b;
    return is_moved(c, a) || is_moved(c, b);
}

static sp_status copy_joint(sp_scene *to, const sp_scene *from, const sp_joint *j, int32_t a, int32_t b)
{
    const sp_real *xyz = from->point[j->point];
    return j->area > 0 ? sp_scene_joint(to, a, b, j->points, xyz, &j->strength, NULL)
                       : sp_scene_points(to, a, b, j->n, j->points, xyz, &j->strength, NULL);
}

/* Contacts as given between stones that stayed. */
static int is_kept(const changed *c, const sp_joint *j)
{
    return !c->out[j->a] && !c->out[j->b] && !joins_moved(c, j, NULL);
}

/* Given contacts, and those found of moved stones. */
static sp_status copy_joints(const changed *c, sp_scene *to, const sp_scene *found, const int32_t *as_read)
{
    const sp_scene *given = &c->read->scene;
    sp_status status = SP_OK;
    for (int32_t i = 0; i < given->count.joints && status == SP_OK; i++) {
        const sp_joint *j = &given->joint[i];
        if (is_kept(c, j)) status = copy_joint(to, given, j, c->number[j->a], c->number[j->b]);
    }
    for (int32_t i = 0; found && i < found->count.joints && status == SP_OK; i++) {
        const sp_joint *j = &found->joint[i];
        if (joins_moved(c, j, as_read)) status = copy_joint(to, found, j, j->a, j->b);
    }
    return status;
}

/* The scene of given contacts. found: the same stones with all contacts found, NULL: none was moved. */
static int join_given(changed *c, sp_capacity *room, const sp_scene *found, failure *error)
{
    int32_t *as_read = malloc((size_t)room->blocks * sizeof *as_read + 1);
    sp_status status;
    int failed = as_read ? 0 : out_of_memory(c, error);
    for (int32_t b = 0; !failed && b < c->read->scene.count.blocks; b++) if (!c->out[b]) as_read[c->number[b]] = b;
    room->joints = c->read->scene.count.joints + (found ? found->count.joints : 0);
    room->points = c->read->scene.count.points + (found ? found->count.points : 0);
    if (!failed) failed = add_blocks(c, room, &c->now.scene, &c->now.memory, error);
    status = failed ? SP_OK : copy_joints(c, &c->now.scene, found, as_read);
    free(as_read);
    if (failed || status == SP_OK) return failed;
    return fail_status(error, status, c->read->path, 0, "contacts");
}

static int build_given(changed *c, sp_capacity *room, failure *error)
{
    sp_scene found;
    void *memory = NULL;
    sp_capacity with = *room;
    int failed = any_moved(c) ? find_contacts(c, &with, &found, &memory, error) : 0;
    if (!failed) failed = join_given(c, room, any_moved(c) ? &found : NULL, error);
    free(memory);
    return failed;
}

/* ----------------------------------------------------------------------------------------------------------------- loads */

/* The loads of the stones that are left; they move with these. */
static int copy_loads(changed *c, failure *error)
{
    const sp_scene *s = &c->read->scene;
    for (int32_t i = 0; i < s->count.loads; i++) {
        sp_load load = s->load[i];
        const int32_t b = load.block;
        if (c->out[b]) continue;
        load.block = c->number[b];
        for (int k = 0; k < 3; k++) load.point[k] += c->move[b][k];
        const sp_status status = sp_scene_load(&c->now.scene, &load, NULL);
        if (status != SP_OK) return fail_status(error, status, c->read->path, 0, "load");
    }
    c->loads = c->now.scene.count.loads;
    return 0;
}

static int keep_friction(changed *c, failure *error)
{
    const sp_scene *s = &c->now.scene;
    c->own_mu = malloc((size_t)s->count.joints * sizeof *c->own_mu + 1);
    if (!c->own_mu) return out_of_memory(c, error);
    for (int32_t i = 0; i < s->count.joints; i++) c->own_mu[i] = s->joint[i].strength.mu;
    return 0;
}

void changed_apply(changed *c)
{
    sp_scene *s = &c->now.scene;
    for (int32_t i = 0; i < s->count.joints; i++) s->joint[i].strength.mu = c->mu >= 0 ? (sp_real)c->mu : c->own_mu[i];
    memcpy(s->gravity, c->read->scene.gravity, sizeof s->gravity);
    tilt_turn(c->tilt, c->azimuth, s->gravity);
    s->count.loads = c->loads;
    if (c->push.block < 0 || c->number[c->push.block] < 0) return;
    sp_load load = { 0 };
    load.block = c->number[c->push.block];
    load.live = 1;
    memcpy(load.force, c->push.force, sizeof load.force);
    memcpy(load.point, c->push.point, sizeof load.point);
    (void)sp_scene_load(s, &load, NULL);                /* what is no number is no push */
}

/* ----------------------------------------------------------------------------------------------------------------- whole */

static void let_go(changed *c)
{
    const host_scene empty = { 0 };
    free(c->now.memory);
    free((void *)c->now.name);
    free(c->now.overlap);
    free(c->own_mu);
    c->now = empty;
    c->own_mu = NULL;
}

/* What `now` has of the scene as read. */
static int borrow(changed *c, const sp_capacity *room, failure *error)
{
    const host_scene *r = c->read;
    c->now.path = r->path;
    c->now.mu = r->mu;
    c->now.found = r->found;
    c->now.touching = r->touching;
    c->now.strength = r->strength;
    c->now.near = any_moved(c) || room->blocks < r->scene.count.blocks ? 0 : r->near;
    c->now.inside = any_moved(c) || room->blocks < r->scene.count.blocks ? 0 : r->inside;
    c->now.across = any_moved(c) || room->blocks < r->scene.count.blocks ? 0 : r->across;
    c->now.remarks = r->remarks;
    c->now.name = malloc((size_t)room->blocks * sizeof *c->now.name + 1);
    if (!c->now.name) return out_of_memory(c, error);
    for (int32_t b = 0; b < r->scene.count.blocks; b++) if (!c->out[b]) c->now.name[c->number[b]] = r->name[b];
    return 0;
}

int changed_build(changed *c, failure *error)
{
    let_go(c);
    sp_capacity room = count_blocks(c);
    int failed = borrow(c, &room, error);
    if (!failed && c->read->found) failed = find_contacts(c, &room, &c->now.scene, &c->now.memory, error);
    else if (!failed) failed = build_given(c, &room, error);
    c->now.bytes = sp_scene_memory(&room);
    if (!failed) failed = copy_loads(c, error);
    if (!failed) failed = keep_friction(c, error);
    if (failed) let_go(c);
    else changed_apply(c);
    return failed;
}

void changed_free(changed *c)
{
    const changed empty = { 0 };
    let_go(c);
    free(c->move);
    free(c->out);
    free(c->fixed);
    free(c->number);
    *c = empty;
}
