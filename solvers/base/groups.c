/* groups: numbers 0..n-1 joined into groups, by union-find with halved paths                      [Tarjan, van Leeuwen 1984] */
#ifndef SP__BASE_GROUPS_C
#define SP__BASE_GROUPS_C

#include "config.c"

#if SP__WITH_LARGE

/* The lowest number of the group of i. */
static int32_t sp__root(int32_t *up, int32_t i)
{
    while (up[i] != i) { up[i] = up[up[i]]; i = up[i]; }
    return i;
}

/* Joins the groups of i and k. */
static void sp__join(int32_t *up, int32_t i, int32_t k)
{
    i = sp__root(up, i); k = sp__root(up, k);
    if (i < k) up[k] = i; else up[i] = k;               /* the lowest number stands for the group; 0 is "supported" */
}

#endif

#endif /* SP__BASE_GROUPS_C */
