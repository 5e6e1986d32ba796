#include "mind.h"
#include "page.h"

#include <string.h>

enum { MOST = 4 };                      /* told in a picture */

int mind_rows(const remarks *r) { return r->count < MOST ? (int)r->count : MOST; }

void mind_write(FILE *out, const remarks *r, double x, double y, size_t letters)
{
    for (int k = 0; k < mind_rows(r); k++) {
        const char *option = r->each[k].option;
        const size_t taken = strlen("mind: ") + (option ? strlen(option) + 2 : 0);
        page_label(out, x, y + MIND_ROW * k);
        fputs("mind: ", out);
        page_text(out, r->each[k].text, letters > taken + 20 ? letters - taken : 20);
        if (option) {
            fputs(": ", out);
            page_text(out, option, letters);
        }
        fputs("</text>\n", out);
    }
}
