/* settle: where do stones come to rest? Rigid bodies that fall, slide and topple, simulated by Bullet 3. Host only.
 *
 * Stones are closed polygon meshes, or several convex ones. They fall under a protocol of steps [seed 5] and end as poses,
 * contacts and a few numbers that tell how quiet it has become. The library's core never includes this.
 *
 *   units     SI, double. Margins and lifts are lengths: they suit stones of some decimetres to metres; scale others.
 *   sameness  the same input gives the same bits on one machine with one Bullet; elsewhere compare verdicts, never digits
 *   memory    malloc; what a call returns is freed by settle_free
 *
 * Contents:  1 stones   2 settings   3 results   4 calls   5 scenes
 */
#ifndef SETTLE_H
#define SETTLE_H

#include "../stonepack.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum settle_status {
    SETTLE_OK = 0,
    SETTLE_E_ARGUMENT  = -1,    /* a null pointer, a count below zero or beyond its limit, a stone that does not exist */
    SETTLE_E_MEMORY    = -2,
    SETTLE_E_NUMBER    = -3,    /* an infinity or a NaN */
    SETTLE_E_SETTINGS  = -4,    /* a setting outside its range */
    SETTLE_E_MESH      = -5,    /* a mesh that encloses no volume, is thinner than 5e-6 of its size, or names a vertex that
                                   does not exist */
    SETTLE_E_PIECES    = -6,    /* more convex pieces than SETTLE_PIECES in one stone */
    SETTLE_E_STOPPED   = -7,    /* by settings.watch */
    SETTLE_E_BODY      = -8,    /* a block of the scene without a mesh, or a free one whose mesh is open */
    SETTLE_E_DIVERGED  = -9,    /* the simulation left the finite numbers */
    SETTLE_E_LOAD      = -10    /* the scene has loads besides weight, mortar, or a block held in some directions only */
} settle_status;

/* One sentence on a status. Never NULL; static storage. */
const char *settle_status_text(settle_status status);

/* 1 ------------------------------------------------------------------------------------------------------------- stones */

#define SETTLE_STONES 100000    /* most stones of a call */
#define SETTLE_PIECES 512       /* most convex pieces of a stone */

/* A closed polygon mesh with outward faces. */
typedef struct settle_mesh {
    int32_t vertices, faces;
    const double *xyz;          /* 3 x vertices [m] */
    const int32_t *size;        /* corners of each face, >= 3 */
    const int32_t *corner;      /* vertex numbers, 0-based, face after face */
} settle_mesh;

/* A stone. Its convex pieces may touch but not overlap; volume, centroid and inertia are theirs together. A mesh that is not
 * convex is cut by settle_split first. */
typedef struct settle_stone {
    int32_t pieces;
    const settle_mesh *piece;
    double mass;                /* [kg] > 0; of fixed stones nothing depends on it */
    int32_t fixed;              /* 1: never moves, is not lifted */
} settle_stone;

/* Cut a mesh into convex pieces by planes through its faces (a binary space partition): convex meshes come back whole,
 * an L becomes 2, a U 3 pieces. A mesh counts as convex when no vertex lies more than `flat` diameters outside a face's
 * plane; 1e-3 suits warped faces. *piece: one allocation, freed by settle_free.
 *   returns SETTLE_OK, SETTLE_E_ARGUMENT, SETTLE_E_NUMBER, SETTLE_E_MESH, SETTLE_E_PIECES, SETTLE_E_MEMORY */
settle_status settle_split(const settle_mesh *mesh, double flat, settle_mesh **piece, int32_t *pieces);

/* An open mesh that is fixed, say a ground, as plates: one behind each face. Otherwise as settle_split. */
settle_status settle_plates(const settle_mesh *mesh, double thickness, settle_mesh **piece, int32_t *pieces);

/* 2 ----------------------------------------------------------------------------------------------------------- settings */

struct settle_pose;

/* Friction of the contacts between two stones (in either order; -1: the container). */
typedef struct settle_pair { int32_t a, b; double mu; } settle_pair;

/* Get them from settle_default() and change what you must. */
typedef struct settle_settings {
    double gravity[3];          /* full gravity                                             [m/s^2]      (0, 0, -9.81) */
    double ramp[3];             /* three gravities before it; never more than full                  [m/s^2]  0.5, 2, 5 */
    int32_t ramp_steps;         /* at each of these and at the full one, before `steps`; 0: no ramp                250 */
    int32_t steps;              /* at full gravity                                                                1500 */
    int32_t tamps;              /* rounds of tamping after that                                                      1 */
    double tamp;                /* gravity while tamping, in full ones                                             3.5 */
    int32_t tamp_steps, rest_steps;     /* of a round: tamping, then full gravity                             200, 400 */
    double dt;                  /* of a step [s]; smaller is truer and slower                                    1/600 */
    int32_t iterations;         /* of the contact solver in a step; more: stiffer stacks, longer                    80 */
    double friction;            /* of a stone's surface; a contact has the product of its two, as Bullet's        0.85 */
    double container_friction;  /*                                                                                 0.9 */
    double mu;                  /* >= 0: friction of every contact instead of that product                          -1 */
    int32_t pairs;              /* contacts with a friction of their own, whatever mu */
    const settle_pair *pair;    /*                                                                                NULL */
    double restitution;         /* 0 .. 1                                                                            0 */
    double damping;             /* share of velocity and spin lost in a second, 0 .. 1                             0.4 */
    double margin;              /* Bullet rounds hulls by so much; they are shrunk by it first, so that faces touch truly.
                                   At most a fifth of a piece's least width                          [m]       0.0015 */
    double touch;               /* gaps up to this count as contacts in the result [m]                          0.0005 */
    double mass_floor;          /* lighter stones weigh this [kg]                                                 1e-4 */
    double container[3];        /* inner width, depth, height of an open box; 0 0 0: none                [m]     0 0 0 */
    double floor[3];            /* middle of its floor [m]                                                       0 0 0 */
    double wall;                /* half the thickness of its floor and walls [m]                                  0.05 */
    double lift;                /* free stones start higher by this, against gravity [m]                          0.06 */
    double lowest;              /* a stone has settled when its centroid is higher than this, against gravity [m] -0.3 */
    double energy;              /* kinetic energy per mass below which a wait ends, after `quiet` such steps; 0: never
                                                                                                         [J/kg]      0 */
    int32_t quiet;              /*                                                                                 100 */
    double moved, turned;       /* a stone was held when its centroid moved and it turned no more  [m, degree]  0.02 8 */
    double reach;               /* settle_seat: neighbours are stones nearer than this [m]                        0.35 */
    int32_t (*watch)(void *user, int32_t step, int32_t steps, double energy, const struct settle_pose *pose);
                                /* called after each step, 1 .. steps, and before the first with 0; not 0 stops      NULL */
    void *user;
} settle_settings;

settle_settings settle_default(void);           /* stones fall into place                                   [seed 5] */
settle_settings settle_confirm_default(void);   /* does a finished assembly keep still? No lift, ramp, damping or tamping,
                                                   friction 0.7, 700 steps */
settle_settings settle_seat_default(void);      /* one stone onto fixed ones: ramps of 60, then 160 steps of 60 iterations,
                                                   no tamping, friction 0.8, lift 0.003 */

/* 3 ------------------------------------------------------------------------------------------------------------ results */

/* Where a stone is: x' = R (x - c) + t of its points x as given. */
typedef struct settle_pose {
    double R[9], c[3], t[3];    /* R by rows; c: volume centroid as given; t: where it is now [m] */
    double moved, turned;       /* |t - c| [m] and angle of R [degree], from the pose as given, not as lifted */
    int32_t settled;            /* fixed, or its centroid is above settings.lowest */
} settle_pose;

#define SETTLE_POINTS 8

/* Points in which two stones touch: the outline of where they are nearer than settings.touch, in the plane of the normal. */
typedef struct settle_contact {
    int32_t a, b;               /* stones; a = -1: the container */
    double n[3];                /* unit normal from a into b */
    int32_t points;             /* 1 .. SETTLE_POINTS */
    double point[SETTLE_POINTS][3];     /* between the two surfaces [m] */
    double depth;               /* deepest penetration, < 0: a gap [m] */
} settle_contact;

typedef struct settle_result {
    int32_t stones, settled;    /* settled: of them, fixed ones included */
    int32_t held;               /* 1: every free stone moved and turned no more than settings.moved, settings.turned */
    double moved, turned;       /* most of any stone [m, degree] */
    int32_t steps;              /* made */
    double energy;              /* kinetic, at the end [J] */
    double drift;               /* farthest any stone's surface went in the last 100 steps [m] */
    double penetration;         /* deepest at the end [m] */
    int32_t contacts;
    settle_pose *pose;          /* of each stone */
    settle_contact *contact;    /* in the order of (a, b) */
} settle_result;

/* 4 -------------------------------------------------------------------------------------------------------------- calls */

/* Let all stones settle. Free result->pose and ->contact by settle_result_free.
 *   returns SETTLE_OK, SETTLE_E_ARGUMENT, SETTLE_E_NUMBER, SETTLE_E_SETTINGS, SETTLE_E_MESH, SETTLE_E_MEMORY,
 *           SETTLE_E_STOPPED, SETTLE_E_DIVERGED; on failure the result is untouched */
settle_status settle_run(int32_t stones, const settle_stone *stone, const settle_settings *settings, settle_result *result);

/* Let one stone settle onto the others within reach, which stay where they are. Poses of the others are as given; contacts
 * are those of the one.     returns as settle_run */
settle_status settle_seat(int32_t stones, const settle_stone *stone, int32_t which, const settle_settings *settings,
                          settle_result *result);

void settle_result_free(settle_result *result);
void settle_free(void *memory);

/* 5 ------------------------------------------------------------------------------------------------------------- scenes */

/* The blocks of a scene as stones. */
typedef struct settle_assembly {
    int32_t stones;
    settle_stone *stone;        /* each points to pieces of its own */
    double scale;               /* lengths here = scale x lengths of the scene */
    int32_t block;              /* on failure: the block at fault, else -1 */
} settle_assembly;

/* Every block becomes a stone; those that are not convex are cut by settle_split(.., 1e-3, ..), supports whose mesh is open
 * become plates of a twentieth of their diameter behind their faces.
 *   unit      0: as it is; 1: lengths scaled so that the mean edge of the free blocks (cube root of volume) is 1, masses so that
 *             their mean is 1, which suits margins and limits to any assembly
 *   returns   what settle_split returns, SETTLE_E_BODY: a block without a mesh, or a free one with an open one; SETTLE_E_LOAD; free the assembly in every case */
settle_status settle_from_scene(const sp_scene *scene, int32_t unit, settle_assembly *assembly);

void settle_assembly_free(settle_assembly *assembly);

/* Room for the contacts of a result as joints of points. Contacts of two blocks that are both fixed are left out. */
void settle_count_joints(const settle_result *result, const sp_scene *scene, sp_capacity *capacity);

/* Add them to a scene whose blocks are the stones, in their order; the container, where there is one, is block `container`.
 *   returns what sp_scene_points returns */
sp_status settle_add_joints(const settle_result *result, int32_t container, const sp_strength *strength, sp_scene *scene);

#ifdef __cplusplus
}
#endif

#endif /* SETTLE_H */
