/* What the suites of proofs share: a small scene without symmetry, its Aeq as a dense matrix from the definition, leaves of
 * random rows. All of it is static. */
#ifndef LEAF_H
#define LEAF_H

#include <math.h>

enum { LEAF_BLOCKS = 3, LEAF_POINTS = 9, LEAF_N = 6 * LEAF_BLOCKS, LEAF_ENTRIES = 40 };

typedef struct leaf_scene {
    sp_scene scene;
    sp_problem pb;
    sp_settings set;
    sp__certifier j;
    int32_t contact[LEAF_POINTS], at[LEAF_POINTS];
    double A[LEAF_N][3 * LEAF_POINTS];  /* Aeq: a row of a block, columns (n, t1, t2) of a corner */
    double p[LEAF_N];                   /* loads in units */
} leaf_scene;

/* Three free blocks of random weight on nine points between them and the ground, the last held along y and about x; random
 * loads. */
static int leaf_make(leaf_scene *o, int32_t faces, int32_t inscribed)
{
    static const int32_t pair[5][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 3, 1 }, { 0, 3 } };
    const sp_capacity cap = { 4, 0, 0, 0, 5, LEAF_POINTS, 3 };
    memset(o, 0, sizeof *o);
    if (!CHECK_INT(sp_scene_create(&o->scene, &cap, &test_arena), SP_OK)) return 0;
    for (int b = 0; b < 4; b++) {
        const sp_real at[3] = { R(b), test_random_real(-1, 1), test_random_real(0, 2) };
        const uint32_t held = b == 0 ? SP_FIXED : b == 3 ? 2u | 8u : 0;
        if (!CHECK_INT(sp_scene_body(&o->scene, b ? test_random_real(1, 3) : 0, at, held, NULL), SP_OK)) return 0;
    }
    for (int k = 0; k < 5; k++) {
        const int32_t points = k < 4 ? 2 : 1;
        const sp_strength rough = sp_strength_friction(test_random_real(0.2, 1));
        sp_real n[3], x[6];
        for (int i = 0; i < 3; i++) n[i] = test_random_real(-1, 1);
        for (int i = 0; i < 6; i++) x[i] = test_random_real(-2, 2);
        if (!CHECK_INT(sp_scene_points(&o->scene, pair[k][0], pair[k][1], n, points, x, &rough, NULL), SP_OK)) return 0;
    }
    for (int b = 1; b < 4; b++) {
        sp_load load;
        memset(&load, 0, sizeof load);
        load.block = b;
        for (int i = 0; i < 3; i++) {
            load.force[i] = test_random_real(-9, 9);
            load.couple[i] = test_random_real(-9, 9);
        }
        if (!CHECK_INT(sp_scene_load(&o->scene, &load, NULL), SP_OK)) return 0;
    }
    o->set.tol = R(0.01);
    o->set.force_bound = 100;
    o->set.faces = faces;
    o->set.inscribed = inscribed;
    o->set.coupled.asked = 1;
    o->set.coupled.eps = R(0.01);
    if (!CHECK_INT(sp_problem_build(&o->scene, &test_arena, &o->pb), SP_OK)) return 0;
    if (!CHECK(sp__certifier_open(&o->j, &o->pb, &o->set, NULL, INT32_MAX, &test_arena))) return 0;
    int32_t v = 0;
    for (int32_t c = 0; c < o->pb.contacts; c++)
        for (int32_t q = 0; q < o->pb.contact[c].points; q++, v++) {
            const sp_contact *t = &o->pb.contact[c];
            const sp_real *axis[3] = { t->joint->n, t->joint->t1, t->joint->t2 };
            o->contact[v] = c;
            o->at[v] = t->point + q;
            for (int side = 0; side < 2; side++) {
                const int32_t i = side ? t->a : t->b;
                sp_real arm[3];
                if (i < 0) continue;
                sp__arm(&o->pb, i, o->at[v], arm);
                for (int k = 0; k < 3; k++)
                    for (int m = 0; m < 3; m++) {
                        const int a = (m + 1) % 3, b = (m + 2) % 3;
                        const double turn = (double)arm[a] * (double)axis[k][b] - (double)arm[b] * (double)axis[k][a];
                        o->A[6 * i + m][3 * v + k] += side ? -(double)axis[k][m] : (double)axis[k][m];
                        o->A[6 * i + 3 + m][3 * v + k] += side ? -turn : turn;
                    }
            }
        }
    for (int r = 0; r < LEAF_N; r++) o->p[r] = (double)o->pb.p[r] / (double)o->j.unit;
    return CHECK_INT(v, LEAF_POINTS);
}

static int leaf_held(int r) { return r == 6 * 2 + 1 || r == 6 * 2 + 3; }
static double leaf_mu(const leaf_scene *o, int v) { return (double)o->pb.contact[o->contact[v]].joint->strength.mu; }
static double leaf_norm(const double *x) { return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); }

/* Longest arm of a block to its corners, straight from the points. */
static double leaf_arm(const leaf_scene *o, int i)
{
    double most = 0;
    for (int v = 0; v < LEAF_POINTS; v++) {
        const sp_contact *t = &o->pb.contact[o->contact[v]];
        sp_real arm[3];
        if (t->a != i && t->b != i) continue;
        sp__arm(&o->pb, i, o->at[v], arm);
        most = fmax(most, sqrt((double)arm[0] * (double)arm[0] + (double)arm[1] * (double)arm[1] + (double)arm[2] * (double)arm[2]));
    }
    return most;
}

/* The lesser of a number of each block that a corner touches. */
static double leaf_lesser(const leaf_scene *o, int v, const double *of)
{
    const sp_contact *t = &o->pb.contact[o->contact[v]];
    return t->a < 0 ? of[t->b] : t->b < 0 ? of[t->a] : fmin(of[t->a], of[t->b]);
}

/* A proof that reads the caller's arrays. */
static sp_proof proof_of(int32_t nodes, const int32_t *node, int32_t entries, const uint16_t *row, const sp_real *y)
{
    const sp_proof proof = { .nodes = nodes, .entries = entries, .node = (int32_t *)(uintptr_t)node,
                             .row = (uint16_t *)(uintptr_t)row, .y = (sp_real *)(uintptr_t)y };
    return proof;
}

#define LEAF_TOL TOL(1e-11, 2e-4)

#endif /* LEAF_H */
