/* A sheet of small pictures of one scene, at several moments. */
#ifndef STONEPACK_HOST_SHEET_H
#define STONEPACK_HOST_SHEET_H

#include "../files/remarks.h"
#include "faces.h"

#define SHEET_CAPTION 48

/* One picture of a sheet: the scene's vertices at that moment, and what stands below. */
typedef struct sheet_frame {
    sp_real (*vertex)[3];
    const unsigned char *mark;  /* of each block a block_mark; NULL: all plain */
    int bad;                    /* the picture has a red rim, its caption too */
    char caption[SHEET_CAPTION];
} sheet_frame;

/* What is around them. */
typedef struct sheet_page {
    const char *title;
    const view_wish *wish;      /* NULL: the view that suits the last moment */
    const remarks *told;        /* below; NULL: none */
    const char *const *name;    /* of each block, for those that come or must be held where it falls; NULL: no names */
    int names;                  /* also of all others that have room */
} sheet_page;

/* Draw a scene at several moments, three in a row, up to 60, all in one scale and one view.    returns 1, 0: out of memory */
int sheet_write(FILE *out, const sp_scene *scene, int frames, const sheet_frame *frame, const sheet_page *page);

#endif
