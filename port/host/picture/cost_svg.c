/* The picture of a cost table: two panels, imbalance over flops and over time, logarithmic. Colour is the stage, shape the kind
 * of cone, a hollow mark an undecided check, a cross another verdict than the reference's. */
#include "cost_svg.h"
#include "page.h"

#include <math.h>
#include <string.h>

#define PANEL_W 380.0
#define PANEL_H 330.0
#define TOP     64.0

typedef struct axes { double left, low[2], high[2]; int time; } axes;      /* low, high: log10 */

static const char *const color[COST_STAGES] = { "#b8860b", "#4d9221", "#8e44ad", "#1d5fa6" };
static const char *const word[COST_STAGES] = { "least squares", "polish", "ADMM", "exact" };

static double log_work(const cost_row *r, int time)
{
    return log10(time ? fmax(r->seconds, 1e-7) * 1e3 : fmax((double)r->cost.flops, 1));
}

static double log_imbalance(const cost_row *r) { return log10(fmin(fmax(r->imbalance, 1e-17), 1)); }

static axes choose_axes(const cost_table *t, double left, int time)
{
    axes a = { left, { 1e9, -17 }, { -1e9, 0 }, time };
    for (int k = 0; k < COST_ROWS; k++) {
        a.low[0] = fmin(a.low[0], log_work(&t->row[k], time));
        a.high[0] = fmax(a.high[0], log_work(&t->row[k], time));
    }
    a.low[0] = floor(a.low[0]);
    a.high[0] = fmax(ceil(a.high[0]), a.low[0] + 1);
    return a;
}

static double px(const axes *a, double x) { return a->left + PANEL_W * (x - a->low[0]) / (a->high[0] - a->low[0]); }
static double py(const axes *a, double y) { return TOP + PANEL_H * (a->high[1] - y) / (a->high[1] - a->low[1]); }

static void draw_grid(FILE *out, const axes *a)
{
    for (double x = a->low[0]; x <= a->high[0] + 0.5; x++) {
        fprintf(out, "<path d=\"M%.1f %.1fv%.1f\" stroke=\"#e4e4e4\"/>\n", px(a, x), TOP, PANEL_H);
        fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">1e%.0f</text>\n", px(a, x), TOP + PANEL_H + 16, x);
    }
    for (double y = a->low[1] + 1; y <= a->high[1] + 0.5; y += 4) {
        fprintf(out, "<path d=\"M%.1f %.1fh%.1f\" stroke=\"#e4e4e4\"/>\n", a->left, py(a, y), PANEL_W);
        fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"end\">1e%.0f</text>\n", a->left - 5, py(a, y) + 4, y);
    }
    fprintf(out, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\">%s</text>\n", a->left + PANEL_W / 2, TOP + PANEL_H + 34,
            a->time ? "time of a check [ms]" : "work of a check [flop]");
}

/* True cone: a disc; inscribed: a square; circumscribed: a diamond. */
static void draw_mark(FILE *out, double x, double y, const cost_row *r, const char *ink, int wrong)
{
    const char kind = r->cone[strlen(r->cone) - 1];
    const char *fill = r->verdict ? ink : "none";
    if (wrong)
        fprintf(out, "<path d=\"M%.1f %.1fl8.0 8.0m0 -8.0l-8.0 8.0\" stroke=\"#b2182b\" stroke-width=\"2\"/>\n", x - 4, y - 4);
    else if (kind == 'i')
        fprintf(out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"6\" height=\"6\" fill=\"%s\" stroke=\"%s\"/>\n", x - 3, y - 3, fill,
                ink);
    else if (kind == 'c')
        fprintf(out, "<path d=\"M%.1f %.1fl4 4l-4 4l-4 -4z\" fill=\"%s\" stroke=\"%s\"/>\n", x, y - 4, fill, ink);
    else fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"%s\" stroke=\"%s\"/>\n", x, y, fill, ink);
}

static void draw_panel(FILE *out, const cost_table *t, double left, int time)
{
    const axes a = choose_axes(t, left, time);
    draw_grid(out, &a);
    for (int k = 0; k < COST_ROWS; k++) {
        const cost_row *r = &t->row[k];
        const int wrong = r->verdict && t->truth && r->verdict != t->truth;
        draw_mark(out, px(&a, log_work(r, time)), py(&a, log_imbalance(r)), r, color[k / COST_TOLS / COST_CONES], wrong);
    }
}

void cost_svg(FILE *out, const host_scene *s, const cost_table *t)
{
    const double width = 2 * PANEL_W + 190, height = TOP + PANEL_H + 96;
    fprintf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\" "
            "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"11\" fill=\"#444\">\n"
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n", width, height, width, height);
    fputs("<text x=\"60\" y=\"26\" font-size=\"16\" font-weight=\"bold\" fill=\"#222\">What accuracy costs: ", out);
    page_text(out, s->path, SIZE_MAX);
    fprintf(out, "</text>\n<text x=\"60\" y=\"46\">largest relative imbalance left by a check, %s; the exact stage "
            "says %s</text>\n", COST_REAL, sp_verdict_text(t->truth));
    draw_panel(out, t, 60, 0);
    draw_panel(out, t, PANEL_W + 150, 1);
    for (int k = 0; k < COST_STAGES; k++)
        fprintf(out, "<circle cx=\"%d\" cy=\"%.0f\" r=\"4\" fill=\"%s\"/><text x=\"%d\" y=\"%.0f\">%s</text>\n", 66 + 110 * k,
                height - 42, color[k], 76 + 110 * k, height - 38, word[k]);
    fprintf(out, "<text x=\"60\" y=\"%.0f\">disc: true cone, square: pyramid inside it, diamond: around it (4, 8, 16, 32 "
            "faces, tol %s); hollow: undecided; red cross: another verdict</text>\n</svg>\n", height - 16,
            sizeof(sp_real) == 8 ? "1e-2 to 1e-12" : "1e-2 to 1e-5");
}
