/* A check or a limit as a page that stands alone: the answer in words, a picture that turns, a table of the joints. */
#ifndef STONEPACK_HOST_REPORT_HTML_H
#define STONEPACK_HOST_REPORT_HTML_H

#include "report.h"

typedef void report_words(FILE *out, const report *r);

/* The picture that turns and the table of joints, of a page of another kind.             returns 1, 0: out of memory */
int report_html_body(FILE *out, const report *r);

/* Write the page of --html, if one is asked for; words: what the terminal is told.       returns 0 or an exit status */
int report_html(const report *r, report_words *words, failure *error);

#endif
