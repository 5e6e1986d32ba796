/* Scenes made to mislead: slots, weights of very different size, limits, supports that hold in part, random piles. */
#include "attack.h"

#include <string.h>

/* An upright square 2 p by 2 p about (x, 0, z), normal along x. */
static void wall(sp_scene *s, int32_t a, int32_t b, double x, double z, double p, double mu)
{
    const double c[3] = { x, 0, z }, u[3] = { 0, p, 0 }, v[3] = { 0, 0, p };
    quad(s, a, b, c, u, v, mu);
}

/* ------------------------------------------------------------------------------------------------ squeezed in a slot */

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

/* A jaw that slides along x only presses a stone onto a fixed wall, by so many weights of the stone. */
static void jaw(sp_scene *s, double squeeze, double mu)
{
    const sp_capacity cap = { 3, 0, 0, 0, 2, 8, 1 };
    sp_load load;
    test_arena.used = 0;
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    const int32_t fixed = body(s, 0, -2, 0, 8, SP_FIXED), stone = body(s, 1, 0, 0, 8, 0);
    const int32_t pressed = body(s, 1, 2, 0, 8, SP_FIXED & ~1u);
    wall(s, fixed, stone, -1, 8, 1, mu);
    wall(s, stone, pressed, 1, 8, 1, mu);
    memset(&load, 0, sizeof load);
    load.block = pressed;
    load.force[0] = R(-9.80665 * squeeze);
    load.point[0] = 2;
    load.point[2] = 8;
    CHECK_INT(sp_scene_load(s, &load, NULL), SP_OK);
}

/* The load passes through the stone, which is judged by what it carries: the stone falls up to 1 / tol weights, a thousand times
 * more hide its weight, as solvers/README.md says. */
TEST(an_outside_load_hides_a_weight_of_less_than_tol_of_it)
{
    static const struct { double squeeze, small; sp_verdict want; } table[] = {
        { 1, 1, SP_UNSTABLE }, { 1e4, 10, SP_UNSTABLE }, { 1e8, 1e3, SP_UNSTABLE }, { 1e12, 1e7, SP_STABLE }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        const double squeeze = TOL(table[k].squeeze, table[k].small);
        sp_scene s;
        sp_result r;
        jaw(&s, squeeze, 0);
        NEED(checked(&s, NULL, &r) == SP_OK);
        if (!CHECK_INT(r.verdict, table[k].want)) TEST_PRINT("    squeezed by %g weights\n", squeeze);
    }
}

/* A motion that no contact resists needs to do more work than rounding, not more than tol. Where contacts resist, and where its
 * work may be rounding, a claim of it proves nothing. */
TEST(a_fall_within_tol_is_believed_only_where_nothing_resists)
{
    static const struct { double squeeze, mu; sp_verdict want; } table[] = {
        { 1e8, 0, SP_UNSTABLE }, { 1e10, 0, SP_UNSTABLE }, { 1e11, 0, SP_UNSTABLE }, { 1e11, 1e-6, SP_UNDECIDED },
        { 1e11, 1e-9, SP_UNDECIDED }, { 1e13, 0, SP_UNDECIDED }, { 1e15, 0, SP_UNDECIDED }
    };
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        sp_scene s;
        jaw(&s, table[k].squeeze, table[k].mu);
        sp_result claim = empty_claim(&s);
        claim.dq[8] = -1;
        const sp_verdict want = TOL(1, 0) ? table[k].want : SP_UNDECIDED;
        if (!CHECK_INT(judged(&s, &claim, NULL), want)) TEST_PRINT("    by %g weights, mu %g\n", table[k].squeeze, table[k].mu);
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

/* ----------------------------------------------------------------------------------------------- very unequal weights */

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

/* --------------------------------------------------------------------------------------- verdicts just beside the limit */

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

/* Interior points alone find these, with the digits of double. */
#if defined SP_NO_IPM || defined SP_REAL_MIXED
#define DECIDES 0
#else
#define DECIDES 1
#endif

/* Rubble whose weights are up to 1e12 times apart, pushed sideways: what a pebble lacks of balance is less than tol of what
 * passes through it, and a search for forces ended in vain. Float has no digits for them. */
TEST(rubble_of_any_weights_is_decided)
{
    for (int k = 0; k < SOME_OF(TOL(300, 150), 40); k++) {
        sp_scene s;
        sp_result r;
        generated("rubble", "seed", test_random_int(1, 1000), &s);
        const double spread = TOL(12.0, 3.0);
        for (int32_t i = 0; i < s.count.blocks; i++)
            s.block[i].mass *= R(pow(10, spread * (double)test_random_real(-0.5, 0.5)));
        gen_gravity(6 + k % 8 * 4, test_random_int(0, 359), s.gravity);
        NEED(checked(&s, NULL, &r) == SP_OK);
        if (DECIDES && !CHECK(r.verdict != SP_UNDECIDED)) TEST_PRINT("    scene %d\n", k);
    }
}

TEST_LIST(attack)
    RUN(no_squeeze_holds_a_block_in_a_slippery_slot)
    RUN(an_outside_load_hides_a_weight_of_less_than_tol_of_it)
    RUN(a_fall_within_tol_is_believed_only_where_nothing_resists)
    RUN(tiny_friction_is_told_honestly)
    RUN(the_bound_on_forces_is_the_callers)
    RUN(pebbles_on_and_under_cathedrals)
    RUN(a_pebble_slides_alone)
    RUN(sandwiches_of_unequal_weights)
    RUN(a_cathedral_lends_a_pebble_no_tolerance)
    RUN(a_cathedral_on_a_pebble_does_not_sink)
    RUN(just_beside_the_limit_units_place_and_order_do_not_matter)
    RUN(a_block_held_against_sliding_stands)
    RUN(a_block_held_against_turning_does_not_tip)
    RUN(a_prop_in_the_air)
    RUN(a_partly_held_block_is_as_much_support_as_it_is_held)
    RUN(a_stop_carries_the_push_of_statics)
    RUN(piles_of_random_weights_are_never_judged_wrong)
    RUN(rubble_of_any_weights_is_decided)
TEST_END
