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
    int behind;                         /* it is, and nothing of it is seen */
    int32_t hinges, slides;             /* drawn, of a limit's mechanism */
    int32_t named[2];                   /* blocks with their names, as it stands and as it moves */
} words;

void words_title(const words *w);

/* Over the picture of a motion: what it shows. */
void words_motion(const words *w, double x, double y);

/* Its first line is at this height [px]. */
void words_legend(const words *w, double y);

/* How many lines it has. */
int words_legend_lines(const words *w);

#endif
