/* What a picture is of: a scene, and what was found about it. */
#ifndef STONEPACK_HOST_SUBJECT_H
#define STONEPACK_HOST_SUBJECT_H

#include "../files/scene.h"
#include "view.h"

typedef struct subject {
    const host_scene *scene;
    const sp_result *result;
    const sp_limit_result *limit;       /* of a limit: result has its forces and motion only; NULL: of a check */
    view_wish view;
    int names;                          /* names on all blocks that have room for one */
    const char *level;                  /* coupled, strong, ambiguous ...: what was asked besides; NULL: nothing */
    const char *motion;                 /* what the motion is, where it is none of these; NULL: how it starts to move */
} subject;

#endif
