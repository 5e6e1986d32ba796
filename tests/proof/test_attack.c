/* Scenes and claims made to mislead: nothing of it may prove what is not so, crash, or let a NaN out. Public calls only. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>

/* 1 ---------------------------------------------------------------------------------------------- scenes and verdicts */

static int number(sp_real x) { return x - x >= 0; }

static int numbers(const sp_real *x, int32_t n)
{
    for (int32_t k = 0; k < n; k++) if (!number(x[k])) return 0;
    return 1;
}

static void start(sp_scene *s, int32_t blocks, int32_t joints, int32_t points)
{
    const sp_capacity cap = { blocks, 0, 0, 0, joints, points, 0 };
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
}

static int32_t body(sp_scene *s, double mass, double x, double y, double z, unsigned held)
{
    const sp_real c[3] = { R(x), R(y), R(z) };
    int32_t id = -1;
    CHECK_INT(sp_scene_body(s, R(mass), c, held, &id), SP_OK);
    return id;
}

/* A rectangle about c with half sides p and q; its normal is p x q. */
static void quad(sp_scene *s, int32_t a, int32_t b, const double c[3], const double p[3], const double q[3], double mu)
{
    const sp_strength strength = sp_strength_friction(R(mu));
    sp_real x[12];
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            x[3 * k + i] = R(c[i] + (k == 1 || k == 2 ? p[i] : -p[i]) + (k >= 2 ? q[i] : -q[i]));
    CHECK_INT(sp_scene_joint(s, a, b, 4, x, &strength, NULL), SP_OK);
}

/* A level rectangle about (x, y, z), 2 p by 2 q: b stands on a. */
static void bed(sp_scene *s, int32_t a, int32_t b, double x, double y, double z, double p, double q, double mu)
{
    const double c[3] = { x, y, z }, u[3] = { p, 0, 0 }, v[3] = { 0, q, 0 };
    quad(s, a, b, c, u, v, mu);
}

/* An upright square 2 p by 2 p about (x, 0, z), normal along x. */
static void wall(sp_scene *s, int32_t a, int32_t b, double x, double z, double p, double mu)
{
    const double c[3] = { x, 0, z }, u[3] = { 0, p, 0 }, v[3] = { 0, 0, p };
    quad(s, a, b, c, u, v, mu);
}

static void generated(const char *name, const char *param, double value, sp_scene *s)
{
    gen_scene g;
    test_arena.used = 0;
    CHECK_INT(gen_open(&g, name), 1);
    if (param) CHECK_INT(gen_set(&g, param, value), 1);
    CHECK_INT(gen_build(&g, &test_arena, s), SP_OK);
}

/* A claim of nothing, in the arena. */
static sp_result empty_claim(const sp_scene *s)
{
    const int32_t nf = 3 * s->count.points, nq = 6 * s->count.blocks;
    sp_result r;
    unsigned char *raw = (unsigned char *)&r;
    for (size_t k = 0; k < sizeof r; k++) raw[k] = 0;
    sp_real *x = (sp_real *)(void *)(test_arena.base + test_arena.used);
    test_arena.used += ((size_t)(nf + 2 * nq) * sizeof *x + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    for (int32_t k = 0; k < nf + 2 * nq; k++) x[k] = 0;
    r.f = x;
    r.dq = x + nf;
    r.y0 = x + nf + nq;
    return r;
}

/* What a claim proves; what cannot be judged proves nothing. */
static sp_verdict judged(const sp_scene *s, const sp_result *claim, const sp_settings *settings)
{
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
    const sp_status status = sp_verify(s, settings, claim, test_arena, &e);
    if (status != SP_E_NOT_FINITE) CHECK_INT(status, SP_OK);
    CHECK(number(e.imbalance) && number(e.least_imbalance));
    return e.verdict;
}

/* Check with everything a check promises: numbers only, evidence that holds with its hint, and without one unless weights are so
 * uneven that the small ones' share of the forces is lost in rounding. */
static sp_status checked(const sp_scene *s, const sp_settings *settings, sp_result *r)
{
    const sp_status status = sp_check(s, settings, &test_arena, r);
    if (status) return status;
    CHECK(numbers(r->f, 3 * s->count.points) && numbers(r->dq, 6 * s->count.blocks) && numbers(r->y0, 6 * r->counts.free_blocks));
    CHECK(number(r->imbalance) && number(r->least_imbalance) && number(r->extremes.compression) && number(r->extremes.tension) &&
          number(r->extremes.utilisation));
    for (int32_t k = 0; k < s->count.joints; k++) {
        sp_joint_force f;
        CHECK_INT(sp_joint_resultant(s, r, k, &f), SP_OK);
        CHECK(numbers(f.force, 3) && numbers(f.point, 3) && number(f.utilisation));
        CHECK(number(r->demand[k].tension) && number(r->demand[k].friction));
    }
    if (r->verdict != SP_UNDECIDED) CHECK(r->verified);
    sp_real light = 0, heavy = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_block *k = &s->block[b];
        if (k->fixed == SP_FIXED) continue;
        if (!(light > 0) || k->mass < light) light = k->mass;
        if (k->mass > heavy) heavy = k->mass;
    }
    const int even = heavy / TOL(R(1e8), R(1e3)) <= light;
    sp_result plain = *r;
    plain.y0 = NULL;
    CHECK_INT(judged(s, r, settings), r->verdict);
    const sp_verdict alone = judged(s, &plain, settings);
    if (even) CHECK_INT(alone, r->verdict);
    else CHECK(alone == SP_UNDECIDED || alone == r->verdict);
    return SP_OK;
}

static sp_verdict verdict(const sp_scene *s)
{
    sp_result r;
    const size_t mark = test_arena.used;
    const sp_status status = checked(s, NULL, &r);
    test_arena.used = mark;
    CHECK_INT(status, SP_OK);
    return status ? SP_UNDECIDED : r.verdict;
}

/* sure 0: may be left undecided (by the float build), never wrong. */
static int verdict_is(const sp_scene *s, sp_verdict want, int sure)
{
    const sp_verdict got = verdict(s);
    return !sure && got == SP_UNDECIDED ? 1 : CHECK_INT(got, want);
}

/* 2 ---------------------------------------------------------------------------------------------- squeezed in a slot */

/* A stone of mass 1 in a slot of width 2 between two upright faces of one block, `times` heavier and standing on the ground. */
static void slot(sp_scene *s, double times, double mu)
{
    start(s, 3, 3, 12);
    const int32_t ground = body(s, 0, 0, 0, -1, SP_FIXED), u = body(s, times, 0, 0, 2, 0), stone = body(s, 1, 0, 0, 8, 0);
    bed(s, ground, u, 0, 0, 0, 5, 5, 0.8);
    wall(s, u, stone, -1, 8, 1, mu);
    wall(s, stone, u, 1, 8, 1, mu);
}

TEST(no_squeeze_holds_a_block_in_a_slippery_slot)
{
    for (double times = 1; times < TOL(1e16, 1e7); times *= 1e5) {
        sp_scene s;
        sp_result r;
        slot(&s, times, 0);
        NEED(checked(&s, NULL, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_UNSTABLE);
        CHECK(r.final);
        for (double squeeze = 1e2; squeeze < TOL(1e13, 1e9); squeeze *= 10) {
            sp_result forged = empty_claim(&s);
            for (int32_t v = 0; v < s.count.points; v++)
                forged.f[3 * v] = R(9.80665 * (v < 4 ? (1 + times) / 4 : squeeze));
            CHECK_INT(judged(&s, &forged, NULL), SP_UNDECIDED);
            forged.y0 = r.y0;
            CHECK_INT(judged(&s, &forged, NULL), SP_UNDECIDED);
        }
    }
}

/* What friction of 1e-9 could hold with forces beyond every bound does not stand, and is not said to fall for good either. */
TEST(tiny_friction_is_told_honestly)
{
    static const struct { double mu; sp_verdict want; int final; } table[] = {
        { 0, SP_UNSTABLE, 1 }, { TOL(1e-9, 1e-5), SP_UNSTABLE, TOL(0, -1) }, { TOL(1e-8, 1e-4), SP_UNSTABLE, 0 },
        { TOL(1e-6, 2e-3), SP_STABLE, 0 }, { 1e-2, SP_STABLE, 0 }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        sp_result r;
        generated("h-model", "mu", table[k].mu, &s);
        NEED(checked(&s, NULL, &r) == SP_OK);
        if (!CHECK_INT(r.verdict, table[k].want)) TEST_PRINT("    mu = %g\n", table[k].mu);
        if (table[k].final >= 0) CHECK_INT(r.final, table[k].final);        /* float: 1e-5 is near the rounding of a motion */
    }
}

/* The bound on forces decides: at mu the slot needs 1 / (8 mu) of the weight at each of its eight corners. */
TEST(the_bound_on_forces_is_the_callers)
{
    sp_scene s;
    sp_result r;
    sp_settings settings = sp_settings_default();
    generated("h-model", "mu", 0.01, &s);
    settings.force_bound = R(2);
    NEED(checked(&s, &settings, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.final, 0);
    settings.force_bound = R(100);
    NEED(checked(&s, &settings, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
}

/* 3 --------------------------------------------------------------------------------------------- very unequal weights */

/* A pile of square stones of width 10 and height 2, each `ratio` times heavier than the one below, in a tilted world. */
static void pile(sp_scene *s, int32_t n, double ratio, double tilt, double mu)
{
    start(s, n + 1, n, 4 * n);
    body(s, 0, 0, 0, -1, SP_FIXED);
    double mass = 1;
    for (int32_t k = 1; k <= n; k++, mass *= ratio) {
        body(s, mass, 0, 0, 2 * k - 1, 0);
        bed(s, k - 1, k, 0, 0, 2 * k - 2, 5, 5, mu);
    }
    gen_gravity(tilt, 17, s->gravity);
}

TEST(pebbles_on_and_under_cathedrals)
{
    static const double ratio[] = { 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e12, 1e15 };
    for (size_t k = 0; k < sizeof ratio / sizeof ratio[0]; k++) {
        sp_scene s;
        const int sure = TOL(1, ratio[k] > 1e-7 && ratio[k] < 1e7);
        pile(&s, 2, ratio[k], 25, 0.44);                /* tan 25 = .46631 */
        verdict_is(&s, SP_UNSTABLE, sure);
        pile(&s, 2, ratio[k], 25, 0.50);
        if (!verdict_is(&s, SP_STABLE, sure)) TEST_PRINT("    ratio = %g\n", ratio[k]);
    }
}

/* Only the pebble's own joint slips, whichever of the two it is. */
TEST(a_pebble_slides_alone)
{
    for (double ratio = 1e3; ratio < TOL(1e16, 1e7); ratio *= 1e3) {
        sp_scene s;
        sp_result r;
        pile(&s, 2, 1 / ratio, 25, 0.7);
        s.joint[1].strength.mu = R(0.46);
        NEED(checked(&s, NULL, &r) == SP_OK);
        CHECK_INT(r.verdict, SP_UNSTABLE);
        CHECK(fabs((double)r.dq[6]) + fabs((double)r.dq[8]) < 1e-6);
        s.joint[1].strength.mu = R(0.47);
        verdict_is(&s, SP_STABLE, 1);
    }
}

/* Three weights, the middle one apart: stable and sliding. */
TEST(sandwiches_of_unequal_weights)
{
    static const double mass[][3] = { { 1, 1e9, 1 }, { 1e9, 1, 1e9 }, { 1, 1e7, 1e14 }, { 1e14, 1e7, 1 }, { 1e12, 1, 1 } };
    for (size_t k = 0; k < sizeof mass / sizeof mass[0]; k++)
        for (int32_t weak = -1; weak < 3; weak++) {
            sp_scene s;
            pile(&s, 3, 1, 25, 0.6);
            for (int b = 0; b < 3; b++) s.block[b + 1].mass = R(mass[k][b]);
            if (weak >= 0) s.joint[weak].strength.mu = R(0.4);
            if (!verdict_is(&s, weak < 0 ? SP_STABLE : SP_UNSTABLE, TOL(1, 0)))
                TEST_PRINT("    masses %g %g %g, weak joint %d\n", mass[k][0], mass[k][1], mass[k][2], (int)weak);
        }
}

/* A pebble between two faces of a cathedral, in the slot it would fall through: no f0 of the cathedral lends it tolerance. */
TEST(a_cathedral_lends_a_pebble_no_tolerance)
{
    for (double times = 1; times < TOL(1e25, 1e16); times *= 1e3) {
        sp_scene s;
        slot(&s, times, 0);
        for (double hint = 1; hint < TOL(1e25, 1e16); hint *= 1e3)
            for (double squeeze = 1; squeeze < TOL(1e25, 1e16); squeeze *= 1e3) {
                const size_t mark = test_arena.used;
                sp_result forged = empty_claim(&s);
                for (int32_t v = 0; v < 12; v++) forged.f[3 * v] = R(v < 4 ? (1 + times) * 9.80665 / 4 : squeeze);
                forged.y0[6 + 0] = R(hint);             /* the stone alone moves: f0 presses on the cheeks */
                if (!CHECK_INT(judged(&s, &forged, NULL), SP_UNDECIDED)) {
                    TEST_PRINT("    %g times heavier, hint %g, squeeze %g\n", times, hint, squeeze);
                    return;
                }
                forged.y0[6 + 0] = 0;
                forged.y0[6 + 2] = R(hint);
                if (!CHECK_INT(judged(&s, &forged, NULL), SP_UNDECIDED)) {
                    TEST_PRINT("    %g times heavier, hint %g upwards, squeeze %g\n", times, hint, squeeze);
                    return;
                }
                test_arena.used = mark;
            }
    }
}

/* A pebble under a cathedral carries it: whatever the hint leaves unknown of its scale, no motion proves that it cannot. */
TEST(a_cathedral_on_a_pebble_does_not_sink)
{
    for (double ratio = 1; ratio < TOL(1e16, 1e10); ratio *= 1e3)
        for (double size = 0; size < TOL(1e30, 1e15); size = size > 0 ? size * 1e3 : TOL(1e-12, 1e-6))
            for (int kind = 0; kind < 4; kind++) {
                sp_scene s;
                pile(&s, 3, ratio, 10, 0.5);
                const sp_real middle = s.block[2].mass;     /* pebble, cathedral, and something between on top */
                s.block[2].mass = s.block[3].mass;
                s.block[3].mass = middle;
                sp_result forged = empty_claim(&s);
                for (int i = 0; i < 18; i++) forged.y0[i] = test_random_real(-size, size);
                for (int i = 6; i < 24; i++) forged.dq[i] = kind ? test_random_real(-1, 1) : 0;
                if (kind < 3) forged.dq[6 * 2 + 2] = -1;    /* the heavy one comes down */
                if (kind < 2) forged.dq[6 * 3 + 2] = -1;
                if (!CHECK(judged(&s, &forged, NULL) != SP_UNSTABLE)) {
                    TEST_PRINT("    ratio %g, hint %g, kind %d\n", ratio, size, kind);
                    return;
                }
                forged.y0 = NULL;
                CHECK(judged(&s, &forged, NULL) != SP_UNSTABLE);
            }
}

/* 4 --------------------------------------------------------------------------------------------------- forged claims */

static const struct { const char *name, *param; double value; sp_verdict verdict; } sample[] = {
    { "two-cubes", "offset", 0.3, SP_STABLE }, { "two-cubes", "offset", 0.6, SP_UNSTABLE }, { "arch", "t", 0.14, SP_STABLE },
    { "arch", "t", 0.09, SP_UNSTABLE }, { "incline", "angle", 35, SP_STABLE }, { "incline", "angle", 45, SP_UNSTABLE },
    { "keystone", "mu", 0.5, SP_STABLE }, { "keystone", "mu", 0.3, SP_UNSTABLE }, { "rubble", "rows", 3, SP_STABLE },
    { "wall", "tilt", 42, SP_UNSTABLE }
};
enum { SAMPLES = sizeof sample / sizeof sample[0] };

static int sampled(int k, sp_scene *s, sp_result *r)
{
    generated(sample[k].name, sample[k].param, sample[k].value, s);
    if (!CHECK_INT(sp_check(s, NULL, &test_arena, r), SP_OK)) return 0;
    return TOL(1, 0) ? CHECK_INT(r->verdict, sample[k].verdict) : r->verdict == sample[k].verdict;
}

/* The opposite of the truth is never proved; the truth need not be. */
static int not_wrong(int k, const sp_scene *s, const sp_result *claim)
{
    const sp_verdict got = judged(s, claim, NULL);
    return CHECK(got == SP_UNDECIDED || got == sample[k].verdict);
}

TEST(a_force_changed_by_more_than_tol_is_refused)
{
    const double by = TOL(1e-6, 2e-2);
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!sampled(k, &s, &r) || r.verdict != SP_STABLE) continue;
        for (int32_t c = 0; c < s.count.joints; c++) {
            const int32_t v = s.joint[c].point;     /* a vertex that carries something, with a free block above */
            const sp_real kept = r.f[3 * v];
            if (kept < R(0.05) * r.extremes.compression) continue;
            r.f[3 * v] = R((double)kept + by * (double)r.extremes.compression);
            CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
            r.f[3 * v] = kept;
        }
        for (int32_t j = 0; j < 3 * s.count.points; j++) r.f[j] = R((double)r.f[j] * (1 - 0.1 * by));
        if (TOL(1, 0)) CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
    }
}

/* Balanced forces that pull: a cube hung from above, and one that hangs on at one side. */
TEST(tension_is_no_evidence)
{
    sp_scene s;
    start(&s, 2, 1, 4);
    const int32_t top = body(&s, 0, 0, 0, 3, SP_FIXED), stone = body(&s, 1, 0, 0, 1, 0);
    bed(&s, stone, top, 0, 0, 2, 1, 1, 1e3);
    sp_result r = empty_claim(&s);
    for (int32_t v = 0; v < 4; v++) r.f[3 * v] = R(-9.80665 / 4);
    CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
    verdict_is(&s, SP_UNSTABLE, 1);

    generated("two-cubes", "offset", 0.6, &s);
    r = empty_claim(&s);
    const double weight = (double)s.block[1].mass * 9.80665;
    for (int32_t v = 0; v < 4; v++) {                   /* overlap 0.6 .. 1 in x, centre of weight at 1.1 */
        const int right = s.point[v][0] > R(0.8);
        r.f[3 * v] = R(weight / 2 * (right ? 1.25 : -0.25));
    }
    CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
}

/* Balanced forces beyond the cone: a block on a slope steeper than its friction. */
TEST(friction_beyond_the_cone_is_no_evidence)
{
    for (int beyond = 0; beyond < 2; beyond++) {
        sp_scene s;
        generated("incline", "angle", 30, &s);
        sp_result r = empty_claim(&s);
        NEED(s.count.points == 4);
        const double weight = (double)s.block[s.count.blocks - 1].mass * 9.80665, tan30 = tan(30 / 57.295779513082320877);
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        NEED(r.verdict == SP_STABLE);                   /* forces that balance, for mu .84 */
        CHECK(weight > 0);
        CHECK_INT(sp_scene_friction(&s, R(tan30 * (beyond ? 1 - TOL(1e-7, 1e-2) : 1 + TOL(1e-7, 1e-2)))), SP_OK);
        CHECK_INT(judged(&s, &r, NULL), beyond ? SP_UNDECIDED : judged(&s, &r, NULL));
        verdict_is(&s, beyond ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

/* Balanced, in the cone, but beyond the bound on forces. */
TEST(forces_above_the_cap_are_no_evidence)
{
    for (int above = 0; above < 2; above++) {
        sp_scene s;
        sp_settings settings = sp_settings_default();
        settings.force_bound = R(50);
        generated("h-model", "mu", 0.84, &s);
        sp_result r;
        NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
        NEED(r.verdict == SP_STABLE);
        const double weight = (double)s.block[s.count.blocks - 1].mass * 9.80665;
        for (int32_t v = 0; v < s.count.points; v++) r.f[3 * v] += R((above ? 1e4 : 1) * weight);
        CHECK_INT(judged(&s, &r, &settings), above ? SP_UNDECIDED : SP_STABLE);
    }
}

/* Hints of any size, in range and null directions, change no verdict to a wrong one. */
TEST(no_hint_misleads)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        if (!sampled(k, &s, &r)) continue;
        sp_result forged = empty_claim(&s);
        const double step = r.counts.free_blocks > 20 ? TOL(1e60, 1e8) : TOL(1e12, 1e3);
        for (double size = TOL(1e-20, 1e-10); size < TOL(1e250, 1e30); size *= step) {
            for (int32_t i = 0; i < 6 * r.counts.free_blocks; i++) r.y0[i] = test_random_real(-size, size);
            not_wrong(k, &s, &r);
            for (int32_t i = 0; i < 6 * r.counts.free_blocks; i++) r.y0[i] = i % 6 == 0 ? R(size) : 0;         /* all alike */
            not_wrong(k, &s, &r);
            for (int32_t v = 0; v < s.count.points; v++) forged.f[3 * v] = R(size);
            for (int32_t i = 0; i < 6 * r.counts.free_blocks; i++) forged.y0[i] = test_random_real(-size, size);
            if (sample[k].verdict == SP_UNSTABLE) CHECK_INT(judged(&s, &forged, NULL), SP_UNDECIDED);
        }
    }
}

TEST(a_hint_and_a_squeeze_together_hold_nothing)
{
    int told = 0;
    for (double squeeze = 1; squeeze < TOL(1e14, 1e9) && told < 3; squeeze *= 100)
        for (double hint = 1; hint < TOL(1e100, 1e30) && told < 3; hint *= 1e4)
            for (int kind = 0; kind < 3; kind++) {
                sp_scene s;
                generated("h-model", "mu", 0, &s);
                sp_result forged = empty_claim(&s);
                for (int32_t v = 0; v < s.count.points; v++) forged.f[3 * v] = R(squeeze * (double)s.block[2].mass);
                for (int32_t i = 0; i < 6; i++)
                    if (kind == 0 || (kind == 1) == (i < 3)) forged.y0[i] = test_random_real(-hint, hint);
                if (!CHECK_INT(judged(&s, &forged, NULL), SP_UNDECIDED)) {
                    told++;
                    TEST_PRINT("    squeeze %g, hint %g, kind %d\n", squeeze, hint, kind);
                }
            }
}

/* On an edge a block may roll without moving its contacts: a hint along that motion is no force. */
TEST(hints_along_motions_no_contact_feels_do_nothing)
{
    for (double size = 1; size < TOL(1e100, 1e25); size *= 1e3)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int off = 0; off < 2; off++) {
                sp_scene s;
                sp_result r;
                const sp_real n[3] = { 0, 0, 1 }, x[6] = { -1, 0, 0, 1, 0, 0 };
                const sp_strength strength = sp_strength_friction(R(0.5));
                start(&s, 2, 1, 2);
                body(&s, 0, 0, 0, -1, SP_FIXED);
                body(&s, 1, 0, 0.1 * off, 1, 0);
                CHECK_INT(sp_scene_points(&s, 0, 1, n, 2, x, &strength, NULL), SP_OK);
                NEED(sp_check(&s, NULL, &test_arena, &r) == SP_OK);
                CHECK_INT(r.verdict, off ? SP_UNSTABLE : SP_STABLE);
                for (int i = 0; i < 6; i++) r.y0[i] = 0;
                r.y0[1] = R(sign * size);               /* roll about the edge: v = w x (c - edge) */
                r.y0[2] = R(-0.1 * off * sign * size);
                r.y0[3] = R(-sign * size);
                CHECK(judged(&s, &r, NULL) != (off ? SP_STABLE : SP_UNSTABLE));
                for (int v = 0; v < 2; v++) r.f[3 * v] = R(9.80665 / 2 * (off ? 1 : 3));
                CHECK_INT(judged(&s, &r, NULL), off ? judged(&s, &r, NULL) : SP_UNDECIDED);
                CHECK(judged(&s, &r, NULL) != SP_STABLE);
            }
}

/* Motions that are none, or of supports, or that contacts forbid; any of them against a scene that stands. */
TEST(motions_that_prove_nothing)
{
    for (int k = 0; k < SAMPLES; k++)
        for (int kind = 0; kind < 6; kind++) {
            sp_scene s;
            sp_result r;
            if (!sampled(k, &s, &r)) continue;
            for (int32_t j = 0; j < 3 * s.count.points; j++) r.f[j] = 0;
            for (int32_t b = 0; b < s.count.blocks; b++)
                for (int c = 0; c < 6; c++) {
                    sp_real *x = &r.dq[6 * b + c];
                    if (kind == 0) *x = 0;
                    else if (kind == 1) *x = R(c == 0);                             /* all of it sideways */
                    else if (kind == 2) *x = R(c == 2);                             /* up */
                    else if (kind == 3) *x = R(c == 2 ? -1 : 0);                    /* down, into the ground */
                    else if (kind == 4) *x = s.block[b].fixed ? R(-1) : 0;          /* supports only */
                    else *x = -*x;                                                  /* the mechanism, backwards */
                }
            if (kind == 1 || kind == 3) not_wrong(k, &s, &r);                       /* may be one */
            else CHECK_INT(judged(&s, &r, NULL), SP_UNDECIDED);
        }
}

/* Tiny motions of other blocks, from rounding: the mechanism still proves, and a standing scene gets none. */
TEST(tiny_motions_elsewhere_change_no_proof)
{
    for (int k = 0; k < SAMPLES; k++) {
        sp_scene s;
        sp_result r;
        double largest = 0;
        if (!sampled(k, &s, &r)) continue;
        sp_result forged = empty_claim(&s);
        const int32_t n = 6 * s.count.blocks;
        for (int32_t j = 0; j < n; j++) largest = fmax(largest, fabs((double)r.dq[j]));
        if (!(largest > 0)) largest = 1;
        for (double size = TOL(1e-14, 1e-8) * largest; size < 1e3 * largest; size *= TOL(100, 10)) {
            for (int32_t j = 0; j < n; j++) forged.dq[j] = R((double)r.dq[j] + (double)test_random_real(-size, size));
            not_wrong(k, &s, &forged);
            for (int32_t b = 0; b < s.count.blocks; b++) {              /* now only blocks that rest, as a whole */
                double moves = 0;
                for (int32_t j = 6 * b; j < 6 * b + 6; j++) moves += fabs((double)r.dq[j]);
                for (int32_t j = 6 * b; j < 6 * b + 6 && moves > 0; j++) forged.dq[j] = r.dq[j];
            }
            if (size < 1e-6 * largest && r.verdict == SP_UNSTABLE) CHECK_INT(judged(&s, &forged, NULL), SP_UNSTABLE);
        }
    }
}

/* Forces and motions of another scene with the same shape. */
TEST(evidence_of_another_scene_is_refused)
{
    static const struct { const char *name, *param; double good, bad; } pair[] = {
        { "two-cubes", "offset", 0.4, 0.6 }, { "incline", "angle", 35, 45 }, { "arch", "t", 0.14, 0.09 },
        { "keystone", "mu", 0.5, 0.3 }, { "wall", "tilt", 10, 42 }
    };
    for (size_t k = 0; k < sizeof pair / sizeof pair[0]; k++) {
        sp_scene good, bad;
        sp_result stands, falls;
        gen_scene g;
        generated(pair[k].name, pair[k].param, pair[k].good, &good);
        gen_open(&g, pair[k].name);
        gen_set(&g, pair[k].param, pair[k].bad);
        NEED(gen_build(&g, &test_arena, &bad) == SP_OK);
        NEED(sp_check(&good, NULL, &test_arena, &stands) == SP_OK);
        NEED(sp_check(&bad, NULL, &test_arena, &falls) == SP_OK);
        CHECK_INT(judged(&bad, &stands, NULL), SP_UNDECIDED);
        if (falls.verdict == SP_UNSTABLE) CHECK(judged(&good, &falls, NULL) != SP_UNSTABLE);
    }
}

/* 5 ------------------------------------------------------------------------------------- verdicts just beside the limit */

typedef struct world { double m, kg, g, shift; int order, swap; } world;

/* The scene in other units, elsewhere, in another order, from the other side. */
static void redo(const sp_scene *in, const world *w, sp_scene *out)
{
    const int32_t n = in->count.blocks, m = in->count.joints;
    const sp_capacity cap = { n, 0, 0, 0, m, in->count.points, 0 };
    CHECK_INT(sp_scene_create(out, &cap, &test_arena), SP_OK);
    for (int32_t k = 0; k < n; k++) {
        const sp_block *b = &in->block[w->order ? n - 1 - k : k];
        body(out, (double)b->mass * w->kg, (double)b->centroid[0] * w->m + w->shift, (double)b->centroid[1] * w->m - w->shift,
             (double)b->centroid[2] * w->m + 0.5 * w->shift, b->fixed);
    }
    for (int32_t k = 0; k < m; k++) {
        const sp_joint *f = &in->joint[w->order ? (7 * k + 3) % m : k];
        const int32_t a = w->order ? n - 1 - f->a : f->a, b = w->order ? n - 1 - f->b : f->b;
        sp_real x[3 * 16];
        for (int32_t v = 0; v < f->points; v++) {
            const sp_real *p = in->point[f->point + (w->swap ? f->points - 1 - v : v)];
            x[3 * v] = R((double)p[0] * w->m + w->shift);
            x[3 * v + 1] = R((double)p[1] * w->m - w->shift);
            x[3 * v + 2] = R((double)p[2] * w->m + 0.5 * w->shift);
        }
        CHECK_INT(sp_scene_joint(out, w->swap ? b : a, w->swap ? a : b, f->points, x, &f->strength, NULL), SP_OK);
    }
    for (int i = 0; i < 3; i++) out->gravity[i] = R((double)in->gravity[i] * w->g);
}

TEST(just_beside_the_limit_units_place_and_order_do_not_matter)
{
    static const struct { const char *name, *param; double limit, margin; sp_verdict below; } table[] = {   /* see closed */
        { "two-cubes", "offset", 0.5, TOL(1e-6, 1e-2), SP_STABLE },
        { "incline", "mu", 0.36397023426620234, TOL(1e-6, 1e-2), SP_UNSTABLE },     /* tan 20 */
        { "overhang", "factor", 1, TOL(1e-6, 3e-2), SP_STABLE },
        { "topple", "angle", 14.036243467926479, TOL(1e-6, 2e-2), SP_STABLE },      /* atan 1/4 */
        { "keystone", "mu", 0.36397023426620234, TOL(1e-4, 5e-2), SP_UNSTABLE },
        { "tower", "lean", 1 / 11.0, TOL(1e-6, 3e-2), SP_STABLE },
        { "arch", "t", 0.104589144893471, TOL(1e-6, 0.1), SP_UNSTABLE }
    };
    static const world change[] = {
        { 1e9, 1, 1, 0, 0, 0 }, { 1e-9, 1, 1, 0, 0, 0 }, { 1e3, TOL(1e-30, 1e-15), 1e3, 0, 0, 0 },
        { 1, TOL(1e30, 1e10), 1, 0, 0, 1 },
        { 1e-6, 1, TOL(1e-20, 1e-10), 0, 1, 0 }, { 1, 1, 1, TOL(1e6, 1e2), 0, 0 }, { 1, 1, 1, 0, 1, 1 },
        { 1e-3, 1e3, 1e-3, TOL(1e3, 0.1), 1, 1 }, { TOL(1e9, 1e5), TOL(1e9, 1e5), 1e-3, 0, 1, 1 }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++)
        for (int side = -1; side <= 1; side += 2)
            for (size_t c = 0; c < sizeof change / sizeof change[0]; c++) {
                sp_scene s, t;
                const double value = table[k].limit * (1 + side * table[k].margin);
                const sp_verdict below = table[k].below, above = below == SP_STABLE ? SP_UNSTABLE : SP_STABLE;
                gen_scene g;
                test_arena.used = 0;
                gen_open(&g, table[k].name);
                gen_set(&g, table[k].param, value);
                if (table[k].name[0] == 'a') gen_set(&g, "n", 11);
                NEED(gen_build(&g, &test_arena, &s) == SP_OK);
                redo(&s, &change[c], &t);
                if (!verdict_is(&t, side < 0 ? below : above, 1))
                    TEST_PRINT("    %s, %s = %.9g, change %d\n", table[k].name, table[k].param, value, (int)c);
            }
}

/* 6 --------------------------------------------------------------------------------------------- degenerate contacts */

TEST(a_block_on_a_point_stands_above_it_only)
{
    for (int k = 0; k < 5; k++) {
        static const double off[] = { 0, TOL(1e-6, 1e-2), 0.1, -0.3, 5 };
        sp_scene s;
        const sp_real n[3] = { 0, 0, R(3) }, x[3] = { 0, 0, 0 };
        const sp_strength strength = sp_strength_friction(R(0.5));
        start(&s, 2, 1, 1);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        body(&s, 2, off[k], 0, 1, 0);
        CHECK_INT(sp_scene_points(&s, 0, 1, n, 1, x, &strength, NULL), SP_OK);
        verdict_is(&s, k ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

TEST(a_block_on_an_edge_stands_above_it_only)
{
    static const double at[][2] = { { 0, 0 }, { 0.9, 0 }, { 1.1, 0 }, { 0, TOL(1e-6, 1e-2) }, { 0.5, -0.2 } };
    for (int k = 0; k < 5; k++) {
        sp_scene s;
        const sp_real n[3] = { 0, 0, 1 }, x[6] = { -1, 0, 0, 1, 0, 0 };
        const sp_strength strength = sp_strength_friction(R(0.5));
        start(&s, 2, 1, 2);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        body(&s, 2, at[k][0], at[k][1], 1, 0);
        CHECK_INT(sp_scene_points(&s, 0, 1, n, 2, x, &strength, NULL), SP_OK);
        verdict_is(&s, k < 2 ? SP_STABLE : SP_UNSTABLE, 1);
    }
}

/* A table on three legs, each a point: stands above their triangle only. */
TEST(three_points_carry_what_is_above_their_triangle)
{
    static const double at[][2] = { { 0, 0 }, { 0.99, 0 }, { 1.01, 0 }, { -0.51, 0 }, { -0.49, 0 } };
    for (int k = 0; k < 5; k++) {
        sp_scene s;
        const sp_real n[3] = { 0, 0, 1 };
        const sp_strength strength = sp_strength_friction(R(0.5));
        start(&s, 2, 3, 3);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        body(&s, 2, at[k][0], at[k][1], 1, 0);
        for (int leg = 0; leg < 3; leg++) {
            const sp_real x[3] = { R(leg ? -0.5 : 1), R(leg == 1 ? 1 : leg == 2 ? -1 : 0), 0 };
            CHECK_INT(sp_scene_points(&s, 0, 1, n, 1, x, &strength, NULL), SP_OK);
        }
        verdict_is(&s, k == 2 || k == 3 ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

/* A round block of radius 1 with n corners, height 2 h, in a world tilted along its first corner's middle; `times` joints. */
static void column(sp_scene *s, int32_t n, int32_t times, double h, double mu, double tilt)
{
    static sp_real x[3 * 512];
    const sp_strength strength = sp_strength_friction(R(mu));
    start(s, 2, times, n * times);
    body(s, 0, 0, 0, -1, SP_FIXED);
    body(s, 1, 0, 0, h, 0);
    for (int32_t k = 0; k < n; k++) {
        const double a = 6.283185307179586 * (k + 0.5) / n;
        x[3 * k] = R(cos(a));
        x[3 * k + 1] = R(sin(a));
        x[3 * k + 2] = 0;
    }
    for (int32_t k = 0; k < times; k++) CHECK_INT(sp_scene_joint(s, 0, 1, n, x, &strength, NULL), SP_OK);
    gen_gravity(tilt, 0, s->gravity);
}

/* Near the limit never wrong, a little off it decided. */
TEST(many_corners_and_repeated_joints_slide_and_topple_as_one)
{
    static const int32_t corners[] = { 3, 4, 7, 64, 512 };
    const double deg = 57.295779513082320877;
    for (size_t k = 0; k < sizeof corners / sizeof corners[0]; k++)
        for (int32_t times = 1; times <= (corners[k] < 100 ? 5 : 1); times += 4)
            for (int m = -2; m <= 2; m++) {
                const int32_t n = corners[k];
                const int far = (m == -2 || m == 2) && n < 100;
                const double margin = (m < 0 ? -1 : 1) * (far ? TOL(1e-5, 5e-2) : TOL(1e-6, 1e-2));
                const double edge = cos(6.283185307179586 / 2 / n);         /* from the middle to the edge across +x */
                sp_scene s;
                if (!m) continue;
                column(&s, n, times, 0.3, 0.5 * (1 + margin), atan(0.5) * deg);
                if (!verdict_is(&s, m < 0 ? SP_UNSTABLE : SP_STABLE, far)) TEST_PRINT("    sliding, margin %g\n", margin);
                column(&s, n, times, 2 * edge, 10, atan(0.5 * (1 + margin)) * deg);
                s.gravity[0] = R(fabs((double)s.gravity[0]));
                if (!verdict_is(&s, m < 0 ? SP_STABLE : SP_UNSTABLE, far))
                    TEST_PRINT("    %d corners, %d times, margin %g\n", (int)n, (int)times, margin);
            }
}

/* Corners on straight edges add nothing. */
TEST(collinear_corners_change_nothing)
{
    static const sp_real x[] = { -1, -1, 0, 0, -1, 0, R(0.5), -1, 0, 1, -1, 0, 1, R(0.1), 0, 1, 1, 0, -1, 1, 0, -1, 0, 0 };
    static const double at[] = { 0, 0.999, 1.001 };
    for (int k = 0; k < 3; k++) {
        sp_scene s;
        const sp_strength strength = sp_strength_friction(R(0.5));
        start(&s, 2, 1, 8);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        body(&s, 1, at[k], 0, 1, 0);
        CHECK_INT(sp_scene_joint(&s, 0, 1, 8, x, &strength, NULL), SP_OK);
        verdict_is(&s, k == 2 ? SP_UNSTABLE : SP_STABLE, 1);
    }
}

/* Needles standing, plates lying, from b / h = 1e-4 to 1e4; tol is of the height, so a needle's limit is known that well. */
TEST(needles_and_plates_topple_where_they_should)
{
    static const double base[] = { 1e-4, 1e-2, 1, 1e2, 1e4 };
    for (size_t k = TOL(0, 1); k < TOL(5, 4); k++)
        for (size_t j = TOL(0, 1); j < TOL(5, 4); j++)
            for (int m = -2; m <= 2; m++) {             /* near the limit never wrong, well off it decided */
                const double unit = (base[k] < 1 ? 1 / base[k] : 1) * (base[j] > 1 ? base[j] : 1);
                const double hides = TOL(4e-9, 0) * base[k];        /* in tol of a load that is nearly all sideways */
                const double margin = (m == -2 || m == 2 ? TOL(1e-4, 0.1) : TOL(1e-6, 2e-2)) * unit + hides;
                const int side = m < 0 ? -1 : 1;
                sp_scene s;
                if (!m || margin > 0.9) continue;
                start(&s, 2, 1, 4);
                body(&s, 0, 0, 0, -1, SP_FIXED);
                body(&s, 1, 0, 0, 1, 0);
                bed(&s, 0, 1, 0, 0, 0, base[k], base[j], 1e5);
                s.gravity[0] = R(9.80665 * base[k] * (1 + side * margin));
                const int sure = (m == -2 || m == 2) && base[k] < TOL(1e3, 10);
                if (!verdict_is(&s, side < 0 ? SP_STABLE : SP_UNSTABLE, sure))
                    TEST_PRINT("    base %g by %g, margin %g\n", base[k], base[j], side * margin);
            }
}

TEST(friction_from_nothing_to_a_thousand)
{
    static const double mu[] = { 0, 1e-6, 1e-3, 1, 1e3 };
    for (size_t k = 0; k < 5; k++) {
        sp_scene s;
        column(&s, 4, 1, 1e-3, mu[k], 0);
        verdict_is(&s, SP_STABLE, 1);
        s.gravity[0] = -s.gravity[2] * R(mu[k] * 0.98);
        if (mu[k] > 0 && mu[k] < 100) verdict_is(&s, SP_STABLE, 1);
        s.gravity[0] = -s.gravity[2] * R(mu[k] * 1.02 + TOL(1e-8, 1e-2));
        if (!verdict_is(&s, SP_UNSTABLE, 1)) TEST_PRINT("    mu = %g\n", mu[k]);
    }
}

TEST(gravity_from_every_side)
{
    sp_scene s;
    column(&s, 8, 1, 0.5, 0.5, 0);
    s.gravity[2] = 0;
    verdict_is(&s, SP_STABLE, 1);
    s.gravity[2] = R(9.81);
    verdict_is(&s, SP_UNSTABLE, 1);
    s.gravity[2] = 0, s.gravity[0] = R(9.81);
    verdict_is(&s, SP_UNSTABLE, 1);
    s.gravity[0] = 0, s.gravity[1] = R(-1e-3);
    verdict_is(&s, SP_UNSTABLE, 1);
    s.gravity[1] = R(NAN);
    sp_result r;
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
    s.gravity[1] = R(INFINITY);
    CHECK_INT(sp_check(&s, NULL, &test_arena, &r), SP_E_NOT_FINITE);
}

/* From denormal to overflowing weights: the right verdict or a status. */
TEST(weights_of_any_size)
{
    static const double mass[] = {
        TOL(5e-324, 1.5e-45), TOL(1e-310, 1e-40), TOL(1e-300, 1e-37), TOL(1e-160, 1e-30), TOL(1e-80, 1e-20), 1e-9,
        1e9, TOL(1e80, 1e16), TOL(1e150, 1e18), TOL(1e155, 1e20), TOL(1e300, 1e37), TOL(1.7e308, 3.4e38)
    };
    for (size_t k = 0; k < sizeof mass / sizeof mass[0]; k++)
        for (int falls = 0; falls < 2; falls++) {
            sp_scene s;
            sp_result r;
            column(&s, 5, 1, 0.3, falls ? 0.4 : 0.7, 30);       /* tan 30 = .577 */
            s.block[1].mass = R(mass[k]);
            for (int i = 0; i < 3 && k < 2; i++) s.gravity[i] *= R(1024);       /* a weight that still has digits */
            const sp_status status = k > 1 ? checked(&s, NULL, &r) : sp_check(&s, NULL, &test_arena, &r);
            if (status) CHECK_INT(status, SP_E_NOT_FINITE);
            else if ((k > 1 || r.verdict) && !CHECK_INT(r.verdict, falls ? SP_UNSTABLE : SP_STABLE))
                TEST_PRINT("    mass %g\n", mass[k]);
            if (!status && !CHECK(numbers(r.f, 15) && numbers(r.dq, 12) && numbers(r.y0, 6)))
                TEST_PRINT("    mass %g\n", mass[k]);
        }
}

/* 7 ----------------------------------------------------------------------------------------- supports, none and in part */

TEST(nothing_free_or_nothing_to_carry_stands)
{
    sp_scene s;
    sp_result r;
    column(&s, 6, 1, 1, 0, 60);
    s.block[1].fixed = SP_FIXED;
    NEED(checked(&s, NULL, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.reason, SP_REASON_NOTHING);
    start(&s, 2, 0, 0);                                 /* no contact, and no load either */
    body(&s, 1, 0, 0, 0, 0);
    body(&s, 1, 5, 0, 0, 0);
    s.gravity[2] = 0;
    verdict_is(&s, SP_STABLE, 1);
}

TEST(floaters_fall)
{
    sp_scene s;
    sp_result r;
    column(&s, 6, 1, 1, 0.5, 0);
    CHECK_INT(sp_scene_body(&s, 1, s.block[1].centroid, 0, NULL), SP_E_CAPACITY);
    start(&s, 4, 2, 8);
    body(&s, 0, 0, 0, -1, SP_FIXED);
    body(&s, 1, 0, 0, 1, 0);
    bed(&s, 0, 1, 0, 0, 0, 1, 1, 0.5);
    body(&s, 1e-9, 9, 0, 1, 0);
    NEED(checked(&s, NULL, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.reason, SP_REASON_NO_CONTACT);
    CHECK(r.final);
    CHECK_WITHIN(r.dq[6], 0, 1e-9);
    CHECK(r.dq[12 + 2] < 0);
    body(&s, 3, 9, 0, 3, 0);                            /* and a companion on it: a group in the air */
    bed(&s, 2, 3, 9, 0, 2, 1, 1, 0.5);
    NEED(checked(&s, NULL, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_UNSTABLE);
    CHECK_INT(r.reason, SP_REASON_NO_SUPPORT);
    CHECK(r.final && r.dq[12 + 2] < 0 && r.dq[18 + 2] < 0);
}

/* A slippery slope of 30 degrees, falling towards -x, under a block held in some directions. */
static void held_on_a_slope(sp_scene *s, unsigned held, double mu)
{
    const double c = 0.8660254037844386, d = 0.5, centre[3] = { 0, 0, 0 }, p[3] = { c, 0, d }, q[3] = { 0, 1, 0 };
    start(s, 2, 1, 4);
    body(s, 0, d, 0, -c, SP_FIXED);
    body(s, 1, -0.5 * d, 0, 0.5 * c, held);
    quad(s, 0, 1, centre, p, q, mu);
}

TEST(a_block_held_against_sliding_stands)
{
    static const struct { unsigned held; double mu; sp_verdict want; } table[] = {
        { 0, 0, SP_UNSTABLE }, { 0, 0.55, SP_UNSTABLE }, { 0, 0.6, SP_STABLE },
        { 1, 0, SP_STABLE },                            /* x: a stop at its side */
        { 2, 0, SP_UNSTABLE }, { 2, 0.55, SP_UNSTABLE },/* y: nothing moves that way */
        { 4, 0, SP_STABLE },                            /* z: it hangs, the slope carries nothing */
        { 56, 0, SP_UNSTABLE },                         /* turning held: it slides all the same */
        { 57, 0, SP_STABLE }, { 62, 0, SP_STABLE }      /* x alone left: no force along x, none needed */
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        held_on_a_slope(&s, table[k].held, table[k].mu);
        if (!verdict_is(&s, table[k].want, 1)) TEST_PRINT("    held %u, mu %g\n", table[k].held, table[k].mu);
    }
}

TEST(a_block_held_against_turning_does_not_tip)
{
    static const struct { unsigned held; sp_verdict want; } table[] = {
        { 0, SP_UNSTABLE }, { 8, SP_UNSTABLE }, { 16, SP_STABLE }, { 32, SP_UNSTABLE }, { 40, SP_UNSTABLE }, { 56, SP_STABLE },
        { 1, SP_STABLE },                               /* a stop in x and friction below make the couple */
        { 2, SP_UNSTABLE }, { 4, SP_STABLE }, { 7, SP_STABLE }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        generated("two-cubes", "offset", 0.6, &s);
        s.block[1].fixed = table[k].held;
        if (!verdict_is(&s, table[k].want, 1)) TEST_PRINT("    held %u\n", table[k].held);
    }
}

/* Held in part and touching nothing: it stands iff its load points where it is held. */
TEST(a_prop_in_the_air)
{
    static const struct { unsigned held; double gx; sp_verdict want; } table[] = {
        { 4, 0, SP_STABLE }, { 4, 1, SP_UNSTABLE }, { 5, 1, SP_STABLE }, { 59, 0, SP_UNSTABLE }, { 59, 1, SP_UNSTABLE },
        { 7, 1, SP_STABLE }, { 56, 0, SP_UNSTABLE }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        start(&s, 1, 0, 0);
        body(&s, 1, 0, 0, 0, table[k].held);
        s.gravity[0] = R(table[k].gx);
        if (!verdict_is(&s, table[k].want, 1)) TEST_PRINT("    held %u, g_x %g\n", table[k].held, table[k].gx);
    }
}

/* A cube on a cube that is held in part and stands on nothing: the path to a support goes through what is held. */
TEST(a_partly_held_block_is_as_much_support_as_it_is_held)
{
    static const struct { unsigned held; double off, gx; sp_verdict want; } table[] = {
        { 4, 0, 0, SP_STABLE }, { 4, 0.3, 0, SP_UNSTABLE }, { 4 | 16, 0.3, 0, SP_STABLE }, { 4 | 8, 0.3, 0, SP_UNSTABLE },
        { 4, 0, 1, SP_UNSTABLE }, { 5, 0, 1, SP_UNSTABLE }, { 5 | 16, 0, 1, SP_STABLE }, { 3, 0, 0, SP_UNSTABLE },
        { 59, 0, 0, SP_UNSTABLE }, { 4 | 16, 0.6, 0, SP_UNSTABLE }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        const double off = table[k].off;
        start(&s, 2, 1, 4);
        body(&s, 1, 0, 0, 0, table[k].held);
        body(&s, 1, off, 0, 1, 0);
        bed(&s, 0, 1, off / 2, 0, 0.5, 0.5 - off / 2, 0.5, 0.84);
        s.gravity[0] = R(table[k].gx);
        if (!verdict_is(&s, table[k].want, 1)) TEST_PRINT("    held %u, offset %g, g_x %g\n", table[k].held, off, table[k].gx);
    }
}

/* A wedge held from turning between a slope and a wall, both slippery: the wall's push is known. */
TEST(a_stop_carries_the_push_of_statics)
{
    sp_scene s;
    sp_result r;
    sp_joint_force f;
    const double c = 0.8660254037844386, d = 0.5, centre[3] = { 0, 0, 0 }, p[3] = { c, 0, d }, q[3] = { 0, 1, 0 };
    start(&s, 2, 2, 8);
    body(&s, 0, 0, 0, -1, SP_FIXED);
    body(&s, 1, 0, 0, 1, 56);
    quad(&s, 0, 1, centre, p, q, 0);
    wall(&s, 0, 1, -2, 1, 0.5, 0);
    NEED(checked(&s, NULL, &r) == SP_OK);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(sp_joint_resultant(&s, &r, 1, &f), SP_OK);
    CHECK_NEAR(f.force[0], 9.80665 * d / c, TOL(1e-9, 1e-4));   /* W tan 30 */
    CHECK_INT(sp_joint_resultant(&s, &r, 0, &f), SP_OK);
    CHECK_NEAR(f.force[2], 9.80665, TOL(1e-9, 1e-4));
}

/* 8 --------------------------------------------------------------------------------------------------- random scenes */

/* A small scene of random kind and numbers: tilt, weights and friction too. */
static void anything(sp_scene *s)
{
    static const struct { const char *name, *a; double a0, a1; const char *b; double b0, b1; } kind[] = {
        { "wall", "rows", 1, 4, "jitter", 0, 0.4 },     { "rubble", "rows", 1, 3, "jitter", 0, 1 },
        { "arch", "n", 3, 15, "t", 0.05, 0.3 },         { "flat-arch", "n", 2, 9, "half", 0, 40 },
        { "vault", "around", 3, 9, "t", 0.05, 0.3 },    { "dome", "rings", 1, 3, "t", 0.05, 0.2 },
        { "diamond", "rows", 1, 5, "height", 0.1, 1 },  { "tower", "n", 1, 12, "lean", 0, 0.2 },
        { "overhang", "n", 1, 8, "factor", 0.5, 1.2 }
    };
    gen_scene g;
    const int k = (int)test_random_int(0, 8);
    test_arena.used = 0;
    CHECK_INT(gen_open(&g, kind[k].name), 1);
    CHECK_INT(gen_set(&g, kind[k].a, test_random_int((int32_t)kind[k].a0, (int32_t)kind[k].a1)), 1);
    CHECK_INT(gen_set(&g, kind[k].b, (double)test_random_real(kind[k].b0, kind[k].b1)), 1);
    if (k == 0 || k == 1) gen_set(&g, "bricks", test_random_int(1, 5));
    if (k == 4) gen_set(&g, "n", test_random_int(1, 3));
    if (k == 5) gen_set(&g, "segments", test_random_int(4, 9));
    gen_set(&g, "tilt", test_random_int(0, 2) ? 0 : (double)test_random_real(0, 60));
    gen_set(&g, "azimuth", (double)test_random_real(-180, 180));
    CHECK_INT(gen_build(&g, &test_arena, s), SP_OK);
    for (int32_t b = 0; b < s->count.blocks; b++) s->block[b].mass *= R(pow(10, (double)test_random_real(-2, 2)));
    for (int32_t j = 0; j < s->count.joints; j++) s->joint[j].strength.mu = test_random_real(0, 1.2);
}

/* Piles of plates of any weights slide at the joint of least friction, if that is less than the slope, and nowhere else. */
TEST(piles_of_random_weights_are_never_judged_wrong)
{
    const double slope = 0.36397023426620234;           /* tan 20 */
    for (int k = 0; k < 600; k++) {
        const double spread = TOL(16.0, 10.0) * (k % 9) / 8, near = k % 2 ? TOL(1e-4, 1e-2) : 0.05;
        const int32_t n = test_random_int(2, 7);
        double least = 9;
        sp_scene s;
        start(&s, n + 1, n, 4 * n);
        body(&s, 0, 0, 0, -1, SP_FIXED);
        for (int32_t i = 0; i < n; i++) {
            const double mu = slope * (1 + near * (test_random_int(0, 5) ? 1 + 9 * (double)test_random_real(0, 1) : -1));
            least = mu < least ? mu : least;
            body(&s, pow(10, spread * (double)test_random_real(-0.5, 0.5)), 0, 0, 2 * i + 1, 0);
            bed(&s, i, i + 1, 0, 0, 2 * i, 15, 15, mu);
        }
        gen_gravity(20, 31, s.gravity);
        if (!verdict_is(&s, least > slope ? SP_STABLE : SP_UNSTABLE, 0))
            TEST_PRINT("    trial %d: %d plates, weights over 1e%g\n", k, (int)n, spread);
    }
}

TEST(random_scenes_have_evidence_that_holds_with_and_without_hint)
{
    for (int k = 0; k < 60; k++) {
        sp_scene s;
        sp_settings settings = sp_settings_default();
        sp_result r;
        anything(&s);
        if (k % 3 == 1) settings.faces = test_random_int(3, 16), settings.inscribed = test_random_int(0, 1);
        CHECK_INT(checked(&s, &settings, &r), SP_OK);
    }
}

TEST(random_scenes_take_exactly_their_memory)
{
    for (int k = 0; k < 40; k++) {
        sp_scene s;
        sp_settings settings = sp_settings_default();
        sp_result r;
        size_t bytes = 0;
        anything(&s);
        settings.faces = k % 2 ? 0 : test_random_int(3, 64);
        settings.localise = test_random_int(0, 1);
        static const sp_stage_id more[] = { SP_STAGE_LEAST_SQUARES, SP_STAGE_DENSE, SP_STAGE_POLISH };
        if (k % 4 == 3) {
            settings.stage[1] = more[test_random_int(0, 1)];
            settings.stage[2] = SP_STAGE_POLISH;
            settings.stage[3] = SP_STAGE_EXACT;
            settings.stage_count = 4;                   /* polish may decide, and takes what the search in all rows would */
            settings.effect[SP_EFFECT_DEPTH] = settings.effect[SP_EFFECT_FRICTION] = SP_WITH;
        }
        NEED(sp_memory(&s, SP_FOR_CHECK, &settings, test_arena, &bytes) == SP_OK);
        NEED(bytes > 0 && bytes < test_arena.cap - test_arena.used);
        sp_arena a = test_arena;
        a.cap = a.used + bytes;
        CHECK_INT(sp_check(&s, &settings, &a, &r), SP_OK);
        a = test_arena;
        a.cap = a.used + bytes - 1;
        const size_t used = a.used;
        CHECK_INT(sp_check(&s, &settings, &a, &r), SP_E_MEMORY);
        CHECK_INT(a.used, used);
    }
}

TEST_LIST(attack)
    RUN(no_squeeze_holds_a_block_in_a_slippery_slot)
    RUN(tiny_friction_is_told_honestly)
    RUN(the_bound_on_forces_is_the_callers)
    RUN(pebbles_on_and_under_cathedrals)
    RUN(a_pebble_slides_alone)
    RUN(sandwiches_of_unequal_weights)
    RUN(a_cathedral_lends_a_pebble_no_tolerance)
    RUN(a_cathedral_on_a_pebble_does_not_sink)
    RUN(a_force_changed_by_more_than_tol_is_refused)
    RUN(tension_is_no_evidence)
    RUN(friction_beyond_the_cone_is_no_evidence)
    RUN(forces_above_the_cap_are_no_evidence)
    RUN(no_hint_misleads)
    RUN(a_hint_and_a_squeeze_together_hold_nothing)
    RUN(hints_along_motions_no_contact_feels_do_nothing)
    RUN(motions_that_prove_nothing)
    RUN(tiny_motions_elsewhere_change_no_proof)
    RUN(evidence_of_another_scene_is_refused)
    RUN(just_beside_the_limit_units_place_and_order_do_not_matter)
    RUN(a_block_on_a_point_stands_above_it_only)
    RUN(a_block_on_an_edge_stands_above_it_only)
    RUN(three_points_carry_what_is_above_their_triangle)
    RUN(many_corners_and_repeated_joints_slide_and_topple_as_one)
    RUN(collinear_corners_change_nothing)
    RUN(needles_and_plates_topple_where_they_should)
    RUN(friction_from_nothing_to_a_thousand)
    RUN(gravity_from_every_side)
    RUN(weights_of_any_size)
    RUN(nothing_free_or_nothing_to_carry_stands)
    RUN(floaters_fall)
    RUN(a_block_held_against_sliding_stands)
    RUN(a_block_held_against_turning_does_not_tip)
    RUN(a_prop_in_the_air)
    RUN(a_partly_held_block_is_as_much_support_as_it_is_held)
    RUN(a_stop_carries_the_push_of_statics)
    RUN(piles_of_random_weights_are_never_judged_wrong)
    RUN(random_scenes_have_evidence_that_holds_with_and_without_hint)
    RUN(random_scenes_take_exactly_their_memory)
TEST_END
