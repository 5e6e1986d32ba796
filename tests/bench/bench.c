/* bench: what a check costs, as CSV.
 *
 *     bench [--quick] [--machine NAME] [--date DATE] [TEXT]       TEXT: only scenes whose name contains it
 *
 * Every scene is judged in several configurations (cone, stages, with and without the localisation) and its evidence verified
 * again. These jobs take turns: one round runs each of them once, so a neighbour's load hits all alike. The first round warms
 * up and is dropped; of the others the median and the best are kept. Time is what the processor spent on this process. Arenas
 * are as small as sp_memory says.
 * Lines that start with # are comments: where and how it ran, the growth of time over joints, wrong verdicts (exit 1).
 *
 * Contents:  1 clock   2 jobs   3 one scene   4 scenes   5 growth   6 main
 */
#define _POSIX_C_SOURCE 200809L

#include "../scenes/gen.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifndef BENCH_FLAGS
#define BENCH_FLAGS "not told"
#endif
#if defined(__clang__) || !defined(__GNUC__)
#define BENCH_COMPILER __VERSION__
#else
#define BENCH_COMPILER "gcc " __VERSION__
#endif
#ifdef SP_REAL_FLOAT
#define BENCH_REAL "float"
#else
#define BENCH_REAL "double"
#endif

enum { JOBS = 12, ROUNDS = 101 };

static const double bench_seconds = 1.5;                /* for all rounds of one scene; a quick run has none to spare */
static const double pi = 3.14159265358979323846;

/* 1 -------------------------------------------------------------------------------------------------------------- clock */

#ifdef CLOCK_PROCESS_CPUTIME_ID
#define BENCH_CLOCK CLOCK_PROCESS_CPUTIME_ID            /* neighbours take the processor away, but not from this clock */
#else
#define BENCH_CLOCK CLOCK_MONOTONIC
#endif

static double now(void)                                 /* [s] */
{
    struct timespec t;
    clock_gettime(BENCH_CLOCK, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void *room(size_t bytes)
{
    void *p = malloc(bytes ? bytes : 1);
    if (!p) {
        fprintf(stderr, "bench: no memory\n");
        exit(71);
    }
    return p;
}

static void must(sp_status status, const char *what)
{
    if (status == SP_OK) return;
    fprintf(stderr, "bench: %s: %s\n", what, sp_status_text(status));
    exit(70);
}

/* 2 --------------------------------------------------------------------------------------------------------------- jobs */

typedef enum kind { BUILD, CONTACTS, SYMBOLIC, CHECK, VERIFY } kind;

static const char *const kind_name[] = { "build", "contacts", "symbolic", "check", "verify" };

typedef struct job {
    kind what;
    const char *config;
    sp_settings set;
    int hint;                                           /* VERIFY: give it y0 */
    size_t bytes;                                       /* of its arena */
    void *memory;
    sp_result result;                                   /* of a CHECK; its numbers are the same in every round */
    sp_evidence evidence;                               /* of a VERIFY */
    sp_contact_report report;
    double seconds[ROUNDS];
} job;

/* One scene and everything done with it. */
typedef struct bench {
    const char *family, *size, *load;
    const gen_scene *gen;
    sp_scene scene, bare;                               /* as made; another without joints, for their finding */
    sp_settings set;                                    /* what jobs start from */
    sp_verdict expected;                                /* SP_UNDECIDED: nobody knows */
    job job[JOBS];
    int jobs, runs;
    int claim;                                          /* the job whose evidence is verified */
} bench;

static job *add(bench *b, kind what, const char *config, const sp_settings *set)
{
    job *j = &b->job[b->jobs++];
    memset(j, 0, sizeof *j);
    j->what = what;
    j->config = config;
    j->set = *set;
    return j;
}

/* The seed's stages at the seed's accuracy, one by one; its program with our sparse factor, kept from iteration to iteration. */
static void add_seed(bench *b)
{
    static sp_seed table;
    sp_settings s = sp_settings_seed();
    table = *sp_seed_table();
    table.dense_cells = 0;
    s.seed = &table;
    s.localise = 0;
    s.stage_count = 2;
    s.stage[1] = SP_STAGE_POLISH;
    add(b, CHECK, "seed: polish", &s);
    s.stage[1] = SP_STAGE_ADMM;
    add(b, CHECK, "seed: ADMM", &s);
}

static void add_checks(bench *b, int contacts)
{
    sp_settings s = b->set;
    if (contacts) {
        add(b, BUILD, "", &s);
        add(b, CONTACTS, "", &s);
        add(b, SYMBOLIC, "", &s);
    }
    b->claim = b->jobs;
    add(b, CHECK, "true", &s);
    add(b, VERIFY, "hint", &s)->hint = 1;
    add(b, VERIFY, "alone", &s);
    s.localise = 1;
    if (b->expected != SP_STABLE) add(b, CHECK, "true and where help is wanted", &s);
    s.localise = 0;
    s.faces = 8;
    add(b, CHECK, "8 inscribed", &s);
    s.faces = 0;
    s.stage[1] = SP_STAGE_LEAST_SQUARES;
    if (b->expected == SP_STABLE) add(b, CHECK, "least squares", &s);
    if (contacts && b->scene.count.points <= 700 && !strcmp(b->family, "wall")) add_seed(b);
}

/* sp_memory of what follows from counts alone. */
static size_t counted(const sp_scene *scene, sp_memory_for what, const sp_settings *settings)
{
    const sp_arena none = { NULL, 0, 0, 0 };
    size_t bytes = 0;
    return sp_memory(scene, what, settings, none, &bytes) == SP_OK ? bytes : 0;
}

/* The arena of a job, exact. */
static void furnish(bench *b, job *j)
{
    sp_arena scratch;
    if (j->what == BUILD) j->bytes = sp_scene_memory(&b->scene.capacity);
    if (j->what == CONTACTS) j->bytes = counted(&b->bare, SP_FOR_CONTACTS, NULL);
    if (j->what == SYMBOLIC) j->bytes = sp_memory_scratch(&b->scene, SP_FOR_CHECK, &j->set);
    if (j->what == VERIFY) j->bytes = counted(&b->scene, SP_FOR_VERIFY, NULL);
    if (j->what == CHECK) {
        const size_t need = sp_memory_scratch(&b->scene, SP_FOR_CHECK, &j->set);
        void *memory = room(need);
        must(sp_arena_init(&scratch, memory, need), "scratch");
        must(sp_memory(&b->scene, SP_FOR_CHECK, &j->set, scratch, &j->bytes), "sp_memory");
        free(memory);
    }
    j->memory = room(j->bytes);
}

/* Once, timed; the job's own preparations are outside the clock. */
static double run(bench *b, job *j)
{
    sp_arena arena;
    sp_scene built;
    size_t bytes;
    sp_contact_settings touch = sp_contact_settings_default();
    sp_result claim = b->job[b->claim].result;
    must(sp_arena_init(&arena, j->memory, j->bytes), "arena");
    if (!j->hint) claim.y0 = NULL;
    b->bare.count.joints = b->bare.count.points = 0;
    const double start = now();
    switch (j->what) {
    case BUILD:    must(gen_build(b->gen, &arena, &built), "build"); break;
    case CONTACTS: must(sp_contacts_find(&b->bare, &touch, arena, &j->report), "sp_contacts_find"); break;
    case SYMBOLIC: must(sp_memory(&b->scene, SP_FOR_CHECK, &j->set, arena, &bytes), "sp_memory"); break;
    case CHECK:    must(sp_check(&b->scene, &j->set, &arena, &j->result), "sp_check"); break;
    case VERIFY:   must(sp_verify(&b->scene, &j->set, &claim, arena, &j->evidence), "sp_verify"); break;
    }
    return now() - start;
}

/* Rounds until the time is spent; returns how many count. A round that takes all of it is not repeated. */
static int rounds(bench *b, int quick)
{
    double first = 0, spent = 0;
    int k = 0;
    for (int j = 0; j < b->jobs; j++) first += b->job[j].seconds[0] = run(b, &b->job[j]);
    if (first > 2 * bench_seconds) return 1;
    const int most = quick ? 3 : ROUNDS, least = quick ? 1 : 3;
    for (; k < most && (k < least || spent < bench_seconds); k++)
        for (int j = 0; j < b->jobs; j++) spent += b->job[j].seconds[k] = run(b, &b->job[j]);
    return k;
}

/* 3 ---------------------------------------------------------------------------------------------------------- one scene */

typedef struct tally { int rows, wrong, undecided, unverified; } tally;

static void count(const bench *b, const job *j, tally *t)
{
    const sp_verdict v = j->what == CHECK ? j->result.verdict : j->evidence.verdict;
    t->rows++;
    if (j->what == CHECK && j->set.stage[1] == SP_STAGE_LEAST_SQUARES) return;     /* often passes on, by its nature */
    if (j->what == CHECK && v && !j->result.verified) t->unverified++;
    if (v && b->expected && v != b->expected) t->wrong++;
    if (!v && b->expected) t->undecided++;
}

/* 1e3 * the k-th of the sorted seconds [ms] */
static double median(job *j, int runs)
{
    qsort(j->seconds, (size_t)runs, sizeof *j->seconds, by_size);
    return 1e3 * (runs % 2 ? j->seconds[runs / 2] : 0.5 * (j->seconds[runs / 2 - 1] + j->seconds[runs / 2]));
}

static void print(bench *b, job *j)
{
    const sp_capacity *n = &b->scene.count;
    const double ms = median(j, b->runs);
    printf("%s,%s,%s,%s,%s,%s,%ld,%ld,%ld,", BENCH_REAL, kind_name[j->what], b->family, b->size, b->load, j->config,
           (long)n->blocks, (long)n->joints, (long)n->points);
    if (j->what == CHECK) {
        const sp_result *r = &j->result;
        printf("%s,%d,%.2e,%ld,%ld,%lld", sp_verdict_text(r->verdict), (int)r->verified, (double)r->imbalance,
               (long)r->spent.total.factorisations, (long)r->spent.total.iterations, (long long)r->spent.total.flops);
    } else if (j->what == VERIFY) printf("%s,,%.2e,,,", sp_verdict_text(j->evidence.verdict), (double)j->evidence.imbalance);
    else printf(",,,,,");
    printf(",%lu,%.0f,%d,%.4g,%.4g\n", (unsigned long)j->bytes, (double)j->bytes / n->points, b->runs, 1e3 * j->seconds[0], ms);
    fflush(stdout);
}

/* The same scene with all its faces and no joint. */
static void strip(bench *b, void *memory, size_t bytes)
{
    sp_arena arena;
    must(sp_arena_init(&arena, memory, bytes), "arena");
    must(gen_build(b->gen, &arena, &b->bare), "build");
}

static void scene(bench *b, int contacts, int quick, tally *t)
{
    sp_capacity cap;
    b->jobs = 0;
    add_checks(b, contacts);
    must(gen_capacity(b->gen, &cap), "capacity");
    const size_t bytes = sp_scene_memory(&cap);
    void *bare = room(bytes);
    strip(b, bare, bytes);
    for (int k = 0; k < b->jobs; k++) furnish(b, &b->job[k]);
    b->runs = rounds(b, quick);
    for (int k = 0; k < b->jobs; k++) {
        job *j = &b->job[k];
        print(b, j);
        if (j->what == CHECK || j->what == VERIFY) count(b, j, t);
        if (j->what == CONTACTS && j->report.joints != b->scene.count.joints) {
            printf("# %s %s: %ld interfaces found of %ld\n", b->family, b->size, (long)j->report.joints,
                   (long)b->scene.count.joints);
            t->wrong++;
        }
        free(j->memory);
    }
    free(bare);
}

/* 4 ------------------------------------------------------------------------------------------------------------- scenes */

/* How a wall is loaded: the world turned by `angle`, or by `share` of the angle at which the wall as one piece overturns. */
typedef struct wall_load { const char *name; double share, angle, azimuth; sp_verdict expected; } wall_load;

static const wall_load loads[] = {
    { "flat",  0,    0,    0,  SP_STABLE },
    { "tilt",  0.6,  0,    90, SP_STABLE },
    { "inpl2", 0,    0.25, 0,  SP_STABLE },
    { "top",   1.25, 0,    90, SP_UNSTABLE },
    { "inpl",  0,    0.55, 0,  SP_UNDECIDED }           /* close to sliding and rocking: depends on size and cone */
};

enum { LOADS = sizeof loads / sizeof loads[0] };

static const struct { const char *size; int loads, quick; } walls[] = {        /* only two of them with the last load */
    { "54", LOADS - 1, 1 }, { "95", LOADS - 1, 1 }, { "147", LOADS - 1, 1 }, { "500", LOADS, 1 }, { "2000", LOADS, 0 },
    { "10000", LOADS - 1, 0 }
};

enum { WALLS = sizeof walls / sizeof walls[0] };

/* Another family: one generator with two thicknesses. */
typedef struct shell {
    const char *family, *size, *scene;
    const char *first; double first_value; const char *second; double second_value;
    double stable, unstable;                            /* thickness / radius */
    int quick;
} shell;

static const shell shells[] = {
    { "arch",  "11",  "arch",  "n", 11, NULL, 0, 0.12, 0.10, 1 },
    { "arch",  "51",  "arch",  "n", 51, NULL, 0, 0.12, 0.10, 1 },
    { "arch",  "101", "arch",  "n", 101, NULL, 0, 0.12, 0.10, 0 },
    { "arch",  "200", "arch",  "n", 200, NULL, 0, 0.12, 0.10, 0 },
    { "dome",  "S",   "dome",  "rings", 6, "segments", 12, 0.10, 0.02, 1 },
    { "dome",  "M",   "dome",  "rings", 12, "segments", 24, 0.10, 0.02, 0 },
    { "dome",  "L",   "dome",  "rings", 20, "segments", 48, 0.10, 0.02, 0 },
    { "vault", "S",   "vault", "around", 9, "n", 7, 0.15, 0.09, 1 },
    { "vault", "M",   "vault", "around", 25, "n", 12, 0.15, 0.09, 0 },
    { "vault", "L",   "vault", "around", 41, "n", 24, 0.15, 0.09, 0 }
};

enum { SHELLS = sizeof shells / sizeof shells[0] };

/* tan of the overturning angle of all blocks but the ground: depth / height. */
static double slenderness(const sp_scene *s)
{
    double low = 0, high = 0, depth = 0;
    for (int32_t i = 0; i < s->count.vertices; i++) {
        if (i < s->block[0].vertex + s->block[0].vertices) continue;
        if ((double)s->vertex[i][2] > high) high = (double)s->vertex[i][2];
        if ((double)s->vertex[i][1] > depth) depth = (double)s->vertex[i][1];
    }
    return depth / (high - low);
}

typedef struct fit { double joints, ms, flops; } fit;

static sp_arena make(bench *b, const gen_scene *g)
{
    sp_capacity cap;
    sp_arena arena;
    must(gen_capacity(g, &cap), "capacity");
    const size_t bytes = sp_scene_memory(&cap);
    must(sp_arena_init(&arena, room(bytes), bytes), "arena");
    must(gen_build(g, &arena, &b->scene), "build");
    b->gen = g;
    b->set = sp_settings_default();
    return arena;
}

/* A wall in one load case; flat ones give a point of the growth curve. */
static void wall(bench *b, const char *size, const wall_load *l, int quick, tally *t, fit *growth, int *points)
{
    gen_scene g;
    gen_open(&g, "wall");
    gen_set(&g, "size", atof(size));
    gen_set(&g, "jitter", 0.35);
    sp_arena arena = make(b, &g);
    const double angle = l->share > 0 ? atan(slenderness(&b->scene)) * l->share : l->angle;
    gen_gravity(angle * 180 / pi, l->azimuth, b->scene.gravity);
    b->family = "wall";
    b->size = size;
    b->load = l->name;
    b->expected = l->expected;
    if (!l->expected) b->set.iterations = 60;           /* the collapse of a large one may wander for long */
    const int flat = l == loads;
    scene(b, flat, quick, t);
    if (flat) {
        const job *j = &b->job[b->claim];
        const fit f = { b->scene.count.joints, 1e3 * j->seconds[b->runs / 2], (double)j->result.spent.total.flops };
        growth[(*points)++] = f;
    }
    free(arena.base);
}

static void shell_run(bench *b, const shell *s, int stable, int quick, tally *t)
{
    gen_scene g;
    gen_open(&g, s->scene);
    gen_set(&g, s->first, s->first_value);
    if (s->second) gen_set(&g, s->second, s->second_value);
    gen_set(&g, "t", stable ? s->stable : s->unstable);
    if (!strcmp(s->scene, "vault")) gen_set(&g, "jitter", 0.35);
    sp_arena arena = make(b, &g);
    b->family = s->family;
    b->size = s->size;
    b->load = stable ? "thick" : "thin";
    b->expected = stable ? SP_STABLE : SP_UNSTABLE;
    scene(b, stable, quick, t);
    free(arena.base);
}

/* 5 ------------------------------------------------------------------------------------------------------------- growth */

/* Slope of log y over log x, least squares; y: ms (0) or flops (1). */
static double exponent(const fit *f, int n, int flops)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int k = 0; k < n; k++) {
        const double x = log(f[k].joints), y = log(flops ? f[k].flops : f[k].ms);
        sx += x; sy += y; sxx += x * x; sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/* 6 --------------------------------------------------------------------------------------------------------------- main */

static int wanted(const char *text, const char *family, const char *size, const char *load)
{
    char name[64];
    snprintf(name, sizeof name, "%s %s %s", family, size, load);
    return !text || strstr(name, text);
}

static void head(const char *machine, const char *date)
{
    printf("# stonepack %d.%d.%d, machine %s, date %s, compiler %s, flags %s\n", SP_VERSION_MAJOR, SP_VERSION_MINOR,
           SP_VERSION_PATCH, machine, date, BENCH_COMPILER, BENCH_FLAGS);
    printf("real,kind,family,size,load,config,blocks,interfaces,vertices,verdict,verified,omega,factorisations,"
           "iterations,flops,bytes,bytes_per_vertex,runs,best_ms,median_ms\n");
}

int main(int argc, char **argv)
{
    static bench b;
    const char *machine = "not told", *date = "not told", *only = NULL;
    int quick = 0, points = 0;
    tally t = { 0, 0, 0, 0 };
    fit growth[WALLS];
    for (int k = 1; k < argc; k++) {
        if (!strcmp(argv[k], "--quick")) quick = 1;
        else if (!strcmp(argv[k], "--machine") && k + 1 < argc) machine = argv[++k];
        else if (!strcmp(argv[k], "--date") && k + 1 < argc) date = argv[++k];
        else only = argv[k];
    }
    head(machine, date);
    for (int k = 0; k < WALLS; k++)
        for (int l = 0; l < (quick ? LOADS - 1 : walls[k].loads); l++)
            if ((!quick || walls[k].quick) && wanted(only, "wall", walls[k].size, loads[l].name))
                wall(&b, walls[k].size, &loads[l], quick, &t, growth, &points);
    for (int k = 0; k < SHELLS; k++)
        for (int thin = 0; thin < 2; thin++)
            if ((!quick || shells[k].quick) && wanted(only, shells[k].family, shells[k].size, thin ? "thin" : "thick"))
                shell_run(&b, &shells[k], !thin, quick, &t);
    if (points > 1)
        printf("# flat walls, true cone: time as interfaces^%.2f, flops as interfaces^%.2f\n", exponent(growth, points, 0),
               exponent(growth, points, 1));
    printf("# %d verdicts: %d wrong, %d undecided, %d not verified\n", t.rows, t.wrong, t.undecided, t.unverified);
    return t.wrong || t.unverified ? 1 : 0;
}
