/* Only the effects a scene calls for: what is left out changes no verdict, and says so. */
#include "../test.h"
#include "../scenes/kinds.h"

#include <math.h>

#ifdef SP_NO_IPM                                        /* the proximal path takes any number of steps, in float not far enough */
#define TELLS 0
#define OPEN (sizeof(sp_real) == 4)
#else
#define TELLS (sizeof(sp_real) == 8)
#define OPEN 0
#endif

enum { MOST = 128 };                                    /* blocks of a part */

/* A generated scene, in test_arena. */
static sp_scene part(const char *name, const char *param, double value, double mu)
{
    gen_scene g;
    sp_scene s;
    memset(&s, 0, sizeof s);
    CHECK_INT(gen_open(&g, name), 1);
    if (param) CHECK_INT(gen_set(&g, param, value), 1);
    if (mu >= 0) CHECK_INT(gen_set(&g, "mu", mu), 1);
    CHECK_INT(gen_build(&g, &test_arena, &s), SP_OK);
    return s;
}

/* How parts are put together: lengths times `length`, masses times `mass`, everything else way round where `turned`. */
typedef struct manner { double length, mass; int turned; } manner;

static sp_scene room(int32_t blocks, int32_t joints, int32_t points)
{
    sp_capacity cap;
    sp_scene s;
    memset(&cap, 0, sizeof cap);
    cap.blocks = blocks;
    cap.joints = joints;
    cap.points = points;
    cap.loads = 4;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    return s;
}

/* `in` moved by x [m] along x, without its meshes; turned: last blocks and joints first, B called A, corners from the next on. */
static void add(sp_scene *out, const sp_scene *in, double x, manner m)
{
    int32_t number[MOST];
    for (int32_t q = 0; q < in->count.blocks; q++) {
        const int32_t k = m.turned ? in->count.blocks - 1 - q : q;
        const sp_block *b = &in->block[k];
        sp_real c[3];
        for (int i = 0; i < 3; i++) c[i] = R(m.length) * (b->centroid[i] + (i ? 0 : R(x)));
        CHECK_INT(sp_scene_body(out, R(m.mass) * b->mass, c, b->fixed, &number[k]), SP_OK);
    }
    for (int32_t q = 0; q < in->count.joints; q++) {
        const sp_joint *f = &in->joint[m.turned ? in->count.joints - 1 - q : q];
        sp_real xyz[3 * 16];
        for (int32_t v = 0; v < f->points; v++) {
            const int32_t from = m.turned ? (2 * f->points - v) % f->points : v;        /* backwards: seen from the other side */
            for (int i = 0; i < 3; i++)
                xyz[3 * v + i] = R(m.length) * (in->point[f->point + from][i] + (i ? 0 : R(x)));
        }
        CHECK_INT(sp_scene_joint(out, number[m.turned ? f->b : f->a], number[m.turned ? f->a : f->b], f->points, xyz,
                                     &f->strength, NULL), SP_OK);
    }
}

static sp_result check(const sp_scene *s, const sp_settings *set, sp_arena *a)
{
    sp_result r;
    sp_evidence e;
    memset(&r, 0, sizeof r);
    CHECK_INT(sp_check(s, set, a, &r), SP_OK);
    CHECK_INT(sp_verify(s, set, &r, *a, &e), SP_OK);
    CHECK_INT(e.verdict, r.verdict == SP_UNDECIDED ? e.verdict : r.verdict);
    return r;
}

/* The verdict with every effect on. */
static sp_result full(const sp_scene *s, const sp_settings *set, sp_arena *a)
{
    sp_settings all = set ? *set : sp_settings_default();
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) all.effect[k] = SP_WITH;
    return check(s, &all, a);
}

static const manner plain = { 1, 1, 0 }, other = { 39.37, 2.2046, 1 };

static sp_scene two(const char *left, const char *right, const char *param, double value, manner m)
{
    const sp_scene a = part(left, NULL, 0, -1), b = part(right, param, value, -1);
    sp_scene s = room(a.count.blocks + b.count.blocks, a.count.joints + b.count.joints, a.count.points + b.count.points);
    add(&s, &a, 0, m);
    add(&s, &b, 100, m);
    for (int k = 0; k < 3; k++) s.gravity[k] *= R(m.length);
    return s;
}

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
        CHECK_INT(full(&s, NULL, &rest).verdict, r.verdict);
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
        exact.cap = bytes;
        const sp_arena fresh = exact;
        sp_result r, other_way;
        CHECK_INT(sp_check(&s, NULL, &exact, &r), SP_OK);
        CHECK_INT(r.spent.peak_bytes, bytes);
        const sp_verdict verdict = r.verdict;
        exact = fresh;
        exact.cap = bytes - 1;
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
    a.cap = bytes;
    return a;
}

TEST(seven_h_models_side_by_side_are_refuted_each_and_verified_in_the_memory_told)
{
    const sp_scene h = part("h-model", NULL, 0, 0.45);
    sp_scene s = room(7 * h.count.blocks, 7 * h.count.joints, 7 * h.count.points);
    sp_settings set = sp_settings_default();
    sp_evidence e;
    for (int k = 0; k < 7; k++) add(&s, &h, 20 * k, plain);
    set.coupled.asked = 1;
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
    static const int32_t wrong[] = { 0, -1, 8, INT32_MAX };             /* a proof of what it is not of */
    for (int k = 0; k < 4; k++) {
        r.coupled.proof.island = wrong[k];
        CHECK_INT(sp_verify(&s, &set, &r, a, &e), SP_OK);
        CHECK_INT(e.verdict, SP_STABLE);
        CHECK(!(e.margin > 0));
    }
}

TEST(what_refutes_one_island_is_no_proof_against_another)
{
    const sp_scene h = part("h-model", NULL, 0, 0.45), c = part("two-cubes", NULL, 0, -1);
    sp_scene s = room(2 * h.count.blocks + 4, 2 * h.count.joints + 2, 2 * h.count.points + 8);
    sp_settings set = sp_settings_default();
    sp_evidence e;
    set.coupled.asked = 1;
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
    for (int32_t k = 0; k < SOME_OF(24, 12); k++) {
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
        const sp_result r = checked_exactly(&s, &set, k < 3);
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
        if (k >= SOME_OF(8, 3)) continue;
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
    CHECK(seen[SP_COUPLING_COUPLED] > SOME_OF(20, 9) && seen[SP_COUPLING_REFUTED] > SOME_OF(TOL(20, 5), TOL(5, 1)));
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

/* Rows 1, 2, 3, 4, 5, 4, 3, 2, 1: all joints level, all loads plumb, and yet only friction holds it. */
TEST(a_diamond_of_five_rows_without_friction_is_undecided_and_of_four_stands)
{
    sp_settings set = sp_settings_default();
    set.effect[SP_EFFECT_FRICTION] = SP_WITHOUT;
    for (int32_t rows = 4; rows <= 5; rows++) {
        test_arena.used = 0;
        const sp_scene s = part("diamond", "rows", rows, 0.84);
        sp_arena a = test_arena;
        const sp_result planned = check(&s, NULL, &a), all = full(&s, NULL, &a), without = check(&s, &set, &a);
        CHECK_INT(planned.verdict, SP_STABLE);
        CHECK_INT(all.verdict, SP_STABLE);
        CHECK_INT(without.verdict, rows == 4 ? SP_STABLE : SP_UNDECIDED);
        CHECK_INT(without.reason, rows == 4 ? SP_REASON_FORCES : SP_REASON_EFFECT);
        CHECK_INT(without.missing, SP_EFFECT_FRICTION);
        CHECK_INT(without.effect[SP_EFFECT_FRICTION], SP_WHY_LEFT_OUT);
    }
}

/* Walls, arches and rubble lie in a plane, what stands and what falls: a third of the flops or less, the forces as good. Least of
 * all where the first guess is right and its proof, always in 3 dimensions, is much of the work. */
TEST(what_has_a_mirror_is_decided_in_the_plane_with_a_third_of_the_work)
{
    static const struct { const char *name, *param; double value; sp_verdict verdict; } scene[] = {
        { "wall", "size", 54, SP_STABLE }, { "wall", "jitter", 0.3, SP_STABLE }, { "arch", "n", 12, SP_STABLE },
        { "rubble", NULL, 0, SP_STABLE }, { "wall", "tilt", 5, SP_STABLE }, { "flat-arch", NULL, 0, SP_STABLE },
        { "wall", "tilt", 45, SP_UNSTABLE }, { "arch", "t", 0.09, SP_UNSTABLE }, { "tower", "lean", 0.1, SP_UNSTABLE },
        { "overhang", "factor", 1.1, SP_UNSTABLE }, { "diamond", "mu", 0.1, SP_UNSTABLE }
    };
    for (int inscribed = 0; inscribed < 2; inscribed++) {
        sp_real planned = 0, whole = 0;
        for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++) {
            sp_settings set = sp_settings_default();
            test_arena.used = 0;
            const sp_scene s = part(scene[k].name, scene[k].param, scene[k].value, -1);
            sp_arena a = test_arena;
            set.faces = inscribed ? 8 : 0;
            const sp_result all = full(&s, &set, &a), r = check(&s, &set, &a);
            if (OPEN && !all.verdict) continue;
            CHECK_INT(all.verdict, scene[k].verdict);
            CHECK_INT(r.verdict, scene[k].verdict);
            CHECK_INT(r.effect[SP_EFFECT_DEPTH], SP_WHY_MIRROR);
            CHECK_INT(all.effect[SP_EFFECT_DEPTH], SP_WHY_ASKED);
            if (!CHECK(R(2.2) * (sp_real)r.spent.total.flops <= (sp_real)all.spent.total.flops))
                TEST_PRINT("    %s: %ld of %ld flops\n", scene[k].name, (long)r.spent.total.flops, (long)all.spent.total.flops);
            CHECK(scene[k].verdict == SP_UNSTABLE || r.imbalance <= r.tol / 2);
            planned += (sp_real)r.spent.total.flops;
            whole += (sp_real)all.spent.total.flops;
        }
        CHECK((OPEN ? R(2.5) : 3) * planned <= whole);
    }
}

TEST(a_mirror_is_found_in_any_direction_and_none_where_there_is_none)
{
    for (int k = 0; k < 4; k++) {
        test_arena.used = 0;
        sp_scene s = part("arch", "n", 9, -1);
        sp_arena a = test_arena;
        if (k == 1) { s.gravity[0] = R(0.3); }                          /* along the arch's own plane */
        if (k == 2) { s.gravity[1] = R(0.3); }                          /* across it */
        if (k == 3) s.block[4].centroid[1] += R(1e-3);
        const sp_result r = check(&s, NULL, &a), all = full(&s, NULL, &a);
        CHECK_INT(r.verdict, all.verdict);
        CHECK_INT(r.effect[SP_EFFECT_DEPTH], k < 2 ? SP_WHY_MIRROR : SP_WHY_CALLED);
    }
}

/* A board across two others: no mirror once it is moved along and across; level joints, so pressure alone decides. */
TEST(level_joints_without_a_mirror_stand_by_pressure_alone)
{
    const sp_real ground[3] = { 0, 0, R(-1) }, top[3] = { R(0.13), R(0.07), R(1.25) };
    const sp_strength strength = sp_strength_friction(R(0.6));
    sp_scene s = room(4, 4, 16);
    CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const double x = 2 * k - 1;
        const sp_real c[3] = { R(x), R(0.1 * k), R(0.5) };
        const sp_real foot[12] = { R(x - 0.3), R(-0.5), 0, R(x + 0.3), R(-0.5), 0, R(x + 0.3), R(0.5), 0, R(x - 0.3), R(0.5), 0 };
        CHECK_INT(sp_scene_body(&s, R(1000), c, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 1 + k, 4, foot, &strength, NULL), SP_OK);
    }
    CHECK_INT(sp_scene_body(&s, R(1500), top, 0, NULL), SP_OK);
    for (int k = 0; k < 2; k++) {
        const double x = 2 * k - 1;
        const sp_real seat[12] = { R(x - 0.3), R(-0.4), R(1), R(x + 0.3), R(-0.4), R(1), R(x + 0.3), R(0.45), R(1), R(x - 0.3), R(0.45), R(1) };
        CHECK_INT(sp_scene_joint(&s, 1 + k, 3, 4, seat, &strength, NULL), SP_OK);
    }
    sp_arena a = test_arena;
    const sp_result r = check(&s, NULL, &a), all = full(&s, NULL, &a);
    CHECK_INT(r.verdict, SP_STABLE);
    CHECK_INT(r.effect[SP_EFFECT_FRICTION], SP_WHY_PRESSURE);
    CHECK_INT(all.effect[SP_EFFECT_FRICTION], SP_WHY_ASKED);
    if (sizeof(sp_real) == 8) CHECK(2 * r.spent.total.flops <= all.spent.total.flops);
}

TEST(the_third_dimension_left_out_of_a_scene_without_a_mirror_is_undecided)
{
    sp_settings set = sp_settings_default();
    const sp_scene s = part("dome", NULL, 0, -1);
    sp_arena a = test_arena;
    set.effect[SP_EFFECT_DEPTH] = SP_WITHOUT;
    const sp_result r = check(&s, &set, &a);
    CHECK_INT(r.verdict, SP_UNDECIDED);
    CHECK_INT(r.reason, SP_REASON_EFFECT);
    CHECK_INT(r.missing, SP_EFFECT_DEPTH);
}

/* Random scenes of every kind on both sides of their limits: the verdict as planned is that of the full simulation, and what the
 * plan told of flops is right within a factor of 5 where forces are found without interior points. */
TEST(planned_and_full_simulation_agree_on_random_scenes)
{
    int32_t plane[3] = { 0, 0, 0 }, plumb[3] = { 0, 0, 0 }, verdict[3] = { 0, 0, 0 };
    for (int k = 0; k < SOME_OF(300, 100); k++) {
        sp_scene s;
        sp_settings set;
        sp_outlook o;
        test_arena.used = 0;
        NEED(kinds_make(k, &test_arena, &s, &set) == SP_OK);
        sp_arena a = test_arena;
        CHECK_INT(sp_plan(&s, &set, a, &o), SP_OK);
        const sp_result r = check(&s, &set, &a), all = full(&s, &set, &a);
        const int near = sizeof(sp_real) == 4 && (!r.verdict || !all.verdict);          /* float is undecided sooner */
        if (!CHECK(r.verdict == all.verdict || near))
            TEST_PRINT("    %d, %s: %d as planned, %d\n", k, kinds_table[k % KINDS].name, (int)r.verdict, (int)all.verdict);
        if (TELLS && r.verdict == SP_STABLE && !r.spent.total.interior && !CHECK(o.flops < 5 * r.spent.total.flops && r.spent.total.flops < 5 * o.flops))
            TEST_PRINT("    %d, %s: %ld flops of %ld\n", k, kinds_table[k % KINDS].name, (long)r.spent.total.flops, (long)o.flops);
        plane[r.verdict] += r.effect[SP_EFFECT_DEPTH] == SP_WHY_MIRROR;
        plumb[r.verdict] += r.effect[SP_EFFECT_FRICTION] == SP_WHY_PRESSURE;
        verdict[r.verdict]++;
    }
    CHECK(verdict[SP_STABLE] > SOME_OF(80, 25) && verdict[SP_UNSTABLE] > SOME_OF(80, 25));
    CHECK(plane[SP_STABLE] > SOME_OF(60, 20) && plane[SP_UNSTABLE] > SOME_OF(30, 10));
    CHECK(plumb[SP_STABLE] > SOME_OF(30, 10) && plumb[SP_UNSTABLE] > SOME_OF(3, 0));
}

/* Piles, each block moved along and across on the one below: no friction can hold what falls, whatever mu is. The same piles with
 * the world tilted may want friction, and so may piers under slabs, cycles. */
TEST(a_forest_of_level_joints_falls_by_pressure_alone_and_nothing_else_does)
{
    int32_t fell = 0;
    for (int k = 11; k < 300; k += k % KINDS == 11 ? 1 : KINDS - 1) {
        sp_scene s;
        sp_settings set;
        test_arena.used = 0;
        NEED(kinds_make(k, &test_arena, &s, &set) == SP_OK);
        for (int32_t q = 0; q < s.count.joints; q++) s.joint[q].strength.mu = R(q % 2 ? 50 : 0.6);
        sp_arena a = test_arena;
        const sp_result r = check(&s, NULL, &a), all = full(&s, NULL, &a);
        CHECK_INT(r.verdict, all.verdict);
        if (sizeof(sp_real) == 8) CHECK_INT(r.effect[SP_EFFECT_FRICTION], SP_WHY_PRESSURE);
        CHECK(r.final || !all.final);
        fell += r.verdict == SP_UNSTABLE;
        gen_gravity(1, 30, s.gravity);
        CHECK(check(&s, NULL, &a).effect[SP_EFFECT_FRICTION] != SP_WHY_PRESSURE);
    }
    CHECK(fell > 4);
    for (int k = 14; k < 300; k += KINDS) {
        sp_scene s;
        sp_settings set;
        test_arena.used = 0;
        NEED(kinds_make(k, &test_arena, &s, &set) == SP_OK);
        sp_arena a = test_arena;
        const sp_result r = check(&s, NULL, &a);
        CHECK(r.verdict == SP_STABLE || r.effect[SP_EFFECT_FRICTION] != SP_WHY_PRESSURE);
    }
}

/* Piers under slabs have cycles: what pressure does not hold friction may. Where there is none nothing may, and both answers are
 * told, without a search in 6 rows; the same as its. */
TEST(without_friction_pressure_alone_tells_what_falls_although_joints_form_rings)
{
    int32_t told[3] = { 0, 0, 0 };
    for (int k = 14; k < 600; k += KINDS) {
        sp_scene s;
        sp_settings set;
        test_arena.used = 0;
        NEED(kinds_make(k, &test_arena, &s, &set) == SP_OK);
        for (int32_t q = 0; q < s.count.joints; q++) s.joint[q].strength.mu = 0;
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), all = full(&s, &set, &a);
        CHECK(r.verdict == all.verdict || (OPEN && !all.verdict));
        if (sizeof(sp_real) == 8 && r.stage == SP_STAGE_EXACT && r.islands.count < 2) CHECK_INT(r.effect[SP_EFFECT_FRICTION], SP_WHY_PRESSURE);
        CHECK(r.final || !all.final);
        told[r.verdict]++;
    }
    CHECK(told[SP_STABLE] > 5 && told[SP_UNSTABLE] > 5);
}

TEST(an_effect_left_out_by_force_never_makes_a_wrong_verdict)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "arch", "n", 7 }, { "arch", "t", 0.09 }, { "incline", NULL, 0 }, { "keystone", NULL, 0 }, { "wall", "size", 54 },
        { "overhang", "factor", 1.1 }, { "overhang", NULL, 0 }, { "diamond", "mu", 0.1 }, { "tower", "lean", 0.1 }
    };
    for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++) {
        test_arena.used = 0;
        const sp_scene s = part(scene[k].name, scene[k].param, scene[k].value, -1);
        sp_arena a = test_arena;
        const sp_result all = full(&s, NULL, &a);
        for (int q = 0; q < SP_EFFECTS_FORCED; q++) {
            sp_settings set = sp_settings_default();
            set.effect[q] = SP_WITHOUT;
            const sp_result r = check(&s, &set, &a);
            CHECK(r.verdict == all.verdict || (r.verdict == SP_UNDECIDED && r.reason == SP_REASON_EFFECT));
        }
    }
}

static int32_t free_blocks(const sp_scene *s)
{
    int32_t n = 0;
    for (int32_t k = 0; k < s->count.blocks; k++) n += s->block[k].fixed != SP_FIXED;
    return n;
}

TEST(a_plan_names_every_effect_and_its_bytes_are_those_of_the_check)
{
    sp_scene s = two("wall", "wall", NULL, 0, plain);
    sp_outlook o;
    size_t bytes = 0;
    sp_settings set = sp_settings_default();
    CHECK_INT(sp_plan(&s, NULL, test_arena, &o), SP_OK);
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, NULL, test_arena, &bytes), SP_OK);
    CHECK_INT(o.bytes, bytes);
    set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
    CHECK_INT(sp_memory(&s, SP_FOR_CHECK, &set, test_arena, &bytes), SP_OK);
    CHECK_INT(o.full_bytes, bytes);
    CHECK_INT(o.islands, 2);
    CHECK(o.bytes < o.full_bytes);
    CHECK_INT(o.effect[SP_EFFECT_FRICTION].why, SP_WHY_CALLED);
    CHECK_INT(o.effect[SP_EFFECT_DEPTH].why, SP_WHY_MIRROR);
    CHECK(o.effect[SP_EFFECT_DEPTH].flops > 0 && 3 * o.flops < o.full_flops && o.unknowns < o.full_unknowns);
    CHECK_INT(o.effect[SP_EFFECT_TOGETHER].why, SP_WHY_APART);
    CHECK_INT(o.effect[SP_EFFECT_STRENGTH].why, SP_WHY_ABSENT);
    CHECK_INT(o.effect[SP_EFFECT_LOADS].why, SP_WHY_ABSENT);
    CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_NOT_ASKED);
    CHECK_INT(o.effect[SP_EFFECT_DYNAMICS].why, SP_WHY_STATICS);
    CHECK_INT(o.full_unknowns, 6 * free_blocks(&s) + 3 * s.count.points);
    s.live = 1;
    s.body[0] = R(0.1);
    set.coupled.asked = 1;
    set.effect[SP_EFFECT_FRICTION] = SP_WITHOUT;
    CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_OK);
    CHECK_INT(o.effect[SP_EFFECT_TOGETHER].why, SP_WHY_ASKED);
    CHECK_INT(o.effect[SP_EFFECT_LIVE].why, SP_WHY_CALLED);
    CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_CALLED);
    CHECK_INT(o.effect[SP_EFFECT_FRICTION].why, SP_WHY_LEFT_OUT);
}

#ifndef SP_NO_CRA
/* A tree of square slabs on a support: slab k rests on slab (k - 1) / 2, two side by side, each a little askew; gravity leans. halves:
 * every joint is two, the second from its other side. */
static void tree(int32_t n, double lean, int halves, sp_scene *s)
{
    const sp_strength strength = sp_strength_friction(R(0.6));
    double x[16] = { 0 }, z[16] = { 0 }, half[16] = { 2 };
    const sp_real ground[3] = { 0, 0, R(-1) };
    test_arena.used = 0;
    *s = room(n + 1, 2 * n, 8 * n);
    CHECK_INT(sp_scene_body(s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int32_t k = 0; k < n; k++) {
        const int32_t on = k ? (k - 1) / 2 : 0;
        if (k) {
            half[k] = 0.45 * half[on];
            x[k] = x[on] + (k % 2 ? -0.5 : 0.5) * half[on] * 1.02;
            z[k] = z[on] + 0.3;
        }
        const double c = 1.1 * half[k] / 2, y = (double)test_random_real(-0.05, 0.05), l = -y, d = half[k] / 2;
        const sp_real at[3] = { R(x[k] + y), R(y), R(z[k] + 0.15) };
        const sp_real corner[12] = { R(x[k] - d), R(-c), R(z[k]), R(x[k] + d), R(l - c), R(z[k]), R(x[k] + d), R(c), R(z[k]),
                                     R(x[k] - d), R(l + c), R(z[k]) };
        CHECK_INT(sp_scene_body(s, R(100 * half[k]), at, 0, NULL), SP_OK);
        for (int part = 0; part < 1 + halves; part++) {         /* corners 0, 1 below, 2, 3 above: cut across the middle */
            sp_real xyz[12];
            for (int v = 0; v < 4; v++)
                for (int i = 0; i < 3; i++) {
                    const int q = part ? 3 - v : v, cut = halves && (part ? q < 2 : q > 1);
                    xyz[3 * v + i] = cut ? (corner[3 * q + i] + corner[3 * (3 - q) + i]) / 2 : corner[3 * q + i];
                }
            const int32_t below = k ? on + 1 : 0;
            CHECK_INT(sp_scene_joint(s, part ? k + 1 : below, part ? below : k + 1, 4, xyz, &strength, NULL), SP_OK);
        }
    }
    s->gravity[0] = R(9.8 * lean);
}

/* The coupled check with and without its search. Without: fewer iterations than 300 leave nothing out. */
static sp_result with_search(const sp_scene *s, sp_settings set, sp_arena *a)
{
    set.iterations = 299;
    return check(s, &set, a);
}

static void agree_coupled(const sp_scene *s, const sp_settings *set, int *told)
{
    sp_arena a = test_arena;
    const sp_result r = check(s, set, &a), all = with_search(s, *set, &a);
    sp_evidence e;
    *told += r.effect[SP_EFFECT_COUPLED] == SP_WHY_FOREST;
    CHECK_INT(all.effect[SP_EFFECT_COUPLED] == SP_WHY_FOREST, all.coupled.verdict == SP_COUPLING_COUPLED && !all.coupled.rounds);
    if (r.verdict && all.verdict) CHECK_INT(r.verdict, all.verdict);
    if (all.verdict) CHECK(r.verdict);
    if (r.level != SP_COUPLED) return;
    CHECK_INT(sp_verify(s, set, &r, a, &e), SP_OK);
    CHECK_INT(e.level, SP_COUPLED);
    CHECK(e.residual <= 1);
}

TEST(what_hangs_on_its_supports_as_a_forest_is_coupled_without_a_search)
{
    static const double ratio[] = { TOL(1e-2, 1e-1), 1, 100, 1e6 };
    int told = 0;
    for (int k = 0; k < 24; k++) {
        sp_settings set = sp_settings_default();
        sp_scene s;
        set.coupled.asked = 1;
        set.coupled.eps = k % 5 == 4 ? 0 : R(1e-4);
        set.coupled.eta = R(1e-4 * ratio[k % 4]);
        set.coupled.box = k % 3 == 1;
        set.faces = k % 6 == 5 ? 8 : 0;
        tree(1 + k % 15, k % 2 ? 0 : 0.05, k % 7 > 3, &s);
        int here = 0;
        agree_coupled(&s, &set, &here);
        CHECK_INT(here, 1);
        told += here;
    }
    CHECK_INT(told, 24);
    sp_settings set = sp_settings_default();
    set.coupled.asked = 1;
    test_arena.used = 0;
    const sp_scene s = part("tower", "n", 10, -1);
    sp_arena a = test_arena;
    const sp_result r = check(&s, &set, &a), all = with_search(&s, set, &a);
    CHECK_INT(r.level, SP_COUPLED);
    CHECK(5 * r.coupled.cost.flops < all.coupled.cost.flops && r.coupled.cost.factorisations == 0);
    sp_outlook o;
    CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_OK);
    CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_FOREST);
    CHECK(o.effect[SP_EFFECT_COUPLED].flops > 0 && o.flops + o.effect[SP_EFFECT_COUPLED].flops <= o.full_flops);
}

/* A couple about the upright on three corners, whose pressure is given: friction holds 0.445 mu W m, and spread as the pressure
 * 0.275 mu W m, where the far corner is at the rim of its cone. In between only the search finds a motion. */
TEST(a_twisted_slab_is_searched_where_friction_spread_as_pressure_does_not_do)
{
    static const struct { double twist; int told; sp_verdict verdict; } ask[] = {
        { 0, 1, SP_STABLE }, { 0.27, 1, SP_STABLE }, { 0.3, 0, SP_STABLE }, { 0.43, 0, SP_STABLE }, { 0.46, 0, SP_UNSTABLE } };
    const sp_real ground[3] = { 0, 0, R(-1) }, at[3] = { 0, 0, R(0.2) };
    const sp_real corner[9] = { 0, 1, 0, R(-0.3), R(-0.2), 0, R(0.3), R(-0.2), 0 };
    const sp_strength strength = sp_strength_friction(R(0.5));
    for (int k = 0; k < 5; k++) {
        const sp_load load = { 1, 0, { at[0], at[1], at[2] }, { 0, 0, 0 }, { 0, 0, R(ask[k].twist * 0.5 * 100 * 9.80665) }, 0 };
        sp_settings set = sp_settings_default();
        int told = 0;
        set.coupled.asked = 1;
        test_arena.used = 0;
        sp_scene s = room(2, 1, 3);
        CHECK_INT(sp_scene_body(&s, 0, ground, SP_FIXED, NULL), SP_OK);
        CHECK_INT(sp_scene_body(&s, 100, at, 0, NULL), SP_OK);
        CHECK_INT(sp_scene_joint(&s, 0, 1, 3, corner, &strength, NULL), SP_OK);
        CHECK_INT(sp_scene_load(&s, &load, NULL), SP_OK);
        agree_coupled(&s, &set, &told);
        CHECK_INT(told, ask[k].told);
        sp_arena a = test_arena;
        CHECK_INT(check(&s, &set, &a).verdict, ask[k].verdict);
    }
}

TEST(a_coupled_check_agrees_with_its_search_on_random_scenes)
{
    static const struct { const char *name, *param; double low, high; } kind[] = {
        { "tower", "lean", 0.02, 0.12 }, { "incline", "angle", -45, 45 }, { "overhang", "factor", 0.7, 1.1 }, { "topple", "angle", -20, 20 },
        { "cantilever", "reach", 0.8, 1.5 }, { "incline", "turn", -90, 90 }, { "keystone", "angle", -30, 30 }, { "arch", "t", 0.09, 0.2 }
    };
    int told = 0;
    for (int k = 0; k < 64; k++) {
        sp_settings set = sp_settings_default();
        set.coupled.asked = 1;
        set.coupled.nodes = 0;
        set.coupled.box = k / 8 % 2;
        set.faces = k / 16 % 2 ? 8 : 0;
        test_arena.used = 0;
        const double value = (double)test_random_real(kind[k % 8].low, kind[k % 8].high);
        const sp_scene s = part(kind[k % 8].name, kind[k % 8].param, value, k / 8 % 3 ? -1 : (double)test_random_real(0.1, 0.9));
        agree_coupled(&s, &set, &told);
    }
    CHECK(told > 20);
}

/* Rings with a mirror: the motion found in the plane is judged in space, and what is not found there is decided in space. */
TEST(a_motion_is_looked_for_in_the_plane_first_and_what_is_not_there_is_decided_in_space)
{
    static const struct { const char *name, *param; double low, high; } kind[] = {
        { "arch", "t", 0.11, 0.2 }, { "keystone", "angle", -30, 30 }, { "h-model", NULL, 0, 0 }, { "wall", "rows", 2, 5 },
        { "diamond", "rows", 2, 4 }
    };
    int plane = 0, refuted = 0, told = 0;
    int64_t flops = 0, most = 0;
    for (int k = 0; k < 60; k++) {
        sp_settings set = sp_settings_default();
        set.localise = 0;
        set.coupled.asked = 1;
        set.coupled.box = k / 5 % 2;
        set.faces = k / 10 % 2 ? 8 : 0;
        set.inscribed = k / 20 % 2;
        test_arena.used = 0;
        const double value = (double)test_random_real(kind[k % 5].low, kind[k % 5].high);
        const double mu = (double)test_random_real(0.4, 1.3);
        const sp_scene s = part(kind[k % 5].name, kind[k % 5].param, k % 5 < 3 ? value : (int)value, mu);
        if (k % 5 != 2 && s.count.points <= SP_EXACT_POINTS) set.coupled.nodes = 200;
        agree_coupled(&s, &set, &told);
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), all = with_search(&s, set, &a);
        const int lies = r.effect[SP_EFFECT_DEPTH] == SP_WHY_MIRROR;
        refuted += r.coupled.reason == SP_COUPLING_NO_MOTION;
        if (r.coupled.reason == SP_COUPLING_STATICS) continue;
        CHECK_INT(lies, r.level == SP_COUPLED);
        if (!lies) continue;
        plane++;
        flops += r.coupled.cost.flops;
        most += all.coupled.cost.flops;
    }
    CHECK_INT(told, 0);
    if (TELLS) CHECK(plane > 25 && refuted > 3 && 2 * flops < most);
}

/* Its tree does not hang on the rounding of the search before it, so any number of nodes is enough for both or for none. */
TEST(a_coupled_check_is_decided_by_one_tree_in_the_plane_and_in_space)
{
    int decided = 0;
    for (int k = 0; k < 20; k++) {
        sp_settings set = sp_settings_default();
        set.localise = 0;
        set.coupled.asked = 1;
        test_arena.used = 0;
        const sp_scene s = part("keystone", "angle", 25 + k, 0.03 * k + 0.5);
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), all = with_search(&s, set, &a);
#ifdef SP_REAL_FLOAT                    /* its scales keep what the search before rounded: one may be left open */
        CHECK(r.verdict == all.verdict || !r.verdict || !all.verdict);
#else
        CHECK_INT(r.verdict, all.verdict);
        CHECK_INT(r.coupled.proof.nodes, all.coupled.proof.nodes);
        CHECK_INT(r.coupled.proof.entries, all.coupled.proof.entries);
#endif
        decided += r.coupled.proof.nodes > 0;
    }
    if (TOL(1, 0)) CHECK(decided > 5);                   /* float refutes none of them */
}

/* Without the third dimension what the plane does not explain stays open: the H model has no motion there. */
TEST(without_the_third_dimension_a_motion_is_found_or_nothing_is_said)
{
    for (int k = 0; k < 2; k++) {
        sp_settings set = sp_settings_default();
        set.coupled.asked = 1;
        set.effect[SP_EFFECT_DEPTH] = SP_WITHOUT;
        test_arena.used = 0;
        const sp_scene s = k ? part("h-model", NULL, 0, 0.84) : part("wall", "rows", 3, -1);
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a);
        CHECK_INT(r.verdict, k ? SP_UNDECIDED : SP_STABLE);
        CHECK_INT(r.coupled.verdict, k ? SP_COUPLING_NOT_FOUND : SP_COUPLING_COUPLED);
        CHECK_INT(r.reason, k ? SP_REASON_EFFECT : SP_REASON_FORCES);
        if (k) CHECK_INT(r.missing, SP_EFFECT_DEPTH);
    }
}

/* mu = 0, rings or not: the least sum of fn and its multipliers tell either way what a search leaves open. */
TEST(without_friction_a_coupled_check_is_decided_by_one_linear_programme)
{
    int told = 0, refuted = 0;
    for (int k = 0; k < 100; k++) {
        sp_settings set = sp_settings_default(), own;
        sp_scene s;
        test_arena.used = 0;
        if (k % 3) NEED(kinds_make(14 + KINDS * k, &test_arena, &s, &own) == SP_OK);
        else s = part("keystone", "angle", 0.3 * k - 35, 0);
        if (s.count.points > SP_EXACT_POINTS) continue;
        for (int32_t q = 0; q < s.count.joints; q++) s.joint[q].strength.mu = 0;
        set.localise = 0;
        set.coupled.asked = 1;
        set.coupled.box = k % 4 == 1;
        set.coupled.eta = k % 5 > 2 ? R(k % 5 == 4 ? 2e-4 : 3e-6) : 0;
        set.coupled.eps = k % 5 > 2 ? R(1e-4) : -1;
        sp_arena a = test_arena;
        const sp_result r = check(&s, &set, &a), all = with_search(&s, set, &a);
        CHECK_INT(r.verdict, all.verdict);
        if (sizeof(sp_real) == 8) CHECK(r.verdict != SP_UNDECIDED);
        refuted += r.coupled.reason == SP_COUPLING_NO_MOTION;
        told += r.level == SP_COUPLED;
        if (r.level == SP_COUPLED) for (int32_t v = 0; v < s.count.points; v++) CHECK(r.coupled.alpha[v] <= 0);
    }
    if (TELLS) CHECK(told > 20 && refuted > 8);
}

/* Rings are no forests: their answers are the search's, whatever they are. */
TEST(a_ring_is_never_told_without_a_search)
{
    static const struct { const char *name, *param; double value; } scene[] = {
        { "h-model", NULL, 0 }, { "keystone", "angle", 20 }, { "keystone", "angle", -20 }, { "arch", "n", 6 }, { "wall", "rows", 3 },
        { "diamond", "rows", 3 }
    };
    for (size_t k = 0; k < sizeof scene / sizeof scene[0]; k++) {
        sp_settings set = sp_settings_default();
        sp_outlook o;
        int told = 0;
        set.coupled.asked = 1;
        test_arena.used = 0;
        const sp_scene s = part(scene[k].name, scene[k].param, scene[k].value, -1);
        agree_coupled(&s, &set, &told);
        CHECK_INT(told, 0);
        CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_OK);
        CHECK_INT(o.effect[SP_EFFECT_COUPLED].why, SP_WHY_CALLED);
    }
}
#endif

TEST(a_plan_with_unusable_arguments_is_refused)
{
    sp_scene s = part("two-cubes", NULL, 0, -1);
    sp_settings set = sp_settings_default();
    sp_outlook o;
    const sp_arena tiny = { test_arena.base, 64, 0, 0 };
    sp_arena a = test_arena;
    CHECK_INT(sp_plan(NULL, NULL, test_arena, &o), SP_E_ARGUMENT);
    CHECK_INT(sp_plan(&s, NULL, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_plan(&s, NULL, tiny, &o), SP_E_MEMORY);
    sp_result r;
    set.effect[0] = (sp_choice)3;
    CHECK_INT(sp_plan(&s, &set, test_arena, &o), SP_E_ARGUMENT);
    CHECK_INT(sp_check(&s, &set, &a, &r), SP_E_ARGUMENT);
    a = test_arena;
    a.base += (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    a.used = a.peak = 0;
    a.cap = test_bytes(&s, SP_FOR_PLAN, NULL);
    CHECK_INT(sp_plan(&s, NULL, a, &o), SP_OK);
}

TEST_LIST(plan)
    RUN(of_two_islands_the_one_that_falls_is_named_and_moves_alone)
    RUN(each_island_keeps_its_own_verdict_and_the_worst_is_that_of_all)
    RUN(islands_solved_apart_and_together_agree_and_their_memory_is_exact)
    RUN(a_coupled_check_of_islands_answers_as_of_the_whole)
#ifndef SP_NO_CRA
    RUN(seven_h_models_side_by_side_are_refuted_each_and_verified_in_the_memory_told)
    RUN(what_refutes_one_island_is_no_proof_against_another)
    RUN(a_coupled_check_tells_of_each_island_what_it_says_of_that_alone_and_of_all_what_it_says_of_the_whole)
#endif
    RUN(supports_join_nothing_and_contacts_between_them_take_no_part)
    RUN(a_diamond_of_five_rows_without_friction_is_undecided_and_of_four_stands)
    RUN(what_has_a_mirror_is_decided_in_the_plane_with_a_third_of_the_work)
    RUN(a_mirror_is_found_in_any_direction_and_none_where_there_is_none)
    RUN(level_joints_without_a_mirror_stand_by_pressure_alone)
    RUN(the_third_dimension_left_out_of_a_scene_without_a_mirror_is_undecided)
    RUN(planned_and_full_simulation_agree_on_random_scenes)
    RUN(a_forest_of_level_joints_falls_by_pressure_alone_and_nothing_else_does)
    RUN(without_friction_pressure_alone_tells_what_falls_although_joints_form_rings)
    RUN(an_effect_left_out_by_force_never_makes_a_wrong_verdict)
    RUN(a_plan_names_every_effect_and_its_bytes_are_those_of_the_check)
#ifndef SP_NO_CRA
    RUN(what_hangs_on_its_supports_as_a_forest_is_coupled_without_a_search)
    RUN(a_twisted_slab_is_searched_where_friction_spread_as_pressure_does_not_do)
    RUN(a_coupled_check_agrees_with_its_search_on_random_scenes)
    RUN(a_motion_is_looked_for_in_the_plane_first_and_what_is_not_there_is_decided_in_space)
    RUN(a_coupled_check_is_decided_by_one_tree_in_the_plane_and_in_space)
    RUN(without_the_third_dimension_a_motion_is_found_or_nothing_is_said)
    RUN(without_friction_a_coupled_check_is_decided_by_one_linear_programme)
    RUN(a_ring_is_never_told_without_a_search)
#endif
    RUN(a_plan_with_unusable_arguments_is_refused)
TEST_END
