/* threads: two threads ask the same questions of the same scenes at once, each in an arena of its own, build orders among them,
 * and two share the tasks of a factor. Their answers are those of one thread, bit by bit; ThreadSanitizer looks on [check.sh,
 * sanitizers]. With -DPLANTED they share an arena, which it must see. */
#define _POSIX_C_SOURCE 200809L
#include "../../port/host/command/jobs.h"
#include "../scenes/gen.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { BYTES = 8 << 20, SCENES = 6, BLOCKS = 6, QUESTIONS = 5 };

static const char *const name[SCENES] = { "arch", "two-cubes", "h-model", "incline", "wall", "keystone" };
static uint64_t room[BYTES / 8], own[3][BYTES / 8];
static sp_scene scene[SCENES];
static sp_arena shared;

typedef struct answers {
    uint64_t *memory;
    uint64_t sum[SCENES][QUESTIONS];
    int failed;
} answers;

static uint64_t fnv(uint64_t h, const void *data, size_t n)                                    /* [Fowler, Noll, Vo] */
{
    const unsigned char *p = data;
    for (size_t k = 0; k < n; k++) h = (h ^ p[k]) * 1099511628211u;
    return h;
}

static uint64_t sum_of(const sp_scene *s, const sp_real *f, const sp_real *dq, int32_t verdict)
{
    uint64_t h = fnv(14695981039346656037u, f, 3 * (size_t)s->count.points * sizeof *f);
    h = fnv(h, dq, 6 * (size_t)s->count.blocks * sizeof *dq);
    return fnv(h, &verdict, sizeof verdict);
}

static void ask(answers *w, int k)
{
    const sp_scene *s = &scene[k];
    sp_settings set = sp_settings_default();
    sp_limit_result limit;
    sp_evidence evidence;
    sp_result r;
    sp_arena fresh, *a = &fresh;
#ifdef PLANTED
    a = &shared;
    (void)w;
#else
    sp_arena_init(a, w->memory, BYTES);
#endif
    set.localise = 1;
    set.budget = 20000000;              /* TSan makes each of them a hundred times as dear */
    for (int coupled = 0; coupled < 2; coupled++) {
        set.coupled.asked = coupled;
        if (sp_check(s, &set, a, &r) != SP_OK || sp_verify(s, &set, &r, *a, &evidence) != SP_OK) { w->failed = 1; return; }
        w->sum[k][2 * coupled] = sum_of(s, r.f, r.dq, (int32_t)r.verdict);
        w->sum[k][1] = fnv(w->sum[k][1], &evidence.imbalance, sizeof evidence.imbalance);
    }
    if (sp_limit(s, NULL, a, &limit) != SP_OK) { w->failed = 1; return; }
    w->sum[k][3] = sum_of(s, limit.f, limit.dq, (int32_t)limit.kind);
}

/* A build order, of the calls that Python makes in one: each block comes and goes again, what must be held, what comes next. */
static void build(answers *w, int k)
{
    const sp_scene *s = &scene[k];
    sp_settings set = sp_settings_default();
    sp_sequence *order;
    sp_suggestion next;
    sp_held held;
    sp_step step;
    sp_arena fresh, *a = &fresh;
#ifdef PLANTED
    a = &shared;
#else
    sp_arena_init(a, w->memory, BYTES);
#endif
    set.budget = 2000000;
    if (sp_sequence_open(s, &set, a, &order) != SP_OK) { w->failed = 1; return; }
    for (int32_t block = 0; block < s->count.blocks && block < BLOCKS; block++)
        for (int turn = 0; turn < 3; turn++) {
            if (sp_sequence_set(order, block, turn % 2 ? SP_ABSENT : SP_PRESENT, &step) != SP_OK) { w->failed = 1; return; }
            w->sum[k][4] = fnv(w->sum[k][4], &step.verdict, sizeof step.verdict) ^ sum_of(s, step.f, step.dq, step.block);
        }
    if (sp_sequence_hold(order, 2000000, &held) != SP_OK || sp_sequence_suggest(order, 1, 2000000, &next) != SP_OK) w->failed = 1;
    else w->sum[k][4] = fnv(w->sum[k][4], &held.count, sizeof held.count) ^ (uint64_t)next.block;
}

static void *ask_all(void *p)
{
    answers *const w = p;
    for (int k = 0; k < SCENES; k++) { ask(w, k); build(w, k); }
    return NULL;
}

/* A dome that stands, checked by one thread and by two, as the program does with --jobs. */
static int shares(void)
{
    sp_settings set = sp_settings_default();
    sp_scene dome;
    sp_arena a;
    failure error;
    sp_result r[2];
    sp_arena_init(&a, own[0], BYTES);
    int failed = gen_make("dome", "rings", 8, &a, &dome) != SP_OK || jobs_begin(2, &set.parallel, &error);
    if (failed || sp_check(&dome, &set, &a, &r[0]) != SP_OK) return 1;
    jobs_end();
    set.parallel = NULL;
    if (sp_check(&dome, &set, &a, &r[1]) != SP_OK) return 1;
    for (int k = 0; k < 3 * dome.count.points; k++) failed |= r[0].f[k] < r[1].f[k] || r[0].f[k] > r[1].f[k];
    return failed || r[0].verdict != r[1].verdict;
}

int main(void)
{
    static answers w[3];
    sp_arena a;
    pthread_t thread[2];
    int failed = 0;
    sp_arena_init(&a, room, sizeof room);
    for (int k = 0; k < SCENES; k++) if (gen_make(name[k], NULL, 0, &a, &scene[k]) != SP_OK) return 1;
    sp_arena_init(&shared, own[2], sizeof own[2]);
    for (int t = 0; t < 3; t++) w[t].memory = own[t];
    for (int t = 0; t < 2; t++) if (pthread_create(&thread[t], NULL, ask_all, &w[t])) return 1;
    for (int t = 0; t < 2; t++) pthread_join(thread[t], NULL);
    ask_all(&w[2]);
    for (int t = 0; t < 3; t++) failed += w[t].failed || memcmp(w[t].sum, w[2].sum, sizeof w[2].sum) != 0;
    failed += shares();
    printf("%d passed, %d failed\n", 4 - failed, failed);
    return failed != 0;
}
