/* arena: memory handed out by offsets from an aligned base.
 *
 * Every object of the library has one carving function that takes its pieces from an arena. Run on a dry arena (no base,
 * unlimited capacity) it counts, run on a real one it places; so size and layout cannot disagree. A piece that does not fit
 * latches the arena as failed: later pieces fail too and `used` stays what it was.
 */
#ifndef SP__ARENA_C
#define SP__ARENA_C

#include "config.c"

SP_API sp_status sp_arena_init(sp_arena *arena, void *memory, size_t bytes)
{
    if (!arena || !memory) return SP_E_ARGUMENT;
    const size_t lost = (size_t)(-(uintptr_t)memory & (SP_ALIGN - 1));
    if (bytes <= lost) return SP_E_MEMORY;
    arena->base = (unsigned char *)memory + lost;
    arena->capacity = bytes - lost;
    arena->used = arena->peak = 0;
    return SP_OK;
}

/* An arena that only counts. */
SP__NOINLINE_SMALL static sp_arena sp__arena_dry(void)
{
    sp_arena a = { NULL, SIZE_MAX - SP_ALIGN, 0, 0 };
    return a;
}

/* `count` pieces of `size` bytes, aligned; NULL on a dry arena or when they do not fit (then the arena is failed). */
static void *sp__take(sp_arena *a, size_t count, size_t size)
{
    const size_t from = (a->used + (SP_ALIGN - 1)) & ~(size_t)(SP_ALIGN - 1);
    if (from < a->used || from > a->capacity || (size && count > (a->capacity - from) / size)) {
        a->capacity = 0;                                /* failed: nothing fits any more */
        return NULL;
    }
    a->used = from + count * size;
    if (a->used > a->peak) a->peak = a->used;
    return a->base ? a->base + from : NULL;
}

static int sp__failed(const sp_arena *a) { return a->capacity == 0; }

#endif /* SP__ARENA_C */
