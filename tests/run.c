/* run: calls the tests and counts.
 *
 *     run [FILTER] [SEED]        tests whose "file/name" contains FILTER; SEED of the random numbers
 *     run -l [FILTER]            names only
 *     LONG=1 run ...             all samples of every claim, not a few [SOME_OF in test.h]
 *     run -m [FILTER] [SEED]     names, bytes of memory touched, and milliseconds; for a board thousands of steps [board.mk]
 *
 * TEST_SUITES is the list of files, X(scene) X(clip) ... for test_scene.c test_clip.c ...; the Makefile gives what is there,
 * a board may choose fewer. TEST_LEAVE_OUT is a file of "stem/name", one a line: tests too large for a board; they are named,
 * each with its reason, by whoever left them out. With TEST_FIRST the first test that fails is the last one that is run. The last
 * line is `N passed, N failed`; the exit status is 1 if a test failed, or none was run.
 */
#include "test.h"

#include <string.h>
#ifdef __has_feature
#if __has_feature(memory_sanitizer)
#include <sanitizer/msan_interface.h>
#define TEST_FORGET(at, n) __msan_allocated_memory(at, n)
#endif
#endif

#ifndef TEST_FORGET
#define TEST_FORGET(at, n) ((void)0)
#endif
#ifndef TEST_FIRST
#define TEST_FIRST 0
#endif
#ifndef TEST_SUITES
#error "TEST_SUITES is missing: X(scene) X(clip) ..."
#endif

#define X(stem) extern const test_entry test_##stem[];
TEST_SUITES
#undef X

static const struct { const char *stem; const test_entry *entry; } suite[] = {
#define X(stem) { #stem, test_##stem },
    TEST_SUITES
#undef X
};

static const char *const left_out[] = {
#ifdef TEST_LEAVE_OUT
#include TEST_LEAVE_OUT
#endif
    NULL
};

sp_arena test_arena;
int test_long;

#ifndef SP_QP_ONLY
size_t test_bytes(const sp_scene *scene, sp_memory_for what, const sp_settings *settings)
{
    const sp_arena none = { NULL, 0, 0, 0 };
    size_t bytes = 0;
    return sp_memory(scene, what, settings, none, &bytes) == SP_OK ? bytes : 0;
}
#endif

static uint64_t memory[TEST_ARENA_BYTES / 8];
static uint64_t seed = 20260101u, state;
static int failures;                                    /* of the running test */
static const char *running_stem, *running_name;

void test_renew(void)
{
    test_arena.used = test_arena.peak = 0;
    TEST_FORGET(memory, sizeof memory);
}

uint32_t test_random(void)
{
    state ^= state >> 12;
    state ^= state << 25;
    state ^= state >> 27;
    return (uint32_t)((state * 2685821657736338717u) >> 32);
}

int32_t test_random_int(int32_t low, int32_t high)
{
    return low + (int32_t)(((uint64_t)test_random() * (uint64_t)(high - low + 1)) >> 32);
}

sp_real test_random_real(double low, double high)
{
    return (sp_real)(low + (high - low) * ((double)test_random() / 4294967296.0));
}

double test_draw(uint32_t *draws, double low, double high)
{
    *draws ^= *draws << 13;
    *draws ^= *draws >> 17;
    *draws ^= *draws << 5;
    return low + (high - low) * (*draws / 4294967296.0);
}

/* A failed check: the first of a test also names the test and the seed. */
static void where(const char *file, int line, const char *text)
{
    if (failures++ == 0)
        TEST_PRINT("FAILED %s/%s (seed %lu)\n", running_stem, running_name, (unsigned long)seed);
    TEST_PRINT("  %s:%d: %s", file, line, text);
}

int test_check(int held, const char *file, int line, const char *text)
{
    if (!held) {
        where(file, line, text);
        TEST_PRINT("\n");
    }
    return held;
}

int test_check_int(long long got, long long want, const char *file, int line, const char *text)
{
    if (got == want) return 1;
    where(file, line, text);
    TEST_PRINT(" = %ld, want %ld\n", (long)got, (long)want);
    return 0;
}

/* printf of a small C library has no floating point: TEST_NO_FLOAT prints millionths of the ratio instead. */
int test_check_near(double got, double want, double tol, int absolute, const char *file, int line, const char *text)
{
    const double size = want < 0 ? -want : want, error = got < want ? want - got : got - want;
    const double allowed = absolute || !(size > 0) ? tol : tol * size;
    if (error <= allowed) return 1;                     /* a NaN fails */
    where(file, line, text);
#ifdef TEST_NO_FLOAT
    TEST_PRINT(": got/want %ld millionths\n", (long)(1e6 * got / want));
#else
    TEST_PRINT(" = %.17g, want %.17g (ratio %.9g, off by %.3g, allowed %.3g)\n", got, want, got / want, error, allowed);
#endif
    return 0;
}

static int equal(const char *a, const char *b)
{
    while (*a && *a == *b) a++, b++;
    return *a == *b;
}

int test_check_text(const char *got, const char *want, const char *file, int line, const char *text)
{
    if (got && equal(got, want)) return 1;
    where(file, line, text);
    TEST_PRINT(" = \"%s\", want \"%s\"\n", got ? got : "(null)", want);
    return 0;
}

/* Does "stem/name" contain `part`? */
static int contains(const char *stem, const char *name, const char *part)
{
    char full[160];
    size_t n = 0;
    for (const char *s = stem; *s && n < 78; s++) full[n++] = *s;
    full[n++] = '/';
    for (const char *s = name; *s && n < 159; s++) full[n++] = *s;
    full[n] = 0;
    for (size_t i = 0; i <= n; i++) {
        size_t k = 0;
        while (part[k] && full[i + k] == part[k]) k++;
        if (!part[k]) return 1;
    }
    return 0;
}

static int leave_out(const char *stem, const char *name)
{
    for (const char *const *l = left_out; *l; l++)
        if (contains(stem, name, *l)) return 1;
    return 0;
}

/* Bytes of memory up to the last one touched since it was painted; painted again. */
static size_t touched(void)
{
    enum { PAINT = 0xa5 };
    size_t n = sizeof memory;
    const uint64_t paint = 0xa5a5a5a5a5a5a5a5u;
    while (n >= 8 && memory[n / 8 - 1] == paint) n -= 8;
    memset(memory, PAINT, n);
    return n;
}

/* One test from a clean start: whether it passed. */
static int run(const char *stem, const test_entry *e)
{
    running_stem = stem;
    running_name = e->name;
    failures = 0;
    state = seed * 2862933555777941757u + 3037000493u;
    sp_arena_init(&test_arena, memory, sizeof memory);
    test_renew();
    if (!TEST_TOO_MUCH()) e->run();
    return failures == 0;
}

int main(int argc, char **argv)
{
    const int list = argc > 1 && equal(argv[1], "-l"), measure = argc > 1 && equal(argv[1], "-m");
    const int at = list || measure ? 2 : 1;
    const char *filter = argc > at ? argv[at] : "";
    int passed = 0, failed = 0;
    TEST_START();
    test_long = TEST_LONG();
    if (measure) touched();
    if (argc > at + 1) {
        seed = 0;
        for (const char *s = argv[at + 1]; *s >= '0' && *s <= '9'; s++) seed = 10 * seed + (uint64_t)(*s - '0');
    }
    for (size_t i = 0; i < sizeof suite / sizeof suite[0]; i++)
        for (const test_entry *e = suite[i].entry; e->run && !(TEST_FIRST && failed); e++) {
            if (!contains(suite[i].stem, e->name, filter)) continue;
            if (leave_out(suite[i].stem, e->name)) continue;
            if (list) TEST_PRINT("%s/%s\n", suite[i].stem, e->name);
            else if (measure) {
                const uint64_t before = TEST_WORK();
                const int held = run(suite[i].stem, e);
                const uint64_t work = TEST_WORK() - before;
                if (held) passed++;
                else failed++;
                TEST_PRINT("%s/%s %lu %lu\n", suite[i].stem, e->name, (unsigned long)touched(), (unsigned long)(work / 1000));
            }
            else if (run(suite[i].stem, e)) passed++;
            else failed++;
        }
    if (!list) TEST_PRINT("%d passed, %d failed\n", passed, failed);
    return !list && (failed || !passed);
}
