/* local: after a step, only blocks that are no longer balanced and those straight below them are solved anew; all other forces
 * are loads on them. */
#ifndef SP__SEQUENCE_LOCAL_C
#define SP__SEQUENCE_LOCAL_C

#include "part.c"

#if SP__WITH_LARGE

/* Records what a check of the part found about its blocks; forces and motion are in place. */
SP__NOINLINE static void sp__part_record(sp_sequence *q, const sp__check *c)
{
    for (int32_t k = 0; k < c->pb.blocks; k++) {
        const int32_t b = c->pb.block[k];
        sp__block_state *s = &q->now.state[b];
        s->certified = 0;
        if (c->r.verdict == SP_STABLE) sp__block_certify(q, b);
        if (c->r.verdict != SP_UNSTABLE) memset(q->now.dq + 6 * (size_t)b, 0, 6 * sizeof *q->now.dq);
        s->verdict = c->r.verdict;
        s->reason = c->r.reason;
        s->final = c->r.final;
        s->imbalance = c->r.imbalance;
        s->least = c->r.least_imbalance;
    }
    q->spent.again += c->pb.blocks;
}

/* Adds block b to those to be solved, once; origin: above which block that began. */
static void sp__local_add(sp_sequence *q, int32_t b, int32_t origin, int32_t *n)
{
    if (q->chosen.mark[b]) return;
    q->chosen.mark[b] = 1;
    q->list.solve[*n] = b;
    q->origin[(*n)++] = origin;
}

/* How far block s is from block o across gravity g, squared; -1: s is not below b. */
static sp_real sp__offset_below(const sp_sequence *q, const sp_contact *t, int32_t b, int32_t o)
{
    const sp_real *g = q->scene->gravity, size = sp__norm3(g);
    const int32_t s = sp__neighbour(t, b);
    sp_real d[3], n[3];
    sp__scale3(t->joint->a == b ? 1 : -1, t->joint->n, n);
    if (!(sp__dot3(n, g) > SP__BELOW * size)) return -1;
    sp__sub3(q->scene->block[s].centroid, q->scene->block[o].centroid, d);
    const sp_real along = sp__dot3(d, g) / size;
    return sp__max(0, sp__dot3(d, d) - along * along);
}

/* The blocks below block b that lie straightest below block o, unless b reaches something fixed. */
SP__NOINLINE static void sp__local_add_below(sp_sequence *q, int32_t b, int32_t o, int32_t *n)
{
    sp_real least = SP__HUGE;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t k = q->graph.start[b]; k < q->graph.start[b + 1]; k++) {
            const sp_contact *t = &q->pb.contact[q->graph.joint[k]];
            const int32_t s = sp__neighbour(t, b);
            const sp_real aside = q->now.state[s].presence == SP_ABSENT ? -1 : sp__offset_below(q, t, b, o);
            if (aside < 0) continue;
            if (!sp__free_now(q, s)) return;
            if (pass && aside <= (sp_real)1.05 * least) sp__local_add(q, s, o, n);
            if (aside < least) least = aside;
        }
}

/* All free blocks that block b touches. */
static void sp__local_add_neighbours(sp_sequence *q, int32_t b, int32_t *n)
{
    for (int32_t k = q->graph.start[b]; k < q->graph.start[b + 1]; k++) {
        const int32_t s = sp__neighbour(&q->pb.contact[q->graph.joint[k]], b);
        if (sp__free_now(q, s)) sp__local_add(q, s, b, n);
    }
}

/* The island of `root`: marks what is not certified and what is below that, wide: and what touches those.
 *     returns how many; 0: nothing, -1: most of it */
SP__NOINLINE static int32_t sp__local_choose(sp_sequence *q, int32_t root, int wide)
{
    int32_t n = 0, size = 0;
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->chosen.mark[b] = 0;
    for (int32_t b = root; b < q->scene->count.blocks; b++) {
        if (!sp__free_now(q, b) || sp__root(q->island, b) != root) continue;
        size++;
        if (!q->now.state[b].certified) sp__block_certify(q, b);
        if (!q->now.state[b].certified) sp__local_add(q, b, b, &n);
    }
    for (int32_t k = 0; k < n && 2 * n <= size; k++) sp__local_add_below(q, q->list.solve[k], q->origin[k], &n);
    const int32_t narrow = wide ? n : 0;
    for (int32_t k = 0; k < narrow && 2 * n <= size; k++) sp__local_add_neighbours(q, q->list.solve[k], &n);
    return 2 * n > size ? -1 : n;
}

/* Forces of joints with free blocks outside the part are loads on it. Where they cancel, the rest from rounding is dropped, for
 * it has no mirror image. */
SP__NOINLINE static void sp__local_load(sp_sequence *q, const sp_problem *pb)
{
    const sp_real unit = q->certifier.unit;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const int32_t b = pb->block[i];
        sp_real *p = pb->p + 6 * (size_t)i, size[2] = { sp__norm3(p), sp__norm3(p + 3) };
        for (int32_t k = q->graph.start[b]; k < q->graph.start[b + 1]; k++) {
            const sp_contact *t = &q->pb.contact[q->graph.joint[k]];
            const int32_t s = sp__neighbour(t, b);
            if (!sp__free_now(q, s) || q->chosen.mark[s]) continue;
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                sp_real F[3], m[3];
                sp__block_force(q, t, b, v, F, m);
                size[0] += sp__in_newtons(unit, sp__norm3(F));
                size[1] += sp__in_newtons(unit, sp__norm3(m));
                sp__to_newtons(unit, 3, F, F);
                sp__to_newtons(unit, 3, m, m);
                for (int c = 0; c < 3; c++) { p[c] += F[c]; p[3 + c] += m[c]; }
            }
            q->spent.cost.flops += 76 * (int64_t)t->points;
        }
        for (int c = 0; c < 6; c++)
            if (sp__abs(p[c]) <= 64 * (sp_real)SP_EPSILON * size[c / 3]) p[c] = 0;
    }
}

/* Forces of the part's joints, admitted.     returns 1 if all its blocks are certified then */
SP__NOINLINE static int sp__local_record(sp_sequence *q, const sp__check *c)
{
    int certified = 1;
    const sp_real newton = sp__in_units(q->certifier.unit, 1); /* in units */
    for (int32_t k = 0; k < c->pb.contacts; k++) {
        const sp_contact *t = &c->pb.contact[k];
        q->certifier.force_cap = q->set.force_bound * sp__contact_least_load(q, t);
        for (int32_t v = 0; v < t->points; v++) {
            sp_real *f = q->now.f + 3 * (size_t)(t->joint->point + v), g[3];
            sp__scale3(newton, c->state.f + 3 * (size_t)(t->point + v), g);
            sp__certifier_make_admissible(&q->certifier, t, g, g);
            sp__to_newtons(q->certifier.unit, 3, g, f);
        }
    }
    for (int32_t k = 0; k < c->pb.blocks; k++) {
        sp__block_certify(q, c->pb.block[k]);
        certified &= q->now.state[c->pb.block[k]].certified;
    }
    return certified;
}

/* The marked blocks alone, all other forces as they are: in their plane where they, with these as loads, have one.
 *     returns 1 if they are certified then */
SP__NOINLINE static int sp__local_solve(sp_sequence *q)
{
    sp__check *c = NULL;
    sp__reduction *reduction = NULL;
    sp_arena a = q->work;
    sp_verdict claim = SP_UNDECIDED;
    sp__part_choose(q);
    if (sp__part_begin(q, q->now.f, q->now.dq, &a, &c)) return 0;
    sp__local_load(q, &c->pb);
    sp_arena room = a;
    sp__reduction *o = sp__take(&room, 1, sizeof *o);
    if (o && sp__reduction_choose(&c->pb, &c->set, o) && o->mode == SP__PLANE) { reduction = o; a = room; }
    if (c->set.iterations > SP__LOCAL_STEPS) c->set.iterations = SP__LOCAL_STEPS;
    c->set.tol *= SP__LOCAL_TOL;
    c->state.left = sp__budget_left(&c->set, &c->r);
    c->state.brief = SP__BRIEF_FORCES;
    const sp_status status = sp__exact_search(&c->pb, &c->set, reduction, &c->state, &a, &claim);
    sp__cost_add(&q->spent.cost, &c->state.cost);
    q->spent.again += c->pb.blocks;
    return !status && claim != SP_UNSTABLE && sp__all_finite(c->state.f, 3 * (size_t)c->pb.points) && sp__local_record(q, c);
}

/* Do forces near those of the step before balance the island of `root`? Then that is what is known of it. */
SP__NOINLINE static int sp__local_island(sp_sequence *q, int32_t root)
{
    int exact = 0, done = 0;
    for (int32_t k = 0; k < q->set.stage_count; k++) exact |= q->set.stage[k] == SP_STAGE_EXACT;
    for (int wide = 0; wide < 2 && exact && !done; wide++) {
        const int32_t n = sp__local_choose(q, root, wide);
        if (n < 0) return 0;
        done = n == 0 || sp__local_solve(q);
    }
    if (!done) return 0;
    for (int32_t b = root; b < q->scene->count.blocks; b++) {
        sp__block_state *s = &q->now.state[b];
        if (!sp__free_now(q, b) || sp__root(q->island, b) != root) continue;
        s->verdict = SP_STABLE;
        s->reason = SP_REASON_FORCES;
        s->final = 0;
        s->least = 0;
        for (size_t k = 0; k < 6; k++) q->now.dq[6 * (size_t)b + k] = 0;
    }
    q->spent.local++;
    return 1;
}

#endif

#endif /* SP__SEQUENCE_LOCAL_C */
