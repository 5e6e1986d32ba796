/* Text as it comes: words of a line, strict numbers. Each number is checked against its grammar before strtod sees it. */
#ifndef STONEPACK_HOST_TEXT_H
#define STONEPACK_HOST_TEXT_H

#include <stddef.h>
#include <stdint.h>
#include "../../../stonepack.h"

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

/* The same for a name, which may stand in quotes, "two words", without them: only quotes that hold blanks are such. */
int text_next_name(text_cursor *c, text_word *name);

/* Text begins behind the byte order mark of UTF-8, which editors of Windows write. */
void text_skip_mark(text_cursor *c);

/* Go to the start of the next line (LF, CR LF or CR); 0 at the end of the text. */
int text_next_line(text_cursor *c);

int text_is(text_word word, const char *s);
int text_same(text_word a, text_word b);

/* Is this the name, with blanks or with the _ that stand for them? Does the name begin with the word and such a blank? */
int text_names(text_word asked, text_word name);
int text_begins(text_word asked, text_word name);

/* Does the word follow a pattern, in which * is anything, also nothing, and ? one byte? */
int text_matches(text_word word, text_word pattern);

typedef enum text_number { TEXT_NUMBER = 0, TEXT_NO_NUMBER, TEXT_TOO_LARGE } text_number;

/* A decimal number, [+-] digits [. digits] [e [+-] digits], all of the word, finite in sp_real. */
text_number text_real(text_word word, sp_real *x);

/* As text_real, in double whatever sp_real is. */
text_number text_double(text_word word, double *x);

/* A decimal whole number within int32_t. */
text_number text_int(text_word word, int32_t *i);

/* The shortest decimal that reads back as x, of finite x; returns text.           text: room for 32 bytes */
const char *text_shortest(sp_real x, char text[32]);

/* What a word of n things ends with: "s", of one thing nothing. */
const char *text_s(int64_t n);

#endif
