/* A scene file or JSON of COMPAS as any text: read, or refused with a line; what is read is checked, its answer verified.
 *
 * Every other text is read as it is, the others with options of the program that all its bytes draw: contacts found, friction,
 * supports, where is down, units, how near faces touch, shells split. What stands behind a line `#beside` is the file beside
 * the model; both are then files in /tmp, gone at the end. */
#include "draws.h"
#include "../../port/host/files/scene.h"

#include <unistd.h>

static uint64_t room[1 << 17], more[1 << 17];

static void asked(const host_scene *h)
{
    const sp_scene *s = &h->scene;
    sp_arena a, scratch;
    sp_settings set = sp_settings_default();
    sp_result r;
    sp_evidence e;
    size_t bytes = 0;
    failure why;
    set.iterations = 300;
    FORGET(room, sizeof room);
    FORGET(more, sizeof more);
    sp_arena_init(&a, room, sizeof room);
    sp_arena_init(&scratch, more, sizeof more);
    if (sp_memory(s, SP_FOR_CHECK, &set, scratch, &bytes) || bytes > a.capacity) return;
    const sp_status status = sp_check(s, &set, &a, &r);
    memset(&why, 0, sizeof why);
    if (status) HOLDS(scene_refused(h, &set, status, &why) && why.line[0], "status %d without a line", (int)status);
    if (status) return;
    for (int32_t k = 0; k < 3 * s->count.points; k++) HOLDS(isfinite(r.f[k]), "f");
    set.tol = r.tol;
    set.force_bound = r.force_bound;
    if (sp_memory(s, SP_FOR_VERIFY, NULL, scratch, &bytes) || bytes > scratch.capacity) return;
    HOLDS(sp_verify(s, &set, &r, scratch, &e) == SP_OK, "verify");
    if (r.verdict) HOLDS(e.verdict == r.verdict, "check %d, verify %d", (int)r.verdict, (int)e.verdict);
}

/* ------------------------------------------------------------------------------------------------------------- options */

static text_word one_of(const char *const *word, uint32_t count)
{
    const char *w = word[draw(count)];
    const text_word out = { w, strlen(w) };
    return out;
}

static void amended(amendments *a)
{
    static const char *const list[8] = { "lowest", "ground", "*", "b0", "b*,-b1", "b0 b1", "none", "?*" };
    static const char *const axis[6] = { "x", "y", "z", "-x", "-y", "-z" }, *const unit[4] = { "mm", "cm", "m", "in" };
    static const char *const near[6] = { "0.0005", "0.05%", "0", "1%", "50%", "0.2" };
    static const char *const angle[4] = { "0", "0.1", "5", "30" };
    for (uint32_t k = draw(3); k > 0; k--) a->fixed[a->lists++] = list[draw(8)];
    if (!draw(3)) a->turn = units_read_axis(one_of(axis, 6), a->up);
    else if (!draw(3)) {
        a->pull = 1;
        for (int k = 0; k < 3; k++) a->gravity[k] = (sp_real)draw(41) / 2 - 10;
    }
    if (!draw(3)) units_read_length(one_of(unit, 4), &a->unit);
    if (!draw(3)) touching_read_distance(one_of(near, 6), &a->contact);
    if (!draw(3)) touching_read_angle(one_of(angle, 4), &a->contact);
    a->split = !draw(3);
}

static scene_settings options(void)
{
    static const double mu[5] = { -1, 0, 0.5, 1e-9, 10 };
    scene_settings set = scene_settings_default();
    if (draw(2)) return set;
    set.mu = (sp_real)mu[draw(5)];
    set.contacts = draw(2) ? SCENE_FIND : SCENE_GIVEN;
    amended(&set.amend);
    return set;
}

/* ------------------------------------------------------------------------------------------------------------- reading */

static void into_file(const char *path, const char *text, size_t length)
{
    FILE *out = fopen(path, "wb");
    if (!out || fwrite(text, 1, length, out) != length || fclose(out)) abort();
}

/* A model and what stands beside it, as files. */
static int two_files(const char *text, size_t size, const char *beside, const scene_settings *set, host_scene *s, failure *why)
{
    char path[64], other[80];
    const char *next = beside + strlen("\n#beside\n");
    snprintf(path, sizeof path, "/tmp/stonepack-fuzz-%ld.obj", (long)getpid());
    snprintf(other, sizeof other, "%s%s", path, OBJ_BESIDE);
    into_file(path, text, (size_t)(beside - text) + 1);
    into_file(other, next, (size_t)(text + size - next));
    const int status = scene_read(path, set, s, why);
    unlink(path);
    unlink(other);
    return status;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    failure why;
    host_scene s;
    if (size < 1 || size > 4000) return 0;
    draws_of(data, size);
    const scene_settings set = options();
    char *text = malloc(size + 1);
    if (!text) abort();
    memcpy(text, data, size);
    text[size] = 0;
    memset(&why, 0, sizeof why);
    const char *beside = strstr(text, "\n#beside\n");
    const int status = beside ? two_files(text, size, beside, &set, &s, &why) : scene_parse("fuzz", text, size, &set, &s, &why);
    if (beside) free(text);                             /* else the scene's */
    HOLDS(status == 0 || why.line[0], "status %d without a line", status);
    if (!status && s.scene.count.blocks <= 24 && s.scene.count.points <= 200) asked(&s);
    scene_free(&s);
    return 0;
}
