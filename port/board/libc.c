/* libc: the four functions a compiler may call, and the little of <string.h> and <math.h> that the tests use: with this nothing
 * of a C library is linked. The library itself needs memcpy, memset, memmove and a square root; the rest is for the tests. */
#include <math.h>
#include <string.h>

#include <stdint.h>

#include "../../tests/scenes/gen.h"

typedef uint32_t __attribute__((may_alias)) word;

void *memcpy(void *to, const void *from, size_t n)
{
    unsigned char *t = to;
    const unsigned char *f = from;
    if ((((uintptr_t)t | (uintptr_t)f | n) & 3) == 0)
        for (size_t k = 0; k < n; k += 4) *(word *)(t + k) = *(const word *)(f + k);
    else
        for (size_t k = 0; k < n; k++) t[k] = f[k];
    return to;
}

void *memmove(void *to, const void *from, size_t n)
{
    unsigned char *t = to;
    const unsigned char *f = from;
    if ((uintptr_t)t <= (uintptr_t)f || (uintptr_t)t >= (uintptr_t)f + n) return memcpy(to, from, n);
    while (n-- > 0) t[n] = f[n];
    return to;
}

void *memset(void *to, int value, size_t n)
{
    unsigned char *t = to;
    const word all = (uint32_t)(unsigned char)value * 0x01010101u;
    size_t k = 0;
    if (((uintptr_t)t & 3) == 0)
        for (; k + 4 <= n; k += 4) *(word *)(t + k) = all;
    for (; k < n; k++) t[k] = (unsigned char)value;
    return to;
}

int memcmp(const void *a, const void *b, size_t n)
{
    const unsigned char *x = a, *y = b;
    for (size_t k = 0; k < n; k++)
        if (x[k] != y[k]) return x[k] < y[k] ? -1 : 1;
    return 0;
}

size_t strlen(const char *s)
{
    size_t n = 0;
    while (s[n]) n++;
    return n;
}

int strcmp(const char *a, const char *b)
{
    while (*a && *a == *b) a++, b++;
    return (unsigned char)*a - (unsigned char)*b;
}

char *strstr(const char *text, const char *part)
{
    for (; ; text++) {
        size_t k = 0;
        while (part[k] && text[k] == part[k]) k++;
        if (!part[k]) return (char *)(uintptr_t)text;
        if (!*text) return NULL;
    }
}

/* Correctly rounded square root, two bits of x and one of the root at a time.                        [after fdlibm's e_sqrt] */
double sqrt(double x)
{
    uint64_t bits, root = 0, twice = 0;
    memcpy(&bits, &x, 8);
    if (bits << 1 == 0) return x;                       /* 0 and -0 */
    if (bits >> 63) return NAN;
    if (bits >> 52 == 2047) return x;                   /* infinity, NaN */
    int64_t e = (int64_t)(bits >> 52);
    if (e == 0)
        for (e = 1; !(bits >> 52); e--) bits <<= 1;
    bits = (bits & 0xfffffffffffffu) | 0x10000000000000u;
    e -= 1023;
    if (e & 1) bits <<= 1, e--;
    bits <<= 1;
    for (uint64_t r = (uint64_t)1 << 53; r; r >>= 1, bits <<= 1)
        if (twice + r <= bits) twice += 2 * r, bits -= twice - r, root += r;
    if (bits) root += root & 1;                         /* never a tie: round by the bit below */
    bits = (root >> 1) + ((uint64_t)(e / 2 + 1022) << 52);
    memcpy(&x, &bits, 8);
    return x;
}

float sqrtf(float x) { return (float)sqrt((double)x); } /* rounded twice, yet right: 53 >= 2 * 24 + 2          [Figueroa 1995] */

double hypot(double a, double b) { return sqrt(a * a + b * b); }
double fabs(double x) { return x < 0 ? -x : x; }
double fmax(double a, double b) { return a < b ? b : a; }
double fmin(double a, double b) { return b < a ? b : a; }

double floor(double x)
{
    if (!(fabs(x) < 4503599627370496.0)) return x;      /* 2^52: whole, or none */
    const double t = (double)(int64_t)x;
    return t > x ? t - 1 : t;
}

double sin(double x) { return gen_sin(x); }
double cos(double x) { return gen_cos(x); }
double tan(double x) { return gen_sin(x) / gen_cos(x); }

/* atan x = 2 atan(x / (1 + sqrt(1 + x^2))), three times; then its series. */
double atan(double x)
{
    double sum = 0;
    for (int k = 0; k < 3; k++) x = x / (1 + sqrt(1 + x * x));
    for (int k = 41; k >= 1; k -= 2) sum = 1.0 / k - x * x * sum;
    return 8 * x * sum;
}

/* e log x, powers of two apart; log m = 2 atanh((m - 1) / (m + 1)). For x > 0. */
double pow(double x, double e)
{
    int64_t two = 0;
    double sum = 0, term = 1, power = 1;
    for (; x >= 1.5; x *= 0.5) two++;
    for (; x < 0.75; x *= 2) two--;
    const double s = (x - 1) / (x + 1);
    for (int k = 41; k >= 1; k -= 2) sum = 1.0 / k + s * s * sum;
    const double log2 = 0.69314718055994530942, y = e * (double)two + e * 2 * s * sum / log2, whole = floor(y + 0.5);
    for (int k = 1; k < 24; k++) power += term *= (y - whole) * log2 / k;
    for (int64_t k = (int64_t)whole; k > 0; k--) power *= 2;
    for (int64_t k = (int64_t)whole; k < 0; k++) power *= 0.5;
    return power;
}
