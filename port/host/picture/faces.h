/* The faces of the blocks: shaded, in the painter's order, with the edges at which they bend. */
#ifndef STONEPACK_HOST_FACES_H
#define STONEPACK_HOST_FACES_H

#include "drawing.h"

/* What a block's colour tells. */
typedef enum block_mark { MARK_PLAIN = 0, MARK_ABSENT, MARK_NEW, MARK_HELD, MARK_FALLS } block_mark;

typedef struct face_edge { int32_t low, high, face; } face_edge;

typedef struct faces {
    face_edge *edge;                    /* of all faces, sorted by block's vertex pairs */
    int32_t edges;
    unsigned char *bend;                /* do the faces bend at the edge that follows this corner? */
    unsigned char *crease;              /* is it drawn: a bend, or the rim of what is seen? */
} faces;

/* Find the edges of d's scene that are drawn.        returns 0: out of memory; free with faces_free in every case */
int faces_find(faces *f, const drawing *d);
void faces_free(faces *f);

/* Draw them. mark: of each block a block_mark, NULL: all plain.                            returns 0: out of memory */
int faces_draw(const faces *f, const drawing *d, const unsigned char *mark);

/* The other face at the edge that follows corner k of this face, -1: none, or more than one. */
int32_t faces_across(const faces *f, const sp_scene *s, int32_t face, int32_t k);

/* The drawn edges of a block, as the data of a path. */
void faces_outline(const faces *f, const drawing *d, int32_t block);

/* The fill of a block with this mark, in full light. */
void faces_color(block_mark mark, int rgb[3]);

#endif
