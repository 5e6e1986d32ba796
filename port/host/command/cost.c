/* cost: what accuracy costs on one scene: cones, stages and tolerances side by side, as a table, a picture, JSON. */
#include "../files/drawn.h"
#include "../files/json_out.h"
#include "../picture/cost_svg.h"
#include "../run.h"
#include "../tilt.h"
#include "commands.h"
#include "outputs.h"
#include "progress.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const cone_name[COST_CONES] = { "true", "4i", "4c", "8i", "8c", "16i", "16c", "32i", "32c" };
static const sp_stage_id stage_id[COST_STAGES] = { SP_STAGE_LEAST_SQUARES, SP_STAGE_POLISH, SP_STAGE_ADMM, SP_STAGE_EXACT };

#ifdef SP_REAL_FLOAT
static const double tol_of[COST_TOLS] = { 1e-2, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5 };
#else
static const double tol_of[COST_TOLS] = { 1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12 };
#endif

static void show_progress(int k, const cost_row *r)
{
    if (!r) progress_end();
    else progress_show("%d of %d: %s, cone %s, tol %.0e ...", k + 1, COST_ROWS, sp_stage_text(r->stage), r->cone, r->tol);
}

/* One check, three times where that is quick; the best time counts. */
static sp_status check_timed(const host_scene *s, const sp_settings *set, cost_row *row)
{
    double spent = 0;
    for (int k = 0; k < 3 && spent < 0.03; k++) {
        sp_result r;
        run_cost cost = { 0, 0 };
        void *memory = NULL;
        const sp_status status = run_check(&s->scene, set, &r, &cost, &memory);
        free(memory);
        if (status) return status;
        spent += cost.seconds;
        row->seconds = k && row->seconds < cost.seconds ? row->seconds : cost.seconds;
        row->verdict = r.verdict;
        row->reason = r.reason;
        row->imbalance = (double)r.imbalance;
        row->least = (double)r.least_imbalance;
        row->cost = r.spent.total;
        row->bytes = r.spent.peak_bytes;
    }
    return SP_OK;
}

/* The verdict others are compared with: the exact stage, the true cone, the least tol that decides. */
static sp_status find_reference(const host_scene *s, const sp_settings *base, cost_table *t)
{
    for (int k = COST_TOLS - 1; k >= 0; k--) {
        sp_settings set = *base;
        cost_row row;
        set.tol = (sp_real)tol_of[k];
        const sp_status status = check_timed(s, &set, &row);
        if (status) return status;
        t->truth = row.verdict;
        t->truth_tol = tol_of[k];
        if (k == COST_TOLS - 1 || row.cost.flops > t->truth_flops) t->truth_flops = row.cost.flops;
        if (row.verdict) return SP_OK;
    }
    return SP_OK;
}

/* Ctrl-C: the table ends with the checks made so far. */
static sp_status stop(cost_table *t, int rows)
{
    progress_end();
    t->rows = rows;
    return SP_OK;
}

/* base: all but cone, stages and tol.     returns as sp_check; progress goes to a terminal's stderr */
static sp_status cost_measure(const host_scene *s, const sp_settings *base, cost_table *t)
{
    sp_settings set = *base;
    memset(t, 0, sizeof *t);
    set.localise = 0;
    sp_status status = find_reference(s, &set, t);
    t->budget = base->budget ? base->budget : t->truth_flops > 1000000 ? 100 * t->truth_flops : 100000000;
    for (int k = 0; k < COST_ROWS && !status; k++) {
        cost_row *row = &t->row[k];
        row->cone = cone_name[k / COST_TOLS % COST_CONES];
        row->stage = stage_id[k / COST_TOLS / COST_CONES];
        row->tol = tol_of[k % COST_TOLS];
        if (progress_stopped()) return stop(t, k);
        show_progress(k, row);
        options_cone(row->cone, &set);
        set.tol = (sp_real)row->tol;
        set.budget = t->budget;
        set.stage_count = 2;
        set.stage[1] = row->stage;
        status = check_timed(s, &set, row);
        t->rows = k + 1;
    }
    show_progress(0, NULL);
    return status;
}

/* ---------------------------------------------------------------------------------------------------------------- table */

static int is_wrong(const cost_table *t, const cost_row *r) { return r->verdict && t->truth && r->verdict != t->truth; }

static const char *scaled(double x, char *text, size_t size)
{
    static const char unit[] = " kMGTP";
    int k = 0;
    for (; x >= 999.5 && unit[k + 1]; k++) x /= 1000;
    snprintf(text, size, x < 9.95 && k ? "%.1f%c" : "%.0f%c", x, unit[k]);
    return text;
}

/* S stable, U unstable, ? undecided, ! after it: not the verdict of the reference. */
static void table_cell(FILE *out, const cost_table *t, const cost_row *r)
{
    char flops[16];
    scaled((double)r->cost.flops, flops, sizeof flops);
    fprintf(out, "  %c%c%5s %7.0e", "?SU"[r->verdict], is_wrong(t, r) ? '!' : ' ', flops, r->imbalance);
}

/* Share of the friction that a pyramid takes away or adds. */
static double friction_gained(const char *cone)
{
    const int faces = (int)strtol(cone, NULL, 10);
    const double c = faces ? cos(3.14159265358979323846 / faces) : 1;
    return cone[strlen(cone) - 1] == 'i' ? c - 1 : 1 / c - 1;
}

static const cost_row *find_row(const cost_table *t, sp_stage_id stage, const char *cone, int tol)
{
    for (int k = 0; k < t->rows; k++)
        if (t->row[k].stage == stage && strcmp(t->row[k].cone, cone) == 0 && k % COST_TOLS == tol) return &t->row[k];
    return NULL;
}

/* What each pyramid does to friction and work, exact stage, at the tol that decides: one line each. */
static void table_words(FILE *out, const cost_table *t)
{
    int k = 0;
    while (k + 1 < COST_TOLS && tol_of[k] > t->truth_tol * 1.01) k++;
    const cost_row *exact = find_row(t, SP_STAGE_EXACT, "true", k);
    fputs("\npyramids against the true cone, exact stage:\n", out);
    for (int c = 1; c < COST_CONES; c++) {
        const cost_row *r = find_row(t, SP_STAGE_EXACT, cone_name[c], k);
        const double work = exact->cost.flops ? (double)r->cost.flops / (double)exact->cost.flops : 1;
        const double share = 100 * friction_gained(cone_name[c]);
        const char *verdict = is_wrong(t, r) ? "another verdict" : r->verdict ? "same verdict" : "undecided";
        fprintf(out, "  %-4s %s %.1f %% of the friction at its worst direction, costs %.2f times the work: %s\n", cone_name[c],
                share < 0 ? "takes" : "adds up to", fabs(share), work, verdict);
    }
}

static void cost_text(FILE *out, const host_scene *s, const cost_table *t, int quiet)
{
    char flops[16];
    fprintf(out, "%s: %s by the exact stage with the true cone at tol %.0e: %ld joint%s, %ld contact point%s", s->path,
            sp_verdict_text(t->truth), t->truth_tol, (long)s->scene.count.joints, text_s(s->scene.count.joints),
            (long)s->scene.count.points, text_s(s->scene.count.points));
    report_near(out, t->truth == SP_STABLE ? 0 : s->near, s->inside, s->across);
    if (quiet) return;
    fprintf(out, "S stable, U unstable, ? undecided, ! another verdict; flops, imbalance; no check above %s flop; "
            "ms: the tightest tol\n\n", scaled((double)t->budget, flops, sizeof flops));
    fprintf(out, "%-18s", "stage, cone   tol:");
    for (int k = 0; k < COST_TOLS; k++) fprintf(out, "%17.0e", tol_of[k]);
    fputs("        ms\n", out);
    for (int k = 0; k < t->rows; k++) {
        const cost_row *r = &t->row[k];
        const int cone = k / COST_TOLS % COST_CONES;
        if (k % COST_TOLS == 0) fprintf(out, "%s%-13s %-4s", k && cone == 0 ? "\n" : "", sp_stage_text(r->stage), r->cone);
        table_cell(out, t, r);
        if (k % COST_TOLS == COST_TOLS - 1) fprintf(out, "%10.3g\n", 1e3 * r->seconds);
    }
    if (t->rows < COST_ROWS) fprintf(out, "\nstopped after %d of %d checks\n", t->rows, COST_ROWS);
    else table_words(out, t);
    remarks_print(out, &s->remarks);
}

/* ----------------------------------------------------------------------------------------------------------------- JSON */

static void cost_json(FILE *out, const host_scene *s, const cost_table *t)
{
    json_out j = { out, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", s->path);
    json_string(&j, "real", COST_REAL);
    json_string(&j, "verdict", sp_verdict_text(t->truth));
    json_real(&j, "verdict_tol", t->truth_tol);
    json_int(&j, "blocks", s->scene.count.blocks);
    json_int(&j, "interfaces", s->scene.count.joints);
    json_int(&j, "contact_vertices", s->scene.count.points);
    json_int(&j, "budget", t->budget);
    json_open(&j, "checks", '[');
    for (int k = 0; k < t->rows; k++) {
        const cost_row *r = &t->row[k];
        json_open(&j, NULL, '{');
        json_string(&j, "cone", r->cone);
        json_string(&j, "stage", sp_stage_text(r->stage));
        json_real(&j, "tol", r->tol);
        json_string(&j, "verdict", sp_verdict_text(r->verdict));
        json_string(&j, "reason", sp_reason_text(r->reason));
        json_bool(&j, "wrong", is_wrong(t, r));
        json_real(&j, "omega", r->imbalance);
        json_real(&j, "least_imbalance", r->least);
        json_int(&j, "flops", r->cost.flops);
        json_int(&j, "factorisations", r->cost.factorisations);
        json_int(&j, "iterations", r->cost.iterations);
        json_int(&j, "peak_bytes", (int64_t)r->bytes);
        json_real(&j, "seconds", r->seconds);
        json_close(&j, '}');
    }
    json_close(&j, ']');
    scene_remarks_json(&j, s);
    json_close(&j, '}');
    fputc('\n', out);
}

/* -------------------------------------------------------------------------------------------------------------- command */

typedef struct measured { const host_scene *scene; const cost_table *table; } measured;

static int put_table(FILE *out, const void *of)
{
    const measured *m = of;
    cost_svg(out, m->scene, m->table);
    return 1;
}

static int draw_table(const options *o, const host_scene *s, const cost_table *t, failure *error)
{
    const measured m = { s, t };
    const int status = drawn_file(o->svg, put_table, &m, error);
    return status ? status : drawn_png(o->png, put_table, &m, error);
}

int command_cost(int argc, char **argv)
{
    static cost_table table;
    failure error = { 0, "" };
    host_scene s;
    options o;
    sp_status status = SP_OK;
    int code = options_read(argc, argv, " --json --svg --png --tilt --budget" SCENE_OPTIONS, &o, &error);

    memset(&s, 0, sizeof s);
    if (!code && o.files != 1) code = fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: cost needs one scene");
    if (!code) code = outputs_check(&o, NULL, &error);
    if (!code) code = scene_read(o.file[0], &o.scene, &s, &error);
    if (!code) tilt_turn(o.tilt, o.azimuth, s.scene.gravity);
    progress_begin(o.quiet);
    progress_hear();
    if (!code) status = cost_measure(&s, &o.settings, &table);
    if (status) code = scene_refused(&s, &o.settings, status, &error);
    if (!code) {
        code = draw_table(&o, &s, &table, &error);      /* the answer is told in any case */
        if (o.json) cost_json(stdout, &s, &table);
        else cost_text(stdout, &s, &table, o.quiet);
        fflush(stdout);
        if (!code) code = table.rows < COST_ROWS ? EXIT_STOPPED : report_exit(table.truth);
    }
    if (error.status) fprintf(stderr, "%s\n", error.line);
    scene_free(&s);
    return code;
}
