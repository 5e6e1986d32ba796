#include "units.h"

int units_read_length(text_word w, units_length *unit)
{
    static const struct { const char *name; units_length unit; } known[] = {
        { "mm", { 1, 1000 } }, { "cm", { 1, 100 } }, { "m", { 1, 1 } }, { "in", { 127, 5000 } } };
    for (int k = 0; k < 4; k++)
        if (text_is(w, known[k].name)) {
            *unit = known[k].unit;
            return 1;
        }
    return 0;
}

int units_read_axis(text_word w, sp_real axis[3])
{
    const int sign = w.n == 2 && (w.s[0] == '-' || w.s[0] == '+');
    const char c = w.n ? w.s[w.n - 1] : 0;
    if (w.n != 1 && !sign) return 0;
    if (c < 'x' || c > 'z') return 0;
    for (int k = 0; k < 3; k++) axis[k] = c - 'x' == k ? (sign && w.s[0] == '-' ? (sp_real)-1 : (sp_real)1) : 0;
    return 1;
}
