/* 6 ---------------------------------------------------------------------------------------------------------- the dual
 *
 * The shortest force in the cones that balances p is f = S P_K(Aeq' y), where y minimises
 *
 *   D(y) = 1/2 sum S_v |P_K(u_v)|^2 + p . y,   u = Aeq' y         gradient Aeq f + p,  Hessian Aeq S DP_K(u) Aeq'
 *
 * convex, once differentiable, 6 unknowns a free block. f is admissible for every y; the imbalance is the only error. An
 * assembly that cannot stand has no minimiser: y runs off along the mechanism dq = -y.
 * Rows are weighted to unit size, forces counted in the largest load, so nothing depends on units. The penalty form adds
 * sum max(0, -u_n)^2 / (2 gamma) (tension at a price) and weighs friction by tau; with gamma finite it always has a minimiser.
 */
typedef struct sp__dual {
    const sp_problem *pb;
    const sp_settings *set;
    sp__cone cone;
    sp__bchol L;                        /* factor of the Hessian + shift */
    sp_real *dense;                     /* or, not NULL, its dense factor */
    sp_real soft, slide;                /* 1/gamma (0: no tension), 1/sqrt(tau); the exact form has 0 and 1 */
    sp_real unit, load;                 /* force of one unit [N]; norm of the weighted load */
    sp_real *mu, *S;                    /* per contact: coefficient in force, metric */
    int32_t *slot;                      /* per contact: its off-diagonal block in L; -1 - slot: transposed; INT32_MIN: none */
    sp_real *z;                         /* 6b: row weights, 0 where held */
    sp_real *weight;                    /* 2b: of force and moment rows, held or not */
    sp_real *size;                      /* 2b: sbar and Sbar of the certificate check, in units */
    sp_real *y, *r, *d;                 /* 6b: potential, gradient, step */
    sp_real *h;                         /* temporaries of the assembly */
    int32_t *xadj, *adj, *parent, *mark;/* graph of touching free blocks */
    sp_cost *cost;
} sp__dual;

#define SP__DUAL_H 96

static void sp__dual_carve_graph(sp__dual *w, const sp_problem *pb, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    w->pb = pb;
    sp__bchol_carve_pattern(&w->L, pb->blocks, a);
    w->xadj = sp__take(a, b + 1, sizeof *w->xadj);
    w->adj = sp__take(a, (size_t)pb->contacts, 2 * sizeof *w->adj);
    w->parent = sp__take(a, b, sizeof *w->parent);
    w->mark = sp__take(a, b, sizeof *w->mark);
}

static void sp__dual_carve(sp__dual *w, const sp_problem *pb, int32_t faces, int32_t nnz, int dense, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks, c = (size_t)pb->contacts;
    w->dense = dense ? sp__take(a, 3 * b, (6 * b + 1) * sizeof *w->dense) : NULL;
    sp__cone_carve(&w->cone, faces, a);
    w->mu = sp__take(a, c, sizeof *w->mu);
    w->S = sp__take(a, c, sizeof *w->S);
    w->slot = sp__take(a, c, sizeof *w->slot);
    w->z = sp__take(a, b, 6 * sizeof *w->z);
    w->weight = sp__take(a, b, 2 * sizeof *w->weight);
    w->size = sp__take(a, b, 2 * sizeof *w->size);
    w->y = sp__take(a, b, 6 * sizeof *w->y);
    w->r = sp__take(a, b, 6 * sizeof *w->r);
    w->d = sp__take(a, b, 6 * sizeof *w->d);
    w->h = sp__take(a, SP__DUAL_H, sizeof *w->h);
    sp__bchol_carve_values(&w->L, nnz, a);
}

/* Neighbours of every free block, each once. */
static void sp__dual_graph(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    const int32_t b = pb->blocks;
    for (int32_t i = 0; i <= b; i++) w->xadj[i] = 0;
    for (int32_t c = 0; c < pb->contacts; c++)
        if (pb->contact[c].a >= 0 && pb->contact[c].b >= 0) {
            w->xadj[pb->contact[c].a + 1]++;
            w->xadj[pb->contact[c].b + 1]++;
        }
    for (int32_t i = 0; i < b; i++) { w->xadj[i + 1] += w->xadj[i]; w->mark[i] = w->xadj[i]; }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int32_t i = pb->contact[c].a, k = pb->contact[c].b;
        if (i < 0 || k < 0) continue;
        w->adj[w->mark[i]++] = k;
        w->adj[w->mark[k]++] = i;
    }
    for (int32_t i = 0; i < b; i++) w->mark[i] = -1;
    int32_t to = 0, from = 0;                           /* repeated neighbours go: two joints between one pair */
    for (int32_t i = 0; i < b; i++) {
        const int32_t end = w->xadj[i + 1], start = to;
        for (; from < end; from++)
            if (w->mark[w->adj[from]] != i) { w->mark[w->adj[from]] = i; w->adj[to++] = w->adj[from]; }
        w->xadj[i] = start;
    }
    w->xadj[b] = to;
}

/* Symbolic step in `a`, whose peak then covers it.     returns blocks of L below the diagonal, -1: does not fit */
static int32_t sp__dual_analyse(sp__dual *w, const sp_problem *pb, sp_arena *a)
{
    sp__dual_carve_graph(w, pb, a);
    sp_arena rest = *a;
    sp__order order;
    sp__order_carve(&order, pb->blocks, 2 * pb->contacts, &rest);
    if (sp__failed(a) || sp__failed(&rest)) return -1;
    if (rest.peak > a->peak) a->peak = rest.peak;
    sp__dual_graph(w);
    rest.used = a->used;
    return sp__bchol_analyse(&w->L, w->xadj, w->adj, w->parent, w->mark, rest);
}

/* Bytes the symbolic step takes. */
static size_t sp__dual_scratch(const sp_problem *pb)
{
    sp__dual w;
    sp__order order;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof w);
    sp__dual_carve_graph(&w, pb, &dry);
    sp__order_carve(&order, pb->blocks, 2 * pb->contacts, &dry);
    return dry.peak;
}

/* Bytes of the whole dual: the symbolic step and the factor share the space behind the graph. */
static size_t sp__dual_need(const sp_problem *pb, const sp_settings *set, int dense, sp_arena scratch)
{
    sp__order order;
    sp__dual *w = sp__take(&scratch, 1, sizeof *w);
    const int32_t nnz = w ? sp__dual_analyse(w, pb, &scratch) : -1;
    if (nnz < 0) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *w);
    sp__dual_carve_graph(w, pb, &dry);
    sp_arena symbolic = dry;
    sp__order_carve(&order, pb->blocks, 2 * pb->contacts, &symbolic);
    sp__dual_carve(w, pb, set->faces, nnz, dense, &dry);
    return dry.peak > symbolic.peak ? dry.peak : symbolic.peak;
}

/* Row weights: 1 / sqrt(sum S) for forces, 1 / sqrt(2/3 sum S |r_v - c|^2) for moments: unit diagonal on average. */
static void sp__dual_weights(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) w->z[k] = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            sp_real o[3], *z = w->z + 6 * (size_t)i;
            const sp_real *arm = side ? t->rb : t->ra;
            o[0] = sp__dot3(arm, t->joint->n); o[1] = sp__dot3(arm, t->joint->t1); o[2] = sp__dot3(arm, t->joint->t2);
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                const sp_real *l = pb->local[v];
                const sp_real x = o[0] + l[0], y = o[1] + l[1], s = o[2] + l[2];
                z[0] += w->S[c];
                z[3] += w->S[c] * (x * x + y * y + s * s) * 2 / 3;
            }
        }
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp_real *z = w->z + 6 * (size_t)i, *f = w->weight + 2 * (size_t)i;
        f[0] = z[0] > 0 ? 1 / SP_SQRT(z[0]) : 1;
        f[1] = z[3] > 0 ? 1 / SP_SQRT(z[3]) : 1;
        for (int k = 0; k < 6; k++) z[k] = sp__held(pb, i, k) ? 0 : f[k / 3];
    }
}

/* r <- the weighted load in units. */
static void sp__dual_load(const sp__dual *w, sp_real *r)
{
    const sp_real unit = 1 / w->unit;
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) r[k] = w->z[k] * (w->pb->p[k] * unit);
}

/* load . y */
static sp_real sp__dual_work(const sp__dual *w, const sp_real *y)
{
    const sp_real unit = 1 / w->unit;
    sp_real s = 0;
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) s += w->z[k] * (w->pb->p[k] * unit) * y[k];
    return s;
}

/* V, W: velocity of B seen from A at the contact's origin and its rotation, in the contact's frame, for weighted motion y. */
static void sp__dual_twist(const sp__dual *w, const sp_contact *t, const sp_real *y, sp_real V[3], sp_real W[3])
{
    sp_real v[3] = { 0, 0, 0 }, o[3] = { 0, 0, 0 };
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *yi = y + 6 * (size_t)i, *z = w->z + 6 * (size_t)i, *arm = side ? t->rb : t->ra;
        const sp_real sign = side ? (sp_real)1 : (sp_real)-1;
        const sp_real a = z[3] * yi[3], b = z[4] * yi[4], c = z[5] * yi[5];
        v[0] += sign * (z[0] * yi[0] + b * arm[2] - c * arm[1]);
        v[1] += sign * (z[1] * yi[1] + c * arm[0] - a * arm[2]);
        v[2] += sign * (z[2] * yi[2] + a * arm[1] - b * arm[0]);
        o[0] += sign * a; o[1] += sign * b; o[2] += sign * c;
    }
    V[0] = sp__dot3(v, t->joint->n); V[1] = sp__dot3(v, t->joint->t1); V[2] = sp__dot3(v, t->joint->t2);
    W[0] = sp__dot3(o, t->joint->n); W[1] = sp__dot3(o, t->joint->t1); W[2] = sp__dot3(o, t->joint->t2);
}

/* u = V + W x l, friction weighed. */
static void sp__dual_rate(const sp__dual *w, const sp_real V[3], const sp_real W[3], const sp_real l[3], sp_real u[3])
{
    u[0] = V[0] + W[1] * l[2] - W[2] * l[1];
    u[1] = (V[1] + W[2] * l[0] - W[0] * l[2]) * w->slide;
    u[2] = (V[2] + W[0] * l[1] - W[1] * l[0]) * w->slide;
}

/* f = S (P_K(u) - (max(0, -u_n) / gamma, 0, 0)), friction unweighed. */
static void sp__dual_force(const sp__dual *w, int32_t c, const sp_real u[3], sp_real f[3])
{
    sp__cone_project(&w->cone, w->mu[c], u, f);
    if (w->soft > 0 && u[0] < 0) f[0] += u[0] * w->soft;
    f[0] *= w->S[c]; f[1] *= w->S[c] * w->slide; f[2] *= w->S[c] * w->slide;
}

/* r[i] += z (F, arm x F + M), F and M in the contact's frame about its origin, on both sides. */
static void sp__dual_scatter(const sp__dual *w, const sp_contact *t, const sp_real F[3], const sp_real M[3], sp_real *r)
{
    sp_real f[3], m[3];
    for (int k = 0; k < 3; k++) {
        f[k] = F[0] * t->joint->n[k] + F[1] * t->joint->t1[k] + F[2] * t->joint->t2[k];
        m[k] = M[0] * t->joint->n[k] + M[1] * t->joint->t1[k] + M[2] * t->joint->t2[k];
    }
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *arm = side ? t->rb : t->ra, *z = w->z + 6 * (size_t)i;
        const sp_real sign = side ? (sp_real)1 : (sp_real)-1;
        sp_real *ri = r + 6 * (size_t)i;
        ri[0] += sign * z[0] * f[0];
        ri[1] += sign * z[1] * f[1];
        ri[2] += sign * z[2] * f[2];
        ri[3] += sign * z[3] * (arm[1] * f[2] - arm[2] * f[1] + m[0]);
        ri[4] += sign * z[4] * (arm[2] * f[0] - arm[0] * f[2] + m[1]);
        ri[5] += sign * z[5] * (arm[0] * f[1] - arm[1] * f[0] + m[2]);
    }
}

#define SP__FLOPS_SWEEP 48              /* a vertex: u 15, P_K about 15, sums 18; a contact adds SP__FLOPS_TWIST */
#define SP__FLOPS_TWIST 160
#define SP__FLOPS_HESSIAN 75            /* a vertex of the assembly; a contact adds SP__FLOPS_BLOCKS */
#define SP__FLOPS_BLOCKS 900

static void sp__dual_count(sp__dual *w, int32_t vertex, int32_t contact)
{
    w->cost->flops += (int64_t)vertex * w->pb->points + (int64_t)contact * w->pb->contacts;
}

typedef enum sp__law { SP__BILATERAL, SP__ADMISSIBLE } sp__law;     /* f = S u, or f = S P_K(u) */

/* r = Aeq f(y) + p, weighted; f (may be NULL) gets the forces, 3 x points, in units. */
static void sp__dual_gradient(sp__dual *w, sp__law law, const sp_real *y, sp_real *r, sp_real *f)
{
    const sp_problem *pb = w->pb;
    sp__dual_load(w, r);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 };
        sp__dual_twist(w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real *l = pb->local[v];
            sp_real u[3], g[3];
            sp__dual_rate(w, V, W, l, u);
            if (law == SP__ADMISSIBLE) sp__dual_force(w, c, u, g);
            else for (int k = 0; k < 3; k++) g[k] = w->S[c] * (k ? w->slide * u[k] : u[k]);
            F[0] += g[0]; F[1] += g[1]; F[2] += g[2];
            M[0] += l[1] * g[2] - l[2] * g[1];
            M[1] += l[2] * g[0] - l[0] * g[2];
            M[2] += l[0] * g[1] - l[1] * g[0];
            if (f) memcpy(f + 3 * (size_t)v, g, sizeof g);
        }
        sp__dual_scatter(w, t, F, M, r);
    }
    sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST);
}

/* d/ds D(y + s d) = f(u + s du) . du + p . d. */
static sp_real sp__dual_slope(sp__dual *w, const sp_real *y, const sp_real *d, sp_real s)
{
    const sp_problem *pb = w->pb;
    sp_real sum = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], dV[3], dW[3], part = 0;
        sp__dual_twist(w, t, y, V, W);
        sp__dual_twist(w, t, d, dV, dW);
        for (int k = 0; k < 3; k++) { V[k] += s * dV[k]; W[k] += s * dW[k]; }
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3], du[3], f[3];
            sp__dual_rate(w, V, W, pb->local[v], u);
            sp__dual_rate(w, dV, dW, pb->local[v], du);
            sp__dual_force(w, c, u, f);
            part += f[0] * du[0] + (f[1] * du[1] + f[2] * du[2]) / w->slide;
        }
        sum += part;
    }
    sp__dual_count(w, SP__FLOPS_SWEEP, 2 * SP__FLOPS_TWIST);
    return sum + sp__dual_work(w, d);
}

/* h += (I, -[l]x)' D (I, -[l]x), row by row: x = l x D_i is row i of -D [l]x, and [l]x of those rows makes ww. */
static void sp__vertex_hessian(const sp_real D[6], const sp_real *l, sp_real *h)
{
    const int at[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
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

/* The contact's share H = sum (I, -[l]x)' S D (I, -[l]x) of the Hessian in its own frame: vv, vw, ww, 9 numbers each. */
static void sp__dual_contact_hessian(const sp__dual *w, sp__law law, int32_t c, const sp_real *y, sp_real *h)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real k = w->slide, S = w->S[c];
    sp_real V[3], W[3];
    sp__dual_twist(w, t, y, V, W);
    for (int q = 0; q < 27; q++) h[q] = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *l = w->pb->local[v];
        sp_real u[3], D[6] = { 1, 0, 0, 1, 0, 1 };
        if (law == SP__ADMISSIBLE) {
            sp__dual_rate(w, V, W, l, u);
            const sp__region region = sp__cone_derivative(&w->cone, w->mu[c], u, D);
            if (w->soft > 0 && u[0] < 0) D[0] += w->soft;
            else if (region == SP__APEX) continue;
        }
        D[0] *= S; D[1] *= S * k; D[2] *= S * k; D[3] *= S * k * k; D[4] *= S * k * k; D[5] *= S * k * k;
        sp__vertex_hessian(D, l, h);
    }
}

/* out = R m R', R = (n, t1, t2): from the contact's frame to the world's. out may not be m. */
static void sp__rotate(const sp_contact *t, const sp_real *m, sp_real *out)
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

/* to(r, c) += zr[r] zc[c] m(r, c), 3 x 3; to has strides tr, tc, m is by rows or, mc = 3, by columns. */
static void sp__add9(sp_real *to, int tr, int tc, const sp_real zr[3], const sp_real zc[3], const sp_real *m, int mr, int mc)
{
    for (int c = 0; c < 3; c++) {
        const sp_real z = zc[c];
        to[tc * c]          += zr[0] * z * m[mc * c];
        to[tc * c + tr]     += zr[1] * z * m[mc * c + mr];
        to[tc * c + 2 * tr] += zr[2] * z * m[mc * c + 2 * mr];
    }
}

/* Diagonal block += Z [ vv . ; vw' ww ] Z, its lower triangle by columns. */
static void sp__add_diagonal(sp_real *block, const sp_real *z, const sp_real *vv, const sp_real *vw, const sp_real *ww)
{
    sp__add9(block, 1, 6, z, z, vv, 3, 1);
    sp__add9(block + 3, 1, 6, z + 3, z, vw, 1, 3);
    sp__add9(block + 21, 1, 6, z + 3, z + 3, ww, 3, 1);
}

/* Block -= Za [ vv qb ; qa' ww ] Zb, by columns, or by rows where it is stored transposed. */
static void sp__add_coupling(sp_real *block, int turn, const sp_real *za, const sp_real *zb, const sp_real *vv,
                             const sp_real *qa, const sp_real *qb, const sp_real *ww)
{
    const int tr = turn ? 6 : 1, tc = turn ? 1 : 6;
    const sp_real minus[6] = { -za[0], -za[1], -za[2], -za[3], -za[4], -za[5] };
    sp__add9(block, tr, tc, minus, zb, vv, 3, 1);
    sp__add9(block + 3 * tc, tr, tc, minus, zb + 3, qb, 3, 1);
    sp__add9(block + 3 * tr, tr, tc, minus + 3, zb, qa, 1, 3);
    sp__add9(block + 3 * tr + 3 * tc, tr, tc, minus + 3, zb + 3, ww, 3, 1);
}

/* Aeq S DP Aeq' + shift into L: every contact's H moved to the centroids of its blocks,
 *
 *   T = [ I  -[arm]x ; 0  I ],   K_aa = Ta' H Ta,   K_bb = Tb' H Tb,   K_ab = -Ta' H Tb                                  */
static void sp__dual_assemble(sp__dual *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp_problem *pb = w->pb;
    sp_real *h = w->h, *vv = h + 27, *vw = h + 36, *ww = h + 45, *qa = h + 54, *qb = h + 63, *nb = h + 72, *k = h + 81;
    sp__bchol_zero(&w->L);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real *za = w->z + 6 * (size_t)(t->a < 0 ? 0 : t->a), *zb = w->z + 6 * (size_t)(t->b < 0 ? 0 : t->b);
        sp__dual_contact_hessian(w, law, c, y, h);
        sp__rotate(t, h, vv);
        sp__rotate(t, h + 9, vw);
        sp__rotate(t, h + 18, ww);
        if (t->a >= 0) {
            sp__cross_right(t->ra, vv, 0, vw, qa);                          /* K_vw = vw - vv [arm]x */
            sp__cross_right(t->ra, vw, 1, ww, nb);                          /* ww - vw' [arm]x */
            sp__cross_left(t->ra, qa, nb, k);                               /* K_ww */
            sp__add_diagonal(w->L.d + 36 * (size_t)w->L.inv[t->a], za, vv, qa, k);
        }
        if (t->b >= 0) {
            sp__cross_right(t->rb, vv, 0, vw, qb);
            sp__cross_right(t->rb, vw, 1, ww, nb);
            sp__cross_left(t->rb, qb, nb, k);
            sp__add_diagonal(w->L.d + 36 * (size_t)w->L.inv[t->b], zb, vv, qb, k);
        }
        if (w->slot[c] != INT32_MIN) {
            const int turn = w->slot[c] < 0;
            sp__cross_left(t->ra, qb, nb, k);
            sp__add_coupling(w->L.x + 36 * (size_t)(turn ? -1 - w->slot[c] : w->slot[c]), turn, za, zb, vv, qa, qb, k);
        }
    }
    for (size_t i = 0; i < (size_t)pb->blocks; i++)
        for (size_t q = 0; q < 6; q++) w->L.d[36 * i + 7 * q] += shift;
    sp__dual_count(w, SP__FLOPS_HESSIAN, SP__FLOPS_BLOCKS);
}

/* The assembled blocks as one dense lower triangle, in elimination order. */
static void sp__dual_spread(sp__dual *w)
{
    const sp__bchol *L = &w->L;
    const size_t n = 6 * (size_t)L->n;
    memset(w->dense, 0, n * (n + 1) / 2 * sizeof *w->dense);
    for (int32_t k = 0; k < L->n; k++)
        for (int32_t q = L->p[k] - 1; q < L->p[k + 1]; q++) {
            const int diagonal = q < L->p[k];
            const int32_t i = diagonal ? k : L->i[q];
            const sp_real *block = diagonal ? L->d + 36 * (size_t)k : L->x + 36 * (size_t)q;
            for (size_t r = 0; r < 6; r++)
                for (size_t c = 0; c < (diagonal ? r + 1 : 6); c++) {
                    const size_t row = 6 * (size_t)i + r;
                    w->dense[row * (row + 1) / 2 + 6 * (size_t)k + c] = block[6 * c + r];
                }
        }
}

/* L L' = Aeq S DP Aeq' + shift */
static void sp__dual_factor(sp__dual *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp_real floor = 4 * (sp_real)SP_EPSILON;
    const int64_t n = 6 * (int64_t)w->L.n;
    sp__dual_assemble(w, law, y, shift);
    if (w->dense) {
        sp__dual_spread(w);
        sp__chol_factor(w->dense, 6 * w->L.n, floor);
    } else sp__bchol_factor(&w->L, floor);
    w->cost->flops += w->dense ? n * n * 2 * w->L.n : w->L.flops;
    w->cost->factorisations++;
}

/* x <- (L L')^-1 b; x may be b. */
static void sp__dual_solve(sp__dual *w, const sp_real *b, sp_real *x)
{
    const int64_t n = 6 * (int64_t)w->L.n;
    w->cost->flops += w->dense ? 2 * n * n : 144 * (int64_t)w->L.p[w->L.n] + 12 * n;
    if (!w->dense) { sp__bchol_solve(&w->L, b, x); return; }
    for (size_t k = 0; k < (size_t)n; k++) w->L.t[k] = b[6 * (size_t)w->L.perm[k / 6] + k % 6];
    sp__chol_solve(w->dense, 6 * w->L.n, w->L.t);
    for (size_t k = 0; k < (size_t)n; k++) x[6 * (size_t)w->L.perm[k / 6] + k % 6] = w->L.t[k];
}

/* Weighted imbalance relative to sbar and Sbar: the largest over the blocks. */
static sp_real sp__dual_omega(const sp__dual *w, const sp_real *r)
{
    sp_real omega = 0;
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *ri = r + 6 * (size_t)i, *s = w->size + 2 * (size_t)i, *z = w->weight + 2 * (size_t)i;
        const sp_real f = sp__ratio(sp__norm3(ri), z[0] * s[0]), m = sp__ratio(sp__norm3(ri + 3), z[1] * s[1]);
        if (f > omega) omega = f;
        if (m > omega) omega = m;
    }
    return omega;
}

/* size = weighted sbar and Sbar from the bilateral force of potential y (metric 1), as the certificate check has them. */
static void sp__dual_sizes(sp__dual *w, const sp_real *y)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *p = pb->p + 6 * (size_t)i;
        w->size[2 * (size_t)i] = sp__norm3(p) / w->unit;
        w->size[2 * (size_t)i + 1] = sp__norm3(p + 3) / w->unit;
        w->d[i] = 0;                                                    /* longest arm */
    }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3];
        sp__dual_twist(w, t, y, V, W);
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real *arm = side ? t->rb : t->ra;
            const sp_real o[3] = { sp__dot3(arm, t->joint->n), sp__dot3(arm, t->joint->t1), sp__dot3(arm, t->joint->t2) };
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                const sp_real *l = pb->local[v], x[3] = { o[0] + l[0], o[1] + l[1], o[2] + l[2] };
                sp_real u[3], m[3];
                sp__dual_rate(w, V, W, l, u);
                sp__cross3(x, u, m);
                w->size[2 * (size_t)i] += sp__norm3(u);
                w->size[2 * (size_t)i + 1] += sp__norm3(m);
                w->d[i] = sp__max(w->d[i], sp__norm3(x));
            }
        }
    }
    for (size_t i = 0; i < (size_t)pb->blocks; i++)
        w->size[2 * i + 1] += 16 * (sp_real)SP_EPSILON * w->size[2 * i] * w->d[i] / w->set->tol;
    sp__dual_count(w, 2 * SP__FLOPS_SWEEP, SP__FLOPS_TWIST);
}

/* The metric S_v ~ min(sbar_A, sbar_B) of a contact, 1 where all are alike: without it a pebble beside a cathedral is lost in
 * rounding.     returns 1 when it is needed */
static int sp__dual_metric(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    sp_real least = SP__HUGE, most = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_real s = sp__lesser(&pb->contact[c], w->size, 2);
        w->S[c] = s;
        if (s < least) least = s;
        if (s > most) most = s;
    }
    const int needed = most > 1000 * least;
    for (int32_t c = 0; c < pb->contacts; c++) w->S[c] = needed ? (w->S[c] > 0 ? w->S[c] / most : 1) : 1;
    return needed;
}

typedef enum sp__form { SP__EXACT, SP__EXACT_DENSE, SP__PENALTY } sp__form;

/* A dual in `a`, everything but the numbers of a metric.     returns NULL when the arena is too small */
static sp__dual *sp__dual_open(const sp_problem *pb, const sp_settings *set, sp__form form, sp_cost *cost, sp_arena *a)
{
    const int penalty = form == SP__PENALTY;
    sp__dual *w = sp__take(a, 1, sizeof *w);
    const int32_t nnz = w ? sp__dual_analyse(w, pb, a) : -1;
    if (nnz < 0) return NULL;
    sp__dual_carve(w, pb, set->faces, nnz, form == SP__EXACT_DENSE, a);
    if (sp__failed(a)) return NULL;
    sp__bchol_pattern(&w->L, w->xadj, w->adj, w->parent, w->mark);
    w->set = set;
    w->cost = cost;
    w->soft = penalty && !set->net ? 1 / set->gamma : 0;
    w->slide = penalty ? 1 / SP_SQRT(set->tau) : 1;
    sp__cone_make(&w->cone);
    sp_real factor = 1, half;
    if (set->faces && set->inscribed) sp__pyramid_half(set->faces, &factor, &half);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        int32_t turned = 0;
        w->mu[c] = t->joint->joint.mu * factor / w->slide;
        w->S[c] = 1;
        w->slot[c] = INT32_MIN;
        if (t->a < 0 || t->b < 0) continue;
        w->slot[c] = sp__bchol_slot(&w->L, t->a, t->b, &turned);
        if (turned) w->slot[c] = -1 - w->slot[c];
    }
    w->unit = sp__load_unit(pb);
    return w;
}
