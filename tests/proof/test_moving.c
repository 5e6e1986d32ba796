/* A motion that starts, or goes on, against the laws of contact: every violation against its formula, the largest told. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/sliding.c"

#include <math.h>

#if SP__WITH_STRONG && SP__WITH_SLIDING

enum { BLOCKS = 3, ROWS = 6 * BLOCKS, CORNERS = 9 };

/* Three free blocks on a ground and on each other, three corners a joint, unlike frictions; a check of it with 300 sweeps. */
typedef struct scene_at_work {
    sp_scene scene;
    sp_problem pb;
    sp_settings set;
    sp__certifier j;
    sp__inertia M[BLOCKS];
    sp_real f[3 * CORNERS], a[ROWS];
} scene_at_work;

static int make(scene_at_work *o, uint32_t held)
{
    const sp_capacity room = { BLOCKS + 1, 0, 0, 0, BLOCKS, CORNERS, 0 };
    const sp_real ground[3] = { 0, 0, 0 };
    memset(o, 0, sizeof *o);
    o->set.tol = R(TOL(1e-9, 1e-4f));
    o->set.force_bound = R(1e6);
    if (!CHECK_INT(sp_scene_create(&o->scene, &room, &test_arena), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&o->scene, 0, ground, SP_FIXED, NULL), SP_OK)) return 0;
    for (int b = 1; b <= BLOCKS; b++) {
        const sp_real at[3] = { test_random_real(-1, 1), test_random_real(-1, 1), R(b) };
        const sp_real n[3] = { test_random_real(-1, 1), test_random_real(-1, 1), 1 };
        const sp_strength rough = { test_random_real(0.3, 0.9), 0, 0, 0 };
        sp_real x[9];
        for (int k = 0; k < 9; k++) x[k] = k % 3 == 2 ? R(b - 0.5) : test_random_real(-1, 1);
        if (!CHECK_INT(sp_scene_body(&o->scene, test_random_real(1, 5), at, b == 2 ? held : 0, NULL), SP_OK)) return 0;
        if (!CHECK_INT(sp_scene_points(&o->scene, b - 1, b, n, 3, x, &rough, NULL), SP_OK)) return 0;
    }
    if (!CHECK_INT(sp_problem_build(&o->scene, &test_arena, &o->pb), SP_OK)) return 0;
    if (!CHECK(sp__certifier_open(&o->j, &o->pb, &o->set, NULL, 300, &test_arena))) return 0;
    for (int v = 0; v < CORNERS; v++) {                 /* within friction */
        const sp_real mu = o->scene.joint[v / 3].strength.mu;
        o->f[3 * v] = o->j.unit * test_random_real(0.1, 2);
        for (int k = 1; k < 3; k++) o->f[3 * v + k] = o->f[3 * v] * mu * test_random_real(-0.6, 0.6);
    }
    for (int k = 0; k < ROWS; k++) o->a[k] = test_random_real(-1, 1);
    return 1;
}

/* |a| + |alpha| times the longest arm of block i. */
static double size_of(const scene_at_work *o, int32_t i)
{
    if (i < 0) return 0;
    return (double)sp__norm3(o->a + 6 * i) + (double)(sp__norm3(o->a + 6 * i + 3) * o->j.scale[i].arm);
}

/* Both laws of a corner. */
static sp_real law(const sp_real f[3], const sp_real d[3], sp_real mu, sp_real s, sp_real moved)
{
    return sp__max(sp__moving_gap(f, d, s, moved), sp__moving_rub(f, d, mu, s, moved));
}

/* The violation of a corner by its formula, of numbers that are not 0 where they divide. */
static double corner(const double f[3], const double d[3], double mu, double s, double moved)
{
    const double slip = hypot(d[1], d[2]), rub = hypot(f[1] * slip + mu * f[0] * d[1], f[2] * slip + mu * f[0] * d[2]);
    return fmax(fmax(fmax(0, -d[0]) / moved, fmin(f[0] / s, fmax(0, d[0]) / moved)), rub / (s * moved));
}

TEST(a_corner_violates_by_its_gap_by_pressure_that_opens_or_by_friction_not_against_its_slip)
{
    for (int k = 0; k < 400; k++) {
        double f[3], d[3];
        sp_real g[3], e[3];
        for (int c = 0; c < 3; c++) {
            g[c] = k / 3 % 3 == 1 && c ? 0 : test_random_real(c ? -1 : 0.01, 1);    /* no friction; no slip; both */
            e[c] = k / 3 % 3 == 2 && c ? 0 : test_random_real(-1, 1) * R(pow(10, -(k % 3)));
            f[c] = (double)g[c];
            d[c] = (double)e[c];
        }
        const sp_real mu = test_random_real(0, 1), s = test_random_real(0.5, 9), moved = test_random_real(0.5, 9);
        const double want = corner(f, d, (double)mu, (double)s, (double)moved);
        CHECK_WITHIN(law(g, e, mu, s, moved), want, TOL(1e-14, 1e-6));
    }
    const sp_real along[3] = { 2, R(-0.8), R(-0.6) }, slip[3] = { 0, 8, 6 };
    CHECK_WITHIN(law(along, slip, R(0.5), 3, 9), 0, TOL(1e-15, 1e-6));     /* friction against the slip */
}

/* All corners: the largest violation, what the forces leave of the balance, and sums of forces; two sweeps. */
TEST(laws_of_contact_are_asked_of_every_corner)
{
    for (int trial = 0; trial < 60; trial++) {
        const sp_arena mark = test_arena;
        scene_at_work o;
        double worst = 0, row[ROWS], sums[2 * BLOCKS] = { 0 };
        NEED(make(&o, 0));
        for (int k = 0; k < ROWS; k++) row[k] = (double)(o.pb.p[k] / o.j.unit);
        for (int pass = 0; pass < 2; pass++)
            for (int v = 0; v < CORNERS; v++) {
                const sp_contact *t = &o.pb.contact[v / 3];
                sp_real g[3], F[3], d[3], arm[3], m[3];
                double gd[3], dd[3];
                for (int k = 0; k < 3; k++) gd[k] = (double)(g[k] = o.f[3 * v + k] / o.j.unit);
                sp__joint_force(t->joint, g, F);
                for (int side = 0; side < 2 && !pass; side++) {
                    const int32_t i = side ? t->a : t->b;
                    if (i < 0) continue;
                    sp__arm(&o.pb, i, v, arm);
                    sp__cross3(arm, F, m);
                    for (int k = 0; k < 3; k++) {
                        row[6 * i + k] += (side ? -1 : 1) * (double)F[k];
                        row[6 * i + 3 + k] += (side ? -1 : 1) * (double)m[k];
                    }
                    sums[2 * i] += (double)sp__norm3(F);
                    sums[2 * i + 1] += (double)sp__norm3(m);
                }
                if (!pass) continue;
                sp__vertex_velocity(&o.pb, NULL, t, v, o.a, d);
                sp__joint_frame(t->joint, d, d);
                for (int k = 0; k < 3; k++) dd[k] = (double)d[k];
                const double s = t->a < 0 ? sums[2 * t->b] : fmin(sums[2 * t->a], sums[2 * t->b]);
                worst = fmax(worst, corner(gd, dd, (double)t->joint->strength.mu, s, size_of(&o, t->a) + size_of(&o, t->b)));
            }
        o.j.sweeps = 5;
        CHECK_WITHIN(sp__moving_contacts(&o.j, o.f, o.a, 0), worst, TOL(1e-12, 1e-5));
        CHECK_INT(o.j.sweeps, 7);
        for (int k = 0; k < ROWS; k++) CHECK_WITHIN(o.j.residual[k], row[k], TOL(1e-12, 1e-4));
        for (int k = 0; k < 2 * BLOCKS; k++) CHECK_WITHIN(o.j.pass.sums[k], sums[k], TOL(1e-12, 1e-4));
        test_arena = mark;
    }
}

/* M a = p + Aeq f by block: |force| in its forces, |moment| in these times its arm and its couple; rows held are left out, and must
 * not move. *moves: the largest acceleration of a block in its forces / mass. */
TEST(what_a_block_of_some_mass_leaves_unbalanced_is_told)
{
    for (int trial = 0; trial < 80; trial++) {
        const sp_arena mark = test_arena;
        const int held = trial % 2, first = trial / 2 % 2;      /* x or y is held, and turning about z */
        scene_at_work o;
        sp_real moves = 7;
        NEED(make(&o, held ? 1u << first | 1u << 5 : 0));
        if (held) o.a[6 + first] = o.a[11] = 0;
        for (int i = 0; i < BLOCKS; i++) {              /* so heavy, or so stiff to turn, that the corners' violations are less */
            o.M[i].mass = o.j.unit * R(pow(10, (double)test_random_real(2, 4)) * (trial / 2 % 3 == 1 ? 1e-9 : 1));
            for (int k = 0; k < 9; k++)
                o.M[i].J[k / 3][k % 3] = o.j.unit * test_random_real(-1, 1) * R(trial / 2 % 3 == 2 ? 1e-6 : 300);
        }
        double worst = (double)sp__moving_contacts(&o.j, o.f, o.a, 0), most = 0;
        for (int i = 0; i < BLOCKS; i++) {
            const sp_real *x = o.a + 6 * i;
            const double s = (double)(o.j.pass.sums[2 * i] + o.j.scale[i].load);
            const double S = s * (double)o.j.scale[i].arm + (double)o.j.scale[i].couple;
            double r[6];
            for (int k = 0; k < 3; k++) {
                r[k] = (double)(o.j.residual[6 * i + k] - o.M[i].mass * x[k] / o.j.unit);
                r[3 + k] = (double)o.j.residual[6 * i + 3 + k];
                for (int q = 0; q < 3; q++) r[3 + k] -= (double)(o.M[i].J[k][q] * x[3 + q] / o.j.unit);
            }
            if (held && i == 1) r[first] = r[5] = 0;
            worst = fmax(worst, sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) / s);
            worst = fmax(worst, sqrt(r[3] * r[3] + r[4] * r[4] + r[5] * r[5]) / S);
            most = fmax(most, (double)(o.M[i].mass / o.j.unit) * size_of(&o, i) / s);
        }
        CHECK_NEAR(sp__certify_moving(&o.j, o.M, o.f, o.a, 0, &moves), worst, TOL(1e-10, 1e-3));
        CHECK_NEAR(moves, most, TOL(1e-10, 1e-3));
        for (int q = 0; q < 2 && held; q++)
            for (int sign = -1; sign < 2; sign += 2) {
                o.a[q ? 11 : 6 + first] = R(1e-3 * sign);
                CHECK_NEAR(sp__certify_moving(&o.j, o.M, o.f, o.a, 0, &moves), SP__HUGE, 0);
                o.a[q ? 11 : 6 + first] = 0;
            }
        test_arena = mark;
    }
}

/* Pressure is what presses of the forces, and nothing else of them. */
TEST(pressure_is_the_forces_without_friction_and_without_pull)
{
    scene_at_work o;
    sp_real pressure[3 * CORNERS], got[3 * CORNERS];
    NEED(make(&o, 0));
    o.f[3] = -o.f[3];
    for (int k = 0; k < 3 * CORNERS; k++) got[k] = k % 3 || k == 3 ? 0 : o.f[k];
    const sp_real want = sp__certify_forces(&o.j, got, NULL);
    CHECK(want > 0);
    CHECK_NEAR(sp__certify_pressure(&o.j, o.f, pressure), want, 0);
    for (int k = 0; k < 3 * CORNERS; k++) CHECK_WITHIN(pressure[k], got[k], TOL(1e-12, 1e-5) * (double)o.j.unit);
}

/* A slide: the larger of imbalance and violations; its share, work of the live loads in the most it could be. */
TEST(a_slide_is_told_by_its_violations_and_the_share_of_work_of_its_loads)
{
    for (int trial = 0; trial < 40; trial++) {
        const sp_arena mark = test_arena;
        const int held = trial % 2, first = trial / 2 % 2;      /* x or y is held, and turning about z */
        scene_at_work o;
        sp_real live[ROWS], share = 7;
        double work = 0, most = 0;
        NEED(make(&o, held ? 1u << first | 1u << 5 : 0));
        if (held) o.a[6 + first] = o.a[11] = 0;
        for (int k = 0; k < ROWS; k++) live[k] = test_random_real(-1, 1) * (k / 3 % 2 == trial / 2 % 2 ? 1 : R(0.1));
        for (int k = 0; k < ROWS; k++) work += (double)live[k] * (double)o.a[k];
        for (int k = 0; k < ROWS; k += 3) most += (double)(sp__norm3(live + k) * sp__norm3(o.a + k));
        const sp_real balance = sp__certify_forces(&o.j, o.f, NULL), laws = sp__moving_contacts(&o.j, o.f, o.a, 0);
        CHECK_NEAR(sp__certify_sliding(&o.j, live, o.f, o.a, &share), sp__max(balance, laws), 0);
        CHECK_WITHIN(share, work > 0 ? work / most : 0, TOL(1e-12, 1e-5));
        for (int k = 0; k < ROWS; k++) live[k] = -live[k];
        sp__certify_sliding(&o.j, live, o.f, o.a, &share);
        CHECK_WITHIN(share, work < 0 ? -work / most : 0, TOL(1e-12, 1e-5));
        for (int q = 0; q < 2 && held; q++)
            for (int sign = -1; sign < 2; sign += 2) {
                o.a[q ? 11 : 6 + first] = R(1e-3 * sign);
                CHECK_NEAR(sp__certify_sliding(&o.j, live, o.f, o.a, &share), SP__HUGE, 0);
                o.a[q ? 11 : 6 + first] = 0;
            }
        test_arena = mark;
    }
}

/* What is beyond the cone is shortened before it is judged, in the sums, too. */
TEST(a_force_beyond_its_cone_is_judged_by_what_is_within)
{
    for (int round = 0; round < 10; round++) {
        const sp_arena mark = test_arena;
        scene_at_work o;
        sp_real within[3 * CORNERS], g[3];
        NEED(make(&o, 0));
        for (int k = 0; k < 3 * CORNERS; k++) if (k % 3) o.f[k] *= 10;
        for (int32_t v = 0; v < CORNERS; v++) {
            o.j.force_cap = sp__certifier_force_cap(&o.j, &o.pb.contact[v / 3]);
            sp__to_units(o.j.unit, 3, o.f + 3 * v, g);
            sp__certifier_make_admissible(&o.j, &o.pb.contact[v / 3], g, g);
            sp__to_newtons(o.j.unit, 3, g, within + 3 * v);
        }
        const double want = (double)sp__moving_contacts(&o.j, within, o.a, 0);
        CHECK_NEAR(sp__moving_contacts(&o.j, o.f, o.a, 0), want, TOL(1e-12, 1e-5));
        test_arena = mark;
    }
}

/* Friction of contact c: -mu N w / |w|, w = sum fn d / N, shared by its corners as they share N. */
static void share(scene_at_work *o, int c)
{
    const sp_contact *t = &o->pb.contact[c];
    double w[3] = { 0, 0, 0 };
    sp_real d[3], g[3];
    o->j.force_cap = sp__certifier_force_cap(&o->j, t);
    for (int v = 3 * c; v < 3 * c + 3; v++) {
        sp__moving_read(&o->j, t, v, o->f, o->a, g, d);
        for (int k = 1; k < 3; k++) w[k] += (double)o->f[3 * v] * (double)d[k];
    }
    const double mu = (double)t->joint->strength.mu, size = hypot(w[1], w[2]);
    for (int v = 3 * c; v < 3 * c + 3; v++)
        for (int k = 1; k < 3; k++) o->f[3 * v + k] = R(-mu * (double)o->f[3 * v] * w[k] / size);
}

/* The block above joint t slides along it and spins on it, nothing else moves. */
static void slide(scene_at_work *o, const sp_contact *t)
{
    memset(o->a, 0, sizeof o->a);
    for (int k = 0; k < 3; k++) {
        o->a[6 * t->b + k] = t->joint->t1[k] + t->joint->t2[k];
        o->a[6 * t->b + 3 + k] = R(0.3) * t->joint->n[k];
    }
}

/* Friction shared by the corners of a plate does not make a slide: each corner's is asked to be against its own slip. */
TEST(a_joint_is_judged_by_a_cap_of_its_own)
{
    static scene_at_work o;
    if (!make(&o, 0)) return;
    sp__moving_sums(&o.j, o.f);
    for (int c = 0; c < BLOCKS; c++) {
        sp_real x[2];
        for (int k = 0; k < 2; k++) {
            o.j.force_cap = k ? 0 : SP__HUGE;           /* of some other joint */
            x[k] = sp__moving_joint(&o.j, &o.pb.contact[c], o.f, o.a, 0);
        }
        CHECK(x[0] > 0 && !(x[0] < x[1]) && !(x[0] > x[1]));
    }
}

TEST(a_slide_is_no_matter_of_plates)
{
    int worse = 0;
    for (int round = 0; round < 20; round++) {
        const sp_arena mark = test_arena;
        scene_at_work o;
        sp_real live[ROWS], share_of = 0;
        NEED(make(&o, 0));
        memset(live, 0, sizeof live);
        const sp_contact *t = &o.pb.contact[BLOCKS - 1];        /* under the top block */
        slide(&o, t);
        share(&o, BLOCKS - 1);
        sp__certify_forces(&o.j, o.f, NULL);
        for (int k = 0; k < ROWS; k++) o.pb.p[k] -= sp__in_newtons(o.j.unit, o.j.residual[k]);      /* they balance */
        const sp_real balance = sp__certify_forces(&o.j, o.f, NULL), laws = sp__moving_contacts(&o.j, o.f, o.a, 0);
        worse += laws > balance && sp__moving_contacts(&o.j, o.f, o.a, 1) < laws;
        CHECK_NEAR(sp__certify_sliding(&o.j, live, o.f, o.a, &share_of), sp__max(balance, laws), 0);
        test_arena = mark;
    }
    CHECK(worse > 3);
}

/* Corners that share F = -mu N w / |w|, w = sum fn d / N, as they share N violate nothing. */
TEST(friction_that_is_one_force_at_the_centre_of_pressure_meets_the_laws)
{
    for (int round = 0; round < 20; round++) {
        const sp_arena mark = test_arena;
        const double scale = round % 2 ? 1 : 0.01;
        scene_at_work o;
        NEED(make(&o, 0));
        for (int c = 0; c < BLOCKS; c++) {
            const sp_contact *t = &o.pb.contact[c];
            for (int v = 3 * c; v < 3 * c + 3; v++) o.f[3 * v] *= R(scale);
            share(&o, c);
            CHECK(sp__moving_gathered(&o.j, t, o.f, o.a, R(scale), 1) < TOL(1e-12, 1e-4));
        }
        test_arena = mark;
    }
}

/* Of n corners F = sum f, w = sum fn d / N: the larger of friction of F that is not against w, and of what corners do not share as N. */
static double as_one_force(sp_real g[3][3], sp_real d[3][3], int n, double mu, double s, double moved)
{
    double F[3] = { 0, 0, 0 }, w[3] = { 0, 0, 0 }, uneven = 0;
    for (int v = 0; v < n; v++)
        for (int k = 0; k < 3; k++) { F[k] += (double)g[v][k]; w[k] += (double)g[v][0] * (double)d[v][k]; }
    for (int v = 0; v < n; v++) {
        const double fn = (double)g[v][0];
        uneven += hypot((double)g[v][1] - fn * F[1] / F[0], (double)g[v][2] - fn * F[2] / F[0]);
    }
    const double slip = hypot(w[1], w[2]) / F[0], rub = hypot(F[1] * slip + mu * w[1], F[2] * slip + mu * w[2]);
    return fmax(rub / (s * moved), uneven / s);
}

/* By its formula, of three corners and of an edge's two; where plates are meant it counts if it is less; without pressure there
 * is none. */
TEST(friction_of_plates_is_judged_as_one_force_where_that_is_better)
{
    int better[4] = { 0, 0, 0, 0 };
    for (int round = 0; round < 60; round++) {
        const sp_arena mark = test_arena;
        scene_at_work o;
        NEED(make(&o, 0));
        for (int v = 0; v < CORNERS && round % 2; v++) for (int k = 1; k < 3; k++) o.f[3 * v + k] = R(0.2 * k) * o.f[3 * v];
        sp__moving_sums(&o.j, o.f);
        for (int c = 0; c < BLOCKS; c++) {
            sp_contact part = o.pb.contact[c];
            const sp_contact *t = &part;
            const int n = part.points = round % 3 ? 3 : 2;
            if (round % 4 > 1) {                        /* along the joint alone */
                slide(&o, t);
                share(&o, c);
                sp__moving_sums(&o.j, o.f);
            }
            const sp_real mu = t->joint->strength.mu, moved = R(size_of(&o, t->a) + size_of(&o, t->b));
            const sp_real s = sp__least_of_blocks(t, o.j.pass.sums, 2);
            double gap = 0, rub = 0;
            sp_real g[3][3], d[3][3];
            o.j.force_cap = sp__certifier_force_cap(&o.j, t);
            for (int v = 0; v < n; v++) {
                sp__moving_read(&o.j, t, 3 * c + v, o.f, o.a, g[v], d[v]);
                gap = fmax(gap, (double)sp__moving_gap(g[v], d[v], s, moved));
                rub = fmax(rub, (double)sp__moving_rub(g[v], d[v], mu, s, moved));
            }
            const double want = as_one_force(g, d, n, (double)mu, (double)s, (double)moved);
            CHECK_WITHIN(sp__moving_gathered(&o.j, t, o.f, o.a, s, moved), want, TOL(1e-12, 1e-4));
            CHECK_WITHIN(sp__moving_joint(&o.j, t, o.f, o.a, 0), fmax(gap, rub), TOL(1e-12, 1e-4));
            CHECK_WITHIN(sp__moving_joint(&o.j, t, o.f, o.a, 1), fmax(gap, fmin(rub, want)), TOL(1e-12, 1e-4));
            better[n] += gap < rub && want < rub;
        }
        memset(o.f, 0, sizeof o.f);
        CHECK_NEAR(sp__moving_gathered(&o.j, &o.pb.contact[0], o.f, o.a, 1, 1), 0, 0);
        test_arena = mark;
    }
    CHECK(better[2] > 2 && better[3] > 5);
}

#endif

TEST_LIST(moving)
#if SP__WITH_STRONG && SP__WITH_SLIDING
    RUN(a_corner_violates_by_its_gap_by_pressure_that_opens_or_by_friction_not_against_its_slip)
    RUN(laws_of_contact_are_asked_of_every_corner)
    RUN(what_a_block_of_some_mass_leaves_unbalanced_is_told)
    RUN(pressure_is_the_forces_without_friction_and_without_pull)
    RUN(a_slide_is_told_by_its_violations_and_the_share_of_work_of_its_loads)
    RUN(a_force_beyond_its_cone_is_judged_by_what_is_within)
    RUN(friction_of_plates_is_judged_as_one_force_where_that_is_better)
    RUN(a_joint_is_judged_by_a_cap_of_its_own)
    RUN(a_slide_is_no_matter_of_plates)
    RUN(friction_that_is_one_force_at_the_centre_of_pressure_meets_the_laws)
#endif
TEST_END
