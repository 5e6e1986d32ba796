#include "words.h"
#include "../motion.h"
#include "../reason.h"
#include "../weakest.h"
#include "mind.h"
#include "page.h"

#include <math.h>
#include <string.h>

#define ROW    MIND_ROW
#define LETTER 6.4                      /* width of one, more or less [px] */

/* The largest 1, 2 or 5 times a power of ten below x. */
static double round_below(double x)
{
    const double ten = pow(10, floor(log10(x)));
    return ten * (x / ten >= 5 ? 5 : x / ten >= 2 ? 2 : 1);
}

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static void put_friction(const words *w)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int32_t i = 0; i < w->d->s->count.joints; i++) {
        low = fmin(low, (double)w->d->s->joint[i].strength.mu);
        high = fmax(high, (double)w->d->s->joint[i].strength.mu);
    }
    if (!(low <= high)) return;
    fprintf(w->out, high > low ? ", friction %.4g to %.4g" : ", friction %.4g", low, high);
}

static int rubs(const sp_scene *s)
{
    for (int32_t i = 0; i < s->count.joints; i++) if (s->joint[i].strength.mu > 0) return 1;
    return 0;
}

/* What is known of a limit from both sides. */
static void put_bracket(FILE *out, const sp_limit_result *x)
{
    if (x->lower >= 0) fprintf(out, "forces carry %.9g", (double)x->lower);
    if (x->upper >= 0) fprintf(out, "%s mechanism falls at %.9g", x->lower < 0 ? "a" : ", a", (double)x->upper);
    if (x->lower < 0 && x->upper < 0) fputs("neither bound found", out);
    fputs(x->verified ? ", verified" : "", out);
}

static void title_of_limit(const words *w)
{
    const sp_limit_result *x = w->of->limit;
    fprintf(w->out, "<text x=\"%.0f\" y=\"40\" font-size=\"24\" font-weight=\"bold\" fill=\"#333\">", PAGE_MARGIN);
    if (x->kind == SP_LIMIT_FOUND) fprintf(w->out, "falls at %.6g", (double)x->multiplier);
    else fputs(x->kind == SP_LIMIT_NONE ? "falls" : x->kind == SP_LIMIT_UNBOUNDED ? "stands" : "undecided", w->out);
    fputs("<tspan font-weight=\"normal\" font-size=\"17\" fill=\"#333\" dx=\"12\">", w->out);
    fputs(x->kind == SP_LIMIT_FOUND ? "times its live loads: " : x->kind == SP_LIMIT_UNDECIDED ? "under its live loads: "
                                                               : "at any multiple of its live loads: ", w->out);
    page_text(w->out, file_name(w->of->scene->path), 50);
    fprintf(w->out, "</tspan></text>\n<text x=\"%.0f\" y=\"62\" font-size=\"13\" fill=\"#555\">%ld block%s, %ld joint%s",
            PAGE_MARGIN, (long)w->d->s->count.blocks, text_s(w->d->s->count.blocks), (long)w->d->s->count.joints,
            text_s(w->d->s->count.joints));
    put_friction(w);
    fprintf(w->out, "</text>\n<text x=\"%.0f\" y=\"80\" font-size=\"13\" fill=\"#555\">", PAGE_MARGIN);
    put_bracket(w->out, x);
    if (rubs(w->d->s) && (x->kind == SP_LIMIT_FOUND || x->kind == SP_LIMIT_UNBOUNDED))
        fputs("; with friction an upper value", w->out);
    if (x->kind == SP_LIMIT_UNDECIDED)
        fputs(x->reason == SP_REASON_BUDGET ? "; the search spent its budget" : "; the two do not meet at this tolerance",
              w->out);
    fputs("</text>\n", w->out);
}

/* How sure the verdict is, in a line. */
static void put_certainty(const words *w)
{
    const sp_result *x = w->of->result;
    if (x->verdict == SP_STABLE)
        fprintf(w->out, "largest imbalance of a block %.2g, tolerance %.2g", (double)x->imbalance, (double)x->tol);
    else if (x->verdict == SP_UNSTABLE && x->final) fputs("no joint forces of any size balance it", w->out);
    else if (x->reason == SP_REASON_NO_MOTION) fputs("forces exist, but no virtual motion explains any of them", w->out);
    else if (x->verdict == SP_UNSTABLE)
        fprintf(w->out, "at best a block stays unbalanced by %.2g of its forces", (double)x->least_imbalance);
    else fprintf(w->out, "%s, %.2g", reason_words(x->reason), (double)x->tol);
    if (x->verdict != SP_UNDECIDED) fputs(x->verified ? ", verified" : ", not verified", w->out);
}

static void title_of_check(const words *w)
{
    const sp_result *x = w->of->result;
    const char *word = x->verdict == SP_STABLE ? "stable" : x->verdict == SP_UNSTABLE ? "unstable" : "undecided";
    const char *more = w->of->level;
    const char *color = x->verdict == SP_STABLE ? "#1b7837" : x->verdict == SP_UNSTABLE ? INK_MOTION : "#8a6d00";
    const int32_t blocks = w->d->s->count.blocks;

    fprintf(w->out, "<text x=\"%.0f\" y=\"40\" font-size=\"24\" font-weight=\"bold\" fill=\"%s\">%s%s%s"
            "<tspan font-weight=\"normal\" font-size=\"17\" fill=\"#333\" dx=\"12\">", PAGE_MARGIN, color, word,
            more ? ", " : "", more ? more : "");
    page_text(w->out, file_name(w->of->scene->path), 60);
    fprintf(w->out, "</tspan></text>\n<text x=\"%.0f\" y=\"62\" font-size=\"13\" fill=\"#555\">", PAGE_MARGIN);
    fprintf(w->out, "%ld block%s, %ld of them free, %ld joint%s", (long)blocks, blocks == 1 ? "" : "s",
            (long)x->counts.free_blocks, (long)x->counts.joints, x->counts.joints == 1 ? "" : "s");
    put_friction(w);
    fputs("; largest compression ", w->out);
    page_quantity(w->out, (double)x->extremes.compression, "N");
    fputs(" at a corner</text>\n", w->out);
    fprintf(w->out, "<text x=\"%.0f\" y=\"80\" font-size=\"13\" fill=\"#555\">", PAGE_MARGIN);
    put_certainty(w);
    fputs("</text>\n", w->out);
}

void words_title(const words *w)
{
    if (w->of->limit) title_of_limit(w);
    else title_of_check(w);
}

/* -------------------------------------------------------------------------------------------------------------- legend */


static void legend_forces(const words *w, double x, double y)
{
    const double force = round_below(w->forces->largest), length = force * w->forces->scale * w->d->scale;
    const double a[2] = { x, y - 4 }, b[2] = { x + length, y - 4 };
    page_arrow(w->out, a, b, INK_FORCE, 1.7, 8);
    page_label(w->out, x + length + 10, y);
    page_quantity(w->out, force, "N");
    fputs(w->of->limit && w->of->motion ? ", force of a joint as it slides"
          : w->of->limit ? ", force of a joint at the limit"
          : w->of->result->verdict == SP_STABLE ? ", force of a joint on the block it holds"
          : ", best force that joints can give", w->out);
    fputs(w->forces->left_out ? "; where they crowd, the largest</text>\n" : "</text>\n", w->out);
}

static void legend_weakest(const words *w, double x, double y)
{
    const int32_t i = w->weakest;
    const sp_demand *help = &w->of->result->demand[i];
    const char *does = motion_of_joint(w->d->s, w->of->result, i);
    const weakest_joint nearest = weakest_nearest(w->d->s, w->of->result);
    char limit[WEAKEST_WORDS];
    fprintf(w->out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"26\" height=\"13\" fill=\"%s\" fill-opacity=\"0.35\" stroke=\"%s\" "
            "stroke-width=\"2\"%s/>\n", x, y - 11, INK_WEAK, INK_WEAK, w->behind ? " stroke-dasharray=\"5 3\"" : "");
    page_label(w->out, x + 36, y);
    fputs("weakest joint ", w->out);
    page_text(w->out, w->of->scene->name[w->d->s->joint[i].a], 20);
    fputs(" | ", w->out);
    page_text(w->out, w->of->scene->name[w->d->s->joint[i].b], 20);
    if (help->tension > 0 || help->friction > 0) {
        fputs(", lacks ", w->out);
        page_quantity(w->out, fmax((double)help->tension, (double)help->friction), "N");
        fputs(help->friction > help->tension ? " of friction" : " of tension", w->out);
    } else if (does) fprintf(w->out, ", %s", does);
    else {
        weakest_words(w->d->s, w->of->result, &nearest, limit);
        fprintf(w->out, ", %s", limit);
    }
    if (w->behind) fputs("; behind other blocks", w->out);
    fputs("</text>\n", w->out);
}

void words_motion(const words *w, double x, double y)
{
    const char *const virtual = w->of->result->level == SP_COUPLED
                              ? "A virtual motion that explains the forces, to "
                              : "A virtual motion that needs such help, to ";
    const char *const says = w->of->motion ? w->of->motion : motion_is_virtual(w->of->result) ? virtual
                           : "How it starts to move, drawn to ";
    const double wide = LETTER * (double)(strlen(says) + strlen(", drawn to 999 mm at most"));
    page_label(w->out, fmax(PAGE_MARGIN, fmin(x, PAGE_WIDTH - PAGE_MARGIN - wide)), y);
    fprintf(w->out, "%s%s", says, w->of->motion ? ", drawn to " : "");
    page_quantity(w->out, w->motion->largest, "m");
    fputs(" at most</text>\n", w->out);
}

static void legend_motion(const words *w, double x, double y)
{
    int c[3];
    faces_color(MARK_FALLS, c);
    fprintf(w->out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"26\" height=\"13\" fill=\"#%02x%02x%02x\" stroke=\"#555\"/>\n",
            x, y - 11, c[0], c[1], c[2]);
    page_label(w->out, x + 36, y);
    fputs("moves</text>\n", w->out);
}

/* Where names were asked for: how many had room. */
static void legend_names(const words *w, double x, double y)
{
    if (!w->of->names) return;
    page_label(w->out, x, y);
    fprintf(w->out, "names on %ld of %ld, where there is room</text>\n", (long)w->named[0],
            (long)w->d->s->count.blocks);
}

static void legend_support(const words *w, double x, double y)
{
    fprintf(w->out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"26\" height=\"13\" fill=\"#9ea6ae\"/><rect x=\"%.1f\" y=\"%.1f\" "
            "width=\"26\" height=\"13\" fill=\"url(#hatch)\" stroke=\"#555\"/>\n", x, y - 11, x, y - 11);
    page_label(w->out, x + 36, y);
    fputs("fixed</text>\n", w->out);
}

/* A length on the paper's horizontal, which parallel projection keeps. */
static void legend_length(const words *w, double x, double y)
{
    const double length = round_below(150 / w->d->scale), wide = length * w->d->scale;
    fprintf(w->out, "<path d=\"M%.1f %.1fv8m0 -4h%.1fm0 -4v8\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.3\"/>\n",
            x, y - 9, wide);
    page_label(w->out, x + wide + 8, y);
    page_quantity(w->out, length, "m");
    fputs("</text>\n", w->out);
}

/* Gravity where it is not straight down. */
static void legend_gravity(const words *w)
{
    const view_axes axes = view_level(w->d->s);
    const double size = view_length(w->d->s->gravity);
    double g[2], a[2] = { PAGE_WIDTH - 76, 32 }, b[2];
    if (!(size > 0) || -view_height(&axes, w->d->s->gravity) > size * (1 - 1e-12)) return;
    view_point(&w->d->v, w->d->s->gravity, g);
    b[0] = a[0] + 44 * g[0] / size;
    b[1] = a[1] - 44 * g[1] / size;
    page_arrow(w->out, a, b, "#333333", 1.7, 8);
    page_label(w->out, a[0] - 22, a[1] - 8);
    fputs("gravity</text>\n", w->out);
}

/* What the marks on the joints of a mechanism mean. */
static void legend_joints(const words *w, double x, double y)
{
    if (w->hinges) {
        fprintf(w->out, "<path d=\"M%.1f %.1fh22\" stroke=\"%s\" stroke-width=\"4\" stroke-linecap=\"round\"/>"
                "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4.5\" fill=\"#fff\" stroke=\"%s\" stroke-width=\"2\"/>\n",
                x + 3, y - 4, INK_HINGE, x + 3, y - 4, INK_HINGE);
        page_label(w->out, x + 36, y);
        fprintf(w->out, "%ld hinge%s</text>\n", (long)w->hinges, w->hinges == 1 ? "" : "s");
    }
    if (!w->slides) return;
    if (w->hinges) x += 150;
    fprintf(w->out, "<rect x=\"%.1f\" y=\"%.1f\" width=\"26\" height=\"13\" fill=\"%s\" fill-opacity=\"0.35\" stroke=\"%s\" "
            "stroke-width=\"2\"/>\n", x, y - 11, INK_SLIDE, INK_SLIDE);
    page_label(w->out, x + 36, y);
    fprintf(w->out, "%ld sliding joint%s</text>\n", (long)w->slides, w->slides == 1 ? "" : "s");
}

int words_legend_lines(const words *w)
{
    return 1 + mind_rows(&w->of->scene->remarks, 124)
         + (w->weakest >= 0 || w->of->limit) + (w->motion->shift > 0 || w->of->names);
}

void words_legend(const words *w, double y)
{
    const double second = 400;
    legend_support(w, PAGE_MARGIN, y);
    legend_length(w, PAGE_MARGIN + 110, y);
    if (w->forces->largest > 0) legend_forces(w, second, y);
    legend_gravity(w);
    if (w->weakest >= 0 || w->of->limit) y += ROW;
    if (w->weakest >= 0) legend_weakest(w, PAGE_MARGIN, y);
    legend_joints(w, PAGE_MARGIN, y);
    if (w->motion->shift > 0 || w->of->names) y += ROW;
    if (w->motion->shift > 0) legend_motion(w, PAGE_MARGIN, y);
    legend_names(w, PAGE_MARGIN + 110, y);
    mind_write(w->out, &w->of->scene->remarks, PAGE_MARGIN, y + ROW, 124);
}
