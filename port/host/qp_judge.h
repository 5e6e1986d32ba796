/* What an answer to a quadratic program is worth, recomputed from the program. A solver from outside claims, this judges. */
#ifndef STONEPACK_HOST_QP_JUDGE_H
#define STONEPACK_HOST_QP_JUDGE_H

#include "../../stonepack.h"

/* Is this a program sp_qp_solve would take?                    returns what sp_qp_solve returns; a guess may be NULL */
sp_status qp_judge_arguments(const sp_qp *qp, const sp_qp_settings *settings, const sp_real *x0, const sp_real *y0);

/* Judge what is claimed of x (n) and y (m), both the result's from now on.
 *
 *   claim     SP_QP_SOLVED: the status is that of the residuals and the gap on the data as given: solved (within eps),
 *             inaccurate (within 10 eps) or numerical
 *             SP_QP_PRIMAL_INFEASIBLE, SP_QP_DUAL_INFEASIBLE: y, or x, is the certificate. It is moved to the nearest that
 *             holds to the last digit; numerical if it does not rule out solutions `settings->radius` times as large as the
 *             data asks for
 *             SP_QP_ITERATIONS, SP_QP_BUDGET: inaccurate if all is within 10 eps
 *             others stay: what calls itself inaccurate is never solved
 *   result    all but rho, iterations, factorisations, flops and polished is written
 *   returns   SP_OK, SP_E_MEMORY */
sp_status qp_judge(const sp_qp *qp, const sp_qp_settings *settings, sp_qp_status claim, sp_real *x, sp_real *y,
                   sp_qp_result *result);

/* A run of a solver from outside: what it claims of x (n) and y (m), and its rho, iterations, factorisations, polished. */
typedef sp_status qp_judge_attempt(const sp_qp *qp, const sp_qp_settings *settings, const sp_real *x0, const sp_real *y0,
                                   sp_real *x, sp_real *y, sp_qp_status *claim, sp_qp_result *result);

/* `solve` and `need` of a sp_qp_solver that attempts it so and is judged. */
sp_status qp_judge_solve(qp_judge_attempt *attempt, const sp_qp *qp, const sp_qp_settings *settings, sp_arena *arena,
                         const sp_real *x0, const sp_real *y0, sp_qp_result *result);
sp_status qp_judge_need(void *self, const sp_qp *qp, const sp_qp_settings *settings, sp_arena scratch, size_t *bytes);

#endif
