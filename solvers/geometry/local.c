/* local: polygons seen from one of their points, so that far coordinates lose nothing */
#ifndef SP__GEOMETRY_LOCAL_C
#define SP__GEOMETRY_LOCAL_C

#include "../base/vec3.c"

/* Points seen from the first of them, in units of a power of two: far or odd-sized coordinates lose nothing, and squares and
 * cubes of what is left can neither over- nor underflow. */
typedef struct sp__local {
    const sp_real *xyz;
    sp_real o[3], s;            /* origin and unit [m] */
    sp_real d;                  /* diagonal of the bounding box, 1 .. 2 sqrt(3), or 0                     [s] */
    sp_real coarse;             /* u (largest |coordinate|): what the coordinates themselves are good for [s] */
} sp__local;

static void sp__local_get(const sp__local *l, int32_t k, sp_real p[3])
{
    for (int c = 0; c < 3; c++) p[c] = (l->xyz[3 * (size_t)k + (size_t)c] - l->o[c]) / l->s;
}

/* The k-th of picked points; pick NULL: of all. */
static void sp__local_pick(const sp__local *l, const int32_t *pick, int32_t k, sp_real p[3])
{
    sp__local_get(l, pick ? pick[k] : k, p);
}

/* Largest power of two not above x, x finite and > 0. */
static sp_real sp__power_of_two(sp_real x)
{
    sp_real s = (sp_real)1;
    while (s <= x / 2) s *= 2;
    while (s > x) s /= 2;
    return s;
}

/* Of the `count` >= 1 points pick[0], pick[1] ... (pick NULL: 0, 1 ...). SP_E_NOT_FINITE: they are too far apart. */
static sp_status sp__local_start(sp__local *l, const sp_real *xyz, const int32_t *pick, int32_t count)
{
    sp_real extent[3], farthest = 0, most = 0;
    l->xyz = xyz;
    l->s = (sp_real)1;
    for (int c = 0; c < 3; c++) {
        const sp_real *at = xyz + c;
        sp_real lo = at[3 * (size_t)(pick ? pick[0] : 0)], hi = lo;
        l->o[c] = lo;
        for (int32_t k = 1; k < count; k++) {
            const sp_real x = at[3 * (size_t)(pick ? pick[k] : k)];
            if (x < lo) lo = x;
            if (x > hi) hi = x;
        }
        extent[c] = hi - lo;
        most = sp__max(most, extent[c]);
        farthest = sp__max(farthest, sp__max(sp__abs(lo), sp__abs(hi)));
    }
    if (!sp__finite(2 * most)) return SP_E_NOT_FINITE;
    if (most > 0) l->s = sp__power_of_two(most);
    for (int c = 0; c < 3; c++) extent[c] /= l->s;
    l->d = sp__norm3(extent);
    l->coarse = SP_EPSILON * (farthest / l->s);
    return SP_OK;
}

#endif /* SP__GEOMETRY_LOCAL_C */
