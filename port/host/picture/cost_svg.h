/* What accuracy costs: the same scene checked with every cone, stage and tolerance, as a picture. */
#ifndef STONEPACK_HOST_COST_SVG_H
#define STONEPACK_HOST_COST_SVG_H

#include <stdio.h>
#include "../files/scene.h"

enum { COST_CONES = 9, COST_STAGES = 4, COST_TOLS = 6, COST_ROWS = COST_CONES * COST_STAGES * COST_TOLS };

#ifdef SP_REAL_FLOAT
#define COST_REAL "float"
#elif defined SP_REAL_MIXED
#define COST_REAL "mixed"
#else
#define COST_REAL "double"
#endif

typedef struct cost_row {
    const char *cone;           /* "true", "8i" */
    sp_stage_id stage;          /* behind the gates, alone */
    double tol;
    sp_verdict verdict;
    sp_reason reason;
    double imbalance, least;        /* least imbalance proved */
    sp_cost cost;
    size_t bytes;               /* peak of the arena */
    double seconds;
} cost_row;

typedef struct cost_table {
    sp_verdict truth;           /* by the exact stage with the true cone, at the tightest tol that decides */
    double truth_tol;
    int64_t truth_flops;
    int64_t budget;             /* flops a check had: a hundred times what the reference took, 1e8 at least */
    int rows;                   /* all, or fewer where Ctrl-C ended it */
    cost_row row[COST_ROWS];    /* by stage, cone, tol */
} cost_table;

/* Imbalance over work and over time, one mark a check. */
void cost_svg(FILE *out, const host_scene *s, const cost_table *t);

#endif
