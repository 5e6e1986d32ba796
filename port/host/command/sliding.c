/* sliding: limits without dilatancy in words and as JSON. */
#include "sliding.h"


int sliding_ask(report *r, sp_sliding_result *x, run_cost *cost, void **memory, failure *error)
{
    const sp_settings *set = &r->options->settings;
    const sp_status status = run_sliding(&r->scene->scene, set, r->limit, x, cost, memory);
    return status == SP_OK ? 0 : scene_refused(r->scene, set, status, error);
}

const char *sliding_reason(sp_sliding_reason reason)
{
    static const char *const text[] = { "state", "nothing found", "not asked" };
    return text[reason];
}

static void json_rows(json_out *j, const char *key, const sp_real *x, int32_t n, int32_t width)
{
    json_open(j, key, '[');
    for (int32_t k = 0; k < n; k++) json_reals(j, NULL, x + (size_t)k * (size_t)width, width);
    json_close(j, ']');
}

static void json_number(json_out *j, const char *key, sp_real x)
{
    if (x >= 0) json_real(j, key, (double)x + 0.0);
    else json_null(j, key);
}

static void json_ends(json_out *j, const sp_sliding_result *x)
{
    json_open(j, "ends", '[');
    for (int32_t k = 0; k < x->ends; k++) {
        json_open(j, NULL, '{');
        json_int(j, "seed", x->end[k].seed);
        json_number(j, "steady", x->end[k].steady);
        json_number(j, "least", x->end[k].least);
        json_close(j, '}');
    }
    json_close(j, ']');
}

/* All that verify needs. */
static void json_evidence(json_out *j, const report *r, const sp_sliding_result *x)
{
    const sp_scene *s = &r->scene->scene;
    json_open(j, "proof", '{');
    json_reals(j, "gravity", s->gravity, 3);
    json_reals(j, "body", s->body, 3);
    json_rows(j, "forces", x->f, s->count.points, 3);
    json_rows(j, "motion", x->v, s->count.blocks, 6);
    json_rows(j, "pressed", x->pressed, s->count.points, 3);
    json_rows(j, "resting", x->resting, s->count.points, 3);
    json_close(j, '}');
}

void sliding_json(json_out *j, const report *r, const sp_sliding_result *x, const run_cost *cost)
{
    json_open(j, "sliding", '{');
    json_string(j, "kind", x->kind == SP_SLIDING_STATE ? "state" : "associative");
    json_string(j, "reason", sliding_reason(x->reason));
    json_number(j, "upper", x->upper);
    json_number(j, "associative", x->associative);
    json_number(j, "lower", x->lower);
    json_number(j, "lower_strong", x->lower_strong);
    json_real(j, "residual", (double)x->residual);
    json_real(j, "share", (double)x->share);
    json_ends(j, x);
    json_int(j, "flops", x->cost.flops);
    json_int(j, "peak_bytes", (int64_t)x->peak_bytes);
    json_real(j, "seconds", cost->seconds);
    if (r->options->forces) json_evidence(j, r, x);
    json_close(j, '}');
}

void sliding_text(FILE *out, const report *r, const sp_sliding_result *x, const run_cost *cost)
{
    (void)r;
    report_row(out, "real sliding");
    if (x->kind == SP_SLIDING_STATE)
        fprintf(out, "a sliding state at %.9g: friction as it is may let it slide there; residual %.2g; verified\n",
                (double)x->upper, (double)x->residual);
    else if (x->reason == SP_SLIDING_NOT_ASKED)
        fputs("not asked: for planar scenes of at most 400 free blocks, joints without strength\n", out);
    else
        fprintf(out, "no state found from %ld start%s; the multiplier above stays the upper value\n", (long)x->ends,
                text_s(x->ends));
    if (x->kind == SP_SLIDING_STATE && x->associative > x->upper * (sp_real)1.000001) {
        report_row(out, "mind");
        fputs("between that and the multiplier above nothing is said\n", out);
    }
    report_row(out, "for safety");
    if (x->lower_strong > 0)
        fprintf(out, "whatever friction does it stays up to %.9g times, proved\n", (double)x->lower_strong);
    else if (x->lower > 0)
        fprintf(out, "no sliding state below %.9g times, proved; that it stays whatever friction does is not\n",
                (double)x->lower);
    else fputs("nothing proved: take no number from here\n", out);
    report_row(out, "starts");
    fprintf(out, "%ld, %.3g Mflop, %.3g ms\n", (long)x->ends, 1e-6 * (double)x->cost.flops, 1e3 * cost->seconds);
}
