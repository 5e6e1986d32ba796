#include "mechanism.h"
#include "../motion.h"
#include "through.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Where a corner of block b goes: x -> c + R (x - c) + shift v, R the rotation by shift w.                  [Rodrigues] */
static void move_point(const mechanism *m, const sp_scene *s, int32_t b, const sp_real x[3], double shift, sp_real out[3])
{
    const sp_real *dq = motion_shown(m->result) + 6 * (size_t)b, *o = s->block[b].centroid;
    const double rate = view_length(dq + 3), angle = shift * rate, k = rate > 0 ? 1 / rate : 0;
    const double w[3] = { k * (double)dq[3], k * (double)dq[4], k * (double)dq[5] };
    double d[3], along;
    for (int c = 0; c < 3; c++) d[c] = (double)x[c] - (double)o[c];
    along = dot(w, d);
    for (int c = 0; c < 3; c++) {
        const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        const double turned = d[c] * cos(angle) + (w[c1] * d[c2] - w[c2] * d[c1]) * sin(angle)
                            + w[c] * along * (1 - cos(angle));
        out[c] = (sp_real)((double)o[c] + (rate > 0 ? turned : d[c]) + shift * (double)dq[c]);
    }
}

/* How far its fastest corner goes. */
static double farthest(const mechanism *m, const sp_scene *s, double shift)
{
    double most = 0;
    for (int32_t b = 0; b < s->count.blocks; b++)
        for (int32_t k = 0; k < s->block[b].vertices && motion_speed(s, m->result, b) > 0; k++) {
            const sp_real *x = s->vertex[s->block[b].vertex + k];
            sp_real y[3], d[3];
            move_point(m, s, b, x, shift, y);
            for (int c = 0; c < 3; c++) d[c] = y[c] - x[c];
            most = fmax(most, view_length(d));
        }
    return most;
}

void mechanism_marks(const mechanism *m, const sp_scene *s, unsigned char *mark)
{
    for (int32_t b = 0; b < s->count.blocks; b++)
        mark[b] = m->shift > 0 && motion_speed(s, m->result, b) > MOTION_STILL ? MARK_FALLS : MARK_PLAIN;
}

int mechanism_move(const mechanism *m, const sp_scene *s, sp_scene *moved)
{
    *moved = *s;
    moved->vertex = malloc(((size_t)s->count.vertices + 1) * sizeof *s->vertex);
    moved->block = malloc(((size_t)s->count.blocks + 1) * sizeof *s->block);
    if (!moved->vertex || !moved->block) return 0;
    memcpy(moved->vertex, s->vertex, (size_t)s->count.vertices * sizeof *s->vertex);
    memcpy(moved->block, s->block, (size_t)s->count.blocks * sizeof *s->block);
    for (int32_t b = 0; b < s->count.blocks; b++) {
        if (!(motion_speed(s, m->result, b) > 0)) continue;
        for (int32_t k = s->block[b].vertex; k < s->block[b].vertex + s->block[b].vertices; k++)
            move_point(m, s, b, s->vertex[k], m->shift, moved->vertex[k]);
        move_point(m, s, b, s->block[b].centroid, m->shift, moved->block[b].centroid);
    }
    return 1;
}

void mechanism_free(sp_scene *moved)
{
    free(moved->vertex);
    free(moved->block);
}

int mechanism_draw(const drawing *moved, const unsigned char *mark)
{
    faces seen;
    const int good = faces_find(&seen, moved) && faces_draw(&seen, moved, mark) && through_draw(moved, &seen, mark);
    faces_free(&seen);
    return good;
}

void mechanism_scale(mechanism *m, drawing *d, const sp_result *result, double size, double length)
{
    double probe, rate;
    memset(m, 0, sizeof *m);
    m->result = result;
    if (!motion_is_told(d->s, result)) return;
    probe = 1e-3 * size * (motion_is_virtual(result) ? 1 / fmax((double)result->coupled.eta, 1e-300) : 1);
    rate = farthest(m, d->s, probe) / probe;
    if (!(rate > 0)) return;
    m->shift = length / rate;
    m->largest = farthest(m, d->s, m->shift);
    for (int32_t b = 0; b < d->s->count.blocks; b++)
        for (int32_t k = 0; k < d->s->block[b].vertices && motion_speed(d->s, result, b) > 1e-3; k++) {
            sp_real y[3];
            move_point(m, d->s, b, d->s->vertex[d->s->block[b].vertex + k], m->shift, y);
            drawing_cover(d, y);
        }
}
