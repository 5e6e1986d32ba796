/* What makes no sense in a scene, in its matrices, of a seat, of a laid stone: each number that is none, each count and index
 * beyond what there is, each argument that is missing has its own status, and nothing is touched. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>
#include <string.h>

static const sp_real odd[3] = { R(NAN), R(INFINITY), R(-INFINITY) };
static const sp_arena none = { NULL, 0, 0, 0 };

static const int32_t box_size[6] = { 4, 4, 4, 4, 4, 4 };
static const int32_t box_face[24] = { 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
static const sp_real box_xyz[24] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1 };
static const sp_mesh box = { 8, 6, box_xyz, box_size, box_face };

/* Two cubes with meshes, room for one joint more and for one load. */
static int begin(sp_scene *s)
{
    const sp_capacity cap = { 3, 16, 12, 48, 2, 9, 1 };
    const sp_real foot[12] = { 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1 };
    const sp_strength rough = sp_strength_friction(R(0.5));
    sp_real high[24];
    const sp_mesh up = { 8, 6, high, box_size, box_face };
    for (int k = 0; k < 24; k++) high[k] = box_xyz[k] + (k % 3 == 2);
    return CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK) && CHECK_INT(sp_scene_block(s, &box, 2400, SP_FIXED, NULL), SP_OK) &&
           CHECK_INT(sp_scene_block(s, &up, 2400, 0, NULL), SP_OK) && CHECK_INT(sp_scene_joint(s, 0, 1, 4, foot, &rough, NULL), SP_OK);
}

static int as_before(const sp_scene *s)
{
    return CHECK(s->count.blocks == 2 && s->count.joints == 1 && s->count.points == 4 && s->count.loads == 0);
}

TEST(joints_are_between_blocks_that_exist_and_made_of_numbers)
{
    sp_scene s;
    const sp_strength rough = sp_strength_friction(R(0.5));
    const sp_real up[3] = { 0, 0, 1 };
    NEED(begin(&s));
    static const struct { int32_t a, b; sp_status want; } pair[] = {
        { -1, 1, SP_E_INDEX }, { 0, -1, SP_E_INDEX }, { 2, 1, SP_E_INDEX }, { 0, 2, SP_E_INDEX }, { 1, 1, SP_E_SELF } };
    sp_real x[12] = { 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1 };
    for (int k = 0; k < 5; k++) {
        CHECK_INT(sp_scene_joint(&s, pair[k].a, pair[k].b, 4, x, &rough, NULL), pair[k].want);
        CHECK_INT(sp_scene_points(&s, pair[k].a, pair[k].b, up, 4, x, &rough, NULL), pair[k].want);
    }
    CHECK_INT(sp_scene_joint(NULL, 0, 1, 4, x, &rough, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, NULL, &rough, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, x, NULL, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_joint(&s, 0, 1, -1, x, &rough, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_points(&s, 0, 1, NULL, 1, x, &rough, NULL), SP_E_ARGUMENT);
    for (int k = 0; k < 3; k++) {
        x[11] = odd[k];
        CHECK_INT(sp_scene_joint(&s, 0, 1, 4, x, &rough, NULL), SP_E_NOT_FINITE);
        x[11] = 1;
    }
    as_before(&s);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, x, &rough, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 1, x, &rough, NULL), SP_E_CAPACITY);     /* no joint more, though corners would fit */
}

TEST(loads_are_on_blocks_that_exist_and_made_of_numbers)
{
    sp_scene s;
    NEED(begin(&s));
    for (int place = 0; place < 10; place++)
        for (int k = 0; k < 3; k++) {
            sp_load l;
            memset(&l, 0, sizeof l);
            l.block = 1;
            if (place < 3) l.point[place] = odd[k];
            else if (place < 6) l.force[place - 3] = odd[k];
            else if (place < 9) l.couple[place - 6] = odd[k];
            else l.mass = odd[k];
            CHECK_INT(sp_scene_load(&s, &l, NULL), SP_E_NOT_FINITE);
        }
    sp_load l;
    memset(&l, 0, sizeof l);
    l.block = 2;
    CHECK_INT(sp_scene_load(&s, &l, NULL), SP_E_INDEX);
    l.block = -1;
    CHECK_INT(sp_scene_load(&s, &l, NULL), SP_E_INDEX);
    l.block = 1;
    l.mass = -1;
    CHECK_INT(sp_scene_load(&s, &l, NULL), SP_E_RANGE);
    l.mass = 0;
    CHECK_INT(sp_scene_load(NULL, &l, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_scene_load(&s, NULL, NULL), SP_E_ARGUMENT);
    as_before(&s);
    CHECK_INT(sp_scene_load(&s, &l, NULL), SP_OK);
    CHECK_INT(sp_scene_load(&s, &l, NULL), SP_E_CAPACITY);
}

TEST(pressure_is_on_faces_that_exist)
{
    sp_scene s;
    NEED(begin(&s));
    static const int32_t block[] = { -1, 2, 0, 0, 1, 1 }, face[] = { 0, 0, -1, 6, INT32_MIN, INT32_MAX };
    for (int k = 0; k < 6; k++) CHECK_INT(sp_scene_pressure(&s, block[k], face[k], 1, 0, NULL), SP_E_INDEX);
    CHECK_INT(sp_scene_pressure(NULL, 0, 0, 1, 0, NULL), SP_E_ARGUMENT);
    for (int k = 0; k < 3; k++) CHECK_INT(sp_scene_pressure(&s, 1, 1, odd[k], 0, NULL), SP_E_NOT_FINITE);
    as_before(&s);
    CHECK_INT(sp_scene_pressure(&s, 1, 5, 1000, 0, NULL), SP_OK);
    CHECK_WITHIN(s.load[0].force[0], 1000, TOL(1e-9, 1e-3));        /* x = 0 is pushed inward */
}

/* A face so small that its area underflows, one so large that it overflows: no force comes of either. */
TEST(pressure_on_a_face_whose_area_is_no_number_is_refused)
{
    const double scale[] = { TOL(1e-170, 1e-24), TOL(1e160, 1e20) };
    for (int k = 0; k < 2; k++) {
        sp_scene s;
        NEED(begin(&s));
        for (int32_t v = 8; v < 16; v++)
            for (int q = 0; q < 3; q++) s.vertex[v][q] = R((double)s.vertex[v][q] * scale[k]);
        CHECK_INT(sp_scene_pressure(&s, 1, 5, 1000, 0, NULL), SP_E_AREA);
        as_before(&s);
    }
}

/* A density so small that the mass underflows: a free block of none is no block, a support needs none. */
TEST(a_block_whose_mass_underflows_is_none)
{
    const sp_capacity cap = { 2, 16, 12, 48, 0, 0, 0 };
    sp_real small[24];
    const sp_mesh grain = { 8, 6, small, box_size, box_face };
    const sp_real least = R(TOL(1e-300, 1e-37));
    sp_scene s;
    for (int k = 0; k < 24; k++) small[k] = box_xyz[k] * R(TOL(1e-20, 1e-5));
    NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
    CHECK_INT(sp_scene_block(&s, &grain, least, 0, NULL), SP_E_DEGENERATE);
    CHECK_INT(s.count.blocks, 0);
    CHECK_INT(sp_scene_block(&s, &grain, least, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_block(&s, &grain, 2400, 0, NULL), SP_OK);
}

TEST(matrices_are_of_a_problem_that_is_there)
{
    sp_scene s;
    sp_problem pb, lost;
    sp_triplets t;
    sp_arena empty = none;
    sp_settings set = sp_settings_default();
    NEED(begin(&s));
    NEED(sp_problem_build(&s, &test_arena, &pb) == SP_OK);
    set.faces = 8;
    lost = pb;
    lost.scene = NULL;
    t.count = -7;
    CHECK_INT(sp_matrix_aeq(NULL, 3, &test_arena, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&lost, 3, &test_arena, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&pb, 3, NULL, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&pb, 3, &empty, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&pb, 3, &test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&pb, 2, &test_arena, &t), SP_E_RANGE);
    CHECK_INT(sp_matrix_aeq(&pb, 5, &test_arena, &t), SP_E_RANGE);
    CHECK_INT(sp_matrix_afr(NULL, &set, 3, &test_arena, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&lost, &set, 3, &test_arena, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&pb, NULL, 3, &test_arena, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&pb, &set, 3, NULL, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&pb, &set, 3, &empty, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&pb, &set, 3, &test_arena, NULL), SP_E_ARGUMENT);
    for (int k = 0; k < 4; k++) {                       /* counts whose product is beyond an index */
        sp_problem large = pb;
        if (k == 0) large.blocks = INT32_MAX / 6 + 1;
        if (k == 1) large.points = INT32_MAX / 36 + 1;
        if (k == 2) large.points = INT32_MAX / 32 + 1;
        if (k == 3) large.blocks = large.points = INT32_MAX;
        if (k != 2) CHECK_INT(sp_matrix_aeq(&large, 3, &test_arena, &t), SP_E_MEMORY);
        if (k > 1) CHECK_INT(sp_matrix_afr(&large, &set, 3, &test_arena, &t), SP_E_MEMORY);
    }
    CHECK_INT(t.count, -7);
    CHECK_INT(sp_matrix_aeq(&pb, 3, &test_arena, &t), SP_OK);
    CHECK_INT(t.rows, 6);
    CHECK_INT(t.cols, 12);
}

/* ------------------------------------------------------------------------------------------------------------- placing */

TEST(clearance_is_asked_with_numbers)
{
    static const sp_real x[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
    const sp_real down[3] = { 0, 0, -1 }, com[3] = { R(0.25), R(0.25), 1 };
    sp_support p;
    memset(&p, 0, sizeof p);
    p.area = -7;
    CHECK_INT(sp_support_clearance(NULL, 3, com, down, test_arena, &p), SP_E_ARGUMENT);
    CHECK_INT(sp_support_clearance(x, -1, com, down, test_arena, &p), SP_E_ARGUMENT);
    CHECK_INT(sp_support_clearance(x, 3, NULL, down, test_arena, &p), SP_E_ARGUMENT);
    CHECK_INT(sp_support_clearance(x, 3, com, NULL, test_arena, &p), SP_E_ARGUMENT);
    CHECK_INT(sp_support_clearance(x, 3, com, down, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_support_clearance(x, 3, com, down, none, &p), SP_E_ARGUMENT);
    for (int k = 0; k < 3; k++)
        for (int q = 0; q < 3; q++) {
            sp_real c[3] = { 0, 0, 1 }, g[3] = { 0, 0, -1 }, y[9];
            memcpy(y, x, sizeof y);
            y[6 + q] = c[q] = g[q] = odd[k];
            CHECK_INT(sp_support_clearance(x, 3, c, down, test_arena, &p), SP_E_NOT_FINITE);
            CHECK_INT(sp_support_clearance(x, 3, com, g, test_arena, &p), SP_E_NOT_FINITE);
            CHECK_INT(sp_support_clearance(y, 3, com, down, test_arena, &p), SP_E_NOT_FINITE);
        }
    const sp_real flat[3] = { 0, 0, 0 };
    CHECK_INT(sp_support_clearance(x, 3, com, flat, test_arena, &p), SP_E_RANGE);
    CHECK(p.area < -6);
    CHECK_INT(sp_support_clearance(x, 3, com, down, test_arena, &p), SP_OK);
    CHECK_WITHIN(p.area, 0.5, TOL(1e-12, 1e-6));
    CHECK_WITHIN(p.clearance, 0.25, TOL(1e-12, 1e-6));
    CHECK_INT(sp_support_clearance(NULL, 0, com, down, test_arena, &p), SP_OK);        /* no point is none to stand on */
    CHECK(p.clearance <= -1 && p.area <= 0);
}

TEST(a_seat_is_weighed_by_numbers_in_their_ranges)
{
    const sp_seat good = { { R(0.25), R(0.5), R(0.1) }, 1, 1, 1, 0, -1 };
    sp_seat s = good;
    sp_seat_weights w = sp_seat_weights_default();
    sp_real J = -7;
    sp_real *const numbers[] = { &s.support.clearance, &s.support.area, &s.support.offset, &s.footprint, &s.height, &s.width, &s.trapped,
                                 &s.seat, &w.area, &w.offset, &w.trapped, &w.seat };
    for (size_t q = 0; q < sizeof numbers / sizeof *numbers; q++)
        for (int k = 0; k < 3; k++) {
            const sp_real was = *numbers[q];
            *numbers[q] = odd[k];
            CHECK_INT(sp_support_cost(&s, &w, &J), SP_E_NOT_FINITE);
            *numbers[q] = was;
        }
    for (size_t q = 3; q < sizeof numbers / sizeof *numbers; q++) {
        const sp_real was = *numbers[q];
        if (q == 7) continue;                           /* a seat may be below the level */
        *numbers[q] = -1;
        CHECK_INT(sp_support_cost(&s, &w, &J), SP_E_RANGE);
        *numbers[q] = 0;
        sp_real other;
        CHECK_INT(sp_support_cost(&s, &w, &other), q < 6 ? SP_E_RANGE : SP_OK);
        *numbers[q] = was;
    }
    CHECK_INT(sp_support_cost(NULL, &w, &J), SP_E_ARGUMENT);
    CHECK_INT(sp_support_cost(&s, &w, NULL), SP_E_ARGUMENT);
    CHECK(J < -6);
    CHECK_INT(sp_support_cost(&s, &w, &J), SP_OK);
    CHECK_WITHIN(J, 0.5 + 0.1 - 0.5, TOL(1e-12, 1e-6));
    s.footprint = R(TOL(1e-300, 1e-37));                /* a quotient overflows */
    s.support.area = R(TOL(1e300, 1e37));
    CHECK_INT(sp_support_cost(&s, &w, &J), SP_E_NOT_FINITE);
}

TEST(seats_are_ordered_by_margin_then_cost)
{
    sp_seat seat[3];
    sp_real J[3];
    int32_t order[3] = { 7, 7, 7 }, stable = 7;
    for (int k = 0; k < 3; k++) {
        const sp_seat s = { { R(k == 1 ? 0.01 : 0.25), R(k == 2 ? 0.25 : 0.5), R(0.1) }, 1, 1, 1, 0, 0 };
        seat[k] = s;
    }
    CHECK_INT(sp_support_rank(seat, -1, 0, NULL, J, order, &stable), SP_E_ARGUMENT);
    CHECK_INT(sp_support_rank(NULL, 3, 0, NULL, J, order, &stable), SP_E_ARGUMENT);
    CHECK_INT(sp_support_rank(seat, 3, 0, NULL, NULL, order, &stable), SP_E_ARGUMENT);
    CHECK_INT(sp_support_rank(seat, 3, 0, NULL, J, NULL, &stable), SP_E_ARGUMENT);
    for (int k = 0; k < 3; k++) CHECK_INT(sp_support_rank(seat, 3, odd[k], NULL, J, order, &stable), SP_E_NOT_FINITE);
    CHECK(order[0] == 7 && stable == 7);
    CHECK_INT(sp_support_rank(NULL, 0, 0, NULL, NULL, NULL, &stable), SP_OK);
    CHECK_INT(stable, 0);
    CHECK_INT(sp_support_rank(seat, 3, R(0.1), NULL, J, order, &stable), SP_OK);
    CHECK(order[0] == 0 && order[1] == 2 && order[2] == 1 && stable == 2);
    CHECK_INT(sp_support_rank(seat, 3, R(0.1), NULL, J, order, NULL), SP_OK);
}

TEST(resting_faces_are_asked_with_all_their_arguments)
{
    sp_rest rest[6];
    int32_t count = 7;
    CHECK_INT(sp_rest_faces(&box, none, rest, 6, &count), SP_E_ARGUMENT);
    CHECK_INT(sp_rest_faces(&box, test_arena, NULL, 6, &count), SP_E_ARGUMENT);
    CHECK_INT(sp_rest_faces(&box, test_arena, rest, -1, &count), SP_E_ARGUMENT);
    CHECK_INT(sp_rest_faces(&box, test_arena, rest, 6, NULL), SP_E_ARGUMENT);
    CHECK(sp_rest_faces(NULL, test_arena, rest, 6, &count) != SP_OK);
    CHECK_INT(count, 7);
    CHECK_INT(sp_rest_faces(&box, test_arena, NULL, 0, &count), SP_E_CAPACITY);
    CHECK_INT(count, 6);
    CHECK_INT(sp_rest_faces(&box, test_arena, rest, 6, &count), SP_OK);
}

TEST(a_laid_stone_is_made_of_numbers_in_their_ranges)
{
    static const sp_real x[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
    const sp_real down[3] = { 0, 0, -1 };
    const sp_laid good = { x, 4, { R(0.5), R(0.5), R(0.5) }, { 0, 0, -1 }, 1, 1 };
    sp_nbo_settings set = sp_nbo_settings_default();
    sp_laid l = good;
    sp_nbo why = (sp_nbo)7;
    sp_real *const numbers[] = { &l.com[2], &l.normal[0], &l.normal[1], &l.normal[2], &l.depth, &l.height, &set.margin, &set.slender,
                                 &set.level };
    for (size_t q = 0; q < sizeof numbers / sizeof *numbers; q++)
        for (int k = 0; k < 3; k++) {
            const sp_real was = *numbers[q];
            *numbers[q] = odd[k];
            CHECK_INT(sp_nbo_gate(&l, down, &set, test_arena, &why, NULL), SP_E_NOT_FINITE);
            *numbers[q] = was;
        }
    for (int k = 0; k < 3; k++) {
        l = good;
        if (k == 0) l.depth = -1;
        if (k == 1) l.height = -1;
        if (k == 2) l.normal[2] = 0;
        CHECK_INT(sp_nbo_gate(&l, down, &set, test_arena, &why, NULL), SP_E_RANGE);
    }
    l = good;
    CHECK_INT(sp_nbo_gate(NULL, down, &set, test_arena, &why, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_nbo_gate(&l, down, &set, test_arena, NULL, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_nbo_gate(&l, NULL, &set, test_arena, &why, NULL), SP_E_ARGUMENT);
    CHECK_INT(why, 7);
    CHECK_INT(sp_nbo_gate(&l, down, &set, test_arena, &why, NULL), SP_OK);
    CHECK_INT(why, SP_NBO_ACCEPTED);
}

/* Points far from each other, on both sides of the centroids: only the squares of their places in the contact overflow. */
TEST(a_problem_whose_squares_are_no_numbers_is_refused)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 2, 0 };
    const sp_real low[3] = { 0, 0, -1 }, high[3] = { 0, 0, 1 }, n[3] = { 0, 0, 1 };
    const sp_strength friction = sp_strength_friction(R(0.5));
    for (int over = 0; over < 2; over++) {
        const sp_real far = R(over ? TOL(1e160, 1e25) : TOL(1e140, 1e15)), xyz[6] = { far, 0, 0, -far, 0, 0 };
        sp_problem pb;
        sp_scene s;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        NEED(sp_scene_body(&s, 1, low, SP_FIXED, NULL) == SP_OK && sp_scene_body(&s, 1, high, 0, NULL) == SP_OK);
        NEED(sp_scene_points(&s, 0, 1, n, 2, xyz, &friction, NULL) == SP_OK);
        CHECK_INT(sp_problem_build(&s, &test_arena, &pb), over ? SP_E_NOT_FINITE : SP_OK);
    }
}

TEST_LIST(numbers)
    RUN(joints_are_between_blocks_that_exist_and_made_of_numbers)
    RUN(loads_are_on_blocks_that_exist_and_made_of_numbers)
    RUN(pressure_is_on_faces_that_exist)
    RUN(pressure_on_a_face_whose_area_is_no_number_is_refused)
    RUN(a_block_whose_mass_underflows_is_none)
    RUN(matrices_are_of_a_problem_that_is_there)
    RUN(clearance_is_asked_with_numbers)
    RUN(a_seat_is_weighed_by_numbers_in_their_ranges)
    RUN(seats_are_ordered_by_margin_then_cost)
    RUN(resting_faces_are_asked_with_all_their_arguments)
    RUN(a_problem_whose_squares_are_no_numbers_is_refused)
    RUN(a_laid_stone_is_made_of_numbers_in_their_ranges)
TEST_END
