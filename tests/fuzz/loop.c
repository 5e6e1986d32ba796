/* loop: a plain driver of a target, without any fuzzer. What fails is made small and left in the file that FOUND names.
 *
 *     TARGET SECONDS [SEED] FILE...      each file once, then bytes of them changed at random, until the time is over
 *     TARGET COUNTx [SEED] FILE...       likewise, so many times
 *     TARGET FILE...                     each file once: what a fuzzer found, or AFL++ with @@
 */
#include "fuzz.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MOST = 4096, FILES = 4096, FIRST = 8, HANGS = 60 };      /* [s] of clock: one input that takes longer has failed */

static uint8_t data[FILES][MOST];
static size_t length[FILES];
static int files;
static uint64_t state = 88172645463325252u;

/* What is asked now; the parent sees it when the child is gone. */
typedef struct input { uint64_t runs; size_t n; uint8_t byte[MOST]; } input;
static input *now;

static uint32_t any(uint32_t below)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (uint32_t)(state >> 32) % below;
}

static void read_file(const char *path)
{
    FILE *in = fopen(path, "rb");
    if (!in || files == FILES) { fprintf(stderr, "%s: cannot be read\n", path); exit(66); }
    length[files] = fread(data[files], 1, MOST, in);
    files++;
    fclose(in);
}

/* A file, up to eight of its bytes changed, a piece of another put in, or cut short. */
static size_t change(uint8_t *out)
{
    const int f = files ? (int)any((uint32_t)(any(2) && files > FIRST ? FIRST : files)) : -1;
    size_t n = f < 0 || !any(8) ? any(160) : length[f];
    for (size_t k = 0; k < n; k++) out[k] = f < 0 || k >= length[f] ? (uint8_t)any(256) : data[f][k];
    for (uint32_t k = any(8); n && k > 0; k--) {
        const size_t at = any((uint32_t)n);
        if (any(2)) out[at] = (uint8_t)any(256);
        else out[at] = (uint8_t)(out[at] + any(9) - 4);
    }
    if (files && !any(4)) {
        const int g = (int)any((uint32_t)files);
        const size_t from = length[g] ? any((uint32_t)length[g]) : 0, to = n ? any((uint32_t)n) : 0;
        for (size_t k = 0; to + k < n && from + k < length[g] && k < 32; k++) out[to + k] = data[g][from + k];
    }
    return any(8) ? n : n ? any((uint32_t)n) : 0;
}

static void ask(const uint8_t *byte, size_t n)
{
    uint8_t *copy = malloc(n ? n : 1);                  /* sanitizers see what is read behind it */
    if (!copy) exit(71);
    memcpy(copy, byte, n);
    alarm(HANGS);
    LLVMFuzzerTestOneInput(copy, n);
    alarm(0);
    free(copy);
}

/* In a process of its own, silent: does it fail? */
static int fails(const uint8_t *byte, size_t n)
{
    int status;
    const pid_t child = fork();
    if (child < 0) return 0;
    if (!child) {
        if (!freopen("/dev/null", "w", stderr)) _exit(0);
        ask(byte, n);
        _exit(0);
    }
    return waitpid(child, &status, 0) == child && status;
}

/* Fewer bytes, then smaller ones, as long as it fails. */
static size_t shrunk(uint8_t *byte, size_t n)
{
    uint8_t less[MOST];
    for (size_t piece = n; piece > 0; piece /= 2)
        for (size_t at = 0; at + piece <= n;) {
            memcpy(less, byte, at);
            memcpy(less + at, byte + at + piece, n - at - piece);
            if (fails(less, n - piece)) { n -= piece; memcpy(byte, less, n); }
            else at += piece;
        }
    for (size_t at = 0; at < n; at++)
        for (unsigned to = 0; to < byte[at]; to = to ? 2 * to : 1) {
            memcpy(less, byte, n);
            less[at] = (uint8_t)to;
            if (fails(less, n)) { byte[at] = (uint8_t)to; break; }
        }
    return n;
}

/* What failed, as small as it gets, in a file. */
static int found(void)
{
    const char *path = getenv("FOUND") ? getenv("FOUND") : "found";
    const size_t before = now->n;
    fprintf(stderr, "input %llu fails\n", (unsigned long long)now->runs);
    if (!fails(now->byte, now->n)) fprintf(stderr, "not by itself\n");
    else now->n = shrunk(now->byte, now->n);
    FILE *out = fopen(path, "wb");
    if (!out || fwrite(now->byte, 1, now->n, out) != now->n || fclose(out)) { fprintf(stderr, "%s: not written\n", path); return 74; }
    fprintf(stderr, "%s: %zu bytes of %zu\n", path, now->n, before);
    return 1;
}

static void run(double seconds, uint64_t count)
{
    const clock_t from = clock();
    for (int k = 0; k < files; k++) {
        now->n = length[k];
        memcpy(now->byte, data[k], now->n);
        ask(now->byte, now->n);
    }
    for (; now->runs < count && (double)(clock() - from) < seconds * CLOCKS_PER_SEC; now->runs++) {
        now->n = change(now->byte);
        ask(now->byte, now->n);
    }
}

int main(int argc, char **argv)
{
    char *end = argc > 1 ? argv[1] : NULL;
    const double many = argc > 1 ? strtod(argv[1], &end) : 0;
    const int counted = end && end[0] == 'x' && !end[1];
    int first = end && (counted || !*end) && many > 0 ? 2 : 1, status;
    if (first == 2 && argc > 2) {
        const uint64_t seed = strtoull(argv[2], &end, 10);
        if (!*end) { state += seed * 2862933555777941757u; first = 3; }
    }
    for (int k = first; k < argc; k++) read_file(argv[k]);
    if (first == 1) {
        for (int k = 0; k < files; k++) ask(data[k], length[k]);
        return 0;
    }
    now = mmap(NULL, sizeof *now, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (now == MAP_FAILED) return 71;
    const pid_t child = fork();
    if (child < 0) return 71;
    if (!child) { run(counted ? 1e9 : many, counted ? (uint64_t)many : UINT64_MAX); return 0; }
    if (waitpid(child, &status, 0) != child) return 71;
    if (status) return found();
    fprintf(stderr, "%llu executions\n", (unsigned long long)now->runs);
    return 0;
}
