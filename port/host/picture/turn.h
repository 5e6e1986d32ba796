/* The picture of a report that turns: what it shows, as data that its script draws. */
#ifndef STONEPACK_HOST_TURN_H
#define STONEPACK_HOST_TURN_H

#include <stdio.h>
#include "subject.h"

/* The elements #names, #scene and the script.                 returns 1, 0: out of memory */
int turn_write(FILE *out, const subject *of);

/* A paragraph: what the colours are, and how long forces and motions are drawn. */
void turn_legend(FILE *out, const subject *of);

/* Does a result have a motion to show? */
int turn_moves(const subject *of);

#endif
