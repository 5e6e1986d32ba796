#include "tilt.h"
#include "run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEGREE (3.14159265358979323846 / 180)

/* -------------------------------------------------------------------------------------------------------------- gravity */

/* h0: x (y where gravity is within 26 degrees of x) made orthogonal to gravity; h1 = h0 x g: y where gravity is down. */
void tilt_level(const sp_real gravity[3], double h[2][3])
{
    double g[3], size = 0, across = 0;
    for (int k = 0; k < 3; k++) size += (double)gravity[k] * (double)gravity[k];
    size = sqrt(size);
    for (int k = 0; k < 3; k++) g[k] = size > 0 ? (double)gravity[k] / size : 0;
    const int first = fabs(g[0]) > 0.9;
    for (int k = 0; k < 3; k++) {
        h[0][k] = (k == first) - g[first] * g[k];
        across += h[0][k] * h[0][k];
    }
    for (int k = 0; k < 3; k++) h[0][k] *= size / sqrt(across);
    for (int k = 0; k < 3; k++) h[1][k] = h[0][(k + 1) % 3] * g[(k + 2) % 3] - h[0][(k + 2) % 3] * g[(k + 1) % 3];
}

/* g' = cos t g + sin t (cos a h0 + sin a h1) */
void tilt_turn(double degrees, double azimuth, sp_real gravity[3])
{
    const double a = azimuth * DEGREE, c = cos(degrees * DEGREE), s = sin(degrees * DEGREE);
    double h[2][3];
    if (!(fabs(degrees) > 0)) return;
    tilt_level(gravity, h);
    for (int k = 0; k < 3; k++)
        gravity[k] = (sp_real)(c * (double)gravity[k] + s * (cos(a) * h[0][k] + sin(a) * h[1][k]));
}

/* --------------------------------------------------------------------------------------------------------------- margin
 *
 * Gravity turns by t towards azimuth a, so that  weight cos t + |weight| sin t h(a)  acts, h level. Where all loads are weights
 * that is as admissible as  weight + tan t (body force along h(a)): one limit for every azimuth. What stands is convex in
 * tan t h(a), so the mechanism of each azimuth bounds the whole region by a line, and the nearest line gives the worst one. */

/* The body force along a level direction: azimuth [rad]. */
static void body_towards(double azimuth, double h[2][3], sp_real body[3])
{
    for (int k = 0; k < 3; k++) body[k] = (sp_real)(cos(azimuth) * h[0][k] + sin(azimuth) * h[1][k]);
}

/* The limit towards one azimuth [rad].     *lambda: what stands */
static sp_status towards(const sp_scene *scene, const sp_settings *settings, double azimuth, double h[2][3],
                         sp_limit_result *x, double *lambda, void **memory)
{
    sp_scene s = *scene;
    run_cost cost;
    body_towards(azimuth, h, s.body);
    const sp_status status = run_limit(&s, settings, x, &cost, memory);
    if (status != SP_OK) return status;
    *lambda = x->kind == SP_LIMIT_UNBOUNDED ? HUGE_VAL
            : x->kind == SP_LIMIT_FOUND ? (double)x->multiplier : fmax(0, (double)x->lower);
    return SP_OK;
}

/* Power of a mass that moves with velocity v: lost to gravity, and gained from either level direction. */
static void add_power(double mass, const double v[3], const sp_real gravity[3], double h[2][3], double *dead, double live[2])
{
    for (int k = 0; k < 3; k++) {
        const double push = mass * v[k];
        *dead -= push * (double)gravity[k];
        for (int i = 0; i < 2; i++) live[i] += push * h[i][k];
    }
}

/* Velocity of a load's point on its block, v + w x (p - centroid). */
static void velocity_of(const sp_load *l, const sp_block *b, const sp_real *dq, double v[3])
{
    const sp_real *w = dq + 3;
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        v[k] = (double)dq[k] + ((double)w[i] * (double)(l->point[j] - b->centroid[j])
                              - (double)w[j] * (double)(l->point[i] - b->centroid[i]));
    }
}

/* Where the line that the mechanism draws comes nearest: its azimuth [rad] and tan t. */
static double nearest_line(const sp_scene *scene, const sp_limit_result *x, double h[2][3], double *azimuth)
{
    double dead = 0, live[2] = { 0, 0 }, v[3];
    for (int32_t b = 0; b < scene->count.blocks; b++) {
        const sp_real *dq = x->dq + 6 * (size_t)b;
        if (scene->block[b].fixed == SP_FIXED) continue;
        for (int k = 0; k < 3; k++) v[k] = (double)dq[k];
        add_power((double)scene->block[b].mass, v, scene->gravity, h, &dead, live);
    }
    for (int32_t n = 0; n < scene->count.loads; n++) {  /* weights laid on */
        const sp_load *l = &scene->load[n];
        if (scene->block[l->block].fixed == SP_FIXED) continue;
        velocity_of(l, &scene->block[l->block], x->dq + 6 * (size_t)l->block, v);
        add_power((double)l->mass, v, scene->gravity, h, &dead, live);
    }
    *azimuth = atan2(live[1], live[0]);
    return x->kind == SP_LIMIT_FOUND ? dead / hypot(live[0], live[1]) : HUGE_VAL;
}

/* Does it stand while level? */
static sp_status ask_level(const sp_scene *scene, const sp_settings *settings, tilt_margin *m)
{
    void *memory = NULL;
    sp_limit_result x;
    run_cost cost;
    sp_scene still = *scene;
    for (int k = 0; k < 3; k++) still.body[k] = 0;
    const sp_status status = run_limit(&still, settings, &x, &cost, &memory);
    free(memory);
    if (status != SP_OK) return status;
    m->stands = x.kind == SP_LIMIT_UNBOUNDED;
    m->undecided = x.kind == SP_LIMIT_UNDECIDED;
    return SP_OK;
}

/* All azimuths, and what each says: its limit's tan t, and where the line of its mechanism is. */
typedef struct around {
    const sp_scene *scene;
    const sp_settings *settings;
    double (*h)[3];
    struct { sp_status status; sp_limit_kind kind; double lambda, line, at; } way[TILT_AZIMUTHS];
} around;

/* The k-th of them. */
static void ask_azimuth(void *job, int32_t k)
{
    around *all = job;
    void *memory = NULL;
    sp_limit_result x;
    all->way[k].status = towards(all->scene, all->settings, 360.0 * k / TILT_AZIMUTHS * DEGREE, all->h, &x, &all->way[k].lambda,
                                 &memory);
    if (all->way[k].status == SP_OK) {
        all->way[k].kind = x.kind;
        all->way[k].line = nearest_line(all->scene, &x, all->h, &all->way[k].at);
    }
    free(memory);
}

/* Tasks, at once where the settings say how. */
static void run_tasks(const sp_settings *settings, void (*task)(void *job, int32_t k), void *job, int32_t n)
{
    const sp_parallel *p = settings->parallel;
    if (p) p->run(p->self, task, job, n);
    else for (int32_t k = 0; k < n; k++) task(job, k);
}

/* The angle of every azimuth, and the nearest line of them all: its tan t, HUGE_VAL where there is none, and azimuth [rad]. */
static sp_status ask_around(const sp_scene *scene, const sp_settings *settings, double h[2][3], tilt_margin *m, double *nearest,
                            double *azimuth)
{
    sp_settings unseen = *settings;
    around all;
    if (settings->parallel) unseen.watch = NULL;        /* who watches is told by one thread alone */
    memset(&all, 0, sizeof all);
    all.scene = scene;
    all.settings = &unseen;
    all.h = h;
    run_tasks(settings, ask_azimuth, &all, TILT_AZIMUTHS);
    *nearest = HUGE_VAL;
    for (int k = 0; k < TILT_AZIMUTHS; k++) {
        if (all.way[k].status != SP_OK) return all.way[k].status;
        m->angle[k] = atan(all.way[k].lambda) / DEGREE;
        m->undecided += all.way[k].kind == SP_LIMIT_UNDECIDED;
        if (!(all.way[k].line < *nearest)) continue;
        *nearest = all.way[k].line;
        *azimuth = all.way[k].at;
    }
    return SP_OK;
}

/* From the nearest line on, each azimuth's mechanism shows a nearer one, or none. */
static sp_status refine(const sp_scene *scene, const sp_settings *settings, double h[2][3], double azimuth, tilt_margin *m,
                        void **memory)
{
    double best = HUGE_VAL;
    for (int it = 0; it < 12; it++) {
        void *own = NULL;
        sp_limit_result x;
        double lambda;
        const sp_status status = towards(scene, settings, azimuth, h, &x, &lambda, &own);
        if (status != SP_OK || !(lambda < best * (1 - 1e-12))) { free(own); return status; }
        free(*memory);
        *memory = own;
        m->worst = x;
        best = lambda;
        m->least = atan(lambda) / DEGREE;
        m->within = (atan(lambda + (double)x.within) - atan(lambda)) / DEGREE;
        m->azimuth = azimuth / DEGREE;
        if (!(nearest_line(scene, &x, h, &azimuth) < HUGE_VAL)) return SP_OK;
    }
    return SP_OK;
}

int tilt_at_least(const tilt_margin *m) { return m->undecided > 0 || m->least >= 90; }

sp_status tilt_measure(const sp_scene *scene, const sp_settings *settings, tilt_margin *m, void **memory)
{
    double h[2][3], nearest = HUGE_VAL, azimuth = 0;
    sp_status status;
    memset(m, 0, sizeof *m);
    *memory = NULL;
    status = ask_level(scene, settings, m);
    if (status != SP_OK || !m->stands) return status;
    tilt_level(scene->gravity, h);
    m->least = 90;
    status = ask_around(scene, settings, h, m, &nearest, &azimuth);
    if (status == SP_OK && nearest < HUGE_VAL) status = refine(scene, settings, h, azimuth, m, memory);
    for (int k = 0; k < TILT_AZIMUTHS; k++)
        if (m->angle[k] < m->least) { m->least = m->angle[k]; m->azimuth = 360.0 * k / TILT_AZIMUTHS; }
    m->azimuth = fmod(floor(1e9 * m->azimuth + 0.5) / 1e9 + 360, 360);     /* a billionth of a degree: 0 is 0 */
    return status;
}

#ifndef SP_NO_SLIDING
/* ------------------------------------------------------------------------------------------------------ without dilatancy
 *
 * All loads c times as large have the same states of sliding, with c times the forces: as above, tan t is lambda. */

/* Azimuth [rad] of the normal that is farthest from gravity's line; *level: its part across gravity. */
static double plane_azimuth(const sp_scene *scene, double h[2][3], double *level)
{
    double azimuth = 0, size = 0;
    *level = 0;
    for (int k = 0; k < 3; k++) size += h[0][k] * h[0][k];
    for (int32_t i = 0; i < scene->count.joints && size > 0; i++) {
        double x[2] = { 0, 0 };
        for (int q = 0; q < 2; q++)
            for (int k = 0; k < 3; k++) x[q] += (double)scene->joint[i].n[k] * h[q][k] / sqrt(size);
        if (!(hypot(x[0], x[1]) > *level)) continue;
        *level = hypot(x[0], x[1]);
        azimuth = atan2(x[1], x[0]);
    }
    return azimuth;
}

static double slide_degrees(sp_real lambda) { return lambda >= 0 ? atan((double)lambda) / DEGREE : -1; }

/* Towards one azimuth [rad]. */
static sp_status slide_towards(const sp_scene *scene, const sp_settings *settings, double azimuth, double h[2][3],
                               tilt_slide *t)
{
    void *memory = NULL, *more = NULL;
    sp_scene s = *scene;
    sp_limit_result limit;
    sp_sliding_result x;
    run_cost cost;
    double size = 0;
    body_towards(azimuth, h, s.body);
    for (int k = 0; k < 3; k++) size += h[0][k] * h[0][k];
    sp_status status = run_limit(&s, settings, &limit, &cost, &memory);
    if (status == SP_OK) status = run_sliding(&s, settings, &limit, &x, &cost, &more);
    if (status == SP_OK) {
        t->azimuth = fmod(floor(1e9 * azimuth / DEGREE + 0.5) / 1e9 + 360, 360);
        for (int k = 0; k < 3; k++) t->body[k] = (sp_real)((double)s.body[k] / sqrt(size));
        t->kind = x.kind;
        t->reason = x.reason;
        t->upper = slide_degrees(x.upper);
        t->associative = slide_degrees(x.associative);
        t->lower = slide_degrees(x.lower);
        t->lower_strong = slide_degrees(x.lower_strong);
        t->residual = (double)x.residual;
    }
    free(more);
    free(memory);
    return status;
}

sp_status tilt_slides(const sp_scene *scene, const sp_settings *settings, tilt_slide *slide, int *n)
{
    double h[2][3], level;
    sp_status status = SP_OK;
    tilt_level(scene->gravity, h);
    const double first = plane_azimuth(scene, h, &level);
    const int ways = level > 1e-6 ? 2 : TILT_SLIDES;
    for (*n = 0; *n < ways && status == SP_OK; ++*n)
        status = slide_towards(scene, settings, (ways == 2 ? first : 0) + 360.0 * *n / ways * DEGREE, h, &slide[*n]);
    return status;
}
#endif
