/* moving: two answers to whether friction, whatever it does, holds a scene that admissible forces can hold, judged.
 *
 *   at rest    M a = p + Aeq f,  0 <= fn, dn >= 0, fn dn = 0,  |ft| <= mu fn,  dt != 0 => ft = -mu fn dt / |dt|,  d = Aeq' a
 *   moving     a pair (f, a) that meets all of that, a != 0: nothing but its history keeps the scene from going that way
 *   pressure   forces with ft = 0 that balance, p = -Aeq fn0: then p . a = -fn0 . dn <= 0, and p . a = a'Ma + sum mu fn |dt|,
 *              so a = 0 for every mu, every mass and wherever in the joints the pressure is
 */
#ifndef SP__PROOF_MOVING_C
#define SP__PROOF_MOVING_C

#include "../scene/inertia.c"
#include "forces.c"

#if SP__WITH_STRONG || SP__WITH_SLIDING

#define SP__MOVES ((sp_real)1e-3)       /* acceleration of a block, in all its forces / mass, from which on it moves */

/* Imbalance of the normal parts of f alone, tension and friction left out; `pressure` gets these, 3 x points. */
static sp_real sp__certify_pressure(sp__certifier *j, const sp_real *f, sp_real *pressure)
{
    for (size_t v = 0; v < (size_t)j->pb->points; v++) {
        pressure[3 * v] = sp__max(0, f[3 * v]);
        pressure[3 * v + 1] = pressure[3 * v + 2] = 0;
    }
    return sp__certify_forces(j, pressure, pressure);
}

/* |a| and |alpha| arm of block i, 0 of a support: the largest acceleration of a joint of it. */
static sp_real sp__moving_size(const sp__certifier *j, int32_t i, const sp_real *a)
{
    return i < 0 ? 0 : sp__norm3(a + 6 * (size_t)i) + sp__norm3(a + 6 * (size_t)i + 3) * j->scale[i].arm;
}

/* Violation at a corner: its gap, pressure on what opens. s: the lesser sum of forces of the two blocks, `moved` the largest
 * acceleration. */
static sp_real sp__moving_gap(const sp_real f[3], const sp_real d[3], sp_real s, sp_real moved)
{
    const sp_real press = sp__ratio(f[0], s), open = sp__ratio(sp__max(0, d[0]), moved);
    return sp__max(sp__ratio(sp__max(0, -d[0]), moved), press < open ? press : open);
}

/* Friction that is not against the slip. */
static sp_real sp__moving_rub(const sp_real f[3], const sp_real d[3], sp_real mu, sp_real s, sp_real moved)
{
    const sp_real slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
    const sp_real rub[3] = { 0, f[1] * slip + mu * f[0] * d[1], f[2] * slip + mu * f[0] * d[2] };
    return sp__ratio(sp__norm3(rub), s * moved);
}

/* The admissible force of corner v, and the motion of its joint there, both in the frame of the joint. */
static void sp__moving_read(const sp__certifier *j, const sp_contact *t, int32_t v, const sp_real *f, const sp_real *a,
                            sp_real g[3], sp_real d[3])
{
    sp__to_units(j->unit, 3, f + 3 * (size_t)v, g);
    sp__certifier_make_admissible(j, t, g, g);
    sp__vertex_velocity(j->pb, NULL, t, v, a, d);
    sp__joint_frame(t->joint, d, d);
}

/* Violation of a joint whose friction is one force F at the centre of its pressure N, against the slip w there, corners
 * sharing F as they share N:  N w = sum fn d,  F |w| = -mu N w,  ft = F fn / N. Pressure that gathers there meets the laws. */
static sp_real sp__moving_gathered(const sp__certifier *j, const sp_contact *t, const sp_real *f, const sp_real *a, sp_real s,
                                   sp_real moved)
{
    sp_real F[3] = { 0, 0, 0 }, w[3] = { 0, 0, 0 }, g[3], d[3], uneven = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp__moving_read(j, t, v, f, a, g, d);
        sp__add3(F, 1, g);
        sp__add3(w, g[0], d);
    }
    if (!(F[0] > 0)) return 0;
    for (int k = 0; k < 3; k++) w[k] /= F[0];
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp__moving_read(j, t, v, f, a, g, d);
        sp__add3(g, -g[0] / F[0], F);
        uneven += sp__norm3(g);
    }
    return sp__max(sp__moving_rub(F, w, t->joint->strength.mu * j->mu_factor, s, moved), sp__ratio(uneven, s));
}

/* Violation of a joint's laws. plates: friction may be one force at the centre of its pressure instead. */
static sp_real sp__moving_joint(sp__certifier *j, const sp_contact *t, const sp_real *f, const sp_real *a, int plates)
{
    const sp_real moved = sp__moving_size(j, t->a, a) + sp__moving_size(j, t->b, a);
    const sp_real s = sp__least_of_blocks(t, j->pass.sums, 2);
    sp_real gap = 0, rub = 0;
    j->force_cap = sp__certifier_force_cap(j, t);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp_real g[3], d[3];
        sp__moving_read(j, t, v, f, a, g, d);
        gap = sp__max(gap, sp__moving_gap(g, d, s, moved));
        rub = sp__max(rub, sp__moving_rub(g, d, t->joint->strength.mu * j->mu_factor, s, moved));
    }
    if (plates && t->points > 1 && rub > j->set->tol) {
        const sp_real gathered = sp__moving_gathered(j, t, f, a, s, moved);
        if (gathered < rub) rub = gathered;
    }
    return sp__max(gap, rub);
}

/* residual = p + Aeq f and each block's sums of the admissible forces. */
static void sp__moving_sums(sp__certifier *j, const sp_real *f)
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
        }
    }
}

/* The sums, then the largest violation of a joint. */
static sp_real sp__moving_contacts(sp__certifier *j, const sp_real *f, const sp_real *a, int plates)
{
    sp_real worst = 0;
    sp__moving_sums(j, f);
    for (int32_t c = 0; c < j->pb->contacts; c++)
        worst = sp__max(worst, sp__moving_joint(j, &j->pb->contact[c], f, a, plates));
    j->sweeps += 2;
    return worst;
}

#endif

#if SP__WITH_STRONG

/* Largest violation of (f, a), in proportion to what each block's forces and each joint's acceleration are. a: 6b, held
 * directions 0; plates: pressure may be anywhere in the joints. *moves: the largest acceleration of a block, in its
 * forces / mass. */
SP__NOINLINE static sp_real sp__certify_moving(sp__certifier *j, const sp__inertia *M, const sp_real *f, const sp_real *a,
                                               int plates, sp_real *moves)
{
    const sp_problem *pb = j->pb;
    sp_real worst = sp__moving_contacts(j, f, a, plates);
    *moves = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *x = a + 6 * (size_t)i, s = j->pass.sums[2 * (size_t)i] + j->scale[i].load;
        sp_real *r = j->residual + 6 * (size_t)i;
        for (int k = 0; k < 3; k++) {
            r[k] -= sp__in_units(j->unit, M[i].mass * x[k]);
            r[3 + k] -= sp__in_units(j->unit, sp__dot3(M[i].J[k], x + 3));
        }
        sp__drop_held(pb, i, r);
        const sp_real S = s * j->scale[i].arm + j->scale[i].couple;
        worst = sp__max(worst, sp__max(sp__ratio(sp__norm3(r), s), sp__ratio(sp__norm3(r + 3), S)));
        for (int k = 0; k < 6; k++) if (sp__held(pb, i, k) && (x[k] < 0 || x[k] > 0)) worst = SP__HUGE;
        *moves = sp__max(*moves, sp__ratio(sp__in_units(j->unit, M[i].mass * sp__moving_size(j, i, a)), s));
    }
    return worst;
}

#endif

#endif /* SP__PROOF_MOVING_C */
