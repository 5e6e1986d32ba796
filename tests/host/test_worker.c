/* The worker: messages come back bit by bit, nothing that is sent to it makes it crash, and nothing stays of a worker that does
 * not answer. Host only. */
#define _POSIX_C_SOURCE 200809L
#include "../test.h"
#include "../../port/host/files/failure.h"
#include "../../port/host/worker/worker.h"
#include "../../port/host/worker/worker_client.h"
#include "../scenes/gen.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* 1 ------------------------------------------------------------------------------------------------------------- scenes */

static double near_to(double x) { return x * (double)test_random_real(0.8, 1.25); }

/* A small scene by formula, its numbers about their defaults. */
static void by_formula(sp_scene *s)
{
    static const char *const name[] = { "two-cubes", "incline", "topple", "overhang", "cantilever", "arch", "flat-arch",
                                        "keystone", "h-model", "wall" };
    gen_scene g;
    CHECK_INT(gen_open(&g, name[test_random_int(0, 9)]), 1);
    for (int k = 0; k < GEN_OWN && g.entry->param[k].name; k++) gen_set(&g, g.entry->param[k].name, near_to(g.value[k]));
    gen_set(&g, "n", test_random_int(3, 5));
    gen_set(&g, "rows", 3);
    gen_set(&g, "bricks", 3);
    gen_set(&g, "mu", near_to(0.84));
    CHECK_INT(gen_build(&g, &test_arena, s), SP_OK);
}

/* A pile without meshes and with everything else a scene can hold: half held blocks, points, strength, loads, live ones. */
static void by_hand(sp_scene *s)
{
    const int32_t n = test_random_int(1, 5);
    const sp_capacity cap = { n + 1, 0, 0, 0, 2 * n, 6 * n, n };
    const sp_real zero[3] = { 0, 0, 0 };
    CHECK_INT(sp_scene_create(s, &cap, &test_arena), SP_OK);
    CHECK_INT(sp_scene_body(s, 0, zero, SP_FIXED, NULL), SP_OK);
    for (int32_t k = 1; k <= n; k++) {
        const sp_real z = R(k), c[3] = { test_random_real(-0.1, 0.1), test_random_real(-0.1, 0.1), z - R(0.5) };
        const sp_real level[12] = { -1, -1, z - 1, 1, -1, z - 1, 1, 1, z - 1, -1, 1, z - 1 };
        const sp_real n3[3] = { test_random_real(-1, 1), test_random_real(-1, 1), test_random_real(0.5, 3) };
        const sp_real spot[6] = { test_random_real(-1, 1), 0, z - 1, 0, test_random_real(-1, 1), z - 1 };
        const sp_strength strong = { R(0.7), test_random_real(0, 100), test_random_real(0, 50), test_random_real(1e5, 1e6) };
        const sp_strength plain = sp_strength_friction(test_random_real(0, 1));
        const sp_load load = { k, test_random_int(0, 1), { 0, 0, z }, { test_random_real(-5, 5), 0, -1 }, { 0, 1, 0 },
                               test_random_real(0, 9) };
        CHECK_INT(sp_scene_body(s, test_random_real(1, 100), c, (uint32_t)test_random_int(0, 7), NULL), SP_OK);
        CHECK_INT(sp_scene_joint(s, k - 1, k, 4, level, test_random() & 1 ? &strong : &plain, NULL), SP_OK);
        if (test_random() & 1) CHECK_INT(sp_scene_points(s, k - 1, k, n3, 2, spot, &plain, NULL), SP_OK);
        if (test_random() & 1) CHECK_INT(sp_scene_load(s, &load, NULL), SP_OK);
    }
    for (int c = 0; c < 3; c++) s->body[c] = test_random_real(-1, 1);
    s->live = test_random_real(0, 2);
    s->gravity[0] = test_random_real(-1, 1);
}

static void any_scene(sp_scene *s)
{
    test_arena.used = 0;
    if (test_random_int(0, 2)) by_formula(s);
    else by_hand(s);
}

static int strong(const sp_scene *s)
{
    for (int32_t k = 0; k < s->count.joints; k++) {
        const sp_strength *j = &s->joint[k].strength;
        if (j->cohesion > 0 || j->tension > 0 || j->crushing > 0) return 1;
    }
    return 0;
}

/* A question that does not take long. */
static sp_settings any_settings(const sp_scene *s)
{
    sp_settings set = test_random_int(0, 9) ? sp_settings_default() : sp_settings_seed();
    set.localise = test_random_int(0, 1);
    set.tol *= test_random_real(1, 100);
    set.coupled.asked = !strong(s) && test_random_int(0, 5) == 0;
    set.coupled.nodes = 100;
    set.coupled.rounds = 4;
    if (test_random_int(0, 3) == 0) set.budget = test_random_int(1, 1000000);
    if (strong(s)) set.faces = 0;
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) set.effect[k] = (sp_choice)(test_random_int(0, 6) % 5 % 3);
    return set;
}

static void same_settings(const sp_settings *a, const sp_settings *b)
{
    CHECK(memcmp(&a->tol, &b->tol, sizeof a->tol) == 0);
    CHECK(memcmp(&a->force_bound, &b->force_bound, sizeof a->tol) == 0);
    CHECK_INT(a->faces, b->faces);
    CHECK_INT(a->inscribed, b->inscribed);
    CHECK_INT(a->penalty.net, b->penalty.net);
    CHECK_INT(a->budget, b->budget);
    CHECK(memcmp(&a->penalty.gamma, &b->penalty.gamma, sizeof a->tol) == 0);
    CHECK(memcmp(&a->penalty.tau, &b->penalty.tau, sizeof a->tol) == 0);
    CHECK_INT(a->localise, b->localise);
    CHECK_INT(a->iterations, b->iterations);
    CHECK_INT(a->stage_count, b->stage_count);
    CHECK(memcmp(a->stage, b->stage, (size_t)a->stage_count * sizeof *a->stage) == 0);
    CHECK(memcmp(&a->coupled, &b->coupled, sizeof a->coupled) == 0);
    CHECK(memcmp(a->effect, b->effect, sizeof a->effect) == 0);
    CHECK(a->seed == b->seed);
}

static int same_islands(const sp_islands *a, const sp_islands *b, size_t blocks)
{
    if (a->count != b->count || !a->each != !b->each) return 0;
    return !a->each || (memcmp(a->of, b->of, blocks * sizeof *a->of) == 0
                        && memcmp(a->each, b->each, (size_t)a->count * sizeof *a->each) == 0);
}

/* Numbers of two results, all of them. */
static int same_numbers(const sp_scene *s, const sp_result *a, const sp_result *b)
{
    const size_t r = sizeof(sp_real), v = (size_t)s->count.points, n = (size_t)s->count.blocks, i = (size_t)s->count.joints;
    const sp_coupled *c = &a->coupled, *d = &b->coupled;
    return memcmp(a->f, b->f, 3 * v * r) == 0 && memcmp(a->dq, b->dq, 6 * n * r) == 0
        && memcmp(a->y0, b->y0, 12 * (size_t)a->counts.free_blocks * r) == 0 && memcmp(a->demand, b->demand, i * sizeof *a->demand) == 0
        && same_islands(&a->islands, &b->islands, n)
        && !c->dq == !d->dq && (!c->dq || memcmp(c->dq, d->dq, 6 * n * r) == 0)
        && !c->alpha == !d->alpha && (!c->alpha || memcmp(c->alpha, d->alpha, v * r) == 0)
        && !c->penalty == !d->penalty && (!c->penalty || memcmp(c->penalty, d->penalty, 4 * v * r) == 0)
        && c->proof.nodes == d->proof.nodes && c->proof.leaves == d->proof.leaves && c->proof.entries == d->proof.entries
        && (!c->proof.nodes || (memcmp(c->proof.node, d->proof.node, (size_t)c->proof.nodes * sizeof *c->proof.node) == 0
                                && memcmp(c->proof.row, d->proof.row, (size_t)c->proof.entries * sizeof *c->proof.row) == 0
                                && memcmp(c->proof.y, d->proof.y, (size_t)c->proof.entries * r) == 0));
}

static int same_cost(const sp_cost *a, const sp_cost *b)
{
    return a->flops == b->flops && a->factorisations == b->factorisations && a->iterations == b->iterations
        && a->interior == b->interior;
}

static int same_words(const sp_result *a, const sp_result *b)
{
    const sp_coupled *c = &a->coupled, *d = &b->coupled;
    const sp_real x[] = { a->tol, a->force_bound, a->imbalance, a->least_imbalance, a->extremes.compression, a->extremes.tension,
                          a->extremes.utilisation, a->extremes.corner_utilisation, a->extremes.tension_ratio, c->residual, c->eps, c->eta, c->margin, c->tension_ratio };
    const sp_real y[] = { b->tol, b->force_bound, b->imbalance, b->least_imbalance, b->extremes.compression, b->extremes.tension,
                          b->extremes.utilisation, b->extremes.corner_utilisation, b->extremes.tension_ratio, d->residual, d->eps, d->eta, d->margin, d->tension_ratio };
    int same = memcmp(x, y, sizeof x) == 0 && same_cost(&a->spent.total, &b->spent.total) && same_cost(&c->cost, &d->cost);
    for (int k = 0; k < SP_STAGES_MAX; k++) same = same && same_cost(&a->spent.by_stage[k], &b->spent.by_stage[k]);
    return same && a->verdict == b->verdict && a->level == b->level && a->reason == b->reason && a->final == b->final
        && a->verified == b->verified && a->stage == b->stage && a->counts.free_blocks == b->counts.free_blocks
        && memcmp(a->effect, b->effect, sizeof a->effect) == 0 && a->missing == b->missing && a->islands.count == b->islands.count
        && a->counts.joints == b->counts.joints && a->counts.points == b->counts.points && a->extremes.weakest == b->extremes.weakest
        && c->verdict == d->verdict && c->reason == d->reason && c->rounds == d->rounds && a->spent.peak_bytes == b->spent.peak_bytes;
}

/* A new field of a struct that travels must be told to blob.c and to the tests above. */
TEST(every_field_of_settings_and_result_is_known_to_the_messages)
{
    if (sizeof(void *) != 8) return;
    CHECK_INT(sizeof(sp_settings), TOL(200, 168));      /* watch, work and parallel stay here */
    CHECK_INT(sizeof(sp_result), TOL(528, 472));
}

TEST(scenes_come_through_and_are_answered_as_in_process_bit_by_bit)
{
    for (int round = 0; round < SOME_OF(1000, 150); round++) {
        blob request = { NULL, 0, 0, 0 }, answer = { NULL, 0, 0, 0 };
        void *memory = NULL, *ours = NULL, *theirs = NULL;
        sp_scene s, again;
        sp_settings set, read;
        sp_result own, told;
        run_cost cost, paid;
        int held;
        any_scene(&s);
        set = any_settings(&s);
        held = CHECK_INT(blob_write_request(&request, &s, &set), SP_OK)
            && CHECK_INT(blob_read_request(&request, &again, &read, &memory), SP_OK) && CHECK(worker_same_scene(&s, &again));
        if (held) same_settings(&set, &read);
        held = held && CHECK_INT(run_check(&s, &set, &own, &cost, &ours), SP_OK);
        if (held) worker_answer_to(&request, &answer);
        held = held && CHECK_INT(blob_read_result(&answer, &s, &told, &paid, &theirs), SP_OK)
            && CHECK(same_words(&own, &told)) && CHECK(same_numbers(&s, &own, &told)) && CHECK_INT(paid.bytes, cost.bytes);
        blob_free(&request);
        blob_free(&answer);
        free(memory);
        free(ours);
        free(theirs);
        if (!held) return;
    }
}

TEST(settings_with_pointers_do_not_travel)
{
    sp_settings set = sp_settings_default();
    const sp_qp_solver solver = sp_qp_admm();
    const sp_stage stage = { NULL, NULL };
    const sp_seed seed = *sp_seed_table();
    const sp_watch watch = { NULL, NULL };
    blob b = { NULL, 0, 0, 0 };
    sp_scene s;
    any_scene(&s);
    set.penalty.solver = &solver;
    CHECK_INT(blob_write_request(&b, &s, &set), SP_E_UNSUPPORTED);
    set.penalty.solver = NULL;
    set.custom = &stage;
    CHECK_INT(blob_write_request(&b, &s, &set), SP_E_UNSUPPORTED);
    set.custom = NULL;
    set.seed = &seed;
    CHECK_INT(blob_write_request(&b, &s, &set), SP_E_UNSUPPORTED);
    set.seed = NULL;
    set.watch = &watch;
    CHECK_INT(blob_write_request(&b, &s, &set), SP_E_UNSUPPORTED);
    blob_free(&b);
}

/* 2 --------------------------------------------------------------------------------------------------------- bad messages */

/* Bit by bit, unlike blob.c's.                                                                              [IEEE 802.3] */
static uint32_t crc(const unsigned char *p, size_t n)
{
    uint32_t c = 0xffffffffu;
    for (size_t k = 0; k < n; k++) {
        c ^= p[k];
        for (int i = 0; i < 8; i++) c = c & 1 ? c >> 1 ^ 0xedb88320u : c >> 1;
    }
    return ~c;
}

static void put4(unsigned char *p, uint32_t x) { for (int k = 0; k < 4; k++) p[k] = (unsigned char)(x >> 8 * k & 255); }

/* Length and checksum made right again. */
static void repair(blob *b)
{
    if (b->length < BLOB_HEADER + 4) return;
    put4(b->data + 12, (uint32_t)(b->length - BLOB_HEADER - 4));
    put4(b->data + b->length - 4, crc(b->data, b->length - 4));
}

static void copy(const blob *from, blob *to)
{
    to->length = 0;
    CHECK(blob_grow(to, from->length));
    memcpy(to->data, from->data, from->length);
    to->length = from->length;
}

/* One to four places changed: a byte, a word of a kind that hurts, or bytes gone. */
static void mutate(blob *b)
{
    static const uint32_t hurtful[] = { 0, 1, 0x7fffffff, 0x80000000, 0xffffffff, 0x7ff00000, 0x7ff80000, 0x7fe00000,
                                         0x00100000, 65536 };
    for (int k = test_random_int(1, 4); k > 0; k--) {
        const size_t at = (size_t)test_random_int(0, (int32_t)b->length - 5);
        switch (test_random_int(0, 4)) {
        case 0: b->data[at] ^= (unsigned char)(1u << test_random_int(0, 7)); break;
        case 1: b->data[at] = (unsigned char)test_random(); break;
        case 2: put4(b->data + at / 4 * 4, hurtful[test_random_int(0, 9)]); break;
        case 3: put4(b->data + (size_t)test_random_int(0, 40) * 4, (uint32_t)test_random_int(-2, 70)); break;
        default:
            if (b->length > 400 && test_random_int(0, 3) == 0) {
                memmove(b->data + at, b->data + at + 4, b->length - at - 4);
                b->length -= 4;
            }
        }
    }
}

/* An answer is a result or an error, whole. */
static int whole_answer(const blob *b) { return blob_whole(b, BLOB_RESULT) == SP_OK || blob_whole(b, BLOB_ERROR) == SP_OK; }

TEST(mutated_messages_are_answered)
{
    blob request = { NULL, 0, 0, 0 }, bad = { NULL, 0, 0, 0 }, answer = { NULL, 0, 0, 0 };
    int results = 0, errors = 0;
    for (int round = 0; round < SOME_OF(10000, 1500); round++) {
        if (round % 20 == 0) {
            sp_scene s;
            sp_settings set;
            any_scene(&s);
            set = any_settings(&s);
            CHECK_INT(blob_write_request(&request, &s, &set), SP_OK);
        }
        copy(&request, &bad);
        mutate(&bad);
        if (round % 4) repair(&bad);
        worker_answer_to(&bad, &answer);
        if (!CHECK(whole_answer(&answer))) break;
        if (blob_whole(&answer, BLOB_RESULT) == SP_OK) results++;
        else errors++;
    }
    CHECK(results > SOME_OF(1000, 100));
    CHECK(errors > SOME_OF(4000, 500));
    blob_free(&request);
    blob_free(&bad);
    blob_free(&answer);
}

TEST(mutated_results_are_read_or_refused)
{
    blob answer = { NULL, 0, 0, 0 }, bad = { NULL, 0, 0, 0 }, request = { NULL, 0, 0, 0 };
    sp_scene s;
    for (int round = 0; round < 2000; round++) {
        void *memory = NULL;
        sp_result r;
        run_cost cost;
        if (round % 50 == 0) {
            sp_settings set;
            any_scene(&s);
            set = any_settings(&s);
            CHECK_INT(blob_write_request(&request, &s, &set), SP_OK);
            worker_answer_to(&request, &answer);
        }
        copy(&answer, &bad);
        mutate(&bad);
        repair(&bad);
        const sp_status status = blob_read_result(&bad, &s, &r, &cost, &memory);
        CHECK(status == SP_OK || status == SP_E_ARGUMENT || status == SP_E_RANGE || status == SP_E_UNSUPPORTED);
        free(memory);
    }
    blob_free(&request);
    blob_free(&bad);
    blob_free(&answer);
}

/* What a session says to these bytes: its status; answers in *said. */
static int session(const unsigned char *bytes, size_t n, blob *said)
{
    FILE *in = tmpfile(), *out = tmpfile();
    int status = -1;
    said->length = 0;
    if (!CHECK(in && out)) return status;
    CHECK_INT(fwrite(bytes, 1, n, in), n);
    rewind(in);
    status = worker_session(in, out);
    const long size = ftell(out);
    rewind(out);
    if (CHECK(size >= 0 && blob_grow(said, (size_t)size + 1))) said->length = fread(said->data, 1, (size_t)size, out);
    fclose(in);
    fclose(out);
    return status;
}

TEST(a_thousand_truncated_messages_get_an_error)
{
    blob request = { NULL, 0, 0, 0 }, said = { NULL, 0, 0, 0 };
    for (int round = 0; round < SOME_OF(1000, 150); round++) {
        sp_scene s;
        sp_settings set;
        size_t n;
        if (round % 20 == 0) {
            any_scene(&s);
            set = any_settings(&s);
            CHECK_INT(blob_write_request(&request, &s, &set), SP_OK);
        }
        n = (size_t)test_random_int(1, (int32_t)request.length - 1);
        if (!CHECK_INT(session(request.data, n, &said), EXIT_SCENE) || !CHECK_INT(blob_whole(&said, BLOB_ERROR), SP_OK)) break;
    }
    blob_free(&request);
    blob_free(&said);
}

TEST(a_message_cut_short_with_a_right_checksum_is_refused)
{
    blob request = { NULL, 0, 0, 0 }, cut = { NULL, 0, 0, 0 };
    sp_scene s, read;
    sp_settings set = sp_settings_default();
    any_scene(&s);
    CHECK_INT(blob_write_request(&request, &s, &set), SP_OK);
    for (size_t n = BLOB_HEADER + 4; n < request.length; n++) {
        void *memory = NULL;
        copy(&request, &cut);
        cut.length = n;
        repair(&cut);
        CHECK_INT(blob_read_request(&cut, &read, &set, &memory), SP_E_RANGE);
        free(memory);
    }
    blob_free(&request);
    blob_free(&cut);
}

TEST(a_session_goes_on_after_a_bad_body_and_ends_after_a_bad_header)
{
    blob one = { NULL, 0, 0, 0 }, all = { NULL, 0, 0, 0 }, said = { NULL, 0, 0, 0 };
    const sp_settings set = sp_settings_default();
    static const blob_kind want[] = { BLOB_RESULT, BLOB_ERROR, BLOB_RESULT, BLOB_ERROR };
    size_t at = 0;
    sp_scene s;
    any_scene(&s);
    CHECK_INT(blob_write_request(&one, &s, &set), SP_OK);
    CHECK(blob_grow(&all, 5 * one.length));
    for (size_t k = 0; k < 5; k++) memcpy(all.data + k * one.length, one.data, one.length);
    all.data[one.length + BLOB_HEADER + 30] ^= 1;                       /* the second one's body */
    all.data[3 * one.length] ^= 1;                                      /* the fourth one's magic: the fifth is never read */
    CHECK_INT(session(all.data, 3 * one.length, &said), 0);
    CHECK_INT(session(all.data, 5 * one.length, &said), EXIT_SCENE);
    for (int k = 0; k < 4; k++) {
        blob_kind kind = BLOB_REQUEST;
        size_t length = 0;
        NEED(at + BLOB_HEADER <= said.length && blob_header(said.data + at, &kind, &length) == SP_OK);
        CHECK_INT(kind, want[k]);
        at += length;
    }
    CHECK_INT(at, said.length);
    blob_free(&one);
    blob_free(&all);
    blob_free(&said);
}

TEST(a_length_beyond_the_limit_is_refused_by_its_header)
{
    blob b = { NULL, 0, 0, 0 };
    blob_kind kind;
    size_t length;
    CHECK_INT(blob_write_error(&b, SP_E_RANGE, "no"), SP_OK);
    CHECK_INT(crc((const unsigned char *)"123456789", 9), 0xcbf43926);
    CHECK_INT(crc(b.data, b.length - 4), b.data[b.length - 4] | b.data[b.length - 3] << 8 | b.data[b.length - 2] << 16
                                         | (uint32_t)b.data[b.length - 1] << 24);
    CHECK_INT(blob_header(b.data, &kind, &length), SP_OK);
    CHECK_INT(length, b.length);
    put4(b.data + 12, BLOB_CAP + 1);
    CHECK_INT(blob_header(b.data, &kind, &length), SP_E_CAPACITY);
    put4(b.data + 12, 0);
    put4(b.data + 8, sizeof(sp_real) == 8);                             /* the other precision */
    CHECK_INT(blob_header(b.data, &kind, &length), SP_E_UNSUPPORTED);
    blob_free(&b);
}

/* 3 ---------------------------------------------------------------------------------------------------------- processes */

/* Seconds that no answer takes, however busy the machine; where a test waits for its end, the time is short and always passes. */
#define AMPLE 600

static worker_end ask(const char *const *command, const sp_scene *s, double seconds, int fallback, worker_answer *a)
{
    const worker_client client = { command, seconds, 0, fallback };
    worker_check(&client, s, NULL, a);
    free(a->memory);
    return a->end;
}

/* Neither a child nor an open file more than before. */
static int nothing_left(int lowest)
{
    const int fd = open("/dev/null", O_RDONLY);
    close(fd);
    errno = 0;
    return CHECK_INT(fd, lowest) && CHECK_INT(waitpid(-1, NULL, WNOHANG), -1) && CHECK_INT(errno, ECHILD);
}

static int lowest_file(void)
{
    const int fd = open("/dev/null", O_RDONLY);
    close(fd);
    return fd;
}

/* `body` in a process of its own, which has no children yet: this one may have been left some by whoever started it, as by a shell
 * that began other work and then became the runner. */
static void in_a_process(int (*body)(void))
{
    const pid_t pid = fork();
    int status = -1;
    if (pid == 0) _exit(body() ? 0 : 1);
    CHECK(pid > 0 && waitpid(pid, &status, 0) == pid);
    CHECK_INT(status, 0);
}

static int ask_the_deaf(void)
{
    static const char *const deaf[] = { "sleep", "600", NULL };
    const int lowest = lowest_file();
    worker_answer a;
    sp_scene s;
    any_scene(&s);
    for (int k = 0; k < SOME_OF(500, 50); k++)
        if (!CHECK_INT(ask(deaf, &s, 0.001, 0, &a), WORKER_LATE) || !CHECK_INT(a.code, -9)) return 0;
    return nothing_left(lowest);
}

TEST(timeouts_in_a_row_leave_no_process) { in_a_process(ask_the_deaf); }

/* A message much longer than any pipe holds. */
static void large(sp_scene *s)
{
    gen_scene g;
    test_arena.used = 0;
    CHECK_INT(gen_open(&g, "wall"), 1);
    CHECK_INT(gen_set(&g, "size", 2000), 1);
    CHECK_INT(gen_build(&g, &test_arena, s), SP_OK);
}

static int fill_pipes(void)
{
    static const char *const echo[] = { "cat", NULL }, *const deaf[] = { "sleep", "600", NULL };
    static const char *const loud[] = { "sh", "-c", "head -c 3000000 /dev/zero 2> /dev/null; exec cat > /dev/null", NULL };
    const int lowest = lowest_file();
    worker_answer a;
    sp_scene s;
    large(&s);
    return CHECK_INT(ask(echo, &s, AMPLE, 0, &a), WORKER_GARBLED)       /* all of it goes there and back */
        && CHECK_INT(ask(loud, &s, AMPLE, 0, &a), WORKER_GARBLED)
        && CHECK_INT(ask(deaf, &s, 0.05, 0, &a), WORKER_LATE) && nothing_left(lowest);
}

TEST(full_pipes_in_both_directions_do_not_block) { in_a_process(fill_pipes); }

static int ask_the_dying(void)
{
    static const struct { const char *command[4]; int code; } table[] = {
        { { "true", NULL, NULL, NULL }, 0 }, { { "false", NULL, NULL, NULL }, 1 },
        { { "/no/such/program", NULL, NULL, NULL }, 127 }, { { "sh", "-c", "kill -11 $$", NULL }, -11 } };
    const int lowest = lowest_file();
    worker_answer a;
    sp_scene s;
    large(&s);
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        if (!CHECK_INT(ask(table[k].command, &s, AMPLE, 0, &a), WORKER_DIED) || !CHECK_INT(a.code, table[k].code)
            || !CHECK_INT(a.status, SP_E_UNSUPPORTED) || !CHECK(a.message[0] != 0)) return 0;
    }
    return nothing_left(lowest);
}

TEST(a_worker_that_dies_is_told_with_its_status) { in_a_process(ask_the_dying); }

/* Has every process with this end of a pipe gone? */
static int all_gone(int fd)
{
    struct pollfd p = { fd, POLLIN, 0 };
    char byte;
    return poll(&p, 1, 1000 * AMPLE) == 1 && read(fd, &byte, 1) == 0;
}

TEST(what_a_worker_started_ends_with_it)
{
    static const char *const nested[] = { "sh", "-c", "sleep 600; true", NULL }, *const left[] = { "sh", "-c", "sleep 600 &", NULL };
    worker_answer a;
    sp_scene s;
    int end[2];
    any_scene(&s);
    NEED(pipe(end) == 0);
    CHECK_INT(ask(nested, &s, 0.1, 0, &a), WORKER_LATE);
    CHECK_INT(ask(left, &s, 0.1, 0, &a), WORKER_LATE);
    close(end[1]);
    CHECK(all_gone(end[0]));
    close(end[0]);
}

#ifdef __linux__
TEST(a_worker_ends_with_its_caller)
{
    static const char *const deaf[] = { "sleep", "600", NULL };
    worker_answer a;
    sp_scene s;
    int end[2];
    pid_t caller;
    any_scene(&s);
    NEED(pipe(end) == 0);
    caller = fork();
    if (caller == 0) {
        ask(deaf, &s, 600, 0, &a);
        _exit(0);
    }
    close(end[1]);
    const struct timespec pause = { 0, 100000000 };     /* whether its worker runs by then or not, it goes */
    nanosleep(&pause, NULL);
    CHECK_INT(kill(caller, SIGKILL), 0);
    CHECK_INT(waitpid(caller, NULL, 0), caller);
    CHECK(all_gone(end[0]));
    close(end[0]);
}
#endif

TEST(time_that_is_no_number_is_none)
{
    static const char *const deaf[] = { "sleep", "600", NULL };
    const double none = 0;
    worker_answer a;
    sp_scene s;
    any_scene(&s);
    CHECK_INT(ask(deaf, &s, none / none, 0, &a), WORKER_LATE);
    CHECK_INT(ask(deaf, &s, -1, 0, &a), WORKER_LATE);
}

/* A worker that says these bytes. */
static void saying(const blob *b, char script[2000])
{
    char *at = script + sprintf(script, "exec printf '");
    for (size_t k = 0; k < b->length && k < 400; k++) at += sprintf(at, "\\%03o", (unsigned)b->data[k]);
    strcpy(at, "'");
}

TEST(a_refusal_for_want_of_memory_falls_back_and_no_other)
{
    static const sp_status said[] = { SP_E_MEMORY, SP_E_RANGE };
    for (int k = 0; k < 2; k++) {
        char script[2000];
        const char *const command[] = { "sh", "-c", script, NULL };
        const worker_client client = { command, AMPLE, 0, 1 };
        blob b = { NULL, 0, 0, 0 };
        worker_answer a;
        sp_scene s;
        any_scene(&s);
        NEED(blob_write_error(&b, said[k], "no") == SP_OK);
        saying(&b, script);
        CHECK_INT(worker_check(&client, &s, NULL, &a), k ? SP_E_RANGE : SP_OK);
        CHECK_INT(a.end, WORKER_REFUSED);
        CHECK_INT(a.fell_back, !k);
        free(a.memory);
        blob_free(&b);
    }
}

TEST(limits_are_set_before_the_worker_starts)
{
    static const char *const command[] = { "sh", "-c", "test $(ulimit -v) = 100000 && test $(ulimit -t) = 601 && "
                                           "test $(ulimit -c) = 0 && exit 5", NULL };
    const worker_client client = { command, AMPLE, (size_t)100000 * 1024, 0 };
    worker_answer a;
    sp_scene s;
    any_scene(&s);
    worker_check(&client, &s, NULL, &a);
    CHECK_INT(a.end, WORKER_DIED);
    CHECK_INT(a.code, 5);
}

TEST(without_a_worker_the_check_falls_back_on_request)
{
    static const char *const none[] = { "false", NULL };
    const worker_client client = { none, AMPLE, 0, 1 };
    worker_answer a;
    run_cost cost;
    sp_result own;
    sp_scene s;
    void *memory;
    any_scene(&s);
    CHECK_INT(run_check(&s, NULL, &own, &cost, &memory), SP_OK);
    CHECK_INT(worker_check(&client, &s, NULL, &a), SP_OK);
    CHECK_INT(a.end, WORKER_DIED);
    CHECK_INT(a.fell_back, 1);
    CHECK(same_words(&own, &a.result) && same_numbers(&s, &own, &a.result));
    free(a.memory);
    free(memory);
}

TEST_LIST(worker)
    RUN(every_field_of_settings_and_result_is_known_to_the_messages)
    RUN(scenes_come_through_and_are_answered_as_in_process_bit_by_bit)
    RUN(settings_with_pointers_do_not_travel)
    RUN(mutated_messages_are_answered)
    RUN(mutated_results_are_read_or_refused)
    RUN(a_thousand_truncated_messages_get_an_error)
    RUN(a_message_cut_short_with_a_right_checksum_is_refused)
    RUN(a_session_goes_on_after_a_bad_body_and_ends_after_a_bad_header)
    RUN(a_length_beyond_the_limit_is_refused_by_its_header)
    RUN(timeouts_in_a_row_leave_no_process)
    RUN(full_pipes_in_both_directions_do_not_block)
    RUN(a_worker_that_dies_is_told_with_its_status)
    RUN(what_a_worker_started_ends_with_it)
#ifdef __linux__
    RUN(a_worker_ends_with_its_caller)
#endif
    RUN(time_that_is_no_number_is_none)
    RUN(a_refusal_for_want_of_memory_falls_back_and_no_other)
    RUN(limits_are_set_before_the_worker_starts)
    RUN(without_a_worker_the_check_falls_back_on_request)
TEST_END
