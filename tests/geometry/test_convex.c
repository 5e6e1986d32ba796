/* test_convex: the clipper of convex polygons against the one of all polygons, and what it refuses. */
#define SP_API static
#include <string.h>
#include "../test.h"
#include "../../solvers/base/words.c"

#include <math.h>

#include "../../solvers/geometry/clip.c"

#define sp__clip sp__convex                             /* the two have the same names: only one is ever in a build */
#define sp__clip_carve sp__convex_carve
#define sp__clip_clear sp__convex_clear
#define sp__clip_add sp__convex_add
#define sp__clip_straighten sp__convex_straighten
#define sp__clip_run sp__convex_run
#undef SP__WITH_SMALL
#define SP__WITH_SMALL 1
#include "../../solvers/geometry/convex.c"
#undef sp__clip
#undef sp__clip_carve
#undef sp__clip_clear
#undef sp__clip_add
#undef sp__clip_straighten
#undef sp__clip_run

#define EPS R(TOL(1e-9, 1e-5f))

enum { MANY = 24 };

/* Both, with the same input. */
typedef struct pair { sp__clip all; sp__convex convex; } pair;

static pair *open(void)
{
    pair *c = sp__take(&test_arena, 1, sizeof *c);
    if (!CHECK(c != NULL)) return NULL;
    sp__clip_carve(&c->all, MANY, MANY, MANY * MANY, &test_arena);
    sp__convex_carve(&c->convex, MANY, MANY, &test_arena);
    CHECK(!sp__failed(&test_arena));
    return c;
}

static void clear(pair *c)
{
    sp__clip_clear(&c->all);
    sp__convex_clear(&c->convex);
}

/* Add the polygon xy[0..n) from its side `first` on: where it starts must not matter, nor the order of segments. */
static void add(pair *c, int32_t side, int32_t n, sp_real (*xy)[2], int32_t first)
{
    for (int32_t i = 0; i < n; i++) {
        const int32_t k = (first + 5 * i) % n, m = (k + 1) % n;     /* n is no multiple of 5 */
        sp__clip_add(&c->all, side, xy[k], xy[m], k, m);
        sp__convex_add(&c->convex, side, xy[(first + i) % n]);
    }
}

/* A convex polygon: n points of an ellipse, from angle `from` on. */
static void ellipse(sp_real (*xy)[2], int32_t n, double from, const double centre[2], double a, double b)
{
    for (int32_t k = 0; k < n; k++) {
        const double at = from + 6.283185307179586 * k / n;
        xy[k][0] = R(centre[0] + a * cos(at));
        xy[k][1] = R(centre[1] + b * sin(at));
    }
}

static double area(int32_t from, int32_t to, const sp_real *(*at)(const pair *, int32_t), const pair *c)
{
    double a = 0;
    const sp_real *o = at(c, from);
    for (int32_t k = from; k < to; k++) {
        const sp_real *p = at(c, k), *q = at(c, k + 1 < to ? k + 1 : from);
        a += ((double)p[0] - (double)o[0]) * ((double)q[1] - (double)o[1])
           - ((double)p[1] - (double)o[1]) * ((double)q[0] - (double)o[0]);
    }
    return a / 2;
}

static const sp_real *at_all(const pair *c, int32_t k) { return c->all.corner[k].x; }
static const sp_real *at_convex(const pair *c, int32_t k) { return c->convex.corner[k]; }

/* The two agree: the same corners in turn, so the same region. */
static int agree(const pair *c, double tol)
{
    const int32_t n = c->convex.corners;
    if (!CHECK_INT(c->convex.bent, 0) || !CHECK_INT(c->convex.loops, c->all.loops)) return 0;
    if (!c->all.loops) return 1;
    const double want = area(0, c->all.loop[1], at_all, c);
    if (!CHECK_WITHIN(area(c->convex.loop[0], c->convex.loop[1], at_convex, c), want, tol)) return 0;
    if (!CHECK_INT(n, c->all.corners)) return 0;
    for (int32_t turn = 0; turn < n; turn++) {
        int same = 1;
        for (int32_t k = 0; k < n && same; k++) {
            const sp__clip_corner *p = &c->all.corner[(k + turn) % n];
            const sp_real *q = c->convex.corner[k];
            same = fabs((double)(p->x[0] - q[0])) + fabs((double)(p->x[1] - q[1])) < tol;
        }
        if (same) return 1;
    }
    return CHECK(!"the same corners in turn");
}

static int run(pair *c, double thin)
{
    return CHECK(sp__clip_run(&c->all, EPS, R(thin))) & CHECK(sp__convex_run(&c->convex, EPS, R(thin)));
}

TEST(convex_polygons_have_the_common_corners_that_any_polygons_have)
{
    static const int32_t sides[] = { 3, 4, 6, 7, 8, 11, 12 };
    pair *c = open();
    sp_real p[MANY][2], q[MANY][2];
    int32_t some = 0;
    NEED(c != NULL);
    for (int round = 0; round < 400; round++) {
        const int32_t n = sides[test_random_int(0, 6)], m = sides[test_random_int(0, 6)];
        const double o[2] = { 0, 0 }, far[2] = { (double)test_random_real(-2, 2), (double)test_random_real(-2, 2) };
        ellipse(p, n, (double)test_random_real(0, 6), o, 1, (double)test_random_real(0.3, 1));
        ellipse(q, m, (double)test_random_real(0, 6), far, (double)test_random_real(0.3, 3), (double)test_random_real(0.3, 1));
        clear(c);
        add(c, 0, n, p, test_random_int(0, n - 1));
        add(c, 1, m, q, test_random_int(0, m - 1));
        if (!run(c, 0.02) || !agree(c, TOL(1e-7, 1e-2))) return;
        some += c->convex.loops;
    }
    CHECK(some > 100);
}

/* Rectangles on a small grid, each side in several pieces: shared sides, corners and corners on sides everywhere, then shaken
 * below eps. */
static void grid(double shake)
{
    pair *c = open();
    sp_real xy[MANY][2];
    int32_t some = 0;
    NEED(c != NULL);
    for (int round = 0; round < 400; round++) {
        clear(c);
        for (int side = 0; side < 2; side++) {
            const int x = test_random_int(0, 3), y = test_random_int(0, 3), w = test_random_int(1, 3), h = test_random_int(1, 3);
            int32_t n = 0;
            for (int k = 0; k < w; k++) { xy[n][0] = R(x + k); xy[n++][1] = R(y); }
            for (int k = 0; k < h; k++) { xy[n][0] = R(x + w); xy[n++][1] = R(y + k); }
            for (int k = 0; k < w; k++) { xy[n][0] = R(x + w - k); xy[n++][1] = R(y + h); }
            for (int k = 0; k < h; k++) { xy[n][0] = R(x); xy[n++][1] = R(y + h - k); }
            for (int32_t k = 0; k < n; k++) for (int d = 0; d < 2; d++) xy[k][d] += R(shake * (double)test_random_real(-1, 1));
            for (int32_t k = 0; k < n; k++) {
                sp__clip_add(&c->all, side, xy[k], xy[(k + 1) % n], k, (k + 1) % n);
                sp__convex_add(&c->convex, side, xy[k]);
            }
        }
        if (!run(c, 0.02) || !agree(c, 100 * (double)EPS)) return;
        some += c->convex.loops;
    }
    CHECK(some > 100);
}

TEST(shared_sides_and_corners_are_as_those_of_any_polygons) { grid(0); }

TEST(shaken_below_eps_they_still_are) { grid(0.1 * (double)EPS); }

/* Sides of a needle, eps wide as lines are here, part only far beyond its tip: nothing out there is common. */
TEST(nothing_is_common_beyond_the_tip_of_a_needle)
{
    sp_real square[4][2] = { { -2, -2 }, { 2, -2 }, { 2, 2 }, { -2, 2 } };
    int found = 0;
    for (int k = 0; k < 200; k++) {
        const double turn = 0.031 * k, width = (double)EPS * (0.25 + 0.05 * (k % 80)), c = cos(turn), d = sin(turn);
        const double u[3] = { -0.5, 0.5, 0.5 }, v[3] = { 0, -0.2 * width, 0.8 * width };
        sp_real needle[3][2];
        test_arena.used = 0;
        pair *p = open();
        if (!p) return;
        clear(p);
        for (int i = 0; i < 3; i++) {
            needle[i][0] = R(c * u[i] - d * v[i]);
            needle[i][1] = R(d * u[i] + c * v[i]);
        }
        for (int i = 0; i < 4; i++) sp__convex_add(&p->convex, 0, square[i]);
        for (int i = 0; i < 3; i++) sp__convex_add(&p->convex, 1, needle[i]);
        CHECK(sp__convex_run(&p->convex, EPS, 0));
        for (int32_t i = 0; i < p->convex.corners; i++)
            for (int q = 0; q < 2; q++) CHECK(sp__abs(p->convex.corner[i][q]) <= R(0.5) + 4 * EPS);
        found += p->convex.corners > 2;
    }
    CHECK(found > 0);
}

TEST(what_is_not_one_convex_polygon_is_told)
{
    sp_real square[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, ell[6][2] = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 },
                                                                                     { 0, 3 } };
    sp_real hole[4][2] = { { R(0.2), R(0.2) }, { R(0.2), R(0.8) }, { R(0.8), R(0.8) }, { R(0.8), R(0.2) } };
    sp_real other[4][2] = { { 2, 0 }, { 3, 0 }, { 3, 1 }, { 2, 1 } };
    pair *c = open();
    NEED(c != NULL);
    for (int side = 0; side < 2; side++)
        for (int k = 0; k < 4; k++) {
            clear(c);
            if (side) add(c, 0, 4, square, 0);
            if (k == 0) add(c, side, 6, ell, 0);
            else add(c, side, 4, square, 0);
            if (k == 1) add(c, side, 4, hole, 0);
            if (k == 2) add(c, side, 4, other, 0);
            if (!side) add(c, 1, 4, square, 0);
            NEED(sp__convex_run(&c->convex, EPS, 0));
            CHECK_INT(c->convex.bent, k < 3);
            CHECK_INT(c->convex.loops, k == 3);
        }
}

/* A square and a strip: where either is about as narrow as what is left out, all that they share is kept; else a shared edge of
 * that width is none. */
TEST(what_is_as_narrow_as_an_edge_itself_is_kept)
{
    static const struct { double low, high; int first, kept; } row[] = {
        { 0, 0.04, 0, 1 }, { 0, 0.04, 1, 1 }, { 0, 1, 0, 1 }, { 0.98, 3, 0, 0 }, { 0.9, 3, 1, 1 }
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const sp_real low = R(row[k].low), high = R(row[k].high);
        sp_real square[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
        sp_real strip[4][2] = { { 0, low }, { 1, low }, { 1, high }, { 0, high } };
        test_arena.used = 0;
        pair *c = open();
        NEED(c != NULL);
        clear(c);
        add(c, row[k].first, 4, square, 0);
        add(c, !row[k].first, 4, strip, 0);
        CHECK(sp__convex_run(&c->convex, EPS, R(0.02)));
        CHECK_INT(c->convex.loops, row[k].kept);
        const double shared = fmin(1, row[k].high) - row[k].low;
        if (row[k].kept) CHECK_WITHIN(area(0, c->convex.corners, at_convex, c), shared, TOL(1e-9, 1e-4));
    }
}

TEST(too_little_room_is_told_and_nothing_is_written_past_it)
{
    pair *c = open();
    sp_real xy[MANY][2];
    const double o[2] = { 0, 0 };
    NEED(c != NULL);
    ellipse(xy, MANY, 0, o, 1, 1);
    clear(c);
    for (int32_t k = 0; k < 3; k++) add(c, 1, MANY, xy, 0);         /* 72 segments, room for 56 */
    CHECK_INT(c->convex.full, 1);
    CHECK(!sp__convex_run(&c->convex, EPS, 0));
}

TEST_LIST(convex)
    RUN(convex_polygons_have_the_common_corners_that_any_polygons_have)
    RUN(shared_sides_and_corners_are_as_those_of_any_polygons)
    RUN(shaken_below_eps_they_still_are)
    RUN(nothing_is_common_beyond_the_tip_of_a_needle)
    RUN(what_is_not_one_convex_polygon_is_told)
    RUN(what_is_as_narrow_as_an_edge_itself_is_kept)
    RUN(too_little_room_is_told_and_nothing_is_written_past_it)
TEST_END
