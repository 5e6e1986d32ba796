/* Scenes and stones: from blocks to stones, from contacts to joints. */
#include "settle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The mesh of a block with its own vertex numbers, in one allocation. */
static settle_mesh *mesh_of(const sp_scene *s, const sp_block *b, double scale)
{
    int32_t corners = 0, n = 0, *size, *corner;
    double *xyz;
    settle_mesh *m;
    for (int32_t f = b->face; f < b->face + b->faces; f++) corners += s->face[f].corners;
    m = malloc(sizeof *m + 3 * (size_t)b->vertices * sizeof *xyz + ((size_t)b->faces + (size_t)corners) * sizeof *size);
    if (!m) return NULL;
    xyz = (double *)(void *)(m + 1);
    size = (int32_t *)(void *)(xyz + 3 * (size_t)b->vertices);
    corner = size + b->faces;
    m->vertices = b->vertices;
    m->faces = b->faces;
    m->xyz = xyz;
    m->size = size;
    m->corner = corner;
    for (int32_t v = 0; v < b->vertices; v++)
        for (int c = 0; c < 3; c++) xyz[3 * v + c] = scale * (double)s->vertex[b->vertex + v][c];
    for (int32_t f = 0; f < b->faces; f++) {
        const sp_face *face = &s->face[b->face + f];
        size[f] = face->corners;
        for (int32_t k = 0; k < face->corners; k++) corner[n++] = s->corner[face->corner + k] - b->vertex;
    }
    return m;
}

/* Is the mesh closed, its faces outward? A support's need not be. */
static int closed(const sp_scene *s, const sp_block *b)
{
    sp_mesh m;
    sp_mass mass;
    int32_t corners = 0, n = 0;
    int good = 0;
    for (int32_t f = b->face; f < b->face + b->faces; f++) corners += s->face[f].corners;
    int32_t *size = malloc(((size_t)b->faces + (size_t)corners + 1) * sizeof *size);
    if (!size) return 0;
    for (int32_t f = 0; f < b->faces; f++) size[f] = s->face[b->face + f].corners;
    for (int32_t f = 0; f < b->faces; f++)
        for (int32_t k = 0; k < size[f]; k++) size[b->faces + n++] = s->corner[s->face[b->face + f].corner + k] - b->vertex;
    m.vertices = b->vertices;
    m.faces = b->faces;
    m.xyz = s->vertex[b->vertex];
    m.size = size;
    m.corner = size + b->faces;
    good = sp_mesh_mass(&m, &mass) == SP_OK;
    free(size);
    return good;
}

settle_status settle_from_scene(const sp_scene *scene, int32_t unit, settle_assembly *assembly)
{
    const settle_assembly none = { 0, NULL, 1, -1 };
    double edge = 0, mass = 0, weight = 1;
    int32_t n = 0;

    if (!scene || !assembly) return SETTLE_E_ARGUMENT;
    *assembly = none;
    for (int c = 0; c < 3; c++)
        if (scene->count.loads || scene->body[c] < 0 || scene->body[c] > 0) return SETTLE_E_LOAD;
    for (int32_t i = 0; i < scene->count.joints; i++) {
        const sp_strength *j = &scene->joint[i].strength;
        if (j->cohesion > 0 || j->tension > 0 || j->crushing > 0) return SETTLE_E_LOAD;
    }
    for (int32_t b = 0; b < scene->count.blocks; b++) {
        if (scene->block[b].fixed) continue;
        edge += cbrt((double)scene->block[b].volume);
        mass += (double)scene->block[b].mass;
        n++;
    }
    if (unit && edge > 0) assembly->scale = n / edge;
    if (unit && mass > 0) weight = n / mass;
    assembly->stone = calloc((size_t)scene->count.blocks + 1, sizeof *assembly->stone);
    if (!assembly->stone) return SETTLE_E_MEMORY;
    for (int32_t b = 0; b < scene->count.blocks; b++) {
        const sp_block *block = &scene->block[b];
        settle_stone *s = &assembly->stone[b];
        settle_mesh *mesh, *piece = NULL;
        settle_status status;
        assembly->block = b;
        if (block->faces == 0) return SETTLE_E_BODY;
        if (block->fixed && block->fixed != SP_FIXED) return SETTLE_E_LOAD;
        mesh = mesh_of(scene, block, assembly->scale);
        if (!mesh) return SETTLE_E_MEMORY;
        status = closed(scene, block) ? settle_split(mesh, 1e-3, &piece, &s->pieces)
               : block->fixed ? settle_plates(mesh, 0.05 * assembly->scale * (double)block->diameter, &piece, &s->pieces) : SETTLE_E_BODY;
        free(mesh);
        if (status) return status;
        s->piece = piece;
        s->mass = block->fixed ? 1 : weight * (double)block->mass;
        s->fixed = block->fixed != 0;
        assembly->stones++;
    }
    assembly->block = -1;
    return SETTLE_OK;
}

void settle_assembly_free(settle_assembly *assembly)
{
    for (int32_t k = 0; assembly->stone && k < assembly->stones; k++) settle_free((void *)(uintptr_t)assembly->stone[k].piece);
    free(assembly->stone);
    assembly->stone = NULL;
}

static int counts(const settle_contact *c, const sp_scene *s)
{
    return !(s->block[c->b].fixed && (c->a < 0 || s->block[c->a].fixed));
}

void settle_count_joints(const settle_result *result, const sp_scene *scene, sp_capacity *capacity)
{
    capacity->joints = capacity->points = 0;
    for (int32_t k = 0; k < result->contacts; k++) {
        if (!counts(&result->contact[k], scene)) continue;
        capacity->joints++;
        capacity->points += result->contact[k].points;
    }
}

sp_status settle_add_joints(const settle_result *result, int32_t container, const sp_strength *strength, sp_scene *scene)
{
    for (int32_t k = 0; k < result->contacts; k++) {
        const settle_contact *c = &result->contact[k];
        sp_real n[3], xyz[3 * SETTLE_POINTS];
        sp_status status;
        if (!counts(c, scene)) continue;
        for (int d = 0; d < 3; d++) n[d] = (sp_real)c->n[d];
        for (int32_t p = 0; p < c->points; p++)
            for (int d = 0; d < 3; d++) xyz[3 * p + d] = (sp_real)c->point[p][d];
        status = sp_scene_points(scene, c->a < 0 ? container : c->a, c->b, n, c->points, xyz, strength, NULL);
        if (status != SP_OK) return status;
    }
    return SP_OK;
}
