/* to_obj: what `scene` was asked, as a file that `stonepack check` reads, on stdout.
 *
 *     to_obj FILE
 */
#include "fuzz.h"
#include "../../port/fuzz/bytes.h"
#include "../../port/host/files/obj_write.h"

int main(int argc, char **argv)
{
    static uint64_t room[1 << 16];
    uint8_t data[200];
    sp_arena arena;
    sp_scene scene;
    failure error;
    FILE *in = argc == 2 ? fopen(argv[1], "rb") : NULL;
    if (!in) { fprintf(stderr, "to_obj FILE\n"); return 64; }
    const size_t n = fread(data, 1, sizeof data, in);
    fclose(in);
    sp_arena_init(&arena, room, sizeof room);
    if (n < 2 || sp_scene_from_bytes(data + 2, n - 2, &arena, &scene)) { fprintf(stderr, "%s: no scene\n", argv[1]); return 65; }
    return obj_write(stdout, &scene, NULL, "stdout", &error);
}
