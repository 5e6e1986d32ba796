/* The worker: answers requests (blob.h) until its input ends. */
#ifndef STONEPACK_HOST_WORKER_H
#define STONEPACK_HOST_WORKER_H

#include <stdio.h>
#include "blob.h"

/* Answer every message of `in` on `out`. A body that is wrong gets an error and the session goes on; after a header that is
 * wrong nobody knows where the next message starts: it gets an error, too, and the session ends.
 *   returns 0: the input ended where a message does; EXIT_SCENE: it did not; EXIT_INTERNAL: can't write, or
 *           no memory for an error */
int worker_session(FILE *in, FILE *out);

/* Answer one message; `answer` is a result or an error, empty only where memory ran out. */
void worker_answer_to(const blob *request, blob *answer);

/* Do two scenes hold the same bits, room apart? */
int worker_same_scene(const sp_scene *a, const sp_scene *b);

#endif
