#include "../files/json_out.h"
#include "../motion.h"
#include "../weakest.h"
#include "report.h"

#include <math.h>

static void json_joints(json_out *j, const report *r)
{
    const sp_scene *s = &r->scene->scene;
    json_open(j, "interfaces_detail", '[');
    for (int32_t i = 0; i < s->count.joints; i++) {
        sp_joint_force f;
        if (sp_joint_resultant(s, &r->result, i, &f) != SP_OK) continue;
        json_open(j, NULL, '{');
        json_string(j, "a", r->scene->name[s->joint[i].a]);
        json_string(j, "b", r->scene->name[s->joint[i].b]);
        json_reals(j, "force", f.force, 3);
        json_reals(j, "point", f.point, 3);
        json_real(j, "min_fn", (double)f.min_fn);
        json_real(j, "max_fn", (double)f.max_fn);
        json_real(j, "utilisation", (double)f.utilisation);
        json_real(j, "corner_utilisation", (double)f.corner_utilisation);
        json_real(j, "tension", (double)r->result.demand[i].tension);
        json_real(j, "missing_friction", (double)r->result.demand[i].friction);
        json_close(j, '}');
    }
    json_close(j, ']');
}

static void json_mechanism(json_out *j, const report *r)
{
    const int falls = r->result.verdict == SP_UNSTABLE && !motion_is_virtual(&r->result);
    json_open(j, "mechanism", '[');
    for (int32_t b = 0; falls && b < r->scene->scene.count.blocks; b++) {
        if (!(motion_speed(&r->scene->scene, &r->result, b) > 0)) continue;
        json_open(j, NULL, '{');
        json_string(j, "block", r->scene->name[b]);
        json_reals(j, "dq", r->result.dq + 6 * (size_t)b, 6);
        json_close(j, '}');
    }
    json_close(j, ']');
}

static void json_overlaps(json_out *j, const host_scene *s)
{
    json_open(j, "overlaps", '[');
    for (int32_t i = 0; i < s->overlaps; i++) {
        json_open(j, NULL, '{');
        json_string(j, "a", s->name[s->overlap[i].a]);
        json_string(j, "b", s->name[s->overlap[i].b]);
        json_real(j, "depth", (double)s->overlap[i].depth);
        json_close(j, '}');
    }
    json_close(j, ']');
}

/* What was simulated and what not. */
static void json_effects(json_out *j, const sp_result *x)
{
    json_open(j, "effects", '{');
    for (int k = 0; k < SP_EFFECTS; k++) {
        json_open(j, sp_effect_text((sp_effect)k), '{');
        json_bool(j, "on", sp_effect_on(x->effect[k]));
        json_string(j, "why", sp_effect_why_text(x->effect[k]));
        json_close(j, '}');
    }
    json_close(j, '}');
    if (x->reason == SP_REASON_EFFECT) json_string(j, "missing_effect", sp_effect_text(x->missing));
}

/* Islands, where there are several. */
static void json_islands(json_out *j, const report *r)
{
    const sp_result *x = &r->result;
    json_open(j, "islands", '[');
    for (int32_t k = 0; x->islands.each && k < x->islands.count; k++) {
        json_open(j, NULL, '{');
        json_string(j, "first_block", r->scene->name[x->islands.each[k].block]);
        json_int(j, "blocks", x->islands.each[k].blocks);
        json_string(j, "verdict", sp_verdict_text(x->islands.each[k].verdict));
        json_string(j, "reason", sp_reason_text(x->islands.each[k].reason));
        if (r->options->settings.coupled.asked) {
            json_string(j, "coupled", sp_coupling_text(x->islands.each[k].coupling));
            json_string(j, "coupled_reason", sp_coupling_reason_text(x->islands.each[k].coupling_reason));
        }
        json_close(j, '}');
    }
    json_close(j, ']');
}

static void json_work(json_out *j, const sp_cost *c)
{
    json_int(j, "flops", c->flops);
    json_int(j, "factorisations", c->factorisations);
    json_int(j, "iterations", c->iterations);
    json_int(j, "interior", c->interior);
}

static void json_cost(json_out *j, const report *r)
{
    json_open(j, "cost", '{');
    json_work(j, &r->result.spent.total);
    json_int(j, "peak_bytes", (int64_t)r->result.spent.peak_bytes);
    json_real(j, "seconds", r->cost.seconds);
    json_open(j, "by_stage", '[');
    for (int32_t k = 0; k < r->options->settings.stage_count; k++) {
        json_open(j, NULL, '{');
        json_string(j, "stage", sp_stage_text(r->options->settings.stage[k]));
        json_work(j, &r->result.spent.by_stage[k]);
        json_close(j, '}');
    }
    if (r->options->settings.coupled.asked) {
        json_open(j, NULL, '{');
        json_string(j, "stage", "coupled");
        json_work(j, &r->result.coupled.cost);
        json_int(j, "bytes", (int64_t)r->coupled_bytes);
        json_close(j, '}');
    }
    json_close(j, ']');
    json_close(j, '}');
}

/* A proof by cases, and its size; with `whole` all of it. */
static void json_proof(json_out *j, const char *key, const sp_proof *p, sp_real margin, int whole)
{
    json_open(j, key, '{');
    json_int(j, "island", p->island);
    json_int(j, "nodes", p->nodes);
    json_int(j, "leaves", p->leaves);
    json_int(j, "multipliers", p->entries);
    json_real(j, "margin", (double)margin);
    if (whole) {
        json_open(j, "node", '[');
        for (int32_t k = 0; k < p->nodes; k++) json_int(j, NULL, p->node[k]);
        json_close(j, ']');
        json_open(j, "row", '[');
        for (int32_t k = 0; k < p->entries; k++) json_int(j, NULL, p->row[k]);
        json_close(j, ']');
        json_reals(j, "y", p->y, p->entries);
    }
    json_close(j, '}');
}

/* The coupled check; with --forces its whole triple, or proof. */
static void json_coupled(json_out *j, const report *r)
{
    const sp_coupled *c = &r->result.coupled;
    json_open(j, "coupled", '{');
    json_string(j, "verdict", sp_coupling_text(c->verdict));
    json_string(j, "reason", sp_coupling_reason_text(c->reason));
    json_real(j, "residual", (double)c->residual);
    json_int(j, "rounds", c->rounds);
    json_real(j, "eps", (double)c->eps);
    json_real(j, "eta", (double)c->eta);
    json_bool(j, "box", r->options->settings.coupled.box);
    if (c->tension_ratio >= 0) json_real(j, "tension_ratio", (double)c->tension_ratio);
    else json_null(j, "tension_ratio");
    if (c->proof.nodes) json_proof(j, "proof", &c->proof, c->margin, r->options->forces);
    if (r->options->forces) {
        json_open(j, "motion", '[');
        for (int32_t b = 0; b < r->scene->scene.count.blocks; b++) json_reals(j, NULL, c->dq + 6 * (size_t)b, 6);
        json_close(j, ']');
        json_reals(j, "alpha", c->alpha, r->scene->scene.count.points);
        json_open(j, "penalty", '[');
        for (int32_t k = 0; c->tension_ratio >= 0 && k < r->scene->scene.count.points; k++)
            json_reals(j, NULL, c->penalty + 4 * (size_t)k, 4);
        json_close(j, ']');
    }
    json_close(j, '}');
}

/* Rows of `width` numbers each. */
static void json_rows(json_out *j, const char *key, const sp_real *x, int32_t rows, int32_t width)
{
    json_open(j, key, '[');
    for (int32_t k = 0; k < rows; k++) json_reals(j, NULL, x + (size_t)k * (size_t)width, width);
    json_close(j, ']');
}

/* Whether friction holds it whatever it does; with --forces the forces and the motion that prove it. */
static void json_strong(json_out *j, const report *r)
{
    const sp_strong_result *x = r->strong;
    const sp_capacity *n = &r->scene->scene.count;
    json_open(j, "strong", '{');
    json_string(j, "verdict", sp_strong_text(x->kind));
    json_string(j, "reason", sp_strong_reason_text(x->reason));
    json_bool(j, "plate", x->plate);
    json_real(j, "residual", (double)x->residual);
    json_real(j, "moves", (double)x->moves);
    json_int(j, "starts", x->starts);
    json_int(j, "balls", x->balls);
    json_int(j, "leaves", x->proof.leaves);
    json_int(j, "flops", x->cost.flops);
    json_int(j, "peak_bytes", (int64_t)x->peak_bytes);
    json_real(j, "seconds", r->strong_cost.seconds);
    if (r->options->forces) {
        json_open(j, "proof", '{');
        json_rows(j, "forces", x->f, n->points, 3);
        json_rows(j, "moving", x->moving, n->points, 3);
        json_rows(j, "motion", x->a, n->blocks, 6);
        if (x->proof.nodes) json_proof(j, "cases", &x->proof, x->margin, 1);
        json_close(j, '}');
    }
    json_close(j, '}');
}

/* The published program's answer beside ours. */
static void json_published(json_out *j, const solvers_published *p)
{
    const ipopt_cra_answer *a = &p->answer;
    json_open(j, "published", '{');
    json_string(j, "solver", "ipopt");
    json_string(j, "status", a->status);
    json_bool(j, "solved", a->solved);
    json_bool(j, "verified", p->evidence.level == SP_COUPLED);
    json_real(j, "objective", a->objective);
    json_open(j, "residuals", '{');
    json_real(j, "balance", a->balance);
    json_real(j, "cone", a->cone);
    json_real(j, "contact", a->contact);
    json_real(j, "gap", a->gap);
    json_real(j, "slip", a->slip);
    json_real(j, "bound", a->bound);
    json_close(j, '}');
    json_int(j, "iterations", a->iterations);
    json_real(j, "seconds", a->seconds);
    json_close(j, '}');
}

/* All that a later `verify` needs: the question as it was put, and the force of every contact vertex. */
static void json_forces(json_out *j, const report *r)
{
    const sp_scene *s = &r->scene->scene;
    json_open(j, "asked", '{');
    json_string(j, "cone", r->options->cone);
    if (r->options->scene.mu >= 0) json_real(j, "mu", (double)r->options->scene.mu);
    else json_null(j, "mu");
    json_reals(j, "gravity", s->gravity, 3);
    json_close(j, '}');
    json_open(j, "forces", '[');
    for (int32_t k = 0; k < s->count.points; k++) json_reals(j, NULL, r->result.f + 3 * (size_t)k, 3);
    json_close(j, ']');
}

/* The question as it was read: its accuracy and its size. */
static void json_question(json_out *j, const report *r)
{
    const sp_result *x = &r->result;
    json_real(j, "tol", (double)x->tol);
    json_string(j, "tol_by", report_tol_by(r));
    json_real(j, "force_bound", (double)x->force_bound);
    json_int(j, "blocks", r->scene->scene.count.blocks);
    json_int(j, "free_blocks", x->counts.free_blocks);
    json_int(j, "interfaces", x->counts.joints);
    json_int(j, "contact_vertices", x->counts.points);
}

/* What words tell as the weakest joint of what stands: weakest_interface has most friction used, however little that is. */
static void json_nearest(json_out *j, const report *r)
{
    const weakest_joint w = weakest_nearest(&r->scene->scene, &r->result);
    if (r->result.verdict == SP_UNSTABLE || w.joint < 0) {
        json_null(j, "nearest_limit");
        return;
    }
    json_open(j, "nearest_limit", '{');
    json_int(j, "interface", w.joint);
    json_string(j, "by", weakest_text(w.by));
    json_real(j, "share", w.share);
    json_bool(j, "known", w.known);
    json_close(j, '}');
}

/* What stands for the verdict, in numbers. */
static void json_evidence(json_out *j, const report *r)
{
    const sp_result *x = &r->result;
    json_string(j, "stage", sp_stage_text(x->stage));
    json_real(j, "omega", (double)x->imbalance);
    json_real(j, "least_imbalance", (double)x->least_imbalance);
    json_real(j, "max_compression", (double)x->extremes.compression);
    json_real(j, "max_joint_compression", report_joint_compression(r));
    json_real(j, "max_tension", (double)x->extremes.tension);
    json_real(j, "max_utilisation", (double)x->extremes.utilisation);
    json_real(j, "max_corner_utilisation", (double)x->extremes.corner_utilisation);
    if (x->extremes.tension_ratio >= 0) json_real(j, "tension_ratio", (double)x->extremes.tension_ratio);
    else json_null(j, "tension_ratio");
    if (x->extremes.weakest >= 0) json_int(j, "weakest_interface", x->extremes.weakest);
    else json_null(j, "weakest_interface");
    json_nearest(j, r);
}

void report_json(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    json_out j = { out, 0 };

    json_open(&j, NULL, '{');
    json_string(&j, "scene", r->scene->path);
    json_string(&j, "verdict", sp_verdict_text(x->verdict));
    json_string(&j, "level", r->strong && r->strong->kind ? sp_strong_text(r->strong->kind) : sp_level_text(x->level));
    json_string(&j, "reason", sp_reason_text(x->reason));
    json_bool(&j, "verified", x->verified);
    json_bool(&j, "final", x->final);
    json_question(&j, r);
    json_evidence(&j, r);
    json_joints(&j, r);
    json_mechanism(&j, r);
    json_overlaps(&j, r->scene);
    json_effects(&j, &r->result);
    json_islands(&j, r);
    scene_remarks_json(&j, r->scene);
    json_cost(&j, r);
    json_int(&j, "memory_bytes", (int64_t)(r->scene->bytes + r->cost.bytes));
    if (r->options->settings.coupled.asked) json_coupled(&j, r);
    if (r->strong) json_strong(&j, r);
    if (r->published) json_published(&j, r->published);
    if (r->options->forces) json_forces(&j, r);
    json_close(&j, '}');
    fputc('\n', out);
}
