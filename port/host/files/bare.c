#include "bare.h"
#include "obj_names.h"

#include <stdlib.h>

static int has_faces(const obj_file *f, int32_t b)
{
    return (b + 1 < f->blocks ? f->block[b + 1].face : f->faces) > f->block[b].face;
}

static int is_free_left(const obj_file *f)
{
    for (int32_t b = 0; b < f->blocks; b++) if (has_faces(f, b) && f->block[b].fixed != SP_FIXED) return 1;
    return 0;
}

/* 1: has faces, or lacks them, or something of the file is on it. */
static unsigned char *mark_kept(const obj_file *f)
{
    unsigned char *kept = calloc((size_t)f->blocks + 1, 1);
    const int empty = is_free_left(f);                  /* a file that is cut may end with the name of its first stone */
    for (int32_t b = 0; kept && b < f->blocks; b++) {
        const unsigned has = f->block[b].has;
        kept[b] = f->block[b].fixed || has_faces(f, b) || !(has & OBJ_CURVES || (!has && empty));
    }
    for (int32_t i = 0; kept && i < f->contacts; i++) kept[f->contact[i].a] = kept[f->contact[i].b] = 1;
    for (int32_t i = 0; kept && i < f->loads; i++) kept[f->load[i].block] = 1;
    return kept;
}

static void tell(int32_t bare, text_word first, remarks *told)
{
    remarks_add(told, NULL, "%ld object%s without faces, the first '%.*s', %s passed over", (long)bare, bare > 1 ? "s" : "",
                (int)(first.n < 60 ? first.n : 60), first.s, bare > 1 ? "were" : "was");
}

int bare_drop(obj_file *f, remarks *told, failure *error)
{
    unsigned char *kept = f->faces ? mark_kept(f) : NULL;
    int32_t blocks = 0;
    text_word first = { NULL, 0 };

    if (!f->faces) return 0;
    if (!kept) return fail_with(error, EXIT_MEMORY, f->path, f->lines, "out of memory while reading");
    for (int32_t b = 0; b < f->blocks; b++) {
        if (kept[b]) f->block[blocks++] = f->block[b];
        else if (!first.s) first = f->block[b].name;
    }
    free(kept);
    if (blocks == f->blocks) return 0;
    tell(f->blocks - blocks, first, told);
    f->blocks = blocks;
    free(f->by_name);
    f->by_name = NULL;
    const int status = obj_names_sort(f, error);
    return status ? status : obj_names_resolve(f, error);
}
