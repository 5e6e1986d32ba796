/* gen: assemblies made by formula, for tests, the bench and the command line.
 *
 * Every scene has exact joints, A below or left of B, and named numbers with defaults and ranges:
 *
 *     gen_scene g;
 *     gen_open(&g, "arch");
 *     gen_set(&g, "t", 0.12);
 *     gen_capacity(&g, &cap);                   how much room (a dry run)
 *     gen_build(&g, &arena, &scene);            sp_scene_create and all blocks and joints
 *
 * The same numbers give the same scene, bit by bit, on every machine. Needs the public calls, floor, fabs and sqrt.
 */
#ifndef GEN_H
#define GEN_H

#include "../../stonepack.h"

#define GEN_OWN    8                            /* numbers a scene may have of its own */
#define GEN_COMMON 4                            /* mu, density, tilt, azimuth: every scene has them, after its own */
#define GEN_VALUES (GEN_OWN + GEN_COMMON)

typedef struct gen_param {
    const char *name;                           /* NULL ends a list */
    double value, low, high;                    /* default and range */
    const char *help;
} gen_param;

typedef struct gen_sink gen_sink;               /* where blocks and joints go: counted or built */

typedef struct gen_entry {
    const char *name, *help;                    /* NULL ends the table */
    void (*emit)(gen_sink *sink, const double *value);
    gen_param param[GEN_OWN + 1];
} gen_entry;

extern const gen_entry gen_table[];
extern const gen_param gen_common[];

/* A chosen entry with its numbers: its own from 0, the common ones from GEN_OWN. */
typedef struct gen_scene {
    const gen_entry *entry;
    double value[GEN_VALUES];
} gen_scene;

/* Choose an entry, all numbers at their defaults.          returns 1, 0: no such name */
int gen_open(gen_scene *g, const char *name);

/* Change a number; a fraction of what is counted is dropped.      returns 1, 0: no such number, -1: outside its range */
int gen_set(gen_scene *g, const char *name, double value);

/* Is the number one that counts something? */
int gen_counts(const char *name);

/* Room needed by the scene, exact.                         returns SP_OK, SP_E_MEMORY (too many) */
sp_status gen_capacity(const gen_scene *g, sp_capacity *cap);

/* Make the scene in an arena.                              returns what the building calls return */
sp_status gen_build(const gen_scene *g, sp_arena *arena, sp_scene *scene);

/* All of this at once, one number changed (param NULL: none).
 *   returns what gen_build returns; SP_E_ARGUMENT: no such name or number, or outside its range */
sp_status gen_make(const char *name, const char *param, double value, sp_arena *arena, sp_scene *scene);

/* Sine and cosine of x [rad] that are the same on every machine: own series, right to an ulp or so for |x| < 1000. */
double gen_sin(double x);
double gen_cos(double x);

/* Gravity of a world turned by `tilt` degrees: its horizontal part points along `azimuth` degrees from x towards y. */
void gen_gravity(double tilt, double azimuth, sp_real gravity[3]);

#endif /* GEN_H */
