/* OSQP 1.x as the solver of quadratic programs.                                                               [seed 4.4] */
#ifndef STONEPACK_OSQP_QP_H
#define STONEPACK_OSQP_QP_H

#include "../../stonepack.h"

/* Solves with an installed OSQP. Of the settings it takes eps_abs, eps_rel, eps_pinf, eps_dinf, polish, iterations, check,
 * passes, sigma, relax and rho; it has no budget and adapts rho its own way. Memory: OSQP's own, by malloc; x and y are in the
 * arena. What it answers is judged by port/host/qp_judge.c on the data as given. */
sp_qp_solver osqp_qp_solver(void);

/* "1.0.0" */
const char *osqp_qp_version(void);

/* A status of OSQP, by name, as a claim to judge; not SP_QP_SOLVED unless OSQP_SOLVED. */
sp_qp_status osqp_qp_claim(int status);

#endif
