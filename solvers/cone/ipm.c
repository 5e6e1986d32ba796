/* ipm: what a primal-dual interior-point method needs of a cone: Nesterov-Todd scaling and steps to the boundary.
 *
 *   cone     C = { x0 >= |(x1, x2)| }, its own dual;  det x = x0^2 - x1^2 - x2^2,  J = diag(1, -1, -1),  e = (1, 0, 0)
 *   product  a o b = (a.b, a0 b1 + b0 a1)                           both conditions of an optimum are x o z = 0
 *   scaling  W z = W^-1 x = lambda,  W^2 = s^2 (2 w w' - J),  det w = 1
 *
 * A step (dx, dz) towards x o z = sigma e meets W^-1 dx + W dz = q, so dx = W q - W^2 dz: h = W q is the aim below.
 *                                                             [Nesterov, Todd 1997; Vandenberghe 2010, "CVXOPT", section 5]
 */
#ifndef SP__IPM_C
#define SP__IPM_C

#include "../base/vec3.c"

#if SP__WITH_LARGE

typedef struct sp__nt { sp_real w[3], s; } sp__nt;

/* det x = x'J x = x0^2 - |(x1, x2)|^2, > 0 inside the cone. */
static sp_real sp__soc_det(const sp_real x[3])
{
    const sp_real t = SP_SQRT(x[1] * x[1] + x[2] * x[2]);
    return (x[0] - t) * (x[0] + t);
}

/* w = (x + J z) / 2 gamma of x, z with determinant 1, s^4 = det x / det z.     returns 0 when x or z is not inside */
static int sp__soc_scaling(const sp_real x[3], const sp_real z[3], sp__nt *W)
{
    const sp_real dx = sp__soc_det(x), dz = sp__soc_det(z);
    if (!(x[0] > 0 && z[0] > 0 && dx > 0 && dz > 0)) return 0;
    const sp_real a = 1 / SP_SQRT(dx), b = 1 / SP_SQRT(dz), gamma = SP_SQRT((1 + a * b * sp__dot3(x, z)) / 2);
    W->w[1] = (a * x[1] - b * z[1]) / (2 * gamma);
    W->w[2] = (a * x[2] - b * z[2]) / (2 * gamma);
    W->w[0] = SP_SQRT(1 + (W->w[1] * W->w[1] + W->w[2] * W->w[2]));
    W->s = SP_SQRT(SP_SQRT(dx) * b);
    return sp__finite(W->s * W->s * W->w[0] * W->w[0]) && W->s > 0;
}

/* o = W v, or W^-1 v; o may not be v. */
static void sp__soc_scale(const sp__nt *W, const sp_real v[3], int inverse, sp_real o[3])
{
    const sp_real t = W->w[1] * v[1] + W->w[2] * v[2], s = inverse ? 1 / W->s : W->s;
    const sp_real x = inverse ? -v[0] : v[0], c = x + t / (1 + W->w[0]);
    o[0] = s * (inverse ? -(t - W->w[0] * v[0]) : W->w[0] * v[0] + t);      /* so said that gcc at -O3 does not fuse it */
    o[1] = s * (v[1] + W->w[1] * c);
    o[2] = s * (v[2] + W->w[2] * c);
}

/* v <- W^2 v = s^2 (2 (w.v) w - J v). v[0] is not written like v[1]: gcc 12 fuses a pair x y - z, x y + z, flags or not. */
static void sp__soc_square(const sp__nt *W, sp_real v[3])
{
    const sp_real s = W->s * W->s, t = 2 * sp__dot3(W->w, v);
    v[0] = s * t * W->w[0] - s * v[0];
    v[1] = s * (t * W->w[1] + v[1]);
    v[2] = s * (t * W->w[2] + v[2]);
}

/* a = l \ q, which solves l o a = q; l inside the cone. */
static void sp__soc_divide(const sp_real l[3], const sp_real q[3], sp_real a[3])
{
    const sp_real t = l[1] * q[1] + l[2] * q[2], d = sp__soc_det(l);
    a[0] = (l[0] * q[0] - t) / d;
    a[1] = q[1] / l[0] + (t / l[0] - q[0]) / d * l[1];
    a[2] = q[2] / l[0] + (t / l[0] - q[0]) / d * l[2];
}

/* a = lambda \ (aim e - (W^-1 dx) o (W dz)): towards x o z = aim e, (dx, dz) the step that ignores the product of changes. */
static void sp__soc_product(const sp__nt *W, const sp_real z[3], const sp_real dx[3], const sp_real dz[3], sp_real aim,
                            sp_real a[3])
{
    sp_real l[3], q[3];
    sp__soc_scale(W, dx, 1, a);
    sp__soc_scale(W, dz, 0, q);
    const sp_real b = q[0];
    q[0] = aim - sp__dot3(a, q);
    q[1] = -(a[0] * q[1] + b * a[1]);
    q[2] = -(a[0] * q[2] + b * a[2]);
    sp__soc_scale(W, z, 0, l);
    sp__soc_divide(l, q, a);
}

/* How much a product v = x z of a pair is to change: back to a tenth to ten times what is aimed at.       [Gondzio 1996] */
static sp_real sp__centred(sp_real v, sp_real aim)
{
    return v < aim / 10 ? aim / 10 - v : v > 10 * aim ? sp__max(10 * aim - v, -10 * aim) : 0;
}

/* h <- h + W (lambda \ q), q the change of both eigenvalues of (W^-1 xt) o (W zt) back to the centre; (xt, zt) a trial point, z
 * the point at hand. xt and zt are overwritten, a and b scratch. */
static void sp__soc_centre(const sp__nt *W, const sp_real z[3], sp_real xt[3], sp_real zt[3], sp_real aim, sp_real a[3],
                           sp_real b[3], sp_real h[3])
{
    sp__soc_scale(W, xt, 1, a);
    sp__soc_scale(W, zt, 0, b);
    const sp_real v = sp__dot3(a, b), v1 = a[0] * b[1] + b[0] * a[1], v2 = a[0] * b[2] + b[0] * a[2];
    const sp_real r = SP_SQRT(v1 * v1 + v2 * v2), hi = sp__centred(v + r, aim), lo = sp__centred(v - r, aim);
    const sp_real c = r > 0 ? (hi - lo) / (2 * r) : 0;
    a[0] = (hi + lo) / 2;                                                   /* q */
    a[1] = c * v1;
    a[2] = c * v2;
    sp__soc_scale(W, z, 0, b);
    sp__soc_divide(b, a, xt);
    sp__soc_scale(W, xt, 0, zt);
    for (int k = 0; k < 3; k++) h[k] += zt[k];
}

/* Largest s <= most with x + s d in the cone, x inside: the first root of det (x + s d) = a s^2 + 2 b s + c. There is none when
 * d is in the cone too; else b^2 >= a c, whatever rounding says. Squares of what is large would leave the range of a float: a,
 * b, c by 2^-64 have the same root. */
static sp_real sp__soc_step(const sp_real x[3], const sp_real d[3], sp_real most)
{
    sp_real a = sp__soc_det(d), b = x[0] * d[0] - x[1] * d[1] - x[2] * d[2], c = sp__soc_det(x);
    if (a >= 0 && d[0] >= 0) return most;
    if (sp__abs(a) + sp__abs(b) + c > (sp_real)1e15) {
        const sp_real down = (sp_real)5.4210108624275222e-20;
        a *= down;
        b *= down;
        c *= down;
    }
    const sp_real root = SP_SQRT(sp__max(0, b * b - a * c)), t = b < 0 ? root - b : b + root;
    if (b < 0) return c < most * t ? c / t : most;
    return t < most * -a ? t / -a : most;
}

/* Largest step from x along d in the half line x >= 0, at most `most`. */
static sp_real sp__ray_step(sp_real x, sp_real d, sp_real most) { return -d * most > x ? x / -d : most; }

#endif
#endif /* SP__IPM_C */
