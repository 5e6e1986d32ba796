/* Marked blocks that stand behind others: their outlines show through. */
#ifndef STONEPACK_HOST_THROUGH_H
#define STONEPACK_HOST_THROUGH_H

#include "faces.h"

/* Draw them, a few; where all that is marked is behind, however many. mark: of each block a block_mark.
 *   returns 0: out of memory */
int through_draw(const drawing *d, const faces *f, const unsigned char *mark);

#endif
