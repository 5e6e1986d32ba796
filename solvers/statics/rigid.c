/* rigid: joints that do not open tie blocks into rigid groups, and a mechanism is sharpened by them.
 *
 * A mechanism moves blocks together in few groups, but inverse iteration leaves a little play inside them (its square is what
 * the Hessian sees), which a long chain magnifies. So blocks without play are tied to the motion of one of them, the root:
 *
 *   x_i = (v + w x (c_i - c_root), w)
 *
 * and conjugate gradients on the tied motions remove what the contacts between groups still resist.  [Hestenes, Stiefel 1952]
 */
#ifndef SP__STATICS_RIGID_C
#define SP__STATICS_RIGID_C

#include "bilateral.c"

#if SP__WITH_LARGE

/* up[i + 1]: group of free block i by its lowest number + 1, 0: the ground; joined where no vertex of a contact moves by more
 * than `play` of its blocks' motion. Blocks held in some directions stay with the ground. */
SP__NOINLINE static void sp__rigid_groups(const sp__system *w, const sp_real *x, sp_real play, int32_t *up)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i <= pb->blocks; i++) up[i] = i;
    for (int32_t i = 0; i < pb->blocks; i++) if (pb->scene->block[pb->block[i]].fixed) sp__join(up, 0, i + 1);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], most = 0, size = 0;
        if (sp__reduced(w) && w->reduction->image[t->point] < 0) continue;
        sp__system_twist(w, t, x, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3];
            sp__system_rate(w, V, W, pb->local[v], u);
            most = sp__max(most, sp__norm3(u));
        }
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real *m = x + 6 * (size_t)i, *z = w->measure.weight + 2 * (size_t)i;
            size = sp__max(size, z[0] * sp__norm3(m) + z[1] * sp__norm3(m + 3) * sp__norm3(side ? t->rb : t->ra));
        }
        if (most <= play * size) sp__join(up, t->a + 1, t->b + 1);
    }
}

/* Groups are kept where the graph had its row starts: L has the pattern by then. Offsets are kept in state->dq. */
static int32_t *sp__rigid_room(const sp__system *w) { return w->graph.xadj; }
static sp_real (*sp__rigid_offsets(const sp_state *state))[3] { return (sp_real (*)[3])state->dq; }

/* The root of i's group and the arm from it; -1: the ground. */
static int32_t sp__rigid_root(const sp__system *w, int32_t *up, int32_t i, sp_real arm[3])
{
    const sp_problem *pb = w->pb;
    const int32_t g = sp__root(up, i + 1) - 1;
    if (g >= 0) sp__sub3(pb->scene->block[pb->block[i]].centroid, pb->scene->block[pb->block[g]].centroid, arm);
    if (g >= 0 && sp__reduced(w)) sp__reduction_turn(w->reduction, arm, arm);
    return g;
}

/* Every block's weighted motion from its root's, in place. */
static void sp__rigid_prolong(const sp__system *w, int32_t *up, sp_real *x)
{
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        sp_real arm[3], m[6], turn[3], *xi = x + 6 * (size_t)i;
        const int32_t g = sp__rigid_root(w, up, i, arm);
        if (g == i) continue;
        if (g < 0) { memset(xi, 0, 6 * sizeof *xi); continue; }
        const sp_real *z = w->measure.weight + 2 * (size_t)i, *s = w->measure.weight + 2 * (size_t)g;
        for (int k = 0; k < 6; k++) m[k] = s[k / 3] * x[6 * (size_t)g + (size_t)k];
        sp__cross3(m + 3, arm, turn);
        for (int k = 0; k < 3; k++) { xi[k] = (m[k] + turn[k]) / z[0]; xi[k + 3] = m[k + 3] / z[1]; }
    }
}

/* The transpose of sp__rigid_prolong: every block's weighted row onto its root's, in place; other rows become 0. */
static void sp__rigid_restrict(const sp__system *w, int32_t *up, sp_real *r)
{
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        sp_real arm[3], f[6], turn[3], *ri = r + 6 * (size_t)i;
        const int32_t g = sp__rigid_root(w, up, i, arm);
        if (g == i) continue;
        const sp_real *z = w->measure.weight + 2 * (size_t)i;
        for (int k = 0; k < 6; k++) { f[k] = ri[k] / z[k / 3]; ri[k] = 0; }
        if (g < 0) continue;
        const sp_real *s = w->measure.weight + 2 * (size_t)g;
        sp_real *rg = r + 6 * (size_t)g;
        sp__cross3(arm, f, turn);
        for (int k = 0; k < 3; k++) { rg[k] += s[0] * f[k]; rg[k + 3] += s[1] * (f[k + 3] + turn[k]); }
    }
}

/* F += g, M += l x g for g = S DP_K(u) du, the rates u and du of two twists. */
SP__NOINLINE static void sp__vertex_apply(const sp__system *w, int32_t c, int32_t v, sp__visit *s)
{
    const sp__yield *yield = sp__system_yield(w, c);
    const sp_real *l = w->pb->local[v], times = sp__system_multiplicity(w, v);
    sp_real *D = s->D, *u = s->u[0], *g = s->f, *m = s->m;
    if (!(times > 0)) return;
    sp__system_rate(w, s->twist[0], s->twist[0] + 3, l, u);
    if (sp__cone_derivative(&w->law.cone, yield, u, D) == SP__APEX) return;
    sp__system_rate(w, s->twist[1], s->twist[1] + 3, l, u);
    const sp_real S = times * sp__system_scale(w, c), x = S * u[0], y = S * u[1], z = S * u[2];
    g[0] = D[0] * x + D[1] * y + D[2] * z;
    g[1] = D[1] * x + D[3] * y + D[4] * z;
    g[2] = D[2] * x + D[4] * y + D[5] * z;
    sp__cross3(l, g, m);
    for (int k = 0; k < 3; k++) { s->sum[k] += g[k]; s->sum[k + 3] += m[k]; }
}

/* out = Aeq S DP_K(Aeq' y) Aeq' x, weighted.   up: rigid groups that x moves, inside which nothing gives; NULL: any x */
SP__NOINLINE static void sp__system_apply(sp__system *w, int32_t *up, const sp_real *y, const sp_real *x, sp_real *out)
{
    const sp_problem *pb = w->pb;
    memset(out, 0, 6 * (size_t)pb->blocks * sizeof *out);
    if (!sp__system_count(w, 2 * SP__FLOPS_SWEEP, 2 * SP__FLOPS_TWIST)) return;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp__visit *s = sp__visit_of(w);
        if (up && sp__root(up, t->a + 1) == sp__root(up, t->b + 1)) continue;
        for (int k = 0; k < 6; k++) s->sum[k] = 0;
        sp__system_twist(w, t, y, s->twist[0], s->twist[0] + 3);
        sp__system_twist(w, t, x, s->twist[1], s->twist[1] + 3);
        for (int32_t v = t->point; v < t->point + t->points; v++) sp__vertex_apply(w, c, v, s);
        sp__system_scatter(w, t, s->sum, s->sum + 3, out);
    }
    sp__system_release(w, out);
}

/* Tie the candidate w->d and sharpen it; w->r, L.t and state->dq are used up.     returns 0 when everything is tied down */
SP__NOINLINE static int sp__rigid_sharpen(sp__system *w, int32_t *up, sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real *x = w->d, *r = w->r, *p = state->dq, *q = w->L.t;
    sp__rigid_prolong(w, up, x);
    if (!(sp__system_norm(w, x) > 0)) return 0;
    sp__system_apply(w, up, w->y, x, r);
    sp__rigid_restrict(w, up, r);
    for (size_t k = 0; k < n; k++) p[k] = r[k] = -r[k];
    sp_real rr = sp__dot(r, r, n);
    const sp_real noise = (sp_real)SP_EPSILON * sp__system_norm(w, x);
    for (int it = 0; it < 40 && rr > noise * noise; it++) {
        sp__rigid_prolong(w, up, p);
        sp__system_apply(w, up, w->y, p, q);
        sp__rigid_restrict(w, up, q);
        const sp_real pq = sp__dot(p, q, n);
        if (!(pq > 0)) break;
        const sp_real alpha = rr / pq;
        for (size_t k = 0; k < n; k++) { x[k] += alpha * p[k]; r[k] -= alpha * q[k]; }
        const sp_real next = sp__dot(r, r, n), beta = next / rr;
        for (size_t k = 0; k < n; k++) p[k] = r[k] + beta * p[k];
        rr = next;
    }
    sp__rigid_prolong(w, up, x);
    return 1;
}

/* Rounding closes the joints inside a group by a few units in the last place of its motion, and all that hangs on a joint
 * presses there. So each opens a little, along paths of joints from the supports: v_i += 4 u max |v| sum n. That costs the work
 * of lifting. off: sum n, 3 x blocks.      mark: is it known? */
SP__NOINLINE static void sp__rigid_open_joints(sp__system *w, sp_real *x, sp_real (*off)[3])
{
    const sp_problem *pb = w->pb;
    sp_real most = 0;
    memset(off, 0, (size_t)pb->blocks * sizeof *off);
    memset(w->graph.mark, 0, (size_t)pb->blocks * sizeof *w->graph.mark);
    for (int more = 1, turn = 0; more && sp__system_spend(w, 6 * (int64_t)pb->contacts); turn = !turn) {
        more = 0;
        for (int32_t k = 0; k < pb->contacts; k++) {
            const sp_contact *t = &pb->contact[turn ? pb->contacts - 1 - k : k];
            const int a = t->a < 0 || w->graph.mark[t->a], b = t->b < 0 || w->graph.mark[t->b];
            if (a == b) continue;
            const int32_t from = a ? t->a : t->b, to = a ? t->b : t->a;
            if (from >= 0) memcpy(off[to], off[from], sizeof *off);
            sp__add3(off[to], a ? 1 : -1, t->joint->n);
            w->graph.mark[to] = more = 1;
        }
    }
    for (int32_t i = 0; i < pb->blocks; i++)
        most = sp__max(most, w->measure.weight[2 * (size_t)i] * sp__norm3(x + 6 * (size_t)i));
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (sp__reduced(w)) sp__reduction_turn(w->reduction, off[i], off[i]);
        sp__add3(x + 6 * (size_t)i, -4 * (sp_real)SP_EPSILON * most / w->measure.weight[2 * (size_t)i], off[i]);
    }
    sp__system_release(w, x);
}

#endif

#endif /* SP__STATICS_RIGID_C */
