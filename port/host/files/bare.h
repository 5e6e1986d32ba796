/* Objects without faces: curves, points, cameras of a drawing. */
#ifndef STONEPACK_HOST_BARE_H
#define STONEPACK_HOST_BARE_H

#include "obj.h"
#include "remarks.h"

/* Blocks that are curves, edges or points go, and empty ones where a block that is free is left, and that is told. Others
 * without faces stay to be refused: of their vertices the faces are missing; so do supports that are only names, and what loads
 * or contacts of the file are on. After amend_file, which says what supports are.         returns 0 or an exit status */
int bare_drop(obj_file *f, remarks *told, failure *error);

#endif
