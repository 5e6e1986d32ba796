/* A whole file in memory, and one to write.
 *
 * Nothing here trusts the input: memory follows the file's real size, and a byte that is no text ends the reading. */
#ifndef STONEPACK_HOST_FILE_H
#define STONEPACK_HOST_FILE_H

#include <stdio.h>
#include "failure.h"

#define FILE_CAP ((size_t)1 << 30)      /* [byte] longest file read */

/* Read a whole file ("-": standard input) into memory of malloc's, with a zero byte after its end.
 * Refuses control bytes other than white space as they arrive, and more than FILE_CAP bytes.    returns 0 or an exit status */
int file_read(const char *path, char **text, size_t *length, failure *error);

/* A file to write, or for "-" and NULL standard output. Not NULL, or an error is set.
 *
 * What is written stands beside it, PATH.NUMBER.part, until it is whole, and then takes its place with the same permissions; a
 * link keeps leading to it. Devices, pipes and what standard output goes to are written directly, as are files in a folder
 * where nothing may be added. */
FILE *file_create(const char *path, failure *error);

/* Close it. What could not be written whole, or ends with another error, is removed: what was at PATH before stays as it was.
 *   status    0, or the error there is already
 *   returns   status, or EXIT_INTERNAL: can't write */
int file_finish(FILE *out, const char *path, int status, failure *error);

/* Do two paths lead to one file, or would they if it were there? Never to devices and pipes, which may be told twice. */
int file_is_same(const char *a, const char *b);

#endif
