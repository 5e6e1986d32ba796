// A block of 1 kg on a fixed slab, pushed over its edge until it falls. Serial shows one verdict a second.
#include <stonepack.h>

static double memory[512];

static sp_verdict ask(sp_real offset)
{
    const sp_real slab[3] = { 0, 0, 0 }, block[3] = { offset, 0, 1 };
    const sp_real left = offset - 1, joint[12] = { left, -1, 0.5, 1, -1, 0.5, 1, 1, 0.5, left, 1, 0.5 };
    const sp_capacity room = { 2, 0, 0, 0, 1, 4 };
    const sp_strength friction = sp_strength_friction(0.6);
    sp_arena arena;
    sp_scene scene;
    sp_result result;
    if (sp_arena_init(&arena, memory, sizeof memory) || sp_scene_create(&scene, &room, &arena) ||
        sp_scene_body(&scene, 0, slab, SP_FIXED, NULL) || sp_scene_body(&scene, 1, block, 0, NULL) ||
        sp_scene_joint(&scene, 0, 1, 4, joint, &friction, NULL) || sp_check(&scene, NULL, &arena, &result))
        return SP_UNDECIDED;
    return result.verdict;
}

void setup() { Serial.begin(115200); }

void loop()
{
    static int step;
    Serial.println(sp_verdict_text(ask((step++ % 20) * 0.1)));
    delay(1000);
}
