/* Files that a command writes, beside those it reads. */
#ifndef STONEPACK_HOST_OUTPUTS_H
#define STONEPACK_HOST_OUTPUTS_H

#include "../files/remarks.h"
#include "options.h"

/* Nothing that is read may be written over, nor one file be written twice. `own`: path of what the command writes without an
 * option, or NULL; it may be the scene itself, which is whole when it is replaced.                returns 0 or EXIT_USAGE */
int outputs_check(const options *o, const char *own, failure *error);

/* Scenes are written as OBJ: a name that ends in the name of another form is refused.            returns 0 or EXIT_USAGE */
int outputs_check_obj(const char *option, const char *path, failure *error);

/* A scene that is written holds what the file beside the one that is read said. Where this file is beside both, it would count
 * twice: refused. Where another is beside what is written, outputs_tell_beside says so.       returns 0 or EXIT_USAGE */
int outputs_check_beside(const char *option, const char *scene, const char *path, failure *error);
void outputs_tell_beside(const char *path, remarks *told);

#endif
