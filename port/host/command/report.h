/* A check that was made, and what is told of it: in words, as JSON, as a picture. */
#ifndef STONEPACK_HOST_REPORT_H
#define STONEPACK_HOST_REPORT_H

#include <stdio.h>
#include "../run.h"
#include "options.h"
#include "../files/scene.h"
#include "solvers.h"
#include "../picture/subject.h"

/* A check that was made. */
typedef struct report {
    const host_scene *scene;
    const options *options;
    sp_result result;
    run_cost cost;              /* of the check itself, without reading and contacts */
    size_t coupled_bytes;       /* by so much its arena is larger for the coupled check */
    const sp_limit_result *limit;           /* a limit instead: result has its forces and motion only; NULL: a check */
    const sp_sliding_result *sliding;       /* of a limit: without dilatancy; NULL: not asked */
    run_cost sliding_cost;
    const sp_strong_result *strong;         /* whether friction holds it whatever it does; NULL: not asked */
    run_cost strong_cost;
    const solvers_published *published;     /* the coupled question by another solver; NULL: not asked */
} report;

/* Make the check of r->scene, by a worker if the options ask for one; its arrays live in *memory, to be freed by the caller.
 *   returns 0 or an exit status */
int report_check(report *r, void **memory, failure *error);

void report_text(FILE *out, const report *r);
void report_json(FILE *out, const report *r);

/* The end of a first line: an answer that may rest on missing contacts, or on one too many, says so. */
void report_near(FILE *out, int32_t near, int32_t inside, int32_t across);

/* The label of a line of report_text. */
void report_row(FILE *out, const char *label);

/* Who told the tol in force, r->result.tol: "asked", "least friction" whose eighth is less, or "coupled". */
const char *report_tol_by(const report *r);

/* A line on that where it was not asked for. */
void report_tol(FILE *out, const report *r);

/* The largest compression of a whole joint, its corners together [N]; 0: none presses. */
double report_joint_compression(const report *r);

/* Is any block held, in any direction? */
int report_supported(const report *r);

/* What pictures show: of an ambiguous scene a motion it has besides rest, of a limit its sliding state, where one is known. */
typedef struct report_shown {
    subject of;
    sp_result result;
    sp_real *dq;                /* malloc's; NULL: the result's own */
    char words[80];
} report_shown;

/* returns 0: out of memory */
int report_show(const report *r, report_shown *shown);

/* Draw it into the files of --svg, --png and --out-obj, where asked for.             returns 0 or an exit status */
int report_draw(const report *r, failure *error);

/* Exit status of a verdict. */
int report_exit(sp_verdict verdict);

#endif
