/* wedge: a vertex of a search in 3 rows a block, where its joint has no strength: fn and, in the plane, one slip.
 *
 *   planar         un = X0 + q0 X2,  us = slide (X1 + q1 X2)          K is a wedge, its sides those of the cone in the plane
 *   level          un = X0 + q0 X1 + q1 X2                            K is fn >= 0
 *
 * X is the motion of B seen from A in 3 rows, at the contact's origin (sp__reduction_motion), q the levers of the vertex.
 */
#ifndef SP__STATICS_WEDGE_C
#define SP__STATICS_WEDGE_C

#include "motion.c"

#if SP__WITH_LARGE

/* f = S u; f = S P_K(u); df = D du with D given, with D = E W^2 E' of the interior-point method */
typedef enum sp__law { SP__BILATERAL, SP__ADMISSIBLE, SP__GIVEN, SP__INTERIOR } sp__law;

/* Levers of a vertex at l in the contact's frame. */
static inline void sp__wedge_levers(const sp__system *w, const sp_real *g, const sp_real *l, sp_real q[2])
{
    const int plane = w->reduction->mode == SP__PLANE;
    q[0] = plane ? -(l[1] * g[2] + l[2] * g[3]) : g[0] * l[2] - g[1] * l[1];
    q[1] = plane ? l[0] : g[2] * l[2] - g[3] * l[1];
}

/* u = (un, us) of a vertex with levers q. */
static inline void sp__wedge_rates(const sp__system *w, const sp_real q[2], const sp_real X[3], sp_real u[2])
{
    const int plane = w->reduction->mode == SP__PLANE;
    u[0] = plane ? X[0] + q[0] * X[2] : X[0] + q[0] * X[1] + q[1] * X[2];
    u[1] = plane ? w->law.slide * (X[1] + q[1] * X[2]) : 0;
}

/* Y += what force f = (fn, fs) at levers q does to X. */
static inline void sp__wedge_gather(const sp__system *w, const sp_real q[2], const sp_real f[2], sp_real Y[3])
{
    const int plane = w->reduction->mode == SP__PLANE;
    Y[0] += f[0];
    Y[1] += plane ? f[1] : q[0] * f[0];
    Y[2] += plane ? q[0] * f[0] + q[1] * f[1] : q[1] * f[0];
}

/* The force as (fn, ft1, ft2); out may be f. */
static inline void sp__wedge_widen(const sp__system *w, const sp_real *g, const sp_real f[2], sp_real out[3])
{
    const sp_real slip = w->reduction->mode == SP__PLANE ? f[1] : 0;
    out[0] = f[0];
    out[1] = slip * g[2];
    out[2] = slip * g[3];
}

/* f = P_K(u) with tension at its price, D its derivative (nn, ns, ss); mu: of the yield. f or D may be NULL. */
static inline void sp__wedge_project(const sp__system *w, sp_real mu, const sp_real *g, const sp_real u[2], sp_real *f,
                                     sp_real *D)
{
    const sp_real side = u[1] < 0 ? (sp_real)-1 : (sp_real)1, s = side * u[1], k = mu / g[u[1] < 0 ? 5 : 4];
    const sp_real n = u[0] + k * s, x = n / (1 + k * k);
    const int inside = u[0] >= 0 && s <= k * u[0], carries = inside || n > 0;
    const sp_real soft = u[0] < 0 ? w->law.soft : 0, c = 1 / (1 + k * k);
    if (f) { f[0] = (inside ? u[0] : carries ? x : 0) + soft * u[0]; f[1] = inside ? u[1] : carries ? side * k * x : 0; }
    if (!D) return;
    D[0] = (inside ? 1 : carries ? c : 0) + soft;
    D[1] = inside || !carries ? 0 : side * k * c;
    D[2] = inside ? 1 : carries ? k * k * c : 0;
}

/* out = P_K(f - D u) in the exact form; out may be f. */
SP__NOINLINE static void sp__wedge_change(const sp__system *w, int32_t c, const sp_real *g, const sp_real D[3],
                                          const sp_real u[2], const sp_real f[2], sp_real *out)
{
    const sp_real x = f[0] - (D[0] * u[0] + D[1] * u[1]), y = f[1] - (D[1] * u[0] + D[2] * u[1]);
    out[0] = x; out[1] = y;
    if (w->reduction->mode == SP__PLANE) { sp__wedge_project(w, sp__system_mu(w, c), g, out, out, NULL); return; }
    out[0] = sp__max(0, x);
    out[1] = 0;
}

/* f = P_K(u), or u where joints are bilateral, in the metric; D likewise. */
static inline void sp__wedge_law(const sp__system *w, sp__law law, int32_t c, const sp_real *g, const sp_real u[2], sp_real *f,
                          sp_real *D)
{
    const sp_real S = sp__system_scale(w, c), T = S * w->law.slide;
    if (f) { f[0] = u[0]; f[1] = u[1]; }
    if (D) { D[0] = D[2] = 1; D[1] = 0; }
    if (law == SP__ADMISSIBLE && w->reduction->mode == SP__PLANE) sp__wedge_project(w, sp__system_mu(w, c), g, u, f, D);
    else if (law == SP__ADMISSIBLE && u[0] < 0) {
        if (f) f[0] *= w->law.soft;
        if (D) D[0] = w->law.soft;
    }
    if (f) { f[0] *= S; f[1] *= T; }
    if (D) { D[0] *= S; D[1] *= T; D[2] *= T * w->law.slide; }
}

#endif

#endif /* SP__STATICS_WEDGE_C */
