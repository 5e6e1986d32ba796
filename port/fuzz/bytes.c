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

/* The same of given bytes, for the search of the inverse. */
static sp_real sp_fuzz_place_of(const uint8_t two[2])
{
    sp_fuzz_bytes b = { two, 2 };
    return sp_fuzz_place(&b);
}

/* A box low..high whose top is `narrow` as wide and shifted by `shear` along x. */
typedef struct sp_fuzz_box { sp_real low[3], high[3], narrow, shear; } sp_fuzz_box;

static void sp_fuzz_top(sp_fuzz_box *o, unsigned top)
{
    o->narrow = top < 160 ? 1 : (sp_real)(top - 120) / 100;
    o->shear = top % 8 == 7 ? (sp_real)(top % 64) / 256 : 0;
}

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
    sp_fuzz_top(o, top);
}

static void sp_fuzz_corners(const sp_fuzz_box *o, sp_real xyz[24])
{
    for (int c = 0; c < 8; c++) {
        const int q = c % 4, at[3] = { q == 1 || q == 2, q > 1, c > 3 };
        for (int k = 0; k < 3; k++) {
            const sp_real middle = (o->low[k] + o->high[k]) / 2, x = at[k] ? o->high[k] : o->low[k];
            xyz[3 * c + k] = c > 3 && k < 2 ? middle + (x - middle) * o->narrow + (k ? 0 : o->shear) : x;
        }
    }
}

static sp_status sp_fuzz_block(sp_scene *scene, const sp_fuzz_box *o, sp_real density, uint32_t fixed)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
    sp_real xyz[24];
    sp_fuzz_corners(o, xyz);
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

static uint32_t sp_fuzz_fixed(unsigned held, int first)
{
    if (first) return held < 240 ? SP_FIXED : held % 64;
    return held < 200 ? 0 : held < 220 ? SP_FIXED : held % 64;
}

static sp_real sp_fuzz_density(unsigned held) { return held % 7 == 3 ? 1 : held % 7 == 5 ? 10000 : 2400; }

static void sp_fuzz_slope(unsigned slope, sp_real gravity[3])
{
    gravity[0] = slope > 200 ? (sp_real)(slope - 200) / 10 : 0;
    gravity[1] = slope > 240 ? 1 : 0;
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
        const unsigned held = sp_fuzz_byte(&b);
        status = sp_fuzz_block(scene, &box[k], sp_fuzz_density(held), sp_fuzz_fixed(held, !k));
    }
    touch.strength = sp_fuzz_strength(&b);
    const unsigned slope = sp_fuzz_byte(&b), loads = sp_fuzz_byte(&b) % 8;
    sp_fuzz_slope(slope, scene->gravity);
    memset(&report, 0, sizeof report);
    if (!status) status = sp_contacts_find(scene, &touch, *arena, &report);
    for (unsigned k = 0; !status && k < (loads < 3 ? loads : 0); k++) status = sp_fuzz_load(scene, &b);
    return status;
}

/* ------------------------------------------------------------------------------------------------------------- the inverse
 * By search: each byte, or two that belong together, is the first that makes the number. */

/* What is written so far; `lost`: no byte makes some number. */
typedef struct sp_fuzz_writer { uint8_t *at; size_t used; int lost; } sp_fuzz_writer;

static void sp_fuzz_put(sp_fuzz_writer *w, unsigned byte) { w->at[w->used++] = (uint8_t)byte; }

static int sp_fuzz_same(sp_real a, sp_real b) { return a <= b && a >= b; }

/* Code k of a place: one byte below 200, else two. */
enum { SP_FUZZ_PLACES = 200 + 56 * 256 };
static void sp_fuzz_code(int k, uint8_t two[2])
{
    two[0] = (uint8_t)(k < 200 ? k : 200 + (k - 200) / 256);
    two[1] = (uint8_t)(k < 200 ? 0 : (k - 200) % 256);
}

static void sp_fuzz_put_code(sp_fuzz_writer *w, const uint8_t two[2])
{
    sp_fuzz_put(w, two[0]);
    if (two[0] >= 200) sp_fuzz_put(w, two[1]);
}

static void sp_fuzz_put_place(sp_fuzz_writer *w, sp_real x)
{
    uint8_t two[2];
    int k = 0;
    for (; k < SP_FUZZ_PLACES; k++) {
        sp_fuzz_code(k, two);
        if (sp_fuzz_same(sp_fuzz_place_of(two), x)) break;
    }
    if (k == SP_FUZZ_PLACES) { w->lost = 1; return; }
    sp_fuzz_put_code(w, two);
}

/* A place and a size whose low and high are these; `onto`: the low is that of the block below, whatever the place. */
static void sp_fuzz_put_span(sp_fuzz_writer *w, sp_real low, sp_real high, int onto)
{
    uint8_t two[2];
    for (int k = 0; k < SP_FUZZ_PLACES; k++) {
        sp_fuzz_code(k, two);
        const sp_real at = sp_fuzz_place_of(two);
        if (!onto && !sp_fuzz_same(at, low)) continue;
        for (unsigned size = 0; size < 16; size++) {
            const sp_real end = at + (sp_real)(1 + size) / 8;
            if (!sp_fuzz_same(onto ? low + (end - at) : end, high)) continue;
            sp_fuzz_put_code(w, two);
            sp_fuzz_put(w, size);
            return;
        }
    }
    w->lost = 1;
}

static void sp_fuzz_put_top(sp_fuzz_writer *w, sp_fuzz_box o, sp_real (*vertex)[3])
{
    for (unsigned top = 0; top < 256; top++) {
        sp_real xyz[24];
        int same = 1;
        sp_fuzz_top(&o, top);
        sp_fuzz_corners(&o, xyz);
        for (int c = 0; c < 24; c++) same = same && sp_fuzz_same(xyz[c], vertex[c / 3][c % 3]);
        if (same) { sp_fuzz_put(w, top); return; }
    }
    w->lost = 1;
}

/* Which of the blocks before it it stands on; -1: none, its place is its own. */
static int32_t sp_fuzz_below(const sp_fuzz_box *box, int32_t k)
{
    for (int32_t j = 0; j < k; j++) if (sp_fuzz_same(box[j].high[2], box[k].low[2])) return j;
    return -1;
}

static void sp_fuzz_put_block(sp_fuzz_writer *w, const sp_scene *scene, int32_t k, sp_fuzz_box *box)
{
    const sp_block *block = &scene->block[k];
    if (block->vertices != 8 || block->faces != 6) { w->lost = 1; return; }
    sp_real (*v)[3] = scene->vertex + block->vertex;
    for (int c = 0; c < 3; c++) {
        box[k].low[c] = v[0][c];
        box[k].high[c] = c < 2 ? v[2][c] : v[6][c];
    }
    const int32_t below = sp_fuzz_below(box, k);
    sp_fuzz_put(w, below < 0 ? 0 : (unsigned)below);
    for (int c = 0; c < 3; c++) sp_fuzz_put_span(w, box[k].low[c], box[k].high[c], c == 2 && below >= 0);
    sp_fuzz_put(w, below < 0 ? 220 : 0);
    sp_fuzz_put_top(w, box[k], v);
    for (unsigned held = 0; held < 256; held++)
        if (sp_fuzz_fixed(held, !k) == block->fixed && sp_fuzz_same(sp_fuzz_density(held), block->density)) {
            sp_fuzz_put(w, held);
            return;
        }
    w->lost = 1;
}

static void sp_fuzz_put_strength(sp_fuzz_writer *w, const sp_strength *s)
{
    for (unsigned k = 0; k < 16 * 256; k++) {
        const uint8_t two[2] = { (uint8_t)(k % 16), (uint8_t)(k / 16) };
        sp_fuzz_bytes b = { two, 2 };
        const sp_strength o = sp_fuzz_strength(&b);
        if (sp_fuzz_same(o.mu, s->mu) && sp_fuzz_same(o.cohesion, s->cohesion) && sp_fuzz_same(o.tension, s->tension) &&
            sp_fuzz_same(o.crushing, s->crushing)) {
            sp_fuzz_put(w, two[0]);
            sp_fuzz_put(w, two[1]);
            return;
        }
    }
    w->lost = 1;
}

static void sp_fuzz_put_slope(sp_fuzz_writer *w, const sp_real gravity[3])
{
    for (unsigned slope = 0; slope < 256; slope++) {
        sp_real g[3];
        sp_fuzz_slope(slope, g);
        if (sp_fuzz_same(g[0], gravity[0]) && sp_fuzz_same(g[1], gravity[1])) { sp_fuzz_put(w, slope); return; }
    }
    w->lost = 1;
}

static void sp_fuzz_put_load(sp_fuzz_writer *w, const sp_load *load)
{
    const int couple = sp_fuzz_same(load->couple[2], 500);
    sp_fuzz_put(w, (unsigned)load->block);
    sp_fuzz_put(w, load->live ? 1 : 0);
    for (int k = 0; k < 3; k++) {
        const sp_real code = load->force[k] / 100 + 128;
        const unsigned byte = code >= 0 && code <= 255 ? (unsigned)code : 0;
        if (!sp_fuzz_same((sp_real)((int)byte - 128) * 100, load->force[k])) w->lost = 1;
        sp_fuzz_put(w, byte);
        sp_fuzz_put_place(w, load->point[k]);
    }
    if (!sp_fuzz_same(load->couple[0], 0) || !sp_fuzz_same(load->couple[1], 0) || load->mass > 0 ||
        (!couple && !sp_fuzz_same(load->couple[2], 0))) w->lost = 1;
    sp_fuzz_put(w, couple ? 255 : 0);
}

size_t sp_scene_to_bytes(const sp_scene *scene, uint8_t *bytes, size_t room)
{
    static const sp_strength plain = { (sp_real)0.84, 0, 0, 0 };
    sp_fuzz_writer w = { bytes, 0, 0 };
    sp_fuzz_box box[SP_FUZZ_BLOCKS];
    const int32_t n = scene->count.blocks;
    const sp_real *a = scene->body;
    if (room < SP_FUZZ_BYTES || n < 2 || n > SP_FUZZ_BLOCKS || scene->count.loads > SP_FUZZ_LOADS) return 0;
    if (!sp_fuzz_same(scene->live, 1) || !sp_fuzz_same(a[0] * a[0] + a[1] * a[1] + a[2] * a[2], 0)) return 0;
    if (!sp_fuzz_same(scene->gravity[2], (sp_real)-9.80665)) return 0;
    sp_fuzz_put(&w, (unsigned)(n - 2));
    for (int32_t k = 0; !w.lost && k < n; k++) sp_fuzz_put_block(&w, scene, k, box);
    sp_fuzz_put_strength(&w, scene->count.joints ? &scene->joint[0].strength : &plain);
    sp_fuzz_put_slope(&w, scene->gravity);
    sp_fuzz_put(&w, (unsigned)scene->count.loads);
    for (int32_t k = 0; !w.lost && k < scene->count.loads; k++) sp_fuzz_put_load(&w, &scene->load[k]);
    return w.lost ? 0 : w.used;
}
