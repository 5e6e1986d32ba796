/* groups: groups by union-find */
#ifndef SP__BASE_GROUPS_C
#define SP__BASE_GROUPS_C

#include "config.c"

#if SP__WITH_LARGE

/* A group of touching free blocks that reaches no support, pulled by F: every joint inside it stays as it is when the group
 * moves along F, so that motion does work |F|^2 > 0 against nothing. Turned by M, with F = 0: likewise, about M. With no load
 * at all f = 0 is the answer. */

static int32_t sp__root(int32_t *up, int32_t i)
{
    while (up[i] != i) { up[i] = up[up[i]]; i = up[i]; }
    return i;
}

static void sp__join(int32_t *up, int32_t i, int32_t k)
{
    i = sp__root(up, i); k = sp__root(up, k);
    if (i < k) up[k] = i; else up[i] = k;               /* the lowest number stands for the group; 0 is "supported" */
}

#endif

#endif /* SP__BASE_GROUPS_C */
