/* check: does each scene stand? */
#include "../files/done.h"
#include "../tilt.h"
#include "commands.h"
#include "jobs.h"
#include "outputs.h"
#include "progress.h"
#include "report.h"
#include "report_csv.h"
#include "report_html.h"

#include <stdlib.h>
#include <string.h>

/* The coupled question once more, as the program its authors publish. */
static int ask_published(report *r, solvers_published *p, failure *error)
{
    sp_status status;
    progress_show("asking Ipopt about %s ...", r->scene->path);
    status = solvers_publish(&r->scene->scene, &r->options->settings, &r->result, p);
    r->published = p;
    return status == SP_OK ? 0 : scene_refused(r->scene, &r->options->settings, status, error);
}

/* Does it stand whatever friction does? */
static int ask_strong(report *r, sp_strong_result *x, void **memory, failure *error)
{
    progress_show("asking whether friction may let go of %s ...", r->scene->path);
    sp_strong_settings how = sp_strong_settings_default();
    how.corners = r->options->corners;
    const sp_status status = run_strong(&r->scene->scene, &r->options->settings, &how, r->result.f, x, &r->strong_cost, memory);
    r->strong = x;
    return status == SP_OK ? 0 : scene_refused(r->scene, &r->options->settings, status, error);
}

/* Pictures, page, model and tables. */
static int draw(const report *r, failure *error)
{
    int status = report_draw(r, error);
    if (!status) status = report_html(r, report_text, error);
    return status || !r->options->csv ? status : report_csv(r, error);
}

/* Read, turn, check, tell: the answer also where one of its files can't be written. */
static int check_one(const char *path, options *o, failure *error)
{
    host_scene s;
    report r;
    solvers_published p;
    sp_strong_result strong;
    void *memory = NULL, *more = NULL;
    int status;

    memset(&r, 0, sizeof r);
    r.scene = &s;
    r.options = o;
    progress_show("reading %s ...", path);
    status = scene_read(path, &o->scene, &s, error);
    if (!status) tilt_turn(o->tilt, o->azimuth, s.scene.gravity);
    o->settings.watch = o->worker > 0 ? NULL : progress_watch(path);
    if (!status) status = report_check(&r, &memory, error);
    if (!status && o->settings.coupled.asked && strcmp(o->solver_name, "ipopt") == 0) status = ask_published(&r, &p, error);
    if (!status && o->strong) status = ask_strong(&r, &strong, &more, error);
    if (!status) {
        const int drawn = draw(&r, error);
        progress_end();
        if (o->json) report_json(stdout, &r);
        else report_text(stdout, &r);
        fflush(stdout);
        status = drawn ? drawn : report_exit(r.result.verdict);
    }
    progress_end();
    free(memory);
    free(more);
    scene_free(&s);
    return status;
}

/* A bad scene hides nothing worse than a verdict; a failure of ours tells before it. */
static int worse_status(int a, int b)
{
    static const int order[] = { EXIT_STABLE, EXIT_UNSTABLE, EXIT_UNDECIDED, EXIT_NO_INPUT, EXIT_SCENE, EXIT_USAGE,
                                 EXIT_UNAVAILABLE, EXIT_MEMORY, EXIT_INTERNAL };
    int rank_a = 0, rank_b = 0;
    for (int k = 0; k < (int)(sizeof order / sizeof *order); k++) {
        if (order[k] == a) rank_a = k;
        if (order[k] == b) rank_b = k;
    }
    return rank_a > rank_b ? a : b;
}

/* All scenes of the command line. */
typedef struct scene_list {
    options *o;
    const done_list *done;
} scene_list;

/* The k-th of them: what it is told as.     returns its status, which an earlier run may have written down */
static int tell_one(void *self, int k)
{
    const scene_list *all = self;
    options *o = all->o;
    failure error = { 0, "" };
    const int before = done_find(all->done, o->file[k]), status = before >= 0 ? before : check_one(o->file[k], o, &error);
    if (status > EXIT_UNDECIDED) fprintf(stderr, "%s\n", error.line);
    if (!o->json && !o->quiet && k + 1 < o->files && before < 0) fputc('\n', stdout);
    fflush(stdout);
    return status;
}

/* After so many of the scenes, by Ctrl-C; what was printed is whole, so that --skip-done can go on from there. */
static int stop(int scenes, int all)
{
    fprintf(stderr, "stonepack: stopped after %d of %d scenes\n", scenes, all);
    return EXIT_STOPPED;
}

/* One after the other, each by as many threads as there may be. */
static int check_in_turn(options *o, const done_list *done, failure *error)
{
    scene_list all = { o, done };
    int worst = jobs_begin(o->jobs, &o->settings.parallel, error);
    if (worst) {
        fprintf(stderr, "%s\n", error->line);
        return worst;
    }
    progress_begin(o->quiet);
    if (o->files > 1) progress_hear();
    for (int k = 0; k < o->files; k++) {
        if (progress_stopped()) {
            worst = stop(k, o->files);
            break;
        }
        worst = worse_status(worst, tell_one(&all, k));
    }
    jobs_end();
    return worst;
}

/* Several at a time, told in their order. */
static int check_beside(options *o, const done_list *done, failure *error)
{
    scene_list all = { o, done };
    int worst = EXIT_STABLE, *status = malloc((size_t)o->files * sizeof *status);
    if (!status) {
        worst = fail_status(error, SP_E_MEMORY, NULL, 0, "--jobs");
        fprintf(stderr, "%s\n", error->line);
        return worst;
    }
    progress_begin(1);
    progress_hear();
    const int ran = jobs_scenes(o->files, o->jobs, o->file, tell_one, &all, status);
    if (ran < 0) {
        free(status);
        fputs("stonepack: --jobs needs POSIX\n", stderr);
        return EXIT_UNAVAILABLE;
    }
    for (int k = 0; k < ran; k++) worst = worse_status(worst, status[k]);
    free(status);
    return ran < o->files ? stop(ran, o->files) : worst;
}

int command_check(int argc, char **argv)
{
    failure error = { 0, "" };
    done_list done = { NULL, 0, 0, 0 };
    options o;

    if (options_read(argc, argv, " --json --forces --svg --png --html --out-obj --csv --view --names"
                     " --tol --budget --cone --stages --solver --preset --net"
                     " --tilt --localise --strong --corners --coupled --cra-eps --cra-eta --cra-box --cra-nodes --effects"
                     " --worker --fallback --skip-done --jobs"
                     SCENE_OPTIONS, &o, &error)) {
        fprintf(stderr, "%s\n", error.line);
        return error.status;
    }
    if (o.files == 0 || ((o.svg || o.png || o.csv || o.model || o.html) && o.files > 1)) {
        fputs(o.files == 0 ? "stonepack: check needs a scene\n" : o.svg || o.png ? "stonepack: --svg and --png draw one scene\n"
              : o.csv ? "stonepack: --csv tells of one scene\n"
              : o.model ? "stonepack: --out-obj shows one scene\n"
              : "stonepack: --html tells of one scene\n", stderr);
        return EXIT_USAGE;
    }
    if (o.json || o.svg || o.png || o.html || o.csv || o.settings.coupled.asked) o.settings.localise = 1;   /* they show it */
    if (outputs_check(&o, NULL, &error) || outputs_check_obj("--out-obj", o.model, &error)
        || (o.done && done_read(o.done, &done, &error))) {
        fprintf(stderr, "%s\n", error.line);
        done_free(&done);
        return error.status;
    }
    if (done.torn) fputc('\n', stdout);                 /* what is appended to it starts a line of its own */
    const int worst = o.files > 1 && o.jobs > 1 ? check_beside(&o, &done, &error) : check_in_turn(&o, &done, &error);
    done_free(&done);
    return worst;
}
