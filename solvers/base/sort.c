/* sort: heap sort of numbers 0..n-1 by a rule of the caller's.
 *
 * No recursion, no memory of its own, n log n always. The rule must be a strict order without ties (ties by index), then the
 * result does not depend on the order given.
 */
#ifndef SP__SORT_C
#define SP__SORT_C

#include "config.c"

#if SP__WITH_STONES

typedef int (*sp__before)(const void *what, int32_t i, int32_t j);      /* does i come before j? */

/* Let p[root] sink to its place in the heap p[0..n), the last in order on top. */
static void sp__sort_sink(int32_t *p, int32_t root, int32_t n, sp__before before, const void *what)
{
    const int32_t x = p[root];
    for (int32_t child = 2 * root + 1; child < n; child = 2 * root + 1) {
        if (child + 1 < n && before(what, p[child], p[child + 1])) child++;
        if (!before(what, x, p[child])) break;
        p[root] = p[child];
        root = child;
    }
    p[root] = x;
}

/* Sort the n numbers p by `before`, which is told `what`; not stable, so `before` breaks ties. */
static void sp__sort(int32_t *p, int32_t n, sp__before before, const void *what)
{
    for (int32_t root = n / 2 - 1; root >= 0; root--) sp__sort_sink(p, root, n, before, what);
    for (int32_t last = n - 1; last > 0; last--) {
        const int32_t top = p[0];
        p[0] = p[last];
        p[last] = top;
        sp__sort_sink(p, 0, last, before, what);
    }
}

#endif
#endif /* SP__SORT_C */
