/* The importer writes the text of a scene into a pipe; what comes out is read as any scene, and trusted as little. */
#define _POSIX_C_SOURCE 200809L         /* fork, setrlimit */
#include "meshes.h"
#include "file.h"
#include "solids.h"

#include <string.h>

#define MESHES_SECONDS 20               /* of processor and, apart from that, of waiting */
#define MESHES_BYTES   ((size_t)2 << 30)

static const char *ending(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot && !strchr(dot, '/') ? dot + 1 : "";
}

static int is_one_of(const char *word, const char *const *list)
{
    for (; *list; list++) {
        size_t i = 0;
        while (word[i] && (word[i] | 32) == (*list)[i]) i++;
        if (!word[i] && !(*list)[i]) return 1;
    }
    return 0;
}

int meshes_is_known(const char *path)
{
    static const char *const known[] = { "stl", "ply", "off", "gltf", "glb", "dae", "fbx", "x3d", "amf", "dxf", "3mf",
                                        "3ds", NULL };
    return is_one_of(ending(path), known);
}

#ifndef WITH_ASSIMP

int meshes_read(const char *path, const amendments *asked, obj_file *file, remarks *told, failure *error)
{
    const obj_file empty = { 0 };
    *file = empty;
    (void)asked, (void)told;
    return fail_with(error, EXIT_UNAVAILABLE, path, 0, "built without Assimp (libassimp-dev), which reads such files: "
                     "export OBJ");
}

#else

#include <assimp/cimport.h>
#include <assimp/scene.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* ------------------------------------------------------------------------------------------------ in the importer's process */

typedef struct writer {
    FILE *out;
    long vertices, blocks;
    double scale;               /* of lengths */
} writer;

static void give_up(FILE *out, const char *why)
{
    fprintf(out, "\n!%.200s", why);
    fflush(out);
    _exit(1);
}

static void write_mesh(writer *w, const struct aiMesh *mesh, struct aiMatrix4x4 m)
{
    for (unsigned v = 0; v < mesh->mNumVertices; v++) {
        const double x = (double)mesh->mVertices[v].x, y = (double)mesh->mVertices[v].y, z = (double)mesh->mVertices[v].z;
        double p[3] = { (double)m.a1 * x + (double)m.a2 * y + (double)m.a3 * z + (double)m.a4,
                              (double)m.b1 * x + (double)m.b2 * y + (double)m.b3 * z + (double)m.b4,
                              (double)m.c1 * x + (double)m.c2 * y + (double)m.c3 * z + (double)m.c4 };
        for (int k = 0; k < 3; k++) if (!(fabs(p[k] *= w->scale) < 1e30)) give_up(w->out, "a coordinate is no finite number");
        fprintf(w->out, "v %.9g %.9g %.9g\n", p[0], p[1], p[2]);
    }
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices < 3) continue;            /* loose points and edges */
        fputs("f", w->out);
        for (unsigned k = 0; k < face->mNumIndices; k++) {
            if (face->mIndices[k] >= mesh->mNumVertices) give_up(w->out, "a face has a corner that is no vertex");
            fprintf(w->out, " %ld", w->vertices + (long)face->mIndices[k] + 1);
        }
        fputs("\n", w->out);
    }
    w->vertices += (long)mesh->mNumVertices;
}

/* A node with meshes is a block; its number makes names differ. */
static void write_name(writer *w, const char *name)
{
    fputs("o ", w->out);
    for (; *name; name++) fputc((unsigned char)*name <= ' ' || strchr("#\\,<>\177", *name) ? '_' : *name, w->out);
    fprintf(w->out, ".%ld\n", w->blocks++);
}

static void write_node(writer *w, const struct aiScene *scene, const struct aiNode *node, struct aiMatrix4x4 above, int depth)
{
    if (depth > 100) give_up(w->out, "nested too deep");
    aiMultiplyMatrix4(&above, &node->mTransformation);
    if (node->mNumMeshes) write_name(w, node->mName.length ? node->mName.data : "mesh");
    for (unsigned k = 0; k < node->mNumMeshes; k++) write_mesh(w, scene->mMeshes[node->mMeshes[k]], above);
    for (unsigned k = 0; k < node->mNumChildren; k++) write_node(w, scene, node->mChildren[k], above, depth + 1);
}

/* A number that the file tells of itself, else `preset`. */
static double told_number(const struct aiScene *scene, const char *key, double preset)
{
    const struct aiMetadata *m = scene->mMetaData;
    for (unsigned k = 0; m && k < m->mNumProperties; k++) {
        const struct aiMetadataEntry *e = &m->mValues[k];
        if (strcmp(m->mKeys[k].data, key)) continue;
        if (e->mType == AI_INT32) return (double)*(const int32_t *)e->mData;
        if (e->mType == AI_FLOAT) return (double)*(const float *)e->mData;
        if (e->mType == AI_DOUBLE) return *(const double *)e->mData;
    }
    return preset;
}

/* FBX tells its unit, in centimetres, and its axis up. Units that scene files don't know become metres. */
static void write_fbx_head(writer *w, const struct aiScene *scene)
{
    static const struct { double size; const char *name; } unit[] = {
        { 0.1, "mm" }, { 1, "cm" }, { 100, "m" }, { 2.54, "in" } };
    const double size = told_number(scene, "UnitScaleFactor", 1), up = told_number(scene, "UpAxis", 1);
    const char *name = "m";
    size_t k = 0;
    if (!(size > 1e-6 && size < 1e6)) give_up(w->out, "its UnitScaleFactor is no length");
    while (k < 4 && fabs(unit[k].size - size) > 1e-6 * size) k++;
    if (k < 4) name = unit[k].name;
    else w->scale = size / 100;
    fprintf(w->out, "#@ unit %s\n#@ up %s%c\n", name, told_number(scene, "UpAxisSign", 1) < 0 ? "-" : "",
            up < 0.5 ? 'x' : up < 1.5 ? 'y' : 'z');
}

/* Never more than whoever started the program grants. */
static void limit(int what, size_t most)
{
    struct rlimit l;
    if (getrlimit(what, &l)) return;
    if (l.rlim_cur > (rlim_t)most) l.rlim_cur = (rlim_t)most;
    if (l.rlim_max > (rlim_t)most) l.rlim_max = (rlim_t)most;
    setrlimit(what, &l);
}

static void import(const char *path, int pipe_end)
{
    FILE *out = fdopen(pipe_end, "w");
    const int null = open("/dev/null", O_WRONLY);
    struct aiMatrix4x4 unit;
    limit(RLIMIT_CPU, MESHES_SECONDS);
    alarm(3 * MESHES_SECONDS);
    limit(RLIMIT_CORE, 0);
#ifndef __SANITIZE_ADDRESS__
    limit(RLIMIT_AS, MESHES_BYTES);
#endif
    if (!out) _exit(2);
    dup2(null, 1);
    dup2(null, 2);
    struct aiPropertyStore *names = aiCreatePropertyStore();
    if (names) aiSetImportPropertyInteger(names, "IMPORT_COLLADA_USE_COLLADA_NAMES", 1);       /* not their ids */
    const struct aiScene *scene = aiImportFileExWithProperties(path, 0, NULL, names);
    writer w = { out, 0, 0, 1 };
    if (!scene || !scene->mRootNode) {
        const char *why = aiGetErrorString();
        give_up(out, strstr(why, "bad_alloc") ? "it asks for more memory than there is for reading" : why);
    }
    aiIdentityMatrix4(&unit);
    if (strcasecmp(ending(path), "fbx") == 0) write_fbx_head(&w, scene);
    write_node(&w, scene, scene->mRootNode, unit, 0);
    if (!w.blocks) give_up(out, "it holds no mesh");
    _exit(fflush(out) ? 2 : 0);
}

/* ------------------------------------------------------------------------------------------------------------- in this one */

/* All that comes out of the pipe.     returns NULL: out of memory, or more than FILE_CAP */
static char *read_pipe(int end, size_t *length)
{
    size_t room = 1 << 16;
    char *text = malloc(room);
    *length = 0;
    while (text) {
        const ssize_t n = read(end, text + *length, room - *length - 1);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) break;
        *length += (size_t)n;
        if (room - *length > 1) continue;
        char *more = room < FILE_CAP ? realloc(text, room *= 2) : NULL;
        if (!more) free(text);
        text = more;
    }
    if (text) text[*length] = 0;
    return text;
}

static int run_importer(const char *path, char **text, size_t *length, failure *error)
{
    int ends[2], how = 0;
    pid_t child;
    if (pipe(ends)) return fail_with(error, EXIT_INTERNAL, path, 0, "no pipe: %s", strerror(errno));
    fflush(NULL);
    child = fork();
    if (child == 0) {
        close(ends[0]);
        import(path, ends[1]);
    }
    close(ends[1]);
    *text = child > 0 ? read_pipe(ends[0], length) : NULL;
    close(ends[0]);
    if (child < 0) return fail_with(error, EXIT_INTERNAL, path, 0, "no process: %s", strerror(errno));
    while (waitpid(child, &how, 0) < 0 && errno == EINTR) continue;
    if (!*text) return fail_with(error, EXIT_MEMORY, path, 0, "out of memory while reading");
    const char *why = strstr(*text, "\n!");
    if (WIFEXITED(how) && WEXITSTATUS(how) == 0 && !why) return 0;
    const int slow = WIFSIGNALED(how) && (WTERMSIG(how) == SIGXCPU || WTERMSIG(how) == SIGKILL || WTERMSIG(how) == SIGALRM);
    fail_with(error, EXIT_SCENE, path, 0, "can't be read: %s",
              why && why[2] ? why + 2 : slow ? "the importer took too long" : "the importer died of it");
    free(*text);
    return error->status;
}

/* What the form says of axes and lengths. */
static void set_axes(const char *path, const amendments *asked, obj_file *f, remarks *told)
{
    static const char *const y_up[] = { "gltf", "glb", "dae", "x3d", "3ds", "dxf", NULL };     /* Assimp turns 3ds, dxf so */
    const sp_real y[3] = { 0, 1, 0 };
    const int up = asked->turn || asked->pull, unit = asked->unit.over != 0;
    if (is_one_of(ending(path), y_up)) {
        obj_set_up(f, y);
        f->down_told = 1;
        if (!up) remarks_add(told, "--up z", "read with y up, in metres, as its form says; otherwise");
    } else if (strcasecmp(ending(path), "fbx") == 0) {
        if (!up || !unit)
            remarks_add(told, "--unit UNIT, --up AXIS", "read in the unit and with the axis up that the file tells; otherwise");
    } else if ((strcasecmp(ending(path), "3mf") == 0 || strcasecmp(ending(path), "amf") == 0) && !f->unit.over && !unit) {
        remarks_add(told, "--unit mm", "lengths were taken for metres, and are millimetres in most such files");
    }
}

/* Importers keep 24 bits of a number: far from the origin stones change their shape. */
static void tell_rounding(const obj_file *f, remarks *told)
{
    double farthest = 0, least = 1e300;
    for (int32_t b = 0; b < f->blocks; b++) {
        const int32_t end = b + 1 < f->blocks ? f->block[b + 1].face : f->faces;
        sp_real low[3] = { 1e30, 1e30, 1e30 }, high[3] = { -1e30, -1e30, -1e30 };
        double size = 0;
        for (int32_t i = f->block[b].face; i < end; i++)
            for (int32_t k = 0; k < f->face[i].corners; k++) {
                const sp_real *x = f->vertex[f->corner[f->face[i].corner + k]];
                for (int c = 0; c < 3; c++) {
                    if (x[c] < low[c]) low[c] = x[c];
                    if (x[c] > high[c]) high[c] = x[c];
                    farthest = fmax(farthest, fabs((double)x[c]));
                }
            }
        for (int c = 0; c < 3; c++) size = fmax(size, (double)(high[c] - low[c]));
        if (size > 0 && size < least) least = size;
    }
    if (least < 1e300 && farthest * 0x1p-24 > 1e-4 * least)
        remarks_add(told, NULL, "such files are read to 24 bits: so far from the origin corners are off by up to %.1g %% of a "
                    "stone; move the model to the origin, or export OBJ", 100 * farthest * 0x1p-24 / least);
}

/* Of a PLY file cut in its header Assimp reads the last line again and again until its time is up. */
static int has_whole_header(const char *path, FILE *in)
{
    char head[1 << 16];
    if (strcasecmp(ending(path), "ply")) return 1;
    const size_t n = fread(head, 1, sizeof head - 1, in);
    for (size_t k = 0; k + 10 <= n; k++) if (memcmp(head + k, "end_header", 10) == 0) return 1;
    return 0;
}

int meshes_read(const char *path, const amendments *asked, obj_file *file, remarks *told, failure *error)
{
    const obj_file empty = { 0 };
    FILE *in = fopen(path, "rb");
    char *text = NULL;
    size_t length = 0;
    int status;

    *file = empty;
    if (!in) return fail_with(error, EXIT_NO_INPUT, path, 0, "can't open: %s", strerror(errno));
    const int whole = has_whole_header(path, in);
    fclose(in);
    if (!whole) return fail_with(error, EXIT_SCENE, path, 0, "can't be read: its header has no end_header");
    status = run_importer(path, &text, &length, error);
    if (!status) status = obj_parse(path, text, length, file, error);
    if (status) return status;
    for (int32_t b = 0; b < file->blocks; b++) file->block[b].line = 0;
    for (int32_t i = 0; i < file->faces; i++) file->face[i].line = 0;
    file->lines = 0;
    file->numbered = 1;
    set_axes(path, asked, file, told);
    tell_rounding(file, told);
    return solids_tidy(file) ? 0 : fail_with(error, EXIT_MEMORY, path, 0, "out of memory while reading");
}

#endif
