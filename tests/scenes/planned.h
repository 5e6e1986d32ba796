/* What the suites of plans and islands share: blocks that differ in weight, piles side by side, a check in each manner. All of it is
 * static. */
#ifndef PLANNED_H
#define PLANNED_H

#include "../test.h"
#include "kinds.h"

#include <math.h>

#ifdef SP_NO_IPM                                        /* the proximal path takes any number of steps, in float not far enough */
#define TELLS 0
#define OPEN (sizeof(sp_real) == 4)
#else
#define TELLS (sizeof(sp_real) == 8)
#define OPEN 0
#endif

enum { MOST = 128 };                                    /* blocks of a part */

/* A generated scene, in test_arena. */
static sp_scene part(const char *name, const char *param, double value, double mu)
{
    gen_scene g;
    sp_scene s;
    memset(&s, 0, sizeof s);
    CHECK_INT(gen_open(&g, name), 1);
    if (param) CHECK_INT(gen_set(&g, param, value), 1);
    if (mu >= 0) CHECK_INT(gen_set(&g, "mu", mu), 1);
    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
    return s;
}

/* How parts are put together: lengths times `length`, masses times `mass`, everything else way round where `turned`. */
typedef struct manner { double length, mass; int turned; } manner;

static sp_scene room(int32_t blocks, int32_t joints, int32_t points)
{
    sp_capacity cap;
    sp_scene s;
    memset(&cap, 0, sizeof cap);
    cap.blocks = blocks;
    cap.joints = joints;
    cap.points = points;
    cap.loads = 4;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    return s;
}

/* `in` moved by x [m] along x, without its meshes; turned: last blocks and joints first, B called A, corners from the next on. */
static void add(sp_scene *out, const sp_scene *in, double x, manner m)
{
    int32_t number[MOST];
    for (int32_t q = 0; q < in->count.blocks; q++) {
        const int32_t k = m.turned ? in->count.blocks - 1 - q : q;
        const sp_block *b = &in->block[k];
        sp_real c[3];
        for (int i = 0; i < 3; i++) c[i] = R(m.length) * (b->centroid[i] + (i ? 0 : R(x)));
        CHECK_INT(sp_scene_body(out, R(m.mass) * b->mass, c, b->fixed, &number[k]), SP_OK);
    }
    for (int32_t q = 0; q < in->count.joints; q++) {
        const sp_joint *f = &in->joint[m.turned ? in->count.joints - 1 - q : q];
        sp_real xyz[3 * 16];
        for (int32_t v = 0; v < f->points; v++) {
            const int32_t from = m.turned ? (2 * f->points - v) % f->points : v;        /* backwards: seen from the other side */
            for (int i = 0; i < 3; i++)
                xyz[3 * v + i] = R(m.length) * (in->point[f->point + from][i] + (i ? 0 : R(x)));
        }
        CHECK_INT(sp_scene_joint(out, number[m.turned ? f->b : f->a], number[m.turned ? f->a : f->b], f->points, xyz,
                                     &f->strength, NULL), SP_OK);
    }
}

static sp_result check(const sp_scene *s, const sp_settings *set, sp_arena *a)
{
    sp_result r;
    sp_evidence e;
    memset(&r, 0, sizeof r);
    CHECK_INT(sp_check(s, set, a, &r), SP_OK);
    CHECK_INT(sp_verify(s, set, &r, *a, &e), SP_OK);
    CHECK_INT(e.verdict, r.verdict == SP_UNDECIDED ? e.verdict : r.verdict);
    return r;
}

/* The verdict with every effect on. */
static sp_result full(const sp_scene *s, const sp_settings *set, sp_arena *a)
{
    sp_settings all = set ? *set : sp_settings_default();
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) all.effect[k] = SP_WITH;
    return check(s, &all, a);
}

static const manner plain = { 1, 1, 0 }, other = { 39.37, 2.2046, 1 };

static sp_scene two(const char *left, const char *right, const char *param, double value, manner m)
{
    const sp_scene a = part(left, NULL, 0, -1), b = part(right, param, value, -1);
    sp_scene s = room(a.count.blocks + b.count.blocks, a.count.joints + b.count.joints, a.count.points + b.count.points);
    add(&s, &a, 0, m);
    add(&s, &b, 100, m);
    for (int k = 0; k < 3; k++) s.gravity[k] *= R(m.length);
    return s;
}

static int32_t free_blocks(const sp_scene *s)
{
    int32_t n = 0;
    for (int32_t k = 0; k < s->count.blocks; k++) n += s->block[k].fixed != SP_FIXED;
    return n;
}

#endif /* PLANNED_H */
