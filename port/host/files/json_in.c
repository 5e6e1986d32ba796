#include "json_in.h"
#include "file.h"
#include "text.h"

#include <stdlib.h>
#include <string.h>

#define DEPTH_MAX 32            /* levels of a result: 4 */

typedef struct reader {
    json_tree *t;
    const char *path, *p, *end;
    int32_t line;
    failure *error;
} reader;

static int fail(reader *r, const char *message)
{
    return fail_with(r->error, EXIT_SCENE, r->path, r->line, "%s", message);
}

static void skip_space(reader *r)
{
    for (; r->p < r->end && (*r->p == ' ' || *r->p == '\t' || *r->p == '\n' || *r->p == '\r'); r->p++)
        if (*r->p == '\n') r->line++;
}

static int skip_char(reader *r, char c)
{
    skip_space(r);
    if (r->p == r->end || *r->p != c) return 0;
    r->p++;
    return 1;
}

/* A new value; its number in *id. */
static int new_value(reader *r, json_kind kind, int32_t *id)
{
    json_tree *t = r->t;
    const json_value empty = { kind, r->line, -1, -1, NULL, { 0 } };
    if (t->count == t->room) {
        const int32_t room = t->room ? 2 * t->room : 256;
        json_value *more = room > t->room ? realloc(t->value, (size_t)room * sizeof *more) : NULL;
        if (!more) return fail_with(r->error, EXIT_MEMORY, r->path, 0, "out of memory while reading");
        t->value = more;
        t->room = room;
    }
    *id = t->count++;
    t->value[*id] = empty;
    return 0;
}

/* Four hex digits, -1: not so. */
static int32_t hex4(const reader *r)
{
    int32_t x = 0;
    if (r->end - r->p < 4) return -1;
    for (int i = 0; i < 4; i++) {
        const char c = r->p[i];
        if (c >= '0' && c <= '9') x = 16 * x + (c - '0');
        else if (c >= 'a' && c <= 'f') x = 16 * x + (c - 'a' + 10);
        else if (c >= 'A' && c <= 'F') x = 16 * x + (c - 'A' + 10);
        else return -1;
    }
    return x;
}

/* A code point as UTF-8 at w; the byte after it. */
static char *utf8(char *w, int32_t x)
{
    if (x < 0x80) *w++ = (char)x;
    else if (x < 0x800) {
        *w++ = (char)(0xc0 | x >> 6);
        *w++ = (char)(0x80 | (x & 63));
    } else if (x < 0x10000) {
        *w++ = (char)(0xe0 | x >> 12);
        *w++ = (char)(0x80 | (x >> 6 & 63));
        *w++ = (char)(0x80 | (x & 63));
    } else {
        *w++ = (char)(0xf0 | x >> 18);
        *w++ = (char)(0x80 | (x >> 12 & 63));
        *w++ = (char)(0x80 | (x >> 6 & 63));
        *w++ = (char)(0x80 | (x & 63));
    }
    return w;
}

/* After a \u: one code point, from a surrogate pair if need be. */
static int unicode(reader *r, char **w)
{
    int32_t x = hex4(r), low;
    if (x < 0) return fail(r, "bad \\u escape in a string");
    r->p += 4;
    if (x >= 0xd800 && x < 0xdc00 && r->end - r->p >= 6 && r->p[0] == '\\' && r->p[1] == 'u') {
        r->p += 2;
        low = hex4(r);
        if (low < 0xdc00 || low > 0xdfff) return fail(r, "half a surrogate pair in a string");
        r->p += 4;
        x = 0x10000 + ((x - 0xd800) << 10) + (low - 0xdc00);
    } else if (x >= 0xd800 && x < 0xe000) return fail(r, "half a surrogate pair in a string");
    if (x == 0) return fail(r, "a zero byte in a string");
    *w = utf8(*w, x);
    return 0;
}

/* After the opening quote. Decoded in place: no escape is shorter than what it stands for. */
static int string(reader *r, const char **s)
{
    static const char from[] = "\"\\/bfnrt", to[] = "\"\\/\b\f\n\r\t";
    char *w = r->t->text + (r->p - r->t->text);

    *s = w;
    while (r->p < r->end && *r->p != '"') {
        const char c = *r->p++;
        if ((unsigned char)c < 32) return fail(r, "a control byte in a string");
        if (c != '\\') {
            *w++ = c;
            continue;
        }
        const char *e = r->p < r->end && *r->p ? strchr(from, *r->p) : NULL;
        if (e) {
            *w++ = to[e - from];
            r->p++;
        } else if (r->p < r->end && *r->p == 'u') {
            r->p++;
            if (unicode(r, &w)) return r->error->status;
        } else return fail(r, "bad escape in a string");
    }
    if (r->p == r->end) return fail(r, "a string without its end");
    r->p++;
    *w = 0;
    return 0;
}

/* The grammar of JSON is narrower than text_double's: no +, no leading 0, digits on both sides of the point. */
static int number(reader *r, double *x)
{
    text_word w = { r->p, 0 };
    const char *q;
    while (r->p + w.n < r->end && (strchr("+-.eE", w.s[w.n]) ? w.s[w.n] != 0 : w.s[w.n] >= '0' && w.s[w.n] <= '9')) w.n++;
    q = w.s + (w.n && w.s[0] == '-');
    if (w.n == 0 || *q < '0' || *q > '9' || (*q == '0' && q + 1 < w.s + w.n && q[1] >= '0' && q[1] <= '9'))
        return fail(r, "a value was expected");
    for (size_t i = 0; i < w.n; i++)
        if (w.s[i] == '.' && (i + 1 == w.n || w.s[i + 1] < '0' || w.s[i + 1] > '9')) return fail(r, "bad number");
    r->p += w.n;
    switch (text_double(w, x)) {
    case TEXT_NUMBER:    return 0;
    case TEXT_TOO_LARGE: return fail(r, "number out of range");
    case TEXT_NO_NUMBER:
    default:             return fail(r, "bad number");
    }
}

static int literal(reader *r, const char *s)
{
    const size_t n = strlen(s);
    if ((size_t)(r->end - r->p) < n || memcmp(r->p, s, n)) return 0;
    r->p += n;
    return 1;
}

static int value(reader *r, int depth, int32_t *id);

/* After the opening bracket. */
static int members(reader *r, int depth, int32_t id, char close)
{
    int32_t last = -1;
    if (depth == DEPTH_MAX) return fail(r, "nested too deep");
    if (skip_char(r, close)) return 0;
    do {
        const char *key = NULL;
        int32_t member;
        if (close == '}') {
            if (!skip_char(r, '"')) return fail(r, "a key in quotes was expected");
            if (string(r, &key)) return r->error->status;
            if (!skip_char(r, ':')) return fail(r, "':' was expected");
        }
        if (value(r, depth + 1, &member)) return r->error->status;
        r->t->value[member].key = key;
        if (last < 0) r->t->value[id].first = member;
        else r->t->value[last].next = member;
        last = member;
    } while (skip_char(r, ','));
    return skip_char(r, close) ? 0 : fail(r, close == '}' ? "',' or '}' was expected" : "',' or ']' was expected");
}

/* Recursion is at most DEPTH_MAX deep. */
static int value(reader *r, int depth, int32_t *id)
{
    skip_space(r);
    if (r->p == r->end) return fail(r, "a value was expected before the end");
    if (new_value(r, JSON_NULL, id)) return r->error->status;
    switch (*r->p) {
    case '{':
        r->t->value[*id].kind = JSON_OBJECT;
        r->p++;
        return members(r, depth, *id, '}');
    case '[':
        r->t->value[*id].kind = JSON_ARRAY;
        r->p++;
        return members(r, depth, *id, ']');
    case '"':
        r->t->value[*id].kind = JSON_STRING;
        r->p++;
        return string(r, &r->t->value[*id].as.string);
    default:
        if (literal(r, "null")) return 0;
        r->t->value[*id].kind = JSON_BOOL;
        if (literal(r, "true")) { r->t->value[*id].as.number = 1; return 0; }
        if (literal(r, "false")) { r->t->value[*id].as.number = 0; return 0; }
        r->t->value[*id].kind = JSON_NUMBER;
        return number(r, &r->t->value[*id].as.number);
    }
}

int json_parse(const char *path, char *text, size_t length, json_tree *tree, failure *error)
{
    const json_tree empty = { text, NULL, 0, 0 };
    reader r = { tree, path, text, text + length, 1, error };
    int32_t id;
    int status;

    *tree = empty;
    status = value(&r, 0, &id);
    if (status) return status;
    skip_space(&r);
    return r.p == r.end ? 0 : fail(&r, "more than one JSON value");
}

int json_read(const char *path, json_tree *tree, failure *error)
{
    const json_tree empty = { NULL, NULL, 0, 0 };
    char *text;
    size_t length;
    const int status = file_read(path, &text, &length, error);
    *tree = empty;
    return status ? status : json_parse(path, text, length, tree, error);
}

const json_value *json_member(const json_tree *tree, const json_value *object, const char *key)
{
    if (!object || object->kind != JSON_OBJECT) return NULL;
    for (int32_t i = object->first; i >= 0; i = tree->value[i].next)
        if (strcmp(tree->value[i].key, key) == 0) return &tree->value[i];
    return NULL;
}

void json_free(json_tree *tree)
{
    free(tree->text);
    free(tree->value);
}
