#include "drawn.h"
#include "file.h"
#include "raster.h"

static int put_whole(FILE *out, const char *path, drawn_put *put, const void *of, failure *error)
{
    return put(out, of) ? 0 : fail_with(error, EXIT_INTERNAL, path, 0, "can't write the picture: out of memory");
}

int drawn_file(const char *path, drawn_put *put, const void *of, failure *error)
{
    FILE *out = path ? file_create(path, error) : NULL;
    if (!path) return 0;
    return out ? file_finish(out, path, put_whole(out, path, put, of, error), error) : error->status;
}

int drawn_png(const char *path, drawn_put *put, const void *of, failure *error)
{
    FILE *svg = path ? tmpfile() : NULL, *out = svg ? file_create(path, error) : NULL;
    int status = 0;
    if (!path) return 0;
    if (!svg) return fail_with(error, EXIT_INTERNAL, path, 0, "can't write: no temporary file");
    if (!out) status = error->status;
    else {
        status = put_whole(svg, path, put, of, error);
        if (!status) status = raster_png(svg, out, path, error);
        status = file_finish(out, path, status, error);
    }
    fclose(svg);
    return status;
}
