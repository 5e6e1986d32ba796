#include "failure.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

int fail_with(failure *error, int status, const char *path, int32_t line, const char *format, ...)
{
    const size_t room = sizeof error->line;
    size_t n = 0;
    va_list args;

    error->status = status;
    if (path) {
        n = strlen(path);
        if (n > 255) { path += n - 255; n = 255; }      /* the end of a long path tells more than its start */
        memcpy(error->line, path, n);
        if (line > 0) n += (size_t)snprintf(error->line + n, room - n, ":%ld", (long)line);
        n += (size_t)snprintf(error->line + n, room - n, ": ");
    }
    va_start(args, format);
    vsnprintf(error->line + n, room - n, format, args);
    va_end(args);
    for (char *c = error->line; *c; c++)
        if ((unsigned char)*c < 32 || *c == 127) *c = '?';
    return status;
}

int fail_status(failure *error, sp_status status, const char *path, int32_t line, const char *what)
{
    int code = EXIT_SCENE;
    if (status == SP_E_MEMORY) code = EXIT_MEMORY;
    if (status == SP_E_ARGUMENT || status == SP_E_CAPACITY) code = EXIT_INTERNAL;
    return fail_with(error, code, path, line, "%s%s%s", what, what[0] ? ": " : "", sp_status_text(status));
}
