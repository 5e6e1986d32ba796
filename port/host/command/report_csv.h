/* A check or a limit as tables: NAME-joints.csv and NAME-blocks.csv. */
#ifndef STONEPACK_HOST_REPORT_CSV_H
#define STONEPACK_HOST_REPORT_CSV_H

#include "report.h"

void report_csv_joints(FILE *out, const report *r);
void report_csv_blocks(FILE *out, const report *r);

/* Create NAME-WHAT.csv of --csv NAME; its path goes to `path`, of REPORT_CSV_PATH bytes.    NULL: error is set */
#define REPORT_CSV_PATH 1024
FILE *report_csv_create(const options *o, const char *what, char *path, failure *error);

/* Write both tables of --csv.                              returns 0 or an exit status */
int report_csv(const report *r, failure *error);

#endif
