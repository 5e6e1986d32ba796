/* lift: motions and forces of a reduced search in all 6 rows of the scene, and motions back; is a level scene a forest? */
#ifndef SP__STATICS_LIFT_C
#define SP__STATICS_LIFT_C

#include "../base/groups.c"
#include "motion.c"

#if SP__WITH_LARGE

/* Height of contact c along e2 above the centroid of its free block of the lower number. */
static sp_real sp__reduction_height(const sp__system *w, const sp_contact *t)
{
    const int a = t->a >= 0 && (t->b < 0 || t->a < t->b);
    return sp__dot3(a ? t->ra : t->rb, w->reduction->e[2]);
}

/* Are joints of one pair of nodes in one plane, none across and none warped?    L.d, L.x: a mark and the height of the first */
SP__NOINLINE static int sp__reduction_layered(sp__system *w)
{
    const sp_problem *pb = w->pb;
    const sp_real eps = sp__reduction_tol(w->set);
    sp__bchol_zero(&w->L);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const int32_t i = t->a >= 0 ? t->a : t->b, slot = w->slot[c];
        sp_real *first = slot == INT32_MIN ? sp__bchol_d(&w->L) + 6 * (size_t)i
                       : sp__bchol_x(&w->L) + 9 * (size_t)(slot < 0 ? -1 - slot : slot);
        const sp_real height = sp__reduction_height(w, t), size = sp__norm3(t->ra) + sp__norm3(t->rb);
        if (first[0] > 0 && sp__abs(first[1] - height) > eps * size) return 0;
        first[0] = 1;
        first[1] = height;
        for (int32_t v = t->point; v < t->point + t->points; v++)
            if (w->reduction->image[v] < 0 || sp__abs(pb->local[v][0]) > eps * (size + sp__norm3(pb->local[v]))) return 0;
    }
    return 1;
}

/* Nodes less edges are as many as trees: a forest. Supports are one node, of edges between free blocks each is in adj twice.
 * mark: trees without supports; parent: does a block, then a tree, touch one? */
SP__NOINLINE static int sp__reduction_forest(sp__system *w)
{
    const sp_problem *pb = w->pb;
    int64_t edges = w->graph.xadj[pb->blocks] / 2, trees = 1;
    if (!sp__reduction_layered(w)) return 0;
    for (int32_t i = 0; i < pb->blocks; i++) { w->graph.mark[i] = i; w->graph.parent[i] = 0; }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        if (t->a >= 0 && t->b >= 0) sp__join(w->graph.mark, t->a, t->b);
        else w->graph.parent[t->a >= 0 ? t->a : t->b] = 1;
    }
    for (int32_t i = 0; i < pb->blocks; i++) edges += w->graph.parent[i];
    for (int32_t i = 0; i < pb->blocks; i++) w->graph.parent[sp__root(w->graph.mark, i)] |= w->graph.parent[i];
    for (int32_t i = 0; i < pb->blocks; i++) trees += sp__root(w->graph.mark, i) == i && !w->graph.parent[i];
    return edges + trees == (int64_t)pb->blocks + 1;
}

/* Sideways motion of a forest, rows 0 and 1, from supports upwards so that no joint slips; m: motions in the axes e. With turns
 * w0, w1 a block's points at arm r2 along e2 go sideways by v0 + w1 r2, v1 - w0 r2.     mark: has it been placed? */
SP__NOINLINE static void sp__reduction_place(sp__system *w, sp_real *m)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i < pb->blocks; i++) w->graph.mark[i] = 0;
    for (int more = 1, turn = 0; more; turn = !turn) {
        more = 0;
        w->budget.cost->flops += 8 * (int64_t)pb->contacts;
        for (int32_t k = 0; k < pb->contacts; k++) {
            const sp_contact *t = &pb->contact[turn ? pb->contacts - 1 - k : k];
            const int a = t->a < 0 || w->graph.mark[t->a], b = t->b < 0 || w->graph.mark[t->b];
            if (a == b) continue;
            const int32_t from = a ? t->a : t->b, to = a ? t->b : t->a;
            const sp_real *up = w->reduction->e[2];
            const sp_real below = sp__dot3(a ? t->ra : t->rb, up), above = sp__dot3(a ? t->rb : t->ra, up);
            sp_real *x = m + 6 * (size_t)to, v[2] = { 0, 0 };
            if (from >= 0) {
                const sp_real *y = m + 6 * (size_t)from;
                v[0] = y[0] + y[4] * below;
                v[1] = y[1] - y[3] * below;
            }
            x[0] = v[0] - x[4] * above;
            x[1] = v[1] + x[3] * above;
            w->graph.mark[to] = more = 1;
        }
    }
}

/* Motions out of the axes e, of a forest with what goes sideways; in 6 rows there is nothing to do. */
static void sp__reduction_to_space(sp__system *w, sp_real *m)
{
    if (!sp__reduced(w)) return;
    if (w->reduction->forest) sp__reduction_place(w, m);
    for (int32_t i = 0; i < 2 * w->pb->blocks; i++) sp__reduction_turn_back(w->reduction, m + 3 * (size_t)i);
}

#if SP__WITH_LIMIT
/* Motions into the axes e, planar rows alone; o NULL: nothing to do. */
static void sp__reduction_from_space(const sp__reduction *o, int32_t blocks, sp_real *m)
{
    if (!SP__WITH_REDUCTION || !o) return;
    for (int32_t i = 0; i < 2 * blocks; i++, m += 3) {
        sp__reduction_turn(o, m, m);
        if (i % 2) m[0] = m[1] = 0; else m[2] = 0;
    }
}
#endif

/* A reduced search's own arrays filled: images, frames, work of a factor; is it a forest, is it frictionless? */
SP__NOINLINE static void sp__reduction_make(sp__system *w)
{
    const sp_problem *pb = w->pb;
    sp__reduction *o = w->reduction;
    sp__reduction_images(o, pb, w->set);
    o->no_strength = !sp__problem_strong(pb);
    for (int32_t c = 0; c < pb->contacts; c++)
        sp__reduction_contact(o, &w->law.cone, &pb->contact[c], o->g + SP__REDUCTION_G * (size_t)c);
    w->L.flops = 0;
    for (int32_t k = 0; k < w->L.n; k++) {
        const int64_t below = w->L.p[k + 1] - w->L.p[k];
        w->L.flops += 17 + 57 * below + 54 * (below * (below - 1) / 2);
    }
    w->reduction->forest = w->reduction->mode == SP__LEVEL_JOINTS && sp__reduction_forest(w);
    w->reduction->frictionless = w->reduction->mode == SP__LEVEL_JOINTS;
    for (int32_t c = 0; c < pb->contacts; c++)
        if (pb->contact[c].joint->strength.mu > 0 || o->image[pb->contact[c].point] < 0) o->frictionless = 0;
}

/* Forces of vertices that do not count: those of their images, or none; what rounding left of forces across the plane goes;
 * o NULL: nothing to do. */
static void sp__reduction_copy_forces(const sp__reduction *o, const sp_problem *pb, sp_real *f)
{
    if (!SP__WITH_REDUCTION || !o) return;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real *g = o->g + SP__REDUCTION_G * (size_t)c;
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real *fv = f + 3 * (size_t)v;
            if (o->image[v] < 0) fv[0] = fv[1] = fv[2] = 0;
            else if (o->image[v] < v) memcpy(fv, f + 3 * (size_t)o->image[v], 3 * sizeof *f);
            else if (o->mode == SP__PLANE) {
                const sp_real slip = fv[1] * g[2] + fv[2] * g[3];
                fv[1] = slip * g[2];
                fv[2] = slip * g[3];
            }
        }
    }
}

#endif

#endif /* SP__STATICS_LIFT_C */
