/* A scene with names: the library's scene, the memory it lives in, and what the file called its blocks. */
#ifndef STONEPACK_HOST_SCENE_H
#define STONEPACK_HOST_SCENE_H

#include "amend.h"
#include "remarks.h"

typedef struct host_scene {
    char *path;                 /* as given, "-": standard input */
    char *beside;               /* of the file beside it, NULL: there is none; its lines are counted below 0 */
    sp_scene scene;             /* its arrays lie in memory */
    void *memory;
    size_t bytes;               /* sp_scene_memory of what the scene holds */
    const char **name;          /* of each block; they lie in names */
    char *names;
    sp_real mu;                 /* friction of the scene, for contacts without one of their own */
    sp_real density;            /* of blocks without one of their own */
    int found;                  /* the contacts were found, not given */
    touching touching;          /* how near faces are that touch, as options and file tell it; of contacts found */
    sp_strength strength;       /* of contacts found */
    int32_t near;               /* pairs of blocks that nearly touch: touching_near */
    int32_t inside;             /* pairs of blocks deep inside each other that have no joint: touching_inside */
    int32_t across;             /* joints that reach across a thin block: across_find */
    int32_t overlaps;
    sp_overlap *overlap;        /* blocks inside each other, only where contacts were found */
    int32_t *line;              /* of the file: of each block, of each contact given, of each load */
    int32_t given;              /* contacts given */
    int32_t gravity_line, strength_line;        /* where they are told first, 0: nowhere */
    remarks remarks;            /* what to know of it beside the answer */
} host_scene;

typedef enum scene_contacts { SCENE_GIVEN, SCENE_FIND } scene_contacts;

/* What is asked beside the file: the options that every command with a scene has. */
typedef struct scene_settings {
    sp_real mu;                 /* overrides every friction of the file; below 0: nothing */
    scene_contacts contacts;    /* SCENE_GIVEN: the file's, found if it has none; SCENE_FIND: found, the file's are left out */
    amendments amend;
} scene_settings;

/* The file as it is. */
scene_settings scene_settings_default(void);

/* Read a scene and build it.
 *   returns    0 or an exit status; free the scene with scene_free in every case */
int scene_read(const char *path, const scene_settings *set, host_scene *s, failure *error);

/* The same from text in memory (malloc's; the scene frees it). */
int scene_parse(const char *path, char *text, size_t length, const scene_settings *set, host_scene *s, failure *error);

/* What the library refuses of a scene that was read, with the line that is to blame: the load, gravity, block or contact whose
 * numbers are too large, the strength that a coupled check does not know.     returns an exit status, never 0 */
int scene_refused(const host_scene *s, const sp_settings *settings, sp_status why, failure *error);

void scene_free(host_scene *s);

/* "touching" and "remarks": what every answer tells of the scene it is about. */
void scene_remarks_json(json_out *j, const host_scene *s);

/* The live load of every block: its weight times a vector. */
void scene_body(host_scene *s, const double body[3]);

#endif
