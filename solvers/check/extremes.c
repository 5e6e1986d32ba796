/* extremes: the largest compression, tension and friction of a force state, and the weakest joint. */
#ifndef SP__CHECK_EXTREMES_C
#define SP__CHECK_EXTREMES_C

#include "read.c"

#if SP__WITH_LARGE

/* Reading the force state: extremes over the joints, and the weakest of them. */
SP__NOINLINE static void sp__read_extremes(const sp_scene *scene, sp_result *r)
{
    sp_real worst = -1;
    int wants = 0;
    sp_extremes *most = &r->extremes;
    most->weakest = -1;
    for (int32_t k = 0; k < scene->count.joints; k++) {
        sp_joint_force f;
        if (!sp__contact_counts(scene, &scene->joint[k])) continue;
        sp_joint_resultant(scene, r, k, &f);
        most->compression = sp__max(most->compression, f.max_fn);
        most->tension = sp__max(most->tension, r->demand[k].tension);
        most->utilisation = sp__max(most->utilisation, f.utilisation);
    }
    const sp_real tiny = 16 * SP__SCALE_TOL * most->compression;
    for (int32_t k = 0; k < scene->count.joints; k++) {
        sp_joint_force f;
        if (!sp__contact_counts(scene, &scene->joint[k])) continue;
        sp_joint_resultant(scene, r, k, &f);
        const sp_real help = sp__max(r->demand[k].tension, r->demand[k].friction);
        const int wanted = help > tiny;
        const sp_real score = wanted ? help : f.utilisation;
        if (wanted > wants || (wanted == wants && score > worst)) { wants = wanted; worst = score; most->weakest = k; }
    }
}

#endif

#endif /* SP__CHECK_EXTREMES_C */
