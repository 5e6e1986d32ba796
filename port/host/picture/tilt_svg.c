#include "mind.h"
#include "page.h"
#include "tilt_svg.h"

#include <math.h>
#include <string.h>

#define DEGREE (3.14159265358979323846 / 180)
#define SIDE 560.0                      /* [px] */
#define RADIUS 210.0

static void polar_point(double radius, double azimuth, double *x, double *y)
{
    *x = SIDE / 2 + radius * cos(azimuth * DEGREE);
    *y = 312 - radius * sin(azimuth * DEGREE);
}

/* Circles of whole degrees, lines every 30. */
static void draw_grid(FILE *out, double most, double step)
{
    double x, y;
    for (double a = step; a <= most * (1 + 1e-9); a += step) {
        fprintf(out, "<circle cx=\"%.1f\" cy=\"312\" r=\"%.2f\" fill=\"none\" stroke=\"#bbb\" stroke-width=\"0.8\"/>\n",
                SIDE / 2, RADIUS * a / most);
        polar_point(RADIUS * a / most, 75, &x, &y);
        fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"11\" fill=\"#555\">%g&#176;</text>\n", x + 2, y - 3, a);
    }
    for (int k = 0; k < 12; k++) {
        polar_point(RADIUS, 30 * k, &x, &y);
        fprintf(out, "<path d=\"M%.1f 312L%.1f %.1f\" stroke=\"#ddd\" stroke-width=\"0.8\"/>\n", SIDE / 2, x, y);
        polar_point(RADIUS + 17, 30 * k, &x, &y);
        fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" font-size=\"12\" fill=\"#333\" text-anchor=\"middle\">%s</text>\n", x, y + 4,
                k == 0 ? "x" : k == 3 ? "y" : k == 6 ? "-x" : k == 9 ? "-y" : "");
    }
}

static int falls_level(const tilt_plot *p) { return !p->at_least && !(p->least > 0); }

static void draw_title(FILE *out, const tilt_plot *p)
{
    const char *slash = strrchr(p->path, '/');
    const double high = SIDE + 20 + MIND_ROW * mind_rows(p->told, 74);
    fprintf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\" "
            "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#fcfbf8\"/>\n", SIDE, high, SIDE, high);
    fputs("<text x=\"28\" y=\"36\" font-size=\"20\" font-weight=\"bold\" fill=\"#333\">", out);
    if (falls_level(p)) fputs("Does not stand while level", out);
    else fprintf(out, "Stands tilted by %s %.3g&#176;", p->at_least ? "at least" : "up to", p->least);
    fputs("<tspan font-weight=\"normal\" font-size=\"15\" dx=\"10\">", out);
    page_text(out, slash ? slash + 1 : p->path, 24);
    fputs("</tspan></text>\n<text x=\"28\" y=\"57\" font-size=\"13\" fill=\"#555\">", out);
    if (!falls_level(p)) fprintf(out, "worst towards azimuth %.4g&#176; (from x to y); ", p->azimuth);
    fprintf(out, "%s cone</text>\n", p->cone);
}

int tilt_svg(FILE *out, const tilt_plot *p)
{
    double most = 0, step, x, y;
    for (int k = 0; k < p->azimuths; k++) most = fmax(most, p->angle[k]);
    step = most > 50 ? 15 : most > 25 ? 10 : most > 10 ? 5 : most > 4 ? 2 : most > 1.5 ? 0.5 : 0.1;
    most = step * ceil(fmax(most, 1e-3) / step);
    draw_title(out, p);
    draw_grid(out, most, step);
    fputs("<path fill=\"#1b7837\" fill-opacity=\"0.25\" stroke=\"#1b7837\" stroke-width=\"2\" stroke-linejoin=\"round\" "
          "d=\"", out);
    for (int k = 0; k < p->azimuths; k++) {
        polar_point(RADIUS * p->angle[k] / most, 360.0 * k / p->azimuths, &x, &y);
        fprintf(out, "%s%.2f %.2f", k ? "L" : "M", x, y);
    }
    fputs("Z\"/>\n", out);
    polar_point(RADIUS * p->least / most, p->azimuth, &x, &y);
    fprintf(out, "<path d=\"M%.1f 312L%.2f %.2f\" stroke=\"#b2182b\" stroke-width=\"1.6\"/>"
            "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"4\" fill=\"#b2182b\"/>\n", SIDE / 2, x, y, x, y);
    fputs("<text x=\"28\" y=\"566\" font-size=\"12\" fill=\"#555\">green: tilts that admissible forces balance; with friction "
          "an upper value</text>\n", out);
    mind_write(out, p->told, 28, SIDE + 6 + MIND_ROW, 74);
    fputs("</svg>\n", out);
    return !ferror(out);
}
