/* scene: the arrays of a scene (blocks, meshes, joints, loads) in an arena, sized by sp_capacity. */
#ifndef SP__SCENE_SCENE_C
#define SP__SCENE_SCENE_C

#include "../base/real.c"

static void sp__scene_carve(sp_scene *scene, sp_arena *a)
{
    const sp_capacity *c = &scene->capacity;
    scene->block = sp__take(a, (size_t)c->blocks, sizeof *scene->block);
    scene->vertex = sp__take(a, (size_t)c->vertices, sizeof *scene->vertex);
    scene->face = sp__take(a, (size_t)c->faces, sizeof *scene->face);
    scene->corner = sp__take(a, (size_t)c->corners, sizeof *scene->corner);
    scene->joint = sp__take(a, (size_t)c->joints, sizeof *scene->joint);
    scene->point = sp__take(a, (size_t)c->points, sizeof *scene->point);
    scene->load = sp__take(a, (size_t)c->loads, sizeof *scene->load);
}

static int sp__capacity_valid(const sp_capacity *c)
{
    return c && c->blocks >= 0 && c->vertices >= 0 && c->faces >= 0 && c->corners >= 0 && c->joints >= 0 && c->points >= 0
        && c->loads >= 0;
}

SP_API size_t sp_scene_memory(const sp_capacity *capacity)
{
    if (!sp__capacity_valid(capacity)) return 0;
    sp_scene scene;
    sp_arena dry = sp__arena_dry();
    scene.capacity = *capacity;
    sp__scene_carve(&scene, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

SP_API sp_status sp_scene_create(sp_scene *scene, const sp_capacity *capacity, sp_arena *arena)
{
    if (!scene || !sp__capacity_valid(capacity) || !arena || !arena->base) return SP_E_ARGUMENT;
    sp_arena a = *arena;
    sp_scene s;
    memset(&s, 0, sizeof s);
    s.gravity[2] = (sp_real)-9.80665;
    s.live = (sp_real)1;
    s.capacity = *capacity;
    sp__scene_carve(&s, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    *arena = a;
    *scene = s;
    return SP_OK;
}

#endif /* SP__SCENE_SCENE_C */
