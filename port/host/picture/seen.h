/* What of a drawing is seen, and what stands behind other blocks. */
#ifndef STONEPACK_HOST_SEEN_H
#define STONEPACK_HOST_SEEN_H

#include "drawing.h"

typedef struct seen_box { double low[2], high[2]; } seen_box;           /* [px] */

typedef struct seen {
    const drawing *d;
    seen_box *paper;                    /* of each block */
} seen;

/* Look at a drawing.                        returns 0: out of memory; end it with seen_end in every case */
int seen_begin(seen *v, const drawing *d);
void seen_end(seen *v);

/* How near a point is to the viewer [m]. */
double seen_depth(const drawing *d, const sp_real x[3]);

/* Is this block the one that is seen at a point of the page? */
int seen_block_at(const seen *v, int32_t block, const double at[2]);

/* Is anything seen of the rim of a joint? */
int seen_joint(const seen *v, const sp_joint *joint);

/* Where a block is seen: at its centroid, else on one of its faces, as near as may be to a point of the page.
 *   returns 0: nowhere that was tried */
int seen_spot(const seen *v, int32_t block, const double near_to[2], double at[2]);

#endif
