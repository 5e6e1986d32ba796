/* hard: scenes that try to break the numbers, each with its reason and its truth. Tests and instruments share them.
 *
 * tests/proof has claims made to mislead and the odd shapes one by one; here every scene is one row, so that it can be
 * run in another arithmetic. Made by the public calls; all of it is static, for one file to include.
 */
#ifndef HARD_H
#define HARD_H

#include "gen.h"

enum {
    HARD_NO_FLOAT = 1,          /* lengths that vanish beside others in 24 bits: float refuses the joint */
    HARD_OPEN_FLOAT = 2,        /* float may leave it undecided: why and how far from its limit is told beside it */
    HARD_FINE_FLOAT = 1024,     /* falls, but forces hold it that miss balance by less than 1e-5: float is asked at 3e-6 */
    HARD_BAND_FLOAT = 128,      /* in float's band, 1e-3 of its limit: nothing is asked of it */
    HARD_CAPPED_FLOAT = 256,    /* takes more than float's force_bound: UNSTABLE that far, never final */
    HARD_FORCES_FLOAT = 512,    /* in float it takes balancing in forces, which goes with the interior points */
    HARD_LIMIT = 4,             /* at its limit, or at the end of its numbers: undecided is honest everywhere */
    HARD_LONG = 16,             /* height 1e3 x base and more: rounding grows by its square, so imbalance may pass 1e-12 */
    HARD_HEAVY = 32,            /* most of the battery's work */
    HARD_INTERIOR = 64,         /* takes interior points: undecided is honest where they are left out */
    HARD_DENORMAL = 8           /* weights below the normal range: undecided or refused where they are flushed to zero */
};

typedef struct hard_case {
    const char *name, *why;
    sp_verdict truth;
    unsigned flags;
    sp_status (*build)(const struct hard_case *c, sp_arena *arena, sp_scene *s);
    double a, b;                /* of the builder */
    double far;                 /* relative distance from its limit, in load, friction or overhang; 0: at it, or none is known */
} hard_case;

static sp_status hard_start(sp_scene *s, int32_t blocks, int32_t joints, int32_t points, sp_arena *arena)
{
    const sp_capacity cap = { blocks, 0, 0, 0, joints, points, 0 };
    return sp_scene_create(s, &cap, arena);
}

static sp_status hard_body(sp_scene *s, double mass, double x, double y, double z, int fixed)
{
    const sp_real c[3] = { (sp_real)x, (sp_real)y, (sp_real)z };
    return sp_scene_body(s, (sp_real)mass, c, fixed ? SP_FIXED : 0, NULL);
}

/* b stands on a: a level rectangle 2 p by 2 q about (x, y, z). */
static sp_status hard_bed(sp_scene *s, int32_t a, int32_t b, double x, double y, double z, double p, double q, double mu)
{
    const double c[12] = { x - p, y - q, z, x + p, y - q, z, x + p, y + q, z, x - p, y + q, z };
    const sp_strength strength = sp_strength_friction((sp_real)mu);
    sp_real v[12];
    for (int k = 0; k < 12; k++) v[k] = (sp_real)c[k];
    return sp_scene_joint(s, a, b, 4, v, &strength, NULL);
}

/* Ground, a cube of 1 m and mass a, on it another of mass b, `off` beside it. */
static sp_status hard_two(const hard_case *c, double off, sp_arena *arena, sp_scene *s)
{
    sp_status e = hard_start(s, 3, 2, 8, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -0.5, 1);
    if (!e) e = hard_body(s, c->a, 0, 0, 0.5, 0);
    if (!e) e = hard_body(s, c->b, off, 0, 1.5, 0);
    if (!e) e = hard_bed(s, 0, 1, 0, 0, 0, 0.5, 0.5, 0.6);
    return e ? e : hard_bed(s, 1, 2, off / 2, 0, 1, 0.5 - off / 2, 0.5, 0.6);
}

static sp_status hard_masses(const hard_case *c, sp_arena *arena, sp_scene *s) { return hard_two(c, 0, arena, s); }

/* The upper one's middle beyond the lower one's edge. */
static sp_status hard_masses_off(const hard_case *c, sp_arena *arena, sp_scene *s) { return hard_two(c, 0.6, arena, s); }

/* A cube of 10 m, its middle `a` beside a joint `b` wide. */
static sp_status hard_edge(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    sp_status e = hard_start(s, 2, 1, 4, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -5, 1);
    if (!e) e = hard_body(s, 2.4e6, c->a, 0, 5, 0);
    return e ? e : hard_bed(s, 0, 1, 0, 0, 0, c->b / 2, 5, 0.6);
}

/* A cube of 10 m on a joint of 10 m and one of 1e-6 m: edges that differ by seven orders. */
static sp_status hard_edges(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    sp_status e = hard_start(s, 2, 2, 8, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -5, 1);
    if (!e) e = hard_body(s, 2.4e6, 0, 0, 5, 0);
    if (!e) e = hard_bed(s, 0, 1, 1, 0, 0, 4, 5, 0.6);
    return e ? e : hard_bed(s, 0, 1, -4.9, 0, 0, c->b / 2, 5e-7, 0.6);
}

/* A block of base 1, height a, gravity turned so that tan = b / a; topples beyond b = 1. */
static sp_status hard_slender(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    sp_status e = hard_start(s, 2, 1, 4, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -1, 1);
    if (!e) e = hard_body(s, 1, 0, 0, c->a / 2, 0);
    if (e) return e;
    s->gravity[0] = (sp_real)(9.81 * c->b / c->a);
    s->gravity[2] = (sp_real)-9.81;
    return hard_bed(s, 0, 1, 0, 0, 0, 0.5, 0.5, 1000);
}

/* A disc of radius 1 on a joint of `a` corners, its middle b beside the joint's. */
static sp_status hard_gon(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    const int32_t n = (int32_t)c->a;
    const sp_strength strength = sp_strength_friction((sp_real)0.6);
    sp_real v[3 * 512];
    sp_status e = hard_start(s, 2, 1, n, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -1, 1);
    if (!e) e = hard_body(s, 100, c->b, 0, 0.5, 0);
    for (int32_t k = 0; k < n; k++) {
        const double t = 6.283185307179586 * k / n;
        v[3 * k] = (sp_real)gen_cos(t);
        v[3 * k + 1] = (sp_real)gen_sin(t);
        v[3 * k + 2] = 0;
    }
    return e ? e : sp_scene_joint(s, 0, 1, n, v, &strength, NULL);
}

/* A cube on a joint given `a` times, each shifted by b; it stands on a support of another mind where b = 0. */
static sp_status hard_repeated(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    const int32_t n = (int32_t)c->a;
    sp_status e = hard_start(s, 3, n + 1, 4 * n + 4, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -0.5, 1);
    if (!e) e = hard_body(s, 2400, 0, 0, 0.5, 0);
    if (!e) e = hard_body(s, 2400, 0.2, 0.1, 1.5, 0);
    for (int32_t k = 0; k < n && !e; k++) e = hard_bed(s, 0, 1, k * c->b, -k * c->b, 0, 0.5, 0.5, 0.6);
    return e ? e : hard_bed(s, 1, 2, 0.1, 0.05, 1, 0.4, 0.45, 0.6);
}

/* A plate of 1 by 1 by 1e-3 under friction a, gravity turned to tan = b. */
static sp_status hard_slope(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    sp_status e = hard_start(s, 2, 1, 4, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -1, 1);
    if (!e) e = hard_body(s, 2.4, 0, 0, 0.0005, 0);
    if (e) return e;
    s->gravity[0] = (sp_real)(9.81 * c->b);
    s->gravity[2] = (sp_real)-9.81;
    return hard_bed(s, 0, 1, 0, 0, 0, 0.5, 0.5, c->a);
}

/* A block on a points (1: under its middle, 2: an edge along y), its middle b beside them. */
static sp_status hard_points(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    const sp_real up[3] = { 0, 0, 1 }, v[6] = { 0, c->a > 1 ? (sp_real)-0.5 : 0, 0, 0, (sp_real)0.5, 0 };
    const sp_strength strength = sp_strength_friction((sp_real)0.6);
    sp_status e = hard_start(s, 2, 1, 2, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -1, 1);
    if (!e) e = hard_body(s, 10, c->b, 0, 0.5, 0);
    return e ? e : sp_scene_points(s, 0, 1, up, (int32_t)c->a, v, &strength, NULL);
}

/* A square whose edges carry `a` corners each, all collinear but four; the middle of the cube b beside its own. */
static sp_status hard_collinear(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    static const double corner[5][2] = { { -0.5, -0.5 }, { 0.5, -0.5 }, { 0.5, 0.5 }, { -0.5, 0.5 }, { -0.5, -0.5 } };
    const int32_t n = (int32_t)c->a;
    const sp_strength strength = sp_strength_friction((sp_real)0.6);
    sp_real v[3 * 64];
    sp_status e = hard_start(s, 2, 1, 4 * n, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -1, 1);
    if (!e) e = hard_body(s, 10, c->b, 0, 0.5, 0);
    for (int32_t k = 0; k < 4 * n; k++) {
        const double *p = corner[k / n], *q = corner[k / n + 1], t = (double)(k % n) / n;
        v[3 * k] = (sp_real)(p[0] + t * (q[0] - p[0]));
        v[3 * k + 1] = (sp_real)(p[1] + t * (q[1] - p[1]));
        v[3 * k + 2] = 0;
    }
    return e ? e : sp_scene_joint(s, 0, 1, 4 * n, v, &strength, NULL);
}

/* Five cubes of side a and mass b, each 0.05 a (0.3 a: it falls) beyond the one below. */
static sp_status hard_tower(sp_arena *arena, sp_scene *s, double side, double mass, double lean, double x, double y)
{
    sp_status e = hard_start(s, 6, 5, 20, arena);
    for (int k = 0; k < 6 && !e; k++) e = hard_body(s, k ? mass : 0, x + k * lean * side, y, (k - 0.5) * side, k == 0);
    for (int k = 0; k < 5 && !e; k++)
        e = hard_bed(s, k, k + 1, x + (k + 0.5) * lean * side, y, k * side, (0.5 - lean / 2) * side, 0.5 * side, 0.6);
    return e;
}
static sp_status hard_scale_stands(const hard_case *c, sp_arena *arena, sp_scene *s) { return hard_tower(arena, s, c->a, c->b, 0.05, 0, 0); }
static sp_status hard_scale_falls(const hard_case *c, sp_arena *arena, sp_scene *s) { return hard_tower(arena, s, c->a, c->b, 0.3, 0, 0); }
static sp_status hard_offset(const hard_case *c, sp_arena *arena, sp_scene *s) { return hard_tower(arena, s, 1, 2400, c->b, c->a, -c->a); }

/* Ten cubes on each other, in turn on a joint of 1 m and one of a: rows that differ by 1 / a. */
static sp_status hard_singular(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    sp_status e = hard_start(s, 11, 10, 40, arena);
    for (int k = 0; k < 11 && !e; k++) e = hard_body(s, k ? 2400 : 0, k > 5 ? c->b : 0, 0, k - 0.5, k == 0);
    for (int k = 0; k < 10 && !e; k++) e = hard_bed(s, k, k + 1, 0, 0, k, k % 2 ? c->a / 2 : 0.5, k % 2 ? c->a / 2 : 0.5, 0.6);
    return e;
}

/* A cube whose joint looks up, gravity (a, 0, b). */
static sp_status hard_gravity(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    sp_status e = hard_start(s, 2, 1, 4, arena);
    if (!e) e = hard_body(s, 0, 0, 0, -1, 1);
    if (!e) e = hard_body(s, 2400, 0, 0, 0.5, 0);
    if (e) return e;
    s->gravity[0] = (sp_real)c->a;
    s->gravity[2] = (sp_real)c->b;
    return hard_bed(s, 0, 1, 0, 0, 0, 0.5, 0.5, 0.6);
}

/* A cube under a ceiling that gravity presses it against. */
static sp_status hard_ceiling(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    sp_status e = hard_start(s, 2, 1, 4, arena);
    if (!e) e = hard_body(s, 2400, c->a, 0, -0.5, 0);
    if (!e) e = hard_body(s, 0, 0, 0, 1, 1);
    if (e) return e;
    s->gravity[2] = (sp_real)9.81;
    return hard_bed(s, 0, 1, 0, 0, 0, 0.5, 0.5, 0.6);
}

static sp_status hard_gen(const char *name, const char *n, double a, const char *m, double b, sp_arena *arena, sp_scene *s)
{
    gen_scene g;
    if (!gen_open(&g, name) || gen_set(&g, n, a) != 1 || (m && gen_set(&g, m, b) != 1)) return SP_E_ARGUMENT;
    return gen_build(&g, arena, s);
}
static sp_status hard_arch(const hard_case *c, sp_arena *arena, sp_scene *s) { return hard_gen("arch", "n", c->a, "t", c->b, arena, s); }
static sp_status hard_stack(const hard_case *c, sp_arena *arena, sp_scene *s) { return hard_gen("tower", "n", c->a, "lean", c->b, arena, s); }
static sp_status hard_harmonic(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    return hard_gen("overhang", "n", c->a, "factor", c->b, arena, s);
}
static sp_status hard_keystone(const hard_case *c, sp_arena *arena, sp_scene *s)
{
    return hard_gen("keystone", "angle", c->a, "mu", c->b, arena, s);
}

#ifdef SP_REAL_FLOAT
#define HARD_LEAST 1e-41
#else
#define HARD_LEAST 1e-312
#endif

static const hard_case hard_cases[] = {
    { "cathedral on a pebble", "masses 1e12 apart", SP_STABLE, 0, hard_masses, 1, 1e12, 0 },
    { "pebble on a cathedral", "masses 1e12 apart", SP_STABLE, 0, hard_masses, 1e12, 1, 0 },
    { "pebble falls off a cathedral", "a fall of 1e-12 of all weight", SP_UNSTABLE, 0, hard_masses_off, 1e12, 1, 0.2 },
    { "cathedral falls off a pebble", "the pebble's scale is not the fall's", SP_UNSTABLE, 0, hard_masses_off, 1, 1e12, 0.2 },
    { "10 m cube on a joint of 1e-6 m", "arms of 1e-6 beside 10", SP_STABLE, HARD_NO_FLOAT, hard_edge, 0, 1e-6, 0 },
    { "10 m cube beside a joint of 1e-6 m", "off by its own width", SP_UNSTABLE, HARD_NO_FLOAT, hard_edge, 1e-6, 1e-6, 1 },
    { "joints of 10 m and of 1e-6 m", "edges seven orders apart", SP_STABLE, HARD_NO_FLOAT, hard_edges, 0, 1e-6, 0 },
    { "needle leans half", "height 1e3 x base", SP_STABLE, HARD_LONG | HARD_FORCES_FLOAT, hard_slender, 1e3, 0.5, 0.5 },
    { "needle leans too far", "height 1e3 x base", SP_UNSTABLE, 0, hard_slender, 1e3, 2, 1 },
    { "longer needle leans half", "height 1e4 x base, at the end of double; 5e-5 of its weight topples it", SP_STABLE, HARD_LIMIT, hard_slender, 1e4, 0.5, 0.5 },
    { "longer needle leans too far", "height 1e4 x base", SP_UNSTABLE, 0, hard_slender, 1e4, 2, 1 },
    { "plate on a steep slope", "height 1e-4 x base", SP_STABLE, 0, hard_slender, 1e-2, 0.5, 0.5 },
    { "joint of 64 corners", "many forces, few rows", SP_STABLE, 0, hard_gon, 64, 0.9, 0.1 },
    { "joint of 64 corners, off", "many forces, few rows", SP_UNSTABLE, 0, hard_gon, 64, 1.05, 0.05 },
    { "joint of 512 corners", "many forces, few rows", SP_STABLE, 0, hard_gon, 512, 0.9, 0.1 },
    { "joint of 512 corners, off", "many forces, few rows", SP_UNSTABLE, 0, hard_gon, 512, 1.05, 0.05 },
    { "joint given three times", "dependent columns", SP_STABLE, 0, hard_repeated, 3, 0, 0 },
    { "joint given nearly three times", "columns 1e-9 apart", SP_STABLE, 0, hard_repeated, 3, 1e-9, 0 },
    { "no friction on the level", "a cone that is a ray", SP_STABLE, 0, hard_slope, 0, 0, 0 },
    { "no friction on a slope", "a cone that is a ray", SP_UNSTABLE, 0, hard_slope, 0, 0.01, 0 },
    { "friction 1e-6, slope half of it", "a needle of a cone", SP_STABLE, 0, hard_slope, 1e-6, 5e-7, 0.5 },
    { "friction 1e-6, slope twice it", "a fall of 1e-6", SP_UNSTABLE, 0, hard_slope, 1e-6, 2e-6, 1 },
    { "friction 1000, steep", "a cone that is nearly a half space", SP_STABLE, 0, hard_slope, 1000, 57, 0.94 },
    { "friction 1000, steeper", "topples first", SP_UNSTABLE, 0, hard_slope, 1000, 1500, 0.5 },
    { "on one point", "three free rotations, at rest", SP_STABLE, 0, hard_points, 1, 0, 0 },
    { "beside one point", "three free rotations", SP_UNSTABLE, 0, hard_points, 1, 0.01, 0 },
    { "on an edge", "one free rotation, at rest", SP_STABLE, 0, hard_points, 2, 0, 0 },
    { "beside an edge", "one free rotation", SP_UNSTABLE, 0, hard_points, 2, 0.01, 0 },
    { "collinear corners", "16 on every edge", SP_STABLE, 0, hard_collinear, 16, 0.45, 0.1 },
    { "collinear corners, off", "16 on every edge", SP_UNSTABLE, 0, hard_collinear, 16, 0.55, 0.1 },
    { "harmonic stack at its limit", "every joint at its edge", SP_STABLE, HARD_LIMIT, hard_harmonic, 10, 1, 0 },
    { "harmonic stack below it", "1e-6 inside", SP_STABLE, HARD_BAND_FLOAT, hard_harmonic, 10, 1 - 1e-6, 1e-6 },
    { "harmonic stack beyond it", "1e-6 outside", SP_UNSTABLE, HARD_BAND_FLOAT, hard_harmonic, 10, 1 + 1e-6, 1e-6 },
    { "chain of 1000 cubes", "forces add up", SP_STABLE, HARD_FORCES_FLOAT, hard_stack, 1000, 0, 0 },
    { "leaning chain of 1000 cubes", "arms add up; five times its limit, but of its forces that is little", SP_UNSTABLE, HARD_HEAVY | HARD_INTERIOR | HARD_FINE_FLOAT, hard_stack, 1000, 0.005, 4 },
    { "arch of 1000 stones", "a chain that must bend", SP_STABLE, HARD_HEAVY | HARD_FORCES_FLOAT, hard_arch, 1000, 0.2, 0.86 },
    { "thin arch of 1000 stones", "a chain that must bend", SP_UNSTABLE, HARD_HEAVY | HARD_FORCES_FLOAT, hard_arch, 1000, 0.09, 0.16 },
    { "keystone a hair inside friction", "forces of 1e3 its weight", SP_STABLE, HARD_CAPPED_FLOAT, hard_keystone, 20, 0.36397023426620236 * 1.001, 1e-3 },
    { "keystone a hair outside friction", "only huge forces nearly hold", SP_UNSTABLE, 0, hard_keystone, 20, 0.36397023426620236 * 0.999, 1e-3 },
    { "cubes of 1e-9 m", "units", SP_STABLE, 0, hard_scale_stands, 1e-9, 1, 0.7 },
    { "cubes of 1e9 m", "units", SP_STABLE, 0, hard_scale_stands, 1e9, 1, 0.7 },
    { "cubes of 1e-9 m fall", "units", SP_UNSTABLE, 0, hard_scale_falls, 1e-9, 1e-9, 0.8 },
    { "cubes of 1e9 m fall", "units", SP_UNSTABLE, 0, hard_scale_falls, 1e9, 1e9, 0.8 },
    { "cubes 1e8 m from the origin", "8 digits are gone on reading", SP_STABLE, HARD_NO_FLOAT, hard_offset, 1e8, 0.05, 0.7 },
    { "cubes 1e8 m from the origin fall", "8 digits are gone on reading", SP_UNSTABLE, HARD_NO_FLOAT, hard_offset, 1e8, 0.3, 0.8 },
    { "joints of 1 m and 1e-5 m in turn", "nearly singular normal matrix", SP_STABLE, 0, hard_singular, 1e-5, 0, 0 },
    { "the same, off by a joint", "leaves 1e-5 of the forces; twice its limit, but forces that miss balance by 3e-8 hold it, less than any tol of float", SP_UNSTABLE, HARD_OPEN_FLOAT, hard_singular, 1e-5, 1e-5, 1 },
    { "weights below the normal range", "denormals", SP_STABLE, HARD_DENORMAL, hard_scale_stands, 1, HARD_LEAST, 0.7 },
    { "such weights fall", "denormals", SP_UNSTABLE, HARD_DENORMAL, hard_scale_falls, 1, HARD_LEAST, 0.8 },
    { "gravity sideways", "nothing presses", SP_UNSTABLE, 0, hard_gravity, 9.81, 0, 0 },
    { "gravity aslant", "half of friction", SP_STABLE, 0, hard_gravity, 3, -9.81, 0.49 },
    { "gravity upwards", "it falls up", SP_UNSTABLE, 0, hard_gravity, 0, 9.81, 0 },
    { "on a ceiling, gravity upwards", "it stands up there", SP_STABLE, 0, hard_ceiling, 0.4, 0, 0.2 },
    { "beside a ceiling, gravity upwards", "it tips up there", SP_UNSTABLE, 0, hard_ceiling, 0.6, 0, 0.2 },
};

/* As each is asked, by its flags: in double by default. Float's default calls stable what misses balance by 1e-4. */
static sp_settings hard_settings(unsigned flags)
{
    sp_settings set = sp_settings_default();
    set.localise = 1;
#ifdef SP_REAL_FLOAT
    set.tol = flags & HARD_FINE_FLOAT ? (sp_real)3e-6 : (sp_real)1e-5;
#endif
    (void)flags;
    return set;
}

/* Is this what the row says, as far as forces up to force_bound go? */
static int hard_right(const hard_case *c, const sp_result *r)
{
#ifdef SP_REAL_FLOAT
    if (c->flags & HARD_CAPPED_FLOAT) return r->verdict == SP_UNSTABLE && !r->final && r->force_bound < 1000;
#endif
    return r->verdict == c->truth;
}

enum { HARD_CASES = sizeof hard_cases / sizeof hard_cases[0] };

#endif /* HARD_H */
