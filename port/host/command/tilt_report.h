/* `limit --tilt-margin`: how far gravity may turn, in words, as JSON, as a picture. */
#ifndef STONEPACK_HOST_TILT_REPORT_H
#define STONEPACK_HOST_TILT_REPORT_H

#include "report.h"

/* Measure it for r->scene and tell it as r->options ask.          returns the exit status of the command */
int tilt_report(report *r, failure *error);

#endif
