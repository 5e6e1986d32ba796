/* forces: imbalance of a force state, and whether a motion proves that no forces balance the loads.
 *
 *   forces    omega = max over blocks of |r_i| / s_i, |m_i| / S_i,  r = Aeq f + p,  f_v in K_v, |f_v| <= c_v
 *   motion    p . dq  -  sum c_v |P_K(u_v)|   >   tol sum (sbar_i |v_i| + Sbar_i |w_i|),   u = -Aeq' dq, dq_i = (v_i, w_i)
 *                                                                             [solvers/README.md, what proves a verdict]
 */
#ifndef SP__PROOF_FORCES_C
#define SP__PROOF_FORCES_C

#include "../cone/pyramids.c"
#include "scale.c"

/* An admissible force near f: fn kept, ft shortened onto the cone; no tension beyond strength, no more than the cap (K_v is
 * convex and holds 0, so a shortened force stays in it). out may be f. */
static void sp__certifier_make_admissible(const sp__certifier *j, const sp_contact *t, const sp_real f[3], sp_real out[3])
{
    const sp_real mu = t->joint->strength.mu * j->mu_factor;
    const int32_t faces = SP__HAS_STRENGTH ? j->set->faces : 0;
    const sp_real slip[3] = { 0, f[1], f[2] };
    sp_real most = faces ? 0 : sp__norm3(slip);         /* the largest tangential share any face sees */
    for (int32_t k = 0; k < faces; k++) {
        const sp_real *d = j->direction[k];
        const sp_real s = d[0] * f[1] + d[1] * f[2];
        if (s > most) most = s;
    }
    const sp__vertex_limits k = sp__certifier_strength(j, t);
    const sp_real fn = f[0] > k.N ? k.N : f[0] > -k.T ? f[0] : -k.T, room = sp__max(0, k.C + mu * fn);
    const sp_real share = most > room ? room / most : 1;
    out[0] = fn;
    out[1] = f[1] * share;
    out[2] = f[2] * share;
    const sp_real size = sp__norm3(out);
    if (size > j->force_cap) sp__scale3(j->force_cap / size, out, out);
}

/* Imbalance of a force state. Every force is first made admissible; the imbalance is then the largest of |r_i| / s_i
 * and |m_i| / S_i, s_i = |load| + min(sum |f_v|, sum |f0_v|), S_i likewise. `admitted` (may be NULL) gets the admissible
 * forces, 3 x points. */
SP__NOINLINE static sp_real sp__certify_forces(sp__certifier *j, const sp_real *f, sp_real *admitted)
{
    const sp_problem *pb = j->pb;
    sp__certifier_load_rows(j);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        j->force_cap = sp__certifier_force_cap(j, t);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real g[3], F[3];
            sp__to_units(j->unit, 3, f + 3 * (size_t)v, g);
            sp__certifier_make_admissible(j, t, g, g);
            sp__joint_force(t->joint, g, F);
            sp__vertex_force(pb, t, v, F, j->residual, j->pass.sums);
            if (admitted) sp__to_newtons(j->unit, 3, g, admitted + 3 * (size_t)v);
        }
    }
    j->sweeps++;
    sp_real imbalance = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp__scale *s = &j->scale[i];
        const sp_real f1 = j->pass.sums[2 * (size_t)i], m1 = j->pass.sums[2 * (size_t)i + 1];
        const sp_real si = s->load + (f1 < s->sum_f0 ? f1 : s->sum_f0);
        const sp_real Si = sp__scale_couple(j, s, m1 < s->sum_m0 ? m1 : s->sum_m0);
        sp_real *row = j->residual + 6 * (size_t)i;
        sp__drop_held(pb, i, row);
        imbalance = sp__max(imbalance, sp__max(sp__ratio(sp__norm3(row), si), sp__ratio(sp__norm3(row + 3), Si)));
    }
    return imbalance;
}

/* |P_K(u)|, the largest u.g over unit g in K. Of a pyramid it is the largest over its edges, and over the feet of u that fall
 * inside their faces. */
SP__NOINLINE static sp_real sp__certifier_cone_resistance(const sp__certifier *j, const sp_contact *t, const sp_real u[3])
{
    const sp_real mu = t->joint->strength.mu * j->mu_factor;
    const int32_t faces = SP__HAS_STRENGTH ? j->set->faces : 0;
    const sp_real z = SP_SQRT(u[1] * u[1] + u[2] * u[2]), all = SP_SQRT(u[0] * u[0] + z * z);
    if (!faces) {
        if (u[0] >= 0 && z <= mu * u[0]) return all;
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
    return u[0] >= 0 && most <= mu * u[0] ? all : best;
}

/* Largest f.u over f in K_v, |f| <= cap; K_v with strength lies between its lower rim (fn = -T, |ft| = low) and its upper one.
 *   over the hull of both rims:          max(low a - T un, high a + N un),  a = |ut|; of a pyramid the largest of
 *                                        d . ut + tan(pi/K) |d x ut| over the normals d of its faces
 *   over lower rim + cone, |f| <= cap:   low a - T un + (cap + T + low / cos(pi/K)) |P_cone(u)|            for the best d
 * Both bound it, so the lesser does. *capped: is the cap needed; stays 0, becomes 0 where the first is the lesser. */
SP__NOINLINE static sp_real sp__certifier_strength_resistance(const sp__certifier *j, const sp_contact *t, const sp_real u[3],
                                                             sp_real P, sp_real cap, int *capped)
{
    const sp_real mu = t->joint->strength.mu * j->mu_factor, secant = SP_SQRT(1 + j->tan_half * j->tan_half);
    const sp__vertex_limits k = sp__certifier_strength(j, t);
    sp_real a = j->set->faces ? 0 : SP_SQRT(u[1] * u[1] + u[2] * u[2]);
    for (int32_t q = 0; q < j->set->faces; q++) {
        const sp_real *d = j->direction[q];
        a = sp__max(a, d[0] * u[1] + d[1] * u[2] + j->tan_half * sp__abs(d[0] * u[2] - d[1] * u[1]));
    }
    const sp_real low = sp__max(0, k.C - mu * k.T), foot = low * a - k.T * u[0], top = (k.C + mu * k.N) * a + k.N * u[0];
    const sp_real shut = foot > top ? foot : top, open = foot + (cap + k.T + low * secant) * P;
    if (shut <= open) *capped = 0;
    return shut < open ? shut : open;
}

/* Longest arm of block i to a joint; where nothing touches it half its size, without a mesh 1, for it may turn. */
static sp_real sp__certifier_arm(const sp__certifier *j, int32_t i)
{
    const sp_real size = j->pb->scene->block[j->pb->block[i]].diameter / 2;
    return j->scale[i].arm > 0 ? j->scale[i].arm : size > 0 ? size : 1;
}

/* Largest displacement of a joint of block i. */
static sp_real sp__certifier_displacement(const sp__certifier *j, int32_t i)
{
    if (i < 0) return 0;
    const sp_real *m = j->dual.motion + 6 * (size_t)i;
    return sp__norm3(m) + sp__norm3(m + 3) * sp__certifier_arm(j, i);
}

/* j->dual.motion = dq in units of its largest displacement, whatever its own unit, where blocks that move less than `rest` of
 * that are held.     returns how many are; -1: nothing moves */
SP__NOINLINE static int32_t sp__certifier_hold_small(sp__certifier *j, const sp_real *dq, sp_real rest)
{
    sp_real largest = 0;
    int32_t held = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t i = 0; i < j->pb->blocks; i++) {
            sp_real *m = j->dual.motion + 6 * (size_t)i;
            for (size_t k = 0; k < 6; k++) m[k] = pass ? dq[6 * (size_t)i + k] / largest : dq[6 * (size_t)i + k];
            sp__drop_held(j->pb, i, m);
            const sp_real size = sp__certifier_displacement(j, i);
            if (!pass) largest = sp__max(largest, size);
            else if (size <= rest) { memset(m, 0, 6 * sizeof *m); held++; }
        }
        if (!(largest > 0) || !sp__finite(largest)) return -1;
    }
    return held;
}

/* Work p . x of the loads; *scale: sum (sbar_i |v_i| + Sbar_i |w_i|). */
SP__NOINLINE static sp_real sp__certifier_work(const sp__certifier *j, sp_real *scale)
{
    sp_real work = 0, p[6];
    *scale = 0;
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        const sp_real *m = j->dual.motion + 6 * (size_t)i;
        sp__certifier_load(j, i, p);
        work += sp__dot(p, m, 6);
        *scale += j->scale[i].s * sp__norm3(m) + j->scale[i].S * sp__norm3(m + 3);
    }
    return work;
}

/* Rounding of a motion and of its rates at corners [SP_EPSILON]. Whoever reads a motion that was written in the scene's units
 * allows more than who wrote it, so that what was final is. */
enum { SP__ROUNDING = 224, SP__READ = 32, SP__TOGETHER = 1 };

/* How far a motion is a proof: (p . dq - sum c_v |P_K(u_v)|) / sum (sbar_i |v_i| + Sbar_i |w_i|), u = -Aeq' dq, where blocks
 * that move less than `rest` of the largest motion are held. A value above tol proves that no force state of this cone within
 * its caps comes nearer to equilibrium than that value. *final: no contact resists at all, but for so much rounding.
 * The held motion is left in j->dual.motion. */
SP__NOINLINE static sp_real sp__certify_motion(sp__certifier *j, const sp_real *dq, sp_real rest, int how, int32_t *final)
{
    const sp_problem *pb = j->pb;
    *final = 0;
    j->resist = 0;
    if (sp__certifier_hold_small(j, dq, rest) < 0) return 0;
    sp_real scale, resist = 0;
    const sp_real work = sp__certifier_work(j, &scale);
    *final = 1;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real cap = sp__certifier_force_cap(j, t);
        const sp_real moved = sp__certifier_displacement(j, t->a) + sp__certifier_displacement(j, t->b);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3];
            sp__vertex_velocity(pb, NULL, t, v, j->dual.motion, u);
            sp__joint_frame(t->joint, u, u);
            sp__scale3(-1, u, u);
            const sp_real P = sp__certifier_cone_resistance(j, t, u);
            int capped = P > (sp_real)(SP__ROUNDING + (how & SP__READ)) * (sp_real)SP_EPSILON * moved;
            if (!SP__HAS_STRENGTH || !sp__contact_strong(pb, t)) resist += cap * P;
            else resist += sp__certifier_strength_resistance(j, t, u, P, cap, &capped);
            if (capped) *final = 0;
        }
    }
    j->sweeps++;
    j->resist = resist;
    if (SP__HAS_STRENGTH && j->set->faces && j->set->inscribed) *final = 0;
    return work > resist ? sp__ratio(work - resist, scale) : 0;
}

/* Shares of the largest motion below which blocks are held. */
static const sp_real sp__certify_rest[6] = { 0, (sp_real)1e-12, (sp_real)1e-9, (sp_real)1e-6, (sp_real)1e-3, (sp_real)0.5 };

/* What a motion proves: 3 and 2, final or not, by more than tol; 1, final by more than rounding, for where no contact resists
 * no tol is needed. SP_SMALL asks for it. */
SP__NOINLINE static int32_t sp__certify_rank(const sp__certifier *j, sp_real value, int32_t final)
{
    if (value > j->set->tol) return 2 + final;
    return SP__WITH_LARGE && final && value > (4096 + (sp_real)j->pb->blocks) * (sp_real)SP_EPSILON;
}

/* The best proof a motion gives, a final one before others, with smaller motions held. It is left in j->dual.motion.
 *   how      SP__READ: the motion was read; SP__TOGETHER: of several islands, each held so by itself: none is dropped unless
 *            what is left proves more than all
 *   *final: no contact resists, and it proves UNSTABLE, be its value within tol or not */
static sp_real sp__certify_mechanism(sp__certifier *j, const sp_real *dq, int how, int32_t *final)
{
    sp_real best = -1, value = -1;
    int32_t rank = -1, last = 0, before = -2, held = 0;
    for (int k = 0; k < 6; k++) {
        const int32_t still = sp__certifier_hold_small(j, dq, sp__certify_rest[k]);
        if (still == before) continue;                  /* the same motion */
        before = still;
        value = sp__certify_motion(j, dq, sp__certify_rest[k], how, final);
        const int32_t now = sp__certify_rank(j, value, *final);
        last = now > rank || (now == rank && value > best && !(how & SP__TOGETHER));
        if (last) { best = value; held = k; rank = now; }
    }
    if (!last) value = sp__certify_motion(j, dq, sp__certify_rest[held], how, final);
    *final = rank & 1;
    return value;
}

/* Units, friction cone and its directions. */
static void sp__certifier_cone(sp__certifier *j, const sp_problem *pb, const sp_settings *set)
{
    j->unit = sp__load_unit(pb);
    j->set = set;
    j->mu_factor = 1;
    j->tan_half = 0;
    j->sweeps = 0;
    if (!SP__HAS_STRENGTH || !set->faces) return;
    sp_real c;
    sp__pyramid_half(set->faces, &c, &j->tan_half);
    if (set->inscribed) j->mu_factor = c;
    for (int32_t k = 0; k < set->faces; k++) sp__pyramid_direction(set->faces, k, j->direction[k]);
}

/* Begin a certificate check whose arrays are carved: find the scales in at most so many sweeps, 2 or more; 0: least scales. */
static void sp__certifier_begin(sp__certifier *j, const sp_problem *pb, const sp_settings *set, const sp_real *y0,
                                int32_t most)
{
    sp__certifier_cone(j, pb, set);
    j->sweeps_most = most;
    sp__certifier_scales(j, y0);
}

/* The same, carved in `a`.     returns 0 when the arena is too small */
SP__NOINLINE static int sp__certifier_open(sp__certifier *j, const sp_problem *pb, const sp_settings *set, const sp_real *y0,
                                           int32_t most, sp_arena *a)
{
    sp__certifier_carve(j, pb, set->faces, a);
    if (sp__failed(a)) return 0;
    sp__certifier_begin(j, pb, set, y0, most);
    return 1;
}

#ifndef SP_SMALL
/* How many sweeps the certificate check may take to find the scales, out of a budget of flops: 2 at least, though a stage spent
 * more than it was left, for with fewer there are no scales that a motion could be judged by. */
static int32_t sp__budget_sweeps(const sp_settings *set, const sp_problem *pb, int64_t flops)
{
    if (set->budget <= 0 || pb->points == 0) return INT32_MAX;
    const int64_t sweeps = flops / (SP__FLOPS_CERTIFICATE * (int64_t)pb->points) - 8;
    return sweeps < 2 ? 2 : sweeps < INT32_MAX ? (int32_t)sweeps : INT32_MAX;
}
#endif

/* The motion that was checked, into a result at the scene's numbers, scaled so that no point of a block moves farther than the
 * largest block reaches; dq of other blocks stays as it is. */
static void sp__motion_write(const sp__certifier *j, sp_real *dq)
{
    const sp_problem *pb = j->pb;
    sp_real largest = 0, block = 0, lone = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *m = j->dual.motion + 6 * (size_t)i;
        block = sp__max(block, j->scale[i].arm);
        lone = sp__max(lone, sp__certifier_arm(j, i));
        largest = sp__max(largest, sp__max(sp__norm3(m), sp__norm3(m + 3) * sp__certifier_arm(j, i)));
    }
    const sp_real scale = largest > 0 ? (block > 0 ? block : lone) / largest : 0;
    for (int32_t i = 0; i < pb->blocks; i++)
        for (size_t k = 0; k < 6; k++) dq[6 * (size_t)pb->block[i] + k] = scale * j->dual.motion[6 * (size_t)i + k];
}

/* The motion of the problem's free blocks, from that of all blocks in a result. */
static void sp__motion_read(const sp_problem *pb, const sp_real *all, sp_real *dq)
{
    for (int32_t i = 0; i < pb->blocks; i++) memcpy(dq + 6 * (size_t)i, all + 6 * (size_t)pb->block[i], 6 * sizeof *dq);
}

#endif /* SP__PROOF_FORCES_C */
