/* refute: does a tree of cases, each closed by a Farkas vector, prove that no triple (f, dq, alpha) exists?
 *
 *   sum y b  <  min c x over the box of x = (f, dq),  c = sum y a,  for rows a x <= b that hold in that case    [Farkas 1902]
 */
#ifndef SP__PROOF_REFUTE_C
#define SP__PROOF_REFUTE_C

#include "triple.c"

#if SP__WITH_COUPLED

/* A proof that there is no triple, walked and added up. Its tree splits the states of the vertices (sp_proof); in a leaf the
 * multipliers y of linear rows a x <= b that hold for every triple of these states, x = (f, dq), with c = sum y a, show
 *
 *     sum y b  <  min c x  over the box   0 <= fn <= F, |ft| <= mu F, |dq_r| <= M_r
 *
 * so there is no such triple. What a triple may be out by (tol, SP__GIVE, SP__SLIP) and what rounding may do, (32 + number of
 * multipliers) u times all products' sizes, is taken off. M: G x_r = e_r, G = Aeq Aeq' weighted, gives dq_r = sum (Aeq' x_r).d,
 * and every |d| is bounded.
 */
typedef struct sp__refute {
    sp__certifier *j;
    const sp__lengths *k;
    const sp_proof *proof;
    int32_t points;                     /* V: vertices that take part */
    int32_t *contact, *at, *state;      /* V */
    int32_t *stack;                     /* 2 x SP__PROOF_DEPTH x V: vertex, state before */
    sp_real *F, total;                  /* V: bound of fn; bound of sum fn */
    sp_real *any_friction;              /* V: friction of any direction */
    sp_real (*f)[3], (*d)[3];           /* V: c on f and on d, contact frame */
    sp_real *fsize, *dsize;             /* V: sizes of what was added up there */
    sp_real *motion;                    /* 6b: multipliers of the balance; then c on dq */
    sp_real *reach;                     /* 6b: M */
    sp_real work;                       /* multiplier of the row of work */
    sp_real right, size, slack;         /* sum y b; sizes of its products; sum |y| of what rows may be out by */
    sp_real slack_of_work;              /* what the row of work may be out by */
} sp__refute;

#define SP__PROOF_DEPTH 32              /* splits above a leaf, for every vertex */
#define SP__PROOF_DEEP (1 << 26)        /* a sector of this state is not halved any more */
#define SP__PROOF_ROWS 24               /* rows of a vertex */

static void sp__refute_carve(sp__refute *w, int32_t points, int32_t blocks, sp_arena *a)
{
    const size_t n = (size_t)points;
    w->points = points;
    w->contact = sp__take(a, n, sizeof *w->contact);
    w->at = sp__take(a, n, sizeof *w->at);
    w->state = sp__take(a, n, sizeof *w->state);
    w->stack = sp__take(a, n, 2 * SP__PROOF_DEPTH * sizeof *w->stack);
    w->F = sp__take(a, n, sizeof *w->F);
    w->any_friction = sp__take(a, n, sizeof *w->any_friction);
    w->f = sp__take(a, n, sizeof *w->f);
    w->d = sp__take(a, n, sizeof *w->d);
    w->fsize = sp__take(a, n, sizeof *w->fsize);
    w->dsize = sp__take(a, n, sizeof *w->dsize);
    w->motion = sp__take(a, (size_t)blocks, 6 * sizeof *w->motion);
    w->reach = sp__take(a, (size_t)blocks, 6 * sizeof *w->reach);
}

SP__NOINLINE static size_t sp__refute_need(int32_t points, int32_t blocks)
{
    sp__refute w;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof w);
    sp__refute_carve(&w, points, blocks, &dry);
    return dry.used;
}

/* sum over vertices of |Aeq' W x| times the largest |d|, x = j->dual.potential. */
static sp_real sp__refute_stretch(const sp__refute *w)
{
    const sp_problem *pb = w->j->pb;
    const sp_real largest = w->k->eta + w->k->eps;          /* >= |dn|, |dt1|, |dt2| */
    sp_real sum = 0;
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        sp_real u[3];
        sp__vertex_velocity(pb, w->j->scale, t, w->at[v], w->j->dual.potential, u);
        sum += sp__norm3(u) * 2 * largest;                  /* 2 > sqrt 3 */
    }
    return sum;
}

/* e_r without the spin of its block. */
static void sp__refute_unit(const sp__certifier *j, int32_t r, sp_real *e)
{
    sp_real k[6];
    for (int32_t q = 0; q < 6 * j->pb->blocks; q++) e[q] = q == r;
    if (!sp__certifier_free_spin(j, r / 6, k)) return;
    for (int32_t q = 0; q < 6; q++) e[r / 6 * 6 + q] -= k[r % 6] * k[q];
}

/* M: |z_r| <= S_r + |G x_r - e_r| max |z|, z = dq / W, and z has no spin.     returns 0: contacts do not bound every motion */
SP__NOINLINE static int sp__refute_reach(sp__refute *w)
{
    sp__certifier *j = w->j;
    const int32_t n = 6 * j->pb->blocks;
    sp_real farthest = 0, worst = 0;
    for (int pass = 0; pass < 2; pass++) {
        if (!(worst < (sp_real)0.5)) return 0;
        for (int32_t r = 0; r < n; r++) {
            const sp_real weight = r % 6 < 3 ? j->scale[r / 6].wf : j->scale[r / 6].wm;
            sp_real miss = 0;
            w->reach[r] = 0;
            if (sp__held(j->pb, r / 6, r % 6)) continue;
            sp__refute_unit(j, r, j->residual);
            for (int32_t q = 0; q < n; q++) j->dual.potential[q] = 0;
            sp__certifier_least_squares(j, j->dual.potential);
            sp__certifier_normal_product(j, j->dual.potential, j->image);
            sp__refute_unit(j, r, j->residual);
            for (int32_t q = 0; q < n; q++) miss += sp__abs(j->image[q] - j->residual[q]);
            const sp_real stretch = sp__refute_stretch(w);
            farthest = sp__max(farthest, stretch);
            if (!pass) worst = sp__max(worst, miss);
            else w->reach[r] = (sp_real)1.01 * weight * (stretch + miss * farthest / (1 - worst));
        }
    }
    return 1;
}

/* F and its sum, by the caps and by work: g sum fn <= p . dq; and what that row may be out by. */
static void sp__refute_forces(sp__refute *w)
{
    sp__certifier *j = w->j;
    const sp_problem *pb = j->pb;
    sp_real work = 0;
    w->slack_of_work = w->total = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *m = w->reach + 6 * (size_t)i;
        sp_real p[6];
        sp__certifier_load(j, i, p);
        for (int k = 0; k < 6; k++) work += sp__abs(p[k]) * m[k];
        w->slack_of_work += j->set->tol * (j->scale[i].s * (m[0] + m[1] + m[2]) + j->scale[i].S * (m[3] + m[4] + m[5]));
    }
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        w->F[v] = sp__certifier_force_cap(j, t);
        w->total += w->F[v];
        w->any_friction[v] = j->set->tol * sp__least_of_blocks(t, &j->scale->s, sizeof *j->scale / sizeof j->scale->s);
        w->slack_of_work += 2 * w->any_friction[v] * w->k->eta;
    }
    if (w->k->eps > 0) {
        const sp_real bound = (sp_real)1.01 * (work + w->slack_of_work);
        w->total = bound < w->total ? bound : w->total;
        for (int32_t v = 0; v < w->points; v++) w->F[v] = bound < w->F[v] ? bound : w->F[v];
    }
    w->slack_of_work += SP__GIVE * w->total;
}

/* Unit vector at `turn` of 2^halvings parts of a quarter turn after the x axis: the half-angle formulas, bit by bit. */
static void sp__refute_direction(int32_t turn, int32_t halvings, sp_real d[2])
{
    sp_real c = 0, s = 1;                               /* of a quarter turn, halved again and again */
    d[0] = 1; d[1] = 0;
    for (int32_t q = turn >> halvings; q > 0; q--) { const sp_real x = d[0]; d[0] = -d[1]; d[1] = x; }
    for (int32_t bit = halvings - 1; bit >= 0; bit--) {
        const sp_real half = SP_SQRT((1 + c) / 2);
        s = s / (2 * half);
        c = half;
        if (!(turn >> bit & 1)) continue;
        const sp_real x = d[0] * c - d[1] * s;
        d[1] = d[1] * c + d[0] * s;
        d[0] = x;
    }
}

/* A row on f: y (fn n + ft . (x, y)) */
static void sp__refute_on_force(sp__refute *w, int32_t v, sp_real y, sp_real n, sp_real t1, sp_real t2)
{
    w->f[v][0] += y * n;
    w->f[v][1] += y * t1;
    w->f[v][2] += y * t2;
    w->fsize[v] += sp__abs(y) * (sp__abs(n) + sp__abs(t1) + sp__abs(t2));
}

/* A row on the motion of vertex v: y (dn n + dt . (t1, t2)). */
static void sp__refute_on_motion(sp__refute *w, int32_t v, sp_real y, sp_real n, sp_real t1, sp_real t2)
{
    w->d[v][0] += y * n;
    w->d[v][1] += y * t1;
    w->d[v][2] += y * t2;
    w->dsize[v] += sp__abs(y) * (sp__abs(n) + sp__abs(t1) + sp__abs(t2));
}

/* A right-hand side, y b. */
static void sp__refute_right_side(sp__refute *w, sp_real y, sp_real b)
{
    w->right += y * b;
    w->size += sp__abs(y * b);
}

/* Rows of the sector of a vertex: slip and friction between its ends, friction's cone near it.     returns 0: no such row */
SP__NOINLINE static int sp__refute_sector(sp__refute *w, int32_t v, int32_t row, sp_real y)
{
    const sp__certifier *j = w->j;
    const sp_contact *t = &j->pb->contact[w->contact[v]];
    const sp_real mu = t->joint->strength.mu * j->mu_factor;
    const int32_t faces = j->set->faces;
    int32_t h = 0, end;
    if (w->state[v] < 4) return 0;
    while (w->state[v] >> h > 7) h++;
    end = w->state[v] - (4 << h);                       /* the sector: from end to end + 1 parts of 4 2^h */
    sp_real d[2];
    if (row == 5) {                                     /* m . dt <= eta */
        if (j->set->coupled.box || y < 0) return 0;
        sp__refute_direction(2 * end + 1, h + 1, d);
        sp__refute_on_motion(w, v, y, 0, d[0], d[1]);
        sp__refute_right_side(w, y, w->k->eta);
    } else if (row < 10) {                              /* a x dt >= 0, b x dt <= 0; ft: s = SP__SLIP |ft| / fn */
        const int second = row == 7 || row == 9, force = row >= 8;
        if ((y > 0) != (second != force)) return 0;
        sp__refute_direction(end + second, h, d);
        const sp_real most = SP__SLIP * mu * SP_SQRT(1 + j->tan_half * j->tan_half);
        if (force) sp__refute_on_force(w, v, y, second ? most : -most, -d[1], d[0]);
        else sp__refute_on_motion(w, v, y, 0, -d[1], d[0]);
        if (force) w->slack += sp__abs(y) * w->any_friction[v];
    } else {                                            /* friction opposite to a, m, b, or on the three faces there */
        if (y < 0 || (faces && faces <= 8)) return 0;
        if (faces) {
            const int64_t whole = (int64_t)8 << h, face = (faces * (2 * (2 * (int64_t)end + 1) + whole) + whole) / (2 * whole);
            sp__pyramid_direction(faces, (int32_t)((face + faces + row - 11) % faces), d);
        } else {
            sp__refute_direction(2 * end + row - 10, h + 1, d);
            d[0] = -d[0]; d[1] = -d[1];
        }
        sp__refute_on_force(w, v, y, -mu, d[0], d[1]);
    }
    return 1;
}

/* Any row of a vertex, for its state.     returns 0: no such row, or not with this sign */
SP__NOINLINE static int sp__refute_vertex(sp__refute *w, int32_t v, int32_t row, sp_real y)
{
    const sp__certifier *j = w->j;
    const int32_t state = w->state[v], faces = j->set->faces;
    sp_real d[2];
    if (row >= 5 && row < 13) return sp__refute_sector(w, v, row, y);
    if (row == 0) {                                     /* -g <= dn <= eta, = -g */
        sp__refute_on_motion(w, v, y, 1, 0, 0);
        sp__refute_right_side(w, y, y > 0 && state < 2 ? w->k->eta : -w->k->eps);
    } else if (row < 5) {                               /* |dt| <= eta along 0, 45, 90, 135 degrees */
        if (row % 2 == 0 && j->set->coupled.box) return 0;
        sp__pyramid_direction(8, row - 1, d);
        sp__refute_on_motion(w, v, y, 0, d[0], d[1]);
        sp__refute_right_side(w, sp__abs(y), w->k->eta);
    } else if (row < 21) {                              /* the cone around */
        const int exact = faces && faces <= 8;
        sp_real mu = j->pb->contact[w->contact[v]].joint->strength.mu * j->mu_factor;
        if (y < 0 || (exact && row - 13 >= faces)) return 0;
        if (faces && !exact) mu *= SP_SQRT(1 + j->tan_half * j->tan_half);
        sp__pyramid_direction(exact ? faces : 8, row - 13, d);
        sp__refute_on_force(w, v, y, -mu, d[0], d[1]);
    } else {                                            /* fn >= 0; f = 0 */
        if (state != 1 && (row > 21 || y > 0)) return 0;
        sp__refute_on_force(w, v, y, row == 21, row == 22, row == 23);
    }
    return 1;
}

/* Adds one multiplier's row.     returns 0: it is not admissible, so the tree proves nothing */
static int sp__refute_add(sp__refute *w, int32_t row, sp_real y)
{
    const int32_t n = 6 * w->j->pb->blocks;
    if (row < 0 || row > n + SP__PROOF_ROWS * w->points || !sp__finite(y)) return 0;
    if (!(sp__abs(y) > 0)) return 1;
    if (row < n) {                                      /* Aeq f = -p */
        sp_real p[6];
        if (sp__held(w->j->pb, row / 6, row % 6)) return 0;
        sp__certifier_load(w->j, row / 6, p);
        w->motion[row] += y;
        sp__refute_right_side(w, y, -p[row % 6]);
        return 1;
    }
    if (row == n) { w->work += y; return y >= 0; }      /* g sum fn <= p . dq */
    return sp__refute_vertex(w, (row - n - 1) / SP__PROOF_ROWS, (row - n - 1) % SP__PROOF_ROWS, y);
}

/* c on f: what the multipliers of balance and work add, then the least c f over the box; taken off `right`. */
static sp_real sp__refute_least_force(sp__refute *w)
{
    sp__certifier *j = w->j;
    const sp_problem *pb = j->pb;
    sp_real least = 0;
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) j->dual.motion[k] = w->motion[k];
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        const sp_real mu = t->joint->strength.mu * (1 + j->tan_half);
        sp_real u[3], *f = w->f[v];
        sp__vertex_velocity(pb, NULL, t, w->at[v], j->dual.motion, u);
        f[0] += sp__dot3(u, t->joint->n) + w->work * w->k->eps;
        f[1] += sp__dot3(u, t->joint->t1);
        f[2] += sp__dot3(u, t->joint->t2);
        w->fsize[v] += sp__certifier_displacement(j, t->a) + sp__certifier_displacement(j, t->b) + w->work * w->k->eps;
        least += w->F[v] * ((f[0] < 0 ? f[0] : 0) - mu * (sp__abs(f[1]) + sp__abs(f[2])));
        w->size += (1 + mu) * w->F[v] * w->fsize[v];
    }
    return least;
}

/* c on dq, and the least c dq over the box. */
static sp_real sp__refute_least_motion(sp__refute *w)
{
    const sp__certifier *j = w->j;
    const sp_problem *pb = j->pb;
    sp_real least = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp_real p[6];
        sp__certifier_load(j, i, p);
        for (size_t k = 0; k < 6; k++) {
            w->motion[6 * (size_t)i + k] = -w->work * p[k];
            w->size += sp__abs(w->work * p[k]) * w->reach[6 * (size_t)i + k];
        }
    }
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        sp_real F[3];
        const sp_real *d = w->d[v];
        for (int k = 0; k < 3; k++) F[k] = d[0] * t->joint->n[k] + d[1] * t->joint->t1[k] + d[2] * t->joint->t2[k];
        sp__vertex_force(pb, t, w->at[v], F, w->motion, NULL);
        sp_real moved = 0;
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->a : t->b;
            if (i < 0) continue;
            const sp_real *m = w->reach + 6 * (size_t)i;
            moved += m[0] + m[1] + m[2] + (m[3] + m[4] + m[5]) * j->scale[i].arm;
        }
        w->size += w->dsize[v] * moved;
        w->slack += w->dsize[v] * (SP__GIVE + SP__GIVE_ROUNDING * moved);
    }
    for (int32_t r = 0; r < 6 * pb->blocks; r++) least -= sp__abs(w->motion[r]) * w->reach[r];
    return least;
}

/* A leaf: multipliers from..to. How far it is from proving nothing, relative to sum |y b|: above 0 is a proof; 0: none */
SP__NOINLINE static sp_real sp__refute_leaf(sp__refute *w, int32_t from, int32_t to)
{
    const sp__certifier *j = w->j;
    for (int32_t v = 0; v < w->points; v++) {
        for (int k = 0; k < 3; k++) w->f[v][k] = w->d[v][k] = 0;
        w->fsize[v] = w->dsize[v] = 0;
    }
    for (int32_t r = 0; r < 6 * j->pb->blocks; r++) w->motion[r] = 0;
    w->work = w->right = w->size = w->slack = 0;
    for (int32_t e = from; e < to; e++) if (!sp__refute_add(w, w->proof->row[e], w->proof->y[e])) return 0;
    w->slack += w->work * w->slack_of_work;
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        const sp_real *m = w->motion + 6 * (size_t)i;
        w->slack += j->set->tol * (j->scale[i].s * sp__norm3(m) + j->scale[i].S * sp__norm3(m + 3));
    }
    const sp_real scale = w->size, forces = sp__refute_least_force(w), motions = sp__refute_least_motion(w);
    const sp_real margin = forces + motions - w->right - w->slack - (32 + (sp_real)(to - from)) * (sp_real)SP_EPSILON * w->size;
    return margin > 0 ? sp__ratio(margin, scale) : 0;
}

/* A vertex splits at 0, at 2, and at 4 2^h below SP__PROOF_DEEP: no more often than the stack has room for. */
typedef char sp__refute_stack_holds_every_split[SP__PROOF_DEEP / 4 <= 1 << (SP__PROOF_DEPTH - 2) ? 1 : -1];

/* Walk the tree.     returns the least margin of its leaves, relative; 0: it proves nothing */
SP__NOINLINE static sp_real sp__refute_walk(sp__refute *w)
{
    const sp_proof *p = w->proof;
    int32_t depth = 0, entry = 0;
    sp_real least = SP__HUGE;
    for (int32_t v = 0; v < w->points; v++) w->state[v] = 0;
    for (int32_t k = 0; k < p->nodes; k++) {
        const int32_t v = p->node[k];                   /* a vertex that splits; below 0: a leaf of -v multipliers */
        if (v >= 0) {                                   /* 0 into 1, 2; 2 into 4..7; s into 2s, 2s + 1 */
            if (v >= w->points) return 0;
            const int32_t state = w->state[v];
            if (state == 1 || state >= SP__PROOF_DEEP) return 0;
            w->stack[2 * depth] = v;
            w->stack[2 * depth++ + 1] = state;
            w->state[v] = state ? 2 * state : 1;
            continue;
        }
        const int64_t to = (int64_t)entry - v;
        if (to > p->entries) return 0;
        const sp_real margin = sp__refute_leaf(w, entry, (int32_t)to);
        if (margin < least) least = margin;
        if (!(least > 0)) return 0;
        entry = (int32_t)to;
        for (; depth; depth--) {                        /* on to the next part of what was split last */
            const int32_t u = w->stack[2 * depth - 2], state = w->stack[2 * depth - 1];
            const int32_t next = w->state[u] + 1, last = state == 0 ? 2 : state == 2 ? 7 : 2 * state + 1;
            if (next <= last) { w->state[u] = next; break; }
            w->state[u] = state;
        }
        if (!depth) return k + 1 == p->nodes ? least : 0;
    }
    return 0;
}

/* Does the proof hold?     returns its least margin, 0: no */
SP__NOINLINE static sp_real sp__certify_refutation(sp__certifier *j, const sp__lengths *k, const sp_proof *proof, sp_arena *a)
{
    if (proof->nodes < 1 || proof->entries < 0 || !proof->node || !proof->row || !proof->y) return 0;
    if (sp__problem_points(j->pb) > SP_EXACT_POINTS) return 0;
    sp__refute *w = sp__take(a, 1, sizeof *w);
    if (!w) return 0;
    sp__refute_carve(w, sp__problem_points(j->pb), j->pb->blocks, a);
    if (sp__failed(a)) return 0;
    w->j = j; w->k = k; w->proof = proof;
    for (int32_t c = 0, v = 0; c < j->pb->contacts; c++)
        for (int32_t q = 0; q < j->pb->contact[c].points; q++, v++) {
            w->contact[v] = c;
            w->at[v] = j->pb->contact[c].point + q;
        }
    if (!sp__refute_reach(w)) return 0;
    sp__refute_forces(w);
    return sp__refute_walk(w);
}

#endif

#endif /* SP__PROOF_REFUTE_C */
