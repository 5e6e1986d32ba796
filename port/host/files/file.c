#define _POSIX_C_SOURCE 200809L         /* lstat */
#include "file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#ifdef _WIN32
#define lstat stat                      /* no links */
#endif

/* The first byte of n that no text contains, or NULL; counts the lines before it. */
static const char *odd_byte(const char *s, size_t n, int32_t *line)
{
    for (size_t i = 0; i < n; i++) {
        const unsigned char c = (unsigned char)s[i];
        if (c == '\n') (*line)++;
        else if ((c < 32 && !memchr("\t\v\f\r", c, 4)) || c == 127) return s + i;
    }
    return NULL;
}

/* Make room for n + 1 more bytes. */
static int make_room(char **text, size_t *room, size_t length, size_t n)
{
    char *more;
    if (length + n + 1 <= *room) return 1;
    while (*room < length + n + 1) *room *= 2;
    more = realloc(*text, *room);
    if (!more) return 0;
    *text = more;
    return 1;
}

/* Forms of programs that have exports of their own, by how their files begin. */
static const char *what_export_helps(const char *text, size_t n)
{
    static const struct { const char *begins, *says; } form[] = {
        { "3D Geometry File Format", "a model of Rhino: export OBJ" },
        { "BLENDER", "a file of Blender: export OBJ" },
        { "\x28\xb5\x2f\xfd", "compressed, as files of Blender are: export OBJ" },
        { "AC10", "a drawing of AutoCAD: export STL" },
        { "\xff\xfe\xff\x0eS", "a model of SketchUp: export OBJ or STL" },
        { "PK\x03\x04", "compressed: unpack it, or name it .3mf if it is one" },
        { "\x1f\x8b", "compressed: unpack it" },
        { "glTF", "a binary glTF: name it .glb" },
        { "Kaydara FBX Binary", "an FBX file: name it .fbx" } };
    for (size_t k = 0; k < sizeof form / sizeof *form; k++) {
        const size_t length = strlen(form[k].begins);
        if (n >= length && memcmp(text, form[k].begins, length) == 0) return form[k].says;
    }
    return "this is no text file";
}

static int read_all(FILE *in, const char *path, char **text, size_t *length, failure *error)
{
    enum { CHUNK = 1 << 16 };
    size_t room = 2 * (size_t)CHUNK, n;
    int32_t line = 1;

    *length = 0;
    *text = malloc(room);
    for (;;) {
        const char *odd;
        if (!*text || !make_room(text, &room, *length, CHUNK))
            return fail_with(error, EXIT_MEMORY, path, 0, "out of memory while reading");
        n = fread(*text + *length, 1, CHUNK, in);
        odd = odd_byte(*text + *length, n, &line);
        if (odd)
            return fail_with(error, EXIT_SCENE, path, line, "byte 0x%02x: %s", (unsigned)*odd & 255u,
                             what_export_helps(*text, *length + n));
        *length += n;
        if (*length > FILE_CAP) return fail_with(error, EXIT_SCENE, path, line, "the file is larger than 1 GiB");
        if (n < CHUNK) break;
    }
    if (ferror(in)) return fail_with(error, EXIT_NO_INPUT, path, 0, "can't read: %s", strerror(errno));
    (*text)[*length] = 0;
    return 0;
}

int file_read(const char *path, char **text, size_t *length, failure *error)
{
    FILE *in = strcmp(path, "-") ? fopen(path, "rb") : stdin;
    int status;

    *text = NULL;
    if (!in) return fail_with(error, EXIT_NO_INPUT, path, 0, "can't open: %s", strerror(errno));
    status = read_all(in, path, text, length, error);
    if (in != stdin) fclose(in);
    if (status) {
        free(*text);
        *text = NULL;
    }
    return status;
}

FILE *file_create(const char *path, failure *error)
{
    FILE *out = path && strcmp(path, "-") ? fopen(path, "wb") : stdout;
    if (!out) fail_with(error, EXIT_INTERNAL, path, 0, "can't write: %s", strerror(errno));
    return out;
}

int file_finish(FILE *out, const char *path, int status, failure *error)
{
    const int early = ferror(out), failed = (out == stdout ? fflush(out) : fclose(out)) != 0 || early;
    struct stat is;
    if (failed && !status)
        status = fail_with(error, EXIT_INTERNAL, out == stdout ? "-" : path, 0, "can't write: %s", strerror(errno));
    if (status && out != stdout && lstat(path, &is) == 0 && S_ISREG(is.st_mode)) remove(path);       /* no device, no link */
    return status;
}
