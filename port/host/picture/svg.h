/* A picture of a checked scene. */
#ifndef STONEPACK_HOST_SVG_H
#define STONEPACK_HOST_SVG_H

#include "../files/scene.h"

/* A scene and what was found about it. */
typedef struct svg_subject {
    const host_scene *scene;
    const sp_result *result;
    const sp_limit_result *limit;       /* of a limit: result has its forces and motion only; NULL: of a check */
} svg_subject;

/* Draw the scene with its forces, its weakest joint and, where it is unstable, how it moves.  returns 1, 0: out of memory */
int svg_write(FILE *out, const svg_subject *subject);

typedef enum svg_mark { SVG_PLAIN = 0, SVG_ABSENT, SVG_NEW, SVG_HELD, SVG_FALLS } svg_mark;

#define SVG_CAPTION 48

/* One picture of a sheet: the scene's vertices at that moment, and what stands below. */
typedef struct svg_frame {
    sp_real (*vertex)[3];
    const unsigned char *mark;  /* of each block an svg_mark; NULL: all plain */
    int bad;                    /* the picture has a red rim, its caption too */
    char caption[SVG_CAPTION];
} svg_frame;

/* Draw a scene at several moments, three in a row, up to 60, all in the view that suits
 * the last and in one scale.                                              returns 1, 0: out of memory */
int svg_sheet(FILE *out, const sp_scene *scene, int frames, const svg_frame *frame, const char *title);

#endif
