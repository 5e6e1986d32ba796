/* hessian: Aeq S DP_K(Aeq' y) Aeq', contact by contact into blocks of 6 x 6, or of 3 x 3 in a reduced search.
 *
 *   H = sum over its vertices of (I, -[l]x)' D (I, -[l]x)         of a contact, in its frame
 *   K_aa += Ta' H Ta,   K_bb += Tb' H Tb,   K_ab -= Ta' H Tb      moved to the centroids of its blocks
 *
 * D of a vertex: S DP_K(u), or E W^2 E' of the interior-point method.
 */
#ifndef SP__STATICS_HESSIAN_C
#define SP__STATICS_HESSIAN_C

#include "capped.c"
#include "wedge.c"

#if SP__WITH_LARGE

/* Is K of every vertex a wedge, or fn >= 0, of a reduced search? */
static int sp__ipm_narrow(const sp__system *w) { return sp__reduced(w) && w->reduction->no_strength; }

/* Numbers x of a vertex: of the true cone 3, else one an edge of K; of a wedge its sides, of level joints fn alone. */
static size_t sp__ipm_numbers(const sp__system *w)
{
    if (sp__ipm_narrow(w)) return w->reduction->mode == SP__PLANE ? 2 : 1;
    return w->law.cone.faces ? (size_t)w->law.cone.faces : 3;
}

/* What each side of a wedge has of the cone's e. */
static sp_real sp__ipm_share(const sp__system *w) { return w->reduction->mode == SP__PLANE ? (sp_real)0.5 : 1; }

/* Columns of E of a wedge, x >= 0: (e[0], e[1]) and (e[0], e[2]), the cone's in the plane: its x0 +- x1 are their x, and of
 * z0 +- z1 each has half, so that its path is theirs. They lie in w->scratch until the next visit. */
SP__NOINLINE static void sp__ipm_sides(const sp__system *w, int32_t c, const sp_real *g)
{
    const int plane = w->reduction->mode == SP__PLANE;
    const sp_real mu = plane ? sp__system_mu(w, c) : 0;
    sp_real *e = sp__visit_of(w)->edge;
    e[0] = sp__ipm_share(w) * w->inner->force_scale * sp__system_scale(w, c);
    e[1] = plane ? e[0] * (mu / g[4]) : 0;
    e[2] = plane ? -e[0] * (mu / g[5]) : 0;
}

/* sp__ipm_derivative of a wedge: D nn, ns, ss. */
SP__NOINLINE static void sp__ipm_by_sides(sp__system *w, int32_t v, const sp_real u[2], sp_real D[3], sp_real *f)
{
    const int32_t sides = (int32_t)sp__ipm_numbers(w);
    const sp_real *x = w->inner->x + (size_t)sides * (size_t)v, *e = sp__visit_of(w)->edge;
    const sp_real times = sp__system_multiplicity(w, v), theta = sp__ipm_share(w) * w->inner->theta;
    D[0] = D[1] = D[2] = 0;
    if (f) f[0] = f[1] = f[2] = 0;
    for (int32_t k = 0; k < sides; k++) {
        const sp_real a = e[0], b = e[1 + k], z = theta - (a * u[0] + b * u[1]), s = x[k] / z;
        if (!(z > 0 && x[k] > 0)) w->inner->outside = 1;
        w->inner->gap += times * x[k] * z;
        D[0] += s * a * a; D[1] += s * a * b; D[2] += s * b * b;
        if (f) { f[0] += x[k] * a; f[1] += x[k] * b; }
    }
}

/* E = S diag(1, mu, mu) for the true cone; for a pyramid x >= 0 and column k of E is its k-th edge, n (1, mu d + h d'),
 * n = S / faces, h = mu tan(pi / faces), d the normal of its k-th face, d' the same turned by a quarter; all times
 * `force_scale`. */
static sp_real sp__ipm_normal(const sp__system *w, int32_t c)
{
    return w->inner->force_scale * sp__system_scale(w, c) / (sp_real)w->law.cone.faces;
}

/* An edge. e[1] is not written like e[2]: see sp__soc_square. */
static inline void sp__ipm_edge(sp_real n, sp_real mu, sp_real h, const sp_real d[2], sp_real e[3])
{
    e[0] = n;
    e[1] = n * mu * d[0] - n * h * d[1];
    e[2] = n * (mu * d[1] + h * d[0]);
}

/* A pyramid's share of sp__ipm_derivative. */
SP__NOINLINE static void sp__ipm_by_edges(sp__system *w, int32_t c, int32_t v, const sp_real u[3], sp_real D[6], sp_real f[3])
{
    const sp_real *x = w->inner->x + (size_t)w->law.cone.faces * (size_t)v, times = sp__system_multiplicity(w, v);
    const sp_real n = sp__ipm_normal(w, c), mu = sp__system_mu(w, c), h = mu * w->law.cone.tan_half;
    sp_real *e = sp__visit_of(w)->edge;
    for (int32_t k = 0; k < w->law.cone.faces; k++) {
        sp__ipm_edge(n, mu, h, w->law.cone.direction[k], e);
        const sp_real zk = w->inner->theta - sp__dot3(e, u), s = x[k] / zk;
        if (!(zk > 0 && x[k] > 0)) w->inner->outside = 1;
        w->inner->gap += times * x[k] * zk;
        D[0] += s * e[0] * e[0]; D[1] += s * e[0] * e[1]; D[2] += s * e[0] * e[2];
        D[3] += s * e[1] * e[1]; D[4] += s * e[1] * e[2]; D[5] += s * e[2] * e[2];
        for (int q = 0; f && q < 3; q++) f[q] += x[k] * e[q];
    }
}

/* The true cone's. */
SP__NOINLINE static void sp__ipm_by_cone(sp__system *w, int32_t c, int32_t v, const sp_real u[3], sp_real D[6], sp_real f[3])
{
    const sp_real *x = w->inner->x + 3 * (size_t)v;
    const sp_real S = w->inner->force_scale * sp__system_scale(w, c), T = S * sp__system_mu(w, c);
    sp_real *z = sp__visit_of(w)->z;
    z[0] = w->inner->theta - S * u[0]; z[1] = -T * u[1]; z[2] = -T * u[2];
    sp__nt W;
    if (!sp__soc_scaling(x, z, &W)) { w->inner->outside = 1; return; }
    const sp_real s = W.s * W.s, p = 2 * s * W.w[1], q = 2 * s * W.w[2];
    w->inner->gap += sp__system_multiplicity(w, v) * sp__dot3(x, z);
    D[0] = S * S * s * (1 + 2 * (W.w[1] * W.w[1] + W.w[2] * W.w[2]));
    D[1] = S * T * p * W.w[0]; D[2] = S * T * q * W.w[0];
    D[3] = T * T * (p * W.w[1] + s); D[4] = T * T * p * W.w[2]; D[5] = T * T * (q * W.w[2] + s);
    if (f) { f[0] = S * x[0]; f[1] = T * x[1]; f[2] = T * x[2]; }
}

/* D = E W^2 E' for rates u = Aeq' y, z = theta e - E'u; f (may be NULL) = E x. Adds x.z to the gap. */
static void sp__ipm_derivative(sp__system *w, int32_t c, int32_t v, const sp_real u[3], sp_real D[6], sp_real f[3])
{
    for (int k = 0; k < 6; k++) D[k] = 0;
    for (int k = 0; f && k < 3; k++) f[k] = 0;
    if (w->inner->capped) sp__capped_derivative(w, c, v, D, f);
    else if (w->law.cone.faces) sp__ipm_by_edges(w, c, v, u, D, f);
    else sp__ipm_by_cone(w, c, v, u, D, f);
}

/* An assembly. */
static int sp__system_assembly(sp__system *w, int plain)
{
    const sp__reduction *o = sp__reduced(w);
    if (o && plain)
        return sp__system_spend(w, SP__FLOPS_REDUCED_HESSIAN(o) * o->vertices + SP__FLOPS_REDUCED_BLOCKS * o->sides);
    return sp__system_count(w, SP__FLOPS_HESSIAN, SP__FLOPS_BLOCKS);
}

/* H of a contact, 3 x 3 in X. */
SP__NOINLINE static void sp__wedge_hessian(sp__system *w, sp__law law, int32_t c, const sp_real *y, sp_real H[9])
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__reduction_frame(w, t);
    const int plane = w->reduction->mode == SP__PLANE;
    sp__visit *at = sp__visit_of(w);
    sp_real *X = at->twist[0], *h = at->twist[1], *q = at->m, *u = at->u[0], *D = at->D;
    for (int k = 0; k < 6; k++) h[k] = 0;
    if (SP__WITH_INTERIOR && law == SP__INTERIOR) sp__ipm_sides(w, c, g);
    sp__reduction_motion(w, t, g, y, X);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *l = w->pb->local[v], times = sp__system_multiplicity(w, v);
        if (!(times > 0)) continue;
        sp__wedge_levers(w, g, l, q);
        sp__wedge_rates(w, q, X, u);
        if (SP__WITH_INTERIOR && law == SP__INTERIOR) sp__ipm_by_sides(w, v, u, D, NULL);
        else sp__wedge_law(w, law, c, g, u, NULL, D);
        const sp_real nn = times * D[0], ns = times * D[1], ss = times * D[2];
        const sp_real a = nn * q[0], b = plane ? ns * q[1] : nn * q[1];
        h[0] += nn;
        h[1] += plane ? ns : a;
        h[2] += plane ? a + b : b;
        h[3] += plane ? ss : a * q[0];
        h[4] += plane ? ns * q[0] + ss * q[1] : a * q[1];
        h[5] += plane ? (a + 2 * b) * q[0] + ss * q[1] * q[1] : b * q[1];
    }
    H[0] = h[0]; H[1] = H[3] = h[1]; H[2] = H[6] = h[2];
    H[4] = h[3]; H[5] = H[7] = h[4]; H[8] = h[5];
}

/* h += (I, -[l]x)' D (I, -[l]x), row by row: x = l x D_i is row i of -D [l]x, and [l]x of those rows makes ww. */
SP__NOINLINE static void sp__vertex_hessian(const sp_real D[6], const sp_real *l, sp_real *h)
{
    static const unsigned char at[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
    for (int i = 0; i < 3; i++) {
        const int up = (i + 2) % 3, down = (i + 1) % 3;
        const sp_real row[3] = { D[at[i][0]], D[at[i][1]], D[at[i][2]] };
        sp_real x[3];
        sp__cross3(l, row, x);
        for (int j = 0; j < 3; j++) {
            h[3 * i + j] += row[j];
            h[9 + 3 * i + j] += x[j];
            h[18 + 3 * down + j] += l[up] * x[j];
            h[18 + 3 * up + j] -= l[down] * x[j];
        }
    }
}

/* D of a vertex for rates u, of both blocks welded or of Newton's forces.     returns 0 when it is zero: the vertex is open */
static int sp__vertex_slope(const sp__system *w, sp__law law, int32_t c, const sp_real *u, sp_real D[6])
{
    D[0] = D[3] = D[5] = 1;
    D[1] = D[2] = D[4] = 0;
    if (law == SP__ADMISSIBLE) {
        const sp__region region = sp__cone_derivative(&w->law.cone, sp__system_yield(w, c), u, D);
        if (w->law.soft > 0 && u[0] < 0) D[0] += w->law.soft;
        else if (region == SP__APEX) return 0;
    }
    const sp_real S = sp__system_scale(w, c), T = S * w->law.slide, R = T * w->law.slide;
    D[0] *= S; D[1] *= T; D[2] *= T; D[3] *= R; D[4] *= R; D[5] *= R;
    return 1;
}

/* D of a vertex, df = D du for rates u = V + W x l; u: room for them.     returns 0 when it is zero */
static int sp__vertex_law(sp__system *w, sp__law law, int32_t c, int32_t v, const sp_real *twist, sp_real *u, sp_real D[6])
{
    if (law == SP__GIVEN) { memcpy(D, w->law.given + 6 * (size_t)v, 6 * sizeof *D); return 1; }
    sp__system_rate(w, twist, twist + 3, w->pb->local[v], u);
    if (!SP__WITH_INTERIOR || law != SP__INTERIOR) return sp__vertex_slope(w, law, c, u, D);
    sp__ipm_derivative(w, c, v, u, D, NULL);
    return 1;
}

/* The contact's share H = sum (I, -[l]x)' D (I, -[l]x) of the Hessian in its own frame, into w->scratch->H.
 *     returns 0 when all of it is zero: the contact is open */
SP__NOINLINE static int sp__system_contact_hessian(sp__system *w, sp__law law, int32_t c, const sp_real *y)
{
    const sp_contact *t = &w->pb->contact[c];
    sp__visit *s = sp__visit_of(w);
    sp_real *h = w->scratch->H, *twist = s->twist[0];
    int carries = 0;
    if (SP__WITH_INTERIOR && law == SP__INTERIOR && w->inner->capped) sp__capped_rows(w, c);
    sp__system_twist(w, t, y, twist, twist + 3);
    for (int q = 0; q < 27; q++) h[q] = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        if (!(sp__system_multiplicity(w, v) > 0) || !sp__vertex_law(w, law, c, v, twist, s->u[0], s->D)) continue;
        for (int k = 0; k < 6; k++) s->D[k] *= sp__system_multiplicity(w, v);
        sp__vertex_hessian(s->D, w->pb->local[v], h);
        carries = 1;
    }
    return carries;
}

/* out = R m R', R = (n, t1, t2): from the contact's frame to the world's. out may not be m. */
SP__NOINLINE static void sp__rotate(const sp_contact *t, const sp_real *m, sp_real *out)
{
    const sp_real *R[3] = { t->joint->n, t->joint->t1, t->joint->t2 };
    sp_real a[9];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) a[3 * i + j] = R[0][i] * m[j] + R[1][i] * m[3 + j] + R[2][i] * m[6 + j];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out[3 * i + j] = a[3 * i] * R[0][j] + a[3 * i + 1] * R[1][j] + a[3 * i + 2] * R[2][j];
}

/* out = [c]x m (+ add, if not NULL) */
static void sp__cross_left(const sp_real c[3], const sp_real *m, const sp_real *add, sp_real *out)
{
    for (int j = 0; j < 3; j++) {
        const sp_real x = m[j], y = m[3 + j], s = m[6 + j];
        out[j]     = c[1] * s - c[2] * y + (add ? add[j] : 0);
        out[3 + j] = c[2] * x - c[0] * s + (add ? add[3 + j] : 0);
        out[6 + j] = c[0] * y - c[1] * x + (add ? add[6 + j] : 0);
    }
}

/* out = m - a [c]x, row i: m_i + c x a_i; `turn`: with a' in place of a */
static void sp__cross_right(const sp_real c[3], const sp_real *a, int turn, const sp_real *m, sp_real *out)
{
    for (int i = 0; i < 3; i++) {
        const sp_real x = turn ? a[i] : a[3 * i], y = turn ? a[3 + i] : a[3 * i + 1], s = turn ? a[6 + i] : a[3 * i + 2];
        out[3 * i]     = m[3 * i]     + c[1] * s - c[2] * y;
        out[3 * i + 1] = m[3 * i + 1] + c[2] * x - c[0] * s;
        out[3 * i + 2] = m[3 * i + 2] + c[0] * y - c[1] * x;
    }
}

/* to(r, c) += z m(r, c), 3 x 3; to has strides tr, tc, m is by rows or, mc = 3, by columns. */
static void sp__add9(sp_real *to, int tr, int tc, sp_real z, const sp_real *m, int mr, int mc)
{
    for (int c = 0; c < 3; c++, to += tc, m += mc) {
        to[0]      += z * m[0];
        to[tr]     += z * m[mr];
        to[2 * tr] += z * m[2 * mr];
    }
}

/* Diagonal block += Z [ vv . ; vw' ww ] Z, Z = diag(z[0], z[1]): the lower triangle by columns. */
static void sp__add_diagonal(sp_real *d, const sp_real *z, const sp_real *vv, const sp_real *vw, const sp_real *ww)
{
    const sp_real f = z[0] * z[0], g = z[0] * z[1], m = z[1] * z[1];
    d[0] += f * vv[0]; d[1] += f * vv[3]; d[2] += f * vv[6];
    d[6] += f * vv[4]; d[7] += f * vv[7];
    d[11] += f * vv[8];
    for (int k = 0; k < 3; k++) { d[3 + k] += g * vw[k]; d[8 + k] += g * vw[3 + k]; d[12 + k] += g * vw[6 + k]; }
    d[15] += m * ww[0]; d[16] += m * ww[3]; d[17] += m * ww[6];
    d[18] += m * ww[4]; d[19] += m * ww[7];
    d[20] += m * ww[8];
}

/* Block -= Za [ vv qb ; qa' ww ] Zb, by columns, or by rows where it is stored transposed. */
SP__NOINLINE static void sp__add_coupling(sp_real *block, int turn, const sp_real *za, const sp_real *zb, const sp_real *vv,
                                       const sp_real *qa, const sp_real *qb, const sp_real *ww)
{
    const int tr = turn ? 6 : 1, tc = turn ? 1 : 6;
    sp__add9(block, tr, tc, -za[0] * zb[0], vv, 3, 1);
    sp__add9(block + 3 * tc, tr, tc, -za[0] * zb[1], qb, 3, 1);
    sp__add9(block + 3 * tr, tr, tc, -za[1] * zb[0], qa, 1, 3);
    sp__add9(block + 3 * tr + 3 * tc, tr, tc, -za[1] * zb[1], ww, 3, 1);
}

/* The matrix's block of free block i, the lower triangle by columns; of a contact between free blocks, or of all between the
 * two: its rows are the later one's in elimination order. L is made in place, unless it is of other precision. */
#ifdef SP_REAL_MIXED
static sp_real *sp__system_diagonal(const sp__system *w, int32_t i) { return w->mixed.diagonal + 21 * (size_t)w->L.inv[i]; }
static sp_real *sp__system_coupling(const sp__system *w, int32_t c) { return w->mixed.coupling + 36 * (size_t)c; }
#else
static sp_real *sp__system_diagonal(const sp__system *w, int32_t i) { return w->L.d + 21 * (size_t)w->L.inv[i]; }
static sp_real *sp__system_coupling(const sp__system *w, int32_t c)
{
    return w->L.x + 36 * (size_t)(w->slot[c] < 0 ? -1 - w->slot[c] : w->slot[c]);
}
#endif

/* Rows and columns of held directions to zero, in every block they run through. */
static void sp__system_clear_held(sp__system *w)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i < pb->blocks; i++)
        for (int k = 0; k < 6; k++) {
            sp_real *d = sp__system_diagonal(w, i);
            if (!sp__held(pb, i, k)) continue;
            for (int q = 0; q < 6; q++) d[q < k ? sp__column[q] + k - q : sp__column[k] + q - k] = 0;
        }
    for (int32_t c = 0; c < pb->contacts; c++)
        for (int k = 0; k < 12 && w->slot[c] != INT32_MIN; k++) {
            const int32_t i = k < 6 ? pb->contact[c].a : pb->contact[c].b;
            const int turn = w->slot[c] < 0, row = (k < 6) != turn;     /* is block a's direction a row as stored? */
            sp_real *x = sp__system_coupling(w, c);
            if (!sp__held(pb, i, k % 6)) continue;
            for (int q = 0; q < 6; q++) x[row ? 6 * q + k % 6 : 6 * (k % 6) + q] = 0;
        }
}

/* Contact c's H, in w->scratch, moved to the centroids of its blocks,
 *
 *   T = [ I  -[arm]x ; 0  I ],   K_aa = Ta' H Ta,   K_bb = Tb' H Tb,   K_ab = -Ta' H Tb                                  */
SP__NOINLINE static void sp__system_add(sp__system *w, int32_t c)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *z = w->measure.weight;
    const sp_real *za = z + 2 * (size_t)(t->a < 0 ? 0 : t->a), *zb = z + 2 * (size_t)(t->b < 0 ? 0 : t->b);
    sp__moved *m = &w->scratch->of.moved;
    const sp_real *H = w->scratch->H;
    sp__rotate(t, H, m->vv);
    sp__rotate(t, H + 9, m->vw);
    sp__rotate(t, H + 18, m->ww);
    if (t->a >= 0) {
        sp__cross_right(t->ra, m->vv, 0, m->vw, m->vwa);                    /* K_vw = vw - vv [arm]x */
        sp__cross_right(t->ra, m->vw, 1, m->ww, m->part);                   /* ww - vw' [arm]x */
        sp__cross_left(t->ra, m->vwa, m->part, m->sum);                     /* K_ww */
        sp__add_diagonal(sp__system_diagonal(w, t->a), za, m->vv, m->vwa, m->sum);
    }
    if (t->b >= 0) {
        sp__cross_right(t->rb, m->vv, 0, m->vw, m->vwb);
        sp__cross_right(t->rb, m->vw, 1, m->ww, m->part);
        sp__cross_left(t->rb, m->vwb, m->part, m->sum);
        sp__add_diagonal(sp__system_diagonal(w, t->b), zb, m->vv, m->vwb, m->sum);
    }
    if (w->slot[c] != INT32_MIN) {
        sp__cross_left(t->ra, m->vwb, m->part, m->sum);
        sp__add_coupling(sp__system_coupling(w, c), w->slot[c] < 0, za, zb, m->vv, m->vwa, m->vwb, m->sum);
    }
}

/* Aeq S DP Aeq' + shift into L. */
SP__NOINLINE static void sp__system_assemble(sp__system *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp_problem *pb = w->pb;
    int held = 0;
#ifdef SP_REAL_MIXED
    memset(w->mixed.diagonal, 0, 21 * (size_t)pb->blocks * sizeof *w->mixed.diagonal);
    memset(w->mixed.coupling, 0, 36 * (size_t)pb->contacts * sizeof *w->mixed.coupling);
#else
    sp__bchol_zero(&w->L);
#endif
    for (int32_t c = 0; c < pb->contacts; c++) if (sp__system_contact_hessian(w, law, c, y)) sp__system_add(w, c);
    for (int32_t i = 0; i < pb->blocks && !held; i++) held = pb->scene->block[pb->block[i]].fixed != 0;
    if (held) sp__system_clear_held(w);
    for (int32_t i = 0; i < pb->blocks; i++)
        for (int q = 0; q < 6; q++) sp__system_diagonal(w, i)[sp__column[q]] += shift;
}

#endif

#endif /* SP__STATICS_HESSIAN_C */
