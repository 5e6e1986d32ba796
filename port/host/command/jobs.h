/* More than one core, `--jobs N`: tasks of one scene by threads, several scenes by processes. POSIX. */
#ifndef STONEPACK_HOST_JOBS_H
#define STONEPACK_HOST_JOBS_H

#include "../../../stonepack.h"
#include "../files/failure.h"

#define JOBS_MOST 64

/* Threads for settings.parallel, until jobs_end: `jobs` - 1 of them besides the caller's own. What asks while they are at work
 * does its tasks alone.     *parallel: NULL of 1 job     returns 0 or EXIT_UNAVAILABLE */
int jobs_begin(int jobs, const sp_parallel **parallel, failure *error);
void jobs_end(void);

/* Scenes 0 .. n - 1, `jobs` at a time, each in a process of its own with exit status one(self, k). What they print, also on
 * standard error, comes in their order. Where progress_stopped, no other is begun.
 *   name      of each, for what is said of one that dies: EXIT_INTERNAL
 *   status    of each that ran. Where no process can be started it is checked in this one, alone
 *   returns   how many ran, from the first on; -1: none, this is not POSIX */
int jobs_scenes(int n, int jobs, char *const *name, int (*one)(void *self, int k), void *self, int *status);

#endif
