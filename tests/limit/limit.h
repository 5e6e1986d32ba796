/* What the suites of limits share: cubes, slopes, pushes, arches, a limit whose claim is verified. All of it is static. */
#ifndef LIMIT_H
#define LIMIT_H

#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>
#include <string.h>

#define NEAR TOL(1e-6, 2e-3)            /* relative accuracy of a multiplier */

static const double weight = 2400 * 9.80665;            /* of the cube of 1 m */

/* A limit both ends of which are held by sp_limit_verify, and by sp_verify of the scene with that multiple of its live loads. */
static sp_limit_result limit_of(const sp_scene *scene, const sp_settings *settings)
{
    sp_limit_result x;
    sp_evidence e;
    sp_result claim;
    sp_scene s = *scene;
    int32_t held = 0;
    memset(&x, 0, sizeof x);
    memset(&claim, 0, sizeof claim);
    CHECK_INT(sp_limit(scene, settings, &test_arena, &x), SP_OK);
    if (x.kind == SP_LIMIT_UNDECIDED || !x.f) return x;
    CHECK(x.verified);
    CHECK_INT(sp_limit_verify(scene, settings, &x, test_arena, &held), SP_OK);
    CHECK_INT(held, 1);
    claim.f = x.f;
    claim.dq = x.dq;
    if (x.lower >= 0) {
        s.live = x.lower;
        CHECK_INT(sp_verify(&s, settings, &claim, test_arena, &e), SP_OK);
        CHECK_INT(e.verdict, SP_STABLE);
    }
    if (x.upper >= 0) {
        memset(x.ray, 0, 3 * (size_t)s.count.points * sizeof *x.ray);
        claim.f = x.ray;                                /* forces that prove nothing */
        s.live = x.upper;
        CHECK_INT(sp_verify(&s, settings, &claim, test_arena, &e), SP_OK);
        CHECK_INT(e.verdict, SP_UNSTABLE);
    }
    return x;
}

/* A cube on the ground, z = 0. */
static sp_scene cube(sp_strength strength)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 4 };
    const sp_real foot[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
    const sp_real middle[3] = { R(0.5), R(0.5), R(0.5) }, ground[3] = { 0, 0, R(-5) };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, R(2400), middle, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &strength, NULL), SP_OK);
    return s;
}

static void push(sp_scene *s, int live, double fx, double fy, double fz, double x, double y, double z)
{
    const sp_load load = { 1, live, { R(x), R(y), R(z) }, { R(fx), R(fy), R(fz) }, { 0, 0, 0 }, 0 };
    CHECK_INT(sp_scene_load(s, &load, NULL), SP_OK);
}

/* Gravity of a slope that rises towards -x: the cube is pulled along x. */
static void slope(sp_scene *s, double angle)
{
    s->gravity[0] = R(9.80665 * sin(angle));
    s->gravity[2] = R(-9.80665 * cos(angle));
}

/* A semicircular arch of 20 round voussoirs, mean radius 1: sectors of a ring, by their masses and centroids. */
static sp_scene round_arch(double t)
{
    const double pi = 3.14159265358979323846, ro = 1 + t / 2, ri = 1 - t / 2, half = pi / 40;
    const double mass = (ro * ro - ri * ri) * half, rc = 2. / 3 * (ro * ro * ro - ri * ri * ri) / (ro * ro - ri * ri) * sin(half) / half;
    const sp_capacity cap = { 21, 0, 0, 0, 21, 84, 0 };
    const sp_strength strength = sp_strength_friction(R(0.84));
    const sp_real ground[3] = { 0, 0, R(-1) };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 20; k++) {
        const double a = pi - (2 * k + 1) * half;
        const sp_real c[3] = { R(rc * cos(a)), R(0.5), R(rc * sin(a)) };
        CHECK_INT(sp_scene_body(&s, R(mass), c, 0, NULL), SP_OK);
    }
    for (int k = 0; k <= 20; k++) {                     /* joint k: from the voussoir before it into the one after */
        const double c = cos(pi - 2 * k * half), z = k == 0 || k == 20 ? 0 : sin(pi - 2 * k * half);
        const sp_real xyz[12] = { R(ri * c), 0, R(ri * z), R(ri * c), 1, R(ri * z), R(ro * c), 1, R(ro * z), R(ro * c), 0, R(ro * z) };
        CHECK_INT(sp_scene_joint(&s, k, k == 20 ? 0 : k + 1, 4, xyz, &strength, NULL), SP_OK);
    }
    return s;
}

#endif /* LIMIT_H */
