#include "../motion.h"
#include "../files/json_out.h"
#include "../picture/svg.h"
#include "report.h"

#include <math.h>
#include <string.h>

int report_exit(sp_verdict verdict)
{
    return verdict == SP_STABLE ? EXIT_STABLE : verdict == SP_UNSTABLE ? EXIT_UNSTABLE : EXIT_UNDECIDED;
}

/* ---------------------------------------------------------------------------------------------------------------- JSON */

static void json_interfaces(json_out *j, const report *r)
{
    const sp_scene *s = &r->scene->scene;
    json_open(j, "interfaces_detail", '[');
    for (int32_t i = 0; i < s->count.interfaces; i++) {
        sp_interface_force f;
        if (sp_interface_resultant(s, &r->result, i, &f) != SP_OK) continue;
        json_open(j, NULL, '{');
        json_string(j, "a", r->scene->name[s->interface[i].a]);
        json_string(j, "b", r->scene->name[s->interface[i].b]);
        json_reals(j, "force", f.force, 3);
        json_reals(j, "point", f.point, 3);
        json_real(j, "min_fn", (double)f.min_fn);
        json_real(j, "max_fn", (double)f.max_fn);
        json_real(j, "utilisation", (double)f.utilisation);
        json_real(j, "tension", (double)r->result.demand[i].tension);
        json_real(j, "missing_friction", (double)r->result.demand[i].friction);
        json_close(j, '}');
    }
    json_close(j, ']');
}

static void json_mechanism(json_out *j, const report *r)
{
    json_open(j, "mechanism", '[');
    for (int32_t b = 0; r->result.verdict == SP_UNSTABLE && !motion_is_virtual(&r->result) && b < r->scene->scene.count.blocks; b++) {
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

/* What was simulated and what not; islands where there are several. */
static void json_effects(json_out *j, const report *r)
{
    const sp_result *x = &r->result;
    json_open(j, "effects", '{');
    for (int k = 0; k < SP_EFFECTS; k++) {
        json_open(j, sp_effect_text((sp_effect)k), '{');
        json_bool(j, "on", sp_effect_on(x->effect[k]));
        json_string(j, "why", sp_effect_why_text(x->effect[k]));
        json_close(j, '}');
    }
    json_close(j, '}');
    if (x->reason == SP_REASON_EFFECT) json_string(j, "missing_effect", sp_effect_text(x->missing));
    json_open(j, "islands", '[');
    for (int32_t k = 0; x->part && k < x->islands; k++) {
        json_open(j, NULL, '{');
        json_string(j, "first_block", r->scene->name[x->part[k].block]);
        json_int(j, "blocks", x->part[k].blocks);
        json_string(j, "verdict", sp_verdict_text(x->part[k].verdict));
        json_string(j, "reason", sp_reason_text(x->part[k].reason));
        if (r->options->settings.coupled.asked) {
            json_string(j, "coupled", sp_coupling_text(x->part[k].coupling));
            json_string(j, "coupled_reason", sp_coupling_reason_text(x->part[k].coupling_reason));
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
    json_work(j, &r->result.cost);
    json_int(j, "peak_bytes", (int64_t)r->result.peak_bytes);
    json_real(j, "seconds", r->cost.seconds);
    json_open(j, "by_stage", '[');
    for (int32_t k = 0; k < r->options->settings.stage_count; k++) {
        json_open(j, NULL, '{');
        json_string(j, "stage", sp_stage_text(r->options->settings.stage[k]));
        json_work(j, &r->result.by_stage[k]);
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

/* What refutes, and its size; with `whole` all of it. */
static void json_proof(json_out *j, const sp_coupled *c, int whole)
{
    const sp_proof *p = &c->proof;
    json_open(j, "proof", '{');
    json_int(j, "island", p->island);
    json_int(j, "nodes", p->nodes);
    json_int(j, "leaves", p->leaves);
    json_int(j, "multipliers", p->entries);
    json_real(j, "margin", (double)c->margin);
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
    if (c->proof.nodes) json_proof(j, c, r->options->forces);
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
    if (r->options->mu >= 0) json_real(j, "mu", (double)r->options->mu);
    else json_null(j, "mu");
    json_reals(j, "gravity", s->gravity, 3);
    json_close(j, '}');
    json_open(j, "forces", '[');
    for (int32_t k = 0; k < s->count.points; k++) json_reals(j, NULL, r->result.f + 3 * (size_t)k, 3);
    json_close(j, ']');
}

const char *report_tol_by(const report *r)
{
    const sp_scene *s = &r->scene->scene;
    sp_real least = 1;
    if (!(r->result.tol < r->options->settings.tol)) return "asked";
    for (int32_t i = 0; i < s->count.interfaces; i++) {
        const sp_real mu = s->interface[i].joint.mu;
        if (mu > 0 && mu < least) least = mu;
    }
    return least / 8 <= r->result.tol ? "least friction" : "coupled";
}

void report_json(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    json_out j = { out, 0 };

    json_open(&j, NULL, '{');
    json_string(&j, "scene", r->scene->path);
    json_string(&j, "verdict", sp_verdict_text(x->verdict));
    json_string(&j, "level", sp_level_text(x->level));
    json_string(&j, "reason", sp_reason_text(x->reason));
    json_bool(&j, "verified", x->verified);
    json_bool(&j, "final", x->final);
    json_real(&j, "tol", (double)x->tol);
    json_string(&j, "tol_by", report_tol_by(r));
    json_real(&j, "force_bound", (double)x->force_bound);
    json_int(&j, "blocks", r->scene->scene.count.blocks);
    json_int(&j, "free_blocks", x->free_blocks);
    json_int(&j, "interfaces", x->interfaces);
    json_int(&j, "contact_vertices", x->points);
    json_string(&j, "stage", sp_stage_text(x->stage));
    json_real(&j, "omega", (double)x->omega);
    json_real(&j, "least_imbalance", (double)x->least_imbalance);
    json_real(&j, "max_compression", (double)x->max_compression);
    json_real(&j, "max_tension", (double)x->max_tension);
    json_real(&j, "max_utilisation", (double)x->max_utilisation);
    if (x->tension_ratio >= 0) json_real(&j, "tension_ratio", (double)x->tension_ratio);
    else json_null(&j, "tension_ratio");
    if (x->weakest >= 0) json_int(&j, "weakest_interface", x->weakest);
    else json_null(&j, "weakest_interface");
    json_interfaces(&j, r);
    json_mechanism(&j, r);
    json_overlaps(&j, r->scene);
    json_effects(&j, r);
    json_cost(&j, r);
    json_int(&j, "memory_bytes", (int64_t)(r->scene->bytes + r->cost.bytes));
    if (r->options->settings.coupled.asked) json_coupled(&j, r);
    if (r->published) json_published(&j, r->published);
    if (r->options->forces) json_forces(&j, r);
    json_close(&j, '}');
    fputc('\n', out);
}

/* --------------------------------------------------------------------------------------------------------------- words */

static const char *capitals(sp_verdict v)
{
    return v == SP_STABLE ? "STABLE" : v == SP_UNSTABLE ? "UNSTABLE" : "UNDECIDED";
}

static const char *why(sp_reason reason)
{
    switch (reason) {
    case SP_REASON_FORCES:     return "forces that the joints can carry hold every block in equilibrium";
    case SP_REASON_NOTHING:    return "nothing to carry: no free block, or no load";
    case SP_REASON_NO_CONTACT: return "a block touches nothing";
    case SP_REASON_NO_SUPPORT: return "a group of blocks has no path to a support";
    case SP_REASON_MECHANISM:  return "the blocks can move in a way that no force of the joints can resist";
    case SP_REASON_LIMIT:      return "neither forces nor a motion within tol: the limit is nearer than that";
    case SP_REASON_BUDGET:     return "the search gave up, its work spent or without progress: neither forces nor a motion within tol";
    case SP_REASON_STAGES:     return "the chosen stages can't decide this";
    case SP_REASON_NO_MOTION:  return "forces exist, but no virtual motion explains any of them";
    case SP_REASON_NOT_COUPLED: return "forces exist; neither a virtual motion that explains them nor a proof against one was found";
    case SP_REASON_TENSION:    return "the penalty form is solved, but wants tension: no proof either way";
    case SP_REASON_UNVERIFIED: return "a solver's answer did not pass verification: no forces, and no motion that proves anything";
    case SP_REASON_EFFECT:     return "an effect was left out that the scene calls for";
    default:                   return "";
    }
}

/* 1234.5 with a unit of thousands: "1.23 kN". */
static void scaled(FILE *out, double x, const char *unit)
{
    static const char *const prefix[] = { "n", "u", "m", "", "k", "M", "G", "T" };
    int k = 3;
    double y = fabs(x);
    while (y >= 999.5 && k < 7) { y /= 1000; x /= 1000; k++; }
    while (y > 0 && y < 0.9995 && k > 0) { y *= 1000; x *= 1000; k--; }
    fprintf(out, "%.3g %s%s", x, prefix[k], unit);
}

static void row(FILE *out, const char *label) { fprintf(out, "  %-15s", label); }

static void text_certainty(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    row(out, "how sure");
    if (x->verdict == SP_STABLE) fprintf(out, "largest imbalance %.2g of a block's forces, tol %.2g", (double)x->omega, (double)x->tol);
    else if (x->verdict == SP_UNSTABLE && x->final) fprintf(out, "no forces of any size would do");
    else if (x->reason == SP_REASON_NO_MOTION)
        fprintf(out, "no motion in any of %ld cases, margin %.2g", (long)x->coupled.proof.leaves, (double)x->coupled.margin);
    else if (x->verdict == SP_UNSTABLE)
        fprintf(out, "at least %.2g of a block's forces stays unbalanced, tol %.2g", (double)x->least_imbalance, (double)x->tol);
    else fprintf(out, "best forces leave %.2g of a block's forces unbalanced, tol %.2g", (double)x->omega, (double)x->tol);
    if (x->verdict != SP_UNDECIDED) fprintf(out, x->verified ? "; verified" : "; NOT verified");
    fputc('\n', out);
}

void report_tol(FILE *out, const report *r)
{
    const char *by = report_tol_by(r);
    if (strcmp(by, "asked") == 0) return;
    row(out, "tol");
    fprintf(out, "%.2g instead of %.2g: %s\n", (double)r->result.tol, (double)r->options->settings.tol,
            strcmp(by, "coupled") ? "an eighth of the least friction, or slopes too steep for it would pass"
                                  : "a coupled check is asked with no coarser one");
}

static void text_coupled(FILE *out, const report *r)
{
    const sp_coupled *c = &r->result.coupled;
    if (!r->options->settings.coupled.asked) return;
    row(out, "coupled");
    fputs(sp_coupling_text(c->verdict), out);
    if (c->verdict == SP_COUPLING_COUPLED) fprintf(out, ": a virtual motion explains the forces, residual %.2g; verified", (double)c->residual);
    else fprintf(out, " (%s)", sp_coupling_reason_text(c->reason));
    fprintf(out, "; eta/eps ");
    if (c->eps > 0) fprintf(out, "%.3g\n", (double)(c->eta / c->eps));
    else fputs("unbounded\n", out);
}

static void text_published(FILE *out, const solvers_published *p)
{
    const ipopt_cra_answer *a = p ? &p->answer : NULL;
    if (!a) return;
    row(out, "Ipopt");
    fprintf(out, "%s after %ld iterations, %.3g s; objective %.9g, residual %.2g; %s\n", a->status, (long)a->iterations, a->seconds,
            a->objective, p->residual, p->evidence.level == SP_COUPLED ? "verified" : "not verified");
}

static void text_weakest(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    const sp_scene *s = &r->scene->scene;
    sp_interface_force f;
    if (x->weakest < 0 || sp_interface_resultant(s, x, x->weakest, &f) != SP_OK) return;
    const sp_demand *help = &x->demand[x->weakest];
    row(out, "weakest joint");
    fprintf(out, "%s - %s", r->scene->name[s->interface[x->weakest].a], r->scene->name[s->interface[x->weakest].b]);
    if (help->friction > help->tension) {
        fputs(": lacks ", out);
        scaled(out, (double)help->friction, "N");
        fputs(" of friction\n", out);
    } else if (help->tension > 0) {
        fputs(": asks for ", out);
        scaled(out, (double)help->tension, "N");
        fputs(" of tension\n", out);
    } else fprintf(out, ": friction used to %.0f %%\n", 100 * (double)f.utilisation);
}

static void text_mechanism(FILE *out, const report *r)
{
    enum { SHOWN = 6 };
    int32_t moving = 0;
    if (r->result.verdict != SP_UNSTABLE || r->result.reason == SP_REASON_NO_MOTION) return;
    row(out, "moving");
    for (int32_t b = 0; b < r->scene->scene.count.blocks; b++)
        if (motion_speed(&r->scene->scene, &r->result, b) > MOTION_STILL && moving++ < SHOWN) fprintf(out, "%s%s", moving > 1 ? ", " : "", r->scene->name[b]);
    if (moving > SHOWN) fprintf(out, " and %ld more", (long)(moving - SHOWN));
    fputc('\n', out);
}

/* How the islands do; those that don't stand by the names of their first blocks. */
static void text_islands(FILE *out, const report *r)
{
    enum { SHOWN = 4 };
    const sp_result *x = &r->result;
    int32_t stable = 0, named = 0;
    if (!x->part) return;
    for (int32_t k = 0; k < x->islands; k++) stable += x->part[k].verdict == SP_STABLE;
    row(out, "islands");
    fprintf(out, "%ld solved apart, %ld stable", (long)x->islands, (long)stable);
    for (int32_t k = 0; k < x->islands && named < SHOWN; k++)
        if (x->part[k].verdict != SP_STABLE)
            fprintf(out, "%s%s %s", named++ ? ", " : "; ", r->scene->name[x->part[k].block], sp_verdict_text(x->part[k].verdict));
    fprintf(out, x->islands - stable > named ? ", ...\n" : "\n");
}

static void text_overlaps(FILE *out, const host_scene *s)
{
    if (s->overlaps == 0) return;
    row(out, "overlap");
    fprintf(out, "%s - %s by ", s->name[s->overlap[0].a], s->name[s->overlap[0].b]);
    scaled(out, (double)s->overlap[0].depth, "m");
    if (s->overlaps > 1) fprintf(out, " and %ld more pairs", (long)(s->overlaps - 1));
    fputc('\n', out);
}

void report_text(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    const sp_capacity *n = &r->scene->scene.count;

    fprintf(out, "%s: %s\n", r->scene->path, capitals(x->verdict));
    row(out, "why");
    fprintf(out, "%s\n", why(x->reason));
    text_certainty(out, r);
    report_tol(out, r);
    text_coupled(out, r);
    text_published(out, r->published);
    text_weakest(out, r);
    text_mechanism(out, r);
    row(out, "forces");
    fputs("largest compression ", out);
    scaled(out, (double)x->max_compression, "N");
    fputs(x->max_tension > 0 ? ", largest tension asked for " : "", out);
    if (x->max_tension > 0) scaled(out, (double)x->max_tension, "N");
    fputc('\n', out);
    for (int coupled = 0; coupled < 2; coupled++) {
        const double ratio = (double)(coupled ? x->coupled.tension_ratio : x->tension_ratio);
        if (!(ratio >= 0) || (coupled && !r->options->settings.coupled.asked)) continue;
        row(out, "penalty form");
        fputs(coupled ? "joined with a motion: " : "", out);
        fprintf(out, ratio < 1e30 ? "largest tension / largest compression %.2g\n" : "nothing but tension\n", ratio);
    }
    row(out, "scene");
    fprintf(out, "%ld block%s, %ld free; %ld joint%s%s, %ld contact points\n", (long)n->blocks, n->blocks == 1 ? "" : "s",
            (long)x->free_blocks, (long)x->interfaces, x->interfaces == 1 ? "" : "s", r->scene->found ? " found" : "",
            (long)x->points);
    if (x->reason == SP_REASON_EFFECT) {
        row(out, "left out");
        fprintf(out, "%s\n", sp_effect_text(x->missing));
    }
    text_islands(out, r);
    text_overlaps(out, r->scene);
    row(out, "cost");
    fprintf(out, "%ld factorisation%s, ", (long)x->cost.factorisations, x->cost.factorisations == 1 ? "" : "s");
    if (x->cost.interior) fprintf(out, "%ld of them interior-point, ", (long)x->cost.interior);
    scaled(out, (double)x->cost.flops, "flop");
    fprintf(out, ", %.1f KiB, ", (double)r->cost.bytes / 1024);
    scaled(out, r->cost.seconds, "s");
    fprintf(out, ", by %s\n", sp_stage_text(x->stage));
    if (!r->options->settings.coupled.asked) return;
    row(out, "of it coupled");
    scaled(out, (double)x->coupled.cost.flops, "flop");
    fprintf(out, ", %.1f KiB\n", (double)r->coupled_bytes / 1024);
}

/* ------------------------------------------------------------------------------------------------------------- picture */

int report_svg(FILE *out, const report *r)
{
    const subject of = { r->scene, &r->result, r->limit };
    return svg_write(out, &of);
}
