/* search: the search for a triple: rounds of Newton steps with springs and drag (springs.c), from several starts, the drag
 * growing until slips are short enough. */
#ifndef SP__COUPLED_SEARCH_C
#define SP__COUPLED_SEARCH_C

#include "offer.c"
#include "held.c"

#if SP__WITH_COUPLED

#define SP__CRA_ROUNDS 60               /* at one drag */

/* Rounds at one drag, to more digits where fewer do not do.
 *   returns 1: a triple is verified, 0: go on, -1: the motion ran away */
SP__NOINLINE static int sp__cra_rounds(sp__cra *c)
{
    c->descent.goal = SP__AGREE;
    for (int round = 0; round < SP__CRA_ROUNDS; round++) {
        c->out->rounds++;
        if (!sp__cra_descend(c)) return -1;
        if (c->spring.soft > 0 && sp__cra_try_motion(c)) return 1;
        c->descent.too_far = 0;
        if (sp__cra_update(c)) {
            c->descent.too_far = sp__cra_extent(c, c->w->y) > c->k.eta + SP__STIFF * SP__GIVE;
            if (c->descent.too_far || c->spring.soft > 0) return 0;
            if (sp__cra_polish(c)) return 1;
            memcpy(c->w->y, c->descent.from, 6 * (size_t)c->pb->blocks * sizeof *c->descent.from);
            c->descent.goal /= 1000;
            c->spring.stiff *= 100;                     /* where joints fit to rounding only, forces move by stiff times that */
            if (c->descent.goal < 100 * (sp_real)SP_EPSILON) return 0;
        }
    }
    return 0;
}

/* A start with the joints that press already closed: forces as if dn + eps were dn, then the motion put onto dn = -eps there.
 * Without eps they touch where they are, and press as statics found: nothing else would, where a squeezed block only slides. */
static void sp__cra_start_closed(sp__cra *c, sp_real drag)
{
    const int gives = c->k.eps > 0;
    c->drag.size = drag;
    c->descent.goal = SP__AGREE;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real press = (sp_real)1.01 * c->spring.stiff * sp__cra_sbar(c, t) * c->k.eps;
        for (int32_t v = t->point; v < t->point + t->points; v++)
            c->spring.lam[v] = gives ? press : sp__in_units(c->w->measure.unit, c->statics[3 * (size_t)v]);
    }
    if (!gives) return;
    sp__cra_descend(c);
    for (size_t v = 0; v < (size_t)c->pb->points; v++) c->spring.lam[v] = sp__max(c->spring.f[3 * v], 0);
    sp__cra_move_to_contact(c);
}

/* From rest, with growing drag and joints as stiff as that.     returns 1 when a triple is verified */
SP__NOINLINE static int sp__cra_grow_drag(sp__cra *c, sp_real drag, sp_real stiff)
{
    memset(c->w->y, 0, 6 * (size_t)c->pb->blocks * sizeof *c->w->y);
    c->spring.stiff = stiff;
    sp__cra_start_closed(c, drag);
    for (c->drag.size = drag; c->drag.size < 200 || (c->descent.too_far && c->drag.size < 20000); c->drag.size *= 10) {
        c->spring.stiff = stiff;
        const int found = sp__cra_rounds(c);
        if (found) return found > 0;
    }
    return 0;
}

/* Friction to start with: without a bound, at mu times statics' fn, a whole or (other contacts than `lone`, or it alone) hardly
 * any of the drag. */
typedef enum sp__start { SP__START_FREE, SP__START_STATICS, SP__START_DRAG, SP__START_LONE, SP__START_OTHERS } sp__start;

/* Sets the bound of friction at every vertex, and whether drag grows, for a start. */
static void sp__cra_set_start(sp__cra *c, sp__start how, int32_t lone)
{
    c->drag.viscous = how >= SP__START_DRAG;
    c->drag.grow = how == SP__START_DRAG ? 2 : 1;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const int weak = how >= SP__START_LONE && (q == lone) == (how == SP__START_OTHERS);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real press = sp__in_units(c->w->measure.unit, c->statics[3 * v]);
            const sp_real most = t->joint->strength.mu * c->j.mu_factor * press;
            c->drag.share[v] = (sp_real)0.5;
            c->drag.miss[v] = 0;
            c->drag.bound[v] = c->drag.viscous ? (weak ? (sp_real)1e-5 : 1) : how == SP__START_FREE ? SP__HUGE : most;
        }
    }
}

#define SP__LONE_MOST 24                /* contacts up to which each is tried alone: an eccentric jam comes of unequal drag */

/* Several starts, the likeliest first. */
static int sp__cra_search(sp__cra *c)
{
    static const struct { sp__start how; sp_real drag, stiff; } start[] = {
        { SP__START_STATICS, (sp_real)0.01, SP__LESS_STIFF }, { SP__START_FREE, (sp_real)0.01, SP__LESS_STIFF },
        { SP__START_FREE, (sp_real)0.01, SP__STIFF },         { SP__START_FREE, (sp_real)0.1, SP__STIFF },
        { SP__START_DRAG, (sp_real)0.01, SP__STIFF },         { SP__START_STATICS, (sp_real)0.01, SP__STIFF },
        { SP__START_DRAG, 1, SP__STIFF },                     { SP__START_STATICS, 1, SP__STIFF },
        { SP__START_FREE, 1, SP__STIFF },                     { SP__START_DRAG, (sp_real)1e-4, SP__STIFF } };
    for (int k = c->spring.soft > 0 ? 2 : 0; k < 10; k++) {
        sp__cra_set_start(c, start[k].how, 0);
        if (sp__cra_grow_drag(c, start[k].drag, start[k].stiff)) return 1;
        if (c->w->budget.spent) return 0;
    }
    for (int32_t q = 0; q < c->pb->contacts && c->pb->contacts <= SP__LONE_MOST && !c->w->budget.spent; q++)
        for (int others = 0; others < 2; others++) {
            sp__cra_set_start(c, others ? SP__START_OTHERS : SP__START_LONE, q);
            if (sp__cra_grow_drag(c, (sp_real)0.01, SP__STIFF)) return 1;
        }
    return 0;
}

#endif

#endif /* SP__COUPLED_SEARCH_C */
