/* cg: conjugate gradients on a positive definite operator, preconditioned by its diagonal.             [Hestenes, Stiefel 1952]
 *
 * The operator is never formed; memory 3 n numbers and the diagonal.
 */
#ifndef SP__CG_C
#define SP__CG_C

#include "../base/arena.c"

#if SP__WITH_QP_CG

typedef void (*sp__apply)(const void *what, const sp_real *v, sp_real *mv);     /* mv <- M v */

typedef struct sp__cg {
    int32_t n;
    sp_real *r, *d, *md;                /* residual, direction, M d */
    sp_real *inverse;                   /* 1 / diag M, > 0 */
} sp__cg;

static void sp__cg_carve(sp__cg *cg, int32_t n, sp_arena *a)
{
    cg->n = n;
    cg->r = sp__take(a, (size_t)n, sizeof *cg->r);
    cg->d = sp__take(a, (size_t)n, sizeof *cg->d);
    cg->md = sp__take(a, (size_t)n, sizeof *cg->md);
    cg->inverse = sp__take(a, (size_t)n, sizeof *cg->inverse);
}

static sp_real sp__inner(const sp_real *a, const sp_real *b, int32_t n)
{
    sp_real s = 0;
    for (int32_t i = 0; i < n; i++) s += a[i] * b[i];
    return s;
}

/* r'Cr with the preconditioner C. */
static sp_real sp__cg_norm(const sp__cg *cg)
{
    sp_real s = 0;
    for (int32_t i = 0; i < cg->n; i++) s += cg->r[i] * cg->r[i] * cg->inverse[i];
    return s;
}

/* x <- M^-1 b from the guess in x, until |r| <= tol |b| or `most` steps.
 * Returns the steps, or -1 - steps when d'Md <= 0 was met: M is not positive definite. */
SP__NOINLINE static int32_t sp__cg_solve(const sp__cg *cg, sp__apply apply, const void *what, const sp_real *b, sp_real *x,
                                      int32_t most, sp_real tol)
{
    const int32_t n = cg->n;
    const sp_real enough = tol * tol * sp__inner(b, b, n);
    apply(what, x, cg->md);
    for (int32_t i = 0; i < n; i++) { cg->r[i] = b[i] - cg->md[i]; cg->d[i] = cg->inverse[i] * cg->r[i]; }
    sp_real rho = sp__cg_norm(cg);
    for (int32_t step = 0; step < most; step++) {
        if (!(sp__inner(cg->r, cg->r, n) > enough) || !(rho > 0)) return step;
        apply(what, cg->d, cg->md);
        const sp_real curvature = sp__inner(cg->d, cg->md, n);
        if (!(curvature > 0)) return -1 - step;
        const sp_real a = rho / curvature;
        for (int32_t i = 0; i < n; i++) { x[i] += a * cg->d[i]; cg->r[i] -= a * cg->md[i]; }
        const sp_real next = sp__cg_norm(cg), beta = next / rho;
        for (int32_t i = 0; i < n; i++) cg->d[i] = cg->inverse[i] * cg->r[i] + beta * cg->d[i];
        rho = next;
    }
    return most;
}

#endif
#endif /* SP__CG_C */
