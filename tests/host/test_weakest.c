/* The joint nearest to its limit: each limit from its closed form, and which of several is told. Host only. */
#include "../test.h"
#include "../../port/host/run.h"
#include "../../port/host/weakest.h"
#include "../scenes/gen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define NEAR TOL(1e-6, 2e-2)

/* A checked scene, in test_arena; its result in memory of malloc's. */
typedef struct checked {
    sp_scene scene;
    sp_result result;
    void *memory;
} checked;

static int check(checked *k)
{
    run_cost cost;
    k->memory = NULL;
    return CHECK_INT(run_check(&k->scene, NULL, &k->result, &cost, &k->memory), SP_OK)
        && CHECK_INT(k->result.verdict, SP_STABLE);
}

/* Is the nearest limit this one, and known?                                 `share` of it, to NEAR; -1: none is near */
static void nearest(checked *k, weakest_limit by, double share, int known)
{
    if (check(k)) {
        const weakest_joint w = weakest_nearest(&k->scene, &k->result);
        CHECK_INT(w.joint >= 0, share >= 0);
        CHECK_INT(weakest_told(&k->scene, &k->result), w.joint);
        if (share >= 0) CHECK_TEXT(weakest_text(w.by), weakest_text(by));
        if (share >= 0) CHECK_NEAR(w.share, share, NEAR);
        if (share >= 0) CHECK_INT(w.known, known);
    }
    free(k->memory);
}

/* A body of weight 1 with its centroid at (x, y, 0), on a support by a joint in the plane z = 0 (`points`: by points). */
static int one_joint(checked *k, double x, double y, const sp_strength *strength, int32_t corners, const sp_real *corner,
                     int points)
{
    const sp_capacity room = { .blocks = 2, .joints = 1, .points = 8, .loads = 1 };
    const sp_real at[3] = { R(x), R(y), 0 }, below[3] = { 0, 0, -1 }, up[3] = { 0, 0, 1 };
    sp_scene *s = &k->scene;
    if (sp_scene_create(s, &room, &test_arena) || sp_scene_body(s, 0, below, SP_FIXED, NULL)
        || sp_scene_body(s, 1, at, 0, NULL)) return 0;
    s->gravity[2] = -1;
    return (points ? sp_scene_points(s, 0, 1, up, corners, corner, strength, NULL)
                   : sp_scene_joint(s, 0, 1, corners, corner, strength, NULL)) == SP_OK;
}

/* On a square of side 2 about the origin: x is the share of the way to its edge. */
static const sp_real square[12] = { -1, -1, 0,  1, -1, 0,  1, 1, 0,  -1, 1, 0 };

static int on_square(checked *k, double x, const sp_strength *strength)
{
    return one_joint(k, x, 0, strength, 4, square, 0);
}

TEST(a_block_at_the_edge_it_tips_about_is_near_its_limit)
{
    const sp_strength dry = sp_strength_friction(R(0.7));
    checked k;
    NEED(on_square(&k, 0.999, &dry));
    nearest(&k, WEAKEST_TIPPING, 0.999, 1);
    NEED(one_joint(&k, -0.3, -0.95, &dry, 4, square, 0));
    nearest(&k, WEAKEST_TIPPING, 0.95, 1);
    NEED(on_square(&k, 0.89, &dry));
    nearest(&k, WEAKEST_TIPPING, -1, 0);
}

TEST(a_block_about_to_turn_in_its_joint_is_near_its_limit)
{
    const sp_strength dry = sp_strength_friction(R(0.7));
    const sp_load twist = { .block = 1, .couple = { 0, 0, R(0.999 * 0.7 * 1.4142135623730951) } };
    checked k;
    NEED(on_square(&k, 0, &dry) && sp_scene_load(&k.scene, &twist, NULL) == SP_OK);
    nearest(&k, WEAKEST_TURNING, 0.999, 1);
}

TEST(a_block_about_to_slide_is_near_its_limit)
{
    const sp_strength dry = sp_strength_friction(R(0.2));
    checked k;
    NEED(on_square(&k, 0, &dry));
    k.scene.gravity[1] = R(0.19);
    nearest(&k, WEAKEST_SLIDING, 0.95, 1);
}

/* Tension 1 of 4 m^2 holds a block beyond the edge: weight at 1.2 and 4 in the middle act together at 1.2 / 5. */
TEST(tension_holds_what_passes_beyond_the_edge)
{
    sp_strength mortar = { R(0.5), 10, 1, 0 };
    checked k;
    NEED(on_square(&k, 1.2, &mortar));
    nearest(&k, WEAKEST_TIPPING, -1, 0);
    mortar.tension = R(0.0625);                         /* 1.2 / 1.25 */
    NEED(on_square(&k, 1.2, &mortar));
    nearest(&k, WEAKEST_TIPPING, 0.96, 1);
    mortar.tension = 1;
    mortar.cohesion = R(0.03125);                       /* it counts up to cohesion / mu */
    NEED(on_square(&k, 1.2, &mortar));
    nearest(&k, WEAKEST_TIPPING, 0.96, 1);
}

TEST(a_hanging_block_is_near_parting_and_a_pressed_one_near_crushing)
{
    const sp_strength glue = { R(0.5), 10, R(0.2625), 0 }, soft = { R(0.5), 0, 0, R(0.2625) };   /* weight / 4 m^2 / 0.952 */
    checked k;
    NEED(on_square(&k, 0, &glue));
    k.scene.gravity[2] = 1;
    nearest(&k, WEAKEST_PARTING, 1 / 1.05, 1);
    NEED(on_square(&k, 0, &soft));
    nearest(&k, WEAKEST_CRUSHING, 1 / 1.05, 1);
}

/* Of an L the middle of its corners is (1, 1); it tips about the line from (2, 1) to (1, 2), which is none of its sides. */
TEST(a_concave_joint_tips_about_its_hull)
{
    static const sp_real ell[18] = { 0, 0, 0,  2, 0, 0,  2, 1, 0,  1, 1, 0,  1, 2, 0,  0, 2, 0 };
    const sp_strength dry = sp_strength_friction(R(0.7));
    checked k;
    NEED(one_joint(&k, 1.48, 1.48, &dry, 6, ell, 0));
    nearest(&k, WEAKEST_TIPPING, 0.96, 1);
}

TEST(points_tip_about_their_hull_in_whatever_order_and_a_line_has_no_inside)
{
    static const sp_real crossed[15] = { -1, -1, 0,  1, 1, 0,  1, -1, 0,  1, 1, 0,  -1, 1, 0 };
    static const sp_real line[9] = { -1, 0, 0,  0, 0, 0,  1, 0, 0 };
    const sp_strength dry = sp_strength_friction(R(0.7));
    checked k;
    NEED(one_joint(&k, 0.2, 0.2, &dry, 5, crossed, 1)); /* the middle of these is (0.2, 0.2) */
    nearest(&k, WEAKEST_TIPPING, -1, 0);
    NEED(one_joint(&k, 0.96, 0.2, &dry, 5, crossed, 1));
    nearest(&k, WEAKEST_TIPPING, 0.95, 1);
    NEED(one_joint(&k, 0.99, 0, &dry, 3, line, 1));
    nearest(&k, WEAKEST_TIPPING, -1, 0);
}

/* A beam on two posts, its weight 0.01 from the outer edge of the second: more than one set of forces holds it. */
TEST(where_forces_are_not_known_the_words_say_by_these)
{
    static const sp_real post[2][12] = { { -2, -1, 0,  -1, -1, 0,  -1, 1, 0,  -2, 1, 0 },
                                         { 0, -1, 0,  1, -1, 0,  1, 1, 0,  0, 1, 0 } };
    const sp_capacity room = { .blocks = 3, .joints = 2, .points = 8 };
    const sp_real at[3] = { R(0.99), 0, 1 }, below[3] = { 0, 0, -1 };
    const sp_strength dry = sp_strength_friction(R(0.7));
    char words[WEAKEST_WORDS];
    checked k;
    sp_scene *s = &k.scene;
    NEED(sp_scene_create(s, &room, &test_arena) == SP_OK && sp_scene_body(s, 0, below, SP_FIXED, NULL) == SP_OK
         && sp_scene_body(s, 0, below, SP_FIXED, NULL) == SP_OK && sp_scene_body(s, 1, at, 0, NULL) == SP_OK);
    for (int32_t i = 0; i < 2; i++) NEED(sp_scene_joint(s, i, 2, 4, post[i], &dry, NULL) == SP_OK);
    NEED(check(&k));
    const weakest_joint w = weakest_nearest(s, &k.result);
    CHECK_INT(w.joint, 1);
    CHECK_INT(w.by, WEAKEST_TIPPING);
    CHECK_INT(w.known, 0);
    weakest_words(s, &k.result, &w, words);
    CHECK(strncmp(words, "near tipping about an edge, ", 28) == 0 && strstr(words, ", by these forces"));
    free(k.memory);
}

static int gen(checked *k, const char *name, const char *param, double value)
{
    return CHECK_INT(gen_make(name, param, value, &test_arena, &k->scene), SP_OK);
}

/* A block on a slope that topples at tan(angle) = 0.25, and uses 30 % of its friction then. */
TEST(a_tall_block_topples_before_it_slides)
{
    checked k;
    NEED(gen(&k, "topple", "angle", 14));
    nearest(&k, WEAKEST_TIPPING, 4 * tan(14 * 3.14159265358979323846 / 180), 1);
}

/* Where forces go round, an arch's line of thrust touches the edge by these forces and not by others: friction is told. */
TEST(a_thick_arch_is_told_by_its_friction)
{
    checked k;
    NEED(gen(&k, "arch", "t", 0.3) && check(&k));
    const weakest_joint w = weakest_nearest(&k.scene, &k.result);
    CHECK_INT(w.by, WEAKEST_SLIDING);
    CHECK_INT(w.known, 0);
    CHECK_INT(w.joint, k.result.extremes.weakest);
    CHECK_NEAR(w.share, k.result.extremes.utilisation, 1e-12);
    free(k.memory);
}

TEST(on_a_plain_wall_no_joint_is_near_its_limit)
{
    checked k;
    NEED(gen(&k, "wall", "rows", 4));
    nearest(&k, WEAKEST_SLIDING, -1, 0);
    NEED(gen(&k, "tower", "lean", 0.05));
    nearest(&k, WEAKEST_SLIDING, -1, 0);
}

TEST_LIST(weakest)
    RUN(a_block_at_the_edge_it_tips_about_is_near_its_limit)
    RUN(a_block_about_to_turn_in_its_joint_is_near_its_limit)
    RUN(a_block_about_to_slide_is_near_its_limit)
    RUN(tension_holds_what_passes_beyond_the_edge)
    RUN(a_hanging_block_is_near_parting_and_a_pressed_one_near_crushing)
    RUN(a_concave_joint_tips_about_its_hull)
    RUN(points_tip_about_their_hull_in_whatever_order_and_a_line_has_no_inside)
    RUN(where_forces_are_not_known_the_words_say_by_these)
    RUN(a_tall_block_topples_before_it_slides)
    RUN(a_thick_arch_is_told_by_its_friction)
    RUN(on_a_plain_wall_no_joint_is_near_its_limit)
TEST_END
