/* Meshes of blocks while an assembly of COMPAS is read: faces turned outward, and on which side of a joint a block lies. */
#ifndef STONEPACK_HOST_COMPAS_MESH_H
#define STONEPACK_HOST_COMPAS_MESH_H

#include <stdint.h>

/* All blocks so far; a block is its vertices, its faces, and their corners, numbered from 0 in the block. */
typedef struct compas_solids {
    double (*xyz)[3];
    int32_t *corner, *face;     /* first corner of each face, and behind the last one of a block the end */
    int32_t (*block)[2];        /* first vertex, first of its entries in face */
    int32_t vertices, corners, faces, blocks;
    struct { int32_t xyz, corner, face, block; } room;
} compas_solids;

/* One of them. before: vertices of all blocks before it. */
typedef struct compas_solid {
    double (*xyz)[3];
    const int32_t *corner, *face;
    int32_t vertices, faces, before;
} compas_solid;

/* Each returns 0 where memory is out. */
int compas_begin(compas_solids *s);
int compas_add_vertex(compas_solids *s, const double x[3]);
int compas_add_corner(compas_solids *s, int32_t vertex);
int compas_end_face(compas_solids *s);
/* A block that is a box: its middle, and from there half an edge each way. */
int compas_add_box(compas_solids *s, const double middle[3], double half[3][3]);

/* Axes of a frame of COMPAS, told by any two across each other: unit vectors, the second across the first in their plane, the
 * third across both.     returns 0: the two are parallel, or one is no direction */
int compas_unit_axes(double axis[3][3]);

/* The block is whole: moved by a frame, 3 x 4 by rows, faces turned outward. */
void compas_end(compas_solids *s, const double frame[12]);

compas_solid compas_last(const compas_solids *s);

/* Does the normal of a polygon, by the right hand, point from block b into a? By the faces in its plane: that holds for blocks
 * that are not convex, too. */
int compas_is_turned(const compas_solids *s, int32_t a, int32_t b, double (*x)[3], int32_t n);

void compas_free(compas_solids *s);

#endif
