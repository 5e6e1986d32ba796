/* Requests and results of the worker as any bytes, their checksum made right: an answer whose header is whole, or a refusal. */
#include "fuzz.h"
#include "../../port/host/worker/worker.h"
#include "../../port/fuzz/bytes.h"

static uint32_t checksum(const unsigned char *p, size_t n)
{
    uint32_t c = ~0u;
    while (n--) {
        c ^= *p++;
        for (int k = 0; k < 8; k++) c = c >> 1 ^ (c & 1 ? 0xedb88320u : 0);
    }
    return ~c;
}

/* A stored result read back for a scene: refused, or judged. */
static void result(const blob *b)
{
    static uint64_t room[1 << 14], more[1 << 18];
    sp_arena a;
    sp_scene s;
    sp_result r;
    run_cost cost;
    sp_evidence e;
    void *memory = NULL;
    const uint8_t two[] = { 0 };
    sp_settings set = sp_settings_default();
    FORGET(room, sizeof room);
    FORGET(more, sizeof more);
    sp_arena_init(&a, room, sizeof room);
    if (sp_scene_from_bytes(two, 1, &a, &s)) abort();
    if (blob_read_result(b, &s, &r, &cost, &memory) == SP_OK) {
        sp_arena_init(&a, more, sizeof more);
        set.coupled.asked = r.coupled.verdict != SP_COUPLING_NOT_ASKED;
        sp_verify(&s, &set, &r, a, &e);
    }
    free(memory);
}

/* A request: only what is small is answered. */
static void request(const blob *b)
{
    blob answer = { NULL, 0, 0, 0 };
    sp_scene s;
    sp_settings set;
    void *memory = NULL;
    const sp_status status = blob_read_request(b, &s, &set, &memory);
    const int small = status == SP_OK && s.count.blocks < 12 && s.count.points < 100 && set.iterations <= 500
        && set.coupled.rounds <= 50 && set.coupled.nodes <= 1000 && set.budget > 0 && set.budget < 20000000;
    free(memory);
    if (status == SP_OK && !small) return;
    worker_answer_to(b, &answer);
    blob_kind kind;
    size_t length;
    HOLDS(answer.length >= BLOB_HEADER, "no answer");
    HOLDS(blob_header(answer.data, &kind, &length) == SP_OK && length == answer.length, "header");
    blob_free(&answer);
}

/* A request for a scene of the bytes, some of it overwritten by their last ones. */
static void made(blob *b, const uint8_t *data, size_t size)
{
    static uint64_t room[1 << 14];
    sp_arena a;
    sp_scene s;
    sp_settings set = sp_settings_default();
    set.budget = 1000000;
    set.iterations = 100;
    sp_arena_init(&a, room, sizeof room);
    if (sp_scene_from_bytes(data, size - 8, &a, &s) || blob_write_request(b, &s, &set)) abort();
    for (size_t k = 1; k < data[size - 2] % 4u * 2; k += 2) {
        const size_t at = (data[size - 2 - k] * 256u + data[size - 3 - k]) % b->length;
        b->data[at] = (unsigned char)(b->data[at] ^ data[size - 4]);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    blob b = { NULL, 0, 0, 0 };
    if (size < BLOB_HEADER + 8 || size > 4000) return 0;
    const unsigned how = data[size - 1];
    if (how & 16) made(&b, data, size);
    else {
        if (!blob_grow(&b, size)) abort();
        memcpy(b.data, data, size);
        b.length = size;
    }
    const uint32_t c = checksum(b.data, b.length - 4);
    if (how & 1) for (int k = 0; k < 4; k++) b.data[b.length - 4 + (size_t)k] = (unsigned char)(c >> 8 * k);
    if (how & 2) result(&b);
    else request(&b);
    blob_free(&b);
    FILE *in = fmemopen((void *)(uintptr_t)data, size, "rb"), *out = fopen("/dev/null", "wb");
    if ((how & 12) == 4 && size < 400 && in && out) worker_session(in, out);
    if (in) fclose(in);
    if (out) fclose(out);
    return 0;
}
