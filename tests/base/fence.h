/* A fence behind every piece of memory that is taken of an arena: what is written there is seen when the piece goes. No fence
 * looks as its neighbours: what was read behind one piece and written behind another is seen, too. Built with AddressSanitizer
 * it cannot be read either. To be included before the parts that take. All of it is static. */
#ifndef FENCE_H
#define FENCE_H

#include "../../solvers/base/arena.c"

#include <string.h>

#ifdef __SANITIZE_ADDRESS__
#define FENCED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FENCED 1
#endif
#endif
#ifdef FENCED
#include <sanitizer/asan_interface.h>
#else
#define ASAN_POISON_MEMORY_REGION(p, n) ((void)(p))
#define ASAN_UNPOISON_MEMORY_REGION(p, n) ((void)(p))
#endif

enum { FENCE_WIDTH = 32, FENCE_BYTE = 0xd7, FENCE_MOST = 1024 };

static unsigned char *fence[FENCE_MOST];                /* standing, lowest first */
static int fences, broken, built;

static unsigned char fence_byte(int k) { return (unsigned char)(FENCE_BYTE + k); }

static void fences_down(const unsigned char *from)
{
    while (fences && fence[fences - 1] + FENCE_WIDTH > from) {
        const unsigned char *at = fence[--fences];
        ASAN_UNPOISON_MEMORY_REGION(at, FENCE_WIDTH);
        for (int k = 0; k < FENCE_WIDTH; k++)
            if (at[k] != fence_byte(fences)) { broken++; break; }
    }
}

/* sp__take with a fence behind the piece; counts it on a dry arena too, so sizes and layout still agree. */
static void *fenced_take(sp_arena *a, size_t count, size_t size)
{
    if (size && count > (SIZE_MAX - FENCE_WIDTH) / size) return sp__take(a, count, size);
    unsigned char *piece = sp__take(a, 1, count * size + FENCE_WIDTH);
    if (!piece) return NULL;
    fences_down(piece);
    ASAN_UNPOISON_MEMORY_REGION(piece, count * size + FENCE_WIDTH);
    memset(piece, 0x5b, count * size);                  /* nothing may count on zeros */
    if (fences < FENCE_MOST) {
        fence[fences] = piece + count * size;
        memset(fence[fences], fence_byte(fences), FENCE_WIDTH);
        ASAN_POISON_MEMORY_REGION(fence[fences], FENCE_WIDTH);
        fences++;
        built++;
    }
    return piece;
}

#define sp__take(a, count, size) fenced_take(a, count, size)

#endif /* FENCE_H */
