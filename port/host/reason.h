/* Why a verdict is what it is, in words. */
#ifndef STONEPACK_HOST_REASON_H
#define STONEPACK_HOST_REASON_H

#include "../../stonepack.h"

/* A sentence without its full stop; "": there is no more to say. */
const char *reason_words(sp_reason reason);

#endif
