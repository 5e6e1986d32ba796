/* Gravity turned: by an angle that is given, or by as much as a scene stands. */
#ifndef STONEPACK_HOST_TILT_H
#define STONEPACK_HOST_TILT_H

#include "../../stonepack.h"

/* The tilt table is what is level, perpendicular to gravity: two directions across each other and gravity, as long as that.
 * Azimuths turn from the first, x made level, to the second; with gravity down: from x to y. */
void tilt_level(const sp_real gravity[3], double h[2][3]);

/* Turn gravity by so many degrees towards an azimuth [degree]. */
void tilt_turn(double degrees, double azimuth, sp_real gravity[3]);

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

/* Measure it. Loads must be weights, since gravity turns weights alone, and joints without strength, which does not scale with
 * gravity as cones do.
 *   returns   as sp_limit; the arrays of m->worst lie in *memory, freed by the caller in every case */
sp_status tilt_measure(const sp_scene *scene, const sp_settings *settings, tilt_margin *m, void **memory);

#ifndef SP_NO_SLIDING
enum { TILT_SLIDES = 4 };

/* The same without dilatancy, towards an azimuth in the plane of a planar scene. */
typedef struct tilt_slide {
    double azimuth;             /* [degree] */
    sp_real body[3];            /* the live load of limit that it is: of `--body`, in gravity */
    sp_sliding_kind kind;
    sp_sliding_reason reason;
    double upper, associative;  /* [degree] a verified sliding state, else the associative value; -1: none */
    double lower, lower_strong; /* [degree] no state below; whatever friction does it stays, both proved */
    double residual;
} tilt_slide;

/* Both ways along the plane that the joints' normals lie in; where all are level beds, along both axes of the table.
 * `slide` has room for TILT_SLIDES, *n of them are written.        returns as sp_limit */
sp_status tilt_slides(const sp_scene *scene, const sp_settings *settings, tilt_slide *slide, int *n);
#endif

/* Is the margin only what is known to stand: an azimuth was not decided, or farther than 90 degrees was not asked? */
int tilt_at_least(const tilt_margin *m);

#endif
