/* shrink: parts of a scene; see shrink.h. */
#include "shrink.h"

#include <string.h>

static int sp_shrink_kept(const uint8_t *mark, int32_t k) { return !mark || mark[k] & 1; }

/* Marks of what a part holds, and where each of its blocks is found in it. */
typedef struct sp_shrink_marks { const uint8_t *block, *joint, *load; } sp_shrink_marks;

static int sp_shrink_joint(const sp_scene *s, const sp_shrink_marks *m, int32_t k)
{
    return sp_shrink_kept(m->joint, k) && sp_shrink_kept(m->block, s->joint[k].a) && sp_shrink_kept(m->block, s->joint[k].b);
}

static int sp_shrink_load(const sp_scene *s, const sp_shrink_marks *m, int32_t k)
{
    return sp_shrink_kept(m->load, k) && sp_shrink_kept(m->block, s->load[k].block);
}

static int32_t sp_shrink_number(const sp_shrink_marks *m, int32_t b)
{
    int32_t number = 0;
    for (int32_t k = 0; k < b; k++) number += sp_shrink_kept(m->block, k);
    return number;
}

static sp_capacity sp_shrink_room(const sp_scene *s, const sp_shrink_marks *m)
{
    sp_capacity room = { 0, 0, 0, 0, 0, 0, 0 };
    for (int32_t b = 0; b < s->count.blocks; b++) {
        if (!sp_shrink_kept(m->block, b)) continue;
        room.blocks++;
        room.vertices += s->block[b].vertices;
        room.faces += s->block[b].faces;
        for (int32_t f = 0; f < s->block[b].faces; f++) room.corners += s->face[s->block[b].face + f].corners;
    }
    for (int32_t k = 0; k < s->count.joints; k++)
        if (sp_shrink_joint(s, m, k)) { room.joints++; room.points += s->joint[k].points; }
    for (int32_t k = 0; k < s->count.loads; k++) room.loads += sp_shrink_load(s, m, k);
    return room;
}

static void sp_shrink_block(const sp_scene *s, int32_t b, sp_scene *out)
{
    sp_block *o = &out->block[out->count.blocks++];
    *o = s->block[b];
    const int32_t moved = out->count.vertices - o->vertex;
    memcpy(out->vertex + out->count.vertices, s->vertex + o->vertex, (size_t)o->vertices * sizeof *s->vertex);
    for (int32_t f = 0; f < o->faces; f++) {
        const sp_face *from = &s->face[o->face + f];
        sp_face *to = &out->face[out->count.faces + f];
        to->corner = out->count.corners;
        to->corners = from->corners;
        for (int32_t c = 0; c < from->corners; c++) out->corner[out->count.corners++] = s->corner[from->corner + c] + moved;
    }
    o->vertex = out->count.vertices;
    o->face = out->count.faces;
    out->count.vertices += o->vertices;
    out->count.faces += o->faces;
}

sp_status sp_scene_part(const sp_scene *scene, const uint8_t *block, const uint8_t *joint, const uint8_t *load, sp_arena *arena,
                        sp_scene *part)
{
    const sp_shrink_marks m = { block, joint, load };
    const sp_capacity room = sp_shrink_room(scene, &m);
    const sp_status status = sp_scene_create(part, &room, arena);
    if (status) return status;
    memcpy(part->gravity, scene->gravity, sizeof part->gravity);
    memcpy(part->body, scene->body, sizeof part->body);
    part->live = scene->live;
    for (int32_t b = 0; b < scene->count.blocks; b++) if (sp_shrink_kept(block, b)) sp_shrink_block(scene, b, part);
    for (int32_t k = 0; k < scene->count.joints; k++) {
        if (!sp_shrink_joint(scene, &m, k)) continue;
        sp_joint *j = &part->joint[part->count.joints++];
        *j = scene->joint[k];
        memcpy(part->point + part->count.points, scene->point + j->point, (size_t)j->points * sizeof *scene->point);
        j->point = part->count.points;
        part->count.points += j->points;
        j->a = sp_shrink_number(&m, j->a);
        j->b = sp_shrink_number(&m, j->b);
    }
    for (int32_t k = 0; k < scene->count.loads; k++) {
        if (!sp_shrink_load(scene, &m, k)) continue;
        sp_load *l = &part->load[part->count.loads++];
        *l = scene->load[k];
        l->block = sp_shrink_number(&m, l->block);
    }
    return SP_OK;
}

/* A search: the scene, its marks, and the arena as it was. */
typedef struct sp_shrink {
    const sp_scene *scene;
    sp_scene_shows shows;
    void *user;
    sp_arena *arena, before;
    uint8_t *block, *joint, *load;
    sp_scene *small;
    sp_status status;
} sp_shrink;

static int sp_shrink_shows(sp_shrink *s)
{
    *s->arena = s->before;
    s->status = sp_scene_part(s->scene, s->block, s->joint, s->load, s->arena, s->small);
    return !s->status && s->shows(s->user, s->small);
}

/* Without what is left of mark[from .. from + size): 1 if it still shows, else they are put back. */
static int sp_shrink_without(sp_shrink *s, uint8_t *mark, int32_t count, int32_t from, int32_t size)
{
    const int32_t to = from + size < count ? from + size : count;
    int some = 0;
    for (int32_t k = from; k < to; k++) if (mark[k]) { mark[k] = 2; some = 1; }
    const int shows = some && sp_shrink_shows(s);
    for (int32_t k = from; k < to; k++) if (mark[k]) mark[k] = shows ? 0 : 1;
    return shows;
}

/* Pieces of half, a quarter ... of the marks, the last first; of one until none goes.     returns whether something went */
static int sp_shrink_marks_of(sp_shrink *s, uint8_t *mark, int32_t count)
{
    int some = 0;
    for (int32_t size = count / 2 > 1 ? count / 2 : 1; !s->status; size = size > 1 ? size / 2 : 1) {
        int went = 0;
        for (int32_t from = (count - 1) / size * size; count && from >= 0; from -= size)
            went |= sp_shrink_without(s, mark, count, from, size);
        some |= went;
        if (size == 1 && !went) break;
    }
    return some;
}

sp_status sp_scene_shrink(const sp_scene *scene, sp_scene_shows shows, void *user, sp_arena *arena, sp_arena scratch,
                          sp_scene *small)
{
    const sp_capacity n = scene->count;
    const size_t need = (size_t)n.blocks + (size_t)n.joints + (size_t)n.loads;
    if (scratch.capacity - scratch.used < need) return SP_E_MEMORY;
    uint8_t *marks = (uint8_t *)scratch.base + scratch.used;
    sp_shrink s = { scene, shows, user, arena, *arena, marks, marks + n.blocks, marks + n.blocks + n.joints, small, SP_OK };
    memset(marks, 1, need);
    if (!sp_shrink_shows(&s)) {
        *arena = s.before;
        return s.status ? s.status : SP_E_ARGUMENT;
    }
    while (sp_shrink_marks_of(&s, s.block, n.blocks) | sp_shrink_marks_of(&s, s.load, n.loads) |
           sp_shrink_marks_of(&s, s.joint, n.joints)) if (s.status) break;
    return sp_shrink_shows(&s) ? SP_OK : s.status ? s.status : SP_E_ARGUMENT;
}
