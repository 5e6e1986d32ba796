/* Have a check made by a worker, a process of its own with limits. POSIX. */
#ifndef STONEPACK_HOST_WORKER_CLIENT_H
#define STONEPACK_HOST_WORKER_CLIENT_H

#include "blob.h"

typedef struct worker_client {
    const char *const *command; /* its words, NULL at the end; the first is looked for in PATH unless it has a slash */
    double seconds;             /* from start to answer; then it is killed */
    size_t memory;              /* its address space [byte]; 0: unlimited */
    int fallback;               /* 1: where no worker answers or memory is too little for it, check in this process */
} worker_client;

typedef enum worker_end {
    WORKER_ANSWERED = 0,        /* a result */
    WORKER_REFUSED,             /* an error; `status` tells which */
    WORKER_LATE,                /* no answer in time; it was killed */
    WORKER_DIED,                /* it ended without an answer; `code` is its exit status, or minus the signal */
    WORKER_GARBLED,             /* what it said is no answer to this scene */
    WORKER_NOT_STARTED          /* no process or socket to be had; a command that can't be run is WORKER_DIED, code 127 */
} worker_end;

typedef struct worker_answer {
    worker_end end;
    int fell_back;              /* no worker answered, `result` was found here (or `status` tells why not) */
    sp_status status;           /* SP_OK: there is a result */
    int code;
    char message[200];          /* one line on an `end` that is no answer */
    sp_result result;           /* its arrays lie in memory */
    run_cost cost;
    void *memory;               /* the caller frees it in every case */
} worker_answer;

/* One check by one worker. Writes and reads as the other side is ready, so full pipes can't block it; when it returns, the
 * worker is gone and waited for, and what it started in its process group is killed. No files. Should the caller die, so does
 * the worker on Linux; elsewhere its processor time, limited to the deadline, ends it.
 *   settings NULL: the default ones
 *   returns answer->status: SP_OK, what sp_check or blob_write_request returns, SP_E_MEMORY; SP_E_UNSUPPORTED without a result
 *           and an `end` that tells more where nobody answered */
sp_status worker_check(const worker_client *client, const sp_scene *scene, const sp_settings *settings, worker_answer *answer);

#endif
