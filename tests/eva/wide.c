/* Frama-C Eva: the certificate check at the capacities it is compiled for, with any numbers at all. A scene has WIDE free
 * blocks, WIDE vertices and any number of joints up to WIDE, each of 1 .. 4 vertices that lie anywhere among them, between any
 * two blocks or a block and a support. One state stands for all passes of a loop. */
#define EVA_PIECES
#include "eva.h"
#include "../../solvers/base/words.c"
#include "../../solvers/proof/refute.c"
#include "../../solvers/proof/shear.c"
#include "../../solvers/proof/still.c"
#include "../../solvers/proof/sliding.c"

enum { WIDE = SP_EXACT_POINTS, EACH = 4, ENTRIES = 4096, NODES = SP__PROOF_DEPTH * WIDE - 2 };

static sp_block block[WIDE + 1];
static sp_joint joint[WIDE];
static sp_real point[WIDE][3], local[WIDE][3];
static int32_t number[WIDE];
static sp_contact contact[WIDE];
static sp_real loads[6 * WIDE], live[6 * WIDE], f[3 * WIDE], dq[6 * (WIDE + 1)], alpha[WIDE], spare[3 * WIDE];
static sp_scene scene;
static sp_problem pb;
static sp_settings set;
static sp__certifier judge;
static sp__inertia inertia[WIDE];
static sp_proof proof;
static int32_t node[NODES];
static uint16_t row[ENTRIES];
static sp_real y[ENTRIES];

static void wide_block(int32_t k)
{
    block[k].fixed = (uint32_t)any_whole(0, SP_FIXED);
    block[k].diameter = any();
    any_numbers(block[k].centroid, 3);
}

static void wide_joint(int32_t c, int32_t blocks, int32_t points, int turned)
{
    sp_joint *const t = &joint[c];
    const int32_t any_block = any_whole(-1, blocks - 1), free_block = any_whole(0, blocks - 1);
    any_numbers(t->n, 3); any_numbers(t->t1, 3); any_numbers(t->t2, 3);
    t->strength.mu = any(); t->strength.cohesion = any(); t->strength.tension = any(); t->strength.crushing = any();
    t->area = any();
    t->point = contact[c].point = any_whole(0, points - EACH);
    t->points = contact[c].points = any_whole(1, EACH);
    contact[c].joint = t;
    contact[c].a = turned ? free_block : any_block; contact[c].b = turned ? any_block : free_block;
    any_numbers(contact[c].ra, 3); any_numbers(contact[c].rb, 3);
}

static void wide_inertia(int32_t i)
{
    inertia[i].mass = any();
    for (int r = 0; r < 3; r++) {
        any_numbers(inertia[i].J[r], 3); any_numbers(inertia[i].turn[r], 3);
        inertia[i].inverse[r] = any();
    }
    inertia[i].known = any_whole(0, 1);
}

/* turned: it is the second block of a joint that may be a support. */
static void wide_scene(int32_t blocks, int32_t points, int32_t faces, int turned)
{
    scene.block = block; scene.joint = joint; scene.point = point;
    scene.count.blocks = blocks + 1; scene.count.joints = points; scene.count.points = points;
    for (int k = 0; k <= blocks; k++) wide_block(k);
    for (int k = 0; k < points; k++) { any_numbers(point[k], 3); any_numbers(local[k], 3); }
    /*@ loop unroll 64; */
    for (int c = 0; c < points; c++) wide_joint(c, blocks, points, turned);
    for (int i = 0; i < blocks; i++) { number[i] = any_whole(0, blocks); wide_inertia(i); }
    any_numbers(loads, 6 * blocks); any_numbers(live, 6 * blocks); any_numbers(f, 3 * points);
    any_numbers(dq, 6 * (blocks + 1)); any_numbers(alpha, points);
    pb.scene = &scene; pb.blocks = blocks; pb.points = points; pb.contacts = any_whole(0, points);
    pb.block = number; pb.contact = contact; pb.point = point; pb.local = local; pb.p = loads;
    pb.ignore_strength = any_whole(0, 1);
    set.tol = any(); set.force_bound = any(); set.faces = faces; set.inscribed = any_whole(0, 1);
    set.coupled.box = any_whole(0, 1); set.coupled.eps = any(); set.coupled.eta = any();
}

static void wide_proof(void)
{
    for (int k = 0; k < NODES; k++) node[k] = any_whole(INT32_MIN, INT32_MAX);
    for (int k = 0; k < ENTRIES; k++) row[k] = (uint16_t)any_whole(0, UINT16_MAX);
    any_numbers(y, ENTRIES);
    proof.nodes = any_whole(INT32_MIN, NODES); proof.entries = any_whole(INT32_MIN, ENTRIES);
    proof.node = node; proof.row = row; proof.y = y;
}

/* A certificate check whose scales are any numbers. */
static void wide_open(int32_t blocks, int32_t points, int32_t faces, int turned, sp_arena *a)
{
    wide_scene(blocks, points, faces, turned);
    sp__certifier_carve(&judge, &pb, faces, a);
    sp__certifier_cone(&judge, &pb, &set);
    for (int i = 0; i < blocks; i++) any_numbers(&judge.scale[i].load, (int)(sizeof *judge.scale / sizeof(sp_real)));
    any_numbers(judge.dual.motion, 6 * blocks);
    any_numbers(judge.correction, 6 * blocks);
    judge.total = any();
    judge.force_cap = any();
}

/* The scales themselves, from a hint of any numbers and without one, in up to SWEEPS sweeps. */
enum { SWEEPS = 1000000 };
void eva_wide_scale(void)
{
    static sp_real hint[12 * WIDE];
    sp_arena a = memory_of(0);
    /*@ widen_hints global:"all", 1000010; */
    wide_scene(WIDE, WIDE, 0, 0);
    any_numbers(hint, 12 * WIDE);
    sp__certifier_open(&judge, &pb, &set, any_whole(0, 1) ? hint : NULL, any_whole(0, SWEEPS), &a);
}

/* Triples of more vertices than there are proofs of: no spin is taken off. */
void eva_wide_triple(void)
{
    sp_arena a = memory_of(0);
    wide_open(WIDE, WIDE, 0, 0, &a);
    pb.contacts = WIDE;
    /*@ loop unroll 64; */
    for (int c = 0; c < WIDE; c++) contact[c].points = any_whole(2, EACH);
    const sp__lengths k = sp__coupled_lengths(&pb, &set);
    sp__certify_coupled(&judge, &k, f, dq, alpha);
}

/* Forces, motions, pressure. */
static void wide_forces(int32_t blocks, int32_t points, int32_t faces, int turned)
{
    int32_t final;
    sp_arena a = memory_of(0);
    wide_open(blocks, points, faces, turned, &a);
    sp__certify_forces(&judge, f, spare);
    sp__certify_mechanism(&judge, dq, any_whole(0, 1) ? SP__TOGETHER : 0, &final);
    sp__motion_write(&judge, dq);
    sp__certify_pressure(&judge, f, spare);
}

void eva_wide_forces(void) { wide_forces(WIDE, WIDE, 0, 0); }
void eva_wide_forces_turned(void) { wide_forces(WIDE, WIDE, 0, 1); }
void eva_wide_forces_faces(void) { wide_forces(WIDE, WIDE, SP__FACES_MAX, 0); }
void eva_wide_forces_one(void) { wide_forces(1, EACH, SP__FACES_MIN, 0); }

/* A refutation of all vertices, in any states. */
static void wide_refute(sp__refute *w, const sp__lengths *k, sp_arena *a)
{
    sp__refute_carve(w, WIDE, WIDE, a);
    w->j = &judge; w->k = k; w->proof = &proof;
    for (int v = 0; v < WIDE; v++) {
        w->contact[v] = any_whole(0, WIDE - 1); w->at[v] = any_whole(0, WIDE - 1);
        w->state[v] = any_whole(0, (1 << 27) - 1);
        w->F[v] = any(); w->any_friction[v] = any();
    }
    any_numbers(w->reach, 6 * WIDE);
    w->total = any(); w->slack_of_work = any();
}

static void wide_refute_leaf(int32_t faces, int turned)
{
    sp_arena a = memory_of(0);
    static sp__refute w;
    sp__lengths k;
    wide_open(WIDE, WIDE, faces, turned, &a);
    wide_proof();
    k.L = any(); k.eps = any(); k.eta = any();
    wide_refute(&w, &k, &a);
    sp__refute_leaf(&w, any_whole(0, ENTRIES), any_whole(0, ENTRIES));
}

void eva_wide_refute(void) { wide_refute_leaf(0, 1); }
void eva_wide_refute_exact(void) { wide_refute_leaf(8, 0); }
void eva_wide_refute_faces(void) { wide_refute_leaf(SP__FACES_MAX, 0); }

/* A walk of any tree of cases of all vertices, of at most NODES nodes: its stack has room for as many splits. */
void eva_wide_refute_walk(void)
{
    sp_arena a = memory_of(0);
    static sp__refute w;
    sp__lengths k;
    wide_open(WIDE, WIDE, 0, 0, &a);
    wide_proof();
    k.L = any(); k.eps = any(); k.eta = any();
    wide_refute(&w, &k, &a);
    if (proof.nodes > 0 && proof.entries >= 0) sp__refute_walk(&w);
}

static void wide_still(sp__still *w, sp_arena *a)
{
    sp__still_carve(w, SP__STILL_POINTS, SP__STILL_POINTS, a);
    w->j = &judge; w->M = inertia; w->proof = &proof;
    for (int v = 0; v < SP__STILL_POINTS; v++) {
        w->contact[v] = any_whole(0, SP__STILL_POINTS - 1); w->at[v] = any_whole(0, SP__STILL_POINTS - 1);
        w->state[v] = any_whole(0, 2 * SP__STILL_DEEP - 1);
    }
    w->delta = any();
}

static void wide_still_leaf(int turned)
{
    sp_arena a = memory_of(0);
    static sp__still w;
    wide_open(SP__STILL_POINTS, SP__STILL_POINTS, 0, turned, &a);
    wide_proof();
    wide_still(&w, &a);
    sp__still_delta(&judge, inertia);
    sp__still_reach(&w);
    sp__still_leaf(&w, any_whole(0, ENTRIES), any_whole(0, ENTRIES));
}

void eva_wide_still(void) { wide_still_leaf(0); }
void eva_wide_still_turned(void) { wide_still_leaf(1); }

/* A walk of any tree of at most 254 nodes, as many as its stack has room for. */
void eva_wide_still_walk(void)
{
    sp_arena a = memory_of(0);
    static sp__still w;
    wide_open(SP__STILL_POINTS, SP__STILL_POINTS, 0, 0, &a);
    wide_proof();
    wide_still(&w, &a);
    any_numbers(w.reach, 6 * SP__STILL_POINTS);
    if (proof.nodes > 0 && proof.nodes <= SP__STILL_DEPTH * SP__STILL_POINTS - 2 && proof.entries >= 0) sp__still_walk(&w);
}

/* All of it, of as many corners and blocks as there may be, of four joints. */
void eva_wide_still_whole(void)
{
    sp_arena a = memory_of(0);
    wide_open(SP__STILL_POINTS, SP__STILL_POINTS, 0, 0, &a);
    wide_proof();
    pb.contacts = SP__STILL_POINTS / EACH;
    /*@ loop unroll 16; */
    for (int c = 0; c < SP__STILL_POINTS / EACH; c++) contact[c].points = EACH;
    if (proof.nodes <= SP__STILL_DEPTH * SP__STILL_POINTS - 2) sp__certify_still(&judge, inertia, &proof, &a);
}

/* What slides, what moves from rest. */
static void wide_moving(int turned)
{
    sp_real share, moves;
    sp_arena a = memory_of(0);
    wide_open(WIDE, WIDE, 0, turned, &a);
    sp__certify_sliding(&judge, live, f, dq, &share);
    sp__certify_moving(&judge, inertia, f, dq, any_whole(0, 1), &moves);
}

void eva_wide_moving(void) { wide_moving(0); }
void eva_wide_moving_turned(void) { wide_moving(1); }

/* A form of shear of as many blocks as it is asked of, but for what adds up: how many pairs there are, how many blocks are
 * reached, where in the triangle the next number goes. */
void eva_wide_shear(void)
{
    sp_arena a = memory_of(0);
    static sp__shear w;
    wide_open(SP__SHEAR_BLOCKS, WIDE, 0, 0, &a);
    sp__shear_carve(&w, WIDE, WIDE, SP__SHEAR_BLOCKS, &a);
    w.j = &judge; w.M = inertia;
    sp__certifier_load_rows(&judge);
    if (!sp__shear_pairs(&w, f)) return;
    const int32_t c = any_whole(0, WIDE - 1);
    if (c >= pb.contacts || !sp__shear_joint(&w, &judge, c, f)) return;
    sp__shear_hang(&w, c, any_whole(0, SP__SHEAR_BLOCKS - 1));
    for (int k = 0; k < 6; k++)
        sp__shear_momentum(&w, 6 * any_whole(0, SP__SHEAR_BLOCKS - 1) + k, any_whole(0, 6 * SP__SHEAR_BLOCKS - 1));
    if (sp__shear_held(&w)) sp__shear_pushes(&w, live);
    sp__shear_slack(&w);
    sp__certify_forces(&judge, w.even, NULL);
}
