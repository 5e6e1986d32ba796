/* shear: does nothing move, whatever friction does, where joints close no loop and forces at rest rub as much as they press?
 *
 *   f'     forces that balance, ft' = fn' g in a joint, g one vector of it, |g| <= mu: its friction has no torsion about the
 *          centre of pressure; joints of the same two blocks, in one plane, count as one
 *   u      the motion a, but that each joint of B on A opens by -g . dt more, which is one of rigid blocks:
 *          (u - a)_B - (u - a)_A = N (a_B - a_A),   N (v, w) = (-(g . v) n, (w . n) g) about a point of the joint
 *
 * Any pair at rest (moving.c), its pressure fn at corners or anywhere in the joints, has with d~ = Aeq' u = d - (g . dt) n
 *
 *   f . d~  = sum -fn (g . dt) - mu fn |dt| <= 0,    -p . u = f' . d~ = sum fn' dn >= 0,    so   u'Ma = p . u + f . d~ <= 0,
 *
 * and a = 0 where u'Ma is positive for every a != 0. With g = 0 this is pressure alone. Along a tree of joints there is one u;
 * around a loop these motions of its joints do not close.
 */
#ifndef SP__PROOF_SHEAR_C
#define SP__PROOF_SHEAR_C

#include "../linear/chol.c"
#include "still.c"

#if SP__WITH_STRONG

#define SP__SHEAR_BLOCKS 32             /* above so many free blocks it is not asked: two matrices of 6b x 6b */
#define SP__SHEAR_LEAST ((sp_real)0.01) /* u'Ma >= this a'Ma */
#ifdef SP_REAL_FLOAT
#define SP__SHEAR_FLAT ((sp_real)1e-4)  /* of an arm: corners so far from the plane of their joint are in it */
#define SP__SHEAR_PIVOT ((sp_real)1e-3) /* of a matrix with a diagonal near 1: more than rounding */
#else
#define SP__SHEAR_FLAT ((sp_real)1e-9)
#define SP__SHEAR_PIVOT ((sp_real)1e-9)
#endif

/* Of a pair of blocks that touch: g [world axes], and the pressure it is of. */
typedef struct sp__shear_pair { sp_real g[3], pressure; } sp__shear_pair;

typedef struct sp__shear {
    const sp__certifier *j;
    const sp__inertia *M;
    int32_t n;                          /* 6b */
    sp_real *u;                         /* n x n: row of u after row, in terms of a */
    sp_real *form;                      /* lower triangle of u'Ma, scaled by sqrt(M) */
    sp_real *slack;                     /* n: most of what the balance of f' leaves; then of u times that, by a */
    int32_t *reached;                   /* b */
    sp__shear_pair *pair;               /* joints: of the first of each pair */
    sp_real *even;                      /* 3 x points: f' [N] */
} sp__shear;

/* Are there few blocks, and joints for all? */
static int sp__shear_allowed(int32_t contacts, int32_t blocks)
{
    return contacts >= blocks && blocks > 0 && blocks <= SP__SHEAR_BLOCKS;
}

static void sp__shear_carve(sp__shear *w, int32_t points, int32_t contacts, int32_t blocks, sp_arena *a)
{
    const size_t n = 6 * (size_t)blocks;
    w->n = 6 * blocks;
    w->u = sp__take(a, n * n, sizeof *w->u);
    w->form = sp__take(a, n * (n + 1) / 2, sizeof *w->form);
    w->slack = sp__take(a, n, sizeof *w->slack);
    w->reached = sp__take(a, (size_t)blocks, sizeof *w->reached);
    w->pair = sp__take(a, (size_t)contacts, sizeof *w->pair);
    w->even = sp__take(a, (size_t)points, 3 * sizeof *w->even);
}

/* Bytes; 0: not asked. */
SP__NOINLINE static size_t sp__shear_need(int32_t points, int32_t contacts, int32_t blocks)
{
    sp__shear w;
    sp_arena dry = sp__arena_dry();
    if (!sp__shear_allowed(contacts, blocks)) return 0;
    sp__take(&dry, 1, sizeof w);
    sp__shear_carve(&w, points, contacts, blocks, &dry);
    return dry.used;
}

/* Of the joints of one pair of blocks, the first; 1 in *same where it names them in the same order. */
static int32_t sp__shear_lead(const sp_problem *pb, int32_t c, int *same)
{
    const sp_contact *t = &pb->contact[c];
    for (int32_t k = 0; k <= c; k++) {
        *same = pb->contact[k].a == t->a && pb->contact[k].b == t->b;
        if (*same || (pb->contact[k].a == t->b && pb->contact[k].b == t->a)) return k;
    }
    return c;
}

/* Do as many pairs of blocks touch as there are free blocks? More close a loop. */
static int sp__shear_open(const sp_problem *pb)
{
    int32_t pairs = 0;
    int same;
    if (!sp__shear_allowed(pb->contacts, pb->blocks)) return 0;
    for (int32_t c = 0; c < pb->contacts; c++) pairs += sp__shear_lead(pb, c, &same) == c;
    return pairs == pb->blocks;
}

/* Are the corners of joint c in the plane of joint k? */
static int sp__shear_flat(const sp__shear *w, int32_t c, int32_t k, sp_real sign)
{
    const sp_problem *pb = w->j->pb;
    const sp_contact *t = &pb->contact[c], *lead = &pb->contact[k];
    const int32_t i = t->b >= 0 ? t->b : t->a;
    sp_real r[3];
    for (int q = 0; q < 3; q++) r[q] = t->joint->n[q] - sign * lead->joint->n[q];
    if (!(sp__norm3(r) <= SP__SHEAR_FLAT)) return 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp__sub3(pb->point[v], pb->point[lead->point], r);
        if (!(sp__abs(sp__dot3(r, lead->joint->n)) <= SP__SHEAR_FLAT * w->j->scale[i].arm)) return 0;
    }
    return 1;
}

/* g of every pair of blocks, ft / fn of the sums over its joints.     returns 0: these do not lie in one plane */
SP__NOINLINE static int sp__shear_pairs(sp__shear *w, const sp_real *f)
{
    const sp_problem *pb = w->j->pb;
    int same;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const int32_t k = sp__shear_lead(pb, c, &same);
        const sp_real sign = same ? (sp_real)1 : (sp_real)-1;
        if (!sp__shear_flat(w, c, k, sign)) return 0;
        if (k == c) memset(&w->pair[c], 0, sizeof w->pair[c]);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real rub[3] = { 0, f[3 * (size_t)v + 1], f[3 * (size_t)v + 2] };
            sp_real F[3];
            sp__joint_force(t->joint, rub, F);
            sp__add3(w->pair[k].g, sign, F);
            w->pair[k].pressure += sp__max(0, f[3 * (size_t)v]);
        }
    }
    for (int32_t c = 0; c < pb->contacts; c++) {
        sp__shear_pair *q = &w->pair[c];
        if (sp__shear_lead(pb, c, &same) != c) continue;
        for (int e = 0; e < 3; e++) q->g[e] = q->pressure > 0 ? q->g[e] / q->pressure : 0;
        sp__add3(q->g, -sp__dot3(q->g, pb->contact[c].joint->n), pb->contact[c].joint->n);
    }
    return 1;
}

/* f' of joint c; residual += Aeq f'.     returns 0: its friction is less than g asks for */
SP__NOINLINE static int sp__shear_joint(const sp__shear *w, sp__certifier *j, int32_t c, const sp_real *f)
{
    const sp_problem *pb = j->pb;
    const sp_contact *t = &pb->contact[c];
    int same;
    const int32_t k = sp__shear_lead(pb, c, &same);
    const sp_real *g = w->pair[k].g, *n = pb->contact[k].joint->n;
    if (!(sp__norm3(g) <= t->joint->strength.mu * j->mu_factor * (1 - 16 * (sp_real)SP_EPSILON))) return 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real fn = (same ? 1 : -1) * sp__max(0, f[3 * (size_t)v]);
        sp_real F[3] = { fn * (n[0] + g[0]), fn * (n[1] + g[1]), fn * (n[2] + g[2]) };
        sp__joint_frame(t->joint, F, w->even + 3 * (size_t)v);
        sp__to_units(j->unit, 3, F, F);
        sp__vertex_force(pb, t, v, F, j->residual, j->pass.sums);
    }
    return 1;
}

/* Row k of the motion of block i, -1 a support, at the point x: column e of a. */
static sp_real sp__shear_at(const sp__shear *w, int32_t i, const sp_real x[3], int k, int32_t e, int moved)
{
    if (i < 0) return 0;
    const sp_real *u = w->u + 6 * (size_t)i * (size_t)w->n + e;
    const size_t n = (size_t)w->n;
    sp_real a[6], r[3], s[3];
    for (int q = 0; q < 6; q++) a[q] = moved ? u[(size_t)q * n] : e == 6 * i + q;
    sp__sub3(x, w->j->pb->scene->block[w->j->pb->block[i]].centroid, r);
    sp__cross3(a + 3, r, s);
    return a[k] + (k < 3 ? s[k] : 0);
}

/* u - a of `child` from that of the other block of joint c, column by column: + N (a_child - a_other). u holds u - a. */
SP__NOINLINE static void sp__shear_hang(sp__shear *w, int32_t c, int32_t child)
{
    const sp_problem *pb = w->j->pb;
    const sp_contact *t = &pb->contact[c];
    const int32_t other = t->b == child ? t->a : t->b;
    const sp_real *x = pb->point[t->point], *g = w->pair[c].g, *n = t->joint->n;
    const sp_real *centroid = pb->scene->block[pb->block[child]].centroid;
    sp_real r[3], s[3];
    sp__sub3(centroid, x, r);
    for (int32_t e = 0; e < w->n; e++) {
        sp_real motion[6], rate = 0, spin = 0;
        for (int k = 0; k < 6; k++) {
            const sp_real d = sp__shear_at(w, child, x, k, e, 0) - sp__shear_at(w, other, x, k, e, 0);
            if (k < 3) rate += g[k] * d;
            else spin += n[k - 3] * d;
        }
        for (int k = 0; k < 3; k++) {
            motion[k] = sp__shear_at(w, other, x, k, e, 1) - rate * n[k];
            motion[3 + k] = sp__shear_at(w, other, x, 3 + k, e, 1) + spin * g[k];
        }
        sp__cross3(motion + 3, r, s);
        for (int k = 0; k < 3; k++) motion[k] += s[k];
        for (int k = 0; k < 6; k++) w->u[(6 * (size_t)child + (size_t)k) * (size_t)w->n + (size_t)e] = motion[k];
    }
}

/* u of all blocks, from the supports on.     returns 0: joints close a loop */
SP__NOINLINE static int sp__shear_tree(sp__shear *w)
{
    const sp_problem *pb = w->j->pb;
    int32_t found = 0, last = -1;
    memset(w->reached, 0, (size_t)pb->blocks * sizeof *w->reached);
    while (found > last) {
        last = found;
        for (int32_t c = 0; c < pb->contacts; c++) {
            const int32_t a = pb->contact[c].a, b = pb->contact[c].b;
            const int ready = a < 0 || w->reached[a], too = b < 0 || w->reached[b];
            if (ready == too) continue;                 /* c is then the first of its pair: others follow it */
            sp__shear_hang(w, c, ready ? b : a);
            w->reached[ready ? b : a] = 1;
            found++;
        }
    }
    if (found < pb->blocks) return 0;
    for (int32_t k = 0; k < w->n; k++) w->u[(size_t)k * (size_t)w->n + (size_t)k] += 1;
    return 1;
}

/* Is u at rest in every held direction, so that what holds it there does no work on u? */
static int sp__shear_held(const sp__shear *w)
{
    const sp_problem *pb = w->j->pb;
    for (int32_t r = 0; r < w->n; r++)
        for (int32_t e = 0; e < w->n && sp__held(pb, r / 6, r % 6); e++)
            if (!sp__held(pb, e / 6, e % 6) && sp__abs(w->u[(size_t)r * (size_t)w->n + (size_t)e]) > 0) return 0;
    return 1;
}

/* (M u) of row r, column e. */
static sp_real sp__shear_momentum(const sp__shear *w, int32_t r, int32_t e)
{
    const sp__inertia *M = &w->M[r / 6];
    const size_t n = (size_t)w->n;
    if (r % 6 < 3) return M->mass * w->u[(size_t)r * n + (size_t)e];
    sp_real s = 0;
    for (int k = 0; k < 3; k++) s += M->J[r % 6 - 3][k] * w->u[(6 * (size_t)(r / 6) + 3 + (size_t)k) * n + (size_t)e];
    return s;
}

/* Is u'Ma >= SP__SHEAR_LEAST a'Ma? By Cholesky of the symmetric part of their difference, scaled to a diagonal near 1. */
SP__NOINLINE static int sp__shear_positive(sp__shear *w)
{
    sp_real *to = w->form;
    for (int32_t r = 0; r < w->n; r++)
        for (int32_t e = 0; e <= r; e++) {
            const sp__inertia *R = &w->M[r / 6], *E = &w->M[e / 6];
            const sp_real a = r % 6 < 3 ? R->mass : R->J[r % 6 - 3][r % 6 - 3];
            const sp_real b = e % 6 < 3 ? E->mass : E->J[e % 6 - 3][e % 6 - 3];
            const int turns = r % 6 >= 3 && e % 6 >= 3;
            const sp_real own = r / 6 != e / 6 ? 0 : turns ? R->J[r % 6 - 3][e % 6 - 3] : r == e ? R->mass : 0;
            const sp_real both = (sp__shear_momentum(w, r, e) + sp__shear_momentum(w, e, r)) / 2;
            *to++ = (both - SP__SHEAR_LEAST * own) / (SP_SQRT(a) * SP_SQRT(b));
        }
    return sp__chol_factor(w->form, w->n, SP__SHEAR_PIVOT) == 0;
}

/* Most of |u . r| / |a|_M for what f' leaves unbalanced, r, and what rounding may hide. */
SP__NOINLINE static sp_real sp__shear_slack(sp__shear *w)
{
    const sp__certifier *j = w->j;
    const sp_problem *pb = j->pb;
    sp_real all = 0;
    for (int32_t r = 0; r < w->n; r++) {
        const sp__scale *s = &j->scale[r / 6];
        const sp_real size = j->pass.sums[2 * (size_t)(r / 6)] + s->load, turn = r % 6 < 3 ? size : size * s->arm + s->couple;
        w->slack[r] = sp__in_newtons(j->unit, sp__abs(j->residual[r]) + 64 * (sp_real)SP_EPSILON * turn);
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp_real e[6], turn = 0;
        for (int k = 0; k < 6; k++) {
            e[k] = 0;
            const sp_real *u = w->u + 6 * (size_t)i + (size_t)k;
            for (int32_t r = 0; r < w->n; r++) e[k] += sp__abs(u[(size_t)r * (size_t)w->n]) * w->slack[r];
        }
        for (int k = 0; k < 3; k++) turn += sp__norm3(w->M[i].turn[k]);
        for (int k = 0; k < 3; k++) all += e[k] * e[k] * w->M[i].inverse[k];
        all += turn * sp__dot3(e + 3, e + 3);
    }
    return SP_SQRT(all);
}

/* Do live loads q do on u what they do on a?  q'Y = q' to tol */
static int sp__shear_pushes(const sp__shear *w, const sp_real *live)
{
    for (int32_t e = 0; e < w->n; e++) {
        sp_real sum = -live[e], size = sp__abs(live[e]);
        for (int32_t r = 0; r < w->n; r++) {
            const sp_real x = live[r] * w->u[(size_t)r * (size_t)w->n + (size_t)e];
            sum += x;
            size += sp__abs(x);
        }
        if (!sp__held(w->j->pb, e / 6, e % 6) && !(sp__abs(sum) <= w->j->set->tol * size)) return 0;
    }
    return 1;
}

/* f' and u of the forces f; live: loads that do on u what they do on a, NULL: none.     returns NULL: there are none such */
SP__NOINLINE static sp__shear *sp__shear_make(sp__certifier *j, const sp_real *f, const sp_real *live, sp_arena *a)
{
    const sp_problem *pb = j->pb;
    if (!sp__shear_open(pb)) return NULL;
    sp__shear *w = sp__take(a, 1, sizeof *w);
    if (!w) return NULL;
    sp__shear_carve(w, pb->points, pb->contacts, pb->blocks, a);
    if (sp__failed(a)) return NULL;
    w->j = j;
    sp__certifier_load_rows(j);
    if (!sp__shear_pairs(w, f)) return NULL;
    for (int32_t c = 0; c < pb->contacts; c++) if (!sp__shear_joint(w, j, c, f)) return NULL;
    j->sweeps++;
    return sp__shear_tree(w) && sp__shear_held(w) && (!live || sp__shear_pushes(w, live)) ? w : NULL;
}

/* Do the forces f hold the scene whatever friction does?     returns a margin of 0 .. 1, 0: no proof */
SP__NOINLINE static sp_real sp__certify_shear(sp__certifier *j, const sp__inertia *M, const sp_real *f, const sp_real *live,
                                              sp_arena *a)
{
    const sp_real least = SP__SHEAR_LEAST * SP_SQRT(sp__in_newtons(j->unit, sp__still_delta(j, M)));
    sp__shear *w = least > 0 ? sp__shear_make(j, f, live, a) : NULL;
    if (!w) return 0;
    w->M = M;
    if (!sp__shear_positive(w)) return 0;
    const sp_real slack = sp__shear_slack(w);
    return slack < least ? 1 - slack / least : 0;
}

#if SP__WITH_SLIDING

/* The largest relative imbalance of f', where live loads do on u what they do on a; SP__HUGE: there is no u. Then no state
 * slides below this multiple of them: q . v of one at less, lambda < lambda', has
 *     0 = (p + lambda q) . u + f . d~ <= -fn' dn - (lambda' - lambda) q . v <= 0 */
SP__NOINLINE static sp_real sp__certify_even(sp__certifier *j, const sp_real *f, const sp_real *live, sp_arena *a)
{
    sp__shear *w = sp__shear_make(j, f, live, a);
    return w ? sp__certify_forces(j, w->even, NULL) : SP__HUGE;
}

#endif

#endif

#endif /* SP__PROOF_SHEAR_C */
