/* Ipopt as the solver of quadratic programs. */
#ifndef STONEPACK_IPOPT_QP_H
#define STONEPACK_IPOPT_QP_H

#include "../../stonepack.h"

/* Solves with an installed Ipopt (3.11 or later). Of the settings it takes eps_abs, eps_rel and iterations. Memory: Ipopt's
 * own, by malloc; x and y are in the arena. What it answers is judged by port/host/qp_judge.c on the data as given. */
sp_qp_solver ipopt_qp_solver(void);

/* "3.11.9" */
const char *ipopt_qp_version(void);

/* A return code of Ipopt, by name, as a claim to judge; not SP_QP_SOLVED unless Solve_Succeeded. */
sp_qp_status ipopt_qp_claim(int code);

#endif
