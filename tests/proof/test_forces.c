/* Joints with strength, and the proof a motion gives, from the inside: what a corner resists against every force it has and by
 * formulas; which of the motions with smaller ones held is taken; how a motion is written. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/forces.c"

#include <math.h>

#include "scale.h"

#ifndef SP_SMALL

/* |ft| <= C + mu fn, -T <= fn <= N of a corner, in units; a cap on forces; faces of the pyramid, 0: the cone. */
typedef struct limits { double mu, C, T, N, cap; int32_t faces, inscribed; } limits;

/* A block on four corners that have these limits each, in an inscribed pyramid by more friction and cohesion of the joint; what
 * was in the check before is not. */
static int strong(one_block *o, const limits *k)
{
    const double less = k->faces && k->inscribed ? cos(3.14159265358979323846 / k->faces) : 1;
    if (!place(o, 1, 1, 0.5, 0, k->mu / less)) return 0;
    o->set.faces = k->faces;
    o->set.inscribed = k->inscribed;
    memset(&o->j, 0x41, sizeof o->j);
    if (!judge(o, NULL)) return 0;
    const double share = (double)o->j.unit * 4 / (double)o->scene.joint[0].area;
    o->scene.joint[0].strength.cohesion = R(k->C / less * share);
    o->scene.joint[0].strength.tension = R(k->T * share);
    o->scene.joint[0].strength.crushing = R(k->N * share);
    return 1;
}

/* Limits at random; T <= C / mu. */
static limits some(int round)
{
    static const int32_t cones[] = { 0, 3, 4, 8, 13, 64 };
    limits k;
    k.mu = (double)test_random_real(0.2, 1.2);
    k.C = (double)test_random_real(0.5, 2);
    k.T = k.C / k.mu * (double)test_random_real(0, 1);
    k.N = (double)test_random_real(3, 9);
    k.cap = round % 5 ? (double)test_random_real(0.5, 3) : 1000;
    k.faces = cones[round % 6];
    k.inscribed = round / 6 % 2;
    return k;
}

/* Corner `at` of a polygon of K sides about the unit circle, its sides' middles at 0, 2 pi / K, .. */
static void corner_of(int32_t K, int32_t at, double c[2])
{
    const double pi = 3.14159265358979323846, turn = pi * (2 * at + 1) / K;
    c[0] = cos(turn) / cos(pi / K);
    c[1] = sin(turn) / cos(pi / K);
}

/* Largest c . ut over the circle or the polygon. */
static double reach(int32_t faces, const double u[3])
{
    double most = faces ? 0 : hypot(u[1], u[2]);
    for (int32_t k = 0; k < faces; k++) {
        double c[2];
        corner_of(faces, k, c);
        most = fmax(most, c[0] * u[1] + c[1] * u[2]);
    }
    return most;
}

/* A force of the corner at random: within its limits and its cap. */
static void force(const limits *k, double f[3])
{
    const double fn = -k->T + (k->N + k->T) * pow((double)test_random_real(0, 1), 3), room = k->C + k->mu * fn;
    const double turn = (double)test_random_real(0, 6.2832);
    double g[3] = { 0, cos(turn), sin(turn) }, most = k->faces ? 0 : 1;
    for (int32_t q = 0; q < k->faces; q++) {            /* the nearest side */
        const double side = 6.28318530717958647692 * q / k->faces;
        most = fmax(most, cos(side) * g[1] + sin(side) * g[2]);
    }
    const double size = test_random_int(0, 1) ? room / most : room / most * (double)test_random_real(0, 1);
    f[0] = fn; f[1] = g[1] * size; f[2] = g[2] * size;
    const double all = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    for (int q = 0; q < 3 && all > k->cap; q++) f[q] *= k->cap / all;
}

/* max(low a - T un, high a + N un) over both rims; low a - T un + (cap + T + low / cos) P over the lower one and the cone. */
TEST(a_corner_with_strength_resists_by_its_rims_or_by_its_cap)
{
    int rims = 0, caps = 0;
    for (int round = 0; round < 240; round++) {
        const sp_arena mark = test_arena;
        const limits k = some(round);
        one_block o;
        double u[3], f[3];
        NEED(strong(&o, &k));
        for (int q = 0; q < 3; q++) u[q] = (double)test_random_real(-1, 1);
        const sp_real v[3] = { R(u[0]), R(u[1]), R(u[2]) }, P = sp__certifier_cone_resistance(&o.j, o.pb.contact, v);
        for (int was = 0; was < 2; was++) {
            int capped = was;
            const double got = (double)sp__certifier_strength_resistance(&o.j, o.pb.contact, v, P, R(k.cap), &capped);
            const double a = reach(k.faces, u), low = fmax(0, k.C - k.mu * k.T), foot = low * a - k.T * u[0];
            const double shut = fmax(foot, (k.C + k.mu * k.N) * a + k.N * u[0]);
            const double open = foot + (k.cap + k.T + low / (k.faces ? cos(3.14159265358979323846 / k.faces) : 1)) * (double)P;
            CHECK_WITHIN(got, fmin(shut, open), TOL(1e-12, 2e-5) * (20 + k.cap));
            if (fabs(shut - open) > TOL(1e-9, 1e-3)) CHECK_INT(capped, was && shut > open);
            rims += shut < open;
            caps += open < shut;
            for (int many = 0; many < 40; many++) {
                force(&k, f);
                CHECK(f[0] * u[0] + f[1] * u[1] + f[2] * u[2] <= got + TOL(1e-12, 2e-5) * (20 + k.cap));
            }
        }
        test_arena = mark;
    }
    CHECK(rims > 20 && caps > 20);
}

/* What moves no corner is resisted by nothing, and not by its cap. */
TEST(a_corner_that_does_not_move_has_no_cap)
{
    const limits k = { 0.5, 1, 1, 5, 10, 8, 0 };
    const sp_real rest[3] = { 0, 0, 0 };
    one_block o;
    int capped = 1;
    NEED(strong(&o, &k));
    CHECK_NEAR(sp__certifier_strength_resistance(&o.j, o.pb.contact, rest, 0, 10, &capped), 0, 0);
    CHECK_INT(capped, 0);
}

/* Within its limits a force stays; beyond them fn is cut, ft is shortened to the nearest side, all to the cap. */
TEST(a_force_is_cut_to_the_strength_of_its_corner)
{
    for (int round = 0; round < 240; round++) {
        const sp_arena mark = test_arena;
        const limits k = some(round);
        one_block o;
        double f[3];
        sp_real g[3], out[3];
        NEED(strong(&o, &k));
        o.j.force_cap = R(k.cap);
        force(&k, f);
        for (int q = 0; q < 3; q++) g[q] = R(f[q] * 0.999);
        sp__certifier_make_admissible(&o.j, o.pb.contact, g, out);
        if (k.T > 0.01 && g[0] > R(-0.99 * k.T)) for (int q = 0; q < 3; q++) CHECK_WITHIN((double)out[q], (double)g[q], TOL(1e-12, 1e-5));
        for (int q = 0; q < 3; q++) g[q] = test_random_real(-20, 20);
        sp__certifier_make_admissible(&o.j, o.pb.contact, g, out);
        const double fn = fmin(k.N, fmax(-k.T, (double)g[0])), room = fmax(0, k.C + k.mu * fn);
        double most = k.faces ? 0 : hypot((double)g[1], (double)g[2]);
        for (int32_t q = 0; q < k.faces; q++) {
            const double side = 6.28318530717958647692 * q / k.faces;
            most = fmax(most, cos(side) * (double)g[1] + sin(side) * (double)g[2]);
        }
        const double share = most > room ? room / most : 1;
        double want[3] = { fn, (double)g[1] * share, (double)g[2] * share };
        const double all = sqrt(want[0] * want[0] + want[1] * want[1] + want[2] * want[2]);
        for (int q = 0; q < 3; q++) CHECK_WITHIN((double)out[q], all > k.cap ? want[q] * k.cap / all : want[q], TOL(1e-11, 1e-4));
        test_arena = mark;
    }
}

/* work - sum of what corners resist, over the scales; how much they resist is left in the check, for no motion nothing. */
TEST(a_motion_is_worth_its_work_less_what_its_corners_resist)
{
    int proofs = 0;
    for (int round = 0; round < 120; round++) {
        const sp_arena mark = test_arena;
        const limits k = some(round);
        const sp_real none[6] = { 0, 0, 0, 0, 0, 0 };
        one_block o;
        sp_real dq[6];
        double largest, resist = 0, work = 0;
        int32_t final;
        NEED(strong(&o, &k));
        if (round % 2) o.scene.joint[0].strength.cohesion = o.scene.joint[0].strength.tension = o.scene.joint[0].strength.crushing = 0;
        for (int q = 0; q < 6; q++) dq[q] = test_random_real(-1, 1);
        if (round > 59) o.set.force_bound = R(0.01);    /* little is resisted: some motions are proofs */
        const sp_contact *t = o.pb.contact;
        const double arm = (double)o.j.scale[0].arm, cap = (double)sp__certifier_force_cap(&o.j, t);
        largest = (double)sp__norm3(dq) + (double)sp__norm3(dq + 3) * arm;
        for (int q = 0; q < 6; q++) work += (double)sp__in_units(o.j.unit, o.pb.p[q]) * (double)dq[q] / largest;
        for (int32_t v = 0; v < 4; v++) {
            sp_real w[3], u[3];
            int capped = 0;
            sp__vertex_velocity(&o.pb, NULL, t, v, dq, w);
            sp__joint_frame(t->joint, w, w);
            for (int q = 0; q < 3; q++) u[q] = -w[q];
            const sp_real P = sp__certifier_cone_resistance(&o.j, t, u);
            resist += round % 2 ? cap * (double)P : (double)sp__certifier_strength_resistance(&o.j, t, u, P, R(cap), &capped);
        }
        resist /= largest;
        const double scale = ((double)(o.j.scale[0].s * sp__norm3(dq)) + (double)(o.j.scale[0].S * sp__norm3(dq + 3))) / largest;
        const int32_t before = o.j.sweeps;
        const double value = (double)sp__certify_motion(&o.j, dq, 0, 0, &final);
        CHECK_INT(o.j.sweeps - before, 1);
        CHECK_WITHIN((double)o.j.resist, resist, TOL(1e-10, 1e-3) * (1 + fabs(resist)));
        if (value > 0) CHECK_INT(final && k.faces && k.inscribed, 0);
        proofs += value > 0 && resist > 0.01 * work;
        sp_real size;
        CHECK_NEAR(sp__certifier_work(&o.j, &size), work, TOL(1e-9, 1e-2));
        CHECK_NEAR(size, scale, TOL(1e-10, 1e-3));
        CHECK_WITHIN(value, fmax(0, work - resist) / scale, TOL(1e-10, 1e-3) * (1 + fabs(resist) / scale));
        CHECK_NEAR(sp__certify_motion(&o.j, none, 0, 0, &final), 0, 0);
        CHECK_NEAR(o.j.resist, 0, 0);
        CHECK_INT(final, 0);
        test_arena = mark;
    }
    CHECK(proofs > 5);
}

#endif

/* Forces are judged by what of them is admissible: max |r| / s, |m| / S, s of load and the lesser of sums of f and f0. What is
 * held is balanced. One sweep. */
TEST(forces_are_out_of_balance_by_what_is_admissible_of_them)
{
    int passed[2] = { 0, 0 };
    uint32_t draws = test_random() | 1;
    for (int trial = 0; trial < 40; trial++) {
        const sp_arena mark = test_arena;
        one_block o;
        sp_real f[36], admitted[36];
        double row[5][6] = { { 0 } }, sums[5][2] = { { 0 } }, worst = 0;
        NEED(chain(&o, &draws));
        o.scene.block[2].fixed = trial % 2 ? 5u : 0u;   /* along x and z */
        NEED(CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK));
        NEED(judge(&o, NULL));
        const double size = pow(10, test_draw(&draws, -2, 2)) * (double)o.j.unit;
        for (int32_t k = 0; k < 3 * o.scene.count.points; k++) f[k] = R(size * test_draw(&draws, -1, 1));
        const int32_t before = o.j.sweeps;
        const double got = (double)sp__certify_forces(&o.j, f, admitted);
        CHECK_INT(o.j.sweeps - before, 1);
        for (int32_t c = 0; c < 4; c++) {
            const sp_contact *t = &o.pb.contact[c];
            o.j.force_cap = sp__certifier_force_cap(&o.j, t);
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                sp_real g[3], world[3];
                for (int k = 0; k < 3; k++) g[k] = f[3 * v + k] / o.j.unit;
                sp__certifier_make_admissible(&o.j, t, g, g);
                for (int k = 0; k < 3; k++) CHECK_NEAR(admitted[3 * v + k], g[k] * o.j.unit, TOL(1e-12, 1e-5));
                sp__joint_force(t->joint, g, world);
                const double F[3] = { (double)world[0], (double)world[1], (double)world[2] };
                for (int32_t b = c; b < c + 2; b++) {
                    double arm[3], m[3];
                    if (b < 1) continue;
                    arm_of(&o, b, v, arm);
                    cross(arm, F, m);
                    for (int k = 0; k < 3; k++) {
                        row[b][k] += (b > c ? 1 : -1) * F[k];
                        row[b][3 + k] += (b > c ? 1 : -1) * m[k];
                    }
                    sums[b][0] += length(F);
                    sums[b][1] += length(m);
                }
            }
        }
        for (int32_t b = 1; b < 5; b++) {
            const sp__scale *s = &o.j.scale[b - 1];
            for (int k = 0; k < 6; k++) row[b][k] += (double)(o.pb.p[6 * (b - 1) + k] / o.j.unit);
            if (trial % 2 && b == 2) row[b][0] = row[b][2] = 0;
            const double si = (double)s->load + fmin(sums[b][0], (double)s->sum_f0);
            const double Si = (double)s->couple + fmin(sums[b][1], (double)s->sum_m0)
                              + 16 * (double)SP_EPSILON * (double)(s->s * s->arm / o.set.tol);
            worst = fmax(worst, fmax(length(row[b]) / si, length(row[b] + 3) / Si));
            passed[0] += sums[b][0] < (double)s->sum_f0;
            passed[1] += sums[b][1] < (double)s->sum_m0;
        }
        CHECK_NEAR(got, worst, TOL(1e-10, 1e-3));
        CHECK_NEAR(sp__certify_forces(&o.j, f, NULL), got, 0);
        test_arena = mark;
    }
    for (int k = 0; k < 2; k++) CHECK(passed[k] > 10 && passed[k] < 150);
}

/* Where nothing is loaded caps are none, and no force is that force. */
TEST(where_caps_are_none_no_force_is_admitted)
{
    one_block o;
    sp_real out[3] = { 7, 7, 7 };
    const sp_real none[3] = { 0, 0, 0 }, some[3] = { 1, 0, 0 };
    NEED(place(&o, 1, 1, 0.5, 0, 0.5));
    NEED(judge(&o, NULL));
    o.j.force_cap = 0;
    for (int k = 0; k < 2; k++) {
        sp__certifier_make_admissible(&o.j, o.pb.contact, k ? some : none, out);
        CHECK_NEAR(sp__norm3(out), 0, 0);
    }
}

/* Three blocks in a row along x, one corner between neighbours, in frictionless planes across; loads as the test says. */
static int row(one_block *o, double mu)
{
    const sp_capacity room = { 4, 0, 0, 0, 3, 3, 0 };
    const sp_strength rough = sp_strength_friction(R(mu));
    const sp_real n[3] = { 1, 0, 0 };
    memset(o, 0, sizeof *o);
    o->set.tol = R(TOL(1e-9, 1e-4f));
    o->set.force_bound = 100;
    if (!CHECK_INT(sp_scene_create(&o->scene, &room, &test_arena), SP_OK)) return 0;
    for (int b = 0; b < 4; b++) {
        const sp_real at[3] = { R(b), 0, 0 }, x[3] = { R(b - 0.5), 0, 0 };
        if (!CHECK_INT(sp_scene_body(&o->scene, (sp_real)(b > 0), at, b ? 0 : SP_FIXED, NULL), SP_OK)) return 0;
        if (b && !CHECK_INT(sp_scene_points(&o->scene, b - 1, b, n, 1, x, &rough, NULL), SP_OK)) return 0;
    }
    return CHECK_INT(sp_problem_build(&o->scene, &test_arena, &o->pb), SP_OK) && judge(o, NULL);
}

TEST(a_motion_proves_more_than_tol_or_if_final_more_than_rounding)
{
    one_block o;
    NEED(row(&o, 0));
    const sp_real tol = o.set.tol, least = (4096 + 3) * (sp_real)SP_EPSILON, more = 1 + 4 * (sp_real)SP_EPSILON;
    for (int32_t final = 0; final < 2; final++) {
        CHECK_INT(sp__certify_rank(&o.j, tol * more, final), 2 + final);
        CHECK_INT(sp__certify_rank(&o.j, least, final), SP__WITH_LARGE && least > tol ? 2 + final : 0);
    }
    o.set.tol = 1;
    CHECK_INT(sp__certify_rank(&o.j, 1, 0), 0);
    CHECK_INT(sp__certify_rank(&o.j, 1, 1), SP__WITH_LARGE);
    CHECK_INT(sp__certify_rank(&o.j, least, 1), 0);
    CHECK_INT(sp__certify_rank(&o.j, least * more, 1), SP__WITH_LARGE);
}

/* 447 units of the last place where 448 count for nothing, as two blocks move, and 512 where a motion was read from a claim. */
TEST(a_corner_resists_from_what_rounding_of_both_motions_may_be)
{
    static const struct { int how, units[2]; } row_of[] = { { 0, { 447, 449 } }, { SP__READ, { 511, 513 } } };
    one_block o;
    NEED(row(&o, 0));
    for (int k = 0; k < 4; k++) {
        sp_real dq[18];
        int32_t final;
        memset(dq, 0, sizeof dq);
        dq[6] = 1 - (sp_real)SP_EPSILON * R(row_of[k / 2].units[k % 2]);
        dq[0] = 1;                                      /* the second less than the first: they press */
        dq[12] = 1;
        o.pb.p[0] = 1;
        sp__certify_motion(&o.j, dq, 0, row_of[k / 2].how, &final);
        CHECK_INT(final, k % 2 == 0);
    }
}

/* `rest` itself is held, what is more moves; supports aside. */
TEST(as_many_blocks_are_held_as_move_no_more_than_rest)
{
    one_block o;
    sp_real dq[18];
    NEED(row(&o, 0));
    memset(dq, 0, sizeof dq);
    CHECK_INT(sp__certifier_hold_small(&o.j, dq, 0), -1);
    dq[1] = 4;
    CHECK_INT(sp__certifier_hold_small(&o.j, dq, 0), 2);
    dq[7] = 2; dq[13] = 1;
    CHECK_INT(sp__certifier_hold_small(&o.j, dq, 0), 0);
    CHECK_INT(sp__certifier_hold_small(&o.j, dq, R(0.25)), 1);
    CHECK_INT(sp__certifier_hold_small(&o.j, dq, R(0.5)), 2);
    CHECK_INT(sp__certifier_hold_small(&o.j, dq, R(0.49)), 1);
    CHECK_NEAR(o.j.dual.motion[1], 1, 0);
    CHECK_NEAR(o.j.dual.motion[7], 0.5, 0);
    CHECK_NEAR(o.j.dual.motion[13], 0, 0);
}

/* What a block is held in does not count as moved. */
TEST(held_directions_of_a_motion_are_left_out)
{
    one_block o;
    sp_real dq[18];
    NEED(row(&o, 0));
    o.scene.block[2].fixed = 2u;                        /* along y */
    memset(dq, 0, sizeof dq);
    dq[6] = 1; dq[7] = 100; dq[12] = 2;
    CHECK_INT(sp__certifier_hold_small(&o.j, dq, 0), 1);
    CHECK_NEAR(o.j.dual.motion[6], 0.5, 0);
    CHECK_NEAR(o.j.dual.motion[7], 0, 0);
}

/* A support does not move; a block moves a joint by its longest arm, or, where nothing touches it, half its size, or 1. */
TEST(a_block_displaces_a_joint_by_its_longest_arm)
{
    static const double size[] = { 0, 0.5, 8 };
    one_block o;
    NEED(row(&o, 0));
    for (int k = 0; k < 18; k++) o.j.dual.motion[k] = R(k == 6 ? 3 : k == 9 ? 2 : 0);
    CHECK_NEAR(sp__certifier_displacement(&o.j, -1), 0, 0);
    for (int k = 0; k < 6; k++) {
        o.scene.block[2].diameter = R(size[k % 3]);
        o.j.scale[1].arm = R(k < 3 ? 0 : 0.25);
        const double arm = k > 2 ? 0.25 : k ? size[k] / 2 : 1;
        CHECK_NEAR(sp__certifier_displacement(&o.j, 1), 3 + 2 * arm, TOL(1e-14, 1e-6));
    }
}

/* The first block moves by 1 along y, under one unit of load there; nothing else moves or is loaded. */
static void first_moves(one_block *o, sp_real dq[18])
{
    memset(dq, 0, 18 * sizeof *dq);
    memset(o->pb.p, 0, 18 * sizeof *o->pb.p);
    dq[1] = 1;
    o->pb.p[1] = o->j.unit;
}

/* Work 1 of the first block and what the second adds or takes with its 1e-10: with it where that is more. */
TEST(of_motions_with_smaller_ones_held_the_best_is_taken)
{
    const double small = TOL(1e-10, 1e-4);
    for (int gains = 0; gains < 2; gains++)
        for (int presses = 0; presses < 2; presses++) {
            const sp_arena mark = test_arena;
            one_block o;
            sp_real dq[18], scale;
            int32_t final, whole;
            NEED(row(&o, 0));
            first_moves(&o, dq);
            dq[7] = R(small);
            o.pb.p[7] = o.j.unit * R(gains ? 1000 : -1000);
            if (presses) dq[0] = dq[6] = dq[12] = R(small);     /* away from the ground together: what is held is pressed */
            const double both = (double)sp__certify_motion(&o.j, dq, 0, 0, &whole);
            CHECK_INT(whole, 1);
            const double alone = (double)sp__certify_motion(&o.j, dq, R(0.1), 0, &final);
            CHECK_INT(final, !presses);
            CHECK(gains ? both > alone : both < alone || presses);
            o.j.sweeps = 0;
            const double value = (double)sp__certify_mechanism(&o.j, dq, 0, &final);
            CHECK_INT(final, 1);
            CHECK_NEAR(value, gains || presses ? both : alone, TOL(1e-14, 1e-6));
            CHECK((o.j.dual.motion[7] > 0) == (gains || presses));
            CHECK_INT(o.j.sweeps, gains || presses ? 3 : 2);
            CHECK(sp__certifier_work(&o.j, &scale) > 0);
            CHECK_NEAR(sp__certify_mechanism(&o.j, dq, SP__TOGETHER, &final), both,          /* none of islands is dropped */
                       TOL(1e-14, 1e-6));
            CHECK_INT(final, 1);
            CHECK(o.j.dual.motion[7] > 0);
            test_arena = mark;
        }
}

/* A block that moves 1e-13 of the largest motion, under a load that makes it count; then under none, where to hold it changes no
 * value: of equal proofs the first is left, which holds nothing. */
TEST(a_proof_holds_no_block_but_for_a_better_one)
{
    for (int counts = 0; counts < 2; counts++) {
        const sp_arena mark = test_arena;
        const double small = counts ? 1e-13 : 1e-20;
        one_block o;
        sp_real dq[18];
        int32_t final;
        NEED(row(&o, 0));
        first_moves(&o, dq);
        dq[7] = R(small);
        o.pb.p[7] = o.j.unit * R(counts ? 10 / small : 0);
        const double alone = (double)sp__certify_motion(&o.j, dq, R(0.1), 0, &final);
        CHECK_WITHIN((double)sp__certify_mechanism(&o.j, dq, 0, &final), alone * (counts ? 11 : 1),
                     TOL(1e-11, 1e-4) * alone);
        CHECK_NEAR(o.j.dual.motion[7], small, TOL(1e-15, 1e-6));
        CHECK_INT(final, 1);
        test_arena = mark;
    }
}

/* The first block moves by 1; the second by a share at which it takes ten times the work of the first; the third by a little more,
 * and adds five times that. The best proof is to hold the second alone: it is found where the share is at most one of these. */
TEST(smaller_motions_are_held_from_six_shares_on)
{
    static const double rest[] = { 0, 1e-12, 1e-9, 1e-6, 1e-3, 0.5 };
    for (int k = 1; k < 6; k++)
        for (int beyond = 0; beyond < 2; beyond++) {
            const sp_arena mark = test_arena;
            const double second = rest[k] * (beyond ? 1.01 : 0.99), third = rest[k] * 1.5;
            one_block o;
            sp_real dq[18];
            int32_t final;
            NEED(row(&o, 0));
            first_moves(&o, dq);
            dq[7] = R(second);
            dq[13] = R(third);
            o.pb.p[7] = o.j.unit * R(-10 / second);
            o.pb.p[13] = o.j.unit * R(5 / third);
            const sp_real value = sp__certify_mechanism(&o.j, dq, 0, &final);
            CHECK_INT(value > 0, !beyond || k < 5);
            CHECK_INT(o.j.dual.motion[13] > 0 && !(o.j.dual.motion[7] > 0), !beyond);
            test_arena = mark;
        }
}

/* Two blocks at rest, one pressed into its ground: no proof, whatever is held. */
TEST(a_resisted_motion_among_blocks_at_rest_is_no_proof)
{
    one_block o;
    sp_real dq[18];
    int32_t final;
    NEED(row(&o, 0));
    memset(dq, 0, sizeof dq);
    memset(o.pb.p, 0, 18 * sizeof *o.pb.p);
    dq[0] = -1;
    o.pb.p[0] = -o.j.unit;
    o.j.sweeps = 0;
    CHECK_NEAR(sp__certify_mechanism(&o.j, dq, 0, &final), 0, 0);
    CHECK_INT(final, 0);
    CHECK_INT(o.j.sweeps, 1);
}

/* A block that slides under no load: no contact resists, but it proves nothing. */
TEST(a_motion_without_work_is_not_final)
{
    one_block o;
    sp_real dq[18];
    int32_t final;
    NEED(row(&o, 0));
    first_moves(&o, dq);
    o.pb.p[1] = 0;
    sp__certify_motion(&o.j, dq, 0, 0, &final);
    CHECK_INT(final, 1);
    CHECK_NEAR(sp__certify_mechanism(&o.j, dq, 0, &final), 0, 0);
    CHECK_INT(final, 0);
}

/* No point moves farther than the longest arm, here a half; without arms half the largest block, or 1. With some
 * the largest block without does not count. */
TEST(a_motion_is_written_at_the_size_of_its_blocks)
{
    for (int round = 0; round < 16; round++) {
        const int what = round % 4;                     /* a motion; without arms; none; the last block wide without an arm */
        const double of = round / 4 % 2 ? 1e-3 : 1, wide = what == 3 ? 3 : round / 8 ? 0.2 : 0;
        const sp_arena mark = test_arena;
        one_block o;
        sp_real all[24], back[18];
        NEED(row(&o, 0));
        for (int k = 0; k < 24; k++) all[k] = 7;
        for (int i = 0; i < 3; i++) o.j.scale[i].arm = R(what == 1 || (what == 3 && i == 2) ? 0 : i == 1 ? 0.5 : 0.25);
        memset(o.j.dual.motion, 0, 18 * sizeof *o.j.dual.motion);
        for (int b = 1; b < 4; b++) o.scene.block[b].diameter = R(what || b < 3 ? 2 * wide : 0);
        if (what != 2) {
            o.j.dual.motion[0] = o.j.dual.motion[1] = R(of * sqrt(2.0));
            o.j.dual.motion[9] = R(of);
            o.j.dual.motion[17] = R(4 * of);
        }
        sp__motion_write(&o.j, all);
        const double arm = wide > 0 ? wide : 1, largest = what % 2 ? fmax(2, 4 * arm) : 2, size = what == 1 ? arm : 0.5;
        for (int k = 0; k < 6; k++) CHECK_NEAR(all[k], 7, 0);
        for (int k = 6; k < 8; k++) CHECK_NEAR(all[k], what == 2 ? 0 : sqrt(2.0) * size / largest, TOL(1e-15, 1e-6));
        CHECK_NEAR(all[15], what == 2 ? 0 : size / largest, TOL(1e-15, 1e-6));
        CHECK_NEAR(all[23], what == 2 ? 0 : 4 * size / largest, TOL(1e-15, 1e-6));
        sp__motion_read(&o.pb, all, back);
        for (int k = 0; k < 18; k++) CHECK_NEAR(back[k], all[6 + k], 0);
        test_arena = mark;
    }
}

TEST_LIST(forces)
#ifndef SP_SMALL
    RUN(a_corner_with_strength_resists_by_its_rims_or_by_its_cap)
    RUN(a_corner_that_does_not_move_has_no_cap)
    RUN(a_force_is_cut_to_the_strength_of_its_corner)
    RUN(a_motion_is_worth_its_work_less_what_its_corners_resist)
#endif
    RUN(forces_are_out_of_balance_by_what_is_admissible_of_them)
    RUN(where_caps_are_none_no_force_is_admitted)
    RUN(a_motion_proves_more_than_tol_or_if_final_more_than_rounding)
    RUN(a_corner_resists_from_what_rounding_of_both_motions_may_be)
    RUN(as_many_blocks_are_held_as_move_no_more_than_rest)
    RUN(held_directions_of_a_motion_are_left_out)
    RUN(a_block_displaces_a_joint_by_its_longest_arm)
    RUN(of_motions_with_smaller_ones_held_the_best_is_taken)
    RUN(a_proof_holds_no_block_but_for_a_better_one)
    RUN(smaller_motions_are_held_from_six_shares_on)
    RUN(a_resisted_motion_among_blocks_at_rest_is_no_proof)
    RUN(a_motion_without_work_is_not_final)
    RUN(a_motion_is_written_at_the_size_of_its_blocks)
TEST_END
