#include "../files/failure.h"
#include "../run.h"
#include "worker.h"

#include <stdlib.h>
#include <string.h>

static void answer_error(blob *answer, sp_status status)
{
    if (blob_write_error(answer, status, sp_status_text(status))) blob_free(answer);
}

void worker_answer_to(const blob *request, blob *answer)
{
    void *memory = NULL, *results = NULL;
    run_cost cost;
    sp_scene scene;
    sp_settings settings;
    sp_result result;
    sp_status status = blob_read_request(request, &scene, &settings, &memory);

    if (!status) status = run_check(&scene, &settings, &result, &cost, &results);
    if (!status) status = blob_write_result(answer, &scene, &result, &cost);
    if (status) answer_error(answer, status);
    free(memory);
    free(results);
}

/* Read until b holds `length` bytes; memory grows as they come, not as they are announced.     returns 0: end of input */
static int read_until(FILE *in, blob *b, size_t length)
{
    while (b->length < length) {
        const size_t want = length - b->length < 65536 ? length - b->length : 65536;
        size_t got;
        if (!blob_grow(b, want)) return 0;
        got = fread(b->data + b->length, 1, want, in);
        b->length += got;
        if (got < want) return 0;
    }
    return 1;
}

/* One message and its answer.      returns 0: go on; 1: end of input; 2: lost; 3: can't answer */
static int answer_one(FILE *in, FILE *out, blob *request, blob *answer)
{
    blob_kind kind;
    size_t length;
    sp_status status = SP_E_ARGUMENT;
    int whole;

    request->length = 0;
    whole = read_until(in, request, BLOB_HEADER);
    if (!whole && !request->failed && request->length == 0 && !ferror(in)) return 1;
    if (whole) status = blob_header(request->data, &kind, &length);
    whole = whole && !status && read_until(in, request, length);
    if (whole) worker_answer_to(request, answer);
    else answer_error(answer, request->failed ? SP_E_MEMORY : status ? status : SP_E_ARGUMENT);
    if (!answer->length || fwrite(answer->data, 1, answer->length, out) != answer->length || fflush(out) != 0) return 3;
    return whole ? 0 : 2;
}

int worker_session(FILE *in, FILE *out)
{
    blob request = { NULL, 0, 0, 0 }, answer = { NULL, 0, 0, 0 };
    int end;
    do end = answer_one(in, out, &request, &answer); while (end == 0);
    blob_free(&request);
    blob_free(&answer);
    return end == 1 ? 0 : end == 2 ? EXIT_SCENE : EXIT_INTERNAL;
}

static int same_block(const sp_block *a, const sp_block *b)
{
    return memcmp(&a->mass, &b->mass, sizeof a->mass) == 0 && memcmp(a->centroid, b->centroid, sizeof a->centroid) == 0
        && memcmp(&a->density, &b->density, sizeof a->density) == 0 && memcmp(&a->volume, &b->volume, sizeof a->volume) == 0
        && memcmp(&a->diameter, &b->diameter, sizeof a->diameter) == 0 && a->fixed == b->fixed
        && a->vertex == b->vertex && a->vertices == b->vertices && a->face == b->face && a->faces == b->faces;
}

static int same_joint(const sp_joint *a, const sp_joint *b)
{
    return a->a == b->a && a->b == b->b && a->point == b->point && a->points == b->points
        && memcmp(a->n, b->n, sizeof a->n) == 0 && memcmp(a->t1, b->t1, sizeof a->t1) == 0
        && memcmp(a->t2, b->t2, sizeof a->t2) == 0 && memcmp(&a->area, &b->area, sizeof a->area) == 0
        && memcmp(&a->strength, &b->strength, sizeof a->strength) == 0;
}

static int same_load(const sp_load *a, const sp_load *b)
{
    return a->block == b->block && a->live == b->live && memcmp(a->point, b->point, sizeof a->point) == 0
        && memcmp(a->force, b->force, sizeof a->force) == 0 && memcmp(a->couple, b->couple, sizeof a->couple) == 0
        && memcmp(&a->mass, &b->mass, sizeof a->mass) == 0;
}

int worker_same_scene(const sp_scene *a, const sp_scene *b)
{
    const sp_capacity *n = &a->count;
    int same = memcmp(n, &b->count, sizeof *n) == 0 && memcmp(a->gravity, b->gravity, sizeof a->gravity) == 0
        && memcmp(&a->live, &b->live, sizeof a->live) == 0 && memcmp(a->body, b->body, sizeof a->body) == 0;
    for (int32_t k = 0; same && k < n->blocks; k++) same = same_block(&a->block[k], &b->block[k]);
    for (int32_t k = 0; same && k < n->joints; k++) same = same_joint(&a->joint[k], &b->joint[k]);
    for (int32_t k = 0; same && k < n->loads; k++) same = same_load(&a->load[k], &b->load[k]);
    return same && memcmp(a->vertex, b->vertex, (size_t)n->vertices * sizeof *a->vertex) == 0
        && memcmp(a->face, b->face, (size_t)n->faces * sizeof *a->face) == 0
        && memcmp(a->corner, b->corner, (size_t)n->corners * sizeof *a->corner) == 0
        && memcmp(a->point, b->point, (size_t)n->points * sizeof *a->point) == 0;
}
