/* Lengths of the coupled check, and the spin of a block that moves no contact, from the inside and by their formulas. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/triple.c"

#if SP__WITH_COUPLED

#include <math.h>

enum { MOST = 12 };

static sp_scene scene;
static sp_problem pb;
static sp_settings set;
static sp__certifier j;

/* A ground and a block whose centroid is at c; joints are added, then the problem is built. */
static int begin(const double c[3], double mass)
{
    const sp_capacity room = { 2, 0, 0, 0, 4, MOST, 0 };
    const sp_real ground[3] = { 0, 0, -9 }, at[3] = { R(c[0]), R(c[1]), R(c[2]) };
    memset(&set, 0, sizeof set);
    set.tol = R(TOL(1e-9, 1e-4f));
    set.force_bound = 100;
    if (!CHECK_INT(sp_scene_create(&scene, &room, &test_arena), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&scene, 0, ground, SP_FIXED, NULL), SP_OK)) return 0;
    return CHECK_INT(sp_scene_body(&scene, R(mass), at, 0, NULL), SP_OK);
}

static int joint(int32_t points, const double *x)
{
    const sp_strength rough = sp_strength_friction(R(0.5));
    const sp_real n[3] = { 0, 0, 1 };
    sp_real at[3 * MOST];
    for (int k = 0; k < 3 * points; k++) at[k] = R(x[k]);
    return CHECK_INT(sp_scene_points(&scene, 0, 1, n, points, at, &rough, NULL), SP_OK);
}

static int build(void)
{
    return CHECK_INT(sp_problem_build(&scene, &test_arena, &pb), SP_OK) &&
           CHECK(sp__certifier_open(&j, &pb, &set, NULL, INT32_MAX, &test_arena));
}

/* A triangle 3, 4, 5; a rectangle 1 by 2; a line of 6, walked once; a point, none: (12 + 6 + 6) / 8. */
TEST(the_mean_edge_is_that_of_polygons_all_around_and_of_lines_once)
{
    static const double three[3][3] = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } };
    static const double four[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 }, { 0, 2, 0 } };
    static const double two[2][3] = { { 0, 0, 0 }, { 6, 0, 0 } }, c[3] = { 0, 0, 1 };
    NEED(begin(c, 1));
    NEED(joint(3, three[0]) && joint(4, four[0]) && joint(2, two[0]) && joint(1, two[1]));
    NEED(build());
    CHECK_NEAR(sp__mean_edge(&pb), 3, TOL(1e-14, 1e-6));
}

/* Where joints are points: the mean of their distances from both centroids, the ground's, which does not count, 0. */
TEST(without_edges_the_length_is_the_mean_arm_of_joints)
{
    static const double x[3][3] = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 } }, c[3] = { 0, 0, R(0.25) };
    double arms = 0;
    NEED(begin(c, 1));
    for (int k = 0; k < 3; k++) NEED(joint(1, x[k]));
    NEED(build());
    for (int k = 0; k < 3; k++) arms += (double)(sp__norm3(pb.contact[k].ra) + sp__norm3(pb.contact[k].rb)) / 2;
    CHECK(arms > 1);
    CHECK_NEAR(sp__mean_edge(&pb), arms / 3, TOL(1e-14, 1e-6));
    for (int k = 0; k < 3; k++) scene.point[k][0] = scene.point[k][1] = 0;      /* all at a quarter below */
    NEED(CHECK_INT(sp_problem_build(&scene, &test_arena, &pb), SP_OK));
    arms = (double)(sp__norm3(pb.contact[0].ra) + sp__norm3(pb.contact[0].rb)) / 2;
    CHECK_NEAR(sp__mean_edge(&pb), arms, TOL(1e-14, 1e-6));
    pb.contacts = 0;
    CHECK_NEAR(sp__mean_edge(&pb), 1, 0);
}

/* Edges that are .12 together, arms that are .3: small scenes are as large ones. */
TEST(lengths_of_small_scenes_are_small)
{
    static const double three[3][3] = { { 0, 0, 0 }, { 0.03, 0, 0 }, { 0, 0.04, 0 } }, c[3] = { 0, 0, 1 };
    const sp_arena mark = test_arena;
    NEED(begin(c, 1));
    NEED(joint(3, three[0]) && build());
    CHECK_NEAR(sp__mean_edge(&pb), 0.04, TOL(1e-14, 1e-6));
    test_arena = mark;
    NEED(begin(c, 1));
    NEED(joint(1, three[0]) && joint(1, three[1]) && joint(1, three[2]) && build());
    for (int q = 0; q < 3; q++) {
        memset(pb.contact[q].ra, 0, sizeof pb.contact[q].ra);
        memset(pb.contact[q].rb, 0, sizeof pb.contact[q].rb);
        pb.contact[q].rb[q] = R(0.2);
    }
    CHECK_NEAR(sp__mean_edge(&pb), 0.1, TOL(1e-14, 1e-6));
}

/* eps, eta; < 0 and 0: 1e-4 of an edge, 100 eps; without eps 1e-2 of an edge. Lengths count in eps, or in eta where that is 0. */
TEST(lengths_are_counted_in_eps_or_where_that_is_0_in_eta)
{
    static const struct { double eps, eta, L, e, h; } is[] = {
        { -1, 0, 2e-4, 1, 100 }, { -1, 1e-2, 2e-4, 1, 50 }, { 1e-3, 0, 1e-3, 1, 100 }, { 1e-3, 5e-3, 1e-3, 1, 5 },
        { 0, 0, 2e-2, 0, 1 }, { 0, 3, 3, 0, 1 }
    };
    static const double four[4][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } }, c[3] = { 1, 1, 1 };
    NEED(begin(c, 1));
    NEED(joint(4, four[0]) && build());
    for (size_t k = 0; k < sizeof is / sizeof *is; k++) {
        set.coupled.eps = R(is[k].eps);
        set.coupled.eta = R(is[k].eta);
        const sp__lengths got = sp__coupled_lengths(&pb, &set);
        CHECK_NEAR(got.L, is[k].L, TOL(1e-14, 1e-6));
        CHECK_NEAR(got.eps, is[k].e, 0);
        CHECK_NEAR(got.eta, is[k].h, TOL(1e-14, 1e-6));
    }
}

/* Points at random on a line through p along d, in two joints; the last one may be off it. */
static int on_a_line(double off, double scale)
{
    double p[3], d[3], c[3], x[5][3];
    for (int k = 0; k < 3; k++) {
        p[k] = scale * (double)test_random_real(-1, 1);
        d[k] = scale * (double)test_random_real(0.3, 1);
        c[k] = scale * (double)test_random_real(2, 3);
    }
    for (int v = 0; v < 5; v++)
        for (int k = 0; k < 3; k++) x[v][k] = p[k] + (v - 1.5) * d[k] + (v == 4 && k == 0 ? off * scale : 0);
    return begin(c, 1) && joint(2, x[0]) && joint(3, x[2]) && build();
}

TEST(the_spin_about_a_line_of_contacts_moves_none_of_them_and_is_one)
{
    for (int round = 0; round < 40; round++) {
        const sp_arena mark = test_arena;
        const double scale = round % 2 ? 1 : 0.01;
        sp_real k[6], w[3];
        NEED(on_a_line(0, scale));
        if (!sp__certifier_free_spin(&j, 0, k)) {       /* float: points rounded off the line */
            CHECK(TOL(0, 1));
            test_arena = mark;
            continue;
        }
        double size = 0, turn = 0;
        for (int q = 0; q < 6; q++) {
            size += (double)(k[q] * k[q]);
            j.dual.motion[q] = k[q] * (q < 3 ? j.scale[0].wf : j.scale[0].wm);
            if (q > 2) turn += (double)(j.dual.motion[q] * j.dual.motion[q]);
        }
        CHECK_NEAR(size, 1, TOL(1e-13, 1e-5));
        CHECK(turn > 0);
        for (int32_t c = 0; c < pb.contacts; c++)
            for (int32_t v = pb.contact[c].point; v < pb.contact[c].point + pb.contact[c].points; v++) {
                sp__certifier_rate_at(&j, &pb.contact[c], v, w);
                CHECK(sqrt((double)sp__dot3(w, w)) < TOL(1e-13, 1e-5) * sqrt(turn) * scale * 10);
            }
        test_arena = mark;
    }
}

TEST(a_point_off_the_line_one_point_alone_or_a_held_turn_leave_no_spin)
{
    static const double x[2][3] = { { 1, 0, 0 }, { 1, 0, 0 } }, c[3] = { 0, 0, 1 };
    sp_real k[6];
    for (int round = 0; round < 10; round++) {
        const sp_arena mark = test_arena;
        NEED(on_a_line(0.01, round % 2 ? 1 : 1000));
        CHECK_INT(sp__certifier_free_spin(&j, 0, k), 0);
        test_arena = mark;
    }
    NEED(begin(c, 1));
    NEED(joint(1, x[0]) && joint(1, x[1]) && build());
    CHECK_INT(sp__certifier_free_spin(&j, 0, k), 0);
    for (int held = 0; held < 6; held++) {              /* about a line along x through the centroid only that turn is asked */
        static const double along[2][3] = { { 1, 0, 1 }, { -1, 0, 1 } };
        const sp_arena mark = test_arena;
        NEED(begin(c, 1));
        NEED(joint(2, along[0]) && build());
        NEED(CHECK_INT(sp__certifier_free_spin(&j, 0, k), 1));
        if (held > 2) j.scale[0].wm = 10;               /* however little of it is a turn */
        scene.block[1].fixed = 1u << held;
        CHECK_INT(sp__certifier_free_spin(&j, 0, k), held != 3);
        scene.block[1].fixed = 0;
        test_arena = mark;
    }
}

/* 64 units of rounding of an arm of 8 are on the line, some more are not; the first points may be any. */
TEST(a_point_is_on_the_line_to_the_last_digits)
{
    static const double x[3][3] = { { 0, 0, 0 }, { 4, 0, 0 }, { 2, 0, 0 } }, c[3] = { 0, 0, 0 };
    sp_real k[6];
    for (int beyond = 0; beyond < 2; beyond++) {
        const sp_arena mark = test_arena;
        NEED(begin(c, 1));
        NEED(joint(3, x[0]) && build());
        j.scale[0].arm = 8;
        scene.point[2][1] = 64 * (sp_real)SP_EPSILON * 8 * (beyond ? 1 + 8 * (sp_real)SP_EPSILON : 1);
        CHECK_INT(sp__certifier_free_spin(&j, 0, k), !beyond);
        test_arena = mark;
    }
}

/* What is left has none of the spin in weighted rows, and what went is the spin alone, however fast it was. */
TEST(a_motion_without_its_spin_is_across_it_and_else_as_it_was)
{
    for (int round = 0; round < 40; round++) {
        const sp_arena mark = test_arena;
        const double fast = round % 2 ? 1 : TOL(1e9, 1e3);
        sp_real k[6], dq[6], was[6];
        NEED(on_a_line(0, 1));
        if (!sp__certifier_free_spin(&j, 0, k)) { CHECK(TOL(0, 1)); test_arena = mark; continue; }
        double W[6], along = 0, gone = 0, left = 0, size = 0;
        for (int q = 0; q < 6; q++) {
            W[q] = (double)(q < 3 ? j.scale[0].wf : j.scale[0].wm);
            dq[q] = was[q] = test_random_real(-1, 1) + R(fast * (double)k[q] * W[q]);
        }
        sp__certifier_remove_spin(&j, 0, dq);
        for (int q = 0; q < 6; q++) {
            along += (double)k[q] * (double)dq[q] / W[q];
            gone += (double)k[q] * ((double)was[q] - (double)dq[q]) / W[q];
            size += fabs((double)dq[q] / W[q]);
        }
        CHECK(fabs(along) <= TOL(1e-14, 1e-5) * size);
        for (int q = 0; q < 6; q++) left += fabs(((double)was[q] - (double)dq[q]) / W[q] - gone * (double)k[q]);
        CHECK(left <= TOL(1e-14, 1e-5) * (fabs(gone) + 1) * 20);
        CHECK(fabs(gone) > 0.1 * fast || round % 2);
        test_arena = mark;
    }
}

/* Two blocks on a line of points each, one rises, the other spins about its line: the spin is not judged up to
 * SP_EXACT_POINTS points, and is beyond. */
TEST(a_spin_is_not_judged_where_there_are_proofs)
{
    const sp_strength rough = sp_strength_friction(R(0.5));
    const sp_real ground[3] = { 0, 0, -9 }, n[3] = { 0, 0, 1 };
    static const double rises[12] = { 0, 0, 0.5, 0, 0, 0,  0, -1, 0, 1, 0, 0 };
    for (int32_t points = SP_EXACT_POINTS; points <= SP_EXACT_POINTS + 1; points++) {
        const sp_capacity room = { 3, 0, 0, 0, 2, SP_EXACT_POINTS + 1, 0 };
        const sp_arena mark = test_arena;
        const int few = points == SP_EXACT_POINTS;
        sp_real x[3 * (SP_EXACT_POINTS + 1)], none[3 * (SP_EXACT_POINTS + 1)], dq[12];
        memset(none, 0, sizeof none);
        memset(&set, 0, sizeof set);
        set.tol = R(TOL(1e-9, 1e-4f));
        set.force_bound = 100;
        set.coupled.eps = set.coupled.eta = 1;
        NEED(CHECK_INT(sp_scene_create(&scene, &room, &test_arena), SP_OK));
        NEED(CHECK_INT(sp_scene_body(&scene, 0, ground, SP_FIXED, NULL), SP_OK));
        for (int32_t b = 1, rest = points; b < 3; b++) {
            const sp_real at[3] = { 1, R(5 * b), 1 };
            const int32_t here = b < 2 ? SP_EXACT_POINTS / 2 : rest;
            for (int32_t v = 0; v < here; v++) { x[3 * v] = R(0.25 * v); x[3 * v + 1] = R(5 * b); x[3 * v + 2] = 0; }
            NEED(CHECK_INT(sp_scene_body(&scene, 1, at, 0, NULL), SP_OK));
            NEED(CHECK_INT(sp_scene_points(&scene, 0, b, n, here, x, &rough, NULL), SP_OK));
            rest -= here;
        }
        NEED(build());
        for (int q = 0; q < 12; q++) dq[q] = R(rises[q]);
        const sp__lengths k = sp__coupled_lengths(&pb, &set);
        CHECK_NEAR(sp__certify_coupled(&j, &k, none, dq, none), 0, 0);
        for (int q = 0; q < 12; q++) CHECK_WITHIN(j.dual.motion[q], q < 6 || !few ? rises[q] : 0, TOL(1e-14, 1e-6));
        test_arena = mark;
    }
}

/* One point of a block at rest: friction of less than tol s need not slip. As it slides: a force beyond the cone is judged by what
 * of it is within, which slip and factor give. */
TEST(friction_is_judged_above_tol_and_within_the_cone)
{
    static const double x[3] = { 0, 0, 0 }, c[3] = { 0, 0, 0 };
    const sp_real rest[6] = { 0, 0, 0, 0, 0, 0 }, slides[6] = { R(0.15), R(-0.2), 0, 0, 0, 0 };
    NEED(begin(c, 1));
    NEED(joint(1, x) && build());
    set.coupled.eps = 0;
    set.coupled.eta = 1;
    j.scale[0].s = 7;
    const sp__lengths k = sp__coupled_lengths(&pb, &set);
    for (int more = 0; more < 2; more++) {
        const sp_real f[3] = { j.unit, j.unit * set.tol * R(more ? 7.1 : 6.9), 0 }, alpha[1] = { 0 };
        CHECK((sp__certify_coupled(&j, &k, f, rest, alpha) > 1) == more);
    }
    sp_real d[3];
    memcpy(j.dual.motion, slides, sizeof slides);
    sp__certifier_rate_at(&j, pb.contact, pb.contact[0].point, d);
    const sp_real f[3] = { j.unit, -4 * d[1] * j.unit, -4 * d[2] * j.unit }, alpha[1] = { 2 * j.unit };    /* |ft| = 1, in the cone 1/2 */
    CHECK(sp__certify_coupled(&j, &k, f, slides, alpha) < R(0.1));
}

#endif

TEST_LIST(spin)
#if SP__WITH_COUPLED
    RUN(the_mean_edge_is_that_of_polygons_all_around_and_of_lines_once)
    RUN(without_edges_the_length_is_the_mean_arm_of_joints)
    RUN(lengths_of_small_scenes_are_small)
    RUN(lengths_are_counted_in_eps_or_where_that_is_0_in_eta)
    RUN(the_spin_about_a_line_of_contacts_moves_none_of_them_and_is_one)
    RUN(a_point_off_the_line_one_point_alone_or_a_held_turn_leave_no_spin)
    RUN(a_point_is_on_the_line_to_the_last_digits)
    RUN(a_motion_without_its_spin_is_across_it_and_else_as_it_was)
    RUN(a_spin_is_not_judged_where_there_are_proofs)
    RUN(friction_is_judged_above_tol_and_within_the_cone)
#endif
TEST_END
