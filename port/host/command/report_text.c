#include "../motion.h"
#include "../reason.h"
#include "../weakest.h"
#include "report.h"

#include <math.h>
#include <string.h>

static const char *capitals(sp_verdict v)
{
    return v == SP_STABLE ? "STABLE" : v == SP_UNSTABLE ? "UNSTABLE" : "UNDECIDED";
}

/* 1234.5 with a unit of thousands: "1.23 kN". */
static void put_scaled(FILE *out, double x, const char *unit)
{
    static const char *const prefix[] = { "n", "u", "m", "", "k", "M", "G", "T" };
    int k = 3;
    double y = fabs(x);
    while (y >= 999.5 && k < 7) { y /= 1000; x /= 1000; k++; }
    while (y > 0 && y < 0.9995 && k > 0) { y *= 1000; x *= 1000; k--; }
    fprintf(out, "%.3g %s%s", x, prefix[k], unit);
}

void report_row(FILE *out, const char *label) { fprintf(out, "  %-15s", label); }

static void text_certainty(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    report_row(out, "how sure");
    if (x->verdict == SP_STABLE)
        fprintf(out, "largest imbalance %.2g of a block's forces, tol %.2g", (double)x->imbalance, (double)x->tol);
    else if (x->verdict == SP_UNSTABLE && x->final) fprintf(out, "no forces of any size would do");
    else if (x->reason == SP_REASON_NO_MOTION)
        fprintf(out, "no motion in any of %ld case%s, margin %.2g", (long)x->coupled.proof.leaves,
                text_s(x->coupled.proof.leaves), (double)x->coupled.margin);
    else if (x->verdict == SP_UNSTABLE)
        fprintf(out, "at least %.2g of a block's forces stays unbalanced, tol %.2g", (double)x->least_imbalance,
                (double)x->tol);
    else fprintf(out, "best forces leave %.2g of a block's forces unbalanced, tol %.2g", (double)x->imbalance, (double)x->tol);
    if (x->verdict != SP_UNDECIDED) fprintf(out, x->verified ? "; verified" : "; NOT verified");
    fputc('\n', out);
}

void report_tol(FILE *out, const report *r)
{
    const char *by = report_tol_by(r);
    if (strcmp(by, "asked") == 0) return;
    report_row(out, "tol");
    fprintf(out, "%.2g instead of %.2g: %s\n", (double)r->result.tol, (double)r->options->settings.tol,
            strcmp(by, "coupled") ? "an eighth of the least friction, or slopes too steep for it would pass"
                                  : "a coupled check is asked with no coarser one");
}

static void text_coupled(FILE *out, const report *r)
{
    const sp_coupled *c = &r->result.coupled;
    if (!r->options->settings.coupled.asked) return;
    report_row(out, "coupled");
    fputs(sp_coupling_text(c->verdict), out);
    if (c->verdict == SP_COUPLING_COUPLED)
        fprintf(out, ": a virtual motion explains the forces, residual %.2g; verified", (double)c->residual);
    else fprintf(out, " (%s)", sp_coupling_reason_text(c->reason));
    fprintf(out, "; eta/eps ");
    if (c->eps > 0) fprintf(out, "%.3g\n", (double)(c->eta / c->eps));
    else fputs("unbounded\n", out);
}

/* Whatever friction does. */
static void text_strong(FILE *out, const report *r)
{
    const sp_strong_result *x = r->strong;
    if (!x) return;
    report_row(out, "friction");
    switch (x->kind) {
    case SP_STRONG_AT_CORNERS:
    case SP_STRONG_STRONG:
        if (x->reason == SP_STRONG_CASES) {
            fprintf(out, "%s: it does not move in any of %ld case%s of sticking and slipping; verified\n",
                    sp_strong_text(x->kind), (long)x->proof.leaves, text_s(x->proof.leaves));
            break;
        }
        if (x->reason == SP_STRONG_EVEN) {
            fputs("strong: friction in proportion to pressure holds every joint, and joints close no loop; verified\n", out);
            break;
        }
        fprintf(out, "strong: pressure alone holds it, whatever friction does; imbalance %.2g; verified\n",
                (double)x->residual);
        break;
    case SP_STRONG_AMBIGUOUS:
        fprintf(out, "ambiguous: it stands or goes, by its history; a block may move off with %.2g of its forces / its "
                "mass; verified\n", (double)x->moves);
        if (x->plate) {
            report_row(out, "");
            fputs("pressure may gather inside a joint, where it holds no torsion; --corners asks without\n", out);
        }
        if (!x->balls) break;
        report_row(out, "");
        fprintf(out, "%ld block%s without a mesh turn as balls do\n", (long)x->balls, x->balls == 1 ? "" : "s");
        break;
    case SP_STRONG_ADMISSIBLE:
        if (x->reason == SP_STRONG_NOT_ASKED)
            fputs("admissible: with strength or loads with mass only pressure is asked\n", out);
        else fprintf(out, "admissible: no proof that nothing moves, and no motion from %ld start%s\n", (long)x->starts,
                     text_s(x->starts));
        break;
    default: fputs("not asked: it is not known to stand\n", out);
    }
}

static void text_published(FILE *out, const solvers_published *p)
{
    const ipopt_cra_answer *a = p ? &p->answer : NULL;
    if (!a) return;
    report_row(out, "Ipopt");
    fprintf(out, "%s after %ld iteration%s, %.3g s; objective %.9g, residual %.2g; %s\n", a->status,
            (long)a->iterations, text_s(a->iterations), a->seconds, a->objective, p->residual,
            p->evidence.level == SP_COUPLED ? "verified" : "not verified");
}

static void text_weakest(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    const sp_scene *s = &r->scene->scene;
    const int32_t told = weakest_told(s, x);
    if (x->extremes.weakest < 0) return;
    report_row(out, "weakest joint");
    if (told < 0) {
        fputs("none is near its limit\n", out);
        return;
    }
    const sp_joint *t = &s->joint[told];
    const sp_demand *help = &x->demand[told];
    const char *does = motion_of_joint(s, x, told);
    fprintf(out, "%s - %s", r->scene->name[t->a], r->scene->name[t->b]);
    if (help->friction > help->tension) {
        fputs(": lacks ", out);
        put_scaled(out, (double)help->friction, "N");
        fputs(" of friction\n", out);
    } else if (help->tension > 0) {
        fputs(": asks for ", out);
        put_scaled(out, (double)help->tension, "N");
        fputs(" of tension\n", out);
    } else if (does) fprintf(out, ": %s\n", does);
    else {
        const weakest_joint w = weakest_nearest(s, x);
        char words[WEAKEST_WORDS];
        weakest_words(s, x, &w, words);
        fprintf(out, ": %s\n", words);
    }
}

static void text_mechanism(FILE *out, const report *r)
{
    int32_t fastest[MOTION_NAMED];
    if (r->result.verdict != SP_UNSTABLE || r->result.reason == SP_REASON_NO_MOTION) return;
    report_row(out, "moving");
    const int32_t moving = motion_fastest(&r->scene->scene, &r->result, MOTION_NAMED, fastest);
    for (int k = 0; k < moving && k < MOTION_NAMED; k++) fprintf(out, "%s%s", k ? ", " : "", r->scene->name[fastest[k]]);
    if (moving > MOTION_NAMED) fprintf(out, " and %ld more", (long)(moving - MOTION_NAMED));
    fputc('\n', out);
}

/* Where help is wanted was not asked: how to ask. */
static void text_help(FILE *out, const report *r)
{
    const sp_reason why = r->result.reason;
    if (r->result.verdict == SP_STABLE || r->options->settings.localise || why == SP_REASON_NO_SUPPORT
        || why == SP_REASON_NO_CONTACT || why == SP_REASON_STAGES) return;
    report_row(out, "help");
    fputs("--localise tells which joints lack tension or friction\n", out);
}

/* How the islands do; those that don't stand by the names of their first blocks. */
static void text_islands(FILE *out, const report *r)
{
    enum { SHOWN = 4 };
    const sp_result *x = &r->result;
    int32_t stable = 0, named = 0;
    if (!x->islands.each) return;
    for (int32_t k = 0; k < x->islands.count; k++) stable += x->islands.each[k].verdict == SP_STABLE;
    report_row(out, "islands");
    fprintf(out, "%ld, each solved alone, %ld stable", (long)x->islands.count, (long)stable);
    for (int32_t k = 0; k < x->islands.count && named < SHOWN; k++)
        if (x->islands.each[k].verdict != SP_STABLE)
            fprintf(out, "%s%s %s", named++ ? ", " : "; ", r->scene->name[x->islands.each[k].block],
                    sp_verdict_text(x->islands.each[k].verdict));
    fprintf(out, x->islands.count - stable > named ? ", ...\n" : "\n");
}

static void text_overlaps(FILE *out, const host_scene *s)
{
    if (s->overlaps == 0) return;
    report_row(out, "overlap");
    fprintf(out, "%s - %s by ", s->name[s->overlap[0].a], s->name[s->overlap[0].b]);
    put_scaled(out, (double)s->overlap[0].depth, "m");
    if (s->overlaps > 1) fprintf(out, " and %ld more pair%s", (long)(s->overlaps - 1), text_s(s->overlaps - 1));
    fputc('\n', out);
}

/* What a joint's corners carry together, and one of them alone. */
static void text_forces(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    report_row(out, "forces");
    fputs("largest compression ", out);
    put_scaled(out, report_joint_compression(r), "N");
    fputs(" of a joint, ", out);
    put_scaled(out, (double)x->extremes.compression, "N");
    fputs(" at a corner", out);
    fputs(x->extremes.tension > 0 ? ", largest tension asked for " : "", out);
    if (x->extremes.tension > 0) put_scaled(out, (double)x->extremes.tension, "N");
    fputc('\n', out);
}

/* What help the penalty form asks for, of statics and of the coupled question. */
static void text_penalty(FILE *out, const report *r)
{
    for (int coupled = 0; coupled < 2; coupled++) {
        const double ratio = (double)(coupled ? r->result.coupled.tension_ratio : r->result.extremes.tension_ratio);
        if (!(ratio >= 0) || (coupled && !r->options->settings.coupled.asked)) continue;
        report_row(out, "penalty form");
        fputs(coupled ? "joined with a motion: " : "", out);
        fprintf(out, ratio < 1e30 ? "largest tension / largest compression %.2g\n" : "nothing but tension\n", ratio);
    }
}

static void text_scene(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    const sp_counts *n = &x->counts;
    const int32_t blocks = r->scene->scene.count.blocks;
    report_row(out, "scene");
    fprintf(out, "%ld block%s, %ld free; %ld joint%s%s, %ld contact point%s\n", (long)blocks, blocks == 1 ? "" : "s",
            (long)n->free_blocks, (long)n->joints, n->joints == 1 ? "" : "s", r->scene->found ? " found" : "",
            (long)n->points, text_s(n->points));
    if (x->reason != SP_REASON_EFFECT) return;
    report_row(out, "left out");
    fprintf(out, "%s\n", sp_effect_text(x->missing));
}

static void text_cost(FILE *out, const report *r)
{
    const sp_result *x = &r->result;
    report_row(out, "cost");
    fprintf(out, "%ld factorisation%s, ", (long)x->spent.total.factorisations, x->spent.total.factorisations == 1 ? "" : "s");
    if (x->spent.total.interior) fprintf(out, "%ld of them interior-point, ", (long)x->spent.total.interior);
    put_scaled(out, (double)x->spent.total.flops, "flop");
    fprintf(out, ", %.1f KiB, ", (double)r->cost.bytes / 1024);
    put_scaled(out, r->cost.seconds, "s");
    fprintf(out, ", by %s\n", sp_stage_text(x->stage));
    if (!r->options->settings.coupled.asked) return;
    report_row(out, "of it coupled");
    put_scaled(out, (double)x->coupled.cost.flops, "flop");
    fprintf(out, ", %.1f KiB\n", (double)r->coupled_bytes / 1024);
}

void report_near(FILE *out, int32_t near, int32_t inside, int32_t across)
{
    if (near > 0)
        fprintf(out, ", but %ld pair%s of blocks nearly touch%s", (long)near, near == 1 ? "" : "s", near == 1 ? "es" : "");
    if (inside > 0)
        fprintf(out, ", %s %ld pair%s of blocks lie%s inside each other", near > 0 ? "and" : "but", (long)inside,
                inside == 1 ? "" : "s", inside == 1 ? "s" : "");
    if (across > 0)
        fprintf(out, ", %s %ld joint%s across a block", near > 0 || inside > 0 ? "and" : "but", (long)across,
                across == 1 ? " reaches" : "s reach");
    fputc('\n', out);
}

static void text_verdict(FILE *out, const report *r)
{
    fprintf(out, "%s: %s", r->scene->path, capitals(r->result.verdict));
    report_near(out, r->result.verdict == SP_STABLE ? 0 : r->scene->near, r->scene->inside, r->scene->across);
}

void report_text(FILE *out, const report *r)
{
    text_verdict(out, r);
    if (r->options->quiet) return;
    report_row(out, "why");
    if (r->result.verdict != SP_STABLE && !report_supported(r)) fputs("nothing is fixed, so nothing holds these blocks: ", out);
    fprintf(out, "%s\n", reason_words(r->result.reason));
    text_certainty(out, r);
    report_tol(out, r);
    text_coupled(out, r);
    text_strong(out, r);
    text_published(out, r->published);
    text_weakest(out, r);
    text_mechanism(out, r);
    text_help(out, r);
    text_forces(out, r);
    text_penalty(out, r);
    text_scene(out, r);
    text_islands(out, r);
    text_overlaps(out, r->scene);
    text_cost(out, r);
    remarks_print(out, &r->scene->remarks);
}
