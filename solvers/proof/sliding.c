/* sliding: a state in which a scene slides under its loads, its joints without dilatancy, judged.
 *
 *   p + lambda q + Aeq f = 0,   0 <= fn, dn >= 0, fn dn = 0,  |ft| <= mu fn,  dt != 0 => ft = -mu fn dt / |dt|,   d = Aeq' v,
 *   q . v > 0
 *
 * Pressure alone that carries lambda' q, p + lambda' q = -An fn0, leaves no state below: lambda q . v = -p . v + sum mu fn |dt|
 * >= -p . v = lambda' q . v + fn0 . dn >= lambda' q . v. Where it carries 0 and lambda', it carries all between: there nothing
 * moves from rest, either (moving.c). Even friction does as much along a tree of joints (shear.c).
 */
#ifndef SP__PROOF_SLIDING_C
#define SP__PROOF_SLIDING_C

#include "moving.c"

#if SP__WITH_SLIDING

#define SP__SLIDES ((sp_real)1e-3)      /* work of live loads, in what they could do on blocks that move as much, from which on
                                           they push the motion on */

/* Largest violation of (f, v) under the loads at hand, in proportion to each block's forces and each joint's motion. live, v:
 * 6b. *share: work of the live loads in the most it could be. */
SP__NOINLINE static sp_real sp__certify_sliding(sp__certifier *j, const sp_real *live, const sp_real *f, const sp_real *v,
                                                sp_real *share)
{
    const sp_problem *pb = j->pb;
    sp_real worst = sp__certify_forces(j, f, NULL), work = 0, most = 0;
    worst = sp__max(worst, sp__moving_contacts(j, f, v, 0));
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *q = live + 6 * (size_t)i, *x = v + 6 * (size_t)i;
        work += sp__dot(q, x, 6);
        most += sp__norm3(q) * sp__norm3(x) + sp__norm3(q + 3) * sp__norm3(x + 3);
        for (int k = 0; k < 6; k++) if (sp__held(pb, i, k) && (x[k] < 0 || x[k] > 0)) worst = SP__HUGE;
    }
    *share = work > 0 ? sp__ratio(work, most) : 0;
    return worst;
}

#endif

#endif /* SP__PROOF_SLIDING_C */
