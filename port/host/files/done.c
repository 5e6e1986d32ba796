/* done: what an earlier run left of its results. */
#define _POSIX_C_SOURCE 200809L         /* access */
#include "done.h"
#include "file.h"
#include "json_in.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int by_name(const void *a, const void *b)
{
    return strcmp(((const done_entry *)a)->scene, ((const done_entry *)b)->scene);
}

static int status_of_verdict(const char *verdict)
{
    return strcmp(verdict, "stable") == 0 ? EXIT_STABLE : strcmp(verdict, "unstable") == 0 ? EXIT_UNSTABLE
         : strcmp(verdict, "undecided") == 0 ? EXIT_UNDECIDED : -1;
}

static int add_scene(done_list *d, const char *scene, int status)
{
    char *copy = malloc(strlen(scene) + 1);
    if (d->count == d->room) {
        const int32_t room = d->room ? 2 * d->room : 64;
        done_entry *more = realloc(d->entry, (size_t)room * sizeof *more);
        if (more) {
            d->entry = more;
            d->room = room;
        }
    }
    if (!copy || d->count == d->room) {
        free(copy);
        return 0;
    }
    strcpy(copy, scene);
    d->entry[d->count].scene = copy;
    d->entry[d->count++].status = status;
    return 1;
}

/* One line: {"scene": ..., "verdict": ...}.       returns 0: no memory */
static int take_line(done_list *d, const char *line, size_t length)
{
    json_tree tree;
    failure ignored;
    char *text = malloc(length + 1);
    int ok = 1, status;
    if (!text) return 0;
    memcpy(text, line, length);
    text[length] = 0;
    if (json_parse("", text, length, &tree, &ignored) == 0 && tree.value[0].kind == JSON_OBJECT) {
        const json_value *scene = json_member(&tree, tree.value, "scene"), *verdict = json_member(&tree, tree.value, "verdict");
        status = verdict && verdict->kind == JSON_STRING ? status_of_verdict(verdict->as.string) : -1;
        if (status >= 0 && scene && scene->kind == JSON_STRING) ok = add_scene(d, scene->as.string, status);
    }
    json_free(&tree);
    return ok;
}

int done_read(const char *path, done_list *d, failure *error)
{
    const done_list none = { NULL, 0, 0, 0 };
    char *text = NULL;
    size_t length = 0;
    int ok = 1, status;

    *d = none;
    if (strcmp(path, "-") && access(path, F_OK) != 0) return 0;
    status = file_read(path, &text, &length, error);
    for (size_t k = 0; !status && ok && k < length;) {
        const char *end = memchr(text + k, '\n', length - k);
        const size_t n = end ? (size_t)(end - (text + k)) : length - k;
        ok = take_line(d, text + k, n);              /* a torn line is no object and says nothing */
        if (!end) d->torn = 1;
        k += n + 1;
    }
    free(text);
    if (!ok) return fail_with(error, EXIT_MEMORY, path, 0, "out of memory");
    if (d->count) qsort(d->entry, (size_t)d->count, sizeof *d->entry, by_name);
    return status;
}

int done_find(const done_list *d, const char *scene)
{
    int32_t low = 0, high = d->count;
    while (low < high) {
        const int32_t k = low + (high - low) / 2;
        const int order = strcmp(d->entry[k].scene, scene);
        if (order == 0) return d->entry[k].status;
        if (order < 0) low = k + 1;
        else high = k;
    }
    return -1;
}

void done_free(done_list *d)
{
    for (int32_t k = 0; k < d->count; k++) free(d->entry[k].scene);
    free(d->entry);
}
