/* Frama-C Eva: the certificate check with any numbers at all, NaN and infinities among them, of a scene whose structure is
 * given: two free blocks, one joint between them of two points, one to the ground of two, one block held in some directions.
 * A proof is any nodes, rows and multipliers, at most NODES and ENTRIES. Asked is memory: indices, what is uninitialised,
 * overflow of whole numbers. What needs no such structure is asked at its capacity by wide.c. */
#define EVA_PIECES
#include "eva.h"
#include "../../solvers/base/words.c"
#include "../../solvers/proof/refute.c"
#include "../../solvers/proof/shear.c"
#include "../../solvers/proof/still.c"
#include "../../solvers/proof/sliding.c"

enum { BLOCKS = 2, JOINTS = 2, POINTS = 4, NODES = 28, ENTRIES = 64, FEW = 8, SWEEPS = 6 };

static sp_block block[BLOCKS + 1];
static sp_joint joint[JOINTS];
static sp_real point[POINTS][3], local[POINTS][3];
static int32_t number[BLOCKS] = { 1, 2 };
static sp_contact contact[JOINTS];
static sp_real loads[6 * BLOCKS], f[3 * POINTS], dq[6 * (BLOCKS + 1)], alpha[POINTS];
static sp_scene scene;
static sp_problem pb;
static sp_settings set;
static sp__certifier judge;
static sp__inertia inertia[BLOCKS];
static sp_proof proof;
static int32_t node[NODES];
static uint16_t row[ENTRIES];
static sp_real y[ENTRIES];

static void any_joint(sp_joint *t, int32_t a, int32_t b, int32_t from)
{
    any_numbers(t->n, 3); any_numbers(t->t1, 3); any_numbers(t->t2, 3);
    t->a = a; t->b = b; t->point = from; t->points = 2;
    t->strength.mu = any(); t->strength.cohesion = any(); t->strength.tension = any(); t->strength.crushing = any();
}

static void make(int32_t faces)
{
    scene.block = block; scene.joint = joint; scene.point = point;
    scene.count.blocks = BLOCKS + 1; scene.count.joints = JOINTS; scene.count.points = POINTS;
    block[0].fixed = SP_FIXED;
    block[2].fixed = 2u | 8u;
    for (int k = 0; k < POINTS; k++) { any_numbers(point[k], 3); any_numbers(local[k], 3); }
    for (int c = 0; c < JOINTS; c++) {
        any_joint(&joint[c], c, c + 1, 2 * c);
        contact[c].joint = &joint[c];
        contact[c].a = c - 1; contact[c].b = c;
        contact[c].point = 2 * c; contact[c].points = 2;
        any_numbers(contact[c].ra, 3); any_numbers(contact[c].rb, 3);
    }
    any_numbers(loads, 6 * BLOCKS); any_numbers(f, 3 * POINTS); any_numbers(dq, 6 * (BLOCKS + 1)); any_numbers(alpha, POINTS);
    pb.scene = &scene; pb.blocks = BLOCKS; pb.contacts = JOINTS; pb.points = POINTS;
    pb.block = number; pb.contact = contact; pb.point = point; pb.local = local; pb.p = loads;
    set.tol = any(); set.force_bound = any(); set.faces = faces; set.inscribed = any_whole(0, 1);
    set.coupled.box = any_whole(0, 1); set.coupled.eps = any(); set.coupled.eta = any();
    for (int k = 0; k < NODES; k++) node[k] = any_whole(INT32_MIN, INT32_MAX);
    for (int k = 0; k < ENTRIES; k++) row[k] = (uint16_t)any_whole(0, UINT16_MAX);
    any_numbers(y, ENTRIES);
    proof.nodes = any_whole(INT32_MIN, NODES); proof.entries = any_whole(INT32_MIN, ENTRIES);
    proof.node = node; proof.row = row; proof.y = y;
}

static void any_inertia(void)
{
    for (int i = 0; i < BLOCKS; i++) {
        inertia[i].mass = any();
        for (int r = 0; r < 3; r++) {
            any_numbers(inertia[i].J[r], 3); any_numbers(inertia[i].turn[r], 3);
            inertia[i].inverse[r] = any();
        }
        inertia[i].known = any_whole(0, 1);
    }
}

/* A certificate check whose scales are any numbers. */
static void opened(int32_t faces, sp_arena *a)
{
    make(faces);
    any_inertia();
    sp__certifier_carve(&judge, &pb, faces, a);
    sp__certifier_cone(&judge, &pb, &set);
    judge.sweeps_most = SWEEPS;
    for (int i = 0; i < BLOCKS; i++) any_numbers(&judge.scale[i].load, (int)(sizeof *judge.scale / sizeof(sp_real)));
    any_numbers(judge.dual.motion, 6 * BLOCKS);
    any_numbers(judge.correction, 6 * BLOCKS);
    judge.total = any();
    judge.force_cap = any();
}

/* Triples, whose blocks lose a spin about a line. */
void eva_triple(void)
{
    sp_arena a = memory_of(0);
    opened(0, &a);
    const sp__lengths k = sp__coupled_lengths(&pb, &set);
    sp__certify_coupled(&judge, &k, f, dq, alpha);
}

/* A walk of any tree of cases of one vertex: NODES hold its deepest, 26 splits and a leaf, and one more. */
void eva_refute_walk(void)
{
    sp_arena a = memory_of(0);
    static sp__refute w;
    opened(0, &a);
    const sp__lengths k = sp__coupled_lengths(&pb, &set);
    pb.blocks = pb.contacts = 1;
    sp__refute_carve(&w, 1, 1, &a);
    w.j = &judge; w.k = &k; w.proof = &proof;
    w.contact[0] = 0; w.at[0] = 1;
    w.F[0] = any(); w.any_friction[0] = any();
    any_numbers(w.reach, 6);
    w.total = any(); w.slack_of_work = any();
    if (proof.nodes > 0 && proof.entries >= 0) sp__refute_walk(&w);
}

/* All of it, of four vertices and FEW nodes. */
void eva_refute_whole(void)
{
    sp_arena a = memory_of(0);
    opened(0, &a);
    const sp__lengths k = sp__coupled_lengths(&pb, &set);
    if (proof.nodes <= FEW) sp__certify_refutation(&judge, &k, &proof, &a);
}

/* A walk of any tree of cases of one corner: its deepest is 12 splits and a leaf. */
void eva_still_walk(void)
{
    sp_arena a = memory_of(0);
    static sp__still w;
    opened(0, &a);
    pb.blocks = pb.contacts = 1;
    sp__still_carve(&w, 1, 1, &a);
    w.j = &judge; w.M = inertia; w.proof = &proof;
    w.contact[0] = 0; w.at[0] = 1;
    w.delta = any();
    any_numbers(w.reach, 6);
    if (proof.nodes > 0 && proof.entries >= 0) sp__still_walk(&w);
}

/* Forces without torsion and the motion along a tree of joints, with live loads and without. */
void eva_even(void)
{
    static sp_real live[6 * BLOCKS];
    sp_arena a = memory_of(0);
    opened(0, &a);
    any_numbers(live, 6 * BLOCKS);
    sp__certify_even(&judge, f, any_whole(0, 1) ? live : NULL, &a);
}

/* The form of shear of a tower of two blocks, with live loads and without. */
void eva_shear(void)
{
    static sp_real live[6 * BLOCKS];
    sp_arena a = memory_of(0);
    opened(0, &a);
    any_numbers(live, 6 * BLOCKS);
    sp__certify_shear(&judge, inertia, f, any_whole(0, 1) ? live : NULL, &a);
}

/* Of one block on two joints, that name the pair in one order or in both. */
static void shear_pair(int32_t a, int32_t b)
{
    sp_arena all = memory_of(0);
    opened(0, &all);
    pb.blocks = 1;
    contact[1].a = a; contact[1].b = b;
    sp__certify_shear(&judge, inertia, f, NULL, &all);
}

void eva_shear_pair(void) { shear_pair(-1, 0); }
void eva_shear_turned(void) { shear_pair(0, -1); }

/* Bytes of any counts: nothing overflows. */
void eva_needs(void)
{
    const int32_t points = any_whole(0, INT32_MAX), contacts = any_whole(0, INT32_MAX), blocks = any_whole(0, INT32_MAX);
    pb.blocks = blocks;
    set.faces = any_whole(0, SP__FACES_MAX);
    sp__certifier_need(&pb, &set);
    sp__refute_need(points, blocks);
    sp__still_need(points, blocks);
    sp__shear_need(points, contacts, blocks);
}

/* How many sweeps a budget leaves; the motion of a result. */
void eva_read(void)
{
    make(0);
    set.budget = any_whole(INT32_MIN, INT32_MAX);
    sp__budget_sweeps(&set, &pb, any_whole(INT32_MIN, INT32_MAX) * (int64_t)INT32_MAX);
    sp__motion_read(&pb, dq, loads);
}
