/* battery: the hard scenes and the corpus, or the scenes of files, in another arithmetic, one line each:
 *
 *     name | verdict | wrong, open, refused, capped (hard.h) or as it is | omega | largest force | ms | proved | final | far | truth
 *
 *     proved    least imbalance there is, of what falls;   far, truth: of the hard scenes
 *
 * battery [up|down|zero] [traps] [flush] [light] [short] [fine] [tol=X] [FILE.obj...]
 *     rounding mode; SIGFPE on invalid, division by zero, overflow; denormals are zero; without the three heaviest; without
 *     the corpus; files: these instead; fine: what stands and does not balance to 1e-12 is OPEN; asked at tol X
 *
 * One file with the library, beside those that read scenes, so that a compiler flag or a header put before it changes all
 * arithmetic: SP_REAL_QUAD, a class in place of double (random.hpp), -fsanitize=numerical. instruments.sh has the lines. Exit
 * status 1: a wrong verdict or one that is missing. Truth of the hard scenes is their row's; that of the others is what plain double says, told by instruments.sh.
 */
#define _GNU_SOURCE
#ifndef SP_REAL_QUAD
#include <math.h>
#endif
#include <fenv.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#if defined __x86_64__ && !defined __cplusplus
#include <xmmintrin.h>
#define BATTERY_FLUSH() _mm_setcsr(_mm_getcsr() | 0x8040)       /* FTZ and DAZ */
#else
#define BATTERY_FLUSH() ((void)0)
#endif

#ifdef BATTERY_BAD
/* A square root that loses eleven digits: what an instrument must see. */
static double battery_sqrt(double x)
{
    const double y = sqrt(x), big = 1e11 * y, sum = y + big;
    return sum - big;
}
#define SP_SQRT(x) battery_sqrt(x)
#endif

#include "../../stonepack.c"
#include "../scenes/gen.c"
#define main corpus_main
#include "../corpus/corpus.c"
#undef main
#include "../scenes/hard.h"
#include "../../port/host/scene.h"

#ifdef BATTERY_SHADOW
void __nsan_check_double(double x);                             /* of clang's runtime: says where x and its shadow differ */

/* Forces that stand, as they come out: those a thousandth of the largest and more, because the others may be 0 by nature, as
 * the residuals inside are: of these the rounding is all there is. */
static void battery_shadow(const sp_result *r)
{
    for (int32_t k = 0; r->verdict == SP_STABLE && k < 3 * r->points; k++)
        if (r->f[k] > 1e-3 * r->max_compression || r->f[k] < -1e-3 * r->max_compression) __nsan_check_double(r->f[k]);
}
#else
#define battery_shadow(r) ((void)(r))
#endif

static uint64_t room[(64u << 20) / 8];
static int bad, flushed, light, without_corpus, fine;
static double tol;                                              /* asked for; 0: what the scenes are asked at */
static clock_t started;

static void say(const char *name, sp_verdict verdict, const char *is, const sp_result *r, const hard_case *c)
{
    printf("%-38s| %-9s | %-5s | %7.1e | %.17g | %.3g | %.1e | %d | %g | %s\n", name, sp_verdict_text(verdict), is, (double)r->omega,
           (double)r->max_compression, 1e3 * (double)(clock() - started) / CLOCKS_PER_SEC, (double)r->least_imbalance,
           (int)r->final, c ? c->far : 0, c && !(c->flags & HARD_LIMIT) ? sp_verdict_text(c->truth) : "");
    fflush(stdout);
}

/* One hard scene against its truth. */
static void hard(const hard_case *c)
{
    sp_arena arena;
    sp_scene s;
    sp_result r;
    unsigned open = HARD_LIMIT | (flushed ? HARD_DENORMAL : 0u);
#ifdef SP_REAL_FLOAT
    open |= HARD_OPEN_FLOAT;
    if (c->flags & HARD_BAND_FLOAT && !(tol > 0)) return;
#endif
    if (light && c->flags & HARD_HEAVY) return;
    memset(&r, 0, sizeof r);
    sp_arena_init(&arena, room, sizeof room);
    sp_settings set = hard_settings();
    if (tol > 0) set.tol = (sp_real)tol;
    sp_status status = c->build(c, &arena, &s);
#ifdef SP_REAL_FLOAT
    if (c->flags & HARD_NO_FLOAT) {
        bad |= !status;
        say(c->name, SP_UNDECIDED, status ? "refused" : "WRONG", &r, c);
        return;
    }
#endif
    started = clock();
    if (!status) status = sp_check(&s, &set, &arena, &r);
    const sp_verdict v = status ? SP_UNDECIDED : r.verdict;
    battery_shadow(&r);
    const int wrong = v && !hard_right(c, &r) && !(c->flags & HARD_LIMIT), missing = !v && !(c->flags & open);
    bad |= wrong || missing;
    const int capped = v != c->truth && !(c->flags & HARD_LIMIT);
    say(c->name, v, wrong ? "WRONG" : missing ? "OPEN" : !v ? "open" : capped ? "capped" : "", &r, c);
}

static void corpus_one(const char *name, int32_t k, const sp_scene *s, int32_t faces, sp_arena *arena, sp_status status)
{
    sp_settings set = hard_settings();
    sp_result r;
    char numbered[64];
    memset(&r, 0, sizeof r);
    set.faces = faces;
    started = clock();
    if (!status) status = sp_check(s, &set, arena, &r);
    bad |= status != SP_OK;
    battery_shadow(&r);
    snprintf(numbered, sizeof numbered, "%s %ld", name, (long)k);
    say(numbered, r.verdict, status ? "WRONG" : "", &r, NULL);
}

static void corpus_all(void)
{
    sp_arena arena;
    sp_scene s;
    int32_t n = 0;
    for (size_t k = 0; k < sizeof compiled / sizeof compiled[0]; k++) {
        sp_arena_init(&arena, room, sizeof room);
        const sp_status status = build(&compiled[k], &arena, &s);
        corpus_one(compiled[k].name, n++, &s, 0, &arena, status);
    }
    for (size_t k = 0; k < sizeof made / sizeof made[0]; k++) {
        gen_scene g;
        sp_arena_init(&arena, room, sizeof room);
        gen_open(&g, made[k].name);
        for (int c = 0; c < 3 && made[k].set[c].name; c++) gen_set(&g, made[k].set[c].name, made[k].set[c].value);
        const sp_status status = gen_build(&g, &arena, &s);
        corpus_one(made[k].name, n++, &s, made[k].faces, &arena, status);
    }
}

/* The scene of a file, by the file's name. */
static void file(const char *path)
{
    sp_arena arena;
    sp_result r;
    sp_settings set = sp_settings_default();
    host_scene s;
    text_error error;
    char name[64];
    const char *last = strrchr(path, '/');
    memset(&r, 0, sizeof r);
    sp_arena_init(&arena, room, sizeof room);
    snprintf(name, sizeof name, "%s", last ? last + 1 : path);
    int status = scene_read(path, -1, SCENE_GIVEN, &s, &error);
    if (tol > 0) set.tol = (sp_real)tol;
    started = clock();
    if (!status) status = sp_check(&s.scene, &set, &arena, &r);
    const int coarse = fine && r.verdict == SP_STABLE && r.omega > (sp_real)1e-12;
    bad |= status || coarse;
    battery_shadow(&r);
    say(name, r.verdict, status ? "WRONG" : coarse ? "OPEN" : "", &r, NULL);
    scene_free(&s);
}

int main(int argc, char **argv)
{
    int files = argc;
    for (int k = 1; k < files; k++) {
        if (strcmp(argv[k], "up") == 0) fesetround(FE_UPWARD);
        else if (strcmp(argv[k], "down") == 0) fesetround(FE_DOWNWARD);
        else if (strcmp(argv[k], "zero") == 0) fesetround(FE_TOWARDZERO);
#ifdef __GLIBC__
        else if (strcmp(argv[k], "traps") == 0) feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
        else if (strcmp(argv[k], "flush") == 0) { flushed = 1; BATTERY_FLUSH(); }
        else if (strcmp(argv[k], "light") == 0) light = 1;
        else if (strcmp(argv[k], "short") == 0) without_corpus = 1;
        else if (strcmp(argv[k], "fine") == 0) fine = 1;
        else if (strncmp(argv[k], "tol=", 4) == 0) tol = atof(argv[k] + 4);
        else files = k;
    }
    for (int k = files; k < argc; k++) file(argv[k]);
    for (int k = 0; files == argc && k < HARD_CASES; k++) hard(&hard_cases[k]);
    if (files == argc && !without_corpus) corpus_all();
    return bad;
}
