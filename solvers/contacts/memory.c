/* memory: the arrays of the search for contacts in an arena, and their sizes: at most (patches <= faces, edges <= corners)
 * before the patches are known, exact after. */
#ifndef SP__CONTACTS_MEMORY_C
#define SP__CONTACTS_MEMORY_C

#include "touch.c"

#if !SP__WITH_SMALL

/* Crossings of boundaries of p and q edges that there is room for: all up to 16-gons; otherwise 8 (p + q), four times what a
 * convex one can have with any other. Combs across combs may need more: SP_E_MEMORY. */
static int64_t sp__crossings(const sp__top_two *t)
{
    const int64_t all = (int64_t)t->first * t->second, most = 8 * ((int64_t)t->first + t->second);
    return all < most ? all : most;
}

/* x into the largest two. */
static void sp__top_two_add(sp__top_two *t, int32_t x)
{
    if (x > t->first) { t->second = t->first; t->first = x; }
    else if (x > t->second) t->second = x;
}

/* Corners of the faces of a block. */
static int32_t sp__block_corners(const sp_scene *scene, int32_t block)
{
    const sp_face *f = scene->face + scene->block[block].face;
    const int32_t n = scene->block[block].faces;
    return n ? f[n - 1].corner + f[n - 1].corners - f[0].corner : 0;
}

static void sp__contact_arrays_carve(sp__contact_arrays *l, const sp_scene *scene, sp_arena *a)
{
    const sp_capacity *n = &scene->count;
    int32_t vertices = 0, faces = 0, corners = 0;
    for (int32_t i = 0; i < n->blocks; i++) {
        const sp_block *k = &scene->block[i];
        const int32_t c = sp__block_corners(scene, i);
        vertices = k->vertices > vertices ? k->vertices : vertices;
        faces = k->faces > faces ? k->faces : faces;
        corners = c > corners ? c : corners;
    }
    const size_t blocks = (size_t)n->blocks, face = (size_t)faces;
    l->body = sp__take(a, blocks, sizeof *l->body);
    l->patch = sp__take(a, (size_t)n->faces, sizeof *l->patch);
    l->bound = sp__take(a, (size_t)n->corners, sizeof *l->bound);
    l->same = sp__take(a, (size_t)n->vertices, sizeof *l->same);
    l->order = sp__take(a, (size_t)(vertices > corners ? vertices : corners), sizeof *l->order);
    l->mine = sp__take(a, face, sizeof *l->mine);
    l->edge = sp__take(a, (size_t)corners, sizeof *l->edge);
    l->normal = sp__take(a, face, sizeof *l->normal);
    l->middle = sp__take(a, face, sizeof *l->middle);
    l->area = sp__take(a, face, sizeof *l->area);
    l->hit = sp__take(a, blocks, sizeof *l->hit);
    for (l->tree.width = 1; l->tree.width < n->blocks && l->tree.width < 1 << 29; l->tree.width *= 2) { }
    l->tree.box = sp__take(a, 2 * (size_t)l->tree.width, sizeof *l->tree.box);
    l->tree.leaf = sp__take(a, blocks, sizeof *l->tree.leaf);
    l->tree.code = sp__take(a, blocks, sizeof *l->tree.code);
}

static void sp__pair_buffer_carve(sp__pair_buffer *p, const sp__top_sizes *most, sp_arena *a)
{
    const int64_t room = 2 * ((int64_t)most->total.first + most->total.second + sp__crossings(&most->side)) + 64;
    p->room = room < INT32_MAX ? (int32_t)room : 0;
    p->near_a = sp__take(a, (size_t)most->patches.first, sizeof *p->near_a);
    p->near_b = sp__take(a, (size_t)most->patches.first, sizeof *p->near_b);
    p->point = sp__take(a, (size_t)room, sizeof *p->point);
    p->found = sp__take(a, (size_t)room, sizeof *p->found);
    p->rank = sp__take(a, (size_t)room, sizeof *p->rank);
}

/* The most there can be before the patches are known: a block has no more patches than faces, and no more edges than corners.
 * A patch of a closed block has at most half of its edges, because their opposites bound other patches. */
static void sp__top_sizes_guess(sp__top_sizes *most, const sp_scene *scene)
{
    memset(most, 0, sizeof *most);
    for (int32_t i = 0; i < scene->count.blocks; i++) {
        const int32_t corners = sp__block_corners(scene, i);
        sp__top_two_add(&most->side, scene->block[i].volume > 0 ? corners / 2 : corners);
        sp__top_two_add(&most->total, corners);
        sp__top_two_add(&most->patches, scene->block[i].faces);
    }
}

/* The arrays themselves are of no interest here, each kind in a frame of its own. */
SP__NOINLINE static void sp__contact_arrays_need(const sp_scene *scene, sp_arena *dry)
{
    sp__contact_arrays none;
    (void)sp__take(dry, 1, sizeof(sp__touch));
    sp__contact_arrays_carve(&none, scene, dry);
}

SP__NOINLINE static void sp__pairs_need(const sp__top_sizes *most, sp_arena *dry)
{
    union { sp__clip clip; sp__pair_buffer pair; } none;
    sp__clip_carve(&none.clip, most->side.first, most->side.second, sp__crossings(&most->side), dry);
    sp__pair_buffer_carve(&none.pair, most, dry);
}

SP__NOINLINE static size_t sp__contacts_memory(const sp_scene *scene)
{
    sp_arena dry = sp__arena_dry();
    sp__top_sizes most;
    sp__top_sizes_guess(&most, scene);
    sp__contact_arrays_need(scene, &dry);
    sp__pairs_need(&most, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

#endif

#endif /* SP__CONTACTS_MEMORY_C */
