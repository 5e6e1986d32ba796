/* A limit without dilatancy, asked and told: real sliding does not open joints. */
#ifndef STONEPACK_HOST_SLIDING_H
#define STONEPACK_HOST_SLIDING_H

#include "report.h"
#include "../files/json_out.h"

/* The answer for r->scene after its limit r->limit; its arrays lie in *memory, to be freed by the caller in every case.
 *   returns 0 or an exit status */
int sliding_ask(report *r, sp_sliding_result *x, run_cost *cost, void **memory, failure *error);

/* Why there is or is no state, in words. */
const char *sliding_reason(sp_sliding_reason reason);

/* Its member of the JSON object, with --forces the evidence, and its lines in words. */
void sliding_json(json_out *j, const report *r, const sp_sliding_result *x, const run_cost *cost);
void sliding_text(FILE *out, const report *r, const sp_sliding_result *x, const run_cost *cost);
#endif
