/* open: memory of a coupled check, its dual and scales, and the start at rest from the forces of statics. */
#ifndef SP__COUPLED_OPEN_C
#define SP__COUPLED_OPEN_C

#include "springs.c"

#if SP__WITH_COUPLED

/* The dual, for work up to `limit`; reduction (may be NULL): in 3 rows. */
static int sp__cra_open(sp__cra *c, int64_t limit, sp__reduction *reduction, sp_arena *a)
{
    c->w = sp__system_make(c->pb, c->set, SP__MOTION, reduction, &c->out->cost, a);
    if (!c->w) return 0;
    c->w->budget.limit = limit;
    c->w->law.given = c->spring.D;
    return 1;
}

/* Its scales. */
static void sp__cra_begin(const sp__cra *c)
{
    sp__system_bilateral(c->w);
    sp__system_sizes(c->w, c->w->y);
    if (sp__system_metric(c->w)) sp__system_bilateral(c->w);
}

/* Is there a plane to search in? The seed's search takes the scene as it is. */
static int sp__cra_mirror(const sp_problem *pb, const sp_settings *set, sp__reduction *o)
{
    return !set->coupled.rounds && sp__reduction_choose(pb, set, o) && o->mode == SP__PLANE;
}

/* All that it keeps, the arrays of its certificate check last. */
SP__NOINLINE static void sp__coupled_carve(sp__cra *c, const sp_problem *pb, const sp_settings *set, sp_arena *a)
{
    sp__triple_carve(&c->offer.t, pb, a);
    sp__cra_carve(c, pb, set->localise, a);
    sp__certifier_carve(&c->j, pb, set->faces, a);
}

SP__NOINLINE static size_t sp__coupled_need(const sp_problem *pb, const sp_settings *set, size_t turns, sp_arena scratch)
{
    sp_arena room = scratch;
    sp__reduction *o = sp__take(&room, 1, sizeof *o);
    if (!o) return SIZE_MAX;
    const size_t dual = sp__system_bytes(pb, set, SP__MOTION, sp__cra_mirror(pb, set, o) ? o : NULL, room);
    sp__cra *c = sp__take(&scratch, 1, sizeof *c);
    if (!c || dual == SIZE_MAX || turns == SIZE_MAX) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *c);
    sp__coupled_carve(c, pb, set, &dry);
    sp_arena branch = dry;
    sp__take(&branch, 1, sp__branch_need(pb, set));
    sp__take(&dry, 1, dual);
    if (turns) sp__take(&dry, 1, turns);
    return dry.used > branch.used ? dry.used : branch.used;
}

/* The forces of statics, all at rest. */
static void sp__cra_offer_statics(sp__cra *c, sp_real imbalance)
{
    memcpy(c->offer.t.f, c->statics, (size_t)c->pb->points * 3 * sizeof *c->offer.t.f);
    memset(c->offer.t.dq, 0, (size_t)c->pb->blocks * 6 * sizeof *c->offer.t.dq);
    memset(c->offer.t.alpha, 0, (size_t)c->pb->points * sizeof *c->offer.t.alpha);
    c->offer.imbalance = imbalance;
    c->offer.residual = sp__certify_coupled(&c->j, &c->k, c->offer.t.f, c->offer.t.dq, c->offer.t.alpha);
}

#elif SP__WITH_LARGE

static size_t sp__coupled_need(const sp_problem *pb, const sp_settings *set, size_t turns, sp_arena scratch)
{
    return (void)pb, (void)set, (void)turns, (void)scratch, 0;
}

#endif

#endif /* SP__COUPLED_OPEN_C */
