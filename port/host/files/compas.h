/* Assemblies and block models of COMPAS, which write JSON, told as the text of a scene file.
 *
 * Read is what compas_assembly, compas_cra and compas_dem write and wrote (COMPAS 0.x to 2.x): a graph or network whose nodes
 * have blocks or elements, in any of the wrappers { dtype | datatype, data | value }; lists of meshes or boxes, also in
 * courses; a single mesh.
 *
 *   names       b and the node's key: b0, b1, ...; spaces and the like become _
 *   supports    is_support, in old files is_anchor; what scripts set is not in the file: --fixed b0,b1
 *   contacts    where every edge has its polygons, turned so that their normal points from a into b; else they are found
 *   density     of the element's material where it has one
 *   problem     of compas_dem: friction of its contact model, gravity where asked for, body forces, point loads, and as
 *               supports what its displacements hold at 0; weight counts always, as in its solver
 *   faces       outward; those out of their plane by more than a hundredth of the block become triangles
 */
#ifndef STONEPACK_HOST_COMPAS_H
#define STONEPACK_HOST_COMPAS_H

#include "obj.h"

/* Does a text begin as JSON does? */
int compas_is_json(const char *text, size_t length);

/* As obj_parse, of JSON. Lines told are those of the JSON. */
int compas_parse(const char *path, char *text, size_t length, obj_file *file, failure *error);

#endif
