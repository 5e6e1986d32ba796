/* Placing a stone: support clearance, cost of a seat, resting faces, the next-best-object gate; against brute force. */
#include "../test.h"
#include "../scenes/kinds.h"

#include <math.h>

enum { POINTS = 24 };

static const sp_real down[3] = { 0, 0, R(-9.80665) };

/* Clearance over all ordered pairs of points: (a, b) is an edge line of the hull if no point lies right of it. */
static int brute_clearance(const sp_real *xyz, int32_t n, const sp_real c[3], double *clearance)
{
    int edges = 0;
    for (int32_t a = 0; a < n; a++)
        for (int32_t b = 0; b < n; b++) {
            const double ex = (double)xyz[3 * b] - (double)xyz[3 * a], ey = (double)xyz[3 * b + 1] - (double)xyz[3 * a + 1];
            const double length2 = ex * ex + ey * ey;
            int right = 0;
            if (!(length2 > 0)) continue;
            for (int32_t k = 0; k < n; k++) {
                const double x = (double)xyz[3 * k] - (double)xyz[3 * a], y = (double)xyz[3 * k + 1] - (double)xyz[3 * a + 1];
                right += ex * y - ey * x < 0;
            }
            if (right) continue;
            const double x = (double)c[0] - (double)xyz[3 * a], y = (double)c[1] - (double)xyz[3 * a + 1];
            const double cross = ex * y - ey * x, d2 = cross * (cross < 0 ? -cross : cross) / length2;    /* signed square */
            if (!edges || d2 < *clearance) *clearance = d2;
            edges++;
        }
    return edges;
}

/* Area and centroid by the edges that no point lies right of; for points of which no three are on a line. */
static double brute_area(const sp_real *xyz, int32_t n, double middle[2])
{
    double area = 0;
    middle[0] = middle[1] = 0;
    for (int32_t a = 0; a < n; a++)
        for (int32_t b = 0; b < n; b++) {
            const double ax = (double)xyz[3 * a], ay = (double)xyz[3 * a + 1];
            const double bx = (double)xyz[3 * b], by = (double)xyz[3 * b + 1];
            int right = a == b;
            for (int32_t k = 0; k < n; k++) {
                const double x = (double)xyz[3 * k] - ax, y = (double)xyz[3 * k + 1] - ay;
                right += k != a && k != b && (bx - ax) * y - (by - ay) * x < 0;
            }
            if (right) continue;
            area += (ax * by - ay * bx) / 2;
            middle[0] += (ax + bx) * (ax * by - ay * bx) / 6;
            middle[1] += (ay + by) * (ax * by - ay * bx) / 6;
        }
    for (int k = 0; k < 2; k++) middle[k] /= area;
    return area;
}

static void random_points(sp_real *xyz, int32_t n, int grid)
{
    for (int32_t i = 0; i < n; i++) {
        for (int k = 0; k < 2; k++)
            xyz[3 * i + k] = grid ? R(test_random_int(-4, 4)) / 4 : test_random_real(-1, 1);
        xyz[3 * i + 2] = test_random_real(-1, 1);
    }
}

TEST(clearance_is_that_of_all_pairs_of_points_in_10000_random_supports)
{
    int32_t inside = 0, flat = 0;
    for (int run = 0; run < 10000; run++) {
        sp_real xyz[3 * POINTS];
        const int32_t n = test_random_int(1, run % 2 ? 6 : POINTS);
        const sp_real com[3] = { test_random_real(-1, 1), test_random_real(-1, 1), 2 };
        sp_support s;
        double want = 0;
        random_points(xyz, n, run % 3 == 0);
        CHECK_INT(sp_support_clearance(xyz, n, com, down, test_arena, &s), SP_OK);
        brute_clearance(xyz, n, com, &want);
        if (!(s.area > 0)) {                            /* all on a line: brute force sees two edges back to back */
            flat++;
            CHECK(s.clearance <= R(-1) && s.clearance >= R(-1));
            continue;
        }
        const double got2 = (double)s.clearance * (double)(s.clearance < 0 ? -s.clearance : s.clearance);
        if (!CHECK_WITHIN(got2, want, TOL(1e-13, 3e-6))) return;
        inside += s.clearance > 0;
    }
    CHECK(inside > 1000 && inside < 9000);
    CHECK(flat > 100 && flat < 4000);
}

TEST(clearance_of_a_unit_square)
{
    const sp_real square[] = { 0, 0, 5, 1, 0, 5, 1, 1, 5, 0, 1, 5, R(0.5), 0, 5, 1, 1, 5, R(0.25), R(0.5), 5 };
    const sp_real com[3] = { R(0.75), R(0.5), 9 }, out[3] = { R(1.5), R(0.5), 0 };
    sp_support s;
    CHECK_INT(sp_support_clearance(square, 7, com, down, test_arena, &s), SP_OK);
    CHECK_NEAR(s.clearance, 0.25, TOL(1e-15, 1e-6));
    CHECK_NEAR(s.area, 1, TOL(1e-15, 1e-6));
    CHECK_NEAR(s.offset, 0.25, TOL(1e-15, 1e-6));
    CHECK_INT(sp_support_clearance(square, 7, out, down, test_arena, &s), SP_OK);
    CHECK_NEAR(s.clearance, -0.5, TOL(1e-15, 1e-6));
}

TEST(support_without_area_reads_minus_one)
{
    const sp_real line[] = { 0, 0, 0, 1, 1, 0, 2, 2, 0, R(0.3), R(0.3), 0 }, com[3] = { 1, 1, 1 };
    const sp_real far_line[] = { R(0.1), R(0.2), 0, R(0.4), R(0.8), 0, R(0.7), R(1.4), 0 };
    for (int32_t n = 0; n <= 4; n++) {
        sp_support s;
        CHECK_INT(sp_support_clearance(line, n, com, down, test_arena, &s), SP_OK);
        CHECK_WITHIN(s.clearance, -1, 0);
        CHECK_WITHIN(s.area, 0, 0);
        CHECK_NEAR(s.offset, 1e9, 1e-7);
    }
    sp_support s;
    CHECK_INT(sp_support_clearance(far_line, 3, com, down, test_arena, &s), SP_OK);
    CHECK_WITHIN(s.clearance, -1, 0);
}

/* Turn by quaternion-free means: a rotation about (1, 1, 1) by 120 degrees permutes the axes, exactly. */
TEST(clearance_follows_gravity_units_and_origin)
{
    for (int run = 0; run < 200; run++) {
        sp_real xyz[3 * POINTS], turned[3 * POINTS];
        const sp_real com[3] = { test_random_real(-1, 1), test_random_real(-1, 1), 1 }, cyc[3] = { com[2], com[0], com[1] };
        const sp_real side[3] = { R(-1), 0, 0 };
        sp_support s, t;
        random_points(xyz, POINTS, 0);
        for (int i = 0; i < POINTS; i++)
            for (int k = 0; k < 3; k++) turned[3 * i + (k + 1) % 3] = xyz[3 * i + k];
        CHECK_INT(sp_support_clearance(xyz, POINTS, com, down, test_arena, &s), SP_OK);
        CHECK_INT(sp_support_clearance(turned, POINTS, cyc, side, test_arena, &t), SP_OK);
        CHECK_WITHIN(t.clearance, s.clearance, TOL(1e-14, 1e-6));
        CHECK_WITHIN(t.area, s.area, TOL(1e-14, 1e-6));
        CHECK_WITHIN(t.offset, s.offset, TOL(1e-14, 1e-6));
        for (int i = 0; i < 3 * POINTS; i++) turned[i] = R(1024) * xyz[i];
        const sp_real large[3] = { R(1024) * com[0], R(1024) * com[1], R(1024) * com[2] };
        CHECK_INT(sp_support_clearance(turned, POINTS, large, down, test_arena, &t), SP_OK);
        CHECK_WITHIN(t.clearance, R(1024) * s.clearance, 0);
    }
}

TEST(support_refuses_bad_input)
{
    const sp_real xyz[] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 }, zero[3] = { 0, 0, 0 }, com[3] = { 0, 0, 1 };
    sp_real bad[] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
    sp_support s;
    CHECK_INT(sp_support_clearance(NULL, 3, com, down, test_arena, &s), SP_E_ARGUMENT);
    CHECK_INT(sp_support_clearance(xyz, -1, com, down, test_arena, &s), SP_E_ARGUMENT);
    CHECK_INT(sp_support_clearance(xyz, 3, com, down, test_arena, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_support_clearance(xyz, 3, com, zero, test_arena, &s), SP_E_RANGE);
    bad[4] /= zero[0];
    CHECK_INT(sp_support_clearance(bad, 3, com, down, test_arena, &s), SP_E_NOT_FINITE);
    bad[4] = TOL(1e200, 1e30f);
    CHECK_INT(sp_support_clearance(bad, 3, com, down, test_arena, &s), SP_E_NOT_FINITE);
    CHECK_INT(sp_support_memory(-1), 0);
    sp_arena exact = test_arena;
    exact.capacity = exact.used + sp_support_memory(3);
    CHECK_INT(sp_support_clearance(xyz, 3, com, down, exact, &s), SP_OK);
    exact.capacity--;
    CHECK_INT(sp_support_clearance(xyz, 3, com, down, exact, &s), SP_E_MEMORY);
}

/* One block on point contacts in a level plane: it stands if its centre of mass is over their hull. */
static sp_verdict on_points(const sp_real *xyz, int32_t n, const sp_real com[3])
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, POINTS, 0 };
    const sp_real ground[3] = { 0, 0, R(-2) }, up[3] = { 0, 0, 1 };
    const sp_strength strength = sp_strength_friction(R(0.84));
    sp_arena a = test_arena;
    sp_scene scene;
    sp_result r;
    if (sp_scene_create(&scene, &cap, &a) || sp_scene_body(&scene, 1, ground, SP_FIXED, NULL) ||
        sp_scene_body(&scene, 1, com, 0, NULL) || sp_scene_points(&scene, 0, 1, up, n, xyz, &strength, NULL) ||
        sp_check(&scene, NULL, &a, &r)) return SP_UNDECIDED;
    return r.verdict;
}

TEST(no_gate_says_no_where_the_statics_say_stable)
{
    int32_t stands = 0, falls = 0;
    for (int run = 0; run < 400; run++) {
        sp_real xyz[3 * POINTS];
        const int32_t n = test_random_int(3, 7);
        const sp_real com[3] = { test_random_real(-0.7, 0.7), test_random_real(-0.7, 0.7), test_random_real(0.2, 2) };
        sp_support s;
        random_points(xyz, n, 0);
        for (int32_t i = 0; i < n; i++) xyz[3 * i + 2] = 0;
        CHECK_INT(sp_support_clearance(xyz, n, com, down, test_arena, &s), SP_OK);
        const sp_verdict v = on_points(xyz, n, com);
        if (v == SP_STABLE) CHECK(s.clearance > TOL(-1e-8, -1e-3)), stands++;
        if (v == SP_UNSTABLE) CHECK(s.clearance < TOL(1e-8, 1e-3)), falls++;
    }
    CHECK(stands > 40 && falls > 100);
}

static const sp_seat seat = { { R(0.1), R(0.5), R(0.2) }, 2, R(0.4), R(0.8), R(0.16), R(1.2) };

TEST(cost_of_a_seat_has_four_terms)
{
    const sp_seat_weights each[4] = { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } };
    const double want[4] = { 0.75, 0.25, 0.2, 1.5 };
    sp_real J = 0;
    for (int k = 0; k < 4; k++) {
        CHECK_INT(sp_support_cost(&seat, &each[k], &J), SP_OK);
        CHECK_NEAR(J, want[k], TOL(1e-14, 1e-6));
    }
    CHECK_INT(sp_support_cost(&seat, NULL, &J), SP_OK);
    CHECK_NEAR(J, 0.75 + 0.25 + 0.2 + 0.5 * 1.5, TOL(1e-14, 1e-6));
}

TEST(cost_refuses_a_stone_without_size)
{
    sp_real J = R(7);
    sp_seat s = seat;
    s.footprint = 0;
    CHECK_INT(sp_support_cost(&s, NULL, &J), SP_E_RANGE);
    s = seat; s.height = R(-1);
    CHECK_INT(sp_support_cost(&s, NULL, &J), SP_E_RANGE);
    s = seat; s.trapped = R(-1);
    CHECK_INT(sp_support_cost(&s, NULL, &J), SP_E_RANGE);
    s = seat; s.seat = s.support.offset / (s.support.area - s.support.area);
    CHECK_INT(sp_support_cost(&s, NULL, &J), SP_E_NOT_FINITE);
    const sp_seat_weights minus = { 1, R(-1), 1, 1 };
    CHECK_INT(sp_support_cost(&seat, &minus, &J), SP_E_RANGE);
    CHECK_INT(sp_support_cost(NULL, NULL, &J), SP_E_ARGUMENT);
    CHECK_WITHIN(J, 7, 0);
}

TEST(seats_are_ordered_stable_first_then_by_cost_then_by_number)
{
    enum { SEATS = 40 };
    sp_seat s[SEATS];
    sp_real J[SEATS];
    int32_t order[SEATS], stable = -1, count = 0;
    for (int k = 0; k < SEATS; k++) {
        s[k] = seat;
        s[k].support.clearance = R(test_random_int(-3, 3)) / 8;
        s[k].seat = R(test_random_int(0, 5));
        count += s[k].support.clearance >= R(0.125);
    }
    CHECK_INT(sp_support_rank(s, SEATS, R(0.125), NULL, J, order, &stable), SP_OK);
    CHECK_INT(stable, count);
    for (int k = 0; k + 1 < SEATS; k++) {
        const int32_t i = order[k], j = order[k + 1];
        CHECK((s[i].support.clearance >= R(0.125)) == (k < count));
        if (k + 1 == count) continue;
        CHECK(J[i] < J[j] || (!(J[i] > J[j]) && i < j));
    }
    CHECK_INT(sp_support_rank(s, -1, 0, NULL, J, order, NULL), SP_E_ARGUMENT);
    CHECK_INT(sp_support_rank(NULL, 0, 0, NULL, NULL, NULL, &stable), SP_OK);
    CHECK_INT(stable, 0);
}

/* J as it is written, from the points alone. */
static double brute_cost(const sp_seat *s, const sp_seat_weights *w, double area, double offset)
{
    const double A = (double)s->footprint, h = (double)s->height, W = (double)s->width;
    return (double)w->area * (1 - area / A) + (double)w->offset * offset / W + (double)w->trapped * (double)s->trapped / (A * h)
         + (double)w->seat * (double)s->seat / W;
}

/* 250 choices among 40 seats on random points; J, who has the margin and the order by brute force from the points. */
TEST(cost_and_order_of_10000_random_seats_are_those_of_brute_force)
{
    enum { SEATS = 40 };
    for (int run = 0; run < 250; run++) {
        const sp_seat_weights defaults = sp_seat_weights_default(), mixed = { test_random_real(0, 2), test_random_real(0, 2),
                                                                             test_random_real(0, 2), test_random_real(0, 2) };
        const sp_seat_weights *w = run % 2 ? &mixed : &defaults;
        const double margin = run % 5 ? (double)test_random_real(-0.5, 0.5) : 0;
        sp_seat s[SEATS];
        sp_real J[SEATS];
        double want[SEATS];
        int stands[SEATS], seen[SEATS] = { 0 }, count = 0;
        int32_t order[SEATS], stable;
        for (int k = 0; k < SEATS; k++) {
            sp_real xyz[3 * POINTS], alone;
            const int32_t n = test_random_int(3, 12);
            const sp_real com[3] = { test_random_real(-1, 1), test_random_real(-1, 1), 2 };
            double middle[2], clear2 = 0;
            random_points(xyz, n, 0);
            CHECK_INT(sp_support_clearance(xyz, n, com, down, test_arena, &s[k].support), SP_OK);
            s[k].footprint = test_random_real(2, 6); s[k].height = test_random_real(0.1, 2); s[k].width = test_random_real(0.1, 2);
            s[k].trapped = test_random_real(0, 1); s[k].seat = test_random_real(-3, 3);
            const double area = brute_area(xyz, n, middle), dx = (double)com[0] - middle[0], dy = (double)com[1] - middle[1];
            want[k] = brute_cost(&s[k], w, area, sqrt(dx * dx + dy * dy));
            CHECK_INT(sp_support_cost(&s[k], w, &alone), SP_OK);
            if (area > 1e-3 && !CHECK_WITHIN(alone, want[k], TOL(1e-10, 2e-2) * (1 + fabs(want[k])))) return;
            want[k] = (double)alone;
            brute_clearance(xyz, n, com, &clear2);
            stands[k] = (double)s[k].support.clearance >= margin;
            if (fabs(clear2 - margin * fabs(margin)) > TOL(1e-9, 1e-4)) CHECK_INT(stands[k], clear2 > margin * fabs(margin));
            count += stands[k];
        }
        CHECK_INT(sp_support_rank(s, SEATS, R(margin), w, J, order, &stable), SP_OK);
        CHECK_INT(stable, count);
        for (int k = 0; k < SEATS; k++) {               /* as many are before k as brute force says */
            int before = 0;
            for (int i = 0; i < SEATS; i++)
                before += stands[i] != stands[k] ? stands[i] : want[i] < want[k] || (!(want[i] > want[k]) && i < k);
            if (!CHECK_INT(order[before], k)) return;
            CHECK_WITHIN(J[k], want[k], 0);
            seen[order[k]]++;
        }
        for (int k = 0; k < SEATS; k++) CHECK_INT(seen[k], 1);
    }
}

/* Random scenes of all kinds, as they are, without half of their joints, and with a support let go: where the stage of gates alone says
 * that it falls, the exact stage alone never says that it stands. */
TEST(no_gate_says_unstable_where_the_exact_stage_says_stable)
{
    int32_t falls = 0, stands = 0, wrong = 0;
    for (int k = 0; k < 3 * SOME_OF(300, 25); k++) {
        sp_scene s;
        sp_settings set;
        sp_result gate, exact;
        test_arena.used = 0;
        if (!CHECK_INT(kinds_make(k / 3, &test_arena, &s, &set), SP_OK)) return;
        for (int32_t i = 0, half = s.count.joints / 2; k % 3 == 1 && i < half; i++) {
            const sp_joint last = s.joint[--s.count.joints];
            if (last.point + last.points == s.count.points) s.count.points = last.point;
        }
        for (int32_t i = 0; k % 3 == 2 && i < s.count.blocks; i++) {
            if (s.block[i].fixed != SP_FIXED || !(s.block[i].mass > 0)) continue;
            s.block[i].fixed = 0;
            break;
        }
        set.localise = 0;
        set.stage_count = 1;
        set.stage[0] = SP_STAGE_GATES;
        sp_arena a = test_arena;
        CHECK_INT(sp_check(&s, &set, &a, &gate), SP_OK);
        set.stage[0] = SP_STAGE_EXACT;
        a = test_arena;
        CHECK_INT(sp_check(&s, &set, &a, &exact), SP_OK);
        falls += gate.verdict == SP_UNSTABLE;
        stands += exact.verdict == SP_STABLE;
        wrong += gate.verdict == SP_UNSTABLE && exact.verdict == SP_STABLE;
    }
    CHECK_INT(wrong, 0);
    if (!CHECK(falls > SOME_OF(200, 12) && stands > SOME_OF(200, 12))) TEST_PRINT("    %d fall, %d stand\n", (int)falls, (int)stands);
}

/* A box a x b x c, its corner at o. */
static const int32_t box_size[6] = { 4, 4, 4, 4, 4, 4 };
static const int32_t box_corner[24] = { 0, 3, 2, 1,  4, 5, 6, 7,  0, 1, 5, 4,  1, 2, 6, 5,  2, 3, 7, 6,  3, 0, 4, 7 };

static sp_mesh box(sp_real xyz[24], double a, double b, double c)
{
    const sp_mesh m = { 8, 6, xyz, box_size, box_corner };
    for (int k = 0; k < 8; k++) {
        xyz[3 * k] = R(k % 4 == 1 || k % 4 == 2 ? a : 0);
        xyz[3 * k + 1] = R(k % 4 >= 2 ? b : 0);
        xyz[3 * k + 2] = R(k >= 4 ? c : 0);
    }
    return m;
}

TEST(a_box_rests_on_six_faces)
{
    sp_real xyz[24];
    const sp_mesh m = box(xyz, 3, 1.5, 1.5);
    const double area[6] = { 4.5, 4.5, 4.5, 2.25, 4.5, 2.25 };
    sp_rest r[6];
    int32_t count = 0;
    CHECK_INT(sp_rest_faces(&m, test_arena, r, 6, &count), SP_OK);
    CHECK_INT(count, 6);
    for (int k = 0; k < 6 && k < count; k++) {
        CHECK_INT(r[k].face, k);
        CHECK_NEAR(r[k].support.area, area[k], TOL(1e-14, 1e-6));
        CHECK_NEAR(r[k].height, k == 3 || k == 5 ? 1.5 : 0.75, TOL(1e-14, 1e-6));
        CHECK_NEAR(r[k].support.clearance, 0.75, TOL(1e-14, 1e-6));
    }
    CHECK_NEAR(r[0].normal[2], -1, 0);
    CHECK_INT(sp_rest_faces(&m, test_arena, r, 4, &count), SP_E_CAPACITY);
    CHECK_INT(count, 6);
    sp_arena exact = test_arena;
    exact.capacity = exact.used + sp_support_memory(m.vertices);
    CHECK_INT(sp_rest_faces(&m, exact, r, 6, &count), SP_OK);
    exact.capacity--;
    CHECK_INT(sp_rest_faces(&m, exact, r, 6, &count), SP_E_MEMORY);
}

/* A leaning prism: its end faces lie flat, of the long ones only those under the centroid. */
TEST(a_leaning_box_does_not_rest_on_its_short_faces)
{
    sp_real xyz[24];
    const sp_mesh m = box(xyz, 1, 1, 3);
    sp_rest r[6];
    int32_t count = 0;
    for (int k = 4; k < 8; k++) xyz[3 * k] += 2;
    CHECK_INT(sp_rest_faces(&m, test_arena, r, 6, &count), SP_OK);
    CHECK_INT(count, 4);                                /* the two parallelograms beside it and the two slanted faces */
    for (int k = 0; k < 4 && k < count; k++) CHECK_INT(r[k].face, k + 2);
}

/* Legs: four feet in one plane are one support; the faces between them none. */
TEST(a_stone_with_feet_rests_on_all_of_them)
{
    static const int32_t size[] = { 4, 4, 4, 4, 4, 8, 4, 4, 8, 4 };
    static const int32_t corner[] = { 0, 8, 9, 1,  2, 10, 11, 3,  4, 12, 13, 5,  6, 14, 15, 7,  7, 15, 8, 0,
                                      0, 1, 2, 3, 4, 5, 6, 7,  1, 9, 10, 2,  3, 11, 12, 4,  15, 14, 13, 12, 11, 10, 9, 8,
                                      5, 13, 14, 6 };
    static const double outline[8][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 3, 1 }, { 3, 0 }, { 4, 0 }, { 4, 2 }, { 0, 2 } };
    sp_real xyz[48];
    const sp_mesh m = { 16, 10, xyz, size, corner };
    sp_rest r[10];
    int32_t count = 0, feet = 0;
    for (int k = 0; k < 16; k++) {                      /* an arch on two legs along x, standing in z */
        xyz[3 * k] = R(outline[k % 8][0]);
        xyz[3 * k + 1] = R(k / 8);
        xyz[3 * k + 2] = R(outline[k % 8][1]);
    }
    CHECK_INT(sp_rest_faces(&m, test_arena, r, 10, &count), SP_OK);
    for (int k = 0; k < count && k < 10; k++)
        if (r[k].normal[2] < R(-0.5)) feet++, CHECK_NEAR(r[k].support.area, 4, TOL(1e-14, 1e-6));
    CHECK_INT(feet, 1);
    CHECK_INT(count, 6);                                /* feet, top, two ends, front, back */
}

/* A cube with one more vertex at an edge, 1e-9 of its height up, and so a sliver there, in the plane of the side: it lies in the
 * plane of the bottom, too, as near as planes are told apart. First or last among the faces, it takes none away. */
TEST(a_sliver_at_an_edge_takes_no_resting_face_away)
{
    static const int32_t size[8] = { 3, 4, 4, 5, 4, 4, 4, 3 };
    static const int32_t corner[31] = { 0, 1, 8,  0, 3, 2, 1,  4, 5, 6, 7,  0, 8, 1, 5, 4,  1, 2, 6, 5,  2, 3, 7, 6,  3, 0, 4, 7,
                                        0, 1, 8 };
    for (int last = 0; last < 2; last++)
        for (int out = 0; out < 2; out++) {             /* out: the sliver is a chamfer between the two planes */
            sp_real xyz[27] = { 0 };
            const sp_mesh m = { 9, 7, xyz, size + last, corner + 3 * last };
            sp_rest r[7];
            int32_t count = 0, down_on = 0;
            box(xyz, 1, 1, 1);
            xyz[24] = R(0.5);
            xyz[25] = R(out ? -1e-9 : 0);
            xyz[26] = R(1e-9);
            CHECK_INT(sp_rest_faces(&m, test_arena, r, 7, &count), SP_OK);
            for (int k = 0; k < count && k < 7; k++) down_on += r[k].normal[2] < R(-0.99) && r[k].support.area > R(0.99);
            CHECK_INT(down_on, 1);
            CHECK(count == 6 || (out && count == 7));
        }
}

TEST(resting_faces_of_random_tetrahedra_are_those_under_their_centroid)
{
    static const int32_t size[4] = { 3, 3, 3, 3 };
    static const int32_t corner[12] = { 0, 2, 1,  0, 1, 3,  1, 2, 3,  2, 0, 3 };
    for (int run = 0; run < 1000; run++) {
        sp_real xyz[12], com[3] = { 0, 0, 0 };
        const sp_mesh m = { 4, 4, xyz, size, corner };
        sp_rest r[4];
        int32_t count = 0, want = 0;
        for (int k = 0; k < 12; k++) xyz[k] = test_random_real(-1, 1), com[k % 3] += xyz[k] / 4;
        if (sp_rest_faces(&m, test_arena, r, 4, &count)) continue;             /* inside out or flat */
        for (int f = 0; f < 4; f++) {                   /* the face's corners alone, gravity along its normal */
            sp_real face[9], n[3];
            sp_support s;
            for (int k = 0; k < 9; k++) face[k] = xyz[3 * corner[3 * f + k / 3] + k % 3];
            for (int k = 0; k < 3; k++) {
                const int p = (k + 1) % 3, q = (k + 2) % 3;
                n[k] = (face[3 + p] - face[p]) * (face[6 + q] - face[q]) - (face[3 + q] - face[q]) * (face[6 + p] - face[p]);
            }
            CHECK_INT(sp_support_clearance(face, 3, com, n, test_arena, &s), SP_OK);
            want += s.clearance > 0;
        }
        if (!CHECK_INT(count, want)) return;
        CHECK(count >= 1);                              /* every convex body has one: the face nearest its centroid */
    }
}

/* The gate: rejection reasons in their order. */
static sp_nbo gate(double x, double depth, double height, double lean, double margin)
{
    const sp_real face[] = { 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0 };
    const sp_laid laid = { face, 4, { R(x), 1, 1 }, { R(lean), 0, R(-1) }, R(depth), R(height) };
    sp_nbo_settings set = sp_nbo_settings_default();
    sp_nbo reason = SP_NBO_MARGIN;
    set.margin = R(margin);
    CHECK_INT(sp_nbo_gate(&laid, down, &set, test_arena, &reason, NULL), SP_OK);
    return reason;
}

TEST(the_gate_gives_the_first_reason_in_order)
{
    CHECK_INT(gate(1, 1, 1, 0, 0.4), SP_NBO_ACCEPTED);
    CHECK_INT(gate(2.5, 0.1, 1, 9, 0.4), SP_NBO_OUTSIDE);
    CHECK_INT(gate(0.5, 0.49, 1, 9, 0.4), SP_NBO_SHALLOW);
    CHECK_INT(gate(0.5, 0.5, 1, 1.03, 0.4), SP_NBO_TILTED);
    CHECK_INT(gate(0.5, 0.5, 1, 1.01, 0.4), SP_NBO_MARGIN);
    CHECK_INT(gate(0.5, 0.5, 1, 1.01, 0.25), SP_NBO_ACCEPTED);
    CHECK_INT(gate(2, 0, 0, 0, 0), SP_NBO_ACCEPTED);    /* on the edge; no height: any depth will do */
    CHECK_TEXT(sp_nbo_text(SP_NBO_TILTED), "resting face tilted");
    CHECK_TEXT(sp_nbo_text((sp_nbo)9), "unknown");
}

/* All four conditions, recomputed from all pairs of points: d_edge / sqrt(area), spans, cosine of the face. */
TEST(the_gate_is_its_four_conditions_in_10000_random_cases)
{
    int32_t count[5] = { 0, 0, 0, 0, 0 };
    for (int run = 0; run < 10000; run++) {
        sp_real xyz[3 * 8], margin = 0;
        const int32_t n = test_random_int(3, 8);
        const sp_real com[3] = { test_random_real(-0.6, 0.6), test_random_real(-0.6, 0.6), 1 };
        const sp_real depth = test_random_real(0.2, 1), height = test_random_real(0.2, 1), lean = test_random_real(0, 1.5);
        const sp_laid laid = { xyz, n, { com[0], com[1], com[2] }, { lean, 0, R(-1) }, depth, height };
        sp_nbo_settings set = sp_nbo_settings_default();
        sp_nbo got;
        double d2 = 0;
        set.margin = test_random_real(0, 0.2);
        random_points(xyz, n, 0);
        CHECK_INT(sp_nbo_gate(&laid, down, &set, test_arena, &got, &margin), SP_OK);
        double middle[2];
        const double area = brute_area(xyz, n, middle);
        brute_clearance(xyz, n, com, &d2);
        const double m = (d2 < 0 ? -sqrt(-d2) : sqrt(d2)) / sqrt(area), slim = (double)depth - 0.5 * (double)height;
        const double level = 1 / sqrt(1 + (double)lean * (double)lean) - 0.7, close = TOL(1e-9, 1e-4);
        const sp_nbo want = m < 0 ? SP_NBO_OUTSIDE : slim < 0 ? SP_NBO_SHALLOW : level < 0 ? SP_NBO_TILTED
                          : m < (double)set.margin ? SP_NBO_MARGIN : SP_NBO_ACCEPTED;
        count[got]++;
        if (!CHECK_WITHIN(margin, m, TOL(1e-9, 1e-3) / sqrt(area))) return;
        const double beside = fabs(m - (double)set.margin);
        if ((fabs(m) < beside ? fabs(m) : beside) < close / sqrt(area) || fabs(slim) < close || fabs(level) < close) continue;
        if (!CHECK_INT(got, want)) return;
    }
    for (int k = 0; k < 5; k++) CHECK(count[k] > 200);
}

TEST(the_gates_margin_has_no_unit)
{
    const sp_real unit[] = { 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0 };
    for (int k = -6; k <= 6; k += 3) {
        sp_real face[12], scale = 1, margin = 0;
        for (int i = 0; i < (k < 0 ? -k : k); i++) scale *= k < 0 ? R(0.125) : R(8);
        for (int i = 0; i < 12; i++) face[i] = scale * unit[i];
        const sp_laid laid = { face, 4, { scale / 2, scale, scale }, { 0, 0, R(-1) }, scale, scale };
        sp_nbo reason;
        CHECK_INT(sp_nbo_gate(&laid, down, NULL, test_arena, &reason, &margin), SP_OK);
        CHECK_INT(reason, SP_NBO_ACCEPTED);
        CHECK_NEAR(margin, 0.25, TOL(1e-14, 1e-6));
    }
    const sp_laid flat = { unit, 2, { 0, 0, 1 }, { 0, 0, R(-1) }, 1, 1 }, thin = { unit, 4, { 1, 1, 1 }, { 0, 0, 0 }, 1, 1 };
    sp_nbo reason;
    sp_real margin = 0;
    CHECK_INT(sp_nbo_gate(&flat, down, NULL, test_arena, &reason, &margin), SP_OK);
    CHECK_INT(reason, SP_NBO_OUTSIDE);
    CHECK_WITHIN(margin, -1, 0);
    CHECK_INT(sp_nbo_gate(&thin, down, NULL, test_arena, &reason, &margin), SP_E_RANGE);
    CHECK_INT(sp_nbo_gate(NULL, down, NULL, test_arena, &reason, &margin), SP_E_ARGUMENT);
}

TEST_LIST(place)
    RUN(clearance_is_that_of_all_pairs_of_points_in_10000_random_supports)
    RUN(clearance_of_a_unit_square)
    RUN(support_without_area_reads_minus_one)
    RUN(clearance_follows_gravity_units_and_origin)
    RUN(support_refuses_bad_input)
    RUN_FULL(no_gate_says_no_where_the_statics_say_stable)
    RUN(cost_of_a_seat_has_four_terms)
    RUN(cost_refuses_a_stone_without_size)
    RUN(seats_are_ordered_stable_first_then_by_cost_then_by_number)
    RUN(cost_and_order_of_10000_random_seats_are_those_of_brute_force)
    RUN_FULL(no_gate_says_unstable_where_the_exact_stage_says_stable)
    RUN(a_box_rests_on_six_faces)
    RUN(a_leaning_box_does_not_rest_on_its_short_faces)
    RUN(a_stone_with_feet_rests_on_all_of_them)
    RUN(a_sliver_at_an_edge_takes_no_resting_face_away)
    RUN(resting_faces_of_random_tetrahedra_are_those_under_their_centroid)
    RUN(the_gate_gives_the_first_reason_in_order)
    RUN(the_gate_is_its_four_conditions_in_10000_random_cases)
    RUN(the_gates_margin_has_no_unit)
TEST_END
