/* open: the system of a problem made in an arena, in 6 rows a block or in 3. */
#ifndef SP__STATICS_OPEN_C
#define SP__STATICS_OPEN_C

#include "size.c"
#include "lift.c"

#if SP__WITH_LARGE

/* Room for the whole system in place of *reduction, which begins in `a`, so that a search in 3 rows does with what the whole
 * one takes. */
SP__NOINLINE static int sp__system_reserve(const sp_problem *pb, const sp_settings *set, sp__form form, int32_t nnz,
                                           const sp__reduction *reduction, sp_arena *a)
{
    const size_t from = (size_t)((const unsigned char *)reduction - a->base);
    sp_arena rest = *a;
    sp__system *t = sp__take(&rest, 1, sizeof *t);
    if (!t) return 0;
    t->reduction = NULL;
    const size_t end = sp__system_end(t, pb, set, form, nnz, from);
    if (end > a->capacity) return 0;
    if (end > a->peak) a->peak = end;
    return 1;
}

/* A system in `a`, everything but the numbers of a metric; reduction (may be NULL): in 3 rows, *reduction the last thing taken
 * from `a`.     returns NULL when the arena is too small */
SP__NOINLINE static sp__system *sp__system_make(const sp_problem *pb, const sp_settings *set, sp__form form,
                                                sp__reduction *reduction, sp_cost *cost, sp_arena *a)
{
    const int penalty = form == SP__PENALTY;
    sp__system *w = sp__take(a, 1, sizeof *w);
    const int32_t nnz = w ? sp__system_analyse(w, pb, a) : -1;
    if (nnz < 0 || (reduction && !sp__system_reserve(pb, set, form, nnz, reduction, a))) return NULL;
    w->reduction = reduction;
    sp__system_carve(w, pb, set, form, nnz, a);
    if (sp__failed(a)) return NULL;
    sp__bchol_pattern(&w->L, w->graph.xadj, w->graph.adj, w->graph.parent, w->graph.mark);
    w->set = set;
    w->budget.cost = cost;
    w->budget.limit = INT64_MAX;
    w->budget.spent = 0;
    w->law.soft = penalty && !set->penalty.net ? 1 / set->penalty.gamma : 0;
    w->law.slide = penalty ? 1 / SP_SQRT(set->penalty.tau) : 1;
    if (form == SP__METRIC || (form == SP__POLISH && set->seed))            /* fp, fm move together */
        w->law.slide = 1 / SP_SQRT(set->penalty.tau * (1 + 1 / set->penalty.gamma));
    sp__cone_make(&w->law.cone);
    sp_real half;
    w->law.friction = 1;
    w->law.least = 0;
    w->measure.metric = 0;
    if (set->faces && set->inscribed) sp__pyramid_half(set->faces, &w->law.friction, &half);
    if (set->effect[SP_EFFECT_FRICTION] == SP_WITHOUT) w->law.friction = 0;
    if (penalty) w->law.friction /= w->law.slide;
    sp__system_slots(w);
    w->measure.unit = sp__load_unit(pb);
    w->carried = NULL;
    if (sp__reduced(w)) sp__reduction_make(w);
    return w;
}

/* A system in all 6 rows. */
static sp__system *sp__system_make_full(const sp_problem *pb, const sp_settings *set, sp__form form, sp_cost *cost, sp_arena *a)
{
    return sp__system_make(pb, set, form, NULL, cost, a);
}

#endif

#endif /* SP__STATICS_OPEN_C */
