/* A scene as a file, in the form that obj.h reads. */
#ifndef STONEPACK_HOST_OBJ_WRITE_H
#define STONEPACK_HOST_OBJ_WRITE_H

#include <stdio.h>
#include "failure.h"

/* Write a scene as a file that reads back as the same scene, contacts as `#@ interface` and `#@ points`.
 *   name      of each block, or NULL: b0 b1 ...
 *   returns   0; an exit status where a block has no mesh, which the form can't say */
int obj_write(FILE *out, const sp_scene *scene, const char *const *name, const char *path, failure *error);

#endif
