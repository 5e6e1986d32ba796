/* The picture of a report that turns: what it shows, as data that its script draws. */
#ifndef STONEPACK_HOST_TURN_H
#define STONEPACK_HOST_TURN_H

#include <stdio.h>
#include "subject.h"

/* The elements #names, #scene and the script.                 returns 1, 0: out of memory */
int turn_write(FILE *out, const subject *of);

/* A block that moves while a step falls: as dq, in its order. */
typedef struct turn_move { int32_t block; sp_real dq[6]; } turn_move;

/* A step of a build order: its block, 0 stands, 1 falls, 2 undecided; who must be held; who moves. */
typedef struct turn_step {
    int32_t block, helds, moves;
    int how;
    const int32_t *held;
    const turn_move *move;
} turn_step;

/* The same elements for a scene that is built or taken down step by step.                 returns 1, 0: out of memory */
int turn_write_steps(FILE *out, const host_scene *scene, const view_wish *wish, int remove, int32_t steps,
                     const turn_step *step);

/* A paragraph: what the colours are, and how long forces and motions are drawn. */
void turn_legend(FILE *out, const subject *of);

/* Does a result have a motion to show? */
int turn_moves(const subject *of);

#endif
