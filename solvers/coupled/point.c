/* point: a triple looked for by cases: the tree of the decision, where every corner that rubs has to slip by a given length.
 *
 *     decision       2 engaged, then quarters, then halves; friction without slip belongs to each of them
 *     here           2 engaged, then 3 no friction, or 4..7 a quarter and   m . dt >= slip,   m its middle
 *
 * The tree is walked by limited discrepancy [Harvey, Ginsberg 1995, IJCAI]: the likeliest child first, and on the way down to a
 * leaf at most `most` times another than that; then twice as often. A child whose program has no point does not count.
 */
#ifndef SP__COUPLED_POINT_C
#define SP__COUPLED_POINT_C

#include "decide.c"

#ifndef SP_NO_CRA

#define SP__POINT_FLOPS 5000000000       /* work for all lengths of slip */
#define SP__POINT_MOST 32               /* discrepancies */
#define SP__POINT_DUST ((sp_real)(sizeof(sp_real) == 8 ? 1e-10 : 1e-6))        /* force that is none, gap that is closed */
#define SP__POINT_SHARP ((sp_real)64)   /* factor on rows that the judge asks to more digits than SP__LP_TOL */

/* |dt| <= eta by the octagon inside the circle: what the judge asks of every vertex, open ones, too. */
static void sp__point_bound_slips(sp__branch *s, int32_t v)
{
    sp_real w[2], turn[2];
    sp__pyramid_direction(8, 0, w);
    sp__pyramid_direction(16, 1, turn);
    const sp_real most = s->k.eta * sp__abs(w[0] * turn[0] + w[1] * turn[1]);
    for (int32_t q = 0; q < 4 && !s->set->coupled.box; q++)
        sp__branch_bound(s, sp__branch_row(s, v, SP__ROW_SLIP + q), -most, most);
}

/* Slip of at least that length, and friction between the ends of the sector, without what the decision leaves for rounding. */
static void sp__point_slip(sp__branch *s, int32_t v, sp_real slip)
{
    sp_real a[2], m[2], b[2];
    s->lp.lower[sp__branch_row(s, v, SP__ROW_AHEAD)] = slip;
    sp__sector(s->state[v], a, m, b);
    for (int32_t q = 0; q < 2; q++) {
        const sp_real *w = q ? b : a, x = SP__POINT_SHARP * w[0], y = SP__POINT_SHARP * w[1];
        sp__branch_force_row(s, sp__branch_row(s, v, SP__ROW_RUB + q), 0, -y, x);
    }
}

/* The program's rows of vertex v for its state. */
static void sp__point_set_state(sp__branch *s, int32_t v, sp_real slip)
{
    const int32_t state = s->state[v], gap = sp__branch_row(s, v, SP__ROW_GAP);
    if (s->loaded[v] == state) return;
    sp__branch_set_state(s, v, state);
    sp__branch_bound(s, gap, -SP__POINT_SHARP * s->k.eps, SP__POINT_SHARP * (state < 2 ? s->k.eta : -s->k.eps));
    sp__point_bound_slips(s, v);
    for (int32_t q = 1; q < 3 && state == 3; q++) sp__branch_bound(s, s->lp.m + 3 * v + q, 0, 0);
    if (state >= 4) sp__point_slip(s, v, slip);
}

/* What the point at hand still lacks at vertex v: 0 nothing. */
static sp_real sp__point_lack(const sp__branch *s, int32_t v)
{
    const sp_real *f = s->lp.x + 3 * v;
    const int32_t state = s->state[v];
    sp_real d[3], width = 4;
    if (state == 1 || state >= SP__BRANCH_DEEP || !(f[0] > SP__POINT_DUST)) return 0;
    sp__branch_displacement(s, v, d);
    const sp_real gap = d[0] + s->k.eps, ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
    if (state == 0 && gap > SP__POINT_DUST) return 16 * (1 + gap) * s->size[v];
    if (state == 3 || ft <= SP__POINT_DUST) return 0;
    const sp_real dt = SP_SQRT(d[1] * d[1] + d[2] * d[2]), across = sp__abs(f[1] * d[2] - f[2] * d[1]);
    if (state < 4) return f[1] * d[1] + f[2] * d[2] < 0 && across <= SP__SLIP / 4 * ft * dt && dt > 2 * SP__SLIP ? 0
                          : 4 * s->size[v] * ft;
    if (across <= SP__SLIP / 4 * ft * dt) return 0;
    for (int32_t q = state; q > 3; q /= 2) width /= 2;
    return s->size[v] * (across / dt) * width;
}

/* States that a state splits into: how many, and the first. */
static int32_t sp__point_children(int32_t state, int32_t *first)
{
    *first = state == 0 ? 1 : state == 2 ? 3 : 2 * state;
    return state == 2 ? 5 : 2;
}

/* A search: the program, the length of slip, whether the likeliest sector is taken by friction alone or by slip as well;
 * discrepancies of the path at hand, the most, and whether that kept it from any child. */
typedef struct sp__dive {
    sp__branch *s;
    sp_real slip;
    int by_friction;
    int32_t missed, most;
    int cut;
} sp__dive;

/* Which of the directions of a state's sectors a force and a slip are most opposed along, or the force alone. */
static int32_t sp__point_sector(const sp_real f[3], const sp_real d[3], int by_friction, int32_t first, int32_t n)
{
    const sp_real ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]), dt = by_friction ? 0 : SP_SQRT(d[1] * d[1] + d[2] * d[2]);
    const sp_real x = sp__ratio(d[1], dt) - sp__ratio(f[1], ft), y = sp__ratio(d[2], dt) - sp__ratio(f[2], ft);
    sp_real a[2], m[2], b[2], best = -SP__HUGE;
    int32_t likely = 0;
    for (int32_t k = first < 4 ? 4 - first : 0; k < n; k++) {
        sp__sector(first + k, a, m, b);
        if (m[0] * x + m[1] * y > best) { best = m[0] * x + m[1] * y; likely = k; }
    }
    return likely;
}

/* The child to begin with: pressing where the force is larger than the gap, else the sector nearest to -friction. */
static int32_t sp__point_likely(const sp__dive *g, int32_t v, int32_t state)
{
    const sp_real *f = g->s->lp.x + 3 * v;
    sp_real d[3];
    int32_t first;
    const int32_t n = sp__point_children(state, &first);
    sp__branch_displacement(g->s, v, d);
    return state == 0 ? f[0] > d[0] + g->s->k.eps : sp__point_sector(f, d, g->by_friction, first, n);
}

/* A node is split at vertex v. */
static void sp__point_split(const sp__dive *g, int32_t v)
{
    sp__branch *s = g->s;
    if (s->depth) s->stack[s->depth - 1].leads = 1;
    sp__frame *f = &s->stack[s->depth++];
    int32_t first;
    f->vertex = v;
    f->state = s->state[v];
    f->child = f->missed = f->leads = 0;
    f->begin = (int8_t)sp__point_likely(g, v, f->state);
    sp__point_children(f->state, &first);
    s->state[v] = first + f->begin;
}

/* On to the next child of the deepest node that has one within the limit.     returns 0: there is none */
static int sp__point_next(sp__dive *g)
{
    sp__branch *s = g->s;
    for (; s->depth; s->depth--) {
        sp__frame *f = &s->stack[s->depth - 1];
        int32_t first;
        const int32_t n = sp__point_children(f->state, &first);
        s->state[f->vertex] = f->state;
        if (f->child + 1 < n && g->missed + f->leads <= g->most) {
            f->missed = (int8_t)(f->missed + f->leads);
            g->missed += f->leads;
            f->leads = 0;
            f->child++;
            s->state[f->vertex] = first + (f->child + f->begin) % n;
            return 1;
        }
        if (f->child + 1 < n) g->cut = 1;
        g->missed -= f->missed;
    }
    return 0;
}

/* The vertex that lacks most; -1: none does. */
static int32_t sp__point_pick(const sp__branch *s)
{
    int32_t pick = -1;
    sp_real worst = 0;
    for (int32_t v = 0; v < s->points; v++) {
        const sp_real lack = sp__point_lack(s, v);
        if (lack > worst) { worst = lack; pick = v; }
    }
    return pick;
}

/* Depth first within the limit.     returns 1 when the program's point is a triple as far as states can tell */
SP__NOINLINE static int sp__point_run(sp__dive *g)
{
    sp__branch *s = g->s;
    s->depth = 0;
    g->missed = g->cut = 0;
    for (int32_t v = 0; v < s->points; v++) { s->state[v] = 0; s->loaded[v] = -1; }
    for (int32_t node = 0; node < s->nodes; node++) {
        for (int32_t v = 0; v < s->points; v++) {
            if (!sp__lp_affords(&s->lp, SP__ROWS)) return 0;
            sp__point_set_state(s, v, g->slip);
        }
        const sp__lp_status status = sp__lp_run(&s->lp, 50 * s->lp.n);
        if (status == SP__LP_GIVEN_UP && !sp__lp_affords(&s->lp, 4)) return 0;
        const int deeper = status == SP__LP_POINT && s->depth < SP__PROOF_DEPTH * s->points;
        const int32_t v = deeper ? sp__point_pick(s) : -1;
        if (deeper && v < 0) return 1;
        if (deeper) sp__point_split(g, v);
        else if (!sp__point_next(g)) return 0;
    }
    return 0;
}

/* f and alpha at vertex v: forces too small to need a closed joint or a slip are none. */
static void sp__point_write_vertex(const sp__branch *s, int32_t v, const sp__triple *t)
{
    const sp_real *x = s->lp.x + 3 * v;
    sp_real *f = t->f + 3 * (size_t)s->at[v], d[3];
    sp__branch_displacement(s, v, d);
    const sp_real squared = d[1] * d[1] + d[2] * d[2], along = -(x[1] * d[1] + x[2] * d[2]);
    const int presses = s->state[v] != 1 && x[0] > SP__POINT_DUST;
    const int rubs = presses && s->state[v] != 3 && squared > 0 && along > 0;
    f[0] = presses ? f[0] : 0;
    for (int q = 1; q < 3; q++) f[q] = rubs ? sp__in_newtons(s->j->unit, x[q] * s->size[v]) : 0;
    t->alpha[s->at[v]] = rubs ? sp__in_newtons(s->j->unit / s->k.L, along * s->size[v] / squared) : 0;
}

/* The triple at the program's point. */
static void sp__point_write(const sp__branch *s, const sp__triple *t)
{
    sp__branch_point(s, t);
    for (int32_t v = 0; v < s->points; v++) sp__point_write_vertex(s, v, t);
}

/* The program of a search, for work up to `limit`.     returns NULL: this many corners are not searched, or no memory */
SP__NOINLINE static sp__branch *sp__point_open(const sp_problem *pb, const sp_settings *set, const sp__certifier *j,
                                               const sp__lengths *k, int64_t limit, sp_arena *a)
{
    int32_t entries;
    const int32_t nodes = sp__branch_proof_room(sp__problem_points(pb), pb->blocks, set->coupled.nodes, &entries);
    sp__branch *s = nodes ? sp__take(a, 1, sizeof *s) : NULL;
    if (!s) return NULL;
    sp__branch_carve(s, pb, a);
    if (sp__failed(a)) return NULL;
    s->set = set;
    s->j = j;
    s->k = *k;
    s->nodes = nodes;
    sp__branch_make(s);
    for (int32_t v = 0; v < s->points; v++)
        sp__branch_motion_row(s, v, sp__branch_row(s, v, SP__ROW_GAP), SP__POINT_SHARP, 0, 0);
    s->lp.limit = limit < SP__POINT_FLOPS ? limit : SP__POINT_FLOPS;
    return s;
}

#endif /* SP_NO_CRA */

#endif /* SP__COUPLED_POINT_C */
