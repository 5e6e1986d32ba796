/* lp: one linear program after the other, for lp.py.
 *     in    n m, m rows of n coefficients, m + n pairs of bounds
 *     out   status steps, then x (status 0) or the multipliers of all constraints (status 1) */
#define SP_API static
#include "../../solvers/linear/lp.c"

#include <stdio.h>
#include <stdlib.h>

static void read_all(sp__lp *lp)
{
    int32_t e = 0;
    for (int32_t i = 0; i < lp->m; i++) {
        lp->start[i] = e;
        for (int32_t j = 0; j < lp->n; j++) {
            double a;
            if (scanf("%lf", &a) != 1) exit(1);
            lp->index[e] = j;
            lp->value[e++] = (sp_real)a;
        }
    }
    lp->start[lp->m] = e;
    for (int32_t i = 0; i < lp->m + lp->n; i++) {
        double low, high;
        if (scanf("%lf %lf", &low, &high) != 2) exit(1);
        lp->lower[i] = (sp_real)low;
        lp->upper[i] = (sp_real)high;
    }
    sp__lp_start(lp);
}

int main(void)
{
    int n, m;
    while (scanf("%d %d", &n, &m) == 2) {
        sp__lp lp;
        sp_arena dry = sp__arena_dry(), a;
        memset(&lp, 0, sizeof lp);
        sp__lp_carve(&lp, n, m, n * m, &dry);
        void *memory = malloc(dry.used + SP_ALIGN);
        if (!memory || sp_arena_init(&a, memory, dry.used + SP_ALIGN)) return 1;
        sp__lp_carve(&lp, n, m, n * m, &a);
        read_all(&lp);
        const sp__lp_status status = sp__lp_run(&lp, 100000);
        const double sign = lp.low ? -1 : 1;
        printf("%d %lld", (int)status, (long long)lp.steps);
        for (int32_t j = 0; status == SP__LP_POINT && j < n; j++) printf(" %.17g", (double)lp.x[j]);
        for (int32_t i = 0; status == SP__LP_NONE && i < m + n; i++)
            printf(" %.17g", i == lp.failed ? sign : lp.slot[i] >= 0 ? -sign * (double)lp.t[lp.slot[i]] : 0);
        printf("\n");
        free(memory);
    }
    return 0;
}
