/* Lengths and directions as people name them: mm, y up. */
#ifndef STONEPACK_HOST_UNITS_H
#define STONEPACK_HOST_UNITS_H

#include "text.h"

/* A length of the file is so many times/over metres: two whole numbers, so that 250 mm are 0.25 m to the last bit. */
typedef struct units_length { int32_t times, over; } units_length;

/* mm, cm, m, in.                                              returns 1, 0: another word */
int units_read_length(text_word w, units_length *unit);

/* x, y, z with or without a sign.                             returns 1, 0: another word */
int units_read_axis(text_word w, sp_real axis[3]);

#endif
