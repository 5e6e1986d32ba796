/* A scene file as written: a legal Wavefront OBJ whose `#@` comments carry what OBJ can't say. obj_format tells its lines.
 *
 * Reading gives tables in the order of the file, indices resolved and checked, names as places in the text. Whether blocks
 * are closed and contacts plane is for the library to say, when scene.c builds them.
 */
#ifndef STONEPACK_HOST_OBJ_H
#define STONEPACK_HOST_OBJ_H

#include "failure.h"
#include "touching.h"
#include "units.h"

/* The lines that a scene file may hold, one a line, as `stonepack --help` prints them. */
extern const char *const obj_format;

enum { OBJ_VERTICES = 1, OBJ_CURVES = 2 };      /* curves: or edges, or points */

typedef struct obj_block {
    text_word name;
    int32_t line, face;         /* first of its faces; they end where the next block's begin */
    sp_real density;            /* [kg/m^3], 0: the scene's */
    uint32_t fixed;             /* as sp_block.fixed */
    unsigned has;               /* what else was told of it: OBJ_VERTICES, OBJ_CURVES */
} obj_block;

typedef struct obj_face {
    int32_t line, corner, corners;
} obj_face;

typedef struct obj_contact {
    text_word name[2];          /* A, B */
    int32_t a, b;               /* their numbers */
    int32_t line, point, points;
    int polygon;                /* 0: points that share the normal n */
    sp_real n[3];
    sp_real mu, strength[3];    /* cohesion, tension, crushing [Pa]; -1: the scene's */
    int32_t strength_line[3];   /* where they are told, 0: nowhere */
} obj_contact;

typedef enum obj_load_kind { OBJ_FORCE, OBJ_COUPLE, OBJ_MASS, OBJ_PRESSURE } obj_load_kind;

typedef struct obj_load {
    text_word name;
    int32_t block, line;
    int live;
    obj_load_kind kind;
    int32_t face;               /* that is pressed, from 0 */
    sp_real f[3], x[3];         /* force, or f[0]: mass or pressure; point, or moment where the force acts at the centroid */
} obj_load;

/* Blocks that are supports, by a list of names and patterns. */
typedef struct obj_support {
    text_word list;
    int32_t line;
} obj_support;

/* What of a file of COMPAS is not in the scene. */
typedef struct compas_unread {
    long edges;                 /* without a polygon, while others have one: contacts are found anew */
    long moves, pressures;      /* components of displacements that are not 0; loads on surfaces */
    int strength;               /* cohesion or tension of the contact model, whose unit is nowhere told */
} compas_unread;

#define OBJ_BESIDE ".stonepack"          /* behind the path of a model: the file beside it */

/* Lines of the file beside a model are counted below 0. */
typedef struct obj_file {
    const char *path;
    char *beside;               /* path of the file beside it; NULL: there is none */
    char *text, *text_beside, *names, *stem;            /* names point into them */
    size_t length;
    int32_t lines;
    sp_real mu, strength[3], density, gravity[3];
    units_length unit;          /* of vertices and points, until amend_file has made them metres; over 0: metres */
    touching contact_told;           /* how near faces touch, where contacts are found */
    int32_t strength_line[3], gravity_line;             /* 0: not told */
    int down_told;              /* by gravity or up */
    int nodes;                  /* names are b and the key of a node: compas.h */
    int numbered;               /* names are those of nodes and .NUMBER: meshes.h */
    compas_unread unread;
    int32_t copies;             /* faces that were there twice and are gone: twins.h */
    int32_t blocks, faces, corners, vertices, contacts, points, loads, supports;
    obj_block *block;
    obj_face *face;
    int32_t *corner;            /* vertex numbers, 0-based */
    sp_real (*vertex)[3];       /* [m] */
    obj_contact *contact;
    sp_real (*point)[3];        /* [m] */
    obj_load *load;
    obj_support *support;
    int32_t *by_name;           /* blocks in the order of their names */
    struct { int32_t block, face, corner, vertex, contact, point, load, support; } room;
} obj_file;

/* Read a scene file ("-": standard input). Free it with obj_free, also after an error.     returns 0 or an exit status */
int obj_read(const char *path, obj_file *file, failure *error);

/* The same from text in memory, which the file then owns (malloc's, or NULL with length 0); path is for messages. */
int obj_parse(const char *path, char *text, size_t length, obj_file *file, failure *error);

/* Read what stands beside a model in PATH.stonepack, if that is there: `#@` lines; `o PATTERN` says which blocks of the
 * model the `density` and `fixed` after it are of.         returns 0 or an exit status */
int obj_read_beside(obj_file *file, failure *error);

/* Gravity as strong as it is, down along -up. */
void obj_set_up(obj_file *file, const sp_real up[3]);

/* Path and line for fail_with. */
#define OBJ_AT(f, n) (n) < 0 ? (f)->beside : (f)->path, (n) < 0 ? -(n) : (n)

void obj_free(obj_file *file);

#endif
