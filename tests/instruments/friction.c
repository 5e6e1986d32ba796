/* friction: attempts to move what is called strong, one line a scene:
 *
 *     name | corners | kind | reason | attempts | settled | moved
 *
 * friction N FILE.obj...     N attempts a scene at most, fewer the more corners it has
 *
 * An attempt is a start of the sweeps of solvers/strong/sweep.c that sp_strong does not try: what a set of corners settles at
 * that carries the load alone, no corner of which can be left out; forces at rest times any factor; any forces within friction;
 * nothing pressed. What pressure holds is strong for every friction, so that is drawn anew each time, .01 to 3 times itself.
 * What holds with pressure anywhere in the joints is tried every other four times with friction at the centre of it. What it
 * comes to is judged with sp_strong's own code; settled: it meets every law of contact, or rests. Exit status 1: it moved.
 * One file with the library, whose private parts it uses. strong_cases.py runs it.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../stonepack.c"
#include "../../port/host/run.h"
#include "../../port/host/files/scene.h"

#define MOST_SWEEPS 1024                /* of an attempt, of all corners */
#define REST ((sp_real)1e-6)             /* acceleration, in all forces of a block / its mass, that is rest but for rounding */
#define FLOPS 4e8                       /* of the attempts on a scene, in all */

typedef struct attack {
    sp_scene *scene;
    sp_real *mu;                        /* joints: of the scene as it is */
    const sp_real *rest;                /* forces at rest */
    sp__starts *w;
    uint64_t seed;
    int any_mu, plate;
    long tried, settled, moved;
} attack;

/* 0 .. 1                                                                                         [xorshift64*: Vigna 2016] */
static double chance(attack *a)
{
    a->seed ^= a->seed >> 12; a->seed ^= a->seed << 25; a->seed ^= a->seed >> 27;
    return (double)((a->seed * 2685821657736338717u) >> 11) / 9007199254740992.0;
}

/* Friction of all joints, each its own times .01 to 3 where any is as good. */
static void draw_mu(attack *a)
{
    const double all = chance(a) < 0.5 ? 1 : 0.01 * pow(300, chance(a));
    for (int32_t j = 0; a->any_mu && j < a->scene->count.joints; j++)
        a->scene->joint[j].strength.mu = (sp_real)((double)a->mu[j] * all * (chance(a) < 0.8 ? 1 : 0.01 * pow(300, chance(a))));
}

/* Do the corners that are on rest, alone? */
static int rests(attack *a)
{
    sp__sweep *s = &a->w->sweep;
    memset(s->f, 0, 3 * (size_t)s->pb->points * sizeof *s->f);
    sp__sweep_run(s, MOST_SWEEPS / 16, 0, (sp_real)1e-9);
    sp_real most = 0, load = 0;
    for (int32_t i = 0; i < 6 * s->pb->blocks; i++) {
        if (i % 6 > 2) continue;
        most = sp__max(most, sp__abs(s->a[i]) * s->M[i / 6].mass);
        load = sp__max(load, sp__abs(s->pb->p[i]));
    }
    return most < (sp_real)1e-4 * load;
}

/* A set of corners that rests alone and none of which can be left out, as far as few trials tell. */
static void minimal(attack *a)
{
    sp__sweep *s = &a->w->sweep;
    const int32_t V = s->corners, trials = V < 40 ? 2 * V : 24;
    memset(s->on, 1, (size_t)V);
    for (int32_t k = 0; k < trials; k++) {
        const int32_t v = (int32_t)(chance(a) * V) % V, n = k < trials / 3 ? 1 + V / 8 : 1;
        uint8_t kept[64];
        for (int32_t i = 0; i < n && i < 64; i++) { kept[i] = s->on[(v + i) % V]; s->on[(v + i) % V] = 0; }
        if (!rests(a)) for (int32_t i = 0; i < n && i < 64; i++) s->on[(v + i) % V] = kept[i];
    }
    rests(a);
}

/* Forces to start from: the k-th way. */
static void start(attack *a, long k)
{
    sp__sweep *s = &a->w->sweep;
    const size_t n = (size_t)s->pb->points;
    const double times = k % 4 == 1 ? 0.01 * pow(1e4, chance(a)) : 1;
    if (k % 4 == 0) { minimal(a); return; }
    for (size_t v = 0; v < n; v++) {
        sp_real *f = s->f + 3 * v;
        const double fn = k % 4 == 1 ? times * (double)a->rest[3 * v] : k % 4 == 3 ? 0
                        : chance(a) < 0.5 ? 0 : chance(a) * (double)a->w->j.scale[0].load * 4;
        const double turn = 6.283185307179586 * chance(a), rub = chance(a);
        f[0] = (sp_real)fn;
        f[1] = (sp_real)(k % 4 == 1 ? times * (double)a->rest[3 * v + 1] : rub * fn * cos(turn));
        f[2] = (sp_real)(k % 4 == 1 ? times * (double)a->rest[3 * v + 2] : rub * fn * sin(turn));
    }
}

static void attempt(attack *a, long k)
{
    sp__starts *w = a->w;
    draw_mu(a);
    memset(w->sweep.on, 1, (size_t)w->sweep.corners);
    w->sweep.plates = a->plate && k / 4 % 2;
    start(a, k);
    memset(w->sweep.on, 1, (size_t)w->sweep.corners);
    sp__sweep_run(&w->sweep, MOST_SWEEPS, (int)(k & 1), 16 * (sp_real)SP_EPSILON);
    const sp_real residual = sp__certify_moving(&w->j, w->M, w->sweep.f, w->sweep.a, w->sweep.plates, &w->moves);
    a->tried++;
    a->settled += residual <= w->j.set->tol || w->moves < REST;
    a->moved += residual <= w->j.set->tol && w->moves >= SP__MOVES;
}

/* Attempts on a scene that is strong. */
static void attack_scene(host_scene *h, const sp_strong_result *r, long most, attack *a)
{
    sp_arena arena;
    sp__holds s;
    void *memory = NULL;
    const sp_settings set = sp_settings_default();
    memset(a, 0, sizeof *a);
    a->scene = &h->scene;
    a->rest = r->f;
    a->seed = 88172645463325252u;
    a->any_mu = r->reason == SP_STRONG_PRESSURE;
    a->plate = r->plate;
    a->mu = malloc(((size_t)h->scene.count.joints + 1) * sizeof *a->mu);
    for (int32_t j = 0; a->mu && j < h->scene.count.joints; j++) a->mu[j] = h->scene.joint[j].strength.mu;
    if (a->mu && run_arena(sp__holds_memory(&h->scene, NULL), &arena, &memory) == SP_OK
        && sp__holds_open(&s, &h->scene, &set, &arena) == SP_OK && sp__inertias(&s.pb, s.starts.arm, s.starts.M)) {
        a->w = &s.starts;
        sp__sweep_begin(&a->w->sweep);
        for (long k = 0; k < most && (double)a->w->sweep.flops < FLOPS; k++) attempt(a, k);
    }
    for (int32_t j = 0; a->mu && j < h->scene.count.joints; j++) h->scene.joint[j].strength.mu = a->mu[j];
    free(a->mu);
    free(memory);
}

/* The scene of a file: asked, and attacked where it is strong.     returns 1: it moved, or can't be read */
static int one(const char *path, long most)
{
    host_scene h;
    failure error;
    sp_result x;
    sp_strong_result r;
    run_cost cost;
    attack a = { 0 };
    void *memory = NULL, *more = NULL;
    const scene_settings as_it_is = scene_settings_default();
    const sp_settings set = sp_settings_default();
    memset(&r, 0, sizeof r);
    if (scene_read(path, &as_it_is, &h, &error)) { printf("%s | can't be read\n", path); return 1; }
    int bad = run_check(&h.scene, &set, &x, &cost, &memory) != SP_OK
           || run_strong(&h.scene, &set, NULL, x.f, &r, &cost, &more) != SP_OK;
    if (!bad && r.kind >= SP_STRONG_AT_CORNERS && !sp__scene_strong(&h.scene)) attack_scene(&h, &r, most, &a);
    printf("%s | %ld | %s | %s | %ld | %ld | %ld\n", path, (long)h.scene.count.points, sp_strong_text(r.kind),
           sp_strong_reason_text(r.reason), a.tried, a.settled, a.moved);
    fflush(stdout);
    free(memory);
    free(more);
    scene_free(&h);
    return bad || a.moved > 0;
}

int main(int argc, char **argv)
{
    int bad = 0;
    for (int k = 2; k < argc; k++) bad |= one(argv[k], atol(argv[1]));
    return bad;
}
