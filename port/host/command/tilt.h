/* How far a scene can be tilted. */
#ifndef STONEPACK_HOST_TILT_H
#define STONEPACK_HOST_TILT_H

#include "../files/scene.h"
#include "options.h"

enum { TILT_AZIMUTHS = 72 };

/* How far gravity may turn towards every azimuth before something falls. */
typedef struct tilt_margin {
    int stands;                 /* it does while level; without that all angles are 0 */
    double angle[TILT_AZIMUTHS];        /* [degree] towards azimuth 360 k / TILT_AZIMUTHS; 90: at any angle below */
    double least, azimuth;      /* the smallest of all azimuths, and its own [degree] */
    double within;              /* by so much it may be less, for what tol forgives [degree] */
    int undecided;              /* so many azimuths were not decided; their angle is what is proved to stand; level: 1 */
    sp_limit_result worst;      /* the limit at `azimuth`: its mechanism */
} tilt_margin;

/* returns 0 or an exit status; the arrays of m->worst lie in *memory, freed by the caller in every case */
int tilt_measure(const host_scene *s, const options *o, tilt_margin *m, void **memory, text_error *error);

/* Is the margin only what is known to stand: an azimuth was not decided, or farther than 90 degrees was not asked? */
int tilt_at_least(const tilt_margin *m);

/* A polar plot of the angles.              returns 1, 0: can't write */
int tilt_draw(FILE *out, const options *o, const tilt_margin *m);

#endif
