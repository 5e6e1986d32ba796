/* Convex solids as loose polygons, and cutting by planes. */
#ifndef SETTLE_PIECES_H
#define SETTLE_PIECES_H

#include "settle.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Are these numbers, none of 1e100 or more? */
int pieces_finite(const double *x, size_t n);

/* Polygons, each with its own corners; of a convex solid all of them, outward. */
typedef struct pieces_solid {
    int32_t faces, corners, face_room, corner_room;
    int32_t *size;
    double (*xyz)[3];
} pieces_solid;

/* Add a polygon.                                                                           returns 1, 0: out of memory */
int pieces_add(pieces_solid *s, int32_t n, const double (*xyz)[3]);

/* Add the faces of a mesh.                                                                 returns 1, 0: out of memory */
int pieces_mesh(pieces_solid *s, const settle_mesh *mesh);

/* A box.                                                                                   returns 1, 0: out of memory */
int pieces_box(pieces_solid *s, const double low[3], const double high[3]);

/* The part of a convex solid with n . x <= d (n of length 1), into `out`, which is overwritten. Points within eps of the plane
 * count as on it.                                                                          returns 1, 0: out of memory */
int pieces_clip(const pieces_solid *s, const double n[3], double d, double eps, pieces_solid *out);

/* The plane of a face of a convex mesh, pushed out to its farthest vertex: n . x <= d holds for all of it. */
typedef struct pieces_plane {
    double n[3], d, width;      /* width: of the mesh along n */
} pieces_plane;

/* Planes of all faces that have one; *plane is malloc's.                                   returns 1, 0: out of memory */
int pieces_planes(const settle_mesh *mesh, pieces_plane **plane, int32_t *planes);

/* Two directions u, v in the plane of n, of the same length, at right angles, u x v along n. */
void pieces_axes(const double n[3], double u[3], double v[3]);

/* Newell's normal, its length twice the polygon's area. */
void pieces_normal(int32_t corners, const double (*xyz)[3], double n[3]);

void pieces_free(pieces_solid *s);

#ifdef __cplusplus
}
#endif

#endif
