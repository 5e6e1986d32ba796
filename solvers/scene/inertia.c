/* inertia: mass and central inertia of the free blocks, and what a force gives them: a = M^-1 (force, moment).
 *
 *   C = sum over faces of det(a, b, c) / 120 (aa' + bb' + cc' + ss'),  s = a + b + c,   J = (tr C 1 - C) mass / volume
 *                                                        [Blow, Binstock 2004: tetrahedra from the centroid to each triangle]
 */
#ifndef SP__SCENE_INERTIA_C
#define SP__SCENE_INERTIA_C

#include "problem.c"

#if SP__WITH_STRONG

/* A free block: mass; inertia; the inverses of both in the directions that are free, zero in those held. */
typedef struct sp__inertia {
    sp_real mass, J[3][3];
    sp_real inverse[3], turn[3][3];     /* 1 / mass by direction; inverse of J among the free turns */
    int32_t known;                      /* 1: from its mesh, 0: taken for a ball as large as its joints are far */
} sp__inertia;

/* C += det(a, b, c) / 120 (aa' + bb' + cc' + ss');    returns det(a, b, c) / 6, the volume */
static sp_real sp__inertia_triangle(const sp_real a[3], const sp_real b[3], const sp_real c[3], sp_real C[3][3])
{
    sp_real n[3], s[3];
    sp__cross3(b, c, n);
    const sp_real det = sp__dot3(a, n);
    for (int k = 0; k < 3; k++) s[k] = a[k] + b[k] + c[k];
    for (int r = 0; r < 3; r++)
        for (int q = 0; q < 3; q++) C[r][q] += det / 120 * (a[r] * a[q] + b[r] * b[q] + c[r] * c[q] + s[r] * s[q]);
    return det / 6;
}

/* C and volume of a face, from the block's centroid: a fan about its vertex mean. */
SP__NOINLINE static sp_real sp__inertia_face(const sp_scene *scene, const sp_block *block, const sp_face *face, sp_real C[3][3])
{
    sp_real mean[3] = { 0, 0, 0 }, volume = 0, p[3], q[3];
    for (int32_t k = 0; k < face->corners; k++) {
        sp__sub3(scene->vertex[scene->corner[face->corner + k]], block->centroid, p);
        sp__add3(mean, 1 / (sp_real)face->corners, p);
    }
    for (int32_t k = 0; k < face->corners; k++) {
        sp__sub3(scene->vertex[scene->corner[face->corner + k]], block->centroid, p);
        sp__sub3(scene->vertex[scene->corner[face->corner + (k + 1) % face->corners]], block->centroid, q);
        volume += sp__inertia_triangle(mean, p, q, C);
    }
    return volume;
}

/* J of a block, of a ball of radius `arm` where it has no mesh. */
SP__NOINLINE static void sp__inertia_of(const sp_scene *scene, const sp_block *block, sp_real arm, sp__inertia *o)
{
    sp_real C[3][3], volume = 0;
    memset(C, 0, sizeof C);
    for (int32_t k = 0; k < block->faces; k++) volume += sp__inertia_face(scene, block, &scene->face[block->face + k], C);
    o->known = volume > 0;
    o->mass = block->mass;
    for (int r = 0; r < 3; r++)
        for (int q = 0; q < 3; q++)
            o->J[r][q] = volume > 0 ? ((r == q ? C[0][0] + C[1][1] + C[2][2] : 0) - C[r][q]) * (block->mass / volume)
                                    : r == q ? (sp_real)0.4 * block->mass * arm * arm : 0;
}

/* Inverse of J among the free turns, by its adjugate: a held turn has 1 on its diagonal, and nothing of the inverse. */
SP__NOINLINE static void sp__inertia_invert(const sp_problem *pb, int32_t i, sp__inertia *o)
{
    sp_real A[3][3], X[3][3];
    for (int r = 0; r < 3; r++) {
        o->inverse[r] = sp__held(pb, i, r) ? 0 : 1 / o->mass;
        for (int q = 0; q < 3; q++)
            A[r][q] = sp__held(pb, i, 3 + r) || sp__held(pb, i, 3 + q) ? (r == q ? o->J[r][r] : 0) : o->J[r][q];
    }
    for (int r = 0; r < 3; r++) sp__cross3(A[(r + 1) % 3], A[(r + 2) % 3], X[r]);
    const sp_real det = sp__dot3(A[0], X[0]);
    for (int r = 0; r < 3; r++)
        for (int q = 0; q < 3; q++)
            o->turn[r][q] = sp__held(pb, i, 3 + r) || sp__held(pb, i, 3 + q) ? 0 : X[q][r] / det;
}

/* The longest arm of every free block to a joint. */
static void sp__inertia_arms(const sp_problem *pb, sp_real *arm)
{
    for (int32_t i = 0; i < pb->blocks; i++) arm[i] = 0;
    for (int32_t c = 0; c < pb->contacts; c++)
        for (int32_t v = pb->contact[c].point; v < pb->contact[c].point + pb->contact[c].points; v++)
            for (int side = 0; side < 2; side++) {
                const int32_t i = side ? pb->contact[c].a : pb->contact[c].b;
                sp_real r[3];
                if (i < 0) continue;
                sp__arm(pb, i, v, r);
                arm[i] = sp__max(arm[i], sp__norm3(r));
            }
}

/* All free blocks; arm: b.     returns 0: a mass or an inertia is nothing, or loads have mass, which turns with no block */
SP__NOINLINE static int sp__inertias(const sp_problem *pb, sp_real *arm, sp__inertia *o)
{
    int sound = 1;
    sp__inertia_arms(pb, arm);
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_block *block = &pb->scene->block[pb->block[i]];
        sp__inertia_of(pb->scene, block, arm[i], &o[i]);
        for (int k = 0; k < 3; k++) sound &= o[i].mass > 0 && o[i].J[k][k] > 0;
        sp__inertia_invert(pb, i, &o[i]);
        for (int k = 0; k < 3; k++) sound &= sp__finite3(o[i].turn[k]) && sp__finite(o[i].inverse[k]);
    }
    for (int32_t k = 0; k < pb->scene->count.loads; k++)
        if (pb->scene->load[k].mass > 0 && pb->scene->block[pb->scene->load[k].block].fixed != SP_FIXED) sound = 0;
    return sound;
}

/* a += M^-1 (force, moment) of block i. */
static void sp__inertia_accelerate(const sp__inertia *o, const sp_real force[6], sp_real a[6])
{
    for (int r = 0; r < 3; r++) {
        a[r] += o->inverse[r] * force[r];
        a[3 + r] += sp__dot3(o->turn[r], force + 3);
    }
}

#endif

#endif /* SP__SCENE_INERTIA_C */
