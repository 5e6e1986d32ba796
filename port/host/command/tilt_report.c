#include "html_page.h"
#include "progress.h"
#include "report_csv.h"
#include "report_html.h"
#include "sliding.h"
#include "tilt_report.h"
#include "../files/csv_out.h"
#include "../files/drawn.h"
#include "../files/file.h"
#include "../files/json_out.h"
#include "../picture/tilt_svg.h"
#include "../tilt.h"

#include <math.h>
#include <stdlib.h>

/* Weights alone and joints without strength are what a margin is for.                           returns 0 or an exit status */
static int refuse_others(const host_scene *s, failure *error)
{
    for (int32_t k = 0; k < s->scene.count.loads; k++) {
        const sp_load *l = &s->scene.load[k];
        sp_real size = 0;
        for (int c = 0; c < 3; c++) size += l->force[c] * l->force[c] + l->couple[c] * l->couple[c];
        if (l->live || size > 0)
            return fail_with(error, EXIT_USAGE, s->path, 0, "--tilt-margin turns weights only, not the forces of this scene");
    }
    for (int32_t k = 0; k < s->scene.count.joints; k++) {
        const sp_strength *j = &s->scene.joint[k].strength;
        if (j->cohesion > 0 || j->tension > 0 || j->crushing > 0)
            return fail_with(error, EXIT_USAGE, s->path, 0,
                             "--tilt-margin is for joints without strength; check --tilt takes it along");
    }
    return 0;
}

/* Without dilatancy, towards both ways of a plane; n 0: not asked. */
typedef struct slides { tilt_slide way[TILT_SLIDES]; int n; } slides;

/* A margin, and the report it is of: of its worst azimuth a limit, whose mechanism is shown. */
typedef struct margin { const tilt_margin *m; const report *r; const slides *s; } margin;

static int put_margin(FILE *out, const void *of)
{
    const tilt_margin *m = ((const margin *)of)->m;
    const report *r = ((const margin *)of)->r;
    const tilt_plot plot = { r->scene->path, m->angle, TILT_AZIMUTHS, m->least, m->azimuth, tilt_at_least(m), r->options->cone,
                             &r->scene->remarks };
    return tilt_svg(out, &plot);
}

/* The mechanism of the worst azimuth, as that of any limit. */
static report of_worst(const report *r, const tilt_margin *m)
{
    report w = *r;
    w.limit = &m->worst;
    w.result.f = m->worst.f;
    w.result.dq = m->worst.dq;
    w.result.verdict = m->worst.upper >= 0 ? SP_UNSTABLE : SP_UNDECIDED;
    w.result.extremes.weakest = -1;
    w.result.verified = m->worst.verified;
    w.result.tol = m->worst.tol;
    return w;
}

static void json_degrees(json_out *j, const char *key, int known, double x)
{
    if (known) json_real(j, key, x);
    else json_null(j, key);
}

static void json_angle(json_out *j, const char *key, double x) { json_degrees(j, key, x >= 0, x); }

static void json_slides(json_out *j, const slides *s)
{
    json_open(j, "sliding", '[');
    for (int k = 0; k < s->n; k++) {
        const tilt_slide *t = &s->way[k];
        json_open(j, NULL, '{');
        json_real(j, "azimuth", t->azimuth);
        json_string(j, "kind", t->kind == SP_SLIDING_STATE ? "state" : "associative");
        json_string(j, "reason", sliding_reason(t->reason));
        json_angle(j, "upper", t->upper);
        json_angle(j, "associative", t->associative);
        json_angle(j, "lower", t->lower);
        json_angle(j, "lower_strong", t->lower_strong);
        json_real(j, "residual", t->residual);
        json_reals(j, "body", t->body, 3);
        json_close(j, '}');
    }
    json_close(j, ']');
}

static void print_slides(FILE *out, const slides *s)
{
    double safe = 90;
    for (int k = 0; k < s->n; k++) {
        const tilt_slide *t = &s->way[k];
        report_row(out, "real sliding");
        if (t->kind == SP_SLIDING_STATE)
            fprintf(out, "towards azimuth %g a sliding state at %.6g degrees; residual %.2g; verified\n", t->azimuth, t->upper,
                    t->residual);
        else if (t->reason == SP_SLIDING_NOT_ASKED)
            fprintf(out, "towards azimuth %g not asked: not a plane of the scene, or too many blocks\n", t->azimuth);
        else fprintf(out, "towards azimuth %g no state found\n", t->azimuth);
        if (t->reason != SP_SLIDING_NOT_ASKED && t->lower_strong < safe) safe = t->lower_strong;
    }
    if (!s->n) return;
    report_row(out, "for safety");
    if (safe > 0 && safe < 90)
        fprintf(out, "along that plane it stays up to %.6g degrees whatever friction does, proved\n", safe);
    else fputs("nothing proved: take no number from here\n", out);
}

static void print_json(const report *r, const tilt_margin *m, const slides *s)
{
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", r->scene->path);
    json_degrees(&j, "tilt_margin", m->stands, m->least);
    json_degrees(&j, "azimuth", m->stands, m->azimuth);
    json_degrees(&j, "within", m->stands && m->least < 90, m->within);
    json_bool(&j, "at_least", tilt_at_least(m));
    json_int(&j, "undecided", m->undecided);
    json_string(&j, "cone", r->options->cone);
    json_open(&j, "angles", '[');
    for (int k = 0; k < TILT_AZIMUTHS && m->stands; k++) json_real(&j, NULL, m->angle[k]);
    json_close(&j, ']');
    if (r->options->sliding) json_slides(&j, s);
    scene_remarks_json(&j, r->scene);
    json_close(&j, '}');
    putchar('\n');
}

static void print_text(FILE *out, const report *r, const tilt_margin *m, const slides *s, int quiet)
{
    const char *path = r->scene->path;
    if (!m->stands) {
        fprintf(out, "%s: %s", path, m->undecided ? "UNDECIDED while level" : "does not stand while level");
        report_near(out, r->scene->near, r->scene->inside, r->scene->across);
        if (!quiet) remarks_print(out, &r->scene->remarks);
        return;
    }
    if (m->least >= 90) fprintf(out, "%s: TILT MARGIN at least 90 degrees, towards every azimuth", path);
    else fprintf(out, "%s: TILT MARGIN %s%.6g degrees, towards azimuth %g (from x to y)", path,
                 tilt_at_least(m) ? "at least " : "", m->least, fmod(floor(100 * m->azimuth + 0.5) / 100, 360));
    report_near(out, r->scene->near, r->scene->inside, r->scene->across);
    if (quiet) return;
    if (m->least < 90 && m->within > 1e-3 * m->least) {
        report_row(out, "how near");
        fprintf(out, "known to within %.2g degrees only: tol counts against the weights, and the margin is small beside that\n",
               m->within);
    }
    if (m->worst.tol > 0) report_tol(out, r);
    report_row(out, "how");
    fprintf(out, "%d azimuths and the lines of their mechanisms, %d undecided; with friction an upper value\n", TILT_AZIMUTHS,
           m->undecided);
    print_slides(out, s);
    remarks_print(out, &r->scene->remarks);
}

/* ------------------------------------------------------------------------------------------------------ page, tables, model */

static int put_words(FILE *out, const void *of)
{
    const margin *t = of;
    print_text(out, t->r, t->m, t->s, 0);
    return !ferror(out);
}

static int put_angles(FILE *out, const tilt_margin *m)
{
    fputs("<h2>How far it may tilt</h2>\n<div><table>\n<thead><tr><th scope=\"col\">towards azimuth [degree]</th>"
          "<th scope=\"col\">stands up to [degree]</th></tr></thead>\n<tbody>\n", out);
    for (int k = 0; k < TILT_AZIMUTHS; k++)
        fprintf(out, "<tr><td>%g</td><td>%.6g</td></tr>\n", 360.0 * k / TILT_AZIMUTHS, m->angle[k]);
    fputs("</tbody></table></div>\n", out);
    return !ferror(out);
}

/* The plot; where it stands while level the mechanism of the worst azimuth; the angles. */
static int put_body(FILE *out, const void *of)
{
    const margin *t = of;
    const report worst = of_worst(t->r, t->m);
    int good;
    fputs("<div class=\"rose\">\n", out);
    good = put_margin(out, of);
    fputs("</div>\n", out);
    if (!t->m->stands) return good;
    if (good && t->m->worst.dq) {
        fprintf(out, "<h2>How it gives way, tilted towards %g degrees</h2>\n", t->m->azimuth);
        good = report_html_body(out, &worst);
    }
    return good && put_angles(out, t->m);
}

static int write_angles(const report *r, const tilt_margin *m, failure *error)
{
    char path[REPORT_CSV_PATH];
    FILE *out = report_csv_create(r->options, "tilt", path, error);
    csv_out c = { out, 0 };
    if (!out) return error->status;
    csv_header(&c, "azimuth_degree,stands_up_to_degree");
    for (int k = 0; k < TILT_AZIMUTHS && m->stands; k++) {
        csv_real(&c, 360.0 * k / TILT_AZIMUTHS);
        csv_real(&c, m->angle[k]);
        csv_end(&c);
    }
    return file_finish(out, path, 0, error);
}

/* Tables and model of the worst mechanism, as of a limit. */
static int write_worst(const report *r, const tilt_margin *m, failure *error)
{
    options o = *r->options;
    report worst = of_worst(r, m);
    int status = 0;
    if (!m->stands || !m->worst.dq) return 0;
    o.svg = o.png = NULL;                       /* those are the plot */
    worst.options = &o;
    if (o.csv) status = report_csv(&worst, error);
    return status ? status : report_draw(&worst, error);
}

static int draw_margin(const report *r, const tilt_margin *m, const slides *s, failure *error)
{
    const margin t = { m, r, s };
    const options *o = r->options;
    const html_page page = { r->scene->path, m->stands ? "tilt margin" : "falls level", put_words, put_body, &t };
    int status = drawn_file(o->svg, put_margin, &t, error);
    if (!status) status = drawn_png(o->png, put_margin, &t, error);
    if (!status) status = html_page_write(o->html, &page, error);
    if (!status && o->csv) status = write_angles(r, m, error);
    return status ? status : write_worst(r, m, error);
}

int tilt_report(report *r, failure *error)
{
    const sp_settings *settings = &r->options->settings;
    tilt_margin m;
    slides s;
    void *memory;
    sp_status measured;
    int status = refuse_others(r->scene, error);
    if (status) return status;
    s.n = 0;
    measured = tilt_measure(&r->scene->scene, settings, &m, &memory);
    progress_end();
    if (measured != SP_OK) status = scene_refused(r->scene, settings, measured, error);
    r->result.tol = m.worst.tol;
    if (!status && r->options->sliding && m.stands) {
        const sp_status slid = tilt_slides(&r->scene->scene, settings, s.way, &s.n);
        progress_end();
        if (slid != SP_OK) status = scene_refused(r->scene, settings, slid, error);
    }
    if (!status) {
        status = draw_margin(r, &m, &s, error);         /* the answer is told in any case */
        if (r->options->json) print_json(r, &m, &s);
        else print_text(stdout, r, &m, &s, r->options->quiet);
        fflush(stdout);
    }
    free(memory);
    return status ? status : m.undecided ? EXIT_UNDECIDED : m.stands ? 0 : EXIT_UNSTABLE;
}
