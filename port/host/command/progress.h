/* What a terminal is told meanwhile, on one line of standard error that the next replaces; and Ctrl-C. */
#ifndef STONEPACK_HOST_PROGRESS_H
#define STONEPACK_HOST_PROGRESS_H

#include "../../../stonepack.h"

/* Nothing is told where standard error is no terminal, or with `quiet`. */
void progress_begin(int quiet);
void progress_show(const char *format, ...);
void progress_end(void);                /* wipes the line */

/* Who watches a check, for settings.watch: from a second on its stage, its factorisations and the time are told. `what` is
 * copied. NULL where nothing is told. */
const sp_watch *progress_watch(const char *what);

/* From now on Ctrl-C is heard: progress_stopped, and whoever asks ends with what there is. A second one ends the program. */
void progress_hear(void);
int progress_stopped(void);

/* The next Ctrl-C calls `heard`, the one after it ends the program. */
void progress_once(void (*heard)(int signal));

#endif
