/* Models in binary and other forms (STL, PLY, OFF, glTF, DAE, 3MF, FBX ...) by Assimp, where it is built in (WITH_ASSIMP). */
#ifndef STONEPACK_HOST_MESHES_H
#define STONEPACK_HOST_MESHES_H

#include "amend.h"
#include "remarks.h"

/* Is a file of this name one of them? */
int meshes_is_known(const char *path);

/* As obj_read; what `asked` tells of up and unit is not remarked upon. The importer runs in a process of its own,
 * MESHES_SECONDS and MESHES_BYTES at most; its death is a bad file.
 *   returns    0 or an exit status, 69 where it is not built in */
int meshes_read(const char *path, const amendments *asked, obj_file *file, remarks *told, failure *error);

#endif
