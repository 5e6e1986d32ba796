/* packer: a small packer with a mistake in it, and the property that finds the mistake: what is packed stands.
 *
 *     cc -O2 -ffp-contract=off -I. port/oracle/packer.c stonepack.c -lm -o packer                       a plain loop
 *     clang -O2 -ffp-contract=off -I. -fsanitize=fuzzer -DPACKER_FUZZER port/oracle/packer.c build/libstonepack.a -lm -o packer
 *
 * The fuzzer is to look into the packer: a library that it instruments, too, is five times as slow.
 *
 * The packer keeps boxes side by side and one on another, all in one plane, numbers in mm, and lays each where it comes to
 * lie lowest. It accepts a box whose centre is above what carries it: true for that box alone, and it may tip the one below.
 */
#include "stonepack.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 8, WIDTH = 1200, DEPTH = 400 };           /* boxes; pallet [mm] */

typedef struct wish { int width, height; } wish;
typedef struct box { int left, bottom, width, height; } box;

/* ---------------------------------------------------------------------------------------------------------- the packer */

/* Bottom of a box laid down at `left`; *from, *to: what carries it there. */
static int rest(const box *placed, int count, int left, int width, int *from, int *to)
{
    int bottom = 0;
    *from = left;
    *to = left + width;
    for (int k = 0; k < count; k++) {
        const box *b = &placed[k];
        const int low = b->left > left ? b->left : left, top = b->bottom + b->height;
        const int high = b->left + b->width < left + width ? b->left + b->width : left + width;
        if (low >= high || top < bottom) continue;
        *from = top > bottom || low < *from ? low : *from;
        *to = top > bottom || high > *to ? high : *to;
        bottom = top;
    }
    return bottom;
}

/* Flush with an edge of the pallet or of a box: where does it come to lie lowest?     returns 1, 0: nowhere */
static int find_place(const box *placed, int count, wish w, box *best)
{
    int found = 0;
    for (int k = -1; k < count; k++)
        for (int side = 0; side < 4; side++) {
            const int edge = k < 0 ? side / 2 * WIDTH : placed[k].left + side / 2 * placed[k].width;
            const int left = side % 2 ? edge : edge - w.width;
            int from, to;
            if (left < 0 || left + w.width > WIDTH) continue;
            const box b = { left, rest(placed, count, left, w.width, &from, &to), w.width, w.height };
            if (2 * from > 2 * left + w.width || 2 * to < 2 * left + w.width) continue;     /* the mistake: this box alone */
            if (found && (b.bottom > best->bottom || (b.bottom == best->bottom && b.left >= best->left))) continue;
            *best = b;
            found = 1;
        }
    return found;
}

static int pack(const wish *each, int count, box *placed)
{
    int laid = 0;
    for (int k = 0; k < count; k++) laid += find_place(placed, laid, each[k], &placed[laid]);
    return laid;
}

/* ---------------------------------------------------------------------------------------------------------- the oracle */

static sp_status add_box(sp_scene *scene, const box *b, uint32_t fixed)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
    sp_real xyz[24];
    const sp_mesh mesh = { 8, 6, xyz, size, corner };
    for (int c = 0; c < 8; c++) {
        xyz[3 * c] = (b->left + ((c + 1) / 2 % 2 ? b->width : 0)) / (sp_real)1000;  /* whole mm: what meets does exactly */
        xyz[3 * c + 1] = (c / 2 % 2 ? DEPTH : 0) / (sp_real)1000;
        xyz[3 * c + 2] = (b->bottom + (c < 4 ? 0 : b->height)) / (sp_real)1000;
    }
    return sp_scene_block(scene, &mesh, 500, fixed, NULL);
}

/* Does it stand? UNDECIDED, a tie, is neither a failure of the packer nor of the library. */
static sp_verdict ask(const box *placed, int count)
{
    static uint64_t memory[1 << 17];
    const sp_capacity room = { MOST + 1, 8 * MOST + 8, 6 * MOST + 6, 24 * MOST + 24, 4 * MOST, 16 * MOST, 0 };
    const box pallet = { 0, -100, WIDTH, 100 };
    sp_contact_report found = { 0, 0, 0, 0, NULL };
    sp_arena arena;
    sp_scene scene;
    sp_result result;
    sp_status s = sp_arena_init(&arena, memory, sizeof memory);
    if (!s) s = sp_scene_create(&scene, &room, &arena);
    if (!s) s = add_box(&scene, &pallet, SP_FIXED);
    for (int k = 0; !s && k < count; k++) s = add_box(&scene, &placed[k], 0);
    if (!s) s = sp_contacts_find(&scene, NULL, arena, &found);
    if (!s) s = sp_check(&scene, NULL, &arena, &result);
    if (s) fprintf(stderr, "packer: %s\n", sp_status_text(s));
    return !s && result.verified ? result.verdict : SP_UNDECIDED;
}

static int falls(const wish *each, int count)
{
    box placed[MOST];
    return ask(placed, pack(each, count, placed)) == SP_UNSTABLE;
}

static void print(const wish *each, int count)
{
    box placed[MOST];
    const int laid = pack(each, count, placed);
    for (int k = 0; k < laid; k++)
        printf("  box %d: %d x %d mm at %d, %d\n", k + 1, placed[k].width, placed[k].height, placed[k].left, placed[k].bottom);
}

#ifdef PACKER_FUZZER
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    wish each[MOST];
    int count = 0;
    for (; count < MOST && 2 * (size_t)count + 1 < size; count++) {
        each[count].width = 100 + 3 * data[2 * count];
        each[count].height = 100 + data[2 * count + 1];
    }
    if (falls(each, count)) {
        puts("what was packed falls:");
        print(each, count);
        fflush(stdout);
        abort();
    }
    return 0;
}
#else

/* Fewer boxes, then smaller ones, as long as they fall.     returns how many are left */
static int shrink(wish *each, int count)
{
    for (int k = 0; k < count; k++) {
        wish less[MOST];
        memcpy(less, each, sizeof less);
        memmove(&less[k], &less[k + 1], (size_t)(count - k - 1) * sizeof *less);
        if (!falls(less, count - 1)) continue;
        memcpy(each, less, sizeof less);
        count--;
        k = -1;
    }
    for (int k = 0; k < 2 * count; k++)
        for (int step = 400; step > 0; step /= 2) {
            int *number = k % 2 ? &each[k / 2].height : &each[k / 2].width;
            *number -= step;
            if (*number < 100 || !falls(each, count)) *number += step;
        }
    return count;
}

int main(void)
{
    uint64_t seed = 1;
    for (int turn = 1; turn <= 100000; turn++) {
        wish each[MOST];
        for (int k = 0; k < 2 * MOST; k++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            const int number = (int)(seed >> 40 & 0xffff);
            if (k % 2) each[k / 2].height = 100 + number % 400; else each[k / 2].width = 100 + number % 800;
        }
        if (!falls(each, MOST)) continue;
        const int count = shrink(each, MOST);
        printf("what was packed falls, found at turn %d; the fewest boxes:\n", turn);
        print(each, count);
        return 1;
    }
    return 0;
}
#endif
