/* The coupled check: what a triple (f, dq, alpha) proves, and what is found. */
#include "../test.h"
#include "../scenes/gen.h"
#include "../scenes/change.h"

#include <math.h>

#define EPS R(1e-3)                     /* [m] */
#define ETA R(2e-2)

static void build(const char *name, const char *param, double value, sp_scene *scene)
{
    CHECK_INT(gen_make(name, param, value, &test_arena, scene), SP_OK);
}

static sp_settings coupled(void)
{
    sp_settings set = sp_settings_default();
    set.coupled.asked = 1;
    set.coupled.eps = EPS;
    set.coupled.eta = ETA;
    return set;
}

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

/* --------------------------------------------------------------------------------------------------------- what is said */

TEST(what_statics_refuse_is_refuted)
{
    const sp_settings set = coupled();
    sp_scene s;
    sp_result r;
    build("two-cubes", "offset", 0.6, &s);
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.coupled.verdict, SP_COUPLING_REFUTED);
    CHECK_INT(r.coupled.reason, SP_COUPLING_STATICS);
}

TEST(what_rests_without_load_is_coupled_as_it_is)
{
    const sp_settings set = coupled();
    sp_scene s;
    sp_result r;
    build("tower", "n", 3, &s);
    s.gravity[2] = 0;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.level, SP_COUPLED);
    CHECK_NEAR(r.coupled.residual, 0, 0);
}

TEST(the_default_lengths_follow_the_mean_edge)
{
    sp_settings set = sp_settings_default();
    sp_scene s;
    sp_result r;
    build("two-cubes", "offset", 0, &s);
    set.coupled.asked = 1;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_NEAR(r.coupled.eps, 1e-4, 1e-6);
    CHECK_NEAR(r.coupled.eta, 1e-2, 1e-6);
    set.coupled.eps = 0;
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.coupled.eps > 0, 0);
    CHECK_NEAR(r.coupled.eta, 1e-2, 1e-6);
}

/* ------------------------------------------------------------------------------------------------------- what is found */

static sp_settings asked(double ratio, int box)
{
    sp_settings set = sp_settings_default();
    set.coupled.asked = 1;
    set.coupled.eps = R(1e-4);
    set.coupled.eta = R(1e-4 * ratio);
    set.coupled.box = box;
    return set;
}

/* The answer, checked: what is coupled is admissible and passes sp_verify. */
static sp_coupling answer(const sp_scene *s, const sp_settings *set, sp_result *r)
{
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
    if (!CHECK_INT(sp_check(s, set, &test_arena, r), SP_OK)) return SP_COUPLING_NOT_ASKED;
    CHECK((r->level == SP_COUPLED) == (r->coupled.verdict == SP_COUPLING_COUPLED));
    if (r->coupled.verdict == SP_COUPLING_COUPLED) {
        CHECK_INT(r->verdict, SP_STABLE);
        CHECK(r->imbalance <= r->tol && r->coupled.residual <= 1);
        CHECK_INT(sp_verify(s, set, r, test_arena, &e), SP_OK);
        CHECK_INT(e.level, SP_COUPLED);
        sp_settings statics = *set;
        statics.coupled.asked = 0;
        CHECK_INT(sp_verify(s, &statics, r, test_arena, &e), SP_OK);
        CHECK(e.verdict == SP_STABLE && e.level == SP_ADMISSIBLE);          /* coupled implies admissible */
    } else CHECK(r->verdict != SP_STABLE);
    return r->coupled.verdict;
}

static sp_coupling of(const char *name, const char *param, double value)
{
    sp_scene s;
    sp_result r;
    const sp_settings set = asked(100, 0);
    test_arena.used = 0;
    build(name, param, value, &s);
    return answer(&s, &set, &r);
}

TEST(what_stands_by_its_weight_is_coupled)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "two-cubes", "offset", 0.4 }, { "incline", "angle", 30 }, { "topple", "angle", 12 }, { "overhang", "factor", 0.95 },
        { "cantilever", "reach", 1.1 }, { "tower", "n", 6 }, { "diamond", "rows", 3 }, { "arch", "n", 12 }, { "arch", "n", TOL(40, 12) },
        { "wall", "rows", 4 } };
    for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++)
        if (!CHECK_INT(of(scene[k].name, scene[k].param, scene[k].value), SP_COUPLING_COUPLED)) TEST_PRINT("    %s\n", scene[k].name);
}

TEST(the_price_of_a_certificate_is_told_and_contains_its_judge)
{
    const sp_settings set = asked(100, 0);
    for (int refuted = 0; refuted < 2; refuted++) {
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        build(refuted ? "h-model" : "incline", NULL, 0, &s);
        answer(&s, &set, &r);
        int64_t sum = r.coupled.cost.flops;
        for (int32_t k = 0; k < set.stage_count; k++) sum += r.spent.by_stage[k].flops;
        CHECK_INT(r.spent.total.flops, sum);
        CHECK(r.coupled.cost.flops > 2 * 90 * (int64_t)s.count.points);
    }
}

TEST(the_h_model_is_never_coupled)                      /* though statics accept it */
{
    static const double mu[] = { 0.01, 0.45, 0.84 };
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        build("h-model", "mu", mu[k], &s);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);
        for (double ratio = 2; ratio < 3e3; ratio *= 10) {
            const sp_settings set = asked(ratio, 1);
            test_arena.used = 0;
            build("h-model", "mu", mu[k], &s);
            CHECK(answer(&s, &set, &r) != SP_COUPLING_COUPLED);
        }
    }
}

/* A block w wide and h high between two walls, a metre deep, in world axes turned by `turn` about z; everything `unit` times as
 * long, `heavy` times as heavy; `swap`: the block is A of its joints; `late`: it is added first. */
typedef struct squeeze { double w, h, mu, turn, unit, heavy; int swap, late; } squeeze;

static void squeezed(const squeeze *q, sp_scene *s)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 0 };
    const sp_strength strength = sp_strength_friction(R(q->mu));
    const double c = cos(q->turn), d = sin(q->turn);
    int32_t wall[2], block = 0;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < 3; k++) {
        const double x = (k == (q->late ? 0 : 2) ? 0 : k == 1 ? 1 : -1) * (q->w / 2 + 1) * q->unit;
        const sp_real at[3] = { R(c * x), R(d * x), 0 };
        int32_t *id = k == (q->late ? 0 : 2) ? &block : &wall[k == 1];
        CHECK_INT(sp_scene_body(s, R(1000 * q->heavy), at, id == &block ? 0 : SP_FIXED, id), SP_OK);
    }
    for (int side = 0; side < 2; side++) {
        sp_real xyz[12];
        const int back = (side == 0) == (q->swap != 0);  /* seen from B anticlockwise */
        for (int k = 0; k < 4; k++) {
            const int v = back ? 3 - k : k;
            const double x = (side ? 0.5 : -0.5) * q->w * q->unit, y = (v == 1 || v == 2 ? 0.5 : -0.5) * q->unit;
            xyz[3 * k] = R(c * x - d * y);
            xyz[3 * k + 1] = R(d * x + c * y);
            xyz[3 * k + 2] = R((v >= 2 ? 0.5 : -0.5) * q->h * q->unit);
        }
        CHECK_INT(q->swap ? sp_scene_joint(s, block, wall[side], 4, xyz, &strength, NULL)
                          : sp_scene_joint(s, wall[side], block, 4, xyz, &strength, NULL), SP_OK);
    }
}

static sp_coupling squeeze_of(squeeze q, double ratio)
{
    sp_scene s;
    sp_result r;
    sp_settings set = asked(ratio, 1);
    set.coupled.eps *= R(q.unit);
    set.coupled.eta *= R(q.unit);
    squeezed(&q, &s);
    return answer(&s, &set, &r);
}

static const squeeze plain = { 1, 0.4, 1, 0, 1, 1, 0, 0 };

TEST(a_squeezed_block_jams_across_its_diagonal_from_mu_2h_over_w_on)
{
    static const double h[] = { 0.2, 0.42, 1 };
    for (int k = 0; k < 3; k++) {
        squeeze q = plain;
        q.h = h[k];
        q.mu = 2 * h[k] * (1 + TOL(1e-3, 2e-2));
        CHECK_INT(squeeze_of(q, 100), SP_COUPLING_COUPLED);
        q.mu = 2 * h[k] * (1 - TOL(1e-3, 2e-2));
        CHECK(squeeze_of(q, 100) != SP_COUPLING_COUPLED);
    }
}

TEST(and_from_eta_over_eps_2w_over_h_on)
{
    static const double h[] = { 0.2, 0.42, 1 };
    for (int k = 0; k < 3; k++) {
        squeeze q = plain;
        q.h = h[k];
        q.mu = 4 * h[k];
        CHECK_INT(squeeze_of(q, 2 / h[k] * (1 + TOL(1e-3, 2e-2))), SP_COUPLING_COUPLED);
        CHECK(squeeze_of(q, 2 / h[k] * (1 - TOL(1e-3, 2e-2))) != SP_COUPLING_COUPLED);
    }
}

TEST(without_give_a_squeezed_block_slides_down_and_is_coupled_however_little_it_rubs)
{
    static const double mu[] = { 0.01, 0.1, 0.7 };
    for (int k = 0; k < 6; k++) {
        sp_settings set = asked(1, k % 2);
        squeeze q = plain;
        sp_scene s;
        sp_result r;
        q.mu = mu[k / 2];
        q.h = k % 2 ? 3 : 0.4;
        set.coupled.eps = 0;
        squeezed(&q, &s);
        CHECK_INT(answer(&s, &set, &r), SP_COUPLING_COUPLED);
    }
}

TEST(the_answer_does_not_depend_on_units_axes_order_or_sides)
{
    for (int k = 0; k < 64; k++) {
        squeeze q = plain;
        q.turn = k & 1 ? 0.7 : 0;
        q.unit = k & 2 ? 1e-3 : 1;
        q.heavy = k & 4 ? TOL(1e6, 1e3) : 1;
        q.swap = k >> 3 & 1;
        q.late = k >> 4 & 1;
        q.mu = k & 32 ? 0.9 : 0.7;                      /* 2 h / w = 0.8 */
        if (k & 32) CHECK_INT(squeeze_of(q, 20), SP_COUPLING_COUPLED);
        else CHECK(squeeze_of(q, 20) != SP_COUPLING_COUPLED);
    }
}

TEST(a_coarse_tol_neither_couples_what_slides_nor_leaves_the_h_model_open)
{
    static const double past[] = { TOL(1.0005, 1.0005), TOL(1.00001, 1.0005), 0 };
    for (int k = 0; k < 3; k++) {
        sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        set.tol = R(1e-3);
        test_arena.used = 0;
        build(past[k] > 0 ? "incline" : "h-model", past[k] > 0 ? "angle" : NULL, 40, &s);
        for (int32_t i = 0; i < s.count.joints && past[k] > 0; i++)
            s.joint[i].strength.mu = R(tan(40 * 3.14159265358979323846 / 180) / past[k]);
        set.coupled.asked = 0;
        CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);                /* within that tol */
        set.coupled.asked = 1;
        CHECK_INT(answer(&s, &set, &r), k < 2 || sizeof(sp_real) == 8 ? SP_COUPLING_REFUTED : SP_COUPLING_NOT_FOUND);
        CHECK_NEAR(r.tol, TOL(1e-6, 1e-4), SP_EPSILON);
    }
}

/* Without friction a keystone sinks by eps / sin of its sides' angle. */
TEST(a_frictionless_keystone_is_coupled_if_it_may_sink_deep_enough)
{
    static const double angle[] = { -30, -5, -1 };
    for (int k = 0; k < 3; k++)
        for (int far = 0; far < 2; far++) {
            sp_scene s;
            sp_result r;
            gen_scene g;
            test_arena.used = 0;
            CHECK(gen_open(&g, "keystone") && gen_set(&g, "angle", angle[k]) && gen_set(&g, "mu", 0));
            CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
            const sp_settings set = asked((far ? 1.01 : 0.99) / tan(-angle[k] * 3.14159265358979323846 / 180), 1);
            const sp_coupling found = answer(&s, &set, &r);
            if (far) CHECK_INT(found, SP_COUPLING_COUPLED);
            else CHECK(found != SP_COUPLING_COUPLED);
        }
}

/* A beam snug between a wall and an upright block that stands free on the ground: nothing squeezes it, and it is too high to jam
 * across its diagonal, but statics let the upright's weight press it. `order`: of the blocks and joints, which side is A. */
static void snug(double mu, int order, sp_scene *s)
{
    static const double at[4][3] = { { 0, 0, -1 }, { -2, 0, 1 }, { 0, 0, 1.5 }, { 0.75, 0, 1 } };       /* ground wall beam post */
    static const double mass[4] = { 0, 0, 100, 5000 };
    static const int pair[3][2] = { { 1, 2 }, { 2, 3 }, { 0, 3 } };
    static const double corner[3][12] = {
        { -0.5, -0.5, 1.2, -0.5, 0.5, 1.2, -0.5, 0.5, 1.8, -0.5, -0.5, 1.8 },
        { 0.5, -0.5, 1.2, 0.5, 0.5, 1.2, 0.5, 0.5, 1.8, 0.5, -0.5, 1.8 },
        { 0.5, -0.5, 0, 1, -0.5, 0, 1, 0.5, 0, 0.5, 0.5, 0 } };
    const sp_capacity cap = { 4, 0, 0, 0, 3, 12, 0 };
    const sp_strength strength = sp_strength_friction(R(mu));
    int32_t id[4];
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    for (int k = 0; k < 4; k++) {
        const int i = (k + order) % 4;
        const sp_real c[3] = { R(at[i][0]), R(at[i][1]), R(at[i][2]) };
        CHECK_INT(sp_scene_body(s, R(mass[i]), c, mass[i] > 0 ? 0 : SP_FIXED, &id[i]), SP_OK);
    }
    for (int k = 0; k < 3; k++) {
        const int j = (k + order) % 3, swap = order >> k & 1;
        sp_real xyz[12];
        for (int q = 0; q < 12; q++) {
            const int v = (q / 3 + order) % 4;
            xyz[q] = R(corner[j][3 * (swap ? 3 - v : v) + q % 3]);
        }
        CHECK_INT(sp_scene_joint(s, id[pair[j][swap]], id[pair[j][!swap]], 4, xyz, &strength, NULL), SP_OK);
    }
}

TEST(a_beam_snug_between_a_wall_and_a_free_upright_is_refuted_however_it_is_numbered)
{
    for (int order = 0; order < 5; order++) {
        const sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        snug(order ? 0.3 : 0.7, order, &s);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);
        snug(order ? 0.3 : 0.7, order, &s);
        if (sizeof(sp_real) == 8) CHECK_INT(answer(&s, &set, &r), SP_COUPLING_REFUTED);
        else CHECK(answer(&s, &set, &r) != SP_COUPLING_COUPLED);
    }
}

/* ---------------------------------------------------------------------------------------------------- monotone, invariant */

/* Scenes with their answers at eta/eps 100, slip bounded by its length. */
typedef struct known { const char *name; double angle, mu, tilt; sp_coupling answer; } known;
static const known sample[] = {
    { "h-model", 0, 0.84, 0, SP_COUPLING_REFUTED },         { "h-model", 0, 0.45, 0, SP_COUPLING_REFUTED },
    { "squeezed", 0, 0.9, 0, SP_COUPLING_COUPLED },         { "squeezed", 0, 0.7, 0, SP_COUPLING_REFUTED },
    { "arch", 0, 0.84, 0, SP_COUPLING_COUPLED },            { "flat-arch", 0, 0.5, 0, SP_COUPLING_COUPLED },
    { "keystone", -1, 0, 0, SP_COUPLING_COUPLED },          { "keystone", -0.5, 0, 0, SP_COUPLING_REFUTED },
    { "keystone", 20, 0.84, 0, SP_COUPLING_REFUTED },       { "keystone", -20, 0.84, 50, SP_COUPLING_COUPLED },
    { "keystone", -20, 0.84, 80, SP_COUPLING_COUPLED },     { "snug", 0, 0.7, 0, SP_COUPLING_REFUTED }
};
enum { SAMPLES = sizeof sample / sizeof sample[0] };

static void build_known(const known *k, sp_scene *s)
{
    squeeze q = plain;
    gen_scene g;
    test_arena.used = 0;
    q.mu = k->mu;
    if (k->name[0] == 's') {
        if (k->name[1] == 'q') squeezed(&q, s);
        else snug(k->mu, 0, s);
        return;
    }
    CHECK(gen_open(&g, k->name));
    CHECK_INT(gen_set(&g, "mu", k->mu), 1);
    if (k->name[0] == 'k') CHECK_INT(gen_set(&g, "angle", k->angle), 1);
    if (k->tilt > 0) CHECK(gen_set(&g, "tilt", k->tilt) == 1 && gen_set(&g, "azimuth", 40) == 1);
    if (k->name[0] == 'a') CHECK_INT(gen_set(&g, "n", 12), 1);
    CHECK_INT(gen_build(&g, &test_arena, s), SP_OK);
}

/* In float an answer may be missing; it is never the other one. */
static void same_answer(const known *k, const sp_scene *s, double unit)
{
    sp_settings set = asked(100, 0);
    sp_result r;
    set.coupled.eps *= R(unit);
    set.coupled.eta *= R(unit);
    const sp_coupling found = answer(s, &set, &r);
    if (sizeof(sp_real) == 8 || found != SP_COUPLING_NOT_FOUND) {
        if (!CHECK_INT(found, k->answer)) TEST_PRINT("    %s angle %g mu %g tilt %g\n", k->name, k->angle, k->mu, k->tilt);
    }
}

TEST(a_turn_with_gravity_units_order_sides_and_first_corners_leave_the_answer)
{
    for (int k = 0; k < SAMPLES; k++)
        for (int way = sample[k].name[1] == 'n' ? SOME_OF(5, 6) : 0; way < 6; way++) {         /* what takes a second: all at once only */
            sp_scene s, other;
            int32_t place[MOST], name[MOST];
            change c = none();
            if (way == 0 || way == 5) any_turn(&c);
            if (way == 1 || way == 5) c.scale = 12.5, c.density = 4e-3, c.gravity = 3;
            if (way == 2 || way == 5) c.permute = 1;
            if (way == 3 || way == 5) c.swap = 1;
            if (way == 4 || way == 5) c.turn = 1;
            build_known(&sample[k], &s);
            copy(&s, &c, &other, place, name);
            same_answer(&sample[k], &other, c.scale);
        }
}

/* Of one triple (f, dq, alpha) the conditions ask  f in K,  dn <= eta, |dt| <= eta,  and besides only what is linear in f for
 * one dq, or in dq for one f. So it is one still
 *     with more friction, or a cone around that one:     f in K stays
 *     with a larger eta, or its bound per component:     |dt1|, |dt2| <= |dt|
 *     in another length:  eps, eta, dq  times s,  alpha / s:     ft = -alpha dt, dn + eps
 *     with other weights: p, f, alpha times s:           Aeq f + p, ft = -alpha dt */
TEST(a_triple_stays_one_where_more_is_allowed_or_all_is_scaled)
{
    for (int k = 0; k < SAMPLES; k++)
        for (int way = 0; way < 8; way++) {
            sp_settings set = asked(100, 0);
            sp_scene s;
            sp_result r;
            sp_evidence e;
            if (sample[k].answer != SP_COUPLING_COUPLED) continue;
            build_known(&sample[k], &s);
            if (answer(&s, &set, &r) != SP_COUPLING_COUPLED) { CHECK(sizeof(sp_real) == 4); continue; }
            if (way == 1) CHECK_INT(sp_scene_friction(&s, R(sample[k].mu * 1.5 + 0.1)), SP_OK);
            if (way == 2) set.coupled.eta *= 10;
            if (way == 3) set.coupled.box = 1;
            if (way == 4 || way == 5) { set.faces = way == 4 ? 5 : 8; set.inscribed = 0; }
            if (way == 6) { set.coupled.eps *= 7; set.coupled.eta *= 7; }
            for (int32_t i = 0; i < 6 * s.count.blocks && way == 6; i++) r.coupled.dq[i] *= 7;
            for (int32_t v = 0; v < s.count.points && way == 6; v++) r.coupled.alpha[v] /= 7;
            for (int i = 0; i < 3 && way == 7; i++) s.gravity[i] *= 3;
            for (int32_t v = 0; v < s.count.points && way == 7; v++) r.coupled.alpha[v] *= 3;
            for (int32_t i = 0; i < 3 * s.count.points && way == 7; i++) r.f[i] *= 3;
            CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), SP_OK);
            if (!CHECK_INT(e.level, SP_COUPLED)) TEST_PRINT("    %s mu %g, way %d\n", sample[k].name, sample[k].mu, way);
        }
}

/* ... so no answer turns back: refuted, perhaps not found, then coupled; in double it turns once. */
TEST(as_friction_or_eta_grows_the_answer_turns_once)
{
    for (int what = 0; what < 3; what++) {
        int turned = 0;
        for (int step = 0; step <= 24; step += SOME_OF(1, 3)) {
            const double by = 0.5 + step * 0.0625 + 1e-3;
            const double mu = what == 2 ? 0 : what == 1 ? 1.6 : 0.8 * by;
            const known k = { what == 2 ? "keystone" : "squeezed", -1, mu, 0, SP_COUPLING_NOT_FOUND };
            const double ratio = what == 0 ? 20 : (what == 1 ? 5 : 1 / tan(3.14159265358979323846 / 180)) * by;
            const sp_settings set = asked(ratio, what == 1);
            sp_scene s;
            sp_result r;
            build_known(&k, &s);
            const sp_coupling found = answer(&s, &set, &r);
            if (found == SP_COUPLING_COUPLED) turned = 1;
            CHECK(!turned || found != SP_COUPLING_REFUTED);
            if (sizeof(sp_real) == 8) CHECK_INT(found, by > 1 ? SP_COUPLING_COUPLED : SP_COUPLING_REFUTED);
        }
        CHECK_INT(turned, 1);
    }
}

TEST(proofs_have_room_by_the_cube_of_the_corners_up_to_ten_megabytes)
{
    static const int n[] = { 1, 2, 4, 11, 12 };
    for (int k = 0; k < 5; k++) {
        sp_settings set = asked(100, 0);
        size_t bytes[2];
        for (int own = 0; own < 2; own++) {
            sp_scene s;
            test_arena.used = 0;
            build("tower", "n", n[k], &s);
            set.coupled.nodes = own ? -1 : 0;
            CHECK_INT(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes[own]), SP_OK);
        }
        const double corners = 4 * n[k], cube = 24 * corners * corners * corners, nodes = cube < 48000 ? cube : 48000;
        CHECK((double)(bytes[1] - bytes[0]) < 300 * nodes + 200000 && bytes[1] - bytes[0] <= (size_t)12 << 20);
        CHECK((double)(bytes[1] - bytes[0]) > 100 * nodes);
    }
}

/* -------------------------------------------------------------------------------------------- where help is wanted */

/* How B moves seen from A at point v of joint i, along n, t1, t2 [m]. */
static void rate(const sp_scene *s, const sp_real *dq, const sp_joint *i, int32_t v, double d[3])
{
    double u[3] = { 0, 0, 0 };
    for (int side = 0; side < 2; side++) {
        const int32_t b = side ? i->a : i->b;
        const sp_real *q = dq + 6 * b, *x = s->point[v], *c = s->block[b].centroid;
        for (int k = 0; k < 3; k++) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            const double turn = (double)q[3 + l] * (double)(x[m] - c[m]) - (double)q[3 + m] * (double)(x[l] - c[l]);
            u[k] += (side ? -1 : 1) * ((double)q[k] + turn);
        }
    }
    for (int k = 0; k < 3; k++) {
        const sp_real *e = k == 0 ? i->n : k == 1 ? i->t1 : i->t2;
        d[k] = u[0] * (double)e[0] + u[1] * (double)e[1] + u[2] * (double)e[2];
    }
}

/* Force of vertex v of joint i onto its B, and the turn about c it gives. */
static void push(const sp_scene *s, const sp_real *penalty, const sp_joint *i, int32_t v, int32_t b, double sum[6])
{
    const sp_real *x = penalty + 4 * v;
    double f[3], arm[3];
    for (int k = 0; k < 3; k++) {
        f[k] = (double)((x[0] - x[1]) * i->n[k] + x[2] * i->t1[k] + x[3] * i->t2[k]) * (b == i->b ? 1 : -1);
        arm[k] = (double)(s->point[v][k] - s->block[b].centroid[k]);
        sum[k] += f[k];
    }
    for (int k = 0; k < 3; k++) sum[3 + k] += arm[(k + 1) % 3] * f[(k + 2) % 3] - arm[(k + 2) % 3] * f[(k + 1) % 3];
}

/* Every condition of the penalty form, its forces in balance; returns whether there is an answer. */
static int explained(const sp_scene *s, const sp_result *r)
{
    const double give = TOL(1e-6, 1e-2) * (double)r->coupled.eps;
    if (!CHECK(r->coupled.tension_ratio >= 0)) return 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const double weight = (double)s->block[b].mass * (double)s->gravity[2];
        double sum[6] = { 0, 0, weight, 0, 0, 0 };
        if (s->block[b].fixed) continue;
        for (int32_t i = 0; i < s->count.joints; i++)
            for (int32_t v = 0; v < s->joint[i].points && (s->joint[i].a == b || s->joint[i].b == b); v++)
                push(s, r->coupled.penalty, &s->joint[i], s->joint[i].point + v, b, sum);
        for (int k = 0; k < 6; k++) CHECK_WITHIN(sum[k], 0, TOL(1e-6, 1e-2) * fabs(weight));
    }
    for (int32_t i = 0; i < s->count.joints; i++)
        for (int32_t v = s->joint[i].point; v < s->joint[i].point + s->joint[i].points; v++) {
            const sp_real *x = r->coupled.penalty + 4 * v;
            double d[3];
            rate(s, r->coupled.dq, &s->joint[i], v, d);
            const double ft = hypot((double)x[2], (double)x[3]), dust = TOL(1e-9, 1e-4) * (double)x[0];
            CHECK(x[0] >= 0 && x[1] >= 0 && r->coupled.alpha[v] >= 0 && d[0] >= -(double)r->coupled.eps - give);
            CHECK(hypot(d[1], d[2]) <= (double)r->coupled.eta + give && d[0] <= (double)r->coupled.eta + give);
            if (x[0] > 0) CHECK_WITHIN(d[0], -(double)r->coupled.eps, give);
            CHECK(ft <= (double)s->joint[i].strength.mu * (double)x[0] + dust);
            for (int k = 1; k < 3; k++)
                CHECK_WITHIN((double)x[k + 1] + (double)r->coupled.alpha[v] * d[k], 0, TOL(1e-6, 1e-2) * (ft + dust));
        }
    return 1;
}

/* A cube of weight W that reaches beyond its support by `offset` of 1: it turns about the edge, s = 1 - offset wide, and only
 * the other edge holds it: W (1/2 - s) / s. */
TEST(a_block_beyond_its_support_demands_tension_at_the_far_edge)
{
    static const double offset[] = { 0.55, 0.6, 0.75 };
    for (int k = 0; k < 3; k++) {
        const sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        build("two-cubes", "offset", offset[k], &s);
        NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
        CHECK_INT(r.coupled.verdict, SP_COUPLING_REFUTED);
        if (!explained(&s, &r)) continue;
        const double W = (double)s.block[1].mass * 9.80665, pull = W * (offset[k] - 0.5) / (1 - offset[k]);
        CHECK_NEAR(r.demand[0].tension, pull / 2, TOL(1e-6, 1e-2));
        CHECK_NEAR(r.extremes.tension, pull / 2, TOL(1e-6, 1e-2));
        CHECK_NEAR(r.coupled.tension_ratio, pull / (W + pull), TOL(1e-6, 1e-2));
        for (int32_t v = 0; v < 4; v++) {
            const int far = s.point[v][0] < s.block[1].centroid[0] - R(offset[k]) / 2;
            CHECK_WITHIN(r.coupled.penalty[4 * v + (far ? 0 : 1)], 0, TOL(1e-6, 1e-2) * W);
            CHECK_NEAR(r.coupled.penalty[4 * v + (far ? 1 : 0)], (far ? pull : W + pull) / 2, TOL(1e-6, 1e-2));
        }
    }
}

/* Statics let the H model squeeze its beam and demand nothing. No motion squeezes it: one joint rubs, W / mu pressed at an
 * edge, against the other end's W w / (2h); the difference must be pulled. */
TEST(the_h_model_demands_tension_at_its_joints_once_a_motion_is_asked_for)
{
    static const double mu[] = { 0.2, 0.45, 0.84 };
    for (int k = 0; k < 3; k++) {
        const sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        build("h-model", "mu", mu[k], &s);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK_WITHIN(r.demand[0].tension + r.demand[1].tension + r.demand[0].friction + r.demand[1].friction, 0, 0);
        NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
        CHECK(r.coupled.verdict != SP_COUPLING_COUPLED);
        if (!explained(&s, &r)) continue;
        const double W = (double)s.block[2].mass * 9.80665;
        double pull = 0;
        for (int32_t v = 0; v < s.count.points; v++) pull += (double)r.coupled.penalty[4 * v + 1];
        CHECK(pull > 0.01 * W && r.coupled.tension_ratio > R(0.1));
        CHECK((double)(r.demand[0].friction + r.demand[1].friction) > 0.01 * W);
        if (k == 2) CHECK_WITHIN(pull / W, 1 / mu[k] - 1, 0.01);        /* w = 2h */
    }
}

TEST(friction_that_a_slope_lacks_is_told_along_with_the_slip)
{
    const sp_settings set = asked(100, 0);
    sp_scene s;
    sp_result r;
    test_arena.used = 0;
    build("incline", "angle", 50, &s);
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    if (!explained(&s, &r)) return;
    CHECK(r.demand[0].friction > 0);
    CHECK_INT(r.extremes.weakest, 0);
    for (int32_t v = 0; v < 4; v++) CHECK(r.coupled.alpha[v] > 0 && r.coupled.penalty[4 * v + 1] > 0);
}

TEST(nothing_is_demanded_where_a_motion_is_found_or_nobody_asks)
{
    for (int k = 0; k < 2; k++) {
        sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        set.localise = !k;
        build(k ? "h-model" : "incline", NULL, 0, &s);
        CHECK(answer(&s, &set, &r) == (k ? TOL(SP_COUPLING_REFUTED, r.coupled.verdict) : SP_COUPLING_COUPLED));
        CHECK(r.coupled.tension_ratio < 0 && !(r.extremes.tension > 0));
        for (int32_t i = 0; i < s.count.joints; i++) CHECK(!(r.demand[i].tension > 0) && !(r.demand[i].friction > 0));
        for (int32_t v = 0; !k && v < 4 * s.count.points; v++) CHECK_WITHIN(r.coupled.penalty[v], 0, 0);
    }
}

TEST(what_is_demanded_does_not_depend_on_units_axes_order_or_sides)
{
    double ratio = -1;
    for (int k = 0; k < 32; k++) {
        squeeze q = plain;
        sp_scene s;
        sp_result r;
        q.turn = k & 1 ? 0.7 : 0;
        q.unit = k & 2 ? 1e-3 : 1;
        q.heavy = k & 4 ? 1e3 : 1;
        q.swap = k >> 3 & 1;
        q.late = k >> 4 & 1;
        q.mu = 0.7;
        sp_settings set = asked(20, 1);
        set.coupled.eps *= R(q.unit);
        set.coupled.eta *= R(q.unit);
        squeezed(&q, &s);
        CHECK(answer(&s, &set, &r) != SP_COUPLING_COUPLED);
        if (!explained(&s, &r)) continue;
        if (ratio < 0) ratio = (double)r.coupled.tension_ratio;
        CHECK_NEAR(r.coupled.tension_ratio, ratio, TOL(1e-6, 1e-2));
    }
}

#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
static sp_settings turns(double ratio)
{
    sp_settings set = sp_settings_seed();
    set.coupled.asked = 1;
    set.coupled.eps = R(1e-4);
    set.coupled.eta = R(1e-4 * ratio);
    return set;
}

static sp_coupling in_turns(const char *name, const char *param, double value, const sp_settings *set, sp_result *r)
{
    sp_scene s;
    test_arena.used = 0;
    build(name, param, value, &s);
    return answer(&s, set, r);
}

TEST(the_seeds_alternation_couples_what_stands_in_a_round)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "two-cubes", "offset", 0.4 }, { "incline", "angle", 30 }, { "topple", "angle", 12 }, { "overhang", "factor", 0.9 },
        { "cantilever", "reach", 1.1 }, { "tower", "n", 6 }, { "wall", "rows", 2 }, { "arch", "n", 12 } };
    const sp_settings set = turns(100);
    for (size_t k = 0; k < sizeof scene / sizeof scene[0] - TOL(0, 1); k++) {           /* float does not find the arch's */
        sp_result r;
        const int coupled = CHECK_INT(in_turns(scene[k].name, scene[k].param, scene[k].value, &set, &r), SP_COUPLING_COUPLED);
        if (!coupled || !CHECK_INT(r.coupled.rounds, 1)) TEST_PRINT("    %s\n", scene[k].name);
    }
}

TEST(the_seeds_alternation_drops_what_no_motion_explains_and_refutes_nothing)
{
    static const double mu[] = { 0.45, 0.6, 0.84 };
    for (int k = 0; k < 3; k++)
        for (double ratio = 2; ratio < 3e3; ratio *= 10) {
            const sp_settings set = turns(ratio);
            sp_result r;
            CHECK_INT(in_turns("h-model", "mu", mu[k], &set, &r), SP_COUPLING_NOT_FOUND);
            CHECK(r.coupled.rounds >= 1 && r.coupled.rounds <= 12 && r.coupled.proof.nodes == 0);
        }
}

TEST(the_seeds_alternation_stops_after_the_rounds_asked_for)
{
    sp_settings set = turns(100);
    sp_result r;
    CHECK_INT(set.coupled.rounds, 12);
    CHECK_INT(sp_settings_default().coupled.rounds, 0);
    set.coupled.nodes = -1;                             /* what it leaves open may be decided after all */
    set.tol = TOL(R(1e-9), R(1e-4));
    CHECK_INT(in_turns("h-model", "mu", 0.6, &set, &r), TOL(SP_COUPLING_REFUTED, SP_COUPLING_NOT_FOUND));
    set = turns(100);
    set.coupled.rounds = 1;
    CHECK_INT(in_turns("h-model", "mu", 0.6, &set, &r), SP_COUPLING_NOT_FOUND);
    CHECK_INT(r.coupled.rounds, 1);
}
#else
TEST(the_seeds_alternation_is_refused_where_it_is_left_out)
{
    sp_scene s;
    sp_result r;
    sp_settings set = asked(100, 0);
    set.coupled.rounds = 12;
    test_arena.used = 0;
    build("incline", "angle", 30, &s);
    CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_E_UNSUPPORTED);
}
#endif

TEST(the_coupled_check_takes_exactly_the_memory_it_says)
{
    for (int k = 0; k < 4; k++) {
        sp_settings set = asked(100, 0);
        sp_scene s;
        sp_result r;
        sp_arena a;
        size_t bytes = 0;
        if (k == 3) set.faces = 8;
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
        if (k == 2) set = turns(100);
#endif
        test_arena.used = 0;
        set.coupled.asked = k > 0;
        build("arch", "n", 8, &s);
        NEED(sp_memory_scratch(&s, SP_FOR_CHECK, &set) <= test_arena.cap - test_arena.used);
        sp_arena scratch = test_arena;
        scratch.cap = scratch.used + sp_memory_scratch(&s, SP_FOR_CHECK, &set) + SP_ALIGN;
        NEED(sp_memory(&s, SP_FOR_CHECK, &set, scratch, &bytes) == SP_OK);
        const size_t from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        NEED(sp_arena_init(&a, test_arena.base + from, test_arena.cap - from) == SP_OK);
        NEED(bytes <= a.cap);
        a.cap = bytes;
        CHECK_INT(sp_check(&s, &set, &a, &r), SP_OK);
        CHECK_INT((int64_t)r.spent.peak_bytes, (int64_t)bytes);
        a.used = 0;
        a.cap = bytes - 1;
        CHECK_INT(sp_check(&s, &set, &a, &r), SP_E_MEMORY);
    }
}

TEST_LIST(coupled)
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
    RUN(what_statics_refuse_is_refuted)
    RUN(what_rests_without_load_is_coupled_as_it_is)
    RUN(the_default_lengths_follow_the_mean_edge)
    RUN(what_stands_by_its_weight_is_coupled)
    RUN(the_price_of_a_certificate_is_told_and_contains_its_judge)
    RUN(the_h_model_is_never_coupled)
    RUN(a_squeezed_block_jams_across_its_diagonal_from_mu_2h_over_w_on)
    RUN(and_from_eta_over_eps_2w_over_h_on)
    RUN(without_give_a_squeezed_block_slides_down_and_is_coupled_however_little_it_rubs)
    RUN(the_answer_does_not_depend_on_units_axes_order_or_sides)
    RUN(a_coarse_tol_neither_couples_what_slides_nor_leaves_the_h_model_open)
    RUN(a_frictionless_keystone_is_coupled_if_it_may_sink_deep_enough)
    RUN(a_beam_snug_between_a_wall_and_a_free_upright_is_refuted_however_it_is_numbered)
    RUN(a_turn_with_gravity_units_order_sides_and_first_corners_leave_the_answer)
    RUN(a_triple_stays_one_where_more_is_allowed_or_all_is_scaled)
    RUN(as_friction_or_eta_grows_the_answer_turns_once)
    RUN(proofs_have_room_by_the_cube_of_the_corners_up_to_ten_megabytes)
    RUN(a_block_beyond_its_support_demands_tension_at_the_far_edge)
    RUN(the_h_model_demands_tension_at_its_joints_once_a_motion_is_asked_for)
    RUN(friction_that_a_slope_lacks_is_told_along_with_the_slip)
    RUN(nothing_is_demanded_where_a_motion_is_found_or_nobody_asks)
    RUN(what_is_demanded_does_not_depend_on_units_axes_order_or_sides)
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
    RUN(the_seeds_alternation_couples_what_stands_in_a_round)
    RUN(the_seeds_alternation_drops_what_no_motion_explains_and_refutes_nothing)
    RUN(the_seeds_alternation_stops_after_the_rounds_asked_for)
#else
    RUN(the_seeds_alternation_is_refused_where_it_is_left_out)
#endif
    RUN(the_coupled_check_takes_exactly_the_memory_it_says)
TEST_END
