/* decide: does any triple (f, dq, alpha) exist? Branch and bound over the states of corners, a linear program in each case. */
#ifndef SP__COUPLED_DECIDE_C
#define SP__COUPLED_DECIDE_C

#include "../linear/lp.c"
#include "../proof/refute.c"

#ifndef SP_NO_CRA
/* Whether any triple exists, by branch and bound. d = Aeq' dq / L, g = eps / L (1, or 0), reach = eta / L:
 *
 *     Aeq f + p = 0,  f in K;   -g <= dn <= reach,  |dt| <= reach;   fn (dn + g) = 0;   ft = -alpha dt, alpha >= 0
 *
 * The first two are (bounded by) linear rows. The others are by cases, a state for every vertex:
 *     0          unknown                       nothing
 *     1          open                          f = 0
 *     2          engaged                       dn = -g
 *     4..7       engaged, slip in a quarter    dt and -ft both between the ends a, b of the sector; 2s and 2s + 1 halve s
 * All states are covered by 1 and 2; 2 by 4..7; s by 2s and 2s + 1. Whatever the states, p.dq = -f.d = g sum fn - sum ft.dt
 * (virtual work), so g sum fn <= p . dq joins f and dq. A node is one linear program over (f, dq); where it has no point, its
 * Farkas vector is kept. Where its point meets all conditions, no finer state would exclude it, and the search ends.
 */
#define SP__BRANCH_DEEP (1 << 24)       /* a sector of this state is not halved any more: 4e-7 rad */

/* Rows of the program: 6b of balance, one of work, then of every vertex: */
enum {
    SP__ROW_GAP,                        /* dn */
    SP__ROW_SLIP,                       /* 4: dt along 0, 45, 90, 135 degrees of (t1, t2) */
    SP__ROW_AHEAD = 5,                  /* dt along the middle of the sector */
    SP__ROW_ENDS,                       /* 2: a x dt >= 0, b x dt <= 0 */
    SP__ROW_RUB = 8,                    /* 2: a x ft <= s fn, b x ft >= -s fn, s = SP__SLIP of the most |ft| / fn */
    SP__ROW_NEAR = 10,                  /* 3: friction in the sector: its ends and middle, or the three faces nearest */
    SP__ROW_CONE = 13,                  /* 8: friction around: the pyramid's faces, or every 45 degrees */
    SP__ROWS = 21
};

/* A node that was split: its vertex, the state before, how many children are done. Of a search by cases (point.c): the child it
 * began with, how many were left behind although they led on, and whether the one at hand does. */
typedef struct sp__frame { int32_t vertex, state; int8_t child, begin, missed, leads; } sp__frame;

typedef struct sp__branch {
    const sp_problem *pb;
    const sp_settings *set;
    const sp__certifier *j;                   /* for the scales of blocks */
    sp__lengths k;
    sp__lp lp;
    int32_t points;                     /* V: vertices that take part */
    sp_real outer;                      /* of a pyramid: radius of its edges / of its faces */
    sp_real *arm, *load;                /* b: longest arm [m], sbar [j->unit] */
    int32_t *contact, *at;              /* V: contact and point of the scene */
    sp_real (*d)[3][12];                /* V: rows n, t1, t2 of Aeq' on the motions of b and a, rotations times arm */
    sp_real *mu, *size;                 /* V: friction in force; force of one unit of f [unit] */
    int32_t *state, *loaded;            /* V: of the node; in the program */
    sp__frame *stack;
    int32_t depth;
    sp_proof *proof;
    int32_t nodes, entries;             /* the proof has room for */
} sp__branch;

/* Entries of the program's rows: balance 18 a vertex and side, work, 8 rows of motion, 13 x 3 of force. */
static int32_t sp__branch_entries(const sp_problem *pb)
{
    int32_t sides = 0, points = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sides += t->points * ((t->a >= 0) + (t->b >= 0));
        points += t->points;
    }
    return sides * (18 + 6 * 8) + points * (1 + 13 * 3) + 6 * pb->blocks;
}

static void sp__branch_carve(sp__branch *s, const sp_problem *pb, sp_arena *a)
{
    const int32_t V = sp__problem_points(pb), b = pb->blocks;
    const size_t v = (size_t)V;
    s->pb = pb;
    s->points = V;
    sp__lp_carve(&s->lp, 3 * V + 6 * b, 6 * b + 1 + SP__ROWS * V, sp__branch_entries(pb), a);
    s->arm = sp__take(a, (size_t)b, sizeof *s->arm);
    s->load = sp__take(a, (size_t)b, sizeof *s->load);
    s->contact = sp__take(a, v, sizeof *s->contact);
    s->at = sp__take(a, v, sizeof *s->at);
    s->d = sp__take(a, v, sizeof *s->d);
    s->mu = sp__take(a, v, sizeof *s->mu);
    s->size = sp__take(a, v, sizeof *s->size);
    s->state = sp__take(a, v, sizeof *s->state);
    s->loaded = sp__take(a, v, sizeof *s->loaded);
    s->stack = sp__take(a, v, SP__PROOF_DEPTH * sizeof *s->stack);
}

/* Ends a, b of the sector of a state >= 4, and its middle m. */
static void sp__sector(int32_t state, sp_real a[2], sp_real m[2], sp_real b[2])
{
    int32_t halvings = 0;
    while (state >> halvings > 7) halvings++;
    const int32_t quarter = (state >> halvings) - 4;
    a[0] = quarter == 0 ? (sp_real)1 : quarter == 2 ? (sp_real)-1 : 0;
    a[1] = quarter == 1 ? (sp_real)1 : quarter == 3 ? (sp_real)-1 : 0;
    b[0] = -a[1]; b[1] = a[0];
    for (;; halvings--) {
        const sp_real x = a[0] + b[0], y = a[1] + b[1], l = SP_SQRT(x * x + y * y);
        m[0] = x / l; m[1] = y / l;
        if (!halvings) return;
        sp_real *end = state >> (halvings - 1) & 1 ? a : b;
        end[0] = m[0]; end[1] = m[1];
    }
}

/* The face of K opposite to the middle of a sector: (2i + 1) / (8 2^h) + 1/2 of a turn, to the nearest of K. */
static int32_t sp__sector_face(int32_t state, int32_t K)
{
    int32_t h = 0;
    while (state >> h > 7) h++;
    const int64_t i = state - ((int64_t)4 << h), turn = (int64_t)8 << h;
    return (int32_t)((K * (2 * (2 * i + 1) + turn) + turn) / (2 * turn) % K);
}

/* Row `row` of the program gets values: x n + y t1 + z t2 of the motion at vertex v. */
static void sp__branch_motion_row(sp__branch *s, int32_t v, int32_t row, sp_real x, sp_real y, sp_real z)
{
    sp_real *to = s->lp.value + s->lp.start[row];
    const int32_t n = s->lp.start[row + 1] - s->lp.start[row];
    for (int32_t e = 0; e < n; e++) to[e] = x * s->d[v][0][e] + y * s->d[v][1][e] + z * s->d[v][2][e];
}

/* Number of row `which` of vertex v in the program. */
static int32_t sp__branch_row(const sp__branch *s, int32_t v, int32_t which)
{
    return 6 * s->pb->blocks + 1 + SP__ROWS * v + which;
}

/* x fn + y ft1 + z ft2 */
static void sp__branch_force_row(sp__branch *s, int32_t row, sp_real x, sp_real y, sp_real z)
{
    sp_real *to = s->lp.value + s->lp.start[row];
    to[0] = x; to[1] = y; to[2] = z;
}

/* Bounds of a row: low <= row x <= high. */
static void sp__branch_bound(sp__branch *s, int32_t row, sp_real low, sp_real high)
{
    s->lp.lower[row] = low;
    s->lp.upper[row] = high;
}

/* Friction within the sector: d . ft <= mu fn for directions opposite to its ends and its middle, or for the faces there. */
static void sp__branch_friction(sp__branch *s, int32_t v, int32_t state, const sp_real a[2], const sp_real m[2],
                                const sp_real b[2])
{
    const int32_t K = s->set->faces, row = sp__branch_row(s, v, SP__ROW_NEAR);
    if (K && K <= 8) return;
    for (int32_t q = 0; q < 3; q++) {
        const sp_real *w = q == 0 ? a : q == 1 ? m : b;
        sp_real face[2] = { -w[0], -w[1] };
        if (K) sp__pyramid_direction(K, (sp__sector_face(state, K) + K + q - 1) % K, face);
        sp__lp_deactivate(&s->lp, row + q);
        sp__branch_force_row(s, row + q, -s->mu[v], face[0], face[1]);
        sp__branch_bound(s, row + q, -SP__LP_FREE, 0);
    }
}

/* Rows of the sector of vertex v. */
SP__NOINLINE static void sp__branch_sector(sp__branch *s, int32_t v, int32_t state)
{
    sp_real a[2], m[2], b[2];
    const int32_t ends = sp__branch_row(s, v, SP__ROW_ENDS), rub = sp__branch_row(s, v, SP__ROW_RUB);
    const int32_t ahead = sp__branch_row(s, v, SP__ROW_AHEAD);
    sp__sector(state, a, m, b);
    for (int32_t q = 0; q < 2; q++) {
        const sp_real *w = q ? b : a;
        sp__lp_deactivate(&s->lp, ends + q);
        sp__lp_deactivate(&s->lp, rub + q);
        sp__branch_motion_row(s, v, ends + q, 0, -w[1], w[0]);
        sp__branch_force_row(s, rub + q, (q ? SP__SLIP : -SP__SLIP) * s->outer * s->mu[v], -w[1], w[0]);
        sp__branch_bound(s, ends + q, q ? -SP__LP_FREE : 0, q ? 0 : SP__LP_FREE);
        sp__branch_bound(s, rub + q, q ? 0 : -SP__LP_FREE, q ? SP__LP_FREE : 0);
    }
    sp__lp_deactivate(&s->lp, ahead);
    sp__branch_motion_row(s, v, ahead, 0, m[0], m[1]);
    sp__branch_bound(s, ahead, -SP__LP_FREE, s->set->coupled.box ? SP__LP_FREE : s->k.eta);
    sp__branch_friction(s, v, state, a, m, b);
}

/* The program's rows of vertex v for a state. */
static void sp__branch_set_state(sp__branch *s, int32_t v, int32_t state)
{
    const int32_t gap = sp__branch_row(s, v, SP__ROW_GAP), f = s->lp.m + 3 * v;
    if (s->loaded[v] == state) return;
    s->loaded[v] = state;
    const sp_real most = state == 1 ? 0 : SP__LP_FREE;
    sp__branch_bound(s, gap, -s->k.eps, state < 2 ? s->k.eta : -s->k.eps);
    sp__branch_bound(s, f, 0, most);
    sp__branch_bound(s, f + 1, -most, most);
    sp__branch_bound(s, f + 2, -most, most);
    for (int32_t q = SP__ROW_AHEAD; q < SP__ROW_CONE; q++)
        sp__branch_bound(s, sp__branch_row(s, v, q), -SP__LP_FREE, SP__LP_FREE);
    if (state >= 4) sp__branch_sector(s, v, state);
}

/* d of vertex v: +-(e, (r - c) x e / arm) on b and a. */
static void sp__branch_vertex(sp__branch *s, int32_t v, const sp_contact *t, const sp_real local[3])
{
    const sp_joint *o = t->joint;
    for (int q = 0; q < 3; q++) {
        const sp_real *e = q == 0 ? o->n : q == 1 ? o->t1 : o->t2;
        sp_real *to = s->d[v][q];
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->a : t->b;
            const sp_real *from = side ? t->ra : t->rb, sign = side ? (sp_real)-1 : (sp_real)1;
            sp_real r[3], m[3];
            if (i < 0) continue;
            for (int k = 0; k < 3; k++) r[k] = from[k] + local[0] * o->n[k] + local[1] * o->t1[k] + local[2] * o->t2[k];
            sp__cross3(r, e, m);
            for (int k = 0; k < 3; k++) { *to++ = sign * e[k]; }
            for (int k = 0; k < 3; k++) { *to++ = sign * m[k] / s->arm[i]; }
        }
    }
}

/* Longest arms, and what a block has to carry. */
static void sp__branch_scales(sp__branch *s)
{
    const sp_problem *pb = s->pb;
    for (int32_t i = 0; i < pb->blocks; i++) s->arm[i] = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t p = t->point; p < t->point + t->points; p++)
            for (int side = 0; side < 2; side++) {
                const int32_t i = side ? t->a : t->b;
                if (i < 0) continue;
                sp_real r[3];
                for (int k = 0; k < 3; k++)
                    r[k] = (side ? t->ra : t->rb)[k] + pb->local[p][0] * t->joint->n[k] + pb->local[p][1] * t->joint->t1[k]
                           + pb->local[p][2] * t->joint->t2[k];
                s->arm[i] = sp__max(s->arm[i], sp__norm3(r));
            }
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (!(s->arm[i] > 0)) s->arm[i] = 1;
        s->load[i] = s->j->scale[i].s > 0 ? s->j->scale[i].s : 1;
    }
}

/* One more entry of the row being written. */
static void sp__branch_add_entry(sp__branch *s, int32_t *e, int32_t variable, sp_real value)
{
    s->lp.index[*e] = variable;
    s->lp.value[(*e)++] = value;
}

/* Rows of balance and work: sum d' size f / load = -p / load of every block;  g sum size fn - p . dq <= 0. */
static void sp__branch_balance(sp__branch *s, int32_t *e)
{
    const sp_problem *pb = s->pb;
    const int32_t z = 3 * s->points;
    for (int32_t r = 0; r < 6 * pb->blocks; r++) {
        const int32_t i = r / 6, k = r % 6;
        const sp_real p = sp__in_units(s->j->unit, pb->p[r]) / (k < 3 ? 1 : s->arm[i]);
        const int held = sp__held(pb, i, k);
        s->lp.start[r] = *e;
        for (int32_t v = 0; v < s->points; v++) {
            const sp_contact *t = &pb->contact[s->contact[v]];
            if (t->a != i && t->b != i) continue;
            const int32_t at = k + (t->b >= 0 && t->a == i ? 6 : 0);
            for (int32_t q = 0; q < 3; q++) sp__branch_add_entry(s, e, 3 * v + q, s->d[v][q][at] * s->size[v] / s->load[i]);
        }
        sp__branch_bound(s, r, held ? -SP__LP_FREE : -p / s->load[i], held ? SP__LP_FREE : -p / s->load[i]);
        sp__branch_bound(s, s->lp.m + z + r, held ? 0 : -SP__LP_FREE, held ? 0 : SP__LP_FREE);
    }
    s->lp.start[6 * pb->blocks] = *e;
    for (int32_t v = 0; v < s->points; v++) sp__branch_add_entry(s, e, 3 * v, s->k.eps * s->size[v]);
    for (int32_t r = 0; r < 6 * pb->blocks; r++)
        sp__branch_add_entry(s, e, z + r, -sp__in_units(s->j->unit, pb->p[r]) / (r % 6 < 3 ? 1 : s->arm[r / 6]));
    sp__branch_bound(s, 6 * pb->blocks, -SP__LP_FREE, 0);
}

/* Pattern and the fixed rows of vertex v. */
static void sp__branch_fixed(sp__branch *s, int32_t v, int32_t *e)
{
    const sp_contact *t = &s->pb->contact[s->contact[v]];
    const int32_t K = s->set->faces, z = 3 * s->points;
    for (int32_t q = 0; q < SP__ROWS; q++) {
        s->lp.start[sp__branch_row(s, v, q)] = *e;
        sp__branch_bound(s, sp__branch_row(s, v, q), -SP__LP_FREE, SP__LP_FREE);
        if (q < SP__ROW_RUB) {
            for (int side = 0; side < 2; side++) {
                const int32_t i = side ? t->a : t->b;
                for (int32_t k = 0; i >= 0 && k < 6; k++) sp__branch_add_entry(s, e, z + 6 * i + k, 0);
            }
        } else {
            for (int32_t k = 0; k < 3; k++) sp__branch_add_entry(s, e, 3 * v + k, 0);
        }
    }
    s->lp.start[sp__branch_row(s, v, SP__ROWS)] = *e;
    sp__branch_motion_row(s, v, sp__branch_row(s, v, SP__ROW_GAP), 1, 0, 0);
    for (int32_t q = 0; q < 4; q++) {
        sp_real w[2];
        sp__pyramid_direction(8, q, w);
        sp__branch_motion_row(s, v, sp__branch_row(s, v, SP__ROW_SLIP + q), 0, w[0], w[1]);
        if (q % 2 == 0 || !s->set->coupled.box)
            sp__branch_bound(s, sp__branch_row(s, v, SP__ROW_SLIP + q), -s->k.eta, s->k.eta);
    }
    for (int32_t q = 0; q < 8; q++) {
        const int32_t exact = K && K <= 8;
        sp_real w[2];
        if (exact && q >= K) continue;
        sp__pyramid_direction(exact ? K : 8, q, w);
        sp__branch_force_row(s, sp__branch_row(s, v, SP__ROW_CONE + q), -s->mu[v] * (exact ? 1 : s->outer), w[0], w[1]);
        sp__branch_bound(s, sp__branch_row(s, v, SP__ROW_CONE + q), -SP__LP_FREE, 0);
    }
}

/* The root program. */
SP__NOINLINE static void sp__branch_make(sp__branch *s)
{
    const sp_problem *pb = s->pb;
    sp_real c = 1, tangent = 0;
    int32_t e = 0, v = 0;
    if (s->set->faces) sp__pyramid_half(s->set->faces, &c, &tangent);
    if (!s->set->inscribed) c = 1;
    s->outer = SP_SQRT(1 + tangent * tangent);
    sp__branch_scales(s);
    for (int32_t k = 0; k < pb->contacts; k++) {
        const sp_contact *t = &pb->contact[k];
        for (int32_t p = t->point; p < t->point + t->points; p++, v++) {
            s->contact[v] = k;
            s->at[v] = p;
            s->mu[v] = c * t->joint->strength.mu;
            s->size[v] = sp__least_of_blocks(t, s->load, 1);
            s->state[v] = 0;
            s->loaded[v] = -1;
            sp__branch_vertex(s, v, t, pb->local[p]);
        }
    }
    sp__branch_balance(s, &e);
    for (v = 0; v < s->points; v++) sp__branch_fixed(s, v, &e);
    sp__lp_start(&s->lp);
}

/* d of vertex v at the program's point. */
static void sp__branch_displacement(const sp__branch *s, int32_t v, sp_real d[3])
{
    const int32_t row = sp__branch_row(s, v, SP__ROW_GAP);
    d[0] = d[1] = d[2] = 0;
    for (int32_t q = 0; q < 3; q++)
        for (int32_t e = s->lp.start[row]; e < s->lp.start[row + 1]; e++)
            d[q] += s->d[v][q][e - s->lp.start[row]] * s->lp.x[s->lp.index[e]];
}

#ifdef SP_REAL_FLOAT
#define SP__BRANCH_DUST ((sp_real)1e-3) /* force or gap that counts as none */
#else
#define SP__BRANCH_DUST ((sp_real)1e-7)
#endif

/* The vertex to branch on: of the unknown the one that presses and gapes most, by its gap; then of those not open the one with
 * the most friction across its slip, as a force, times the width of its sector. -1:
 * the point meets all conditions as closely as states can tell. */
static int32_t sp__branch_pick(const sp__branch *s)
{
    int32_t pick = -1;
    sp_real worst = 0;
    for (int pass = 0; pass < 2 && pick < 0; pass++)
        for (int32_t v = 0; v < s->points; v++) {
            const sp_real *f = s->lp.x + 3 * v;
            sp_real d[3], width = 4;
            if (s->state[v] == 1 || (!pass && s->state[v] > 0) || s->state[v] >= SP__BRANCH_DEEP) continue;
            sp__branch_displacement(s, v, d);
            const sp_real ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]), dt = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
            const sp_real x = pass ? ft : f[0], y = pass ? dt : d[0] + s->k.eps, along = f[1] * d[1] + f[2] * d[2];
            if (x <= SP__BRANCH_DUST || y <= SP__BRANCH_DUST) continue;
            const sp_real across = along > 0 ? ft : sp__abs(f[1] * d[2] - f[2] * d[1]) / dt;
            if (pass && across * dt <= SP__BRANCH_DUST) continue;
            for (int32_t q = s->state[v]; q > 3; q /= 2) width /= 2;
            const sp_real value = pass ? s->size[v] * across * width : y;
            if (value > worst) { worst = value; pick = v; }
        }
    return pick;
}

/* Number of a constraint in the proof: rows as they are, bounds of f after the rows of their vertex; -1: a bound of dq. */
static int32_t sp__branch_proof_row(const sp__branch *s, int32_t i)
{
    const int32_t base = 6 * s->pb->blocks + 1, v = i < s->lp.m ? (i - base) / SP__ROWS : (i - s->lp.m) / 3;
    if (i < base) return i;
    if (i < s->lp.m) return i + 3 * v;
    return i < s->lp.m + 3 * s->points ? base + (SP__ROWS + 3) * v + SP__ROWS + (i - s->lp.m) % 3 : -1;
}

/* Factor from a multiplier of the scaled row of a constraint to one of the proof's row. */
static sp_real sp__branch_weight(const sp__branch *s, int32_t i)
{
    const int32_t base = 6 * s->pb->blocks + 1, v = i < s->lp.m ? (i - base) / SP__ROWS : (i - s->lp.m) / 3;
    if (i < base - 1) return 1 / (s->load[i / 6] * (i % 6 < 3 ? 1 : s->arm[i / 6]));
    if (i == base - 1 || (i < s->lp.m && (i - base) % SP__ROWS < SP__ROW_RUB)) return 1;
    return 1 / s->size[v];
}

/* Multiplier of the k-th active constraint, of the failed one for k = n; 0 for what is only rounding,
 * or where it would ask for a bound that is none. */
static sp_real sp__branch_multiplier(const sp__branch *s, int32_t k, sp_real largest)
{
    const sp__lp *lp = &s->lp;
    const int32_t i = k < lp->n ? lp->active[k] : lp->failed;
    const sp_real sign = lp->low ? (sp_real)-1 : (sp_real)1, y = k < lp->n ? -sign * lp->t[k] : sign;
    if (sp__abs(y) <= SP__LP_ZERO * largest) return 0;
    return (y > 0 ? lp->upper[i] >= SP__LP_FREE : lp->lower[i] <= -SP__LP_FREE) ? 0 : y;
}

/* A closed node: its Farkas vector, 1 on the constraint that fails and -t on the active ones.     returns 0: no room */
static int sp__branch_close_node(sp__branch *s)
{
    sp_proof *p = s->proof;
    const int32_t from = p->entries;
    sp_real largest = 1;
    for (int32_t k = 0; k < s->lp.n; k++) largest = sp__max(largest, sp__abs(s->lp.t[k]));
    for (int32_t k = 0; k <= s->lp.n; k++) {
        const int32_t i = k < s->lp.n ? s->lp.active[k] : s->lp.failed, row = sp__branch_proof_row(s, i);
        const sp_real y = sp__branch_multiplier(s, k, largest);
        if (row < 0 || !(sp__abs(y) > 0)) continue;
        if (p->entries == s->entries) return 0;
        p->row[p->entries] = (uint16_t)row;
        p->y[p->entries++] = y * sp__branch_weight(s, i);
    }
    if (p->nodes == s->nodes) return 0;
    p->node[p->nodes++] = from - p->entries;
    p->leaves++;
    return 1;
}

/* States that a state splits into: how many, and the first. */
static int32_t sp__branch_children(int32_t state, int32_t *first)
{
    *first = state == 0 ? 1 : 2 * state;
    return state == 2 ? 4 : 2;
}

/* Flops that the check of the proof takes: so far, and with a leaf more. */
static int64_t sp__branch_check_flops(const sp__branch *s)
{
    return 40 * ((int64_t)s->proof->entries + s->lp.n) + SP__FLOPS_CERTIFICATE * ((int64_t)s->proof->leaves + 1) * s->points;
}

typedef enum sp__outcome { SP__OUT_REFUTED, SP__OUT_POINT, SP__OUT_BUDGET } sp__outcome;

/* Walks the tree: a linear program at every node, which is split where its point does not meet all conditions. */
SP__NOINLINE static sp__outcome sp__branch_run(sp__branch *s, int64_t left)
{
    s->depth = 0;
    s->proof->nodes = s->proof->leaves = s->proof->entries = 0;
    for (;;) {
        s->lp.limit = left - sp__branch_check_flops(s);
        for (int32_t v = 0; v < s->points; v++) {
            if (!sp__lp_affords(&s->lp, SP__ROWS)) return SP__OUT_BUDGET;
            sp__branch_set_state(s, v, s->state[v]);
        }
        const sp__lp_status status = sp__lp_run(&s->lp, 50 * s->lp.n);
        if (status == SP__LP_GIVEN_UP) return SP__OUT_BUDGET;
        if (status == SP__LP_POINT) {
            const int32_t v = sp__branch_pick(s);
            if (v < 0) return SP__OUT_POINT;
            if (s->proof->nodes == s->nodes || s->depth == SP__PROOF_DEPTH * s->points) return SP__OUT_BUDGET;
            sp__frame *f = &s->stack[s->depth++];
            s->proof->node[s->proof->nodes++] = v;
            f->state = s->state[v];
            f->vertex = v;
            f->child = 0;
            sp__branch_children(f->state, &s->state[v]);
            continue;
        }
        if (!sp__branch_close_node(s)) return SP__OUT_BUDGET;
        for (; s->depth; s->depth--) {                      /* the next child of the deepest node that has one */
            sp__frame *f = &s->stack[s->depth - 1];
            int32_t first;
            const int32_t n = sp__branch_children(f->state, &first);
            s->state[f->vertex] = f->state;
            if (++f->child == n) continue;
            s->state[f->vertex] = first + f->child;
            break;
        }
        if (!s->depth) return SP__OUT_REFUTED;
    }
}

/* Nodes and multipliers a proof has room for; 0: nothing is decided. `points`: contact vertices that take part. */
static int32_t sp__branch_proof_room(int32_t points, int32_t blocks, int32_t asked, int32_t *entries)
{
    const int few = points > 0 && points <= SP_EXACT_POINTS && blocks <= SP_EXACT_POINTS;
    const int32_t cube = few ? 24 * points * points * points : 0, own = cube < 48000 ? cube : 48000;
    const int32_t nodes = few && asked >= 0 ? asked : own;
    const int32_t most = INT32_MAX / 32 - 32 * SP_EXACT_POINTS, room = nodes < most ? nodes : most;
    *entries = room ? 20 * room + 3 * points + 6 * blocks + 1 : 0;
    return room;
}

static void sp__proof_carve(sp_proof *p, int32_t points, int32_t blocks, const sp_settings *set, sp_arena *a)
{
    int32_t entries;
    const int32_t nodes = sp__branch_proof_room(points, blocks, set->coupled.nodes, &entries);
    p->y = sp__take(a, (size_t)entries, sizeof *p->y);
    p->node = sp__take(a, (size_t)nodes, sizeof *p->node);
    p->row = sp__take(a, (size_t)entries, sizeof *p->row);
}

SP__NOINLINE static size_t sp__branch_bytes(const sp_problem *pb)
{
    sp__branch s;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof s);
    sp__branch_carve(&s, pb, &dry);
    return dry.used;
}

/* Bytes that the decision and the check of its proof take, one after the other. */
static size_t sp__branch_need(const sp_problem *pb, const sp_settings *set)
{
    int32_t entries;
    const int32_t points = sp__problem_points(pb);
    if (!sp__branch_proof_room(points, pb->blocks, set->coupled.nodes, &entries)) return 0;
    const size_t decision = sp__branch_bytes(pb), check = sp__refute_need(points, pb->blocks);
    return decision > check ? decision : check;
}

typedef struct sp__triple { sp_real *f, *dq, *alpha; } sp__triple;      /* 3 x points, 6b, points [N; m, 1; N/m] */

/* fn and dq of the program's point. */
static void sp__branch_point(const sp__branch *s, const sp__triple *t)
{
    memset(t->f, 0, 3 * (size_t)s->pb->points * sizeof *t->f);
    memset(t->alpha, 0, (size_t)s->pb->points * sizeof *t->alpha);
    for (int32_t v = 0; v < s->points; v++)
        t->f[3 * (size_t)s->at[v]] = sp__in_newtons(s->j->unit, s->lp.x[3 * v] * s->size[v]);
    for (int32_t r = 0; r < 6 * s->pb->blocks; r++)
        t->dq[r] = s->k.L * s->lp.x[3 * s->points + r] / (r % 6 < 3 ? 1 : s->arm[r / 6]);
}

/* Is there no triple? The proof, once checked, is left in out->proof, its margin, verdict and reason with it. t (may be NULL):
 * gets the point, if there is one; it is a triple where mu = 0. */
SP__NOINLINE static sp_status sp__branch_decide(const sp_problem *pb, const sp_settings *set, sp__certifier *j,
                                                const sp__lengths *k,
                                             int64_t left, const sp__triple *t, sp_arena *a, sp_coupled *out)
{
    const size_t mark = a->used;
    int32_t entries;
    const int32_t nodes = sp__branch_proof_room(sp__problem_points(pb), pb->blocks, set->coupled.nodes, &entries);
    if (!nodes) return SP_OK;
    sp__take(a, 1, sp__branch_need(pb, set));
    if (sp__failed(a)) return SP_E_MEMORY;
    a->used = mark;
    sp__branch *s = sp__take(a, 1, sizeof *s);
    sp__branch_carve(s, pb, a);
    s->set = set;
    s->j = j;
    s->k = *k;
    s->proof = &out->proof;
    s->nodes = nodes;
    s->entries = entries;
    sp__branch_make(s);
    const sp__outcome outcome = sp__branch_run(s, left - out->cost.flops);
    if (t && outcome == SP__OUT_POINT) sp__branch_point(s, t);
    out->cost.flops += s->lp.flops + (outcome == SP__OUT_REFUTED ? sp__branch_check_flops(s) : 0);
    a->used = mark;
    if (outcome == SP__OUT_REFUTED) out->margin = sp__certify_refutation(j, k, &out->proof, a);
    a->used = mark;
    if (out->margin > 0) {
        out->verdict = SP_COUPLING_REFUTED;
        out->reason = SP_COUPLING_NO_MOTION;
        return SP_OK;
    }
    out->proof.nodes = out->proof.leaves = out->proof.entries = 0;
    out->reason = outcome == SP__OUT_BUDGET ? SP_COUPLING_BUDGET : SP_COUPLING_LIMIT;
    return SP_OK;
}

#endif /* SP_NO_CRA */

#endif /* SP__COUPLED_DECIDE_C */
