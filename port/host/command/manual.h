/* The manual page and the completions of shells, made from what --help prints.
 *
 * A help text: lines of usage, an empty line, then text. A line that begins with two spaces and a dash tells options: their
 * names, each with its value in capitals, two spaces, what they do, two spaces, their default; lines indented further go on. */
#ifndef STONEPACK_HOST_MANUAL_H
#define STONEPACK_HOST_MANUAL_H

#include <stdio.h>

typedef struct manual_entry {
    const char *name, *summary, *help;
    const char *more;           /* what else --help prints of it, or NULL */
} manual_entry;

/* kind: man, bash or zsh.                      returns 0: another */
int manual_write(FILE *out, const char *kind, const manual_entry *entry, int entries, const char *scene_lines);

#endif
