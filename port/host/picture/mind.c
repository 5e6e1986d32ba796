#include "mind.h"
#include "page.h"

#include <string.h>

#define MOST   4                        /* told in a picture */
#define LEAD   "mind: "
#define INDENT 41.0                     /* its width [px] */

/* Bytes of the first row of a text, up to the last blank that is within so many; all of a text without blanks. */
static size_t row_of(const char *s, size_t letters)
{
    size_t n = 0, blank = 0;
    for (; n <= letters && s[n]; n++) if (s[n] == ' ') blank = n;
    return s[n] && blank ? blank : strlen(s);
}

static void write_row(FILE *out, const char *s, size_t n, size_t letters)
{
    char row[512];
    if (n >= sizeof row) n = sizeof row - 1;
    memcpy(row, s, n);
    row[n] = 0;
    page_text(out, row, letters);
}

/* One remark in rows; its option stands in one piece.     returns the rows; out NULL: counts them only */
static int write_remark(FILE *out, const remark *m, double x, double y, size_t letters)
{
    const size_t room = letters - strlen(LEAD), option = m->option ? strlen(m->option) + 2 : 0;
    const char *s = m->text;
    for (int rows = 0; ; rows++) {
        const size_t n = row_of(s, room);
        const int last = !s[n], fits = last && n + option <= room;
        if (out) {
            page_label(out, rows ? x + INDENT : x, y + MIND_ROW * rows);
            if (!rows) fputs(LEAD, out);
            write_row(out, s, n, room);
            if (last && option) fputs(fits ? ": " : ":", out);
            if (fits && option) page_text(out, m->option, room);
            fputs("</text>\n", out);
        }
        if (last && option && !fits && out) {
            page_label(out, x + INDENT, y + MIND_ROW * (rows + 1));
            page_text(out, m->option, room);
            fputs("</text>\n", out);
        }
        if (last) return rows + 1 + (option && !fits);
        s += n + 1;
    }
}

static int told(const remarks *r) { return r->count < MOST ? (int)r->count : MOST; }

int mind_rows(const remarks *r, size_t letters)
{
    int rows = 0;
    for (int k = 0; k < told(r); k++) rows += write_remark(NULL, &r->each[k], 0, 0, letters);
    return rows;
}

void mind_write(FILE *out, const remarks *r, double x, double y, size_t letters)
{
    for (int k = 0; k < told(r); k++) y += MIND_ROW * write_remark(out, &r->each[k], x, y, letters);
}
