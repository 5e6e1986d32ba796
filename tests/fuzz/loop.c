/* loop: a plain driver of a target, without any fuzzer.
 *
 *     TARGET SECONDS [SEED] FILE...      each file once, then bytes of them changed at random, until the time is over
 *     TARGET FILE...                     each file once: what a fuzzer found, or AFL++ with @@
 */
#include "fuzz.h"

#include <time.h>

enum { MOST = 4096, FILES = 256 };

static uint8_t data[FILES][MOST];
static size_t length[FILES];
static int files;
static uint64_t state = 88172645463325252u;

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
    const int f = files ? (int)any((uint32_t)files) : -1;
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

int main(int argc, char **argv)
{
    char *end = argc > 1 ? argv[1] : NULL;
    const double seconds = argc > 1 ? strtod(argv[1], &end) : 0;
    int first = end && !*end && seconds > 0 ? 2 : 1;
    if (first == 2 && argc > 2) {
        const uint64_t seed = strtoull(argv[2], &end, 10);
        if (!*end) { state += seed * 2862933555777941757u; first = 3; }
    }
    for (int k = first; k < argc; k++) read_file(argv[k]);
    for (int k = 0; k < files; k++) LLVMFuzzerTestOneInput(data[k], length[k]);
    static uint8_t now[MOST];
    const clock_t from = clock();
    uint64_t runs = 0;
    for (; first > 1 && (double)(clock() - from) < seconds * CLOCKS_PER_SEC; runs++) {
        const size_t n = change(now);
        if (getenv("LAST")) {                           /* what was asked when it fell */
            FILE *last = fopen(getenv("LAST"), "wb");
            if (last) { fwrite(now, 1, n, last); fclose(last); }
        }
        uint8_t *copy = malloc(n ? n : 1);              /* sanitizers see what is read behind it */
        if (!copy) return 71;
        memcpy(copy, now, n);
        LLVMFuzzerTestOneInput(copy, n);
        free(copy);
    }
    fprintf(stderr, "%llu executions\n", (unsigned long long)runs);
    return 0;
}
