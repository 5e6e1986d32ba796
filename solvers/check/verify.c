/* verify: sp_verify: the certificate check of a stored result, its forces, motion, triple or proof, from the scene alone. */
#ifndef SP__CHECK_VERIFY_C
#define SP__CHECK_VERIFY_C

#include "memory.c"

#if SP__WITH_COUPLED
/* Tables of islands, the problem of one, and what judges it; `hint`: its share of y0. */
typedef struct sp__island_claim { sp__islands t; sp_problem pb; sp__certifier j; sp_real *hint; } sp__island_claim;

/* Bytes of that, at most: what is refuted has few vertices and blocks. */
SP__NOINLINE static size_t sp__verify_island_need(const sp_scene *scene, const sp_settings *set)
{
    sp_problem pb;
    sp__islands t;
    const int32_t few = SP_EXACT_POINTS;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &pb);
    if (pb.blocks > few) pb.blocks = few;
    if (pb.contacts > few) pb.contacts = few;
    if (pb.points > few) pb.points = few;
    sp__take(&dry, 1, sizeof(sp__island_claim));
    sp__islands_carve(&t, scene, scene->count.blocks, NULL, &dry);
    sp__part_carve(&pb, sp__scene_live(scene), &dry);
    sp__take(&dry, (size_t)pb.blocks, 12 * sizeof(sp_real));
    sp__take(&dry, 1, sp__certifier_need(&pb, set));
    sp__take(&dry, 1, sp__refute_need(pb.points, pb.blocks));
    return dry.used;
}

/* The share of y0 that an island's blocks have. */
static void sp__island_hint(const sp__island_claim *p, const sp_scene *scene, const sp_real *y0)
{
    const size_t b = (size_t)p->pb.blocks;
    size_t all = 0;
    for (int32_t i = 0; i < scene->count.blocks; i++) all += p->t.rank[i] >= 0;
    for (size_t i = 0; i < b; i++)
        for (size_t half = 0; half < 2; half++)
            memcpy(p->hint + 6 * (half * b + i), y0 + 6 * (half * all + (size_t)p->t.rank[p->pb.block[i]]),
                   6 * sizeof *p->hint);
}

/* The margin of a proof against what j judges; 0: it proves nothing.     returns SP_E_MEMORY: it does not fit */
SP__NOINLINE static sp_status sp__verify_refutation(sp__certifier *j, const sp__lengths *k, const sp_proof *proof, sp_arena a,
                                                    sp_real *margin)
{
    const int32_t points = sp__problem_points(j->pb);
    sp_arena whole = a;
    if (points <= SP_EXACT_POINTS && !sp__take(&whole, 1, sp__refute_need(points, j->pb->blocks))) return SP_E_MEMORY;
    *margin = sp__certify_refutation(j, k, proof, &a);
    return SP_OK;
}

/* The margin of a proof that refutes an island, judged on that alone; 0: none.     returns SP_E_MEMORY, SP_E_NOT_FINITE */
SP__NOINLINE static sp_status sp__verify_island(const sp_scene *scene, const sp_settings *set, const sp__lengths *k,
                                             const sp_result *claim, sp_arena a, sp_real *margin)
{
    sp__island_claim *p = sp__take(&a, 1, sizeof *p);
    if (!p) return SP_E_MEMORY;
    sp__islands_carve(&p->t, scene, scene->count.blocks, NULL, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    const int32_t count = sp__islands_join(scene, p->t.row);
    const int32_t island = claim->coupled.proof.island;
    if (island < 1 || island > count) return SP_OK;
    sp__islands_fill(scene, &p->t);
    const sp__part part = sp__islands_part(&p->t, island - 1);
    sp__part_count(scene, &part, &p->pb);
    if (p->pb.points > SP_EXACT_POINTS || p->pb.blocks > SP_EXACT_POINTS) return SP_OK;
    const sp_status status = sp__part_build(scene, &part, &a, &p->pb);
    if (status) return status;
    p->hint = sp__take(&a, (size_t)p->pb.blocks, 12 * sizeof *p->hint);
    if (!p->hint) return SP_E_MEMORY;
    if (claim->y0) sp__island_hint(p, scene, claim->y0);
    if (!sp__certifier_open(&p->j, &p->pb, set, claim->y0 ? p->hint : NULL, INT32_MAX, &a)) return SP_E_MEMORY;
    return sp__verify_refutation(&p->j, k, &claim->coupled.proof, a, margin);
}

/* The triple of a coupled check, and a proof that there is none.     returns SP_E_MEMORY, SP_E_NOT_FINITE */
SP__NOINLINE static sp_status sp__verify_coupled(const sp_scene *scene, sp__check *c, sp__certifier *j, const sp_result *claim,
                                                 sp_real *dq, sp_arena scratch, sp_arena room, sp_evidence *e)
{
    sp_status status = SP_OK;
    if (c->set.coupled.asked && claim->coupled.dq && claim->coupled.alpha) {
        const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
        sp__motion_read(&c->pb, claim->coupled.dq, dq);
        e->residual = sp__certify_coupled(j, &k, claim->f, dq, claim->coupled.alpha);
        if (e->level && e->residual <= 1) e->level = SP_COUPLED;
    }
    if (c->set.coupled.asked && claim->coupled.proof.nodes > 0) {
        const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
        if (!claim->coupled.proof.island) status = sp__verify_refutation(j, &k, &claim->coupled.proof, scratch, &e->margin);
        else status = sp__verify_island(scene, &c->set, &k, claim, room, &e->margin);
        if (status) return status;
        if (e->margin > 0) { e->verdict = SP_UNSTABLE; e->level = SP_NONE; }
    }
    return SP_OK;
}

/* Bytes of a proof of the whole scene; 0: it is too large for one. */
static size_t sp__verify_proof_need(const sp_scene *scene, const sp_problem *pb)
{
    const int32_t points = sp__points_count(scene);
    return points <= SP_EXACT_POINTS ? sp__refute_need(points, pb->blocks) : 0;
}
#else
static size_t sp__verify_island_need(const sp_scene *scene, const sp_settings *set) { return (void)scene, (void)set, 0; }
static size_t sp__verify_proof_need(const sp_scene *scene, const sp_problem *pb) { return (void)scene, (void)pb, 0; }
static sp_status sp__verify_coupled(const sp_scene *scene, sp__check *c, sp__certifier *j, const sp_result *claim, sp_real *dq,
                                    sp_arena scratch, sp_arena room, sp_evidence *e)
{
    return (void)scene, (void)c, (void)j, (void)claim, (void)dq, (void)scratch, (void)room, (void)e, SP_OK;
}
#endif

SP__NOINLINE static size_t sp__verify_memory(const sp_scene *scene)
{
    sp_problem pb;
    sp_settings set = sp_settings_default();
    set.faces = 64;
    sp__problem_count(scene, &pb);
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof(sp__check));
    sp_arena part = dry;
    sp__take(&part, 1, sp__verify_island_need(scene, &set));
    sp__take(&dry, 1, sp__problem_memory(scene));
    sp__take(&dry, (size_t)pb.blocks, 6 * sizeof(sp_real));
    sp__take(&dry, 1, sp__certifier_need(&pb, &set));
    const size_t proof = sp__verify_proof_need(scene, &pb);
    if (proof) sp__take(&dry, 1, proof);
    return part.used > dry.used ? part.used : dry.used;
}

SP_API sp_status sp_verify(const sp_scene *scene, const sp_settings *settings, const sp_result *claim, sp_arena scratch,
                           sp_evidence *evidence)
{
    if (!scene || !claim || !claim->f || !claim->dq || !evidence || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    if (!sp__all_finite(claim->f, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->dq, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    const int triple = settings && settings->coupled.asked && claim->coupled.dq && claim->coupled.alpha;
    if (triple && !sp__all_finite(claim->coupled.dq, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    if (triple && !sp__all_finite(claim->coupled.alpha, (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    sp__check *c = sp__take(&scratch, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    const sp_arena room = scratch;
    sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (!status) status = sp_problem_build(scene, &scratch, &c->pb);
    if (status) return status;
    c->set.force_bound = sp__max(c->set.force_bound, SP__FORCES_LEAST);     /* what stands may take as much */
    sp__certifier j;
    sp_real *dq = sp__take(&scratch, (size_t)c->pb.blocks, 6 * sizeof *dq);
    if (sp__failed(&scratch) || !sp__certifier_open(&j, &c->pb, &c->set, claim->y0, INT32_MAX, &scratch)) return SP_E_MEMORY;
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
    sp__motion_read(&c->pb, claim->dq, dq);
    e.imbalance = sp__certify_forces(&j, claim->f, NULL);
    e.least_imbalance = sp__certify_mechanism(&j, dq, SP__READ, &e.final);
    if (e.imbalance <= c->set.tol) e.verdict = SP_STABLE;
    else if (e.least_imbalance > c->set.tol || (SP__WITH_LARGE && e.final)) e.verdict = SP_UNSTABLE;
    if (e.verdict != SP_UNSTABLE) e.final = 0;
    if (e.verdict == SP_STABLE) e.level = SP_ADMISSIBLE;
    if (SP__WITH_COUPLED) status = sp__verify_coupled(scene, c, &j, claim, dq, scratch, room, &e);
    if (status) return status;
    *evidence = e;
    return SP_OK;
}

#endif /* SP__CHECK_VERIFY_C */
