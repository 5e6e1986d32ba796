#define _XOPEN_SOURCE 700               /* lstat, realpath, fchown */
#include "file.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#ifdef _WIN32
#include <process.h>
#define PROCESS _getpid()
#else
#include <fcntl.h>
#include <unistd.h>
#define PROCESS getpid()
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

/* ------------------------------------------------------------------------------------------------------------- writing */

/* What PATH leads to by links, malloc's; itself where nothing is there yet. */
static char *behind_links(const char *path)
{
    char *to = NULL;
#ifndef _WIN32
    to = realpath(path, NULL);
#endif
    if (!to && (to = malloc(strlen(path) + 1)) != NULL) strcpy(to, path);
    return to;
}

/* What is written until it is whole, beside the file it then replaces; NULL: out of memory. */
static char *name_of_part(const char *target)
{
    const size_t room = strlen(target) + 32;
    char *part = malloc(room);
    if (part) snprintf(part, room, "%s.%ld.part", target, (long)PROCESS);
    return part;
}

#ifdef _WIN32

static int is_written_directly(const char *path)
{
    struct stat is;
    return stat(path, &is) == 0 && !S_ISREG(is.st_mode);
}

static FILE *open_part(const char *part, const char *target)
{
    (void)target;
    return fopen(part, "wb");
}

static int put_in_place(const char *part, const char *target)
{
    remove(target);                     /* rename replaces nothing here */
    return rename(part, target) == 0;
}

#else

/* Devices, pipes, what standard output or error goes to, a link to nothing. */
static int is_written_directly(const char *path)
{
    struct stat is, other;
    if (stat(path, &is)) return lstat(path, &is) == 0;
    for (int k = 1; k <= 2; k++) if (fstat(k, &other) == 0 && other.st_dev == is.st_dev && other.st_ino == is.st_ino) return 1;
    return !S_ISREG(is.st_mode);
}

/* With the permissions of what it will replace. */
static FILE *open_part(const char *part, const char *target)
{
    const int fd = open(part, O_WRONLY | O_CREAT | O_EXCL, 0666);
    struct stat is;
    if (fd < 0) return NULL;
    if (stat(target, &is) == 0) {
        const int owned = fchown(fd, is.st_uid, is.st_gid);             /* where that is allowed */
        (void)(owned | fchmod(fd, is.st_mode & 0777));
    }
    return fdopen(fd, "wb");
}

static int put_in_place(const char *part, const char *target) { return rename(part, target) == 0; }

#endif

/* NULL: to be written directly. Where that is refused, it is when the file is opened. */
static FILE *create_part(const char *path)
{
    char *target = behind_links(path), *part = target ? name_of_part(target) : NULL;
    FILE *out = NULL, *there = fopen(path, "r+b");      /* may it be written at all? */
    const int good = part && (there || errno == ENOENT);
    if (there) fclose(there);
    if (part) remove(part);                             /* left by a process of the same number that was killed */
    if (good) out = open_part(part, target);
    free(target);
    free(part);
    return out;
}

FILE *file_create(const char *path, failure *error)
{
    FILE *out;
    if (!path || strcmp(path, "-") == 0) return stdout;
    out = is_written_directly(path) ? NULL : create_part(path);
    if (!out) out = fopen(path, "wb");
    if (!out) fail_with(error, EXIT_INTERNAL, path, 0, "can't write: %s", strerror(errno));
    return out;
}

/* What was written beside PATH takes its place, or goes where status is an error; no part: PATH itself was written. */
static int finish_part(const char *path, int status, failure *error)
{
    char *target = behind_links(path), *part = target ? name_of_part(target) : NULL;
    struct stat is;
    if (!part) status = fail_with(error, EXIT_MEMORY, path, 0, "out of memory while writing");
    else if (is_written_directly(path) || stat(part, &is)) {
        if (status && stat(target, &is) == 0 && S_ISREG(is.st_mode) && !is_written_directly(path)) remove(target);
    } else {
        if (!status && !put_in_place(part, target))
            status = fail_with(error, EXIT_INTERNAL, path, 0, "can't write: %s", strerror(errno));
        if (status) remove(part);
    }
    free(target);
    free(part);
    return status;
}

int file_finish(FILE *out, const char *path, int status, failure *error)
{
    const int own = out != stdout, early = ferror(out), failed = (own ? fclose(out) : fflush(out)) != 0 || early;
    if (failed && !status)
        status = fail_with(error, EXIT_INTERNAL, own ? path : "-", 0, "can't write: %s", strerror(errno));
    return own ? finish_part(path, status, error) : status;
}

/* --------------------------------------------------------------------------------------------------------------- names */

#ifdef _WIN32

int file_is_same(const char *a, const char *b)
{
    char *whole[2] = { _fullpath(NULL, a, 0), _fullpath(NULL, b, 0) };
    const int same = whole[0] && whole[1] && _stricmp(whole[0], whole[1]) == 0;
    free(whole[0]);
    free(whole[1]);
    return same;
}

#else

/* The folder a path is in.     returns its last name, NULL: no such folder */
static const char *find_folder(const char *path, struct stat *is)
{
    const char *slash = strrchr(path, '/');
    char *folder = malloc(strlen(path) + 2);
    const char *name = slash ? slash + 1 : path;
    if (folder) {
        memcpy(folder, path, (size_t)(name - path));
        strcpy(folder + (name - path), ".");
        if (stat(folder, is)) name = NULL;
    }
    free(folder);
    return folder ? name : NULL;
}

int file_is_same(const char *a, const char *b)
{
    struct stat x, y;
    const int there = stat(a, &x) == 0, also = stat(b, &y) == 0;
    if (there != also || (there && !S_ISREG(x.st_mode))) return 0;
    if (there) return x.st_dev == y.st_dev && x.st_ino == y.st_ino;
    const char *name = find_folder(a, &x), *other = find_folder(b, &y);
    return name && other && x.st_dev == y.st_dev && x.st_ino == y.st_ino && strcmp(name, other) == 0;
}

#endif
