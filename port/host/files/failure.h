/* How the program fails: an exit status and one line. */
#ifndef STONEPACK_HOST_FAILURE_H
#define STONEPACK_HOST_FAILURE_H

#include "../../../stonepack.h"

/* Exit status of the program (sysexits.h where it has a name for it; 130: stopped by Ctrl-C, as shells tell it). */
enum { EXIT_STABLE = 0, EXIT_UNSTABLE = 1, EXIT_UNDECIDED = 2, EXIT_USAGE = 64, EXIT_SCENE = 65, EXIT_NO_INPUT = 66,
       EXIT_UNAVAILABLE = 69, EXIT_INTERNAL = 70, EXIT_MEMORY = 71, EXIT_STOPPED = 130 };

/* What went wrong: exit status and one line without its newline. */
typedef struct failure {
    int status;
    char line[512];
} failure;

/* Set an error `path:line: message` (without `line:` when line is 0). Returns status. Control bytes become '?'. */
int fail_with(failure *error, int status, const char *path, int32_t line, const char *format, ...);

/* Set the error of a library call. Returns its exit status: 71, 65 or 70. */
int fail_status(failure *error, sp_status status, const char *path, int32_t line, const char *what);

#endif
