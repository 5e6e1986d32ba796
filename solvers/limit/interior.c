/* interior: largest multiple lambda by interior points in forces, motion and lambda at once.     [Ye, Todd, Mizuno 1994] */
#ifndef SP__LIMIT_INTERIOR_C
#define SP__LIMIT_INTERIOR_C

#include "newton.c"

#if SP__WITH_INTERIOR

/* The embedding of statics/interior.c with one ray and one column more, for
 *
 *   max lambda,  Aeq f + p + lambda q = 0,  f = E x,  lambda = l / tau:
 *
 *   Aeq E x + l q + tau p = theta r0     z + E' Aeq' y = theta e     s + q.y + tau = theta r1     kappa + p.y - l = theta r2
 *   x o z = mu e,   l s = mu,   tau kappa = mu                               x = z = e, y = 0, l = s = tau = kappa = 1 at first
 *
 * At the end tau > 0: f = E x / tau carries lambda, and dq = -y, which no contact resists, does so much work under it that
 * p.dq + lambda q.dq = 0; or kappa > 0: dq falls at every lambda; or l > 0 = tau = kappa: there is no end to it.
 *
 * A step borders the factor of M = Aeq E W^2 E' Aeq' by q and p. M tends to be singular along the mechanism v, which both q and
 * p pull; so p gives way to p' = p + a q with p'.M^-1 q = 0, l to l' = l - a tau, and the columns no longer see the same v. */
#define SP__LIMIT_NEAR SP__SCALE_TOL    /* gap of both ends, relative, at which forces at the limit are tried */
#define SP__LIMIT_MOST 100              /* interior-point iterations: an optimum takes more than a verdict */
#define SP__LIMIT_CLOSE ((sp_real)0.03) /* of the way that the predictor does not get: the end is near, and steps go farther */
#define SP__LIMIT_ROUGH ((sp_real)1e-6) /* of the predictor's residual that may be left: its motion is judged by itself */
#ifdef SP_REAL_FLOAT
#define SP__LIMIT_KEEP SP__IPM_KEEP
#define SP__LIMIT_FIRST_NEAR ((sp_real)1e-3)    /* where they are tried first */
#else
#define SP__LIMIT_FIRST_NEAR ((sp_real)1e-6)
#define SP__LIMIT_KEEP ((sp_real)0.999)
#endif

/* Loads dead + a live, from now on. */
static void sp__limit_loads(sp__limit *L, sp_real a)
{
    sp__engine *g = &L->engine;
    g->at = a;
    sp__bracket_load(&L->bracket, 1, a * L->ref);
}

/* Loads at a; where they all but cancel each other, which is no size for anything, at a + 1. */
static void sp__limit_loads_sized(sp__limit *L, sp_real a)
{
    const sp__bracket *b = &L->bracket;
    sp_real dead = 0, both = 0;
    sp__limit_loads(L, a);
    for (size_t k = 0; k < 6 * (size_t)b->pb.blocks; k++) { dead += sp__abs(b->dead[k]); both += sp__abs(b->pb.p[k]); }
    if (16 * both < dead) sp__limit_loads(L, a + 1);
}

/* Sizes of the certificate check for the loads at hand; with a metric E depends on them, so they stay. */
static void sp__limit_sizes(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    if (w->measure.metric > 0) return;
    for (size_t k = 0; k < n; k++) {
        const sp_real unit = w->measure.unit * w->measure.weight[k / 3];
        g->state.dq[k] = sp__in_units(unit, L->bracket.hint[k]);
        w->d[k] = -sp__in_units(unit, L->bracket.hint[n + k]);
    }
    sp__reduction_from_space(g->reduction, w->pb->blocks, g->state.dq);
    sp__reduction_from_space(g->reduction, w->pb->blocks, w->d);
    sp__system_sizes(w, g->state.dq);
}

/* Vq, Vp and their products, for the factor at hand. */
SP__NOINLINE static void sp__interior_columns(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp_real most = 1000 * (1 + g->h.l / g->h.m.tau);
    sp__system_solve(w, g->q, g->Vq);
    g->G[0] = sp__dot(g->q, g->Vq, n);
    sp__limit_loads(L, 0);
    const sp_real a = g->G[0] > 0 ? -sp__system_work(w, g->Vq) / g->G[0] : 0;
    sp__limit_loads_sized(L, g->h.l / g->h.m.tau);
    sp__limit_sizes(L);
    sp__limit_loads(L, a > most ? most : a < -most ? -most : a);
    sp__system_load(w, w->r);
    sp__system_solve(w, w->r, g->Vp);
    g->G[1] = sp__system_work(w, g->Vq);
    g->G[2] = sp__system_work(w, g->Vp);
}

/* lambda <= a + (resistance - work under dead + a live) / work of live, for dq = -y, caps at the sizes at hand. The least
 * stays. */
SP__NOINLINE static void sp__limit_candidate(sp__limit *L, const sp_real *y)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real live = 0, size = 0, resist = 0, scale = 0;
    const sp_real work = -sp__system_work(w, y);
    for (size_t k = 0; k < n; k++) { live -= g->q[k] * y[k]; size += sp__abs(g->q[k] * y[k]); }
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *yi = y + 6 * (size_t)i, *s = w->measure.size + 2 * (size_t)i, *z = w->measure.weight + 2 * (size_t)i;
        scale += s[0] * z[0] * sp__norm3(yi) + s[1] * z[1] * sp__norm3(yi + 3);
    }
    for (int32_t c = 0; c < w->pb->contacts; c++) resist += sp__newton_resist(w, c, y);
    sp__system_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST);
    const int idle = sp__abs(live) <= 64 * (sp_real)SP_EPSILON * size;         /* live loads do not care */
    const int none = (idle || live > 0) && work - g->at * live - resist > (sp_real)1.1 * w->set->tol * scale;
    const sp_real best = idle ? (none ? -1 : SP__HUGE) : live > 0 ? g->at + (resist - work) / live : SP__HUGE;
    const sp_real slack = idle ? 0 : w->set->tol * scale / live;
    if (!none && (L->none || !(best + slack < L->best + L->slack))) return;     /* of proofs that nothing stands the last */
    L->best = best;
    L->none = none;
    L->slack = slack;
    for (size_t k = 0; k < n; k++) L->bracket.dq[k] = -w->measure.weight[k / 3] * y[k];
    sp__reduction_to_space(w, L->bracket.dq);
}

/* y, and y with the least change in the metric of W after which no contact resists, its work as the embedding wants it at last:
 * q.y = -s - tau;  and p.y = l - kappa. The free part of the predictor stays in w->d. */
SP__NOINLINE static void sp__interior_motions(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp_real *G = g->G, det = G[0] * G[2] - G[1] * G[1];
    g->h.m.corrected = 0;
    g->h.m.sigma = 0;
    sp__ipm_sweep(w, &g->h.m, SP__AIM, w->d);
    sp__system_solve_to(w, SP__LIMIT_ROUGH, w->d, w->d);
    sp__limit_candidate(L, w->y);
    if (!(G[0] > 0)) return;
    for (size_t k = 0; k < n; k++) w->r[k] = w->y[k] + w->d[k];
    const sp_real a = -g->h.s - g->h.m.tau - sp__dot(g->q, w->r, n);
    const sp_real b = g->h.l - g->h.m.kappa - g->at * (g->h.s + g->h.m.tau) - sp__system_work(w, w->r);
    sp__system_axpy(w, a / G[0], g->Vq, w->r);
    sp__limit_candidate(L, w->r);
    if (!(det > 0)) return;
    sp__system_axpy(w, (a * G[2] - b * G[1]) / det - a / G[0], g->Vq, w->r);
    sp__system_axpy(w, (b * G[0] - a * G[1]) / det, g->Vp, w->r);
    sp__limit_candidate(L, w->r);
}

/* Changes of l, s, tau, kappa and the shares of Vq and Vp, from the free part dy of a step: with dl' = dl - a dtau
 *
 *   [ -(q.Vq + s/l)            1 - q.Vp - a s/l              ] [ dl'  ]
 *   [ -(1 + q.Vp + a s/l)     -(p'.Vp + kappa/tau + a^2 s/l) ] [ dtau ]  = b                                            */
static void sp__interior_homogeneous(sp__limit *L, const sp_real *dy)
{
    sp__engine *g = &L->engine;
    sp__ipm *m = &g->h.m;
    const size_t n = 6 * (size_t)g->w->pb->blocks;
    const sp_real keep = 1 - m->sigma, a = g->at, t = g->h.s / g->h.l, *G = g->G;
    const sp_real E = keep * (g->h.l - a * m->tau), T = keep * m->tau;
    const sp_real cl = m->sigma * m->mu - g->h.l * g->h.s - g->h.pl, ct = m->sigma * m->mu - m->tau * m->kappa - g->h.pt;
    const sp_real r1 = sp__dot(g->q, g->w->y, n) + g->h.s + m->tau;
    const sp_real r2 = m->kappa + sp__system_work(g->w, g->w->y) - g->h.l + a * (g->h.s + m->tau);
    const sp_real b1 = E * G[0] + T * G[1] - keep * r1 - cl / g->h.l - sp__dot(g->q, dy, n);
    const sp_real b2 = E * G[1] + T * G[2] - keep * r2 - ct / m->tau - a * cl / g->h.l - sp__system_work(g->w, dy);
    const sp_real a11 = -(G[0] + t), a12 = 1 - G[1] - a * t, a21 = -(1 + G[1] + a * t);
    const sp_real a22 = -(G[2] + m->kappa / m->tau + a * a * t), det = a11 * a22 - a12 * a21;
    const sp_real d = (b1 * a22 - a12 * b2) / det;
    m->dtau = (a11 * b2 - a21 * b1) / det;
    g->h.dl = d + a * m->dtau;
    g->h.ds = (cl - g->h.s * g->h.dl) / g->h.l;
    m->dkappa = (ct - m->kappa * m->dtau) / m->tau;
    g->h.along[0] = -(E + d);
    g->h.along[1] = -(T + m->dtau);
}

/* The whole step of y from its free part, in place, and how far it may go. */
static void sp__interior_reach(sp__limit *L, sp_real *dy)
{
    sp__engine *g = &L->engine;
    sp__system_axpy(g->w, g->h.along[0], g->Vq, dy);
    sp__system_axpy(g->w, g->h.along[1], g->Vp, dy);
    g->h.m.along[2] = dy;
    sp__ipm_reach(g->w, &g->h.m);
    g->h.m.reach = sp__ray_step(g->h.l, g->h.dl, sp__ray_step(g->h.s, g->h.ds, g->h.m.reach));
}

#define SP__LIMIT_CENTRES 4             /* solves a step may take with the factor at hand, if it is shorter than */
#ifdef SP_REAL_MIXED                    /* there a solve is refined, and costs as much as a small factor */
#define SP__LIMIT_SHORT ((sp_real)0.6)
#define SP__LIMIT_GAINS ((sp_real)0.2)
#else
#define SP__LIMIT_SHORT ((sp_real)0.9)
#define SP__LIMIT_GAINS ((sp_real)0.03) /* of the way, and no less, that makes another one worth its while */
#endif

/* Products of a step m->reach long are brought back to the centre: the step dy towards that.     returns 0: no budget left */
SP__NOINLINE static int sp__interior_centred(sp__limit *L, sp_real *dy)
{
    sp__homogeneous *h = &L->engine.h;
    sp__ipm *m = &h->m;
    const sp_real t = m->reach, aim = m->sigma * m->mu;
    h->pl -= sp__centred((h->l + t * h->dl) * (h->s + t * h->ds), aim);
    h->pt -= sp__centred((m->tau + t * m->dtau) * (m->kappa + t * m->dkappa), aim);
    sp__ipm_sweep(L->engine.w, m, SP__CENTRE, dy);
    if (L->engine.w->budget.spent) return 0;
    sp__system_solve(L->engine.w, dy, dy);
    m->kept = (int16_t)(3 - m->kept);
    sp__interior_homogeneous(L, dy);
    sp__interior_reach(L, dy);
    return 1;
}

static void sp__interior_keep(sp__homogeneous *h)
{
    h->before[0] = h->m.reach;
    h->before[1] = h->dl;
    h->before[2] = h->ds;
    h->before[3] = h->m.dtau;
    h->before[4] = h->m.dkappa;
}

/* Back to the step dy that was before. */
static void sp__interior_back(sp__homogeneous *h, sp_real *dy)
{
    sp__ipm *m = &h->m;
    m->kept = (int16_t)(3 - m->kept);
    m->along[2] = dy;
    m->reach = h->before[0];
    h->dl = h->before[1];
    h->ds = h->before[2];
    m->dtau = h->before[3];
    m->dkappa = h->before[4];
}

/* Single products far from the centre keep steps short: they are brought back with the same factor while steps get longer.
 *     returns the dy of the step it ends with, w->r as at first, or w->d                                      [Gondzio 1996] */
SP__NOINLINE static sp_real *sp__interior_centre(sp__limit *L)
{
    sp__homogeneous *h = &L->engine.h;
    sp__ipm *m = &h->m;
    sp_real *dy = L->engine.w->r, *next = L->engine.w->d;
    for (int k = 0; k < SP__LIMIT_CENTRES && m->reach < SP__LIMIT_SHORT; k++) {
        sp__interior_keep(h);
        m->reach = m->reach * (sp_real)1.5 + (sp_real)0.3;
        if (m->reach > 1) m->reach = 1;
        if (!sp__interior_centred(L, next)) { m->reach = h->before[0]; return dy; }
        if (m->reach < h->before[0]) { sp__interior_back(h, dy); return dy; }
        sp_real *was = dy;
        dy = next;
        next = was;
        if (m->reach < h->before[0] + SP__LIMIT_GAINS) return dy;
    }
    return dy;
}

/* Predictor and corrector, from what sp__interior_motions left in w->d. */
static void sp__interior_correct(sp__limit *L)
{
    sp__homogeneous *h = &L->engine.h;
    sp__system *w = L->engine.w;
    sp__ipm *m = &h->m;
    h->pl = h->pt = 0;
    sp__interior_homogeneous(L, w->d);
    m->along[1] = w->d;
    sp__interior_reach(L, w->d);
    h->left = 1 - (m->reach < 1 ? m->reach : 1);
    h->pl = h->dl * h->ds;
    h->pt = m->dtau * m->dkappa;
    m->corrected = 1;
    m->sigma = h->left * h->left * h->left;
    sp__ipm_sweep(w, m, SP__AIM, w->r);
    sp__system_solve(w, w->r, w->r);
    sp__interior_homogeneous(L, w->r);
    sp__interior_reach(L, w->r);
}

/* A step, and on to where it ends. */
SP__NOINLINE static void sp__interior_step(sp__limit *L)
{
    sp__homogeneous *h = &L->engine.h;
    sp__system *w = L->engine.w;
    sp__ipm *m = &h->m;
    sp__interior_correct(L);
    sp_real *dy = sp__interior_centre(L);
    m->reach *= h->left < SP__LIMIT_CLOSE ? SP__LIMIT_KEEP : SP__IPM_KEEP;
    if (m->reach > 1) m->reach = 1;
    sp__ipm_sweep(w, m, SP__MOVE, NULL);
    sp__system_axpy(w, m->reach, dy, w->y);
    m->tau += m->reach * m->dtau;
    m->kappa += m->reach * m->dkappa;
    h->l += m->reach * h->dl;
    h->s += m->reach * h->ds;
    m->theta *= 1 - m->reach * (1 - m->sigma);
}

/* Forces E x / t, or those of w->y (t = 0), balanced for d dead + l live (in ref) with the factor at hand. */
SP__NOINLINE static int sp__limit_forces(sp__limit *L, sp_real d, sp_real l, sp_real t, sp_real *f)
{
    sp__engine *g = &L->engine;
    const sp_real tau = g->h.m.tau;
    sp__bracket_load(&L->bracket, d, l * L->ref);
    sp__limit_sizes(L);
    g->n.found = 0;
    g->state.f = f;
    g->h.m.tau = t;
    sp__ipm_forces(g->w, t > 0 ? &g->h.m : NULL, &g->n, &g->state);
    g->h.m.tau = tau;
    sp__reduction_copy_forces(g->reduction, &L->bracket.pb, f);
    return g->n.found && sp__bracket_stands(&L->bracket, d, l * L->ref, f, f);
}

/* Where the interior points are done but for so much, do the forces at hand, balanced, carry their multiple? The largest stays.
 *     returns 1: and it is as near to the best motion's power balance */
static int sp__interior_lower(sp__limit *L, sp_real share)
{
    sp__engine *g = &L->engine;
    const sp_real l = g->h.l / g->h.m.tau, a = l < L->best ? l : sp__max(0, L->best), width = share * (1 + sp__abs(a));
    if (!L->none && L->r.lower >= 0 && L->best - L->r.lower / L->ref <= width) return 1;
    if (L->none || (g->h.m.theta > share * g->h.m.tau && sp__abs(L->best - l) > width) || a * L->ref <= L->r.lower) return 0;
    if (!sp__limit_forces(L, 1, a, g->h.m.tau, L->r.ray)) return 0;
    sp__limit_carried(L, a * L->ref, L->r.ray);
    return sp__abs(L->best - a) <= width;
}

/* Of both ends: so near that they close the bracket, at most. */
static sp_real sp__interior_share(const sp__limit *L, sp_real most)
{
    const sp_real wide = SP__LIMIT_WIDE * L->r.tol;
    return wide < most ? wide : most;
}

/* A lower end as soon as it closes the bracket. Where all joints slide at once, rounding spoils the forces of later steps. */
static void sp__interior_first(sp__limit *L)
{
    const sp_real l = L->engine.h.l / L->engine.h.m.tau, share = sp__interior_share(L, SP__LIMIT_FIRST_NEAR);
    if (sp__abs(L->best - l) <= share * (1 + sp__abs(l))) sp__interior_lower(L, share);
}

/* Do the forces at hand balance the live loads alone, so that there is no limit? If so, forces for the current multiple too. */
static int sp__interior_unbounded(sp__limit *L)
{
    sp__engine *g = &L->engine;
    const sp_real l = g->h.l / g->h.m.tau;
    g->h.m.ray = 1;
    const int found = sp__limit_forces(L, 0, 1, g->h.l, L->r.ray);
    g->h.m.ray = 0;
    if (!found) return 0;
    for (size_t k = 0; k < 3 * (size_t)L->bracket.pb.points; k++) L->r.ray[k] /= L->ref;
    L->r.kind = SP_LIMIT_UNBOUNDED;
    if (!sp__limit_forces(L, 1, l, g->h.m.tau, L->r.f)) return 1;
    L->r.lower = l * L->ref;
    L->r.imbalance = L->bracket.imbalance;
    return 1;
}

/* x = z = e, y = 0, l = s = tau = kappa = 1. */
static void sp__interior_start(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__ipm_start(g->w, &g->h.m);
    g->h.m.kept = 1;
    g->h.l = g->h.s = 1;
}

/* Interior points, until the ends meet.     returns 1: lower and best meet, the live loads have no end, or nothing stands */
SP__NOINLINE static int sp__interior_run(sp__limit *L)
{
    sp__engine *g = &L->engine;
    sp__system *w = g->w;
    sp__ipm *m = &g->h.m;
    sp__bracket *b = &L->bracket;
    const sp_real cones = sp__ipm_cones(w);
    int idle = 0;                                       /* steps that got nowhere, one after the other */
    sp__interior_start(L);
    for (int it = 0; it < SP__LIMIT_MOST && idle < SP__IPM_IDLE && g->n.left > 0 && m->theta > (sp_real)SP_EPSILON; it++) {
        m->gap = 0;
        m->outside = 0;
        sp__system_factor(w, SP__INTERIOR, w->y, SP__IPM_SHIFT);
        if (w->budget.spent) return 0;
        g->n.left--;
        b->cost.iterations++;
        b->cost.interior++;
        if (m->outside) return 0;
        m->mu = (m->gap + m->tau * m->kappa + g->h.l * g->h.s) / (cones + 2);
        sp__interior_first(L);
        if (sp__interior_lower(L, sp__interior_share(L, SP__LIMIT_NEAR))) return 1;
        if (g->h.l > 1000 * m->tau && sp__interior_unbounded(L)) return 1;
        sp__interior_columns(L);
        sp__interior_motions(L);
        if (w->budget.spent) return 0;
        if (L->none && sp__bracket_falls(b, 0, 1, NULL)) return 1;
        sp__interior_step(L);
        if (w->budget.spent) return 0;
        idle = m->reach < SP__IPM_NOWHERE ? idle + 1 : 0;
    }
    sp__interior_lower(L, 1000 * SP__LIMIT_NEAR);
    return 0;
}

#endif

#endif /* SP__LIMIT_INTERIOR_C */
