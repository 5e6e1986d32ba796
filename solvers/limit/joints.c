/* joints: how joints move in a collapse: at rest, sliding, open; an edge that stays in touch while it opens is a hinge. */
#ifndef SP__LIMIT_JOINTS_C
#define SP__LIMIT_JOINTS_C

#include "../scene/problem.c"
#include "../statics/constants.c"

#if SP__WITH_LIMIT

/* How far vertex v moves with a block in motion dq; returns what that is small against: the most the block's motion can come to
 * there, and its distance from the centroid, which a mechanism's motion is scaled to; 0 of a support, wherever its centroid. */
static sp_real sp__joint_displace(const sp_scene *scene, const sp_real *dq, int32_t block, int32_t v, sp_real u[3])
{
    const sp_real *m = dq + 6 * (size_t)block;
    sp_real arm[3];
    sp__sub3(scene->point[v], scene->block[block].centroid, arm);
    sp__cross3(m + 3, arm, u);
    sp__add3(u, 1, m);
    return scene->block[block].fixed == SP_FIXED ? 0 : sp__norm3(m) + (1 + sp__norm3(m + 3)) * sp__norm3(arm);
}

/* One corner: dn and |dt|.     returns 0 at rest, 1 in touch and sliding, 2 open */
static int sp__joint_corner(const sp_scene *scene, const sp_real *dq, const sp_joint *f, int32_t v, sp_real d[2])
{
    sp_real u[3], w[3];
    const sp_real rest = SP__PLAY * (sp__joint_displace(scene, dq, f->b, v, u) + sp__joint_displace(scene, dq, f->a, v, w));
    sp__sub3(u, w, u);
    sp__joint_frame(f, u, w);
    d[0] = w[0];
    d[1] = SP_SQRT(w[1] * w[1] + w[2] * w[2]);
    if (sp__norm3(u) <= rest) return 0;
    return d[0] <= f->strength.mu * d[1] * (sp_real)1.001 + rest ? 1 : 2;
}

SP_API sp_status sp_joint_moves(const sp_scene *scene, const sp_real *dq, int32_t joint, sp_joint_motion *motion)
{
    if (!scene || !dq || !motion) return SP_E_ARGUMENT;
    if (joint < 0 || joint >= scene->count.joints) return SP_E_INDEX;
    const sp_joint *f = &scene->joint[joint];
    sp_joint_motion m = { SP_JOINT_RIGID, 0, 0, { 0, 0, 0 }, { 0, 0, 0 } };
    int32_t count[3] = { 0, 0, 0 };
    sp_real farthest = -1, d[2], x[3];
    for (int32_t v = f->point; v < f->point + f->points; v++) {
        const int how = sp__joint_corner(scene, dq, f, v, d);
        count[how]++;
        m.opening = sp__max(m.opening, d[0]);
        m.slip = sp__max(m.slip, d[1]);
        for (int32_t q = f->point; q <= v && how < 2; q++) {
            if (sp__joint_corner(scene, dq, f, q, d) == 2) continue;
            sp__sub3(scene->point[v], scene->point[q], x);
            if (!(sp__norm3(x) > farthest)) continue;
            farthest = sp__norm3(x);
            memcpy(m.a, scene->point[q], sizeof m.a);
            memcpy(m.b, scene->point[v], sizeof m.b);
        }
    }
    if (count[2]) m.kind = count[2] == f->points ? SP_JOINT_OPEN : SP_JOINT_HINGE;
    else if (count[1]) m.kind = SP_JOINT_SLIDING;
    *motion = m;
    return SP_OK;
}

#endif

#endif /* SP__LIMIT_JOINTS_C */
