/* near: how near to a limit both of its sides are told; tests/bench/near.c has the table. */
#include "../test.h"
#include "../scenes/near.h"

#include <string.h>

#define BAND TOL(1e-8, 1e-3)                            /* declared: relative distance in load multiplier */
#define TIGHTEST TOL(1e-12, 1e-6)                       /* tol that tells most */
#if defined SP_NO_IPM || defined SP_SMALL
#define MAY_BE_OPEN 1
#else
#define MAY_BE_OPEN 0
#endif

static sp_result check_at(const near_case *c, double share, double tol)
{
    sp_scene s;
    sp_settings set = sp_settings_default();
    sp_result r;
    memset(&r, 0, sizeof r);
    test_arena.used = 0;
    set.tol = R(tol);
    set.localise = 0;
    if (CHECK_INT(near_build(c, share, &test_arena, &s), SP_OK)) CHECK_INT(sp_check(&s, &set, &test_arena, &r), SP_OK);
    return r;
}

static void both_sides(const near_case *c, double distance, double tol)
{
    const sp_verdict below = check_at(c, -distance, tol).verdict, beyond = check_at(c, distance, tol).verdict;
    const int held = CHECK(below == SP_STABLE || (MAY_BE_OPEN && !below)) &
                     CHECK(beyond == SP_UNSTABLE || (MAY_BE_OPEN && !beyond));
    if (!held) TEST_PRINT("    %s: %g from its limit at tol %g: %d, %d\n", c->name, distance, tol, (int)below, (int)beyond);
}

/* In double the declared band is left ten times behind. */
TEST(both_sides_of_a_limit_are_told_at_the_declared_band)
{
    for (int k = 0; k < NEAR_CASES; k++)
        for (double d = 0.1; d > TOL(0.099, 0.99) * BAND; d /= 10) both_sides(&near_cases[k], d, TIGHTEST);
}

/* Every tol tells both sides from a thousand times itself on. */
TEST(both_sides_of_a_limit_are_told_at_a_thousand_tol)
{
    static const double tols[] = { 1e-4, TOL(1e-6, 1e-5), TOL(1e-9, 1e-5), TOL(1e-12, 1e-5) };
    for (int k = 0; k < NEAR_CASES; k++)
        for (size_t t = 0; t < sizeof tols / sizeof tols[0]; t++) both_sides(&near_cases[k], 1000 * tols[t], tols[t]);
}

/* What stands is never called fallen, however near it is; what falls is called stable only where it balances within tol, some
 * hundred times which is its distance from the limit. */
TEST(nothing_is_wrong_inside_the_band)
{
    for (int k = 0; k < NEAR_CASES; k++)
        for (double d = BAND; d > TOL(1e-16, 1e-9); d /= SOME_OF(10, 100)) {         /* below that a float is the same */
            const double tol = TIGHTEST;
            const sp_result below = check_at(&near_cases[k], -d, tol), beyond = check_at(&near_cases[k], d, tol);
            const int held = CHECK(below.verdict != SP_UNSTABLE) &
                             CHECK(beyond.verdict != SP_STABLE || (d < 200 * tol && beyond.imbalance <= R(tol)));
            if (!held) TEST_PRINT("    %s: %g from its limit\n", near_cases[k].name, d);
        }
}

TEST_LIST(near)
    RUN(both_sides_of_a_limit_are_told_at_the_declared_band)
    RUN(both_sides_of_a_limit_are_told_at_a_thousand_tol)
    RUN(nothing_is_wrong_inside_the_band)
TEST_END
