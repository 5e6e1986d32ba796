/* Limits without dilatancy: closed forms, walls of the literature, claims that prove nothing, memory. */
#include "../test.h"

#ifndef SP_NO_SLIDING
#include "sliding.h"

#include <math.h>

#define NEAR TOL(1e-7, 2e-3)
static const sp_sliding_settings one_start = { 1, 90, 1 };
enum { EXACT = TOL(1, 0) };             /* float has no digits left for walls */

TEST(a_cube_on_a_floor_slides_at_its_friction_and_tips_at_its_breadth)
{
    static const double mu[] = { 0.1, 0.5, 0.9, 1.1, 3 };
    for (int k = 0; k < 5; k++) {
        sp_scene s = pushed("two-cubes", "offset", 0, 1, 0);
        s.joint[0].strength.mu = R(mu[k]);
        const sp_sliding_result r = slide(&s, &one_start);
        CHECK_INT(r.kind, SP_SLIDING_STATE);
        CHECK(fabs((double)r.upper - (mu[k] < 1 ? mu[k] : 1)) < NEAR);
        CHECK(fabs((double)(r.lower / r.upper) - 1) < TOL(1e-6, 1e-2) || !EXACT);       /* friction even with pressure */
        CHECK(fabs((double)(r.lower_strong / r.upper) - 1) < TOL(1e-6, 1e-2) || !EXACT);
    }
}

/* n cubes, each .08 m beyond the one below, pushed that way: they tip at (1 - .08 (n + 1)) / n, and below that nothing slides, nor
 * moves from rest, whatever friction does. */
TEST(a_stack_is_strong_up_to_where_it_tips)
{
    for (int n = 1; n <= 8; n++) {
        sp_scene s = pushed("tower", "n", n, 1, 0);
        const sp_sliding_result r = slide(&s, &one_start);
        const double tips = (1 - 0.08 * (n + 1)) / n;
        if (!EXACT) continue;
        CHECK_NEAR(r.upper, tips < 0.84 ? tips : 0.84, 1e-7);
        CHECK_NEAR(r.lower, r.upper, 1e-6);
        CHECK_NEAR(r.lower_strong, r.upper, 1e-6);
    }
}

/* Friction that is not even with pressure, forces of another multiple, loads that lift: no lower side. Forces that do not balance
 * at rest: none that is strong. */
TEST(forces_that_are_changed_prove_no_lower_side)
{
    if (!EXACT) return;
    for (int what = 0; what < 5; what++) {
        sp_sliding_evidence e;
        sp_scene s = pushed("tower", "n", 3, 1, 0);
        sp_sliding_result r = slide(&s, &one_start);
        CHECK(r.lower > 0 && r.lower_strong > 0);
        if (what == 0) r.lower *= R(1.001);
        if (what == 1) r.lower_strong *= R(1.001);
        if (what == 2) for (int32_t k = 0; k < s.count.points; k++) r.pressed[3 * k + 1] *= R(0.9);
        if (what == 3) s.joint[0].strength.mu = R(0.05);
        if (what == 4) for (int32_t k = 0; k < 3 * s.count.points; k++) r.resting[k] *= R(0.9);
        CHECK_INT(sp_sliding_verify(&s, NULL, &r, test_arena, &e), SP_OK);
        CHECK(!(e.lower_strong > 0));
        CHECK_INT(e.lower > 0, what == 1 || what == 4);
    }
}

/* A cube .2 m from its edge tips under a load P .3 m beyond it at lambda P = 2/3 of its weight; pressure alone tells so. */
static sp_scene tipping(void)
{
    sp_load load;
    sp_scene s = room_for(2, 2);
    memset(&load, 0, sizeof load);
    brick(&s, 0, 1, -1, 0, SP_FIXED);
    brick(&s, 0.3, 1.3, 0, 1, 0);
    find_joints(&s, 0.84);
    load.block = 1;
    load.live = 1;
    load.point[0] = R(1.3);
    load.point[1] = load.point[2] = R(0.5);
    load.force[2] = -s.block[1].mass * R(9.80665);
    CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
    return s;
}

TEST(what_tips_is_strong_up_to_where_it_tips)
{
    const sp_scene s = tipping();
    const sp_sliding_result r = slide(&s, &one_start);
    CHECK_INT(r.kind, SP_SLIDING_STATE);
    CHECK(fabs((double)r.upper - 2.0 / 3) < NEAR);
    CHECK(fabs((double)r.lower - 2.0 / 3) < NEAR && fabs((double)r.lower_strong - 2.0 / 3) < NEAR);
}

/* Twice its weight on top of a cube: whatever is pushed down on a floor stays. */
TEST(no_state_is_claimed_where_there_is_none)
{
    const sp_scene s = pushed("two-cubes", "offset", 0.2, 0, -1);
    const sp_sliding_result r = slide(&s, &one_start);
    CHECK_INT(r.kind, SP_SLIDING_NONE);
    CHECK_INT(r.reason, SP_SLIDING_NOTHING_FOUND);
    CHECK(r.upper < 0 && r.associative < 0);
}

/* A beam between two walls: down it goes at once, its squeeze being any; up it goes when its weight is lifted off. */
TEST(a_beam_held_by_squeezing_alone_slides_at_once)
{
    for (int up = 0; up < 2; up++) {
        const sp_scene s = pushed("h-model", "mu", 0.6, 0, up ? 1 : -1);
        const sp_sliding_result r = slide(&s, &one_start);
        CHECK_INT(r.kind, SP_SLIDING_STATE);
        CHECK(fabs((double)r.upper - up) < NEAR);
        CHECK(!(r.lower > 0) && !(r.lower_strong > 0));
    }
}

/* Pushed up a slope of 20 degrees: (mu - tan) / (1 + mu tan), down it: (mu + tan) / (1 - mu tan). */
TEST(a_block_on_a_slope_slides_up_and_down_at_its_closed_form)
{
    const double mu = 0.84, tan = 0.36397023426620234;
    for (int up = 0; up < 2; up++) {
        const sp_scene s = pushed("incline", "angle", 20, up ? -1 : 1, 0);
        const sp_sliding_result r = slide(&s, &one_start);
        CHECK_INT(r.kind, SP_SLIDING_STATE);
        CHECK(fabs((double)r.upper - (up ? (mu + tan) / (1 - mu * tan) : (mu - tan) / (1 + mu * tan))) < NEAR);
    }
}

/* Two such bodies, all patterns of whose corners were told apart by linear programs: limits .132719 and .836841 with dilatancy,
 * without it nothing at any multiple >= 0. */
TEST(a_finite_associative_limit_may_have_no_state_at_all)
{
    static const double at[2][2][2] = { { { -0.96, 0.41 }, { -1, 0.01 } }, { { -0.62, 0.65 }, { -0.69, -0.19 } } };
    static const double angle[2][2] = { { 1.3007963267948965, 0.6307963267948966 }, { 1.1407963267948966, 0.9207963267948965 } };
    static const double q[2][3] = { { -0.4, -1.09, -1.36 }, { -0.52, 0.16, -0.38 } }, limit[2] = { 0.13271922, 0.83684117 };
    for (int k = 0; k < 2; k++) {
        const sp_scene s = two_points(at[k], angle[k], 2, q[k]);
        const sp_sliding_result r = slide(&s, NULL);
        if (EXACT) CHECK(fabs((double)r.associative - limit[k]) < 1e-6);
        CHECK_INT(r.kind, SP_SLIDING_NONE);
        CHECK_INT(r.reason, SP_SLIDING_NOTHING_FOUND);
        CHECK(r.upper >= r.associative && r.upper <= r.associative);
    }
}

/* Another one: states at .8534 and at 1.998 alone; strong at samples between. So a state says nothing of what lies above it. */
TEST(a_state_below_multiples_that_are_strong_is_a_state)
{
    static const double at[2][2] = { { 0.431, -0.923 }, { 0.786, 0.465 } }, angle[2] = { 2.485, 1.405 };
    static const double q[3] = { -1.054, -0.657, -0.42 };
    const sp_scene s = two_points(at, angle, 1, q);
    const sp_sliding_result r = slide(&s, NULL);
    if (EXACT) CHECK(fabs((double)r.associative - 1.998) < 2e-3);
    CHECK_INT(r.kind, SP_SLIDING_STATE);
    CHECK(fabs((double)r.upper - 0.8534) < 1e-3 || fabs((double)r.upper - 1.998) < 2e-3);
    CHECK(!(r.lower_strong > 0));
}

/* Published: .640 (.643 with dilatancy). The state lies below. */
TEST(a_wall_of_ferris_and_tin_loi_slides_below_its_published_multiple)
{
    if (!EXACT) return;
    const sp_scene s = bond(6);
    const sp_sliding_result r = slide(&s, &one_start);
    CHECK_INT(r.kind, SP_SLIDING_STATE);
    CHECK(fabs((double)r.upper - 0.638982) < 2e-6);
    CHECK(fabs((double)r.associative - 0.642859) < 2e-6);
    CHECK(r.residual < R(1e-12) && r.share > R(0.1));
    CHECK(r.ends == 1 && r.end[0].steady > R(0.638));
}

/* Published: .563. More starts find no higher state than fewer. */
TEST(more_starts_find_no_higher_state)
{
    if (!EXACT || !test_long) return;
    const sp_sliding_settings more = { 3, 200, 1 };
    sp_scene s = bond(10);
    const sp_sliding_result r = slide(&s, &one_start);
    CHECK(fabs((double)r.upper - 0.557416) < 2e-6);
    s = bond(10);
    const sp_sliding_result x = slide(&s, &more);
    CHECK(x.ends > 1 && x.upper <= r.upper);
}

TEST(a_state_does_not_depend_on_how_the_scene_is_written)
{
    for (int round = 0; round < SOME_OF(20, 4); round++) {
        int32_t place[MOST], name[MOST];
        sp_scene s = pushed("tower", "n", 4, 1, 0), t;
        change c = none();
        const sp_sliding_result r = slide(&s, &one_start);
        any_turn(&c);
        c.scale = round % 2 ? 100 : 0.1;
        c.gravity = round % 3 ? 1 : 7;
        c.permute = c.turn = c.swap = 1;
        copy(&s, &c, &t, place, name);
        for (int k = 0; k < 3; k++) t.body[k] = R(c.gravity * c.q[k][0] * 9.80665);
        const sp_sliding_result x = slide(&t, &one_start);
        CHECK_INT(r.kind, SP_SLIDING_STATE);
        CHECK_INT(x.kind, SP_SLIDING_STATE);
        CHECK(fabs((double)x.upper / (double)r.upper - 1) < NEAR);
    }
}

/* Pressed on, a cantilever stands under any multiple: no end bounds the program, which stopped at any vertex. */
TEST(lower_was_0_or_18_by_the_order_of_blocks_where_pressure_carries_any_multiple)
{
    for (int round = 0; round < 6; round++) {
        int32_t place[MOST], name[MOST];
        sp_scene s = pushed("cantilever", "reach", 1, 0, -1), t;
        change c = none();
        c.permute = round > 0;
        copy(&s, &c, &t, place, name);
        for (int k = 0; k < 3; k++) t.body[k] = s.body[k];
        const sp_sliding_result r = slide(&t, &one_start);
        if (EXACT) CHECK_NEAR(r.lower, 1000, 1e-3);     /* where it ends now: times live loads as large as dead ones */
    }
}

TEST(a_state_that_is_changed_proves_nothing)
{
    sp_scene s = pushed("two-cubes", "offset", 0, 1, 0);
    sp_sliding_result r = slide(&s, &one_start), x;
    sp_sliding_evidence e;
    const int32_t points = s.count.points;
    for (int what = 0; what < 6; what++) {
        x = r;
        if (what == 0) x.upper *= R(1.01);
        if (what == 1) for (int k = 0; k < 6; k++) r.v[6 + k] = -r.v[6 + k];
        if (what == 2) for (int32_t k = 0; k < 3 * points; k++) r.f[k] = -r.f[k];
        if (what == 3) r.v[6 + 2] += R(0.01);           /* it would open where it presses */
        if (what == 4) memset(r.v, 0, 12 * sizeof *r.v);
        if (what == 5) memset(r.f, 0, 3 * (size_t)points * sizeof *r.f);
        CHECK_INT(sp_sliding_verify(&s, NULL, &x, test_arena, &e), SP_OK);
        if (!CHECK_INT(e.state, 0)) TEST_PRINT("    change %d\n", what);
        s = pushed("two-cubes", "offset", 0, 1, 0);
        r = slide(&s, &one_start);
    }
    x = r;
    x.lower = x.lower_strong = R(0.5);                  /* no pressure carries that */
    CHECK_INT(sp_sliding_verify(&s, NULL, &x, test_arena, &e), SP_OK);
    CHECK(!(e.lower > 0) && !(e.lower_strong > 0));
}

/* Of two cubes that slide alike live loads do all the work that they could do. */
TEST(loads_along_every_motion_do_all_the_work_there_is)
{
    sp_sliding_evidence e;
    sp_scene s = room_for(3, 4);
    brick(&s, -1, 5, -1, 0, SP_FIXED);
    brick(&s, 0, 1, 0, 1, 0);
    brick(&s, 2, 3, 0, 1, 0);
    find_joints(&s, 0.5);
    s.body[0] = R(9.80665);
    sp_sliding_result r = slide(&s, &one_start);
    CHECK(fabs((double)r.upper - 0.5) < NEAR);
    for (int k = 0; k < 12; k++) r.v[6 + k] = k % 6 == 0;
    CHECK_INT(sp_sliding_verify(&s, NULL, &r, test_arena, &e), SP_OK);
    CHECK_INT(e.state, 1);
    CHECK(fabs((double)e.share - 1) < 1e-6);
}

/* A cube that slides along x and is held along y, where live loads push it too, and hold nothing up: they do little of the work
 * that they could do, but push from a thousandth of it on. */
TEST(loads_push_a_slide_from_a_thousandth_of_their_work_on)
{
    for (int less = 0; less < 2; less++) {
        sp_sliding_evidence e;
        sp_scene s = pushed("two-cubes", "offset", 0, 1, 0);
        s.joint[0].strength.mu = R(0.5);
        const sp_sliding_result r = slide(&s, &one_start);
        CHECK_INT(r.kind, SP_SLIDING_STATE);
        const double share = 1e-3 * (less ? 0.99 : 1.01);
        s.block[1].fixed = 2u;
        s.body[1] = R(9.80665 * sqrt(1 / (share * share) - 1));
        CHECK_INT(sp_sliding_verify(&s, NULL, &r, test_arena, &e), SP_OK);
        CHECK_NEAR(e.share, share, TOL(1e-6, 1e-3));
        CHECK_INT(e.state, !less);
    }
}

TEST(scenes_that_are_not_planar_keep_the_associative_value)
{
    sp_scene s = pushed("two-cubes", "offset", 0.1, 1, 0);
    s.body[1] = R(2);
    const sp_sliding_result r = slide(&s, &one_start);
    CHECK_INT(r.kind, SP_SLIDING_NONE);
    CHECK_INT(r.reason, SP_SLIDING_NOT_ASKED);
    CHECK(r.upper >= r.associative && r.upper > 0);
}

/* Dead and live loads lean out of the plane by as much to either side: together they are in it. */
TEST(loads_that_lie_in_a_plane_only_together_are_not_planar)
{
    sp_scene s = pushed("two-cubes", "offset", 0.1, 1, 0);
    s.gravity[1] = R(0.25);
    s.body[1] = -R(0.25);
    const sp_sliding_result r = slide(&s, &one_start);
    CHECK_INT(r.kind, SP_SLIDING_NONE);
    CHECK_INT(r.reason, SP_SLIDING_NOT_ASKED);
    CHECK(r.upper >= r.associative && r.upper > 0);
}

TEST(strength_of_joints_is_not_asked)
{
    sp_scene s = pushed("two-cubes", "offset", 0.1, 1, 0);
    s.joint[0].strength.cohesion = 10;
    CHECK_INT(slide(&s, &one_start).reason, SP_SLIDING_NOT_ASKED);
}

TEST(the_same_seed_gives_the_same_bits)
{
    const sp_sliding_settings how = { 2, 90, 77 };
    sp_scene s = pushed("wall", "rows", 3, 1, 0);
    const sp_sliding_result a = slide(&s, &how), b = slide(&s, &how);
    CHECK(memcmp(&a.upper, &b.upper, sizeof a.upper) == 0 && a.ends == b.ends && a.end[0].seed == 77);
    CHECK(memcmp(a.f, b.f, 3 * (size_t)s.count.points * sizeof *a.f) == 0);
    CHECK(memcmp(a.v, b.v, 6 * (size_t)s.count.blocks * sizeof *a.v) == 0);
}

/* Nothing that could slide: supports alone, a stone that touches nothing, more stones than are asked for. */
TEST(what_has_no_joint_or_no_stone_or_too_many_does_not_slide)
{
    for (int k = 0; k < 3; k++) {
        const int32_t stones = k == 0 ? 0 : k == 1 ? 1 : 401;
        const sp_capacity cap = { 1 + stones, 0, 0, 0, 0, 0, 0 };
        const sp_real origin[3] = { 0, 0, 0 };
        sp_scene s;
        sp_limit_result limit;
        sp_sliding_result r;
        size_t bytes = 0;
        test_arena.used = 0;
        CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
        CHECK_INT(sp_scene_body(&s, 0, origin, SP_FIXED, NULL), SP_OK);
        for (int32_t b = 0; b < stones; b++) CHECK_INT(sp_scene_body(&s, 1, origin, 0, NULL), SP_OK);
        s.body[0] = 1;
        memset(&limit, 0, sizeof limit);
        limit.kind = SP_LIMIT_NONE;
        limit.upper = -1;
        CHECK_INT(sp_memory(&s, SP_FOR_SLIDING, NULL, test_arena, &bytes), SP_OK);
        NEED(sp_sliding(&s, NULL, &one_start, &limit, &test_arena, &r) == SP_OK);
        CHECK(r.peak_bytes > 0 && bytes > 0);
        CHECK_INT(r.kind, SP_SLIDING_NONE);
        CHECK_INT(r.reason, SP_SLIDING_NOT_ASKED);
        CHECK(!(r.lower > 0));
    }
}

/* A claim's multiples: none below 0, a strong one no larger than the other. */
TEST(multiples_that_are_claimed_are_in_their_order)
{
    const sp_scene s = tipping();
    const sp_sliding_result r = slide(&s, &one_start);
    sp_sliding_evidence e;
    NEED(r.lower > 0 && r.lower_strong > 0);
    for (int k = 0; k < 4; k++) {
        sp_sliding_result c = r;
        if (k == 1) c.upper = -1;
        if (k == 2) c.lower = -1;
        if (k == 3) c.lower_strong = 2 * c.lower;
        CHECK_INT(sp_sliding_verify(&s, NULL, &c, test_arena, &e), SP_OK);
        CHECK_INT(e.lower > 0, k != 2);
        CHECK_INT(e.lower_strong > 0, k < 2);
        CHECK(e.lower_strong <= e.lower);
    }
}

/* Whoever lets the judge take less is told less, never more. */
TEST(what_a_budget_leaves_of_a_claim_is_part_of_it)
{
    const sp_scene s = tipping();
    const sp_sliding_result r = slide(&s, &one_start);
    sp_settings set = sp_settings_default();
    sp_sliding_evidence e;
    int none = 0, all = 0;
    for (set.budget = 1; set.budget < 10000000; set.budget *= 2) {
        CHECK_INT(sp_sliding_verify(&s, &set, &r, test_arena, &e), SP_OK);
        CHECK(e.lower == 0 || e.lower == r.lower);
        CHECK(e.lower_strong == 0 || e.lower_strong == r.lower_strong);
        CHECK(e.lower_strong <= e.lower);
        none += e.lower == 0 && e.lower_strong == 0;
        all += e.lower == r.lower && e.lower_strong == r.lower_strong;
    }
    CHECK(none > 0 && all > 0);
}

TEST(a_budget_beyond_what_may_be_spent_changes_no_bit)
{
    const sp_scene s = tipping();
    sp_limit_result limit;
    sp_sliding_result r[2];
    NEED(sp_limit(&s, NULL, &test_arena, &limit) == SP_OK);
    for (int k = 0; k < 2; k++) {
        sp_settings set = sp_settings_default();
        set.budget = k ? INT64_MAX / 4 : 0;
        NEED(sp_sliding(&s, &set, &one_start, &limit, &test_arena, &r[k]) == SP_OK);
    }
    CHECK_INT(r[1].kind, r[0].kind);
    CHECK(r[0].upper > 0 && r[1].upper == r[0].upper && r[1].lower == r[0].lower && r[1].lower_strong == r[0].lower_strong);
    CHECK(r[1].cost.flops == r[0].cost.flops);
}

TEST(sliding_takes_the_memory_it_says_and_no_byte_less)
{
    static const char *const name[] = { "two-cubes", "wall", "h-model" };
    for (int k = 0; k < 3; k++) {
        sp_scene s = pushed(name[k], NULL, 0, 1, 0);
        sp_limit_result limit;
        sp_sliding_result r;
        sp_sliding_evidence e;
        size_t bytes = 0;
        CHECK_INT(sp_limit(&s, NULL, &test_arena, &limit), SP_OK);
        CHECK_INT(sp_memory(&s, SP_FOR_SLIDING, NULL, test_arena, &bytes), SP_OK);
        sp_arena a = test_arena;
        a.used = (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        a.base += a.used;
        a.used = a.peak = 0;
        a.capacity = bytes - 1;
        CHECK_INT(sp_sliding(&s, NULL, &one_start, &limit, &a, &r), SP_E_MEMORY);
        CHECK(a.used == 0);
        a.capacity = bytes;
        CHECK_INT(sp_sliding(&s, NULL, &one_start, &limit, &a, &r), SP_OK);
        CHECK(a.peak == bytes && r.peak_bytes == bytes);
        CHECK_INT(sp_memory(&s, SP_FOR_SLIDING_VERIFY, NULL, test_arena, &bytes), SP_OK);
        a.base += (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        a.used = 0;
        a.capacity = bytes;
        CHECK_INT(sp_sliding_verify(&s, NULL, &r, a, &e), SP_OK);
        a.capacity = bytes - 1;
        CHECK_INT(sp_sliding_verify(&s, NULL, &r, a, &e), SP_E_MEMORY);
    }
}

TEST(sliding_questions_that_make_no_sense_are_refused)
{
    static const sp_sliding_settings bad[] = { { -1, 90, 1 }, { SP_SLIDING_STARTS + 1, 90, 1 }, { 1, -1, 1 }, { 1, 1001, 1 } };
    sp_scene s = pushed("two-cubes", "offset", 0.1, 1, 0);
    sp_settings set = sp_settings_default();
    sp_limit_result limit;
    sp_sliding_result r;
    sp_sliding_evidence e;
    CHECK_INT(sp_limit(&s, NULL, &test_arena, &limit), SP_OK);
    for (int k = 0; k < 4; k++) CHECK_INT(sp_sliding(&s, NULL, &bad[k], &limit, &test_arena, &r), SP_E_RANGE);
    CHECK_INT(sp_sliding(NULL, NULL, NULL, &limit, &test_arena, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding(&s, NULL, NULL, NULL, &test_arena, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding(&s, NULL, NULL, &limit, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_sliding(&s, NULL, NULL, &limit, &test_arena, NULL), SP_E_ARGUMENT);
    set.faces = 8;
    CHECK_INT(sp_sliding(&s, &set, NULL, &limit, &test_arena, &r), SP_E_UNSUPPORTED);
    CHECK_INT(sp_sliding(&s, NULL, &one_start, &limit, &test_arena, &r), SP_OK);
    CHECK_INT(sp_sliding_verify(&s, &set, &r, test_arena, &e), SP_E_UNSUPPORTED);
    r.v[0] = R(1e300) * R(1e300);
    CHECK_INT(sp_sliding_verify(&s, NULL, &r, test_arena, &e), SP_E_NOT_FINITE);
    limit.upper = r.v[0];
    CHECK_INT(sp_sliding(&s, NULL, NULL, &limit, &test_arena, &r), SP_E_NOT_FINITE);
}

#endif

TEST_LIST(sliding)
#ifndef SP_NO_SLIDING
    RUN(a_stack_is_strong_up_to_where_it_tips)
    RUN(forces_that_are_changed_prove_no_lower_side)
    RUN(a_cube_on_a_floor_slides_at_its_friction_and_tips_at_its_breadth)
    RUN(what_tips_is_strong_up_to_where_it_tips)
    RUN(no_state_is_claimed_where_there_is_none)
    RUN(a_beam_held_by_squeezing_alone_slides_at_once)
    RUN(a_block_on_a_slope_slides_up_and_down_at_its_closed_form)
    RUN(a_finite_associative_limit_may_have_no_state_at_all)
    RUN(a_state_below_multiples_that_are_strong_is_a_state)
    RUN(a_wall_of_ferris_and_tin_loi_slides_below_its_published_multiple)
    RUN(more_starts_find_no_higher_state)
    RUN(a_state_does_not_depend_on_how_the_scene_is_written)
    RUN(lower_was_0_or_18_by_the_order_of_blocks_where_pressure_carries_any_multiple)
    RUN(a_state_that_is_changed_proves_nothing)
    RUN(loads_along_every_motion_do_all_the_work_there_is)
    RUN(loads_push_a_slide_from_a_thousandth_of_their_work_on)
    RUN(scenes_that_are_not_planar_keep_the_associative_value)
    RUN(loads_that_lie_in_a_plane_only_together_are_not_planar)
    RUN(strength_of_joints_is_not_asked)
    RUN(the_same_seed_gives_the_same_bits)
    RUN(what_has_no_joint_or_no_stone_or_too_many_does_not_slide)
    RUN(multiples_that_are_claimed_are_in_their_order)
    RUN(what_a_budget_leaves_of_a_claim_is_part_of_it)
    RUN(a_budget_beyond_what_may_be_spent_changes_no_bit)
    RUN(sliding_takes_the_memory_it_says_and_no_byte_less)
    RUN(sliding_questions_that_make_no_sense_are_refused)
#endif
TEST_END
