/* Pairs of forces and accelerations by pivoting: every one meets the laws of a pyramid, by sums of the tests' own. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/strong/starts.c"

#include <math.h>

#if SP__WITH_STRONG

enum { BLOCKS = 3, CORNERS = 4 * BLOCKS };

typedef struct scene_at_work {
    sp_scene scene;
    sp_problem pb;
    sp__inertia M[BLOCKS];
    sp__sweep sweep;
    sp__lemke lemke;
} scene_at_work;

/* A heap: every block on what is below it by four corners, faces up to `lean` off the level; what is held is held so. */
static int make(scene_at_work *o, double lean, uint32_t held, double mass)
{
    const sp_capacity room = { BLOCKS + 1, 0, 0, 0, BLOCKS, CORNERS, 0 };
    const sp_real ground[3] = { 0, 0, 0 };
    sp_real arm[BLOCKS];
    test_arena.used = 0;
    memset(o, 0, sizeof *o);
    if (!CHECK_INT(sp_scene_create(&o->scene, &room, &test_arena), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&o->scene, 0, ground, SP_FIXED, NULL), SP_OK)) return 0;
    for (int b = 1; b <= BLOCKS; b++) {
        const sp_real at[3] = { test_random_real(-0.3, 0.3), test_random_real(-0.3, 0.3), R(b) };
        const sp_real n[3] = { test_random_real(-lean, lean), test_random_real(-lean, lean), 1 };
        const sp_strength rough = { test_random_real(0.2, 0.9), 0, 0, 0 };
        sp_real x[12];
        for (int k = 0; k < 12; k++) {                  /* around the centroid */
            const int right = k / 3 == 1 || k / 3 == 2, far = k / 3 >= 2;
            x[k] = k % 3 == 2 ? R(b - 0.5) : (k % 3 ? far : right) ? test_random_real(0.4, 1) : -test_random_real(0.4, 1);
        }
        const sp_real m = R(mass) * test_random_real(1, 5);
        if (!CHECK_INT(sp_scene_body(&o->scene, m, at, b == 2 ? held : 0, NULL), SP_OK)) return 0;
        if (!CHECK_INT(sp_scene_points(&o->scene, b - 1, b, n, 4, x, &rough, NULL), SP_OK)) return 0;
    }
    if (!CHECK_INT(sp_problem_build(&o->scene, &test_arena, &o->pb), SP_OK)) return 0;
    if (!CHECK(sp__inertias(&o->pb, arm, o->M))) return 0;
    sp__sweep_carve(&o->sweep, &o->pb, &test_arena);
    o->sweep.M = o->M;
    sp__lemke_carve(&o->lemke, CORNERS, &test_arena);
    if (!CHECK(!sp__failed(&test_arena))) return 0;
    sp__sweep_begin(&o->sweep);
    memset(o->sweep.on, 1, CORNERS);
    return 1;
}

/* Largest acceleration that free fall gives. */
static const double fall = 9.80665;

/* The laws of corner v of a pair: pressure or a gap; within the pyramid; friction of the corner of it that is most against the slip. */
static void check_laws(const scene_at_work *o, int v, double weight)
{
    const sp__sweep_corner *q = &o->sweep.corner[v];
    const sp_real *f = o->sweep.f + 3 * q->at;
    const double mu = (double)o->pb.contact[q->contact].joint->strength.mu, near = TOL(1e-8, 3e-3);
    sp_real d[3];
    sp__sweep_rate(&o->sweep, q, o->sweep.a, d);
    const double slip = fmax(fabs((double)d[1]), fabs((double)d[2])), works = (double)(f[1] * d[1] + f[2] * d[2]);
    CHECK((double)f[0] >= 0);
    CHECK((double)d[0] >= -near * fall);
    CHECK_WITHIN((double)f[0] * (double)d[0], 0, near * weight * fall);
    CHECK(fabs((double)f[1]) + fabs((double)f[2]) <= mu * (double)f[0] + near * weight);
    CHECK_WITHIN(works, -mu * (double)f[0] * slip, near * weight * fall);
}

/* Pivoting; in float rounding may end it early: then there are no forces. */
static int ends(scene_at_work *o, uint32_t seed)
{
    if (sp__lemke_run(&o->lemke, &o->sweep, seed)) return 1;
    CHECK(TOL(0, 1));
    for (int k = 0; k < 3 * CORNERS; k++) CHECK(!(o->sweep.f[k] < 0 || o->sweep.f[k] > 0));
    return 0;
}

TEST(pivoting_ends_and_what_it_ends_with_meets_the_laws_of_a_pyramid)
{
    int moving = 0, resting = 0;
    for (int k = 0; k < SOME_OF(200, 20); k++) {
        scene_at_work o;
        if (!make(&o, k % 4 ? 0.7 : 0.1, k % 3 ? 0 : 1u << 1 | 1u << 3, k % 2 ? 1 : 1000)) return;
        double weight = 0;
        for (int b = 0; b < BLOCKS; b++) weight += (double)o.M[b].mass * fall;
        if (!ends(&o, (uint32_t)k + 1)) continue;
        sp__sweep_accelerate(&o.sweep);
        for (int v = 0; v < CORNERS; v++) check_laws(&o, v, weight);
        double most = 0;
        for (int i = 0; i < 6 * BLOCKS; i++) most = fmax(most, fabs((double)o.sweep.a[i]));
        moving += most > 1e-2 * fall;
        resting += most < 1e-5 * fall;
    }
    CHECK(moving > 5 && resting > 0);
}

TEST(a_pair_that_moves_and_meets_its_laws_has_a_positive_energy)
{
    scene_at_work o;
    for (int k = 0; k < SOME_OF(50, 10); k++) {
        if (!make(&o, 0.7, 0, 1)) return;
        if (!ends(&o, (uint32_t)k + 1)) continue;
        sp__sweep_accelerate(&o.sweep);
        double power = 0, twice = 0, rub = 0;           /* a'Ma = p . a - the work of friction */
        for (int b = 0; b < BLOCKS; b++)
            for (int r = 0; r < 6; r++) {
                const double a = (double)o.sweep.a[6 * b + r];
                power += (double)o.pb.p[6 * b + r] * a;
                if (r < 3) twice += (double)o.M[b].mass * a * a;
                else for (int q = 0; q < 3; q++) twice += (double)o.M[b].J[r - 3][q] * a * (double)o.sweep.a[6 * b + 3 + q];
            }
        for (int v = 0; v < CORNERS; v++) {
            sp_real d[3];
            sp__sweep_rate(&o.sweep, &o.sweep.corner[v], o.sweep.a, d);
            const sp_real *f = o.sweep.f + 3 * o.sweep.corner[v].at;
            rub -= (double)(f[1] * d[1] + f[2] * d[2]);
        }
        CHECK_WITHIN(twice, power - rub, TOL(1e-8, 1e-2) * (fabs(power) + 100));
    }
}

TEST(what_no_corner_holds_back_has_no_forces)
{
    scene_at_work o;
    if (!make(&o, 0.2, 0, 1)) return;
    for (int b = 0; b < BLOCKS; b++)                    /* lifted, the upper ones more */
        for (int k = 0; k < 6; k++) o.pb.p[6 * b + k] = k == 2 ? o.M[b].mass * R(1 + b) : 0;
    for (int c = 0; c < BLOCKS; c++) {
        sp_joint *t = &o.scene.joint[c];
        for (int k = 0; k < 3; k++) { t->n[k] = k == 2; t->t1[k] = k == 0; t->t2[k] = k == 1; }
    }
    sp__sweep_begin(&o.sweep);
    CHECK_INT(sp__lemke_run(&o.lemke, &o.sweep, 1), 1);
    for (int k = 0; k < 3 * CORNERS; k++) CHECK(!(o.sweep.f[k] < 0 || o.sweep.f[k] > 0));
}

TEST(an_exchange_leaves_what_the_table_says_as_it_was)
{
    enum { N = 6 };
    scene_at_work o;
    if (!make(&o, 0.5, 0, 1)) return;
    o.lemke.n = N;
    double value[2 * N + 1], first[N][N + 2];
    for (int i = 0; i < N; i++) {
        o.lemke.basic[i] = i;
        for (int k = 0; k < N + 2; k++) first[i][k] = (double)(o.lemke.T[i * (N + 2) + k] = test_random_real(-1, 1));
    }
    for (int k = 0; k <= N; k++) o.lemke.other[k] = N + k;
    for (int t = 0; t < 20; t++) {
        const int32_t r = (int32_t)(test_random() % N), c = (int32_t)(test_random() % (N + 1));
        if (fabs((double)o.lemke.T[r * (N + 2) + c]) > 0.1) sp__lemke_exchange(&o.lemke, r, c);
        for (int k = 0; k <= N; k++) value[o.lemke.other[k]] = (double)test_random_real(-1, 1);
        for (int i = 0; i < N; i++) {
            double y = (double)o.lemke.T[i * (N + 2) + N + 1];
            for (int k = 0; k <= N; k++) y += (double)o.lemke.T[i * (N + 2) + k] * value[o.lemke.other[k]];
            value[o.lemke.basic[i]] = y;
        }
        for (int i = 0; i < N; i++) {
            double y = first[i][N + 1];
            for (int k = 0; k <= N; k++) y += first[i][k] * value[N + k];
            CHECK_WITHIN(y, value[i], TOL(1e-9, 1e-2) * (1 + fabs(y)));
        }
        for (int k = 0; k <= N; k++) CHECK_INT(o.lemke.other[sp__lemke_column(&o.lemke, o.lemke.other[k])], o.lemke.other[k]);
    }
}

TEST(of_rows_that_end_a_step_together_the_added_variable_leaves_then_the_steepest)
{
    enum { N = 6, Z0 = 2 * N };
    static const sp_real fall_of[N] = { -1, -2, -4, R(-0.5), 3, -8 }, at[N] = { 1, 2, 4, 9, 1, 80 };
    scene_at_work o;
    if (!make(&o, 0.5, 0, 1)) return;
    o.lemke.n = N;
    o.lemke.dust = R(TOL(1e-12, 1e-6));
    for (int i = 0; i < N; i++) {
        o.lemke.basic[i] = i;
        for (int k = 0; k < N; k++) o.lemke.T[i * (N + 2) + k] = fall_of[i];
        o.lemke.T[i * (N + 2) + N + 1] = at[i];
    }
    CHECK_INT(sp__lemke_leaves(&o.lemke, 0), 2);                    /* 1, 2, 4 over 1, 2, 4 */
    o.lemke.basic[1] = Z0;
    CHECK_INT(sp__lemke_leaves(&o.lemke, 0), 1);
    o.lemke.basic[1] = 1;
    o.lemke.basic[5] = Z0;                                          /* far from leaving */
    CHECK_INT(sp__lemke_leaves(&o.lemke, 0), 2);
    o.lemke.T[3 * (N + 2) + N + 1] = R(0.1);
    CHECK_INT(sp__lemke_leaves(&o.lemke, 0), 3);
    for (int i = 0; i < N; i++) o.lemke.T[i * (N + 2)] = R(i < 3 ? 0.5 : 1);
    CHECK_INT(sp__lemke_leaves(&o.lemke, 0), -1);                   /* a ray */
}

TEST(a_table_is_held_for_so_many_corners_and_no_more)
{
    CHECK(sp__lemke_need(SP__LEMKE_POINTS) > 6 * 6 * sizeof(sp_real) * SP__LEMKE_POINTS * SP__LEMKE_POINTS);
    CHECK_INT(sp__lemke_need(SP__LEMKE_POINTS + 1), 0);
    CHECK_INT(sp__lemke_need(0), 0);
}

#endif

TEST_LIST(lemke)
#if SP__WITH_STRONG
    RUN(pivoting_ends_and_what_it_ends_with_meets_the_laws_of_a_pyramid)
    RUN(a_pair_that_moves_and_meets_its_laws_has_a_positive_energy)
    RUN(what_no_corner_holds_back_has_no_forces)
    RUN(an_exchange_leaves_what_the_table_says_as_it_was)
    RUN(of_rows_that_end_a_step_together_the_added_variable_leaves_then_the_steepest)
    RUN(a_table_is_held_for_so_many_corners_and_no_more)
#endif
TEST_END
