/* stonepack: does this assembly of blocks stand, how sure are we, and why?
 *
 * Rigid blocks touch in plane polygons, their joints. Each corner carries one force, f = fn n + ft1 t1 + ft2 t2, which acts on
 * block B (its opposite on A); n points from A into B, fn > 0 presses, |ft| <= mu fn. The library looks for forces that hold
 * every free block in equilibrium, Aeq f + p = 0, or for a motion that proves there are none.
 *
 *   units      SI: m, kg, s, N; angles never appear. Any consistent set works as well. Gravity is (0, 0, -9.80665) unless
 *              scene.gravity is set.
 *   memory     one arena given by the caller; no call allocates, prints, reads a clock or keeps state of its own.
 *   errors     every call returns an sp_status; on failure outputs are untouched unless its text says otherwise.
 *   pointers   are not NULL and their arrays are read, not kept, unless the text says otherwise.
 *   numbers    of blocks and joints are 0, 1, 2 ... as they are added; a call writes them to *id, which may be NULL.
 *   results    the same input gives the same bits, on every machine, when built with -ffp-contract=off.
 *   licence    MIT
 *
 * A program, two meshes given:
 *
 *     static unsigned char memory[1 << 18];
 *     const sp_capacity room = { 2, 16, 12, 48, 1, 4, 0 };
 *     sp_contact_report found = { 0, 0, 0, 0, NULL };
 *     sp_arena arena; sp_scene scene; sp_result result; sp_evidence evidence; sp_joint_force force;
 *     sp_status s = sp_arena_init(&arena, memory, sizeof memory);
 *     if (!s) s = sp_scene_create(&scene, &room, &arena);
 *     if (!s) s = sp_scene_block(&scene, &ground, 2400, SP_FIXED, NULL);
 *     if (!s) s = sp_scene_block(&scene, &stone, 2400, 0, NULL);
 *     if (!s) s = sp_contacts_find(&scene, NULL, arena, &found);
 *     if (!s) s = sp_check(&scene, NULL, &arena, &result);
 *     if (!s) s = sp_verify(&scene, NULL, &result, arena, &evidence);
 *     if (!s) s = sp_joint_resultant(&scene, &result, 0, &force);
 *     puts(s ? sp_status_text(s) : sp_verdict_text(result.verdict));         // stable; force.force holds the stone [N]
 */
#ifndef STONEPACK_H
#define STONEPACK_H
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

#ifndef SP_API
#define SP_API extern
#endif
#ifdef SP_REAL_FLOAT
typedef float sp_real;
#define SP_EPSILON 5.9604644775390625e-08f              /* u, unit roundoff: 2^-24 */
#define sp_arena_init sp_arena_init_float               /* header and object of different precision do not link */
#elif defined SP_REAL_QUAD                              /* a reference for tests, gcc and clang: SP_SQRT is sqrtq */
typedef __float128 sp_real;
#define SP_EPSILON 9.6296497219361793e-35               /* u, unit roundoff: 2^-113 */
#define sp_arena_init sp_arena_init_quad
#elif !defined SP_REAL_OTHER                            /* defined (tests): sp_real, SP_EPSILON stand before this */
typedef double sp_real;
#define SP_EPSILON 1.1102230246251565e-16               /* u, unit roundoff: 2^-53 */
#endif

typedef enum sp_status {
    SP_OK = 0,
    SP_E_ARGUMENT    = -1,      /* a null pointer, a count below zero, an unknown enumerator */
    SP_E_MEMORY      = -2,      /* the arena is too small */
    SP_E_CAPACITY    = -3,      /* the scene is full: one of its sp_capacity numbers was reached */
    SP_E_NOT_FINITE  = -4,      /* an infinity or a NaN in the input, or a size whose square or cube overflows */
    SP_E_INDEX       = -5,      /* a block, vertex or joint number that does not exist */
    SP_E_RANGE       = -6,      /* a number outside its range: mu < 0, density <= 0, tol, number of pyramid faces ... */
    SP_E_OPEN        = -7,      /* the mesh of a free block has an edge without its opposite */
    SP_E_INWARD      = -8,      /* the mesh of a free block is closed but its faces look inward */
    SP_E_DEGENERATE  = -9,      /* no volume relative to its size, or a face with fewer than three corners */
    SP_E_WARPED      = -10,     /* a face out of plane by more than 1e-2 of its block's diameter */
    SP_E_PLANE       = -11,     /* a joint polygon out of plane by more than 1e-6 of its diameter */
    SP_E_AREA        = -12,     /* a joint polygon without area, a contact normal without length */
    SP_E_SELF        = -13,     /* a joint between a block and itself */
    SP_E_EMPTY       = -14,     /* no block at all */
    SP_E_UNSUPPORTED = -15,     /* legal, but not in this version or build: strength of a joint in a coupled check */
    SP_E_INDEFINITE  = -16      /* P of a quadratic program is not positive semidefinite */
} sp_status;
/* Memory of the caller's, handed out front to back. Reset by `used = 0`; `peak` keeps the largest `used` ever seen. */
typedef struct sp_arena {
    unsigned char *base;        /* aligned start */
    size_t capacity, used, peak; /* [byte]; used <= capacity, used <= peak */
} sp_arena;
/* Start an arena in `bytes` bytes at `memory` (owned by the caller, must outlive the arena). The base is aligned to SP_ALIGN,
 * so up to SP_ALIGN - 1 bytes are lost; give memory that is aligned to lose none.
 *   returns SP_OK, SP_E_ARGUMENT (a null pointer), SP_E_MEMORY (not even one aligned byte) */
SP_API sp_status sp_arena_init(sp_arena *arena, void *memory, size_t bytes);

#ifndef SP_QP_ONLY
/* In full below. */
typedef struct sp_scene sp_scene;                       /* blocks, joints, loads; lives in an arena, which must outlive it */
typedef struct sp_strength { sp_real mu, cohesion, tension, crushing; } sp_strength;    /* of a joint: see below */
typedef struct sp_contact_settings sp_contact_settings;
typedef struct sp_contact_report sp_contact_report;     /* joints, points found; overlaps */
typedef struct sp_settings sp_settings;                 /* of a check; NULL everywhere: the default ones */
typedef struct sp_result sp_result;                     /* verdict, reason; f[3 i .. 3 i + 2] = fn, ft1, ft2 of corner i,
                                                           corners in the order of joints as added; of an UNSTABLE f balances
                                                           nothing, and dq is the motion of the collapse */
typedef struct sp_evidence sp_evidence;                 /* verdict that the evidence proves; verified: it is the result's */
typedef struct sp_joint_force sp_joint_force;           /* force[3] on b in x y z, its point[3]; utilisation |ft| / (mu fn) of
                                                           the joint as a whole */
/* What a scene has room for, each >= 0. */
typedef struct sp_capacity {
    int32_t blocks, vertices, faces, corners;   /* meshes; corners: sum of the faces' vertex counts */
    int32_t joints, points;                     /* contacts; points: sum of the joints' vertex counts */
    int32_t loads;                              /* besides weight */
} sp_capacity;
/* A closed polygon mesh with outward faces, as the caller has it (copied, not kept). */
typedef struct sp_mesh {
    int32_t vertices, faces;
    const sp_real *xyz;         /* 3 x vertices                                              [m] */
    const int32_t *size;        /* corners of each face, >= 3 */
    const int32_t *corner;      /* vertex numbers, 0-based, face after face */
} sp_mesh;

/* An empty scene, sp_scene_memory(capacity) bytes of the arena.    returns SP_OK, SP_E_ARGUMENT (a count < 0), SP_E_MEMORY */
SP_API sp_status sp_scene_create(sp_scene *scene, const sp_capacity *capacity, sp_arena *arena);

#define SP_FIXED 63u            /* all six directions of a block held: x y z forces (bits 0-2), x y z moments (bits 3-5) */
/* Add a block of uniform density > 0 [kg/m^3]. fixed: held directions, 0 .. SP_FIXED; a support (SP_FIXED) may be open or flat.
 *   returns what sp_mesh_mass returns, SP_E_RANGE (density <= 0, fixed > SP_FIXED), SP_E_CAPACITY */
SP_API sp_status sp_scene_block(sp_scene *scene, const sp_mesh *mesh, sp_real density, uint32_t fixed, int32_t *id);
/* Add a block without a mesh, known by its mass [kg] (> 0, or >= 0 for a support) and centroid [m].
 *   returns SP_OK, SP_E_ARGUMENT, SP_E_NOT_FINITE, SP_E_RANGE, SP_E_CAPACITY */
SP_API sp_status sp_scene_body(sp_scene *scene, sp_real mass, const sp_real centroid[3], uint32_t fixed, int32_t *id);
SP_API sp_strength sp_strength_friction(sp_real mu);     /* friction mu and nothing else; mu < 0 is refused where it is used */
/* Add a contact polygon, `points` >= 3 corners in 3 x points numbers, anticlockwise seen from B: its normal by the right hand
 * points from a into b [m]. Plane to 1e-6 of its diameter; collinear corners and repeated joints are legal.
 *   returns SP_OK, SP_E_ARGUMENT, SP_E_NOT_FINITE, SP_E_INDEX, SP_E_SELF, SP_E_AREA (also points < 3), SP_E_PLANE,
 *           SP_E_RANGE (strength), SP_E_CAPACITY */
SP_API sp_status sp_scene_joint(sp_scene *scene, int32_t a, int32_t b, int32_t points, const sp_real *xyz,
                                const sp_strength *strength, int32_t *id);

/* Find what touches what: every pair of opposed near-coplanar face patches of two blocks, not both fixed, clipped to their
 * exact common polygon(s), one joint each, appended to the scene in the order of (a, b). Coplanar neighbouring faces of one
 * block count as one face. scratch: sp_memory, SP_FOR_CONTACTS; overwritten. settings NULL: friction 0.84, distances as below.
 *   report    filled also on SP_E_CAPACITY (nothing is appended then: give the scene that much room and call again)
 *   returns   SP_OK, SP_E_ARGUMENT, SP_E_RANGE, SP_E_NOT_FINITE (strength), SP_E_MEMORY, SP_E_CAPACITY, SP_E_UNSUPPORTED */
SP_API sp_status sp_contacts_find(sp_scene *scene, const sp_contact_settings *settings, sp_arena scratch,
                                  sp_contact_report *report);
typedef enum sp_verdict { SP_UNDECIDED = 0, SP_STABLE = 1, SP_UNSTABLE = 2 } sp_verdict;
/* Does it stand? The arrays of the result live in the arena, of which it takes what sp_memory tells for SP_FOR_CHECK.
 *   returns   SP_OK (whatever the verdict), SP_E_ARGUMENT, SP_E_EMPTY, SP_E_RANGE (settings), SP_E_MEMORY (arena unchanged,
 *             result untouched), SP_E_NOT_FINITE (loads overflow), SP_E_UNSUPPORTED (in this build; strength if coupled) */
SP_API sp_status sp_check(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_result *result);

/* Re-check the evidence of a result from the scene, now or later. scratch: sp_memory, SP_FOR_VERIFY; overwritten.
 *   returns as sp_check; SP_E_NOT_FINITE (in f, a dq or alpha) */
SP_API sp_status sp_verify(const sp_scene *scene, const sp_settings *settings, const sp_result *claim, sp_arena scratch,
                           sp_evidence *evidence);

/* Resultant of one joint on its block b; reads result.f alone.     returns SP_OK, SP_E_ARGUMENT, SP_E_INDEX */
SP_API sp_status sp_joint_resultant(const sp_scene *scene, const sp_result *result, int32_t joint, sp_joint_force *out);
/* ================================================= You can stop here. ================================================= */
#endif /* SP_QP_ONLY */

#define SP_VERSION_MAJOR 0
#define SP_VERSION_MINOR 2
#define SP_VERSION_PATCH 0

#define SP_ALIGN 16             /* [byte] every piece of an arena starts at a multiple of this from its base */

#if defined SP_QP_ONLY && defined SP_EXACT_ONLY
#error "SP_QP_ONLY and SP_EXACT_ONLY: one leaves quadratic programs alone, the other leaves them out"
#elif defined SP_QP_ONLY && defined SP_NO_QP
#error "SP_QP_ONLY and SP_NO_QP: nothing is left"
#endif
#if defined SP_REAL_MIXED && (defined SP_REAL_FLOAT || defined SP_REAL_QUAD)
#error "SP_REAL_MIXED is double with factors in float: not with SP_REAL_FLOAT, SP_REAL_QUAD"
#elif defined SP_REAL_FLOAT && defined SP_REAL_QUAD
#error "SP_REAL_FLOAT and SP_REAL_QUAD: numbers have one precision"
#endif

/* What follows from the switches, which are explained at the end. */
#ifdef SP_EXACT_ONLY
#undef SP_SMALL
#define SP_SMALL
#undef SP_NO_IPM
#define SP_NO_IPM
#undef SP_NO_PLAN
#define SP_NO_PLAN
#undef SP_NO_QP
#define SP_NO_QP
#endif
#ifdef SP_NO_IPM
#undef SP_NO_SLIDING
#define SP_NO_SLIDING
#endif
#ifdef SP_SMALL
#undef SP_NO_CRA
#define SP_NO_CRA
#undef SP_NO_STRONG
#define SP_NO_STRONG
#undef SP_NO_SLIDING
#define SP_NO_SLIDING
#undef SP_QP_NO_CG
#define SP_QP_NO_CG
#undef SP_QP_NO_POLISH
#define SP_QP_NO_POLISH
#undef SP_QP_NO_INTERIOR
#define SP_QP_NO_INTERIOR
#endif

typedef enum sp_words {       /* which enumeration sp_text is asked about */
    SP_WORDS_STATUS = 0, SP_WORDS_QP_STATUS, SP_WORDS_VERDICT, SP_WORDS_LEVEL, SP_WORDS_REASON, SP_WORDS_STAGE, SP_WORDS_EFFECT,
    SP_WORDS_EFFECT_WHY, SP_WORDS_COUPLING, SP_WORDS_COUPLING_REASON, SP_WORDS_PRESENCE, SP_WORDS_HELD_PROOF, SP_WORDS_LIMIT,
    SP_WORDS_JOINT, SP_WORDS_NBO, SP_WORDS_STRONG, SP_WORDS_STRONG_REASON
} sp_words;

/* What a value of that enumeration is called, lower case; of a status: one sentence. An unknown value or enumeration is
 * "unknown", with SP_QP_ONLY all from SP_WORDS_VERDICT on, with SP_NO_STRONG the last two. Never NULL; static storage.
 * sp_verdict_text and others call it. */
SP_API const char *sp_text(sp_words of, int32_t value);
static inline const char *sp_status_text(sp_status status) { return sp_text(SP_WORDS_STATUS, (int32_t)status); }

#ifndef SP_QP_ONLY
/* -------------------------------------------------------------------------------------------------------- the scene in full */

/* sp_strength, what a joint can carry: the set K_v of forces at each of its corners, which share the joint's area A alike,
 * A_v = A / points:
 *     |ft| <= mu fn + cohesion A_v,   fn >= -tension A_v,   fn <= crushing A_v                               [Mohr-Coulomb]
 *
 *     mu         friction coefficient, >= 0 [1]
 *     cohesion   shear strength at no pressure, >= 0 [Pa]; mortar
 *     tension    tensile strength, >= 0 [Pa]
 *     crushing   compressive strength, >= 0 [Pa]; 0: unlimited
 *
 * Tension counts up to cohesion / mu, where the cone ends; a pyramid takes the place of |ft|, an inscribed one with cos(pi/K)
 * of both mu and cohesion. Strength needs an area (not points); coupled checks and sp_matrix_afr know friction only:
 * SP_E_UNSUPPORTED. So does the program of SP_STAGE_ADMM, whose answers are judged as ever. */

typedef struct sp_block {
    sp_real mass;               /* [kg] */
    sp_real centroid[3];        /* [m] */
    sp_real density;            /* [kg/m^3], 0 for a block given by its mass */
    sp_real volume, diameter;   /* [m^3], [m] */
    uint32_t fixed;             /* held directions, SP_FIXED: a support */
    int32_t vertex, vertices;   /* its part of scene.vertex, first and how many; none of a block given by its mass */
    int32_t face, faces;        /* its part of scene.face, likewise */
} sp_block;

typedef struct sp_face { int32_t corner, corners; } sp_face;    /* its part of scene.corner; vertex numbers of the scene */

typedef struct sp_joint {
    int32_t a, b;               /* blocks; n points from a into b */
    int32_t point, points;      /* its part of scene.point */
    sp_real n[3], t1[3], t2[3]; /* right-handed frame: t1 along the first true edge, t2 = n x t1 */
    sp_real area;               /* [m^2], 0 for point and edge contacts */
    sp_strength strength;
} sp_joint;

/* What acts on a block besides its own weight. All of it may be 0; on a support it does nothing. */
typedef struct sp_load {
    int32_t block;              /* 0 .. blocks - 1 */
    int32_t live;               /* 0: always there; else: counts scene.live times */
    sp_real point[3];           /* where force and mass act; it moves with the block [m] */
    sp_real force[3];           /* world axes [N] */
    sp_real couple[3];          /* moment besides that of the force, world axes [N m] */
    sp_real mass;               /* a weight laid on or hung to the point, a gripper for instance, >= 0 [kg] */
} sp_load;

/* The assembly. Read it freely; change it through the calls below (gravity, live and body may be set directly). To take out
 * what was added last, set count back to what it was before (all of it, or joints and points to find them anew). Lives in an
 * arena. Body forces: to shake or tilt a scene for good, change gravity (a seismic coefficient k along x: gravity[0] = k g). */
struct sp_scene {
    sp_real gravity[3];         /* [m/s^2], finite; set to (0, 0, -9.80665) by sp_scene_create */
    sp_real live;               /* multiple at which live loads and `body` act, finite; set to 1 */
    sp_real body[3];            /* live acceleration of every block and every load's mass [m/s^2], 0 */
    sp_capacity capacity, count; /* room, and how much of it is used; count.blocks entries of block[], ... */
    sp_block *block;
    sp_real (*vertex)[3];       /* [m] */
    sp_face *face;
    int32_t *corner;            /* vertex numbers of the scene, face after face */
    sp_joint *joint;
    sp_real (*point)[3];        /* contact vertices [m] */
    sp_load *load;
};

/* Bytes a scene of this capacity takes from an arena, exact; 0 if a number is negative or the size overflows. */
SP_API size_t sp_scene_memory(const sp_capacity *capacity);

typedef struct sp_mass {
    sp_real volume;             /* [m^3] */
    sp_real centroid[3];        /* [m] */
    sp_real diameter;           /* diagonal of the bounding box [m] */
} sp_mass;

/* Volume, centroid and size of a closed mesh with outward faces, about a local vertex so that far coordinates lose nothing.
 *   V = 1/6 sum a.(b x c),  c = 1/(24 V) sum [a.(b x c)](a + b + c)                                    [seed 1.3]
 * A polygon is fanned about its vertex mean (a triangle is taken as it is). Vertices with equal coordinates are the same.
 *   returns SP_OK, SP_E_ARGUMENT, SP_E_NOT_FINITE, SP_E_INDEX, SP_E_DEGENERATE, SP_E_WARPED, SP_E_OPEN, SP_E_INWARD */
SP_API sp_status sp_mesh_mass(const sp_mesh *mesh, sp_mass *mass);

/* Add a point or edge contact: points >= 1 in 3 x points numbers [m] that share the normal n (any length > 0) from a into b.
 *   returns as sp_scene_joint, SP_E_RANGE (points < 1), SP_E_AREA (n without length, strength other than friction) */
SP_API sp_status sp_scene_points(sp_scene *scene, int32_t a, int32_t b, const sp_real n[3], int32_t points,
                                 const sp_real *xyz, const sp_strength *strength, int32_t *id);

/* Use one friction coefficient mu >= 0 for every joint there is.   returns SP_OK, SP_E_ARGUMENT, SP_E_NOT_FINITE, SP_E_RANGE */
SP_API sp_status sp_scene_friction(sp_scene *scene, sp_real mu);

/* Add a load (copied).     returns SP_OK, SP_E_ARGUMENT, SP_E_NOT_FINITE, SP_E_INDEX, SP_E_RANGE (mass < 0), SP_E_CAPACITY */
SP_API sp_status sp_scene_load(sp_scene *scene, const sp_load *load, int32_t *id);

/* Add a pressure [Pa] on one face (its number within the block) as the force it comes to: -pressure x area vector, at the
 * centroid of the face; < 0 pulls. live as sp_load.live.    returns as sp_scene_load, SP_E_INDEX (face), SP_E_AREA (none) */
SP_API sp_status sp_scene_pressure(sp_scene *scene, int32_t block, int32_t face, sp_real pressure, int32_t live, int32_t *id);

/* --------------------------------------------------------------------------------------------------------- contacts in full */

struct sp_contact_settings {
    sp_real distance;           /* faces nearer than this touch, >= 0; relative to the smaller block's diameter  1e-6
                                   beyond 1e-6 at most a quarter of either block's width across the faces (not SP_SMALL);
                                   what is narrower is left out, beyond 1e-6 unless in one plane to 4e-9 (not SP_SMALL) */
    sp_real angle;              /* largest sine of the angle between touching faces, 0 .. 0.5                    1e-3
                                   -k, k <= 64, not SP_SMALL: 1e-3, or up to 0.5 where faces rise k distances at most */
    int32_t absolute;           /* 1: distance is in m                                                              0 */
    sp_strength strength;       /* given to every contact found                                               mu 0.84 */
};

typedef struct sp_overlap { int32_t a, b; sp_real depth; } sp_overlap;     /* two blocks inside each other by `depth` [m] */

struct sp_contact_report {
    int32_t joints, points;         /* found; also when the scene had no room for them */
    int32_t overlaps;               /* pairs of blocks inside each other beyond the distance */
    int32_t overlap_capacity;       /* in: room in `overlap`, >= 0 */
    sp_overlap *overlap;            /* in: the caller's, or NULL; out: the first overlap_capacity of them, by block numbers */
};
SP_API sp_contact_settings sp_contact_settings_default(void);

/* sp_contacts_find's small print. A patch with a hole, or a concave one, is one or several simple polygons with all true
 * corners (of SP_SMALL the convex hull of what faces share in one plane). Scratch is enough unless two faces cross each other
 * like combs, in more places than eight a corner: then it returns SP_E_MEMORY and wants more. SP_SMALL: SP_E_UNSUPPORTED where
 * a face that is not convex lies in one plane with an opposed one and their boxes meet, whether or not they touch. */

/* ------------------------------------------------------------------------------------------------------- what a check tells */

typedef enum sp_level { SP_NONE = 0, SP_ADMISSIBLE = 1, SP_COUPLED = 2 } sp_level;  /* how far a STABLE goes: RBE, CRA */

typedef enum sp_reason {
    SP_REASON_FORCES = 0,       /* stable: an admissible force state was found and verified */
    SP_REASON_NOTHING,          /* stable: no free block, or no load */
    SP_REASON_NO_CONTACT,       /* unstable: a block touches nothing */
    SP_REASON_NO_SUPPORT,       /* unstable: a group of blocks has no path to a support */
    SP_REASON_MECHANISM,        /* unstable: a motion that no admissible force can resist */
    SP_REASON_LIMIT,            /* undecided: neither forces nor motion within tol; the limit is nearer than tol can tell */
    SP_REASON_BUDGET,           /* undecided: the search gave up, its iterations or budget spent, or without progress */
    SP_REASON_STAGES,           /* undecided: the chosen stages cannot decide this */
    SP_REASON_NO_MOTION,        /* unstable, coupled check: no virtual motion explains any admissible forces */
    SP_REASON_NOT_COUPLED,      /* undecided: the coupled check found neither a motion nor a proof that there is none */
    SP_REASON_TENSION,          /* undecided: the penalty form is solved and wants more tension than it tolerates; no proof */
    SP_REASON_UNVERIFIED,       /* undecided: a solver's answer did not pass verification: its forces don't balance within tol,
                                   or its motion proves nothing */
    SP_REASON_EFFECT            /* undecided: an effect was left out that the scene calls for: result.missing */
} sp_reason;

typedef enum sp_stage_id {
    SP_STAGE_NONE = 0,
    SP_STAGE_GATES,             /* no contact, no support, nothing to carry */
    SP_STAGE_LEAST_SQUARES,     /* the bilateral force, accepted if it happens to be admissible            [seed 2.1] */
    SP_STAGE_DENSE,             /* the same by one dense Cholesky factor, 36 b^2 / 2 numbers                [seed 2.1] */
    SP_STAGE_POLISH,            /* alternating projections onto the cone                                   [seed 2.2] */
    SP_STAGE_EXACT,             /* semismooth Newton on the dual; where that stalls interior points, then a proximal path */
    SP_STAGE_ADMM,              /* the penalty form as a quadratic program, at its own accuracy          [seed 1.5, 4] */
    SP_STAGE_CUSTOM             /* the caller's own: settings.custom */
} sp_stage_id;

#define SP_STAGES_MAX 6

/* Work done, in units that are the same on every machine. */
typedef struct sp_cost {
    int64_t flops;              /* + - * / and square roots on matrices and forces, counted by formula */
    int32_t factorisations, iterations;     /* of all methods that ran */
    int32_t interior;           /* of the iterations those of the interior-point method */
} sp_cost;

/* What a scene may or may not call for. sp_check leaves out what it can prove to change nothing; sp_plan says what and why. */
typedef enum sp_effect {
    SP_EFFECT_FRICTION = 0,     /* friction in the joints */
    SP_EFFECT_DEPTH,            /* the third dimension: what goes out of the plane of a mirror */
    SP_EFFECT_TOGETHER,         /* all blocks as one problem; left out, each island of free blocks that touch is solved alone */
    SP_EFFECT_STRENGTH,         /* cohesion, tension and crushing of joints; from here on reported, not chosen */
    SP_EFFECT_LOADS,            /* loads besides weight */
    SP_EFFECT_LIVE,             /* loads that count scene.live times */
    SP_EFFECT_COUPLED,          /* the motion that explains the forces */
    SP_EFFECT_DYNAMICS          /* how it moves: never in statics */
} sp_effect;

#define SP_EFFECTS 8
#define SP_EFFECTS_FORCED 3     /* the first of them are the caller's to force */

/* SP_WITHOUT where the scene calls for the effect: what can still be proved (forces that need none of it) stands, else the
 * verdict is UNDECIDED, SP_REASON_EFFECT. Without SP_EFFECT_TOGETHER is never wrong, so nothing is lost by it. */
typedef enum sp_choice { SP_PLANNED = 0, SP_WITH, SP_WITHOUT } sp_choice;

/* Why an effect is simulated or not. */
typedef enum sp_effect_why {
    SP_WHY_CALLED = 0,          /* on: the scene calls for it */
    SP_WHY_ASKED,               /* on: settings.effect */
    SP_WHY_LEFT_OUT,            /* off: settings.effect */
    SP_WHY_ABSENT,              /* off: mu = 0, no strength, no load */
    SP_WHY_NOT_ASKED,           /* off: a question of its own */
    SP_WHY_STATICS,             /* off: statics */
    SP_WHY_APART,               /* off: islands */
    SP_WHY_STAGES,              /* on: stages that take the scene as it is (ADMM, the seed's, custom), or a budget */
    SP_WHY_MIRROR,              /* off: one mirror plane for everything; not where a motion had to be sought in space */
    SP_WHY_PRESSURE,            /* off: what presses on level joints decides without */
    SP_WHY_FOREST               /* off: contacts form a forest, or nothing need move: the triple follows without a search */
} sp_effect_why;

/* The help one joint would need, where settings.localise: from the penalty form; joined with a motion where that was asked and
 * one was found. 0 where it was not asked. */
typedef struct sp_demand {
    sp_real tension;            /* largest max(0, fm - fp) of its vertices, less what its strength holds [N] */
    sp_real friction;           /* largest |ft| - mu max(0, fp - fm) of its vertices, likewise, or 0 [N] */
} sp_demand;

typedef enum sp_coupling {
    SP_COUPLING_NOT_ASKED = 0,
    SP_COUPLING_COUPLED,        /* a triple was found and verified */
    SP_COUPLING_REFUTED,        /* proved that there is none */
    SP_COUPLING_NOT_FOUND       /* neither */
} sp_coupling;

typedef enum sp_coupling_reason {
    SP_COUPLING_NONE = 0,       /* not asked */
    SP_COUPLING_MOTION,         /* coupled: a motion explains the forces */
    SP_COUPLING_STATICS,        /* refuted: statically unstable; not found: statically undecided */
    SP_COUPLING_NO_MOTION,      /* refuted: no consistent motion */
    SP_COUPLING_LIMIT,          /* not found: what was found needs alpha without bound */
    SP_COUPLING_BUDGET          /* not found: the search spent its work */
} sp_coupling_reason;

/* A proof that no triple meets the conditions of the coupled check; its grammar stands with what is for experts. */
typedef struct sp_proof {
    int32_t nodes, leaves, entries;     /* 0: no proof */
    int32_t island;                     /* 0: of the whole scene; k: of its k-th island, islands.each[k - 1], alone: its
                                           blocks, vertices, V, b and its own unit of force; eps and eta of the whole */
    int32_t *node;
    uint16_t *row;
    sp_real *y;
} sp_proof;

/* What the coupled check found; zero where it was not asked. */
typedef struct sp_coupled {
    sp_coupling verdict;        /* refuted makes the check's verdict UNSTABLE, not found UNDECIDED */
    sp_coupling_reason reason;
    sp_real residual;           /* largest violation relative to what is allowed; of the last attempt if not coupled     [1] */
    int32_t rounds;             /* of the search; 0: none was needed */
    sp_real eps, eta;           /* in force [m] */
    sp_real *dq;                /* 6 x scene.count.blocks: virtual displacement of the centroid, rotation      [m, 1] */
    sp_real *alpha;             /* scene.count.points; the forces are result.f                                 [N/m] */
    sp_real *penalty;           /* 4 x scene.count.points, where settings.localise and not coupled: fp, fm, ft1, ft2 of the
                                   penalty form joined with a motion, as above with fp for fn and any fm >= 0; dq and alpha
                                   are that motion's. The best of several motions, not of all; zero if none will do; of
                                   islands that are coupled their forces; NULL where not localise                      [N] */
    sp_real tension_ratio;      /* its max fm / max fp, the largest of an island; -1: there is none, of some island     [1] */
    sp_proof proof;             /* of a refuted, unless statics refute it; behind all other arrays */
    sp_real margin;             /* of the proof, > 0: what is left of its weakest leaf when all that a triple may be
                                   out by, and rounding, are taken off                                                   [1] */
    sp_cost cost;               /* of this check alone; also in result.spent.total */
} sp_coupled;

/* Free blocks that touch each other, or touch a third that does; the rest of the scene cannot help or harm them. An
 * island's report is what a check of it alone says, with eps and eta of the whole scene. */
typedef struct sp_island {
    sp_verdict verdict;
    sp_reason reason;
    sp_stage_id stage;
    sp_coupling coupling;       /* its coupled check */
    sp_coupling_reason coupling_reason;
    int32_t block, blocks;      /* its first block, how many it has, >= 1 */
} sp_island;

/* What the joints carry at most (0 where they carry none), and which of them is worst off. */
typedef struct sp_extremes {
    sp_real compression;        /* largest fn of a corner [N] */
    sp_real tension;            /* largest demanded tension [N] */
    sp_real utilisation;        /* largest of the joints' [1] */
    sp_real corner_utilisation; /* largest of the corners', the specification's number [1]                       [seed 1.6] */
    sp_real tension_ratio;      /* the seed's own number, max fm / max fp of SP_STAGE_ADMM's solution [1]; -1: there is none */
    int32_t weakest;            /* joint, -1 if there is none: of what falls one of a block that moves, most help demanded, else
                                   the one that opens or slides fastest; of what stands the highest utilisation */
} sp_extremes;

/* What took part: free blocks, the joints that touch one, and their corners. */
typedef struct sp_counts { int32_t free_blocks, joints, points; } sp_counts;

/* Islands, which are checked one by one: the verdict of all is that of the worst. */
typedef struct sp_islands {
    int32_t count;              /* 1: solved as one, 0: nothing to solve */
    int32_t *of;                /* scene.count.blocks: island of each, 0 .. count - 1, -1: a support; NULL where count < 2 */
    sp_island *each;            /* count of them, in the order of their first blocks; NULL where count < 2 */
} sp_islands;

/* What a check took; sums of all islands. */
typedef struct sp_spent {
    sp_cost total;              /* all stages */
    sp_cost by_stage[SP_STAGES_MAX];        /* in the order of settings.stage */
    size_t peak_bytes;          /* of the arena */
} sp_spent;

struct sp_result {
    sp_verdict verdict;
    sp_level level;             /* of a STABLE, else SP_NONE */
    sp_reason reason;
    int32_t final;              /* 1, of an UNSTABLE: no force of any size would do, for the true cone; then least_imbalance may
                                   be less than tol */
    int32_t verified;           /* 1: the evidence passed sp_verify's own computation */
    sp_stage_id stage;          /* that decided, or SP_STAGE_NONE */
    sp_real imbalance;          /* largest relative imbalance of f, 1e30 where forces press on a block without loads; tells for
                                   every verdict; where pressure alone decided (SP_WHY_PRESSURE) relative to the loads alone,
                                   which sp_verify makes less                                                            [1] */
    sp_real least_imbalance;    /* proved by dq: no admissible forces within force_bound come below this one            [1] */
    sp_real *f;                 /* 3 x scene.count.points: fn, ft1, ft2 of each contact vertex, exactly in the cone     [N] */
    sp_real *dq;                /* 6 x scene.count.blocks: displacement of the centroid, rotation; of an UNSTABLE the mechanism,
                                   of an UNDECIDED the nearest to one found, of a STABLE zero; scaled so that the largest
                                   displacement is the largest distance of a joint from its block's centroid; where
                                   nothing touches anything half the size of the largest block                        [m, 1] */
    sp_demand *demand;          /* scene.count.joints; zero where not asked for */
    sp_extremes extremes;
    sp_real tol, force_bound;   /* in force */
    sp_effect missing;          /* of SP_REASON_EFFECT alone: what was left out */
    sp_effect_why effect[SP_EFFECTS];           /* by sp_effect: what was simulated and what not, and why */
    sp_counts counts;
    sp_islands islands;
    sp_coupled coupled;
    sp_spent spent;
    sp_real *y0;                /* 12 x free blocks: potential of the bilateral force in two parts of 6, large and small (one
                                   part alone loses a pebble beside a cathedral); a hint for sp_verify */
};

/* The verdict that the evidence of a claim proves, recomputed from the scene by a projection and sums of its own.
 * sp_verify reads the claim's f, dq and (if not NULL) y0, a hint of the search's for the scales, used only as far as its
 * residual allows and ignored where it is not finite; and if settings.coupled.asked its coupled.dq and coupled.alpha (unless
 * NULL) and coupled.proof (if it has nodes); nothing else. tol, force_bound (a smaller one than 4 counts as 4, for less proves
 * no fall), cone, eps and eta are those of the settings, friction and gravity those of the scene, whatever the claim says. */
struct sp_evidence {
    sp_verdict verdict;         /* proved by claim->f (STABLE) or claim->dq (UNSTABLE), else UNDECIDED */
    int32_t final;              /* as in sp_result, and so the next two [1] */
    sp_real imbalance, least_imbalance;         /* the first of the claim's forces, their ft shortened onto the cone */
    sp_level level;             /* of a STABLE, else SP_NONE; coupled: the triple proves that, too */
    sp_real residual;           /* of the triple, proved where <= 1; 0 where none was asked for or claimed [1] */
    sp_real margin;             /* of a proof that there is no triple; the verdict then is UNSTABLE; 0: no such proof [1] */
};

struct sp_joint_force {
    sp_real force[3];           /* resultant on b, world axes [N] */
    sp_real point[3];           /* where it acts: mean of the vertices weighted by |fn| [m] */
    sp_real min_fn, max_fn;     /* of its corners [N] */
    sp_real utilisation;        /* |sum ft| / (mu sum fn + cohesion area) [1]; 0 below 1e-4 of the lighter block's weight */
    sp_real corner_utilisation; /* largest |ft| / (mu fn + its share of cohesion) of a corner [1]; of this force state alone:
                                   others may use less. A corner below 1e-4 of the lighter block's weight, or of the
                                   joint's largest fn, does not count; 0 in SP_SMALL                         [seed 1.6] */
};

/* What the contacts together do to a block: force [N] and moment about its centroid [N m], world axes. On a free block they
 * balance its weight and loads; a support's reaction is the opposite. Reads result.f alone.    returns as sp_joint_resultant */
SP_API sp_status sp_block_resultant(const sp_scene *scene, const sp_result *result, int32_t block, sp_real force[3],
                                    sp_real moment[3]);

/* The same, a function for each group of words. sp_effect_on: is it simulated (1) or left out (0)? */
static inline const char *sp_verdict_text(sp_verdict verdict) { return sp_text(SP_WORDS_VERDICT, (int32_t)verdict); }
static inline const char *sp_level_text(sp_level level) { return sp_text(SP_WORDS_LEVEL, (int32_t)level); }
static inline const char *sp_reason_text(sp_reason reason) { return sp_text(SP_WORDS_REASON, (int32_t)reason); }
static inline const char *sp_stage_text(sp_stage_id stage) { return sp_text(SP_WORDS_STAGE, (int32_t)stage); }
static inline int sp_effect_on(sp_effect_why w) { return w == SP_WHY_CALLED || w == SP_WHY_ASKED || w == SP_WHY_STAGES; }
static inline const char *sp_effect_text(sp_effect effect) { return sp_text(SP_WORDS_EFFECT, (int32_t)effect); }
static inline const char *sp_effect_why_text(sp_effect_why why) { return sp_text(SP_WORDS_EFFECT_WHY, (int32_t)why); }
static inline const char *sp_coupling_text(sp_coupling coupling) { return sp_text(SP_WORDS_COUPLING, (int32_t)coupling); }
static inline const char *sp_coupling_reason_text(sp_coupling_reason reason)
{
    return sp_text(SP_WORDS_COUPLING_REASON, (int32_t)reason);
}

/* ---------------------------------------------------------------------------------------------------- what a check is asked */

/* What the coupled check is asked with; eps, eta and eta / eps below 1e30. */
typedef struct sp_coupled_settings {
    int32_t asked;              /* 1: where the forces exist, ask for the motion; where none shows up to 2.5e10
                                   flops an island, or settings.budget                                                  0 */
    sp_real eps;                /* what a joint gives [m], >= 0; below 0: 1e-4 of the mean edge of the joints          -1 */
    sp_real eta;                /* largest dn, |dt| [m], > 0; 0: 100 eps, of an eps of 0 what 1e-2 of the mean edge is  0 */
    int32_t box;                /* 1: eta bounds dt1 and dt2 each, as compas_cra; 0: |dt|                                0 */
    int32_t rounds;             /* >= 0; 0: the default search; else the seed's alternation, at most so many rounds    [3.3]
                                   (SP_E_UNSUPPORTED where there is no preset of the seed)                               0 */
    int32_t nodes;              /* of the exact decision's tree, at most; memory for its proof: about 210 bytes each.
                                   0: none; below 0, of V contact vertices: 24 V^3, 48000 at most, above SP_EXACT_POINTS none;
                                   each island has its own, all have the same memory                                    -1 */
} sp_coupled_settings;

#define SP_EXACT_POINTS 48      /* contact vertices of an island up to which the coupled check is decided by branch and bound */

struct sp_stage; struct sp_qp_solver; struct sp_seed;

#define SP_TOL_QUICK ((sp_real)1e-3)    /* steps of the one dial, settings.tol */
#ifdef SP_REAL_FLOAT
#define SP_TOL_STANDARD ((sp_real)1e-4)
#define SP_TOL_PRECISE ((sp_real)1e-5)
#else
#define SP_TOL_STANDARD ((sp_real)1e-6)
#define SP_TOL_PRECISE ((sp_real)1e-9)
#endif

/* The penalty form, min 1/2 sum(fp^2 + gamma fm^2 + tau |ft|^2): what localise and SP_STAGE_ADMM solve.           [seed 1.5] */
typedef struct sp_penalty_settings {
    sp_real gamma, tau;         /* weight of tension, of friction, relative to compression, > 0                       1e3, 1 */
    int32_t net;                /* 1: friction on fp - fm instead of fp; shows no tension                                  0 */
    const struct sp_qp_solver *solver;          /* for SP_STAGE_ADMM and coupled.rounds; NULL: sp_qp_solve           NULL */
} sp_penalty_settings;

/* Who watches a check. `step` is called when a stage begins, with its name, and after that once a factorisation of the exact,
 * least-squares, polish and penalty searches, with SP_STAGE_NONE; cost: of that stage and island so far. It changes nothing
 * and nothing depends on it. A plan, verification and SP_SMALL tell nothing. */
typedef struct sp_watch {
    void (*step)(void *self, sp_stage_id stage, const sp_cost *cost);
    void *self;
} sp_watch;

/* More cores. `run` calls task(job, k) once for each k of 0 .. n - 1, in any order and at the same time where it can, and
 * returns when all calls have. Tasks write apart from each other: the result has the same bits however many run. Factors of
 * large scenes are made so; a task is at least some 20 microseconds of work, n at most 16. Without `run`: SP_E_ARGUMENT. */
typedef struct sp_parallel {
    void (*run)(void *self, void (*task)(void *job, int32_t k), void *job, int32_t n);
    void *self;
} sp_parallel;

/* Settings of a check. Get them from sp_settings_default() and change what you must: first what most callers change. */
struct sp_settings {
    sp_real tol;                /* accuracy of the evidence, 4 u .. 0.1; relative imbalance per block   1e-9, float 1e-4
                                   above an eighth of the least friction > 0 counts as that, with coupled.asked above 1e-6,
                                   float 1e-4, as that; the result says what was in force */
    int64_t budget;             /* flops >= 0 the check may spend, never more; 0: no limit. Islands are solved as one then. The
                                   result is the best evidence so far: a larger budget decides what a smaller one did, and its
                                   imbalance is no larger (ADMM's last iterate may be worse; in float without interior points by
                                   a fifth at most). A custom stage heeds state.left by itself                           0 */
    sp_choice effect[SP_EFFECTS_FORCED];        /* by sp_effect                                                   planned */
    sp_coupled_settings coupled;                /* the coupled check */
    int32_t localise;           /* 1: where not stable, solve the penalty form to see where help is wanted, but for stones
                                   without a path to a support; with coupled.asked where not coupled, joined with a motion. It
                                   takes up to twice as long then                                                         0 */
    int32_t iterations;         /* >= 0: factorisations an exact solve may spend; below 300 nothing is left out by plan 300 */
    sp_real force_bound;        /* forces above this multiple of the ordinary ones count as none;
                                   >= 0; 0: tol/(10u), 4 at least, 1e6 at most
                                   larger decides nearer to friction locks, smaller decides collapse sooner */
    int32_t faces;              /* 3 .. 64: friction pyramid of so many; 0: the true cone (ADMM: 8 faces inscribed)    0 */
    int32_t inscribed;          /* 1: pyramid inside the cone (mu cos(pi/K)); 0: around it (mu)                        1 */
    int32_t stage_count;                        /* 1 .. SP_STAGES_MAX                                                  2 */
    sp_stage_id stage[SP_STAGES_MAX];           /* order in which stages are tried                          gates, exact */
    const struct sp_stage *custom;              /* for SP_STAGE_CUSTOM, else NULL */
    const struct sp_seed *seed;                 /* constants and gates of the seed (the seed, below); NULL: only its constants
                                                   where a stage has no other, gates by tol                NULL */
    sp_penalty_settings penalty;                /* the penalty form */
    struct sp_arena *work;      /* another arena, the caller's, where stages work: their factors are most of what a check takes.
                                   `used` stays, `peak` tells. SP_E_ARGUMENT: the arena of the check itself, or one without
                                   memory. For sp_check; plan, sequence, limit do without                           NULL */
    const sp_watch *watch;      /* told how far the check is; NULL: no one                                          NULL */
    const sp_parallel *parallel;                /* runs tasks on more cores; NULL: one task after the other         NULL */
};
SP_API sp_settings sp_settings_default(void);

/* ---------------------------------------------------------------------------------------------------------- how much memory */

/* What memory is asked for. Told before the call, exact unless said otherwise. */
typedef enum sp_memory_for {
    SP_FOR_CHECK = 0,           /* sp_check, from its arena. At most where nothing is to be carried, where a stage decides
                                   before one that takes more, where the budget or an effect left out ends it, with
                                   coupled.asked where statics refuse. With settings.work: without what that arena takes */
    SP_FOR_WORK,                /* sp_check, of the arena settings.work (whatever that is now) */
    SP_FOR_VERIFY,              /* sp_verify's scratch, at most (for 64 faces) */
    SP_FOR_CONTACTS,            /* sp_contacts_find's scratch, at most */
    SP_FOR_PLAN,                /* sp_plan's scratch, at most */
    SP_FOR_LIMIT,               /* sp_limit, at most; exact where interior points find a limit in the plane of a mirror */
    SP_FOR_LIMIT_VERIFY,        /* sp_limit_verify's scratch, at most */
    SP_FOR_SEQUENCE,            /* sp_sequence_open, and all that is ever needed */
    SP_FOR_PROBLEM,             /* sp_problem_build */
    SP_FOR_STRONG,              /* sp_strong: with a budget less, a proof that it pays for; SP_E_ARGUMENT: left out */
    SP_FOR_STRONG_VERIFY,       /* sp_strong_verify's scratch; likewise */
    SP_FOR_SLIDING,             /* sp_sliding; likewise */
    SP_FOR_SLIDING_VERIFY       /* sp_sliding_verify's scratch; likewise */
} sp_memory_for;

/* Bytes that a call with this scene and these settings (NULL: the default ones) takes from its arena.
 *   scratch   check, work, limit, sequence run their symbolic step in it and may overwrite it; the others follow from counts
 *             alone and leave it alone: an empty one will do
 *   returns   SP_OK, SP_E_ARGUMENT (also an unknown `what`), SP_E_MEMORY (scratch too small, sp_memory_scratch tells how much;
 *             or more bytes than can be counted), SP_E_UNSUPPORTED (what this build leaves out), else what the call returns */
SP_API sp_status sp_memory(const sp_scene *scene, sp_memory_for what, const sp_settings *settings, sp_arena scratch,
                           size_t *bytes);

/* Bytes of scratch that sp_memory needs for it, an upper bound from counts alone; 0: too large to count, or unusable settings.
 * A penalty.solver whose `need` wants more than sp_qp_memory would must say so itself. */
SP_API size_t sp_memory_scratch(const sp_scene *scene, sp_memory_for what, const sp_settings *settings);

#ifndef SP_NO_STRONG
/* ------------------------------------------------------------------------------------------------ whatever friction does
 *
 * STABLE says that admissible forces exist. Friction may find others: which it finds is decided by the scene's history. At
 * rest the accelerations a of the blocks and the forces f meet
 *
 *     M a = p + Aeq f,  fn >= 0, dn >= 0, fn dn = 0,  |ft| <= mu fn,  dt != 0 => ft = -mu fn dt / |dt|,  d = Aeq' a
 *
 * STRONG says that every such pair has a = 0, AMBIGUOUS that some have and some have not. With more friction, more contacts or
 * more load it may be the one or the other: neither is monotone. Joints with strength count for what pressure alone holds.
 */
typedef enum sp_strong_kind {
    SP_STRONG_NONE = 0,         /* the forces that were given hold nothing */
    SP_STRONG_ADMISSIBLE,       /* it may stand: neither a proof that nothing moves nor a motion was found */
    SP_STRONG_AMBIGUOUS,        /* it stands or goes, by its history: a motion that friction does not hinder */
    SP_STRONG_AT_CORNERS,       /* proved, if pressure is at the corners that the joints list: nothing moves; a plate whose
                                   pressure gathers at its middle spins more easily */
    SP_STRONG_STRONG            /* proved: whatever friction does, and wherever in the joints pressure is, nothing moves */
} sp_strong_kind;

typedef enum sp_strong_reason {
    SP_STRONG_NO_FORCES = 0,    /* none: imbalance beyond tol */
    SP_STRONG_PRESSURE,         /* strong: pressure alone balances the loads, so mu and masses do not matter */
    SP_STRONG_MOTION,           /* ambiguous: (moving, a) */
    SP_STRONG_NOTHING_FOUND,    /* admissible: no start led to a motion, and no proof was found */
    SP_STRONG_NOT_ASKED,        /* admissible: strength of a joint, or a load with mass, with which motions are unknown */
    SP_STRONG_CASES,            /* strong: a proof that tells cases of sticking and slipping apart, up to 16 corners */
    SP_STRONG_EVEN              /* strong: f, with friction in proportion to pressure in every joint; no loops of joints, up to
                                   32 free blocks */
} sp_strong_reason;

typedef struct sp_strong_settings {
    int32_t starts;             /* most sweeps from which a motion is sought, >= 0, beside 16 pairs by pivoting where it is
                                   > 0; settings.budget is for their flops                                              256 */
    int32_t corners;            /* 1: pressure is at the corners that joints list, 0: maybe anywhere in their polygons     0 */
} sp_strong_settings;
static inline sp_strong_settings sp_strong_settings_default(void)
{
    const sp_strong_settings s = { 256, 0 };
    return s;
}

typedef struct sp_strong_result {
    sp_strong_kind kind;
    sp_strong_reason reason;
    int32_t plate;              /* 1: of a STRONG, proved for pressure anywhere in the joints' polygons; of an AMBIGUOUS, its
                                   friction is one force a joint at the centre of pressure, shared by corners as that is */
    int32_t starts;             /* that were tried */
    int32_t balls;              /* free blocks without a mesh: where they turn, an AMBIGUOUS is one for the inertia of a ball as
                                   large as the block's joints are far from its centroid */
    sp_real residual;           /* of a STRONG: largest relative imbalance of f; of an AMBIGUOUS: of (moving, a)        [1] */
    sp_real moves;              /* of an AMBIGUOUS: largest acceleration of a block, in all forces on it / mass, >= 1e-3 [1] */
    sp_proof proof;             /* of SP_STRONG_CASES: no block moves by more than 1e-3 of its load / its mass, for forces
                                   up to 1e4 sbar; behind all other arrays */
    sp_real margin;             /* of a proof, > 0                                                                        [1] */
    sp_real tol;                /* in force */
    sp_real *f;                 /* 3 x scene.count.points: forces at rest; of a STRONG by pressure ft = 0; between two
                                   supports, where any would do, those given or 0                                     [N] */
    sp_real *moving;            /* 3 x scene.count.points: forces of the motion, else 0                               [N] */
    sp_real *a;                 /* 6 x scene.count.blocks: acceleration of the centroid, of the turn; else 0
                                                                                                         [m/s^2, rad/s^2] */
    sp_cost cost;
    size_t peak_bytes;          /* of the arena */
} sp_strong_result;

/* Does it stand whatever friction does? It asks for pressure first, then whether friction in proportion to pressure holds a
 * tree of joints, then for motions, by sweeps over the corners from many starts, each judged with every condition above to tol;
 * then, in double and up to 16 corners, by branch and bound over corners that are open, stick or slip within a sector, whose
 * proof is judged.
 *   settings  NULL: the default ones; read are tol, force_bound, budget; faces must be 0
 *   f         of a sp_check that says STABLE, 3 x scene.count.points
 *   pressed   f of a sp_check with settings.effect[SP_EFFECT_FRICTION] = SP_WITHOUT that says STABLE; NULL where it does not
 *   how       NULL: the default
 *   result    its arrays live in the arena, of which it takes what sp_memory tells for SP_FOR_STRONG
 *   returns   SP_OK (whatever the kind), SP_E_NOT_FINITE (f), SP_E_RANGE (how), SP_E_UNSUPPORTED (faces), else as sp_check */
SP_API sp_status sp_strong(const sp_scene *scene, const sp_settings *settings, const sp_strong_settings *how, const sp_real *f,
                           const sp_real *pressed, sp_arena *arena, sp_strong_result *result);

/* What f, moving, a and proof of a claim prove, recomputed from the scene; nothing else of it is read.
 *   scratch: sp_memory, SP_FOR_STRONG_VERIFY; overwritten      returns as sp_verify, SP_E_UNSUPPORTED (a pyramid) */
SP_API sp_status sp_strong_verify(const sp_scene *scene, const sp_settings *settings, const sp_strong_result *claim,
                                  sp_arena scratch, sp_strong_kind *proved);

static inline const char *sp_strong_text(sp_strong_kind kind) { return sp_text(SP_WORDS_STRONG, (int32_t)kind); }
static inline const char *sp_strong_reason_text(sp_strong_reason reason)
{
    return sp_text(SP_WORDS_STRONG_REASON, (int32_t)reason);
}
#endif

#ifndef SP_NO_IPM
/* ------------------------------------------------------------------------------------------------------ how far from falling
 *
 * The largest multiple lambda >= 0 of the live loads (those with live not 0, and scene.body) that the assembly bears on top of
 * the others: the largest lambda for which an admissible force state exists. With friction that is an upper value: such a
 * state is necessary for standing, not sufficient, and a real wall may fall at less (its friction does not make it open as it
 * slides). Without friction, and where nothing slides, it is exact.              [Drucker 1954; Gilbert, Casapulla, Ahmed 2006]
 */

typedef enum sp_limit_kind {
    SP_LIMIT_UNDECIDED = 0,     /* an end of the bracket was not found, or they are too far apart; see reason */
    SP_LIMIT_FOUND,             /* lower and upper are verified and close */
    SP_LIMIT_NONE,              /* no lambda >= 0 works: dq falls under the dead loads, and live loads do not hinder it */
    SP_LIMIT_UNBOUNDED          /* every lambda >= lower works: ray balances the live loads alone, without strength */
} sp_limit_kind;

typedef struct sp_limit_result {
    sp_limit_kind kind;
    sp_reason reason;           /* SP_REASON_FORCES; of an UNDECIDED: SP_REASON_BUDGET, SP_REASON_LIMIT: the bracket stays open
                                   at this tol, or SP_REASON_UNVERIFIED */
    sp_real multiplier;         /* lambda >= 0: power balance of dq, (resistance - dead . dq) / (live . dq), the resistance that
                                   of joints with strength; bracketed; 0 unless FOUND */
    sp_real lower;              /* sp_verify of f, with scene.live = lower, says STABLE; -1: no such end */
    sp_real upper;              /* sp_verify of dq, with scene.live = upper, says UNSTABLE, and live . dq > 0; -1: no such end.
                                   Of a NONE 0 */
    sp_real within;             /* of a FOUND: by so much the multiplier may be off: the bracket's width, and what tol forgives
                                   forces at lower in the mechanism; counts against the loads, not a small multiplier */
    sp_verdict dead;            /* under the dead loads alone, verified, evidence not kept; UNSTABLE: live loads must hold it */
    sp_real lowest;             /* least multiple found at which it stands: 0 where dead is STABLE; -1: none */
    sp_real imbalance;          /* largest relative imbalance of f [1] */
    sp_real least_imbalance;    /* that dq proves at upper [1] */
    int32_t final;              /* of dq at upper: no force of any size would do, for the true cone */
    int32_t verified;           /* sp_limit_verify agrees */
    sp_real tol, force_bound;   /* in force */
    sp_real *f;                 /* 3 x scene.count.points, at lower                                                   [N] */
    sp_real *ray;               /* 3 x scene.count.points, for the live loads alone; zero unless UNBOUNDED            [N] */
    sp_real *dq;                /* 6 x scene.count.blocks: collapse mechanism; scaled as that of a check            [m, 1] */
    sp_real *y0;                /* 24 x free blocks: hints for the verification of dead and live loads; may be NULL */
    sp_cost cost;
    size_t peak_bytes;          /* of the arena */
} sp_limit_result;

/* How much of the live loads? By a primal-dual interior-point method in forces, motion and lambda at once, whose last answer
 * is made exact and then verified from both sides. Joints with strength: what loads without end leave of them (friction;
 * nothing of one that may crush) tells whether there is an end; it is sought by Newton's method on the exact stage's dual, with
 * lambda in it. What either leaves open is left to the exact stage, by Newton's method on the power balance; the dead loads,
 * and ends that are still apart, to whole checks, up to 40 between the ends, where 300 iterations or more may be spent.
 *   scene     its `live` is not read
 *   settings  NULL: the default ones; read are tol, force_bound, faces, inscribed, iterations (four times as many where joints
 *             have strength), budget, and effect of the third dimension, which is left out as by a check: 3 rows a block where
 *             joints, dead and live loads share a mirror. A budget is never exceeded; a larger one mostly decides what a
 *             smaller one did
 *   result    its arrays live in the arena, of which it takes what sp_memory tells for SP_FOR_LIMIT
 *   returns   SP_OK (whatever the kind), SP_E_UNSUPPORTED (coupled), else as sp_check */
SP_API sp_status sp_limit(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_limit_result *result);

/* Do both ends hold? Recomputes them from the scene by what sp_verify uses: kind, lower, upper, f, ray, dq and (if not NULL) y0
 * of the claim are read. scratch: sp_memory, SP_FOR_LIMIT_VERIFY; overwritten.
 *   out       held: 1 if every end the claim has is proved; a FOUND and an UNBOUNDED have a lower one, a FOUND an upper one
 *   returns   as sp_verify */
SP_API sp_status sp_limit_verify(const sp_scene *scene, const sp_settings *settings, const sp_limit_result *claim,
                                 sp_arena scratch, int32_t *held);

static inline const char *sp_limit_text(sp_limit_kind kind) { return sp_text(SP_WORDS_LIMIT, (int32_t)kind); }

#ifndef SP_NO_SLIDING
/* ----------------------------------------------------------------------------------------------- sliding without dilatancy
 *
 * The limit above has friction that opens joints as they slide. Real sliding does not. A sliding state at lambda is (f, v) with
 *
 *     p + lambda q + Aeq f = 0,  fn >= 0, dn >= 0, fn dn = 0,  |ft| <= mu fn,  dt != 0 => ft = -mu fn dt / |dt|
 *     d = Aeq' v,  q . v > 0                                                      [q: live loads; Ferris, Tin-Loi 2001]
 *
 *     upper          a verified state exists there: the scene may slide at that multiple. Without one the associative value,
 *                    called so. Nothing is said between it and the associative value, where states may exist or not
 *     lower          no such state in [0, lower), proved for the whole interval: pressure alone carries lower, or friction in
 *                    proportion to it along a tree of joints. 0 where nothing is proved
 *     lower_strong   strong on all of [0, it] (whatever friction does): such forces carry 0, too. The number for safety
 */
#define SP_SLIDING_STARTS 32            /* histories, at most */

typedef enum sp_sliding_kind {
    SP_SLIDING_NONE = 0,        /* no state was found: upper is the associative value; -1: it has none */
    SP_SLIDING_STATE            /* (f, v) is a state at upper */
} sp_sliding_kind;

typedef enum sp_sliding_reason {
    SP_SLIDING_FOUND = 0,
    SP_SLIDING_NOTHING_FOUND,   /* histories came to no state: there may be none */
    SP_SLIDING_NOT_ASKED        /* not planar, a joint with strength, or more than 400 free blocks */
} sp_sliding_reason;

typedef struct sp_sliding_settings {
    int32_t starts;             /* histories, joints more or less stiff: 0 .. SP_SLIDING_STARTS                           8 */
    int32_t work;               /* 0 .. 1000: so many times the flops of the limit may be spent, at least 1e7            90 */
    uint32_t seed;              /* of the first history, whose joints are alike; others have the next ones                1 */
} sp_sliding_settings;
static inline sp_sliding_settings sp_sliding_settings_default(void)
{
    const sp_sliding_settings s = { 8, 90, 1 };
    return s;
}

/* Where one history ends. */
typedef struct sp_sliding_end {
    uint32_t seed;
    sp_real steady;             /* multiple at which its forces stay as they are; -1: it did not come to that */
    sp_real least;              /* of the states that it leads to; -1: to none */
} sp_sliding_end;

typedef struct sp_sliding_result {
    sp_sliding_kind kind;
    sp_sliding_reason reason;
    sp_real upper, associative; /* associative: upper of the limit; -1: none */
    sp_real lower, lower_strong;
    sp_real residual;           /* of a STATE: largest violation of its conditions, relative, <= tol                     [1] */
    sp_real share;              /* of a STATE: q . v / sum |q_i| |v_i|, >= 1e-3                                          [1] */
    sp_real tol;                /* in force */
    int32_t ends;               /* histories */
    sp_sliding_end *end;        /* ends */
    sp_real *f, *v;             /* 3 x scene.count.points [N], 6 x scene.count.blocks [m, 1]: the state; else 0 */
    sp_real *pressed, *resting; /* 3 x scene.count.points: forces that prove it, at lower and at 0; else 0             [N] */
    sp_cost cost;
    size_t peak_bytes;          /* of the arena */
} sp_sliding_result;

/* Histories of a planar scene: live loads are pushed on, step by step, joints being a little soft, until forces stay; what is
 * found is made exact and led to lower multiples by linear programs in forces and in the motion, and judged.
 *   settings  NULL: the default ones; read are tol, force_bound, budget; faces must be 0. Where the budget ends nothing new
 *             begins; a step or a linear program under way is finished, so that more may be spent
 *   how       NULL: the default
 *   limit     of sp_limit for the same scene; read are kind, upper, cost
 *   result    its arrays live in the arena, of which it takes what sp_memory tells for SP_FOR_SLIDING
 *   returns   SP_OK (whatever the kind), SP_E_RANGE (how), SP_E_NOT_FINITE (limit), SP_E_UNSUPPORTED (faces),
 *             else as sp_limit */
SP_API sp_status sp_sliding(const sp_scene *scene, const sp_settings *settings, const sp_sliding_settings *how,
                            const sp_limit_result *limit, sp_arena *arena, sp_sliding_result *result);

typedef struct sp_sliding_evidence {
    int32_t state;              /* 1: (f, v) is a sliding state at upper */
    sp_real residual, share;    /* its */
    sp_real lower, lower_strong;        /* as far as pressed and resting prove them; 0: not */
} sp_sliding_evidence;

/* What upper, f, v, lower, pressed, lower_strong and resting of a claim prove, recomputed from the scene by the certificate
 * check; nothing else of it is read.
 *   scratch: sp_memory, SP_FOR_SLIDING_VERIFY; overwritten      returns as sp_limit_verify, SP_E_UNSUPPORTED (faces) */
SP_API sp_status sp_sliding_verify(const sp_scene *scene, const sp_settings *settings, const sp_sliding_result *claim,
                                   sp_arena scratch, sp_sliding_evidence *evidence);
#endif

/* What a joint does in a motion. Friction is associative: what slides opens by mu times its slip at most, else it is open. */
typedef enum sp_joint_kind {
    SP_JOINT_RIGID = 0,         /* no corner moves */
    SP_JOINT_HINGE,             /* some corners stay in touch, others open */
    SP_JOINT_SLIDING,           /* all corners stay in touch, some slide */
    SP_JOINT_OPEN               /* all corners open */
} sp_joint_kind;

typedef struct sp_joint_motion {
    sp_joint_kind kind;
    sp_real opening, slip;      /* largest dn, |dt| of a corner                                                       [m] */
    sp_real a[3], b[3];         /* of a hinge or a sliding joint: the corners in touch that lie farthest apart        [m] */
} sp_joint_motion;

/* dq: 6 x scene.count.blocks, finite, the motion of a result.     returns SP_OK, SP_E_ARGUMENT, SP_E_INDEX */
SP_API sp_status sp_joint_moves(const sp_scene *scene, const sp_real *dq, int32_t joint, sp_joint_motion *motion);

static inline const char *sp_joint_text(sp_joint_kind kind) { return sp_text(SP_WORDS_JOINT, (int32_t)kind); }
#endif

#ifndef SP_EXACT_ONLY
/* --------------------------------------------------------------------------------------------------------- a build order
 *
 * Does it stand at every step, and what must be held meanwhile? The scene is the finished one; which of its blocks are there
 * is set step by step, the joints of the others count for nothing. After each step only islands that it touched are looked at
 * again, an island being free blocks that touch each other; all others keep their verdict and forces.
 *
 *     sp_memory(&scene, SP_FOR_SEQUENCE, NULL, scratch, &bytes);
 *     sp_sequence_open(&scene, NULL, &arena, &sequence);               the supports are there, nothing else
 *     for each stone k: sp_sequence_set(sequence, k, SP_PRESENT, &step);
 *         if (step.verdict != SP_STABLE) sp_sequence_hold(sequence, 0, &held);
 *
 * A step starts from the forces of the one before: where these, changed only in the stones below the one that came or beside
 * the one that went, balance every block, that decides. If not, the island is checked as sp_check would. Either way the verdict
 * is that of sp_check's certificate: sp_verify accepts the forces of all that is there, or the motion of the island that falls.
 */

typedef enum sp_presence {
    SP_ABSENT = 0,
    SP_PRESENT,
    SP_HELD                     /* there, and fixed in place as a support is: by a robot, a prop, centring */
} sp_presence;

/* A build order under way. Lives in an arena, refers to the scene, which must stay as it is. */
typedef struct sp_sequence sp_sequence;

/* What is known after a step. */
typedef struct sp_step {
    sp_verdict verdict;         /* of all that is there: that of its worst island */
    sp_reason reason;           /* of that island */
    int32_t final;              /* no force of any size would do */
    int32_t block;              /* a free block of that island, of an UNSTABLE one that moves; -1: STABLE */
    int32_t islands, checked;   /* how many there are, and were looked at in this step */
    int32_t blocks, again;      /* free blocks that are there, and for how many forces or a motion were sought in this step,
                                   one counted in every try it was part of */
    int32_t local;              /* of the islands looked at so many needed a few of their blocks only */
    sp_real imbalance;          /* largest relative imbalance of a block, or more                                       [1] */
    sp_real least_imbalance;    /* of an UNSTABLE: proved for that island                                               [1] */
    const sp_real *f;           /* 3 x scene.count.points: forces, 0 where a block is absent; until the next call       [N] */
    const sp_real *dq;          /* 6 x scene.count.blocks: how islands that fall move, each as sp_result.dq; 0: at rest */
    sp_cost cost;               /* of this step */
} sp_step;

/* Begin: of the blocks only supports (SP_FIXED) are there.
 *   settings  NULL: the default ones. Of the stages all but SP_STAGE_ADMM and SP_STAGE_CUSTOM; statics only; localise is
 *             taken as 0; budget is that of each try at an island, of which a step makes three at most
 *   returns   SP_OK, SP_E_ARGUMENT, SP_E_EMPTY, SP_E_RANGE (settings), SP_E_UNSUPPORTED (those stages, coupled),
 *             SP_E_NOT_FINITE (loads overflow), SP_E_MEMORY: arena too small. On failure arena and *sequence are untouched */
SP_API sp_status sp_sequence_open(const sp_scene *scene, const sp_settings *settings, sp_arena *arena, sp_sequence **sequence);

/* One block (its number in the scene) comes, goes, is held or let go; a support is there or absent. What it touched is looked
 * at again. step: its f and dq are the sequence's, until the next call.
 *   returns   SP_OK (whatever the verdict), SP_E_ARGUMENT (null pointers, presence), SP_E_INDEX */
SP_API sp_status sp_sequence_set(sp_sequence *sequence, int32_t block, sp_presence presence, sp_step *step);

/* All blocks at once, presence[scene.count.blocks]: a later start, or the finished scene that is to be taken down.
 *   returns   SP_OK (whatever the verdict), SP_E_ARGUMENT (null pointers, a presence) */
SP_API sp_status sp_sequence_fill(sp_sequence *sequence, const sp_presence *presence, sp_step *step);

typedef enum sp_held_proof {
    SP_HELD_MINIMAL = 0,        /* no smaller set makes it stand */
    SP_HELD_IRREDUCIBLE,        /* none of them can be let go, others might do with fewer */
    SP_HELD_ENOUGH              /* it stands so; the budget ended the search, or a smaller set was undecided */
} sp_held_proof;

/* Blocks to be held besides those that are, so that what is there stands. */
typedef struct sp_held {
    int32_t count;              /* >= 0; 0: nothing need be held */
    const int32_t *block;       /* count: their numbers, ascending within an island; until the next call */
    const int32_t *must;        /* count: 1: it falls even when all others of its island are held */
    sp_held_proof proof;
    int32_t checks;             /* sets that were tried */
    sp_cost cost;
} sp_held;

#define SP_HELD_EXHAUSTIVE 8    /* islands of up to so many free blocks: every set is tried, the smallest ones first */

/* The smallest set of blocks to hold now. Per island that does not stand: which must be held at any rate is found block by
 * block; then all sets up to SP_HELD_EXHAUSTIVE blocks; beyond, those held in the last answer, then block after block that
 * moves most in the collapse, then each is let go again if it can be; two are proved by trying each block alone.
 *   budget    flops after which the best set so far is taken; 0: none
 *   returns   SP_OK, SP_E_ARGUMENT (null pointers, budget < 0) */
SP_API sp_status sp_sequence_hold(sp_sequence *sequence, int64_t budget, sp_held *held);

typedef struct sp_suggestion {
    int32_t block;              /* its number; -1: none keeps everything standing, or the budget ended first */
    int32_t tried;              /* stones looked at */
    int32_t all;                /* 1: the budget sufficed */
    sp_cost cost;
} sp_suggestion;

/* A next stone after which everything stands. add 1: the lowest absent block that does, no support, of those that touch
 * something that is there; 0: the highest block that may be taken away (supports and held ones stay). Nothing is changed.
 *   budget    flops after which no other stone is tried; 0: none
 *   returns   SP_OK, SP_E_ARGUMENT (null pointers, budget < 0) */
SP_API sp_status sp_sequence_suggest(sp_sequence *sequence, int32_t add, int64_t budget, sp_suggestion *suggestion);

static inline const char *sp_presence_text(sp_presence presence) { return sp_text(SP_WORDS_PRESENCE, (int32_t)presence); }
static inline const char *sp_held_proof_text(sp_held_proof proof) { return sp_text(SP_WORDS_HELD_PROOF, (int32_t)proof); }
#endif

/* -------------------------------------------------------------------------------- is there a motion, too: the coupled check */

/* The coupled check (coupled rigid-block analysis).                                              [Kao et al. 2022; departure 3]
 *
 * Friction alone lets forces squeeze a block that nothing presses. The coupled check asks besides for a virtual motion dq of
 * the blocks that explains the forces: joints give by eps, press only where they gave it all, and rub only against their slip.
 *
 *     dd = Aeq' dq       dn >= -eps       fn (dn + eps) = 0       ft = -alpha dt,  alpha >= 0        dn <= eta,  |dt| <= eta
 *
 * Only eta / eps matters: p . dq = eps sum fn + sum alpha |dt|^2, so it bounds the forces. eps = 0: dn >= 0, fn dn = 0, and
 * lengths are counted in eta instead of eps.
 *
 * sp_verify calls a triple (f, dq, alpha) coupled if f passes as a force state (imbalance <= tol) and, in every contact vertex,
 * with L = eps (eta where eps = 0), the residual is <= 1, the largest of
 *     |dn + eps| / g  where fn > 0, (-eps - dn) / g, (dn - eta) / g, (|dt| - eta) / g      g = 1e-10 L + 16 u |motion|
 *     where |ft| > tol min(sbar_A, sbar_B):   |ft + alpha dt| / (1e-6 |ft|) and (1e-6 L + 4e6 u |motion|) / |dt|
 * |motion|: how far the two blocks move there (a block whose contacts lie on one line without its spin about it, which
 * moves none of them, up to SP_EXACT_POINTS contact vertices). In words: forces vanish exactly where a joint is open; a
 * joint that presses may be out by a 10^-10th of eps; where there is friction there is slip, of at least a millionth of
 * eps, opposite to it within a millionth. The set of such triples is not closed: what is feasible only as alpha grows
 * without bound is not found (limit).
 * In float: 1e-4 instead of 1e-10, both 1e-6 are 1e-2, 4e6 u is 400 u. */

/* ----------------------------------------------------------------------------------------------- what will a check simulate */

#ifndef SP_NO_PLAN
typedef struct sp_planned {
    sp_effect_why why;          /* is it simulated, and why */
    int64_t unknowns, flops, bytes;     /* what leaving it out is predicted to save; flops: a guess of the steps a search takes,
                                           for what stands within a factor of 5, for what falls often less than it takes; bytes:
                                           exact, below 0 where the tables of small islands take more than they spare */
} sp_planned;

/* What a check is predicted to do. Unknowns: 6 rows a free block, 3 forces a contact vertex. */
typedef struct sp_outlook {
    sp_planned effect[SP_EFFECTS];
    int32_t islands;            /* how many, as sp_islands.count */
    int64_t unknowns, flops, full_unknowns, full_flops;         /* as planned, and with all effects the scene has */
    size_t bytes, full_bytes;                                   /* of the arena; full: all blocks together */
} sp_outlook;

/* What will sp_check simulate, what not, and why? settings NULL: the default ones. scratch: sp_memory, SP_FOR_PLAN.
 *   returns what sp_check returns */
SP_API sp_status sp_plan(const sp_scene *scene, const sp_settings *settings, sp_arena scratch, sp_outlook *out);
#endif

/* -------------------------------------------------------------------------------------------------------- placing a stone
 *
 * Cheap looks at one stone before any statics: where a planner throws away most of its candidates.           [seed 6.1, 6.2]
 * They know the stone and what is under it, no friction and no neighbours: a choice among seats, not a verdict.
 */

/* The convex hull of a stone's contact points in plan (along gravity), and its centre of mass over it. */
typedef struct sp_support {
    sp_real clearance;          /* distance of the centre of mass from the nearest hull edge, positive inside; exactly -1, with
                                   area 0 and offset 1e9, where the points span no area                              [m] */
    sp_real area;               /* of the hull                                                                     [m^2] */
    sp_real offset;             /* of the centre of mass from the hull's centroid                                    [m] */
} sp_support;

/* Bytes of scratch for `points` contact points, exact; 0 if points < 0 or the size overflows. */
SP_API size_t sp_support_memory(int32_t points);

/* clr(c) = min over hull edges of n_in . (c - a).                                                               [seed 6.1]
 *   in   xyz, points   3 x points contact points, in any order, repeats allowed; points >= 0                        [m]
 *   in   com           centre of mass of the stone [m];   gravity: any length > 0;   scratch: sp_support_memory(points)
 *   returns SP_OK, SP_E_ARGUMENT, SP_E_NOT_FINITE (also a size whose square overflows), SP_E_RANGE (gravity), SP_E_MEMORY */
SP_API sp_status sp_support_clearance(const sp_real *xyz, int32_t points, const sp_real com[3], const sp_real gravity[3],
                                      sp_arena scratch, sp_support *support);

/* A place a stone could take. What the caller measures in its own map: */
typedef struct sp_seat {
    sp_support support;
    sp_real footprint;          /* area of the stone in plan, > 0                                                  [m^2] */
    sp_real height;             /* h of the stone, > 0                                                               [m] */
    sp_real width;              /* mean width of the stones at hand, > 0                                             [m] */
    sp_real trapped;            /* volume enclosed under the stone, >= 0                                           [m^3] */
    sp_real seat;               /* height of the seat above any one level, any sign                                  [m] */
} sp_seat;

/* Weights of the four terms, >= 0: small support, centre of mass off its middle, void underneath, high seat. */
typedef struct sp_seat_weights { sp_real area, offset, trapped, seat; } sp_seat_weights;
SP_API sp_seat_weights sp_seat_weights_default(void);   /* 1, 1, 1, 0.5 */

/* J = w1 (1 - A_hull / A_foot) + w3 |c - g_hull| / W + wu V_under / (A_foot h) + ws z_seat / W; less is better.  [seed 6.1]
 *   weights NULL: the default ones; J: one number [1].     returns SP_OK, SP_E_ARGUMENT, SP_E_NOT_FINITE, SP_E_RANGE */
SP_API sp_status sp_support_cost(const sp_seat *seat, const sp_seat_weights *weights, sp_real *J);

/* Order seats: those with clearance >= margin [m] first, then by J, ties by number.
 *   out  J, order      count each; order[0] is the best seat
 *   out  stable        how many have the margin; may be NULL
 *   returns SP_OK, SP_E_ARGUMENT, SP_E_NOT_FINITE, SP_E_RANGE (J and order are scratch then) */
SP_API sp_status sp_support_rank(const sp_seat *seats, int32_t count, sp_real margin, const sp_seat_weights *weights,
                                 sp_real *J, int32_t *order, int32_t *stable);

/* A face a stone can rest on: a plane with the stone on one side and the centroid over the hull of what touches it. */
typedef struct sp_rest {
    int32_t face;               /* the first face of the mesh in that plane */
    sp_real normal[3];          /* outward: along gravity when the stone rests on it */
    sp_real height;             /* of the centroid over the plane [m] */
    sp_support support;         /* clearance > 0 */
} sp_rest;

/* Stable resting faces of a stone of uniform density, in the order of its faces.                [Goldberg, Mirtich 1999]
 * All of them for a convex stone; of another one those in whose plane a face lies (feet in one plane count together). A plane
 * is recognised to 1e-6 of the diameter (float 2e-6); a face warped by more is none.
 *   scratch  sp_support_memory(mesh->vertices)
 *   out  rest, count   the first `capacity` >= 0 of them (rest may be NULL for 0); how many there are: SP_E_CAPACITY if more
 *   returns SP_OK, SP_E_CAPACITY, what sp_mesh_mass returns, SP_E_MEMORY */
SP_API sp_status sp_rest_faces(const sp_mesh *mesh, sp_arena scratch, sp_rest *rest, int32_t capacity, int32_t *count);

/* A stone laid down, as the next-best-object gate asks for it. */
typedef struct sp_laid {
    const sp_real *xyz;         /* 3 x points: the corners it rests on, in place [m] */
    int32_t points;             /* >= 0 */
    sp_real com[3];             /* centre of mass, in place [m] */
    sp_real normal[3];          /* of the resting face, outward (downward when level), any length > 0 */
    sp_real depth, height;      /* extents of the laid stone into the wall and along gravity, >= 0 [m] */
} sp_laid;

typedef enum sp_nbo {
    SP_NBO_ACCEPTED = 0,
    SP_NBO_OUTSIDE,             /* the centre of mass is not over the support */
    SP_NBO_SHALLOW,             /* depth / height too small: it lies along the wall instead of into it */
    SP_NBO_TILTED,              /* the resting face is not level enough */
    SP_NBO_MARGIN               /* too near the edge of the support */
} sp_nbo;

typedef struct sp_nbo_settings {
    sp_real margin;             /* least clearance / sqrt(area of the support)                                          0 */
    sp_real slender;            /* least depth / height                                                               0.5 */
    sp_real level;              /* least cosine between the resting face's normal and gravity, 0.7: 45 degrees        0.7 */
} sp_nbo_settings;
SP_API sp_nbo_settings sp_nbo_settings_default(void);

/* Accept or reject a laid stone; the reason is the first of the enumerators' order that applies.                [seed 6.2]
 *   settings NULL: the default ones;  scratch: sp_support_memory(laid->points)
 *   out  margin        clearance / sqrt(area), signed; -1 where the points span no area; may be NULL
 *   returns as sp_support_clearance; SP_E_RANGE: also extents < 0, a normal without length */
SP_API sp_status sp_nbo_gate(const sp_laid *laid, const sp_real gravity[3], const sp_nbo_settings *settings, sp_arena scratch,
                             sp_nbo *reason, sp_real *margin);

static inline const char *sp_nbo_text(sp_nbo reason) { return sp_text(SP_WORDS_NBO, (int32_t)reason); }

/* ----------------------------------------------------------------------------------------------- for experts: static arrays */

/* The same as constant expressions, for static arrays. They are of 64 bits, whatever size_t has, and do not wrap for
 * counts up to 2^23, alone or in sums: an array too large for the machine does not compile.
 *
 *   SP_SCENE_BYTES    sp_scene_memory of a capacity of these numbers, exact
 *   SP_MEMORY_BYTES   an upper bound on sp_memory for up to so many blocks (supports too), joints and contact vertices,
 *                     whatever touches what, with the true cone and the stages of the mask: 1 << SP_STAGE_EXACT | ..., 0
 *                     for the default ones; each load takes 4 more. The factor is taken as full, 36
 *                     numbers for each two blocks: near the truth up to some thirty blocks. For SP_STAGE_CUSTOM, whose
 *                     need it cannot know, it is SP_NEVER_FITS, larger than any.
 *   SP_PYRAMID_BYTES  what settings.faces takes besides
 *   SP_STRENGTH_BYTES what joints with cohesion, tension or crushing take besides, where settings.faces is 0
 *   SP_COUPLED_BYTES  what settings.coupled.asked takes besides, with room for coupled.nodes (0 or more) in a proof; without
 *                     coupled.rounds
 *   SP_ADMM_BYTES     in SP_MEMORY_BYTES where the mask has SP_STAGE_ADMM, for a pyramid of up to 8 faces, the seed's own; of
 *                     more: SP_MEMORY_BYTES without that bit plus this. It takes the factor as full, too, which it never is:
 *                     some ten times the truth for a few stones, a hundred times for twenty
 *   SP_ADMM_CG_BYTES  to be added instead of that where the seed has ADMM use conjugate gradients, which keep no factor
 *                     (dense_cells 0, admm.backend SP_QP_CG): near the truth */
#define SP_NEVER_FITS ((uint64_t)1 << 63)
#define SP_SCENE_BYTES(blocks, vertices, faces, corners, joints, points, loads) \
    ((((uint64_t)(blocks) * sizeof(sp_block) + 15) & ~(uint64_t)15) \
     + (((uint64_t)(vertices) * 3 * sizeof(sp_real) + 15) & ~(uint64_t)15) \
     + (((uint64_t)(faces) * sizeof(sp_face) + 15) & ~(uint64_t)15) + (((uint64_t)(corners) * 4 + 15) & ~(uint64_t)15) \
     + (((uint64_t)(joints) * sizeof(sp_joint) + 15) & ~(uint64_t)15) \
     + (((uint64_t)(points) * 3 * sizeof(sp_real) + 15) & ~(uint64_t)15) + (uint64_t)(loads) * sizeof(sp_load))
#ifdef SP_REAL_MIXED                                    /* the matrix beside its factor, and what refines */
#define SP_MIXED_BYTES(blocks, joints) (sizeof(sp_real) * (54 * (uint64_t)(blocks) + 36 * (uint64_t)(joints)) + 80)
#else
#define SP_MIXED_BYTES(blocks, joints) 0
#endif
/* The factor in 6 rows a block, or a quarter of it in 3 and what those know of joints and of mirror images: the larger. */
#define SP_SEARCH_BYTES(blocks, joints, vertices) \
    (SP_PAIRS_BYTES(blocks, 9) + (SP_PAIRS_BYTES(blocks, 27) > SP_MIRROR_BYTES(joints, vertices) \
                                  ? SP_PAIRS_BYTES(blocks, 27) : SP_MIRROR_BYTES(joints, vertices)))
#define SP_PAIRS_BYTES(blocks, each) (sizeof(sp_real) * (each) * ((uint64_t)(blocks) + 1) * ((uint64_t)(blocks) + 1) / 2)
#define SP_MIRROR_BYTES(joints, vertices) (20 * sizeof(sp_real) * (uint64_t)(joints) + 4 * (uint64_t)(vertices))
#define SP_MEMORY_BYTES(blocks, joints, vertices, stages) \
    ((stages) & ~126 ? SP_NEVER_FITS \
     : ((stages) & 1 << SP_STAGE_ADMM ? SP_ADMM_BYTES(blocks, vertices, 8) : 0) \
     + sizeof(sp_real) * (15 * (uint64_t)(vertices) + 85 * ((uint64_t)(blocks) + 1) + 102 \
                          + ((stages) & 1 << SP_STAGE_DENSE ? (18 * (uint64_t)(blocks) + 21) * ((uint64_t)(blocks) + 1) : 0)) \
     + SP_MIXED_BYTES(blocks, joints) + SP_SEARCH_BYTES(blocks, joints, vertices) \
     + 4 * (((uint64_t)(blocks) + 1) * ((uint64_t)(blocks) + 30) / 2 + 5 * (uint64_t)(joints) + 3) \
     + (sizeof(sp_demand) + sizeof(sp_contact)) * (uint64_t)(joints) + sizeof(sp_island) * ((uint64_t)(blocks) + 1) \
     + 2 * (sizeof(sp_settings) + sizeof(sp_problem) + sizeof(sp_state) + sizeof(sp_result)) + 1776)
#define SP_PYRAMID_BYTES(vertices, faces) (sizeof(sp_real) * (uint64_t)(faces) * ((uint64_t)(vertices) + 4) + 64)
#define SP_STRENGTH_BYTES(blocks, vertices) \
    (sizeof(sp_real) * (10 * (uint64_t)(vertices) + 6 * (uint64_t)(blocks) + 68) + 64)
#define SP_COUPLED_BYTES(blocks, vertices, nodes) \
    (sizeof(sp_real) * (32 * (uint64_t)(vertices) + 79 * (uint64_t)(blocks)) + 1000 \
     + ((nodes) ? SP_PROOF_BYTES(SP_EXACT_MOST(blocks), SP_EXACT_MOST(vertices), nodes) : 0))
#define SP_EXACT_MOST(count) ((uint64_t)(count) < SP_EXACT_POINTS ? (uint64_t)(count) : (uint64_t)SP_EXACT_POINTS)
#define SP_PROOF_BYTES(b, v, nodes) \
    ((sizeof(sp_real) + 2) * (20 * (uint64_t)(nodes) + 3 * (v) + 6 * (b) + 1) \
     + (sizeof(sp_real) + 4) * (229 * (v) + 48 * (b) + 3) \
     + sizeof(sp_real) * ((3 * (v) + 6 * (b)) * (3 * (v) + 6 * (b)) + 38 * (v) + 2 * (b)) \
     + 4 * (uint64_t)(nodes) + 400 * (v) + 1000)
#define SP_ADMM_BYTES(blocks, vertices, faces) \
    (SP_ADMM_CG_BYTES(blocks, vertices, faces) \
     + SP_FACTOR_BYTES(6 * (uint64_t)(blocks) + ((uint64_t)(faces) + 6) * (uint64_t)(vertices), \
                       (4 * (uint64_t)(faces) + 50) * (uint64_t)(vertices)))
#define SP_FACTOR_BYTES(n, entries) ((sizeof(sp_real) + 4) * ((n) * (n) / 2 + (entries)) + 80 * (n))
#define SP_ADMM_CG_BYTES(blocks, vertices, faces) \
    ((sizeof(sp_real) + 4) * (4 * (uint64_t)(faces) + 50) * (uint64_t)(vertices) + sizeof(sp_real) * (uint64_t)(blocks) + 2200 \
     + (15 * sizeof(sp_real) + 9) * (6 * (uint64_t)(blocks) + ((uint64_t)(faces) + 6) * (uint64_t)(vertices)))

/* Near the truth, where it is known what touches what: within 1.3 for walls, arches and piles of 8 to 60 stones with the
 * default settings, joints without strength. blocks: supports too; vertices: those of contacts, of meshes in SP_CONTACTS_BYTES.
 * SP_SMALL has SP_MEMORY_BYTES alone; SP_NO_IPM and SP_REAL_MIXED take less than these tell.
 *
 *   fill                blocks of the factor below its diagonal, at most:
 *   SP_FILL_ANY         whatever touches what: a proof; then they are no nearer than SP_MEMORY_BYTES
 *   SP_FILL_WALL        of walls and vaults in courses, of width stones along or upwards, whichever are fewer. Measured, not
 *                       proved: tests hold it for shapes of 8 to 60 stones. Width 1: an arch, a tower, whatever has no closed
 *                       ring of free blocks: proved
 *   SP_FILL_PILE        of stones heaped in layers, each on up to four; likewise
 *   SP_CHECK_BYTES      sp_memory for SP_FOR_CHECK, where all free blocks hang together (an island); apart: SP_APART_BYTES more
 *   SP_LIMIT_BYTES      for SP_FOR_LIMIT
 *   SP_SEQUENCE_BYTES   for SP_FOR_SEQUENCE
 *   SP_CONTACTS_BYTES   for SP_FOR_CONTACTS: corners of all blocks' faces, and of the block that has most; of an open support
 *                       twice
 *
 * A check that lacks memory is SP_E_MEMORY and never wrong. */
#define SP_FILL_ANY(blocks) ((uint64_t)(blocks) * ((blocks) > 0 ? (uint64_t)(blocks) - 1 : 0) / 2)
#define SP_FILL_WALL(blocks, joints, width) \
    ((width) <= 1 ? (uint64_t)(blocks) : (7 * (uint64_t)(joints) + 6 * (uint64_t)(blocks) * (uint64_t)(width)) / 10 + 1)
#define SP_FILL_PILE(blocks, joints) \
    (5 * (uint64_t)(joints) / 4 + 1 \
     + (23 * (uint64_t)(joints) > 19 * (uint64_t)(blocks) \
        ? (uint64_t)(blocks) * (23 * (uint64_t)(joints) - 19 * (uint64_t)(blocks)) / 1000 : 0))
#ifdef SP_SMALL
#define SP_NEAR_BYTES(bytes) SP_NEVER_FITS
#else
#define SP_NEAR_BYTES(bytes) (bytes)
#endif
/* 36 numbers a block of the factor, or 9 in 3 rows and what those know of joints and of mirror images: the larger. */
#define SP_BELOW_BYTES(fill, joints, vertices) \
    ((9 * sizeof(sp_real) + 4) * (uint64_t)(fill) + 64 \
     + (27 * sizeof(sp_real) * (uint64_t)(fill) > SP_MIRROR_BYTES(joints, vertices) \
        ? 27 * sizeof(sp_real) * (uint64_t)(fill) : SP_MIRROR_BYTES(joints, vertices)))
#define SP_FRAME_BYTES \
    (2 * (sizeof(sp_settings) + sizeof(sp_problem) + sizeof(sp_state) + sizeof(sp_result)) + 102 * sizeof(sp_real))
#define SP_CHECK_BYTES(blocks, joints, vertices, fill) \
    SP_NEAR_BYTES((92 * sizeof(sp_real) + 24) * (uint64_t)(blocks) \
                  + (sizeof(sp_demand) + sizeof(sp_contact) + 12) * (uint64_t)(joints) \
                  + 9 * sizeof(sp_real) * (uint64_t)(vertices) + SP_BELOW_BYTES(fill, joints, vertices) \
                  + SP_MIXED_BYTES(blocks, joints) + SP_FRAME_BYTES)
#define SP_APART_BYTES(blocks, vertices) \
    SP_NEAR_BYTES(6 * sizeof(sp_real) * ((uint64_t)(vertices) + 2 * (uint64_t)(blocks)) + SP_FRAME_BYTES \
                  + (sizeof(sp_island) + 32) * ((uint64_t)(blocks) + 1))
#define SP_LIMIT_BYTES(blocks, joints, vertices, fill) \
    SP_NEAR_BYTES((216 * sizeof(sp_real) + 36) * (uint64_t)(blocks) + (sizeof(sp_contact) + 12) * (uint64_t)(joints) \
                  + 21 * sizeof(sp_real) * (uint64_t)(vertices) + SP_BELOW_BYTES(fill, joints, vertices) \
                  + SP_MIXED_BYTES(blocks, joints) + SP_FRAME_BYTES + 62 * sizeof(sp_real) + 690)
#define SP_SEQUENCE_BYTES(blocks, joints, vertices, fill) \
    SP_NEAR_BYTES((120 * sizeof(sp_real) + 128) * (uint64_t)(blocks) + (14 * sizeof(sp_real) + 88) * (uint64_t)(joints) \
                  + 21 * sizeof(sp_real) * (uint64_t)(vertices) + SP_BELOW_BYTES(fill, joints, vertices) \
                  + SP_MIXED_BYTES(blocks, joints) + SP_FRAME_BYTES + 100 * sizeof(sp_real) + 1110)
#define SP_CROSSINGS(most) ((uint64_t)(most) < 32 ? (uint64_t)(most) * (uint64_t)(most) / 4 : 8 * (uint64_t)(most))
#define SP_TREE_WIDTH(n) ((n) <= 8 ? 8 : (n) <= 16 ? 16 : (n) <= 32 ? 32 : (n) <= 64 ? 64 : 2 * (uint64_t)(n))
#define SP_CONTACTS_BYTES(blocks, vertices, faces, corners, most) \
    SP_NEAR_BYTES((10 * sizeof(sp_real) + 28) * (uint64_t)(blocks) + (12 * sizeof(sp_real) + 8) * (uint64_t)(faces) \
                  + 8 * (uint64_t)(corners) + 4 * (uint64_t)(vertices) + 12 * sizeof(sp_real) * SP_TREE_WIDTH(blocks) \
                  + (39 * sizeof(sp_real) + 206) * (uint64_t)(most) + (23 * sizeof(sp_real) + 121) * SP_CROSSINGS(most) \
                  + 560 * sizeof(sp_real) + 3300)

/* ------------------------------------------------------------------------------ for experts: proofs that there is no triple */

/* A proof that no triple meets the conditions of the coupled check. Every contact vertex that takes part, 0..V-1 in the order
 * of joints, is in one of these cases, of which finer ones halve the sector of coarser ones (angles from t1 to t2):
 *
 *     0 unknown;  1 open, f = 0;  2 engaged, dn = -eps;  4..7 engaged, dt and -ft in that quarter;  2s, 2s + 1 the halves of s
 *
 * node[] is a tree in preorder, its root has all unknown: k >= 0 splits vertex k (0 into 1, 2; 2 into 4, 5, 6, 7; s into 2s,
 * 2s + 1), k < 0 is a leaf that takes the next -k of row[] and y[]: multipliers of inequalities of its case, numbered
 *
 *     0..6b-1     Aeq f + p = 0                                  6b              eps sum fn <= p . dq
 *     6b+1+24v+   0 dn;  1..4 dt along 0, 45, 90, 135 degrees;  5 along the sector's middle m;
 *                 6, 7 a x dt >= 0, b x dt <= 0 at its ends;  8, 9 a x ft <= s fn, b x ft >= -s fn,
 *                 s = 1e-6 of the most |ft| / fn (float 1e-2);
 *                 10..12 ft along -a, -m, -b (pyramids of more than 8 faces: on the three nearest there);
 *                 13..20 ft around (pyramids of up to 8 faces: on those; else every 45 degrees);  21..23 fn, ft1, ft2
 *
 * in units: forces in the largest component of a load, dq and dd in L. Their sum is an inequality that no f and dq meet; a
 * multiplier of 0 adds nothing to it, of whatever row. */

/* ---------------------------------------------------------------------------------------------------- for experts: matrices */

/* One contact of the compiled problem. */
typedef struct sp_contact {
    int32_t a, b;               /* rows of the free blocks, -1: a support */
    int32_t point, points;      /* its part of problem.point and problem.local; of scene.point it is joint->point */
    int32_t id;                 /* joint of the scene */
    const sp_joint *joint;      /* that joint: frame and strength */
    sp_real ra[3], rb[3];       /* origin of the contact (mean of its vertices) seen from the two centroids [m] */
} sp_contact;

/* A scene made ready: supports dropped, everything relative to centroids. Lives in an arena, refers to the scene. */
typedef struct sp_problem {
    const sp_scene *scene;
    int32_t blocks, contacts, points;   /* free blocks b, contacts that touch one, contact vertices v: all those of the scene */
    int32_t *block;                     /* b: their numbers in the scene */
    sp_contact *contact;
    sp_real (*point)[3];                /* v x 3: vertices, those of the scene [m] */
    sp_real (*local)[3];                /* v x 3: vertex in the contact's frame, (n, t1, t2) from its origin [m] */
    sp_real *p;                         /* 6b: force and moment about the centroid on each free block: weight, loads and
                                           scene.live times the live ones [N, N m] */
    sp_real *live;                      /* 6b: the live ones once; NULL where there are none */
    int32_t keep_order;                 /* 1: blocks are eliminated in the order they stand in, 0: in that of least fill */
    int32_t ignore_strength;            /* 1: of strength only what loads without end leave: friction; nothing
                                           of a joint that may crush */
} sp_problem;

/* Make a problem of a scene, which must stay as it is; its arrays live in the arena, sp_memory, SP_FOR_PROBLEM.
 *   returns SP_OK, SP_E_ARGUMENT, SP_E_EMPTY, SP_E_NOT_FINITE, SP_E_MEMORY */
SP_API sp_status sp_problem_build(const sp_scene *scene, sp_arena *arena, sp_problem *problem);

/* A sparse matrix by count entries (i, j, x), in any order, and by columns: p[cols + 1], row numbers ascending. In an arena. */
typedef struct sp_triplets { int32_t rows, cols, count; int32_t *i, *j; sp_real *x; } sp_triplets;
typedef struct sp_csc { int32_t rows, cols; int32_t *p, *i; sp_real *x; } sp_csc;

/* Aeq, 6b x (columns v): Aeq f + p = 0.                                                               [seed 1.1, 1.2]
 *   columns   3: fn ft1 ft2;  4: fp fm ft1 ft2 with fn = fp - fm
 *   returns   SP_OK, SP_E_ARGUMENT, SP_E_RANGE (columns), SP_E_MEMORY */
SP_API sp_status sp_matrix_aeq(const sp_problem *problem, int32_t columns, sp_arena *arena, sp_triplets *out);

/* Afr, (K v) x (columns v): Afr f <= 0, row k of a vertex cos(2 pi k/K) ft1 + sin(2 pi k/K) ft2 - mu_eff fn.   [seed 1.4]
 *   settings  faces K = 3..64, inscribed; penalty.net: the normal term of 4 columns is fp - fm instead of fp
 *   returns   SP_OK, SP_E_ARGUMENT, SP_E_RANGE, SP_E_MEMORY, SP_E_UNSUPPORTED (strength of a joint) */
SP_API sp_status sp_matrix_afr(const sp_problem *problem, const sp_settings *settings, int32_t columns, sp_arena *arena,
                               sp_triplets *out);

/* Columns of a matrix given by entries; entries at the same place are added in their order.
 *   returns SP_OK, SP_E_ARGUMENT (also a count < 0), SP_E_INDEX, SP_E_MEMORY */
SP_API sp_status sp_csc_from(const sp_triplets *t, sp_arena *arena, sp_csc *out);

/* ------------------------------------------------------------------------------------------------------ for experts: stages */

/* What stages hand to each other: the best force state and potential so far. */
typedef struct sp_state {
    sp_real *f;                 /* 3 x points: in and out, admissible when a stage leaves it */
    sp_real *y;                 /* 6 x blocks: in and out, f = P_K(Aeq' y) where the stage works that way */
    sp_real *y0;                /* 12 x blocks: potential of the bilateral force in two parts, large and small, of 6 x blocks
                                   each; written by the first stage that knows it */
    sp_real *dq;                /* 6 x blocks: candidate mechanism */
    int16_t has_y0;
    int16_t brief;              /* 1: the caller has other questions: give up where the likeliest way comes to nothing;
                                   2, of float: the search in the plane came to a motion that falls within tol;
                                   3: only forces are wanted, of a motion no more than that there is one */
    sp_reason reason;           /* why, when a stage claims */
    sp_real tension_ratio;      /* max fm / max fp of the penalty form, -1 unless a stage solved it */
    sp_cost cost;               /* of the running stage */
    int64_t left;               /* flops it may spend; what judges it is already off */
} sp_state;

/* A stage: looks for forces or a motion. It only proposes; sp_check judges what it left in the state by sp_verify's code.
 *   run    may take memory from the arena (given back after it); sets *claim to SP_STABLE (judge f), SP_UNSTABLE (judge dq) or
 *          SP_UNDECIDED (f and dq are its best attempts; the next stage goes on)
 *          pieces of its own start at multiples of SP_ALIGN
 *   need   bytes run takes from an arena, exact; the symbolic step, if there is one, runs in `scratch`; SIZE_MAX: too small
 *   returns SP_OK or SP_E_MEMORY */
typedef struct sp_stage {
    sp_status (*run)(const sp_problem *problem, const sp_settings *settings, sp_state *state, sp_arena *arena,
                     sp_verdict *claim);
    size_t (*need)(const sp_problem *problem, const sp_settings *settings, sp_arena scratch);
} sp_stage;
#endif /* SP_QP_ONLY */

/* ----------------------------------------------------------------------------------------------------- quadratic programs
 *
 *     min 1/2 x'Px + q'x   subject to   l <= Ax <= u                              P positive semidefinite
 *
 * A solver on its own; it has never heard of a stone. SP_NO_QP leaves its calls out, SP_QP_NO_CG the matrix-free back end,
 * SP_QP_NO_POLISH the polish and the sharpening of certificates [Stellato et al. 2020, "OSQP"], SP_QP_NO_INTERIOR interior
 * points.                                                                                 [Schwan et al. 2023, "PIQP"]
 */
#define SP_QP_INFINITY ((sp_real)1e20)  /* l <= -1e20, u >= 1e20 (also IEEE infinities): no bound */

/* The problem, the caller's: nothing is copied, it must stay as it is until the solver is done. Matrices by columns: column j
 * is entries p[j] .. p[j+1]-1, row numbers i ascending without repeats, p[0] = 0.
 * P is given as its UPPER TRIANGLE with the diagonal: an entry below the diagonal is refused, not read. */
typedef struct sp_qp {
    int32_t n, m;               /* unknowns >= 1, rows >= 0 */
    const int32_t *Pp, *Pi;     /* n x n; all three NULL: P = 0, a linear program */
    const sp_real *Px;
    const sp_real *q;           /* n; NULL: 0 */
    const int32_t *Ap, *Ai;     /* m x n; may be NULL when m = 0 */
    const sp_real *Ax;
    const sp_real *l, *u;       /* m, l <= u; equal: an equation */
} sp_qp;

typedef enum sp_qp_backend {
    SP_QP_SPARSE = 0,           /* sparse LDL' of [P + sigma I, A'; A, -1/rho], least fill */
    SP_QP_DENSE,                /* dense Cholesky of P + sigma I + A' rho A: n (n+1) / 2 numbers */
    SP_QP_CG                    /* no matrix: conjugate gradients on the same; least memory, most time */
} sp_qp_backend;

typedef enum sp_qp_method {
    SP_QP_ADMM = 0,             /* ADMM, then the method of multipliers for the last digits */
    SP_QP_INTERIOR,             /* interior points; ADMM from the start where they give up, or with SP_QP_CG */
    SP_QP_AUTO                  /* likewise, but from a guess 100 iterations of ADMM first. SP_QP_NO_INTERIOR: ADMM */
} sp_qp_method;

typedef enum sp_qp_status {
    SP_QP_SOLVED = 0,           /* residuals within eps, and the objective (strict), on the data as given */
    SP_QP_INACCURATE,           /* stopped (iterations, budget), all within 10 eps */
    SP_QP_PRIMAL_INFEASIBLE,    /* y proves: no x with |x| < radius meets the constraints */
    SP_QP_DUAL_INFEASIBLE,      /* x is a direction that goes down for ever: unbounded if feasible, up to radius */
    SP_QP_ITERATIONS,           /* iteration limit; x, y are the last iterate */
    SP_QP_BUDGET,               /* work budget spent; likewise */
    SP_QP_NUMERICAL             /* numbers left the range of sp_real; x, y are the last that were finite */
} sp_qp_status;

/* Get them from sp_qp_default() and change what you must. */
typedef struct sp_qp_settings {
    sp_qp_backend backend;      /*                                                                                 sparse */
    sp_qp_method method;        /*                                                                                   auto */
    sp_real eps_abs, eps_rel;   /* >= 0, not both 0: residual <= eps_abs + eps_rel x its terms       1e-6 1e-5, float 1e-4 */
    sp_real eps_pinf, eps_dinf; /* certificates looser than this, > 0, are not looked at                             1e-4 */
    sp_real radius;             /* >= 1: a certificate must rule out solutions so many times the iterate  1e6, float 1e3 */
    int32_t strict;             /* also: the objective right to eps_abs + eps_rel |objective| (see gap), and residuals within
                                   eps in equilibrated units, so that small rows count as large ones                    1 */
    int32_t polish;             /* method of multipliers from the iterate for the last digits, and where ADMM takes long;
                                   about as much work as was done before. Interior points go on while a step
                                   halves the residuals, before that                             1 (0: SP_QP_NO_POLISH) */
    int32_t iterations;         /* at most, of all together, > 0; interior points take 200 at most                   8000 */
    int64_t budget;             /* most flops of a run, >= 0; one too small for an iteration judges the guess; 0: none 0 */
    int32_t check;              /* iterations between looks at the residuals, > 0                                      10 */
    int32_t passes;             /* of equilibration, >= 0                                                              10 */
    sp_real sigma, relax;       /* proximal weight, 0 < .. <= 1; over-relaxation, 0 < .. < 2  1e-6 (float 1e-3) and 1.6 */
    sp_real rho, rho_equal;     /* penalty, 1e-6 .. 1e6; its factor on equations, >= 1        0.1 and 1e3 (float 1e2) */
    int32_t adapt, adapt_most;  /* iterations between changes of rho, >= 0 (0: never); most changes            100 and 10 */
    sp_real adapt_factor;       /* > 1: rho is multiplied or divided by this when the residuals are more than 10 apart  5 */
    int32_t cg_steps;           /* of conjugate gradients per iteration, > 0                                          250 */
    sp_real cg_tol;             /* its relative residual, > 0                                       1e-10, float 1e-6 */
} sp_qp_settings;

typedef struct sp_qp_result {
    sp_qp_status status;
    const sp_real *x, *y;       /* n unknowns, m multipliers (y_i > 0 pushes down from u, < 0 up from l); in the arena. If
                                   primal infeasible y is the certificate, x 0; if dual infeasible x is, y 0; largest 1 */
    sp_real objective;          /* 1/2 x'Px + q'x */
    sp_real primal, dual;       /* residuals on the data as given: |Ax - z|, |Px + q + A'y| */
    sp_real gap;                /* how far off the objective is, at about the solution: the larger of |y|'|Ax - z| and
                                   |x'Px + q'x + u'y+ + l'y-| + |x|'|Px + q + A'y| */
    sp_real radius;             /* of a certificate: no solution with |x / D|_1 (or |x / D|_1 + |y / E|_1) below it */
    sp_real rho;                /* at the end: a good start for a similar problem */
    int32_t polished;           /* the result comes from the polish */
    int32_t iterations, factorisations;
    int64_t flops;
} sp_qp_result;

/* A solver that others plug in, or ours. Whoever uses one passes the struct on: there is no registry. Both functions are called
 * with arguments that sp_qp_solve would take (settings is never NULL).
 *   solve  as sp_qp_solve: x0, y0 may be NULL or left unread; x and y are taken from the arena (or live as long as it), every
 *          field of *result is written, no number of it is a NaN. Settings it has no counterpart of it ignores. result->status
 *          by what was reached, never by another library's number of it:
 *            SP_QP_SOLVED       residuals within eps_abs, eps_rel by that solver's own account; an answer it calls inaccurate
 *                               is SP_QP_INACCURATE, whatever stopped it
 *            ..._INFEASIBLE     it has a certificate, which is in y (primal) or x (dual); else SP_QP_NUMERICAL
 *            SP_QP_ITERATIONS   its limit of iterations; SP_QP_BUDGET: of work or time
 *            SP_QP_NUMERICAL    anything else: it broke down, refuses the problem, is interrupted
 *          returns SP_OK whatever result->status, SP_E_MEMORY (arena and result untouched, also where its own memory ran out),
 *          or another status sp_qp_solve returns
 *   need   as sp_qp_memory: bytes solve takes from an arena, exact; NULL where that is just x and y
 * Nobody takes a solver's word: stages judge what they are given. */
typedef struct sp_qp_solver {
    void *self;                 /* passed through, the caller's */
    sp_status (*solve)(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, const sp_real *x0,
                       const sp_real *y0, sp_qp_result *result);
    sp_status (*need)(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes);
} sp_qp_solver;

#ifndef SP_NO_QP
/* Ours: sp_qp_solve and sp_qp_memory by SP_QP_ADMM or SP_QP_INTERIOR, whatever the settings say. */
SP_API sp_qp_solver sp_qp_admm(void);
#ifndef SP_QP_NO_INTERIOR
SP_API sp_qp_solver sp_qp_interior(void);
#endif

#ifndef SP_NO_DYKSTRA
/* The seed's first one, to compare with: alternating projections, for a diagonal P; another, rows of very different scale or
 * nearly dependent equations end as SP_QP_NUMERICAL. At most 500 iterations. Of the settings it reads eps_abs, eps_rel,
 * iterations and budget.                                                              [seed 4.1; Boyle, Dykstra 1986] */
SP_API sp_qp_solver sp_qp_dykstra(void);
#endif

SP_API sp_qp_settings sp_qp_default(void);

/* Bytes sp_qp_setup and sp_qp_solve take from an arena, exact. The symbolic step of the sparse back end runs in `scratch`.
 *   returns SP_OK, SP_E_MEMORY: scratch too small; else what sp_qp_setup returns of its arguments */
SP_API sp_status sp_qp_memory(const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes);

/* Bytes of scratch that sp_qp_memory needs; 0: too large to count. */
SP_API size_t sp_qp_memory_scratch(const sp_qp *qp, const sp_qp_settings *settings);

/* Solve. settings NULL: the default ones. x0 (n), y0 (m): a guess, each may be NULL.
 *   returns SP_OK (whatever result->status), and on failure with arena and result untouched: SP_E_ARGUMENT, SP_E_EMPTY (n = 0),
 *           SP_E_INDEX (rows out of range or out of order, P below its diagonal), SP_E_NOT_FINITE, SP_E_RANGE (l > u,
 *           settings), SP_E_UNSUPPORTED (a back end, method or polish that this build leaves out),
 *           SP_E_INDEFINITE (P, scaled, has an eigenvalue below about -1e-9 of its largest entry, float -2.5e-7 n; the
 *           matrix-free back end can only look for one and may miss one that is small), SP_E_MEMORY */
SP_API sp_status sp_qp_solve(const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, const sp_real *x0,
                             const sp_real *y0, sp_qp_result *result);

/* The same in steps, for many problems with the same P and A. The work lives in the arena and refers to the arrays of *qp.
 *   returns as sp_qp_solve, and SP_E_NOT_FINITE also where scaling overflows */
typedef struct sp_qp_work sp_qp_work;
SP_API sp_status sp_qp_setup(const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena, sp_qp_work **work);

/* Other q, l, u (NULL: keep), referred to and not copied. Factors anew only if a row became an equation, or free, or ceased to.
 *   returns SP_OK, and with nothing changed SP_E_ARGUMENT, SP_E_NOT_FINITE, SP_E_RANGE */
SP_API sp_status sp_qp_update(sp_qp_work *work, const sp_real *q, const sp_real *l, const sp_real *u);

/* Another rho, 1e-6 .. 1e6; factors anew at the next run.     returns SP_OK, SP_E_ARGUMENT, SP_E_RANGE */
SP_API sp_status sp_qp_rho(sp_qp_work *work, sp_real rho);

/* Run from a guess (x0, y0: NULL for 0; result->x and ->y of the run before are fine).  returns SP_OK, SP_E_ARGUMENT,
 *         SP_E_NOT_FINITE (guess) */
SP_API sp_status sp_qp_run(sp_qp_work *work, const sp_real *x0, const sp_real *y0, sp_qp_result *result);

static inline const char *sp_qp_status_text(sp_qp_status status) { return sp_text(SP_WORDS_QP_STATUS, (int32_t)status); }
#endif /* SP_NO_QP */

#ifndef SP_QP_ONLY
/* ------------------------------------------------------------------------------------------------ the seed's constants
 *
 * "Seed" is the specification, [n.m] its sections in solvers/seed/README.md; departures from it are numbered in
 * solvers/README.md. It asks least squares, then polish, then ADMM, and reads a verdict off the third one's tension. Here the
 * same stages, constants and gates only propose, and verdicts are proved as ever: a finite gamma buys a little tension even
 * where none is needed [departure 2]. Ranges: faces 3 .. 64, window, balance and reg > 0, gain < 1, no number < 0. Values are
 * those of double; what a float can't reach is float's own in sp_seed_table: balance 1e-5, cone 1e-5, reg 1e-6, sigma 1e-3,
 * rho_equal 1e2, cg_tol 1e-6, eps 1e-4. */

typedef struct sp_seed {
    int32_t faces, inscribed;   /* friction pyramid, mu_eff = mu cos(pi/faces)                             8, 1     [1.4] */
    int32_t net;                /* friction on fp - fm                                                     1        [1.4] */
    sp_real gamma, tau;         /* weights of tension and friction                                         1e3, 1   [1.5] */
    int32_t dense_cells;        /* n^2 + (equations + friction rows) n up to which ADMM factors a dense
                                   matrix; conjugate gradients above. 0: admm.backend                      1.2e7    [1.5] */
    sp_real tension;            /* max fm / max fp that counts as none; also the tol of the preset         1e-3     [1.6] */
    sp_real balance, cone;      /* gates of least squares and polish: imbalance, friction beyond the cone  1e-6, 1e-7 [2.1] */
    sp_real gain;               /* polish gives up when `window` rounds gain less                          0.05     [2.2] */
    int32_t window, rounds;     /* and after so many rounds                                                250, 20000 [2.2] */
    sp_real engaged, floor;     /* a joint is engaged, rubs, above so much of the largest fn; and above it 0.01, 1e-9 [3.2] */
    sp_real reg;                /* added to 2J'J of the motion's least squares                             1e-9     [3.2] */
    sp_real gate, drop;         /* residual that passes; joints beyond it and so much of the worst go      0.5, 0.75 [3.3] */
    sp_real slip_error;         /* friction so far off its slip goes, in eps                               2        [3.3] */
    int32_t turns;              /* settings.coupled.rounds                                                 12       [3.3] */
    sp_qp_settings admm;        /* sigma 1e-6, relax 1.6, rho 0.1 and 1e3 of it on equations, eps 1e-4, eps_pinf 1e-4, check 10,
                                   adapt 100, at most 10 by 5, 3 passes, CG 250 and 1e-10                   [4.2, 4.3] */
    sp_qp_settings native;      /* what settings.penalty.solver is asked for: 1e-6, 1e-5, 6000 iterations, polish   [4.4] */
} sp_seed;

/* The one table of all of them; static storage. Copy it, change what you like and point settings.seed to the copy. NULL of
 * SP_SMALL, which refuses every one. */
SP_API const sp_seed *sp_seed_table(void);

#if !defined(SP_NO_QP) && !defined(SP_NO_ADMM)

/* gates, least squares, polish, ADMM with the seed's cone, constants, gates and its tolerance for tension as tol; a coupled
 * check, where it is asked for, by the seed's alternation alone, eta bounding each component. */
SP_API sp_settings sp_settings_seed(void);
#endif
#endif /* SP_QP_ONLY */

/* ------------------------------------------------------------------------------------------------------------ configuration
 *
 *   SP_API          linkage of the public calls              extern; `static` makes the library private to one file
 *   SP_REAL_FLOAT   defined: all numbers are float           double
 *   SP_REAL_MIXED   defined, and SP_REAL_FLOAT not: block factors of the search in space are float, and what they solve is
 *                   refined in double by conjugate gradients; the same verdicts as double, to a relative 1e-6 of a limit;
 *                   7 kB of stack
 *   SP_SQRT(x)      correctly rounded square root            sqrt / sqrtf of the C library
 *   SP_ASSERT(c)    checks of internal assumptions           nothing
 *   SP_SMALL        defined: every call below in its smallest form, a third of the code. True cone, joints without strength,
 *                   all blocks together, by a search that stops at tol. Its factor is an envelope in the order of the blocks:
 *                   number them so that what touches is near. All that falls is a MECHANISM, fewer of them are final, what is
 *                   undecided is at its LIMIT; demand, effect and extremes stay 0, weakest -1 (sp_joint_resultant tells).
 *                   Budgets, effects left out, stages but the gates and the exact one (which are one here; so sp_settings_seed,
 *                   too, and sp_seed_table is NULL), pyramids, the coupled check, contacts of faces that are not convex:
 *                   SP_E_UNSUPPORTED, also for a number or choice of these that no build takes.
 *                   custom, penalty and what coupled has but for asked are neither read nor checked.
 *                   What two blocks share in one plane is one contact, its convex hull, which carries the same forces; left
 *                   out is a hull narrower than the distance, and a piece as narrow of two faces that are both more than four
 *                   times as wide, where other builds ask each polygon. A hull of very many corners is several contacts.
 *                   Contacts of two blocks are in the order of faces. Overlaps are found of convex blocks only; every pair of
 *                   blocks is asked for contacts, every pair of their faces. Texts of statuses are shorter.
 *                   sp_limit leaves more undecided, and has no y0; what another build's sp_limit claims is for that build's
 *                   sp_limit_verify, for this one may leave it open. sp_sequence checks all that is there at every step, and
 *                   sp_sequence_hold searches no other sets than those it comes to by letting go. Quadratic programs: the dense
 *                   back end and ADMM whichever are chosen, no polish; sp_qp_dykstra takes one row at a time
 *   SP_NO_IPM       defined: no interior-point method and no sp_limit; the exact stage leaves more of what is about to fall
 *                   undecided
 *   SP_NO_PLAN      defined: no sp_plan, no search of planar and level scenes in 3 rows; depth left out: SP_E_UNSUPPORTED
 *   SP_NO_CRA       defined: no coupled check; settings.coupled is refused with SP_E_UNSUPPORTED
 *   SP_NO_STRONG    defined: no sp_strong, no calls of its own; SP_SMALL is without, too
 *   SP_NO_SLIDING   defined: no sp_sliding, no calls of its own; SP_SMALL and SP_NO_IPM are without, too
 *   SP_NO_ADMM      defined: no preset of the seed (the seed, below); SP_STAGE_ADMM is refused with SP_E_UNSUPPORTED
 *   SP_NO_DYKSTRA   defined: no sp_qp_dykstra
 *   SP_QP_NO_INTERIOR  defined: no interior points for quadratic programs: sp_qp_solve by ADMM, whatever it is used for
 *   SP_NO_QP        defined: no quadratic programs, none of all these
 *   SP_QP_ONLY      defined: quadratic programs and nothing else
 *   SP_EXACT_ONLY   defined: of SP_SMALL the check alone, without sp_sequence; with it go SP_NO_QP, SP_NO_IPM, SP_NO_PLAN
 */

/* Switches: what is lost, and the code saved of 241937 bytes on a Cortex-M7, of 233819 on an M4F in float.
 *
 *   SP_NO_IPM         interior points, sp_limit and its calls, sp_joint_moves                         49070   46892
 *   SP_NO_PLAN        sp_plan; planar and level scenes in 3 rows a block, SP_EFFECT_DEPTH left out    13094   12898
 *   SP_NO_CRA         the coupled check: settings.coupled.asked                                       38862   37360
 *   SP_NO_STRONG      sp_strong: what friction holds whatever it does                                 20068   19280
 *   SP_NO_SLIDING     sp_sliding: limits without dilatancy                                            15580   15078
 *   SP_NO_ADMM        the preset of the seed, SP_STAGE_ADMM, settings.coupled.rounds                   8682    8468
 *   SP_NO_DYKSTRA     sp_qp_dykstra                                                                    3144    3076
 *   SP_NO_QP          all quadratic programs; with SP_NO_ADMM, SP_NO_DYKSTRA                          32148   31268
 *   SP_QP_NO_CG       SP_QP_CG, the back end without a matrix                                          1536    1492
 *   SP_QP_NO_POLISH   sp_qp_settings.polish: the last digits, sharper certificates                     3788    3592
 *   SP_QP_NO_INTERIOR interior points for quadratic programs: SP_QP_INTERIOR, sp_qp_interior           4096    4014
 *   SP_QP_ONLY        all that knows of stones                                                       215979  208519
 *   SP_SMALL          all but the smallest form; with SP_NO_CRA; no CG, polish, interior points      192881  186351
 *   SP_EXACT_ONLY     as SP_SMALL, and sp_sequence; with SP_NO_QP, SP_NO_IPM, SP_NO_PLAN             209479  202487
 *
 * Calls left out are not declared; settings that ask for what is left out are SP_E_UNSUPPORTED. Any may be combined, but
 * two contradictions stop at an #error: SP_QP_ONLY with SP_NO_QP or SP_EXACT_ONLY; more than one of SP_REAL_MIXED,
 * SP_REAL_FLOAT, SP_REAL_QUAD. */

#ifdef __cplusplus
}
#endif
#endif /* STONEPACK_H */
