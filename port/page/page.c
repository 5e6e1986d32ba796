/* page: what a page calls. One scene as read, one as it is changed, the last check of that; all texts are the program's.
 *
 * Numbers go out as tables of doubles, a row each, which stay until the next call that makes them. */
#define _POSIX_C_SOURCE 200809L         /* open_memstream */
#include "changed.h"
#include "../host/command/report.h"
#include "../host/files/obj_write.h"
#include "../host/motion.h"
#include "../host/picture/svg.h"
#include "../host/weakest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#ifdef __wasm__
#define CALLED(name) __attribute__((export_name(#name))) name
#else
#define CALLED(name) name
#endif

enum { WORDS = 64, BLOCK_ROW = 10, JOINT_ROW = 17 };

static struct page {
    char *in;                   /* what the page writes: options, path, model */
    char *out;                  /* what it reads: report, JSON, scene, picture */
    char *word[WORDS];
    options asked;
    sp_real mu;                 /* of its options; below 0: none */
    host_scene read;
    changed changed;
    report report;              /* of changed.now */
    void *memory;               /* of its result */
    int has_result;
    double *blocks, *joints;
    failure error;
} page;

double now(void) { return 0; }          /* a page has its own clock */

/* ------------------------------------------------------------------------------------------------------------------ texts */

/* Room for n bytes, and a zero after them. */
char *CALLED(page_room)(int32_t n)
{
    free(page.in);
    page.in = n >= 0 ? malloc((size_t)n + 1) : NULL;
    if (page.in) page.in[n] = 0;
    return page.in;
}

const char *CALLED(page_error)(void) { return page.error.line; }

typedef int put_text(FILE *out);

/* What `put` writes, or NULL. */
static const char *told(put_text *put)
{
    size_t n;
    free(page.out);
    page.out = NULL;
    FILE *out = open_memstream(&page.out, &n);
    if (!out) return NULL;
    const int failed = put(out);
    return fclose(out) == 0 && !failed ? page.out : NULL;
}

static int put_report(FILE *out) { report_text(out, &page.report); return 0; }
static int put_json(FILE *out) { report_json(out, &page.report); return 0; }
static int put_remarks(FILE *out)
{
    json_out j = { out, 0 };
    json_open(&j, NULL, '{');
    remarks_json(&j, &page.read.remarks);
    json_close(&j, '}');
    return 0;
}
static int put_scene(FILE *out)
{
    const host_scene *s = &page.changed.now;
    return obj_write(out, &s->scene, s->name, s->path, &page.error);
}
static int put_picture(FILE *out)
{
    const view_wish any = { 0, 0, 0 };
    const subject of = { &page.changed.now, &page.report.result, NULL, any, 0, NULL, NULL };
    return !svg_write(out, &of);
}

/* The report of `check`, its JSON with all forces, of that the remarks alone, the scene as a file, its picture as SVG.       NULL: none, see page_error */
const char *CALLED(page_report)(void) { return page.has_result ? told(put_report) : NULL; }
const char *CALLED(page_json)(void) { return page.has_result ? told(put_json) : NULL; }
const char *CALLED(page_remarks)(void) { return told(put_remarks); }
const char *CALLED(page_scene)(void) { return page.changed.now.memory ? told(put_scene) : NULL; }
const char *CALLED(page_picture)(void) { return page.has_result ? told(put_picture) : NULL; }

/* --------------------------------------------------------------------------------------------------------------- the scene */

static void forget_result(void)
{
    const report empty = { 0 };
    free(page.memory);
    page.memory = NULL;
    page.report = empty;
    page.has_result = 0;
}

static void close_scene(void)
{
    const host_scene empty = { 0 };
    forget_result();
    changed_free(&page.changed);
    scene_free(&page.read);
    page.read = empty;
}

/* The first byte that no text contains, as file.c has it; NULL: none. */
static const char *odd_byte(const char *s, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (((unsigned char)s[i] < 32 && !memchr("\t\n\v\f\r", s[i], 5)) || s[i] == 127) return s + i;
    return NULL;
}

/* Words of the program's command line at `s`, each with a zero behind it.     returns what stands behind them */
static char *take_words(char *s, int32_t words)
{
    int n = 2;
    static char command[] = "check";
    page.word[0] = page.word[1] = command;
    for (int32_t k = 0; k < words && n < WORDS; k++, s += strlen(s) + 1) page.word[n++] = s;
    page.error.status = options_read(n, page.word, SCENE_OPTIONS " --tilt --tol ", &page.asked, &page.error);
    page.mu = page.asked.scene.mu;
    return s;
}

static int parse(const char *path, const char *text, size_t n)
{
    char *copy = malloc(n + 1);
    if (!copy) return fail_with(&page.error, EXIT_MEMORY, path, 0, "out of memory");
    memcpy(copy, text, n);
    copy[n] = 0;
    return scene_parse(path, copy, n, &page.asked.scene, &page.read, &page.error);
}

/* Read a model: page_room holds `words` options, its path, each with a zero behind it, and `length` bytes of its text.
 *   returns 0 or an exit status; page_error tells */
int32_t CALLED(page_open)(int32_t words, int32_t length)
{
    const failure none = { 0, "" };
    close_scene();
    page.error = none;
    char *path = take_words(page.in, words), *text = path + strlen(path) + 1;
    if (page.error.status) return page.error.status;
    if (odd_byte(text, (size_t)length)) return fail_with(&page.error, EXIT_SCENE, path, 0, "not a text file");
    if (!parse(path, text, (size_t)length)) (void)changed_open(&page.changed, &page.read, &page.error);
    page.changed.tilt = page.asked.tilt;
    page.changed.azimuth = page.asked.azimuth;
    return page.error.status;
}

/* Names of the blocks that are left: that of block b. */
const char *CALLED(page_name)(int32_t b) { return page.changed.now.name[b]; }

/* Numbers of blocks, vertices, faces, corners, joints, points; blocks as read. */
int32_t CALLED(page_count)(int32_t what)
{
    const sp_capacity *n = &page.changed.now.scene.count;
    const int32_t of[] = { n->blocks, n->vertices, n->faces, n->corners, n->joints, n->points,
                           page.read.scene.count.blocks };
    return of[what];
}

const sp_real *CALLED(page_vertices)(void) { return page.changed.now.scene.vertex[0]; }
const int32_t *CALLED(page_corners)(void) { return page.changed.now.scene.corner; }
const sp_face *CALLED(page_faces)(void) { return page.changed.now.scene.face; }         /* corner, corners */
const sp_real *CALLED(page_points)(void) { return page.changed.now.scene.point[0]; }
const sp_real *CALLED(page_gravity)(void) { return page.changed.now.scene.gravity; }

/* Number as read, fixed, mass, centroid, diameter, first face, faces, vertices of each block. */
const double *CALLED(page_blocks)(void)
{
    const sp_scene *s = &page.changed.now.scene;
    double *more = realloc(page.blocks, ((size_t)s->count.blocks * BLOCK_ROW + 1) * sizeof *more);
    if (!more) return NULL;
    page.blocks = more;
    for (int32_t b = 0; b < page.read.scene.count.blocks; b++) {
        const int32_t k = page.changed.number[b];
        if (k < 0) continue;
        const sp_block *x = &s->block[k];
        const double row[BLOCK_ROW] = { b, x->fixed, (double)x->mass, (double)x->centroid[0], (double)x->centroid[1],
                                        (double)x->centroid[2], (double)x->diameter, x->face, x->faces, x->vertices };
        memcpy(more + (size_t)k * BLOCK_ROW, row, sizeof row);
    }
    return page.blocks;
}

/* ------------------------------------------------------------------------------------------------------------ what changes */

void CALLED(page_friction)(double mu)
{
    page.changed.mu = mu;
    page.asked.scene.mu = mu >= 0 ? (sp_real)mu : page.mu;
}

void CALLED(page_tilt)(double degrees, double azimuth)
{
    page.changed.tilt = degrees;
    page.changed.azimuth = azimuth;
}

/* b: its number as read, -1: no push */
void CALLED(page_push)(int32_t b, double fx, double fy, double fz, double x, double y, double z)
{
    const changed_push push = { b, { (sp_real)fx, (sp_real)fy, (sp_real)fz }, { (sp_real)x, (sp_real)y, (sp_real)z } };
    page.changed.push = push;
}

/* Block b as read: how far it was moved, whether it is taken out, in which directions it is held. page_build follows. */
void CALLED(page_block)(int32_t b, double x, double y, double z, int32_t out, int32_t fixed)
{
    const sp_real by[3] = { (sp_real)x, (sp_real)y, (sp_real)z };
    memcpy(page.changed.move[b], by, sizeof by);
    page.changed.out[b] = out;
    page.changed.fixed[b] = (uint32_t)fixed & SP_FIXED;
}

/* How block b was held as read. */
int32_t CALLED(page_held)(int32_t b) { return (int32_t)page.read.scene.block[b].fixed; }

int32_t CALLED(page_build)(void)
{
    forget_result();
    page.error.status = 0;
    return changed_build(&page.changed, &page.error);
}

/* ------------------------------------------------------------------------------------------------------------- the answer */

/* Check the scene as it is now.     returns the verdict, an sp_verdict; below 0: an exit status, page_error tells */
int32_t CALLED(page_check)(void)
{
    forget_result();
    page.error.status = 0;
    changed_apply(&page.changed);
    page.asked.forces = page.asked.settings.localise = 1;
    page.report.scene = &page.changed.now;
    page.report.options = &page.asked;
    const sp_status status = run_check(&page.changed.now.scene, &page.asked.settings, &page.report.result, &page.report.cost,
                                       &page.memory);
    if (status != SP_OK) {
        forget_result();
        return -fail_status(&page.error, status, page.read.path, 0, "");
    }
    page.has_result = 1;
    return (int32_t)page.report.result.verdict;
}

/* Blocks a and b, force on b, its point, utilisation, largest tension, normal, first point, points, area, own friction of each joint. */
const double *CALLED(page_joints)(void)
{
    const sp_scene *s = &page.changed.now.scene;
    double *more = realloc(page.joints, ((size_t)s->count.joints * JOINT_ROW + 1) * sizeof *more);
    if (!more || !page.has_result) return NULL;
    page.joints = more;
    for (int32_t i = 0; i < s->count.joints; i++) {
        const sp_joint *j = &s->joint[i];
        sp_joint_force f;
        if (sp_joint_resultant(s, &page.report.result, i, &f) != SP_OK) return NULL;
        const double row[JOINT_ROW] = { j->a, j->b, (double)f.force[0], (double)f.force[1], (double)f.force[2],
                                        (double)f.point[0], (double)f.point[1], (double)f.point[2], (double)f.utilisation,
                                        (double)page.report.result.demand[i].tension, (double)j->n[0], (double)j->n[1],
                                        (double)j->n[2], j->point, j->points, (double)j->area,
                                        (double)page.changed.own_mu[i] };
        memcpy(more + (size_t)i * JOINT_ROW, row, sizeof row);
    }
    return page.joints;
}

/* Velocity and spin of each block; NULL: nothing moves. */
const sp_real *CALLED(page_motion)(void)
{
    return page.has_result && page.report.result.verdict == SP_UNSTABLE ? motion_shown(&page.report.result) : NULL;
}

/* The joint that is nearest to its limit, -1: none is near. */
int32_t CALLED(page_weakest)(void)
{
    return page.has_result ? weakest_told(&page.changed.now.scene, &page.report.result) : -1;
}

/* Was the verdict verified? */
int32_t CALLED(page_verified)(void) { return page.has_result && page.report.result.verified; }

/* How many times the push (and what other live loads there are) it bears: infinite, or -1: not decided, -2: none. */
double CALLED(page_margin)(void)
{
    sp_limit_result x;
    run_cost cost;
    void *memory;
    changed_apply(&page.changed);
    const sp_status status = run_limit(&page.changed.now.scene, NULL, &x, &cost, &memory);
    free(memory);
    if (status != SP_OK || x.kind == SP_LIMIT_UNDECIDED) return -1;
    return x.kind == SP_LIMIT_NONE ? -2 : x.kind == SP_LIMIT_UNBOUNDED ? HUGE_VAL : (double)x.multiplier;
}
