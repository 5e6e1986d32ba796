/* Solvers of quadratic programs by name: ours, and those that others wrote where this program was built with them. */
#ifndef STONEPACK_HOST_SOLVERS_H
#define STONEPACK_HOST_SOLVERS_H

#include "text.h"

/* The solver of this name: "admm", "dykstra", "osqp" or "ipopt".
 * returns 0; EXIT_USAGE: no such solver, or it is not in this build, and what to install */
int solvers_find(const char *name, sp_qp_solver *out, text_error *error);

#endif
