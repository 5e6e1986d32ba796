/* Names on the blocks: always of those that the words tell of, of all where that is asked for and as far as there is room. */
#ifndef STONEPACK_HOST_NAMES_H
#define STONEPACK_HOST_NAMES_H

#include "drawing.h"

typedef struct names {
    const char *const *text;            /* of each block */
    const unsigned char *told;          /* is this block named in the words? NULL: none */
    const sp_real *at;                  /* names of those told stand near it; NULL: on their middles */
    double clear;                       /* [px] round `at` that stay free of names */
    int all;                            /* the others, too: those whose middle is seen, where their name fits */
} names;

/* Draw them; *drawn: how many.                                                              returns 0: out of memory */
int names_draw(const names *n, const drawing *d, int32_t *drawn);

#endif
