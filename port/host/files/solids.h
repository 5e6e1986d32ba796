/* Solids as programs write them, made into blocks: seams, faces that look inwards, warped faces, several shells in one. */
#ifndef STONEPACK_HOST_SOLIDS_H
#define STONEPACK_HOST_SOLIDS_H

#include "obj.h"
#include "remarks.h"

/* Of a file in which every vertex is of one block: vertices of a block at the same place become one, blocks whose faces look
 * inwards are turned, and polygons of contacts so that their normal points from A into B.        returns 0: out of memory */
int solids_tidy(obj_file *f);

/* Faces that the library would refuse as warped become triangles, and that is told. Shells that are not joined become blocks
 * of their own, NAME.1, NAME.2 ..., if `split`, else they are told.          returns 0 or an exit status */
int solids_mend(obj_file *f, int split, remarks *told, failure *error);

#endif
