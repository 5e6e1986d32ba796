/* families: stacks, walls, rubble and arches by a seed; see families.h. */
#include "families.h"

#include <string.h>

enum { SP_FAMILY_BLOCKS = 32 };                         /* a wall of 6 x 5 bricks, and its ground */

/* splitmix64 [Steele, Lea & Flood 2014, "Fast splittable pseudorandom number generators"]. */
static uint64_t sp_family_bits(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static sp_real sp_family_real(uint64_t *state, double from, double to)
{
    return (sp_real)(from + (to - from) * ((double)(sp_family_bits(state) >> 40) / 16777216.0));
}

static int32_t sp_family_int(uint64_t *state, int32_t from, int32_t to)
{
    return from + (int32_t)(sp_family_bits(state) % (uint64_t)(to - from + 1));
}

/* A prism of a quadrilateral in x and z, anticlockwise seen from -y, from y = 0 to depth. */
static sp_status sp_family_prism(sp_scene *scene, const sp_real xz[8], sp_real depth, uint32_t fixed)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 1, 2, 3, 7, 6, 5, 4, 0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3, 3, 7, 4, 0 };
    sp_real xyz[24];
    for (int c = 0; c < 8; c++) {
        xyz[3 * c] = xz[2 * (c % 4)];
        xyz[3 * c + 1] = c < 4 ? 0 : depth;
        xyz[3 * c + 2] = xz[2 * (c % 4) + 1];
    }
    const sp_mesh mesh = { 8, 6, xyz, size, corner };
    return sp_scene_block(scene, &mesh, 2400, fixed, NULL);
}

static sp_status sp_family_box(sp_scene *scene, sp_real x0, sp_real x1, sp_real z0, sp_real z1, sp_real depth, uint32_t fixed)
{
    const sp_real xz[8] = { x0, z0, x1, z0, x1, z1, x0, z1 };
    return sp_family_prism(scene, xz, depth, fixed);
}

/* Each box on the one below, its middle over it. */
static sp_status sp_family_stack(sp_scene *scene, uint64_t *seed)
{
    const int32_t n = sp_family_int(seed, 1, 8);
    sp_real left = 0, right = 2, z = 0;
    sp_status status = sp_family_box(scene, left, right, -1, 0, 1, SP_FIXED);
    for (int32_t k = 0; !status && k < n; k++) {
        const sp_real width = sp_family_real(seed, 0.4, 1.5), height = sp_family_real(seed, 0.1, 0.8);
        const sp_real middle = left + (right - left) * sp_family_real(seed, 0.25, 0.75);
        left = middle - width / 2;
        right = middle + width / 2;
        status = sp_family_box(scene, left, right, z, z + height, sp_family_real(seed, 0.5, 1), 0);
        z += height;
    }
    return status;
}

/* Bricks of two by one, every other course shifted by half of one; up to two are missing above the first course. */
static sp_status sp_family_wall(sp_scene *scene, uint64_t *seed)
{
    const int32_t courses = sp_family_int(seed, 2, 6), bricks = sp_family_int(seed, 2, 5);
    const int32_t missing[2] = { sp_family_int(seed, bricks, 60), sp_family_int(seed, bricks, 60) };
    sp_status status = sp_family_box(scene, -2, (sp_real)(2 * bricks + 2), -1, 0, 2, SP_FIXED);
    int32_t number = 0;
    for (int32_t c = 0; c < courses; c++)
        for (int32_t b = 0; !status && b < bricks; b++, number++) {
            const sp_real x = (sp_real)(2 * b + c % 2);
            if (number == missing[0] || number == missing[1]) continue;
            status = sp_family_box(scene, x, x + 2, (sp_real)c, (sp_real)(c + 1), 1, 0);
        }
    return status;
}

/* Courses cut at random places, not nearer than a sixth of the mean stone to each other. */
static sp_status sp_family_rubble(sp_scene *scene, uint64_t *seed)
{
    const int32_t courses = sp_family_int(seed, 2, 5);
    const sp_real width = sp_family_real(seed, 2, 4), depth = sp_family_real(seed, 0.3, 0.8);
    sp_real z = 0;
    sp_status status = sp_family_box(scene, -1, width + 1, -1, 0, depth, SP_FIXED);
    for (int32_t c = 0; c < courses; c++) {
        const int32_t stones = sp_family_int(seed, 1, 5);
        const sp_real height = sp_family_real(seed, 0.2, 0.7), step = width / (sp_real)stones;
        sp_real x = 0;
        for (int32_t k = 0; !status && k < stones; k++) {
            const sp_real to = k + 1 == stones ? width : step * ((sp_real)(k + 1) + sp_family_real(seed, -0.4, 0.4));
            status = sp_family_box(scene, x, to, z, z + height, depth, 0);
            x = to;
        }
        z += height;
    }
    return status;
}

/* Half a circle of radius 2: t = tan(angle / 2) from the crown, -1 to 1, so that no sine is asked. */
static sp_status sp_family_arch(sp_scene *scene, uint64_t *seed)
{
    const int32_t n = 2 * sp_family_int(seed, 2, 7) + 1;
    const sp_real out = 2 + sp_family_real(seed, 0.25, 0.6);
    sp_status status = sp_family_box(scene, -3, 3, -1, 0, 1, SP_FIXED);
    sp_real x = -1, z = 0;
    for (int32_t k = 0; !status && k < n; k++) {
        const sp_real t = (sp_real)(2 * (k + 1) - n) / (sp_real)n, s = 1 + t * t;
        const sp_real to_x = k + 1 == n ? 1 : 2 * t / s, to_z = k + 1 == n ? 0 : (1 - t * t) / s;
        const sp_real xz[8] = { 2 * x, 2 * z, 2 * to_x, 2 * to_z, out * to_x, out * to_z, out * x, out * z };
        const sp_real turned[8] = { xz[6], xz[7], xz[0], xz[1], xz[2], xz[3], xz[4], xz[5] };
        status = sp_family_prism(scene, turned, 1, 0);
        x = to_x;
        z = to_z;
    }
    return status;
}

sp_status sp_scene_of_family(sp_fuzz_family family, uint64_t seed, sp_arena *arena, sp_scene *scene)
{
    static sp_status (*const make[SP_FUZZ_FAMILIES])(sp_scene *, uint64_t *) = {
        sp_family_stack, sp_family_wall, sp_family_rubble, sp_family_arch,
    };
    enum { N = SP_FAMILY_BLOCKS };
    const sp_capacity room = { N, 8 * N, 6 * N, 24 * N, 4 * N, 16 * N, 0 };
    const sp_arena before = *arena;
    sp_contact_settings touch = sp_contact_settings_default();
    sp_contact_report report;
    if ((int)family < 0 || family >= SP_FUZZ_FAMILIES) return SP_E_ARGUMENT;
    sp_status status = sp_scene_create(scene, &room, arena);
    if (!status) status = make[family](scene, &seed);
    touch.strength = sp_strength_friction(sp_family_real(&seed, 0.4, 0.9));
    memset(&report, 0, sizeof report);
    if (!status) status = sp_contacts_find(scene, &touch, *arena, &report);
    if (status) { *arena = before; return status; }
    const sp_real t = sp_family_real(&seed, -1, 1), g = (sp_real)9.80665;
    scene->body[0] = g * (1 - t * t) / (1 + t * t);
    scene->body[1] = g * 2 * t / (1 + t * t);
    scene->live = 0;
    return SP_OK;
}

sp_status sp_scene_at(sp_scene *scene, sp_real distance, sp_arena scratch)
{
    sp_limit_result r;
    const sp_status status = sp_limit(scene, NULL, &scratch, &r);
    if (status) return status;
    if (r.kind != SP_LIMIT_FOUND) return SP_E_UNSUPPORTED;
    scene->live = (distance > 0 ? r.lower : r.upper) * (1 - distance);
    return SP_OK;
}
