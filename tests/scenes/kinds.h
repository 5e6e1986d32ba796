/* kinds: random scenes of every kind, on both sides of their limits; number k is the same everywhere. The test of the plan and
 * its bench share them. Made by the generator and the public calls; all of it is static, for one file to include.
 */
#ifndef KINDS_H
#define KINDS_H

#include "gen.h"

#include <string.h>

/* Numbers of scene k.                                                                                          [splitmix64] */
typedef struct kinds_random { uint64_t state; } kinds_random;

static double kinds_between(kinds_random *r, double low, double high)
{
    uint64_t x = r->state += 0x9E3779B97F4A7C15u;
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
    x = (x ^ x >> 27) * 0x94D049BB133111EBu;
    x ^= x >> 31;
    return low + (high - low) * ((double)(x >> 11) / 9007199254740992.0);
}

static int kinds_int(kinds_random *r, int low, int high) { return low + (int)kinds_between(r, 0, high - low + 0.999999); }

typedef struct kinds_change { const char *name; double low, high; } kinds_change;       /* a number of a generated scene */

/* Scenes by the generator, and what is built here. */
typedef struct kinds_entry {
    const char *name, *scene;
    kinds_change change[4];
    sp_status (*build)(kinds_random *r, double mu, sp_arena *arena, sp_scene *s);
} kinds_entry;

static sp_status kinds_body(sp_scene *s, double mass, double x, double y, double z)
{
    const sp_real c[3] = { (sp_real)x, (sp_real)y, (sp_real)z };
    return sp_scene_body(s, (sp_real)mass, c, mass > 0 ? 0 : SP_FIXED, NULL);
}

/* b on a: where the rectangles p and q (x, y of the middle, half sides) overlap, level at z. */
static sp_status kinds_bed(sp_scene *s, int a, int b, const double p[4], const double q[4], double z, double mu)
{
    double low[2], high[2];
    sp_real v[12];
    const sp_strength strength = sp_strength_friction((sp_real)mu);
    for (int k = 0; k < 2; k++) {
        low[k] = p[k] - p[2 + k] > q[k] - q[2 + k] ? p[k] - p[2 + k] : q[k] - q[2 + k];
        high[k] = p[k] + p[2 + k] < q[k] + q[2 + k] ? p[k] + p[2 + k] : q[k] + q[2 + k];
        if (!(high[k] - low[k] > 1e-3)) return SP_OK;
    }
    for (int k = 0; k < 4; k++) {
        v[3 * k] = (sp_real)(k == 1 || k == 2 ? high[0] : low[0]);
        v[3 * k + 1] = (sp_real)(k > 1 ? high[1] : low[1]);
        v[3 * k + 2] = (sp_real)z;
    }
    return sp_scene_joint(s, a, b, 4, v, &strength, NULL);
}

static sp_status kinds_room(sp_scene *s, int32_t blocks, int32_t joints, sp_arena *arena)
{
    const sp_capacity cap = { blocks, 0, 0, 0, joints, 4 * joints, 0 };
    return sp_scene_create(s, &cap, arena);
}

/* Piles of blocks, each moved along and across on the one below. */
static sp_status kinds_piles(kinds_random *r, int piles, double mu, sp_arena *arena, sp_scene *s)
{
    const double ground[4] = { 0, 0, 1e3, 1e3 }, most = kinds_between(r, 0.05, 0.3);
    sp_status e = kinds_room(s, 1 + 12 * piles, 12 * piles, arena);
    if (!e) e = kinds_body(s, 0, 0, 0, -1);
    for (int p = 0; p < piles; p++) {
        const int high = kinds_int(r, 3, 12);
        double below[4] = { 0, 0, 0, 0 };
        for (int k = 0, id = 0; k < high; k++) {
            double at[4] = { 10 * p, 0, kinds_between(r, 0.4, 0.6), kinds_between(r, 0.4, 0.6) };
            for (int q = 0; q < 2 && k; q++) at[q] = below[q] + kinds_between(r, -most, most);
            if (!e) e = kinds_body(s, kinds_between(r, 500, 2000), at[0], at[1], k + 0.5);
            if (!e) e = kinds_bed(s, id, s->count.blocks - 1, k ? below : ground, at, k, mu);
            id = s->count.blocks - 1;
            memcpy(below, at, sizeof below);
        }
    }
    return e;
}

static sp_status kinds_pile(kinds_random *r, double mu, sp_arena *arena, sp_scene *s) { return kinds_piles(r, 1, mu, arena, s); }

static sp_status kinds_yard(kinds_random *r, double mu, sp_arena *arena, sp_scene *s)
{
    return kinds_piles(r, kinds_int(r, 2, 6), mu, arena, s);
}

static sp_status kinds_slippery(kinds_random *r, double mu, sp_arena *arena, sp_scene *s)
{
    return kinds_piles(r, kinds_int(r, 1, 3), 0 * mu, arena, s);
}

/* Storeys of piers under a slab, every other slab turned; piers and slabs a little off. */
static sp_status kinds_tables(kinds_random *r, double mu, sp_arena *arena, sp_scene *s)
{
    const double most = kinds_between(r, 0.05, 0.6);
    const int storeys = kinds_int(r, 1, 4);
    double below[4] = { 0, 0, 1e3, 1e3 };
    sp_status e = kinds_room(s, 1 + 4 * storeys, 6 * storeys, arena);
    if (!e) e = kinds_body(s, 0, 0, 0, -1);
    for (int k = 0, id = 0; k < storeys; k++) {
        double slab[4] = { 0, 0, k % 2 ? 1 : 3, k % 2 ? 3 : 1 };
        const int piers = kinds_int(r, 2, 3);
        double pier[3][4];
        for (int q = 0; q < 2; q++) slab[q] = kinds_between(r, -most, most);
        for (int q = 0; q < piers; q++) {
            const double along = piers == 2 ? 3 * q - 1.5 : 1.5 * q - 1.5;
            pier[q][0] = (k % 2 ? 0 : along) + kinds_between(r, -0.3, 0.3);
            pier[q][1] = (k % 2 ? along : 0) + kinds_between(r, -0.3, 0.3);
            pier[q][2] = pier[q][3] = 0.5;
            if (!e) e = kinds_body(s, 1000, pier[q][0], pier[q][1], 1.5 * k + 0.5);
            if (!e) e = kinds_bed(s, id, s->count.blocks - 1, below, pier[q], 1.5 * k, mu);
        }
        if (!e) e = kinds_body(s, kinds_between(r, 1000, 6000), slab[0], slab[1], 1.5 * k + 1.25);
        for (int q = 0; q < piers; q++)
            if (!e) e = kinds_bed(s, s->count.blocks - 1 - piers + q, s->count.blocks - 1, pier[q], slab, 1.5 * k + 1, mu);
        id = s->count.blocks - 1;
        memcpy(below, slab, sizeof below);
    }
    return e;
}

static const kinds_entry kinds_table[] = {
    { "wall", "wall", { { "jitter", 0, 0.45 }, { "tilt", 0, 40 }, { "rows", 4, 9 }, { "seed", 1, 1000 } }, NULL },
    { "wall, out of plane", "wall", { { "jitter", 0, 0.45 }, { "tilt", 0, 12 }, { "azimuth", 80, 100 }, { "seed", 1, 1000 } }, NULL },
    { "wall, nearly planar", "wall", { { "jitter", 0, 0.45 }, { "tilt", 0, 40 }, { "rows", 4, 9 }, { "seed", 1, 1000 } }, NULL },
    { "rubble", "rubble", { { "tilt", 0, 40 }, { "rows", 3, 6 }, { "jitter", 0.2, 0.8 }, { "seed", 1, 1000 } }, NULL },
    { "arch", "arch", { { "t", 0.07, 0.16 }, { "n", 6, 30 }, { "mu", 0.2, 0.9 }, { "depth", 0.2, 0.8 } }, NULL },
    { "flat arch", "flat-arch", { { "mu", 0.2, 0.9 }, { "n", 5, 15 }, { "half", 10, 35 }, { "tilt", 0, 5 } }, NULL },
    { "vault", "vault", { { "t", 0.08, 0.2 }, { "jitter", 0.1, 0.4 }, { "tilt", 0, 10 }, { "seed", 1, 1000 } }, NULL },
    { "dome", "dome", { { "t", 0.02, 0.12 }, { "mu", 0.1, 0.9 }, { "tilt", 0, 10 }, { "rings", 5, 8 } }, NULL },
    { "tower", "tower", { { "lean", 0.02, 0.16 }, { "n", 4, 20 }, { "mu", 0.2, 0.9 }, { "tilt", 0, 3 } }, NULL },
    { "diamond", "diamond", { { "mu", 0.05, 0.8 }, { "rows", 3, 7 }, { "height", 0.2, 0.4 }, { "tilt", 0, 1 } }, NULL },
    { "chain", "overhang", { { "n", 3, 20 }, { "factor", 0.8, 1.2 }, { "mu", 0.2, 0.9 }, { "tilt", 0, 1 } }, NULL },
    { "pile", NULL, { { NULL, 0, 0 } }, kinds_pile },
    { "piles", NULL, { { NULL, 0, 0 } }, kinds_yard },
    { "piles, mu = 0", NULL, { { NULL, 0, 0 } }, kinds_slippery },
    { "piers and slabs", NULL, { { NULL, 0, 0 } }, kinds_tables }
};

enum { KINDS = sizeof kinds_table / sizeof kinds_table[0] };

/* Scene k: of kind k % KINDS, and the cone it is checked with: of eight the true one thrice. */
static sp_status kinds_make(int k, sp_arena *arena, sp_scene *s, sp_settings *set)
{
    static const int32_t cone[] = { 0, 8, 0, 4, 0, 5, 8, 12 };
    const kinds_entry *e = &kinds_table[k % KINDS];
    kinds_random r = { (uint64_t)k };
    gen_scene g;
    sp_status status;
    *set = sp_settings_default();
    set->localise = 1;
    set->faces = cone[k / KINDS % 8];
    set->inscribed = k / KINDS % 2;
    if (e->build) return e->build(&r, kinds_between(&r, 0.1, 0.9), arena, s);
    if (!gen_open(&g, e->scene)) return SP_E_ARGUMENT;
    for (int q = 0; q < 4; q++) gen_set(&g, e->change[q].name, kinds_between(&r, e->change[q].low, e->change[q].high));
    status = gen_build(&g, arena, s);
    if (!status && k % KINDS == 2) {                                    /* one stone off by 1e-14 to 1e-2 of its depth */
        double off = 0.002;
        for (int q = kinds_int(&r, 0, 12); q > 0; q--) off *= 0.1;
        s->block[s->count.blocks / 2].centroid[1] += (sp_real)off;
    }
    return status;
}

#endif /* KINDS_H */
