/* vec3: vectors of three, with care for what rounding, overflow and underflow do to them. */
#ifndef SP__VEC3_C
#define SP__VEC3_C

#include "real.c"

#if SP__WITH_STONES

static inline sp_real sp__dot3(const sp_real a[3], const sp_real b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* |a|, also where its square would over- or underflow; infinite where the sum of its components is. */
static inline sp_real sp__norm3(const sp_real a[3])
{
#ifdef SP_REAL_FLOAT
    const sp_real low = (sp_real)1e-24, high = (sp_real)1e24;
#else
    const sp_real low = (sp_real)1e-280, high = (sp_real)1e280;
#endif
    const sp_real square = sp__dot3(a, a);
    if (square > low && square < high) return SP_SQRT(square);
    const sp_real m = sp__abs(a[0]) + sp__abs(a[1]) + sp__abs(a[2]);
    if (!(m > 0) || !sp__finite(m)) return m;
    const sp_real s[3] = { a[0] / m, a[1] / m, a[2] / m };
    return m * SP_SQRT(sp__dot3(s, s));
}

static int sp__finite3(const sp_real a[3]) { return sp__all_finite(a, 3); }

/* c = a - b, c = s a, c = a x b; c may be a, in the first two also b. */
static inline void sp__sub3(const sp_real a[3], const sp_real b[3], sp_real c[3])
{
    c[0] = a[0] - b[0]; c[1] = a[1] - b[1]; c[2] = a[2] - b[2];
}

static inline void sp__scale3(sp_real s, const sp_real a[3], sp_real c[3])
{
    c[0] = s * a[0]; c[1] = s * a[1]; c[2] = s * a[2];
}

/* a += s b */
static inline void sp__add3(sp_real a[3], sp_real s, const sp_real b[3])
{
    a[0] += s * b[0]; a[1] += s * b[1]; a[2] += s * b[2];
}

static inline void sp__cross3(const sp_real a[3], const sp_real b[3], sp_real c[3])
{
    const sp_real x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    c[0] = x; c[1] = y; c[2] = z;
}

/* a b and what rounding took from it; exact for |a|, |b| far from over- and underflow.                  [Dekker 1971] */
static sp_real sp__product(sp_real a, sp_real b, sp_real *rest)
{
#ifdef SP_REAL_FLOAT
    const sp_real half = (sp_real)4097;                 /* 2^12 + 1: cuts 24 bits into 12 + 12 */
#else
    const sp_real half = (sp_real)134217729;            /* 2^27 + 1: cuts 53 bits into 26 + 26 and a sign */
#endif
    const sp_real ca = half * a, ah = ca - (ca - a), al = a - ah;
    const sp_real cb = half * b, bh = cb - (cb - b), bl = b - bh;
    const sp_real p = a * b;
    *rest = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
    return p;
}

/* a d - b c, right to an ulp or two: the cross product of two long vectors that are nearly parallel (slivers) keeps its
 * direction, so errors in volume and area go with the body's surface and not with the square of its length. */
static sp_real sp__minor(sp_real a, sp_real b, sp_real c, sp_real d)
{
    sp_real e, f;
    const sp_real p = sp__product(a, d, &e), q = sp__product(b, c, &f);
    return (p - q) + (e - f);
}

/* c += a x b, each component by sp__minor. */
static void sp__cross3_add(const sp_real a[3], const sp_real b[3], sp_real c[3])
{
    for (int k = 0, i = 1, j = 2; k < 3; k++) {
        c[k] += sp__minor(a[i], a[j], b[i], b[j]);
        i = j;
        j = k;
    }
}

/* b = a / |a|, b may be a; divided, not multiplied by 1 / |a|: what lies along an axis becomes exactly 0 and +-1. */
static void sp__unit3(const sp_real a[3], sp_real b[3])
{
    const sp_real length = sp__norm3(a);
    for (int k = 0; k < 3; k++) b[k] = a[k] / length;
}

/* Unit vector across n (unit): the world axis least aligned with n, the first of equals, made orthogonal to it. */
static void sp__across3(const sp_real n[3], sp_real t[3])
{
    int k = 0;
    if (sp__abs(n[1]) < sp__abs(n[k])) k = 1;
    if (sp__abs(n[2]) < sp__abs(n[k])) k = 2;
    sp__scale3(-n[k], n, t);
    t[k] += (sp_real)1;
    sp__unit3(t, t);
}

#endif
#endif /* SP__VEC3_C */
