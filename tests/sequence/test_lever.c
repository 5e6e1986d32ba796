/* The lever of a contact about a block: sum |x x f0| >= lever sum |f0| for every f0 = V + W x x, from the least of
 * |G z|^2 / |F z|^2, which is found here by iteration and there by halving. */
#define SP_API static
#include "../test.h"

#include <math.h>

#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/scene/joint.c"
#include "../../solvers/sequence/state.c"

#if SP__WITH_LARGE

/* One joint anywhere, of three corners or four, seen from a block at the origin. */
static void any_joint(sp_scene *s, sp_problem *pb)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 4, 0 };
    const sp_real origin[3] = { 0, 0, 0 }, far[3] = { 9, 9, 9 };
    const sp_strength strength = sp_strength_friction(R(0.5));
    const int points = test_random_int(3, 4);
    sp_real xyz[12], u[3], v[3];
    test_arena.used = 0;
    for (int k = 0; k < 3; k++) {
        xyz[k] = test_random_real(-1, 1);
        u[k] = test_random_real(-1, 1);
        v[k] = test_random_real(-1, 1);
    }
    for (int k = 0; k < 3; k++) {
        xyz[3 + k] = xyz[k] + u[k];
        xyz[6 + k] = xyz[k] + u[k] + v[k];
        xyz[9 + k] = xyz[k] + v[k];
    }
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(s, 1, far, SP_FIXED, NULL), SP_OK);
    CHECK_INT(sp_scene_body(s, 1, origin, 0, NULL), SP_OK);
    CHECK_INT(sp_scene_joint(s, 0, 1, points, xyz, &strength, NULL), SP_OK);
    CHECK_INT(sp_problem_build(s, &test_arena, pb), SP_OK);
}

/* |F z|^2 and |G z|^2 of z = (V, W), by their definition. */
static void squares(const sp_scene *s, double unit, const double z[6], double *F, double *G)
{
    *F = *G = 0;
    for (int v = 0; v < s->count.points; v++) {
        double x[3], f[3];
        for (int k = 0; k < 3; k++) x[k] = (double)s->point[v][k] / unit;
        for (int k = 0; k < 3; k++) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            f[k] = z[k] + z[3 + a] * x[b] - z[3 + b] * x[a];
        }
        for (int k = 0; k < 3; k++) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            *F += f[k] * f[k];
            *G += (x[a] * f[b] - x[b] * f[a]) * (x[a] * f[b] - x[b] * f[a]);
        }
    }
}

static double size_of(const sp_scene *s)
{
    double most = 0;
    for (int v = 0; v < s->count.points; v++) {
        double xx = 0;
        for (int k = 0; k < 3; k++) xx += (double)s->point[v][k] * (double)s->point[v][k];
        most = fmax(most, sqrt(xx));
    }
    return most;
}

TEST(the_matrices_of_a_lever_are_squares_of_forces_and_their_moments)
{
    for (int k = 0; k < 50; k++) {
        sp_scene s;
        sp_problem pb;
        sp__lever_work w;
        double z[6], F, G, sums[2] = { 0, 0 };
        any_joint(&s, &pb);
        const double unit = size_of(&s);
        sp__lever_matrices(&pb, &pb.contact[0], 0, R(unit), &w);
        for (int r = 0; r < 6; r++) z[r] = (double)test_random_real(-1, 1);
        squares(&s, unit, z, &F, &G);
        for (int r = 0, e = 0; r < 6; r++)
            for (int c = 0; c <= r; c++, e++) {
                sums[0] += (r == c ? 1 : 2) * z[r] * z[c] * (double)w.FF[e];
                sums[1] += (r == c ? 1 : 2) * z[r] * z[c] * (double)w.GG[e];
            }
        CHECK_WITHIN(sums[0], F, TOL(1e-12, 1e-4) * (1 + F));
        CHECK_WITHIN(sums[1], G, TOL(1e-12, 1e-4) * (1 + F));
    }
}

/* The least |G z|^2 / |F z|^2, by steps any way, of sizes 1 to 1e-4, that make it less. */
static double least_share(const sp_scene *s, double unit)
{
    double z[6], F, G, least = 1;
    for (int start = 0; start < 2; start++) {
        for (int r = 0; r < 6; r++) z[r] = (double)test_random_real(-1, 1);
        for (int step = 0; step < 500; step++) {
            double way[6], best;
            squares(s, unit, z, &F, &G);
            best = G / F;
            for (int r = 0; r < 6; r++) way[r] = (double)test_random_real(-1, 1);
            for (double t = 1; t > 1e-4; t /= 4)
                for (int sign = -1; sign < 2; sign += 2) {
                    double y[6];
                    for (int r = 0; r < 6; r++) y[r] = z[r] + sign * t * way[r];
                    squares(s, unit, y, &F, &G);
                    if (F > 0 && G / F < best) { best = G / F; for (int r = 0; r < 6; r++) z[r] = y[r]; }
                }
            least = fmin(least, best);
        }
    }
    return least;
}

/* Shares are halved from 1/2 down to 1e-4; .9 of the root is what is claimed. */
TEST(a_lever_is_the_largest_of_its_halvings_that_holds)
{
    int some = 0;
    for (int k = 0; k < 12; k++) {
        sp_scene s;
        sp_problem pb;
        sp__lever_work w;
        any_joint(&s, &pb);
        const double unit = size_of(&s), lever = (double)sp__lever(&pb, &pb.contact[0], 0, &w);
        const double least = least_share(&s, unit), n = s.count.points;
        double share = 0.5;
        while (share > least) share /= 2;
        if (least / share < 1.02 || least / share > 1.96) continue;     /* too near to a halving to be told */
        some++;
        const double want = share > 1e-4 ? 0.9 * sqrt(share / n) * unit : 0;
        CHECK(lever <= want + 1e-5 * unit);
        if (share > TOL(0, 1e-2)) CHECK_WITHIN(lever, want, 1e-5 * unit);
    }
    CHECK(some > 6);
}

TEST(about_a_line_of_forces_there_is_no_lever)
{
    sp_scene s;
    sp_problem pb;
    sp__lever_work w;
    any_joint(&s, &pb);
    pb.contact[0].points = 1;
    CHECK(sp__lever(&pb, &pb.contact[0], 0, &w) <= 0);
    pb.contact[0].points = 2;
    CHECK(sp__lever(&pb, &pb.contact[0], 0, &w) <= 0);
}
#endif

TEST_LIST(lever)
#if SP__WITH_LARGE
    RUN(the_matrices_of_a_lever_are_squares_of_forces_and_their_moments)
    RUN(a_lever_is_the_largest_of_its_halvings_that_holds)
    RUN(about_a_line_of_forces_there_is_no_lever)
#endif
TEST_END
