/* Text as it comes: a whole file in memory, words of a line, strict numbers, one-line messages.
 *
 * Nothing here trusts the input: memory follows the file's real size, a byte that is no text ends the reading, and every
 * number is checked against its grammar before strtod sees it.
 */
#ifndef STONEPACK_HOST_TEXT_H
#define STONEPACK_HOST_TEXT_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include "../../../stonepack.h"

/* Exit status of the program (sysexits.h where it has a name for it). */
enum { EXIT_STABLE = 0, EXIT_UNSTABLE = 1, EXIT_UNDECIDED = 2, EXIT_USAGE = 64, EXIT_SCENE = 65, EXIT_NO_INPUT = 66,
       EXIT_UNAVAILABLE = 69, EXIT_INTERNAL = 70, EXIT_MEMORY = 71 };

#define TEXT_CAP ((size_t)1 << 30)      /* [byte] longest file read */

/* The shortest decimal that reads back as x, of finite x; returns text.           text: room for 32 bytes */
const char *text_shortest(sp_real x, char text[32]);

/* What went wrong: exit status and one line without its newline. */
typedef struct text_error {
    int status;
    char line[512];
} text_error;

/* Set an error `path:line: message` (without `line:` when line is 0). Returns status. Control bytes become '?'. */
int text_fail(text_error *error, int status, const char *path, int32_t line, const char *format, ...);

/* Set the error of a library call. Returns its exit status: 71, 65 or 70. */
int text_fail_status(text_error *error, sp_status status, const char *path, int32_t line, const char *what);

/* Read a whole file ("-": standard input) into memory of malloc's, with a zero byte after its end.
 * Refuses control bytes other than white space as they arrive, and more than TEXT_CAP bytes.    returns 0 or an exit status */
int text_read(const char *path, char **text, size_t *length, text_error *error);

/* A file to write, or for "-" and NULL standard output. Not NULL, or an error is set. */
FILE *text_create(const char *path, text_error *error);

/* Close it. What could not be written whole, or ends with another error, is removed: nothing half written stays.
 *   status    0, or the error there is already
 *   returns   status, or EXIT_INTERNAL: can't write */
int text_finish(FILE *out, const char *path, int status, text_error *error);

/* A place in a text. */
typedef struct text_cursor {
    const char *p, *end;
    int32_t line;               /* from 1 */
} text_cursor;

/* A word: no copy, not terminated. */
typedef struct text_word {
    const char *s;
    size_t n;
} text_word;

/* Next word of this line; 0 at its end. A backslash before the line's end joins the next line. */
int text_next_word(text_cursor *c, text_word *word);

/* Go to the start of the next line (LF, CR LF or CR); 0 at the end of the text. */
int text_next_line(text_cursor *c);

int text_is(text_word word, const char *s);

typedef enum text_number { TEXT_NUMBER = 0, TEXT_NO_NUMBER, TEXT_TOO_LARGE } text_number;

/* A decimal number, [+-] digits [. digits] [e [+-] digits], all of the word, finite in sp_real. */
text_number text_real(text_word word, sp_real *x);

/* As text_real, in double whatever sp_real is. */
text_number text_double(text_word word, double *x);

/* A decimal whole number within int32_t. */
text_number text_int(text_word word, int32_t *i);

#endif
