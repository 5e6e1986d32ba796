#include "model.h"
#include "../motion.h"
#include "../files/text.h"
#include "scales.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A model being written. */
typedef struct model {
    FILE *out;
    const subject *of;
    int32_t vertices;                   /* written so far */
} model;

static void put_vertex(model *m, const sp_real x[3])
{
    char text[32];
    fputs("v", m->out);
    for (int c = 0; c < 3; c++) fprintf(m->out, " %s", text_shortest(x[c], text));
    fputs("\n", m->out);
    m->vertices++;
}

/* Vertices and faces of a block of this scene, whose name was written, in a group. */
static void put_solid(model *m, const sp_scene *s, int32_t b, const char *group)
{
    const sp_block *of = &s->block[b];
    const int32_t first = m->vertices + 1 - of->vertex;
    fprintf(m->out, "g %s\n", group);
    for (int32_t k = of->vertex; k < of->vertex + of->vertices; k++) put_vertex(m, s->vertex[k]);
    for (int32_t i = of->face; i < of->face + of->faces; i++) {
        fputs("f", m->out);
        for (int32_t k = s->face[i].corner; k < s->face[i].corner + s->face[i].corners; k++)
            fprintf(m->out, " %ld", (long)first + s->corner[k]);
        fputs("\n", m->out);
    }
}

/* `more` stands behind its name. */
static void put_block(model *m, const sp_scene *s, int32_t b, const char *more, const char *group)
{
    if (s->block[b].faces == 0) return;
    fprintf(m->out, "o %s%s\n", m->of->scene->name[b], more);
    put_solid(m, s, b, group);
}

static int put_moved(model *m, const mechanism *motion)
{
    const sp_scene *s = &m->of->scene->scene;
    sp_scene moved;
    const int good = mechanism_move(motion, s, &moved);
    for (int32_t b = 0; good && b < s->count.blocks; b++)
        if (motion_speed(s, m->of->result, b) > MOTION_STILL) put_block(m, &moved, b, "_moved", "moved");
    mechanism_free(&moved);
    return good;
}

/* A unit vector across d. */
static void across(const double d[3], double out[3])
{
    const int c = fabs(d[0]) <= fabs(d[1]) && fabs(d[0]) <= fabs(d[2]) ? 0 : fabs(d[1]) <= fabs(d[2]) ? 1 : 2;
    const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    const double size = sqrt(d[c1] * d[c1] + d[c2] * d[c2]);
    out[c] = 0;
    out[c1] = -d[c2] / size;
    out[c2] = d[c1] / size;
}

/* Its shaft and, a fifth of it long, its head. */
static void put_arrow(model *m, const sp_real from[3], const sp_real to[3])
{
    double d[3], side[3];
    sp_real wing[2][3];
    for (int c = 0; c < 3; c++) d[c] = (double)to[c] - (double)from[c];
    const double size = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (!(size > 0)) return;
    across(d, side);
    for (int w = 0; w < 2; w++)
        for (int c = 0; c < 3; c++) wing[w][c] = (sp_real)((double)to[c] - 0.2 * d[c] + (w ? -0.08 : 0.08) * size * side[c]);
    put_vertex(m, from);
    put_vertex(m, to);
    put_vertex(m, wing[0]);
    put_vertex(m, wing[1]);
    const long n = (long)m->vertices;
    fprintf(m->out, "l %ld %ld\nl %ld %ld %ld\n", n - 3, n - 2, n - 1, n - 2, n);
}

static void put_forces(model *m, const forces *f)
{
    const sp_scene *s = &m->of->scene->scene;
    if (!(f->largest > 0)) return;
    fputs("o forces\ng forces\n", m->out);
    for (int32_t i = 0; i < s->count.joints; i++) {
        sp_real from[3], to[3];
        double size;
        if (forces_arrow(f, s, i, from, to, &size) && size > 1e-3 * f->largest) put_arrow(m, from, to);
    }
}

/* Where a block passes its force on. */
typedef struct passing { int32_t joints; sp_real at[2][3]; } passing;

/* The thrust line: through each free block that two joints press on, from one point of force to the other. */
static int put_thrust(model *m, const forces *f)
{
    const sp_scene *s = &m->of->scene->scene;
    passing *p = calloc((size_t)s->count.blocks + 1, sizeof *p);
    int32_t lines = 0;
    if (!p) return 0;
    for (int32_t i = 0; f->largest > 0 && i < s->count.joints; i++) {
        sp_real from[3], to[3];
        double size;
        if (!forces_arrow(f, s, i, from, to, &size) || !(size > 1e-6 * f->largest)) continue;
        for (int end = 0; end < 2; end++) {
            passing *on = &p[end ? s->joint[i].b : s->joint[i].a];
            if (on->joints < 2) memcpy(on->at[on->joints], from, sizeof from);
            on->joints++;
        }
    }
    for (int32_t b = 0; b < s->count.blocks; b++) {
        if (s->block[b].fixed == SP_FIXED || p[b].joints != 2) continue;
        if (!lines++) fputs("o thrust\ng thrust\n", m->out);
        put_vertex(m, p[b].at[0]);
        put_vertex(m, p[b].at[1]);
        fprintf(m->out, "l %ld %ld\n", (long)m->vertices - 1, (long)m->vertices);
    }
    free(p);
    return 1;
}

static void put_head(FILE *out)
{
    fputs("#@ picture\n# Written by stonepack --out-obj: a picture of a result, not a scene. Lengths in m.\n", out);
}

int model_write(FILE *out, const subject *of)
{
    model m = { out, of, 0 };
    drawing d;
    forces f;
    mechanism motion;
    double size;
    memset(&d, 0, sizeof d);
    d.s = &of->scene->scene;
    d.v = view_choose(d.s, NULL);
    scales_choose(&d, &f, &motion, of->result, &size);
    put_head(out);
    if (f.largest > 0) fprintf(out, "# forces: %.6g N a metre, the largest of a joint %.6g N\n", 1 / f.scale, f.largest);
    if (motion.shift > 0) fprintf(out, "# moved: the farthest corner by %.6g m\n", motion.largest);
    for (int32_t b = 0; b < d.s->count.blocks; b++) put_block(&m, d.s, b, "", "blocks");
    if (motion.shift > 0 && !put_moved(&m, &motion)) return 0;
    put_forces(&m, &f);
    return put_thrust(&m, &f);
}

static int has_step(const model_step *step, int32_t steps, int32_t b)
{
    int32_t k = 0;
    while (k < steps && step[k].block != b) k++;
    return k < steps;
}

/* What moves while step k (from 1) falls; its farthest corner goes `way` [m]. */
static int put_step_moved(model *m, const model_step *step, int32_t k, double size, double way)
{
    const sp_scene *s = &m->of->scene->scene;
    sp_real *dq = calloc(6 * (size_t)s->count.blocks, sizeof *dq);
    sp_result falls;
    sp_scene moved;
    mechanism motion;
    drawing d;
    if (!dq) return 0;
    memset(&d, 0, sizeof d);
    memset(&falls, 0, sizeof falls);
    d.s = s;
    d.v = view_choose(s, NULL);
    falls.verdict = SP_UNSTABLE;
    falls.dq = dq;
    for (int32_t i = 0; i < step->moves; i++)
        memcpy(dq + 6 * (size_t)step->move[i].block, step->move[i].dq, sizeof step->move->dq);
    mechanism_scale(&motion, &d, &falls, size, way);
    const int good = mechanism_move(&motion, s, &moved);
    for (int32_t i = 0; good && i < step->moves; i++) {
        const int32_t b = step->move[i].block;
        if (s->block[b].faces == 0 || !(motion_speed(s, &falls, b) > MOTION_STILL)) continue;
        fprintf(m->out, "o %04ld_%s_moved\n", (long)k, m->of->scene->name[b]);
        put_solid(m, &moved, b, "moved");
    }
    mechanism_free(&moved);
    free(dq);
    return good;
}

int model_write_steps(FILE *out, const host_scene *scene, const model_step *step, int32_t steps)
{
    const sp_scene *s = &scene->scene;
    const subject of = { scene, NULL, NULL, { 0, 0, 0 }, 0, NULL, NULL };
    model m = { out, &of, 0 };
    double size;
    const double block = scales_blocks(s, &size);
    put_head(out);
    for (int32_t b = 0; b < s->count.blocks; b++) if (!has_step(step, steps, b)) put_block(&m, s, b, "", "start");
    for (int32_t k = 0; k < steps; k++) {
        const int32_t b = step[k].block;
        if (s->block[b].faces == 0) continue;
        fprintf(out, "o %04ld_%s\n", (long)k + 1, scene->name[b]);
        put_solid(&m, s, b, step[k].group);
    }
    for (int32_t k = 0; k < steps; k++)
        if (step[k].moves && !put_step_moved(&m, &step[k], k + 1, size, scales_way(block, size))) return 0;
    return 1;
}
