/* Any bytes make a small scene that is valid: for fuzzers of whatever sits on top of stonepack.
 *
 *     int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
 *     {
 *         static uint64_t memory[1 << 15];
 *         sp_arena arena;
 *         sp_scene scene;
 *         sp_arena_init(&arena, memory, sizeof memory);
 *         if (sp_scene_from_bytes(data, size, &arena, &scene)) return 0;
 *         ...
 *
 * The scene has 2 to 6 boxes and frusta, mostly stacked, on one support or more; contacts found, friction, now and then
 * strength; up to two loads, some of them live; gravity down or aslant. The same bytes make the same scene, few bytes a simple
 * one: what is missing counts as 0. Needs stonepack.h and bytes.c, no other file.
 */
#ifndef STONEPACK_FUZZ_BYTES_H
#define STONEPACK_FUZZ_BYTES_H

#include "../../stonepack.h"

enum { SP_FUZZ_BLOCKS = 6, SP_FUZZ_LOADS = 2 };

#ifdef __cplusplus
extern "C" {
#endif

/* The scene lives in the arena, of which 128 KiB are enough; contacts are found in what is left of it.
 *   returns   SP_OK, SP_E_MEMORY, SP_E_CAPACITY (more contacts than it has room for) */
sp_status sp_scene_from_bytes(const uint8_t *bytes, size_t count, sp_arena *arena, sp_scene *scene);

/* Its inverse: bytes of which sp_scene_from_bytes makes the same blocks, loads and gravity to the bit, and finds joints anew, of
 * the strength of the first one. So a scene written by hand, in eighths of a metre, becomes a seed of a corpus.
 *   returns   how many bytes; 0: it is not of this form, or SP_FUZZ_BYTES bytes may be needed and `room` is less */
enum { SP_FUZZ_BYTES = 1 + 13 * SP_FUZZ_BLOCKS + 4 + 12 * SP_FUZZ_LOADS };
size_t sp_scene_to_bytes(const sp_scene *scene, uint8_t *bytes, size_t room);

#ifdef __cplusplus
}
#endif

#endif
