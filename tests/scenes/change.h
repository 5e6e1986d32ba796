/* change: a scene written in another way: turned and moved, in other units, in another order, joints from their other side.
 * For tests to include; all of it is static. Held directions are not turned, loads are left out.
 */
#ifndef CHANGE_H
#define CHANGE_H

#include "../test.h"

#include <math.h>

/* What is done to a scene: x' = scale Q x + shift, and so on. */
typedef struct change {
    double q[3][3], shift[3];
    double scale, density, gravity;                     /* factors: m, kg/m^3, m/s^2 */
    int permute;                                        /* blocks and joints in another order */
    int turn;                                           /* contact polygons start elsewhere */
    int swap;                                           /* every other joint from the other side */
    int twice;                                          /* every joint given two times */
} change;

static change none(void)
{
    change c = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { 0, 0, 0 }, 1, 1, 1, 0, 0, 0, 0 };
    return c;
}

enum { MOST = 512 };                                    /* blocks and joints of the scenes here */

static void move(const change *c, const sp_real x[3], int direction_only, double y[3])
{
    for (int i = 0; i < 3; i++) {
        y[i] = 0;
        for (int j = 0; j < 3; j++) y[i] += c->q[i][j] * (double)x[j];
        if (!direction_only) y[i] = c->scale * y[i] + c->shift[i];
    }
}

/* 0 .. n-1 in another order                                                                           [Fisher & Yates] */
static void shuffle(int32_t *p, int32_t n, int really)
{
    for (int32_t i = 0; i < n; i++) p[i] = i;
    for (int32_t i = n - 1; really && i > 0; i--) {
        const int32_t j = test_random_int(0, i), t = p[i];
        p[i] = p[j];
        p[j] = t;
    }
}

/* Blocks of `in`, changed, into `out`: place[b] is the new number of block b. */
static void copy_blocks(const sp_scene *in, const change *c, sp_scene *out, int32_t *place)
{
    int32_t order[MOST];
    shuffle(order, in->count.blocks, c->permute);
    for (int32_t k = 0; k < in->count.blocks; k++) {
        const sp_block *b = &in->block[order[k]];
        if (!b->faces) {
            double y[3];
            move(c, b->centroid, 0, y);
            const sp_real at[3] = { R(y[0]), R(y[1]), R(y[2]) };
            const double heavy = c->density * c->scale * c->scale * c->scale;
            CHECK_INT(sp_scene_body(out, R((double)b->mass * heavy), at, b->fixed, &place[order[k]]), SP_OK);
            continue;
        }
        sp_real xyz[3 * 64];
        int32_t size[64], corner[256], n = 0;
        for (int32_t v = 0; v < b->vertices; v++) {
            double y[3];
            move(c, in->vertex[b->vertex + v], 0, y);
            for (int i = 0; i < 3; i++) xyz[3 * v + i] = R(y[i]);
        }
        for (int32_t f = 0; f < b->faces; f++) {
            const sp_face *face = &in->face[b->face + f];
            size[f] = face->corners;
            for (int32_t i = 0; i < face->corners; i++) corner[n++] = in->corner[face->corner + i] - b->vertex;
        }
        const sp_mesh mesh = { b->vertices, b->faces, xyz, size, corner };
        CHECK_INT(sp_scene_block(out, &mesh, R((double)b->density * c->density), b->fixed, &place[order[k]]), SP_OK);
    }
}

/* Joints: name[j] is the new number of joint j. */
static void copy_joints(const sp_scene *in, const change *c, sp_scene *out, const int32_t *place, int32_t *name)
{
    int32_t order[MOST];
    shuffle(order, in->count.joints, c->permute);
    for (int32_t k = 0; k < in->count.joints; k++) {
        const sp_joint *j = &in->joint[order[k]];
        const int back = c->swap && order[k] % 2 == 0;
        const int32_t n = j->points, start = c->turn ? test_random_int(0, n - 1) : 0;
        sp_real xyz[3 * 16];
        for (int32_t v = 0; v < n; v++) {
            const int32_t from = back ? (start + n - v) % n : (start + v) % n;
            double y[3];
            move(c, in->point[j->point + from], 0, y);
            for (int i = 0; i < 3; i++) xyz[3 * v + i] = R(y[i]);
        }
        CHECK_INT(sp_scene_joint(out, place[back ? j->b : j->a], place[back ? j->a : j->b], n, xyz, &j->strength,
                                     &name[order[k]]), SP_OK);
    }
}

static void copy(const sp_scene *in, const change *c, sp_scene *out, int32_t *place, int32_t *name)
{
    double g[3];
    sp_capacity cap = in->count;
    cap.joints *= 1 + c->twice;
    cap.points *= 1 + c->twice;
    CHECK_INT(sp_scene_create(out, &cap, &test_arena), SP_OK);
    move(c, in->gravity, 1, g);
    for (int i = 0; i < 3; i++) out->gravity[i] = R(g[i] * c->gravity);
    copy_blocks(in, c, out, place);
    copy_joints(in, c, out, place, name);
    if (c->twice) copy_joints(in, c, out, place, name);
}

/* A turn about a random axis, from a random unit quaternion. */
static void any_turn(change *c)
{
    double w[4], s = 0;
    do {
        s = 0;
        for (int i = 0; i < 4; i++) w[i] = (double)test_random_real(-1, 1), s += w[i] * w[i];
    } while (s < 0.1 || s > 1);
    for (int i = 0; i < 4; i++) w[i] /= sqrt(s);
    const double a = w[0], b = w[1], d = w[2], e = w[3];
    const double q[3][3] = { { a * a + b * b - d * d - e * e, 2 * (b * d - a * e), 2 * (b * e + a * d) },
                             { 2 * (b * d + a * e), a * a - b * b + d * d - e * e, 2 * (d * e - a * b) },
                             { 2 * (b * e - a * d), 2 * (d * e + a * b), a * a - b * b - d * d + e * e } };
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) c->q[i][j] = q[i][j];
}

#endif /* CHANGE_H */
