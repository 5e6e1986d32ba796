/* worker: checks in a process of their own, which may run out of time or memory without harm to anyone. */
#include "../../../tests/scenes/gen.h"
#include "../files/scene.h"
#include "../run.h"
#include "../worker/worker.h"
#include "commands.h"

#include <stdlib.h>
#include <string.h>

/* Scene -> message -> scene. */
static int round_trip(const char *path)
{
    const sp_settings settings = sp_settings_default();
    const scene_settings as_it_is = scene_settings_default();
    failure error = { 0, "" };
    blob b = { NULL, 0, 0, 0 };
    void *memory = NULL;
    host_scene s;
    sp_scene again;
    sp_settings set;
    int exit_status = scene_read(path, &as_it_is, &s, &error);

    if (!exit_status) {
        sp_status status = blob_write_request(&b, &s.scene, &settings);
        if (!status) status = blob_read_request(&b, &again, &set, &memory);
        if (status) exit_status = fail_status(&error, status, path, 0, "");
        else if (!worker_same_scene(&s.scene, &again))
            exit_status = fail_with(&error, EXIT_INTERNAL, path, 0, "not the same bits");
        else printf("%s: %lu bytes, same bits\n", path, (unsigned long)b.length);
    }
    if (exit_status) fprintf(stderr, "%s\n", error.line);
    blob_free(&b);
    free(memory);
    scene_free(&s);
    return exit_status;
}

/* A session with one request; is the answer the check's own result, bit by bit? Times don't count. */
static int session_agrees(const sp_scene *scene, const sp_settings *settings)
{
    blob request = { NULL, 0, 0, 0 }, answer = { NULL, 0, 0, 0 }, told = { NULL, 0, 0, 0 }, own = { NULL, 0, 0, 0 };
    void *memory = NULL, *read = NULL;
    run_cost cost = { 0, 0 }, theirs = { 0, 0 };
    sp_result result, got;
    sp_status status = run_check(scene, settings, &result, &cost, &memory);
    int same;

    if (!status) status = blob_write_request(&request, scene, settings);
    if (!status) worker_answer_to(&request, &answer);
    if (!status) status = blob_read_result(&answer, scene, &got, &theirs, &read);
    cost.seconds = theirs.seconds;
    if (!status) status = blob_write_result(&own, scene, &result, &cost);
    if (!status) status = blob_write_result(&told, scene, &got, &theirs);
    same = !status && own.length == told.length && memcmp(own.data, told.data, own.length) == 0;
    blob_free(&request);
    blob_free(&answer);
    blob_free(&told);
    blob_free(&own);
    free(memory);
    free(read);
    return same;
}

static int scene_agrees(const char *name, int coupled)
{
    sp_settings settings = sp_settings_default();
    sp_capacity cap;
    sp_arena arena;
    sp_scene scene;
    gen_scene g;
    void *memory = NULL;
    int same;
    settings.coupled.asked = coupled;
    same = gen_open(&g, name) && gen_capacity(&g, &cap) == SP_OK && run_arena(sp_scene_memory(&cap), &arena, &memory) == SP_OK
        && gen_build(&g, &arena, &scene) == SP_OK && session_agrees(&scene, &settings);
    free(memory);
    if (!same) fprintf(stderr, "worker: %s: not the same bits\n", name);
    return same;
}

/* A few scenes by formula, here and as messages. */
static int self_test(void)
{
    const int same = scene_agrees("arch", 0) & scene_agrees("wall", 1) & scene_agrees("h-model", 1);
    if (same) puts("worker: 3 scenes, same bits as in-process");
    return same ? 0 : EXIT_INTERNAL;
}

int command_worker(int argc, char **argv)
{
    if (argc == 2) return worker_session(stdin, stdout);
    if (argc == 3 && strcmp(argv[2], "--selftest") == 0) return self_test();
    if (argc == 4 && strcmp(argv[2], "--roundtrip") == 0) return round_trip(argv[3]);
    fputs("stonepack: worker takes --selftest, --roundtrip SCENE, or nothing: then it answers its standard input\n", stderr);
    return EXIT_USAGE;
}
