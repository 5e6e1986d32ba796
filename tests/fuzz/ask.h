/* ask: what all questions of fuzz_scene.c share: memory used again and again, draws, counts of what was asked, a check whose
 * evidence is verified, and what two verdicts may say of each other. */
#ifndef ASK_H
#define ASK_H

#include "draws.h"
#include "../../port/fuzz/bytes.h"

enum { ROOM = 1 << 20, SCENE = 0, CHECK, OTHER, CHECK_OTHER, SEQUENCE, SCRATCH, ROOMS, VERTICES = 320 };
static uint64_t room[ROOMS][ROOM / 8];                  /* used again and again */

static sp_arena arena(int k)
{
    sp_arena a;
    FORGET(room[k], ROOM);
    HOLDS(sp_arena_init(&a, room[k], ROOM) == SP_OK, "arena");
    return a;
}

/* Bytes that a call wants; 0: more than there is room for, or nothing. */
static size_t bytes_of(const sp_scene *s, sp_memory_for what, const sp_settings *set)
{
    size_t bytes = 0;
    const sp_status status = sp_memory(s, what, set, arena(SCRATCH), &bytes);
    HOLDS(status == SP_OK || status == SP_E_MEMORY || status == SP_E_UNSUPPORTED || status == SP_E_NOT_FINITE ||
          status == SP_E_EMPTY, "memory for %d: status %d", (int)what, (int)status);
    return status || bytes > ROOM ? 0 : bytes;
}

static sp_arena room_for(int k, size_t bytes)
{
    sp_arena a = arena(k);
    a.capacity = bytes;
    return a;
}

static void all_finite(const sp_real *x, int32_t n, const char *what)
{
    for (int32_t k = 0; k < n; k++) HOLDS(isfinite(x[k]), "%s[%d]", what, (int)k);
}

static double draw_real(double low, double high) { return low + (high - low) * draw(1u << 30) / (double)(1u << 30); }

/* ------------------------------------------------------------------------------------------------------------- counts */

/* Invariants that every scene is asked (or one in three of them: `some`), then questions of which it is asked a few. */
typedef enum question {
    IN_ORDER, TURNED, IN_UNITS, FULL, FRICTION, HELD, CONTACT, INVARIANTS,
    RESULTANTS = INVARIANTS, MOVES, FORGED, LESS_MEMORY, PYRAMID, COUPLED, BUDGET, STAGES, LIMIT, NEAR_LIMIT, SLIDING, STRONG,
    ORDER_OF_BUILD, FILL, HOLD, SUGGEST, PLAN, CONTACTS, MATRIX, PLACING, RESTING, QUESTIONS
} question;

static const char *const question_name[QUESTIONS] = {
    "another order", "turned and moved", "other units", "with all effects", "more or less friction", "one more or less held",
    "one contact more or less", "resultants", "motions of joints", "forged evidence", "less memory", "a pyramid", "coupled",
    "a budget", "other stages", "limit", "near the limit", "sliding", "strong", "block by block", "some blocks at once",
    "what to hold", "what comes next", "plan", "contacts", "matrices", "placing", "resting faces"
};
static uint64_t count[QUESTIONS], verdicts[3], unequal, near_limit, refused;

static void asked(question q) { count[q]++; }

/* At the end: how often each was asked; verdicts by default settings, of scenes as they are and written otherwise. */
static void told(void)
{
    for (int q = 0; q < QUESTIONS; q++)
        fprintf(stderr, "%-9s %9llu  %s\n", q < INVARIANTS ? "invariant" : "question", (unsigned long long)count[q],
                question_name[q]);
    fprintf(stderr, "verdicts  %9llu stable, %llu unstable, %llu undecided; %llu in one way only, %llu within tol of a limit, "
            "%llu refused\n", (unsigned long long)verdicts[SP_STABLE], (unsigned long long)verdicts[SP_UNSTABLE],
            (unsigned long long)verdicts[SP_UNDECIDED], (unsigned long long)unequal, (unsigned long long)near_limit,
            (unsigned long long)refused);
}

static int some;                                        /* FUZZ_SOME: of a scene a part of it is asked, to see more scenes */

static void tell_at_end(void)
{
    static int once;
    if (!once) { atexit(told); some = getenv("FUZZ_SOME") != NULL; }
    once = 1;
}

/* ------------------------------------------------------------------------------------------------------------- a check */

static int opposite(sp_verdict a, sp_verdict b) { return a + b == SP_STABLE + SP_UNSTABLE && a && b; }

/* The evidence of a result proves its verdict. */
static void evidence(const sp_scene *s, const sp_settings *set, const sp_result *r)
{
    sp_evidence e;
    sp_settings same = *set;
    const size_t bytes = bytes_of(s, SP_FOR_VERIFY, NULL);
    HOLDS(bytes > 0, "memory of verify");
    same.tol = r->tol;
    same.force_bound = r->force_bound;
    const sp_status status = sp_verify(s, &same, r, room_for(SCRATCH, bytes), &e);
    HOLDS(status == SP_OK, "verify: status %d", (int)status);
    if (r->verdict) HOLDS(e.verdict == r->verdict, "check %d, verify %d, imbalance %g, least %g", (int)r->verdict,
                          (int)e.verdict, (double)e.imbalance, (double)e.least_imbalance);
    HOLDS(e.least_imbalance <= e.imbalance * (sp_real)(1 + 1e-9), "proved to leave %g, leaves %g", (double)e.least_imbalance,
          (double)e.imbalance);
    if (r->final) HOLDS(e.final, "final");
    if (r->level == SP_COUPLED) HOLDS(e.level == SP_COUPLED, "residual %g", (double)e.residual);
}

/* Does a check of these settings take all that sp_memory tells? Not where a gate decides, or something ends it early. */
static int takes_all(const sp_settings *set, const sp_result *r)
{
    if (set->budget || set->coupled.asked || set->stage_count != 2 || r->stage != SP_STAGE_EXACT) return 0;
    for (int32_t k = 0; r->islands.each && k < r->islands.count; k++) if (r->islands.each[k].stage != SP_STAGE_EXACT) return 0;
    return r->spent.total.factorisations > 0;
}

static void numbers(const sp_scene *s, const sp_result *r)
{
    all_finite(r->f, 3 * s->count.points, "f");
    all_finite(r->dq, 6 * s->count.blocks, "dq");
    const sp_real number[6] = { r->imbalance, r->least_imbalance, r->extremes.compression, r->extremes.tension,
                                r->extremes.utilisation, r->coupled.residual };
    for (int q = 0; q < 6; q++) HOLDS(!isnan(number[q]), "number %d", q);
    HOLDS(r->verified == (r->verdict != SP_UNDECIDED), "verified %d", (int)r->verified);
}

/* In arena k, of `bytes`.     returns 0: refused, r->f is NULL then */
static int check_in(const sp_scene *s, const sp_settings *set, int k, size_t bytes, sp_result *r)
{
    sp_arena a = room_for(k, bytes);
    memset(r, 0, sizeof *r);
    const sp_status status = sp_check(s, set, &a, r);
    HOLDS(status == SP_OK || status == SP_E_UNSUPPORTED || status == SP_E_NOT_FINITE, "check: status %d", (int)status);
    if (status) { r->verdict = SP_UNDECIDED; r->f = NULL; return 0; }
    numbers(s, r);
    return 1;
}

/* In the memory that it says it takes, its evidence verified.     returns its verdict; r->f is NULL where it was not asked */
static sp_verdict check(const sp_scene *s, const sp_settings *set, int k, sp_result *r)
{
    const size_t bytes = bytes_of(s, SP_FOR_CHECK, set);
    memset(r, 0, sizeof *r);
    if (!bytes || !check_in(s, set, k, bytes, r)) return SP_UNDECIDED;          /* a proof's room may be large */
    HOLDS(r->spent.peak_bytes <= bytes, "%zu of %zu bytes", r->spent.peak_bytes, bytes);
    if (takes_all(set, r)) HOLDS(r->spent.peak_bytes == bytes, "%zu of %zu bytes", r->spent.peak_bytes, bytes);
    evidence(s, set, r);
    return r->verdict;
}

/* With default settings, counted; every fourth as carefully as the scene itself. */
static sp_verdict check_other(const sp_scene *s, sp_result *r)
{
    const sp_settings set = sp_settings_default();
    if (!draw(4)) check(s, &set, CHECK_OTHER, r);
    else check_in(s, &set, CHECK_OTHER, ROOM, r);
    if (r->f) verdicts[r->verdict]++;
    return r->verdict;
}

/* What falls is within tol of its limit where it is proved to fall by no more than what forces may be out by. */
static int within_tol(const sp_result *r) { return r->verdict == SP_UNSTABLE && r->least_imbalance <= 2 * r->tol; }

/* Of two that may not be opposite, the one that falls may be within tol of its limit. */
static void not_opposite(const sp_result *a, const sp_result *b, const char *what)
{
    if (!opposite(a->verdict, b->verdict)) return;
    const sp_result *falls = a->verdict == SP_UNSTABLE ? a : b;
    HOLDS(within_tol(falls), "%s: %d, then %d; proved to fall by %g, tol %g", what, (int)a->verdict, (int)b->verdict,
          (double)falls->least_imbalance, (double)falls->tol);
    near_limit++;
}

/* The same question twice: both are decided alike, or one is undecided, which is counted. */
static void same(const sp_result *a, const sp_result *b, const char *what)
{
    not_opposite(a, b, what);
    if (a->verdict != b->verdict && !opposite(a->verdict, b->verdict)) unequal++;
}

#endif
