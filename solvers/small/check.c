/* check: sp_check, sp_memory and sp_plan in SP_SMALL; the full build's are in check/. */
#ifndef SP__SMALL_CHECK_C
#define SP__SMALL_CHECK_C

#include "../check/memory.c"

#if SP__WITH_SMALL

/* The exact stage of SP_SMALL, in as little code as does it. Newton's method on the dual of statics/
 *
 *   D(y) = 1/2 sum S_v |P_K(u_v)|^2 + p . y,   u = Aeq' y,   f = S P_K(u)         [Qi, Sun 1993; Rockafellar 1976]
 *
 * vertex by vertex in world axes, its Hessian in an envelope in the order of the blocks. What forces and motions are worth it
 * asks the certificate check, of which it uses the scales and sums but nothing else: that check uses nothing of this. */

#define SP__FLOPS_VERTEX 900            /* a vertex in a Hessian, at most; its gradient and a judgement together no more */

/* What a sweep computes; linear: P_K = 1, bilateral. */
typedef enum sp__want { SP__GRADIENT, SP__HESSIAN, SP__LINEAR, SP__LINEAR_HESSIAN } sp__want;

typedef struct sp__small {
    const sp_problem *pb;
    const sp_settings *set;
    sp_real *H;                         /* envelope */
    int32_t *row;                       /* 6b: of it */
    sp_real *z;                         /* 6b: weights of the rows, 0 where a block is held */
    sp_real *y, *r, *d, *x, *base;      /* 6b each: potential, gradient, step, motion -z y, y before a step */
    sp_real *best;                      /* 6b: y of the least imbalance */
    sp_real e[3][12];                   /* n, t1, t2 of a vertex as rows of -Aeq', the lower block first */
    int32_t side[2];                    /* these blocks, -1: a support */
    sp_real metric, S;                  /* 1 / largest cap, or 0: S = 1; S of the contact at hand */
    sp_real prox, imbalance;                /* weight of |y|^2 / 2; the least imbalance so far */
    int64_t flops;                      /* of a factor */
    int32_t sweeps, left;               /* passes over the vertices so far; factorisations that may follow */
    int32_t stalled;                    /* the imbalance no longer falls with prox: something moves */
    sp_result *to;                      /* forces and motion tried last; verdict once decided */
    sp__certifier j;
} sp__small;

/* Rows of the envelope.                                                            returns its size, -1: too large to count */
static int64_t sp__small_rows(sp__small *w, const sp_problem *pb)
{
    int32_t *row = w->row;
    int64_t size = 0;
    w->flops = 0;
    for (int32_t i = 0; i < pb->blocks; i++) row[6 * i] = i;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int32_t a = pb->contact[c].a, b = pb->contact[c].b, low = a < b ? a : b, high = a < b ? b : a;
        if (low >= 0 && low < row[6 * high]) row[6 * high] = low;
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        const int32_t first = row[6 * i];
        for (int32_t k = 6 * i; k < 6 * i + 6; k++) {
            row[k] = (int32_t)size - 6 * first;
            const int64_t length = k + 1 - 6 * first;
            size += length;
            w->flops += length * length;
            if (size > INT32_MAX) return -1;
        }
    }
    return size;
}

/* The search's own arrays in `a`, rows in `rows`: the same arena, or scratch where `a` only counts.    returns 0: no memory */
static int sp__small_carve(sp__small *w, const sp_problem *pb, sp_arena *rows, sp_arena *a)
{
    w->row = sp__take(rows, (size_t)pb->blocks, 6 * sizeof *w->row);
    const int64_t entries = sp__failed(rows) ? -1 : sp__small_rows(w, pb);
    if (entries < 0) return 0;
    const size_t n = 6 * (size_t)pb->blocks;
    sp_real *v = sp__take(a, n, 7 * sizeof *v);
    w->H = sp__take(a, (size_t)entries, sizeof *w->H);
    if (sp__failed(a)) return 0;
    if (!v) return 1;                                   /* counted */
    w->z = v;
    w->y = v += n;
    w->r = v += n;
    w->d = v += n;
    w->x = v += n;
    w->base = v += n;
    w->best = v + n;
    return 1;
}

/* y += s x */
static void sp__small_axpy(const sp__small *w, sp_real s, const sp_real *x, sp_real *y)
{
    sp__add(y, 1, s, x, 6 * (size_t)w->pb->blocks);
}

static sp_real sp__small_dot(const sp__small *w, const sp_real *x, const sp_real *y)
{
    return sp__dot(x, y, 6 * (size_t)w->pb->blocks);
}

/* x = -z y: the motion of a potential */
static void sp__small_motion(const sp__small *w, const sp_real *y)
{
    for (int32_t k = 0; k < 6 * w->pb->blocks; k++) w->x[k] = -w->z[k] * y[k];
}

/* Row k of a vertex: (s e, s arm x e) of both blocks, the rates -Aeq'.                                   returns u = row . x */
static sp_real sp__small_row(sp__small *w, const sp_contact *t, int32_t v, int k, const sp_real axis[3])
{
    sp_real u = 0;
    for (int side = 0; side < 2; side++) {
        const int32_t i = w->side[side];
        sp_real arm[3], *e = w->e[k] + 6 * side;
        if (i < 0) continue;
        sp__arm(w->pb, i, v, arm);
        sp__scale3(i == t->a ? (sp_real)1 : (sp_real)-1, axis, e);
        sp__cross3(arm, e, e + 3);
        u += sp__dot(e, w->x + 6 * (size_t)i, 6);
    }
    return u;
}

/* H += s e e' */
static void sp__small_add_square(sp__small *w, sp_real s, const sp_real *e)
{
    for (int p = w->side[0] < 0 ? 6 : 0; p < 12; p++) {
        const int32_t i = 6 * w->side[p / 6] + p % 6;
        const sp_real se = s * e[p];
        for (int side = w->side[0] < 0; side <= p / 6; side++) {
            sp_real *h = w->H + w->row[i] + 6 * w->side[side];
            const sp_real *g = e + 6 * side;
            for (int q = 0; q < (side < p / 6 ? 6 : p % 6 + 1); q++) h[q] += se * g[q];
        }
    }
}

/* One vertex: f = S P_K(u), r += Aeq f, H += Aeq S DP_K(u) Aeq'. On the cone's side P_K(u) = (g.u) g, g = (1, mu w) normed,
 * w = ut / |ut|, and DP_K = g g' + (mu fn / |ut|) w_perp w_perp'. */
SP__NOINLINE static void sp__small_vertex(sp__small *w, const sp_contact *t, int32_t v, sp__want want)
{
    const sp_real mu = t->joint->strength.mu;
    const sp_real u[3] = { sp__small_row(w, t, v, 0, t->joint->n), sp__small_row(w, t, v, 1, t->joint->t1),
                           sp__small_row(w, t, v, 2, t->joint->t2) };
    sp_real *f = w->to->f + 3 * (size_t)v, slope[3];
    const sp_real a = SP_SQRT(u[1] * u[1] + u[2] * u[2]);
    for (int k = 0; k < 3; k++) { f[k] = w->S * u[k]; slope[k] = 1; }
    if (want < SP__LINEAR && !(u[0] >= 0 && a <= mu * u[0])) {
        const sp_real fn = (u[0] + mu * a) / (1 + mu * mu), q = 1 / SP_SQRT(1 + mu * mu);
        f[0] = f[1] = f[2] = 0;
        if (!(mu * a > -u[0])) return;
        const sp_real x = u[1] / a, y = u[2] / a;
        f[0] = w->S * fn; f[1] = mu * x * f[0]; f[2] = mu * y * f[0];
        for (int k = 0; k < 12; k++) {
            const sp_real n = w->e[0][k], e = w->e[1][k], g = w->e[2][k];
            w->e[0][k] = q * (n + mu * (x * e + y * g));
            w->e[1][k] = x * g - y * e;
        }
        slope[1] = mu * fn / a; slope[2] = 0;
    }
    const sp_real c[3] = { slope[2] > 0 ? f[0] : SP_SQRT(1 + mu * mu) * f[0], slope[2] * f[1], slope[2] * f[2] };
    for (int k = 0; k < 3; k++) {
        for (int side = 0; side < 2; side++)
            for (int q = 0; q < 6 && w->side[side] >= 0; q++) w->r[6 * w->side[side] + q] -= c[k] * w->e[k][6 * side + q];
        if (want & SP__HESSIAN && slope[k] > 0) sp__small_add_square(w, w->S * slope[k], w->e[k]);
    }
}

/* f, and r = z (Aeq f + p), at y; H too where it is wanted, not yet weighted. */
SP__NOINLINE static void sp__small_sweep(sp__small *w, const sp_real *y, sp__want want)
{
    const sp_problem *pb = w->pb;
    const int32_t n = 6 * pb->blocks;
    for (int32_t i = 0; i < pb->blocks; i++) sp__certifier_load(&w->j, i, w->r + 6 * i);
    sp__small_motion(w, y);
    if (want & SP__HESSIAN) memset(w->H, 0, (size_t)(w->row[n - 1] + n) * sizeof *w->H);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        w->S = w->metric > 0 ? w->metric * sp__certifier_force_cap(&w->j, t) : 1;
        if (!(w->S > 0)) w->S = 1;
        w->side[0] = t->a < t->b ? t->a : t->b;
        w->side[1] = t->a < t->b ? t->b : t->a;
        for (int32_t v = t->point; v < t->point + t->points; v++) sp__small_vertex(w, t, v, want);
    }
    for (int32_t k = 0; k < n; k++) w->r[k] *= w->z[k];
    w->sweeps++;
}

/* L L' = Z H Z + shift */
static void sp__small_factor(sp__small *w, sp_real shift)
{
    const int32_t n = 6 * w->pb->blocks;
    for (int32_t i = 0; i < n; i++) {
        sp_real *h = w->H + w->row[i];
        for (int32_t k = sp__envelope_first(w->row, i); k <= i; k++) h[k] *= w->z[i] * w->z[k];
        h[i] += shift;
    }
    sp__envelope_factor(w->H, w->row, n, 4 * (sp_real)SP_EPSILON);
    w->to->spent.total.factorisations++;
}

/* x <- (L L')^-1 s b; x may be b. */
static void sp__small_solve(const sp__small *w, sp_real s, const sp_real *b, sp_real *x)
{
    const int32_t n = 6 * w->pb->blocks;
    for (int32_t k = 0; k < n; k++) x[k] = s * b[k];
    sp__envelope_solve(w->H, w->row, n, x);
}

/* Is dq = -z y a proof? Then that is the verdict. */
SP__NOINLINE static void sp__small_try_proof(sp__small *w, const sp_real *y)
{
    sp_result *r = w->to;
    if (r->verdict) return;
    sp__small_motion(w, y);
    if (!(sp__certify_motion(&w->j, w->x, 0, 0, &r->final) > w->set->tol)) return;
    r->least_imbalance = sp__certify_mechanism(&w->j, w->x, 0, &r->final);
    r->verdict = SP_UNSTABLE;
}

/* Do the forces of the last sweep balance? */
static void sp__small_measure(sp__small *w)
{
    sp_result *r = w->to;
    sp__to_newtons(w->j.unit, 3 * (size_t)w->pb->points, r->f, r->f);
    r->imbalance = sp__certify_forces(&w->j, r->f, r->f);
    if (r->imbalance <= w->set->tol) r->verdict = SP_STABLE;
    if (!(r->imbalance < w->imbalance)) return;
    w->imbalance = r->imbalance;
    memcpy(w->best, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->y);
}

/* Nothing resists a mechanism: it is a null vector of the Hessian, and inverse iteration brings it out of x (used up). */
static void sp__small_purify(sp__small *w, sp_real *x)
{
    for (int it = 0; it < 2 && !w->to->verdict; it++) {
        sp__small_solve(w, 1, x, x);
        const sp_real size = SP_SQRT(sp__small_dot(w, x, x));
        if (!(size > 0)) return;
        for (int32_t k = 0; k < 6 * w->pb->blocks; k++) x[k] /= size;
        sp__small_try_proof(w, x);
    }
}

/* Weights and potential of the bilateral force: rows of unit size on average; (G + shift) y = -p, and of each correction what
 * follows a null vector is taken out again.                                                                      [seed 2.1] */
SP__NOINLINE static void sp__small_bilateral(sp__small *w)
{
    const int32_t n = 6 * w->pb->blocks;
    for (int32_t k = 0; k < n; k++) { w->y[k] = 0; w->z[k] = !sp__held(w->pb, k / 6, k % 6); }
    sp__small_sweep(w, w->y, SP__LINEAR_HESSIAN);
    for (int32_t k = 0; k < n; k += 3) {
        sp_real sum = 0;
        for (int32_t q = k; q < k + 3; q++) sum += w->H[w->row[q] + q] / 3;
        for (int32_t q = k; q < k + 3 && sum > 0; q++) w->z[q] /= SP_SQRT(sum);
    }
    sp__small_factor(w, SP__SHIFT);
    sp_real last = SP__HUGE;
    for (int it = 0; ; it++) {
        sp__small_sweep(w, w->y, SP__LINEAR);
        const sp_real now = sp__small_dot(w, w->r, w->r);
        sp__small_solve(w, 1, w->r, w->d);
        sp__small_solve(w, SP__SHIFT, w->d, w->x);
        sp__small_axpy(w, -1, w->x, w->d);
        if (it == 5 || now > last / 16) break;
        sp__small_axpy(w, -1, w->d, w->y);
        last = now;
    }
}

/* Scales of the certificate check by that force, and a metric where contacts of very different load meet.
 *       returns 0: no memory */
SP__NOINLINE static int sp__small_scales(sp__small *w, sp_arena *a)
{
    const int32_t n = 6 * w->pb->blocks;
    sp_real least = SP__HUGE, most = 0;
    for (int32_t k = 0; k < n; k++) {
        w->to->y0[k] = sp__in_newtons(w->j.unit * w->z[k], w->y[k]);
        w->to->y0[n + k] = -sp__in_newtons(w->j.unit * w->z[k], w->d[k]);
    }
    if (!sp__certifier_open(&w->j, w->pb, w->set, w->to->y0, INT32_MAX, a)) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_real cap = sp__certifier_force_cap(&w->j, &w->pb->contact[c]);
        if (cap < least) least = cap;
        if (cap > most) most = cap;
    }
    if (most > 1000 * least) w->metric = 1 / most;
    return 1;
}

/* y += s d: the whole step first, then where the slope of D(y) + prox |y|^2 / 2 along d is below a fifth of its start. */
SP__NOINLINE static sp_real sp__small_move(sp__small *w)
{
    sp_real lo = 0, hi = 0, fhi = 0, s = 1, flo = sp__small_dot(w, w->r, w->d) + w->prox * sp__small_dot(w, w->y, w->d);
    const sp_real noise = 64 * (sp_real)SP_EPSILON * SP_SQRT(sp__small_dot(w, w->d, w->d));
    const int down = flo < -noise;
    const sp_real enough = sp__max(noise, (sp_real)-0.2 * flo);
    memcpy(w->base, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    for (int it = 0; ; it++) {
        memcpy(w->y, w->base, 6 * (size_t)w->pb->blocks * sizeof *w->y);
        sp__small_axpy(w, s, w->d, w->y);
        sp__small_sweep(w, w->y, SP__GRADIENT);
        const sp_real f = sp__small_dot(w, w->r, w->d) + w->prox * sp__small_dot(w, w->y, w->d);
        if (!down || !(sp__abs(f) > enough) || it == 14) break;
        if (f < 0) { lo = s; flo = f; } else { hi = s; fhi = f; }
        if (hi > 0) {
            const sp_real edge = (hi - lo) / 10, at = lo + (hi - lo) * (-flo / (fhi - flo));
            s = at < lo + edge ? lo + edge : at > hi - edge ? hi - edge : at;
        }
        else if (s > 1000) break;
        else s *= 4;
    }
    sp__small_measure(w);
    return s;
}

/* One Newton step; returns its length. On the way y, the step and what inverse iteration makes of them are tried as proofs. */
SP__NOINLINE static sp_real sp__small_step(sp__small *w, sp_real shift)
{
    w->left--;
    w->to->spent.total.iterations++;
    sp__small_sweep(w, w->y, SP__HESSIAN);
    sp__small_factor(w, w->prox + shift);
    if (w->stalled) {
        memcpy(w->d, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->d);
        sp__small_purify(w, w->d);
    }
    sp__small_axpy(w, w->prox, w->y, w->r);
    sp__small_solve(w, -1, w->r, w->d);
    sp__small_axpy(w, -w->prox, w->y, w->r);
    sp__small_try_proof(w, w->d);
    if (w->to->verdict) return 1;
    const sp_real s = sp__small_move(w);
    sp__small_try_proof(w, w->y);
    if (s > 10) sp__small_purify(w, w->d);
    return s;
}

/* May the search go on, its verdict open? */
static int sp__small_undecided(const sp__small *w) { return w->left > 0 && !w->to->verdict; }

/* Plain Newton: quadratic unless close to collapse. Gives up after two tiny steps. */
static void sp__small_plain(sp__small *w)
{
    sp_real shift = SP__SHIFT;
    w->prox = 0;
    w->stalled = 0;
    for (int it = 0, tiny = 0; it < 12 && sp__small_undecided(w) && tiny < 2; it++) {
        const sp_real s = sp__small_step(w, shift);
        if (s < (sp_real)0.03) { tiny++; shift = shift * 1000 < 1 ? shift * 1000 : 1; }
        if (s > (sp_real)0.5) shift = sp__max(SP__SHIFT, shift / 100);
    }
}

/* Proximal path from y = 0: minimise D(y) + prox |y|^2 / 2 for prox = 0.1, 0.001, ... Either the imbalance vanishes, or -y
 * grows into the mechanism. */
SP__NOINLINE static void sp__small_path(sp__small *w)
{
    sp_real level = SP__HUGE;
    for (int32_t k = 0; k < 6 * w->pb->blocks; k++) w->y[k] = 0;
    w->prox = (sp_real)0.1;
    for (int extra = 8; extra > 0 && sp__small_undecided(w); ) {
        sp__small_step(w, 0);
        if (w->to->verdict) return;
        if (w->prox <= SP__SHIFT) {
            extra--;
            continue;
        }
        const sp_real r = sp__small_dot(w, w->r, w->r), y = w->prox * w->prox * sp__small_dot(w, w->y, w->y);
        const sp_real inner = r + y + 2 * w->prox * sp__small_dot(w, w->r, w->y);
        if (inner > (sp_real)0.09 * y && inner > (sp_real)0.01 * r) continue;
        w->stalled = r > (sp_real)0.01 * level && w->prox < (sp_real)1e-4;
        level = r;
        w->prox = w->prox > 100 * SP__SHIFT ? w->prox / 100 : SP__PROX;
        w->stalled |= w->prox <= SP__DEEP;
    }
}

#ifndef SP_EXACT_ONLY
/* A motion that capped forces might resist: what they resist by is rounding, if all that resists it lets it pass in a null
 * vector of the Hessian there. */
SP__NOINLINE static void sp__small_sharpen(sp__small *w)
{
    sp_result *r = w->to;
    for (int it = 0; it < 3 && r->verdict == SP_UNSTABLE && !r->final; it++) {
        const size_t n = 6 * (size_t)w->pb->blocks;
        memcpy(w->base, w->j.dual.motion, n * sizeof *w->base);
        for (size_t k = 0; k < n; k++) w->d[k] = w->z[k] > 0 ? -w->base[k] / w->z[k] : 0;
        sp__small_sweep(w, w->d, SP__HESSIAN);
        sp__small_factor(w, SP__SHIFT);
        r->verdict = SP_UNDECIDED;
        sp__small_purify(w, w->d);
        if (r->verdict) continue;
        r->verdict = SP_UNSTABLE;
        r->least_imbalance = sp__certify_mechanism(&w->j, w->base, 0, &r->final);
        return;
    }
}
#else
static void sp__small_sharpen(sp__small *w) { (void)w; }
#endif

/* The search on a built problem, its arrays carved; those of the certificate check behind them. */
SP__NOINLINE static int sp__small_run(sp__small *w, sp_arena *a)
{
    sp_result *r = w->to;
    w->imbalance = 2 * SP__HUGE;               /* what nothing can balance is SP__HUGE, and better than no forces yet */
    w->left = w->set->iterations;
    w->j.pb = w->pb;
    w->j.unit = sp__load_unit(w->pb);
    sp__small_bilateral(w);
    if (!sp__small_scales(w, a)) return 0;
    for (int32_t k = 0; k < 6 * w->pb->blocks; k++) w->d[k] = -w->r[k];        /* what no contact takes */
    sp__small_purify(w, w->d);
    if (w->metric > 0) sp__small_bilateral(w);
    sp__small_sweep(w, w->y, SP__GRADIENT);
    sp__small_measure(w);
    sp__small_plain(w);
    sp__small_path(w);
    sp__small_plain(w);
    sp__small_sharpen(w);
    if (r->verdict != SP_STABLE) {
        sp__small_sweep(w, w->best, SP__GRADIENT);
        sp__small_measure(w);
        if (!r->verdict) r->least_imbalance = sp__certify_mechanism(&w->j, w->x, 0, &r->final);
        sp__motion_write(&w->j, r->dq);
    }
    r->spent.total.flops = w->flops * r->spent.total.factorisations
                  + (SP__FLOPS_VERTEX * (int64_t)w->sweeps + SP__FLOPS_CERTIFICATE * (int64_t)w->j.sweeps) * w->pb->points;
    return 1;
}

/* A result's numbers, its arrays in place. */
SP__NOINLINE static void sp__small_finish(sp_result *r)
{
    r->verified = r->verdict != SP_UNDECIDED;
    r->stage = r->verdict && r->counts.free_blocks ? SP_STAGE_EXACT : SP_STAGE_NONE;
    r->reason = r->verdict == SP_UNSTABLE ? SP_REASON_MECHANISM : r->verdict != SP_STABLE ? SP_REASON_LIMIT
              : r->counts.free_blocks ? SP_REASON_FORCES : SP_REASON_NOTHING;
    r->level = r->verdict == SP_STABLE ? SP_ADMISSIBLE : SP_NONE;
    if (r->verdict != SP_UNSTABLE) r->final = 0;
}

/* Numbers of a result: f, dq, y0. */
static size_t sp__small_numbers(const sp_scene *scene)
{
    sp_problem pb;
    sp__problem_count(scene, &pb);
    return 3 * (size_t)scene->count.points + 6 * (size_t)scene->count.blocks + 12 * (size_t)pb.blocks;
}

SP_API sp_status sp_check(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_result *result)
{
    sp_arena *work = settings ? settings->work : NULL;
    if (!scene || !arena || !arena->base || !result || (work && (work == arena || !work->base))) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp_arena kept = *arena;
    const size_t numbers = sp__small_numbers(scene), joints = (size_t)scene->count.joints;
    sp_real *number = sp__take(&kept, numbers, sizeof *number);
    sp_demand *demand = sp__take(&kept, joints, sizeof *demand);
    sp_arena a = work ? *work : kept;
    sp__check *c = sp__take(&a, 1, sizeof *c);
    sp__small *w = sp__take(&a, 1, sizeof *w);
    if (sp__failed(&kept) || sp__failed(&a)) return SP_E_MEMORY;
    memset(number, 0, numbers * sizeof *number);
    memset(demand, 0, joints * sizeof *demand);
    memset(c, 0, sizeof *c);
    memset(w, 0, sizeof *w);
    sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (!status) status = sp_problem_build(scene, &a, &c->pb);
    if (status) return status;
    sp_result *r = &c->r;
    r->f = number;
    r->dq = r->f + 3 * (size_t)scene->count.points;
    r->y0 = r->dq + 6 * (size_t)scene->count.blocks;
    r->demand = demand;
    r->tol = c->set.tol;
    r->force_bound = c->set.force_bound;
    r->counts.free_blocks = c->pb.blocks;
    r->counts.joints = c->pb.contacts;
    r->counts.points = sp__points_count(scene);
    r->extremes.tension_ratio = r->coupled.tension_ratio = -1;
    r->extremes.weakest = -1;
    r->islands.count = c->pb.blocks > 0;
    if (!r->islands.count) r->verdict = SP_STABLE;
    w->pb = &c->pb; w->set = &c->set; w->to = r;
    if (!sp__small_carve(w, &c->pb, &a, &a) || (r->islands.count && !sp__small_run(w, &a))) return SP_E_MEMORY;
    sp__small_finish(r);
    r->spent.by_stage[c->set.stage_count - 1] = r->spent.total;
    if (work) work->peak = a.peak; else kept.peak = a.peak;
    r->spent.peak_bytes = kept.peak;
    *arena = kept;
    *result = *r;
    return SP_OK;
}

/* Memory of a search on problem pb: its own arrays, then those of the check; rows in scratch.     returns 0: no memory */
static int sp__small_need(sp__small *w, const sp_problem *pb, const sp_settings *set, sp_arena scratch, sp_arena *dry)
{
    sp__take(dry, (size_t)pb->blocks, 6 * sizeof *w->row);
    if (!sp__small_carve(w, pb, &scratch, dry)) return 0;
    if (pb->blocks) sp__take(dry, 1, sp__certifier_need(pb, set));
    return 1;
}

/* Bytes of a check: of its result, and of all else.                         flops: of a factor; may be NULL */
static sp_status sp__small_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, int64_t *flops,
                                  size_t part[2])
{
    if (!scene || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__check *c = sp__take(&scratch, 1, sizeof *c);
    sp__small *w = sp__take(&scratch, 1, sizeof *w);
    if (!w) return SP_E_MEMORY;
    sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (!status) status = sp_problem_build(scene, &scratch, &c->pb);
    if (status) return status;
    sp_arena kept = sp__arena_dry(), dry = kept;
    sp__take(&kept, sp__small_numbers(scene), sizeof(sp_real));
    sp__take(&kept, (size_t)scene->count.joints, sizeof(sp_demand));
    sp__take(&dry, 1, sizeof *c);
    sp__take(&dry, 1, sizeof *w);
    sp__take(&dry, 1, sp__problem_memory(scene));
    if (!sp__small_need(w, &c->pb, &c->set, scratch, &dry)) return SP_E_MEMORY;
    part[0] = kept.used;
    part[1] = dry.used;
    if (flops) *flops = w->flops;
    return SP_OK;
}

/* Both parts in one arena. */
static size_t sp__small_sum(const size_t part[2]) { return ((part[0] + (SP_ALIGN - 1)) & ~(size_t)(SP_ALIGN - 1)) + part[1]; }

static sp_status sp__check_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    size_t part[2];
    if (!bytes) return SP_E_ARGUMENT;
    const sp_status status = sp__small_memory(scene, settings, scratch, NULL, part);
    if (!status) *bytes = settings && settings->work ? part[0] : sp__small_sum(part);
    return status;
}

static sp_status sp__work_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    size_t part[2];
    if (!bytes) return SP_E_ARGUMENT;
    const sp_status status = sp__small_memory(scene, settings, scratch, NULL, part);
    if (!status) *bytes = part[1];
    return status;
}

static size_t sp__check_scratch(const sp_scene *scene, const sp_settings *settings)
{
    (void)settings;
    if (!scene) return 0;
    return sizeof(sp__check) + sizeof(sp__small) + sp__problem_memory(scene) + 24 * (size_t)scene->count.blocks + 5 * SP_ALIGN;
}

#if SP__WITH_PLAN
/* A check by this search takes everything there is, all blocks together; its factor is known, its steps are a guess. */
static size_t sp__plan_memory(const sp_scene *scene, const sp_settings *settings) { return sp__check_scratch(scene, settings); }

SP_API sp_status sp_plan(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, sp_outlook *out)
{
    size_t part[2];
    int64_t flops;
    if (!out) return SP_E_ARGUMENT;
    const sp_status status = sp__small_memory(scene, settings, scratch, &flops, part);
    if (status) return status;
    sp_problem pb;
    const int64_t points = sp__points_count(scene);
    sp__problem_count(scene, &pb);
    memset(out, 0, sizeof *out);
    for (int k = 0; k < SP_EFFECTS; k++)
        out->effect[k].why = k == SP_EFFECT_DYNAMICS ? SP_WHY_STATICS : k == SP_EFFECT_COUPLED ? SP_WHY_NOT_ASKED
                           : sp__effect_present(scene, NULL, 1, (sp_effect)k) ? SP_WHY_CALLED : SP_WHY_ABSENT;
    out->islands = pb.blocks > 0;
    out->bytes = out->full_bytes = sp__small_sum(part);
    out->unknowns = out->full_unknowns = 6 * (int64_t)pb.blocks + 3 * points;
    out->flops = out->full_flops = 5 * flops + 20 * SP__FLOPS_VERTEX * points;
    return SP_OK;
}
#else
static size_t sp__plan_memory(const sp_scene *scene, const sp_settings *settings) { return (void)scene, (void)settings, 0; }
#endif

#endif

#endif /* SP__SMALL_CHECK_C */
