/* Scenes that have a result already: a JSON Lines file of an earlier run. */
#ifndef STONEPACK_HOST_DONE_H
#define STONEPACK_HOST_DONE_H

#include "failure.h"

typedef struct done_entry {
    char *scene;
    int status;                 /* exit status of its verdict */
} done_entry;

typedef struct done_list {
    done_entry *entry;          /* by name */
    int32_t count, room;
    int torn;                   /* the file ends inside a line */
} done_list;

/* Read what `check --json` wrote. Lines that are no result (the torn last one of a run that was stopped) don't count; no such
 * file: nothing is done.       returns 0 or an exit status; free with done_free in every case */
int done_read(const char *path, done_list *done, failure *error);

/* Exit status of the verdict of this scene, -1: it has none. */
int done_find(const done_list *done, const char *scene);

void done_free(done_list *done);

#endif
