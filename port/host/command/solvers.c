#include "solvers.h"
#include "../run.h"

#include <stdlib.h>
#include <string.h>

#ifdef WITH_OSQP
#include "../../osqp/osqp_qp.h"
#endif
#ifdef WITH_IPOPT
#include "../../ipopt/ipopt_qp.h"
#endif

/* Who solves quadratic programs: made by `make`, NULL where this build is without it, and what brings it. */
static const struct { const char *name; sp_qp_solver (*make)(void); const char *install; } solver[] = {
    { "admm", sp_qp_admm, "" },
    { "interior", sp_qp_interior, "" },
    { "dykstra", sp_qp_dykstra, "" },
#ifdef WITH_OSQP
    { "osqp", osqp_qp_solver, "" },
#else
    { "osqp", NULL, "install OSQP 1.x, then make OSQP=PREFIX" },
#endif
#ifdef WITH_IPOPT
    { "ipopt", ipopt_qp_solver, "" },
#else
    { "ipopt", NULL, "apt-get install coinor-libipopt-dev pkg-config, then make" },
#endif
};

const char *solvers_first(void)
{
    for (size_t k = 0; k < sizeof solver / sizeof *solver; k++)
        if (solver[k].make && strcmp(solver[k].name, "osqp") == 0) return solver[k].name;
    return solver[0].name;
}

int solvers_find(const char *name, sp_qp_solver *out, failure *error)
{
    for (size_t k = 0; k < sizeof solver / sizeof *solver; k++) {
        if (strcmp(name, solver[k].name)) continue;
        if (!solver[k].make)
            return fail_with(error, EXIT_UNAVAILABLE, NULL, 0, "stonepack: --solver %s is not in this build: %s", name,
                             solver[k].install);
        *out = solver[k].make();
        return 0;
    }
    return fail_with(error, EXIT_USAGE, NULL, 0, "stonepack: --solver needs auto, admm, interior, dykstra, osqp or ipopt");
}

#ifdef WITH_IPOPT

/* What sp_verify says of this triple. */
static sp_status verify_triple(const sp_scene *scene, const sp_settings *settings, const sp_result *result, sp_real *f,
                               sp_real *dq, sp_real *alpha, sp_evidence *evidence)
{
    sp_result claim = *result;
    claim.f = f;
    claim.coupled.dq = dq;
    claim.coupled.alpha = alpha;
    return run_verify(scene, settings, &claim, evidence);
}

sp_status solvers_publish(const sp_scene *scene, const sp_settings *settings, const sp_result *result, solvers_published *out)
{
    const ipopt_cra_question q = { result->coupled.eps, result->coupled.eta, settings->coupled.box, 3000, 60, 1e-8, NULL };
    const size_t v = (size_t)scene->count.points, b = (size_t)scene->count.blocks;
    sp_real *f = calloc(4 * v + 6 * b + 1, sizeof *f);
    sp_status status = f ? ipopt_cra_solve(scene, settings, &q, f, f + 4 * v, f + 3 * v, &out->answer) : SP_E_MEMORY;
    out->residual = status == SP_OK ? ipopt_cra_residual(&out->answer) : 0;
    if (status == SP_OK) status = verify_triple(scene, settings, result, f, f + 4 * v, f + 3 * v, &out->evidence);
    free(f);
    return status;
}

#else

sp_status solvers_publish(const sp_scene *scene, const sp_settings *settings, const sp_result *result, solvers_published *out)
{
    (void)scene; (void)settings; (void)result; (void)out;
    return SP_E_UNSUPPORTED;
}

#endif
