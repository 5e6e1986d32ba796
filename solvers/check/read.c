/* read: the resultant of a joint's forces, and the force and moment that all joints put on a block. */
#ifndef SP__CHECK_READ_C
#define SP__CHECK_READ_C

#include "../base/vectors.c"
#include "../scene/joint.c"
#include "../scene/problem.c"

/* Weight of the lighter free block of a joint: what a joint that carries next to nothing is measured by. */
static sp_real sp__lesser_weight(const sp_scene *scene, const sp_joint *t)
{
    const sp_block *a = &scene->block[t->a], *b = &scene->block[t->b];
    const sp_real mass = a->fixed == SP_FIXED || (b->fixed != SP_FIXED && b->mass < a->mass) ? b->mass : a->mass;
    return mass * sp__norm3(scene->gravity);
}

/* Share of friction used, |ft| / (mu fn + C); 0 where both are what rounding leaves, at the tip of a cone moved down. */
static sp_real sp__friction_used(sp_real slip, sp_real press, sp_real C)
{
    const sp_real held = sp__max(0, press + C), tiny = 64 * (sp_real)SP_EPSILON * (sp__abs(press) + C);
    return held > tiny || slip > tiny ? sp__ratio(slip, held) : 0;
}

/* Largest |ft| / (mu fn + C) of a joint's corners with |fn| + |ft| above `least`: at 1 one of them slides, by this force
 * state.                                                                                                      [seed 1.6] */
static sp_real sp__corner_utilisation(const sp_joint *t, const sp_real *f, sp_real least)
{
    const sp_real C = sp__vertex_strength(t, 0).C;
    sp_real most = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real fn = f[3 * (size_t)v], x = f[3 * (size_t)v + 1], y = f[3 * (size_t)v + 2], slip = SP_SQRT(x * x + y * y);
        if (sp__abs(fn) + slip > least) most = sp__max(most, sp__friction_used(slip, t->strength.mu * fn, C));
    }
    return most;
}

SP_API sp_status sp_joint_resultant(const sp_scene *scene, const sp_result *result, int32_t joint,
                                        sp_joint_force *out)
{
    if (!scene || !result || !result->f || !out) return SP_E_ARGUMENT;
    if (joint < 0 || joint >= scene->count.joints) return SP_E_INDEX;
    const sp_joint *t = &scene->joint[joint];
    sp_joint_force o;
    sp_real sum[3] = { 0, 0, 0 }, size = 0;
    memset(&o, 0, sizeof o);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *f = result->f + 3 * (size_t)v;
        const int first = v == t->point;
        sp__add3(sum, 1, f);
        size += sp__abs(f[0]);
        if (first || f[0] < o.min_fn) o.min_fn = f[0];
        if (first || f[0] > o.max_fn) o.max_fn = f[0];
    }
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real share = size > 0 ? sp__abs(result->f[3 * (size_t)v]) / size : 1 / (sp_real)t->points;
        sp_real away[3];
        sp__sub3(scene->point[v], scene->point[t->point], away);
        sp__add3(o.point, share, away);
    }
    sp__add3(o.point, 1, scene->point[t->point]);
    sp__joint_force(t, sum, o.force);
    const sp_real slip = SP_SQRT(sum[1] * sum[1] + sum[2] * sum[2]);
    const sp_real least = (sp_real)1e-4 * sp__lesser_weight(scene, t);
    o.utilisation = size + slip > least
        ? sp__friction_used(slip, t->strength.mu * sum[0], t->strength.cohesion * t->area) : 0;
    if (SP__WITH_LARGE) o.corner_utilisation = sp__corner_utilisation(t, result->f, sp__max(least, (sp_real)1e-4 * o.max_fn));
    *out = o;
    return SP_OK;
}

SP_API sp_status sp_block_resultant(const sp_scene *scene, const sp_result *result, int32_t block, sp_real force[3],
                                    sp_real moment[3])
{
    if (!scene || !result || !result->f || !force || !moment) return SP_E_ARGUMENT;
    if (block < 0 || block >= scene->count.blocks) return SP_E_INDEX;
    for (int k = 0; k < 3; k++) force[k] = moment[k] = 0;
    for (int32_t k = 0; k < scene->count.joints; k++) {
        const sp_joint *t = &scene->joint[k];
        if (t->a != block && t->b != block) continue;
        const sp_real sign = t->b == block ? (sp_real)1 : (sp_real)-1;
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real F[3], arm[3], m[3];
            sp__joint_force(t, result->f + 3 * (size_t)v, F);
            sp__sub3(scene->point[v], scene->block[block].centroid, arm);
            sp__cross3(arm, F, m);
            sp__add3(force, sign, F);
            sp__add3(moment, sign, m);
        }
    }
    return SP_OK;
}

#endif /* SP__CHECK_READ_C */
