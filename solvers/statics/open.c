/* open: making the system in an arena */
#ifndef SP__STATICS_OPEN_C
#define SP__STATICS_OPEN_C

#include "size.c"
#include "lift.c"

#if SP__WITH_LARGE

/* Room for the whole dual in place of *flat, which begins in `a`, so that a search in 3 rows does with what the whole one takes. */
SP__NOINLINE static int sp__dual_reserve(const sp_problem *pb, const sp_settings *set, sp__form form, int32_t nnz, const sp__flat *flat,
                                      sp_arena *a)
{
    const size_t from = (size_t)((const unsigned char *)flat - a->base);
    sp_arena rest = *a;
    sp__dual *t = sp__take(&rest, 1, sizeof *t);
    if (!t) return 0;
    t->flat = NULL;
    const int none = !SP__WITH_INTERIOR || form == SP__PENALTY || form == SP__MOTION;
    const size_t rays = none ? 0 : form == SP__LIMIT && !set->faces ? 3 : (size_t)set->faces;
    const size_t end = sp__dual_end(t, pb, set, 0, rays, nnz, from);
    if (end > a->cap) return 0;
    if (end > a->peak) a->peak = end;
    return 1;
}

/* A dual in `a`, everything but the numbers of a metric; flat (may be NULL): in 3 rows, *flat the last thing taken from `a`.
 *     returns NULL when the arena is too small */
SP__NOINLINE static sp__dual *sp__dual_make(const sp_problem *pb, const sp_settings *set, sp__form form, sp__flat *flat,
                                         sp_cost *cost, sp_arena *a)
{
    const int penalty = form == SP__PENALTY;
    sp__dual *w = sp__take(a, 1, sizeof *w);
    const int32_t nnz = w ? sp__dual_analyse(w, pb, a) : -1;
    if (nnz < 0 || (flat && !sp__dual_reserve(pb, set, form, nnz, flat, a))) return NULL;
    w->flat = flat;
    sp__dual_carve(w, pb, set->faces, nnz, form == SP__EXACT_DENSE, a);
    if (sp__failed(a)) return NULL;
    sp__bchol_pattern(&w->L, w->xadj, w->adj, w->parent, w->mark);
    w->set = set;
    w->cost = cost;
    w->limit = INT64_MAX;
    w->spent = 0;
    w->soft = penalty && !set->net ? 1 / set->gamma : 0;
    w->slide = penalty ? 1 / SP_SQRT(set->tau) : 1;
    if (form == SP__METRIC) w->slide = 1 / SP_SQRT(set->tau * (1 + 1 / set->gamma));     /* fp and fm move together: 1 + 1/gamma */
    sp__cone_make(&w->cone);
    sp_real half;
    w->factor = 1;
    w->metric = 0;
    if (set->faces && set->inscribed) sp__pyramid_half(set->faces, &w->factor, &half);
    if (set->effect[SP_EFFECT_FRICTION] == SP_WITHOUT) w->factor = 0;
    if (penalty) w->factor /= w->slide;
    sp__dual_slots(w);
    w->unit = sp__load_unit(pb);
    w->carried = NULL;
    if (sp__reduced(w)) sp__flat_open(w);
    return w;
}

static sp__dual *sp__dual_open(const sp_problem *pb, const sp_settings *set, sp__form form, sp_cost *cost, sp_arena *a)
{
    return sp__dual_make(pb, set, form, NULL, cost, a);
}

#endif

#endif /* SP__STATICS_OPEN_C */
