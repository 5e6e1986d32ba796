/* mirror: in planar and level scenes 3 of a block's 6 rows are enough; which scenes, and which rows. */
#ifndef SP__STATICS_MIRROR_C
#define SP__STATICS_MIRROR_C

#include "../cone/cone.c"
#include "../scene/joint.c"
#include "constants.c"

#if SP__WITH_LARGE

/* May a plan leave effects out with these stages? Only if the exact stage is among them and no stage's answer depends on which
 * blocks are solved together. Not with fewer iterations than usual: who asks for fewer wants to see what they buy as it is. */
static int sp__plan_stages(const sp_settings *set)
{
    int exact = 0;
    if (!set) return 1;
    if (set->seed || set->iterations < SP__ITERATIONS || set->stage_count > SP_STAGES_MAX) return 0;
    for (int32_t k = 0; k < set->stage_count; k++) {
        if (set->stage[k] == SP_STAGE_CUSTOM || set->stage[k] == SP_STAGE_ADMM) return 0;
        exact |= set->stage[k] == SP_STAGE_EXACT;
    }
    return exact;
}

/* Two kinds of scenes need only 3 of a block's 6 rows.
 *
 *   planar         one plane (or planes parallel to it) is a mirror for every joint's corners, every centroid, every load and
 *                  the friction cones. The mirror image of forces that balance balances, and so does the mean of both: if there
 *                  are forces there are symmetric ones. Symmetric motions go in the plane and turn about its normal m, so of
 *                  the dual's 6 unknowns 3 are left, corners that mirror each other have equal rates and count as one, and P_K
 *                  keeps forces in the plane because the cone is symmetric. f0, unique, is symmetric as well, and so is the
 *                  optimum of the penalty form, which is strictly convex. A motion that no symmetric forces resist, none do:
 *                  their mean would.
 *   level          all loads along e, no joint but with n = +-e or across it: of their forces only fn of the first. Rows: force
 *                  along e, moments across it; the others are zero of themselves. Forces fn >= 0 lie in every friction cone, so
 *                  those that balance stand; where there are none friction may still help (a diamond of five rows).
 *   a forest       level without joints across, and the graph of supports (one node) and free blocks with one edge for all
 *                  joints of a pair in one plane has no cycle: friction cannot help, either.
 *     Forces: cut any edge; what hangs on it is pulled along e, and turned only about axes across e. So its friction sums to
 *     zero with no moment about e, and none about axes across e (all of it acts in one plane): fn alone balances as well.
 *     Motions: of one that fn does not resist let every block go sideways, from the supports upwards along the edges, so that
 *     the plane of its edge does not slip (slip of a plane that turns about axes in it is the same all over). Loads do no work
 *     in that, and u = (un, 0, 0) meets no more resistance in a cone than fn alone: |P_K(u)| = max(0, un).
 *     In the same way ft = 0 in f0 (the wrench of an edge is given, and fn alone is the shortest) and in the penalty form.
 *     It is not so with a cycle, with joints of one pair at two heights (a cycle), or with loads across: all are tested.
 *   frictionless   level without joints across, mu = 0: fn along e is all the force there is, and the three rows all that is
 *                  not zero of itself. What fn does not balance falls; only f0 is that of 6 rows, because bilateral joints hold
 *                  sideways.
 *
 * A search in 3 rows keeps vectors of 6 in the axes e; of them the planar one uses 0, 1 and 5, the level one 2, 3 and 4. What
 * it finds is turned back and judged in 3 dimensions as everything is. */

typedef enum sp__mode { SP__PLANE, SP__LEVEL_JOINTS } sp__mode;

typedef struct sp__reduction {
    sp__mode mode;
    int forest, frictionless;           /* level: a forest; no friction, no joint across the loads */
    sp_real e[3][3];                    /* planar: e0, e1 in the plane, e2 = m; level: e2 along the loads, e0, e1 across */
    int32_t *image;                     /* per contact vertex: its mirror image, or itself; -1: takes no part */
    sp_real *g;                         /* SP__REDUCTION_G a contact: frame (sp__reduction_contact), then T of a, of b */
    int64_t vertices, sides;            /* vertices that count; free blocks of all contacts */
    int no_strength;                    /* no joint has strength */
    int spent;                          /* the budget ended its search */
} sp__reduction;

#define SP__REDUCTION_G 20
/* Flops, planar and level: of a vertex in a sweep (u 7, P_K and S about 12, sums 7; u 10, S fn 2, sums 5); of the twist of a
 * free block of a contact there and back; of a vertex in an assembly (u 7, D about 16, q' D q 23; u 10, D 2, q' D q 16), of a
 * free block of a contact (H T 33, T' of it 26, half of what couples two 21). */
#define SP__FLOPS_REDUCED_SWEEP(o) ((o)->mode == SP__PLANE ? 26 : 17)
#define SP__FLOPS_REDUCED_TWIST 28
#define SP__FLOPS_REDUCED_HESSIAN(o) ((o)->mode == SP__PLANE ? 46 : 28)
#define SP__FLOPS_REDUCED_BLOCKS 80

/* Asymmetry, relative to arms, that is as good as none. */
static sp_real sp__reduction_tol(const sp_settings *set) { return sp__max(set->tol / 16, 16 * (sp_real)SP_EPSILON); }

/* The mirror image of vertex v of a contact, in its plane along h = (m.t1, m.t2); -1: there is none. */
static int32_t sp__mirror_image(const sp_problem *pb, const sp_contact *t, int32_t v, const sp_real h[2], sp_real within)
{
    const sp_real *l = pb->local[v];
    const sp_real out = 2 * (l[1] * h[0] + l[2] * h[1]), x = l[1] - out * h[0], y = l[2] - out * h[1];
    for (int32_t k = t->point; k < t->point + t->points; k++) {
        const sp_real *o = pb->local[k];
        if (sp__abs(o[1] - x) <= within && sp__abs(o[2] - y) <= within && sp__abs(o[0] - l[0]) <= within) return k;
    }
    return -1;
}

/* Is m the normal of a mirror of this contact? */
static int sp__mirror_contact(const sp_problem *pb, const sp_settings *set, const sp_contact *t, const sp_real m[3])
{
    const sp_real h[2] = { sp__dot3(m, t->joint->t1), sp__dot3(m, t->joint->t2) }, eps = sp__reduction_tol(set);
    sp_real size = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) size = sp__max(size, sp__norm3(pb->local[v]));
    if (sp__abs(sp__dot3(m, t->joint->n)) > eps) return 0;
    if (t->a >= 0 && sp__abs(sp__dot3(m, t->ra)) > eps * (size + sp__norm3(t->ra))) return 0;
    if (t->b >= 0 && sp__abs(sp__dot3(m, t->rb)) > eps * (size + sp__norm3(t->rb))) return 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const int32_t image = sp__mirror_image(pb, t, v, h, eps * size);
        if (image < 0 || sp__mirror_image(pb, t, image, h, eps * size) != v) return 0;
    }
    return 1;
}

/* Are the loads symmetric: no force along m, no couple across it; for level joints: the other way round? */
static int sp__mirror_loads(const sp_problem *pb, const sp_settings *set, const sp_real m[3], int level)
{
    const sp_real eps = sp__reduction_tol(set);
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *F = pb->p + 6 * (size_t)i, *M = F + 3, *along = level ? M : F, *across = level ? F : M;
        sp_real rest[3];
        for (int k = 0; k < 3; k++) rest[k] = across[k] - sp__dot3(across, m) * m[k];
        if (pb->scene->block[pb->block[i]].fixed) return 0;             /* held in some directions */
        if (sp__abs(sp__dot3(along, m)) > eps * sp__norm3(along) || sp__norm3(rest) > eps * sp__norm3(across)) return 0;
    }
    return 1;
}

/* The normal of the mirror: across the first joint's normal and what makes the widest angle with it, of normals and forces;
 * where all of that is parallel, `edge` (1 or 2) of the first joint's tangents.                     returns 0: there is none */
static int sp__mirror_normal(const sp_problem *pb, int edge, sp_real m[3])
{
    const sp_joint *f = pb->contact[0].joint;
    sp_real widest = (sp_real)1e-3, size;
    m[0] = m[1] = m[2] = 0;
    for (int32_t k = 1; k < pb->contacts + pb->blocks; k++) {
        sp_real x[3], u[3];
        memcpy(u, k < pb->contacts ? pb->contact[k].joint->n : pb->p + 6 * (size_t)(k - pb->contacts), sizeof u);
        size = sp__norm3(u);
        sp__cross3(f->n, u, x);
        if (size > 0 && sp__norm3(x) > widest * size) { widest = sp__norm3(x) / size; memcpy(m, x, sizeof x); }
    }
    if (sp__norm3(m) > 0) { sp__unit3(m, m); return edge == 1; }
    memcpy(m, edge == 1 ? f->t1 : f->t2, 3 * sizeof *m);
    return 1;
}

/* Does the pyramid of a contact have a mirror across direction h of its tangent plane: is h along a face or an edge? */
static int sp__mirror_cone(const sp_settings *set, const sp_contact *t, const sp_real m[3])
{
    const sp_real x = sp__dot3(m, t->joint->t1), y = sp__dot3(m, t->joint->t2);
    sp_real c, half, plus = -1, minus = -1;
    const sp_real eps = sp__max(sp__reduction_tol(set), 64 * (sp_real)SP_EPSILON);
    if (!set->faces) return 1;
    if (set->faces % 4 == 0 && sp__max(sp__abs(x), sp__abs(y)) >= 1 - eps) return 1;      /* along a face's normal */
    sp__pyramid_half(set->faces, &c, &half);
    for (int32_t k = 0; k < set->faces; k++) {
        sp_real d[2];
        sp__pyramid_direction(set->faces, k, d);
        plus = sp__max(plus, d[1] * x - d[0] * y);
        minus = sp__max(minus, d[0] * y - d[1] * x);
    }
    return (plus >= 1 - eps || plus <= c + eps) && (minus >= 1 - eps || minus <= c + eps);
}

/* Is the problem planar?     m: the normal of the mirror */
SP__NOINLINE static int sp__reduction_planar(const sp_problem *pb, const sp_settings *set, sp_real m[3])
{
    for (int edge = 1; pb->contacts && edge <= 2; edge++) {
        int32_t c = 0;
        if (!sp__mirror_normal(pb, edge, m) || !sp__mirror_loads(pb, set, m, 0)) continue;
        while (c < pb->contacts && sp__mirror_contact(pb, set, &pb->contact[c], m)
               && sp__mirror_cone(set, &pb->contact[c], m)) c++;
        if (c == pb->contacts) return 1;
    }
    return 0;
}

/* May joints be taken for frictionless first, because that is likely to be the answer? All loads along m, which joints are
 * level or upright to, no mortar, and every block rests on something. */
SP__NOINLINE static int sp__reduction_level(const sp_problem *pb, const sp_settings *set, const sp_real m[3])
{
    const sp_real eps = sp__reduction_tol(set);
    int32_t rests = 0;
    if (!sp__mirror_loads(pb, set, m, 1)) return 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real along = sp__dot3(t->joint->n, m);
        sp_real across[3];
        if (sp__strength_beyond_friction(&t->joint->strength)) return 0;
        sp__cross3(t->joint->n, m, across);
        if (sp__norm3(across) > eps && sp__abs(along) > eps) return 0;
        rests += (along < 0 && t->b >= 0) || (along > 0 && t->a >= 0);
    }
    return rests >= pb->blocks;
}

/* The direction of the loads: that of the first.     returns 0 where there is none */
static int sp__reduction_down(const sp_problem *pb, sp_real m[3])
{
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *F = pb->p + 6 * (size_t)i;
        if (sp__norm3(F) > 0) { sp__unit3(F, m); return 1; }
    }
    return 0;
}

/* e0, e1 so that e is right-handed. */
static void sp__reduction_axes(sp__reduction *o)
{
    const sp_real *m = o->e[2];
    const int less = sp__abs(m[0]) <= sp__abs(m[1]) ? 0 : 1, least = sp__abs(m[less]) <= sp__abs(m[2]) ? less : 2;
    sp_real x[3] = { 0, 0, 0 };
    x[least] = 1;
    sp__cross3(x, m, o->e[0]);
    sp__unit3(o->e[0], o->e[0]);
    sp__cross3(m, o->e[0], o->e[1]);
}

/* The reduction that is planned for a problem: what is planar is not tried without friction.     returns 0: none */
static int sp__reduction_choose(const sp_problem *pb, const sp_settings *set, sp__reduction *o)
{
    const sp_choice *choice = set->effect;
    memset(o, 0, sizeof *o);
    if (!SP__WITH_REDUCTION || !pb->blocks || !sp__plan_stages(set)) return 0;
    const int planar = choice[SP_EFFECT_DEPTH] != SP_WITH && choice[SP_EFFECT_FRICTION] != SP_WITHOUT
                    && sp__reduction_planar(pb, set, o->e[2]);
    o->mode = planar ? SP__PLANE : SP__LEVEL_JOINTS;
    if (!planar && (choice[SP_EFFECT_FRICTION] == SP_WITH || !sp__reduction_down(pb, o->e[2]))) return 0;
    if (!planar && !sp__reduction_level(pb, set, o->e[2])) return 0;
    sp__reduction_axes(o);
    return 1;
}

/* Takes part: planar every joint, level those along the loads. */
static void sp__reduction_images(sp__reduction *o, const sp_problem *pb, const sp_settings *set)
{
    const sp_real eps = sp__reduction_tol(set);
    o->vertices = o->sides = 0;
    for (int32_t v = 0; v < pb->points; v++) o->image[v] = -1;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real h[2] = { sp__dot3(o->e[2], t->joint->t1), sp__dot3(o->e[2], t->joint->t2) };
        const int level = h[0] * h[0] + h[1] * h[1] <= eps * eps;
        o->sides += (t->a >= 0) + (t->b >= 0);
        sp_real size = 0;
        for (int32_t v = t->point; v < t->point + t->points; v++) size = sp__max(size, sp__norm3(pb->local[v]));
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            if (o->mode == SP__PLANE) o->image[v] = sp__mirror_image(pb, t, v, h, eps * size);
            else if (level) o->image[v] = v;
            o->vertices += o->image[v] >= v;
        }
    }
}

/* Frame of a contact:
 *   planar         n in the plane (2), t = m x n in the joint's tangents (2), the nearest face's share of friction along t and
 *                  against it (2)
 *   level          t1, t2 along e0 (2), along e1 (2)                                                                         */
static void sp__reduction_contact(const sp__reduction *o, const sp__cone *cone, const sp_contact *t, sp_real *g)
{
    const sp_joint *f = t->joint;
    const sp_real *n = f->n;
    const int plane = o->mode == SP__PLANE;
    g[0] = plane ? sp__dot3(n, o->e[0]) : sp__dot3(f->t1, o->e[0]);
    g[1] = plane ? sp__dot3(n, o->e[1]) : sp__dot3(f->t2, o->e[0]);
    sp_real slip[3];
    for (int k = 0; k < 3; k++) slip[k] = g[0] * o->e[1][k] - g[1] * o->e[0][k];
    g[2] = plane ? sp__dot3(slip, f->t1) : sp__dot3(f->t1, o->e[1]);
    g[3] = plane ? sp__dot3(slip, f->t2) : sp__dot3(f->t2, o->e[1]);
    g[4] = g[5] = plane && !cone->faces;
    for (int32_t k = 0; plane && k < cone->faces; k++) {
        const sp_real *d = cone->direction[k], along = d[0] * g[2] + d[1] * g[3];
        g[4] = sp__max(g[4], along);
        g[5] = sp__max(g[5], -along);
    }
}

/* The k-th row of three among six. */
static size_t sp__reduction_row(const sp__reduction *o, int k)
{
    return (size_t)(o->mode == SP__LEVEL_JOINTS ? 2 + k : k < 2 ? k : 5);
}

/* Components of a world vector along e. */
static void sp__reduction_turn(const sp__reduction *o, const sp_real x[3], sp_real out[3])
{
    const sp_real a = sp__dot3(x, o->e[0]), b = sp__dot3(x, o->e[1]);
    out[2] = sp__dot3(x, o->e[2]);
    out[0] = a; out[1] = b;
}

/* A vector of components along e as one of the world, in place. */
static void sp__reduction_turn_back(const sp__reduction *o, sp_real x[3])
{
    const sp_real a = x[0], b = x[1], c = x[2];
    for (int k = 0; k < 3; k++) x[k] = a * o->e[0][k] + b * o->e[1][k] + c * o->e[2][k];
}

#endif

#endif /* SP__STATICS_MIRROR_C */
