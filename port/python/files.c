/* Scene files, pictures and answers of the program for other languages: what `convert` reads and writes, what `check --svg` draws
 * and `check --json --forces` tells.
 *
 * A shared library over the other one. Strings, structs of stonepack.h and a handle cross, no struct of the program. */
#include "../host/command/report.h"
#include "../host/files/drawn.h"
#include "../host/files/file.h"
#include "../host/files/obj_write.h"
#include "../host/files/scene.h"
#include "../host/picture/svg.h"

#include <stdlib.h>
#include <string.h>

#define FILES_API __attribute__((visibility("default")))

/* A scene that is read: what was asked, what came of it, what went wrong. */
typedef struct files_scene {
    scene_settings set;
    host_scene scene;
    failure error;
} files_scene;

/* An empty one, or NULL. Free it with files_free. */
FILES_API files_scene *files_new(void);

/* What is told beside the file, as options of the program: fixed LIST, up AXIS, unit NAME, contact-distance D,
 * contact-angle DEG, mu X, gravity-x, gravity-y, gravity-z X, split "". value must live until files_read.
 *   returns   1, 0: not understood */
FILES_API int files_option(files_scene *f, const char *name, const char *value);

/* Read a file, or text in memory if there is one (copied).     returns 0, else files_error tells */
FILES_API int files_read(files_scene *f, const char *path, const char *text, size_t length);

FILES_API const char *files_error(const files_scene *f);
FILES_API const sp_scene *files_parts(const files_scene *f);
FILES_API const char *files_name(const files_scene *f, int32_t block);
FILES_API const char *files_remark(const files_scene *f, int32_t k);       /* NULL: there are fewer */

/* Where its joints were found, not given: 1, how, and the blocks inside each other; else 0. */
FILES_API int files_found(const files_scene *f, sp_contact_settings *how, int32_t *overlaps, const sp_overlap **overlap);
FILES_API double files_mu(const files_scene *f);
FILES_API double files_density(const files_scene *f);
FILES_API void files_free(files_scene *f);

/* Write a scene as a file that reads back as the same; draw one with the result of a check, of a limit as well (else NULL).
 *   message   room for 512 bytes
 *   returns   0, else message tells */
FILES_API int files_write(const char *path, const sp_scene *scene, const char *const *name, char *message);
FILES_API int files_draw(const char *path, const sp_scene *scene, const char **name, const char *title, const sp_result *result,
                         const sp_limit_result *limit, int names, char *message);

/* Write the answer of a check, with all forces, as `stonepack verify` reads it; path_of_scene is for whoever reads it.
 *   cone      "true", "8i" ...; settings: as they were asked
 *   returns   0, else message tells */
FILES_API int files_json(const char *path, const sp_scene *scene, const char **name, const char *path_of_scene,
                         const sp_result *result, const sp_settings *settings, const char *cone, char *message);

files_scene *files_new(void)
{
    files_scene *f = calloc(1, sizeof *f);
    if (f) f->set = scene_settings_default();
    return f;
}

static text_word word_of(const char *s)
{
    const text_word w = { s, strlen(s) };
    return w;
}

static int take_gravity(amendments *a, int k, text_word w)
{
    a->pull = 1;
    return text_real(w, &a->gravity[k]) == TEXT_NUMBER;
}

int files_option(files_scene *f, const char *name, const char *value)
{
    amendments *a = &f->set.amend;
    const text_word w = word_of(value);
    if (strcmp(name, "fixed") == 0 && a->lists < AMEND_LISTS) return a->fixed[a->lists++] = value, 1;
    if (strcmp(name, "unit") == 0) return units_read_length(w, &a->unit);
    if (strcmp(name, "contact-distance") == 0) return touching_read_distance(w, &a->contact);
    if (strcmp(name, "contact-angle") == 0) return touching_read_angle(w, &a->contact);
    if (strcmp(name, "split") == 0) return a->split = 1;
    if (strcmp(name, "up") == 0) return (a->turn = units_read_axis(w, a->up)) != 0;
    if (strcmp(name, "mu") == 0) return text_real(w, &f->set.mu) == TEXT_NUMBER && f->set.mu >= 0;
    if (strncmp(name, "gravity-", 8) == 0 && name[8] >= 'x' && name[8] <= 'z') return take_gravity(a, name[8] - 'x', w);
    return 0;
}

int files_read(files_scene *f, const char *path, const char *text, size_t length)
{
    char *copy;
    if (!text) return scene_read(path, &f->set, &f->scene, &f->error);
    copy = malloc(length + 1);
    if (!copy) return fail_with(&f->error, EXIT_MEMORY, path, 0, "out of memory");
    memcpy(copy, text, length);
    copy[length] = 0;
    return scene_parse(path, copy, length, &f->set, &f->scene, &f->error);
}

const char *files_error(const files_scene *f) { return f->error.line; }
const sp_scene *files_parts(const files_scene *f) { return &f->scene.scene; }
const char *files_name(const files_scene *f, int32_t block) { return f->scene.name[block]; }
double files_mu(const files_scene *f) { return (double)f->scene.mu; }
double files_density(const files_scene *f) { return (double)f->scene.density; }

int files_found(const files_scene *f, sp_contact_settings *how, int32_t *overlaps, const sp_overlap **overlap)
{
    if (!f->scene.found) return 0;
    *how = touching_settings(f->scene.touching);
    how->strength = f->scene.strength;
    *overlaps = f->scene.overlaps;
    *overlap = f->scene.overlap;
    return 1;
}

const char *files_remark(const files_scene *f, int32_t k)
{
    return k < f->scene.remarks.count ? f->scene.remarks.each[k].text : NULL;
}

void files_free(files_scene *f)
{
    if (f) scene_free(&f->scene);
    free(f);
}

static int told(int status, const failure *error, char *message)
{
    memcpy(message, error->line, sizeof error->line);
    return status;
}

int files_write(const char *path, const sp_scene *scene, const char *const *name, char *message)
{
    failure error = { 0, "" };
    FILE *out = file_create(path, &error);
    int status = error.status;
    if (out) status = file_finish(out, path, obj_write(out, scene, name, path, &error), &error);
    return told(status, &error, message);
}

int files_json(const char *path, const sp_scene *scene, const char **name, const char *path_of_scene, const sp_result *result,
               const sp_settings *settings, const char *cone, char *message)
{
    failure error = { 0, "" };
    host_scene s;
    options asked;
    report r;
    memset(&s, 0, sizeof s);
    memset(&asked, 0, sizeof asked);
    memset(&r, 0, sizeof r);
    s.path = (char *)(uintptr_t)path_of_scene;
    s.scene = *scene;
    s.name = name;
    asked.forces = 1;
    asked.scene.mu = -1;
    asked.settings = *settings;
    strncpy(asked.cone, cone, sizeof asked.cone - 1);
    r.scene = &s;
    r.options = &asked;
    r.result = *result;
    FILE *out = file_create(path, &error);
    int status = error.status;
    if (out) {
        report_json(out, &r);
        status = file_finish(out, path, 0, &error);
    }
    return told(status, &error, message);
}

static int put(FILE *out, const void *of) { return svg_write(out, of); }

int files_draw(const char *path, const sp_scene *scene, const char **name, const char *title, const sp_result *result,
               const sp_limit_result *limit, int names, char *message)
{
    failure error = { 0, "" };
    host_scene s;
    memset(&s, 0, sizeof s);
    s.path = (char *)(uintptr_t)title;
    s.scene = *scene;
    s.name = name;
    const subject of = { &s, result, limit, { 0, 0, 0 }, names, NULL, NULL };
    return told(drawn_file(path, put, &of, &error), &error, message);
}
