#define _POSIX_C_SOURCE 200809L         /* posix_spawn, fileno */
#include "raster.h"

#ifdef _WIN32

int raster_png(FILE *svg, FILE *png, const char *path, failure *error)
{
    (void)svg, (void)png, (void)path;
    return fail_with(error, EXIT_UNAVAILABLE, NULL, 0, "stonepack: --png needs POSIX, to start rsvg-convert");
}

#else
#include <errno.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

/* Wait for its end.    returns 1: it did its work */
static int ended_well(pid_t child)
{
    int how = 0;
    pid_t is;
    do is = waitpid(child, &how, 0); while (is < 0 && errno == EINTR);
    return is == child && WIFEXITED(how) && WEXITSTATUS(how) == 0;
}

int raster_png(FILE *svg, FILE *png, const char *path, failure *error)
{
    static char program[] = "rsvg-convert", zoom[] = "--zoom=2", unlimited[] = "--unlimited";
    char *const argv[] = { program, zoom, unlimited, NULL };
    posix_spawn_file_actions_t io;
    pid_t child;
    int failed;
    if (fflush(svg) || fflush(png) || fseek(svg, 0, SEEK_SET) || lseek(fileno(svg), 0, SEEK_SET) < 0)
        return fail_with(error, EXIT_INTERNAL, path, 0, "can't write the picture: %s", strerror(errno));
    if (posix_spawn_file_actions_init(&io)) return fail_with(error, EXIT_MEMORY, path, 0, "out of memory");
    failed = posix_spawn_file_actions_adddup2(&io, fileno(svg), STDIN_FILENO);
    if (!failed) failed = posix_spawn_file_actions_adddup2(&io, fileno(png), STDOUT_FILENO);
    if (!failed) failed = posix_spawnp(&child, program, &io, NULL, argv, environ);
    posix_spawn_file_actions_destroy(&io);
    if (failed == ENOENT)
        return fail_with(error, EXIT_UNAVAILABLE, NULL, 0,
                         "stonepack: --png needs rsvg-convert (apt-get install librsvg2-bin)");
    if (failed) return fail_with(error, EXIT_INTERNAL, path, 0, "can't start rsvg-convert: %s", strerror(failed));
    return ended_well(child) ? 0 : fail_with(error, EXIT_INTERNAL, path, 0, "rsvg-convert can't draw the picture");
}

#endif
