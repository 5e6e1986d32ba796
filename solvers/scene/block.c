/* block: a mesh with its mass and centroid becomes a block of the scene, stone or support. */
#ifndef SP__SCENE_BLOCK_C
#define SP__SCENE_BLOCK_C

#include "mesh.c"

/* Copy a mesh into the scene; room was checked. */
static void sp__scene_copy(sp_scene *scene, const sp_mesh *mesh, int32_t corners)
{
    sp_capacity *n = &scene->count;
    if (mesh->vertices) memcpy(scene->vertex + n->vertices, mesh->xyz, (size_t)mesh->vertices * sizeof *scene->vertex);
    for (int32_t k = 0; k < corners; k++) scene->corner[n->corners + k] = n->vertices + mesh->corner[k];
    for (int32_t k = 0; k < mesh->faces; k++) {
        scene->face[n->faces + k].corner = n->corners;
        scene->face[n->faces + k].corners = mesh->size[k];
        n->corners += mesh->size[k];
    }
    n->vertices += mesh->vertices;
    n->faces += mesh->faces;
}

/* Is there room for one more block with this mesh? */
static int sp__scene_room(const sp_scene *scene, const sp_mesh *mesh, int32_t corners)
{
    const sp_capacity *most = &scene->capacity, *n = &scene->count;
    return n->blocks < most->blocks && mesh->vertices <= most->vertices - n->vertices
        && mesh->faces <= most->faces - n->faces && corners <= most->corners - n->corners;
}

/* The next block, without mesh; room was checked. */
static sp_block *sp__block_add(sp_scene *scene, sp_real mass, const sp_real centroid[3], uint32_t fixed, int32_t *id)
{
    sp_block *k = &scene->block[scene->count.blocks];
    memset(k, 0, sizeof *k);
    k->mass = mass;
    memcpy(k->centroid, centroid, sizeof k->centroid);
    k->fixed = fixed;
    k->vertex = scene->count.vertices;
    k->face = scene->count.faces;
    if (id) *id = scene->count.blocks;
    scene->count.blocks++;
    return k;
}

SP_API sp_status sp_scene_block(sp_scene *scene, const sp_mesh *mesh, sp_real density, uint32_t fixed, int32_t *id)
{
    int32_t corners;
    sp_mass m;
    if (!scene) return SP_E_ARGUMENT;
    sp_status status = sp__mesh_check(mesh, &corners);
    if (status) return status;
    if (!sp__finite(density)) return SP_E_NOT_FINITE;
    if (!(density > 0) || fixed > SP_FIXED) return SP_E_RANGE;
    status = fixed == SP_FIXED ? sp__mesh_support(mesh, corners, &m) : sp__mesh_measure(mesh, corners, &m);
    if (status) return status;
    const sp_real mass = density * m.volume;
    if (!sp__finite(mass)) return SP_E_NOT_FINITE;
    if (!(mass > 0) && fixed != SP_FIXED) return SP_E_DEGENERATE;       /* underflow */
    if (!sp__scene_room(scene, mesh, corners)) return SP_E_CAPACITY;
    sp_block *k = sp__block_add(scene, mass, m.centroid, fixed, id);
    k->density = density;
    k->volume = m.volume;
    k->diameter = m.diameter;
    k->vertices = mesh->vertices;
    k->faces = mesh->faces;
    sp__scene_copy(scene, mesh, corners);
    return SP_OK;
}

SP_API sp_status sp_scene_body(sp_scene *scene, sp_real mass, const sp_real centroid[3], uint32_t fixed, int32_t *id)
{
    if (!scene || !centroid) return SP_E_ARGUMENT;
    if (!sp__finite(mass) || !sp__finite3(centroid)) return SP_E_NOT_FINITE;
    if (mass < 0 || (!(mass > 0) && fixed != SP_FIXED) || fixed > SP_FIXED) return SP_E_RANGE;
    if (scene->count.blocks >= scene->capacity.blocks) return SP_E_CAPACITY;
    (void)sp__block_add(scene, mass, centroid, fixed, id);
    return SP_OK;
}

#endif /* SP__SCENE_BLOCK_C */
