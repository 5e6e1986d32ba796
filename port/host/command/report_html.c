#include "html_page.h"
#include "../picture/page.h"
#include "../picture/turn.h"
#include "report_html.h"

#include <math.h>
#include <stdlib.h>

static void put_controls(FILE *out, int moves)
{
    fputs("<canvas id=\"view\" width=\"1400\" height=\"840\" tabindex=\"0\" role=\"img\" "
          "aria-label=\"The blocks. Arrow keys turn, plus and minus zoom, 0 goes back.\"></canvas>\n<p>", out);
    if (moves) fputs("<label>as it stands <input id=\"motion\" type=\"range\" min=\"0\" max=\"1\" step=\"0.05\" value=\"0\"> "
                     "as it starts to move</label>\n", out);
    fputs("<label><input id=\"forces\" type=\"checkbox\" checked> forces</label>\n"
          "<label><input id=\"labels\" type=\"checkbox\"> names</label>\n"
          "<button id=\"home\" type=\"button\">first view</button></p>\n"
          "<p>Drag, or with the picture in focus arrow keys, turn it; the wheel, + and - zoom. Grey: fixed.</p>\n", out);
}

static void put_name(FILE *out, const char *name)
{
    fputs("</td><td>", out);
    page_text(out, name, 60);
}

/* How a joint of a limit gives way. */
static void put_way(FILE *out, const report *r, int32_t i)
{
    sp_joint_motion m;
    const int moves = sp_joint_moves(&r->scene->scene, r->limit->dq, i, &m) == SP_OK && m.kind != SP_JOINT_RIGID;
    fputs(moves ? sp_joint_text(m.kind) : "-", out);
}

static void put_joint(FILE *out, const report *r, int32_t i)
{
    const sp_scene *s = &r->scene->scene;
    const sp_joint *j = &s->joint[i];
    sp_joint_force f;
    if (sp_joint_resultant(s, &r->result, i, &f) != SP_OK) return;
    const double fn = (double)(f.force[0] * j->n[0] + f.force[1] * j->n[1] + f.force[2] * j->n[2]);
    fprintf(out, "<tr><td><button type=\"button\">%ld</button>", (long)i);
    put_name(out, r->scene->name[j->a]);
    put_name(out, r->scene->name[j->b]);
    fprintf(out, "</td><td>%.4g</td><td>%.4g</td><td>%.0f</td><td>", (double)j->area, fn, 100 * (double)f.utilisation);
    if (r->limit) put_way(out, r, i);
    else fprintf(out, "%.3g", (double)fmax((double)r->result.demand[i].tension, (double)r->result.demand[i].friction));
    fputs("</td></tr>\n", out);
}

static void put_table(FILE *out, const report *r)
{
    static const char *const head[] = {
        "joint", "a", "b", "area [m\302\262]", "compression [N]", "friction used [%]", NULL };
    fputs("<h2>Joints</h2>\n<div class=\"wide\"><table id=\"joints\">\n<thead><tr>", out);
    for (int k = 0; k < 7; k++)
        fprintf(out, "<th scope=\"col\"><button type=\"button\">%s</button></th>",
                head[k] ? head[k] : r->limit ? "gives way" : "lacks [N]");
    fputs("</tr></thead>\n<tbody>\n", out);
    for (int32_t i = 0; i < r->scene->scene.count.joints; i++) put_joint(out, r, i);
    fputs("</tbody></table></div>\n", out);
}

/* A report, and how it is told. */
typedef struct telling { const report *r; report_words *words; } telling;

static int put_words(FILE *out, const void *of)
{
    const telling *t = of;
    options loud = *t->r->options;
    report r = *t->r;
    loud.quiet = 0;
    r.options = &loud;
    t->words(out, &r);
    return !ferror(out);
}

int report_html_body(FILE *out, const report *r)
{
    report_shown x;
    int good = report_show(r, &x);
    x.of.names = 0;
    if (good) {
        put_controls(out, turn_moves(&x.of));
        turn_legend(out, &x.of);
        put_table(out, r);
        good = turn_write(out, &x.of);
    }
    free(x.dq);
    return good;
}

static int put_body(FILE *out, const void *of) { return report_html_body(out, ((const telling *)of)->r); }

int report_html(const report *r, report_words *words, failure *error)
{
    const telling t = { r, words };
    const html_page page = { r->scene->path, r->limit ? sp_limit_text(r->limit->kind) : sp_verdict_text(r->result.verdict),
                             put_words, put_body, &t };
    return html_page_write(r->options->html, &page, error);
}
