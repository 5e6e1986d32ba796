/* Remarks: what whoever asks should know of a scene beside the answer, a sentence each, with the option that helps.
 *
 * A scene gathers them while it is read (host_scene.remarks); a command may add more. They are told once, below the answer,
 * and change neither verdict nor exit status. */
#ifndef STONEPACK_HOST_REMARKS_H
#define STONEPACK_HOST_REMARKS_H

#include <stdio.h>
#include "json_out.h"

typedef struct remark {
    char *text;                 /* a sentence without a full stop */
    char *option;               /* that helps, as it is typed: "--up y"; NULL: none */
} remark;

typedef struct remarks {
    int32_t count, room;
    remark *each;
} remarks;

/* Add a sentence, format and arguments as printf's; one that is there already is not added again. option: NULL, or it is
 * copied. Where memory is out the remark is lost: no answer depends on it. */
void remarks_add(remarks *r, const char *option, const char *format, ...);

/* A row each, as in the report of `check`: "  remark         TEXT: OPTION". */
void remarks_print(FILE *out, const remarks *r);

/* "remarks": [{"text", "option" or null}, ...] */
void remarks_json(json_out *j, const remarks *r);

void remarks_free(remarks *r);

#endif
