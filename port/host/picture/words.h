/* The words around a picture: a title above, a legend below. */
#ifndef STONEPACK_HOST_WORDS_H
#define STONEPACK_HOST_WORDS_H

#include "forces.h"
#include "mechanism.h"
#include "subject.h"

/* What the words are about. */
typedef struct words {
    FILE *out;
    const subject *of;
    const drawing *d;
    const forces *forces;
    const mechanism *motion;
    int32_t weakest;                    /* joint that is drawn; -1: none is near its limit */
    int32_t hinges, slides;             /* drawn, of a limit's mechanism */
    int32_t named[2];                   /* blocks with their names, as it stands and as it moves */
} words;

void words_title(const words *w);

/* Over the picture of a motion: what it shows. */
void words_motion(const words *w, double x, double y);

/* Two lines, the first at this height [px]. */
void words_legend(const words *w, double y);

#endif
