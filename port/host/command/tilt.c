/* The tilt margin: gravity turns by t towards azimuth a, so that  weight cos t + |weight| sin t h(a)  acts, h level. Where all loads
 * are weights that is as admissible as  weight + tan t (body force along h(a)): one limit for every azimuth. What stands is convex
 * in tan t h(a), so the mechanism of each azimuth bounds the whole region by a line, and the nearest line gives the worst one. */
#include "../picture/tilt_svg.h"
#include "../run.h"
#include "tilt.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEGREE (3.14159265358979323846 / 180)

/* The limit towards one azimuth [rad].     *lambda: what stands */
static sp_status towards(const sp_scene *scene, const options *o, double azimuth, double h[2][3], sp_limit_result *x, double *lambda,
                         void **memory)
{
    sp_scene s = *scene;
    run_cost cost;
    for (int k = 0; k < 3; k++) s.body[k] = (sp_real)(cos(azimuth) * h[0][k] + sin(azimuth) * h[1][k]);
    const sp_status status = run_limit(&s, &o->settings, x, &cost, memory);
    if (status != SP_OK) return status;
    *lambda = x->kind == SP_LIMIT_UNBOUNDED ? HUGE_VAL : x->kind == SP_LIMIT_FOUND ? (double)x->multiplier : fmax(0, (double)x->lower);
    return SP_OK;
}

/* Where the line that the mechanism draws comes nearest: its azimuth [rad] and tan t. */
static double nearest_line(const sp_scene *scene, const sp_limit_result *x, double h[2][3], double *azimuth)
{
    double dead = 0, live[2] = { 0, 0 };
    for (int32_t b = 0; b < scene->count.blocks; b++)
        for (int k = 0; k < 3; k++) {
            const double push = (double)scene->block[b].mass * (double)x->dq[6 * b + k];
            if (scene->block[b].fixed == SP_FIXED) continue;
            dead -= push * (double)scene->gravity[k];
            for (int i = 0; i < 2; i++) live[i] += push * h[i][k];
        }
    for (int32_t n = 0; n < scene->count.loads; n++) {  /* weights laid on */
        const sp_load *l = &scene->load[n];
        const sp_block *b = &scene->block[l->block];
        const sp_real *v = x->dq + 6 * l->block, *w = v + 3;
        for (int k = 0; k < 3 && b->fixed != SP_FIXED; k++) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            const double turn = (double)w[i] * (double)(l->point[j] - b->centroid[j]) - (double)w[j] * (double)(l->point[i] - b->centroid[i]);
            const double push = (double)l->mass * ((double)v[k] + turn);
            dead -= push * (double)scene->gravity[k];
            for (int q = 0; q < 2; q++) live[q] += push * h[q][k];
        }
    }
    *azimuth = atan2(live[1], live[0]);
    return x->kind == SP_LIMIT_FOUND ? dead / hypot(live[0], live[1]) : HUGE_VAL;
}

/* Does it stand while level? */
static int stands_level(const host_scene *s, const options *o, tilt_margin *m, text_error *error)
{
    void *memory = NULL;
    sp_limit_result x;
    run_cost cost;
    sp_scene still = s->scene;
    for (int k = 0; k < 3; k++) still.body[k] = 0;
    const sp_status e = run_limit(&still, &o->settings, &x, &cost, &memory);
    free(memory);
    if (e != SP_OK) return scene_refused(s, &o->settings, e, error);
    m->stands = x.kind == SP_LIMIT_UNBOUNDED;
    m->undecided = x.kind == SP_LIMIT_UNDECIDED;
    return 0;
}

/* From the nearest line on, each azimuth's mechanism shows a nearer one, or none. */
static sp_status refine(const host_scene *s, const options *o, double h[2][3], double azimuth, tilt_margin *m, void **memory)
{
    double best = HUGE_VAL;
    for (int it = 0; it < 12; it++) {
        void *now = NULL;
        sp_limit_result x;
        double lambda;
        const sp_status status = towards(&s->scene, o, azimuth, h, &x, &lambda, &now);
        if (status != SP_OK || !(lambda < best * (1 - 1e-12))) { free(now); return status; }
        free(*memory);
        *memory = now;
        m->worst = x;
        best = lambda;
        m->least = atan(lambda) / DEGREE;
        m->within = (atan(lambda + (double)x.within) - atan(lambda)) / DEGREE;
        m->azimuth = azimuth / DEGREE;
        if (!(nearest_line(&s->scene, &x, h, &azimuth) < HUGE_VAL)) return SP_OK;
    }
    return SP_OK;
}

int tilt_at_least(const tilt_margin *m) { return m->undecided > 0 || m->least >= 90; }

int tilt_measure(const host_scene *s, const options *o, tilt_margin *m, void **memory, text_error *error)
{
    double h[2][3], nearest = HUGE_VAL, worst = 0;
    int status;
    memset(m, 0, sizeof *m);
    *memory = NULL;
    for (int32_t k = 0; k < s->scene.count.loads; k++) {
        const sp_load *l = &s->scene.load[k];
        if (l->live || l->force[0] * l->force[0] + l->force[1] * l->force[1] + l->force[2] * l->force[2] + l->couple[0] * l->couple[0]
                       + l->couple[1] * l->couple[1] + l->couple[2] * l->couple[2] > 0)
            return text_fail(error, EXIT_USAGE, s->path, 0, "--tilt-margin turns weights only, not the forces of this scene");
    }
    for (int32_t k = 0; k < s->scene.count.interfaces; k++) {           /* strength doesn't scale with gravity as cones do */
        const sp_joint *j = &s->scene.interface[k].joint;
        if (j->cohesion > 0 || j->tension > 0 || j->cap > 0)
            return text_fail(error, EXIT_USAGE, s->path, 0, "--tilt-margin is for joints without strength; check --tilt takes it along");
    }
    status = stands_level(s, o, m, error);
    if (status || !m->stands) return status;
    options_level(s->scene.gravity, h);
    m->least = 90;
    for (int k = 0; k < TILT_AZIMUTHS; k++) {
        const double azimuth = 360.0 * k / TILT_AZIMUTHS * DEGREE;
        void *now = NULL;
        sp_limit_result x;
        double lambda, at, line;
        const sp_status e = towards(&s->scene, o, azimuth, h, &x, &lambda, &now);
        if (e != SP_OK) { free(now); return scene_refused(s, &o->settings, e, error); }
        m->angle[k] = atan(lambda) / DEGREE;
        m->undecided += x.kind == SP_LIMIT_UNDECIDED;
        line = nearest_line(&s->scene, &x, h, &at);
        if (line < nearest) { nearest = line; worst = at; }
        free(now);
    }
    if (nearest < HUGE_VAL) {
        const sp_status e = refine(s, o, h, worst, m, memory);
        if (e != SP_OK) return scene_refused(s, &o->settings, e, error);
    }
    for (int k = 0; k < TILT_AZIMUTHS; k++)
        if (m->angle[k] < m->least) { m->least = m->angle[k]; m->azimuth = 360.0 * k / TILT_AZIMUTHS; }
    m->azimuth = fmod(floor(1e9 * m->azimuth + 0.5) / 1e9 + 360, 360);     /* a billionth of a degree: 0 is 0 */
    return 0;
}

int tilt_draw(FILE *out, const options *o, const tilt_margin *m)
{
    const tilt_plot plot = { m->angle, TILT_AZIMUTHS, m->least, m->azimuth, tilt_at_least(m), o->cone };
    return tilt_svg(out, &plot);
}
