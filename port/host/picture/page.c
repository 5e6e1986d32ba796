#include "page.h"
#include "../files/json_out.h"

#include <math.h>

void page_begin(FILE *out, double height)
{
    fprintf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" "
            "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n", PAGE_WIDTH, height, PAGE_WIDTH, height);
    fputs("<defs><pattern id=\"hatch\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" "
          "patternTransform=\"rotate(45)\"><path d=\"M0 0V7\" stroke=\"#2f3942\" stroke-width=\"1.6\" stroke-opacity=\"0.55\"/>"
          "</pattern></defs>\n", out);
    fprintf(out, "<rect width=\"%.0f\" height=\"%.0f\" fill=\"#fcfbf8\"/>\n", PAGE_WIDTH, height);
}

void page_end(FILE *out) { fputs("</svg>\n", out); }

/* U+FFFE and U+FFFF, which XML may not hold. */
static int is_no_character(const char *s, int bytes)
{
    return bytes == 3 && s[0] == '\xef' && s[1] == '\xbf' && (s[2] == '\xbe' || s[2] == '\xbf');
}

void page_text(FILE *out, const char *s, size_t most)
{
    for (size_t n = 0; *s && n < most; n++) {
        const int bytes = json_utf8(s);
        if (*s == '<') fputs("&lt;", out);
        else if (*s == '>') fputs("&gt;", out);
        else if (*s == '&') fputs("&amp;", out);
        else if (bytes == 0 || (unsigned char)*s < 32 || *s == 127 || is_no_character(s, bytes)) fputc('?', out);
        else fwrite(s, 1, (size_t)bytes, out);
        s += bytes ? bytes : 1;
    }
    if (*s) fputs("...", out);
}

void page_quantity(FILE *out, double x, const char *unit)
{
    static const char *const prefix[] = { "n", "&#181;", "m", "", "k", "M", "G", "T" };
    int k = 3;
    while (fabs(x) >= 999.5 && k < 7) { x /= 1000; k++; }
    while (fabs(x) > 0 && fabs(x) < 0.9995 && k > 0) { x *= 1000; k--; }
    fprintf(out, "%.3g %s%s", x, prefix[k], unit);
}

void page_label(FILE *out, double x, double y)
{
    fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"13\" fill=\"#333\">", x, y);
}

void page_arrow(FILE *out, const double a[2], const double b[2], const char *ink, double width, double head)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], length = sqrt(dx * dx + dy * dy);
    const double h = fmin(head, 0.6 * length), ux = dx / fmax(length, 1e-9), uy = dy / fmax(length, 1e-9);
    if (length < 1) return;
    for (int halo = width > 1; halo >= 0; halo--) {
        const char *color = halo ? "#ffffff" : ink;
        const double w = halo ? width + 1.8 : width;
        const char *dim = halo ? " stroke-opacity=\"0.75\"" : "";
        fprintf(out, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"%s\" stroke-width=\"%.1f\"%s fill=\"none\"/>", a[0], a[1],
                b[0] - ux * h * 0.8, b[1] - uy * h * 0.8, color, w, dim);
        fprintf(out, "<path d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fZ\" fill=\"%s\" stroke=\"%s\" stroke-width=\"%.1f\"%s/>\n",
                b[0], b[1], b[0] - ux * h - uy * h * 0.36, b[1] - uy * h + ux * h * 0.36, b[0] - ux * h + uy * h * 0.36,
                b[1] - uy * h - ux * h * 0.36, color, color, halo ? 1.8 : 0.0, dim);
    }
}
