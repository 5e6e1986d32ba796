/* cases: does nothing move, whatever friction does? Branch and bound over states of corners, a linear program in each case. */
#ifndef SP__STRONG_CASES_C
#define SP__STRONG_CASES_C

#include "../linear/lp.c"
#include "../proof/still.c"

#if SP__WITH_STRONG

#define SP__CASES_FEW 4                 /* corners up to which a proof has room for a few nodes */
#ifdef SP_REAL_FLOAT
#define SP__CASES_DUST ((sp_real)1e-3)  /* pressure, gap, slip that counts as none */
#else
#define SP__CASES_DUST ((sp_real)1e-8)
#endif
#define SP__CASES_FLOPS 8000000000      /* where there is no budget: for two blocks on a slope 5e9 */
#define SP__CASES_RUB ((sp_real)1e-6)   /* friction off its slip's, in the corner's load, that counts as none */

#define SP__CASES_SWEEPS 12             /* over the inverse, that a node costs at least: 25 to 90 were counted */

/* Room of a proof. */
typedef struct sp__cases_room { int32_t nodes, multipliers; } sp__cases_room;

/* Two blocks on four corners each take some 100,000 nodes, 16 multipliers each; a budget (0: none) has work for fewer. */
static sp__cases_room sp__cases_room_for(int32_t points, int32_t blocks, int64_t budget)
{
    const int32_t few = points <= SP__CASES_FEW, most = few ? 4096 : 131072, n = 3 * points + 6 * blocks;
    const int64_t worth = budget / (SP__CASES_SWEEPS * (int64_t)n * n) + 64;
    sp__cases_room room = { most, 0 };
    if (budget > 0 && worth < most) room.nodes = (int32_t)worth;
    room.multipliers = (few ? 24 : 16) * room.nodes;
    return room;
}

/* A node that was split: its corner, the state before, how many children are done. */
typedef struct sp__case { int32_t corner, state, child; } sp__case;

/* The program of a case over x = (f / size, a / A, rotations times arm): rows as sp__still_row has them, each in proportion. */
typedef struct sp__cases {
    const sp_problem *pb;
    const sp__certifier *j;
    const sp__inertia *M;
    sp__lp lp;
    int32_t points;                     /* V */
    sp_real A, power;                   /* largest load / mass [m/s^2]; A times all loads */
    int32_t *contact, *at, *state, *loaded;     /* V; loaded: the state in the program */
    sp_real *size;                      /* V: unit of its force */
    sp_real (*d)[3][12];                /* V: dn, dt1, dt2 of a unit of each variable of the motions of b and a */
    sp__case *stack;
    int32_t depth;
    sp_proof *proof;
    sp__cases_room room;                /* its */
} sp__cases;

/* Entries of the program's rows: 6b of M, 3 x 6 a corner and side in M a - Aeq f, work, 5 rows of d, 14 of f. */
static int32_t sp__cases_entries(int32_t points, int32_t blocks)
{
    return 6 * blocks * 4 + points * 12 * (3 + 5) + 3 * 14 * points;
}

static void sp__cases_carve(sp__cases *s, int32_t points, int32_t blocks, sp_arena *a)
{
    const size_t v = (size_t)points;
    s->points = points;
    const int32_t n = 6 * blocks;
    sp__lp_carve(&s->lp, 3 * points + n, n + 1 + SP__STILL_FORCE * points, sp__cases_entries(points, blocks), a);
    s->contact = sp__take(a, v, sizeof *s->contact);
    s->at = sp__take(a, v, sizeof *s->at);
    s->state = sp__take(a, v, sizeof *s->state);
    s->loaded = sp__take(a, v, sizeof *s->loaded);
    s->size = sp__take(a, v, sizeof *s->size);
    s->d = sp__take(a, v, sizeof *s->d);
    s->stack = sp__take(a, v, SP__STILL_DEPTH * sizeof *s->stack);
}

/* Are there so few corners that cases are told apart? Not in float, whose rounding closes none. */
static int sp__cases_allowed(const sp_scene *scene, int32_t blocks)
{
    const int32_t points = sp__points_count(scene);
    return sizeof(sp_real) >= 8 && points > 0 && points <= SP__STILL_POINTS && blocks <= SP__STILL_POINTS;
}

static void sp__cases_bound(sp__cases *s, int32_t row, sp_real low, sp_real high)
{
    s->lp.lower[row] = low;
    s->lp.upper[row] = high;
}

/* Row `which` of corner v in the program. */
static int32_t sp__cases_row(const sp__cases *s, int32_t v, int32_t which)
{
    return 6 * s->pb->blocks + 1 + SP__STILL_FORCE * v + which;
}

static sp_real sp__cases_arm(const sp__cases *s, int32_t i) { return s->j->scale[i].arm > 0 ? s->j->scale[i].arm : 1; }

/* Coefficients and bounds of a row of corner v, for its state. */
static void sp__cases_set_row(sp__cases *s, int32_t v, int32_t which)
{
    const int32_t row = sp__cases_row(s, v, which), n = s->lp.start[row + 1] - s->lp.start[row];
    const int sign = sp__still_sign(s->state[v], which);
    const int moves = which >= SP__STILL_ENDS && (which < SP__STILL_CONE || which >= SP__STILL_NEAR);
    sp_real *to = s->lp.value + s->lp.start[row], r[6];
    if (moves ? sign : s->loaded[v] < 0) {
        sp__lp_deactivate(&s->lp, row);
        sp__still_row(s->state[v], which, s->pb->contact[s->contact[v]].joint->strength.mu, r);
        for (int32_t e = 0; e < n; e++)
            to[e] = which < SP__STILL_RUB ? r[3] * s->d[v][0][e] + r[4] * s->d[v][1][e] + r[5] * s->d[v][2][e] : r[e];
    }
    sp__cases_bound(s, row, sign == -1 || sign == 2 ? 0 : -SP__LP_FREE, sign > 0 ? 0 : SP__LP_FREE);
}

/* The program's rows of corner v for its state, and bounds of its force. */
static void sp__cases_set(sp__cases *s, int32_t v)
{
    const int32_t f = s->lp.m + 3 * v, state = s->state[v];
    const sp_real most = state == 1 ? 0 : SP__LP_FREE;
    if (s->loaded[v] == state) return;
    for (int32_t q = 0; q < SP__STILL_FORCE; q++) sp__cases_set_row(s, v, q);
    s->loaded[v] = state;
    sp__cases_bound(s, f, 0, most);
    sp__cases_bound(s, f + 1, -most, most);
    sp__cases_bound(s, f + 2, -most, most);
}

/* d of corner v: +-(e, (r - c) x e / arm) on b and a. */
static void sp__cases_corner(sp__cases *s, int32_t v)
{
    const sp_contact *t = &s->pb->contact[s->contact[v]];
    const sp_joint *o = t->joint;
    for (int q = 0; q < 3; q++) {
        const sp_real *e = q == 0 ? o->n : q == 1 ? o->t1 : o->t2;
        sp_real *to = s->d[v][q];
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->a : t->b;
            const sp_real sign = side ? (sp_real)-1 : (sp_real)1;
            sp_real r[3], m[3];
            if (i < 0) continue;
            sp__arm(s->pb, i, s->at[v], r);
            sp__cross3(r, e, m);
            for (int k = 0; k < 3; k++) *to++ = sign * e[k];
            for (int k = 0; k < 3; k++) *to++ = sign * m[k] / sp__cases_arm(s, i);
        }
    }
}

static void sp__cases_entry(sp__cases *s, int32_t *e, int32_t variable, sp_real value)
{
    s->lp.index[*e] = variable;
    s->lp.value[(*e)++] = value;
}

/* Row r of M a - Aeq f = p, in the block's load, moments in load times arm. */
static void sp__cases_dynamics(sp__cases *s, int32_t r, int32_t *e)
{
    const sp_problem *pb = s->pb;
    const int32_t i = r / 6, k = r % 6, z = 3 * s->points;
    const sp_real load = s->j->scale[i].load, arm = sp__cases_arm(s, i), A = sp__in_units(s->j->unit, s->A) / load;
    const sp_real p = sp__in_units(s->j->unit, pb->p[r]) / load / (k < 3 ? 1 : arm);
    const int held = sp__held(pb, i, k);
    s->lp.start[r] = *e;
    if (k < 3) sp__cases_entry(s, e, z + r, s->M[i].mass * A);
    else for (int q = 0; q < 3; q++) sp__cases_entry(s, e, z + 6 * i + 3 + q, s->M[i].J[k - 3][q] * A / (arm * arm));
    for (int32_t v = 0; v < s->points; v++) {
        const sp_contact *t = &pb->contact[s->contact[v]];
        if (t->a != i && t->b != i) continue;
        const int32_t at = k + (t->b >= 0 && t->a == i ? 6 : 0);
        for (int32_t q = 0; q < 3; q++) sp__cases_entry(s, e, 3 * v + q, -s->d[v][q][at] * s->size[v] / load);
    }
    sp__cases_bound(s, r, held ? -SP__LP_FREE : p, held ? SP__LP_FREE : p);
    sp__cases_bound(s, s->lp.m + z + r, held ? 0 : -SP__LP_FREE, held ? 0 : SP__LP_FREE);
}

/* All rows, and the state of nothing known. */
static void sp__cases_rows(sp__cases *s, sp_real delta)
{
    const sp_problem *pb = s->pb;
    const int32_t n = 6 * pb->blocks, z = 3 * s->points;
    int32_t e = 0;
    for (int32_t r = 0; r < n; r++) sp__cases_dynamics(s, r, &e);
    s->lp.start[n] = e;
    for (int32_t r = 0; r < n; r++)
        sp__cases_entry(s, &e, z + r, -sp__in_units(s->j->unit, pb->p[r]) * s->A / s->power
                                      / (r % 6 < 3 ? 1 : sp__cases_arm(s, r / 6)));
    sp__cases_bound(s, n, -SP__LP_FREE, -delta / s->power);
    for (int32_t v = 0; v < s->points; v++) {
        const sp_contact *t = &pb->contact[s->contact[v]];
        for (int32_t q = 0; q < SP__STILL_FORCE; q++) {
            s->lp.start[sp__cases_row(s, v, q)] = e;
            for (int side = 0; side < 2 && q < SP__STILL_RUB; side++) {
                const int32_t i = side ? t->a : t->b;
                for (int32_t k = 0; i >= 0 && k < 6; k++) sp__cases_entry(s, &e, z + 6 * i + k, 0);
            }
            for (int32_t k = 0; k < 3 && q >= SP__STILL_RUB; k++) sp__cases_entry(s, &e, 3 * v + k, 0);
        }
        s->state[v] = 0;
        s->loaded[v] = -1;
    }
    s->lp.start[s->lp.m] = e;
}

/* Units, corners, the root program. */
SP__NOINLINE static void sp__cases_make(sp__cases *s, sp_real delta)
{
    const sp_problem *pb = s->pb;
    int32_t v = 0;
    sp_real all = 0;
    s->A = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        s->A = sp__max(s->A, sp__in_newtons(s->j->unit, s->j->scale[i].load) / s->M[i].mass);
        all += s->j->scale[i].load;
    }
    s->power = s->A * all;
    for (int32_t c = 0; c < pb->contacts; c++)
        for (int32_t k = 0; k < pb->contact[c].points; k++, v++) {
            s->contact[v] = c;
            s->at[v] = pb->contact[c].point + k;
            s->size[v] = sp__least_of_blocks(&pb->contact[c], &s->j->scale->load, sizeof *s->j->scale / sizeof(sp_real));
            sp__cases_corner(s, v);
        }
    sp__cases_rows(s, delta);
    sp__lp_start(&s->lp);
}

/* d / A of corner v at the program's point. */
static void sp__cases_rate(const sp__cases *s, int32_t v, sp_real d[3])
{
    const int32_t from = s->lp.start[sp__cases_row(s, v, 0)], to = s->lp.start[sp__cases_row(s, v, 1)];
    for (int q = 0; q < 3; q++) {
        d[q] = 0;
        for (int32_t e = from; e < to; e++) d[q] += s->d[v][q][e - from] * s->lp.x[s->lp.index[e]];
    }
}

/* The corner to split: the unknown one that presses and gapes most, then the one whose friction is farthest from its slip's;
 * -1: the point meets every condition. */
static int32_t sp__cases_pick(const sp__cases *s)
{
    int32_t pick = -1;
    for (int pass = 0; pass < 2 && pick < 0; pass++) {
        sp_real worst = pass ? 0 : SP__CASES_DUST;
        for (int32_t v = 0; v < s->points; v++) {
            const sp_real *f = s->lp.x + 3 * v, mu = s->pb->contact[s->contact[v]].joint->strength.mu;
            sp_real d[3];
            if (s->state[v] == 1 || s->state[v] == 3 || (!pass && s->state[v]) || s->state[v] >= SP__STILL_DEEP) continue;
            sp__cases_rate(s, v, d);
            const sp_real slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
            const sp_real rub[3] = { 0, f[1] * slip + mu * f[0] * d[1], f[2] * slip + mu * f[0] * d[2] };
            const sp_real wrong = sp__norm3(rub), least = f[0] < d[0] ? f[0] : d[0], value = pass ? s->size[v] * wrong : least;
            if (pass ? slip > SP__CASES_DUST && wrong > SP__CASES_RUB * slip && value > worst : value > worst) {
                worst = value;
                pick = v;
            }
        }
    }
    return pick;
}

/* Number of a constraint in the proof, -1: a bound of a; *weight: from its multiplier to the proof's. */
static int32_t sp__cases_proof_row(const sp__cases *s, int32_t i, sp_real *weight)
{
    const int32_t n = 6 * s->pb->blocks, V = s->points;
    if (i < n) {
        const int32_t b = i / 6;
        *weight = 1 / s->j->scale[b].load / (i % 6 < 3 ? 1 : sp__cases_arm(s, b));
        return i;
    }
    if (i == n) { *weight = 1 / s->power; return n; }
    if (i < s->lp.m) {
        const int32_t v = (i - n - 1) / SP__STILL_FORCE, q = (i - n - 1) % SP__STILL_FORCE;
        *weight = 1 / (q < SP__STILL_RUB ? s->A : s->size[v]);
        return n + 1 + SP__STILL_ROWS * v + q;
    }
    if (i >= s->lp.m + 3 * V) return -1;
    const int32_t v = (i - s->lp.m) / 3;
    *weight = 1 / s->size[v];
    return n + 1 + SP__STILL_ROWS * v + SP__STILL_FORCE + (i - s->lp.m) % 3;
}

/* t <- t + (a_i - sum t_k a_k) M, i the constraint that fails: what rounding did to M goes out of t. */
static void sp__cases_refine(sp__lp *lp)
{
    const size_t n = (size_t)lp->n;
    sp_real *left = lp->was;
    for (size_t j = 0; j < n; j++) left[j] = 0;
    for (int32_t k = 0; k <= lp->n; k++) {
        const int32_t i = k < lp->n ? lp->active[k] : lp->failed;
        const sp_real t = k < lp->n ? -lp->t[k] : 1;
        if (i >= lp->m) { left[i - lp->m] += t; continue; }
        for (int32_t e = lp->start[i]; e < lp->start[i + 1]; e++) left[lp->index[e]] += t * lp->value[e];
    }
    for (size_t j = 0; j < n; j++)
        for (size_t k = 0; k < n; k++) lp->t[k] += left[j] * lp->M[j * n + k];
    lp->flops += 4 * (int64_t)(n * n) + 2 * (int64_t)lp->entries;
}

/* A closed node: its Farkas vector, 1 on the constraint that fails and -t on the active ones.     returns 0: no room */
static int sp__cases_close(sp__cases *s)
{
    sp_proof *p = s->proof;
    const sp__lp *lp = &s->lp;
    sp__cases_refine(&s->lp);
    const int32_t from = p->entries;
    const sp_real sign = lp->low ? (sp_real)-1 : (sp_real)1;
    sp_real largest = 1, weight = 0;
    for (int32_t k = 0; k < lp->n; k++) largest = sp__max(largest, sp__abs(lp->t[k]));
    for (int32_t k = 0; k <= lp->n; k++) {
        const int32_t i = k < lp->n ? lp->active[k] : lp->failed, row = sp__cases_proof_row(s, i, &weight);
        const sp_real y = k < lp->n ? -sign * lp->t[k] : sign;
        if (row < 0 || sp__abs(y) <= SP__LP_ZERO * largest) continue;
        if (y > 0 ? lp->upper[i] >= SP__LP_FREE : lp->lower[i] <= -SP__LP_FREE) continue;
        if (p->entries == s->room.multipliers) return 0;
        p->row[p->entries] = (uint16_t)row;
        p->y[p->entries++] = y * weight;
    }
    if (p->nodes == s->room.nodes) return 0;
    p->node[p->nodes++] = from - p->entries;
    p->leaves++;
    return 1;
}

/* Goes on to the next child of the deepest node that has one.     returns 0: the tree is done */
static int sp__cases_next(sp__cases *s)
{
    for (; s->depth; s->depth--) {
        sp__case *f = &s->stack[s->depth - 1];
        int32_t first;
        const int32_t n = sp__still_children(f->state, &first);
        s->state[f->corner] = f->state;
        if (++f->child == n) continue;
        s->state[f->corner] = first + f->child;
        return 1;
    }
    return 0;
}

/* Walks the tree.     returns 1: every case is closed, 0: a point is left, or no room or work */
SP__NOINLINE static int sp__cases_run(sp__cases *s, int64_t limit)
{
    sp_proof *p = s->proof;
    s->depth = p->nodes = p->leaves = p->entries = 0;
    s->lp.limit = limit;
    do {
        for (int32_t v = 0; v < s->points; v++) sp__cases_set(s, v);
        sp__lp_status status = sp__lp_run(&s->lp, 50 * s->lp.n);
        while (status == SP__LP_POINT) {
            const int32_t v = sp__cases_pick(s);
            if (v < 0 || p->nodes == s->room.nodes || s->depth == SP__STILL_DEPTH * s->points) return 0;
            sp__case *f = &s->stack[s->depth++];
            p->node[p->nodes++] = v;
            f->state = s->state[v];
            f->corner = v;
            f->child = 0;
            sp__still_children(f->state, &s->state[v]);
            sp__cases_set(s, v);
            status = sp__lp_run(&s->lp, 50 * s->lp.n);
        }
        if (status == SP__LP_GIVEN_UP || !sp__cases_close(s)) return 0;
    } while (sp__cases_next(s));
    return 1;
}

/* Bytes of the search and of the check of its proof, one after the other. */
SP__NOINLINE static size_t sp__cases_need(int32_t points, int32_t blocks)
{
    sp__cases s;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof s);
    sp__cases_carve(&s, points, blocks, &dry);
    return dry.used;
}

/* Room for a proof. */
static void sp__cases_proof(sp_proof *p, const sp__cases_room *room, sp_arena *a)
{
    const size_t entries = (size_t)room->multipliers;
    p->y = sp__take(a, entries, sizeof *p->y);
    p->node = sp__take(a, (size_t)room->nodes, sizeof *p->node);
    p->row = sp__take(a, entries, sizeof *p->row);
}

/* Does nothing move? The proof in r->proof, which has room for the budget, is not judged yet.     returns 0: not decided */
SP__NOINLINE static int sp__cases_decide(const sp_problem *pb, const sp__certifier *j, const sp__inertia *M, int64_t budget,
                                         sp_arena a, sp_strong_result *r)
{
    const sp_real delta = sp__still_delta(j, M);
    sp__cases *s = sp__take(&a, 1, sizeof *s);
    if (!s || !(delta > 0)) return 0;
    sp__cases_carve(s, sp__problem_points(pb), pb->blocks, &a);
    if (sp__failed(&a)) return 0;
    s->pb = pb; s->j = j; s->M = M;
    s->proof = &r->proof;
    s->room = sp__cases_room_for(s->points, pb->blocks, budget);
    sp__cases_make(s, delta);
    const int proved = sp__cases_run(s, budget > 0 ? budget : SP__CASES_FLOPS);
    r->cost.flops += s->lp.flops;
    return proved;
}

#endif

#endif /* SP__STRONG_CASES_C */
