/* still: does a tree of cases, each closed by a Farkas vector, prove that nothing moves, whatever friction does?
 *
 *   every pair (f, a) at rest (moving.c) has  p . a = a'Ma + sum mu fn |dt| >= m_i |a_i|^2,  so what moves has p . a >= delta
 *   sum y b  <  min c x over the box of x = (f, a),  c = sum y r,  for rows r x <= b that hold in that case     [Farkas 1902]
 */
#ifndef SP__PROOF_STILL_C
#define SP__PROOF_STILL_C

#include "../scene/part.c"
#include "moving.c"

#if SP__WITH_STRONG

#define SP__STILL SP__MOVES             /* acceleration of a block, in its load / mass, that counts as none */
#define SP__STILL_CAP ((sp_real)1e4)    /* forces up to so many times sbar are counted with */
#define SP__STILL_POINTS 16             /* corners up to which cases are told apart */
#define SP__STILL_DEPTH 16              /* splits above a leaf, for every corner */
#define SP__STILL_DEEP (1 << 12)        /* a sector of this state is not halved any more */

/* States of a corner, 0 into 1, 2; 2 into 3..7; s > 3 into 2s, 2s + 1:
 *     0 unknown;  1 open: f = 0;  2 closed: dn = 0;  3 sticks: dt = 0;  4..7 slips within a quarter, then halves of it: dt is
 *     between its ends a, b, its middle is m: ft = -mu fn dt / |dt| is between -a, -b and m . ft <= -mu fn cos(half the sector)
 * Rows of a corner: */
enum {
    SP__STILL_GAP,                      /* dn >= 0, = 0 */
    SP__STILL_SLIP,                     /* 2: dt = 0 */
    SP__STILL_ENDS = 3,                 /* 2: a x dt >= 0, b x dt <= 0 */
    SP__STILL_RUB = 5,                  /* 2: a x ft <= 0, b x ft >= 0 */
    SP__STILL_FULL = 7,                 /* m . ft + mu cos fn <= 0 */
    SP__STILL_CONE = 8,                 /* 8: d . ft <= mu fn, every 45 degrees */
    SP__STILL_NEAR = 16,                /* 3: the same for d = -a, -m, -b */
    SP__STILL_FORCE = 19,               /* 3: fn >= 0; f = 0 */
    SP__STILL_ROWS = 22
};

typedef struct sp__still {
    sp__certifier *j;
    const sp__inertia *M;
    const sp_proof *proof;
    int32_t points;                     /* V */
    int32_t *contact, *at, *state;      /* V */
    int32_t *stack;                     /* 2 x SP__STILL_DEPTH x V: corner, state before */
    sp_real (*f)[3], (*d)[3];           /* V: c on f and on d, contact frame */
    sp_real *size;                      /* V: sizes of what was added up in c on d */
    sp_real *motion, *c;                /* 6b: multipliers of M a = p + Aeq f; c on a */
    sp_real *reach;                     /* 6b: most |a| */
    sp_real delta, work, right, rounding;
} sp__still;

static void sp__still_carve(sp__still *w, int32_t points, int32_t blocks, sp_arena *a)
{
    const size_t n = (size_t)points;
    w->points = points;
    w->contact = sp__take(a, n, sizeof *w->contact);
    w->at = sp__take(a, n, sizeof *w->at);
    w->state = sp__take(a, n, sizeof *w->state);
    w->stack = sp__take(a, n, 2 * SP__STILL_DEPTH * sizeof *w->stack);
    w->f = sp__take(a, n, sizeof *w->f);
    w->d = sp__take(a, n, sizeof *w->d);
    w->size = sp__take(a, n, sizeof *w->size);
    w->motion = sp__take(a, (size_t)blocks, 6 * sizeof *w->motion);
    w->c = sp__take(a, (size_t)blocks, 6 * sizeof *w->c);
    w->reach = sp__take(a, (size_t)blocks, 6 * sizeof *w->reach);
}

SP__NOINLINE static size_t sp__still_need(int32_t points, int32_t blocks)
{
    sp__still w;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof w);
    sp__still_carve(&w, points, blocks, &dry);
    return dry.used;
}

/* delta = least m (SP__STILL load / m)^2 of a block; 0 where one has no load or no known inertia. */
SP__NOINLINE static sp_real sp__still_delta(const sp__certifier *j, const sp__inertia *M)
{
    sp_real delta = SP__HUGE;
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        const sp_real a = SP__STILL * sp__ratio(sp__in_newtons(j->unit, j->scale[i].load), M[i].mass);
        const sp_real least = M[i].known ? j->scale[i].load * SP__STILL * a : 0;
        if (least < delta) delta = least;
    }
    return delta < SP__HUGE ? delta : 0;
}

/* |a|_M <= |p|_M^-1 =: P, so |a_k| <= P sqrt((M^-1)_kk) */
static void sp__still_reach(sp__still *w)
{
    const sp_problem *pb = w->j->pb;
    sp_real P = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp_real a[6] = { 0, 0, 0, 0, 0, 0 };
        sp__inertia_accelerate(&w->M[i], pb->p + 6 * (size_t)i, a);
        P += sp__dot(pb->p + 6 * (size_t)i, a, 6);
    }
    P = SP_SQRT(sp__max(0, P)) * (sp_real)1.01;
    for (int32_t i = 0; i < pb->blocks; i++)
        for (int k = 0; k < 3; k++) {
            w->reach[6 * i + k] = P * SP_SQRT(w->M[i].inverse[k]);
            w->reach[6 * i + 3 + k] = P * SP_SQRT(sp__max(0, w->M[i].turn[k][k]));
        }
}

/* Unit vector at `end` parts of 4 2^h of a turn after the x axis, by the half-angle formulas. */
static void sp__still_direction(int32_t end, int32_t h, sp_real d[2])
{
    sp_real c = 0, s = 1;
    d[0] = 1; d[1] = 0;
    for (int32_t q = end >> h; q > 0; q--) { const sp_real x = d[0]; d[0] = -d[1]; d[1] = x; }
    for (int32_t bit = h - 1; bit >= 0; bit--) {
        const sp_real half = SP_SQRT((1 + c) / 2);
        s = s / (2 * half);
        c = half;
        if (!(end >> bit & 1)) continue;
        const sp_real x = d[0], y = d[1];
        d[0] = -(y * s - x * c);                        /* so said that gcc at -O3 does not fuse it */
        d[1] = x * s + y * c;
    }
}

/* Ends and middle of the sector of a state > 3: w[0], w[2] and w[1]. */
static void sp__still_sector(int32_t state, sp_real w[3][2])
{
    int32_t h = 0;
    while (state >> h > 7) h++;
    const int32_t first = 2 * (state - (4 << h));
    for (int32_t k = 0; k < 3; k++) sp__still_direction(first + k, h + 1, w[k]);
}

/* Which signs the multiplier of a row may have in a state: 1 y >= 0, -1 y <= 0, 2 both, 0 no such row. */
static int sp__still_sign(int32_t state, int32_t row)
{
    if (row == SP__STILL_GAP) return state < 2 ? -1 : 2;
    if (row < SP__STILL_ENDS) return state == 3 ? 2 : 0;
    if (row >= SP__STILL_CONE && row < SP__STILL_NEAR) return 1;
    if (row >= SP__STILL_FORCE) return state == 1 ? 2 : row == SP__STILL_FORCE ? -1 : 0;
    if (state < 4) return 0;
    return row == SP__STILL_ENDS || row == SP__STILL_RUB + 1 ? -1 : 1;
}

/* Row of a corner: r[0..2] on f, r[3..5] on d. */
static void sp__still_row(int32_t state, int32_t row, sp_real mu, sp_real r[6])
{
    sp_real w[3][2];
    for (int k = 0; k < 6; k++) r[k] = 0;
    if (row < SP__STILL_ENDS) r[3 + row] = 1;
    else if (row >= SP__STILL_FORCE) r[row - SP__STILL_FORCE] = 1;
    else if (row >= SP__STILL_CONE && row < SP__STILL_NEAR) {
        sp__pyramid_direction(8, row - SP__STILL_CONE, r + 1);
        r[0] = -mu;
    } else if (state > 3) {
        sp__still_sector(state, w);
        const int32_t k = row >= SP__STILL_NEAR ? row - SP__STILL_NEAR : row == SP__STILL_FULL ? 1 : row % 2 ? 0 : 2;
        const sp_real *e = w[k];
        if (row < SP__STILL_RUB) { r[4] = -e[1]; r[5] = e[0]; }
        else if (row < SP__STILL_FULL) { r[1] = -e[1]; r[2] = e[0]; }
        else if (row == SP__STILL_FULL) { r[0] = mu * (w[0][0] * e[0] + w[0][1] * e[1]); r[1] = e[0]; r[2] = e[1]; }
        else { r[0] = -mu; r[1] = -e[0]; r[2] = -e[1]; }
    }
}

/* Adds a multiplier's row.     returns 0: it is not admissible */
static int sp__still_add(sp__still *w, int32_t row, sp_real y)
{
    const sp__certifier *j = w->j;
    const int32_t n = 6 * j->pb->blocks;
    if (row < 0 || row > n + SP__STILL_ROWS * w->points || !sp__finite(y)) return 0;
    if (!(sp__abs(y) > 0)) return 1;
    if (row < n) {                                      /* M a - Aeq f = p */
        if (sp__held(j->pb, row / 6, row % 6)) return 0;
        const sp_real p = sp__in_units(j->unit, j->pb->p[row]);
        w->motion[row] += y;
        w->right += y * p;
        w->rounding += sp__abs(y * p);
        return 1;
    }
    if (row == n) { w->work += y; return y >= 0; }      /* -p . a <= -delta */
    const int32_t v = (row - n - 1) / SP__STILL_ROWS, q = (row - n - 1) % SP__STILL_ROWS;
    const int sign = sp__still_sign(w->state[v], q);
    sp_real r[6];
    if (!sign || (sign < 2 && (y > 0) != (sign > 0))) return 0;
    sp__still_row(w->state[v], q, j->pb->contact[w->contact[v]].joint->strength.mu, r);
    for (int k = 0; k < 3; k++) {
        w->f[v][k] += y * r[k];
        w->d[v][k] += y * r[3 + k];
        w->size[v] += sp__abs(y) * (sp__abs(r[k]) + sp__abs(r[3 + k]));
    }
    return 1;
}

/* c on f, -Aeq' y and the rows of the corner; the least c f over 0 <= fn <= F, |ft| <= mu fn. */
static sp_real sp__still_least_force(sp__still *w)
{
    const sp__certifier *j = w->j;
    const sp_problem *pb = j->pb;
    const sp_real ease = j->set->force_bound < SP__STILL_CAP ? 1 : SP__STILL_CAP / j->set->force_bound;
    sp_real least = 0;
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        const sp_real mu = t->joint->strength.mu, F = ease * sp__certifier_force_cap(j, t);
        sp_real u[3], size = w->size[v];
        sp__vertex_velocity(pb, NULL, t, w->at[v], w->motion, u);
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->a : t->b;
            const sp_real *y = w->motion + 6 * (size_t)(i < 0 ? 0 : i);
            if (i >= 0) size += sp__norm3(y) + sp__norm3(y + 3) * j->scale[i].arm;
        }
        sp__joint_frame(t->joint, u, u);
        const sp_real t1 = w->f[v][1] - u[1], t2 = w->f[v][2] - u[2];
        const sp_real worst = w->f[v][0] - u[0] - mu * SP_SQRT(t1 * t1 + t2 * t2);
        if (worst < 0) least += F * worst;
        w->rounding += (1 + mu) * F * size;
    }
    return least;
}

/* c on a, M y - work p + Aeq (rows on d), and the least c a over |a| <= reach. */
static sp_real sp__still_least_motion(sp__still *w)
{
    const sp__certifier *j = w->j;
    const sp_problem *pb = j->pb;
    sp_real least = 0;
    for (int32_t i = 0; i < pb->blocks; i++)
        for (int k = 0; k < 3; k++) {
            const size_t r = 6 * (size_t)i + (size_t)k;
            const sp_real *y = w->motion + 6 * (size_t)i, px = sp__in_units(j->unit, pb->p[r] * w->work);
            const sp_real pm = sp__in_units(j->unit, pb->p[r + 3] * w->work);
            w->c[r] = sp__in_units(j->unit, w->M[i].mass * y[k]) - px;
            w->c[r + 3] = sp__in_units(j->unit, sp__dot3(w->M[i].J[k], y + 3)) - pm;
            w->rounding += w->reach[r] * (sp__abs(w->c[r]) + 2 * sp__abs(px));
            w->rounding += w->reach[r + 3] * (sp__in_units(j->unit, sp__norm3(w->M[i].J[k])) * sp__norm3(y + 3) + sp__abs(pm));
        }
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        sp_real F[3];
        sp__joint_force(t->joint, w->d[v], F);
        sp__vertex_force(pb, t, w->at[v], F, w->c, NULL);
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->a : t->b;
            const sp_real *m = w->reach + 6 * (size_t)(i < 0 ? 0 : i);
            if (i >= 0) w->rounding += w->size[v] * (m[0] + m[1] + m[2] + (m[3] + m[4] + m[5]) * j->scale[i].arm);
        }
    }
    for (int32_t r = 0; r < 6 * pb->blocks; r++) least -= sp__abs(w->c[r]) * w->reach[r];    /* held: reach is 0 */
    return least;
}

/* A leaf: multipliers from..to. Its margin relative to what delta gives; 0: no proof */
SP__NOINLINE static sp_real sp__still_leaf(sp__still *w, int32_t from, int32_t to)
{
    memset(w->f, 0, (size_t)w->points * sizeof *w->f);
    memset(w->d, 0, (size_t)w->points * sizeof *w->d);
    memset(w->size, 0, (size_t)w->points * sizeof *w->size);
    memset(w->motion, 0, 6 * (size_t)w->j->pb->blocks * sizeof *w->motion);
    w->work = w->right = w->rounding = 0;
    for (int32_t e = from; e < to; e++) if (!sp__still_add(w, w->proof->row[e], w->proof->y[e])) return 0;
    w->right -= w->work * w->delta;
    w->rounding += w->work * w->delta;
    const sp_real least = sp__still_least_force(w) + sp__still_least_motion(w);
    const sp_real margin = least - w->right - (32 + (sp_real)(to - from)) * (sp_real)SP_EPSILON * w->rounding;
    return margin > 0 ? sp__ratio(margin, w->rounding) : 0;
}

/* How many states a state splits into, and the first. */
static int32_t sp__still_children(int32_t state, int32_t *first)
{
    *first = state == 0 ? 1 : state == 2 ? 3 : 2 * state;
    return state == 2 ? 5 : 2;
}

/* A corner splits at 0, at 2, and at 4 2^h below SP__STILL_DEEP: no more often than the stack has room for. */
typedef char sp__still_stack_holds_every_split[SP__STILL_DEEP / 4 <= 1 << (SP__STILL_DEPTH - 2) ? 1 : -1];

/* Walk the tree.     returns the least margin of its leaves; 0: it proves nothing */
SP__NOINLINE static sp_real sp__still_walk(sp__still *w)
{
    const sp_proof *p = w->proof;
    int32_t depth = 0, entry = 0, first;
    sp_real least = SP__HUGE;
    memset(w->state, 0, (size_t)w->points * sizeof *w->state);
    for (int32_t k = 0; k < p->nodes; k++) {
        const int32_t v = p->node[k];                   /* a vertex that splits; below 0: a leaf of -v multipliers */
        if (v >= 0) {
            if (v >= w->points) return 0;
            const int32_t state = w->state[v];
            if (state == 1 || state == 3 || state >= SP__STILL_DEEP) return 0;
            w->stack[2 * depth] = v;
            w->stack[2 * depth++ + 1] = state;
            sp__still_children(state, &w->state[v]);
            continue;
        }
        const int64_t to = (int64_t)entry - v;
        if (to > p->entries) return 0;
        const sp_real margin = sp__still_leaf(w, entry, (int32_t)to);
        if (margin < least) least = margin;
        if (!(least > 0)) return 0;
        entry = (int32_t)to;
        for (; depth; depth--) {                        /* on to the next part of what was split last */
            const int32_t u = w->stack[2 * depth - 2], state = w->stack[2 * depth - 1];
            const int32_t next = w->state[u] + 1, children = sp__still_children(state, &first);
            if (next < first + children) { w->state[u] = next; break; }
            w->state[u] = state;
        }
        if (!depth) return k + 1 == p->nodes ? least : 0;
    }
    return 0;
}

/* Does the proof hold? M: of all blocks.     returns its least margin, 0: no */
SP__NOINLINE static sp_real sp__certify_still(sp__certifier *j, const sp__inertia *M, const sp_proof *proof, sp_arena *a)
{
    const sp_problem *pb = j->pb;
    const int32_t points = sp__problem_points(pb);
    if (proof->nodes < 1 || proof->entries < 0 || !proof->node || !proof->row || !proof->y) return 0;
    if (points > SP__STILL_POINTS || pb->blocks > SP__STILL_POINTS) return 0;
    sp__still *w = sp__take(a, 1, sizeof *w);
    if (!w) return 0;
    sp__still_carve(w, points, pb->blocks, a);
    if (sp__failed(a)) return 0;
    w->j = j; w->M = M; w->proof = proof;
    w->delta = sp__still_delta(j, M);
    if (!(w->delta > 0)) return 0;
    for (int32_t c = 0, v = 0; c < pb->contacts; c++)
        for (int32_t q = 0; q < pb->contact[c].points; q++, v++) {
            w->contact[v] = c;
            w->at[v] = pb->contact[c].point + q;
        }
    sp__still_reach(w);
    return sp__still_walk(w);
}

#endif

#endif /* SP__PROOF_STILL_C */
