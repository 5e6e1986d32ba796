/* settle: where do the stones come to rest?  --confirm: does the scene keep still, and does statics say the same? */
#include "commands.h"
#include "outputs.h"

#ifndef WITH_BULLET

#include "../files/failure.h"

#include <stdio.h>

int command_settle(int argc, char **argv)
{
    (void)argc, (void)argv;
    fputs("stonepack: settle needs Bullet and g++, which were missing when this was built: apt-get install g++ libbullet-dev, "
          "then make\n", stderr);
    return EXIT_UNAVAILABLE;
}

#else

#include "../../../settle/settle.h"
#include "../files/file.h"
#include "../files/json_out.h"
#include "../files/obj_write.h"
#include "../files/text.h"
#include "../picture/sheet.h"
#include "progress.h"
#include "report.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#define FRAMES 9                /* drawn */
#define MOMENTS 17              /* kept: when there are more, every other is let go */

/* ------------------------------------------------------------------------------------------------------------ settings */

/* Settings that --set knows. */
static const struct { const char *name; int real; size_t at; const char *help; } setting[] = {
#define REAL(name, help)  { #name, 1, offsetof(settle_settings, name), help }
#define WHOLE(name, help) { #name, 0, offsetof(settle_settings, name), help }
    WHOLE(ramp_steps, "steps at each of three smaller gravities and the full one"),
    WHOLE(steps, "steps at full gravity after these"),
    WHOLE(tamps, "rounds of tamping"), REAL(tamp, "gravity while tamping, in full ones"),
    WHOLE(tamp_steps, "steps of it in a round"), WHOLE(rest_steps, "steps of rest after it"), REAL(dt, "of a step, s"),
    WHOLE(iterations, "of the contact solver in a step"),
    REAL(restitution, "0 .. 1"), REAL(damping, "share of velocity lost in a second"),
    REAL(margin, "by which hulls are shrunk and rounded, m"), REAL(touch, "gaps up to this count as contacts, m"),
    REAL(mass_floor, "kg"), REAL(wall, "half the container's thickness, m"),
    REAL(lift, "of free stones at the start, m"), REAL(lowest, "height of a settled stone's centroid, at least, m"),
    REAL(energy, "J/kg below which a wait ends; 0: never"), WHOLE(quiet, "steps it must stay there"),
    REAL(moved, "--confirm: most a held stone moves, m"), REAL(turned, "--confirm: most it turns, degrees"),
    { "width",  1, offsetof(settle_settings, container),                      "of an open container, m; 0: none" },
    { "depth",  1, offsetof(settle_settings, container) + sizeof(double),     "of it, m" },
    { "height", 1, offsetof(settle_settings, container) + 2 * sizeof(double), "of it, m" },
    { "floor",  1, offsetof(settle_settings, floor) + 2 * sizeof(double),     "height of its floor, m" }
};

static void print_settings(const settle_settings *s)
{
    puts("settings of stonepack settle --set NAME=VALUE,... and their defaults (lengths in m; with --confirm in mean block "
         "edges):\n");
    for (size_t k = 0; k < sizeof setting / sizeof *setting; k++) {
        const void *at = (const char *)s + setting[k].at;
        const double x = setting[k].real ? *(const double *)at : (double)*(const int32_t *)at;
        printf("  %-12s %-12.6g %s\n", setting[k].name, x, setting[k].help);
    }
}

/* NAME=VALUE,NAME=VALUE */
static int read_settings(const char *list, settle_settings *s, failure *error)
{
    while (list && *list) {
        const size_t n = strcspn(list, "=,"), end = n + strcspn(list + n, ",");
        const text_word value = { list + n + 1, end > n ? end - n - 1 : 0 };
        size_t k = 0;
        int32_t i = 0;
        double x = 0;
        while (k < sizeof setting / sizeof *setting && (strlen(setting[k].name) != n || memcmp(setting[k].name, list, n))) k++;
        if (k == sizeof setting / sizeof *setting)
            return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: --set has no setting '%.*s', see stonepack settle --set "
                             "help", n < 40 ? (int)n : 40, list);
        if (end == n || (setting[k].real ? text_double(value, &x) : text_int(value, &i)) != TEXT_NUMBER)
            return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: --set %s needs a %snumber", setting[k].name,
                             setting[k].real ? "" : "whole ");
        if (setting[k].real) memcpy((char *)s + setting[k].at, &x, sizeof x);
        else memcpy((char *)s + setting[k].at, &i, sizeof i);
        list += list[end] ? end + 1 : end;
    }
    return 0;
}

/* -------------------------------------------------------------------------------------------------------------- one run */

/* All that a run needs and leaves behind. */
typedef struct session {
    const options *o;
    host_scene in;
    settle_assembly assembly;
    settle_settings set;
    settle_pair *pair;
    settle_result result;
    sheet_frame frame[MOMENTS];           /* vertices as they were at multiples of `stride` steps, where asked for */
    int stopped;                        /* by Ctrl-C */
    int frames, bar;                    /* bar: shown so far, in percent */
    int32_t stride;
    int32_t container;                  /* its block in the scene written, -1: none */
} session;

static int32_t fixed_blocks(const sp_scene *s)
{
    int32_t n = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) n += s->block[b].fixed != 0;
    return n;
}

/* x' = R (x - c) + t, with lengths of the simulation. */
static void place_point(const settle_pose *p, double scale, const sp_real x[3], sp_real out[3])
{
    double d[3];
    for (int c = 0; c < 3; c++) d[c] = scale * (double)x[c] - p->c[c];
    for (int c = 0; c < 3; c++)
        out[c] = (sp_real)((p->R[3 * c] * d[0] + p->R[3 * c + 1] * d[1] + p->R[3 * c + 2] * d[2] + p->t[c]) / scale);
}

/* Vertices of the whole scene with these poses, malloc's; NULL: out of memory. */
static sp_real (*moved_vertices(const session *s, const settle_pose *pose))[3]
{
    const sp_scene *scene = &s->in.scene;
    sp_real (*x)[3] = malloc(((size_t)scene->count.vertices + 1) * sizeof *x);
    for (int32_t b = 0; x && b < scene->count.blocks; b++)
        for (int32_t k = scene->block[b].vertex; k < scene->block[b].vertex + scene->block[b].vertices; k++) {
            if (scene->block[b].fixed) memcpy(x[k], scene->vertex[k], sizeof *x);
            else place_point(&pose[b], s->assembly.scale, scene->vertex[k], x[k]);
        }
    return x;
}

/* Add a moment; of too many every other goes.                                              returns 0: out of memory */
static int keep_moment(session *s, int32_t step, double energy, const settle_pose *pose)
{
    sheet_frame *f;
    if (s->frames == MOMENTS) {
        for (int k = 1; k < MOMENTS; k++) {
            if (k % 2) free(s->frame[k].vertex);
            else s->frame[k / 2] = s->frame[k];
            s->frame[k].vertex = NULL;
        }
        s->frames = (MOMENTS + 1) / 2;
        s->stride *= 2;
    }
    if (step % s->stride) return 1;
    f = &s->frame[s->frames++];
    f->vertex = moved_vertices(s, pose);
    snprintf(f->caption, sizeof f->caption, "%.2f s, kinetic energy %.2g J", step * s->set.dt, energy);
    return f->vertex != NULL;
}

/* Ctrl-C: the stones as they are now are the result; none of them has settled. */
static int keep_poses(session *s, int32_t step, double energy, const settle_pose *pose)
{
    const size_t bytes = (size_t)s->assembly.stones * sizeof *pose;
    if (s->o->confirm) return s->stopped = 1;
    s->result.pose = malloc(bytes);
    if (!s->result.pose) return 0;
    memcpy(s->result.pose, pose, bytes);
    s->result.stones = s->assembly.stones;
    s->result.settled = fixed_blocks(&s->in.scene);
    s->result.steps = step;
    s->result.energy = energy;
    return s->stopped = 1;
}

/* A bar on a terminal, and the moments that are drawn. */
static int32_t watch_step(void *user, int32_t step, int32_t steps, double energy, const settle_pose *pose)
{
    session *s = user;
    const int percent = steps ? (int)(100.0 * step / steps) : 100;
    if (progress_stopped() && keep_poses(s, step, energy, pose)) return 1;
    if (percent > s->bar) {
        char bar[31];
        for (int k = 0; k < 30; k++) bar[k] = k < percent * 30 / 100 ? '#' : '.';
        bar[30] = 0;
        s->bar = percent;
        progress_show("settling [%s] step %ld of %ld, kinetic energy %.2e J", bar, (long)step, (long)steps, energy);
    }
    return s->o->frames && step % s->stride == 0 && !keep_moment(s, step, energy, pose);
}

/* Friction of given contacts where it is not the scene's. */
static int gather_friction(session *s)
{
    const sp_scene *scene = &s->in.scene;
    s->set.mu = (double)s->in.mu;
    s->pair = malloc(((size_t)scene->count.joints + 1) * sizeof *s->pair);
    if (!s->pair) return 0;
    for (int32_t i = 0; i < scene->count.joints; i++) {
        const sp_joint *c = &scene->joint[i];
        const settle_pair p = { c->a, c->b, (double)c->strength.mu };
        if (p.mu < s->set.mu || p.mu > s->set.mu) s->pair[s->set.pairs++] = p;
    }
    s->set.pair = s->pair;
    return 1;
}

/* Under the middle of all free stones, its floor at the height asked for. */
static void put_container(session *s)
{
    double low[2] = { HUGE_VAL, HUGE_VAL }, high[2] = { -HUGE_VAL, -HUGE_VAL };
    const sp_scene *scene = &s->in.scene;
    for (int32_t b = 0; b < scene->count.blocks; b++)
        for (int32_t k = 0; k < scene->block[b].vertices && !scene->block[b].fixed; k++)
            for (int c = 0; c < 2; c++) {
                low[c] = fmin(low[c], (double)scene->vertex[scene->block[b].vertex + k][c]);
                high[c] = fmax(high[c], (double)scene->vertex[scene->block[b].vertex + k][c]);
            }
    for (int c = 0; c < 2 && low[0] <= high[0]; c++) s->set.floor[c] = s->assembly.scale * 0.5 * (low[c] + high[c]);
}

static int fail_settle(settle_status status, const session *s, failure *error)
{
    const int32_t b = s->assembly.block;
    const int code = status == SETTLE_E_MEMORY || status == SETTLE_E_STOPPED ? EXIT_MEMORY
                   : status == SETTLE_E_SETTINGS || status == SETTLE_E_NUMBER || status == SETTLE_E_ARGUMENT ? EXIT_USAGE
                   : EXIT_SCENE;
    if (code == EXIT_USAGE) return fail_with(error, code, NULL, 0, "stonepack: settle: %s", settle_status_text(status));
    if (code == EXIT_SCENE && b >= 0)
        return fail_with(error, code, s->in.path, 0, "block '%.60s': %s", s->in.name[b], settle_status_text(status));
    return fail_with(error, code, s->in.path, 0, "%s", code == EXIT_MEMORY ? "out of memory" : settle_status_text(status));
}

/* Which stone is no body: the first that is refused alone. */
static int32_t find_refused(const session *s)
{
    settle_settings still = s->set;
    still.ramp_steps = still.steps = still.tamps = still.pairs = 0;
    still.watch = NULL;
    for (int32_t k = 0; k < s->assembly.stones; k++) {
        settle_result r;
        if (settle_run(1, &s->assembly.stone[k], &still, &r) != SETTLE_OK) return k;
        settle_result_free(&r);
    }
    return -1;
}

static int simulate(session *s, failure *error)
{
    settle_status status = settle_from_scene(&s->in.scene, s->o->confirm, &s->assembly);
    double size = 0;

    if (status) return fail_settle(status, s, error);
    for (int c = 0; c < 3; c++) size += (double)s->in.scene.gravity[c] * (double)s->in.scene.gravity[c];
    for (int c = 0; c < 3; c++)                         /* lengths and masses of --confirm are scaled, and so is gravity */
        s->set.gravity[c] = (double)s->in.scene.gravity[c] * (s->o->confirm && size > 0 ? 9.81 / sqrt(size) : 1);
    if (!gather_friction(s)) return fail_settle(SETTLE_E_MEMORY, s, error);
    put_container(s);
    s->set.watch = watch_step;
    s->set.user = s;
    s->bar = -1;
    status = settle_run(s->assembly.stones, s->assembly.stone, &s->set, &s->result);
    progress_end();
    if (status == SETTLE_E_STOPPED && s->stopped) return 0;
    if (status == SETTLE_E_MESH) s->assembly.block = find_refused(s);
    return status ? fail_settle(status, s, error) : 0;
}

/* -------------------------------------------------------------------------------------------------------------- written */

/* The container as its five inner faces, an open support: a picture shows what is inside. */
static sp_status add_container(const session *s, sp_scene *out)
{
    static const int32_t size[5] = { 4, 4, 4, 4, 4 };
    static const int32_t corner[20] = { 0, 1, 3, 2, 0, 2, 6, 4, 1, 5, 7, 3, 0, 4, 5, 1, 2, 3, 7, 6 };
    const sp_mesh mesh = { 8, 5, NULL, size, corner };
    sp_mesh m = mesh;
    sp_real xyz[24];
    for (int k = 0; k < 8; k++)
        for (int c = 0; c < 3; c++) {
            const double along = c == 2 ? k >> 2 : (k >> c & 1) - 0.5;
            xyz[3 * k + c] = (sp_real)((s->set.floor[c] + along * s->set.container[c]) / s->assembly.scale);
        }
    m.xyz = xyz;
    return sp_scene_block(out, &m, 1, SP_FIXED, NULL);
}

static sp_status add_blocks(const session *s, sp_scene *out)
{
    const sp_scene *in = &s->in.scene;
    sp_real (*x)[3] = moved_vertices(s, s->result.pose);
    int32_t *number = malloc(((size_t)in->count.corners + (size_t)in->count.faces + 1) * sizeof *number);
    sp_status status = x && number ? SP_OK : SP_E_MEMORY;
    for (int32_t b = 0; b < in->count.blocks && status == SP_OK; b++) {
        const sp_block *block = &in->block[b];
        int32_t n = block->faces;
        const sp_mesh mesh = { block->vertices, block->faces, x[block->vertex], number, number + block->faces };
        for (int32_t f = 0; f < block->faces; f++) {
            const sp_face *face = &in->face[block->face + f];
            number[f] = face->corners;
            for (int32_t k = 0; k < face->corners; k++) number[n++] = in->corner[face->corner + k] - block->vertex;
        }
        status = sp_scene_block(out, &mesh, block->density > 0 ? block->density : 1, block->fixed, NULL);
    }
    free(number);
    free(x);
    return status;
}

/* Contacts of the scene written get the friction they had while it settled. */
static void keep_friction(const session *s, sp_scene *out)
{
    for (int32_t i = 0; i < out->count.joints; i++) {
        sp_joint *c = &out->joint[i];
        for (int32_t k = 0; k < s->set.pairs; k++)
            if ((s->pair[k].a == c->a && s->pair[k].b == c->b) || (s->pair[k].a == c->b && s->pair[k].b == c->a))
                c->strength = sp_strength_friction((sp_real)s->pair[k].mu);
    }
}

/* A scene in new memory with room for `cap` and all blocks in it. */
static sp_status start_scene(const session *s, const sp_capacity *cap, void **memory, sp_scene *out)
{
    sp_arena arena;
    sp_status status;
    free(*memory);
    status = run_arena(sp_scene_memory(cap), &arena, memory);
    if (status == SP_OK) status = sp_scene_create(out, cap, &arena);
    if (status == SP_OK) memcpy(out->gravity, s->in.scene.gravity, sizeof out->gravity);
    if (status == SP_OK) status = add_blocks(s, out);
    if (status == SP_OK && s->container >= 0) status = add_container(s, out);
    return status;
}

/* Contacts by their faces, in a scene of exactly the size they need. */
static sp_status find_near(const session *s, sp_capacity *cap, void **memory, sp_scene *out)
{
    sp_contact_settings near = sp_contact_settings_default();
    sp_contact_report found = { 0, 0, 0, 0, NULL };
    sp_status status = SP_E_CAPACITY;
    near.distance = (sp_real)s->o->near;
    near.absolute = 1;
    near.angle = (sp_real)0.05;                 /* 3 degrees */
    near.strength = sp_strength_friction(s->in.mu);
    for (int pass = 0; pass < 2 && status == SP_E_CAPACITY; pass++) {
        void *room;
        sp_arena scratch;
        cap->joints = found.joints;
        cap->points = found.points;
        status = start_scene(s, cap, memory, out);
        if (status != SP_OK) return status;
        /* four times as much: stones inside each other by a hair cross like combs */
        status = run_arena(4 * run_bytes(out, SP_FOR_CONTACTS, NULL), &scratch, &room);
        if (status == SP_OK) status = sp_contacts_find(out, &near, scratch, &found);
        free(room);
    }
    return status;
}

/* The scene as it came to rest. */
static int build_settled(session *s, void **memory, sp_scene *out, failure *error)
{
    const sp_strength strength = sp_strength_friction(s->in.mu);
    sp_capacity cap = s->in.scene.count;
    sp_status status;

    cap.joints = cap.points = 0;
    s->container = s->set.container[0] > 0 ? cap.blocks : -1;
    if (s->container >= 0) cap.blocks += 1, cap.vertices += 8, cap.faces += 5, cap.corners += 20;
    if (s->o->near > 0) status = find_near(s, &cap, memory, out);
    else {
        settle_count_joints(&s->result, &s->in.scene, &cap);
        status = start_scene(s, &cap, memory, out);
        if (status == SP_OK) status = settle_add_joints(&s->result, s->container, &strength, out);
    }
    if (status != SP_OK) return fail_status(error, status, s->in.path, 0, "as it came to rest");
    keep_friction(s, out);
    return 0;
}

static int write_scene(session *s, failure *error)
{
    sp_scene out;
    void *memory = NULL;
    const char **name = malloc(((size_t)s->in.scene.count.blocks + 1) * sizeof *name);
    int status = name ? build_settled(s, &memory, &out, error) : fail_with(error, EXIT_MEMORY, s->in.path, 0, "out of memory");
    FILE *file = status ? NULL : file_create(s->o->out, error);
    if (file) {
        memcpy(name, s->in.name, (size_t)s->in.scene.count.blocks * sizeof *name);
        name[s->in.scene.count.blocks] = "container";
        status = obj_write(file, &out, name, s->o->out, error);
        status = file_finish(file, s->o->out, status, error);
    } else if (!status) status = error->status;
    free(name);
    free(memory);
    return status;
}

static int write_frames(session *s, failure *error)
{
    sheet_frame shown[FRAMES], *last;
    const int n = s->frames < FRAMES - 1 ? s->frames : FRAMES - 1;
    FILE *file = file_create(s->o->frames, error);
    const char *slash = strrchr(s->in.path, '/');
    const int32_t fixed = fixed_blocks(&s->in.scene);
    char title[160];
    int status = 0;
    if (!file) return error->status;
    for (int k = 0; k < n; k++) shown[k] = s->frame[k * s->frames / n];
    last = &shown[n];
    memset(last, 0, sizeof *last);
    last->vertex = moved_vertices(s, s->result.pose);
    snprintf(last->caption, sizeof last->caption, "%.2f s, kinetic energy %.2g J", s->result.steps * s->set.dt,
             s->result.energy);
    snprintf(title, sizeof title, "%.60s: %ld of %ld stone%s at rest after %.2g s", slash ? slash + 1 : s->in.path,
             (long)(s->result.settled - fixed), (long)(s->result.stones - fixed), text_s(s->result.stones - fixed),
             s->result.steps * s->set.dt);
    const sheet_page page = { title, &s->o->view, &s->in.remarks, NULL, 0 };
    if (!last->vertex || !sheet_write(file, &s->in.scene, n + 1, shown, &page))
        status = fail_with(error, EXIT_MEMORY, s->in.path, 0, "out of memory");
    free(last->vertex);
    return file_finish(file, s->o->frames, status, error);
}

/* ----------------------------------------------------------------------------------------------------------------- told */

/* Mean diameter of the free stones [m]. */
static double mean_diameter(const sp_scene *s)
{
    double sum = 0;
    int32_t n = 0;
    for (int32_t b = 0; b < s->count.blocks; b++)
        if (!s->block[b].fixed) sum += (double)s->block[b].diameter, n++;
    return n ? sum / n : 1;
}

static void print_text(const session *s)
{
    const settle_result *r = &s->result;
    const int32_t fixed = fixed_blocks(&s->in.scene);
    int32_t points = 0;
    for (int32_t k = 0; k < r->contacts; k++) points += r->contact[k].points;
    if (s->stopped) fputs("stopped by Ctrl-C; stones as they were then\n", stderr);
    printf("%s: %ld of %ld stone%s settled in %ld step%s", s->in.path, (long)(r->settled - fixed), (long)(r->stones - fixed),
           text_s(r->stones - fixed), (long)r->steps, text_s(r->steps));
    report_near(stdout, 0, s->in.inside, s->in.across);    /* gaps close while they settle */
    if (s->o->quiet) return;
    if (r->settled == r->stones)
        printf("  at rest        kinetic energy %.2g J; nothing moved more than %.2g mm in the last 100 steps\n", r->energy,
               1e3 * r->drift);
    else
        printf("  at the end     kinetic energy %.2g J; in the last 100 steps one moved %.2g mm; those that fell out "
               "count, too\n", r->energy, 1e3 * r->drift);
    printf("  penetration    %.2g mm, %.2g mm per m of stone\n", 1e3 * r->penetration,
           1e3 * r->penetration / mean_diameter(&s->in.scene));
    printf("  contacts       %ld in %ld point%s\n", (long)r->contacts, (long)points, text_s(points));
    if (s->o->out) printf("  written        %s\n", s->o->out);
    remarks_print(stdout, &s->in.remarks);
}

static void print_json(const session *s, const sp_result *statics, const char *agree)
{
    const settle_result *r = &s->result;
    const double scale = s->assembly.scale;
    json_out j = { stdout, 0 };
    json_open(&j, NULL, '{');
    json_string(&j, "scene", s->in.path);
    json_int(&j, "stones", r->stones - fixed_blocks(&s->in.scene));
    json_int(&j, "settled", r->settled - fixed_blocks(&s->in.scene));
    json_int(&j, "steps", r->steps);
    json_real(&j, "kinetic_energy", r->energy);
    json_real(&j, "drift", r->drift / scale);
    json_real(&j, "penetration", r->penetration / scale);
    json_int(&j, "contacts", r->contacts);
    if (statics) {
        json_string(&j, "statics", sp_verdict_text(statics->verdict));
        json_string(&j, "settle", r->held ? "held" : "fell");
        json_real(&j, "moved", r->moved);
        json_real(&j, "turned", r->turned);
        json_string(&j, "together", agree);
    }
    scene_remarks_json(&j, &s->in);
    json_close(&j, '}');
    fputc('\n', stdout);
}

static void print_motion(const session *s)
{
    printf("  moved          %.2g block edges, turned %.2g degrees at most; held: up to %g and %g\n", s->result.moved,
           s->result.turned, s->set.moved, s->set.turned);
    remarks_print(stdout, &s->in.remarks);
}

/* The static verdict beside what the simulation did. */
static int compare_with_statics(session *s, failure *error)
{
    report r;
    void *memory = NULL;
    const char *agree;
    int status;

    memset(&r, 0, sizeof r);
    r.scene = &s->in;
    r.options = s->o;
    status = report_check(&r, &memory, error);
    if (!status) {
        status = r.result.verdict == SP_UNDECIDED || (r.result.verdict == SP_STABLE) != s->result.held ? EXIT_UNDECIDED
               : s->result.held ? EXIT_STABLE : EXIT_UNSTABLE;
        agree = r.result.verdict == SP_UNDECIDED ? "undecided" : status == EXIT_UNDECIDED ? "differ" : "agree";
        if (s->o->json) print_json(s, &r.result, agree);
        else {
            printf("%s: statics says %s, settle %s: they %s", s->in.path, sp_verdict_text(r.result.verdict),
                   s->result.held ? "held" : "fell", agree[0] == 'u' ? "can't be compared" : agree);
            report_near(stdout, r.result.verdict == SP_STABLE ? 0 : s->in.near, s->in.inside, s->in.across);
            if (!s->o->quiet) print_motion(s);
        }
    }
    free(memory);
    return status;
}

static int write_files(session *s, failure *error)
{
    const int status = s->o->frames ? write_frames(s, error) : 0;
    return status || !s->o->out ? status : write_scene(s, error);
}

static int settle_and_tell(session *s, failure *error)
{
    int status = scene_read(s->o->file[0], &s->o->scene, &s->in, error);
    if (!status) status = simulate(s, error);
    if (status) return status;
    outputs_tell_beside(s->o->out, &s->in.remarks);
    status = write_files(s, error);                     /* the answer is told in any case */
    if (s->o->confirm && !status) return s->stopped ? EXIT_STOPPED : compare_with_statics(s, error);
    if (s->o->json) print_json(s, NULL, NULL);
    else print_text(s);
    fflush(stdout);
    if (status || s->stopped) return status ? status : EXIT_STOPPED;
    return s->result.settled == s->result.stones ? EXIT_STABLE : EXIT_UNSTABLE;
}

int command_settle(int argc, char **argv)
{
    failure error = { 0, "" };
    options o;
    session s;
    int status = options_read(argc, argv, " -o --frames --view --set --near --json --confirm" SCENE_OPTIONS, &o, &error);

    memset(&s, 0, sizeof s);
    s.o = &o;
    s.container = -1;
    s.stride = 1;
    s.assembly.scale = 1;
    s.set = o.confirm ? settle_confirm_default() : settle_default();
    if (!status && o.set && strcmp(o.set, "help") == 0) {
        print_settings(&s.set);
        return 0;
    }
    if (!status && (o.files != 1 || (!o.out && !o.confirm && !o.frames)))
        status = fail_with(&error, EXIT_USAGE, NULL, 0, "stonepack: settle needs one scene, and -o, --frames or --confirm");
    if (!status) status = outputs_check(&o, NULL, &error);
    if (!status) status = outputs_check_obj("settle", o.out, &error);
    if (!status) status = outputs_check_beside("settle", o.file[0], o.out, &error);
    if (!status) status = read_settings(o.set, &s.set, &error);
    progress_begin(o.quiet);
    progress_hear();
    if (!status) status = settle_and_tell(&s, &error);
    if (status > EXIT_UNDECIDED && status != EXIT_STOPPED) fprintf(stderr, "%s\n", error.line);
    for (int k = 0; k < MOMENTS; k++) free(s.frame[k].vertex);
    settle_result_free(&s.result);
    settle_assembly_free(&s.assembly);
    free(s.pair);
    scene_free(&s.in);
    return status;
}

#endif
