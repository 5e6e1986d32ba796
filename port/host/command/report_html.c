#include "../files/file.h"
#include "../picture/page.h"
#include "../picture/turn.h"
#include "report_html.h"

#include <string.h>

static const char style[] =
":root { color-scheme: light dark; --ink: #222; --paper: #fcfbf8; --line: #ccc; }\n"
"@media (prefers-color-scheme: dark) { :root { --ink: #e4e2dc; --paper: #1b1c1e; --line: #555; } }\n"
"body { margin: 0 auto; padding: 1rem; max-width: 72rem; font: 16px/1.45 Helvetica, Arial, sans-serif; color: var(--ink);\n"
"  background: var(--paper); }\n"
"h1 { font-size: 1.5rem; overflow-wrap: anywhere; }\n"
"dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; margin: 0 0 1rem; }\n"
"dt { opacity: .75; } dd { margin: 0; overflow-wrap: anywhere; }\n"
"canvas { width: 100%; height: auto; border: 1px solid var(--line); touch-action: none; cursor: grab; }\n"
"p label { margin-right: 1.2rem; white-space: nowrap; }\n"
":focus-visible { outline: 3px solid #2f7fd6; outline-offset: 1px; }\n"
"div { overflow-x: auto; } table { border-collapse: collapse; }\n"
"th, td { border-bottom: 1px solid var(--line); padding: .15rem .6rem; text-align: right; }\n"
"th button, td button { font: inherit; color: inherit; background: none; border: 0; text-decoration: underline; }\n";

/* What report_text says: its first line as the head, the others as terms and what is said of them. */
static void put_words(FILE *out, FILE *text)
{
    char line[1024];
    int lines = 0;
    while (fgets(line, sizeof line, text)) {
        char *said = line;
        line[strcspn(line, "\n")] = 0;
        if (lines++ == 0) {
            fputs("<h1>", out);
            page_text(out, line, 200);
            fputs("</h1>\n<dl>\n", out);
            continue;
        }
        fputs("<dt>", out);
        if (strlen(line) > 17 && line[0] == ' ') {      /* as report_row sets it */
            said = line + 17;
            for (size_t n = 16; n > 1 && line[n] == ' '; n--) line[n] = 0;
            page_text(out, line + 2, 14);
        }
        fputs("</dt><dd>", out);
        page_text(out, said, sizeof line);
        fputs("</dd>\n", out);
    }
    fputs(lines ? "</dl>\n" : "", out);
}

static void put_controls(FILE *out, int moves)
{
    fputs("<canvas id=\"view\" width=\"1400\" height=\"840\" tabindex=\"0\" role=\"img\" "
          "aria-label=\"The blocks. Arrow keys turn, plus and minus zoom, 0 goes back.\"></canvas>\n<p>", out);
    if (moves) fputs("<label>as it stands <input id=\"motion\" type=\"range\" min=\"0\" max=\"1\" step=\"0.05\" value=\"0\"> "
                     "as it starts to move</label>\n", out);
    fputs("<label><input id=\"forces\" type=\"checkbox\" checked> forces</label>\n"
          "<label><input id=\"labels\" type=\"checkbox\"> names</label>\n"
          "<button id=\"home\" type=\"button\">first view</button></p>\n"
          "<p>Drag, or with the picture in focus arrow keys, turn it; the wheel, + and - zoom. Grey: fixed. "
          "Orange: the weakest joint, or the one whose number was pressed.</p>\n", out);
}

static void put_name(FILE *out, const char *name)
{
    fputs("</td><td>", out);
    page_text(out, name, 60);
}

static void put_joint(FILE *out, const report *r, int32_t i)
{
    const sp_scene *s = &r->scene->scene;
    const sp_joint *j = &s->joint[i];
    const sp_demand *help = &r->result.demand[i];
    sp_joint_force f;
    if (sp_joint_resultant(s, &r->result, i, &f) != SP_OK) return;
    const double fn = (double)(f.force[0] * j->n[0] + f.force[1] * j->n[1] + f.force[2] * j->n[2]);
    fprintf(out, "<tr><td><button type=\"button\">%ld</button>", (long)i);
    put_name(out, r->scene->name[j->a]);
    put_name(out, r->scene->name[j->b]);
    fprintf(out, "</td><td>%.4g</td><td>%.4g</td><td>%.0f</td><td>%.3g</td></tr>\n", (double)j->area, fn,
            100 * (double)f.utilisation, (double)(help->tension > help->friction ? help->tension : help->friction));
}

static void put_table(FILE *out, const report *r)
{
    static const char *const head[] = {
        "joint", "a", "b", "area [m\302\262]", "compression [N]", "friction used [%]", "lacks [N]" };
    fputs("<h2>Joints</h2>\n<div><table id=\"joints\">\n<thead><tr>", out);
    for (int k = 0; k < 7; k++) fprintf(out, "<th scope=\"col\"><button type=\"button\">%s</button></th>", head[k]);
    fputs("</tr></thead>\n<tbody>\n", out);
    for (int32_t i = 0; i < r->scene->scene.count.joints; i++) put_joint(out, r, i);
    fputs("</tbody></table></div>\n", out);
}

static int put_page(FILE *out, const report *r, FILE *text)
{
    const subject of = { r->scene, &r->result, NULL, r->options->view, 0 };
    fputs("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
          "<meta name=\"viewport\" content=\"width=device-width\">\n<title>", out);
    page_text(out, r->scene->path, 100);
    fprintf(out, ": %s</title>\n<style>\n%s</style></head>\n<body>\n", sp_verdict_text(r->result.verdict), style);
    put_words(out, text);
    put_controls(out, turn_moves(&of));
    put_table(out, r);
    if (!turn_write(out, &of)) return 0;
    fputs("</body></html>\n", out);
    return 1;
}

int report_html(const report *r, failure *error)
{
    const char *path = r->options->html;
    FILE *text = tmpfile(), *out = text ? file_create(path, error) : NULL;
    int status = 0;
    if (!text) return fail_with(error, EXIT_INTERNAL, path, 0, "can't write: no temporary file");
    if (!out) {
        fclose(text);
        return error->status;
    }
    report_text(text, r);
    rewind(text);
    if (!put_page(out, r, text)) status = fail_with(error, EXIT_INTERNAL, path, 0, "can't write the page");
    fclose(text);
    return file_finish(out, path, status, error);
}
