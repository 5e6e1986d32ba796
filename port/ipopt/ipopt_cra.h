/* The coupled check as its authors publish it, a nonlinear program, by Ipopt.                      [Kao et al. 2022, Eq. 11] */
#ifndef STONEPACK_IPOPT_CRA_H
#define STONEPACK_IPOPT_CRA_H

#include "../../stonepack.h"

/* The question: scene and cone of the settings, and lengths in force, as result.coupled tells them. */
typedef struct ipopt_cra_question {
    sp_real eps, eta;           /* [m], eta > 0 */
    int32_t box;                /* 1: eta bounds dt1 and dt2 each, as compas_cra; 0: |dt| */
    int32_t iterations;         /* most */
    double seconds;             /* most, of processor time */
    double tol;                 /* of Ipopt: of constraints in units of eps, mean weight and their products */
    const sp_real *f;           /* 3 x points: forces to start from; NULL: a mean weight of compression everywhere */
} ipopt_cra_question;

/* The answer. Residuals are recomputed from the triple, 1: as large as the thing itself. */
typedef struct ipopt_cra_answer {
    const char *status;         /* Ipopt's, "Solve_Succeeded" */
    int solved;                 /* it is that, or ..._To_Acceptable_Level, and every residual is within 1e-6 */
    int32_t iterations;
    double seconds;             /* of the clock */
    double objective;           /* |fn|^2 + |alpha|^2, SI */
    double balance;             /* |Aeq f + p|, of the block's own load; moments over its largest arm */
    double cone;                /* what f lies outside of it, of the mean weight */
    double contact;             /* |fn (dn + eps)|, of mean weight x eps */
    double gap;                 /* -eps - dn, of eps */
    double slip;                /* |ft + alpha dt|, of the mean weight; or alpha below 0 */
    double bound;               /* dn - eta and |dt| - eta, of eps */
} ipopt_cra_answer;

/* Solve. f (3 x scene.count.points), dq (6 x blocks) and alpha (points) are the caller's, written whatever Ipopt says.
 *   returns SP_OK, SP_E_ARGUMENT, SP_E_RANGE (eps, eta), SP_E_UNSUPPORTED (joints with strength), SP_E_MEMORY,
 *           or what sp_problem_build returns */
sp_status ipopt_cra_solve(const sp_scene *scene, const sp_settings *settings, const ipopt_cra_question *question, sp_real *f,
                          sp_real *dq, sp_real *alpha, ipopt_cra_answer *answer);

/* The largest of an answer's residuals. */
double ipopt_cra_residual(const ipopt_cra_answer *answer);

#endif
