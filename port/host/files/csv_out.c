#include "csv_out.h"
#include "text.h"

#include <string.h>

/* Text inside quotes. */
static void put_quoted(csv_out *c, const char *s)
{
    for (; *s; s++) {
        if (*s == '"') fputc('"', c->out);
        fputc(*s, c->out);
    }
}

static void next_value(csv_out *c)
{
    if (c->comma) fputc(',', c->out);
    c->comma = 1;
}

void csv_header(csv_out *c, const char *columns) { fprintf(c->out, "%s\n", columns); }

void csv_text(csv_out *c, const char *s)
{
    next_value(c);
    if (!strpbrk(s, ",\"\r\n") && s[strspn(s, " ")] == *s) {
        fputs(s, c->out);
        return;
    }
    fputc('"', c->out);
    put_quoted(c, s);
    fputc('"', c->out);
}

void csv_names(csv_out *c, const char *const *name, const int32_t *which, int32_t n)
{
    next_value(c);
    if (n) fputc('"', c->out);
    for (int32_t k = 0; k < n; k++) {
        if (k) fputc(';', c->out);
        put_quoted(c, name[which[k]]);
    }
    if (n) fputc('"', c->out);
}

void csv_real(csv_out *c, sp_real x)
{
    char text[32];
    next_value(c);
    if (x - x <= 0 && x - x >= 0) fputs(text_shortest(x, text), c->out);
}

void csv_reals(csv_out *c, const sp_real *x, int n)
{
    for (int k = 0; k < n; k++) csv_real(c, x[k]);
}

void csv_int(csv_out *c, int64_t x)
{
    next_value(c);
    fprintf(c->out, "%lld", (long long)x);
}

void csv_none(csv_out *c) { next_value(c); }

void csv_end(csv_out *c)
{
    fputc('\n', c->out);
    c->comma = 0;
}
