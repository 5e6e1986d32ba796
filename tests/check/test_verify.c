/* Evidence: what is true is accepted, and nothing else is, whatever a claim says. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>

#if defined SP_SMALL || defined SP_NO_CRA || defined SP_EXACT_ONLY
enum { TELLS_COUPLED = 0 };
#else
enum { TELLS_COUPLED = 1 };
#endif

static void build(const char *name, const char *param, double value, sp_scene *scene)
{
    CHECK_INT(gen_make(name, param, value, &test_arena, scene), SP_OK);
}

/* What a claim proves; a claim with a NaN or an infinity in it is refused and proves nothing. */
static sp_verdict judged(const sp_scene *scene, const sp_result *claim)
{
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
    const sp_status status = sp_verify(scene, NULL, claim, test_arena, &e);
    if (status != SP_E_NOT_FINITE) CHECK_INT(status, SP_OK);
    return e.verdict;
}

/* A claim of nothing: no forces, no motion; fill in what is to be judged. */
static sp_result empty_claim(const sp_scene *scene)
{
    static sp_real f[3 * 4096], dq[6 * 512];
    const sp_settings settings = sp_settings_default();
    sp_result r;
    for (int32_t k = 0; k < 3 * scene->count.points && k < 3 * 4096; k++) f[k] = 0;
    for (int32_t k = 0; k < 6 * scene->count.blocks && k < 6 * 512; k++) dq[k] = 0;
    unsigned char *raw = (unsigned char *)&r;
    for (size_t k = 0; k < sizeof r; k++) raw[k] = 0;
    r.f = f;
    r.dq = dq;
    r.y0 = NULL;
    r.tol = settings.tol;
    return r;
}

static const struct { const char *name, *param; double value; sp_verdict verdict; } sample[] = {
    { "two-cubes", "offset", 0.3, SP_STABLE }, { "two-cubes", "offset", 0.6, SP_UNSTABLE }, { "arch", "t", 0.14, SP_STABLE },
    { "arch", "t", 0.09, SP_UNSTABLE }, { "wall", "size", 54, SP_STABLE }, { "h-model", "mu", 0.5, SP_STABLE },
    { "keystone", "mu", 0.5, SP_STABLE }, { "keystone", "mu", 0.3, SP_UNSTABLE }
};
enum { SAMPLES = sizeof sample / sizeof sample[0] };

static int checked(int k, sp_scene *scene, sp_result *result)
{
    test_arena.used = 0;
    build(sample[k].name, sample[k].param, sample[k].value, scene);
    if (!CHECK_INT(sp_check(scene, NULL, &test_arena, result), SP_OK)) return 0;
    return CHECK_INT(result->verdict, sample[k].verdict);
}

TEST(true_evidence_is_accepted_with_and_without_its_hint)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!checked(k, &s, &r)) continue;
        CHECK_INT(judged(&s, &r), r.verdict);
        r.y0 = NULL;
        CHECK_INT(judged(&s, &r), r.verdict);
    }
}

TEST(a_wrong_hint_neither_helps_nor_breaks)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!checked(k, &s, &r)) continue;
        for (int32_t i = 0; i < 6 * r.counts.free_blocks; i++) r.y0[i] = test_random_real(-1e6, 1e6);
        const sp_verdict v = judged(&s, &r);
        CHECK(v == r.verdict || v == SP_UNDECIDED);
        for (int32_t i = 0; i < 6 * r.counts.free_blocks; i++) r.y0[i] = R(NAN);
        const sp_verdict w = judged(&s, &r);
        CHECK(w == r.verdict || w == SP_UNDECIDED);
    }
}

TEST(nothing_is_no_evidence)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        test_arena.used = 0;
        build(sample[k].name, sample[k].param, sample[k].value, &s);
        const sp_result r = empty_claim(&s);
        CHECK_INT(judged(&s, &r), SP_UNDECIDED);
    }
}

TEST(numbers_that_are_none_prove_nothing)
{
    const double odd[] = { NAN, INFINITY, -INFINITY, TOL(1e308, 1e38), TOL(-1e308, -1e38), TOL(1e200, 1e25) };
    for (int k = 0; k < SAMPLES; k++)
        for (size_t i = 0; i < sizeof odd / sizeof odd[0]; i++)
            for (int all = 0; all < 2; all++) {
                sp_scene s;
                sp_result r;
                if (!checked(k, &s, &r)) continue;
                const int32_t nf = 3 * s.count.points, nq = 6 * s.count.blocks;
                if (r.verdict == SP_STABLE) {
                    for (int32_t j = all ? 0 : test_random_int(0, nf - 1); j < nf; j += all ? 1 : nf) r.f[j] = R(odd[i]);
                    if (all) CHECK_INT(judged(&s, &r), SP_UNDECIDED);
                    else judged(&s, &r);                /* one shear may be cut off again; it must only not crash */
                } else {
                    const int32_t block = s.count.blocks - 1;
                    for (int32_t j = all ? 0 : 6 * block; j < nq; j += all ? 1 : nq) r.dq[j] = R(odd[i]);
                    if (!isfinite(odd[i]) && all) CHECK_INT(judged(&s, &r), SP_UNDECIDED);
                    else judged(&s, &r);
                }
            }
}

TEST(one_normal_force_that_is_no_number_spoils_a_claim)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!checked(k, &s, &r) || r.verdict != SP_STABLE) continue;
        for (int32_t v = 0; v < s.count.points; v += 5) {
            const sp_real kept = r.f[3 * v];
            r.f[3 * v] = R(NAN);
            CHECK_INT(judged(&s, &r), SP_UNDECIDED);
            r.f[3 * v] = kept;
        }
        CHECK_INT(judged(&s, &r), SP_STABLE);
    }
}

TEST(forces_scaled_or_turned_round_are_refused)
{
    static const double factor[] = { -1, 0, 0.99, 1.01, 2, 1e6 };
    for (int k = 0; k < SAMPLES; k++)
        for (size_t i = 0; i < sizeof factor / sizeof factor[0]; i++) {
            sp_scene s;
            sp_result r;
            if (!checked(k, &s, &r) || r.verdict != SP_STABLE) continue;
            for (int32_t j = 0; j < 3 * s.count.points; j++) r.f[j] = R((double)r.f[j] * factor[i]);
            CHECK_INT(judged(&s, &r), SP_UNDECIDED);
        }
}

/* A standing scene has no mechanism, so no motion whatever may prove one. */
TEST(no_motion_proves_that_a_standing_scene_falls)
{
    for (int k = 0; k < SAMPLES; k++) {
        if (sample[k].verdict != SP_STABLE) continue;
        for (int trial = 0; trial < SOME_OF(200, 60); trial++) {
            sp_scene s;
            test_arena.used = 0;
            build(sample[k].name, sample[k].param, sample[k].value, &s);
            sp_result r = empty_claim(&s);
            const double size = pow(10, (double)test_random_real(-8, 8));
            const int sparse = trial % 3;
            for (int32_t b = 0; b < s.count.blocks; b++)
                for (int c = 0; c < 6; c++)
                    if (!sparse || test_random_int(0, 2) == 0) r.dq[6 * b + c] = test_random_real(-size, size);
            CHECK_INT(judged(&s, &r), SP_UNDECIDED);
        }
    }
}

TEST(a_mechanism_reversed_is_refused)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!checked(k, &s, &r) || r.verdict != SP_UNSTABLE) continue;
        for (int32_t j = 0; j < 6 * s.count.blocks; j++) r.dq[j] = -r.dq[j];
        CHECK_INT(judged(&s, &r), SP_UNDECIDED);
    }
}

/* However large a mechanism is written, it proves the same. */
TEST(the_length_of_a_mechanism_does_not_matter)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!checked(k, &s, &r) || r.verdict != SP_UNSTABLE) continue;
        for (int32_t j = 0; j < 6 * s.count.blocks; j++) r.dq[j] *= 1024;
        CHECK_INT(judged(&s, &r), SP_UNSTABLE);
        for (int32_t j = 0; j < 6 * s.count.blocks; j++) r.dq[j] /= 1048576;
        CHECK_INT(judged(&s, &r), SP_UNSTABLE);
    }
}

/* A block in a slot without friction, squeezed: no squeeze, however hard, carries its weight within tolerance. */
TEST(a_squeezed_block_in_a_slippery_slot_does_not_stand)
{
    for (double times = 1; times < TOL(1e13, 1e9); times *= 10) {
        sp_scene s;
        test_arena.used = 0;
        build("h-model", "mu", 0, &s);
        sp_result r = empty_claim(&s);
        const double weight = (double)s.block[2].mass * 9.80665;
        for (int32_t v = 0; v < s.count.points; v++) r.f[3 * v] = R(times * weight / 4);
        CHECK_INT(judged(&s, &r), SP_UNDECIDED);
    }
}

/* A pebble on the sloping roof of something far heavier, known by masses and joints only. */
static void pebble(double ratio, double mu, sp_scene *s)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 0 };
    const double c = cos(0.3), d = sin(0.3);
    const sp_real low[3] = { 0, 0, -1 }, middle[3] = { 0, 0, 5 }, high[3] = { R(0.01 * d), 0, R(10 + 0.01 * c) };
    const sp_real foot[12] = { -10, -10, 0, 10, -10, 0, 10, 10, 0, -10, 10, 0 };
    sp_real roof[12];
    for (int k = 0; k < 4; k++) {
        const double x = k == 1 || k == 2 ? 0.02 : -0.02, y = k >= 2 ? 0.02 : -0.02;
        roof[3 * k] = R(c * x);
        roof[3 * k + 1] = R(y);
        roof[3 * k + 2] = R(10 - d * x);
    }
    const sp_strength firm = sp_strength_friction(R(0.84)), strength = sp_strength_friction(R(mu));
    int32_t ground, cathedral, stone;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(s, 0, low, SP_FIXED, &ground), SP_OK);
    CHECK_INT(sp_scene_body(s, R(0.01 * ratio), middle, 0, &cathedral), SP_OK);
    CHECK_INT(sp_scene_body(s, R(0.01), high, 0, &stone), SP_OK);
    CHECK_INT(sp_scene_joint(s, ground, cathedral, 4, foot, &firm, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(s, cathedral, stone, 4, roof, &strength, NULL), SP_OK);
}

TEST(a_pebble_is_judged_by_its_own_weight)
{
    for (double ratio = 1; ratio < TOL(1e16, 1e7); ratio *= 1e3) {
        sp_scene s;
        sp_result r;
        test_arena.used = 0;
        pebble(ratio, 0.30, &s);                        /* tan 0.3 = .3093 */
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_UNSTABLE);
        test_arena.used = 0;
        pebble(ratio, 0.32, &s);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_STABLE);
    }
}

#ifndef SP_SMALL
/* A level joint between x0 and x1 at height z, 1 deep. */
static void bed(sp_scene *s, int32_t a, int32_t b, double x0, double x1, double z)
{
    const sp_real v[12] = { R(x0), 0, R(z), R(x1), 0, R(z), R(x1), 1, R(z), R(x0), 1, R(z) };
    const sp_strength strength = sp_strength_friction(R(0.6));
    CHECK_INT(sp_scene_joint(s, a, b, 4, v, &strength, NULL), SP_OK);
}

static int32_t cube_at(sp_scene *s, double mass, double x, double z)
{
    const sp_real c[3] = { R(x), R(0.5), R(z) };
    int32_t id = -1;
    CHECK_INT(sp_scene_body(s, R(mass), c, 0, &id), SP_OK);
    return id;
}

enum { FOOT_NONE, FOOT_EDGE, FOOT_POINT };

/* A wall of 5 courses of 4 stones, and beside it a pile of 12 cubes, which rests as `foot` says 0.3 off its middle. */
static sp_scene wall_and_pile(double wall, double pile, int foot)
{
    const sp_capacity cap = { 40, 0, 0, 0, 80, 320, 0 };
    const sp_real ground[3] = { 0, 0, R(-1) }, up[3] = { 0, 0, 1 };
    const sp_strength strength = sp_strength_friction(R(0.6));
    sp_scene s;
    int32_t id[5][4], last = 0;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int r = 0; r < 5; r++)
        for (int k = 0; k < 4; k++) {
            const double x = 2 * k + r % 2;
            id[r][k] = cube_at(&s, wall, x + 1, r + 0.5);
            if (!r) bed(&s, 0, id[r][k], x, x + 2, 0);
            else bed(&s, id[r - 1][k], id[r][k], 2 * k + 1, 2 * k + 2, r);
            if (r && r % 2 && k < 3) bed(&s, id[r - 1][k + 1], id[r][k], x + 1, x + 2, r);
            if (r && r % 2 == 0 && k) bed(&s, id[r - 1][k - 1], id[r][k], x, x + 1, r);
        }
    for (int k = 0; k < 12; k++) {
        const sp_real edge[6] = { R(20.2), 0, 0, R(20.2), 1, 0 }, point[3] = { R(20.2), R(0.5), 0 };
        const int32_t stone = cube_at(&s, pile, 20.5, k + 0.5);
        if (k) bed(&s, last, stone, 20, 21, k);
        else if (foot != FOOT_NONE)
            CHECK_INT(sp_scene_points(&s, 0, stone, up, foot == FOOT_EDGE ? 2 : 1, foot == FOOT_EDGE ? edge : point, &strength, NULL), SP_OK);
        last = stone;
    }
    return s;
}

/* A pile that not even joints that pull could balance, beside a wall that stands, up to 1e12 apart in weight: the pile's motion
 * proves what it proves alone, with and without the hint, and the check says so, islands apart and together. */
TEST(a_pile_that_turns_about_its_foot_falls_whatever_stands_beside_it)
{
    static const double ratio[] = { 1, 1e3, 1e6, 1e12 };
    for (int k = 0; k < 2 * 3 * TOL(4, 2); k++) {
        const double r = ratio[k / 6];
        const sp_scene s = wall_and_pile(k % 2 ? r : 1, k % 2 ? 1 : r, k / 2 % 3);
        for (int together = 0; together < 2; together++) {
            sp_settings set = sp_settings_default();
            sp_result x;
            set.effect[SP_EFFECT_TOGETHER] = together ? SP_WITH : SP_PLANNED;
            set.localise = 0;
            CHECK_INT(sp_check(&s, &set, &test_arena, &x), SP_OK);
            if (!CHECK_INT(x.verdict, SP_UNSTABLE)) TEST_PRINT("    foot %d, wall %g, together %d\n", k / 2 % 3, k % 2 ? r : 1 / r, together);
            CHECK_INT(judged(&s, &x), SP_UNSTABLE);
            x.y0 = NULL;
            CHECK_INT(judged(&s, &x), SP_UNSTABLE);
        }
    }
}
#endif

/* Two plain cubes, and a motion that "proves" their fall, because forces a thousand times smaller than theirs count as none. */
TEST(a_force_bound_below_what_stands_proves_no_fall)
{
    static const double bound[] = { 1e-3, 0.1, 0.9 };
    for (size_t k = 0; k < sizeof bound / sizeof bound[0]; k++) {
        sp_scene s;
        sp_evidence e;
        sp_settings set = sp_settings_default();
        test_arena.used = 0;
        build("two-cubes", "offset", 0.3, &s);
        sp_result claim = empty_claim(&s);
        for (int32_t b = 0; b < s.count.blocks; b++) if (s.block[b].fixed != SP_FIXED) claim.dq[6 * b + 2] = -1;
        set.force_bound = (sp_real)bound[k];
        if (!CHECK_INT(sp_verify(&s, &set, &claim, test_arena, &e), SP_OK)) continue;
        if (!CHECK_INT(e.verdict, SP_UNDECIDED)) TEST_PRINT("    force_bound %g\n", bound[k]);
    }
}

/* Evidence says no more than was proved: final of a fall alone, no level and no numbers of what was not asked. */
TEST(evidence_says_what_was_proved_and_no_more)
{
    int finals = 0;
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        sp_evidence e;
        if (!checked(k, &s, &r)) continue;
        NEED(sp_verify(&s, NULL, &r, test_arena, &e) == SP_OK);
        CHECK_INT(e.verdict, r.verdict);
        CHECK_INT(e.final, r.verdict == SP_UNSTABLE && r.final);
        CHECK_INT(e.level, r.verdict == SP_STABLE ? SP_ADMISSIBLE : SP_NONE);
        CHECK(!(e.residual > 0) && !(e.margin > 0));
        CHECK(r.verdict == SP_STABLE ? e.imbalance <= r.tol : e.least_imbalance > 0);
        finals += e.final;
    }
    CHECK(finals > 0);
}

/* Two bodies fall side by side and press on each other by rounding. 480 units of the last place are no resistance to who reads
 * them (512 are), and too many for who wrote them (448 are): what a check calls final stays final when its motion is read. */
TEST(a_motion_is_final_with_the_rounding_of_being_written_and_read)
{
    const sp_capacity room = { 2, 0, 0, 0, 1, 1, 0 };
    const sp_strength rough = sp_strength_friction(R(0.5));
    const sp_real n[3] = { 1, 0, 0 }, at[2][3] = { { 0, 0, 0 }, { 1, 0, 0 } }, x[3] = { R(0.5), 0, 0 };
    for (int units = 480; units < 540; units += 40) {
        sp_scene s;
        sp_evidence e;
        test_arena.used = 0;
        NEED(CHECK_INT(sp_scene_create(&s, &room, &test_arena), SP_OK));
        for (int b = 0; b < 2; b++) CHECK_INT(sp_scene_body(&s, 1, at[b], 0, NULL), SP_OK);
        CHECK_INT(sp_scene_points(&s, 0, 1, n, 1, x, &rough, NULL), SP_OK);
        sp_result r = empty_claim(&s);
        r.dq[2] = r.dq[8] = -1;
        r.dq[0] = (sp_real)SP_EPSILON * R(units);
        NEED(CHECK_INT(sp_verify(&s, NULL, &r, test_arena, &e), SP_OK));
        CHECK_INT(e.verdict, SP_UNSTABLE);
        CHECK_INT(e.final, units < 512);
    }
}

/* Forces short by a share are out of balance by it; they prove what stands with a tol that is no less, and not with a lesser. */
TEST(an_imbalance_of_just_tol_is_balanced)
{
    sp_scene s;
    sp_result r;
    sp_evidence e;
    sp_settings set = sp_settings_default();
    NEED(checked(0, &s, &r));
    for (int32_t k = 0; k < 3 * s.count.points; k++) r.f[k] *= R(1 - 1e-3);
    NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    CHECK_INT(e.verdict, SP_UNDECIDED);
    CHECK_NEAR(e.imbalance, 0.5e-3, 0.1);
    const sp_real just = e.imbalance;
    set.tol = just;
    NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    CHECK_WITHIN(e.imbalance, just, 0);
    CHECK_INT(e.verdict, SP_STABLE);
    set.tol = just * R(1 - 1e-6);
    NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    CHECK_INT(e.verdict, SP_UNDECIDED);
}

/* A motion proves a fall where what it leaves unbalanced is more than tol. */
TEST(what_a_motion_leaves_unbalanced_by_just_tol_may_stand)
{
    sp_scene s;
    sp_result r;
    sp_evidence e;
    sp_settings set = sp_settings_default();
    build("two-cubes", "offset", 0.55, &s);
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    for (int32_t i = 0; i < s.count.blocks; i++) r.dq[6 * i + 2] -= s.block[i].fixed == SP_FIXED ? 0 : R(1e-5);    /* not without work */
    set.force_bound = 100;
    NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    CHECK_INT(e.verdict, SP_UNSTABLE);
    if (e.final) return;                                /* in float nothing resists that, whatever the bound */
    sp_real just = 0;
    for (int it = 0; it < 9 && (e.least_imbalance < just || e.least_imbalance > just); it++) {     /* rounding is allowed for by tol */
        just = set.tol = e.least_imbalance;
        NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    }
    CHECK_WITHIN(e.least_imbalance, just, 0);
    CHECK_INT(e.verdict, SP_UNDECIDED);
    set.tol = just * R(1 - TOL(1e-6, 1e-4));
    NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    CHECK_INT(e.verdict, SP_UNSTABLE);
}

#if !defined SP_SMALL && !defined SP_NO_CRA && !defined SP_EXACT_ONLY
/* COUPLED needs both, forces that balance and a triple that holds. */
TEST(a_triple_is_coupled_only_with_forces_that_balance)
{
    sp_scene s;
    sp_result r;
    sp_evidence e;
    sp_settings set = sp_settings_default();
    set.coupled.asked = 1;
    build("two-cubes", "offset", 0.3, &s);
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    CHECK_INT(e.level, SP_COUPLED);
    CHECK(e.residual <= 1);
    for (int32_t v = 0; v < s.count.points; v++) r.coupled.alpha[v] = -1;
    NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    CHECK_INT(e.level, SP_ADMISSIBLE);
    CHECK(e.residual > 1);
    for (int32_t v = 0; v < s.count.points; v++) r.coupled.alpha[v] = 0;
    for (int32_t k = 0; k < 3 * s.count.points; k++) r.f[k] *= R(0.5);
    for (int32_t v = 0; v < s.count.points; v++) r.f[3 * v + 1] = r.f[3 * v + 2] = 0;
    NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
    CHECK(e.residual <= 1);
    CHECK_INT(e.verdict, SP_UNDECIDED);
    CHECK_INT(e.level, SP_NONE);
}

/* Motions moved farther and farther apart from a triple that holds: it is coupled up to a residual of 1, and no farther. A claim
 * without motion or without alpha, or where nobody asks, is of forces alone. */
TEST(a_triple_is_coupled_up_to_its_allowance_and_where_it_is_asked_for)
{
    sp_scene s;
    sp_result r;
    sp_evidence e;
    sp_settings set = sp_settings_default();
    set.coupled.asked = 1;
    build("two-cubes", "offset", 0.3, &s);
    NEED(sp_check(&s, &set, &test_arena, &r) == SP_OK);
    const sp_real at = r.coupled.dq[8];
    double within = 0, beyond = (double)r.coupled.eps;  /* by so much the upper cube may be lifted, and may not */
    int near = 0;
    for (int it = 0; it < TOL(60, 30); it++) {
        const double lift = (within + beyond) / 2;
        r.coupled.dq[8] = at + R(lift);
        NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
        CHECK_INT(e.level, e.residual <= 1 ? SP_COUPLED : SP_ADMISSIBLE);
        CHECK_INT(e.verdict, SP_STABLE);
        near += e.residual > 1 && e.residual < 2;
        if (e.residual <= 1) within = lift; else beyond = lift;
    }
    CHECK(near > 0);
    r.coupled.dq[8] = at;
    sp_real *dq = r.coupled.dq, *alpha = r.coupled.alpha;
    for (int without = 0; without < 3; without++) {
        r.coupled.dq = without == 0 ? NULL : dq;
        r.coupled.alpha = without == 1 ? NULL : alpha;
        set.coupled.asked = without != 2;
        NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
        CHECK_INT(e.level, SP_ADMISSIBLE);
        CHECK(!(e.residual > 0));
    }
}

/* A cube that falls upwards: that its forces balance along z contradicts itself, for joints press only. A tree of one leaf says so. */
TEST(a_proof_of_one_leaf_refutes_where_it_is_asked_for)
{
    int32_t node[1] = { -1 };
    uint16_t row[1] = { 2 };                            /* balance of the first free block along z */
    sp_real y[1];
    sp_settings set = sp_settings_default();
    sp_evidence e;
    sp_scene s;
    int held = 0;
    build("two-cubes", NULL, 0, &s);
    s.gravity[2] = 9;
    sp_result r = empty_claim(&s);
    r.coupled.proof.nodes = r.coupled.proof.leaves = r.coupled.proof.entries = 1;
    r.coupled.proof.node = node;
    r.coupled.proof.row = row;
    r.coupled.proof.y = y;
    for (int k = 0; k < 8; k++) {
        y[0] = k % 2 ? 1 : -1;
        set.coupled.asked = k / 2 % 2;
        r.coupled.proof.island = k / 4;
        NEED(sp_verify(&s, &set, &r, test_arena, &e) == SP_OK);
        CHECK_INT(e.verdict, e.margin > 0 ? SP_UNSTABLE : SP_UNDECIDED);
        CHECK(set.coupled.asked || !(e.margin > 0));
        held += e.margin > 0;
    }
    CHECK_INT(held, 2);                                 /* with one sign of y, of the whole and of its island */
}
#endif

/* What lies behind the arrays of a claim is not read; their last numbers are. */
TEST(a_claim_is_read_to_its_last_number_and_no_farther)
{
    enum { TRIED = 5 };
    static sp_real f[3 * 8 + 32], dq[6 * 2 + 12], move[6 * 2 + 12], alpha[8 + 8];
    sp_scene s;
    sp_evidence e;
    sp_settings set = sp_settings_default();
    set.coupled.asked = TELLS_COUPLED;
    build("two-cubes", NULL, 0, &s);
    sp_result r = empty_claim(&s);
    const int32_t nf = 3 * s.count.points, nq = 6 * s.count.blocks, na = s.count.points;
    NEED(na <= 8 && s.count.blocks == 2);
    r.f = f;
    r.dq = dq;
    r.coupled.dq = move;
    r.coupled.alpha = alpha;
    for (int k = 0; k < TRIED; k++) {
        for (int32_t i = 0; i < 3 * 8 + 32; i++) f[i] = i < nf ? 0 : R(NAN);
        for (int32_t i = 0; i < 6 * 2 + 12; i++) dq[i] = move[i] = i < nq ? 0 : R(NAN);
        for (int32_t i = 0; i < 8 + 8; i++) alpha[i] = i < na ? 0 : R(NAN);
        if (k == 1) f[nf - 1] = R(NAN);
        if (k == 2) dq[nq - 1] = R(NAN);
        if (k == 3) move[nq - 1] = R(NAN);
        if (k == 4) alpha[na - 1] = R(NAN);
        const int read = k > 0 && (k < 3 || set.coupled.asked);
        CHECK_INT(sp_verify(&s, &set, &r, test_arena, &e), read ? SP_E_NOT_FINITE : SP_OK);
    }
}

TEST(a_support_alone_stands)
{
    const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 0 };
    const sp_real middle[3] = { 0, 0, 0 };
    sp_evidence e;
    sp_scene s;
    NEED(sp_scene_create(&s, &cap, &test_arena) == SP_OK);
    sp_result r = empty_claim(&s);
    CHECK_INT(sp_verify(&s, NULL, &r, test_arena, &e), SP_E_EMPTY);
    NEED(sp_scene_body(&s, 0, middle, SP_FIXED, NULL) == SP_OK);
    CHECK_INT(sp_verify(&s, NULL, &r, test_arena, &e), SP_OK);
    CHECK_INT(e.verdict, SP_STABLE);
}

TEST(verify_says_which_argument_it_cannot_use)
{
    sp_scene s;
    sp_evidence e = { SP_STABLE, 1, 2, 3, SP_NONE, 0, 0 };
    build("two-cubes", NULL, 0, &s);
    sp_result r = empty_claim(&s);
    CHECK_INT(sp_verify(NULL, NULL, &r, test_arena, &e), SP_E_ARGUMENT);
    CHECK_INT(sp_verify(&s, NULL, NULL, test_arena, &e), SP_E_ARGUMENT);
    CHECK_INT(sp_verify(&s, NULL, &r, test_arena, NULL), SP_E_ARGUMENT);
    const sp_arena nowhere = { NULL, 0, 0, 0 };
    CHECK_INT(sp_verify(&s, NULL, &r, nowhere, &e), SP_E_ARGUMENT);
    sp_real *f = r.f;
    r.f = NULL;
    CHECK_INT(sp_verify(&s, NULL, &r, test_arena, &e), SP_E_ARGUMENT);
    r.f = f;
    r.dq = NULL;
    CHECK_INT(sp_verify(&s, NULL, &r, test_arena, &e), SP_E_ARGUMENT);
    size_t bytes = 7;
    CHECK_INT(sp_memory(NULL, SP_FOR_VERIFY, NULL, test_arena, &bytes), SP_E_ARGUMENT);
    CHECK_INT(sp_memory(&s, SP_FOR_VERIFY, NULL, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT((int64_t)bytes, 7);
    CHECK_INT(e.verdict, SP_STABLE);
}

TEST_LIST(verify)
    RUN(true_evidence_is_accepted_with_and_without_its_hint)
    RUN(a_wrong_hint_neither_helps_nor_breaks)
    RUN(nothing_is_no_evidence)
    RUN(numbers_that_are_none_prove_nothing)
    RUN(one_normal_force_that_is_no_number_spoils_a_claim)
    RUN(forces_scaled_or_turned_round_are_refused)
    RUN(no_motion_proves_that_a_standing_scene_falls)
    RUN(a_mechanism_reversed_is_refused)
    RUN(the_length_of_a_mechanism_does_not_matter)
    RUN(a_squeezed_block_in_a_slippery_slot_does_not_stand)
    RUN(a_pebble_is_judged_by_its_own_weight)
#ifndef SP_SMALL
    RUN(a_pile_that_turns_about_its_foot_falls_whatever_stands_beside_it)
#endif
    RUN(a_force_bound_below_what_stands_proves_no_fall)
    RUN(evidence_says_what_was_proved_and_no_more)
    RUN(a_motion_is_final_with_the_rounding_of_being_written_and_read)
    RUN(an_imbalance_of_just_tol_is_balanced)
    RUN(what_a_motion_leaves_unbalanced_by_just_tol_may_stand)
#if !defined SP_SMALL && !defined SP_NO_CRA && !defined SP_EXACT_ONLY
    RUN(a_triple_is_coupled_only_with_forces_that_balance)
    RUN(a_triple_is_coupled_up_to_its_allowance_and_where_it_is_asked_for)
    RUN(a_proof_of_one_leaf_refutes_where_it_is_asked_for)
#endif
    RUN(a_claim_is_read_to_its_last_number_and_no_farther)
    RUN(a_support_alone_stands)
    RUN(verify_says_which_argument_it_cannot_use)
TEST_END
