/* near: scenes whose limit is known to 17 digits and more, to be asked this near to it. Tests and bench share them.
 *
 * Each stands up to `limit` times its live load, the acceleration of gravity along x or y, and falls beyond. Limits are sums of
 * two doubles: those of arch, overhang and the wall in its plane are brackets of sp_limit in __float128 at tol 1e-20, 1e-17
 * wide (tests/bench/near.c asks it again); keystone: (1 + mu t) / (t - mu), t = tan of its sides as
 * rounding of their corners leaves them; wall out of plane: depth / height.
 * All of it is static, for one file to include.
 */
#ifndef NEAR_H
#define NEAR_H

#include "gen.h"

typedef struct near_case {
    const char *name, *scene;
    struct { const char *name; double value; } set[2];
    int axis;                           /* of the live load */
    double limit[2];
} near_case;

static const near_case near_cases[] = {
    { "arch of 11 stones, pushed",       "arch",     { { "n", 11 },       { "t", 0.15 } },    0,
      { 0.16133997854323134,  -6.2239237926036489e-18 } },
    { "keystone about to slide, pushed", "keystone", { { "angle", -20 },  { "mu", 0.3 } },    0,
      { 17.33917474280512,     1.766897169612648e-15 } },
    { "overhang of 10 boards, pushed",   "overhang", { { "n", 10 },       { "factor", 0.9 } }, 0,
      { 0.050000000000000051, -2.4994676193518055e-18 } },
    { "wall tilted out of its plane",    "wall",     { { "rows", 4 },     { "bricks", 6 } },  1,
      { 0.25, 0 } },
    { "wall tilted in its plane",        "wall",     { { "rows", 4 },     { "bricks", 6 } },  0,
      { 0.76034016235021273,  2.1754050873589543e-17 } },
};

enum { NEAR_CASES = sizeof near_cases / sizeof near_cases[0] };

/* The scene, its load (1 + share) times its limit. */
static sp_status near_build(const near_case *c, double share, sp_arena *arena, sp_scene *s)
{
    gen_scene g;
    if (!gen_open(&g, c->scene)) return SP_E_ARGUMENT;
    for (int k = 0; k < 2; k++)
        if (gen_set(&g, c->set[k].name, c->set[k].value) != 1) return SP_E_ARGUMENT;
    const sp_status status = gen_build(&g, arena, s);
    if (status) return status;
    const sp_real limit = (sp_real)c->limit[0] + (sp_real)c->limit[1];
    s->body[c->axis] = -s->gravity[2];
    s->live = limit + limit * (sp_real)share;
    return SP_OK;
}

#endif /* NEAR_H */
