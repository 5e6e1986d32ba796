/* The exact decision of the coupled check: what has no triple is refuted with a proof that sp_verify checks, and a proof proves
 * nothing but its own scene. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>
#include <string.h>

static void build(const char *name, const char *param, double value, double mu, sp_scene *scene)
{
    gen_scene g;
    CHECK_INT(gen_open(&g, name), 1);
    if (param) CHECK_INT(gen_set(&g, param, value), 1);
    CHECK_INT(gen_set(&g, "mu", mu), 1);
    CHECK_INT(gen_build(&g, &test_arena, scene), SP_OK);
}

/* A block of height h squeezed between walls w = 1 apart. */
static void squeeze(double h, double mu, sp_scene *scene)
{
    gen_scene g;
    CHECK_INT(gen_open(&g, "keystone"), 1);
    CHECK_INT(gen_set(&g, "angle", 0), 1);
    CHECK_INT(gen_set(&g, "height", h), 1);
    CHECK_INT(gen_set(&g, "mu", mu), 1);
    CHECK_INT(gen_build(&g, &test_arena, scene), SP_OK);
}

static sp_settings coupled(double ratio, int box)
{
    sp_settings set = sp_settings_default();
    set.coupled.asked = 1;
    set.coupled.eps = R(1e-3);
    set.coupled.eta = R(ratio * 1e-3);
    set.coupled.box = box;
    return set;
}

/* Float has too few digits for some proofs: there it may be silent, but not wrong. */
static int refuted(sp_coupling found) { return found == SP_COUPLING_REFUTED || (TOL(0, 1) && found == SP_COUPLING_NOT_FOUND); }

/* Check and verify; a refuted one brings its proof and is unstable, for both. */
static sp_coupling decided(const sp_scene *s, const sp_settings *set, sp_result *r)
{
    sp_evidence e;
    CHECK_INT(sp_check(s, set, &test_arena, r), SP_OK);
    CHECK_INT(sp_verify(s, set, r, test_arena, &e), SP_OK);
    CHECK((r->coupled.verdict == SP_COUPLING_REFUTED) == (r->verdict == SP_UNSTABLE));
    CHECK((r->coupled.margin > 0) == (r->reason == SP_REASON_NO_MOTION));
    CHECK((r->coupled.proof.nodes > 0) == (r->reason == SP_REASON_NO_MOTION));
    CHECK_INT(e.verdict == SP_UNSTABLE, r->verdict == SP_UNSTABLE);
    CHECK_NEAR(e.margin, r->coupled.margin, TOL(1e-6, 1e-2));
    return r->coupled.verdict;
}

TEST(the_h_model_is_refused_with_a_proof)
{
    static const double mu[3] = { 0.01, 0.45, 0.84 };
    for (int k = 0; k < 6; k += SOME_OF(1, 2)) {
        sp_scene s;
        sp_result r;
        const sp_settings set = coupled(10, k / 3);
        test_arena.used = 0;
        build("h-model", NULL, 0, mu[k % 3], &s);
        CHECK(refuted(decided(&s, &set, &r)));
        CHECK_INT(r.verified, r.reason == SP_REASON_NO_MOTION);
    }
}

/* Friction jams the block across its diagonal from mu = 2h/w on, and only if it may sink and turn so far: eta / eps = 2w/h. */
TEST(a_squeezed_block_is_refuted_up_to_its_limits_and_coupled_beyond)
{
    static const double off[4] = { TOL(-1e-3, -0.05), TOL(1e-3, 0.05), -0.1, 0.1 };
    for (int k = 0; k < 16; k++) {
        const double h = k & 4 ? 0.42 : 0.3, by = 1 + off[k % 4];
        const sp_settings set = coupled(k & 8 ? 2 / h * by : 100, 1);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        squeeze(h, k & 8 ? 2 * h * 1.2 : 2 * h * by, &s);
        const sp_coupling found = decided(&s, &set, &r);
        CHECK(by < 1 ? refuted(found) : found == SP_COUPLING_COUPLED);
    }
}

TEST(the_verdict_knows_no_units)
{
    for (int k = 0; k < 4; k++) {
        static const double size[4] = { 1e-2, 1, 1e3, 1 };
        sp_scene s;
        sp_result r;
        sp_settings set = coupled(20, 1);
        test_arena.used = 0;
        gen_scene g;
        CHECK_INT(gen_open(&g, "keystone"), 1);
        CHECK_INT(gen_set(&g, "angle", 0), 1);
        CHECK_INT(gen_set(&g, "width", size[k]), 1);
        CHECK_INT(gen_set(&g, "depth", size[k]), 1);
        CHECK_INT(gen_set(&g, "height", 0.42 * size[k]), 1);
        CHECK_INT(gen_set(&g, "density", k == 3 ? 1e-3 : 1e3), 1);
        CHECK_INT(gen_set(&g, "mu", 0.8), 1);
        CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
        set.coupled.eps *= R(size[k]);
        set.coupled.eta *= R(size[k]);
        CHECK(refuted(decided(&s, &set, &r)));
    }
}

static void side(sp_scene *s, int32_t a, int32_t b, double x, double low, double high)
{
    const sp_strength strength = sp_strength_friction(R(0.6));
    const sp_real xyz[12] = { R(x), R(-0.2), R(low), R(x), R(0.2), R(low), R(x), R(0.2), R(high), R(x), R(-0.2), R(high) };
    CHECK_INT(sp_scene_joint(s, a, b, 4, xyz, &strength, NULL), SP_OK);
}

/* Wall and floor fixed, an upright block on the floor, a beam between wall and block that nothing squeezes: statics lets
 * the friction of the upright press the beam, no motion explains why it should. */
TEST(a_beam_snug_between_a_wall_and_a_free_block_is_refused)
{
    static const sp_capacity cap = { 4, 0, 0, 0, 3, 12, 0 };
    const sp_real wall[3] = { R(-1.1), 0, 1 }, beam[3] = { R(0), 0, R(0.6) }, upright[3] = { R(1.5), 0, R(0.5) };
    const sp_real floor[12] = { 1, R(-0.2), 0, 2, R(-0.2), 0, 2, R(0.2), 0, 1, R(0.2), 0 };
    const sp_strength strength = sp_strength_friction(R(0.6));
    sp_settings set = coupled(3, 0);
    sp_scene s;
    sp_result r;
    NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
    NEED(sp_scene_body(&s, 1, wall, SP_FIXED, NULL) == SP_OK);
    NEED(sp_scene_body(&s, 10, beam, 0, NULL) == SP_OK);
    NEED(sp_scene_body(&s, 20, upright, 0, NULL) == SP_OK);
    side(&s, 0, 1, -1, 0.5, 0.7);
    side(&s, 1, 2, 1, 0.5, 0.7);
    NEED(sp_scene_joint(&s, 0, 2, 4, floor, &strength, NULL) == SP_OK);
    set.coupled.asked = 0;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    set.coupled.asked = 1;
    CHECK(refuted(decided(&s, &set, &r)));
}

/* A block of 125 kg at rest between triangles of a fixed one, corners in cm, anticlockwise seen from the block. */
typedef struct wedged { double mu; int joints, cm[3][9]; } wedged;

static void hold(const wedged *w, sp_scene *s)
{
    static const sp_capacity cap = { 2, 0, 0, 0, 3, 9, 0 };
    const sp_real far[3] = { -9, -9, -9 }, origin[3] = { 0, 0, 0 };
    const sp_strength strength = sp_strength_friction(R(w->mu));
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(s, 1000, far, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(s, 125, origin, 0, NULL), SP_OK);
    for (int k = 0; k < w->joints; k++) {
        sp_real xyz[9];
        for (int q = 0; q < 9; q++) xyz[q] = R(w->cm[k][q] / 100.0);
        CHECK_INT(sp_scene_joint(s, 0, 1, 3, xyz, &strength, NULL), SP_OK);
    }
}

/* The decision ends at friction without slip, and the search's springs find nothing; beside that point there are triples. */
TEST(a_triple_beside_a_point_of_friction_without_slip_is_found)
{
    static const wedged w[] = {
        { 0.4, 3, { { -26, 23, 28, -14, -4, 49, -33, -11, 19 },
                  { 13, -28, -28, 7, -40, -13, 24, -30, -11 },
                  { -12, 43, -5, 12, 40, -11, 5, 37, 13 } } },
        { 1, 3, { { -3, 40, 14, -18, 46, -7, 4, 33, -11 },
                  { 6, -24, -38, -19, -15, -46, -13, -17, -19 },
                  { -23, 42, -11, -4, 35, 18, -36, 22, 15 } } },
        { 2, 3, { { 20, -31, 33, -19, -3, 42, 25, 17, 41 },
                  { -10, 45, 1, -3, 39, -17, 8, 34, 0 },
                  { 45, -10, 16, 25, -25, -11, 21, -37, 23 } } },
        { 1, 2, { { 39, -14, 5, 43, 0, 1, 37, -9, -9 },
                  { -35, 21, 8, -28, 3, 26, -47, -2, 8 } } },
        { 2, 2, { { 37, -12, 1, 40, 8, 14, 43, 9, -10 },
                  { -30, -33, 30, -19, -43, -5, -32, -8, 1 } } } };
    for (size_t k = 0; k < sizeof w / sizeof *w; k++) {
        sp_settings set = coupled(100, 0);
        sp_scene s;
        sp_result r;
        set.coupled.eps = -1;
        set.coupled.eta = 0;
        hold(&w[k], &s);
        const sp_coupling found = decided(&s, &set, &r);
        CHECK(found == SP_COUPLING_COUPLED || (TOL(0, 1) && found == SP_COUPLING_NOT_FOUND));
        CHECK(found != SP_COUPLING_COUPLED || (r.coupled.residual <= 1 && r.imbalance <= r.tol));
    }
}

/* A block w wide, d deep and h high between two fixed faces, of a friction that is `part` of the 2h/w from which it jams. */
static void between(const double size[4], sp_scene *s)
{
    static const sp_capacity cap = { 2, 0, 0, 0, 2, 8, 0 };
    const double w = size[0], h = size[1], d = size[2];
    const sp_real far[3] = { -9, -9, -9 }, at[3] = { R(w / 2), R(d / 2), R(h / 2) };
    const sp_strength strength = sp_strength_friction(R(2 * h / w * size[3]));
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(s, 1000, far, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(s, R(1000 * w * d * h), at, 0, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const sp_real x = R(k * w), y = R(d), z = R(h), xyz[12] = { x, 0, 0, x, y, 0, x, y, z, x, 0, z };
        CHECK_INT(sp_scene_joint(s, k, 1 - k, 4, xyz, &strength, NULL), SP_OK);
    }
}

/* Between two refreshes of its basis the linear program once closed cases by multipliers of 1e9, which were rounding: the tree
 * was complete, and the certificate check refused it. Float proves few of these, and then goes through all reflections. */
TEST(the_cases_of_a_squeezed_block_are_closed_by_multipliers_that_prove_it)
{
    static const double w[] = { 0.9, 1, 1.1, 1.3 }, h[] = { 0.3, 1, 1.2, 1.5 }, d[] = { 0.3, 0.5, 0.8 }, part[] = { 0.9, 0.99 };
    for (int k = 0; k < 96; k += SOME_OF(1, TOL(1, 11))) {
        const double size[] = { w[k % 4], h[k / 4 % 4], d[k / 16 % 3], part[k / 48] };
        sp_settings set = coupled(100, 0);
        sp_scene s;
        sp_result r;
        set.coupled.eps = -1;
        set.coupled.eta = 0;
        between(size, &s);
        if (!CHECK(refuted(decided(&s, &set, &r)))) TEST_PRINT("    %g wide, %g high\n", size[0], size[1]);
    }
}

TEST(what_plainly_stands_is_never_refuted)
{
    static const char *const scenes[] = { "two-cubes", "incline", "topple", "overhang", "cantilever" };
    for (int k = 0; k < 30; k++) {
        sp_settings set = coupled(k % 2 ? 10 : 100, k / 2 % 2);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        if (k / 6 == 3) build("overhang", "n", 3, 0.84, &s);
        else build(scenes[k / 6], NULL, 0, 0.84, &s);
        if (k % 3) { set.faces = k % 3 == 1 ? 8 : 16; set.inscribed = k % 3 - 1; }
        CHECK(decided(&s, &set, &r) != SP_COUPLING_REFUTED);
    }
    sp_scene s;
    sp_result r;
    const sp_settings set = coupled(100, 1);
    test_arena.used = 0;
    build("keystone", "angle", -5, 0, &s);              /* wider above: rests on its sides, without friction */
    CHECK_INT(decided(&s, &set, &r), SP_COUPLING_COUPLED);
}

/* 16 faces around the cone make friction 1.02 of itself: the block jams from mu = 0.84 on. */
TEST(a_squeezed_block_is_refuted_by_a_pyramid_of_16_faces)
{
    for (int k = 0; k < TOL(2, 1); k++) {
        sp_settings set = coupled(100, 1);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        set.faces = 16;
        set.inscribed = !k;
        set.budget = TOL(0, 5000000);
        squeeze(0.42, 0.8, &s);
        CHECK(refuted(decided(&s, &set, &r)));
    }
}

/* Where eta is less than the least slip there is nothing rubs: on a slope of 20 degrees no triple balances, on the level one does. */
TEST(what_must_rub_needs_room_to_slip)
{
    for (int k = 0; k < 4; k++) {
        sp_settings set = coupled(k & 1 ? 1e-7 : 10, 0);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        set.budget = 2000000;                           /* forests need no search, and it finds nothing */
        build(k & 2 ? "incline" : "two-cubes", k & 2 ? "angle" : NULL, 20, 0.84, &s);
        CHECK_INT(decided(&s, &set, &r) == SP_COUPLING_COUPLED, k < 3);
    }
}

/* ------------------------------------------------------------------------------------------------------- false proofs */

enum { NODES = 4000, ENTRIES = 80000 };

static int32_t node[NODES];
static uint16_t row[ENTRIES];
static sp_real y[ENTRIES];

/* A refuted squeezed block, its proof copied to where it can be damaged. */
static void proof_of(sp_scene *s, const sp_settings *set, sp_result *r)
{
    squeeze(0.42, 0.8, s);
    NEED(sp_check(s, set, &test_arena, r) == SP_OK);
    NEED(r->coupled.verdict == SP_COUPLING_REFUTED);
    NEED(r->coupled.proof.nodes <= NODES && r->coupled.proof.entries <= ENTRIES);
    for (int32_t k = 0; k < r->coupled.proof.nodes; k++) node[k] = r->coupled.proof.node[k];
    for (int32_t k = 0; k < r->coupled.proof.entries; k++) {
        row[k] = r->coupled.proof.row[k];
        y[k] = r->coupled.proof.y[k];
    }
    r->coupled.proof.node = node;
    r->coupled.proof.row = row;
    r->coupled.proof.y = y;
}

static double margin(const sp_scene *s, const sp_settings *set, const sp_result *r)
{
    sp_evidence e;
    CHECK_INT(sp_verify(s, set, r, test_arena, &e), SP_OK);
    CHECK((e.margin > 0) == (e.verdict == SP_UNSTABLE));
    return (double)e.margin;
}

TEST(a_proof_holds_for_its_own_question_only)
{
    sp_scene s, other;
    sp_result r;
    sp_settings set = coupled(20, 1);
    proof_of(&s, &set, &r);
    CHECK(margin(&s, &set, &r) > 0);
    squeeze(0.42, 0.86, &other);
    CHECK_WITHIN(margin(&other, &set, &r), 0, 0);
    build("two-cubes", NULL, 0, 0.84, &other);
    r.dq = NULL;
    sp_result t;
    NEED(sp_check(&other, NULL, &test_arena, &t) == SP_OK);
    t.coupled = r.coupled;
    t.coupled.dq = t.coupled.alpha = NULL;
    CHECK_WITHIN(margin(&other, &set, &t), 0, 0);
}

TEST(a_proof_with_a_part_missing_or_changed_is_none)
{
    sp_scene s, stands;
    sp_result r;
    const sp_settings set = coupled(20, 1);
    proof_of(&s, &set, &r);
    squeeze(0.42, 0.86, &stands);
    r.coupled.proof.nodes--;
    CHECK_WITHIN(margin(&s, &set, &r), 0, 0);
    r.coupled.proof.nodes += 1;
    r.coupled.proof.entries--;
    CHECK_WITHIN(margin(&s, &set, &r), 0, 0);
    r.coupled.proof.entries++;
    CHECK(margin(&s, &set, &r) > 0);
    for (int k = 0; k < 300; k++) {                     /* damaged anywhere: nothing is proved of a block that can stand */
        const int32_t n = test_random_int(0, r.coupled.proof.nodes - 1), e = test_random_int(0, r.coupled.proof.entries - 1);
        const int32_t old_node = node[n];
        const uint16_t old_row = row[e];
        const sp_real old_y = y[e];
        if (k % 3 == 0) node[n] = test_random_int(-20, 12);
        if (k % 3 == 1) row[e] = (uint16_t)test_random_int(0, 250);
        if (k % 3 == 2) y[e] *= test_random_real(-2, 2);
        if (k % 50 == 2) y[e] = R(NAN);
        CHECK_WITHIN(margin(&stands, &set, &r), 0, 0);
        margin(&s, &set, &r);
        node[n] = old_node; row[e] = old_row; y[e] = old_y;
    }
    CHECK(margin(&s, &set, &r) > 0);
}

/* One leaf that would close everything, if multipliers might have any sign or rows any state. */
TEST(one_line_is_no_proof)
{
    sp_scene s;
    sp_result r;
    const sp_settings set = coupled(20, 1);
    squeeze(0.42, 0.86, &s);
    NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
    r.coupled.proof.node = node;
    r.coupled.proof.row = row;
    r.coupled.proof.y = y;
    r.coupled.proof.nodes = r.coupled.proof.entries = 1;
    node[0] = -1;
    for (int32_t q = 0; q < 7 + 24 * 8 + 2; q++)
        for (int sign = -1; sign <= 1; sign++) {
            row[0] = (uint16_t)q;
            y[0] = R(sign * 1e6);
            CHECK_WITHIN(margin(&s, &set, &r), 0, 0);
        }
}

/* ------------------------------------------------------------------------------------------------------------- its price */

TEST(without_nodes_nothing_is_decided)
{
    sp_scene s;
    sp_result r;
    sp_settings set = coupled(10, 1);
    build("h-model", NULL, 0, 0.84, &s);
    for (int32_t nodes = 0; nodes < 40; nodes += 13) {
        set.coupled.nodes = nodes;
        CHECK_INT(decided(&s, &set, &r), SP_COUPLING_NOT_FOUND);
        CHECK_INT(r.coupled.reason, SP_COUPLING_BUDGET);
        CHECK_INT(r.coupled.proof.entries, 0);
    }
}

TEST(the_memory_it_asks_for_is_what_it_takes)
{
    for (int k = 0; k < 4; k++) {
        sp_scene s;
        sp_result r;
        sp_settings set = coupled(20, 1);
        size_t bytes;
        test_arena.used = 0;
        set.coupled.nodes = k % 2 ? -1 : 300;
        squeeze(0.42, k / 2 ? 0.86 : 0.8, &s);
        NEED(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes) == SP_OK);
        sp_arena a = { test_arena.base + test_arena.used, bytes, 0, 0 };
        a.base += (size_t)(-(uintptr_t)a.base & (SP_ALIGN - 1));
        CHECK_INT(sp_check(&s, &set, &a, &r), SP_OK);
        CHECK_INT(a.peak, bytes);
        CHECK((r.coupled.proof.nodes > 0) == (r.coupled.verdict == SP_COUPLING_REFUTED));
        const sp_result was = r;
        sp_arena less = { a.base, bytes - 1, 0, 0 };
        CHECK_INT(sp_check(&s, &set, &less, &r), SP_E_MEMORY);
        CHECK_INT(less.used, 0);
        CHECK_INT(memcmp(&was, &r, sizeof r), 0);
    }
}

TEST_LIST(exact)
    RUN(the_h_model_is_refused_with_a_proof)
    RUN(a_squeezed_block_is_refuted_up_to_its_limits_and_coupled_beyond)
    RUN(the_verdict_knows_no_units)
    RUN(a_beam_snug_between_a_wall_and_a_free_block_is_refused)
    RUN(a_triple_beside_a_point_of_friction_without_slip_is_found)
    RUN(the_cases_of_a_squeezed_block_are_closed_by_multipliers_that_prove_it)
    RUN(what_plainly_stands_is_never_refuted)
    RUN(a_squeezed_block_is_refuted_by_a_pyramid_of_16_faces)
    RUN(what_must_rub_needs_room_to_slip)
    RUN(a_proof_holds_for_its_own_question_only)
    RUN(a_proof_with_a_part_missing_or_changed_is_none)
    RUN(one_line_is_no_proof)
    RUN(without_nodes_nothing_is_decided)
    RUN(the_memory_it_asks_for_is_what_it_takes)
TEST_END
