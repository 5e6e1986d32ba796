/* What a triple (f, dq, alpha) of the coupled check proves, and what it does not. */
#include "coupled.h"

/* ------------------------------------------------------------------------------------------------- what a triple proves */

enum { POINTS = 64, BLOCKS = 16 };

/* A triple for a scene with one free block, its last: forces of the check, sinking by eps, slipping by `slip` against them. */
typedef struct triple {
    sp_scene s;
    sp_settings set;
    sp_real f[3 * POINTS], dq[6 * BLOCKS], alpha[POINTS];
    sp_real *move;                      /* of the free block */
    sp_result claim;
    sp_evidence e;
} triple;

static void slide(triple *t, double sink, double slip)
{
    const sp_joint *c = &t->s.joint[0];
    double ft[3] = { 0, 0, 0 }, size = 0;
    for (int k = 0; k < 3; k++) {
        for (int32_t v = 0; v < c->points; v++)
            ft[k] += (double)t->f[3 * v + 1] * (double)c->t1[k] + (double)t->f[3 * v + 2] * (double)c->t2[k];
        size += ft[k] * ft[k];
    }
    size = sqrt(size);
    for (int k = 0; k < 3; k++) t->move[k] = R(-sink * (double)c->n[k] - (size > 0 ? slip * ft[k] / size : 0));
    for (int32_t v = 0; v < c->points; v++)
        t->alpha[v] = slip > 0 ? R(hypot((double)t->f[3 * v + 1], (double)t->f[3 * v + 2]) / slip) : 0;
}

static void make(triple *t, const char *name, const char *param, double value)
{
    sp_result r;
    test_arena.used = 0;
    build(name, param, value, &t->s);
    CHECK_INT(sp_check(&t->s, NULL, &test_arena, &r), SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    for (int32_t k = 0; k < 3 * t->s.count.points; k++) t->f[k] = r.f[k];
    for (int32_t k = 0; k < 6 * t->s.count.blocks; k++) t->dq[k] = 0;
    t->set = coupled();
    t->claim = r;
    t->claim.f = t->f;
    t->claim.coupled.dq = t->dq;
    t->claim.coupled.alpha = t->alpha;
    t->move = t->dq + 6 * (t->s.count.blocks - 1);
    slide(t, (double)EPS, 5 * (double)EPS);
}

static sp_level judged(triple *t)
{
    CHECK_INT(sp_verify(&t->s, &t->set, &t->claim, test_arena, &t->e), SP_OK);
    CHECK_INT(t->e.verdict, SP_STABLE);
    if (t->set.coupled.asked) CHECK((t->e.level == SP_COUPLED) == (t->e.residual <= 1));
    return t->e.level;
}

TEST(a_cube_that_sinks_and_a_block_that_creeps_down_its_slope_are_coupled)
{
    triple t;
    make(&t, "two-cubes", "offset", 0);
    CHECK_INT(judged(&t), SP_COUPLED);
    make(&t, "two-cubes", "offset", 0.4);
    CHECK_INT(judged(&t), SP_COUPLED);
    make(&t, "incline", "angle", 20);
    CHECK_INT(judged(&t), SP_COUPLED);
    CHECK(t.e.residual < R(0.1));
}

TEST(without_the_question_or_the_triple_a_state_is_admissible)
{
    triple t;
    make(&t, "incline", "angle", 20);
    t.set.coupled.asked = 0;
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
    t.set.coupled.asked = 1;
    t.claim.coupled.alpha = NULL;
    CHECK_INT(sp_verify(&t.s, &t.set, &t.claim, test_arena, &t.e), SP_OK);
    CHECK_INT(t.e.level, SP_ADMISSIBLE);
}

TEST(friction_against_nothing_or_along_the_slip_is_refused)
{
    triple t;
    make(&t, "incline", "angle", 20);
    slide(&t, (double)EPS, 0);
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
    slide(&t, (double)EPS, -5 * (double)EPS);
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
    slide(&t, (double)EPS, -5 * (double)EPS);
    for (int32_t v = 0; v < 4; v++) t.alpha[v] = -t.alpha[v];
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
    slide(&t, (double)EPS, 5 * (double)EPS);
    t.alpha[2] *= R(TOL(1.00001, 1.1));
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
}

TEST(slip_must_be_a_millionth_of_eps_and_opposite_within_a_millionth)
{
    triple t;
    make(&t, "incline", "angle", 20);
    slide(&t, (double)EPS, TOL(1.1e-6, 0.011) * (double)EPS);
    CHECK_INT(judged(&t), SP_COUPLED);
    slide(&t, (double)EPS, TOL(0.9e-6, 0.009) * (double)EPS);
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
    for (int turn = 0; turn < 2; turn++) {
        slide(&t, (double)EPS, 5 * (double)EPS);
        t.move[1] += R(5 * (turn ? 2 : 0.5) * TOL(1e-6, 1e-2)) * EPS;       /* y is across the slope */
        CHECK_INT(judged(&t), turn ? SP_ADMISSIBLE : SP_COUPLED);
    }
}

TEST(a_joint_that_presses_gives_eps_and_no_joint_gives_more)
{
    triple t;
    for (int k = 0; k < 4; k++) {
        static const double factor[4] = { TOL(0.5e-10, 0.5e-4), TOL(-0.5e-10, -0.5e-4), TOL(2e-10, 2e-4), TOL(-2e-10, -2e-4) };
        make(&t, "incline", "angle", 20);
        slide(&t, (double)EPS * (1 + factor[k]), 5 * (double)EPS);
        CHECK_INT(judged(&t), k < 2 ? SP_COUPLED : SP_ADMISSIBLE);
    }
    make(&t, "two-cubes", "offset", 0);
    t.move[4] = EPS;                    /* tilts: two corners open, two too deep */
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
    t.move[2] -= EPS / 2;               /* one edge open, the other eps deep: but all four corners press */
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
}

TEST(no_slip_or_opening_exceeds_eta)
{
    triple t;
    for (int k = 0; k < 4; k++) {
        make(&t, "incline", "angle", 20);
        slide(&t, (double)EPS, (double)ETA * (k & 1 ? 1.001 : 0.999));
        if (k & 2) t.move[1] += ETA / 2;                /* off the line too far for friction, and beyond eta */
        CHECK_INT(judged(&t), k ? SP_ADMISSIBLE : SP_COUPLED);
    }
    make(&t, "two-cubes", "offset", 0);                 /* no friction: slip any way, bounded as a length or by component */
    for (int k = 0; k < 4; k++) {
        t.move[0] = t.move[1] = ETA * R(k & 1 ? 0.9 : 0.7);
        t.set.coupled.box = k / 2;
        CHECK_INT(judged(&t), k == 1 ? SP_ADMISSIBLE : SP_COUPLED);
    }
}

TEST(without_give_a_triple_may_have_any_size)
{
    triple t;
    make(&t, "incline", "angle", 20);
    t.set.coupled.eps = 0;
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
    for (double eta = 1e-6; eta < 1e4; eta *= 100) {
        t.set.coupled.eta = R(eta);
        slide(&t, 0, eta / 2);
        CHECK_INT(judged(&t), SP_COUPLED);
        slide(&t, 0, -eta / 2);
        CHECK_INT(judged(&t), SP_ADMISSIBLE);
    }
}

/* A block held between two points, its centroid on the line through them: it may spin about that line as fast as you like. */
TEST(no_spin_hides_that_a_joint_gives_too_little)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 2, 0 };
    const sp_real at[3][3] = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } }, n[3] = { 1, 0, 0 };
    const sp_real left[3] = { R(-0.5), 0, 0 }, right[3] = { R(0.5), 0, 0 };
    const sp_strength strength = sp_strength_friction(1);
    const double ratio = sizeof(sp_real) == 8 ? 1e9 : 1e4;
    sp_settings set = coupled();
    sp_scene s;
    sp_result r;
    sp_evidence e;
    NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
    for (int k = 0; k < 3; k++) CHECK_INT(sp_scene_body(&s, 1, at[k], k < 2 ? SP_FIXED : 0, NULL), SP_OK);
    CHECK_INT(sp_scene_points(&s, 0, 2, n, 1, left, &strength, NULL), SP_OK);
    CHECK_INT(sp_scene_points(&s, 2, 1, n, 1, right, &strength, NULL), SP_OK);
    set.coupled.eta = R(ratio) * EPS;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK(r.level != SP_COUPLED);
    CHECK_INT(r.coupled.verdict, SP_COUPLING_REFUTED);
    r.coupled.proof.nodes = 0;                          /* what would it be without its proof? */
    r.coupled.dq[12 + 2] = R(-0.9) * set.coupled.eta;
    for (int k = 0; k < 2; k++)
        r.coupled.alpha[k] = R(hypot((double)r.f[3 * k + 1], (double)r.f[3 * k + 2])) / (R(0.9) * set.coupled.eta);
    for (double spin = 1; spin < 1e20; spin *= 3) {
        r.coupled.dq[12 + 3] = R(spin) * EPS;
        CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
        CHECK_INT(e.level, SP_ADMISSIBLE);
    }
}

/* A bar held between two points by their friction alone: nothing presses it, and its spin about them has no bound. */
TEST(a_bar_between_two_points_is_refuted_whatever_its_spin)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 2, 0 };
    const sp_strength strength = sp_strength_friction(R(0.5));
    for (int k = 0; k < 4; k++) {
        const double c = cos(0.3 * k), d = sin(0.3 * k), sag = k == 3 ? 0.1 : 0;        /* at last it hangs below the line */
        const sp_real at[3][3] = { { R(-c), R(-d), 0 }, { R(c), R(d), 0 }, { 0, 0, R(-sag) } }, n[3] = { R(c), R(d), 0 };
        const sp_real left[3] = { R(-c / 2), R(-d / 2), 0 }, right[3] = { R(c / 2), R(d / 2), 0 };
        sp_settings set = coupled();
        sp_scene s;
        sp_result r;
        sp_evidence e;
        test_arena.used = 0;
        NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
        for (int b = 0; b < 3; b++) CHECK_INT(sp_scene_body(&s, 1, at[b], b < 2 ? SP_FIXED : 0, NULL), SP_OK);
        CHECK_INT(sp_scene_points(&s, 0, 2, n, 1, left, &strength, NULL), SP_OK);
        CHECK_INT(sp_scene_points(&s, 2, 1, n, 1, right, &strength, NULL), SP_OK);
        set.coupled.box = k & 1;
        NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
        CHECK_INT(r.coupled.verdict, SP_COUPLING_REFUTED);
        CHECK_INT(r.coupled.reason, SP_COUPLING_NO_MOTION);
        CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
        CHECK(e.verdict == SP_UNSTABLE && e.margin > 0);
    }
}

/* A beam on two points stands, however fast the triple's motion spins it about their line. */
TEST(a_spin_that_moves_no_contact_neither_makes_nor_breaks_a_triple)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 2, 0 };
    const sp_strength strength = sp_strength_friction(R(0.5));
    const sp_real at[2][3] = { { 0, 0, -1 }, { 0, 0, 0 } }, n[3] = { 0, 0, 1 }, feet[6] = { R(-0.5), 0, 0, R(0.7), 0, 0 };
    sp_settings set = coupled();
    sp_scene s;
    sp_result r;
    sp_evidence e;
    test_arena.used = 0;
    NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
    for (int b = 0; b < 2; b++) CHECK_INT(sp_scene_body(&s, 1, at[b], b ? 0 : SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_points(&s, 0, 1, n, 2, feet, &strength, NULL), SP_OK);
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.level, SP_COUPLED);
    for (double spin = 1; spin < 1e12; spin *= 1e3) {
        r.coupled.dq[6 + 3] = R(spin) * EPS;
        CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
        CHECK_INT(e.level, SP_COUPLED);
    }
}

TEST(numbers_that_are_none_are_no_triple)
{
    triple t;
    make(&t, "incline", "angle", 20);
    t.move[3] = R(NAN);
    CHECK_INT(sp_verify(&t.s, &t.set, &t.claim, test_arena, &t.e), SP_E_NOT_FINITE);
    t.move[3] = 0;
    t.alpha[1] = R(INFINITY);
    CHECK_INT(sp_verify(&t.s, &t.set, &t.claim, test_arena, &t.e), SP_E_NOT_FINITE);
    t.alpha[1] = R(TOL(1e308, 1e38));
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
    t.alpha[1] = 0;
    t.move[0] = R(TOL(1e308, 1e38));
    CHECK_INT(judged(&t), SP_ADMISSIBLE);
}

TEST(lengths_out_of_range_are_refused)
{
    static const double bad[] = { NAN, INFINITY, -INFINITY, -1 };
    sp_scene s;
    sp_result r;
    build("two-cubes", NULL, 0, &s);
    for (int k = 0; k < 4; k++) {
        sp_settings set = coupled();
        set.coupled.eta = R(bad[k]);
        CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_RANGE);
        set = coupled();
        set.coupled.eps = R(bad[k]);
        CHECK_INT(sp_check(&s, &set, &test_arena, &r), k < 3 ? SP_E_RANGE : SP_OK);
    }
    sp_settings set = coupled();
    set.coupled.eps = R(2e30);                          /* whose eta, by default, would not be a number */
    CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_RANGE);
    set.coupled.eps = R(1e-20);
    set.coupled.eta = R(1e20);
    CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_RANGE);
}

TEST_LIST(triple)
    RUN(a_cube_that_sinks_and_a_block_that_creeps_down_its_slope_are_coupled)
    RUN(without_the_question_or_the_triple_a_state_is_admissible)
    RUN(friction_against_nothing_or_along_the_slip_is_refused)
    RUN(slip_must_be_a_millionth_of_eps_and_opposite_within_a_millionth)
    RUN(a_joint_that_presses_gives_eps_and_no_joint_gives_more)
    RUN(no_slip_or_opening_exceeds_eta)
    RUN(without_give_a_triple_may_have_any_size)
    RUN(no_spin_hides_that_a_joint_gives_too_little)
    RUN(a_bar_between_two_points_is_refuted_whatever_its_spin)
    RUN(a_spin_that_moves_no_contact_neither_makes_nor_breaks_a_triple)
    RUN(numbers_that_are_none_are_no_triple)
    RUN(lengths_out_of_range_are_refused)
TEST_END
