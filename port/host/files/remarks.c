#include "remarks.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST 400                     /* [byte] of a sentence; names in it are cut by who adds it */

static char *copy_of(const char *s)
{
    char *copy = malloc(strlen(s) + 1);
    return copy ? strcpy(copy, s) : NULL;
}

static int is_told(const remarks *r, const char *text)
{
    for (int32_t i = 0; i < r->count; i++) if (strcmp(r->each[i].text, text) == 0) return 1;
    return 0;
}

static int make_room(remarks *r)
{
    const int32_t room = r->room ? 2 * r->room : 8;
    remark *more = r->count < r->room ? r->each : realloc(r->each, (size_t)room * sizeof *more);
    if (!more) return 0;
    if (r->count == r->room) r->room = room;
    r->each = more;
    return 1;
}

void remarks_add(remarks *r, const char *option, const char *format, ...)
{
    remark new = { NULL, NULL };
    char text[LONGEST];
    va_list args;

    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (is_told(r, text) || !make_room(r)) return;
    new.text = copy_of(text);
    new.option = option ? copy_of(option) : NULL;
    if (new.text && (new.option || !option)) r->each[r->count++] = new;
    else {
        free(new.text);
        free(new.option);
    }
}

void remarks_print(FILE *out, const remarks *r)
{
    for (int32_t i = 0; i < r->count; i++)
        fprintf(out, "  %-15s%s%s%s\n", "remark", r->each[i].text, r->each[i].option ? ": " : "",
                r->each[i].option ? r->each[i].option : "");
}

void remarks_json(json_out *j, const remarks *r)
{
    json_open(j, "remarks", '[');
    for (int32_t i = 0; i < r->count; i++) {
        json_open(j, NULL, '{');
        json_string(j, "text", r->each[i].text);
        if (r->each[i].option) json_string(j, "option", r->each[i].option);
        else json_null(j, "option");
        json_close(j, '}');
    }
    json_close(j, ']');
}

void remarks_free(remarks *r)
{
    for (int32_t i = 0; i < r->count; i++) {
        free(r->each[i].text);
        free(r->each[i].option);
    }
    free(r->each);
}
