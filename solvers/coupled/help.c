/* help: where tension or friction is missing so that a motion explains the forces: the penalty form joined with a motion.
 *                                                                                                   [Kao 2022, Eq. 14] */
#ifndef SP__COUPLED_HELP_C
#define SP__COUPLED_HELP_C

#include "search.c"

#if SP__WITH_COUPLED

/* The best answer into the result: alpha, what each joint demands, the largest fm / the largest fp. */
SP__NOINLINE static void sp__cra_demand(const sp__cra *c, sp_demand *demand)
{
    sp_coupled *out = c->out;
    sp_real press = 0, pull = 0;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        sp_demand *o = &demand[t->id];
        o->tension = o->friction = 0;
        for (size_t v = 0; v < (size_t)t->points; v++) {
            const sp_real *x = out->penalty + 4 * ((size_t)t->joint->point + v), ft = SP_SQRT(x[2] * x[2] + x[3] * x[3]);
            o->tension = sp__max(o->tension, x[1] - x[0]);
            o->friction = sp__max(o->friction, ft - t->joint->strength.mu * sp__max(x[0] - x[1], 0));
            press = sp__max(press, x[0]);
            pull = sp__max(pull, x[1]);
        }
    }
    out->tension_ratio = sp__ratio(pull, press);
}

/* Where help is wanted: the penalty form, joined with a motion.                                              [Kao 2022, Eq. 14]
 *
 *     min 1/2 sum (fp^2 + gamma fm^2 + tau |ft|^2)     Aeq (fp - fm, ft) + p = 0,  |ft| <= mu fp,  fm >= 0
 *     (fp, ft, dq, alpha) as in the coupled check
 *
 * Motions come from the search, with joints that stick: pulled open they give softly. Each is held fast; what is left is
 * convex, and its dual is unconstrained as that of the penalty form. The least of them counts. */
SP__NOINLINE static void sp__cra_help(sp__cra *c, sp_demand *demand)
{
    static const sp_real part[] = { 1, (sp_real)0.1, 10, 100 };
    const int32_t rounds = c->out->rounds;
    c->held.least = SP__HUGE;
    for (int k = 0; k < 8 && (k < 2 || !(c->held.least < SP__HUGE)) && !c->w->budget.spent; k++) {
        c->spring.stiff = SP__STIFF;
        c->spring.soft = part[k % 4] / (SP__STIFF * c->k.eta);             /* a joint that carries sbar opens by eta / part */
        sp__cra_set_start(c, SP__START_FREE, 0);
        memset(c->w->y, 0, 6 * (size_t)c->pb->blocks * sizeof *c->w->y);
        sp__cra_start_closed(c, (sp_real)0.01);
        if (k >= 4) sp__cra_search(c);
        else if (sp__cra_descend(c)) sp__cra_try_motion(c);
    }
    c->out->rounds = rounds;
    if (c->held.least < SP__HUGE) sp__cra_demand(c, demand);
}

#endif

#endif /* SP__COUPLED_HELP_C */
