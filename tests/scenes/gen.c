/* gen: assemblies made by formula: the table of all of them, and the calls. How each is made is in gen_stacks.h, gen_arches.h,
 * gen_walls.h and gen_vaults.h, and of what in gen_solids.h.
 *
 * Most scenes are drawn in the x-z plane, x to the right and z up, and extruded along y. Polygons run anticlockwise seen
 * from -y. Lengths in m, angles in degrees.
 */
#include "gen_stacks.h"
#include "gen_vaults.h"

#define END { NULL, 0, 0, 0, NULL }

const gen_param gen_common[] = {
    { "mu",      0.84,    0, 1e9, "friction coefficient" },
    { "density", 2400, 1e-9, 1e9, "kg/m^3" },
    { "tilt",    0,     -90,  90, "the world turned, degrees" },
    { "azimuth", 0,    -360, 360, "towards this direction, degrees from x to y" },
    END
};

const gen_entry gen_table[] = {
    { "two-cubes", "a cube on a fixed one", two_cubes, {
        { "offset", 0.3, -0.99, 0.99, "of the upper one along x, m; falls beyond 0.5" }, END } },
    { "incline", "a block on a slope; slides when tan(angle) > mu", incline, {
        { "angle", 20, -80, 80, "of the slope, degrees" },
        { "turn", 0, -360, 360, "of the slope against the joint's first edge, degrees" },
        { "height", 0.2, 1e-3, 10, "of the unit block, m" }, END } },
    { "topple", "a tall block on a slope; topples when tan(angle) > base / height", topple, {
        { "base", 0.25, 1e-3, 100, "m" }, { "height", 1, 1e-3, 100, "m" }, { "angle", 13, -80, 80, "degrees" }, END } },
    { "overhang", "the harmonic stack over a table's edge; falls when factor > 1", overhang, {
        { "n", 5, 1, 200, "boards of length 1" }, { "factor", 0.95, 0, 1.5, "of the harmonic offsets" },
        { "shift", 0, -0.5, 0.5, "of the whole stack, m" }, { "height", 0.2, 1e-3, 10, "of a board, m" }, END } },
    { "cantilever", "a beam held down by a weight on its tail", cantilever, {
        { "reach", 1.2, 0, 1.6, "beyond the support, m, of 2 m" }, { "weight", 0.3, 1e-3, 100, "height of the weight, m" }, END } },
    { "tower", "a leaning stack of cubes; falls when lean > 1 / (n + 1)", tower, {
        { "n", 10, 1, 1000, "cubes" }, { "lean", 0.08, 0, 0.9, "each beyond the one below, m" }, END } },
    { "diamond", "rows of 1, 2 .. m .. 2, 1 boards; m = 5 needs mu .2813, 6 needs .5396", diamond, {
        { "rows", 5, 1, 60, "m, boards in the longest row" }, { "height", 0.3, 1e-3, 10, "of a board, m" }, END } },
    { "inverted-triangle", "rows of 1, 2 .. m boards; stands only to m = 2", inverted_triangle, {
        { "rows", 3, 1, 60, "m" }, { "height", 0.3, 1e-3, 10, "of a board, m" }, END } },
    { "arch", "a ring of voussoirs with straight sides", arch, {
        { "n", 20, 2, 2000, "voussoirs" }, { "t", 0.12, 1e-4, 1.9, "thickness / mean radius" }, { "radius", 1, 1e-3, 1e6, "mean, m" },
        { "half", 90, 1, 170, "half angle of embrace, degrees" }, { "ends", 0, 0, 1, "1: the end voussoirs are the supports" },
        { "depth", 0.5, 1e-3, 1e6, "m" }, { "facets", 1, 1, GEN_FACETS, "chords of each inside and outside" }, END } },
    { "flat-arch", "wedges under a level top", flat_arch, {
        { "n", 9, 1, 500, "wedges" }, { "span", 2, 1e-3, 1e6, "m, below" }, { "height", 0.4, 1e-3, 1e6, "m" },
        { "half", 25, 0, 60, "lean of the outer joints, degrees" }, { "depth", 0.4, 1e-3, 1e6, "m" }, END } },
    { "keystone", "one wedge between supports; stands iff mu >= tan(angle)", keystone, {
        { "angle", 20, -60, 60, "of its sides from upright, wider below for > 0, degrees" }, { "width", 1, 1e-3, 1e6, "at mid height, m" },
        { "height", 0.5, 1e-3, 1e6, "m" }, { "depth", 0.5, 1e-3, 1e6, "m" }, END } },
    { "h-model", "a beam held between two posts by friction alone", h_model, { END } },
    { "wall", "running bond, odd courses end in half bricks", wall, {
        { "rows", 8, 1, 500, "" }, { "bricks", 8, 1, 200, "per course" }, { "length", 0.4, 1e-6, 1e6, "of a brick, m" },
        { "height", 0.2, 1e-6, 1e6, "of a course, m" }, { "depth", 0.2, 1e-6, 1e6, "m" }, { "seed", 1, 0, 1e9, "" },
        { "jitter", 0, 0, 0.49, "of the head joints, of half a brick" },
        { "size", 0, 0, 1e4, "instead of rows and bricks: 54 95 147 500 2000 10000 interfaces or so" }, END } },
    { "rubble", "irregular polygonal stones that fit exactly", rubble, {
        { "rows", 6, 1, 500, "" }, { "bricks", 6, 1, 120, "per course" }, { "length", 0.5, 1e-6, 1e6, "mean, m" },
        { "height", 0.25, 1e-6, 1e6, "mean, m" }, { "depth", 0.4, 1e-6, 1e6, "m" }, { "seed", 1, 0, 1e9, "" },
        { "jitter", 0.5, 0, 1, "of all corners" },
        { "count", 0, 0, 5000, "loose stones in the air instead, for settle" }, END } },
    { "vault", "a barrel in running bond", vault, {
        { "around", 13, 2, 400, "courses" }, { "n", 5, 1, 200, "stones along a course" }, { "t", 0.15, 1e-3, 1.9, "thickness / mean radius" },
        { "radius", 1, 1e-3, 1e6, "mean, m" }, { "half", 90, 1, 170, "half angle of embrace, degrees" },
        { "length", 2, 1e-3, 1e6, "m" }, { "seed", 1, 0, 1e9, "" }, { "jitter", 0, 0, 0.49, "of the cross joints" }, END } },
    { "dome", "rings of stones from the springing to an oculus", dome, {
        { "rings", 8, 1, 200, "" }, { "segments", 16, 3, 128, "stones of a ring" }, { "t", 0.1, 1e-3, 1.9, "thickness / mean radius" },
        { "radius", 1, 1e-3, 1e6, "mean, m" }, { "foot", 90, 10, 120, "springing, degrees from the zenith" },
        { "eye", 12, 1, 80, "oculus, degrees from the zenith" }, END } },
    { NULL, NULL, NULL, { END } }
};

/* ---------------------------------------------------------------------------------------------------------------- calls */

static int same(const char *a, const char *b)
{
    while (*a && *a == *b) a++, b++;
    return *a == *b;
}

int gen_open(gen_scene *g, const char *name)
{
    for (const gen_entry *e = gen_table; e->name; e++)
        if (same(e->name, name)) {
            g->entry = e;
            for (int k = 0; k < GEN_OWN; k++) g->value[k] = 0;
            for (int k = 0; k < GEN_OWN && e->param[k].name; k++) g->value[k] = e->param[k].value;
            for (int k = 0; k < GEN_COMMON; k++) g->value[GEN_OWN + k] = gen_common[k].value;
            return 1;
        }
    return 0;
}

int gen_counts(const char *name)
{
    static const char *const whole[] = {
        "n", "rows", "bricks", "seed", "size", "count", "around", "rings", "segments", "ends", "facets"
    };
    for (size_t k = 0; k < sizeof whole / sizeof *whole; k++) if (same(name, whole[k])) return 1;
    return 0;
}

int gen_set(gen_scene *g, const char *name, double value)
{
    for (int k = 0; k < GEN_OWN + GEN_COMMON; k++) {
        const gen_param *p = k < GEN_OWN ? &g->entry->param[k] : &gen_common[k - GEN_OWN];
        if (!p->name) {
            k = GEN_OWN - 1;
            continue;
        }
        if (!same(p->name, name)) continue;
        if (!(value >= p->low && value <= p->high)) return -1;
        g->value[k] = value;
        return 1;
    }
    return 0;
}

static gen_sink start(const gen_scene *g, sp_scene *scene)
{
    gen_sink s = { scene, { 0, 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, 0 }, g->value[GEN_OWN + 1], SP_OK, 1 };
    s.strength.mu = (sp_real)g->value[GEN_OWN];
    return s;
}

sp_status gen_capacity(const gen_scene *g, sp_capacity *cap)
{
    gen_sink s = start(g, NULL);
    g->entry->emit(&s, g->value);
    *cap = s.count;
    return SP_OK;
}

void gen_gravity(double tilt, double azimuth, sp_real gravity[3])
{
    const double g = 9.80665;
    gravity[0] = (sp_real)(g * gen_sin(rad(tilt)) * gen_cos(rad(azimuth)));
    gravity[1] = (sp_real)(g * gen_sin(rad(tilt)) * gen_sin(rad(azimuth)));
    gravity[2] = (sp_real)(-g * gen_cos(rad(tilt)));
}

sp_status gen_build(const gen_scene *g, sp_arena *arena, sp_scene *scene)
{
    sp_capacity cap;
    sp_status status = gen_capacity(g, &cap);
    if (status) return status;
    status = sp_scene_create(scene, &cap, arena);
    if (status) return status;
    gen_sink s = start(g, scene);
    g->entry->emit(&s, g->value);
    gen_gravity(g->value[GEN_OWN + 2], g->value[GEN_OWN + 3], scene->gravity);
    return s.status;
}

sp_status gen_make(const char *name, const char *param, double value, sp_arena *arena, sp_scene *scene)
{
    gen_scene g;
    if (gen_open(&g, name) != 1 || (param && gen_set(&g, param, value) != 1)) return SP_E_ARGUMENT;
    return gen_build(&g, arena, scene);
}

/* ------------------------------------------------------------------------------------------------------ sine and cosine */

/* sin and cos by their series on |r| <= pi/4, r = x - k pi/2 with pi/2 in two parts: C libraries differ in the last bit, this
 * does not. For |x| up to some hundred turns. */
static void turned(double x, double *sine, double *cosine)
{
    const double k = floor(x * (2 / gen_pi) + 0.5), r = (x - k * 1.57079632673412561417) - k * 6.07710050650619224932e-11, q = r * r;
    double s = 0, c = 0;
    for (int i = 17; i >= 3; i -= 2) s = q / (i * (i - 1)) * (1 - s);       /* sin r = r (1 - q/6 (1 - q/20 (1 - ... */
    for (int i = 18; i >= 2; i -= 2) c = q / (i * (i - 1)) * (1 - c);       /* cos r = 1 - q/2 (1 - q/12 (1 - ... */
    s = r - r * s;
    c = 1 - c;
    const int quarter = (int)k & 3;
    *sine = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
    *cosine = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
}

double gen_sin(double x)
{
    double s, c;
    turned(x, &s, &c);
    return s;
}

double gen_cos(double x)
{
    double s, c;
    turned(x, &s, &c);
    return c;
}
