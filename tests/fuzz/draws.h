/* draws: of all bytes of an input, so that another byte anywhere draws otherwise and the same input always the same. Each thing
 * that is asked draws for itself, whatever else is asked. */
#ifndef DRAWS_H
#define DRAWS_H

#include "fuzz.h"

static uint64_t drawn_from, drawing;

/* The k-th series of draws of this input. */
static void draws_anew(unsigned k) { drawing = (drawn_from ^ (k + 1) * 11400714819323198485u) | 1; }

static void draws_of(const uint8_t *data, size_t size)
{
    drawn_from = 1469598103934665603u;                  /* [Fowler, Noll, Vo] */
    for (size_t k = 0; k < size; k++) drawn_from = (drawn_from ^ data[k]) * 1099511628211u;
    draws_anew(0);
}

static uint32_t draw(uint32_t below)
{
    drawing ^= drawing << 13;
    drawing ^= drawing >> 7;
    drawing ^= drawing << 17;
    return (uint32_t)(drawing * 2685821657736338717u >> 32) % below;        /* [Vigna] */
}

#endif
