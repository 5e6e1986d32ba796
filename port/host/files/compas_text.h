/* The text of a scene file that grows while JSON is read, and for each of its lines the line of the JSON that it comes from. */
#ifndef STONEPACK_HOST_COMPAS_TEXT_H
#define STONEPACK_HOST_COMPAS_TEXT_H

#include <stddef.h>
#include <stdint.h>

/* Empty: all 0. text and line are malloc's. */
typedef struct compas_text {
    char *text;
    size_t length, room;
    int32_t *line, lines, line_room;
} compas_text;

/* Append n bytes; a newline at their end ends a line that comes from `line`.     returns 0: out of memory */
int compas_text_add(compas_text *t, const char *some, size_t n, int32_t line);

#endif
