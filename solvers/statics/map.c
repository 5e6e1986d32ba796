/* map: from the motion of a contact's two blocks to its vertices, and from forces at the vertices back to the blocks.
 *
 *   X = T y        motion of B seen from A at the contact's origin, 6 numbers V, W, or 3 in a search of 3 rows a block
 *   u = (I, -[l]x) X                  rates of a vertex at l, three, or fn's and one slip's (wedge.c)
 *   f = S P_K(u)                      its force;  Y += (I, -[l]x)' f;  r += T' Y
 *
 * Two kernels behind one face: passes over the vertices (gradient, slope, resistance, sizes) are written once. The wide one
 * works from lever arms. One matrix of 6 x rows a contact side, made once, would serve both, but costs plain scenes more than
 * it saves: 1,400 flops for 900 in the assembly of a contact and 216 for 160 there and back; measured, walls of 54 to 2,000
 * joints take 4 to 10 % longer, an arch 4 %, a dome 6 % (medians of nine, runs interleaved).
 */
#ifndef SP__STATICS_MAP_C
#define SP__STATICS_MAP_C

#include "wedge.c"

#if SP__WITH_LARGE

/* A contact as a pass over its vertices sees it. */
typedef struct sp__view {
    const sp_contact *t;
    int32_t c;
    const sp_real *g;       /* frame of the narrow kernel: 3 numbers a motion, 2 a vertex; NULL: the wide kernel, 6 and 3 */
} sp__view;

/* From now on w->law.yield is K of its vertices. */
static sp__view sp__view_of(const sp__system *w, int32_t c)
{
    const sp_contact *t = &w->pb->contact[c];
    const int narrow = sp__system_yield(w, c)->plain && sp__reduced(w);
    const sp__view k = { t, c, narrow ? sp__reduction_frame(w, t) : NULL };
    return k;
}

/* X = T y */
static inline void sp__view_motion(const sp__system *w, const sp__view *k, const sp_real *y, sp_real X[6])
{
    if (k->g) sp__reduction_motion(w, k->t, k->g, y, X);
    else sp__system_twist(w, k->t, y, X, X + 3);
}

/* r += T' Y */
static void sp__view_scatter(const sp__system *w, const sp__view *k, const sp_real Y[6], sp_real *r)
{
    if (k->g) sp__reduction_gather(w, k->t, k->g, Y, r);
    else sp__system_scatter(w, k->t, Y, Y + 3, r);
}

/* Where a vertex at l is, for the two below: l, or its levers, which lie in w->scratch until the next call. */
static inline const sp_real *sp__view_place(const sp__system *w, const sp__view *k, const sp_real *l)
{
    if (!k->g) return l;
    sp__wedge_levers(w, k->g, l, sp__visit_of(w)->h);
    return sp__visit_of(w)->h;
}

/* u = (I, -[l]x) X, friction weighed; the narrow kernel has no third. */
static inline void sp__view_rates(const sp__system *w, const sp__view *k, const sp_real *place, const sp_real X[6],
                                  sp_real u[3])
{
    if (k->g) sp__wedge_rates(w, place, X, u);
    else sp__system_rate(w, X, X + 3, place, u);
}

/* f = S P_K(u), or S u */
static inline void sp__view_force(const sp__system *w, const sp__view *k, sp__law law, const sp_real u[3], sp_real f[3])
{
    if (k->g) { sp__wedge_law(w, law, k->c, k->g, u, f, NULL); return; }
    if (law == SP__ADMISSIBLE) { sp__system_force(w, k->c, w->law.yield, u, f); return; }
    for (int q = 0; q < 3; q++) f[q] = sp__system_scale(w, k->c) * (q ? w->law.slide * u[q] : u[q]);
}

/* f = P_K(u) of the narrow kernel, as a call of its own: written into the line search it would deepen the stack of sp_check,
 * which reaches its deepest there. */
SP__NOINLINE static void sp__view_wedge(const sp__system *w, const sp__view *k, const sp_real *u, sp_real *f)
{
    sp__wedge_law(w, SP__ADMISSIBLE, k->c, k->g, u, f, NULL);
}

/* f as (fn, ft1, ft2) */
static inline void sp__view_widen(const sp__system *w, const sp__view *k, const sp_real f[3], sp_real out[3])
{
    if (k->g) sp__wedge_widen(w, k->g, f, out);
    else memcpy(out, f, 3 * sizeof *f);
}

/* Y += (I, -[l]x)' f */
static inline void sp__view_gather(const sp__system *w, const sp__view *k, const sp_real *place, const sp_real f[3],
                                   sp_real Y[6])
{
    const sp_real *l = place;
    if (k->g) { sp__wedge_gather(w, place, f, Y); return; }
    Y[0] += f[0]; Y[1] += f[1]; Y[2] += f[2];
    Y[3] += l[1] * f[2] - l[2] * f[1];
    Y[4] += l[2] * f[0] - l[0] * f[2];
    Y[5] += l[0] * f[1] - l[1] * f[0];
}

/* |f| of as many numbers as there are. */
static inline sp_real sp__view_norm(const sp__view *k, const sp_real f[3])
{
    return k->g ? SP_SQRT(f[0] * f[0] + f[1] * f[1]) : sp__norm3(f);
}

/* f.u; friction is weighed in u, not in f. */
static sp_real sp__view_power(const sp__system *w, const sp__view *k, const sp_real f[3], const sp_real u[3])
{
    return f[0] * u[0] + (k->g ? f[1] * u[1] : f[1] * u[1] + f[2] * u[2]) / w->law.slide;
}

#endif

#endif /* SP__STATICS_MAP_C */
