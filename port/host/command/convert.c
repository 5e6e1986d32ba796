/* convert: read a scene, write it with its contacts.  gen: write a scene made by formula. */
#include "../../../tests/scenes/gen.h"
#include "../files/file.h"
#include "../files/obj_write.h"
#include "../files/scene.h"
#include "../files/text.h"
#include "../run.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Write to a file or, for "-" or NULL, to standard output. */
static int write_scene_to(const char *path, const sp_scene *scene, const char *const *name, failure *error)
{
    FILE *out = file_create(path, error);
    return out ? file_finish(out, path, obj_write(out, scene, name, path ? path : "-", error), error) : error->status;
}

int command_convert(int argc, char **argv)
{
    failure error = { 0, "" };
    host_scene s;
    options o;

    if (options_read(argc, argv, SCENE_OPTIONS, &o, &error) == 0 && (o.files < 1 || o.files > 2))
        fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: convert needs a scene and at most one file to write");
    if (!error.status && o.files > 1 && outputs_check(&o, o.file[1], &error) == 0)
        outputs_check_obj("convert", o.file[1], &error);
    if (!error.status && o.files > 1) outputs_check_beside("convert", o.file[0], o.file[1], &error);
    if (!error.status) {
        if (scene_read(o.file[0], &o.scene, &s, &error) == 0
            && write_scene_to(o.files > 1 ? o.file[1] : NULL, &s.scene, s.name, &error) == 0 && !o.quiet) {
            outputs_tell_beside(o.files > 1 ? o.file[1] : NULL, &s.remarks);
            remarks_print(stderr, &s.remarks);          /* standard output may be the scene */
        }
        scene_free(&s);
    }
    if (error.status) fprintf(stderr, "%s\n", error.line);
    return error.status;
}

/* ----------------------------------------------------------------------------------------------------------------- gen */

static void print_param(const gen_param *p)
{
    for (; p->name; p++) printf("  %-12s %-10g %s (%g .. %g)\n", p->name, p->value, p->help, p->low, p->high);
}

static void print_scenes(void)
{
    puts("stonepack gen NAME [NUMBER=VALUE ...]: writes a scene to standard output\n");
    for (const gen_entry *e = gen_table; e->name; e++) {
        printf("%s: %s\n", e->name, e->help);
        print_param(e->param);
    }
    puts("every scene:");
    print_param(gen_common);
}

/* NAME=VALUE, --NAME=VALUE or --NAME VALUE. */
static int read_numbers(int argc, char **argv, gen_scene *g, failure *error)
{
    for (int i = 3; i < argc; i++) {
        char *name = argv[i], *value = strchr(name, '=');
        const int dashes = strncmp(name, "--", 2) == 0;
        text_word w;
        double x = 0;
        int set;
        if (dashes) name += 2;
        if (value) *value++ = 0;
        else if (dashes && i + 1 < argc) value = argv[++i];
        if (!value)
            return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: gen %s: '%.60s' has no value", argv[2], name);
        w.s = value;
        w.n = strlen(value);
        if (text_double(w, &x) != TEXT_NUMBER)
            return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: gen %s: '%.60s' is not a number", argv[2], value);
        if (gen_counts(name) && x - floor(x) > 0)
            return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: gen %s: not a whole number: '%.60s'; see stonepack gen",
                             argv[2], name);
        set = gen_set(g, name, x);
        if (set != 1)
            return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: gen %s: %s '%.60s'; see stonepack gen", argv[2],
                             set ? "outside its range:" : "no number called", name);
    }
    return 0;
}

static int write_generated(const gen_scene *g, failure *error)
{
    sp_capacity cap;
    sp_scene scene;
    sp_arena arena;
    void *memory = NULL;
    int failed = 0;
    sp_status status = gen_capacity(g, &cap);

    if (status == SP_OK) status = run_arena(sp_scene_memory(&cap), &arena, &memory);
    if (status == SP_OK) status = gen_build(g, &arena, &scene);
    if (status != SP_OK) failed = fail_status(error, status, g->entry->name, 0, "");
    else failed = write_scene_to(NULL, &scene, NULL, error);
    free(memory);
    return failed;
}

int command_gen(int argc, char **argv)
{
    failure error = { 0, "" };
    gen_scene g;

    if (argc < 3) {
        print_scenes();
        return 0;
    }
    if (!gen_open(&g, argv[2]))
        fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: no scene '%.60s'; see stonepack gen", argv[2]);
    else if (read_numbers(argc, argv, &g, &error) == 0) write_generated(&g, &error);
    if (error.status) fprintf(stderr, "%s\n", error.line);
    return error.status;
}
