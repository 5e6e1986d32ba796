/* A leaf of a proof that nothing moves against its definition: c = sum y r over a dense Aeq and M, its least over the box;
 * the box itself; which rows a corner has in which state, and that each holds there; the walk, and proofs that are none. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/still.c"
#include "../../solvers/proof/sliding.c"
#include "leaf.h"

#if SP__WITH_STRONG

static leaf_scene o;
static sp__inertia M[LEAF_BLOCKS];
static sp__still *w;

static int begin(void)
{
    if (!leaf_make(&o, 0, 0)) return 0;
    memset(M, 0, sizeof M);
    for (int i = 0; i < LEAF_BLOCKS; i++) {
        M[i].mass = test_random_real(1, 2);
        M[i].known = 1;
        for (int k = 0; k < 3; k++)
            for (int q = 0; q <= k; q++)
                M[i].J[k][q] = M[i].J[q][k] = k == q ? test_random_real(2, 3) : test_random_real(-0.5, 0.5);
        sp__inertia_invert(&o.pb, i, &M[i]);
    }
    w = sp__take(&test_arena, 1, sizeof *w);
    if (!CHECK(w)) return 0;
    memset(w, 0, sizeof *w);
    sp__still_carve(w, LEAF_POINTS, o.pb.blocks, &test_arena);
    if (!CHECK(!sp__failed(&test_arena))) return 0;
    w->j = &o.j;
    w->M = M;
    for (int v = 0; v < LEAF_POINTS; v++) {
        w->contact[v] = o.contact[v];
        w->at[v] = o.at[v];
        w->state[v] = (int32_t[]){ 0, 1, 2, 3, 4, 7, 11, 25 }[test_random_int(0, 7)];
    }
    for (int r = 0; r < LEAF_N; r++) w->reach[r] = leaf_held(r) ? 0 : test_random_real(0, 2);
    w->delta = R(0.125);
    return 1;
}

static void clear(void)
{
    memset(w->f, 0, LEAF_POINTS * sizeof *w->f);
    memset(w->d, 0, LEAF_POINTS * sizeof *w->d);
    memset(w->size, 0, LEAF_POINTS * sizeof *w->size);
    memset(w->motion, 0, LEAF_N * sizeof *w->motion);
    w->work = w->right = w->rounding = 0;
}

/* Rows of random multipliers, added; n: how many were. */
static int32_t some(uint16_t *row, sp_real *y, int32_t most)
{
    int32_t n = 0;
    for (int tries = 0; tries < 400 && n < most; tries++) {
        const int32_t kind = test_random_int(0, 9), v = test_random_int(0, LEAF_POINTS - 1);
        const int32_t r = kind < 3 ? test_random_int(0, LEAF_N - 1) : kind == 3 && tries % 4 == 0 ? LEAF_N
                        : LEAF_N + 1 + SP__STILL_ROWS * v + test_random_int(0, SP__STILL_ROWS - 1);
        const sp_real x = test_random_real(-2, 2), was = w->work;
        if (r == LEAF_N && x < 0) continue;
        if (sp__still_add(w, r, x)) { row[n] = (uint16_t)r; y[n++] = x; }
        else CHECK_WITHIN(w->work, was, 0);
    }
    return n;
}

/* Least of c over the box, and the sizes that rounding is counted by, from w's sums before. */
static double least(double *rounding)
{
    double sum = 0, c[LEAF_N];
    for (int v = 0; v < LEAF_POINTS; v++) {
        const sp_contact *t = &o.pb.contact[o.contact[v]];
        double cap[LEAF_BLOCKS], g[3], size = (double)w->size[v];
        for (int i = 0; i < LEAF_BLOCKS; i++) {
            cap[i] = (double)o.j.scale[i].force_cap * fmin((double)o.set.force_bound, 1e4);
            double y[6];
            for (int k = 0; k < 6; k++) y[k] = (double)w->motion[6 * i + k];
            if (t->a == i || t->b == i) size += leaf_norm(y) + leaf_norm(y + 3) * leaf_arm(&o, i);
        }
        for (int k = 0; k < 3; k++) {
            g[k] = (double)w->f[v][k];
            for (int r = 0; r < LEAF_N; r++) g[k] -= o.A[r][3 * v + k] * (double)w->motion[r];
        }
        const double F = leaf_lesser(&o, v, cap), worst = g[0] - leaf_mu(&o, v) * hypot(g[1], g[2]);
        sum += F * fmin(worst, 0);
        *rounding += (1 + leaf_mu(&o, v)) * F * size;
    }
    for (int r = 0; r < LEAF_N; r++) {
        const sp__inertia *m = &M[r / 6];
        const double unit = (double)o.j.unit, p = o.p[r] * (double)w->work;
        double ma = 0, Jy = 0, J = 0;
        if (r % 6 < 3) ma = (double)m->mass * (double)w->motion[r] / unit;
        for (int k = 0; k < 3 && r % 6 > 2; k++) {
            ma += (double)m->J[r % 6 - 3][k] * (double)w->motion[r / 6 * 6 + 3 + k] / unit;
            Jy += (double)w->motion[r / 6 * 6 + 3 + k] * (double)w->motion[r / 6 * 6 + 3 + k];
            J += (double)m->J[r % 6 - 3][k] * (double)m->J[r % 6 - 3][k];
        }
        c[r] = ma - p;
        *rounding += (double)w->reach[r] * (r % 6 < 3 ? fabs(c[r]) + 2 * fabs(p) : sqrt(J * Jy) / unit + fabs(p));
        for (int q = 0; q < 3 * LEAF_POINTS; q++) c[r] += o.A[r][q] * (double)w->d[q / 3][q % 3];
        if (!leaf_held(r)) sum -= fabs(c[r]) * (double)w->reach[r];
    }
    for (int v = 0; v < LEAF_POINTS; v++) {
        const sp_contact *t = &o.pb.contact[o.contact[v]];
        for (int r = 0; r < LEAF_N; r++)
            if (t->a == r / 6 || t->b == r / 6)
                *rounding += (double)w->size[v] * (double)w->reach[r] * (r % 6 < 3 ? 1 : leaf_arm(&o, r / 6));
    }
    return sum;
}

TEST(a_leaf_that_nothing_moves_is_what_its_definition_says)
{
    int proofs = 0;
    for (int k = 0; k < SOME_OF(400, 80); k++) {
        const sp_arena mark = test_arena;
        uint16_t row[LEAF_ENTRIES];
        sp_real y[LEAF_ENTRIES];
        NEED(begin());
        o.set.force_bound = R(k % 2 ? 1e-3 : 1e5);
        if (k % 2) for (int r = 0; r < LEAF_N; r++) w->reach[r] *= R(1e-4);
        clear();
        const int32_t n = some(row, y, 1 + k % 20);
        double rounding = (double)w->rounding, right = 0;
        for (int32_t e = 0; e < n; e++) {
            if (row[e] < LEAF_N) right += (double)y[e] * o.p[row[e]];
            if (row[e] == LEAF_N) right -= (double)y[e] * 0.125;
        }
        rounding += (double)w->work * 0.125;
        const double margin = least(&rounding) - right - (32 + n) * (double)SP_EPSILON * rounding;
        const sp_proof proof = { .entries = n, .row = row, .y = y };
        w->proof = &proof;
        const double got = (double)sp__still_leaf(w, 0, n);
        CHECK_NEAR(w->rounding, rounding, LEAF_TOL * 10);
        if (fabs(margin) > LEAF_TOL * 10 * rounding) CHECK_WITHIN(got, fmax(margin, 0) / rounding, LEAF_TOL * 10);
        proofs += margin > 0;
        test_arena = mark;
    }
    CHECK(proofs > 5);
}

/* What a row adds, and the size that it adds. */
TEST(a_row_adds_its_terms_and_their_size)
{
    NEED(begin());
    for (int k = 0; k < 2000; k++) {
        uint16_t row[1];
        sp_real y[1];
        clear();
        if (!some(row, y, 1)) continue;
        double rounding = 0;
        for (int v = 0; v < LEAF_POINTS; v++) {
            double size = 0;
            for (int q = 0; q < 3; q++) size += fabs((double)w->f[v][q]) + fabs((double)w->d[v][q]);
            CHECK_WITHIN(w->size[v], size, LEAF_TOL);
        }
        if (row[0] < LEAF_N) {
            rounding = fabs((double)y[0] * o.p[row[0]]);
            CHECK_WITHIN(w->right, (double)y[0] * o.p[row[0]], LEAF_TOL * 10);
            CHECK(!leaf_held(row[0]));
        }
        CHECK_WITHIN(w->rounding, rounding, LEAF_TOL * 10);
        for (int q = 0; q < LEAF_N; q++) CHECK_WITHIN(w->motion[q], q == row[0] ? (double)y[0] : 0, 0);
        const int32_t at = row[0] > LEAF_N ? (row[0] - LEAF_N - 1) / SP__STILL_ROWS : -1;
        for (int v = 0; v < LEAF_POINTS; v++) {
            sp_real r[6] = { 0, 0, 0, 0, 0, 0 };
            if (v == at) sp__still_row(w->state[v], (row[0] - LEAF_N - 1) % SP__STILL_ROWS, R(leaf_mu(&o, v)), r);
            for (int q = 0; q < 3; q++) {
                CHECK_WITHIN(w->f[v][q], (double)(y[0] * r[q]), LEAF_TOL);
                CHECK_WITHIN(w->d[v][q], (double)(y[0] * r[3 + q]), LEAF_TOL);
            }
        }
    }
    const int32_t last = LEAF_N + SP__STILL_ROWS * LEAF_POINTS;
    w->state[LEAF_POINTS - 1] = 1;
    CHECK_INT(sp__still_add(w, last, 1), 1);
    CHECK_INT(sp__still_add(w, last + 1, 1), 0);
    CHECK_INT(sp__still_add(w, -1, 1), 0);
    CHECK_INT(sp__still_add(w, 0, R(NAN)), 0);
    CHECK_INT(sp__still_add(w, 0, R(INFINITY)), 0);
    CHECK_INT(sp__still_add(w, LEAF_N, -1), 0);
    for (int32_t r = 0; r < LEAF_N; r++) CHECK_INT(sp__still_add(w, r, 1), !leaf_held(r));
}

/* Which sign a multiplier may have: of dn >= 0 down, once it is closed any; of slip none but where it sticks; of a sector's ends
 * and of friction against them one each; of cones up; of fn >= 0 down, and of an open corner's forces any. */
TEST(a_multiplier_has_the_sign_that_its_state_asks)
{
    static const char *const sign[5] = { "-0000000++++++++000-00", "-0000000++++++++000bbb", "b0000000++++++++000-00",
                                         "bbb00000++++++++000-00", "b00-++-++++++++++++-00" };
    NEED(begin());
    for (int32_t state = 0; state < 32; state++) {
        for (int32_t row = 0; row < SP__STILL_ROWS; row++) {
            const char s = sign[state < 4 ? state : 4][row];
            CHECK_INT(sp__still_sign(state, row), s == 'b' ? 2 : s == '+' ? 1 : s == '-' ? -1 : 0);     /* a search reads it */
            for (int k = -1; k < 2; k += 2) {
                clear();
                w->state[1] = state;
                const int taken = sp__still_add(w, LEAF_N + 1 + SP__STILL_ROWS + row, R(k));
                if (!CHECK_INT(taken, s == 'b' || s == (k > 0 ? '+' : '-'))) TEST_PRINT("    state %d, row %d, %d\n", (int)state, (int)row, k);
                if (!taken) CHECK_WITHIN(w->size[1], 0, 0);
            }
        }
    }
}

/* Whatever the row is, in whatever state. */
TEST(a_multiplier_of_0_adds_nothing_to_a_still_proof)
{
    NEED(begin());
    clear();
    for (int32_t state = 0; state < 16; state++)
        for (int32_t row = 0; row <= LEAF_N + SP__STILL_ROWS * LEAF_POINTS; row++) {
            for (int v = 0; v < LEAF_POINTS; v++) w->state[v] = state;
            if (!CHECK_INT(sp__still_add(w, row, 0), 1)) TEST_PRINT("    state %d, row %d\n", (int)state, (int)row);
        }
    CHECK_INT(sp__still_add(w, LEAF_N + SP__STILL_ROWS * LEAF_POINTS + 1, 0), 0);
    for (int v = 0; v < LEAF_POINTS; v++) CHECK_NEAR(w->size[v], 0, 0);
    CHECK_NEAR(w->rounding, 0, 0);
}

/* Pairs of loads balanced but for a rest of `ulps` u of what was added up. */
static sp_real nearly(int32_t from, int32_t pairs, double ulps)
{
    static uint16_t row[1100];
    static sp_real y[1100];
    const int32_t a = 0, b = 7;
    const sp_proof proof = { .entries = from + 2 * pairs, .row = row, .y = y };
    for (int32_t e = from; e < from + 2 * pairs; e += 2) {
        row[e] = (uint16_t)a;
        row[e + 1] = (uint16_t)b;
        y[e] = R(-1 / o.p[a]);
        y[e + 1] = R((1 - 2 * ulps * (double)SP_EPSILON) / o.p[b]);
    }
    w->proof = &proof;
    return sp__still_leaf(w, from, from + 2 * pairs);
}

/* The allowance for rounding, 32 and one a row times u of all that was added up: a margin just beyond it is one, within none. */
TEST(a_margin_within_its_own_rounding_is_none)
{
    for (int k = 0; k < 40; k++) {
        const sp_arena mark = test_arena;
        const int32_t from = k % 2 ? 1000 : 0, pairs = k % 4 < 2 ? 1 : 10;
        NEED(begin());
        o.set.force_bound = 0;
        memset(w->reach, 0, LEAF_N * sizeof *w->reach);
        CHECK(nearly(from, pairs, 1.4 * (32 + 2 * pairs)) > 0);
        CHECK(!(nearly(from, pairs, 0.7 * (32 + 2 * pairs)) > 0));
        CHECK(!(nearly(from, pairs, -1.4 * (32 + 2 * pairs)) > 0));
        test_arena = mark;
    }
}

/* Loads of 1 and multipliers a few u from 1 add up without rounding: what is left is `ulps` u less 32 and one a row. */
TEST(a_margin_is_less_by_32_roundings_and_one_for_each_row)
{
    NEED(begin());
    o.set.force_bound = 0;
    memset(w->reach, 0, LEAF_N * sizeof *w->reach);
    o.pb.p[0] = o.pb.p[7] = o.j.unit;
    o.p[0] = o.p[7] = 1;
    for (int32_t pairs = 1; pairs < 9; pairs *= 2) {
        const double ulps = 2 * (32 + 2 * pairs);
        CHECK_NEAR(nearly(0, pairs, ulps), ulps / 2 * (double)SP_EPSILON, 1e-3);
    }
}

/* A proof that holds in a box of nothing alone, where loads are too small to move anything: it holds where masses make it so; with
 * masses as they are, and where an inertia is unknown, it does not, whatever is left in memory. */
TEST(a_still_proof_stands_on_masses_that_are_known)
{
    NEED(begin());
    o.set.force_bound = 0;
    int32_t node[1] = { -1 };
    uint16_t row[1] = { 0 };
    sp_real y[1] = { o.p[0] > 0 ? -1 : 1 };
    const sp_proof good = { .nodes = 1, .entries = 1, .node = node, .row = row, .y = y };
    for (int k = 0; k < 4; k++) {
        sp_arena a = test_arena;
#ifndef FENCED                                          /* painted by the fence, else */
        memset(a.base + a.used, 0, sp__still_need(LEAF_POINTS, o.pb.blocks) + SP_ALIGN);
#endif
        for (int i = 0; k > 0 && i < LEAF_BLOCKS; i++) {
            memset(&M[i], 0, sizeof M[i]);
            M[i].mass = k < 3 ? R(TOL(1e-300, 1e-30)) : R(1e-4) * o.j.unit;         /* delta is large, or some hundredths */
            M[i].known = k != 2;
        }
        CHECK_INT(sp__certify_still(&o.j, M, &good, &a) > 0, k % 2);
    }
}

/* Rows hold for every pair in their state: what is open, sticks, or slips with friction full and opposite. */
TEST(every_row_of_a_corner_holds_in_its_state)
{
    const double pi = 3.14159265358979323846, mu = 0.6;
    for (int32_t state = 0; state < 64; state++)
        for (int32_t row = 0; row < SP__STILL_ROWS; row++) {
            const int sign = sp__still_sign(state, row);
            int h = 0;
            sp_real r[6];
            if (!sign) continue;
            sp__still_row(state, row, R(mu), r);
            while (state >> h > 7) h++;
            for (int k = 0; k < 200; k++) {
                const double share = k < 9 ? k / 8.0 : (double)test_random_real(0, 1), fn = state == 1 ? 0 : 1;
                double turn = k < 64 ? pi / 32 * k : (double)test_random_real(0, 7), x[6];
                if (state > 3) turn = pi / 2 / (1 << h) * (state - (4 << h) + share);
                const double slip = state == 3 ? 0 : k % 3, open = state < 2 ? k % 2 : 0, rub = state > 3 ? -1 : k % 5 / 4.0;
                x[0] = fn; x[1] = rub * mu * fn * cos(turn); x[2] = rub * mu * fn * sin(turn);
                x[3] = open; x[4] = slip * cos(turn); x[5] = slip * sin(turn);
                double sum = 0;
                for (int q = 0; q < 6; q++) sum += (double)r[q] * x[q];
                if (sign == 2) CHECK_WITHIN(sum, 0, TOL(1e-12, 1e-5));
                else if (!CHECK(sign * sum <= TOL(1e-12, 1e-5))) return;
            }
        }
}

/* The rows that lean on a direction, to the last digits. */
TEST(rows_of_a_sector_are_at_its_ends_and_its_middle)
{
    const double pi = 3.14159265358979323846, mu = 0.6;
    for (int32_t state = 4; state < 128; state++) {
        int h = 0;
        while (state >> h > 7) h++;
        const double part = pi / 2 / (1 << h), from = part * (state - (4 << h));
        for (int32_t row = SP__STILL_ENDS; row < SP__STILL_FORCE; row++) {
            double want[6] = { 0, 0, 0, 0, 0, 0 };
            sp_real r[6];
            if (row < 7) {
                const double turn = row % 2 ? from : from + part;
                want[row < 5 ? 4 : 1] = -sin(turn);
                want[row < 5 ? 5 : 2] = cos(turn);
            } else if (row == 7) {
                want[0] = mu * cos(part / 2); want[1] = cos(from + part / 2); want[2] = sin(from + part / 2);
            } else {
                const double turn = row < 16 ? pi / 4 * (row - 8) : from + part / 2 * (row - 16) + pi;
                want[0] = -mu; want[1] = cos(turn); want[2] = sin(turn);
            }
            sp__still_row(state, row, R(mu), r);
            for (int q = 0; q < 6; q++) CHECK_WITHIN(r[q], want[q], TOL(1e-13, 1e-5));
        }
    }
}

/* The gap, slip and forces are rows of one number. */
TEST(rows_without_a_direction_are_one_number)
{
    for (int32_t state = 0; state < 8; state++)
        for (int32_t row = 0; row < SP__STILL_ROWS; row++) {
            sp_real r[6];
            if (row == SP__STILL_ENDS) row = SP__STILL_FORCE;
            sp__still_row(state, row, R(0.6), r);
            for (int q = 0; q < 6; q++) CHECK_WITHIN(r[q], q == (row < SP__STILL_ENDS ? 3 + row : row - SP__STILL_FORCE), 0);
        }
}

/* |a_k| <= 1.01 |p|_M^-1 sqrt((M^-1)_kk); delta = least (1e-3 load)^2 / m. */
TEST(the_box_of_accelerations_is_that_of_all_loads)
{
    for (int k = 0; k < 20; k++) {
        const sp_arena mark = test_arena;
        double P = 0, delta = 1e300;
        NEED(begin());
        for (int r = 0; r < LEAF_N; r++) o.pb.p[r] *= R(k % 2 ? 1e-3 : 1);
        for (int i = 0; i < LEAF_BLOCKS; i++) {
            const sp_real *p = o.pb.p + 6 * i;
            for (int r = 0; r < 3; r++) {
                if (!leaf_held(6 * i + r)) P += (double)p[r] * (double)p[r] / (double)M[i].mass;
                for (int q = 0; q < 3; q++) P += (double)p[3 + r] * (double)M[i].turn[r][q] * (double)p[3 + q];
            }
            const double load = leaf_norm(o.p + 6 * i);
            delta = fmin(delta, 1e-6 * load * load * (double)o.j.unit / (double)M[i].mass);
        }
        sp__still_reach(w);
        for (int r = 0; r < LEAF_N; r++) {
            const sp__inertia *m = &M[r / 6];
            const double inverse = r % 6 < 3 ? 1 / (double)m->mass : (double)m->turn[r % 6 - 3][r % 6 - 3];
            CHECK_NEAR(w->reach[r], leaf_held(r) ? 0 : 1.01 * sqrt(P * inverse), TOL(1e-12, 1e-4));
        }
        CHECK_NEAR(sp__still_delta(&o.j, M), delta, TOL(1e-12, 1e-4));
        M[1].known = 0;
        CHECK_WITHIN(sp__still_delta(&o.j, M), 0, 0);
        o.pb.blocks = 0;
        CHECK_WITHIN(sp__still_delta(&o.j, M), 0, 0);
        test_arena = mark;
    }
}

/* A leaf that holds in every case: a balance, in a box of nothing. */
static sp_real walk(int32_t nodes, const int32_t *node, int32_t entries, const uint16_t *row, const sp_real *y)
{
    const sp_proof proof = proof_of(nodes, node, entries, row, y);
    w->proof = &proof;
    return sp__still_walk(w);
}

TEST(every_case_of_a_still_proof_is_closed_once_and_in_order)
{
    static const uint16_t row[16] = { 0 };
    sp_real y[16];
    NEED(begin());
    o.set.force_bound = 0;
    memset(w->reach, 0, LEAF_N * sizeof *w->reach);
    for (int k = 0; k < 16; k++) y[k] = o.p[0] > 0 ? -1 : 1;
    static const struct { int32_t nodes, node[14], entries; int holds; } tree[] = {
        { 1, { -1 }, 1, 1 }, { 3, { 0, -1, -1 }, 2, 1 }, { 2, { 0, -1 }, 2, 0 }, { 4, { 0, -1, -1, -1 }, 3, 0 },
        { 8, { 3, -1, 3, -1, -1, -1, -1, -1 }, 6, 1 },  /* closed: sticks and four quarters */
        { 7, { 3, -1, 3, -1, -1, -1, -1 }, 5, 0 }, { 9, { 3, -1, 3, -1, -1, -1, -1, -1, -1 }, 7, 0 },
        { 10, { 3, -1, 3, -1, 3, -1, -1, -1, -1, -1 }, 7, 1 }, { 9, { 3, -1, 3, 3, -1, -1, -1, -1, -1 }, 7, 0 },
        { 5, { 0, 1, -1, -1, -1 }, 3, 1 }, { 3, { 0, 0, -1 }, 3, 0 }, { 3, { 9, -1, -1 }, 2, 0 },
        { 3, { INT32_MAX, -1, -1 }, 2, 0 }, { 1, { -2 }, 1, 0 }, { 1, { INT32_MIN }, 1, 0 }, { 3, { 0, -1, -1 }, 1, 0 },
        { 3, { 0, -2, -1 }, 3, 1 }
    };
    for (size_t k = 0; k < sizeof tree / sizeof tree[0]; k++)
        if (!CHECK_INT(walk(tree[k].nodes, tree[k].node, tree[k].entries, row, y) > 0, tree[k].holds))
            TEST_PRINT("    tree %d\n", (int)k);
    y[1] = -y[1];
    CHECK(!(walk(3, tree[1].node, 2, row, y) > 0));
}

/* Nodes end where they say, with cases that are not closed: what lies behind is no node. Sanitizers see it. */
TEST(a_still_proof_that_is_cut_off_is_not_read_on)
{
    static const int32_t cut[2] = { 0, -1 };
    static const uint16_t row[2] = { 0, 0 };
    NEED(begin());
    o.set.force_bound = 0;
    memset(w->reach, 0, LEAF_N * sizeof *w->reach);
    const sp_real s = o.p[0] > 0 ? -1 : 1, y[2] = { s, s };
    CHECK(!(walk(2, cut, 2, row, y) > 0));
    CHECK(!(walk(1, cut, 2, row, y) > 0));
}

/* A case has the states of its splits: friction is full where it slips, and only there. */
TEST(each_case_of_a_still_proof_has_its_own_rows)
{
    NEED(begin());
    o.set.force_bound = 0;
    memset(w->reach, 0, LEAF_N * sizeof *w->reach);
    const uint16_t at = LEAF_N + 1 + 2 * SP__STILL_ROWS, open = at + 20, stick = at + 1, full = at + 7;
    const uint16_t row[14] = { 0, open, 0, stick, 0, full, 0, full, 0, full, 0, full };
    const sp_real s = o.p[0] > 0 ? -1 : 1;
    sp_real y[14];
    static const int32_t node[8] = { 2, -2, 2, -2, -2, -2, -2, -2 };
    for (int k = 0; k < 14; k++) y[k] = k % 2 ? 1 : s;
    CHECK(walk(8, node, 12, row, y) > 0);
    for (int k = 1; k < 12; k += 2) {
        uint16_t other[14];
        memcpy(other, row, sizeof other);
        other[k] = k == 3 ? full : stick;
        CHECK(!(walk(8, node, 12, other, y) > 0));
    }
}

/* The last row there is, ft2 of the last corner, which is open: a corner has 22. */
TEST(the_last_row_of_a_still_proof_is_one)
{
    NEED(begin());
    const int32_t last = LEAF_N + 22 * LEAF_POINTS;
    clear();
    w->state[LEAF_POINTS - 1] = 1;
    CHECK_INT(sp__still_add(w, last, 1), 1);
    CHECK_NEAR(w->f[LEAF_POINTS - 1][2], 1, 0);
    CHECK_INT(sp__still_add(w, last + 1, 1), 0);
}

/* A corner takes three whole numbers, two for each of 16 splits above a leaf, and seven numbers. */
TEST(a_still_proof_has_room_for_16_splits_of_every_corner)
{
    const size_t corner = (3 + 2 * 16) * sizeof(int32_t) + 7 * sizeof(sp_real);
    CHECK_INT(sp__still_need(48, 1) - sp__still_need(16, 1), 32 * corner);
}

TEST(what_is_no_still_proof_is_none)
{
    NEED(begin());
    int32_t node[1] = { -1 };
    uint16_t row[1] = { 0 };
    sp_real y[1] = { 0 };
    const sp_proof good = { .nodes = 1, .entries = 1, .node = node, .row = row, .y = y };
    for (int k = 0; k < 8; k++) {
        sp_proof p = good;
        if (k == 0) p.nodes = 0;
        if (k == 1) p.nodes = -1;
        if (k == 2) p.entries = -1;
        if (k == 3) p.node = NULL;
        if (k == 4) p.row = NULL;
        if (k == 5) p.y = NULL;
        if (k == 6) p.entries = INT32_MIN;
        if (k == 7) p.nodes = INT32_MIN;
        const size_t used = test_arena.used;
        sp_arena a = test_arena;
        CHECK(!(sp__certify_still(&o.j, M, &p, &a) > 0));
        CHECK_INT(a.used, used);
    }
    const size_t need = sp__still_need(LEAF_POINTS, o.pb.blocks), from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    for (size_t bytes = 0; bytes <= need; bytes += SP_ALIGN) {
        sp_arena a = { test_arena.base + from, bytes, 0, 0 };
        memset(a.base + bytes, 0x5a, 64);
        CHECK(!(sp__certify_still(&o.j, M, &good, &a) > 0));
        CHECK(bytes < need ? sp__failed(&a) || !(a.used == need) : a.used == need && !sp__failed(&a));
        for (int k = 0; k < 64; k++) NEED(a.base[bytes + (size_t)k] == 0x5a);
    }
}

/* A sector is halved to 2^-10 of a quarter, no more. */
TEST(a_still_proof_may_be_deep_but_not_without_end)
{
    enum { DEPTH = 16 };
    static int32_t node[2 * DEPTH + 16];
    static uint16_t row[DEPTH + 16];
    static sp_real y[DEPTH + 16];
    NEED(begin());
    o.set.force_bound = 0;
    memset(w->reach, 0, LEAF_N * sizeof *w->reach);
    for (int k = 0; k < DEPTH + 16; k++) y[k] = o.p[0] > 0 ? -1 : 1;
    for (int halvings = 8; halvings < 13; halvings++) {
        int32_t n = 0, leaves = 0;
        node[n++] = 0; node[n++] = -1;                  /* open; closed into stuck and quarters, the first halved so often */
        node[n++] = 0; node[n++] = -1;
        for (int h = 0; h < halvings; h++) node[n++] = 0;
        for (int h = 0; h < halvings + 4; h++) node[n++] = -1;
        for (int k = 0; k < n; k++) leaves += node[k] < 0;
        CHECK_INT(walk(n, node, leaves, row, y) > 0, halvings <= 10);
    }
}

/* Cases are told apart of 16 corners and of 16 blocks; of more not even memory is taken. */
TEST(a_still_proof_of_too_much_is_none)
{
    NEED(begin());
    int32_t node[1] = { -1 };
    uint16_t row[1] = { 0 };
    sp_real y[1] = { 0 };
    const sp_proof good = { .nodes = 1, .entries = 1, .node = node, .row = row, .y = y };
    sp_contact contact = o.pb.contact[0];
    sp_problem pb = o.pb;
    const size_t from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN, little = sizeof(sp__still) + SP_ALIGN;
    pb.contact = &contact;
    pb.contacts = 1;
    o.j.pb = &pb;
    for (int32_t points = 15; points < 19; points++)
        for (int32_t blocks = 15; blocks < 19; blocks++) {
            sp_arena a = { test_arena.base + from, little, 0, 0 };
            contact.points = points;
            pb.blocks = blocks;
            CHECK(!(sp__certify_still(&o.j, M, &good, &a) > 0));
            CHECK_INT(a.used > 0 || sp__failed(&a), points <= 16 && blocks <= 16);
        }
}

#if SP__WITH_SLIDING
/* Where a block is held nothing moves, be it as little as numbers can say; nor does what is pushed back slide. */
TEST(a_state_that_moves_what_is_held_does_not_slide)
{
    sp_real f[3 * LEAF_POINTS], v[LEAF_N], live[LEAF_N], share;
    NEED(begin());
    memset(f, 0, sizeof f);
    for (int r = 0; r < LEAF_N; r++) {
        live[r] = test_random_real(-1, 1);
        v[r] = leaf_held(r) ? 0 : test_random_real(-1, 1);
    }
    double work = 0, most = 0;
    for (int i = 0; i < LEAF_BLOCKS; i++) {
        double q[6], x[6];
        for (int k = 0; k < 6; k++) {
            q[k] = (double)live[6 * i + k];
            x[k] = (double)v[6 * i + k];
            work += q[k] * x[k];
        }
        most += leaf_norm(q) * leaf_norm(x) + leaf_norm(q + 3) * leaf_norm(x + 3);
    }
    const int sign = work > 0 ? 1 : -1;
    for (int r = 0; r < LEAF_N; r++) live[r] = R(sign * (double)live[r]);
    CHECK(sp__certify_sliding(&o.j, live, f, v, &share) < SP__HUGE);
    CHECK_NEAR(share, sign * work / most, TOL(1e-12, 1e-5));
    for (int r = 0; r < LEAF_N; r++) live[r] = -live[r];
    CHECK(sp__certify_sliding(&o.j, live, f, v, &share) < SP__HUGE);
    CHECK_WITHIN(share, 0, 0);
    for (int r = 0; r < LEAF_N; r++)
        for (int k = -1; k < 2; k += 2) {
            const sp_real was = v[r];
            if (!leaf_held(r)) continue;
            v[r] = R(k * 1e-30);
            CHECK(sp__certify_sliding(&o.j, live, f, v, &share) >= SP__HUGE);
            v[r] = was;
        }
}
#endif

#endif

TEST_LIST(still)
#if SP__WITH_STRONG
    RUN(a_leaf_that_nothing_moves_is_what_its_definition_says)
    RUN(a_row_adds_its_terms_and_their_size)
    RUN(a_multiplier_has_the_sign_that_its_state_asks)
    RUN(a_multiplier_of_0_adds_nothing_to_a_still_proof)
    RUN(a_margin_within_its_own_rounding_is_none)
    RUN(a_margin_is_less_by_32_roundings_and_one_for_each_row)
    RUN(a_still_proof_stands_on_masses_that_are_known)
    RUN(every_row_of_a_corner_holds_in_its_state)
    RUN(rows_of_a_sector_are_at_its_ends_and_its_middle)
    RUN(rows_without_a_direction_are_one_number)
    RUN(the_box_of_accelerations_is_that_of_all_loads)
    RUN(every_case_of_a_still_proof_is_closed_once_and_in_order)
    RUN(a_still_proof_that_is_cut_off_is_not_read_on)
    RUN(each_case_of_a_still_proof_has_its_own_rows)
    RUN(the_last_row_of_a_still_proof_is_one)
    RUN(a_still_proof_has_room_for_16_splits_of_every_corner)
    RUN(what_is_no_still_proof_is_none)
    RUN(a_still_proof_may_be_deep_but_not_without_end)
    RUN(a_still_proof_of_too_much_is_none)
#if SP__WITH_SLIDING
    RUN(a_state_that_moves_what_is_held_does_not_slide)
#endif
#endif
TEST_END
