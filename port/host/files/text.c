#include "text.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
static int is_line_end(char c) { return c == '\n' || c == '\r'; }
static int is_digit(char c) { return c >= '0' && c <= '9'; }

/* --------------------------------------------------------------------------------------------------------------- words */

/* Length of the line end at p: 2 for CR LF, 1 for LF or CR, 0 for none. */
static size_t line_end_length(const char *p, const char *end)
{
    if (p == end || !is_line_end(*p)) return 0;
    return p[0] == '\r' && end - p > 1 && p[1] == '\n' ? 2 : 1;
}

int text_next_word(text_cursor *c, text_word *word)
{
    for (;;) {
        size_t joined;
        while (c->p < c->end && is_blank(*c->p)) c->p++;
        if (c->p == c->end || *c->p != '\\') break;
        joined = line_end_length(c->p + 1, c->end);
        if (!joined) break;
        c->p += 1 + joined;
        c->line++;
    }
    word->s = c->p;
    while (c->p < c->end && !is_blank(*c->p) && !is_line_end(*c->p)) {
        if (*c->p == '\\' && line_end_length(c->p + 1, c->end)) break;
        c->p++;
    }
    word->n = (size_t)(c->p - word->s);
    return word->n > 0;
}

int text_next_name(text_cursor *c, text_word *name)
{
    const text_cursor before = *c;
    const char *p;
    int blanks = 0;
    if (!text_next_word(c, name)) return 0;
    if (*name->s != '"') return 1;
    for (p = name->s + 1; p < before.end && !is_line_end(*p) && *p != '"'; p++) blanks += is_blank(*p);
    if (p == before.end || *p != '"' || !blanks) return 1;
    name->s++;
    name->n = (size_t)(p - name->s);
    c->p = p + 1;
    return 1;
}

void text_skip_mark(text_cursor *c)
{
    if (c->end - c->p >= 3 && memcmp(c->p, "\xef\xbb\xbf", 3) == 0) c->p += 3;
}

int text_next_line(text_cursor *c)
{
    while (c->p < c->end && !is_line_end(*c->p)) c->p++;
    if (c->p == c->end) return 0;
    c->p += line_end_length(c->p, c->end);
    c->line++;
    return c->p < c->end;
}

int text_is(text_word word, const char *s)
{
    return strlen(s) == word.n && memcmp(word.s, s, word.n) == 0;
}

int text_same(text_word a, text_word b) { return a.n == b.n && memcmp(a.s, b.s, a.n) == 0; }

int text_begins(text_word asked, text_word name)
{
    for (size_t i = 0; i < asked.n; i++)
        if (i == name.n || (asked.s[i] != name.s[i] && !(is_blank(asked.s[i]) && name.s[i] == '_'))) return 0;
    return name.n > asked.n && name.s[asked.n] == '_';
}

int text_names(text_word asked, text_word name)
{
    for (size_t i = 0; i < asked.n && i < name.n; i++)
        if (asked.s[i] != name.s[i] && !(is_blank(asked.s[i]) && name.s[i] == '_')) return 0;
    return asked.n == name.n;
}

static int matches_one(char c, char pattern) { return pattern == '?' || pattern == c || (pattern == ' ' && c == '_'); }

/* The last * takes ever more of the word until what follows it fits. */
int text_matches(text_word word, text_word pattern)
{
    size_t i = 0, k = 0, star = SIZE_MAX, from = 0;
    while (i < word.n) {
        if (k < pattern.n && pattern.s[k] == '*') {
            star = k++;
            from = i;
        } else if (k < pattern.n && matches_one(word.s[i], pattern.s[k])) i++, k++;
        else if (star != SIZE_MAX) {
            k = star + 1;
            i = ++from;
        } else return 0;
    }
    while (k < pattern.n && pattern.s[k] == '*') k++;
    return k == pattern.n;
}

/* ------------------------------------------------------------------------------------------------------------- numbers */

/* Does all of the word follow [+-] digits [. digits] [e [+-] digits], with a digit before the e? */
static int is_decimal(text_word w)
{
    size_t i = 0, digits = 0, exponent = 0;

    if (i < w.n && (w.s[i] == '+' || w.s[i] == '-')) i++;
    for (; i < w.n && is_digit(w.s[i]); i++) digits++;
    if (i < w.n && w.s[i] == '.')
        for (i++; i < w.n && is_digit(w.s[i]); i++) digits++;
    if (digits == 0) return 0;
    if (i == w.n) return 1;
    if (w.s[i] != 'e' && w.s[i] != 'E') return 0;
    i++;
    if (i < w.n && (w.s[i] == '+' || w.s[i] == '-')) i++;
    for (; i < w.n && is_digit(w.s[i]); i++) exponent++;
    return exponent > 0 && i == w.n;
}

/* A terminated copy for strtod; longer words are no sensible number. */
static int copy_decimal(text_word w, char buffer[128])
{
    if (w.n > 127 || !is_decimal(w)) return 0;
    memcpy(buffer, w.s, w.n);
    buffer[w.n] = 0;
    return 1;
}

text_number text_double(text_word word, double *x)
{
    char buffer[128];
    double y;
    if (!copy_decimal(word, buffer)) return TEXT_NO_NUMBER;
    y = strtod(buffer, NULL);                           /* the program never leaves the C locale */
    if (!(y >= -DBL_MAX && y <= DBL_MAX)) return TEXT_TOO_LARGE;
    *x = y;
    return TEXT_NUMBER;
}

text_number text_real(text_word word, sp_real *x)
{
#ifdef SP_REAL_FLOAT
    char buffer[128];
    float y;
    if (!copy_decimal(word, buffer)) return TEXT_NO_NUMBER;
    y = strtof(buffer, NULL);                           /* rounded once */
    if (!(y >= -FLT_MAX && y <= FLT_MAX)) return TEXT_TOO_LARGE;
    *x = y;
    return TEXT_NUMBER;
#else
    double y;
    const text_number is = text_double(word, &y);
    if (is == TEXT_NUMBER) *x = y;
    return is;
#endif
}

text_number text_int(text_word word, int32_t *i)
{
    int64_t x = 0;
    size_t k = 0;
    int minus = 0;

    if (word.n && (word.s[0] == '+' || word.s[0] == '-')) minus = word.s[k++] == '-';
    if (k == word.n) return TEXT_NO_NUMBER;
    for (; k < word.n; k++) {
        if (!is_digit(word.s[k])) return TEXT_NO_NUMBER;
        if (x <= INT32_MAX) x = 10 * x + (word.s[k] - '0');
    }
    if (x > INT32_MAX) return TEXT_TOO_LARGE;
    *i = (int32_t)(minus ? -x : x);
    return TEXT_NUMBER;
}

/* Does the text read back as x? */
static int reads_as(sp_real x, const char text[32])
{
    sp_real y = 0;
    const text_word w = { text, strlen(text) };
    return text_real(w, &y) == TEXT_NUMBER && !(y < x) && !(y > x);
}

/* How many digits a number has, zeros in front not counted. */
static int count_digits(const char *text)
{
    int n = 0;
    for (; *text && *text != 'e'; text++) n += is_digit(*text) && (n || *text != '0');
    return n;
}

/* The digits of a number, rounded to one less, with no zeros at their end.      returns 0: they cannot tell what printf would
 * print, for there are none behind the point, or the last one is a 5, or all are 9 */
static int drop_digit(char text[32])
{
    char *point = strchr(text, '.'), *end, *last;
    if (!point) return 0;
    end = point + 1 + strspn(point + 1, "0123456789");
    last = end - 1;
    if (last == point || *last == '5') return 0;
    if (*last > '5') {
        char *k = last - 1;
        for (; k > text && (*k == '9' || *k == '.'); k--) if (*k == '9') *k = '0';
        if (!is_digit(*k) || *k == '9') return 0;
        ++*k;
    }
    for (last--; last > point && *last == '0'; last--) continue;
    memmove(last > point ? last + 1 : point, end, strlen(end) + 1);
    return 1;
}

/* 17 digits tell every number apart (of float 9), `sure` print all that has fewer. printf is slow, so it is asked once. */
const char *text_shortest(sp_real x, char text[32])
{
    const int sure = sizeof(sp_real) == 8 ? 15 : 6;
    char shorter[32];
    if (sizeof(sp_real) == 8) snprintf(text, 32, "%.17g", (double)x);
    else snprintf(text, 32, "%.9g", (double)x);
    for (int digits = count_digits(text); digits > sure && digits <= 17; digits = count_digits(text)) {
        memcpy(shorter, text, sizeof shorter);
        if (!drop_digit(shorter)) snprintf(shorter, sizeof shorter, "%.*g", digits - 1, (double)x);
        if (!reads_as(x, shorter)) break;
        memcpy(text, shorter, sizeof shorter);
    }
    return text;
}

const char *text_s(int64_t n) { return n == 1 ? "" : "s"; }
