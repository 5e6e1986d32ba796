/* cone: nearest point of a friction cone and the derivative of that map, for the search.
 *
 *   true cone       K = { |ut| <= mu un }                                              P_K in closed form      [seed 2.2]
 *   pyramid         K = { d_k . ut <= mu un, k = 0..faces-1 }, d_k at 2 pi k/faces from the first tangent.
 *                   By its mirror symmetry the nearest point lies in the sector of u: fold u into it, then the answer is
 *                   u itself, its foot on one face, its foot on one edge, or the apex. Cost log(faces).
 * mu is the coefficient in force (mu cos(pi/K) for an inscribed pyramid). P_K of a cone is homogeneous: P_K(s u) = s P_K(u).
 *
 *   with strength   K = { |ut| <= C + mu un, -T <= un <= N }, T <= C / mu: a cone or pyramid moved down, cut off below and
 *                   above. The distance to its section at height t is convex in t: where the uncut one has its least, kept
 *                   within -T .. N, lies the nearest point: on the slope, a wall, a rim between them; of a pyramid an edge, a
 *                   corner.
 */
#ifndef SP__CONE_C
#define SP__CONE_C

#include "../base/vec3.c"
#include "pyramids.c"

#if SP__WITH_LARGE

typedef struct sp__cone {
    int32_t faces;                      /* 0: true cone */
    sp_real tan_half;                   /* tan(pi / faces) */
    sp_real (*direction)[2];            /* faces of them */
} sp__cone;

/* Strength of one vertex; plain: friction only, C = T = 0, N without end. */
typedef struct sp__yield { sp_real mu, C, T, N; int plain; } sp__yield;

typedef enum sp__region { SP__APEX, SP__INSIDE, SP__FACE, SP__EDGE, SP__WALL, SP__RIM,
                         SP__CORNER } sp__region;

/* Position of u in the cone, and its local frame: w the unit vector of its face, b how far along the face (>= 0), side +-1. */
typedef struct sp__foot { sp__region region; sp_real w[2], a, b, side, t; } sp__foot;

static void sp__cone_carve(sp__cone *k, int32_t faces, sp_arena *a)
{
    k->faces = faces;
    k->direction = sp__take(a, (size_t)faces, sizeof *k->direction);
}

/* Edges and half angle of the pyramid, if the cone is one. */
static void sp__cone_make(sp__cone *k)
{
    sp_real c;
    k->tan_half = 0;
    if (!k->faces) return;
    sp__pyramid_half(k->faces, &c, &k->tan_half);
    for (int32_t i = 0; i < k->faces; i++) sp__pyramid_direction(k->faces, i, k->direction[i]);
}

/* The face nearest to ut: bisection over the half circle, sector k ends where d_k + d_k+1 points. */
static int32_t sp__cone_sector(const sp__cone *k, sp_real x, sp_real y)
{
    int32_t lo = 0, hi = k->faces / 2;
    while (lo < hi) {
        const int32_t mid = (lo + hi) / 2;
        const sp_real *d = k->direction[mid], *e = k->direction[mid + 1];
        if ((d[0] + e[0]) * y - (d[1] + e[1]) * x > 0) lo = mid + 1;
        else hi = mid;
    }
    return lo;
}

/* The local frame of ut, its length in o->a. */
static void sp__cone_frame(const sp__cone *k, const sp_real u[3], sp__foot *o)
{
    o->b = 0; o->side = 1;
    if (!k->faces) {
        o->w[0] = o->a > 0 ? u[1] / o->a : 1;
        o->w[1] = o->a > 0 ? u[2] / o->a : 0;
        return;
    }
    const sp_real y = u[2] < 0 ? -u[2] : u[2];
    const sp_real *d = k->direction[sp__cone_sector(k, u[1], y)];
    o->w[0] = d[0]; o->w[1] = u[2] < 0 ? -d[1] : d[1];
    o->a = o->w[0] * u[1] + o->w[1] * u[2];
    o->b = o->w[0] * u[2] - o->w[1] * u[1];
    if (o->b < 0) { o->b = -o->b; o->side = -1; }
}

/* Foot of u on the set with strength, in the frame of u. A true cone has b = tan(pi/K) = 0. */
static void sp__yield_foot(const sp__cone *k, const sp__yield *y, sp_real x, sp__foot *o)
{
    const sp_real mu = y->mu, e = mu * k->tan_half, at = x < -y->T ? -y->T : x > y->N ? y->N : x;
    const sp_real room = sp__max(0, y->C + mu * at);
    const int beyond = x < -y->T || x > y->N;
    if (o->a <= room && (room > 0 || !beyond)) {        /* a wall without width is a rim */
        o->region = beyond ? SP__WALL : SP__INSIDE;
        o->t = at;
        return;
    }
    o->region = SP__FACE;
    o->t = (x + mu * (o->a - y->C)) / (1 + mu * mu);
    if (o->b > k->tan_half * (y->C + mu * o->t)) {
        o->region = SP__EDGE;
        o->t = (x + mu * (o->a - y->C) + e * (o->b - k->tan_half * y->C)) / (1 + mu * mu + e * e);
    }
    if (o->t > -y->T && o->t < y->N) return;
    o->t = o->t < y->N ? -y->T : y->N;
    o->region = o->b > k->tan_half * sp__max(0, y->C + mu * o->t) ? SP__CORNER : SP__RIM;
}

/* Position of u; plain: in the cone or pyramid |ft| <= mu fn, whatever the strength. */
static void sp__cone_foot(const sp__cone *k, const sp__yield *yield, int plain, const sp_real u[3], sp__foot *o)
{
    const sp_real mu = yield->mu, e = mu * k->tan_half;
    o->a = SP_SQRT(u[1] * u[1] + u[2] * u[2]);
    if (plain && !k->faces) {                        /* most often: what needs no frame before it */
        o->b = 0; o->side = 1;
        if (u[0] >= 0 && o->a <= mu * u[0]) { o->region = SP__INSIDE; return; }
        if (mu * o->a <= -u[0]) { o->region = SP__APEX; return; }
    }
    if (SP__WITH_LARGE && k->faces && yield->plain) {    /* the pyramid lies between the cones of mu and of mu / cos(pi/K) */
        if (u[0] >= 0 && (sp_real)1.001 * o->a <= mu * u[0]) { o->region = SP__INSIDE; return; }
        if (mu * o->a * (1 + k->tan_half * k->tan_half) <= -u[0]) { o->region = SP__APEX; return; }
    }
    sp__cone_frame(k, u, o);
    if (!plain) { sp__yield_foot(k, yield, u[0], o); return; }
    if (k->faces && u[0] >= 0 && o->a <= mu * u[0]) { o->region = SP__INSIDE; return; }
    o->region = SP__FACE;
    o->t = (u[0] + mu * o->a) / (1 + mu * mu);
    if (!k->faces || (o->t > 0 && o->b <= e * o->t)) return;
    o->t = (u[0] + mu * o->a + e * o->b) / (1 + mu * mu + e * e);
    o->region = o->t > 0 ? SP__EDGE : SP__APEX;
}

/* f = P_K(u). f may be u. Returns the region. */
static sp__region sp__cone_project(const sp__cone *k, const sp__yield *yield, const sp_real u[3], sp_real f[3])
{
    sp__foot o;
    sp__cone_foot(k, yield, yield->plain, u, &o);
    if (o.region == SP__INSIDE) { f[0] = u[0]; f[1] = u[1]; f[2] = u[2]; return o.region; }
    if (o.region == SP__APEX) { f[0] = f[1] = f[2] = 0; return o.region; }
    if (o.region == SP__WALL) { f[0] = o.t; f[1] = u[1]; f[2] = u[2]; return o.region; }
    const sp_real along = sp__max(0, yield->C + yield->mu * o.t);
    const sp_real across = o.side * (o.region == SP__EDGE || o.region == SP__CORNER ? along * k->tan_half : o.b);
    f[0] = o.t;
    f[1] = along * o.w[0] - across * o.w[1];
    f[2] = along * o.w[1] + across * o.w[0];
    return o.region;
}

/* D = DP_K(u), symmetric 3 x 3: D[0..5] = nn, n1, n2, 11, 12, 22. Returns the region. */
SP__NOINLINE static sp__region sp__cone_derivative(const sp__cone *k, const sp__yield *yield, const sp_real u[3], sp_real D[6])
{
    const sp_real mu = yield->mu;
    sp__foot o;
    o.w[0] = o.w[1] = o.t = 0;                  /* inside a plain cone and at its apex: neither written nor read */
    sp__cone_foot(k, yield, yield->plain, u, &o);
    D[0] = D[1] = D[2] = D[3] = D[4] = D[5] = 0;
    if (o.region == SP__INSIDE) D[0] = 1;
    if (o.region == SP__INSIDE || o.region == SP__WALL) D[3] = D[5] = 1;
    if (o.region == SP__FACE || o.region == SP__RIM) {              /* true cone: (1, mu w)(1, mu w)'/(1 + mu^2)      */
        const sp_real q = o.region == SP__RIM ? 0 : 1 / (1 + mu * mu);      /* + (C + mu t)/a (I - w w'); a rim:  */
        const sp_real c = k->faces ? 1                                          /* the second part alone */
                        : o.a > 0 ? sp__max(0, yield->C + mu * o.t) / o.a : 0;
                                                    /* pyramid: I - n n', so 1 in place of (C + mu t)/a               */
        D[0] = q; D[1] = q * mu * o.w[0]; D[2] = q * mu * o.w[1];
        const sp_real s = q * mu * mu;
        D[3] = s * o.w[0] * o.w[0] + c * o.w[1] * o.w[1];
        D[4] = (s - c) * o.w[0] * o.w[1];
        D[5] = s * o.w[1] * o.w[1] + c * o.w[0] * o.w[0];
    }
    if (o.region == SP__EDGE) {                  /* e e' / e.e, e = (1, mu w + mu tan(pi/K) side w_perp) */
        const sp_real h = mu * k->tan_half * o.side;
        const sp_real x = mu * o.w[0] - h * o.w[1], y = mu * o.w[1] + h * o.w[0];
        const sp_real q = 1 / (1 + x * x + y * y);
        D[0] = q; D[1] = q * x; D[2] = q * y; D[3] = q * x * x; D[4] = q * x * y; D[5] = q * y * y;
    }
    return o.region;
}

/* Largest f.u over f in K with |f| <= most, or a little more: over the rims; over the cone or pyramid |ft| <= mu fn from the
 * lower rim, the vector to which is no longer than T + low / cos(pi/K), most times the length of u's foot on it. */
SP__NOINLINE static sp_real sp__yield_support(const sp__cone *k, const sp__yield *y, const sp_real u[3], sp_real most)
{
    sp__foot o;
    o.t = 0;
    sp__cone_foot(k, y, 1, u, &o);
    const sp_real along = y->mu * o.t, across = o.region == SP__EDGE ? along * k->tan_half : o.b;
    const sp_real size = o.region == SP__APEX ? 0 : o.region == SP__INSIDE ? sp__norm3(u)
                       : SP_SQRT(o.t * o.t + along * along + across * across);
    const sp_real low = sp__max(0, y->C - y->mu * y->T), a = o.a + k->tan_half * o.b;
    const sp_real corner = SP_SQRT(1 + k->tan_half * k->tan_half);
    const sp_real foot = low * a - y->T * u[0], open = foot + (most + y->T + low * corner) * size;
    const sp_real crush = y->N * u[0] + (y->C + y->mu * y->N) * a, shut = foot > crush ? foot : crush;
    return shut < open ? shut : open;
}

/* Largest f.u over f in K_v, |f| <= most: of a plain cone most |P_K(u)|. */
static sp_real sp__cone_support(const sp__cone *k, const sp__yield *y, const sp_real u[3], sp_real most)
{
    if (y->plain) {
        sp_real g[3];
        sp__cone_project(k, y, u, g);
        return most * sp__norm3(g);
    }
    return sp__yield_support(k, y, u, most);
}

#endif
#endif /* SP__CONE_C */
