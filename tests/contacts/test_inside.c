/* What only parts of the search for contacts show: the frame chosen is the best by the formula wherever blocks stand, a few
 * outermost corners tell the least shadow whatever is in the memory behind them, faces go by size, an edge is cut into shorter
 * ones, and hulls tell equal points apart by their numbers. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/contacts/find.c"

#include <math.h>

#ifndef SP_SMALL

enum { SLABS = 40 };

static sp_scene scene;
static sp__touch touch;

#include "boxes.h"

static void open_scene(int32_t blocks)
{
    const sp_capacity cap = { blocks, 128 * blocks, 128 * blocks, 512 * blocks, 8, 64, 0 };
    CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
}

static void find_patches(void)
{
    memset(&touch, 0, sizeof touch);
    touch.scene = &scene;
    touch.set = sp_contact_settings_default();
    sp__contact_arrays_carve(&touch.all, &scene, &test_arena);
    sp__touch_blocks(&touch, &test_arena);
    CHECK_INT(touch.status, SP_OK);
}

/* A box about `at` with half widths along n and two axes across. */
static void slab(const sp_real at[3], const sp_real n[3], const sp_real half[3])
{
    static const int32_t sides[6] = { 4, 4, 4, 4, 4, 4 };
    static const int32_t corner[24] = { 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7 };
    sp_real axis[3][3], xyz[24];
    sp__unit3(n, axis[2]);
    sp__across3(axis[2], axis[0]);
    sp__cross3(axis[2], axis[0], axis[1]);
    for (int v = 0; v < 8; v++)
        for (int i = 0; i < 3; i++) {
            const int q = v % 4;
            xyz[3 * v + i] = at[i] + (q == 1 || q == 2 ? 1 : -1) * half[0] * axis[0][i]
                           + (q > 1 ? 1 : -1) * half[1] * axis[1][i] + (v > 3 ? 1 : -1) * half[2] * axis[2][i];
        }
    const sp_mesh mesh = { 8, 6, xyz, sides, corner };
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 0, NULL), SP_OK);
}

/* Slabs one on another along n, each tilted by up to `tilt`, thick or thin, all of them `away`. */
static void pile(int32_t slabs, double tilt, double thick, const double away[3])
{
    sp_real n[3], m[3], at[3], half[3];
    open_scene(slabs);
    for (int i = 0; i < 3; i++) n[i] = test_random_real(0.2, 1);
    sp__unit3(n, n);
    for (int32_t k = 0; k < slabs; k++) {
        for (int i = 0; i < 3; i++) {
            at[i] = R(away[i]) + R(3 * thick * ((7 * k + 3) % slabs)) * n[i];
            m[i] = n[i] + test_random_real(-tilt, tilt);
            half[i] = R(i == 2 ? thick : 1);
        }
        slab(at, m, half);
    }
    find_patches();
    sp__tree_build(&touch);
}

/* The best frame of some blocks' faces, if it has less than half the share of x, y, z. */
static int best_frame(sp_real best[3][3])
{
    const sp__tree *tree = &touch.all.tree;
    double least = share_of(best) / 2;
    int better = 0;
    for (int32_t l = 0; l < tree->leaves; l += tree->leaves / 8 + 1) {
        const sp__body *b = &touch.all.body[tree->leaf[l]];
        for (int32_t p = b->patch; p < b->patch + b->patches && p < b->patch + 6; p++) {
            sp_real axis[3][3];
            sp__frame_of(&touch, &touch.all.patch[p], axis);
            CHECK_NEAR(sp__frame_share(&touch, axis), share_of(axis), TOL(1e-9, 1e-3));
            if (!(share_of(axis) < least)) continue;
            least = share_of(axis);
            memcpy(best, axis, 3 * sizeof *best);
            better = 1;
        }
    }
    return better;
}

TEST(the_best_frame_of_all_is_chosen_wherever_blocks_stand)
{
    const double away[3][3] = { { 0, 0, 0 }, { 30, -8, 2 }, { -20, 40, 9 } };
    int turned = 0;
    for (int k = 0; k < 30; k++) {
        sp_real best[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
        test_renew();
        pile(test_random_int(1, SLABS), k % 5 * 0.1, k % 2 ? 0.02 : 0.2, away[k % 3]);
        const int better = best_frame(best);
        CHECK_INT(sp__frame_choose(&touch), better);
        if (better) CHECK_NEAR(share_of(touch.all.tree.axis), share_of(best), TOL(1e-9, 1e-3));
        turned += better;
    }
    CHECK(turned > 5 && turned < 28);
}

TEST(the_box_of_everything_holds_all_boxes_and_no_more)
{
    const double away[3] = { 5, 6, 7 };
    pile(20, 0.3, 0.1, away);
    for (int c = 0; c < 3; c++) {
        sp_real lo = touch.all.body[0].lo[c], hi = touch.all.body[0].hi[c];
        for (int32_t i = 1; i < 20; i++) {
            lo = touch.all.body[i].lo[c] < lo ? touch.all.body[i].lo[c] : lo;
            hi = sp__max(hi, touch.all.body[i].hi[c]);
        }
        CHECK_WITHIN(touch.all.tree.lo[c], lo, TOL(1e-5, 1e-3));
        CHECK_WITHIN(touch.all.tree.hi[c], hi, TOL(1e-5, 1e-3));
    }
}

TEST(the_noise_of_a_block_is_16_roundings_of_its_reach_and_its_diameter)
{
    const double away[3] = { 5, -600, 7 };
    pile(8, 0.3, 0.1, away);
    for (int32_t b = 0; b < 8; b++) {
        const sp_block *k = &scene.block[b];
        double reach = 0;
        for (int32_t v = k->vertex; v < k->vertex + k->vertices; v++)
            for (int i = 0; i < 3; i++) reach = fmax(reach, fabs((double)scene.vertex[v][i]));
        CHECK_NEAR(touch.all.body[b].noise, 16 * (double)SP_EPSILON * (reach + (double)k->diameter), TOL(1e-12, 1e-5));
    }
}

TEST(a_face_is_in_front_of_a_plane_where_one_of_its_corners_is)
{
    const double away[3] = { 0, 0, 0 };
    int32_t before = 0;
    pile(8, 0.3, 0.1, away);
    for (int k = 0; k < 400; k++) {
        const int32_t f = test_random_int(0, scene.count.faces - 1);
        const sp_real flat = test_random_real(0, 0.2);
        sp__patch p;
        int one = 0;
        memset(&p, 0, sizeof p);
        for (int i = 0; i < 3; i++) { p.n[i] = test_random_real(-1, 1); p.o[i] = test_random_real(-1, 1); }
        for (int32_t c = scene.face[f].corner; c < scene.face[f].corner + scene.face[f].corners; c++) {
            sp_real d[3];
            sp__sub3(scene.vertex[scene.corner[c]], p.o, d);
            one |= sp__dot3(d, p.n) > flat;
        }
        CHECK_INT(sp__face_before_plane(&touch, f, &p, flat), one);
        before += one;
    }
    CHECK(before > 50 && before < 350);
}

/* An eighth of the distance up to the default one; of a larger one half of what is above. */
TEST(the_tolerance_of_a_plane_follows_the_distance)
{
    const double away[3] = { 0, 0, 0 }, times[] = { 0.5, 1, 1.5, 3, 1000 };
    pile(1, 0, 0.1, away);
    sp__body body = touch.all.body[0];
    for (int k = 0; k < 5; k++) {
        const double usual = 1e-6 * (double)scene.block[0].diameter, fine = usual / (k ? 8 : 16);
        body.noise = 0;
        body.reach = R(times[k] * usual);
        CHECK_NEAR(sp__plane_tolerance(&touch, &body), fmax(fine, (times[k] * usual - 8 * fine) / 2), TOL(1e-9, 1e-4));
    }
}

/* What follows a place in memory is none of its coordinates. */
TEST(a_place_on_the_curve_has_three_coordinates)
{
    const sp_real all_lo[4] = { 0, 0, 0, 0 }, all_hi[4] = { 1, 1, 1, 1 }, lo[4] = { 0, 0, 0, 1 }, hi[4] = { 0, 0, 0, 1 };
    CHECK_INT(sp__morton(lo, hi, all_lo, all_hi), 0);
}

/* A prism over a polygon of n corners on a circle, about (x, y). */
static void drum(int32_t n, double r, double x, double y)
{
    sp_real xyz[128][3];
    int32_t size[66], corner[384], at = 0;
    for (int32_t k = 0; k < 2 * n; k++) {
        xyz[k][0] = R(x + r * cos(6.283185307179586 * (k % n) / n));
        xyz[k][1] = R(y + r * sin(6.283185307179586 * (k % n) / n));
        xyz[k][2] = R(k < n ? -r : r);
    }
    for (int32_t k = 0; k < n; k++) {
        const int32_t m = (k + 1) % n, side[4] = { k, m, n + m, n + k };
        size[k] = 4;
        for (int i = 0; i < 4; i++) corner[at++] = side[i];
    }
    for (int32_t k = 0; k < 2 * n; k++) corner[at++] = k < n ? n - 1 - k : k;
    size[n] = size[n + 1] = n;
    const sp_mesh mesh = { 2 * n, n + 2, xyz[0], size, corner };
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 0, NULL), SP_OK);
}

/* The memory that corners are kept in names a vertex that is far off; there are more axes than there is room for corners. */
TEST(what_memory_holds_does_not_tell_the_least_shadow)
{
    for (int k = 0; k < 12; k++) {
        const sp_real far[3] = { 900, 800, 700 }, n[3] = { 0, 0, 1 }, half[3] = { 1, 1, 1 };
        sp_real least = SP__HUGE;
        test_renew();
        open_scene(3);
        drum(64 - k, 1, 0, 0);
        drum(63 - k % 2, 1.01, 1e-3 * (k % 3), 1e-4 * (k % 4));
        slab(far, n, half);
        find_patches();
        sp__pair_start(&touch, 1);
        const int32_t patches = touch.all.body[2].patch;
        for (int32_t p = 0; p < patches; p++) {
            const sp_real x = sp__shadow(&touch, touch.all.patch[p].n);
            if (x < least) least = x;
        }
        for (int32_t e = 0; e < 6 * 62; e++) touch.all.edge[e][0] = touch.all.edge[e][1] = scene.block[2].vertex;
        CHECK(sp__shadow_faces(&touch, R(-9)) == least);
    }
}

TEST(faces_go_by_size_and_those_of_one_size_by_place)
{
    for (int k = 0; k < 20; k++) {
        test_renew();
        open_scene(1);
        drum(test_random_int(3, 32), 1, 0, 0);
        find_patches();
        touch.patches = 0;
        sp__touch_group(&touch, &touch.all.body[0], scene.block[0].faces);
        for (int32_t i = 1; i < scene.block[0].faces; i++) {
            const int32_t f = touch.all.order[i - 1], g = touch.all.order[i];
            CHECK(touch.all.area[f] >= touch.all.area[g]);
            if (touch.all.area[f] > touch.all.area[g]) continue;
            CHECK(sp__place_order(touch.all.middle[f], touch.all.middle[g], 0) < 0);
        }
    }
}

enum { SQUARES = 10, FACES = 6 * SQUARES * SQUARES + 1 };

static struct { sp_real xyz[5 * FACES][3]; int32_t size[FACES], corner[5 * FACES], corners, faces; } made;

static void corner_at(double x, double y, double z)
{
    made.xyz[made.corners][0] = R(x);
    made.xyz[made.corners][1] = R(y);
    made.xyz[made.corners][2] = R(z);
    made.corner[made.corners] = made.corners;
    made.corners++;
    made.size[made.faces]++;
}

/* A unit cube whose sides are many squares. Between two of its top lies a sliver, up to m, which stands steeply. */
static void cube_with_a_sliver(double wide, double high)
{
    const double h = 1.0 / SQUARES, m[3] = { 5 * h - wide, 4.5 * h, 1 + high };
    memset(&made, 0, sizeof made);
    for (int32_t k = 0; k < FACES - 1; k++, made.faces++) {
        const int side = k % 2, c = k / 2 % 3, i = k / 6 % SQUARES, j = k / 6 / SQUARES;
        for (int v = 0; v < 4; v++) {
            const int q = side ? v : 3 - v;
            double x[3];
            x[c] = side;
            x[(c + 1) % 3] = h * (i + (q == 1 || q == 2));
            x[(c + 2) % 3] = h * (j + (q > 1));
            corner_at(x[0], x[1], x[2]);
            if (c == 2 && side && i == 4 && j == 4 && v == 1) corner_at(m[0], m[1], m[2]);
        }
    }
    corner_at(h * 5, h * 4, 1);
    corner_at(h * 5, h * 5, 1);
    corner_at(m[0], m[1], m[2]);
    made.faces++;
    const sp_mesh mesh = { made.corners, made.faces, made.xyz[0], made.size, made.corner };
    CHECK_INT(sp_scene_block(&scene, &mesh, R(2400), 0, NULL), SP_OK);
}

/* Half the distance is the tolerance of a plane. */
TEST(a_sliver_that_keeps_to_a_plane_belongs_to_it_however_steep)
{
    const sp_capacity cap = { 1, 5 * FACES, FACES, 5 * FACES, 8, 64, 0 };
    for (int k = 0; k < 2; k++) {
        test_renew();
        CHECK_INT(sp_scene_create(&scene, &cap, &test_arena), SP_OK);
        cube_with_a_sliver(2e-3, k ? 8e-3 : 4.9e-3);
        memset(&touch, 0, sizeof touch);
        touch.scene = &scene;
        touch.set = sp_contact_settings_default();
        touch.set.distance = R(1e-2);
        touch.set.absolute = 1;
        sp__contact_arrays_carve(&touch.all, &scene, &test_arena);
        sp__touch_blocks(&touch, &test_arena);
        CHECK_INT(touch.status, SP_OK);
        CHECK_INT(touch.all.body[0].patches, k ? 7 : 6);    /* too high: with what it is of */
    }
}

/* Nodes a little more than eps from an edge a few eps long. */
TEST(a_node_on_an_edge_cuts_it_into_shorter_ones)
{
    int32_t cut = 0;
    sp__clip c;
    memset(&c, 0, sizeof c);
    sp__clip_carve(&c, 8, 8, 8, &test_arena);
    c.snap = 1;
    const sp__clip_edge e = { 0, 1, { 1, 0 } };
    for (int k = 0; k < 4000; k++) {
        double part[3];
        for (int v = 0; v < 3; v++)
            for (int i = 0; i < 2; i++) c.g.xy[v][i] = test_random_real(-2, 2);
        for (int v = 0; v < 3; v++) {
            const sp_real *p = c.g.xy[v], *q = c.g.xy[(v + 1) % 3];
            part[v] = (double)((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]));
        }
        if (!sp__clip_node_on_edge(&c, &e, 2)) continue;
        CHECK(part[1] <= part[0] && part[2] <= part[0]);
        cut++;
    }
    CHECK(cut > 100);
}

/* Of a thousand places along it the nearest one is as far, to its step. */
TEST(a_place_is_as_far_from_a_segment_as_from_its_nearest_point)
{
    for (int k = 0; k < 200; k++) {
        const sp_real a[2] = { 0, 0 }, b[2] = { test_random_real(0.1, 1), test_random_real(-1, 1) };
        const sp_real p[2] = { test_random_real(-2, 2), test_random_real(-2, 2) };
        double least = 1e9;
        for (int i = 0; i <= 1000; i++) {
            const double x = (double)p[0] - i * (double)b[0] / 1000, y = (double)p[1] - i * (double)b[1] / 1000;
            least = fmin(least, sqrt(x * x + y * y));
        }
        CHECK_WITHIN(sqrt((double)sp__clip_distance2(p, a, b)), least, 2e-3);
    }
}

/* From the way back clockwise: what is met first; the way back itself last. */
TEST(ways_on_are_met_in_the_order_of_their_angles)
{
    for (int k = 0; k < 300; k++) {
        const double way = (double)test_random_real(0, 6.28);
        sp_real at[3][2];
        int32_t turn[3] = { 0, test_random_int(1, 24), test_random_int(1, 24) };
        if (turn[1] == turn[2]) continue;
        for (int v = 0; v < 3; v++) {
            const double size = (double)test_random_real(0.5, 2), past = v ? 1e-3 : 0;
            const double angle = way - 6.283185307179586 * turn[v] / 24 - past;
            at[v][0] = R(size * cos(angle));
            at[v][1] = R(size * sin(angle));
            turn[v] %= 24;                              /* just past the way back: first of all */
        }
        CHECK_INT(sp__clip_turns_before(at[0], at[1], at[2]), turn[1] < turn[2]);
        for (int i = 0; i < 2; i++) at[2][i] = 2 * at[0][i];
        CHECK_INT(sp__clip_turns_before(at[0], at[1], at[2]), 1);
        CHECK_INT(sp__clip_turns_before(at[0], at[2], at[1]), 0);
    }
}

/* Twice the area of a triangle of nodes. */
static double turn_of(const sp__clip *c, int i, int j, int k)
{
    const sp_real *a = c->g.xy[i], *b = c->g.xy[j], *p = c->g.xy[k];
    return (double)((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]));
}

/* Those that only point at each other get none, though a node on one of them would do no harm. */
TEST(edges_get_a_node_where_they_cross_and_no_other)
{
    int32_t crossed = 0;
    sp__clip c;
    memset(&c, 0, sizeof c);
    sp__clip_carve(&c, 8, 8, 8, &test_arena);
    c.snap = R(1e-6);
    for (int32_t e = 0; e < 2; e++) { const sp__clip_edge edge = { 2 * e, 2 * e + 1, { 0, 0 } }; c.g.edge[e] = edge; }
    for (int k = 0; k < 500; k++) {
        for (int v = 0; v < 4; v++) for (int i = 0; i < 2; i++) c.g.xy[v][i] = test_random_real(-1, 1);
        const int cross = turn_of(&c, 0, 1, 2) * turn_of(&c, 0, 1, 3) < 0 && turn_of(&c, 2, 3, 0) * turn_of(&c, 2, 3, 1) < 0;
        c.g.nodes = 4;
        sp__clip_cross(&c, 0, 1);
        CHECK_INT(c.g.nodes, 4 + cross);
        if (!cross) continue;
        CHECK_WITHIN(turn_of(&c, 0, 1, 4), 0, TOL(1e-12, 1e-5));
        CHECK_WITHIN(turn_of(&c, 2, 3, 4), 0, TOL(1e-12, 1e-5));
        crossed++;
    }
    CHECK(crossed > 50);
}

/* A square with corners on its sides that it does not need, from any corner on. */
TEST(a_loop_keeps_the_corners_it_needs_and_no_other)
{
    sp__clip c;
    memset(&c, 0, sizeof c);
    sp__clip_carve(&c, 8, 8, 8, &test_arena);
    c.snap = R(1e-6);
    for (int k = 0; k < 200; k++) {
        double xy[16][2];
        int n = 0;
        for (int side = 0; side < 4; side++)
            for (int i = 0, more = test_random_int(0, 3); i <= more; i++, n++) {
                const double x = side == 1 || side == 2, y = side > 1, along = i / (more + 1.0);
                xy[n][0] = x + (side == 0 ? along : side == 2 ? -along : 0);
                xy[n][1] = y + (side == 1 ? along : side == 3 ? -along : 0);
            }
        const int from = test_random_int(0, n - 1);
        c.loops = c.loop[0] = 0;
        c.corners = n;
        for (int v = 0; v < n; v++) for (int i = 0; i < 2; i++) c.corner[v].x[i] = R(xy[(v + from) % n][i]);
        sp__clip_straighten(&c);
        CHECK_INT(c.corners, 4);
    }
}

static int goes_through(const sp__clip *c, double lo, double hi)
{
    const double rim = (hi - lo) / 10;
    int through = 0;
    for (int32_t i = 0; i < c->cut.lines; i++) through |= (double)c->cut.x[i] > lo + rim && (double)c->cut.x[i] < hi - rim;
    return through;
}

/* Holes from lo to hi in any order: lines ascend, and one goes through the inner 8/10 of each. */
TEST(lines_through_holes_ascend_and_leave_none_out)
{
    sp__clip c;
    memset(&c, 0, sizeof c);
    sp__clip_carve(&c, 8, 8, 8, &test_arena);
    for (int k = 0; k < 50; k++) {
        double lo[12], hi[12];
        c.cut.lines = c.loops = c.loop[0] = 0;
        c.corners = 3;
        for (int h = 0; h < 12; h++) {
            const int32_t before = c.cut.lines;
            lo[h] = (double)test_random_real(-9, 9);
            hi[h] = lo[h] + (double)test_random_real(0.1, 1);
            for (int v = 0; v < 3; v++) c.corner[v].x[0] = R(v == 1 ? hi[h] : lo[h]);
            const int there = goes_through(&c, lo[h], hi[h]);
            sp__clip_add_cut(&c);
            CHECK_INT(c.cut.lines - before, !there);
        }
        CHECK_INT(c.full, 0);
        for (int32_t i = 1; i < c.cut.lines; i++) CHECK(c.cut.x[i - 1] < c.cut.x[i]);
        for (int h = 0; h < 12; h++) CHECK(goes_through(&c, lo[h], hi[h]));
    }
}

/* Edges from node 0 to nodes 2 .. 6, after one from node 1. */
TEST(the_edge_to_leave_by_is_the_first_one_clockwise_that_is_not_used)
{
    sp__clip c;
    sp__clip_carve(&c, 8, 8, 8, &test_arena);
    for (int k = 0; k < 200; k++) {
        const double way = (double)test_random_real(0, 6.28);
        int32_t turn[7], first = -1;
        for (int32_t v = 0; v < 7; v++) {
            turn[v] = v < 2 ? 0 : 1 + (7 * v + k) % 23;
            for (int i = 0; i < 2; i++) {
                const double angle = way - 6.283185307179586 * turn[v] / 24;
                c.g.xy[v][i] = R(3 + (v ? (i ? sin(angle) : cos(angle)) : 0));
            }
        }
        for (int32_t e = 0; e < 6; e++) {
            const sp__clip_edge edge = { e ? 0 : 1, e ? e + 1 : 0, { e && test_random_int(0, 2) == 0, 0 } };
            c.g.edge[e] = edge;
            c.g.next[e] = e > 1 ? e - 1 : -1;
            if (e && !edge.w[0] && (first < 0 || turn[e + 1] < turn[first + 1])) first = e;
        }
        c.g.first[0] = 5;
        CHECK_INT(sp__clip_next_edge(&c.g, 0), first);
    }
}

TEST(equal_points_of_a_hull_go_by_number)
{
    static const int32_t order[12] = { 0, 1, 2, 9, 10, 11, 3, 4, 5, 6, 7, 8 };
    sp__hull h;
    sp__hull_carve(&h, 12, &test_arena);
    for (int32_t k = 0; k < 12; k++) {
        h.p[k][0] = k / 3 == 1 || k / 3 == 2;
        h.p[k][1] = k / 6;
    }
    sp__hull_run(&h);
    CHECK_INT(h.corners, 4);
    for (int32_t i = 0; i < 12; i++) CHECK_INT(h.order[i], order[i]);
}

TEST(a_hull_of_three_points_goes_round_them)
{
    sp__hull h;
    sp__hull_carve(&h, 3, &test_arena);
    for (int k = 0; k < 3; k++) {
        for (int v = 0; v < 3; v++) { h.p[(v + k) % 3][0] = v == 1; h.p[(v + k) % 3][1] = v == 2; }
        for (int v = 0; v < 7; v++) h.corner[v] = -1;
        sp__hull_run(&h);
        CHECK_INT(h.corners, 3);
        for (int v = 0; v < 4; v++) {
            static const int32_t round[4] = { 0, 1, 2, 0 };
            CHECK_INT(h.corner[v], (round[v] + k) % 3);
        }
    }
}

/* Shoelace about any place: area, and its middle. */
TEST(a_hull_has_the_area_and_the_middle_of_its_triangles)
{
    sp__hull h;
    sp__hull_carve(&h, 10, &test_arena);
    sp_real far = SP__HUGE;
    for (int i = 0; i < 12; i++) far *= far;
    h.p[9][0] = h.p[9][1] = far;                        /* infinite, no corner; named behind them all the same */
    for (int k = 0; k < 50; k++) {
        double twice = 0, x = 0, y = 0;
        sp_real g[2];
        h.points = 9;
        for (int v = 0; v < 9; v++) for (int i = 0; i < 2; i++) h.p[v][i] = test_random_real(-1, 2);
        sp__hull_run(&h);
        h.corner[h.corners + 1] = 9;
        const sp_real area = sp__hull_area(&h, g);
        for (int32_t i = 0; i < h.corners; i++) {
            const sp_real *p = h.p[h.corner[i]], *q = h.p[h.corner[i + 1]];
            const double t = (double)(p[0] * q[1] - p[1] * q[0]);
            twice += t;
            x += t * (double)(p[0] + q[0]);
            y += t * (double)(p[1] + q[1]);
        }
        CHECK_NEAR(area, twice / 2, TOL(1e-12, 1e-4));
        CHECK_WITHIN(g[0], x / twice / 3, TOL(1e-10, 1e-3));
        CHECK_WITHIN(g[1], y / twice / 3, TOL(1e-10, 1e-3));
    }
}

/* Beside all edges, not only the nearest piece of one. */
TEST(the_clearance_of_a_hull_is_the_least_of_all_its_edges)
{
    sp__hull h;
    sp__hull_carve(&h, 9, &test_arena);
    for (int k = 0; k < 50; k++) {
        const sp_real c[2] = { test_random_real(-1, 2), test_random_real(-1, 2) };
        double least = 1e9;
        h.points = 9;
        for (int v = 0; v < 9; v++) for (int i = 0; i < 2; i++) h.p[v][i] = test_random_real(-1, 2);
        sp__hull_run(&h);
        for (int32_t i = 0; i < h.corners; i++) {
            const sp_real *p = h.p[h.corner[i]], *q = h.p[h.corner[i + 1]];
            const double x = (double)(q[0] - p[0]), y = (double)(q[1] - p[1]);
            least = fmin(least, (x * (double)(c[1] - p[1]) - y * (double)(c[0] - p[0])) / sqrt(x * x + y * y));
        }
        CHECK_WITHIN(sp__hull_clearance(&h, c), least, TOL(1e-12, 1e-5));
    }
}

TEST(a_unit_is_the_largest_power_of_two_that_is_not_above)
{
    double power = 1.0 / 1024 / 1024;
    for (int k = -20; k < 20; k++, power *= 2) {
        CHECK_WITHIN(sp__power_of_two(R(power)), power, 0);
        CHECK_WITHIN(sp__power_of_two(R(1.7 * power)), power, 0);
        CHECK_WITHIN(sp__power_of_two(R(1.999 * power)), power, 0);
    }
}

#endif

TEST_LIST(inside)
#ifndef SP_SMALL
    RUN(the_best_frame_of_all_is_chosen_wherever_blocks_stand)
    RUN(the_box_of_everything_holds_all_boxes_and_no_more)
    RUN(the_noise_of_a_block_is_16_roundings_of_its_reach_and_its_diameter)
    RUN(a_face_is_in_front_of_a_plane_where_one_of_its_corners_is)
    RUN(the_tolerance_of_a_plane_follows_the_distance)
    RUN(a_place_on_the_curve_has_three_coordinates)
    RUN(what_memory_holds_does_not_tell_the_least_shadow)
    RUN(faces_go_by_size_and_those_of_one_size_by_place)
    RUN(a_sliver_that_keeps_to_a_plane_belongs_to_it_however_steep)
    RUN(a_node_on_an_edge_cuts_it_into_shorter_ones)
    RUN(a_place_is_as_far_from_a_segment_as_from_its_nearest_point)
    RUN(ways_on_are_met_in_the_order_of_their_angles)
    RUN(edges_get_a_node_where_they_cross_and_no_other)
    RUN(a_loop_keeps_the_corners_it_needs_and_no_other)
    RUN(lines_through_holes_ascend_and_leave_none_out)
    RUN(the_edge_to_leave_by_is_the_first_one_clockwise_that_is_not_used)
    RUN(equal_points_of_a_hull_go_by_number)
    RUN(a_hull_of_three_points_goes_round_them)
    RUN(a_hull_has_the_area_and_the_middle_of_its_triangles)
    RUN(the_clearance_of_a_hull_is_the_least_of_all_its_edges)
    RUN(a_unit_is_the_largest_power_of_two_that_is_not_above)
#endif
TEST_END
