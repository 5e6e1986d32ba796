/* Solids as programs write them, made into blocks: warped faces, several shells in one. */
#ifndef STONEPACK_HOST_SOLIDS_H
#define STONEPACK_HOST_SOLIDS_H

#include "obj.h"
#include "remarks.h"

/* Faces that the library would refuse as warped become triangles, and that is told. Shells that are not joined become blocks
 * of their own, NAME.1, NAME.2 ..., if `split`, else they are told.          returns 0 or an exit status */
int solids_mend(obj_file *f, int split, remarks *told, failure *error);

#endif
