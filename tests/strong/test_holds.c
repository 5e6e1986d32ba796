/* What sp_strong_verify takes for proved, to the last bit of tol; the room, the work and the zeros of sp_strong. Claims are
 * made by formulas, none by the search. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/strong/strong.c"

#if SP__WITH_STRONG

#include "stool.h"

#include <math.h>

enum { FEET = 4, MOST = 8, BODIES = 3 };

/* Forces, forces of a motion and accelerations of a claim of few points and blocks. */
static sp_real rest[3 * MOST], moving[3 * MOST], motion[6 * BODIES];

/* What works on a question, and what judges. */
static sp__holds hold;

/* A claim of nothing. */
static sp_strong_result nothing(void)
{
    sp_strong_result x;
    memset(&x, 0, sizeof x);
    memset(rest, 0, sizeof rest);
    memset(moving, 0, sizeof moving);
    memset(motion, 0, sizeof motion);
    x.f = rest; x.moving = moving; x.a = motion;
    return x;
}

/* tol, and a bound of forces that does not follow from it. */
static sp_settings within(sp_real tol)
{
    sp_settings set = sp_settings_default();
    set.tol = tol;
    set.force_bound = 1000;
    return set;
}

static sp_strong_kind judged(const sp_scene *s, const sp_settings *set, const sp_strong_result *claim)
{
    sp_strong_kind proved = SP_STRONG_NONE;
    CHECK_INT(sp_strong_verify(s, set, claim, test_arena, &proved), SP_OK);
    return proved;
}

/* What sp_strong makes of forces, in an arena that keeps it. */
static sp_strong_result kept(const sp_scene *s, const sp_settings *set, const sp_strong_settings *how, const sp_real *f,
                             sp_arena *a)
{
    sp_strong_result r;
    memset(&r, 0, sizeof r);
    CHECK_INT(sp_strong(s, set, how, f, NULL, a, &r), SP_OK);
    return r;
}

static sp_strong_result told(const sp_scene *s, const sp_settings *set, const sp_strong_settings *how, const sp_real *f)
{
    sp_arena a = test_arena;
    return kept(s, set, how, f, &a);
}

/* += force F at the point of a joint of one, in its frame. */
static void put(const sp_scene *s, int32_t joint, const sp_real F[3], sp_real *f)
{
    const sp_joint *t = &s->joint[joint];
    f[3 * t->point] += sp__dot3(F, t->n);
    f[3 * t->point + 1] += sp__dot3(F, t->t1);
    f[3 * t->point + 2] += sp__dot3(F, t->t2);
}

/* A stool of feet at r1 < r2, mu, weight 1 N: J about the vertical. */
static const double r1 = 0.3, r2 = 0.6, mu = 0.5, J = (0.7 * 0.7 + 0.7 * 0.7) / 3 / 9.80665;

/* Feet k and k + 2, at the distance r, carry all the weight and turn the stool by T. */
static void carry(const sp_scene *s, int k, double r, double T, double size, sp_real *f)
{
    for (int q = k; q < FEET; q += 2) {
        const double way = q < 2 ? 1 : -1, t = way * T / (2 * r);
        const sp_real F[3] = { R(k ? -t * size : 0), R(k ? 0 : t * size), R(size / 2) };
        put(s, q, F, f);
    }
}

/* The pair that spins the stool by `spin`: the near feet carry it and rub against it by all of mu. */
static sp_scene spinning(double spin, sp_strong_result *claim)
{
    const double T = mu * r1 + J * spin;
    const sp_scene s = stool(r1, r2, mu, T);
    *claim = nothing();
    carry(&s, 1, r2, -T, 1, rest);
    carry(&s, 0, r1, -mu * r1, 1, moving);
    motion[6 + 5] = R(spin);
    return s;
}

/* What the judge says of the claim's forces and motion, by its own parts. */
static void measure(const sp_scene *s, const sp_settings *set, const sp_strong_result *claim, sp_real *pressure,
                    sp_real *forces, sp_real *pair, sp_real *moves)
{
    sp__holds *h = &hold;
    sp_arena a = test_arena;
    CHECK_INT(sp__holds_open(h, s, set, &a), SP_OK);
    *pressure = sp__certify_pressure(&h->starts.j, claim->f, h->starts.sweep.f);
    *forces = sp__certify_forces(&h->starts.j, claim->f, NULL);
    CHECK(sp__inertias(&h->pb, h->starts.arm, h->starts.M));
    sp__motion_read(&h->pb, claim->a, h->starts.sweep.a);
    *pair = sp__certify_moving(&h->starts.j, h->starts.M, claim->moving, h->starts.sweep.a, 1, moves);
}

/* Less by a bit or two. */
static sp_real below(sp_real x) { return x - x * (sp_real)SP_EPSILON; }

TEST(a_motion_by_formula_is_ambiguous_and_no_motion_that_is_faster_or_slower)
{
    for (int k = 0; k < 3; k++) {
        sp_strong_result x;
        const double most = mu * (r2 - r1) / J;
        const sp_scene s = spinning((k + 1) * most / 4, &x);
        CHECK_INT(judged(&s, NULL, &x), SP_STRONG_AMBIGUOUS);
        for (int fast = 0; fast < 2; fast++) {
            const sp_real was = motion[6 + 5];
            motion[6 + 5] *= R(fast ? 1.01 : 0.99);
            CHECK_INT(judged(&s, NULL, &x), SP_STRONG_ADMISSIBLE);
            motion[6 + 5] = was;
        }
    }
}

/* Forces a thousandth too large: as large as tol their imbalance is taken, by one bit more it is not. */
TEST(pressure_that_is_out_of_balance_by_tol_is_taken_and_by_more_is_not)
{
    sp_real pressure, forces, pair, moves;
    const sp_scene s = stool(r1, r2, mu, 0);
    sp_settings set = within(R(0.01));
    sp_strong_result x = nothing();
    carry(&s, 0, r1, 0, 1.001, rest);
    measure(&s, &set, &x, &pressure, &forces, &pair, &moves);
    CHECK(pressure > R(1e-4) && pressure < R(1e-3));
    set = within(pressure);
    CHECK_INT(judged(&s, &set, &x), SP_STRONG_STRONG);
    sp_strong_result r = told(&s, &set, NULL, rest);
    CHECK(r.kind == SP_STRONG_STRONG && r.reason == SP_STRONG_PRESSURE);
    CHECK_INT(r.plate, 1);
    CHECK(!(r.residual < pressure) && !(r.residual > pressure));
    for (int v = 0; v < FEET; v++) CHECK(!(r.f[3 * v] < rest[3 * v]) && !(r.f[3 * v] > rest[3 * v]));
    set = within(below(pressure));
    CHECK_INT(judged(&s, &set, &x), SP_STRONG_NONE);
    r = told(&s, &set, NULL, rest);
    CHECK(r.kind == SP_STRONG_NONE && r.reason == SP_STRONG_NO_FORCES);
    for (int v = 0; v < 3 * FEET; v++) CHECK(!(r.f[v] < 0) && !(r.f[v] > 0));
}

TEST(forces_at_rest_that_are_out_of_balance_by_tol_are_taken_and_by_more_are_not)
{
    const sp_strong_settings no_starts = { 0, 0 };
    const double T = 0.9 * mu * r2;
    sp_real pressure, forces, pair, moves;
    const sp_scene s = stool(r1, r2, mu, T);
    sp_settings set = within(R(0.01));
    sp_strong_result x = nothing();
    carry(&s, 1, r2, -T, 1.001, rest);
    measure(&s, &set, &x, &pressure, &forces, &pair, &moves);
    CHECK(pressure > R(0.1) && forces > R(1e-4) && forces < R(1e-2));
    set = within(forces);
    CHECK_INT(judged(&s, &set, &x), SP_STRONG_ADMISSIBLE);
    CHECK_INT(told(&s, &set, &no_starts, rest).kind, SP_STRONG_ADMISSIBLE);
    set = within(below(forces));
    CHECK_INT(judged(&s, &set, &x), SP_STRONG_NONE);
    const sp_strong_result r = told(&s, &set, &no_starts, rest);
    CHECK_INT(r.kind, SP_STRONG_NONE);
    for (int v = 0; v < 3 * FEET; v++) CHECK(!(r.f[v] < 0) && !(r.f[v] > 0));
}

TEST(a_motion_that_is_out_by_tol_is_taken_and_by_more_is_not)
{
    sp_real pressure, forces, pair, moves;
    sp_strong_result x;
    const sp_scene s = spinning(1, &x);
    sp_settings set = within(R(0.01));
    motion[6 + 5] *= R(1.002);
    measure(&s, &set, &x, &pressure, &forces, &pair, &moves);
    CHECK(forces < pair && pair > R(1e-5) && pair < R(1e-2));
    set = within(pair);
    CHECK_INT(judged(&s, &set, &x), SP_STRONG_AMBIGUOUS);
    set = within(below(pair));
    CHECK_INT(judged(&s, &set, &x), SP_STRONG_ADMISSIBLE);
}

/* Spins around that whose acceleration is 1e-3 of the stool's forces: of those that meet the number some are it to the bit. */
TEST(what_moves_by_a_thousandth_moves_and_by_less_does_not)
{
    int met = 0;
    double least = 0, most = 1;
    for (int k = 0; k < 60; k++) {
        sp_real pressure, forces, pair, moves;
        sp_strong_result x;
        const double spin = (least + most) / 2;
        const sp_scene s = spinning(spin, &x);
        const sp_settings set = within(R(TOL(1e-9, 1e-4)));
        measure(&s, &set, &x, &pressure, &forces, &pair, &moves);
        const sp_strong_kind kind = judged(&s, &set, &x);
        CHECK_INT(kind, moves >= SP__MOVES ? SP_STRONG_AMBIGUOUS : SP_STRONG_ADMISSIBLE);
        met += moves >= SP__MOVES && !(moves > SP__MOVES);
        if (moves >= SP__MOVES) most = spin;
        else least = spin;
    }
    CHECK(met > 0);
}

/* The stool without a load, its feet rubbing against a post at its side: p = -Aeq fn0 of the feet alone, so that
 * -p . a = sum fn0 dn >= 0, which is one case of all, work 1 and dn >= 0 of every foot by its pressure. */
TEST(a_proof_of_one_case_is_a_proof)
{
    const double h = 0.1;
    const sp_real left[3] = { -1, 0, 0 }, post[3] = { R(0.7), 0, 0 };
    const sp_real pushed[3] = { R(-h), 0, 0 }, stands[3] = { 0, 0, R(0.25) }, rubs[3] = { R(h / 2), 0, R(0.25) };
    const sp_strength rough = sp_strength_friction(R(mu));
    int32_t node[1] = { -1 - FEET };
    uint16_t row[1 + FEET];
    sp_real y[1 + FEET];
    sp_scene s = stool(r1, r2, mu, 0);
    CHECK_INT(sp_scene_points(&s, 0, 1, left, 1, post, &rough, NULL), SP_OK);
    sp_strong_result x = nothing();
    put(&s, FEET, pushed, rest);
    for (int q = 0; q < FEET; q++) put(&s, q, q % 2 ? rubs : stands, rest);
    CHECK_INT(judged(&s, NULL, &x), SP_STRONG_ADMISSIBLE);
    sp_arena a = test_arena;
    CHECK_INT(sp__holds_open(&hold, &s, NULL, &a), SP_OK);
    const int32_t n = 6 * hold.pb.blocks;
    for (int v = 0; v < FEET; v++) {
        row[v] = (uint16_t)(n + 1 + SP__STILL_ROWS * v + SP__STILL_GAP);
        y[v] = -sp__in_units(hold.starts.j.unit, R(0.25));
    }
    row[FEET] = (uint16_t)n;
    y[FEET] = 1;
    x.proof.nodes = x.proof.leaves = 1;
    x.proof.entries = 1 + FEET;
    x.proof.node = node; x.proof.row = row; x.proof.y = y;
    CHECK_INT(judged(&s, NULL, &x), TOL(SP_STRONG_STRONG, SP_STRONG_ADMISSIBLE));
    y[0] /= 2;                                          /* no balance */
    CHECK_INT(judged(&s, NULL, &x), SP_STRONG_ADMISSIBLE);
    y[0] *= 2;
    y[FEET] = 0;                                        /* no work */
    CHECK_INT(judged(&s, NULL, &x), SP_STRONG_ADMISSIBLE);
}

/* Two blocks, and what is held of them; joints of some points between these and the ground. */
typedef struct held_joint { int32_t a, b, points; } held_joint;

static sp_scene held(uint32_t first, uint32_t second, const sp_real n[3], const held_joint *joint, int joints)
{
    const sp_capacity cap = { 3, 0, 0, 0, 4, 16, 0 };
    const sp_strength rough = sp_strength_friction(R(mu));
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    for (int b = 0; b < BODIES; b++) {
        const sp_real at[3] = { 0, 0, R(b) };
        CHECK_INT(sp_scene_body(&s, 1, at, b == 0 ? SP_FIXED : b == 1 ? first : second, NULL), SP_OK);
    }
    for (int c = 0; c < joints; c++) {
        const sp_real z = R(c + 0.5), x[12] = { 0, 0, z, 1, 0, z, 1, 1, z, 0, 1, z };
        CHECK_INT(sp_scene_points(&s, joint[c].a, joint[c].b, n, joint[c].points, x, &rough, NULL), SP_OK);
    }
    return s;
}

/* A joint of two points or more spins where one of its blocks may turn about an axis that its normal has a part of. */
static int spins(const sp_scene *s)
{
    for (int32_t c = 0; c < s->count.joints; c++)
        for (int k = 0; k < 3 && s->joint[c].points > 1; k++) {
            const uint32_t both = s->block[s->joint[c].a].fixed & s->block[s->joint[c].b].fixed;
            if (!(both >> (3 + k) & 1u) && fabs((double)s->joint[c].n[k]) > 0) return 1;
        }
    return 0;
}

/* Then corners are not all the same, and a proof by cases is one at corners alone. */
TEST(a_joint_of_two_points_or_more_spins_unless_both_its_blocks_are_held_about_all_axes_of_its_normal)
{
    static const sp_real n[5][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { R(0.6), 0, R(0.8) }, { 1, 2, 3 } };
    static const held_joint joint[6][3] = {
        { { 0, 1, 1 }, { 1, 2, 2 }, { 0, 0, 0 } }, { { 0, 1, 2 }, { 1, 2, 1 }, { 0, 0, 0 } },
        { { 1, 0, 4 }, { 2, 0, 1 }, { 0, 0, 0 } }, { { 0, 1, 1 }, { 0, 2, 1 }, { 0, 2, 3 } },
        { { 2, 0, 3 }, { 0, 0, 0 }, { 0, 0, 0 } }, { { 0, 1, 1 }, { 1, 2, 1 }, { 2, 0, 1 } } };
    static const int joints[6] = { 2, 2, 2, 3, 1, 3 };
    int none = 0, some = 0;
    for (int k = 0; k < 5; k++)
        for (int c = 0; c < 6; c++)
            for (uint32_t first = 0; first < 16; first++)
                for (uint32_t second = 0; second < 16; second += 5) {
                    /* turns, and with them one way or all but one */
                    const uint32_t ways = first & 8u ? 5u : 2u, turns = (first & 7u) << 3, more = (second & 7u) << 3;
                    const sp_scene s = held(turns | ways, more, n[k], joint[c], joints[c]);
                    sp_problem pb;
                    CHECK_INT(sp_problem_build(&s, &test_arena, &pb), SP_OK);
                    CHECK_INT(sp__holds_plates(&pb), !spins(&s));
                    if (spins(&s)) some++;
                    else none++;
                }
    CHECK(none > 100 && some > 100);
}

/* Blocks in a chain from the ground, each on the last by some points; `loose` ones touch nothing. */
static sp_scene chain(int32_t blocks, int32_t points, int32_t loose)
{
    const sp_capacity cap = { blocks + loose + 1, 0, 0, 0, blocks, blocks * points, 0 };
    const sp_strength rough = sp_strength_friction(R(mu));
    const sp_real up[3] = { 0, 0, 1 };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    sp_real *x = sp__take(&test_arena, (size_t)points + 1, 3 * sizeof *x);
    for (int32_t b = 0; b <= blocks + loose; b++) {
        const sp_real at[3] = { 0, 0, R(b) };
        CHECK_INT(sp_scene_body(&s, 1, at, b ? 0 : SP_FIXED, NULL), SP_OK);
        for (int32_t v = 0; v < points; v++) { x[3 * v] = R(v); x[3 * v + 1] = R(v % 3); x[3 * v + 2] = R(b - 0.5); }
        if (b && b <= blocks) CHECK_INT(sp_scene_points(&s, b - 1, b, up, points, x, &rough, NULL), SP_OK);
    }
    return s;
}

/* Each of its steps takes it anew: pivoting, even friction, a proof that is judged, a search for one. */
TEST(room_behind_the_problem_is_the_most_that_one_step_asks_for)
{
    static const struct { int32_t blocks, points, loose; } of[] = {
        { 0, 0, 1 }, { 1, 1, 0 }, { 1, 4, 0 }, { 1, 4, 1 }, { 2, 8, 0 }, { 3, 5, 0 }, { 12, 1, 0 }, { 1, 17, 0 }, { 1, 108, 0 },
        { 1, 109, 0 }, { 33, 1, 0 }, { 33, 4, 0 } };
    int largest[4] = { 0, 0, 0, 0 }, none = 0;
    for (size_t k = 0; k < sizeof of / sizeof *of; k++)
        for (int search = 0; search < 2; search++) {
            const sp_scene s = chain(of[k].blocks, of[k].points, of[k].loose);
            const int32_t points = of[k].blocks * of[k].points, blocks = of[k].blocks + of[k].loose;
            const int cases = TOL(1, 0) && points > 0 && points <= SP__STILL_POINTS && blocks <= SP__STILL_POINTS;
            const size_t room[4] = { search ? sp__lemke_need(points) : 0, sp__shear_need(points, of[k].blocks, blocks),
                                     cases ? sp__still_need(points, blocks) : 0,
                                     cases && search ? sp__cases_need(points, blocks) : 0 };
            int most = 0;
            for (int q = 1; q < 4; q++) if (room[q] > room[most]) most = q;
            CHECK_INT(sp__holds_cases_need(&s, search), room[most]);
            largest[most] += room[most] > 0;
            none += room[most] == 0;
        }
    for (int q = 0; q < 4; q++) CHECK(largest[q] > 0 || (q > 1 && !TOL(1, 0)));
    CHECK(none > 0);
}

/* What was on the stack before is not read. */
static int dirty(void)
{
    volatile unsigned char stack[512];
    int sum = 0;
    for (int k = 0; k < 512; k++) stack[k] = 0xA5;
    for (int k = 0; k < 512; k++) sum += stack[k];
    return sum;
}

TEST(where_there_are_too_many_corners_there_is_no_proof_whatever_was_there_before)
{
    const sp_scene s = chain(1, SP__STILL_POINTS + 1, 0);
    sp_arena a = test_arena;
    CHECK_INT(dirty(), 512 * 0xA5);
    const sp_proof p = sp__holds_proof(&s, NULL, &a);
    CHECK(!p.nodes && !p.leaves && !p.entries && !p.island && !p.node && !p.row && !p.y);
    CHECK_INT(a.used, test_arena.used);
}

/* The ground on another support, pressed: what pressure alone holds keeps the pressure that was given there, and nothing of
 * it is left where the next answer is. */
TEST(supports_have_no_motion_and_joints_between_them_no_forces)
{
    const sp_strong_settings no_starts = { 0, 0 };
    const sp_real ground[3] = { 0, 0, -2 }, up[3] = { 0, 0, 1 }, foot[3] = { 0, 0, R(-1.5) };
    const sp_strength rough = sp_strength_friction(R(mu));
    int32_t below_it = 0;
    for (int what = 0; what < 2; what++) {
        const double T = what ? mu * (r1 + r2) / 2 : 0;
        sp_scene s = stool(r1, r2, mu, T);
        nothing();
        CHECK_INT(sp_scene_body(&s, 1, ground, SP_FIXED, &below_it), SP_OK);
        CHECK_INT(sp_scene_points(&s, below_it, 0, up, 1, foot, &rough, NULL), SP_OK);
        carry(&s, 1, r2, -T, 1, rest);
        rest[3 * FEET] = 7;
        const sp_strong_result r = told(&s, NULL, &no_starts, rest);
        CHECK_INT(r.kind, what ? SP_STRONG_ADMISSIBLE : SP_STRONG_STRONG);
        for (int k = what ? 0 : 1; k < 3; k++) CHECK(!(r.f[3 * FEET + k] < 0) && !(r.f[3 * FEET + k] > 0));
        for (int k = 0; k < 3 * (FEET + 1); k++) CHECK(!(r.moving[k] < 0) && !(r.moving[k] > 0));
        for (int k = 0; k < 6 * BODIES; k++) CHECK(!(r.a[k] < 0) && !(r.a[k] > 0));
    }
}

/* Nothing found and nothing proved is ADMISSIBLE, and keeps the arrays of the answer alone. */
TEST(where_no_case_is_closed_no_proof_is_kept)
{
    const sp_strong_settings no_starts = { 0, 0 };
    sp_strong_result x;
    const sp_scene s = spinning(1, &x);
    sp_arena a = test_arena, bare = test_arena;
    for (int k = 0; k < 2; k++) sp__take(&bare, 3 * FEET, sizeof(sp_real));
    sp__take(&bare, 6 * 2, sizeof(sp_real));
    const sp_strong_result r = kept(&s, NULL, &no_starts, rest, &a);
    CHECK(r.kind == SP_STRONG_ADMISSIBLE && r.reason == SP_STRONG_NOTHING_FOUND && !r.plate);
    CHECK(!r.proof.nodes && !r.proof.leaves && !r.proof.entries && !r.proof.node && !r.proof.row && !r.proof.y);
    CHECK_INT(a.used, bare.used);
}

/* A plate by the law of one friction a joint: pressure at its middle holds no torque. */
static sp_scene turned_plate(double torque)
{
    const sp_scene s = plate(0.5, mu, torque, 0);
    const double r = 0.5 * sqrt(2.0), t = -torque / (4 * r);
    sp_joint *o = &s.joint[0];
    nothing();
    for (int v = 0; v < FEET; v++) {
        const sp_real *x = s.point[o->point + v], F[3] = { R(-t * (double)x[1] / r), R(t * (double)x[0] / r), R(0.25) };
        rest[3 * v] = sp__dot3(F, o->n);
        rest[3 * v + 1] = sp__dot3(F, o->t1);
        rest[3 * v + 2] = sp__dot3(F, o->t2);
    }
    return s;
}

TEST(a_plate_that_spins_is_one_by_pressure_at_its_middle_and_says_so)
{
    const sp_scene s = turned_plate(0.1);
    const sp_strong_result r = told(&s, NULL, NULL, rest);
    CHECK_INT(r.kind, SP_STRONG_AMBIGUOUS);
    CHECK_INT(r.plate, 1);
}

/* However little the budget is, there is a start by single corners, then one by plates. */
TEST(a_budget_ends_the_starts_of_either_search_after_the_first_that_exceeds_it)
{
    const sp_scene s = turned_plate(0.1);
    sp_settings set = sp_settings_default();
    set.budget = 1;
    const sp_strong_result r = told(&s, &set, NULL, rest);
    CHECK_INT(r.starts, 2);
    set.budget = 0;                                     /* none: all of 16 pairs and 2^4 sets of corners, then as many sets */
    sp_strong_settings all = { 256, 1 };
    CHECK_INT(told(&s, &set, &all, rest).starts, SP__STARTS_PIVOTED + (1 << FEET));
}

/* Flops are those of all sweeps, and a constant for every point of those that certify. */
TEST(what_is_spent_is_the_flops_of_both_searches_and_of_what_judges)
{
    const sp_scene s = turned_plate(0.1);
    const sp_strong_settings how = { 256, 0 };
    sp_arena a = test_arena;
    sp_real f[3 * FEET], at_rest[6 * 2];
    CHECK_INT(sp__holds_open(&hold, &s, NULL, &a), SP_OK);
    memset(f, 0, sizeof f);
    memset(at_rest, 0, sizeof at_rest);
    hold.r.f = f; hold.r.moving = moving; hold.r.a = at_rest;
    sp__holds_decide(&hold, rest, NULL, &how, a);
    CHECK_INT(hold.r.kind, SP_STRONG_AMBIGUOUS);
    CHECK(hold.starts.sweep.flops > 0);
    CHECK_INT(hold.r.cost.flops, hold.starts.sweep.flops);
    CHECK_INT(hold.r.starts, hold.starts.tried);
    memset(moving, 0, sizeof moving);
    const int64_t judging = SP__FLOPS_CERTIFICATE * (int64_t)hold.starts.j.sweeps * FEET;
    const sp_strong_result r = told(&s, NULL, &how, rest);
    CHECK_INT(r.cost.flops, hold.starts.sweep.flops + judging);
}

/* Asked or not, a coupled check is none of this: neither its finer tol nor what it refuses. */
TEST(settings_of_a_coupled_check_are_not_heard)
{
    const sp_scene s = stool(r1, r2, mu, 0);
    sp_settings set = within(R(0.01));
    nothing();
    carry(&s, 0, r1, 0, 1, rest);
    set.coupled.asked = 1;
    const sp_strong_result r = told(&s, &set, NULL, rest);
    CHECK_INT(r.kind, SP_STRONG_STRONG);
    CHECK(!(r.tol < set.tol) && !(r.tol > set.tol));
}

/* A block alone falls: that is an answer; no block at all is no question. */
TEST(one_block_is_a_scene_and_none_is_not)
{
    sp_strong_kind proved = SP_STRONG_STRONG;
    sp_strong_result x = nothing(), r = x;
    const sp_capacity cap = { 1, 0, 0, 0, 0, 0, 0 };
    const sp_real at[3] = { 0, 0, 0 };
    sp_scene s;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
    for (int blocks = 0; blocks < 2; blocks++) {
        sp_arena a = test_arena;
        if (blocks) CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
        CHECK_INT(sp_strong(&s, NULL, NULL, rest, NULL, &a, &r), blocks ? SP_OK : SP_E_EMPTY);
        CHECK_INT(sp_strong_verify(&s, NULL, &x, test_arena, &proved), blocks ? SP_OK : SP_E_EMPTY);
        CHECK_INT(proved, blocks ? SP_STRONG_NONE : SP_STRONG_STRONG);
    }
    CHECK_INT(r.kind, SP_STRONG_NONE);
}

/* Numbers of a claim are read to the last one, and none behind it. */
TEST(what_is_no_number_is_refused_wherever_it_is_in_the_evidence_and_not_behind_it)
{
    const sp_real infinite = R(1e300) * R(1e300);
    const sp_scene s = stool(r1, r2, mu, 0);
    const int size[3] = { 3 * FEET, 3 * FEET, 6 * 2 };
    sp_strong_result x = nothing(), r;
    sp_real *of[3];
    of[0] = rest; of[1] = moving; of[2] = motion;
    carry(&s, 0, r1, 0, 1, rest);
    for (int e = 0; e < 3; e++)
        for (int k = 0; k <= size[e]; k++) {
            const sp_real was = of[e][k];
            sp_arena a = test_arena;
            sp_strong_kind proved = SP_STRONG_ADMISSIBLE;
            of[e][k] = infinite - infinite;
            CHECK_INT(sp_strong_verify(&s, NULL, &x, test_arena, &proved), k < size[e] ? SP_E_NOT_FINITE : SP_OK);
            CHECK_INT(proved, k < size[e] ? SP_STRONG_ADMISSIBLE : SP_STRONG_STRONG);
            if (e < 2)                                  /* forces given, with friction and without */
                CHECK_INT(sp_strong(&s, NULL, NULL, rest, e ? moving : NULL, &a, &r), k < size[e] ? SP_E_NOT_FINITE : SP_OK);
            of[e][k] = was;
        }
}

/* So many points that the bytes of one array of forces are told in 32 bits, and those of two are not. */
TEST(bytes_that_cannot_be_counted_are_none)
{
    sp_scene s = stool(r1, r2, mu, 0);
    s.count.points = (int32_t)(UINT32_MAX / (3 * sizeof(sp_real)) / 3 * 2);
    CHECK((sp__holds_memory(&s, NULL) == 0) == (sizeof(size_t) < 8));
    CHECK((sp__holds_verify_memory(&s) == 0) == (sizeof(size_t) < 8));
}

TEST(every_pointer_that_is_missing_is_told)
{
    const sp_scene s = stool(r1, r2, mu, 0);
    sp_arena none = test_arena, a = test_arena;
    sp_strong_kind proved = SP_STRONG_STRONG;
    sp_strong_result r;
    none.base = NULL;
    for (int k = 0; k < 7; k++) {
        sp_strong_result x = nothing();
        carry(&s, 0, r1, 0, 1, rest);
        if (k == 2) x.f = NULL;
        if (k == 3) x.moving = NULL;
        if (k == 4) x.a = NULL;
        CHECK_INT(sp_strong_verify(k == 0 ? NULL : &s, NULL, k == 1 ? NULL : &x, k == 6 ? none : test_arena,
                                   k == 5 ? NULL : &proved), SP_E_ARGUMENT);
        CHECK_INT(proved, SP_STRONG_STRONG);
    }
    CHECK_INT(sp_strong(NULL, NULL, NULL, rest, NULL, &a, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, NULL, NULL, &a, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, rest, NULL, NULL, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, rest, NULL, &none, &r), SP_E_ARGUMENT);
    CHECK_INT(sp_strong(&s, NULL, NULL, rest, NULL, &a, NULL), SP_E_ARGUMENT);
}

/* Not in float, whose rounding closes none. */
TEST(cases_are_told_apart_of_few_corners_and_blocks)
{
    static const struct { int joints, blocks, few; } row[] = {
        { 1, 1, 1 }, { 0, 1, 0 }, { 1, SP__STILL_POINTS, 1 }, { 1, SP__STILL_POINTS + 1, 0 }, { 4, 4, 1 }, { 5, 4, 0 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const sp_capacity cap = { 2, 0, 0, 0, 5, 20, 0 };
        const sp_real at[3] = { 0, 0, 0 }, foot[12] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
        const sp_strength rough = sp_strength_friction(R(0.5));
        sp_scene s;
        test_arena.used = 0;
        CHECK_INT(sp_scene_create(&s, &cap, &test_arena), SP_OK);
        for (int b = 0; b < 2; b++) CHECK_INT(sp_scene_body(&s, 1, at, 0, NULL), SP_OK);
        for (int i = 0; i < row[k].joints; i++) CHECK_INT(sp_scene_joint(&s, 0, 1, 4, foot, &rough, NULL), SP_OK);
        CHECK_INT(sp__cases_allowed(&s, row[k].blocks), row[k].few && TOL(1, 0));
    }
}

#endif

TEST_LIST(holds)
#if SP__WITH_STRONG
    RUN(a_motion_by_formula_is_ambiguous_and_no_motion_that_is_faster_or_slower)
    RUN(pressure_that_is_out_of_balance_by_tol_is_taken_and_by_more_is_not)
    RUN(forces_at_rest_that_are_out_of_balance_by_tol_are_taken_and_by_more_are_not)
    RUN(a_motion_that_is_out_by_tol_is_taken_and_by_more_is_not)
    RUN(what_moves_by_a_thousandth_moves_and_by_less_does_not)
    RUN(a_proof_of_one_case_is_a_proof)
    RUN(cases_are_told_apart_of_few_corners_and_blocks)
    RUN(a_joint_of_two_points_or_more_spins_unless_both_its_blocks_are_held_about_all_axes_of_its_normal)
    RUN(room_behind_the_problem_is_the_most_that_one_step_asks_for)
    RUN(where_there_are_too_many_corners_there_is_no_proof_whatever_was_there_before)
    RUN(supports_have_no_motion_and_joints_between_them_no_forces)
    RUN(where_no_case_is_closed_no_proof_is_kept)
    RUN(a_plate_that_spins_is_one_by_pressure_at_its_middle_and_says_so)
    RUN(a_budget_ends_the_starts_of_either_search_after_the_first_that_exceeds_it)
    RUN(what_is_spent_is_the_flops_of_both_searches_and_of_what_judges)
    RUN(settings_of_a_coupled_check_are_not_heard)
    RUN(one_block_is_a_scene_and_none_is_not)
    RUN(what_is_no_number_is_refused_wherever_it_is_in_the_evidence_and_not_behind_it)
    RUN(bytes_that_cannot_be_counted_are_none)
    RUN(every_pointer_that_is_missing_is_told)
#endif
TEST_END
