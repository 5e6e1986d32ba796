/* 5 -------------------------------------------------------------------------------------------------- certificate check
 *
 * What a force state or a motion proves, from the scene alone. Nothing here is used by the search, nothing of the search here:
 * own projection, own sums, world coordinates instead of contact frames.                                   [DESIGN 3]
 *
 *   f0            bilateral least-squares force: least imbalance, then least norm
 *   sbar, Sbar    |load| + sum |f0_v|,  |couple| + sum |(r_v - c) x f0_v| + 16 u sbar max |r_v - c| / tol
 *   caps          c_v = force_bound min(sbar_A, sbar_B) over the free blocks of a contact
 */
#ifdef SP_REAL_FLOAT
#define SP__SCALE_TOL ((sp_real)1e-4)   /* f0 is a scale: this many digits of it */
#else
#define SP__SCALE_TOL ((sp_real)1e-9)
#endif
#define SP__HUGE ((sp_real)1e30)        /* stands for a ratio with nothing below the line */

typedef struct sp__scale {
    sp_real load, couple;               /* |force|, |moment| of the load */
    sp_real f0, m0, arm;                /* sum |f0_v|, sum |(r_v - c) x f0_v|, max |r_v - c| */
    sp_real s, S;                       /* sbar, Sbar */
    sp_real wf, wm;                     /* row weights of the least-squares problem: 1 / rms of a column */
} sp__scale;

typedef struct sp__judge {
    const sp_problem *pb;
    const sp_settings *set;             /* tol and force_bound resolved */
    sp_real mu_factor, tan_half;        /* mu_eff / mu; tan(pi/K) */
    sp_real (*direction)[2];            /* of the pyramid's faces */
    sp__scale *scale;                   /* b */
    sp_real *x, *r, *p, *q, *g;         /* 6b each: solution, residual, direction, G p, G r */
    sp_real unit;                       /* of force [N]; everything below is counted in it */
    sp_real cap;                        /* of the contact at hand */
    int32_t sweeps;                     /* passes over all contact vertices, for the work count */
} sp__judge;

static void sp__judge_carve(sp__judge *j, const sp_problem *pb, int32_t faces, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    j->pb = pb;
    j->scale = sp__take(a, b, sizeof *j->scale);
    j->direction = sp__take(a, (size_t)faces, sizeof *j->direction);
    j->x = sp__take(a, b, 6 * sizeof *j->x);
    j->r = sp__take(a, b, 6 * sizeof *j->r);
    j->p = sp__take(a, b, 6 * sizeof *j->p);
    j->q = sp__take(a, b, 6 * sizeof *j->q);
    j->g = sp__take(a, b, 6 * sizeof *j->g);
}

/* a / b for a, b >= 0; 0 / 0 is 0; SP__HUGE for what is larger or no number. */
static sp_real sp__ratio(sp_real a, sp_real b)
{
    if (a <= 0 && a >= 0) return 0;
    return a < SP__HUGE * b ? a / b : SP__HUGE;
}

/* A unit of force in which no square over- or underflows: the largest component of a load, of a couple where there are none. */
static sp_real sp__load_unit(const sp_problem *pb)
{
    sp_real force = 0, couple = 0;
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) {
        const sp_real x = sp__abs(pb->p[k]);
        if (k % 6 < 3) force = sp__max(force, x);
        else couple = sp__max(couple, x);
    }
    return force > 0 ? force : couple > 0 ? couple : 1;
}

/* sbar of the free blocks of a contact, the smaller. */
static sp_real sp__lesser(const sp_contact *t, const sp_real *s, size_t stride)
{
    if (t->a < 0) return s[stride * (size_t)t->b];
    if (t->b < 0) return s[stride * (size_t)t->a];
    const sp_real a = s[stride * (size_t)t->a], b = s[stride * (size_t)t->b];
    return a < b ? a : b;
}

/* The directions in which free block i is held do not count. */
static int sp__held(const sp_problem *pb, int32_t i, int k)
{
    return (int)(pb->scene->block[pb->block[i]].fixed >> k & 1u);
}

static void sp__release(const sp_problem *pb, int32_t i, sp_real row[6])
{
    for (int k = 0; k < 6; k++) if (sp__held(pb, i, k)) row[k] = 0;
}

/* r_v - c_i for a free block i, zero for a support. */
static void sp__arm(const sp_problem *pb, int32_t i, int32_t v, sp_real arm[3])
{
    arm[0] = arm[1] = arm[2] = 0;
    if (i >= 0) sp__sub3(pb->scene->point[v], pb->scene->block[pb->block[i]].centroid, arm);
}

/* Velocity of the material point of block i at vertex v: v_i + w_i x (r - c_i), times `sign`, added to u. With `scale` the
 * motion is given in weighted rows. */
static void sp__point_velocity(const sp_problem *pb, const sp__scale *scale, int32_t i, int32_t v, const sp_real *motion,
                               sp_real sign, sp_real u[3])
{
    if (i < 0) return;
    const sp_real *m = motion + 6 * (size_t)i;
    const sp_real wf = scale ? scale[i].wf : 1, wm = scale ? scale[i].wm : 1;
    sp_real arm[3], w[3];
    sp__arm(pb, i, v, arm);
    sp__cross3(m + 3, arm, w);
    for (int k = 0; k < 3; k++) u[k] += sign * (wf * m[k] + wm * w[k]);
}

/* sign (F, (r - c) x F) added to the row of block i; |F| and |(r - c) x F| to sums (may be NULL). */
static void sp__point_force(const sp_problem *pb, int32_t i, int32_t v, const sp_real F[3], sp_real sign, sp_real *row,
                            sp_real *sum)
{
    if (i < 0) return;
    sp_real arm[3], m[3];
    sp__arm(pb, i, v, arm);
    sp__cross3(arm, F, m);
    for (size_t k = 0; k < 3; k++) {
        row[6 * (size_t)i + k] += sign * F[k];
        row[6 * (size_t)i + 3 + k] += sign * m[k];
    }
    if (sum) { sum[2 * (size_t)i] += sp__norm3(F); sum[2 * (size_t)i + 1] += sp__norm3(m); }
}

/* The load of free block i in units. */
static void sp__judge_load(const sp__judge *j, int32_t i, sp_real p[6])
{
    for (size_t k = 0; k < 6; k++) p[k] = j->pb->p[6 * (size_t)i + k] / j->unit;
}

/* Free blocks' load sizes, longest arms, and row weights 1/sqrt(number of vertices), 1/sqrt(2/3 sum |r_v - c|^2), which do
 * not depend on units or axes. */
static void sp__judge_weights(sp__judge *j)
{
    const sp_problem *pb = j->pb;
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        sp_real p[6];
        sp__judge_load(j, i, p);
        s->load = sp__norm3(p);
        s->couple = sp__norm3(p + 3);
        s->f0 = s->m0 = s->arm = s->wf = s->wm = 0;
    }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++)
            for (int side = 0; side < 2; side++) {
                const int32_t i = side ? t->b : t->a;
                if (i < 0) continue;
                sp__scale *s = &j->scale[i];
                sp_real arm[3];
                sp__arm(pb, i, v, arm);
                const sp_real l = sp__norm3(arm);
                if (l > s->arm) s->arm = l;
                s->wf += 1;
                s->wm += l * l * 2 / 3;
            }
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        s->wf = s->wf > 0 ? 1 / SP_SQRT(s->wf) : 0;
        s->wm = s->wm > 0 ? 1 / SP_SQRT(s->wm) : 0;
    }
}

/* row <- W row, held rows to zero. */
static void sp__judge_weigh(const sp__judge *j, sp_real *row)
{
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        sp_real *w = row + 6 * (size_t)i;
        for (int k = 0; k < 3; k++) { w[k] *= j->scale[i].wf; w[k + 3] *= j->scale[i].wm; }
        sp__release(j->pb, i, w);
    }
}

/* out = W Aeq Aeq' W in; Aeq Aeq' needs no frames because a vertex's three forces are orthonormal. */
static void sp__judge_normal(sp__judge *j, const sp_real *in, sp_real *out)
{
    const sp_problem *pb = j->pb;
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) out[k] = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3] = { 0, 0, 0 };
            sp__point_velocity(pb, j->scale, t->b, v, in, 1, u);
            sp__point_velocity(pb, j->scale, t->a, v, in, -1, u);
            sp__point_force(pb, t->b, v, u, 1, out, NULL);
            sp__point_force(pb, t->a, v, u, -1, out, NULL);
        }
    }
    sp__judge_weigh(j, out);
    j->sweeps++;
}

static sp_real sp__dot(const sp_real *a, const sp_real *b, size_t n)
{
    sp_real s = 0;
    for (size_t k = 0; k < n; k++) s += a[k] * b[k];
    return s;
}

/* Conjugate residuals for G x = -W p, G = W Aeq Aeq' W semidefinite: x minimises |W (Aeq f0 + p)| and f0 = Aeq' W x has least
 * norm among the minimisers. Starts from the hint y0 = W x, which it only believes as far as the residual does.
 *   returns 1 when G x + W p is small, or as small as it can be (G times it vanishes), within SP__SCALE_TOL    [Stiefel 1955] */
static int sp__judge_bilateral(sp__judge *j, const sp_real *y0)
{
    const sp_problem *pb = j->pb;
    const size_t n = 6 * (size_t)pb->blocks;
    for (size_t k = 0; k < n; k++) {
        const sp__scale *s = &j->scale[k / 6];
        const sp_real w = k % 6 < 3 ? s->wf : s->wm;
        j->x[k] = y0 && w > 0 ? y0[k] / j->unit / w : 0;
        if (!sp__finite(j->x[k] * j->x[k])) j->x[k] = 0;
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__release(pb, i, j->x + 6 * (size_t)i);
        sp__judge_load(j, i, j->p + 6 * (size_t)i);
    }
    sp__judge_weigh(j, j->p);
    const sp_real load = sp__dot(j->p, j->p, n);
    sp__judge_normal(j, j->x, j->r);
    for (size_t k = 0; k < n; k++) { j->r[k] = -j->r[k] - j->p[k]; j->p[k] = j->r[k]; }
    sp__judge_normal(j, j->r, j->g);
    for (size_t k = 0; k < n; k++) j->q[k] = j->g[k];
    sp_real rg = sp__dot(j->r, j->g, n);
    const sp_real small = SP__SCALE_TOL * SP__SCALE_TOL;
    for (int32_t it = 0; ; it++) {
        const sp_real rr = sp__dot(j->r, j->r, n), gg = sp__dot(j->g, j->g, n), qq = sp__dot(j->q, j->q, n);
        if (rr <= small * load || gg <= small * small * rr) return 1;
        if (it >= 1000 + pb->blocks * 6 || !(qq > 0) || !(rg > 0)) return 0;
        const sp_real alpha = rg / qq;
        for (size_t k = 0; k < n; k++) { j->x[k] += alpha * j->p[k]; j->r[k] -= alpha * j->q[k]; }
        sp__judge_normal(j, j->r, j->g);
        const sp_real next = sp__dot(j->r, j->g, n), beta = next / rg;
        for (size_t k = 0; k < n; k++) { j->p[k] = j->r[k] + beta * j->p[k]; j->q[k] = j->g[k] + beta * j->q[k]; }
        rg = next;
    }
}

/* The scales of every free block.     returns 0 when f0 could not be settled */
static int sp__judge_scales(sp__judge *j, const sp_real *y0)
{
    const sp_problem *pb = j->pb;
    sp__judge_weights(j);
    const int settled = sp__judge_bilateral(j, y0);
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) j->r[k] = j->q[k] = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real f[3] = { 0, 0, 0 };
            sp__point_velocity(pb, j->scale, t->b, v, j->x, 1, f);
            sp__point_velocity(pb, j->scale, t->a, v, j->x, -1, f);
            sp__point_force(pb, t->b, v, f, 1, j->r, j->q);
            sp__point_force(pb, t->a, v, f, -1, j->r, j->q);
        }
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        s->f0 = j->q[2 * (size_t)i];
        s->m0 = j->q[2 * (size_t)i + 1];
        s->s = s->load + s->f0;
        s->S = s->couple + s->m0 + 16 * (sp_real)SP_EPSILON * s->s * s->arm / j->set->tol;
    }
    j->sweeps++;
    return settled;
}

/* c_v of the vertices of a contact. */
static sp_real sp__judge_cap(const sp__judge *j, const sp_contact *t)
{
    return j->set->force_bound * sp__lesser(t, &j->scale->s, sizeof *j->scale / sizeof j->scale->s);
}

/* An admissible force near f: fn kept, ft shortened onto the cone; no tension, no more than the cap. out may be f. */
static void sp__judge_admit(const sp__judge *j, const sp_contact *t, const sp_real f[3], sp_real out[3])
{
    const sp_real mu = t->joint->joint.mu * j->mu_factor;
    const int32_t faces = j->set->faces;
    const sp_real slip[3] = { 0, f[1], f[2] };
    sp_real most = faces ? 0 : sp__norm3(slip);         /* the largest tangential share any face sees */
    for (int32_t k = 0; k < faces; k++) {
        const sp_real *d = j->direction[k];
        const sp_real s = d[0] * f[1] + d[1] * f[2];
        if (s > most) most = s;
    }
    const sp_real fn = f[0] > 0 ? f[0] : 0, room = mu * fn;
    const sp_real share = most > room ? room / most : 1;
    out[0] = fn;
    out[1] = f[1] * share;
    out[2] = f[2] * share;
    const sp_real size = sp__norm3(out);
    if (size > j->cap) sp__scale3(j->cap / size, out, out);
}

/* omega of a force state: admitted, then the largest of |r_i| / s_i and |m_i| / S_i, s_i = |load| + min(sum |f_v|, sum |f0_v|),
 * S_i likewise. `admitted` (may be NULL) gets the forces that were judged, 3 x points. */
static sp_real sp__judge_forces(sp__judge *j, const sp_real *f, sp_real *admitted)
{
    const sp_problem *pb = j->pb;
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__judge_load(j, i, j->r + 6 * (size_t)i);
        memset(j->q + 6 * (size_t)i, 0, 6 * sizeof *j->q);
    }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        j->cap = sp__judge_cap(j, t);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real g[3], F[3];
            sp__scale3(1 / j->unit, f + 3 * (size_t)v, g);
            sp__judge_admit(j, t, g, g);
            for (int k = 0; k < 3; k++) F[k] = g[0] * t->joint->n[k] + g[1] * t->joint->t1[k] + g[2] * t->joint->t2[k];
            sp__point_force(pb, t->b, v, F, 1, j->r, j->q);
            sp__point_force(pb, t->a, v, F, -1, j->r, j->q);
            if (admitted) sp__scale3(j->unit, g, admitted + 3 * (size_t)v);
        }
    }
    j->sweeps++;
    sp_real omega = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp__scale *s = &j->scale[i];
        const sp_real f1 = j->q[2 * (size_t)i], m1 = j->q[2 * (size_t)i + 1];
        const sp_real si = s->load + (f1 < s->f0 ? f1 : s->f0);
        const sp_real Si = s->couple + (m1 < s->m0 ? m1 : s->m0) + 16 * (sp_real)SP_EPSILON * s->s * s->arm / j->set->tol;
        sp_real *row = j->r + 6 * (size_t)i;
        sp__release(pb, i, row);
        const sp_real a = sp__ratio(sp__norm3(row), si), b = sp__ratio(sp__norm3(row + 3), Si);
        if (a > omega) omega = a;
        if (b > omega) omega = b;
    }
    return omega;
}

/* |P_K(u)| = largest u.g over unit g in K: over the foot on each face that falls inside it, and over each edge. */
static sp_real sp__judge_resist(const sp__judge *j, const sp_contact *t, const sp_real u[3])
{
    const sp_real mu = t->joint->joint.mu * j->mu_factor;
    const int32_t faces = j->set->faces;
    const sp_real z = SP_SQRT(u[1] * u[1] + u[2] * u[2]), all = SP_SQRT(u[0] * u[0] + z * z);
    if (!faces) {
        if (z <= mu * u[0]) return all;
        const sp_real along = (u[0] + mu * z) / SP_SQRT(1 + mu * mu);
        return along > 0 ? along : 0;
    }
    const sp_real edge = mu * j->tan_half;              /* half the width of a face at fn = 1 */
    sp_real best = 0, most = 0;
    for (int32_t k = 0; k < faces; k++) {
        const sp_real *d = j->direction[k];
        const sp_real a = d[0] * u[1] + d[1] * u[2], b = d[0] * u[2] - d[1] * u[1];
        if (a > most) most = a;
        const sp_real fn = (u[0] + mu * a) / (1 + mu * mu), width = b < 0 ? -b : b;
        if (fn > 0 && width <= edge * fn) {
            const sp_real foot = SP_SQRT(fn * fn * (1 + mu * mu) + b * b);
            if (foot > best) best = foot;
        }
        const sp_real e = (u[0] + mu * a + edge * b) / SP_SQRT(1 + mu * mu + edge * edge);
        if (e > best) best = e;
    }
    return most <= mu * u[0] ? all : best;
}

/* How far a motion is a proof: (p . dq - sum c_v |P_K(u_v)|) / sum (sbar_i |v_i| + Sbar_i |w_i|), u = -Aeq' dq, where blocks
 * that move less than `rest` of the largest motion are held. A value above tol proves that no force state of this cone within
 * its caps comes nearer to equilibrium than that value. *final: no contact resists at all.
 * The held motion is left in j->x. */
static sp_real sp__judge_motion(sp__judge *j, const sp_real *dq, sp_real rest, int32_t *final)
{
    const sp_problem *pb = j->pb;
    sp_real largest = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t i = 0; i < pb->blocks; i++) {
            sp_real *m = j->x + 6 * (size_t)i;
            memcpy(m, dq + 6 * (size_t)i, 6 * sizeof *m);
            sp__release(pb, i, m);
            const sp_real size = sp__norm3(m) + sp__norm3(m + 3) * j->scale[i].arm;
            if (!pass && size > largest) largest = size;
            if (pass && size <= rest * largest) memset(m, 0, 6 * sizeof *m);
        }
    sp_real work = 0, scale = 0, resist = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *m = j->x + 6 * (size_t)i;
        sp_real p[6];
        sp__judge_load(j, i, p);
        work += sp__dot(p, m, 6);
        scale += j->scale[i].s * sp__norm3(m) + j->scale[i].S * sp__norm3(m + 3);
    }
    *final = 1;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real cap = sp__judge_cap(j, t);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real w[3] = { 0, 0, 0 }, a[3] = { 0, 0, 0 };
            sp__point_velocity(pb, NULL, t->b, v, j->x, -1, w);
            sp__point_velocity(pb, NULL, t->a, v, j->x, -1, a);
            const sp_real moved = sp__norm3(w) + sp__norm3(a);
            for (int k = 0; k < 3; k++) w[k] -= a[k];
            const sp_real u[3] = { sp__dot3(w, t->joint->n), sp__dot3(w, t->joint->t1), sp__dot3(w, t->joint->t2) };
            const sp_real P = sp__judge_resist(j, t, u);
            resist += cap * P;
            if (P > 64 * (sp_real)SP_EPSILON * moved) *final = 0;       /* below that: rounding of u */
        }
    }
    j->sweeps++;
    if (j->set->faces && j->set->inscribed) *final = 0;
    return work > resist ? sp__ratio(work - resist, scale) : 0;
}

/* The best proof a motion gives, with smaller motions held at 1e-12, 1e-9, 1e-6, 1e-3, 0.5 of the largest. The motion that
 * gives it is left in j->x. Stops at the first that is a proof by a wide margin. */
static sp_real sp__judge_mechanism(sp__judge *j, const sp_real *dq, int32_t *final)
{
    static const sp_real rest[6] = { 0, (sp_real)1e-12, (sp_real)1e-9, (sp_real)1e-6, (sp_real)1e-3, (sp_real)0.5 };
    sp_real best = -1, held = 0;
    for (int k = 0; k < 6; k++) {
        const sp_real value = sp__judge_motion(j, dq, rest[k], final);
        if (value > best) { best = value; held = rest[k]; }
        if (*final && value > j->set->tol) return value;
    }
    return sp__judge_motion(j, dq, held, final);
}

/* Set up a judge in `a` and find the scales.     returns 0 when they could not be settled */
static int sp__judge_open(sp__judge *j, const sp_problem *pb, const sp_settings *set, const sp_real *y0, sp_arena *a)
{
    sp__judge_carve(j, pb, set->faces, a);
    if (sp__failed(a)) return 0;
    j->unit = sp__load_unit(pb);
    j->set = set;
    j->mu_factor = 1;
    j->tan_half = 0;
    j->sweeps = 0;
    if (set->faces) {
        sp_real c;
        sp__pyramid_half(set->faces, &c, &j->tan_half);
        if (set->inscribed) j->mu_factor = c;
        for (int32_t k = 0; k < set->faces; k++) sp__pyramid_direction(set->faces, k, j->direction[k]);
    }
    return sp__judge_scales(j, y0);
}
