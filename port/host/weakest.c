#include "weakest.h"
#include "motion.h"

#define NEAR_LIMIT 0.01                 /* share of its friction from which a joint is worth a name: below it is rounding */

int32_t weakest_told(const sp_scene *s, const sp_result *x)
{
    const int32_t i = x->extremes.weakest;
    sp_joint_force f;
    if (i >= 0 && motion_of_joint(s, x, i)) return i;
    if (i < 0 || sp_joint_resultant(s, x, i, &f) != SP_OK) return -1;
    return x->demand[i].friction > 0 || x->demand[i].tension > 0 || (double)f.utilisation >= NEAR_LIMIT ? i : -1;
}
