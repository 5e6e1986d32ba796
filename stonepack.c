#include "stonepack.h"

#include <string.h>
#ifndef SP_SQRT
#include <math.h>
#ifdef SP_REAL_FLOAT
#define SP_SQRT(x) sqrtf(x)
#else
#define SP_SQRT(x) sqrt(x)
#endif
#endif

#include "solvers/arena.c"
#include "solvers/pyramid.c"
#include "solvers/cone.c"
#include "solvers/order.c"
#include "solvers/chol.c"
#include "solvers/bchol.c"
#include "solvers/sort.c"
#include "solvers/clip.c"
#include "parts/1_scene.c"
#include "parts/2_contacts.c"
#include "parts/3_matrices.c"
#include "parts/4_check.c"
#include "parts/5_dual.c"
#include "parts/6_stages.c"
#include "parts/7_ladder.c"
