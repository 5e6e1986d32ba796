/* The dual D(y) from the inside: its gradient, slope and Hessian against differences, its factor against the product it
 * inverts, rigid groups against the motions that make them. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../scenes/gen.h"
#include "../../solvers/statics/rigid.c"

#include <math.h>

enum { SCENES = 5, POINTS = 3 };

static const struct { const char *name, *number; double value; int32_t faces; } scene_of[SCENES] = {
    { "arch", "n", 7, 0 }, { "wall", "size", 20, 0 }, { "dome", "rings", 3, 0 }, { "arch", "n", 7, 6 },
    { "wall", "jitter", 0.3, 4 }
};

/* One dual at a random y, and room for what is compared. */
typedef struct bench {
    sp_scene scene;
    sp_problem pb;
    sp_settings set;
    sp_cost cost;
    sp__system *w;
    size_t n;
    sp_real *y, *d, *at, *r, *q, *f;
} bench;

/* What of the settings the dual reads, as by default. */
static void settle(sp_settings *set)
{
    memset(set, 0, sizeof *set);
    set->tol = R(TOL(1e-9, 1e-4f));
    set->penalty.gamma = 1000;
    set->penalty.tau = 1;
    set->inscribed = 1;
}

static int begin(bench *b, int k)
{
    memset(b, 0, sizeof *b);
    settle(&b->set);
    b->set.faces = scene_of[k].faces;
    sp_arena *a = &test_arena;
    if (!CHECK_INT(gen_make(scene_of[k].name, scene_of[k].number, scene_of[k].value, a, &b->scene), SP_OK)) return 0;
    if (!CHECK_INT(sp_problem_build(&b->scene, a, &b->pb), SP_OK)) return 0;
    b->w = sp__system_make_full(&b->pb, &b->set, SP__EXACT, &b->cost, a);
    if (!CHECK(b->w != NULL)) return 0;
    sp__system_weights(b->w);
    b->n = 6 * (size_t)b->pb.blocks;
    sp_real **all[5] = { &b->y, &b->d, &b->at, &b->r, &b->q };
    for (int q = 0; q < 5; q++) *all[q] = sp__take(a, b->n, sizeof **all[q]);
    b->f = sp__take(a, (size_t)b->pb.points, 3 * sizeof *b->f);
    for (size_t q = 0; q < b->n; q++) { b->y[q] = test_random_real(-1, 1); b->d[q] = test_random_real(-1, 1); }
    return CHECK(b->f != NULL);
}

static void step(bench *b, sp_real h) { for (size_t k = 0; k < b->n; k++) b->at[k] = b->y[k] + h * b->d[k]; }

/* D = 1/2 sum |f_v|^2 / S_v + p . y, from the forces alone; b->q gets the gradient. */
static double value(bench *b, const sp_real *y)
{
    double sum = 0;
    sp__system_gradient(b->w, SP__ADMISSIBLE, y, b->q, b->f);
    for (int32_t c = 0; c < b->pb.contacts; c++) {
        const sp_contact *t = &b->pb.contact[c];
        for (int32_t k = 3 * t->point; k < 3 * (t->point + t->points); k++)
            sum += 0.5 * (double)(b->f[k] * b->f[k] / sp__system_scale(b->w, c));
    }
    sp__system_load(b->w, b->r);
    for (size_t k = 0; k < b->n; k++) sum += (double)(b->r[k] * y[k]);
    return sum;
}

TEST(gradient_is_that_of_D)
{
    const sp_real h = R(TOL(1e-5, 3e-2f));
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        bench b;
        NEED(begin(&b, k));
        for (int p = 0; p < POINTS; p++) {
            step(&b, h);
            const double above = value(&b, b.at);
            step(&b, -h);
            const double below = value(&b, b.at), here = value(&b, b.y);
            double along = 0, size = fabs(here);
            for (size_t q = 0; q < b.n; q++) { along += (double)(b.q[q] * b.d[q]); size += fabs((double)(b.q[q] * b.d[q])); }
            CHECK(size > 0.1);
            CHECK_WITHIN((above - below) / (2 * (double)h), along, TOL(1e-7, 2e-3) * size);
            CHECK_WITHIN(sp__system_slope(b.w, b.y, b.d, 0) + sp__system_work(b.w, b.d), along, TOL(1e-12, 1e-5) * size);
            step(&b, 1);
            memcpy(b.y, b.at, b.n * sizeof *b.y);
        }
        test_arena.used = mark.used;
    }
}

TEST(held_directions_have_no_gradient)
{
    bench b;
    test_arena.used = 0;
    NEED(begin(&b, 0));
    b.scene.block[b.pb.block[2]].fixed = 1u | 4u | 16u;
    sp__system_gradient(b.w, SP__ADMISSIBLE, b.y, b.r, NULL);
    for (size_t q = 0; q < b.n; q++) CHECK_INT(b.r[q] > 0 || b.r[q] < 0, !(q == 12 || q == 14 || q == 16));
}

/* Away from the edges of the cones, where a random y is, D is twice differentiable. */
TEST(Hessian_is_that_of_the_gradient)
{
    const sp_real h = R(TOL(1e-6, 2e-3f));
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        bench b;
        NEED(begin(&b, k));
        step(&b, h);
        sp__system_gradient(b.w, SP__ADMISSIBLE, b.at, b.q, NULL);
        step(&b, -h);
        sp__system_gradient(b.w, SP__ADMISSIBLE, b.at, b.r, NULL);
        for (size_t q = 0; q < b.n; q++) b.r[q] = (b.q[q] - b.r[q]) / (2 * h);
        sp__system_apply(b.w, NULL, b.y, b.d, b.q);
        double off = 0, size = 0;
        for (size_t q = 0; q < b.n; q++) {
            off += pow((double)(b.r[q] - b.q[q]), 2);
            size += pow((double)b.q[q], 2);
        }
        CHECK(size > 1e-3);
        CHECK_WITHIN(sqrt(off), 0, TOL(1e-6, 3e-2) * sqrt(size));
        test_arena.used = mark.used;
    }
}

TEST(factor_inverts_Hessian_plus_shift)
{
    const sp_real shift = R(0.05);
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        bench b;
        NEED(begin(&b, k));
        sp__system_factor(b.w, SP__ADMISSIBLE, b.y, shift);
        sp__system_solve(b.w, b.d, b.at);
        sp__system_apply(b.w, NULL, b.y, b.at, b.q);
        double off = 0, size = 0;
        for (size_t q = 0; q < b.n; q++) {
            off += pow((double)(b.q[q] + shift * b.at[q] - b.d[q]), 2);
            size += pow((double)b.d[q], 2);
        }
        CHECK_WITHIN(sqrt(off), 0, TOL(1e-11, 1e-3) * sqrt(size));
        test_arena.used = mark.used;
    }
}

/* y = 0 presses nothing: what is left is the load. The bilateral force balances it wherever joints may pull. */
TEST(bilateral_force_leaves_nothing_of_the_load)
{
    for (int k = 0; k < SCENES; k++) {
        const sp_arena mark = test_arena;
        bench b;
        NEED(begin(&b, k));
        sp__system_bilateral(b.w);
        sp__system_gradient(b.w, SP__BILATERAL, b.w->y, b.r, NULL);
        for (size_t q = 0; q < b.n; q++) b.at[q] = -b.w->d[q];
        sp__system_gradient(b.w, SP__BILATERAL, b.at, b.q, NULL);
        sp__system_load(b.w, b.d);
        double off = 0, size = 0;
        for (size_t q = 0; q < b.n; q++) {
            off += pow((double)(b.r[q] + b.q[q] - b.d[q]), 2);         /* both parts; the load is in each */
            size += pow((double)b.d[q], 2);
        }
        CHECK_WITHIN(sqrt(off), 0, TOL(1e-9, 1e-3) * sqrt(size));
        test_arena.used = mark.used;
    }
}

/* A pile of six: blocks from `first` on move as one body, up and about an axis across; the others rest. */
static void move_from(bench *b, int32_t first, sp_real up, sp_real turn)
{
    for (int32_t i = 0; i < b->pb.blocks; i++) {
        const sp_real *c = b->scene.block[b->pb.block[i]].centroid, *z = b->w->measure.weight + 2 * (size_t)i;
        sp_real *x = b->y + 6 * (size_t)i;
        for (int q = 0; q < 6; q++) x[q] = 0;
        if (i < first) continue;
        x[0] = turn * c[2] / z[0];                      /* w x c for w along y */
        x[2] = (up - turn * c[0]) / z[0];
        x[4] = turn / z[1];
    }
}

TEST(rigid_groups_are_the_blocks_that_move_together)
{
    bench b;
    int32_t up[16];
    memset(&b, 0, sizeof b);
    settle(&b.set);
    NEED(gen_make("tower", "n", 6, &test_arena, &b.scene) == SP_OK);
    NEED(sp_problem_build(&b.scene, &test_arena, &b.pb) == SP_OK);
    NEED(b.pb.blocks < 15);
    b.w = sp__system_make_full(&b.pb, &b.set, SP__EXACT, &b.cost, &test_arena);
    NEED(b.w);
    sp__system_weights(b.w);
    b.y = sp__take(&test_arena, (size_t)b.pb.blocks, 6 * sizeof *b.y);
    for (int32_t first = 0; first <= b.pb.blocks; first++)
        for (int turn = 0; turn < 2; turn++) {
            move_from(&b, first, 1, (sp_real)turn);
            sp__rigid_groups(b.w, b.y, R(TOL(1e-9, 1e-4f)), up);
            for (int32_t i = 0; i < b.pb.blocks; i++)   /* up counts from 1; 0 is the ground */
                CHECK_INT(sp__root(up, i + 1), i < first ? 0 : first + 1);
        }
}

TEST_LIST(gradient)
    RUN_FULL(held_directions_have_no_gradient)
    RUN_FULL(gradient_is_that_of_D)
    RUN_FULL(Hessian_is_that_of_the_gradient)
    RUN_FULL(factor_inverts_Hessian_plus_shift)
    RUN_FULL(bilateral_force_leaves_nothing_of_the_load)
    RUN_FULL(rigid_groups_are_the_blocks_that_move_together)
TEST_END
