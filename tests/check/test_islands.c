/* Islands: each is checked by itself, and what is said of all follows from each. */
#include "../scenes/planned.h"

TEST(of_two_islands_the_one_that_falls_is_named_and_moves_alone)
{
    for (int k = 0; k < 2; k++) {
        sp_scene s;
        test_arena.used = 0;
        s = two("arch", "overhang", "factor", 1.1, k ? other : plain);
        sp_arena a = test_arena;
        const sp_result r = check(&s, NULL, &a);
        int32_t moving = 0;
        CHECK_INT(r.verdict, SP_UNSTABLE);
        CHECK_INT(r.reason, SP_REASON_MECHANISM);
        CHECK_INT(r.islands.count, 2);
        NEED(r.islands.each && r.islands.of);
        CHECK_INT(r.islands.each[0].verdict, SP_STABLE);
        CHECK_INT(r.islands.each[0].reason, SP_REASON_FORCES);
        CHECK_INT(r.islands.each[1].verdict, SP_UNSTABLE);
        CHECK_INT(r.islands.each[0].blocks + r.islands.each[1].blocks, r.counts.free_blocks);
        CHECK_INT(r.islands.of[r.islands.each[1].block], 1);
        for (int32_t i = 0; i < s.count.blocks; i++) {
            const sp_real *dq = r.dq + 6 * (size_t)i;
            int goes = 0;
            for (int q = 0; q < 6; q++) goes |= dq[q] < 0 || dq[q] > 0;
            CHECK_INT(r.islands.of[i] < 0, s.block[i].fixed == SP_FIXED);
            CHECK(!goes || r.islands.of[i] == 1);
            moving += goes;
        }
        CHECK(moving > 0);
        CHECK_INT(r.effect[SP_EFFECT_TOGETHER], SP_WHY_APART);
        CHECK_INT(full(&s, NULL, &a).verdict, SP_UNSTABLE);
    }
}

/* A cube tips over the edge of a ledge, another one touches nothing: both go, as far in one unit of length as in the next. */
TEST(the_motion_of_a_stone_that_touches_nothing_has_no_unit)
{
    static const double unit[5] = { 1, 1024, 0.25, 1.0 / 1024, 1.0 / 1048576 };
    static const int32_t size[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 0, 3, 2, 1,  4, 5, 6, 7,  0, 1, 5, 4,  1, 2, 6, 5,  2, 3, 7, 6,  3, 0, 4, 7 };
    for (int k = 0; k < 5; k++) {
        const sp_capacity cap = { 3, 24, 18, 72, 1, 4, 0 };
        const sp_strength strength = sp_strength_friction(R(0.7));
        const sp_real u = R(unit[k]), foot[12] = { 0, 0, 0, R(0.4) * u, 0, 0, R(0.4) * u, u, 0, 0, u, 0 };
        sp_scene s;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        for (int b = 0; b < 3; b++) {                   /* the ledge, the one that tips, the other one */
            sp_real xyz[24];
            const sp_mesh m = { 8, 6, xyz, size, corner };
            for (int v = 0; v < 8; v++) {
                xyz[3 * v] = u * R((v % 4 == 1 || v % 4 == 2) + (b == 2 ? 5 : b ? 0 : -0.6));
                xyz[3 * v + 1] = u * R(v % 4 >= 2);
                xyz[3 * v + 2] = u * R((v >= 4) - (b == 0));
            }
            CHECK_INT(sp_scene_block(&s, &m, 2400, b ? 0 : SP_FIXED, NULL), SP_OK);
        }
        CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &strength, NULL), SP_OK);
        const sp_result r = check(&s, NULL, &test_arena);
        CHECK_INT(r.verdict, SP_UNSTABLE);
        CHECK_INT(r.islands.count, 2);
        CHECK_INT(r.extremes.weakest, 0);
        CHECK_NEAR(r.dq[6 * 1 + 4], 1, TOL(1e-6, 1e-3));
        CHECK_NEAR(r.dq[6 * 2 + 2], -unit[k] * sqrt(0.75), TOL(1e-6, 1e-3));            /* as far as half its diagonal */
    }
}

/* Two stones tip off ledges of their own, the second `share` as large: both move, as each does alone. */
TEST(the_motion_of_a_smaller_island_beside_a_larger_one_was_dropped)
{
    static const double share[] = { 1, 0.7, 0.5, 0.3, 0.1, 0.01 }, over[] = { 0.55, 0.6, 0.7, 0.9 };
    for (int k = 0; k < 24; k++) {
        const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 0 };
        const sp_strength strength = sp_strength_friction(R(0.7));
        const double r = share[k / 4];
        const sp_real ground[3] = { 0, 0, -9 }, a[3] = { R(0.9), 0, R(0.5) }, b[3] = { R(20 + over[k % 4] * r), 0, R(r / 2) };
        sp_scene s;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, 1000, a, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, R(1000 * r * r * r), b, 0, NULL), SP_OK);
        for (int j = 0; j < 2; j++) {
            const sp_real h = R(j ? r / 2 : 0.5), x = R(j ? 20 : 0);
            const sp_real foot[12] = { x - h, -h, 0, x + h, -h, 0, x + h, h, 0, x - h, h, 0 };
            CHECK_INT(sp_scene_joint(&s, 0, 1 + j, 4, foot, &strength, NULL), SP_OK);
        }
        const sp_result found = check(&s, NULL, &test_arena);
        CHECK_INT(found.verdict, SP_UNSTABLE);
        CHECK_INT(found.islands.count, 2);
        for (int i = 0; i < 2; i++) {
            CHECK_INT(found.islands.each[i].verdict, SP_UNSTABLE);
            CHECK(fabs((double)found.dq[6 * (1 + i) + 4]) > 1e-6);
        }
    }
}

TEST(each_island_keeps_its_own_verdict_and_the_worst_is_that_of_all)
{
    static const struct { double left, right; sp_verdict verdict[3]; } want[] = {
        { 0.3, 0.4, { SP_STABLE, SP_STABLE, SP_STABLE } },      { 0.6, 0.4, { SP_UNSTABLE, SP_STABLE, SP_UNSTABLE } },
        { 0.6, 0.7, { SP_UNSTABLE, SP_UNSTABLE, SP_UNSTABLE } }, { 0.5, 0.4, { SP_UNDECIDED, SP_STABLE, SP_UNDECIDED } },
        { 0.5, 0.6, { SP_UNDECIDED, SP_UNSTABLE, SP_UNSTABLE } }
    };
    for (size_t k = 0; k < sizeof want / sizeof want[0]; k++) {
        test_arena.used = 0;
        const sp_scene a = part("two-cubes", "offset", want[k].left, -1), b = part("two-cubes", "offset", want[k].right, -1);
        sp_scene s = room(4, 2, 8);
        add(&s, &a, 0, plain);
        add(&s, &b, 10, plain);
        sp_arena rest = test_arena;
        const sp_result r = check(&s, NULL, &rest);
        NEED(r.islands.each != NULL);
        for (int q = 0; q < 2; q++)
            if (want[k].verdict[q] != SP_UNDECIDED) CHECK_INT(r.islands.each[q].verdict, want[k].verdict[q]);
        if (want[k].verdict[0] != SP_UNDECIDED) CHECK_INT(r.verdict, want[k].verdict[2]);
        CHECK(r.islands.each[0].verdict != SP_UNSTABLE || r.verdict == SP_UNSTABLE);
        for (int32_t i = 0; r.verdict == SP_STABLE && i < 6 * s.count.blocks; i++) CHECK_WITHIN(r.dq[i], 0, 0);
        CHECK_INT(full(&s, NULL, &rest).verdict, r.verdict);
    }
}

/* What stands, what is left open within tol of its limit, what falls: in any order, of a check and of a build order. */
TEST(what_falls_is_worse_than_what_is_open_and_that_worse_than_what_stands)
{
    static const struct { const char *name, *param; double value; } of[3] = {
        { "two-cubes", "offset", 0.3 }, { "overhang", "factor", 1 + 2e-9 }, { "overhang", "factor", 1.1 } };
    static const int bad[3] = { 1, 0, 2 };              /* UNDECIDED, STABLE, UNSTABLE */
    for (int k = 0; k < 27; k++) {
        const int which[3] = { k % 3, k / 3 % 3, k / 9 };
        sp_verdict worst = SP_STABLE;
        int near = 0;
        test_arena.used = 0;
        sp_scene s = room(20, 20, 80);
        for (int q = 0; q < 3; q++) {
            const sp_scene a = part(of[which[q]].name, of[which[q]].param, of[which[q]].value, -1);
            add(&s, &a, 10 * q, plain);
        }
        sp_arena rest = test_arena;
        const sp_result r = check(&s, NULL, &rest);
        CHECK_INT(r.islands.count, 3);
        NEED(r.islands.each != NULL);
        for (int q = 0; q < 3; q++) {
            const sp_verdict v = r.islands.each[q].verdict;
            near |= which[q] == 1;
            if (which[q] != 1) CHECK_INT(v, which[q] ? SP_UNSTABLE : SP_STABLE);
            if (bad[v] > bad[worst]) worst = v;
        }
        CHECK_INT(r.verdict, worst);
#ifndef SP_EXACT_ONLY
        sp_sequence *order;
        sp_presence who[20];
        sp_step step;
        for (int b = 0; b < 20; b++) who[b] = SP_PRESENT;
        rest = test_arena;
        NEED(sp_sequence_open(&s, NULL, &rest, &order) == SP_OK);
        NEED(sp_sequence_fill(order, who, &step) == SP_OK);
        CHECK_INT(step.islands, 3);
        if (!near) CHECK_INT(step.verdict, worst);
        if (which[0] == 2 || which[1] == 2 || which[2] == 2) CHECK_INT(step.verdict, SP_UNSTABLE);
        CHECK_INT(step.block >= 0, step.verdict != SP_STABLE);
#endif
    }
}

/* Piles of boxes that touch nothing but what is under them, some off their base. */
static sp_scene piles(int32_t count, manner m)
{
    const sp_real down[3] = { 0, 0, R(-m.length) };
    sp_scene s = room(1 + 6 * count, 6 * count, 24 * count);
    for (int k = 0; k < 3; k++) s.gravity[k] *= R(m.length);
    CHECK_INT(sp_scene_body(&s, 0, down, SP_FIXED, NULL), SP_OK);
    for (int32_t p = 0; p < count; p++) {
        const int32_t high = test_random_int(1, 6);
        double x = 10 * p, y = 0;
        for (int32_t k = 0, below = 0; k < high; k++) {
            const double most = p % 3 ? 0.2 : 0.45;
            const double dx = (double)test_random_real(-most, most), dy = (double)test_random_real(-most, most);
            const double l = m.length, lo = k ? (dx > 0 ? dx : 0) : 0, hi = k ? (dx > 0 ? 1 : 1 + dx) : 1;
            const double near = k ? (dy > 0 ? dy : 0) : 0, far = k ? (dy > 0 ? 1 : 1 + dy) : 1;
            const sp_real foot[12] = { R(l * (x + lo)), R(l * (y + near)), R(l * k), R(l * (x + hi)), R(l * (y + near)), R(l * k),
                                       R(l * (x + hi)), R(l * (y + far)), R(l * k), R(l * (x + lo)), R(l * (y + far)), R(l * k) };
            const sp_strength strength = sp_strength_friction(R(0.6));
            if (k) { x += dx; y += dy; }
            const sp_real c[3] = { R(l * (x + 0.5)), R(l * (y + 0.5)), R(l * (k + 0.5)) };
            int32_t id = 0;
            CHECK_INT(sp_scene_body(&s, R(m.mass * 1000), c, 0, &id), SP_OK);
            CHECK_INT(sp_scene_joint(&s, below, id, 4, foot, &strength, NULL), SP_OK);
            below = id;
        }
    }
    return s;
}

TEST(islands_solved_apart_and_together_agree_and_their_memory_is_exact)
{
    int32_t stable = 0, unstable = 0;
    for (int32_t k = 0; k < 60; k++) {
        size_t bytes = 0;
        test_arena.used = 0;
        sp_scene s = piles(1 + k % 5, k % 2 ? other : plain);
        if (k % 7 == 0) {
            const sp_load load = { s.count.blocks - 1, 0, { 0, 0, 0 }, { R(3), 0, R(-50) }, { 0, 0, 0 }, 0 };
            CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        }
        NEED(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes) == SP_OK);
        sp_arena exact = test_arena, all = test_arena;
        exact.base += (exact.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        exact.used = exact.peak = 0;
        exact.capacity = bytes;
        const sp_arena fresh = exact;
        sp_result r, other_way;
        CHECK_INT(sp_check(&s, NULL, &exact, &r), SP_OK);
        CHECK_INT(r.spent.peak_bytes, bytes);
        const sp_verdict verdict = r.verdict;
        exact = fresh;
        exact.capacity = bytes - 1;
        CHECK_INT(sp_check(&s, NULL, &exact, &other_way), SP_E_MEMORY);
        CHECK_INT(exact.used, 0);
        CHECK_INT(full(&s, NULL, &all).verdict, verdict);
        stable += verdict == SP_STABLE;
        unstable += verdict == SP_UNSTABLE;
    }
    CHECK(stable > 5 && unstable > 5);
}

TEST(a_coupled_check_of_islands_answers_as_of_the_whole)
{
    static const double mu[] = { 0.84, 1.2 };
    for (int k = 0; k < 2; k++) {
        test_arena.used = 0;
        const sp_scene h = part("h-model", NULL, 0, mu[k]), c = part("two-cubes", NULL, 0, -1);
        sp_scene s = room(h.count.blocks + 2, h.count.joints + 1, h.count.points + 4);
        sp_settings set = sp_settings_default();
        add(&s, &h, 0, plain);
        add(&s, &c, 50, plain);
        set.coupled.asked = 1;
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), f = full(&s, &set, &a);
        CHECK_INT(r.islands.count, 2);
        CHECK_INT(f.islands.count, 1);
        CHECK_INT(r.coupled.verdict, f.coupled.verdict);
        CHECK_INT(r.verdict, f.verdict);
    }
}

#ifndef SP_NO_CRA
/* An arena of `bytes` behind what is taken of test_arena. */
static sp_arena behind(size_t bytes)
{
    sp_arena a = test_arena;
    a.base += (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    a.used = a.peak = 0;
    a.capacity = bytes;
    return a;
}

TEST(seven_h_models_side_by_side_are_refuted_each_and_verified_in_the_memory_told)
{
    const sp_scene h = part("h-model", NULL, 0, 0.45);
    sp_scene s = room(7 * h.count.blocks, 7 * h.count.joints, 7 * h.count.points);
    sp_settings set = sp_settings_default();
    sp_evidence e;
    for (int k = 0; k < 7; k++) add(&s, &h, 20 * k, plain);
    set.coupled.asked = set.localise = 1;
    set.localise = 0;
    CHECK(s.count.points > SP_EXACT_POINTS);
    sp_arena a = test_arena;
    sp_result r = check(&s, &set, &a);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.reason, SP_REASON_NO_MOTION);
    CHECK_INT(r.coupled.verdict, SP_COUPLING_REFUTED);
    CHECK(r.coupled.margin > 0 && r.verified);
    CHECK_INT(r.islands.count, 7);
    for (int32_t k = 0; k < r.islands.count; k++) {
        CHECK_INT(r.islands.each[k].verdict, SP_UNSTABLE);
        CHECK_INT(r.islands.each[k].reason, SP_REASON_NO_MOTION);
        CHECK_INT(r.islands.each[k].coupling, SP_COUPLING_REFUTED);
        CHECK_INT(r.islands.each[k].coupling_reason, SP_COUPLING_NO_MOTION);
    }
    test_arena = a;
    a = behind(test_bytes(&s, SP_FOR_VERIFY, NULL));
    CHECK_INT(sp_verify(&s, &set, &r, a, &e), SP_OK);
    CHECK_INT(e.verdict, SP_UNSTABLE);
    CHECK(e.margin > 0);
    static const int32_t wrong[] = { 0, -1, 8, INT32_MAX, INT32_MIN };  /* a proof of what it is not of */
    for (int k = 0; k < 5; k++) {
        r.coupled.proof.island = wrong[k];
        CHECK_INT(sp_verify(&s, &set, &r, a, &e), SP_OK);
        CHECK_INT(e.verdict, SP_STABLE);
        CHECK(!(e.margin > 0));
    }
}

TEST(an_island_whose_coupled_check_is_open_leaves_that_of_the_whole_open)
{
    const sp_scene h = part("h-model", NULL, 0, 0.45), c = part("two-cubes", NULL, 0, -1);
    sp_scene s = room(h.count.blocks + c.count.blocks, h.count.joints + c.count.joints, h.count.points + c.count.points);
    sp_settings set = sp_settings_default();
    add(&s, &h, 0, plain);
    add(&s, &c, 50, plain);
    set.coupled.asked = 1;
    set.coupled.nodes = 0;                              /* nothing is decided */
    sp_arena a = test_arena;
    const sp_result r = check(&s, &set, &a);
    CHECK_INT(r.islands.count, 2);
    CHECK_INT(r.islands.each[0].coupling, SP_COUPLING_NOT_FOUND);
    CHECK_INT(r.islands.each[1].coupling, SP_COUPLING_COUPLED);
    CHECK_INT(r.coupled.verdict, SP_COUPLING_NOT_FOUND);
    CHECK_INT(r.coupled.reason, r.islands.each[0].coupling_reason);
    CHECK(r.coupled.reason != SP_COUPLING_STATICS && r.coupled.reason != SP_COUPLING_NONE);
    CHECK_INT(r.verdict, SP_UNDECIDED);
}

TEST(what_refutes_one_island_is_no_proof_against_another)
{
    const sp_scene h = part("h-model", NULL, 0, 0.45), c = part("two-cubes", NULL, 0, -1);
    sp_scene s = room(2 * h.count.blocks + 4, 2 * h.count.joints + 2, 2 * h.count.points + 8);
    sp_settings set = sp_settings_default();
    sp_evidence e;
    set.coupled.asked = set.localise = 1;
    for (int k = 0; k < 2; k++) {
        add(&s, &c, 50 * k, plain);
        add(&s, &h, 50 * k + 20, plain);
    }
    for (int32_t k = 0; k < 2; k++) s.joint[s.count.joints - 1 - k].strength.mu = R(1.2);      /* the last of them jams */
    sp_arena a = test_arena;
    sp_result r = check(&s, &set, &a);
    CHECK_INT(r.islands.count, 4);
    CHECK_INT(r.coupled.verdict, SP_COUPLING_REFUTED);
    CHECK_INT(r.coupled.proof.island, 2);
    for (int32_t k = 0; k < 4; k++) CHECK_INT(r.islands.each[k].verdict, k == 1 ? SP_UNSTABLE : SP_STABLE);
    for (int32_t k = 1; k <= 4; k++) {
        r.coupled.proof.island = k;
        CHECK_INT(sp_verify(&s, &set, &r, a, &e), SP_OK);
        CHECK_INT(e.margin > 0, k == 2);
    }
}

/* A block on a level joint of so many corners; where `aside`, another that touches nothing. */
static sp_scene on_corners(int32_t corners, int aside)
{
    const sp_real ground[3] = { 0, 0, R(-1) }, middle[3] = { 0, 0, R(0.5) }, far[3] = { R(9), 0, R(0.5) };
    const sp_strength strength = sp_strength_friction(R(0.6));
    sp_real xyz[3 * (SP_EXACT_POINTS + 1)];
    test_arena.used = 0;
    sp_scene s = room(3, 1, corners);
    for (int32_t k = 0; k < corners; k++) {             /* on a parabola and the chord that shuts it */
        xyz[3 * k] = R(2.0 * k / (corners - 1) - 1);
        xyz[3 * k + 1] = xyz[3 * k] * xyz[3 * k] - R(0.5);
        xyz[3 * k + 2] = 0;
    }
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, R(1000), middle, 0, NULL), SP_OK);
    if (aside) CHECK_INT(sp_scene_body(&s, R(1000), far, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, corners, xyz, &strength, NULL), SP_OK);
    return s;
}

/* So many blocks, one point between each of the first `linked` and the next. */
static sp_scene chain(int32_t blocks, int32_t linked)
{
    const sp_real along[3] = { R(1), 0, 0 };
    const sp_strength strength = sp_strength_friction(R(0.6));
    test_arena.used = 0;
    sp_scene s = room(blocks, linked, linked);
    for (int32_t k = 0; k < blocks; k++) {
        const sp_real c[3] = { R(k), 0, 0 };
        CHECK_INT(sp_scene_body(&s, R(1000), c, 0, NULL), SP_OK);
    }
    for (int32_t k = 0; k < linked; k++) {
        const sp_real at[3] = { R(k + 0.5), 0, 0 };
        CHECK_INT(sp_scene_points(&s, k, k + 1, along, 1, at, &strength, NULL), SP_OK);
    }
    return s;
}

/* sp_verify of a claim of a proof of one leaf that holds nothing, with so many bytes less than sp_memory tells. */
static sp_status judged_with_less(const sp_scene *s, int32_t island, size_t less)
{
    static int32_t node[1] = { -1 };
    static uint16_t row[1];
    static sp_real f[3 * (SP_EXACT_POINTS + 1)], dq[6 * 256], y[1];
    sp_settings set = sp_settings_default();
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
    sp_result r;
    memset(&r, 0, sizeof r);
    CHECK(s->count.points <= SP_EXACT_POINTS + 1 && s->count.blocks <= 256);
    r.f = f;
    r.dq = dq;
    r.coupled.proof.nodes = r.coupled.proof.leaves = r.coupled.proof.entries = 1;
    r.coupled.proof.island = island;
    r.coupled.proof.node = node;
    r.coupled.proof.row = row;
    r.coupled.proof.y = y;
    set.coupled.asked = set.localise = 1;
    set.faces = 64;                                     /* what SP_FOR_VERIFY is told for */
    const sp_status status = sp_verify(s, &set, &r, behind(test_bytes(s, SP_FOR_VERIFY, NULL) - less), &e);
    CHECK(!(e.margin > 0));
    return status;
}

/* A proof that does not fit is not taken for none: it is judged in the memory told, refused in a byte less. Of an island that
 * is the whole scene the memory told is what it takes. */
TEST(a_proof_is_judged_in_the_memory_told_and_refused_in_a_byte_less)
{
    for (int32_t corners = 3; corners <= SP_EXACT_POINTS; corners += 15) {
        const sp_scene s = on_corners(corners, 0);
        CHECK_INT(judged_with_less(&s, 1, 0), SP_OK);
        CHECK_INT(judged_with_less(&s, 1, 1), SP_E_MEMORY);
        CHECK_INT(judged_with_less(&s, 0, 0), SP_OK);
        CHECK_INT(judged_with_less(&s, 2, 0), SP_OK);
    }
}

TEST(a_proof_of_a_chain_is_judged_in_the_memory_told_and_refused_in_a_byte_less)
{
    for (int32_t blocks = 2; blocks <= SP_EXACT_POINTS; blocks += 23) {
        const sp_scene s = chain(blocks, blocks - 1);
        CHECK_INT(judged_with_less(&s, 1, 0), SP_OK);
        CHECK_INT(judged_with_less(&s, 1, 1), SP_E_MEMORY);
    }
}

/* One corner or one block more than a proof may be of: it needs less, and says nothing. */
TEST(what_is_too_large_for_a_proof_is_told_in_less_memory)
{
    for (int32_t aside = 0; aside < 2; aside++) {
        const sp_scene most = on_corners(SP_EXACT_POINTS, aside);
        CHECK_INT(judged_with_less(&most, 1, 0), SP_OK);
        CHECK_INT(judged_with_less(&most, 0, 0), SP_OK);
        CHECK_INT(judged_with_less(&most, 0, 9000), SP_E_MEMORY);
        const sp_scene more = on_corners(SP_EXACT_POINTS + 1, aside);
        CHECK_INT(judged_with_less(&more, 1, 9000), SP_OK);
        CHECK_INT(judged_with_less(&more, 0, 9000), SP_OK);
    }
    const sp_scene too_long = chain(SP_EXACT_POINTS + 1, SP_EXACT_POINTS);
    CHECK_INT(judged_with_less(&too_long, 1, 9000), SP_OK);
}

/* Islands of one block beside one that is a chain: the whole takes more than any of them. */
TEST(a_proof_of_loose_blocks_is_judged_in_the_memory_of_the_whole)
{
    for (int32_t linked = 0; linked <= SP_EXACT_POINTS + 1; linked++) {
        if (linked > 0 && linked < SP_EXACT_POINTS) continue;
        const sp_scene loose = chain(160, linked);
        CHECK_INT(judged_with_less(&loose, 160 - linked, 0), SP_OK);
        CHECK_INT(judged_with_less(&loose, 0, 0), SP_OK);
        CHECK_INT(judged_with_less(&loose, 0, 1), SP_E_MEMORY);
    }
}

/* One of several scenes that are coupled, refuted, fall, or hang between. */
static sp_scene some_part(void)
{
    static const struct { const char *name, *param; double from, to, low, high; } kind[] = {
        { "h-model", NULL, 0, 0, 0.7, 1.2 },            { "two-cubes", "offset", 0, 0.55, 0.6, 0.9 },
        { "incline", "angle", 0, 50, 0.5, 0.9 },        { "overhang", "factor", 0.8, 1.1, 0.6, 0.6 },
        { "tower", "lean", 0, 0.1, 0.6, 0.6 },          { "flat-arch", "height", 0.2, 0.6, 0, 0.9 }
    };
    const int32_t k = test_random_int(0, 5);
    sp_scene s;
    gen_scene g;
    memset(&s, 0, sizeof s);
    CHECK_INT(gen_open(&g, kind[k].name), 1);
    if (kind[k].param) CHECK_INT(gen_set(&g, kind[k].param, (double)test_random_real(kind[k].from, kind[k].to)), 1);
    if (k > 2) CHECK_INT(gen_set(&g, "n", k == 5 ? 3 : 4), 1);
    CHECK_INT(gen_set(&g, "mu", (double)test_random_real(kind[k].low, kind[k].high)), 1);
    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
    return s;
}

/* An island's forces from its first joint on are those of a check of it alone, but for the rounding of a unit. */
static int same_forces(const sp_result *r, int32_t point, const sp_result *alone, int32_t points)
{
    double far = 0, most = 0;
    for (size_t k = 0; k < 3 * (size_t)points; k++) {
        far = fmax(far, fabs((double)(r->f[3 * (size_t)point + k] - alone->f[k])));
        most = fmax(most, fabs((double)alone->f[k]));
    }
    return far <= 8 * (double)SP_EPSILON * most;
}

/* A check in no more than sp_memory tells, exactly that where it localises, and not in a byte less if `tight`. Its arrays stay. */
static sp_result checked_exactly(const sp_scene *s, const sp_settings *set, int tight)
{
    sp_result r = { 0 };
    size_t bytes = 0;
    CHECK_INT(sp_memory(s, SP_FOR_CHECK, set, test_arena, &bytes), SP_OK);
    sp_arena a = behind(bytes);
    CHECK_INT(sp_check(s, set, &a, &r), SP_OK);
    if (set->localise) CHECK_INT((int64_t)r.spent.peak_bytes, (int64_t)bytes);
    CHECK(r.spent.peak_bytes <= bytes);
    a = behind(r.spent.peak_bytes - 1);
    if (tight) CHECK_INT(sp_check(s, set, &a, &r), SP_E_MEMORY);
    a = behind(bytes);
    if (tight) CHECK_INT(sp_check(s, set, &a, &r), SP_OK);
    CHECK(bytes <= SP_MEMORY_BYTES(s->count.blocks, s->count.joints, s->count.points, 0)
                   + SP_COUPLED_BYTES(s->count.blocks, s->count.points, 48000));
    test_arena.used += bytes + SP_ALIGN;
    return r;
}

static void claim_holds(const sp_scene *s, const sp_settings *set, const sp_result *r)
{
    sp_evidence e;
    sp_arena scratch = behind(test_bytes(s, SP_FOR_VERIFY, NULL));
    CHECK_INT(sp_verify(s, set, r, scratch, &e), SP_OK);
    CHECK(r->verdict == SP_UNDECIDED || e.verdict == r->verdict);
    CHECK(r->verdict != SP_STABLE || (e.level == SP_COUPLED && r->level == SP_COUPLED));
}

/* Island q of r, whose contact vertices begin at `first`, against a check of that piece alone.     returns its verdict */
static sp_verdict as_alone(const sp_result *r, int32_t q, int32_t first, const sp_scene *piece, sp_settings set, int32_t seen[4])
{
    const sp_island *p = &r->islands.each[q];
    sp_scene alone = room(piece->count.blocks, piece->count.joints, piece->count.points);
    add(&alone, piece, 0, plain);
    set.coupled.eps = r->coupled.eps;
    set.coupled.eta = 0;                                /* 100 eps, as of the whole */
    sp_arena rest = test_arena;
    const sp_result o = check(&alone, &set, &rest);
    CHECK_INT(p->verdict, o.verdict);
    CHECK_INT(p->reason, o.reason);
    CHECK_INT(p->coupling, o.coupled.verdict);
    CHECK_INT(p->coupling_reason, o.coupled.reason);
    if (o.coupled.verdict == SP_COUPLING_COUPLED) CHECK(same_forces(r, first, &o, alone.count.points));
    seen[o.coupled.verdict]++;
    return o.verdict;
}

TEST(a_coupled_check_tells_of_each_island_what_it_says_of_that_alone_and_of_all_what_it_says_of_the_whole)
{
    int32_t coupled = 0, refuted = 0, open = 0, whole = 0, beyond = 0, seen[4] = { 0, 0, 0, 0 };
    for (int32_t k = 0; k < SOME_OF(24, 8); k++) {
        sp_scene piece[5], s;
        const int32_t pieces = test_random_int(2, 5);
        int32_t blocks = 0, joints = 0, points = 0;
        sp_settings set = sp_settings_default();
        test_arena.used = 0;
        for (int32_t q = 0; q < pieces; q++) {
            piece[q] = some_part();
            blocks += piece[q].count.blocks; joints += piece[q].count.joints; points += piece[q].count.points;
        }
        s = room(blocks, joints, points);
        for (int32_t q = 0; q < pieces; q++) add(&s, &piece[q], 0, plain);
        set.coupled.asked = 1;
        set.localise = k % 3 != 0;
        const sp_result r = checked_exactly(&s, &set, k < SOME_OF(3, 1));
        NEED(r.islands.count == pieces);
        claim_holds(&s, &set, &r);
        sp_verdict worst = SP_STABLE;
        for (int32_t q = 0, first = 0; q < pieces; first += piece[q].count.points, q++) {
            const sp_verdict alone = as_alone(&r, q, first, &piece[q], set, seen);
            if (alone == SP_UNSTABLE || worst == SP_STABLE) worst = alone;
        }
        CHECK_INT(r.verdict, worst);
        coupled += r.verdict == SP_STABLE;
        refuted += r.reason == SP_REASON_NO_MOTION;
        open += r.verdict == SP_UNDECIDED;
        if (k < SOME_OF(0, 1) || k >= SOME_OF(8, 3)) continue;
        sp_arena rest = test_arena;
        set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
        set.coupled.nodes = 1000;
        set.localise = 0;
        const sp_result f = check(&s, &set, &rest);
        CHECK_INT(f.islands.count, 1);
        CHECK(f.verdict == r.verdict || f.verdict == SP_UNDECIDED);
        whole++;
        beyond += f.verdict != r.verdict;
    }
    TEST_PRINT("    %ld coupled, %ld refuted, %ld open; of %ld asked of the whole %ld are decided by islands only\n", (long)coupled,
               (long)refuted, (long)open, (long)whole, (long)beyond);
    CHECK(coupled > SOME_OF(5, 1) && refuted > SOME_OF(2, 0) && beyond < whole);
    CHECK(seen[SP_COUPLING_COUPLED] > SOME_OF(20, 5) && seen[SP_COUPLING_REFUTED] > SOME_OF(TOL(20, 5), TOL(3, 0)));
}
#endif

TEST(supports_join_nothing_and_contacts_between_them_take_no_part)
{
    const sp_real low[3] = { 0, 0, R(-1) }, high[3] = { R(1), 0, R(-1) };
    const sp_real side[12] = { R(0.5), 0, R(-2), R(0.5), R(1), R(-2), R(0.5), R(1), 0, R(0.5), 0, 0 };
    const sp_strength strength = sp_strength_friction(R(0.6));
    sp_scene s = room(4, 3, 12);
    CHECK_INT(sp_scene_body(&s, 0, low, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, high, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(&s, 0, 1, 4, side, &strength, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const sp_real c[3] = { R(k), 0, R(0.5) };
        const sp_real foot[12] = { R(k - 0.4), R(-0.4), 0, R(k + 0.4), R(-0.4), 0, R(k + 0.4), R(0.4), 0, R(k - 0.4), R(0.4), 0 };
        CHECK_INT(sp_scene_body(&s, R(1000), c, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 2 + k, 4, foot, &strength, NULL), SP_OK);
    }
    sp_arena a = test_arena;
    const sp_result r = check(&s, NULL, &a);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.islands.count, 2);
    CHECK_INT(r.counts.joints, 2);
}

TEST_LIST(islands)
    RUN(of_two_islands_the_one_that_falls_is_named_and_moves_alone)
    RUN(the_motion_of_a_stone_that_touches_nothing_has_no_unit)
    RUN(the_motion_of_a_smaller_island_beside_a_larger_one_was_dropped)
    RUN(each_island_keeps_its_own_verdict_and_the_worst_is_that_of_all)
    RUN(what_falls_is_worse_than_what_is_open_and_that_worse_than_what_stands)
    RUN(islands_solved_apart_and_together_agree_and_their_memory_is_exact)
    RUN(a_coupled_check_of_islands_answers_as_of_the_whole)
#ifndef SP_NO_CRA
    RUN(seven_h_models_side_by_side_are_refuted_each_and_verified_in_the_memory_told)
    RUN(an_island_whose_coupled_check_is_open_leaves_that_of_the_whole_open)
    RUN(what_refutes_one_island_is_no_proof_against_another)
    RUN(a_proof_is_judged_in_the_memory_told_and_refused_in_a_byte_less)
    RUN(a_proof_of_a_chain_is_judged_in_the_memory_told_and_refused_in_a_byte_less)
    RUN(what_is_too_large_for_a_proof_is_told_in_less_memory)
    RUN(a_proof_of_loose_blocks_is_judged_in_the_memory_of_the_whole)
    RUN(a_coupled_check_tells_of_each_island_what_it_says_of_that_alone_and_of_all_what_it_says_of_the_whole)
#endif
    RUN(supports_join_nothing_and_contacts_between_them_take_no_part)
TEST_END
