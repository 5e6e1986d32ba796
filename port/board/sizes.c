/* sizes: what a controller needs for so many stones: bytes of arena for each question, and the most that a check took while the
 * scene was tilted towards its limit, in instructions and in flops, for which settings.budget is a bound that nothing passes. */
#include "../../tests/scenes/gen.h"
#include "board.h"

typedef struct family { const char *name; struct { const char *set[2]; int value[2]; } size[5]; } family;

static const family families[] = {
    { "arch", { { { "n", NULL }, { 8, 0 } }, { { "n", NULL }, { 16, 0 } }, { { "n", NULL }, { 24, 0 } }, { { "n", NULL }, { 40, 0 } },
                { { "n", NULL }, { 60, 0 } } } },
    { "wall", { { { "rows", "bricks" }, { 3, 2 } }, { { "rows", "bricks" }, { 4, 4 } }, { { "rows", "bricks" }, { 5, 4 } },
                { { "rows", "bricks" }, { 7, 5 } }, { { "rows", "bricks" }, { 9, 6 } } } },
    { "rubble", { { { "rows", "bricks" }, { 3, 2 } }, { { "rows", "bricks" }, { 4, 4 } }, { { "rows", "bricks" }, { 5, 4 } },
                  { { "rows", "bricks" }, { 7, 5 } }, { { "rows", "bricks" }, { 9, 6 } } } }
};
enum { FAMILIES = sizeof families / sizeof families[0], SIZES = 5, HALVINGS = 8 };

static uint64_t memory[(sizeof(sp_real) == 4 ? 3u << 19 : 3u << 20) / 8];

static sp_status build(int f, int n, double tilt, double azimuth, sp_arena *arena, sp_scene *scene)
{
    const family *const of = &families[f];
    gen_scene g;
    if (!gen_open(&g, of->name)) return SP_E_ARGUMENT;
    for (int k = 0; k < 2 && of->size[n].set[k]; k++) gen_set(&g, of->size[n].set[k], of->size[n].value[k]);
    gen_set(&g, "tilt", tilt);
    gen_set(&g, "azimuth", azimuth);
    sp_arena_init(arena, memory, sizeof memory);
    return gen_build(&g, arena, scene);
}

typedef struct most { uint64_t instructions; int64_t flops; int undecided; } most;

static sp_verdict check(int f, int n, double tilt, double azimuth, most *m)
{
    sp_arena arena;
    sp_scene scene;
    sp_result r;
    sp_settings set = sp_settings_default();
    if (sizeof(sp_real) == 4) set.tol = (sp_real)1e-4;
    if (build(f, n, tilt, azimuth, &arena, &scene)) return SP_UNDECIDED;
    const uint64_t from = board_instructions();
    if (sp_check(&scene, &set, &arena, &r)) return SP_UNDECIDED;
    const uint64_t work = board_instructions() - from;
    if (work > m->instructions) m->instructions = work;
    if (r.spent.total.flops > m->flops) m->flops = r.spent.total.flops;
    m->undecided += r.verdict == SP_UNDECIDED;
    return r.verdict;
}

/* Tilted by as much as it just stands, found by halving: the nearer to the limit, the harder. */
static void lean(int f, int n, double azimuth, most *m)
{
    double stands = 0, falls = 45;
    check(f, n, stands, azimuth, m);
    check(f, n, falls, azimuth, m);
    for (int k = 0; k < HALVINGS; k++) {
        const double between = (stands + falls) / 2;
        if (check(f, n, between, azimuth, m) == SP_STABLE) stands = between;
        else falls = between;
    }
}

static unsigned long needs(const sp_scene *s, sp_memory_for what, sp_arena scratch)
{
    size_t bytes = 0;
    return sp_memory(s, what, NULL, scratch, &bytes) ? 0 : (unsigned long)bytes;
}

static int stones(const sp_scene *s)
{
    int n = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) n += s->block[b].fixed != SP_FIXED;
    return n;
}

static void row(int f, int n)
{
    static const double along[] = { 0, 90, 30 };
    sp_arena arena;
    sp_scene s;
    most m = { 0, 0, 0 };
    if (build(f, n, 0, 0, &arena, &s)) return;
    const unsigned long scene = (unsigned long)arena.used, asked = needs(&s, SP_FOR_CHECK, arena),
                        limit = needs(&s, SP_FOR_LIMIT, arena), steps = needs(&s, SP_FOR_SEQUENCE, arena);
    const int free_stones = stones(&s), joints = s.count.joints, corners = s.count.points;
    for (unsigned k = 0; k < sizeof along / sizeof along[0]; k++) lean(f, n, along[k], &m);
    board_print("%-7s %6d %6d %7d %8lu %8lu %8lu %8lu %11lu %10lu %9d\n", families[f].name, free_stones, joints, corners, scene, asked,
                limit, steps, (unsigned long)(m.instructions / 1000), (unsigned long)(m.flops / 1000), m.undecided);
}

int main(void)
{
    board_print("%-7s %6s %6s %7s %8s %8s %8s %8s %11s %10s %9s\n", "family", "stones", "joints", "corners", "scene B", "check B",
                "limit B", "steps B", "1000 insn", "1000 flops", "undecided");
    for (int f = 0; f < FAMILIES; f++)
        for (int n = 0; n < SIZES; n++) row(f, n);
    return 0;
}
