/* regions: scene and answer in one memory, all that a check works on, the factor above all, in another.
 *
 * Linker scripts put `.fast` into a RAM region of its own where the board has one (FAST in the memory maps). sp_memory tells
 * how much goes there (SP_FOR_WORK), and how much stays (SP_FOR_CHECK); SP_MEMORY_BYTES bounds either. The same check in one memory finds the same bits.
 */
#include "../../tests/scenes/gen.h"
#include "board.h"

#include <string.h>

#define BLOCKS 12
#define JOINTS 24
#define POINTS (4 * JOINTS)

__attribute__((section(".fast"))) static uint64_t fast[SP_MEMORY_BYTES(BLOCKS, JOINTS, POINTS, 0) / 8];
static uint64_t large[(64u << 10) / 8], other[sizeof large / 8];

/* A wall of ten, checked with its work in `work`, or all in one where that is NULL. */
static sp_status stands(void *memory, sp_arena *work, sp_result *r, size_t *stays, size_t *goes)
{
    gen_scene g;
    sp_arena arena;
    sp_scene scene;
    sp_settings set = sp_settings_default();
    gen_open(&g, "wall");
    gen_set(&g, "rows", 3), gen_set(&g, "bricks", 3);
    sp_status status = sp_arena_init(&arena, memory, sizeof large);
    if (!status) status = gen_build(&g, &arena, &scene);
    set.work = work;
    const size_t before = arena.used;
    if (!status) status = sp_memory(&scene, SP_FOR_CHECK, &set, arena, stays);
    if (!status) status = sp_memory(&scene, SP_FOR_WORK, &set, arena, goes);
    if (!status) status = sp_check(&scene, &set, &arena, r);
    return !status && r->spent.peak_bytes - before != *stays ? SP_E_MEMORY : status;
}

int main(void)
{
    sp_arena work;
    sp_result apart, one;
    size_t stays, goes, all, none;
    sp_arena_init(&work, fast, sizeof fast);
    const sp_status status = stands(large, &work, &apart, &stays, &goes), again = stands(other, NULL, &one, &all, &none);
    if (status || again) { board_print("%s, %s\n", sp_status_text(status), sp_status_text(again)); return 1; }
    const int same = apart.verdict == one.verdict && !memcmp(apart.f, one.f, 3 * (size_t)one.counts.points * sizeof *one.f);
    board_print("%s: %u bytes at %lx, %u at %lx; in one: %u, %s\n", sp_verdict_text(apart.verdict), (unsigned)stays,
                (unsigned long)(uintptr_t)large, (unsigned)goes, (unsigned long)(uintptr_t)fast, (unsigned)all,
                same ? "the same bits" : "other bits");
    return !same || work.peak != goes;
}
