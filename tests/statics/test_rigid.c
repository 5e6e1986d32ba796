/* Rigid groups: the blocks a motion leaves together, the motion that ties them, its transpose, what makes it sharp, what opens
 * the joints that rounding closed, and the proofs that are tried of it. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../scenes/gen.h"
#include "../../solvers/statics/newton.c"

#include <math.h>

enum { MOST = 256 };

/* A system of a generated scene, and vectors of it. */
typedef struct tied {
    sp_scene scene;
    sp_problem pb;
    sp_settings set;
    sp_cost cost;
    sp__system *w;
    size_t n;
    sp_real *x, *y, *a, *b;
    int32_t up[MOST + 1];
} tied;

static int begin(tied *t, const char *name, const char *number, double value)
{
    sp_arena *a = &test_arena;
    memset(t, 0, sizeof *t);
    t->set.tol = R(TOL(1e-9, 1e-4f));
    t->set.inscribed = 1;
    if (!CHECK_INT(gen_make(name, number, value, a, &t->scene), SP_OK)) return 0;
    if (!CHECK_INT(sp_problem_build(&t->scene, a, &t->pb), SP_OK) || !CHECK(t->pb.blocks <= MOST)) return 0;
    t->w = sp__system_make_full(&t->pb, &t->set, SP__EXACT, &t->cost, a);
    if (!CHECK(t->w != NULL)) return 0;
    sp__system_weights(t->w);
    t->n = 6 * (size_t)t->pb.blocks;
    sp_real **all[4] = { &t->x, &t->y, &t->a, &t->b };
    for (int q = 0; q < 4; q++) *all[q] = sp__take(a, t->n, sizeof **all[q]);
    for (size_t k = 0; k < t->n; k++) { t->x[k] = test_random_real(-1, 1); t->y[k] = test_random_real(-1, 1); }
    return CHECK(t->b != NULL);
}

/* Any groups: blocks joined by chance, some with the ground. */
static void any_groups(tied *t)
{
    for (int32_t i = 0; i <= t->pb.blocks; i++) t->up[i] = i;
    for (int32_t k = 0; k < t->pb.blocks; k++)
        sp__join(t->up, test_random_int(test_random_int(0, 9) ? 1 : 0, t->pb.blocks), test_random_int(1, t->pb.blocks));
}

/* Velocity of block i at a point of space, from its weighted motion. */
static void velocity(const tied *t, const sp_real *x, int32_t i, const double at[3], double v[3])
{
    const sp_real *m = x + 6 * (size_t)i, *z = t->w->measure.weight + 2 * (size_t)i, *c = t->scene.block[t->pb.block[i]].centroid;
    double r[3], o[3];
    for (int k = 0; k < 3; k++) { r[k] = at[k] - (double)c[k]; o[k] = (double)(z[1] * m[3 + k]); }
    v[0] = (double)(z[0] * m[0]) + o[1] * r[2] - o[2] * r[1];
    v[1] = (double)(z[0] * m[1]) + o[2] * r[0] - o[0] * r[2];
    v[2] = (double)(z[0] * m[2]) + o[0] * r[1] - o[1] * r[0];
}

/* Blocks of a group have one velocity at any point of space, that of their root; those of the ground have none. */
TEST(a_tied_motion_is_that_of_the_roots)
{
    for (int k = 0; k < 20; k++) {
        const sp_arena mark = test_arena;
        const double at[3] = { (double)test_random_real(-3, 3), (double)test_random_real(-3, 3), (double)test_random_real(-3, 3) };
        tied t;
        NEED(begin(&t, k % 2 ? "arch" : "wall", k % 2 ? "n" : "rows", k % 2 ? 12 : 4));
        any_groups(&t);
        memcpy(t.a, t.x, t.n * sizeof *t.a);
        sp__rigid_prolong(t.w, t.up, t.a);
        for (int32_t i = 0; i < t.pb.blocks; i++) {
            const int32_t root = sp__root(t.up, i + 1) - 1;
            double v[3], want[3] = { 0, 0, 0 };
            velocity(&t, t.a, i, at, v);
            if (root >= 0) velocity(&t, t.x, root, at, want);
            for (int q = 0; q < 3; q++) CHECK_WITHIN(v[q], want[q], TOL(1e-11, 1e-4));
        }
        test_arena.used = mark.used;
    }
}

/* (prolong x) . y = x . (restrict y), rows of roots alone being left. */
TEST(restriction_is_the_transpose_of_prolongation)
{
    for (int k = 0; k < 40; k++) {
        const sp_arena mark = test_arena;
        tied t;
        double left = 0, right = 0, size = 0;
        NEED(begin(&t, k % 2 ? "dome" : "wall", k % 2 ? "rings" : "jitter", k % 2 ? 2 : 0.3));
        any_groups(&t);
        memcpy(t.a, t.x, t.n * sizeof *t.a);
        memcpy(t.b, t.y, t.n * sizeof *t.b);
        sp__rigid_prolong(t.w, t.up, t.a);
        sp__rigid_restrict(t.w, t.up, t.b);
        for (size_t q = 0; q < t.n; q++) {
            left += (double)(t.a[q] * t.y[q]);
            right += (double)(t.x[q] * t.b[q]);
            size += fabs((double)(t.a[q] * t.y[q]));
            if (sp__root(t.up, (int32_t)(q / 6) + 1) != (int32_t)(q / 6) + 1) CHECK_NEAR(t.b[q], 0, 0);
        }
        CHECK(size > 0.1);
        CHECK_WITHIN(left, right, TOL(1e-12, 1e-5) * size);
        test_arena.used = mark.used;
    }
}

/* Inside a rigid group no contact gives, so none need be asked. */
TEST(tied_motions_are_resisted_between_their_groups_alone)
{
    for (int k = 0; k < 20; k++) {
        const sp_arena mark = test_arena;
        tied t;
        double off = 0, size = 0;
        NEED(begin(&t, k % 2 ? "dome" : "wall", k % 2 ? "rings" : "jitter", k % 2 ? 2 : 0.3));
        any_groups(&t);
        sp__rigid_prolong(t.w, t.up, t.x);
        sp__system_apply(t.w, NULL, t.y, t.x, t.a);
        sp__system_apply(t.w, t.up, t.y, t.x, t.b);
        for (size_t q = 0; q < t.n; q++) { off += pow((double)(t.a[q] - t.b[q]), 2); size += pow((double)t.a[q], 2); }
        CHECK(size > 1e-6);
        CHECK_WITHIN(sqrt(off), 0, TOL(1e-12, 1e-4) * sqrt(size));
        test_arena.used = mark.used;
    }
}

/* Resistance x'Hx of the tied motion goes, and its gradient along tied motions with it. */
TEST(a_sharpened_motion_is_tied_and_resisted_least)
{
    for (int k = 0; k < 10; k++) {
        const sp_arena mark = test_arena;
        tied t;
        sp_state state;
        memset(&state, 0, sizeof state);
        NEED(begin(&t, "arch", "n", 6 + k));
        any_groups(&t);
        memcpy(t.w->y, t.y, t.n * sizeof *t.y);
        memcpy(t.w->d, t.x, t.n * sizeof *t.x);
        memcpy(t.a, t.x, t.n * sizeof *t.a);
        sp__rigid_prolong(t.w, t.up, t.a);
        sp__system_apply(t.w, NULL, t.y, t.a, t.b);
        const double before = (double)sp__dot(t.a, t.b, t.n);
        sp__rigid_restrict(t.w, t.up, t.b);             /* its gradient along tied motions */
        const double slope = sqrt((double)sp__dot(t.b, t.b, t.n));
        state.dq = sp__take(&test_arena, t.n, sizeof *state.dq);
        NEED(state.dq && sp__rigid_sharpen(t.w, t.up, &state));
        memcpy(t.x, t.w->d, t.n * sizeof *t.x);
        memcpy(t.a, t.x, t.n * sizeof *t.a);
        sp__rigid_prolong(t.w, t.up, t.a);
        double off = 0, size = 0;
        for (size_t q = 0; q < t.n; q++) { off += pow((double)(t.a[q] - t.x[q]), 2); size += pow((double)t.x[q], 2); }
        CHECK_WITHIN(sqrt(off), 0, TOL(1e-11, 1e-4) * sqrt(size));
        sp__system_apply(t.w, NULL, t.y, t.x, t.b);
        const double after = (double)sp__dot(t.x, t.b, t.n);
        CHECK(before > 1e-3 && after <= 0.05 * before);
        sp__rigid_restrict(t.w, t.up, t.b);
        CHECK_WITHIN(sqrt((double)sp__dot(t.b, t.b, t.n)), 0, 0.05 * slope);
        test_arena.used = mark.used;
    }
}

/* Every joint that blocks hang on opens by what its normal says, no less than before. */
TEST(joints_are_opened_along_their_normals)
{
    for (int k = 0; k < 8; k++) {
        const sp_arena mark = test_arena;
        tied t;
        NEED(begin(&t, k % 2 ? "tower" : "overhang", "n", 3 + k));
        sp_real (*off)[3] = sp__take(&test_arena, (size_t)t.pb.blocks, sizeof *off);
        NEED(off);
        for (int32_t c = 0; c < t.pb.contacts; c += 2) {        /* every other joint from its other side */
            sp_contact *j = &t.pb.contact[c];
            const int32_t a = j->a;
            j->a = j->b;
            j->b = a;
            for (int q = 0; q < 3; q++) t.scene.joint[j->id].n[q] *= -1;
        }
        for (size_t q = 0; q < t.n; q++) t.x[q] = q % 6 ? 0 : 1;
        sp__rigid_open_joints(t.w, t.x, off);
        for (int32_t c = 0; c < t.pb.contacts; c++) {
            const sp_contact *j = &t.pb.contact[c];
            double open = 0;                            /* a tower is a path: each block is one normal above the other */
            for (int q = 0; q < 3; q++)
                open += (double)j->joint->n[q] * ((j->b < 0 ? 0 : (double)off[j->b][q]) - (j->a < 0 ? 0 : (double)off[j->a][q]));
            CHECK_NEAR(open, 1, TOL(1e-12, 1e-5));
        }
        for (int32_t i = 0; i < t.pb.blocks; i++) {     /* the motion sought is -x: x goes back by 4 u of the largest */
            const sp_real z = t.w->measure.weight[2 * (size_t)i];
            double most = 0;
            for (int32_t q = 0; q < t.pb.blocks; q++) most = fmax(most, (double)t.w->measure.weight[2 * (size_t)q]);
            const double want = 4 * (double)SP_EPSILON * most * (double)off[i][2];
            CHECK_WITHIN(-t.x[6 * (size_t)i + 2] * z, want, 1e-3 * fabs(want));
        }
        test_arena.used = mark.used;
    }
}

/* A block in a slot without friction falls. What opens its joint with one wall by 4 u closes the other by as much: caps of
 * 1 / u of its weight do not let it, and it counts as it was; caps of 100 times do, and it counts as opened. */
TEST(a_motion_that_must_not_be_opened_is_tried_as_it_is)
{
    const sp_capacity room = { 2, 0, 0, 0, 2, 8, 0 };
    const sp_real wall[3] = { 0, 0, 0 }, n[2][3] = { { 1, 0, 0 }, { -1, 0, 0 } };
    for (int k = 0; k < 4; k++) {
        const sp_arena mark = test_arena;
        const int stiff = k % 2, side = k / 2;          /* the wall that is opened: that of the first joint */
        const sp_strength smooth = sp_strength_friction(0);
        sp__newton search;
        sp_state state;
        tied t;
        memset(&t, 0, sizeof t);
        memset(&search, 0, sizeof search);
        memset(&state, 0, sizeof state);
        t.set.tol = R(TOL(1e-9, 1e-4f));
        t.set.force_bound = stiff ? 1 / (sp_real)SP_EPSILON : 100;
        NEED(sp_scene_create(&t.scene, &room, &test_arena) == SP_OK);
        NEED(sp_scene_body(&t.scene, 0, wall, SP_FIXED, NULL) == SP_OK && sp_scene_body(&t.scene, 1, wall, 0, NULL) == SP_OK);
        for (int q = 0; q < 2; q++) {
            const sp_real *m = n[q ^ side], x[12] = { -m[0], -1, -1, -m[0], 1, -1, -m[0], 1, 1, -m[0], -1, 1 };
            NEED(sp_scene_points(&t.scene, 0, 1, m, 4, x, &smooth, NULL) == SP_OK);
        }
        NEED(sp_problem_build(&t.scene, &test_arena, &t.pb) == SP_OK);
        t.w = sp__system_make_full(&t.pb, &t.set, SP__EXACT, &t.cost, &test_arena);
        state.dq = sp__take(&test_arena, 6, sizeof *state.dq);
        NEED(t.w && state.dq);
        sp__system_weights(t.w);
        t.w->measure.size[0] = t.w->measure.size[1] = 2 * sp__abs(t.pb.p[2]);
        for (int q = 0; q < 6; q++) { t.w->y[q] = q < 2; t.w->d[q] = q == 2; }      /* pressed to a wall, sliding; d = -dq */
        sp__newton_try_rigid(t.w, &search, SP__PLAY, &state);
        NEED(CHECK_INT(search.proved, 1));
        CHECK(state.dq[2] < 0);
        const double opened = stiff ? 0 : (side ? -4 : 4) * (double)SP_EPSILON * fabs((double)state.dq[2]);
        CHECK_WITHIN(state.dq[0], opened, 1e-3 * fabs(opened));
        test_arena.used = mark.used;
    }
}

TEST_LIST(rigid)
    RUN_FULL(a_tied_motion_is_that_of_the_roots)
    RUN_FULL(restriction_is_the_transpose_of_prolongation)
    RUN_FULL(tied_motions_are_resisted_between_their_groups_alone)
    RUN_FULL(a_sharpened_motion_is_tied_and_resisted_least)
    RUN_FULL(joints_are_opened_along_their_normals)
    RUN_FULL(a_motion_that_must_not_be_opened_is_tried_as_it_is)
TEST_END
