/* clock: how long work takes on a host; the core never looks. */
#ifndef STONEPACK_HOST_CLOCK_H
#define STONEPACK_HOST_CLOCK_H

double now(void);               /* [s] from some moment on; never goes back */

#endif /* STONEPACK_HOST_CLOCK_H */
