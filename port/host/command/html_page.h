/* An answer as a page that stands alone: nothing is fetched. */
#ifndef STONEPACK_HOST_HTML_PAGE_H
#define STONEPACK_HOST_HTML_PAGE_H

#include "../files/drawn.h"

typedef struct html_page {
    const char *path, *answer;          /* of the scene; in a word */
    drawn_put *words, *body;            /* the answer as on a terminal, its first line the head; what follows */
    const void *of;                     /* handed to both */
} html_page;

/* Write it into a file of this name; NULL: nothing is asked for.                returns 0 or an exit status */
int html_page_write(const char *path, const html_page *p, failure *error);

#endif
