/* A check as a page that stands alone: the verdict in words, a picture that turns, a table of the joints. */
#ifndef STONEPACK_HOST_REPORT_HTML_H
#define STONEPACK_HOST_REPORT_HTML_H

#include "report.h"

/* Write the page of --html.                                returns 0 or an exit status */
int report_html(const report *r, failure *error);

#endif
