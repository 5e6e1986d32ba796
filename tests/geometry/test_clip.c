/* test_clip: common regions of polygons against areas that follow from something else. */
#define SP_API static
#include <string.h>
#include "../test.h"
#include "../../solvers/base/words.c"

#include <math.h>

#include "../../solvers/geometry/clip.c"

#define EPS R(TOL(1e-9, 1e-5f))

/* A clipper with room for p and q segments that may all cross. */
static sp__clip *clipper(int32_t p, int32_t q)
{
    sp__clip *c = sp__take(&test_arena, 1, sizeof *c);
    if (!CHECK(c != NULL)) return NULL;
    sp__clip_carve(c, p, q, (int64_t)p * q, &test_arena);
    CHECK(!sp__failed(&test_arena));
    sp__clip_clear(c);
    return c;
}

/* Add the polygon xy[0..n), moved by (x, y). */
static void add(sp__clip *c, int32_t side, int32_t n, sp_real (*xy)[2], double x, double y)
{
    for (int32_t k = 0; k < n; k++) {
        const int32_t m = (k + 1) % n;
        const sp_real p[2] = { xy[k][0] + R(x), xy[k][1] + R(y) }, q[2] = { xy[m][0] + R(x), xy[m][1] + R(y) };
        sp__clip_add(c, side, p, q, k, m);
    }
}

/* The rectangle from (x0, y0) to (x1, y1); a hole if `hole`. */
static void box(sp__clip *c, int32_t side, double x0, double y0, double x1, double y1, int hole)
{
    sp_real p[4][2] = { { R(x0), R(y0) }, { R(x1), R(y0) }, { R(x1), R(y1) }, { R(x0), R(y1) } };
    if (hole) {
        p[1][0] = R(x0); p[1][1] = R(y1);
        p[3][0] = R(x1); p[3][1] = R(y0);
    }
    add(c, side, 4, p, 0, 0);
}

static double loop_area(const sp__clip *c, int32_t l)
{
    double a = 0;
    const sp_real *o = c->corner[c->loop[l]].x;
    for (int32_t k = c->loop[l]; k < c->loop[l + 1]; k++) {
        const sp_real *p = c->corner[k].x, *q = c->corner[k + 1 < c->loop[l + 1] ? k + 1 : c->loop[l]].x;
        a += ((double)p[0] - (double)o[0]) * ((double)q[1] - (double)o[1])
           - ((double)p[1] - (double)o[1]) * ((double)q[0] - (double)o[0]);
    }
    return a / 2;
}

static double total(const sp__clip *c)
{
    double a = 0;
    for (int32_t l = 0; l < c->loops; l++) a += loop_area(c, l);
    return a;
}

/* Every loop simple: no corner twice, no two edges crossing. */
static int simple(const sp__clip *c)
{
    for (int32_t l = 0; l < c->loops; l++) {
        const int32_t s = c->loop[l], n = c->loop[l + 1] - s;
        for (int32_t i = 0; i < n; i++)
            for (int32_t j = i + 1; j < n; j++) {
                const sp_real *a = c->corner[s + i].x, *b = c->corner[s + (i + 1) % n].x;
                const sp_real *p = c->corner[s + j].x, *q = c->corner[s + (j + 1) % n].x;
                const sp_real dx = a[0] - p[0], dy = a[1] - p[1];
                if (!(dx * dx + dy * dy > 0)) return 0;
                if (j == i + 1 || (j + 1) % n == i) continue;
                if (sp__clip_turn(a, b, p) * sp__clip_turn(a, b, q) < 0
                    && sp__clip_turn(p, q, a) * sp__clip_turn(p, q, b) < 0) return 0;
            }
    }
    return 1;
}

/* A star-shaped polygon about (x, y): directions evenly turned by `turn`, radii lo .. hi. */
static void star(int32_t n, sp_real (*xy)[2], double x, double y, double lo, double hi)
{
    const double t = 6.283185307179586 / n;
    double c = 1, s = 0, ct = 0, st = 0, term = 1;
    for (int k = 0; k < 30; k++) {                      /* cos and sin of t by their series */
        if (k % 2 == 0) ct += (k % 4 == 0 ? term : -term);
        else st += (k % 4 == 1 ? term : -term);
        term *= t / (k + 1);
    }
    for (int32_t k = 0; k < n; k++) {
        const double r = (double)test_random_real(lo, hi), u = c * ct - s * st;
        xy[k][0] = R(x + r * c);
        xy[k][1] = R(y + r * s);
        s = c * st + s * ct;
        c = u;
    }
}

/* Area of a triangle clipped by a triangle, both anticlockwise                             [Sutherland, Hodgman 1974] */
static double triangles(double p[3][2], double q[3][2])
{
    double poly[16][2], out[16][2], area = 0;
    int n = 3;
    memcpy(poly, p, 3 * sizeof *poly);
    for (int e = 0; e < 3 && n; e++) {
        const double *a = q[e], *b = q[(e + 1) % 3];
        int m = 0;
        for (int k = 0; k < n; k++) {
            const double *u = poly[k], *v = poly[(k + 1) % n];
            const double du = (b[0] - a[0]) * (u[1] - a[1]) - (b[1] - a[1]) * (u[0] - a[0]);
            const double dv = (b[0] - a[0]) * (v[1] - a[1]) - (b[1] - a[1]) * (v[0] - a[0]);
            if (du >= 0) { out[m][0] = u[0]; out[m++][1] = u[1]; }
            if ((du < 0 && dv > 0) || (du > 0 && dv < 0)) {
                out[m][0] = u[0] + (v[0] - u[0]) * (du / (du - dv));
                out[m++][1] = u[1] + (v[1] - u[1]) * (du / (du - dv));
            }
        }
        n = m;
        memcpy(poly, out, sizeof poly);
    }
    for (int k = 0; k < n; k++) area += poly[k][0] * poly[(k + 1) % n][1] - poly[k][1] * poly[(k + 1) % n][0];
    return area / 2;
}

/* Common area of two polygons, each star-shaped about its given centre: sum over the triangles of their fans. */
static double fans(int32_t n, sp_real (*p)[2], const double o[2], int32_t m, sp_real (*q)[2], const double z[2])
{
    double sum = 0;
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < m; j++) {
            double s[3][2] = { { o[0], o[1] }, { (double)p[i][0], (double)p[i][1] },
                               { (double)p[(i + 1) % n][0], (double)p[(i + 1) % n][1] } };
            double t[3][2] = { { z[0], z[1] }, { (double)q[j][0], (double)q[j][1] },
                               { (double)q[(j + 1) % m][0], (double)q[(j + 1) % m][1] } };
            sum += triangles(s, t);
        }
    return sum;
}

static void against_fans(int32_t n, int32_t m, double lo, int rounds)
{
    sp__clip *c = clipper(n, m);
    sp_real p[64][2], q[64][2];
    int odd = 0;
    NEED(c != NULL);
    for (int k = 0; k < rounds; k++) {
        const double o[2] = { 0, 0 };
        const double z[2] = { (double)test_random_real(-1.5, 1.5), (double)test_random_real(-1.5, 1.5) };
        star(n, p, o[0], o[1], lo, 1);
        star(m, q, z[0], z[1], lo, 1);
        sp__clip_clear(c);
        add(c, 0, n, p, 0, 0);
        add(c, 1, m, q, 0, 0);
        NEED(sp__clip_run(c, EPS, 0));
        odd += c->torn;
        CHECK_WITHIN(total(c), fans(n, p, o, m, q, z), TOL(3e-8, 3e-4));
        CHECK(simple(c));
    }
    CHECK_INT(odd, 0);
}

TEST(random_convex_pairs_have_the_area_of_sutherland_hodgman) { against_fans(9, 7, 0.95, 400); }

TEST(random_stars_have_the_area_of_their_fans) { against_fans(25, 31, 0.2, 150); }

TEST(a_square_in_itself_is_itself)
{
    sp__clip *c = clipper(4, 4);
    NEED(c != NULL);
    box(c, 0, 0, 0, 1, 1, 0);
    box(c, 1, 0, 0, 1, 1, 0);
    NEED(sp__clip_run(c, EPS, 0));
    CHECK_INT(c->loops, 1);
    CHECK_INT(c->corners, 4);
    CHECK_NEAR(total(c), 1, TOL(1e-15, 1e-6));
}

TEST(squares_that_share_an_edge_or_corner_have_nothing_in_common)
{
    sp__clip *c = clipper(4, 4);
    NEED(c != NULL);
    for (int k = 0; k < 3; k++) {
        sp__clip_clear(c);
        box(c, 0, 0, 0, 1, 1, 0);
        box(c, 1, 1, 0.5 * k, 2, 1 + 0.5 * k, 0);
        NEED(sp__clip_run(c, EPS, 0));
        CHECK_INT(c->loops, 0);
    }
}

TEST(collinear_corners_of_the_input_are_gone)
{
    sp__clip *c = clipper(6, 4);
    sp_real p[6][2] = { { 0, 0 }, { R(0.3), 0 }, { 1, 0 }, { 1, R(0.7) }, { 1, 1 }, { 0, 1 } };
    NEED(c != NULL);
    add(c, 0, 6, p, 0, 0);
    box(c, 1, 0, 0, 1, 2, 0);
    NEED(sp__clip_run(c, EPS, 0));
    CHECK_INT(c->loops, 1);
    CHECK_INT(c->corners, 4);
}

TEST(corners_keep_the_numbers_of_the_first_region)
{
    sp__clip *c = clipper(4, 4);
    NEED(c != NULL);
    box(c, 0, 0, 0, 2, 1, 0);
    box(c, 1, 1, 0, 3, 2, 0);
    NEED(sp__clip_run(c, EPS, 0));
    NEED(c->corners == 4);
    for (int k = 0; k < 4; k++) {
        const sp_real *p = c->corner[k].x;
        CHECK_INT(c->corner[k].name, p[0] > R(1.5) ? (p[1] > R(0.5) ? 2 : 1) : (p[1] > R(0.5) ? -1 : 0));
    }
}

TEST(a_u_on_a_bar_touches_twice)
{
    sp__clip *c = clipper(8, 4);
    sp_real u[8][2] = { { 0, 0 }, { 1, 0 }, { 1, 2 }, { 2, 2 }, { 2, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 } };
    NEED(c != NULL);
    add(c, 0, 8, u, 0, 0);
    box(c, 1, -1, -1, 4, 1.5, 0);
    NEED(sp__clip_run(c, EPS, 0));
    CHECK_INT(c->loops, 2);
    CHECK_INT(c->corners, 8);
    CHECK_NEAR(total(c), 3, TOL(1e-14, 1e-6));
}

TEST(a_ring_becomes_simple_polygons_of_its_area)
{
    sp__clip *c = clipper(8, 4);
    NEED(c != NULL);
    box(c, 0, 0, 0, 4, 4, 0);
    box(c, 0, 1, 1, 3, 3, 1);
    box(c, 1, -1, -1, 5, 5, 0);
    NEED(sp__clip_run(c, EPS, 0));
    CHECK_INT(c->loops, 2);
    CHECK_INT(c->torn, 0);
    CHECK_NEAR(total(c), 12, TOL(1e-14, 1e-6));
    CHECK(simple(c));
}

TEST(a_hole_that_touches_the_rim_leaves_simple_polygons)
{
    sp__clip *c = clipper(7, 4);
    sp_real hole[3][2] = { { 0, 2 }, { 2, 3 }, { 2, 1 } };          /* its first corner lies on the rim */
    NEED(c != NULL);
    box(c, 0, 0, 0, 4, 4, 0);
    add(c, 0, 3, hole, 0, 0);
    box(c, 1, -1, -1, 5, 5, 0);
    NEED(sp__clip_run(c, EPS, 0));
    CHECK_INT(c->torn, 0);
    CHECK_NEAR(total(c), 14, TOL(1e-14, 1e-6));
    CHECK(simple(c));
}

TEST(a_sieve_keeps_its_area)
{
    sp__clip *c = clipper(4 + 4 * 25, 4 + 4 * 4);
    NEED(c != NULL);
    box(c, 0, 0, 0, 11, 11, 0);
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) box(c, 0, 1 + 2 * i, 1 + 2 * j, 2 + 2 * i, 2 + 2 * j, 1);
    box(c, 1, 0.5, 0.5, 10.5, 10.5, 0);
    for (int i = 0; i < 2; i++)                                     /* over nine bars' crossings and next to holes */
        for (int j = 0; j < 2; j++) box(c, 1, 3 + 4 * i, 2 + 4 * j, 4 + 4 * i, 3 + 4 * j, 1);
    NEED(sp__clip_run(c, EPS, 0));
    CHECK_INT(c->torn, 0);
    CHECK_NEAR(total(c), 100 - 25 - 4, TOL(1e-13, 1e-5));
    CHECK(simple(c));
}

/* Random unions on a small grid against themselves: shared edges, corners and T-joints everywhere, then shaken below eps. */
static void grids(double shake, double tol)
{
    sp__clip *c = clipper(4 * 36, 4 * 36);
    NEED(c != NULL);
    for (int round = 0; round < 40; round++) {
        double want = 0;
        sp__clip_clear(c);
        for (int i = 0; i < 6; i++)
            for (int j = 0; j < 6; j++) {
                const int p = test_random() % 3 != 0, q = test_random() % 3 != 0;
                const double d = shake * (double)test_random_real(-1, 1), e = shake * (double)test_random_real(-1, 1);
                if (p) box(c, 0, i + d, j + e, i + 1 + d, j + 1 + e, 0);
                if (q) box(c, 1, i + e, j + d, i + 1 + e, j + 1 + d, 0);
                want += p && q;
            }
        NEED(sp__clip_run(c, EPS, 0));
        CHECK_INT(c->torn, 0);
        CHECK_WITHIN(total(c), want, tol);
        CHECK(simple(c));
    }
}

TEST(unions_of_grid_cells_are_exact) { grids(0, TOL(1e-13, 1e-5)); }

TEST(unions_of_shaken_cells_are_right_to_eps) { grids(0.2 * (double)EPS, 100 * (double)EPS); }

TEST(rotated_squares_make_the_octagon)
{
    sp__clip *c = clipper(4, 4);
    const double co = 0.9800665778412416, si = 0.19866933079506122;             /* 0.2 rad */
    sp_real q[4][2];
    NEED(c != NULL);
    for (int k = 0; k < 4; k++) {
        const double x = k == 1 || k == 2 ? 0.5 : -0.5, y = k > 1 ? 0.5 : -0.5;
        q[k][0] = R(co * x - si * y);
        q[k][1] = R(si * x + co * y);
    }
    box(c, 0, -0.5, -0.5, 0.5, 0.5, 0);
    add(c, 1, 4, q, 0, 0);
    NEED(sp__clip_run(c, EPS, 0));
    CHECK_INT(c->corners, 8);
    /* the circumscribed octagon of the circle of radius 1/2, tan of half the turns: tan(a/2) + tan(pi/4 - a/2), four each */
    CHECK_NEAR(total(c), (si / (1 + co)) + ((1 + co - si) / (1 + co + si)), TOL(1e-14, 1e-6));
}

TEST(slivers_are_left_out_by_their_width)
{
    sp__clip *c = clipper(4, 4);
    NEED(c != NULL);
    for (int k = 0; k < 2; k++) {
        sp__clip_clear(c);
        box(c, 0, 0, 0, 1, 1, 0);
        box(c, 1, k ? 0.9 : 0.98, 0, 2, 1, 0);
        NEED(sp__clip_run(c, EPS, R(0.05)));
        CHECK_INT(c->loops, k);
    }
}

TEST(too_little_room_is_told)
{
    sp__clip *c = clipper(4, 4);
    NEED(c != NULL);
    box(c, 0, 0, 0, 1, 1, 0);
    box(c, 1, 0.5, 0.5, 2, 2, 0);
    c->g.node_capacity = 9;
    CHECK(!sp__clip_run(c, EPS, 0));
}

TEST_LIST(clip)
    RUN(random_convex_pairs_have_the_area_of_sutherland_hodgman)
    RUN(random_stars_have_the_area_of_their_fans)
    RUN(a_square_in_itself_is_itself)
    RUN(squares_that_share_an_edge_or_corner_have_nothing_in_common)
    RUN(collinear_corners_of_the_input_are_gone)
    RUN(corners_keep_the_numbers_of_the_first_region)
    RUN(a_u_on_a_bar_touches_twice)
    RUN(a_ring_becomes_simple_polygons_of_its_area)
    RUN(a_hole_that_touches_the_rim_leaves_simple_polygons)
    RUN(a_sieve_keeps_its_area)
    RUN(unions_of_grid_cells_are_exact)
    RUN(unions_of_shaken_cells_are_right_to_eps)
    RUN(rotated_squares_make_the_octagon)
    RUN(slivers_are_left_out_by_their_width)
    RUN(too_little_room_is_told)
TEST_END
