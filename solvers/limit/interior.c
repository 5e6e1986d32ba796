/* interior: interior points in forces, motion and multiplier at once */
#ifndef SP__LIMIT_INTERIOR_C
#define SP__LIMIT_INTERIOR_C

#include "bracket.c"

#if SP__WITH_INTERIOR

/* Section 19's embedding with one ray and one column more, for
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
typedef struct sp__limit {
    sp__bracket bracket;
    sp_state state;
    sp__newton n;
    sp__ipm m;
    sp_limit_result r;
    sp__dual *w;
    sp__flat *flat;                     /* NULL: in 6 rows a block */
    sp_arena room;                      /* for judging */
    sp_real *q, *Vq, *Vp;               /* 6b: weighted live load, M^-1 q, M^-1 p' */
    sp_real *f;                         /* 3 x points: forces that are tried when all others are kept */
    sp_real ref;                        /* multiplier that counts as 1 below */
    sp_real at;                         /* a: the loads at hand are dead + a live */
    sp_real l, s, dl, ds;
    sp_real G[3];                       /* q.Vq, q.Vp, p'.Vp */
    sp_real along[2];                   /* a step is its free part and these multiples of Vq and Vp */
    sp_real best, slack;                /* least power balance of a motion (kept in ends.dq), and what tol adds to it */
    sp_real least;                      /* largest one of a motion that live loads hinder: less does not stand */
    int none;                           /* that motion falls at 0, too */
} sp__limit;

#define SP__LIMIT_NEAR SP__SCALE_TOL    /* gap of both ends, relative, at which forces at the limit are tried */
#define SP__LIMIT_MOST 100              /* interior-point iterations: an optimum takes more than a verdict */
#define SP__LIMIT_CLOSE ((sp_real)0.03) /* of the way that the predictor does not get: the end is near, and steps go farther */
#ifdef SP_REAL_FLOAT
#define SP__LIMIT_KEEP SP__IPM_KEEP
#else
#define SP__LIMIT_KEEP ((sp_real)0.999)
#endif
#define SP__LIMIT_FAR 1000              /* multiple, in ref, from which on forces are nearly those of live loads alone */
#define SP__STRONG_MOST 240              /* factorisations of a climb in c, at most */
#define SP__STRONG_NEAR (100 * SP__SCALE_TOL)    /* gap of both ends, relative, that ends a climb */
#define SP__STRONG_SOLVED SP__TIE             /* omega from which on y is taken for that of its c */
#define SP__LIMIT_WIDE 1000             /* a bracket so many tol wide is closed */
#define SP__LIMIT_SLACK ((sp_real)0.01) /* what tol adds to a motion's balance may widen it by no more, in ref */
#ifdef SP_REAL_MIXED
#define SP__LIMIT_STEP 400              /* tol below a motion's balance where forces are asked for: float sees no nearer */
#else
#define SP__LIMIT_STEP 4
#endif

static void sp__limit_loads(sp__limit *L, sp_real a)
{
    L->at = a;
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

/* Sizes of the certificate check for the loads at hand; with a metric E hangs on them, and they stay. */
static void sp__limit_sizes(sp__limit *L)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    if (w->metric > 0) return;
    for (size_t k = 0; k < n; k++) {
        const sp_real unit = w->unit * w->weight[k / 3];
        L->state.dq[k] = L->bracket.hint[k] / unit;
        w->d[k] = -L->bracket.hint[n + k] / unit;
    }
    sp__flat_drop(L->flat, w->pb->blocks, L->state.dq);
    sp__flat_drop(L->flat, w->pb->blocks, w->d);
    sp__dual_sizes(w, L->state.dq);
}

/* Vq, Vp and their products, for the factor at hand. */
SP__NOINLINE static void sp__interior_columns(sp__limit *L)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp_real most = 1000 * (1 + L->l / L->m.tau);
    sp__dual_solve(w, L->q, L->Vq);
    L->G[0] = sp__dot(L->q, L->Vq, n);
    sp__limit_loads(L, 0);
    const sp_real a = L->G[0] > 0 ? -sp__dual_work(w, L->Vq) / L->G[0] : 0;
    sp__limit_loads_sized(L, L->l / L->m.tau);
    sp__limit_sizes(L);
    sp__limit_loads(L, a > most ? most : a < -most ? -most : a);
    sp__dual_load(w, w->r);
    sp__dual_solve(w, w->r, L->Vp);
    L->G[1] = sp__dual_work(w, L->Vq);
    L->G[2] = sp__dual_work(w, L->Vp);
}

/* lambda <= a + (resistance - work under dead + a live) / work of live, for dq = -y, caps at the sizes at hand. The least
 * stays. */
SP__NOINLINE static void sp__limit_candidate(sp__limit *L, const sp_real *y)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real live = 0, size = 0, resist = 0, scale = 0;
    const sp_real work = -sp__dual_work(w, y);
    for (size_t k = 0; k < n; k++) { live -= L->q[k] * y[k]; size += sp__abs(L->q[k] * y[k]); }
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *yi = y + 6 * (size_t)i, *s = w->size + 2 * (size_t)i, *z = w->weight + 2 * (size_t)i;
        scale += s[0] * z[0] * sp__norm3(yi) + s[1] * z[1] * sp__norm3(yi + 3);
    }
    for (int32_t c = 0; c < w->pb->contacts; c++) resist += sp__newton_resist(w, c, y);
    sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST);
    const int idle = sp__abs(live) <= 64 * (sp_real)SP_EPSILON * size;         /* live loads do not care */
    const int none = (idle || live > 0) && work - L->at * live - resist > (sp_real)1.1 * w->set->tol * scale;
    const sp_real best = idle ? (none ? -1 : SP__HUGE) : live > 0 ? L->at + (resist - work) / live : SP__HUGE;
    const sp_real slack = idle ? 0 : w->set->tol * scale / live;
    if (!none && (L->none || !(best + slack < L->best + L->slack))) return;     /* of proofs that nothing stands the last */
    L->best = best;
    L->none = none;
    L->slack = slack;
    for (size_t k = 0; k < n; k++) L->bracket.dq[k] = -w->weight[k / 3] * y[k];
    sp__flat_lift(w, L->bracket.dq);
}

/* y, and y with the least change in the metric of W after which no contact resists, its work as the embedding wants it at last:
 * q.y = -s - tau;  and p.y = l - kappa. The free part of the predictor stays in w->d. */
SP__NOINLINE static void sp__interior_motions(sp__limit *L)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp_real *G = L->G, det = G[0] * G[2] - G[1] * G[1];
    L->m.corrected = 0;
    L->m.sigma = 0;
    sp__ipm_sweep(w, &L->m, SP__AIM, w->d);
    sp__dual_solve(w, w->d, w->d);
    sp__limit_candidate(L, w->y);
    if (!(G[0] > 0)) return;
    for (size_t k = 0; k < n; k++) w->r[k] = w->y[k] + w->d[k];
    const sp_real a = -L->s - L->m.tau - sp__dot(L->q, w->r, n);
    const sp_real b = L->l - L->m.kappa - L->at * (L->s + L->m.tau) - sp__dual_work(w, w->r);
    sp__dual_axpy(w, a / G[0], L->Vq, w->r);
    sp__limit_candidate(L, w->r);
    if (!(det > 0)) return;
    sp__dual_axpy(w, (a * G[2] - b * G[1]) / det - a / G[0], L->Vq, w->r);
    sp__dual_axpy(w, (b * G[0] - a * G[1]) / det, L->Vp, w->r);
    sp__limit_candidate(L, w->r);
}

/* Changes of l, s, tau, kappa and the shares of Vq and Vp, from the free part dy of a step: with dl' = dl - a dtau
 *
 *   [ -(q.Vq + s/l)            1 - q.Vp - a s/l              ] [ dl'  ]
 *   [ -(1 + q.Vp + a s/l)     -(p'.Vp + kappa/tau + a^2 s/l) ] [ dtau ]  = b                                            */
static void sp__interior_homogeneous(sp__limit *L, const sp_real *dy, sp_real pl, sp_real pt)
{
    sp__ipm *m = &L->m;
    const size_t n = 6 * (size_t)L->w->pb->blocks;
    const sp_real keep = 1 - m->sigma, a = L->at, t = L->s / L->l, *G = L->G;
    const sp_real E = keep * (L->l - a * m->tau), T = keep * m->tau;
    const sp_real cl = m->sigma * m->mu - L->l * L->s - pl, ct = m->sigma * m->mu - m->tau * m->kappa - pt;
    const sp_real r1 = sp__dot(L->q, L->w->y, n) + L->s + m->tau;
    const sp_real r2 = m->kappa + sp__dual_work(L->w, L->w->y) - L->l + a * (L->s + m->tau);
    const sp_real b1 = E * G[0] + T * G[1] - keep * r1 - cl / L->l - sp__dot(L->q, dy, n);
    const sp_real b2 = E * G[1] + T * G[2] - keep * r2 - ct / m->tau - a * cl / L->l - sp__dual_work(L->w, dy);
    const sp_real a11 = -(G[0] + t), a12 = 1 - G[1] - a * t, a21 = -(1 + G[1] + a * t);
    const sp_real a22 = -(G[2] + m->kappa / m->tau + a * a * t), det = a11 * a22 - a12 * a21;
    const sp_real d = (b1 * a22 - a12 * b2) / det;
    m->dtau = (a11 * b2 - a21 * b1) / det;
    L->dl = d + a * m->dtau;
    L->ds = (cl - L->s * L->dl) / L->l;
    m->dkappa = (ct - m->kappa * m->dtau) / m->tau;
    L->along[0] = -(E + d);
    L->along[1] = -(T + m->dtau);
}

/* The whole step of y from its free part, in place, and how far it may go. */
static void sp__interior_reach(sp__limit *L, sp_real *dy)
{
    sp__dual_axpy(L->w, L->along[0], L->Vq, dy);
    sp__dual_axpy(L->w, L->along[1], L->Vp, dy);
    L->m.along[2] = dy;
    sp__ipm_reach(L->w, &L->m);
    L->m.reach = sp__ray_step(L->l, L->dl, sp__ray_step(L->s, L->ds, L->m.reach));
}

/* Predictor and corrector, from what sp__interior_motions left in w->d. */
SP__NOINLINE static void sp__interior_step(sp__limit *L)
{
    sp__dual *w = L->w;
    sp__ipm *m = &L->m;
    sp__interior_homogeneous(L, w->d, 0, 0);
    m->along[1] = w->d;
    sp__interior_reach(L, w->d);
    const sp_real left = 1 - (m->reach < 1 ? m->reach : 1), pl = L->dl * L->ds, pt = m->dtau * m->dkappa;
    m->corrected = 1;
    m->sigma = left * left * left;
    sp__ipm_sweep(w, m, SP__AIM, w->r);
    sp__dual_solve(w, w->r, w->r);
    sp__interior_homogeneous(L, w->r, pl, pt);
    sp__interior_reach(L, w->r);
    m->reach *= left < SP__LIMIT_CLOSE ? SP__LIMIT_KEEP : SP__IPM_KEEP;
    if (m->reach > 1) m->reach = 1;
    sp__ipm_sweep(w, m, SP__MOVE, NULL);
    sp__dual_axpy(w, m->reach, w->r, w->y);
    m->tau += m->reach * m->dtau;
    m->kappa += m->reach * m->dkappa;
    L->l += m->reach * L->dl;
    L->s += m->reach * L->ds;
    m->theta *= 1 - m->reach * (1 - m->sigma);
}

/* Forces E x / t, or those of w->y (t = 0), balanced for d dead + l live (in ref) with the factor at hand. */
SP__NOINLINE static int sp__limit_forces(sp__limit *L, sp_real d, sp_real l, sp_real t, sp_real *f)
{
    const sp_real tau = L->m.tau;
    sp__bracket_load(&L->bracket, d, l * L->ref);
    sp__limit_sizes(L);
    L->n.found = 0;
    L->state.f = f;
    L->m.tau = t;
    sp__ipm_forces(L->w, t > 0 ? &L->m : NULL, &L->n, &L->state);
    L->m.tau = tau;
    sp__flat_spread(L->flat, &L->bracket.pb, f);
    return L->n.found && sp__bracket_stands(&L->bracket, d, l * L->ref, f, f, L->room);
}

/* Where the interior points are done but for so much, do the forces at hand, balanced, carry their multiple? The largest stays.
 *     returns 1: and it is as near to the best motion's power balance */
static int sp__interior_lower(sp__limit *L, sp_real near)
{
    const sp_real l = L->l / L->m.tau, a = l < L->best ? l : sp__max(0, L->best), far = near * (1 + sp__abs(a));
    if (!L->none && L->r.lower >= 0 && L->best - L->r.lower / L->ref <= far) return 1;
    if (L->none || (L->m.theta > near * L->m.tau && sp__abs(L->best - l) > far) || a * L->ref <= L->r.lower) return 0;
    if (!sp__limit_forces(L, 1, a, L->m.tau, L->r.ray)) return 0;
    L->r.lower = a * L->ref;
    L->r.omega = L->bracket.omega;
    memcpy(L->r.f, L->r.ray, 3 * (size_t)L->bracket.pb.points * sizeof *L->r.f);
    return sp__abs(L->best - a) <= far;
}

/* Do they carry the live loads alone, and all of them the multiple at hand? */
static int sp__interior_unbounded(sp__limit *L)
{
    const sp_real l = L->l / L->m.tau;
    L->m.ray = 1;
    const int found = sp__limit_forces(L, 0, 1, L->l, L->r.ray);
    L->m.ray = 0;
    if (!found) return 0;
    for (size_t k = 0; k < 3 * (size_t)L->bracket.pb.points; k++) L->r.ray[k] /= L->ref;
    L->r.kind = SP_LIMIT_UNBOUNDED;
    if (!sp__limit_forces(L, 1, l, L->m.tau, L->r.f)) return 1;
    L->r.lower = l * L->ref;
    L->r.omega = L->bracket.omega;
    return 1;
}

/* x = z = e, y = 0, l = s = tau = kappa = 1. */
static void sp__interior_start(sp__limit *L)
{
    sp__ipm_start(L->w, &L->m);
    L->l = L->s = 1;
}

/* Interior points, until the ends meet.     returns 1: lower and best meet, the live loads have no end, or nothing stands */
SP__NOINLINE static int sp__interior_run(sp__limit *L)
{
    sp__dual *w = L->w;
    sp__ipm *m = &L->m;
    sp__bracket *b = &L->bracket;
    const int32_t faces = w->cone.faces;
    const sp_real cones = (sp_real)w->pb->points * (sp_real)(faces ? faces : 1);
    int idle = 0;                                       /* steps that got nowhere, one after the other */
    sp__interior_start(L);
    for (int it = 0; it < SP__LIMIT_MOST && idle < SP__IPM_IDLE && L->n.left > 0 && m->theta > (sp_real)SP_EPSILON; it++) {
        m->gap = 0;
        m->outside = 0;
        sp__dual_factor(w, SP__INTERIOR, w->y, SP__IPM_SHIFT);
        if (w->spent) return 0;
        L->n.left--;
        b->cost.iterations++;
        b->cost.interior++;
        if (m->outside) return 0;
        m->mu = (m->gap + m->tau * m->kappa + L->l * L->s) / (cones + 2);
        if (sp__interior_lower(L, SP__LIMIT_NEAR)) return 1;
        if (L->l > 1000 * m->tau && sp__interior_unbounded(L)) return 1;
        sp__interior_columns(L);
        sp__interior_motions(L);
        if (w->spent) return 0;
        if (L->none && sp__bracket_falls(b, 0, 1, NULL, L->room)) return 1;
        sp__interior_step(L);
        if (w->spent) return 0;
        idle = m->reach < SP__IPM_NOWHERE ? idle + 1 : 0;
    }
    sp__interior_lower(L, 1000 * SP__LIMIT_NEAR);
    return 0;
}

#endif

#endif /* SP__LIMIT_INTERIOR_C */
