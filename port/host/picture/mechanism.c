#include "mechanism.h"
#include "../motion.h"
#include "page.h"

#include <math.h>
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

/* Does this face look towards the viewer after it moved? Tells by its area on paper. */
static int is_seen_moved(const mechanism *m, const drawing *d, int32_t b, int32_t face)
{
    const sp_face *f = &d->s->face[face];
    double area = 0, first[2] = { 0, 0 }, before[2] = { 0, 0 };
    for (int32_t k = 0; k < f->corners; k++) {
        sp_real x[3];
        double at[2];
        move_point(m, d->s, b, d->s->vertex[d->s->corner[f->corner + k]], m->shift, x);
        view_point(&d->v, x, at);
        if (k == 0) { first[0] = at[0]; first[1] = at[1]; }
        if (k > 1) area += (before[0] - first[0]) * (at[1] - first[1]) - (before[1] - first[1]) * (at[0] - first[0]);
        before[0] = at[0];
        before[1] = at[1];
    }
    return area > 0;
}

/* The outline of a moved face; an edge between two seen faces is drawn with the first of them only. */
static void put_moved_outline(const mechanism *m, const drawing *d, const faces *f, int32_t b, int32_t face)
{
    const sp_face *of = &d->s->face[face];
    for (int32_t k = 0; k < of->corners; k++) {
        const int32_t other = faces_across(f, d->s, face, k);
        sp_real x[3], y[3];
        double from[2], to[2];
        if (other >= 0 && is_seen_moved(m, d, b, other) && (other < face || !f->bend[of->corner + k])) continue;
        move_point(m, d->s, b, d->s->vertex[d->s->corner[of->corner + k]], m->shift, x);
        move_point(m, d->s, b, d->s->vertex[d->s->corner[of->corner + (k + 1) % of->corners]], m->shift, y);
        drawing_point(d, x, from);
        drawing_point(d, y, to);
        fprintf(d->out, "M%.1f %.1fL%.1f %.1f", from[0], from[1], to[0], to[1]);
    }
}

void mechanism_draw(const mechanism *m, const drawing *d, const faces *f)
{
    if (!(m->shift > 0)) return;
    fprintf(d->out, "<g fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\" stroke-linejoin=\"round\">\n",
            INK_MOTION);
    for (int32_t b = 0; b < d->s->count.blocks; b++) {
        const int32_t end = d->s->block[b].face + d->s->block[b].faces;
        if (!(motion_speed(d->s, m->result, b) > 1e-3)) continue;
        fputs("<path d=\"", d->out);
        for (int32_t i = d->s->block[b].face; i < end; i++)
            if (is_seen_moved(m, d, b, i)) put_moved_outline(m, d, f, b, i);
        fputs("\"/>\n", d->out);
    }
    fputs("</g>\n", d->out);
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

void mechanism_scale(mechanism *m, drawing *d, const sp_result *result, double size, double length)
{
    double probe, rate;
    memset(m, 0, sizeof *m);
    m->result = result;
    if (result->verdict != SP_UNSTABLE && !motion_is_virtual(result)) return;
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
