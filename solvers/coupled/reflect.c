/* reflect: a triple looked for by reflections in two sets, one linear and one of each corner by itself.
 *
 *     A   Aeq f + p = 0,   d = Aeq' y
 *     B   of every corner:  f = 0,  -eps <= dn <= eta,  |dt| <= eta
 *                   or  dn = -eps,  ft = -a e,  dt = b e,  0 <= a <= mu fn,  0 <= b <= eta
 *
 *     z <- z + B(2 A(z) - z) - A(z),   z = (f, d),   nearest in   sum |f|^2 / s + kappa^2 s |d|^2
 *                                   [Douglas, Rachford 1956, Trans. AMS 82; Elser, Rankenburg, Thibault 2007, PNAS 104(2)]
 *
 * A point of both is a triple. B is not convex, so nothing says that it is found, but z leaves where the sets are only near
 * each other and settles where they meet. With s of every corner in the metric, Aeq S Aeq' is the matrix of f and of d.
 */
#ifndef SP__COUPLED_REFLECT_C
#define SP__COUPLED_REFLECT_C

#include "offer.c"

#if SP__WITH_COUPLED

#define SP__REFLECT_STARTS 48
#define SP__REFLECT_FIRST 4             /* starts before the decision, which takes longer than these and less than the others */
#define SP__REFLECT_FLOPS 4000000000    /* work for these, then for the others, which are left out where these take it all */
#define SP__REFLECT_STEPS 6000          /* of one start, five times that where the sets come near each other */
#define SP__REFLECT_NEAR ((sp_real)1e-3)
#define SP__REFLECT_CORNER 150          /* flops of B */
#define SP__REFLECT_LEAST ((sp_real)(sizeof(sp_real) == 4 ? 0.1 : 1e-3))        /* slip where there is friction, in L */
#define SP__REFLECT_LIGHT ((sp_real)(sizeof(sp_real) == 4 ? 1e-5 : 1e-10))      /* least s, beside the largest */

/* f and d of a corner in units of s and of L. */
typedef struct sp__corner { sp_real f[3], d[3]; } sp__corner;

/* s of contact t. What carries next to nothing counts as carrying a little, or f / s would be rounding. */
static sp_real sp__reflect_scale(const sp__cra *c, const sp_contact *t)
{
    return sp__max(sp__cra_sbar(c, t), SP__REFLECT_LIGHT * c->sbar_most);
}

/* The direction e of slip and -friction that is nearest to both: of opposed ones the long axis of ft ft' + kappa^2 dt dt'. */
SP__NOINLINE static void sp__reflect_direction(const sp__corner *x, sp_real kappa, sp_real e[2])
{
    const sp_real ft[2] = { x->f[1], x->f[2] }, dt[2] = { kappa * x->d[1], kappa * x->d[2] };
    const sp_real ff = ft[0] * ft[0] + ft[1] * ft[1], dd = dt[0] * dt[0] + dt[1] * dt[1];
    if (ft[0] * dt[0] + ft[1] * dt[1] < 0) {
        const sp_real half = (ft[0] * ft[0] + dt[0] * dt[0] - ft[1] * ft[1] - dt[1] * dt[1]) / 2;
        const sp_real across = ft[0] * ft[1] + dt[0] * dt[1], r = SP_SQRT(half * half + across * across);
        e[0] = half >= 0 ? half + r : across;
        e[1] = half >= 0 ? across : r - half;
        if (e[0] * dt[0] + e[1] * dt[1] < 0) { e[0] = -e[0]; e[1] = -e[1]; }
    } else for (int q = 0; q < 2; q++) e[q] = dd >= ff ? dt[q] : -ft[q];
    const sp_real norm = SP_SQRT(e[0] * e[0] + e[1] * e[1]);
    for (int q = 0; q < 2; q++) e[q] = norm > 0 ? e[q] / norm : q == 0;
}

static sp_real sp__reflect_distance(const sp__corner *x, const sp__corner *y, sp_real kappa)
{
    sp_real f = 0, d = 0;
    for (int q = 0; q < 3; q++) {
        f += (x->f[q] - y->f[q]) * (x->f[q] - y->f[q]);
        d += (x->d[q] - y->d[q]) * (x->d[q] - y->d[q]);
    }
    return f + kappa * kappa * d;
}

/* B of a corner of contact t: the nearer of open and pressing. */
SP__NOINLINE static void sp__reflect_corner(const sp__cra *c, const sp_contact *t, sp_real kappa,
                                            const sp__corner *x, sp__corner *y)
{
    const sp_real slip = SP_SQRT(x->d[1] * x->d[1] + x->d[2] * x->d[2]), cut = slip > c->k.eta ? c->k.eta / slip : 1;
    sp__corner open = { { 0 }, { sp__within(x->d[0], -c->k.eps, c->k.eta), cut * x->d[1], cut * x->d[2] } };
    sp_real e[2];
    sp__reflect_direction(x, kappa, e);
    const sp_real along[3] = { 0, e[0], e[1] }, mu = sp__cra_friction(c, t, along);
    sp_real fn = sp__max(x->f[0], 0), a = sp__max(-(x->f[1] * e[0] + x->f[2] * e[1]), 0);
    if (a > mu * x->f[0]) { fn = sp__max((x->f[0] + mu * a) / (1 + mu * mu), 0); a = mu * fn; }
    const sp_real b = sp__within(x->d[1] * e[0] + x->d[2] * e[1], a > 0 ? SP__REFLECT_LEAST : 0, c->k.eta);
    const sp__corner press = { { fn, -a * e[0], -a * e[1] }, { -c->k.eps, b * e[0], b * e[1] } };
    *y = sp__reflect_distance(x, &open, kappa) < sp__reflect_distance(x, &press, kappa) ? open : press;
}

/* z lies where the weights of the matrix were, which nothing asks for once it is factored. */
static sp__corner *sp__reflect_point(const sp__cra *c) { return (sp__corner *)(void *)c->spring.D; }

/* The metric's matrix Aeq S Aeq'; z is gone. */
static void sp__reflect_factor(const sp__cra *c)
{
    memset(c->spring.D, 0, 6 * (size_t)c->pb->points * sizeof *c->spring.D);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real *D = c->spring.D + 6 * (size_t)v;
            D[0] = D[3] = D[5] = sp__reflect_scale(c, t) / c->sbar_most;
        }
    }
    sp__system_factor(c->w, SP__GIVEN, c->w->y, SP__SHIFT);
}

/* A: of z its d to the motion w->y and its rates in spring.d, its f to forces in balance in spring.f. */
SP__NOINLINE static void sp__reflect_linear(sp__cra *c)
{
    const sp__corner *z = sp__reflect_point(c);
    sp_real *f = c->spring.f, *d = c->spring.d;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__reflect_scale(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++)
            for (int k = 0; k < 3; k++) {
                f[3 * v + (size_t)k] = s * z[v].f[k];
                d[3 * v + (size_t)k] = s / c->sbar_most * z[v].d[k];
            }
    }
    sp__cra_balance(c, d, 0);
    sp__system_solve(c->w, c->w->r, c->w->y);
    sp__cra_balance(c, f, 1);
    sp__system_solve(c->w, c->w->r, c->w->d);
    sp__cra_rates(c, c->w->d, d);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__reflect_scale(c, t) / c->sbar_most;
        for (size_t k = 3 * (size_t)t->point; k < 3 * ((size_t)t->point + (size_t)t->points); k++) f[k] -= s * d[k];
    }
    sp__cra_rates(c, c->w->y, d);
}

/* The step of vertex v of contact t, behind A; its force of B is left in spring.f.     returns how far A and B are apart */
SP__NOINLINE static sp_real sp__reflect_vertex(const sp__cra *c, const sp_contact *t, size_t v, sp_real kappa, sp__corner *z)
{
    const sp_real s = sp__reflect_scale(c, t), *d = c->spring.d + 3 * v;
    sp_real *f = c->spring.f + 3 * v, most = 0;
    sp__corner mirrored, next;
    for (int k = 0; k < 3; k++) {
        mirrored.f[k] = 2 * f[k] / s - z->f[k];
        mirrored.d[k] = 2 * d[k] - z->d[k];
    }
    sp__reflect_corner(c, t, kappa, &mirrored, &next);
    for (int k = 0; k < 3; k++) {
        const sp_real by = next.f[k] - f[k] / s, along = next.d[k] - d[k];
        z->f[k] += by;
        z->d[k] += along;
        f[k] = s * next.f[k];
        most = sp__max(most, sp__max(sp__abs(by), kappa * sp__abs(along)));
    }
    return most;
}

/* A step of z.     returns the largest difference between A and B */
SP__NOINLINE static sp_real sp__reflect_step(sp__cra *c, sp_real kappa)
{
    sp__corner *z = sp__reflect_point(c);
    sp_real most = 0;
    if (!sp__system_spend(c->w, SP__REFLECT_CORNER * (int64_t)c->pb->points)) return SP__HUGE;
    sp__reflect_linear(c);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        for (int32_t v = t->point; v < t->point + t->points; v++)
            most = sp__max(most, sp__reflect_vertex(c, t, (size_t)v, kappa, z + v));
    }
    return most;
}

/* Start k: every other with the forces of statics; three with slips against these, then with motions of any kind. */
SP__NOINLINE static void sp__reflect_begin(const sp__cra *c, int k, sp__corner *z)
{
    const sp_real size[] = { 1, 10, (sp_real)0.1, 100 };
    uint32_t x = 2463534242u + 7919u * (uint32_t)k;
    for (size_t i = 0; i < 6 * (size_t)c->pb->blocks; i++) {
        x = sp__random(x);
        c->w->y[i] = size[k % 4] * ((sp_real)(x >> 8) / (1 << 23) - 1);
    }
    sp__system_release(c->w, c->w->y);
    sp__cra_rates(c, c->w->y, c->spring.d);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__reflect_scale(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++)
            for (size_t i = 0; i < 3; i++) {
                const sp_real f = sp__in_units(c->w->measure.unit, c->statics[3 * v + i]) / s;
                z[v].f[i] = k % 2 ? 0 : f;
                z[v].d[i] = k > 2 ? c->spring.d[3 * v + i] : i ? -10 * f : -c->k.eps;
            }
    }
}

/* The rest of the digits. Where that fails z goes on from the point where the sets were near, forces of B and their motion.
 *   returns 1 when a triple is verified */
SP__NOINLINE static int sp__reflect_polish(sp__cra *c)
{
    sp_real *kept[3] = { c->spring.lam, c->drag.bound, c->drag.share };
    const size_t n = (size_t)c->pb->points;
    c->out->rounds++;
    for (size_t k = 0; k < 3 * n; k++) kept[k % 3][k / 3] = c->spring.f[k];
    if (sp__cra_polish(c)) return 1;
    sp__reflect_factor(c);
    memcpy(c->w->y, c->descent.from, 6 * (size_t)c->pb->blocks * sizeof *c->w->y);
    sp__cra_rates(c, c->w->y, c->spring.d);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__reflect_scale(c, t);
        for (size_t k = 3 * (size_t)t->point; k < 3 * ((size_t)t->point + (size_t)t->points); k++) {
            sp__corner *z = sp__reflect_point(c) + k / 3;
            z->f[k % 3] = kept[k % 3][k / 3] / s;
            z->d[k % 3] = c->spring.d[k];
        }
    }
    return 0;
}

/* Steps from start k; the rest of the digits is tried whenever the sets are ten times nearer.
 *   returns 1 when a triple is verified */
SP__NOINLINE static int sp__reflect_run(sp__cra *c, int k)
{
    static const sp_real kappa[] = { (sp_real)0.1, (sp_real)0.3, (sp_real)0.03 };
    sp_real next = (sp_real)1e-2;
    sp__reflect_factor(c);
    sp__reflect_begin(c, k, sp__reflect_point(c));
    for (int32_t step = 0, last = SP__REFLECT_STEPS; step < last && !c->w->budget.spent; step++) {
        const sp_real apart = sp__reflect_step(c, kappa[k % 3]);
        if (apart < SP__REFLECT_NEAR) last = 5 * SP__REFLECT_STEPS;
        if (apart > next) continue;
        if (sp__reflect_polish(c)) return 1;
        next = apart / 10;
    }
    return 0;
}

/* From starts `first` to `last` - 1, for work of its own within `left`.     returns 1 when a triple is verified */
static int sp__cra_reflect(sp__cra *c, int first, int last, int64_t left)
{
    const int64_t limit = c->out->cost.flops + SP__REFLECT_FLOPS;
    c->w->budget.limit = limit < left ? limit : left;
    c->w->budget.spent = 0;
    for (int k = first; k < last && !c->w->budget.spent; k++) if (sp__reflect_run(c, k)) return 1;
    return 0;
}

#endif

#endif /* SP__COUPLED_REFLECT_C */
