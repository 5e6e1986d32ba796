/* plan: what leaving out effects saves, as CSV per kind of scene and per what was left out.
 *
 *     make bench-plan [SCENES='FILE ...']      without scenes: 300 random ones of every kind, tests/scenes/kinds.h
 *
 * Every scene is checked as planned and with all effects. Flops and bytes are counted, so they are the same everywhere; times are
 * the processor's, the best of three in turns. Ratios of sums: what the full simulation of all scenes takes over what the
 * planned one takes; "least" is that of the worst scene. Exit 1 where two verdicts differ.
 */
#define _POSIX_C_SOURCE 200809L

#include "../scenes/kinds.h"
#include "../../port/host/files/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { SCENES = 300, ROWS = KINDS + 16 };

typedef struct row {
    const char *name;
    int scenes, agree;
    double seconds[2], flops[2], bytes[2], least;       /* planned, full */
} row;

static row rows[ROWS];

static double now(void)                                 /* [s] */
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void *room(size_t bytes)
{
    void *p = malloc(bytes ? bytes : 1);
    if (p) return p;
    fprintf(stderr, "bench-plan: no memory\n");
    exit(71);
}

/* One check in an arena of sp_memory's size.     returns its time */
static double run(const sp_scene *s, const sp_settings *set, sp_result *r)
{
    sp_arena a;
    size_t bytes = sp_memory_scratch(s, SP_FOR_CHECK, set);
    void *scratch = room(bytes), *memory;
    sp_arena_init(&a, scratch, bytes);
    if (sp_memory(s, SP_FOR_CHECK, set, a, &bytes)) exit(70);
    free(scratch);
    memory = room(bytes);
    sp_arena_init(&a, memory, bytes);
    const double start = now();
    if (sp_check(s, set, &a, r)) exit(70);
    const double seconds = now() - start;
    free(memory);                                       /* the result's arrays with it */
    r->spent.peak_bytes = bytes;
    return seconds;
}

/* The row of that name from `first` on, a new one where there is none. */
static row *find(const char *name, int first)
{
    int k = first;
    while (rows[k].name && strcmp(rows[k].name, name)) k++;
    rows[k].name = name;
    return &rows[k];
}

static void count(row *o, const sp_result r[2], const double seconds[2])
{
    const double ratio = r[0].spent.total.flops > 0 ? (double)r[1].spent.total.flops / (double)r[0].spent.total.flops : 1;
    o->least = o->scenes && o->least < ratio ? o->least : ratio;
    o->scenes++;
    o->agree += r[0].verdict == r[1].verdict;
    for (int k = 0; k < 2; k++) {
        o->seconds[k] += seconds[k];
        o->flops[k] += (double)r[k].spent.total.flops;
        o->bytes[k] += (double)r[k].spent.peak_bytes;
    }
}

static const char *decided(const sp_result *r)
{
    const int plane = r->effect[SP_EFFECT_DEPTH] == SP_WHY_MIRROR, plumb = r->effect[SP_EFFECT_FRICTION] == SP_WHY_PRESSURE;
    if (plane) return r->verdict == SP_STABLE ? "in the plane, stable" : "in the plane, unstable";
    if (plumb) return r->verdict == SP_STABLE ? "by pressure alone, stable" : "by pressure alone, unstable";
    return r->islands.count > 1 ? "by islands, not all of one kind" : "with all effects";
}

static void check(const char *name, const sp_scene *s, const sp_settings *set, int told)
{
    sp_settings all = *set;
    sp_result r[2];
    double seconds[2] = { 0, 0 };
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) all.effect[k] = SP_WITH;
    for (int round = 0; round < 3; round++)
        for (int k = 0; k < 2; k++) {
            const double t = run(s, k ? &all : set, &r[k]);
            seconds[k] = round && seconds[k] < t ? seconds[k] : t;
        }
    count(find(name, 0), r, seconds);
    count(find(decided(&r[0]), KINDS), r, seconds);
    if (r[0].verdict != r[1].verdict)
        printf("# %s %d: %s as planned, %s\n", name, told, sp_verdict_text(r[0].verdict), sp_verdict_text(r[1].verdict));
}

static void print(const char *group, int first, int last)
{
    row all = { "together", 0, 0, { 0, 0 }, { 0, 0 }, { 0, 0 }, 1e9 };
    for (int q = first; q <= last; q++) {
        const row *o = q < last ? &rows[q] : &all;
        if (!o->scenes) continue;
        printf("%s,\"%s\",%d,%d,%.3f,%.3f,%.2f,%.3f\n", group, o->name, o->scenes, o->agree, o->flops[1] / o->flops[0],
               o->least, o->seconds[1] / o->seconds[0], o->bytes[1] / o->bytes[0]);
        all.scenes += o->scenes;
        all.agree += o->agree;
        if (o->least < all.least) all.least = o->least;
        for (int k = 0; k < 2; k++) {
            all.seconds[k] += o->seconds[k];
            all.flops[k] += o->flops[k];
            all.bytes[k] += o->bytes[k];
        }
    }
    if (all.scenes != all.agree) rows[ROWS - 1].agree = -1;
}

int main(int argc, char **argv)
{
    const scene_settings as_it_is = scene_settings_default();
    for (int k = 1; k < argc; k++) {
        failure error = { 0, "" };
        host_scene s;
        sp_settings set = sp_settings_default();
        if (scene_read(argv[k], &as_it_is, &s, &error) == 0)
            for (int cone = 0; cone < 2; cone++, set.faces = 8) check("scenes given", &s.scene, &set, k);
        else fprintf(stderr, "%s\n", error.line);
        scene_free(&s);
    }
    const size_t bytes = (size_t)64 << 20;
    void *memory = room(bytes);
    for (int k = 0; k < SCENES && argc < 2; k++) {
        sp_arena a;
        sp_scene s;
        sp_settings set;
        sp_arena_init(&a, memory, bytes);
        if (kinds_make(k, &a, &s, &set)) exit(70);
        check(kinds_table[k % KINDS].name, &s, &set, k);
    }
    free(memory);
    printf("group,name,scenes,agree,flops,least,time,bytes\n");
    print("kind", 0, KINDS);
    print("decided", KINDS, ROWS - 1);
    return rows[ROWS - 1].agree < 0;
}
