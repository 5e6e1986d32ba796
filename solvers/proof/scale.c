/* scale: the certificate check's memory, the bilateral force f0, and the sizes by which each block's imbalance is measured.
 *
 *   f0            bilateral least-squares force: least imbalance, then least norm              [solvers/README.md, what proves]
 *   sbar, Sbar    |load| + sum |f0_v|,  |couple| + sum |(r_v - c) x f0_v| + 16 u sbar max |r_v - c| / tol
 *   caps          c_v = force_bound min(sbar_A, sbar_B) over the free blocks of a contact
 *
 * The files of proof/ include nothing of a search: projection and sums are their own, in world coordinates instead of contact
 * frames. A search hands over what is to be proved and a first guess y0 of f0, which is used as far as its residual allows.
 * Both sides read the scene and its problem (scene/).
 */
#ifndef SP__PROOF_SCALE_C
#define SP__PROOF_SCALE_C

#include "../base/vectors.c"
#include "../scene/joint.c"
#include "../scene/problem.c"

#ifdef SP_REAL_FLOAT
#define SP__SCALE_NULL ((sp_real)3e-6)  /* |G r| / |r| at which no step can lower the residual r */
#else
#define SP__SCALE_NULL ((sp_real)1e-14)
#endif
#define SP__SCALE_KNOWN ((sp_real)1e-3) /* imbalance of f0, relative to a block's load, up to which it is that block's scale */

typedef struct sp__scale {
    sp_real load, couple;               /* |force|, |moment| of the load */
    sp_real sum_f0, sum_m0, arm;        /* sum |f0_v|, sum |(r_v - c) x f0_v|, max |r_v - c| */
    sp_real s, S;                       /* sbar, Sbar */
    sp_real force_cap;                  /* sbar that bounds the forces of its contacts */
    sp_real known;                      /* 1: f0 balances this block */
    sp_real wf, wm;                     /* row weights of the least-squares problem: 1 / rms of a column */
} sp__scale;

/* sp__scale holds numbers only, because sp__least_of_blocks steps through an array of them by whole numbers; i386 would align
 * a double to half of one. */
typedef char sp__scale_is_numbers[sizeof(sp__scale) % sizeof(sp_real) == 0 ? 1 : -1];

#define SP__FLOPS_CERTIFICATE 90    /* a vertex in a sweep; scales take 2 sweeps or more, forces or a triple 1, a motion 7 */

/* A certificate check at work: the scene it checks against, its scales and scratch. The certificate itself is the result. */
typedef struct sp__certifier {
    const sp_problem *pb;
    const sp_settings *set;             /* tol and force_bound resolved */
    sp_real mu_factor, tan_half;        /* mu_eff / mu; tan(pi/K) */
    sp_real (*direction)[2];            /* of the pyramid's faces */
    sp__scale *scale;                   /* b */
    union { sp_real *potential, *motion; } dual;        /* 6b: of f0, in weighted rows; the motion that is judged */
    sp_real *correction;                /* 6b: of the potential, so that f0 = Aeq' W (potential + correction) */
    sp_real *residual;                  /* 6b: Aeq f + p of f0, or of the forces that are judged */
    sp_real *step;                      /* 6b: of the least squares, whose matrix is G = W Aeq Aeq' W */
    union { sp_real *step_image, *sums; } pass;         /* 6b: G step; 2b: each block's sum |f_v|, sum |(r_v - c) x f_v| */
    sp_real *image;                     /* 6b: G residual, or of another row */
    sp_real unit;                       /* of force [N]; everything below is counted in it */
    sp_real total;                      /* sum of |load| */
    sp_real force_cap;                  /* c_v of the contact at hand */
    sp_real resist;                     /* sum c_v |P_K(u_v)| of the motion judged last */
    int32_t sweeps;                     /* passes over all contact vertices, for the work count */
    int32_t sweeps_most;                /* how many the scales may take; 0: scales of the loads alone */
} sp__certifier;

static void sp__certifier_carve(sp__certifier *j, const sp_problem *pb, int32_t faces, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    j->pb = pb;
    j->scale = sp__take(a, b, sizeof *j->scale);
    j->direction = sp__take(a, (size_t)faces, sizeof *j->direction);
    j->dual.potential = sp__take(a, b, 6 * sizeof *j->dual.potential);
    j->correction = sp__take(a, b, 6 * sizeof *j->correction);
    j->residual = sp__take(a, b, 6 * sizeof *j->residual);
    j->step = sp__take(a, b, 6 * sizeof *j->step);
    j->pass.step_image = sp__take(a, b, 6 * sizeof *j->pass.step_image);
    j->image = sp__take(a, b, 6 * sizeof *j->image);
}

SP__NOINLINE static size_t sp__certifier_need(const sp_problem *pb, const sp_settings *set)
{
    sp__certifier j;
    sp_arena dry = sp__arena_dry();
    sp__certifier_carve(&j, pb, set->faces, &dry);
    return dry.peak;
}

/* Motion of B seen from A at vertex v of a contact, v_i + w_i x (r - c_i) of each: dd of a motion dq, the rate u = -dd of
 * y = -dq. With `scale` the motion is given in weighted rows. */
static void sp__vertex_velocity(const sp_problem *pb, const sp__scale *scale, const sp_contact *t, int32_t v,
                                const sp_real *motion, sp_real u[3])
{
    u[0] = u[1] = u[2] = 0;
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->a : t->b;
        if (i < 0) continue;
        const sp_real *m = motion + 6 * (size_t)i, sign = side ? -1 : 1;
        const sp_real wf = scale ? scale[i].wf : 1, wm = scale ? scale[i].wm : 1;
        sp_real arm[3], w[3];
        sp__arm(pb, i, v, arm);
        sp__cross3(m + 3, arm, w);
        sp__scale3(wm, w, w);
        sp__add3(w, wf, m);
        sp__add3(u, sign, w);
    }
}

/* (F, (r - c) x F) added to the row of B, taken off that of A; |F| and |(r - c) x F| to both blocks' sums (may be NULL). */
static void sp__vertex_force(const sp_problem *pb, const sp_contact *t, int32_t v, const sp_real F[3], sp_real *row,
                             sp_real *sum)
{
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->a : t->b;
        if (i < 0) continue;
        sp_real arm[3], m[3], *to = row + 6 * (size_t)i;
        const sp_real sign = side ? -1 : 1;
        sp__arm(pb, i, v, arm);
        sp__cross3(arm, F, m);
        sp__add3(to, sign, F);
        sp__add3(to + 3, sign, m);
        if (sum) { sum[2 * (size_t)i] += sp__norm3(F); sum[2 * (size_t)i + 1] += sp__norm3(m); }
    }
}

/* The load of free block i in units. */
static void sp__certifier_load(const sp__certifier *j, int32_t i, sp_real p[6])
{
    sp__to_units(j->unit, 6, j->pb->p + 6 * (size_t)i, p);
}

/* residual = p, sums = 0: where balances start. */
static void sp__certifier_load_rows(sp__certifier *j)
{
    const size_t n = 6 * (size_t)j->pb->blocks;
    sp__to_units(j->unit, n, j->pb->p, j->residual);
    memset(j->pass.sums, 0, 2 * (size_t)j->pb->blocks * sizeof *j->pass.sums);
}

/* Free blocks' load sizes, longest arms, and row weights 1/sqrt(number of vertices), 1/sqrt(2/3 sum |r_v - c|^2), which do
 * not depend on units or axes. */
static void sp__certifier_row_weights(sp__certifier *j)
{
    const sp_problem *pb = j->pb;
    j->total = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        sp_real p[6];
        sp__certifier_load(j, i, p);
        s->load = sp__norm3(p);
        s->couple = sp__norm3(p + 3);
        s->sum_f0 = s->sum_m0 = s->arm = s->wf = s->wm = 0;
        j->total += s->load;
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
static void sp__certifier_scale_rows(const sp__certifier *j, sp_real *row)
{
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        sp_real *w = row + 6 * (size_t)i;
        for (int k = 0; k < 3; k++) { w[k] *= j->scale[i].wf; w[k + 3] *= j->scale[i].wm; }
        sp__drop_held(j->pb, i, w);
    }
}

/* out = W Aeq Aeq' W in; Aeq Aeq' needs no frames because a vertex's three forces are orthonormal. */
static void sp__certifier_normal_product(sp__certifier *j, const sp_real *in, sp_real *out)
{
    const sp_problem *pb = j->pb;
    memset(out, 0, 6 * (size_t)pb->blocks * sizeof *out);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3];
            sp__vertex_velocity(pb, j->scale, t, v, in, u);
            sp__vertex_force(pb, t, v, u, out, NULL);
        }
    }
    sp__certifier_scale_rows(j, out);
    j->sweeps++;
}

/* Conjugate residuals for G d = r, G = W Aeq Aeq' W semidefinite, r = j->residual (used up), p the step; `to` += d. Stops when
 * r is small, when it is as small as it can be (G r vanishes), or when neither has fallen for 100 + b/2 steps: it takes that
 * many to reach across half the structure.                                                             [Stiefel 1955] */
SP__NOINLINE static void sp__certifier_least_squares(sp__certifier *j, sp_real *to)
{
    const size_t n = 6 * (size_t)j->pb->blocks;
    sp_real *r = j->residual, *p = j->step;
    const sp_real solved = SP__SCALE_TOL * SP__SCALE_TOL, null = SP__SCALE_NULL * SP__SCALE_NULL;
    const sp_real start = sp__dot(r, r, n);
    sp__certifier_normal_product(j, r, j->image);
    memcpy(p, r, n * sizeof *p);
    memcpy(j->pass.step_image, j->image, n * sizeof *j->pass.step_image);
    sp_real rg = sp__dot(r, j->image, n), last_r = SP__HUGE, last_g = SP__HUGE;
    for (int32_t it = 0; it < 1000 + 6 * j->pb->blocks; it++) {
        const sp_real rr = sp__dot(r, r, n), gg = sp__dot(j->image, j->image, n);
        const sp_real qq = sp__dot(j->pass.step_image, j->pass.step_image, n);
        if (rr <= solved * start || gg <= null * rr || !(qq > 0) || !(rg > 0) || j->sweeps >= j->sweeps_most) return;
        if (it % (100 + j->pb->blocks / 2) == 0) {
            if (rr > (sp_real)0.9 * last_r && gg > last_g / 2) return;
            last_r = rr;
            last_g = gg;
        }
        const sp_real alpha = rg / qq;
        sp__add(to, 1, alpha, p, n);
        sp__add(r, 1, -alpha, j->pass.step_image, n);
        sp__certifier_normal_product(j, r, j->image);
        const sp_real next = sp__dot(r, j->image, n), beta = next / rg;
        sp__add(p, beta, 1, r, n);
        sp__add(j->pass.step_image, beta, 1, j->image, n);
        rg = next;
    }
}

/* Does f0 balance a block, so that it may serve as the block's scale? It does if the residual r of its rows is within a few
 * digits of the load, or within the rounding of the forces that pass through the block. */
static int sp__scale_is_balanced(const sp_real r[6], sp_real load, sp_real f0, sp_real arm)
{
    const sp_real enough = SP__SCALE_KNOWN * load + 10000 * (sp_real)SP_EPSILON * f0;
    return sp__norm3(r) <= enough && sp__norm3(r + 3) <= enough * arm;
}

/* f0 = Aeq' W (potential + correction), the two parts taken vertex by vertex, so that a pebble's share of a cathedral's
 * potential is not lost in rounding. j->residual = Aeq f0 + p; every block's sums, and whether they are its scale.
 *     returns how many blocks are not known */
static int32_t sp__certifier_sums(sp__certifier *j)
{
    const sp_problem *pb = j->pb;
    int32_t unknown = 0;
    sp__certifier_load_rows(j);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real f[3], rest[3];
            sp__vertex_velocity(pb, j->scale, t, v, j->dual.potential, f);
            sp__vertex_velocity(pb, j->scale, t, v, j->correction, rest);
            sp__add3(f, 1, rest);
            sp__vertex_force(pb, t, v, f, j->residual, j->pass.sums);
        }
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        sp__drop_held(pb, i, j->residual + 6 * (size_t)i);
        s->sum_f0 = j->pass.sums[2 * (size_t)i];
        s->sum_m0 = j->pass.sums[2 * (size_t)i + 1];
        s->known = (sp_real)sp__scale_is_balanced(j->residual + 6 * (size_t)i, s->load, s->sum_f0, s->arm);
        unknown += s->known < 1;
    }
    j->sweeps++;
    return unknown;
}

/* One of the two parts of a hint y0 = W x into `to`; entries that are not finite become 0. */
static void sp__certifier_read_hint(const sp__certifier *j, const sp_real *y0, sp_real *to)
{
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        sp_real *x = to + 6 * (size_t)i;
        for (size_t k = 0; k < 6; k++) {
            const sp_real w = k < 3 ? j->scale[i].wf : j->scale[i].wm;
            x[k] = y0 && w > 0 ? sp__in_units(j->unit, y0[6 * (size_t)i + k]) / w : 0;
            if (!sp__finite(x[k] * x[k])) x[k] = 0;
        }
        sp__drop_held(j->pb, i, x);
    }
}

/* Nothing can make r = j->residual (weighted) smaller: G r vanishes, or, at the last, is what rounding of the forces makes of
 * it, as where a block turns about an edge: 64 u |W (|p| + |f0|)|. */
static int sp__certifier_is_optimal(sp__certifier *j, int last)
{
    const size_t n = 6 * (size_t)j->pb->blocks;
    sp_real sum = 0;
    for (int32_t i = 0; SP__HAS_STRENGTH && last && i < j->pb->blocks; i++) {
        const sp__scale *s = &j->scale[i];
        const sp_real f = s->wf * (s->load + s->sum_f0), m = s->wm * (s->couple + s->sum_m0);
        sum += f * f + m * m;
    }
    sp__certifier_normal_product(j, j->residual, j->image);
    const sp_real gg = sp__dot(j->image, j->image, n);
    return gg <= SP__SCALE_NULL * SP__SCALE_NULL * sp__dot(j->residual, j->residual, n)
        || (SP__HAS_STRENGTH && last && gg <= 4096 * (sp_real)SP_EPSILON * (sp_real)SP_EPSILON * sum);
}

/* potential + correction minimises |W (Aeq f0 + p)|, and f0 has least norm among the minimisers: from the hint y0 if its
 * residual shows that it does, else solved for here and corrected twice.     returns 0 when neither settled */
static int sp__certifier_bilateral(sp__certifier *j, const sp_real *y0)
{
    const size_t n = 6 * (size_t)j->pb->blocks;
    const sp_real *correction = y0 ? y0 + n : NULL;
    for (int own = !y0; own < 2; own++) {
        sp__certifier_read_hint(j, own ? NULL : y0, j->dual.potential);
        sp__certifier_read_hint(j, own ? NULL : correction, j->correction);
        for (int round = 0; j->sweeps + 2 <= j->sweeps_most; round++) {     /* the fourth leaves by itself */
            if (!sp__certifier_sums(j)) return 1;
            sp__certifier_scale_rows(j, j->residual);
            if ((round || !own) && sp__certifier_is_optimal(j, round == 3)) return 1;
            if (!own || round == 3 || j->sweeps + 2 > j->sweeps_most) break;
            for (size_t k = 0; k < n; k++) j->residual[k] = -j->residual[k];
            sp__certifier_least_squares(j, round ? j->correction : j->dual.potential);
        }
    }
    return 0;
}

/* |couple| + m + 16 u sbar max |r_v - c| / tol. */
static sp_real sp__scale_couple(const sp__certifier *j, const sp__scale *s, sp_real m)
{
    return s->couple + m + 16 * (sp_real)SP_EPSILON * s->s * s->arm / j->set->tol;
}

/* The scales of every free block. Where f0 does not balance it (nothing does, or its share is lost in rounding) the load takes
 * the place of f0: sbar = 2 |load|, and s_i is between |load| and that. Its caps then come from load + f0 + 10000 u times all
 * loads, which rounding may hide in f0; where f0 has not converged, from a thousand times all loads, more than any bilateral
 * force. With j->sweeps_most = 0 the scales are the loads alone, f0 = 0. They are not larger than the true ones, so forces that
 * pass by them pass by those. */
static void sp__certifier_scales(sp__certifier *j, const sp_real *y0)
{
    sp__certifier_row_weights(j);
    const int settled = j->sweeps_most ? sp__certifier_bilateral(j, y0) : 1;
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        if (!j->sweeps_most) s->known = 1;
        s->force_cap = s->load + s->sum_f0;
        if (s->known < 1) {
            s->force_cap = settled ? s->force_cap + 10000 * (sp_real)SP_EPSILON * j->total : 1000 * j->total;
            s->sum_f0 = s->load;
            s->sum_m0 = s->load * s->arm;
        }
        s->s = s->load + s->sum_f0;
        s->S = sp__scale_couple(j, s, s->sum_m0);
    }
}

/* c_v, the largest force at a vertex of a contact that a proof counts with. */
static sp_real sp__certifier_force_cap(const sp__certifier *j, const sp_contact *t)
{
    return j->set->force_bound * sp__least_of_blocks(t, &j->scale->force_cap, sizeof *j->scale / sizeof j->scale->force_cap);
}

/* Strength of a vertex in units; none where the joint has none. */
static sp__vertex_limits sp__certifier_strength(const sp__certifier *j, const sp_contact *t)
{
    const sp__vertex_limits none = { 0, 0, SP__HUGE };
    if (!SP__HAS_STRENGTH || !sp__contact_strong(j->pb, t)) return none;
    sp__vertex_limits k = sp__vertex_strength(t->joint, j->pb->ignore_strength);
    k.C *= sp__in_units(j->unit, j->mu_factor);
    k.T = sp__in_units(j->unit, k.T);
    k.N = sp__ratio(k.N, j->unit);
    return k;
}

#endif /* SP__PROOF_SCALE_C */
