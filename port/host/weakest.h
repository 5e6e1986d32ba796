/* The joint nearest to its limit, and which limit that is. */
#ifndef STONEPACK_HOST_WEAKEST_H
#define STONEPACK_HOST_WEAKEST_H

#include "../../stonepack.h"

/* What a joint is near to: sliding along its plane, tipping about one of its edges, turning in its plane, being pulled apart,
 * being crushed. */
typedef enum weakest_limit {
    WEAKEST_SLIDING, WEAKEST_TIPPING, WEAKEST_TURNING, WEAKEST_PARTING, WEAKEST_CRUSHING, WEAKEST_LIMITS
} weakest_limit;

typedef struct weakest_joint {
    int32_t joint;              /* -1: none is near its limit */
    weakest_limit by;
    double share;               /* of that limit, 0 .. 1; by a corner's friction, where that alone is near, the corner's */
    int known;                  /* 1: balance alone fixes what the joint passes on; 0: so it is by these forces, not by all */
} weakest_joint;

#define WEAKEST_NEAR 0.9        /* from this share on a joint is near its limit */

/* Of what stands, and of the best forces of what is undecided: first a joint near its limit that holds by itself what hangs on
 * it, else the one that uses most of its friction, from 1 % on, else one that these forces bring near its limit. */
weakest_joint weakest_nearest(const sp_scene *scene, const sp_result *result);

/* "sliding", "tipping" and so on. */
const char *weakest_text(weakest_limit by);

/* What is told of such a joint behind its name, into `words`. */
#define WEAKEST_WORDS 96
void weakest_words(const sp_scene *scene, const sp_result *result, const weakest_joint *w, char words[WEAKEST_WORDS]);

/* The joint that lacks most, else the one that opens or slides fastest, else the nearest to its limit; -1: none is near. */
int32_t weakest_told(const sp_scene *scene, const sp_result *result);

#endif
