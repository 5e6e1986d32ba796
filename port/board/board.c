/* board: what all architectures share. Operations are those of Arm's semihosting, which RISC-V took over. */
#include "board.h"

#include <stdarg.h>
#include <stddef.h>
#include <string.h>

enum { SYS_OPEN = 0x01, SYS_WRITE0 = 0x04, SYS_READ = 0x06, SYS_GET_CMDLINE = 0x15, SYS_EXIT = 0x18, SYS_EXIT_EXTENDED = 0x20,
       STOPPED = 0x20026 };

int main(int argc, char **argv);

/* ---------------------------------------------------------------------------------------------------------- start and end */

void board_exit(int status)
{
    const unsigned long block[2] = { STOPPED, (unsigned long)status };
    board_call(SYS_EXIT_EXTENDED, block);
    board_call(SYS_EXIT, block);
    for (;;) { }
}

void board_fault(const char *what, unsigned long why)
{
    board_print("%s, %08lx\n", what, why);
    board_exit(134);
}

/* The words of the command line that the simulator was given. */
static int words(char *line, char **argv, int most)
{
    int argc = 0;
    for (char *s = line; *s && argc < most; ) {
        while (*s == ' ') *s++ = 0;
        if (*s) argv[argc++] = s;
        while (*s && *s != ' ') s++;
    }
    return argc;
}

void board_main(void)
{
    static char line[256];
    static char *argv[9];
    const struct { char *at; size_t size; } block = { line, sizeof line };
    memmove(board_data, board_data_from, (size_t)(board_data_end - board_data));
    memset(board_bss, 0, (size_t)(board_bss_end - board_bss));
    board_count();
    if (board_call(SYS_GET_CMDLINE, &block)) line[0] = 0;
    board_exit(main(words(line, argv, 8), argv));
}

/* ------------------------------------------------------------------------------------------------------------------ stack */

enum { PAINT = 0x5a, KEPT = 128 };                      /* [byte] of the frames that are running */

static char *painted;

__attribute__((noinline)) void board_paint(void)
{
    painted = (char *)__builtin_frame_address(0);
    for (volatile char *p = board_bss_end; p < painted - KEPT; p++) *p = PAINT;
}

__attribute__((noinline)) unsigned board_depth(void)
{
    const char *p = board_bss_end;
    while (p < painted && *p == PAINT) p++;
    return (unsigned)(painted - p);
}

/* ------------------------------------------------------------------------------------------------------------ text in, out */

static char out[256];
static unsigned filled;

static void flush(void)
{
    out[filled] = 0;
    board_call(SYS_WRITE0, out);
    filled = 0;
}

static int put(char c)
{
    out[filled++] = c;
    if (filled == sizeof out - 1) flush();
    return 1;
}

static int put_padded(const char *text, int length, int width, char pad, int left)
{
    int n = 0;
    if (!left) for (; n < width - length; n++) put(pad);
    for (int k = 0; k < length; k++, n++) put(text[k]);
    for (; n < width; n++) put(' ');
    return n;
}

/* Digits of x, written backwards from `end`: where they start. */
static char *digits(char *end, unsigned long long x, unsigned base)
{
    do *--end = "0123456789abcdef"[x % base]; while (x /= base);
    return end;
}

/* x as d.ddde+xx with `precision` digits after the point; the last may be off by one. */
static int scientific(char *text, double x, int precision)
{
    char *t = text;
    int e = 0;
    if (x < 0) *t++ = '-', x = -x;
    if (!(x - x >= 0)) { memcpy(t, x > 0 ? "inf" : "nan", 3); return (int)(t - text) + 3; }
    if (precision > 17) precision = 17;
    if (x > 0) {
        while (x >= 1e16) x *= 1e-16, e += 16;
        while (x < 1e-16) x *= 1e16, e -= 16;
        while (x >= 10) x /= 10, e++;
        while (x < 1) x *= 10, e--;
    }
    double half = 0.5;
    for (int k = 0; k < precision; k++) half /= 10;
    if ((x += half) >= 10) x /= 10, e++;
    for (int k = 0; k <= precision; k++) {
        const int d = (int)x;
        *t++ = (char)('0' + d);
        if (!k && precision) *t++ = '.';
        x = 10 * (x - d);
    }
    char digit[8], *d = digits(digit + 8, (unsigned long long)(e < 0 ? -e : e), 10);
    *t++ = 'e';
    *t++ = e < 0 ? '-' : '+';
    while (d < digit + 8) *t++ = *d++;
    return (int)(t - text);
}

/* Plain digits for numbers of ordinary size, else with an exponent. */
static int number(char *text, double x, int precision, char kind)
{
    const double size = x < 0 ? -x : x;
    double scale = 1;
    if (precision < 0) precision = 6;
    if (kind == 'e' || !(size < 1e9) || (kind == 'g' && size > 0 && size < 1e-4)) return scientific(text, x, precision);
    if (kind == 'g') for (double s = size; s >= 1 && precision > 1; s /= 10) precision--;
    if (precision > 9) precision = 9;
    for (int k = 0; k < precision; k++) scale *= 10;
    char buffer[40], *end = buffer + 40, *d;
    unsigned long long n = (unsigned long long)(size * scale + 0.5);
    const unsigned long long whole = n / (unsigned long long)scale;
    for (n %= (unsigned long long)scale; precision && kind == 'g' && n % 10 == 0; precision--) n /= 10;
    d = end;
    if (precision) {
        d = digits(end, n, 10);
        while (end - d < precision) *--d = '0';
        *--d = '.';
    }
    d = digits(d, whole, 10);
    if (x < 0) *--d = '-';
    memcpy(text, d, (size_t)(end - d));
    return (int)(end - d);
}

/* Width or precision: digits, or * for an argument. */
static int count(const char **f, va_list *a)
{
    int n = 0;
    if (**f == '*') return (*f)++, va_arg(*a, int);
    for (; **f >= '0' && **f <= '9'; (*f)++) n = 10 * n + (**f - '0');
    return n;
}

int board_print(const char *f, ...)
{
    va_list a;
    int n = 0;
    va_start(a, f);
    for (; *f; f++) {
        if (*f != '%') { n += put(*f); continue; }
        char buffer[48], *end = buffer + sizeof buffer, *text = end, pad = ' ';
        int left = 0, longs = 0, precision = -1;
        for (f++; *f == '-' || *f == '0' || *f == '+'; f++) *f == '-' ? (left = 1) : *f == '0' ? (pad = '0') : (pad = pad);
        const int width = count(&f, &a);
        if (*f == '.') f++, precision = count(&f, &a);
        for (; *f == 'l' || *f == 'z'; f++) longs++;
        if (*f == 's') {
            const char *s = va_arg(a, const char *);
            int length = 0;
            while (s[length] && (precision < 0 || length < precision)) length++;
            n += put_padded(s, length, width, ' ', left);
            continue;
        }
        if (*f == 'c') *--text = (char)va_arg(a, int);
        else if (*f == '%') *--text = '%';
        else if (*f == 'd' || *f == 'i') {
            const long long x = longs > 1 ? va_arg(a, long long) : longs ? va_arg(a, long) : va_arg(a, int);
            text = digits(end, x < 0 ? 0 - (unsigned long long)x : (unsigned long long)x, 10);
            if (x < 0) *--text = '-';
        } else if (*f == 'u' || *f == 'x') {
            const unsigned long long x = longs > 1 ? va_arg(a, unsigned long long) : longs ? va_arg(a, unsigned long)
                                                                                           : va_arg(a, unsigned);
            text = digits(end, x, *f == 'x' ? 16 : 10);
        } else {
            end = buffer + number(buffer, va_arg(a, double), precision, *f);
            text = buffer;
        }
        n += put_padded(text, (int)(end - text), width, pad, left);
    }
    va_end(a);
    flush();
    return n;
}

long board_open(const char *name)
{
    const struct { const char *name; unsigned long mode, length; } open = { name, 0, strlen(name) };
    return board_call(SYS_OPEN, &open);
}

int board_line(long from, char *text, int cap)
{
    int n = 0;
    for (;;) {
        char c = 0;
        const struct { long from; char *to; unsigned long length; } read = { from, &c, 1 };
        if (from < 0 || board_call(SYS_READ, &read)) return -1;
        if (c == '\n') break;
        if (n < cap - 1) text[n++] = c;
    }
    text[n] = 0;
    return n;
}
