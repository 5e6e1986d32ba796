/* test_contacts: what touches what, on stones whose common faces are known. */
#include <string.h>
#include "../test.h"

#define MANY 64                                         /* corners of a prism's outline */
#define CLOSE TOL(1e-9, 2e-5f)

/* A frame: x = unit (R x' + shift); identity to start with. */
typedef struct frame { double r[3][3], shift[3], unit; } frame;

static frame upright(void)
{
    frame f = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { 0, 0, 0 }, 1 };
    return f;
}

/* A rotation with rational-looking numbers, from the quaternion (w, x, y, z) / |.|. */
static frame turned(double w, double x, double y, double z, double shift, double unit)
{
    const double s = 2 / (w * w + x * x + y * y + z * z);
    frame f = { { { 1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w) },
                  { s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w) },
                  { s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y) } },
                { shift, -shift, 2 * shift }, unit };
    return f;
}

static void place(const frame *f, double x, double y, double z, sp_real out[3])
{
    for (int k = 0; k < 3; k++)
        out[k] = R(f->unit * (f->r[k][0] * x + f->r[k][1] * y + f->r[k][2] * z + f->shift[k]));
}

static sp_scene scene;
static sp_contact_report report;
static sp_overlap overlap[16];

/* A scene with ample room. */
static int start(int32_t blocks)
{
    const sp_capacity cap = { blocks, blocks * 160, blocks * 200, blocks * 900, blocks * 12, blocks * 200, 0 };
    return CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
}

/* Upright prism over an outline, anticlockwise; caps as one polygon, or as a fan from corner `fan` >= 0; sides as one
 * rectangle or as two triangles. `first` turns the order of the faces, so it must not matter. */
static int32_t prism(const frame *f, int32_t n, double (*xy)[2], double z0, double z1, int fan, int first, uint32_t fixed)
{
    static sp_real xyz[2 * MANY][3];
    static int32_t size[6 * MANY], corner[16 * MANY], begin[6 * MANY], s2[6 * MANY], c2[16 * MANY];
    int32_t faces = 0, corners = 0, id = -1, at = 0;
    for (int32_t k = 0; k < n; k++) {
        place(f, xy[k][0], xy[k][1], z0, xyz[k]);
        place(f, xy[k][0], xy[k][1], z1, xyz[n + k]);
    }
    for (int cap = 0; cap < 2; cap++) {
        if (fan < 0) {
            begin[faces] = corners;
            size[faces++] = n;
            for (int32_t k = 0; k < n; k++) corner[corners++] = cap ? n + k : n - 1 - k;
            continue;
        }
        for (int32_t k = 1; k + 1 < n; k++) {
            const int32_t a = (fan + k) % n, b = (fan + k + 1) % n;
            begin[faces] = corners;
            size[faces++] = 3;
            corner[corners++] = cap ? n + fan : fan;
            corner[corners++] = cap ? n + a : b;
            corner[corners++] = cap ? n + b : a;
        }
    }
    for (int32_t k = 0; k < n; k++) {
        const int32_t m = (k + 1) % n, q[4] = { k, m, n + m, n + k };
        for (int t = 0; t < (fan < 0 ? 1 : 2); t++) {
            begin[faces] = corners;
            size[faces++] = fan < 0 ? 4 : 3;
            corner[corners++] = q[0];
            corner[corners++] = q[1 + t];
            corner[corners++] = q[2 + t];
            if (fan < 0) corner[corners++] = q[3];
        }
    }
    for (int32_t k = 0; k < faces; k++) {
        const int32_t g = (k + first) % faces;
        s2[k] = size[g];
        for (int32_t c = 0; c < size[g]; c++) c2[at++] = corner[begin[g] + c];
    }
    const sp_mesh mesh = { 2 * n, faces, xyz[0], s2, c2 };
    CHECK_INT(sp_scene_block(&scene, &mesh, 2400, fixed, &id), SP_OK);
    return id;
}

static int32_t box(const frame *f, double x0, double y0, double z0, double x1, double y1, double z1, uint32_t fixed)
{
    double xy[4][2] = { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
    return prism(f, 4, xy, z0, z1, -1, 0, fixed);
}

static sp_status find(const sp_contact_settings *set)
{
    const size_t need = test_bytes(&scene, SP_FOR_CONTACTS, NULL);
    if (!CHECK(need > 0 && need < test_arena.cap - test_arena.used)) return SP_E_MEMORY;
    report.overlap = overlap;
    report.overlap_cap = 16;
    return sp_contacts_find(&scene, set, test_arena, &report);
}

/* The smallest build knows convex faces alone: another one with an opposed one near it is refused. Of what two blocks share in one
 * plane it has the convex hull. */
#ifdef SP_SMALL
enum { CONVEX_ONLY = 1 };
#else
enum { CONVEX_ONLY = 0 };
#endif

static int refused(void)
{
    if (!CONVEX_ONLY) return 0;
    CHECK_INT(find(NULL), SP_E_UNSUPPORTED);
    CHECK_INT(scene.count.joints, 0);
    CHECK_INT(scene.count.points, 0);
    return 1;
}

static double area_sum(void)
{
    double a = 0;
    for (int32_t k = 0; k < scene.count.joints; k++) a += (double)scene.joint[k].area;
    return a;
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

/* One contact of n corners and this area, and no overlap. */
static void expect_one(int32_t corners, double area)
{
    CHECK_INT(find(NULL), SP_OK);
    CHECK_INT(report.joints, 1);
    CHECK_INT(report.points, corners);
    CHECK_INT(report.overlaps, 0);
    CHECK_NEAR(area_sum(), area, CLOSE);
}

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

static double ell[6][2] = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };
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

/* What is narrower than the distance as a whole is left out, in one face or in two. */
TEST(what_is_narrower_than_the_distance_is_left_out)
{
    const frame f = upright();
    sp_contact_settings set = sp_contact_settings_default();
    set.absolute = 1;
    set.distance = R(0.01);
    for (int fan = -1; fan < 1; fan++)
        for (int wide = 0; wide < 2; wide++) {
            double low[4][2] = { { -2, 0 }, { 0, 0 }, { 0, 1 }, { -2, 1 } }, high[4][2] = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } };
            high[0][0] = high[3][0] = wide ? -0.015 : -0.007;
            NEED(start(2));
            prism(&f, 4, low, -1, 0, fan, 0, SP_FIXED);
            prism(&f, 4, high, 0, 1, fan, 0, 0);
            CHECK_INT(find(&set), SP_OK);
            CHECK_INT(report.joints, wide);
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
            prism(&f, 4, xy, 0, 1, fan, 0, 0);
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
    RUN(frames_and_units_do_not_matter)
    RUN(an_l_on_a_slab_keeps_its_reflex_corner)
    RUN(the_legs_of_a_u_are_two_patches)
    RUN(two_us_face_to_face_touch_at_both_legs)
    RUN(triangulated_stones_have_the_contacts_of_polygonal_ones)
    RUN(fans_of_triangles_make_up_an_l)
    RUN(drums_of_many_triangles_touch_all_round)
    RUN(narrow_faces_make_up_what_they_share)
    RUN(what_is_narrower_than_the_distance_is_left_out)
    RUN(two_rims_of_a_gap_narrower_than_the_distance_do_not_make_a_wide_contact)
    RUN(triangulated_slabs_overhang_as_far_as_polygonal_ones)
    RUN(a_ring_on_a_slab_has_the_area_of_the_ring)
    RUN(a_plug_in_a_ring_touches_all_round)
    RUN(supports_do_not_touch_each_other)
    RUN(a_flat_support_is_enough)
    RUN(blocks_inside_each_other_are_told_with_their_depth)
    RUN(a_stone_in_the_notch_of_an_l_is_told_only_when_inside)
    RUN(too_little_room_in_the_scene_changes_nothing)
    RUN(the_scratch_it_asks_for_is_enough_and_little_is_refused)
    RUN(nonsense_is_refused)
    RUN(a_running_bond_has_the_contacts_of_its_formula)
TEST_END
