/* The certificate check against its definition, on a small scene without symmetry: scales from a dense least-squares solution,
 * imbalance of forces, what a motion proves, each condition of a triple and of a motion that friction does not hinder, just met
 * and just exceeded. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/triple.c"
#include "../../solvers/proof/moving.c"
#include "leaf.h"

static leaf_scene o;

/* ------------------------------------------------------------------------------------------------------------- scales */

static int solve(int n, double G[LEAF_N][LEAF_N], double x[LEAF_N])
{
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int r = k; r < n; r++) if (fabs(G[r][k]) > fabs(G[best][k])) best = r;
        for (int c = 0; c < n; c++) { const double t = G[k][c]; G[k][c] = G[best][c]; G[best][c] = t; }
        const double t = x[k]; x[k] = x[best]; x[best] = t;
        if (!(fabs(G[k][k]) > 1e-9)) return 0;
        for (int r = 0; r < n; r++) {
            const double by = r == k ? 0 : G[r][k] / G[k][k];
            for (int c = k; c < n && r != k; c++) G[r][c] -= by * G[k][c];
            if (r != k) x[r] -= by * x[k];
        }
    }
    for (int k = 0; k < n; k++) x[k] /= G[k][k];
    return 1;
}

/* The bilateral force of least norm, f0 = Aeq' x, (Aeq Aeq') x = -p over the free rows. */
static int bilateral(double f0[3 * LEAF_POINTS])
{
    double G[LEAF_N][LEAF_N], x[LEAF_N];
    for (int i = 0; i < LEAF_N; i++) {
        x[i] = leaf_held(i) ? 0 : -o.p[i];
        for (int k = 0; k < LEAF_N; k++) {
            G[i][k] = i == k && leaf_held(i);
            for (int q = 0; q < 3 * LEAF_POINTS && !leaf_held(i) && !leaf_held(k); q++) G[i][k] += o.A[i][q] * o.A[k][q];
        }
    }
    if (!solve(LEAF_N, G, x)) return 0;
    for (int q = 0; q < 3 * LEAF_POINTS; q++) {
        f0[q] = 0;
        for (int i = 0; i < LEAF_N; i++) f0[q] += o.A[i][q] * x[i];
    }
    return 1;
}

/* Sums over a block's corners of |f_v| and |(r_v - c) x f_v|. */
static void sums_of(const double *f, int i, double *force, double *moment)
{
    *force = *moment = 0;
    for (int v = 0; v < LEAF_POINTS; v++) {
        double F[3] = { 0, 0, 0 }, m[3] = { 0, 0, 0 };
        for (int k = 0; k < 3; k++)
            for (int q = 0; q < 3; q++) {
                F[k] += o.A[6 * i + k][3 * v + q] * f[3 * v + q];
                m[k] += o.A[6 * i + 3 + k][3 * v + q] * f[3 * v + q];
            }
        *force += leaf_norm(F);
        *moment += leaf_norm(m);
    }
}

static int corners_of(int i)
{
    int n = 0;
    for (int v = 0; v < LEAF_POINTS; v++) {
        const sp_contact *t = &o.pb.contact[o.contact[v]];
        n += t->a == i || t->b == i;
    }
    return n;
}

static double squared_arms(int i)
{
    double sum = 0;
    for (int v = 0; v < LEAF_POINTS; v++) {
        const sp_contact *t = &o.pb.contact[o.contact[v]];
        sp_real r[3];
        if (t->a != i && t->b != i) continue;
        sp__arm(&o.pb, i, o.at[v], r);
        sum += (double)sp__dot3(r, r);
    }
    return sum;
}

TEST(scales_are_those_of_the_least_bilateral_force)
{
    for (int k = 0; k < 10; k++) {
        const sp_arena mark = test_arena;
        double f0[3 * LEAF_POINTS], total = 0;
        NEED(leaf_make(&o, 0, 0));
        NEED(bilateral(f0));
        for (int i = 0; i < LEAF_BLOCKS; i++) {
            const sp__scale *s = &o.j.scale[i];
            double force, moment;
            sums_of(f0, i, &force, &moment);
            const double load = leaf_norm(o.p + 6 * i), couple = leaf_norm(o.p + 6 * i + 3), arm = leaf_arm(&o, i);
            total += load;
            CHECK_NEAR(s->load, load, TOL(1e-12, 1e-5));
            CHECK_NEAR(s->couple, couple, TOL(1e-12, 1e-5));
            CHECK_NEAR(s->arm, arm, TOL(1e-12, 1e-5));
            CHECK_NEAR(s->wf, 1 / sqrt(corners_of(i)), TOL(1e-12, 1e-5));
            CHECK_NEAR(s->wm, 1 / sqrt(squared_arms(i) * 2 / 3), TOL(1e-12, 1e-5));
            CHECK_NEAR(s->sum_f0, force, TOL(1e-6, 1e-2));
            CHECK_NEAR(s->sum_m0, moment, TOL(1e-6, 1e-2));
            CHECK_NEAR(s->s, load + force, TOL(1e-6, 1e-2));
            CHECK_NEAR(s->force_cap, load + force, TOL(1e-6, 1e-2));
            CHECK_NEAR(s->S, couple + moment + 16 * (double)SP_EPSILON * (load + force) * arm / 0.01, TOL(1e-6, 1e-2));
            CHECK(s->known >= 1);
        }
        CHECK_NEAR(o.j.total, total, TOL(1e-12, 1e-5));
        test_arena = mark;
    }
}

/* The hint of a search, read back from f0 itself, is taken where it balances: no step is made. */
TEST(a_hint_that_balances_is_taken_and_another_is_not)
{
    double G[LEAF_N][LEAF_N], x[LEAF_N];
    sp_real hint[2 * LEAF_N];
    NEED(leaf_make(&o, 0, 0));
    const int32_t own = o.j.sweeps;
    for (int i = 0; i < LEAF_N; i++) {
        x[i] = leaf_held(i) ? 0 : -o.p[i];
        for (int k = 0; k < LEAF_N; k++) {
            G[i][k] = i == k && leaf_held(i);
            for (int q = 0; q < 3 * LEAF_POINTS && !leaf_held(i) && !leaf_held(k); q++) G[i][k] += o.A[i][q] * o.A[k][q];
        }
    }
    NEED(solve(LEAF_N, G, x));
    for (int split = 0; split < 3; split++) {           /* all of it in either part, or half in each */
        for (int i = 0; i < LEAF_N; i++) {
            const double share = split == 0 ? 1 : split == 1 ? 0 : 0.5;
            hint[i] = R(x[i] * share * (double)o.j.unit);
            hint[LEAF_N + i] = R(x[i] * (1 - share) * (double)o.j.unit);
        }
        sp_arena a = test_arena;
        NEED(sp__certifier_open(&o.j, &o.pb, &o.set, hint, INT32_MAX, &a));
        CHECK_INT(o.j.sweeps, 1);
        if (split == 2) { CHECK(own > 3); continue; }
        hint[split ? LEAF_N : 0] += R(0.5 * (double)o.j.unit);
        NEED(sp__certifier_open(&o.j, &o.pb, &o.set, hint, INT32_MAX, &a));
        CHECK(o.j.sweeps > 3);
    }
}

/* Sweeps that are spent end the search for f0: scales are then the loads, caps a thousand times all of them; with none to spend
 * they are the loads alone. */
TEST(without_sweeps_scales_come_from_the_loads)
{
    NEED(leaf_make(&o, 0, 0));
    for (int32_t most = 0; most < 5; most += most ? 1 : 2) {            /* 2 or more, or none */
        sp_arena a = test_arena;
        NEED(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, most, &a));
        CHECK(o.j.sweeps <= most);
        for (int i = 0; i < LEAF_BLOCKS; i++) {
            const sp__scale *s = &o.j.scale[i];
            const double load = leaf_norm(o.p + 6 * i), twice = most ? 2 * load : load;
            const double couple = leaf_norm(o.p + 6 * i + 3), arm = leaf_arm(&o, i);
            CHECK_NEAR(s->s, twice, TOL(1e-12, 1e-5));
            CHECK_NEAR(s->S, couple + (most ? load * arm : 0) + 16 * (double)SP_EPSILON * twice * arm / 0.01, TOL(1e-12, 1e-5));
            CHECK_NEAR(s->force_cap, most ? 1000 * (double)o.j.total : load, TOL(1e-12, 1e-5));
            CHECK_INT(s->known > 0, !most);
        }
    }
}

/* A block that nothing touches is not balanced by any f0: twice its load is its scale; caps add what rounding may hide. */
TEST(what_nothing_touches_is_scaled_by_its_load)
{
    const sp_capacity cap = { 3, 0, 0, 0, 1, 4, 0 };
    const sp_real at[3][3] = { { 0, 0, -1 }, { 0, 0, R(0.5) }, { 9, 0, 0 } };
    const sp_real corner[12] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 };
    const sp_strength rough = sp_strength_friction(R(0.5));
    memset(&o, 0, sizeof o);
    NEED(sp_scene_create(&o.scene, &cap, &test_arena) == SP_OK);
    for (int b = 0; b < 3; b++) NEED(sp_scene_body(&o.scene, R(b * b), at[b], b ? 0 : SP_FIXED, NULL) == SP_OK);
    NEED(sp_scene_joint(&o.scene, 0, 1, 4, corner, &rough, NULL) == SP_OK);
    o.set.tol = R(0.01);
    o.set.force_bound = 100;
    NEED(sp_problem_build(&o.scene, &test_arena, &o.pb) == SP_OK);
    NEED(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, INT32_MAX, &test_arena));
    const sp__scale *s = o.j.scale;
    CHECK_NEAR(s[0].s, 0.5, TOL(1e-9, 1e-4));           /* a quarter of the other's load, twice */
    CHECK_NEAR(s[1].s, 2, TOL(1e-12, 1e-5));
    CHECK_NEAR(s[1].force_cap, 1 + 10000 * (double)SP_EPSILON * 1.25, TOL(1e-14, 1e-6));
    CHECK(s[0].known > 0 && !(s[1].known > 0));
    CHECK_NEAR(s[1].S, 0, 0);
}

/* Balanced: within 1e-3 of the load and 10000 u of the forces, moments within that and the longest arm. */
TEST(balance_of_a_scale_is_just_met_and_just_exceeded)
{
    const double u = (double)SP_EPSILON, load = 3, arm = 7;
    for (int heavy = 0; heavy < 2; heavy++) {
        const double f0 = heavy ? 1 / u : 0, enough = 1e-3 * load + 1e4 * u * f0;
        for (int k = 0; k < 6; k++)
            for (int above = 0; above < 2; above++) {
                sp_real r[6] = { 0, 0, 0, 0, 0, 0 };
                r[k] = R((k % 2 ? -1 : 1) * enough * (k < 3 ? 1 : arm) * (above ? 1.001 : 0.999));
                CHECK_INT(sp__scale_is_balanced(r, R(load), R(f0), R(arm)), !above);
            }
    }
}

/* No step can lower a residual whose image by G is what rounding makes of it, at the last look only. */
TEST(a_residual_is_least_if_its_image_is_within_rounding)
{
    NEED(leaf_make(&o, 0, 0));
    double sum = 0, gg = 0;
    sp_real r[LEAF_N];
    for (int i = 0; i < LEAF_BLOCKS; i++) {
        const sp__scale *s = &o.j.scale[i];
        const double f = (double)s->wf * (double)(s->load + s->sum_f0), m = (double)s->wm * (double)(s->couple + s->sum_m0);
        sum += f * f + m * m;
    }
    for (int i = 0; i < LEAF_N; i++) r[i] = leaf_held(i) ? 0 : test_random_real(-1, 1);
    sp__certifier_normal_product(&o.j, r, o.j.image);
    for (int i = 0; i < LEAF_N; i++) gg += (double)o.j.image[i] * (double)o.j.image[i];
    for (int above = 0; above < 2; above++)
        for (int last = 0; last < 2; last++) {
            const double u = (double)SP_EPSILON, t = sqrt(4096 * u * u * sum / gg) * (above ? 1.001 : 0.999);
            for (int i = 0; i < LEAF_N; i++) o.j.residual[i] = R(t * (double)r[i]);
            CHECK_INT(sp__certifier_is_optimal(&o.j, last), last && !above);
        }
}

/* G = W Aeq Aeq' W against the dense one. */
TEST(the_normal_product_is_w_a_a_w)
{
    NEED(leaf_make(&o, 0, 0));
    sp_real in[LEAF_N], out[LEAF_N];
    double f[3 * LEAF_POINTS];
    for (int i = 0; i < LEAF_N; i++) in[i] = leaf_held(i) ? 0 : test_random_real(-1, 1);
    const int32_t sweeps = o.j.sweeps;
    sp__certifier_normal_product(&o.j, in, out);
    CHECK_INT(o.j.sweeps, sweeps + 1);
    for (int q = 0; q < 3 * LEAF_POINTS; q++) {
        f[q] = 0;
        for (int i = 0; i < LEAF_N; i++)
            f[q] += o.A[i][q] * (double)in[i] * (double)(i % 6 < 3 ? o.j.scale[i / 6].wf : o.j.scale[i / 6].wm);
    }
    for (int i = 0; i < LEAF_N; i++) {
        double want = 0;
        for (int q = 0; q < 3 * LEAF_POINTS; q++) want += o.A[i][q] * f[q];
        want *= leaf_held(i) ? 0 : (double)(i % 6 < 3 ? o.j.scale[i / 6].wf : o.j.scale[i / 6].wm);
        CHECK_WITHIN(out[i], want, TOL(1e-12, 1e-4));
    }
}

/* ------------------------------------------------------------------------------------------------------------- forces */

/* The imbalance of forces in the cone, and those admitted. */
TEST(imbalance_is_the_largest_of_all_blocks)
{
    for (int k = 0; k < 60; k++) {
        const sp_arena mark = test_arena;
        double f0[3 * LEAF_POINTS], f[3 * LEAF_POINTS], want = 0;
        sp_real in[3 * LEAF_POINTS], out[3 * LEAF_POINTS];
        NEED(leaf_make(&o, 0, 0));
        NEED(bilateral(f0));
        const double large = k % 3 == 0 ? 0.1 : k % 3 == 1 ? 1 : 20;
        for (int v = 0; v < LEAF_POINTS; v++) {         /* inside their cones */
            const double fn = (double)test_random_real(0, large), turn = (double)test_random_real(0, 7);
            f[3 * v] = fn;
            f[3 * v + 1] = 0.9 * leaf_mu(&o, v) * fn * cos(turn);
            f[3 * v + 2] = 0.9 * leaf_mu(&o, v) * fn * sin(turn);
        }
        for (int q = 0; q < 3 * LEAF_POINTS; q++) in[q] = R(f[q] * (double)o.j.unit);
        for (int i = 0; i < LEAF_BLOCKS; i++) {
            double r[6], force, moment, force0, moment0;
            for (int q = 0; q < 6; q++) {
                r[q] = o.p[6 * i + q];
                for (int c = 0; c < 3 * LEAF_POINTS; c++) r[q] += o.A[6 * i + q][c] * f[c];
                if (leaf_held(6 * i + q)) r[q] = 0;
            }
            sums_of(f, i, &force, &moment);
            sums_of(f0, i, &force0, &moment0);
            const double load = leaf_norm(o.p + 6 * i), couple = leaf_norm(o.p + 6 * i + 3);
            const double s = load + fmin(force, force0);
            const double slack = 16 * (double)SP_EPSILON * (load + force0) * leaf_arm(&o, i) / 0.01;
            want = fmax(want, fmax(leaf_norm(r) / s, leaf_norm(r + 3) / (couple + fmin(moment, moment0) + slack)));
        }
        const int32_t sweeps = o.j.sweeps;
        CHECK_NEAR(sp__certify_forces(&o.j, in, out), want, TOL(1e-6, 1e-2));
        CHECK_INT(o.j.sweeps, sweeps + 1);
        for (int q = 0; q < 3 * LEAF_POINTS; q++) CHECK_WITHIN(out[q], in[q], TOL(1e-11, 1e-4) * (double)o.j.unit * large);
        test_arena = mark;
    }
}

/* Strength at a corner: fn between -T and N, |ft| within C + mu fn, all within the cap. */
TEST(an_admitted_force_keeps_to_strength_and_cap)
{
    NEED(leaf_make(&o, 4, 0));                          /* room for 4 faces */
    sp_joint *joint = &o.scene.joint[0];
    const sp_contact *t = &o.pb.contact[0];
    joint->area = 2;
    joint->strength.mu = R(0.5);
    for (int k = 0; k < 4; k++) {
        o.set.faces = k == 3 ? 4 : 0;
        sp__certifier_cone(&o.j, &o.pb, &o.set);
        const double unit = (double)o.j.unit, C = k == 0 ? 0 : 3, T = k == 2 ? 9 : 1, N = k == 0 ? 1e30 : 8;
        joint->strength.cohesion = R(C * unit);         /* area 2, two corners: stresses are forces at a corner */
        joint->strength.tension = R(T * unit);
        joint->strength.crushing = k == 0 ? 0 : R(N * unit);
        o.j.force_cap = R(9);
        const double most_T = fmin(T, C / 0.5);
        for (int q = 0; q < 300; q++) {
            const sp_real f[3] = { test_random_real(-12, 14), test_random_real(-9, 9), test_random_real(-9, 9) };
            sp_real g[3];
            sp__certifier_make_admissible(&o.j, t, f, g);
            const double fn = fmin(fmax((double)f[0], -most_T), N), room = fmax(0, C + 0.5 * fn);
            const double along = k == 3 ? fmax(fabs((double)f[1]), fabs((double)f[2])) : hypot((double)f[1], (double)f[2]);
            const double share = along > room ? room / along : 1;
            double want[3] = { fn, (double)f[1] * share, (double)f[2] * share };
            const double size = leaf_norm(want), less = size > 9 ? 9 / size : 1;
            for (int i = 0; i < 3; i++) CHECK_WITHIN(g[i], want[i] * less, TOL(1e-11, 1e-4));
        }
    }
}

/* ------------------------------------------------------------------------------------------------------------- motions */

/* |P_K(u)| of the true cone. */
static double resistance(double mu, const double u[3])
{
    const double z = hypot(u[1], u[2]), all = leaf_norm(u);
    if (z <= mu * u[0]) return all;
    if (mu * z <= -u[0]) return 0;
    return (u[0] + mu * z) / sqrt(1 + mu * mu);
}

/* What a motion proves, from its definition: of no size of its own, blocks within `rest` of the farthest held. */
static double proves(const double *motion, double rest, int *final, double *resist)
{
    double m[LEAF_N], size[LEAF_BLOCKS], largest = 0, work = 0, scale = 0;
    for (int i = 0; i < LEAF_N; i++) m[i] = leaf_held(i) ? 0 : motion[i];
    for (int i = 0; i < LEAF_BLOCKS; i++) {
        size[i] = leaf_norm(m + 6 * i) + leaf_norm(m + 6 * i + 3) * leaf_arm(&o, i);
        largest = fmax(largest, size[i]);
    }
    for (int i = 0; i < LEAF_N; i++) m[i] = size[i / 6] / largest <= rest ? 0 : m[i] / largest;
    *final = 1;
    *resist = 0;
    for (int i = 0; i < LEAF_BLOCKS; i++) {
        for (int q = 0; q < 6; q++) work += o.p[6 * i + q] * m[6 * i + q];
        scale += (double)o.j.scale[i].s * leaf_norm(m + 6 * i) + (double)o.j.scale[i].S * leaf_norm(m + 6 * i + 3);
    }
    for (int v = 0; v < LEAF_POINTS; v++) {
        double u[3] = { 0, 0, 0 }, cap[LEAF_BLOCKS];
        for (int k = 0; k < 3; k++) for (int i = 0; i < LEAF_N; i++) u[k] -= o.A[i][3 * v + k] * m[i];
        for (int i = 0; i < LEAF_BLOCKS; i++) cap[i] = (double)o.set.force_bound * (double)o.j.scale[i].force_cap;
        const double P = resistance(leaf_mu(&o, v), u);
        *resist += leaf_lesser(&o, v, cap) * P;
        if (P > 1e-3) *final = 0;
    }
    return work > *resist ? (work - *resist) / scale : 0;
}

TEST(a_motion_proves_work_less_resistance)
{
    int some = 0;
    for (int k = 0; k < 200; k++) {
        const sp_arena mark = test_arena;
        double motion[LEAF_N], resist;
        sp_real dq[LEAF_N];
        int32_t final = -1;
        int want_final;
        NEED(leaf_make(&o, 0, 0));
        o.set.force_bound = R(k % 4 == 0 ? 1e-4 : k % 4 == 1 ? 1e-2 : 100);
        const double rest = k % 5 == 4 ? 0.3 : 0;
        for (int i = 0; i < LEAF_N; i++) motion[i] = (double)test_random_real(-1, 1) + (k % 4 < 2 ? 0.3 * o.p[i] : 0);
        for (int i = 0; i < LEAF_N; i++) dq[i] = R(1e3 * motion[i]);
        const double want = proves(motion, rest, &want_final, &resist);
        CHECK_NEAR(sp__certify_motion(&o.j, dq, R(rest), 0, &final), want, TOL(1e-9, 1e-2));
        CHECK_NEAR(o.j.resist, resist, TOL(1e-9, 1e-3));
        CHECK_INT(final, want_final);
        some += want > 0;
        test_arena = mark;
    }
    CHECK(some > 20);
}

/* Whatever its size: the farthest a block moves is the farthest that one reaches; nothing stays nothing. */
TEST(a_motion_is_written_as_large_as_the_largest_block)
{
    NEED(leaf_make(&o, 0, 0));
    for (int round = 0; round < 6; round++) {
        sp_real dq[6 * (LEAF_BLOCKS + 1)], reach = 0, far = 0;
        const double times = round == 0 ? 0 : round % 2 ? 100 : 0.01;
        for (int i = 0; i < LEAF_N; i++) o.j.dual.motion[i] = R(times) * test_random_real(-1, 1);
        for (int i = 0; i < LEAF_BLOCKS; i++) o.j.scale[i].arm = test_random_real(0.1, 9);
        memset(dq, 0, sizeof dq);
        sp__motion_write(&o.j, dq);
        for (int i = 0; i < LEAF_BLOCKS; i++) {
            const sp_real *m = dq + 6 * o.pb.block[i];
            reach = sp__max(reach, o.j.scale[i].arm);
            far = sp__max(far, sp__max(sp__norm3(m), sp__norm3(m + 3) * sp__certifier_arm(&o.j, i)));
        }
        CHECK_WITHIN((double)far, round ? (double)reach : 0, TOL(1e-12, 1e-5));
    }
}

/* A block is held if no joint of it moves farther than `rest` of the farthest; what does not move, or is no number, proves
 * nothing. */
TEST(what_moves_less_than_its_share_is_held)
{
    NEED(leaf_make(&o, 0, 0));
    for (int k = 0; k < 2; k++) {
        sp_real dq[LEAF_N];
        memset(dq, 0, sizeof dq);
        dq[0] = 4;
        dq[6 + 4] = R((k ? 1.001 : 0.999) * 4 * 0.25 / leaf_arm(&o, 1));
        dq[12 + 1] = 1e6f;                              /* held anyway */
        dq[12] = 4;
        CHECK_INT(sp__certifier_hold_small(&o.j, dq, R(0.25)), k ? 0 : 1);
        CHECK_NEAR(o.j.dual.motion[0], 1, TOL(1e-12, 1e-6));
        CHECK_WITHIN(o.j.dual.motion[6 + 4], k ? 0.25 * 1.001 / leaf_arm(&o, 1) : 0, TOL(1e-12, 1e-6));
        CHECK_WITHIN(o.j.dual.motion[12 + 1], 0, 0);
    }
    sp_real still[LEAF_N], odd[LEAF_N];
    memset(still, 0, sizeof still);
    memset(odd, 0, sizeof odd);
    CHECK_INT(sp__certifier_hold_small(&o.j, still, 0), -1);
    int32_t final = 7;
    CHECK_WITHIN(sp__certify_motion(&o.j, still, 0, 0, &final), 0, 0);
    CHECK_INT(final, 0);
    CHECK_WITHIN(o.j.resist, 0, 0);
    odd[3] = R(INFINITY);
    CHECK_INT(sp__certifier_hold_small(&o.j, odd, 0), -1);
}

/* 3 and 2 by more than tol, 1 by more than rounding of 4096 + b units where nothing resists. */
TEST(ranks_of_a_proof_are_just_met_and_just_exceeded)
{
    NEED(leaf_make(&o, 0, 0));
    const double u = (double)SP_EPSILON * (4096 + LEAF_BLOCKS);
    for (int above = 0; above < 2; above++)
        for (int final = 0; final < 2; final++) {
            const double by = above ? 1.0001 : 0.9999;
            CHECK_INT(sp__certify_rank(&o.j, R(0.01 * by), final), above ? 2 + final : final);
            CHECK_INT(sp__certify_rank(&o.j, R(u * by), final), above && final);
        }
}

/* ------------------------------------------------------------------------------------------------------------- triples */

static sp__lengths lengths(void) { const sp__lengths k = { R(0.5), 1, 20 }; return k; }

/* One corner's conditions, each just met and just exceeded. */
TEST(each_condition_of_a_triple_is_just_met_and_just_exceeded)
{
    const sp__lengths k = lengths();
    const double give = (double)SP__GIVE, slip = (double)SP__SLIP;
    const sp_real none[3] = { 0, 0, 0 }, press[3] = { 1, 0, 0 }, rub[3] = { 1, R(0.3), R(-0.4) };
    for (int above = 0; above < 2; above++) {
        const double by = above ? 1.01 : 0.99;
#define WORST(f, alpha, moved, ...) \
    (double)sp__coupled_vertex(&k, box, f, R(alpha), (const sp_real[]){ __VA_ARGS__ }, R(moved), R(0.1))
        for (int box = 0; box < 2; box++) {
            const double far = 20 + give * by;          /* eta */
            if (TOL(1, 0)) {
                CHECK_INT(WORST(none, 0, 0, R(far), 0, 0) <= 1, !above);
                CHECK_INT(WORST(none, 0, 0, 0, R(far), 0) <= 1, !above);
                CHECK_INT(WORST(none, 0, 0, 0, 0, R(-far)) <= 1, !above);
                CHECK_INT(WORST(none, 0, 0, -1 + 0.5f, R(15), R(-15)) <= 1, box);       /* slip 21, components 15 */
                CHECK_NEAR(WORST(none, 0, 0, R(-1 - give * by), 0, 0), by, 1e-4);
                CHECK_NEAR(WORST(press, 0, 0, R(-1 + give * by), 0, 0), by, 1e-4);
                CHECK_NEAR(WORST(press, 0, 0, R(-1 - give * by), 0, 0), by, 1e-4);
                /* rounding hides 16 u of what moves, 1e-6 at the most */
                const double moved = 1e9, hidden = 16 * (double)SP_EPSILON * moved, most = 1e-6;
                CHECK(hidden > most);
                CHECK_NEAR(WORST(press, 0, moved, R(-1 + (give + most) * by), 0, 0), by, 1e-4);
                CHECK_NEAR(WORST(press, 0, 1e7, R(-1 + (give + hidden / 100) * by), 0, 0), by, 1e-4);
            }
            CHECK_WITHIN(WORST(none, 0, 0, 3, 0, 0), 0, 0);     /* open and without a force */
            CHECK(WORST(press, 0, 0, R(-0.5), 0, 0) > 1);
            CHECK_WITHIN(WORST(none, 0, 0, -1, 3, 4), 0, 0);
            /* friction: opposite to slip within SP__SLIP of |ft| = 1/2, alpha dt = -ft */
            const double d1 = -0.3, d2 = 0.4;
            CHECK_WITHIN(WORST(rub, 1, 0, -1, R(d1), R(d2)), slip / 0.5, TOL(1e-9, 1e-4));
            CHECK_NEAR(WORST(rub, 1, 0, -1, R(d1 + slip * 0.5 * by * 0.6), R(d2 - slip * 0.5 * by * 0.8)), by, TOL(1e-3, 2e-1));
            CHECK_NEAR(WORST(rub, 1, 0, -1, R(d1 + slip * 0.5 * by * 0.8), R(d2 + slip * 0.5 * by * 0.6)), by, TOL(1e-3, 2e-1));
            CHECK(WORST(rub, 1, 0, -1, R(-d1), R(-d2)) > 1);
            CHECK(WORST(rub, 0, 0, -1, R(d1), R(d2)) > 1);
            CHECK(WORST(rub, -1, 0, -1, R(d1), R(d2)) >= SP__HUGE);
            CHECK(WORST(none, NAN, 0, -1, 0, 0) >= SP__HUGE);
            /* slip of at least SP__SLIP, and what rounding makes of it */
            const double least = slip / by, noisy = (slip + (double)SP__SLIP_ROUNDING * 3) / by;
            CHECK_NEAR(WORST(rub, 0.5 / least, 0, -1, R(d1 * 2 * least), R(d2 * 2 * least)), by, TOL(1e-6, 1e-2));
            CHECK_NEAR(WORST(rub, 0.5 / noisy, 3, -1, R(d1 * 2 * noisy), R(d2 * 2 * noisy)), by, TOL(1e-6, 1e-2));
            /* friction of 0.1 and less is asked for nothing */
            const sp_real little[3] = { 1, R(0.0999), 0 }, more[3] = { 1, 0, R(0.1001) };
            CHECK_WITHIN(WORST(little, 0, 0, -1, 0, 0), 0, 0);
            CHECK(WORST(more, 0, 0, -1, 0, 0) > 1);
            CHECK_WITHIN(sp__coupled_vertex(&k, box, none, 0, none, 0, 0), 0, 0);   /* none, where any is asked */
            CHECK(WORST(rub, 1, 0, NAN, 0, 0) > 1);
        }
#undef WORST
    }
}

/* In units of L: a gap, of pressure and at eta, by 1e-10, and rounding hides 16 u of what moves, 1e-6 at the most; friction is
 * opposite to slip by 1e-6 of it, of slip of at least 1e-6, and 4e6 u of what moves. In float 1e-4, 1e-2, 1e-2, and 400 u. */
TEST(what_a_triple_may_be_out_by_is_met_and_exceeded_in_numbers)
{
    const sp__lengths k = { 1, 0, 2 };
    const double u = (double)SP_EPSILON, give = TOL(1e-10, 1e-4), most = TOL(1e-6, 1e-2), slip = TOL(1e-6, 1e-2);
    const double hides = 16 * u, blurs = TOL(4e6, 400) * u;
    const sp_real none[3] = { 0, 0, 0 }, press[3] = { 1, 0, 0 }, rub[3] = { 1, R(0.3), R(-0.4) };
    for (int q = 0; q < 4; q++) {
        const double by = q % 2 ? 1.02 : 0.98, sign = q / 2 ? -1 : 1;
#define WITHIN(f, alpha, moved, ...) \
    (sp__coupled_vertex(&k, 0, f, R(alpha), (const sp_real[]){ __VA_ARGS__ }, R(moved), R(0.1)) <= 1)
        CHECK_INT(WITHIN(press, 0, 0, R(sign * give * by), 0, 0), q % 2 == 0);
        CHECK_INT(WITHIN(none, 0, 0, R(2 + give * by), 0, 0), q % 2 == 0);
        CHECK_INT(WITHIN(press, 0, 10 * give / hides, R(sign * 11 * give * by), 0, 0), q % 2 == 0);
        CHECK_INT(WITHIN(press, 0, 10 * most / hides, R(sign * (give + most) * by), 0, 0), q % 2 == 0);
        for (int moves = 0; moves < 2; moves++) {       /* |ft| = 1/2; slip so long that it is just enough, or enough and turned */
            const double moved = moves ? 10 * slip / blurs : 0, least = (slip + blurs * moved) / by, far = 100 * slip;
            CHECK_INT(WITHIN(rub, 0.5 / least, moved, 0, R(-0.6 * least), R(0.8 * least)), q % 2 == 0);
            CHECK_INT(WITHIN(rub, 0.5 / far, moved, 0, R(far * (-0.6 + 0.8 * sign * slip * by)),
                             R(far * (0.8 + 0.6 * sign * slip * by))), q % 2 == 0);
        }
#undef WITHIN
    }
}

/* At rest, without play: friction needs slip from tol sbar on, that of the block which carries less. */
TEST(friction_at_rest_is_up_to_tol_of_the_lesser_block)
{
    NEED(leaf_make(&o, 0, 0));
    const sp__lengths k = { 1, 0, 1 };
    sp_real rest[LEAF_N], none[LEAF_POINTS];
    double s[LEAF_BLOCKS];
    memset(rest, 0, sizeof rest);
    memset(none, 0, sizeof none);
    for (int i = 0; i < LEAF_BLOCKS; i++) s[i] = (double)o.j.scale[i].s;
    for (int v = 0; v < LEAF_POINTS; v++)
        for (int more = 0; more < 2; more++) {
            sp_real f[3 * LEAF_POINTS];
            memset(f, 0, sizeof f);
            const double ft = (more ? 1.01 : 0.99) * 0.01 * leaf_lesser(&o, v, s);
            f[3 * v] = R(2 * ft / leaf_mu(&o, v)) * o.j.unit;
            f[3 * v + 1] = R(ft) * o.j.unit;
            CHECK_INT(sp__certify_coupled(&o.j, &k, f, rest, none) > 1, more);
        }
}

/* A whole triple is as bad as its worst corner: here one corner at a time is out. */
TEST(a_triple_is_as_bad_as_its_worst_corner)
{
    NEED(leaf_make(&o, 0, 0));
    const sp__lengths k = lengths();
    for (int round = 0; round < 40; round++) {
        double dq[LEAF_N], worst = 0;
        sp_real f[3 * LEAF_POINTS], motion[LEAF_N], alpha[LEAF_POINTS], d[3], g[3];
        for (int i = 0; i < LEAF_N; i++) {
            dq[i] = leaf_held(i) ? 0 : (double)test_random_real(-1, 1);
            motion[i] = R(leaf_held(i) ? 5 : dq[i] * (double)k.L);
        }
        o.set.coupled.box = round % 2;
        for (int v = 0; v < LEAF_POINTS; v++) {
            const sp_contact *t = &o.pb.contact[o.contact[v]];
            double moved = 0, s[LEAF_BLOCKS], u[3] = { 0, 0, 0 };
            for (int i = 0; i < LEAF_BLOCKS; i++) {
                s[i] = (double)o.j.scale[i].s;
                if (t->a == i || t->b == i) moved += leaf_norm(dq + 6 * i) + leaf_norm(dq + 6 * i + 3) * leaf_arm(&o, i);
            }
            for (int c = 0; c < 3; c++) for (int i = 0; i < LEAF_N; i++) u[c] += o.A[i][3 * v + c] * dq[i];
            const double slip = hypot(u[1], u[2]), fn = v == round % LEAF_POINTS ? 1 : 0, ft = leaf_mu(&o, v) * fn;
            const sp_real in[3] = { R(fn), R(-ft * u[1] / slip * 1.5), R(-ft * u[2] / slip * 1.5) };    /* beyond the cone */
            for (int c = 0; c < 3; c++) { f[3 * v + c] = in[c] * o.j.unit; d[c] = R(u[c]); }
            g[0] = in[0]; g[1] = in[1] / R(1.5); g[2] = in[2] / R(1.5);
            const double a = ft / slip * (1 + 0.2 * (double)SP__SLIP);
            alpha[v] = R(a * (double)o.j.unit / (double)k.L);
            const sp_real least = R(0.01 * leaf_lesser(&o, v, s));
            worst = fmax(worst, (double)sp__coupled_vertex(&k, round % 2, g, R(a), d, R(moved), least));
        }
        const int32_t sweeps = o.j.sweeps;
        CHECK_NEAR(sp__certify_coupled(&o.j, &k, f, motion, alpha), worst, TOL(1e-5, 1e-1));
        CHECK_INT(o.j.sweeps, sweeps + 1);
    }
}

/* Lengths: eps by a ten thousandth of the mean edge, eta a hundred times that; without eps eta alone. */
TEST(lengths_follow_the_edges_or_the_arms)
{
    NEED(leaf_make(&o, 0, 0));
    double edges = 0;
    int count = 0;
    for (int32_t c = 0; c < o.pb.contacts; c++) {
        const sp_contact *t = &o.pb.contact[c];
        if (t->points == 2) {
            double e[3];
            for (int k = 0; k < 3; k++) e[k] = (double)o.pb.point[t->point + 1][k] - (double)o.pb.point[t->point][k];
            edges += leaf_norm(e);
            count++;
        }
    }
    const double edge = edges / count;
    static const struct { double eps, eta; } table[] = { { -1, 0 }, { 0, 0 }, { 0.03, 0 }, { 0, 0.7 }, { 0.03, 0.6 }, { -1, 0.5 } };
    for (int k = 0; k < 6; k++) {
        o.set.coupled.eps = R(table[k].eps);
        o.set.coupled.eta = R(table[k].eta);
        const sp__lengths got = sp__coupled_lengths(&o.pb, &o.set);
        const double eps = table[k].eps < 0 ? 1e-4 * edge : table[k].eps;
        const double eta = table[k].eta > 0 ? table[k].eta : eps > 0 ? 100 * eps : 1e-2 * edge;
        CHECK_NEAR(got.L, eps > 0 ? eps : eta, TOL(1e-12, 1e-5));
        CHECK_NEAR(got.eps, eps > 0 ? 1 : 0, 0);
        CHECK_NEAR(got.eta, eps > 0 ? eta / eps : 1, TOL(1e-12, 1e-5));
    }
    const int32_t contacts = o.pb.contacts;
    o.pb.contact += contacts - 1;                       /* the last touches at one point */
    o.pb.contacts = 1;
    const sp_contact *t = o.pb.contact;
    CHECK_NEAR(sp__mean_edge(&o.pb), ((double)sp__norm3(t->ra) + (double)sp__norm3(t->rb)) / 2, TOL(1e-12, 1e-5));
    o.pb.contacts = 0;
    CHECK_NEAR(sp__mean_edge(&o.pb), 1, 0);
}

/* ------------------------------------------------------------------------------------------- motions friction does not hinder */

#if SP__WITH_STRONG
/* Both laws of a corner. */
static sp_real law(const sp_real f[3], const sp_real d[3], sp_real mu, sp_real s, sp_real moved)
{
    return sp__max(sp__moving_gap(f, d, s, moved), sp__moving_rub(f, d, mu, s, moved));
}

/* Gap, pressure on what opens, friction that is not against the slip; s = 2, moved = 4. */
TEST(each_law_of_contact_is_measured_by_forces_and_accelerations)
{
#define CORNER(f0, f1, f2, d0, d1, d2) (double)law((const sp_real[]){ R(f0), R(f1), R(f2) }, \
                                               (const sp_real[]){ R(d0), R(d1), R(d2) }, R(0.5), 2, 4)
    const double tol = TOL(1e-12, 1e-5);
    CHECK_WITHIN(CORNER(0, 0, 0, 1, 3, -2), 0, 0);              /* open: it may go anywhere */
    CHECK_NEAR(CORNER(0, 0, 0, -1, 0, 0), 0.25, tol);           /* closes by a quarter of what moves */
    CHECK_WITHIN(CORNER(1, 0.3, 0.4, 0, 0, 0), 0, 0);           /* sticks */
    CHECK_NEAR(CORNER(1, 0, 0, 1, 0, 0), 0.25, tol);            /* pressure 1/2, opens by 1/4 */
    CHECK_NEAR(CORNER(0.1, 0, 0, 1, 0, 0), 0.05, tol);
    CHECK_NEAR(CORNER(1, -0.3, -0.4, 0, 3, 4), 0, tol);         /* slides, friction full and opposite */
    CHECK_NEAR(CORNER(1, 0.3, 0.4, 0, 3, 4), 5.0 / 8, tol);
    CHECK_NEAR(CORNER(1, 0, 0, 0, 3, 4), 2.5 / 8, tol);
    CHECK_NEAR(CORNER(1, -0.4, 0.3, 0, 3, 4), hypot(-0.4 * 5 + 1.5, 0.3 * 5 + 2) / 8, tol);
#undef CORNER
}

typedef struct moving_case {
    sp__inertia M[LEAF_BLOCKS];
    double f[3 * LEAF_POINTS], a[LEAF_N];           /* in units of the judge; accelerations */
    sp_real in[3 * LEAF_POINTS], acc[LEAF_N];       /* the same, as they are handed on */
    double only[LEAF_BLOCKS], s[LEAF_BLOCKS];       /* forces on a block without and with its load */
} moving_case;

static void draw_bodies(moving_case *x)
{
    memset(x->M, 0, sizeof x->M);
    for (int i = 0; i < LEAF_BLOCKS; i++) {
        x->M[i].mass = test_random_real(1, 2) * o.j.unit;
        for (int q = 0; q < 3; q++)
            for (int c = 0; c <= q; c++) x->M[i].J[q][c] = x->M[i].J[c][q] = test_random_real(0, 1) * o.j.unit;
    }
}

static void draw_motion(moving_case *x, int round)
{
    const double faster = round % 3 ? 1 : 1e3, few = round % 4 == 3;
    for (int v = 0; v < LEAF_POINTS; v++) {
        const double fn = few && v != round % LEAF_POINTS ? 0 : (double)test_random_real(0, 5);
        const double turn = (double)test_random_real(0, 7);
        x->f[3 * v] = fn;
        x->f[3 * v + 1] = 0.9 * leaf_mu(&o, v) * fn * cos(turn);
        x->f[3 * v + 2] = 0.9 * leaf_mu(&o, v) * fn * sin(turn);
    }
    for (int q = 0; q < 3 * LEAF_POINTS; q++) x->in[q] = R(x->f[q] * (double)o.j.unit);
    for (int i = 0; i < LEAF_N; i++) {
        x->a[i] = leaf_held(i) || round % 5 == 4 ? 0 : faster * (double)test_random_real(-1, 1);
        if (round % 6 == 5 && i / 6 == round / 6 % 3) x->a[i] = 0;
        x->acc[i] = R(x->a[i]);
    }
}

/* Row i of p + A f - M a. */
static double unbalanced(const moving_case *x, int i)
{
    const sp__inertia *m = &x->M[i / 6];
    double r = o.p[i], ma = 0;
    for (int c = 0; c < 3 * LEAF_POINTS; c++) r += o.A[i][c] * x->f[c];
    if (i % 6 < 3) ma = (double)m->mass * x->a[i];
    else for (int c = 0; c < 3; c++) ma += (double)m->J[i % 6 - 3][c] * x->a[i / 6 * 6 + 3 + c];
    return leaf_held(i) ? 0 : r - ma / (double)o.j.unit;
}

static double speed_of(const moving_case *x, int i)
{
    return leaf_norm(x->a + 6 * i) + leaf_norm(x->a + 6 * i + 3) * leaf_arm(&o, i);
}

/* The worst imbalance of a block, and how far it moves for its forces. */
static double of_blocks(moving_case *x, double *moves)
{
    double worst = 0, r[LEAF_N];
    *moves = 0;
    for (int i = 0; i < LEAF_N; i++) r[i] = unbalanced(x, i);
    for (int i = 0; i < LEAF_BLOCKS; i++) {
        double moment;
        sums_of(x->f, i, &x->only[i], &moment);
        x->s[i] = x->only[i] + leaf_norm(o.p + 6 * i);
        *moves = fmax(*moves, (double)x->M[i].mass / (double)o.j.unit * speed_of(x, i) / x->s[i]);
        worst = fmax(worst, fmax(leaf_norm(r + 6 * i) / x->s[i],
                                 leaf_norm(r + 6 * i + 3) / (x->s[i] * leaf_arm(&o, i) + leaf_norm(o.p + 6 * i + 3))));
    }
    return worst;
}

static double of_corner(const moving_case *x, int v)
{
    const sp_contact *t = &o.pb.contact[o.contact[v]];
    double moved = 0;
    sp_real d[3], g[3];
    for (int k = 0; k < 3; k++) {
        double u = 0;
        for (int i = 0; i < LEAF_N; i++) u += o.A[i][3 * v + k] * x->a[i];
        d[k] = R(u);
        g[k] = R(x->f[3 * v + k]);
    }
    for (int i = 0; i < LEAF_BLOCKS; i++) if (t->a == i || t->b == i) moved += speed_of(x, i);
    return (double)law(g, d, R(leaf_mu(&o, v)), R(leaf_lesser(&o, v, x->only)), R(moved));
}

/* (f, a) of random forces and accelerations: laws at all corners, M a = p + Aeq f of all blocks, against the definition. */
TEST(a_motion_is_measured_block_by_block)
{
    static moving_case x;
    for (int round = 0; round < 120; round++) {
        const sp_arena mark = test_arena;
        double moves;
        sp_real got_moves = -1;
        NEED(leaf_make(&o, 0, 0));
        draw_bodies(&x);
        draw_motion(&x, round);
        double worst = of_blocks(&x, &moves);
        CHECK(worst >= 0);
        for (int v = 0; v < LEAF_POINTS; v++) worst = fmax(worst, of_corner(&x, v));
        const int32_t sweeps = o.j.sweeps;
        CHECK_NEAR(sp__certify_moving(&o.j, x.M, x.in, x.acc, 0, &got_moves), worst, TOL(1e-9, 1e-2));
        CHECK_NEAR(got_moves, moves, TOL(1e-9, 1e-2));
        CHECK_INT(o.j.sweeps, sweeps + 2);
        x.acc[13] = R(round % 2 ? 1e-20 : -1e-20);     /* what is held does not move at all */
        CHECK(sp__certify_moving(&o.j, x.M, x.in, x.acc, 0, &got_moves) >= SP__HUGE);
        test_arena = mark;
    }
}

#endif

#if SP__WITH_STRONG || SP__WITH_SLIDING
/* Pressure keeps fn where it presses and nothing else. */
TEST(pressure_is_the_normal_part_that_presses)
{
    NEED(leaf_make(&o, 0, 0));
    sp_real f[3 * LEAF_POINTS], g[3 * LEAF_POINTS], h[3 * LEAF_POINTS];
    for (int q = 0; q < 3 * LEAF_POINTS; q++) {
        f[q] = test_random_real(-1, 1);
        h[q] = q % 3 == 0 && f[q] > 0 ? f[q] : 0;
    }
    const double got = (double)sp__certify_pressure(&o.j, f, g), want = (double)sp__certify_forces(&o.j, h, NULL);
    CHECK_NEAR(got, want, TOL(1e-12, 1e-5));
    for (int q = 0; q < 3 * LEAF_POINTS; q++) CHECK_WITHIN(g[q], h[q], TOL(1e-12, 1e-5));
}

#endif

TEST_LIST(corner)
    RUN_FULL(scales_are_those_of_the_least_bilateral_force)
    RUN_FULL(a_hint_that_balances_is_taken_and_another_is_not)
    RUN_FULL(without_sweeps_scales_come_from_the_loads)
    RUN_FULL(what_nothing_touches_is_scaled_by_its_load)
    RUN_FULL(balance_of_a_scale_is_just_met_and_just_exceeded)
    RUN_FULL(a_residual_is_least_if_its_image_is_within_rounding)
    RUN_FULL(the_normal_product_is_w_a_a_w)
    RUN_FULL(imbalance_is_the_largest_of_all_blocks)
    RUN_FULL(an_admitted_force_keeps_to_strength_and_cap)
    RUN_FULL(a_motion_proves_work_less_resistance)
    RUN_FULL(a_motion_is_written_as_large_as_the_largest_block)
    RUN_FULL(what_moves_less_than_its_share_is_held)
    RUN_FULL(ranks_of_a_proof_are_just_met_and_just_exceeded)
    RUN_FULL(each_condition_of_a_triple_is_just_met_and_just_exceeded)
    RUN_FULL(what_a_triple_may_be_out_by_is_met_and_exceeded_in_numbers)
    RUN_FULL(friction_at_rest_is_up_to_tol_of_the_lesser_block)
    RUN_FULL(a_triple_is_as_bad_as_its_worst_corner)
    RUN_FULL(lengths_follow_the_edges_or_the_arms)
#if SP__WITH_STRONG
    RUN_FULL(each_law_of_contact_is_measured_by_forces_and_accelerations)
    RUN_FULL(a_motion_is_measured_block_by_block)
#endif
#if SP__WITH_STRONG || SP__WITH_SLIDING
    RUN_FULL(pressure_is_the_normal_part_that_presses)
#endif
TEST_END
