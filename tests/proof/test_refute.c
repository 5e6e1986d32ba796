/* Every row of a refutation from the inside. A row is an inequality a x <= b that a proof may use in a given state of a contact
 * vertex, so it must hold for every triple in that state, and some triple must meet it: a looser row would be no error, but a
 * weaker proof than sp_proof says. Rows, states and lengths as in the header at sp_proof. */
#define SP_API static
#include "../test.h"
#include "../../solvers/base/words.c"
#include "../../solvers/scene/scene.c"
#include "../../solvers/scene/block.c"
#include "../../solvers/proof/refute.c"

#include <math.h>

#define PI 3.14159265358979323846

/* One block on one joint; the vertex looked at is its first. */
static sp_scene scene;
static sp_problem pb;
static sp_settings set;
static sp__certifier judge;
static sp__lengths length;
static sp__refute *w;
static double mu_effective;

static int begin(int32_t faces, int32_t inscribed, int32_t box)
{
    const sp_capacity room = { 2, 0, 0, 0, 1, 4, 0 };
    const sp_real ground[3] = { 0, 0, -1 }, at[3] = { 0, 0, R(0.5) }, corner[12] = { -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0 };
    const sp_strength strength = { R(0.6), 0, 0, 0 };
    memset(&set, 0, sizeof set);
    set.tol = R(TOL(1e-9, 1e-4f));
    set.force_bound = 100;
    set.iterations = 300;
    set.faces = faces;
    set.inscribed = inscribed;
    set.coupled.asked = 1;
    set.coupled.eps = R(1e-4);
    set.coupled.box = box;
    mu_effective = 0.6 * (faces && inscribed ? cos(PI / faces) : 1);
    if (!CHECK_INT(sp_scene_create(&scene, &room, &test_arena), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&scene, 0, ground, SP_FIXED, NULL), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_body(&scene, 1, at, 0, NULL), SP_OK)) return 0;
    if (!CHECK_INT(sp_scene_joint(&scene, 0, 1, 4, corner, &strength, NULL), SP_OK)) return 0;
    if (!CHECK_INT(sp_problem_build(&scene, &test_arena, &pb), SP_OK)) return 0;
    if (!CHECK(sp__certifier_open(&judge, &pb, &set, NULL, INT32_MAX, &test_arena))) return 0;
    length = sp__coupled_lengths(&pb, &set);
    w = sp__take(&test_arena, 1, sizeof *w);
    if (!CHECK(w)) return 0;
    memset(w, 0, sizeof *w);
    sp__refute_carve(w, 4, pb.blocks, &test_arena);
    w->j = &judge;
    w->k = &length;
    for (int32_t v = 0; v < 4; v++) {
        w->contact[v] = 0;
        w->at[v] = pb.contact[0].point + v;
        w->any_friction[v] = w->F[v] = 0;
    }
    return CHECK(!sp__failed(&test_arena));
}

/* The farthest that ft may reach along `turn` where fn = 1. */
static double reach(double turn)
{
    double most = set.faces ? 0 : 1;
    for (int32_t k = 0; k < set.faces; k++) most = fmax(most, cos(turn - 2 * PI * k / set.faces));
    return mu_effective / most;
}

/* The farthest that dt may reach along `turn`. */
static double slip(double turn)
{
    return (double)length.eta / (set.coupled.box ? fmax(fabs(cos(turn)), fabs(sin(turn))) : 1);
}

/* Where a sector of a state begins and ends. */
static void sector(int32_t state, double *from, double *to)
{
    int h = 0;
    while (state >> h > 7) h++;
    const double part = PI / 2 / (1 << h);
    *from = (state - (4 << h)) * part;
    *to = *from + part;
}

/* A triple in this state: number k < 64 is an extreme one (ends, middle, nothing and the most of each), others are random. */
static void triple(int32_t state, int k, double f[3], double d[3])
{
    const int edge = k < 64;
    const double much[2] = { edge ? k % 2 : (double)test_random_real(0, 1), edge ? k / 2 % 2 : (double)test_random_real(0, 1) };
    double turn = edge ? PI / 8 * (k / 4) : (double)test_random_real(0, 2 * PI);
    double back = edge ? turn : (double)test_random_real(0, 2 * PI);
    const double fn = edge ? 1 : (double)test_random_real(0, 5);
    if (state >= 4) {
        double from, to;
        sector(state, &from, &to);
        turn = from + (to - from) * (edge ? k / 4 % 9 / 8.0 : (double)test_random_real(0, 1));
        back = turn + PI;                               /* friction is opposite to slip */
    }
    f[0] = state == 1 ? 0 : fn;
    f[1] = f[0] * much[0] * reach(back) * cos(back);
    f[2] = f[0] * much[0] * reach(back) * sin(back);
    const double open = edge ? k / 4 % 2 : (double)test_random_real(0, 1);
    d[0] = -(double)length.eps + (state < 2 ? open * (double)(length.eta + length.eps) : 0);
    d[1] = much[1] * slip(turn) * cos(turn);
    d[2] = much[1] * slip(turn) * sin(turn);
}

/* a x - b of a row with multiplier y = +-1 for one triple, and the size of its terms. */
static double excess(const double f[3], const double d[3], double *size)
{
    double sum = -(double)w->right;
    *size = fabs(sum);
    for (int k = 0; k < 3; k++) {
        sum += (double)w->f[0][k] * f[k] + (double)w->d[0][k] * d[k];
        *size += fabs((double)w->f[0][k] * f[k]) + fabs((double)w->d[0][k] * d[k]);
    }
    return sum;
}

/* Add one row;     returns 0 where this state has none, or not with this sign */
static int add(int32_t state, int32_t row, int sign)
{
    for (int k = 0; k < 3; k++) w->f[0][k] = w->d[0][k] = 0;
    w->fsize[0] = w->dsize[0] = w->right = w->size = w->slack = 0;
    w->state[0] = state;
    return sp__refute_add(w, 6 * pb.blocks + 1 + row, (sp_real)sign);
}

/* States that have the same rows: unknown, open, engaged, in a sector. */
enum { UNKNOWN, OPEN, ENGAGED, SECTOR, CLASSES };

static int class_of(int32_t state) { return state > 3 ? SECTOR : (int)state; }

typedef struct seen { int there, tight; } seen;         /* a row with one sign: is there one, did some triple meet it? */

/* All rows in all states to an eighth of a quarter, for one cone.     returns how many there are */
static int holds(seen of[CLASSES][SP__PROOF_ROWS][2])
{
    int rows = 0;
    for (int32_t state = 0; state < 64; state++)
        for (int32_t row = 0; row < SP__PROOF_ROWS && state != 3; row++)
            for (int sign = 0; sign < 2; sign++) {
                if (!add(state, row, sign ? -1 : 1)) continue;
                seen *now = &of[class_of(state)][row][sign];
                now->there = 1;
                rows++;
                for (int k = 0; k < 96; k++) {
                    double f[3], d[3], size;
                    triple(state, k, f, d);
                    const double over = excess(f, d, &size), u = TOL(1e-12, 1e-5) * (size + 1);
                    if (over > u) {
                        CHECK_INT(state, -1);
                        CHECK_INT(row, -1);
                        CHECK_WITHIN(over, 0, u);
                        return rows;
                    }
                    if (size > 0.01 && over > -TOL(1e-4, 2e-2) * size) now->tight = 1;
                }
            }
    return rows;
}

/* Those of f = 0 and of fn >= 0 say no more than that; between eighths of a circle and many faces nothing need meet. */
static void every_row(int32_t faces, int32_t inscribed, int32_t box)
{
    const sp_arena mark = test_arena;
    seen of[CLASSES][SP__PROOF_ROWS][2] = { { { { 0, 0 } } } };
    if (!begin(faces, inscribed, box)) return;
    CHECK(holds(of) > 500);
    for (int c = 0; c < CLASSES; c++)
        for (int32_t row = 0; row < (faces > 8 ? 10 : 21); row++)
            for (int sign = 0; sign < 2; sign++)
                if (of[c][row][sign].there && !(c == OPEN && row > 4)) CHECK(of[c][row][sign].tight);
    CHECK_INT(of[SECTOR][5][0].there, !box);
    CHECK_INT(of[SECTOR][11][0].there, !faces || faces > 8);
    test_arena = mark;
}

/* Friction opposite to the middle of a sector, as much as there may be, lies on the face that row 11 names. */
TEST(row_11_is_the_face_that_friction_meets)
{
    static const int32_t faces[] = { 9, 12, 17, 33, 64 };
    for (int q = 0; q < 5; q++) {
        const sp_arena mark = test_arena;
        NEED(begin(faces[q], q % 2, 0));
        for (int32_t state = 4; state < 64; state++) {
            double from, to, size;
            sector(state, &from, &to);
            const double back = (from + to) / 2 + PI, none[3] = { 0, 0, 0 };
            const double f[3] = { 1, reach(back) * cos(back), reach(back) * sin(back) };
            CHECK_INT(add(state, 11, 1), 1);
            CHECK_WITHIN(excess(f, none, &size), 0, TOL(1e-12, 1e-5));
        }
        test_arena = mark;
    }
}

TEST(every_row_holds_for_every_triple_of_its_state_true_cone) { every_row(0, 1, 0); }
TEST(every_row_holds_where_slip_is_bound_by_components) { every_row(0, 1, 1); }
TEST(every_row_holds_for_pyramids_of_3_to_8_faces)
{
    for (int32_t faces = 3; faces <= 8; faces += SOME_OF(1, faces == 4 ? 4 : 1)) every_row(faces, faces % 2, faces / 4 % 2);
}
TEST(every_row_holds_for_pyramids_of_9_to_64_faces)
{
    static const int32_t faces[] = { 9, 10, 12, 16, 17, 31, 32, 48, 63, 64 };
    for (int k = 0; k < 10; k += SOME_OF(1, k ? 6 : 3)) every_row(faces[k], k % 2, k / 2 % 2);
}

/* What no state has is refused: rows beyond the last, wrong signs, no number. */
TEST(a_row_that_is_none_is_refused)
{
    NEED(begin(0, 1, 0));
    const int32_t n = 6 * pb.blocks;
    CHECK_INT(sp__refute_add(w, -1, 1), 0);
    CHECK_INT(sp__refute_add(w, n + SP__PROOF_ROWS * 4 + 1, 1), 0);
    CHECK_INT(sp__refute_add(w, INT32_MAX, 1), 0);
    CHECK_INT(sp__refute_add(w, 0, R(NAN)), 0);
    CHECK_INT(sp__refute_add(w, 0, R(INFINITY)), 0);
    CHECK_INT(sp__refute_add(w, n, -1), 0);             /* the row of work has one side */
    for (int32_t state = 0; state < 4; state++)         /* rows of a sector where there is none */
        for (int32_t row = 5; row < 13; row++) {
            CHECK_INT(add(state, row, 1), 0);
            CHECK_INT(add(state, row, -1), 0);
        }
    for (int32_t row = 13; row < 22; row++) CHECK_INT(add(0, row, -1), row == 21);
    for (int32_t row = 22; row < 24; row++)             /* f = 0 only where a vertex is open */
        for (int32_t state = 0; state < 8; state++) CHECK_INT(add(state, row, 1), state == 1);
}

/* Whether a state has a row is told by the sign of its multiplier, not by its size. */
TEST(a_row_is_taken_by_the_sign_of_its_multiplier)
{
    static const int32_t faces[] = { 0, 5, 12 };
    static const double size[] = { 1e-9, 0.5, 3, 1e9 };
    for (int q = 0; q < 3; q++) {
        const sp_arena mark = test_arena;
        NEED(begin(faces[q], 1, 0));
        const int32_t n = 6 * pb.blocks;
        for (int k = 0; k < 4; k++) {
            for (int32_t state = 0; state < 16; state++)
                for (int32_t row = 0; row < SP__PROOF_ROWS && state != 3; row++)
                    for (int sign = -1; sign < 2; sign += 2) {
                        const int there = add(state, row, sign);
                        CHECK_INT(sp__refute_add(w, n + 1 + row, R(sign * size[k])), there);
                    }
            CHECK_INT(sp__refute_add(w, n, R(size[k])), 1);
            CHECK_INT(sp__refute_add(w, n, R(-size[k])), 0);
        }
        test_arena = mark;
    }
}

/* Whatever the row is, in whatever state. */
TEST(a_multiplier_of_0_adds_nothing)
{
    NEED(begin(12, 1, 1));
    const int32_t n = 6 * pb.blocks;
    add(0, 0, 1);
    const double f = (double)w->f[0][0], d = (double)w->d[0][0], right = (double)w->right, size = (double)w->size;
    for (int32_t state = 0; state < 16; state++)
        for (int32_t row = 0; row <= n + 4 * SP__PROOF_ROWS; row++) {
            w->state[0] = state;
            for (int32_t v = 1; v < 4; v++) w->state[v] = 0;
            if (!CHECK_INT(sp__refute_add(w, row, 0), 1)) TEST_PRINT("    state %d, row %d\n", (int)state, (int)row);
        }
    CHECK_INT(sp__refute_add(w, n + 4 * SP__PROOF_ROWS + 1, 0), 0);
    CHECK_NEAR(w->f[0][0], f, 0);
    CHECK_NEAR(w->d[0][0], d, 0);
    CHECK_NEAR(w->right, right, 0);
    CHECK_NEAR(w->size, size, 0);
}

/* The last row there is, ft2 of the last vertex: a vertex has 24. */
TEST(the_last_row_is_one)
{
    NEED(begin(0, 1, 0));
    const int32_t last = 6 * pb.blocks + 4 * 24;
    for (int k = 0; k < 3; k++) w->f[3][k] = 0;
    w->state[3] = 1;
    CHECK_INT(sp__refute_add(w, last, 1), 1);
    CHECK_NEAR(w->f[3][2], 1, 0);
    CHECK_INT(sp__refute_add(w, last + 1, 1), 0);
}

/* Directions by half angles against those of trigonometry. */
TEST(directions_of_sectors_are_those_of_the_circle)
{
    for (int32_t h = 0; h < 12; h++)
        for (int32_t turn = 0; turn <= 4 << h; turn++) {
            sp_real d[2];
            sp__refute_direction(turn, h, d);
            CHECK_WITHIN(d[0], cos(PI / 2 * turn / (1 << h)), TOL(1e-14, 1e-6));
            CHECK_WITHIN(d[1], sin(PI / 2 * turn / (1 << h)), TOL(1e-14, 1e-6));
        }
}

TEST_LIST(refute)
    RUN_FULL(every_row_holds_for_every_triple_of_its_state_true_cone)
    RUN_FULL(every_row_holds_where_slip_is_bound_by_components)
    RUN_FULL(every_row_holds_for_pyramids_of_3_to_8_faces)
    RUN_FULL(every_row_holds_for_pyramids_of_9_to_64_faces)
    RUN_FULL(row_11_is_the_face_that_friction_meets)
    RUN_FULL(a_row_that_is_none_is_refused)
    RUN_FULL(a_row_is_taken_by_the_sign_of_its_multiplier)
    RUN_FULL(a_multiplier_of_0_adds_nothing)
    RUN_FULL(the_last_row_is_one)
    RUN_FULL(directions_of_sectors_are_those_of_the_circle)
TEST_END
