/* 7 ---------------------------------------------------------------------------------------------------------- stages */

#ifdef SP_REAL_FLOAT
#define SP__SHIFT ((sp_real)1e-6)       /* smallest diagonal shift that keeps a semidefinite matrix of unit size factorable */
#else
#define SP__SHIFT ((sp_real)1e-13)
#endif

/* Gates ---------------------------------------------------------------------------------------------------------------
 * A group of touching free blocks that reaches no support, pulled by F: every joint inside it stays as it is when the group
 * moves along F, so that motion does work |F|^2 > 0 against nothing. With no load at all f = 0 is the answer.            */

static int32_t sp__root(int32_t *up, int32_t i)
{
    while (up[i] != i) { up[i] = up[up[i]]; i = up[i]; }
    return i;
}

static void sp__join(int32_t *up, int32_t i, int32_t k)
{
    i = sp__root(up, i); k = sp__root(up, k);
    if (i < k) up[k] = i; else up[i] = k;               /* the lowest number stands for the group; 0 is "supported" */
}

static size_t sp__gates_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    (void)set; (void)scratch;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, (size_t)pb->blocks + 1, sizeof(int32_t));
    return dry.peak;
}

/* The first group without support that is pulled anywhere moves: dq = F / |F| for its blocks.     returns its size */
static int32_t sp__gates_fall(const sp_problem *pb, int32_t *up, sp_real *dq)
{
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (up[i + 1] != i + 1) continue;
        sp_real F[3] = { 0, 0, 0 };
        int32_t size = 0;
        for (int32_t k = i; k < pb->blocks; k++)
            if (sp__root(up, k + 1) == i + 1) {
                size++;
                for (size_t q = 0; q < 3; q++) F[q] += pb->p[6 * (size_t)k + q];
            }
        const sp_real force = sp__norm3(F);
        if (!(force > 0)) continue;
        for (int32_t k = i; k < pb->blocks; k++)
            if (sp__root(up, k + 1) == i + 1)
                for (size_t q = 0; q < 3; q++) dq[6 * (size_t)k + q] = F[q] / force;
        return size;
    }
    return 0;
}

static sp_status sp__gates_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    (void)set;
    int32_t *up = sp__take(arena, (size_t)pb->blocks + 1, sizeof *up);
    if (sp__failed(arena)) return SP_E_MEMORY;
    sp_real load = 0;
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) load = sp__max(load, sp__abs(pb->p[k]));
    if (!(load > 0)) {
        *claim = SP_STABLE;
        state->reason = SP_REASON_NOTHING;
        return SP_OK;
    }
    for (int32_t i = 0; i <= pb->blocks; i++) up[i] = i;
    for (int32_t i = 0; i < pb->blocks; i++) if (pb->scene->block[pb->block[i]].fixed) sp__join(up, 0, i + 1);
    for (int32_t c = 0; c < pb->contacts; c++) sp__join(up, pb->contact[c].a + 1, pb->contact[c].b + 1);
    const int32_t size = sp__gates_fall(pb, up, state->dq);
    if (size) {
        *claim = SP_UNSTABLE;
        state->reason = size > 1 ? SP_REASON_NO_SUPPORT : SP_REASON_NO_CONTACT;
    }
    state->cost.flops += 6 * (int64_t)pb->blocks;
    return SP_OK;
}

/* Bilateral force -------------------------------------------------------------------------------------------------------
 * Least squares in the metric: (G + shift) y = -p, G = Aeq S Aeq', and where p has a part that no contact resists at all
 * (then y would run off by it) that part is taken out again: y <- y - shift (G + shift)^-1 y.               [seed 2.1] */

static void sp__dual_axpy(sp__dual *w, sp_real s, const sp_real *x, sp_real *y)
{
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) y[k] += s * x[k];
}

static sp_real sp__dual_norm(const sp__dual *w, const sp_real *x)
{
    return SP_SQRT(sp__dot(x, x, 6 * (size_t)w->pb->blocks));
}

/* y += correction for gradient r by the factor at hand, r is used up. */
static void sp__bilateral_correct(sp__dual *w, int singular)
{
    sp__dual_solve(w, w->r, w->r);
    if (singular) {
        sp__dual_solve(w, w->r, w->d);
        sp__dual_axpy(w, -SP__SHIFT, w->d, w->r);
    }
    sp__dual_axpy(w, -1, w->r, w->y);
}

/* w->y: potential of the bilateral force in the metric at hand, w->r its gradient. Factorises once. */
static void sp__dual_bilateral(sp__dual *w)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp__dual_weights(w);
    sp__dual_load(w);
    sp__dual_factor(w, SP__BILATERAL, w->p, SP__SHIFT);
    const sp_real load = sp__dual_norm(w, w->p), small = 64 * (sp_real)SP_EPSILON * load;
    int singular = 0;
    sp_real last = SP__HUGE;
    for (int it = 0; it < 6; it++) {
        if (!it) for (size_t k = 0; k < n; k++) { w->y[k] = 0; w->r[k] = w->p[k]; }
        sp__bilateral_correct(w, singular);
        sp__dual_gradient(w, SP__BILATERAL, w->y, w->r, NULL);
        const sp_real now = sp__dual_norm(w, w->r);
        if (!singular && now > SP__SCALE_TOL * load) { singular = 1; it = -1; last = SP__HUGE; continue; }
        if (now <= small || now > last / 4) break;
        last = now;
    }
}

/* state->y0 <- unweighted potential of metric 1, [N/m]: f0 = Aeq' y0. */
static void sp__dual_hint(const sp__dual *w, sp_state *state)
{
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) state->y0[k] = w->unit * w->z[k] * w->y[k];
    state->has_y0 = 1;
}

/* state->f <- forces of potential y in newtons. */
static void sp__dual_forces(sp__dual *w, sp__law law, const sp_real *y, sp_state *state)
{
    sp__dual_gradient(w, law, y, w->r, state->f);
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        for (size_t k = 3 * (size_t)t->point; k < 3 * (size_t)(t->point + t->points); k++) state->f[k] *= w->unit;
    }
}

static sp_status sp__least_squares_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                                       sp_verdict *claim)
{
    sp__dual w;
    if (sp__dual_open(&w, pb, set, 0, &state->cost, arena)) return SP_E_MEMORY;
    sp__dual_bilateral(&w);
    sp__dual_hint(&w, state);
    sp__dual_forces(&w, SP__BILATERAL, w.y, state);
    *claim = SP_STABLE;
    return SP_OK;
}

/* Exact -----------------------------------------------------------------------------------------------------------------
 * Semismooth Newton on the dual with a line search, from the bilateral potential; where that stalls (collapse, or close to
 * it), the proximal path: minimise D(y) + prox |y|^2 / 2 for prox = 0.1, 0.001, ... Either the imbalance vanishes, or -y
 * grows into the mechanism.                                                     [Qi, Sun 1993; Rockafellar 1976] */

typedef struct sp__newton {
    sp_real prox;                       /* weight of |y|^2 / 2 */
    sp_real shift;                      /* on the diagonal of the Hessian, beyond prox */
    sp_real omega, best;                /* of the current y, of the best (kept in state->y) */
    sp_real goal;                       /* omega to reach */
    int32_t left;                       /* factorisations */
    int proved;                         /* state->dq holds a proof */
} sp__newton;

/* Step length: slope(s) = d/ds [D(y + s d) + prox |y + s d|^2 / 2] brought below a fifth of its start. */
static sp_real sp__newton_search(sp__dual *w, sp_real prox)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp_real yd = prox * sp__dot(w->y, w->d, n), dd = prox * sp__dot(w->d, w->d, n);
    const sp_real start = sp__dot(w->r, w->d, n) + yd;
    const sp_real noise = 64 * (sp_real)SP_EPSILON * sp__dual_norm(w, w->p) * sp__dual_norm(w, w->d);
    const sp_real enough = sp__max((sp_real)0.2 * sp__abs(start), noise);
    sp_real lo = 0, flo = start, hi = 0, fhi = 0, s = 1;
    if (!(start < -noise)) return 1;
    for (int it = 0; it < 14; it++) {
        const sp_real f = sp__dual_slope(w, w->y, w->d, s) + yd + s * dd;
        if (sp__abs(f) <= enough) return s;
        if (f < 0) { lo = s; flo = f; }
        else { hi = s; fhi = f; }
        if (!(hi > 0)) {
            if (s > 1000) return s;
            s *= 4;
            continue;
        }
        s = lo + (hi - lo) * (-flo / (fhi - flo));
        const sp_real edge = (sp_real)0.1 * (hi - lo);          /* keep off the ends, or one of them never moves */
        if (s < lo + edge) s = lo + edge;
        if (s > hi - edge) s = hi - edge;
    }
    return lo > 0 ? lo : s;
}

/* (p . dq - sum c_v |P_K(u_v)|) / sum (sbar |v| + Sbar |w|) for dq = -y, as the certificate check defines it. */
static sp_real sp__newton_proof(sp__dual *w, const sp_real *y)
{
    const sp_problem *pb = w->pb;
    sp_real scale = 0, resist = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *yi = y + 6 * (size_t)i, *s = w->size + 2 * (size_t)i, *z = w->weight + 2 * (size_t)i;
        scale += s[0] * z[0] * sp__norm3(yi) + s[1] * z[1] * sp__norm3(yi + 3);
    }
    const sp_real work = -sp__dot(w->p, y, 6 * (size_t)pb->blocks);
    if (!(work > 0)) return 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], sum = 0, cap = SP__HUGE;
        sp__dual_twist(w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3];
            sp__dual_rate(w, V, W, pb->local[v], u);
            sp__cone_project(&w->cone, w->mu[c], u, u);
            sum += sp__norm3(u);
        }
        if (t->a >= 0) cap = w->size[2 * (size_t)t->a];
        if (t->b >= 0 && w->size[2 * (size_t)t->b] < cap) cap = w->size[2 * (size_t)t->b];
        resist += w->set->force_bound * cap * sum;
    }
    sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST);
    return sp__ratio(work - resist, scale);
}

/* Keep y as the mechanism if it is a proof. */
static void sp__newton_try(sp__dual *w, sp__newton *n, const sp_real *y, sp_state *state)
{
    if (n->proved || sp__newton_proof(w, y) <= 2 * w->set->tol) return;
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) state->dq[k] = -w->z[k] * y[k];
    n->proved = 1;
}

/* After a step: gradient, imbalance, best so far. */
static void sp__newton_look(sp__dual *w, sp__newton *n, sp_state *state)
{
    sp__dual_gradient(w, SP__ADMISSIBLE, w->y, w->r, NULL);
    n->omega = sp__dual_omega(w, w->r);
    if (n->omega < n->best) {
        n->best = n->omega;
        memcpy(state->y, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    }
}

/* One Newton step; returns its length. Candidates for a proof on the way: the step, and the part of y that nothing resists,
 * (H + prox)^-1 y, which one more solve brings out. */
static sp_real sp__newton_step(sp__dual *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp__dual_factor(w, SP__ADMISSIBLE, w->y, n->prox + n->shift);
    n->left--;
    state->cost.iterations++;
    if (n->omega > n->goal && n->prox > 0) {
        sp__dual_solve(w, w->y, w->d);
        sp__newton_try(w, n, w->d, state);
    }
    for (size_t k = 0; k < size; k++) w->d[k] = -w->r[k] - n->prox * w->y[k];
    sp__dual_solve(w, w->d, w->d);
    if (n->omega > (sp_real)1e-6) sp__newton_try(w, n, w->d, state);
    const sp_real s = sp__newton_search(w, n->prox);
    sp__dual_axpy(w, s, w->d, w->y);
    sp__newton_look(w, n, state);
    if (n->omega > (sp_real)1e-6) sp__newton_try(w, n, w->y, state);
    return s;
}

/* The goal is reached: a few more steps with the factor at hand while each gains a digit. */
static void sp__newton_finish(sp__dual *w, sp__newton *n, sp_state *state)
{
    for (int it = 0; it < 4; it++) {
        const sp_real last = n->omega;
        for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->d[k] = -w->r[k];
        sp__dual_solve(w, w->d, w->d);
        sp__dual_axpy(w, 1, w->d, w->y);
        sp__newton_look(w, n, state);
        if (n->omega > last / 10) break;
    }
}

/* Plain Newton: quadratic unless close to collapse. Gives up after two tiny steps. */
static void sp__newton_plain(sp__dual *w, sp__newton *n, sp_state *state)
{
    int tiny = 0;
    n->prox = 0;
    n->shift = SP__SHIFT;
    for (int it = 0; it < 12 && n->left > 0 && n->omega > n->goal && !n->proved && tiny < 2; it++) {
        const sp_real s = sp__newton_step(w, n, state);
        if (s < (sp_real)0.03) { tiny++; n->shift = n->shift * 1000 < 1 ? n->shift * 1000 : 1; }
        if (s > (sp_real)0.5) n->shift = sp__max(SP__SHIFT, n->shift / 100);
    }
}

/* Proximal path from y = 0. */
static void sp__newton_path(sp__dual *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    for (size_t k = 0; k < size; k++) w->y[k] = 0;
    n->prox = (sp_real)0.1;
    n->shift = 0;
    sp__newton_look(w, n, state);
    while (n->left > 0 && n->omega > n->goal && !n->proved) {
        sp__newton_step(w, n, state);
        const sp_real y = n->prox * sp__dual_norm(w, w->y), r = sp__dual_norm(w, w->r);
        for (size_t k = 0; k < size; k++) w->d[k] = w->r[k] + n->prox * w->y[k];
        const sp_real inner = sp__dual_norm(w, w->d);
        if (inner > (sp_real)0.3 * y && inner > (sp_real)0.1 * r) continue;
        if (n->prox <= SP__SHIFT / 10) return;
        n->prox /= 100;
    }
}

/* A proof sharpened: (H + shift)^-1 once more on the mechanism takes out what contacts still resist. */
static sp_status sp__exact_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    sp__dual w;
    sp__newton n = { 0, 0, 0, SP__HUGE, set->tol / 4, set->iterations, 0 };
    if (sp__dual_open(&w, pb, set, 0, &state->cost, arena)) return SP_E_MEMORY;
    sp__dual_bilateral(&w);
    sp__dual_hint(&w, state);
    sp__dual_sizes(&w, w.y);
    if (sp__dual_metric(&w)) sp__dual_bilateral(&w);
    sp__newton_try(&w, &n, w.y, state);
    sp__newton_look(&w, &n, state);
    sp__newton_plain(&w, &n, state);
    if (!n.proved && n.omega > n.goal) sp__newton_path(&w, &n, state);
    if (!n.proved && n.omega <= n.goal) sp__newton_finish(&w, &n, state);
    sp__dual_forces(&w, SP__ADMISSIBLE, state->y, state);
    *claim = n.proved ? SP_UNSTABLE : n.best <= set->tol ? SP_STABLE : SP_UNDECIDED;
    state->reason = n.proved ? SP_REASON_MECHANISM : n.left > 0 ? SP_REASON_LIMIT : SP_REASON_BUDGET;
    return SP_OK;
}

static size_t sp__dual_stage_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__dual_need(pb, set, scratch);
}
