/* Faces that a file has twice: listed again, or of a second shell in the same place. They would count a mass again. */
#ifndef STONEPACK_HOST_TWINS_H
#define STONEPACK_HOST_TWINS_H

#include "obj.h"
#include "remarks.h"

/* Of faces of a block with the same corners in the same order, looking the same way, the first stays and the others go, and
 * that is told. A block that is closed with them and open without is refused.          returns 0 or an exit status */
int twins_drop(obj_file *f, remarks *told, failure *error);

/* Pressure lines count the faces of a file: none of a file that lost some.             returns 0 or an exit status */
int twins_check_pressures(const obj_file *f, failure *error);

#endif
