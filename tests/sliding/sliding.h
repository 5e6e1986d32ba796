/* What the suites of sliding limits share: the question asked and judged, a wall of bricks. All of it is static. */
#ifndef SLIDING_H
#define SLIDING_H

#include "../test.h"
#include "../scenes/gen.h"
#include "../scenes/change.h"

#include <math.h>
#include <string.h>

/* The answer of a scene; sp_sliding_verify proves the same from the evidence alone. */
static sp_sliding_result slide(const sp_scene *s, const sp_sliding_settings *how)
{
    sp_limit_result limit;
    sp_sliding_result r;
    sp_sliding_evidence e;
    memset(&r, 0, sizeof r);
    memset(&e, 0, sizeof e);
    CHECK_INT(sp_limit(s, NULL, &test_arena, &limit), SP_OK);
    if (!CHECK_INT(sp_sliding(s, NULL, how, &limit, &test_arena, &r), SP_OK)) return r;
    CHECK_INT(sp_sliding_verify(s, NULL, &r, test_arena, &e), SP_OK);
    CHECK_INT(e.state, r.kind == SP_SLIDING_STATE);
    CHECK(!(e.lower < r.lower) && !(e.lower_strong < r.lower_strong) && r.lower_strong <= r.lower);
    if (r.upper >= 0) CHECK(r.lower <= r.upper * R(1 + TOL(1e-9, 1e-4)));
    if (r.kind == SP_SLIDING_STATE && r.associative >= 0) CHECK(r.upper <= r.associative * R(1 + TOL(1e-8, 1e-3)));
    return r;
}

/* A generated scene whose blocks are pushed by so much of their weight. */
static sp_scene pushed(const char *name, const char *param, double value, double x, double z)
{
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(gen_make(name, param, value, &test_arena, &s), SP_OK);
    s.body[0] = R(x * 9.80665);
    s.body[2] = R(z * 9.80665);
    return s;
}

/* A box of the wall's thickness. */
static void brick(sp_scene *s, double x0, double x1, double z0, double z1, uint32_t fixed)
{
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t face[24] = { 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
    const sp_real xyz[24] = { R(x0), 0, R(z0), R(x1), 0, R(z0), R(x1), 1, R(z0), R(x0), 1, R(z0),
                              R(x0), 0, R(z1), R(x1), 0, R(z1), R(x1), 1, R(z1), R(x0), 1, R(z1) };
    const sp_mesh mesh = { 8, 6, xyz, size, face };
    CHECK_INT(sp_scene_block(s, &mesh, 1000, fixed, NULL), SP_OK);
}

/* A scene with room for so many bricks and joints, and a load. */
static sp_scene room_for(int32_t bricks, int32_t joints)
{
    const sp_capacity cap = { bricks, 8 * bricks, 6 * bricks, 24 * bricks, joints, 6 * joints, 1 };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    return s;
}

/* What touches what, with friction mu. */
static void find_joints(sp_scene *s, double mu)
{
    sp_contact_settings set = sp_contact_settings_default();
    sp_contact_report report;
    memset(&report, 0, sizeof report);
    set.strength = sp_strength_friction(R(mu));
    CHECK_INT(sp_contacts_find(s, &set, test_arena, &report), SP_OK);
}

/* Running bond, five bricks of .4 x .175 m a row, mu .65, pushed along x by its weight: with 6 rows wall 1 of Ferris and Tin-Loi
 * (2001), whose limit without dilatancy is .640 there and .643 with it; with 10 rows wall 2, .563 and .580. */
static sp_scene bond(int rows)
{
    sp_scene s = room_for(60, 160);
    brick(&s, 0, 2, -0.175, 0, SP_FIXED);
    for (int k = 0; k < rows; k++)
        for (int i = 0; i < 6 - k % 2; i++) {
            const double shift = k % 2 ? 0 : -0.2, x0 = 0.4 * i + shift, x1 = x0 + 0.4;
            brick(&s, x0 < 0 ? 0 : x0, x1 > 2 ? 2 : x1, 0.175 * k, 0.175 * (k + 1), 0);
        }
    find_joints(&s, 0.65);
    s.body[0] = R(9.80665);
    return s;
}

/* A body of weight 1 N on two points of a support in the plane of x and z, normals at so many radians from x; live load q: force
 * along x and z, moment from x to z. */
static sp_scene two_points(const double at[2][2], const double angle[2], double mu, const double q[3])
{
    const sp_capacity cap = { 2, 0, 0, 0, 2, 2, 1 };
    const sp_real below[3] = { 0, 0, -9 }, middle[3] = { 0, 0, 0 };
    const sp_strength rough = sp_strength_friction(R(mu));
    sp_load load;
    sp_scene s;
    test_arena.used = 0;
    memset(&load, 0, sizeof load);
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, below, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, R(1 / 9.80665), middle, 0, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const sp_real point[3] = { R(at[k][0]), 0, R(at[k][1]) }, n[3] = { R(cos(angle[k])), 0, R(sin(angle[k])) };
        CHECK_INT(sp_scene_points(&s, 0, 1, n, 1, point, &rough, NULL), SP_OK);
    }
    load.block = load.live = 1;
    load.force[0] = R(q[0]);
    load.force[2] = R(q[1]);
    load.couple[1] = R(-q[2]);
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    return s;
}

#endif /* SLIDING_H */
