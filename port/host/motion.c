#include "motion.h"

#include <math.h>

int motion_is_virtual(const sp_result *x)
{
    const int helped = x->coupled.tension_ratio >= 0 && (x->verdict == SP_UNDECIDED || x->reason == SP_REASON_NO_MOTION);
    return x->coupled.dq != NULL && (x->level == SP_COUPLED || helped);
}

const sp_real *motion_shown(const sp_result *x) { return motion_is_virtual(x) ? x->coupled.dq : x->dq; }

int motion_is_told(const sp_scene *s, const sp_result *x)
{
    if (x->verdict == SP_UNSTABLE || motion_is_virtual(x)) return 1;
    for (int32_t b = 0; x->verdict == SP_STABLE && x->dq && b < s->count.blocks; b++) if (motion_speed(s, x, b) > 0) return 1;
    return 0;
}

double motion_speed(const sp_scene *s, const sp_result *x, int32_t b)
{
    const sp_real *dq = motion_shown(x) + 6 * (size_t)b;
    const double unit = motion_is_virtual(x) ? (double)(x->coupled.eps > 0 ? x->coupled.eps : x->coupled.eta) : 1;
    const double turn = sqrt((double)(dq[3] * dq[3] + dq[4] * dq[4] + dq[5] * dq[5])) * (double)s->block[b].diameter / 2;
    const double go = sqrt((double)(dq[0] * dq[0] + dq[1] * dq[1] + dq[2] * dq[2]));
    return (go > turn ? go : turn) / unit;
}

const char *motion_of_joint(const sp_scene *s, const sp_result *x, int32_t joint)
{
    sp_joint_motion m;
    if (x->verdict != SP_UNSTABLE || sp_joint_moves(s, x->dq, joint, &m) != SP_OK || m.kind == SP_JOINT_RIGID) return NULL;
    return m.kind == SP_JOINT_SLIDING ? "slides" : "opens";
}

int32_t motion_fastest(const sp_scene *s, const sp_result *x, int32_t most, int32_t *block)
{
    int32_t moving = 0, kept = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        const double v = motion_speed(s, x, b);
        if (!(v > MOTION_STILL)) continue;
        moving++;
        int32_t k = kept;                               /* its place: equal to rounding, it comes later */
        while (k > 0 && v > (1 + MOTION_STILL) * motion_speed(s, x, block[k - 1])) k--;
        if (k >= most) continue;
        if (kept < most) kept++;
        for (int32_t i = kept - 1; i > k; i--) block[i] = block[i - 1];
        block[k] = b;
    }
    return moving;
}
