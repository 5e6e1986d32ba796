/* place: looks at one stone before any statics, judged by brute force, and by a check where one stone rests on supports. */
#ifndef PLACE_H
#define PLACE_H

#include "balance.h"

/* Corners of the joints that block b rests on, and whether these are all it has, level and on supports. */
static int32_t under(const sp_scene *s, int32_t b, sp_real (*x)[3], int *alone)
{
    int32_t n = 0;
    *alone = !s->block[b].fixed;
    for (int32_t q = 0; q < s->count.joints; q++) {
        const sp_joint *j = &s->joint[q];
        if (j->a != b && j->b != b) continue;
        const int level = (double)j->n[2] * (j->b == b ? 1 : -1) > 1 - 1e-12;
        const int glued = j->strength.tension > 0 || j->strength.crushing > 0;
        if (!level || glued || s->block[j->a == b ? j->b : j->a].fixed != SP_FIXED) *alone = 0;
        for (int32_t v = j->point; level && v < j->point + j->points; v++, n++) memcpy(x[n], s->point[v], sizeof x[n]);
    }
    return n;
}

/* Distance of the centre of mass from the nearest edge of the hull of points in plan, z up, over all pairs of them that have
 * all others on one side. area: of the largest triangle of three of them. */
static double clearance(sp_real (*x)[3], int32_t n, const sp_real com[3], double *area)
{
    double least = INFINITY;
    *area = 0;
    for (int32_t i = 0; i < n; i++)
        for (int32_t k = 0; k < n; k++) {
            const double e[2] = { (double)(x[k][0] - x[i][0]), (double)(x[k][1] - x[i][1]) }, size = hypot(e[0], e[1]);
            int outside = !(size > 1e-9);
            for (int32_t q = 0; q < n && !outside; q++)
                outside = e[0] * (double)(x[q][1] - x[i][1]) - e[1] * (double)(x[q][0] - x[i][0]) < -1e-9 * size;
            if (outside) continue;
            const double to[2] = { (double)(com[0] - x[i][0]), (double)(com[1] - x[i][1]) };
            const double off = (e[0] * to[1] - e[1] * to[0]) / size;
            if (off < least) least = off;
        }
    for (int32_t i = 0; i < n; i++)
        for (int32_t k = 0; k < i; k++)
            for (int32_t q = 0; q < k; q++) {
                const double e[2] = { (double)(x[k][0] - x[i][0]), (double)(x[k][1] - x[i][1]) };
                const double g[2] = { (double)(x[q][0] - x[i][0]), (double)(x[q][1] - x[i][1]) };
                const double now = fabs(e[0] * g[1] - e[1] * g[0]) / 2;
                if (now > *area) *area = now;
            }
    return least;
}

/* A seat of what block b rests on. */
static sp_seat seat_of(const sp_scene *s, int32_t b, const sp_support *support)
{
    const sp_real size = s->block[b].diameter > 0 ? s->block[b].diameter : 1;
    const sp_real width = (sp_real)draw_real(0.1, 2), trapped = (sp_real)draw_real(0, 2);
    const sp_seat seat = { *support, size * size, size, width, trapped, s->block[b].centroid[2] };
    return seat;
}

static void gated(const sp_scene *s, int32_t b, sp_real (*x)[3], int32_t n, const sp_support *of, sp_arena scratch)
{
    const sp_real down[3] = { 0, 0, -1 };
    const sp_real aslant = (sp_real)draw_real(-1, 1), depth = (sp_real)draw_real(0, 2), height = (sp_real)draw_real(0, 2);
    sp_laid laid = { &x[0][0], n, { 0, 0, 0 }, { aslant, 0, -1 }, depth, height };
    sp_nbo why;
    sp_real margin;
    memcpy(laid.com, s->block[b].centroid, sizeof laid.com);
    HOLDS(sp_nbo_gate(&laid, down, NULL, scratch, &why, &margin) == SP_OK, "gate");
    HOLDS((why == SP_NBO_OUTSIDE) == !(of->clearance >= 0), "clearance %g: %d", (double)of->clearance, (int)why);
    HOLDS((why == SP_NBO_SHALLOW) == (of->clearance >= 0 && laid.depth < laid.height / 2), "depth %g, height %g: %d",
          (double)laid.depth, (double)laid.height, (int)why);
    HOLDS(!isnan(margin), "margin");
}

/* Seats in the order that is told: those with the margin first, then by cost. */
static void ranked(const sp_seat *seat, int32_t n)
{
    const sp_real margin = (sp_real)draw_real(-0.5, 0.5);
    sp_real J[SP_FUZZ_BLOCKS], each;
    int32_t order[SP_FUZZ_BLOCKS], stable = -1, seen = 0;
    HOLDS(sp_support_rank(seat, n, margin, NULL, J, order, &stable) == SP_OK, "rank");
    for (int32_t k = 0; k < n; k++) {
        HOLDS(order[k] >= 0 && order[k] < n && !(seen >> order[k] & 1), "order[%d] is %d", (int)k, (int)order[k]);
        seen |= 1 << order[k];
        HOLDS(sp_support_cost(&seat[k], NULL, &each) == SP_OK && isfinite(each), "cost %d", (int)k);
        HOLDS(!(each < J[k]) && !(each > J[k]), "cost %d: %g, ranked %g", (int)k, (double)each, (double)J[k]);
        HOLDS((seat[order[k]].support.clearance >= margin) == (k < stable), "%d stable, %d", (int)stable, (int)k);
        if (k && k != stable) HOLDS(J[order[k - 1]] <= J[order[k]], "order %d", (int)k);
    }
}

/* The only stone, on supports, under nothing but its weight, stands where its centre is over them. */
static void as_checked(const sp_scene *s, const sp_result *r, double least)
{
    int32_t blocks = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) blocks += s->block[b].fixed != SP_FIXED;
    if (blocks != 1 || s->count.loads || s->gravity[0] > 0 || s->gravity[1] > 0 || fabs(least) <= 1e-6) return;
    HOLDS(r->verdict == (least > 0 ? SP_STABLE : SP_UNSTABLE), "clearance %g, check %d", least, (int)r->verdict);
}

/* Every stone on what is under it. */
static void placing(const sp_scene *s, const sp_result *r)
{
    static sp_real x[VERTICES][3];
    const sp_real down[3] = { 0, 0, -1 };
    sp_seat seat[SP_FUZZ_BLOCKS];
    asked(PLACING);
    for (int32_t b = 0; b < s->count.blocks; b++) {
        int alone;
        double area;
        sp_support of;
        const int32_t n = under(s, b, x, &alone);
        const size_t bytes = sp_support_memory(n);
        sp_arena a = room_for(SCRATCH, bytes ? bytes - 1 : 0);
        if (bytes) HOLDS(sp_support_clearance(&x[0][0], n, s->block[b].centroid, down, a, &of) == SP_E_MEMORY, "one byte less");
        a.capacity = bytes;
        HOLDS(sp_support_clearance(&x[0][0], n, s->block[b].centroid, down, a, &of) == SP_OK, "clearance");
        const double least = clearance(x, n, s->block[b].centroid, &area);
        HOLDS(!isnan(of.clearance) && of.area >= 0 && !isnan(of.offset), "block %d", (int)b);
        if (area > 1e-6) HOLDS(fabs(least - (double)of.clearance) <= 1e-6 && (double)of.area >= area * (1 - 1e-9),
                               "%g, by pairs %g", (double)of.clearance, least);
        if (alone && area > 1e-6) as_checked(s, r, least);
        gated(s, b, x, n, &of, a);
        seat[b] = seat_of(s, b, &of);
    }
    ranked(seat, s->count.blocks);
}

/* A stone laid on a face that it can rest on: a check says so, too. */
static void rests(const sp_block *o, const sp_real (*x)[3], const sp_rest *rest)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 64, 0 };
    const sp_strength rough = sp_strength_friction((sp_real)0.5);
    const sp_settings set = sp_settings_default();
    sp_arena a = arena(OTHER);
    sp_real up[3], below[3], corner[64][3];
    sp_scene s;
    sp_result r;
    int32_t n = 0;
    for (int k = 0; k < 3; k++) { up[k] = -rest->normal[k]; below[k] = o->centroid[k] + 2 * rest->height * rest->normal[k]; }
    for (int32_t v = 0; v < o->vertices && n < 64; v++) {
        double over = (double)rest->height;
        for (int k = 0; k < 3; k++) over -= (double)rest->normal[k] * (double)(x[v][k] - o->centroid[k]);
        HOLDS(over >= -1e-5 * (double)o->diameter, "vertex %d is %g below the face", (int)v, over);
        if (over <= 1e-6 * (double)o->diameter) memcpy(corner[n++], x[v], sizeof corner[0]);
    }
    HOLDS(sp_scene_create(&s, &cap, &a) == SP_OK && sp_scene_body(&s, 1, below, SP_FIXED, NULL) == SP_OK, "ground");
    HOLDS(sp_scene_body(&s, o->mass, o->centroid, 0, NULL) == SP_OK, "stone");
    HOLDS(sp_scene_points(&s, 0, 1, up, n, &corner[0][0], &rough, NULL) == SP_OK, "%d corners", (int)n);
    for (int k = 0; k < 3; k++) s.gravity[k] = rest->normal[k];
    if (check(&s, &set, CHECK_OTHER, &r) != SP_STABLE)
        HOLDS((double)rest->support.clearance <= 1e-6 * (double)o->diameter, "rests %g from an edge, check %d",
              (double)rest->support.clearance, (int)r.verdict);
}

/* Faces on which each stone can rest. */
static void resting(const sp_scene *s)
{
    asked(RESTING);
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_block *o = &s->block[b];
        sp_rest rest[8];
        int32_t size[8], corner[32], n = 0, found = -1;
        if (o->faces > 8) continue;
        for (int32_t f = 0; f < o->faces; f++) {
            const sp_face *face = &s->face[o->face + f];
            size[f] = face->corners;
            for (int32_t c = 0; c < size[f] && n < 32; c++) corner[n++] = s->corner[face->corner + c] - o->vertex;
        }
        const sp_mesh mesh = { o->vertices, o->faces, &s->vertex[o->vertex][0], size, corner };
        HOLDS(sp_rest_faces(&mesh, room_for(SCRATCH, sp_support_memory(mesh.vertices)), rest, 8, &found) == SP_OK, "rest");
        HOLDS(found >= 1 && found <= o->faces, "%d faces", (int)found);
        for (int32_t k = 0; k < found; k++) {
            HOLDS(rest[k].height > 0 && rest[k].support.clearance > 0, "face %d: height %g", (int)k, (double)rest[k].height);
            rests(o, (const sp_real (*)[3])s->vertex + o->vertex, &rest[k]);
        }
    }
}

#endif
