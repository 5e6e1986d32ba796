/* The motion behind a proof by even friction against its definition: what joints of a tree do in it, what its power with M a is. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/shear.c"

#if SP__WITH_STRONG

#include <math.h>

enum { BLOCKS = 5, CORNERS = 3, ROWS = 6 * BLOCKS };
enum { TREE, LOOP, RING, LOOSE };

static sp_scene scene;
static sp_problem pb;
static sp_settings set;
static sp__certifier j;
static sp__inertia M[BLOCKS];
static sp__shear *w;

/* A joint of three corners in any plane, named from either side. */
static int joint(int32_t a, int32_t b)
{
    const sp_strength rough = sp_strength_friction(R(0.7));
    sp_real n[3], t[3], s[3], o[3], x[9];
    for (int k = 0; k < 3; k++) { n[k] = test_random_real(-1, 1); t[k] = test_random_real(-1, 1); o[k] = test_random_real(-2, 2); }
    sp__cross3(n, t, s);
    sp__cross3(s, n, t);
    for (int q = 0; q < CORNERS; q++)
        for (int k = 0; k < 3; k++) x[3 * q + k] = o[k] + (q == 1) * t[k] + (q == 2) * s[k];
    const int turned = test_random_int(0, 1);
    return CHECK_INT(sp_scene_points(&scene, turned ? b : a, turned ? a : b, n, CORNERS, x, &rough, NULL), SP_OK);
}

/* Blocks hung on a support or on each other at random, in any order of joints; LOOP: one joint more; RING: on each other
 * alone; LOOSE: the last one on nothing. */
static int begin(int kind)
{
    const sp_capacity cap = { BLOCKS + 1, 0, 0, 0, BLOCKS + 1, CORNERS * (BLOCKS + 1), 0 };
    if (!CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK)) return 0;
    for (int32_t b = 0; b <= BLOCKS; b++) {
        const sp_real at[3] = { test_random_real(-2, 2), test_random_real(-2, 2), test_random_real(-2, 2) };
        if (!CHECK_INT(sp_scene_body(&scene, b ? R(1) : 0, at, b ? 0 : SP_FIXED, NULL), SP_OK)) return 0;
    }
    for (int32_t b = BLOCKS - (kind == LOOSE); b > 0; b--)
        if (!joint(b, kind != RING ? test_random_int(0, b - 1) : b > 1 ? b - 1 : BLOCKS)) return 0;
    if (kind == LOOP && !joint(0, BLOCKS)) return 0;
    memset(M, 0, sizeof M);
    for (int i = 0; i < BLOCKS; i++) {
        M[i].mass = test_random_real(1, 2);
        M[i].known = 1;
        for (int k = 0; k < 3; k++) M[i].J[k][k] = test_random_real(20, 30);
    }
    set.tol = R(0.01);
    set.force_bound = 100;
    if (!CHECK_INT(sp_problem_build(&scene, &test_arena, &pb), SP_OK)) return 0;
    if (!CHECK(sp__certifier_open(&j, &pb, &set, NULL, INT32_MAX, &test_arena))) return 0;
    w = sp__take(&test_arena, 1, sizeof *w);
    if (!CHECK(w)) return 0;
    sp__shear_carve(w, pb.points, pb.contacts, BLOCKS, &test_arena);
    if (!CHECK(!sp__failed(&test_arena))) return 0;
    w->j = &j;
    w->M = M;
    memset(w->u, 0, (size_t)(ROWS * ROWS) * sizeof *w->u);
    return 1;
}

/* A g of every joint, along it. */
static void draw(double most)
{
    for (int32_t c = 0; c < pb.contacts; c++) {
        const sp_real g[3] = { 0, test_random_real(-most, most), test_random_real(-most, most) };
        sp__joint_force(pb.contact[c].joint, g, w->pair[c].g);
    }
}

/* a, and u = Y a */
static void move(sp_real a[ROWS], sp_real u[ROWS])
{
    for (int r = 0; r < ROWS; r++) a[r] = test_random_real(-1, 1);
    for (int r = 0; r < ROWS; r++) {
        u[r] = 0;
        for (int e = 0; e < ROWS; e++) u[r] += w->u[r * ROWS + e] * a[e];
    }
}

TEST(in_the_sheared_motion_joints_slip_alike_and_open_by_less_what_friction_takes_up)
{
    for (int round = 0; round < 40; round++) {
        const sp_arena mark = test_arena;
        sp_real a[ROWS], u[ROWS], d[3], e[3];
        NEED(begin(TREE));
        draw(0.4);
        NEED(CHECK(sp__shear_tree(w)));
        move(a, u);
        for (int32_t c = 0; c < pb.contacts; c++)
            for (int32_t v = pb.contact[c].point; v < pb.contact[c].point + CORNERS; v++) {
                sp_real g[3];
                sp__vertex_velocity(&pb, NULL, &pb.contact[c], v, a, d);
                sp__vertex_velocity(&pb, NULL, &pb.contact[c], v, u, e);
                const double rub = (double)sp__dot3(w->pair[c].g, d);
                sp__joint_frame(pb.contact[c].joint, d, d);
                sp__joint_frame(pb.contact[c].joint, e, e);
                sp__joint_frame(pb.contact[c].joint, w->pair[c].g, g);
                CHECK_WITHIN(g[0], 0, TOL(1e-12, 1e-5));
                CHECK_WITHIN((double)e[0] - ((double)d[0] - rub), 0, TOL(1e-11, 1e-3));
                for (int k = 1; k < 3; k++) CHECK_WITHIN((double)e[k] - (double)d[k], 0, TOL(1e-11, 1e-3));
            }
        test_arena = mark;
    }
}

TEST(around_a_loop_there_is_no_sheared_motion)
{
    for (int round = 0; round < 10; round++) {
        const sp_arena mark = test_arena;
        sp_real f[3 * CORNERS * (BLOCKS + 1)];
        memset(f, 0, sizeof f);
        NEED(begin(LOOP));
        CHECK(!sp__shear_open(&pb) || !sp__shear_pairs(w, f));      /* or a pair twice, in two planes */
        test_arena = mark;
    }
}

TEST(a_block_that_hangs_on_nothing_is_in_no_tree)
{
    NEED(begin(LOOSE));
    draw(0.4);
    CHECK_INT(sp__shear_tree(w), 0);
}

/* What stands beside u stays as it was. */
TEST(the_motion_of_a_tree_is_written_where_it_belongs)
{
    NEED(begin(TREE));
    draw(0.4);
    for (int k = 0; k < ROWS * (ROWS + 1) / 2; k++) w->form[k] = 7;
    NEED(CHECK(sp__shear_tree(w)));
    for (int k = 0; k < ROWS * (ROWS + 1) / 2; k++) CHECK(w->form[k] == 7);
    for (int k = 0; k < BLOCKS; k++) CHECK(w->reached[k]);
}

/* Whatever a factor says is positive is so for motions drawn at random; with much friction it says no. */
TEST(the_power_of_the_sheared_motion_with_m_a_is_what_the_factor_says)
{
    int yes = 0, no = 0;
    for (int round = 0; round < 60; round++) {
        const sp_arena mark = test_arena;
        NEED(begin(TREE));
        draw(round % 3 == 0 ? 0.02 : round % 3 == 1 ? 0.1 : 2);
        NEED(CHECK(sp__shear_tree(w)));
        const int positive = sp__shear_positive(w);
        double least = 1e30;
        for (int k = 0; k < 200; k++) {
            sp_real a[ROWS], u[ROWS];
            double power = 0, energy = 0;
            move(a, u);
            for (int r = 0; r < ROWS; r++) {
                const double m = (double)(r % 6 < 3 ? M[r / 6].mass : M[r / 6].J[r % 6 - 3][r % 6 - 3]);
                power += m * (double)u[r] * (double)a[r];
                energy += m * (double)a[r] * (double)a[r];
            }
            if (power / energy < least) least = power / energy;
        }
        if (positive) CHECK(least >= 0.01);
        yes += positive;
        no += !positive;
        test_arena = mark;
    }
    CHECK(yes > 5 && no > 5);
}

/* Corners beside the plane of their joint; more friction than there is. */
TEST(even_friction_is_in_the_plane_of_its_joint_and_within_mu)
{
    sp_real f[3 * CORNERS * BLOCKS];
    for (int what = 0; what < 3; what++) {
        const sp_arena mark = test_arena;
        NEED(begin(TREE));
        for (int v = 0; v < CORNERS * BLOCKS; v++) { f[3 * v] = 1; f[3 * v + 1] = R(what == 2 ? 0.71 : 0.69); f[3 * v + 2] = 0; }
        if (what == 1) scene.point[4][0] += R(0.1), scene.point[4][1] += R(0.1), scene.point[4][2] += R(0.1);
        CHECK_INT(sp__shear_pairs(w, f), what != 1);
        sp__certifier_load_rows(&j);
        if (what != 1) for (int32_t c = 0; c < pb.contacts; c++) CHECK_INT(sp__shear_joint(w, &j, c, f), what != 2);
        test_arena = mark;
    }
}

/* A held direction is at rest where no free block moves it: nothing leans, or all of a block that hangs on a support is held. */
TEST(friction_moves_what_is_held_with_what_is_free)
{
    for (int round = 0; round < 20; round++) {
        const sp_arena mark = test_arena;
        const int32_t b = test_random_int(1, BLOCKS), k = test_random_int(0, 5);
        NEED(begin(TREE));
        for (int leans = 0; leans < 2; leans++) {
            for (int r = 0; r < ROWS * ROWS; r++) w->u[r] = 0;
            draw(leans ? 0.4 : 0);
            NEED(CHECK(sp__shear_tree(w)));
            CHECK(sp__shear_held(w));
            scene.block[b].fixed = 1u << k;
            CHECK_INT(sp__shear_held(w), !leans);
            scene.block[b].fixed = 0;
            scene.block[1].fixed = SP_FIXED;
            CHECK(sp__shear_held(w));
            scene.block[1].fixed = 0;
        }
        test_arena = mark;
    }
}

/* The work of live loads where they act: on u another than on a where a joint leans, but in directions that are held. */
TEST(live_loads_do_other_work_on_the_sheared_motion_where_a_joint_leans)
{
    for (int round = 0; round < 20; round++) {
        const sp_arena mark = test_arena;
        sp_real live[ROWS];
        NEED(begin(TREE));
        for (int leans = 0; leans < 2; leans++) {
            for (int r = 0; r < ROWS * ROWS; r++) w->u[r] = 0;
            draw(leans ? 0.4 : 0);
            NEED(CHECK(sp__shear_tree(w)));
            for (int r = 0; r < ROWS; r++) live[r] = r < 6 ? test_random_real(-1, 1) : 0;
            CHECK_INT(sp__shear_pushes(w, live), !leans);
            scene.block[1].fixed = SP_FIXED;
            CHECK(sp__shear_pushes(w, live));
            scene.block[1].fixed = 0;
        }
        test_arena = mark;
    }
}

/* All corners pressed alike, `leans`: friction of .2 along one side. */
TEST(a_sheared_motion_is_made_of_a_tree_at_rest_where_held_that_loads_push_as_much)
{
    static const struct { int kind, leans, held, loaded, made; } is[] = {
        { TREE, 1, 0, 0, 1 }, { RING, 0, 0, 0, 0 }, { TREE, 1, 1, 0, 0 }, { TREE, 0, 1, 0, 1 }, { TREE, 1, 0, 1, 0 },
        { TREE, 0, 0, 1, 1 }
    };
    for (size_t k = 0; k < sizeof is / sizeof *is; k++) {
        const sp_arena mark = test_arena;
        sp_real f[3 * CORNERS * BLOCKS], live[ROWS];
        NEED(begin(is[k].kind));
        for (int v = 0; v < CORNERS * BLOCKS; v++) { f[3 * v] = 1; f[3 * v + 1] = R(0.2 * is[k].leans); f[3 * v + 2] = 0; }
        for (int r = 0; r < ROWS; r++) live[r] = test_random_real(-1, 1);
        if (is[k].held) scene.block[BLOCKS].fixed = 1;
        CHECK_INT(sp__shear_make(&j, f, is[k].loaded ? live : NULL, &test_arena) != NULL, is[k].made);
        test_arena = mark;
    }
}

/* A chain of n blocks from a support on: contacts alone. */
static int open_chain(int32_t n)
{
    static sp_contact link[SP__SHEAR_BLOCKS + 1];
    sp_problem chain;
    memset(&chain, 0, sizeof chain);
    for (int32_t k = 0; k < n; k++) { link[k].a = k - 1; link[k].b = k; }
    chain.contact = link;
    chain.contacts = chain.blocks = n;
    return sp__shear_open(&chain);
}

TEST(even_friction_is_asked_of_1_to_32_blocks_that_have_a_joint_each)
{
    CHECK(sp__shear_need(3, 1, 1) > 0 && sp__shear_need(96, 32, 32) > 0);
    CHECK_INT((int)sp__shear_need(99, 33, 33), 0);
    CHECK_INT((int)sp__shear_need(3, 1, 2), 0);
    CHECK_INT((int)sp__shear_need(0, 0, 0), 0);
    CHECK_INT((int)sp__shear_need(3, 1, 0), 0);
    CHECK(open_chain(1) && open_chain(32));
    CHECK(!open_chain(0) && !open_chain(33));
}

/* u, its power's lower triangle, slack; f'; blocks reached; pairs; the struct. Each begins at a multiple of 16 at most. */
TEST(even_friction_takes_a_matrix_and_a_half_of_six_rows_a_block)
{
    for (int32_t blocks = 1; blocks <= 5; blocks++) {
        const int32_t joints = blocks + 2, points = 4 * joints;
        const size_t n = 6 * (size_t)blocks, reals = n * n + n * (n + 1) / 2 + n + 3 * (size_t)points;
        const size_t least = sizeof *w + reals * sizeof(sp_real) + (size_t)blocks * sizeof(int32_t)
                             + (size_t)joints * sizeof(sp__shear_pair);
        const size_t need = sp__shear_need(points, joints, blocks);
#ifdef FENCED
        const size_t most = least + 7 * (16 + FENCE_WIDTH);
#else
        const size_t most = least + 7 * 16;
#endif
        CHECK(need >= least && need < most);
    }
}

TEST(joints_of_two_blocks_are_one_pair_from_whichever_side_they_are_named)
{
    static const int32_t is[][4] = { { 0, 1, 0, 1 }, { 1, 0, 0, 0 }, { 0, 2, 2, 1 }, { 2, 1, 3, 1 }, { 0, 2, 2, 1 }, { 1, 2, 3, 0 },
                                     { 3, 1, 6, 1 } };     /* a, b; first of the pair, named alike */
    sp_contact t[7];
    sp_problem few;
    memset(t, 0, sizeof t);
    memset(&few, 0, sizeof few);
    few.contact = t;
    few.contacts = 7;
    for (int k = 0; k < 7; k++) { t[k].a = is[k][0]; t[k].b = is[k][1]; }
    for (int k = 0; k < 7; k++) {
        int same;
        CHECK_INT(sp__shear_lead(&few, k, &same), is[k][2]);
        CHECK_INT(same, is[k][3]);
    }
}

/* A block on two joints of a support in the plane x = 0, the second named from the block's side. */
static int on_two(void)
{
    const sp_capacity cap = { 2, 0, 0, 0, 2, 2 * CORNERS, 0 };
    const sp_strength rough = sp_strength_friction(R(0.7));
    const sp_real n[2][3] = { { 1, 0, 0 }, { -1, 0, 0 } }, at[3] = { 2, 0, 0 };
    const sp_real x[2][9] = { { 0, 0, 0, 0, 1, 0, 0, 0, 1 }, { 0, 3, 0, 0, 4, 0, 0, 3, 1 } };
    if (!CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK)) return 0;
    for (int b = 0; b < 2; b++) if (!CHECK_INT(sp_scene_body(&scene, (sp_real)b, at, b ? 0 : SP_FIXED, NULL), SP_OK)) return 0;
    for (int k = 0; k < 2; k++)
        if (!CHECK_INT(sp_scene_points(&scene, k, 1 - k, n[k], CORNERS, x[k], &rough, NULL), SP_OK)) return 0;
    set.tol = R(0.01);
    set.force_bound = 100;
    if (!CHECK_INT(sp_problem_build(&scene, &test_arena, &pb), SP_OK)) return 0;
    if (!CHECK(sp__certifier_open(&j, &pb, &set, NULL, INT32_MAX, &test_arena))) return 0;
    w = sp__take(&test_arena, 1, sizeof *w);
    if (!CHECK(w)) return 0;
    sp__shear_carve(w, pb.points, pb.contacts, pb.blocks, &test_arena);
    w->j = &j;
    return CHECK(!sp__failed(&test_arena));
}

/* g = ft / fn of all corners of the pair, as forces on the block; a corner that pulls presses by nothing. */
TEST(friction_of_two_joints_of_a_pair_adds_up_as_forces_do)
{
    for (int round = 0; round < 20; round++) {
        const sp_arena mark = test_arena;
        sp_real f[6 * CORNERS], sum[3] = { 0, 0, 0 }, pressure = 0;
        const double size = round % 3 ? 1 : 1e-3;       /* g has none */
        NEED(on_two());
        for (int v = 0; v < 2 * CORNERS; v++) {
            sp_real F[3];
            f[3 * v] = test_random_real(-0.2 * size, 2 * size);
            for (int k = 1; k < 3; k++) f[3 * v + k] = test_random_real(-0.3 * size, 0.3 * size);
            sp__joint_force(pb.contact[v / CORNERS].joint, f + 3 * v, F);
            for (int k = 1; k < 3; k++) sum[k] += v < CORNERS ? F[k] : -F[k];
            pressure += f[3 * v] > 0 ? f[3 * v] : 0;
        }
        NEED(CHECK(sp__shear_pairs(w, f)));
        for (int k = 0; k < 3; k++) CHECK_WITHIN((double)w->pair[0].g[k], (double)(sum[k] / pressure), TOL(1e-12, 1e-5));
        sp__certifier_load_rows(&j);
        for (int32_t c = 0; c < 2; c++) NEED(CHECK(sp__shear_joint(w, &j, c, f)));
        for (int v = 0; v < 2 * CORNERS; v++) {
            sp_real F[3];
            sp__joint_force(pb.contact[v / CORNERS].joint, w->even + 3 * v, F);
            const double fn = f[3 * v] > 0 ? (double)f[3 * v] : 0;
            CHECK_WITHIN((double)w->even[3 * v], fn, TOL(1e-12, 1e-5));
            for (int k = 1; k < 3; k++)
                CHECK_WITHIN((double)(v < CORNERS ? F[k] : -F[k]), fn * (double)w->pair[0].g[k], TOL(1e-12, 1e-5));
        }
        test_arena = mark;
    }
}

TEST(where_nothing_presses_there_is_no_friction)
{
    sp_real f[6 * CORNERS];
    memset(f, 0, sizeof f);
    NEED(on_two());
    for (int v = 0; v < 2 * CORNERS; v++) { f[3 * v] = R(v < CORNERS ? -0.5 : 0); f[3 * v + 2] = 1; }
    NEED(CHECK(sp__shear_pairs(w, f)));
    for (int k = 0; k < 3; k++) CHECK(w->pair[0].g[k] == 0);
}

/* 1e-9 of an arm of 8 m, in float 1e-4, counts, a few units in the last place more do not; nor turned by so much. */
TEST(joints_of_a_pair_are_in_one_plane_to_the_last_digits)
{
    for (int beyond = 0; beyond < 2; beyond++) {
        const sp_arena mark = test_arena;
        NEED(on_two());
        const sp_real flat = R(TOL(1e-9, 1e-4));
        j.scale[0].arm = 8;
        CHECK(sp__shear_flat(w, 1, 0, -1) && !sp__shear_flat(w, 1, 0, 1));
        scene.point[4][0] = 8 * flat * (beyond ? 1 + 8 * SP_EPSILON : 1);
        CHECK_INT(sp__shear_flat(w, 1, 0, -1), !beyond);
        scene.point[4][0] = 0;
        scene.joint[1].n[1] = flat * (beyond ? 1 + 8 * SP_EPSILON : 1);
        CHECK_INT(sp__shear_flat(w, 1, 0, -1), !beyond);
        test_arena = mark;
    }
}

/* |g| at what mu allows times the caller's factor, less 16 units of rounding, is allowed, a few units more are not. */
TEST(even_friction_is_within_mu_times_its_factor_to_the_last_digits)
{
    const sp_real f[6 * CORNERS] = { 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0 };
    NEED(on_two());
    NEED(CHECK(sp__shear_pairs(w, f)));
    sp__certifier_load_rows(&j);
    j.mu_factor = R(0.5);
    const sp_real most = pb.contact[0].joint->strength.mu * j.mu_factor * (1 - 16 * SP_EPSILON);
    for (int32_t c = 0; c < 2; c++)
        for (int beyond = 0; beyond < 2; beyond++) {
            w->pair[0].g[2] = beyond ? most * (1 + 8 * SP_EPSILON) : most;
            CHECK_INT(sp__shear_joint(w, &j, c, f), !beyond);
        }
}

TEST(friction_of_a_pair_is_in_the_plane_of_its_first_joint)
{
    sp_real f[6 * CORNERS];
    NEED(on_two());
    for (int k = 0; k < 2; k++) scene.joint[k].t1[0] = R(0.1);
    for (int v = 0; v < 2 * CORNERS; v++) { f[3 * v] = 1; f[3 * v + 1] = R(v < CORNERS ? 0.3 : 0.2); f[3 * v + 2] = 0; }
    NEED(CHECK(sp__shear_pairs(w, f)));
    CHECK_WITHIN((double)sp__dot3(w->pair[0].g, pb.contact[0].joint->n), 0, TOL(1e-15, 1e-7));
    CHECK(sp__norm3(w->pair[0].g) > 0);
}

/* One block, its centroid in the joint, J = j 1: the symmetric part of n g' has the least eigenvalue -|g| / 2, of v and of w, so
 * u'Ma >= (1 - |g| / 2) a'Ma: .01 of it from |g| = 1.98 on. */
TEST(the_power_of_a_sheared_block_is_one_less_half_of_what_friction_leans)
{
    const sp_real inertia[3] = { R(0.01), 1, 300 };
    for (int round = 0; round < 6; round++) {
        const sp_arena mark = test_arena;
        const double angle = test_random_real(0, 6), leans = 1.98 + TOL(1e-6, 0.01) * (round % 2 ? 1 : -1);
        sp__inertia one;
        memset(&one, 0, sizeof one);
        one.mass = round < 4 ? 1 : 7;
        for (int k = 0; k < 3; k++) one.J[k][k] = inertia[round / 2];
        NEED(on_two());
        memset(scene.block[1].centroid, 0, sizeof scene.block[1].centroid);
        memset(w->u, 0, 36 * sizeof *w->u);
        w->M = &one;
        w->pair[0].g[0] = 0;
        w->pair[0].g[1] = R(leans * cos(angle));
        w->pair[0].g[2] = R(leans * sin(angle));
        NEED(CHECK(sp__shear_tree(w)));
        CHECK_INT(sp__shear_positive(w), round % 2 == 0);
        test_arena = mark;
    }
}

/* u = a but for one number on the diagonal: what it has beyond .01 is more than rounding from 1e-9 on, in float 1e-3. */
TEST(a_power_within_rounding_of_a_hundredth_of_the_energy_is_none)
{
    NEED(begin(TREE));
    for (int r = 0; r < ROWS; r++)
        for (int beyond = 0; beyond < 2; beyond++) {
            for (int k = 0; k < ROWS * ROWS; k++) w->u[k] = k % (ROWS + 1) == 0;
            w->u[r * (ROWS + 1)] = R(0.01 + TOL(1e-9, 1e-3) * (beyond ? 1.01 : 0.99));
            CHECK_INT(sp__shear_positive(w), beyond);
        }
}

/* As of bodies turned against their axes. */
TEST(moments_of_inertia_may_have_products)
{
    for (int round = 0; round < 40; round++) {
        const sp_arena mark = test_arena;
        NEED(begin(TREE));
        for (int i = 0; i < BLOCKS; i++)
            for (int k = 0; k < 3; k++) {
                M[i].J[k][k] = test_random_real(2, 3);
                M[i].J[k][(k + 1) % 3] = M[i].J[(k + 1) % 3][k] = test_random_real(-0.9, 0.9);
            }
        draw(0);
        NEED(CHECK(sp__shear_tree(w)));
        CHECK(sp__shear_positive(w));                   /* u = a */
        M[BLOCKS - 1].J[0][1] = M[BLOCKS - 1].J[1][0] = R(3.1);     /* of no body */
        CHECK(!sp__shear_positive(w));
        test_arena = mark;
    }
}

/* |u|' (|r| + what rounding may hide), block by block over the root of its mass, or of its moments at the least. */
TEST(what_even_friction_leaves_counts_by_the_work_it_may_do)
{
    for (int round = 0; round < 20; round++) {
        const sp_arena mark = test_arena;
        sp_real left[ROWS];
        double all = 0;
        NEED(begin(TREE));
        draw(0.4);
        NEED(CHECK(sp__shear_tree(w)));
        sp__certifier_load_rows(&j);
        for (int i = 0; i < BLOCKS; i++) {
            j.scale[i].load = test_random_real(0, 1);
            j.scale[i].couple = test_random_real(0, 1);
            j.scale[i].arm = test_random_real(1, 2);
            j.pass.sums[2 * i] = test_random_real(0, 1);
            for (int k = 0; k < 3; k++) {
                M[i].inverse[k] = test_random_real(0, 1);
                for (int q = 0; q < 3; q++) M[i].turn[k][q] = test_random_real(-1, 1);
            }
        }
        for (int r = 0; r < ROWS; r++) {
            const sp__scale *s = &j.scale[r / 6];
            const sp_real size = j.pass.sums[2 * (r / 6)] + s->load;
            const sp_real hidden = 64 * SP_EPSILON * (r % 6 < 3 ? size : size * s->arm + s->couple);
            j.residual[r] = round % 3 == 2 ? hidden * test_random_real(-1, 1) : round % 3 ? test_random_real(-1, 1) : 0;
            left[r] = j.unit * (sp__abs(j.residual[r]) + 64 * SP_EPSILON * (r % 6 < 3 ? size : size * s->arm + s->couple));
        }
        for (int i = 0; i < BLOCKS; i++) {
            double e[6], turn = 0;
            for (int k = 0; k < 6; k++) {
                e[k] = 0;
                for (int r = 0; r < ROWS; r++) e[k] += fabs((double)w->u[r * ROWS + 6 * i + k]) * (double)left[r];
            }
            for (int k = 0; k < 3; k++) {
                all += e[k] * e[k] * (double)M[i].inverse[k];
                turn += sqrt((double)sp__dot3(M[i].turn[k], M[i].turn[k]));
            }
            all += turn * (e[3] * e[3] + e[4] * e[4] + e[5] * e[5]);
        }
        CHECK_WITHIN((double)sp__shear_slack(w) / sqrt(all), 1, TOL(1e-12, 1e-5));
        test_arena = mark;
    }
}

/* [M u]_re of row r and column e, M of the block of r. */
static double momentum(int r, int e)
{
    const sp__inertia *m = &M[r / 6];
    double sum = r % 6 < 3 ? (double)m->mass * (double)w->u[r * ROWS + e] : 0;
    for (int k = 0; k < 3 && r % 6 >= 3; k++) sum += (double)m->J[r % 6 - 3][k] * (double)w->u[(r / 6 * 6 + 3 + k) * ROWS + e];
    return sum;
}

/* (M Y + Y'M) / 2 - .01 M, each row and column over the root of its diagonal of M, is what the factor multiplies to, for any Y
 * near 1. */
TEST(what_is_factored_is_the_power_less_a_hundredth_of_the_energy)
{
    for (int round = 0; round < 10; round++) {
        const sp_arena mark = test_arena;
        NEED(begin(TREE));
        for (int i = 0; i < BLOCKS; i++) {
            M[i].mass = test_random_real(1, 2) * R(i + 1);
            for (int k = 0; k < 3; k++) {
                M[i].J[k][k] = test_random_real(2, 3) * R(i + 1);
                M[i].J[k][(k + 1) % 3] = M[i].J[(k + 1) % 3][k] = test_random_real(-0.9, 0.9);
            }
        }
        for (int k = 0; k < ROWS * ROWS; k++) w->u[k] = (k % (ROWS + 1) == 0) + test_random_real(-0.01, 0.01);
        NEED(CHECK(sp__shear_positive(w)));
        for (int r = 0; r < ROWS; r++)
            for (int e = 0; e <= r; e++) {
                double is = 0;                          /* L L' */
                for (int k = 0; k <= e; k++) is += (double)w->form[r * (r + 1) / 2 + k] * (double)w->form[e * (e + 1) / 2 + k];
                const sp__inertia *first = &M[r / 6], *other = &M[e / 6];
                const double a = (double)(r % 6 < 3 ? first->mass : first->J[r % 6 - 3][r % 6 - 3]);
                const double b = (double)(e % 6 < 3 ? other->mass : other->J[e % 6 - 3][e % 6 - 3]);
                double own = 0;
                if (r / 6 == e / 6 && r % 6 >= 3 && e % 6 >= 3) own = (double)first->J[r % 6 - 3][e % 6 - 3];
                if (r == e && r % 6 < 3) own = a;
                CHECK_WITHIN(is, ((momentum(r, e) + momentum(e, r)) / 2 - 0.01 * own) / sqrt(a * b), TOL(1e-12, 1e-5));
            }
        test_arena = mark;
    }
}

/* u = a but for one number, which a held row may have of held columns only. */
TEST(a_held_row_is_at_rest_in_every_free_column)
{
    NEED(begin(TREE));
    for (int r = 0; r < ROWS; r++)
        for (int e = 0; e < ROWS; e++) {
            if (r == e) continue;
            for (int k = 0; k < ROWS * ROWS; k++) w->u[k] = k % (ROWS + 1) == 0;
            w->u[r * ROWS + e] = R(1e-3);
            CHECK(sp__shear_held(w));
            scene.block[1 + r / 6].fixed = 1u << r % 6;
            CHECK_INT(sp__shear_held(w), 0);
            scene.block[1 + e / 6].fixed |= 1u << e % 6;
            CHECK_INT(sp__shear_held(w), 1);
            scene.block[1 + r / 6].fixed = scene.block[1 + e / 6].fixed = 0;
        }
}

/* q'u of column e is q_e to tol of all that is added up, 1 + 1 + 100 + 100; of a held column anything. */
TEST(what_live_loads_do_is_alike_to_tol_of_the_sizes_added_up)
{
    NEED(begin(TREE));
    for (int e = 0; e < ROWS; e++)
        for (int beyond = 0; beyond < 2; beyond++) {
            sp_real live[ROWS];
            const int r = (e + 1) % ROWS, s = (e + 7) % ROWS;
            for (int k = 0; k < ROWS * ROWS; k++) w->u[k] = k % (ROWS + 1) == 0;
            for (int k = 0; k < ROWS; k++) live[k] = 0;
            live[e] = 1;
            live[r] = live[s] = 100;
            w->u[r * ROWS + e] = 1;
            w->u[s * ROWS + e] = R(-1 + (beyond ? 0.021 : 0.020));
            CHECK_INT(sp__shear_pushes(w, live), !beyond);
            scene.block[1 + e / 6].fixed = 1u << e % 6;
            CHECK(sp__shear_pushes(w, live));
            scene.block[1 + e / 6].fixed = 0;
        }
}

/* f' = fn (n + g) at every corner, in the frame of its joint, whatever way that looks. */
TEST(even_forces_are_pressure_times_normal_and_slope)
{
    for (int round = 0; round < 10; round++) {
        const sp_arena mark = test_arena;
        sp_real f[3 * CORNERS * BLOCKS];
        NEED(begin(TREE));
        for (int v = 0; v < CORNERS * BLOCKS; v++) { f[3 * v] = test_random_real(0.1, 1); f[3 * v + 1] = f[3 * v + 2] = 0; }
        NEED(CHECK(sp__shear_pairs(w, f)));
        draw(0.3);
        sp__certifier_load_rows(&j);
        for (int32_t c = 0; c < pb.contacts; c++) {
            NEED(CHECK(sp__shear_joint(w, &j, c, f)));
            for (int v = pb.contact[c].point; v < pb.contact[c].point + CORNERS; v++) {
                sp_real F[3], want[3];
                sp__joint_force(pb.contact[c].joint, w->even + 3 * v, F);
                for (int k = 0; k < 3; k++) want[k] = f[3 * v] * (pb.contact[c].joint->n[k] + w->pair[c].g[k]);
                for (int k = 0; k < 3; k++) CHECK_WITHIN((double)F[k], (double)want[k], TOL(1e-12, 1e-5));
            }
        }
        test_arena = mark;
    }
}

/* As many bytes as it says, and it says once that it has been over the contacts. */
TEST(even_friction_takes_the_memory_it_says_and_one_sweep)
{
    sp_real f[3 * CORNERS * BLOCKS];
    NEED(begin(TREE));
    for (int v = 0; v < CORNERS * BLOCKS; v++) { f[3 * v] = 1; f[3 * v + 1] = f[3 * v + 2] = 0; }
    const size_t need = sp__shear_need(pb.points, pb.contacts, pb.blocks);
    const int32_t before = j.sweeps;
    sp_arena room;
    memset(&room, 0, sizeof room);
    room.base = sp__take(&test_arena, 1, need);
    room.capacity = need;
    NEED(CHECK(room.base));
    CHECK(sp__shear_make(&j, f, NULL, &room) != NULL);
    CHECK_INT((int)room.used, (int)need);
    CHECK_INT(j.sweeps - before, 1);
    room.used = 0;
    room.capacity = need - 1;
    CHECK(sp__shear_make(&j, f, NULL, &room) == NULL);
    room.used = 0;
    CHECK(!(sp__certify_shear(&j, M, f, NULL, &room) > 0));     /* what is not asked proves nothing */
}

/* Where the inertia of a block is unknown nothing is asked: no proof, and no sweep. */
TEST(even_friction_of_a_block_of_unknown_inertia_is_not_asked)
{
    sp_real f[3 * CORNERS * BLOCKS];
    NEED(begin(TREE));
    for (int v = 0; v < CORNERS * BLOCKS; v++) { f[3 * v] = 1; f[3 * v + 1] = f[3 * v + 2] = 0; }
    for (int unknown = 0; unknown < 2; unknown++) {
        const int32_t before = j.sweeps;
        M[BLOCKS - 1].known = !unknown;
        const sp_real margin = sp__certify_shear(&j, M, f, NULL, &test_arena);
        CHECK(!unknown || !(margin > 0));
        CHECK_INT(j.sweeps - before, !unknown);
    }
}

/* A block of mass 1 whose two joints press by 1 a corner and lean by g, loads out of balance by `left`: 1 less the work that may do
 * in sqrt(delta) / 100; nothing where it may do more, or where the power is none. */
TEST(the_margin_is_one_less_the_share_that_is_left)
{
    for (int round = 0; round < 24; round++) {
        const sp_arena mark = test_arena;
        const int leans = round % 3 == 2, most = round % 6 == 1;
        sp_real f[6 * CORNERS], sums[2] = { 0, 0 };
        sp__inertia one;
        memset(&one, 0, sizeof one);
        one.mass = 1;
        one.known = 1;
        NEED(on_two());
        memset(scene.block[1].centroid, 0, sizeof scene.block[1].centroid);
        for (int k = 0; k < 3; k++) { one.J[k][k] = R(0.5); one.inverse[k] = 1; one.turn[k][k] = 2; }
        for (int c = 0; c < 2; c++) scene.joint[c].strength.mu = 3;
        for (int v = 0; v < 2 * CORNERS; v++) {
            const sp_real rub[3] = { 0, 0, R(leans ? 1.99 : 0) };       /* along z, on the block */
            sp_real g[3];
            sp__joint_frame(pb.contact[v / CORNERS].joint, rub, g);
            f[3 * v] = 1;
            for (int k = 1; k < 3; k++) f[3 * v + k] = v < CORNERS ? g[k] : -g[k];
        }
        for (int r = 0; r < 6; r++) pb.p[r] = 0;
        for (int c = 0; c < 2; c++)
            for (int v = pb.contact[c].point; v < pb.contact[c].point + CORNERS; v++) {
                sp_real F[3], row[6] = { 0 };
                sp__joint_force(pb.contact[c].joint, f + 3 * v, F);
                sp__vertex_force(&pb, &pb.contact[c], v, F, row, sums);
                for (int r = 0; r < 6; r++) pb.p[r] -= row[r];
            }
        sp__certifier_open(&j, &pb, &set, NULL, INT32_MAX, &test_arena);
        const double least = 0.01 * sqrt((double)sp__in_newtons(j.unit, sp__still_delta(&j, &one)));
        const double share = leans ? 0 : (double)(most ? test_random_real(1.1, 9) : test_random_real(0.1, 0.9));
        pb.p[1] += R(share * least);
        sp__certifier_open(&j, &pb, &set, NULL, INT32_MAX, &test_arena);
        const double now = 0.01 * sqrt((double)sp__in_newtons(j.unit, sp__still_delta(&j, &one)));
        const sp_real margin = sp__certify_shear(&j, &one, f, NULL, &test_arena);
        if (leans || TOL(0, 1)) CHECK_INT(margin > 0, 0);       /* in float rounding may hide as much */
        else CHECK_WITHIN((double)margin, fmax(0, 1 - share * least / now), TOL(1e-8, 1));
        test_arena = mark;
    }
}

#endif

TEST_LIST(shear)
#if SP__WITH_STRONG
    RUN(in_the_sheared_motion_joints_slip_alike_and_open_by_less_what_friction_takes_up)
    RUN(around_a_loop_there_is_no_sheared_motion)
    RUN(a_block_that_hangs_on_nothing_is_in_no_tree)
    RUN(the_motion_of_a_tree_is_written_where_it_belongs)
    RUN(the_power_of_the_sheared_motion_with_m_a_is_what_the_factor_says)
    RUN(even_friction_is_in_the_plane_of_its_joint_and_within_mu)
    RUN(friction_moves_what_is_held_with_what_is_free)
    RUN(live_loads_do_other_work_on_the_sheared_motion_where_a_joint_leans)
    RUN(a_sheared_motion_is_made_of_a_tree_at_rest_where_held_that_loads_push_as_much)
    RUN(even_friction_is_asked_of_1_to_32_blocks_that_have_a_joint_each)
    RUN(even_friction_takes_a_matrix_and_a_half_of_six_rows_a_block)
    RUN(joints_of_two_blocks_are_one_pair_from_whichever_side_they_are_named)
    RUN(friction_of_two_joints_of_a_pair_adds_up_as_forces_do)
    RUN(where_nothing_presses_there_is_no_friction)
    RUN(joints_of_a_pair_are_in_one_plane_to_the_last_digits)
    RUN(even_friction_is_within_mu_times_its_factor_to_the_last_digits)
    RUN(friction_of_a_pair_is_in_the_plane_of_its_first_joint)
    RUN(the_power_of_a_sheared_block_is_one_less_half_of_what_friction_leans)
    RUN(a_power_within_rounding_of_a_hundredth_of_the_energy_is_none)
    RUN(moments_of_inertia_may_have_products)
    RUN(what_even_friction_leaves_counts_by_the_work_it_may_do)
    RUN(what_is_factored_is_the_power_less_a_hundredth_of_the_energy)
    RUN(a_held_row_is_at_rest_in_every_free_column)
    RUN(what_live_loads_do_is_alike_to_tol_of_the_sizes_added_up)
    RUN(even_forces_are_pressure_times_normal_and_slope)
    RUN(even_friction_takes_the_memory_it_says_and_one_sweep)
    RUN(even_friction_of_a_block_of_unknown_inertia_is_not_asked)
    RUN(the_margin_is_one_less_the_share_that_is_left)
#endif
TEST_END
