/* plan: sp_plan: which effects a scene calls for, why, and the unknowns and flops that leaving out the others saves. */
#ifndef SP__CHECK_PLAN_C
#define SP__CHECK_PLAN_C

#include "../coupled/forest.c"
#include "memory.c"

#if SP__WITH_LARGE && SP__WITH_PLAN
/* Work of the full simulation of a problem: 6 rows a block, 3 forces a vertex; and in flops SP__PLAN_STEPS Newton steps,
 * each an assembly, a factor, SP__PLAN_SWEEPS passes over the contacts and a solve. Steps are a guess (3 to 5 for a wall, more
 * near a limit), what a step costs is known. */
#define SP__PLAN_STEPS 5
#define SP__PLAN_SWEEPS 4
#define SP__PLAN_SEARCH 12              /* steps of a coupled check's search where it is an easy one */

typedef struct sp__work {
    int64_t unknowns, flops;            /* of all rows and forces */
    int64_t less[2], fewer[2];          /* flops and unknowns that each sp__mode saves */
    int32_t problems, reduced[2];       /* how many problems, how many of them a reduction is planned for */
    int32_t forests;                    /* forests, which the coupled check answers without a search */
    int64_t search;                     /* flops of such searches */
} sp__work;

/* Is the coupled check asked, and are its joints a forest, for which no motion is searched? */
#if SP__WITH_COUPLED
static int sp__plan_forest(const sp_problem *pb, const sp_settings *set, sp_arena a)
{
    sp__forest g;
    return set->coupled.asked && sp__forest_allowed(set) && sp__forest_of(pb, &g, &a);
}
#else
static int sp__plan_forest(const sp_problem *pb, const sp_settings *set, sp_arena a) { return (void)pb, (void)set, (void)a, 0; }
#endif

/* Work that a reduction saves, a planar one with corners in pairs, a level one with a first guess that is mostly right. */
static void sp__plan_reduced(const sp_problem *pb, const sp__reduction *f, int64_t full, int64_t factor, sp__work *o)
{
    const int plane = f->mode == SP__PLANE;
    const int64_t v = pb->points / (1 + plane), sides = 2 * (int64_t)pb->contacts;
    const int64_t assembly = SP__FLOPS_REDUCED_HESSIAN(f) * v + SP__FLOPS_REDUCED_BLOCKS * sides;
    const int64_t sweep = SP__FLOPS_REDUCED_SWEEP(f) * v + SP__FLOPS_REDUCED_TWIST * sides;
    o->less[f->mode] += full - (plane ? SP__PLAN_STEPS : 2) * (assembly + factor / 8 + SP__PLAN_SWEEPS * sweep);
    o->fewer[f->mode] += 3 * (int64_t)pb->blocks + 2 * (int64_t)pb->points;
    o->reduced[f->mode]++;
}

/* Adds the work of a problem. */
SP__NOINLINE static sp_status sp__plan_problem(const sp_problem *pb, const sp_settings *set, sp_arena scratch, sp__work *o)
{
    const int forest = sp__plan_forest(pb, set, scratch);
    sp__system *w = sp__take(&scratch, 1, sizeof *w);
    const int32_t blocks = w ? sp__system_analyse(w, pb, &scratch) : -1;
    if (blocks < 0) return SP_E_MEMORY;
    const int64_t v = sp__problem_points(pb), c = pb->contacts, b = pb->blocks;
    const int64_t sweep = SP__FLOPS_SWEEP * v + SP__FLOPS_TWIST * c, assembly = SP__FLOPS_HESSIAN * v + SP__FLOPS_BLOCKS * c;
    const int64_t full = SP__PLAN_STEPS * (assembly + w->L.flops + SP__PLAN_SWEEPS * sweep + 144 * (int64_t)blocks + 72 * b);
    sp__reduction *reduction = sp__take(&scratch, 1, sizeof *reduction);
    if (!reduction) return SP_E_MEMORY;
    o->unknowns += 6 * b + 3 * v;
    o->flops += full;
    o->problems++;
    o->forests += forest;
    o->search += SP__PLAN_SEARCH * (assembly + w->L.flops + SP__PLAN_SWEEPS * sweep);
    if (sp__reduction_choose(pb, set, reduction)) sp__plan_reduced(pb, reduction, full, w->L.flops, o);
    return SP_OK;
}

/* The work of a scene as one problem. */
SP__NOINLINE static sp_status sp__plan_whole(const sp_scene *scene, const sp_settings *set, sp_arena scratch, sp__work *o)
{
    sp_problem pb;
    const sp_status status = sp_problem_build(scene, &scratch, &pb);
    return status ? status : sp__plan_problem(&pb, set, scratch, o);
}

/* The work of a scene, island by island. */
SP__NOINLINE static sp_status sp__plan_islands(const sp_scene *scene, int32_t count, const sp_settings *set, sp_arena scratch,
                                             sp__work *o)
{
    sp__islands t;
    sp_problem pb;
    sp_status status = SP_OK;
    sp__islands_carve(&t, scene, count, NULL, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__islands_fill(scene, &t);
    for (int32_t k = 0; k < count && !status; k++) {
        sp_arena a = scratch;
        const sp__part part = sp__islands_part(&t, k);
        status = sp__part_build(scene, &part, &a, &pb);
        if (!status) status = sp__plan_problem(&pb, set, a, o);
    }
    return status;
}

/* Memory of a plan, in the arena. */
typedef struct sp__planner {
    sp_settings set;
    sp_outlook o;
    sp__work whole, planned;
} sp__planner;

/* Every effect in words, and what leaving it out saves. */
static void sp__plan_effects(const sp_scene *scene, sp__planner *p)
{
    sp_outlook *o = &p->o;
    for (int32_t k = 0; k < SP_EFFECTS; k++)
        o->effect[k].why = sp__effect_why(&p->set, (sp_effect)k, sp__effect_present(scene, &p->set, o->islands, (sp_effect)k));
    const sp__work *w = &p->planned;
    o->effect[SP_EFFECT_TOGETHER].flops = p->whole.flops - w->flops;
    o->effect[SP_EFFECT_TOGETHER].bytes = (int64_t)o->full_bytes - (int64_t)o->bytes;
    o->full_unknowns = p->whole.unknowns;
    o->full_flops = p->whole.flops;
    o->unknowns = w->unknowns;
    o->flops = w->flops;
    for (int mode = 0; mode < 2; mode++) {
        sp_planned *e = &o->effect[mode == SP__PLANE ? SP_EFFECT_DEPTH : SP_EFFECT_FRICTION];
        e->flops = w->less[mode];
        e->unknowns = w->fewer[mode];
        if (w->reduced[mode] == w->problems && w->problems) e->why = mode == SP__PLANE ? SP_WHY_MIRROR : SP_WHY_PRESSURE;
    }
    if (w->forests == w->problems && w->problems) {
        o->effect[SP_EFFECT_COUPLED].why = SP_WHY_FOREST;
        o->effect[SP_EFFECT_COUPLED].flops = w->search;
        o->full_flops += w->search;
    }
    o->flops -= w->less[SP__PLANE] + w->less[SP__LEVEL_JOINTS];
    o->unknowns -= w->fewer[SP__PLANE] + w->fewer[SP__LEVEL_JOINTS];
}

SP__NOINLINE static size_t sp__plan_memory(const sp_scene *scene, const sp_settings *settings)
{
    const size_t need = sp__check_scratch(scene, settings);
    return need ? need + sizeof(sp__planner) + sizeof(sp__system) + 2 * SP_ALIGN : 0;
}

/* Needs and work as planned, then with all blocks together. */
SP__NOINLINE static sp_status sp__plan_run(const sp_scene *scene, sp__planner *p, sp_arena scratch)
{
    const sp_choice together = p->set.effect[SP_EFFECT_TOGETHER];
    sp_status status = sp__memory(scene, &p->set, NULL, scratch, &p->o.bytes);
    sp__island_counts counts = { 1, 0, 0 };
    if (!status) status = sp__islands_count(scene, &p->set, scratch, &counts);
    p->o.islands = counts.blocks > 0 || counts.islands > 1 ? counts.islands : 0;
    if (!status && p->o.islands > 1) status = sp__plan_islands(scene, p->o.islands, &p->set, scratch, &p->planned);
    p->set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
    if (!status) status = sp__memory(scene, &p->set, NULL, scratch, &p->o.full_bytes);
    if (!status) status = sp__plan_whole(scene, &p->set, scratch, &p->whole);
    p->set.effect[SP_EFFECT_TOGETHER] = together;
    if (p->o.islands < 2) p->planned = p->whole;
    return status;
}

SP_API sp_status sp_plan(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, sp_outlook *out)
{
    if (!scene || !scratch.base || !out) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__planner *p = sp__take(&scratch, 1, sizeof *p);
    if (!p) return SP_E_MEMORY;
    memset(p, 0, sizeof *p);
    sp_status status = sp__settings_resolve(scene, settings, &p->set);
    p->set.work = NULL;
    if (!status) status = sp__plan_run(scene, p, scratch);
    if (status) return status;
    sp__plan_effects(scene, p);
    *out = p->o;
    return SP_OK;
}

#elif SP__WITH_LARGE

static size_t sp__plan_memory(const sp_scene *scene, const sp_settings *settings) { return (void)scene, (void)settings, 0; }

#endif

#endif /* SP__CHECK_PLAN_C */
