/* Blocks of a file by their names. */
#ifndef STONEPACK_HOST_OBJ_NAMES_H
#define STONEPACK_HOST_OBJ_NAMES_H

#include "obj.h"

/* Name of a word for a message: at most 60 bytes. */
#define WORD(w) (int)((w).n < 60 ? (w).n : 60), (w).s, (w).n < 60 ? "" : "..."
#define WORD_FORMAT "'%.*s%s'"

/* f->by_name. Both return 0 or an exit status; two blocks of one name are refused. */
int obj_names_sort(obj_file *f, failure *error);

/* The blocks that contacts and loads name. */
int obj_names_resolve(obj_file *f, failure *error);

/* The name of a block that is the whole file: the last part of its path without what follows the last dot. malloc's; NULL: out
 * of memory. */
char *obj_names_stem(const char *path, text_word *name);

#endif
