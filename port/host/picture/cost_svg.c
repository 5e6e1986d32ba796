/* The picture of a cost table: two panels, imbalance over flops and over time, logarithmic. Colour is the stage, shape
 * the kind of cone, a hollow mark an undecided check, a cross another verdict than the reference's. */
#include "cost_svg.h"
#include "mind.h"
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
    for (int k = 0; k < t->rows; k++) {
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

/* Kind of a cone: 0 true, 1 inscribed, 2 circumscribed. */
static int kind_of(const char *cone)
{
    const char last = cone[strlen(cone) - 1];
    return last == 'i' ? 1 : last == 'c' ? 2 : 0;
}

/* True cone: a disc; inscribed: a square; circumscribed: a triangle. Hollow: undecided. */
static void draw_shape(FILE *out, double x, double y, int kind, const char *ink, int decided)
{
    fprintf(out, "<g class=\"%s\" fill=\"%s\" fill-opacity=\"%s\" stroke=\"%s\" stroke-width=\"1.3\">",
            kind == 1 ? "square" : kind == 2 ? "triangle" : "disc", decided ? ink : "#fff", decided ? "0.75" : "0.6", ink);
    if (kind == 1) fprintf(out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"7\" height=\"7\"/>", x - 3.5, y - 3.5);
    else if (kind == 2) fprintf(out, "<path d=\"M%.1f %.1fl5 8.6h-10z\"/>", x, y - 5.4);
    else fprintf(out, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"5\"/>", x, y);
    fputs("</g>\n", out);
}

static void draw_cross(FILE *out, double x, double y)
{
    fprintf(out, "<path d=\"M%.1f %.1fl9 9m0 -9l-9 9\" stroke=\"#b2182b\" stroke-width=\"2.4\"/>\n", x - 4.5, y - 4.5);
}

static void draw_panel(FILE *out, const cost_table *t, double left, int time)
{
    const axes a = choose_axes(t, left, time);
    draw_grid(out, &a);
    for (int k = 0; k < t->rows; k++) {
        const cost_row *r = &t->row[k];
        const int wrong = r->verdict && t->truth && r->verdict != t->truth;
        const double x = px(&a, log_work(r, time)), y = py(&a, log_imbalance(r));
        if (wrong) draw_cross(out, x, y);
        else draw_shape(out, x, y, kind_of(r->cone), color[k / COST_TOLS / COST_CONES], r->verdict != SP_UNDECIDED);
    }
}

/* Colours in one line, shapes in the next. */
static void draw_legend(FILE *out, double y)
{
    static const char *const shape[] = { "true cone", "pyramid inside it", "pyramid around it" };
    for (int k = 0; k < COST_STAGES; k++)
        fprintf(out, "<rect x=\"%d\" y=\"%.0f\" width=\"14\" height=\"10\" fill=\"%s\"/>"
                "<text x=\"%d\" y=\"%.0f\">%s</text>\n", 60 + 130 * k, y - 5, color[k], 80 + 130 * k, y + 4, word[k]);
    y += 24;
    for (int k = 0; k < 3; k++) {
        draw_shape(out, 66 + 130 * k, y, k, "#444", 1);
        fprintf(out, "<text x=\"%d\" y=\"%.0f\">%s</text>\n", 80 + 130 * k, y + 4, shape[k]);
    }
    draw_shape(out, 66 + 130 * 3, y, 0, "#444", 0);
    fprintf(out, "<text x=\"%d\" y=\"%.0f\">hollow: undecided</text>\n", 80 + 130 * 3, y + 4);
    draw_cross(out, 66 + 130 * 4, y);
    fprintf(out, "<text x=\"%d\" y=\"%.0f\">another verdict</text>\n", 80 + 130 * 4, y + 4);
}

void cost_svg(FILE *out, const host_scene *s, const cost_table *t)
{
    const char *slash = strrchr(s->path, '/');
    const double width = 2 * PANEL_W + 190, height = TOP + PANEL_H + 96 + MIND_ROW * mind_rows(&s->remarks, 124);
    fprintf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\" "
            "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"11\" fill=\"#444\">\n"
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n", width, height, width, height);
    fputs("<text x=\"60\" y=\"26\" font-size=\"16\" font-weight=\"bold\" fill=\"#222\">What accuracy costs: ", out);
    page_text(out, slash ? slash + 1 : s->path, 60);
    fprintf(out, "</text>\n<text x=\"60\" y=\"46\">largest relative imbalance left by a check, %s; the exact stage "
            "says %s; pyramids of 4, 8, 16, 32 faces, tol %s", COST_REAL, sp_verdict_text(t->truth),
            sizeof(sp_real) == 8 ? "1e-2 to 1e-12" : "1e-2 to 1e-5");
    if (t->rows < COST_ROWS) fprintf(out, "; stopped after %d of %d checks", t->rows, COST_ROWS);
    fputs("</text>\n", out);
    draw_panel(out, t, 60, 0);
    draw_panel(out, t, PANEL_W + 150, 1);
    draw_legend(out, TOP + PANEL_H + 52);
    mind_write(out, &s->remarks, 60, TOP + PANEL_H + 52 + 24 + MIND_ROW, 124);
    fputs("</svg>\n", out);
}
