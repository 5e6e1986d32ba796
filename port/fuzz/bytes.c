/* bytes: a small valid scene from any bytes; see bytes.h. */
#include "bytes.h"

#include <string.h>

/* What is left of the bytes. */
typedef struct sp_fuzz_bytes { const uint8_t *at; size_t left; } sp_fuzz_bytes;

static unsigned sp_fuzz_byte(sp_fuzz_bytes *b)
{
    if (!b->left) return 0;
    b->left--;
    return *b->at++;
}

/* Eighths of a metre for most bytes, so that faces meet; near misses for the others. */
static sp_real sp_fuzz_place(sp_fuzz_bytes *b)
{
    const unsigned k = sp_fuzz_byte(b);
    if (k < 200) return (sp_real)(k % 32) / 8 - 1;
    return (sp_real)(k - 200) / 1000 + (sp_real)sp_fuzz_byte(b) / 1000000;
}

/* A box low..high whose top is `narrow` as wide and shifted by `shear` along x. */
typedef struct sp_fuzz_box { sp_real low[3], high[3], narrow, shear; } sp_fuzz_box;

static void sp_fuzz_shape(sp_fuzz_bytes *b, const sp_fuzz_box *below, sp_fuzz_box *o)
{
    for (int k = 0; k < 3; k++) {
        o->low[k] = sp_fuzz_place(b);
        o->high[k] = o->low[k] + (sp_real)(1 + sp_fuzz_byte(b) % 16) / 8;
    }
    const unsigned on = sp_fuzz_byte(b), top = sp_fuzz_byte(b);
    if (below && on < 220) {                            /* mostly it stands on an earlier one */
        const sp_real height = o->high[2] - o->low[2];
        o->low[2] = below->high[2];
        o->high[2] = o->low[2] + height;
    }
    o->narrow = top < 160 ? 1 : (sp_real)(top - 120) / 100;
    o->shear = top % 8 == 7 ? (sp_real)(top % 64) / 256 : 0;
}

static sp_status sp_fuzz_block(sp_scene *scene, const sp_fuzz_box *o, sp_real density, uint32_t fixed)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
    sp_real xyz[24];
    for (int c = 0; c < 8; c++) {
        const int q = c % 4, at[3] = { q == 1 || q == 2, q > 1, c > 3 };
        for (int k = 0; k < 3; k++) {
            const sp_real middle = (o->low[k] + o->high[k]) / 2, x = at[k] ? o->high[k] : o->low[k];
            xyz[3 * c + k] = c > 3 && k < 2 ? middle + (x - middle) * o->narrow + (k ? 0 : o->shear) : x;
        }
    }
    const sp_mesh mesh = { 8, 6, xyz, size, corner };
    return sp_scene_block(scene, &mesh, density, fixed, NULL);
}

static sp_status sp_fuzz_load(sp_scene *scene, sp_fuzz_bytes *b)
{
    sp_load load;
    memset(&load, 0, sizeof load);
    load.block = (int32_t)(sp_fuzz_byte(b) % (unsigned)scene->count.blocks);
    load.live = (int32_t)(sp_fuzz_byte(b) & 1);
    for (int k = 0; k < 3; k++) {
        load.force[k] = (sp_real)((int)sp_fuzz_byte(b) - 128) * 100;
        load.point[k] = sp_fuzz_place(b);
    }
    load.couple[2] = sp_fuzz_byte(b) > 200 ? 500 : 0;
    return sp_scene_load(scene, &load, NULL);
}

/* Friction of the joints; strength with one in sixteen. */
static sp_strength sp_fuzz_strength(sp_fuzz_bytes *b)
{
    static const double mu[16] = { 0.84, 0, 0.5, 1e-9, 1, 10, 0.3, 0.577, 0.1, 1e-3, 1e3, 0.7, 0.84, 0.84, 0.6, 2 };
    sp_strength s = sp_strength_friction((sp_real)mu[sp_fuzz_byte(b) % 16]);
    const unsigned more = sp_fuzz_byte(b);
    if (more < 240) return s;
    s.cohesion = (sp_real)(more - 239) * 10000;
    s.tension = more > 248 ? 5000 : 0;
    s.crushing = more > 252 ? 1000000 : 0;
    return s;
}

sp_status sp_scene_from_bytes(const uint8_t *bytes, size_t count, sp_arena *arena, sp_scene *scene)
{
    sp_fuzz_bytes b = { bytes, count };
    const int32_t n = 2 + (int32_t)(sp_fuzz_byte(&b) % (SP_FUZZ_BLOCKS - 1));
    const sp_capacity room = { n, 8 * n, 6 * n, 24 * n, 40, 320, SP_FUZZ_LOADS };
    sp_fuzz_box box[SP_FUZZ_BLOCKS];
    sp_contact_settings touch = sp_contact_settings_default();
    sp_contact_report report;
    sp_status status = sp_scene_create(scene, &room, arena);
    for (int32_t k = 0; !status && k < n; k++) {
        const unsigned under = sp_fuzz_byte(&b);
        sp_fuzz_shape(&b, k ? &box[under % (unsigned)k] : NULL, &box[k]);
        const unsigned held = sp_fuzz_byte(&b), kind = held % 7;
        const uint32_t fixed = !k ? (held < 240 ? SP_FIXED : held % 64) : held < 200 ? 0 : held < 220 ? SP_FIXED : held % 64;
        status = sp_fuzz_block(scene, &box[k], kind == 3 ? 1 : kind == 5 ? 10000 : 2400, fixed);
    }
    touch.strength = sp_fuzz_strength(&b);
    const unsigned slope = sp_fuzz_byte(&b), loads = sp_fuzz_byte(&b) % 8;
    scene->gravity[0] = slope > 200 ? (sp_real)(slope - 200) / 10 : 0;
    scene->gravity[1] = slope > 240 ? 1 : 0;
    memset(&report, 0, sizeof report);
    if (!status) status = sp_contacts_find(scene, &touch, *arena, &report);
    for (unsigned k = 0; !status && k < (loads < 3 ? loads : 0); k++) status = sp_fuzz_load(scene, &b);
    return status;
}
