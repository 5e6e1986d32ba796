/* Build orders of which every step is known without this library: by a closed form, and by linear programmes. So every build that
 * answers, SP_SMALL with its own engine as well, says the same step by step. */
#include "../test.h"
#include "../scenes/gen.h"

#include <math.h>

/* A character of `moves` is a free block by its number in the scene, 0 to 9, then from a on: it comes if it is not there, else it
 * goes. `truth` says after each move whether what is there stands, s, or falls, f; tests/oracle/sequence.py --orders reads both from
 * here and asks linear programmes. */
static const struct { const char *name, *param; double value; const char *moves, *truth; } known[] = {
    { "arch", "n", 7, "01234563021456", "sfffffsfffffss" },
    { "arch", "n", 9, "876543210", "sfffffffs" },
    { "arch", "t", 0.09, "0j1i2h3g4f5e6d7c8b9a", "ssssssffffffffffffff" },
    { "arch", "t", 0.14, "0j1i2h3g4f5e6d7c8b9a55aa", "ssssssfffffffffffffsfsfs" },
    { "tower", "lean", 0.13, "01234567898765", "ssssssffffffff" },
    { "overhang", "factor", 0.95, "0123443210", "ssssssssss" },
    { "overhang", "factor", 1.05, "0123443210", "ssssfsssss" },
    { "cantilever", "reach", 1.1, "0101100", "fsfsfsf" },
    { "cantilever", "reach", 1.4, "01100", "fffsf" },
    { "keystone", "mu", 0.45, "00", "ss" },
    { "keystone", "mu", 0.3, "00", "fs" },
    { "h-model", NULL, 0, "00", "ss" },
    { "diamond", "rows", 3, "012345678876543210", "sssfsffsssffsfssss" },
    { "diamond", "rows", 3, "012345876", "sssfsffss" },
    { "inverted-triangle", "rows", 3, "012345543210", "sssfsfsfssss" },
    { "inverted-triangle", "rows", 3, "021543", "sssfsf" },
    { "flat-arch", "n", 5, "01234140321", "ffffsffffsf" },
    { "two-cubes", "offset", 0.6, "00", "fs" },
    { "wall", "rows", 3, "0123456789abcdefghi00cc", "sssssssssssssssssssfsss" },
    { "rubble", "bricks", 2, "0123456789abcde0246", "sssssssssssssssfssf" },
    { "rubble", "bricks", 2, "021354687a9bcde", "sssssssssssssss" },
    { "vault", "around", 3, "0123456789abcdef55", "fffffffffffffffsss" },
};

/* The block of a character: its number among the free ones. */
static int32_t block_of(const sp_scene *s, char move)
{
    int32_t n = move <= '9' ? move - '0' : move - 'a' + 10;
    for (int32_t b = 0; b < s->count.blocks; b++)
        if (s->block[b].fixed != SP_FIXED && n-- == 0) return b;
    return SP_NONE;
}

TEST(every_step_is_as_linear_programmes_say)
{
    const size_t start = test_arena.used;
    int32_t seen[2] = { 0, 0 };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        uint64_t there = 0;
        sp_scene s;
        sp_sequence *q = NULL;
        test_arena.used = start;
        NEED(gen_make(known[k].name, known[k].param, known[k].value, &test_arena, &s) == SP_OK);
        NEED(sp_sequence_open(&s, NULL, &test_arena, &q) == SP_OK);
        for (int i = 0; known[k].moves[i]; i++) {
            const int32_t b = block_of(&s, known[k].moves[i]);
            sp_step step;
            NEED(b >= 0 && b < 64);
            there ^= (uint64_t)1 << b;
            NEED(sp_sequence_set(q, b, there >> b & 1 ? SP_PRESENT : SP_ABSENT, &step) == SP_OK);
            const int stands = known[k].truth[i] == 's';
            if (!CHECK_INT(step.verdict, stands ? SP_STABLE : SP_UNSTABLE))
                TEST_PRINT("    %s, %s: step %d\n", known[k].name, known[k].moves, i);
            seen[stands]++;
        }
    }
    CHECK(seen[0] > 60 && seen[1] > 60);
}

/* -------------------------------------------------------------------------------------------------- piles: closed form */

enum { PILES = 2, HIGH = 6 };

/* Cubes of 1 m side, each at (x, y) of its pile; 0 is the ground under it. */
typedef struct pile { double x[HIGH + 1], y[HIGH + 1], mass[HIGH + 1]; sp_presence who[HIGH + 1]; } pile;

static int32_t stone_of(int p, int k) { return k ? 1 + p * HIGH + k - 1 : 0; }

static void make_piles(pile *all, sp_scene *s)
{
    const sp_capacity room = { 1 + PILES * HIGH, 0, 0, 0, PILES * HIGH, 4 * PILES * HIGH, 0 };
    const sp_strength strength = sp_strength_friction(R(0.5));
    const sp_real ground[3] = { 0, 0, R(-0.5) };
    CHECK_INT(sp_scene_create(s, &room, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(s, 0, ground, SP_FIXED, NULL), SP_OK);
    for (int p = 0; p < PILES; p++)
        for (int k = 0; k <= HIGH; k++) {
            pile *t = &all[p];
            t->who[k] = k ? SP_ABSENT : SP_HELD;
            t->mass[k] = (double)test_random_real(500, 2000);
            t->x[k] = k ? t->x[k - 1] + (double)test_random_real(-0.35, 0.35) : 5 * p;
            t->y[k] = k ? t->y[k - 1] + (double)test_random_real(-0.35, 0.35) : 0;
            const sp_real at[3] = { R(t->x[k]), R(t->y[k]), R(k - 0.5) };
            if (k) CHECK_INT(sp_scene_body(s, R(t->mass[k]), at, 0, NULL), SP_OK);
        }
    for (int p = 0; p < PILES; p++)
        for (int k = 1; k <= HIGH; k++) {
            const pile *t = &all[p];
            const double left = fmax(t->x[k], t->x[k - 1]) - 0.5, right = fmin(t->x[k], t->x[k - 1]) + 0.5;
            const double front = fmax(t->y[k], t->y[k - 1]) - 0.5, back = fmin(t->y[k], t->y[k - 1]) + 0.5;
            const sp_real z = R(k - 1), foot[12] = { R(left), R(front), z, R(right), R(front), z, R(right), R(back), z, R(left), R(back), z };
            CHECK_INT(sp_scene_joint(s, stone_of(p, k - 1), stone_of(p, k), 4, foot, &strength, NULL), SP_OK);
        }
}

/* How far inside the joint under stone k the centroid of what rests on it is; negative: outside, it tips. Joints are level, so
 * friction has no part in it. [m] */
static double inside(const pile *t, int k)
{
    double m = 0, x = 0, y = 0;
    for (int i = k; i <= HIGH && t->who[i] == SP_PRESENT; i++) {
        m += t->mass[i];
        x += t->mass[i] * t->x[i];
        y += t->mass[i] * t->y[i];
    }
    const double dx = fmin(0.5 - fabs(x / m - t->x[k]), 0.5 - fabs(x / m - t->x[k - 1]));
    const double dy = fmin(0.5 - fabs(y / m - t->y[k]), 0.5 - fabs(y / m - t->y[k - 1]));
    return fmin(dx, dy);
}

/* The least of all joints; -1: a stone rests on nothing. */
static double least_inside(const pile *t)
{
    double least = 1;
    for (int k = 1; k <= HIGH; k++)
        if (t->who[k] == SP_PRESENT) least = fmin(least, t->who[k - 1] == SP_ABSENT ? -1 : inside(t, k));
    return least;
}

/* A random move: up or down at the top, the lowest stone taken in the hand or let go, one in the middle away or back.
 * Returns the stone. */
static int move(pile *t)
{
    int top = 0;
    for (int k = 1; k <= HIGH; k++) if (t->who[k] != SP_ABSENT) top = k;
    const int what = test_random_int(0, 9), k = what > 7 && top > 2 ? test_random_int(2, top - 1) : what > 6 && top ? 1
                                            : what > 4 && top ? top : top < HIGH ? top + 1 : top;
    const sp_presence instead = k == 1 && what == 7 ? SP_HELD : SP_ABSENT;
    t->who[k] = t->who[k] == SP_PRESENT ? instead : SP_PRESENT;
    return k;
}

TEST(piles_stand_while_over_each_joint_is_the_centroid_of_what_rests_on_it)
{
    const size_t start = test_arena.used;
    int32_t seen[2] = { 0, 0 }, near = 0;
    for (int scene = 0; scene < SOME_OF(60, 12); scene++) {
        pile all[PILES];
        sp_scene s;
        sp_sequence *q = NULL;
        test_arena.used = start;
        make_piles(all, &s);
        NEED(sp_sequence_open(&s, NULL, &test_arena, &q) == SP_OK);
        for (int i = 0; i < 40; i++) {
            const int p = i % PILES, k = move(&all[p]);
            sp_step step;
            NEED(sp_sequence_set(q, stone_of(p, k), all[p].who[k], &step) == SP_OK);
            const double least = fmin(least_inside(&all[0]), least_inside(&all[1]));
            near += fabs(least) < 0.01;
            if (fabs(least) < 0.01) continue;           /* [m] */
            if (!CHECK_INT(step.verdict, least > 0 ? SP_STABLE : SP_UNSTABLE))
                TEST_PRINT("    scene %d, step %d: %g m inside\n", scene, i, least);
            seen[least > 0]++;
        }
    }
    CHECK(seen[0] > SOME_OF(500, 100) && seen[1] > SOME_OF(500, 100) && near < SOME_OF(240, 48));
}

TEST_LIST(orders)
    RUN(every_step_is_as_linear_programmes_say)
    RUN(piles_stand_while_over_each_joint_is_the_centroid_of_what_rests_on_it)
TEST_END
