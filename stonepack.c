/* stonepack.c: the mechanics of rigid blocks, bottom-up; read it from the top like the paper. Mathematics that has never heard
 * of a stone is in solvers/ and comes first. `cc -O2 -ffp-contract=off -c stonepack.c` is the whole build.
 *
 *    1  words                            texts of enumerators
 *    2  scene, empty                     room for blocks and interfaces
 *    3  local coordinates                polygons seen from one of their points
 *    4  mesh and mass                    volume and centroid, closed and outward [seed 1.3]
 *    5  scene, blocks                    adding stones and supports
 *    6  scene, interfaces and loads      adding joints: frames, planarity; forces, couples, weights, pressures
 *    7  contacts                         what touches what: patches, box tree, clipping, overlaps
 *    8  problem                          a scene made ready: rows, arms, loads
 *    9  matrices                         Aeq, Afr [seed 1.1, 1.2, 1.4]
 *   10  certificate check                what forces and motions prove; shares nothing with the search
 *   11  the dual                         D(y), its gradient and Hessian, sizes and metric; planar and level scenes
 *   12  search constants                 and the table of the seed's
 *   13  gates                            no contact, no support, no load
 *   14  bilateral force                  least squares, sparse and dense [seed 2.1]
 *   15  polish                           alternating projections [seed 2.2]
 *   16  exact stage: search and proof
 *   17  exact stage: rigid groups
 *   18  exact stage: steps               semismooth Newton, proximal path
 *   19  exact stage: interior point      where Newton stalls
 *   20  exact stage: its run             in 6 rows a block, or in 3 where the scene lets them
 *   21  penalty form                     where help is wanted [seed 1.5]
 *   22  penalty program                  the same as a quadratic program [seed 1.5, 4]
 *   23  coupled check: exact decision    branch and bound over the states of joints
 *   24  coupled check                    a motion that explains the forces [seed 3]
 *   25  islands                          groups of free blocks that touch, each as a scene of its own
 *   26  ladder                           settings, stages, memory, judgement
 *   27  reading a result                 resultants, utilisation, weakest joint
 *   28  check                            sp_check
 *   29  verify                           sp_verify
 *   30  plan                             which effects a scene calls for, and what that saves
 *   31  placing a stone                  support, seats, resting faces, next-best-object gate [seed 6.1, 6.2]
 *   32  build order                      sp_sequence: islands, steps from the forces of the step before
 *   33  what to hold                     smallest sets of held blocks; what may come next
 *   34  limit: both ends                 sp_limit_verify
 *   35  limit: search                    sp_limit, sp_limit_memory; hinges and sliding joints of a motion
 *   36  smallest check                   SP_SMALL: sp_check, sp_memory, sp_plan by a search of its own; not 11, 13-28, 30
 *   37  smallest limit                   in place of 35
 *   38  smallest build order             in place of 32 and 33
 *
 * Symbols                       code            shape                           unit
 *   f; Aeq; p                   f; -; p         3 per vertex; 6b x 3v; 6b       N; 1 and m; N and N m
 *   delta q; u = -delta d       dq; u           6 per block; 3 per vertex       m and rad; m
 *   y, the dual of Aeq f + p    y = -dq         6b
 *   K, P_K, mu                  cone, project   cone of a vertex, nearest point
 *   b, v                        blocks, points  free blocks, contact vertices
 * A row of a block is (Fx Fy Fz Mx My Mz) about its centroid, a force (fn, ft1, ft2) acts on B, fn > 0 presses.
 *
 * Sources: [seed n] the document the system was specified by, section n; [DESIGN n] its design. The others by name:
 *   Kao, Iannuzzo, Thomaszewski, Coros, Van Mele, Block 2022, Computer-Aided Design 146:103216; Heyman 1966; Qi, Sun 1993,
 *   Math. Programming 58; Rockafellar 1976, SIAM J. Control Optim. 14; Amestoy, Davis, Duff 1996, SIAM J. Matrix Anal. 17;
 *   Hestenes, Stiefel 1952; Stiefel 1955; Dekker 1971, Numer. Math. 18; Davis 2006, Direct Methods for Sparse Linear Systems;
 *   George, Liu 1981, Computer Solution of Large Sparse Positive Definite Systems.
 */
#include "stonepack.h"

#include "solvers/arena.c"
#include "solvers/real.c"
#if !defined(SP_SMALL) || !defined(SP_NO_QP)
#include "solvers/order.c"
#include "solvers/chol.c"
#endif
#ifndef SP_NO_QP
#include "solvers/ldl.c"
#ifndef SP_QP_NO_CG
#include "solvers/cg.c"
#endif
#include "solvers/ruiz.c"
#include "solvers/qp.c"
#include "solvers/kkt.c"
#include "solvers/proof.c"
#include "solvers/auglag.c"
#include "solvers/admm.c"
#include "solvers/dykstra.c"
#endif
#ifndef SP_QP_ONLY
#include "solvers/vec3.c"
#include "solvers/csc.c"
#include "solvers/pyramid.c"
#ifdef SP_SMALL
#include "solvers/envelope.c"
#else
#include "solvers/cone.c"
#include "solvers/bchol.c"
#endif
#if !defined(SP_NO_IPM) && !defined(SP_SMALL)
#include "solvers/ipm.c"
#endif
#include "solvers/sort.c"
#include "solvers/hull.c"
#ifdef SP_SMALL
#include "solvers/convex.c"
#else
#include "solvers/clip.c"
#endif
#ifndef SP_NO_CRA
#include "solvers/lp.c"
#endif
#endif

/* 1 ---------------------------------------------------------------------------------------------------------------- words */

#ifdef SP_SMALL
#define SP__TOLD(text) ""                               /* told by other builds only, most of it of what this one does without */
#else
#define SP__TOLD(text) text
#endif

/* The k-th of zero-terminated words that follow each other: no table of pointers, so nothing to relocate. */
static const char *sp__word(const char *words, int k)
{
    for (; k > 0; k--) {
        while (*words) words++;
        words++;
    }
    return words;
}

/* In the order of the enumerators of stonepack.h. */
SP_API const char *sp_status_text(sp_status status)
{
    const int k = -(int)status;
    return sp__word("no error\0"
                    "bad argument" SP__TOLD(": a null pointer, a negative count or an unknown choice") "\0"
                    "not enough memory" SP__TOLD(" in the arena") "\0"
                    "the scene is full\0"
                    SP__TOLD("a number is ") "infinite" SP__TOLD(", not a number, or too large to be squared") "\0"
                    SP__TOLD("a block, vertex or interface of ") "that number does not exist\0"
                    SP__TOLD("a number is ") "outside its range\0"
                    "the mesh is open" SP__TOLD(": an edge lacks its opposite") "\0"
                    SP__TOLD("the mesh is inside out: ") "its faces look inward\0"
                    "the mesh encloses no volume" SP__TOLD(", or a face has fewer than three corners") "\0"
                    "a face is out of plane\0"
                    "the interface" SP__TOLD(" polygon") " is out of plane\0"
                    "the interface has no area" SP__TOLD(", or its normal no length") "\0"
                    SP__TOLD("an interface ") "between a block and itself\0"
                    SP__TOLD("the scene has ") "no block\0"
                    "not supported here"
                    SP__TOLD(": strength of joints with the coupled check, or a part this build leaves out") "\0"
                    "P" SP__TOLD(" of the quadratic program") " is not positive semidefinite\0"
                    "unknown status", k >= 0 && k <= 16 ? k : 17);
}

#ifndef SP_NO_QP
SP_API const char *sp_qp_status_text(sp_qp_status status)
{
    const int k = (int)status;
    return sp__word("solved\0" "inaccurate\0" "primal infeasible\0" "dual infeasible\0" "iteration limit\0" "budget\0" "numerical\0"
                    "unknown", k >= 0 && k <= 6 ? k : 7);
}
#endif

#ifndef SP_QP_ONLY                                       /* all that follows */

SP_API const char *sp_verdict_text(sp_verdict verdict)
{
    const int k = (int)verdict;
    return sp__word("undecided\0" "stable\0" "unstable\0" "unknown", k >= 0 && k <= 2 ? k : 3);
}

SP_API const char *sp_level_text(sp_level level)
{
    const int k = (int)level;
    return sp__word("none\0" "admissible\0" "coupled\0" "unknown", k >= 0 && k <= 2 ? k : 3);
}

SP_API const char *sp_reason_text(sp_reason reason)
{
    const int k = (int)reason;
    return sp__word("forces\0" "nothing to carry\0" "no contact\0" "no support\0" "mechanism\0" "limit\0" "budget\0" "stages\0"
                    SP__TOLD("no consistent motion") "\0" SP__TOLD("no coupled certificate") "\0" "tension\0" "unverified\0"
                    SP__TOLD("effect left out") "\0" "unknown",
                    k >= 0 && k <= 12 ? k : 13);
}

SP_API const char *sp_coupling_text(sp_coupling coupling)
{
    const int k = (int)coupling;
    return sp__word("not asked\0" SP__TOLD("coupled") "\0" SP__TOLD("refuted") "\0" SP__TOLD("not found") "\0" "unknown", k >= 0 && k <= 3 ? k : 4);
}

SP_API const char *sp_coupling_reason_text(sp_coupling_reason reason)
{
    const int k = (int)reason;
    return sp__word("not asked\0" SP__TOLD("motion") "\0" SP__TOLD("statics") "\0" SP__TOLD("no consistent motion") "\0" SP__TOLD("limit") "\0"
                    SP__TOLD("budget") "\0" "unknown",
                    k >= 0 && k <= 5 ? k : 6);
}

SP_API const char *sp_stage_text(sp_stage_id stage)
{
    const int k = (int)stage;
    return sp__word("none\0" "gates\0" SP__TOLD("least squares") "\0" SP__TOLD("dense") "\0" SP__TOLD("polish") "\0" "exact\0"
                    SP__TOLD("ADMM") "\0" SP__TOLD("custom") "\0" "unknown",
                    k >= 0 && k <= 7 ? k : 8);
}

SP_API const char *sp_effect_text(sp_effect effect)
{
    const int k = (int)effect;
    return sp__word("friction\0" "depth\0" "together\0" "strength\0" "loads\0" "live\0" "coupled\0" "dynamics\0"
                    "unknown", k >= 0 && k < SP_EFFECTS ? k : SP_EFFECTS);
}

SP_API int sp_effect_on(sp_effect_why why) { return why == SP_WHY_CALLED || why == SP_WHY_ASKED || why == SP_WHY_STAGES; }

SP_API const char *sp_effect_why_text(sp_effect_why why)
{
    const int k = (int)why;
    return sp__word("the scene calls for it\0" "the caller asks for it\0" SP__TOLD("left out by the caller") "\0" "not in this scene\0"
                    "not asked for\0" "statics asks for none\0" SP__TOLD("they share no free block; ") "each is solved alone\0"
                    SP__TOLD("stages or a budget that a plan leaves alone") "\0"
                    SP__TOLD("everything has one mirror plane: 3 rows a block") "\0"
                    SP__TOLD("level joints under plumb loads: pressure alone comes first") "\0"
                    SP__TOLD("contacts form a forest, or nothing need move: no search") "\0"
                    "unknown", k >= 0 && k <= (int)SP_WHY_FOREST ? k : (int)SP_WHY_FOREST + 1);
}

#ifndef SP_EXACT_ONLY
SP_API const char *sp_presence_text(sp_presence presence)
{
    const int k = (int)presence;
    return sp__word("absent\0" "present\0" "held\0" "unknown", k >= 0 && k <= 2 ? k : 3);
}

SP_API const char *sp_held_proof_text(sp_held_proof proof)
{
    const int k = (int)proof;
    return sp__word("minimal\0" "irreducible\0" "enough\0" "unknown", k >= 0 && k <= 2 ? k : 3);
}
#endif

/* 2 --------------------------------------------------------------------------------------------------------- scene, empty */

static void sp__scene_carve(sp_scene *scene, sp_arena *a)
{
    const sp_capacity *c = &scene->cap;
    scene->block = sp__take(a, (size_t)c->blocks, sizeof *scene->block);
    scene->vertex = sp__take(a, (size_t)c->vertices, sizeof *scene->vertex);
    scene->face = sp__take(a, (size_t)c->faces, sizeof *scene->face);
    scene->corner = sp__take(a, (size_t)c->corners, sizeof *scene->corner);
    scene->interface = sp__take(a, (size_t)c->interfaces, sizeof *scene->interface);
    scene->point = sp__take(a, (size_t)c->points, sizeof *scene->point);
    scene->load = sp__take(a, (size_t)c->loads, sizeof *scene->load);
}

static int sp__capacity_valid(const sp_capacity *c)
{
    return c && c->blocks >= 0 && c->vertices >= 0 && c->faces >= 0 && c->corners >= 0 && c->interfaces >= 0 && c->points >= 0
        && c->loads >= 0;
}

SP_API size_t sp_scene_memory(const sp_capacity *cap)
{
    if (!sp__capacity_valid(cap)) return 0;
    sp_scene scene;
    sp_arena dry = sp__arena_dry();
    scene.cap = *cap;
    sp__scene_carve(&scene, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

SP_API sp_status sp_scene_create(sp_scene *scene, const sp_capacity *cap, sp_arena *arena)
{
    if (!scene || !sp__capacity_valid(cap) || !arena || !arena->base) return SP_E_ARGUMENT;
    sp_arena a = *arena;
    sp_scene s;
    memset(&s, 0, sizeof s);
    s.gravity[2] = (sp_real)-9.80665;
    s.live = (sp_real)1;
    s.cap = *cap;
    sp__scene_carve(&s, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    *arena = a;
    *scene = s;
    return SP_OK;
}

/* 3 ---------------------------------------------------------------------------------------------------- local coordinates */

/* Points seen from the first of them, in units of a power of two: far or odd-sized coordinates lose nothing, and squares and
 * cubes of what is left can neither over- nor underflow. */
typedef struct sp__local {
    const sp_real *xyz;
    sp_real o[3], s;            /* origin and unit [m] */
    sp_real d;                  /* diagonal of the bounding box, 1 .. 2 sqrt(3), or 0                     [s] */
    sp_real coarse;             /* u (largest |coordinate|): what the coordinates themselves are good for [s] */
} sp__local;

static void sp__local_get(const sp__local *l, int32_t k, sp_real p[3])
{
    for (int c = 0; c < 3; c++) p[c] = (l->xyz[3 * (size_t)k + (size_t)c] - l->o[c]) / l->s;
}

/* The k-th of picked points; pick NULL: of all. */
static void sp__local_pick(const sp__local *l, const int32_t *pick, int32_t k, sp_real p[3])
{
    sp__local_get(l, pick ? pick[k] : k, p);
}

/* Largest power of two not above x, x finite and > 0. */
static sp_real sp__power_of_two(sp_real x)
{
    sp_real s = (sp_real)1;
    while (s <= x / 2) s *= 2;
    while (s > x) s /= 2;
    return s;
}

/* Of the `count` >= 1 points pick[0], pick[1] ... (pick NULL: 0, 1 ...). SP_E_NOT_FINITE: they are too far apart. */
static sp_status sp__local_start(sp__local *l, const sp_real *xyz, const int32_t *pick, int32_t count)
{
    sp_real extent[3], far = 0, most = 0;
    l->xyz = xyz;
    l->s = (sp_real)1;
    for (int c = 0; c < 3; c++) {
        const sp_real *at = xyz + c;
        sp_real lo = at[3 * (size_t)(pick ? pick[0] : 0)], hi = lo;
        l->o[c] = lo;
        for (int32_t k = 1; k < count; k++) {
            const sp_real x = at[3 * (size_t)(pick ? pick[k] : k)];
            if (x < lo) lo = x;
            if (x > hi) hi = x;
        }
        extent[c] = hi - lo;
        most = sp__max(most, extent[c]);
        far = sp__max(far, sp__max(sp__abs(lo), sp__abs(hi)));
    }
    if (!sp__finite(2 * most)) return SP_E_NOT_FINITE;
    if (most > 0) l->s = sp__power_of_two(most);
    for (int c = 0; c < 3; c++) extent[c] /= l->s;
    l->d = sp__norm3(extent);
    l->coarse = SP_EPSILON * (far / l->s);
    return SP_OK;
}

/* 4 -------------------------------------------------------------------------------------------------------- mesh and mass */

/* What is asked of every mesh, supports too: numbers are numbers, faces have corners, corners exist. */
static sp_status sp__mesh_check(const sp_mesh *mesh, int32_t *corners)
{
    if (!mesh || mesh->vertices < 0 || mesh->faces < 0 || (mesh->vertices > 0 && !mesh->xyz)) return SP_E_ARGUMENT;
    if (mesh->faces > 0 && (!mesh->size || !mesh->corner)) return SP_E_ARGUMENT;
    if (!sp__all_finite(mesh->xyz, 3 * (size_t)mesh->vertices)) return SP_E_NOT_FINITE;
    int32_t sum = 0;
    for (int32_t k = 0; k < mesh->faces; k++) {
        if (mesh->size[k] < 3) return SP_E_DEGENERATE;
        if (mesh->size[k] > INT32_MAX - sum) return SP_E_ARGUMENT;
        sum += mesh->size[k];
    }
    for (int32_t k = 0; k < sum; k++)
        if (mesh->corner[k] < 0 || mesh->corner[k] >= mesh->vertices) return SP_E_INDEX;
    *corners = sum;
    return mesh->vertices > 0 ? SP_OK : SP_E_DEGENERATE;
}

/* Scrambles 64 bits one to one.                                                        [Stafford 2011, variant 13] */
static uint64_t sp__mix(uint64_t h)
{
    h = (h ^ (h >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    h = (h ^ (h >> 27)) * UINT64_C(0x94d049bb133111eb);
    return h ^ (h >> 31);
}

/* A number for a place. Equal coordinates give equal numbers, -0 counts as 0; taken from values, so byte order is no matter. */
static uint64_t sp__place_hash(const sp_real x[3])
{
    uint64_t h = 0;
    for (int c = 0; c < 3; c++) {
        const sp_real v = x[c] + (sp_real)0;            /* -0 + 0 = +0 */
#ifdef SP_REAL_FLOAT
        uint32_t bits;
#else
        uint64_t bits;
#endif
        memcpy(&bits, &v, sizeof bits);
        h = sp__mix(h + UINT64_C(0x9e3779b97f4a7c15) + bits);
    }
    return h;
}

/* Closed: every directed edge p -> q has its opposite. Give each edge g(p, q) = -g(q, p) = F(p, q) - F(q, p) with a scrambling
 * F of the end points' places; then opposite edges cancel, and anything left over leaves a sum that is 0 by accident once in
 * 2^64. It needs no memory, one pass, and takes vertices of equal coordinates for the same without welding them. */
static int sp__mesh_closed(const sp_mesh *mesh)
{
    uint64_t sum = 0;
    const int32_t *corner = mesh->corner;
    for (int32_t k = 0; k < mesh->faces; corner += mesh->size[k++]) {
        uint64_t p = sp__place_hash(mesh->xyz + 3 * (size_t)corner[mesh->size[k] - 1]);
        for (int32_t i = 0; i < mesh->size[k]; i++) {
            const uint64_t q = sp__place_hash(mesh->xyz + 3 * (size_t)corner[i]);
            sum += sp__mix(p + sp__mix(q)) - sp__mix(q + sp__mix(p));
            p = q;
        }
    }
    return sum == 0;
}

/* Mean of points, local. */
static void sp__local_mean(const sp__local *l, const int32_t *pick, int32_t count, sp_real m[3])
{
    m[0] = m[1] = m[2] = 0;
    for (int32_t k = 0; k < count; k++) {
        sp_real p[3];
        sp__local_pick(l, pick, k, p);
        sp__add3(m, 1, p);
    }
    sp__scale3((sp_real)1 / (sp_real)count, m, m);
}

/* Farthest corner from the plane through m with normal n, times |n|; reach: the farthest from m. */
static sp_real sp__local_warp(const sp__local *l, const int32_t *pick, int32_t count, const sp_real m[3], const sp_real n[3],
                              sp_real *reach)
{
    sp_real most = 0, far = 0;
    for (int32_t k = 0; k < count; k++) {
        sp_real p[3];
        sp__local_pick(l, pick, k, p);
        sp__sub3(p, m, p);
        most = sp__max(most, sp__abs(sp__dot3(p, n)));
        far = sp__max(far, sp__dot3(p, p));
    }
    *reach = SP_SQRT(far);
    return most;
}

/* Sums over triangles, local: 6V in mass->volume, 24 V c in mass->centroid, 2A; n: twice the vector area of the running face. */
typedef struct sp__solid { sp_mass *mass; sp_real area, n[3]; } sp__solid;

/* Triangle of m and the corners i, j. */
SP__APART static void sp__solid_triangle(sp__solid *t, const sp__local *l, const sp_real m[3], int32_t i, int32_t j)
{
    sp_real p[3], q[3], n[3] = { 0, 0, 0 };
    sp__local_get(l, i, p);
    sp__local_get(l, j, q);
    sp__cross3_add(p, q, n);
    const sp_real v = sp__dot3(m, n);                   /* m . (p x q) */
    t->mass->volume += v;
    sp__cross3_add(m, p, n);
    sp__cross3_add(q, m, n);                            /* m x p + p x q + q x m = (p - m) x (q - m) */
    sp__add3(p, 1, m);
    sp__add3(p, 1, q);
    sp__add3(t->mass->centroid, v, p);
    t->area += sp__norm3(n);
    sp__add3(t->n, 1, n);
}

/* A triangle as it is, a larger polygon fanned about its vertex mean m. Then each of its corners p has to be within 1e-2 of the
 * block's diameter from its plane. What rounding alone may do to (p - m) . n is allowed on top, so a face without area, which
 * has no plane, passes. */
SP__APART static sp_status sp__solid_face(sp__solid *t, const sp__local *l, const int32_t *corner, int32_t corners)
{
    sp_real m[3], reach;
    if (corners == 3) {
        sp__local_get(l, corner[0], m);
        sp__solid_triangle(t, l, m, corner[1], corner[2]);
        return SP_OK;
    }
    sp__local_mean(l, corner, corners, m);
    t->n[0] = t->n[1] = t->n[2] = 0;
    for (int32_t k = 0; k < corners; k++) sp__solid_triangle(t, l, m, corner[k > 0 ? k - 1 : corners - 1], corner[k]);
    const sp_real out = sp__local_warp(l, corner, corners, m, t->n, &reach);
    const sp_real noise = 16 * (sp_real)corners * (l->coarse + SP_EPSILON * l->d) * l->d * reach;
    return out > (sp_real)1e-2 * l->d * sp__norm3(t->n) + noise ? SP_E_WARPED : SP_OK;
}

/* Is 6V more than error? Coordinates good to e leave the volume of a surface A uncertain by e A, and rounding here acts as if
 * the corners had moved by u d; measured on flat bodies of all shapes and places: `least` / `sure` at most. So a body
 * that passes has its volume to a percent in double; float takes what can be told from flat at all, plates of 1e-6 among it. */
static sp_status sp__solid_judge(const sp__solid *t, const sp__local *l)
{
#ifdef SP_REAL_FLOAT
    const sp_real sure = (sp_real)1;
#else
    const sp_real sure = (sp_real)50;
#endif
    const sp_real least = 3 * sure * (l->coarse + SP_EPSILON * l->d) * t->area;
    if (t->mass->volume > least) return SP_OK;
    return t->mass->volume < -least ? SP_E_INWARD : SP_E_DEGENERATE;
}

/* Volume, centroid and size of a checked mesh. The diameter is set whenever it is a number. */
static sp_status sp__mesh_measure(const sp_mesh *mesh, int32_t corners, sp_mass *mass)
{
    sp__local l;
    sp__solid t = { mass, 0, { 0, 0, 0 } };
    if (sp__local_start(&l, mesh->xyz, corners ? mesh->corner : NULL, corners ? corners : mesh->vertices)) return SP_E_NOT_FINITE;
    mass->volume = mass->centroid[0] = mass->centroid[1] = mass->centroid[2] = 0;
    mass->diameter = l.d * l.s;
    if (!sp__finite(mass->diameter * mass->diameter * mass->diameter)) return SP_E_NOT_FINITE;
    const int32_t *corner = mesh->corner;
    for (int32_t k = 0; k < mesh->faces; corner += mesh->size[k++]) {
        const sp_status status = sp__solid_face(&t, &l, corner, mesh->size[k]);
        if (status) return status;
    }
    if (!sp__mesh_closed(mesh)) return SP_E_OPEN;
    const sp_status status = sp__solid_judge(&t, &l);
    if (status) return status;
    for (int c = 0; c < 3; c++) mass->centroid[c] = l.o[c] + l.s * (mass->centroid[c] / (4 * mass->volume));
    mass->volume = mass->volume / 6 * l.s * l.s * l.s;
    return mass->volume > 0 ? SP_OK : SP_E_DEGENERATE;  /* underflow */
}

SP_API sp_status sp_mesh_mass(const sp_mesh *mesh, sp_mass *mass)
{
    int32_t corners;
    sp_mass found;
    if (!mass) return SP_E_ARGUMENT;
    sp_status status = sp__mesh_check(mesh, &corners);
    if (!status) status = sp__mesh_measure(mesh, corners, &found);
    if (!status) *mass = found;
    return status;
}

/* A support need not enclose anything: then it has no mass and sits at its vertex mean. */
static sp_status sp__mesh_support(const sp_mesh *mesh, int32_t corners, sp_mass *mass)
{
    const sp_status status = sp__mesh_measure(mesh, corners, mass);
    if (status != SP_E_OPEN && status != SP_E_INWARD && status != SP_E_DEGENERATE) return status;
    sp__local l;
    if (sp__local_start(&l, mesh->xyz, NULL, mesh->vertices)) return SP_E_NOT_FINITE;
    sp__local_mean(&l, NULL, mesh->vertices, mass->centroid);
    for (int c = 0; c < 3; c++) mass->centroid[c] = l.o[c] + l.s * mass->centroid[c];
    mass->volume = 0;
    return SP_OK;
}

/* 5 -------------------------------------------------------------------------------------------------------- scene, blocks */

/* Copy a mesh into the scene; room was checked. */
static void sp__scene_copy(sp_scene *scene, const sp_mesh *mesh, int32_t corners)
{
    sp_capacity *n = &scene->count;
    if (mesh->vertices) memcpy(scene->vertex + n->vertices, mesh->xyz, (size_t)mesh->vertices * sizeof *scene->vertex);
    for (int32_t k = 0; k < corners; k++) scene->corner[n->corners + k] = n->vertices + mesh->corner[k];
    for (int32_t k = 0; k < mesh->faces; k++) {
        scene->face[n->faces + k].corner = n->corners;
        scene->face[n->faces + k].corners = mesh->size[k];
        n->corners += mesh->size[k];
    }
    n->vertices += mesh->vertices;
    n->faces += mesh->faces;
}

static int sp__scene_room(const sp_scene *scene, const sp_mesh *mesh, int32_t corners)
{
    const sp_capacity *cap = &scene->cap, *n = &scene->count;
    return n->blocks < cap->blocks && mesh->vertices <= cap->vertices - n->vertices
        && mesh->faces <= cap->faces - n->faces && corners <= cap->corners - n->corners;
}

/* The next block, without mesh; room was checked. */
static sp_block *sp__block_add(sp_scene *scene, sp_real mass, const sp_real centroid[3], uint32_t fixed, int32_t *id)
{
    sp_block *k = &scene->block[scene->count.blocks];
    memset(k, 0, sizeof *k);
    k->mass = mass;
    memcpy(k->centroid, centroid, sizeof k->centroid);
    k->fixed = fixed;
    k->vertex = scene->count.vertices;
    k->face = scene->count.faces;
    if (id) *id = scene->count.blocks;
    scene->count.blocks++;
    return k;
}

SP_API sp_status sp_scene_block(sp_scene *scene, const sp_mesh *mesh, sp_real density, uint32_t fixed, int32_t *id)
{
    int32_t corners;
    sp_mass m;
    if (!scene) return SP_E_ARGUMENT;
    sp_status status = sp__mesh_check(mesh, &corners);
    if (status) return status;
    if (!sp__finite(density)) return SP_E_NOT_FINITE;
    if (!(density > 0) || fixed > SP_FIXED) return SP_E_RANGE;
    status = fixed == SP_FIXED ? sp__mesh_support(mesh, corners, &m) : sp__mesh_measure(mesh, corners, &m);
    if (status) return status;
    const sp_real mass = density * m.volume;
    if (!sp__finite(mass)) return SP_E_NOT_FINITE;
    if (!(mass > 0) && fixed != SP_FIXED) return SP_E_DEGENERATE;       /* underflow */
    if (!sp__scene_room(scene, mesh, corners)) return SP_E_CAPACITY;
    sp_block *k = sp__block_add(scene, mass, m.centroid, fixed, id);
    k->density = density;
    k->volume = m.volume;
    k->diameter = m.diameter;
    k->vertices = mesh->vertices;
    k->faces = mesh->faces;
    sp__scene_copy(scene, mesh, corners);
    return SP_OK;
}

SP_API sp_status sp_scene_body(sp_scene *scene, sp_real mass, const sp_real centroid[3], uint32_t fixed, int32_t *id)
{
    if (!scene || !centroid) return SP_E_ARGUMENT;
    if (!sp__finite(mass) || !sp__finite3(centroid)) return SP_E_NOT_FINITE;
    if (mass < 0 || (!(mass > 0) && fixed != SP_FIXED) || fixed > SP_FIXED) return SP_E_RANGE;
    if (scene->count.blocks >= scene->cap.blocks) return SP_E_CAPACITY;
    (void)sp__block_add(scene, mass, centroid, fixed, id);
    return SP_OK;
}

/* 6 ------------------------------------------------------------------------------------------ scene, interfaces and loads */

SP_API sp_joint sp_joint_friction(sp_real mu)
{
    const sp_joint joint = { mu, 0, 0, 0 };
    return joint;
}

static sp_status sp__joint_check(const sp_joint *joint)
{
    const sp_real rest[3] = { joint->cohesion, joint->tension, joint->cap };
    if (!sp__finite(joint->mu) || !sp__finite3(rest)) return SP_E_NOT_FINITE;
    return joint->mu >= 0 && rest[0] >= 0 && rest[1] >= 0 && rest[2] >= 0 ? SP_OK : SP_E_RANGE;
}

/* Has a joint strength beyond friction, or less than any? */
SP__CALLED static int sp__joint_strong(const sp_joint *joint) { return joint->cohesion > 0 || joint->tension > 0 || joint->cap > 0; }

static int sp__scene_strong(const sp_scene *scene)
{
    for (int32_t k = 0; k < scene->count.interfaces; k++) if (sp__joint_strong(&scene->interface[k].joint)) return 1;
    return 0;
}

/* What one vertex of a joint can carry [N]: the joint's strength over its share of the area, the same for every vertex.
 *   |ft| <= C + mu fn,  -T <= fn <= N,  T <= C / mu                                                       [Mohr, Coulomb]
 * endless: only its directions without end, forces that may be added as often as one likes: as if it had no area. */
typedef struct sp__strength { sp_real C, T, N; } sp__strength;

static sp__strength sp__vertex_strength(const sp_interface *f, int endless)
{
    const sp_real share = endless ? 0 : f->area / (sp_real)f->points;
    sp__strength k = { f->joint.cohesion * share, f->joint.tension * share, f->joint.cap > 0 ? f->joint.cap * share : SP__HUGE };
    if (k.T * f->joint.mu > k.C) k.T = k.C / f->joint.mu;
    return k;
}

/* Is K_v of a contact more or less than a cone? */
static int sp__contact_strong(const sp_problem *pb, const sp_contact *t)
{
    return pb->endless ? t->joint->joint.cap > 0 : sp__joint_strong(&t->joint->joint);
}

/* Twice the vector area of a polygon, sum p x q over its edges, and its perimeter; local.           [Newell's normal] */
static sp_real sp__polygon_normal(const sp__local *l, const int32_t *pick, int32_t points, sp_real n[3])
{
    sp_real p[3], q[3], perimeter = 0;
    n[0] = n[1] = n[2] = 0;
    sp__local_pick(l, pick, points - 1, p);
    for (int32_t k = 0; k < points; k++) {
        sp__local_pick(l, pick, k, q);
        sp__cross3_add(p, q, n);
        sp__sub3(q, p, p);
        perimeter += sp__norm3(p);
        for (int c = 0; c < 3; c++) p[c] = q[c];
    }
    return perimeter;
}

/* t1 along the first edge longer than 1e-9 of the perimeter, made orthogonal to n (unit); an edge that stands across the plane
 * by more than it lies in it (it can be that short) is passed over. */
static void sp__polygon_tangent(const sp__local *l, int32_t points, sp_real perimeter, const sp_real n[3], sp_real t[3])
{
    sp_real p[3], q[3];
    sp__local_get(l, 0, p);
    for (int32_t k = 1; k <= points; k++) {
        sp__local_get(l, k < points ? k : 0, q);
        sp__sub3(q, p, t);
        const sp_real length = sp__norm3(t), out = sp__dot3(t, n);
        sp__add3(t, -out, n);
        memcpy(p, q, sizeof p);
        const sp_real in = sp__norm3(t);
        if (length > (sp_real)1e-9 * perimeter && in > length / 2) {
            sp__unit3(t, t);
            return;
        }
    }
    sp__across3(n, t);
}

/* Normal, tangents and area of a contact polygon; plane to 1e-6 of its diameter and what its coordinates are good for. */
static sp_status sp__polygon_frame(int32_t points, const sp_real *xyz, sp_interface *f)
{
    sp__local l;
    sp_real m[3], reach;
    if (sp__local_start(&l, xyz, NULL, points)) return SP_E_NOT_FINITE;
    const sp_real perimeter = sp__polygon_normal(&l, NULL, points, f->n), twice = sp__norm3(f->n);
    const sp_real noise = 4 * (l.coarse + SP_EPSILON * l.d);
    if (!(twice > noise * perimeter)) return SP_E_AREA;
    f->area = twice / 2 * l.s * l.s;
    if (!sp__finite(f->area)) return SP_E_NOT_FINITE;
    if (!(f->area > 0)) return SP_E_AREA;               /* underflow */
    sp__unit3(f->n, f->n);
    sp__local_mean(&l, NULL, points, m);
    if (sp__local_warp(&l, NULL, points, m, f->n, &reach) > (sp_real)1e-6 * l.d + noise) return SP_E_PLANE;
    sp__polygon_tangent(&l, points, perimeter, f->n, f->t1);
    sp__cross3(f->n, f->t1, f->t2);
    return SP_OK;
}

/* The same for points that share a given normal of any length. */
static sp_status sp__points_frame(const sp_real n[3], sp_interface *f)
{
    const sp_real most = sp__max(sp__abs(n[0]), sp__max(sp__abs(n[1]), sp__abs(n[2])));
    if (!sp__finite3(n)) return SP_E_NOT_FINITE;
    if (!(most > 0)) return SP_E_AREA;
    const sp_real s = sp__power_of_two(most);
    for (int c = 0; c < 3; c++) f->n[c] = n[c] / s;
    sp__unit3(f->n, f->n);
    sp__across3(f->n, f->t1);
    sp__cross3(f->n, f->t1, f->t2);
    f->area = 0;
    return SP_OK;
}

/* What polygons and points have in common. The new interface is made in the scene's next free place, which is nobody's until
 * sp__interface_add counts it. */
static sp_status sp__interface_start(sp_scene *scene, int32_t a, int32_t b, int32_t points, const sp_real *xyz,
                                     const sp_joint *joint)
{
    if (!scene || !xyz || !joint || points < 0) return SP_E_ARGUMENT;
    if (a < 0 || b < 0 || a >= scene->count.blocks || b >= scene->count.blocks) return SP_E_INDEX;
    if (a == b) return SP_E_SELF;
    const sp_status status = sp__joint_check(joint);
    if (status) return status;
    if (!sp__all_finite(xyz, 3 * (size_t)points)) return SP_E_NOT_FINITE;
    const sp_capacity *n = &scene->count;
    if (n->interfaces >= scene->cap.interfaces || points > scene->cap.points - n->points) return SP_E_CAPACITY;
    sp_interface *f = &scene->interface[n->interfaces];
    f->a = a; f->b = b;
    f->point = n->points;
    f->points = points;
    f->joint = *joint;
    return SP_OK;
}

static void sp__interface_add(sp_scene *scene, int32_t points, const sp_real *xyz, int32_t *id)
{
    memcpy(scene->point + scene->count.points, xyz, (size_t)points * sizeof *scene->point);
    if (id) *id = scene->count.interfaces;
    scene->count.interfaces++;
    scene->count.points += points;
}

SP_API sp_status sp_scene_interface(sp_scene *scene, int32_t a, int32_t b, int32_t points, const sp_real *xyz,
                                    const sp_joint *joint, int32_t *id)
{
    sp_status status = sp__interface_start(scene, a, b, points, xyz, joint);
    if (!status) status = points < 3 ? SP_E_AREA : sp__polygon_frame(points, xyz, &scene->interface[scene->count.interfaces]);
    if (!status) sp__interface_add(scene, points, xyz, id);
    return status;
}

SP_API sp_status sp_scene_points(sp_scene *scene, int32_t a, int32_t b, const sp_real n[3], int32_t points,
                                 const sp_real *xyz, const sp_joint *joint, int32_t *id)
{
    if (!n) return SP_E_ARGUMENT;
    sp_status status = sp__interface_start(scene, a, b, points, xyz, joint);
    if (!status) status = points < 1 ? SP_E_RANGE : sp__points_frame(n, &scene->interface[scene->count.interfaces]);
    if (!status && sp__joint_strong(joint)) status = SP_E_AREA;         /* strength is per area */
    if (!status) sp__interface_add(scene, points, xyz, id);
    return status;
}

SP_API sp_status sp_scene_friction(sp_scene *scene, sp_real mu)
{
    if (!scene) return SP_E_ARGUMENT;
    if (!sp__finite(mu)) return SP_E_NOT_FINITE;
    if (mu < 0) return SP_E_RANGE;
    for (int32_t k = 0; k < scene->count.interfaces; k++) scene->interface[k].joint.mu = mu;
    return SP_OK;
}

SP_API sp_status sp_scene_load(sp_scene *scene, const sp_load *load, int32_t *id)
{
    if (!scene || !load) return SP_E_ARGUMENT;
    if (load->block < 0 || load->block >= scene->count.blocks) return SP_E_INDEX;
    if (!sp__finite3(load->point) || !sp__finite3(load->force) || !sp__finite3(load->couple) || !sp__finite(load->mass))
        return SP_E_NOT_FINITE;
    if (load->mass < 0) return SP_E_RANGE;
    if (scene->count.loads == scene->cap.loads) return SP_E_CAPACITY;
    if (id) *id = scene->count.loads;
    scene->load[scene->count.loads++] = *load;
    return SP_OK;
}

/* Area vector of a face and its centroid seen from its first corner o, both by triangles (o, b, c) of area vector t:
 *   sum t,  sum (t . n)(b + c) / (3 sum t . n)                                                      returns 0: no area */
static int sp__face_area(const sp_scene *scene, const sp_face *face, sp_real area[3], sp_real centroid[3])
{
    const int32_t *corner = scene->corner + face->corner;
    const sp_real *o = scene->vertex[corner[0]];
    sp_real sum = 0;
    for (int q = 0; q < 3; q++) area[q] = centroid[q] = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t k = 1; k + 1 < face->corners; k++) {
            sp_real b[3], c[3], t[3];
            sp__sub3(scene->vertex[corner[k]], o, b);
            sp__sub3(scene->vertex[corner[k + 1]], o, c);
            sp__cross3(b, c, t);
            const sp_real weight = sp__dot3(t, area);
            sp__add3(b, 1, c);
            if (pass) { sp__add3(centroid, weight, b); sum += weight; }
            else sp__add3(area, (sp_real)0.5, t);
        }
    for (int q = 0; q < 3; q++) centroid[q] = o[q] + centroid[q] / ((sp_real)3 * sum);
    return sum > 0 && sp__finite3(centroid);
}

SP_API sp_status sp_scene_pressure(sp_scene *scene, int32_t block, int32_t face, sp_real pressure, int32_t live, int32_t *id)
{
    if (!scene) return SP_E_ARGUMENT;
    if (block < 0 || block >= scene->count.blocks || face < 0 || face >= scene->block[block].faces) return SP_E_INDEX;
    sp_load load;
    sp_real area[3];
    memset(&load, 0, sizeof load);
    load.block = block;
    load.live = live;
    if (!sp__face_area(scene, &scene->face[scene->block[block].face + face], area, load.point)) return SP_E_AREA;
    sp__scale3(-pressure, area, load.force);
    return sp_scene_load(scene, &load, id);
}

/* 7 ------------------------------------------------------------------------------------------------------------- contacts */

/* Which faces of which blocks touch, and in what polygons.
 *
 *   patch      all faces of one block in one plane and with one direction; bounded by the edges that do not cancel
 *   bound      boundary edges of the patches, vertex numbers of the scene, patch on the left seen from outside
 *   noise      16 u (|coordinate| + diameter): no tolerance is below it, so float and far coordinates work          [m]
 *   near       settings' distance of a pair of blocks, at least the noise                                           [m]
 *
 *   distance   of two patches: along A's normal, in the middle of what they share; the angle bounds the rest
 *   in-plane   corners nearer than min(near, 1e-6 diameter)/8 are one; what is narrower than `near` is an edge contact, and
 *              left out
 *
 * Boxes in a balanced tree by Morton order find the pairs, n log n whatever the sizes are mixed like; a slab under everything
 * costs its own pairs and no more.
 *
 * SP_SMALL takes every face for a patch, and for what the patches of one plane share with a block its convex hull: that carries
 * the same, for a force at a point of it is a sum of forces at its corners. How narrow it is, is asked of the hull, for faces may
 * be narrow that together are not; a narrow piece of two faces that are not is an edge contact. Nothing is sorted, every pair of
 * blocks is asked.
 */

typedef struct sp__patch {
    sp_real n[3], o[3];         /* plane: outward unit normal and a point of the largest face */
    sp_real lo[3], hi[3];       /* box */
    int32_t edge, edges;        /* its part of bound */
#ifdef SP_SMALL
    int32_t plane;              /* the first patch of its block in its plane */
#endif
} sp__patch;

typedef struct sp__body {       /* what the search knows of a block */
    sp_real lo[3], hi[3];       /* box, of its faces only */
    sp_real noise, reach;       /* see above; its own settings' distance */
    sp_real warp;               /* farthest corner of a face from the face's plane */
    int32_t patch, patches, edge, edges;
    int32_t convex;             /* closed and nothing beyond any of its faces */
} sp__body;

#ifndef SP_SMALL
typedef struct sp__found { int32_t start, size; } sp__found;    /* a polygon of the present pair */

/* The largest of a number over the blocks, and the largest of the others. */
typedef struct sp__two { int32_t first, second; } sp__two;

/* Edges of one patch, of a block; patches of a block. */
typedef struct sp__most { sp__two side, total, patches; } sp__most;
#endif

/* Memory of the search. */
typedef struct sp__all {
    sp__body *body;
    sp__patch *patch;
    int32_t (*bound)[2];
#ifndef SP_SMALL
    int32_t *same;                              /* vertex -> the vertex that stands for all at its place */
    int32_t *order, *mine;                      /* of one block: vertices, faces or edges in order; face -> patch */
    int32_t (*edge)[2];                         /* of one block */
    sp_real (*normal)[3], (*middle)[3], *area;  /* of the faces of one block */
    int32_t *hit;                               /* blocks that may touch the present one */
    int32_t width;                              /* of the tree: power of two, not below the number of blocks */
    sp_real (*box)[6];                          /* of the tree's nodes, 1 the top, children 2k and 2k + 1 */
    int32_t *leaf;                              /* block of each leaf */
    uint32_t *code;                             /* Morton code of each block */
#endif
} sp__all;

/* Memory of one pair of blocks. */
typedef struct sp__pair {
    sp_real (*point)[3];                        /* polygons found; of SP_SMALL one */
#ifdef SP_SMALL
    sp__hull hull;                              /* that one, in its plane */
    int32_t corners, parts;                     /* of it; of the same plane, appended before it for want of room */
#else
    int32_t *near_a, *near_b;                   /* patches near the other block's box */
    sp__found *found;
    int32_t *rank;                              /* their order */
    int32_t room;                               /* of them, and of points */
#endif
} sp__pair;

typedef struct sp__touch {
    sp_scene *scene;
    sp_contact_settings set;
    sp_contact_report report;
    sp_capacity before;                         /* the scene's count at the start */
    sp_status status;
    int32_t full;                               /* the scene had no room for something */
    sp__all all;
    sp__clip clip;
    sp__pair pair;
#ifndef SP_SMALL
    sp__most most;
    int32_t leaves, edges;                      /* of the tree; of the faces of a patch */
    sp_real lo[3], hi[3];                       /* box of everything */
    int32_t points, founds;                     /* what was found of the present pair */
#endif
    int32_t patches, bounds;
    int32_t block, vertex0, face0;              /* of the block whose patches are being made */
    int32_t a, b;                               /* present pair */
    sp_real near, noise, snap, unit;            /* of that pair; unit: length of 1 in the plane of the clipping [m] */
    sp_real e1[3], e2[3];                       /* axes of that plane */
} sp__touch;

SP_API sp_contact_settings sp_contact_settings_default(void)
{
    sp_contact_settings s;
    memset(&s, 0, sizeof s);
    s.distance = (sp_real)1e-6;
    s.angle = (sp_real)1e-3;
    s.joint.mu = (sp_real)0.84;
    return s;
}

/* ------------------------------------------------------------------------------------------------------------- memory */

#ifdef SP_SMALL
/* Everything: of a pair there are never more than two faces at once, and the hull of what some of them share. */
static void sp__touch_carve(sp__all *l, sp__clip *clip, sp__pair *pair, const sp_scene *scene, sp_arena *a)
{
    const sp_capacity *n = &scene->count;
    int32_t side = 16;                          /* at least: for the hull of many small faces */
    for (int32_t f = 0; f < n->faces; f++) if (scene->face[f].corners > side) side = scene->face[f].corners;
    l->body = sp__take(a, (size_t)n->blocks, sizeof *l->body);
    l->patch = sp__take(a, (size_t)n->faces, sizeof *l->patch);
    l->bound = sp__take(a, (size_t)n->corners, sizeof *l->bound);
    sp__clip_carve(clip, side, side, a);
    pair->point = sp__take(a, (size_t)clip->cap, sizeof *pair->point);
    sp__hull_carve(&pair->hull, clip->cap, a);
}

SP_API size_t sp_contacts_memory(const sp_scene *scene)
{
    sp_arena dry = sp__arena_dry();
    struct { sp__all all; sp__clip clip; sp__pair pair; } none;
    if (!scene) return 0;
    (void)sp__take(&dry, 1, sizeof(sp__touch));
    sp__touch_carve(&none.all, &none.clip, &none.pair, scene, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}
#else
/* Crossings of boundaries of p and q edges that there is room for: all up to 16-gons; otherwise 8 (p + q), four times what a
 * convex one can have with any other. Combs across combs may need more: SP_E_MEMORY. */
static int64_t sp__crossings(const sp__two *t)
{
    const int64_t all = (int64_t)t->first * t->second, most = 8 * ((int64_t)t->first + t->second);
    return all < most ? all : most;
}

static void sp__two_add(sp__two *t, int32_t x)
{
    if (x > t->first) { t->second = t->first; t->first = x; }
    else if (x > t->second) t->second = x;
}

/* Corners of the faces of a block. */
static int32_t sp__block_corners(const sp_scene *scene, int32_t block)
{
    const sp_face *f = scene->face + scene->block[block].face;
    const int32_t n = scene->block[block].faces;
    return n ? f[n - 1].corner + f[n - 1].corners - f[0].corner : 0;
}

static void sp__all_carve(sp__all *l, const sp_scene *scene, sp_arena *a)
{
    const sp_capacity *n = &scene->count;
    int32_t vertices = 0, faces = 0, corners = 0;
    for (int32_t i = 0; i < n->blocks; i++) {
        const sp_block *k = &scene->block[i];
        const int32_t c = sp__block_corners(scene, i);
        vertices = k->vertices > vertices ? k->vertices : vertices;
        faces = k->faces > faces ? k->faces : faces;
        corners = c > corners ? c : corners;
    }
    const size_t blocks = (size_t)n->blocks, face = (size_t)faces;
    l->body = sp__take(a, blocks, sizeof *l->body);
    l->patch = sp__take(a, (size_t)n->faces, sizeof *l->patch);
    l->bound = sp__take(a, (size_t)n->corners, sizeof *l->bound);
    l->same = sp__take(a, (size_t)n->vertices, sizeof *l->same);
    l->order = sp__take(a, (size_t)(vertices > corners ? vertices : corners), sizeof *l->order);
    l->mine = sp__take(a, face, sizeof *l->mine);
    l->edge = sp__take(a, (size_t)corners, sizeof *l->edge);
    l->normal = sp__take(a, face, sizeof *l->normal);
    l->middle = sp__take(a, face, sizeof *l->middle);
    l->area = sp__take(a, face, sizeof *l->area);
    l->hit = sp__take(a, blocks, sizeof *l->hit);
    for (l->width = 1; l->width < n->blocks && l->width < 1 << 29; l->width *= 2) { }
    l->box = sp__take(a, 2 * (size_t)l->width, sizeof *l->box);
    l->leaf = sp__take(a, blocks, sizeof *l->leaf);
    l->code = sp__take(a, blocks, sizeof *l->code);
}

static void sp__pair_carve(sp__pair *p, const sp__most *most, sp_arena *a)
{
    const int64_t room = 2 * ((int64_t)most->total.first + most->total.second + sp__crossings(&most->side)) + 64;
    p->room = room < INT32_MAX ? (int32_t)room : 0;
    p->near_a = sp__take(a, (size_t)most->patches.first, sizeof *p->near_a);
    p->near_b = sp__take(a, (size_t)most->patches.first, sizeof *p->near_b);
    p->point = sp__take(a, (size_t)room, sizeof *p->point);
    p->found = sp__take(a, (size_t)room, sizeof *p->found);
    p->rank = sp__take(a, (size_t)room, sizeof *p->rank);
}

/* Before the patches are known: a block has no more of them than faces, and no more edges than corners. Of a closed block one
 * patch has at most half of these, because their opposites bound others. */
static void sp__most_guess(sp__most *most, const sp_scene *scene)
{
    memset(most, 0, sizeof *most);
    for (int32_t i = 0; i < scene->count.blocks; i++) {
        const int32_t corners = sp__block_corners(scene, i);
        sp__two_add(&most->side, scene->block[i].volume > 0 ? corners / 2 : corners);
        sp__two_add(&most->total, corners);
        sp__two_add(&most->patches, scene->block[i].faces);
    }
}

SP_API size_t sp_contacts_memory(const sp_scene *scene)
{
    sp_arena dry = sp__arena_dry();
    union { sp__all all; sp__clip clip; sp__pair pair; } none;
    sp__most most;
    if (!scene) return 0;
    sp__most_guess(&most, scene);
    (void)sp__take(&dry, 1, sizeof(sp__touch));
    sp__all_carve(&none.all, scene, &dry);
    sp__clip_carve(&none.clip, most.side.first, most.side.second, sp__crossings(&most.side), &dry);
    sp__pair_carve(&none.pair, &most, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}
#endif

/* ------------------------------------------------------------------------------------------------------------ patches */

/* Lexicographic order of places; 0: the same. */
static int sp__place_order(const sp_real p[3], const sp_real q[3], sp_real eps)
{
    for (int c = 0; c < 3; c++) {
        if (p[c] < q[c] - eps) return -1;
        if (p[c] > q[c] + eps) return 1;
    }
    return 0;
}

/* Plane of a face through its vertex mean; normal 0 without one.     returns twice the area */
SP__APART static sp_real sp__touch_plane(const sp__touch *t, int32_t f, sp_real n[3], sp_real m[3])
{
    const sp_face *face = &t->scene->face[t->face0 + f];
    const int32_t *corner = t->scene->corner + face->corner;
    sp__local l;
    (void)sp__local_start(&l, t->scene->vertex[0], corner, face->corners);
    (void)sp__polygon_normal(&l, corner, face->corners, n);
    sp__local_mean(&l, corner, face->corners, m);
    const sp_real twice = sp__norm3(n);
    for (int c = 0; c < 3; c++) {
        n[c] = twice > 0 ? n[c] / twice : 0;
        m[c] = l.o[c] + l.s * m[c];
    }
    return twice * l.s * l.s;
}

/* What is that near to a plane lies in it. */
static sp_real sp__body_flat(const sp__touch *t, const sp__body *body)
{
    return sp__max(body->noise, (sp_real)1e-6 * t->scene->block[t->block].diameter / 8);
}

/* Farthest corner of a face from a plane. */
static sp_real sp__touch_off(const sp__touch *t, int32_t f, const sp_real n[3], const sp_real o[3])
{
    const sp_face *face = &t->scene->face[t->face0 + f];
    sp_real most = 0;
    for (int32_t k = 0; k < face->corners; k++) {
        sp_real d[3];
        sp__sub3(t->scene->vertex[t->scene->corner[face->corner + k]], o, d);
        most = sp__max(most, sp__abs(sp__dot3(d, n)));
    }
    return most;
}

static void sp__box_start(sp_real lo[3], sp_real hi[3], const sp_real p[3])
{
    for (int c = 0; c < 3; c++) lo[c] = hi[c] = p[c];
}

static void sp__box_add(sp_real lo[3], sp_real hi[3], const sp_real p[3])
{
    for (int c = 0; c < 3; c++) {
        lo[c] = p[c] < lo[c] ? p[c] : lo[c];
        hi[c] = hi[c] < p[c] ? p[c] : hi[c];
    }
}

/* Box of boundary edges from..to-1. */
static void sp__bound_box(const sp__touch *t, int32_t from, int32_t to, sp_real lo[3], sp_real hi[3])
{
    for (int32_t e = from; e < to; e++) {
        const sp_real *x = t->scene->vertex[t->all.bound[e][0]];
        if (e == from) sp__box_start(lo, hi, x);
        sp__box_add(lo, hi, x);
    }
}

#ifdef SP_SMALL
/* Patches of a block: its faces that have an area. */
static void sp__touch_patches(sp__touch *t, sp__body *body, int32_t faces)
{
    const sp_real flat = sp__body_flat(t, body);
    for (int32_t f = 0; f < faces; f++) {
        const sp_face *face = &t->scene->face[t->face0 + f];
        const int32_t *corner = t->scene->corner + face->corner;
        sp__patch *p = &t->all.patch[t->patches];
        if (!(sp__touch_plane(t, f, p->n, p->o) > 0)) continue;
        body->warp = sp__max(body->warp, sp__touch_off(t, f, p->n, p->o));
        p->edge = t->bounds;
        p->edges = face->corners;
        for (int32_t k = 0; k < p->edges; k++) {
            t->all.bound[t->bounds][0] = corner[k];
            t->all.bound[t->bounds++][1] = corner[k + 1 < p->edges ? k + 1 : 0];
        }
        sp__bound_box(t, p->edge, t->bounds, p->lo, p->hi);
        p->plane = body->patch;
        for (const sp__patch *q; p->plane < t->patches; p->plane++) {
            q = &t->all.patch[p->plane];
            if (q->plane == p->plane && sp__dot3(q->n, p->n) > 0 && sp__touch_off(t, f, q->n, q->o) <= flat) break;
        }
        t->patches++;
    }
}
#else
/* Larger faces first: the largest of a plane is the most exact. Equal ones by place, so face order does not matter. */
static int sp__face_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    if (t->all.area[i] > t->all.area[j]) return 1;
    if (t->all.area[i] < t->all.area[j]) return 0;
    const int o = sp__place_order(t->all.middle[i], t->all.middle[j], 0);
    return o ? o < 0 : i < j;
}

/* Edges between the same two vertices stand together. */
static int sp__edge_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const int32_t *p = t->all.edge[i], *q = t->all.edge[j];
    const int32_t plo = p[0] < p[1] ? p[0] : p[1], qlo = q[0] < q[1] ? q[0] : q[1];
    const int32_t phi = p[0] + p[1] - plo, qhi = q[0] + q[1] - qlo;
    if (plo != qlo) return plo < qlo;
    return phi != qhi ? phi < qhi : i < j;
}

/* same[v]: the first vertex at v's place. */
static int sp__vertex_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const int o = sp__place_order(t->scene->vertex[t->vertex0 + i], t->scene->vertex[t->vertex0 + j], 0);
    return o ? o < 0 : i < j;
}

static void sp__touch_weld(sp__touch *t)
{
    const sp_block *k = &t->scene->block[t->block];
    for (int32_t v = 0; v < k->vertices; v++) t->all.order[v] = v;
    sp__sort(t->all.order, k->vertices, sp__vertex_before, t);
    int32_t first = 0;
    for (int32_t i = 0; i < k->vertices; i++) {
        const int32_t v = t->vertex0 + t->all.order[i];
        if (!i || sp__place_order(t->scene->vertex[first], t->scene->vertex[v], 0)) first = v;
        t->all.same[v] = first;
    }
}

/* Give each face with area its patch: the first whose plane all its corners keep to, or a new one. */
static void sp__touch_group(sp__touch *t, sp__body *body, int32_t faces)
{
    const sp_real flat = sp__body_flat(t, body);
    for (int32_t f = 0; f < faces; f++) {
        t->all.area[f] = sp__touch_plane(t, f, t->all.normal[f], t->all.middle[f]);
        body->warp = sp__max(body->warp, sp__touch_off(t, f, t->all.normal[f], t->all.middle[f]));
        t->all.order[f] = f;
    }
    sp__sort(t->all.order, faces, sp__face_before, t);
    for (int32_t i = 0; i < faces; i++) {
        const int32_t f = t->all.order[i];
        int32_t p = body->patch;
        t->all.mine[f] = -1;
        if (!(t->all.area[f] > 0)) continue;
        for (; p < t->patches; p++)
            if (sp__dot3(t->all.patch[p].n, t->all.normal[f]) > 0
                && sp__touch_off(t, f, t->all.patch[p].n, t->all.patch[p].o) <= flat) break;
        t->all.mine[f] = p;
        if (p < t->patches) continue;
        for (int c = 0; c < 3; c++) {
            t->all.patch[p].n[c] = t->all.normal[f][c];
            t->all.patch[p].o[c] = t->all.middle[f][c];
        }
        t->patches++;
    }
}

/* All edges of a face, by the vertices that stand for their places. */
static void sp__touch_edges(sp__touch *t, int32_t f)
{
    const sp_face *face = &t->scene->face[t->face0 + f];
    const int32_t *corner = t->scene->corner + face->corner;
    for (int32_t k = 0; k < face->corners; k++) {
        t->all.edge[t->edges][0] = t->all.same[corner[k]];
        t->all.edge[t->edges][1] = t->all.same[corner[k + 1 < face->corners ? k + 1 : 0]];
        t->edges++;
    }
}

/* Boundary of a patch from t->all.edge: of the edges between two vertices those that their opposites do not cancel. */
static void sp__touch_bound(sp__touch *t, sp__patch *p)
{
    int32_t *order = t->all.order;
    p->edge = t->bounds;
    for (int32_t k = 0; k < t->edges; k++) order[k] = k;
    sp__sort(order, t->edges, sp__edge_before, t);
    for (int32_t k = 0; k < t->edges; ) {
        const int32_t u = t->all.edge[order[k]][0], v = t->all.edge[order[k]][1];
        int32_t net = 0;
        for (; k < t->edges; k++) {
            const int32_t *e = t->all.edge[order[k]];
            if (e[0] == u && e[1] == v) net++;
            else if (e[0] == v && e[1] == u) net--;
            else break;
        }
        for (; net && u != v; net += net < 0 ? 1 : -1) {
            t->all.bound[t->bounds][0] = net > 0 ? u : v;
            t->all.bound[t->bounds++][1] = net > 0 ? v : u;
        }
    }
    p->edges = t->bounds - p->edge;
    sp__bound_box(t, p->edge, t->bounds, p->lo, p->hi);
}

/* Patches of a block: its faces by plane. */
static void sp__touch_patches(sp__touch *t, sp__body *body, int32_t faces)
{
    sp__touch_weld(t);
    sp__touch_group(t, body, faces);
    for (int32_t p = body->patch; p < t->patches; p++) {
        t->edges = 0;
        for (int32_t f = 0; f < faces; f++) if (t->all.mine[f] == p) sp__touch_edges(t, f);
        sp__touch_bound(t, &t->all.patch[p]);
    }
}
#endif

/* Nothing of a closed block beyond a face of it? */
static int sp__touch_convex(const sp__touch *t, const sp__body *body)
{
    const sp_block *k = &t->scene->block[t->block];
    const sp_real flat = sp__body_flat(t, body) + 2 * body->warp;
    if (!(k->volume > 0)) return 0;
    for (int32_t p = body->patch; p < body->patch + body->patches; p++)
        for (int32_t e = body->edge; e < body->edge + body->edges; e++) {
            sp_real d[3];
            sp__sub3(t->scene->vertex[t->all.bound[e][0]], t->all.patch[p].o, d);
            if (sp__dot3(d, t->all.patch[p].n) > flat) return 0;
        }
    return 1;
}

/* Box and noise of a block from its patches. */
static void sp__touch_size(sp__touch *t, sp__body *body)
{
    const sp_real diameter = t->scene->block[t->block].diameter;
    sp_real far = 0;
    for (int32_t v = 0; v < t->scene->block[t->block].vertices; v++)
        for (int c = 0; c < 3; c++) far = sp__max(far, sp__abs(t->scene->vertex[t->vertex0 + v][c]));
    body->noise = 16 * SP_EPSILON * (far + diameter);
    body->reach = sp__max(body->noise, t->set.absolute ? t->set.distance : t->set.distance * diameter);
}

/* Patches of one block. */
static void sp__touch_block(sp__touch *t, int32_t block)
{
    const sp_block *k = &t->scene->block[block];
    sp__body *body = &t->all.body[block];
    t->block = block;
    t->vertex0 = k->vertex;
    t->face0 = k->face;
    body->warp = 0;
    body->patch = t->patches;
    body->edge = t->bounds;
    sp__touch_size(t, body);
    sp__touch_patches(t, body, k->faces);
    body->patches = t->patches - body->patch;
    body->edges = t->bounds - body->edge;
    sp__bound_box(t, body->edge, t->bounds, body->lo, body->hi);
    body->convex = sp__touch_convex(t, body);
}

/* --------------------------------------------------------------------------------------------------------------- tree */

/* Do two boxes come nearer than d? */
static int sp__boxes_near(const sp_real lo[3], const sp_real hi[3], const sp_real lo2[3], const sp_real hi2[3], sp_real d)
{
    for (int c = 0; c < 3; c++) if (lo[c] > hi2[c] + d || lo2[c] > hi[c] + d) return 0;
    return 1;
}

#ifndef SP_SMALL
/* Every third bit from bit 0. */
static uint32_t sp__spread(uint32_t x)
{
    x = (x | x << 16) & UINT32_C(0x030000ff);
    x = (x | x << 8) & UINT32_C(0x0300f00f);
    x = (x | x << 4) & UINT32_C(0x030c30c3);
    return (x | x << 2) & UINT32_C(0x09249249);
}

static int sp__code_before(const void *what, int32_t i, int32_t j)
{
    const uint32_t *code = what;
    return code[i] != code[j] ? code[i] < code[j] : i < j;
}

static int sp__number_before(const void *what, int32_t i, int32_t j)
{
    (void)what;
    return i < j;
}

/* Leaves: the blocks with faces along a Morton curve through the middles of their boxes, 1024 steps a side. */
static void sp__tree_leaves(sp__touch *t)
{
    sp_real *lo = t->lo, *hi = t->hi;
    t->leaves = 0;
    for (int32_t i = 0; i < t->scene->count.blocks; i++) {
        const sp__body *k = &t->all.body[i];
        if (!k->edges) continue;
        if (!t->leaves) sp__box_start(lo, hi, k->lo);
        sp__box_add(lo, hi, k->lo);
        sp__box_add(lo, hi, k->hi);
        t->all.leaf[t->leaves++] = i;
    }
    for (int32_t l = 0; l < t->leaves; l++) {
        const sp__body *k = &t->all.body[t->all.leaf[l]];
        uint32_t code = 0;
        for (int c = 0; c < 3; c++) {
            const sp_real wide = hi[c] - lo[c], at = (k->lo[c] - lo[c]) / 2 + (k->hi[c] - lo[c]) / 2;
            const uint32_t step = wide > 0 ? (uint32_t)(int32_t)(1023 * (at / wide)) : 0;
            code |= sp__spread(step < 1023 ? step : 1023) << c;
        }
        t->all.code[t->all.leaf[l]] = code;
    }
    sp__sort(t->all.leaf, t->leaves, sp__code_before, t->all.code);
}

/* Boxes bottom-up; an empty one has low above high. */
static void sp__tree_build(sp__touch *t)
{
    sp__tree_leaves(t);
    for (int32_t k = 2 * t->all.width - 1; k > 0; k--) {
        sp_real *box = t->all.box[k];
        box[0] = (sp_real)1;
        box[3] = (sp_real)0;
        if (k >= t->all.width) {
            if (k - t->all.width >= t->leaves) continue;
            const sp__body *b = &t->all.body[t->all.leaf[k - t->all.width]];
            for (int c = 0; c < 3; c++) { box[c] = b->lo[c] - b->reach; box[3 + c] = b->hi[c] + b->reach; }
            continue;
        }
        const sp_real *left = t->all.box[2 * k], *right = t->all.box[2 * k + 1];
        if (left[0] > left[3]) continue;
        for (int c = 0; c < 6; c++) box[c] = left[c];
        if (right[0] > right[3]) continue;
        sp__box_add(box, box + 3, right);
        sp__box_add(box, box + 3, right + 3);
    }
}

/* Blocks above a whose boxes come near a's, in order. Returns how many. */
static int32_t sp__tree_ask(sp__touch *t, int32_t a)
{
    const sp__body *body = &t->all.body[a];
    int32_t hits = 0, k = 1;
    if (!body->edges) return 0;
    while (k > 0) {
        const sp_real *box = t->all.box[k];
        if (!(box[0] > box[3]) && sp__boxes_near(body->lo, body->hi, box, box + 3, body->reach)) {
            if (k < t->all.width) { k *= 2; continue; }
            if (t->all.leaf[k - t->all.width] > a) t->all.hit[hits++] = t->all.leaf[k - t->all.width];
        }
        while (k & 1) k >>= 1;                          /* up from right children, past the top to 0 */
        if (k) k++;
    }
    sp__sort(t->all.hit, hits, sp__number_before, NULL);
    return hits;
}
#endif

/* --------------------------------------------------------------------------------------------------------------- pair */

/* Coordinates of x in the plane of patch p, e1 and e2 from o, in units. */
static void sp__pair_flat(const sp__touch *t, const sp__patch *p, const sp_real x[3], sp_real xy[2])
{
    sp_real d[3];
    sp__sub3(x, p->o, d);
    xy[0] = sp__dot3(t->e1, d) / t->unit;
    xy[1] = sp__dot3(t->e2, d) / t->unit;
}

/* Give the boundary of a patch to the clipper: A's as it is, B's in A's plane, turned round. */
static void sp__pair_region(sp__touch *t, const sp__patch *plane, const sp__patch *p, int32_t side)
{
#ifdef SP_SMALL
    for (int32_t k = 0; k < p->edges; k++) {
        sp_real x[2];
        sp__pair_flat(t, plane, t->scene->vertex[t->all.bound[p->edge + (side ? p->edges - 1 - k : k)][0]], x);
        sp__clip_add(&t->clip, side, x);
    }
#else
    for (int32_t e = p->edge; e < p->edge + p->edges; e++) {
        const int32_t u = t->all.bound[e][side], v = t->all.bound[e][1 - side];
        sp_real from[2], to[2];
        sp__pair_flat(t, plane, t->scene->vertex[u], from);
        sp__pair_flat(t, plane, t->scene->vertex[v], to);
        sp__clip_add(&t->clip, side, from, to, u, v);
    }
#endif
}

/* A place in the plane of patch p in space. */
static void sp__pair_place(const sp__touch *t, const sp__patch *p, const sp_real xy[2], sp_real x[3])
{
    for (int c = 0; c < 3; c++) x[c] = p->o[c] + t->unit * (xy[0] * t->e1[c] + xy[1] * t->e2[c]);
}

#ifdef SP_SMALL
static void sp__pair_corner(const sp__touch *t, const sp__patch *p, int32_t corner, sp_real x[3])
{
    sp__pair_place(t, p, t->clip.corner[corner], x);
}
#else
/* A corner of the result in space: on A's plane; a vertex that is there already stays what it is, to the bit. */
static void sp__pair_corner(const sp__touch *t, const sp__patch *p, int32_t corner, sp_real x[3])
{
    const int32_t name = t->clip.corner[corner].name;
    sp__pair_place(t, p, t->clip.corner[corner].x, x);
    if (name < 0) return;
    for (int c = 0; c < 3; c++) if (sp__abs(t->scene->vertex[name][c] - x[c]) > t->noise / 4) return;
    memcpy(x, t->scene->vertex[name], 3 * sizeof *x);
}

static void sp__reverse(sp_real (*p)[3], int32_t from, int32_t to)
{
    for (to--; from < to; from++, to--)
        for (int c = 0; c < 3; c++) {
            const sp_real x = p[from][c];
            p[from][c] = p[to][c];
            p[to][c] = x;
        }
}

/* Start the polygon at its first corner in order of x, y, z. */
static void sp__pair_canonical(const sp__touch *t, sp_real (*p)[3], int32_t size)
{
    int32_t first = 0;
    for (int32_t k = 1; k < size; k++) if (sp__place_order(p[k], p[first], t->snap) < 0) first = k;
    sp__reverse(p, 0, first);
    sp__reverse(p, first, size);
    sp__reverse(p, 0, size);
}
#endif

/* Append a polygon to the scene; where there is no room, count. */
static void sp__pair_add(sp__touch *t, int32_t size, sp_real (*point)[3])
{
    const sp_status s = sp_scene_interface(t->scene, t->a, t->b, size, point[0], &t->set.joint, NULL);
    if (s != SP_OK && s != SP_E_CAPACITY) return;                   /* too small for its coordinates */
    t->full |= s == SP_E_CAPACITY;
    t->report.interfaces++;
    t->report.points += size;
}

#ifdef SP_SMALL
/* Append what was gathered in the plane of patch p, unless that is all and narrower than `near`. */
static void sp__pair_close(sp__touch *t, const sp__patch *p)
{
    const int32_t n = t->pair.corners;
    for (int32_t k = 0; k < n; k++) sp__pair_place(t, p, t->pair.hull.p[k], t->pair.point[k]);
    if (n && (t->pair.parts || sp__clip_wide(t->pair.hull.p, n, t->near / t->unit) > 0)) sp__pair_add(t, n, t->pair.point);
    t->pair.corners = 0;
}

/* Gather the clipper's polygon: the hull of it and what there is. Without room for that what there is goes by itself. */
static void sp__pair_gather(sp__touch *t, const sp__patch *p)
{
    sp__clip *c = &t->clip;
    sp__hull *h = &t->pair.hull;
    if (t->pair.corners + c->corners > c->cap) {
        t->pair.parts++;
        sp__pair_close(t, p);
    }
    h->points = t->pair.corners + c->corners;
    memcpy(h->p + t->pair.corners, c->corner, (size_t)c->corners * sizeof *h->p);
    sp__hull_run(h);
    c->corners = h->corners;
    for (int32_t k = 0; k < h->corners; k++) memcpy(c->corner[k], h->p[h->corner[k]], sizeof *h->p);
    sp__clip_straighten(c);
    t->pair.corners = c->corners;
    memcpy(h->p, c->corner, (size_t)c->corners * sizeof *h->p);
}
#endif

/* Keep loop l of the clipper if B's plane is near in its middle: gap g along n_A, n_B . (o_B - m - g n_A) = 0. */
static void sp__pair_keep(sp__touch *t, const sp__patch *p, const sp__patch *q, int32_t l)
{
    const int32_t from = t->clip.loop[l], size = t->clip.loop[l + 1] - from;
    sp_real m[3] = { 0, 0, 0 }, (*point)[3] = t->pair.point;
#ifndef SP_SMALL
    if (size > t->pair.room - t->points || t->founds >= t->pair.room) { t->status = SP_E_MEMORY; return; }
    point += t->points;
#endif
    for (int32_t k = 0; k < size; k++) {
        sp_real d[3];
        sp__pair_corner(t, p, from + k, point[k]);
        sp__sub3(q->o, point[k], d);
        sp__add3(m, 1 / (sp_real)size, d);
    }
    if (sp__abs(sp__dot3(q->n, m) / sp__dot3(q->n, p->n)) > t->near) return;
#ifdef SP_SMALL
    sp__pair_gather(t, p);
#else
    sp__pair_canonical(t, point, size);
    t->pair.found[t->founds].start = t->points;
    t->pair.found[t->founds].size = size;
    t->points += size;
    t->founds++;
#endif
}

/* Can patches p and q touch: opposed to within the angle, boxes and planes near? Between planes at angle s the distance
 * changes by s times the way. */
static int sp__pair_opposed(const sp__touch *t, const sp__patch *p, const sp__patch *q)
{
    sp_real x[3], d[3];
    if (sp__dot3(p->n, q->n) >= 0 || !sp__boxes_near(p->lo, p->hi, q->lo, q->hi, t->near)) return 0;
    sp__cross3(p->n, q->n, x);
    const sp_real s = sp__norm3(x);
    if (s > t->set.angle) return 0;
    sp__sub3(q->o, p->o, d);
    return sp__abs(sp__dot3(d, p->n)) <= 2 * t->near + 2 * s * sp__norm3(d);
}

/* Polygons of two patches, u of A and q of B, in the plane of patch p: u, or of SP_SMALL the first in u's plane. */
static void sp__pair_clip(sp__touch *t, const sp__patch *p, const sp__patch *u, const sp__patch *q)
{
    sp__across3(p->n, t->e1);
    sp__cross3(p->n, t->e1, t->e2);
    sp__clip_clear(&t->clip);
    sp__pair_region(t, p, u, 0);
    sp__pair_region(t, p, q, 1);
    if (!sp__clip_run(&t->clip, t->snap / t->unit, t->near / t->unit)) { t->status = SP_E_MEMORY; return; }
#ifdef SP_SMALL
    if (t->clip.bent) { t->status = SP_E_UNSUPPORTED; return; }
#endif
    for (int32_t l = 0; l < t->clip.loops && !t->status; l++) sp__pair_keep(t, p, q, l);
}

#ifndef SP_SMALL
/* Patches of one block near the box of another. Returns how many. */
static int32_t sp__pair_near(const sp__touch *t, const sp__body *own, const sp__body *other, int32_t *list)
{
    int32_t n = 0;
    for (int32_t k = own->patch; k < own->patch + own->patches; k++) {
        const sp__patch *p = &t->all.patch[k];
        if (p->edges && sp__boxes_near(p->lo, p->hi, other->lo, other->hi, t->near)) list[n++] = k;
    }
    return n;
}

static int sp__found_before(const void *what, int32_t i, int32_t j)
{
    const sp__touch *t = what;
    const sp__found *f = &t->pair.found[i], *g = &t->pair.found[j];
    for (int32_t k = 0; k < f->size && k < g->size; k++) {
        const int o = sp__place_order(t->pair.point[f->start + k], t->pair.point[g->start + k], t->snap);
        if (o) return o < 0;
    }
    return f->size != g->size ? f->size < g->size : i < j;
}

/* Append what was found to the scene, in the order of corners; where there is no room, count. */
static void sp__pair_append(sp__touch *t)
{
    for (int32_t k = 0; k < t->founds; k++) t->pair.rank[k] = k;
    sp__sort(t->pair.rank, t->founds, sp__found_before, t);
    for (int32_t k = 0; k < t->founds; k++) {
        const sp__found *f = &t->pair.found[t->pair.rank[k]];
        sp__pair_add(t, f->size, t->pair.point + f->start);
    }
}
#endif

/* Tolerances of the pair. */
static void sp__pair_start(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[b];
    const sp_real d = t->scene->block[t->a].diameter, e = t->scene->block[b].diameter, small = d < e ? d : e;
    t->b = b;
    t->noise = sp__max(p->noise, q->noise);
    t->near = sp__max(t->noise, p->reach < q->reach ? p->reach : q->reach);
    t->snap = (sp_real)1e-6 * small < t->near ? (sp_real)1e-6 * small : t->near;
    t->snap = sp__max(t->noise, t->snap / 8);
    t->unit = small > 0 ? sp__power_of_two(small) : (sp_real)1;
}

/* ------------------------------------------------------------------------------------------------------------ overlap */

/* By how much the blocks' shadows on an axis overlap, of any length; below 0 they are apart. */
static sp_real sp__shadow(const sp__touch *t, const sp_real axis[3])
{
    sp_real lo[2] = { 0, 0 }, hi[2] = { 0, 0 };
    const sp_real *o = t->all.body[t->a].lo;
    for (int side = 0; side < 2; side++) {
        const sp__body *k = &t->all.body[side ? t->b : t->a];
        for (int32_t e = k->edge; e < k->edge + k->edges; e++) {
            sp_real d[3];
            sp__sub3(t->scene->vertex[t->all.bound[e][0]], o, d);
            const sp_real x = sp__dot3(axis, d);
            if (e == k->edge || x < lo[side]) lo[side] = x;
            if (e == k->edge || x > hi[side]) hi[side] = x;
        }
    }
    const sp_real one = hi[0] - lo[1], two = hi[1] - lo[0];
    return one < two ? one : two;
}

/* Least overlap of the shadows along the normals of both blocks' patches. At most `flat`: a plane keeps them apart, which is
 * proof for blocks of any shape. */
static sp_real sp__shadow_faces(const sp__touch *t, sp_real flat)
{
    sp_real least = 0;
    int some = 0;
    for (int side = 0; side < 2; side++) {
        const sp__body *k = &t->all.body[side ? t->b : t->a];
        for (int32_t p = k->patch; p < k->patch + k->patches; p++) {
            const sp_real x = sp__shadow(t, t->all.patch[p].n);
            if (!some || x < least) least = x;
            some = 1;
            if (least <= flat) return least;
        }
    }
    return least;
}

/* One of an edge and its opposite? */
static int sp__edge_once(const sp__touch *t, const int32_t *e)
{
#ifdef SP_SMALL
    return sp__place_order(t->scene->vertex[e[0]], t->scene->vertex[e[1]], 0) < 0;
#else
    return (void)t, e[0] <= e[1];
#endif
}

/* The same along the cross products of their edges: with the normals that is all a convex pair can be kept apart by. */
static sp_real sp__shadow_edges(const sp__touch *t, sp_real least, sp_real flat)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[t->b];
    for (int32_t i = p->edge; i < p->edge + p->edges; i++)
        for (int32_t j = q->edge; j < q->edge + q->edges; j++) {
            const int32_t *u = t->all.bound[i], *v = t->all.bound[j];
            sp_real d[3], e[3];
            if (!sp__edge_once(t, u) || !sp__edge_once(t, v)) continue;
            sp__sub3(t->scene->vertex[u[1]], t->scene->vertex[u[0]], d);
            sp__sub3(t->scene->vertex[v[1]], t->scene->vertex[v[0]], e);
            const sp_real size = sp__norm3(d) * sp__norm3(e);
            sp__cross3(d, e, d);
            const sp_real length = sp__norm3(d);
            if (!(length > (sp_real)1e-4 * size)) continue;         /* parallel: no axis of its own */
            sp__scale3((sp_real)1 / length, d, d);
            const sp_real x = sp__shadow(t, d);
            if (x < least) least = x;
            if (least <= flat) return least;
        }
    return least;
}

/* Does the upward ray from x pass right of the directed edge p q, seen from above? +1, -1 or 0, the same for q p but for the
 * sign. Half-open in y. */
static int sp__ray_edge(const sp_real x[3], const sp_real p[3], const sp_real q[3])
{
    const int up = p[1] <= x[1], to = q[1] <= x[1];
    if (up == to) return 0;
    const sp_real *lo = up ? p : q, *hi = up ? q : p;
    const sp_real side = (hi[0] - lo[0]) * (x[1] - lo[1]) - (hi[1] - lo[1]) * (x[0] - lo[0]);
    return side > 0 ? (up ? 1 : -1) : 0;
}

/* Squared distance of x from the triangle v[0] v[1] v[2] with normal n (not 0): from its plane over its inside, else from the
 * nearest edge, d - s e with s = clamp(d . e / e . e). */
static sp_real sp__triangle_far2(const sp_real x[3], const sp_real *const v[3], const sp_real n[3])
{
    sp_real e[3], d[3], c[3], least = -1, h = 0;
    int inside = 1;
    for (int k = 0; k < 3; k++) {
        sp__sub3(v[(k + 1) % 3], v[k], e);
        sp__sub3(x, v[k], d);
        h = sp__dot3(d, n);
        sp__cross3(e, d, c);
        if (sp__dot3(c, n) < 0) inside = 0;
        const sp_real len2 = sp__dot3(e, e), along = sp__dot3(d, e);
        const sp_real s = along <= 0 || !(len2 > 0) ? 0 : along >= len2 ? (sp_real)1 : along / len2;
        for (int i = 0; i < 3; i++) d[i] -= s * e[i];
        const sp_real far2 = sp__dot3(d, d);
        if (least < 0 || far2 < least) least = far2;
    }
    return inside ? h * h / sp__dot3(n, n) : least;
}

/* How deep x lies inside a closed block: 0 if outside, or not deeper than `flat`. Inside: the faces above wind round it. */
static sp_real sp__depth(const sp__touch *t, int32_t block, const sp_real x[3], sp_real flat)
{
    const sp_scene *s = t->scene;
    const sp_block *k = &s->block[block];
    sp_real least2 = k->diameter * k->diameter;
    int wind = 0;
    if (!(k->volume > 0)) return 0;
    const sp__body *body = &t->all.body[block];
    for (int c = 0; c < 3; c++) if (x[c] < body->lo[c] + flat || x[c] > body->hi[c] - flat) return 0;
    for (int32_t f = k->face; f < k->face + k->faces; f++)
        for (int32_t i = 1; i + 1 < s->face[f].corners; i++) {
            const int32_t *corner = s->corner + s->face[f].corner;
            const sp_real *const v[3] = { s->vertex[corner[0]], s->vertex[corner[i]], s->vertex[corner[i + 1]] };
            sp_real d[3], n[3];
            sp__sub3(v[1], v[0], d);
            sp__sub3(v[2], v[0], n);
            sp__cross3(d, n, n);
            if (!(sp__dot3(n, n) > 0)) continue;
            const sp_real far2 = sp__triangle_far2(x, v, n);
            if (far2 <= flat * flat) return 0;
            if (far2 < least2) least2 = far2;
            const int w = sp__ray_edge(x, v[0], v[1]) + sp__ray_edge(x, v[1], v[2]) + sp__ray_edge(x, v[2], v[0]);
            sp__sub3(v[0], x, d);
            if (w && (n[2] > 0 ? sp__dot3(d, n) > 0 : sp__dot3(d, n) < 0)) wind += w;
        }
    return wind > 0 ? SP_SQRT(least2) : 0;
}

/* Part of the edge p q in a box: from s[0] to s[1], empty if s[0] > s[1].                          [Liang, Barsky 1984] */
static void sp__edge_in_box(const sp_real p[3], const sp_real q[3], const sp__body *k, sp_real s[2])
{
    s[0] = 0;
    s[1] = (sp_real)1;
    for (int c = 0; c < 3; c++) {
        const sp_real d = q[c] - p[c];
        if (!(sp__abs(d) > 0)) {
            if (p[c] < k->lo[c] || p[c] > k->hi[c]) s[1] = (sp_real)-1;
            continue;
        }
        const sp_real u = (k->lo[c] - p[c]) / d, v = (k->hi[c] - p[c]) / d;
        s[0] = sp__max(s[0], u < v ? u : v);
        if (s[1] > (u < v ? v : u)) s[1] = u < v ? v : u;
    }
}

/* Deepest of the vertices of `inner`, and of points along its edges, inside `outer`. */
static sp_real sp__depth_edges(const sp__touch *t, int32_t inner, int32_t outer, sp_real flat)
{
    const sp__body *k = &t->all.body[inner];
    const int64_t work = (int64_t)k->edges * t->scene->block[outer].faces;
    const int steps = work < 20000 ? 8 : 2;
    sp_real most = 0;
    for (int32_t e = k->edge; e < k->edge + k->edges; e++) {
        const sp_real *p = t->scene->vertex[t->all.bound[e][0]], *q = t->scene->vertex[t->all.bound[e][1]];
        sp_real s[2], x[3];
        most = sp__max(most, sp__depth(t, outer, p, flat));
        if (!sp__edge_once(t, t->all.bound[e])) continue;
        sp__edge_in_box(p, q, &t->all.body[outer], s);
        for (int i = 1; i < steps && s[0] < s[1]; i++) {
            const sp_real at = s[0] + (s[1] - s[0]) * (sp_real)i / (sp_real)steps;
            for (int c = 0; c < 3; c++) x[c] = p[c] + at * (q[c] - p[c]);
            most = sp__max(most, sp__depth(t, outer, x, flat));
        }
    }
    return most;
}

/* Depth of the present pair inside each other, at most `flat` if none is seen.
 *   convex, closed   separating axes: always seen, least way out
 *   other shapes     only what is certain: no plane along a face keeps them apart, and a vertex, a point on an edge, or a
 *                    centroid of one is inside the other; depth of that point. Thin crossings may be missed; touching blocks
 *                    are never reported
 *   open or flat     supports have no inside: only their vertices and edges inside the other are seen */
static sp_real sp__pair_depth(const sp__touch *t, sp_real flat)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[t->b];
    const int64_t work = (int64_t)p->edges * q->edges * (p->edges + q->edges) / 4;
    for (int c = 0; c < 3; c++) if (p->hi[c] - q->lo[c] <= flat || q->hi[c] - p->lo[c] <= flat) return 0;
    const sp_real least = sp__shadow_faces(t, flat);
    if (least <= flat) return 0;
    if (p->convex && q->convex && work <= 10000000) return sp__shadow_edges(t, least, flat);
    if (!SP__FULL) return 0;
    sp_real most = sp__max(sp__depth_edges(t, t->a, t->b, flat), sp__depth_edges(t, t->b, t->a, flat));
    for (int side = 0; side < 2; side++) {
        const sp_real *x = t->scene->block[side ? t->b : t->a].centroid;
        const sp_real d = sp__depth(t, t->a, x, flat), e = sp__depth(t, t->b, x, flat);
        most = sp__max(most, d < e ? d : e);
    }
    return most < least ? most : least;
}

SP__CALLED static void sp__pair_overlap(sp__touch *t)
{
    const sp_real flat = t->near + 2 * (t->all.body[t->a].warp + t->all.body[t->b].warp);
    const sp_real depth = sp__pair_depth(t, flat);
    if (!(depth > flat)) return;
    if (t->report.overlap && t->report.overlaps < t->report.overlap_cap) {
        const sp_overlap o = { t->a, t->b, depth };
        t->report.overlap[t->report.overlaps] = o;
    }
    t->report.overlaps++;
}

/* --------------------------------------------------------------------------------------------------------------- find */

/* All of one pair. */
static void sp__touch_pair(sp__touch *t, int32_t b)
{
    const sp__body *p = &t->all.body[t->a], *q = &t->all.body[b];
    if (t->scene->block[t->a].fixed == SP_FIXED && t->scene->block[b].fixed == SP_FIXED) return;
    sp__pair_start(t, b);
#ifdef SP_SMALL
    if (!p->edges || !q->edges || !sp__boxes_near(p->lo, p->hi, q->lo, q->hi, p->reach + q->reach)) return;
    for (int32_t plane = p->patch; plane < p->patch + p->patches; plane++) {
        const sp__patch *first = &t->all.patch[plane];
        t->pair.parts = 0;
        for (int32_t i = plane; i < p->patch + p->patches; i++)
            for (int32_t j = q->patch; j < q->patch + q->patches && !t->status; j++) {
                const sp__patch *u = &t->all.patch[i], *v = &t->all.patch[j];
                if (u->plane == plane && sp__pair_opposed(t, u, v)) sp__pair_clip(t, first, u, v);
            }
        sp__pair_close(t, first);
    }
#else
    t->points = t->founds = 0;
    const int32_t n = sp__pair_near(t, p, q, t->pair.near_a), m = sp__pair_near(t, q, p, t->pair.near_b);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < m && !t->status; j++) {
            const sp__patch *u = &t->all.patch[t->pair.near_a[i]], *v = &t->all.patch[t->pair.near_b[j]];
            if (sp__pair_opposed(t, u, v)) sp__pair_clip(t, u, u, v);
        }
    if (t->status) return;
    sp__pair_append(t);
#endif
    if (!t->status) sp__pair_overlap(t);
}

#ifndef SP_SMALL
/* Patches of all blocks, then what the largest pair needs. */
static void sp__touch_blocks(sp__touch *t, sp_arena *scratch)
{
    sp__most *most = &t->most;
    for (int32_t i = 0; i < t->scene->count.blocks; i++) {
        int32_t side = 0;
        sp__touch_block(t, i);
        for (int32_t p = t->all.body[i].patch; p < t->patches; p++)
            if (t->all.patch[p].edges > side) side = t->all.patch[p].edges;
        sp__two_add(&most->side, side);
        sp__two_add(&most->total, t->all.body[i].edges);
        sp__two_add(&most->patches, t->all.body[i].patches);
    }
    sp__clip_carve(&t->clip, most->side.first, most->side.second, sp__crossings(&most->side), scratch);
    sp__pair_carve(&t->pair, most, scratch);
    if (sp__failed(scratch)) t->status = SP_E_MEMORY;
}
#endif

static sp_status sp__contact_settings_check(const sp_contact_settings *s)
{
    if (!sp__finite(s->distance) || !sp__finite(s->angle)) return SP_E_RANGE;
    if (s->distance < 0 || s->angle < 0 || s->angle > (sp_real)0.5) return SP_E_RANGE;
    return sp__joint_check(&s->joint);
}

SP_API sp_status sp_contacts_find(sp_scene *scene, const sp_contact_settings *settings, sp_arena scratch,
                                  sp_contact_report *report)
{
    if (!scene || !scratch.base || !report || report->overlap_cap < 0) return SP_E_ARGUMENT;
    sp__touch *t = sp__take(&scratch, 1, sizeof *t);
    if (!t) return SP_E_MEMORY;
    memset(t, 0, sizeof *t);
    t->set = settings ? *settings : sp_contact_settings_default();
    t->status = sp__contact_settings_check(&t->set);
    if (t->status) return t->status;
    t->scene = scene;
    t->before = scene->count;
    t->report.overlap = report->overlap;
    t->report.overlap_cap = report->overlap_cap;
#ifdef SP_SMALL
    sp__touch_carve(&t->all, &t->clip, &t->pair, scene, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    for (int32_t i = 0; i < scene->count.blocks; i++) sp__touch_block(t, i);
    for (t->a = 0; t->a < scene->count.blocks; t->a++)
        for (int32_t b = t->a + 1; b < scene->count.blocks && !t->status; b++) sp__touch_pair(t, b);
#else
    sp__all_carve(&t->all, scene, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__touch_blocks(t, &scratch);
    if (!t->status) sp__tree_build(t);
    for (t->a = 0; t->a < scene->count.blocks && !t->status; t->a++) {
        const int32_t hits = sp__tree_ask(t, t->a);
        for (int32_t h = 0; h < hits && !t->status; h++) sp__touch_pair(t, t->all.hit[h]);
    }
#endif
    if (t->status || t->full) scene->count = t->before;
    if (t->status) return t->status;
    *report = t->report;
    return t->full ? SP_E_CAPACITY : SP_OK;
}

/* 8 -------------------------------------------------------------------------------------------------------------- problem */

/* A contact takes part if it touches a free block. */
static int sp__contact_counts(const sp_scene *scene, const sp_interface *f)
{
    return scene->block[f->a].fixed != SP_FIXED || scene->block[f->b].fixed != SP_FIXED;
}

/* Is there anything that counts scene.live times? */
static int sp__scene_live(const sp_scene *scene)
{
    for (int32_t k = 0; k < scene->count.loads; k++) if (scene->load[k].live) return 1;
    for (int k = 0; k < 3; k++) if (scene->body[k] < 0 || scene->body[k] > 0) return 1;
    return 0;
}

/* A vector of a joint's frame (n, t1, t2) in space, and back. */
static void sp__joint_force(const sp_interface *t, const sp_real f[3], sp_real F[3])
{
    for (int k = 0; k < 3; k++) F[k] = f[0] * t->n[k] + f[1] * t->t1[k] + f[2] * t->t2[k];
}

static void sp__joint_frame(const sp_interface *t, const sp_real u[3], sp_real d[3])
{
    const sp_real x = sp__dot3(u, t->n), y = sp__dot3(u, t->t1), z = sp__dot3(u, t->t2);
    d[0] = x; d[1] = y; d[2] = z;
}

/* Contact vertices that take part. */
static int32_t sp__points_count(const sp_scene *scene)
{
    int32_t n = 0;
    for (int32_t k = 0; k < scene->count.interfaces; k++)
        if (sp__contact_counts(scene, &scene->interface[k])) n += scene->interface[k].points;
    return n;
}

#if !defined(SP_SMALL) || !defined(SP_NO_PLAN)
/* What of an effect is in the scene. */
static int sp__effect_present(const sp_scene *scene, const sp_settings *set, int32_t islands, sp_effect effect)
{
    int friction = 0;
    for (int32_t k = 0; k < scene->count.interfaces; k++)
        friction |= sp__contact_counts(scene, &scene->interface[k]) && scene->interface[k].joint.mu > 0;
    return effect == SP_EFFECT_FRICTION ? friction
         : effect == SP_EFFECT_DEPTH ? 1
         : effect == SP_EFFECT_TOGETHER ? islands < 2
         : effect == SP_EFFECT_STRENGTH ? sp__scene_strong(scene)
         : effect == SP_EFFECT_LOADS ? scene->count.loads > 0
         : effect == SP_EFFECT_LIVE ? sp__scene_live(scene)
         : effect == SP_EFFECT_COUPLED && set->coupled.asked;
}
#endif

static void sp__problem_count(const sp_scene *scene, sp_problem *problem)
{
    problem->scene = scene;
    problem->blocks = problem->contacts = 0;
    problem->points = scene->count.points;
    problem->ordered = problem->endless = 0;
    for (int32_t k = 0; k < scene->count.blocks; k++)
        if (scene->block[k].fixed != SP_FIXED) problem->blocks++;
    for (int32_t k = 0; k < scene->count.interfaces; k++)
        if (sp__contact_counts(scene, &scene->interface[k])) problem->contacts++;
}

static void sp__problem_carve(sp_problem *problem, sp_arena *a)
{
    problem->block = sp__take(a, (size_t)problem->blocks, sizeof *problem->block);
    problem->contact = sp__take(a, (size_t)problem->contacts, sizeof *problem->contact);
    problem->local = sp__take(a, (size_t)problem->points, sizeof *problem->local);
    problem->p = sp__take(a, (size_t)problem->blocks, 6 * sizeof *problem->p);
    problem->live = NULL;
    if (sp__scene_live(problem->scene)) problem->live = sp__take(a, (size_t)problem->blocks, 6 * sizeof *problem->live);
}

SP_API size_t sp_problem_memory(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem problem;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &problem);
    sp__problem_carve(&problem, &dry);
    return sp__failed(&dry) ? 0 : dry.used;
}

/* Row of a block of the scene among the free ones (their numbers ascend), -1: a support. */
static int32_t sp__problem_row(const sp_problem *problem, int32_t block)
{
    int32_t lo = 0, hi = problem->blocks;
    while (lo < hi) {
        const int32_t mid = lo + (hi - lo) / 2;
        if (problem->block[mid] < block) lo = mid + 1; else hi = mid;
    }
    return lo < problem->blocks && problem->block[lo] == block ? lo : -1;
}

/* Points of a contact from their mean, in its frame; the mean goes to `mean`, seen from the first point. Differences are taken
 * of neighbouring places only, so coordinates far from the origin lose nothing. */
static void sp__contact_local(const sp_problem *problem, const sp_interface *f, sp_real mean[3])
{
    const sp_real (*point)[3] = (const sp_real (*)[3])problem->scene->point + f->point;
    sp_real x[3];
    mean[0] = mean[1] = mean[2] = 0;
    for (int32_t k = 1; k < f->points; k++) {
        sp__sub3(point[k], point[0], x);
        sp__add3(mean, 1, x);
    }
    sp__scale3((sp_real)1 / (sp_real)f->points, mean, mean);
    for (int32_t k = 0; k < f->points; k++) {
        sp_real *local = problem->local[f->point + k];
        sp__sub3(point[k], point[0], x);
        sp__sub3(x, mean, x);
        sp__joint_frame(f, x, local);
    }
}

/* One contact: rows, frame, arms (first point - centroid) + (mean - first point). */
static void sp__contact_build(const sp_problem *problem, int32_t id, sp_contact *contact)
{
    const sp_scene *scene = problem->scene;
    const sp_interface *f = &scene->interface[id];
    contact->id = id;
    contact->a = sp__problem_row(problem, f->a);
    contact->b = sp__problem_row(problem, f->b);
    contact->point = f->point;
    contact->points = f->points;
    contact->joint = f;
    sp_real mean[3];
    sp__contact_local(problem, f, mean);
    const sp_real *first = scene->point[f->point], *ca = scene->block[f->a].centroid, *cb = scene->block[f->b].centroid;
    sp__sub3(first, ca, contact->ra);
    sp__add3(contact->ra, 1, mean);
    sp__sub3(first, cb, contact->rb);
    sp__add3(contact->rb, 1, mean);
}

/* p += (F, M + (x - c) x F) of a force F at x with a couple M. */
static void sp__load_add(sp_real *p, const sp_real F[3], const sp_real M[3], const sp_real x[3], const sp_real c[3])
{
    sp_real r[3];
    sp__sub3(x, c, r);
    sp__cross3_add(r, F, p + 3);
    sp__add3(p, 1, F);
    sp__add3(p + 3, 1, M);
}

/* One load: what always acts goes to p, what counts scene.live times to problem.live. */
static void sp__problem_load(const sp_problem *problem, const sp_load *load, int32_t row)
{
    const sp_scene *scene = problem->scene;
    const sp_real *c = scene->block[load->block].centroid, none[3] = { 0, 0, 0 };
    sp_real *p = problem->p + 6 * (size_t)row, *live = problem->live ? problem->live + 6 * (size_t)row : p;
    sp_real weight[3];
    sp__load_add(load->live ? live : p, load->force, load->couple, load->point, c);
    if (!(load->mass > 0)) return;
    sp__scale3(load->mass, scene->gravity, weight);
    sp__load_add(load->live ? live : p, weight, none, load->point, c);
    sp__scale3(load->mass, scene->body, weight);
    sp__load_add(live, weight, none, load->point, c);
}

/* What rounding leaves of terms that cancel is no load: q = (F, M) on a block, a sum of its weight, `share` of this load, others.
 * Each component has rounding of its own, for a push sideways hides no weight. A point is known no better than its place.
 *   g: what the load's mass weighs by, `share` times [m/s^2]
 *   own: acceleration of the block and of all masses on it [m/s^2] */
static void sp__load_cancel(sp_real *q, const sp_load *load, sp_real share, const sp_real g[3], const sp_real own[3],
                            const sp_block *block)
{
    const sp_real noise = 16 * (sp_real)SP_EPSILON, near = (sp__norm3(load->point) + sp__norm3(block->centroid)) / 4;
    sp_real F[3];
    for (int k = 0; k < 3; k++) {
        F[k] = share * (sp__abs(load->force[k]) + sp__abs(g[k]) * load->mass) + sp__abs(own[k]) * (load->mass + block->mass);
        if (sp__abs(q[k]) > noise * F[k]) return;
    }
    q[0] = q[1] = q[2] = 0;
    if (sp__norm3(q + 3) <= noise * (share * sp__norm3(load->couple) + sp__norm3(F) * near)) q[3] = q[4] = q[5] = 0;
}

/* The same in the sums that a load is part of. The smallest build knows no body force here, nor what live loads leave of each
 * other. */
static void sp__load_settle(const sp_problem *problem, const sp_load *load, int32_t row)
{
    const sp_scene *scene = problem->scene;
    const sp_block *block = &scene->block[load->block];
    const sp_real times = sp__abs(scene->live);
    const sp_real *own = scene->gravity;
    sp_real both[3];
    if (SP__FULL) {
        for (int k = 0; k < 3; k++) both[k] = sp__abs(own[k]) + times * sp__abs(scene->body[k]);
        own = both;
    }
    sp__load_cancel(problem->p + 6 * (size_t)row, load, load->live ? times : 1, scene->gravity, own, block);
    if (SP__FULL && problem->live && load->live)
        sp__load_cancel(problem->live + 6 * (size_t)row, load, 1, scene->gravity, scene->body, block);
}

/* p = weight + loads + live multiple x live ones; a held direction keeps its row, whoever solves masks it. */
static sp_status sp__problem_loads(sp_problem *problem)
{
    const sp_scene *scene = problem->scene;
    if (!sp__finite(scene->live) || !sp__finite3(scene->gravity) || !sp__finite3(scene->body)) return SP_E_NOT_FINITE;
    memset(problem->p, 0, (size_t)problem->blocks * 6 * sizeof *problem->p);
    if (problem->live) memset(problem->live, 0, (size_t)problem->blocks * 6 * sizeof *problem->live);
    for (int32_t i = 0; i < problem->blocks; i++) {
        const sp_real mass = scene->block[problem->block[i]].mass;
        sp__scale3(mass, scene->gravity, problem->p + 6 * (size_t)i);
        if (problem->live) sp__scale3(mass, scene->body, problem->live + 6 * (size_t)i);
    }
    for (int32_t k = 0; k < scene->count.loads; k++) {
        const int32_t row = sp__problem_row(problem, scene->load[k].block);
        if (row >= 0) sp__problem_load(problem, &scene->load[k], row);
    }
    for (size_t k = 0; k < 6 * (size_t)problem->blocks; k++) {
        if (problem->live) problem->p[k] += scene->live * problem->live[k];
        if (!sp__finite(problem->p[k] * problem->p[k])) return SP_E_NOT_FINITE;
    }
    for (int32_t k = 0; k < scene->count.loads; k++) {
        const int32_t row = sp__problem_row(problem, scene->load[k].block);
        if (row >= 0) sp__load_settle(problem, &scene->load[k], row);
    }
    return SP_OK;
}

/* Loads and contacts, everything relative to the centroids. */
static sp_status sp__problem_fill(sp_problem *problem)
{
    const sp_scene *scene = problem->scene;
    int32_t row = 0, contact = 0;
    for (int32_t k = 0; k < scene->count.blocks; k++) if (scene->block[k].fixed != SP_FIXED) problem->block[row++] = k;
    const sp_status status = sp__problem_loads(problem);
    if (status) return status;
    memset(problem->local, 0, (size_t)problem->points * sizeof *problem->local);
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        if (!sp__contact_counts(scene, &scene->interface[k])) continue;
        sp_contact *c = &problem->contact[contact++];
        sp__contact_build(problem, k, c);
        sp_real size = sp__dot3(c->ra, c->ra) + sp__dot3(c->rb, c->rb);
        for (int32_t v = 0; v < c->points; v++) size += sp__dot3(problem->local[c->point + v], problem->local[c->point + v]);
        if (!sp__finite(size)) return SP_E_NOT_FINITE;
    }
    return SP_OK;
}

SP_API sp_status sp_problem_build(const sp_scene *scene, sp_arena *arena, sp_problem *problem)
{
    if (!scene || !arena || !arena->base || !problem) return SP_E_ARGUMENT;
    if (scene->count.blocks == 0) return SP_E_EMPTY;
    sp_arena a = *arena;
    sp_problem made;
    sp__problem_count(scene, &made);
    sp__problem_carve(&made, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    const sp_status status = sp__problem_fill(&made);
    if (status) return status;
    *arena = a;
    *problem = made;
    return SP_OK;
}

/* 9 ------------------------------------------------------------------------------------------------------------- matrices */

static void sp__triplets_carve(sp_triplets *t, int32_t count, sp_arena *a)
{
    t->i = sp__take(a, (size_t)count, sizeof *t->i);
    t->j = sp__take(a, (size_t)count, sizeof *t->j);
    t->x = sp__take(a, (size_t)count, sizeof *t->x);
}

/* An entry, unless it is 0; without room (x NULL) it is only counted, without j its column is known from the order. */
static void sp__triplets_put(sp_triplets *t, int32_t i, int32_t j, sp_real x)
{
    if (!(sp__abs(x) > 0)) return;
    if (t->j) t->j[t->count] = j;
    if (t->x) { t->i[t->count] = i; t->x[t->count] = x; }
    t->count++;
}

/* The column of force s e at arm r on the rows of one block:  [ s e ; s r x e ]. */
static void sp__aeq_column(sp_triplets *t, int32_t row, int32_t column, sp_real s, const sp_real r[3], const sp_real e[3])
{
    sp_real x[6];
    sp__scale3(s, e, x);
    sp__cross3(r, x, x + 3);
    for (int32_t c = 0; c < 6; c++) sp__triplets_put(t, 6 * row + c, column, x[c]);
}

/* Column c of one contact vertex, rows ascending: f on B with arm r - c_B, -f on A with arm r - c_A. */
static void sp__aeq_vertex(sp_triplets *t, const sp_problem *problem, const sp_contact *contact, int32_t v, int32_t columns,
                           int32_t c)
{
    const sp_scene *scene = problem->scene;
    const sp_interface *f = &scene->interface[contact->id];
    const int32_t extra = columns - 3;                  /* 1: fm after fp */
    const sp_real *e = c <= extra ? contact->joint->n : c - extra == 1 ? contact->joint->t1 : contact->joint->t2;
    const sp_real s = c == 1 && extra ? (sp_real)-1 : (sp_real)1;
    for (int side = 0; side < 2; side++) {
        const int onto_b = (contact->a < contact->b) == side;
        const int32_t row = onto_b ? contact->b : contact->a;
        sp_real r[3];
        if (row < 0) continue;
        sp__sub3(scene->point[v], scene->block[onto_b ? f->b : f->a].centroid, r);
        sp__aeq_column(t, row, columns * v + c, onto_b ? s : -s, r, e);
    }
}

static void sp__aeq_entries(sp_triplets *t, const sp_problem *problem, int32_t columns)
{
    t->count = 0;
    for (int32_t k = 0; k < problem->contacts; k++) {
        const sp_contact *contact = &problem->contact[k];
        for (int32_t q = 0; q < columns * contact->points; q++)
            sp__aeq_vertex(t, problem, contact, contact->point + q / columns, columns, q % columns);
    }
}

SP_API sp_status sp_matrix_aeq(const sp_problem *problem, int32_t columns, sp_arena *arena, sp_triplets *out)
{
    if (!problem || !problem->scene || !arena || !arena->base || !out) return SP_E_ARGUMENT;
    if (columns != 3 && columns != 4) return SP_E_RANGE;
    if (problem->blocks > INT32_MAX / 6 || problem->points > INT32_MAX / (2 * 6 * columns)) return SP_E_MEMORY;
    sp_arena a = *arena;
    sp_triplets t = { 6 * problem->blocks, columns * problem->points, 0, NULL, NULL, NULL };
    sp__aeq_entries(&t, problem, columns);
    sp__triplets_carve(&t, t.count, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    sp__aeq_entries(&t, problem, columns);
    *arena = a;
    *out = t;
    return SP_OK;
}

/* Rows of the friction pyramid. */
typedef struct sp__friction {
    int32_t faces, net, first;          /* first: row of vertex 0 */
    sp_real shrink;                     /* mu_eff / mu */
} sp__friction;

static void sp__friction_open(sp__friction *r, int32_t faces, int32_t inscribed, int32_t net, int32_t first)
{
    sp_real tangent;
    r->faces = faces;
    r->net = net;
    r->first = first;
    sp__pyramid_half(faces, &r->shrink, &tangent);
    (void)tangent;
    if (!inscribed) r->shrink = (sp_real)1;
}

/* Column c of one contact vertex: cos_k ft1 + sin_k ft2 - mu_eff (fp or fp - fm). */
static void sp__afr_vertex(sp_triplets *t, const sp__friction *r, const sp_contact *contact, int32_t v, int32_t columns, int32_t c)
{
    const sp_real mu = r->shrink * contact->joint->joint.mu;
    const int32_t tangent = c - (columns - 2);          /* 0, 1: ft1, ft2 */
    for (int32_t k = 0; k < r->faces; k++) {
        const int32_t row = r->first + r->faces * v + k;
        sp_real d[2];
        sp__pyramid_direction(r->faces, k, d);
        if (tangent >= 0) sp__triplets_put(t, row, columns * v + c, d[tangent]);
        else if (c == 0) sp__triplets_put(t, row, columns * v, -mu);
        else if (r->net) sp__triplets_put(t, row, columns * v + 1, mu);
    }
}

static void sp__afr_entries(sp_triplets *t, const sp_problem *problem, const sp_settings *settings, int32_t columns)
{
    sp__friction r;
    sp__friction_open(&r, settings->faces, settings->inscribed, settings->net, 0);
    t->count = 0;
    for (int32_t k = 0; k < problem->contacts; k++) {
        const sp_contact *contact = &problem->contact[k];
        for (int32_t q = 0; q < columns * contact->points; q++)
            sp__afr_vertex(t, &r, contact, contact->point + q / columns, columns, q % columns);
    }
}

SP_API sp_status sp_matrix_afr(const sp_problem *problem, const sp_settings *settings, int32_t columns, sp_arena *arena,
                               sp_triplets *out)
{
    if (!problem || !problem->scene || !settings || !arena || !arena->base || !out) return SP_E_ARGUMENT;
    if ((columns != 3 && columns != 4) || settings->faces < SP__FACES_MIN || settings->faces > SP__FACES_MAX) return SP_E_RANGE;
    if (sp__scene_strong(problem->scene)) return SP_E_UNSUPPORTED;
    if (problem->points > INT32_MAX / (4 * settings->faces)) return SP_E_MEMORY;
    sp_arena a = *arena;
    sp_triplets t = { settings->faces * problem->points, columns * problem->points, 0, NULL, NULL, NULL };
    sp__afr_entries(&t, problem, settings, columns);
    sp__triplets_carve(&t, t.count, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    sp__afr_entries(&t, problem, settings, columns);
    *arena = a;
    *out = t;
    return SP_OK;
}

/* 10 --------------------------------------------------------------------------------------------------- certificate check */

/* What a force state or a motion proves, from the scene alone. Nothing here is used by the search, nothing of the search here:
 * own projection, own sums, world coordinates instead of contact frames.                                   [DESIGN 3]
 *
 *   f0            bilateral least-squares force: least imbalance, then least norm
 *   sbar, Sbar    |load| + sum |f0_v|,  |couple| + sum |(r_v - c) x f0_v| + 16 u sbar max |r_v - c| / tol
 *   caps          c_v = force_bound min(sbar_A, sbar_B) over the free blocks of a contact
 */
#ifdef SP_REAL_FLOAT
#define SP__SCALE_TOL ((sp_real)1e-4)   /* f0 is a scale: this many digits of it */
#define SP__SCALE_NULL ((sp_real)3e-6)  /* what the normal matrix makes of a residual that nothing can take away, relative */
#else
#define SP__SCALE_TOL ((sp_real)1e-9)
#define SP__SCALE_NULL ((sp_real)1e-14)
#endif
#define SP__SCALE_KNOWN ((sp_real)1e-3) /* imbalance of f0, relative to a block's load, up to which it is that block's scale */

typedef struct sp__scale {
    sp_real load, couple;               /* |force|, |moment| of the load */
    sp_real f0, m0, arm;                /* sum |f0_v|, sum |(r_v - c) x f0_v|, max |r_v - c| */
    sp_real s, S;                       /* sbar, Sbar */
    sp_real cap;                        /* sbar that bounds the forces of its contacts */
    sp_real known;                      /* 1: f0 balances this block */
    sp_real wf, wm;                     /* row weights of the least-squares problem: 1 / rms of a column */
} sp__scale;

/* Numbers only: sp__lesser walks through it in steps of whole numbers, and i386 aligns a double to half of one. */
typedef char sp__scale_is_numbers[sizeof(sp__scale) % sizeof(sp_real) == 0 ? 1 : -1];

#define SP__FLOPS_JUDGE 90              /* a vertex in a sweep: >= 2 for the scales, 1 for forces or a triple, 7 for a motion */

typedef struct sp__judge {
    const sp_problem *pb;
    const sp_settings *set;             /* tol and force_bound resolved */
    sp_real mu_factor, tan_half;        /* mu_eff / mu; tan(pi/K) */
    sp_real (*direction)[2];            /* of the pyramid's faces */
    sp__scale *scale;                   /* b */
    sp_real *x, *e, *r, *p, *q, *g;     /* 6b each: potential of f0 in two parts, residual, direction, G p, G r */
    sp_real unit;                       /* of force [N]; everything below is counted in it */
    sp_real total;                      /* sum of |load| */
    sp_real cap;                        /* of the contact at hand */
    sp_real resist;                     /* sum c_v |P_K(u_v)| of the motion judged last */
    int32_t sweeps;                     /* passes over all contact vertices, for the work count */
    int32_t most;                       /* of them, for the scales */
} sp__judge;

static void sp__judge_carve(sp__judge *j, const sp_problem *pb, int32_t faces, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    j->pb = pb;
    j->scale = sp__take(a, b, sizeof *j->scale);
    j->direction = sp__take(a, (size_t)faces, sizeof *j->direction);
    j->x = sp__take(a, b, 6 * sizeof *j->x);
    j->e = sp__take(a, b, 6 * sizeof *j->e);
    j->r = sp__take(a, b, 6 * sizeof *j->r);
    j->p = sp__take(a, b, 6 * sizeof *j->p);
    j->q = sp__take(a, b, 6 * sizeof *j->q);
    j->g = sp__take(a, b, 6 * sizeof *j->g);
}

SP__APART static size_t sp__judge_need(const sp_problem *pb, const sp_settings *set)
{
    sp__judge j;
    sp_arena dry = sp__arena_dry();
    sp__judge_carve(&j, pb, set->faces, &dry);
    return dry.peak;
}

/* a / b for a, b >= 0; 0 / 0 is 0; SP__HUGE for what is larger or no number. */
static sp_real sp__ratio(sp_real a, sp_real b)
{
    if (a <= 0 && a >= 0) return 0;
    if (b > 1) return a / b < SP__HUGE ? a / b : SP__HUGE;      /* there SP__HUGE b may leave the range of float */
    return a < SP__HUGE * b ? a / b : SP__HUGE;
}

/* A unit of force in which no square over- or underflows: the largest component of a load, of a couple where there are none. */
static sp_real sp__load_unit(const sp_problem *pb)
{
    sp_real force = 0, couple = 0;
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) {
        const sp_real x = sp__abs(pb->p[k]);
        if (k % 6 < 3) force = sp__max(force, x);
        else couple = sp__max(couple, x);
    }
    return force > 0 ? force : couple > 0 ? couple : 1;
}

/* sbar of the free blocks of a contact, the smaller. */
static sp_real sp__lesser(const sp_contact *t, const sp_real *s, size_t stride)
{
    if (t->a < 0) return s[stride * (size_t)t->b];
    if (t->b < 0) return s[stride * (size_t)t->a];
    const sp_real a = s[stride * (size_t)t->a], b = s[stride * (size_t)t->b];
    return a < b ? a : b;
}

/* The directions in which free block i is held do not count. */
static int sp__held(const sp_problem *pb, int32_t i, int k)
{
    return (int)(pb->scene->block[pb->block[i]].fixed >> k & 1u);
}

static void sp__release(const sp_problem *pb, int32_t i, sp_real row[6])
{
    for (int k = 0; k < 6; k++) if (sp__held(pb, i, k)) row[k] = 0;
}

/* r_v - c_i for a free block i, zero for a support. */
static void sp__arm(const sp_problem *pb, int32_t i, int32_t v, sp_real arm[3])
{
    arm[0] = arm[1] = arm[2] = 0;
    if (i >= 0) sp__sub3(pb->scene->point[v], pb->scene->block[pb->block[i]].centroid, arm);
}

/* u = velocity of B seen from A at vertex v of a contact, v_i + w_i x (r - c_i) of each. With `scale` the motion is given in
 * weighted rows. */
static void sp__vertex_velocity(const sp_problem *pb, const sp__scale *scale, const sp_contact *t, int32_t v,
                                const sp_real *motion, sp_real u[3])
{
    u[0] = u[1] = u[2] = 0;
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->a : t->b;
        if (i < 0) continue;
        const sp_real *m = motion + 6 * (size_t)i, sign = side ? -1 : 1;
        const sp_real wf = scale ? scale[i].wf : 1, wm = scale ? scale[i].wm : 1;
        sp_real arm[3], w[3];
        sp__arm(pb, i, v, arm);
        sp__cross3(m + 3, arm, w);
        for (int k = 0; k < 3; k++) u[k] += sign * (wf * m[k] + wm * w[k]);
    }
}

/* (F, (r - c) x F) added to the row of B, taken off that of A; |F| and |(r - c) x F| to both blocks' sums (may be NULL). */
static void sp__vertex_force(const sp_problem *pb, const sp_contact *t, int32_t v, const sp_real F[3], sp_real *row, sp_real *sum)
{
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->a : t->b;
        if (i < 0) continue;
        sp_real arm[3], m[3], *to = row + 6 * (size_t)i;
        const sp_real sign = side ? -1 : 1;
        sp__arm(pb, i, v, arm);
        sp__cross3(arm, F, m);
        for (int k = 0; k < 3; k++) { to[k] += sign * F[k]; to[3 + k] += sign * m[k]; }
        if (sum) { sum[2 * (size_t)i] += sp__norm3(F); sum[2 * (size_t)i + 1] += sp__norm3(m); }
    }
}

/* The load of free block i in units. */
static void sp__judge_load(const sp__judge *j, int32_t i, sp_real p[6])
{
    for (size_t k = 0; k < 6; k++) p[k] = j->pb->p[6 * (size_t)i + k] / j->unit;
}

/* r = p, q = 0: where balances and their sums start. */
static void sp__judge_start(sp__judge *j)
{
    for (size_t k = 0; k < 6 * (size_t)j->pb->blocks; k++) {
        j->r[k] = j->pb->p[k] / j->unit;
        j->q[k] = 0;
    }
}

/* Free blocks' load sizes, longest arms, and row weights 1/sqrt(number of vertices), 1/sqrt(2/3 sum |r_v - c|^2), which do
 * not depend on units or axes. */
static void sp__judge_weights(sp__judge *j)
{
    const sp_problem *pb = j->pb;
    j->total = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        sp_real p[6];
        sp__judge_load(j, i, p);
        s->load = sp__norm3(p);
        s->couple = sp__norm3(p + 3);
        s->f0 = s->m0 = s->arm = s->wf = s->wm = 0;
        j->total += s->load;
    }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++)
            for (int side = 0; side < 2; side++) {
                const int32_t i = side ? t->b : t->a;
                if (i < 0) continue;
                sp__scale *s = &j->scale[i];
                sp_real arm[3];
                sp__arm(pb, i, v, arm);
                const sp_real l = sp__norm3(arm);
                if (l > s->arm) s->arm = l;
                s->wf += 1;
                s->wm += l * l * 2 / 3;
            }
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        s->wf = s->wf > 0 ? 1 / SP_SQRT(s->wf) : 0;
        s->wm = s->wm > 0 ? 1 / SP_SQRT(s->wm) : 0;
    }
}

/* row <- W row, held rows to zero. */
static void sp__judge_weigh(const sp__judge *j, sp_real *row)
{
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        sp_real *w = row + 6 * (size_t)i;
        for (int k = 0; k < 3; k++) { w[k] *= j->scale[i].wf; w[k + 3] *= j->scale[i].wm; }
        sp__release(j->pb, i, w);
    }
}

/* out = W Aeq Aeq' W in; Aeq Aeq' needs no frames because a vertex's three forces are orthonormal. */
static void sp__judge_normal(sp__judge *j, const sp_real *in, sp_real *out)
{
    const sp_problem *pb = j->pb;
    memset(out, 0, 6 * (size_t)pb->blocks * sizeof *out);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3];
            sp__vertex_velocity(pb, j->scale, t, v, in, u);
            sp__vertex_force(pb, t, v, u, out, NULL);
        }
    }
    sp__judge_weigh(j, out);
    j->sweeps++;
}

static sp_real sp__dot(const sp_real *a, const sp_real *b, size_t n)
{
    sp_real s = 0;
    for (size_t k = 0; k < n; k++) s += a[k] * b[k];
    return s;
}

/* a = s a + t b. */
static void sp__add(sp_real *a, sp_real s, sp_real t, const sp_real *b, size_t n)
{
    for (size_t k = 0; k < n; k++) a[k] = s * a[k] + t * b[k];
}

/* Conjugate residuals for G d = r, G = W Aeq Aeq' W semidefinite, r in j->r (used up); `to` += d. Stops when what is left of r
 * is small, or as small as it can be (G times it vanishes), or without progress: rounding holds both over as many steps as news
 * takes along half the blocks.                                                                                    [Stiefel 1955] */
SP__APART static void sp__judge_solve(sp__judge *j, sp_real *to)
{
    const size_t n = 6 * (size_t)j->pb->blocks;
    const sp_real small = SP__SCALE_TOL * SP__SCALE_TOL, null = SP__SCALE_NULL * SP__SCALE_NULL, start = sp__dot(j->r, j->r, n);
    sp__judge_normal(j, j->r, j->g);
    memcpy(j->p, j->r, n * sizeof *j->p);
    memcpy(j->q, j->g, n * sizeof *j->q);
    sp_real rg = sp__dot(j->r, j->g, n), last_r = SP__HUGE, last_g = SP__HUGE;
    for (int32_t it = 0; it < 1000 + 6 * j->pb->blocks; it++) {
        const sp_real rr = sp__dot(j->r, j->r, n), gg = sp__dot(j->g, j->g, n), qq = sp__dot(j->q, j->q, n);
        if (rr <= small * start || gg <= null * rr || !(qq > 0) || !(rg > 0) || j->sweeps >= j->most) return;
        if (it % (100 + j->pb->blocks / 2) == 0) {
            if (rr > (sp_real)0.9 * last_r && gg > last_g / 2) return;
            last_r = rr;
            last_g = gg;
        }
        const sp_real alpha = rg / qq;
        sp__add(to, 1, alpha, j->p, n);
        sp__add(j->r, 1, -alpha, j->q, n);
        sp__judge_normal(j, j->r, j->g);
        const sp_real next = sp__dot(j->r, j->g, n), beta = next / rg;
        sp__add(j->p, beta, 1, j->r, n);
        sp__add(j->q, beta, 1, j->g, n);
        rg = next;
    }
}

/* Does f0 balance a block, so that it is its scale? Residual r of its rows, to a few digits of its load or to the rounding of
 * what runs through it. */
static int sp__scale_known(const sp_real r[6], sp_real load, sp_real f0, sp_real arm)
{
    const sp_real enough = SP__SCALE_KNOWN * load + 10000 * (sp_real)SP_EPSILON * f0;
    return sp__norm3(r) <= enough && sp__norm3(r + 3) <= enough * arm;
}

/* f0 = Aeq' W (x + e), the two parts taken vertex by vertex, so that a pebble's share of a cathedral's potential is not lost in
 * rounding. j->r = Aeq f0 + p; every block's sums, and whether they are its scale.     returns how many blocks are not known */
static int32_t sp__judge_sums(sp__judge *j)
{
    const sp_problem *pb = j->pb;
    int32_t unknown = 0;
    sp__judge_start(j);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real f[3], rest[3];
            sp__vertex_velocity(pb, j->scale, t, v, j->x, f);
            sp__vertex_velocity(pb, j->scale, t, v, j->e, rest);
            for (int k = 0; k < 3; k++) f[k] += rest[k];
            sp__vertex_force(pb, t, v, f, j->r, j->q);
        }
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        sp__release(pb, i, j->r + 6 * (size_t)i);
        s->f0 = j->q[2 * (size_t)i];
        s->m0 = j->q[2 * (size_t)i + 1];
        s->known = (sp_real)sp__scale_known(j->r + 6 * (size_t)i, s->load, s->f0, s->arm);
        unknown += s->known < 1;
    }
    j->sweeps++;
    return unknown;
}

/* One of the two parts of a hint y0 = W x into `to`; what is no number counts as none. */
static void sp__judge_hint(const sp__judge *j, const sp_real *y0, sp_real *to)
{
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        sp_real *x = to + 6 * (size_t)i;
        for (size_t k = 0; k < 6; k++) {
            const sp_real w = k < 3 ? j->scale[i].wf : j->scale[i].wm;
            x[k] = y0 && w > 0 ? y0[6 * (size_t)i + k] / j->unit / w : 0;
            if (!sp__finite(x[k] * x[k])) x[k] = 0;
        }
        sp__release(j->pb, i, x);
    }
}

/* Nothing can make the residual j->r (weighted) smaller: G r vanishes, or, at the last, is what rounding of the forces makes of
 * it, as where a block turns about an edge: 64 u |W (|p| + |f0|)|. */
static int sp__judge_optimal(sp__judge *j, int last)
{
    const size_t n = 6 * (size_t)j->pb->blocks;
    sp_real sum = 0;
    for (int32_t i = 0; SP__FULL && last && i < j->pb->blocks; i++) {
        const sp__scale *s = &j->scale[i];
        const sp_real f = s->wf * (s->load + s->f0), m = s->wm * (s->couple + s->m0);
        sum += f * f + m * m;
    }
    sp__judge_normal(j, j->r, j->g);
    const sp_real gg = sp__dot(j->g, j->g, n);
    return gg <= SP__SCALE_NULL * SP__SCALE_NULL * sp__dot(j->r, j->r, n)
        || (SP__FULL && last && gg <= 4096 * (sp_real)SP_EPSILON * (sp_real)SP_EPSILON * sum);
}

/* x + e minimises |W (Aeq f0 + p)|, and f0 has least norm among the minimisers: from the hint y0, which is believed as far as
 * its residual goes, else by our own solve, corrected twice.     returns 0 when neither settled */
static int sp__judge_bilateral(sp__judge *j, const sp_real *y0)
{
    const size_t n = 6 * (size_t)j->pb->blocks;
    for (int own = !y0; own < 2; own++) {
        sp__judge_hint(j, own ? NULL : y0, j->x);
        sp__judge_hint(j, own ? NULL : y0 + n, j->e);
        for (int round = 0; round < 4 && j->sweeps + 2 <= j->most; round++) {
            if (!sp__judge_sums(j)) return 1;
            sp__judge_weigh(j, j->r);
            if ((round || !own) && sp__judge_optimal(j, round == 3)) return 1;
            if (!own || round == 3 || j->sweeps + 2 > j->most) break;
            for (size_t k = 0; k < n; k++) j->r[k] = -j->r[k];
            sp__judge_solve(j, round ? j->e : j->x);
        }
    }
    return 0;
}

/* |couple| + m + 16 u sbar max |r_v - c| / tol. */
static sp_real sp__scale_couple(const sp__judge *j, const sp__scale *s, sp_real m)
{
    return s->couple + m + 16 * (sp_real)SP_EPSILON * s->s * s->arm / j->set->tol;
}

/* The scales of every free block. One that f0 does not balance (nothing does, or its share is lost in rounding) has its load
 * alone as scale of a balance, and for its caps f0 and what rounding of all loads may hide in it; where f0 is not settled, a
 * thousand times all loads, more than what a bilateral force comes to. With j->most = 0 the loads alone, f0 = 0: no scale is
 * larger than the true one, so forces that pass by these pass by those. */
static void sp__judge_scales(sp__judge *j, const sp_real *y0)
{
    sp__judge_weights(j);
    const int settled = j->most ? sp__judge_bilateral(j, y0) : 1;
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        sp__scale *s = &j->scale[i];
        if (!j->most) s->known = 1;
        s->cap = s->load + s->f0;
        if (s->known < 1) {
            s->cap = settled ? s->cap + 10000 * (sp_real)SP_EPSILON * j->total : 1000 * j->total;
            s->f0 = s->load;
            s->m0 = s->load * s->arm;
        }
        s->s = s->load + s->f0;
        s->S = sp__scale_couple(j, s, s->m0);
    }
}

/* c_v of the vertices of a contact. */
static sp_real sp__judge_cap(const sp__judge *j, const sp_contact *t)
{
    return j->set->force_bound * sp__lesser(t, &j->scale->cap, sizeof *j->scale / sizeof j->scale->cap);
}

/* Strength of a vertex in units; none where the joint has none. */
static sp__strength sp__judge_strength(const sp__judge *j, const sp_contact *t)
{
    const sp__strength none = { 0, 0, SP__HUGE };
    if (!SP__FULL || !sp__contact_strong(j->pb, t)) return none;
    sp__strength k = sp__vertex_strength(t->joint, j->pb->endless);
    k.C *= j->mu_factor / j->unit;
    k.T /= j->unit;
    k.N = sp__ratio(k.N, j->unit);
    return k;
}

/* An admissible force near f: fn kept, ft shortened onto the cone; no tension beyond strength, no more than the cap (K_v is
 * convex and holds 0, so a shortened force stays in it). out may be f. */
static void sp__judge_admit(const sp__judge *j, const sp_contact *t, const sp_real f[3], sp_real out[3])
{
    const sp_real mu = t->joint->joint.mu * j->mu_factor;
    const int32_t faces = SP__FULL ? j->set->faces : 0;
    const sp_real slip[3] = { 0, f[1], f[2] };
    sp_real most = faces ? 0 : sp__norm3(slip);         /* the largest tangential share any face sees */
    for (int32_t k = 0; k < faces; k++) {
        const sp_real *d = j->direction[k];
        const sp_real s = d[0] * f[1] + d[1] * f[2];
        if (s > most) most = s;
    }
    const sp__strength k = sp__judge_strength(j, t);
    const sp_real fn = f[0] > k.N ? k.N : f[0] > -k.T ? f[0] : -k.T, room = sp__max(0, k.C + mu * fn);
    const sp_real share = most > room ? room / most : 1;
    out[0] = fn;
    out[1] = f[1] * share;
    out[2] = f[2] * share;
    const sp_real size = sp__norm3(out);
    if (size > j->cap) sp__scale3(j->cap / size, out, out);
}

/* omega of a force state: admitted, then the largest of |r_i| / s_i and |m_i| / S_i, s_i = |load| + min(sum |f_v|, sum |f0_v|),
 * S_i likewise. `admitted` (may be NULL) gets the forces that were judged, 3 x points. */
SP__APART static sp_real sp__judge_forces(sp__judge *j, const sp_real *f, sp_real *admitted)
{
    const sp_problem *pb = j->pb;
    sp__judge_start(j);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        j->cap = sp__judge_cap(j, t);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real g[3], F[3];
            for (size_t k = 0; k < 3; k++) g[k] = f[3 * (size_t)v + k] / j->unit;
            sp__judge_admit(j, t, g, g);
            sp__joint_force(t->joint, g, F);
            sp__vertex_force(pb, t, v, F, j->r, j->q);
            if (admitted) sp__scale3(j->unit, g, admitted + 3 * (size_t)v);
        }
    }
    j->sweeps++;
    sp_real omega = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp__scale *s = &j->scale[i];
        const sp_real f1 = j->q[2 * (size_t)i], m1 = j->q[2 * (size_t)i + 1];
        const sp_real si = s->load + (f1 < s->f0 ? f1 : s->f0), Si = sp__scale_couple(j, s, m1 < s->m0 ? m1 : s->m0);
        sp_real *row = j->r + 6 * (size_t)i;
        sp__release(pb, i, row);
        omega = sp__max(omega, sp__max(sp__ratio(sp__norm3(row), si), sp__ratio(sp__norm3(row + 3), Si)));
    }
    return omega;
}

/* |P_K(u)| = largest u.g over unit g in K: over the foot on each face that falls inside it, and over each edge. */
SP__APART static sp_real sp__judge_resist(const sp__judge *j, const sp_contact *t, const sp_real u[3])
{
    const sp_real mu = t->joint->joint.mu * j->mu_factor;
    const int32_t faces = SP__FULL ? j->set->faces : 0;
    const sp_real z = SP_SQRT(u[1] * u[1] + u[2] * u[2]), all = SP_SQRT(u[0] * u[0] + z * z);
    if (!faces) {
        if (u[0] >= 0 && z <= mu * u[0]) return all;
        const sp_real along = (u[0] + mu * z) / SP_SQRT(1 + mu * mu);
        return along > 0 ? along : 0;
    }
    const sp_real edge = mu * j->tan_half;              /* half the width of a face at fn = 1 */
    sp_real best = 0, most = 0;
    for (int32_t k = 0; k < faces; k++) {
        const sp_real *d = j->direction[k];
        const sp_real a = d[0] * u[1] + d[1] * u[2], b = d[0] * u[2] - d[1] * u[1];
        if (a > most) most = a;
        const sp_real fn = (u[0] + mu * a) / (1 + mu * mu), width = b < 0 ? -b : b;
        if (fn > 0 && width <= edge * fn) {
            const sp_real foot = SP_SQRT(fn * fn * (1 + mu * mu) + b * b);
            if (foot > best) best = foot;
        }
        const sp_real e = (u[0] + mu * a + edge * b) / SP_SQRT(1 + mu * mu + edge * edge);
        if (e > best) best = e;
    }
    return u[0] >= 0 && most <= mu * u[0] ? all : best;
}

/* Largest f.u over f in K_v, |f| <= cap; K_v with strength lies between its lower rim (fn = -T, |ft| = low) and its upper one.
 *   over the hull of both rims:             max(low a - T un, high a + N un),  a = |ut|, of a pyramid d . ut + tan(pi/K) |d x ut|
 *   over lower rim + cone, |f| <= cap:      low a - T un + (cap + T + low / cos(pi/K)) |P_cone(u)|            for the best d
 * Both bound it, so the lesser does. *capped: is the cap needed; stays 0, becomes 0 where the first is the lesser. */
SP__APART static sp_real sp__judge_support(const sp__judge *j, const sp_contact *t, const sp_real u[3], sp_real P, sp_real cap,
                                           int *capped)
{
    const sp_real mu = t->joint->joint.mu * j->mu_factor, corner = SP_SQRT(1 + j->tan_half * j->tan_half);
    const sp__strength k = sp__judge_strength(j, t);
    sp_real a = j->set->faces ? 0 : SP_SQRT(u[1] * u[1] + u[2] * u[2]);
    for (int32_t q = 0; q < j->set->faces; q++) {
        const sp_real *d = j->direction[q];
        a = sp__max(a, d[0] * u[1] + d[1] * u[2] + j->tan_half * sp__abs(d[0] * u[2] - d[1] * u[1]));
    }
    const sp_real low = sp__max(0, k.C - mu * k.T), foot = low * a - k.T * u[0], top = (k.C + mu * k.N) * a + k.N * u[0];
    const sp_real shut = foot > top ? foot : top, open = foot + (cap + k.T + low * corner) * P;
    if (shut <= open) *capped = 0;
    return shut < open ? shut : open;
}

/* Longest arm of block i to a joint; where nothing touches it 1, for it may turn. */
static sp_real sp__judge_arm(const sp__judge *j, int32_t i) { return j->scale[i].arm > 0 ? j->scale[i].arm : 1; }

/* Largest displacement of a joint of block i. */
static sp_real sp__judge_moved(const sp__judge *j, int32_t i)
{
    if (i < 0) return 0;
    const sp_real *m = j->x + 6 * (size_t)i;
    return sp__norm3(m) + sp__norm3(m + 3) * sp__judge_arm(j, i);
}

/* j->x = dq in units of its largest displacement, whatever its own unit, where blocks that move less than `rest` of that are
 * held.     returns how many are; -1: nothing moves */
SP__APART static int32_t sp__judge_hold(sp__judge *j, const sp_real *dq, sp_real rest)
{
    sp_real largest = 0;
    int32_t held = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t i = 0; i < j->pb->blocks; i++) {
            sp_real *m = j->x + 6 * (size_t)i;
            for (size_t k = 0; k < 6; k++) m[k] = pass ? dq[6 * (size_t)i + k] / largest : dq[6 * (size_t)i + k];
            sp__release(j->pb, i, m);
            const sp_real size = sp__judge_moved(j, i);
            if (!pass) largest = sp__max(largest, size);
            else if (size <= rest) { memset(m, 0, 6 * sizeof *m); held++; }
        }
        if (!(largest > 0) || !sp__finite(largest)) return -1;
    }
    return held;
}

/* load . x, and the same of the scales. */
SP__APART static sp_real sp__judge_work(const sp__judge *j, sp_real *scale)
{
    sp_real work = 0, p[6];
    *scale = 0;
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        const sp_real *m = j->x + 6 * (size_t)i;
        sp__judge_load(j, i, p);
        work += sp__dot(p, m, 6);
        *scale += j->scale[i].s * sp__norm3(m) + j->scale[i].S * sp__norm3(m + 3);
    }
    return work;
}

/* How far a motion is a proof: (p . dq - sum c_v |P_K(u_v)|) / sum (sbar_i |v_i| + Sbar_i |w_i|), u = -Aeq' dq, where blocks
 * that move less than `rest` of the largest motion are held. A value above tol proves that no force state of this cone within
 * its caps comes nearer to equilibrium than that value. *final: no contact resists at all.
 * The held motion is left in j->x. */
SP__APART static sp_real sp__judge_motion(sp__judge *j, const sp_real *dq, sp_real rest, int32_t *final)
{
    const sp_problem *pb = j->pb;
    *final = 0;
    j->resist = 0;
    if (sp__judge_hold(j, dq, rest) < 0) return 0;
    sp_real scale, resist = 0;
    const sp_real work = sp__judge_work(j, &scale);
    *final = 1;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real cap = sp__judge_cap(j, t), moved = sp__judge_moved(j, t->a) + sp__judge_moved(j, t->b);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real w[3];
            sp__vertex_velocity(pb, NULL, t, v, j->x, w);
            sp__joint_frame(t->joint, w, w);
            const sp_real u[3] = { -w[0], -w[1], -w[2] }, P = sp__judge_resist(j, t, u);
            int capped = P > 256 * (sp_real)SP_EPSILON * moved;         /* below that: rounding of dq and u */
            resist += SP__FULL && sp__contact_strong(pb, t) ? sp__judge_support(j, t, u, P, cap, &capped) : cap * P;
            if (capped) *final = 0;
        }
    }
    j->sweeps++;
    j->resist = resist;
    if (SP__FULL && j->set->faces && j->set->inscribed) *final = 0;
    return work > resist ? sp__ratio(work - resist, scale) : 0;
}

/* Shares of the largest motion below which blocks are held. */
static const sp_real sp__judge_rest[6] = { 0, (sp_real)1e-12, (sp_real)1e-9, (sp_real)1e-6, (sp_real)1e-3, (sp_real)0.5 };

/* The best proof a motion gives, a final one before others, with smaller motions held. It is left in j->x. */
static sp_real sp__judge_mechanism(sp__judge *j, const sp_real *dq, int32_t *final)
{
    sp_real best = -1, held = 0, value = -1;
    int32_t sure = 0, last = 0, before = -2;
    for (int k = 0; k < 6; k++) {
        const int32_t still = sp__judge_hold(j, dq, sp__judge_rest[k]);
        if (still == before) continue;                  /* the same motion */
        before = still;
        value = sp__judge_motion(j, dq, sp__judge_rest[k], final);
        *final &= value > j->set->tol;
        last = *final > sure || (*final == sure && value > best);
        if (last) { best = value; held = sp__judge_rest[k]; sure = *final; }
    }
    return last ? value : sp__judge_motion(j, dq, held, final);
}

/* Units, friction cone and its directions. */
static void sp__judge_cone(sp__judge *j, const sp_problem *pb, const sp_settings *set)
{
    j->unit = sp__load_unit(pb);
    j->set = set;
    j->mu_factor = 1;
    j->tan_half = 0;
    j->sweeps = 0;
    if (!SP__FULL || !set->faces) return;
    sp_real c;
    sp__pyramid_half(set->faces, &c, &j->tan_half);
    if (set->inscribed) j->mu_factor = c;
    for (int32_t k = 0; k < set->faces; k++) sp__pyramid_direction(set->faces, k, j->direction[k]);
}

/* Set up a judge in `a` and find the scales in at most so many sweeps, 2 or more; 0: least scales.
 *     returns 0 when the arena is too small */
SP__APART static int sp__judge_open(sp__judge *j, const sp_problem *pb, const sp_settings *set, const sp_real *y0, int32_t most,
                                    sp_arena *a)
{
    sp__judge_carve(j, pb, set->faces, a);
    if (sp__failed(a)) return 0;
    sp__judge_cone(j, pb, set);
    j->most = most;
    sp__judge_scales(j, y0);
    return 1;
}

#ifndef SP_SMALL
/* Sweeps the judge may take for the scales out of so many flops. */
static int32_t sp__budget_sweeps(const sp_settings *set, const sp_problem *pb, int64_t flops)
{
    if (set->budget <= 0 || pb->points == 0) return INT32_MAX;
    const int64_t sweeps = flops / (SP__FLOPS_JUDGE * (int64_t)pb->points) - 8;
    return sweeps < INT32_MAX ? (int32_t)sweeps : INT32_MAX;
}
#endif

#ifndef SP_NO_CRA
/* What a triple (f, dq, alpha) of the coupled check may be out by, in units of its length L: a pressing joint by SP__GIVE, slip
 * that takes friction at least SP__SLIP and opposite within SP__SLIP, and what rounding hides in a motion: of a gap SP__GIVE_MOST
 * at most, or a block that spins about the points it is held at would hide all of it. */
#ifdef SP_REAL_FLOAT
#define SP__GIVE ((sp_real)1e-4)
#define SP__GIVE_MOST ((sp_real)1e-2)
#define SP__SLIP ((sp_real)1e-2)
#define SP__SLIP_ROUNDING (400 * (sp_real)SP_EPSILON)
#else
#define SP__GIVE ((sp_real)1e-10)
#define SP__GIVE_MOST ((sp_real)1e-6)
#define SP__SLIP ((sp_real)1e-6)
#define SP__SLIP_ROUNDING (4000000 * (sp_real)SP_EPSILON)
#endif
#define SP__GIVE_ROUNDING (16 * (sp_real)SP_EPSILON)

/* Largest tol of a coupled check: by so much a triple may miss balance, so a coarse one would certify what lies beyond its limit,
 * and no proof would reach as far. */
#define SP__COUPLED_TOL ((sp_real)(sizeof(sp_real) == 8 ? 1e-6 : 1e-4))

/* Lengths of the coupled check; eps and eta are counted in L: (1, eta / eps), or (0, 1) where eps is 0. */
typedef struct sp__lengths { sp_real L, eps, eta; } sp__lengths;

/* Mean edge of the joints that take part; where they have none (points), mean distance of a joint from its blocks' centroids. */
static sp_real sp__mean_edge(const sp_problem *pb)
{
    sp_real edges = 0, arms = 0;
    int32_t count = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const int32_t n = t->points > 2 ? t->points : t->points - 1;
        for (int32_t k = 0; k < n; k++) {
            sp_real e[3];
            sp__sub3(pb->scene->point[t->point + (k + 1) % t->points], pb->scene->point[t->point + k], e);
            edges += sp__norm3(e);
        }
        count += n;
        arms += (sp__norm3(t->ra) + sp__norm3(t->rb)) / 2;
    }
    if (edges > 0) return edges / (sp_real)count;
    return arms > 0 ? arms / (sp_real)pb->contacts : 1;
}

static sp__lengths sp__coupled_lengths(const sp_problem *pb, const sp_settings *set)
{
    const sp_coupled_settings *cs = &set->coupled;
    const sp_real edge = sp__mean_edge(pb), eps = cs->eps < 0 ? (sp_real)1e-4 * edge : cs->eps;
    const sp_real eta = cs->eta > 0 ? cs->eta : eps > 0 ? 100 * eps : (sp_real)1e-2 * edge;
    sp__lengths k = { eps, 1, 0 };
    if (eps > 0) k.eta = eta / eps;
    else { k.L = eta; k.eps = 0; k.eta = 1; }
    return k;
}

/* dd of vertex v of contact t in its frame, for the motion j->x. */
static void sp__judge_rate(const sp__judge *j, const sp_contact *t, int32_t v, sp_real d[3])
{
    sp_real w[3];
    sp__vertex_velocity(j->pb, NULL, t, v, j->x, w);
    d[0] = sp__dot3(w, t->joint->n); d[1] = sp__dot3(w, t->joint->t1); d[2] = sp__dot3(w, t->joint->t2);
}

/* The spin of block i about the line through all its contact points, if they lie on one: it moves no contact, so motions are
 * judged without it, and proofs need not bound it. In weighted rows z = dq / W, |k| = 1.     returns 0: there is none */
SP__APART static int sp__judge_spin(const sp__judge *j, int32_t i, sp_real k[6])
{
    const sp_problem *pb = j->pb;
    sp_real first[3] = { 0, 0, 0 }, line[3] = { 0, 0, 0 }, far = 0;
    int32_t seen = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t c = 0; c < pb->contacts; c++) {
            const sp_contact *t = &pb->contact[c];
            for (int32_t v = t->point; (t->a == i || t->b == i) && v < t->point + t->points; v++) {
                sp_real r[3], off[3];
                sp__arm(pb, i, v, r);
                if (!seen++) memcpy(first, r, sizeof first);
                sp__sub3(r, first, r);
                sp__cross3(line, r, off);
                if (pass && sp__norm3(off) > 64 * (sp_real)SP_EPSILON * j->scale[i].arm) return 0;
                if (pass || !(sp__norm3(r) > far)) continue;
                far = sp__norm3(r);
                memcpy(line, r, sizeof line);
            }
        }
        if (!(far > 0)) return 0;
        if (!pass) sp__scale3(1 / far, line, line);
    }
    sp__cross3(first, line, k);                         /* of the centroid */
    sp_real size = 0;
    for (int q = 0; q < 6; q++) {
        k[q] = q < 3 ? k[q] / j->scale[i].wf : line[q - 3] / j->scale[i].wm;
        if (sp__held(pb, i, q) && sp__abs(k[q]) > 0) return 0;
        size += k[q] * k[q];
    }
    for (int q = 0; q < 6; q++) k[q] /= SP_SQRT(size);
    return 1;
}

/* dq of block i without that spin; twice, for what rounding leaves of a fast one. */
static void sp__judge_stop(const sp__judge *j, int32_t i, sp_real *dq)
{
    sp_real k[6];
    if (!sp__judge_spin(j, i, k)) return;
    for (int round = 0; round < 2; round++) {
        sp_real along = 0;
        for (int q = 0; q < 6; q++) along += k[q] * dq[q] / (q < 3 ? j->scale[i].wf : j->scale[i].wm);
        for (int q = 0; q < 6; q++) dq[q] -= along * k[q] * (q < 3 ? j->scale[i].wf : j->scale[i].wm);
    }
}

/* Worst violation of the conditions at one vertex relative to what is allowed. d: dd / L; ft and -alpha dt in units of force;
 * least: force below which friction is not asked for its slip. */
static sp_real sp__coupled_vertex(const sp__lengths *k, int box, const sp_real f[3], sp_real alpha, const sp_real d[3],
                                  sp_real moved, sp_real least)
{
    const sp_real hidden = SP__GIVE_ROUNDING * moved, gap = d[0] + k->eps;
    const sp_real g = SP__GIVE + (hidden < SP__GIVE_MOST ? hidden : SP__GIVE_MOST);
    const sp_real slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
    const sp_real most = box ? sp__max(sp__abs(d[1]), sp__abs(d[2])) : slip;
    sp_real worst = sp__max(d[0], most) > k->eta ? (sp__max(d[0], most) - k->eta) / g : 0;
    if (gap < 0 || f[0] > 0) worst = sp__max(worst, sp__abs(gap) / g);
    if (!(alpha >= 0)) return SP__HUGE;
    if (ft > least) {
        const sp_real x = f[1] + alpha * d[1], y = f[2] + alpha * d[2];
        worst = sp__max(worst, sp__ratio(SP_SQRT(x * x + y * y), SP__SLIP * ft));
        worst = sp__max(worst, sp__ratio(SP__SLIP + SP__SLIP_ROUNDING * moved, slip));
    }
    return worst < SP__HUGE ? worst : SP__HUGE;
}

/* Residual of a triple: f (3 x points), dq (6b), alpha (points).                                       [Kao 2022, Eqs. 8-10] */
SP__APART static sp_real sp__judge_coupled(sp__judge *j, const sp__lengths *k, const sp_real *f, const sp_real *dq,
                                           const sp_real *alpha)
{
    const sp_problem *pb = j->pb;
    const int few = sp__points_count(pb->scene) <= SP_EXACT_POINTS;       /* only then there are proofs */
    for (int32_t i = 0; i < pb->blocks; i++) {
        for (size_t q = 0; q < 6; q++) j->x[6 * (size_t)i + q] = dq[6 * (size_t)i + q] / k->L;
        sp__release(pb, i, j->x + 6 * (size_t)i);
        if (few) sp__judge_stop(j, i, j->x + 6 * (size_t)i);
    }
    sp_real worst = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real moved = sp__judge_moved(j, t->a) + sp__judge_moved(j, t->b);
        const sp_real least = j->set->tol * sp__lesser(t, &j->scale->s, sizeof *j->scale / sizeof j->scale->s);
        j->cap = sp__judge_cap(j, t);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real g[3], d[3];
            for (size_t q = 0; q < 3; q++) g[q] = f[3 * (size_t)v + q] / j->unit;
            sp__judge_admit(j, t, g, g);
            sp__judge_rate(j, t, v, d);
            worst = sp__max(worst, sp__coupled_vertex(k, j->set->coupled.box, g, alpha[v] * k->L / j->unit, d, moved, least));
        }
    }
    j->sweeps++;
    return worst;
}
/* A proof that there is no triple, walked and added up. Its tree splits the states of the vertices (sp_proof); in a leaf the
 * multipliers y of linear rows a x <= b that hold for every triple of these states, x = (f, dq), with c = sum y a, show
 *
 *     sum y b  <  min c x  over the box   0 <= fn <= F, |ft| <= mu F, |dq_r| <= M_r
 *
 * so there is no such triple. What a triple may be out by (tol, SP__GIVE, SP__SLIP) and what rounding may do, (32 + number of
 * multipliers) u times all products' sizes, is taken off. M: G x_r = e_r, G = Aeq Aeq' weighted, gives dq_r = sum (Aeq' x_r).d,
 * and every |d| is bounded.
 */
typedef struct sp__refute {
    sp__judge *j;
    const sp__lengths *k;
    const sp_proof *proof;
    int32_t points;                     /* V: vertices that take part */
    int32_t *contact, *at, *state;      /* V */
    int32_t *stack;                     /* 2 x SP__PROOF_DEPTH x V: vertex, state before */
    sp_real *most, total;               /* V: F; bound of sum fn */
    sp_real *small;                     /* V: friction of any direction */
    sp_real (*f)[3], (*d)[3];           /* V: c on f and on d, contact frame */
    sp_real *fsize, *dsize;             /* V: sizes of what was added up there */
    sp_real *motion;                    /* 6b: multipliers of the balance; then c on dq */
    sp_real *reach;                     /* 6b: M */
    sp_real work;                       /* multiplier of the row of work */
    sp_real right, size, slack;         /* sum y b; sizes of its products; sum |y| of what rows may be out by */
    sp_real loose;                      /* what the row of work may be out by */
} sp__refute;

#define SP__PROOF_DEPTH 32              /* splits above a leaf, for every vertex */
#define SP__PROOF_ROWS 24               /* rows of a vertex */

static void sp__refute_carve(sp__refute *w, int32_t points, int32_t blocks, sp_arena *a)
{
    const size_t n = (size_t)points;
    w->points = points;
    w->contact = sp__take(a, n, sizeof *w->contact);
    w->at = sp__take(a, n, sizeof *w->at);
    w->state = sp__take(a, n, sizeof *w->state);
    w->stack = sp__take(a, n, 2 * SP__PROOF_DEPTH * sizeof *w->stack);
    w->most = sp__take(a, n, sizeof *w->most);
    w->small = sp__take(a, n, sizeof *w->small);
    w->f = sp__take(a, n, sizeof *w->f);
    w->d = sp__take(a, n, sizeof *w->d);
    w->fsize = sp__take(a, n, sizeof *w->fsize);
    w->dsize = sp__take(a, n, sizeof *w->dsize);
    w->motion = sp__take(a, (size_t)blocks, 6 * sizeof *w->motion);
    w->reach = sp__take(a, (size_t)blocks, 6 * sizeof *w->reach);
}

SP__APART static size_t sp__refute_need(int32_t points, int32_t blocks)
{
    sp__refute w;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof w);
    sp__refute_carve(&w, points, blocks, &dry);
    return dry.used;
}

/* sum over vertices of |Aeq' W x| times the largest |d|, for x in j->x. */
static sp_real sp__refute_stretch(const sp__refute *w)
{
    const sp_problem *pb = w->j->pb;
    const sp_real far = w->k->eta + w->k->eps;          /* >= |dn|, |dt1|, |dt2| */
    sp_real sum = 0;
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        sp_real u[3];
        sp__vertex_velocity(pb, w->j->scale, t, w->at[v], w->j->x, u);
        sum += sp__norm3(u) * 2 * far;                  /* 2 > sqrt 3 */
    }
    return sum;
}

/* e_r without the spin of its block. */
static void sp__refute_unit(const sp__judge *j, int32_t r, sp_real *e)
{
    sp_real k[6];
    for (int32_t q = 0; q < 6 * j->pb->blocks; q++) e[q] = q == r;
    if (!sp__judge_spin(j, r / 6, k)) return;
    for (int32_t q = 0; q < 6; q++) e[r / 6 * 6 + q] -= k[r % 6] * k[q];
}

/* M: |z_r| <= S_r + |G x_r - e_r| max |z|, z = dq / W, and z has no spin.     returns 0: contacts do not bound every motion */
SP__APART static int sp__refute_reach(sp__refute *w)
{
    sp__judge *j = w->j;
    const int32_t n = 6 * j->pb->blocks;
    sp_real farthest = 0, worst = 0;
    for (int pass = 0; pass < 2; pass++) {
        if (!(worst < (sp_real)0.5)) return 0;
        for (int32_t r = 0; r < n; r++) {
            const sp_real weight = r % 6 < 3 ? j->scale[r / 6].wf : j->scale[r / 6].wm;
            sp_real miss = 0;
            w->reach[r] = 0;
            if (sp__held(j->pb, r / 6, r % 6)) continue;
            sp__refute_unit(j, r, j->r);
            for (int32_t q = 0; q < n; q++) j->x[q] = 0;
            sp__judge_solve(j, j->x);
            sp__judge_normal(j, j->x, j->g);
            sp__refute_unit(j, r, j->r);
            for (int32_t q = 0; q < n; q++) miss += sp__abs(j->g[q] - j->r[q]);
            const sp_real stretch = sp__refute_stretch(w);
            farthest = sp__max(farthest, stretch);
            if (!pass) worst = sp__max(worst, miss);
            else w->reach[r] = (sp_real)1.01 * weight * (stretch + miss * farthest / (1 - worst));
        }
    }
    return 1;
}

/* F and its sum, by the caps and by work: g sum fn <= p . dq; and what that row may be out by. */
static void sp__refute_forces(sp__refute *w)
{
    sp__judge *j = w->j;
    const sp_problem *pb = j->pb;
    sp_real work = 0;
    w->loose = w->total = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *m = w->reach + 6 * (size_t)i;
        sp_real p[6];
        sp__judge_load(j, i, p);
        for (int k = 0; k < 6; k++) work += sp__abs(p[k]) * m[k];
        w->loose += j->set->tol * (j->scale[i].s * (m[0] + m[1] + m[2]) + j->scale[i].S * (m[3] + m[4] + m[5]));
    }
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        w->most[v] = sp__judge_cap(j, t);
        w->total += w->most[v];
        w->small[v] = j->set->tol * sp__lesser(t, &j->scale->s, sizeof *j->scale / sizeof j->scale->s);
        w->loose += 2 * w->small[v] * w->k->eta;
    }
    if (w->k->eps > 0) {
        const sp_real bound = (sp_real)1.01 * (work + w->loose);
        w->total = bound < w->total ? bound : w->total;
        for (int32_t v = 0; v < w->points; v++) w->most[v] = bound < w->most[v] ? bound : w->most[v];
    }
    w->loose += SP__GIVE * w->total;
}

/* Unit vector at `turn` of 2^halvings parts of a quarter turn after the x axis: the half-angle formulas, bit by bit. */
static void sp__refute_direction(int32_t turn, int32_t halvings, sp_real d[2])
{
    sp_real c = 0, s = 1;                               /* of a quarter turn, halved again and again */
    d[0] = 1; d[1] = 0;
    for (int32_t q = turn >> halvings; q > 0; q--) { const sp_real x = d[0]; d[0] = -d[1]; d[1] = x; }
    for (int32_t bit = halvings - 1; bit >= 0; bit--) {
        const sp_real half = SP_SQRT((1 + c) / 2);
        s = s / (2 * half);
        c = half;
        if (!(turn >> bit & 1)) continue;
        const sp_real x = d[0] * c - d[1] * s;
        d[1] = d[1] * c + d[0] * s;
        d[0] = x;
    }
}

/* A row on f: y (fn n + ft . (x, y)) */
static void sp__refute_on_force(sp__refute *w, int32_t v, sp_real y, sp_real n, sp_real t1, sp_real t2)
{
    w->f[v][0] += y * n;
    w->f[v][1] += y * t1;
    w->f[v][2] += y * t2;
    w->fsize[v] += sp__abs(y) * (sp__abs(n) + sp__abs(t1) + sp__abs(t2));
}

static void sp__refute_on_motion(sp__refute *w, int32_t v, sp_real y, sp_real n, sp_real t1, sp_real t2)
{
    w->d[v][0] += y * n;
    w->d[v][1] += y * t1;
    w->d[v][2] += y * t2;
    w->dsize[v] += sp__abs(y) * (sp__abs(n) + sp__abs(t1) + sp__abs(t2));
}

static void sp__refute_right(sp__refute *w, sp_real y, sp_real b)
{
    w->right += y * b;
    w->size += sp__abs(y * b);
}

/* Rows of the sector of a vertex: slip and friction between its ends, friction's cone near it.     returns 0: no such row */
SP__APART static int sp__refute_sector(sp__refute *w, int32_t v, int32_t row, sp_real y)
{
    const sp__judge *j = w->j;
    const sp_contact *t = &j->pb->contact[w->contact[v]];
    const sp_real mu = t->joint->joint.mu * j->mu_factor;
    const int32_t faces = j->set->faces;
    int32_t h = 0, end;
    if (w->state[v] < 4) return 0;
    while (w->state[v] >> h > 7) h++;
    end = w->state[v] - (4 << h);                       /* the sector: from end to end + 1 parts of 4 2^h */
    sp_real d[2];
    if (row == 5) {                                     /* m . dt <= eta */
        if (j->set->coupled.box || y < 0) return 0;
        sp__refute_direction(2 * end + 1, h + 1, d);
        sp__refute_on_motion(w, v, y, 0, d[0], d[1]);
        sp__refute_right(w, y, w->k->eta);
    } else if (row < 10) {                              /* a x dt >= 0, b x dt <= 0; ft: s = SP__SLIP |ft| / fn */
        const int second = row == 7 || row == 9, force = row >= 8;
        if ((y > 0) != (second != force)) return 0;
        sp__refute_direction(end + second, h, d);
        const sp_real most = SP__SLIP * mu * SP_SQRT(1 + j->tan_half * j->tan_half);
        if (force) sp__refute_on_force(w, v, y, second ? most : -most, -d[1], d[0]);
        else sp__refute_on_motion(w, v, y, 0, -d[1], d[0]);
        if (force) w->slack += sp__abs(y) * w->small[v];
    } else {                                            /* friction opposite to a, m, b, or on the three faces there */
        if (y < 0 || (faces && faces <= 8)) return 0;
        if (faces) {
            const int64_t whole = (int64_t)8 << h, face = (faces * (2 * (2 * (int64_t)end + 1) + whole) + whole) / (2 * whole);
            sp__pyramid_direction(faces, (int32_t)((face + faces + row - 11) % faces), d);
        } else {
            sp__refute_direction(2 * end + row - 10, h + 1, d);
            d[0] = -d[0]; d[1] = -d[1];
        }
        sp__refute_on_force(w, v, y, -mu, d[0], d[1]);
    }
    return 1;
}

/* Any row of a vertex, for its state.     returns 0: no such row, or not with this sign */
SP__APART static int sp__refute_vertex(sp__refute *w, int32_t v, int32_t row, sp_real y)
{
    const sp__judge *j = w->j;
    const int32_t state = w->state[v], faces = j->set->faces;
    sp_real d[2];
    if (row >= 5 && row < 13) return sp__refute_sector(w, v, row, y);
    if (row == 0) {                                     /* -g <= dn <= eta, = -g */
        sp__refute_on_motion(w, v, y, 1, 0, 0);
        sp__refute_right(w, y, y > 0 && state < 2 ? w->k->eta : -w->k->eps);
    } else if (row < 5) {                               /* |dt| <= eta along 0, 45, 90, 135 degrees */
        if (row % 2 == 0 && j->set->coupled.box) return 0;
        sp__pyramid_direction(8, row - 1, d);
        sp__refute_on_motion(w, v, y, 0, d[0], d[1]);
        sp__refute_right(w, sp__abs(y), w->k->eta);
    } else if (row < 21) {                              /* the cone around */
        const int exact = faces && faces <= 8;
        sp_real mu = j->pb->contact[w->contact[v]].joint->joint.mu * j->mu_factor;
        if (y < 0 || (exact && row - 13 >= faces)) return 0;
        if (faces && !exact) mu *= SP_SQRT(1 + j->tan_half * j->tan_half);
        sp__pyramid_direction(exact ? faces : 8, row - 13, d);
        sp__refute_on_force(w, v, y, -mu, d[0], d[1]);
    } else {                                            /* fn >= 0; f = 0 */
        if (state != 1 && (row > 21 || y > 0)) return 0;
        sp__refute_on_force(w, v, y, row == 21, row == 22, row == 23);
    }
    return 1;
}

/* One multiplier.     returns 0: the proof is none */
static int sp__refute_add(sp__refute *w, int32_t row, sp_real y)
{
    const int32_t n = 6 * w->j->pb->blocks;
    if (row < 0 || row > n + SP__PROOF_ROWS * w->points || !sp__finite(y)) return 0;
    if (row < n) {                                      /* Aeq f = -p */
        sp_real p[6];
        if (sp__held(w->j->pb, row / 6, row % 6)) return 0;
        sp__judge_load(w->j, row / 6, p);
        w->motion[row] += y;
        sp__refute_right(w, y, -p[row % 6]);
        return 1;
    }
    if (row == n) { w->work += y; return y >= 0; }      /* g sum fn <= p . dq */
    return sp__refute_vertex(w, (row - n - 1) / SP__PROOF_ROWS, (row - n - 1) % SP__PROOF_ROWS, y);
}

/* c on f: what the multipliers of balance and work add, then the least c f over the box; taken off `right`. */
static sp_real sp__refute_least_force(sp__refute *w)
{
    sp__judge *j = w->j;
    const sp_problem *pb = j->pb;
    sp_real least = 0;
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) j->x[k] = w->motion[k];
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        const sp_real mu = t->joint->joint.mu * (1 + j->tan_half);
        sp_real u[3], *f = w->f[v];
        sp__vertex_velocity(pb, NULL, t, w->at[v], j->x, u);
        f[0] += sp__dot3(u, t->joint->n) + w->work * w->k->eps;
        f[1] += sp__dot3(u, t->joint->t1);
        f[2] += sp__dot3(u, t->joint->t2);
        w->fsize[v] += sp__judge_moved(j, t->a) + sp__judge_moved(j, t->b) + w->work * w->k->eps;
        least += w->most[v] * ((f[0] < 0 ? f[0] : 0) - mu * (sp__abs(f[1]) + sp__abs(f[2])));
        w->size += (1 + mu) * w->most[v] * w->fsize[v];
    }
    return least;
}

/* c on dq, and the least c dq over the box. */
static sp_real sp__refute_least_motion(sp__refute *w)
{
    const sp__judge *j = w->j;
    const sp_problem *pb = j->pb;
    sp_real least = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        sp_real p[6];
        sp__judge_load(j, i, p);
        for (size_t k = 0; k < 6; k++) {
            w->motion[6 * (size_t)i + k] = -w->work * p[k];
            w->size += sp__abs(w->work * p[k]) * w->reach[6 * (size_t)i + k];
        }
    }
    for (int32_t v = 0; v < w->points; v++) {
        const sp_contact *t = &pb->contact[w->contact[v]];
        sp_real F[3];
        const sp_real *d = w->d[v];
        for (int k = 0; k < 3; k++) F[k] = d[0] * t->joint->n[k] + d[1] * t->joint->t1[k] + d[2] * t->joint->t2[k];
        sp__vertex_force(pb, t, w->at[v], F, w->motion, NULL);
        sp_real moved = 0;
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->a : t->b;
            if (i < 0) continue;
            const sp_real *m = w->reach + 6 * (size_t)i;
            moved += m[0] + m[1] + m[2] + (m[3] + m[4] + m[5]) * j->scale[i].arm;
        }
        w->size += w->dsize[v] * moved;
        w->slack += w->dsize[v] * (SP__GIVE + SP__GIVE_ROUNDING * moved);
    }
    for (int32_t r = 0; r < 6 * pb->blocks; r++) least -= sp__abs(w->motion[r]) * w->reach[r];
    return least;
}

/* A leaf: multipliers from..to. How far it is from proving nothing, relative to sum |y b|: above 0 is a proof; 0: none */
SP__APART static sp_real sp__refute_leaf(sp__refute *w, int32_t from, int32_t to)
{
    const sp__judge *j = w->j;
    for (int32_t v = 0; v < w->points; v++) {
        for (int k = 0; k < 3; k++) w->f[v][k] = w->d[v][k] = 0;
        w->fsize[v] = w->dsize[v] = 0;
    }
    for (int32_t r = 0; r < 6 * j->pb->blocks; r++) w->motion[r] = 0;
    w->work = w->right = w->size = w->slack = 0;
    for (int32_t e = from; e < to; e++) if (!sp__refute_add(w, w->proof->row[e], w->proof->y[e])) return 0;
    w->slack += w->work * w->loose;
    for (int32_t i = 0; i < j->pb->blocks; i++) {
        const sp_real *m = w->motion + 6 * (size_t)i;
        w->slack += j->set->tol * (j->scale[i].s * sp__norm3(m) + j->scale[i].S * sp__norm3(m + 3));
    }
    const sp_real scale = w->size, forces = sp__refute_least_force(w), motions = sp__refute_least_motion(w);
    const sp_real margin = forces + motions - w->right - w->slack - (32 + (sp_real)(to - from)) * (sp_real)SP_EPSILON * w->size;
    return margin > 0 ? sp__ratio(margin, scale) : 0;
}

/* Walk the tree.     returns the least margin of its leaves, relative; 0: it proves nothing */
SP__APART static sp_real sp__refute_walk(sp__refute *w)
{
    const sp_proof *p = w->proof;
    int32_t depth = 0, entry = 0;
    sp_real least = SP__HUGE;
    for (int32_t v = 0; v < w->points; v++) w->state[v] = 0;
    for (int32_t k = 0; k < p->nodes; k++) {
        if (p->node[k] >= 0) {                          /* a vertex splits: 0 into 1, 2; 2 into 4..7; s into 2s, 2s + 1 */
            const int32_t v = p->node[k], state = v < w->points ? w->state[v] : 1;
            if (state == 1 || state >= 1 << 26 || depth == SP__PROOF_DEPTH * w->points) return 0;
            w->stack[2 * depth] = v;
            w->stack[2 * depth++ + 1] = state;
            w->state[v] = state ? 2 * state : 1;
            continue;
        }
        if (p->node[k] < -p->entries || entry > p->entries + p->node[k]) return 0;
        const sp_real margin = sp__refute_leaf(w, entry, entry - p->node[k]);
        if (margin < least) least = margin;
        if (!(least > 0)) return 0;
        entry -= p->node[k];
        for (; depth; depth--) {                        /* on to the next part of what was split last */
            const int32_t v = w->stack[2 * depth - 2], state = w->stack[2 * depth - 1];
            const int32_t last = state == 0 ? 2 : state == 2 ? 7 : 2 * state + 1;
            if (w->state[v] < last) { w->state[v]++; break; }
            w->state[v] = state;
        }
        if (!depth) return k + 1 == p->nodes ? least : 0;
    }
    return 0;
}

/* Does the proof hold?     returns its least margin, 0: no */
SP__APART static sp_real sp__judge_refuted(sp__judge *j, const sp__lengths *k, const sp_proof *proof, sp_arena *a)
{
    if (proof->nodes < 1 || proof->entries < 0 || !proof->node || !proof->row || !proof->y) return 0;
    if (sp__points_count(j->pb->scene) > SP_EXACT_POINTS) return 0;
    sp__refute *w = sp__take(a, 1, sizeof *w);
    if (!w) return 0;
    memset(w, 0, sizeof *w);
    sp__refute_carve(w, sp__points_count(j->pb->scene), j->pb->blocks, a);
    if (sp__failed(a)) return 0;
    w->j = j; w->k = k; w->proof = proof;
    for (int32_t c = 0, v = 0; c < j->pb->contacts; c++)
        for (int32_t q = 0; q < j->pb->contact[c].points; q++, v++) {
            w->contact[v] = c;
            w->at[v] = j->pb->contact[c].point + q;
        }
    if (!sp__refute_reach(w)) return 0;
    sp__refute_forces(w);
    return sp__refute_walk(w);
}
#endif /* SP_NO_CRA */

#ifndef SP_SMALL
/* 11 ------------------------------------------------------------------------------------------------------------ the dual */

/* A group of touching free blocks that reaches no support, pulled by F: every joint inside it stays as it is when the group
 * moves along F, so that motion does work |F|^2 > 0 against nothing. Turned by M, with F = 0: likewise, about M. With no load
 * at all f = 0 is the answer. */

static int32_t sp__root(int32_t *up, int32_t i)
{
    while (up[i] != i) { up[i] = up[up[i]]; i = up[i]; }
    return i;
}

static void sp__join(int32_t *up, int32_t i, int32_t k)
{
    i = sp__root(up, i); k = sp__root(up, k);
    if (i < k) up[k] = i; else up[i] = k;               /* the lowest number stands for the group; 0 is "supported" */
}

#define SP__ITERATIONS 300              /* factorisations of an exact solve, unless the caller wants others */

/* The stages a plan may shorten: those whose answer does not depend on which blocks are solved together, with the exact one; no
 * fewer iterations than usual, because what they buy is then told of the stages as they are. */
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
 *   planar         one plane (or planes parallel to it) is a mirror for every joint's corners, every centroid, every load and the
 *                  friction cones. The mirror image of forces that balance balances, and so does the mean of both: if there
 *                  are forces there are symmetric ones. Symmetric motions go in the plane and turn about its normal m, so of the
 *                  dual's 6 unknowns 3 are left, corners that mirror each other have equal rates and count as one, and P_K
 *                  keeps forces in the plane because the cone is symmetric. f0, unique, is symmetric as well, and so is the
 *                  optimum of the penalty form, which is strictly convex. A motion that no symmetric forces resist, none do:
 *                  their mean would.
 *   level          all loads along e, no joint but with n = +-e or across it: of their forces only fn of the first. Rows: force
 *                  along e, moments across it; the others are zero of themselves. Forces fn >= 0 lie in every friction cone, so
 *                  those that balance stand; where there are none friction may still help (a diamond of five rows).
 *   a forest       level without joints across, and the graph of supports (one node) and free blocks with one edge for all joints
 *                  of a pair in one plane has no cycle: friction cannot help, either.
 *     Forces: cut any edge; what hangs on it is pulled along e, and turned only about axes across e. So its friction sums to
 *     zero with no moment about e, and none about axes across e (all of it acts in one plane): fn alone balances as well.
 *     Motions: of one that fn does not resist let every block go sideways, from the supports upwards along the edges, so that
 *     the plane of its edge does not slip (slip of a plane that turns about axes in it is the same all over). Loads do no work
 *     in that, and u = (un, 0, 0) meets no more resistance in a cone than fn alone: |P_K(u)| = max(0, un).
 *     In the same way ft = 0 in f0 (the wrench of an edge is given, and fn alone is the shortest) and in the penalty form.
 *     It is not so with a cycle, with joints of one pair at two heights (a cycle), or with loads across: all are tested.
 *   slick          level without joints across, mu = 0: fn along e is all the force there is, and the three rows all that is not
 *                  zero of itself. What fn does not balance falls; only f0 is that of 6 rows, because bilateral joints hold sideways.
 *
 * A search in 3 rows keeps vectors of 6 in the axes e; of them the planar one uses 0, 1 and 5, the level one 2, 3 and 4. What it
 * finds is turned back and judged in 3 dimensions as everything is. */

typedef enum sp__mode { SP__PLANE, SP__PLUMB } sp__mode;

typedef struct sp__flat {
    sp__mode mode;
    int forest, slick;                  /* level: a forest; no friction, no joint across the loads */
    sp_real e[3][3];                    /* planar: e0, e1 in the plane, e2 = m; level: e2 along the loads, e0, e1 across */
    int32_t *mate;                      /* per contact vertex: its mirror image, itself where there is none; -1: takes no part */
    sp_real *g;                         /* SP__FLAT_G a contact: frame, see sp__flat_contact; T of a, of b, see sp__flat_weigh */
    int64_t vertices, sides;            /* vertices that count; free blocks of all contacts */
    int plain;                          /* no joint has strength */
    int spent;                          /* the budget ended its search */
} sp__flat;

#define SP__FLAT_G 20
/* Flops, planar and level: of a vertex in a sweep (u 7, P_K and S about 12, sums 7; u 10, S fn 2, sums 5); of the twist of a
 * free block of a contact there and back; of a vertex in an assembly (u 7, D about 16, q' D q 23; u 10, D 2, q' D q 16), of a
 * free block of a contact (H T 33, T' of it 26, half of what couples two 21). */
#define SP__FLOPS_FLAT_SWEEP(o) ((o)->mode == SP__PLANE ? 26 : 17)
#define SP__FLOPS_FLAT_TWIST 28
#define SP__FLOPS_FLAT_HESSIAN(o) ((o)->mode == SP__PLANE ? 46 : 28)
#define SP__FLOPS_FLAT_BLOCKS 80

#ifndef SP_NO_PLAN
/* Asymmetry, relative to arms, that is as good as none. */
static sp_real sp__flat_small(const sp_settings *set) { return sp__max(set->tol / 16, 16 * (sp_real)SP_EPSILON); }

/* The mirror image of vertex v of a contact, in its plane along h = (m.t1, m.t2); -1: there is none. */
static int32_t sp__flat_image(const sp_problem *pb, const sp_contact *t, int32_t v, const sp_real h[2], sp_real small)
{
    const sp_real *l = pb->local[v];
    const sp_real out = 2 * (l[1] * h[0] + l[2] * h[1]), x = l[1] - out * h[0], y = l[2] - out * h[1];
    for (int32_t k = t->point; k < t->point + t->points; k++) {
        const sp_real *o = pb->local[k];
        if (sp__abs(o[1] - x) <= small && sp__abs(o[2] - y) <= small && sp__abs(o[0] - l[0]) <= small) return k;
    }
    return -1;
}

/* Is m the normal of a mirror of this contact? */
static int sp__flat_mirror(const sp_problem *pb, const sp_settings *set, const sp_contact *t, const sp_real m[3])
{
    const sp_real h[2] = { sp__dot3(m, t->joint->t1), sp__dot3(m, t->joint->t2) }, eps = sp__flat_small(set);
    sp_real size = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) size = sp__max(size, sp__norm3(pb->local[v]));
    if (sp__abs(sp__dot3(m, t->joint->n)) > eps) return 0;
    if (t->a >= 0 && sp__abs(sp__dot3(m, t->ra)) > eps * (size + sp__norm3(t->ra))) return 0;
    if (t->b >= 0 && sp__abs(sp__dot3(m, t->rb)) > eps * (size + sp__norm3(t->rb))) return 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const int32_t image = sp__flat_image(pb, t, v, h, eps * size);
        if (image < 0 || sp__flat_image(pb, t, image, h, eps * size) != v) return 0;
    }
    return 1;
}

/* Are the loads symmetric: no force along m, no couple across it; frictionless (`plumb`): the other way round? */
static int sp__flat_loads(const sp_problem *pb, const sp_settings *set, const sp_real m[3], int plumb)
{
    const sp_real eps = sp__flat_small(set);
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *F = pb->p + 6 * (size_t)i, *M = F + 3, *along = plumb ? M : F, *across = plumb ? F : M;
        sp_real rest[3];
        for (int k = 0; k < 3; k++) rest[k] = across[k] - sp__dot3(across, m) * m[k];
        if (pb->scene->block[pb->block[i]].fixed) return 0;             /* held in some directions */
        if (sp__abs(sp__dot3(along, m)) > eps * sp__norm3(along) || sp__norm3(rest) > eps * sp__norm3(across)) return 0;
    }
    return 1;
}

/* The normal of the mirror: across the first joint's normal and what makes the widest angle with it, of normals and forces; where
 * all of that is parallel, `edge` (1 or 2) of the first joint's tangents.                          returns 0: there is none */
static int sp__flat_normal(const sp_problem *pb, int edge, sp_real m[3])
{
    const sp_interface *f = pb->contact[0].joint;
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
static int sp__flat_cone(const sp_settings *set, const sp_contact *t, const sp_real m[3])
{
    const sp_real x = sp__dot3(m, t->joint->t1), y = sp__dot3(m, t->joint->t2);
    sp_real c, half, plus = -1, minus = -1;
    if (!set->faces) return 1;
    sp__pyramid_half(set->faces, &c, &half);
    for (int32_t k = 0; k < set->faces; k++) {
        sp_real d[2];
        sp__pyramid_direction(set->faces, k, d);
        plus = sp__max(plus, d[1] * x - d[0] * y);
        minus = sp__max(minus, d[0] * y - d[1] * x);
    }
    const sp_real eps = sp__max(sp__flat_small(set), 64 * (sp_real)SP_EPSILON);
    return (plus >= 1 - eps || plus <= c + eps) && (minus >= 1 - eps || minus <= c + eps);
}

/* Is the problem planar?     m: the normal of the mirror */
SP__APART static int sp__flat_planar(const sp_problem *pb, const sp_settings *set, sp_real m[3])
{
    for (int edge = 1; pb->contacts && edge <= 2; edge++) {
        int32_t c = 0;
        if (!sp__flat_normal(pb, edge, m) || !sp__flat_loads(pb, set, m, 0)) continue;
        while (c < pb->contacts && sp__flat_mirror(pb, set, &pb->contact[c], m) && sp__flat_cone(set, &pb->contact[c], m)) c++;
        if (c == pb->contacts) return 1;
    }
    return 0;
}

/* May joints be taken for frictionless first, because that is likely to be the answer? All loads along m, which joints are level or
 * upright to, no mortar, and every block rests on something. */
SP__APART static int sp__flat_plumb(const sp_problem *pb, const sp_settings *set, const sp_real m[3])
{
    const sp_real eps = sp__flat_small(set);
    int32_t rests = 0;
    if (sp__scene_strong(pb->scene) || !sp__flat_loads(pb, set, m, 1)) return 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real along = sp__dot3(t->joint->n, m);
        sp_real across[3];
        sp__cross3(t->joint->n, m, across);
        if (sp__norm3(across) > eps && sp__abs(along) > eps) return 0;
        rests += (along < 0 && t->b >= 0) || (along > 0 && t->a >= 0);
    }
    return rests >= pb->blocks;
}

/* The direction of the loads: that of the first.     returns 0 where there is none */
static int sp__flat_down(const sp_problem *pb, sp_real m[3])
{
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *F = pb->p + 6 * (size_t)i;
        if (sp__norm3(F) > 0) { sp__unit3(F, m); return 1; }
    }
    return 0;
}

/* e0, e1 so that e is right-handed. */
static void sp__flat_axes(sp__flat *o)
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
static int sp__flat_choose(const sp_problem *pb, const sp_settings *set, sp__flat *o)
{
    const sp_choice *choice = set->effect;
    memset(o, 0, sizeof *o);
    if (!pb->blocks || !sp__plan_stages(set)) return 0;
    const int planar = choice[SP_EFFECT_DEPTH] != SP_WITH && choice[SP_EFFECT_FRICTION] != SP_WITHOUT
                    && sp__flat_planar(pb, set, o->e[2]);
    o->mode = planar ? SP__PLANE : SP__PLUMB;
    if (!planar && (choice[SP_EFFECT_FRICTION] == SP_WITH || !sp__flat_down(pb, o->e[2]))) return 0;
    if (!planar && !sp__flat_plumb(pb, set, o->e[2])) return 0;
    sp__flat_axes(o);
    return 1;
}

/* Takes part: planar every joint, level those along the loads. */
static void sp__flat_mates(sp__flat *o, const sp_problem *pb, const sp_settings *set)
{
    const sp_real eps = sp__flat_small(set);
    o->vertices = o->sides = 0;
    for (int32_t v = 0; v < pb->points; v++) o->mate[v] = -1;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real h[2] = { sp__dot3(o->e[2], t->joint->t1), sp__dot3(o->e[2], t->joint->t2) };
        const int level = h[0] * h[0] + h[1] * h[1] <= eps * eps;
        o->sides += (t->a >= 0) + (t->b >= 0);
        sp_real size = 0;
        for (int32_t v = t->point; v < t->point + t->points; v++) size = sp__max(size, sp__norm3(pb->local[v]));
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            if (o->mode == SP__PLANE) o->mate[v] = sp__flat_image(pb, t, v, h, eps * size);
            else if (level) o->mate[v] = v;
            o->vertices += o->mate[v] >= v;
        }
    }
}

/* Frame of a contact:
 *   planar         n in the plane (2), t = m x n in the joint's tangents (2), the nearest face's share of friction along t and
 *                  against it (2)
 *   level          t1, t2 along e0 (2), along e1 (2)                                                                         */
static void sp__flat_contact(const sp__flat *o, const sp__cone *cone, const sp_contact *t, sp_real *g)
{
    const sp_interface *f = t->joint;
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
static size_t sp__flat_row(const sp__flat *o, int k) { return (size_t)(o->mode == SP__PLUMB ? 2 + k : k < 2 ? k : 5); }

/* Components of a world vector along e. */
static void sp__flat_turn(const sp__flat *o, const sp_real x[3], sp_real out[3])
{
    const sp_real a = sp__dot3(x, o->e[0]), b = sp__dot3(x, o->e[1]);
    out[2] = sp__dot3(x, o->e[2]);
    out[0] = a; out[1] = b;
}

/* And back, in place. */
static void sp__flat_unturn(const sp__flat *o, sp_real x[3])
{
    const sp_real a = x[0], b = x[1], c = x[2];
    for (int k = 0; k < 3; k++) x[k] = a * o->e[0][k] + b * o->e[1][k] + c * o->e[2][k];
}
#endif

/* The shortest force in the cones that balances p is f = S P_K(Aeq' y), where y minimises
 *
 *   D(y) = 1/2 sum S_v |P_K(u_v)|^2 + p . y,   u = Aeq' y         gradient Aeq f + p,  Hessian Aeq S DP_K(u) Aeq'
 *
 * convex, once differentiable, 6 unknowns a free block. f is admissible for every y; the imbalance is the only error. An
 * assembly that cannot stand has no minimiser: y runs off along the mechanism dq = -y.
 * Rows are weighted to unit size, forces counted in the largest load, so nothing depends on units. The penalty form adds
 * sum max(0, -u_n)^2 / (2 gamma) (tension at a price) and weighs friction by tau; with gamma finite it always has a minimiser.
 */

#ifndef SP_NO_IPM
typedef enum sp__pass { SP__AIM, SP__REACH, SP__MOVE } sp__pass;

/* The interior-point method (section 19) has f = E x at a vertex, x in a cone that is its own dual. */
typedef struct sp__ipm {
    sp_real *x;                         /* 3 a vertex, or one an edge of its pyramid */
    sp_real natural;                    /* force of x = e where S = 1 */
    sp_real theta, gap;                 /* what is left of the start's residuals; sum of x z */
    int outside;                        /* x or z is no longer inside, by rounding */
    sp__pass pass;                      /* right-hand side; step length; step */
    int corrected;                      /* the product of the predictor's changes is taken into account */
    const sp_real *along[3];            /* y; its predictor and its step */
    sp_real tau, kappa, mu, sigma;
    sp_real stake;                      /* weight of the pair: tau kappa = stake mu */
    sp_real reach;                      /* step length */
    sp_real dtau, dkappa;
    int ray;                            /* forces are asked for the live loads alone */
} sp__ipm;
#endif

typedef struct sp__dual {
    const sp_problem *pb;
    const sp_settings *set;
    sp__cone cone;
    sp__yield *yield;                   /* of the contact last asked for */
    sp__bchol L;                        /* factor of the Hessian + shift */
    sp_real *dense;                     /* or, not NULL, its dense factor */
#ifdef SP_REAL_MIXED
    sp_real *diagonal, *coupling;       /* the matrix: 21 a block as in L.d, 36 a contact */
    sp_real *scale;                     /* 6b: 1 / sqrt(its diagonal) */
    sp_real *cg;                        /* 24b: direction, its image, residual over the factor, residual */
#endif
    sp_real soft, slide;                /* 1/gamma (0: no tension), 1/sqrt(tau); the exact form has 0 and 1 */
    sp_real unit, load;                 /* force of one unit [N]; norm of the weighted load */
    sp_real factor;                     /* coefficient in force / mu */
    struct sp__flat *flat;              /* of a search in 3 rows a block, else NULL */
    struct sp__ipm *inner;              /* of the interior-point method */
    sp_real *x;                         /* 3 x points: its x for the true cone */
    int singular;                       /* the bilateral matrix has null vectors that the load has a part along */
    sp_real metric;                     /* 1 / largest sbar of a contact, or 0: S = 1 everywhere */
    int32_t *slot;                      /* per contact: its off-diagonal block in L; -1 - slot: transposed; INT32_MIN: none */
    sp_real *weight;                    /* 2b: of force and moment rows */
    sp_real *size;                      /* 2b: sbar and Sbar of the certificate check, in units */
    sp_real *y, *r, *d;                 /* 6b: potential, gradient, step */
    sp_real *bears;                     /* 3b: sum |f_v|, sum |x_v x f_v|, longest arm of the last forces; NULL: not asked for */
    sp_real *h;                         /* temporaries of the assembly */
    const sp_real *given;               /* 6 x points: D of every vertex, for SP__GIVEN */
    int32_t *xadj, *adj, *parent, *mark;/* graph of touching free blocks */
    sp_cost *cost;
    int64_t limit;                      /* flops that cost may reach */
    int spent;                          /* a piece of work did not fit; from then on none is done */
} sp__dual;

#define SP__DUAL_H 102
#ifdef SP_REAL_MIXED
#define SP__REFINE 40                   /* steps a solution of the factor is refined by, at most */
#endif

static void sp__dual_carve_graph(sp__dual *w, const sp_problem *pb, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    w->pb = pb;
    sp__bchol_carve_pattern(&w->L, pb->blocks, a);
    w->xadj = sp__take(a, b + 1, sizeof *w->xadj);
    w->adj = sp__take(a, (size_t)pb->contacts, 2 * sizeof *w->adj);
    w->parent = sp__take(a, b, sizeof *w->parent);
    w->mark = sp__take(a, b, sizeof *w->mark);
}

static void sp__dual_carve(sp__dual *w, const sp_problem *pb, int32_t faces, int32_t nnz, int dense, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks, c = (size_t)pb->contacts;
    w->dense = dense ? sp__take(a, 3 * b, (6 * b + 1) * sizeof *w->dense) : NULL;
    sp__cone_carve(&w->cone, faces, a);
    w->yield = sp__take(a, 1, sizeof *w->yield);
    w->slot = sp__take(a, c, sizeof *w->slot);
    w->weight = sp__take(a, b, 2 * sizeof *w->weight);
    w->size = sp__take(a, b, 2 * sizeof *w->size);
    w->y = sp__take(a, b, 6 * sizeof *w->y);
    w->r = sp__take(a, b, 6 * sizeof *w->r);
    w->d = sp__take(a, b, 6 * sizeof *w->d);
    w->h = sp__take(a, SP__DUAL_H, sizeof *w->h);
#ifndef SP_NO_PLAN
    if (w->flat) {
        w->L.rows = 3;
        w->flat->mate = sp__take(a, (size_t)pb->points, sizeof *w->flat->mate);
        w->flat->g = sp__take(a, c, SP__FLAT_G * sizeof *w->flat->g);
    }
#endif
    sp__bchol_carve_values(&w->L, nnz, a);
#ifdef SP_REAL_MIXED
    w->diagonal = sp__take(a, b, 21 * sizeof *w->diagonal);
    w->coupling = sp__take(a, c, 36 * sizeof *w->coupling);
    w->scale = sp__take(a, b, 6 * sizeof *w->scale);
    w->cg = sp__take(a, b, 24 * sizeof *w->cg);
#endif
#ifndef SP_NO_IPM
    w->inner = sp__take(a, 1, sizeof *w->inner);
    w->x = sp__take(a, faces ? 0 : (size_t)pb->points, 3 * sizeof *w->x);
#endif
}

/* Neighbours of every free block, each once. */
SP__APART static void sp__dual_graph(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    const int32_t b = pb->blocks;
    for (int32_t i = 0; i <= b; i++) w->xadj[i] = 0;
    for (int32_t c = 0; c < pb->contacts; c++)
        if (pb->contact[c].a >= 0 && pb->contact[c].b >= 0) {
            w->xadj[pb->contact[c].a + 1]++;
            w->xadj[pb->contact[c].b + 1]++;
        }
    for (int32_t i = 0; i < b; i++) { w->xadj[i + 1] += w->xadj[i]; w->mark[i] = w->xadj[i]; }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int32_t i = pb->contact[c].a, k = pb->contact[c].b;
        if (i < 0 || k < 0) continue;
        w->adj[w->mark[i]++] = k;
        w->adj[w->mark[k]++] = i;
    }
    for (int32_t i = 0; i < b; i++) w->mark[i] = -1;
    int32_t to = 0, from = 0;                           /* repeated neighbours go: two joints between one pair */
    for (int32_t i = 0; i < b; i++) {
        const int32_t end = w->xadj[i + 1], start = to;
        for (; from < end; from++)
            if (w->mark[w->adj[from]] != i) { w->mark[w->adj[from]] = i; w->adj[to++] = w->adj[from]; }
        w->xadj[i] = start;
    }
    w->xadj[b] = to;
}

SP__APART static void sp__dual_carve_order(const sp_problem *pb, sp_arena *a)
{
    sp__order order;
    sp__order_carve(&order, pb->blocks, 2 * pb->contacts, a);
}

/* Symbolic step in `a`, whose peak then covers it.     returns blocks of L below the diagonal, -1: does not fit */
SP__APART static int32_t sp__dual_analyse(sp__dual *w, const sp_problem *pb, sp_arena *a)
{
    sp__dual_carve_graph(w, pb, a);
    sp_arena rest = *a;
    sp__dual_carve_order(pb, &rest);
    if (sp__failed(a) || sp__failed(&rest)) return -1;
    if (rest.peak > a->peak) a->peak = rest.peak;
    sp__dual_graph(w);
    rest.used = a->used;
    for (int32_t k = 0; k < pb->blocks && pb->ordered; k++) w->L.perm[k] = k;
    return pb->ordered ? sp__bchol_count(&w->L, w->xadj, w->adj, w->parent, w->mark)
                       : sp__bchol_analyse(&w->L, w->xadj, w->adj, w->parent, w->mark, rest);
}

/* Bytes the symbolic step takes. */
SP__APART static size_t sp__dual_scratch(const sp_problem *pb)
{
    sp__dual w;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof(sp__flat));
    sp__take(&dry, 1, sizeof w);
    sp__dual_carve_graph(&w, pb, &dry);
    sp__dual_carve_order(pb, &dry);
    return dry.peak;
}

/* Where a dual ends that begins at `from`, with so many blocks below the diagonal and rays a vertex: the symbolic step and the
 * factor share the space behind the graph. t is used up; t->flat: in 3 rows. */
static size_t sp__dual_end(sp__dual *t, const sp_problem *pb, const sp_settings *set, int dense, size_t rays, int32_t nnz, size_t from)
{
    sp_arena dry = sp__arena_dry();
    dry.used = from;
    sp__take(&dry, 1, sizeof *t);
    sp__dual_carve_graph(t, pb, &dry);
    sp_arena symbolic = dry;
    sp__dual_carve_order(pb, &symbolic);
    sp__dual_carve(t, pb, set->faces, nnz, dense, &dry);
    if (rays) sp__take(&dry, (size_t)pb->points, rays * sizeof *t->y);
    return dry.peak > symbolic.peak ? dry.peak : symbolic.peak;
}

/* Bytes of the whole dual; flat (may be NULL): and of one in 3 rows before it, behind *flat, which takes more where few blocks
 * have many joints. */
static size_t sp__dual_most(const sp_problem *pb, const sp_settings *set, int dense, size_t rays, sp__flat *flat, sp_arena scratch)
{
    sp__dual *w = sp__take(&scratch, 1, sizeof *w);
    const int32_t nnz = w ? sp__dual_analyse(w, pb, &scratch) : -1;
    if (nnz < 0) return SIZE_MAX;
    w->flat = NULL;
    const size_t whole = sp__dual_end(w, pb, set, dense, rays, nnz, 0);
    w->flat = flat;
    const size_t less = flat ? sp__dual_end(w, pb, set, dense, rays, nnz, sizeof *flat) : 0;
    return less > whole ? less : whole;
}

static size_t sp__dual_need(const sp_problem *pb, const sp_settings *set, int dense, size_t rays, sp_arena scratch)
{
    return sp__dual_most(pb, set, dense, rays, NULL, scratch);
}

/* The same of a search that may be in 3 rows first. */
static size_t sp__flat_need(const sp_problem *pb, const sp_settings *set, size_t rays, sp_arena scratch)
{
#ifndef SP_NO_PLAN
    sp__flat *o = sp__take(&scratch, 1, sizeof *o);
    if (!o) return SIZE_MAX;
    if (sp__flat_choose(pb, set, o)) return sp__dual_most(pb, set, 0, rays, o, scratch);
#endif
    return sp__dual_need(pb, set, 0, rays, scratch);
}

/* How often vertex v counts: 0 where its mirror image does for both, or where it takes no part. */
static sp_real sp__dual_counts(const sp__dual *w, int32_t v)
{
#ifndef SP_NO_PLAN
    if (w->flat) return w->flat->mate[v] > v ? 2 : w->flat->mate[v] == v;
#endif
    (void)w; (void)v;
    return 1;
}

/* S of a contact's vertices, ~ min(sbar_A, sbar_B): without it a pebble beside a cathedral is lost in rounding. */
static sp_real sp__dual_S(const sp__dual *w, int32_t c)
{
    const sp_real s = w->metric > 0 ? sp__lesser(&w->pb->contact[c], w->size, 2) * w->metric : 1;
    return s > 0 ? s : 1;
}

#ifndef SP_NO_PLAN
static const sp_real *sp__flat_frame(const sp__dual *w, const sp_contact *t)
{
    return w->flat->g + SP__FLAT_G * (size_t)(t - w->pb->contact);
}

/* T of a block of a contact, +- that of its weighted rows: (along n, slip, turn), level (along n, two turns), at the origin of the
 * contact, of B seen from A.
 *   planar         [ nx ny arm0 ;  -ny nx arm1 ;  0 0 1 ]
 *   level          [ +-1 +-arm0 +-arm1 ;  0 1 0 ;  0 0 1 ]
 * By columns without the two zeros. */
static void sp__flat_weigh(const sp__dual *w, const sp_contact *t, int side)
{
    const sp__flat *o = w->flat;
    const int32_t i = side ? t->b : t->a;
    sp_real *g = o->g + SP__FLAT_G * (size_t)(t - w->pb->contact), *T = g + 6 + 7 * side;
    if (i < 0) return;
    const sp_real sign = side ? (sp_real)1 : (sp_real)-1, up = sp__dot3(t->joint->n, o->e[2]) < 0 ? -sign : sign;
    const sp_real x = sp__dot3(side ? t->rb : t->ra, o->e[0]), y = sp__dot3(side ? t->rb : t->ra, o->e[1]);
    const sp_real z = w->weight[2 * (size_t)i], turn = w->weight[2 * (size_t)i + 1];
    const int plane = o->mode == SP__PLANE;
    T[0] = plane ? sign * z * g[0] : up * z;
    T[1] = plane ? -sign * z * g[1] : 0;
    T[2] = plane ? sign * z * g[1] : up * turn * y;
    T[3] = plane ? sign * z * g[0] : sign * turn;
    T[4] = plane ? sign * turn * (g[1] * x - g[0] * y) : -up * turn * x;
    T[5] = plane ? sign * turn * (g[0] * x + g[1] * y) : 0;
    T[6] = sign * turn;
}
#endif

/* Row weights: 1 / sqrt(sum S) for forces, 1 / sqrt(2/3 sum S |r_v - c|^2) for moments: unit diagonal on average. */
static void sp__dual_weights(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    for (size_t k = 0; k < 2 * (size_t)pb->blocks; k++) w->weight[k] = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            sp_real o[3], *z = w->weight + 2 * (size_t)i;
            const sp_real *arm = side ? t->rb : t->ra;
            const sp_real S = sp__dual_S(w, c);
            o[0] = sp__dot3(arm, t->joint->n); o[1] = sp__dot3(arm, t->joint->t1); o[2] = sp__dot3(arm, t->joint->t2);
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                const sp_real *l = pb->local[v];
                const sp_real x = o[0] + l[0], y = o[1] + l[1], s = o[2] + l[2];
                const sp_real times = S * sp__dual_counts(w, v);
                z[0] += times;
                z[1] += times * (x * x + y * y + s * s) * 2 / 3;
            }
        }
    }
    for (size_t k = 0; k < 2 * (size_t)pb->blocks; k++) w->weight[k] = w->weight[k] > 0 ? 1 / SP_SQRT(w->weight[k]) : 1;
#ifndef SP_NO_PLAN
    for (int32_t c = 0; c < 2 * pb->contacts && w->flat; c++) sp__flat_weigh(w, &pb->contact[c / 2], c % 2);
#endif
}

/* Rows of held directions to zero. */
static void sp__dual_release(const sp__dual *w, sp_real *r)
{
    for (int32_t i = 0; i < w->pb->blocks; i++)
        if (w->pb->scene->block[w->pb->block[i]].fixed) sp__release(w->pb, i, r + 6 * (size_t)i);
}

/* Force (k even) or moment of the load of block k / 2 in units, in the axes of the rows. */
static void sp__dual_p(const sp__dual *w, size_t k, sp_real p[3])
{
    for (size_t q = 0; q < 3; q++) p[q] = w->pb->p[3 * k + q] / w->unit;
#ifndef SP_NO_PLAN
    if (!w->flat) return;
    const int plane = w->flat->mode == SP__PLANE, along = plane == (int)(k % 2);         /* rows 2 and 5, or the others */
    sp__flat_turn(w->flat, p, p);
    if (along) p[0] = p[1] = 0;
    else p[2] = 0;
#endif
}

/* r <- the weighted load in units. */
static void sp__dual_load(const sp__dual *w, sp_real *r)
{
    for (size_t k = 0; k < 2 * (size_t)w->pb->blocks; k++) {
        sp__dual_p(w, k, r + 3 * k);
        for (size_t q = 3 * k; q < 3 * k + 3; q++) r[q] *= w->weight[k];
    }
    sp__dual_release(w, r);
}

/* load . y */
static sp_real sp__dual_work(const sp__dual *w, const sp_real *y)
{
    sp_real s = 0;
    for (size_t k = 0; k < 2 * (size_t)w->pb->blocks; k++) {
        sp_real p[3];
        sp__dual_p(w, k, p);
        for (size_t q = 0; q < 3; q++) s += w->weight[k] * p[q] * y[3 * k + q];
    }
    return s;
}

/* Is K_v of any contact no cone? */
static int sp__problem_strong(const sp_problem *pb)
{
    for (int32_t c = 0; c < pb->contacts; c++) if (sp__contact_strong(pb, &pb->contact[c])) return 1;
    return 0;
}

/* Coefficient of contact c in force. */
static sp_real sp__dual_mu(const sp__dual *w, int32_t c) { return w->pb->contact[c].joint->joint.mu * w->factor; }

/* K of a vertex of contact c in units, and as f = S P_(K/S)(u) wants it: strength over S, friction in its own units. It lies in
 * w->yield until the next call. */
static const sp__yield *sp__dual_yield(const sp__dual *w, int32_t c)
{
    const sp_contact *t = &w->pb->contact[c];
    sp__yield *k = w->yield;
    k->mu = sp__dual_mu(w, c);
    k->plain = !sp__contact_strong(w->pb, t);
    k->C = k->T = 0;
    k->N = SP__HUGE;
    if (k->plain) return k;
    const sp__strength strength = sp__vertex_strength(t->joint, w->pb->endless);
    const sp_real scale = 1 / (w->unit * sp__dual_S(w, c));
    k->C = strength.C * scale * w->factor;
    k->T = strength.T * scale;
    k->N = sp__ratio(strength.N, 1 / scale);
    return k;
}

#ifndef SP_NO_PLAN
/* X = T y: motion of B seen from A at the origin of a contact. */
static void sp__flat_there(const sp__dual *w, const sp_contact *t, const sp_real *g, const sp_real *y, sp_real X[3])
{
    X[0] = X[1] = X[2] = 0;
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *T = g + 6 + 7 * side, *yi = y + 6 * (size_t)i;
        const sp_real a = yi[sp__flat_row(w->flat, 0)], b = yi[sp__flat_row(w->flat, 1)], c = yi[sp__flat_row(w->flat, 2)];
        X[0] += T[0] * a + T[2] * b + T[4] * c;
        X[1] += T[1] * a + T[3] * b + T[5] * c;
        X[2] += T[6] * c;
    }
}

/* r += T' Y: the forces Y that X meets. */
static void sp__flat_back(const sp__dual *w, const sp_contact *t, const sp_real *g, const sp_real Y[3], sp_real *r)
{
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *T = g + 6 + 7 * side;
        sp_real *ri = r + 6 * (size_t)i;
        ri[sp__flat_row(w->flat, 0)] += T[0] * Y[0] + T[1] * Y[1];
        ri[sp__flat_row(w->flat, 1)] += T[2] * Y[0] + T[3] * Y[1];
        ri[sp__flat_row(w->flat, 2)] += T[4] * Y[0] + T[5] * Y[1] + T[6] * Y[2];
    }
}

/* V, W of sp__dual_twist from 3 rows a block. */
SP__APART static void sp__flat_twist(const sp__dual *w, const sp_contact *t, const sp_real *y, sp_real V[3], sp_real W[3])
{
    const sp_real *g = sp__flat_frame(w, t);
    const int plane = w->flat->mode == SP__PLANE;
    sp_real X[3];
    sp__flat_there(w, t, g, y, X);
    V[0] = X[0]; V[1] = plane ? X[1] * g[2] : 0; V[2] = plane ? X[1] * g[3] : 0;
    W[0] = 0; W[1] = plane ? -X[2] * g[3] : X[1] * g[0] + X[2] * g[2]; W[2] = plane ? X[2] * g[2] : X[1] * g[1] + X[2] * g[3];
}

/* sp__dual_scatter into 3 rows a block. */
SP__APART static void sp__flat_scatter(const sp__dual *w, const sp_contact *t, const sp_real F[3], const sp_real M[3], sp_real *r)
{
    const sp_real *g = sp__flat_frame(w, t);
    const int plane = w->flat->mode == SP__PLANE;
    const sp_real Y[3] = { F[0], plane ? F[1] * g[2] + F[2] * g[3] : g[0] * M[1] + g[1] * M[2],
                           plane ? g[2] * M[2] - g[3] * M[1] : g[2] * M[1] + g[3] * M[2] };
    sp__flat_back(w, t, g, Y, r);
}
#endif

/* sp__dual_twist from 6 rows a block. */
SP__APART static void sp__space_twist(const sp__dual *w, const sp_contact *t, const sp_real *y, sp_real V[3], sp_real W[3])
{
    sp_real v[3] = { 0, 0, 0 }, o[3] = { 0, 0, 0 };
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *yi = y + 6 * (size_t)i, *arm = side ? t->rb : t->ra;
        const sp_real sign = side ? (sp_real)1 : (sp_real)-1;
        const sp_real z = sign * w->weight[2 * (size_t)i], s = sign * w->weight[2 * (size_t)i + 1];
        const sp_real a = s * yi[3], b = s * yi[4], c = s * yi[5];
        v[0] += z * yi[0] + b * arm[2] - c * arm[1];
        v[1] += z * yi[1] + c * arm[0] - a * arm[2];
        v[2] += z * yi[2] + a * arm[1] - b * arm[0];
        o[0] += a; o[1] += b; o[2] += c;
    }
    V[0] = sp__dot3(v, t->joint->n); V[1] = sp__dot3(v, t->joint->t1); V[2] = sp__dot3(v, t->joint->t2);
    W[0] = sp__dot3(o, t->joint->n); W[1] = sp__dot3(o, t->joint->t1); W[2] = sp__dot3(o, t->joint->t2);
}

/* V, W: velocity of B seen from A at the contact's origin and its rotation, in the contact's frame, for weighted motion y. */
SP__APART static void sp__dual_twist(const sp__dual *w, const sp_contact *t, const sp_real *y, sp_real V[3], sp_real W[3])
{
#ifndef SP_NO_PLAN
    if (w->flat) { sp__flat_twist(w, t, y, V, W); return; }
#endif
    sp__space_twist(w, t, y, V, W);
}

/* u = V + W x l, friction weighed. */
static void sp__dual_rate(const sp__dual *w, const sp_real V[3], const sp_real W[3], const sp_real l[3], sp_real u[3])
{
    u[0] = V[0] + W[1] * l[2] - W[2] * l[1];
    u[1] = (V[1] + W[2] * l[0] - W[0] * l[2]) * w->slide;
    u[2] = (V[2] + W[0] * l[1] - W[1] * l[0]) * w->slide;
}

/* f = S (P_K(u) - (max(0, -u_n) / gamma, 0, 0)), friction unweighed. */
static void sp__dual_force(const sp__dual *w, int32_t c, const sp__yield *yield, const sp_real u[3], sp_real f[3])
{
    sp__cone_project(&w->cone, yield, u, f);
    if (w->soft > 0 && u[0] < 0) f[0] += u[0] * w->soft;
    const sp_real S = sp__dual_S(w, c), slip = S * w->slide;
    f[0] *= S; f[1] *= slip; f[2] *= slip;
}

/* sp__dual_scatter into 6 rows a block. */
SP__APART static void sp__space_scatter(const sp__dual *w, const sp_contact *t, const sp_real F[3], const sp_real M[3], sp_real *r)
{
    sp_real f[3], m[3];
    for (int k = 0; k < 3; k++) {
        f[k] = F[0] * t->joint->n[k] + F[1] * t->joint->t1[k] + F[2] * t->joint->t2[k];
        m[k] = M[0] * t->joint->n[k] + M[1] * t->joint->t1[k] + M[2] * t->joint->t2[k];
    }
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *arm = side ? t->rb : t->ra;
        const sp_real sign = side ? (sp_real)1 : (sp_real)-1;
        const sp_real z = sign * w->weight[2 * (size_t)i], s = sign * w->weight[2 * (size_t)i + 1];
        sp_real *ri = r + 6 * (size_t)i;
        ri[0] += z * f[0];
        ri[1] += z * f[1];
        ri[2] += z * f[2];
        ri[3] += s * (arm[1] * f[2] - arm[2] * f[1] + m[0]);
        ri[4] += s * (arm[2] * f[0] - arm[0] * f[2] + m[1]);
        ri[5] += s * (arm[0] * f[1] - arm[1] * f[0] + m[2]);
    }
}

/* r[i] += z (F, arm x F + M), F and M in the contact's frame about its origin, on both sides. */
static void sp__dual_scatter(const sp__dual *w, const sp_contact *t, const sp_real F[3], const sp_real M[3], sp_real *r)
{
#ifndef SP_NO_PLAN
    if (w->flat) { sp__flat_scatter(w, t, F, M, r); return; }
#endif
    sp__space_scatter(w, t, F, M, r);
}

#define SP__FLOPS_SWEEP 48              /* a vertex: u 15, P_K about 15, sums 18; a contact adds SP__FLOPS_TWIST */
#define SP__FLOPS_TWIST 160
#define SP__FLOPS_HESSIAN 75            /* a vertex of the assembly; a contact adds SP__FLOPS_BLOCKS */
#define SP__FLOPS_BLOCKS 900

/* Count work before it is done. What would exceed the budget latches, as a full arena does: this and all later work is left out,
 * so a check on a budget is a check without one that stops early.                       returns whether the work is to be done */
static int sp__dual_pay(sp__dual *w, int64_t flops)
{
    if (flops > w->limit - w->cost->flops) w->spent = 1;
    if (!w->spent) w->cost->flops += flops;
    return !w->spent;
}

/* The same for so many flops a vertex and a contact, these parts of SP__FLOPS_TWIST. */
static int sp__dual_count(sp__dual *w, int32_t vertex, int32_t contact)
{
#ifndef SP_NO_PLAN
    const sp__flat *o = w->flat;
    if (o) return sp__dual_pay(w, vertex * o->vertices + contact * SP__FLOPS_FLAT_TWIST / SP__FLOPS_TWIST * o->sides);
#endif
    return sp__dual_pay(w, (int64_t)vertex * w->pb->points + (int64_t)contact * w->pb->contacts);
}

/* So many sweeps over all vertices, each with so many twists; where a vertex has fn and one slip, of those. */
static int sp__dual_sweep(sp__dual *w, int32_t sweeps, int32_t twists)
{
#ifndef SP_NO_PLAN
    if (w->flat && w->flat->plain) return sp__dual_count(w, sweeps * SP__FLOPS_FLAT_SWEEP(w->flat), twists * SP__FLOPS_TWIST);
#endif
    return sp__dual_count(w, sweeps * SP__FLOPS_SWEEP, twists * SP__FLOPS_TWIST);
}

/* An assembly. */
static int sp__dual_assembly(sp__dual *w, int plain)
{
#ifndef SP_NO_PLAN
    const sp__flat *o = w->flat;
    if (o && plain) return sp__dual_pay(w, SP__FLOPS_FLAT_HESSIAN(o) * o->vertices + SP__FLOPS_FLAT_BLOCKS * o->sides);
#endif
    (void)plain;
    return sp__dual_count(w, SP__FLOPS_HESSIAN, SP__FLOPS_BLOCKS);
}

/* f = S u; f = S P_K(u); df = D du with D given, with D of section 19 */
typedef enum sp__law { SP__BILATERAL, SP__ADMISSIBLE, SP__GIVEN, SP__INTERIOR } sp__law;

/* Force g at l, in the contact's frame, into what the blocks bear. */
SP__APART static void sp__dual_bear(sp__dual *w, const sp_contact *t, const sp_real *l, const sp_real g[3])
{
    const sp_interface *f = t->joint;
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        const sp_real *arm = side ? t->rb : t->ra;
        const sp_real x[3] = { sp__dot3(arm, f->n) + l[0], sp__dot3(arm, f->t1) + l[1], sp__dot3(arm, f->t2) + l[2] };
        sp_real m[3], *sum = w->bears + 3 * (size_t)i;
        sp__cross3(x, g, m);
        sum[0] += sp__norm3(g);
        sum[1] += sp__norm3(m);
        sum[2] = sp__max(sum[2], sp__norm3(x));
    }
}

#ifndef SP_NO_PLAN
/* Where no joint has strength a vertex of a search in 3 rows has fn, and planar one slip, with rates
 *   planar         un = X0 + q0 X2,  us = X1 + q1 X2;  level un = X0 + q0 X1 + q1 X2
 * and K is a wedge, its sides those of the cone in the plane.          *times: how often it counts */
static sp_real sp__flat_rate(const sp__dual *w, const sp_real *g, int32_t v, const sp_real X[3], sp_real q[2], sp_real u[2])
{
    const sp_real *l = w->pb->local[v];
    if (w->flat->mode == SP__PLANE) {
        q[0] = -(l[1] * g[2] + l[2] * g[3]);
        q[1] = l[0];
        u[0] = X[0] + q[0] * X[2];
        u[1] = w->slide * (X[1] + q[1] * X[2]);
    } else {
        q[0] = g[0] * l[2] - g[1] * l[1];
        q[1] = g[2] * l[2] - g[3] * l[1];
        u[0] = X[0] + q[0] * X[1] + q[1] * X[2];
        u[1] = 0;
    }
    return sp__dual_counts(w, v);
}

/* f = P_K(u) with tension at its price, D its derivative (nn, ns, ss); mu: of the yield. f or D may be NULL. */
static void sp__flat_wedge(const sp__dual *w, sp_real mu, const sp_real *g, const sp_real u[2], sp_real *f, sp_real *D)
{
    const sp_real side = u[1] < 0 ? (sp_real)-1 : (sp_real)1, s = side * u[1], k = mu / g[u[1] < 0 ? 5 : 4];
    const sp_real n = u[0] + k * s, x = n / (1 + k * k);
    const int inside = u[0] >= 0 && s <= k * u[0], carries = inside || n > 0;
    const sp_real soft = u[0] < 0 ? w->soft : 0, c = 1 / (1 + k * k);
    if (f) { f[0] = (inside ? u[0] : carries ? x : 0) + soft * u[0]; f[1] = inside ? u[1] : carries ? side * k * x : 0; }
    if (!D) return;
    D[0] = (inside ? 1 : carries ? c : 0) + soft;
    D[1] = inside || !carries ? 0 : side * k * c;
    D[2] = inside ? 1 : carries ? k * k * c : 0;
}

/* f = P_K(u), or u where joints are bilateral, in the metric; D likewise. */
static void sp__flat_law(const sp__dual *w, sp__law law, int32_t c, const sp_real *g, const sp_real u[2], sp_real *f, sp_real *D)
{
    const sp_real S = sp__dual_S(w, c), T = S * w->slide;
    if (f) { f[0] = u[0]; f[1] = u[1]; }
    if (D) { D[0] = D[2] = 1; D[1] = 0; }
    if (law == SP__ADMISSIBLE && w->flat->mode == SP__PLANE) sp__flat_wedge(w, sp__dual_mu(w, c), g, u, f, D);
    else if (law == SP__ADMISSIBLE && u[0] < 0) {
        if (f) f[0] *= w->soft;
        if (D) D[0] = w->soft;
    }
    if (f) { f[0] *= S; f[1] *= T; }
    if (D) { D[0] *= S; D[1] *= T; D[2] *= T * w->slide; }
}

/* Size of a force (fn, a slip) and of its moment about an arm x + l in the contact's frame. */
static sp_real sp__flat_moment(const sp__dual *w, const sp_contact *t, int side, int32_t v, const sp_real h[2], sp_real size[2])
{
    const sp_real *g = sp__flat_frame(w, t), *arm = side ? t->rb : t->ra, *l = w->pb->local[v];
    const sp_real x[3] = { sp__dot3(arm, t->joint->n) + l[0], sp__dot3(arm, t->joint->t1) + l[1], sp__dot3(arm, t->joint->t2) + l[2] };
    const int plane = w->flat->mode == SP__PLANE;
    const sp_real f[3] = { h[0], plane ? h[1] * g[2] : 0, plane ? h[1] * g[3] : 0 };
    sp_real m[3];
    sp__cross3(x, f, m);
    size[0] = SP_SQRT(h[0] * h[0] + h[1] * h[1]);
    size[1] = sp__norm3(m);
    return sp__norm3(x);
}

/* sp__dual_bear of that force. */
static void sp__flat_bear(sp__dual *w, const sp_contact *t, int32_t v, sp_real times, const sp_real h[2])
{
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        sp_real size[2], *sum = w->bears + 3 * (size_t)i;
        if (i < 0) continue;
        const sp_real far = sp__flat_moment(w, t, side, v, h, size);
        sum[0] += times * size[0];
        sum[1] += times * size[1];
        sum[2] = sp__max(sum[2], far);
    }
}

/* A contact's share of sp__dual_gradient. */
SP__APART static void sp__flat_gradient(sp__dual *w, sp__law law, int32_t c, const sp_real *y, sp_real *r, sp_real *f)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__flat_frame(w, t);
    const int plane = w->flat->mode == SP__PLANE;
    sp_real *X = w->h, *Y = X + 3, *q = X + 6, *u = X + 8, *h = X + 10;
    Y[0] = Y[1] = Y[2] = 0;
    sp__flat_there(w, t, g, y, X);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        if (!(times > 0)) continue;
        sp__flat_law(w, law, c, g, u, h, NULL);
        if (w->bears) sp__flat_bear(w, t, v, times, h);
        if (f) {
            f[3 * (size_t)v] = h[0];
            f[3 * (size_t)v + 1] = plane ? h[1] * g[2] : 0;
            f[3 * (size_t)v + 2] = plane ? h[1] * g[3] : 0;
        }
        const sp_real n = times * h[0], s = times * h[1];
        Y[0] += n;
        Y[1] += plane ? s : q[0] * n;
        Y[2] += plane ? q[0] * n + q[1] * s : q[1] * n;
    }
    sp__flat_back(w, t, g, Y, r);
}

/* What its vertices can resist motion y with: sum |P_K(u)| times the cap, in the metric. */
SP__APART static sp_real sp__flat_resist(const sp__dual *w, int32_t c, const sp_real *y, sp_real most)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__flat_frame(w, t);
    sp_real *X = w->h, *q = X + 3, *u = X + 5, *h = X + 7, sum = 0;
    sp__flat_there(w, t, g, y, X);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        if (!(times > 0)) continue;
        sp__flat_law(w, SP__ADMISSIBLE, c, g, u, h, NULL);
        sum += times * SP_SQRT(h[0] * h[0] + h[1] * h[1]);
    }
    return most * sum;
}

/* And of sp__dual_slope. */
SP__APART static sp_real sp__flat_slope(sp__dual *w, int32_t c, const sp_real *y, const sp_real *d, sp_real s)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__flat_frame(w, t);
    sp_real *X = w->h, *dX = X + 3, *q = X + 6, *u = X + 8, *du = X + 10, *h = X + 12, sum = 0;
    sp__flat_there(w, t, g, y, X);
    sp__flat_there(w, t, g, d, dX);
    for (int k = 0; k < 3; k++) X[k] += s * dX[k];
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        if (!(times > 0)) continue;
        sp__flat_law(w, SP__ADMISSIBLE, c, g, u, h, NULL);
        sp__flat_rate(w, g, v, dX, q, du);
        sum += times * (h[0] * du[0] + h[1] * du[1] / w->slide);
    }
    return sum;
}

/* H of a contact, 3 x 3 in X. */
SP__APART static void sp__flat_hessian(sp__dual *w, sp__law law, int32_t c, const sp_real *y, sp_real H[9])
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *g = sp__flat_frame(w, t);
    const int plane = w->flat->mode == SP__PLANE;
    sp_real *X = w->h, *h = X + 3, *q = X + 9, *u = X + 11, *D = X + 13;
    for (int k = 0; k < 6; k++) h[k] = 0;
    sp__flat_there(w, t, g, y, X);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        if (!(times > 0)) continue;
        sp__flat_law(w, law, c, g, u, NULL, D);
        const sp_real nn = times * D[0], ns = times * D[1], ss = times * D[2];
        const sp_real a = nn * q[0], b = plane ? ns * q[1] : nn * q[1];
        h[0] += nn;
        h[1] += plane ? ns : a;
        h[2] += plane ? a + b : b;
        h[3] += plane ? ss : a * q[0];
        h[4] += plane ? ns * q[0] + ss * q[1] : a * q[1];
        h[5] += plane ? (a + 2 * b) * q[0] + ss * q[1] * q[1] : b * q[1];
    }
    H[0] = h[0]; H[1] = H[3] = h[1]; H[2] = H[6] = h[2];
    H[4] = h[3]; H[5] = H[7] = h[4]; H[8] = h[5];
}
#endif

/* And in 6 rows. */
SP__APART static void sp__space_gradient(sp__dual *w, sp__law law, int32_t c, const sp_real *y, sp_real *r, sp_real *f)
{
    const sp_contact *t = &w->pb->contact[c];
    sp_real *V = w->h, *W = V + 3, *u = V + 6, *g = V + 9, *F = V + 12, *M = V + 15;
    for (int k = 0; k < 6; k++) F[k] = 0;
    sp__dual_twist(w, t, y, V, W);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *l = w->pb->local[v], times = sp__dual_counts(w, v);
        if (!(times > 0)) continue;
        sp__dual_rate(w, V, W, l, u);
        if (law == SP__ADMISSIBLE) sp__dual_force(w, c, w->yield, u, g);
        else for (int k = 0; k < 3; k++) g[k] = sp__dual_S(w, c) * (k ? w->slide * u[k] : u[k]);
        if (f) memcpy(f + 3 * (size_t)v, g, 3 * sizeof *g);
        sp__scale3(times, g, g);
        F[0] += g[0]; F[1] += g[1]; F[2] += g[2];
        M[0] += l[1] * g[2] - l[2] * g[1];
        M[1] += l[2] * g[0] - l[0] * g[2];
        M[2] += l[0] * g[1] - l[1] * g[0];
        if (w->bears) sp__dual_bear(w, t, l, g);
    }
    sp__dual_scatter(w, t, F, M, r);
}

/* r = Aeq f(y) + p, weighted; f (may be NULL) gets the forces, 3 x points, in units. */
static void sp__dual_gradient(sp__dual *w, sp__law law, const sp_real *y, sp_real *r, sp_real *f)
{
    const sp_problem *pb = w->pb;
    if (!sp__dual_sweep(w, 1, 1) || (w->bears && !sp__dual_count(w, SP__FLOPS_SWEEP, 0))) return;
    sp__dual_load(w, r);
    if (w->bears) memset(w->bears, 0, 3 * (size_t)pb->blocks * sizeof *w->bears);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int plain = sp__dual_yield(w, c)->plain;
#ifndef SP_NO_PLAN
        if (w->flat && plain) { sp__flat_gradient(w, law, c, y, r, f); continue; }
#else
        (void)plain;
#endif
        sp__space_gradient(w, law, c, y, r, f);
    }
    sp__dual_release(w, r);
}

/* A contact's share of sp__dual_slope. */
SP__APART static sp_real sp__space_slope(sp__dual *w, int32_t c, const sp_real *y, const sp_real *d, sp_real s)
{
    const sp_contact *t = &w->pb->contact[c];
    sp_real *at = w->h, *move = at + 6, *u = at + 12, *du = at + 15, *f = at + 18, *part = at + 21;
    *part = 0;
    sp__dual_twist(w, t, y, at, at + 3);
    sp__dual_twist(w, t, d, move, move + 3);
    for (int k = 0; k < 6; k++) at[k] += s * move[k];
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        if (!(sp__dual_counts(w, v) > 0)) continue;
        sp__dual_rate(w, at, at + 3, w->pb->local[v], u);
        sp__dual_rate(w, move, move + 3, w->pb->local[v], du);
        sp__dual_force(w, c, w->yield, u, f);
        *part += sp__dual_counts(w, v) * (f[0] * du[0] + (f[1] * du[1] + f[2] * du[2]) / w->slide);
    }
    return *part;
}

/* d/ds D(y + s d) = f(u + s du) . du + p . d. */
SP__APART static sp_real sp__dual_slope(sp__dual *w, const sp_real *y, const sp_real *d, sp_real s)
{
    sp_real sum = 0;
    if (!sp__dual_sweep(w, 1, 2)) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const int plain = sp__dual_yield(w, c)->plain;
#ifndef SP_NO_PLAN
        if (w->flat && plain) { sum += sp__flat_slope(w, c, y, d, s); continue; }
#else
        (void)plain;
#endif
        sum += sp__space_slope(w, c, y, d, s);
    }
    return sum + sp__dual_work(w, d);
}

/* h += (I, -[l]x)' D (I, -[l]x), row by row: x = l x D_i is row i of -D [l]x, and [l]x of those rows makes ww. */
SP__APART static void sp__vertex_hessian(const sp_real D[6], const sp_real *l, sp_real *h)
{
    static const unsigned char at[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
    for (int i = 0; i < 3; i++) {
        const int up = (i + 2) % 3, down = (i + 1) % 3;
        const sp_real row[3] = { D[at[i][0]], D[at[i][1]], D[at[i][2]] };
        sp_real x[3];
        sp__cross3(l, row, x);
        for (int j = 0; j < 3; j++) {
            h[3 * i + j] += row[j];
            h[9 + 3 * i + j] += x[j];
            h[18 + 3 * down + j] += l[up] * x[j];
            h[18 + 3 * up + j] -= l[down] * x[j];
        }
    }
}

#ifndef SP_NO_IPM
/* E = S diag(1, mu, mu) for the true cone; for a pyramid x >= 0 and column k of E is its k-th edge: this, all times `natural`.
 * e[1] not written like e[2]: see sp__soc_square. */
static void sp__ipm_edge(const sp__dual *w, int32_t c, int32_t k, sp_real e[3])
{
    const sp_real mu = sp__dual_mu(w, c), h = mu * w->cone.tan_half, *d = w->cone.direction[k];
    e[0] = w->inner->natural * sp__dual_S(w, c) / (sp_real)w->cone.faces;
    e[1] = e[0] * mu * d[0] - e[0] * h * d[1];
    e[2] = e[0] * (mu * d[1] + h * d[0]);
}

/* A pyramid's share of sp__ipm_derivative. */
SP__APART static void sp__ipm_by_edges(sp__dual *w, int32_t c, int32_t v, const sp_real u[3], sp_real D[6], sp_real f[3])
{
    const sp_real *x = w->inner->x + (size_t)w->cone.faces * (size_t)v, times = sp__dual_counts(w, v);
    sp_real *e = w->h + 57;
    for (int32_t k = 0; k < w->cone.faces; k++) {
        sp__ipm_edge(w, c, k, e);
        const sp_real zk = w->inner->theta - sp__dot3(e, u), s = x[k] / zk;
        if (!(zk > 0 && x[k] > 0)) w->inner->outside = 1;
        w->inner->gap += times * x[k] * zk;
        D[0] += s * e[0] * e[0]; D[1] += s * e[0] * e[1]; D[2] += s * e[0] * e[2];
        D[3] += s * e[1] * e[1]; D[4] += s * e[1] * e[2]; D[5] += s * e[2] * e[2];
        for (int q = 0; f && q < 3; q++) f[q] += x[k] * e[q];
    }
}

/* The true cone's. */
SP__APART static void sp__ipm_by_cone(sp__dual *w, int32_t c, int32_t v, const sp_real u[3], sp_real D[6], sp_real f[3])
{
    const sp_real *x = w->inner->x + 3 * (size_t)v;
    const sp_real S = w->inner->natural * sp__dual_S(w, c), T = S * sp__dual_mu(w, c);
    sp_real *z = w->h + 60;
    z[0] = w->inner->theta - S * u[0]; z[1] = -T * u[1]; z[2] = -T * u[2];
    sp__nt W;
    if (!sp__soc_scaling(x, z, &W)) { w->inner->outside = 1; return; }
    const sp_real s = W.s * W.s, p = 2 * s * W.w[1], q = 2 * s * W.w[2];
    w->inner->gap += sp__dual_counts(w, v) * sp__dot3(x, z);
    D[0] = S * S * s * (1 + 2 * (W.w[1] * W.w[1] + W.w[2] * W.w[2]));
    D[1] = S * T * p * W.w[0]; D[2] = S * T * q * W.w[0];
    D[3] = T * T * (p * W.w[1] + s); D[4] = T * T * p * W.w[2]; D[5] = T * T * (q * W.w[2] + s);
    if (f) { f[0] = S * x[0]; f[1] = T * x[1]; f[2] = T * x[2]; }
}

/* D = E W^2 E' for rates u = Aeq' y, z = theta e - E'u; f (may be NULL) = E x. Adds x.z to the gap. */
static void sp__ipm_derivative(sp__dual *w, int32_t c, int32_t v, const sp_real u[3], sp_real D[6], sp_real f[3])
{
    for (int k = 0; k < 6; k++) D[k] = 0;
    for (int k = 0; f && k < 3; k++) f[k] = 0;
    if (w->cone.faces) sp__ipm_by_edges(w, c, v, u, D, f);
    else sp__ipm_by_cone(w, c, v, u, D, f);
}
#endif

/* D of a vertex, df = D du for rates u = V + W x l; u: room for them.     returns 0 when it is zero: the vertex is open */
static int sp__vertex_law(sp__dual *w, sp__law law, int32_t c, int32_t v, const sp_real *twist, sp_real *u, sp_real D[6])
{
    if (law == SP__GIVEN) { memcpy(D, w->given + 6 * (size_t)v, 6 * sizeof *D); return 1; }
    sp__dual_rate(w, twist, twist + 3, w->pb->local[v], u);
#ifndef SP_NO_IPM
    if (law == SP__INTERIOR) {
        sp__ipm_derivative(w, c, v, u, D, NULL);
        return 1;
    }
#endif
    D[0] = D[3] = D[5] = 1;
    D[1] = D[2] = D[4] = 0;
    if (law == SP__ADMISSIBLE) {
        const sp__region region = sp__cone_derivative(&w->cone, sp__dual_yield(w, c), u, D);
        if (w->soft > 0 && u[0] < 0) D[0] += w->soft;
        else if (region == SP__APEX) return 0;
    }
    const sp_real S = sp__dual_S(w, c), T = S * w->slide, R = T * w->slide;
    D[0] *= S; D[1] *= T; D[2] *= T; D[3] *= R; D[4] *= R; D[5] *= R;
    return 1;
}

/* The contact's share H = sum (I, -[l]x)' D (I, -[l]x) of the Hessian in its own frame: vv, vw, ww, 9 numbers each.
 *     returns 0 when all of it is zero: the contact is open */
SP__APART static int sp__dual_contact_hessian(sp__dual *w, sp__law law, int32_t c, const sp_real *y, sp_real *h)
{
    const sp_contact *t = &w->pb->contact[c];
    sp_real *twist = h + 87, *u = h + 93, *D = h + 96;
    int carries = 0;
    sp__dual_twist(w, t, y, twist, twist + 3);
    for (int q = 0; q < 27; q++) h[q] = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        if (!(sp__dual_counts(w, v) > 0) || !sp__vertex_law(w, law, c, v, twist, u, D)) continue;
        for (int k = 0; k < 6; k++) D[k] *= sp__dual_counts(w, v);
        sp__vertex_hessian(D, w->pb->local[v], h);
        carries = 1;
    }
    return carries;
}

/* out = R m R', R = (n, t1, t2): from the contact's frame to the world's. out may not be m. */
SP__APART static void sp__rotate(const sp_contact *t, const sp_real *m, sp_real *out)
{
    const sp_real *R[3] = { t->joint->n, t->joint->t1, t->joint->t2 };
    sp_real a[9];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) a[3 * i + j] = R[0][i] * m[j] + R[1][i] * m[3 + j] + R[2][i] * m[6 + j];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            out[3 * i + j] = a[3 * i] * R[0][j] + a[3 * i + 1] * R[1][j] + a[3 * i + 2] * R[2][j];
}

/* out = [c]x m (+ add, if not NULL) */
static void sp__cross_left(const sp_real c[3], const sp_real *m, const sp_real *add, sp_real *out)
{
    for (int j = 0; j < 3; j++) {
        const sp_real x = m[j], y = m[3 + j], s = m[6 + j];
        out[j]     = c[1] * s - c[2] * y + (add ? add[j] : 0);
        out[3 + j] = c[2] * x - c[0] * s + (add ? add[3 + j] : 0);
        out[6 + j] = c[0] * y - c[1] * x + (add ? add[6 + j] : 0);
    }
}

/* out = m - a [c]x, row i: m_i + c x a_i; `turn`: with a' in place of a */
static void sp__cross_right(const sp_real c[3], const sp_real *a, int turn, const sp_real *m, sp_real *out)
{
    for (int i = 0; i < 3; i++) {
        const sp_real x = turn ? a[i] : a[3 * i], y = turn ? a[3 + i] : a[3 * i + 1], s = turn ? a[6 + i] : a[3 * i + 2];
        out[3 * i]     = m[3 * i]     + c[1] * s - c[2] * y;
        out[3 * i + 1] = m[3 * i + 1] + c[2] * x - c[0] * s;
        out[3 * i + 2] = m[3 * i + 2] + c[0] * y - c[1] * x;
    }
}

/* to(r, c) += z m(r, c), 3 x 3; to has strides tr, tc, m is by rows or, mc = 3, by columns. */
static void sp__add9(sp_real *to, int tr, int tc, sp_real z, const sp_real *m, int mr, int mc)
{
    for (int c = 0; c < 3; c++, to += tc, m += mc) {
        to[0]      += z * m[0];
        to[tr]     += z * m[mr];
        to[2 * tr] += z * m[2 * mr];
    }
}

/* Diagonal block += Z [ vv . ; vw' ww ] Z, Z = diag(z[0], z[1]): the lower triangle by columns. */
static void sp__add_diagonal(sp_real *d, const sp_real *z, const sp_real *vv, const sp_real *vw, const sp_real *ww)
{
    const sp_real f = z[0] * z[0], g = z[0] * z[1], m = z[1] * z[1];
    d[0] += f * vv[0]; d[1] += f * vv[3]; d[2] += f * vv[6];
    d[6] += f * vv[4]; d[7] += f * vv[7];
    d[11] += f * vv[8];
    for (int k = 0; k < 3; k++) { d[3 + k] += g * vw[k]; d[8 + k] += g * vw[3 + k]; d[12 + k] += g * vw[6 + k]; }
    d[15] += m * ww[0]; d[16] += m * ww[3]; d[17] += m * ww[6];
    d[18] += m * ww[4]; d[19] += m * ww[7];
    d[20] += m * ww[8];
}

/* Block -= Za [ vv qb ; qa' ww ] Zb, by columns, or by rows where it is stored transposed. */
SP__APART static void sp__add_coupling(sp_real *block, int turn, const sp_real *za, const sp_real *zb, const sp_real *vv,
                                       const sp_real *qa, const sp_real *qb, const sp_real *ww)
{
    const int tr = turn ? 6 : 1, tc = turn ? 1 : 6;
    sp__add9(block, tr, tc, -za[0] * zb[0], vv, 3, 1);
    sp__add9(block + 3 * tc, tr, tc, -za[0] * zb[1], qb, 3, 1);
    sp__add9(block + 3 * tr, tr, tc, -za[1] * zb[0], qa, 1, 3);
    sp__add9(block + 3 * tr + 3 * tc, tr, tc, -za[1] * zb[1], ww, 3, 1);
}

/* The matrix's block of free block i, the lower triangle by columns; of a contact between free blocks, or of all between the two:
 * its rows are the later one's in elimination order. L is made in place, unless it is of other precision. */
#ifdef SP_REAL_MIXED
static sp_real *sp__dual_diagonal(const sp__dual *w, int32_t i) { return w->diagonal + 21 * (size_t)w->L.inv[i]; }
static sp_real *sp__dual_coupling(const sp__dual *w, int32_t c) { return w->coupling + 36 * (size_t)c; }
#else
static sp_real *sp__dual_diagonal(const sp__dual *w, int32_t i) { return w->L.d + 21 * (size_t)w->L.inv[i]; }
static sp_real *sp__dual_coupling(const sp__dual *w, int32_t c)
{
    return w->L.x + 36 * (size_t)(w->slot[c] < 0 ? -1 - w->slot[c] : w->slot[c]);
}
#endif

/* Rows and columns of held directions to zero, in every block they run through. */
static void sp__dual_hold(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i < pb->blocks; i++)
        for (int k = 0; k < 6; k++) {
            sp_real *d = sp__dual_diagonal(w, i);
            if (!sp__held(pb, i, k)) continue;
            for (int q = 0; q < 6; q++) d[q < k ? sp__column[q] + k - q : sp__column[k] + q - k] = 0;
        }
    for (int32_t c = 0; c < pb->contacts; c++)
        for (int k = 0; k < 12 && w->slot[c] != INT32_MIN; k++) {
            const int32_t i = k < 6 ? pb->contact[c].a : pb->contact[c].b;
            const int turn = w->slot[c] < 0, row = (k < 6) != turn;     /* is block a's direction a row as stored? */
            sp_real *x = sp__dual_coupling(w, c);
            if (!sp__held(pb, i, k % 6)) continue;
            for (int q = 0; q < 6; q++) x[row ? 6 * q + k % 6 : 6 * (k % 6) + q] = 0;
        }
}

/* Contact c's H, in w->h, moved to the centroids of its blocks,
 *
 *   T = [ I  -[arm]x ; 0  I ],   K_aa = Ta' H Ta,   K_bb = Tb' H Tb,   K_ab = -Ta' H Tb                                  */
SP__APART static void sp__dual_add(sp__dual *w, int32_t c)
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *za = w->weight + 2 * (size_t)(t->a < 0 ? 0 : t->a), *zb = w->weight + 2 * (size_t)(t->b < 0 ? 0 : t->b);
    sp_real *h = w->h, *vv = h + 27, *vw = h + 36, *ww = h + 45, *qa = h + 54, *qb = h + 63, *nb = h + 72, *k = h + 81;
    sp__rotate(t, h, vv);
    sp__rotate(t, h + 9, vw);
    sp__rotate(t, h + 18, ww);
    if (t->a >= 0) {
        sp__cross_right(t->ra, vv, 0, vw, qa);                              /* K_vw = vw - vv [arm]x */
        sp__cross_right(t->ra, vw, 1, ww, nb);                              /* ww - vw' [arm]x */
        sp__cross_left(t->ra, qa, nb, k);                                   /* K_ww */
        sp__add_diagonal(sp__dual_diagonal(w, t->a), za, vv, qa, k);
    }
    if (t->b >= 0) {
        sp__cross_right(t->rb, vv, 0, vw, qb);
        sp__cross_right(t->rb, vw, 1, ww, nb);
        sp__cross_left(t->rb, qb, nb, k);
        sp__add_diagonal(sp__dual_diagonal(w, t->b), zb, vv, qb, k);
    }
    if (w->slot[c] != INT32_MIN) {
        sp__cross_left(t->ra, qb, nb, k);
        sp__add_coupling(sp__dual_coupling(w, c), w->slot[c] < 0, za, zb, vv, qa, qb, k);
    }
}

/* Aeq S DP Aeq' + shift into L. */
SP__APART static void sp__dual_assemble(sp__dual *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp_problem *pb = w->pb;
    int held = 0;
#ifdef SP_REAL_MIXED
    memset(w->diagonal, 0, 21 * (size_t)pb->blocks * sizeof *w->diagonal);
    memset(w->coupling, 0, 36 * (size_t)pb->contacts * sizeof *w->coupling);
#else
    sp__bchol_zero(&w->L);
#endif
    for (int32_t c = 0; c < pb->contacts; c++) if (sp__dual_contact_hessian(w, law, c, y, w->h)) sp__dual_add(w, c);
    for (int32_t i = 0; i < pb->blocks && !held; i++) held = pb->scene->block[pb->block[i]].fixed != 0;
    if (held) sp__dual_hold(w);
    for (int32_t i = 0; i < pb->blocks; i++)
        for (int q = 0; q < 6; q++) sp__dual_diagonal(w, i)[sp__column[q]] += shift;
}

#ifdef SP_REAL_MIXED
/* L <- T A T + 2 u, u and L of the factor's precision, T = diag(A)^-1/2 (1 where that is 0): no number leaves the range of a
 * float, and motions that A hardly resists are all slowed down alike. Pivots dropped one by one would tear them apart, and
 * conjugate gradients would find each anew. Before that A's diagonal grows by its own `own`. */
SP__APART static void sp__dual_lower(sp__dual *w, sp_real own)
{
    const sp__bchol *L = &w->L;
    sp__bchol_zero(&w->L);
    for (size_t k = 0; k < (size_t)L->n; k++) {
        sp_real *d = w->diagonal + 21 * k, *t = w->scale + 6 * k;
        sp__low *to = L->d + 21 * k;
        for (int c = 0; c < 6; c++) {
            sp_real *pivot = d + sp__column[c];
            *pivot += own * *pivot;
            t[c] = *pivot > 0 ? 1 / SP_SQRT(*pivot) : 1;
        }
        for (int c = 0; c < 6; c++) {
            for (int r = c; r < 6; r++) to[sp__column[c] + r - c] = (sp__low)(d[sp__column[c] + r - c] * t[c] * t[r]);
            to[sp__column[c]] += 2 * SP__LOW_EPSILON;
        }
    }
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        if (w->slot[c] == INT32_MIN) continue;
        const int32_t a = L->inv[w->pb->contact[c].a], b = L->inv[w->pb->contact[c].b], first = a < b ? a : b;
        const sp_real *A = sp__dual_coupling(w, c), *col = w->scale + 6 * (size_t)first, *row = w->scale + 6 * (size_t)(a + b - first);
        sp__low *to = L->x + 36 * (size_t)(w->slot[c] < 0 ? -1 - w->slot[c] : w->slot[c]);
        for (int k = 0; k < 36; k++) to[k] += (sp__low)(A[k] * col[k / 6] * row[k % 6]);
    }
}

/* y <- A x, in the caller's order of rows. */
SP__APART static void sp__dual_times(const sp__dual *w, const sp_real *x, sp_real *y)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *d = sp__dual_diagonal(w, i), *xi = x + 6 * (size_t)i;
        sp_real *yi = y + 6 * (size_t)i;
        for (int r = 0; r < 6; r++) yi[r] = 0;
        for (int c = 0; c < 6; c++)
            for (int r = c; r < 6; r++) {
                const sp_real a = d[sp__column[c] + r - c];
                yi[r] += a * xi[c];
                if (r > c) yi[c] += a * xi[r];
            }
    }
    for (int32_t k = 0; k < pb->contacts; k++) {
        if (w->slot[k] == INT32_MIN) continue;
        const size_t a = (size_t)pb->contact[k].a, b = (size_t)pb->contact[k].b, first = w->L.inv[a] < w->L.inv[b] ? a : b;
        const sp_real *block = sp__dual_coupling(w, k), *xc = x + 6 * first, *xr = x + 6 * (a + b - first);
        sp_real *yc = y + 6 * first, *yr = y + 6 * (a + b - first);
        for (int c = 0; c < 6; c++)
            for (int r = 0; r < 6; r++) {
                yr[r] += block[6 * c + r] * xc[c];
                yc[c] += block[6 * c + r] * xr[r];
            }
    }
}
#endif

#ifndef SP_NO_PLAN
/* A contact's H = h of vv, vw, ww in its own frame as 3 x 3 in X. */
static void sp__flat_project(const sp__flat *o, const sp_real *g, const sp_real *h, sp_real *H)
{
    const sp_real *vv = h, *vw = h + 9, *ww = h + 18, x = g[2], y = g[3];
    if (o->mode == SP__PLANE) {
        H[0] = vv[0];
        H[1] = H[3] = vv[1] * x + vv[2] * y;
        H[4] = (vv[4] * x + 2 * vv[5] * y) * x + vv[8] * y * y;
        H[2] = H[6] = vw[2] * x - vw[1] * y;
        H[5] = H[7] = (vw[5] * x - vw[4] * y) * x + (vw[8] * x - vw[7] * y) * y;
        H[8] = (ww[8] * x - 2 * ww[5] * y) * x + ww[4] * y * y;
        return;
    }
    const sp_real p = ww[4] * g[0] + ww[5] * g[1], q = ww[5] * g[0] + ww[8] * g[1];
    H[0] = vv[0];
    H[1] = H[3] = vw[1] * g[0] + vw[2] * g[1];
    H[2] = H[6] = vw[1] * x + vw[2] * y;
    H[4] = p * g[0] + q * g[1];
    H[5] = H[7] = p * x + q * y;
    H[8] = (ww[4] * x + 2 * ww[5] * y) * x + ww[8] * y * y;
}

/* out = H T by columns, H symmetric. */
static void sp__flat_right(const sp_real H[9], const sp_real T[7], sp_real out[9])
{
    for (int r = 0; r < 3; r++) {
        out[r] = T[0] * H[r] + T[1] * H[3 + r];
        out[3 + r] = T[2] * H[r] + T[3] * H[3 + r];
        out[6 + r] = T[4] * H[r] + T[5] * H[3 + r] + T[6] * H[6 + r];
    }
}

/* Row r of T' times a column x. */
static sp_real sp__flat_left(const sp_real T[7], int r, const sp_real x[3])
{
    const sp_real sum = T[2 * r] * x[0] + T[2 * r + 1] * x[1];
    return r == 2 ? sum + T[6] * x[2] : sum;
}

/* Contact c's H into L: T' H T. */
SP__APART static void sp__flat_add(sp__dual *w, int32_t c, const sp_real H[9])
{
    const sp_contact *t = &w->pb->contact[c];
    const sp_real *T = sp__flat_frame(w, t) + 6;
    sp_real *X = w->h + 36;
    for (int side = 0; side < 2; side++) {
        const int32_t i = side ? t->b : t->a;
        if (i < 0) continue;
        sp__flat_right(H, T + 7 * side, X + 9 * side);
        sp_real *d = sp__bchol_d(&w->L) + 6 * (size_t)w->L.inv[i];
        for (int q = 0; q < 3; q++)
            for (int r = 0; r <= q; r++) d[sp__column3[r] + q - r] += sp__flat_left(T + 7 * side, r, X + 9 * side + 3 * q);
    }
    if (w->slot[c] == INT32_MIN) return;
    const int turn = w->slot[c] < 0;
    sp_real *x = sp__bchol_x(&w->L) + 9 * (size_t)(turn ? -1 - w->slot[c] : w->slot[c]);
    for (int k = 0; k < 9; k++) x[k] += sp__flat_left(T + 7 * turn, k % 3, X + 9 * !turn + k / 3 * 3);
}

/* sp__dual_assemble in 3 rows a block. */
SP__APART static void sp__flat_assemble(sp__dual *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp_problem *pb = w->pb;
    sp_real *H = w->h + 27;
    sp__bchol_zero(&w->L);
    for (int32_t c = 0; c < pb->contacts; c++) {
        if (law < SP__GIVEN && sp__dual_yield(w, c)->plain) sp__flat_hessian(w, law, c, y, H);
        else if (sp__dual_contact_hessian(w, law, c, y, w->h)) sp__flat_project(w->flat, sp__flat_frame(w, &pb->contact[c]), w->h, H);
        else continue;
        sp__flat_add(w, c, H);
    }
    for (size_t k = 0; k < (size_t)pb->blocks; k++)
        for (int q = 0; q < 3; q++) sp__bchol_d(&w->L)[6 * k + sp__column3[q]] += shift;
}

/* Solve by the factor of 3 rows. */
static void sp__flat_solve(sp__dual *w, const sp_real *b, sp_real *x)
{
    sp_real *t = w->L.t;
    for (size_t k = 0; k < (size_t)w->L.n; k++)
        for (int r = 0; r < 3; r++) t[3 * k + (size_t)r] = b[6 * (size_t)w->L.perm[k] + sp__flat_row(w->flat, r)];
    sp__bchol3_solve(&w->L, t);
    memset(x, 0, 6 * (size_t)w->L.n * sizeof *x);
    for (size_t k = 0; k < (size_t)w->L.n; k++)
        for (int r = 0; r < 3; r++) x[6 * (size_t)w->L.perm[k] + sp__flat_row(w->flat, r)] = t[3 * k + (size_t)r];
}
#endif

/* The assembled blocks as one dense lower triangle, in elimination order. */
static void sp__dual_spread(sp__dual *w)
{
    const sp__bchol *L = &w->L;
    const size_t n = 6 * (size_t)L->n;
    memset(w->dense, 0, n * (n + 1) / 2 * sizeof *w->dense);
    for (int32_t k = 0; k < L->n; k++)
        for (int32_t q = L->p[k] - 1; q < L->p[k + 1]; q++) {
            const int diagonal = q < L->p[k];
            const int32_t i = diagonal ? k : L->i[q];
            const sp__low *block = diagonal ? L->d + 21 * (size_t)k : L->x + 36 * (size_t)q;
            for (size_t r = 0; r < 6; r++)
                for (size_t c = 0; c < (diagonal ? r + 1 : 6); c++) {
                    const size_t row = 6 * (size_t)i + r;
                    w->dense[row * (row + 1) / 2 + 6 * (size_t)k + c] = (sp_real)block[diagonal ? sp__column[c] + r - c : 6 * c + r];
                }
        }
}

#ifndef SP_NO_PLAN
/* sp__dual_factor in 3 rows a block, in full precision. */
static void sp__flat_factor(sp__dual *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp_real floor = 4 * (sp_real)SP_EPSILON;
    sp__flat_assemble(w, law, y, law == SP__INTERIOR ? 0 : shift);
    w->cost->factorisations++;
#ifndef SP_NO_IPM
    if (law == SP__INTERIOR) sp__bchol_balance(&w->L, shift);
    sp__bchol3_factor(&w->L, floor);
    if (law == SP__INTERIOR) sp__bchol_unbalance(&w->L);
#else
    sp__bchol3_factor(&w->L, floor);
#endif
}
#endif

/* L L' = Aeq S DP Aeq' + shift; for the interior law, whose rows differ by orders, shift times its own diagonal. */
SP__APART static void sp__dual_factor(sp__dual *w, sp__law law, const sp_real *y, sp_real shift)
{
    const sp__low floor = 4 * (sp__low)SP__LOW_EPSILON;
    const int64_t n = 6 * (int64_t)w->L.n, own = w->dense ? n * n * 2 * w->L.n : w->L.flops;
    if (!sp__dual_pay(w, own) || !sp__dual_assembly(w, w->flat && w->flat->plain && law < SP__GIVEN)) return;
#ifndef SP_NO_PLAN
    if (w->flat) { sp__flat_factor(w, law, y, shift); return; }
#endif
    sp__dual_assemble(w, law, y, law == SP__INTERIOR ? 0 : shift);
    w->cost->factorisations++;
#ifdef SP_REAL_MIXED
    sp__dual_lower(w, law == SP__INTERIOR ? shift : 0);
#elif !defined SP_NO_IPM
    if (law == SP__INTERIOR) {
        sp__bchol_balance(&w->L, shift);
        sp__bchol_factor(&w->L, floor);
        sp__bchol_unbalance(&w->L);
        return;
    }
#endif
    if (w->dense) {
        sp__dual_spread(w);
        sp__chol_factor(w->dense, 6 * w->L.n, (sp_real)floor);
    } else sp__bchol_factor(&w->L, floor);
}

/* x <- (L L')^-1 b; x may be b. */
static void sp__dual_back(sp__dual *w, const sp_real *b, sp_real *x)
{
    const size_t n = 6 * (size_t)w->L.n;
    if (!w->dense) { sp__bchol_solve(&w->L, b, x); return; }
    for (size_t k = 0; k < n; k++) w->L.t[k] = b[6 * (size_t)w->L.perm[k / 6] + k % 6];
    sp__chol_solve(w->dense, 6 * w->L.n, w->L.t);
    for (size_t k = 0; k < n; k++) x[6 * (size_t)w->L.perm[k / 6] + k % 6] = w->L.t[k];
}

static int64_t sp__dual_solve_flops(const sp__dual *w)
{
    const int64_t n = 6 * (int64_t)w->L.n;
    return w->dense ? 2 * n * n : (144 * (int64_t)w->L.p[w->L.n] + 12 * n) / (w->L.rows == 3 ? 4 : 1);
}

#ifdef SP_REAL_MIXED
/* z <- T (L L')^-1 T r, in the range of a float whatever the size of r.     returns r.z */
static sp_real sp__dual_precondition(sp__dual *w, const sp_real *r, sp_real *z)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real most = 0, rz = 0;
    for (size_t k = 0; k < n; k++) {
        z[k] = r[k] * w->scale[6 * (size_t)w->L.inv[k / 6] + k % 6];
        most = sp__max(most, sp__abs(z[k]));
    }
    for (size_t k = 0; k < n; k++) z[k] = most > 0 ? z[k] / most : 0;
    sp__dual_back(w, z, z);
    for (size_t k = 0; k < n; k++) {
        z[k] *= w->scale[6 * (size_t)w->L.inv[k / 6] + k % 6] * most;
        rz += r[k] * z[k];
    }
    return rz;
}

/* x <- A^-1 b, x may be b, by conjugate gradients with the factor as preconditioner: a few steps, and where A is nearly singular
 * one more for every null vector, which floats can't tell from another. Directions are made orthogonal to the last one only in
 * A [Polak, Ribiere 1969]: L is not exactly what it solves. x <- 0 where not one step is paid for. */
static void sp__dual_solve(sp__dual *w, const sp_real *b, sp_real *x)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    const int64_t flops = sp__dual_solve_flops(w) + 144 * (int64_t)w->pb->contacts + 180 * (int64_t)w->L.n;
    sp_real *p = w->cg, *q = p + n, *z = q + n, *r = z + n;
#ifndef SP_NO_PLAN
    if (w->flat) {
        if (sp__dual_pay(w, sp__dual_solve_flops(w))) sp__flat_solve(w, b, x);
        else memset(x, 0, n * sizeof *x);
        return;
    }
#endif
    memcpy(r, b, n * sizeof *r);
    memset(x, 0, n * sizeof *x);
    if (!sp__dual_pay(w, flops)) return;
    sp_real rz = sp__dual_precondition(w, r, p);
    const sp_real enough = 256 * (sp_real)SP_EPSILON * (sp_real)SP_EPSILON * rz;
    for (int it = 0; it < SP__REFINE && rz > enough; it++) {
        sp__dual_times(w, p, q);
        const sp_real pq = sp__dot(p, q, n);
        if (!(pq > 0)) return;
        const sp_real alpha = rz / pq;
        for (size_t k = 0; k < n; k++) { x[k] += alpha * p[k]; r[k] -= alpha * q[k]; }
        if (!sp__dual_pay(w, flops)) return;
        const sp_real next = sp__dual_precondition(w, r, z), beta = -alpha * sp__dot(z, q, n) / rz;
        for (size_t k = 0; k < n; k++) p[k] = z[k] + beta * p[k];
        rz = next;
    }
}
#else
/* x <- (L L')^-1 b; x may be b. x <- 0 where that is no longer paid for. */
static void sp__dual_solve(sp__dual *w, const sp_real *b, sp_real *x)
{
    if (sp__dual_pay(w, sp__dual_solve_flops(w))) {
#ifndef SP_NO_PLAN
        if (w->flat) sp__flat_solve(w, b, x);
        else
#endif
        sp__dual_back(w, b, x);
    }
    else memset(x, 0, 6 * (size_t)w->L.n * sizeof *x);
}
#endif

/* Sizes by which forces are judged: sbar and Sbar, no more than load and what they themselves put on block i. */
SP__APART static void sp__dual_strict(const sp__dual *w, int32_t i, sp_real s[2])
{
    const sp_real *p = w->pb->p + 6 * (size_t)i, *bears = w->bears + 3 * (size_t)i;
    const sp_real rounding = 16 * (sp_real)SP_EPSILON * s[0] * bears[2] / w->set->tol;
    const sp_real f = sp__norm3(p) / w->unit + bears[0], m = sp__norm3(p + 3) / w->unit + bears[1] + rounding;
    if (f < s[0]) s[0] = f;
    if (m < s[1]) s[1] = m;
}

/* Weighted imbalance relative to sbar and Sbar, or to what forces are judged by: the largest over the blocks. */
static sp_real sp__dual_omega(const sp__dual *w, const sp_real *r)
{
    sp_real omega = 0;
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *ri = r + 6 * (size_t)i, *z = w->weight + 2 * (size_t)i;
        sp_real s[2] = { w->size[2 * (size_t)i], w->size[2 * (size_t)i + 1] };
        if (w->bears) sp__dual_strict(w, i, s);
        const sp_real f = sp__ratio(sp__norm3(ri), z[0] * s[0]), m = sp__ratio(sp__norm3(ri + 3), z[1] * s[1]);
        if (f > omega) omega = f;
        if (m > omega) omega = m;
    }
    return omega;
}

/* Are forces and motions of the rows at hand all of the scene's? Else sizes are the loads alone, which are less. */
static int sp__dual_whole(const sp__dual *w)
{
#ifndef SP_NO_PLAN
    if (w->flat && w->flat->mode == SP__PLUMB) return w->flat->forest || w->flat->slick;
#endif
    (void)w;
    return 1;
}

/* A contact's share in the size of a block it touches: sum |f_v| and sum |x_v x f_v|, x_v seen from the centroid. */
SP__APART static void sp__dual_size(const sp__dual *w, const sp_contact *t, const sp_real *arm, sp_real twist[4][3], sp_real *size,
                                    sp_real *longest)
{
    const sp_interface *g = t->joint;
    const sp_real o[3] = { sp__dot3(arm, g->n), sp__dot3(arm, g->t1), sp__dot3(arm, g->t2) };
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *l = w->pb->local[v], x[3] = { o[0] + l[0], o[1] + l[1], o[2] + l[2] };
        const sp_real times = sp__dual_counts(w, v);
        sp_real u[3], m[3];
        sp__dual_rate(w, twist[0], twist[1], l, u);
        sp__dual_rate(w, twist[2], twist[3], l, m);
        sp__sub3(u, m, u);
        sp__cross3(x, u, m);
        size[0] += times * sp__norm3(u);
        size[1] += times * sp__norm3(m);
        *longest = sp__max(*longest, sp__norm3(x));
    }
}

#ifndef SP_NO_PLAN
/* The same of a contact in 3 rows, both blocks. */
SP__APART static void sp__flat_size(sp__dual *w, const sp_contact *t, const sp_real *y)
{
    const sp_real *g = sp__flat_frame(w, t);
    sp_real X[3] = { 0, 0, 0 }, dX[3];
    if (sp__dual_whole(w)) {
        sp__flat_there(w, t, g, y, X);
        sp__flat_there(w, t, g, w->d, dX);
        sp__sub3(X, dX, X);
    }
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp_real q[2], u[2], one[2];
        const sp_real times = sp__flat_rate(w, g, v, X, q, u);
        for (int side = 0; side < 2 && times > 0; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real far = sp__flat_moment(w, t, side, v, u, one);
            w->size[2 * (size_t)i] += times * one[0];
            w->size[2 * (size_t)i + 1] += times * one[1];
            w->L.t[i] = sp__max(w->L.t[i], far);
        }
    }
}
#endif

/* size = sbar and Sbar of the certificate check, from the bilateral force of potential y (metric 1) less that of w->d, its
 * correction; L.t is used up. */
static void sp__dual_sizes(sp__dual *w, const sp_real *y)
{
    const sp_problem *pb = w->pb;
    if (!sp__dual_sweep(w, sp__dual_whole(w), 2 * sp__dual_whole(w)) || !sp__dual_count(w, SP__FLOPS_SWEEP, 0)) return;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *p = pb->p + 6 * (size_t)i;
        w->size[2 * (size_t)i] = sp__norm3(p) / w->unit;
        w->size[2 * (size_t)i + 1] = sp__norm3(p + 3) / w->unit;
        w->L.t[i] = 0;                                                  /* longest arm */
    }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
#ifndef SP_NO_PLAN
        if (w->flat && w->flat->plain) { sp__flat_size(w, t, y); continue; }
#endif
        sp_real twist[4][3];
        sp__dual_twist(w, t, y, twist[0], twist[1]);
        sp__dual_twist(w, t, w->d, twist[2], twist[3]);
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i >= 0) sp__dual_size(w, t, side ? t->rb : t->ra, twist, w->size + 2 * (size_t)i, &w->L.t[i]);
        }
    }
    for (size_t i = 0; i < (size_t)pb->blocks; i++)
        w->size[2 * i + 1] += 16 * (sp_real)SP_EPSILON * w->size[2 * i] * w->L.t[i] / w->set->tol;
}

/* Is a metric needed, because contacts of very different load meet?     returns 1 when it is, and sets it */
static int sp__dual_metric(sp__dual *w)
{
    sp_real least = SP__HUGE, most = 0;
    if (w->spent) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_real s = sp__lesser(&w->pb->contact[c], w->size, 2);
        if (s < least) least = s;
        if (s > most) most = s;
    }
    if (!(most > 1000 * least)) return 0;
    w->metric = 1 / most;
    return 1;
}

/* METRIC: H of the penalty form; LIMIT: exact, and room for interior points of 3 numbers a vertex, or one an edge, behind it;
 * MOTION: exact, with no such room. */
typedef enum sp__form { SP__EXACT, SP__EXACT_DENSE, SP__PENALTY, SP__METRIC, SP__LIMIT, SP__MOTION } sp__form;

/* Where every contact's block off the diagonal is. */
static void sp__dual_slots(sp__dual *w)
{
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        int32_t turned = 0;
        w->slot[c] = INT32_MIN;
        if (t->a < 0 || t->b < 0) continue;
        w->slot[c] = sp__bchol_slot(&w->L, t->a, t->b, &turned);
        if (turned) w->slot[c] = -1 - w->slot[c];
    }
}

#ifndef SP_NO_PLAN
/* Height of contact c along e2 above the centroid of its free block of the lower number. */
static sp_real sp__flat_height(const sp__dual *w, const sp_contact *t)
{
    const int a = t->a >= 0 && (t->b < 0 || t->a < t->b);
    return sp__dot3(a ? t->ra : t->rb, w->flat->e[2]);
}

/* Are joints of one pair of nodes in one plane, none across and none warped?     L.d, L.x: a mark and the height of the first */
SP__APART static int sp__flat_tidy(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    const sp_real eps = sp__flat_small(w->set);
    sp__bchol_zero(&w->L);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const int32_t i = t->a >= 0 ? t->a : t->b, slot = w->slot[c];
        sp_real *first = slot == INT32_MIN ? sp__bchol_d(&w->L) + 6 * (size_t)i : sp__bchol_x(&w->L) + 9 * (size_t)(slot < 0 ? -1 - slot : slot);
        const sp_real height = sp__flat_height(w, t), size = sp__norm3(t->ra) + sp__norm3(t->rb);
        if (first[0] > 0 && sp__abs(first[1] - height) > eps * size) return 0;
        first[0] = 1;
        first[1] = height;
        for (int32_t v = t->point; v < t->point + t->points; v++)
            if (w->flat->mate[v] < 0 || sp__abs(pb->local[v][0]) > eps * (size + sp__norm3(pb->local[v]))) return 0;
    }
    return 1;
}

/* Nodes less edges are as many as trees: a forest. Supports are one node, of edges between free blocks each is in adj twice.
 * mark: trees without supports; parent: does a block, then a tree, touch one? */
SP__APART static int sp__flat_forest(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    int64_t edges = w->xadj[pb->blocks] / 2, trees = 1;
    if (!sp__flat_tidy(w)) return 0;
    for (int32_t i = 0; i < pb->blocks; i++) { w->mark[i] = i; w->parent[i] = 0; }
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        if (t->a >= 0 && t->b >= 0) sp__join(w->mark, t->a, t->b);
        else w->parent[t->a >= 0 ? t->a : t->b] = 1;
    }
    for (int32_t i = 0; i < pb->blocks; i++) edges += w->parent[i];
    for (int32_t i = 0; i < pb->blocks; i++) w->parent[sp__root(w->mark, i)] |= w->parent[i];
    for (int32_t i = 0; i < pb->blocks; i++) trees += sp__root(w->mark, i) == i && !w->parent[i];
    return edges + trees == (int64_t)pb->blocks + 1;
}

/* Sideways motion of a forest, rows 0 and 1, from supports upwards so that no joint slips; m: motions in the axes e. With turns w0,
 * w1 a block's points at arm r2 along e2 go sideways by v0 + w1 r2, v1 - w0 r2.     mark: has it been placed? */
SP__APART static void sp__flat_place(sp__dual *w, sp_real *m)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i < pb->blocks; i++) w->mark[i] = 0;
    for (int more = 1, turn = 0; more; turn = !turn) {
        more = 0;
        w->cost->flops += 8 * (int64_t)pb->contacts;
        for (int32_t k = 0; k < pb->contacts; k++) {
            const sp_contact *t = &pb->contact[turn ? pb->contacts - 1 - k : k];
            const int a = t->a < 0 || w->mark[t->a], b = t->b < 0 || w->mark[t->b];
            if (a == b) continue;
            const int32_t from = a ? t->a : t->b, to = a ? t->b : t->a;
            const sp_real below = sp__dot3(a ? t->ra : t->rb, w->flat->e[2]), above = sp__dot3(a ? t->rb : t->ra, w->flat->e[2]);
            sp_real *x = m + 6 * (size_t)to, v[2] = { 0, 0 };
            if (from >= 0) {
                const sp_real *y = m + 6 * (size_t)from;
                v[0] = y[0] + y[4] * below;
                v[1] = y[1] - y[3] * below;
            }
            x[0] = v[0] - x[4] * above;
            x[1] = v[1] + x[3] * above;
            w->mark[to] = more = 1;
        }
    }
}

/* Motions out of the axes e, of a forest with what goes sideways. */
static void sp__flat_lift(sp__dual *w, sp_real *m)
{
    if (w->flat->forest) sp__flat_place(w, m);
    for (int32_t i = 0; i < 2 * w->pb->blocks; i++) sp__flat_unturn(w->flat, m + 3 * (size_t)i);
}

#ifndef SP_NO_IPM
/* And into them: planar rows alone. */
static void sp__flat_drop(const sp__flat *o, int32_t blocks, sp_real *m)
{
    for (int32_t i = 0; i < 2 * blocks; i++, m += 3) {
        sp__flat_turn(o, m, m);
        if (i % 2) m[0] = m[1] = 0; else m[2] = 0;
    }
}
#endif

/* What a search in 3 rows has besides: frames, images, work of a factor. */
SP__APART static void sp__flat_open(sp__dual *w)
{
    const sp_problem *pb = w->pb;
    sp__flat_mates(w->flat, pb, w->set);
    w->flat->plain = !sp__problem_strong(pb);
    for (int32_t c = 0; c < pb->contacts; c++) sp__flat_contact(w->flat, &w->cone, &pb->contact[c], w->flat->g + SP__FLAT_G * (size_t)c);
    w->L.flops = 0;
    for (int32_t k = 0; k < w->L.n; k++) {
        const int64_t below = w->L.p[k + 1] - w->L.p[k];
        w->L.flops += 17 + 57 * below + 54 * (below * (below - 1) / 2);
    }
    w->flat->forest = w->flat->mode == SP__PLUMB && sp__flat_forest(w);
    w->flat->slick = w->flat->mode == SP__PLUMB;
    for (int32_t c = 0; c < pb->contacts; c++)
        if (pb->contact[c].joint->joint.mu > 0 || w->flat->mate[pb->contact[c].point] < 0) w->flat->slick = 0;
}

/* Forces of vertices that do not count: those of their images, or none; what rounding left of forces across the plane goes. */
static void sp__flat_spread(const sp__flat *o, const sp_problem *pb, sp_real *f)
{
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp_real *g = o->g + SP__FLAT_G * (size_t)c;
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real *fv = f + 3 * (size_t)v;
            if (o->mate[v] < 0) fv[0] = fv[1] = fv[2] = 0;
            else if (o->mate[v] < v) memcpy(fv, f + 3 * (size_t)o->mate[v], 3 * sizeof *f);
            else if (o->mode == SP__PLANE) {
                const sp_real slip = fv[1] * g[2] + fv[2] * g[3];
                fv[1] = slip * g[2];
                fv[2] = slip * g[3];
            }
        }
    }
}
#endif

/* Room for the whole dual in place of *flat, which begins in `a`, so that a search in 3 rows does with what the whole one takes. */
SP__APART static int sp__dual_reserve(const sp_problem *pb, const sp_settings *set, sp__form form, int32_t nnz, const sp__flat *flat,
                                      sp_arena *a)
{
    const size_t from = (size_t)((const unsigned char *)flat - a->base);
    sp_arena rest = *a;
    sp__dual *t = sp__take(&rest, 1, sizeof *t);
    if (!t) return 0;
    t->flat = NULL;
    size_t rays = form == SP__PENALTY || form == SP__MOTION ? 0 : form == SP__LIMIT && !set->faces ? 3 : (size_t)set->faces;
#ifdef SP_NO_IPM
    rays = 0;
#endif
    const size_t end = sp__dual_end(t, pb, set, 0, rays, nnz, from);
    if (end > a->cap) return 0;
    if (end > a->peak) a->peak = end;
    return 1;
}

/* A dual in `a`, everything but the numbers of a metric; flat (may be NULL): in 3 rows, *flat the last thing taken from `a`.
 *     returns NULL when the arena is too small */
SP__APART static sp__dual *sp__dual_make(const sp_problem *pb, const sp_settings *set, sp__form form, sp__flat *flat,
                                         sp_cost *cost, sp_arena *a)
{
    const int penalty = form == SP__PENALTY;
    sp__dual *w = sp__take(a, 1, sizeof *w);
    const int32_t nnz = w ? sp__dual_analyse(w, pb, a) : -1;
    if (nnz < 0 || (flat && !sp__dual_reserve(pb, set, form, nnz, flat, a))) return NULL;
    w->flat = flat;
    sp__dual_carve(w, pb, set->faces, nnz, form == SP__EXACT_DENSE, a);
    if (sp__failed(a)) return NULL;
    sp__bchol_pattern(&w->L, w->xadj, w->adj, w->parent, w->mark);
    w->set = set;
    w->cost = cost;
    w->limit = INT64_MAX;
    w->spent = 0;
    w->soft = penalty && !set->net ? 1 / set->gamma : 0;
    w->slide = penalty ? 1 / SP_SQRT(set->tau) : 1;
    if (form == SP__METRIC) w->slide = 1 / SP_SQRT(set->tau * (1 + 1 / set->gamma));     /* fp and fm move together: 1 + 1/gamma */
    sp__cone_make(&w->cone);
    sp_real half;
    w->factor = 1;
    w->metric = 0;
    if (set->faces && set->inscribed) sp__pyramid_half(set->faces, &w->factor, &half);
    if (set->effect[SP_EFFECT_FRICTION] == SP_WITHOUT) w->factor = 0;
    if (penalty) w->factor /= w->slide;
    sp__dual_slots(w);
    w->unit = sp__load_unit(pb);
    w->bears = NULL;
#ifndef SP_NO_PLAN
    if (flat) sp__flat_open(w);
#endif
    return w;
}

static sp__dual *sp__dual_open(const sp_problem *pb, const sp_settings *set, sp__form form, sp_cost *cost, sp_arena *a)
{
    return sp__dual_make(pb, set, form, NULL, cost, a);
}

#endif /* SP_SMALL */

/* 12 ---------------------------------------------------------------------------------------------------- search constants */

#ifdef SP_REAL_FLOAT
#define SP__SHIFT ((sp_real)1e-6)       /* diagonal shift that keeps a semidefinite matrix of unit size factorable */
#define SP__PROX ((sp_real)3e-7)        /* end of the proximal path: a few roundings of the diagonal */
#define SP__DEEP ((sp_real)1e-4)        /* so far down the path proofs are tried even while the imbalance falls */
#define SP__TIE ((sp_real)2e-4)         /* where on the path rigid groups show */
#define SP__PLAY ((sp_real)1e-3)        /* motion within a group, relative */
#define SP__GAIN ((sp_real)0.9)         /* a round of balancing that leaves no less is the last: factors have few digits */
#else
#define SP__SHIFT ((sp_real)1e-13)
#define SP__PROX ((sp_real)1e-15)
#define SP__DEEP SP__SHIFT
#define SP__TIE ((sp_real)1e-8)
#define SP__PLAY ((sp_real)1e-6)
#define SP__GAIN ((sp_real)0.5)
#endif
#define SP__ITERATIONS 300              /* factorisations of an exact solve, unless the caller wants others */
#define SP__PLAY_IDLE ((sp_real)0.1)    /* SP__PLAY where rounding has ended the search */
#define SP__IPM_MOST 60                 /* interior-point iterations */
#define SP__IPM_LATE ((sp_real)1e-5)    /* theta from which on a motion is worth more work than steps: the limit is near */
#define SP__IPM_KEEP ((sp_real)0.99)    /* share of the way to the boundary */
#define SP__IPM_NOWHERE ((sp_real)0.1)  /* length of a step that gets nowhere */
#define SP__IPM_IDLE 8                  /* so many of them one after the other end it: rounding holds theta */
#ifdef SP_REAL_MIXED
#define SP__IPM_LAST 0                  /* factors in float hold them, but other ways refine in double */
#else
#define SP__IPM_LAST 1                  /* where they get nowhere nothing else does */
#endif
#if defined SP_REAL_FLOAT || defined SP_REAL_MIXED
#define SP__IPM_SHIFT (16 * (sp_real)SP_EPSILON)        /* relative to each diagonal */
#else
#define SP__IPM_SHIFT ((sp_real)SP_EPSILON)     /* a mechanism 1e-6 from its limit is resisted by no more */
#endif

#ifdef SP_SMALL
SP_API const sp_seed *sp_seed_table(void) { return NULL; }
#else
/* The seed's constants, each with its section; what a float can't reach is float's own. */
#ifdef SP_REAL_FLOAT
#define SP__SEED(d, f) ((sp_real)f)
#else
#define SP__SEED(d, f) ((sp_real)d)
#endif
static const sp_seed sp__seed = {
    .faces = 8, .inscribed = 1, .net = 1,                                       /* [1.4] */
    .gamma = (sp_real)1e3, .tau = (sp_real)1,                                   /* [1.5] */
    .dense_cells = 12000000,                                                    /* [1.5] */
    .tension = (sp_real)1e-3,                                                   /* [1.6] */
    .balance = SP__SEED(1e-6, 1e-5), .cone = SP__SEED(1e-7, 1e-5),              /* [2.1] */
    .gain = (sp_real)0.05, .window = 250, .rounds = 20000,                      /* [2.2] */
    .engaged = (sp_real)0.01, .floor = (sp_real)1e-9, .reg = SP__SEED(1e-9, 1e-6),                      /* [3.2] */
    .gate = (sp_real)0.5, .peel = (sp_real)0.75, .askew = (sp_real)2, .turns = 12,                      /* [3.3] */
    .admm = {
        .backend = SP_QP_SPARSE,
        .eps_abs = (sp_real)1e-4, .eps_rel = (sp_real)1e-4,                     /* [4.2] the checker's */
        .eps_pinf = (sp_real)1e-4, .eps_dinf = (sp_real)1e-4,                   /* [4.3] */
        .radius = SP__SEED(1e6, 1e3),                                           /* ours: what a certificate must exclude */
        .iterations = 8000, .check = 10, .passes = 3,                           /* [4.2] and so on to the end */
        .sigma = SP__SEED(1e-6, 1e-3), .relax = (sp_real)1.6, .rho = (sp_real)0.1, .rho_equal = SP__SEED(1e3, 1e2),
        .adapt = 100, .adapt_most = 10, .adapt_factor = (sp_real)5, .cg_steps = 250, .cg_tol = SP__SEED(1e-10, 1e-6)
    },
    .native = {
        .backend = SP_QP_SPARSE, .eps_abs = SP__SEED(1e-6, 1e-4), .eps_rel = SP__SEED(1e-5, 1e-4),      /* [4.4] */
        .eps_pinf = (sp_real)1e-4, .eps_dinf = (sp_real)1e-4, .radius = SP__SEED(1e6, 1e3),
        .strict = 1, .polish = 1, .iterations = 6000, .check = 10, .passes = 10,                        /* [4.4] */
        .sigma = SP__SEED(1e-6, 1e-3), .relax = (sp_real)1.6, .rho = (sp_real)0.1, .rho_equal = SP__SEED(1e3, 1e2),
        .adapt = 100, .adapt_most = 10, .adapt_factor = (sp_real)5, .cg_steps = 250, .cg_tol = SP__SEED(1e-10, 1e-6)
    }
};
#undef SP__SEED

SP_API const sp_seed *sp_seed_table(void) { return &sp__seed; }

/* 13 --------------------------------------------------------------------------------------------------------------- gates */

static size_t sp__gates_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    (void)set; (void)scratch;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, (size_t)pb->blocks + 1, sizeof(int32_t));
    return dry.peak;
}

/* Centroid of free block k seen from that of free block i. */
static void sp__gates_arm(const sp_problem *pb, int32_t i, int32_t k, sp_real r[3])
{
    sp__sub3(pb->scene->block[pb->block[k]].centroid, pb->scene->block[pb->block[i]].centroid, r);
}

/* Force F on the group of block i, its moment M about that block's centroid.                returns how many blocks it has */
static int32_t sp__gates_pull(const sp_problem *pb, int32_t *up, int32_t i, sp_real F[3], sp_real M[3])
{
    int32_t size = 0;
    sp__scale3(0, F, F);
    sp__scale3(0, M, M);
    for (int32_t k = i; k < pb->blocks; k++) {
        sp_real r[3];
        if (sp__root(up, k + 1) != i + 1) continue;
        sp__gates_arm(pb, i, k, r);
        sp__cross3_add(r, pb->p + 6 * (size_t)k, M);
        for (size_t q = 0; q < 3; q++) {
            F[q] += pb->p[6 * (size_t)k + q];
            M[q] += pb->p[6 * (size_t)k + 3 + q];
        }
        size++;
    }
    return size;
}

/* The first group without support that is pulled or turned moves: dq = F / |F|, or M / |M| about the first block, for its
 * blocks.                                                                                              returns its size */
static int32_t sp__gates_fall(const sp_problem *pb, int32_t *up, sp_real *dq)
{
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (up[i + 1] != i + 1) continue;
        sp_real F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 };
        const int32_t size = sp__gates_pull(pb, up, i, F, M);
        const int turn = !(sp__norm3(F) > 0);
        if (turn && !(sp__norm3(M) > 0)) continue;
        sp__unit3(turn ? M : F, F);
        for (int32_t k = i; k < pb->blocks; k++) {
            sp_real r[3], *to = dq + 6 * (size_t)k;
            if (sp__root(up, k + 1) != i + 1) continue;
            sp__gates_arm(pb, i, k, r);
            if (turn) sp__cross3(F, r, to); else memcpy(to, F, sizeof F);
            if (turn) memcpy(to + 3, F, sizeof F);
        }
        return size;
    }
    return 0;
}

static sp_status sp__gates_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    (void)set;
    int32_t *up = sp__take(arena, (size_t)pb->blocks + 1, sizeof *up);
    if (sp__failed(arena)) return SP_E_MEMORY;
    state->reason = SP_REASON_BUDGET;
    if (state->left < 6 * (int64_t)pb->blocks) return SP_OK;
    state->reason = SP_REASON_STAGES;
    sp_real load = 0;
    memset(state->dq, 0, 6 * (size_t)pb->blocks * sizeof *state->dq);
    for (size_t k = 0; k < 6 * (size_t)pb->blocks; k++) load = sp__max(load, sp__abs(pb->p[k]));
    if (!(load > 0)) {
        *claim = SP_STABLE;
        state->reason = SP_REASON_NOTHING;
        return SP_OK;
    }
    for (int32_t i = 0; i <= pb->blocks; i++) up[i] = i;
    for (int32_t i = 0; i < pb->blocks; i++) if (pb->scene->block[pb->block[i]].fixed) sp__join(up, 0, i + 1);
    for (int32_t c = 0; c < pb->contacts; c++) sp__join(up, pb->contact[c].a + 1, pb->contact[c].b + 1);
    const int32_t size = sp__gates_fall(pb, up, state->dq);
    if (size) {
        *claim = SP_UNSTABLE;
        state->reason = size > 1 ? SP_REASON_NO_SUPPORT : SP_REASON_NO_CONTACT;
    }
    state->cost.flops += 6 * (int64_t)pb->blocks;
    return SP_OK;
}

/* 14 ----------------------------------------------------------------------------------------------------- bilateral force */

/* Least squares in the metric: (G + shift) y = -p, G = Aeq S Aeq', and where p has a part that no contact resists at all
 * (then y would run off by it) that part is taken out again: y <- y - shift (G + shift)^-1 y.               [seed 2.1] */

static void sp__dual_axpy(sp__dual *w, sp_real s, const sp_real *x, sp_real *y)
{
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) y[k] += s * x[k];
}

static sp_real sp__dual_norm(const sp__dual *w, const sp_real *x)
{
    return SP_SQRT(sp__dot(x, x, 6 * (size_t)w->pb->blocks));
}

/* w->r <- correction of y for gradient r, by the factor at hand. */
static void sp__bilateral_correct(sp__dual *w)
{
    sp__dual_solve(w, w->r, w->r);
    if (!w->singular) return;
    sp__dual_solve(w, w->r, w->d);
    sp__dual_axpy(w, -SP__SHIFT, w->d, w->r);
}

/* w->y: potential of the bilateral force of the load at hand, by the bilateral factor; w->d: what rounding left of it, y - d is
 * better. Worth nothing when w->spent. */
SP__APART static void sp__bilateral_solve(sp__dual *w)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    for (size_t k = 0; k < n; k++) w->y[k] = 0;
    sp__dual_load(w, w->r);
    w->load = sp__dual_norm(w, w->r);
    w->singular = 0;
    sp_real last = SP__HUGE;
    for (int it = 0; it < 6; it++) {
        sp__bilateral_correct(w);
        sp__dual_axpy(w, -1, w->r, w->y);
        sp__dual_gradient(w, SP__BILATERAL, w->y, w->r, NULL);
        if (w->spent) return;
        const sp_real now = sp__dual_norm(w, w->r);
        if (!w->singular && now > SP__SCALE_TOL * w->load) {            /* again, for a matrix with null vectors in the load */
            w->singular = 1;
            it = -1;
            last = SP__HUGE;
            for (size_t k = 0; k < n; k++) w->y[k] = 0;
            sp__dual_load(w, w->r);
            continue;
        }
        if (now <= 64 * (sp_real)SP_EPSILON * w->load || now > last / 4) break;
        last = now;
    }
    sp__bilateral_correct(w);
    memcpy(w->d, w->r, n * sizeof *w->d);
}

/* The same from the beginning, in the metric at hand. Factorises once. */
static void sp__dual_bilateral(sp__dual *w)
{
    sp__dual_weights(w);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->y[k] = 0;
    sp__dual_factor(w, SP__BILATERAL, w->y, SP__SHIFT);
    sp__bilateral_solve(w);
}

/* state->y0 <- unweighted potential of metric 1, [N/m]: f0 = Aeq' (y0 + y0'), in two parts. */
static void sp__dual_hint(sp__dual *w, sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
#ifndef SP_NO_PLAN
    if (w->flat && w->flat->mode == SP__PLUMB && !w->flat->forest) return;
#endif
    for (size_t k = 0; k < n; k++) {
        state->y0[k] = w->unit * w->weight[k / 3] * w->y[k];
        state->y0[n + k] = -w->unit * w->weight[k / 3] * w->d[k];
    }
#ifndef SP_NO_PLAN
    if (w->flat) { sp__flat_lift(w, state->y0); sp__flat_lift(w, state->y0 + n); }
#endif
    state->has_y0 = 1;
}

/* state->f <- forces of potential y in newtons. */
static void sp__dual_forces(sp__dual *w, sp__law law, const sp_real *y, sp_state *state)
{
    sp__dual_gradient(w, law, y, w->r, state->f);
    for (int32_t c = 0; c < w->pb->contacts && !w->spent; c++) {
        const sp_contact *t = &w->pb->contact[c];
        for (size_t k = 3 * (size_t)t->point; k < 3 * (size_t)(t->point + t->points); k++) state->f[k] *= w->unit;
    }
}

#ifndef SP_NO_PLAN
/* The hint alone. */
SP__APART static sp_status sp__bilateral_hint(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena arena)
{
    sp__dual *w = sp__dual_open(pb, set, SP__EXACT, &state->cost, &arena);
    if (!w) return SP_E_MEMORY;
    sp__dual_bilateral(w);
    sp__dual_hint(w, state);
    return SP_OK;
}
#endif

/* What the seed asks of the bilateral force before it calls it forces: no tension, no friction beyond the cone. */
typedef struct sp__gate { int tension, friction; } sp__gate;

/* Largest compression and tension of f, and friction beyond the cone, by f's own size.                  [seed 2.1] */
SP__APART static sp__gate sp__seed_gate(sp__dual *w, const sp_seed *seed, const sp_real *f)
{
    sp_real press = 0, pull = 0, beyond = 0, size = 0;
    const sp__gate shut = { 0, 0 };
    if (!sp__dual_count(w, SP__FLOPS_SWEEP, 0)) return shut;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        const sp__yield *yield = sp__dual_yield(w, c);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real *g = f + 3 * (size_t)v;
            const sp_real flat[3] = { sp__max(0, g[0]), g[1], g[2] };
            sp__foot foot;
            sp__cone_foot(&w->cone, yield, yield->plain, flat, &foot);
            press = sp__max(press, g[0]);
            pull = sp__max(pull, -g[0]);
            size = sp__max(size, sp__norm3(g));
            beyond = sp__max(beyond, foot.a - yield->mu * (w->set->net ? g[0] : flat[0]));
        }
    }
    const sp__gate gate = { pull <= seed->tension * press, beyond <= seed->cone * size };
    return gate;
}

static sp_status sp__bilateral_run(const sp_problem *pb, const sp_settings *set, sp__form form, sp_state *state,
                                   sp_arena *arena, sp_verdict *claim)
{
    sp__dual *w = sp__dual_open(pb, set, form, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    w->limit = state->left;
    state->reason = SP_REASON_BUDGET;
    sp__dual_bilateral(w);
    if (w->spent) return SP_OK;
    if (form != SP__METRIC) sp__dual_hint(w, state);
    sp__dual_forces(w, SP__BILATERAL, w->y, state);
    if (w->spent) return SP_OK;
    state->reason = SP_REASON_STAGES;
    *claim = SP_STABLE;
    if (!set->seed) return SP_OK;
    const sp__gate gate = sp__seed_gate(w, set->seed, state->f);
    if (!gate.tension || !gate.friction || sp__dual_norm(w, w->r) > set->seed->balance * w->load) *claim = SP_UNDECIDED;
    return SP_OK;
}

static sp_status sp__least_squares_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                                       sp_verdict *claim)
{
    return sp__bilateral_run(pb, set, set->seed ? SP__METRIC : SP__EXACT, state, arena, claim);
}

static sp_status sp__dense_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    return sp__bilateral_run(pb, set, SP__EXACT_DENSE, state, arena, claim);
}

static size_t sp__sparse_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__dual_need(pb, set, 0, 0, scratch);
}

static size_t sp__dense_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__dual_need(pb, set, 1, 0, scratch);
}

/* 15 -------------------------------------------------------------------------------------------------------------- polish */

/* Alternating projections between the cones and E = { Aeq f + p = 0 }:  f <- P_K(f),  f <- f - Aeq' G^-1 (Aeq f + p), one
 * factor of G = Aeq Aeq'. Ends when the forces in the cones balance, or when a window of rounds gains too little: an empty
 * intersection never ends by itself, so this stage can only say STABLE. With the seed's constants in the settings the second
 * step is taken in the metric of the penalty form, f <- f - H^-1 Aeq' (Aeq H^-1 Aeq')^-1 (Aeq f + p), its goal is the seed's
 * gate, and it does not start where tension alone blocks the bilateral force.                            [seed 2.2] */

/* f <- P_K(f + H^-1 Aeq' y) and r = Aeq f + p of it. */
SP__APART static void sp__polish_round(sp__dual *w, const sp_real *y, sp_real *f, sp_real *r)
{
    const sp_problem *pb = w->pb;
    if (!sp__dual_count(w, (w->bears ? 2 : 1) * SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) return;
    sp__dual_load(w, r);
    if (w->bears) memset(w->bears, 0, 3 * (size_t)pb->blocks * sizeof *w->bears);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp__yield *yield = sp__dual_yield(w, c);
        sp_real V[3], W[3], F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 }, u[3], m[3];
        sp__dual_twist(w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real *g = f + 3 * (size_t)v;
            sp__dual_rate(w, V, W, pb->local[v], u);
            for (int k = 0; k < 3; k++) u[k] = g[k] + (k ? w->slide * u[k] : u[k]);
            sp__cone_project(&w->cone, yield, u, g);
            sp__cross3(pb->local[v], g, m);
            for (int k = 0; k < 3; k++) { F[k] += g[k]; M[k] += m[k]; }
            if (w->bears) sp__dual_bear(w, t, pb->local[v], g);
        }
        sp__dual_scatter(w, t, F, M, r);
    }
    sp__dual_release(w, r);
}

/* A round and its omega. keep (NULL: not on a budget) gets the forces whose omega, as forces are judged, is the best so far. */
SP__APART static sp_real sp__polish_look(sp__dual *w, sp_real *f, sp_real *keep, sp_real *best)
{
    if (keep) w->bears = w->L.t;
    sp__polish_round(w, w->y, f, w->r);
    const sp_real strict = w->spent ? SP__HUGE : sp__dual_omega(w, w->r);
    w->bears = NULL;
    if (keep && strict < *best) {
        *best = strict;
        memcpy(keep, f, 3 * (size_t)w->pb->points * sizeof *f);
    }
    return w->spent ? SP__HUGE : sp__dual_omega(w, w->r);
}

static size_t sp__polish_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    return sp__dual_need(pb, set, 0, set->budget > 0 ? 3 : 0, scratch);
}

static sp_status sp__polish_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    const sp_seed *seed = set->seed ? set->seed : sp_seed_table();
    sp__dual *w = sp__dual_open(pb, set, set->seed ? SP__METRIC : SP__EXACT, &state->cost, arena);
    const size_t n = 6 * (size_t)pb->blocks, size = 3 * (size_t)pb->points;
    sp_real best = SP__HUGE, *keep = w && set->budget > 0 ? sp__take(arena, size, sizeof *keep) : NULL;
    if (!w || sp__failed(arena)) return SP_E_MEMORY;
    w->limit = state->left;
    const sp_real goal = set->seed && seed->balance < set->tol / 4 ? seed->balance : set->tol / 4;
    state->reason = SP_REASON_BUDGET;
    sp__dual_bilateral(w);
    if (w->spent) return SP_OK;
    if (!set->seed) sp__dual_hint(w, state);
    sp__dual_sizes(w, w->y);
    if (set->seed) sp__dual_forces(w, SP__BILATERAL, w->y, state);
    const sp__gate gate = set->seed ? sp__seed_gate(w, seed, state->f) : (sp__gate){ 1, 0 };
    if (gate.friction && !gate.tension) { state->reason = SP_REASON_STAGES; return SP_OK; }
    memset(state->f, 0, size * sizeof *state->f);
    sp_real omega = sp__polish_look(w, state->f, keep, &best), last = omega;
    if (w->spent) return SP_OK;
    for (int round = 1; omega > goal && round <= seed->rounds; round++) {
        sp__dual_solve(w, w->r, w->y);
        for (size_t k = 0; k < n; k++) w->y[k] = -w->y[k];
        const sp_real now = sp__polish_look(w, state->f, keep, &best);
        if (w->spent) break;
        omega = now;
        state->cost.iterations++;
        if (round % seed->window) continue;
        if (omega > (1 - seed->gain) * last) break;
        last = omega;
    }
    *claim = omega <= (set->seed ? goal : set->tol) ? SP_STABLE : SP_UNDECIDED;
    if (keep && !*claim) memcpy(state->f, keep, size * sizeof *keep);
    for (size_t k = 0; k < size; k++) state->f[k] *= w->unit;
    if (!w->spent) state->reason = SP_REASON_STAGES;
    return SP_OK;
}

/* 16 --------------------------------------------------------------------------------------- exact stage: search and proof */

/* Semismooth Newton on the dual with a line search, from the bilateral potential; where that stalls (collapse, or close to
 * it), the proximal path: minimise D(y) + prox |y|^2 / 2 for prox = 0.1, 0.001, ... Either the imbalance vanishes, or -y
 * grows into the mechanism.                                                     [Qi, Sun 1993; Rockafellar 1976] */

#ifdef SP_REAL_FLOAT
#define SP__ENOUGH ((sp_real)0.9)       /* of tol: the search's own omega that will do */
#define SP__MORE ((sp_real)1.1)         /* of tol: the search's own value of a proof that will do */
#else
#define SP__ENOUGH ((sp_real)0.999)
#define SP__MORE ((sp_real)1.001)
#endif
#define SP__FINE ((sp_real)(sizeof(sp_real) == 4 ? 1 : 1e-12))  /* omega from which forces are taken as they come */
#define SP__NEAR 1000                   /* an undecided search that came within so many tol is at the limit, else it gave up */

typedef struct sp__newton {
    sp_real prox;                       /* weight of |y|^2 / 2 */
    sp_real shift;                      /* on the diagonal of the Hessian, beyond prox */
    sp_real omega, best;                /* of the current y, of the best (kept in state->y) */
    sp_real goal;                       /* omega to reach */
    int32_t left;                       /* factorisations */
    int proved;                         /* state->dq holds a proof */
    sp_real level;                      /* imbalance at the end of the last piece of the path */
    int stalled;                        /* it no longer falls with prox: something moves */
    int found;                          /* state->f holds forces that balance */
} sp__newton;

/* Is there work left to spend? */
static int sp__newton_left(const sp__dual *w, const sp__newton *n) { return n->left > 0 && !w->spent; }

static int sp__newton_open(const sp__newton *n) { return n->omega > n->goal && !n->proved && !n->found; }

/* What a search along d works with: slope(s) = d/ds [D(y + s d) + prox |y + s d|^2 / 2] = f(s) . d + yd + s dd. */
typedef struct sp__line { sp_real yd, dd, start, noise; } sp__line;

static sp_real sp__line_enough(const sp__line *l) { return sp__max((sp_real)0.2 * sp__abs(l->start), l->noise); }

/* Step length that brings the slope below a fifth of its start; `f`: the slope at 1, known already. */
SP__APART static sp_real sp__newton_search(sp__dual *w, const sp__line *l, sp_real f)
{
    sp_real lo = 0, flo = l->start, hi = 0, fhi = 0, s = 1;
    for (int it = 0; it < 14; it++) {
        if (it) f = sp__dual_slope(w, w->y, w->d, s) + l->yd + s * l->dd;
        if (sp__abs(f) <= sp__line_enough(l)) return s;
        if (f < 0) { lo = s; flo = f; }
        else { hi = s; fhi = f; }
        if (!(hi > 0)) {
            if (s > 1000) return s;
            s *= 4;
            continue;
        }
        s = lo + (hi - lo) * (-flo / (fhi - flo));
        const sp_real edge = (sp_real)0.1 * (hi - lo);          /* keep off the ends, or one of them never moves */
        if (s < lo + edge) s = lo + edge;
        if (s > hi - edge) s = hi - edge;
    }
    return lo > 0 ? lo : s;
}

/* Work of the load, resistance of the contacts at their caps (counted no further than the work), and what both are compared with,
 * for dq = -y, as the certificate check has them: sum c_v |P_K(u_v)| (with strength: the support function of K_v),
 * sum (sbar |v| + Sbar |w|). */
typedef struct sp__proof { sp_real work, resist, scale; } sp__proof;

/* sp__flat_resist in 6 rows a block. */
SP__APART static sp_real sp__space_resist(const sp__dual *w, int32_t c, const sp_real *y, sp_real most)
{
    const sp_contact *t = &w->pb->contact[c];
    sp_real *V = w->h, *W = w->h + 3, *u = w->h + 6, sum = 0;
    sp__dual_twist(w, t, y, V, W);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real times = sp__dual_counts(w, v);
        if (!(times > 0)) continue;
        sp__dual_rate(w, V, W, w->pb->local[v], u);
        sum += times * sp__cone_support(&w->cone, w->yield, u, most);
    }
    return sum;
}

/* What the vertices of contact c can resist a motion with. */
SP__APART static sp_real sp__newton_resist(const sp__dual *w, int32_t c, const sp_real *y)
{
    const int plain = sp__dual_yield(w, c)->plain;
    const sp_real S = sp__dual_S(w, c), most = w->set->force_bound * sp__lesser(&w->pb->contact[c], w->size, 2) / S;
#ifndef SP_NO_PLAN
    if (w->flat && plain) return sp__flat_resist(w, c, y, most);
#else
    (void)plain;
#endif
    return S * sp__space_resist(w, c, y, most);
}

SP__APART static void sp__newton_weigh(sp__dual *w, const sp_real *y, sp__proof *o)
{
    const sp_problem *pb = w->pb;
    o->work = o->resist = o->scale = 0;
    if (!sp__dual_sweep(w, 1, 1)) return;
    o->work = -sp__dual_work(w, y);
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *yi = y + 6 * (size_t)i, *s = w->size + 2 * (size_t)i, *z = w->weight + 2 * (size_t)i;
        o->scale += s[0] * z[0] * sp__norm3(yi) + s[1] * z[1] * sp__norm3(yi + 3);
    }
    for (int32_t c = 0; c < pb->contacts && o->resist < o->work; c++) o->resist += sp__newton_resist(w, c, y);
}

/* (work - resist) / scale */
static sp_real sp__newton_proof(sp__dual *w, const sp_real *y)
{
    sp__proof o;
    sp__newton_weigh(w, y, &o);
    return o.work > o.resist ? sp__ratio(o.work - o.resist, o.scale) : 0;
}

/* Keep y as the mechanism if it is a proof. */
static void sp__newton_try(sp__dual *w, sp__newton *n, const sp_real *y, sp_state *state)
{
    if (n->proved || sp__newton_proof(w, y) <= SP__MORE * w->set->tol) return;
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) state->dq[k] = -w->weight[k / 3] * y[k];
    n->proved = 1;
}

/* 17 ------------------------------------------------------------------------------------------- exact stage: rigid groups */

/* A mechanism moves blocks together in few groups, but inverse iteration leaves a little play inside them (its
 * square is what the Hessian sees), which a long chain magnifies. So blocks without play are tied to the motion of one of
 * them, the root: x_i = (v + w x (c_i - c_root), w), and conjugate gradients on the tied motions remove what the contacts
 * between groups still resist.                                                             [Hestenes, Stiefel 1952] */

/* up[i + 1]: group of free block i by its lowest number + 1, 0: the ground; joined where no vertex of a contact moves by more
 * than `play` of its blocks' motion. Blocks held in some directions stay with the ground. */
SP__APART static void sp__rigid_groups(const sp__dual *w, const sp_real *x, sp_real play, int32_t *up)
{
    const sp_problem *pb = w->pb;
    for (int32_t i = 0; i <= pb->blocks; i++) up[i] = i;
    for (int32_t i = 0; i < pb->blocks; i++) if (pb->scene->block[pb->block[i]].fixed) sp__join(up, 0, i + 1);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real V[3], W[3], most = 0, size = 0;
#ifndef SP_NO_PLAN
        if (w->flat && w->flat->mate[t->point] < 0) continue;
#endif
        sp__dual_twist(w, t, x, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3];
            sp__dual_rate(w, V, W, pb->local[v], u);
            most = sp__max(most, sp__norm3(u));
        }
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real *m = x + 6 * (size_t)i, *z = w->weight + 2 * (size_t)i;
            size = sp__max(size, z[0] * sp__norm3(m) + z[1] * sp__norm3(m + 3) * sp__norm3(side ? t->rb : t->ra));
        }
        if (most <= play * size) sp__join(up, t->a + 1, t->b + 1);
    }
}

/* The root of i's group and the arm from it; -1: the ground. */
static int32_t sp__rigid_root(const sp__dual *w, int32_t *up, int32_t i, sp_real arm[3])
{
    const sp_problem *pb = w->pb;
    const int32_t g = sp__root(up, i + 1) - 1;
    if (g >= 0) sp__sub3(pb->scene->block[pb->block[i]].centroid, pb->scene->block[pb->block[g]].centroid, arm);
#ifndef SP_NO_PLAN
    if (g >= 0 && w->flat) sp__flat_turn(w->flat, arm, arm);
#endif
    return g;
}

/* Every block's weighted motion from its root's, in place. */
static void sp__rigid_prolong(const sp__dual *w, int32_t *up, sp_real *x)
{
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        sp_real arm[3], m[6], turn[3], *xi = x + 6 * (size_t)i;
        const int32_t g = sp__rigid_root(w, up, i, arm);
        if (g == i) continue;
        if (g < 0) { memset(xi, 0, 6 * sizeof *xi); continue; }
        const sp_real *z = w->weight + 2 * (size_t)i, *s = w->weight + 2 * (size_t)g;
        for (int k = 0; k < 6; k++) m[k] = s[k / 3] * x[6 * (size_t)g + (size_t)k];
        sp__cross3(m + 3, arm, turn);
        for (int k = 0; k < 3; k++) { xi[k] = (m[k] + turn[k]) / z[0]; xi[k + 3] = m[k + 3] / z[1]; }
    }
}

/* Its transpose: every block's weighted row onto its root's, in place; other rows become 0. */
static void sp__rigid_restrict(const sp__dual *w, int32_t *up, sp_real *r)
{
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        sp_real arm[3], f[6], turn[3], *ri = r + 6 * (size_t)i;
        const int32_t g = sp__rigid_root(w, up, i, arm);
        if (g == i) continue;
        const sp_real *z = w->weight + 2 * (size_t)i;
        for (int k = 0; k < 6; k++) { f[k] = ri[k] / z[k / 3]; ri[k] = 0; }
        if (g < 0) continue;
        const sp_real *s = w->weight + 2 * (size_t)g;
        sp_real *rg = r + 6 * (size_t)g;
        sp__cross3(arm, f, turn);
        for (int k = 0; k < 3; k++) { rg[k] += s[0] * f[k]; rg[k + 3] += s[1] * (f[k + 3] + turn[k]); }
    }
}

/* F += g, M += l x g for g = S DP_K(u) du, the rates u and du from two twists V, W; h from 18 on is used up. */
SP__APART static void sp__vertex_apply(const sp__dual *w, int32_t c, int32_t v, sp_real twist[4][3], sp_real F[3], sp_real M[3])
{
    const sp__yield *yield = sp__dual_yield(w, c);
    const sp_real *l = w->pb->local[v], times = sp__dual_counts(w, v);
    sp_real *D = w->h + 18, *u = w->h + 24, *g = w->h + 27, *m = w->h + 30;
    if (!(times > 0)) return;
    sp__dual_rate(w, twist[0], twist[1], l, u);
    if (sp__cone_derivative(&w->cone, yield, u, D) == SP__APEX) return;
    sp__dual_rate(w, twist[2], twist[3], l, u);
    const sp_real S = times * sp__dual_S(w, c), x = S * u[0], y = S * u[1], z = S * u[2];
    g[0] = D[0] * x + D[1] * y + D[2] * z;
    g[1] = D[1] * x + D[3] * y + D[4] * z;
    g[2] = D[2] * x + D[4] * y + D[5] * z;
    sp__cross3(l, g, m);
    for (int k = 0; k < 3; k++) { F[k] += g[k]; M[k] += m[k]; }
}

/* out = Aeq S DP_K(Aeq' y) Aeq' x, weighted. */
SP__APART static void sp__dual_apply(sp__dual *w, const sp_real *y, const sp_real *x, sp_real *out)
{
    const sp_problem *pb = w->pb;
    memset(out, 0, 6 * (size_t)pb->blocks * sizeof *out);
    if (!sp__dual_count(w, 2 * SP__FLOPS_SWEEP, 2 * SP__FLOPS_TWIST)) return;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real (*twist)[3] = (sp_real (*)[3])w->h, *F = w->h + 12, *M = w->h + 15;
        for (int k = 0; k < 3; k++) F[k] = M[k] = 0;
        sp__dual_twist(w, t, y, twist[0], twist[1]);
        sp__dual_twist(w, t, x, twist[2], twist[3]);
        for (int32_t v = t->point; v < t->point + t->points; v++) sp__vertex_apply(w, c, v, twist, F, M);
        sp__dual_scatter(w, t, F, M, out);
    }
    sp__dual_release(w, out);
}

/* Tie the candidate w->d and sharpen it; w->r, L.t and state->dq are used up.     returns 0 when everything is tied down */
SP__APART static int sp__rigid_sharpen(sp__dual *w, int32_t *up, sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real *x = w->d, *r = w->r, *p = state->dq, *q = w->L.t;
    sp__rigid_prolong(w, up, x);
    if (!(sp__dual_norm(w, x) > 0)) return 0;
    sp__dual_apply(w, w->y, x, r);
    sp__rigid_restrict(w, up, r);
    for (size_t k = 0; k < n; k++) p[k] = r[k] = -r[k];
    sp_real rr = sp__dot(r, r, n);
    const sp_real noise = (sp_real)SP_EPSILON * sp__dual_norm(w, x);
    for (int it = 0; it < 40 && rr > noise * noise; it++) {
        sp__rigid_prolong(w, up, p);
        sp__dual_apply(w, w->y, p, q);
        sp__rigid_restrict(w, up, q);
        const sp_real pq = sp__dot(p, q, n);
        if (!(pq > 0)) break;
        const sp_real alpha = rr / pq;
        for (size_t k = 0; k < n; k++) { x[k] += alpha * p[k]; r[k] -= alpha * q[k]; }
        const sp_real next = sp__dot(r, r, n), beta = next / rr;
        for (size_t k = 0; k < n; k++) p[k] = r[k] + beta * p[k];
        rr = next;
    }
    sp__rigid_prolong(w, up, x);
    return 1;
}

/* Rounding closes the joints inside a group by a few units in the last place of its motion, and all that hangs on a joint presses
 * there. So each opens a little, along paths of joints from the supports: v_i += 4 u max |v| sum n. That costs the work of lifting.
 * off: sum n, 3 x blocks.      mark: is it known? */
SP__APART static void sp__rigid_open(sp__dual *w, sp_real *x, sp_real (*off)[3])
{
    const sp_problem *pb = w->pb;
    sp_real most = 0;
    memset(off, 0, (size_t)pb->blocks * sizeof *off);
    memset(w->mark, 0, (size_t)pb->blocks * sizeof *w->mark);
    for (int more = 1, turn = 0; more && sp__dual_pay(w, 6 * (int64_t)pb->contacts); turn = !turn) {
        more = 0;
        for (int32_t k = 0; k < pb->contacts; k++) {
            const sp_contact *t = &pb->contact[turn ? pb->contacts - 1 - k : k];
            const int a = t->a < 0 || w->mark[t->a], b = t->b < 0 || w->mark[t->b];
            if (a == b) continue;
            const int32_t from = a ? t->a : t->b, to = a ? t->b : t->a;
            if (from >= 0) memcpy(off[to], off[from], sizeof *off);
            sp__add3(off[to], a ? 1 : -1, t->joint->n);
            w->mark[to] = more = 1;
        }
    }
    for (int32_t i = 0; i < pb->blocks; i++) most = sp__max(most, w->weight[2 * (size_t)i] * sp__norm3(x + 6 * (size_t)i));
    for (int32_t i = 0; i < pb->blocks; i++) {
#ifndef SP_NO_PLAN
        if (w->flat) sp__flat_turn(w->flat, off[i], off[i]);
#endif
        sp__add3(x + 6 * (size_t)i, -4 * (sp_real)SP_EPSILON * most / w->weight[2 * (size_t)i], off[i]);
    }
    sp__dual_release(w, x);
}

/* 18 -------------------------------------------------------------------------------------------------- exact stage: steps */

/* After a step: imbalance, best so far. */
static void sp__newton_keep(const sp__dual *w, sp__newton *n, sp_state *state)
{
    if (w->spent) return;                               /* w->r is not of this y */
    n->omega = sp__dual_omega(w, w->r);
    if (n->omega < n->best) {
        n->best = n->omega;
        memcpy(state->y, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    }
}

static void sp__newton_look(sp__dual *w, sp__newton *n, sp_state *state)
{
    sp__dual_gradient(w, SP__ADMISSIBLE, w->y, w->r, NULL);
    sp__newton_keep(w, n, state);
}

SP__APART static void sp__line_open(const sp__dual *w, const sp__newton *n, sp__line *l)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    l->yd = n->prox * sp__dot(w->y, w->d, size);
    l->dd = n->prox * sp__dot(w->d, w->d, size);
    l->start = sp__dot(w->r, w->d, size) + l->yd;
    l->noise = 64 * (sp_real)SP_EPSILON * w->load * sp__dual_norm(w, w->d);
}

/* y += s d, the whole step first: its gradient tells the slope there, and mostly that is all. L.t keeps y meanwhile. */
SP__APART static sp_real sp__newton_move(sp__dual *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp__line l;
    sp_real s = 1;
    sp__line_open(w, n, &l);
    memcpy(w->L.t, w->y, size * sizeof *w->y);
    sp__dual_axpy(w, 1, w->d, w->y);
    sp__dual_gradient(w, SP__ADMISSIBLE, w->y, w->r, NULL);
    const sp_real f = sp__dot(w->r, w->d, size) + l.yd + l.dd;
    if (l.start < -l.noise && sp__abs(f) > sp__line_enough(&l)) {
        memcpy(w->y, w->L.t, size * sizeof *w->y);
        s = sp__newton_search(w, &l, f);
        sp__dual_axpy(w, s, w->d, w->y);
        sp__dual_gradient(w, SP__ADMISSIBLE, w->y, w->r, NULL);
    }
    sp__newton_keep(w, n, state);
    return s;
}

/* Nothing resists a mechanism: it is a null vector of the Hessian, and inverse iteration brings it out of x (used up). */
static void sp__newton_purify(sp__dual *w, sp__newton *n, sp_real *x, sp_state *state)
{
    for (int it = 0; it < 2 && !n->proved; it++) {
        sp__dual_solve(w, x, x);
        const sp_real size = sp__dual_norm(w, x);
        if (!(size > 0)) return;
        for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) x[k] /= size;
        sp__newton_try(w, n, x, state);
    }
}

/* The candidate in w->d, tied into rigid groups: opened, else as it is. */
SP__APART static void sp__newton_tie(sp__dual *w, sp__newton *n, sp_real play, sp_state *state)
{
    if (n->proved || !sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) return;
    sp__rigid_groups(w, w->d, play, w->xadj);
    if (sp__rigid_sharpen(w, w->xadj, state)) {
        memcpy(w->r, w->d, 6 * (size_t)w->pb->blocks * sizeof *w->r);
        sp__rigid_open(w, w->d, (sp_real (*)[3])state->dq);
        sp__newton_try(w, n, w->d, state);
        sp__newton_try(w, n, w->r, state);
    }
    sp__dual_gradient(w, SP__ADMISSIBLE, w->y, w->r, NULL);
}

/* One Newton step; returns its length. On the way y, the step and what inverse iteration makes of them are tried as proofs. */
SP__APART static sp_real sp__newton_step(sp__dual *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp__dual_factor(w, SP__ADMISSIBLE, w->y, n->prox + n->shift);
    if (w->spent) return 0;
    n->left--;
    state->cost.iterations++;
    if (n->stalled) {
        memcpy(w->d, w->y, size * sizeof *w->d);
        sp__newton_purify(w, n, w->d, state);
        if (n->prox < SP__TIE) sp__newton_tie(w, n, SP__PLAY, state);
    }
    for (size_t k = 0; k < size; k++) w->d[k] = -w->r[k] - n->prox * w->y[k];
    sp__dual_solve(w, w->d, w->d);
    sp__newton_try(w, n, w->d, state);
    const sp_real s = sp__newton_move(w, n, state);
    if (n->omega > n->goal && !n->proved) {
        sp__newton_try(w, n, w->y, state);
        if (s > 10) sp__newton_purify(w, n, w->d, state);
    }
    return s;
}

/* y += (Aeq S DP Aeq')^-1 (-r), with the factor at hand. */
static void sp__newton_correct(sp__dual *w)
{
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->d[k] = -w->r[k];
    sp__dual_solve(w, w->d, w->d);
    sp__dual_axpy(w, 1, w->d, w->y);
}

/* The goal is reached: a few more steps with the factor at hand while each gains a digit; then omega as forces are judged, and
 * more steps where that asks for them. What is good enough goes to state->f. */
SP__APART static void sp__newton_finish(sp__dual *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    if (n->found || n->proved || n->omega > n->goal) return;
    for (int it = 0; it < 4; it++) {
        const sp_real last = n->omega;
        sp__newton_correct(w);
        sp__newton_look(w, n, state);
        if (n->omega > last / 10) break;
    }
    memcpy(w->y, state->y, size * sizeof *w->y);
    w->bears = w->L.t;
    n->omega = SP__HUGE;
    for (int it = 0; it < 12 && !n->found; it++) {
        const sp_real last = n->omega;
        if (it) sp__newton_correct(w);
        sp__dual_forces(w, SP__ADMISSIBLE, w->y, state);
        if (w->spent) break;
        n->best = n->omega = sp__dual_omega(w, w->r);
        n->found = n->omega <= SP__ENOUGH * w->set->tol;
        if (n->omega > last / 2) break;
    }
    w->bears = NULL;
}

/* After a step of length s, more or less on the diagonal.     returns whether the step was tiny */
SP__APART static int sp__newton_damp(sp__newton *n, sp_real s)
{
    const int tiny = s < (sp_real)0.03;
    if (tiny) n->shift = n->shift * 1000 < 1 ? n->shift * 1000 : 1;
    if (s > (sp_real)0.5) n->shift = sp__max(SP__SHIFT, n->shift / 100);
    return tiny;
}

/* Plain Newton: quadratic unless close to collapse. Gives up after two tiny steps. */
SP__APART static void sp__newton_plain(sp__dual *w, sp__newton *n, sp_state *state)
{
    int tiny = 0;
    n->prox = 0;
    n->stalled = 0;
    n->shift = SP__SHIFT;
    for (int it = 0; it < 12 && sp__newton_left(w, n) && n->omega > n->goal && !n->proved && tiny < 2; it++)
        tiny += sp__newton_damp(n, sp__newton_step(w, n, state));
}

/* On the path y = (mechanism) / prox + (what balances the forces), and the caps magnify the second part. Newton without the
 * load, x <- x - (H + shift)^-1 Aeq S P_K(Aeq' x), a little too far, moves the direction of y to where no contact resists it at
 * all; curved cones want more than the inverse iteration that is enough for hinges. */
SP__APART static void sp__newton_restore(sp__dual *w, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    const sp_real y = sp__dual_norm(w, w->y);
    if (!(y > 0)) return;
    for (size_t k = 0; k < size; k++) w->d[k] = w->y[k] / y;
    for (int it = 0; it < 3 && sp__newton_left(w, n) && !n->proved; it++, n->left--) {
        sp__dual_factor(w, SP__ADMISSIBLE, w->d, SP__SHIFT);
        sp__dual_gradient(w, SP__ADMISSIBLE, w->d, w->r, NULL);
        sp__dual_load(w, w->L.t);
        for (size_t k = 0; k < size; k++) w->r[k] -= w->L.t[k];
        sp__dual_solve(w, w->r, w->r);
        sp__dual_axpy(w, -(sp_real)1.1, w->r, w->d);
        sp__newton_try(w, n, w->d, state);
    }
    if (!n->proved) sp__newton_tie(w, n, SP__PLAY, state);
}

/* Is y near enough to the minimum for this prox?     n->stalled: does the imbalance no longer fall with it? */
SP__APART static int sp__newton_level(sp__dual *w, sp__newton *n)
{
    const sp_real y = n->prox * sp__dual_norm(w, w->y), r = sp__dual_norm(w, w->r);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->d[k] = w->r[k] + n->prox * w->y[k];
    const sp_real inner = sp__dual_norm(w, w->d);
    if (inner > (sp_real)0.3 * y && inner > (sp_real)0.1 * r) return 0;
    n->stalled = r > (sp_real)0.1 * n->level && n->prox < (sp_real)1e-4;
    n->level = r;
    return 1;
}

/* Proximal path from y = 0. */
SP__APART static void sp__newton_path(sp__dual *w, sp__newton *n, sp_state *state)
{
    memset(w->y, 0, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    n->prox = (sp_real)0.1;
    n->shift = 0;
    n->level = SP__HUGE;
    sp__newton_look(w, n, state);
    for (int extra = 8; extra > 0 && sp__newton_left(w, n) && n->omega > n->goal && !n->proved; ) {
        sp__newton_step(w, n, state);
        if (n->prox <= SP__SHIFT) {
            if (extra-- == 8) sp__newton_restore(w, n, state);
            continue;
        }
        if (!sp__newton_level(w, n)) continue;
        if (n->stalled && !n->proved) sp__newton_restore(w, n, state);
        n->prox = n->prox > 100 * SP__SHIFT ? n->prox / 100 : SP__PROX;
        n->stalled |= n->prox <= SP__DEEP;
    }
}

/* A motion that not even bilateral joints resist: the part of the load along null vectors, by inverse iteration. */
static void sp__newton_loose(sp__dual *w, sp__newton *n, sp_state *state)
{
    sp__dual_load(w, w->d);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k++) w->d[k] = -w->d[k];
    sp__newton_purify(w, n, w->d, state);
}

/* A proof is found: sharpen it by the rigid groups it shows, as it is and after inverse iteration with the last factor, and
 * take what the contacts resist least. A block that turns about its edge or its point moves none of its corners, so it counts as
 * tied: where that ties all, every block goes alone. state->y is used up. */
SP__APART static void sp__newton_settle(sp__dual *w, sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    for (size_t k = 0; k < n; k++) state->y[k] = w->d[k] = -state->dq[k] / w->weight[k / 3];
    sp__proof best, now;
    sp__newton_weigh(w, w->d, &best);
    for (int pass = 0; pass < 2 && best.resist > 0; pass++) {
        memcpy(w->d, state->y, n * sizeof *w->d);
        if (pass) sp__dual_solve(w, w->d, w->d);
        if (!sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) break;
        sp__rigid_groups(w, w->d, SP__PLAY, w->xadj);
        if (!sp__rigid_sharpen(w, w->xadj, state)) {
            memcpy(w->d, state->y, n * sizeof *w->d);
            sp__rigid_groups(w, w->d, -1, w->xadj);
            if (!sp__rigid_sharpen(w, w->xadj, state)) continue;
        }
        sp__newton_weigh(w, w->d, &now);
        if (!(now.work > now.resist && now.resist * best.work < best.resist * now.work)) continue;
        best = now;
        memcpy(state->y, w->d, n * sizeof *w->d);
    }
    for (size_t k = 0; k < n; k++) state->dq[k] = -w->weight[k / 3] * state->y[k];
}

/* 19 ----------------------------------------------------------------------------------------- exact stage: interior point */

/* Where Newton stalls, with thousands of joints about to slide or open at once. Forces f = E x of any size (E: sp__ipm_edge):
 *
 *   Aeq E x + tau p = theta r0,  z + E' Aeq' y = theta e,  kappa + p.y = k theta,  x o z = mu e,  tau kappa = k mu,
 *
 * x, z in cones, from x = z = e, y = 0, tau = theta = mu = 1, kappa = k down to theta = mu = 0: the homogeneous self-dual
 * embedding of "is there an f". Then f = E x / tau balances p, or no contact resists dq = -y while the load does work kappa: of
 * all such motions the centre, with k / (k + number of cones) of the most work there is; so k is not 1, and late, where little
 * work has to do for a proof, more than there are cones. A step factorises
 * Aeq E W^2 E' Aeq', the same blocks as Newton's; z is never stored. Mostly it ends long before that: when the least change of
 * x, in the metric of W, that balances p is admissible, or the least change of y after which nothing resists is a proof.
 *                                  [Ye, Todd, Mizuno 1994; Nesterov, Todd 1997; Mehrotra 1992; Andersen, Roos, Terlaky 2003] */

#ifndef SP_NO_IPM

/* One cone, E' Aeq' of y, predictor and step in u: dz = -(1 - sigma) theta e - u[2], dx = h - W^2 dz, h from solvers/ipm.c.
 * AIM, with no step yet: g = -(1 - sigma) x - dx, what Aeq E of the step has to make up for. */
SP__APART static void sp__ipm_cone(sp__ipm *m, sp_real *x, sp_real u[3][3], sp_real g[3], sp_real t[9])
{
    sp__nt W;
    const sp_real keep = 1 - m->sigma;
    sp_real *h = t, *z = t + 3, *dz = t + 6;
    sp__scale3(-1, u[0], z);
    z[0] += m->theta;
    if (!sp__soc_scaling(x, z, &W)) { m->outside = 1; return; }
    for (int k = 0; k < 3; k++) h[k] = -x[k];
    if (m->corrected) {
        for (int k = 0; k < 3; k++) h[k] = u[1][k];
        h[0] += m->theta;
        sp__scale3(-1, h, dz);
        sp__soc_square(&W, h);
        sp__sub3(h, x, h);
        sp__soc_aim(&W, x, z, h, dz, m->sigma * m->mu, h);
    }
    for (int k = 0; k < 3; k++) g[k] = m->pass == SP__AIM ? 0 : u[2][k];
    g[0] += keep * m->theta;
    sp__scale3(-1, g, dz);
    sp__soc_square(&W, g);
    for (int k = 0; k < 3; k++) g[k] += h[k];                               /* dx */
    if (m->pass == SP__REACH) m->reach = sp__soc_step(z, dz, sp__soc_step(x, g, m->reach));
    for (int k = 0; k < 3; k++) {
        if (m->pass == SP__MOVE) x[k] += m->reach * g[k];
        g[k] = -(keep * x[k] + g[k]);
    }
}

/* The same for one edge of a pyramid, where W^2 = x / z. */
static sp_real sp__ipm_ray(sp__ipm *m, sp_real *x, const sp_real u[3])
{
    const sp_real keep = 1 - m->sigma, z = m->theta - u[0], s = *x / z;
    sp_real h = -*x;
    if (m->corrected) {
        const sp_real dz = -m->theta - u[1], dx = -*x - s * dz;
        h += (m->sigma * m->mu - dx * dz) / z;
    }
    const sp_real dz = -keep * m->theta - (m->pass == SP__AIM ? 0 : u[2]), dx = h - s * dz;
    if (m->pass == SP__REACH) m->reach = sp__ray_step(z, dz, sp__ray_step(*x, dx, m->reach));
    if (m->pass == SP__MOVE) *x += m->reach * dx;
    return -(keep * *x + dx);
}

/* The edges of a vertex's pyramid. */
SP__APART static void sp__ipm_rays(const sp__dual *w, sp__ipm *m, int32_t c, int32_t v, sp_real u[3][3], sp_real g[3])
{
    sp_real *x = m->x + (size_t)w->cone.faces * (size_t)v, *e = w->h + 42, *rate = w->h + 45;
    for (int32_t k = 0; k < w->cone.faces; k++) {
        sp__ipm_edge(w, c, k, e);
        for (int q = 0; q < 3; q++) rate[q] = sp__dot3(e, u[q]);
        const sp_real a = sp__ipm_ray(m, x + k, rate);
        for (int q = 0; q < 3; q++) g[q] += a * e[q];
    }
}

/* One vertex: its cone or the edges of its pyramid. g is a force. */
SP__APART static void sp__ipm_vertex(const sp__dual *w, sp__ipm *m, int32_t c, int32_t v, sp_real u[3][3], sp_real g[3])
{
    g[0] = g[1] = g[2] = 0;
    if (w->cone.faces) { sp__ipm_rays(w, m, c, v, u, g); return; }
    const sp_real S = m->natural * sp__dual_S(w, c), T = S * sp__dual_mu(w, c);
    for (int k = 0; k < 3; k++) { u[k][0] *= S; u[k][1] *= T; u[k][2] *= T; }
    sp__ipm_cone(m, m->x + 3 * (size_t)v, u, g, w->h + 42);
    g[0] *= S; g[1] *= T; g[2] *= T;
}

/* One pass over all vertices. AIM: r = Aeq g, the right-hand side but for -(1 - sigma) tau p; it has no step yet, and what is not
 * corrected no predictor: those rates are 0. */
SP__APART static void sp__ipm_sweep(sp__dual *w, sp__ipm *m, sp__pass pass, sp_real *r)
{
    const sp_problem *pb = w->pb;
    const int counts[3] = { 1, m->corrected, pass != SP__AIM }, rates = 1 + counts[1] + counts[2];
    m->pass = pass;
    if (!sp__dual_count(w, rates * SP__FLOPS_SWEEP, rates * SP__FLOPS_TWIST)) return;
    if (pass == SP__AIM) memset(r, 0, 6 * (size_t)pb->blocks * sizeof *r);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sp_real *twist = w->h, *g = w->h + 27, *a = w->h + 30, *F = w->h + 33, *M = w->h + 36;
        sp_real (*u)[3] = (sp_real (*)[3])(w->h + 18);
        for (int k = 0; k < 3; k++) {
            F[k] = M[k] = u[k][0] = u[k][1] = u[k][2] = 0;
            if (counts[k]) sp__dual_twist(w, t, m->along[k], twist + 6 * k, twist + 6 * k + 3);
        }
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            if (!(sp__dual_counts(w, v) > 0)) continue;
            for (int k = 0; k < 3; k++)
                if (counts[k]) sp__dual_rate(w, twist + 6 * k, twist + 6 * k + 3, pb->local[v], u[k]);
            sp__ipm_vertex(w, m, c, v, u, g);
            sp__scale3(sp__dual_counts(w, v), g, g);
            sp__cross3(pb->local[v], g, a);
            for (int k = 0; k < 3; k++) { F[k] += g[k]; M[k] += a[k]; }
        }
        if (pass == SP__AIM) sp__dual_scatter(w, t, F, M, r);
    }
    if (pass == SP__AIM) sp__dual_release(w, r);
}

/* g = P_K(f - D u); g may be f. */
static void sp__ipm_change(const sp__dual *w, const sp__yield *yield, const sp_real D[6], const sp_real u[3], const sp_real f[3],
                           sp_real g[3])
{
    const sp_real a = f[0] - (D[0] * u[0] + D[1] * u[1] + D[2] * u[2]), b = f[1] - (D[1] * u[0] + D[3] * u[1] + D[4] * u[2]);
    g[2] = f[2] - (D[2] * u[0] + D[4] * u[1] + D[5] * u[2]);
    g[0] = a; g[1] = b;
    sp__cone_project(&w->cone, yield, g, g);
}

/* Forces of the live loads alone: is this a vertex that only others press, W^2 < 1, so x -> 0? What x is left there would have
 * to balance stones that nothing else holds. */
static int sp__ipm_idle(const sp__dual *w, const sp__ipm *m, int32_t c, const sp_real D[6])
{
    const sp_real S = m->natural * sp__dual_S(w, c);
    return m->ray && D[0] < S * S;
}

/* f <- P_K(f - D Aeq' d), D = E W^2 E', in units; before the first change of f it is P_K(E x / tau). m NULL: D = S DP_K and
 * f = S P_K of Newton's y: a y of a thousand times the forces' size has lost their last digits. Then r = Aeq g + p of
 * g = P_K(f - D Aeq' e). Changes add up in f, not in d: a large d, most of it a motion that hardly anything resists, would
 * hide small ones. */
SP__APART static void sp__ipm_balance(sp__dual *w, const sp__ipm *m, int first, const sp_real *d, const sp_real *e, sp_state *state)
{
    const sp_problem *pb = w->pb;
    if (!sp__dual_count(w, 4 * SP__FLOPS_SWEEP, 3 * SP__FLOPS_TWIST)) return;
    sp__dual_load(w, w->r);
    memset(w->bears, 0, 3 * (size_t)pb->blocks * sizeof *w->bears);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        const sp__yield *yield = sp__dual_yield(w, c);
        sp_real *twist = w->h, *u = w->h + 18, *D = w->h + 21, *g = w->h + 27, *F = w->h + 30, *M = w->h + 33;
        sp__dual_twist(w, t, w->y, twist, twist + 3);
        sp__dual_twist(w, t, d, twist + 6, twist + 9);
        sp__dual_twist(w, t, e, twist + 12, twist + 15);
        for (int k = 0; k < 3; k++) F[k] = M[k] = 0;
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real *f = state->f + 3 * (size_t)v;
            const sp_real times = sp__dual_counts(w, v);
            if (!(times > 0)) continue;
            sp__dual_rate(w, twist, twist + 3, pb->local[v], u);
            if (m) sp__ipm_derivative(w, c, v, u, D, g);
            else {
                sp__dual_force(w, c, yield, u, g);
                if (!sp__vertex_law(w, SP__ADMISSIBLE, c, v, twist, u, D)) memset(D, 0, 6 * sizeof *D);
            }
            if (m && sp__ipm_idle(w, m, c, D)) { memset(f, 0, 3 * sizeof *f); continue; }
            if (first) sp__scale3(m ? 1 / m->tau : 1, g, f);
            sp__dual_rate(w, twist + 6, twist + 9, pb->local[v], u);
            sp__ipm_change(w, yield, D, u, f, f);
            sp__dual_rate(w, twist + 12, twist + 15, pb->local[v], u);
            sp__ipm_change(w, yield, D, u, f, g);
            sp__scale3(times, g, g);
            sp__cross3(pb->local[v], g, u);
            for (int k = 0; k < 3; k++) { F[k] += g[k]; M[k] += u[k]; }
            sp__dual_bear(w, t, pb->local[v], g);
        }
        sp__dual_scatter(w, t, F, M, w->r);
    }
    sp__dual_release(w, w->r);
}

/* Does the least change of x (m NULL: of Newton's forces) that balances leave the forces admissible? What is not is projected
 * and the rest balanced again while that gains. Then state->f holds them. */
SP__APART static void sp__ipm_forces(sp__dual *w, const sp__ipm *m, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp_real last = SP__HUGE, strict = SP__HUGE;
    int more = 8;                                       /* once balanced: lightly loaded blocks come to rest last */
    memset(state->dq, 0, size * sizeof *w->d);
    memset(w->d, 0, size * sizeof *w->d);
    for (int it = 0; ; it++) {                          /* ends with state->f as good as it was found */
        w->bears = w->L.t;
        sp__ipm_balance(w, m, it == 0, state->dq, w->d, state);
        const sp_real now = sp__dual_omega(w, w->r);
        w->bears = NULL;
        if (w->spent) return;
        n->omega = sp__dual_omega(w, w->r);
        const int slow = n->omega > SP__GAIN * last && now > SP__GAIN * strict;
        if (it == 60 || (slow && (last > n->goal || now >= strict || !more--))) break;
        last = n->omega;
        strict = now;
        memcpy(state->dq, w->d, size * sizeof *w->d);
        sp__dual_solve(w, w->r, w->d);
    }
    n->omega = strict;
    if (strict > SP__ENOUGH * w->set->tol) return;
    for (size_t k = 0; k < 3 * (size_t)w->pb->points; k++) state->f[k] *= w->unit;
    n->best = strict;
    n->found = 1;
}

/* Changes of tau and kappa, from the step w->r of y that leaves tau alone and state->dq = dy / dtau. */
static void sp__ipm_homogeneous(const sp__dual *w, sp__ipm *m, const sp_state *state, sp_real product)
{
    const sp_real rest = m->kappa + sp__dual_work(w, w->y), keep = 1 - m->sigma;
    const sp_real c = m->tau * m->kappa + product - m->sigma * m->stake * m->mu;
    m->dtau = (c / m->tau - keep * rest - sp__dual_work(w, w->r)) / (sp__dual_work(w, state->dq) - m->kappa / m->tau);
    m->dkappa = -(c + m->kappa * m->dtau) / m->tau;
}

/* Longest step along m->along[2] that stays inside. */
static void sp__ipm_reach(sp__dual *w, sp__ipm *m)
{
    m->reach = 1000;
    sp__ipm_sweep(w, m, SP__REACH, NULL);
    m->reach = sp__ray_step(m->kappa, m->dkappa, sp__ray_step(m->tau, m->dtau, m->reach));
}

/* state->dq = dy / dtau; w->d = the least change of y in the metric of W after which no contact resists. With so much of dy / dtau
 * that the load's work is kappa it is tried as a proof. */
SP__APART static void sp__ipm_motion(sp__dual *w, sp__ipm *m, sp__newton *n, sp_state *state)
{
    const size_t size = 6 * (size_t)w->pb->blocks;
    sp__dual_load(w, state->dq);
    for (size_t k = 0; k < size; k++) state->dq[k] = -state->dq[k];
    sp__dual_solve(w, state->dq, state->dq);
    m->corrected = 0;
    m->sigma = 0;
    sp__ipm_sweep(w, m, SP__AIM, w->d);
    sp__dual_solve(w, w->d, w->d);
    const sp_real pulls = -sp__dual_work(w, state->dq);
    if (!(pulls > 0)) return;
    const sp_real share = (m->kappa + sp__dual_work(w, w->y) + sp__dual_work(w, w->d)) / pulls;
    for (size_t k = 0; k < size; k++) w->r[k] = w->y[k] + w->d[k] + share * state->dq[k];
    sp__newton_try(w, n, w->r, state);
}

/* Predictor and corrector with the factor at hand, from what sp__ipm_motion left in w->d and state->dq. */
SP__APART static void sp__ipm_step(sp__dual *w, sp__ipm *m, const sp_state *state)
{
    const size_t n = 6 * (size_t)w->pb->blocks;
    for (size_t k = 0; k < n; k++) w->r[k] = w->d[k] + m->tau * state->dq[k];
    sp__ipm_homogeneous(w, m, state, 0);
    sp__dual_axpy(w, m->tau + m->dtau, state->dq, w->d);
    m->along[1] = m->along[2] = w->d;
    sp__ipm_reach(w, m);
    const sp_real left = 1 - (m->reach < 1 ? m->reach : 1), product = m->dtau * m->dkappa;
    m->corrected = 1;
    m->sigma = left * left * left;
    sp__ipm_sweep(w, m, SP__AIM, w->r);
    sp__dual_solve(w, w->r, w->r);
    sp__dual_axpy(w, (1 - m->sigma) * m->tau, state->dq, w->r);
    sp__ipm_homogeneous(w, m, state, product);
    sp__dual_axpy(w, m->dtau, state->dq, w->r);
    m->along[2] = w->r;
    sp__ipm_reach(w, m);
    m->reach *= SP__IPM_KEEP;
    if (m->reach > 1) m->reach = 1;
    sp__ipm_sweep(w, m, SP__MOVE, NULL);
    sp__dual_axpy(w, m->reach, w->r, w->y);
    m->tau += m->reach * m->dtau;
    m->kappa += m->reach * m->dkappa;
    m->theta *= 1 - m->reach * (1 - m->sigma);
}

/* x = z = e, y = 0. The natural force is a quarter of what an average block bears. */
static void sp__ipm_start(sp__dual *w, sp__ipm *m)
{
    const int32_t faces = w->cone.faces;
    memset(w->y, 0, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    for (size_t k = 0; k < (size_t)(faces ? faces : 3) * (size_t)w->pb->points; k++) m->x[k] = faces || k % 3 == 0;
    m->natural = 0;
    for (int32_t i = 0; i < w->pb->blocks; i++) m->natural += w->size[2 * (size_t)i] / (4 * (sp_real)w->pb->blocks);
    if (w->metric > 0) m->natural = 1 / (4 * w->metric);
    m->theta = m->tau = 1;
    m->kappa = m->stake;
    m->ray = 0;
    m->along[0] = m->along[1] = m->along[2] = w->y;
    w->inner = m;
}

/* Leaves forces that balance (n->found), a proof (n->proved) or neither. m->x: 3 a vertex, faces of them for a pyramid.
 *   returns 1 where SP__IPM_IDLE steps one after the other got nowhere and no other way does: factors have too few digits */
SP__APART static int sp__ipm_run(sp__dual *w, sp__ipm *m, sp__newton *n, sp_state *state)
{
    const sp_real cones = (sp_real)w->pb->points * (sp_real)(w->cone.faces ? w->cone.faces : 1);
    int idle = 0;
    m->stake = sp__max(1, cones / 10);
    sp__ipm_start(w, m);
    for (int it = 0; it < SP__IPM_MOST && idle < SP__IPM_IDLE && sp__newton_left(w, n) && m->theta > (sp_real)SP_EPSILON; it++) {
        m->gap = 0;
        m->outside = 0;
        if (m->theta < SP__IPM_LATE) m->stake = 3 * cones;
        sp__dual_factor(w, SP__INTERIOR, w->y, SP__IPM_SHIFT);
        if (w->spent) break;
        n->left--;
        state->cost.iterations++;
        state->cost.interior++;
        if (m->outside) break;
        m->mu = (m->gap + m->tau * m->kappa) / (cones + m->stake);
        sp__ipm_forces(w, m, n, state);
        if (n->found) return 0;
        sp__newton_try(w, n, w->y, state);
        if (!n->proved) sp__ipm_motion(w, m, n, state);
        if (n->proved || w->spent) return 0;
        sp__ipm_step(w, m, state);
        idle = m->reach < SP__IPM_NOWHERE ? idle + 1 : 0;
    }
    sp__newton_look(w, n, state);
    if (idle == SP__IPM_IDLE) {                         /* y still shows what goes together, roughly */
        memcpy(w->d, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->d);
        sp__newton_tie(w, n, SP__PLAY_IDLE, state);
    }
    return idle == SP__IPM_IDLE && SP__IPM_LAST;
}
#endif

/* 20 ----------------------------------------------------------------------------------------------------- exact stage: its run */

static size_t sp__exact_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
#ifdef SP_NO_IPM
    return sp__flat_need(pb, set, 0, scratch);
#else
    return sp__flat_need(pb, set, (size_t)set->faces, scratch);
#endif
}

#ifndef SP_NO_PLAN
/* Do no joints part or slip under the bilateral force: is it P_K of itself, nearly? Then it is the answer.     f <- it
 * A light block beside a heavy one has digits of its own: what is much for its load is looked at with the forces on it. */
SP__APART static int sp__newton_bonded(sp__dual *w, sp_state *state)
{
    const sp_real little = sp__max(w->set->tol / 1000, 64 * (sp_real)SP_EPSILON);
    int each = 1;
    sp__dual_forces(w, SP__ADMISSIBLE, w->y, state);
    if (w->spent || sp__dual_norm(w, w->r) > little * w->load) return 0;
    sp__dual_load(w, w->L.t);
    for (size_t k = 0; k < 6 * (size_t)w->pb->blocks; k += 6)
        each &= SP_SQRT(sp__dot(w->r + k, w->r + k, 6)) <= little * SP_SQRT(sp__dot(w->L.t + k, w->L.t + k, 6));
    if (!each) sp__dual_sizes(w, w->y);
    return each || (!w->spent && sp__dual_omega(w, w->r) <= little);
}
#endif

/* The ways to an answer, until one of them ends the search: Newton, interior points, the proximal path, forces.
 * looked: w->r is of w->y already. */
static void sp__exact_ways(sp__dual *w, sp__newton *n, int looked, sp_state *state)
{
    const int whole = sp__dual_whole(w);
    int idle = 0;                                       /* too long for these factors: no other way gets there, either */
    if (w->singular) sp__newton_loose(w, n, state);
    if (sp__dual_metric(w)) { sp__dual_bilateral(w); looked = 0; }
    if (whole) sp__newton_try(w, n, w->y, state);
    if (looked) sp__newton_keep(w, n, state);
    else sp__newton_look(w, n, state);
    if (whole) sp__newton_plain(w, n, state);
    sp__newton_finish(w, n, state);
#ifndef SP_NO_IPM
    const int cones = !sp__problem_strong(w->pb);              /* with strength K is none */
    const int coarse = n->found && n->best > SP__FINE;  /* within tol, but not to rounding */
    if (sp__newton_open(n) && whole && cones) idle = sp__ipm_run(w, w->inner, n, state);
#endif
    if (sp__newton_open(n) && whole && !idle) {
        sp__newton_path(w, n, state);
        sp__newton_plain(w, n, state);                 /* from there, without what |y|^2 pulls */
        sp__newton_finish(w, n, state);
    }
#ifndef SP_NO_IPM
    if ((coarse || (sp__newton_open(n) && whole && !idle)) && cones && sp__newton_left(w, n)) {   /* as near as y goes; on in forces */
        const size_t bytes = 6 * (size_t)w->pb->blocks * sizeof *w->y;
        if (coarse) memcpy(state->y, w->y, bytes);      /* the y at hand found them; else the nearest that was kept */
        else memcpy(w->y, state->y, bytes);
        sp__dual_factor(w, SP__ADMISSIBLE, w->y, SP__SHIFT);
        n->left--;
        n->found = 0;                                   /* then they are still those of y */
        sp__ipm_forces(w, NULL, n, state);
    }
#endif
}

/* flat (may be NULL): in 3 rows a block; its forces and motions are those of all 6. Without friction where that may be called for
 * the least force is all that is tried: it says what stands, and where it does not little is lost. */
SP__APART static sp_status sp__exact_search(const sp_problem *pb, const sp_settings *set, sp__flat *flat, sp_state *state,
                                            sp_arena *arena, sp_verdict *claim)
{
    sp__newton n = { 0, 0, 0, SP__HUGE, set->tol / 4, set->iterations, 0, 0, 0, 0 };
    sp__dual *w = sp__dual_make(pb, set, SP__EXACT, flat, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
#ifndef SP_NO_IPM
    w->inner->x = set->faces ? sp__take(arena, (size_t)pb->points, (size_t)set->faces * sizeof *w->x) : w->x;
    if (!w->inner->x) return SP_E_MEMORY;
#endif
    const int whole = sp__dual_whole(w);
    const int64_t tail = (int64_t)SP__FLOPS_SWEEP * pb->points + (int64_t)SP__FLOPS_TWIST * pb->contacts;   /* of the forces */
    w->limit = state->left - tail;
    state->reason = SP_REASON_BUDGET;
    if (flat) flat->spent = 1;
    sp__dual_bilateral(w);
    if (w->spent) return SP_OK;
    if (flat) flat->spent = 0;
    sp__dual_hint(w, state);
    int looked = 0;                                     /* w->r is of this y */
#ifndef SP_NO_PLAN
    looked = flat && !w->singular;
    if (looked && sp__newton_bonded(w, state)) {
        sp__flat_spread(flat, pb, state->f);
        *claim = SP_STABLE;
        return SP_OK;
    }
#endif
    sp__dual_sizes(w, w->y);
    if (!whole && w->singular) return SP_OK;
    sp__exact_ways(w, &n, looked, state);
    const int spent = w->spent;
    w->limit = state->left;
    w->spent = 0;
    if (!n.found && n.best < SP__HUGE) sp__dual_forces(w, SP__ADMISSIBLE, state->y, state);
    w->spent = spent;
    if (n.proved && set->localise) sp__newton_settle(w, state);
    for (size_t k = 0; k < 6 * (size_t)pb->blocks && !n.proved; k++)
        state->dq[k] = -w->weight[k / 3] * (spent ? state->y[k] : w->y[k]);
#ifndef SP_NO_PLAN
    if (flat) {
        sp__flat_lift(w, state->dq);
        sp__flat_spread(flat, pb, state->f);
        flat->spent = spent;
    }
#endif
    *claim = n.proved ? SP_UNSTABLE : n.best <= set->tol ? SP_STABLE : SP_UNDECIDED;
    state->reason = n.proved ? SP_REASON_MECHANISM : n.best <= set->tol ? SP_REASON_FORCES
                  : n.left > 0 && !spent && n.best <= SP__NEAR * set->tol ? SP_REASON_LIMIT : SP_REASON_BUDGET;
    return SP_OK;
}

static sp_status sp__exact_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    return sp__exact_search(pb, set, NULL, state, arena, claim);
}

/* 21 -------------------------------------------------------------------------------------------------------- penalty form */

/* min 1/2 sum (fp^2 + gamma fm^2 + tau |ft|^2), Aeq f + p = 0, |ft| <= mu fp: tension at a price, so it always has a solution
 * and shows where help is wanted. It does not decide: a finite gamma buys a little tension even where none is needed.
 *                                                                                            [seed 1.5; Kao 2022, Eq. 14] */

SP__APART static void sp__penalty_demand(sp__dual *w, sp_demand *demand)
{
    if (!sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST)) return;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_contact *t = &w->pb->contact[c];
        const sp__yield *yield = sp__dual_yield(w, c);
        const sp__strength k = sp__vertex_strength(t->joint, 0);
        sp_demand *o = &demand[t->id];
        sp_real V[3], W[3];
        sp__dual_twist(w, t, w->y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real u[3], f[3];
            if (!(sp__dual_counts(w, v) > 0)) continue;
            sp__dual_rate(w, V, W, w->pb->local[v], u);
            sp__dual_force(w, c, yield, u, f);
            const sp_real held = k.C + t->joint->joint.mu * sp__max(-k.T, f[0] * w->unit);
            o->tension = sp__max(o->tension, -f[0] * w->unit - k.T);
            o->friction = sp__max(o->friction, SP_SQRT(f[1] * f[1] + f[2] * f[2]) * w->unit - held);
        }
    }
}

SP__APART static sp_status sp__penalty_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena,
                                           sp_demand *demand)
{
    sp__newton n = { 0, 0, 0, SP__HUGE, sp__max(set->tol, 16 * SP__SCALE_TOL), 40, 1, 0, 0, 0 };   /* proved: no proofs are sought */
    sp__dual *w = NULL;
#ifndef SP_NO_PLAN
    const size_t start = arena->used;
    sp__flat *flat = sp__take(arena, 1, sizeof *flat);
    if (!flat) return SP_E_MEMORY;
    if (sp__flat_choose(pb, set, flat)) {
        w = sp__dual_make(pb, set, SP__PENALTY, flat, &state->cost, arena);
        if (!w) return SP_E_MEMORY;
    }
    if (!w || !sp__dual_whole(w)) { arena->used = start; w = NULL; }       /* level, but friction may help */
#endif
    if (!w) w = sp__dual_open(pb, set, SP__PENALTY, &state->cost, arena);
    if (!w) return SP_E_MEMORY;
    w->limit = state->left;
    sp__dual_bilateral(w);
    if (w->spent) return SP_OK;
    sp__dual_sizes(w, w->y);
    if (sp__dual_metric(w)) sp__dual_bilateral(w);
    sp__newton_look(w, &n, state);
    n.shift = SP__SHIFT;
    while (sp__newton_left(w, &n) && n.omega > n.goal) sp__newton_step(w, &n, state);
    if (n.omega <= n.goal) sp__penalty_demand(w, demand);   /* else not even tension helps: no friction, a loose stone */
    return SP_OK;
}

/* 22 ----------------------------------------------------------------------------------------------------- penalty program */

/* The penalty form as the seed has it, a quadratic program of 4 columns a vertex, x = (fp, fm, ft1, ft2), K friction rows:
 *
 *     min 1/2 sum (fp^2 + gamma fm^2 + tau |ft|^2)        Aeq x = -p,   Afr x <= 0,   fp, fm >= 0       [seed 1.5, 4.2]
 *
 * Forces are counted in the largest load, moments in forces at the block's longest arm, so residuals don't depend on units.
 * Its forces fp - fm, ft are put into the cones and judged; the multipliers of Aeq are a motion: dq of a certificate that there
 * are no forces. Where the true cone is asked for the seed's pyramid takes its place, whose forces the true cone admits.  */
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)

typedef struct sp__program_arrays {
    int32_t *Pp, *Ap, *Ai;              /* Pp: 0, 1, ...: column starts and rows of the diagonal P */
    sp_real *Px, *Ax, *l, *u, *x;       /* x: first guess */
    sp_real *arm;                       /* b: 1 / longest arm */
} sp__program_arrays;

typedef struct sp__program {
    sp_qp qp;
    sp_qp_settings set;
    sp_qp_solver solver;
    sp_qp_result r;
    sp__friction friction;
    sp__program_arrays at;
    sp_real unit;                       /* of force [N] */
} sp__program;

static void sp__program_carve(sp__program_arrays *at, const sp_qp *qp, int32_t blocks, int32_t entries, sp_arena *a)
{
    const size_t n = (size_t)qp->n, m = (size_t)qp->m;
    at->Pp = sp__take(a, n + 1, sizeof *at->Pp);
    at->Px = sp__take(a, n, sizeof *at->Px);
    at->Ap = sp__take(a, n + 1, sizeof *at->Ap);
    at->Ai = sp__take(a, (size_t)entries, sizeof *at->Ai);
    at->Ax = sp__take(a, (size_t)entries, sizeof *at->Ax);
    at->l = sp__take(a, m, sizeof *at->l);
    at->u = sp__take(a, m, sizeof *at->u);
    at->x = sp__take(a, n, sizeof *at->x);
    at->arm = sp__take(a, (size_t)blocks, sizeof *at->arm);
}

static const sp_seed *sp__seed_of(const sp_settings *set) { return set->seed ? set->seed : &sp__seed; }

/* n and m, and the most entries A can have: 12 of Aeq and K of Afr a column, 2 signs a vertex.     returns -1: too large */
static int32_t sp__program_size(const sp_problem *pb, const sp_settings *set, sp_qp *qp)
{
    const int32_t faces = set->faces ? set->faces : sp__seed_of(set)->faces;
    memset(qp, 0, sizeof *qp);
    if (pb->blocks > INT32_MAX / 24 || pb->points > INT32_MAX / (16 * (faces + 13))) return -1;
    qp->n = 4 * pb->points;
    qp->m = 6 * pb->blocks + (faces + 2) * pb->points;
    return pb->points * (4 * (12 + faces) + 2);
}

/* Dense or without a matrix, as the seed has it; else what the settings say.                                  [seed 1.5] */
static sp_qp_backend sp__program_backend(const sp_problem *pb, const sp_settings *set, const sp_qp *qp)
{
    const sp_seed *seed = sp__seed_of(set);
    if (set->qp_solver) return seed->native.backend;
    if (!set->seed || seed->dense_cells <= 0) return seed->admm.backend;
    const int64_t n = qp->n, cells = n * (n + qp->m - 2 * pb->points);
    if (cells <= seed->dense_cells) return SP_QP_DENSE;
#ifdef SP_QP_NO_CG
    return SP_QP_SPARSE;
#else
    return SP_QP_CG;
#endif
}

/* Without the preset the accuracy is that of the check, and the active rows are solved for exactly. */
static void sp__program_tighten(sp_qp_settings *s, sp_real tol)
{
    const sp_real eps = sp__max(tol / 4, 1000 * (sp_real)SP_EPSILON);
    if (eps < s->eps_abs) s->eps_abs = eps;
    if (eps < s->eps_rel) s->eps_rel = eps;
#ifndef SP_QP_NO_POLISH
    s->polish = 1;
#endif
}

/* Sizes, pyramid and who solves it.     returns 0: too large */
static int sp__program_open(sp__program *g, const sp_problem *pb, const sp_settings *set)
{
    const sp_seed *seed = sp__seed_of(set);
    if (sp__program_size(pb, set, &g->qp) < 0) return 0;
    sp__friction_open(&g->friction, set->faces ? set->faces : seed->faces, set->faces ? set->inscribed : seed->inscribed, set->net,
                      6 * pb->blocks);
    g->set = set->qp_solver ? seed->native : seed->admm;
    g->set.backend = sp__program_backend(pb, set, &g->qp);
    if (!set->seed) sp__program_tighten(&g->set, set->tol);
    if (set->qp_solver) g->solver = *set->qp_solver;
    else g->solver = sp_qp_admm();
    return 1;
}

/* A by columns: rows of Aeq, of Afr, and 1 in a row of its own where the unknown has a sign. Ap NULL: entries are only counted. */
static void sp__program_columns(const sp__program *g, const sp_problem *pb, sp_triplets *t, int32_t *Ap)
{
    t->count = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *contact = &pb->contact[c];
        for (int32_t q = 0; q < 4 * contact->points; q++) {
            const int32_t v = contact->point + q / 4;
            sp__aeq_vertex(t, pb, contact, v, 4, q % 4);
            sp__afr_vertex(t, &g->friction, contact, v, 4, q % 4);
            if (q % 4 < 2) sp__triplets_put(t, 6 * pb->blocks + g->friction.faces * pb->points + 2 * v + q % 4, 4 * v + q % 4, 1);
            if (Ap) Ap[4 * v + q % 4 + 1] = t->count;
        }
    }
}

/* P and A; moments about a centroid are divided by its longest arm. */
SP__APART static void sp__program_matrices(sp__program *g, const sp_problem *pb, const sp_settings *set)
{
    const int32_t n = g->qp.n;
    sp_triplets t = { g->qp.m, n, 0, g->at.Ai, NULL, g->at.Ax };
    memset(g->at.Ap, 0, ((size_t)n + 1) * sizeof *g->at.Ap);
    sp__program_columns(g, pb, &t, g->at.Ap);
    for (int32_t i = 0; i < pb->blocks; i++) g->at.arm[i] = 0;
    for (int32_t k = 0; k < t.count; k++) {
        const int32_t row = g->at.Ai[k], i = row / 6;
        if (row < 6 * pb->blocks && row % 6 > 2) g->at.arm[i] = sp__max(g->at.arm[i], sp__abs(g->at.Ax[k]));
    }
    for (int32_t i = 0; i < pb->blocks; i++) g->at.arm[i] = g->at.arm[i] > 0 ? 1 / g->at.arm[i] : 1;
    for (int32_t k = 0; k < t.count; k++)
        if (g->at.Ai[k] < 6 * pb->blocks && g->at.Ai[k] % 6 > 2) g->at.Ax[k] *= g->at.arm[g->at.Ai[k] / 6];
    for (int32_t j = 0; j < n; j++) {
        if (g->at.Ap[j + 1] < g->at.Ap[j]) g->at.Ap[j + 1] = g->at.Ap[j];           /* a vertex between supports has no entries */
        g->at.Pp[j] = j;
        g->at.Px[j] = j % 4 == 0 ? 1 : j % 4 == 1 ? set->gamma : set->tau;
    }
    g->at.Pp[n] = n;
    g->qp.Pp = g->qp.Pi = g->at.Pp;
    g->qp.Px = g->at.Px;
    g->qp.Ap = g->at.Ap;
    g->qp.Ai = g->at.Ai;
    g->qp.Ax = g->at.Ax;
}

/* l, u: the load on rows of Aeq that are not held; Afr x <= 0; fp, fm >= 0. */
static void sp__program_bounds(sp__program *g, const sp_problem *pb)
{
    const int32_t friction = 6 * pb->blocks, signs = friction + g->friction.faces * pb->points;
    for (int32_t i = 0; i < g->qp.m; i++) {
        const int held = i < friction && sp__held(pb, i / 6, (int)(i % 6));
        const sp_real p = i < friction ? -pb->p[i] / g->unit * (i % 6 > 2 ? g->at.arm[i / 6] : 1) : 0;
        g->at.l[i] = held || (i >= friction && i < signs) ? -SP_QP_INFINITY : p;
        g->at.u[i] = held || i >= signs ? SP_QP_INFINITY : p;
    }
    g->qp.l = g->at.l;
    g->qp.u = g->at.u;
}

/* The program in `a`, with a first guess from the forces of the stage before; NULL: it does not fit. */
SP__APART static sp__program *sp__program_make(const sp_problem *pb, const sp_settings *set, const sp_real *f, sp_arena *a)
{
    sp__program *g = sp__take(a, 1, sizeof *g);
    if (!g) return NULL;
    memset(g, 0, sizeof *g);
    if (!sp__program_open(g, pb, set)) return NULL;
    sp_triplets t = { 0, 0, 0, NULL, NULL, NULL };
    sp__program_columns(g, pb, &t, NULL);
    sp__program_carve(&g->at, &g->qp, pb->blocks, t.count, a);
    if (sp__failed(a)) return NULL;
    g->unit = sp__load_unit(pb);
    sp__program_matrices(g, pb, set);
    sp__program_bounds(g, pb);
    for (size_t v = 0; v < (size_t)pb->points; v++) {
        const sp_real fn = f ? f[3 * v] / g->unit : 0;
        g->at.x[4 * v] = sp__max(fn, 0);
        g->at.x[4 * v + 1] = sp__max(-fn, 0);
        g->at.x[4 * v + 2] = f ? f[3 * v + 1] / g->unit : 0;
        g->at.x[4 * v + 3] = f ? f[3 * v + 2] / g->unit : 0;
    }
    return g;
}

/* The answer into the state, whose forces are put into the cones by whoever judges them.     returns max fm / max fp, -1: there
 * are no forces in it */
static sp_real sp__program_forces(const sp__program *g, const sp_problem *pb, sp_state *state)
{
    const sp_real *x = g->r.x;
    sp_real press = 0, pull = 0;
    if (!x) return -1;
    for (int32_t j = 0; j < g->qp.n; j++) if (!sp__finite(g->unit * x[j])) return -1;
    for (size_t v = 0; v < (size_t)pb->points; v++, x += 4) {
        press = sp__max(press, x[0]);
        pull = sp__max(pull, x[1]);
        state->f[3 * v] = g->unit * (x[0] - x[1]);
        state->f[3 * v + 1] = g->unit * x[2];
        state->f[3 * v + 2] = g->unit * x[3];
    }
    return sp__ratio(pull, press);
}

/* What a run of the quadratic program takes before it heeds a budget: two looks at the first guess. */
static int64_t sp__program_least(const sp_qp *qp)
{
    const int64_t products = 4 * ((int64_t)qp->Ap[qp->n] + 2 * (int64_t)qp->n) + 2 * (int64_t)qp->Ap[qp->n];
    return 2 * (6 * products + 700 * ((int64_t)qp->n + qp->m));
}

/* dq <- the multipliers of Aeq. */
static void sp__program_motion(const sp__program *g, const sp_problem *pb, sp_real *dq)
{
    for (int32_t i = 0; g->r.y && i < 6 * pb->blocks; i++) {
        const sp_real y = g->r.y[i] * (i % 6 > 2 ? g->at.arm[i / 6] : 1);
        dq[i] = sp__finite(y) && !sp__held(pb, i / 6, (int)(i % 6)) ? y : 0;
    }
}

static sp_status sp__admm_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *arena, sp_verdict *claim)
{
    const sp_seed *seed = set->seed ? set->seed : &sp__seed;
    sp__program *g = sp__program_make(pb, set, state->f, arena);
    if (!g) return SP_E_MEMORY;
    state->reason = SP_REASON_BUDGET;
    if (set->budget > 0) g->set.budget = state->left;
    if (set->budget > 0 && state->left < sp__program_least(&g->qp)) return SP_OK;
    const sp_status status = g->solver.solve(g->solver.self, &g->qp, &g->set, arena, g->at.x, NULL, &g->r);
    if (status) return status == SP_E_MEMORY ? status : SP_OK;
    state->cost.flops += g->r.flops;
    state->cost.factorisations += g->r.factorisations;
    state->cost.iterations += g->r.iterations;
    if (g->r.status == SP_QP_PRIMAL_INFEASIBLE) {
        sp__program_motion(g, pb, state->dq);
        state->reason = SP_REASON_UNVERIFIED;
        *claim = SP_UNSTABLE;
        return SP_OK;
    }
    if (g->r.status == SP_QP_DUAL_INFEASIBLE || g->r.status == SP_QP_NUMERICAL) return SP_OK;
    const sp_real ratio = sp__program_forces(g, pb, state);
    if (ratio < 0) return SP_OK;
    sp__program_motion(g, pb, state->dq);
    if (g->r.status != SP_QP_SOLVED) return SP_OK;
    state->tension_ratio = ratio;
    state->reason = ratio > seed->tension ? SP_REASON_TENSION : SP_REASON_UNVERIFIED;
    if (!(ratio > seed->tension)) *claim = SP_STABLE;
    return SP_OK;
}

static size_t sp__admm_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    size_t bytes = 0;
    sp__program *g = sp__program_make(pb, set, NULL, &scratch);
    if (!g) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *g);
    sp__program_carve(&g->at, &g->qp, pb->blocks, g->at.Ap[g->qp.n], &dry);     /* g->qp keeps the arrays */
    if (!pb->points) return dry.peak;                   /* without unknowns it is no program, and is not solved */
    if (g->solver.need && g->solver.need(g->solver.self, &g->qp, &g->set, scratch, &bytes)) return SIZE_MAX;
    sp__take(&dry, 1, bytes);
    if (g->solver.need) return dry.peak;
    sp__take(&dry, (size_t)g->qp.n, sizeof(sp_real));
    sp__take(&dry, (size_t)g->qp.m, sizeof(sp_real));
    return dry.peak;
}

/* Scratch for that, from counts alone; 0: too large. */
static size_t sp__admm_scratch(const sp_problem *pb, const sp_settings *set)
{
    sp_qp qp;
    sp__program_arrays at;
    sp_arena dry = sp__arena_dry();
    const int32_t entries = sp__program_size(pb, set, &qp);
    const size_t solver = entries < 0 ? 0 : sp__qp_count(&qp, entries, sp__program_backend(pb, set, &qp), 0);
    if (solver == 0) return 0;
    sp__take(&dry, 1, sizeof(sp__program));
    sp__program_carve(&at, &qp, pb->blocks, entries, &dry);
    sp__take(&dry, 1, solver);
    return sp__failed(&dry) ? 0 : dry.peak + SP_ALIGN;
}

#endif

/* 23 ------------------------------------------------------------------------------------- coupled check: exact decision */

#ifndef SP_NO_CRA
/* Whether any triple exists, by branch and bound. d = Aeq' dq / L, g = eps / L (1, or 0), reach = eta / L:
 *
 *     Aeq f + p = 0,  f in K;   -g <= dn <= reach,  |dt| <= reach;   fn (dn + g) = 0;   ft = -alpha dt, alpha >= 0
 *
 * The first two are (bounded by) linear rows. The others are by cases, a state for every vertex:
 *     0          unknown                       nothing
 *     1          open                          f = 0
 *     2          engaged                       dn = -g
 *     4..7       engaged, slip in a quarter    dt and -ft both between the ends a, b of the sector; 2s and 2s + 1 halve s
 * All states are covered by 1 and 2; 2 by 4..7; s by 2s and 2s + 1. Whatever the states, p.dq = -f.d = g sum fn - sum ft.dt
 * (virtual work), so g sum fn <= p . dq joins f and dq. A node is one linear programme over (f, dq); where it has no point, its
 * Farkas vector is kept. Where its point meets all conditions, no finer state would exclude it, and the search ends.
 */
#define SP__BRANCH_DEEP (1 << 24)       /* a sector of this state is not halved any more: 4e-7 rad */

/* Rows of the programme: 6b of balance, one of work, then of every vertex: */
enum {
    SP__ROW_GAP,                        /* dn */
    SP__ROW_SLIP,                       /* 4: dt along 0, 45, 90, 135 degrees of (t1, t2) */
    SP__ROW_AHEAD = 5,                  /* dt along the middle of the sector */
    SP__ROW_ENDS,                       /* 2: a x dt >= 0, b x dt <= 0 */
    SP__ROW_RUB = 8,                    /* 2: a x ft <= s fn, b x ft >= -s fn, s = SP__SLIP of the most |ft| / fn */
    SP__ROW_NEAR = 10,                  /* 3: friction in the sector: its ends and middle, or the three faces nearest */
    SP__ROW_CONE = 13,                  /* 8: friction around: the pyramid's faces, or every 45 degrees */
    SP__ROWS = 21
};

/* A node that was split: its vertex, the state before, the child at hand. */
typedef struct sp__frame { int32_t vertex, state, child; } sp__frame;

typedef struct sp__branch {
    const sp_problem *pb;
    const sp_settings *set;
    const sp__judge *j;                 /* for the scales of blocks */
    sp__lengths k;
    sp__lp lp;
    int32_t points;                     /* V: vertices that take part */
    sp_real outer;                      /* of a pyramid: radius of its edges / of its faces */
    sp_real *arm, *load;                /* b: longest arm [m], sbar [j->unit] */
    int32_t *contact, *at;              /* V: contact and point of the scene */
    sp_real (*d)[3][12];                /* V: rows n, t1, t2 of Aeq' on the motions of b and a, rotations times arm */
    sp_real *mu, *size;                 /* V: friction in force; force of one unit of f [unit] */
    int32_t *state, *loaded;            /* V: of the node; in the programme */
    sp__frame *stack;
    int32_t depth;
    sp_proof *proof;
    int32_t nodes, entries;             /* the proof has room for */
} sp__branch;

/* Entries of the programme's rows: balance 18 a vertex and side, work, 8 rows of motion, 13 x 3 of force. */
static int32_t sp__branch_entries(const sp_problem *pb)
{
    int32_t sides = 0, points = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        sides += t->points * ((t->a >= 0) + (t->b >= 0));
        points += t->points;
    }
    return sides * (18 + 6 * 8) + points * (1 + 13 * 3) + 6 * pb->blocks;
}

static void sp__branch_carve(sp__branch *s, const sp_problem *pb, sp_arena *a)
{
    const int32_t V = sp__points_count(pb->scene), b = pb->blocks;
    const size_t v = (size_t)V;
    s->pb = pb;
    s->points = V;
    sp__lp_carve(&s->lp, 3 * V + 6 * b, 6 * b + 1 + SP__ROWS * V, sp__branch_entries(pb), a);
    s->arm = sp__take(a, (size_t)b, sizeof *s->arm);
    s->load = sp__take(a, (size_t)b, sizeof *s->load);
    s->contact = sp__take(a, v, sizeof *s->contact);
    s->at = sp__take(a, v, sizeof *s->at);
    s->d = sp__take(a, v, sizeof *s->d);
    s->mu = sp__take(a, v, sizeof *s->mu);
    s->size = sp__take(a, v, sizeof *s->size);
    s->state = sp__take(a, v, sizeof *s->state);
    s->loaded = sp__take(a, v, sizeof *s->loaded);
    s->stack = sp__take(a, v, SP__PROOF_DEPTH * sizeof *s->stack);
}

/* Ends a, b of the sector of a state >= 4, and its middle m. */
static void sp__sector(int32_t state, sp_real a[2], sp_real m[2], sp_real b[2])
{
    int32_t halvings = 0;
    while (state >> halvings > 7) halvings++;
    const int32_t quarter = (state >> halvings) - 4;
    a[0] = quarter == 0 ? (sp_real)1 : quarter == 2 ? (sp_real)-1 : 0;
    a[1] = quarter == 1 ? (sp_real)1 : quarter == 3 ? (sp_real)-1 : 0;
    b[0] = -a[1]; b[1] = a[0];
    for (;; halvings--) {
        const sp_real x = a[0] + b[0], y = a[1] + b[1], l = SP_SQRT(x * x + y * y);
        m[0] = x / l; m[1] = y / l;
        if (!halvings) return;
        sp_real *end = state >> (halvings - 1) & 1 ? a : b;
        end[0] = m[0]; end[1] = m[1];
    }
}

/* The face of K opposite to the middle of a sector: (2i + 1) / (8 2^h) + 1/2 of a turn, to the nearest of K. */
static int32_t sp__sector_face(int32_t state, int32_t K)
{
    int32_t h = 0;
    while (state >> h > 7) h++;
    const int64_t i = state - ((int64_t)4 << h), turn = (int64_t)8 << h;
    return (int32_t)((K * (2 * (2 * i + 1) + turn) + turn) / (2 * turn) % K);
}

/* Row `row` of the programme gets values: x n + y t1 + z t2 of the motion at vertex v. */
static void sp__branch_motion_row(sp__branch *s, int32_t v, int32_t row, sp_real x, sp_real y, sp_real z)
{
    sp_real *to = s->lp.value + s->lp.start[row];
    const int32_t n = s->lp.start[row + 1] - s->lp.start[row];
    for (int32_t e = 0; e < n; e++) to[e] = x * s->d[v][0][e] + y * s->d[v][1][e] + z * s->d[v][2][e];
}

static int32_t sp__branch_row(const sp__branch *s, int32_t v, int32_t which)
{
    return 6 * s->pb->blocks + 1 + SP__ROWS * v + which;
}

/* x fn + y ft1 + z ft2 */
static void sp__branch_force_row(sp__branch *s, int32_t row, sp_real x, sp_real y, sp_real z)
{
    sp_real *to = s->lp.value + s->lp.start[row];
    to[0] = x; to[1] = y; to[2] = z;
}

static void sp__branch_bound(sp__branch *s, int32_t row, sp_real low, sp_real high)
{
    s->lp.lower[row] = low;
    s->lp.upper[row] = high;
}

/* Friction within the sector: d . ft <= mu fn for directions opposite to its ends and its middle, or for the faces there. */
static void sp__branch_near(sp__branch *s, int32_t v, int32_t state, const sp_real a[2], const sp_real m[2], const sp_real b[2])
{
    const int32_t K = s->set->faces, row = sp__branch_row(s, v, SP__ROW_NEAR);
    if (K && K <= 8) return;
    for (int32_t q = 0; q < 3; q++) {
        const sp_real *w = q == 0 ? a : q == 1 ? m : b;
        sp_real face[2] = { -w[0], -w[1] };
        if (K) sp__pyramid_direction(K, (sp__sector_face(state, K) + K + q - 1) % K, face);
        sp__lp_drop(&s->lp, row + q);
        sp__branch_force_row(s, row + q, -s->mu[v], face[0], face[1]);
        sp__branch_bound(s, row + q, -SP__LP_FREE, 0);
    }
}

/* Rows of the sector of vertex v. */
SP__APART static void sp__branch_sector(sp__branch *s, int32_t v, int32_t state)
{
    sp_real a[2], m[2], b[2];
    const int32_t ends = sp__branch_row(s, v, SP__ROW_ENDS), rub = sp__branch_row(s, v, SP__ROW_RUB);
    const int32_t ahead = sp__branch_row(s, v, SP__ROW_AHEAD);
    sp__sector(state, a, m, b);
    for (int32_t q = 0; q < 2; q++) {
        const sp_real *w = q ? b : a;
        sp__lp_drop(&s->lp, ends + q);
        sp__lp_drop(&s->lp, rub + q);
        sp__branch_motion_row(s, v, ends + q, 0, -w[1], w[0]);
        sp__branch_force_row(s, rub + q, (q ? SP__SLIP : -SP__SLIP) * s->outer * s->mu[v], -w[1], w[0]);
        sp__branch_bound(s, ends + q, q ? -SP__LP_FREE : 0, q ? 0 : SP__LP_FREE);
        sp__branch_bound(s, rub + q, q ? 0 : -SP__LP_FREE, q ? SP__LP_FREE : 0);
    }
    sp__lp_drop(&s->lp, ahead);
    sp__branch_motion_row(s, v, ahead, 0, m[0], m[1]);
    sp__branch_bound(s, ahead, -SP__LP_FREE, s->set->coupled.box ? SP__LP_FREE : s->k.eta);
    sp__branch_near(s, v, state, a, m, b);
}

/* The programme's rows of vertex v for a state. */
static void sp__branch_load(sp__branch *s, int32_t v, int32_t state)
{
    const int32_t gap = sp__branch_row(s, v, SP__ROW_GAP), f = s->lp.m + 3 * v;
    if (s->loaded[v] == state) return;
    s->loaded[v] = state;
    const sp_real most = state == 1 ? 0 : SP__LP_FREE;
    sp__branch_bound(s, gap, -s->k.eps, state < 2 ? s->k.eta : -s->k.eps);
    sp__branch_bound(s, f, 0, most);
    sp__branch_bound(s, f + 1, -most, most);
    sp__branch_bound(s, f + 2, -most, most);
    for (int32_t q = SP__ROW_AHEAD; q < SP__ROW_CONE; q++)
        sp__branch_bound(s, sp__branch_row(s, v, q), -SP__LP_FREE, SP__LP_FREE);
    if (state >= 4) sp__branch_sector(s, v, state);
}

/* d of vertex v: +-(e, (r - c) x e / arm) on b and a. */
static void sp__branch_vertex(sp__branch *s, int32_t v, const sp_contact *t, const sp_real local[3])
{
    const sp_interface *o = t->joint;
    for (int q = 0; q < 3; q++) {
        const sp_real *e = q == 0 ? o->n : q == 1 ? o->t1 : o->t2;
        sp_real *to = s->d[v][q];
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->a : t->b;
            const sp_real *from = side ? t->ra : t->rb, sign = side ? (sp_real)-1 : (sp_real)1;
            sp_real r[3], m[3];
            if (i < 0) continue;
            for (int k = 0; k < 3; k++) r[k] = from[k] + local[0] * o->n[k] + local[1] * o->t1[k] + local[2] * o->t2[k];
            sp__cross3(r, e, m);
            for (int k = 0; k < 3; k++) { *to++ = sign * e[k]; }
            for (int k = 0; k < 3; k++) { *to++ = sign * m[k] / s->arm[i]; }
        }
    }
}

/* Longest arms, and what a block has to carry. */
static void sp__branch_scales(sp__branch *s)
{
    const sp_problem *pb = s->pb;
    for (int32_t i = 0; i < pb->blocks; i++) s->arm[i] = 0;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        for (int32_t p = t->point; p < t->point + t->points; p++)
            for (int side = 0; side < 2; side++) {
                const int32_t i = side ? t->a : t->b;
                if (i < 0) continue;
                sp_real r[3];
                for (int k = 0; k < 3; k++)
                    r[k] = (side ? t->ra : t->rb)[k] + pb->local[p][0] * t->joint->n[k] + pb->local[p][1] * t->joint->t1[k]
                           + pb->local[p][2] * t->joint->t2[k];
                s->arm[i] = sp__max(s->arm[i], sp__norm3(r));
            }
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (!(s->arm[i] > 0)) s->arm[i] = 1;
        s->load[i] = s->j->scale[i].s > 0 ? s->j->scale[i].s : 1;
    }
}

/* One more entry of the row being written. */
static void sp__branch_put(sp__branch *s, int32_t *e, int32_t variable, sp_real value)
{
    s->lp.index[*e] = variable;
    s->lp.value[(*e)++] = value;
}

/* Rows of balance and work: sum d' size f / load = -p / load of every block;  g sum size fn - p . dq <= 0. */
static void sp__branch_balance(sp__branch *s, int32_t *e)
{
    const sp_problem *pb = s->pb;
    const int32_t z = 3 * s->points;
    for (int32_t r = 0; r < 6 * pb->blocks; r++) {
        const int32_t i = r / 6, k = r % 6;
        const sp_real p = pb->p[r] / s->j->unit / (k < 3 ? 1 : s->arm[i]);
        const int held = sp__held(pb, i, k);
        s->lp.start[r] = *e;
        for (int32_t v = 0; v < s->points; v++) {
            const sp_contact *t = &pb->contact[s->contact[v]];
            if (t->a != i && t->b != i) continue;
            const int32_t at = k + (t->b >= 0 && t->a == i ? 6 : 0);
            for (int32_t q = 0; q < 3; q++) sp__branch_put(s, e, 3 * v + q, s->d[v][q][at] * s->size[v] / s->load[i]);
        }
        sp__branch_bound(s, r, held ? -SP__LP_FREE : -p / s->load[i], held ? SP__LP_FREE : -p / s->load[i]);
        sp__branch_bound(s, s->lp.m + z + r, held ? 0 : -SP__LP_FREE, held ? 0 : SP__LP_FREE);
    }
    s->lp.start[6 * pb->blocks] = *e;
    for (int32_t v = 0; v < s->points; v++) sp__branch_put(s, e, 3 * v, s->k.eps * s->size[v]);
    for (int32_t r = 0; r < 6 * pb->blocks; r++)
        sp__branch_put(s, e, z + r, -pb->p[r] / s->j->unit / (r % 6 < 3 ? 1 : s->arm[r / 6]));
    sp__branch_bound(s, 6 * pb->blocks, -SP__LP_FREE, 0);
}

/* Pattern and the fixed rows of vertex v. */
static void sp__branch_fixed(sp__branch *s, int32_t v, int32_t *e)
{
    const sp_contact *t = &s->pb->contact[s->contact[v]];
    const int32_t K = s->set->faces, z = 3 * s->points;
    for (int32_t q = 0; q < SP__ROWS; q++) {
        s->lp.start[sp__branch_row(s, v, q)] = *e;
        sp__branch_bound(s, sp__branch_row(s, v, q), -SP__LP_FREE, SP__LP_FREE);
        if (q < SP__ROW_RUB) {
            for (int side = 0; side < 2; side++) {
                const int32_t i = side ? t->a : t->b;
                for (int32_t k = 0; i >= 0 && k < 6; k++) sp__branch_put(s, e, z + 6 * i + k, 0);
            }
        } else {
            for (int32_t k = 0; k < 3; k++) sp__branch_put(s, e, 3 * v + k, 0);
        }
    }
    s->lp.start[sp__branch_row(s, v, SP__ROWS)] = *e;
    sp__branch_motion_row(s, v, sp__branch_row(s, v, SP__ROW_GAP), 1, 0, 0);
    for (int32_t q = 0; q < 4; q++) {
        sp_real w[2];
        sp__pyramid_direction(8, q, w);
        sp__branch_motion_row(s, v, sp__branch_row(s, v, SP__ROW_SLIP + q), 0, w[0], w[1]);
        if (q % 2 == 0 || !s->set->coupled.box)
            sp__branch_bound(s, sp__branch_row(s, v, SP__ROW_SLIP + q), -s->k.eta, s->k.eta);
    }
    for (int32_t q = 0; q < 8; q++) {
        const int32_t exact = K && K <= 8;
        sp_real w[2];
        if (exact && q >= K) continue;
        sp__pyramid_direction(exact ? K : 8, q, w);
        sp__branch_force_row(s, sp__branch_row(s, v, SP__ROW_CONE + q), -s->mu[v] * (exact ? 1 : s->outer), w[0], w[1]);
        sp__branch_bound(s, sp__branch_row(s, v, SP__ROW_CONE + q), -SP__LP_FREE, 0);
    }
}

/* The root programme. */
SP__APART static void sp__branch_make(sp__branch *s)
{
    const sp_problem *pb = s->pb;
    sp_real c = 1, tangent = 0;
    int32_t e = 0, v = 0;
    if (s->set->faces) sp__pyramid_half(s->set->faces, &c, &tangent);
    if (!s->set->inscribed) c = 1;
    s->outer = SP_SQRT(1 + tangent * tangent);
    sp__branch_scales(s);
    for (int32_t k = 0; k < pb->contacts; k++) {
        const sp_contact *t = &pb->contact[k];
        for (int32_t p = t->point; p < t->point + t->points; p++, v++) {
            s->contact[v] = k;
            s->at[v] = p;
            s->mu[v] = c * t->joint->joint.mu;
            s->size[v] = sp__lesser(t, s->load, 1);
            s->state[v] = 0;
            s->loaded[v] = -1;
            sp__branch_vertex(s, v, t, pb->local[p]);
        }
    }
    sp__branch_balance(s, &e);
    for (v = 0; v < s->points; v++) sp__branch_fixed(s, v, &e);
    sp__lp_start(&s->lp);
}

/* d of vertex v at the programme's point. */
static void sp__branch_rate(const sp__branch *s, int32_t v, sp_real d[3])
{
    const int32_t row = sp__branch_row(s, v, SP__ROW_GAP);
    d[0] = d[1] = d[2] = 0;
    for (int32_t q = 0; q < 3; q++)
        for (int32_t e = s->lp.start[row]; e < s->lp.start[row + 1]; e++)
            d[q] += s->d[v][q][e - s->lp.start[row]] * s->lp.x[s->lp.index[e]];
}

#ifdef SP_REAL_FLOAT
#define SP__BRANCH_DUST ((sp_real)1e-3) /* force or gap that counts as none */
#else
#define SP__BRANCH_DUST ((sp_real)1e-7)
#endif

/* The vertex to branch on: of the unknown the one that presses and gapes most, by its gap; then of those not open the one with
 * the most friction across its slip, as a force, times the width of its sector. -1: the point meets all conditions as closely as
 * states can tell. */
static int32_t sp__branch_pick(const sp__branch *s)
{
    int32_t pick = -1;
    sp_real worst = 0;
    for (int pass = 0; pass < 2 && pick < 0; pass++)
        for (int32_t v = 0; v < s->points; v++) {
            const sp_real *f = s->lp.x + 3 * v;
            sp_real d[3], width = 4;
            if (s->state[v] == 1 || (!pass && s->state[v] > 0) || s->state[v] >= SP__BRANCH_DEEP) continue;
            sp__branch_rate(s, v, d);
            const sp_real ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]), dt = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
            const sp_real x = pass ? ft : f[0], y = pass ? dt : d[0] + s->k.eps, along = f[1] * d[1] + f[2] * d[2];
            if (x <= SP__BRANCH_DUST || y <= SP__BRANCH_DUST) continue;
            const sp_real across = along > 0 ? ft : sp__abs(f[1] * d[2] - f[2] * d[1]) / dt;
            if (pass && across * dt <= SP__BRANCH_DUST) continue;
            for (int32_t q = s->state[v]; q > 3; q /= 2) width /= 2;
            const sp_real value = pass ? s->size[v] * across * width : y;
            if (value > worst) { worst = value; pick = v; }
        }
    return pick;
}

/* Number of a constraint in the proof: rows as they are, bounds of f after the rows of their vertex; -1: a bound of dq. */
static int32_t sp__branch_number(const sp__branch *s, int32_t i)
{
    const int32_t base = 6 * s->pb->blocks + 1, v = i < s->lp.m ? (i - base) / SP__ROWS : (i - s->lp.m) / 3;
    if (i < base) return i;
    if (i < s->lp.m) return i + 3 * v;
    return i < s->lp.m + 3 * s->points ? base + (SP__ROWS + 3) * v + SP__ROWS + (i - s->lp.m) % 3 : -1;
}

/* What one unit of a constraint's scaled row is in the proof's. */
static sp_real sp__branch_weight(const sp__branch *s, int32_t i)
{
    const int32_t base = 6 * s->pb->blocks + 1, v = i < s->lp.m ? (i - base) / SP__ROWS : (i - s->lp.m) / 3;
    if (i < base - 1) return 1 / (s->load[i / 6] * (i % 6 < 3 ? 1 : s->arm[i / 6]));
    if (i == base - 1 || (i < s->lp.m && (i - base) % SP__ROWS < SP__ROW_RUB)) return 1;
    return 1 / s->size[v];
}

/* Multiplier of the k-th active constraint, of the failed one for k = n; 0 for dust, or where it would ask for a bound that is
 * none. */
static sp_real sp__branch_multiplier(const sp__branch *s, int32_t k, sp_real largest)
{
    const sp__lp *lp = &s->lp;
    const int32_t i = k < lp->n ? lp->active[k] : lp->failed;
    const sp_real sign = lp->low ? (sp_real)-1 : (sp_real)1, y = k < lp->n ? -sign * lp->t[k] : sign;
    if (sp__abs(y) <= SP__LP_ZERO * largest) return 0;
    return (y > 0 ? lp->upper[i] >= SP__LP_FREE : lp->lower[i] <= -SP__LP_FREE) ? 0 : y;
}

/* A closed node: its Farkas vector, 1 on the constraint that fails and -t on the active ones.     returns 0: no room */
static int sp__branch_close(sp__branch *s)
{
    sp_proof *p = s->proof;
    const int32_t from = p->entries;
    sp_real largest = 1;
    for (int32_t k = 0; k < s->lp.n; k++) largest = sp__max(largest, sp__abs(s->lp.t[k]));
    for (int32_t k = 0; k <= s->lp.n; k++) {
        const int32_t i = k < s->lp.n ? s->lp.active[k] : s->lp.failed, row = sp__branch_number(s, i);
        const sp_real y = sp__branch_multiplier(s, k, largest);
        if (row < 0 || !(sp__abs(y) > 0)) continue;
        if (p->entries == s->entries) return 0;
        p->row[p->entries] = (uint16_t)row;
        p->y[p->entries++] = y * sp__branch_weight(s, i);
    }
    if (p->nodes == s->nodes) return 0;
    p->node[p->nodes++] = from - p->entries;
    p->leaves++;
    return 1;
}

/* States that a state splits into: how many, and the first. */
static int32_t sp__branch_children(int32_t state, int32_t *first)
{
    *first = state == 0 ? 1 : 2 * state;
    return state == 2 ? 4 : 2;
}

/* Flops that the check of the proof takes: so far, and with a leaf more. */
static int64_t sp__branch_check(const sp__branch *s)
{
    return 40 * ((int64_t)s->proof->entries + s->lp.n) + SP__FLOPS_JUDGE * ((int64_t)s->proof->leaves + 1) * s->points;
}

typedef enum sp__outcome { SP__OUT_REFUTED, SP__OUT_POINT, SP__OUT_BUDGET } sp__outcome;

SP__APART static sp__outcome sp__branch_run(sp__branch *s, int64_t left)
{
    s->depth = 0;
    s->proof->nodes = s->proof->leaves = s->proof->entries = 0;
    for (;;) {
        s->lp.limit = left - sp__branch_check(s);
        for (int32_t v = 0; v < s->points; v++) {
            if (!sp__lp_pays(&s->lp, SP__ROWS)) return SP__OUT_BUDGET;
            sp__branch_load(s, v, s->state[v]);
        }
        const sp__lp_status status = sp__lp_run(&s->lp, 50 * s->lp.n);
        if (status == SP__LP_GIVEN_UP) return SP__OUT_BUDGET;
        if (status == SP__LP_POINT) {
            const int32_t v = sp__branch_pick(s);
            if (v < 0) return SP__OUT_POINT;
            if (s->proof->nodes == s->nodes || s->depth == SP__PROOF_DEPTH * s->points) return SP__OUT_BUDGET;
            sp__frame *f = &s->stack[s->depth++];
            s->proof->node[s->proof->nodes++] = v;
            f->state = s->state[v];
            f->vertex = v;
            f->child = 0;
            sp__branch_children(f->state, &s->state[v]);
            continue;
        }
        if (!sp__branch_close(s)) return SP__OUT_BUDGET;
        for (; s->depth; s->depth--) {                      /* the next child of the deepest node that has one */
            sp__frame *f = &s->stack[s->depth - 1];
            int32_t first;
            const int32_t n = sp__branch_children(f->state, &first);
            s->state[f->vertex] = f->state;
            if (++f->child == n) continue;
            s->state[f->vertex] = first + f->child;
            break;
        }
        if (!s->depth) return SP__OUT_REFUTED;
    }
}

/* Nodes and multipliers a proof has room for; 0: nothing is decided. `points`: contact vertices that take part. */
static int32_t sp__branch_room(int32_t points, int32_t blocks, int32_t asked, int32_t *entries)
{
    const int few = points > 0 && points <= SP_EXACT_POINTS && blocks <= SP_EXACT_POINTS;
    const int32_t cube = few ? 24 * points * points * points : 0, own = cube < 48000 ? cube : 48000;
    const int32_t nodes = few && asked >= 0 ? asked : own;
    const int32_t most = INT32_MAX / 32 - 32 * SP_EXACT_POINTS, room = nodes < most ? nodes : most;
    *entries = room ? 20 * room + 3 * points + 6 * blocks + 1 : 0;
    return room;
}

static void sp__proof_carve(sp_proof *p, int32_t points, int32_t blocks, const sp_settings *set, sp_arena *a)
{
    int32_t entries;
    const int32_t nodes = sp__branch_room(points, blocks, set->coupled.nodes, &entries);
    p->y = sp__take(a, (size_t)entries, sizeof *p->y);
    p->node = sp__take(a, (size_t)nodes, sizeof *p->node);
    p->row = sp__take(a, (size_t)entries, sizeof *p->row);
}

SP__APART static size_t sp__branch_bytes(const sp_problem *pb)
{
    sp__branch s;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof s);
    sp__branch_carve(&s, pb, &dry);
    return dry.used;
}

/* Bytes that the decision and the check of its proof take, one after the other. */
static size_t sp__branch_need(const sp_problem *pb, const sp_settings *set)
{
    int32_t entries;
    const int32_t points = sp__points_count(pb->scene);
    if (!sp__branch_room(points, pb->blocks, set->coupled.nodes, &entries)) return 0;
    const size_t decision = sp__branch_bytes(pb), check = sp__refute_need(points, pb->blocks);
    return decision > check ? decision : check;
}

typedef struct sp__triple { sp_real *f, *dq, *alpha; } sp__triple;      /* 3 x points, 6b, points [N; m, 1; N/m] */

/* fn and dq of the programme's point. */
static void sp__branch_point(const sp__branch *s, const sp__triple *t)
{
    memset(t->f, 0, 3 * (size_t)s->pb->points * sizeof *t->f);
    memset(t->alpha, 0, (size_t)s->pb->points * sizeof *t->alpha);
    for (int32_t v = 0; v < s->points; v++) t->f[3 * (size_t)s->at[v]] = s->lp.x[3 * v] * s->size[v] * s->j->unit;
    for (int32_t r = 0; r < 6 * s->pb->blocks; r++) t->dq[r] = s->k.L * s->lp.x[3 * s->points + r] / (r % 6 < 3 ? 1 : s->arm[r / 6]);
}

/* Is there no triple? The proof, once checked, is left in out->proof, its margin, verdict and reason with it. t (may be NULL): gets
 * the point, if there is one; it is a triple where mu = 0. */
SP__APART static sp_status sp__branch_decide(const sp_problem *pb, const sp_settings *set, sp__judge *j, const sp__lengths *k,
                                             int64_t left, const sp__triple *t, sp_arena *a, sp_coupled *out)
{
    const size_t mark = a->used;
    int32_t entries;
    const int32_t nodes = sp__branch_room(sp__points_count(pb->scene), pb->blocks, set->coupled.nodes, &entries);
    if (!nodes) return SP_OK;
    sp__take(a, 1, sp__branch_need(pb, set));
    if (sp__failed(a)) return SP_E_MEMORY;
    a->used = mark;
    sp__branch *s = sp__take(a, 1, sizeof *s);
    sp__branch_carve(s, pb, a);
    s->set = set;
    s->j = j;
    s->k = *k;
    s->proof = &out->proof;
    s->nodes = nodes;
    s->entries = entries;
    sp__branch_make(s);
    const sp__outcome outcome = sp__branch_run(s, left - out->cost.flops);
    if (t && outcome == SP__OUT_POINT) sp__branch_point(s, t);
    out->cost.flops += s->lp.flops + (outcome == SP__OUT_REFUTED ? sp__branch_check(s) : 0);
    a->used = mark;
    if (outcome == SP__OUT_REFUTED) out->margin = sp__judge_refuted(j, k, &out->proof, a);
    a->used = mark;
    if (out->margin > 0) {
        out->verdict = SP_COUPLING_REFUTED;
        out->reason = SP_COUPLING_NO_MOTION;
        return SP_OK;
    }
    out->proof.nodes = out->proof.leaves = out->proof.entries = 0;
    out->reason = outcome == SP__OUT_POINT ? SP_COUPLING_LIMIT : SP_COUPLING_BUDGET;
    return SP_OK;
}

#endif /* SP_NO_CRA */

/* 24 ------------------------------------------------------------------------------------------------------- coupled check */

#ifndef SP_NO_CRA
/* Is there a virtual motion that explains the forces? Only asked where forces were found; every triple the search offers is
 * judged by the certificate check.                                                             [Kao 2022, Eqs. 8-11; DESIGN 9.3]
 *
 * For any alpha >= 0 the motion that minimises   -p . dq + 1/2 sum alpha |dt|^2   subject to dn >= -eps   meets every condition
 * but two: fn, its multiplier, balances the loads with ft = -alpha dt, but |ft| may exceed mu fn, and slips eta. So the search
 * looks for alpha. It starts with a drag so weak that joints close before friction carries anything, cuts each vertex's friction
 * at mu times the normal force it saw last, and lets the drag grow, which shortens the slips:
 *
 *     min  -p . dq + sum h(|dt|) + kn/2 sum max(0, lam/kn - (dn + eps))^2       h: drag/2 |dt|^2, from drag |dt| = cap on linear
 *
 * by Newton steps on the block matrix of the dual; lam <- fn, cap <- mu fn. Where forces and slips then agree, the motion is
 * put onto dn = -eps and the forces, along their slips, onto balance, both to rounding. */

typedef struct sp__cra {
    const sp_problem *pb;
    const sp_settings *set;
    sp__lengths k;
    sp__judge j;
    sp__triple t;                       /* on offer */
    sp_real omega, residual;            /* what the judge says of it */
    int offered;                        /* there was one */
    sp_coupled *out;
    sp__dual *w;                        /* block matrix, rows, weights; w->y is the motion in L, forces are in units */
    sp_real *f, *d, *D;                 /* 3, 3, 6 x points: forces, dd / L, their derivative */
    sp_real *lam, *cap;                 /* points: multiplier of the normal, bound of the friction */
    sp_real *kept;                      /* 6b */
    const sp_real *statics;             /* 3 x points: the forces that were found [N] */
    sp_real drag;                       /* of slip, in sbar / L */
    sp_real most;                       /* largest sbar of a contact */
    sp_real goal, violation, change;    /* friction beyond its cone, change of fn, relative to sbar */
    int viscous;                        /* friction beyond its cone is lessened by its drag, cap is a factor on it; else cut */
    int far;                            /* forces and slips agree, but a slip or opening exceeds eta */
    sp_real grow;                       /* how fast a drag that was lessened may grow again */
    int tiny;                           /* friction had to be dropped because its slip was too short */
    int mirror, spent;                  /* it was searched for in the plane; the budget ended the search */
    sp_real soft;                       /* of joints that stick: their stiffness when pulled / when pressed; else 0 */
    sp_real (*held)[4];                 /* points, of a motion held fast: largest |ft| / fp, -1: open; direction; 1 / |dt| */
    sp_real *still;                     /* 6b: that motion */
    int holds;                          /* forces are those of the penalty form in the motion held fast */
    sp_real energy, least;              /* at the end of a descent; of the penalty form so far */
} sp__cra;

#ifdef SP_REAL_FLOAT
#define SP__AGREE ((sp_real)1e-3)       /* forces and slips agree so far when their other digits are tried */
#define SP__STIFF ((sp_real)100)        /* kn: of joints, in sbar / L */
#define SP__DUST ((sp_real)1e-5)        /* forces below it, relative to sbar, are taken for none */
#else
#define SP__AGREE ((sp_real)1e-7)
#define SP__STIFF ((sp_real)1e4)
#define SP__DUST ((sp_real)1e-8)
#endif
#define SP__CRA_FLOPS 4000000000        /* work after which the search gives up */
#define SP__HOLD_SHIFT ((sp_real)(sizeof(sp_real) == 8 ? 1e-8 : 1e-5))          /* SP__SHIFT for a motion held fast */

static void sp__triple_carve(sp__triple *t, const sp_problem *pb, sp_arena *a)
{
    t->f = sp__take(a, (size_t)pb->points, 3 * sizeof *t->f);
    t->dq = sp__take(a, (size_t)pb->blocks, 6 * sizeof *t->dq);
    t->alpha = sp__take(a, (size_t)pb->points, sizeof *t->alpha);
}

static void sp__cra_carve(sp__cra *c, const sp_problem *pb, int localise, sp_arena *a)
{
    const size_t v = (size_t)pb->points;
    c->f = sp__take(a, v, 3 * sizeof *c->f);
    c->d = sp__take(a, v, 3 * sizeof *c->d);
    c->D = sp__take(a, v, 6 * sizeof *c->D);
    c->lam = sp__take(a, v, sizeof *c->lam);
    c->cap = sp__take(a, v, sizeof *c->cap);
    c->kept = sp__take(a, (size_t)pb->blocks, 6 * sizeof *c->kept);
    c->still = sp__take(a, localise ? (size_t)pb->blocks : 0, 6 * sizeof *c->still);
    c->held = sp__take(a, localise ? v : 0, sizeof *c->held);
}

/* sbar of the vertices of contact c, the smaller. */
static sp_real sp__cra_sbar(const sp__cra *c, const sp_contact *t)
{
    return sp__lesser(t, &c->j.scale->s, sizeof *c->j.scale / sizeof c->j.scale->s);
}

/* Largest |ft| / fn against slip d: mu, of a pyramid what it reaches in that direction. */
static sp_real sp__cra_reach(const sp__cra *c, const sp_contact *t, const sp_real d[3])
{
    const sp_real mu = t->joint->joint.mu * c->j.mu_factor, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
    sp_real most = 0;
    if (!c->set->faces || !(slip > 0)) return mu;
    for (int32_t k = 0; k < c->set->faces; k++)
        most = sp__max(most, -(c->j.direction[k][0] * d[1] + c->j.direction[k][1] * d[2]));
    return mu * (slip / most);
}

/* u = Aeq' y at every vertex. */
SP__APART static void sp__cra_rates(const sp__cra *c, const sp_real *y, sp_real *u)
{
    if (!sp__dual_count(c->w, 15, SP__FLOPS_TWIST / 2)) return;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        sp_real V[3], W[3];
        sp__dual_twist(c->w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++)
            if (sp__dual_counts(c->w, v) > 0) sp__dual_rate(c->w, V, W, c->pb->local[v], u + 3 * (size_t)v);
    }
}

/* w->r = Aeq f + load (load: 1 or 0), weighted. */
SP__APART static void sp__cra_balance(const sp__cra *c, const sp_real *f, int load)
{
    const sp_problem *pb = c->pb;
    if (load) sp__dual_load(c->w, c->w->r);
    else memset(c->w->r, 0, 6 * (size_t)pb->blocks * sizeof *c->w->r);
    if (!sp__dual_count(c->w, 15, SP__FLOPS_TWIST / 2)) return;
    for (int32_t q = 0; q < pb->contacts; q++) {
        const sp_contact *t = &pb->contact[q];
        sp_real F[3] = { 0, 0, 0 }, M[3] = { 0, 0, 0 }, m[3];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real *g = f + 3 * (size_t)v, times = sp__dual_counts(c->w, v);
            if (!(times > 0)) continue;
            sp__cross3(pb->local[v], g, m);
            for (int k = 0; k < 3; k++) { F[k] += times * g[k]; M[k] += times * m[k]; }
        }
        sp__dual_scatter(c->w, t, F, M, c->w->r);
    }
    sp__dual_release(c->w, c->w->r);
}

/* Force and derivative of one vertex that moves by d; the energy stored in it is added to *energy. */
static void sp__cra_vertex(const sp__cra *c, size_t v, sp_real s, sp_real *energy)
{
    const sp_real *d = c->d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), cap = c->viscous ? SP__HUGE : c->cap[v];
    const sp_real drag = c->drag * s * (c->viscous ? c->cap[v] : 1), fn = c->lam[v] - SP__STIFF * s * (d[0] + c->k.eps);
    sp_real *f = c->f + 3 * v, *D = c->D + 6 * v;
    const int slides = drag * slip > cap;
    const sp_real al = slides ? cap / slip : drag, z = al / (SP__STIFF * c->most);
    const sp_real x = slides ? d[1] / slip : 0, y = slides ? d[2] / slip : 0;
    f[0] = fn > 0 ? fn : c->soft * fn;
    f[1] = -al * d[1];
    f[2] = -al * d[2];
    D[0] = (fn > 0 ? 1 : c->soft) * s / c->most;
    D[1] = D[2] = 0;
    D[3] = z * (1 - x * x);
    D[4] = -z * x * y;
    D[5] = z * (1 - y * y);
    *energy += f[0] * fn / (2 * SP__STIFF * s) + (slides ? cap * (slip - cap / (2 * drag)) : al * slip * slip / 2);
}

/* The same of a motion held fast, d being the penalty form's potential:  fm = max(0, dn) / gamma, and (fp, sqrt(tau) |ft|) is
 * the nearest to -(dn, e . dt / sqrt(tau)) in the wedge between (1, 0) and (1, m). */
static void sp__cra_wedge(const sp__cra *c, size_t v, sp_real s, sp_real *energy)
{
    const sp_real *d = c->d + 3 * v, *held = c->held[v], soft = 1 / c->set->gamma, slide = 1 / SP_SQRT(c->set->tau);
    const sp_real m = held[0] / slide, x = -d[0], z = -slide * (held[1] * d[1] + held[2] * d[2]);
    const sp_real on = (x + m * z) / (1 + m * m);
    const int open = held[0] < 0, inside = !open && x > 0 && z > 0 && z <= m * x, rim = !open && !inside && z > 0 && on > 0;
    const int axis = !open && z <= 0 && x > 0;
    const sp_real nn = inside || axis ? 1 : rim ? 1 / (1 + m * m) : 0;
    const sp_real nt = rim ? m * nn : 0, tt = inside ? 1 : rim ? m * nt : 0;
    const sp_real fp = inside || axis ? x : rim ? on : 0, ft = inside ? z : rim ? m * on : 0, fm = soft * sp__max(-x, 0);
    sp_real *f = c->f + 3 * v, *D = c->D + 6 * v;
    f[0] = s * (fp - fm);
    f[1] = s * slide * ft * held[1];
    f[2] = s * slide * ft * held[2];
    s /= c->most;
    D[0] = s * (nn + (x < 0 ? soft : 0));
    D[1] = s * slide * nt * held[1];
    D[2] = s * slide * nt * held[2];
    s *= slide * slide * tt;
    D[3] = s * held[1] * held[1];
    D[4] = s * held[1] * held[2];
    D[5] = s * held[2] * held[2];
    *energy += (f[0] * x + f[1] * -d[1] + f[2] * -d[2]) / 2;
}

/* sbar of contact t as the penalty form takes it: no metric unless there must be one. */
static sp_real sp__cra_size(const sp__cra *c, const sp_contact *t)
{
    return c->w->metric > 0 ? sp__cra_sbar(c, t) : c->most;
}

/* Forces, derivatives and the energy of motion w->y; w->r: what they leave unbalanced. */
SP__APART static sp_real sp__cra_springs(sp__cra *c)
{
    sp_real energy = 0;
    sp__cra_rates(c, c->w->y, c->d);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = c->holds ? sp__cra_size(c, t) : sp__cra_sbar(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real times = sp__dual_counts(c->w, (int32_t)v);
            sp_real part = 0;
            if (!(times > 0)) continue;
            if (c->holds) sp__cra_wedge(c, v, s, &part);
            else sp__cra_vertex(c, v, s, &part);
            energy += times * part;
        }
    }
    sp__cra_balance(c, c->f, 1);
    return energy - sp__dual_work(c->w, c->w->y);
}

/* Largest component of Aeq' y. */
SP__APART static sp_real sp__cra_extent(const sp__cra *c, const sp_real *y)
{
    sp_real most = 0;
    if (!sp__dual_count(c->w, 15, SP__FLOPS_TWIST / 2)) return 0;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        sp_real V[3], W[3], u[3];
        sp__dual_twist(c->w, t, y, V, W);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            if (!(sp__dual_counts(c->w, v) > 0)) continue;
            sp__dual_rate(c->w, V, W, c->pb->local[v], u);
            for (int k = 0; k < 3; k++) most = sp__max(most, sp__abs(u[k]));
        }
    }
    return most;
}

/* y <- kept + step d */
static sp_real sp__cra_at(sp__cra *c, sp_real step)
{
    memcpy(c->w->y, c->kept, 6 * (size_t)c->pb->blocks * sizeof *c->kept);
    sp__dual_axpy(c->w, step, c->w->d, c->w->y);
    return sp__cra_springs(c);
}

/* Where between 0 and `high` along d the energy is least; it falls by `down` at first, and rises at `step`. */
static sp_real sp__cra_valley(sp__cra *c, sp_real step, sp_real high, sp_real down)
{
    const size_t n = 6 * (size_t)c->pb->blocks;
    sp_real low = 0, energy = 0;
    for (int k = 0; k < 20; k++) {
        energy = sp__cra_at(c, step);
        const sp_real slope = sp__dot(c->w->r, c->w->d, n);
        if (sp__abs(slope) < (sp_real)0.1 * down) break;
        if (slope > 0) low = step;
        else high = step;
        step = (low + high) / 2;
    }
    return energy;
}

/* Newton steps with halving on the energy; a motion held fast has sharper bends, and takes more of them.
 *   returns 0 when the motion runs away, or the work is spent */
SP__APART static int sp__cra_descend(sp__cra *c)
{
    const size_t n = 6 * (size_t)c->pb->blocks;
    sp__dual *w = c->w;
    const sp_real enough = sp__max(1000 * (sp_real)SP_EPSILON, (sp_real)1e-3 * c->goal);
    const sp_real shift = c->holds ? SP__HOLD_SHIFT : SP__SHIFT;
    const sp_real room = 1 + (c->holds ? 1000 * c->set->gamma : c->k.eta), whole = 1 / ((c->holds ? 1 : SP__STIFF) * c->most);
    c->energy = sp__cra_springs(c);
    for (int it = 0; it < (c->holds ? 150 : 15) && !w->spent; it++) {
        if (sp__dual_norm(w, w->r) <= enough * w->load) break;
        sp__dual_factor(w, SP__GIVEN, w->y, shift);
        sp__dual_solve(w, w->r, w->d);
        const sp_real down = sp__dot(w->r, w->d, n), far = sp__cra_extent(c, w->d);
        memcpy(c->kept, w->y, n * sizeof *w->y);
        sp_real step = far * whole > 20 * room ? 20 * room / far : whole, next = c->energy;
        for (int half = 0; half < 30; half++, step /= 2) {
            next = sp__cra_at(c, step);
            if (next <= c->energy - (sp_real)1e-4 * down * step + 100 * (sp_real)SP_EPSILON * sp__abs(c->energy)) break;
        }
        c->energy = c->holds && step < whole ? sp__cra_valley(c, step, whole, down) : next;
        c->out->cost.iterations++;
        if (!(sp__cra_extent(c, w->y) < 1000 * room)) return 0;
    }
    return !w->spent;
}

/* Where friction exceeds its cone it is cut; lam follows fn.     returns 1 when forces and slips agree */
SP__APART static int sp__cra_update(sp__cra *c, sp_real damp)
{
    c->violation = c->change = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t q = 0; q < c->pb->contacts; q++) {
            const sp_contact *t = &c->pb->contact[q];
            const sp_real s = sp__cra_sbar(c, t);
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                const sp_real *f = c->f + 3 * (size_t)v;
                const sp_real fp = sp__max(f[0], 0), room = sp__cra_reach(c, t, c->d + 3 * (size_t)v) * fp;
                const sp_real ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
                if (!pass) {
                    c->violation = sp__max(c->violation, (ft - room) / s);
                    c->change = sp__max(c->change, sp__abs(fp - c->lam[v]) / (SP__STIFF * s));
                    c->lam[v] = fp;
                } else if (c->viscous) {
                    if (ft > 0) c->cap[v] *= sp__max((sp_real)0.1, room < 2 * ft ? (sp_real)0.999 * room / ft : c->grow);
                    if (c->cap[v] > 1) c->cap[v] = 1;
                } else c->cap[v] = c->cap[v] < SP__HUGE ? damp * room + (1 - damp) * c->cap[v] : room;
            }
            if (q + 1 == c->pb->contacts && !pass && c->violation <= c->goal) pass = 1;     /* the caps are good */
        }
    return c->violation <= c->goal && c->change <= c->goal;
}

/* The motion put onto dn = -eps where a vertex presses: proximal steps on the squares of dn + eps. */
SP__APART static void sp__cra_press(sp__cra *c)
{
    sp__dual *w = c->w;
    for (int round = 0; round < 5; round++) {
        sp__cra_rates(c, w->y, c->d);
        for (int32_t q = 0; q < c->pb->contacts; q++) {
            const sp_contact *t = &c->pb->contact[q];
            const sp_real s = sp__cra_sbar(c, t) / c->most;
            for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
                const int presses = c->f[3 * v] > 0;
                sp_real *D = c->D + 6 * v;
                D[0] = presses ? s : 0;
                D[1] = D[2] = D[4] = 0;
                D[3] = D[5] = (sp_real)1e-6 * s;
                c->d[3 * v] = presses ? -s * (c->d[3 * v] + c->k.eps) : 0;
                c->d[3 * v + 1] = c->d[3 * v + 2] = 0;
            }
        }
        if (!round) sp__dual_factor(w, SP__GIVEN, w->y, SP__SHIFT);
        sp__cra_balance(c, c->d, 0);
        sp__dual_solve(w, w->r, w->d);
        sp__dual_axpy(w, 1, w->d, w->y);
    }
    sp__cra_rates(c, w->y, c->d);
}

/* Forces are laid along the slips: df = -D Aeq' z where Aeq D Aeq' z = Aeq f + p; D of a vertex that presses, of one whose
 * friction is free in size, of one at the rim of its cone.     returns 0 when a force changes its sign */
SP__APART static int sp__cra_lay(sp__cra *c)
{
    sp__dual *w = c->w;
    for (int round = 0; round < 4; round++) {
        sp__cra_balance(c, c->f, 1);
        if (!round) sp__dual_factor(w, SP__GIVEN, w->y, SP__SHIFT);
        sp__dual_solve(w, w->r, w->d);
        for (int32_t q = 0; q < c->pb->contacts; q++) {
            const sp_contact *t = &c->pb->contact[q];
            sp_real *V = w->h, *W = w->h + 3, *u = w->h + 6;
            sp__dual_twist(w, t, w->d, V, W);
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                const sp_real *D = c->D + 6 * (size_t)v;
                sp_real *f = c->f + 3 * (size_t)v;
                if (!(f[0] > 0)) continue;
                sp__dual_rate(w, V, W, c->pb->local[v], u);
                f[0] -= D[0] * u[0] + D[1] * u[1] + D[2] * u[2];
                f[1] -= D[1] * u[0] + D[3] * u[1] + D[4] * u[2];
                f[2] -= D[2] * u[0] + D[4] * u[1] + D[5] * u[2];
                if (!(f[0] > 0) || f[1] * c->d[3 * (size_t)v + 1] + f[2] * c->d[3 * (size_t)v + 2] > 0) return 0;
            }
        }
    }
    return 1;
}

/* How each vertex's force may change: none where it is open, along n, along the slip, along both at the rim of the cone.
 * Friction whose slip is too short is dropped. */
SP__APART static void sp__cra_freedoms(sp__cra *c)
{
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__cra_sbar(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            sp_real *f = c->f + 3 * v, *D = c->D + 6 * v;
            const sp_real *d = c->d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), reach = sp__cra_reach(c, t, d);
            const sp_real ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]), wn = sp__max(sp__max(f[0], ft) / c->most, (sp_real)1e-6 * s / c->most);
            const int rubs = ft > 0 && slip > 2 * SP__SLIP, rim = rubs && ft >= (1 - (sp_real)1e-6) * reach * f[0];
            const sp_real x = rubs ? -d[1] / slip : 0, y = rubs ? -d[2] / slip : 0;
            const sp_real wt = rim ? wn * reach * reach : rubs ? wn : 0, cross = rim ? wn * reach : 0;
            if (!rubs && ft > 100 * SP__DUST * s) c->tiny = 1;
            D[0] = f[0] > 0 ? wn : 0;
            D[1] = cross * x; D[2] = cross * y;
            D[3] = wt * x * x; D[4] = wt * x * y; D[5] = wt * y * y;
            f[1] = (rim ? reach * f[0] : ft) * x;
            f[2] = (rim ? reach * f[0] : ft) * y;
        }
    }
}

#ifndef SP_NO_PLAN
/* A triple in the plane as one in space: motions out of the axes e, f and alpha of mirrored corners those of their images. */
static void sp__cra_lift(const sp__cra *c)
{
    const sp__flat *o = c->w->flat;
    sp__flat_lift(c->w, c->t.dq);
    sp__flat_spread(o, c->pb, c->t.f);
    for (int32_t v = 0; v < c->pb->points; v++) c->t.alpha[v] = c->t.alpha[o->mate[v] < v ? o->mate[v] : v];
}
#endif

/* The triple in metres and newtons.     returns 1 when it is verified */
SP__APART static int sp__cra_offer(sp__cra *c)
{
    const sp__dual *w = c->w;
    for (size_t k = 0; k < 6 * (size_t)c->pb->blocks; k++) c->t.dq[k] = c->k.L * w->weight[k / 3] * w->y[k];
    memset(c->t.f, 0, 3 * (size_t)c->pb->points * sizeof *c->t.f);
    memset(c->t.alpha, 0, (size_t)c->pb->points * sizeof *c->t.alpha);
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real *f = c->f + 3 * v, *d = c->d + 3 * v;
            const sp_real slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
            sp__scale3(w->unit, f, c->t.f + 3 * v);
            if (slip > 0) c->t.alpha[v] = ft / slip * (w->unit / c->k.L);
        }
    }
#ifndef SP_NO_PLAN
    if (w->flat) sp__cra_lift(c);
#endif
    if (!sp__dual_pay(c->w, 2 * SP__FLOPS_JUDGE * (int64_t)c->pb->points)) return 0;
    c->omega = sp__judge_forces(&c->j, c->t.f, c->t.f);
    c->residual = sp__judge_coupled(&c->j, &c->k, c->t.f, c->t.dq, c->t.alpha);
    c->offered = 1;
    return c->omega <= c->set->tol && c->residual <= 1;
}

/* Forces and slips agree to some digits: the rest of the digits.     returns 1 when a triple is verified */
SP__APART static int sp__cra_polish(sp__cra *c)
{
    memcpy(c->kept, c->w->y, 6 * (size_t)c->pb->blocks * sizeof *c->kept);
    c->tiny = 0;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__cra_sbar(c, t);
        for (int32_t v = t->point; v < t->point + t->points; v++)
            if (c->f[3 * (size_t)v] <= SP__DUST * s) memset(c->f + 3 * (size_t)v, 0, 3 * sizeof *c->f);
    }
    sp__cra_press(c);
    sp__cra_freedoms(c);
    return sp__cra_lay(c) && sp__cra_offer(c);
}

/* The motion is held fast: what each vertex may carry in it.     returns 0 when it is none that the conditions allow */
SP__APART static int sp__cra_fasten(sp__cra *c)
{
    for (int deep = 1, round = 0; deep && round < 5; round++) {         /* what comes to lie too deep presses, too */
        deep = 0;
        sp__cra_press(c);
        for (size_t v = 0; v < (size_t)c->pb->points; v++) {
            if (c->d[3 * v] + c->k.eps >= -SP__GIVE) continue;
            deep = !(c->f[3 * v] > 0);
            c->f[3 * v] = 1;
        }
    }
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real *d = c->d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), gap = d[0] + c->k.eps;
            const sp_real most = c->set->coupled.box ? sp__max(sp__abs(d[1]), sp__abs(d[2])) : slip;
            const int rubs = slip > 2 * SP__SLIP;
            if (gap < -SP__GIVE || sp__max(d[0], most) > c->k.eta) return 0;
            c->held[v][0] = gap > SP__GIVE ? -1 : rubs ? sp__cra_reach(c, t, d) : 0;
            c->held[v][1] = rubs ? -d[1] / slip : 0;
            c->held[v][2] = rubs ? -d[2] / slip : 0;
            c->held[v][3] = rubs ? 1 / slip : 0;
        }
    }
    return 1;
}

/* The best answer so far: forces, and the motion with its alpha. */
SP__APART static void sp__cra_keep(sp__cra *c)
{
    const sp__dual *w = c->w;
    const sp_real soft = 1 / c->set->gamma;
    c->least = -c->energy;
    for (size_t k = 0; k < 6 * (size_t)c->pb->blocks; k++) c->t.dq[k] = c->k.L * w->weight[k / 3] * c->still[k];
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__cra_size(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real fm = s * soft * sp__max(c->d[3 * v], 0), *f = c->f + 3 * v;
            sp_real *to = c->out->penalty + 4 * v;
            c->t.alpha[v] = SP_SQRT(f[1] * f[1] + f[2] * f[2]) * (w->unit / c->k.L) * c->held[v][3];
            to[0] = c->held[v][0] < 0 ? 0 : w->unit * sp__max(f[0] + fm, 0);
            to[1] = w->unit * fm;
            to[2] = w->unit * f[1];
            to[3] = w->unit * f[2];
        }
    }
}

/* The penalty form in the motion at hand, put onto dn = -eps.     returns 1 when it is the best so far */
SP__APART static int sp__cra_hold(sp__cra *c)
{
    const size_t n = 6 * (size_t)c->pb->blocks;
    sp__dual *w = c->w;
    if (!sp__cra_fasten(c)) return 0;
    memcpy(c->still, w->y, n * sizeof *w->y);
    memset(w->y, 0, n * sizeof *w->y);
    c->holds = 1;
    c->goal = SP__AGREE;
    const int better = sp__cra_descend(c) && sp__dual_norm(w, w->r) <= SP__AGREE * w->load && -c->energy < c->least;
    if (better) sp__cra_keep(c);
    c->holds = 0;
    memcpy(w->y, c->still, n * sizeof *w->y);
    return better;
}

/* Rounds at one drag, to more digits where fewer do not do.
 *   returns 1: a triple is verified, 0: go on, -1: the motion ran away */
SP__APART static int sp__cra_rounds(sp__cra *c, sp_real damp)
{
    sp_real last = SP__HUGE;
    c->goal = SP__AGREE;
    for (int round = 0; round < 25; round++) {
        c->out->rounds++;
        if (!sp__cra_descend(c)) return -1;
        if (c->soft > 0 && sp__cra_hold(c)) return 1;
        c->far = 0;
        if (sp__cra_update(c, damp)) {
            c->far = sp__cra_extent(c, c->w->y) > c->k.eta + SP__STIFF * SP__GIVE;
            if (c->far || c->soft > 0) return 0;
            if (sp__cra_polish(c)) return 1;
            memcpy(c->w->y, c->kept, 6 * (size_t)c->pb->blocks * sizeof *c->kept);
            c->goal /= 1000;
            if (c->goal < 100 * (sp_real)SP_EPSILON) return 0;
        }
        if (c->violation > last) damp = sp__max((sp_real)0.1, damp * (sp_real)0.7);
        last = c->violation;
    }
    return 0;
}

/* A start with the joints that press already closed: forces as if dn + eps were dn, then the motion put onto dn = -eps there.
 * Without eps they touch where they are, and press as statics found: nothing else would, where a squeezed block only slides. */
static void sp__cra_close(sp__cra *c, sp_real drag)
{
    const int gives = c->k.eps > 0;
    c->drag = drag;
    c->goal = SP__AGREE;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real press = (sp_real)1.01 * SP__STIFF * sp__cra_sbar(c, t) * c->k.eps;
        for (int32_t v = t->point; v < t->point + t->points; v++)
            c->lam[v] = gives ? press : c->statics[3 * (size_t)v] / c->w->unit;
    }
    if (!gives) return;
    sp__cra_descend(c);
    for (size_t v = 0; v < (size_t)c->pb->points; v++) c->lam[v] = sp__max(c->f[3 * v], 0);
    sp__cra_press(c);
}

/* From rest, with growing drag.     returns 1 when a triple is verified */
SP__APART static int sp__cra_grow(sp__cra *c, sp_real drag, sp_real damp)
{
    memset(c->w->y, 0, 6 * (size_t)c->pb->blocks * sizeof *c->w->y);
    sp__cra_close(c, drag);
    for (c->drag = drag; c->drag < 200 || (c->far && c->drag < 20000); c->drag *= 10) {
        const int found = sp__cra_rounds(c, damp);
        if (found) return found > 0;
    }
    return 0;
}

/* Friction to start with: without a bound, at mu times statics' fn, a whole or (other contacts than `lone`, or it alone) hardly
 * any of the drag. */
typedef enum sp__start { SP__START_FREE, SP__START_STATICS, SP__START_DRAG, SP__START_LONE, SP__START_OTHERS } sp__start;

static void sp__cra_start(sp__cra *c, sp__start how, int32_t lone)
{
    c->viscous = how >= SP__START_DRAG;
    c->grow = how == SP__START_DRAG ? 2 : 1;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const int weak = how >= SP__START_LONE && (q == lone) == (how == SP__START_OTHERS);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real most = t->joint->joint.mu * c->j.mu_factor * (c->statics[3 * v] / c->w->unit);
            c->cap[v] = c->viscous ? (weak ? (sp_real)1e-5 : 1) : how == SP__START_FREE ? SP__HUGE : most;
        }
    }
}

#define SP__LONE_MOST 24                /* contacts up to which each is tried alone: what jams askew does so by unequal drag */

/* Several starts, the likeliest first. */
static int sp__cra_search(sp__cra *c)
{
    static const struct { sp__start how; sp_real drag, damp; } start[] = {
        { SP__START_FREE, (sp_real)0.01, (sp_real)0.7 }, { SP__START_FREE, (sp_real)0.1, (sp_real)0.3 },
        { SP__START_DRAG, (sp_real)0.01, 0 },            { SP__START_STATICS, (sp_real)0.01, (sp_real)0.3 },
        { SP__START_DRAG, 1, 0 },                        { SP__START_STATICS, 1, (sp_real)0.3 },
        { SP__START_FREE, 1, (sp_real)0.3 },             { SP__START_DRAG, (sp_real)1e-4, 0 } };
    for (int k = 0; k < 8; k++) {
        sp__cra_start(c, start[k].how, 0);
        if (sp__cra_grow(c, start[k].drag, start[k].damp)) return 1;
        if (c->w->spent) return 0;
    }
    for (int32_t q = 0; q < c->pb->contacts && c->pb->contacts <= SP__LONE_MOST && !c->w->spent; q++)
        for (int others = 0; others < 2; others++) {
            sp__cra_start(c, others ? SP__START_OTHERS : SP__START_LONE, q);
            if (sp__cra_grow(c, (sp_real)0.01, 0)) return 1;
        }
    return 0;
}

/* The best answer into the result: alpha, what each joint demands, the largest fm / the largest fp. */
SP__APART static void sp__cra_demand(const sp__cra *c, sp_demand *demand)
{
    sp_coupled *out = c->out;
    sp_real press = 0, pull = 0;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        sp_demand *o = &demand[t->id];
        o->tension = o->friction = 0;
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real *x = out->penalty + 4 * v, ft = SP_SQRT(x[2] * x[2] + x[3] * x[3]);
            o->tension = sp__max(o->tension, x[1] - x[0]);
            o->friction = sp__max(o->friction, ft - t->joint->joint.mu * sp__max(x[0] - x[1], 0));
            press = sp__max(press, x[0]);
            pull = sp__max(pull, x[1]);
        }
    }
    out->tension_ratio = sp__ratio(pull, press);
}

/* Where help is wanted: the penalty form, joined with a motion.                                              [Kao 2022, Eq. 14]
 *
 *     min 1/2 sum (fp^2 + gamma fm^2 + tau |ft|^2)     Aeq (fp - fm, ft) + p = 0,  |ft| <= mu fp,  fm >= 0
 *     (fp, ft, dq, alpha) as in the coupled check
 *
 * Motions come from the search, with joints that stick: pulled open they give softly. Each is held fast; what is left is
 * convex, and its dual is unconstrained as that of the penalty form. The least of them counts. */
SP__APART static void sp__cra_help(sp__cra *c, sp_demand *demand)
{
    static const sp_real part[] = { 1, (sp_real)0.1, 10, 100 };
    const int32_t rounds = c->out->rounds;
    c->least = SP__HUGE;
    for (int k = 0; k < 8 && (k < 2 || !(c->least < SP__HUGE)) && !c->w->spent; k++) {
        c->soft = part[k % 4] / (SP__STIFF * c->k.eta);                 /* a joint that carries sbar opens by eta / part */
        sp__cra_start(c, SP__START_FREE, 0);
        memset(c->w->y, 0, 6 * (size_t)c->pb->blocks * sizeof *c->w->y);
        sp__cra_close(c, (sp_real)0.01);
        if (k >= 4) sp__cra_search(c);
        else if (sp__cra_descend(c)) sp__cra_hold(c);
    }
    c->out->rounds = rounds;
    if (c->least < SP__HUGE) sp__cra_demand(c, demand);
}

#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
/* The seed's own search, settings.coupled.rounds > 0: forces and motion take turns.                        [seed 3.2, 3.3]
 *
 *     E: fn > max(floor, engaged max fn)     F: |ft| above the same     w^2 = fn / max fn     h = ft / |ft|
 *     min over dq, beta   sum_E w^2 (dn + eps)^2 + sum_F |dt + beta h|^2 + reg |dq|^2
 *     s.t.                dn >= -eps, |dd| <= eta, beta >= least
 *
 * in our signs and units of L: first without constraints, beta solved for in closed form (in the block matrix it is the
 * projection of dt across h); where that breaks a constraint, as a quadratic program. Friction without slip is no motion that
 * explains it, so beta is drawn, ever so weakly, to SP__ALT_SLIP, and bounded below. Where w |dn + eps| <= gate on E the forces
 * are laid along the slips and the triple is judged like any other. Else the worst joints of E lose their force and friction
 * against the slip is dropped, and the forces are solved for anew. */
typedef struct sp__alt {
    sp__cra *c;
    const sp_seed *seed;
    sp_real (*f)[3];                    /* points: forces of the round, in units */
    sp_real (*h)[2];                    /* points: direction of friction, 0 outside F */
    sp_real *weight;                    /* points: w, 0 outside E */
    int32_t *pin;                       /* points: 1: no friction, 2: no force */
    sp_real slip, least;                /* what beta is drawn to; its bound */
    sp_arena rest;                      /* for the programs */
} sp__alt;

/* min 1/2 x'Px + q'x over x = (y, d, beta): rows Aeq' y - d = 0, bounds of d, of beta. */
typedef struct sp__explain {
    sp_qp qp;
    sp_qp_settings set;
    sp_qp_result r;
    sp_triplets t;
    sp_csc A;
    int32_t *Pp, *Pi;
    sp_real *Px, *q, *l, *u, *x;
} sp__explain;

#define SP__ALT_STEPS 40                /* of the forces towards balance */
#define SP__ALT_WEAK ((sp_real)(sizeof(sp_real) == 8 ? 1e-6 : 1e-3))    /* weight of (beta - slip)^2 */

static void sp__alt_carve(sp__alt *m, const sp_problem *pb, sp_arena *a)
{
    const size_t v = (size_t)pb->points;
    m->f = sp__take(a, v, sizeof *m->f);
    m->h = sp__take(a, v, sizeof *m->h);
    m->weight = sp__take(a, v, sizeof *m->weight);
    m->pin = sp__take(a, v, sizeof *m->pin);
}

/* Entries of A; weight: of force and moment rows (NULL: 1). */
static void sp__explain_entries(sp_triplets *t, const sp_problem *pb, const sp_real *weight)
{
    const int32_t y = 6 * pb->blocks, d = 3 * pb->points;
    t->count = 0;
    for (int32_t c = 0; c < pb->contacts; c++)
        for (int32_t q = 0; q < 3 * pb->contact[c].points; q++)
            sp__aeq_vertex(t, pb, &pb->contact[c], pb->contact[c].point + q / 3, 3, q % 3);
    for (int32_t k = 0; t->i && k < t->count; k++) {
        const int32_t row = t->i[k];
        t->i[k] = t->j[k];
        t->j[k] = row;
        t->x[k] = sp__held(pb, row / 6, (int)(row % 6)) ? 0 : t->x[k] * (weight ? weight[row / 3] : 1);
    }
    for (int32_t k = 0; k < d; k++) sp__triplets_put(t, k, y + k, -1);
    for (int32_t k = 0; k < d + pb->points; k++) sp__triplets_put(t, d + k, y + k, 1);
}

static void sp__explain_size(const sp_problem *pb, sp_qp *qp)
{
    memset(qp, 0, sizeof *qp);
    qp->n = 6 * pb->blocks + 4 * pb->points;
    qp->m = 7 * pb->points;
}

static void sp__explain_carve(sp__explain *g, const sp_problem *pb, int32_t entries, sp_arena *a)
{
    const size_t n = (size_t)g->qp.n, m = (size_t)g->qp.m;
    g->Pp = sp__take(a, n + 1, sizeof *g->Pp);
    g->Pi = sp__take(a, n + 2 * (size_t)pb->points, sizeof *g->Pi);
    g->Px = sp__take(a, n + 2 * (size_t)pb->points, sizeof *g->Px);
    g->q = sp__take(a, n, sizeof *g->q);
    g->l = sp__take(a, m, sizeof *g->l);
    g->u = sp__take(a, m, sizeof *g->u);
    g->x = sp__take(a, n, sizeof *g->x);
    sp__triplets_carve(&g->t, entries, a);
}

/* w^2; of a joint that presses too little to be engaged hardly anything: it closes if nothing speaks against it. */
static sp_real sp__alt_pull(const sp__alt *m, size_t v)
{
    const sp_real w = m->weight[v];
    return w > 0 ? w * w : m->f[v][0] > 0 && m->pin[v] < 2 ? SP__ALT_WEAK : 0;
}

/* P and q; m NULL: only where their entries are. */
SP__APART static void sp__explain_cost(sp__explain *g, const sp_problem *pb, const sp__alt *m)
{
    const int32_t y = 6 * pb->blocks, d = 3 * pb->points;
    int32_t e = 0;
    for (int32_t j = 0; j < g->qp.n; j++) {
        const int32_t v = j < y ? 0 : j < y + d ? (j - y) / 3 : j - y - d, axis = j < y + d ? (j - y) % 3 : 3;
        const sp_real w2 = m && j >= y ? sp__alt_pull(m, (size_t)v) : 0;
        const int rubs = m && j >= y && (m->h[v][0] * m->h[v][0] + m->h[v][1] * m->h[v][1] > 0);
        g->Pp[j] = e;
        g->q[j] = 0;
        for (int32_t k = 1; j >= y + d && k < 3; k++, e++) {
            g->Pi[e] = y + 3 * v + k;
            g->Px[e] = rubs ? m->h[v][k - 1] : 0;
        }
        g->Pi[e] = j;
        g->Px[e] = j < y ? (m ? m->seed->reg : 1) : axis == 0 ? w2 : axis < 3 ? (sp_real)rubs : (sp_real)rubs + SP__ALT_WEAK;
        if (m && j >= y && axis == 0) g->q[j] = w2 * m->c->k.eps;
        if (m && j >= y + d) g->q[j] = -SP__ALT_WEAK * m->slip;
        e++;
    }
    g->Pp[g->qp.n] = e;
}

/* Aeq' y = d;  -eps <= dn <= eta, |dt1|, |dt2| <= eta or, of |dt| <= eta, the square inside;  beta >= least. */
static void sp__explain_bounds(sp__explain *g, const sp_problem *pb, const sp__alt *m)
{
    const int32_t d = 3 * pb->points;
    const sp_real eta = !m ? 1 : m->c->set->coupled.box ? m->c->k.eta : (sp_real)0.7 * m->c->k.eta;
    for (int32_t i = 0; i < g->qp.m; i++) {
        const int normal = i < 2 * d && i % 3 == 0;
        g->l[i] = i < d ? 0 : i >= 2 * d ? (m ? m->least : 0) : normal ? (m ? -m->c->k.eps : 0) : -eta;
        g->u[i] = i < d ? 0 : i >= 2 * d ? SP_QP_INFINITY : normal && m ? m->c->k.eta : eta;
    }
}

/* The program in `a`; m NULL: its shape alone. NULL: it does not fit. */
SP__APART static sp__explain *sp__explain_make(const sp_problem *pb, const sp__alt *m, sp_arena *a)
{
    if (pb->points > INT32_MAX / 512 || pb->blocks > INT32_MAX / 512) return NULL;
    sp__explain *g = sp__take(a, 1, sizeof *g);
    if (!g) return NULL;
    memset(g, 0, sizeof *g);
    sp__explain_size(pb, &g->qp);
    g->t.rows = g->qp.m;
    g->t.cols = g->qp.n;
    sp__explain_entries(&g->t, pb, NULL);
    sp__explain_carve(g, pb, g->t.count, a);
    if (sp__failed(a)) return NULL;
    sp__explain_entries(&g->t, pb, m ? m->c->w->weight : NULL);
    if (sp_csc_from(&g->t, a, &g->A)) return NULL;
    sp__explain_cost(g, pb, m);
    sp__explain_bounds(g, pb, m);
    g->qp.Pp = g->Pp; g->qp.Pi = g->Pi; g->qp.Px = g->Px; g->qp.q = g->q;
    g->qp.Ap = g->A.p; g->qp.Ai = g->A.i; g->qp.Ax = g->A.x;
    g->qp.l = g->l; g->qp.u = g->u;
    return g;
}

static sp_qp_solver sp__alt_solver(const sp_settings *set) { return set->qp_solver ? *set->qp_solver : sp_qp_admm(); }

static size_t sp__explain_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    size_t bytes = 0;
    sp__take(&scratch, 1, 0);                           /* aligned */
    const size_t from = scratch.used;
    sp__explain *g = sp__explain_make(pb, NULL, &scratch);
    const sp_qp_solver solver = sp__alt_solver(set);
    if (!g) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, scratch.used - from);
    if (solver.need) {
        if (solver.need(solver.self, &g->qp, &sp__seed_of(set)->native, scratch, &bytes)) return SIZE_MAX;
        sp__take(&dry, 1, bytes);
        return dry.used;
    }
    sp__take(&dry, (size_t)g->qp.n, sizeof(sp_real));
    sp__take(&dry, (size_t)g->qp.m, sizeof(sp_real));
    return dry.used;
}

/* Bytes of its own arrays. */
SP__APART static size_t sp__alt_own(const sp_problem *pb)
{
    sp_arena dry = sp__arena_dry();
    sp__alt m;
    sp__take(&dry, 1, sizeof m);
    sp__alt_carve(&m, pb, &dry);
    return dry.used;
}

/* Bytes of the alternation; SIZE_MAX: scratch too small. */
static size_t sp__alt_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    if (!set->coupled.rounds) return 0;
    const size_t forces = sp__admm_need(pb, set, scratch), motion = sp__explain_need(pb, set, scratch);
    if (forces == SIZE_MAX || motion == SIZE_MAX) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sp__alt_own(pb));
    sp__take(&dry, 1, forces > motion ? forces : motion);
    return dry.used;
}

/* Scratch for that, from counts alone; 0: too large. */
static size_t sp__alt_scratch(const sp_problem *pb, const sp_settings *set)
{
    const size_t forces = sp__admm_scratch(pb, set);
    if (!forces || pb->points > INT32_MAX / 512 || pb->blocks > INT32_MAX / 512) return 0;
    sp_qp qp;
    sp_arena dry = sp__arena_dry();
    sp__explain_size(pb, &qp);
    const int32_t entries = 43 * pb->points;
    const size_t n = (size_t)qp.n, m = (size_t)qp.m;
    const size_t solver = sp__qp_count(&qp, entries + qp.n + 2 * pb->points, sp__seed_of(set)->native.backend, 0);
    if (!solver) return 0;
    sp__take(&dry, 1, sizeof(sp__explain) + 16 * SP_ALIGN);
    sp__take(&dry, 6 * n + 2 * m + 8, sizeof(sp_real));
    sp__take(&dry, (size_t)entries + n + 1, 2 * sizeof(sp_real) + 3 * sizeof(int32_t));
    sp__take(&dry, 1, solver);
    if (sp__failed(&dry)) return 0;
    return sizeof(sp__cra) + SP_ALIGN + (dry.used > forces ? dry.used : forces);
}

/* E, F, w, h of the round's forces.     returns the number of engaged vertices */
static int32_t sp__alt_engage(sp__alt *m)
{
    const sp__cra *c = m->c;
    sp_real most = 0;
    int32_t engaged = 0;
    for (int32_t v = 0; v < c->pb->points; v++) most = sp__max(most, m->f[v][0]);
    const sp_real least = sp__max(m->seed->floor, m->seed->engaged * most);
    for (int32_t v = 0; v < c->pb->points; v++) {
        const sp_real *f = m->f[v], ft = SP_SQRT(f[1] * f[1] + f[2] * f[2]);
        const int rubs = f[0] > least && ft > least;
        m->weight[v] = f[0] > least ? SP_SQRT(f[0] / most) : 0;
        m->h[v][0] = rubs ? f[1] / ft : 0;
        m->h[v][1] = rubs ? f[2] / ft : 0;
        engaged += f[0] > least;
    }
    return engaged;
}

/* The motion of least squares, beta free, into w->y: (2J'J + reg) y = -2J' (residual of rest). */
SP__APART static void sp__alt_squares(sp__alt *m)
{
    const sp__cra *c = m->c;
    const sp_real weak = SP__ALT_WEAK;
    memset(c->d, 0, 3 * (size_t)c->pb->points * sizeof *c->d);
    memset(c->D, 0, 6 * (size_t)c->pb->points * sizeof *c->D);
    for (size_t v = 0; v < (size_t)c->pb->points; v++) {
        const sp_real w = m->weight[v], x = m->h[v][0], y = m->h[v][1];
        sp_real *D = c->D + 6 * v, *d = c->d + 3 * v;
        D[0] = sp__alt_pull(m, v);
        d[0] = -D[0] * c->k.eps;
        if (!(w > 0 && x * x + y * y > 0)) continue;
        D[3] = y * y + weak * x * x;
        D[4] = (weak - 1) * x * y;
        D[5] = x * x + weak * y * y;
        d[1] = -weak * m->slip * x;
        d[2] = -weak * m->slip * y;
    }
    sp__dual_factor(c->w, SP__GIVEN, c->w->y, m->seed->reg);
    sp__cra_balance(c, c->d, 0);
    sp__dual_solve(c->w, c->w->r, c->w->y);
    sp__cra_rates(c, c->w->y, c->d);
}

/* beta of vertex v that suits its slip. */
static sp_real sp__alt_beta(const sp__alt *m, size_t v)
{
    const sp_real *d = m->c->d + 3 * v;
    return -(d[1] * m->h[v][0] + d[2] * m->h[v][1]);
}

/* Does the motion keep the constraints? To 1e-3 eps: what presses is put into place later. */
static int sp__alt_keeps(const sp__alt *m)
{
    const sp__lengths *k = &m->c->k;
    for (size_t v = 0; v < (size_t)m->c->pb->points; v++) {
        const sp_real *d = m->c->d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]);
        const sp_real most = m->c->set->coupled.box ? sp__max(sp__abs(d[1]), sp__abs(d[2])) : slip;
        if (d[0] < -k->eps - (sp_real)1e-3 || sp__max(d[0], most) > k->eta) return 0;
        if (m->h[v][0] * m->h[v][0] + m->h[v][1] * m->h[v][1] > 0 && sp__alt_beta(m, v) < m->least) return 0;
    }
    return 1;
}

/* What is left for a program.     returns 0 when it is too little */
static int sp__alt_left(const sp__cra *c, const sp_qp *qp, sp_qp_settings *set)
{
    if (c->set->budget <= 0) return 1;
    set->budget = c->w->limit - c->out->cost.flops;
    if (set->budget < sp__program_least(qp)) c->w->spent = 1;
    return !c->w->spent;
}

/* What a program cost.     returns whether it is solved; `close`: nearly will do */
static int sp__alt_solved(const sp__cra *c, const sp_qp_result *r, int close)
{
    c->out->cost.flops += r->flops;
    c->out->cost.factorisations += r->factorisations;
    c->out->cost.iterations += r->iterations;
    if (r->status == SP_QP_BUDGET) c->w->spent = 1;
    return r->x && (r->status == SP_QP_SOLVED || (close && r->status == SP_QP_INACCURATE));
}

/* The same under its constraints.     returns 1, 0: no answer */
SP__APART static int sp__alt_explain(sp__alt *m)
{
    const sp__cra *c = m->c;
    const size_t n = 6 * (size_t)c->pb->blocks, d = 3 * (size_t)c->pb->points;
    sp_arena a = m->rest;
    sp__explain *g = sp__explain_make(c->pb, m, &a);
    const sp_qp_solver solver = sp__alt_solver(c->set);
    if (!g) return 0;
    memcpy(g->x, c->w->y, n * sizeof *g->x);
    memcpy(g->x + n, c->d, d * sizeof *g->x);
    for (size_t v = 0; v < d / 3; v++) g->x[n + d + v] = sp__max(sp__alt_beta(m, v), m->least);
    g->set = m->seed->native;
    if (!sp__alt_left(c, &g->qp, &g->set)) return 0;
    if (solver.solve(solver.self, &g->qp, &g->set, &a, g->x, NULL, &g->r)) return 0;
    if (!sp__alt_solved(c, &g->r, 1)) return 0;
    for (size_t k = 0; k < n; k++) if (!sp__finite(g->r.x[k])) return 0;
    memcpy(c->w->y, g->r.x, n * sizeof *c->w->y);
    sp__cra_rates(c, c->w->y, c->d);
    return 1;
}

/* w |dn + eps| at vertex v, in L. */
static sp_real sp__alt_gap(const sp__alt *m, size_t v)
{
    return m->weight[v] * sp__abs(m->c->d[3 * v] + m->c->k.eps);
}

/* What the motion does not explain loses its force: of E the worst, of F what is askew.     returns how many were pinned */
static int32_t sp__alt_peel(sp__alt *m, sp_real worst)
{
    const sp_real most = sp__max(m->seed->gate, m->seed->peel * worst);
    int32_t pinned = 0;
    for (size_t v = 0; v < (size_t)m->c->pb->points; v++) {
        const sp_real *d = m->c->d + 3 * v, beta = sp__max(sp__alt_beta(m, v), 0);
        const sp_real x = d[1] + beta * m->h[v][0], y = d[2] + beta * m->h[v][1];
        const int rubs = m->h[v][0] * m->h[v][0] + m->h[v][1] * m->h[v][1] > 0;
        const int32_t pin = sp__alt_gap(m, v) > most ? 2 : rubs && SP_SQRT(x * x + y * y) > m->seed->askew ? 1 : 0;
        if (pin <= m->pin[v]) continue;
        m->pin[v] = pin;
        pinned++;
    }
    return pinned;
}

/* Forces anew, columns of what is pinned out of A.     returns 1; 0: none, or with tension */
SP__APART static int sp__alt_forces(sp__alt *m)
{
    const sp__cra *c = m->c;
    sp_arena a = m->rest;
    sp__program *g = sp__program_make(c->pb, c->set, NULL, &a);
    if (!g) return 0;
    for (int32_t j = 0; j < g->qp.n; j++)
        if (m->pin[j / 4] > (j % 4 < 2))
            for (int32_t k = g->at.Ap[j]; k < g->at.Ap[j + 1]; k++) g->at.Ax[k] = 0;
    if (!sp__alt_left(c, &g->qp, &g->set)) return 0;
    if (g->solver.solve(g->solver.self, &g->qp, &g->set, &a, NULL, NULL, &g->r)) return 0;
    if (!sp__alt_solved(c, &g->r, 0)) return 0;
    sp_real press = 0, pull = 0;
    for (size_t v = 0; v < (size_t)c->pb->points; v++) {
        const sp_real *x = g->r.x + 4 * v, by = g->unit / c->w->unit;
        for (int k = 0; k < 3; k++) {
            m->f[v][k] = m->pin[v] > (k == 0) ? 0 : by * (k ? x[k + 1] : x[0] - x[1]);
            if (!sp__finite(m->f[v][k])) return 0;
        }
        press = sp__max(press, x[0]);
        pull = sp__max(pull, x[1]);
    }
    return sp__ratio(pull, press) <= m->seed->tension;
}

/* f = a e + b g in each closed vertex: e = n, g = n - reach dt / |dt|; a in lam, b in cap, from the round's forces.
 * The derivative for a step in proportion to a and b:  D = a e e' + b g g'. */
SP__APART static void sp__alt_spread(const sp__alt *m, int first)
{
    const sp__cra *c = m->c;
    for (int32_t q = 0; q < c->pb->contacts; q++) {
        const sp_contact *t = &c->pb->contact[q];
        const sp_real s = sp__cra_sbar(c, t);
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            const sp_real *d = c->d + 3 * v, slip = SP_SQRT(d[1] * d[1] + d[2] * d[2]), reach = sp__cra_reach(c, t, d);
            const int rubs = slip > 2 * SP__SLIP && reach > 0;
            const sp_real x = rubs ? -reach * d[1] / slip : 0, y = rubs ? -reach * d[2] / slip : 0;
            sp_real *f = c->f + 3 * v, *D = c->D + 6 * v;
            if (first) {
                const sp_real along = rubs ? sp__max(m->f[v][1] * x + m->f[v][2] * y, 0) / (reach * reach) : 0;
                const int closed = sp__abs(d[0] + c->k.eps) <= SP__GIVE / 2;
                c->cap[v] = closed && rubs ? sp__max(along, (sp_real)0.01 * s) : 0;
                c->lam[v] = closed ? sp__max(m->f[v][0] - along, (sp_real)0.01 * s) : 0;
            }
            const sp_real a = c->lam[v], b = c->cap[v], A = a / c->most, B = b / c->most;
            f[0] = a + b;
            f[1] = b * x;
            f[2] = b * y;
            D[0] = A + B;
            D[1] = B * x; D[2] = B * y;
            D[3] = B * x * x; D[4] = B * x * y; D[5] = B * y * y;
        }
    }
}

/* One step towards balance that keeps a and b positive: df = -D Aeq' z, Aeq D Aeq' z = Aeq f + p. */
SP__APART static void sp__alt_step(const sp__alt *m)
{
    const sp__cra *c = m->c;
    sp__dual *w = c->w;
    sp_real least = -1;
    sp__dual_factor(w, SP__GIVEN, w->y, SP__SHIFT);
    sp__dual_solve(w, w->r, w->d);
    for (int pass = 0; pass < 2; pass++)
        for (int32_t q = 0; q < c->pb->contacts; q++) {
            const sp_contact *t = &c->pb->contact[q];
            sp_real V[3], W[3], u[3];
            sp__dual_twist(w, t, w->d, V, W);
            for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
                const sp_real *f = c->f + 3 * v, b = c->cap[v];
                sp__dual_rate(w, V, W, c->pb->local[v], u);
                const sp_real ge = u[0], gg = u[0] + (b > 0 ? (f[1] * u[1] + f[2] * u[2]) / b : 0), k = 1 / c->most;
                if (!pass) least = sp__max(least, sp__max(ge, gg) * k);
                else {
                    const sp_real by = least > (sp_real)0.9 ? (sp_real)0.9 / least : 1;
                    c->lam[v] -= by * k * c->lam[v] * ge;
                    c->cap[v] -= by * k * b * gg;
                }
            }
        }
}

/* Forces along the motion's slips where it presses, and the triple to the judge.     returns 1 when it is verified */
static int sp__alt_offer(sp__alt *m)
{
    sp__cra *c = m->c;
    for (size_t v = 0; v < (size_t)c->pb->points; v++)
        c->f[3 * v] = m->weight[v] > 0 || (sp__alt_pull(m, v) > 0 && sp__abs(c->d[3 * v] + c->k.eps) <= (sp_real)0.01);
    sp__cra_press(c);
    for (int step = 0; step < SP__ALT_STEPS; step++) {
        sp__alt_spread(m, !step);
        sp__cra_balance(c, c->f, 1);
        if (sp__dual_norm(c->w, c->w->r) <= 32 * (sp_real)SP_EPSILON * c->w->load) break;
        sp__alt_step(m);
    }
    sp__alt_spread(m, 0);
    return sp__cra_offer(c);
}

/* Rounds of forces and motion.     returns 1 when a triple is verified, -1: no memory */
static int sp__alternate(sp__cra *c, sp_arena *a)
{
    sp__alt *m = sp__take(a, 1, sizeof *m);
    if (!m) return -1;
    memset(m, 0, sizeof *m);
    sp__alt_carve(m, c->pb, a);
    if (sp__failed(a)) return -1;
    m->c = c;
    m->seed = sp__seed_of(c->set);
    m->rest = *a;
    m->slip = c->k.eps > 0 && c->k.eta > 10 ? 1 : c->k.eta / 10;
    m->least = sp__max(m->slip / 1000, 4 * SP__SLIP);
    memset(m->pin, 0, (size_t)c->pb->points * sizeof *m->pin);
    for (size_t v = 0; v < (size_t)c->pb->points; v++) sp__scale3(1 / c->w->unit, c->statics + 3 * v, m->f[v]);
    while (c->out->rounds < c->set->coupled.rounds) {
        sp_real worst = 0;
        c->out->rounds++;
        if (!sp__alt_engage(m)) return 0;
        sp__alt_squares(m);
        if (!sp__alt_keeps(m) && !sp__alt_explain(m)) return 0;
        for (size_t v = 0; v < (size_t)c->pb->points; v++) worst = sp__max(worst, sp__alt_gap(m, v));
        const int32_t pinned = sp__alt_peel(m, worst);
        const int passes = worst <= m->seed->gate;
        if (passes && sp__alt_offer(m)) return 1;
        if (!pinned && !passes) return 0;
        if (!pinned) memcpy(m->f, c->f, (size_t)c->pb->points * sizeof *m->f);
        else if (!sp__alt_forces(m)) return 0;
    }
    return 0;
}
#else
static size_t sp__alt_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    (void)pb; (void)set; (void)scratch;
    return 0;
}

static int sp__alternate(sp__cra *c, sp_arena *a) { (void)c; (void)a; return 0; }
#endif

/* The dual, for work up to `limit`; flat (may be NULL): in 3 rows. */
static int sp__cra_open(sp__cra *c, int64_t limit, sp__flat *flat, sp_arena *a)
{
    c->w = sp__dual_make(c->pb, c->set, SP__MOTION, flat, &c->out->cost, a);
    if (!c->w) return 0;
    c->w->limit = limit;
    c->w->given = c->D;
    return 1;
}

/* Its scales. */
static void sp__cra_begin(const sp__cra *c)
{
    sp__dual_bilateral(c->w);
    sp__dual_sizes(c->w, c->w->y);
    if (sp__dual_metric(c->w)) sp__dual_bilateral(c->w);
}

/* Is there a plane to search in? The seed's search takes the scene as it is. */
static int sp__cra_mirror(const sp_problem *pb, const sp_settings *set, sp__flat *o)
{
#ifndef SP_NO_PLAN
    return !set->coupled.rounds && sp__flat_choose(pb, set, o) && o->mode == SP__PLANE;
#else
    (void)pb; (void)set; (void)o;
    return 0;
#endif
}

SP__APART static size_t sp__coupled_need(const sp_problem *pb, const sp_settings *set, size_t turns, sp_arena scratch)
{
    sp_arena room = scratch;
    sp__flat *o = sp__take(&room, 1, sizeof *o);
    if (!o) return SIZE_MAX;
    const size_t dual = sp__dual_most(pb, set, 0, 0, sp__cra_mirror(pb, set, o) ? o : NULL, room);
    sp__cra *c = sp__take(&scratch, 1, sizeof *c);
    if (!c || dual == SIZE_MAX || turns == SIZE_MAX) return SIZE_MAX;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *c);
    sp__triple_carve(&c->t, pb, &dry);
    sp__cra_carve(c, pb, set->localise, &dry);
    sp__take(&dry, 1, sp__judge_need(pb, set));
    sp_arena branch = dry;
    sp__take(&branch, 1, sp__branch_need(pb, set));
    sp__take(&dry, 1, dual);
    if (turns) sp__take(&dry, 1, turns);
    return dry.used > branch.used ? dry.used : branch.used;
}

/* The forces of statics, all at rest. */
static void sp__cra_rest(sp__cra *c, sp_real omega)
{
    memcpy(c->t.f, c->statics, (size_t)c->pb->points * 3 * sizeof *c->t.f);
    memset(c->t.dq, 0, (size_t)c->pb->blocks * 6 * sizeof *c->t.dq);
    memset(c->t.alpha, 0, (size_t)c->pb->points * sizeof *c->t.alpha);
    c->omega = omega;
    c->residual = sp__judge_coupled(&c->j, &c->k, c->t.f, c->t.dq, c->t.alpha);
}

/* Is a forest told without a search? Not where nothing may be left out, or the seed's search is asked. */
static int sp__hangs(const sp_settings *set) { return !set->coupled.rounds && set->iterations >= SP__ITERATIONS; }

/* The contact graph: supports one node, the joints of two nodes one edge if they have one normal, a seam. */
typedef struct sp__forest {
    int32_t *seam;                      /* contacts, those of one edge together */
    int32_t *degree, *join, *order;     /* of blocks; join: where the only edge left begins in seam; order: leaves first */
} sp__forest;

/* Do the joints i and j, in order of their nodes, belong to different edges?     1: i first, -1: j first, 0: to one */
static int sp__seam_order(const sp_problem *pb, int32_t i, int32_t j)
{
    const sp_contact *s = &pb->contact[i], *t = &pb->contact[j];
    const int32_t lo = s->a < s->b ? s->a : s->b, low = t->a < t->b ? t->a : t->b;
    const int32_t hi = s->a + s->b - lo, high = t->a + t->b - low;
    return lo != low ? (lo < low ? 1 : -1) : hi < high ? 1 : hi > high ? -1 : 0;
}

static int sp__seam_before(const void *what, int32_t i, int32_t j)
{
    const int order = sp__seam_order(what, i, j);
    return order ? order > 0 : i < j;
}

/* Seams.     returns 0 where joints of the same two nodes have two normals, a ring */
SP__APART static int sp__forest_seams(const sp_problem *pb, sp__forest *g)
{
    for (int32_t q = 0; q < pb->contacts; q++) g->seam[q] = q;
    sp__sort(g->seam, pb->contacts, sp__seam_before, pb);
    for (int32_t k = 1; k < pb->contacts; k++) {
        const sp_contact *s = &pb->contact[g->seam[k - 1]], *t = &pb->contact[g->seam[k]];
        sp_real x[3];
        if (sp__seam_order(pb, g->seam[k - 1], g->seam[k])) continue;
        sp__cross3(s->joint->n, t->joint->n, x);
        if (!(sp__norm3(x) <= SP__GIVE) || (sp__dot3(s->joint->n, t->joint->n) > 0) != (s->a == t->a)) return 0;
    }
    return 1;
}

/* Leaves first: block order[k] goes with its only edge left, join[order[k]].
 *   returns 1 when no block stays: a forest that hangs on the supports; 0: it does not, or no memory */
SP__APART static int sp__forest_of(const sp_problem *pb, sp__forest *g, sp_arena *a)
{
    const size_t b = (size_t)pb->blocks;
    int32_t n = 0;
    g->seam = sp__take(a, (size_t)pb->contacts, sizeof *g->seam);
    g->degree = sp__take(a, b, sizeof *g->degree);
    g->join = sp__take(a, b, sizeof *g->join);
    g->order = sp__take(a, b, sizeof *g->order);
    if (sp__failed(a) || !sp__forest_seams(pb, g)) return 0;
    for (size_t i = 0; i < b; i++) g->degree[i] = g->join[i] = 0;
    for (int32_t k = 0; k < pb->contacts; k++) {
        const sp_contact *t = &pb->contact[g->seam[k]];
        if (k && !sp__seam_order(pb, g->seam[k - 1], g->seam[k])) continue;
        if (t->a >= 0) { g->degree[t->a]++; g->join[t->a] ^= k; }       /* of a single edge left its number */
        if (t->b >= 0) { g->degree[t->b]++; g->join[t->b] ^= k; }
    }
    for (int32_t i = 0; i < pb->blocks; i++)
        for (int32_t v = i; v >= 0 && g->degree[v] == 1;) {
            const sp_contact *t = &pb->contact[g->seam[g->join[v]]];
            const int32_t u = t->a == v ? t->b : t->a;
            g->order[n++] = v;
            g->degree[v] = 0;
            if (u >= 0) { g->degree[u]--; g->join[u] ^= g->join[v]; }
            v = u;
        }
    return n == pb->blocks;
}

/* Friction of an edge, on the B side of its first joint, spread as its pressure, and the slip against it:
 * g(r) = G + w x (r - o). */
typedef struct sp__plate {
    const sp_contact *first;
    int32_t from, to;                   /* of seam */
    sp_real o[3], G[3], w[3], F, I, M;
} sp__plate;

static void sp__plate_at(const sp__plate *p, const sp_real r[3], sp_real g[3])
{
    sp_real arm[3];
    sp__sub3(r, p->o, arm);
    sp__cross3(p->w, arm, g);
    for (int k = 0; k < 3; k++) g[k] += p->G[k];
}

/* +1, or -1 for a joint whose A is the other's B. */
static sp_real sp__plate_side(const sp__plate *p, const sp_contact *t) { return t->b == p->first->b ? (sp_real)1 : (sp_real)-1; }

/* Friction that statics found at point v of contact t, on the B side of the first. */
static void sp__plate_friction(const sp__cra *c, const sp__plate *p, const sp_contact *t, int32_t v, sp_real ft[3])
{
    const sp_real *f = c->statics + 3 * (size_t)v, side = sp__plate_side(p, t);
    for (int k = 0; k < 3; k++) ft[k] = side * (f[1] * t->joint->t1[k] + f[2] * t->joint->t2[k]);
}

/* One of four sums over an edge:  0 F, F o;  1 Ft;  2 I, Mn;  3 the largest |g|, returned. */
SP__APART static sp_real sp__plate_sum(const sp__cra *c, const sp__forest *g, sp__plate *p, int pass)
{
    const sp_scene *scene = c->pb->scene;
    const sp_real *at = scene->point[p->first->point];
    sp_real most = 0;
    for (int32_t k = p->from; k < p->to; k++) {
        const sp_contact *t = &c->pb->contact[g->seam[k]];
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            const sp_real fn = c->statics[3 * (size_t)v];
            sp_real x[3], y[3], ft[3];
            sp__plate_friction(c, p, t, v, ft);
            sp__sub3(scene->point[v], pass ? p->o : at, x);
            sp__cross3(p->first->joint->n, x, y);
            if (pass == 0) { p->F += fn; for (int q = 0; q < 3; q++) p->o[q] += fn * x[q]; }
            if (pass == 1) for (int q = 0; q < 3; q++) p->G[q] += ft[q];
            if (pass == 2) { p->I += fn * sp__dot3(y, y); p->M += sp__dot3(ft, y); }
            if (pass < 3) continue;
            sp__plate_at(p, scene->point[v], x);
            most = sp__max(most, sp__norm3(x));
        }
    }
    return most;
}

/* G = Ft / F, w = Mn / I n;  F = sum fn, o = sum fn r / F, I = sum fn |n x (r - o)|^2, Ft and Mn: friction and its moment
 * about o.     returns the largest |g| of the edge's vertices */
SP__APART static sp_real sp__plate_of(const sp__cra *c, const sp__forest *g, int32_t from, sp__plate *p)
{
    memset(p, 0, sizeof *p);
    p->first = &c->pb->contact[g->seam[from]];
    p->from = from;
    for (p->to = from + 1; p->to < c->pb->contacts && !sp__seam_order(c->pb, g->seam[from], g->seam[p->to]);) p->to++;
    sp__plate_sum(c, g, p, 0);
    if (!(p->F > 0)) return 0;
    for (int k = 0; k < 3; k++) p->o[k] = c->pb->scene->point[p->first->point][k] + p->o[k] / p->F;
    for (int pass = 1; pass < 3; pass++) sp__plate_sum(c, g, p, pass);
    sp__scale3(1 / p->F, p->G, p->G);
    if (p->I > 0) sp__scale3(p->M / p->I, p->first->joint->n, p->w);
    return sp__plate_sum(c, g, p, 3);
}

/* dq of block v from that of the block or support on the other side of the edge: sinking by eps, slip -s g. */
SP__APART static void sp__plate_carry(const sp__cra *c, int32_t v, const sp__plate *p, sp_real s)
{
    const sp_contact *t = p->first;
    const sp_problem *pb = c->pb;
    const int32_t u = t->a == v ? t->b : t->a;
    const sp_real sign = t->b == v ? (sp_real)1 : (sp_real)-1, *at = pb->scene->block[pb->block[v]].centroid;
    sp_real *m = c->t.dq + 6 * (size_t)v, g[3];
    sp__plate_at(p, at, g);
    for (int k = 0; k < 3; k++) {
        m[k] = -sign * (c->k.eps * c->k.L * t->joint->n[k] + s * g[k]);
        m[k + 3] = -sign * s * p->w[k];
    }
    if (u < 0) return;
    const sp_real *from = c->t.dq + 6 * (size_t)u;
    sp_real arm[3], x[3];
    sp__sub3(at, pb->scene->block[pb->block[u]].centroid, arm);
    sp__cross3(from + 3, arm, x);
    for (int k = 0; k < 3; k++) { m[k] += from[k] + x[k]; m[k + 3] += from[k + 3]; }
}

/* f and alpha of an edge. */
SP__APART static void sp__plate_lay(const sp__cra *c, const sp__forest *g, const sp__plate *p, sp_real s)
{
    for (int32_t k = p->from; k < p->to; k++) {
        const sp_contact *t = &c->pb->contact[g->seam[k]];
        for (size_t v = (size_t)t->point; v < (size_t)t->point + (size_t)t->points; v++) {
            sp_real *f = c->t.f + 3 * v, x[3];
            sp__plate_at(p, c->pb->scene->point[v], x);
            f[0] = c->statics[3 * v];
            f[1] = sp__plate_side(p, t) * f[0] * sp__dot3(x, t->joint->t1);
            f[2] = sp__plate_side(p, t) * f[0] * sp__dot3(x, t->joint->t2);
            c->t.alpha[v] = s > 0 ? f[0] / s : 0;
        }
    }
}

/* Where the edges hang the free blocks on the supports as a forest nothing need be searched for: how the sides of an edge move
 * against each other can be chosen for each of them. All sink by eps, dn = -eps at every vertex, and slip like a plate whose
 * drag is its pressure (sp__plate_of):
 *
 *     ft = fn g(r),    dt = -s g(r),    alpha = fn / s      s > 0 as small as eta likes
 *
 * Their sum and moment are those of the friction that statics found, and fn stays, so balance stays; [K 8-10] hold whatever eps and
 * eta. What is left is |g| <= mu: of forces in their cones |Ft| <= mu F, so it holds where friction has no moment about the normal,
 * and else the judge tells. One cycle, and slips are not free: the H model's block lies between two contacts with supports, the
 * beam snug between a wall and an upright in a ring through the ground, although it has no self-stress.
 *   returns 1 when the triple is verified */
SP__APART static int sp__cra_hang(sp__cra *c, sp_arena a)
{
    const sp_problem *pb = c->pb;
    const sp_real omega = c->omega;
    sp__forest g;
    if (!sp__hangs(c->set) || !sp__forest_of(pb, &g, &a)) return 0;
    for (int32_t k = pb->blocks; k-- > 0;) {
        sp__plate p;
        const sp_real most = sp__plate_of(c, &g, g.join[g.order[k]], &p), slip = c->k.L * (c->k.eta < 2 ? c->k.eta / 2 : 1);
        const sp_real s = most > 0 ? slip / most : 0;
        sp__plate_carry(c, g.order[k], &p, s);
        sp__plate_lay(c, &g, &p, s);
    }
    c->out->cost.flops += 240 * (int64_t)pb->points;
    c->omega = sp__judge_forces(&c->j, c->t.f, c->t.f);
    c->residual = sp__judge_coupled(&c->j, &c->k, c->t.f, c->t.dq, c->t.alpha);
    if (c->omega <= c->set->tol && c->residual <= 1) return 1;
    sp__cra_rest(c, omega);
    return 0;
}

/* The motion of the free blocks into the scene's; where the judge takes spins off they stay off, also among other islands. */
static void sp__cra_spread(const sp__cra *c)
{
    const sp_problem *pb = c->pb;
    const int few = sp__points_count(pb->scene) <= SP_EXACT_POINTS;
    for (int32_t i = 0; i < pb->blocks; i++) {
        if (few) sp__judge_stop(&c->j, i, c->t.dq + 6 * (size_t)i);
        memcpy(c->out->dq + 6 * (size_t)pb->block[i], c->t.dq + 6 * (size_t)i, 6 * sizeof *c->t.dq);
    }
    memcpy(c->out->alpha, c->t.alpha, (size_t)pb->points * sizeof *c->t.alpha);
}

/* The triple on offer is verified: into the result. */
static void sp__cra_found(const sp__cra *c, sp_state *state, sp_real *omega)
{
    c->out->verdict = SP_COUPLING_COUPLED;
    c->out->reason = SP_COUPLING_MOTION;
    memcpy(state->f, c->t.f, (size_t)c->pb->points * 3 * sizeof *c->t.f);
    *omega = c->omega;
}

/* The judge's scales once more, from a hint or none. */
static void sp__coupled_scales(sp__cra *c, const sp_real *y0)
{
    const int32_t before = c->j.sweeps;
    sp__judge_scales(&c->j, y0);
    c->out->cost.flops += SP__FLOPS_JUDGE * (int64_t)(c->j.sweeps - before) * c->pb->points;
}

/* No triple was found: is there none? With mu = 0 this is one programme that tells either way: ft = 0, alpha = 0, and what is left is
 * linear. Forces fn >= 0 that balance with the least g sum fn, and the multipliers dq of balance, dn >= -g, meet fn (dn + g) = 0,
 * because g sum fn = p . dq: a triple, where |d| <= eta. The root of the decision is that programme, |d| <= eta among its rows. */
SP__APART static sp_status sp__coupled_decide(sp__cra *c, sp_state *state, sp_real *omega, sp_arena *a)
{
    int slick = 1;
    for (int32_t q = 0; q < c->pb->contacts; q++) if (c->pb->contact[q].joint->joint.mu > 0) slick = 0;
    const int same = sizeof(sp_real) == 8 && c->set->budget <= 0 && sp__branch_need(c->pb, c->set) > 0;   /* float needs it */
    if (same) sp__coupled_scales(c, NULL);              /* rounding of the search before is nothing that its tree hangs on */
    const sp_status status = sp__branch_decide(c->pb, c->set, &c->j, &c->k, state->left, slick ? &c->t : NULL, a, c->out);
    if (same) sp__coupled_scales(c, state->has_y0 ? state->y0 : NULL);
    if (status || !slick || c->out->reason != SP_COUPLING_LIMIT) return status;
    c->omega = sp__judge_forces(&c->j, c->t.f, c->t.f);
    c->residual = sp__judge_coupled(&c->j, &c->k, c->t.f, c->t.dq, c->t.alpha);
    c->out->cost.flops += 2 * SP__FLOPS_JUDGE * (int64_t)c->pb->points;
    c->out->residual = c->residual;
    if (c->omega <= c->set->tol && c->residual <= 1) sp__cra_found(c, state, omega);
    return SP_OK;
}

#ifndef SP_NO_PLAN
/* The search in the plane, where one plane is a mirror of everything (section 11): motions in it that turn about its normal, 3
 * rows a block, corners in pairs. There dt of every corner lies in the plane, so ft = -alpha dt does, too, and mirrored corners
 * carry mirrored forces: what meets the conditions there, forces shared by halves, meets them in space, whose judge has the last
 * word.
 * From rest the search in space would stay in the plane by itself: energy, caps and drags are symmetric, so are Newton's steps.
 * So where this one finds nothing the decision comes before the search in space. That there is nothing in the plane proves
 * nothing: motions that explain forces need not be convex, and the mean of a triple and its image is none.
 *   returns 1 when a triple is verified, 0: none, or there is no such plane (c->mirror tells), -1: no memory */
SP__APART static int sp__cra_plane(sp__cra *c, int64_t left, sp_arena *a)
{
    const size_t mark = a->used;
    const sp_real omega = c->omega;
    const int64_t limit = c->out->cost.flops + SP__CRA_FLOPS;
    sp__flat *o = sp__take(a, 1, sizeof *o);
    int found = 0;
    if (!o) return -1;
    if (sp__cra_mirror(c->pb, c->set, o)) {
        if (!sp__cra_open(c, limit < left ? limit : left, o, a)) return -1;
        memset(c->f, 0, 3 * (size_t)c->pb->points * sizeof *c->f);      /* images keep it */
        sp__cra_begin(c);
        found = sp__cra_search(c);
        c->mirror = 1;
        c->spent = c->w->spent && limit >= left;
    }
    a->used = mark;
    if (found || !c->mirror) return found;
    c->offered = c->tiny = 0;
    sp__cra_rest(c, omega);
    return 0;
}
#endif

/* In space, by search unless one is found, which `found` tells, then the decision. */
SP__APART static sp_status sp__coupled_search(sp__cra *c, int found, sp_state *state, sp_real *omega, sp_arena *a)
{
    const int64_t limit = c->out->cost.flops + SP__CRA_FLOPS;
    const size_t mark = a->used;
    if (!sp__cra_open(c, limit < state->left ? limit : state->left, NULL, a)) return SP_E_MEMORY;
    const size_t turns = a->used, more = sp__alt_need(c->pb, c->set, *a);
    if (more == SIZE_MAX || (more && !sp__take(a, 1, more))) return SP_E_MEMORY;
    a->used = turns;
    if (!found) {
        sp__cra_begin(c);
        found = c->set->coupled.rounds ? sp__alternate(c, a) : sp__cra_search(c);
    }
    if (found < 0) return SP_E_MEMORY;
    c->out->residual = c->residual;
    if (found) sp__cra_found(c, state, omega);
    else if (c->offered && c->tiny) c->out->reason = SP_COUPLING_LIMIT;
    c->spent = c->w->spent && limit >= state->left;
    a->used = mark;
    return found || c->spent || c->mirror ? SP_OK : sp__coupled_decide(c, state, omega, a);
}

/* Is there a triple? In the plane where there is one, then in space, unless that is left out. */
static sp_status sp__coupled_ask(sp__cra *c, sp_state *state, sp_result *r, sp_arena *a)
{
    const int found = c->residual <= 1 || sp__cra_hang(c, *a);
    c->out->cost.flops += SP__FLOPS_JUDGE * (int64_t)c->j.sweeps * c->pb->points;       /* offers pay for themselves */
#ifndef SP_NO_PLAN
    const int plane = found ? 0 : sp__cra_plane(c, state->left, a);
    if (plane < 0) return SP_E_MEMORY;
    if (plane) {
        c->out->residual = c->residual;
        sp__cra_found(c, state, &r->omega);
        return SP_OK;
    }
    if (!found && c->set->effect[SP_EFFECT_DEPTH] == SP_WITHOUT) return SP_OK;
    if (!found && r->effect[SP_EFFECT_DEPTH] == SP_WHY_MIRROR) r->effect[SP_EFFECT_DEPTH] = SP_WHY_CALLED;
    if (c->mirror && !c->spent) {
        const sp_status status = sp__coupled_decide(c, state, &r->omega, a);
        if (status || c->out->verdict != SP_COUPLING_NOT_FOUND) return status;
    }
#endif
    return sp__coupled_search(c, found, state, &r->omega, a);
}

/* Is there a triple? Its forces become state->f. Else, where asked, what the joints would have to carry.
 *   in     r->coupled.verdict, reason: statics, if there are no forces (state->f) to begin with; r->omega of the forces
 *          state->left: flops, ten sweeps or more
 *   out    verdict, reason, residual, rounds, dq, alpha, cost; r->omega of the new forces, r->demand; r->effect: in space after
 *          all */
SP__APART static sp_status sp__coupled_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *a,
                                           sp_result *r)
{
    sp_coupled *out = &r->coupled;
    sp__cra *c = sp__take(a, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    memset(c, 0, sizeof *c);
    sp__triple_carve(&c->t, pb, a);
    sp__cra_carve(c, pb, set->localise, a);
    const int32_t sweeps = sp__budget_sweeps(set, pb, state->left);
    if (!sp__judge_open(&c->j, pb, set, state->has_y0 ? state->y0 : NULL, sweeps, a)) return SP_E_MEMORY;
    const size_t mark = a->used;
    sp__take(a, 1, sp__branch_need(pb, set));           /* whoever finds one: the same memory */
    if (sp__failed(a)) return SP_E_MEMORY;
    a->used = mark;
    c->pb = pb;
    c->set = set;
    c->out = out;
    c->k = sp__coupled_lengths(pb, set);
    c->statics = state->f;
    for (int32_t q = 0; q < pb->contacts; q++) c->most = sp__max(c->most, sp__cra_sbar(c, &pb->contact[q]));
    memset(c->d, 0, (size_t)pb->points * 3 * sizeof *c->d);
    sp__cra_rest(c, r->omega);
    sp_status status = SP_OK;
    if (out->reason != SP_COUPLING_STATICS) status = sp__coupled_ask(c, state, r, a);
    else out->cost.flops += SP__FLOPS_JUDGE * (int64_t)c->j.sweeps * pb->points;
    if (out->verdict != SP_COUPLING_COUPLED && set->localise && c->most > 0 && !status) {
        const int64_t help = out->cost.flops + SP__CRA_FLOPS / 2;
        a->used = mark;
        if (!sp__cra_open(c, help < state->left ? help : state->left, NULL, a)) return SP_E_MEMORY;
        sp__cra_begin(c);
        sp__cra_help(c, r->demand);
    }
    sp__cra_spread(c);
    return status;
}
#endif /* SP_NO_CRA */
/* 25 ------------------------------------------------------------------------------------------------------------- islands */

/* Free blocks that touch, or touch a third, form an island; supports join nothing, because they don't move. A contact's columns
 * of Aeq have rows in one island only, so Aeq is block diagonal by islands and so are Aeq Aeq', the bilateral force f0, the
 * cones and the caps. Hence f balances p if and only if its share in each island balances the loads there, and dq is a
 * mechanism if one of its shares is (p.dq - sum c_v |P_K(u_v)| and what it is compared with are sums over islands; of two
 * ratios the mediant is no less than the smaller). So each is solved as a scene of its own, in the memory of the largest; the
 * worst verdict is that of the whole, and the evidence, put together, is judged on the whole as ever. The same of a coupled check:
 * its conditions are of one vertex each, so triples of all islands are one of the whole, whose shares are triples; with eps and eta
 * of the whole. What refutes an island refutes the whole, and is judged on that island alone. */

typedef struct sp__islands {
    int32_t count;
    int32_t *label;                     /* per block: its island, by lowest block numbers; -1: a support */
    int32_t *rank, *row;                /* per block: number in its island's scene (0: the support there); row among free blocks */
    int32_t *block, *interface, *load;  /* of each island the first, -1: none */
    int32_t *next, *link, *hook;        /* the next block, interface, load of the same island, -1: none */
} sp__islands;

/* May islands be solved apart? Not on a budget, which the first of them might spend. */
static int sp__islands_apart(const sp_settings *set)
{
    return sp__plan_stages(set) && (!set || (set->effect[SP_EFFECT_TOGETHER] != SP_WITH && set->budget <= 0));
}

/* up: root of each free block's island.                                                      returns how many there are */
static int32_t sp__islands_join(const sp_scene *scene, int32_t *up)
{
    int32_t count = 0;
    for (int32_t i = 0; i < scene->count.blocks; i++) up[i] = i;
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        const sp_interface *f = &scene->interface[k];
        if (scene->block[f->a].fixed != SP_FIXED && scene->block[f->b].fixed != SP_FIXED) sp__join(up, f->a, f->b);
    }
    for (int32_t i = 0; i < scene->count.blocks; i++) count += scene->block[i].fixed != SP_FIXED && sp__root(up, i) == i;
    return count;
}

/* Islands that are told apart, 1 where they are not; the most contact vertices and free blocks of those that a proof may tell of. */
typedef struct sp__apart { int32_t islands, points, blocks; } sp__apart;

/* What each island has, by its root. */
SP__APART static void sp__islands_few(const sp_scene *scene, int32_t *up, int32_t *points, int32_t *blocks, sp__apart *o)
{
    const sp_capacity *n = &scene->count;
    o->points = o->blocks = 0;
    for (int32_t i = 0; i < n->blocks; i++) points[i] = blocks[i] = 0;
    for (int32_t k = 0; k < n->interfaces; k++) {
        const sp_interface *f = &scene->interface[k];
        if (sp__contact_counts(scene, f)) points[sp__root(up, scene->block[f->a].fixed != SP_FIXED ? f->a : f->b)] += f->points;
    }
    for (int32_t i = 0; i < n->blocks; i++) if (scene->block[i].fixed != SP_FIXED) blocks[sp__root(up, i)]++;
    for (int32_t i = 0; i < n->blocks; i++) {
        if (points[i] > SP_EXACT_POINTS || blocks[i] > SP_EXACT_POINTS) continue;
        if (points[i] > o->points) o->points = points[i];
        if (blocks[i] > o->blocks) o->blocks = blocks[i];
    }
}

/* How the blocks of a scene are solved.     returns SP_OK, SP_E_MEMORY: scratch too small */
static sp_status sp__islands_count(const sp_scene *scene, const sp_settings *set, sp_arena scratch, sp__apart *o)
{
    sp_problem pb;
    const size_t b = (size_t)scene->count.blocks;
    sp__problem_count(scene, &pb);
    o->islands = 1;
    o->points = sp__points_count(scene);
    o->blocks = pb.blocks;
    if (!sp__islands_apart(set)) return SP_OK;
    int32_t *up = sp__take(&scratch, b, sizeof *up), *points = sp__take(&scratch, b, sizeof *points);
    int32_t *blocks = sp__take(&scratch, b, sizeof *blocks);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    const int32_t count = sp__islands_join(scene, up);
    if (count < 2) return SP_OK;
    o->islands = count;
    sp__islands_few(scene, up, points, blocks, o);
    return SP_OK;
}

/* Tables for up to `count` islands. `label` (may be NULL) lies elsewhere. */
SP__APART static void sp__islands_carve(sp__islands *t, const sp_scene *scene, int32_t count, int32_t *label, sp_arena *a)
{
    const size_t b = (size_t)scene->count.blocks, n = (size_t)count;
    t->count = count;
    t->label = label ? label : sp__take(a, b, sizeof *t->label);
    t->rank = sp__take(a, b, sizeof *t->rank);
    t->row = sp__take(a, b, sizeof *t->row);
    t->next = sp__take(a, b, sizeof *t->next);
    t->link = sp__take(a, (size_t)scene->count.interfaces, sizeof *t->link);
    t->hook = sp__take(a, (size_t)scene->count.loads, sizeof *t->hook);
    t->block = sp__take(a, n, sizeof *t->block);
    t->interface = sp__take(a, n, sizeof *t->interface);
    t->load = sp__take(a, n, sizeof *t->load);
}

/* Item `k` in front of its island's list; supports (-1) are in none. */
static void sp__islands_put(int32_t island, int32_t k, int32_t *first, int32_t *next)
{
    if (island < 0) return;
    next[k] = first[island];
    first[island] = k;
}

/* The island of an interface: that of its free block. */
static int32_t sp__islands_joint(const sp_scene *scene, const sp__islands *t, int32_t k)
{
    const int32_t a = t->label[scene->interface[k].a];
    return a >= 0 ? a : t->label[scene->interface[k].b];
}

/* Labels by lowest block, lists in ascending order. */
SP__APART static void sp__islands_fill(const sp_scene *scene, const sp__islands *t)
{
    const sp_capacity *n = &scene->count;
    int32_t count = 0, row = 0;
    sp__islands_join(scene, t->rank);
    for (int32_t i = 0; i < n->blocks; i++) {
        const int32_t root = scene->block[i].fixed == SP_FIXED ? -1 : sp__root(t->rank, i);     /* root <= i */
        t->label[i] = root < 0 ? -1 : root == i ? count++ : t->label[root];
        t->row[i] = root < 0 ? -1 : row++;
    }
    for (int32_t k = 0; k < t->count; k++) t->block[k] = t->interface[k] = t->load[k] = -1;
    for (int32_t i = n->blocks - 1; i >= 0; i--) sp__islands_put(t->label[i], i, t->block, t->next);
    for (int32_t k = n->interfaces - 1; k >= 0; k--) sp__islands_put(sp__islands_joint(scene, t, k), k, t->interface, t->link);
    for (int32_t k = n->loads - 1; k >= 0; k--) sp__islands_put(t->label[scene->load[k].block], k, t->load, t->hook);
    for (int32_t i = 0; i < n->blocks; i++) t->rank[i] = 0;
    for (int32_t k = 0; k < t->count; k++) {
        int32_t rank = 0;
        for (int32_t i = t->block[k]; i >= 0; i = t->next[i]) t->rank[i] = ++rank;
    }
}

/* What island k has, with one support for all it rests on. */
static void sp__island_size(const sp_scene *scene, const sp__islands *t, int32_t k, sp_capacity *n)
{
    memset(n, 0, sizeof *n);
    n->blocks = 1;
    for (int32_t i = t->block[k]; i >= 0; i = t->next[i]) n->blocks++;
    for (int32_t q = t->interface[k]; q >= 0; q = t->link[q]) {
        n->interfaces++;
        n->points += scene->interface[q].points;
    }
    for (int32_t q = t->load[k]; q >= 0; q = t->hook[q]) n->loads++;
}

/* Island k as a scene of its own in `a`: one support, then its blocks (without meshes), interfaces and loads in their order.
 *     returns NULL when it does not fit */
SP__APART static sp_scene *sp__island_scene(const sp_scene *scene, const sp__islands *t, int32_t k, sp_arena *a)
{
    sp_scene *s = sp__take(a, 1, sizeof *s);
    if (!s) return NULL;
    *s = *scene;
    sp__island_size(scene, t, k, &s->cap);
    sp__scene_carve(s, a);
    if (sp__failed(a)) return NULL;
    s->count = s->cap;
    int32_t n = 0, points = 0;
    s->block[0] = scene->block[t->block[k]];            /* a support near by */
    s->block[0].fixed = SP_FIXED;
    for (int32_t i = t->block[k]; i >= 0; i = t->next[i]) s->block[t->rank[i]] = scene->block[i];
    for (int32_t i = 0; i < s->count.blocks; i++)
        s->block[i].vertex = s->block[i].vertices = s->block[i].face = s->block[i].faces = 0;
    for (int32_t q = t->interface[k]; q >= 0; q = t->link[q]) {
        sp_interface *f = &s->interface[n++];
        *f = scene->interface[q];
        memcpy(s->point + points, scene->point + f->point, (size_t)f->points * sizeof *s->point);
        f->a = t->rank[f->a];
        f->b = t->rank[f->b];
        f->point = points;
        points += f->points;
    }
    n = 0;
    for (int32_t q = t->load[k]; q >= 0; q = t->hook[q]) {
        s->load[n] = scene->load[q];
        s->load[n].block = t->rank[s->load[n].block];
        n++;
    }
    return s;
}

#endif /* SP_SMALL */

/* 26 -------------------------------------------------------------------------------------------------------------- ladder */

SP_API sp_settings sp_settings_default(void)
{
    sp_settings s;
    memset(&s, 0, sizeof s);
#ifdef SP_REAL_FLOAT
    s.tol = (sp_real)1e-4;
#else
    s.tol = (sp_real)1e-9;
#endif
    s.inscribed = 1;
    s.gamma = 1000;
    s.tau = 1;
    s.localise = 1;
    s.iterations = SP__ITERATIONS;
    s.budget = 0;
    s.stage_count = 2;
    s.stage[0] = SP_STAGE_GATES;
    s.stage[1] = SP_STAGE_EXACT;
    s.coupled.eps = -1;
    s.coupled.nodes = -1;
    return s;
}

#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
SP_API sp_settings sp_settings_seed(void)
{
    sp_settings s = sp_settings_default();
#ifndef SP_SMALL
    s.tol = sp__seed.tension;
    s.faces = sp__seed.faces;
    s.inscribed = sp__seed.inscribed;
    s.net = sp__seed.net;
    s.gamma = sp__seed.gamma;
    s.tau = sp__seed.tau;
    s.seed = &sp__seed;
    s.coupled.rounds = sp__seed.turns;
#endif
    s.stage_count = 4;
    s.stage[1] = SP_STAGE_LEAST_SQUARES;
    s.stage[2] = SP_STAGE_POLISH;
    s.stage[3] = SP_STAGE_ADMM;
    s.coupled.nodes = 0;
    return s;
}
#endif

#define SP__FORCES_LEAST ((sp_real)4)   /* least force_bound: eight times what a stone on one point takes */

/* What rounding and the scene have a say in.
 *
 *     force_bound   min(1e6, tol / (10 u)): larger forces round to more than tol. A finer tol brings it down no further than
 *                   SP__FORCES_LEAST: a proof below that says nothing of what stands.
 *     tol           within it a block may miss balance sideways by tol of its forces, where friction holds mu of them: an
 *                   eighth of the least mu at most, or a cube on a slope of 2 mu would stand. */
static void sp__settings_fit(const sp_scene *scene, sp_settings *s)
{
    const sp_real most = s->tol / (10 * (sp_real)SP_EPSILON);
    if (!(s->force_bound > 0)) s->force_bound = sp__max(SP__FORCES_LEAST, most < (sp_real)1e6 ? most : (sp_real)1e6);
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        const sp_real enough = scene->interface[k].joint.mu / 8;
        if (enough > 0 && enough < s->tol) s->tol = sp__max(enough, 4 * (sp_real)SP_EPSILON);
    }
}

#ifndef SP_SMALL
/* What of a table of constants could break a loop or a pyramid. */
static int sp__seed_fits(const sp_seed *s)
{
    return s->faces >= SP__FACES_MIN && s->faces <= SP__FACES_MAX && s->window > 0 && s->rounds >= 0 && s->tension >= 0
        && s->balance > 0 && s->cone >= 0 && s->gain >= 0 && s->gain < 1 && s->engaged >= 0 && s->floor >= 0 && s->reg > 0
        && s->gate >= 0 && s->peel >= 0 && s->askew >= 0;
}

/* The caller's settings, checked and with the automatic values filled in. */
static sp_status sp__settings_resolve(const sp_scene *scene, const sp_settings *in, sp_settings *out)
{
    *out = in ? *in : sp_settings_default();
    if (!(out->tol >= 4 * (sp_real)SP_EPSILON && out->tol <= (sp_real)0.1)) return SP_E_RANGE;
#ifndef SP_NO_CRA
    if (out->coupled.asked && out->tol > SP__COUPLED_TOL) out->tol = SP__COUPLED_TOL;
#endif
    if (!sp__finite(out->force_bound) || out->force_bound < 0) return SP_E_RANGE;
    if (out->faces && (out->faces < 3 || out->faces > 64)) return SP_E_RANGE;
    if (!(out->gamma > 0) || !(out->tau > 0) || !sp__finite(out->gamma) || !sp__finite(out->tau)) return SP_E_RANGE;
    if (out->iterations < 0 || out->budget < 0 || out->stage_count < 1 || out->stage_count > SP_STAGES_MAX) return SP_E_RANGE;
    for (int32_t k = 0; k < out->stage_count; k++) {
        const sp_stage_id id = out->stage[k];
        if (id <= SP_STAGE_NONE || id > SP_STAGE_CUSTOM) return SP_E_ARGUMENT;
#if defined(SP_NO_QP) || defined(SP_NO_ADMM)
        if (id == SP_STAGE_ADMM) return SP_E_UNSUPPORTED;
#endif
        if (id == SP_STAGE_CUSTOM && (!out->custom || !out->custom->run || !out->custom->need)) return SP_E_ARGUMENT;
    }
    if (out->qp_solver && !out->qp_solver->solve) return SP_E_ARGUMENT;
    const sp_coupled_settings *cs = &out->coupled;
    if (!(cs->eps < SP__HUGE) || !sp__finite(cs->eps) || !(cs->eta < SP__HUGE) || cs->eta < 0) return SP_E_RANGE;
    if (cs->rounds < 0 || (cs->eps > 0 && !(cs->eta / cs->eps < SP__HUGE))) return SP_E_RANGE;
#ifdef SP_NO_CRA
    if (out->coupled.asked) return SP_E_UNSUPPORTED;
#endif
#if defined(SP_NO_QP) || defined(SP_NO_ADMM)
    if (out->coupled.asked && out->coupled.rounds) return SP_E_UNSUPPORTED;
#endif
    if (out->seed && !sp__seed_fits(out->seed)) return SP_E_RANGE;
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) {
        const int32_t choice = (int32_t)out->effect[k];
        if (choice < (int32_t)SP_PLANNED || choice > (int32_t)SP_WITHOUT) return SP_E_ARGUMENT;
    }
#ifdef SP_NO_PLAN
    if (out->effect[SP_EFFECT_DEPTH] == SP_WITHOUT) return SP_E_UNSUPPORTED;
#endif
    if (out->coupled.asked && sp__scene_strong(scene)) return SP_E_UNSUPPORTED;
    sp__settings_fit(scene, out);
    return SP_OK;
}

static sp_stage sp__stage(const sp_settings *set, sp_stage_id id)
{
    sp_stage s = { sp__exact_run, sp__exact_need };
    if (id == SP_STAGE_GATES) { s.run = sp__gates_run; s.need = sp__gates_need; }
    if (id == SP_STAGE_LEAST_SQUARES) { s.run = sp__least_squares_run; s.need = sp__sparse_need; }
    if (id == SP_STAGE_DENSE) { s.run = sp__dense_run; s.need = sp__dense_need; }
    if (id == SP_STAGE_POLISH) { s.run = sp__polish_run; s.need = sp__polish_need; }
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
    if (id == SP_STAGE_ADMM) { s.run = sp__admm_run; s.need = sp__admm_need; }
#endif
    if (id == SP_STAGE_CUSTOM) s = *set->custom;
    return s;
}

#else
/* The same of the smallest check: what it does not know it refuses. */
static sp_status sp__settings_resolve(const sp_scene *scene, const sp_settings *in, sp_settings *out)
{
    *out = in ? *in : sp_settings_default();
    if (!(out->tol >= 4 * (sp_real)SP_EPSILON && out->tol <= (sp_real)0.1)) return SP_E_RANGE;
    if (!sp__finite(out->force_bound) || out->force_bound < 0) return SP_E_RANGE;
    if (out->iterations < 0 || out->stage_count < 1 || out->stage_count > SP_STAGES_MAX) return SP_E_RANGE;
    int other = out->faces || out->budget || out->seed || out->coupled.asked || sp__scene_strong(scene);
    for (int k = 0; k < SP_EFFECTS_FORCED; k++) other |= (uint32_t)out->effect[k] > (uint32_t)SP_WITH;
    for (int32_t k = 0; k < out->stage_count; k++) other |= out->stage[k] != SP_STAGE_GATES && out->stage[k] != SP_STAGE_EXACT;
    if (other) return SP_E_UNSUPPORTED;
    sp__settings_fit(scene, out);
    return SP_OK;
}
#endif

#ifndef SP_SMALL
/* What a check keeps: the result's arrays, in front of everything that goes again. */
typedef struct sp__kept {
    sp_real *f, *dq, *y0;
    sp_demand *demand;
    int32_t *island;                    /* where there is more than one */
    sp_island *part;
    sp_real *cdq, *alpha, *penalty;     /* of the coupled check, where it is asked */
    size_t used;                        /* of the arena so far */
    sp_proof proof;
} sp__kept;

static void sp__kept_carve(sp__kept *r, const sp_scene *scene, int32_t free_blocks, const sp__apart *apart, const sp_settings *set,
                           sp_arena *a)
{
    memset(r, 0, sizeof *r);
    r->f = sp__take(a, (size_t)scene->count.points, 3 * sizeof *r->f);
    r->dq = sp__take(a, (size_t)scene->count.blocks, 6 * sizeof *r->dq);
    r->y0 = sp__take(a, (size_t)free_blocks, 12 * sizeof *r->y0);
    r->demand = sp__take(a, (size_t)scene->count.interfaces, sizeof *r->demand);
    if (apart->islands > 1) {
        r->island = sp__take(a, (size_t)scene->count.blocks, sizeof *r->island);
        r->part = sp__take(a, (size_t)apart->islands, sizeof *r->part);
    }
    r->used = a->used;
#ifndef SP_NO_CRA
    if (!set || !set->coupled.asked) return;
    r->cdq = sp__take(a, (size_t)scene->count.blocks, 6 * sizeof *r->cdq);
    r->alpha = sp__take(a, (size_t)scene->count.points, sizeof *r->alpha);
    if (set->localise) r->penalty = sp__take(a, (size_t)scene->count.points, 4 * sizeof *r->penalty);
    r->used = a->used;
    sp__proof_carve(&r->proof, apart->points, apart->blocks, set, a);
#else
    (void)set;
#endif
}

/* Bytes of that. */
SP__APART static size_t sp__kept_need(const sp_scene *scene, int32_t free_blocks, const sp__apart *apart, const sp_settings *set)
{
    sp__kept kept;
    sp_arena dry = sp__arena_dry();
    sp__kept_carve(&kept, scene, free_blocks, apart, set, &dry);
    return dry.used;
}

/* On a budget stages work on arrays of their own, and the result keeps the best of them. */
static void sp__state_carve(sp_state *s, const sp_problem *pb, const sp_settings *set, sp_arena *a)
{
    s->y = sp__take(a, (size_t)pb->blocks, 6 * sizeof *s->y);
    if (set->budget <= 0) return;
    s->f = sp__take(a, (size_t)pb->points, 3 * sizeof *s->f);
    s->dq = sp__take(a, (size_t)pb->blocks, 6 * sizeof *s->dq);
}

/* What a check works on; lies in the arena, behind what it keeps, because it is too large for a small stack. */
typedef struct sp__check {
    sp_settings set;
    sp_problem pb;
    sp_state state;
    sp_result r;
    size_t arrays, kept;                /* of the arena: what the result takes, and that with room for a proof */
} sp__check;

#else
typedef struct sp__check { sp_settings set; sp_problem pb; sp_result r; } sp__check;
#endif

#ifndef SP_SMALL
/* Scratch of a problem and its symbolic step. */
static size_t sp__whole_scratch(const sp_scene *scene, const sp_settings *settings)
{
    sp_problem pb;
    (void)settings;
    sp__problem_count(scene, &pb);
    size_t most = sp__dual_scratch(&pb);
#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)
    for (int32_t k = 0; settings && k < settings->stage_count; k++) {
        if (settings->stage[k] != SP_STAGE_ADMM) continue;
        const size_t need = sp__admm_scratch(&pb, settings);
        if (need == 0) return 0;
        if (need > most) most = need;
    }
#ifndef SP_NO_CRA
    if (settings && settings->coupled.asked && settings->coupled.rounds) {
        const size_t need = sp__alt_scratch(&pb, settings);
        if (need == 0) return 0;
        if (need > most) most = need;
    }
#endif
#endif
    return sp_problem_memory(scene) + SP_ALIGN + most;
}

/* Tables of islands and the largest of their scenes, at most. */
static size_t sp__islands_scratch(const sp_scene *scene)
{
    sp__islands t;
    sp_arena dry = sp__arena_dry();
    sp_capacity n = scene->count;
    n.vertices = n.faces = n.corners = 0;
    n.blocks++;
    sp__take(&dry, 1, sizeof t);
    sp__islands_carve(&t, scene, scene->count.blocks, NULL, &dry);
    sp__take(&dry, 1, sizeof *scene);
    sp__take(&dry, 1, sp_scene_memory(&n));
    return dry.used + 2 * SP_ALIGN;
}

SP_API size_t sp_memory_scratch(const sp_scene *scene, const sp_settings *settings)
{
    if (!scene || (settings && (settings->stage_count < 0 || settings->stage_count > SP_STAGES_MAX))) return 0;
    const size_t whole = sp__whole_scratch(scene, settings);
    return whole ? sizeof(sp__check) + SP_ALIGN + whole + (sp__islands_apart(settings) ? sp__islands_scratch(scene) : 0) : 0;
}

/* The largest need of the chosen stages and of what judges them, SIZE_MAX: scratch too small. */
SP__APART static size_t sp__stages_need(const sp_problem *pb, const sp_settings *set, sp_arena scratch)
{
    const size_t most = sp__judge_need(pb, set);
    size_t work = 0;
    for (int32_t k = 0; k <= set->stage_count && pb->blocks; k++) {
        if (k == set->stage_count && !set->localise) break;
        const size_t need = k < set->stage_count ? sp__stage(set, set->stage[k]).need(pb, set, scratch)
                                                 : sp__flat_need(pb, set, 0, scratch);
        if (need > work) work = need;
    }
    if (!set->work) return most > work ? most : work;
    if (!set->work->base && work > set->work->peak) set->work->peak = work;     /* sp_memory_work asks */
    return work == SIZE_MAX ? work : most;
}

/* Bytes of a problem, its potential and what is done to it; SIZE_MAX: scratch too small. */
static size_t sp__problem_need(const sp_problem *pb, const sp_settings *set, size_t work)
{
    sp_state state;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sp_problem_memory(pb->scene));
    sp__state_carve(&state, pb, set, &dry);
    sp__take(&dry, 1, work);
    return work == SIZE_MAX ? SIZE_MAX : dry.used;
}

/* That of every stage and of the coupled check on the whole of a scene. */
SP__APART static sp_status sp__whole_need(const sp_scene *scene, sp__check *c, sp_arena scratch, size_t *bytes)
{
    const sp_status status = sp_problem_build(scene, &scratch, &c->pb);
    if (status) return status;
    size_t work = sp__stages_need(&c->pb, &c->set, scratch);
#ifndef SP_NO_CRA
    if (c->set.coupled.asked) {
        const size_t need = sp__coupled_need(&c->pb, &c->set, sp__alt_need(&c->pb, &c->set, scratch), scratch);
        if (need > work) work = need;
    }
#endif
    *bytes = sp__problem_need(&c->pb, &c->set, work);
    return *bytes == SIZE_MAX ? SP_E_MEMORY : SP_OK;
}

/* An island's scene, what its check keeps, and `behind`. */
SP__APART static size_t sp__island_bytes(const sp_scene *s, const sp_settings *set, size_t behind)
{
    const sp__apart one = { 1, 0, 0 };                  /* its proof lies with the whole's */
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *s);
    sp__take(&dry, 1, sp_scene_memory(&s->cap));
    sp__take(&dry, 1, sp__kept_need(s, s->count.blocks - 1, &one, set));
    sp__take(&dry, 1, sizeof(sp__check));
    sp__take(&dry, 1, behind);
    return dry.used;
}

/* Bytes that island k takes behind the tables. */
SP__APART static sp_status sp__island_need(const sp_scene *scene, const sp__islands *t, int32_t k, sp__check *c, sp_arena scratch,
                                           size_t *bytes)
{
    const sp_scene *s = sp__island_scene(scene, t, k, &scratch);
    const sp_status status = s ? sp__whole_need(s, c, scratch, bytes) : SP_E_MEMORY;
    if (!status) *bytes = sp__island_bytes(s, &c->set, *bytes);
    return status;
}

/* The way over all islands: where a check is, and what it keeps besides the result. */
typedef struct sp__tour {
    sp__islands t;
    int32_t at, again;                  /* the island, 1: only for its proof */
    int32_t lies;                       /* the proof is still in the room that all share */
    sp_proof proof;                     /* of the last that was refuted */
    sp_real margin;
    size_t start, mark;                 /* of the arena: before this, behind the tables */
} sp__tour;

/* Bytes of the tables and what is `behind`. */
SP__APART static size_t sp__tour_bytes(const sp_scene *scene, int32_t count, size_t behind)
{
    sp__islands t;
    int32_t label = 0;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof(sp__tour));
    sp__islands_carve(&t, scene, count, &label, &dry);
    sp__take(&dry, 1, behind);
    return dry.used;
}

/* Bytes of the tables and the island that wants most. */
SP__APART static sp_status sp__islands_need(const sp_scene *scene, int32_t count, sp__check *c, sp_arena scratch, size_t *bytes)
{
    size_t most = 0;
    sp__islands *t = sp__take(&scratch, 1, sizeof *t);
    if (!t) return SP_E_MEMORY;
    sp__islands_carve(t, scene, count, NULL, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__islands_fill(scene, t);
    for (int32_t k = 0; k < count; k++) {
        const sp_status status = sp__island_need(scene, t, k, c, scratch, bytes);
        if (status) return status;
        if (*bytes > most) most = *bytes;
    }
    *bytes = sp__tour_bytes(scene, count, most);
    return SP_OK;
}

/* Bytes behind what a check keeps: islands apart, then all of them judged; or the whole. */
SP__APART static sp_status sp__work_need(const sp_scene *scene, int32_t islands, sp__check *c, sp_arena scratch, size_t *bytes)
{
    if (islands < 2) return sp__whole_need(scene, c, scratch, bytes);
    sp__problem_count(scene, &c->pb);
    const size_t judged = sp__problem_need(&c->pb, &c->set, sp__judge_need(&c->pb, &c->set));
    const sp_status status = sp__islands_need(scene, islands, c, scratch, bytes);
    if (judged > *bytes) *bytes = judged;
    return status;
}

/* What SP_MEMORY_BYTES takes for granted of structs and sizes that the header does not show, in double and float. */
typedef char sp__memory_bytes_holds[sizeof(sp_real) > 8 || (sizeof(sp__dual) <= 400 && sizeof(sp__yield) <= 64
                                    && sizeof(sp__scale) <= 13 * sizeof(sp_real) && SP__DUAL_H <= 102 && SP_ALIGN == 16) ? 1 : -1];
#ifndef SP_NO_PLAN
typedef char sp__memory_bytes_holds_flat[sizeof(sp_real) > 8 || SP__FLAT_G <= 20 ? 1 : -1];
#endif
#ifndef SP_NO_IPM
typedef char sp__memory_bytes_holds_inner[sizeof(sp_real) > 8 || sizeof(sp__ipm) <= 144 ? 1 : -1];      /* 368 + 144 = 512 */
#endif

#ifndef SP_NO_CRA
typedef char sp__memory_bytes_holds_coupled[sizeof(sp_real) > 8 || (sizeof(sp__cra) <= 448 && sizeof(sp__branch) <= 448
                                            && sizeof(sp__refute) <= 448 && SP__ROWS <= 21 && SP__PROOF_DEPTH <= 32) ? 1 : -1];
#endif
#if !defined SP_NO_QP && !defined SP_NO_ADMM
typedef char sp__memory_bytes_holds_program[sizeof(sp_real) > 8 || sizeof(sp__program) + sizeof(sp__qp) <= 1280 ? 1 : -1];
#endif

/* As sp_memory; work: where not NULL, an arena that only counts in place of settings.work. */
static sp_status sp__memory(const sp_scene *scene, const sp_settings *settings, sp_arena *work, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__apart apart;
    const sp_status counted = sp__islands_count(scene, settings, scratch, &apart);
    sp__check *c = sp__take(&scratch, 1, sizeof *c);
    if (!c || counted) return SP_E_MEMORY;
    sp_status status = sp__settings_resolve(scene, settings, &c->set);
    size_t behind = 0;
    if (work) c->set.work = work;
    if (!status) status = sp__work_need(scene, apart.islands, c, scratch, &behind);
    if (status) return status;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &c->pb);
    sp__take(&dry, 1, sp__kept_need(scene, c->pb.blocks, &apart, &c->set));
    sp__take(&dry, 1, sizeof *c);
    sp__take(&dry, 1, behind);
    *bytes = dry.used;
    return SP_OK;
}

SP_API sp_status sp_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    return sp__memory(scene, settings, NULL, scratch, bytes);
}

SP_API sp_status sp_memory_work(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    sp_arena work = sp__arena_dry();
    const sp_status status = sp__memory(scene, settings, &work, scratch, bytes);
    if (!status) *bytes = work.peak;
    return status;
}

/* Where stages work: memory of its own, or what is left of the check's. */
static sp_arena sp__work_open(const sp_settings *set, const sp_arena *a) { return set->work ? *set->work : *a; }

static void sp__work_close(const sp_settings *set, sp_arena *a, const sp_arena *room)
{
    if (set->work) a = set->work;
    if (room->peak > a->peak) a->peak = room->peak;
}

#endif

/* The judge's motion into a result's dq: scaled so that no point of a block moves farther than the largest block reaches. */
static void sp__check_motion(const sp__judge *j, sp_real *dq)
{
    const sp_problem *pb = j->pb;
    sp_real largest = 0, block = 0;
    for (int32_t i = 0; i < pb->blocks; i++) {
        const sp_real *m = j->x + 6 * (size_t)i;
        block = sp__max(block, j->scale[i].arm);
        largest = sp__max(largest, sp__max(sp__norm3(m), sp__norm3(m + 3) * sp__judge_arm(j, i)));
    }
    const sp_real scale = largest > 0 ? (block > 0 ? block : 1) / largest : 0;
    memset(dq, 0, 6 * (size_t)pb->scene->count.blocks * sizeof *dq);
    for (int32_t i = 0; i < pb->blocks; i++)
        for (size_t k = 0; k < 6; k++) dq[6 * (size_t)pb->block[i] + k] = scale * j->x[6 * (size_t)i + k];
}

#ifndef SP_SMALL
/* Flops that are left of the budget. */
static int64_t sp__budget_left(const sp_settings *set, const sp_result *r)
{
    return set->budget > 0 ? set->budget - r->cost.flops : INT64_MAX / 4;
}

/* Forces smaller than `share` of the largest component are none: dust on what is not loaded no balance of its own forgives. */
static void sp__forces_dust(sp_real *f, int32_t points, sp_real share)
{
    const size_t n = 3 * (size_t)points;
    sp_real most = 0;
    for (size_t k = 0; k < n; k++) most = sp__max(most, sp__abs(f[k]));
    for (size_t k = 0; k < n; k += 3) if (sp__norm3(f + k) < share * most) memset(f + k, 0, 3 * sizeof *f);
}

/* What the state proves, whatever was claimed; its evidence into the result, on a budget if it is better than what is there.
 * Forces are judged unless a motion is claimed, and a motion unless forces are. */
SP__APART static sp_verdict sp__check_judge(sp__judge *j, sp_state *state, sp_verdict claim, sp_result *r)
{
    int32_t final = 0;
    const size_t f = 3 * (size_t)j->pb->points, dq = 6 * (size_t)j->pb->blocks;
    if (!sp__all_finite(state->f, f)) memset(state->f, 0, f * sizeof *state->f);
    if (!sp__all_finite(state->dq, dq)) memset(state->dq, 0, dq * sizeof *state->dq);
    const int own = state->f != r->f;                   /* on a budget */
    sp_real omega = sp__judge_forces(j, state->f, state->f);
    if (omega > (sp_real)0.1 && claim != SP_UNSTABLE && j->sweeps <= j->most) {
        sp__forces_dust(state->f, j->pb->points, (sp_real)1e-6);
        omega = sp__judge_forces(j, state->f, state->f);
    }
    if (own && omega < r->omega) memcpy(r->f, state->f, f * sizeof *r->f);
    if (!own || omega < r->omega) r->omega = omega;
    if (claim != SP_UNSTABLE && omega <= r->tol) return SP_STABLE;
    if (claim == SP_STABLE) return SP_UNDECIDED;
    const sp_real least = sp__judge_mechanism(j, state->dq, &final);
    if (own && least < r->least_imbalance) return SP_UNDECIDED;
    r->least_imbalance = least;
    if (claim != SP_UNSTABLE || least > r->tol) sp__check_motion(j, r->dq);
    if (!(least > r->tol)) return SP_UNDECIDED;
    r->final = final;
    return SP_UNSTABLE;
}

static void sp__cost_add(sp_cost *to, const sp_cost *c)
{
    to->flops += c->flops;
    to->factorisations += c->factorisations;
    to->iterations += c->iterations;
    to->interior += c->interior;
}

/* The reason a result gives: the stage's own, unless the evidence says otherwise. A limit is near where some imbalance is
 * proved or what is left is some tol, and well below 1 where tol is coarse. */
static sp_reason sp__check_reason(sp_stage_id stage, sp_verdict claim, const sp_result *r, sp_reason told)
{
    const int near = r->least_imbalance > 0 || (r->omega <= SP__NEAR * r->tol && r->omega * r->omega <= r->tol);
    if (r->verdict == SP_STABLE) return told == SP_REASON_NOTHING ? told : SP_REASON_FORCES;
    if (r->verdict == SP_UNSTABLE) return claim == SP_UNSTABLE && stage == SP_STAGE_GATES ? told : SP_REASON_MECHANISM;
    if (told == SP_REASON_UNVERIFIED && claim == SP_UNSTABLE && r->least_imbalance > 0) return SP_REASON_LIMIT;
    if (told == SP_REASON_BUDGET || stage != SP_STAGE_EXACT) return told;
    return near ? SP_REASON_LIMIT : SP_REASON_BUDGET;
}

/* The judgement of what a stage left in the state, `most` sweeps for the scales: r->verdict. */
SP__APART static sp_status sp__check_claim(const sp_problem *pb, const sp_settings *set, int32_t most, sp_verdict claim,
                                           sp_state *state, sp_arena *a, sp_result *r)
{
    sp__judge j;
    const size_t mark = a->used;
    if (!sp__judge_open(&j, pb, set, state->has_y0 ? state->y0 : NULL, most, a)) return SP_E_MEMORY;
    r->verdict = sp__check_judge(&j, state, claim, r);
    a->used = mark;
    state->cost.flops += SP__FLOPS_JUDGE * (int64_t)j.sweeps * pb->points;
    return SP_OK;
}

#ifndef SP_NO_PLAN
/* What a search in 3 rows came to. */
typedef struct sp__sought {
    sp_verdict claim;
    int plane, known;                   /* in the plane; its bilateral force is the scene's */
    int spent;                          /* the budget ended it */
} sp__sought;

/* The search in 3 rows, where one is planned, in the memory of the whole search, before it. */
SP__APART static sp_status sp__check_search(const sp_problem *pb, const sp_settings *set, const sp_result *r, sp_state *state,
                                            sp_arena *a, sp__sought *s)
{
    sp_arena room = sp__work_open(set, a);
    sp__flat *o = sp__take(&room, 1, sizeof *o);
    if (!o) return SP_E_MEMORY;
    state->left = sp__budget_left(set, r) - 10 * SP__FLOPS_JUDGE * (int64_t)pb->points;
    if (state->left < 0 || !sp__flat_choose(pb, set, o)) return SP_OK;
    const sp_status status = sp__exact_search(pb, set, o, state, &room, &s->claim);
    s->plane = o->mode == SP__PLANE;
    s->known = s->plane || o->forest;
    s->spent = o->spent;
    sp__work_close(set, a, &room);
    return status;
}

/* f0 by all 6 rows. */
SP__APART static sp_status sp__check_hint(const sp_problem *pb, const sp_settings *set, sp_state *state, const sp_arena *a)
{
    return sp__bilateral_hint(pb, set, state, sp__work_open(set, a));
}

/* What it claims, judged in full. Where its bilateral force is not the scene's: forces by least scales, then all by those of 6 rows,
 * unless there is a budget. What a budget ended is judged, too. */
SP__APART static sp_status sp__check_sought(const sp_problem *pb, const sp_settings *set, const sp__sought *s, sp_state *state,
                                            sp_arena *a, sp_result *r)
{
    const int32_t most = sp__budget_sweeps(set, pb, sp__budget_left(set, r) - state->cost.flops);
    if (s->known) return sp__check_claim(pb, set, most, s->claim, state, a, r);
    if (s->claim != SP_UNSTABLE) {
        const sp_status status = sp__check_claim(pb, set, 0, SP_STABLE, state, a, r);
        if (status || r->verdict == SP_STABLE || !s->claim) return status;
    }
    if (set->budget > 0) return SP_OK;
    const sp_status status = sp__check_hint(pb, set, state, a);
    return status ? status : sp__check_claim(pb, set, INT32_MAX, s->claim, state, a, r);
}

/* What is planar is not tried without friction. Where the third dimension is left out by force nothing comes after. */
SP__APART static sp_status sp__check_reduced(const sp_problem *pb, const sp_settings *set, int32_t k, sp_state *state,
                                             sp_arena *a, sp_result *r, int *done)
{
    sp__sought s = { SP_UNDECIDED, 0, 0, 0 };
    memset(&state->cost, 0, sizeof state->cost);
    sp_status status = sp__check_search(pb, set, r, state, a, &s);
    if (!status && (s.claim || s.spent)) {
        r->verdict = SP_UNDECIDED;
        status = sp__check_sought(pb, set, &s, state, a, r);
        if (r->verdict == SP_UNDECIDED) r->final = 0;
        if (r->verdict == SP_UNDECIDED && !s.spent) r->least_imbalance = 0;
        *done = s.spent || r->verdict != SP_UNDECIDED;
    }
    if (*done && r->verdict != SP_UNDECIDED) {
        r->verified = 1;
        r->stage = set->stage[k];
        r->reason = r->verdict == SP_STABLE ? SP_REASON_FORCES : SP_REASON_MECHANISM;
        r->effect[s.plane ? SP_EFFECT_DEPTH : SP_EFFECT_FRICTION] = s.plane ? SP_WHY_MIRROR : SP_WHY_PRESSURE;
    } else if (*done) r->reason = SP_REASON_BUDGET;
    else if (set->effect[SP_EFFECT_DEPTH] == SP_WITHOUT) {
        r->reason = SP_REASON_EFFECT;
        r->missing = SP_EFFECT_DEPTH;
    }
    sp__cost_add(&r->by_stage[k], &state->cost);
    sp__cost_add(&r->cost, &state->cost);
    return status;
}

#endif /* SP_NO_PLAN */

/* One stage and, if it claims anything or is the last, the judgement of what it found.     *done: the check is decided */
SP__APART static sp_status sp__check_stage(const sp_problem *pb, const sp_settings *set, int32_t k, sp_state *state, sp_arena *a,
                                           sp_result *r, int *done)
{
    sp_verdict claim = SP_UNDECIDED;
    const int last = k + 1 == set->stage_count;
    const int64_t left = sp__budget_left(set, r), judge = 10 * SP__FLOPS_JUDGE * (int64_t)pb->points;
    memset(&state->cost, 0, sizeof state->cost);
    if (left < judge) {
        r->reason = SP_REASON_BUDGET;
        return SP_OK;
    }
    state->left = left - judge;
    sp_arena room = sp__work_open(set, a);
    const sp_status status = sp__stage(set, set->stage[k]).run(pb, set, state, &room, &claim);
    if (status) return status;
    sp__work_close(set, a, &room);
    r->tension_ratio = state->tension_ratio;
    if (claim != SP_STABLE && claim != SP_UNSTABLE) claim = SP_UNDECIDED;
    if (claim || last || (set->budget > 0 && set->stage[k] != SP_STAGE_GATES)) {
        const sp_status judged = sp__check_claim(pb, set, sp__budget_sweeps(set, pb, left - state->cost.flops), claim, state, a, r);
        if (judged) return judged;
        *done = r->verdict != SP_UNDECIDED;
        r->verified = *done;
        r->stage = *done ? set->stage[k] : SP_STAGE_NONE;
        r->reason = sp__check_reason(set->stage[k], claim, r, state->reason);
        if (claim == SP_UNSTABLE && !*done && set->effect[SP_EFFECT_FRICTION] == SP_WITHOUT) {
            r->reason = SP_REASON_EFFECT;
            r->missing = SP_EFFECT_FRICTION;
        }
    }
    sp__cost_add(&r->by_stage[k], &state->cost);
    sp__cost_add(&r->cost, &state->cost);
    return SP_OK;
}

#endif /* SP_SMALL */

/* 27 ---------------------------------------------------------------------------------------------------- reading a result */

/* Weight of the lighter free block of an interface: what a joint that carries next to nothing is measured by. */
static sp_real sp__lesser_weight(const sp_scene *scene, const sp_interface *t)
{
    const sp_block *a = &scene->block[t->a], *b = &scene->block[t->b];
    const sp_real mass = a->fixed == SP_FIXED || (b->fixed != SP_FIXED && b->mass < a->mass) ? b->mass : a->mass;
    return mass * sp__norm3(scene->gravity);
}

SP_API sp_status sp_interface_resultant(const sp_scene *scene, const sp_result *result, int32_t interface,
                                        sp_interface_force *out)
{
    if (!scene || !result || !result->f || !out) return SP_E_ARGUMENT;
    if (interface < 0 || interface >= scene->count.interfaces) return SP_E_INDEX;
    const sp_interface *t = &scene->interface[interface];
    sp_interface_force o;
    sp_real sum[3] = { 0, 0, 0 }, size = 0;
    memset(&o, 0, sizeof o);
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real *f = result->f + 3 * (size_t)v;
        const int first = v == t->point;
        sp__add3(sum, 1, f);
        size += sp__abs(f[0]);
        if (first || f[0] < o.min_fn) o.min_fn = f[0];
        if (first || f[0] > o.max_fn) o.max_fn = f[0];
    }
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        const sp_real share = size > 0 ? sp__abs(result->f[3 * (size_t)v]) / size : 1 / (sp_real)t->points;
        sp_real away[3];
        sp__sub3(scene->point[v], scene->point[t->point], away);
        sp__add3(o.point, share, away);
    }
    sp__add3(o.point, 1, scene->point[t->point]);
    sp__joint_force(t, sum, o.force);
    const sp_real slip = SP_SQRT(sum[1] * sum[1] + sum[2] * sum[2]);
    const sp_real held = sp__max(0, t->joint.mu * sum[0] + t->joint.cohesion * t->area);
    o.utilisation = size + slip > (sp_real)1e-4 * sp__lesser_weight(scene, t) ? sp__ratio(slip, held) : 0;
    *out = o;
    return SP_OK;
}

SP_API sp_status sp_block_resultant(const sp_scene *scene, const sp_result *result, int32_t block, sp_real force[3],
                                    sp_real moment[3])
{
    if (!scene || !result || !result->f || !force || !moment) return SP_E_ARGUMENT;
    if (block < 0 || block >= scene->count.blocks) return SP_E_INDEX;
    for (int k = 0; k < 3; k++) force[k] = moment[k] = 0;
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        const sp_interface *t = &scene->interface[k];
        if (t->a != block && t->b != block) continue;
        const sp_real sign = t->b == block ? (sp_real)1 : (sp_real)-1;
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real F[3], arm[3], m[3];
            sp__joint_force(t, result->f + 3 * (size_t)v, F);
            sp__sub3(scene->point[v], scene->block[block].centroid, arm);
            sp__cross3(arm, F, m);
            sp__add3(force, sign, F);
            sp__add3(moment, sign, m);
        }
    }
    return SP_OK;
}

#ifndef SP_SMALL
/* Reading the force state: extremes over the interfaces, and the weakest of them. */
SP__APART static void sp__check_read(const sp_scene *scene, sp_result *r)
{
    sp_real worst = -1;
    int wants = 0;
    r->weakest = -1;
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        sp_interface_force f;
        if (!sp__contact_counts(scene, &scene->interface[k])) continue;
        sp_interface_resultant(scene, r, k, &f);
        r->max_compression = sp__max(r->max_compression, f.max_fn);
        r->max_tension = sp__max(r->max_tension, r->demand[k].tension);
        r->max_utilisation = sp__max(r->max_utilisation, f.utilisation);
    }
    const sp_real dust = 16 * SP__SCALE_TOL * r->max_compression;
    for (int32_t k = 0; k < scene->count.interfaces; k++) {
        sp_interface_force f;
        if (!sp__contact_counts(scene, &scene->interface[k])) continue;
        sp_interface_resultant(scene, r, k, &f);
        const sp_real help = sp__max(r->demand[k].tension, r->demand[k].friction);
        const int wanted = help > dust;
        const sp_real score = wanted ? help : f.utilisation;
        if (wanted > wants || (wanted == wants && score > worst)) { wants = wanted; worst = score; r->weakest = k; }
    }
}

/* 28 --------------------------------------------------------------------------------------------------------------- check */

/* Where tension is wanted, of what did not turn out stable. */
SP__APART static sp_status sp__check_demand(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *a, sp_result *r)
{
    memset(&state->cost, 0, sizeof state->cost);
    state->left = sp__budget_left(set, r);
    sp_arena room = sp__work_open(set, a);
    const sp_status status = sp__penalty_run(pb, set, state, &room, r->demand);
    sp__cost_add(&r->cost, &state->cost);
    sp__work_close(set, a, &room);
    return status;
}

/* The ladder of stages on a built problem, then the localisation where it does not stand. */
static sp_status sp__check_run(const sp_problem *pb, const sp_settings *set, sp_state *state, sp_arena *a, sp_result *r)
{
    int done = 0;
    for (int32_t k = 0; k < set->stage_count && !done; k++) {
        sp_status status = SP_OK;
#ifndef SP_NO_PLAN
        if (set->stage[k] == SP_STAGE_EXACT) status = sp__check_reduced(pb, set, k, state, a, r, &done);
#endif
        if (!status && !done && r->reason != SP_REASON_EFFECT) status = sp__check_stage(pb, set, k, state, a, r, &done);
        if (status) return status;
    }
    if (r->verdict == SP_STABLE || r->reason == SP_REASON_STAGES || !set->localise) return SP_OK;
    return sp__check_demand(pb, set, state, a, r);
}

#ifndef SP_NO_CRA
/* eps and eta in force. */
SP__APART static void sp__coupled_told_lengths(sp__check *c)
{
    const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
    c->r.coupled.eps = k.eps > 0 ? k.L : 0;
    c->r.coupled.eta = k.L * k.eta;
}

/* The coupled check, where forces were found; its answer, its cost and its forces into the result. */
SP__APART static sp_status sp__check_coupled(sp__check *c, sp_arena *a)
{
    sp_result *r = &c->r;
    sp_coupled *out = &r->coupled;
    const size_t mark = a->used;
    sp_status status = SP_OK;
    sp__coupled_told_lengths(c);
    c->state.left = sp__budget_left(&c->set, r);
    c->state.f = r->f;                                  /* also on a budget */
    if (r->verdict == SP_STABLE) memset(r->dq, 0, 6 * (size_t)c->pb.scene->count.blocks * sizeof *r->dq);
    out->verdict = r->verdict == SP_UNSTABLE ? SP_COUPLING_REFUTED : SP_COUPLING_NOT_FOUND;
    out->reason = r->verdict == SP_STABLE ? SP_COUPLING_BUDGET : SP_COUPLING_STATICS;
    if (!c->pb.blocks) {
        out->verdict = SP_COUPLING_COUPLED;
        out->reason = SP_COUPLING_MOTION;
    } else if (c->state.left >= 10 * SP__FLOPS_JUDGE * (int64_t)c->pb.points && (r->verdict == SP_STABLE || c->set.localise))
        status = sp__coupled_run(&c->pb, &c->set, &c->state, a, r);
    a->used = mark;
    sp__cost_add(&r->cost, &out->cost);
    if (out->verdict == SP_COUPLING_COUPLED && c->pb.blocks && !out->rounds) r->effect[SP_EFFECT_COUPLED] = SP_WHY_FOREST;
    return status;
}

/* What that makes of the verdict of statics.     returns 1: another one */
static int sp__coupled_told(const sp_settings *set, sp_coupling coupling, sp_coupling_reason why, sp_verdict *verdict,
                            sp_reason *reason)
{
    if (coupling <= SP_COUPLING_COUPLED || why == SP_COUPLING_STATICS) return 0;
    const int refuted = coupling == SP_COUPLING_REFUTED;
    *verdict = refuted ? SP_UNSTABLE : SP_UNDECIDED;
    *reason = refuted ? SP_REASON_NO_MOTION : set->effect[SP_EFFECT_DEPTH] == SP_WITHOUT ? SP_REASON_EFFECT : SP_REASON_NOT_COUPLED;
    return 1;
}
#endif

/* An empty result of this scene in c->r, its arrays zero. */
static void sp__check_clear(const sp_scene *scene, sp__check *c)
{
    sp_result *r = &c->r;
    const size_t b = (size_t)c->pb.blocks;
    memset(r->f, 0, 3 * (size_t)scene->count.points * sizeof *r->f);
    memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    memset(r->y0, 0, 12 * b * sizeof *r->y0);
    memset(r->demand, 0, (size_t)scene->count.interfaces * sizeof *r->demand);
    if (r->coupled.dq) memset(r->coupled.dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->coupled.dq);
    if (r->coupled.alpha) memset(r->coupled.alpha, 0, (size_t)scene->count.points * sizeof *r->coupled.alpha);
    r->tension_ratio = r->coupled.tension_ratio = -1;
    if (r->coupled.penalty) memset(r->coupled.penalty, 0, 4 * (size_t)scene->count.points * sizeof *r->coupled.penalty);
    if (c->set.budget > 0 || c->set.effect[SP_EFFECT_DEPTH] == SP_WITHOUT) r->omega = b ? 1 : 0;     /* of no forces at all */
    r->tol = c->set.tol;
    r->force_bound = c->set.force_bound;
    r->free_blocks = c->pb.blocks;
    r->interfaces = c->pb.contacts;
    r->points = sp__points_count(scene);
    r->verdict = b ? SP_UNDECIDED : SP_STABLE;
    r->reason = b ? SP_REASON_STAGES : SP_REASON_NOTHING;
    r->verified = !b;
    r->islands = b ? 1 : 0;
}

/* Why an effect is on or off. */
static sp_effect_why sp__effect_why(const sp_settings *set, sp_effect effect, int present)
{
    const sp_choice choice = effect < SP_EFFECTS_FORCED ? set->effect[effect] : SP_PLANNED;
    if (choice == SP_WITH) return SP_WHY_ASKED;
    if (effect == SP_EFFECT_TOGETHER && (set->budget > 0 || !sp__plan_stages(set))) return SP_WHY_STAGES;
    if (effect == SP_EFFECT_TOGETHER) return present ? SP_WHY_CALLED : SP_WHY_APART;
    if (choice == SP_WITHOUT) return SP_WHY_LEFT_OUT;
    if (effect < SP_EFFECTS_FORCED && present && !sp__plan_stages(set)) return SP_WHY_STAGES;
    if (effect == SP_EFFECT_DYNAMICS) return SP_WHY_STATICS;
    return present ? SP_WHY_CALLED : effect == SP_EFFECT_COUPLED ? SP_WHY_NOT_ASKED : SP_WHY_ABSENT;
}

/* Everything of a check in arena `a` but the problem; `a` may be used up.
 *   out    *check: where the result is found on SP_OK */
SP__APART static sp_status sp__check_open(const sp_scene *scene, const sp_settings *settings, const sp__apart *apart, sp_arena *a,
                                          sp__check **check)
{
    sp_problem count;
    sp__kept arrays;
    sp__problem_count(scene, &count);
    sp__kept_carve(&arrays, scene, count.blocks, apart, settings, a);
    const size_t all = a->used;
    sp__check *c = sp__take(a, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
    memset(c, 0, sizeof *c);
    c->pb = count;
    c->r.f = arrays.f; c->r.dq = arrays.dq; c->r.y0 = arrays.y0; c->r.demand = arrays.demand;
    c->r.island = arrays.island; c->r.part = arrays.part;
    c->r.coupled.dq = arrays.cdq;
    c->r.coupled.alpha = arrays.alpha;
    c->r.coupled.penalty = arrays.penalty;
    c->r.coupled.proof = arrays.proof;
    c->arrays = arrays.used;
    c->kept = all;
    const sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (status) return status;
    sp__check_clear(scene, c);
    *check = c;
    return SP_OK;
}

/* The problem and the potential of the search behind it. */
static sp_status sp__check_problem(sp__check *c, sp_arena *a)
{
    const sp_status status = sp_problem_build(c->pb.scene, a, &c->pb);
    if (status) return status;
    sp_state *state = &c->state;
    sp__state_carve(state, &c->pb, &c->set, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    const size_t b = 6 * (size_t)c->pb.blocks;
    memset(state->y, 0, b * sizeof *state->y);
    state->reason = SP_REASON_STAGES;
    state->tension_ratio = -1;
    state->y0 = c->r.y0;
    if (c->set.budget > 0) {
        memset(state->f, 0, 3 * (size_t)c->pb.points * sizeof *state->f);
        memset(state->dq, 0, b * sizeof *state->dq);
        return SP_OK;
    }
    state->f = c->r.f;
    state->dq = c->r.dq;                                /* free blocks first; spread over the scene's once it is a proof */
    return SP_OK;
}

#ifndef SP_NO_CRA
/* The same of its triple, or its penalty form, where its forces take the place of that if it is coupled. */
SP__APART static void sp__island_triple(const sp_scene *scene, const sp__islands *t, int32_t k, const sp__check *found, sp__check *c)
{
    const sp_coupled *from = &found->r.coupled;
    sp_coupled *out = &c->r.coupled;
    int32_t joint = 0;
    for (int32_t q = t->interface[k]; q >= 0; q = t->link[q], joint++) {
        const sp_interface *f = &found->pb.scene->interface[joint];
        const size_t to = (size_t)scene->interface[q].point, at = (size_t)f->point, n = (size_t)f->points;
        memcpy(out->alpha + to, from->alpha + at, n * sizeof *out->alpha);
        if (out->penalty) memcpy(out->penalty + 4 * to, from->penalty + 4 * at, 4 * n * sizeof *out->penalty);
        for (size_t v = 0; v < n && out->penalty && from->verdict == SP_COUPLING_COUPLED; v++)
            for (size_t i = 0; i < 3; i++) out->penalty[4 * (to + v) + i + (i > 0)] = found->r.f[3 * (at + v) + i];
    }
    for (int32_t i = t->block[k]; i >= 0; i = t->next[i])
        memcpy(out->dq + 6 * (size_t)i, from->dq + 6 * (size_t)t->rank[i], 6 * sizeof *out->dq);
    out->eps = from->eps;
    out->eta = from->eta;
    out->residual = sp__max(out->residual, from->residual);
    out->rounds += from->rounds;
    if (from->verdict != SP_COUPLING_COUPLED && out->tension_ratio > -2)               /* -2: of one there is none */
        out->tension_ratio = from->tension_ratio < 0 ? (sp_real)-2 : sp__max(out->tension_ratio, from->tension_ratio);
    sp__cost_add(&out->cost, &from->cost);
    c->r.part[k].coupling = from->verdict;
    c->r.part[k].coupling_reason = from->reason;
}
#endif

/* What was found about island k into the arrays of the whole; motions stay where they are looked for, free blocks first. */
SP__APART static void sp__island_keep(const sp_scene *scene, const sp__islands *t, int32_t k, const sp__check *found, sp__check *c)
{
    const sp_result *from = &found->r;
    sp_result *r = &c->r;
    const size_t b = 6 * (size_t)found->pb.blocks, all = 6 * (size_t)c->pb.blocks;
    int32_t joint = 0;
    for (int32_t q = t->interface[k]; q >= 0; q = t->link[q], joint++) {
        const sp_interface *f = &found->pb.scene->interface[joint];
        memcpy(r->f + 3 * (size_t)scene->interface[q].point, from->f + 3 * (size_t)f->point,
               3 * (size_t)f->points * sizeof *r->f);
        r->demand[q] = from->demand[joint];
    }
    for (int32_t i = t->block[k]; i >= 0; i = t->next[i]) {
        const size_t to = 6 * (size_t)t->row[i], at = 6 * (size_t)t->rank[i];
        memcpy(r->y0 + to, from->y0 + at - 6, 6 * sizeof *r->y0);
        memcpy(r->y0 + all + to, from->y0 + b + at - 6, 6 * sizeof *r->y0);
        if (from->verdict != SP_STABLE) memcpy(r->dq + to, from->dq + at, 6 * sizeof *r->dq);
    }
    c->state.has_y0 |= found->state.has_y0;
    r->omega = sp__max(r->omega, from->omega);
    sp__cost_add(&r->cost, &from->cost);
    for (int32_t q = 0; q < c->set.stage_count; q++) sp__cost_add(&r->by_stage[q], &from->by_stage[q]);
    for (int q = 0; q < SP_EFFECTS; q++)
        if (k == 0 || r->effect[q] != from->effect[q]) r->effect[q] = k ? SP_WHY_CALLED : from->effect[q];
    memset(&r->part[k], 0, sizeof r->part[k]);
    r->part[k].block = t->block[k];
    r->part[k].blocks = found->pb.blocks;
    r->part[k].verdict = from->verdict;
    r->part[k].reason = from->reason;
    r->part[k].stage = from->stage;
    if (from->reason == SP_REASON_EFFECT) r->missing = from->missing;
#ifndef SP_NO_CRA
    if (c->set.coupled.asked) sp__island_triple(scene, t, k, found, c);
#endif
}

/* The island whose verdict is that of all: the first that falls, else the first undecided, else the first with forces. */
static int32_t sp__islands_worst(const sp_result *r)
{
    int32_t worst = 0;
    for (int32_t k = 1; k < r->islands; k++) {
        const sp_verdict a = r->part[worst].verdict, b = r->part[k].verdict;
        if (a == SP_UNSTABLE || (a == SP_UNDECIDED && b != SP_UNSTABLE)) continue;
        if (b != SP_STABLE || r->part[worst].reason == SP_REASON_NOTHING) worst = k;
    }
    return worst;
}

#ifndef SP_NO_CRA
/* The coupled check of the whole from those of all islands; r->verdict is that of statics. Where all are coupled the triple is
 * judged once more. */
SP__APART static sp_status sp__islands_couple(sp__check *c, sp_arena *a)
{
    sp_result *r = &c->r;
    sp_coupled *out = &r->coupled;
    int32_t open = -1;
    if (out->tension_ratio < 0) out->tension_ratio = -1;
    if (r->verdict == SP_UNSTABLE) {                    /* statics refute: what was proved of an island is not asked for */
        out->proof.nodes = out->proof.leaves = out->proof.entries = out->proof.island = 0;
        out->margin = 0;
    }
    const int refuted = out->proof.nodes > 0;
    for (int32_t k = r->islands - 1; k >= 0; k--)
        if (r->part[k].coupling == SP_COUPLING_NOT_FOUND && r->part[k].coupling_reason != SP_COUPLING_STATICS) open = k;
    out->verdict = r->verdict == SP_UNSTABLE || refuted ? SP_COUPLING_REFUTED : SP_COUPLING_NOT_FOUND;
    out->reason = refuted ? SP_COUPLING_NO_MOTION : r->verdict != SP_STABLE ? SP_COUPLING_STATICS
                : open >= 0 ? r->part[open].coupling_reason : SP_COUPLING_LIMIT;
    if (refuted || open >= 0 || r->verdict != SP_STABLE) return SP_OK;
    sp__judge j;
    const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
    if (!sp__judge_open(&j, &c->pb, &c->set, c->state.has_y0 ? r->y0 : NULL, INT32_MAX, a)) return SP_E_MEMORY;
    for (int32_t i = 0; i < c->pb.blocks; i++)
        memcpy(c->state.y + 6 * (size_t)i, out->dq + 6 * (size_t)c->pb.block[i], 6 * sizeof *c->state.y);
    r->omega = sp__judge_forces(&j, r->f, r->f);
    out->residual = sp__judge_coupled(&j, &k, r->f, c->state.y, out->alpha);
    const sp_cost cost = { SP__FLOPS_JUDGE * (int64_t)j.sweeps * c->pb.points, 0, 0, 0 };
    sp__cost_add(&out->cost, &cost);
    sp__cost_add(&r->cost, &cost);
    if (r->omega > r->tol || out->residual > 1) return SP_OK;
    out->verdict = SP_COUPLING_COUPLED;
    out->reason = SP_COUPLING_MOTION;
    return SP_OK;
}
#endif

/* The evidence of all islands, judged on the whole. */
SP__APART static sp_status sp__islands_judge(const sp_scene *scene, const sp__tour *w, sp__check *c, sp_arena *a)
{
    sp_result *r = &c->r;
    const int32_t *label = w->t.label, *row = w->t.row;
    if (w->proof.nodes) r->coupled.proof = w->proof;
    r->coupled.margin = w->margin;
    const sp_island *worst = &r->part[sp__islands_worst(r)];
    for (int32_t i = 0; i < scene->count.blocks; i++)                   /* what falls tells, not what may */
        if (label[i] >= 0 && r->part[label[i]].verdict != worst->verdict)
            memset(r->dq + 6 * (size_t)row[i], 0, 6 * sizeof *r->dq);
    a->used = w->start;                                                 /* the tables are no longer needed */
    sp_status status = sp__check_problem(c, a);
    const size_t mark = a->used;
    if (!status && !sp__take(a, 1, sp__judge_need(&c->pb, &c->set))) status = SP_E_MEMORY;
    a->used = mark;
    r->verdict = SP_STABLE;                                             /* where all stand that has been judged, block by block */
    if (!status && (worst->verdict != SP_STABLE || r->omega > SP__ENOUGH * r->tol))
        status = sp__check_claim(&c->pb, &c->set, INT32_MAX, worst->verdict, &c->state, a, r);
    if (status) return status;
    sp__cost_add(&r->cost, &c->state.cost);
    sp__cost_add(&r->by_stage[c->set.stage_count - 1], &c->state.cost);
    r->verified = r->verdict != SP_UNDECIDED;
    r->stage = r->verified ? worst->stage : SP_STAGE_NONE;
    r->reason = r->verdict == worst->verdict ? worst->reason : SP_REASON_LIMIT;
    if (r->verdict == SP_STABLE) memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
#ifndef SP_NO_CRA
    if (c->set.coupled.asked) status = sp__islands_couple(c, a);
#endif
    return status;
}

#ifndef SP_NO_CRA
/* eps and eta of the whole, for its islands. */
SP__APART static sp_status sp__islands_lengths(const sp_scene *scene, sp_coupled_settings *cs, const sp_settings *set, sp_arena a)
{
    sp_problem pb;
    const sp_status status = sp_problem_build(scene, &a, &pb);
    if (status) return status;
    const sp__lengths k = sp__coupled_lengths(&pb, set);
    if (cs->eps < 0) cs->eps = k.eps > 0 ? k.L : 0;
    if (!(k.eps > 0)) cs->eta = k.L;
    return SP_OK;
}
#endif

/* The way over all islands, in the arena. */
SP__APART static sp_status sp__tour_open(const sp_scene *scene, sp__check *c, sp_arena *a, sp__tour **walk)
{
    const size_t start = a->used;
    sp_status status = SP_OK;
#ifndef SP_NO_CRA
    if (c->set.coupled.asked) status = sp__islands_lengths(scene, &c->set.coupled, &c->set, *a);
#endif
    sp__tour *w = sp__take(a, 1, sizeof *w);
    if (status || !w) return status ? status : SP_E_MEMORY;
    memset(w, 0, sizeof *w);
    sp__islands_carve(&w->t, scene, c->r.islands, c->r.island, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    sp__islands_fill(scene, &w->t);
    w->start = start;
    w->mark = a->used;
    *walk = w;
    return SP_OK;
}

/* Where another search came after the last that was refuted, whose proof has gone, that is sought again. */
static int sp__tour_more(const sp__tour *w, const sp__check *c, int32_t k)
{
    return k < c->r.islands + (w->proof.nodes && !w->lies);
}

/* A check of the k-th island as a scene of its own. A proof goes into the room the whole has for it. */
SP__APART static sp_status sp__tour_next(const sp_scene *scene, sp__tour *w, int32_t k, const sp__check *c, sp_arena *a,
                                         sp__check **found)
{
    const sp__apart one = { 1, 0, 0 };
    w->at = k < c->r.islands ? k : w->proof.island - 1;
    w->again = k == c->r.islands;
    const sp_scene *s = sp__island_scene(scene, &w->t, w->at, a);
    const sp_status status = s ? sp__check_open(s, &c->set, &one, a, found) : SP_E_MEMORY;
    if (!status) (*found)->r.coupled.proof = c->r.coupled.proof;
    return status;
}

/* What it found. */
SP__APART static void sp__tour_keep(const sp_scene *scene, sp__tour *w, const sp__check *found, sp__check *c, sp_arena *a)
{
    const sp_coupled *o = &found->r.coupled;
    if (!w->again) sp__island_keep(scene, &w->t, w->at, found, c);
    else sp__cost_add(&c->r.cost, &found->r.cost);
    w->lies &= !o->rounds && (o->verdict != SP_COUPLING_NOT_FOUND || o->reason == SP_COUPLING_STATICS);
    if (o->proof.nodes) {
        w->proof = o->proof;
        w->proof.island = w->at + 1;
        w->margin = o->margin;
        w->lies = 1;
    }
    a->used = w->mark;
}

#ifndef SP_NO_CRA
/* What the coupled check makes of what statics said, of every island and of the whole. */
SP__APART static void sp__check_told(sp__check *c)
{
    sp_result *r = &c->r;
    for (int32_t k = 0; r->part && k < r->islands; k++) {
        sp_island *p = &r->part[k];
        sp__coupled_told(&c->set, p->coupling, p->coupling_reason, &p->verdict, &p->reason);
    }
    if (!sp__coupled_told(&c->set, r->coupled.verdict, r->coupled.reason, &r->verdict, &r->reason)) return;
    r->verified = r->verdict == SP_UNSTABLE;
    if (r->reason == SP_REASON_EFFECT) r->missing = SP_EFFECT_DEPTH;
}
#endif

/* What a check starts with: of several islands the way over them. */
SP__APART static sp_status sp__check_begin(const sp_scene *scene, const sp_settings *settings, sp_arena *a, sp__check **c,
                                           sp__tour **w)
{
    sp__apart apart;
    sp_status status = sp__islands_count(scene, settings, *a, &apart);
    if (!status) status = sp__check_open(scene, settings, &apart, a, c);
    if (status || apart.islands < 2) return status;
    (*c)->r.islands = apart.islands;
    return sp__tour_open(scene, *c, a, w);
}

/* Words and resultants of what was found. */
SP__APART static void sp__check_close(const sp_scene *scene, sp__check *c)
{
    sp_result *r = &c->r;
    const int32_t islands = r->islands > 1 ? r->islands : 1;
#ifndef SP_NO_CRA
    if (c->set.coupled.asked) sp__check_told(c);
#endif
    if (r->verdict == SP_STABLE) memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    if (r->verdict == SP_STABLE) r->level = c->set.coupled.asked ? SP_COUPLED : SP_ADMISSIBLE;
    sp__check_read(scene, r);
    for (int32_t k = 0; k < SP_EFFECTS; k++)
        if (r->effect[k] == SP_WHY_CALLED)
            r->effect[k] = sp__effect_why(&c->set, (sp_effect)k, sp__effect_present(scene, &c->set, islands, (sp_effect)k));
}

SP_API sp_status sp_check(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (settings && settings->work && (settings->work == arena || !settings->work->base)) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__check *c = NULL;
    sp__tour *w = NULL;
    sp_arena a = *arena;
    sp_status status = sp__check_begin(scene, settings, &a, &c, &w);
    for (int32_t k = 0; !status && (w ? sp__tour_more(w, c, k) : !k); k++) {
        sp__check *found = c;
        if (w) status = sp__tour_next(scene, w, k, c, &a, &found);
        if (!status) status = sp__check_problem(found, &a);
        if (!status && found->pb.blocks) status = sp__check_run(&found->pb, &found->set, &found->state, &a, &found->r);
#ifndef SP_NO_CRA
        if (!status && found->set.coupled.asked) status = sp__check_coupled(found, &a);
#endif
        if (!status && w) sp__tour_keep(scene, w, found, c, &a);
    }
    if (!status && w) status = sp__islands_judge(scene, w, c, &a);
    if (status) return status;
    sp__check_close(scene, c);
    c->r.peak_bytes = arena->peak = a.peak;
    arena->used = c->r.coupled.proof.nodes ? c->kept : c->arrays;
    *result = c->r;
    return SP_OK;
}

#endif /* SP_SMALL */

/* 29 -------------------------------------------------------------------------------------------------------------- verify */

#ifndef SP_NO_CRA
/* Tables of islands, one as a scene of its own, and what judges it; `hint`: its share of y0. */
typedef struct sp__part { sp__islands t; sp_problem pb; sp__judge j; sp_real *hint; } sp__part;

/* Bytes of that, at most: what is refuted has few vertices and blocks. */
SP__APART static size_t sp__verify_part_need(const sp_scene *scene, const sp_settings *set)
{
    sp_problem pb;
    sp__islands t;
    sp_capacity n = scene->count;
    const int32_t few = SP_EXACT_POINTS;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &pb);
    if (pb.blocks > few) pb.blocks = few;
    if (pb.contacts > few) pb.contacts = few;
    if (pb.points > few) pb.points = few;
    n.vertices = n.faces = n.corners = 0;
    n.blocks = pb.blocks + 1;
    n.interfaces = pb.contacts;
    n.points = pb.points;
    sp__take(&dry, 1, sizeof(sp__part));
    sp__islands_carve(&t, scene, scene->count.blocks, NULL, &dry);
    sp__take(&dry, 1, sizeof *scene);
    sp__take(&dry, 1, sp_scene_memory(&n));
    sp__problem_carve(&pb, &dry);
    sp__take(&dry, (size_t)pb.blocks, 12 * sizeof(sp_real));
    sp__take(&dry, 1, sp__judge_need(&pb, set));
    sp__take(&dry, 1, sp__refute_need(pb.points, pb.blocks));
    return dry.used;
}

/* The margin of a proof that refutes an island, judged on that alone; 0: none.     returns SP_E_MEMORY, SP_E_NOT_FINITE */
SP__APART static sp_status sp__verify_part(const sp_scene *scene, const sp_settings *set, const sp__lengths *k,
                                           const sp_result *claim, sp_arena a, sp_real *margin)
{
    const int32_t island = claim->coupled.proof.island - 1;
    sp__part *p = sp__take(&a, 1, sizeof *p);
    if (!p) return SP_E_MEMORY;
    sp__islands_carve(&p->t, scene, scene->count.blocks, NULL, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    const int32_t count = sp__islands_join(scene, p->t.rank);
    if (island < 0 || island >= count) return SP_OK;
    sp__islands_fill(scene, &p->t);
    sp_capacity n;
    sp__island_size(scene, &p->t, island, &n);
    if (n.points > SP_EXACT_POINTS || n.blocks > SP_EXACT_POINTS + 1) return SP_OK;
    const sp_scene *s = sp__island_scene(scene, &p->t, island, &a);
    sp_status status = s ? sp_problem_build(s, &a, &p->pb) : SP_E_MEMORY;
    if (status) return status;
    const size_t b = (size_t)p->pb.blocks;
    size_t all = 0;
    p->hint = sp__take(&a, b, 12 * sizeof *p->hint);
    if (!p->hint) return SP_E_MEMORY;
    for (int32_t i = 0; i < scene->count.blocks; i++) all += p->t.row[i] >= 0;
    for (int32_t i = p->t.block[island]; i >= 0 && claim->y0; i = p->t.next[i])
        for (size_t half = 0; half < 2; half++)
            memcpy(p->hint + 6 * (half * b + (size_t)p->t.rank[i] - 1), claim->y0 + 6 * (half * all + (size_t)p->t.row[i]),
                   6 * sizeof *p->hint);
    if (!sp__judge_open(&p->j, &p->pb, set, claim->y0 ? p->hint : NULL, INT32_MAX, &a)) return SP_E_MEMORY;
    *margin = sp__judge_refuted(&p->j, k, &claim->coupled.proof, &a);
    return SP_OK;
}
#endif

SP_API size_t sp_verify_memory(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp_settings set = sp_settings_default();
    set.faces = 64;
    sp__problem_count(scene, &pb);
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof(sp__check));
#ifndef SP_NO_CRA
    const size_t part = dry.used + sp__verify_part_need(scene, &set);
#endif
    sp__take(&dry, 1, sp_problem_memory(scene));
    sp__take(&dry, (size_t)pb.blocks, 6 * sizeof(sp_real));
    sp__take(&dry, 1, sp__judge_need(&pb, &set));
#ifndef SP_NO_CRA
    const int32_t points = sp__points_count(scene);
    if (points <= SP_EXACT_POINTS) sp__take(&dry, 1, sp__refute_need(points, pb.blocks));
    if (part > dry.used) return part;
#endif
    return dry.used;
}

/* The motion of the free blocks out of a claim's. */
static void sp__verify_motion(const sp_problem *pb, const sp_real *all, sp_real *dq)
{
    for (int32_t i = 0; i < pb->blocks; i++) memcpy(dq + 6 * (size_t)i, all + 6 * (size_t)pb->block[i], 6 * sizeof *dq);
}

SP_API sp_status sp_verify(const sp_scene *scene, const sp_settings *settings, const sp_result *claim, sp_arena scratch,
                           sp_evidence *evidence)
{
    if (!scene || !claim || !claim->f || !claim->dq || !evidence || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    if (!sp__all_finite(claim->f, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->dq, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    const int triple = settings && settings->coupled.asked && claim->coupled.dq && claim->coupled.alpha;
    if (triple && !sp__all_finite(claim->coupled.dq, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    if (triple && !sp__all_finite(claim->coupled.alpha, (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    sp__check *c = sp__take(&scratch, 1, sizeof *c);
    if (!c) return SP_E_MEMORY;
#ifndef SP_NO_CRA
    const sp_arena room = scratch;
#endif
    sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (!status) status = sp_problem_build(scene, &scratch, &c->pb);
    if (status) return status;
    sp__judge j;
    sp_real *dq = sp__take(&scratch, (size_t)c->pb.blocks, 6 * sizeof *dq);
    if (sp__failed(&scratch) || !sp__judge_open(&j, &c->pb, &c->set, claim->y0, INT32_MAX, &scratch)) return SP_E_MEMORY;
    sp_evidence e = { SP_UNDECIDED, 0, 0, 0, SP_NONE, 0, 0 };
    sp__verify_motion(&c->pb, claim->dq, dq);
    e.omega = sp__judge_forces(&j, claim->f, NULL);
    e.least_imbalance = sp__judge_mechanism(&j, dq, &e.final);
    if (e.omega <= c->set.tol) e.verdict = SP_STABLE;
    else if (e.least_imbalance > c->set.tol) e.verdict = SP_UNSTABLE;
    if (e.verdict != SP_UNSTABLE) e.final = 0;
    if (e.verdict == SP_STABLE) e.level = SP_ADMISSIBLE;
#ifndef SP_NO_CRA
    if (triple) {
        const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
        sp__verify_motion(&c->pb, claim->coupled.dq, dq);
        e.residual = sp__judge_coupled(&j, &k, claim->f, dq, claim->coupled.alpha);
        if (e.level && e.residual <= 1) e.level = SP_COUPLED;
    }
    if (c->set.coupled.asked && claim->coupled.proof.nodes > 0) {
        const sp__lengths k = sp__coupled_lengths(&c->pb, &c->set);
        if (!claim->coupled.proof.island) e.margin = sp__judge_refuted(&j, &k, &claim->coupled.proof, &scratch);
        else status = sp__verify_part(scene, &c->set, &k, claim, room, &e.margin);
        if (status) return status;
        if (e.margin > 0) { e.verdict = SP_UNSTABLE; e.level = SP_NONE; }
    }
#endif
    *evidence = e;
    return SP_OK;
}

/* 30 --------------------------------------------------------------------------------------------------------------- plan */

#if !defined(SP_NO_PLAN) && !defined(SP_SMALL)
/* What the full simulation of a problem comes to: 6 rows a block, 3 forces a vertex; and in flops SP__PLAN_STEPS Newton steps,
 * each an assembly, a factor, SP__PLAN_SWEEPS passes over the contacts and a solve. Steps are a guess (3 to 5 for a wall, more
 * near a limit), what a step costs is known. */
#define SP__PLAN_STEPS 5
#define SP__PLAN_SWEEPS 4
#define SP__PLAN_SEARCH 12              /* steps of a coupled check's search where it is an easy one */

typedef struct sp__work {
    int64_t unknowns, flops;            /* of all rows and forces */
    int64_t less[2], fewer[2];          /* flops and unknowns that each sp__mode saves */
    int32_t problems, reduced[2];       /* how many problems, how many of them a reduction is planned for */
    int32_t forests;                    /* how many of them are told to be coupled without a search */
    int64_t search;                     /* flops of such searches */
} sp__work;

/* Is no search for a motion planned? */
static int sp__plan_hangs(const sp_problem *pb, const sp_settings *set, sp_arena a)
{
#ifndef SP_NO_CRA
    sp__forest g;
    return set->coupled.asked && sp__hangs(set) && sp__forest_of(pb, &g, &a);
#else
    (void)pb; (void)set; (void)a;
    return 0;
#endif
}

/* What a reduction saves, a planar one with corners in pairs, a level one with a first guess that is mostly right. */
static void sp__plan_flat(const sp_problem *pb, const sp__flat *f, int64_t full, int64_t factor, sp__work *o)
{
    const int plane = f->mode == SP__PLANE;
    const int64_t v = pb->points / (1 + plane), sides = 2 * (int64_t)pb->contacts;
    const int64_t assembly = SP__FLOPS_FLAT_HESSIAN(f) * v + SP__FLOPS_FLAT_BLOCKS * sides;
    const int64_t sweep = SP__FLOPS_FLAT_SWEEP(f) * v + SP__FLOPS_FLAT_TWIST * sides;
    o->less[f->mode] += full - (plane ? SP__PLAN_STEPS : 2) * (assembly + factor / 8 + SP__PLAN_SWEEPS * sweep);
    o->fewer[f->mode] += 3 * (int64_t)pb->blocks + 2 * (int64_t)pb->points;
    o->reduced[f->mode]++;
}

/* Adds the work of a scene as one problem. */
SP__APART static sp_status sp__plan_whole(const sp_scene *scene, const sp_settings *set, sp_arena scratch, sp__work *o)
{
    sp_problem pb;
    const sp_status status = sp_problem_build(scene, &scratch, &pb);
    if (status) return status;
    const int hangs = sp__plan_hangs(&pb, set, scratch);
    sp__dual *w = sp__take(&scratch, 1, sizeof *w);
    const int32_t blocks = w ? sp__dual_analyse(w, &pb, &scratch) : -1;
    if (blocks < 0) return SP_E_MEMORY;
    const int64_t v = sp__points_count(scene), c = pb.contacts, b = pb.blocks;
    const int64_t sweep = SP__FLOPS_SWEEP * v + SP__FLOPS_TWIST * c, assembly = SP__FLOPS_HESSIAN * v + SP__FLOPS_BLOCKS * c;
    const int64_t full = SP__PLAN_STEPS * (assembly + w->L.flops + SP__PLAN_SWEEPS * sweep + 144 * (int64_t)blocks + 72 * b);
    sp__flat *flat = sp__take(&scratch, 1, sizeof *flat);
    if (!flat) return SP_E_MEMORY;
    o->unknowns += 6 * b + 3 * v;
    o->flops += full;
    o->problems++;
    o->forests += hangs;
    o->search += SP__PLAN_SEARCH * (assembly + w->L.flops + SP__PLAN_SWEEPS * sweep);
    if (sp__flat_choose(&pb, set, flat)) sp__plan_flat(&pb, flat, full, w->L.flops, o);
    return SP_OK;
}

/* The same, island by island. */
SP__APART static sp_status sp__plan_apart(const sp_scene *scene, int32_t count, const sp_settings *set, sp_arena scratch,
                                           sp__work *o)
{
    sp__islands t;
    sp_status status = SP_OK;
    sp__islands_carve(&t, scene, count, NULL, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__islands_fill(scene, &t);
    for (int32_t k = 0; k < count && !status; k++) {
        sp_arena a = scratch;
        const sp_scene *s = sp__island_scene(scene, &t, k, &a);
        status = s ? sp__plan_whole(s, set, a, o) : SP_E_MEMORY;
    }
    return status;
}

/* What a plan works on, in the arena. */
typedef struct sp__planner {
    sp_settings set;
    sp_outlook o;
    sp__work whole, apart;
} sp__planner;

/* Every effect in words, and what leaving it out saves. */
static void sp__plan_effects(const sp_scene *scene, sp__planner *p)
{
    sp_outlook *o = &p->o;
    for (int32_t k = 0; k < SP_EFFECTS; k++)
        o->effect[k].why = sp__effect_why(&p->set, (sp_effect)k, sp__effect_present(scene, &p->set, o->islands, (sp_effect)k));
    const sp__work *w = &p->apart;
    o->effect[SP_EFFECT_TOGETHER].flops = p->whole.flops - w->flops;
    o->effect[SP_EFFECT_TOGETHER].bytes = (int64_t)o->full_bytes - (int64_t)o->bytes;
    o->full_unknowns = p->whole.unknowns;
    o->full_flops = p->whole.flops;
    o->unknowns = w->unknowns;
    o->flops = w->flops;
    for (int mode = 0; mode < 2; mode++) {
        sp_planned *e = &o->effect[mode == SP__PLANE ? SP_EFFECT_DEPTH : SP_EFFECT_FRICTION];
        e->flops = w->less[mode];
        e->unknowns = w->fewer[mode];
        if (w->reduced[mode] == w->problems && w->problems) e->why = mode == SP__PLANE ? SP_WHY_MIRROR : SP_WHY_PRESSURE;
    }
    if (w->forests == w->problems && w->problems) {
        o->effect[SP_EFFECT_COUPLED].why = SP_WHY_FOREST;
        o->effect[SP_EFFECT_COUPLED].flops = w->search;
        o->full_flops += w->search;
    }
    o->flops -= w->less[SP__PLANE] + w->less[SP__PLUMB];
    o->unknowns -= w->fewer[SP__PLANE] + w->fewer[SP__PLUMB];
}

SP_API size_t sp_plan_memory(const sp_scene *scene, const sp_settings *settings)
{
    const size_t need = sp_memory_scratch(scene, settings);
    return need ? need + sizeof(sp__planner) + sizeof(sp__dual) + 2 * SP_ALIGN : 0;
}

/* Needs and work as planned, then with all blocks together. */
SP__APART static sp_status sp__plan_run(const sp_scene *scene, sp__planner *p, sp_arena scratch)
{
    const sp_choice together = p->set.effect[SP_EFFECT_TOGETHER];
    sp_status status = sp__memory(scene, &p->set, NULL, scratch, &p->o.bytes);
    sp__apart apart = { 1, 0, 0 };
    if (!status) status = sp__islands_count(scene, &p->set, scratch, &apart);
    p->o.islands = apart.islands;
    if (!status && p->o.islands > 1) status = sp__plan_apart(scene, p->o.islands, &p->set, scratch, &p->apart);
    p->set.effect[SP_EFFECT_TOGETHER] = SP_WITH;
    if (!status) status = sp__memory(scene, &p->set, NULL, scratch, &p->o.full_bytes);
    if (!status) status = sp__plan_whole(scene, &p->set, scratch, &p->whole);
    p->set.effect[SP_EFFECT_TOGETHER] = together;
    if (p->o.islands < 2) p->apart = p->whole;
    return status;
}

SP_API sp_status sp_plan(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, sp_outlook *out)
{
    if (!scene || !scratch.base || !out) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__planner *p = sp__take(&scratch, 1, sizeof *p);
    if (!p) return SP_E_MEMORY;
    memset(p, 0, sizeof *p);
    sp_status status = sp__settings_resolve(scene, settings, &p->set);
    p->set.work = NULL;
    if (!status) status = sp__plan_run(scene, p, scratch);
    if (status) return status;
    sp__plan_effects(scene, p);
    *out = p->o;
    return SP_OK;
}

#endif /* SP_NO_PLAN */

/* 31 ----------------------------------------------------------------------------------------------------- placing a stone */

SP_API size_t sp_support_memory(int32_t points)
{
    if (points < 0) return 0;
    sp__hull h;
    sp_arena dry = sp__arena_dry();
    sp__hull_carve(&h, points, &dry);
    return dry.used;
}

/* Coordinates of x across `up`, seen from o. */
static void sp__plan(const sp_real up[3], const sp_real o[3], const sp_real x[3], sp_real xy[2])
{
    sp_real s[3], t[3], d[3];
    sp__across3(up, s);
    sp__cross3(up, s, t);
    sp__sub3(x, o, d);
    xy[0] = sp__dot3(s, d);
    xy[1] = sp__dot3(t, d);
}

/* What a hull whose origin is the centre of mass says of it.     returns SP_E_NOT_FINITE where it is too large to be squared */
static sp_status sp__support_read(sp__hull *h, sp_support *support)
{
    const sp_real com[2] = { 0, 0 };
    sp_real size = 0, g[3] = { 0, 0, 0 };
    const sp_support none = { (sp_real)-1, 0, (sp_real)1e9 };
    for (int32_t i = 0; i < h->points; i++) size = sp__max(size, sp__max(sp__abs(h->p[i][0]), sp__abs(h->p[i][1])));
    if (!sp__finite(size * size)) return SP_E_NOT_FINITE;
    sp__hull_run(h);
    *support = none;
    if (h->corners < 3) return SP_OK;
    const sp_real area = sp__hull_area(h, g);
    if (!(area > (sp_real)64 * SP_EPSILON * size * size)) return SP_OK;
    support->area = area;
    support->clearance = sp__hull_clearance(h, com);
    support->offset = sp__norm3(g);
    return SP_OK;
}

SP_API sp_status sp_support_clearance(const sp_real *xyz, int32_t points, const sp_real com[3], const sp_real gravity[3],
                                      sp_arena scratch, sp_support *support)
{
    if ((!xyz && points) || points < 0 || !com || !gravity || !support || !scratch.base) return SP_E_ARGUMENT;
    if (!sp__finite3(com) || !sp__finite3(gravity)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(xyz, 3 * (size_t)points)) return SP_E_NOT_FINITE;
    if (!(sp__norm3(gravity) > 0)) return SP_E_RANGE;
    sp_real up[3];
    sp__hull h;
    sp__hull_carve(&h, points, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    sp__unit3(gravity, up);
    sp__scale3((sp_real)-1, up, up);
    for (int32_t i = 0; i < points; i++) sp__plan(up, com, xyz + 3 * (size_t)i, h.p[i]);
    return sp__support_read(&h, support);
}

SP_API sp_seat_weights sp_seat_weights_default(void)
{
    const sp_seat_weights w = { (sp_real)1, (sp_real)1, (sp_real)1, (sp_real)0.5 };
    return w;
}

static sp_status sp__seat_check(const sp_seat *s, const sp_seat_weights *w)
{
    sp_real x[sizeof *s / sizeof s->seat], y[sizeof *w / sizeof w->seat];           /* they are nothing but numbers */
    memcpy(x, s, sizeof x);
    memcpy(y, w, sizeof y);
    if (!sp__all_finite(x, sizeof x / sizeof *x) || !sp__all_finite(y, sizeof y / sizeof *y)) return SP_E_NOT_FINITE;
    if (!(s->footprint > 0 && s->height > 0 && s->width > 0 && s->trapped >= 0)) return SP_E_RANGE;
    return w->area >= 0 && w->offset >= 0 && w->trapped >= 0 && w->seat >= 0 ? SP_OK : SP_E_RANGE;
}

SP_API sp_status sp_support_cost(const sp_seat *seat, const sp_seat_weights *weights, sp_real *J)
{
    const sp_seat_weights w = weights ? *weights : sp_seat_weights_default();
    if (!seat || !J) return SP_E_ARGUMENT;
    const sp_status status = sp__seat_check(seat, &w);
    if (status) return status;
    const sp_real cost = w.area * ((sp_real)1 - seat->support.area / seat->footprint) + w.offset * seat->support.offset / seat->width
                       + w.trapped * (seat->trapped / seat->footprint) / seat->height + w.seat * seat->seat / seat->width;
    if (!sp__finite(cost)) return SP_E_NOT_FINITE;
    *J = cost;
    return SP_OK;
}

typedef struct sp__seats { const sp_seat *seat; const sp_real *J; sp_real margin; } sp__seats;

static int sp__seat_before(const void *what, int32_t i, int32_t j)
{
    const sp__seats *s = what;
    const int p = s->seat[i].support.clearance >= s->margin, q = s->seat[j].support.clearance >= s->margin;
    if (p != q) return p;
    if (s->J[i] < s->J[j] || s->J[i] > s->J[j]) return s->J[i] < s->J[j];
    return i < j;
}

SP_API sp_status sp_support_rank(const sp_seat *seats, int32_t count, sp_real margin, const sp_seat_weights *weights,
                                 sp_real *J, int32_t *order, int32_t *stable)
{
    if (count < 0 || (count && (!seats || !J || !order))) return SP_E_ARGUMENT;
    if (!sp__finite(margin)) return SP_E_NOT_FINITE;
    const sp__seats s = { seats, J, margin };
    int32_t enough = 0;
    for (int32_t i = 0; i < count; i++) {
        const sp_status status = sp_support_cost(&seats[i], weights, &J[i]);
        if (status) return status;
        order[i] = i;
        enough += seats[i].support.clearance >= margin;
    }
    sp__sort(order, count, sp__seat_before, &s);
    if (stable) *stable = enough;
    return SP_OK;
}

SP_API size_t sp_rest_memory(const sp_mesh *mesh)
{
    return mesh ? sp_support_memory(mesh->vertices) : 0;
}

/* How far x lies outside the plane through o with normal n, seen from o. */
static sp_real sp__outside(const sp_real n[3], const sp_real o[3], const sp_real x[3])
{
    sp_real d[3];
    sp__sub3(x, o, d);
    return sp__dot3(n, d);
}

/* Unit normal of a face.     returns 0 where it has no area */
static int sp__face_normal(const sp_mesh *mesh, const int32_t *corner, int32_t size, sp_real n[3])
{
    sp__local l;
    if (sp__local_start(&l, mesh->xyz, corner, size)) return 0;
    (void)sp__polygon_normal(&l, corner, size, n);
    if (!(sp__norm3(n) > 0)) return 0;
    sp__unit3(n, n);
    return 1;
}

/* Does the whole stone lie behind the plane through o with normal n? */
static int sp__rest_behind(const sp_mesh *mesh, const sp_real n[3], const sp_real o[3], sp_real eps)
{
    for (int32_t v = 0; v < mesh->vertices; v++) if (sp__outside(n, o, mesh->xyz + 3 * (size_t)v) > eps) return 0;
    return 1;
}

/* Is a face with these corners, earlier than one in the plane (n, o), the one that stands for this plane? */
static int sp__rest_same(const sp_mesh *mesh, const int32_t *corner, int32_t size, const sp_real n[3], const sp_real o[3],
                         sp_real eps)
{
    sp_real m[3];
    for (int32_t k = 0; k < size; k++) if (sp__outside(n, o, mesh->xyz + 3 * (size_t)corner[k]) < -eps) return 0;
    return sp__face_normal(mesh, corner, size, m) && sp__rest_behind(mesh, m, mesh->xyz + 3 * (size_t)corner[0], eps);
}

static int sp__rest_first(const sp_mesh *mesh, int32_t face, const sp_real n[3], const sp_real o[3], sp_real eps)
{
    const int32_t *corner = mesh->corner;
    for (int32_t f = 0; f < face; corner += mesh->size[f++])
        if (sp__rest_same(mesh, corner, mesh->size[f], n, o, eps)) return 0;
    return 1;
}

/* The hull of all vertices in the plane, the centroid its origin. */
static sp_status sp__rest_support(const sp_mesh *mesh, const sp_mass *mass, const sp_real o[3], sp_real eps, sp_rest *r,
                                  sp_arena scratch)
{
    sp__hull h;
    sp_real up[3];
    sp__hull_carve(&h, mesh->vertices, &scratch);
    if (sp__failed(&scratch)) return SP_E_MEMORY;
    h.points = 0;
    sp__scale3((sp_real)-1, r->normal, up);
    for (int32_t v = 0; v < mesh->vertices; v++) {
        const sp_real *x = mesh->xyz + 3 * (size_t)v;
        if (sp__outside(r->normal, o, x) >= -eps) sp__plan(up, mass->centroid, x, h.p[h.points++]);
    }
    r->height = -sp__outside(r->normal, o, mass->centroid);
    return sp__support_read(&h, &r->support);
}

SP_API sp_status sp_rest_faces(const sp_mesh *mesh, sp_arena scratch, sp_rest *rest, int32_t cap, int32_t *count)
{
    if (!scratch.base || (cap && !rest) || cap < 0 || !count) return SP_E_ARGUMENT;
    sp_mass mass;
    sp_status status = sp_mesh_mass(mesh, &mass);
    if (status) return status;
    const sp_real eps = sp__max((sp_real)1e-6, (sp_real)32 * SP_EPSILON) * mass.diameter;
    const int32_t *corner = mesh->corner;
    int32_t found = 0;
    for (int32_t f = 0; f < mesh->faces && !status; corner += mesh->size[f++]) {
        const sp_real *o = mesh->xyz + 3 * (size_t)corner[0];
        sp_rest r = { f, { 0, 0, 0 }, 0, { 0, 0, 0 } };
        if (!sp__face_normal(mesh, corner, mesh->size[f], r.normal)) continue;
        if (!sp__rest_behind(mesh, r.normal, o, eps) || !sp__rest_first(mesh, f, r.normal, o, eps)) continue;
        status = sp__rest_support(mesh, &mass, o, eps, &r, scratch);
        if (status || !(r.support.clearance > 0)) continue;
        if (found < cap) rest[found] = r;
        found++;
    }
    if (!status) *count = found;
    return !status && found > cap ? SP_E_CAPACITY : status;
}

SP_API sp_nbo_settings sp_nbo_settings_default(void)
{
    const sp_nbo_settings s = { 0, (sp_real)0.5, (sp_real)0.7 };
    return s;
}

SP_API sp_status sp_nbo_gate(const sp_laid *laid, const sp_real gravity[3], const sp_nbo_settings *settings, sp_arena scratch,
                             sp_nbo *reason, sp_real *margin)
{
    const sp_nbo_settings set = settings ? *settings : sp_nbo_settings_default();
    const sp_real wants[3] = { set.margin, set.slender, set.level };
    sp_support s;
    if (!laid || !reason) return SP_E_ARGUMENT;
    const sp_status status = sp_support_clearance(laid->xyz, laid->points, laid->com, gravity, scratch, &s);
    if (status) return status;
    if (!sp__finite(laid->depth) || !sp__finite(laid->height) || !sp__finite3(laid->normal) || !sp__finite3(wants))
        return SP_E_NOT_FINITE;
    if (laid->depth < 0 || laid->height < 0 || !(sp__norm3(laid->normal) > 0)) return SP_E_RANGE;
    sp_real n[3], g[3];
    sp__unit3(laid->normal, n);
    sp__unit3(gravity, g);
    const sp_real m = s.area > 0 ? s.clearance / SP_SQRT(s.area) : s.clearance;
    *reason = !(s.clearance >= 0)                       ? SP_NBO_OUTSIDE
            : laid->depth < set.slender * laid->height  ? SP_NBO_SHALLOW
            : sp__dot3(n, g) < set.level                ? SP_NBO_TILTED
            : m < set.margin                            ? SP_NBO_MARGIN : SP_NBO_ACCEPTED;
    if (margin) *margin = m;
    return SP_OK;
}

SP_API const char *sp_nbo_text(sp_nbo reason)
{
    const int k = (int)reason;
    return sp__word("accepted\0" SP__TOLD("centre of mass ") "outside its support\0" "too shallow" SP__TOLD(" for its height") "\0"
                    "resting face tilted\0" "too near the edge" SP__TOLD(" of its support") "\0" "unknown",
                    k >= 0 && k <= 4 ? k : 5);
}

#ifndef SP_SMALL
/* 32 ---------------------------------------------------------------------------------------------------------- build order */

/* The finished scene, some of its blocks absent. An island (free blocks that touch each other) is checked as a scene of its
 * own, the part: its blocks, the held ones and supports that they touch, the joints between.
 *
 * Before that the forces of the step before are tried. A block is called plain if its forces f pass sp_check's certificate
 * whatever f0 is, so that it can be seen from the block alone: sbar >= |load|, s >= 1.8 |load| (what balances a load is no
 * less than it, and f0 does to three digits, or counts as the load), and with tol' a little less than tol, for rounding,
 *
 *     |r| <= tol' 1.8 |load|,   |m| <= tol' (|couple| + min(sum |x_v x f_v|, lever |load|)),   |f_v| <= force_bound min |load|
 *
 * where lever |load| <= sum |x_v x f0_v| (sp__lever). An island of plain blocks stands. Where a step left some that are not,
 * they and what is below them are solved alone, loaded by the forces of their joints with all others, which stay.    */

#define SP__LEAN_STEPS 4                /* factorisations for that */
#define SP__LEAN_TOL ((sp_real)0.25)    /* of tol for that: its blocks bear the forces of others */
#define SP__PLAIN_TOL ((sp_real)0.9)    /* tol' of tol */
#define SP__BELOW ((sp_real)0.2)        /* cosine between gravity and a joint's normal from which on a block is below another */

typedef struct sp__stone {
    sp_presence presence;
    sp_verdict verdict;                 /* of its island */
    sp_reason reason;
    int32_t final, plain, stale;
    sp_real omega, least;
} sp__stone;

/* A search for what to hold (section 33). */
typedef struct sp__hold {
    sp_sequence *q;
    int32_t *member, members;           /* the island */
    int64_t budget;
    int32_t worst;                      /* what moves most in the first group that falls */
    int32_t known;                      /* how many of the members must be held */
    int32_t count;                      /* held so far, in q->answer */
    sp_held_proof proof;                /* the weakest of all islands */
    int over;                           /* the budget is spent */
    int unsure;                         /* a set that did not stand was not shown to fall */
    sp_status status;
} sp__hold;

struct sp_sequence {
    const sp_scene *scene;
    sp_settings set;
    sp_problem pb;                      /* of the finished scene, all blocks there */
    sp__judge judge;                    /* its units and cone */
    sp_scene part;
    int32_t members;                    /* free blocks of the part, which come first */
    sp__stone *stone, *stone_kept;      /* per block */
    int32_t *row, *order;               /* block's row in pb, -1: a support; blocks by elimination */
    int32_t *start, *joint;             /* contacts of pb at each block */
    sp_real *lever;                     /* per row [m] */
    int32_t *up, *mark, *number;        /* islands by union-find; who is meant; number in the part, -1 */
    int32_t *part_block, *part_joint;   /* back from there */
    int32_t *list, *origin;             /* blocks to be solved, and above which block that began */
    int32_t *answer, *must, *was;       /* of the search for what to hold */
    sp_real *f, *f_kept, *dq, *dq_kept;
    sp_arena work;
    sp__hold hold;
    sp_cost cost;
    int32_t checked, again, local, tries;
};

static void sp__sequence_carve(sp_sequence *q, const sp_scene *scene, const sp_problem *count, size_t work, sp_arena *a)
{
    const size_t n = (size_t)scene->count.blocks, c = (size_t)count->contacts, v = (size_t)scene->count.points;
    q->row = sp__take(a, n, sizeof *q->row);
    q->order = sp__take(a, n, sizeof *q->order);
    q->up = sp__take(a, n, sizeof *q->up);
    q->mark = sp__take(a, n, sizeof *q->mark);
    q->number = sp__take(a, n, sizeof *q->number);
    q->part_block = sp__take(a, n, sizeof *q->part_block);
    q->list = sp__take(a, n, sizeof *q->list);
    q->origin = sp__take(a, n, sizeof *q->origin);
    q->answer = sp__take(a, n, sizeof *q->answer);
    q->must = sp__take(a, n, sizeof *q->must);
    q->was = sp__take(a, n, sizeof *q->was);
    q->start = sp__take(a, n + 1, sizeof *q->start);
    q->joint = sp__take(a, c, 2 * sizeof *q->joint);
    q->part_joint = sp__take(a, c, sizeof *q->part_joint);
    q->stone = sp__take(a, n, sizeof *q->stone);
    q->stone_kept = sp__take(a, n, sizeof *q->stone_kept);
    q->lever = sp__take(a, (size_t)count->blocks, sizeof *q->lever);
    q->f = sp__take(a, v, 3 * sizeof *q->f);
    q->f_kept = sp__take(a, v, 3 * sizeof *q->f_kept);
    q->dq = sp__take(a, n, 6 * sizeof *q->dq);
    q->dq_kept = sp__take(a, n, 6 * sizeof *q->dq_kept);
    q->judge.direction = sp__take(a, 64, sizeof *q->judge.direction);
    memset(&q->part, 0, sizeof q->part);
    q->part.cap.blocks = scene->count.blocks;
    q->part.cap.interfaces = count->contacts;
    q->part.cap.points = scene->count.points;
    q->part.cap.loads = scene->count.loads;
    sp__scene_carve(&q->part, a);
    q->work.base = sp__take(a, work, 1);
    q->work.cap = work;
    q->work.used = q->work.peak = 0;
}

/* The caller's settings, as far as they can be followed step by step: what a check of a part needs must be no more than what
 * one of the whole does. */
static sp_status sp__sequence_settings(const sp_scene *scene, const sp_settings *in, sp_settings *out)
{
    const sp_status status = sp__settings_resolve(scene, in, out);
    if (status) return status;
    if (out->coupled.asked) return SP_E_UNSUPPORTED;
    for (int32_t k = 0; k < out->stage_count; k++)
        if (out->stage[k] == SP_STAGE_ADMM || out->stage[k] == SP_STAGE_CUSTOM) return SP_E_UNSUPPORTED;
    out->localise = 0;
    out->effect[SP_EFFECT_TOGETHER] = SP_WITH;          /* a part is one island */
    out->work = NULL;
    return SP_OK;
}

SP_API size_t sp_sequence_scratch(const sp_scene *scene, const sp_settings *settings)
{
    const size_t most = sp_memory_scratch(scene, settings);
    return most ? sizeof(sp_sequence) + SP_ALIGN + most : 0;
}

/* Bytes of a check of the whole, and of its symbolic step: a part in the same order of elimination fills no more. */
SP__APART static sp_status sp__sequence_work(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *work)
{
    sp_sequence *q = sp__take(&scratch, 1, sizeof *q);
    if (!q) return SP_E_MEMORY;
    sp_status status = sp__sequence_settings(scene, settings, &q->set);
    if (!status) status = sp__memory(scene, &q->set, NULL, scratch, work);
    if (status) return status;
    const size_t symbolic = sp_memory_scratch(scene, &q->set);
    if (symbolic > *work) *work = symbolic;
    return symbolic ? SP_OK : SP_E_MEMORY;
}

SP_API sp_status sp_sequence_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    size_t work = 0;
    const sp_status status = sp__sequence_work(scene, settings, scratch, &work);
    if (status) return status;
    sp_sequence *q = sp__take(&scratch, 1, sizeof *q);
    sp_arena dry = sp__arena_dry();
    if (!q) return SP_E_MEMORY;
    sp__take(&dry, 1, sizeof *q);
    sp__take(&dry, 1, sp_problem_memory(scene));
    sp__problem_count(scene, &q->pb);
    sp__sequence_carve(q, scene, &q->pb, work, &dry);
    if (sp__failed(&dry)) return SP_E_MEMORY;
    *bytes = dry.used;
    return SP_OK;
}

/* A free block that is there and not held. */
static int sp__loose(const sp_sequence *q, int32_t b)
{
    return q->row[b] >= 0 && q->stone[b].presence == SP_PRESENT;
}

static int32_t sp__beside(const sp_contact *t, int32_t b) { return t->joint->a == b ? t->joint->b : t->joint->a; }

typedef struct sp__grip { sp_real FF[21], GG[21], M[21]; } sp__grip;

/* F'F and G'G of a contact seen from block b, F = [1, -[x]], G = [x] F, x in units of the longest |x|: f = F (V, W) is a force
 * of the kind f0 has, x x f = G (V, W) its moment, [x]'[x] = |x|^2 - x x'. */
SP__APART static void sp__lever_matrices(const sp_problem *pb, const sp_contact *t, int32_t i, sp_real unit, sp__grip *w)
{
    for (int k = 0; k < 21; k++) w->FF[k] = w->GG[k] = 0;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp_real x[3], F[6][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
        sp__arm(pb, i, v, x);
        sp__scale3(1 / unit, x, x);
        const sp_real xx = sp__dot3(x, x);
        for (int k = 0; k < 3; k++) sp__cross3(F[k], x, F[3 + k]);
        for (int r = 0, e = 0; r < 6; r++)
            for (int c = 0; c <= r; c++, e++) {
                const sp_real f = sp__dot3(F[r], F[c]);
                w->FF[e] += f;
                w->GG[e] += xx * f - sp__dot3(F[r], x) * sp__dot3(F[c], x);
            }
    }
}

/* f0 = V + W x x over a contact, so sum |x x f0| >= lever sum |f0| with a lever of its shape alone: |G z|^2 >= share |F z|^2
 * for all z if G'G - share F'F is positive, and sums of norms are at least, at most sqrt(points) times, norms of all. A little
 * less, for what f0 may be out of balance and for rounding; 0 where points or an edge let f0 run through the centroid. */
SP__APART static sp_real sp__lever(const sp_problem *pb, const sp_contact *t, int32_t i, sp__grip *w)
{
    sp_real unit = 0, *M = w->M;
    for (int32_t v = t->point; v < t->point + t->points; v++) {
        sp__arm(pb, i, v, M);
        unit = sp__max(unit, sp__norm3(M));
    }
    if (!(unit > 0)) return 0;
    sp__lever_matrices(pb, t, i, unit, w);
    for (sp_real share = (sp_real)0.5; share > (sp_real)1e-4; share /= 2) {
        int positive = 1;
        for (int k = 0; k < 21; k++) M[k] = w->GG[k] - share * w->FF[k];
        sp__chol_factor(M, 6, 1000 * (sp_real)SP_EPSILON);
        for (int k = 0; k < 6; k++) positive &= M[k * (k + 3) / 2] < SP__NEVER / 2;
        if (positive) return (sp_real)0.9 * SP_SQRT(share / (sp_real)t->points) * unit;
    }
    return 0;
}

/* Levers, and the contacts at each block. */
SP__APART static sp_status sp__sequence_joints(sp_sequence *q)
{
    const int32_t n = q->scene->count.blocks;
    sp_arena a = q->work;
    sp__grip *w = sp__take(&a, 1, sizeof *w);
    if (!w) return SP_E_MEMORY;
    for (int32_t b = 0; b <= n; b++) q->start[b] = 0;
    for (int32_t i = 0; i < q->pb.blocks; i++) q->lever[i] = q->scene->block[q->pb.block[i]].fixed ? 0 : SP__HUGE;
    for (int32_t c = 0; c < q->pb.contacts; c++) {
        const sp_contact *t = &q->pb.contact[c];
        q->start[t->joint->a]++;
        q->start[t->joint->b]++;
        for (int side = 0; side < 2; side++) {
            const int32_t i = side ? t->b : t->a;
            if (i < 0) continue;
            const sp_real lever = sp__lever(&q->pb, t, i, w);
            if (lever < q->lever[i]) q->lever[i] = lever;
        }
    }
    for (int32_t b = 0; b < n; b++) q->start[b + 1] += q->start[b];
    for (int32_t c = q->pb.contacts - 1; c >= 0; c--) {
        q->joint[--q->start[q->pb.contact[c].joint->a]] = c;
        q->joint[--q->start[q->pb.contact[c].joint->b]] = c;
    }
    return SP_OK;
}

/* Blocks in the order of least fill of the finished scene. */
SP__APART static sp_status sp__sequence_order(sp_sequence *q)
{
    sp_arena a = q->work;
    sp__dual *w = sp__take(&a, 1, sizeof *w);
    if (!w || sp__dual_analyse(w, &q->pb, &a) < 0) return SP_E_MEMORY;
    for (int32_t k = 0; k < q->pb.blocks; k++) q->order[k] = q->pb.block[w->L.perm[k]];
    return SP_OK;
}

SP_API sp_status sp_sequence_open(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_sequence **sequence)
{
    if (!scene || !arena || !arena->base || !sequence) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    size_t work = 0;
    sp_arena a = *arena;
    sp_status status = sp__sequence_work(scene, settings, a, &work);
    if (status) return status;
    sp_sequence *q = sp__take(&a, 1, sizeof *q);
    if (!q) return SP_E_MEMORY;
    memset(q, 0, sizeof *q);
    q->scene = scene;
    status = sp__sequence_settings(scene, settings, &q->set);
    if (!status) status = sp_problem_build(scene, &a, &q->pb);
    if (status) return status;
    sp__sequence_carve(q, scene, &q->pb, work, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    memcpy(q->part.gravity, scene->gravity, sizeof q->part.gravity);
    memcpy(q->part.body, scene->body, sizeof q->part.body);
    q->part.live = scene->live;
    q->judge.pb = &q->pb;
    sp__judge_cone(&q->judge, &q->pb, &q->set);
    const size_t n = (size_t)scene->count.blocks;
    memset(q->stone, 0, n * sizeof *q->stone);
    memset(q->was, 0, n * sizeof *q->was);
    memset(q->f, 0, 3 * (size_t)scene->count.points * sizeof *q->f);
    memset(q->dq, 0, 6 * n * sizeof *q->dq);
    for (int32_t b = 0; b < scene->count.blocks; b++) {
        q->row[b] = sp__problem_row(&q->pb, b);
        q->number[b] = -1;
        q->up[b] = b;
        if (q->row[b] < 0) q->stone[b].presence = SP_PRESENT;
    }
    status = sp__sequence_joints(q);
    if (!status) status = sp__sequence_order(q);
    if (status) return status;
    *arena = a;
    *sequence = q;
    return SP_OK;
}

/* Which loose blocks hang together. */
static void sp__sequence_islands(sp_sequence *q)
{
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->up[b] = b;
    for (int32_t c = 0; c < q->pb.contacts; c++) {
        const sp_interface *t = q->pb.contact[c].joint;
        if (sp__loose(q, t->a) && sp__loose(q, t->b)) sp__join(q->up, t->a, t->b);
    }
}

/* Block b into the part. */
static void sp__part_block(sp_sequence *q, int32_t b, int fixed)
{
    sp_block *to = &q->part.block[q->part.count.blocks];
    *to = q->scene->block[b];
    to->vertex = to->vertices = to->face = to->faces = 0;
    if (fixed) to->fixed = SP_FIXED;
    q->part_block[q->part.count.blocks] = b;
    q->number[b] = q->part.count.blocks++;
}

/* Contact c into the part, if it is between members or of one and something fixed. */
static void sp__part_joint(sp_sequence *q, int32_t c)
{
    const sp_interface *t = q->pb.contact[c].joint;
    const int32_t end[2] = { t->a, t->b };
    int inside = 0;
    for (int k = 0; k < 2; k++) inside += q->number[end[k]] >= 0 && q->number[end[k]] < q->members;
    if (!inside) return;
    for (int k = 0; k < 2 && inside < 2; k++) {
        if (q->number[end[k]] >= 0 && q->number[end[k]] < q->members) continue;
        if (q->stone[end[k]].presence == SP_ABSENT || sp__loose(q, end[k])) return;
        if (q->number[end[k]] < 0) sp__part_block(q, end[k], 1);
    }
    sp_interface *to = &q->part.interface[q->part.count.interfaces];
    *to = *t;
    to->a = q->number[t->a];
    to->b = q->number[t->b];
    to->point = q->part.count.points;
    memcpy(q->part.point[to->point], q->scene->point[t->point], (size_t)t->points * sizeof *q->part.point);
    q->part.count.points += t->points;
    q->part_joint[q->part.count.interfaces++] = c;
}

/* The part of all marked blocks. */
SP__APART static void sp__part_make(sp_sequence *q)
{
    sp_capacity *n = &q->part.count;
    memset(n, 0, sizeof *n);
    for (int32_t k = 0; k < q->pb.blocks; k++) if (q->mark[q->order[k]]) sp__part_block(q, q->order[k], 0);
    q->members = n->blocks;
    for (int32_t c = 0; c < q->pb.contacts; c++) sp__part_joint(q, c);
    for (int32_t k = 0; k < q->scene->count.loads; k++) {
        const sp_load *load = &q->scene->load[k];
        if (!q->mark[load->block]) continue;
        q->part.load[n->loads] = *load;
        q->part.load[n->loads++].block = q->number[load->block];
    }
    for (int32_t k = 0; k < n->blocks; k++) q->number[q->part_block[k]] = -1;
}

/* The part of the island of `root`. */
static void sp__part_island(sp_sequence *q, int32_t root)
{
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->mark[b] = sp__loose(q, b) && sp__root(q->up, b) == root;
    sp__part_make(q);
}

/* A check of the part in `a`, before the first stage. */
SP__APART static sp_status sp__part_open(sp_sequence *q, sp_arena *a, sp__check **c)
{
    const sp__apart one = { 1, 0, 0 };
    sp_status status = sp__check_open(&q->part, &q->set, &one, a, c);
    if (!status) status = sp__check_problem(*c, a);
    if (!status) (*c)->pb.ordered = 1;
    return status;
}

/* Does the part stand? sp_check without what is only told. */
SP__APART static sp_status sp__part_check(sp_sequence *q, sp__check **c)
{
    sp_arena a = q->work;
    sp_status status = sp__part_open(q, &a, c);
    if (status) return status;
    if ((*c)->pb.blocks) status = sp__check_run(&(*c)->pb, &(*c)->set, &(*c)->state, &a, &(*c)->r);
    sp__cost_add(&q->cost, &(*c)->r.cost);
    return status;
}

/* F, m: force on block b at vertex v of contact t, its moment about the centroid, both in units. */
static void sp__stone_force(const sp_sequence *q, const sp_contact *t, int32_t b, int32_t v, sp_real F[3], sp_real m[3])
{
    const sp_interface *j = t->joint;
    const sp_real *f = q->f + 3 * (size_t)v, sign = (j->b == b ? 1 : -1) / q->judge.unit;
    sp_real arm[3];
    for (int k = 0; k < 3; k++) F[k] = sign * (f[0] * j->n[k] + f[1] * j->t1[k] + f[2] * j->t2[k]);
    sp__arm(&q->pb, q->row[b], v, arm);
    sp__cross3(arm, F, m);
}

/* |load| of the free blocks of a contact, the lesser, in units; SP__HUGE: none of them is loose. */
static sp_real sp__stone_load(const sp_sequence *q, const sp_contact *t)
{
    sp_real least = SP__HUGE;
    for (int side = 0; side < 2; side++) {
        const int32_t b = side ? t->joint->b : t->joint->a;
        sp_real p[6];
        if (!sp__loose(q, b)) continue;
        sp__judge_load(&q->judge, q->row[b], p);
        const sp_real load = sp__norm3(p);
        if (load < least) least = load;
    }
    return least;
}

/* Is block b plain? Its omega, or more. */
SP__APART static void sp__stone_weigh(sp_sequence *q, int32_t b)
{
    sp__stone *s = &q->stone[b];
    sp_real r[6], m1 = 0;
    int large = 0;
    sp__judge_load(&q->judge, q->row[b], r);
    const sp_real load = sp__norm3(r), couple = sp__norm3(r + 3), lever = q->lever[q->row[b]] * load;
    for (int32_t k = q->start[b]; k < q->start[b + 1]; k++) {
        const sp_contact *t = &q->pb.contact[q->joint[k]];
        if (q->stone[sp__beside(t, b)].presence == SP_ABSENT) continue;
        const sp_real most = q->set.force_bound * sp__stone_load(q, t);
        for (int32_t v = t->point; v < t->point + t->points; v++) {
            sp_real F[3], m[3];
            sp__stone_force(q, t, b, v, F, m);
            for (int c = 0; c < 3; c++) { r[c] += F[c]; r[3 + c] += m[c]; }
            if (m1 < lever) m1 += sp__norm3(m);
            large |= sp__dot3(F, F) > most * most;
        }
        q->cost.flops += 60 * (int64_t)t->points;
    }
    const sp_real arm = m1 < lever ? m1 : lever;
    s->omega = sp__max(sp__ratio(sp__norm3(r), (sp_real)1.8 * load), sp__ratio(sp__norm3(r + 3), couple + arm));
    s->plain = s->omega <= SP__PLAIN_TOL * q->set.tol && !large && q->lever[q->row[b]] > 0;
}

/* What a check of the part found becomes what is known of its blocks. */
SP__APART static void sp__part_keep(sp_sequence *q, const sp__check *c)
{
    for (int32_t k = 0; k < q->part.count.interfaces; k++) {
        const sp_interface *t = &q->part.interface[k];
        memcpy(q->f + 3 * (size_t)q->pb.contact[q->part_joint[k]].point, c->r.f + 3 * (size_t)t->point,
               3 * (size_t)t->points * sizeof *q->f);
    }
    for (int32_t k = 0; k < q->members; k++) {
        const int32_t b = q->part_block[k];
        sp__stone *s = &q->stone[b];
        sp_real *dq = q->dq + 6 * (size_t)b;
        s->plain = 0;
        if (c->r.verdict == SP_STABLE) sp__stone_weigh(q, b);
        for (size_t i = 0; i < 6; i++) dq[i] = c->r.verdict == SP_UNSTABLE ? c->r.dq[6 * (size_t)k + i] : 0;
        s->verdict = c->r.verdict;
        s->reason = c->r.reason;
        s->final = c->r.final;
        s->omega = c->r.omega;
        s->least = c->r.least_imbalance;
    }
    q->again += q->members;
}

static void sp__lean_add(sp_sequence *q, int32_t b, int32_t origin, int32_t *n)
{
    if (q->mark[b]) return;
    q->mark[b] = 1;
    q->list[*n] = b;
    q->origin[(*n)++] = origin;
}

/* How far block s is from block o across gravity g, squared; -1: s is not below b. */
static sp_real sp__lean_aside(const sp_sequence *q, const sp_contact *t, int32_t b, int32_t o)
{
    const sp_real *g = q->scene->gravity, size = sp__norm3(g);
    const int32_t s = sp__beside(t, b);
    sp_real d[3], n[3];
    sp__scale3(t->joint->a == b ? 1 : -1, t->joint->n, n);
    if (!(sp__dot3(n, g) > SP__BELOW * size)) return -1;
    sp__sub3(q->scene->block[s].centroid, q->scene->block[o].centroid, d);
    const sp_real along = sp__dot3(d, g) / size;
    return sp__max(0, sp__dot3(d, d) - along * along);
}

/* The blocks below block b that lie straightest below block o, unless b reaches something fixed. */
SP__APART static void sp__lean_below(sp_sequence *q, int32_t b, int32_t o, int32_t *n)
{
    sp_real least = SP__HUGE;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t k = q->start[b]; k < q->start[b + 1]; k++) {
            const sp_contact *t = &q->pb.contact[q->joint[k]];
            const int32_t s = sp__beside(t, b);
            const sp_real aside = q->stone[s].presence == SP_ABSENT ? -1 : sp__lean_aside(q, t, b, o);
            if (aside < 0) continue;
            if (!sp__loose(q, s)) return;
            if (pass && aside <= (sp_real)1.05 * least) sp__lean_add(q, s, o, n);
            if (aside < least) least = aside;
        }
}

/* All loose blocks that block b touches. */
static void sp__lean_beside(sp_sequence *q, int32_t b, int32_t *n)
{
    for (int32_t k = q->start[b]; k < q->start[b + 1]; k++) {
        const int32_t s = sp__beside(&q->pb.contact[q->joint[k]], b);
        if (sp__loose(q, s)) sp__lean_add(q, s, b, n);
    }
}

/* The island of `root`: marks what is not plain and what is below that, wide: and what touches those.
 *     returns how many; 0: nothing, -1: most of it */
SP__APART static int32_t sp__lean_choose(sp_sequence *q, int32_t root, int wide)
{
    int32_t n = 0, size = 0;
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->mark[b] = 0;
    for (int32_t b = root; b < q->scene->count.blocks; b++) {
        if (!sp__loose(q, b) || sp__root(q->up, b) != root) continue;
        size++;
        if (!q->stone[b].plain) sp__stone_weigh(q, b);
        if (!q->stone[b].plain) sp__lean_add(q, b, b, &n);
    }
    for (int32_t k = 0; k < n && 2 * n <= size; k++) sp__lean_below(q, q->list[k], q->origin[k], &n);
    const int32_t narrow = wide ? n : 0;
    for (int32_t k = 0; k < narrow && 2 * n <= size; k++) sp__lean_beside(q, q->list[k], &n);
    return 2 * n > size ? -1 : n;
}

/* Forces of joints with loose blocks outside the part are loads on it; where they cancel, what rounding left goes: it has no mirror. */
SP__APART static void sp__lean_load(sp_sequence *q, const sp_problem *pb)
{
    for (int32_t i = 0; i < q->members; i++) {
        const int32_t b = q->part_block[i];
        sp_real *p = pb->p + 6 * (size_t)i, size[2] = { sp__norm3(p), sp__norm3(p + 3) };
        for (int32_t k = q->start[b]; k < q->start[b + 1]; k++) {
            const sp_contact *t = &q->pb.contact[q->joint[k]];
            const int32_t s = sp__beside(t, b);
            if (!sp__loose(q, s) || q->mark[s]) continue;
            for (int32_t v = t->point; v < t->point + t->points; v++) {
                sp_real F[3], m[3];
                sp__stone_force(q, t, b, v, F, m);
                for (int c = 0; c < 3; c++) { p[c] += q->judge.unit * F[c]; p[3 + c] += q->judge.unit * m[c]; }
                size[0] += q->judge.unit * sp__norm3(F);
                size[1] += q->judge.unit * sp__norm3(m);
            }
            q->cost.flops += 76 * (int64_t)t->points;
        }
        for (int c = 0; c < 6; c++)
            if (sp__abs(p[c]) <= 64 * (sp_real)SP_EPSILON * size[c / 3]) p[c] = 0;
    }
}

/* Forces of the part's joints, admitted.     returns 1 if all its blocks are plain then */
SP__APART static int sp__lean_keep(sp_sequence *q, const sp__check *c)
{
    int plain = 1;
    for (int32_t k = 0; k < q->part.count.interfaces; k++) {
        const sp_interface *from = &q->part.interface[k];
        const sp_contact *t = &q->pb.contact[q->part_joint[k]];
        q->judge.cap = q->set.force_bound * sp__stone_load(q, t);
        for (int32_t v = 0; v < t->points; v++) {
            sp_real *f = q->f + 3 * (size_t)(t->point + v), g[3];
            sp__scale3(1 / q->judge.unit, c->state.f + 3 * (size_t)(from->point + v), g);
            sp__judge_admit(&q->judge, t, g, g);
            sp__scale3(q->judge.unit, g, f);
        }
    }
    for (int32_t k = 0; k < q->members; k++) {
        sp__stone_weigh(q, q->part_block[k]);
        plain &= q->stone[q->part_block[k]].plain;
    }
    return plain;
}

/* The marked blocks alone, all other forces as they are: in their plane where they, with these as loads, have one.
 *     returns 1 if they are plain then */
SP__APART static int sp__lean_solve(sp_sequence *q)
{
    sp__check *c = NULL;
    sp__flat *flat = NULL;
    sp_arena a = q->work;
    sp_verdict claim = SP_UNDECIDED;
    sp__part_make(q);
    if (sp__part_open(q, &a, &c)) return 0;
    sp__lean_load(q, &c->pb);
#ifndef SP_NO_PLAN
    sp_arena room = a;
    sp__flat *o = sp__take(&room, 1, sizeof *o);
    if (o && sp__flat_choose(&c->pb, &c->set, o) && o->mode == SP__PLANE) { flat = o; a = room; }
#endif
    if (c->set.iterations > SP__LEAN_STEPS) c->set.iterations = SP__LEAN_STEPS;
    c->set.tol *= SP__LEAN_TOL;
    c->state.left = sp__budget_left(&c->set, &c->r);
    const sp_status status = sp__exact_search(&c->pb, &c->set, flat, &c->state, &a, &claim);
    sp__cost_add(&q->cost, &c->state.cost);
    q->again += q->members;
    return !status && claim != SP_UNSTABLE && sp__all_finite(c->state.f, 3 * (size_t)c->pb.points) && sp__lean_keep(q, c);
}

/* Do forces near those of the step before balance the island of `root`? Then that is what is known of it. */
SP__APART static int sp__lean_island(sp_sequence *q, int32_t root)
{
    int exact = 0, done = 0;
    for (int32_t k = 0; k < q->set.stage_count; k++) exact |= q->set.stage[k] == SP_STAGE_EXACT;
    for (int wide = 0; wide < 2 && exact && !done; wide++) {
        const int32_t n = sp__lean_choose(q, root, wide);
        if (n < 0) return 0;
        done = n == 0 || sp__lean_solve(q);
    }
    if (!done) return 0;
    for (int32_t b = root; b < q->scene->count.blocks; b++) {
        sp__stone *s = &q->stone[b];
        if (!sp__loose(q, b) || sp__root(q->up, b) != root) continue;
        s->verdict = SP_STABLE;
        s->reason = SP_REASON_FORCES;
        s->final = 0;
        s->least = 0;
        for (size_t k = 0; k < 6; k++) q->dq[6 * (size_t)b + k] = 0;
    }
    q->local++;
    return 1;
}

/* Every island with a stale block is looked at again. */
SP__APART static sp_status sp__sequence_look(sp_sequence *q)
{
    for (int32_t b = 0; b < q->scene->count.blocks; b++)
        if (sp__loose(q, b) && q->stone[b].stale) q->stone[sp__root(q->up, b)].stale = 1;
    for (int32_t root = 0; root < q->scene->count.blocks; root++) {
        if (!sp__loose(q, root) || sp__root(q->up, root) != root || !q->stone[root].stale) continue;
        q->checked++;
        if (sp__lean_island(q, root)) continue;
        sp__check *c = NULL;
        sp__part_island(q, root);
        const sp_status status = sp__part_check(q, &c);
        if (status) return status;
        sp__part_keep(q, c);
    }
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->stone[b].stale = 0;
    return SP_OK;
}

/* The islands of block b and of what it touches are stale. */
static void sp__sequence_touch(sp_sequence *q, int32_t b)
{
    const int32_t n = q->scene->count.blocks;
    for (int32_t k = 0; k < n; k++) q->mark[k] = 0;
    if (sp__loose(q, b)) q->mark[sp__root(q->up, b)] = 1;
    for (int32_t k = q->start[b]; k < q->start[b + 1]; k++) {
        const int32_t s = sp__beside(&q->pb.contact[q->joint[k]], b);
        if (sp__loose(q, s)) q->mark[sp__root(q->up, s)] = 1;
    }
    for (int32_t k = 0; k < n; k++) q->stone[k].stale |= sp__loose(q, k) && q->mark[sp__root(q->up, k)];
}

/* Block b comes, goes, is held or let go: forces of joints that no longer count vanish, and who bore them is to be weighed. */
SP__APART static void sp__sequence_change(sp_sequence *q, int32_t b, sp_presence presence)
{
    sp__sequence_touch(q, b);
    q->stone[b].presence = presence;
    q->stone[b].plain = 0;
    if (!sp__loose(q, b)) for (size_t k = 0; k < 6; k++) q->dq[6 * (size_t)b + k] = 0;
    for (int32_t k = q->start[b]; k < q->start[b + 1]; k++) {
        const sp_contact *t = &q->pb.contact[q->joint[k]];
        const int32_t s = sp__beside(t, b);
        if (presence != SP_ABSENT && q->stone[s].presence != SP_ABSENT && (sp__loose(q, b) || sp__loose(q, s))) continue;
        q->stone[s].plain = 0;
        memset(q->f + 3 * (size_t)t->point, 0, 3 * (size_t)t->points * sizeof *q->f);
    }
    if (presence == SP_ABSENT) q->was[b] = 0;
}

static void sp__sequence_start(sp_sequence *q)
{
    memset(&q->cost, 0, sizeof q->cost);
    q->checked = q->again = q->local = q->tries = 0;
}

/* Is it worse: unstable, then undecided, then stable? */
static int sp__worse(sp_verdict a, sp_verdict b)
{
    return a == SP_STABLE ? 0 : b == SP_STABLE || (a == SP_UNSTABLE && b == SP_UNDECIDED);
}

/* What the step found. */
SP__APART static void sp__sequence_tell(sp_sequence *q, sp_step *step)
{
    sp_real most = -1;
    memset(step, 0, sizeof *step);
    step->verdict = SP_STABLE;
    step->reason = SP_REASON_NOTHING;
    step->block = -1;
    for (int32_t b = 0; b < q->scene->count.blocks; b++) {
        const sp__stone *s = &q->stone[b];
        if (!sp__loose(q, b)) continue;
        step->blocks++;
        step->islands += sp__root(q->up, b) == b;
        step->omega = sp__max(step->omega, s->omega);
        if (step->blocks == 1 || sp__worse(s->verdict, step->verdict)
            || (s->verdict == SP_STABLE && step->verdict == SP_STABLE && s->reason == SP_REASON_FORCES)) {
            if (s->verdict != step->verdict) step->block = b;
            step->verdict = s->verdict;
            step->reason = s->reason;
            step->final = s->final;
            step->least_imbalance = s->least;
        }
    }
    for (int32_t b = 0, root = step->block; root >= 0 && b < q->scene->count.blocks; b++) {
        const sp_real *dq = q->dq + 6 * (size_t)b;
        if (!sp__loose(q, b) || sp__root(q->up, b) != sp__root(q->up, root) || !(sp__norm3(dq) > most)) continue;
        most = sp__norm3(dq);
        step->block = b;
    }
    step->checked = q->checked;
    step->again = q->again;
    step->local = q->local;
    step->f = q->f;
    step->dq = q->dq;
    step->cost = q->cost;
}

static int sp__presence_valid(sp_presence presence)
{
    return presence == SP_ABSENT || presence == SP_PRESENT || presence == SP_HELD;
}

SP_API sp_status sp_sequence_set(sp_sequence *sequence, int32_t block, sp_presence presence, sp_step *step)
{
    if (!sequence || !step || !sp__presence_valid(presence)) return SP_E_ARGUMENT;
    if (block < 0 || block >= sequence->scene->count.blocks) return SP_E_INDEX;
    sp__sequence_start(sequence);
    if (presence != sequence->stone[block].presence) {
        sp__sequence_change(sequence, block, presence);
        sp__sequence_islands(sequence);
        sp__sequence_touch(sequence, block);
        const sp_status status = sp__sequence_look(sequence);
        if (status) return status;
    }
    sp__sequence_tell(sequence, step);
    return SP_OK;
}

SP_API sp_status sp_sequence_fill(sp_sequence *sequence, const sp_presence *presence, sp_step *step)
{
    if (!sequence || !presence || !step) return SP_E_ARGUMENT;
    for (int32_t b = 0; b < sequence->scene->count.blocks; b++) if (!sp__presence_valid(presence[b])) return SP_E_ARGUMENT;
    sp__sequence_start(sequence);
    for (int32_t b = 0; b < sequence->scene->count.blocks; b++)
        if (presence[b] != sequence->stone[b].presence) sp__sequence_change(sequence, b, presence[b]);
    sp__sequence_islands(sequence);
    for (int32_t b = 0; b < sequence->scene->count.blocks; b++) sequence->stone[b].stale = sp__loose(sequence, b);
    const sp_status status = sp__sequence_look(sequence);
    if (status) return status;
    sp__sequence_tell(sequence, step);
    return SP_OK;
}

/* 33 ------------------------------------------------------------------------------------------------------- what to hold */

/* Holding a block takes its six equations away and forbids no force: whatever set makes an assembly stand, a larger one does,
 * too (forces between two held blocks are 0, which every K_v holds). So a block that falls with all others held is in every set,
 * one pass of letting go leaves a set that can lose no block, and sets of one and two need few proofs. */

/* Do the members stand that are not held now?     returns 0 also when the budget is spent */
SP__APART static int sp__hold_stands(sp__hold *h)
{
    sp_sequence *q = h->q;
    q->tries++;
    sp__sequence_islands(q);
    for (int32_t k = 0; k < h->members; k++) {
        sp__check *c = NULL;
        const int32_t root = h->member[k];
        if (!sp__loose(q, root) || sp__root(q->up, root) != root) continue;
        h->over |= h->budget > 0 && q->cost.flops >= h->budget;
        if (h->over) return 0;
        sp__part_island(q, root);
        h->status = sp__part_check(q, &c);
        if (h->status) { h->over = 1; return 0; }
        if (c->r.verdict == SP_STABLE) continue;
        h->unsure |= c->r.verdict == SP_UNDECIDED;
        sp_real most = -1;
        for (int32_t i = 0; i < q->members; i++) {
            const sp_real *dq = c->r.dq + 6 * (size_t)i, size = sp__norm3(dq);
            if (!(size > most) && !(size >= most && q->part_block[i] < h->worst)) continue;
            most = size;
            h->worst = q->part_block[i];
        }
        return 0;
    }
    return 1;
}

static void sp__hold_all(const sp__hold *h, sp_presence presence)
{
    for (int32_t k = 0; k < h->members; k++) h->q->stone[h->member[k]].presence = presence;
}

/* must[b]: b falls even when all other members are held. */
SP__APART static void sp__hold_must(sp__hold *h)
{
    sp_sequence *q = h->q;
    sp__hold_all(h, SP_HELD);
    for (int32_t k = 0; k < h->members && !h->over; k++) {
        h->unsure = 0;                                  /* of these sets nothing is claimed but who falls */
        q->stone[h->member[k]].presence = SP_PRESENT;
        q->must[h->member[k]] = !sp__hold_stands(h) && !h->over && !h->unsure;
        q->stone[h->member[k]].presence = SP_HELD;
    }
}

/* Exactly the members of this set are held. */
static void sp__hold_set(const sp__hold *h, uint32_t set)
{
    for (int32_t k = 0; k < h->members; k++) h->q->stone[h->member[k]].presence = set >> k & 1u ? SP_HELD : SP_PRESENT;
}

static int32_t sp__hold_size(const sp__hold *h)
{
    int32_t n = 0;
    for (int32_t k = 0; k < h->members; k++) n += h->q->stone[h->member[k]].presence == SP_HELD;
    return n;
}

/* All sets that hold what must be, the smallest first, in the order of their numbers.     leaves the first that does */
SP__APART static sp_held_proof sp__hold_exhaust(sp__hold *h)
{
    uint32_t must = 0;
    for (int32_t k = 0; k < h->members; k++) if (h->q->must[h->member[k]]) must |= 1u << k;
    for (int32_t size = 1; size <= h->members; size++)
        for (uint32_t set = 1; set < 1u << h->members && !h->over; set++) {
            sp__hold_set(h, set);
            if ((set & must) != must || sp__hold_size(h) != size) continue;
            if (sp__hold_stands(h)) return SP_HELD_MINIMAL;
        }
    sp__hold_all(h, SP_HELD);
    return SP_HELD_ENOUGH;
}

/* Of those that can't be let go one is minimal; of two, does one of the others suffice?     leaves it so if it does */
SP__APART static sp_held_proof sp__hold_one(sp__hold *h)
{
    sp_sequence *q = h->q;
    int32_t pair[2] = { -1, -1 }, n = 0;
    if (sp__hold_size(h) < 2) return SP_HELD_MINIMAL;
    if (sp__hold_size(h) > 2) return SP_HELD_IRREDUCIBLE;
    for (int32_t k = 0; k < h->members; k++)
        if (q->stone[h->member[k]].presence == SP_HELD) pair[n++] = h->member[k];
    sp__hold_all(h, SP_PRESENT);
    for (int32_t k = 0; k < h->members && !h->over; k++) {
        const int32_t b = h->member[k];
        if (b == pair[0] || b == pair[1] || (h->known && !q->must[b])) continue;    /* the pair itself: letting go has tried */
        q->stone[b].presence = SP_HELD;
        if (sp__hold_stands(h)) return SP_HELD_MINIMAL;
        q->stone[b].presence = SP_PRESENT;
    }
    q->stone[pair[0]].presence = q->stone[pair[1]].presence = SP_HELD;
    return h->over ? SP_HELD_IRREDUCIBLE : SP_HELD_MINIMAL;
}

/* What must be held and what was held last; then what moves most, until it stands; then each let go that can be. */
SP__APART static sp_held_proof sp__hold_guided(sp__hold *h)
{
    sp_sequence *q = h->q;
    int32_t must = 0;
    for (int32_t k = 0; k < h->members; k++) {
        const int32_t b = h->member[k];
        must += q->must[b];
        q->stone[b].presence = q->must[b] || q->was[b] ? SP_HELD : SP_PRESENT;
    }
    while (!sp__hold_stands(h)) {
        if (h->over) { sp__hold_all(h, SP_HELD); return SP_HELD_ENOUGH; }
        q->stone[h->worst].presence = SP_HELD;
    }
    for (int32_t k = 0; k < h->members && !h->over; k++) {
        const int32_t b = h->member[k];
        if (q->stone[b].presence != SP_HELD || q->must[b]) continue;
        q->stone[b].presence = SP_PRESENT;
        if (!sp__hold_stands(h)) q->stone[b].presence = SP_HELD;
    }
    h->known = must;
    return h->over ? SP_HELD_ENOUGH : sp__hold_size(h) == must ? SP_HELD_MINIMAL : SP_HELD_IRREDUCIBLE;
}

/* The island whose lowest block is q->list[0..members-1]'s first; its set to the answer. */
SP__APART static sp_status sp__hold_island(sp__hold *h)
{
    sp_sequence *q = h->q;
    h->worst = h->member[0];
    for (int32_t k = 0; k < h->members; k++) q->must[h->member[k]] = 0;
    sp__hold_must(h);
    h->unsure = q->stone[h->member[0]].verdict == SP_UNDECIDED;     /* that of none held */
    sp_held_proof proof = h->members <= SP_HELD_EXHAUSTIVE ? sp__hold_exhaust(h) : sp__hold_guided(h);
    if (proof == SP_HELD_IRREDUCIBLE) proof = sp__hold_one(h);
    if (h->unsure) proof = SP_HELD_ENOUGH;
    if (proof > h->proof) h->proof = proof;
    for (int32_t k = 0; k < h->members; k++) {
        const int32_t b = h->member[k];
        q->was[b] = q->stone[b].presence == SP_HELD;
        if (q->was[b]) q->answer[h->count++] = b;
        q->stone[b].presence = SP_PRESENT;
    }
    sp__sequence_islands(q);
    return h->status;
}

SP_API sp_status sp_sequence_hold(sp_sequence *sequence, int64_t budget, sp_held *held)
{
    if (!sequence || !held || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    sp__hold *h = &q->hold;
    memset(h, 0, sizeof *h);
    h->q = q;
    h->member = q->list;
    h->budget = budget;
    sp__sequence_start(q);
    for (int32_t root = 0; root < q->scene->count.blocks; root++) {
        if (!sp__loose(q, root) || sp__root(q->up, root) != root || q->stone[root].verdict == SP_STABLE) continue;
        h->members = 0;
        for (int32_t b = root; b < q->scene->count.blocks; b++)
            if (sp__loose(q, b) && sp__root(q->up, b) == root) q->list[h->members++] = b;
        const sp_status status = sp__hold_island(h);
        if (status) return status;
    }
    for (int32_t k = 0; k < h->count; k++) q->list[k] = q->must[q->answer[k]];
    memset(held, 0, sizeof *held);
    held->count = h->count;
    held->block = q->answer;
    held->must = q->list;
    held->proof = h->proof;
    held->checks = q->tries;
    held->cost = q->cost;
    return SP_OK;
}

#define SP__LEVEL ((sp_real)1e-3)        /* of its diameter: so much lower is no lower */

/* May block b be tried as the next one? */
static int sp__next_candidate(const sp_sequence *q, int32_t b, int32_t add)
{
    if (q->row[b] < 0) return 0;
    if (!add) return q->stone[b].presence == SP_PRESENT;
    if (q->stone[b].presence != SP_ABSENT) return 0;
    for (int32_t k = q->start[b]; k < q->start[b + 1]; k++)
        if (q->stone[sp__beside(&q->pb.contact[q->joint[k]], b)].presence != SP_ABSENT) return 1;
    return 0;
}

/* The lowest (to add) or highest candidate not tried yet, q->answer 0; -1: none. */
static int32_t sp__next_pick(sp_sequence *q, int32_t add)
{
    int32_t best = -1;
    for (int32_t b = 0; b < q->scene->count.blocks; b++) {
        const sp_real *g = q->scene->gravity;
        sp_real d[3] = { 0, 0, 0 };
        if (q->answer[b]) continue;
        if (best >= 0) sp__sub3(q->scene->block[b].centroid, q->scene->block[best].centroid, d);
        const sp_real deeper = (add ? 1 : -1) * sp__dot3(d, g);
        if (best < 0 || deeper > SP__LEVEL * q->scene->block[b].diameter * sp__norm3(g)) best = b;
    }
    if (best >= 0) q->answer[best] = 1;
    return best;
}

/* Would everything stand with block b there, or gone? All that is known stays as it is. */
SP__APART static sp_status sp__next_try(sp_sequence *q, int32_t b, int32_t add, int *stands)
{
    const size_t n = (size_t)q->scene->count.blocks, v = 3 * (size_t)q->scene->count.points;
    const int32_t was = q->was[b];
    memcpy(q->stone_kept, q->stone, n * sizeof *q->stone);
    memcpy(q->f_kept, q->f, v * sizeof *q->f);
    memcpy(q->dq_kept, q->dq, 6 * n * sizeof *q->dq);
    sp__sequence_change(q, b, add ? SP_PRESENT : SP_ABSENT);
    sp__sequence_islands(q);
    sp__sequence_touch(q, b);
    const sp_status status = sp__sequence_look(q);
    *stands = 1;
    for (int32_t k = 0; k < q->scene->count.blocks; k++) *stands &= !sp__loose(q, k) || q->stone[k].verdict == SP_STABLE;
    memcpy(q->stone, q->stone_kept, n * sizeof *q->stone);
    memcpy(q->f, q->f_kept, v * sizeof *q->f);
    memcpy(q->dq, q->dq_kept, 6 * n * sizeof *q->dq);
    q->was[b] = was;
    sp__sequence_islands(q);
    return status;
}

SP_API sp_status sp_sequence_suggest(sp_sequence *sequence, int32_t add, int64_t budget, sp_suggestion *suggestion)
{
    if (!sequence || !suggestion || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    int32_t found = -1, tried = 0, all = 1;
    sp__sequence_start(q);
    for (int32_t b = 0; b < q->scene->count.blocks; b++) q->answer[b] = !sp__next_candidate(q, b, add);
    for (int32_t b = sp__next_pick(q, add); b >= 0 && found < 0; b = sp__next_pick(q, add)) {
        int stands = 0;
        all = !(budget > 0 && q->cost.flops >= budget);
        if (!all) break;
        const sp_status status = sp__next_try(q, b, add, &stands);
        if (status) return status;
        tried++;
        if (stands) found = b;
    }
    suggestion->block = found;
    suggestion->tried = tried;
    suggestion->all = all;
    suggestion->cost = q->cost;
    return SP_OK;
}

#endif /* SP_SMALL */

#ifndef SP_NO_IPM
/* 34 ----------------------------------------------------------------------------------------------------- limit: both ends */

/* What proves an end of the bracket, by the certificate check alone: forces that balance dead + lower live; a motion that falls
 * under dead + upper live and that live loads push on rather than hinder, so that it falls at every larger multiple, too;
 * forces that balance the live loads alone, which may be added to others as often as one likes (the cones are convex). */
typedef struct sp__ends {
    sp_settings set, wide;              /* resolved; with a pyramid around the cone: `final` then tells of it */
    sp_scene scene;                     /* without live loads in p */
    sp_problem pb;                      /* p: some multiples of both loads */
    sp_real *dead, *live;               /* 6b each */
    const sp_real *y0;                  /* 24b: hints for both; may be NULL */
    sp_real *hint;                      /* 12b: for the loads at hand */
    sp_real *dq, *whole;                /* 6b: the motion; with what is held in dq */
    sp_real omega, least, resist;       /* resist: work that joints with strength take of the motion judged last [N m] */
    int32_t final;
    int64_t limit;                      /* flops in all */
    sp_cost cost;
    int spent;                          /* a judgement did not fit */
    sp__judge judge;                    /* the one at hand */
} sp__ends;

/* dead, live, dq, whole, hint */
static void sp__ends_carve(sp_real *at[5], int32_t blocks, sp_arena *a)
{
    for (int k = 0; k < 5; k++) at[k] = sp__take(a, (size_t)blocks, (k < 4 ? 6 : 12) * sizeof *at[k]);
}

static sp_status sp__ends_build(const sp_scene *scene, const sp_settings *settings, sp__ends *e, sp_arena *a)
{
    e->scene = *scene;
    e->scene.live = 0;
    sp_status status = sp__settings_resolve(scene, settings, &e->set);
    if (!status && e->set.coupled.asked) status = SP_E_UNSUPPORTED;
    if (!status) status = sp_problem_build(&e->scene, a, &e->pb);
    if (status) return status;
    e->wide = e->set;
    e->wide.inscribed = 0;
    e->limit = e->set.budget > 0 ? e->set.budget : INT64_MAX / 4;
    memset(&e->cost, 0, sizeof e->cost);
    e->spent = 0;
    e->resist = 0;
    sp_real *at[5];
    sp__ends_carve(at, e->pb.blocks, a);
    if (sp__failed(a)) return SP_E_MEMORY;
    e->dead = at[0]; e->live = at[1]; e->dq = at[2]; e->whole = at[3]; e->hint = at[4];
    const size_t bytes = 6 * (size_t)e->pb.blocks * sizeof *e->dead;
    memcpy(e->dead, e->pb.p, bytes);
    if (e->pb.live) memcpy(e->live, e->pb.live, bytes); else memset(e->live, 0, bytes);
    memset(e->dq, 0, bytes);
    return SP_OK;
}

/* p = d dead + l live. Live loads without dead ones stand for ever more of them: what they want of joints is there without end. */
static void sp__ends_mix(sp__ends *e, sp_real d, sp_real l)
{
    const size_t n = 6 * (size_t)e->pb.blocks;
    e->pb.endless = !(d > 0);
    for (size_t k = 0; k < n; k++) e->pb.p[k] = d * e->dead[k] + l * e->live[k];
    for (size_t k = 0; k < 2 * n && e->y0; k++) e->hint[k] = d * e->y0[k] + l * e->y0[2 * n + k];
}

/* A judge for d dead + l live, while ten sweeps and more are left of the budget; what it took is counted when it is closed. */
static int sp__ends_open(sp__ends *e, sp_real d, sp_real l, sp_arena *room)
{
    const int64_t sweep = SP__FLOPS_JUDGE * (int64_t)e->pb.points, left = e->limit - e->cost.flops;
    const int64_t sweeps = sweep ? left / sweep - 8 : INT32_MAX;
    if (sweeps < 2) { e->spent = 1; return 0; }
    sp__ends_mix(e, d, l);
    return sp__judge_open(&e->judge, &e->pb, &e->set, e->y0 ? e->hint : NULL, sweeps < INT32_MAX ? (int32_t)sweeps : INT32_MAX,
                          room);
}

SP__CALLED static void sp__ends_close(sp__ends *e)
{
    e->cost.flops += SP__FLOPS_JUDGE * (int64_t)e->judge.sweeps * e->pb.points;
}

/* Do these forces balance d dead + l live?     admitted: as sp__judge_forces */
SP__APART static int sp__ends_stand(sp__ends *e, sp_real d, sp_real l, const sp_real *f, sp_real *admitted, sp_arena room)
{
    if (!sp__ends_open(e, d, l, &room)) return 0;
    e->omega = sp__judge_forces(&e->judge, f, admitted);
    sp__ends_close(e);
    return e->omega <= e->set.tol;
}

static sp_real sp__ends_work(const sp__ends *e, const sp_real *load)
{
    return sp__dot(load, e->dq, 6 * (size_t)e->pb.blocks);
}

/* Where it falls, does it fall at every larger multiple, too? Live loads push on it, more than joints resist without end; or
 * nothing resists it but strength, and they hinder it so little that force_bound times a multiple at which they are as large as
 * the dead ones does not hold it. */
SP__APART static int sp__ends_beyond(sp__ends *e, sp_arena room)
{
    int32_t final;
    if (!e->pb.live) return 1;
    sp__ends_mix(e, 1, 0);
    const sp_real dead = sp__load_unit(&e->pb);
    if (!sp__ends_open(e, 0, 1, &room)) return 0;
    e->judge.set = &e->wide;
    const int pushes = sp__judge_motion(&e->judge, e->dq, 0, &final) > 0;
    sp__ends_close(e);
    if (pushes) return 1;
    const sp_real ratio = sp__ratio(dead, e->judge.unit);
    if (!final || (e->resist > 0 && !e->final)) return 0;
    return sp__ends_work(e, e->dead) - e->resist + e->set.force_bound * ratio * sp__ends_work(e, e->live) >= 0;
}

#ifdef SP_SMALL
/* Does e->dq fall at lambda, and at every larger one, too? What moves in the best proof stays in e->dq, and in `all` (may be NULL)
 * as a result has it. */
SP__APART static int sp__ends_fall(sp__ends *e, sp_real lambda, int beyond, sp_real *all, sp_arena room)
{
    sp_arena again = room;
    if (!sp__ends_open(e, 1, lambda, &again)) return 0;
    e->least = sp__judge_mechanism(&e->judge, e->dq, &e->final);
    if (!(e->least > e->set.tol)) return 0;
    if (all) sp__check_motion(&e->judge, all);
    memcpy(e->dq, e->judge.x, 6 * (size_t)e->pb.blocks * sizeof *e->dq);
    return !beyond || sp__ends_beyond(e, room);
}
#else
/* The motion just judged into e->dq, and what joints with strength take of it. */
static void sp__ends_keep(sp__ends *e)
{
    e->resist = sp__problem_strong(&e->pb) ? e->judge.resist * e->judge.unit : 0;
    memcpy(e->dq, e->judge.x, 6 * (size_t)e->pb.blocks * sizeof *e->dq);
    sp__ends_close(e);
}

/* Does e->dq fall at lambda, with smaller motions held as sp__judge_mechanism may, and if `beyond` at every larger one, too?
 * What moves in that proof stays in e->dq, and in `all` (may be NULL) as a result has it. */
SP__APART static int sp__ends_fall(sp__ends *e, sp_real lambda, int beyond, sp_real *all, sp_arena room)
{
    const size_t bytes = 6 * (size_t)e->pb.blocks * sizeof *e->dq;
    sp_real value[6] = { 0, 0, 0, 0, 0, 0 };
    int32_t final[6] = { 0, 0, 0, 0, 0, 0 };
    memcpy(e->whole, e->dq, bytes);
    for (int pass = 0; pass < 7; pass++) {
        sp_arena again = room;
        sp__judge *j = &e->judge;
        int k = 0;
        if (!sp__ends_open(e, 1, lambda, &again)) return 0;
        if (pass == 0) {
            for (k = 0; k < 6; k++) value[k] = sp__judge_motion(j, e->whole, sp__judge_rest[k], &final[k]);
            sp__ends_close(e);
            continue;
        }
        for (int q = 1; q < 6; q++) {                   /* a final proof before others, then the best */
            const int proof = value[q] > e->set.tol, before = value[k] > e->set.tol;
            if (proof && (!before || final[q] > final[k] || (final[q] == final[k] && value[q] > value[k]))) k = q;
        }
        if (!(value[k] > e->set.tol)) break;
        e->least = sp__judge_motion(j, e->whole, sp__judge_rest[k], &e->final);
        if (all) sp__check_motion(j, all);
        sp__ends_keep(e);
        if (!beyond || sp__ends_beyond(e, room)) return 1;
        value[k] = 0;
    }
    memcpy(e->dq, e->whole, bytes);
    return 0;
}
#endif

/* By how much the multiplier may be off. dq proves (upper - balance) live . dq = least scale, and forces within tol carry at most
 * tol scale / (live . dq) more than they should. */
static sp_real sp__ends_within(const sp_limit_result *r, sp_real balance)
{
    return r->upper - r->lower + r->tol * sp__ratio(r->upper - balance, r->least_imbalance);
}

/* Every end that the claim has. */
SP__APART static int sp__ends_hold(sp__ends *e, const sp_limit_result *r, sp_arena room)
{
    if (r->kind == SP_LIMIT_UNBOUNDED && !sp__ends_stand(e, 0, 1, r->ray, NULL, room)) return 0;
    if (r->kind != SP_LIMIT_NONE && r->lower < 0) return 0;
    if (r->kind == SP_LIMIT_FOUND && !(r->lower <= r->upper)) return 0;
    if (r->kind != SP_LIMIT_NONE && !sp__ends_stand(e, 1, r->lower, r->f, NULL, room)) return 0;
    if (r->kind == SP_LIMIT_UNBOUNDED) return 1;
    sp__verify_motion(&e->pb, r->dq, e->dq);
    return sp__ends_fall(e, r->kind == SP_LIMIT_NONE ? 0 : r->upper, 1, NULL, room);
}

SP_API size_t sp_limit_verify_memory(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp_real *at[5];
    sp__judge j;
    sp_arena dry = sp__arena_dry();
    sp__problem_count(scene, &pb);
    sp__take(&dry, 1, sizeof(sp__ends));
    sp__take(&dry, 1, sp_problem_memory(scene));
    sp__ends_carve(at, pb.blocks, &dry);
    sp_arena judge = sp__arena_dry();
    sp__judge_carve(&j, &pb, SP__FACES_MAX, &judge);
    sp__take(&dry, 1, judge.peak);
    return sp__failed(&dry) ? 0 : dry.used;
}

SP_API sp_status sp_limit_verify(const sp_scene *scene, const sp_settings *settings, const sp_limit_result *claim,
                                 sp_arena scratch, int32_t *held)
{
    if (!scene || !claim || !claim->f || !claim->ray || !claim->dq || !held || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    if (!sp__finite(claim->lower) || !sp__finite(claim->upper)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->f, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->ray, 3 * (size_t)scene->count.points)) return SP_E_NOT_FINITE;
    if (!sp__all_finite(claim->dq, 6 * (size_t)scene->count.blocks)) return SP_E_NOT_FINITE;
    sp__ends *e = sp__take(&scratch, 1, sizeof *e);
    if (!e) return SP_E_MEMORY;
    const sp_status status = sp__ends_build(scene, settings, e, &scratch);
    if (status) return status;
    e->y0 = claim->y0;
    sp_arena room = scratch;
    sp__take(&room, 1, sp__judge_need(&e->pb, &e->set));
    if (sp__failed(&room)) return SP_E_MEMORY;
    *held = claim->kind != SP_LIMIT_UNDECIDED && sp__ends_hold(e, claim, scratch);
    return SP_OK;
}

#ifndef SP_SMALL
/* 35 -------------------------------------------------------------------------------------------------------- limit: search */

/* Section 19's embedding with one ray and one column more, for
 *
 *   max lambda,  Aeq f + p + lambda q = 0,  f = E x,  lambda = l / tau:
 *
 *   Aeq E x + l q + tau p = theta r0     z + E' Aeq' y = theta e     s + q.y + tau = theta r1     kappa + p.y - l = theta r2
 *   x o z = mu e,   l s = mu,   tau kappa = mu                               x = z = e, y = 0, l = s = tau = kappa = 1 at first
 *
 * At the end tau > 0: f = E x / tau carries lambda, and dq = -y, which no contact resists, does so much work under it that
 * p.dq + lambda q.dq = 0; or kappa > 0: dq falls at every lambda; or l > 0 = tau = kappa: there is no end to it.
 *
 * A step borders the factor of M = Aeq E W^2 E' Aeq' by q and p. M tends to be singular along the mechanism v, which both q and
 * p pull; so p gives way to p' = p + a q with p'.M^-1 q = 0, l to l' = l - a tau, and the columns no longer see the same v. */
typedef struct sp__limit {
    sp__ends ends;
    sp_state state;
    sp__newton n;
    sp__ipm m;
    sp_limit_result r;
    sp__dual *w;
    sp__flat *flat;                     /* NULL: in 6 rows a block */
    sp_arena room;                      /* for judging */
    sp_real *q, *Vq, *Vp;               /* 6b: weighted live load, M^-1 q, M^-1 p' */
    sp_real *f;                         /* 3 x points: forces that are tried when all others are kept */
    sp_real ref;                        /* multiplier that counts as 1 below */
    sp_real at;                         /* a: the loads at hand are dead + a live */
    sp_real l, s, dl, ds;
    sp_real G[3];                       /* q.Vq, q.Vp, p'.Vp */
    sp_real along[2];                   /* a step is its free part and these multiples of Vq and Vp */
    sp_real best, slack;                /* least power balance of a motion (kept in ends.dq), and what tol adds to it */
    sp_real least;                      /* largest one of a motion that live loads hinder: less does not stand */
    int none;                           /* that motion falls at 0, too */
} sp__limit;

#define SP__LIMIT_NEAR SP__SCALE_TOL    /* gap of both ends, relative, at which forces at the limit are tried */
#define SP__LIMIT_MOST 100              /* interior-point iterations: an optimum takes more than a verdict */
#define SP__LIMIT_CLOSE ((sp_real)0.03) /* of the way that the predictor does not get: the end is near, and steps go farther */
#ifdef SP_REAL_FLOAT
#define SP__LIMIT_KEEP SP__IPM_KEEP
#else
#define SP__LIMIT_KEEP ((sp_real)0.999)
#endif
#define SP__LIMIT_FAR 1000              /* multiple, in ref, from which on forces are nearly those of live loads alone */
#define SP__CLIMB_MOST 240              /* factorisations of a climb in c, at most */
#define SP__CLIMB_NEAR (100 * SP__SCALE_TOL)    /* gap of both ends, relative, that ends a climb */
#define SP__CLIMBED SP__TIE             /* omega from which on y is taken for that of its c */
#define SP__LIMIT_WIDE 1000             /* a bracket so many tol wide is closed */
#define SP__LIMIT_SLACK ((sp_real)0.01) /* what tol adds to a motion's balance may widen it by no more, in ref */
#ifdef SP_REAL_MIXED
#define SP__LIMIT_STEP 400              /* tol below a motion's balance where forces are asked for: float sees no nearer */
#else
#define SP__LIMIT_STEP 4
#endif

static void sp__limit_at(sp__limit *L, sp_real a)
{
    L->at = a;
    sp__ends_mix(&L->ends, 1, a * L->ref);
}

/* Loads at a; where they all but cancel each other, which is no size for anything, at a + 1. */
static void sp__limit_apart(sp__limit *L, sp_real a)
{
    const sp__ends *e = &L->ends;
    sp_real dead = 0, both = 0;
    sp__limit_at(L, a);
    for (size_t k = 0; k < 6 * (size_t)e->pb.blocks; k++) { dead += sp__abs(e->dead[k]); both += sp__abs(e->pb.p[k]); }
    if (16 * both < dead) sp__limit_at(L, a + 1);
}

/* Sizes of the certificate check for the loads at hand; with a metric E hangs on them, and they stay. */
static void sp__limit_sizes(sp__limit *L)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    if (w->metric > 0) return;
    for (size_t k = 0; k < n; k++) {
        const sp_real unit = w->unit * w->weight[k / 3];
        L->state.dq[k] = L->ends.hint[k] / unit;
        w->d[k] = -L->ends.hint[n + k] / unit;
    }
#ifndef SP_NO_PLAN
    if (L->flat) { sp__flat_drop(L->flat, w->pb->blocks, L->state.dq); sp__flat_drop(L->flat, w->pb->blocks, w->d); }
#endif
    sp__dual_sizes(w, L->state.dq);
}

/* Vq, Vp and their products, for the factor at hand. */
SP__APART static void sp__limit_columns(sp__limit *L)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp_real most = 1000 * (1 + L->l / L->m.tau);
    sp__dual_solve(w, L->q, L->Vq);
    L->G[0] = sp__dot(L->q, L->Vq, n);
    sp__limit_at(L, 0);
    const sp_real a = L->G[0] > 0 ? -sp__dual_work(w, L->Vq) / L->G[0] : 0;
    sp__limit_apart(L, L->l / L->m.tau);
    sp__limit_sizes(L);
    sp__limit_at(L, a > most ? most : a < -most ? -most : a);
    sp__dual_load(w, w->r);
    sp__dual_solve(w, w->r, L->Vp);
    L->G[1] = sp__dual_work(w, L->Vq);
    L->G[2] = sp__dual_work(w, L->Vp);
}

/* lambda <= a + (resistance - work under dead + a live) / work of live, for dq = -y, caps at the sizes at hand. The least
 * stays. */
SP__APART static void sp__limit_candidate(sp__limit *L, const sp_real *y)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real live = 0, size = 0, resist = 0, scale = 0;
    const sp_real work = -sp__dual_work(w, y);
    for (size_t k = 0; k < n; k++) { live -= L->q[k] * y[k]; size += sp__abs(L->q[k] * y[k]); }
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        const sp_real *yi = y + 6 * (size_t)i, *s = w->size + 2 * (size_t)i, *z = w->weight + 2 * (size_t)i;
        scale += s[0] * z[0] * sp__norm3(yi) + s[1] * z[1] * sp__norm3(yi + 3);
    }
    for (int32_t c = 0; c < w->pb->contacts; c++) resist += sp__newton_resist(w, c, y);
    sp__dual_count(w, SP__FLOPS_SWEEP, SP__FLOPS_TWIST);
    const int idle = sp__abs(live) <= 64 * (sp_real)SP_EPSILON * size;         /* live loads do not care */
    const int none = (idle || live > 0) && work - L->at * live - resist > (sp_real)1.1 * w->set->tol * scale;
    const sp_real best = idle ? (none ? -1 : SP__HUGE) : live > 0 ? L->at + (resist - work) / live : SP__HUGE;
    const sp_real slack = idle ? 0 : w->set->tol * scale / live;
    if (!none && (L->none || !(best + slack < L->best + L->slack))) return;     /* of proofs that nothing stands the last */
    L->best = best;
    L->none = none;
    L->slack = slack;
    for (size_t k = 0; k < n; k++) L->ends.dq[k] = -w->weight[k / 3] * y[k];
#ifndef SP_NO_PLAN
    if (L->flat) sp__flat_lift(w, L->ends.dq);
#endif
}

/* y, and y with the least change in the metric of W after which no contact resists, its work as the embedding wants it at last:
 * q.y = -s - tau;  and p.y = l - kappa. The free part of the predictor stays in w->d. */
SP__APART static void sp__limit_motions(sp__limit *L)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp_real *G = L->G, det = G[0] * G[2] - G[1] * G[1];
    L->m.corrected = 0;
    L->m.sigma = 0;
    sp__ipm_sweep(w, &L->m, SP__AIM, w->d);
    sp__dual_solve(w, w->d, w->d);
    sp__limit_candidate(L, w->y);
    if (!(G[0] > 0)) return;
    for (size_t k = 0; k < n; k++) w->r[k] = w->y[k] + w->d[k];
    const sp_real a = -L->s - L->m.tau - sp__dot(L->q, w->r, n);
    const sp_real b = L->l - L->m.kappa - L->at * (L->s + L->m.tau) - sp__dual_work(w, w->r);
    sp__dual_axpy(w, a / G[0], L->Vq, w->r);
    sp__limit_candidate(L, w->r);
    if (!(det > 0)) return;
    sp__dual_axpy(w, (a * G[2] - b * G[1]) / det - a / G[0], L->Vq, w->r);
    sp__dual_axpy(w, (b * G[0] - a * G[1]) / det, L->Vp, w->r);
    sp__limit_candidate(L, w->r);
}

/* Changes of l, s, tau, kappa and the shares of Vq and Vp, from the free part dy of a step: with dl' = dl - a dtau
 *
 *   [ -(q.Vq + s/l)            1 - q.Vp - a s/l              ] [ dl'  ]
 *   [ -(1 + q.Vp + a s/l)     -(p'.Vp + kappa/tau + a^2 s/l) ] [ dtau ]  = b                                            */
static void sp__limit_homogeneous(sp__limit *L, const sp_real *dy, sp_real pl, sp_real pt)
{
    sp__ipm *m = &L->m;
    const size_t n = 6 * (size_t)L->w->pb->blocks;
    const sp_real keep = 1 - m->sigma, a = L->at, t = L->s / L->l, *G = L->G;
    const sp_real E = keep * (L->l - a * m->tau), T = keep * m->tau;
    const sp_real cl = m->sigma * m->mu - L->l * L->s - pl, ct = m->sigma * m->mu - m->tau * m->kappa - pt;
    const sp_real r1 = sp__dot(L->q, L->w->y, n) + L->s + m->tau;
    const sp_real r2 = m->kappa + sp__dual_work(L->w, L->w->y) - L->l + a * (L->s + m->tau);
    const sp_real b1 = E * G[0] + T * G[1] - keep * r1 - cl / L->l - sp__dot(L->q, dy, n);
    const sp_real b2 = E * G[1] + T * G[2] - keep * r2 - ct / m->tau - a * cl / L->l - sp__dual_work(L->w, dy);
    const sp_real a11 = -(G[0] + t), a12 = 1 - G[1] - a * t, a21 = -(1 + G[1] + a * t);
    const sp_real a22 = -(G[2] + m->kappa / m->tau + a * a * t), det = a11 * a22 - a12 * a21;
    const sp_real d = (b1 * a22 - a12 * b2) / det;
    m->dtau = (a11 * b2 - a21 * b1) / det;
    L->dl = d + a * m->dtau;
    L->ds = (cl - L->s * L->dl) / L->l;
    m->dkappa = (ct - m->kappa * m->dtau) / m->tau;
    L->along[0] = -(E + d);
    L->along[1] = -(T + m->dtau);
}

/* The whole step of y from its free part, in place, and how far it may go. */
static void sp__limit_reach(sp__limit *L, sp_real *dy)
{
    sp__dual_axpy(L->w, L->along[0], L->Vq, dy);
    sp__dual_axpy(L->w, L->along[1], L->Vp, dy);
    L->m.along[2] = dy;
    sp__ipm_reach(L->w, &L->m);
    L->m.reach = sp__ray_step(L->l, L->dl, sp__ray_step(L->s, L->ds, L->m.reach));
}

/* Predictor and corrector, from what sp__limit_motions left in w->d. */
SP__APART static void sp__limit_step(sp__limit *L)
{
    sp__dual *w = L->w;
    sp__ipm *m = &L->m;
    sp__limit_homogeneous(L, w->d, 0, 0);
    m->along[1] = w->d;
    sp__limit_reach(L, w->d);
    const sp_real left = 1 - (m->reach < 1 ? m->reach : 1), pl = L->dl * L->ds, pt = m->dtau * m->dkappa;
    m->corrected = 1;
    m->sigma = left * left * left;
    sp__ipm_sweep(w, m, SP__AIM, w->r);
    sp__dual_solve(w, w->r, w->r);
    sp__limit_homogeneous(L, w->r, pl, pt);
    sp__limit_reach(L, w->r);
    m->reach *= left < SP__LIMIT_CLOSE ? SP__LIMIT_KEEP : SP__IPM_KEEP;
    if (m->reach > 1) m->reach = 1;
    sp__ipm_sweep(w, m, SP__MOVE, NULL);
    sp__dual_axpy(w, m->reach, w->r, w->y);
    m->tau += m->reach * m->dtau;
    m->kappa += m->reach * m->dkappa;
    L->l += m->reach * L->dl;
    L->s += m->reach * L->ds;
    m->theta *= 1 - m->reach * (1 - m->sigma);
}

/* Forces E x / t, or those of w->y (t = 0), balanced for d dead + l live (in ref) with the factor at hand. */
SP__APART static int sp__limit_forces(sp__limit *L, sp_real d, sp_real l, sp_real t, sp_real *f)
{
    const sp_real tau = L->m.tau;
    sp__ends_mix(&L->ends, d, l * L->ref);
    sp__limit_sizes(L);
    L->n.found = 0;
    L->state.f = f;
    L->m.tau = t;
    sp__ipm_forces(L->w, t > 0 ? &L->m : NULL, &L->n, &L->state);
    L->m.tau = tau;
#ifndef SP_NO_PLAN
    if (L->flat) sp__flat_spread(L->flat, &L->ends.pb, f);
#endif
    return L->n.found && sp__ends_stand(&L->ends, d, l * L->ref, f, f, L->room);
}

/* Where the interior points are done but for so much, do the forces at hand, balanced, carry their multiple? The largest stays.
 *     returns 1: and it is as near to the best motion's power balance */
static int sp__limit_lower(sp__limit *L, sp_real near)
{
    const sp_real l = L->l / L->m.tau, a = l < L->best ? l : sp__max(0, L->best), far = near * (1 + sp__abs(a));
    if (!L->none && L->r.lower >= 0 && L->best - L->r.lower / L->ref <= far) return 1;
    if (L->none || (L->m.theta > near * L->m.tau && sp__abs(L->best - l) > far) || a * L->ref <= L->r.lower) return 0;
    if (!sp__limit_forces(L, 1, a, L->m.tau, L->r.ray)) return 0;
    L->r.lower = a * L->ref;
    L->r.omega = L->ends.omega;
    memcpy(L->r.f, L->r.ray, 3 * (size_t)L->ends.pb.points * sizeof *L->r.f);
    return sp__abs(L->best - a) <= far;
}

/* Do they carry the live loads alone, and all of them the multiple at hand? */
static int sp__limit_ray(sp__limit *L)
{
    const sp_real l = L->l / L->m.tau;
    L->m.ray = 1;
    const int found = sp__limit_forces(L, 0, 1, L->l, L->r.ray);
    L->m.ray = 0;
    if (!found) return 0;
    for (size_t k = 0; k < 3 * (size_t)L->ends.pb.points; k++) L->r.ray[k] /= L->ref;
    L->r.kind = SP_LIMIT_UNBOUNDED;
    if (!sp__limit_forces(L, 1, l, L->m.tau, L->r.f)) return 1;
    L->r.lower = l * L->ref;
    L->r.omega = L->ends.omega;
    return 1;
}

/* K that is no cone, and what interior points leave open, by the exact stage's own dual with lambda in it:
 *
 *   max c lambda - 1/2 sum |f_v|^2 / S_v,  Aeq f + p + lambda q = 0,  f in K         dual: min D(y) with p alone, q . y = -c
 *
 * The larger c, the nearer lambda is to the limit (it lacks |f|^2 / 2c at most, and nothing from some c on if K is polyhedral) and y
 * to a multiple of the mechanism, along which D is flat; but q is not across it, so a bordered Newton step is regular there:
 * d = -H^-1 (r + dlambda q), q . d = 0.                                              [Mangasarian, Meyer 1979: exact for large c] */
SP__APART static sp_real sp__climb_step(sp__limit *L, sp_real c)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp__dual_factor(w, SP__ADMISSIBLE, w->y, L->n.prox + L->n.shift);
    if (w->spent) return 0;
    L->n.left--;
    L->ends.cost.iterations++;
    sp__dual_solve(w, L->q, L->Vq);
    L->G[0] = sp__dot(L->q, L->Vq, n);
    if (!(L->G[0] > 0)) return 0;
    const sp_real off = (c + sp__dot(L->q, w->y, n)) / L->G[0];
    if (sp__abs(off) * L->G[0] > (sp_real)1e-9 * c) {   /* a larger c: along the tangent */
        sp__dual_axpy(w, -off, L->Vq, w->y);
        sp__newton_look(w, &L->n, &L->state);
        return 1;
    }
    for (size_t k = 0; k < n; k++) w->d[k] = -w->r[k] - L->n.prox * w->y[k];
    sp__dual_solve(w, w->d, w->d);
    for (int pass = 0; pass < 2; pass++) {              /* what rounding leaves along Vq, too */
        const sp_real a = sp__dot(L->q, w->d, n) / L->G[0];
        sp__dual_axpy(w, -a, L->Vq, w->d);
        if (!pass) { L->at += a; sp__dual_axpy(w, a, L->q, w->r); }
    }
    sp__limit_at(L, L->at);
    return sp__newton_move(w, &L->n, &L->state);
}

/* y for that c: by Newton, and where that stalls and `far` by the proximal path.     returns 1: it is found */
SP__APART static int sp__climb_at(sp__limit *L, sp_real c, int far)
{
    const sp__dual *w = L->w;
    sp__newton *n = &L->n;
    n->omega = SP__HUGE;
    n->prox = 0;
    n->shift = SP__SHIFT;
    for (int it = 0, tiny = 0; it < 12 && sp__newton_left(w, n) && n->omega > n->goal && tiny < 2; it++)
        tiny += sp__newton_damp(n, sp__climb_step(L, c));
    if (n->omega <= SP__CLIMBED || !far) return n->omega <= SP__CLIMBED;
    n->shift = 0;
    n->level = SP__HUGE;
    n->prox = (sp_real)0.1;
    for (int extra = 4; extra > 0 && sp__newton_left(w, n) && n->omega > n->goal; ) {
        sp__climb_step(L, c);
        if (n->prox <= SP__SHIFT) extra--;
        else if (sp__newton_level(L->w, n)) n->prox = n->prox > 100 * SP__SHIFT ? n->prox / 100 : SP__PROX;
    }
    return n->omega <= SP__CLIMBED;
}

/* Are both ends found, and no farther apart than so much? */
static int sp__limit_near(const sp__limit *L, sp_real apart)
{
    return L->best < SP__HUGE && L->r.lower >= 0 && L->best - L->r.lower / L->ref <= apart * (1 + sp__abs(L->best));
}

/* The kept motion once more, sharpened by the rigid groups it shows: for the work of the loads that it falls by. */
SP__APART static void sp__limit_settle(sp__limit *L)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    memcpy(L->state.dq, L->ends.dq, n * sizeof *L->state.dq);
#ifndef SP_NO_PLAN
    if (L->flat) sp__flat_drop(L->flat, w->pb->blocks, L->state.dq);
#endif
    sp__ends_mix(&L->ends, L->best < 0, L->best < 0 ? 0 : L->ref);
    sp__newton_settle(w, &L->state);
    for (size_t k = 0; k < n; k++) L->Vq[k] = -L->state.dq[k] / w->weight[k / 3];
    sp__limit_at(L, sp__max(0, L->best));
    sp__limit_candidate(L, L->Vq);
}

/* What y at that c says: its motion, that of a larger c, that since the c before (in Vp), and the best of these sharpened, as upper
 * ends; its forces as a lower one.                                                                returns 1: they meet */
SP__APART static int sp__climb_ends(sp__limit *L, int sharpen)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    const sp_real a = L->at;
    sp__limit_sizes(L);
    sp__limit_candidate(L, w->y);
    for (int pass = 0; pass < 2; pass++) {
        for (size_t k = 0; k < n; k++) w->d[k] = pass ? w->y[k] - L->Vp[k] : -L->Vq[k];
        sp__limit_candidate(L, w->d);
    }
    sp__dual_factor(w, SP__ADMISSIBLE, w->y, SP__SHIFT);
    L->n.left--;
    if (!w->spent && a >= 0 && a * L->ref > L->r.lower && sp__limit_forces(L, 1, a, 0, L->r.ray)) {
        L->r.lower = a * L->ref;
        L->r.omega = L->ends.omega;
        memcpy(L->r.f, L->r.ray, 3 * (size_t)L->ends.pb.points * sizeof *L->r.f);
    }
    if (sharpen && L->best < SP__HUGE && !sp__limit_near(L, SP__CLIMB_NEAR)) sp__limit_settle(L);
    return sp__limit_near(L, SP__CLIMB_NEAR);
}

/* Both ends, by larger and larger c, until they meet or lambda stays where it is: from a y that Newton misses back to the last one
 * and a smaller step.                                                     returns 1: they are near enough to close the bracket */
SP__APART static int sp__limit_climb(sp__limit *L)
{
    sp__dual *w = L->w;
    const size_t n = 6 * (size_t)w->pb->blocks;
    sp_real most = 0, sum = 0, last = -SP__HUGE;
    for (int32_t i = 0; i < w->pb->blocks; i++) {
        sum += w->size[2 * (size_t)i];
        most = sp__max(most, w->size[2 * (size_t)i]);
    }
    memset(w->y, 0, n * sizeof *w->y);
    sp__limit_at(L, 0);
    L->n.best = SP__HUGE;
    sp_real c = sum * most, times = 10;
    const int32_t others = L->n.left > SP__CLIMB_MOST ? L->n.left - SP__CLIMB_MOST : 0;
    L->n.left -= others;
    int met = 0;
    for (int stage = 0, still = 0; stage < 24 && still < 3 && !met; stage++) {
        memcpy(L->Vp, w->y, n * sizeof *L->Vp);
        if (!sp__climb_at(L, c, !stage)) {              /* back, and not so far */
            if (!sp__newton_left(w, &L->n) || !stage || times < (sp_real)1.2) break;
            memcpy(w->y, L->Vp, n * sizeof *w->y);
            c /= times;
            times = SP_SQRT(times);
            sp__limit_at(L, last);
        } else {
            still = sp__abs(L->at - last) <= SP__LIMIT_NEAR * (1 + sp__abs(last)) ? still + 1 : 0;
            last = L->at;
            met = sp__climb_ends(L, still);
            sp__limit_at(L, last);
            times = times * times < 10 ? times * times : 10;
        }
        c *= times;
    }
    L->n.left += others;
    return sp__limit_near(L, SP__LIMIT_WIDE * L->r.tol);
}

/* x = z = e, y = 0, l = s = tau = kappa = 1. */
static void sp__limit_start(sp__limit *L)
{
    sp__ipm_start(L->w, &L->m);
    L->l = L->s = 1;
}

/* Interior points, until the ends meet.     returns 1: lower and best meet, the live loads have no end, or nothing stands */
SP__APART static int sp__limit_run(sp__limit *L)
{
    sp__dual *w = L->w;
    sp__ipm *m = &L->m;
    sp__ends *e = &L->ends;
    const int32_t faces = w->cone.faces;
    const sp_real cones = (sp_real)w->pb->points * (sp_real)(faces ? faces : 1);
    int idle = 0;                                       /* steps that got nowhere, one after the other */
    sp__limit_start(L);
    for (int it = 0; it < SP__LIMIT_MOST && idle < SP__IPM_IDLE && L->n.left > 0 && m->theta > (sp_real)SP_EPSILON; it++) {
        m->gap = 0;
        m->outside = 0;
        sp__dual_factor(w, SP__INTERIOR, w->y, SP__IPM_SHIFT);
        if (w->spent) return 0;
        L->n.left--;
        e->cost.iterations++;
        e->cost.interior++;
        if (m->outside) return 0;
        m->mu = (m->gap + m->tau * m->kappa + L->l * L->s) / (cones + 2);
        if (sp__limit_lower(L, SP__LIMIT_NEAR)) return 1;
        if (L->l > 1000 * m->tau && sp__limit_ray(L)) return 1;
        sp__limit_columns(L);
        sp__limit_motions(L);
        if (w->spent) return 0;
        if (L->none && sp__ends_fall(e, 0, 1, NULL, L->room)) return 1;
        sp__limit_step(L);
        if (w->spent) return 0;
        idle = m->reach < SP__IPM_NOWHERE ? idle + 1 : 0;
    }
    sp__limit_lower(L, 1000 * SP__LIMIT_NEAR);
    return 0;
}

/* Flops that are left to the search: the judge of both ends wants some, too. */
static int64_t sp__limit_left(const sp__ends *e)
{
    return e->limit - e->cost.flops - 80 * SP__FLOPS_JUDGE * (int64_t)e->pb.points;
}

/* L->flat, the last thing taken from `a`, where one mirror is that of joints, dead and live loads. The loads at hand are those of
 * about the size both have at work. */
static void sp__limit_flat(sp__limit *L, sp_arena *a)
{
    sp__ends *e = &L->ends;
    L->flat = NULL;
#ifndef SP_NO_PLAN
    const size_t start = a->used;
    sp__flat *o = sp__take(a, 1, sizeof *o);
    int planar = o != NULL;
    for (int k = 0; k < 3 && planar; k++) {             /* both, dead, live */
        sp__ends_mix(e, k != 2, k != 1 ? L->ref : 0);
        planar = k ? sp__flat_loads(&e->pb, &e->set, o->e[2], 0) : sp__flat_choose(&e->pb, &e->set, o) && o->mode == SP__PLANE;
    }
    if (planar) L->flat = o;
    else if (o) a->used = start;
#else
    (void)a;
#endif
    sp__ends_mix(e, 1, L->ref);
}

/* The dual at that load, its sizes and metric; hints for both loads. */
SP__APART static sp_status sp__limit_open(sp__limit *L, sp_arena *a)
{
    sp__ends *e = &L->ends;
    const size_t n = 6 * (size_t)e->pb.blocks;
    sp_real *y0[2] = { L->r.y0, L->r.y0 + 2 * n };
    sp__limit_flat(L, a);
    L->w = sp__dual_make(&e->pb, &e->set, SP__LIMIT, L->flat, &e->cost, a);
    if (!L->w) return SP_E_MEMORY;
    L->w->limit = sp__limit_left(e) + e->cost.flops;
    L->m.x = sp__take(a, (size_t)e->pb.points, (size_t)(e->set.faces ? e->set.faces : 3) * sizeof *L->m.x);
    if (sp__failed(a)) return SP_E_MEMORY;
    for (int k = 0; k < 2; k++) {
        sp__ends_mix(e, k ? 0 : 1, k ? L->ref : 0);
        if (k) sp__bilateral_solve(L->w); else sp__dual_bilateral(L->w);
        if (L->w->spent) return SP_OK;
        L->state.y0 = y0[k];
        sp__dual_hint(L->w, &L->state);
    }
    for (size_t k = 0; k < 2 * n; k++) y0[1][k] /= L->ref;
    e->y0 = L->r.y0;
    L->w->metric = 0;
    sp__limit_apart(L, 1);
    sp__limit_sizes(L);
    if (sp__dual_metric(L->w)) sp__dual_weights(L->w);
    sp__ends_mix(e, 0, L->ref);
    sp__dual_load(L->w, L->q);
    return SP_OK;
}

/* The exact stage under the loads at hand, first in 3 rows where they let it. */
SP__APART static sp_status sp__limit_stage(sp__limit *L, sp_arena room, sp_verdict *claim)
{
    sp__ends *e = &L->ends;
#ifndef SP_NO_PLAN
    sp_arena again = room;
    sp__flat *o = sp__take(&again, 1, sizeof *o);
    if (!o) return SP_E_MEMORY;
    if (sp__flat_choose(&e->pb, &e->wide, o)) {    /* with as many iterations as were asked for */
        const sp_status status = sp__exact_search(&e->pb, &e->set, o, &L->state, &again, claim);
        if (status || *claim == SP_STABLE || (*claim == SP_UNSTABLE && (o->mode == SP__PLANE || o->forest))) return status;
        *claim = SP_UNDECIDED;
    }
#endif
    return sp__exact_run(&e->pb, &e->set, &L->state, &room, claim);
}

/* Gates and the exact stage at d dead + a live.     returns what they claim; state.dq, or f, says it */
SP__APART static sp_verdict sp__limit_exact(sp__limit *L, sp_real d, sp_real a, sp_real *f, sp_arena room)
{
    sp__ends *e = &L->ends;
    sp_verdict claim = SP_UNDECIDED;
    sp_arena again = room;
    sp__ends_mix(e, d, a * L->ref);
    e->set.iterations = L->n.left;
    e->set.localise = 1;
    L->state.f = f;
    memset(f, 0, 3 * (size_t)e->pb.points * sizeof *f);
    L->state.y0 = e->hint;
    memset(&L->state.cost, 0, sizeof L->state.cost);
    L->state.left = sp__limit_left(e);
    if (L->state.left <= 0) { e->spent = 1; return SP_UNDECIDED; }
    sp_status status = sp__gates_run(&e->pb, &e->set, &L->state, &room, &claim);
    if (!status && !claim) status = sp__limit_stage(L, again, &claim);
    L->n.left -= L->state.cost.factorisations;
    sp__cost_add(&e->cost, &L->state.cost);
    if (status) claim = SP_UNDECIDED;
    if (claim == SP_UNSTABLE) memcpy(e->dq, L->state.dq, 6 * (size_t)e->pb.blocks * sizeof *e->dq);
    return claim;
}

/* Power balance of the motion: the multiple of live loads at which its work is 0; SP__HUGE where they do none. */
static sp_real sp__limit_balance(const sp__limit *L)
{
    const sp_real dead = sp__ends_work(&L->ends, L->ends.dead) - L->ends.resist;
    const sp_real live = L->ref * sp__ends_work(&L->ends, L->ends.live);
    return sp__abs(dead) < SP__HUGE * sp__abs(live) ? -dead / live : SP__HUGE;
}

/* Vp falls below `least`, Vq beyond `best`, which is not more: together, in the shares in which live loads do no work, they fall at
 * any multiple, for joints resist both at once with no more than what they resist each with. */
static int sp__limit_never(sp__limit *L)
{
    sp__ends *e = &L->ends;
    const size_t n = 6 * (size_t)e->pb.blocks;
    const sp_real p = sp__dot(e->live, L->Vp, n), q = sp__dot(e->live, L->Vq, n);
    if (!(L->least >= L->best && p < 0 && q > 0)) return 0;
    for (size_t k = 0; k < n; k++) e->dq[k] = L->Vp[k] / -p + L->Vq[k] / q;
    L->none = sp__ends_fall(e, 0, 1, NULL, L->room);
    if (!L->none) memcpy(e->dq, L->Vq, n * sizeof *e->dq);
    return L->none;
}

/* An UNSTABLE at *a: its motion is a better bound from above, or, where live loads would hold it, from below. *a: where to ask
 * next.                                                                             returns 0: nothing gained */
static int sp__limit_cut(sp__limit *L, sp_real *a, sp_real step)
{
    const int beyond = sp__ends_fall(&L->ends, *a * L->ref, 1, NULL, L->room);
    if (!beyond && !sp__ends_fall(&L->ends, *a * L->ref, 0, NULL, L->room)) return 0;
    const sp_real balance = sp__limit_balance(L), last = *a;
    L->none = beyond && last <= 0;
    if (L->none) return 1;
    if (!(balance < SP__HUGE)) return 0;
    if (beyond ? balance < L->best : balance > L->least) {
        *(beyond ? &L->best : &L->least) = balance;
        memcpy(beyond ? L->Vq : L->Vp, L->ends.dq, 6 * (size_t)L->ends.pb.blocks * sizeof *L->Vq);
    }
    if (sp__limit_never(L)) return 1;
    const sp_real next = beyond ? L->best - step : balance + step < L->best ? balance + step : L->best;
    *a = sp__max(0, next);
    return beyond ? *a < last : *a > last;
}

/* Live loads alone, before there is an upper end: forces that balance them are a ray, and there is none; or something falls under
 * them, and its power balance is one. */
SP__APART static void sp__limit_endless(sp__limit *L, sp_arena room)
{
    sp__ends *e = &L->ends;
    sp_real a = 1;
    const sp_verdict claim = sp__limit_exact(L, 0, 1, L->r.ray, room);
    if (claim == SP_STABLE && sp__ends_stand(e, 0, L->ref, L->r.ray, L->r.ray, L->room)) {
        for (size_t k = 0; k < 3 * (size_t)e->pb.points; k++) L->r.ray[k] /= L->ref;
        L->r.kind = SP_LIMIT_UNBOUNDED;
    }
    for (int it = 0; it < 3 && claim == SP_UNSTABLE && a < SP__HUGE; it++) {    /* what joints resist hangs on caps, and those on a */
        int32_t final;
        sp_arena again = L->room;
        if (!sp__ends_open(e, 1, a * L->ref, &again)) return;
        sp__judge_motion(&e->judge, e->dq, 0, &final);
        sp__ends_keep(e);
        L->best = a = sp__ends_work(e, e->live) > 0 ? sp__limit_balance(L) : SP__HUGE;
    }
}

/* Does it stand under the dead loads alone, so that there is something to climb from? Or fall, whatever the live ones do: L->none */
SP__APART static int sp__limit_rises(sp__limit *L, sp_arena room)
{
    sp__ends *e = &L->ends;
    const size_t bytes = 6 * (size_t)e->pb.blocks * sizeof *e->dq;
    memcpy(L->Vp, e->dq, bytes);
    const sp_verdict claim = sp__limit_exact(L, 1, 0, L->r.f, room);
    L->none = claim == SP_UNSTABLE && sp__ends_fall(e, 0, 1, NULL, L->room);
    if (!L->none) memcpy(e->dq, L->Vp, bytes);
    if (claim != SP_STABLE || !sp__ends_stand(e, 1, 0, L->r.f, L->r.f, L->room)) return 0;
    L->r.lower = 0;
    L->r.omega = e->omega;
    L->r.dead = SP_STABLE;
    return 1;
}

/* Of forces in r.ray that carry a large multiple little is due to dead loads: are they a ray without what is so small? */
SP__APART static int sp__limit_far(sp__limit *L)
{
    sp_real *ray = L->r.ray;
    sp__forces_dust(ray, L->ends.pb.points, 100 * L->ref / L->r.lower);
    for (size_t k = 0; k < 3 * (size_t)L->ends.pb.points; k++) ray[k] /= L->r.lower;
    if (!sp__ends_stand(&L->ends, 0, 1, L->r.ray, L->r.ray, L->room)) return 0;
    L->r.kind = SP_LIMIT_UNBOUNDED;
    return 1;
}

/* Where interior points leave an end open: the exact stage just below the best motion's power balance. Each collapse it finds
 * gives a better one, as Newton's method on the least imbalance over lambda would: few steps.            [Dinkelbach 1967]
 *     returns 1: lower is found (of an UNBOUNDED any), or nothing stands */
SP__APART static int sp__limit_newton(sp__limit *L, sp_arena room)
{
    const int any = L->r.kind == SP_LIMIT_UNBOUNDED;
    sp_real *f = any ? L->r.f : L->r.ray;               /* those of the lower end stay until there are better ones */
    if (any) L->best = SP__HUGE;
    const sp_real size = 1 + (L->best < SP__HUGE ? sp__abs(L->best) : 0), far = (sp_real)0.01 * size;
    sp_real step = SP__LIMIT_STEP * L->ends.set.tol * size;
    L->least = -SP__HUGE;
    memcpy(L->Vq, L->ends.dq, 6 * (size_t)L->ends.pb.blocks * sizeof *L->Vq);
    sp_real a = L->best < SP__HUGE ? sp__max(0, L->best - step) : 0;
    for (int it = 0; it < 24 && L->n.left > 0 && sp__limit_left(&L->ends) > 0 && step < far; it++) {
        const sp_verdict claim = sp__limit_exact(L, 1, a, f, room);
        if (claim == SP_STABLE && sp__ends_stand(&L->ends, 1, a * L->ref, f, f, L->room)) {
            if (!(a > 0)) L->r.dead = SP_STABLE;
            if (a * L->ref > L->r.lower) {
                L->r.lower = a * L->ref;
                L->r.omega = L->ends.omega;
                memmove(L->r.f, f, 3 * (size_t)L->ends.pb.points * sizeof *f);
            }
            if (any || L->best < SP__HUGE || (a > SP__LIMIT_FAR && sp__limit_far(L))) return 1;
            a = a > 0 ? 8 * a : 1;
            continue;
        }
        if (claim == SP_UNSTABLE && sp__limit_cut(L, &a, step)) {
            if (L->none) return 1;
            continue;
        }
        if (claim == SP_UNSTABLE) {                     /* does it stand at all? */
            if (!(a > 0)) return 0;
            a = 0;
            continue;
        }
        if (L->best < SP__HUGE) {
            step *= 10;
            a = sp__max(0, L->best - step);
        } else a = a > 0 ? 8 * a : 1;
    }
    if (L->best < SP__HUGE) memcpy(L->ends.dq, L->Vq, 6 * (size_t)L->ends.pb.blocks * sizeof *L->Vq);
    return 0;
}

/* The motion at hand proves the upper end, the least it can; or that of the exact stage there. */
SP__APART static int sp__limit_upper(sp__limit *L, sp_arena room)
{
    sp_limit_result *r = &L->r;
    sp_real slack = sp__max(L->slack, L->ends.set.tol * (1 + sp__abs(L->best))) * (sp_real)1.5;
    for (int it = 0; it < 8; it++, slack *= 2) {
        const sp_real lambda = L->none ? 0 : sp__max(0, L->best + slack) * L->ref;
        if (it == 2 && !L->none) sp__limit_exact(L, 1, L->best + slack, r->ray, room);
        if (!sp__ends_fall(&L->ends, lambda, 1, r->dq, L->room)) continue;
        if (L->ends.least < (sp_real)1.1 * L->ends.set.tol) {   /* by a hair: so that it is proof as it is told, too */
            sp__verify_motion(&L->ends.pb, r->dq, L->ends.dq);
            if (!sp__ends_fall(&L->ends, lambda, 1, NULL, L->room)) continue;
        }
        r->upper = lambda;
        r->least_imbalance = L->ends.least;
        r->final = L->ends.final;
        return 1;
    }
    return 0;
}

/* What was found, by its ends. */
static void sp__limit_conclude(sp__limit *L)
{
    sp_limit_result *r = &L->r;
    const sp_real slack = L->slack < SP__LIMIT_SLACK ? L->slack : SP__LIMIT_SLACK;
    const sp_real wide = SP__LIMIT_WIDE * r->tol * (sp__abs(r->lower) + L->ref) + 4 * slack * L->ref;
    const int never = L->none || (r->lower < 0 && !(r->upper > 0));
    if (never) r->kind = r->upper < 0 ? SP_LIMIT_UNDECIDED : SP_LIMIT_NONE;
    else if (r->kind == SP_LIMIT_UNBOUNDED) r->kind = r->lower < 0 ? SP_LIMIT_UNDECIDED : SP_LIMIT_UNBOUNDED;
    else if (r->lower >= 0 && r->upper >= r->lower && r->upper - r->lower <= wide) r->kind = SP_LIMIT_FOUND;
    const int spent = L->ends.spent || L->n.left <= 0 || sp__limit_left(&L->ends) <= 0;
    r->reason = r->kind ? SP_REASON_FORCES : spent ? SP_REASON_BUDGET : SP_REASON_LIMIT;
    if (r->kind != SP_LIMIT_FOUND) return;
    const sp_real balance = sp__limit_balance(L) * L->ref;
    if (balance >= 0 && balance < r->lower && sp__ends_stand(&L->ends, 1, balance, r->f, NULL, L->room)) {
        r->lower = balance;                             /* within tol the same forces carry less, too */
        r->omega = L->ends.omega;
    }
    r->multiplier = balance < r->lower ? r->lower : balance > r->upper ? r->upper : balance;
    r->within = sp__ends_within(r, balance);
}

/* What of all that stands, or falls, under the dead loads alone, and from where on? Where live loads must hold it, each collapse
 * tells a least multiple, by Newton's method on the least imbalance, from below. */
SP__APART static void sp__limit_lowest(sp__limit *L, sp_arena room)
{
    sp__ends *e = &L->ends;
    sp_limit_result *r = &L->r;
    sp_real a = 0;
    r->lowest = r->lower;
    if (r->kind == SP_LIMIT_NONE) r->dead = SP_UNSTABLE;
    else if (!(r->lower > 0) && r->lower >= 0) r->dead = SP_STABLE;
    if (r->dead == SP_STABLE) r->lowest = 0;
    for (int it = 0; it < 12 && r->lowest > a * L->ref && L->n.left > 0; it++) {
        const sp_real last = a;
        const sp_verdict claim = sp__limit_exact(L, 1, a, L->f, room);
        if (claim == SP_STABLE && sp__ends_stand(e, 1, a * L->ref, L->f, NULL, L->room)) {
            r->lowest = a * L->ref;
            if (!it) r->dead = SP_STABLE;
            if (r->kind != SP_LIMIT_UNBOUNDED) return;
            r->lower = r->lowest;                       /* every multiple from there on */
            r->omega = e->omega;
            memcpy(r->f, L->f, 3 * (size_t)e->pb.points * sizeof *r->f);
            return;
        }
        if (claim == SP_UNSTABLE && sp__ends_fall(e, a * L->ref, 0, NULL, L->room)) {
            r->dead = SP_UNSTABLE;
            a = sp__limit_balance(L) + SP__LIMIT_STEP * e->set.tol * (1 + a);
        } else if (!it) return;
        if (!(a > last)) a = (last + r->lowest / L->ref) / 2;
    }
}

/* About the multiple at which live loads are of the size of dead ones, over all contacts; moments by their arms. */
static sp_real sp__limit_reference(sp__ends *e)
{
    sp_real sum[2] = { 0, 0 };
    for (int32_t c = 0; c < e->pb.contacts; c++)
        for (int side = 0; side < 2; side++) {
            const sp_contact *t = &e->pb.contact[c];
            const int32_t i = side ? t->b : t->a;
            const sp_real arm = sp__norm3(side ? t->rb : t->ra);
            for (int k = 0; k < 2 && i >= 0; k++) {
                const sp_real *p = (k ? e->live : e->dead) + 6 * (size_t)i;
                sum[k] += sp__norm3(p) + (arm > 0 ? sp__norm3(p + 3) / arm : 0);
            }
        }
    const sp_real ref = sp__ratio(sum[0], sum[1]);
    return ref > 0 && ref < SP__HUGE ? ref : 1;
}

/* Interior points and what they leave: the best motion sharpened.     returns 1: both ends are near, or nothing stands */
SP__APART static int sp__limit_search(sp__limit *L)
{
    sp__ends *e = &L->ends;
    int done = !L->w->spent && sp__limit_run(L);
    if (L->r.kind == SP_LIMIT_UNBOUNDED) return L->r.lower >= 0;
    if (!L->w->spent && !(done && L->none) && L->best < SP__HUGE) sp__limit_settle(L);
    if (L->none && !done) done = L->none = sp__ends_fall(e, 0, 1, NULL, L->room);
    e->spent |= L->w->spent;
    return done || sp__limit_near(L, SP__LIMIT_WIDE * L->r.tol);
}

/* Search, then both ends; `a` is used up. */
SP__APART static sp_status sp__limit_decide(sp__limit *L, sp_arena *a)
{
    sp__ends *e = &L->ends;
    sp_arena rest = *a;
    int done = 0, live = 0;
    for (size_t k = 0; k < 6 * (size_t)e->pb.blocks; k++) live |= e->live[k] < 0 || e->live[k] > 0;
    if (!live) L->r.kind = SP_LIMIT_UNBOUNDED;                  /* does it stand at all? */
    else if (!sp__problem_strong(&e->pb)) {
        const sp_status status = sp__limit_open(L, a);
        if (status) return status;
        done = sp__limit_search(L);
    }
    if (!done) {
        L->none = 0;
        if (L->r.kind != SP_LIMIT_UNBOUNDED && !(L->best < SP__HUGE)) sp__limit_endless(L, rest);
        const int strong = sp__problem_strong(&e->pb) && L->r.kind != SP_LIMIT_UNBOUNDED;
        if (strong && sp__limit_rises(L, rest) && L->best >= 0) {
            a->used = rest.used;
            const sp_status status = sp__limit_open(L, a);
            if (status) return status;
            done = sp__limit_climb(L);
        }
        if (!done && !L->none) done = sp__limit_newton(L, rest);
    }
    if (L->none || (L->r.kind != SP_LIMIT_UNBOUNDED && L->best < SP__HUGE)) sp__limit_upper(L, rest);
    sp__limit_conclude(L);
    sp__limit_lowest(L, rest);
    if (L->r.upper < 0) memset(L->r.dq, 0, 6 * (size_t)e->scene.count.blocks * sizeof *L->r.dq);
    if (L->r.kind != SP_LIMIT_UNBOUNDED) memset(L->r.ray, 0, 3 * (size_t)e->pb.points * sizeof *L->r.ray);
    return SP_OK;
}

typedef struct sp__limit_kept { sp_real *f, *ray, *dq, *y0; } sp__limit_kept;

static void sp__limit_carve_kept(sp__limit_kept *r, const sp_scene *scene, int32_t blocks, sp_arena *a)
{
    r->f = sp__take(a, (size_t)scene->count.points, 3 * sizeof *r->f);
    r->ray = sp__take(a, (size_t)scene->count.points, 3 * sizeof *r->ray);
    r->dq = sp__take(a, (size_t)scene->count.blocks, 6 * sizeof *r->dq);
    r->y0 = sp__take(a, (size_t)blocks, 24 * sizeof *r->y0);
}

static void sp__limit_carve(sp__limit *L, const sp_scene *scene, int32_t blocks, sp_arena *a)
{
    L->f = sp__take(a, (size_t)scene->count.points, 3 * sizeof *L->f);
    L->state.y = sp__take(a, (size_t)blocks, 6 * sizeof *L->state.y);
    L->state.dq = sp__take(a, (size_t)blocks, 6 * sizeof *L->state.dq);
    L->q = sp__take(a, (size_t)blocks, 6 * sizeof *L->q);
    L->Vq = sp__take(a, (size_t)blocks, 6 * sizeof *L->Vq);
    L->Vp = sp__take(a, (size_t)blocks, 6 * sizeof *L->Vp);
}

SP_API size_t sp_limit_memory_scratch(const sp_scene *scene)
{
    if (!scene) return 0;
    sp_problem pb;
    sp__problem_count(scene, &pb);
    return sizeof(sp__limit) + SP_ALIGN + sp_limit_verify_memory(scene) + SP_ALIGN + sp__dual_scratch(&pb);
}

SP_API sp_status sp_limit_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__limit *L = sp__take(&scratch, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    const sp_status status = sp__ends_build(scene, settings, &L->ends, &scratch);
    if (status) return status;
    const sp_problem *pb = &L->ends.pb;
    const int32_t faces = L->ends.set.faces;
    L->ends.y0 = NULL;
    L->ref = sp__limit_reference(&L->ends);
    sp__limit_flat(L, &scratch);
#ifndef SP_NO_PLAN
    if (!L->flat) L->flat = sp__take(&scratch, 1, sizeof *L->flat);    /* of other loads there may be one */
#endif
    const size_t search = pb->blocks ? sp__dual_most(pb, &L->ends.set, 0, (size_t)(faces ? faces : 3), L->flat, scratch) : 0;
    if (search == SIZE_MAX) return SP_E_MEMORY;
    sp__limit_kept kept;
    sp_arena dry = sp__arena_dry();
    sp__limit_carve_kept(&kept, scene, pb->blocks, &dry);
    sp__take(&dry, 1, sizeof *L);
    sp__take(&dry, 1, sp_problem_memory(scene));
    sp_real *at[5];
    sp__ends_carve(at, pb->blocks, &dry);
    sp__limit_carve(L, scene, pb->blocks, &dry);
    sp__take(&dry, 1, sp__judge_need(pb, &L->ends.set));
    sp__take(&dry, 1, search);
    *bytes = dry.used;
    return SP_OK;
}

/* Everything of a limit in arena `a`.     *limit: where the result is found on SP_OK; *kept: end of its arrays */
SP__APART static sp_status sp__limit_build(const sp_scene *scene, const sp_settings *settings, sp_arena *a, sp__limit **limit,
                                           size_t *kept)
{
    sp_problem count;
    sp__limit_kept arrays;
    sp__problem_count(scene, &count);
    sp__limit_carve_kept(&arrays, scene, count.blocks, a);
    *kept = a->used;
    sp__limit *L = sp__take(a, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    memset(L, 0, sizeof *L);
    const sp_status status = sp__ends_build(scene, settings, &L->ends, a);
    if (status) return status;
    sp__limit_carve(L, scene, count.blocks, a);
    const size_t need = sp__judge_need(&L->ends.pb, &L->ends.set);
    L->room.base = sp__take(a, 1, need);
    L->room.cap = need ? need : 1;                      /* 0 would mean that something did not fit */
    if (sp__failed(a)) return SP_E_MEMORY;
    sp_limit_result *r = &L->r;
    r->f = arrays.f; r->ray = arrays.ray; r->dq = arrays.dq; r->y0 = arrays.y0;
    memset(r->f, 0, 3 * (size_t)scene->count.points * sizeof *r->f);
    memset(r->ray, 0, 3 * (size_t)scene->count.points * sizeof *r->ray);
    memset(r->dq, 0, 6 * (size_t)scene->count.blocks * sizeof *r->dq);
    memset(r->y0, 0, 24 * (size_t)count.blocks * sizeof *r->y0);
    memset(L->state.y, 0, 6 * (size_t)count.blocks * sizeof *L->state.y);
    r->lower = r->upper = r->lowest = -1;
    r->tol = L->ends.set.tol;
    r->force_bound = L->ends.set.force_bound;
    L->n.goal = r->tol / 4;
    L->n.left = (sp__problem_strong(&L->ends.pb) ? 2 : 1) * L->ends.set.iterations;
    L->best = SP__HUGE;
    L->ref = sp__limit_reference(&L->ends);
    *limit = L;
    return SP_OK;
}

SP_API sp_status sp_limit(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_limit_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__limit *L = NULL;
    size_t kept = 0;
    sp_arena a = *arena;
    sp_status status = sp__limit_build(scene, settings, &a, &L, &kept);
    if (!status) status = sp__limit_decide(L, &a);
    if (status) return status;
    L->r.verified = L->r.kind != SP_LIMIT_UNDECIDED && sp__ends_hold(&L->ends, &L->r, L->room);
    if (L->r.kind && !L->r.verified) L->r.reason = L->ends.spent ? SP_REASON_BUDGET : SP_REASON_UNVERIFIED;
    if (!L->r.verified) L->r.kind = SP_LIMIT_UNDECIDED;
    L->r.cost = L->ends.cost;
    L->r.peak_bytes = a.peak;
    arena->used = kept;
    arena->peak = a.peak;
    *result = L->r;
    return SP_OK;
}

#endif /* SP_SMALL */

SP_API const char *sp_limit_text(sp_limit_kind kind)
{
    const int k = (int)kind;
    return sp__word("undecided\0" "found\0" "none\0" "unbounded\0" "unknown", k >= 0 && k <= 3 ? k : 4);
}

/* How far vertex v moves with a block in motion dq; returns what that is small against: the most the block's motion can come to
 * there, and its distance from the centroid, which a mechanism's motion is scaled to. */
static sp_real sp__joint_displace(const sp_scene *scene, const sp_real *dq, int32_t block, int32_t v, sp_real u[3])
{
    const sp_real *m = dq + 6 * (size_t)block;
    sp_real arm[3];
    sp__sub3(scene->point[v], scene->block[block].centroid, arm);
    sp__cross3(m + 3, arm, u);
    sp__add3(u, 1, m);
    return sp__norm3(m) + (1 + sp__norm3(m + 3)) * sp__norm3(arm);
}

/* One corner: dn and |dt|.     returns 0 at rest, 1 in touch and sliding, 2 open */
static int sp__joint_corner(const sp_scene *scene, const sp_real *dq, const sp_interface *f, int32_t v, sp_real d[2])
{
    sp_real u[3], w[3];
    const sp_real rest = SP__PLAY * (sp__joint_displace(scene, dq, f->b, v, u) + sp__joint_displace(scene, dq, f->a, v, w));
    sp__sub3(u, w, u);
    sp__joint_frame(f, u, w);
    d[0] = w[0];
    d[1] = SP_SQRT(w[1] * w[1] + w[2] * w[2]);
    if (sp__norm3(u) <= rest) return 0;
    return d[0] <= f->joint.mu * d[1] * (sp_real)1.001 + rest ? 1 : 2;
}

SP_API sp_status sp_joint_moves(const sp_scene *scene, const sp_real *dq, int32_t interface, sp_joint_motion *motion)
{
    if (!scene || !dq || !motion) return SP_E_ARGUMENT;
    if (interface < 0 || interface >= scene->count.interfaces) return SP_E_INDEX;
    const sp_interface *f = &scene->interface[interface];
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

SP_API const char *sp_joint_text(sp_joint_kind kind)
{
    const int k = (int)kind;
    return sp__word("rigid\0" "hinge\0" "sliding\0" "open\0" "unknown", k >= 0 && k <= 3 ? k : 4);
}
#endif /* SP_NO_IPM */

#ifdef SP_SMALL
/* 36 ------------------------------------------------------------------------------------------------------- smallest check */

/* The exact stage of SP_SMALL, in as little code as does it. The same Newton on the dual as in sections 14, 16 and 18,
 *
 *   D(y) = 1/2 sum S_v |P_K(u_v)|^2 + p . y,   u = Aeq' y,   f = S P_K(u)         [Qi, Sun 1993; Rockafellar 1976]
 *
 * vertex by vertex in world axes, its Hessian in an envelope in the order of the blocks. What forces and motions are worth it asks
 * the certificate check, of which it uses the scales and sums but nothing else: that check uses nothing of this. */

#define SP__FLOPS_VERTEX 900            /* a vertex in a Hessian, at most; its gradient and a judgement together no more */

typedef enum sp__want { SP__GRADIENT, SP__HESSIAN, SP__LINEAR, SP__LINEAR_HESSIAN } sp__want;     /* linear: P_K = 1, bilateral */

typedef struct sp__small {
    const sp_problem *pb;
    const sp_settings *set;
    sp__judge j;
    sp_real *H;                         /* envelope */
    int32_t *row;                       /* 6b: of it */
    sp_real *z;                         /* 6b: weights of the rows, 0 where a block is held */
    sp_real *y, *r, *d, *x, *base;      /* 6b each: potential, gradient, step, motion -z y, y before a step */
    sp_real *best;                      /* 6b: y of the least omega */
    sp_real e[3][12];                   /* n, t1, t2 of a vertex as rows of -Aeq': of its blocks of the lower, the higher number */
    int32_t side[2];                    /* these blocks, -1: a support */
    sp_real metric, S;                  /* 1 / largest cap, or 0: S = 1; S of the contact at hand */
    sp_real prox, omega;                /* weight of |y|^2 / 2; the least imbalance so far */
    int64_t flops;                      /* of a factor */
    int32_t sweeps, left;               /* passes over the vertices so far; factorisations that may follow */
    int32_t stalled;                    /* the imbalance no longer falls with prox: something moves */
    sp_result *to;                      /* forces and motion tried last; verdict once decided */
} sp__small;

/* Rows of the envelope.                                                            returns its size, -1: too large to count */
static int64_t sp__small_rows(sp__small *w, const sp_problem *pb)
{
    int32_t *row = w->row;
    int64_t size = 0;
    w->flops = 0;
    for (int32_t i = 0; i < pb->blocks; i++) row[6 * i] = i;
    for (int32_t c = 0; c < pb->contacts; c++) {
        const int32_t a = pb->contact[c].a, b = pb->contact[c].b, low = a < b ? a : b, high = a < b ? b : a;
        if (low >= 0 && low < row[6 * high]) row[6 * high] = low;
    }
    for (int32_t i = 0; i < pb->blocks; i++) {
        const int32_t first = row[6 * i];
        for (int32_t k = 6 * i; k < 6 * i + 6; k++) {
            row[k] = (int32_t)size - 6 * first;
            const int64_t length = k + 1 - 6 * first;
            size += length;
            w->flops += length * length;
            if (size > INT32_MAX) return -1;
        }
    }
    return size;
}

/* The search's own arrays in `a`, rows in `rows`: the same arena, or scratch where `a` only counts.    returns 0: no memory */
static int sp__small_carve(sp__small *w, const sp_problem *pb, sp_arena *rows, sp_arena *a)
{
    w->row = sp__take(rows, (size_t)pb->blocks, 6 * sizeof *w->row);
    const int64_t entries = sp__failed(rows) ? -1 : sp__small_rows(w, pb);
    if (entries < 0) return 0;
    const size_t n = 6 * (size_t)pb->blocks;
    sp_real *v = sp__take(a, n, 7 * sizeof *v);
    w->H = sp__take(a, (size_t)entries, sizeof *w->H);
    if (sp__failed(a)) return 0;
    if (!v) return 1;                                   /* counted */
    w->z = v;
    w->y = v += n;
    w->r = v += n;
    w->d = v += n;
    w->x = v += n;
    w->base = v += n;
    w->best = v + n;
    return 1;
}

/* y += s x */
static void sp__small_axpy(const sp__small *w, sp_real s, const sp_real *x, sp_real *y)
{
    sp__add(y, 1, s, x, 6 * (size_t)w->pb->blocks);
}

static sp_real sp__small_dot(const sp__small *w, const sp_real *x, const sp_real *y)
{
    return sp__dot(x, y, 6 * (size_t)w->pb->blocks);
}

/* x = -z y: the motion of a potential */
static void sp__small_motion(const sp__small *w, const sp_real *y)
{
    for (int32_t k = 0; k < 6 * w->pb->blocks; k++) w->x[k] = -w->z[k] * y[k];
}

/* Row k of a vertex: (s e, s arm x e) of both blocks, the rates -Aeq'.                                     returns u = row . x */
static sp_real sp__small_row(sp__small *w, const sp_contact *t, int32_t v, int k, const sp_real axis[3])
{
    sp_real u = 0;
    for (int side = 0; side < 2; side++) {
        const int32_t i = w->side[side];
        sp_real arm[3], *e = w->e[k] + 6 * side;
        if (i < 0) continue;
        sp__arm(w->pb, i, v, arm);
        sp__scale3(i == t->a ? (sp_real)1 : (sp_real)-1, axis, e);
        sp__cross3(arm, e, e + 3);
        u += sp__dot(e, w->x + 6 * (size_t)i, 6);
    }
    return u;
}

/* H += s e e' */
static void sp__small_square(sp__small *w, sp_real s, const sp_real *e)
{
    for (int p = w->side[0] < 0 ? 6 : 0; p < 12; p++) {
        const int32_t i = 6 * w->side[p / 6] + p % 6;
        const sp_real se = s * e[p];
        for (int side = w->side[0] < 0; side <= p / 6; side++) {
            sp_real *h = w->H + w->row[i] + 6 * w->side[side];
            const sp_real *g = e + 6 * side;
            for (int q = 0; q < (side < p / 6 ? 6 : p % 6 + 1); q++) h[q] += se * g[q];
        }
    }
}

/* One vertex: f = S P_K(u), r += Aeq f, H += Aeq S DP_K(u) Aeq'. On the cone's side P_K(u) = (g.u) g, g = (1, mu w) normed,
 * w = ut / |ut|, and DP_K = g g' + (mu fn / |ut|) w_perp w_perp'. */
SP__APART static void sp__small_vertex(sp__small *w, const sp_contact *t, int32_t v, sp__want want)
{
    const sp_real mu = t->joint->joint.mu;
    const sp_real u[3] = { sp__small_row(w, t, v, 0, t->joint->n), sp__small_row(w, t, v, 1, t->joint->t1),
                           sp__small_row(w, t, v, 2, t->joint->t2) };
    sp_real *f = w->to->f + 3 * (size_t)v, slope[3];
    const sp_real a = SP_SQRT(u[1] * u[1] + u[2] * u[2]);
    for (int k = 0; k < 3; k++) { f[k] = w->S * u[k]; slope[k] = 1; }
    if (want < SP__LINEAR && !(u[0] >= 0 && a <= mu * u[0])) {
        const sp_real fn = (u[0] + mu * a) / (1 + mu * mu), q = 1 / SP_SQRT(1 + mu * mu);
        f[0] = f[1] = f[2] = 0;
        if (!(mu * a > -u[0])) return;
        const sp_real x = u[1] / a, y = u[2] / a;
        f[0] = w->S * fn; f[1] = mu * x * f[0]; f[2] = mu * y * f[0];
        for (int k = 0; k < 12; k++) {
            const sp_real n = w->e[0][k], e = w->e[1][k], g = w->e[2][k];
            w->e[0][k] = q * (n + mu * (x * e + y * g));
            w->e[1][k] = x * g - y * e;
        }
        slope[1] = mu * fn / a; slope[2] = 0;
    }
    const sp_real c[3] = { slope[2] > 0 ? f[0] : SP_SQRT(1 + mu * mu) * f[0], slope[2] * f[1], slope[2] * f[2] };
    for (int k = 0; k < 3; k++) {
        for (int side = 0; side < 2; side++)
            for (int q = 0; q < 6 && w->side[side] >= 0; q++) w->r[6 * w->side[side] + q] -= c[k] * w->e[k][6 * side + q];
        if (want & SP__HESSIAN && slope[k] > 0) sp__small_square(w, w->S * slope[k], w->e[k]);
    }
}

/* f, and r = z (Aeq f + p), at y; H too where it is wanted, not yet weighted. */
SP__APART static void sp__small_sweep(sp__small *w, const sp_real *y, sp__want want)
{
    const sp_problem *pb = w->pb;
    const int32_t n = 6 * pb->blocks;
    for (int32_t i = 0; i < pb->blocks; i++) sp__judge_load(&w->j, i, w->r + 6 * i);
    sp__small_motion(w, y);
    if (want & SP__HESSIAN) memset(w->H, 0, (size_t)(w->row[n - 1] + n) * sizeof *w->H);
    for (int32_t c = 0; c < pb->contacts; c++) {
        const sp_contact *t = &pb->contact[c];
        w->S = w->metric > 0 ? w->metric * sp__judge_cap(&w->j, t) : 1;
        if (!(w->S > 0)) w->S = 1;
        w->side[0] = t->a < t->b ? t->a : t->b;
        w->side[1] = t->a < t->b ? t->b : t->a;
        for (int32_t v = t->point; v < t->point + t->points; v++) sp__small_vertex(w, t, v, want);
    }
    for (int32_t k = 0; k < n; k++) w->r[k] *= w->z[k];
    w->sweeps++;
}

/* L L' = Z H Z + shift */
static void sp__small_factor(sp__small *w, sp_real shift)
{
    const int32_t n = 6 * w->pb->blocks;
    for (int32_t i = 0; i < n; i++) {
        sp_real *h = w->H + w->row[i];
        for (int32_t k = sp__envelope_first(w->row, i); k <= i; k++) h[k] *= w->z[i] * w->z[k];
        h[i] += shift;
    }
    sp__envelope_factor(w->H, w->row, n, 4 * (sp_real)SP_EPSILON);
    w->to->cost.factorisations++;
}

/* x <- (L L')^-1 s b; x may be b. */
static void sp__small_solve(const sp__small *w, sp_real s, const sp_real *b, sp_real *x)
{
    const int32_t n = 6 * w->pb->blocks;
    for (int32_t k = 0; k < n; k++) x[k] = s * b[k];
    sp__envelope_solve(w->H, w->row, n, x);
}

/* Is dq = -z y a proof? Then that is the verdict. */
SP__APART static void sp__small_try(sp__small *w, const sp_real *y)
{
    sp_result *r = w->to;
    if (r->verdict) return;
    sp__small_motion(w, y);
    if (!(sp__judge_motion(&w->j, w->x, 0, &r->final) > w->set->tol)) return;
    r->least_imbalance = sp__judge_mechanism(&w->j, w->x, &r->final);
    r->verdict = SP_UNSTABLE;
}

/* Do the forces of the last sweep balance? */
static void sp__small_look(sp__small *w)
{
    sp_result *r = w->to;
    for (int32_t k = 0; k < 3 * w->pb->points; k++) r->f[k] *= w->j.unit;
    r->omega = sp__judge_forces(&w->j, r->f, r->f);
    if (r->omega <= w->set->tol) r->verdict = SP_STABLE;
    if (!(r->omega < w->omega)) return;
    w->omega = r->omega;
    memcpy(w->best, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->y);
}

/* Nothing resists a mechanism: it is a null vector of the Hessian, and inverse iteration brings it out of x (used up). */
static void sp__small_purify(sp__small *w, sp_real *x)
{
    for (int it = 0; it < 2 && !w->to->verdict; it++) {
        sp__small_solve(w, 1, x, x);
        const sp_real size = SP_SQRT(sp__small_dot(w, x, x));
        if (!(size > 0)) return;
        for (int32_t k = 0; k < 6 * w->pb->blocks; k++) x[k] /= size;
        sp__small_try(w, x);
    }
}

/* Weights and potential of the bilateral force: rows of unit size on average; (G + shift) y = -p, and of each correction what
 * follows a null vector is taken out again.                                                                      [seed 2.1] */
SP__APART static void sp__small_bilateral(sp__small *w)
{
    const int32_t n = 6 * w->pb->blocks;
    for (int32_t k = 0; k < n; k++) { w->y[k] = 0; w->z[k] = !sp__held(w->pb, k / 6, k % 6); }
    sp__small_sweep(w, w->y, SP__LINEAR_HESSIAN);
    for (int32_t k = 0; k < n; k += 3) {
        sp_real sum = 0;
        for (int32_t q = k; q < k + 3; q++) sum += w->H[w->row[q] + q] / 3;
        for (int32_t q = k; q < k + 3 && sum > 0; q++) w->z[q] /= SP_SQRT(sum);
    }
    sp__small_factor(w, SP__SHIFT);
    sp_real last = SP__HUGE;
    for (int it = 0; ; it++) {
        sp__small_sweep(w, w->y, SP__LINEAR);
        const sp_real now = sp__small_dot(w, w->r, w->r);
        sp__small_solve(w, 1, w->r, w->d);
        sp__small_solve(w, SP__SHIFT, w->d, w->x);
        sp__small_axpy(w, -1, w->x, w->d);
        if (it == 5 || now > last / 16) break;
        sp__small_axpy(w, -1, w->d, w->y);
        last = now;
    }
}

/* Scales of the judge by that force, and a metric where contacts of very different load meet.       returns 0: no memory */
SP__APART static int sp__small_scales(sp__small *w, sp_arena *a)
{
    const int32_t n = 6 * w->pb->blocks;
    sp_real least = SP__HUGE, most = 0;
    for (int32_t k = 0; k < n; k++) {
        w->to->y0[k] = w->j.unit * w->z[k] * w->y[k];
        w->to->y0[n + k] = -w->j.unit * w->z[k] * w->d[k];
    }
    if (!sp__judge_open(&w->j, w->pb, w->set, w->to->y0, INT32_MAX, a)) return 0;
    for (int32_t c = 0; c < w->pb->contacts; c++) {
        const sp_real cap = sp__judge_cap(&w->j, &w->pb->contact[c]);
        if (cap < least) least = cap;
        if (cap > most) most = cap;
    }
    if (most > 1000 * least) w->metric = 1 / most;
    return 1;
}

/* y += s d: the whole step first, then where the slope of D(y) + prox |y|^2 / 2 along d is below a fifth of its start. */
SP__APART static sp_real sp__small_move(sp__small *w)
{
    sp_real lo = 0, hi = 0, fhi = 0, s = 1, flo = sp__small_dot(w, w->r, w->d) + w->prox * sp__small_dot(w, w->y, w->d);
    const sp_real noise = 64 * (sp_real)SP_EPSILON * SP_SQRT(sp__small_dot(w, w->d, w->d));
    const int down = flo < -noise;
    const sp_real enough = sp__max(noise, (sp_real)-0.2 * flo);
    memcpy(w->base, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->y);
    for (int it = 0; ; it++) {
        memcpy(w->y, w->base, 6 * (size_t)w->pb->blocks * sizeof *w->y);
        sp__small_axpy(w, s, w->d, w->y);
        sp__small_sweep(w, w->y, SP__GRADIENT);
        const sp_real f = sp__small_dot(w, w->r, w->d) + w->prox * sp__small_dot(w, w->y, w->d);
        if (!down || !(sp__abs(f) > enough) || it == 14) break;
        if (f < 0) { lo = s; flo = f; } else { hi = s; fhi = f; }
        if (hi > 0) {
            const sp_real edge = (hi - lo) / 10, at = lo + (hi - lo) * (-flo / (fhi - flo));
            s = at < lo + edge ? lo + edge : at > hi - edge ? hi - edge : at;
        }
        else if (s > 1000) break;
        else s *= 4;
    }
    sp__small_look(w);
    return s;
}

/* One Newton step; returns its length. On the way y, the step and what inverse iteration makes of them are tried as proofs. */
SP__APART static sp_real sp__small_step(sp__small *w, sp_real shift)
{
    w->left--;
    w->to->cost.iterations++;
    sp__small_sweep(w, w->y, SP__HESSIAN);
    sp__small_factor(w, w->prox + shift);
    if (w->stalled) {
        memcpy(w->d, w->y, 6 * (size_t)w->pb->blocks * sizeof *w->d);
        sp__small_purify(w, w->d);
    }
    sp__small_axpy(w, w->prox, w->y, w->r);
    sp__small_solve(w, -1, w->r, w->d);
    sp__small_axpy(w, -w->prox, w->y, w->r);
    sp__small_try(w, w->d);
    if (w->to->verdict) return 1;
    const sp_real s = sp__small_move(w);
    sp__small_try(w, w->y);
    if (s > 10) sp__small_purify(w, w->d);
    return s;
}

static int sp__small_open(const sp__small *w) { return w->left > 0 && !w->to->verdict; }

/* Plain Newton: quadratic unless close to collapse. Gives up after two tiny steps. */
static void sp__small_plain(sp__small *w)
{
    sp_real shift = SP__SHIFT;
    w->prox = 0;
    w->stalled = 0;
    for (int it = 0, tiny = 0; it < 12 && sp__small_open(w) && tiny < 2; it++) {
        const sp_real s = sp__small_step(w, shift);
        if (s < (sp_real)0.03) { tiny++; shift = shift * 1000 < 1 ? shift * 1000 : 1; }
        if (s > (sp_real)0.5) shift = sp__max(SP__SHIFT, shift / 100);
    }
}

/* Proximal path from y = 0: minimise D(y) + prox |y|^2 / 2 for prox = 0.1, 0.001, ... Either the imbalance vanishes, or -y grows
 * into the mechanism. */
SP__APART static void sp__small_path(sp__small *w)
{
    sp_real level = SP__HUGE;
    for (int32_t k = 0; k < 6 * w->pb->blocks; k++) w->y[k] = 0;
    w->prox = (sp_real)0.1;
    for (int extra = 8; extra > 0 && sp__small_open(w); ) {
        sp__small_step(w, 0);
        if (w->to->verdict) return;
        if (w->prox <= SP__SHIFT) {
            extra--;
            continue;
        }
        const sp_real r = sp__small_dot(w, w->r, w->r), y = w->prox * w->prox * sp__small_dot(w, w->y, w->y);
        const sp_real inner = r + y + 2 * w->prox * sp__small_dot(w, w->r, w->y);
        if (inner > (sp_real)0.09 * y && inner > (sp_real)0.01 * r) continue;
        w->stalled = r > (sp_real)0.01 * level && w->prox < (sp_real)1e-4;
        level = r;
        w->prox = w->prox > 100 * SP__SHIFT ? w->prox / 100 : SP__PROX;
        w->stalled |= w->prox <= SP__DEEP;
    }
}

#ifndef SP_EXACT_ONLY
/* A motion that capped forces might resist: what they resist by is rounding, if all that resists it lets it pass in a null vector
 * of the Hessian there. */
SP__APART static void sp__small_sharpen(sp__small *w)
{
    sp_result *r = w->to;
    for (int it = 0; it < 3 && r->verdict == SP_UNSTABLE && !r->final; it++) {
        const size_t n = 6 * (size_t)w->pb->blocks;
        memcpy(w->base, w->j.x, n * sizeof *w->base);
        for (size_t k = 0; k < n; k++) w->d[k] = w->z[k] > 0 ? -w->base[k] / w->z[k] : 0;
        sp__small_sweep(w, w->d, SP__HESSIAN);
        sp__small_factor(w, SP__SHIFT);
        r->verdict = SP_UNDECIDED;
        sp__small_purify(w, w->d);
        if (r->verdict) continue;
        r->verdict = SP_UNSTABLE;
        r->least_imbalance = sp__judge_mechanism(&w->j, w->base, &r->final);
        return;
    }
}
#endif

/* The search on a built problem, its arrays carved; the judge's behind them. */
SP__APART static int sp__small_run(sp__small *w, sp_arena *a)
{
    sp_result *r = w->to;
    w->omega = SP__HUGE;
    w->left = w->set->iterations;
    w->j.pb = w->pb;
    w->j.unit = sp__load_unit(w->pb);
    sp__small_bilateral(w);
    if (!sp__small_scales(w, a)) return 0;
    for (int32_t k = 0; k < 6 * w->pb->blocks; k++) w->d[k] = -w->r[k];        /* what no contact takes */
    sp__small_purify(w, w->d);
    if (w->metric > 0) sp__small_bilateral(w);
    sp__small_sweep(w, w->y, SP__GRADIENT);
    sp__small_look(w);
    sp__small_plain(w);
    sp__small_path(w);
    sp__small_plain(w);
#ifndef SP_EXACT_ONLY
    sp__small_sharpen(w);
#endif
    if (r->verdict != SP_STABLE) {
        sp__small_sweep(w, w->best, SP__GRADIENT);
        sp__small_look(w);
        if (!r->verdict) r->least_imbalance = sp__judge_mechanism(&w->j, w->x, &r->final);
        sp__check_motion(&w->j, r->dq);
    }
    r->cost.flops = w->flops * r->cost.factorisations
                  + (SP__FLOPS_VERTEX * (int64_t)w->sweeps + SP__FLOPS_JUDGE * (int64_t)w->j.sweeps) * w->pb->points;
    return 1;
}

/* A result's numbers, its arrays in place. */
SP__APART static void sp__small_told(sp_result *r)
{
    r->verified = r->verdict != SP_UNDECIDED;
    r->stage = r->verdict && r->free_blocks ? SP_STAGE_EXACT : SP_STAGE_NONE;
    r->reason = r->verdict == SP_UNSTABLE ? SP_REASON_MECHANISM : r->verdict != SP_STABLE ? SP_REASON_LIMIT
              : r->free_blocks ? SP_REASON_FORCES : SP_REASON_NOTHING;
    r->level = r->verdict == SP_STABLE ? SP_ADMISSIBLE : SP_NONE;
    if (r->verdict != SP_UNSTABLE) r->final = 0;
}

/* Numbers of a result: f, dq, y0. */
static size_t sp__small_numbers(const sp_scene *scene)
{
    sp_problem pb;
    sp__problem_count(scene, &pb);
    return 3 * (size_t)scene->count.points + 6 * (size_t)scene->count.blocks + 12 * (size_t)pb.blocks;
}

SP_API sp_status sp_check(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_result *result)
{
    sp_arena *work = settings ? settings->work : NULL;
    if (!scene || !arena || !arena->base || !result || (work && (work == arena || !work->base))) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp_arena kept = *arena;
    const size_t numbers = sp__small_numbers(scene), joints = (size_t)scene->count.interfaces;
    sp_real *number = sp__take(&kept, numbers, sizeof *number);
    sp_demand *demand = sp__take(&kept, joints, sizeof *demand);
    sp_arena a = work ? *work : kept;
    sp__check *c = sp__take(&a, 1, sizeof *c);
    sp__small *w = sp__take(&a, 1, sizeof *w);
    if (sp__failed(&kept) || sp__failed(&a)) return SP_E_MEMORY;
    memset(number, 0, numbers * sizeof *number);
    memset(demand, 0, joints * sizeof *demand);
    memset(c, 0, sizeof *c);
    memset(w, 0, sizeof *w);
    sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (!status) status = sp_problem_build(scene, &a, &c->pb);
    if (status) return status;
    sp_result *r = &c->r;
    r->f = number;
    r->dq = r->f + 3 * (size_t)scene->count.points;
    r->y0 = r->dq + 6 * (size_t)scene->count.blocks;
    r->demand = demand;
    r->tol = c->set.tol;
    r->force_bound = c->set.force_bound;
    r->free_blocks = c->pb.blocks;
    r->interfaces = c->pb.contacts;
    r->points = sp__points_count(scene);
    r->tension_ratio = r->coupled.tension_ratio = -1;
    r->weakest = -1;
    r->islands = c->pb.blocks > 0;
    if (!r->islands) r->verdict = SP_STABLE;
    w->pb = &c->pb; w->set = &c->set; w->to = r;
    if (!sp__small_carve(w, &c->pb, &a, &a) || (r->islands && !sp__small_run(w, &a))) return SP_E_MEMORY;
    sp__small_told(r);
    r->by_stage[c->set.stage_count - 1] = r->cost;
    if (work) work->peak = a.peak; else kept.peak = a.peak;
    r->peak_bytes = kept.peak;
    *arena = kept;
    *result = *r;
    return SP_OK;
}

/* What a search on problem pb takes from an arena: its own arrays, then the judge's; rows in scratch.     returns 0: no memory */
static int sp__small_need(sp__small *w, const sp_problem *pb, const sp_settings *set, sp_arena scratch, sp_arena *dry)
{
    sp__take(dry, (size_t)pb->blocks, 6 * sizeof *w->row);
    if (!sp__small_carve(w, pb, &scratch, dry)) return 0;
    if (pb->blocks) sp__take(dry, 1, sp__judge_need(pb, set));
    return 1;
}

/* Bytes of a check: of its result, and of all else.                         flops: of a factor; may be NULL */
static sp_status sp__small_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, int64_t *flops, size_t part[2])
{
    if (!scene || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__check *c = sp__take(&scratch, 1, sizeof *c);
    sp__small *w = sp__take(&scratch, 1, sizeof *w);
    if (!w) return SP_E_MEMORY;
    sp_status status = sp__settings_resolve(scene, settings, &c->set);
    if (!status) status = sp_problem_build(scene, &scratch, &c->pb);
    if (status) return status;
    sp_arena kept = sp__arena_dry(), dry = kept;
    sp__take(&kept, sp__small_numbers(scene), sizeof(sp_real));
    sp__take(&kept, (size_t)scene->count.interfaces, sizeof(sp_demand));
    sp__take(&dry, 1, sizeof *c);
    sp__take(&dry, 1, sizeof *w);
    sp__take(&dry, 1, sp_problem_memory(scene));
    if (!sp__small_need(w, &c->pb, &c->set, scratch, &dry)) return SP_E_MEMORY;
    part[0] = kept.used;
    part[1] = dry.used;
    if (flops) *flops = w->flops;
    return SP_OK;
}

/* Both parts in one arena. */
static size_t sp__small_sum(const size_t part[2]) { return ((part[0] + (SP_ALIGN - 1)) & ~(size_t)(SP_ALIGN - 1)) + part[1]; }

SP_API sp_status sp_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    size_t part[2];
    if (!bytes) return SP_E_ARGUMENT;
    const sp_status status = sp__small_memory(scene, settings, scratch, NULL, part);
    if (!status) *bytes = settings && settings->work ? part[0] : sp__small_sum(part);
    return status;
}

SP_API sp_status sp_memory_work(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    size_t part[2];
    if (!bytes) return SP_E_ARGUMENT;
    const sp_status status = sp__small_memory(scene, settings, scratch, NULL, part);
    if (!status) *bytes = part[1];
    return status;
}

SP_API size_t sp_memory_scratch(const sp_scene *scene, const sp_settings *settings)
{
    (void)settings;
    if (!scene) return 0;
    return sizeof(sp__check) + sizeof(sp__small) + sp_problem_memory(scene) + 24 * (size_t)scene->count.blocks + 5 * SP_ALIGN;
}

#ifndef SP_NO_PLAN
/* A check by this search takes everything there is, all blocks together; its factor is known, its steps are a guess. */
SP_API size_t sp_plan_memory(const sp_scene *scene, const sp_settings *settings) { return sp_memory_scratch(scene, settings); }

SP_API sp_status sp_plan(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, sp_outlook *out)
{
    size_t part[2];
    int64_t flops;
    if (!out) return SP_E_ARGUMENT;
    const sp_status status = sp__small_memory(scene, settings, scratch, &flops, part);
    if (status) return status;
    sp_problem pb;
    const int64_t points = sp__points_count(scene);
    sp__problem_count(scene, &pb);
    memset(out, 0, sizeof *out);
    for (int k = 0; k < SP_EFFECTS; k++)
        out->effect[k].why = k == SP_EFFECT_DYNAMICS ? SP_WHY_STATICS : k == SP_EFFECT_COUPLED ? SP_WHY_NOT_ASKED
                           : sp__effect_present(scene, NULL, 1, (sp_effect)k) ? SP_WHY_CALLED : SP_WHY_ABSENT;
    out->islands = pb.blocks > 0;
    out->bytes = out->full_bytes = sp__small_sum(part);
    out->unknowns = out->full_unknowns = 6 * (int64_t)pb.blocks + 3 * points;
    out->flops = out->full_flops = 5 * flops + 20 * SP__FLOPS_VERTEX * points;
    return SP_OK;
}
#endif

#ifndef SP_NO_IPM
/* 37 ------------------------------------------------------------------------------------------------------- smallest limit */

/* sp_limit by that search alone. Forces that balance the live loads without the dead ones are a ray, and there is no end; or
 * something falls under them, and the multiple at which its motion does no work, -(dead . dq) / (live . dq), is no less than
 * lambda. From there Newton's method on the least imbalance over lambda: what falls just below has a lesser one, or, where live
 * loads hold it, tells the least multiple.                                                             [Dinkelbach 1967] */
typedef struct sp__limit {
    sp__ends ends;
    sp__small w;
    sp_result at;                       /* of the search at hand */
    sp_limit_result r;                  /* its dq: the motion of `best` */
    sp_real best, unit, step;           /* least balance; multiple at which both loads are as large; how far below to ask */
    sp_verdict dead;                    /* without live loads */
    int none;                           /* that motion falls at 0, too */
} sp__limit;

/* The search under d dead + l live; the ends' dq is the motion it ends with. */
SP__APART static sp_verdict sp__limit_ask(sp__limit *L, sp_real d, sp_real l, sp_arena room)
{
    sp__ends_mix(&L->ends, d, l);
    L->at.verdict = SP_UNDECIDED;
    L->w.metric = 0;
    if (!L->ends.pb.blocks) return SP_STABLE;
    sp__small_run(&L->w, &room);
    sp__verify_motion(&L->ends.pb, L->at.dq, L->ends.dq);
    return L->at.verdict;
}

/* Power balance of the motion: the multiple of live loads at which its work is 0; SP__HUGE where they do none. */
static sp_real sp__limit_balance(const sp__ends *e)
{
    const sp_real dead = sp__ends_work(e, e->dead), live = sp__ends_work(e, e->live);
    return sp__abs(dead) < SP__HUGE * sp__abs(live) ? -dead / live : SP__HUGE;
}

/* What falls at a: a better bound from above, or, where live loads would hold it, from below. Returns where to ask next; a itself
 * where nothing is gained. */
SP__APART static sp_real sp__limit_cut(sp__limit *L, sp_real a, sp_arena room)
{
    const sp_real balance = sp__limit_balance(&L->ends);
    const int beyond = sp__ends_beyond(&L->ends, room);
    L->none = beyond && !(a > 0);
    if (beyond && (L->none || balance < L->best)) {
        L->best = balance;
        memcpy(L->r.dq, L->at.dq, 6 * (size_t)L->ends.scene.count.blocks * sizeof *L->r.dq);
        return L->none ? a : sp__max(0, balance - L->step);
    }
    const sp_real middle = balance < L->best ? (balance + L->best) / 2 : L->best;
    const sp_real next = balance + L->step < middle ? balance + L->step : middle;
    return !beyond && next > a ? next : a;
}

SP__APART static void sp__limit_search(sp__limit *L, sp_arena room)
{
    sp__ends *e = &L->ends;
    sp_limit_result *r = &L->r;
    sp__ends_mix(e, 1, 0);
    const sp_real dead = sp__load_unit(&e->pb);
    sp__ends_mix(e, 0, 1);
    L->unit = dead / sp__load_unit(&e->pb);
    if (sp__limit_ask(L, 0, 1, room) == SP_STABLE) {
        r->kind = SP_LIMIT_UNBOUNDED;
        L->at.f = r->f;                                 /* the others stay: the ray */
    } else if (sp__ends_work(e, e->live) > 0) sp__limit_cut(L, 1, room);
    L->step = 4 * r->tol * (L->unit + (L->best < SP__HUGE ? L->best : 0));
    sp_real a = L->best < SP__HUGE ? sp__max(0, L->best - L->step) : 0;
    for (int it = 0; it < 24 && !L->none; it++) {
        const sp_verdict verdict = sp__limit_ask(L, 1, a, room);
        if (!(a > 0)) L->dead = verdict;
        if (verdict == SP_STABLE) {
            r->lower = a;
            r->omega = L->at.omega;
            memmove(r->f, L->at.f, 3 * (size_t)e->pb.points * sizeof *r->f);
            if (r->kind == SP_LIMIT_UNBOUNDED || L->best < SP__HUGE) return;
        }
        const sp_real was = a;
        if (verdict == SP_UNSTABLE) a = sp__limit_cut(L, a, room);
        else if (verdict == SP_STABLE || !(L->best < SP__HUGE)) a = a > 0 ? 8 * a : L->unit;
        else { L->step *= 10; a = sp__max(0, L->best - L->step); }
        if (!(a < was) && !(a > was)) return;
    }
}

/* Does it stand under the dead loads alone, and if not, from where on? */
SP__APART static void sp__limit_lowest(sp__limit *L, sp_arena room)
{
    sp_limit_result *r = &L->r;
    sp_real a = 0;
    r->lowest = r->lower;
    if (r->kind == SP_LIMIT_NONE) r->dead = SP_UNSTABLE;
    else if (!(r->lower > 0)) r->dead = r->lower < 0 ? SP_UNDECIDED : SP_STABLE;
    if (r->kind == SP_LIMIT_UNBOUNDED && r->lower > 0) r->dead = L->dead;       /* asked already, and no room for other forces */
    for (int it = 0; it < 12 && r->kind == SP_LIMIT_FOUND && r->lower > a; it++) {
        const sp_real last = a;
        const sp_verdict verdict = sp__limit_ask(L, 1, a, room);
        if (!it) r->dead = verdict;
        if (verdict == SP_STABLE) r->lowest = a;
        if (verdict != SP_UNSTABLE) return;
        a = sp__limit_balance(&L->ends) + L->step;
        if (!(a > last)) return;
    }
}

/* Both ends of what was found, and what that makes of it. */
SP__APART static void sp__limit_conclude(sp__limit *L, sp_arena room)
{
    sp__ends *e = &L->ends;
    sp_limit_result *r = &L->r;
    const sp_real wide = 1000 * r->tol * (L->unit + sp__abs(r->lower));
    sp_real slack = wide / 500;
    for (int it = 0; it < 10 && r->upper < 0 && (L->none || (!r->kind && L->best < SP__HUGE)); it++, slack *= 2) {
        const sp_real lambda = L->none ? 0 : sp__max(0, L->best + slack);
        sp__verify_motion(&e->pb, r->dq, e->dq);
        if (!sp__ends_fall(e, lambda, 1, r->dq, room)
            && (sp__limit_ask(L, 1, lambda, room) != SP_UNSTABLE || !sp__ends_fall(e, lambda, 1, r->dq, room))) continue;
        r->upper = lambda;
        r->least_imbalance = e->least;
        r->final = e->final;
    }
    if (L->none) r->kind = SP_LIMIT_NONE;
    else if (!r->kind && r->lower >= 0 && r->upper - r->lower <= wide) r->kind = SP_LIMIT_FOUND;
    const sp_real balance = sp__limit_balance(e);
    if (r->kind == SP_LIMIT_FOUND) {
        r->multiplier = balance < r->lower ? r->lower : balance > r->upper ? r->upper : balance;
        r->within = sp__ends_within(r, balance);
    }
    sp__limit_lowest(L, room);
    if (r->kind != SP_LIMIT_UNBOUNDED) memset(r->ray, 0, 3 * (size_t)e->pb.points * sizeof *r->ray);
    r->verified = r->kind && sp__ends_hold(e, r, room);
    if (!r->verified) { r->kind = SP_LIMIT_UNDECIDED; r->reason = SP_REASON_LIMIT; }
}

/* f, ray, dq */
static size_t sp__limit_numbers(const sp_scene *scene)
{
    return 6 * ((size_t)scene->count.points + (size_t)scene->count.blocks);
}

SP_API size_t sp_limit_memory_scratch(const sp_scene *scene)
{
    if (!scene) return 0;
    return sizeof(sp__limit) + sp_limit_verify_memory(scene) + 24 * (size_t)scene->count.blocks + 2 * SP_ALIGN;
}

SP_API sp_status sp_limit_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp__limit *L = sp__take(&scratch, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    const sp_status status = sp__ends_build(scene, settings, &L->ends, &scratch);
    if (status) return status;
    sp_real *at[5];
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, sp__limit_numbers(scene), sizeof(sp_real));
    sp__take(&dry, 1, sizeof *L);
    sp__take(&dry, 1, sp_problem_memory(scene));
    sp__ends_carve(at, L->ends.pb.blocks, &dry);
    sp__take(&dry, (size_t)scene->count.blocks, 6 * sizeof(sp_real));
    if (!sp__small_need(&L->w, &L->ends.pb, &L->ends.set, scratch, &dry)) return SP_E_MEMORY;
    *bytes = dry.used;
    return SP_OK;
}

SP_API sp_status sp_limit(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_limit_result *result)
{
    if (!scene || !arena || !arena->base || !result) return SP_E_ARGUMENT;
    if (scene->count.blocks < 1) return SP_E_EMPTY;
    sp_arena a = *arena;
    const size_t numbers = sp__limit_numbers(scene), forces = 3 * (size_t)scene->count.points;
    sp_real *number = sp__take(&a, numbers, sizeof *number);
    const size_t used = a.used;
    sp__limit *L = sp__take(&a, 1, sizeof *L);
    if (!L) return SP_E_MEMORY;
    memset(number, 0, numbers * sizeof *number);
    memset(L, 0, sizeof *L);
    const sp_status status = sp__ends_build(scene, settings, &L->ends, &a);
    if (status) return status;
    sp_limit_result *r = &L->r;
    r->f = number; r->ray = r->f + forces; r->dq = r->ray + forces;
    r->lower = r->upper = r->lowest = -1;
    r->tol = L->ends.set.tol;
    r->force_bound = L->ends.set.force_bound;
    L->best = SP__HUGE;
    L->at.f = r->ray; L->at.y0 = L->ends.hint;
    L->at.dq = sp__take(&a, (size_t)scene->count.blocks, 6 * sizeof *r->dq);
    L->w.pb = &L->ends.pb; L->w.set = &L->ends.set; L->w.to = &L->at;
    sp_arena room = a;
    if (!sp__small_carve(&L->w, &L->ends.pb, &a, &a)) return SP_E_MEMORY;
    room = a;
    sp__take(&a, 1, sp__judge_need(&L->ends.pb, &L->ends.set));
    if (sp__failed(&a)) return SP_E_MEMORY;
    sp__limit_search(L, room);
    sp__limit_conclude(L, room);
    r->cost = L->at.cost;
    r->peak_bytes = arena->peak = a.peak;
    arena->used = used;
    *result = *r;
    return SP_OK;
}
#endif /* SP_NO_IPM */

#ifndef SP_EXACT_ONLY
/* 38 ------------------------------------------------------------------------------------------------- smallest build order */

/* Every step is a check of all that is there: the scene with what is absent or held taken for a support, and joints of what is
 * absent left out. */
struct sp_sequence {
    const sp_scene *scene;
    sp_scene part;
    sp_settings set;
    sp_result r;                        /* of the last check */
    sp_verdict verdict;                 /* of the last step */
    sp_presence *who;                   /* per block; SP__TRIED: held to see what that does */
    int32_t *answer, *must, *told;      /* per block */
    sp_cost cost;                       /* of the call at hand */
    int32_t tries;
    sp_arena work;                      /* of a check */
};

#define SP__TRIED ((sp_presence)3)

static void sp__sequence_carve(sp_sequence *q, const sp_scene *scene, size_t work, sp_arena *a)
{
    const size_t blocks = (size_t)scene->count.blocks;
    q->part.block = sp__take(a, blocks, sizeof *q->part.block);
    q->part.interface = sp__take(a, (size_t)scene->count.interfaces, sizeof *q->part.interface);
    q->who = sp__take(a, blocks, sizeof *q->who);
    q->answer = sp__take(a, 3 * blocks, sizeof *q->answer);
    q->work.base = sp__take(a, 1, work);
    q->work.cap = work;
}

/* Settings, and bytes of a check: one of the whole takes the most. */
static sp_status sp__sequence_work(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, sp_settings *set, size_t *work)
{
    *set = settings ? *settings : sp_settings_default();
    set->work = NULL;
    return sp_memory(scene, set, scratch, work);
}

SP_API size_t sp_sequence_scratch(const sp_scene *scene, const sp_settings *settings)
{
    const size_t most = sp_memory_scratch(scene, settings);
    return most ? sizeof(sp_sequence) + SP_ALIGN + most : 0;
}

SP_API sp_status sp_sequence_memory(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, size_t *bytes)
{
    if (!scene || !bytes || !scratch.base) return SP_E_ARGUMENT;
    sp_sequence *q = sp__take(&scratch, 1, sizeof *q);
    size_t work = 0;
    if (!q) return SP_E_MEMORY;
    const sp_status status = sp__sequence_work(scene, settings, scratch, &q->set, &work);
    if (status) return status;
    sp_arena dry = sp__arena_dry();
    sp__take(&dry, 1, sizeof *q);
    sp__sequence_carve(q, scene, work, &dry);
    *bytes = dry.used;
    return SP_OK;
}

SP_API sp_status sp_sequence_open(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_sequence **sequence)
{
    if (!scene || !arena || !arena->base || !sequence) return SP_E_ARGUMENT;
    sp_arena a = *arena;
    sp_sequence *q = sp__take(&a, 1, sizeof *q);
    size_t work = 0;
    if (!q) return SP_E_MEMORY;
    memset(q, 0, sizeof *q);
    const sp_status status = sp__sequence_work(scene, settings, a, &q->set, &work);
    if (status) return status;
    q->scene = scene;
    q->part = *scene;
    sp__sequence_carve(q, scene, work, &a);
    if (sp__failed(&a)) return SP_E_MEMORY;
    q->must = q->answer + scene->count.blocks;
    q->told = q->must + scene->count.blocks;
    for (int32_t b = 0; b < scene->count.blocks; b++) q->who[b] = scene->block[b].fixed == SP_FIXED ? SP_PRESENT : SP_ABSENT;
    *arena = a;
    *sequence = q;
    return SP_OK;
}

/* What is there, checked. */
SP__APART static sp_verdict sp__sequence_check(sp_sequence *q)
{
    const sp_scene *s = q->scene;
    sp_arena a = q->work;
    q->part.count.interfaces = 0;
    for (int32_t b = 0; b < s->count.blocks; b++) {
        q->part.block[b] = s->block[b];
        if (q->who[b] != SP_PRESENT) q->part.block[b].fixed = SP_FIXED;
    }
    for (int32_t k = 0; k < s->count.interfaces; k++)
        if (q->who[s->interface[k].a] && q->who[s->interface[k].b]) q->part.interface[q->part.count.interfaces++] = s->interface[k];
    q->r.verdict = SP_UNDECIDED;
    sp_check(&q->part, &q->set, &a, &q->r);
    q->cost.flops += q->r.cost.flops;
    q->cost.iterations += q->r.cost.iterations;
    q->cost.factorisations += q->r.cost.factorisations;
    q->tries++;
    return q->r.verdict;
}

static void sp__sequence_start(sp_sequence *q)
{
    memset(&q->cost, 0, sizeof q->cost);
    q->tries = 0;
}

static int sp__loose(const sp_sequence *q, int32_t b) { return q->who[b] == SP_PRESENT && q->scene->block[b].fixed != SP_FIXED; }

static void sp__sequence_step(sp_sequence *q, sp_step *step)
{
    const sp_result *r = &q->r;
    sp_real most = -1;
    sp__sequence_start(q);
    q->verdict = sp__sequence_check(q);
    memset(step, 0, sizeof *step);
    step->verdict = r->verdict;
    step->reason = r->reason;
    step->final = r->final;
    step->block = -1;
    for (int32_t b = 0; b < q->scene->count.blocks && r->verdict != SP_STABLE; b++) {
        const sp_real moves = sp__norm3(r->dq + 6 * (size_t)b);
        if (sp__loose(q, b) && moves > most) { most = moves; step->block = b; }
    }
    step->islands = step->checked = r->islands;
    step->blocks = step->again = r->free_blocks;
    step->omega = r->omega;
    step->least_imbalance = r->least_imbalance;
    step->f = r->f;
    step->dq = r->dq;
    step->cost = q->cost;
}

static int sp__presence_valid(sp_presence p) { return p == SP_ABSENT || p == SP_PRESENT || p == SP_HELD; }

SP_API sp_status sp_sequence_set(sp_sequence *sequence, int32_t block, sp_presence presence, sp_step *step)
{
    if (!sequence || !step || !sp__presence_valid(presence)) return SP_E_ARGUMENT;
    if (block < 0 || block >= sequence->scene->count.blocks) return SP_E_INDEX;
    sequence->who[block] = presence;
    sp__sequence_step(sequence, step);
    return SP_OK;
}

SP_API sp_status sp_sequence_fill(sp_sequence *sequence, const sp_presence *presence, sp_step *step)
{
    if (!sequence || !presence || !step) return SP_E_ARGUMENT;
    const int32_t blocks = sequence->scene->count.blocks;
    for (int32_t b = 0; b < blocks; b++) if (!sp__presence_valid(presence[b])) return SP_E_ARGUMENT;
    memcpy(sequence->who, presence, (size_t)blocks * sizeof *presence);
    sp__sequence_step(sequence, step);
    return SP_OK;
}

/* One of the blocks held on trial let go. */
static sp_verdict sp__hold_without(sp_sequence *q, int32_t b, int64_t budget)
{
    if (budget > 0 && q->cost.flops >= budget) return SP_UNDECIDED;
    q->who[b] = SP_PRESENT;
    const sp_verdict verdict = sp__sequence_check(q);
    q->who[b] = SP__TRIED;
    return verdict;
}

/* A block that falls with all others held is in every set. Of the rest one after the other is let go again: holding more never
 * harms, so what cannot be let go then never can, and with no more than one such block no set is smaller. */
SP_API sp_status sp_sequence_hold(sp_sequence *sequence, int64_t budget, sp_held *held)
{
    if (!sequence || !held || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    const int32_t blocks = q->scene->count.blocks;
    int sure = 1, others = 0;
    sp__sequence_start(q);
    memset(held, 0, sizeof *held);
    for (int32_t b = 0; b < blocks && q->verdict != SP_STABLE; b++) if (sp__loose(q, b)) q->who[b] = SP__TRIED;
    for (int32_t b = 0; b < blocks; b++) q->must[b] = q->who[b] == SP__TRIED && sp__hold_without(q, b, budget) == SP_UNSTABLE;
    for (int32_t b = 0; b < blocks; b++) {
        if (q->who[b] != SP__TRIED || q->must[b]) continue;
        const sp_verdict verdict = sp__hold_without(q, b, budget);
        if (verdict == SP_STABLE) q->who[b] = SP_PRESENT; else others++;
        sure &= verdict != SP_UNDECIDED;
    }
    for (int32_t b = 0; b < blocks; b++) {
        if (q->who[b] != SP__TRIED) continue;
        q->told[held->count] = q->must[b];
        q->answer[held->count++] = b;
        q->who[b] = SP_PRESENT;
    }
    held->block = q->answer;
    held->must = q->told;
    held->proof = !sure ? SP_HELD_ENOUGH : others > 1 ? SP_HELD_IRREDUCIBLE : SP_HELD_MINIMAL;
    held->checks = q->tries;
    held->cost = q->cost;
    return SP_OK;
}

/* May block b be put there (add) or taken away? */
static int sp__next_candidate(const sp_sequence *q, int32_t b, int32_t add)
{
    if (q->scene->block[b].fixed == SP_FIXED) return 0;
    if (!add) return q->who[b] == SP_PRESENT;
    for (int32_t k = 0; k < q->scene->count.interfaces && !q->who[b]; k++) {
        const sp_interface *t = &q->scene->interface[k];
        if ((t->a == b && q->who[t->b]) || (t->b == b && q->who[t->a])) return 1;
    }
    return 0;
}

SP_API sp_status sp_sequence_suggest(sp_sequence *sequence, int32_t add, int64_t budget, sp_suggestion *suggestion)
{
    if (!sequence || !suggestion || budget < 0) return SP_E_ARGUMENT;
    sp_sequence *q = sequence;
    const int32_t blocks = q->scene->count.blocks;
    sp__sequence_start(q);
    memset(suggestion, 0, sizeof *suggestion);
    suggestion->block = -1;
    suggestion->all = 1;
    for (int32_t b = 0; b < blocks; b++) q->answer[b] = sp__next_candidate(q, b, add);
    while (suggestion->block < 0) {
        int32_t next = -1;
        sp_real least = 0;                              /* height, of a block to be taken away the depth */
        for (int32_t b = 0; b < blocks; b++) {
            const sp_real h = (add ? -1 : 1) * sp__dot3(q->scene->gravity, q->scene->block[b].centroid);
            if (q->answer[b] && (next < 0 || h < least)) { next = b; least = h; }
        }
        if (next < 0) break;
        suggestion->all = !(budget > 0 && q->cost.flops >= budget);
        if (!suggestion->all) break;
        const sp_presence was = q->who[next];
        q->answer[next] = 0;
        q->who[next] = add ? SP_PRESENT : SP_ABSENT;
        if (sp__sequence_check(q) == SP_STABLE) suggestion->block = next;
        q->who[next] = was;
        suggestion->tried++;
    }
    suggestion->cost = q->cost;
    return SP_OK;
}
#endif /* SP_EXACT_ONLY */
#endif /* SP_SMALL */

#endif /* SP_QP_ONLY */
