/* A stone as a body of the simulation: mass, centroid, inertia, hulls. */
#ifndef SETTLE_BODY_H
#define SETTLE_BODY_H

#include "bullet.h"
#include "settle.h"

/* The body of a stone, lifted against gravity. *radius: of the sphere about the centroid that holds it [m].
 * body_free in every case.    returns SETTLE_OK, SETTLE_E_ARGUMENT, SETTLE_E_NUMBER, SETTLE_E_PIECES, SETTLE_E_MESH, SETTLE_E_MEMORY */
settle_status body_make(const settle_stone *stone, int32_t id, const settle_settings *set, bullet_body *body, double *radius);
void body_free(bullet_body *body);

#endif
