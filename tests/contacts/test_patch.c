/* Faces that are not convex, or made of many triangles, touch as what they make up. */
#include "contacts.h"

static int refused(void)
{
    if (!CONVEX_ONLY) return 0;
    CHECK_INT(find(NULL), SP_E_UNSUPPORTED);
    CHECK_INT(scene.count.joints, 0);
    CHECK_INT(scene.count.points, 0);
    return 1;
}

/* Does a joint have a corner at p, to within tol? */
static int has_corner(int32_t k, const sp_real p[3], double tol)
{
    const sp_joint *f = &scene.joint[k];
    for (int32_t i = f->point; i < f->point + f->points; i++) {
        double d = 0;
        for (int c = 0; c < 3; c++) {
            const double x = (double)scene.point[i][c] - (double)p[c];
            d += x * x;
        }
        if (d <= tol * tol) return 1;
    }
    return 0;
}
static double you[8][2] = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };

TEST(an_l_on_a_slab_keeps_its_reflex_corner)
{
    const frame f = turned(1, 2, 3, 4, 0, 1);
    NEED(start(2));
    box(&f, -1, -1, -1, 4, 4, 0, SP_FIXED);
    prism(&f, 6, ell, 0, 1, -1, 0, 0);
    if (refused()) return;
    expect_one(6, 5);
    sp_real reflex[3];
    place(&f, 1, 1, 0, reflex);
    NEED(scene.count.joints == 1);
    CHECK(has_corner(0, reflex, TOL(1e-14, 1e-5)));
}

TEST(the_legs_of_a_u_are_two_patches)
{
    const frame f = upright();
    NEED(start(2));
    box(&f, -1, 2, -1, 4, 5, 0, SP_FIXED);
    prism(&f, 8, you, 0, 1, -1, 0, 0);
    if (refused()) return;
    CHECK_INT(find(NULL), SP_OK);
    CHECK_INT(report.joints, 2);
    CHECK_INT(report.points, 8);
    CHECK_NEAR(area_sum(), 2, CLOSE);
}

TEST(two_us_face_to_face_touch_at_both_legs)
{
    frame f = turned(1, 0.3, 0.2, 0.1, 2, 1), g = f;
    for (int k = 0; k < 3; k++) {                       /* turned by half about z, moved to (3, 6, 0) */
        g.r[k][0] = -f.r[k][0];
        g.r[k][1] = -f.r[k][1];
        g.shift[k] += 3 * f.r[k][0] + 6 * f.r[k][1];
    }
    NEED(start(2));
    prism(&f, 8, you, 0, 1, -1, 0, 0);
    prism(&g, 8, you, 0, 1, -1, 0, 0);
    CHECK_INT(find(NULL), SP_OK);
    CHECK_INT(report.joints, CONVEX_ONLY ? 1 : 2);
    CHECK_INT(report.overlaps, 0);
    CHECK_NEAR(area_sum(), CONVEX_ONLY ? 3 : 2, CLOSE);
}

/* A contact of the smallest build, which may begin at another corner: the area and corners of that wanted. */
static void turned_round(int32_t k, const sp_joint *want, sp_real (*point)[3])
{
    CHECK_INT(scene.joint[k].a, want->a);
    CHECK_INT(scene.joint[k].b, want->b);
    CHECK_NEAR(scene.joint[k].area, want->area, TOL(1e-9, 1e-5f));
    for (int32_t i = want->point; i < want->point + want->points; i++) CHECK(has_corner(k, point[i], TOL(1e-12, 1e-5)));
}

TEST(triangulated_stones_have_the_contacts_of_polygonal_ones)
{
    static double six[6][2] = { { 0, 0 }, { 2, -0.5 }, { 3, 1 }, { 2.5, 3 }, { 1, 3.5 }, { -0.5, 1.5 } };
    static double eight[8][2] = { { 1, 0 }, { 2, 0 }, { 3, 1 }, { 3, 2 }, { 2, 3 }, { 1, 3 }, { 0, 2 }, { 0, 1 } };
    const frame f = turned(2, -1, 3, 0.5, 3, 1);
    for (int shape = CONVEX_ONLY ? 2 : 0; shape < 4; shape++) {
        sp_joint want[8];
        static sp_real point[64][3];
        int32_t count = 0, points = 0;
        for (int model = 0; model < 6; model++) {       /* polygonal, then fans and other face orders */
            NEED(start(3));
            const int fan = model && shape != 1 ? 3 : -1, low = model & 1 ? 0 : -1;
            double slab[4][2] = { { -1, -1 }, { 2.5, -1 }, { 2.5, 4 }, { -1, 4 } };
            prism(&f, 4, slab, -1, 0, low, model, SP_FIXED);
            prism(&f, shape & 1 ? 8 : 6, shape == 0 ? ell : shape == 1 ? you : shape == 2 ? six : eight, 0, 1, fan, 2 * model, 0);
            prism(&f, 4, slab, 1, 2, model > 2 ? 2 : -1, 3 * model, 0);
            CHECK_INT(find(NULL), SP_OK);
            CHECK_INT(report.overlaps, 0);
            if (!model) {
                count = scene.count.joints;
                points = scene.count.points;
                NEED(count <= 8 && points <= 64);
                memcpy(want, scene.joint, (size_t)count * sizeof *want);
                memcpy(point, scene.point, (size_t)points * sizeof *point);
                continue;
            }
            NEED(scene.count.joints == count && scene.count.points == points);
            if (CONVEX_ONLY) {
                for (int32_t k = 0; k < count; k++) turned_round(k, &want[k], point);
                continue;
            }
            for (int32_t k = 0; k < count; k++) {
                CHECK_INT(scene.joint[k].a, want[k].a);
                CHECK_INT(scene.joint[k].b, want[k].b);
                CHECK_NEAR(scene.joint[k].area, want[k].area, TOL(1e-9, 1e-5f));
            }
            for (int32_t k = 0; k < points; k++)        /* the same corners in the same order */
                for (int c = 0; c < 3; c++) CHECK_WITHIN(scene.point[k][c], point[k][c], TOL(1e-13, 2e-5f));
        }
    }
}

TEST(fans_of_triangles_make_up_an_l)
{
    const frame f = turned(2, -1, 3, 0.5, 3, 1);
    NEED(start(2));
    box(&f, -1, -1, -1, 4, 4, 0, SP_FIXED);
    prism(&f, 6, ell, 0, 1, 3, 2, 0);
    expect_one(CONVEX_ONLY ? 5 : 6, CONVEX_ONLY ? 7 : 5);
    for (int k = 0; k < 6; k++) {
        sp_real p[3];
        place(&f, ell[k][0], ell[k][1], 0, p);
        CHECK_INT(has_corner(0, p, TOL(1e-12, 1e-5)), !CONVEX_ONLY || k != 3);
    }
}

/* More corners than the smallest build gathers at once: it has several contacts then, and all corners. */
TEST(drums_of_many_triangles_touch_all_round)
{
    enum { N = 46 };
    const frame f = turned(2, -1, 3, 0.5, 3, 1);
    double round[N][2], x = 1, y = 0;
    for (int k = 0; k < N; k++) {                       /* turned by a 46th of a circle each */
        const double u = 0.9906859460363308 * x - 0.1361666490962466 * y;
        round[k][0] = x;
        round[k][1] = y;
        y = 0.1361666490962466 * x + 0.9906859460363308 * y;
        x = u;
    }
    NEED(start(2));
    prism(&f, N, round, -1, 0, 0, 0, SP_FIXED);
    prism(&f, N, round, 0, 1, 20, 7, 0);
    CHECK_INT(find(NULL), SP_OK);
    CHECK(CONVEX_ONLY ? report.joints > 1 : report.joints == 1);
    for (int k = 0; k < N; k++) {
        sp_real p[3];
        int seen = 0;
        place(&f, round[k][0], round[k][1], 0, p);
        for (int32_t i = 0; i < scene.count.joints; i++) seen |= has_corner(i, p, TOL(1e-12, 1e-5));
        CHECK(seen);
    }
}

/* Faces narrower than the distance, of a patch that is not: a drum in a fan about the middle of its cap, on a slab in strips. */
TEST(narrow_faces_make_up_what_they_share)
{
    enum { N = 128, STRIPS = 50 };
    static sp_real xyz[4 * N + 8][3];
    static int32_t size[4 * N], corner[16 * N];
    const double step[2] = { 0.99879545620517239, 0.049067674327418015 };       /* a 128th of a circle */
    const frame f = turned(2, -1, 3, 0.5, 3, 1);
    sp_contact_settings set = sp_contact_settings_default();
    sp_arena a;
    sp_result r;
    int32_t faces = 0, corners = 0;
    NEED(start(8));
    for (int k = 0; k <= STRIPS; k++)
        for (int e = 0; e < 4; e++) place(&f, -1 + 2.0 * k / STRIPS, e % 2 * 2 - 1, e / 2 - 1, xyz[4 * k + e]);
    for (int k = 0; k < STRIPS; k++) {
        static const int32_t turn[4][4] = { { 2, 6, 7, 3 }, { 0, 1, 5, 4 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
        for (int s = 0; s < 4; s++, size[faces++] = 4) for (int c = 0; c < 4; c++) corner[corners++] = 4 * k + turn[s][c];
    }
    const sp_mesh slab = { 4 * STRIPS + 4, faces, xyz[0], size, corner };       /* a support may be open at its ends */
    NEED(CHECK_INT(sp_scene_block(&scene, &slab, 2400, SP_FIXED, NULL), SP_OK));
    double x = 0.5, y = 0;
    for (int k = faces = corners = 0; k < N; k++) {
        const int32_t q = (k + 1) % N, t[10] = { 2 * N, q, k, 2 * N + 1, N + k, N + q, k, q, N + q, N + k };
        for (int s = 0; s < 3; s++) size[faces++] = s < 2 ? 3 : 4;
        for (int c = 0; c < 10; c++) corner[corners++] = t[c];
        for (int e = 0; e < 2; e++) place(&f, x, y, e, xyz[e * N + k]);
        const double u = step[0] * x - step[1] * y;
        y = step[1] * x + step[0] * y;
        x = u;
    }
    for (int e = 0; e < 2; e++) place(&f, 0, 0, e, xyz[2 * N + e]);
    const sp_mesh drum = { 2 * N + 2, faces, xyz[0], size, corner };
    NEED(CHECK_INT(sp_scene_block(&scene, &drum, 2400, 0, NULL), SP_OK));
    set.absolute = 1;
    set.distance = R(0.06);                             /* strips are 0.04 wide, sectors 0.025 at most */
    CHECK_INT(find(&set), SP_OK);
    CHECK(CONVEX_ONLY ? report.joints >= 1 : report.joints == 1);
    for (int k = 0; k < N; k++) {
        int seen = 0;
        for (int32_t i = 0; i < scene.count.joints; i++) seen |= has_corner(i, xyz[k], TOL(1e-12, 1e-5));
        CHECK(seen);
    }
    scene.gravity[0] = R(-9.81 * f.r[0][2]);
    scene.gravity[1] = R(-9.81 * f.r[1][2]);
    scene.gravity[2] = R(-9.81 * f.r[2][2]);
    a = test_arena;
    CHECK_INT(sp_check(&scene, NULL, &a, &r), SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
}

/* What is narrower than the distance as a whole is left out, in one face or in two; but not of exact faces, whose gap is 0. */
TEST(what_is_narrower_than_the_distance_is_left_out)
{
    const frame f = upright();
    sp_contact_settings set = sp_contact_settings_default();
    set.absolute = 1;
    set.distance = R(0.01);
    for (int k = 0; k < 8; k++) {
        const int fan = k % 2 - 1, wide = k / 2 % 2, exact = k / 4;
        double low[4][2] = { { -2, 0 }, { 0, 0 }, { 0, 1 }, { -2, 1 } }, high[4][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } };
        high[0][0] = high[3][0] = wide ? -0.015 : -0.007;
        NEED(start(2));
        prism(&f, 4, low, -1, 0, fan, 0, SP_FIXED);
        prism(&f, 4, high, exact ? 0 : 1e-4, 1, fan, 0, 0);
        CHECK_INT(find(&set), SP_OK);
        CHECK_INT(report.joints, wide || (exact && !CONVEX_ONLY));
    }
}

/* A beam on two ledges, bearing 3 mm on each: it stands at every distance, as at the default. */
TEST(an_exact_contact_narrower_than_the_distance_is_kept)
{
    const frame f = turned(2, -1, 3, 0.5, 3, 1);
    sp_contact_settings set = sp_contact_settings_default();
    sp_result r;
    set.absolute = 1;
    for (int k = 0; k < 6; k++) {
        double beam[4][2] = { { 0, 0 }, { 2, 0 }, { 2, 0.3 }, { 0, 0.3 } };
        NEED(start(3));
        box(&f, -0.5, -0.1, -0.5, 0.003, 0.4, 0, SP_FIXED);
        box(&f, 1.997, -0.1, -0.5, 2.5, 0.4, 0, SP_FIXED);
        prism(&f, 4, beam, 0, 0.4, k % 2 - 1, 0, 0);
        for (int c = 0; c < 3; c++) scene.gravity[c] = R(-9.81 * f.r[c][2]);
        set.distance = k < 2 ? R(1e-6) : k < 4 ? R(0.01) : R(0.1);
        CHECK_INT(find(&set), SP_OK);
        if (CONVEX_ONLY && k > 1) continue;             /* the smallest build leaves it out */
        CHECK_INT(report.joints, 2);
        CHECK_NEAR(area_sum(), 2 * 0.003 * 0.3, TOL(1e-9, 1e-2));
        sp_arena a = test_arena;
        CHECK_INT(sp_check(&scene, NULL, &a, &r), SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);
    }
}

/* A stone across a gap between two plates of one support. */
TEST(two_rims_of_a_gap_narrower_than_the_distance_do_not_make_a_wide_contact)
{
    static const sp_real plate[8][3] = { { -1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 }, { -1, 1, 0 },
                                         { 1, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 } };
    static const int32_t size[2] = { 4, 4 }, corner[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
    const sp_mesh plates = { 8, 2, plate[0], size, corner };
    const frame f = upright();
    sp_contact_settings set = sp_contact_settings_default();
    set.absolute = 1;
    set.distance = R(0.002);
    for (int fan = -1; fan < 1; fan++)
        for (int wide = 0; wide < 3; wide++) {          /* none of the rims, one, both */
            const double left = wide ? -0.003 : -0.0015, right = wide == 2 ? 1.003 : 1.0015;
            double xy[4][2] = { { left, 0 }, { right, 0 }, { right, 1 }, { left, 1 } };
            NEED(start(2));
            CHECK_INT(sp_scene_block(&scene, &plates, 2400, SP_FIXED, NULL), SP_OK);
            prism(&f, 4, xy, 1e-4, 1, fan, 0, 0);
            CHECK_INT(find(&set), SP_OK);
            CHECK_INT(report.joints, CONVEX_ONLY ? wide > 0 : wide);
            sp_arena a = test_arena;
            sp_result r;
            CHECK_INT(sp_check(&scene, NULL, &a, &r), SP_OK);
            CHECK_INT(r.verdict, wide == 2 ? SP_STABLE : SP_UNSTABLE);
        }
}

/* A slab of length 2 that reaches `out` beyond the edge of another it lies on, both cut into triangles as fans from corners `low`
 * and `high`, below 0 not: it stands up to half its length, whatever diagonals cut what they share. */
static sp_verdict overhanging(double out, int low, int high)
{
    const frame f = upright();
    const sp_arena before = test_arena;
    sp_arena a;
    sp_result r;
    if (!start(2)) return SP_UNDECIDED;
    double base[4][2] = { { -2, 0 }, { 0, 0 }, { 0, 1 }, { -2, 1 } }, top[4][2] = { { out - 2, 0 }, { out, 0 }, { out, 1 }, { out - 2, 1 } };
    prism(&f, 4, base, -1, 0, low, 0, SP_FIXED);
    prism(&f, 4, top, 0, 1, high, 0, 0);
    CHECK_INT(find(NULL), SP_OK);
    a = test_arena;
    CHECK_INT(sp_check(&scene, NULL, &a, &r), SP_OK);
    test_arena = before;
    return r.verdict;
}

TEST(triangulated_slabs_overhang_as_far_as_polygonal_ones)
{
    for (int low = -1; low < 4; low++)
        for (int high = -1; high < 4; high++) {
            CHECK_INT(overhanging(1 - TOL(1e-6, 1e-2), low, high), SP_STABLE);
            CHECK_INT(overhanging(1 + TOL(1e-6, 1e-2), low, high), SP_UNSTABLE);
        }
}

/* A square ring: outer 4 x 4, inner 2 x 2, height 1; its caps are one face each, with a bridge from rim to hole. */
static void ring(const frame *f, double z0, double z1)
{
    static const int32_t size[10] = { 10, 10, 4, 4, 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[52] = { 8, 9, 10, 11, 8, 12, 15, 14, 13, 12,     /* top, outer ring then hole by the bridge */
                                        0, 4, 5, 6, 7, 4, 0, 3, 2, 1,            /* bottom */
                                        0, 1, 9, 8, 1, 2, 10, 9, 2, 3, 11, 10, 3, 0, 8, 11,
                                        4, 12, 13, 5, 5, 13, 14, 6, 6, 14, 15, 7, 7, 15, 12, 4 };
    static const double xy[8][2] = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1, 1 }, { 3, 1 }, { 3, 3 }, { 1, 3 } };
    sp_real xyz[16][3];
    for (int k = 0; k < 8; k++) {
        place(f, xy[k][0], xy[k][1], z0, xyz[k]);
        place(f, xy[k][0], xy[k][1], z1, xyz[8 + k]);
    }
    const sp_mesh mesh = { 16, 10, xyz[0], size, corner };
    CHECK_INT(sp_scene_block(&scene, &mesh, 2400, 0, NULL), SP_OK);
}

TEST(a_ring_on_a_slab_has_the_area_of_the_ring)
{
    const frame f = turned(1, 0.2, -0.4, 0.3, 1, 1);
    NEED(start(2));
    box(&f, -1, -1, -1, 5, 5, 0, SP_FIXED);
    ring(&f, 0, 1);
    if (refused()) return;
    CHECK_INT(find(NULL), SP_OK);
    CHECK(report.joints >= 2);
    CHECK_INT(report.overlaps, 0);
    CHECK_NEAR(area_sum(), 12, CLOSE);
    static const double xy[8][2] = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 1, 1 }, { 3, 1 }, { 3, 3 }, { 1, 3 } };
    for (int k = 0; k < 8; k++) {
        sp_real p[3];
        int seen = 0;
        place(&f, xy[k][0], xy[k][1], 0, p);
        for (int32_t i = 0; i < scene.count.joints; i++) seen += has_corner(i, p, TOL(1e-12, 1e-5));
        CHECK(seen > 0);
    }
}

TEST(a_plug_in_a_ring_touches_all_round)
{
    const frame f = turned(1, 0.2, -0.4, 0.3, 1, 1);
    NEED(start(2));
    ring(&f, 0, 1);
    box(&f, 1, 1, 0, 3, 3, 1, 0);
    CHECK_INT(find(NULL), SP_OK);
    CHECK_INT(report.joints, 4);
    CHECK_INT(report.overlaps, 0);
    CHECK_NEAR(area_sum(), 8, CLOSE);
}

TEST_LIST(patch)
    RUN(an_l_on_a_slab_keeps_its_reflex_corner)
    RUN(the_legs_of_a_u_are_two_patches)
    RUN(two_us_face_to_face_touch_at_both_legs)
    RUN(triangulated_stones_have_the_contacts_of_polygonal_ones)
    RUN(fans_of_triangles_make_up_an_l)
    RUN(drums_of_many_triangles_touch_all_round)
    RUN(narrow_faces_make_up_what_they_share)
    RUN(what_is_narrower_than_the_distance_is_left_out)
    RUN(an_exact_contact_narrower_than_the_distance_is_kept)
    RUN(two_rims_of_a_gap_narrower_than_the_distance_do_not_make_a_wide_contact)
    RUN(triangulated_slabs_overhang_as_far_as_polygonal_ones)
    RUN(a_ring_on_a_slab_has_the_area_of_the_ring)
    RUN(a_plug_in_a_ring_touches_all_round)
TEST_END
