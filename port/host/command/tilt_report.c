#include "progress.h"
#include "tilt_report.h"
#include "../files/drawn.h"
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

static int put_margin(FILE *out, const void *of) { return tilt_svg(out, of); }

static int draw_margin(const report *r, const tilt_margin *m, failure *error)
{
    const tilt_plot plot = { m->angle, TILT_AZIMUTHS, m->least, m->azimuth, tilt_at_least(m), r->options->cone,
                             &r->scene->remarks };
    const int status = drawn_file(r->options->svg, put_margin, &plot, error);
    return status ? status : drawn_png(r->options->png, put_margin, &plot, error);
}

static void json_degrees(json_out *j, const char *key, int known, double x)
{
    if (known) json_real(j, key, x);
    else json_null(j, key);
}

static void print_json(const report *r, const tilt_margin *m)
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
    scene_remarks_json(&j, r->scene);
    json_close(&j, '}');
    putchar('\n');
}

static void print_text(const report *r, const tilt_margin *m)
{
    const char *path = r->scene->path;
    if (!m->stands) {
        printf("%s: %s", path, m->undecided ? "UNDECIDED while level" : "does not stand while level");
        report_near(stdout, r->scene);
        if (!r->options->quiet) remarks_print(stdout, &r->scene->remarks);
        return;
    }
    if (m->least >= 90) printf("%s: TILT MARGIN at least 90 degrees, towards every azimuth", path);
    else printf("%s: TILT MARGIN %s%.6g degrees, towards azimuth %g (from x to y)", path, tilt_at_least(m) ? "at least " : "",
                m->least, fmod(floor(100 * m->azimuth + 0.5) / 100, 360));
    report_near(stdout, r->scene);
    if (r->options->quiet) return;
    if (m->least < 90 && m->within > 1e-3 * m->least) {
        report_row(stdout, "how near");
        printf("known to within %.2g degrees only: tol counts against the weights, and the margin is small beside that\n",
               m->within);
    }
    if (m->worst.tol > 0) report_tol(stdout, r);
    report_row(stdout, "how");
    printf("%d azimuths and the lines of their mechanisms, %d undecided; with friction an upper value\n", TILT_AZIMUTHS,
           m->undecided);
    remarks_print(stdout, &r->scene->remarks);
}

int tilt_report(report *r, failure *error)
{
    const sp_settings *settings = &r->options->settings;
    tilt_margin m;
    void *memory;
    sp_status measured;
    int status = refuse_others(r->scene, error);
    if (status) return status;
    measured = tilt_measure(&r->scene->scene, settings, &m, &memory);
    progress_end();
    if (measured != SP_OK) status = scene_refused(r->scene, settings, measured, error);
    if (!status) status = draw_margin(r, &m, error);
    r->result.tol = m.worst.tol;
    if (!status && r->options->json) print_json(r, &m);
    if (!status && !r->options->json) print_text(r, &m);
    free(memory);
    return status ? status : m.undecided ? EXIT_UNDECIDED : m.stands ? 0 : EXIT_UNSTABLE;
}
