/* extremes: the largest compression, tension and friction of a force state, and the weakest joint. */
#ifndef SP__CHECK_EXTREMES_C
#define SP__CHECK_EXTREMES_C

#include "read.c"

#if SP__WITH_LARGE

/* How far the blocks of joint t go in the motion, at most: displacement, and turn times how far the joint is. */
SP__NOINLINE static sp_real sp__joint_reach(const sp_scene *scene, const sp_joint *t, const sp_real *dq)
{
    sp_real most = 0;
    for (int side = 0; side < 2; side++) {
        const int32_t b = side ? t->a : t->b;
        const sp_real *m = dq + 6 * (size_t)b, shift = sp__norm3(m), turn = sp__norm3(m + 3);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real arm[3];
            sp__sub3(scene->point[v], scene->block[b].centroid, arm);
            most = sp__max(most, shift + turn * sp__norm3(arm));
        }
    }
    return most;
}

/* How fast joint t opens or slides in the motion: largest |dd| of its corners. */
SP__NOINLINE static sp_real sp__joint_speed(const sp_scene *scene, const sp_joint *t, const sp_real *dq)
{
    sp_real most = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp_real dd[3] = { 0, 0, 0 };
        for (int side = 0; side < 2; side++) {
            const int32_t b = side ? t->a : t->b;
            const sp_real *m = dq + 6 * (size_t)b, sign = side ? -1 : 1;
            sp_real arm[3], w[3];
            sp__sub3(scene->point[v], scene->block[b].centroid, arm);
            sp__cross3(m + 3, arm, w);
            sp__add3(dd, sign, m);
            sp__add3(dd, sign, w);
        }
        most = sp__max(most, sp__norm3(dd));
    }
    return most;
}

/* Largest compression, tension and friction over the joints; weakest: the joint that uses most of its friction, by resultants,
 * with the seed's constants in the settings by corners.                                                        [seed 1.6] */
SP__NOINLINE static void sp__extremes_of_forces(const sp_scene *scene, const sp_settings *set, sp_result *r)
{
    sp_real worst = -1;
    sp_extremes *most = &r->extremes;
    most->weakest = -1;
    for (int32_t k = 0; k < scene->count.joints; k++) {
        sp_joint_force f;
        if (!sp__contact_counts(scene, &scene->joint[k])) continue;
        sp_joint_resultant(scene, r, k, &f);
        most->compression = sp__max(most->compression, f.max_fn);
        most->tension = sp__max(most->tension, r->demand[k].tension);
        most->utilisation = sp__max(most->utilisation, f.utilisation);
        most->corner_utilisation = sp__max(most->corner_utilisation, f.corner_utilisation);
        const sp_real used = set->seed ? f.corner_utilisation : f.utilisation;
        if (used > worst) { worst = used; most->weakest = k; }
    }
}

/* Reading the force state: extremes over the joints, and the weakest of them: where help is wanted most; else, of what falls,
 * the joint of the mechanism that opens or slides fastest, of what stands that which uses most of its friction. */
SP__NOINLINE static void sp__read_extremes(const sp_scene *scene, const sp_settings *set, sp_result *r)
{
    sp_real largest = 0, worst = -1;
    int wants = 0, moves = 0;
    sp__extremes_of_forces(scene, set, r);
    for (size_t k = 0; r->verdict == SP_UNSTABLE && k < 6 * (size_t)scene->count.blocks; k++) moves |= sp__abs(r->dq[k]) > 0;
    for (int32_t k = 0; moves && k < scene->count.joints; k++)
        if (sp__contact_counts(scene, &scene->joint[k]))
            largest = sp__max(largest, sp__joint_reach(scene, &scene->joint[k], r->dq));
    const sp_real tiny = 16 * SP__SCALE_TOL * r->extremes.compression;
    if (moves) r->extremes.weakest = -1;
    for (int32_t k = 0; k < scene->count.joints; k++) {
        if (!sp__contact_counts(scene, &scene->joint[k])) continue;
        const sp_real help = sp__max(r->demand[k].tension, r->demand[k].friction);
        const int wanted = help > tiny;
        if (!wanted && !moves) continue;
        if (moves && !(sp__joint_reach(scene, &scene->joint[k], r->dq) > (sp_real)1e-6 * largest)) continue;   /* it rests */
        const sp_real score = wanted ? help : sp__joint_speed(scene, &scene->joint[k], r->dq);
        if (wanted > wants || (wanted == wants && score > worst)) { wants = wanted; worst = score; r->extremes.weakest = k; }
    }
}

#endif

#endif /* SP__CHECK_EXTREMES_C */
