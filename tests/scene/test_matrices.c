/* Matrices: the problem of a scene, Aeq, Afr, and columns from entries. Signs, transposes and indices are what can go wrong. */
#include "../test.h"
#include "../../solvers/cone/pyramids.c"
#include <string.h>
#include <math.h>

#define U ((double)SP_EPSILON)
#define TURN 6.283185307179586476925

/* Unit cubes as bodies: 0 a support centred at z = 1/2, 1 on top of it; the square between them. */
static const sp_real square[12] = { 0, 0, 1,  1, 0, 1,  1, 1, 1,  0, 1, 1 };

static sp_scene empty(void)
{
    const sp_capacity cap = { 16, 0, 0, 0, 32, 128, 0 };
    sp_scene scene;
    CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
    return scene;
}

static void body(sp_scene *scene, double x, double y, double z, double mass, uint32_t fixed)
{
    const sp_real c[3] = { R(x), R(y), R(z) };
    CHECK_INT(sp_scene_body(scene, R(mass), c, fixed, NULL), SP_OK);
}

static void touch(sp_scene *scene, int32_t a, int32_t b, const sp_real *xyz, double mu)
{
    const sp_strength strength = sp_strength_friction(R(mu));
    CHECK_INT(sp_scene_joint(scene, a, b, 4, xyz, &strength, NULL), SP_OK);
}

static sp_scene two_cubes(uint32_t below)
{
    sp_scene scene = empty();
    body(&scene, 0.5, 0.5, 0.5, 3, below);
    body(&scene, 0.5, 0.5, 1.5, 5, 0);
    touch(&scene, 0, 1, square, 0.5);
    return scene;
}

static sp_problem build(const sp_scene *scene)
{
    sp_problem p;
    memset(&p, 0, sizeof p);
    CHECK_INT(sp_problem_build(scene, &test_arena, &p), SP_OK);
    return p;
}

/* Entry (i, j) of a matrix by entries; equal places add. */
static double at(const sp_triplets *t, int32_t i, int32_t j)
{
    double sum = 0;
    for (int32_t k = 0; k < t->count; k++)
        if (t->i[k] == i && t->j[k] == j) sum += (double)t->x[k];
    return sum;
}

/* Sixteen random blocks, `supports` of them fixed, with random squares between them. */
static sp_scene tangle(int supports)
{
    sp_scene scene = empty();
    for (int k = 0; k < 16; k++)
        body(&scene, (double)test_random_real(-3, 3), (double)test_random_real(-3, 3), (double)test_random_real(-3, 3),
             (double)test_random_real(1, 9), k % 4 == 1 && k / 4 < supports ? SP_FIXED : 0);
    for (int k = 0; k < 32; k++) {
        const int32_t a = test_random_int(0, 15), b = (a + test_random_int(1, 15)) % 16;
        sp_real o[3], u[3], v[3], xyz[12];
        for (int c = 0; c < 3; c++) {
            o[c] = test_random_real(-3, 3); u[c] = test_random_real(-1, 1); v[c] = test_random_real(-1, 1);
        }
        for (int c = 0; c < 3; c++) {
            xyz[c] = o[c]; xyz[3 + c] = o[c] + u[c]; xyz[6 + c] = o[c] + u[c] + v[c]; xyz[9 + c] = o[c] + v[c];
        }
        touch(&scene, a, b, xyz, (double)test_random_real(0, 1));
    }
    return scene;
}

/* ------------------------------------------------------------------------------------------------------------ pyramid */

TEST(directions_are_right_to_a_few_ulp)
{
    double worst = 0;
    for (int32_t K = 3; K <= 64; K++)
        for (int32_t k = 0; k < K; k++) {
            sp_real d[2];
            sp__pyramid_direction(K, k, d);
            const int32_t quarter = 4 * k / K;          /* the library's cosine of a rounded 2 pi k/K would be no better */
            const double rest = TURN / 4 * (4 * k % K) / K, c = cos(rest), s = sin(rest);
            const double x = (double)d[0] - (quarter % 2 ? -s : c) * (quarter < 2 ? 1 : -1);
            const double y = (double)d[1] - (quarter % 2 ? c : s) * (quarter < 2 ? 1 : -1);
            const double off = sqrt(x * x + y * y);
            if (off > worst) worst = off;
        }
    CHECK_WITHIN(worst, 0, 5 * U);
}

TEST(half_faces_are_right_to_a_few_ulp)
{
    for (int32_t K = 3; K <= 64; K++) {
        sp_real c, t;
        sp__pyramid_half(K, &c, &t);
        CHECK_NEAR(c, cos(TURN / 2 / K), 4 * U);
        CHECK_NEAR(t, tan(TURN / 2 / K), 8 * U);
    }
}

TEST(axes_are_exact_and_mirrors_equal)
{
    for (int32_t K = 3; K <= 64; K++)
        for (int32_t k = 0; k < K; k++) {
            sp_real d[2], e[2];
            sp__pyramid_direction(K, k, d);
            if (4 * k % K == 0) {
                const int quarter = (int)(4 * k / K);
                CHECK_WITHIN(d[0], quarter % 2 ? 0 : 1 - quarter, 0);
                CHECK_WITHIN(d[1], quarter % 2 ? 2 - quarter : 0, 0);
            }
            if (8 * k % K == 0 && 4 * k % K != 0) CHECK_WITHIN(fabs((double)d[0]), fabs((double)d[1]), 0);
            if (k > 0) {                                /* mirrored in the first direction */
                sp__pyramid_direction(K, K - k, e);
                CHECK_WITHIN(e[0], d[0], 0);
                CHECK_WITHIN(e[1], -(double)d[1], 0);
            }
            if (K % 2 == 0) {                           /* opposite */
                sp__pyramid_direction(K, (k + K / 2) % K, e);
                CHECK_WITHIN(e[0], -(double)d[0], 0);
                CHECK_WITHIN(e[1], -(double)d[1], 0);
            }
        }
}

/* ------------------------------------------------------------------------------------------------------------ problem */

TEST(a_problem_takes_exactly_what_it_says)
{
    const sp_scene scene = tangle(4);
    const size_t bytes = test_bytes(&scene, SP_FOR_PROBLEM, NULL);
    const sp_arena before = test_arena;
    sp_arena a = test_arena;
    sp_problem p, was;
    memset(&p, 0x5a, sizeof p);
    was = p;
    a.used = (a.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    a.capacity = a.used + bytes - 1;
    sp_arena tight = a;
    CHECK_INT(sp_problem_build(&scene, &tight, &p), SP_E_MEMORY);
    CHECK(memcmp(&tight, &a, sizeof a) == 0);
    CHECK(memcmp(&p, &was, sizeof p) == 0);
    a.capacity++;
    CHECK_INT(sp_problem_build(&scene, &a, &p), SP_OK);
    CHECK_INT(a.used, a.capacity);
    CHECK(memcmp(&before, &test_arena, sizeof before) == 0);
}

TEST(problem_refuses_nonsense)
{
    sp_scene scene = empty();
    sp_problem p;
    sp_arena none = { NULL, 1000, 0, 0 };
    CHECK_INT(sp_problem_build(&scene, &test_arena, &p), SP_E_EMPTY);
    body(&scene, 0, 0, 0, 1, 0);
    CHECK_INT(test_bytes(NULL, SP_FOR_PROBLEM, NULL), 0);
    CHECK_INT(sp_problem_build(NULL, &test_arena, &p), SP_E_ARGUMENT);
    CHECK_INT(sp_problem_build(&scene, NULL, &p), SP_E_ARGUMENT);
    CHECK_INT(sp_problem_build(&scene, &none, &p), SP_E_ARGUMENT);
    CHECK_INT(sp_problem_build(&scene, &test_arena, NULL), SP_E_ARGUMENT);
    const size_t used = test_arena.used;
    scene.gravity[1] = (sp_real)HUGE_VAL;
    CHECK_INT(sp_problem_build(&scene, &test_arena, &p), SP_E_NOT_FINITE);
    scene.gravity[1] = (sp_real)NAN;
    CHECK_INT(sp_problem_build(&scene, &test_arena, &p), SP_E_NOT_FINITE);
    scene.gravity[1] = 0;
    body(&scene, (double)TOL(1e200, 1e25f), 0, 0, 1, 0);
    touch(&scene, 0, 1, square, 0);                     /* an arm whose square overflows */
    CHECK_INT(sp_problem_build(&scene, &test_arena, &p), SP_E_NOT_FINITE);
    CHECK_INT(test_arena.used, used);
}

TEST(two_cubes_make_the_problem_on_paper)
{
    const sp_scene scene = two_cubes(SP_FIXED);
    const sp_problem p = build(&scene);
    CHECK_INT(p.blocks, 1);
    CHECK_INT(p.contacts, 1);
    CHECK_INT(p.points, 4);
    CHECK(p.live == NULL);
    CHECK_INT(p.block[0], 1);
    CHECK(p.scene == &scene);
    const sp_contact *c = &p.contact[0];
    const double ra[3] = { 0, 0, 0.5 }, rb[3] = { 0, 0, -0.5 };
    const double local[4][3] = { { 0, -0.5, -0.5 }, { 0, 0.5, -0.5 }, { 0, 0.5, 0.5 }, { 0, -0.5, 0.5 } };
    CHECK_INT(c->a, -1);
    CHECK_INT(c->b, 0);
    CHECK_INT(c->id, 0);
    CHECK_INT(c->point, 0);
    CHECK_INT(c->points, 4);
    CHECK_NEAR(c->joint->strength.mu, 0.5, 0);
    for (int k = 0; k < 3; k++) {
        CHECK_WITHIN(c->ra[k], ra[k], 0);
        CHECK_WITHIN(c->rb[k], rb[k], 0);
        for (int v = 0; v < 4; v++) CHECK_WITHIN(p.local[v][k], local[v][k], 0);
    }
    for (int k = 0; k < 6; k++) CHECK_NEAR(p.p[k], k == 2 ? -5 * 9.80665 : 0, 2 * U);
}

/* Rows count free blocks only; what lies between two supports is not there; a partly held block keeps its six rows. */
TEST(supports_have_no_rows)
{
    sp_scene scene = empty();
    const uint32_t fixed[5] = { SP_FIXED, 0, SP_FIXED, 21u, 0 };
    for (int k = 0; k < 5; k++) body(&scene, 0.5, 0.5, k, k + 1, fixed[k]);
    touch(&scene, 0, 2, square, 0.1);
    touch(&scene, 4, 3, square, 0.2);
    touch(&scene, 2, 0, square, 0.3);
    touch(&scene, 1, 0, square, 0.4);
    const sp_problem p = build(&scene);
    CHECK_INT(p.blocks, 3);
    CHECK_INT(p.contacts, 2);
    CHECK_INT(p.points, 16);
    const int32_t block[3] = { 1, 3, 4 };
    for (int k = 0; k < 3; k++) {
        CHECK_INT(p.block[k], block[k]);
        CHECK_NEAR(p.p[6 * k + 2], -(block[k] + 1) * 9.80665, 2 * U);
    }
    CHECK_INT(p.contact[0].id, 1);
    CHECK_INT(p.contact[0].a, 2);
    CHECK_INT(p.contact[0].b, 1);
    CHECK_INT(p.contact[0].point, 4);
    CHECK_INT(p.contact[1].id, 3);
    CHECK_INT(p.contact[1].a, 0);
    CHECK_INT(p.contact[1].b, -1);
    sp_triplets aeq, afr;
    sp_settings s = sp_settings_default();
    s.faces = 8;
    CHECK_INT(sp_matrix_aeq(&p, 3, &test_arena, &aeq), SP_OK);
    CHECK_INT(sp_matrix_afr(&p, &s, 3, &test_arena, &afr), SP_OK);
    CHECK_INT(aeq.rows, 18);
    CHECK_INT(aeq.cols, 48);
    CHECK_INT(afr.rows, 8 * 16);
    CHECK_INT(afr.cols, 48);
    for (int32_t k = 0; k < aeq.count; k++) CHECK(aeq.j[k] / 12 == 1 || aeq.j[k] / 12 == 3);
    for (int32_t k = 0; k < afr.count; k++) CHECK((afr.i[k] / 32 == 1 || afr.i[k] / 32 == 3) && afr.i[k] / 8 == afr.j[k] / 3);
    for (int32_t k = 0; k < aeq.count; k++) CHECK(aeq.i[k] / 6 != 0 || aeq.j[k] / 12 == 3);
}

TEST(all_fixed_is_a_problem_without_rows)
{
    sp_scene scene = empty();
    body(&scene, 0, 0, 0, 1, SP_FIXED);
    body(&scene, 0, 0, 1, 1, SP_FIXED);
    touch(&scene, 0, 1, square, 0.5);
    const sp_problem p = build(&scene);
    sp_triplets t;
    sp_csc m;
    CHECK_INT(p.blocks, 0);
    CHECK_INT(p.contacts, 0);
    CHECK_INT(sp_matrix_aeq(&p, 4, &test_arena, &t), SP_OK);
    CHECK_INT(t.rows, 0);
    CHECK_INT(t.cols, 16);
    CHECK_INT(t.count, 0);
    CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_OK);
    CHECK_INT(m.p[16], 0);
}

/* Moved by 1e6, everything relative keeps its bits. */
TEST(a_far_problem_is_the_near_one)
{
    sp_scene near_ = empty(), far_ = empty();
    const double o[3] = { 1e6, -1e6, 524288 };
    sp_real xyz[12], moved[12];
    for (int v = 0; v < 12; v++) {
        xyz[v] = square[v] * R(0.75) + R(v / 3 == 1 || v / 3 == 2 ? 0.25 : 0);
        xyz[v] = R(floor((double)xyz[v] * 8) / 8);
        if (v % 3 == 2) xyz[v] = R(1);
        moved[v] = R((double)xyz[v] + o[v % 3]);
    }
    body(&near_, 0.5, 0.25, 0.5, 1, SP_FIXED);
    body(&near_, 0.5, 0.75, 1.5, 1, 0);
    body(&far_, o[0] + 0.5, o[1] + 0.25, o[2] + 0.5, 1, SP_FIXED);
    body(&far_, o[0] + 0.5, o[1] + 0.75, o[2] + 1.5, 1, 0);
    touch(&near_, 0, 1, xyz, 1);
    touch(&far_, 0, 1, moved, 1);
    const sp_problem a = build(&near_), b = build(&far_);
    CHECK(memcmp(a.contact->ra, b.contact->ra, sizeof a.contact->ra) == 0);
    CHECK(memcmp(a.contact->rb, b.contact->rb, sizeof a.contact->rb) == 0);
    CHECK(memcmp(a.contact->joint->t1, b.contact->joint->t1, sizeof a.contact->joint->t1) == 0);
    CHECK(memcmp(a.local, b.local, 4 * sizeof *a.local) == 0);
    sp_triplets ta, tb;
    CHECK_INT(sp_matrix_aeq(&a, 3, &test_arena, &ta), SP_OK);
    CHECK_INT(sp_matrix_aeq(&b, 3, &test_arena, &tb), SP_OK);
    NEED(ta.count == tb.count);
    CHECK(memcmp(ta.x, tb.x, (size_t)ta.count * sizeof *ta.x) == 0);
}

/* origin + n l0 + t1 l1 + t2 l2 is the vertex again, seen from either centroid, and the mean of the locals is zero. */
TEST(arms_and_locals_rebuild_the_points)
{
    const sp_scene scene = tangle(3);
    const sp_problem p = build(&scene);
    for (int32_t k = 0; k < p.contacts; k++) {
        const sp_contact *c = &p.contact[k];
        const sp_joint *f = &scene.joint[c->id];
        double mean[3] = { 0, 0, 0 };
        for (int32_t v = c->point; v < c->point + c->points; v++)
            for (int x = 0; x < 3; x++) {
                const double arm = (double)p.local[v][0] * (double)c->joint->n[x] + (double)p.local[v][1] * (double)c->joint->t1[x]
                                 + (double)p.local[v][2] * (double)c->joint->t2[x];
                const double at_a = (double)scene.block[f->a].centroid[x], at_b = (double)scene.block[f->b].centroid[x];
                CHECK_WITHIN(at_a + (double)c->ra[x] + arm, scene.point[v][x], 64 * U);
                CHECK_WITHIN(at_b + (double)c->rb[x] + arm, scene.point[v][x], 64 * U);
                mean[x] += (double)p.local[v][x];
            }
        for (int x = 0; x < 3; x++) CHECK_WITHIN(mean[x], 0, 32 * U);
    }
}

/* ---------------------------------------------------------------------------------------------------------------- Aeq */

/* By hand: B's arm of vertex 0 is r = (-1/2, -1/2, -1/2), A's (-1/2, -1/2, 1/2); n = z, t1 = x, t2 = y.
 * r x z = (ry, -rx, 0), r x x = (0, rz, -ry), r x y = (-rz, 0, rx); A has the opposite sign. */
TEST(two_cubes_make_the_matrix_on_paper)
{
    const sp_scene scene = two_cubes(0);
    const sp_problem p = build(&scene);
    sp_triplets t;
    CHECK_INT(sp_matrix_aeq(&p, 3, &test_arena, &t), SP_OK);
    CHECK_INT(t.rows, 12);
    CHECK_INT(t.cols, 12);
    CHECK_INT(t.count, 4 * 3 * 2 * 3);                  /* one force and two moments a column and block, no stored zeros */
    const double b[6][3] = { { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -0.5, 0, 0.5 }, { 0.5, -0.5, 0 }, { 0, 0.5, -0.5 } };
    const double a[6][3] = { { 0, -1, 0 }, { 0, 0, -1 }, { -1, 0, 0 }, { 0.5, 0, 0.5 }, { -0.5, -0.5, 0 }, { 0, -0.5, 0.5 } };
    for (int32_t i = 0; i < 6; i++)
        for (int32_t j = 0; j < 3; j++) {
            CHECK_WITHIN(at(&t, i, j), a[i][j], 0);
            CHECK_WITHIN(at(&t, 6 + i, j), b[i][j], 0);
        }
    CHECK_WITHIN(at(&t, 6 + 3, 3 * 2), 0.5, 0);         /* fn at vertex 2, r = (1/2, 1/2, .): moments (1/2, -1/2, 0) */
    CHECK_WITHIN(at(&t, 6 + 4, 3 * 2), -0.5, 0);
    for (int32_t k = 0; k < t.count; k++) CHECK(t.x[k] > 0 || t.x[k] < 0);
}

/* A quarter of the weight at each corner carries the upper cube: Aeq f + p = 0. */
TEST(a_quarter_at_each_corner_carries_a_cube)
{
    const sp_scene scene = two_cubes(SP_FIXED);
    const sp_problem p = build(&scene);
    sp_triplets t;
    double r[6];
    for (int32_t columns = 3; columns <= 4; columns++) {
        CHECK_INT(sp_matrix_aeq(&p, columns, &test_arena, &t), SP_OK);
        CHECK_INT(t.rows, 6);
        CHECK_INT(t.cols, 4 * columns);
        for (int k = 0; k < 6; k++) r[k] = (double)p.p[k];
        for (int32_t k = 0; k < t.count; k++)
            if (t.j[k] % columns == 0) r[t.i[k]] += (double)t.x[k] * 5 * 9.80665 / 4;
        for (int k = 0; k < 6; k++) CHECK_WITHIN(r[k], 0, 50 * 4 * U);
    }
}

TEST(four_columns_split_the_normal)
{
    const sp_scene scene = tangle(4);
    const sp_problem p = build(&scene);
    sp_triplets three, four;
    sp_csc a, b;
    CHECK_INT(sp_matrix_aeq(&p, 3, &test_arena, &three), SP_OK);
    CHECK_INT(sp_matrix_aeq(&p, 4, &test_arena, &four), SP_OK);
    CHECK_INT(sp_csc_from(&three, &test_arena, &a), SP_OK);
    CHECK_INT(sp_csc_from(&four, &test_arena, &b), SP_OK);
    CHECK_INT(b.rows, a.rows);
    for (int32_t v = 0; v < p.points; v++) {
        const int32_t from[4] = { 0, 0, 1, 2 };
        for (int c = 0; c < 4; c++) {
            const int32_t i = a.p[3 * v + from[c]], j = b.p[4 * v + c], n = a.p[3 * v + from[c] + 1] - i;
            NEED(b.p[4 * v + c + 1] - j == n);
            for (int32_t q = 0; q < n; q++) {
                CHECK_INT(b.i[j + q], a.i[i + q]);
                CHECK_WITHIN(b.x[j + q], c == 1 ? -(double)a.x[i + q] : (double)a.x[i + q], 0);
            }
        }
    }
}

/* Moving all blocks together, as one body about any point, opens and slides nothing: Aeq' dq = 0. */
TEST(a_common_motion_moves_no_contact)
{
    const sp_scene scene = tangle(0);
    const sp_problem p = build(&scene);
    sp_triplets t;
    double dq[96], dd[3 * 128] = { 0 }, v[3], w[3];
    for (int c = 0; c < 3; c++) { v[c] = (double)test_random_real(-1, 1); w[c] = (double)test_random_real(-1, 1); }
    for (int32_t k = 0; k < p.blocks; k++) {
        const sp_real *x = scene.block[p.block[k]].centroid;
        for (int c = 0; c < 3; c++) {
            const int d = (c + 1) % 3, e = (c + 2) % 3;
            dq[6 * k + c] = v[c] + w[d] * (double)x[e] - w[e] * (double)x[d];
            dq[6 * k + 3 + c] = w[c];
        }
    }
    CHECK_INT(sp_matrix_aeq(&p, 3, &test_arena, &t), SP_OK);
    for (int32_t k = 0; k < t.count; k++) dd[t.j[k]] += (double)t.x[k] * dq[t.i[k]];
    for (int32_t j = 0; j < t.cols; j++) CHECK_WITHIN(dd[j], 0, 256 * U);
}

/* Lifting B by one opens each contact by n . z and slides it by t . z. */
TEST(a_lifted_block_opens_its_contacts)
{
    const sp_scene scene = tangle(2);
    const sp_problem p = build(&scene);
    sp_triplets t;
    double dd[3 * 128] = { 0 };
    const int32_t row = 5;
    CHECK_INT(sp_matrix_aeq(&p, 3, &test_arena, &t), SP_OK);
    for (int32_t k = 0; k < t.count; k++)
        if (t.i[k] == 6 * row + 2) dd[t.j[k]] += (double)t.x[k];
    for (int32_t k = 0; k < p.contacts; k++) {
        const sp_contact *c = &p.contact[k];
        const double s = c->b == row ? 1 : c->a == row ? -1 : 0;
        for (int32_t q = c->point; q < c->point + c->points; q++) {
            CHECK_WITHIN(dd[3 * q], s * (double)c->joint->n[2], 0);
            CHECK_WITHIN(dd[3 * q + 1], s * (double)c->joint->t1[2], 0);
            CHECK_WITHIN(dd[3 * q + 2], s * (double)c->joint->t2[2], 0);
        }
    }
}

/* ---------------------------------------------------------------------------------------------------------------- Afr */

TEST(four_faces_have_exact_coefficients)
{
    const sp_scene scene = two_cubes(SP_FIXED);
    const sp_problem p = build(&scene);
    sp_settings s = sp_settings_default();
    sp_triplets t;
    s.faces = 4;
    s.inscribed = 0;
    CHECK_INT(sp_matrix_afr(&p, &s, 3, &test_arena, &t), SP_OK);
    CHECK_INT(t.rows, 16);
    CHECK_INT(t.cols, 12);
    CHECK_INT(t.count, 4 * 4 * 2);
    const double want[4][3] = { { -0.5, 1, 0 }, { -0.5, 0, 1 }, { -0.5, -1, 0 }, { -0.5, 0, -1 } };
    for (int32_t v = 0; v < 4; v++)
        for (int32_t k = 0; k < 4; k++)
            for (int32_t c = 0; c < 3; c++) CHECK_WITHIN(at(&t, 4 * v + k, 3 * v + c), want[k][c], 0);
    s.inscribed = 1;
    CHECK_INT(sp_matrix_afr(&p, &s, 3, &test_arena, &t), SP_OK);
    CHECK_NEAR(at(&t, 5, 3), -0.5 * sqrt(0.5), 4 * U);
    CHECK_WITHIN(at(&t, 5, 5), 1, 0);
}

/* Friction is bounded by fp alone, or by fp - fm. */
TEST(net_friction_counts_tension)
{
    const sp_scene scene = two_cubes(SP_FIXED);
    const sp_problem p = build(&scene);
    sp_settings s = sp_settings_default();
    sp_triplets t;
    s.faces = 8;
    s.inscribed = 0;
    for (int net = 0; net < 2; net++) {
        s.penalty.net = net;
        CHECK_INT(sp_matrix_afr(&p, &s, 4, &test_arena, &t), SP_OK);
        CHECK_INT(t.cols, 16);
        for (int32_t k = 0; k < 8; k++) {
            CHECK_WITHIN(at(&t, 16 + k, 8), -0.5, 0);
            CHECK_WITHIN(at(&t, 16 + k, 9), net ? 0.5 : 0, 0);
            CHECK_WITHIN(at(&t, 16 + k, 10), cos(TURN * k / 8), 4 * U);
            CHECK_WITHIN(at(&t, 16 + k, 11), sin(TURN * k / 8), 4 * U);
        }
        s.penalty.net = 1;
        CHECK_INT(sp_matrix_afr(&p, &s, 3, &test_arena, &t), SP_OK);
        CHECK_WITHIN(at(&t, 17, 6), -0.5, 0);           /* with 3 columns fn is net anyway */
    }
}

/* An inscribed pyramid touches the cone in its edges, a circumscribed one along its faces; both for every K. */
TEST(pyramids_touch_the_cone)
{
    const sp_scene scene = two_cubes(SP_FIXED);
    const sp_problem p = build(&scene);
    sp_settings s = sp_settings_default();
    for (s.faces = 3; s.faces <= 64; s.faces++)
        for (s.inscribed = 0; s.inscribed < 2; s.inscribed++) {
            const int32_t K = s.faces;
            const sp_arena mark = test_arena;
            sp_triplets t;
            double face[64][3];
            CHECK_INT(sp_matrix_afr(&p, &s, 3, &test_arena, &t), SP_OK);
            for (int32_t q = 0; q < 3 * K; q++) face[q / 3][q % 3] = at(&t, q / 3, q % 3);
            for (int32_t k = 0; k < K; k++) {
                const double angle = TURN * (k + (s.inscribed ? 0.5 : 0)) / K, ft[2] = { 0.5 * cos(angle), 0.5 * sin(angle) };
                double most = -9;
                for (int32_t q = 0; q < K; q++) {
                    const double row = face[q][0] + face[q][1] * ft[0] + face[q][2] * ft[1];
                    if (row > most) most = row;
                }
                CHECK_WITHIN(most, 0, 6 * U);
            }
            test_arena = mark;
        }
}

TEST(matrices_refuse_nonsense)
{
    const sp_scene scene = two_cubes(0);
    const sp_problem p = build(&scene);
    sp_settings s = sp_settings_default();
    sp_arena none = { NULL, 1000, 0, 0 };
    sp_triplets t, was;
    memset(&t, 0x5a, sizeof t);
    was = t;
    const size_t used = test_arena.used;
    s.faces = 8;
    CHECK_INT(sp_matrix_aeq(NULL, 3, &test_arena, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&p, 3, NULL, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&p, 3, &none, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&p, 3, &test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_aeq(&p, 2, &test_arena, &t), SP_E_RANGE);
    CHECK_INT(sp_matrix_aeq(&p, 5, &test_arena, &t), SP_E_RANGE);
    CHECK_INT(sp_matrix_afr(NULL, &s, 3, &test_arena, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&p, NULL, 3, &test_arena, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&p, &s, 3, NULL, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&p, &s, 3, &none, &t), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&p, &s, 3, &test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_matrix_afr(&p, &s, 2, &test_arena, &t), SP_E_RANGE);
    const int32_t faces[5] = { 0, 2, 65, -8, INT32_MAX };
    for (int k = 0; k < 5; k++) {
        s.faces = faces[k];
        CHECK_INT(sp_matrix_afr(&p, &s, 3, &test_arena, &t), SP_E_RANGE);
    }
    CHECK(memcmp(&t, &was, sizeof t) == 0);
    CHECK_INT(test_arena.used, used);
}

/* count x (i, j, x), each piece aligned. */
static size_t entries(int32_t count)
{
    const size_t n = (size_t)count, a = SP_ALIGN - 1;
    return ((n * sizeof(int32_t) + a) & ~a) * 2 + n * sizeof(sp_real);
}

TEST(matrices_take_their_entries_and_no_byte_more)
{
    const sp_scene scene = tangle(4);
    const sp_problem p = build(&scene);
    sp_settings s = sp_settings_default();
    s.faces = 5;
    for (int k = 0; k < 4; k++) {
        sp_arena whole = test_arena, exact = test_arena;
        sp_triplets t, u, was;
        exact.used = (exact.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
        const int32_t columns = 3 + k % 2;
        CHECK_INT(k < 2 ? sp_matrix_aeq(&p, columns, &whole, &t) : sp_matrix_afr(&p, &s, columns, &whole, &t), SP_OK);
        exact.capacity = exact.used + entries(t.count);
        sp_arena less = exact;
        less.capacity--;
        const sp_arena before = less;
        memset(&u, 0x5a, sizeof u);
        was = u;
        CHECK_INT(k < 2 ? sp_matrix_aeq(&p, columns, &less, &u) : sp_matrix_afr(&p, &s, columns, &less, &u), SP_E_MEMORY);
        CHECK(memcmp(&less, &before, sizeof less) == 0);
        CHECK(memcmp(&u, &was, sizeof u) == 0);
        CHECK_INT(k < 2 ? sp_matrix_aeq(&p, columns, &exact, &u) : sp_matrix_afr(&p, &s, columns, &exact, &u), SP_OK);
        CHECK_INT(exact.used, exact.capacity);
        CHECK_INT(u.count, t.count);
    }
}

/* ------------------------------------------------------------------------------------------------------------ columns */

TEST(columns_are_sorted_and_duplicates_added)
{
    int32_t i[8] = { 2, 0, 2, 1, 2, 0, 1, 2 }, j[8] = { 1, 3, 0, 1, 1, 0, 1, 1 };
    sp_real x[8] = { 1, 2, 3, 4, 10, 5, -4, 100 };
    const sp_triplets t = { 3, 5, 8, i, j, x };
    sp_csc m;
    CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_OK);
    const int32_t p[6] = { 0, 2, 4, 4, 5, 5 }, rows[5] = { 0, 2, 1, 2, 0 };
    const double values[5] = { 5, 3, 0, 111, 2 };       /* a sum of 0 stays an entry */
    CHECK_INT(m.rows, 3);
    CHECK_INT(m.cols, 5);
    for (int k = 0; k < 6; k++) CHECK_INT(m.p[k], p[k]);
    for (int k = 0; k < 5; k++) {
        CHECK_INT(m.i[k], rows[k]);
        CHECK_WITHIN(m.x[k], values[k], 0);
    }
}

/* (large + 1) - large and (large - large) + 1 differ: the order of entries is the order of adding. */
TEST(duplicates_are_added_in_their_order)
{
    const sp_real large = R(4) / SP_EPSILON;
    int32_t i[6] = { 1, 1, 1, 1, 1, 1 }, j[6] = { 0, 1, 0, 1, 0, 1 };
    sp_real x[6] = { large, large, 1, -large, -large, 1 };
    const sp_triplets t = { 2, 2, 6, i, j, x };
    sp_csc m;
    CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_OK);
    CHECK_INT(m.p[2], 2);
    CHECK_WITHIN(m.x[0], 0, 0);
    CHECK_WITHIN(m.x[1], 1, 0);
}

TEST(random_entries_make_the_same_dense_matrix)
{
    for (int round = 0; round < 40; round++) {
        const int32_t rows = test_random_int(1, 12), cols = test_random_int(1, 12), count = test_random_int(0, 150);
        int32_t i[150], j[150];
        sp_real x[150];
        double dense[144] = { 0 };
        for (int32_t k = 0; k < count; k++) {
            i[k] = test_random_int(0, rows - 1);
            j[k] = test_random_int(0, cols - 1);
            x[k] = (sp_real)test_random_int(-50, 50);
            dense[12 * i[k] + j[k]] += (double)x[k];
        }
        const sp_triplets t = { rows, cols, count, i, j, x };
        sp_csc m;
        NEED(sp_csc_from(&t, &test_arena, &m) == SP_OK);
        CHECK_INT(m.p[0], 0);
        for (int32_t c = 0; c < cols; c++)
            for (int32_t k = m.p[c]; k < m.p[c + 1]; k++) {
                CHECK(k == m.p[c] || m.i[k] > m.i[k - 1]);
                dense[12 * m.i[k] + c] -= (double)m.x[k];
            }
        for (int k = 0; k < 144; k++) CHECK_WITHIN(dense[k], 0, 0);
    }
}

TEST(columns_refuse_nonsense)
{
    int32_t i[2] = { 0, 1 }, j[2] = { 0, 1 };
    sp_real x[2] = { 1, 2 };
    const sp_triplets good = { 2, 2, 2, i, j, x };
    sp_arena none = { NULL, 1000, 0, 0 };
    sp_csc m, was;
    memset(&m, 0x5a, sizeof m);
    was = m;
    sp_triplets t = good;
    CHECK_INT(sp_csc_from(NULL, &test_arena, &m), SP_E_ARGUMENT);
    CHECK_INT(sp_csc_from(&good, NULL, &m), SP_E_ARGUMENT);
    CHECK_INT(sp_csc_from(&good, &none, &m), SP_E_ARGUMENT);
    CHECK_INT(sp_csc_from(&good, &test_arena, NULL), SP_E_ARGUMENT);
    t.rows = -1;             CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_E_ARGUMENT);
    t = good; t.cols = -1;   CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_E_ARGUMENT);
    t = good; t.count = -1;  CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_E_ARGUMENT);
    t = good; t.x = NULL;    CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_E_ARGUMENT);
    t = good; t.i = NULL;    CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_E_ARGUMENT);
    t = good; t.j = NULL;    CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_E_ARGUMENT);
    t = good; t.rows = 1;    CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_E_INDEX);
    t = good; t.cols = 1;    CHECK_INT(sp_csc_from(&t, &test_arena, &m), SP_E_INDEX);
    i[0] = -1;               CHECK_INT(sp_csc_from(&good, &test_arena, &m), SP_E_INDEX);
    i[0] = 0; j[1] = -1;     CHECK_INT(sp_csc_from(&good, &test_arena, &m), SP_E_INDEX);
    CHECK(memcmp(&m, &was, sizeof m) == 0);
    CHECK_INT(test_arena.used, 0);
}

/* The least arena that works is used to its last byte at the peak; what stays is p, i and x. */
TEST(columns_give_their_scratch_back)
{
    int32_t i[5] = { 3, 1, 3, 0, 2 }, j[5] = { 0, 1, 0, 1, 2 };
    sp_real x[5] = { 1, 2, 3, 4, 5 };
    const sp_triplets t = { 4, 3, 5, i, j, x };
    sp_csc m;
    sp_arena a = test_arena;
    size_t cap = 1;
    for (;; cap++) {
        a = test_arena;
        a.capacity = cap;
        const sp_arena before = a;
        const sp_status status = sp_csc_from(&t, &a, &m);
        if (status == SP_OK) break;
        NEED(status == SP_E_MEMORY && cap < 1000);
        CHECK(memcmp(&a, &before, sizeof a) == 0);
    }
    CHECK_INT(a.peak, cap);
    CHECK_INT(a.used, 16 + 32 + 5 * sizeof *x);         /* 4 and 5 int32, aligned; 5 numbers */
    CHECK_INT(m.p[3], 4);
    CHECK_WITHIN(m.x[0], 4, 0);
}

TEST_LIST(matrices)
    RUN(directions_are_right_to_a_few_ulp)
    RUN(half_faces_are_right_to_a_few_ulp)
    RUN(axes_are_exact_and_mirrors_equal)
    RUN(a_problem_takes_exactly_what_it_says)
    RUN(problem_refuses_nonsense)
    RUN(two_cubes_make_the_problem_on_paper)
    RUN(supports_have_no_rows)
    RUN(all_fixed_is_a_problem_without_rows)
    RUN(a_far_problem_is_the_near_one)
    RUN(arms_and_locals_rebuild_the_points)
    RUN(two_cubes_make_the_matrix_on_paper)
    RUN(a_quarter_at_each_corner_carries_a_cube)
    RUN(four_columns_split_the_normal)
    RUN(a_common_motion_moves_no_contact)
    RUN(a_lifted_block_opens_its_contacts)
    RUN(four_faces_have_exact_coefficients)
    RUN(net_friction_counts_tension)
    RUN(pyramids_touch_the_cone)
    RUN(matrices_refuse_nonsense)
    RUN(matrices_take_their_entries_and_no_byte_more)
    RUN(columns_are_sorted_and_duplicates_added)
    RUN(duplicates_are_added_in_their_order)
    RUN(random_entries_make_the_same_dense_matrix)
    RUN(columns_refuse_nonsense)
    RUN(columns_give_their_scratch_back)
TEST_END
