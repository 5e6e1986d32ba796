#include "json_out.h"
#include "text.h"

#include <float.h>

int json_utf8(const char *s)
{
    const unsigned char *c = (const unsigned char *)s;
    if (c[0] < 0x80) return c[0] ? 1 : 0;
    if (c[0] >= 0xc2 && c[0] <= 0xdf && (c[1] & 0xc0) == 0x80) return 2;
    if ((c[0] & 0xf0) == 0xe0 && (c[1] & 0xc0) == 0x80 && (c[2] & 0xc0) == 0x80) {
        if (c[0] == 0xe0 && c[1] < 0xa0) return 0;                      /* longer than need be */
        if (c[0] == 0xed && c[1] >= 0xa0) return 0;                     /* half a surrogate pair */
        return 3;
    }
    if (c[0] >= 0xf0 && c[0] <= 0xf4 && (c[1] & 0xc0) == 0x80 && (c[2] & 0xc0) == 0x80 && (c[3] & 0xc0) == 0x80) {
        if (c[0] == 0xf0 && c[1] < 0x90) return 0;
        if (c[0] == 0xf4 && c[1] >= 0x90) return 0;                     /* above U+10FFFF */
        return 4;
    }
    return 0;
}

static void write_quoted(FILE *out, const char *s)
{
    fputc('"', out);
    while (*s) {
        size_t plain = 0;                               /* ASCII that needs no escape, at once */
        while (s[plain] > 31 && s[plain] < 127 && s[plain] != '"' && s[plain] != '\\') plain++;
        if (plain) fwrite(s, 1, plain, out);
        s += plain;
        if (!*s) break;
        const unsigned char c = (unsigned char)*s;
        const int n = json_utf8(s);
        if (c == '"' || c == '\\') fprintf(out, "\\%c", c);
        else if (n == 0 || c < 32 || c == 127) fprintf(out, "\\u%04x", c);
        else fwrite(s, 1, (size_t)n, out);
        s += n ? n : 1;
    }
    fputc('"', out);
}

static void write_key(json_out *j, const char *key)
{
    if (j->comma) fputs(", ", j->out);
    j->comma = 1;
    if (key) {
        write_quoted(j->out, key);
        fputs(": ", j->out);
    }
}

void json_open(json_out *j, const char *key, char bracket)
{
    write_key(j, key);
    fputc(bracket, j->out);
    j->comma = 0;
}

void json_close(json_out *j, char bracket)
{
    fputc(bracket, j->out);
    j->comma = 1;
}

void json_string(json_out *j, const char *key, const char *s)
{
    write_key(j, key);
    write_quoted(j->out, s);
}

void json_real(json_out *j, const char *key, double x)
{
    char text[32];
    write_key(j, key);
    fputs(x >= -DBL_MAX && x <= DBL_MAX ? text_shortest((sp_real)x, text) : "null", j->out);
}

void json_int(json_out *j, const char *key, int64_t x)
{
    write_key(j, key);
    fprintf(j->out, "%lld", (long long)x);
}

void json_bool(json_out *j, const char *key, int x)
{
    write_key(j, key);
    fputs(x ? "true" : "false", j->out);
}

void json_null(json_out *j, const char *key)
{
    write_key(j, key);
    fputs("null", j->out);
}

void json_reals(json_out *j, const char *key, const sp_real *x, int32_t n)
{
    json_open(j, key, '[');
    for (int32_t i = 0; i < n; i++) json_real(j, NULL, (double)x[i]);
    json_close(j, ']');
}
