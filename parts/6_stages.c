/* 7 ---------------------------------------------------------------------------------------------------------- stages */

#ifdef SP_REAL_FLOAT
#define SP__SHIFT ((sp_real)1e-6)       /* diagonal shift that keeps a semidefinite matrix of unit size factorable */
#define SP__PROX ((sp_real)3e-7)        /* end of the proximal path: a few roundings of the diagonal */
#else
#define SP__SHIFT ((sp_real)1e-13)
#define SP__PROX ((sp_real)1e-15)
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
    for (size_t k = 0; k < n; k++) w->y[k] = 0;
    sp__dual_factor(w, SP__BILATERAL, w->y, SP__SHIFT);
    sp__dual_load(w, w->r);
    w->load = sp__dual_norm(w, w->r);
    const sp_real load = w->load, small = 64 * (sp_real)SP_EPSILON * load;
    int singular = 0;
    sp_real last = SP__HUGE;
    for (int it = 0; it < 6; it++) {
        if (!it) { for (size_t k = 0; k < n; k++) w->y[k] = 0; sp__dual_load(w, w->r); }
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

static sp_status sp__bilateral_run(const sp_problem *pb, const sp_settings *set, sp__form form, sp_state *state,
                                   sp_arena *arena, sp_verdict *claim)
{
    sp__dual *w = sp__dual_open(pb, set, form, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    sp__dual_bilateral(w);
    sp__dual_hint(w, state);
    sp__dual_forces(w, SP__BILATERAL, w->y, state);
    *claim = SP_STABLE;
    state->reason = SP_REASON_STAGES;
    return SP_OK;
}

static sp_status sp__least_squares_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                                       sp_verdict *claim)
{
    return sp__bilateral_run(pb, set, SP__EXACT, state, arena, claim);
}

static sp_status sp__dense_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    return sp__bilateral_run(pb, set, SP__EXACT_DENSE, state, arena, claim);
}

static size_t sp__sparse_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__dual_need(pb, set, 0, scratch);
}

static size_t sp__dense_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__dual_need(pb, set, 1, scratch);
}

/* Polish ----------------------------------------------------------------------------------------------------------------
 * Alternating projections between the cones and E = { Aeq f + p = 0 }:  f <- P_K(f),  f <- f - Aeq' G^-1 (Aeq f + p), one
 * factor of G = Aeq Aeq'. Ends when the forces in the cones balance, or when 250 rounds gain less than 5 %: an empty
 * intersection never ends by itself, so this stage can only say STABLE.                                  [seed 2.2] */

#define SP__POLISH_WINDOW 250           /* rounds between looks at the progress */
#define SP__POLISH_ROUNDS 20000
#define SP__POLISH_GAIN ((sp_real)0.95)

/* f <- P_K(f) and r = Aeq f + p of it; with y also first f <- f + Aeq' y. */
static void sp__polish_round(sp__dual *w, const sp_real *y, sp_real *f, sp_real *r)
{
    const sp_problem *pb = w->pb;
    sp__dual_load(w, r);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 }, u[3], m[3];
        sp__dual_twist(w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real *g = f + 3 * (size_t)v;
            sp__dual_rate(w, V, W, pb->local[v], u);
            for (int k = 0; k < 3; k++) u[k] += g[k];
            sp__cone_project(&w->cone, w->mu[c], u, g);
            sp__cross3(pb->local[v], g, m);
            for (int k = 0; k < 3; k++) { F[k] += g[k]; M[k] += m[k]; }
        }
        sp__dual_scatter(w, t, F, M, r);
    }
    sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST);
}

static sp_status sp__polish_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    sp__dual *w = sp__dual_open(pb, set, SP__EXACT, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    const size_t n = 6 * (size_t)pb->blocks;
    sp__dual_bilateral(w);
    sp__dual_hint(w, state);
    sp__dual_sizes(w, w->y);
    memset(state->f, 0, 3 * (size_t)pb->points * sizeof *state->f);
    sp__polish_round(w, w->y, state->f, w->r);
    sp_real omega = sp__dual_omega(w, w->r), last = omega;
    for (int round = 1; omega > set->tol / 4 && round <= SP__POLISH_ROUNDS; round++) {
        sp__dual_solve(w, w->r, w->y);
        for (size_t k = 0; k < n; k++) w->y[k] = -w->y[k];
        sp__polish_round(w, w->y, state->f, w->r);
        omega = sp__dual_omega(w, w->r);
        state->cost.iterations++;
        if (round % SP__POLISH_WINDOW) continue;
        if (omega > SP__POLISH_GAIN * last) break;
        last = omega;
    }
    for (size_t k = 0; k < 3 * (size_t)pb->points; k++) state->f[k] *= w->unit;
    *claim = omega <= set->tol ? SP_STABLE : SP_UNDECIDED;
    state->reason = SP_REASON_STAGES;
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
    const sp_real noise = 64 * (sp_real)SP_EPSILON * w->load * sp__dual_norm(w, w->d);
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
    const sp_real work = -sp__dual_work(w, y);
    if (!(work > 0)) return 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], sum = 0;
        sp__dual_twist(w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3];
            sp__dual_rate(w, V, W, pb->local[v], u);
            sp__cone_project(&w->cone, w->mu[c], u, u);
            sum += sp__norm3(u);
        }
        resist += w->set->force_bound * sp__lesser(t, w->size, 2) * sum;
    }
    sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST);
    return work > resist ? sp__ratio(work - resist, scale) : 0;
}

/* Keep y as the mechanism if it is a proof. */
static void sp__newton_try(sp__dual *w, sp__newton *n, const sp_real *y, sp_state *state)
{
    if (n->proved || sp__newton_proof(w, y) <= 2 * w->set->tol) return;
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) state->dq[k] = -w->z[k] * y[k];
    n->proved = 1;
}

/* Rigid groups: a mechanism moves blocks together in few groups, but inverse iteration leaves a little play inside them (its
 * square is what the Hessian sees), which a long chain magnifies. So blocks without play are tied to the motion of one of
 * them, the root: x_i = (v + w x (c_i - c_root), w), and conjugate gradients on the tied motions remove what the contacts
 * between groups still resist.                                                             [Hestenes, Stiefel 1952] */

/* up[i + 1]: group of free block i by its lowest number + 1, 0: the ground; joined where no vertex of a contact moves by more
 * than `play` of its blocks' motion. Blocks held in some directions stay with the ground. */
static void sp__rigid_groups(const sp__dual *w, const sp_real *x, sp_real play, int32_t *up)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i <= pb->blocks; i++) up[i] = i;
    for (int32_t i = 0; i < pb->blocks; i++) if (pb->scene->block[pb->block[i]].fixed) sp__join(up, 0, i + 1);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], most = 0, size = 0;
        sp__dual_twist(w, t, x, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3];
            sp__dual_rate(w, V, W, pb->local[v], u);
            most = sp__max(most, sp__norm3(u));
        }
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real *m = x + 6 * (size_t)i, *z = w->weight + 2 * (size_t)i;
            size = sp__max(size, z[0] * sp__norm3(m) + z[1] * sp__norm3(m + 3) * sp__norm3(side ? t->rb : t->ra));
        }
        if (most <= play * size) sp__join(up, t->a + 1, t->b + 1);
    }
}

/* The root of i's group and the arm from it; -1: the ground. */
static int32_t sp__rigid_root(const sp__dual *w, int32_t *up, int32_t i, sp_real arm[3])
{
    const sp_problem *pb = w->pb;
    const int32_t g = sp__root(up, i + 1) - 1;
    if (g >= 0) sp__sub3(pb->scene->block[pb->block[i]].centroid, pb->scene->block[pb->block[g]].centroid, arm);
    return g;
}

/* Every block's weighted motion from its root's, in place. */
static void sp__rigid_prolong(const sp__dual *w, int32_t *up, sp_real *x)
{
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        sp_real arm[3], m[6], turn[3], *xi = x + 6 * (size_t)i;
        const int32_t g = sp__rigid_root(w, up, i, arm);
        if (g == i) continue;
        if (g < 0) { memset(xi, 0, 6 * sizeof *xi); continue; }
        const sp_real *z = w->weight + 2 * (size_t)i, *s = w->weight + 2 * (size_t)g;
        for (int k = 0; k < 6; k++) m[k] = s[k / 3] * x[6 * (size_t)g + (size_t)k];
        sp__cross3(m + 3, arm, turn);
        for (int k = 0; k < 3; k++) { xi[k] = (m[k] + turn[k]) / z[0]; xi[k + 3] = m[k + 3] / z[1]; }
    }
}

/* Its transpose: every block's weighted row onto its root's, in place; other rows become 0. */
static void sp__rigid_restrict(const sp__dual *w, int32_t *up, sp_real *r)
{
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        sp_real arm[3], f[6], turn[3], *ri = r + 6 * (size_t)i;
        const int32_t g = sp__rigid_root(w, up, i, arm);
        if (g == i) continue;
        const sp_real *z = w->weight + 2 * (size_t)i;
        for (int k = 0; k < 6; k++) { f[k] = ri[k] / z[k / 3]; ri[k] = 0; }
        if (g < 0) continue;
        const sp_real *s = w->weight + 2 * (size_t)g;
        sp_real *rg = r + 6 * (size_t)g;
        sp__cross3(arm, f, turn);
        for (int k = 0; k < 3; k++) { rg[k] += s[0] * f[k]; rg[k + 3] += s[1] * (f[k + 3] + turn[k]); }
    }
}

/* out = Aeq S DP_K(Aeq' y) Aeq' x, weighted. */
static void sp__dual_apply(sp__dual *w, const sp_real *y, const sp_real *x, sp_real *out)
{
    const sp_problem *pb = w->pb;
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) out[k] = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], dV[3], dW[3], F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 };
        sp__dual_twist(w, t, y, V, W);
        sp__dual_twist(w, t, x, dV, dW);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real *l = pb->local[v];
            sp_real u[3], D[6], g[3], m[3];
            sp__dual_rate(w, V, W, l, u);
            if (sp__cone_derivative(&w->cone, w->mu[c], u, D) == SP__APEX) continue;
            sp__dual_rate(w, dV, dW, l, u);
            g[0] = w->S[c] * (D[0] * u[0] + D[1] * u[1] + D[2] * u[2]);
            g[1] = w->S[c] * (D[1] * u[0] + D[3] * u[1] + D[4] * u[2]);
            g[2] = w->S[c] * (D[2] * u[0] + D[4] * u[1] + D[5] * u[2]);
            sp__cross3(l, g, m);
            for (int k = 0; k < 3; k++) { F[k] += g[k]; M[k] += m[k]; }
        }
        sp__dual_scatter(w, t, F, M, out);
    }
    sp__dual_count(w, 2 * SP__FLOPS_SWEEP, 2 * SP__FLOPS_TWIST);
}

/* Tie the candidate w->d and sharpen it; w->r, L.t and state->dq are used up.     returns 0 when everything is tied down */
static int sp__rigid_sharpen(sp__dual *w, int32_t *up, sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real *x = w->d, *r = w->r, *p = state->dq, *q = w->L.t;
    sp__rigid_prolong(w, up, x);
    if (!(sp__dual_norm(w, x) > 0)) return 0;
    sp__dual_apply(w, w->y, x, r);
    sp__rigid_restrict(w, up, r);
    for (size_t k = 0; k < n; k++) p[k] = r[k] = -r[k];
    sp_real rr = sp__dot(r, r, n);
    for (int it = 0; it < 40 && rr > 0; it++) {
        sp__rigid_prolong(w, up, p);
        sp__dual_apply(w, w->y, p, q);
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

/* Nothing resists a mechanism: it is a null vector of the Hessian, and inverse iteration brings it out of x (used up). */
static void sp__newton_purify(sp__dual *w, sp__newton *n, sp_real *x, sp_state *state)
{
    for (int it = 0; it < 2 && !n->proved; it++) {
        sp__dual_solve(w, x, x);
        const sp_real size = sp__dual_norm(w, x);
        if (!(size > 0)) return;
        for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) x[k] /= size;
        sp__newton_try(w, n, x, state);
    }
}

/* The candidate in w->d, tied into rigid groups. */
static void sp__newton_tie(sp__dual *w, sp__newton *n, sp_state *state)
{
    if (n->proved) return;
    sp__rigid_groups(w, w->d, (sp_real)1e-6, w->xadj);
    if (sp__rigid_sharpen(w, w->xadj, state)) sp__newton_try(w, n, w->d, state);
    sp__dual_gradient(w, SP__ADMISSIBLE, w->y, w->r, NULL);
}

/* One Newton step; returns its length. On the way y, the step and what inverse iteration makes of them are tried as proofs. */
static sp_real sp__newton_step(sp__dual *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp__dual_factor(w, SP__ADMISSIBLE, w->y, n->prox + n->shift);
    n->left--;
    state->cost.iterations++;
    if (n->prox > 0 && n->prox < (sp_real)1e-4) {
        memcpy(w->d, w->y, size * sizeof *w->d);
        sp__newton_purify(w, n, w->d, state);
        if (n->prox < (sp_real)1e-8) sp__newton_tie(w, n, state);
    }
    for (size_t k = 0; k < size; k++) w->d[k] = -w->r[k] - n->prox * w->y[k];
    sp__dual_solve(w, w->d, w->d);
    sp__newton_try(w, n, w->d, state);
    const sp_real s = sp__newton_search(w, n->prox);
    sp__dual_axpy(w, s, w->d, w->y);
    sp__newton_look(w, n, state);
    if (n->omega > n->goal && !n->proved) {
        sp__newton_try(w, n, w->y, state);
        if (s > 10) sp__newton_purify(w, n, w->d, state);
    }
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
    for (int extra = 8; extra > 0 && n->left > 0 && n->omega > n->goal && !n->proved; ) {
        sp__newton_step(w, n, state);
        if (n->prox <= SP__SHIFT) { extra--; continue; }
        const sp_real y = n->prox * sp__dual_norm(w, w->y), r = sp__dual_norm(w, w->r);
        for (size_t k = 0; k < size; k++) w->d[k] = w->r[k] + n->prox * w->y[k];
        const sp_real inner = sp__dual_norm(w, w->d);
        if (inner > (sp_real)0.3 * y && inner > (sp_real)0.1 * r) continue;
        n->prox = n->prox > 100 * SP__SHIFT ? n->prox / 100 : SP__PROX;
    }
}

static sp_status sp__exact_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    sp__newton n = { 0, 0, 0, SP__HUGE, set->tol / 4, set->iterations, 0 };
    sp__dual *w = sp__dual_open(pb, set, SP__EXACT, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    sp__dual_bilateral(w);
    sp__dual_hint(w, state);
    sp__dual_sizes(w, w->y);
    if (sp__dual_metric(w)) sp__dual_bilateral(w);
    sp__newton_try(w, &n, w->y, state);
    sp__newton_look(w, &n, state);
    sp__newton_plain(w, &n, state);
    if (!n.proved && n.omega > n.goal) sp__newton_path(w, &n, state);
    if (!n.proved && n.omega <= n.goal) sp__newton_finish(w, &n, state);
    sp__dual_forces(w, SP__ADMISSIBLE, state->y, state);
    *claim = n.proved ? SP_UNSTABLE : n.best <= set->tol ? SP_STABLE : SP_UNDECIDED;
    state->reason = n.proved ? SP_REASON_MECHANISM : n.best <= set->tol ? SP_REASON_FORCES
                  : n.left > 0 ? SP_REASON_LIMIT : SP_REASON_BUDGET;
    return SP_OK;
}
