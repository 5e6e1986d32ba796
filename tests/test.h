/* test: a handful of macros for tests that also run on a bare board.
 *
 * No files, no clock, no malloc; text leaves through TEST_PRINT only. A test file looks like this:
 *
 *     #include "../test.h"
 *
 *     TEST(two_and_two_are_four) { CHECK_INT(2 + 2, 4); }
 *
 *     TEST_LIST(sums)                             the stem of the file: tests/WING/test_sums.c
 *         RUN(two_and_two_are_four)
 *     TEST_END
 *
 * Names of tests are claims. A white-box test defines SP_API as static, then includes the one part it looks into:
 *
 *     #define SP_API static
 *     #include "../test.h"
 *     #include "../../solvers/linear/chol.c"
 */
#ifndef TEST_H
#define TEST_H

#include "../stonepack.h"

#ifndef TEST_PRINT
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#define TEST_PRINT printf
#define TEST_LONG() (getenv("LONG") && *getenv("LONG") == '1')
#define TEST_WORK() ((uint64_t)clock() * 1000000u / CLOCKS_PER_SEC)     /* on a host, microseconds of its processor */
#define TEST_START() setvbuf(stdout, NULL, _IONBF, 0)  /* what was said before a crash is seen */
#else
#define TEST_START() ((void)0)
#endif
#ifndef TEST_LONG
#define TEST_LONG() 0
#endif

#ifndef TEST_ARENA_BYTES
#define TEST_ARENA_BYTES (64u << 20)                    /* [byte] static memory of the runner; a board asks for less */
#endif

typedef struct test_entry { const char *name; void (*run)(void); } test_entry;

#define TEST(name)      static void name(void)
#define TEST_LIST(stem) extern const test_entry test_##stem[]; const test_entry test_##stem[] = {
#define RUN(name)       { #name, name },
#define TEST_END        { NULL, NULL } };

/* Tests of what SP_SMALL does without: pyramids, strength of joints, budgets, islands told apart, and engines that are quicker. */
#ifdef SP_SMALL
#define RUN_FULL(name)
enum { TEST_SMALL = 1 };
#else
#define RUN_FULL(name) RUN(name)
enum { TEST_SMALL = 0 };
#endif

#ifndef TEST_WORK
#define TEST_WORK() ((uint64_t)0)                       /* steps taken so far, where they can be counted */
#endif
#ifndef TEST_TOO_MUCH
#define TEST_TOO_MUCH() 0                               /* 0, later 1 where a test is stopped for taking too many */
#endif

/* sp_memory of what follows from counts alone; 0 where it is refused. */
#ifndef SP_QP_ONLY
size_t test_bytes(const sp_scene *scene, sp_memory_for what, const sp_settings *settings);
#endif

/* All memory a test has: empty when a test starts. Pass `test_arena` by value for scratch, &test_arena to keep. */
extern sp_arena test_arena;
void test_renew(void);                                  /* it is empty again; to MSan nobody has written there yet */

/* How many samples of one claim: a few in daily work and on boards, all of them with LONG=1, as `make nightly` asks. */
extern int test_long;
#define SOME_OF(all, few) (test_long ? (all) : (few))

/* Numbers without pattern, the same on every machine; seeded anew for every test, the seed is printed on failure. */
uint32_t test_random(void);                             /* 0 .. 2^32 - 1                                  [xorshift64*] */
int32_t  test_random_int(int32_t low, int32_t high);    /* low .. high, both included */
sp_real  test_random_real(double low, double high);     /* low <= x < high */

/* low <= x < high from numbers of your own, draws not 0: known by the first of them, whatever the test's seed.  [xorshift32] */
double test_draw(uint32_t *draws, double low, double high);

/* Each returns whether it held; a failure prints where, what, and for numbers both values and their ratio. */
int test_check(int held, const char *file, int line, const char *text);
int test_check_int(long long got, long long want, const char *file, int line, const char *text);
int test_check_near(double got, double want, double tol, int absolute, const char *file, int line, const char *text);
int test_check_text(const char *got, const char *want, const char *file, int line, const char *text);

#define CHECK(cond)               test_check(!!(cond), __FILE__, __LINE__, #cond)
#define CHECK_INT(got, want)      test_check_int((long long)(got), (long long)(want), __FILE__, __LINE__, #got)
#define CHECK_TEXT(got, want)     test_check_text(got, want, __FILE__, __LINE__, #got)

/* |got - want| <= tol |want|, and <= tol where want is 0. */
#define CHECK_NEAR(got, want, reltol)  test_check_near((double)(got), (double)(want), (double)(reltol), 0, \
                                                       __FILE__, __LINE__, #got)
/* |got - want| <= tol. */
#define CHECK_WITHIN(got, want, tol)   test_check_near((double)(got), (double)(want), (double)(tol), 1, \
                                                       __FILE__, __LINE__, #got)

/* Leave the test where going on makes no sense. */
#define NEED(cond)                do { if (!CHECK(cond)) return; } while (0)

/* The nearest number of this build; keeps -Wconversion quiet in both precisions. */
#define R(x) ((sp_real)(x))

/* A tolerance that is `d` in double and `f` in float. */
#ifdef SP_REAL_FLOAT
#define TOL(d, f) (f)
#else
#define TOL(d, f) (d)
#endif

#endif /* TEST_H */
