/* cost: verdicts on a board and what they cost: bytes of arena, instructions, depth of the stack, by stage and tol. */
#include "../../tests/scenes/gen.h"
#include "board.h"

#include <string.h>

typedef struct scene_entry { const char *title, *name; struct { const char *name; double value; } set[2]; } scene_entry;

static const scene_entry scenes[] = {
    { "wall of 10", "wall", { { "rows", 3 }, { "bricks", 3 } } },
    { "wall of 10, leaning", "wall", { { "rows", 3 }, { "tilt", 20 } } },
    { "arch of 11", "arch", { { "n", 11 }, { NULL, 0 } } },
    { "arch of 11, thin", "arch", { { "n", 11 }, { "t", 0.1 } } },
    { "wall of 26", "wall", { { "size", 54 }, { NULL, 0 } } }
};

static const struct { const char *name; int32_t count; sp_stage_id stage[2]; } ladders[] = {
    { "exact", 2, { SP_STAGE_GATES, SP_STAGE_EXACT } },
    { "least squares", 1, { SP_STAGE_LEAST_SQUARES } },
    { "dense", 1, { SP_STAGE_DENSE } },
    { "polish", 1, { SP_STAGE_POLISH } }
};

static uint64_t memory[(2u << 20) / 8];

static sp_status build(const scene_entry *e, sp_arena *arena, sp_scene *scene)
{
    gen_scene g;
    if (!gen_open(&g, e->name)) return SP_E_ARGUMENT;
    for (int k = 0; k < 2 && e->set[k].name; k++) gen_set(&g, e->set[k].name, e->set[k].value);
    if (!strcmp(e->name, "wall") && !strcmp(e->set[0].name, "rows")) gen_set(&g, "bricks", 3), gen_set(&g, "azimuth", 90);
    sp_arena_init(arena, memory, sizeof memory);
    return gen_build(&g, arena, scene);
}

static void row(const scene_entry *e, int l, double tol)
{
    sp_arena arena;
    sp_scene scene;
    sp_result r;
    sp_settings set = sp_settings_default();
    sp_status status = build(e, &arena, &scene);
    const size_t taken = arena.used;
    set.stage_count = ladders[l].count;
    memcpy(set.stage, ladders[l].stage, sizeof ladders[l].stage);
    set.tol = (sp_real)tol;
    board_paint();
    const uint64_t from = board_instructions();
    if (!status) status = sp_check(&scene, &set, &arena, &r);
    const uint64_t work = board_instructions() - from;
    if (status) {
        board_print("%-20s %s\n", e->title, sp_status_text(status));
        return;
    }
    board_print("%-20s %-14s %.0e  %-10s %9lu %8lu %8lu %6u\n", e->title, ladders[l].name, tol, sp_verdict_text(r.verdict),
                (unsigned long)(work / 1000), (unsigned long)taken, (unsigned long)(r.spent.peak_bytes - taken), board_depth());
}

int main(void)
{
    static const double tols[] = { 1e-3, 1e-4, 1e-6, 1e-9 };
    board_print("%-20s %-14s %-6s %-10s %9s %8s %8s %6s\n",
                "scene", "stage", "tol", "verdict", "1000 insn", "scene B", "check B", "stack B");
    for (size_t s = 0; s < sizeof scenes / sizeof scenes[0]; s++)
        for (int l = 0; l < 4; l++)
            for (int t = 0; t < (sizeof(sp_real) == 4 ? 2 : 4); t++)
                if (l == 0 || t == (sizeof(sp_real) == 4 ? 1 : 3)) row(&scenes[s], l, tols[t]);
    return 0;
}
