#include "solvers.h"

#include <string.h>

#ifdef WITH_OSQP
#include "../osqp/osqp_qp.h"
#endif
#ifdef WITH_IPOPT
#include "../ipopt/ipopt_qp.h"
#endif

int solvers_find(const char *name, sp_qp_solver *out, text_error *error)
{
    if (strcmp(name, "admm") == 0) {
        *out = sp_qp_admm();
        return 0;
    }
    if (strcmp(name, "dykstra") == 0) {
        *out = sp_qp_dykstra();
        return 0;
    }
    if (strcmp(name, "osqp") == 0) {
#ifdef WITH_OSQP
        *out = osqp_qp_solver();
        return 0;
#else
        return text_fail(error, EXIT_USAGE, NULL, 0, "stonepack: --solver osqp is not in this build: "
                         "install OSQP 1.x, then make OSQP=PREFIX");
#endif
    }
    if (strcmp(name, "ipopt") == 0) {
#ifdef WITH_IPOPT
        *out = ipopt_qp_solver();
        return 0;
#else
        return text_fail(error, EXIT_USAGE, NULL, 0, "stonepack: --solver ipopt is not in this build: "
                         "apt-get install coinor-libipopt-dev pkg-config, then make");
#endif
    }
    return text_fail(error, EXIT_USAGE, NULL, 0, "stonepack: --solver needs admm, dykstra, osqp or ipopt");
}
