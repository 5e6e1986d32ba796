/* A scene file or JSON of COMPAS as any text: read, or refused with a line; what is read is checked, its answer verified. */
#include "fuzz.h"
#include "../../port/host/files/scene.h"

static uint64_t room[1 << 17], more[1 << 17];

static void asked(const sp_scene *s)
{
    sp_arena a, scratch;
    sp_settings set = sp_settings_default();
    sp_result r;
    sp_evidence e;
    size_t bytes = 0;
    set.iterations = 300;
    sp_arena_init(&a, room, sizeof room);
    sp_arena_init(&scratch, more, sizeof more);
    if (sp_memory(s, SP_FOR_CHECK, &set, scratch, &bytes) || bytes > a.capacity || sp_check(s, &set, &a, &r)) return;
    for (int32_t k = 0; k < 3 * s->count.points; k++) HOLDS(isfinite(r.f[k]), "f");
    set.tol = r.tol;
    set.force_bound = r.force_bound;
    if (sp_memory(s, SP_FOR_VERIFY, NULL, scratch, &bytes) || bytes > scratch.capacity) return;
    HOLDS(sp_verify(s, &set, &r, scratch, &e) == SP_OK, "verify");
    if (r.verdict) HOLDS(e.verdict == r.verdict, "check %d, verify %d", (int)r.verdict, (int)e.verdict);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const scene_settings plain = scene_settings_default();
    failure why;
    if (size < 1 || size > 4000) return 0;
    char *text = malloc(size + 1);
    if (!text) abort();
    memcpy(text, data, size);
    text[size] = 0;
    memset(&why, 0, sizeof why);
    host_scene s;
    const int status = scene_parse("fuzz", text, size, &plain, &s, &why);
    HOLDS(status == 0 || why.line[0], "status %d without a line", status);
    if (!status && s.scene.count.blocks <= 24 && s.scene.count.points <= 200) asked(&s.scene);
    scene_free(&s);
    return 0;
}
