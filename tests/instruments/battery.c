/* battery: the hard scenes and the corpus, or the scenes of files, in another arithmetic, one line each:
 *
 *     name | verdict | how | imbalance | largest force | ms | proved | final | far | truth
 *
 *     how       wrong, open, refused, capped (hard.h), short, or as it is
 *     proved    least imbalance there is, of what falls;   far, truth: of the hard scenes;   short: the last digit of a weight
 *               is more than tol of it
 *
 * battery [up|down|zero] [traps] [flush] [light] [short] [fine] [far] [only=NAME] [tol=X] [FILE.obj...]
 *     rounding mode; SIGFPE on invalid, division by zero, overflow; denormals are zero; without the three heaviest; without
 *     the corpus; files: these instead; fine: what stands and does not balance to 1e-12 is OPEN; asked at tol X
 *     far: instead, name | relative distance from its limit in load;   only: that hard scene
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
#include "../../port/host/files/scene.h"

#ifdef BATTERY_SHADOW
void __nsan_check_double(double x);                             /* of clang's runtime: says where x and its shadow differ */

/* Forces that stand, as they come out: those a thousandth of the largest and more, because the others may be 0 by nature, as
 * the residuals inside are: of these the rounding is all there is. */
static void battery_shadow(const sp_result *r)
{
    for (int32_t k = 0; r->verdict == SP_STABLE && k < 3 * r->counts.points; k++)
        if (r->f[k] > 1e-3 * r->extremes.compression || r->f[k] < -1e-3 * r->extremes.compression) __nsan_check_double(r->f[k]);
}
#else
#define battery_shadow(r) ((void)(r))
#endif

static uint64_t room[(64u << 20) / 8];
static int bad, flushed, light, without_corpus, fine, far;
static const char *only;                                        /* of the hard scenes */
static double tol;                                              /* asked for; 0: what the scenes are asked at */
static clock_t started;

static void say(const char *name, sp_verdict verdict, const char *is, const sp_result *r, const hard_case *c)
{
    printf("%-38s| %-9s | %-5s | %7.1e | %.17g | %.3g | %.1e | %d | %g | %s\n", name, sp_verdict_text(verdict), is, (double)r->imbalance,
           (double)r->extremes.compression, 1e3 * (double)(clock() - started) / CLOCKS_PER_SEC, (double)r->least_imbalance,
           (int)r->final, c ? c->far : 0, c && (c->far > 0 || !(c->flags & HARD_LIMIT)) ? sp_verdict_text(c->truth) : "");
    fflush(stdout);
}

/* The scene with a share of every weight added to it: along an axis, ways 0 to 5, or, way 6, by hands: each block is held at its
 * centroid by a force of any direction up to that (a made-up joint of one point, the force its strength). */
static sp_verdict changed(const sp_scene *s, const sp_settings *set, int way, double share, sp_arena arena)
{
    sp_scene t = *s;
    sp_result r;
    const sp_real *g = s->gravity;
    const double much = share * (double)sp__norm3(g);
    const int32_t blocks = s->count.blocks, joints = s->count.joints, points = s->count.points;
    int32_t support = 0;
    memset(&r, 0, sizeof r);
    while (support < blocks && s->block[support].fixed != SP_FIXED) support++;
    if (way < 6) t.gravity[way / 2] += (sp_real)(way % 2 ? -much : much);
    else {
        t.joint = sp__take(&arena, (size_t)(joints + blocks), sizeof *t.joint);
        t.point = sp__take(&arena, (size_t)(points + blocks), sizeof *t.point);
        if (support == blocks || sp__failed(&arena)) return SP_UNDECIDED;
        memcpy(t.joint, s->joint, (size_t)joints * sizeof *t.joint);
        memcpy(t.point, s->point, (size_t)points * sizeof *t.point);
    }
    for (int32_t k = 0; k < blocks && way == 6; k++) {
        const sp_real hold = (sp_real)much * s->block[k].mass;
        const sp_joint hand = { support, k, t.count.points, 1, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, 1, { 0, hold, hold, hold } };
        if (s->block[k].fixed || !(hold > 0)) continue;
        t.joint[t.count.joints++] = hand;
        memcpy(t.point[t.count.points++], s->block[k].centroid, sizeof *t.point);
    }
    t.capacity = t.count;
    return sp_check(&t, set, &arena, &r) ? SP_UNDECIDED : r.verdict;
}

/* Relative distance from the limit in load, from above: the first share of the weights, each twice the one before, that changes
 * the verdict, for what falls also by hands. 1: none up to a tenth does. */
static double distance(const sp_scene *s, const sp_settings *set, sp_arena arena)
{
    const sp_verdict is = changed(s, set, 0, 0, arena);
    const int ways = is == SP_UNSTABLE ? 7 : 6;
    for (double share = 1e-9; share < 0.15; share *= 2)
        for (int way = 0; way < ways; way++) {
            const sp_verdict other = changed(s, set, way, share, arena);
            if (other && other != is) return share;
        }
    return 1;
}

/* The largest of what the last digit of a weight is to it: more than a few roundings below the normal range. */
static double last_digit(const sp_scene *s)
{
    double most = 0;
    for (int32_t k = 0; k < s->count.blocks; k++) {
        const sp_real whole = s->block[k].mass;
        sp_real last = whole;
        while (last / 2 > 0 && whole + last / 2 > whole) last /= 2;
        if (whole > 0 && (double)(last / whole) > most) most = (double)(last / whole);
    }
    return most;
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
    if (only && strcmp(only, c->name)) return;
    memset(&r, 0, sizeof r);
    sp_arena_init(&arena, room, sizeof room);
    sp_settings set = hard_settings(c->flags);
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
    if (far) { printf("%s|%.3g\n", c->name, status ? 1 : distance(&s, &set, arena)); return; }
    if (!status) status = sp_check(&s, &set, &arena, &r);
    const sp_verdict v = status ? SP_UNDECIDED : r.verdict;
    battery_shadow(&r);
    const int is_short = !v && last_digit(&s) > (double)set.tol;
    const int wrong = v && !hard_right(c, &r) && !(c->flags & HARD_LIMIT), missing = !v && !(c->flags & open) && !is_short;
    bad |= wrong || missing;
    const int capped = v != c->truth && !(c->flags & HARD_LIMIT);
    say(c->name, v, wrong ? "WRONG" : missing ? "OPEN" : is_short ? "short" : !v ? "open" : capped ? "capped" : "", &r, c);
}

static void corpus_one(const char *name, int32_t k, const sp_scene *s, int32_t faces, sp_arena *arena, sp_status status)
{
    sp_settings set = hard_settings(0);
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
    const scene_settings as_it_is = scene_settings_default();
    host_scene s;
    failure error;
    char name[64];
    const char *last = strrchr(path, '/');
    memset(&r, 0, sizeof r);
    sp_arena_init(&arena, room, sizeof room);
    snprintf(name, sizeof name, "%s", last ? last + 1 : path);
    int status = scene_read(path, &as_it_is, &s, &error);
    set.localise = 1;
    if (tol > 0) set.tol = (sp_real)tol;
    started = clock();
    if (far) { printf("%s|%.3g\n", name, status ? 1 : distance(&s.scene, &set, arena)); scene_free(&s); return; }
    if (!status) status = sp_check(&s.scene, &set, &arena, &r);
    const int coarse = fine && r.verdict == SP_STABLE && r.imbalance > (sp_real)1e-12;
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
        else if (strcmp(argv[k], "far") == 0) far = 1;
        else if (strncmp(argv[k], "only=", 5) == 0) only = argv[k] + 5;
        else if (strncmp(argv[k], "tol=", 4) == 0) tol = atof(argv[k] + 4);
        else files = k;
    }
    for (int k = files; k < argc; k++) file(argv[k]);
    for (int k = 0; files == argc && k < HARD_CASES; k++) hard(&hard_cases[k]);
    if (files == argc && !without_corpus) corpus_all();
    return bad;
}
