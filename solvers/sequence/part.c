/* part: some of the blocks that are present become a part (scene/part.c) and are checked. */
#ifndef SP__SEQUENCE_PART_C
#define SP__SEQUENCE_PART_C

#include "../check/one.c"
#include "state.c"

#if SP__WITH_LARGE

/* Islands of the free blocks that are present and not held. */
static void sp__sequence_islands(sp_sequence *q)
{
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->island[b] = b;
    for (int32_t c = 0; c < q->pb.contacts; c++) {
        const sp_joint *t = q->pb.contact[c].joint;
        if (sp__free_now(q, t->a) && sp__free_now(q, t->b)) sp__join(q->island, t->a, t->b);
    }
}

/* Is contact c one of the part's: of a member, with another member or with what is held or a support? */
static int sp__part_has_contact(const sp_sequence *q, int32_t c)
{
    const sp_joint *t = q->pb.contact[c].joint;
    const int32_t end[2] = { t->a, t->b };
    if (!q->chosen.mark[t->a] && !q->chosen.mark[t->b]) return 0;
    for (int k = 0; k < 2; k++)
        if (!q->chosen.mark[end[k]] && (q->now.state[end[k]].presence == SP_ABSENT || sp__free_now(q, end[k]))) return 0;
    return 1;
}

/* Number k to the front of a list. */
static void sp__list_prepend(int32_t k, int32_t *first, int32_t *next)
{
    next[k] = *first;
    *first = k;
}

/* The part of all marked blocks. */
SP__NOINLINE static void sp__part_choose(sp_sequence *q)
{
    int32_t row = 0;
    sp__part *p = &q->chosen.part;
    p->block = p->joint = p->load = -1;
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->chosen.number[b] = -1;
    for (int32_t k = q->pb.blocks - 1; k >= 0; k--)
        if (q->chosen.mark[q->graph.order[k]]) sp__list_prepend(q->graph.order[k], &p->block, q->chosen.block_next);
    for (int32_t b = p->block; b >= 0; b = q->chosen.block_next[b]) q->chosen.number[b] = row++;
    for (int32_t c = q->pb.contacts - 1; c >= 0; c--)
        if (sp__part_has_contact(q, c)) sp__list_prepend(q->pb.contact[c].id, &p->joint, q->chosen.joint_next);
    for (int32_t k = q->scene->count.loads - 1; k >= 0; k--)
        if (q->chosen.mark[q->scene->load[k].block]) sp__list_prepend(k, &p->load, q->chosen.load_next);
}

/* The part of the island of `root`. */
static void sp__part_island(sp_sequence *q, int32_t root)
{
    for (int32_t b = 0; b < q->scene->count.blocks; b++)
        q->chosen.mark[b] = sp__free_now(q, b) && sp__root(q->island, b) == root;
    sp__part_choose(q);
}

/* A check of the part in `a`, before the first stage; f, dq: where it writes, at the scene's numbers. */
SP__NOINLINE static sp_status sp__part_begin(sp_sequence *q, sp_real *f, sp_real *dq, sp_arena *a, sp__check **c)
{
    for (int32_t b = q->chosen.part.block; b >= 0; b = q->chosen.block_next[b]) memset(dq + 6 * (size_t)b, 0, 6 * sizeof *dq);
    const sp_status status = sp__part_open(q->scene, &q->chosen.part, &q->set, a, c);
    if (status) return status;
    (*c)->r.f = f;
    (*c)->r.dq = dq;
    (*c)->pb.keep_order = 1;
    return SP_OK;
}

/* Does the part stand? sp_check without its reports. */
SP__NOINLINE static sp_status sp__part_check(sp_sequence *q, sp_real *f, sp_real *dq, sp__check **c)
{
    sp_arena a = q->work;
    sp_status status = sp__part_begin(q, f, dq, &a, c);
    if (status) return status;
    if ((*c)->pb.blocks) status = sp__run_stages(&(*c)->pb, &(*c)->set, &(*c)->state, &a, &(*c)->r);
    sp__cost_add(&q->spent.cost, &(*c)->r.spent.total);
    return status;
}

/* F, m: force on block b at vertex v of contact t, its moment about the centroid, both in units. */
static void sp__block_force(const sp_sequence *q, const sp_contact *t, int32_t b, int32_t v, sp_real F[3], sp_real m[3])
{
    const sp_joint *j = t->joint;
    const sp_real *f = q->now.f + 3 * (size_t)v, newton = sp__in_units(q->certifier.unit, j->b == b ? 1 : -1);
    sp_real arm[3];
    sp__joint_force(j, f, F);
    sp__scale3(newton, F, F);
    sp__arm(&q->pb, q->graph.row[b], v, arm);
    sp__cross3(arm, F, m);
}

/* |load| of the free blocks of a contact, the lesser, in units; SP__HUGE: none of them is free. */
static sp_real sp__contact_least_load(const sp_sequence *q, const sp_contact *t)
{
    sp_real least = SP__HUGE;
    for (int side = 0; side < 2; side++) {
        const int32_t b = side ? t->joint->b : t->joint->a;
        sp_real p[6];
        if (!sp__free_now(q, b)) continue;
        sp__certifier_load(&q->certifier, q->graph.row[b], p);
        const sp_real load = sp__norm3(p);
        if (load < least) least = load;
    }
    return least;
}

/* Is block b certified? Its imbalance, or more. */
SP__NOINLINE static void sp__block_certify(sp_sequence *q, int32_t b)
{
    sp__block_state *s = &q->now.state[b];
    sp_real r[6], m1 = 0;
    int large = 0;
    sp__certifier_load(&q->certifier, q->graph.row[b], r);
    const sp_real load = sp__norm3(r), couple = sp__norm3(r + 3), lever = q->graph.lever[q->graph.row[b]] * load;
    for (int32_t k = q->graph.start[b]; k < q->graph.start[b + 1]; k++) {
        const sp_contact *t = &q->pb.contact[q->graph.joint[k]];
        if (q->now.state[sp__neighbour(t, b)].presence == SP_ABSENT) continue;
        const sp_real most = q->set.force_bound * sp__contact_least_load(q, t);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real F[3], m[3];
            sp__block_force(q, t, b, v, F, m);
            for (int c = 0; c < 3; c++) { r[c] += F[c]; r[3 + c] += m[c]; }
            if (m1 < lever) m1 += sp__norm3(m);
            large |= sp__dot3(F, F) > most * most;
        }
        q->spent.cost.flops += 60 * (int64_t)t->points;
    }
    const sp_real arm = m1 < lever ? m1 : lever;
    s->imbalance = sp__max(sp__ratio(sp__norm3(r), (sp_real)1.8 * load), sp__ratio(sp__norm3(r + 3), couple + arm));
    s->certified = s->imbalance <= SP__CERTIFIED_TOL * q->set.tol && !large && q->graph.lever[q->graph.row[b]] > 0;
}

#endif

#endif /* SP__SEQUENCE_PART_C */
