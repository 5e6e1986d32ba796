/* corpus: one number over what sp_check finds in the bundled scenes, verdicts and force bits alike. The same on every machine,
 * compiler and level of optimisation when built with -ffp-contract=off; one number for double, one for float.
 *
 *     cc -ffp-contract=off corpus.c ../scenes/gen.c ../../stonepack.c -lm -I build && ./a.out
 *
 * Prints a line per scene, so that a difference has a name, and last `corpus double HASH`. Before it `bytes 64-bit HASH`, over
 * what each check took of its arena: pointers are in there, so it is the same for machines of one pointer size. Scenes are
 * those of the generators and the committed files, made into C by scenes.awk. No files, no malloc: it runs on a bare board.
 */
#include "../test.h"
#include "../scenes/gen.h"

#include <string.h>

#define C(x) ((sp_real)x)

typedef struct compiled_scene {
    const char *name;
    sp_real mu, gravity[3];
    int32_t blocks, joints;
    const sp_real *xyz;                 /* of all blocks */
    const int32_t *vertices, *faces;    /* per block */
    const uint32_t *fixed;
    const sp_real *density;
    const int32_t *size, *corner;       /* of all faces; corners count from their block's first vertex */
    const int32_t *pair, *points;       /* per joint; none: contacts are found */
    const sp_real *point;
} compiled_scene;

#include "scenes.h"

typedef struct formula { const char *name; struct { const char *name; double value; } set[3]; int32_t faces; } formula;

/* Every generator, standing and falling, near its limit and far from it; some by pyramids. */
static const formula made[] = {
    { "two-cubes",         { { "offset", 0.49 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "two-cubes",         { { "offset", 0.6 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "incline",           { { "angle", 39 }, { "turn", 25 }, { NULL, 0 } }, 0 },
    { "incline",           { { "angle", 39 }, { "turn", 25 }, { NULL, 0 } }, 8 },
    { "incline",           { { "angle", 41 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "topple",            { { "angle", 13 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "topple",            { { "angle", 15 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "overhang",          { { "n", 10 }, { "factor", 0.97 }, { NULL, 0 } }, 0 },
    { "overhang",          { { "n", 10 }, { "factor", 1.03 }, { NULL, 0 } }, 0 },
    { "cantilever",        { { NULL, 0 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "cantilever",        { { "reach", 1.5 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "tower",             { { NULL, 0 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "tower",             { { "lean", 0.1 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "diamond",           { { "rows", 4 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "diamond",           { { "mu", 0.2 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "inverted-triangle", { { NULL, 0 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "arch",              { { "n", 11 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "arch",              { { "n", 11 }, { "t", 0.1 }, { NULL, 0 } }, 0 },
    { "arch",              { { "t", 0.12 }, { "mu", 0.6 }, { NULL, 0 } }, 4 },
    { "arch",              { { "mu", 0.2 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "flat-arch",         { { NULL, 0 }, { NULL, 0 }, { NULL, 0 } }, 16 },
    { "flat-arch",         { { "mu", 0.3 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "keystone",          { { "angle", 39 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "keystone",          { { "angle", 42 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "h-model",           { { NULL, 0 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "h-model",           { { "mu", 0 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "wall",              { { "size", 54 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "wall",              { { "size", 54 }, { "tilt", 15 }, { "azimuth", 90 } }, 0 },
    { "wall",              { { "size", 54 }, { "tilt", 36 }, { NULL, 0 } }, 0 },
    { "wall",              { { "jitter", 0.3 }, { "tilt", 5 }, { "azimuth", 80 } }, 8 },
    { "rubble",            { { NULL, 0 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "rubble",            { { "tilt", 40 }, { NULL, 0 }, { NULL, 0 } }, 0 },
    { "vault",             { { "around", 9 }, { "n", 3 }, { "jitter", 0.2 } }, 0 },
    { "vault",             { { "around", 9 }, { "n", 3 }, { "t", 0.08 } }, 0 },
    { "dome",              { { "rings", 4 }, { "segments", 8 }, { NULL, 0 } }, 0 },
    { "dome",              { { "rings", 4 }, { "segments", 8 }, { "mu", 0.15 } }, 0 }
};

static unsigned char memory[3u << 20];
static uint64_t bytes = 14695981039346656037u;                  /* over the peaks of the arenas */

/* FNV-1a over the bytes of an integer, lowest first, whatever the machine's own order. */
static uint64_t mix(uint64_t hash, uint64_t value)
{
    for (int k = 0; k < 64; k += 8) hash = (hash ^ ((value >> k) & 255)) * 1099511628211u;
    return hash;
}

static uint64_t mix_reals(uint64_t hash, const sp_real *x, int32_t count)
{
    for (int32_t k = 0; k < count; k++) {
#ifdef SP_REAL_FLOAT
        uint32_t bits;
#else
        uint64_t bits;
#endif
        memcpy(&bits, &x[k], sizeof bits);
        hash = mix(hash, bits);
    }
    return hash;
}

/* Verdict, reason, forces, mechanism, demand, work: what a check of the scene says. */
static sp_status judge(const sp_scene *scene, int32_t faces, sp_arena *arena, uint64_t *hash, sp_verdict *verdict)
{
    sp_settings set = sp_settings_default();
    sp_result r;
    set.faces = faces;
    set.localise = 1;
    const sp_status status = sp_check(scene, &set, arena, &r);
    if (status) return status;
    const sp_real number[5] = { r.imbalance, r.least_imbalance, r.extremes.compression, r.extremes.tension, r.extremes.utilisation };
    uint64_t h = 14695981039346656037u;
    h = mix(h, (uint64_t)r.verdict);
    h = mix(h, (uint64_t)r.reason);
    h = mix(h, (uint64_t)(r.final + 2 * r.verified));
    h = mix(h, (uint64_t)r.extremes.weakest);
    h = mix(h, (uint64_t)r.spent.total.flops);
    h = mix(h, (uint64_t)r.spent.total.factorisations);
    h = mix(h, (uint64_t)r.spent.total.iterations);
    h = mix(h, (uint64_t)r.spent.total.interior);
    for (int k = 0; k < SP_STAGES_MAX; k++) h = mix(h, (uint64_t)r.spent.by_stage[k].flops);
    bytes = mix(bytes, (uint64_t)r.spent.peak_bytes);
    h = mix_reals(h, number, 5);
    h = mix_reals(h, r.f, 3 * scene->count.points);
    h = mix_reals(h, r.dq, 6 * scene->count.blocks);
    *hash = h;
    *verdict = r.verdict;
    return SP_OK;
}

static sp_status build(const compiled_scene *c, sp_arena *arena, sp_scene *scene)
{
    const sp_strength friction = sp_strength_friction(c->mu);
    sp_capacity room = { c->blocks, 0, 0, 0, c->joints, 0, 0 };
    const sp_real *xyz = c->xyz, *point = c->point;
    const int32_t *size = c->size, *corner = c->corner;
    for (int32_t b = 0, f = 0; b < c->blocks; b++) {
        room.vertices += c->vertices[b];
        room.faces += c->faces[b];
        for (int32_t k = 0; k < c->faces[b]; k++) room.corners += c->size[f++];
    }
    for (int32_t j = 0; j < c->joints; j++) room.points += c->points[j];
    if (!c->joints) room.joints = 4 * c->blocks, room.points = 32 * c->blocks;
    sp_status status = sp_scene_create(scene, &room, arena);
    for (int32_t b = 0; !status && b < c->blocks; b++) {
        const sp_mesh mesh = { c->vertices[b], c->faces[b], xyz, size, corner };
        status = sp_scene_block(scene, &mesh, c->density[b], c->fixed[b], NULL);
        xyz += 3 * c->vertices[b];
        for (int32_t k = 0; k < c->faces[b]; k++) corner += *size++;
    }
    for (int32_t j = 0; !status && j < c->joints; j++) {
        status = sp_scene_joint(scene, c->pair[2 * j], c->pair[2 * j + 1], c->points[j], point, &friction, NULL);
        point += 3 * c->points[j];
    }
    if (!status && !c->joints) {
        sp_contact_settings set = sp_contact_settings_default();
        sp_contact_report report = { 0, 0, 0, 0, NULL };
        set.strength = friction;
        status = sp_contacts_find(scene, &set, *arena, &report);
    }
    if (!status) memcpy(scene->gravity, c->gravity, sizeof scene->gravity);
    return status;
}

/* One line; the number over all of them. */
static uint64_t tell(uint64_t all, const char *name, const sp_scene *scene, int32_t faces, sp_arena *arena, sp_status status)
{
    uint64_t hash = 0;
    sp_verdict verdict = SP_UNDECIDED;
    if (!status) status = judge(scene, faces, arena, &hash, &verdict);
    TEST_PRINT("%s %s %08lx%08lx\n", name, status ? sp_status_text(status) : sp_verdict_text(verdict),
               (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
    return mix(all, status ? 0 : hash);
}

int main(void)
{
    uint64_t all = 14695981039346656037u;
    int failed = 0;
    sp_arena arena;
    sp_scene scene;
    TEST_START();
    for (size_t k = 0; k < sizeof compiled / sizeof compiled[0]; k++) {
        sp_arena_init(&arena, memory, sizeof memory);
        const sp_status status = build(&compiled[k], &arena, &scene);
        all = tell(all, compiled[k].name, &scene, 0, &arena, status);
        failed |= status != SP_OK;
    }
    for (size_t k = 0; k < sizeof made / sizeof made[0]; k++) {
        gen_scene g;
        sp_arena_init(&arena, memory, sizeof memory);
        int known = gen_open(&g, made[k].name);
        for (int c = 0; c < 3 && known && made[k].set[c].name; c++)
            known = gen_set(&g, made[k].set[c].name, made[k].set[c].value) == 1;
        const sp_status status = known ? gen_build(&g, &arena, &scene) : SP_E_ARGUMENT;
        all = tell(all, made[k].name, &scene, made[k].faces, &arena, status);
        failed |= status != SP_OK;
    }
    TEST_PRINT("bytes %d-bit %08lx%08lx\n", (int)(8 * sizeof(void *)), (unsigned long)(bytes >> 32),
               (unsigned long)(bytes & 0xffffffffu));
    TEST_PRINT("corpus %s %08lx%08lx\n", sizeof(sp_real) == 4 ? "float" : "double",
               (unsigned long)(all >> 32), (unsigned long)(all & 0xffffffffu));
    return failed;
}
