/* starts: is there a motion that friction does not hinder? Contact forces are sought from starts that a history might leave:
 * nothing pressed, and corners that carry the load alone before the others touch. What they settle at is judged. */
#ifndef SP__STRONG_STARTS_C
#define SP__STRONG_STARTS_C

#include "../proof/moving.c"
#include "lemke.c"

#if SP__WITH_STRONG

#define SP__STARTS_SUBSETS 8            /* corners up to which every set of them is a start */
#define SP__STARTS_SWEEPS 4096          /* of some corners alone, then of all, until nothing changes */
#define SP__STARTS_PIVOTED 16           /* that pivoting makes */
#ifdef SP_REAL_FLOAT
#define SP__STARTS_DUST ((sp_real)1e-5) /* mass times acceleration, in the block's load, that counts as none */
#else
#define SP__STARTS_DUST ((sp_real)1e-9)
#endif
#define SP__STARTS_FEW 256              /* of some of many corners */
#define SP__STARTS_FLOPS 1000000000     /* of all starts together, where there is no budget */

typedef struct sp__starts {
    sp__sweep sweep;
    sp__certifier j;
    sp__inertia *M;                     /* b */
    sp_real *arm;                       /* b */
    sp_real residual, moves;            /* of the pair judged last */
    int32_t tried;
    int32_t pivoted;                    /* starts that pivoting makes, the first of all */
    sp__lemke *lemke;                   /* where there are some: the caller's */
} sp__starts;

static void sp__starts_carve(sp__starts *s, const sp_problem *pb, sp_arena *a)
{
    sp__sweep_carve(&s->sweep, pb, a);
    s->M = sp__take(a, (size_t)pb->blocks, sizeof *s->M);
    s->sweep.M = s->M;
    s->arm = sp__take(a, (size_t)pb->blocks, sizeof *s->arm);
    sp__certifier_carve(&s->j, pb, 0, a);
}

SP__NOINLINE static size_t sp__starts_need(const sp_scene *scene)
{
    sp_problem pb;
    sp__starts s;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &pb);
    sp__starts_carve(&s, &pb, &dry);
    return dry.used;
}

/* Which corners carry in the k-th start: all; then, of a few, every set; of many, each with one chance in 2, 4 or 8. */
static void sp__starts_choose(sp__starts *s, int32_t k)
{
    const int32_t V = s->sweep.corners;
    uint32_t seed = 2463534242u + 7919u * (uint32_t)k;
    for (int32_t v = 0; v < V; v++) {
        seed = sp__random(seed);
        const uint32_t chance = 2u << (uint32_t)k % 3u, drawn = seed >> 8 & (chance - 1);
        s->sweep.on[v] = (uint8_t)(k < 2 ? 1 : V <= SP__STARTS_SUBSETS ? (k - 1) >> v & 1 : !drawn);
    }
}

/* The pair at hand, which is verified, into the result. */
static void sp__starts_write(const sp__starts *s, sp_strong_result *r)
{
    const sp_problem *pb = s->sweep.pb;
    r->kind = SP_STRONG_AMBIGUOUS;
    r->reason = SP_STRONG_MOTION;
    r->residual = s->residual;
    r->moves = s->moves;
    r->plate = s->sweep.plates;
    memcpy(r->moving, s->sweep.f, 3 * (size_t)pb->points * sizeof *r->moving);
    for (int32_t i = 0; i < pb->blocks; i++)
        memcpy(r->a + 6 * (size_t)pb->block[i], s->sweep.a + 6 * (size_t)i, 6 * sizeof *r->a);
}

/* How many starts there are: those that pivoting makes, and of the sweeps those that differ, up to `most`; 0 of 0. */
static int32_t sp__starts_count(const sp__starts *s, int32_t most)
{
    const int32_t all = s->sweep.corners <= SP__STARTS_SUBSETS ? 1 << s->sweep.corners : most;
    return most > 0 ? s->pivoted + (all < most ? all : most) : 0;
}

/* Forces of the k-th start that is not pivoted: what some corners settle at alone. */
static void sp__starts_set_out(sp__starts *s, int32_t k, sp_real fine)
{
    sp__sweep *w = &s->sweep;
    sp__starts_choose(s, k);
    memset(w->f, 0, 3 * (size_t)w->pb->points * sizeof *w->f);
    if (k > 1) sp__sweep_run(w, w->corners <= SP__STARTS_SUBSETS ? SP__STARTS_SWEEPS : SP__STARTS_FEW, k & 1, fine);
    memset(w->on, 1, (size_t)w->corners);
}

/* What is at rest but for rounding is at rest: no laws of contact are asked of a direction that rounding has. */
static void sp__starts_calm(sp__starts *s)
{
    for (int32_t i = 0; i < s->sweep.pb->blocks; i++) {
        sp_real *a = s->sweep.a + 6 * (size_t)i;
        const sp_real size = sp__norm3(a) + sp__norm3(a + 3) * s->j.scale[i].arm;
        if (sp__in_units(s->j.unit, s->M[i].mass * size) < SP__STARTS_DUST * s->j.scale[i].load) memset(a, 0, 6 * sizeof *a);
    }
}

/* The pair that the k-th start settles at.     returns 1: it moves, and is verified */
SP__NOINLINE static int sp__starts_try(sp__starts *s, int32_t k)
{
    sp__sweep *w = &s->sweep;
    const sp_real fine = 16 * (sp_real)SP_EPSILON;
    memset(w->on, 1, (size_t)w->corners);
    if (k < s->pivoted) sp__lemke_run(s->lemke, w, 2463534242u + 7919u * (uint32_t)k);
    else sp__starts_set_out(s, k - s->pivoted, fine);
    sp__sweep_run(w, SP__STARTS_SWEEPS, k & 1, fine);
    sp__starts_calm(s);
    s->residual = sp__certify_moving(&s->j, s->M, w->f, w->a, w->plates, &s->moves);
    s->tried++;
    return s->residual <= s->j.set->tol && s->moves >= SP__MOVES;
}

/* Room for pivoting, where it is for so many corners: until the next call that takes the arena. */
SP__NOINLINE static void sp__starts_pivot(sp__starts *s, sp__lemke *lemke, sp_arena a)
{
    if (!sp__lemke_allowed(s->sweep.corners)) return;
    s->pivoted = SP__STARTS_PIVOTED;
    s->lemke = lemke;
    sp__lemke_carve(lemke, s->sweep.corners, &a);
}

/* Starts, `most` of them by sweeps, within the limit of flops: the first that moves, of few corners the fastest. */
SP__NOINLINE static void sp__starts_run(sp__starts *s, int32_t most, int64_t limit, sp_strong_result *r)
{
    const int32_t count = sp__starts_count(s, most), few = s->sweep.corners <= SP__STARTS_SUBSETS;
    const int64_t before = s->sweep.flops;
    sp__sweep_begin(&s->sweep);
    for (int32_t k = 0; k < count && s->sweep.flops - before < limit; k++) {
        if (!sp__starts_try(s, k) || !(s->moves > (1 + (sp_real)1e-6) * r->moves)) continue;
        sp__starts_write(s, r);
        if (!few) return;
    }
}

#endif

#endif /* SP__STRONG_STARTS_C */
