#include "compas_text.h"

#include <stdlib.h>
#include <string.h>

static int end_line(compas_text *t, int32_t line)
{
    if (t->lines == t->line_room) {
        const int32_t room = t->line_room ? 2 * t->line_room : 256;
        int32_t *more = room > t->line_room ? realloc(t->line, (size_t)room * sizeof *more) : NULL;
        if (!more) return 0;
        t->line = more;
        t->line_room = room;
    }
    t->line[t->lines++] = line;
    return 1;
}

int compas_text_add(compas_text *t, const char *some, size_t n, int32_t line)
{
    if (t->length + n + 1 > t->room) {
        const size_t room = 2 * (t->room + n) + 512;
        char *more = realloc(t->text, room);
        if (!more) return 0;
        t->text = more;
        t->room = room;
    }
    memcpy(t->text + t->length, some, n);
    t->length += n;
    t->text[t->length] = 0;
    return n == 0 || some[n - 1] != '\n' || end_line(t, line);
}
