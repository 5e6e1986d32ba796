/* A polar plot of how far gravity may turn towards each azimuth. */
#ifndef STONEPACK_HOST_TILT_SVG_H
#define STONEPACK_HOST_TILT_SVG_H

#include <stdio.h>
#include "../files/remarks.h"

typedef struct tilt_plot {
    const char *path;           /* of the scene */
    const double *angle;        /* [degree] towards azimuth 360 k / azimuths */
    int azimuths;
    double least, azimuth;      /* the smallest of all, and its own [degree] */
    int at_least;               /* it is only what is known to stand */
    const char *cone;           /* "true", "8i" */
    const remarks *told;        /* below it */
} tilt_plot;

/* returns 1, 0: can't write */
int tilt_svg(FILE *out, const tilt_plot *p);

#endif
