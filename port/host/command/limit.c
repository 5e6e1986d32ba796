/* limit: how much of the live loads does it carry, and what gives way? */
#include "../files/json_out.h"
#include "../motion.h"
#include "../run.h"
#include "../tilt.h"
#include "commands.h"
#include "jobs.h"
#include "outputs.h"
#include "progress.h"
#include "report.h"
#include "report_csv.h"
#include "report_html.h"
#include "sliding.h"
#include "tilt_report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int any_friction(const sp_scene *s)
{
    for (int32_t i = 0; i < s->count.joints; i++) if (s->joint[i].strength.mu > 0) return 1;
    return 0;
}

/* ---------------------------------------------------------------------------------------------------------------- JSON */

static void json_end(json_out *j, const char *key, sp_real x)
{
    if (x >= 0) json_real(j, key, (double)x);
    else json_null(j, key);
}

/* Is the multiplier so small that tol leaves little of it? tol counts against the loads. */
static int is_vague(const sp_limit_result *x)
{
    return x->kind == SP_LIMIT_FOUND && (double)x->within > 1e-3 * (double)x->multiplier;
}

/* Blocks that move. */
static void json_mechanism(json_out *j, const host_scene *s, const sp_real *of)
{
    json_open(j, "mechanism", '[');
    for (int32_t b = 0; b < s->scene.count.blocks; b++) {
        const sp_real *dq = of + 6 * (size_t)b;
        int moves = 0;
        for (int k = 0; k < 6; k++) moves |= dq[k] < 0 || dq[k] > 0;
        if (!moves) continue;
        json_open(j, NULL, '{');
        json_string(j, "block", s->name[b]);
        json_reals(j, "dq", dq, 6);
        json_close(j, '}');
    }
    json_close(j, ']');
}

static void json_joint(json_out *j, const host_scene *s, int32_t i, const sp_joint_motion *m)
{
    json_open(j, NULL, '{');
    json_string(j, "a", s->name[s->scene.joint[i].a]);
    json_string(j, "b", s->name[s->scene.joint[i].b]);
    json_string(j, "kind", sp_joint_text(m->kind));
    json_real(j, "opening", (double)m->opening);
    json_real(j, "slip", (double)m->slip);
    if (m->kind == SP_JOINT_HINGE) {
        json_open(j, "line", '[');
        json_reals(j, NULL, m->a, 3);
        json_reals(j, NULL, m->b, 3);
        json_close(j, ']');
    }
    json_close(j, '}');
}

/* What the joints do meanwhile. */
static void json_joints(json_out *j, const host_scene *s, const sp_real *dq)
{
    json_open(j, "joints", '[');
    for (int32_t i = 0; i < s->scene.count.joints; i++) {
        sp_joint_motion m;
        if (sp_joint_moves(&s->scene, dq, i, &m) == SP_OK && m.kind != SP_JOINT_RIGID) json_joint(j, s, i, &m);
    }
    json_close(j, ']');
}

static void json_cost(json_out *j, const report *r)
{
    const sp_cost *c = &r->limit->cost;
    json_open(j, "cost", '{');
    json_int(j, "flops", c->flops);
    json_int(j, "factorisations", c->factorisations);
    json_int(j, "iterations", c->iterations);
    json_int(j, "interior", c->interior);
    json_int(j, "peak_bytes", (int64_t)r->limit->peak_bytes);
    json_real(j, "seconds", r->cost.seconds);
    json_close(j, '}');
}

/* The multiple, from both sides, and what stands at none of it. */
static void json_multiplier(json_out *j, const sp_limit_result *x)
{
    if (x->kind == SP_LIMIT_FOUND) json_real(j, "multiplier", (double)x->multiplier + 0.0);   /* no -0 */
    else if (x->kind == SP_LIMIT_NONE) json_null(j, "multiplier");
    else json_string(j, "multiplier", sp_limit_text(x->kind));
    json_string(j, "kind", sp_limit_text(x->kind));
    json_string(j, "reason", sp_reason_text(x->reason));
    json_bool(j, "verified", x->verified);
    json_end(j, "lower", x->lower);
    json_end(j, "upper", x->upper);
    if (x->kind == SP_LIMIT_FOUND) json_real(j, "within", (double)x->within);
    else json_null(j, "within");
    json_bool(j, "vague", is_vague(x));
    if (x->dead == SP_UNDECIDED) json_null(j, "falls_under_dead_loads");
    else json_bool(j, "falls_under_dead_loads", x->dead == SP_UNSTABLE);
    json_end(j, "lowest", x->lowest);
}

static void print_json(const report *r)
{
    const sp_limit_result *x = r->limit;
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", r->scene->path);
    json_multiplier(&j, x);
    json_bool(&j, "upper_value_by_friction", any_friction(&r->scene->scene));
    json_string(&j, "cone", r->options->cone);
    json_bool(&j, "final", x->final);
    json_real(&j, "tol", (double)x->tol);
    json_string(&j, "tol_by", report_tol_by(r));
    json_real(&j, "force_bound", (double)x->force_bound);
    json_real(&j, "omega", (double)x->imbalance);
    json_real(&j, "least_imbalance", (double)x->least_imbalance);
    if (r->sliding) sliding_json(&j, r, r->sliding, &r->sliding_cost);
    json_mechanism(&j, r->scene, x->dq);
    json_joints(&j, r->scene, x->dq);
    json_cost(&j, r);
    json_int(&j, "memory_bytes", (int64_t)(r->scene->bytes + r->cost.bytes));
    scene_remarks_json(&j, r->scene);
    json_close(&j, '}');
    fputc('\n', stdout);
}

/* --------------------------------------------------------------------------------------------------------------- words */

static void print_joints(FILE *out, const report *r, sp_joint_kind kind, const char *label)
{
    enum { SHOWN = 6 };
    const host_scene *s = r->scene;
    int32_t n = 0;
    for (int32_t i = 0; i < s->scene.count.joints; i++) {
        sp_joint_motion m;
        if (sp_joint_moves(&s->scene, r->limit->dq, i, &m) != SP_OK || m.kind != kind || n++ >= SHOWN) continue;
        if (n == 1) report_row(out, label);
        fprintf(out, "%s%s - %s", n > 1 ? ", " : "", s->name[s->scene.joint[i].a], s->name[s->scene.joint[i].b]);
    }
    if (n > SHOWN) fprintf(out, " and %ld more", (long)(n - SHOWN));
    if (n) fputc('\n', out);
}

static void print_multiplier(FILE *out, const report *r)
{
    const sp_limit_result *x = r->limit;
    fprintf(out, "%s: ", r->scene->path);
    switch (x->kind) {
    case SP_LIMIT_FOUND:     fprintf(out, "MULTIPLIER %.9g", (double)x->multiplier + 0.0); break;
    case SP_LIMIT_NONE:      fputs("NONE: it falls whatever the multiple of the live loads", out); break;
    case SP_LIMIT_UNBOUNDED: fputs("UNBOUNDED: it carries arbitrarily large multiples of the live loads", out); break;
    default:                 fprintf(out, "UNDECIDED: %s", x->reason == SP_REASON_BUDGET
                                     ? "the search spent its budget" : "the two bounds do not meet at this tol");
    }
    report_near(out, x->kind == SP_LIMIT_UNBOUNDED ? 0 : r->scene->near, r->scene->inside, r->scene->across);
    if (r->options->quiet) return;
    report_row(out, "how sure");
    if (x->lower >= 0) fprintf(out, "forces carry %.12g, largest imbalance %.2g", (double)x->lower, (double)x->imbalance);
    if (x->upper >= 0) fprintf(out, "%sa mechanism falls at %.12g", x->lower >= 0 ? "; " : "", (double)x->upper);
    if (x->lower < 0 && x->upper < 0) fputs("neither bound found", out);
    fputs(x->verified ? "; verified\n" : "; NOT verified\n", out);
    if (is_vague(x)) {
        report_row(out, "how near");
        fprintf(out, "known to within %.2g only: tol %.2g counts against the loads, and the multiplier is small beside that\n",
                (double)x->within, (double)x->tol);
    }
    report_tol(out, r);
}

/* What the multiplier does not tell. */
static void print_reservations(FILE *out, const report *r)
{
    const sp_limit_result *x = r->limit;
    if (x->dead == SP_UNSTABLE && x->lowest >= 0) {
        report_row(out, "mind");
        fprintf(out, "it falls under the dead loads alone; live loads are found to hold it at %.9g times, maybe at less\n",
                (double)x->lowest);
    } else if (x->dead == SP_UNDECIDED && x->kind) {
        report_row(out, "mind");
        fputs("whether it stands under the dead loads alone was not decided\n", out);
    }
    if (!any_friction(&r->scene->scene) || (x->kind != SP_LIMIT_FOUND && x->kind != SP_LIMIT_UNBOUNDED)) return;
    report_row(out, "mind");
    fputs("with friction this is an upper value: real sliding does not open joints, and may fall at less\n", out);
}

static void print_text(FILE *out, const report *r)
{
    const sp_limit_result *x = r->limit;
    const sp_capacity *n = &r->scene->scene.count;
    int32_t moving = 0;
    print_multiplier(out, r);
    if (r->options->quiet) return;
    print_reservations(out, r);
    if (r->sliding) sliding_text(out, r, r->sliding, &r->sliding_cost);
    for (int32_t b = 0; b < n->blocks; b++) moving += motion_speed(&r->scene->scene, &r->result, b) > MOTION_STILL;
    if (moving) {
        report_row(out, "mechanism");
        fprintf(out, "%ld block%s\n", (long)moving, moving == 1 ? " moves" : "s move");
        print_joints(out, r, SP_JOINT_HINGE, "hinges");
        print_joints(out, r, SP_JOINT_SLIDING, "sliding");
        print_joints(out, r, SP_JOINT_OPEN, "opening");
    }
    report_row(out, "scene");
    fprintf(out, "%ld block%s, %ld joint%s%s\n", (long)n->blocks, n->blocks == 1 ? "" : "s", (long)n->joints,
            n->joints == 1 ? "" : "s", r->scene->found ? " found" : "");
    report_row(out, "cost");
    fprintf(out, "%ld factorisation%s, %ld of them interior-point, %.3g Mflop, %.1f KiB, %.3g ms\n",
            (long)x->cost.factorisations, text_s(x->cost.factorisations), (long)x->cost.interior,
            1e-6 * (double)x->cost.flops, (double)r->cost.bytes / 1024, 1e3 * r->cost.seconds);
    remarks_print(out, &r->scene->remarks);
}

/* ------------------------------------------------------------------------------------------------------------- command */

/* The live load of every block as --body asks; there must be one. */
static int set_body(host_scene *s, const options *o, failure *error)
{
    const double body = fabs(o->body[0]) + fabs(o->body[1]) + fabs(o->body[2]);
    int live = 0;
    scene_body(s, o->body);
    for (int32_t k = 0; k < s->scene.count.loads; k++) live |= s->scene.load[k].live;
    if (live || body > 0) return 0;
    return fail_with(error, EXIT_USAGE, s->path, 0, "limit needs a live load: `#@ live` lines, or --body");
}

/* Pictures, page, model and tables. */
static int draw(const report *r, failure *error)
{
    int status = report_draw(r, error);
    if (!status) status = report_html(r, print_text, error);
    return status || !r->options->csv ? status : report_csv(r, error);
}

static int limit_command(report *r, failure *error)
{
    sp_limit_result x;
    sp_sliding_result sliding;
    void *memory = NULL, *more = NULL;
    int status = 0;
    const sp_status e = run_limit(&r->scene->scene, &r->options->settings, &x, &r->cost, &memory);
    progress_end();
    if (e != SP_OK) status = scene_refused(r->scene, &r->options->settings, e, error);
    if (!status) {
        r->limit = &x;
        r->result.f = x.f;
        r->result.dq = x.dq;
        r->result.verdict = x.upper >= 0 ? SP_UNSTABLE : SP_UNDECIDED;
        r->result.extremes.weakest = -1;
        r->result.verified = x.verified;
        r->result.tol = x.tol;
        if (r->options->sliding) {
            r->sliding = &sliding;
            status = sliding_ask(r, &sliding, &r->sliding_cost, &more, error);
        }
    }
    if (!status) {
        status = draw(r, error);                        /* the answer is told in any case */
        if (r->options->json) print_json(r);
        else print_text(stdout, r);
        fflush(stdout);
    }
    free(memory);
    free(more);
    return status ? status : x.kind == SP_LIMIT_UNDECIDED ? EXIT_UNDECIDED : 0;
}

int command_limit(int argc, char **argv)
{
    failure error = { 0, "" };
    host_scene s;
    options o;
    report r;
    int status;

    status = options_read(argc, argv, " --json --forces --svg --png --html --out-obj --csv --view --names"
                          " --tol --cone --body --tilt --tilt-margin --budget --sliding --jobs"
                          SCENE_OPTIONS, &o,
                          &error);
    if (!status && o.files != 1) status = fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: limit needs one scene");
    if (!status) status = outputs_check(&o, NULL, &error);
    if (!status) status = outputs_check_obj("--out-obj", o.model, &error);
    if (!status) {
        memset(&r, 0, sizeof r);
        r.scene = &s;
        r.options = &o;
        progress_begin(o.quiet);
        o.settings.watch = progress_watch(o.file[0]);
        status = scene_read(o.file[0], &o.scene, &s, &error);
        if (!status) tilt_turn(o.tilt, o.azimuth, s.scene.gravity);
        if (!status && o.tilt_margin && (fabs(o.body[0]) > 0 || fabs(o.body[1]) > 0 || fabs(o.body[2]) > 0))
            status = fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: --tilt-margin and --body exclude each other");
        if (!status && !o.tilt_margin) status = set_body(&s, &o, &error);
        if (!status) status = jobs_begin(o.jobs, &o.settings.parallel, &error);
        if (!status) status = o.tilt_margin ? tilt_report(&r, &error) : limit_command(&r, &error);
        jobs_end();
        scene_free(&s);
    }
    if (status > EXIT_UNDECIDED) fprintf(stderr, "%s\n", error.line);
    return status;
}
