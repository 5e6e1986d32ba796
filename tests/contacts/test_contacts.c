/* test_contacts: what touches what, on stones whose common faces are known by formula; gaps, supports, blocks inside each other. */
#include "contacts.h"

#include <math.h>

TEST(aligned_cubes_share_their_square)
{
    const frame f = upright();
    NEED(start(2));
    box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
    box(&f, 0, 0, 1, 1, 1, 2, 0);
    expect_one(4, 1);
    NEED(scene.count.joints == 1);
    CHECK_INT(scene.joint[0].a, 0);
    CHECK_INT(scene.joint[0].b, 1);
    CHECK_NEAR(scene.joint[0].n[2], 1, TOL(1e-15, 1e-6f));
    CHECK_NEAR(scene.joint[0].strength.mu, 0.84, TOL(1e-15, 1e-6f));
    CHECK_WITHIN(scene.point[0][0], 0, 0);              /* starts at the lowest corner, and corners are exact */
    CHECK_WITHIN(scene.point[0][1], 0, 0);
    CHECK_WITHIN(scene.point[2][0], 1, 0);
}

TEST(the_normal_points_from_the_lower_number_whoever_lies_below)
{
    const frame f = upright();
    NEED(start(2));
    box(&f, 0, 0, 1, 1, 1, 2, 0);
    box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
    expect_one(4, 1);
    NEED(scene.count.joints == 1);
    CHECK_NEAR(scene.joint[0].n[2], -1, TOL(1e-15, 1e-6f));
}

TEST(offset_cubes_share_three_quarters)
{
    const frame f = upright();
    NEED(start(2));
    box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
    box(&f, 0.25, 0, 1, 1.25, 1, 2, 0);
    expect_one(4, 0.75);
}

TEST(cubes_side_by_side_share_a_wall)
{
    const frame f = upright();
    NEED(start(2));
    box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
    box(&f, 1, 0.5, 0.5, 2, 1.5, 1.5, 0);
    expect_one(4, 0.25);
}

TEST(a_turned_cube_on_a_cube_shares_the_octagon)
{
    const frame f = upright();
    const double co = 0.9800665778412416, si = 0.19866933079506122;             /* 0.2 rad */
    double xy[4][2];
    for (int k = 0; k < 4; k++) {
        const double x = k == 1 || k == 2 ? 0.5 : -0.5, y = k > 1 ? 0.5 : -0.5;
        xy[k][0] = co * x - si * y;
        xy[k][1] = si * x + co * y;
    }
    NEED(start(2));
    box(&f, -0.5, -0.5, 0, 0.5, 0.5, 1, SP_FIXED);
    prism(&f, 4, xy, 1, 2, -1, 0, 0);
    expect_one(8, si / (1 + co) + (1 + co - si) / (1 + co + si));   /* tan(a/2) + tan(pi/4 - a/2) */
}

TEST(cubes_that_share_an_edge_or_corner_do_not_touch_in_faces)
{
    const frame f = upright();
    NEED(start(3));
    box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
    box(&f, 1, 0, 1, 2, 1, 2, 0);
    box(&f, -1, -1, -1, 0, 0, 0, 0);
    CHECK_INT(find(NULL), SP_OK);
    CHECK_INT(report.joints, 0);
    CHECK_INT(report.overlaps, 0);
}

TEST(gaps_count_by_the_distance)
{
    const frame f = upright();
    const double gap[4] = { 1e-4, 3e-4, 1e-4, 3e-4 };
    sp_contact_settings set = sp_contact_settings_default();
    for (int k = 0; k < 4; k++) {
        set.absolute = k / 2;
        set.distance = R(k / 2 ? 2e-4 : 2e-4 / 1.7320508);          /* of the unit cube's diameter */
        NEED(start(2));
        box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
        box(&f, 0, 0, 1 + gap[k], 1, 1, 2, 0);
        CHECK_INT(find(&set), SP_OK);
        CHECK_INT(report.joints, k % 2 ? 0 : 1);
        CHECK_INT(report.overlaps, 0);
    }
}

TEST(tilted_faces_count_by_the_angle)
{
    const frame f = upright();
    sp_contact_settings set = sp_contact_settings_default();
    for (int k = 0; k < 2; k++) {
        const double lift = k ? 1.2e-2 : 0.8e-2;
        frame g = turned(1, 0, lift / 2, 0, 0, 1);      /* about the middle of the joint */
        set.distance = R(2e-2);
        set.angle = R(1e-2);
        set.absolute = 1;
        g.shift[2] = 1;
        NEED(start(2));
        box(&f, -0.5, -0.5, 0, 0.5, 0.5, 1, SP_FIXED);
        box(&g, -0.5, -0.5, 0, 0.5, 0.5, 1, 0);
        CHECK_INT(find(&set), SP_OK);
        CHECK_INT(report.joints, k ? 0 : 1);
    }
}

#ifndef SP_SMALL
/* Tilted about its middle, ends `high` distances away: whole while that is at most twice, else the strip within the distance. */
TEST(a_tilted_face_touches_where_it_is_within_the_distance)
{
    static const double high[] = { 0.5, 1.5, 1.99, 2.01, 4, 20 };
    const frame f = upright();
    sp_contact_settings set = sp_contact_settings_default();
    set.distance = R(1e-4);
    set.angle = R(1e-2);
    set.absolute = 1;
    for (size_t k = 0; k < sizeof high / sizeof high[0]; k++) {
        const double want = high[k] <= 2 ? 1 : 1 / high[k];
        frame g = turned(1, 0, high[k] * 1e-4, 0, 0, 1);
        g.shift[2] = 1;
        NEED(start(2));
        box(&f, -0.5, -0.5, 0, 0.5, 0.5, 1, SP_FIXED);
        box(&g, -0.5, -0.5, 0, 0.5, 0.5, 1, 0);
        CHECK_INT(find(&set), SP_OK);
        if (!CHECK_INT(report.joints, 1)) continue;
        CHECK_NEAR(area_sum(), want, TOL(1e-5, 2e-2));
    }
}

/* Two slates 1 thick and 300 long, one on the other, on a support: however large the distance, bottom and top of a slate are
 * not taken for each other's, and the upper slate does not reach the support through the lower. */
TEST(a_distance_does_not_reach_through_a_slate)
{
    static const double share[] = { 1e-6, 1e-3, 3e-3, 1e-2, 0.1, 0.5 };
    const frame f[2] = { upright(), turned(3, 1, -1, 2, 1, 1e-3) };
    sp_contact_settings set = sp_contact_settings_default();
    for (size_t i = 0; i < 2 * sizeof share / sizeof share[0]; i++) {
        const double unit = f[i % 2].unit;
        set.distance = R(share[i / 2]);
        NEED(start(3));
        box(&f[i % 2], 0, 0, 0, 300, 200, 100, SP_FIXED);
        box(&f[i % 2], 0, 0, 100, 300, 200, 101, 0);
        box(&f[i % 2], 200, 0, 101, 500, 200, 102, 0);
        CHECK_INT(find(&set), SP_OK);
        CHECK_INT(report.joints, 2);
        CHECK_NEAR(area_sum(), (60000 + 20000) * unit * unit, TOL(1e-9, 1e-3f));
    }
}

/* Faces of blocks 1 thick, apart or inside each other: a quarter of the thinner is the most that counts. */
TEST(faces_touch_up_to_a_quarter_of_the_thinner_block)
{
    static const double gap[] = { 0.24, -0.24, 0.26, -0.26 };
    const frame f = turned(3, 1, -1, 2, 1, 1);
    sp_contact_settings set = sp_contact_settings_default();
    set.distance = R(0.5);
    set.absolute = 1;
    for (int k = 0; k < 4; k++) {
        NEED(start(2));
        box(&f, 0, 0, 0, 4, 4, 4, SP_FIXED);
        box(&f, 0, 0, 4 + gap[k], 4, 4, 5 + gap[k], 0);
        CHECK_INT(find(&set), SP_OK);
        CHECK_INT(report.joints, k < 2);
    }
}

/* A cube on a cube as large or smaller: a distance of half a cube finds what that of a millionth does. */
TEST(a_large_distance_loses_no_cube_on_a_cube)
{
    static const double share[] = { 1e-6, 0.01, 0.1, 0.25, 0.3, 0.5 };
    const frame f = turned(1, 2, 3, 4, 0, 1);
    sp_contact_settings set = sp_contact_settings_default();
    for (size_t k = 0; k < 2 * sizeof share / sizeof share[0]; k++) {
        const double side = k % 2 ? 0.6 : 1;
        set.distance = R(share[k / 2]);
        NEED(start(2));
        box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
        box(&f, 0.3 * side, 0, 1, 1.3 * side, side, 1 + side, 0);
        CHECK_INT(find(&set), SP_OK);
        CHECK_INT(report.joints, 1);
        CHECK_NEAR(area_sum(), (k % 2 ? 0.6 : 0.7) * side, TOL(1e-9, 1e-4f));
    }
}

/* A slab 0.01 thick and 0.4 of it inside another: no distance joins them or keeps silent about it. */
TEST(a_slab_deep_in_another_is_told_at_every_distance)
{
    static const double share[] = { 1e-6, 1e-3, 1e-2, 0.5 };
    const frame f = turned(1, 2, 3, 4, 0, 1);
    sp_contact_settings set = sp_contact_settings_default();
    for (size_t k = 0; k < sizeof share / sizeof share[0]; k++) {
        set.distance = R(share[k]);
        NEED(start(2));
        box(&f, 0, 0, 0, 1, 1, 0.01, SP_FIXED);
        box(&f, 0, 0, 0.006, 1, 1, 0.016, 0);
        CHECK_INT(find(&set), SP_OK);
        CHECK_INT(report.joints, 0);
        CHECK_INT(report.overlaps, 1);
    }
}

/* A beam 1 long and 0.04 wide on a wide slab, turned about its long or its short middle: with an angle of -8 faces may rise by
 * eight distances across the width or along the length; of a rise of h distances 2/h is within. */
TEST(narrow_faces_may_stand_steeper)
{
    static const struct { double rise; int along, found; } k[] = {
        { 3, 0, 1 }, { 7.8, 0, 1 }, { 8.2, 0, 0 }, { 7.8, 1, 1 }, { 8.2, 1, 0 }, { 300, 1, 0 } };
    const frame f = upright();
    sp_contact_settings set = sp_contact_settings_default();
    set.distance = R(1e-3);
    set.angle = -8;
    set.absolute = 1;
    for (size_t i = 0; i < sizeof k / sizeof k[0]; i++) {
        const double sine = k[i].rise * 1e-3 / (k[i].along ? 1 : 0.04), tangent = sine / (1 + sqrt(1 - sine * sine));
        frame g = k[i].along ? turned(1, 0, tangent, 0, 0, 1) : turned(1, tangent, 0, 0, 0, 1);
        g.shift[2] = 1;
        NEED(start(2));
        box(&f, -2, -2, 0, 2, 2, 1, SP_FIXED);
        box(&g, -0.5, -0.02, 0, 0.5, 0.02, 1, 0);
        CHECK_INT(find(&set), SP_OK);
        CHECK_INT(report.joints, k[i].found);
        if (k[i].found && k[i].rise > 4) CHECK_NEAR(area_sum(), 0.04 * 2 / k[i].rise, 0.05);
    }
}
#endif

/* Scenes seen from odd frames and in odd units have the same contacts. */
TEST(frames_and_units_do_not_matter)
{
    const frame f[5] = { turned(1, 2, 3, 4, 0, 1), turned(5, -1, 2, 0.3, 1, 1e-3), turned(1, 0.1, -0.7, 0.2, 10, 1e3),
#ifdef SP_REAL_FLOAT
                         turned(1, 2, 3, 4, 30, 1), turned(1, 1, 1, 1, 100, 1) };
    const double tol[5] = { 1e-5, 1e-5, 1e-4, 1e-4, 1e-3 };
#else
                         turned(1, 2, 3, 4, 1e6, 1), turned(3, 1, -1, 2, 1e6, 1e-3) };
    const double tol[5] = { 1e-13, 1e-13, 1e-12, 1e-8, 1e-8 };
#endif
    for (int k = 0; k < 5; k++) {
        const double u2 = f[k].unit * f[k].unit;
        NEED(start(4));
        box(&f[k], 0, 0, 0, 2, 1, 1, SP_FIXED);
        box(&f[k], 0, 0, 1, 1, 1, 2, 0);
        box(&f[k], 1, 0, 1, 2, 1, 2, 0);
        box(&f[k], 0.5, 0, 2, 1.5, 1, 3, 0);
        CHECK_INT(find(NULL), SP_OK);
        CHECK_INT(report.joints, 5);
        CHECK_INT(report.points, 20);
        CHECK_INT(report.overlaps, 0);
        CHECK_NEAR(area_sum(), 4 * u2, tol[k]);
    }
}

TEST(supports_do_not_touch_each_other)
{
    const frame f = upright();
    NEED(start(2));
    box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
    box(&f, 0, 0, 1, 1, 1, 2, SP_FIXED);
    CHECK_INT(find(NULL), SP_OK);
    CHECK_INT(report.joints, 0);
}

TEST(a_flat_support_is_enough)
{
    static const sp_real xyz[12] = { -1, -1, 0, 2, -1, 0, 2, 2, 0, -1, 2, 0 };
    static const int32_t size[1] = { 4 }, corner[4] = { 0, 1, 2, 3 };
    const sp_mesh mesh = { 4, 1, xyz, size, corner };
    const frame f = upright();
    NEED(start(2));
    CHECK_INT(sp_scene_block(&scene, &mesh, 1, SP_FIXED, NULL), SP_OK);
    box(&f, 0, 0, 0, 1, 1, 1, 0);
    expect_one(4, 1);
}

TEST(blocks_inside_each_other_are_told_with_their_depth)
{
    const frame f = turned(1, 2, 3, 4, 0, 1);
    NEED(start(6));
    box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
    box(&f, 0.1, 0.2, 0.95, 1.1, 1.2, 2, 0);            /* 0.05 deep */
    box(&f, 10, 0, 0, 11, 1, 1, 0);
    box(&f, 10, 0, 0, 11, 1, 1, 0);                     /* the same block twice */
    box(&f, 20, 0, 0, 29, 1, 1, 0);
    box(&f, 24, -4, 0, 25, 5, 1, 0);                    /* crossed bars, no corner of one in the other */
    CHECK_INT(find(NULL), SP_OK);
    NEED(report.overlaps == 3);
    CHECK_INT(overlap[0].a, 0);
    CHECK_INT(overlap[0].b, 1);
    CHECK_NEAR(overlap[0].depth, 0.05, TOL(1e-12, 1e-4f));
    CHECK_NEAR(overlap[1].depth, 1, TOL(1e-12, 1e-5f));
    CHECK_NEAR(overlap[2].depth, 1, TOL(1e-12, 1e-5f));
}

/* A cube beside another to any of six sides, first or last in the scene: apart nothing, on it a joint of its face, in it an overlap
 * of that depth. */
TEST(what_lies_to_any_side_is_apart_or_touches_or_overlaps)
{
    const frame f = upright();
    for (int k = 0; k < 36; k++) {
        const int axis = k / 2 % 3, first = k / 6 % 2;
        const double side = k % 2 ? 1 : -1, gap = k / 12 == 0 ? 0.1 : k / 12 == 1 ? 0 : -0.05;
        double at[3] = { 0.25, 0.125, 0.25 };           /* across, within the other's face by so much */
        at[axis] = side > 0 ? 1 + gap : -1 - gap;
        NEED(start(2));
        if (first) box(&f, at[0], at[1], at[2], at[0] + 1, at[1] + 1, at[2] + 1, 0);
        box(&f, 0, 0, 0, 1, 1, 1, SP_FIXED);
        if (!first) box(&f, at[0], at[1], at[2], at[0] + 1, at[1] + 1, at[2] + 1, 0);
        CHECK_INT(find(NULL), SP_OK);
        CHECK_INT(report.joints, k / 12 == 1);
        CHECK_INT(report.overlaps, k / 12 == 2);
        if (report.joints == 1) CHECK_NEAR(area_sum(), axis == 1 ? 0.75 * 0.75 : 0.75 * 0.875, CLOSE);
        if (k / 12 == 2 && report.overlaps == 1) CHECK_NEAR(overlap[0].depth, 0.05, TOL(1e-12, 1e-4f));
    }
}

/* Room for some of them, for none, and none at all: they are counted, and the first are told. */
TEST(overlaps_beyond_the_room_for_them_are_counted)
{
    const frame f = upright();
    sp_overlap few[2];
    for (int32_t k = 0; k < 4; k++) {
        sp_contact_report told;
        NEED(start(6));
        for (int q = 0; q < 3; q++) {
            box(&f, 10 * q, 0, 0, 10 * q + 1, 1, 1, SP_FIXED);
            box(&f, 10 * q, 0, 0.9, 10 * q + 1, 1, 2, 0);
        }
        memset(&told, 0, sizeof told);
        memset(few, 0, sizeof few);
        told.overlap = k < 3 ? few : NULL;
        told.overlap_capacity = k < 3 ? k : 2;
        CHECK_INT(sp_contacts_find(&scene, NULL, test_arena, &told), SP_OK);
        CHECK_INT(told.overlaps, 3);
        for (int32_t q = 0; q < 2; q++) {
            CHECK_INT(few[q].depth > 0, k < 3 && q < k);
            if (k < 3 && q < k) CHECK(few[q].a == 2 * q && few[q].b == 2 * q + 1);
        }
    }
}

TEST(a_stone_in_the_notch_of_an_l_is_told_only_when_inside)
{
    const frame f = turned(1, 2, 3, 4, 0, 1);
    for (int k = 0; k < 2; k++) {
        const double into = k ? 0.125 : 0;
        NEED(start(2));
        prism(&f, 6, ell, 0, 1, -1, 0, SP_FIXED);
        box(&f, 1 - into, 1 - into, 0.25, 2, 2, 0.75, 0);
        CHECK_INT(find(NULL), SP_OK);
        CHECK_INT(report.overlaps, CONVEX_ONLY ? 0 : k);
        CHECK_INT(report.joints, k ? 0 : 2);
        if (k && !CONVEX_ONLY) CHECK_NEAR(overlap[0].depth, 0.125, 0.5);
    }
}

TEST(too_little_room_in_the_scene_changes_nothing)
{
    const frame f = upright();
    const sp_capacity cap = { 3, 24, 18, 72, 1, 8, 0 };
    NEED(CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK));
    for (int k = 0; k < 3; k++) box(&f, 0, 0, k, 1, 1, k + 1, k ? 0 : SP_FIXED);
    const sp_capacity before = scene.count;
    CHECK_INT(find(NULL), SP_E_CAPACITY);
    CHECK_INT(report.joints, 2);
    CHECK_INT(report.points, 8);
    CHECK_INT(memcmp(&before, &scene.count, sizeof before), 0);
}

TEST(the_scratch_it_asks_for_is_enough_and_little_is_refused)
{
    const frame f = upright();
    NEED(start(5));
    for (int k = 0; k < 5; k++) box(&f, 0, 0, k, 1, 1, k + 1, k ? 0 : SP_FIXED);
    const sp_capacity before = scene.count;
    const size_t need = test_bytes(&scene, SP_FOR_CONTACTS, NULL);
    unsigned char *memory = test_arena.base + test_arena.used;
    int enough = 0;
    for (size_t bytes = 64; bytes <= need; bytes += bytes < need && bytes + 997 > need ? need - bytes : 997) {
        sp_arena a;
        NEED(CHECK_INT(sp_arena_init(&a, memory, bytes), SP_OK));
        const sp_status s = sp_contacts_find(&scene, NULL, a, &report);
        enough = s == SP_OK;
        if (s) CHECK_INT(s, SP_E_MEMORY);
        if (s) CHECK_INT(memcmp(&before, &scene.count, sizeof before), 0);
        scene.count = before;
        if (bytes == need) break;
    }
    CHECK(enough);
}

TEST(nonsense_is_refused)
{
    const frame f = upright();
    sp_contact_settings set = sp_contact_settings_default();
    NEED(start(1));
    box(&f, 0, 0, 0, 1, 1, 1, 0);
    CHECK_INT(sp_contacts_find(NULL, NULL, test_arena, &report), SP_E_ARGUMENT);
    CHECK_INT(sp_contacts_find(&scene, NULL, test_arena, NULL), SP_E_ARGUMENT);
    set.distance = -1;
    CHECK_INT(find(&set), SP_E_RANGE);
    set = sp_contact_settings_default();
    set.strength.mu = -1;
    CHECK_INT(find(&set), SP_E_RANGE);
    set = sp_contact_settings_default();
    set.angle = 2;
    CHECK_INT(find(&set), SP_E_RANGE);
#ifdef SP_SMALL
    set.angle = -1;
#else
    set.angle = -65;
#endif
    CHECK_INT(find(&set), SP_E_RANGE);
}

/* Bricks of 2 x 1 x 1, every second course moved by half a brick, and a slab below. */
static void wall(int32_t courses, int32_t long_, int order)
{
    const frame f = turned(1, 0, 0, 0.3, 1, 0.1);
    for (int32_t i = 0; i < courses * long_ + 1; i++) {
        const int32_t k = order ? courses * long_ - i : i;
        if (k == courses * long_) { box(&f, -1, -1, -1, 2 * long_ + 2, 2, 0, SP_FIXED); continue; }
        const int32_t row = k / long_, x = 2 * (k % long_) + row % 2;
        box(&f, x, 0, row, x + 2, 1, row + 1, 0);
    }
}

TEST(a_running_bond_has_the_contacts_of_its_formula)
{
    enum { N = 8, L = 9 };
    double area[2];
    for (int order = 0; order < 2; order++) {
        NEED(start(N * L + 1));
        wall(N, L, order);
        CHECK_INT(find(NULL), SP_OK);
        /* heads N (L - 1); beds: 2 L - 1 between courses; L on the slab */
        CHECK_INT(report.joints, N * (L - 1) + (N - 1) * (2 * L - 1) + L);
        CHECK_INT(report.points, 4 * report.joints);
        CHECK_INT(report.overlaps, 0);
        area[order] = area_sum();
        for (int32_t k = 1; k < scene.count.joints; k++) {
            const sp_joint *p = &scene.joint[k - 1], *q = &scene.joint[k];
            CHECK(p->a < q->a || (p->a == q->a && p->b < q->b));
            CHECK(q->a < q->b);
        }
    }
    CHECK_NEAR(area[0], 0.01 * (N * (L - 1) + (N - 1) * (2 * L - 1) + 2 * L), CLOSE);
    CHECK_NEAR(area[1], area[0], CLOSE);
}

TEST_LIST(contacts)
    RUN(aligned_cubes_share_their_square)
    RUN(the_normal_points_from_the_lower_number_whoever_lies_below)
    RUN(offset_cubes_share_three_quarters)
    RUN(cubes_side_by_side_share_a_wall)
    RUN(a_turned_cube_on_a_cube_shares_the_octagon)
    RUN(cubes_that_share_an_edge_or_corner_do_not_touch_in_faces)
    RUN(gaps_count_by_the_distance)
    RUN(tilted_faces_count_by_the_angle)
#ifndef SP_SMALL
    RUN(a_tilted_face_touches_where_it_is_within_the_distance)
    RUN(a_distance_does_not_reach_through_a_slate)
    RUN(faces_touch_up_to_a_quarter_of_the_thinner_block)
    RUN(a_large_distance_loses_no_cube_on_a_cube)
    RUN(a_slab_deep_in_another_is_told_at_every_distance)
    RUN(narrow_faces_may_stand_steeper)
#endif
    RUN(frames_and_units_do_not_matter)
    RUN(supports_do_not_touch_each_other)
    RUN(a_flat_support_is_enough)
    RUN(blocks_inside_each_other_are_told_with_their_depth)
    RUN(what_lies_to_any_side_is_apart_or_touches_or_overlaps)
    RUN(overlaps_beyond_the_room_for_them_are_counted)
    RUN(a_stone_in_the_notch_of_an_l_is_told_only_when_inside)
    RUN(too_little_room_in_the_scene_changes_nothing)
    RUN(the_scratch_it_asks_for_is_enough_and_little_is_refused)
    RUN(nonsense_is_refused)
    RUN(a_running_bond_has_the_contacts_of_its_formula)
TEST_END
