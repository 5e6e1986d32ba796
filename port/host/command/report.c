#include "../files/drawn.h"
#include "../picture/model.h"
#include "../picture/svg.h"
#include "../worker/worker_client.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>

/* By a worker, this program once more. */
static int by_worker(report *r, void **memory, failure *error)
{
    const options *o = r->options;
    const char *const command[] = { o->program, "worker", NULL };
    const worker_client client = { command, o->worker, (size_t)o->worker_memory, o->fallback };
    worker_answer a;
    const sp_status status = worker_check(&client, &r->scene->scene, &o->settings, &a);

    *memory = a.memory;
    r->result = a.result;
    r->cost = a.cost;
    if (a.end > WORKER_REFUSED && !a.fell_back) return fail_with(error, EXIT_INTERNAL, r->scene->path, 0, "%s", a.message);
    if (status == SP_E_UNSUPPORTED && !(o->settings.coupled.asked && r->scene->strength_line))
        return fail_with(error, EXIT_USAGE, r->scene->path, 0, "this question can't go to a worker: %s",
                         sp_status_text(status));
    return status == SP_OK ? 0 : scene_refused(r->scene, &r->options->settings, status, error);
}

/* In this process. */
static int by_ourselves(report *r, void **memory, failure *error)
{
    const sp_status status = run_check(&r->scene->scene, &r->options->settings, &r->result, &r->cost, memory);
    return status == SP_OK ? 0 : scene_refused(r->scene, &r->options->settings, status, error);
}

int report_check(report *r, void **memory, failure *error)
{
    sp_settings without = r->options->settings;
    size_t bytes;
    const int status = r->options->worker > 0 ? by_worker(r, memory, error) : by_ourselves(r, memory, error);
    if (status || !without.coupled.asked) return status;
    without.coupled.asked = 0;
    if (run_check_bytes(&r->scene->scene, &without, &bytes) == SP_OK && bytes < r->cost.bytes)
        r->coupled_bytes = r->cost.bytes - bytes;
    return 0;
}

const char *report_tol_by(const report *r)
{
    const sp_scene *s = &r->scene->scene;
    sp_real least = 1;
    if (!(r->result.tol < r->options->settings.tol)) return "asked";
    for (int32_t i = 0; i < s->count.joints; i++) {
        const sp_real mu = s->joint[i].strength.mu;
        if (mu > 0 && mu < least) least = mu;
    }
    return least / 8 <= r->result.tol ? "least friction" : "coupled";
}

double report_joint_compression(const report *r)
{
    const sp_scene *s = &r->scene->scene;
    double most = 0;
    for (int32_t k = 0; k < s->count.joints; k++) {
        const sp_real *n = s->joint[k].n;
        sp_joint_force f;
        if (sp_joint_resultant(s, &r->result, k, &f) != SP_OK) continue;
        const double fn = (double)(f.force[0] * n[0] + f.force[1] * n[1] + f.force[2] * n[2]);
        if (fn > most) most = fn;
    }
    return most;
}

int report_supported(const report *r)
{
    for (int32_t i = 0; i < r->scene->scene.count.blocks; i++) if (r->scene->scene.block[i].fixed) return 1;
    return 0;
}

static int put_svg(FILE *out, const void *of) { return svg_write(out, of); }
static int put_model(FILE *out, const void *of) { return model_write(out, of); }

/* The motion m, 6 x blocks, becomes the one that is shown, the largest number of it 1.      returns 0: out of memory */
static int show_motion(report_shown *x, const sp_real *m)
{
    const size_t n = 6 * (size_t)x->of.scene->scene.count.blocks;
    double most = 0;
    x->dq = malloc(n * sizeof *x->dq + 1);
    for (size_t k = 0; k < n; k++) most = fmax(most, fabs((double)m[k]));
    for (size_t k = 0; x->dq && k < n; k++) x->dq[k] = most > 0 ? (sp_real)((double)m[k] / most) : 0;
    x->result.dq = x->dq;
    return x->dq != NULL;
}

int report_show(const report *r, report_shown *x)
{
    const subject of = { r->scene, &x->result, r->limit, r->options->view, r->options->names, NULL, NULL };
    x->result = r->result;
    x->dq = NULL;
    x->of = of;
    if (r->strong && r->strong->kind) x->of.level = sp_strong_text(r->strong->kind);
    else if (!r->limit && r->result.level == SP_COUPLED) x->of.level = sp_level_text(SP_COUPLED);
    if (r->strong && r->strong->kind == SP_STRONG_AMBIGUOUS) {
        x->of.motion = "It stands, and by another history of its friction it starts to move";
        return show_motion(x, r->strong->a);
    }
    if (!r->sliding || r->sliding->kind != SP_SLIDING_STATE) return 1;
    snprintf(x->words, sizeof x->words, "How it slides at %.6g, its joints without dilatancy", (double)r->sliding->upper);
    x->of.motion = x->words;
    x->result.f = r->sliding->f;
    return show_motion(x, r->sliding->v);
}

int report_draw(const report *r, failure *error)
{
    const options *o = r->options;
    report_shown x;
    int status = report_show(r, &x) ? 0 : fail_with(error, EXIT_MEMORY, NULL, 0, "can't draw the picture: out of memory");
    if (!status) status = drawn_file(o->svg, put_svg, &x.of, error);
    if (!status) status = drawn_png(o->png, put_svg, &x.of, error);
    if (!status) status = drawn_file(o->model, put_model, &x.of, error);
    free(x.dq);
    return status;
}

int report_exit(sp_verdict verdict)
{
    return verdict == SP_STABLE ? EXIT_STABLE : verdict == SP_UNSTABLE ? EXIT_UNSTABLE : EXIT_UNDECIDED;
}
