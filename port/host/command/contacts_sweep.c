#include "../files/json_out.h"
#include "../run.h"
#include "contacts_sweep.h"
#include "progress.h"
#include "report.h"

#include <math.h>
#include <stdlib.h>

enum { DECADES = 6, GRID = 2 * DECADES + 1, ROWS = GRID + 1 };

static const double finest = 1e-8;              /* of the smaller block */

/* One distance, and what it makes of the scene. */
typedef struct sweep_row {
    double share, length;                       /* of the smaller block; of the smallest [m] */
    int in_force;                               /* the scene's own, by options, file or default */
    int32_t pairs, joints, points, overlaps;
    double area;                                /* of all joints [m^2] */
    sp_verdict verdict;
} sweep_row;

typedef struct sweep {
    int rows;
    sweep_row row[ROWS];
    int first, last;                            /* rows of the widest range with the same pairs and verdict; -1: none touch */
} sweep;

/* ------------------------------------------------------------------------------------------------------------ distances */

static void add_row(sweep *w, double share, double smallest, int in_force)
{
    const sweep_row row = { share, share * smallest, in_force, 0, 0, 0, 0, 0, SP_UNDECIDED };
    w->row[w->rows++] = row;
}

/* Two of a decade, 1 and 3, and the scene's own at its place. */
static void set_distances(sweep *w, double own, double smallest)
{
    int before = 1;
    w->rows = 0;
    for (int k = 0; k < GRID; k++) {
        const int tens = k / 2;
        const double share = finest * pow(10, tens) * (k % 2 ? 3 : 1);
        const int same = fabs(share - own) <= 1e-6 * own;
        if (before && own < share && !same) add_row(w, own, smallest, 1);
        if (same || own < share) before = 0;
        add_row(w, share, smallest, same);
    }
    if (before) add_row(w, own, smallest, 1);
}

/* ----------------------------------------------------------------------------------------------------------- one distance */

/* Joints come pair by pair. */
static void count_contacts(const touching_found *found, sweep_row *row)
{
    const sp_scene *s = &found->scene;
    row->joints = s->count.joints;
    row->points = s->count.points;
    row->overlaps = found->overlaps;
    for (int32_t i = 0; i < s->count.joints; i++) {
        const sp_joint *j = &s->joint[i];
        row->area += (double)j->area;
        row->pairs += i == 0 || j[-1].a != j->a || j[-1].b != j->b;
    }
}

static int try_distance(const host_scene *s, const options *o, sweep_row *row, failure *error)
{
    touching t = s->touching;
    touching_found found;
    sp_result result;
    run_cost cost;
    void *memory = NULL;
    sp_status status;

    if (!row->in_force) {
        t.has_distance = t.share = 1;
        t.distance = (sp_real)row->share;
    }
    sp_contact_settings set = touching_settings(t);
    set.strength = s->strength;
    if (!touching_find(&s->scene, &set, &found))
        return fail_with(error, EXIT_MEMORY, s->path, 0, "out of memory: contacts at %g%%", 100 * row->share);
    count_contacts(&found, row);
    status = run_check(&found.scene, &o->settings, &result, &cost, &memory);
    if (status == SP_OK) row->verdict = result.verdict;
    free(memory);
    touching_free(&found);
    return status == SP_OK ? 0 : scene_refused(s, &o->settings, status, error);
}

static int is_alike(const sweep_row *a, const sweep_row *b) { return a->pairs == b->pairs && a->verdict == b->verdict; }

/* The widest range by the ratio of its ends, of equal ones the last: that of larger distances. */
static void find_steady(sweep *w)
{
    double widest = 0;
    w->first = w->last = -1;
    for (int k = 0, end; k < w->rows; k = end) {
        for (end = k + 1; end < w->rows && is_alike(&w->row[k], &w->row[end]); end++) { }
        const double ratio = w->row[end - 1].share / fmax(w->row[k].share, finest / 10);
        if (w->row[k].pairs == 0 || !(ratio >= 0.99 * widest)) continue;
        widest = ratio;
        w->first = k;
        w->last = end - 1;
    }
}

/* ---------------------------------------------------------------------------------------------------------------- telling */

static const char *text_of(sp_verdict v) { return v == SP_STABLE ? "STABLE" : v == SP_UNSTABLE ? "UNSTABLE" : "UNDECIDED"; }

static void print_table(const host_scene *s, const sweep *w, int quiet)
{
    const sweep_row *first = &w->row[w->first < 0 ? 0 : w->first], *last = &w->row[w->last < 0 ? 0 : w->last];
    if (w->first < 0) printf("%s: nothing touches at any distance up to 1%%\n", s->path);
    else if (w->first == w->last)
        printf("%s: pairs that touch and verdict differ from distance to distance\n", s->path);
    else {
        printf("%s: %s with %ld pair%s that touch%s, the same from %g%% to %g%%", s->path, text_of(first->verdict),
               (long)first->pairs, text_s(first->pairs), first->pairs == 1 ? "es" : "", 100 * first->share, 100 * last->share);
        report_near(stdout, first->verdict == SP_STABLE || first->pairs == w->row[w->rows - 1].pairs ? 0 : s->near, s->inside,
                    s->across);
    }
    if (quiet) return;
    printf("  %-16s %11s %8s %8s %8s %13s %9s   %s\n", "distance", "least [m]", "pairs", "joints", "points", "area [m^2]",
           "overlaps", "verdict");
    for (int k = 0; k < w->rows; k++) {
        const sweep_row *r = &w->row[k];
        char share[24];
        snprintf(share, sizeof share, "%.6g%%", 100 * r->share);
        printf("%c %-16s %11.3g %8ld %8ld %8ld %13.6g %9ld   %s\n", r->in_force ? '*' : ' ', share, r->length, (long)r->pairs,
               (long)r->joints, (long)r->points, r->area, (long)r->overlaps, text_of(r->verdict));
    }
    puts("* in force; a distance is a share of the smaller block of each pair, least [m] that of the smallest block");
    remarks_print(stdout, &s->remarks);
}

static void json_row(json_out *j, const sweep_row *r)
{
    json_open(j, NULL, '{');
    json_real(j, "share", r->share);
    json_real(j, "least_distance", r->length);
    json_bool(j, "in_force", r->in_force);
    json_int(j, "pairs", r->pairs);
    json_int(j, "joints", r->joints);
    json_int(j, "points", r->points);
    json_real(j, "area", r->area);
    json_int(j, "overlaps", r->overlaps);
    json_string(j, "verdict", sp_verdict_text(r->verdict));
    json_close(j, '}');
}

static void print_json(const host_scene *s, const sweep *w)
{
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", s->path);
    json_int(&j, "blocks", s->scene.count.blocks);
    json_open(&j, "sweep", '[');
    for (int k = 0; k < w->rows; k++) json_row(&j, &w->row[k]);
    json_close(&j, ']');
    if (w->first < 0) json_null(&j, "steady");
    else {
        json_open(&j, "steady", '{');
        json_real(&j, "from", w->row[w->first].share);
        json_real(&j, "to", w->row[w->last].share);
        json_int(&j, "pairs", w->row[w->first].pairs);
        json_string(&j, "verdict", sp_verdict_text(w->row[w->first].verdict));
        json_close(&j, '}');
    }
    scene_remarks_json(&j, s);
    json_close(&j, '}');
    fputc('\n', stdout);
}

int contacts_sweep(const host_scene *s, const options *o, failure *error)
{
    const double smallest = (double)touching_smallest(&s->scene);
    const sp_contact_settings own = touching_settings(s->touching);
    sweep w;
    int status = 0;

    if (!(smallest > 0)) return fail_with(error, EXIT_SCENE, s->path, 0, "no block has faces: nothing touches at any distance");
    set_distances(&w, (double)own.distance / (own.absolute ? smallest : 1), smallest);
    progress_begin(o->quiet);
    for (int k = 0; k < w.rows && !status; k++) {
        progress_show("%d of %d: distance %g%% ...", k + 1, w.rows, 100 * w.row[k].share);
        status = try_distance(s, o, &w.row[k], error);
    }
    progress_end();
    if (status) return status;
    find_steady(&w);
    if (o->json) print_json(s, &w);
    else print_table(s, &w, o->quiet);
    return 0;
}
