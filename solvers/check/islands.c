/* islands: a scene whose blocks fall into several islands: each is checked by itself, then the verdicts become one.
 *
 *   imbalance = max over islands;  verdict: UNSTABLE if one falls, else UNDECIDED if one is, else STABLE
 */
#ifndef SP__CHECK_ISLANDS_C
#define SP__CHECK_ISLANDS_C

#include "one.c"

#if SP__WITH_LARGE

/* Share of tol up to which the imbalances of islands stand for that of the whole, in spite of rounding. */
#define SP__ISLANDS_ENOUGH ((sp_real)(sizeof(sp_real) == 4 ? 0.9 : 0.999))

#if SP__WITH_COUPLED
/* Numbers of an island's coupled check into those of the whole.
 * Where it is coupled its forces take the place of the penalty form. */
SP__NOINLINE static void sp__island_coupled(int32_t k, const sp__check *found, sp__check *c)
{
    const sp_coupled *from = &found->r.coupled;
    sp_coupled *out = &c->r.coupled;
    for (int32_t q = 0; q < found->pb.contacts && out->penalty && from->verdict == SP_COUPLING_COUPLED; q++) {
        const sp_joint *f = found->pb.contact[q].joint;
        for (size_t v = (size_t)f->point; v < (size_t)f->point + (size_t)f->points; v++)
            for (size_t i = 0; i < 3; i++) out->penalty[4 * v + i + (i > 0)] = c->r.f[3 * v + i];
    }
    out->eps = from->eps;
    out->eta = from->eta;
    out->residual = sp__max(out->residual, from->residual);
    out->rounds += from->rounds;
    if (from->verdict != SP_COUPLING_COUPLED && out->tension_ratio > -2)               /* -2: of one there is none */
        out->tension_ratio = from->tension_ratio < 0 ? (sp_real)-2 : sp__max(out->tension_ratio, from->tension_ratio);
    sp__cost_add(&out->cost, &from->cost);
    c->r.islands.each[k].coupling = from->verdict;
    c->r.islands.each[k].coupling_reason = from->reason;
}
#else
static void sp__island_coupled(int32_t k, const sp__check *found, sp__check *c) { (void)k; (void)found; (void)c; }
#endif

/* y0 of an island at its rows among all free blocks, the large half and the small. */
static void sp__island_potential(const int32_t *rank, const sp__check *found, sp__check *c)
{
    const size_t b = (size_t)found->pb.blocks, all = (size_t)c->pb.blocks;
    for (size_t i = 0; i < b; i++)
        for (size_t half = 0; half < 2; half++)
            memcpy(c->r.y0 + 6 * (half * all + (size_t)rank[found->pb.block[i]]), found->state.y0 + 6 * (half * b + i),
                   6 * sizeof *c->r.y0);
    c->state.has_y0 |= found->state.has_y0;
}

/* An island that stands has no motion. */
static void sp__island_clear_motion(const sp__check *found)
{
    for (int32_t i = 0; i < found->pb.blocks && found->r.verdict == SP_STABLE; i++)
        memset(found->r.dq + 6 * (size_t)found->pb.block[i], 0, 6 * sizeof *found->r.dq);
}

/* Add the result of island k to that of the whole; forces and motion are in its arrays already. */
SP__NOINLINE static void sp__island_add(const int32_t *rank, int32_t k, const sp__check *found, sp__check *c)
{
    const sp_result *from = &found->r;
    sp_result *r = &c->r;
    sp__island_potential(rank, found, c);
    r->imbalance = sp__max(r->imbalance, from->imbalance);
    sp__cost_add(&r->spent.total, &from->spent.total);
    for (int32_t q = 0; q < c->set.stage_count; q++) sp__cost_add(&r->spent.by_stage[q], &from->spent.by_stage[q]);
    for (int q = 0; q < SP_EFFECTS; q++)
        if (k == 0 || r->effect[q] != from->effect[q]) r->effect[q] = k ? SP_WHY_CALLED : from->effect[q];
    memset(&r->islands.each[k], 0, sizeof r->islands.each[k]);
    r->islands.each[k].block = found->pb.block[0];
    r->islands.each[k].blocks = found->pb.blocks;
    r->islands.each[k].verdict = from->verdict;
    r->islands.each[k].reason = from->reason;
    r->islands.each[k].stage = from->stage;
    if (from->reason == SP_REASON_EFFECT) r->missing = from->missing;
    if (SP__WITH_COUPLED && c->set.coupled.asked) sp__island_coupled(k, found, c);
}

/* The island whose verdict is that of all: the first that falls, else the first undecided, else the first with forces. */
static int32_t sp__islands_worst(const sp_result *r)
{
    int32_t worst = 0;
    for (int32_t k = 1; k < r->islands.count; k++) {
        const sp_verdict a = r->islands.each[worst].verdict, b = r->islands.each[k].verdict;
        if (a == SP_UNSTABLE || (a == SP_UNDECIDED && b != SP_UNSTABLE)) continue;
        if (b != SP_STABLE || r->islands.each[worst].reason == SP_REASON_NOTHING) worst = k;
    }
    return worst;
}

#if SP__WITH_COUPLED
/* The coupled check of the whole from those of all islands; r->verdict is that of statics. Where all are coupled the triple is
 * checked once more on the whole. */
SP__NOINLINE static sp_status sp__islands_couple(sp__check *c, sp_arena *a)
{
    sp_result *r = &c->r;
    sp_coupled *out = &r->coupled;
    int32_t open = -1;
    if (out->tension_ratio < 0) out->tension_ratio = -1;
    if (r->verdict == SP_UNSTABLE) {                    /* statics refute: what was proved of an island is not asked for */
        out->proof.nodes = out->proof.leaves = out->proof.entries = out->proof.island = 0;
        out->margin = 0;
    }
    const int refuted = out->proof.nodes > 0;
    for (int32_t k = r->islands.count - 1; k >= 0; k--)
        if (r->islands.each[k].coupling == SP_COUPLING_NOT_FOUND
            && r->islands.each[k].coupling_reason != SP_COUPLING_STATICS) open = k;
    out->verdict = r->verdict == SP_UNSTABLE || refuted ? SP_COUPLING_REFUTED : SP_COUPLING_NOT_FOUND;
    out->reason = refuted ? SP_COUPLING_NO_MOTION : r->verdict != SP_STABLE ? SP_COUPLING_STATICS
                : open >= 0 ? r->islands.each[open].coupling_reason : SP_COUPLING_LIMIT;
    if (refuted || open >= 0 || r->verdict != SP_STABLE) return SP_OK;
    sp__certifier j;
    const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
    if (!sp__certifier_open(&j, &c->pb, &c->set, c->state.has_y0 ? r->y0 : NULL, INT32_MAX, a)) return SP_E_MEMORY;
    sp__motion_read(&c->pb, out->dq, c->state.y);
    r->imbalance = sp__certify_forces(&j, r->f, r->f);
    out->residual = sp__certify_coupled(&j, &k, r->f, c->state.y, out->alpha);
    const sp_cost cost = { SP__FLOPS_CERTIFICATE * (int64_t)j.sweeps * c->pb.points, 0, 0, 0 };
    sp__cost_add(&out->cost, &cost);
    sp__cost_add(&r->spent.total, &cost);
    if (r->imbalance > r->tol || out->residual > 1) return SP_OK;
    out->verdict = SP_COUPLING_COUPLED;
    out->reason = SP_COUPLING_MOTION;
    return SP_OK;
}
#else
static sp_status sp__islands_couple(sp__check *c, sp_arena *a) { return (void)c, (void)a, SP_OK; }
#endif

/* One verdict of all islands. Where all stand by imbalances up to SP__ISLANDS_ENOUGH tol, each checked by itself, that is the
 * verdict: no force passes between them. Else the evidence of all is checked on the whole scene. */
SP__NOINLINE static sp_status sp__islands_certify(const sp_scene *scene, const sp__island_loop *w, sp__check *c, sp_arena *a)
{
    sp_result *r = &c->r;
    const int32_t *label = w->t.label;
    if (w->proof.nodes) r->coupled.proof = w->proof;
    r->coupled.margin = w->margin;
    const sp_island *worst = &r->islands.each[sp__islands_worst(r)];
    for (int32_t i = 0; i < scene->count.blocks; i++)   /* only the motion of islands that gave the verdict */
        if (label[i] >= 0 && r->islands.each[label[i]].verdict != worst->verdict)
            memset(r->dq + 6 * (size_t)i, 0, 6 * sizeof *r->dq);
    a->used = w->start;                                                 /* the tables are no longer needed */
    sp_status status = sp__check_problem(c, a);
    const size_t mark = a->used;
    if (!status) sp__motion_read(&c->pb, r->dq, c->state.dq);
    if (!status && !sp__take(a, 1, sp__certifier_need(&c->pb, &c->set))) status = SP_E_MEMORY;
    a->used = mark;
    if (worst->verdict == SP_STABLE && r->imbalance <= SP__ISLANDS_ENOUGH * r->tol)
        r->verdict = SP_STABLE;                                         /* every block has been checked, with its island */
    else if (!status)
        status = sp__check_evidence(&c->pb, &c->set, INT32_MAX, worst->verdict, &c->state, a, r);
    if (status) return status;
    sp__cost_add(&r->spent.total, &c->state.cost);
    sp__cost_add(&r->spent.by_stage[c->set.stage_count - 1], &c->state.cost);
    r->verified = r->verdict != SP_UNDECIDED;
    r->stage = r->verified ? worst->stage : SP_STAGE_NONE;
    r->reason = r->verdict == worst->verdict ? worst->reason : SP_REASON_LIMIT;
    if (r->verdict == SP_STABLE) memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    if (SP__WITH_COUPLED && c->set.coupled.asked) status = sp__islands_couple(c, a);
    return status;
}

#if SP__WITH_COUPLED
/* eps and eta of the whole, for its islands. */
SP__NOINLINE static sp_status sp__islands_lengths(const sp_scene *scene, sp_coupled_settings *cs, const sp_settings *set,
                                                  sp_arena a)
{
    sp_problem pb;
    const sp_status status = sp_problem_build(scene, &a, &pb);
    if (status) return status;
    const sp__lengths k = sp__coupled_lengths(&pb, set);
    if (cs->eps < 0) cs->eps = k.eps > 0 ? k.L : 0;
    if (!(k.eps > 0)) cs->eta = k.L;
    return SP_OK;
}
#else
static sp_status sp__islands_lengths(const sp_scene *scene, sp_coupled_settings *cs, const sp_settings *set, sp_arena a)
{
    return (void)scene, (void)cs, (void)set, (void)a, SP_OK;
}
#endif

/* The loop over all islands, in the arena. */
SP__NOINLINE static sp_status sp__island_loop_begin(const sp_scene *scene, sp__check *c, sp_arena *a, sp__island_loop **walk)
{
    const size_t start = a->used;
    sp_status status = SP_OK;
    if (SP__WITH_COUPLED && c->set.coupled.asked) status = sp__islands_lengths(scene, &c->set.coupled, &c->set, *a);
    sp__island_loop *w = sp__take(a, 1, sizeof *w);
    if (status || !w) return status ? status : SP_E_MEMORY;
    memset(w, 0, sizeof *w);
    sp__islands_carve(&w->t, scene, c->r.islands.count, c->r.islands.of, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    sp__islands_fill(scene, &w->t);
    w->start = start;
    w->mark = a->used;
    *walk = w;
    return SP_OK;
}

/* Is there an island left? A proof that a later search overwrote is sought once more, after the last island. */
static int sp__island_loop_continues(const sp__island_loop *w, const sp__check *c, int32_t k)
{
    return k < c->r.islands.count + (w->proof.nodes && !w->proof_kept);
}

/* An island writes into the arrays of the whole, and a proof into the room that has. */
static void sp__island_results(const sp_result *whole, sp_result *r)
{
    r->f = whole->f;
    r->dq = whole->dq;
    r->demand = whole->demand;
    r->coupled.dq = whole->coupled.dq;
    r->coupled.alpha = whole->coupled.alpha;
    r->coupled.penalty = whole->coupled.penalty;
    r->coupled.proof = whole->coupled.proof;
}

/* A check of the k-th island. A proof goes into the room the whole has for it. */
SP__NOINLINE static sp_status sp__island_loop_open(const sp_scene *scene, sp__island_loop *w, int32_t k, const sp__check *c,
                                                   sp_arena *a, sp__check **found)
{
    w->at = k < c->r.islands.count ? k : w->proof.island - 1;
    w->again = k == c->r.islands.count;
    const sp__part part = sp__islands_part(&w->t, w->at);
    const sp_status status = sp__part_open(scene, &part, &c->set, a, found);
    if (!status) sp__island_results(&c->r, &(*found)->r);
    return status;
}

/* The island's result into that of the whole. */
SP__NOINLINE static void sp__island_loop_collect(sp__island_loop *w, const sp__check *found, sp__check *c, sp_arena *a)
{
    const sp_coupled *o = &found->r.coupled;
    sp__island_clear_motion(found);
    if (!w->again) sp__island_add(w->t.rank, w->at, found, c);
    else sp__cost_add(&c->r.spent.total, &found->r.spent.total);
    w->proof_kept &= !o->rounds && (o->verdict != SP_COUPLING_NOT_FOUND || o->reason == SP_COUPLING_STATICS);
    if (o->proof.nodes) {
        w->proof = o->proof;
        w->proof.island = w->at + 1;
        w->margin = o->margin;
        w->proof_kept = 1;
    }
    a->used = w->mark;
}

#endif

#endif /* SP__CHECK_ISLANDS_C */
