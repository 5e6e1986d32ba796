/* A leaf of a refutation against its definition: c = sum y a over a dense Aeq, the least c x over the box, what rows may be out
 * by, the sizes of the products; the box itself; the walk over the tree of cases, and proofs that are none. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/refute.c"
#include "leaf.h"

static leaf_scene o;
static sp__lengths length;
static sp__refute *w;

static int begin(int32_t faces, int32_t inscribed)
{
    if (!leaf_make(&o, faces, inscribed)) return 0;
    length = sp__coupled_lengths(&o.pb, &o.set);
    w = sp__take(&test_arena, 1, sizeof *w);
    if (!CHECK(w)) return 0;
    memset(w, 0, sizeof *w);
    sp__refute_carve(w, LEAF_POINTS, o.pb.blocks, &test_arena);
    if (!CHECK(!sp__failed(&test_arena))) return 0;
    w->j = &o.j;
    w->k = &length;
    for (int v = 0; v < LEAF_POINTS; v++) {
        w->contact[v] = o.contact[v];
        w->at[v] = o.at[v];
        w->F[v] = test_random_real(0, 3);
        w->any_friction[v] = test_random_real(0, 1);
        w->state[v] = 0;
    }
    for (int r = 0; r < LEAF_N; r++) w->reach[r] = leaf_held(r) ? 0 : test_random_real(0, 2);
    w->slack_of_work = test_random_real(1, 2);
    return 1;
}

static void clear(void)
{
    for (int v = 0; v < LEAF_POINTS; v++) {
        for (int k = 0; k < 3; k++) w->f[v][k] = w->d[v][k] = 0;
        w->fsize[v] = w->dsize[v] = 0;
    }
    for (int r = 0; r < LEAF_N; r++) w->motion[r] = 0;
    w->work = w->right = w->size = w->slack = 0;
}

/* A row that some state has, with its sign; the corner is put into that state. */
static int32_t some_row(sp_real *y)
{
    const int32_t kind = test_random_int(0, 9), v = test_random_int(0, LEAF_POINTS - 1);
    *y = test_random_real(-2, 2);
    if (kind < 3) {
        int32_t r = test_random_int(0, LEAF_N - 1);
        while (leaf_held(r)) r = test_random_int(0, LEAF_N - 1);
        return r;
    }
    if (kind == 3) { *y = *y < 0 ? -*y : *y; return LEAF_N; }
    return LEAF_N + 1 + SP__PROOF_ROWS * v + test_random_int(0, SP__PROOF_ROWS - 1);
}

/* What was added up, kept apart before the least is taken. */
typedef struct sums {
    double f[LEAF_POINTS][3], d[LEAF_POINTS][3], fsize[LEAF_POINTS], dsize[LEAF_POINTS], y[LEAF_N], work, right, size, slack;
} sums;

static sums kept(void)
{
    sums s;
    for (int v = 0; v < LEAF_POINTS; v++) {
        for (int k = 0; k < 3; k++) { s.f[v][k] = (double)w->f[v][k]; s.d[v][k] = (double)w->d[v][k]; }
        s.fsize[v] = (double)w->fsize[v];
        s.dsize[v] = (double)w->dsize[v];
    }
    for (int r = 0; r < LEAF_N; r++) s.y[r] = (double)w->motion[r];
    s.work = (double)w->work; s.right = (double)w->right; s.size = (double)w->size; s.slack = (double)w->slack;
    return s;
}

/* Largest displacement of a joint of a block, by the multipliers of its balance. */
static double displacement(const double *y, int i)
{
    return i < 0 ? 0 : leaf_norm(y + 6 * i) + leaf_norm(y + 6 * i + 3) * leaf_arm(&o, i);
}

/* min c f over 0 <= fn <= F, |ft1|, |ft2| <= mu F, c = c of rows + Aeq' y + work eps on fn; the sizes of its products. */
static double least_force(const sums *s, double *size)
{
    const double half = (double)o.j.tan_half;
    double least = 0;
    for (int v = 0; v < LEAF_POINTS; v++) {
        const sp_contact *t = &o.pb.contact[o.contact[v]];
        const double mu = leaf_mu(&o, v) * (1 + half), F = (double)w->F[v];
        double c[3];
        for (int k = 0; k < 3; k++) {
            c[k] = s->f[v][k] + (k ? 0 : s->work * (double)length.eps);
            for (int r = 0; r < LEAF_N; r++) c[k] += o.A[r][3 * v + k] * s->y[r];
        }
        least += F * (fmin(c[0], 0) - mu * (fabs(c[1]) + fabs(c[2])));
        *size += (1 + mu) * F * (s->fsize[v] + displacement(s->y, t->a) + displacement(s->y, t->b) + s->work * (double)length.eps);
    }
    return least;
}

/* min c dq over |dq| <= reach, c = Aeq d - work p. */
static double least_motion(const sums *s, double *size, double *slack)
{
    double least = 0;
    for (int r = 0; r < LEAF_N; r++) {
        double c = -s->work * o.p[r];
        for (int q = 0; q < 3 * LEAF_POINTS; q++) c += o.A[r][q] * s->d[q / 3][q % 3];
        least -= fabs(c) * (double)w->reach[r];
        *size += fabs(s->work * o.p[r]) * (double)w->reach[r];
    }
    for (int v = 0; v < LEAF_POINTS; v++) {
        const sp_contact *t = &o.pb.contact[o.contact[v]];
        double moved = 0;
        for (int side = 0; side < 2; side++) {
            const int i = side ? t->a : t->b;
            for (int k = 0; k < 6 && i >= 0; k++) moved += (double)w->reach[6 * i + k] * (k < 3 ? 1 : leaf_arm(&o, i));
        }
        *size += s->dsize[v] * moved;
        *slack += s->dsize[v] * ((double)SP__GIVE + 16 * (double)SP_EPSILON * moved);
    }
    return least;
}

TEST(what_a_row_adds_is_as_large_as_its_terms)
{
    NEED(begin(0, 1));
    for (int k = 0; k < 3000; k++) {
        sp_real y;
        const int32_t row = some_row(&y), v = row > LEAF_N ? (row - LEAF_N - 1) / SP__PROOF_ROWS : 0;
        const int32_t q = row > LEAF_N ? (row - LEAF_N - 1) % SP__PROOF_ROWS : -1;
        clear();
        w->state[v] = test_random_int(0, 60);
        if (w->state[v] == 3 || !sp__refute_add(w, row, y)) continue;
        const sums s = kept();
        double sum = 0;
        for (int i = 0; i < LEAF_POINTS; i++) {
            const double f = fabs(s.f[i][0]) + fabs(s.f[i][1]) + fabs(s.f[i][2]);
            const double d = fabs(s.d[i][0]) + fabs(s.d[i][1]) + fabs(s.d[i][2]);
            CHECK_WITHIN(s.fsize[i], f, LEAF_TOL);
            CHECK_WITHIN(s.dsize[i], d, LEAF_TOL);
            sum += i == v ? 0 : f + d;
        }
        CHECK_WITHIN(sum, 0, 0);
        CHECK_WITHIN(s.size, fabs(s.right), LEAF_TOL);
        CHECK_WITHIN(s.slack, q == 8 || q == 9 ? fabs((double)y) * (double)w->any_friction[v] : 0, LEAF_TOL);
        for (int r = 0; r < LEAF_N; r++) CHECK_WITHIN(s.y[r], r == row ? (double)y : 0, 0);
        CHECK_WITHIN(s.work, row == LEAF_N ? (double)y : 0, 0);
        if (row < LEAF_N) CHECK_WITHIN(s.right, -(double)y * o.p[row], LEAF_TOL * 10);
    }
}

/* Coefficients of the rows that lean on a direction, to the last digits: any other direction of the circle would hold as well. */
TEST(rows_point_where_the_header_says)
{
    static const int32_t kinds[] = { 0, 5, 8, 9, 12, 64 };
    const double pi = 3.14159265358979323846;
    for (int q = 0; q < 6; q++)
        for (int32_t state = 2; state < 64; state++) {
            if (state == 3) continue;
            const sp_arena mark = test_arena;
            const int32_t faces = kinds[q];
            NEED(begin(faces, 1));
            const int v = test_random_int(0, LEAF_POINTS - 1);
            const double mu = leaf_mu(&o, v) * (faces ? cos(pi / faces) : 1), outer = faces > 8 ? mu / cos(pi / faces) : mu;
            int h = 0;
            while (state >> h > 7) h++;
            const double part = pi / 2 / (1 << h), from = (state - (4 << h)) * part;
            for (int32_t row = 1; row < SP__PROOF_ROWS; row++) {
                if (row > 5 && row < 13 && row != 12 && row != 10) continue;
                clear();
                w->state[v] = state;
                const int there = sp__refute_add(w, LEAF_N + 1 + SP__PROOF_ROWS * v + row, row == 21 ? -1 : 1);
                const int exact = faces && faces <= 8;
                double turn, size = 1, n = 0, *to = NULL, f[3], d[3];
                for (int k = 0; k < 3; k++) { f[k] = (double)w->f[v][k]; d[k] = (double)w->d[v][k]; }
                if (row < 5) { turn = pi / 4 * (row - 1); to = d; CHECK_INT(there, 1); }
                else if (row == 5) { turn = from + part / 2; to = d; CHECK_INT(there, state > 3); }
                else if (row < 13) {
                    CHECK_INT(there, state > 3 && !exact);
                    if (faces) continue;
                    turn = from + (row - 10) * part / 2; to = f; size = -1; n = -mu;
                }
                else if (row < 21) {
                    turn = 2 * pi * (row - 13) / (exact ? faces : 8); to = f; n = -outer;
                    CHECK_INT(there, !exact || row - 13 < faces);
                } else { CHECK_INT(there, row == 21); continue; }
                if (!there) continue;
                CHECK_WITHIN(to[0], n, TOL(1e-13, 1e-5));
                CHECK_WITHIN(to[1], size * cos(turn), TOL(1e-13, 1e-5));
                CHECK_WITHIN(to[2], size * sin(turn), TOL(1e-13, 1e-5));
            }
            test_arena = mark;
        }
}

/* a x dt >= 0 and b x dt <= 0 at a sector's ends a, b; a x ft <= s fn and b x ft >= -s fn, s = SP__SLIP times the most friction
 * there is: mu, at the corners of a circumscribed pyramid mu / cos(pi / K). Each by multipliers of one sign. */
TEST(a_sector_is_bound_at_its_ends)
{
    static const struct { int32_t row; int end, force, sign; } table[] = {
        { 6, 0, 0, -1 }, { 7, 1, 0, 1 }, { 8, 0, 1, 1 }, { 9, 1, 1, -1 }
    };
    const double pi = 3.14159265358979323846;
    for (int q = 0; q < 6; q++) {
        const sp_arena mark = test_arena;
        const int32_t faces = q < 2 ? 0 : q < 4 ? 5 : 12;
        NEED(begin(faces, q % 2));
        const int v = test_random_int(0, LEAF_POINTS - 1);
        const double s = (double)SP__SLIP * leaf_mu(&o, v) / (faces && !(q % 2) ? cos(pi / faces) : 1);
        for (int32_t state = 4; state < 64; state++)
            for (int k = 0; k < 4; k++) {
                const int32_t row = LEAF_N + 1 + SP__PROOF_ROWS * v + table[k].row;
                int h = 0;
                while (state >> h > 7) h++;
                const double turn = pi / 2 / (1 << h) * (state - (4 << h) + table[k].end), y = 1.5 * table[k].sign;
                const sp_real *got = table[k].force ? w->f[v] : w->d[v];
                clear();
                w->state[v] = state;
                CHECK_INT(sp__refute_add(w, row, R(-y)), 0);
                clear();
                CHECK_INT(sp__refute_add(w, row, R(y)), 1);
                CHECK_NEAR(got[0], table[k].force ? -fabs(y) * s : 0, TOL(1e-12, 1e-5));
                CHECK_WITHIN(got[1], -y * sin(turn), TOL(1e-13, 1e-5));
                CHECK_WITHIN(got[2], y * cos(turn), TOL(1e-13, 1e-5));
            }
        test_arena = mark;
    }
}

/* Rows 21 to 23 are fn, ft1, ft2: of an open corner with either sign, elsewhere fn >= 0 alone. */
TEST(an_open_corner_has_no_force_in_any_direction)
{
    NEED(begin(0, 1));
    for (int32_t state = 0; state < 8; state++)
        for (int k = 0; k < 3; k++)
            for (int sign = -1; sign < 2; sign += 2) {
                clear();
                w->state[1] = state;
                const int there = sp__refute_add(w, LEAF_N + 1 + SP__PROOF_ROWS + 21 + k, R(2 * sign));
                if (state == 3) continue;
                CHECK_INT(there, state == 1 || (k == 0 && sign < 0));
                for (int i = 0; i < 3 && there; i++) CHECK_WITHIN(w->f[1][i], i == k ? 2 * sign : 0, 0);
            }
}

/* Where slip is bound by components, only these rows bound it. */
TEST(rows_across_the_components_are_none_where_components_are_bound)
{
    NEED(begin(0, 1));
    o.set.coupled.box = 1;
    for (int32_t row = 1; row < 6; row++) {
        clear();
        w->state[0] = 5;
        CHECK_INT(sp__refute_add(w, LEAF_N + 1 + row, 1), row == 1 || row == 3);
    }
}

/* Rows of a block that is held are none. */
TEST(held_directions_have_no_row)
{
    NEED(begin(0, 1));
    clear();
    for (int32_t r = 0; r < LEAF_N; r++) CHECK_INT(sp__refute_add(w, r, 1), !leaf_held(r));
}

/* Leaves of random rows: what is least over the box, what is out, and what rounding may do, against the definition. */
TEST(a_leaf_is_what_its_definition_says)
{
    for (int k = 0; k < SOME_OF(400, 60); k++) {
        const sp_arena mark = test_arena;
        uint16_t row[LEAF_ENTRIES];
        sp_real y[LEAF_ENTRIES];
        int32_t n = 0;
        NEED(begin(k % 3 == 2 ? 5 : k % 3 == 1 ? 12 : 0, k % 2));
        if (k % 4 == 3) {                               /* contact without play */
            o.set.coupled.eps = 0;
            length = sp__coupled_lengths(&o.pb, &o.set);
        }
        for (int v = 0; v < LEAF_POINTS; v++) w->state[v] = (int32_t[]){ 0, 1, 2, 4, 7, 11, 25 }[test_random_int(0, 6)];
        clear();
        for (int tries = 0; tries < 300 && n < 24; tries++) {
            sp_real x;
            const int32_t r = some_row(&x);
            if (r == LEAF_N && tries % 4) continue;
            const double before = (double)w->right;
            const sums s = kept();
            if (sp__refute_add(w, r, x) && (double)w->right <= before) { row[n] = (uint16_t)r; y[n++] = x; continue; }
            for (int v = 0; v < LEAF_POINTS; v++) {     /* a row that would raise sum y b is not taken */
                for (int q = 0; q < 3; q++) { w->f[v][q] = R(s.f[v][q]); w->d[v][q] = R(s.d[v][q]); }
                w->fsize[v] = R(s.fsize[v]); w->dsize[v] = R(s.dsize[v]);
            }
            for (int q = 0; q < LEAF_N; q++) w->motion[q] = R(s.y[q]);
            w->work = R(s.work); w->right = R(s.right); w->size = R(s.size); w->slack = R(s.slack);
        }
        const sums s = kept();
        double size = s.size, slack = s.slack + s.work * (double)w->slack_of_work;
        for (int i = 0; i < LEAF_BLOCKS; i++)
            slack += 0.01 * ((double)o.j.scale[i].s * leaf_norm(s.y + 6 * i) + (double)o.j.scale[i].S * leaf_norm(s.y + 6 * i + 3));
        const double forces = least_force(&s, &size);
        CHECK_WITHIN(sp__refute_least_force(w), forces, LEAF_TOL * (1 + size));
        CHECK_WITHIN(w->size, size, LEAF_TOL * (1 + size));
        const double motions = least_motion(&s, &size, &slack);
        CHECK_WITHIN(sp__refute_least_motion(w), motions, LEAF_TOL * (1 + size));
        CHECK_WITHIN(w->size, size, LEAF_TOL * (1 + size));

        /* A wide box hides gaps by rounding: 16 u of what its corners may move. */
        for (int r = 0; r < LEAF_N; r++) w->reach[r] *= R(1e9);
        const double before = (double)w->slack;
        double hidden = 0, none = 0;
        least_motion(&s, &none, &hidden);
        sp__refute_least_motion(w);
        CHECK_NEAR((double)w->slack - before, hidden, TOL(1e-6, 1e-2));
        for (int r = 0; r < LEAF_N; r++) w->reach[r] *= R(1e-9);

        /* A tight box: what is left is - sum y b - slack, and rounding. */
        for (int part = 0; part < 3; part++) {
            const double less = part == 0 ? 1 : part == 1 ? 1e-3 : 1e-5;
            if (part) {
                for (int v = 0; v < LEAF_POINTS; v++) w->F[v] *= R(less);
                for (int r = 0; r < LEAF_N; r++) w->reach[r] *= R(less);
            }
            size = s.size;
            slack = s.slack + s.work * (double)w->slack_of_work;
            for (int i = 0; i < LEAF_BLOCKS; i++)
                slack += 0.01 * ((double)o.j.scale[i].s * leaf_norm(s.y + 6 * i) + (double)o.j.scale[i].S * leaf_norm(s.y + 6 * i + 3));
            const double all = least_force(&s, &size) + least_motion(&s, &size, &slack) - s.right;
            const double margin = all - slack - (32 + n) * (double)SP_EPSILON * size;
            const sp_proof proof = { .entries = n, .row = row, .y = y };
            w->proof = &proof;
            const double got = (double)sp__refute_leaf(w, 0, n), want = margin > 0 ? margin / s.size : 0;
            if (fabs(margin) > LEAF_TOL * 10 * (1 + size)) CHECK_WITHIN(got, want, LEAF_TOL * (1 + size) / s.size);
        }
        test_arena = mark;
    }
}

/* Multipliers so large that their products round by more than the margin prove nothing: (32 + n) u of all sizes is taken off.
 * y and -y of the same row leave c as it is. */
TEST(rounding_is_taken_off_a_margin)
{
    NEED(begin(0, 1));
    uint16_t row[3] = { 1, 1, 0 };
    sp_real y[3] = { 0, 0, 0 };
    const sp_proof proof = { .entries = 3, .row = row, .y = y };
    w->proof = &proof;
    for (int v = 0; v < LEAF_POINTS; v++) w->F[v] *= R(1e-4);
    y[2] = o.p[0] > 0 ? 1 : -1;
    const double plain = (double)sp__refute_leaf(w, 0, 3) * fabs(o.p[0]);
    NEED(plain > 0);
    for (double big = 1; big < 1e30; big *= 2) {
        y[0] = R(big);
        y[1] = R(-big);
        double size = fabs(o.p[0]) + 2 * big * fabs(o.p[1]);
        const double scale = size;
        sums s;
        memset(&s, 0, sizeof s);
        s.y[0] = (double)y[2];
        const double least = least_force(&s, &size), want = plain - 35 * (double)SP_EPSILON * (scale - fabs(o.p[0]));
        CHECK(least <= 0);
        const double got = (double)sp__refute_leaf(w, 0, 3) * scale;
        if (want < 0.02 * plain) { CHECK_WITHIN(got, 0, 0); return; }
        if (want < 0.9 * plain) CHECK_NEAR(got, want, TOL(1e-9, 1e-4));
    }
    CHECK(0);
}

/* ------------------------------------------------------------------------------------------------------------- the box */

/* Least y'(G y) matters not: M y = e by elimination of the dense G = W Aeq Aeq' W over the free rows. */
static int solve(double G[LEAF_N][LEAF_N], double x[LEAF_N])
{
    for (int k = 0; k < LEAF_N; k++) {
        int best = k;
        for (int r = k; r < LEAF_N; r++) if (fabs(G[r][k]) > fabs(G[best][k])) best = r;
        for (int c = 0; c < LEAF_N; c++) { const double t = G[k][c]; G[k][c] = G[best][c]; G[best][c] = t; }
        const double t = x[k]; x[k] = x[best]; x[best] = t;
        if (!(fabs(G[k][k]) > 1e-9)) return 0;
        for (int r = 0; r < LEAF_N; r++) {
            const double by = r == k ? 0 : G[r][k] / G[k][k];
            for (int c = k; c < LEAF_N && r != k; c++) G[r][c] -= by * G[k][c];
            if (r != k) x[r] -= by * x[k];
        }
    }
    for (int k = 0; k < LEAF_N; k++) x[k] /= G[k][k];
    return 1;
}

static double weight(int r) { return (double)(r % 6 < 3 ? o.j.scale[r / 6].wf : o.j.scale[r / 6].wm); }

/* |dq_r| <= 1.01 W sum |Aeq' W x| 2 (eta + eps),  G x = e_r. */
static double reach(int r)
{
    double G[LEAF_N][LEAF_N], x[LEAF_N], sum = 0;
    for (int i = 0; i < LEAF_N; i++) {
        x[i] = i == r;
        for (int k = 0; k < LEAF_N; k++) {
            G[i][k] = i == k && leaf_held(i);
            for (int q = 0; q < 3 * LEAF_POINTS && !leaf_held(i) && !leaf_held(k); q++)
                G[i][k] += weight(i) * o.A[i][q] * o.A[k][q] * weight(k);
        }
    }
    if (!solve(G, x)) return -1;
    for (int v = 0; v < LEAF_POINTS; v++) {
        double u[3] = { 0, 0, 0 };
        for (int k = 0; k < 3; k++) for (int i = 0; i < LEAF_N; i++) u[k] += o.A[i][3 * v + k] * weight(i) * x[i];
        sum += leaf_norm(u) * 2 * (double)(length.eta + length.eps);
    }
    return 1.01 * weight(r) * sum;
}

TEST(no_motion_reaches_beyond_what_its_corners_allow)
{
    for (int k = 0; k < 5; k++) {
        const sp_arena mark = test_arena;
        NEED(begin(0, 1));
        for (int r = 0; r < LEAF_N; r++) w->reach[r] = -1;
        NEED(sp__refute_reach(w));
        for (int r = 0; r < LEAF_N; r++) {
            const double want = leaf_held(r) ? 0 : reach(r);
            if (want >= 0) CHECK_NEAR(w->reach[r], want, TOL(1e-6, 1e-2));
        }
        o.j.sweeps_most = o.j.sweeps;                   /* no step is left to find x with */
        CHECK_INT(sp__refute_reach(w), 0);
        test_arena = mark;
    }
}

/* Where x is found only in part, what is missing of e is bound by the farthest motion. Steps are counted once, then taken away
 * from the last row's second solution. */
TEST(a_reach_that_is_found_in_part_counts_what_is_missing)
{
    const int last = LEAF_N - 1;
    int partly = 0, loosely = 0;
    for (int scene = 0; scene < 4; scene++) {
        const sp_arena mark = test_arena;
        NEED(begin(0, 1));
        const int32_t start = o.j.sweeps;
        NEED(sp__refute_reach(w));
        const int32_t all = o.j.sweeps - start;
        double farthest = 0;
        for (int r = 0; r < LEAF_N; r++) farthest = fmax(farthest, leaf_held(r) ? 0 : (double)w->reach[r] / 1.01 / weight(r));
        for (int32_t fewer = 2; fewer < 12; fewer++) {
            double miss = 0, stretch = 0;
            o.j.sweeps = 0;
            o.j.sweeps_most = all - fewer;
            NEED(sp__refute_reach(w));
            for (int q = 0; q < LEAF_N; q++) miss += fabs((double)o.j.image[q] - (q == last));
            for (int v = 0; v < LEAF_POINTS; v++) {
                double u[3] = { 0, 0, 0 };
                for (int c = 0; c < 3; c++)
                    for (int i = 0; i < LEAF_N; i++) u[c] += o.A[i][3 * v + c] * weight(i) * (double)o.j.dual.potential[i];
                stretch += leaf_norm(u) * 2 * (double)(length.eta + length.eps);
            }
            const double want = 1.01 * weight(last) * (stretch + miss * fmax(farthest, stretch));
            CHECK_NEAR(w->reach[last], want, TOL(1e-6, 2e-2));
            partly += miss > 0.1;

            /* As much less in the first round: worst is what is missing there; the second finds nothing, so it misses 1. */
            o.j.sweeps = 0;
            o.j.sweeps_most = all / 2 - fewer;
            const int bound = sp__refute_reach(w);
            CHECK_INT(bound, miss < 0.5);
            for (int r = 0; r < LEAF_N && bound; r++)
                CHECK_NEAR(w->reach[r], leaf_held(r) ? 0 : 1.01 * weight(r) * fmax(farthest, stretch) / (1 - miss),
                           TOL(1e-6, 2e-2));
            loosely += bound && miss > 0.1;
        }
        test_arena = mark;
    }
    CHECK(partly > TOL(2, -1));
    CHECK(loosely > TOL(0, -1));
}

/* A refutation w of the scene in o, blocks of as many corners each.     returns 0: the test is over */
static int refutation_of(int32_t blocks, int32_t corners)
{
    o.set.tol = R(1e-4);
    o.set.force_bound = 100;
    if (!CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK)) return 0;
    if (!CHECK(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, INT32_MAX, &test_arena))) return 0;
    length.L = length.eps = 1; length.eta = 100;
    w = sp__take(&test_arena, 1, sizeof *w);
    if (!CHECK(w)) return 0;
    sp__refute_carve(w, blocks * corners, blocks, &test_arena);
    if (!CHECK(!sp__failed(&test_arena))) return 0;
    w->j = &o.j;
    w->k = &length;
    for (int32_t v = 0; v < blocks * corners; v++) { w->contact[v] = v / corners; w->at[v] = v; }
    return 1;
}

/* A block on one point that may move along x and turn about y, unlike in their weights. One step for the last row leaves
 * (t^2 + t) / (1 + t^2) of it, t = G_xy / G_yy: a half at sqrt 2 - 1. */
TEST(motions_are_bound_where_less_than_half_of_a_direction_is_missing)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, 1, 0 };
    const sp_real ground[3] = { 0, 0, -9 }, at[3] = { 0, 0, 0 }, up[3] = { 0, 0, 1 }, point[3] = { 2, 0, 1 };
    const sp_strength rough = sp_strength_friction(R(0.5));
    const uint32_t held = 2 | 4 | 8 | 32;
    for (int beyond = 0; beyond < 2; beyond++) {
        const sp_arena mark = test_arena;
        memset(&o, 0, sizeof o);
        NEED(sp_scene_create(&o.scene, &cap, &test_arena) == SP_OK);
        NEED(sp_scene_body(&o.scene, 0, ground, SP_FIXED, NULL) == SP_OK);
        NEED(sp_scene_body(&o.scene, 1, at, held, NULL) == SP_OK);
        NEED(sp_scene_points(&o.scene, 0, 1, up, 1, point, &rough, NULL) == SP_OK);
        NEED(refutation_of(1, 1));
        o.j.scale[0].wm = 1;                            /* t = wf wm z / (wm^2 (x^2 + z^2)) */
        o.j.scale[0].wf = R(5 * (sqrt(2.0) - 1) * (1 + (beyond ? 1 : -1) * TOL(1e-6, 1e-2)));
        sp_real to[6] = { 0 };
        for (int k = 0; k < 6; k++) o.j.residual[k] = k == 0;
        o.j.sweeps = 0;
        sp__certifier_least_squares(&o.j, to);
        o.j.sweeps_most = o.j.sweeps + 1 + 2;           /* what x takes, and y up to its first step */
        o.j.sweeps = 0;
        CHECK_INT(sp__refute_reach(w), !beyond);
        test_arena = mark;
    }
}

/* Blocks that touch nothing but the ground: each is bound as it would be were it there alone. */
TEST(blocks_apart_reach_as_far_as_each_alone)
{
    enum { APART = 7 };
    const sp_real ground[3] = { 0, 0, -1 };
    const sp_strength rough = sp_strength_friction(R(0.5));
    double alone[6 * APART];
    for (int part = 0; part <= APART; part++) {         /* one by one, then all */
        const sp_arena mark = test_arena;
        const int32_t from = part < APART ? part : 0, blocks = part < APART ? 1 : APART;
        const sp_capacity cap = { blocks + 1, 0, 0, 0, blocks, 4 * blocks, 0 };
        memset(&o, 0, sizeof o);
        NEED(sp_scene_create(&o.scene, &cap, &test_arena) == SP_OK);
        NEED(sp_scene_body(&o.scene, 0, ground, SP_FIXED, NULL) == SP_OK);
        for (int32_t b = 0; b < blocks; b++) {
            const sp_real h = R(0.1) * R(from + b + 1), x = 3 * R(from + b), at[3] = { x, 0, h };
            const sp_real foot[12] = { x - h, -h, 0, x + h, -h, 0, x + h, h, 0, x - h, h, 0 };
            NEED(sp_scene_body(&o.scene, 1, at, 0, NULL) == SP_OK);
            NEED(sp_scene_joint(&o.scene, 0, b + 1, 4, foot, &rough, NULL) == SP_OK);
        }
        NEED(refutation_of(blocks, 4));
        NEED(sp__refute_reach(w));
        for (int r = 0; r < 6 * blocks; r++) {
            if (part < APART) alone[6 * from + r] = (double)w->reach[r];
            else CHECK_NEAR(w->reach[r], alone[r], TOL(1e-6, 1e-2));
        }
        test_arena = mark;
    }
}

/* A block that touches at one line may spin about it at any rate: that spin is taken out of e, in its own rows. */
TEST(a_block_on_one_line_is_bound_but_for_its_spin)
{
    const sp_capacity cap = { 3, 0, 0, 0, 3, 8, 0 };
    const sp_real at[3][3] = { { 0, 0, -1 }, { 5, 0, 1 }, { R(0.3), R(0.2), 1 } };
    const sp_real line[6] = { -1, -1, 0, 1, R(0.5), 0 }, up[3] = { 0, 0, 1 };
    const sp_real foot[12] = { 4, -1, 0, 6, -1, 0, 6, 1, 0, 4, 1, 0 };
    const sp_strength rough = sp_strength_friction(R(0.5));
    memset(&o, 0, sizeof o);
    NEED(sp_scene_create(&o.scene, &cap, &test_arena) == SP_OK);
    for (int b = 0; b < 3; b++) NEED(sp_scene_body(&o.scene, R(b), at[b], b ? 0 : SP_FIXED, NULL) == SP_OK);
    NEED(sp_scene_joint(&o.scene, 0, 1, 4, foot, &rough, NULL) == SP_OK);
    NEED(sp_scene_points(&o.scene, 0, 2, up, 2, line, &rough, NULL) == SP_OK);
    o.set.tol = R(1e-4);
    o.set.force_bound = 100;
    NEED(sp_problem_build(&o.scene, &test_arena, &o.pb) == SP_OK);
    NEED(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, INT32_MAX, &test_arena));
    const double along[3] = { 2, 1.5, 0 }, from[3] = { -1.3, -1.2, -1 };
    double spin[6], size = 0;
    for (int k = 0; k < 3; k++) {                       /* turn about the line, seen from the centroid: v = first x along */
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        spin[k] = (along[a] * from[b] - along[b] * from[a]) * -1 / (double)o.j.scale[1].wf;
        spin[3 + k] = along[k] / (double)o.j.scale[1].wm;
    }
    for (int k = 0; k < 6; k++) size += spin[k] * spin[k];
    for (int r = 0; r < 12; r++) {
        sp_real e[14];
        e[12] = e[13] = R(7);
        sp__refute_unit(&o.j, r, e);
        for (int q = 0; q < 12; q++) {
            const double want = (q == r) - (r > 5 && q > 5 ? spin[r - 6] * spin[q - 6] / size : 0);
            CHECK_WITHIN(e[q], want, TOL(1e-12, 1e-5));
        }
        CHECK(e[12] >= 7 && e[13] >= 7);
    }
}

/* A spin that the block is held against is none: across the line, or where the line does not pass its centroid. */
TEST(a_block_held_against_its_spin_has_none)
{
    static const struct { uint32_t held; double height; int spins; } table[] = {
        { 0, 1, 1 }, { 0, 0, 1 }, { 8, 1, 0 }, { 8, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 }, { 1 | 4 | 16 | 32, 1, 1 }, { 4, 0, 1 }
    };
    const sp_capacity cap = { 2, 0, 0, 0, 1, 2, 0 };
    const sp_real ground[3] = { 0, 0, -1 }, line[6] = { -1, 0, 0, 1, 0, 0 }, up[3] = { 0, 0, 1 };
    const sp_strength rough = sp_strength_friction(R(0.5));
    for (size_t k = 0; k < sizeof table / sizeof table[0]; k++) {
        const sp_arena mark = test_arena;
        const sp_real at[3] = { 0, 0, R(table[k].height) };
        sp_real spin[6];
        memset(&o, 0, sizeof o);
        NEED(sp_scene_create(&o.scene, &cap, &test_arena) == SP_OK);
        NEED(sp_scene_body(&o.scene, 0, ground, SP_FIXED, NULL) == SP_OK);
        NEED(sp_scene_body(&o.scene, 1, at, table[k].held, NULL) == SP_OK);
        NEED(sp_scene_points(&o.scene, 0, 1, up, 2, line, &rough, NULL) == SP_OK);
        o.set.tol = R(1e-4);
        o.set.force_bound = 100;
        NEED(sp_problem_build(&o.scene, &test_arena, &o.pb) == SP_OK);
        NEED(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, INT32_MAX, &test_arena));
        if (!CHECK_INT(sp__certifier_free_spin(&o.j, 0, spin), table[k].spins)) TEST_PRINT("    case %d\n", (int)k);
        if (table[k].spins) {                           /* turn about x, y moved by as much as the centroid is high: |k| = 1 */
            const double m = 1 / (double)o.j.scale[0].wm, f = table[k].height / (double)o.j.scale[0].wf, n = sqrt(m * m + f * f);
            CHECK_NEAR(fabs((double)spin[3]), m / n, TOL(1e-12, 1e-5));
            CHECK_WITHIN(fabs((double)spin[1]), f / n, TOL(1e-12, 1e-5));
        }
        test_arena = mark;
    }
}

/* Caps, or what the row of work leaves of them where eps > 0; what that row may be out by. */
TEST(no_force_is_larger_than_its_cap_or_than_work_allows)
{
    for (int k = 0; k < 20; k++) {
        const sp_arena mark = test_arena;
        NEED(begin(0, 1));
        const double tol = 0.01, shrink = pow(10, -k % 10 / 2.0);
        double work = 0, slack = 0, total = 0, s[LEAF_BLOCKS], cap[LEAF_BLOCKS];
        if (k >= 10) { length.eps = 0; length.eta = 1; }
        for (int r = 0; r < LEAF_N; r++) {
            w->reach[r] *= R(shrink);
            work += fabs(o.p[r]) * (double)w->reach[r];
            slack += tol * (double)w->reach[r] * (double)(r % 6 < 3 ? o.j.scale[r / 6].s : o.j.scale[r / 6].S);
        }
        for (int i = 0; i < LEAF_BLOCKS; i++) { s[i] = (double)o.j.scale[i].s; cap[i] = 100 * (double)o.j.scale[i].force_cap; }
        for (int v = 0; v < LEAF_POINTS; v++) {
            slack += 2 * tol * leaf_lesser(&o, v, s) * (double)length.eta;
            total += leaf_lesser(&o, v, cap);
        }
        const double bound = length.eps > 0 ? 1.01 * (work + slack) : 1e300;
        sp__refute_forces(w);
        for (int v = 0; v < LEAF_POINTS; v++) {
            CHECK_NEAR(w->F[v], fmin(bound, leaf_lesser(&o, v, cap)), TOL(1e-12, 1e-5));
            CHECK_NEAR(w->any_friction[v], tol * leaf_lesser(&o, v, s), TOL(1e-12, 1e-5));
        }
        CHECK_NEAR(w->total, fmin(bound, total), TOL(1e-12, 1e-5));
        CHECK_NEAR(w->slack_of_work, slack + (double)SP__GIVE * fmin(bound, total), TOL(1e-12, 1e-5));
        test_arena = mark;
    }
}

/* ------------------------------------------------------------------------------------------------------------ the walk */

/* A leaf that holds in every state: y p > 0 of a balance in a box of nothing. */
static void easy(void)
{
    for (int v = 0; v < LEAF_POINTS; v++) w->F[v] = w->any_friction[v] = 0;
    for (int r = 0; r < LEAF_N; r++) w->reach[r] = 0;
    w->slack_of_work = 0;
    o.set.tol = 0;
}

static sp_real walk(int32_t nodes, const int32_t *node, int32_t entries, const uint16_t *row, const sp_real *y)
{
    const sp_proof proof = proof_of(nodes, node, entries, row, y);
    w->proof = &proof;
    return sp__refute_walk(w);
}

/* 0 into open and closed, closed into quarters, quarters into halves: the tree is told by its leaves, each once, in order. */
TEST(every_case_of_a_tree_is_closed_once_and_in_order)
{
    static const uint16_t row[16] = { 0 };
    sp_real y[16];
    NEED(begin(0, 1));
    easy();
    for (int k = 0; k < 16; k++) y[k] = o.p[0] > 0 ? 1 : -1;
    static const struct { int32_t nodes, node[14], entries; int holds; } tree[] = {
        { 1, { -1 }, 1, 1 },
        { 3, { 0, -1, -1 }, 2, 1 },
        { 2, { 0, -1 }, 2, 0 },                         /* closed is left out */
        { 4, { 0, -1, -1, -1 }, 3, 0 },                 /* one leaf too many */
        { 7, { 3, -1, 3, -1, -1, -1, -1 }, 5, 1 },
        { 6, { 3, -1, 3, -1, -1, -1 }, 5, 0 },
        { 8, { 3, -1, 3, -1, -1, -1, -1, -1 }, 6, 0 },
        { 9, { 3, -1, 3, -1, 3, -1, -1, -1, -1 }, 6, 1 },       /* a quarter into halves */
        { 8, { 3, -1, 3, -1, 3, -1, -1, -1 }, 6, 0 },
        { 5, { 0, 1, -1, -1, -1 }, 3, 1 },              /* another corner where the first is open */
        { 3, { 0, 0, -1 }, 3, 0 },                      /* open is not split */
        { 3, { 9, -1, -1 }, 2, 0 },                     /* no such corner */
        { 3, { INT32_MAX, -1, -1 }, 2, 0 },
        { 1, { -2 }, 1, 0 }, { 1, { INT32_MIN }, 1, 0 }, { 1, { -1 }, 0, 0 }, { 3, { 0, -1, -1 }, 1, 0 },
        { 3, { 0, -2, -1 }, 2, 0 }, { 3, { 0, -2, -1 }, 3, 1 }, { 3, { 0, -1, -2 }, 3, 1 }
    };
    for (size_t k = 0; k < sizeof tree / sizeof tree[0]; k++)
        if (!CHECK_INT(walk(tree[k].nodes, tree[k].node, tree[k].entries, row, y) > 0, tree[k].holds))
            TEST_PRINT("    tree %d\n", (int)k);
    y[1] = -y[1];                                       /* one leaf that does not hold */
    CHECK(!(walk(3, tree[1].node, 2, row, y) > 0));
    CHECK(!(walk(7, tree[4].node, 5, row, y) > 0));
}

/* A leaf sees the states that its splits gave: row 22 (ft1 = 0) holds of an open corner only, row 12 of a sector only. */
TEST(each_case_has_the_states_of_its_splits)
{
    NEED(begin(0, 1));
    easy();
    const uint16_t open = LEAF_N + 1 + 2 * SP__PROOF_ROWS + 22, sector = LEAF_N + 1 + 2 * SP__PROOF_ROWS + 12;
    const uint16_t row[12] = { 0, open, 0, sector, 0, sector, 0, sector, 0, sector };
    uint16_t other[12];
    sp_real y[12];
    for (int k = 0; k < 12; k++) y[k] = k % 2 ? 1 : o.p[0] > 0 ? 1 : -1;
    static const int32_t node[7] = { 2, -2, 2, -2, -2, -2, -2 };
    CHECK(walk(7, node, 10, row, y) > 0);
    for (int k = 1; k < 10; k += 2) {
        memcpy(other, row, sizeof other);
        other[k] = k == 1 ? sector : open;              /* what this case has not */
        CHECK(!(walk(7, node, 10, other, y) > 0));
    }
    CHECK_INT(w->state[2] >= 0, 1);
}

/* What a leaf proves depends on its rows, not on how many rows of other leaves lie before them. */
TEST(a_leaf_is_the_same_wherever_its_rows_stand)
{
    enum { ROOM = 200 };
    static uint16_t row[ROOM];
    static sp_real y[ROOM];
    NEED(begin(0, 1));
    const sp_proof proof = { .entries = ROOM, .row = row, .y = y };
    w->proof = &proof;
    easy();
    y[0] = y[ROOM - 1] = o.p[0] > 0 ? 1 : -1;
    const sp_real first = sp__refute_leaf(w, 0, 1);
    CHECK(first > 0);
    CHECK_WITHIN(sp__refute_leaf(w, ROOM - 1, ROOM), first, 0);
}

/* Nodes end where they say, with cases that are not closed: what lies behind is no node. Sanitizers see it. */
TEST(a_proof_that_is_cut_off_is_not_read_on)
{
    static const int32_t cut[2] = { 0, -1 };
    static const uint16_t row[2] = { 0, 0 };
    NEED(begin(0, 1));
    easy();
    const sp_real s = o.p[0] > 0 ? 1 : -1, y[2] = { s, s };
    CHECK(!(walk(2, cut, 2, row, y) > 0));
    CHECK(!(walk(1, cut, 2, row, y) > 0));
}

/* All corners are unknown to the first leaf, whatever was walked before: that a corner is open is no row of it. */
TEST(a_walk_begins_where_nothing_is_known)
{
    NEED(begin(0, 1));
    easy();
    static const int32_t node[1] = { -2 };
    const sp_real y[2] = { o.p[0] > 0 ? 1 : -1, 1 };
    for (int v = 0; v < LEAF_POINTS; v++) {
        const uint16_t row[2] = { 0, (uint16_t)(LEAF_N + 1 + SP__PROOF_ROWS * v + 22) };
        for (int q = 0; q < LEAF_POINTS; q++) w->state[q] = 1;
        CHECK(!(walk(1, node, 2, row, y) > 0));
    }
}

/* The margin of a tree is that of its worst leaf. */
TEST(a_tree_holds_as_well_as_its_worst_leaf)
{
    NEED(begin(0, 1));
    easy();
    const uint16_t row[4] = { 0, 0, 0, 0 };
    sp_real y[4];
    static const int32_t one[1] = { -1 }, node[3] = { 0, -1, -1 };
    w->slack_of_work = 0;
    for (int v = 0; v < LEAF_POINTS; v++) w->F[v] = R(1e-3);
    const sp_real s = o.p[0] > 0 ? 1 : -1;
    y[0] = s;
    const double plain = (double)walk(1, one, 1, row, y);
    CHECK(plain > 0 && plain < 1);
    /* the same row twice with opposite signs weakens it: sizes grow */
    const uint16_t more[5] = { 0, 0, 1, 1, 0 };
    const sp_real z[5] = { s, s, 1, -1, s };
    static const int32_t worse[3] = { 0, -1, -3 }, first[3] = { 0, -3, -1 };
    const double mixed = (double)walk(3, worse, 4, more, z), swapped = (double)walk(3, first, 4, more + 1, z + 1);
    CHECK_NEAR(walk(3, node, 2, row, (const sp_real[]){ s, s }), plain, TOL(1e-12, 1e-5));
    CHECK(mixed > 0 && mixed < 0.99 * plain);
    CHECK_NEAR(swapped, mixed, TOL(1e-12, 1e-5));
}

/* SP__PROOF_DEPTH splits for every corner are walked, no more; a sector is halved to 2^-24 of a quarter. */
TEST(a_tree_may_be_deep_but_not_without_end)
{
    enum { DEPTH = 40 };
    static int32_t node[2 * DEPTH + 16];
    static uint16_t row[DEPTH + 16];
    static sp_real y[DEPTH + 16];
    NEED(begin(0, 1));
    easy();
    for (int k = 0; k < DEPTH + 16; k++) y[k] = o.p[0] > 0 ? 1 : -1;
    for (int halvings = 20; halvings < 30; halvings++) {
        int32_t n = 0, leaves = 2;
        node[n++] = 0; node[n++] = -1; node[n++] = 0;   /* open; closed into quarters, the first halved so often */
        for (int h = 0; h < halvings; h++) node[n++] = 0;
        for (int h = 0; h < halvings + 4; h++, leaves++) node[n++] = -1;
        CHECK_INT(walk(n, node, leaves - 1, row, y) > 0, halvings <= 24);
    }
}

/* A corner takes three whole numbers, two for each of 32 splits above a leaf, and ten numbers. */
TEST(a_refutation_has_room_for_32_splits_of_every_corner)
{
    const size_t corner = (3 + 2 * 32) * sizeof(int32_t) + 10 * sizeof(sp_real);
    CHECK_INT(sp__refute_need(48, 1) - sp__refute_need(16, 1), 32 * corner);
}

/* Nothing is read of a proof that is none; whole proofs take exactly what was counted. */
TEST(what_is_no_proof_is_none)
{
    NEED(begin(0, 1));
    int32_t node[1] = { -1 };
    uint16_t row[1] = { 0 };
    sp_real y[1] = { 0 };
    const sp_proof good = { .nodes = 1, .entries = 1, .node = node, .row = row, .y = y };
    const size_t need = sp__refute_need(LEAF_POINTS, o.pb.blocks);
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
        CHECK(!(sp__certify_refutation(&o.j, &length, &p, &a) > 0));
        CHECK_INT(a.used, used);                        /* nothing was begun */
    }
    const size_t from = (test_arena.used + SP_ALIGN - 1) / SP_ALIGN * SP_ALIGN;
    for (size_t bytes = 0; bytes <= need; bytes += SP_ALIGN) {
        sp_arena a = { test_arena.base + from, bytes, 0, 0 };
        memset(a.base + bytes, 0x5a, 64);
        CHECK(!(sp__certify_refutation(&o.j, &length, &good, &a) > 0));
        CHECK(bytes < need ? sp__failed(&a) || !(a.used == need) : a.used == need && !sp__failed(&a));
        for (int k = 0; k < 64; k++) NEED(a.base[bytes + (size_t)k] == 0x5a);
    }
}

/* A block under a ceiling, or on the ground, that it touches at so many corners; judged with its weight as the unit. */
static int hang(int32_t points, int hangs)
{
    const sp_capacity cap = { 2, 0, 0, 0, 1, points, 0 };
    const sp_real up = R(hangs ? -1 : 1), support[3] = { 0, 0, 0 }, at[3] = { R(0.1), R(0.2), up }, n[3] = { 0, 0, up };
    const sp_strength rough = sp_strength_friction(R(0.5));
    sp_real x[3 * (SP_EXACT_POINTS + 1)];
    for (int32_t v = 0; v < points; v++) {
        x[3 * v] = R(cos(6 * v / (double)points));
        x[3 * v + 1] = R(sin(6 * v / (double)points));
        x[3 * v + 2] = 0;
    }
    memset(&o, 0, sizeof o);
    if (!CHECK_INT(sp_scene_create(&o.scene, &cap, &test_arena), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&o.scene, 0, support, SP_FIXED, NULL), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&o.scene, 1, at, 0, NULL), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_points(&o.scene, 0, 1, n, points, x, &rough, NULL), SP_OK)) return 0;
    o.set.tol = R(0.01);
    o.set.force_bound = 100;
    if (!CHECK_INT(sp_problem_build(&o.scene, &test_arena, &o.pb), SP_OK)) return 0;
    length.L = length.eps = 1; length.eta = 100;
    return CHECK(sp__certifier_open(&o.j, &o.pb, &o.set, NULL, INT32_MAX, &test_arena));
}

/* That nothing carries its weight: one multiplier, of the balance along z. */
static sp_real weight_is_not_carried(void)
{
    static const int32_t node[1] = { -1 };
    static const uint16_t row[1] = { 2 };
    static const sp_real y[1] = { -1 };
    const sp_proof proof = proof_of(1, node, 1, row, y);
    sp_arena a = test_arena;
    return sp__certify_refutation(&o.j, &length, &proof, &a);
}

/* A joint that only presses down cannot hold a block: least c f = 0, sum y b = -W; less what balance may be out by, tol sbar,
 * and what forces up to their caps may round. No proof is walked of more corners than SP_EXACT_POINTS. */
TEST(a_block_under_a_ceiling_is_refuted_by_its_weight)
{
    static const int32_t points[] = { 3, 4, 17, SP_EXACT_POINTS, SP_EXACT_POINTS + 1 };
    for (int k = 0; k < 5; k++) {
        const sp_arena mark = test_arena;
        NEED(hang(points[k], 1));
        const double want = 1 - (double)o.set.tol * (double)o.j.scale[0].s;
        CHECK_WITHIN(weight_is_not_carried(), points[k] > SP_EXACT_POINTS ? 0 : want, TOL(1e-9, 0.1));
        test_arena = mark;
    }
}

/* What motions are bound by is found in steps: without any, nothing bounds them, and the same proof is none. */
TEST(motions_without_bound_are_not_refuted)
{
    NEED(hang(4, 1));
    CHECK(weight_is_not_carried() > 0);
    o.j.sweeps_most = o.j.sweeps;
    CHECK(!(weight_is_not_carried() > 0));
}

/* On the ground the same multiplier leaves -F a corner: forces up to their caps, whatever the memory held before. */
TEST(a_block_on_the_ground_is_not_refuted_by_its_weight)
{
    for (int fill = 0; fill < 256; fill += 85) {
        const sp_arena mark = test_arena;
        NEED(hang(4, 0));
        memset(test_arena.base + test_arena.used, fill, sp__refute_need(4, 1) + SP_ALIGN);
        CHECK(!(weight_is_not_carried() > 0));
        test_arena = mark;
    }
}

TEST_LIST(leaf)
    RUN_FULL(what_a_row_adds_is_as_large_as_its_terms)
    RUN_FULL(rows_point_where_the_header_says)
    RUN_FULL(a_sector_is_bound_at_its_ends)
    RUN_FULL(an_open_corner_has_no_force_in_any_direction)
    RUN_FULL(rows_across_the_components_are_none_where_components_are_bound)
    RUN_FULL(held_directions_have_no_row)
    RUN_FULL(a_leaf_is_what_its_definition_says)
    RUN_FULL(rounding_is_taken_off_a_margin)
    RUN_FULL(no_motion_reaches_beyond_what_its_corners_allow)
    RUN_FULL(a_reach_that_is_found_in_part_counts_what_is_missing)
    RUN_FULL(motions_are_bound_where_less_than_half_of_a_direction_is_missing)
    RUN_FULL(blocks_apart_reach_as_far_as_each_alone)
    RUN_FULL(a_block_on_one_line_is_bound_but_for_its_spin)
    RUN_FULL(a_block_held_against_its_spin_has_none)
    RUN_FULL(no_force_is_larger_than_its_cap_or_than_work_allows)
    RUN_FULL(every_case_of_a_tree_is_closed_once_and_in_order)
    RUN_FULL(each_case_has_the_states_of_its_splits)
    RUN_FULL(a_leaf_is_the_same_wherever_its_rows_stand)
    RUN_FULL(a_proof_that_is_cut_off_is_not_read_on)
    RUN_FULL(a_walk_begins_where_nothing_is_known)
    RUN_FULL(a_tree_holds_as_well_as_its_worst_leaf)
    RUN_FULL(a_tree_may_be_deep_but_not_without_end)
    RUN_FULL(a_refutation_has_room_for_32_splits_of_every_corner)
    RUN_FULL(what_is_no_proof_is_none)
    RUN_FULL(a_block_under_a_ceiling_is_refuted_by_its_weight)
    RUN_FULL(motions_without_bound_are_not_refuted)
    RUN_FULL(a_block_on_the_ground_is_not_refuted_by_its_weight)
TEST_END
