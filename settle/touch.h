/* Contacts with their outlines, from the points that the simulation meets. */
#ifndef SETTLE_TOUCH_H
#define SETTLE_TOUCH_H

#include "bullet.h"
#include "settle.h"

/* Stones where they are; those from `stones` on are the parts of the container. */
typedef struct touch_place {
    int32_t stones, bodies;
    const settle_stone *const *stone;
    const settle_pose *pose;
} touch_place;

/* The contacts of these points in the order of (a, b), at most one a point; gaps up to `gap` count.
 *   touch     is sorted
 *   contact   room for `touches`                                                           returns 0: out of memory */
int touch_contacts(const touch_place *at, bullet_touch *touch, int32_t touches, double gap, settle_contact *contact,
                   int32_t *contacts);

#endif
