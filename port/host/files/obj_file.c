/* What a scene file may hold, as it is told, and how its tables are let go. */
#include "obj.h"

#include <stdlib.h>

const char *const obj_format =
    "  o NAME                             starts a block, its spaces become _; v and f as in any OBJ\n"
    "  g NAME                             likewise, in a file without o lines before it\n"
    "  #@ mu 0.84                         friction, whole scene; after an interface: that interface\n"
    "  #@ gravity 0 0 -9.80665            [m/s^2]\n"
    "  #@ density 2400                    [kg/m^3] whole scene; after an o line: that block\n"
    "  #@ up y                            gravity as strong, along -y; also -x, z, ...\n"
    "  #@ unit mm                         of all coordinates: mm, cm, m, in; forces stay N, densities kg/m^3\n"
    "  #@ contact_distance 0.0005         [m] faces nearer than this touch; 0.05%: of the smaller block\n"
    "  #@ contact_angle 1                 [degree] largest angle between touching faces\n"
    "  #@ supports b1,foot*               blocks that are supports, by name or pattern; or lowest; or ground, which is added\n"
    "  #@ fixed                           after an o line: this block is a support; fixed x y z rx ry rz: held in these "
    "directions\n"
    "  #@ interface A B x y z x y z ...   contact polygon, normal by the right hand from A into B\n"
    "  #@ points A B nx ny nz x y z ...   point or edge contact with its normal\n"
    "  #@ load A fx fy fz px py pz        force at a point; fx fy fz mx my mz couple: force and couple\n"
    "  #@ live A ...                      the same, scaled by `limit`\n"
    "  #@ mass A kg px py pz [live]       weight at a point, a gripper for instance\n"
    "  #@ pressure A FACE p [live]        [Pa] on its FACE-th f line, from 1\n"
    "  #@ cohesion c                      [Pa] of joints, as mu; also tension, crushing\n";

void obj_free(obj_file *file)
{
    free(file->text);
    free(file->text_beside);
    free(file->names);
    free(file->stem);
    free(file->beside);
    free(file->support);
    free(file->block);
    free(file->face);
    free(file->corner);
    free(file->vertex);
    free(file->contact);
    free(file->point);
    free(file->load);
    free(file->by_name);
}
