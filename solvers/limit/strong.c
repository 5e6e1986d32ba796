/* strong: joints with strength: max c lambda - 1/2 sum |f_v|^2 / S_v for growing c, by Newton's method on its dual. */
#ifndef SP__LIMIT_STRONG_C
#define SP__LIMIT_STRONG_C

#include "interior.c"

#if SP__WITH_INTERIOR

#define SP__STRONG_MOST 240             /* factorisations for the first c, at most */
#define SP__STRONG_CLIMB 130            /* factorisations of the climb from there, at most */
#define SP__STRONG_ASK 160              /* factorisations of a question, at most: what is decided takes no more */
#define SP__STRONG_NEAR (100 * SP__SCALE_TOL)   /* gap of both ends, relative, that ends a climb */
#define SP__STRONG_STILL ((sp_real)(sizeof(sp_real) == 8 ? 1e-6 : 1e-4))        /* change of imbalance, relative: none */
#define SP__STRONG_SOLVED SP__STRONG_STILL      /* imbalance from which on y is taken for that of its c; forces come later */

/* K that is no cone, and what interior points leave open, by the dual of the exact stage with lambda in it:
 *
 *   max c lambda - 1/2 sum |f_v|^2 / S_v,  Aeq f + p + lambda q = 0,  f in K         dual: min D(y) with p alone, q . y = -c
 *
 * The larger c, the nearer lambda is to the limit (it lacks |f|^2 / 2c at most, and nothing from some c on if K is polyhedral)
 * and y to a multiple of the mechanism, along which D is flat; but q is not across it, so a bordered Newton step is regular
 * there: d = -H^-1 (r + dlambda q), q . d = 0.
 *                                                                             [Mangasarian, Meyer 1979: exact for large c] */
SP__NOINLINE static sp_real sp__strong_step(sp__limit *L, sp_real c)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp__system_factor(w, SP__ADMISSIBLE, w->y, g->n.prox + g->n.shift);
    if (w->budget.spent) return 0;
    g->n.left--;
    L->bracket.cost.iterations++;
    sp__system_solve(w, g->q, g->Vq);
    g->G[0] = sp__dot(g->q, g->Vq, n);
    if (!(g->G[0] > 0)) return 0;
    const sp_real off = (c + sp__dot(g->q, w->y, n)) / g->G[0];
    const sp_real rounding = 16 * (sp_real)SP_EPSILON * SP_SQRT(sp__dot(g->q, g->q, n) * sp__dot(w->y, w->y, n));
    if (sp__abs(off) * g->G[0] > (sp_real)1e-9 * c + rounding) {       /* a larger c: along the tangent */
        sp__system_axpy(w, -off, g->Vq, w->y);
        sp__newton_measure(w, &g->n, &g->state);
        return 1;
    }
    for (size_t k = 0; k < n; k++) w->d[k] = -w->r[k] - g->n.prox * w->y[k];
    sp__system_solve(w, w->d, w->d);
    for (int pass = 0; pass < 2; pass++) {              /* what rounding leaves along Vq, too */
        const sp_real a = sp__dot(g->q, w->d, n) / g->G[0];
        sp__system_axpy(w, -a, g->Vq, w->d);
        if (!pass) { g->at += a; sp__system_axpy(w, a, g->q, w->r); }
    }
    sp__limit_loads(L, g->at);
    return sp__newton_move(w, &g->n, 0, &g->state);
}

/* y for that c: by Newton, and where that stalls and `thorough` by the proximal path.     returns 1: it is found */
SP__NOINLINE static int sp__strong_solve(sp__limit *L, sp_real c, int thorough)
{
    sp__engine *g = &L->engine;
    const sp__system *w = g->w;
    sp__newton *n = &g->n;
    n->imbalance = SP__HUGE;
    n->prox = 0;
    n->shift = SP__SHIFT;
    for (int it = 0, tiny = 0; it < 18 && sp__newton_work_left(w, n) && n->imbalance > n->goal && tiny < 2; it++) {
        const sp_real was = n->imbalance;
        tiny += sp__newton_adapt_shift(n, sp__strong_step(L, c));
        /* What gains no more is rounding, or, at SP__HUGE, of loads that cancel, to which no imbalance is small. */
        const int idle = n->imbalance < SP__STRONG_SOLVED || !(n->imbalance < SP__HUGE);
        tiny += idle && n->imbalance > was / 2;
    }
    if (n->imbalance <= SP__STRONG_SOLVED || !thorough) return n->imbalance <= SP__STRONG_SOLVED;
    n->shift = 0;
    n->level = SP__HUGE;
    n->prox = (sp_real)0.1;
    for (int extra = 4, still = 0; extra > 0 && still < 4 && sp__newton_work_left(w, n) && n->imbalance > n->goal; ) {
        const sp_real was = n->imbalance;
        sp__strong_step(L, c);
        still = sp__abs(n->imbalance - was) > SP__STRONG_STILL * was ? 0 : still + 1;
        if (n->prox <= SP__SHIFT) extra--;
        else if (sp__newton_near_minimum(g->w, n)) {
            n->prox = n->prox > 100 * SP__SHIFT ? n->prox / 100 : SP__PROX;
            sp__limit_sizes(L);
            sp__limit_candidate(L, w->y);
            if (L->none || L->best < 0) break;              /* no lambda >= 0 stands: y would grow without end */
        }
    }
    return n->imbalance <= SP__STRONG_SOLVED;
}

/* Are both ends as near as they are asked to be: of the loads that are left where live ones cancel dead ones? */
static int sp__strong_met(const sp__limit *L)
{
    const sp__bracket *b = &L->bracket;
    const sp_real a = L->best < SP__HUGE ? L->best * L->ref : 0;
    sp_real left = 0, all = 0;
    for (int32_t i = 0; i < b->pb.blocks; i++) {
        const sp_real *dead = b->dead + 6 * (size_t)i, *live = b->live + 6 * (size_t)i;
        const sp_real sum[3] = { dead[0] + a * live[0], dead[1] + a * live[1], dead[2] + a * live[2] };
        left += sp__norm3(sum);
        all += sp__norm3(dead) + sp__abs(a) * sp__norm3(live);
    }
    return sp__limit_ends_meet(L, SP__STRONG_NEAR * sp__ratio(left, all));
}

/* The kept motion once more, sharpened by the rigid groups it shows: for the work of the loads that it falls by. */
SP__NOINLINE static void sp__limit_sharpen(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    memcpy(g->state.dq, L->bracket.dq, n * sizeof *g->state.dq);
    sp__reduction_from_space(g->reduction, w->pb->blocks, g->state.dq);
    sp__bracket_load(&L->bracket, L->best < 0, L->best < 0 ? 0 : L->ref);
    sp__newton_sharpen_proof(w, 2, &g->state);
    for (size_t k = 0; k < n; k++) g->Vq[k] = -g->state.dq[k] / w->measure.weight[k / 3];
    sp__limit_loads(L, sp__max(0, L->best));
    sp__limit_candidate(L, g->Vq);
}

/* Vq, with y' = -Vq / (q . Vq): of the factor at hand, and once more from there, which takes away what the factor's shift adds:
 * joints hardly pressed, but by caps of a million weights. */
SP__NOINLINE static void sp__strong_derivative(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp__system_solve(w, g->q, g->Vq);
    g->G[0] = sp__dot(g->q, g->Vq, n);
    for (size_t k = 0; k < n; k++) w->d[k] = SP__SHIFT * g->Vq[k];
    sp__system_solve(w, w->d, w->d);
    sp__system_axpy(w, -sp__ratio(sp__dot(g->q, w->d, n), g->G[0]), g->Vq, w->d);
    sp__system_axpy(w, 1, w->d, g->Vq);
}

/* Upper end: the motion u (y - Vp) - v Vq. */
static void sp__strong_motion(sp__limit *L, sp_real u, sp_real v)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->d[k] = u * (w->y[k] - g->Vp[k]) - v * g->Vq[k];
    sp__limit_candidate(L, w->d);
}

/* Both ends from the y of this c. Upper: its motion y = c m + y0 + y1 / c + ..., its derivative y' = m - y1 / c^2 (of the last
 * step's factor, then of that at y: where H has a kink either may be better), its change Y since the y (in Vp) of the c
 * `before`, (c - before) (m - y1 / (c before)), the sum c y' - before Y / (c - before), which lacks y1, too, and the best of
 * them sharpened. Lower: its forces.                                                                  returns 1: they meet */
SP__NOINLINE static int sp__strong_ends(sp__limit *L, sp_real c, sp_real before, int sharpen)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const sp_real a = g->at;
    sp__limit_sizes(L);
    sp__limit_candidate(L, w->y);
    sp__strong_motion(L, 0, 1);
    sp__strong_motion(L, 1, 0);
    sp__system_factor(w, SP__ADMISSIBLE, w->y, SP__SHIFT);
    g->n.left--;
    if (!w->budget.spent) {
        sp__strong_derivative(L);
        sp__strong_motion(L, 0, 1);
        if (before > 0) sp__strong_motion(L, -before / (c - before), sp__ratio(c, g->G[0]));
    }
    if (!w->budget.spent && a >= 0 && a * L->ref > L->r.lower && sp__limit_forces(L, 1, a, 0, L->r.ray))
        sp__limit_carried(L, a * L->ref, L->r.ray);
    if (sharpen && L->best < SP__HUGE && !sp__strong_met(L)) sp__limit_sharpen(L);
    return sp__strong_met(L);
}

/* What is left of the steps beyond so many is put aside.                                  returns how many */
static int32_t sp__strong_spare(sp__newton *n, int32_t most)
{
    const int32_t spare = n->left > most ? n->left - most : 0;
    n->left -= spare;
    return spare;
}

/* Both ends, by larger and larger c, until they meet or lambda no longer changes. Where Newton fails, c goes back to its last
 * value and takes a smaller step from there.                                                     returns 1: they are near
 * enough to close the bracket */
SP__NOINLINE static int sp__strong_run(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real most = 0, sum = 0, last = -SP__HUGE;
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        sum += w->measure.size[2 * (size_t)i];
        most = sp__max(most, w->measure.size[2 * (size_t)i]);
    }
    memset(w->y, 0, n * sizeof *w->y);
    sp__limit_loads(L, 0);
    g->n.best = SP__HUGE;
    sp_real c = sum * most, before = 0, times = 10;
    int32_t others = sp__strong_spare(&g->n, SP__STRONG_MOST);
    int met = 0;
    for (int stage = 0, still = 0; stage < 24 && still < 3 && !met; stage++) {
        memcpy(g->Vp, w->y, n * sizeof *g->Vp);
        if (!sp__strong_solve(L, c, !stage)) {              /* back, and not so far */
            if (!sp__newton_work_left(w, &g->n) || !stage || times < (sp_real)1.2) break;
            memcpy(w->y, g->Vp, n * sizeof *w->y);
            c /= times;
            times = SP_SQRT(times);
            sp__limit_loads(L, last);
        } else {
            still = sp__abs(g->at - last) <= SP__LIMIT_NEAR * (1 + sp__abs(last)) ? still + 1 : 0;
            last = g->at;
            met = sp__strong_ends(L, c, before, still);
            before = c;
            if (!stage) others += sp__strong_spare(&g->n, SP__STRONG_CLIMB);
            sp__limit_loads(L, last);
            times = times * times < 10 ? times * times : 10;
        }
        c *= times;
    }
    g->n.left += others;
    return sp__limit_ends_meet(L, SP__LIMIT_HALVED * L->r.tol);
}

#endif

#endif /* SP__LIMIT_STRONG_C */
