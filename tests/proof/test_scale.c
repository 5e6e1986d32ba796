/* The certificate check from the inside: scales against closed forms, what a hint may do, forces brought into a cone, what a
 * cone resists of a motion, and the proof a motion gives. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/forces.c"

#include <math.h>

#include "scale.h"

/* What was counted for a certificate check is what it takes, of the cone and of pyramids. */
TEST(a_certificate_check_takes_what_was_counted)
{
    for (int32_t faces = 0; faces <= 64; faces += 8) {
        one_block o;
        NEED(place(&o, 1, 1, 0.5, 0, 0.5));
        o.set.faces = faces;
        const size_t need = sp__certifier_need(&o.pb, &o.set), from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        sp_arena a = { test_arena.base + from, need, 0, 0 }, less = { test_arena.base + from, need - SP_ALIGN, 0, 0 };
        CHECK(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, INT32_MAX, &a));
        CHECK_INT(a.peak, need);
        CHECK(!sp__certifier_open(&o.j, &o.pb, &o.set, NULL, INT32_MAX, &less));
    }
}

/* The bilateral force under a block in the middle is a quarter of its weight at each corner: sbar = 2 W, and each quarter has
 * the arm a / sqrt 2 about the centroid, so Sbar = W a / sqrt 2 and what rounding adds. All in units of the largest load, W. */
TEST(scale_of_a_block_in_the_middle_is_a_closed_form)
{
    static const double mass[] = { 1e-6, 1, 3e7 }, side[] = { 1e-3, 1, 40 };
    for (int m = 0; m < 3; m++)
        for (int q = 0; q < 3; q++) {
            const sp_arena mark = test_arena;
            one_block o;
            NEED(place(&o, mass[m], side[q], side[q] / 2, 0, 0.5));
            NEED(judge(&o, NULL));
            const sp__scale *s = &o.j.scale[0];
            const double arm = side[q] * sqrt(0.75), slack = 16 * (double)SP_EPSILON * 2 * arm / (double)o.set.tol;
            CHECK_NEAR(o.j.unit, mass[m] * 9.80665, TOL(1e-12, 1e-6));
            CHECK_NEAR(s->load, 1, TOL(1e-12, 1e-6));
            CHECK_NEAR(s->s, 2, TOL(1e-9, 1e-4));
            CHECK_NEAR(s->arm, arm, TOL(1e-12, 1e-6));
            CHECK_NEAR(s->S, side[q] / sqrt(2.0) + slack, TOL(1e-9, 1e-4));
            CHECK_NEAR(s->force_cap, 2, TOL(1e-9, 1e-4));
            CHECK_NEAR(sp__certifier_force_cap(&o.j, o.pb.contact), 200, TOL(1e-9, 1e-4));
            test_arena = mark;
        }
}

/* What a hint says wrongly is solved for instead; whatever it says, no number but a number comes out. */
TEST(hint_changes_no_scale)
{
    static const double wrong[] = { 0, 1, -1e12, 1e300, NAN, INFINITY };
    one_block o;
    NEED(place(&o, 5, 1, 0.5, 0.3, 0.5));
    NEED(judge(&o, NULL));
    const sp__scale own = o.j.scale[0];
    for (int k = 0; k < 6; k++) {
        sp_real hint[12];
        for (int q = 0; q < 12; q++) hint[q] = R(wrong[k] * (k ? test_random_real(0.5, 1) : 0));
        NEED(judge(&o, hint));
        CHECK_NEAR(o.j.scale[0].s, own.s, TOL(1e-8, 1e-3));
        CHECK_NEAR(o.j.scale[0].S, own.S, TOL(1e-8, 1e-3));
        CHECK_NEAR(o.j.scale[0].force_cap, own.force_cap, TOL(1e-8, 1e-3));
    }
}

/* Whatever comes in, what comes out is in the cone: fn kept where it presses, no tension, friction shortened and not turned, no
 * more than the cap. */
TEST(admitted_force_is_in_the_cone)
{
    static const int32_t faces[] = { 0, 3, 4, 8, 9, 64 };
    for (int q = 0; q < 6; q++) {
        const sp_arena mark = test_arena;
        one_block o;
        NEED(place(&o, 1, 1, 0.5, 0, 0.6));
        o.set.faces = faces[q];
        o.set.inscribed = q % 2;
        NEED(judge(&o, NULL));
        const sp_contact *t = o.pb.contact;
        o.j.force_cap = 50;
        for (int k = 0; k < 500; k++) {
            const sp_real f[3] = { test_random_real(-1, 60), test_random_real(-9, 9), test_random_real(-9, 9) };
            sp_real g[3];
            sp__certifier_make_admissible(&o.j, t, f, g);
            const double mu = 0.6 * (faces[q] && q % 2 ? cos(3.14159265358979323846 / faces[q]) : 1), u = TOL(1e-12, 1e-5);
            double most = faces[q] ? 0 : hypot((double)g[1], (double)g[2]);
            for (int32_t d = 0; d < faces[q]; d++) {
                const double turn = 2 * 3.14159265358979323846 * d / faces[q];
                most = fmax(most, cos(turn) * (double)g[1] + sin(turn) * (double)g[2]);
            }
            CHECK(g[0] >= 0);
            CHECK(most <= mu * (double)g[0] + u * 60);
            CHECK(sp__norm3(g) <= o.j.force_cap * (1 + R(u)));
            CHECK_WITHIN(g[1] * f[2] - g[2] * f[1], 0, u * 600);
            CHECK(g[1] * f[1] + g[2] * f[2] >= 0);
            if (f[0] > 0 && f[0] < 40) CHECK_NEAR(g[0], f[0], u);
            sp_real again[3];
            sp__certifier_make_admissible(&o.j, t, g, again);
            for (int i = 0; i < 3; i++) CHECK_WITHIN(again[i], g[i], u * 60);
        }
        test_arena = mark;
    }
}

/* |P_K(u)| is the largest g . u over unit g in K: no g tried comes above it, and the best of many comes near. */
TEST(resistance_of_a_cone_is_the_largest_work_of_a_unit_force)
{
    static const int32_t faces[] = { 0, 3, 4, 8, 16, 64 };
    for (int q = 0; q < 6; q++) {
        const sp_arena mark = test_arena;
        one_block o;
        NEED(place(&o, 1, 1, 0.5, 0, 0.7));
        o.set.faces = faces[q];
        o.set.inscribed = q % 2;
        NEED(judge(&o, NULL));
        o.j.force_cap = 1e6f;
        for (int k = 0; k < SOME_OF(60, 20); k++) {
            const sp_real u[3] = { test_random_real(-1, 1), test_random_real(-1, 1), test_random_real(-1, 1) };
            const double got = (double)sp__certifier_cone_resistance(&o.j, o.pb.contact, u);
            double best = 0;
            for (int i = 0; i < 4000; i++) {
                const sp_real wild[3] = { test_random_real(0, 1), test_random_real(-2, 2), test_random_real(-2, 2) };
                sp_real g[3];
                sp__certifier_make_admissible(&o.j, o.pb.contact, wild, g);
                const double size = (double)sp__norm3(g);
                if (size > 0) best = fmax(best, (double)sp__dot3(g, u) / size);
            }
            CHECK(best <= got + TOL(1e-12, 1e-5));
            CHECK(got <= best + 0.05);
        }
        test_arena = mark;
    }
}

/* Down a slope steeper than friction: dq = t + mu n opens no more than friction asks, so nothing resists it, and
 * p . dq = W (sin - mu cos) is what it proves, over sbar |dq|. Less steep it proves nothing. */
TEST(sliding_motion_proves_its_power_balance)
{
    const double mu = 0.5;
    for (int k = 0; k < 12; k++) {
        const sp_arena mark = test_arena;
        const double angle = 0.2 + 0.06 * k, c = cos(angle), s = sin(angle), power = s - mu * c;
        const double scale = k % 3 == 0 ? 1 : k % 3 == 1 ? 1e-7 : 1e5;          /* a motion has no size of its own */
        one_block o;
        int32_t final = 0;
        NEED(place(&o, 3, 1, 0.5, angle, mu));
        o.set.faces = SP__HAS_STRENGTH && k / 2 % 2 ? 4 : 0;
        o.set.inscribed = k % 2;
        NEED(judge(&o, NULL));
        const double more = mu * (1 + TOL(1e-6, 1e-2));                       /* clear of the edge of the cone */
        const sp_real dq[6] = { R(scale * (-c - more * s)), 0, R(scale * (-s + more * c)), 0, 0, 0 };
        const double value = (double)sp__certify_motion(&o.j, dq, 0, 0, &final);
        const double want = (s - more * c) / ((double)o.j.scale[0].s * sqrt(1 + more * more));
        if (power > 0.02) {
            CHECK_NEAR(value, want, TOL(1e-9, 1e-3));
            CHECK_INT(final, !(o.set.faces && o.set.inscribed));        /* the cone has more friction than what is in it */
        } else if (power < -0.02) CHECK_INT(value > 0, 0);
        test_arena = mark;
    }
}

/* Into the ground is resisted by the caps: a proof of nothing, and not final. */
TEST(motion_into_a_joint_proves_nothing)
{
    one_block o;
    int32_t final = 1;
    const sp_real down[6] = { 0, 0, -1, 0, 0, 0 };
    NEED(place(&o, 3, 1, 0.5, 0, 0.5));
    NEED(judge(&o, NULL));
    CHECK_INT(sp__certify_motion(&o.j, down, 0, 0, &final) > 0, 0);
    CHECK_INT(final, 0);
    CHECK_NEAR(o.j.resist, 4 * 200, TOL(1e-9, 1e-4));   /* four corners, each of its cap, in units of the motion's largest */
}

/* Forces that are a relative x out of balance are found to be: by x of load and force together. */
TEST(imbalance_is_relative_to_load_and_forces)
{
    for (int k = 0; k < 8; k++) {
        const sp_arena mark = test_arena;
        const double off = pow(10, -k);
        one_block o;
        sp_real f[12];
        NEED(place(&o, 7, 1, 0.5, 0, 0.5));
        NEED(judge(&o, NULL));
        for (int v = 0; v < 4; v++) {
            f[3 * v] = R(7 * 9.80665 / 4 * (1 - off));
            f[3 * v + 1] = f[3 * v + 2] = 0;
        }
        CHECK_WITHIN(sp__certify_forces(&o.j, f, NULL), off / (1 + (1 - off)), TOL(1e-12, 1e-6));
        test_arena = mark;
    }
}

/* Load, couple and longest arm of every block, the sum of all loads, and weights 1/sqrt(n) and 1/sqrt(2/3 sum |r - c|^2). */
TEST(weights_loads_and_arms_follow_from_blocks_and_corners)
{
    uint32_t draws = test_random() | 1;
    for (int trial = 0; trial < 20; trial++) {
        const sp_arena mark = test_arena;
        one_block o;
        double total = 0;
        NEED(chain(&o, &draws));
        NEED(judge(&o, NULL));
        const double unit = (double)o.j.unit;
        for (int32_t b = 1; b < 5; b++) {
            const sp__scale *s = &o.j.scale[b - 1];
            const sp_load *l = &o.scene.load[0];
            double force[3] = { 0, 0, -9.80665 * (double)o.scene.block[b].mass }, couple[3] = { 0, 0, 0 }, arm[3];
            double sum = 0, most = 0;
            int corners = 0;
            if (b == l->block) {
                double f[3], m[3];
                for (int k = 0; k < 3; k++) {
                    f[k] = (double)l->force[k];
                    arm[k] = (double)l->point[k] - (double)o.scene.block[b].centroid[k];
                }
                cross(arm, f, m);
                for (int k = 0; k < 3; k++) { force[k] += f[k]; couple[k] = (double)l->couple[k] + m[k]; }
            }
            for (int32_t v = 0; v < o.scene.count.points; v++) {
                if (!arm_of(&o, b, v, arm)) continue;
                corners++;
                sum += length(arm) * length(arm);
                most = fmax(most, length(arm));
            }
            total += length(force) / unit;
            CHECK_NEAR(s->load, length(force) / unit, TOL(1e-12, 1e-5));
            CHECK_NEAR(s->couple, length(couple) / unit, TOL(1e-12, 1e-5));
            CHECK_NEAR(s->arm, most, TOL(1e-12, 1e-5));
            CHECK_NEAR(s->wf, 1 / sqrt(corners), TOL(1e-12, 1e-5));
            CHECK_NEAR(s->wm, 1 / sqrt(2.0 / 3 * sum), TOL(1e-12, 1e-5));
        }
        CHECK_NEAR(o.j.total, total, TOL(1e-12, 1e-5));
        for (int32_t c = 0; c < 4; c++) {               /* a joint's force is bound by the block that carries less */
            const double above = (double)o.j.scale[c].force_cap, below = c ? (double)o.j.scale[c - 1].force_cap : above;
            CHECK_NEAR(sp__certifier_force_cap(&o.j, &o.pb.contact[c]), 100 * fmin(above, below), TOL(1e-12, 1e-5));
        }
        test_arena = mark;
    }
}

/* What a corner sees of two blocks that move: v + w x (r - c) of each, that of the one on it with +. */
TEST(corners_move_with_their_blocks)
{
    uint32_t draws = test_random() | 1;
    for (int trial = 0; trial < 20; trial++) {
        const sp_arena mark = test_arena;
        one_block o;
        sp_real dq[24];
        NEED(chain(&o, &draws));
        for (int k = 0; k < 24; k++) dq[k] = R(test_draw(&draws, -1, 1));
        for (int32_t c = 0; c < 4; c++)
            for (int32_t v = o.scene.joint[c].point; v < o.scene.joint[c].point + o.scene.joint[c].points; v++) {
                double want[3] = { 0, 0, 0 };
                sp_real u[3];
                for (int32_t b = c; b < c + 2; b++) {
                    double arm[3], spin[3], turned[3];
                    if (b < 1) continue;
                    arm_of(&o, b, v, arm);
                    for (int k = 0; k < 3; k++) spin[k] = (double)dq[6 * (b - 1) + 3 + k];
                    cross(spin, arm, turned);
                    for (int k = 0; k < 3; k++) want[k] += (b > c ? 1 : -1) * ((double)dq[6 * (b - 1) + k] + turned[k]);
                }
                sp__vertex_velocity(&o.pb, NULL, &o.pb.contact[c], v, dq, u);
                for (int k = 0; k < 3; k++) CHECK_WITHIN(u[k], want[k], TOL(1e-13, 1e-5));
            }
        test_arena = mark;
    }
}

/* f0 of any potential and correction, corner by corner: what it leaves of every block's balance, and how much goes through it. */
TEST(what_a_potential_leaves_unbalanced_is_summed_corner_by_corner)
{
    uint32_t draws = test_random() | 1;
    for (int trial = 0; trial < 20; trial++) {
        const sp_arena mark = test_arena;
        one_block o;
        double row[5][6] = { { 0 } }, sums[5][2] = { { 0 } };
        NEED(chain(&o, &draws));
        o.scene.block[2].fixed = trial % 2 ? 5u : 0u;   /* along x and z: what is held is balanced */
        NEED(CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK));
        NEED(judge(&o, NULL));
        for (int k = 0; k < 24; k++) {
            o.j.dual.potential[k] = test_random_real(-1, 1);
            o.j.correction[k] = test_random_real(-1, 1);
        }
        for (int32_t v = 0; v < o.scene.count.points; v++) {
            double f[3] = { 0, 0, 0 }, arm[3], m[3];
            for (int32_t b = 1; b < 5; b++) {           /* the block on a joint counts with +, the one under it with - */
                double w[3], x[6];
                if (!arm_of(&o, b, v, arm)) continue;
                const double sign = v < o.scene.joint[b - 1].point + o.scene.joint[b - 1].points ? 1 : -1;
                for (int k = 0; k < 6; k++)
                    x[k] = ((double)o.j.dual.potential[6 * (b - 1) + k] + (double)o.j.correction[6 * (b - 1) + k]) *
                           (double)(k < 3 ? o.j.scale[b - 1].wf : o.j.scale[b - 1].wm);
                cross(x + 3, arm, w);
                for (int k = 0; k < 3; k++) f[k] += sign * (x[k] + w[k]);
            }
            for (int32_t b = 1; b < 5; b++) {
                if (!arm_of(&o, b, v, arm)) continue;
                const double sign = v < o.scene.joint[b - 1].point + o.scene.joint[b - 1].points ? 1 : -1;
                cross(arm, f, m);
                for (int k = 0; k < 3; k++) { row[b][k] += sign * f[k]; row[b][3 + k] += sign * m[k]; }
                sums[b][0] += length(f);
                sums[b][1] += length(m);
            }
        }
        o.j.sweeps = 0;
        CHECK_INT(sp__certifier_sums(&o.j), 4);         /* nothing of it balances anything */
        CHECK_INT(o.j.sweeps, 1);
        for (int32_t b = 1; b < 5; b++) {
            for (int k = 0; k < 6; k++) {
                const double want = row[b][k] + (double)(o.pb.p[6 * (b - 1) + k] / o.j.unit);
                const int held = trial % 2 && b == 2 && (k == 0 || k == 2);
                CHECK_WITHIN(o.j.residual[6 * (b - 1) + k], held ? 0 : want, held ? 0 : TOL(1e-10, 1e-3));
            }
            CHECK_NEAR(o.j.scale[b - 1].sum_f0, sums[b][0], TOL(1e-11, 1e-4));
            CHECK_NEAR(o.j.scale[b - 1].sum_m0, sums[b][1], TOL(1e-11, 1e-4));
            CHECK_INT(o.j.scale[b - 1].known, 0);
        }
        test_arena = mark;
    }
}

/* No sweep, no f0: every block is measured by its load alone, and that counts as known. */
TEST(without_sweeps_scales_are_those_of_the_loads)
{
    one_block o;
    uint32_t draws = test_random() | 1;
    NEED(chain(&o, &draws));
    NEED(CHECK(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, 0, &test_arena)));
    for (int i = 0; i < 4; i++) {
        const sp__scale *s = &o.j.scale[i];
        CHECK_INT(s->known, 1);
        CHECK_NEAR(s->sum_f0, 0, 0);
        CHECK_NEAR(s->sum_m0, 0, 0);
        CHECK_NEAR(s->force_cap, s->load, 0);
        CHECK_NEAR(s->s, s->load, 0);
        CHECK_NEAR(s->S, (double)s->couple + 16 * (double)SP_EPSILON * (double)(s->load * s->arm / o.set.tol), TOL(1e-12, 1e-5));
    }
    CHECK_INT(o.j.sweeps, 0);
}

/* What no f0 balances, a block beside its only point, is measured by twice its load; its caps by what rounding may hide in f0 of
 * all loads, or, where two sweeps left no time to find f0, by a thousand times all loads. */
TEST(what_no_force_balances_is_measured_by_its_load)
{
    for (int k = 0; k < 4; k++) {
        const int few = k % 2, aside = k / 2;
        const double load = aside ? sqrt(2.0) : 1;      /* as much along x as its weight, or the weight alone */
        one_block o;
        NEED(place(&o, 4, 1, 0.5, 0, 0.5));
        o.scene.count.points = o.scene.joint[0].points = 1;     /* one corner of the four is left */
        NEED(CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK));
        if (aside) o.pb.p[0] = o.pb.p[2];
        NEED(CHECK(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, few ? 2 : INT32_MAX, &test_arena)));
        const sp__scale *s = &o.j.scale[0];
        const double arm = sqrt(0.75), slack = 16 * (double)SP_EPSILON * 2 * arm / (double)o.set.tol;
        CHECK_INT(s->known, 0);
        CHECK_NEAR(s->s, 2 * load, TOL(1e-12, 1e-6));
        CHECK_NEAR(s->S, (arm + slack) * load, TOL(1e-12, 1e-5));
        CHECK_NEAR(o.j.total, load, TOL(1e-12, 1e-6));
        if (few) CHECK_NEAR(s->force_cap, 1000 * load, TOL(1e-12, 1e-6));
        else CHECK((double)s->force_cap > load * (1 + 5000 * (double)SP_EPSILON) && (double)s->force_cap < 2 * load);
    }
}

/* A pebble that no force balances, beside a block 1e8 times as heavy, in float 1e4: 10000 u of all loads may hide in its f0
 * by rounding. Counted twice, loads are not summed twice. */
TEST(a_cap_counts_what_rounding_of_all_loads_may_hide)
{
    const sp_capacity room = { 3, 0, 0, 0, 2, 5, 0 };
    const sp_real at[3] = { R(0.3), 0, 1 }, far[3] = { 50, 0, 1 }, up[3] = { 0, 0, 1 }, ground[3] = { 0, 0, -1 };
    const sp_real foot[3] = { 0, 0, 0 }, feet[12] = { 49, -1, 0, 51, -1, 0, 51, 1, 0, 49, 1, 0 };
    const sp_strength rough = { R(0.5), 0, 0, 0 };
    one_block o;
    memset(&o, 0, sizeof o);
    o.set.tol = R(TOL(1e-9, 1e-4f));
    o.set.force_bound = 100;
    NEED(CHECK_INT(sp_scene_create(&o.scene, &room, &test_arena), SP_OK));
    NEED(CHECK_INT(sp_scene_body(&o.scene, 0, ground, SP_FIXED, NULL), SP_OK));
    NEED(CHECK_INT(sp_scene_body(&o.scene, R(1e-4), at, 0, NULL), SP_OK));
    NEED(CHECK_INT(sp_scene_body(&o.scene, R(TOL(1e4, 1)), far, 0, NULL), SP_OK));
    NEED(CHECK_INT(sp_scene_points(&o.scene, 0, 1, up, 1, foot, &rough, NULL), SP_OK));
    NEED(CHECK_INT(sp_scene_joint(&o.scene, 0, 2, 4, feet, &rough, NULL), SP_OK));
    NEED(CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK));
    NEED(judge(&o, NULL));
    const sp__scale *s = &o.j.scale[0];
    const double hidden = 10000 * (double)SP_EPSILON * (double)o.j.total, f0 = (double)o.j.pass.sums[0];
    CHECK_INT(s->known, 0);
    CHECK_INT(o.j.scale[1].known, 1);
    CHECK(hidden > TOL(1e-5, 1e-2) * (double)s->load);
    CHECK_NEAR(s->force_cap, (double)s->load + f0 + hidden, TOL(1e-14, 1e-6));
    const sp_real total = o.j.total;
    sp__certifier_scales(&o.j, NULL);
    CHECK_NEAR(o.j.total, total, 0);
}

/* A block that touches nothing has no weights, one whose only point is its centroid none of rotation. */
TEST(what_has_no_corner_or_no_arm_has_no_weight)
{
    const sp_capacity room = { 3, 0, 0, 0, 1, 1, 0 };
    const sp_real ground[3] = { 0, 0, 0 }, at[3] = { 1, 0, 1 }, far[3] = { 9, 0, 1 }, up[3] = { 0, 0, 1 };
    const sp_strength rough = { R(0.5), 0, 0, 0 };
    one_block o;
    memset(&o, 0, sizeof o);
    o.set.tol = R(TOL(1e-9, 1e-4f));
    o.set.force_bound = 100;
    CHECK_INT(sp_scene_create(&o.scene, &room, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(&o.scene, 0, ground, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&o.scene, 1, at, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_body(&o.scene, 1, far, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_points(&o.scene, 0, 1, up, 1, at, &rough, NULL), SP_OK);
    CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK);
    NEED(judge(&o, NULL));
    CHECK_NEAR(o.j.scale[0].wf, 1, TOL(1e-12, 1e-6));
    CHECK_NEAR(o.j.scale[0].wm, 0, 0);
    CHECK_NEAR(o.j.scale[1].wf, 0, 0);
    CHECK_NEAR(o.j.scale[1].wm, 0, 0);
}

/* Within a thousandth of the load and 10000 roundings of f0, a moment that times the longest arm; just that is within. */
TEST(f0_balances_a_block_up_to_its_allowance)
{
    const sp_real load = 3, f0 = R(TOL(7e6, 7)), arm = R(0.25);
    const sp_real enough = (sp_real)1e-3 * load + 10000 * (sp_real)SP_EPSILON * f0;
    for (int k = 0; k < 6; k++) {
        sp_real r[6] = { 0, 0, 0, 0, 0, 0 };
        r[k] = k < 3 ? enough : enough * arm;
        CHECK_INT(sp__scale_is_balanced(r, load, f0, arm), 1);
        r[k] *= R(1 + 4 * (double)SP_EPSILON);
        CHECK_INT(sp__scale_is_balanced(r, load, f0, arm), 0);
    }
}

/* The numbers of a hint are row weights times potential times the unit; what is none, or has no square, or is of a row that is
 * held or has no weight, counts as 0. */
TEST(a_hint_is_read_row_by_row)
{
    const double odd[] = { NAN, INFINITY, -INFINITY, TOL(1e200, 1e30), TOL(-1e170, -1e25) };
    uint32_t draws = test_random() | 1;
    one_block o;
    sp_real y0[24], x[24];
    NEED(chain(&o, &draws));
    o.scene.block[2].fixed = 5u;                        /* along x and z */
    NEED(CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK));
    NEED(judge(&o, NULL));
    o.j.scale[3].wm = 0;
    for (int trial = 0; trial < 6; trial++) {
        for (int k = 0; k < 24; k++) { y0[k] = R(test_draw(&draws, 1, 2)); x[k] = 7; }
        if (trial) y0[13] = R(odd[trial - 1]);
        sp__certifier_read_hint(&o.j, y0, x);
        for (int k = 0; k < 24; k++) {
            const double w = (double)(k % 6 < 3 ? o.j.scale[k / 6].wf : o.j.scale[k / 6].wm);
            const int none = k == 6 || k == 8 || k > 20 || (trial && k == 13);
            CHECK_NEAR(x[k], none ? 0 : (double)y0[k] / (double)o.j.unit / w, none ? 0 : TOL(1e-14, 1e-6));
        }
    }
    sp__certifier_read_hint(&o.j, NULL, x);
    for (int k = 0; k < 24; k++) CHECK_NEAR(x[k], 0, 0);
}

/* Strength of a corner, its share of the joint's, in units of the largest load; friction of an inscribed pyramid is less. */
TEST(strength_of_a_corner_is_its_share_in_units)
{
    one_block o;
    NEED(place(&o, 5, 2, 0.5, 0, 0.5));
    o.set.faces = SP__HAS_STRENGTH ? 4 : 0;
    o.set.inscribed = 1;
    NEED(judge(&o, NULL));
    CHECK_NEAR(sp__certifier_strength(&o.j, o.pb.contact).N, SP__HUGE, 0);
    CHECK_NEAR(sp__certifier_strength(&o.j, o.pb.contact).C, 0, 0);
    if (!SP__HAS_STRENGTH) return;
    const sp_strength strong = { R(0.5), 40, 60, 900 };
    o.scene.joint[0].strength = strong;
    const sp__vertex_limits k = sp__certifier_strength(&o.j, o.pb.contact);
    CHECK_NEAR(k.C, 40 * sqrt(0.5) / (double)o.j.unit, TOL(1e-12, 1e-5));      /* an area of 4, 1 each */
    CHECK_NEAR(k.T, 60 / (double)o.j.unit, TOL(1e-12, 1e-5));
    CHECK_NEAR(k.N, 900 / (double)o.j.unit, TOL(1e-12, 1e-5));
}

TEST_LIST(scale)
    RUN(a_certificate_check_takes_what_was_counted)
    RUN(scale_of_a_block_in_the_middle_is_a_closed_form)
    RUN_FULL(hint_changes_no_scale)
    RUN_FULL(admitted_force_is_in_the_cone)
    RUN_FULL(resistance_of_a_cone_is_the_largest_work_of_a_unit_force)
    RUN(sliding_motion_proves_its_power_balance)
    RUN(motion_into_a_joint_proves_nothing)
    RUN(imbalance_is_relative_to_load_and_forces)
    RUN(weights_loads_and_arms_follow_from_blocks_and_corners)
    RUN(corners_move_with_their_blocks)
    RUN(what_a_potential_leaves_unbalanced_is_summed_corner_by_corner)
    RUN(without_sweeps_scales_are_those_of_the_loads)
    RUN(what_no_force_balances_is_measured_by_its_load)
    RUN(a_cap_counts_what_rounding_of_all_loads_may_hide)
    RUN(what_has_no_corner_or_no_arm_has_no_weight)
    RUN(f0_balances_a_block_up_to_its_allowance)
    RUN(a_hint_is_read_row_by_row)
    RUN(strength_of_a_corner_is_its_share_in_units)
TEST_END
