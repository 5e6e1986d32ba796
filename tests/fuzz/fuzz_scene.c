/* Any bytes as a small scene (port/fuzz), and everything that can be asked of it. What must hold:
 *
 *     memory      sp_memory tells enough; on failure nothing is touched
 *     numbers     no NaN, no infinity
 *     evidence    sp_verify proves the verdict from the evidence and never the other one from forged evidence; sp_limit_verify,
 *                 sp_strong_verify likewise
 *     invariants  no opposite verdict of the same scene with all effects, moved, turned, in other units, in another order, given
 *                 block by block; of a stable one with more friction, with one more block held, or with one more contact
 */
#include "fuzz.h"
#include "../../port/fuzz/bytes.h"

enum { ROOM = 1 << 20 };
static uint64_t room[5][ROOM / 8];                      /* used again and again */

static sp_arena arena(int k)
{
    sp_arena a;
    FORGET(room[k], ROOM);
    HOLDS(sp_arena_init(&a, room[k], ROOM) == SP_OK, "arena");
    return a;
}

static void all_finite(const sp_real *x, int32_t n, const char *what)
{
    for (int32_t k = 0; k < n; k++) HOLDS(isfinite(x[k]), "%s[%d]", what, (int)k);
}

static int opposite(sp_verdict a, sp_verdict b) { return a + b == SP_STABLE + SP_UNSTABLE && a && b; }

/* ------------------------------------------------------------------------------------------------------------- a check */

/* The evidence of a result proves its verdict. */
static void evidence(const sp_scene *s, const sp_settings *set, const sp_result *r)
{
    sp_evidence e;
    sp_settings same = *set;
    sp_arena a = arena(4);
    size_t bytes = 0;
    const sp_arena nothing = { NULL, 0, 0, 0 };
    HOLDS(sp_memory(s, SP_FOR_VERIFY, NULL, nothing, &bytes) == SP_OK && bytes <= a.capacity, "%zu bytes", bytes);
    a.capacity = bytes;
    same.tol = r->tol;
    same.force_bound = r->force_bound;
    const sp_status status = sp_verify(s, &same, r, a, &e);
    HOLDS(status == SP_OK, "verify: status %d", (int)status);
    if (r->verdict) HOLDS(e.verdict == r->verdict, "check %d, verify %d, imbalance %g, least %g", (int)r->verdict, (int)e.verdict,
                          (double)e.imbalance, (double)e.least_imbalance);
    if (r->final) HOLDS(e.final, "final");
    if (r->level == SP_COUPLED) HOLDS(e.level == SP_COUPLED, "residual %g", (double)e.residual);
}

/* In the memory that it says it takes, in arena k. */
static sp_verdict check(const sp_scene *s, const sp_settings *set, int k, sp_result *r)
{
    sp_arena a = arena(k), scratch = arena(4);
    size_t bytes = 0;
    memset(r, 0, sizeof *r);
    sp_status status = sp_memory(s, SP_FOR_CHECK, set, scratch, &bytes);
    if (status == SP_E_MEMORY || bytes > a.capacity) return SP_UNDECIDED;       /* a proof's room may be large */
    if (!status) {
        a.capacity = bytes;
        status = sp_check(s, set, &a, r);
    }
    if (status) {
        HOLDS(status == SP_E_UNSUPPORTED || status == SP_E_NOT_FINITE, "check: status %d", (int)status);
        r->verdict = SP_UNDECIDED;
        r->f = NULL;
        return SP_UNDECIDED;
    }
    HOLDS(r->spent.peak_bytes <= bytes, "%zu of %zu bytes", r->spent.peak_bytes, bytes);
    all_finite(r->f, 3 * s->count.points, "f");
    all_finite(r->dq, 6 * s->count.blocks, "dq");
    const sp_real number[6] = { r->imbalance, r->least_imbalance, r->extremes.compression, r->extremes.tension,
                                r->extremes.utilisation, r->coupled.residual };
    for (int q = 0; q < 6; q++) HOLDS(!isnan(number[q]), "number %d", q);
    HOLDS(r->verified == (r->verdict != SP_UNDECIDED), "verified %d", (int)r->verified);
    evidence(s, set, r);
    return r->verdict;
}

/* ---------------------------------------------------------------------------------------------------------- other writings */

/* How a scene is written again: x' = scale (x, y, z turned by quarters) + shift, blocks from the last to the first, every
 * friction times so much, one more block held, one more contact of bytes. */
typedef struct writing { int reverse, quarter; double scale, shift, mu; int32_t held; const uint8_t *contact; } writing;

static void turned(const writing *w, const sp_real x[3], double size, double shift, sp_real y[3])
{
    const sp_real a = w->quarter ? -x[1] : x[0], b = w->quarter ? x[0] : x[1];
    y[0] = (sp_real)(size * (double)a + shift);
    y[1] = (sp_real)(size * (double)b - shift);
    y[2] = (sp_real)(size * (double)x[2] + shift);
}

/* One to three points with friction between any two blocks, about the middle between them, as eleven bytes say.
 *     returns 0: refused */
static int one_more_contact(sp_scene *s, const uint8_t byte[11])
{
    const int32_t n = s->count.blocks, a = byte[0] % n, b = (a + 1 + byte[1] % (n - 1)) % n, points = 1 + byte[2] % 3;
    const sp_strength strength = sp_strength_friction((sp_real)(byte[3] / 64.0));
    sp_real normal[3], x[9];
    for (int c = 0; c < 3; c++) normal[c] = (sp_real)((byte[4 + c] % 16 - 8) + (c == 2 ? 0.5 : 0));     /* never 0 */
    for (int k = 0; k < 9; k++) {
        const sp_real middle = (s->block[a].centroid[k % 3] + s->block[b].centroid[k % 3]) / 2;
        x[k] = middle + (sp_real)((byte[7 + (k + k / 3) % 4] - 128) / 64.0);
    }
    return !sp_scene_points(s, a, b, normal, points, x, &strength, NULL);
}

/* Blocks by mass and centroid, joints by their corners.     returns 0: refused */
static int written(const sp_scene *in, const writing *w, int k, sp_scene *out)
{
    const double s = w->scale, s3 = s * s * s;
    sp_arena a = arena(k);
    const sp_capacity cap = { in->count.blocks, 0, 0, 0, in->count.joints + 1, in->count.points + 3, in->count.loads };
    const int32_t n = in->count.blocks;
    sp_real y[3 * 320];
    if (sp_scene_create(out, &cap, &a)) return 0;
    turned(w, in->gravity, 1, 0, out->gravity);
    for (int32_t b = 0; b < n; b++) {
        const sp_block *o = &in->block[w->reverse ? n - 1 - b : b];
        const uint32_t fixed = o->fixed;
        const int held = (w->reverse ? n - 1 - b : b) == w->held;
        turned(w, o->centroid, s, w->shift, y);
        uint32_t turn = fixed;                          /* held directions turn with it */
        if (w->quarter) turn = (fixed & ~27u) | (fixed & 1) << 1 | (fixed & 2) >> 1 | (fixed & 8) << 1 | (fixed & 16) >> 1;
        if (sp_scene_body(out, (sp_real)((double)o->mass * s3), y, held ? SP_FIXED : turn, NULL)) return 0;
    }
    for (int32_t q = 0; q < in->count.joints; q++) {
        const sp_joint *j = &in->joint[w->reverse ? in->count.joints - 1 - q : q];
        sp_strength strength = j->strength;
        strength.mu = (sp_real)((double)strength.mu * w->mu);
        strength.cohesion = (sp_real)((double)strength.cohesion * s);
        strength.tension = (sp_real)((double)strength.tension * s);
        strength.crushing = (sp_real)((double)strength.crushing * s);
        for (int32_t v = 0; v < j->points; v++) turned(w, in->point[j->point + v], s, w->shift, y + 3 * v);
        const int32_t ja = w->reverse ? n - 1 - j->a : j->a, jb = w->reverse ? n - 1 - j->b : j->b;
        if (sp_scene_joint(out, ja, jb, j->points, y, &strength, NULL)) return 0;
    }
    for (int32_t q = 0; q < in->count.loads; q++) {
        sp_load load = in->load[q];
        load.block = w->reverse ? n - 1 - load.block : load.block;
        turned(w, in->load[q].force, s3, 0, load.force);
        turned(w, in->load[q].couple, s3 * s, 0, load.couple);
        turned(w, in->load[q].point, s, w->shift, load.point);
        if (sp_scene_load(out, &load, NULL)) return 0;
    }
    return !w->contact || one_more_contact(out, w->contact);
}

/* What a forged claim proves. */
static sp_verdict proved(const sp_scene *s, const sp_result *claim)
{
    sp_settings same = sp_settings_default();
    sp_evidence e;
    same.tol = claim->tol;
    same.force_bound = claim->force_bound;
    return sp_verify(s, &same, claim, arena(4), &e) ? SP_UNDECIDED : e.verdict;
}

/* Evidence of the other verdict is never believed: of what stands each block pushed and turned along each axis, and motions
 * and forces of bytes for both. */
static void forged(const sp_scene *s, const sp_result *r, const uint8_t *data, size_t size)
{
    static sp_real dq[6 * SP_FUZZ_BLOCKS], f[3 * 320];
    const int32_t n = 6 * s->count.blocks;
    sp_result claim = *r;
    claim.verdict = r->verdict == SP_STABLE ? SP_UNSTABLE : SP_STABLE;
    claim.dq = dq;
    claim.f = f;
    for (int32_t c = 0; c < 3 * s->count.points; c++) f[c] = r->f[c] * (sp_real)(1 + (c % 3 ? 0 : data[(size_t)c % size] / 256.0));
    for (int32_t k = 0; k < (r->verdict == SP_STABLE ? 2 * n : 0); k++) {
        memset(dq, 0, sizeof dq);
        dq[k / 2] = k % 2 ? -1 : 1;
        HOLDS(proved(s, &claim) != SP_UNSTABLE, "it stands, motion %d", (int)k);
    }
    for (int32_t k = 0; k < n; k++) dq[k] = (sp_real)((int)data[(size_t)k % size] - 128);
    HOLDS(!opposite(r->verdict, proved(s, &claim)), "another motion, other forces");
}

static void never_opposite(const sp_scene *s, sp_verdict v, const writing *w, const char *what)
{
    sp_scene other;
    sp_result r;
    const sp_settings set = sp_settings_default();
    if (!written(s, w, 2, &other)) return;
    const sp_verdict got = check(&other, &set, 3, &r);
    HOLDS(!opposite(v, got), "%s: %d instead of %d", what, (int)got, (int)v);
}

/* ----------------------------------------------------------------------------------------------------------- other questions */

static void limit(const sp_scene *s, sp_verdict v)
{
    sp_arena a = arena(2), scratch = arena(4);
    sp_settings set = sp_settings_default();
    sp_limit_result r;
    size_t bytes = 0;
    int32_t held = -1;
    set.budget = 20000000;
    if (sp_memory(s, SP_FOR_LIMIT, &set, scratch, &bytes) || bytes > a.capacity) return;
    a.capacity = bytes;
    sp_status status = sp_limit(s, &set, &a, &r);
    HOLDS(status == SP_OK, "limit: status %d", (int)status);
    const sp_real number[5] = { r.multiplier, r.lower, r.upper, r.within, r.imbalance };
    for (int k = 0; k < 5; k++) HOLDS(!isnan(number[k]), "number %d", k);
    all_finite(r.f, 3 * s->count.points, "f");
    all_finite(r.dq, 6 * s->count.blocks, "dq");
    if (r.kind == SP_LIMIT_FOUND) HOLDS(r.lower <= r.upper, "%g .. %g", (double)r.lower, (double)r.upper);
    set.tol = r.tol;
    set.force_bound = r.force_bound;
    status = sp_limit_verify(s, &set, &r, arena(4), &held);
    HOLDS(status == SP_OK, "limit verify: status %d", (int)status);
    if (r.verified) HOLDS(held, "kind %d", (int)r.kind);
    if (r.kind != SP_LIMIT_FOUND || s->live < 1 || s->live > 1) return;
    if (v == SP_STABLE) HOLDS(r.upper >= 1 - (sp_real)1e-6, "stands at 1, limit %g", (double)r.upper);
    if (v == SP_UNSTABLE && r.dead == SP_STABLE) HOLDS(r.lower <= 1 + (sp_real)1e-6, "falls at 1, limit %g", (double)r.lower);
}

/* Block by block up to the whole scene. */
static void sequence(const sp_scene *s, sp_verdict v)
{
    sp_arena a = arena(2), scratch = arena(4);
    sp_sequence *q;
    sp_step step;
    sp_held held;
    size_t bytes = 0;
    const sp_status room_for = sp_memory(s, SP_FOR_SEQUENCE, NULL, scratch, &bytes);
    if (room_for || bytes > a.capacity) return;
    a.capacity = bytes;
    HOLDS(sp_sequence_open(s, NULL, &a, &q) == SP_OK, "open");
    memset(&step, 0, sizeof step);
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const sp_status status = sp_sequence_set(q, b, SP_PRESENT, &step);
        HOLDS(status == SP_OK, "set: status %d", (int)status);
        all_finite(step.f, 3 * s->count.points, "step f");
    }
    HOLDS(!opposite(step.verdict, v), "sequence %d, check %d", (int)step.verdict, (int)v);
    HOLDS(sp_sequence_hold(q, 1000000, &held) == SP_OK, "hold");
    for (int32_t k = 0; k < held.count; k++) HOLDS(held.block[k] >= 0 && held.block[k] < s->count.blocks, "held %d", (int)k);
}

static void strong(const sp_scene *s, const sp_real *f)
{
    sp_arena a = arena(2), scratch = arena(4);
    const sp_strong_settings few = { 16, 0 };
    sp_settings set = sp_settings_default();
    sp_strong_result r;
    sp_strong_kind proved = SP_STRONG_NONE;
    size_t bytes = 0;
    set.budget = 5000000;
    if (sp_memory(s, SP_FOR_STRONG, &set, scratch, &bytes) || bytes > a.capacity) return;
    a.capacity = bytes;
    const sp_status status = sp_strong(s, &set, &few, f, NULL, &a, &r);
    HOLDS(status == SP_OK, "strong: status %d", (int)status);
    HOLDS(r.kind != SP_STRONG_NONE, "forces of a stable check hold nothing");
    all_finite(r.f, 3 * s->count.points, "strong f");
    all_finite(r.a, 6 * s->count.blocks, "a");
    set.tol = r.tol;
    HOLDS(sp_strong_verify(s, &set, &r, arena(4), &proved) == SP_OK, "strong verify");
    HOLDS(proved == r.kind, "said %d, proved %d", (int)r.kind, (int)proved);
}

/* The same scene written otherwise, with more friction, one more block held or one more contact: never the opposite verdict. */
static void rewritten(const sp_scene *s, sp_verdict v, unsigned mode, unsigned more, const uint8_t *data, size_t size)
{
    uint8_t byte[11];
    if (mode == 2) never_opposite(s, v, &(writing){ 1, 0, 1, 0, 1, -1, NULL }, "in another order");
    if (mode == 3) never_opposite(s, v, &(writing){ 0, 1, 1, 4, 1, -1, NULL }, "moved and turned");
    if (mode == 4) never_opposite(s, v, &(writing){ 0, 0, 32, 0, 1, -1, NULL }, "in other units");
    if (v != SP_STABLE) return;
    if (mode == 5) never_opposite(s, v, &(writing){ 0, 0, 1, 0, 1 + more / 64.0, -1, NULL }, "with more friction");
    if (mode == 6)
        never_opposite(s, v, &(writing){ 0, 0, 1, 0, 1, (int32_t)(more % (unsigned)s->count.blocks), NULL }, "with one more held");
    for (size_t k = 0; k < sizeof byte; k++) byte[k] = data[(1 + k) % size];
    if (mode == 15) never_opposite(s, v, &(writing){ 0, 0, 1, 0, 1, -1, byte }, "with one more contact");
}

/* A pyramid; more faces inside the cone hold no less than fewer. */
static void in_a_pyramid(const sp_scene *s, sp_verdict v, sp_settings set, unsigned more)
{
    sp_result other;
    set.faces = 3 + (int32_t)(more % 62);
    set.inscribed = (int32_t)(more % 2);
    const sp_verdict p = check(s, &set, 3, &other);
    if (set.inscribed) HOLDS(!(p == SP_STABLE && v == SP_UNSTABLE), "inside %d faces, not in the cone", (int)set.faces);
    else HOLDS(!(p == SP_UNSTABLE && v == SP_STABLE), "in the cone, not inside %d faces", (int)set.faces);
}

/* By other settings: what holds between their verdict and v. */
static void asked_otherwise(const sp_scene *s, sp_verdict v, sp_settings set, unsigned mode, unsigned more)
{
    sp_result other;
    if (mode == 1) {
        for (int k = 0; k < SP_EFFECTS_FORCED; k++) set.effect[k] = SP_WITH;
        HOLDS(!opposite(v, check(s, &set, 3, &other)), "with all effects");
    }
    if (mode == 10) in_a_pyramid(s, v, set, more);
    if (mode == 11) {
        set.coupled.asked = 1;
        set.coupled.nodes = 100 + 4 * (int32_t)more;
        set.coupled.box = (int32_t)(more % 2);
        set.budget = 20000000;
        HOLDS(!(check(s, &set, 3, &other) == SP_STABLE && v == SP_UNSTABLE), "coupled, not admissible");
    }
    if (mode == 12) {
        set.budget = 1 + 40 * (int64_t)more * more;
        HOLDS(!opposite(v, check(s, &set, 3, &other)), "with a budget");
    }
    if (mode == 14) {
        set.stage_count = 3;
        set.stage[0] = SP_STAGE_GATES;
        set.stage[1] = more % 2 ? SP_STAGE_LEAST_SQUARES : SP_STAGE_DENSE;
        set.stage[2] = more & 2 ? SP_STAGE_POLISH : SP_STAGE_ADMM;
        set.iterations = 200;
        HOLDS(!opposite(v, check(s, &set, 3, &other)), "by stages");
    }
}

/* One byte less is refused, and nothing touched. */
static void short_of_memory(const sp_scene *s, const sp_settings *set, size_t need, unsigned more)
{
    static unsigned char before[sizeof(sp_result)];
    sp_result other;
    sp_arena b = arena(3);
    b.capacity = need > 64 ? more * (need - 1) / 255 : 0;
    memset(&other, 0x5a, sizeof other);
    memcpy(before, &other, sizeof other);
    const sp_status status = sp_check(s, set, &b, &other);
    HOLDS(status == SP_E_MEMORY && b.used == 0 && !memcmp(before, &other, sizeof other), "status %d", (int)status);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    sp_arena a = arena(0);
    sp_scene s;
    sp_result r;
    sp_settings set = sp_settings_default();
    if (size < 4 || size > 200) return 0;
    const unsigned mode = data[0] % 16, more = data[1];
    set.localise = data[0] < 128;
    if (sp_scene_from_bytes(data + 2, size - 2, &a, &s)) return 0;
    const sp_verdict v = check(&s, &set, 1, &r);
    if (!r.f) return 0;
    if (mode == 0 && v) forged(&s, &r, data, size);
    if (mode == 7) limit(&s, v);
    if (mode == 8) sequence(&s, v);
    if (mode == 9 && v == SP_STABLE) strong(&s, r.f);
    if (mode == 13) short_of_memory(&s, &set, r.spent.peak_bytes, more);
    rewritten(&s, v, mode, more, data, size);
    asked_otherwise(&s, v, set, mode, more);
    return 0;
}
