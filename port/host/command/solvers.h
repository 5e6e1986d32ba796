/* Solvers of quadratic programs by name: ours, and those that others wrote where this program was built with them. */
#ifndef STONEPACK_HOST_SOLVERS_H
#define STONEPACK_HOST_SOLVERS_H

#include "../files/failure.h"
#include "../../ipopt/ipopt_cra.h"

/* The solver of this name: "admm", "interior", "dykstra", "osqp" or "ipopt".
 * returns 0; EXIT_USAGE: no such solver, or it is not in this build, and what to install */
int solvers_find(const char *name, sp_qp_solver *out, failure *error);

/* The name of the first that is built in: OSQP, else our ADMM.                                                   [seed 4.1] */
const char *solvers_first(void);

/* The coupled question of a check as its authors' program, by Ipopt. */
typedef struct solvers_published {
    ipopt_cra_answer answer;
    double residual;            /* the largest of its residuals */
    sp_evidence evidence;       /* what sp_verify says of its triple */
} solvers_published;

/* returns SP_OK, SP_E_UNSUPPORTED: not built in, or what ipopt_cra_solve and sp_verify return */
sp_status solvers_publish(const sp_scene *scene, const sp_settings *settings, const sp_result *result, solvers_published *out);

#endif
