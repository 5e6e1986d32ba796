/* Which faces of a scene a viewer sees first: the painter's order, decided pair by pair where two faces overlap on paper. */
#ifndef STONEPACK_HOST_HIDDEN_H
#define STONEPACK_HOST_HIDDEN_H

#include "view.h"

/* The faces that look towards the viewer, back to front, in *order (malloc's).      returns their number, -1: out of memory */
int32_t hidden_order(const sp_scene *s, const view *v, int32_t **order);

#endif
